//! Triangles that share vertices.

use fixed::types::{I2F14, U1F15};

use crate::{
    geometry::{InputError, TooSmall},
    mesh::{BoundingBox, Edge, convex, edges, neighbours, polygons},
};

/// Vertices, and faces that name three of them each.
///
/// The unit of the vertices is the model's choice; poses and cameras use the same. A face is seen from the side from
/// which its vertices run clockwise on the screen: with x to the right, y up and z away from the viewer,
/// cross(b - a, c - a) points outwards.
///
/// ```
/// use zrow::scene::FaceSet;
///
/// static TETRAHEDRON: FaceSet = match FaceSet::new(
///     &[[0, 0, 0], [512, 0, 0], [0, 512, 0], [0, 0, 512]],
///     &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
/// ) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// assert_eq!(TETRAHEDRON.faces().len(), 4);
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FaceSet<'a> {
    vertices: &'a [[i16; 3]],
    faces: &'a [[u16; 3]],
    neighbours: &'a [[u16; 3]],
}

impl<'a> FaceSet<'a> {
    /// A face set whose vertex indices are all checked here, once; in a `static`, by the compiler.
    ///
    /// # Errors
    /// [`InputError::IndexOutOfRange`] with the first face that names a vertex that is not there.
    pub const fn new(vertices: &'a [[i16; 3]], faces: &'a [[u16; 3]]) -> Result<Self, InputError> {
        let mut rest = faces;
        while let [corners, later @ ..] = rest {
            let [one, two, three] = *corners;
            let largest = larger(one, larger(two, three));
            if largest as usize >= vertices.len() {
                return Err(InputError::IndexOutOfRange {
                    face: faces.len() - rest.len(),
                    vertex: largest,
                });
            }
            rest = later;
        }
        Ok(Self {
            vertices,
            faces,
            neighbours: &[],
        })
    }

    /// The triangles of convex polygons, each a list of vertices: of a polygon of `n` corners the `n - 2` that its first corner
    /// has with two others that follow each other, one polygon after the other. As with triangles, a polygon is seen from the
    /// side from which its corners run clockwise on the screen.
    ///
    /// The corners of a polygon must lie within half a unit of one plane, which is across its Newell normal (in Sutherland,
    /// Sproull and Schumacker 1974), and turn there, all the same way; that is checked exactly. The mesh converter cuts concave
    /// polygons, too. Diagonals of a polygon that is exactly planar are no [edges](Self::find_edges); those of others are
    /// smooth edges, which are silhouettes only where the polygon is seen almost on edge.
    ///
    /// In a `static` the compiler does it. Cost: three cross products and three dot products a corner.
    ///
    /// ```
    /// use zrow::scene::FaceSet;
    ///
    /// /// A pyramid on a square.
    /// const VERTICES: [[i16; 3]; 5] = [[-9, 0, -9], [-9, 0, 9], [9, 0, 9], [9, 0, -9], [0, 9, 0]];
    /// const POLYGONS: [&[u16]; 5] = [&[3, 2, 1, 0], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];
    /// const FACES: [[u16; 3]; FaceSet::count_triangles(&POLYGONS)] = match FaceSet::triangulate(&VERTICES, &POLYGONS) {
    ///     Ok(faces) => faces,
    ///     Err(_) => panic!("a polygon is not planar, not convex, or names a vertex that is not there"),
    /// };
    /// assert_eq!(FACES[..3], [[3, 2, 1], [3, 1, 0], [0, 1, 4]]);
    /// // Eight edges, without the diagonal of the square.
    /// assert_eq!(FaceSet::count_edges(&VERTICES, &FACES), 8);
    /// ```
    ///
    /// # Errors
    /// For the first polygon that is wrong: [`InputError::IndexOutOfRange`], whose `face` is the polygon;
    /// [`InputError::NotPlanar`]; [`InputError::NotConvex`], also of a polygon that has fewer than three corners, or one that
    /// is repeated or straight. [`InputError::NumberOfFaces`] with the number of triangles, where that is not `FACES`.
    pub const fn triangulate<const FACES: usize>(
        vertices: &[[i16; 3]],
        polygons: &[&[u16]],
    ) -> Result<[[u16; 3]; FACES], InputError> {
        polygons::triangulate(vertices, polygons)
    }

