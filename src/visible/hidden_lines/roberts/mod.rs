//! Roberts' algorithm: edges against convex solids, each of which is the common part of half-spaces.
//!
//! A convex solid is all that lies behind the plane of each of its faces, so that its planes (Roberts' volume matrix) say of any
//! point whether it is inside. Three steps lead to a drawing:
//!
//! 1. Self-hiding. Of a convex solid that is seen from outside, an edge is hidden by the solid itself exactly where both faces
//!    beside it are seen from behind. So an edge is never compared with its own solid.
//! 2. Each other edge against each other solid. The eye is at infinity along the axis of depth, because that is how the screen
//!    sees space. The points of an edge P + t d, 0 <= t <= 1, move towards the viewer, P + t d + a g, a >= 0: where such a ray
//!    meets the solid, the edge is hidden. All planes together bound a convex region in (t, a), whose least and greatest t are the
//!    ends of the one interval of the edge that the solid hides.
//!
//! ```text
//!     a ^      back planes                     +-------+
//!       |     \   a >= ..  /                  /  solid  \
//!       |      \+--------+/                  /           \
//!       |      /|////////|\            P ---+=============+--- Q      hidden from least t to greatest t
//!       |     / |////////| \                 \           /
//!     --+----+--+--------+--+--> t            \         /
//!       |      least     greatest              +-------+
//! ```
//!
//! 3. Penetration. Where an edge pierces a face of another solid (a = 0), a new edge begins that no mesh has; the two points
//!    where edges pierce the same pair of faces are its ends. The new edges are then tested against all solids.
//!
//! The linear program of the second step is solved with a eliminated (Fourier and Motzkin): only planes of faces that are seen
//! from the front bound a from above, and only those of faces seen from behind, and a >= 0, from below. So there is an a for t
//! exactly if each plane of the front allows a = 0, and each pair of a front and a back plane leaves room. Pairs whose faces do
//! not meet follow from those that do, in the silhouette edges, and what such a pair says is: t is on the inner side of its
//! edge, as seen. What is left for each solid are inequalities in t alone, one for each face of the front and one for each
//! silhouette edge; each cuts one end off the interval.
//!
//! A model counts as convex if it is so on the screen, where its corners were snapped: it was not cut, no corner is in front of the
//! plane of one of its faces by more than the tolerance that faces hide with, and the outline of those seen from the front has
//! all corners to one side of each of its edges, to a unit of position. Other models, concave or cut by a plane of the view, are
//! taken face by face, as if each were a solid of its own (three planes through the eye, and its own): their parts are right,
//! too, but take long.
//!
//! Guarantees: an edge is hidden where a face hides it, as [`FaceAgainstSegment`](crate::visible::FaceAgainstSegment) has it, up
//! to the rounding of corners: where a point would be hidden or not if it were moved by a unit of position along both axes and a
//! few of depth. Faces that only touch an edge do not hide it. Numbers are exact; planes are rounded to 30 bits, which moves
//! them by less than 1/32 unit, and the ends of parts to the nearest unit.
//!
//! Cost: each plane is compared with each corner of its model, once; then for each edge the box of each solid, and two dot products
//! a plane where the boxes overlap, up to the first plane that has all of the edge in front of it. New edges take a comparison
//! of each two faces of different models whose boxes overlap. Source: L. G. Roberts, Machine Perception of Three-Dimensional
//! Solids, 1963.

mod plane;
mod solid;
mod tested_line;

use crate::{
    geometry::TooSmall,
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::{
        hiding::HidingFace,
        junction::junction,
        line_part::LinePart,
        line_table::{LineEdge, LineFace, LineTable},
        method::Method,
        parts::{END, PartedLine, Parts},
        roberts::{
            plane::Plane,
            solid::{Bounds, Solid, Volume, faces_of, volume},
            tested_line::{Covered, TestedLine},
        },
    },
};

