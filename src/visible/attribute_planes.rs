//! Sets up the planes of the attributes of a face: one reciprocal a small face, whatever the number of planes.

use crate::{
    geometry::{ScreenPlane, Window},
    shade::{PlaneSource, Planes, Shading},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{
        active_face::{ActiveFace, Surroundings, from_top, in_order_of_rows},
        depth_plane::{AreaReciprocal, SmallFace, wide_attribute_plane},
        face_table::FaceTable,
        sides::Sides,
    },
};

/// The corners of a face on the screen, from its top.
struct Corners<'v> {
    sides: Sides,
    depths: [u32; 3],
    /// The reciprocal of its area, for a small face.
    small: Option<(SmallFace, AreaReciprocal)>,
    viewport: &'v Window,
    first_column: i32,
}

impl<'v> Corners<'v> {
    fn new<S: ScreenPrecision>(sides: Sides, depths: [u32; 3], surroundings: &Surroundings<'v>) -> Self {
        Self {
            sides,
            depths,
            small: if S::FRACTION_BITS <= 4 {
                SmallFace::new(&sides).and_then(|small| Some((small, small.reciprocal()?)))
            } else {
                None
            },
            viewport: surroundings.viewport,
            first_column: surroundings.first_column,
        }
    }
}

/// A [`PlaneSource`] at a precision.
struct AtPrecision<'c, 'v, S>(&'c Corners<'v>, core::marker::PhantomData<S>);

impl<S: ScreenPrecision> PlaneSource for AtPrecision<'_, '_, S> {
    #[inline]
    fn plane(&self, values: [i32; 3]) -> ScreenPlane {
        let corners = self.0;
        match corners
            .small
            .and_then(|(small, reciprocal)| small.gradients(values, || Some(reciprocal)))
        {
            Some(small) => small.through(corners.sides.top, values[0]),
            None => {
                let mut sides = corners.sides;
                sides.top.x += corners.first_column << S::FRACTION_BITS;
                wide_attribute_plane::<S>(&sides, values, corners.viewport, corners.first_column)
            }
        }
    }

    fn depths(&self) -> [u32; 3] {
        self.0.depths
    }
}

/// Sets up the planes of the attributes of a face with these corners.
#[inline(never)]
pub(super) fn set_up_attributes<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    face: &mut ActiveFace<S, H>,
    faces: &F,
    corners: [&ScreenVertex<S, D>; 3],
    surroundings: &Surroundings<'_>,
) {
    let Some(attributes) = faces.attributes(face.node) else {
        return;
    };
    let attributes = in_order_of_rows(corners, attributes);
    let corners = from_top(corners);
    let sides = Sides::of(corners, surroundings.first_column);
    let depths = if F::IS_ORTHOGRAPHIC {
        // Nothing has a weight: as in a face whose corners are all as far away.
        [1; 3]
    } else {
        corners.map(|corner| (corner.z.units() as u32) << D::FRACTION_BITS)
    };
    let corners = Corners::new::<S>(sides, depths, surroundings);
    let source = AtPrecision::<S>(&corners, core::marker::PhantomData);
    face.attributes = H::Attributes::set_up(attributes, &source, H::TOLERANCE);
}
