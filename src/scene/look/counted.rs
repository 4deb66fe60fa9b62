//! Frames that count what they take.

use core::{cell::Cell, marker::PhantomData};

use crate::scene::{Counters, Look};

/// The [`Look`] `L` with counters: [`Prepared::counters`](crate::scene::Prepared::counters) says what a frame took. The picture
/// is the same.
///
/// RAM: 52 bytes in the prepared frame. Cost: some instructions a span, and three a fragment.
///
/// [`Counters`] has an example.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counted<L>(PhantomData<L>);

impl<L: Look> Look for Counted<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = Cell<Counters>;
    type Silhouettes = L::Silhouettes;
    type Visibility = L::Visibility;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
