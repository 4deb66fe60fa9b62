//! The faces and edges of a prepared frame as the methods of hidden lines read them.

use core::ops::Range;

use crate::{
    mesh::EdgeKind,
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::line_part::PartKind,
};

/// A point on the screen: position in units of the precision, and stored depth in units, where nearer is larger.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinePoint {
    /// Column, in units of the precision; grows to the right. The smallest and the largest one are less than 2^22 apart.
    pub x: i32,
    /// Row, in units of the precision; grows downwards.
    pub y: i32,
    /// Stored depth, below 2^24: nearer is larger.
    pub depth: i32,
}

/// A face on the screen, or a fragment of one that was cut.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LineFace {
    /// Index in the table: whole faces have their index in the order of models and faces, fragments follow.
    pub index: usize,
    /// Index of the face's model among the models.
    pub model: usize,
    /// Index of the face in its mesh.
    pub face: usize,
    /// The corners: clockwise on the screen where the face is seen from the front. Those of a fragment are always clockwise.
    pub corners: [LinePoint; 3],
    /// Whether the face is seen from the front.
    pub is_front: bool,
    /// Whether the face is drawn, and so may hide something: from the front, or from either side in looks that draw backs.
    pub is_seen: bool,
}

/// An edge on the screen that is to be drawn.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LineEdge {
    /// Index of the edge's model among the models.
    pub model: usize,
    /// Index of the edge in the table of edges of its model.
    pub edge: usize,
    /// The vertices of the edge, by their indices in the mesh.
    pub vertices: [u16; 2],
    /// The faces beside it, by their indices in the mesh, the lower one first; the second one of a boundary is
    /// [`FaceSet::NO_NEIGHBOUR`](crate::scene::FaceSet::NO_NEIGHBOUR).
    pub faces: [u16; 2],
    /// The ends, in the order of the vertices, as they were snapped, or as the edge was cut.
    pub ends: [LinePoint; 2],
    /// Whether the edge is a boundary, a crease or smooth; a smooth edge that is drawn is a silhouette.
    pub kind: EdgeKind,
    /// Whether the surface ends at the edge as it is seen: a boundary, or an edge of whose faces one is seen from the front.
    pub is_silhouette: bool,
}

impl LineEdge {
    /// What kind of line the edge is in a drawing.
    pub(super) const fn part_kind(&self) -> PartKind {
        match (self.kind, self.is_silhouette) {
            (EdgeKind::Boundary, _) => PartKind::Boundary,
            (EdgeKind::Crease, false) => PartKind::Crease,
            (EdgeKind::Crease, true) | (EdgeKind::Smooth, _) => PartKind::Silhouette,
        }
    }
}

// Not re-exported.
/// The faces and edges of a prepared frame, over all its models.
pub trait LineTable<S: ScreenPrecision, D: DepthWidth> {
    /// How many models there are.
    fn models(&self) -> usize;
    /// The indices in the table of the faces of a model, as far as they were not cut; empty where there is no such model.
    fn faces_of_model(&self, model: usize) -> Range<usize>;
    /// One more than the greatest index of a face or a fragment, at most 65,535: with so many slots a method has room for all.
    fn face_indices(&self) -> usize;
    /// The face or the fragment with an index; `None` where a face was cut, is off the screen or belongs to a model that was left
    /// out.
    fn face(&self, index: usize) -> Option<LineFace>;
    /// All faces and fragments on the screen, whether they are drawn or not, by their indices. Of faces that were cut, only the
    /// fragments that are drawn in the viewport.
    fn faces(&self) -> impl Iterator<Item = LineFace> {
        (0..self.face_indices()).filter_map(|index| self.face(index))
    }
    /// The edges that are to be drawn, in the order of models and their tables of edges.
    fn edges(&self) -> impl Iterator<Item = LineEdge>;
}
