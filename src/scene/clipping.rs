//! Cuts the faces that the near plane, the far plane and the guard band cross. Linked only for frames whose look
//! [clips](crate::scene::Look::CLIPS).

use core::borrow::Borrow;

use crate::{
    clip::convex::{Plane, Polygon, PolygonCorner, cut_segment, sutherland_hodgman},
    scene::{
        Look, Model,
        back_faces::culls_by_planes,
        frame::{AttributesOf, FRAGMENT, FRAGMENT_VERTICES, MOST_NODES, StoredOf, corners},
        lens::{ScreenVertexOf, has_far_plane, projection},
        off_screen::{eye_corner, guard_band, is_outside, project_corner},
        preparation::{Preparation, begin, next_outside_rows, rows_of_face, visible_rows},
        stored_attributes::Stored,
    },
    shade::{Attributes, Shading},
    view::{AffineEyeTransform, Camera, DepthWidth, EyeTransform, ScreenPrecision, ScreenVertex, ToEye},
    visible::{NONE, Silhouettes},
};

/// A polygon of a look that is cut.
type PolygonOf<L> = Polygon<<L as Look>::Precision, AttributesOf<L>>;

impl<L: Look> Preparation<'_, L> {
    /// Puts the faces of a model into the buckets of their first rows, where some of them may have to be cut.
    #[inline(never)]
    pub(super) fn sort_faces_to_cut(
        &mut self,
        camera: &Camera,
        model: &Model<'_, L::Shading>,
        first_vertex: usize,
        first_face: usize,
    ) {
        let is_mirrored = model.is_mirrored();
        for (index, &[a, b, c]) in model.mesh().faces().iter().enumerate().rev() {
            let face = &if is_mirrored { [a, c, b] } else { [a, b, c] };
            let node = first_face + index;
            if culls_by_planes::<L>()
                && self
                    .tables
                    .next
                    .get(node)
                    .is_some_and(|next| usize::from(*next) == node)
            {
                continue;
            }
            let Some([a, b, c]) = corners(self.tables.vertices.get(first_vertex..).unwrap_or_default(), face) else {
                continue;
            };
            let next = if [a, b, c].into_iter().any(is_outside) {
                if !all_outside_alike([a, b, c]) {
                    self.cut_face(camera, model, face, (first_vertex, node as u16));
                    if L::DRAWS_BACKS {
                        // The other way round: of both polygons at most one is seen.
                        let [a, b, c] = *face;
                        self.cut_face(camera, model, &[a, c, b], (first_vertex, node as u16));
                    }
                }
                NONE
            } else if let Some(rows) = rows_of_face::<L>([a, b, c], &self.viewport) {
                begin(self.tables.rows, node as u16, rows)
            } else if L::Silhouettes::BY_AREA {
                next_outside_rows::<L>([a, b, c], node as u16)
            } else {
                continue;
            };
            if let Some(entry) = self.tables.next.get_mut(node) {
                *entry = next;
            }
        }
    }

    /// Cuts a face and puts its fragments, a fan of triangles, behind the vertices.
    #[cold]
    #[inline(never)]
    fn cut_face(
        &mut self,
        camera: &Camera,
        model: &Model<'_, L::Shading>,
        face: &[u16; 3],
        (first_vertex, order): (usize, u16),
    ) {
        let (mut polygon, mut kept) = (PolygonOf::<L>::new(), PolygonOf::<L>::new());
        for (index, position) in face.iter().zip(eye_corners::<L>(camera, model, face)) {
            let attributes = self.tables.attributes.get(first_vertex + usize::from(*index));
            let pushed = polygon.push(PolygonCorner {
                position,
                attributes: attributes.map_or(AttributesOf::<L>::ZERO, all_attributes::<L>),
            });
            debug_assert!(pushed.is_ok(), "three corners of nine");
        }
        let (mut polygon, mut kept) = (&mut polygon, &mut kept);
        sutherland_hodgman(polygon, &Plane::near(self.projection.near), kept);
        if has_far_plane::<L>(&self.projection) {
            core::mem::swap(&mut polygon, &mut kept);
            sutherland_hodgman(polygon, &Plane::far(self.projection.far), kept);
        }
        for corner in kept.iter_mut() {
            project_corner::<L>(&self.projection, &mut corner.position);
        }
        for side in &guard_band::<L>() {
            core::mem::swap(&mut polygon, &mut kept);
            sutherland_hodgman(polygon, side, kept);
        }
        if !is_front(kept) {
            return;
        }
        let Some((apex, fan)) = kept.split_first() else { return };
        for pair in fan.windows(2).rev() {
            let [second, third] = pair else { continue };
            let corners = [apex.position, second.position, third.position].map(inside);
            if let Some(rows) = visible_rows::<L>(corners.each_ref(), &self.viewport) {
                self.add_clipped_face(&corners, order, rows);
                self.set_attributes_of_last([apex.attributes, second.attributes, third.attributes]);
            }
        }
    }

    /// Puts a fragment into the bucket of its first row. Counts its vertices even where there is no room for them.
    fn add_clipped_face(
        &mut self,
        corners: &[ScreenVertex<L::Precision, L::Depth>; 3],
        order: u16,
        rows: (usize, usize),
    ) {
        let header = self.vertices_needed;
        self.vertices_needed = header.saturating_add(FRAGMENT_VERTICES);
        let within = self.vertices_needed <= MOST_NODES;
        let vertices = self.tables.vertices.get_mut(header..self.vertices_needed);
        if let (true, Some([header, a, b, c])) = (within, vertices) {
            header.x = L::Precision::narrow(i32::from(order));
            [*a, *b, *c] = *corners;
        }
        let next = begin(self.tables.rows, FRAGMENT | header as u16, rows);
        if let Some(header) = self.tables.vertices.get_mut(header) {
            header.y = L::Precision::narrow(i32::from(next));
        }
    }

    /// Sets what varies over the fragment that was added last.
    fn set_attributes_of_last(&mut self, corners: [AttributesOf<L>; 3]) {
        let first = self.vertices_needed.saturating_sub(corners.len());
        if let Some(attributes) = self.tables.attributes.get_mut(first..self.vertices_needed) {
            attributes.copy_from_slice(&corners.map(StoredOf::<L>::new));
        }
    }
}

