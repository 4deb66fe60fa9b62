//! Faces with two sides.

use core::marker::PhantomData;

use crate::scene::Look;

/// The [`Look`] `L` in which faces are seen from both sides: leaves, cloth, paper, meshes with holes. The picture is that of a
/// mesh whose faces are all there once more the other way round, each right after itself, for the time and the memory of one.
///
/// A back has the colours, textures and light of its front. For light on the side that is seen there is
/// [`TwoSided`](crate::shade::TwoSided), around the lights of any shading.
///
/// Cost: two multiplications more for a face that faces away, to find out; four more when rows reach a face.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I16F16, U0F16};
/// use zrow::{
///     band::Band,
///     scene::{Camera, DoubleSided, FaceSet, Memory, Model, Pose, Rotation},
/// };
///
/// let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 0], [512, -512, 0]], &[[0, 1, 2]])?;
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mut memory = Memory::<DoubleSided<Rgb565>, 3, 1, 64, 64>::new();
/// for turns in [0.0, 0.5] {
///     let pose = Pose::new(
///         Rotation::about_y(U0F16::from_num(turns)),
///         [0, 0, 1024].map(I16F16::from_num),
///     );
///     let models = [Model::new(mesh, &[Rgb565::RED])?.with_pose(pose)];
///     let mut words = [0; 64 * 64];
///     let mut band = Band::<Rgb565>::new(area, &mut words)?;
///     memory.prepare(&camera, &models)?.draw(&mut band);
///     assert_eq!(band.words()[32 * 64 + 32], Rgb565::RED.into_storage());
/// }
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DoubleSided<L>(PhantomData<L>);

impl<L: Look> Look for DoubleSided<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    type Visibility = L::Visibility;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = true;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
