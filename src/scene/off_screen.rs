//! Vertices off the screen, which are nearer than the near plane, behind the far plane or beyond the guard band: how the table
//! of projected vertices marks them, and how their faces' corners are computed when a face is cut.

use crate::{
    clip::convex::Plane,
    scene::{
        Look,
        lens::{ProjectionOf, ScreenVertexOf, has_far_plane, project},
    },
    view::{DepthWidth, EyePoint, ScreenPrecision, ScreenVertex, ToEye, WideVertex},
};

/// A position of a look in the wide numbers that faces are cut in.
type Position<L> = [<<L as Look>::Precision as ScreenPrecision>::Wide; 3];

/// The entry of a vertex that is off the screen in the table of projected vertices: x is the mark [`ScreenPrecision::OUTSIDE`],
/// and y has a bit for each clipping plane that the vertex is beyond, the near plane's lowest.
#[cold]
#[inline(never)]
pub(super) fn off_screen<L: Look>(
    projection: &ProjectionOf<L>,
    transform: &impl ToEye,
    vertex: [i16; 3],
) -> ScreenVertexOf<L> {
    let mut corner = eye_corner::<L::Precision>(transform, vertex);
    let beyond = |side: &Plane, corner: &Position<L>| i32::from(side.distance::<L::Precision>(corner) < 0);
    let mut sides = beyond(&Plane::near(projection.near), &corner);
    if sides == 0 {
        let is_behind = i32::from(has_far_plane::<L>(projection)) & beyond(&Plane::far(projection.far), &corner);
        project_corner::<L>(projection, &mut corner);
        for side in &guard_band::<L>() {
            sides = sides << 1 | beyond(side, &corner);
        }
        // The lowest bits are those of the far and the near plane, and the vertex is not beyond that one.
        sides = sides << 2 | is_behind << 1;
    }
    ScreenVertex {
        x: L::Precision::OUTSIDE,
        y: L::Precision::narrow(sides),
        z: L::Depth::FARTHEST,
    }
}

/// Marks the vertices of a model that are behind the far plane as off the screen. Returns whether there is one.
#[cold]
#[inline(never)]
pub(super) fn mark_behind_far_plane<L: Look>(
    projection: &ProjectionOf<L>,
    transform: &impl ToEye,
    vertices: &[[i16; 3]],
    slots: &mut [ScreenVertexOf<L>],
) -> bool {
    let mut any = false;
    for (vertex, slot) in vertices.iter().zip(slots) {
        if transform.apply(*vertex).z > projection.far {
            *slot = off_screen::<L>(projection, transform, *vertex);
            any = true;
        }
    }
    any
}

/// A vertex of a model in eye space, in the wide numbers that faces are cut in.
#[cold]
#[inline(never)]
pub(super) fn eye_corner<S: ScreenPrecision>(transform: &impl ToEye, vertex: [i16; 3]) -> [S::Wide; 3] {
    let EyePoint { x, y, z } = transform.apply(vertex);
    [S::wide(x.into()), S::wide(y.into()), S::wide(z.into())]
}

/// Projects a corner behind the near plane from eye space to the screen, in place.
#[cold]
#[inline(never)]
pub(super) fn project_corner<L: Look>(projection: &ProjectionOf<L>, corner: &mut Position<L>) {
    let [x, y, z] = *corner;
    let (x, y, z) = (x.into() as i32, y.into() as i32, z.into() as i32);
    let WideVertex { x, y, z } = project::<L>(projection, EyePoint { x, y, z });
    *corner = [
        L::Precision::wide(x),
        L::Precision::wide(y),
        L::Precision::wide(z.into()),
    ];
}

/// The sides of the guard band of a look: left, right, top, bottom.
pub(super) const fn guard_band<L: Look>() -> [Plane; 4] {
    Plane::guard_band::<L::Precision>(!L::IS_ORTHOGRAPHIC)
}

/// Whether an entry of the table of projected vertices marks a vertex off the screen.
#[inline]
pub(super) fn is_outside<S: ScreenPrecision, D: DepthWidth>(vertex: &ScreenVertex<S, D>) -> bool {
    vertex.x == S::OUTSIDE
}
