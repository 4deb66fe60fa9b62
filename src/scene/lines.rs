//! The faces and edges of a prepared frame as methods of hidden lines read them. Linked only where one is called.

use core::ops::Range;

use crate::{
    mesh::{Edge, EdgeKind},
    scene::{
        Look, Model,
        clipping::side_in_eye_space,
        culling::is_left_out,
        edges::{self, ModelOnScreen},
        faces::{Corner, corners_of, find},
        frame::FRAGMENT_VERTICES,
        lens::ScreenVertexOf,
        model::outward,
        off_screen::is_outside,
        preparation::is_front,
    },
    view::{Camera, DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{LineEdge, LineFace, LinePart, LinePoint, LineTable, PartKind},
};

/// What is read of a prepared frame, and the tables of edges of its models.
pub(super) struct Lines<'t, 'm, L: Look> {
    /// The vertices of the models, and the fragments.
    pub(super) vertices: &'t [ScreenVertexOf<L>],
    pub(super) models: &'t [Model<'m, L::Shading>],
    pub(super) camera: &'t Camera,
    /// Where the fragments of cut faces are among the vertices.
    pub(super) fragments: Range<usize>,
    /// The table of edges of each model.
    pub(super) edges: &'t [&'t [Edge]],
}

impl<'m, L: Look> Lines<'_, 'm, L> {
    fn whole_faces(&self) -> usize {
        self.models.iter().map(|model| model.mesh().faces().len()).sum()
    }

    fn whole_face(&self, index: usize) -> Option<LineFace> {
        let (_, first_vertex, face) = find(self.models, index as u16)?;
        let (number, model) = self.model_of(index)?;
        if is_left_out::<L>(self.vertices, first_vertex) {
            return None;
        }
        let corners = corners_of::<L>(self.vertices.get(first_vertex..)?, model, self.camera, face)?;
        let corners = outward::<L::Shading, _>(model.skin(), corners.each_ref());
        if L::CLIPS && corners.into_iter().any(is_outside) {
            return None;
        }
        let [a, b, c] = corners.map(ScreenVertex::position);
        let is_front_face = is_front::<L::Precision>(a, b, c);
        Some(LineFace {
            index,
            model: number,
            face,
            corners: corners.map(point_of),
            is_front: is_front_face,
            is_seen: is_front_face || (L::DRAWS_BACKS && is_front::<L::Precision>(a, c, b)),
        })
    }

    fn fragment(&self, index: usize) -> Option<LineFace> {
        let first = index.checked_sub(self.whole_faces())?.checked_mul(FRAGMENT_VERTICES)?;
        let fragments = self.vertices.get(self.fragments.clone())?;
        let [header, a, b, c] = fragments.get(first..)?.first_chunk::<FRAGMENT_VERTICES>()?;
        let order = header.x_units() as u16;
        let (_, _, face) = find(self.models, order)?;
        let (number, model) = self.model_of(usize::from(order))?;
        let is_front = !L::DRAWS_BACKS || {
            let corners = outward::<L::Shading, _>(model.skin(), *model.mesh().faces().get(face)?);
            side_in_eye_space::<L>(self.camera, model, &corners) > 0
        };
        Some(LineFace {
            index,
            model: number,
            face,
            corners: [a, b, c].map(point_of),
            is_front,
            is_seen: true,
        })
    }

    /// Hands over the edges at which all faces are turned away, each as one hidden part.
    pub(super) fn hand_over_turned_away(&self, part: &mut impl FnMut(LinePart<L::Precision>)) {
        for (model, table) in self.edges.iter().enumerate() {
            let on_screen = ModelOnScreen::<L>::new(self.vertices, self.models, self.camera, model);
            let edges = on_screen.into_iter().flat_map(|model| {
                let edges = table.iter().enumerate();
                edges.filter_map(move |(index, edge)| model.edge_turned_away(index, edge))
            });
            for edge in edges {
                let [from, to] = edge.ends.map(|end| end.point);
                if from == to {
                    continue;
                }
                part(LinePart {
                    model,
                    edge: Some(edge.index),
                    ends: [from, to],
                    kind: match edge.kind {
                        EdgeKind::Boundary => PartKind::Boundary,
                        EdgeKind::Crease | EdgeKind::Smooth => PartKind::Crease,
                    },
                    is_hidden: true,
                });
            }
        }
    }

    /// The model of a face by its index in the order of models and faces, with its own index.
    fn model_of(&self, face: usize) -> Option<(usize, &Model<'m, L::Shading>)> {
        let mut end = 0;
        self.models.iter().enumerate().find(|(_, model)| {
            end += model.mesh().faces().len();
            face < end
        })
    }
}

impl<L: Look> LineTable<L::Precision, L::Depth> for Lines<'_, '_, L> {
    fn models(&self) -> usize {
        self.models.len()
    }

    fn faces_of_model(&self, model: usize) -> Range<usize> {
        let Some((before, [model, ..])) = self.models.split_at_checked(model) else {
            return 0..0;
        };
        let first = before.iter().map(|model| model.mesh().faces().len()).sum();
        first..first + model.mesh().faces().len()
    }

    fn face_indices(&self) -> usize {
        self.whole_faces() + self.fragments.len() / FRAGMENT_VERTICES
    }

    fn face(&self, index: usize) -> Option<LineFace> {
        if index < self.whole_faces() {
            self.whole_face(index)
        } else {
            self.fragment(index)
        }
    }

    fn edges(&self) -> impl Iterator<Item = LineEdge> {
        self.edges.iter().enumerate().flat_map(move |(model, table)| {
            let on_screen = edges::edges::<L>(self.vertices, self.models, self.camera, model, table);
            on_screen.filter_map(move |edge| {
                let in_mesh = table.get(edge.index)?;
                Some(LineEdge {
                    model,
                    edge: edge.index,
                    vertices: in_mesh.vertices(),
                    faces: in_mesh.faces(),
                    ends: edge.ends.map(point_of_corner),
                    kind: edge.kind,
                    is_silhouette: edge.is_silhouette,
                })
            })
        })
    }
}

fn point_of<S: ScreenPrecision, D: DepthWidth>(vertex: &ScreenVertex<S, D>) -> LinePoint {
    LinePoint {
        x: vertex.x_units(),
        y: vertex.y_units(),
        depth: vertex.z.units(),
    }
}

fn point_of_corner<S: ScreenPrecision, D: DepthWidth>(corner: Corner<S, D>) -> LinePoint {
    LinePoint {
        x: corner.point.x_units(),
        y: corner.point.y_units(),
        depth: corner.depth.units(),
    }
}
