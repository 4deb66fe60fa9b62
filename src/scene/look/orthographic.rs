//! Parallel rays.

use core::marker::PhantomData;

use fixed::types::I16F16;

use crate::{
    scene::Look,
    view::{Camera, Projection},
};

/// The [`Look`] `L` with parallel rays instead of perspective: things are as large wherever they are, by the camera's
/// [scale](Camera::with_scale), as in plans and in isometric views. A vertex takes no division, and what a shading divides by
/// the depth varies evenly on the screen. Preparing a frame of whole faces ([`Whole`](crate::scene::Whole)) links no division
/// at all, which `cargo run --release -- panics` shows for chips without a divider; drawing links those that set the edges and
/// the planes of faces up, and faces that may be cut those of the cuts.
///
/// Depth falls evenly from the near to the far plane of the camera ([`Camera::with_far`]), which reaches 32,768 units until it
/// is set. One unit of it is 1/65,536 of the way between them with `u16`, taken up to the next power of two, 256 times finer
/// with `u32`. What is behind the far plane is cut away.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I8F24, I16F16};
/// use zrow::{
///     geometry::InputError,
///     scene::{Camera, FaceSet, Memory, Model, Orthographic},
/// };
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?
///     .with_far(I16F16::from_num(4_224))?
///     .with_scale(I8F24::from_num(0.0625))?;
/// let mesh = FaceSet::new(&[[-160, -160, 500], [0, 160, 4_000], [160, -160, 500]], &[[0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Rgb565::RED])?];
/// let mut memory = Memory::<Orthographic<Rgb565>, 3, 1, 64, 64>::new();
/// let scene = memory.prepare(&camera, &models)?;
/// // Ten pixels to each side of the middle, near and far, in 1/16 pixel.
/// let corners = scene.faces().next().map(|face| face.corners.map(|corner| corner.point.y_units()));
/// assert_eq!(corners, Some([504 + 160, 504 - 160, 504 + 160]));
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Orthographic<L>(PhantomData<L>);

impl<L: Look> Look for Orthographic<L> {
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
    const IS_ORTHOGRAPHIC: bool = true;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}

impl<L: Look> Orthographic<L> {
    /// The stored depth of a plane at that distance from a camera, to draw at with the scene's depth: what
    /// [`Camera::depth_at`] is in perspective.
    pub fn depth_at(camera: &Camera, distance: I16F16) -> L::Depth {
        Projection::<L::Precision, L::Depth>::parallel(camera).parallel_depth_at(distance)
    }
}
