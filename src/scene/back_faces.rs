//! Faces that are turned away for certain, left out before their vertices are transformed, and the marks that they leave in the
//! tables. Linked only for shadings whose models have [planes](crate::shade::Shading::HAS_PLANES).
//!
//! First each plane of a model is asked whether the eye is behind it; the vertices of the other faces are marked, and then
//! transformed. A face that was left out is its own next node; a vertex that was left out has a mark in its coordinates, and
//! whoever asks for it later, to draw a model as points or hidden edges, has it transformed then.

use crate::{
    scene::{
        Look, Model,
        culling::is_left_out,
        lens::{ProjectionOf, ScreenVertexOf, on_screen, projection},
        off_screen::is_outside,
        seen_vertices::SeenVertices,
    },
    shade::Shading,
    view::{BackFaceTest, Camera, DepthWidth, EyeTransform, PlanesOfMesh, ScreenPrecision, ScreenVertex, ToEye},
    visible::NONE,
};

/// Whether faces of a look are left out by their planes: they have some, in the axes of the world, and backs are not drawn. Not
/// where shortcuts are switched off.
pub(super) const fn culls_by_planes<L: Look>() -> bool {
    L::Shading::HAS_PLANES && !L::Shading::HAS_AFFINE_MAP && L::HURRIES && !L::DRAWS_BACKS
}

/// The vertical coordinate of a vertex that was not transformed; its horizontal one is that of a vertex off the screen. There
/// the vertical coordinate has a bit for each plane that the vertex is beyond, and no vertex is beyond all planes but one.
const NOT_TRANSFORMED: i32 = -2;

/// Transforms the vertices of a model that its faces need which are not turned away for certain, and marks the other vertices
/// and faces. `false` where all vertices are to be transformed, because some may be off the screen, or one of them is that has
/// moved since the planes were found; then no face is marked.
///
/// `next` has an entry for each face, from the model's first on, whose index is that of the face among those of all models.
#[inline(never)]
pub(super) fn transform_seen<L: Look>(
    projection: &ProjectionOf<L>,
    transform: &EyeTransform<L::Precision>,
    model: &Model<'_, L::Shading>,
    slots: &mut [ScreenVertexOf<L>],
    (first_face, next): (usize, &mut [u16]),
) -> bool {
    let mesh = model.mesh();
    let Some((test, planes)) = test_of::<L>(projection, transform, model) else {
        next.fill(NONE);
        return false;
    };
    let mut seen = SeenVertices::none();
    let mut node = first_face as u16;
    for ((face, plane), next) in mesh.faces().iter().zip(planes).zip(&mut *next) {
        if test.is_turned_away(*plane) {
            *next = node;
        } else {
            *next = NONE;
            seen.mark(*face);
        }
        // Fewer than 2^15 faces have nodes, and one after the last may have any number.
        node = node.wrapping_add(1);
    }
    let are_inside = transform_marked::<L>(projection, transform, mesh.vertices(), slots, &seen);
    if !are_inside {
        next.fill(NONE);
    }
    are_inside
}

/// Transforms the vertices that are marked, up to one that is off the screen: then the result is `false`.
// Not inlined: the loop needs every register.
#[inline(never)]
fn transform_marked<L: Look>(
    projection: &ProjectionOf<L>,
    transform: &EyeTransform<L::Precision>,
    vertices: &[[i16; 3]],
    slots: &mut [ScreenVertexOf<L>],
    seen: &SeenVertices,
) -> bool {
    let left_out = not_transformed::<L>();
    let mut bits = 0;
    for (index, (vertex, slot)) in vertices.iter().zip(slots).enumerate() {
        if index % SeenVertices::CHUNK == 0 {
            bits = seen.of_chunk(index / SeenVertices::CHUNK);
        }
        *slot = if bits & 1 == 0 {
            left_out
        } else if let Some(found) = on_screen::<L>(projection, transform.apply(*vertex)) {
            found
        } else {
            return false;
        };
        bits >>= 1;
    }
    true
}

