//! No row is drawn in passes.

use core::marker::PhantomData;

use crate::scene::Look;

/// The [`Look`] `L` without passes: where more faces cross a row than there are slots, preparing the frame is an error that
/// says how many would do ([`Look::DRAWS_IN_PASSES`]). Saves about 2 KB of flash.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     geometry::{InputError, TooSmall},
///     scene::{Camera, FaceSet, Memory, Model, OnePass},
/// };
///
/// // Two faces that cross the same rows, and one slot for such faces.
/// let mesh = FaceSet::new(&[[-512, -512, 1024], [0, 512, 1024], [512, -512, 1024]], &[[0, 1, 2], [0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Rgb565::RED; 2])?];
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mut memory = Memory::<OnePass<Rgb565>, 3, 2, 64, 64, 1>::new();
/// let error = memory.prepare(&camera, &models).err();
/// assert_eq!(error, Some(InputError::TooSmall(TooSmall::ActiveFaces(2))));
/// let mut memory = Memory::<OnePass<Rgb565>, 3, 2, 64, 64, 2>::new();
/// assert_eq!(memory.prepare(&camera, &models)?.active_needed(), 2);
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnePass<L>(PhantomData<L>);

impl<L: Look> Look for OnePass<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    type Visibility = L::Visibility;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = false;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
