//! Once a frame: vertices to the screen, faces culled and sorted by their first row.

use core::ops::Range;

use crate::{
    geometry::{InputError, TooSmall, Window, pixel_domain},
    scene::{
        Frame, Look, Model, Prepared,
        back_faces::{culls_by_planes, transform_seen},
        culling::{is_beyond, is_left_out, leave_out, view_volume},
        frame::{AttributesOf, MOST_NODES, RowStart, StoredOf, Tables, corners},
        lens::{ProjectionOf, ScreenVertexOf, has_far_plane, on_screen, projection},
        off_screen::{mark_behind_far_plane, off_screen},
        preparation::{Preparation, begin, next_outside_rows, rows_of_face},
        prepared_faces::UniformsOf,
        seen_vertices::SeenVertices,
        stored_attributes::Stored,
    },
    shade::{Planes, Shading},
    view::{AffineEyeTransform, Camera, EyePoint, EyeTransform, ScreenPrecision, ToEye, ViewVolume},
    visible::{LookVisibility, Silhouettes},
};

/// The clipping boundary beyond which an off-screen vertex lies.
#[derive(Debug, Copy, Clone)]
enum OutsideOf {
    NearPlane,
    FarPlane,
    GuardBand,
}

impl OutsideOf {
    const fn error(self, model: usize) -> InputError {
        match self {
            Self::NearPlane => InputError::BeforeNearPlane { model },
            Self::FarPlane => InputError::BehindFarPlane { model },
            Self::GuardBand => InputError::BeyondGuardBand { model },
        }
    }
}

impl<L: Look> Frame<'_, L> {
    /// Prepares a frame: each vertex is transformed once; faces that are seen from behind or cover no pixel of the
    /// viewport are left out; faces that cross the near or the far plane or leave the guard band are cut, unless the
    /// look does without ([`Look::CLIPS`]).
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the capacity that would do, exactly; [`InputError::OutOfDomain`] where the viewport is;
    /// [`InputError::ModelOutOfDomain`] where an affine map makes a model too large;
    /// [`InputError::BeforeNearPlane`], [`InputError::BehindFarPlane`] and [`InputError::BeyondGuardBand`] where faces are not
    /// cut.
    #[inline]
    pub fn prepare<'f, 'm>(
        &'f mut self,
        camera: &Camera,
        models: &'f [Model<'m, L::Shading>],
    ) -> Result<Prepared<'f, 'm, L>, InputError> {
        Prepared::new(self.reborrow(), camera, models)
    }

    /// Fills the tables, and returns where among the vertices the fragments of cut faces are.
    #[inline]
    pub(super) fn fill(
        &mut self,
        camera: &Camera,
        models: &[Model<'_, L::Shading>],
    ) -> Result<Range<usize>, InputError> {
        let viewport = camera.viewport();
        check_viewport::<L::Precision>(&viewport)?;
        let [vertices, faces] = totals(models);
        let most_vertices = self.tables.vertices.len().min(MOST_NODES);
        check(most_vertices, TooSmall::Vertices(vertices))?;
        check(self.tables.next.len().min(MOST_NODES), TooSmall::Faces(faces))?;
        check(self.depths.len(), TooSmall::Columns(viewport.width() as usize))?;
        check(self.tables.rows.len(), TooSmall::Rows(viewport.height() as usize))?;

        let mut preparation = Preparation {
            tables: self.tables.reborrow(),
            projection: projection::<L>(camera),
            viewport,
            vertices_needed: vertices,
        };
        preparation.tables.clear_rows();
        let all_inside = preparation.transform_vertices(camera, models)?;
        preparation.sort_faces(camera, models, vertices, faces, !all_inside || !L::HURRIES);
        let vertices_needed = preparation.vertices_needed;
        if L::CLIPS {
            check(most_vertices, TooSmall::Vertices(vertices_needed))?;
        }
        let most_active = RowStart::most_active(self.tables.rows);
        if L::DRAWS_IN_PASSES && !L::IS_MULTISAMPLED {
            check(self.active.capacity(), TooSmall::ActiveFaces(most_active.min(1)))?;
            self.active.restart_passes(most_active);
        } else {
            check(self.active.capacity(), TooSmall::ActiveFaces(most_active))?;
        }
        self.silhouettes.row.visibility.restart();
        self.active.restart();
        Ok(vertices..vertices_needed)
    }
}

