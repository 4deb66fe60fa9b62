//! Appel's algorithm: the number of faces in front of an edge, which is counted once and then carried along.
//!
//! The quantitative invisibility of a point is the number of seen faces that lie between it and the eye; a point is visible where
//! it is 0. Along an edge it changes by one, and only
//!
//! - where the edge passes on the screen behind a contour: a side of a face that is seen, with no such face on the other side.
//!   Behind any other side the edge goes from one face to its neighbour, and the number stays;
//! - where the edge goes through a face.
//!
//! ```text
//!          +-----------+---+
//!          |         /     |         Two faces that are seen, in front of the edge from P to Q. Behind their outer sides, which
//!     P ---+=======/=======+--- Q    are contours, the number changes; behind the side that they share it does not.
//!       0  |  1  /    1    |  0
//!          +---+-----------+
//! ```
//!
//! The contours are found first, from the faces alone. The invisibility of the first vertex is found by a ray, which looks at all
//! faces. From there it is carried to the other end of the edge, and on along all edges that share one of the two vertices: most
//! edges need no ray.
//!
//! Lines in which faces penetrate each other, if they are asked for, are walked as edges are. Such a line lies in two faces, and
//! the rounding of its ends would let these hide it here and there. So they are taken out of the number again: what changes behind
//! their sides, and where the line goes through them, is added once more with the other sign.
//!
//! Guarantees: an edge is hidden exactly where a face lies in front of it by more than a tolerance (2 units of depth, or 8 of depths
//! with 24 bits), of edges and faces as they were snapped; in exact integers, with the ends of parts rounded to the nearest unit
//! of the precision. What coincides on the screen is decided as if all edges were moved by a distance smaller than any, so that
//! the number that is carried to a vertex is that which a ray finds there, in whatever way faces meet, overlap or go through each
//! other. So no number is ever wrong and has to be found anew.
//!
//! Cost: finding the contours takes a search among the sides without a partner for each side of a face; an edge takes a comparison
//! of bounds with each contour and with each face, exact products for those that it meets, and a search among its changes for each
//! of them; a ray takes as long as the faces of an edge. Intersections take a comparison of bounds a pair of faces. A torus
//! with a cube in it, all sides of whose faces are edges: 4 rays for the 422 edges of which something may be seen.
//!
//! Source: A. Appel, "The notion of quantitative invisibility and the machine rendering of solids", 1967.

mod changes;
mod contours;
mod exact;
mod vertices;

use crate::{
    geometry::TooSmall,
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::{
        appel::{
            changes::Changes,
            contours::{Contours, Side},
            exact::{Change, Segment, Triangle},
            vertices::Vertex,
        },
        hiding::tolerance,
        intersection::intersection_of,
        line_part::LinePart,
        line_table::{LineFace, LinePoint, LineTable},
        method::Method,
        parts::{END, PartedLine, Parts},
    },
};

/// Hidden lines by quantitative invisibility: the number of faces in front of an edge is counted at one vertex, and carried along
/// the edges, where it changes behind contours alone (Appel 1967).
///
/// A [`HiddenLines`](crate::visible::HiddenLines) method. Solids may be open and go through each other. Of edges that lie in
/// steep faces of other models, it may show parts that [`FaceAgainstSegment`](crate::visible::FaceAgainstSegment) does not, or hide
/// them: the tolerance in depth is the same for all faces.
///
/// With `INTERSECTIONS`, the lines in which faces penetrate each other are handed over as well, after the edges. Two faces of
/// one model that have a corner in common do not penetrate each other, nor do those that only touch. Neither of the two faces hides
/// the line. It takes a comparison of bounds for each pair of faces, and no memory.
///
/// Memory: `24 * CONTOURS + 8 * CROSSINGS + 16 * VERTICES + 12` bytes. Any of the capacities may be 0: it takes longer then, and the
/// parts are the same.
///
/// - `CONTOURS`: sides of faces without a partner, while faces are looked at one after the other: some more than there are in the
///   end. Of faces for which there is no room, all sides are walked past.
/// - `CROSSINGS`: places where the number changes along one edge. An edge with more of them is walked several times.
/// - `VERTICES`: vertices at which edges meet; twice as many as there are make searches short. At one that finds no room, a ray is
///   cast for each edge.
///
/// When to take it: for many edges that are connected, as of a mesh with creases, where most faces have neighbours on all sides.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Appel<
    const CONTOURS: usize,
    const CROSSINGS: usize,
    const VERTICES: usize,
    const INTERSECTIONS: bool = false,
