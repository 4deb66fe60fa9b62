//! Coarser meshes by edge collapses, the one with the least quadric error first (Garland and Heckbert, "Surface Simplification
//! Using Quadric Error Metrics", 1997).
//!
//! A collapse moves a point along an edge onto the other end, and the two faces at the edge vanish:
//!
//! ```text
//!        x                   x
//!       / \                  |
//!   ---u---v---     ->    ---v---      the faces u v x and v u y are gone
//!       \ /                  |
//!        y                   y
//! ```
//!
//! No point is new, so each keeps texture coordinates, normals and colours of the finest mesh. A point where those differ
//! between its faces lies on a seam, and moves along the seam alone: every vertex at `u` becomes the vertex at `v` of a face
//! that vanishes. A point of an open border moves along the border. What is closed stays closed: edges collapse only where the
//! neighbours of both ends are the third points of the faces that vanish (the link condition of Dey, Edelsbrunner, Guha and
//! Nekhayev, "Topology preserving edge contraction", 1999). A face that would turn by more than about 70 degrees, by more than
//! 84 in all, lose its area or become a sliver holds a collapse back.

use std::{
    cmp::Ordering,
    collections::{BinaryHeap, HashMap},
};

use crate::{
    quadric::Quadric,
    vector::{Vector, cross, difference, dot, length, scaled, unit},
};

/// The cosine of the greatest angle by which a collapse turns a face.
const LEAST_COSINE: f64 = 0.35;
/// The same for all collapses together, against the face of the finest mesh: small turns add up.
const LEAST_COSINE_IN_ALL: f64 = 0.1;
/// The least area of a face by the sum of its squared sides, where 1 is an equilateral one: the side of a sliver is chance.
const LEAST_COMPACTNESS: f64 = 0.05;
/// Faces around both ends of an edge at most, so that no collapse takes long.
const MOST_AROUND: usize = 256;
/// The weight of planes upright on borders and seams, where that of a face's plane is 1: they keep their shape.
const BORDER_WEIGHT: f64 = 4.0;

/// What tells faces around a point apart: a vertex, and the colour of a face.
type Side = (u16, [u8; 3]);

/// A mesh that becomes coarser.
pub struct Simplifier {
    /// Positions, each once.
    points: Vec<[i16; 3]>,
    /// The point of each vertex.
    point_of: Vec<usize>,
    /// The vertices of faces; `None` for those that are gone.
    faces: Vec<Option<[u16; 3]>>,
    colors: Vec<[u8; 3]>,
    /// The directions out of the faces of the finest mesh; of one without an area, 0.
    normals: Vec<Vector>,
    /// The faces around each point.
    around: Vec<Vec<usize>>,
    quadrics: Vec<Quadric>,
    /// How the faces around each point hang together, where that is known.
    fans: Vec<Option<Fan>>,
    /// How often the surroundings of a point changed.
    changes: Vec<u32>,
    candidates: BinaryHeap<Candidate>,
    left: usize,
}

/// How the faces around a point hang together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fan {
    /// One beside the other, all the way round.
    Closed,
    /// One beside the other, from border to border.
    Border,
    /// Otherwise: such a point stays where it is.
    Tangled,
}

/// An edge that may collapse.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Candidate {
    error: f64,
    length: f64,
    from: usize,
    to: usize,
    /// Those of both points when the error was computed.
    changes: [u32; 2],
}

impl Eq for Candidate {}

