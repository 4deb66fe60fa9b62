//! Positions at 1/256 pixel.

use core::marker::PhantomData;

use crate::{geometry::Sub8, scene::Look};

/// The [`Look`] `L` with positions at 1/256 pixel instead of 1/16 ([`Sub8`]), so that slow turns do not tremble and the
/// viewport may be larger. A vertex takes 12 bytes.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fine<L>(PhantomData<L>);

impl<L: Look> Look for Fine<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = Sub8;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
