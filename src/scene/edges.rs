//! The points and the edges of a prepared frame, to be drawn as points and lines.
//!
//! Which edges are drawn follows from which of the faces beside them are seen, as a face is culled: by the sense in which its
//! corners run on the screen where they were snapped, and by its plane in eye space where one of them is off the screen.
//!
//! Nothing of it is linked into programs that ask for neither.

use crate::{
    mesh::{Edge, EdgeKind, FaceSet},
    scene::{
        Look, Model,
        back_faces::{is_not_transformed, transformed},
        clipping::{cut_edge, side_in_eye_space},
        culling::is_left_out,
        faces::Corner,
        frame::corners,
        lens::ScreenVertexOf,
        model::outward,
        off_screen::is_outside,
        preparation::is_front,
    },
    view::{Camera, ScreenPrecision, ScreenVertex},
};

/// A vertex of a model on the screen.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScreenPoint<S: ScreenPrecision, D> {
    /// Index of the model among the models.
    pub model: usize,
    /// Index of the vertex in the model's mesh.
    pub vertex: usize,
    /// The position that the vertex was snapped to, and its depth.
    pub corner: Corner<S, D>,
}

/// An edge on the screen that is to be drawn.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScreenEdge<S: ScreenPrecision, D> {
    /// Index of the edge in the table of edges.
    pub index: usize,
    /// The ends, in the order of the edge's vertices, as they were snapped, or as the edge was cut.
    pub ends: [Corner<S, D>; 2],
    /// Whether the edge is a boundary, a crease or smooth; a smooth edge that is drawn is a silhouette.
    pub kind: EdgeKind,
    /// Whether the surface ends at the edge as it is seen: a boundary, or an edge of whose faces one is seen from the front.
    pub is_silhouette: bool,
}

/// The vertices on the screen, in the order of models and vertices.
pub(super) fn points<'t, 'm, L: Look>(
    vertices: &'t [ScreenVertexOf<L>],
    models: &'t [Model<'m, L::Shading>],
    camera: &'t Camera,
) -> impl Iterator<Item = ScreenPoint<L::Precision, L::Depth>> + use<'t, 'm, L> {
    let with_first_vertex = models.iter().enumerate().scan(0, |next, (number, model)| {
        let first_vertex = *next;
        *next += model.mesh().vertices().len();
        Some((number, model, first_vertex, *next))
    });
    with_first_vertex
        .filter(|(_, _, first_vertex, _)| !is_left_out::<L>(vertices, *first_vertex))
        .flat_map(move |(number, model, first_vertex, end)| {
            let of_model = vertices.get(first_vertex..end).unwrap_or_default();
            of_model.iter().enumerate().filter_map(move |(vertex, position)| {
                let position = transformed::<L>(position, vertex, model, camera);
                if L::CLIPS && is_outside(&position) {
                    return None;
                }
                Some(ScreenPoint {
                    model: number,
                    vertex,
                    corner: Corner::new(&position)?,
                })
            })
        })
}

/// The edges of a model that are to be drawn, of those of a table and in its order.
pub(super) fn edges<'t, 'm, L: Look>(
    vertices: &'t [ScreenVertexOf<L>],
    models: &'t [Model<'m, L::Shading>],
    camera: &'t Camera,
    model: usize,
    edges: &'t [Edge],
) -> impl Iterator<Item = ScreenEdge<L::Precision, L::Depth>> + use<'t, 'm, L> {
    let on_screen = ModelOnScreen::<L>::new(vertices, models, camera, model);
    on_screen.into_iter().flat_map(move |model| {
        let edges = edges.iter().enumerate();
        edges.filter_map(move |(index, edge)| model.edge(index, edge))
    })
}

/// A model of a prepared frame of which something may be seen.
#[derive(Copy, Clone)]
pub(super) struct ModelOnScreen<'t, 'm, L: Look> {
    /// The vertices of the model.
    pub(super) vertices: &'t [ScreenVertexOf<L>],
    model: &'t Model<'m, L::Shading>,
    camera: &'t Camera,
}