    /// How many triangles [`triangulate`](Self::triangulate) cuts polygons into: of each two fewer than it has corners.
    pub const fn count_triangles(polygons: &[&[u16]]) -> usize {
        polygons::count(polygons)
    }

    /// The face set with the neighbours of each face: the index of the face on the other side of the edge from its first to its
    /// second vertex, of that from the second to the third, and of that from the third to the first;
    /// [`NO_NEIGHBOUR`](Self::NO_NEIGHBOUR) where there is none. Faces for which there are no three of them have none.
    ///
    /// They tell which edges are silhouettes ([`Antialiased`](crate::scene::Antialiased)). The mesh converter writes them, and
    /// [`find_neighbours`](Self::find_neighbours) finds them.
    #[must_use]
    pub const fn with_neighbours(self, neighbours: &'a [[u16; 3]]) -> Self {
        Self { neighbours, ..self }
    }

    /// In a table of neighbours: no face is on the other side of an edge.
    pub const NO_NEIGHBOUR: u16 = neighbours::NO_NEIGHBOUR;

    /// The neighbours of `FACES` faces: those that have the same two vertices the other way round. Where more than two faces
    /// meet in an edge, and on the other side of the edges of a hole, there is none. Faces after the first 65,535 have no number:
    /// they are nobody's neighbours.
    ///
    /// In a `static` the compiler finds them; a mesh of a thousand faces takes it a second. Cost: a few steps for each edge,
    /// and 16 bytes of stack a face.
    ///
    /// ```
    /// use zrow::scene::FaceSet;
    ///
    /// const FACES: [[u16; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    /// static NEIGHBOURS: [[u16; 3]; 4] = FaceSet::find_neighbours(&FACES);
    /// static TETRAHEDRON: FaceSet =
    ///     match FaceSet::new(&[[0, 0, 0], [512, 0, 0], [0, 512, 0], [0, 0, 512]], &FACES) {
    ///         Ok(faces) => faces.with_neighbours(&NEIGHBOURS),
    ///         Err(_) => panic!("a face names a vertex that is not there"),
    ///     };
    /// assert_eq!(TETRAHEDRON.neighbours()[0], [2, 3, 1]);
    /// ```
    pub const fn find_neighbours<const FACES: usize>(faces: &[[u16; 3]; FACES]) -> [[u16; 3]; FACES] {
        neighbours::find(faces)
    }