/// All attributes of a vertex, in a look that cuts faces.
fn all_attributes<L: Look>(stored: &StoredOf<L>) -> AttributesOf<L> {
    // All are kept, none is asked for.
    *stored.attributes(|| AttributesOf::<L>::ZERO).borrow()
}

/// The ends on the screen of what the near plane, the far plane and the guard band leave of an edge between two vertices of a
/// model; `None` where nothing is left.
#[cold]
#[inline(never)]
pub(super) fn cut_edge<L: Look>(
    camera: &Camera,
    model: &Model<'_, L::Shading>,
    [from, to]: [u16; 2],
) -> Option<[ScreenVertexOf<L>; 2]> {
    let projection = projection::<L>(camera);
    let [from, to, _] = eye_corners::<L>(camera, model, &[from, to, to]);
    let mut ends = cut_segment::<L::Precision>([from, to], &Plane::near(projection.near))?;
    if has_far_plane::<L>(&projection) {
        ends = cut_segment::<L::Precision>(ends, &Plane::far(projection.far))?;
    }
    for end in &mut ends {
        project_corner::<L>(&projection, end);
    }
    for side in &guard_band::<L>() {
        ends = cut_segment::<L::Precision>(ends, side)?;
    }
    Some(ends.map(inside))
}

/// From which side a face of a model is seen, or would be if it were on the screen: 1 from the front, -1 from behind, 0 where
/// it is seen on edge. By the plane of the face in eye space, and on which side of that the camera is.
#[cold]
#[inline(never)]
pub(super) fn side_in_eye_space<L: Look>(camera: &Camera, model: &Model<'_, L::Shading>, face: &[u16; 3]) -> i32 {
    let [a, b, c] = eye_corners::<L>(camera, model, face).map(|corner| corner.map(|part| i128::from(part.into())));
    // The camera is at the origin; where rays are parallel, only x and y of the normal's way matter. Coordinates are below
    // 2^34 in size.
    let cross = |[x, y, _]: [i128; 3], [u, v, _]: [i128; 3]| x * v - y * u;
    let signed = if L::IS_ORTHOGRAPHIC {
        cross(a, b) + cross(b, c) + cross(c, a)
    } else {
        let [[.., near_a], [.., near_b], [.., near_c]] = [a, b, c];
        cross(a, b) * near_c + cross(b, c) * near_a + cross(c, a) * near_b
    };
    // With y up, what runs clockwise is negative.
    -signed.signum() as i32
}