/// The test for the faces of a model, and their planes.
fn test_of<'m, L: Look>(
    projection: &ProjectionOf<L>,
    transform: &EyeTransform<L::Precision>,
    model: &Model<'m, L::Shading>,
) -> Option<(BackFaceTest, &'m [[i16; 4]])> {
    let planes = L::Shading::planes(model.skin())?;
    let (middle, halves) = planes.bounds().middle_and_halves()?;
    let format = planes.format();
    let of_mesh = PlanesOfMesh {
        middle,
        halves,
        normal_bits: format.normal_bits,
        offset_shift: format.offset_shift,
    };
    let test = if L::IS_ORTHOGRAPHIC {
        projection.parallel_back_face_test(transform, &of_mesh)
    } else {
        projection.back_face_test(transform, &of_mesh)
    };
    Some((test?, planes.table()))
}

/// The entry of a vertex that was not transformed in the table of projected vertices.
fn not_transformed<L: Look>() -> ScreenVertexOf<L> {
    ScreenVertex {
        x: L::Precision::OUTSIDE,
        y: L::Precision::narrow(NOT_TRANSFORMED),
        z: L::Depth::FARTHEST,
    }
}

/// Whether a vertex was not transformed, as none of a face that is drawn is.
#[inline]
pub(super) fn is_not_transformed<L: Look>(vertex: &ScreenVertexOf<L>) -> bool {
    culls_by_planes::<L>() && vertex.x == L::Precision::OUTSIDE && vertex.y_units() == NOT_TRANSFORMED
}

/// A vertex of a model by its index, transformed now if it was not when the frame was prepared.
#[inline]
pub(super) fn transformed<L: Look>(
    vertex: &ScreenVertexOf<L>,
    index: usize,
    model: &Model<'_, L::Shading>,
    camera: &Camera,
) -> ScreenVertexOf<L> {
    if is_not_transformed::<L>(vertex) {
        transform_late::<L>(index, model, camera)
    } else {
        *vertex
    }
}

/// Transforms one vertex of a model, all of which is on the screen.
#[cold]
#[inline(never)]
fn transform_late<L: Look>(index: usize, model: &Model<'_, L::Shading>, camera: &Camera) -> ScreenVertexOf<L> {
    let transform = EyeTransform::<L::Precision>::new(&model.pose, camera.pose());
    let vertex = model.mesh().vertices().get(index).copied().unwrap_or_default();
    on_screen::<L>(&projection::<L>(camera), transform.apply(vertex)).unwrap_or(not_transformed::<L>())
}

/// The models that were not left out as a whole, each with its vertices on the screen.
fn prepared_models<'m, 'a, L: Look>(
    vertices: &'m [ScreenVertexOf<L>],
    models: &'m [Model<'a, L::Shading>],
) -> impl Iterator<Item = (&'m Model<'a, L::Shading>, &'m [ScreenVertexOf<L>])> {
    let mut first_vertex = 0;
    models.iter().filter_map(move |model| {
        let first = first_vertex;
        first_vertex += model.mesh().vertices().len();
        let of_model = vertices.get(first..first_vertex).unwrap_or_default();
        (!is_left_out::<L>(vertices, first)).then_some((model, of_model))
    })
}

/// The number of vertices that were not transformed because only faces have them that are turned away. Models that were left
/// out as a whole do not count.
pub(super) fn vertices_not_transformed<L: Look>(
    vertices: &[ScreenVertexOf<L>],
    models: &[Model<'_, L::Shading>],
) -> u32 {
    let of_models = prepared_models::<L>(vertices, models);
    of_models
        .map(|(_, vertices)| vertices.iter().filter(|vertex| is_not_transformed::<L>(vertex)).count())
        .sum::<usize>() as u32
}

/// The number of faces that were left out because the eye is behind their planes. Asks each plane of the models once more, for
/// looks that count.
pub(super) fn faces_culled<L: Look>(
    vertices: &[ScreenVertexOf<L>],
    models: &[Model<'_, L::Shading>],
    camera: &Camera,
) -> u32 {
    if !culls_by_planes::<L>() {
        return 0;
    }
    let projection = projection::<L>(camera);
    let of_model = prepared_models::<L>(vertices, models).map(|(model, vertices)| {
        // With a vertex off the screen a model was prepared as without planes.
        if vertices
            .iter()
            .any(|vertex| is_outside(vertex) && !is_not_transformed::<L>(vertex))
        {
            return 0;
        }
        let transform = EyeTransform::new(&model.pose, camera.pose());
        test_of::<L>(&projection, &transform, model).map_or(0, |(test, planes)| {
            let faces = model.mesh().faces().iter().zip(planes);
            faces.filter(|(_, plane)| test.is_turned_away(**plane)).count()
        })
    });
    of_model.sum::<usize>() as u32
}
