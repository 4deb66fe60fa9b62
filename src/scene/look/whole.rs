//! No face is cut.

use core::marker::PhantomData;

use crate::scene::Look;

/// The [`Look`] `L` without cut faces, for objects that stay in front of the camera and within the guard band: where a vertex
/// does not, preparing the frame is an error that names its model ([`Look::CLIPS`]). Saves about 3 KB of flash.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Whole<L>(PhantomData<L>);

impl<L: Look> Look for Whole<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    const CLIPS: bool = false;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