/// Hidden lines by convex solids, with the new edges where solids penetrate each other (Roberts 1963). For scenes of boxes and
/// other convex solids, and wherever solids go through each other.
///
/// All models may be convex or not: those that are not, or were cut by a plane of the view, take longer, and no memory.
/// [`FaceSet::is_convex`](crate::scene::FaceSet::is_convex) tells. New edges come after all others, with the kind
/// [`Intersection`](crate::visible::PartKind::Intersection), the first of the two models, and no index of an edge; only those of
/// which both faces are seen from the front, as the others are behind their own solid. A model that goes through itself has none.
///
/// `SOLIDS` is the number of models, and `PLANES` how many faces of convex ones are seen from the front, and silhouette edges they
/// have: for closed models never more than twice as many as they have faces.
///
/// RAM: 40 bytes a solid, 24 bytes a plane, and 16.
///
/// Source: Roberts 1963.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I2F14, I16F16, U0F16};
/// use zrow::{
///     scene::{Camera, Edge, FaceSet, Memory, Model, Pose, Rotation},
///     visible::{PartKind, Roberts},
/// };
///
/// /// A pyramid on a square.
/// const VERTICES: [[i16; 3]; 5] = [[-90, -60, -90], [-90, -60, 90], [90, -60, 90], [90, -60, -90], [0, 90, 0]];
/// const POLYGONS: [&[u16]; 5] = [&[3, 2, 1, 0], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];
/// const FACES: [[u16; 3]; 6] = match FaceSet::triangulate(&VERTICES, &POLYGONS) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a polygon is not planar, not convex, or names a vertex that is not there"),
/// };
/// static EDGES: [Edge; 8] = match FaceSet::find_edges(&VERTICES, &FACES, I2F14::lit("0.866")) {
///     Ok(edges) => edges,
///     Err(_) => panic!("a face names a vertex that is not there, or the table is too small"),
/// };
///
/// let mesh = FaceSet::new(&VERTICES, &FACES)?;
/// assert!(mesh.is_convex());
/// let at = |x: i32, z: i32, turn: f32| {
///     Pose::new(Rotation::about_y(U0F16::from_num(turn)), [x, 0, z].map(I16F16::from_num))
/// };
/// let pyramid = Model::new(mesh, &[Rgb565::RED; 6])?;
/// // Two that go through each other, and one far behind them.
/// let models = [at(-20, 300, 0.0), at(50, 310, 0.1), at(10, 900, 0.0)].map(|pose| pyramid.with_pose(pose));
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(64))?;
/// let mut memory = Memory::<Rgb565, 15, 18, 64, 64>::new();
/// let scene = memory.prepare(&camera, &models)?;
///
/// let mut method = Roberts::<3, 36>::new();
/// let (mut hidden, mut intersections) = ([0; 3], 0);
/// scene.visible_parts(&mut method, &[&EDGES[..]; 3], |part| {
///     if part.is_hidden && part.kind != PartKind::Intersection {
///         hidden[part.model] += 1;
///     }
///     if part.kind == PartKind::Intersection && !part.is_hidden {
///         intersections += 1;
///     }
/// })?;
/// assert!(hidden[2] > 0 && intersections > 0);
/// assert!(method.boxes_apart() < method.pairs() && method.inequalities() > 0);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Roberts<const SOLIDS: usize, const PLANES: usize> {
    /// The planes of convex models, those of a model one after the other.
    planes: [Plane; PLANES],
    /// One for each model.
    solids: [Solid; SOLIDS],
    counts: Counts,
}

/// What the last call took.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Counts {
    pairs: u32,
    boxes_apart: u32,
    inequalities: u32,
}

impl Counts {
    const ZERO: Self = Self {
        pairs: 0,
        boxes_apart: 0,
        inequalities: 0,
    };
}

impl<const SOLIDS: usize, const PLANES: usize> Default for Roberts<SOLIDS, PLANES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const SOLIDS: usize, const PLANES: usize> Roberts<SOLIDS, PLANES> {
    /// The memory; all bits are zero, so that a `static` lies in `.bss`.
    pub const fn new() -> Self {
        Self {
            planes: [Plane::ZERO; PLANES],
            solids: [Solid::ZERO; SOLIDS],
            counts: Counts::ZERO,
        }
    }

    /// How many pairs of a line (an edge, or a new one) and a solid that it does not belong to the last call looked at.
    pub const fn pairs(&self) -> u32 {
        self.counts.pairs
    }

    /// How many of the [pairs](Self::pairs) of the last call needed no more than a look at their boxes: they are beside each
    /// other as seen, or all of the solid is behind the line.
    pub const fn boxes_apart(&self) -> u32 {
        self.counts.boxes_apart
    }

    /// How many inequalities the last call solved. A face of a model that is not convex takes four.
    pub const fn inequalities(&self) -> u32 {
        self.counts.inequalities
    }

    /// Finds the planes of all models.
    fn find_planes<S: ScreenPrecision, D: DepthWidth>(&mut self, table: &impl LineTable<S, D>) -> Result<(), TooSmall> {
        if table.models() > SOLIDS {
            return Err(TooSmall::Solids(table.models()));
        }
        let mut used = 0;
        for (model, solid) in self.solids.iter_mut().take(table.models()).enumerate() {
            let first = used;
            let room = self.planes.get_mut(first..).unwrap_or_default();
            let count = match volume(table, model, room) {
                Volume::Convex(count) => count,
                Volume::Other => 0,
            };
            used += count;
            *solid = Solid::new(Bounds::of_faces(faces_of(table, model)), [first, used]);
        }
        if used > PLANES {
            return Err(TooSmall::Planes(used));
        }
        Ok(())
    }