/// The corners of a face in eye space.
fn eye_corners<L: Look>(
    camera: &Camera,
    model: &Model<'_, L::Shading>,
    face: &[u16; 3],
) -> [[<L::Precision as ScreenPrecision>::Wide; 3]; 3] {
    let vertices = model.mesh().vertices();
    if L::Shading::HAS_AFFINE_MAP {
        let affine = L::Shading::affine(model.skin());
        // It was there when the vertices were transformed.
        match AffineEyeTransform::new(affine, &model.pose, camera.pose()) {
            Some(transform) => to_eye::<L::Precision>(&transform, vertices, face),
            None => Default::default(),
        }
    } else {
        let transform = EyeTransform::<L::Precision>::new(&model.pose, camera.pose());
        to_eye::<L::Precision>(&transform, vertices, face)
    }
}

/// Three of the vertices of a mesh in eye space.
fn to_eye<S: ScreenPrecision>(transform: &impl ToEye, vertices: &[[i16; 3]], face: &[u16; 3]) -> [[S::Wide; 3]; 3] {
    face.map(|index| {
        let vertex = vertices.get(usize::from(index)).copied().unwrap_or_default();
        eye_corner::<S>(transform, vertex)
    })
}

/// Whether a polygon on the screen is seen from the front: its corners run clockwise. Corners of cuts are rounded, so that the
/// fragments of one that is seen from behind may be slivers that run clockwise.
fn is_front<S: ScreenPrecision, A: Attributes>(polygon: &Polygon<S, A>) -> bool {
    let Some((apex, others)) = polygon.split_first() else {
        return false;
    };
    // Twice the area: differences below 2^24, and eight corners.
    let from_apex = |corner: &PolygonCorner<S, A>| {
        let ([x, y, _], [from_x, from_y, _]): ([S::Wide; 3], [S::Wide; 3]) = (corner.position, apex.position);
        [x.into() - from_x.into(), y.into() - from_y.into()]
    };
    let mut area = 0;
    for pair in others.windows(2) {
        if let [one, other] = pair {
            let ([x1, y1], [x2, y2]): ([i64; 2], [i64; 2]) = (from_apex(one), from_apex(other));
            area += x1 * y2 - x2 * y1;
        }
    }
    area > 0
}

/// Trivial rejection: whether all three corners are beyond the same clipping plane.
fn all_outside_alike<S: ScreenPrecision, D: DepthWidth>(corners: [&ScreenVertex<S, D>; 3]) -> bool {
    corners
        .into_iter()
        .map(|corner| if is_outside(corner) { corner.y_units() } else { 0 })
        .fold(-1, |shared, sides| shared & sides)
        != 0
}

/// The screen vertex of a corner that is inside the guard band.
fn inside<S: ScreenPrecision, D: DepthWidth>(corner: [S::Wide; 3]) -> ScreenVertex<S, D> {
    let [x, y, z] = corner;
    ScreenVertex {
        x: S::narrow(x.into() as i32),
        y: S::narrow(y.into() as i32),
        z: D::from_units(z.into() as i32),
    }
}
