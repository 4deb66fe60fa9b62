//! Flat shading: one colour a face. Interpolates nothing and costs nothing a pixel.

use crate::shade::Shade;

/// One colour for every fragment.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flat<W>(pub W);

impl<W: Copy> Shade<W> for Flat<W> {
    #[inline(always)]
    fn word(&self) -> W {
        self.0
    }

    #[inline(always)]
    fn step_right(&mut self) {}
}