    /// Hands over an edge in parts.
    fn edge<S: ScreenPrecision, D: DepthWidth>(
        &mut self,
        table: &impl LineTable<S, D>,
        edge: &LineEdge,
        part: &mut impl FnMut(LinePart<S>),
    ) {
        let line = PartedLine::of(edge);
        let of_model = table.faces_of_model(edge.model);
        let faces = edge.faces.map(|face| of_model.start.saturating_add(usize::from(face)));
        let is_front = |index: &usize| of_model.contains(index) && table.face(*index).is_some_and(|face| face.is_front);
        let is_of_convex = self.solids.get(edge.model).is_some_and(Solid::is_convex);
        if is_of_convex && !faces.iter().any(is_front) {
            let mut parts = Parts::new(line, part);
            parts.until(END, true);
            return parts.finish();
        }
        let tested = TestedLine {
            line,
            models: [edge.model; 2],
            faces,
        };
        self.line(table, &tested, part);
    }

    /// Hands over a line in parts.
    fn line<S: ScreenPrecision, D: DepthWidth>(
        &mut self,
        table: &impl LineTable<S, D>,
        tested: &TestedLine,
        part: &mut impl FnMut(LinePart<S>),
    ) {
        self.solve(table.models(), tested);
        let mut parts = Parts::new(tested.line, part);
        let mut at = 0;
        while at < END {
            let Covered { until, next } = self.covered(table, tested, at);
            let is_hidden = until > at;
            at = if is_hidden { until } else { next };
            parts.until(at, is_hidden);
        }
        parts.finish();
    }

    /// Finds the interval of a line that each solid hides.
    fn solve(&mut self, models: usize, tested: &TestedLine) {
        let ends = tested.line.ends;
        let around = Bounds::of_points(&ends);
        for (model, solid) in self.solids.iter_mut().take(models).enumerate() {
            solid.hidden = [0; 2];
            if solid.is_convex() && tested.models.contains(&model) {
                continue;
            }
            self.counts.pairs = self.counts.pairs.saturating_add(1);
            if !solid.bounds.may_hide(&around) {
                self.counts.boxes_apart = self.counts.boxes_apart.saturating_add(1);
                continue;
            }
            let hidden = solid.hidden_interval(&self.planes, ends);
            solid.hidden = hidden.interval.unwrap_or([0; 2]);
            self.counts.inequalities = self.counts.inequalities.saturating_add(hidden.inequalities);
        }
    }

    /// How far a line is hidden from a parameter on, and where it is next.
    fn covered<S: ScreenPrecision, D: DepthWidth>(
        &mut self,
        table: &impl LineTable<S, D>,
        tested: &TestedLine,
        at: u32,
    ) -> Covered {
        let mut covered = Covered { until: at, next: END };
        for (model, solid) in self.solids.iter().take(table.models()).enumerate() {
            let [start, end] = solid.hidden;
            if start == end {
                continue;
            }
            if solid.is_convex() {
                covered.with(solid.hidden, at);
                continue;
            }
            let may_hide = |face: &LineFace| {
                let bounds = Bounds::of_points(&face.corners);
                face.is_seen
                    && !(tested.faces.contains(&face.index))
                    && bounds.may_hide(&Bounds::of_points(&tested.line.ends))
            };
            for face in faces_of(table, model).filter(may_hide) {
                self.counts.inequalities = self.counts.inequalities.saturating_add(4);
                let hidden = HidingFace::new(face.corners).and_then(|face| face.hidden::<D>(tested.line.ends));
                if let Some(hidden) = hidden {
                    covered.with(hidden, at);
                }
            }
        }
        covered
    }

    /// Hands over the new edges where two models penetrate each other.
    fn junctions<S: ScreenPrecision, D: DepthWidth>(
        &mut self,
        table: &impl LineTable<S, D>,
        models: [usize; 2],
        part: &mut impl FnMut(LinePart<S>),
    ) {
        let [Some(first), Some(second)] = models.map(|model| self.solids.get(model).copied()) else {
            return;
        };
        if !first.bounds.meets(&second.bounds) {
            return;
        }
        let [one, other] = models;
        for face in faces_of(table, one).filter(|face| first.shows(face)) {
            let bounds = Bounds::of_points(&face.corners);
            if !bounds.meets(&second.bounds) {
                continue;
            }
            for beside in faces_of(table, other).filter(|face| second.shows(face)) {
                if !bounds.meets(&Bounds::of_points(&beside.corners)) {
                    continue;
                }
                if let Some(ends) = junction::<D>([face.corners, beside.corners]) {
                    self.line(table, &TestedLine::between([&face, &beside], ends), part);
                }
            }
        }
    }
}

impl<D: DepthWidth, const SOLIDS: usize, const PLANES: usize> Method<D> for Roberts<SOLIDS, PLANES> {
    fn visible_parts<S, T>(&mut self, table: &T, part: &mut impl FnMut(LinePart<S>)) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        T: LineTable<S, D>,
    {
        self.counts = Counts::ZERO;
        self.find_planes(table)?;
        for edge in table.edges() {
            self.edge(table, &edge, part);
        }
        for first in 0..table.models() {
            for second in first + 1..table.models() {
                self.junctions(table, [first, second], part);
            }
        }
        Ok(())
    }
}
