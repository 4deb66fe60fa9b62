//! Sets up the planes of the depth and the attributes of a face: one reciprocal a small face, whatever the number of planes.

use core::{borrow::Borrow, marker::PhantomData};

use crate::{
    geometry::ScreenPlane,
    shade::{PlaneSource, Planes, Shading},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{
        active_face::{ActiveFace, LeftOver, Surroundings, from_top, in_order_of_rows},
        depth_plane::{AreaReciprocal, DepthPlane, SmallFace, wide_attribute_plane},
        face_table::{FaceTable, corners_from_top},
        sides::{SamplePosition, Sides},
    },
};

/// The corners of a face on the screen, from its top.
struct Corners<'c, 'v, S, D, H, F, P> {
    sides: Sides,
    depths: [u32; 3],
    /// The reciprocal of its area, for a small face.
    small: Option<(SmallFace, AreaReciprocal)>,
    faces: &'c F,
    node: u16,
    surroundings: &'c Surroundings<'v, P>,
    look: PhantomData<(S, D, H)>,
}

impl<S, D, H, F, P> PlaneSource for Corners<'_, '_, S, D, H, F, P>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
    P: SamplePosition,
{
    #[inline]
    fn plane(&self, values: [i32; 3]) -> ScreenPlane {
        match self
            .small
            .and_then(|(small, reciprocal)| small.gradients(values, || Some(reciprocal)))
        {
            Some(small) => small.through(self.sides.top, values[0]),
            None => {
                let [top, right, left] = values;
                wide_plane(self.faces, self.node, self.surroundings, top, right, left)
            }
        }
    }

    #[inline]
    fn depths(&self) -> [u32; 3] {
        self.depths
    }
}

/// The plane of an attribute of a face that is not small, or where it is steep, from its values at the corners.
// The corners are looked up once more, and the values handed over one by one, so that those of the many small faces need not be
// in memory.
#[cold]
#[inline(never)]
fn wide_plane<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
    surroundings: &Surroundings<'_, impl SamplePosition>,
    top: i32,
    right: i32,
    left: i32,
) -> ScreenPlane {
    match corners_from_top(faces, node) {
        Some(corners) => {
            let sides = surroundings.sample.see(Sides::of(corners, 0));
            wide_attribute_plane::<S>(
                &sides,
                [top, right, left],
                surroundings.viewport,
                surroundings.first_column,
            )
        }
        None => ScreenPlane::ZERO,
    }
}

/// Sets up the plane of the depth of a face that is not small, or where it is steep.
#[cold]
#[inline(never)]
fn set_up_wide_depth<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    face: &mut ActiveFace<S, H>,
    faces: &impl FaceTable<S, D, H>,
    surroundings: &Surroundings<'_, impl SamplePosition>,
) {
    if let Some(corners) = corners_from_top(faces, face.node) {
        let sides = surroundings.sample.see(Sides::of(corners, 0));
        face.plane = DepthPlane::wide_at(corners, &sides, surroundings.viewport, surroundings.first_column);
    }
}

/// Sets up the planes of the depth and of the attributes of a face with these corners, and its edges by its sides, which are
/// the same. Returns the parts that are left.
#[inline(never)]
pub(super) fn set_up_attributes<S, D, H, F, P>(
    face: &mut ActiveFace<S, H>,
    faces: &F,
    corners: [&ScreenVertex<S, D>; 3],
    surroundings: &Surroundings<'_, P>,
    set_up_edges: impl FnOnce(&mut ActiveFace<S, H>, &Sides) -> LeftOver,
) -> LeftOver
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
    P: SamplePosition,
{
    let from_top = from_top(corners);
    let sides = surroundings.sample.see(Sides::of(from_top, surroundings.first_column));
    let left_over = set_up_edges(face, &sides);
    let Some(attributes) = faces.attributes(face.node, |of_corners| in_order_of_rows(corners, of_corners)) else {
        return left_over;
    };
    let depths = if F::IS_ORTHOGRAPHIC {
        // Nothing has a weight: as in a face whose corners are all as far away.
        [1; 3]
    } else {
        from_top.map(|corner| (corner.z.units() as u32) << D::FRACTION_BITS)
    };
    let corners = Corners::<S, D, H, F, P> {
        sides,
        depths,
        small: if S::FRACTION_BITS <= 4 {
            SmallFace::new(&sides, false).and_then(|small| Some((small, small.reciprocal(false)?)))
        } else {
            None
        },
        faces,
        node: face.node,
        surroundings,
        look: PhantomData,
    };
    if !surroundings.without_plane {
        let small = match corners.small {
            Some((small, reciprocal)) if D::FRACTION_BITS == 16 => {
                DepthPlane::of_small_face(from_top, &sides, small, || Some(reciprocal))
            }
            _ => None,
        };
        match small {
            Some(plane) => face.plane = plane,
            None => set_up_wide_depth(face, faces, surroundings),
        }
    }
    let attributes = attributes.each_ref().map(Borrow::borrow);
    H::Attributes::set_up(&mut face.attributes, attributes, &corners, H::TOLERANCE);
    left_over
}
