//! Flat shading: one colour a face. Interpolates nothing and costs nothing a pixel.

use crate::shade::Shade;

/// One colour for every fragment.
pub(crate) struct Flat<W>(pub W);

impl<W: Copy> Shade<W> for Flat<W> {
    #[inline]
    fn word(&self) -> W {
        self.0
    }

    #[inline]
    fn step_right(&mut self) {}
}
