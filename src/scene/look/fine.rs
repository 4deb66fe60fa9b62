//! Positions at 1/256 pixel.

use core::marker::PhantomData;

use crate::{geometry::Sub8, scene::Look};

/// The [`Look`] `L` with positions at 1/256 pixel instead of 1/16 ([`Sub8`]), so that slow turns do not tremble and the
/// viewport may be larger. A vertex takes 12 bytes.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::scene::{Camera, FaceSet, Fine, Memory, Model};
///
/// // One unit is 1/32 pixel there: the model moves right by that in each frame.
/// let mesh = FaceSet::new(&[[-512, -512, 1024], [0, 512, 1024], [512, -512, 1024]], &[[0, 1, 2]])?;
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let (mut memory, mut fine) = (Memory::<Rgb565, 3, 1, 64, 64>::new(), Memory::<Fine<Rgb565>, 3, 1, 64, 64>::new());
/// let (mut columns, mut fine_columns) = (Vec::new(), Vec::new());
/// for frame in 0..4 {
///     let mut models = [Model::new(mesh, &[Rgb565::RED])?];
///     models[0].pose.translation = [frame, 0, 0].map(I16F16::from_num::<i32>);
///     columns.extend(memory.prepare(&camera, &models)?.points().next().map(|point| point.corner.point.x));
///     fine_columns.extend(fine.prepare(&camera, &models)?.points().next().map(|point| point.corner.point.x));
/// }
/// // In steps of 1/16 pixel the corner stands still in the third frame, in those of 1/256 in none.
/// assert_eq!(columns, [15.5, 15.5625, 15.5625, 15.625]);
/// assert_eq!(fine_columns, [15.5, 15.53125, 15.5625, 15.59375]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
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
    type Visibility = L::Visibility;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
