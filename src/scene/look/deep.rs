//! Depths of 32 bits.

use core::marker::PhantomData;

use crate::{scene::Look, visible::LookVisibility};

/// The [`Look`] `L` with depths of 32 bits instead of 16: 256 times finer, for scenes that reach far. A vertex takes 8 bytes
/// (12 where it is [`Fine`](crate::scene::Fine)), a column of the depth row 4.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::scene::{Camera, Deep, FaceSet, Memory, Model};
///
/// // A poster, two units in front of a house 8,000 units away, where one unit of 16-bit depths is 7.6 units of space.
/// let house = FaceSet::new(&[[-900, -900, 8000], [0, 900, 8000], [900, -900, 8000]], &[[0, 1, 2]])?;
/// let poster = FaceSet::new(&[[-900, -900, 7998], [0, 900, 7998], [900, -900, 7998]], &[[0, 1, 2]])?;
/// let models = [Model::new(house, &[Rgb565::WHITE])?, Model::new(poster, &[Rgb565::RED])?];
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let (mut memory, mut deep) = (Memory::<Rgb565, 6, 2, 64, 64>::new(), Memory::<Deep<Rgb565>, 6, 2, 64, 64>::new());
/// let middle = Point::new(32, 32);
/// // Of equally near ones the first is seen: the house.
/// assert_eq!(memory.prepare(&camera, &models)?.face_at(middle), Some(0));
/// assert_eq!(deep.prepare(&camera, &models)?.face_at(middle), Some(1));
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Deep<L>(PhantomData<L>);

impl<L: Look<Visibility: LookVisibility<u32>>> Look for Deep<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = u32;
    type Counting = L::Counting;
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