    /// The neighbours of each face, as far as they are known ([`with_neighbours`](Self::with_neighbours)).
    pub const fn neighbours(&self) -> &'a [[u16; 3]] {
        self.neighbours
    }

    /// The edges of a mesh, to draw it as lines ([`Prepared::edges`](crate::scene::Prepared::edges)): each with the faces on
    /// both sides and its [`EdgeKind`](crate::scene::EdgeKind). It is a crease where its faces turn so much from one to the
    /// other that the cosine of the angle is less than `cosine`, a number with 14 fractional bits from -1 to 1: 0.866 for 30
    /// degrees. With 1 or more, each edge between two faces is a crease; with -1 or less, none is. The angles are compared
    /// exactly.
    ///
    /// An edge between faces that lie in one plane, as inside a polygon that was cut into triangles, is none. Where more than
    /// two faces meet, a crease is there once for every two of them. Vertices in the same position count as one; faces
    /// without an area, and all faces after the first 65,535, are not looked at.
    ///
    /// The edges are in the order of the faces that have them. [`count_edges`](Self::count_edges) says how many there are; what
    /// is left in a longer table are edges without a face, which are never drawn.
    ///
    /// In a `static` the compiler finds them; a mesh of a thousand faces takes it a second, and from some 2,000 faces on it
    /// asks for `#[allow(long_running_const_eval)]`, or for the table that the mesh converter writes. Cost: a few steps for
    /// each edge, and 48 bytes of stack a face beside the table.
    ///
    /// ```
    /// use zrow::fixed::types::I2F14;
    /// use zrow::scene::{Edge, EdgeKind, FaceSet};
    ///
    /// /// A square of two triangles, and one triangle that stands on its upper side.
    /// const VERTICES: [[i16; 3]; 5] = [[0, 0, 0], [0, 9, 0], [9, 9, 0], [9, 0, 0], [5, 9, -9]];
    /// const FACES: [[u16; 3]; 3] = [[0, 1, 2], [0, 2, 3], [2, 1, 4]];
    /// static EDGES: [Edge; FaceSet::count_edges(&VERTICES, &FACES)] =
    ///     match FaceSet::find_edges(&VERTICES, &FACES, I2F14::lit("0.866")) {
    ///         Ok(edges) => edges,
    ///         Err(_) => panic!("a face names a vertex that is not there, or the table is too small"),
    ///     };
    /// // Without the diagonal.
    /// assert_eq!(EDGES.map(|edge| edge.vertices()), [[0, 1], [1, 2], [2, 3], [3, 0], [1, 4], [4, 2]]);
    /// assert_eq!(EDGES[0], Edge::boundary([0, 1], 0));
    /// assert_eq!((EDGES[1].kind(), EDGES[1].faces()), (EdgeKind::Crease, [0, 2]));
    /// ```
    ///
    /// # Errors
    /// [`InputError::IndexOutOfRange`] as [`new`](Self::new) has it; [`TooSmall::Edges`] with the number of edges.
    pub const fn find_edges<const FACES: usize, const EDGES: usize>(
        vertices: &[[i16; 3]],
        faces: &[[u16; 3]; FACES],
        cosine: I2F14,
    ) -> Result<[Edge; EDGES], InputError> {
        if let Err(error) = FaceSet::new(vertices, faces) {
            return Err(error);
        }
        let (edges, count) = edges::find(vertices, faces, cosine);
        if count > EDGES {
            return Err(InputError::TooSmall(TooSmall::Edges(count)));
        }
        Ok(edges)
    }

    /// How many edges a mesh has, whatever counts as a crease: the length of the table that
    /// [`find_edges`](Self::find_edges) returns. A vertex that is not there counts as one at the origin.
    ///
    /// Cost: as that of `find_edges`.
    pub const fn count_edges<const FACES: usize>(vertices: &[[i16; 3]], faces: &[[u16; 3]; FACES]) -> usize {
        edges::find::<FACES, 0>(vertices, faces, I2F14::ZERO).1
    }

    /// The mesh with its vertices a part of the way to those of another pose of it, as in key-frame animation (morphing): to a
    /// stride, a smile, an open wing. The vertices are written to `into`, and faces are not checked once more.
    ///
    /// Each coordinate is the exact one, rounded once to the nearest unit, halves up: at part 0 those of this mesh, at part 1
    /// those of the other pose; a greater part counts as 1. Vertices after the number of this mesh are not used. Normals,
    /// colours and texture coordinates stay those of the model's skin.
    ///
    /// Cost: three multiplications a vertex.
    ///
    /// ```
    /// use zrow::fixed::types::U1F15;
    /// use zrow::{geometry::TooSmall, scene::FaceSet};
    ///
    /// const DOWN: FaceSet = match FaceSet::new(&[[0, 0, 0], [0, 100, 0], [400, 0, -7]], &[[0, 1, 2]]) {
    ///     Ok(faces) => faces,
    ///     Err(_) => panic!("a face names a vertex that is not there"),
    /// };
    /// /// The same wing, lifted.
    /// const UP: [[i16; 3]; 3] = [[0, 0, 0], [0, 100, 0], [380, 200, -8]];
    ///
    /// let mut vertices = [[0; 3]; 3];
    /// let wing = DOWN.morphed(&UP, U1F15::from_num(0.5), &mut vertices)?;
    /// assert_eq!(wing.vertices(), [[0, 0, 0], [0, 100, 0], [390, 100, -7]]);
    /// assert_eq!(DOWN.morphed(&UP, U1F15::ONE, &mut vertices)?.vertices(), UP);
    /// # Ok::<(), TooSmall>(())
    /// ```
    ///
    /// # Errors
    /// [`TooSmall::Vertices`] with the number of vertices of this mesh, where `to` or `into` have fewer.
    pub fn morphed<'v>(&self, to: &[[i16; 3]], part: U1F15, into: &'v mut [[i16; 3]]) -> Result<FaceSet<'v>, TooSmall>
    where
        'a: 'v,
    {
        let count = self.vertices.len();
        let (Some(to), Some(into)) = (to.get(..count), into.get_mut(..count)) else {
            return Err(TooSmall::Vertices(count));
        };
        let part = i32::from(part.min(U1F15::ONE).to_bits());
        let ends = self.vertices.as_flattened().iter().zip(to.as_flattened());
        for (coordinate, (from, to)) in into.as_flattened_mut().iter_mut().zip(ends) {
            let (from, to) = (i32::from(*from), i32::from(*to));
            // At most 65,535 times 2^15, and a half more: below 2^31.
            *coordinate = (from + (((to - from) * part + (1 << 14)) >> 15)) as i16;
        }
        Ok(FaceSet {
            vertices: into,
            faces: self.faces,
            neighbours: self.neighbours,
        })
    }

    /// The sum of the numbers of vertices of several face sets: the capacity `VERTICES` of a [`Memory`](crate::scene::Memory)
    /// for models of them, where no face is cut. A mesh that two models share counts twice.
    pub const fn vertices_of(sets: &[FaceSet<'_>]) -> usize {
        let (mut sum, mut rest) = (0usize, sets);
        while let [set, others @ ..] = rest {
            sum = sum.saturating_add(set.vertices.len());
            rest = others;
        }
        sum
    }

    /// The sum of the numbers of faces of several face sets: the capacity `FACES` of a [`Memory`](crate::scene::Memory) for
    /// models of them. A mesh that two models share counts twice.
    pub const fn faces_of(sets: &[FaceSet<'_>]) -> usize {
        let (mut sum, mut rest) = (0usize, sets);
        while let [set, others @ ..] = rest {
            sum = sum.saturating_add(set.faces.len());
            rest = others;
        }
        sum
    }

    /// The vertices: x, y, z.
    pub const fn vertices(&self) -> &'a [[i16; 3]] {
        self.vertices
    }

    /// The smallest box around the vertices, for models that are left out where nothing of them is seen
    /// ([`Bounded`](crate::shade::Bounded)). Best in a `const`. Cost: six comparisons a vertex.
    pub const fn bounds(&self) -> BoundingBox {
        BoundingBox::around(self.vertices)
    }

    /// Whether the mesh is convex: no vertex is in front of the plane of a face, exactly. Then an edge of it is hidden by the mesh
    /// itself only where both faces beside it are seen from behind, and solids are told apart by planes
    /// ([`Roberts`](crate::visible::Roberts)). Whether the mesh is closed is not asked; faces without an area have no plane.
    ///
    /// Best in a `const`. Cost: a dot product for each face and vertex.
    ///
    /// ```
    /// use zrow::scene::FaceSet;
    ///
    /// const VERTICES: [[i16; 3]; 5] = [[0, 0, 0], [512, 0, 0], [0, 512, 0], [0, 0, 512], [400, 400, 400]];
    /// const FACES: [[u16; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    ///
    /// let (tetrahedron, _) = VERTICES.split_at(4);
    /// assert!(FaceSet::new(tetrahedron, &FACES)?.is_convex());
    /// // With a vertex outside.
    /// assert!(!FaceSet::new(&VERTICES, &FACES)?.is_convex());
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub const fn is_convex(&self) -> bool {
        convex::is_convex(self.vertices, self.faces)
    }

    /// The faces: three indices of the vertices.
    pub const fn faces(&self) -> &'a [[u16; 3]] {
        self.faces
    }
}

