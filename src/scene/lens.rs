//! The lens of a look: perspective, or parallel rays where it is orthographic. The other one is not linked.

use crate::{
    scene::Look,
    view::{Camera, EyePoint, Projection, ScreenVertex, WideVertex},
};

/// The numbers that a camera fixes for a frame of a look.
pub(super) type ProjectionOf<L> = Projection<<L as Look>::Precision, <L as Look>::Depth>;

/// A vertex on the screen of a look.
pub(super) type ScreenVertexOf<L> = ScreenVertex<<L as Look>::Precision, <L as Look>::Depth>;

/// The numbers that a camera fixes for a frame.
#[inline]
pub(super) fn projection<L: Look>(camera: &Camera) -> ProjectionOf<L> {
    if L::IS_ORTHOGRAPHIC {
        Projection::parallel(camera)
    } else {
        Projection::new(camera)
    }
}

/// Projects a vertex that is not in front of the near plane.
#[inline]
pub(super) fn project<L: Look>(projection: &ProjectionOf<L>, eye: EyePoint) -> WideVertex {
    if L::IS_ORTHOGRAPHIC {
        projection.project_parallel(eye)
    } else {
        projection.project(eye)
    }
}

/// Projects a vertex; `None` where it is off the screen. In perspective it may be behind the far plane.
#[inline]
pub(super) fn on_screen<L: Look>(projection: &ProjectionOf<L>, eye: EyePoint) -> Option<ScreenVertexOf<L>> {
    if L::IS_ORTHOGRAPHIC {
        return projection.project_parallel_inside(eye);
    }
    if eye.z < projection.near {
        return None;
    }
    projection.project_inside(eye)
}

/// Whether there is a far plane to cut at: where rays are parallel, depths end at it.
#[inline]
pub(super) fn has_far_plane<L: Look>(projection: &ProjectionOf<L>) -> bool {
    L::IS_ORTHOGRAPHIC || projection.far != 0
}
