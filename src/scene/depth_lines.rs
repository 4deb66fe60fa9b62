//! The edges of a model as lines in depth: each with the greatest slope of the faces beside it, for a polygon offset.
//!
//! Nothing of it is linked into programs that do not ask for it.

use core::ops::Range;

use crate::{
    mesh::{Edge, FaceSet},
    scene::{
        Look, Model,
        edges::{ModelOnScreen, ScreenEdge},
        frame::{FRAGMENT_VERTICES, corners},
        lens::ScreenVertexOf,
        off_screen::is_outside,
    },
    view::Camera,
    visible::{DepthLine, slope_of_face},
};

/// An edge and the line that it is drawn as.
pub type LineOf<L> = (
    ScreenEdge<<L as Look>::Precision, <L as Look>::Depth>,
    DepthLine<<L as Look>::Depth>,
);

/// The edges of a model that are to be drawn, each with its line. `fragments` are the vertices of faces that were cut.
pub(super) fn lines_in_depth<'t, 'm, L: Look>(
    (vertices, fragments): (&'t [ScreenVertexOf<L>], Range<usize>),
    models: &'t [Model<'m, L::Shading>],
    camera: &'t Camera,
    model: usize,
    edges: &'t [Edge],
) -> impl Iterator<Item = LineOf<L>> + use<'t, 'm, L> {
    let before = models.get(..model).unwrap_or_default();
    let first_face = before.iter().map(|model| model.mesh().faces().len()).sum::<usize>();
    let fragments = vertices.get(fragments).unwrap_or_default();
    let on_screen = ModelOnScreen::<L>::new(vertices, models, camera, model);
    on_screen.into_iter().flat_map(move |model| {
        edges.iter().enumerate().filter_map(move |(index, edge)| {
            let on_screen = model.edge(index, edge)?;
            let slopes = edge.faces().map(|face| slope(&model, fragments, first_face, face));
            let line = DepthLine::new(on_screen.ends.map(|end| (end.pixel(), end.depth)));
            let [one, other] = slopes;
            Some((on_screen, line.with_slope(one.max(other))))
        })
    })
}

/// The greatest slope of a face beside an edge, or 0 where it is not seen.
fn slope<L: Look>(
    model: &ModelOnScreen<'_, '_, L>,
    fragments: &[ScreenVertexOf<L>],
    first_face: usize,
    face: u16,
) -> u32 {
    if face == FaceSet::NO_NEIGHBOUR || !ModelOnScreen::<L>::is_seen(model.side(face)) {
        return 0;
    }
    let index = usize::from(face);
    let Some(corners) = model
        .mesh()
        .faces()
        .get(index)
        .and_then(|face| corners(model.vertices, face))
    else {
        return 0;
    };
    if L::CLIPS && corners.into_iter().any(is_outside) {
        return slope_of_fragments::<L>(fragments, first_face + index);
    }
    slope_of_face(corners)
}

/// The greatest slope of the parts of a face that was cut, by its index in the order of models and faces.
fn slope_of_fragments<L: Look>(fragments: &[ScreenVertexOf<L>], order: usize) -> u32 {
    let parts = fragments
        .chunks_exact(FRAGMENT_VERTICES)
        .filter_map(|fragment| match fragment {
            [header, a, b, c] if usize::from(header.x_units() as u16) == order => Some(slope_of_face([a, b, c])),
            _ => None,
        });
    parts.max().unwrap_or(0)
}