fn check_viewport<S: ScreenPrecision>(viewport: &Window) -> Result<(), InputError> {
    let (min, max) = pixel_domain::<S>();
    let inside = min <= viewport.left.min(viewport.top) && viewport.right.max(viewport.bottom) <= max;
    if inside {
        Ok(())
    } else {
        Err(InputError::out_of_domain::<S>())
    }
}

/// The number of vertices and the number of faces of all models of a frame together, each at most [`usize::MAX`].
fn totals<H: Shading>(models: &[Model<'_, H>]) -> [usize; 2] {
    [
        total(models.iter().map(|model| model.mesh().vertices().len())),
        total(models.iter().map(|model| model.mesh().faces().len())),
    ]
}

/// The sum of the lengths, or the greatest number: models may share a mesh, so that the sum may exceed memory.
fn total(lengths: impl Iterator<Item = usize>) -> usize {
    lengths.fold(0, usize::saturating_add)
}

fn check(capacity: usize, needed: TooSmall) -> Result<(), InputError> {
    trace!("{} of {} in use", needed, capacity);
    if needed.needed() <= capacity {
        Ok(())
    } else {
        Err(InputError::TooSmall(needed))
    }
}

impl<L: Look> Preparation<'_, L> {
    /// Transforms all vertices. Returns whether all are on the screen; where no face is cut, one that is not is an
    /// error.
    fn transform_vertices(&mut self, camera: &Camera, models: &[Model<'_, L::Shading>]) -> Result<bool, InputError> {
        let Self { tables, projection, .. } = self;
        let mut slots = &mut *tables.vertices;
        let mut first_face = 0;
        let mut all_inside = true;
        // Not by `then`, whose closure the compiler would begin with for all shadings.
        let volume = if L::Shading::HAS_BOUNDS {
            Some(view_volume::<L>(projection, camera))
        } else {
            None
        };
        for (index, model) in models.iter().enumerate() {
            let vertices = model.mesh().vertices();
            // The capacity was checked: there is room for all vertices.
            let Some((slots_of_model, rest)) = slots.split_at_mut_checked(vertices.len()) else {
                break;
            };
            let transformed = if L::Shading::HAS_AFFINE_MAP {
                let transform = affine_transform(model, camera).ok_or(InputError::ModelOutOfDomain { model: index })?;
                let is_unseen = is_beyond_bounds(volume.as_ref(), &transform, model, |ends| transform.fits(ends));
                put_on_screen::<L>(projection, &transform, vertices, slots_of_model, is_unseen)
            } else {
                let transform = EyeTransform::<L::Precision>::new(&model.pose, camera.pose());
                let is_unseen = is_beyond_bounds(volume.as_ref(), &transform, model, |_| true);
                if culls_by_planes::<L>() {
                    let (first, count) = (first_face, model.mesh().faces().len());
                    first_face += count;
                    let next = tables.next.get_mut(first..first_face).unwrap_or_default();
                    if !is_unseen && transform_seen::<L>(projection, &transform, model, slots_of_model, (first, next)) {
                        slots = rest;
                        continue;
                    }
                }
                put_on_screen::<L>(projection, &transform, vertices, slots_of_model, is_unseen)
            };
            all_inside &= transformed.map_err(|beyond| beyond.error(index))?;
            slots = rest;
        }
        Ok(all_inside)
    }

    /// Puts all faces into the buckets of their first rows, and computes what their vertices have beside positions. Backwards,
    /// because each face becomes the head of its bucket.
    fn sort_faces(
        &mut self,
        camera: &Camera,
        models: &[Model<'_, L::Shading>],
        vertices: usize,
        faces: usize,
        cut: bool,
    ) {
        let (mut first_vertex, mut first_face) = (vertices, faces);
        for model in models.iter().rev() {
            let mesh = model.mesh();
            // No underflow: both numbers began as the sums of these lengths.
            first_vertex -= mesh.vertices().len();
            first_face -= mesh.faces().len();
            if is_left_out::<L>(self.tables.vertices, first_vertex) {
                continue;
            }
            let mut seen = SeenVertices::none();
            let may_be_cut = L::CLIPS && cut;
            // Faces that are cut need what all their vertices have.
            if may_be_cut || !Self::LIGHTS_VERTICES {
                self.shade_vertices(camera, model, first_vertex, None);
            }
            if may_be_cut {
                self.sort_faces_to_cut(camera, model, first_vertex, first_face);
            } else {
                self.tables
                    .sort_whole_faces(model, first_vertex, first_face, &self.viewport, &mut seen);
            }
            if !may_be_cut && Self::LIGHTS_VERTICES {
                self.shade_vertices(camera, model, first_vertex, Some(&seen));
            }
        }
    }

    /// Whether so much is computed for a vertex that it is left out where no face is seen: there are lights. Silhouettes also
    /// look at faces between the centres of pixels, which rows do not reach.
    const LIGHTS_VERTICES: bool = AttributesOf::<L>::VARY && !L::Silhouettes::BY_AREA && size_of::<UniformsOf<L>>() > 0;

    /// Fills in what the vertices of a model have beside their positions: those that are seen, or all.
    fn shade_vertices(
        &mut self,
        camera: &Camera,
        model: &Model<'_, L::Shading>,
        first_vertex: usize,
        seen: Option<&SeenVertices>,
    ) {
        if !AttributesOf::<L>::VARY {
            return;
        }
        let end = first_vertex + model.mesh().vertices().len();
        if let Some(attributes) = self.tables.attributes.get_mut(first_vertex..end) {
            shade_vertices::<L>(model, camera, attributes, seen);
        }
    }
}

impl<L: Look> Tables<'_, L> {
    /// Puts the faces of a model of which none must be cut into their buckets. A loop of its own, because half of all
    /// faces end in it.
    #[inline(never)]
    fn sort_whole_faces(
        &mut self,
        model: &Model<'_, L::Shading>,
        first_vertex: usize,
        first_face: usize,
        viewport: &Window,
        seen: &mut SeenVertices,
    ) {
        let mesh = model.mesh();
        let is_mirrored = model.is_mirrored();
        let last_vertex = first_vertex + mesh.vertices().len();
        let vertices = self.vertices.get(first_vertex..last_vertex).unwrap_or_default();
        let next = self.next.get_mut(first_face..).unwrap_or_default();
        for (index, (face, next)) in mesh.faces().iter().zip(next).enumerate().rev() {
            let node = (first_face + index) as u16;
            if culls_by_planes::<L>() && *next == node {
                continue;
            }
            let Some([a, b, c]) = corners(vertices, face) else {
                continue;
            };
            let corners = if is_mirrored { [a, c, b] } else { [a, b, c] };
            if let Some(rows) = rows_of_face::<L>(corners, viewport) {
                *next = begin(self.rows, node, rows);
                if Preparation::<L>::LIGHTS_VERTICES {
                    seen.mark(*face);
                }
            } else if L::Silhouettes::BY_AREA {
                *next = next_outside_rows::<L>(corners, node);
            }
        }
    }
}

/// The transformation of a model by an affine map, if its vertices fit.
pub(super) fn affine_transform<H: Shading>(model: &Model<'_, H>, camera: &Camera) -> Option<AffineEyeTransform> {
    AffineEyeTransform::new(H::affine(model.skin()), &model.pose, camera.pose())
        .filter(|transform| transform.fits(model.mesh().vertices()))
}

/// Whether nothing of a model is seen: it has bounds, whose points `fit` the numbers of eye space, and all of them is beyond
/// one plane.
#[inline]
fn is_beyond_bounds<H: Shading>(
    volume: Option<&ViewVolume>,
    transform: &impl ToEye,
    model: &Model<'_, H>,
    fit: impl FnOnce(&[[i16; 3]]) -> bool,
) -> bool {
    // The constant first: for other shadings the compiler does not even begin with what follows.
    if !H::HAS_BOUNDS {
        return false;
    }
    match (volume, H::bounds(model.skin())) {
        (Some(volume), Some(bounds)) => is_beyond(volume, transform, &bounds, fit),
        _ => false,
    }
}

/// Transforms the vertices of a model, or marks one of which nothing is seen. Returns whether all that are transformed are on
/// the screen and in front of the far plane; where no face is cut, one that is not on the screen is an error.
#[inline]
fn put_on_screen<L: Look>(
    projection: &ProjectionOf<L>,
    transform: &impl ToEye,
    vertices: &[[i16; 3]],
    slots: &mut [ScreenVertexOf<L>],
    is_unseen: bool,
) -> Result<bool, OutsideOf> {
    if L::Shading::HAS_BOUNDS && is_unseen {
        leave_out::<L>(slots);
        return Ok(true);
    }
    let all_inside = transform_model::<L>(projection, transform, vertices, slots)?;
    // Once more over the vertices, so that a frame without a far plane takes no time for it.
    if L::CLIPS && !L::IS_ORTHOGRAPHIC && has_far_plane::<L>(projection) {
        let any = mark_behind_far_plane::<L>(projection, transform, vertices, slots);
        return Ok(all_inside && !any);
    }
    Ok(all_inside)
}

/// Transforms the vertices of a model. Returns whether all are on the screen; where no face is cut, one that is not is
/// an error.
// Not inlined: the loop needs every register.
#[inline(never)]
fn transform_model<L: Look>(
    projection: &ProjectionOf<L>,
    transform: &impl ToEye,
    vertices: &[[i16; 3]],
    slots: &mut [ScreenVertexOf<L>],
) -> Result<bool, OutsideOf> {
    let mut all_inside = true;
    for (vertex, slot) in vertices.iter().zip(slots) {
        let eye = transform.apply(*vertex);
        if let Some(vertex) = on_screen::<L>(projection, eye) {
            *slot = vertex;
        } else if !L::CLIPS {
            return Err(beyond::<L>(projection, eye));
        } else {
            *slot = off_screen::<L>(projection, transform, *vertex);
            all_inside = false;
        }
    }
    Ok(all_inside)
}

/// Fills in what the vertices of a model have beside their positions: those that are seen, or all.
#[inline(never)]
fn shade_vertices<L: Look>(
    model: &Model<'_, L::Shading>,
    camera: &Camera,
    attributes: &mut [StoredOf<L>],
    seen: Option<&SeenVertices>,
) {
    let uniforms = L::Shading::uniforms(model.skin(), &model.pose, camera);
    let vertices = model.mesh().vertices().iter().enumerate();
    let mut bits = u32::MAX;
    for (attributes, (vertex, position)) in attributes.iter_mut().zip(vertices) {
        // The constant first: in other looks all vertices are filled in.
        if Preparation::<L>::LIGHTS_VERTICES && vertex % SeenVertices::CHUNK == 0 {
            bits = seen.map_or(u32::MAX, |seen| seen.of_chunk(vertex / SeenVertices::CHUNK));
        }
        let is_seen = bits & 1 != 0;
        if Preparation::<L>::LIGHTS_VERTICES {
            bits >>= 1;
        }
        if is_seen {
            let all = L::Shading::vertex(model.skin(), &uniforms, vertex, position.map(i32::from));
            *attributes = StoredOf::<L>::new(all);
        }
    }
}

/// The clipping boundary beyond which a vertex that is off the screen lies.
fn beyond<L: Look>(projection: &ProjectionOf<L>, eye: EyePoint) -> OutsideOf {
    if eye.z < projection.near {
        OutsideOf::NearPlane
    } else if L::IS_ORTHOGRAPHIC && eye.z > projection.far {
        OutsideOf::FarPlane
    } else {
        OutsideOf::GuardBand
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Many models of one mesh have more vertices than there are addresses.
    #[test]
    fn a_total_ends_at_the_greatest_number() {
        assert_eq!(total([].into_iter()), 0);
        assert_eq!(total([3, usize::MAX - 3].into_iter()), usize::MAX);
        assert_eq!(total([3, usize::MAX - 2].into_iter()), usize::MAX);
        assert_eq!(total([usize::MAX / 2; 9].into_iter()), usize::MAX);
        let capacity = MOST_NODES;
        let needed = total([1 << (usize::BITS - 2); 4].into_iter());
        assert!(check(capacity, TooSmall::Vertices(needed)).is_err());
    }
}
