//! No face is cut.

use core::marker::PhantomData;

use crate::scene::{Look, stored_attributes::ButCoordinates};

/// The [`Look`] `L` without cut faces, for objects that stay in front of the camera and within the guard band: where a vertex
/// does not, preparing the frame is an error that names its model ([`Look::CLIPS`]). Saves about 3 KB of flash, and of
/// each vertex 4 bytes for its texture coordinates, which faces read from the skin of their model instead.
///
/// The memory has room for the vertices of the models and no more, because nothing is cut. The example of [`Look`] has
/// a model that comes too near.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I16F16, U0F16};
/// use zrow::scene::{Camera, FaceSet, Memory, Model, Pose, Rotation, Whole};
///
/// static LOGO: FaceSet = match FaceSet::new(&[[-512, -512, 0], [0, 512, 0], [512, -512, 0]], &[[0, 1, 2]]) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// const VERTICES: usize = LOGO.vertices().len();
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mut memory = Memory::<Whole<Rgb565>, VERTICES, 1, 64, 64>::new();
/// for angle in (0..=u16::MAX).step_by(1024) {
///     let pose = Pose::new(Rotation::about_y(U0F16::from_bits(angle)), [0, 0, 1024].map(I16F16::from_num::<i32>));
///     let models = [Model::new(LOGO, &[Rgb565::RED])?.with_pose(pose)];
///     assert_eq!(memory.prepare(&camera, &models)?.vertices_needed(), VERTICES);
/// }
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
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
    type Visibility = L::Visibility;
    type StoredAttributes = ButCoordinates;
    const CLIPS: bool = false;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
