//! No face is cut.

use core::marker::PhantomData;

use crate::scene::{Look, stored_attributes::ButCoordinates};

/// The [`Look`] `L` without cut faces, for objects that stay in front of the camera and within the guard band: where a vertex
/// does not, preparing the frame is an error that names its model ([`Look::CLIPS`]). Saves about 3 KB of flash, and of
/// each vertex 4 bytes for its texture coordinates, which faces read from the skin of their model instead.
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
    type StoredAttributes = ButCoordinates;
    const CLIPS: bool = false;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
