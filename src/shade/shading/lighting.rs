//! Light on a surface, computed at the vertices or once a face.

use core::fmt::Debug;

use crate::{
    shade::InstructionSet,
    view::{Camera, Pose},
};

/// Lights, and how a surface reflects them: [`Lambert`](crate::shade::Lambert), [`Blinn`](crate::shade::Blinn), or one of the
/// program's own.
pub trait Lighting: Copy + Debug + 'static {
    /// The lights as a model sees them, in its own axes.
    type OfModel: Copy;
    /// Whether there is any light for which a surface's normal counts.
    const NEEDS_NORMALS: bool = true;
    /// Whether there is any light for which the position of a surface counts.
    const NEEDS_POSITIONS: bool = true;

    /// The lights in the axes of a model that is in a pose before a camera. Called once a model and frame.
    fn seen_from(&self, pose: &Pose, camera: &Camera) -> Self::OfModel;

    /// The light that the surface at a position of a model reflects, from its normal of length 1 with 14 fractional bits.
    /// Called once a vertex and frame, or once a face and frame.
    fn reflected(lights: &Self::OfModel, normal: [i32; 3], position: [i32; 3]) -> ReflectedLight;

    /// How many instructions of a set [`reflected`](Self::reflected) takes, for
    /// [`Prepared::estimate`](crate::scene::Prepared::estimate). If this says nothing else, it is as plain as light from a
    /// direction.
    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        set.of([30, 25])
    }
}

/// Light that a surface reflects, in units of 1/32,768: from 0 to 32,768.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReflectedLight {
    /// What it reflects in its own colour.
    pub diffuse: i32,
    /// What it reflects in the colour of the light, which is white: a highlight.
    pub specular: i32,
}

/// Fractional bits of a light.
pub(super) const LIGHT_BITS: u32 = 15;
/// Full light.
pub(super) const FULL: i32 = 1 << LIGHT_BITS;