> {
    contours: [Side; CONTOURS],
    changes: [Change; CROSSINGS],
    vertices: [Vertex; VERTICES],
    contours_kept: usize,
    rays: u32,
    edges: u32,
}

impl<const CONTOURS: usize, const CROSSINGS: usize, const VERTICES: usize, const INTERSECTIONS: bool>
    Appel<CONTOURS, CROSSINGS, VERTICES, INTERSECTIONS>
{
    /// Memory in which nothing is known: all bits are zero.
    pub const fn new() -> Self {
        Self {
            contours: [[LinePoint { x: 0, y: 0, depth: 0 }; 2]; CONTOURS],
            changes: [Change::NONE; CROSSINGS],
            vertices: [Vertex::FREE; VERTICES],
            contours_kept: 0,
            rays: 0,
            edges: 0,
        }
    }

    /// How many rays were cast in the last frame: at the vertices to which no line carried a number.
    pub const fn rays(&self) -> u32 {
        self.rays
    }

    /// How many contours were kept in the last frame: all of them, if there was room for the sides of all faces.
    pub const fn contours(&self) -> usize {
        self.contours_kept
    }

    /// How many lines were walked in the last frame: edges, and intersections.
    pub const fn edges(&self) -> u32 {
        self.edges
    }
}

impl<const CONTOURS: usize, const CROSSINGS: usize, const VERTICES: usize, const INTERSECTIONS: bool> Default
    for Appel<CONTOURS, CROSSINGS, VERTICES, INTERSECTIONS>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth, const CONTOURS: usize, const CROSSINGS: usize, const VERTICES: usize, const INTERSECTIONS: bool>
    Method<D> for Appel<CONTOURS, CROSSINGS, VERTICES, INTERSECTIONS>
{
    fn visible_parts<S, T>(&mut self, table: &T, part: &mut impl FnMut(LinePart<S>)) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        T: LineTable<S, D>,
    {
        for vertex in &mut self.vertices {
            *vertex = Vertex::FREE;
        }
        (self.rays, self.edges) = (0, 0);
        let mut one = [Change::NONE];
        let faces = Faces::new(table, &mut self.contours);
        self.contours_kept = faces.contours.sides().len();
        let mut walk = Walk {
            faces,
            changes: if CROSSINGS == 0 { &mut one } else { &mut self.changes },
            vertices: &mut self.vertices,
            rays: &mut self.rays,
            edges: &mut self.edges,
        };
        for edge in table.edges() {
            walk.find_parts::<S, D>(PartedLine::of(&edge), &[], part);
        }
        if INTERSECTIONS {
            for_each_penetration(table, |line, faces| walk.find_parts::<S, D>(line, &faces, part));
        }
        Ok(())
    }
}

/// A walk along edges, with what is known of the vertices that it came to.
struct Walk<'w, T> {
    faces: Faces<'w, T>,
    changes: &'w mut [Change],
    vertices: &'w mut [Vertex],
    rays: &'w mut u32,
    edges: &'w mut u32,
}

impl<T> Walk<'_, T> {
    /// Hands over a line in parts, which some faces do not hide, because it lies in them.
    fn find_parts<S, D>(&mut self, line: PartedLine, excepted: &[Triangle], part: &mut impl FnMut(LinePart<S>))
    where
        S: ScreenPrecision,
        D: DepthWidth,
        T: LineTable<S, D>,
    {
        let raised = line.ends.map(|end| LinePoint {
            depth: end.depth + tolerance::<D>() as i32,
            ..end
        });
        if let Some(segment) = Segment::new(raised) {
            *self.edges += 1;
            let mut parts = Parts::new(line, part);
            self.along(&segment, excepted, |parameter, is_hidden| {
                parts.until(parameter, is_hidden)
            });
            parts.finish();
        }
    }

    /// Walks along a line. Says of each part up to a parameter, from the start on, whether faces hide it that are not excepted.
    fn along<S, D>(&mut self, edge: &Segment, excepted: &[Triangle], mut until: impl FnMut(u32, bool))
    where
        S: ScreenPrecision,
        D: DepthWidth,
        T: LineTable<S, D>,
    {
        let mut changes = self.faces.changes(edge, excepted, self.changes, 0);
        // Vertices have the number of all faces.
        let excepted_at = |point: LinePoint| excepted.iter().filter(|face| face.hides(point)).count() as i32;
        let (at_start, at_end) = (excepted_at(edge.from), excepted_at(edge.to));
        let sum = changes.sum + at_end - at_start;
        let of_all = match known_at_start(self.vertices, edge, sum) {
            Some(count) => count,
            None => {
                *self.rays += 1;
                self.faces.in_front_of(edge.from)
            }
        };
        vertices::keep(self.vertices, edge.from, of_all);
        vertices::keep(self.vertices, edge.to, of_all + sum);
        let mut in_front = of_all - at_start;
        loop {
            for change in changes.first() {
                until(change.at, in_front > 0);
                in_front += change.by;
            }
            match changes.next() {
                Some(from) => changes = self.faces.changes(edge, excepted, self.changes, from),
                None => break,
            }
        }
        until(END, in_front > 0);
    }
}