const fn larger(one: u16, other: u16) -> u16 {
    if one > other { one } else { other }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VERTICES: [[i16; 3]; 4] = [[0; 3]; 4];

    #[test]
    fn sums_are_those_of_all_sets() {
        let one = FaceSet::new(&VERTICES, &[[0, 3, 1]]).unwrap();
        let other = FaceSet::new(&VERTICES[..2], &[[0, 1, 1]; 3]).unwrap();
        let empty = FaceSet::new(&[], &[]).unwrap();
        for (sets, sums) in [
            (&[][..], [0, 0]),
            (&[one, empty, other], [6, 4]),
            (&[other, other], [4, 6]),
        ] {
            assert_eq!([FaceSet::vertices_of(sets), FaceSet::faces_of(sets)], sums);
        }
    }

    #[test]
    fn a_face_may_name_the_last_vertex_and_none_after_it() {
        assert!(FaceSet::new(&VERTICES, &[[0, 3, 1], [3, 3, 3]]).is_ok());
        for corners in [[4, 0, 1], [0, 4, 1], [0, 1, 4]] {
            assert_eq!(
                FaceSet::new(&VERTICES, &[[0, 3, 1], corners, [9, 9, 9]]),
                Err(InputError::IndexOutOfRange { face: 1, vertex: 4 })
            );
        }
        assert!(FaceSet::new(&[], &[]).is_ok());
    }
}
