//! Flat shading: one colour a face. Interpolates nothing and costs nothing a pixel.

use crate::{
    geometry::TooSmall,
    mesh::FaceSet,
    shade::{InstructionSet, Shade, Shading},
    surface::BandColor,
    view::{Camera, Pose},
};

impl<C: BandColor> Shading for C {
    type Color = C;
    type Skin<'a> = &'a [C];
    type Uniforms = ();
    type Attributes = ();
    const HAS_HOLES: bool = false;

    fn check(colors: &&[C], mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        let needed = mesh.faces().len();
        if colors.len() < needed {
            Err(TooSmall::Colors(needed))
        } else {
            Ok(())
        }
    }

    #[inline]
    fn uniforms(_: &&[C], _: &Pose, _: &Camera) {}

    #[inline]
    fn vertex(_: &&[C], (): &(), _: usize, _: [i32; 3]) {}

    #[inline]
    fn face(colors: &&[C], (): &(), _: &FaceSet<'_>, face: usize) -> Option<C::Word> {
        colors.get(face).map(|color| color.to_word())
    }

    #[inline]
    fn instructions(_: InstructionSet) -> [u32; 2] {
        [0; 2]
    }

    #[inline]
    fn fragment(_: &&[C], face: C::Word, (): &()) -> Option<C::Word> {
        Some(face)
    }
}

/// A shade that is the same at each pixel of a span.
pub(crate) struct Flat<W>(pub W);

impl<W: Copy> Shade<W> for Flat<W> {
    #[inline]
    fn word(&self) -> Option<W> {
        Some(self.0)
    }

    #[inline]
    fn step_right(&mut self) {}
}
