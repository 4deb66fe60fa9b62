//! Several samples a pixel.

use core::marker::PhantomData;

use crate::scene::Look;

/// The [`Look`] `L` for pictures with several samples a pixel, which
/// [`Prepared::draw_samples`](crate::scene::Prepared::draw_samples) draws on what
/// [`Band::multisample`](crate::band::Band::multisample) hands over, each sample with a depth of its own. All edges are
/// smoothed: silhouettes, edges between faces, and where faces go through each other.
///
/// Faces are kept that cover a sample and not the centre of a pixel. [`Prepared::draw`](crate::scene::Prepared::draw) draws the
/// picture of `L`, with one sample a pixel, at its centre.
///
/// A face crosses more rows, so that there have to be more slots for those in a row
/// ([`Prepared::active_needed`](crate::scene::Prepared::active_needed)). No row is drawn in passes
/// ([`Look::DRAWS_IN_PASSES`]), and none without depths. Around [`Antialiased`](crate::scene::Antialiased) it draws no
/// silhouettes; within it there are no samples. [`Prepared::estimate`](crate::scene::Prepared::estimate) predicts what `L`
/// takes. Memory: that of `L`.
///
/// [`Prepared::draw_samples`](crate::scene::Prepared::draw_samples) has an example.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Multisampled<L>(PhantomData<L>);

impl<L: Look> Look for Multisampled<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = ();
    type Visibility = ();
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = false;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = true;
}