impl<'t, 'm, L: Look> ModelOnScreen<'t, 'm, L> {
    pub(super) fn new(
        vertices: &'t [ScreenVertexOf<L>],
        models: &'t [Model<'m, L::Shading>],
        camera: &'t Camera,
        index: usize,
    ) -> Option<Self> {
        let (before, rest) = models.split_at_checked(index)?;
        let model = rest.first()?;
        let first_vertex = before.iter().map(|model| model.mesh().vertices().len()).sum::<usize>();
        if is_left_out::<L>(vertices, first_vertex) {
            return None;
        }
        Some(Self {
            vertices: vertices.get(first_vertex..)?.get(..model.mesh().vertices().len())?,
            model,
            camera,
        })
    }

    /// An edge on the screen, if it is to be drawn.
    pub(super) fn edge(&self, index: usize, edge: &Edge) -> Option<ScreenEdge<L::Precision, L::Depth>> {
        let (kind, sides) = (edge.kind(), edge.faces().map(|face| self.side(face)));
        let [one, other] = sides;
        let any_is_seen = Self::is_seen(one) || Self::is_seen(other);
        let is_silhouette = match kind {
            EdgeKind::Boundary => any_is_seen,
            EdgeKind::Crease | EdgeKind::Smooth => (one > 0) != (other > 0),
        };
        let is_drawn = match kind {
            EdgeKind::Boundary | EdgeKind::Crease => any_is_seen,
            EdgeKind::Smooth => is_silhouette,
        };
        if !is_drawn {
            return None;
        }
        Some(ScreenEdge {
            index,
            ends: self.ends(edge.vertices())?,
            kind,
            is_silhouette,
        })
    }

    /// An edge on the screen, if no face at it is seen and one at least is turned away: where solids are closed, it is hidden. No
    /// smooth edge is one.
    pub(super) fn edge_turned_away(&self, index: usize, edge: &Edge) -> Option<ScreenEdge<L::Precision, L::Depth>> {
        let [one, other] = edge.faces().map(|face| self.side(face));
        let is_smooth = matches!(edge.kind(), EdgeKind::Smooth);
        if L::DRAWS_BACKS || is_smooth || one > 0 || other > 0 || one + other == 0 {
            return None;
        }
        Some(ScreenEdge {
            index,
            ends: self.ends(edge.vertices())?,
            kind: edge.kind(),
            is_silhouette: false,
        })
    }

    /// The mesh of the model.
    pub(super) fn mesh(&self) -> &FaceSet<'m> {
        self.model.mesh()
    }

    /// Whether a face is drawn that is seen from a [side](Self::side).
    pub(super) fn is_seen(side: i32) -> bool {
        side > 0 || L::DRAWS_BACKS && side < 0
    }

    /// From which side a face is seen: 1 from the front, -1 from behind, 0 on edge, or where there is no such face.
    pub(super) fn side(&self, face: u16) -> i32 {
        if face == FaceSet::NO_NEIGHBOUR {
            return 0;
        }
        let Some(face) = self.model.mesh().faces().get(usize::from(face)) else {
            return 0;
        };
        let face = outward::<L::Shading, _>(self.model.skin(), *face);
        let Some(corners) = corners(self.vertices, &face) else {
            return 0;
        };
        // Turned away for certain, and no corner is off the screen.
        if corners.into_iter().any(is_not_transformed::<L>) {
            return -1;
        }
        if L::CLIPS && corners.into_iter().any(is_outside) {
            return side_in_eye_space::<L>(self.camera, self.model, &face);
        }
        let [a, b, c] = corners.map(ScreenVertex::position);
        i32::from(is_front::<L::Precision>(a, b, c)) - i32::from(is_front::<L::Precision>(a, c, b))
    }

    /// The ends of an edge on the screen; `None` where nothing of it is left, or a vertex is not there.
    fn ends(&self, vertices: [u16; 2]) -> Option<[Corner<L::Precision, L::Depth>; 2]> {
        let [from, to] = vertices.map(|vertex| {
            let index = usize::from(vertex);
            let vertex = self.vertices.get(index)?;
            Some(transformed::<L>(vertex, index, self.model, self.camera))
        });
        let (from, to) = (&from?, &to?);
        if L::CLIPS && (is_outside(from) || is_outside(to)) {
            let [from, to] = cut_edge::<L>(self.camera, self.model, vertices)?;
            return Some([Corner::new(&from)?, Corner::new(&to)?]);
        }
        Some([Corner::new(from)?, Corner::new(to)?])
    }
}
