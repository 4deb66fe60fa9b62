//! An edge of a mesh, as it lies in flash.

use crate::mesh::neighbours::NO_NEIGHBOUR;

/// Whether the surface of a mesh ends at an edge, turns sharply there or hardly turns: where a mesh is drawn as lines, that
/// decides which edges are drawn.
///
/// Outlines are thick and creases thin, as in a technical drawing:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I2F14, I16F16};
/// use zrow::scene::{Camera, Edge, EdgeKind, FaceSet, Memory, Model};
///
/// /// A sheet that is folded towards the camera.
/// const VERTICES: [[i16; 3]; 4] = [[-512, -256, 1024], [0, 0, 800], [0, 512, 800], [512, -256, 1024]];
/// const FACES: [[u16; 3]; 2] = [[0, 2, 1], [1, 2, 3]];
/// static EDGES: [Edge; 5] = match FaceSet::find_edges(&VERTICES, &FACES, I2F14::lit("0.866")) {
///     Ok(edges) => edges,
///     Err(_) => panic!("a face names a vertex that is not there, or the table is too small"),
/// };
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let models = [Model::new(FaceSet::new(&VERTICES, &FACES)?, &[Rgb565::RED; 2])?];
/// let mut memory = Memory::<Rgb565, 4, 2, 64, 64>::new();
/// let scene = memory.prepare(&camera, &models)?;
/// let widths = scene.edges(0, &EDGES).map(|edge| match edge.kind {
///     EdgeKind::Boundary => 3,
///     EdgeKind::Smooth => 2,
///     EdgeKind::Crease => 1,
/// });
/// assert_eq!(widths.collect::<Vec<u32>>(), [3, 1, 3, 3, 3]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum EdgeKind {
    /// Only one face has the edge: the surface ends there.
    Boundary,
    /// The faces on both sides turn by more than an angle from one to the other, as at the edge of a box; or more than two
    /// faces meet in the edge.
    Crease,
    /// The faces on both sides turn by less, as on a ball: the edge is drawn only where it is a silhouette.
    Smooth,
}

/// An edge of a [`FaceSet`](crate::scene::FaceSet): two vertices, the faces on both sides, and its [`EdgeKind`]. 8 bytes.
///
/// [`FaceSet::find_edges`](crate::scene::FaceSet::find_edges) finds the edges of a mesh, the mesh converter writes them with
/// `--edges 30`, and [`Prepared::edges`](crate::scene::Prepared::edges) says where they are on the screen.
///
/// A table may hold any line that is drawn where faces are seen, such as the diagonal of a square, which is no edge of
/// the mesh because both of its faces lie in one plane:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I16F16, U0F16};
/// use zrow::scene::{Camera, Edge, FaceSet, Memory, Model, Pose, Rotation};
///
/// const VERTICES: [[i16; 3]; 4] = [[-512, -512, 0], [-512, 512, 0], [512, 512, 0], [512, -512, 0]];
/// static DIAGONAL: [Edge; 1] = [Edge::crease([0, 2], [0, 1])];
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mesh = FaceSet::new(&VERTICES, &[[0, 1, 2], [0, 2, 3]])?;
/// let mut memory = Memory::<Rgb565, 4, 2, 64, 64>::new();
/// for (turns, lines) in [(0.0, 1), (0.5, 0)] {
///     let rotation = Rotation::about_y(U0F16::from_num(turns));
///     let pose = Pose::new(rotation, [0, 0, 1024].map(I16F16::from_num::<i32>));
///     let models = [Model::new(mesh, &[Rgb565::RED; 2])?.with_pose(pose)];
///     assert_eq!(memory.prepare(&camera, &models)?.edges(0, &DIAGONAL).count(), lines);
/// }
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Edge {
    vertices: [u16; 2],
    /// The order says the kind: of a smooth edge ascending, of a crease descending or twice the same, and a boundary has
    /// [`NO_NEIGHBOUR`] as its second one.
    faces: [u16; 2],
}

impl Edge {
    /// An edge without faces, which is never drawn: it fills up a table that has room for more edges than a mesh has.
    pub(super) const NONE: Self = Self::boundary([0; 2], NO_NEIGHBOUR);

    /// An edge that only one face has, by the indices of its vertices and of the face.
    pub const fn boundary(vertices: [u16; 2], face: u16) -> Self {
        Self {
            vertices,
            faces: [face, NO_NEIGHBOUR],
        }
    }

    /// An edge at which two faces turn much: drawn where one of them is seen. By the indices of its vertices and faces;
    /// twice the same face where the crease has no other, as one of three that meet in it.
    pub const fn crease(vertices: [u16; 2], [one, other]: [u16; 2]) -> Self {
        let faces = if one < other { [other, one] } else { [one, other] };
        Self { vertices, faces }
    }

    /// An edge at which two different faces turn little: drawn where one of them is seen from the front and the other one
    /// from behind. By the indices of its vertices and faces.
    pub const fn smooth(vertices: [u16; 2], [one, other]: [u16; 2]) -> Self {
        let faces = if one < other { [one, other] } else { [other, one] };
        Self { vertices, faces }
    }

    /// The indices of its ends among the vertices of the mesh.
    pub const fn vertices(&self) -> [u16; 2] {
        self.vertices
    }

    /// The indices of the faces on both sides among those of the mesh, the lower one first; a boundary has
    /// [`FaceSet::NO_NEIGHBOUR`](crate::scene::FaceSet::NO_NEIGHBOUR) as its second.
    pub const fn faces(&self) -> [u16; 2] {
        let [one, other] = self.faces;
        if one < other { [one, other] } else { [other, one] }
    }

    /// Whether the edge is a boundary, a crease or smooth, which decides where it is drawn as a line.
    pub const fn kind(&self) -> EdgeKind {
        let [one, other] = self.faces;
        if other == NO_NEIGHBOUR {
            EdgeKind::Boundary
        } else if one < other {
            EdgeKind::Smooth
        } else {
            EdgeKind::Crease
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_has_what_it_was_made_of() {
        for faces in [[3, 8], [8, 3]] {
            let crease = Edge::crease([5, 2], faces);
            let smooth = Edge::smooth([5, 2], faces);
            assert_eq!((crease.kind(), smooth.kind()), (EdgeKind::Crease, EdgeKind::Smooth));
            for edge in [crease, smooth] {
                assert_eq!((edge.vertices(), edge.faces()), ([5, 2], [3, 8]));
            }
        }
        let edge = Edge::boundary([5, 2], 3);
        assert_eq!(
            (edge.vertices(), edge.faces(), edge.kind()),
            ([5, 2], [3, NO_NEIGHBOUR], EdgeKind::Boundary)
        );
        let edge = Edge::crease([5, 2], [3, 3]);
        assert_eq!((edge.faces(), edge.kind()), ([3, 3], EdgeKind::Crease));
        assert_eq!(size_of::<Edge>(), 8);
    }
}