/// The quantitative invisibility at the start of an edge, if it is known there or at the end, and the sum of what changes along
/// the edge.
fn known_at_start(vertices: &[Vertex], edge: &Segment, sum: i32) -> Option<i32> {
    vertices::find(vertices, edge.from).or_else(|| {
        let at_end = vertices::find(vertices, edge.to)?;
        Some(at_end - sum)
    })
}

/// The faces of a table that are seen, as edges are walked past them.
struct Faces<'t, T> {
    table: &'t T,
    /// The contours of the first faces.
    contours: Contours<'t>,
}

impl<'t, T> Faces<'t, T> {
    /// Finds the contours, in so much memory.
    fn new<S: ScreenPrecision, D: DepthWidth>(table: &'t T, memory: &'t mut [Side]) -> Self
    where
        T: LineTable<S, D>,
    {
        let mut contours = Contours::new(memory);
        for face in table.faces() {
            if seen(&face).is_some_and(|seen| !contours.add(seen.sides())) {
                break;
            }
            contours.end = face.index + 1;
        }
        Self { table, contours }
    }

    /// The changes of a line from a parameter on, without those of some faces.
    fn changes<'c, S: ScreenPrecision, D: DepthWidth>(
        &self,
        edge: &Segment,
        excepted: &[Triangle],
        memory: &'c mut [Change],
        from: u32,
    ) -> Changes<'c>
    where
        T: LineTable<S, D>,
    {
        let mut changes = Changes::new(memory, from);
        for side in self.contours.sides() {
            changes.add(edge.behind(*side));
        }
        for face in self.table.faces() {
            let Some(triangle) = seen(&face) else { continue };
            changes.add(edge.through(&triangle));
            if face.index >= self.contours.end {
                for side in triangle.sides() {
                    changes.add(edge.behind(side));
                }
            }
        }
        for face in excepted {
            changes.add(edge.through(face).map(Change::reversed));
            for side in face.sides() {
                changes.add(edge.behind(side).map(Change::reversed));
            }
        }
        changes
    }

    /// Casts a ray: how many faces lie in front of a point.
    fn in_front_of<S: ScreenPrecision, D: DepthWidth>(&self, point: LinePoint) -> i32
    where
        T: LineTable<S, D>,
    {
        let hiding = self.table.faces().filter_map(|face| seen(&face));
        hiding.filter(|face| face.hides(point)).count() as i32
    }
}

/// Finds the lines in which faces penetrate each other, with the two faces, of all pairs.
fn for_each_penetration<S, D, T>(table: &T, mut line: impl FnMut(PartedLine, [Triangle; 2]))
where
    S: ScreenPrecision,
    D: DepthWidth,
    T: LineTable<S, D>,
{
    for face in table.faces() {
        let Some(one) = seen(&face) else { continue };
        for beside in (face.index + 1..table.face_indices()).filter_map(|index| table.face(index)) {
            let Some(other) = seen(&beside).filter(|other| one.meets(other)) else {
                continue;
            };
            if let Some(found) = intersection_of(table, &face, &beside) {
                line(found, [one, other]);
            }
        }
    }
}

/// A face as edges are walked past it, if it is seen.
fn seen(face: &LineFace) -> Option<Triangle> {
    face.is_seen.then(|| Triangle::new(face.corners)).flatten()
}
