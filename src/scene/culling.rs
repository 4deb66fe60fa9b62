//! Models of which nothing is seen, left out before their vertices are transformed (Clark 1976), and the mark that they leave
//! in the tables. Linked only for shadings whose models have [bounds](crate::shade::Shading::HAS_BOUNDS).

use crate::{
    mesh::BoundingVolume,
    scene::{
        Look, Model,
        lens::{ProjectionOf, ScreenVertexOf, has_far_plane, projection},
    },
    shade::Shading,
    view::{Camera, DepthWidth, EyeTransform, Pose, ScreenPrecision, ScreenVertex, ToEye, ViewVolume},
};

/// The planes of what a camera sees in a look. The far plane is one of them where faces end at it.
#[inline]
pub(super) fn view_volume<L: Look>(projection: &ProjectionOf<L>, camera: &Camera) -> ViewVolume {
    let ends_at_far_plane = (L::CLIPS || L::IS_ORTHOGRAPHIC) && has_far_plane::<L>(projection);
    projection.view_volume(&camera.viewport(), L::IS_ORTHOGRAPHIC, ends_at_far_plane)
}

/// Whether all of a volume is beyond one plane, so that nothing within it is seen; a volume of which not all points fit the
/// numbers of eye space is taken for one that is seen.
#[inline(never)]
pub(super) fn is_beyond(
    volume: &ViewVolume,
    transform: &impl ToEye,
    bounds: &BoundingVolume,
    fit: impl FnOnce(&[[i16; 3]]) -> bool,
) -> bool {
    let Some(points) = bounds.points() else { return true };
    let [center, x, y, z] = points;
    let halves = || [transform.apply(x), transform.apply(y), transform.apply(z)];
    fit(&points) && volume.is_beyond(transform.apply(center), halves, bounds.straight())
}

/// What the vertical coordinate of the first vertex of a model says, beside the mark of a vertex that is off the screen, where
/// the model was left out: no vertex is beyond all planes.
const LEFT_OUT: i32 = -1;

/// Marks a model as left out, in the place of its first vertex. Without vertices it has no faces either.
pub(super) fn leave_out<L: Look>(slots: &mut [ScreenVertexOf<L>]) {
    if let [first, ..] = slots {
        *first = ScreenVertex {
            x: L::Precision::OUTSIDE,
            y: L::Precision::narrow(LEFT_OUT),
            z: L::Depth::FARTHEST,
        };
    }
}

/// Whether the model was left out whose first vertex has an index.
#[inline]
pub(super) fn is_left_out<L: Look>(vertices: &[ScreenVertexOf<L>], first_vertex: usize) -> bool {
    L::Shading::HAS_BOUNDS
        && vertices
            .get(first_vertex)
            .is_some_and(|first| first.x == L::Precision::OUTSIDE && first.y_units() == LEFT_OUT)
}

/// How many faces have the models that were left out.
pub(super) fn faces_left_out<L: Look>(vertices: &[ScreenVertexOf<L>], models: &[Model<'_, L::Shading>]) -> u32 {
    let (mut first_vertex, mut faces) = (0usize, 0);
    for model in models {
        if is_left_out::<L>(vertices, first_vertex) {
            faces += model.mesh().faces().len() as u32;
        }
        first_vertex += model.mesh().vertices().len();
    }
    faces
}

impl Camera {
    /// Whether anything within a box, a sphere or a cylinder may be seen in a look `L`, where it is in a pose: `false` where
    /// all of it is beyond the near plane, the far plane or one side of the picture. To leave a group of models out together
    /// that have a box around them, or not to compute what they need; a single model is left out by itself where its shading is
    /// [`Bounded`](crate::shade::Bounded).
    ///
    /// A model that is left out of a scene changes nothing in the picture of the others. Hierarchies may have any depth: a
    /// group that is not seen has no member that is.
    ///
    /// Cost: the transformation of one vertex and its comparison with six planes; where it is beyond one of them, three more.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     geometry::InputError,
    ///     scene::{BoundingBox, Camera, FaceSet, Memory, Model, Pose, Rotation},
    /// };
    ///
    /// const CHAIR: FaceSet = match FaceSet::new(&[[-10, -10, 0], [0, 10, 0], [10, -10, 0]], &[[0, 1, 2]]) {
    ///     Ok(faces) => faces,
    ///     Err(_) => panic!("a face names a vertex that is not there"),
    /// };
    /// /// Around a row of four chairs, 30 units apart.
    /// const ROW: BoundingBox = BoundingBox::around(&[[-10, -10, 0], [100, 10, 0]]);
    ///
    /// let at = |x, z| Pose::new(Rotation::IDENTITY, [x, 0, z].map(I16F16::from_num::<i32>));
    /// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(8))?;
    /// let chair = Model::new(CHAIR, &[Rgb565::RED])?;
    /// let (mut chairs, mut count) = ([chair; 8], 0);
    /// // One row before the camera, one behind it.
    /// for row in [at(-40, 80), at(-40, -80)] {
    ///     if camera.may_see::<Rgb565>(ROW, &row) {
    ///         for number in 0..4 {
    ///             chairs[count] = chair.with_pose(at(30 * number, 0).then(&row)?);
    ///             count += 1;
    ///         }
    ///     }
    /// }
    /// assert_eq!(count, 4);
    /// let mut memory = Memory::<Rgb565, 24, 8, 64, 64>::new();
    /// assert_eq!(memory.prepare(&camera, &chairs[..count])?.faces().count(), 4);
    /// # Ok::<(), InputError>(())
    /// ```
    pub fn may_see<L: Look>(&self, bounds: impl Into<BoundingVolume>, pose: &Pose) -> bool {
        let volume = view_volume::<L>(&projection::<L>(self), self);
        let transform = EyeTransform::<L::Precision>::new(pose, self.pose());
        !is_beyond(&volume, &transform, &bounds.into(), |_| true)
    }
}