impl Ord for Candidate {
    /// The greatest is the one to collapse first: the least error, of equal ones the shortest edge.
    fn cmp(&self, other: &Self) -> Ordering {
        let by_error = other.error.total_cmp(&self.error);
        by_error
            .then(other.length.total_cmp(&self.length))
            .then((other.from, other.to).cmp(&(self.from, self.to)))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Simplifier {
    /// Takes over a mesh: positions of its vertices, its faces, and their colours.
    pub fn new(vertices: &[[i16; 3]], faces: &[[u16; 3]], colors: &[[u8; 3]]) -> Self {
        let mut points = Vec::new();
        let mut known = HashMap::new();
        let point_of: Vec<usize> = vertices
            .iter()
            .map(|&position| {
                *known.entry(position).or_insert_with(|| {
                    points.push(position);
                    points.len() - 1
                })
            })
            .collect();
        let mut around = vec![Vec::new(); points.len()];
        for (index, face) in faces.iter().enumerate() {
            for vertex in face {
                let faces: &mut Vec<usize> = &mut around[point_of[usize::from(*vertex)]];
                // Once, also of a face with a point twice.
                if faces.last() != Some(&index) {
                    faces.push(index);
                }
            }
        }
        let mut simplifier = Self {
            quadrics: vec![Quadric::default(); points.len()],
            changes: vec![0; points.len()],
            fans: vec![None; points.len()],
            points,
            point_of,
            faces: faces.iter().copied().map(Some).collect(),
            colors: colors.to_vec(),
            normals: vec![[0.0; 3]; faces.len()],
            around,
            candidates: BinaryHeap::new(),
            left: faces.len(),
        };
        simplifier.add_quadrics();
        for point in 0..simplifier.points.len() {
            for neighbor in simplifier.neighbors(point) {
                simplifier.push(point, neighbor);
            }
        }
        simplifier
    }

    /// Collapses edges until so many faces are left, or none can.
    pub fn reduce(&mut self, faces: usize) {
        while self.left > faces {
            let Some(candidate) = self.candidates.pop() else { return };
            let Candidate { from, to, changes, .. } = candidate;
            if changes == [self.changes[from], self.changes[to]]
                && let Some(moved) = self.moved(from, to)
            {
                self.collapse(from, to, &moved);
            }
        }
    }

    /// The faces that are left, with their indices.
    pub fn faces(&self) -> impl Iterator<Item = (usize, [u16; 3])> + '_ {
        let faces = self.faces.iter().enumerate();
        faces.filter_map(|(index, face)| face.map(|face| (index, face)))
    }

    fn position(&self, point: usize) -> Vector {
        self.points[point].map(f64::from)
    }

    /// The points of a face that is left.
    fn points_of(&self, face: usize) -> [usize; 3] {
        let vertices = self.faces[face].unwrap_or_default();
        vertices.map(|vertex| self.point_of[usize::from(vertex)])
    }

    /// The vertex of a face at a point, and its colour.
    fn side(&self, face: usize, point: usize) -> Option<Side> {
        let vertices = self.faces[face]?;
        let vertex = vertices
            .into_iter()
            .find(|&vertex| self.point_of[usize::from(vertex)] == point)?;
        Some((vertex, self.colors[face]))
    }

    /// The points that share a face with one, in order.
    fn neighbors(&self, point: usize) -> Vec<usize> {
        let faces = self.around[point].iter();
        let mut neighbors: Vec<_> = faces
            .flat_map(|&face| self.points_of(face))
            .filter(|&other| other != point)
            .collect();
        neighbors.sort_unstable();
        neighbors.dedup();
        neighbors
    }

    /// The faces at the edge between two points.
    fn at_edge(&self, one: usize, other: usize) -> Vec<usize> {
        // Out of those around the point that has fewer.
        let [few, many] = if self.around[one].len() <= self.around[other].len() {
            [one, other]
        } else {
            [other, one]
        };
        let faces = self.around[few].iter().copied();
        faces.filter(|&face| self.points_of(face).contains(&many)).collect()
    }

    /// How the faces around a point hang together.
    fn fan(&mut self, point: usize) -> Fan {
        if let Some(fan) = self.fans[point] {
            return fan;
        }
        let fan = self.walk_around(point);
        self.fans[point] = Some(fan);
        fan
    }

    fn walk_around(&self, point: usize) -> Fan {
        let faces = &self.around[point];
        let others = |face: usize| self.points_of(face).into_iter().filter(move |&other| other != point);
        let mut spokes: Vec<(usize, usize)> = faces
            .iter()
            .flat_map(|&face| others(face).map(move |other| (other, face)))
            .collect();
        spokes.sort_unstable();
        // Each neighbour is in two faces, or in one at a border.
        let mut ends = Vec::new();
        for spoke in spokes.chunk_by(|one, other| one.0 == other.0) {
            match spoke {
                [(end, _)] => ends.push(*end),
                [_, _] => {}
                _ => return Fan::Tangled,
            }
        }
        let Some(&(first, _)) = spokes.first() else {
            return Fan::Tangled;
        };
        let (fan, start) = match ends[..] {
            [] => (Fan::Closed, first),
            [end, _] => (Fan::Border, end),
            _ => return Fan::Tangled,
        };
        // From face to face over the neighbours between them: all are reached if there is one fan.
        let (mut here, mut last, mut reached) = (start, None, 0);
        while reached < faces.len() {
            let from = spokes.partition_point(|&(other, _)| other < here);
            let beside = spokes[from..].iter().take_while(|&&(other, _)| other == here);
            let Some(&(_, face)) = beside.into_iter().find(|&&(_, face)| Some(face) != last) else {
                break;
            };
            let Some(next) = others(face).find(|&other| other != here) else {
                break;
            };
            (here, last) = (next, Some(face));
            reached += 1;
            if here == start {
                break;
            }
        }
        if reached == faces.len() { fan } else { Fan::Tangled }
    }

    /// The faces that a collapse changes, as they are then; or `None` where it would tear a seam or a border, close a hole,
    /// double a face, or turn one over.
    fn moved(&mut self, from: usize, to: usize) -> Option<Vec<(usize, [u16; 3])>> {
        if self.around[from].len() + self.around[to].len() > MOST_AROUND {
            return None;
        }
        let gone = self.at_edge(from, to);
        let is_closed = match gone.len() {
            1 => false,
            2 => true,
            _ => return None,
        };
        match (self.fan(from), self.fan(to)) {
            (Fan::Tangled, _) | (_, Fan::Tangled) => return None,
            (Fan::Border, _) if is_closed => return None,
            _ => {}
        }
        let third = |face: &usize| {
            self.points_of(*face)
                .into_iter()
                .find(|&point| point != from && point != to)
        };
        let mut thirds: Vec<usize> = gone.iter().filter_map(third).collect();
        thirds.sort_unstable();
        let mut shared = self.neighbors(from);
        let of_other = self.neighbors(to);
        shared.retain(|point| of_other.binary_search(point).is_ok());
        if shared != thirds {
            return None;
        }
        let mut sides: HashMap<Side, u16> = HashMap::new();
        for &face in &gone {
            let (there, _) = self.side(face, to)?;
            // At a seam between both faces that ends in the point, its one vertex would become two.
            if *sides.entry(self.side(face, from)?).or_insert(there) != there {
                return None;
            }
        }
        let others = self.around[from].iter().filter(|face| !gone.contains(face));
        others
            .map(|&face| Some((face, self.moved_face(face, from, to, &sides)?)))
            .collect()
    }

    /// A face whose vertex at a point becomes one at another point.
    fn moved_face(&self, face: usize, from: usize, to: usize, sides: &HashMap<Side, u16>) -> Option<[u16; 3]> {
        let side = self.side(face, from)?;
        let vertex = *sides.get(&side)?;
        let before = self.faces[face]?;
        let after = before.map(|old| if old == side.0 { vertex } else { old });
        let points = after.map(|vertex| self.point_of[usize::from(vertex)]);
        let is_double = |&other: &usize| self.points_of(other).iter().all(|point| points.contains(point));
        if self.around[to].iter().any(is_double) {
            return None;
        }
        let normal = |points: [usize; 3]| {
            let [a, b, c] = points.map(|point| self.position(point));
            cross(difference(b, a), difference(c, a))
        };
        let (old, new) = (normal(self.points_of(face)), normal(points));
        let turns_little = dot(old, new) > LEAST_COSINE * length(old) * length(new);
        let keeps_its_side = dot(self.normals[face], new) >= LEAST_COSINE_IN_ALL * length(new);
        let compactness = |points: [usize; 3], normal: Vector| {
            let [a, b, c] = points.map(|point| self.position(point));
            let squares = [(a, b), (b, c), (c, a)].map(|(from, to)| difference(to, from));
            // 1 for three equal sides.
            12f64.sqrt() * length(normal) / squares.map(|side| dot(side, side)).iter().sum::<f64>()
        };
        let shape = compactness(points, new);
        let is_no_sliver = shape >= LEAST_COMPACTNESS || shape >= compactness(self.points_of(face), old);
        (turns_little && keeps_its_side && is_no_sliver).then_some(after)
    }

    fn collapse(&mut self, from: usize, to: usize, moved: &[(usize, [u16; 3])]) {
        let gone = self.at_edge(from, to);
        for &face in &gone {
            for point in self.points_of(face) {
                self.around[point].retain(|&other| other != face);
                self.fans[point] = None;
            }
            self.faces[face] = None;
        }
        self.left -= gone.len();
        for &(face, vertices) in moved {
            self.faces[face] = Some(vertices);
            self.around[to].push(face);
        }
        self.around[from].clear();
        self.quadrics[to] = self.quadrics[to].and(self.quadrics[from]);
        self.changes[from] += 1;
        self.changes[to] += 1;
        self.fans[to] = None;
        for neighbor in self.neighbors(to) {
            self.fans[neighbor] = None;
            self.push(to, neighbor);
            self.push(neighbor, to);
        }
    }

    fn push(&mut self, from: usize, to: usize) {
        let (start, end) = (self.position(from), self.position(to));
        self.candidates.push(Candidate {
            error: self.quadrics[from].and(self.quadrics[to]).error(end),
            length: length(difference(end, start)),
            from,
            to,
            changes: [self.changes[from], self.changes[to]],
        });
    }

    /// The planes of faces, and upright ones on borders and seams. Not by their areas: small parts of a model would go first
    /// (half of the teapot's faces are off by up to 21 of 512 units then, instead of 9).
    fn add_quadrics(&mut self) {
        for face in 0..self.faces.len() {
            let points = self.points_of(face);
            let [a, b, c] = points.map(|point| self.position(point));
            let product = cross(difference(b, a), difference(c, a));
            let Some(normal) = unit(product) else { continue };
            self.normals[face] = normal;
            self.add(&points, Quadric::of_plane(normal, a, 1.0));
            for (one, other) in [(0, 1), (1, 2), (2, 0)].map(|(one, other)| (points[one], points[other])) {
                if self.is_seam(face, one, other) {
                    let along = difference(self.position(other), self.position(one));
                    let upright = unit(cross(along, normal)).unwrap_or(normal);
                    let quadric = Quadric::of_plane(upright, self.position(one), BORDER_WEIGHT);
                    self.add(&[one, other], quadric);
                }
            }
        }
    }

    fn add(&mut self, points: &[usize], quadric: Quadric) {
        for &point in points {
            self.quadrics[point] = self.quadrics[point].and(quadric);
        }
    }

    /// Whether an edge of a face has no other face, or one with other vertices or another colour.
    fn is_seam(&self, face: usize, one: usize, other: usize) -> bool {
        let sides = |face| [one, other].map(|point| self.side(face, point));
        let faces = self.at_edge(one, other);
        faces.len() != 2 || faces.iter().any(|&beside| sides(beside) != sides(face))
    }
}

/// The distance of a point from a triangle.
pub fn distance(point: Vector, [a, b, c]: [Vector; 3]) -> f64 {
    let normal = cross(difference(b, a), difference(c, a));
    let edges = [(a, b), (b, c), (c, a)];
    let is_inside =
        |&(from, to): &(Vector, Vector)| dot(cross(normal, difference(to, from)), difference(point, from)) >= 0.0;
    if edges.iter().all(is_inside)
        && let Some(normal) = unit(normal)
    {
        return dot(normal, difference(point, a)).abs();
    }
    let to_edge = |(from, to): (Vector, Vector)| {
        let (along, way) = (difference(to, from), difference(point, from));
        let part = dot(way, along) / dot(along, along).max(f64::MIN_POSITIVE);
        length(difference(way, scaled(along, part.clamp(0.0, 1.0))))
    };
    edges.map(to_edge).into_iter().fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::distance;

    #[test]
    fn distances_are_to_faces_edges_and_corners() {
        let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        for (point, expected) in [
            ([1.0, 1.0, 3.0], 3.0),
            ([2.0, -5.0, 0.0], 5.0),
            ([4.0, 4.0, 0.0], 8f64.sqrt()),
            ([-3.0, -4.0, 12.0], 13.0),
        ] {
            assert!((distance(point, triangle) - expected).abs() < 1e-12, "{point:?}");
        }
    }
}
