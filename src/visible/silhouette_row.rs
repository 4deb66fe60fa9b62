//! The silhouettes in a row: what of each pixel lies inside them, by area.
//!
//! ```text
//!      edge of a silhouette             Each edge that goes up covers all to its right, one that goes down takes
//!   +------+--/---+------+------+       that away again: cells with cover and area, as for outlines. So the sum in
//!   |      | /####|######|######|       a pixel is the number of surfaces that face the viewer there, one behind
//!   +------+/-----+------+------+       the other: 1, 2, and with a fraction where a silhouette passes through the
//!     0      3/4     1      1           pixel. The fraction is the coverage of that surface. Edges between two
//!                                       faces of a surface cancel out, to the bit: a mesh has no seams.
//! ```
//!
//! Guarantees: coverage is the exact area within 1/128 of a pixel, rounded to 1/255, where the silhouettes of one surface pass
//! through a pixel, also where corners or several edges lie in it. Two silhouettes that pass through one pixel at different
//! depths are taken for one.
//!
//! Source: cells with cover and area (FreeType's smooth rasterizer, Turner 2000) of silhouette edges alone (Sander, Hoppe,
//! Snyder and Gortler 2001, "Discontinuity edge overdraw").

use core::{fmt::Debug, num::Wrapping};

use embedded_graphics::geometry::Point;

use crate::{
    coverage::{COVER_BITS, Cell, Coverage, X_BITS, X_ONE, for_each_visible_cell},
    geometry::{divide_floor_large, divide_long},
    shade::{ChannelColor, Encoded},
    surface::{BandColor, LittleEndian, Order, PixelWord},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{face_edges::FaceEdges, silhouette_edge::ActiveEdge, touched_columns::Touched},
};

// Not re-exported: how silhouettes are drawn is said by a wrapper of the look.
/// How the silhouettes of a look are drawn: by the centres of pixels (`()`), or [by area](ByArea).
pub trait Silhouettes<C: BandColor>: Debug + 'static {
    /// Whether they are drawn by area.
    const BY_AREA: bool;
    /// What is kept of each column of the row.
    type Column<D: DepthWidth>: Entry;
    /// What is kept of each face.
    type FaceEdges: Entry;
    /// Room for edges that go on from row to row.
    type ActiveEdges<D: DepthWidth>: Entry;

    /// What is kept of the columns, where silhouettes are drawn by area; else nothing.
    fn columns<D: DepthWidth>(columns: &mut [Self::Column<D>]) -> &mut [EdgeColumn<C::Word, D>];

    /// What is kept of faces, where silhouettes are drawn by area; else nothing.
    fn faces(faces: &mut [Self::FaceEdges]) -> &mut [FaceEdges];

    /// The active edges, where silhouettes are drawn by area; else nothing.
    fn active<D: DepthWidth>(edges: &mut Self::ActiveEdges<D>) -> &mut [ActiveEdge<D>];

    /// The word of a pixel of which a part is covered, in the machine's byte order.
    fn mix(fragment: C::Word, behind: C::Word, coverage: Coverage, position: Point) -> C::Word;
}

// Not re-exported.
/// An entry of a table.
pub trait Entry: Copy + Debug {
    /// The entry of a new table: all bits are zero.
    const EMPTY: Self;
}

impl Entry for () {
    const EMPTY: Self = ();
}

impl<C: BandColor> Silhouettes<C> for () {
    const BY_AREA: bool = false;
    type Column<D: DepthWidth> = ();
    type FaceEdges = ();
    type ActiveEdges<D: DepthWidth> = ();

    fn columns<D: DepthWidth>(_: &mut [()]) -> &mut [EdgeColumn<C::Word, D>] {
        &mut []
    }

    fn faces(_: &mut [()]) -> &mut [FaceEdges] {
        &mut []
    }

    fn active<D: DepthWidth>((): &mut ()) -> &mut [ActiveEdge<D>] {
        &mut []
    }

    fn mix(fragment: C::Word, _: C::Word, _: Coverage, _: Point) -> C::Word {
        fragment
    }
}

/// Silhouettes by the area of each pixel that lies inside them.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ByArea;

impl<C: ChannelColor> Silhouettes<C> for ByArea {
    const BY_AREA: bool = true;
    type Column<D: DepthWidth> = EdgeColumn<C::Word, D>;
    type FaceEdges = FaceEdges;
    type ActiveEdges<D: DepthWidth> = [ActiveEdge<D>; ACTIVE_EDGES];

    fn columns<D: DepthWidth>(columns: &mut [EdgeColumn<C::Word, D>]) -> &mut [EdgeColumn<C::Word, D>] {
        columns
    }

    fn faces(faces: &mut [FaceEdges]) -> &mut [FaceEdges] {
        faces
    }

    fn active<D: DepthWidth>(edges: &mut [ActiveEdge<D>; ACTIVE_EDGES]) -> &mut [ActiveEdge<D>] {
        edges
    }

    fn mix(fragment: C::Word, behind: C::Word, coverage: Coverage, position: Point) -> C::Word {
        let mut word = [LittleEndian::reorder(behind)];
        C::blend_run::<Encoded, LittleEndian>(&mut word, position, C::from_word(fragment), coverage);
        let [word] = word;
        LittleEndian::reorder(word)
    }
}

// Not re-exported.
/// A pixel of a row, as far as silhouettes pass through it.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EdgeColumn<W, D> {
    /// What the number of surfaces in the pixel has more than in the pixel before it, 2^18 for 1.
    pub(super) change: i32,
    /// The face of the nearest edge that passes through the pixel, plus one; 0 where there is none. With
    /// [`ONE_EDGE`](Self::ONE_EDGE) if it is the only one.
    pub(super) face: u16,
    /// The depth of the nearest edge: at the centre of the pixel, between the depths of its ends; of an edge up to 16 pixels long
    /// that of its middle.
    pub(super) depth: D,
    /// The word that the pixel of the band had before the row was drawn.
    pub(super) behind: W,
}

impl<W: PixelWord, D: DepthWidth> EdgeColumn<W, D> {
    /// Beside the face, whose number is less than 2^15: one edge alone passes through the pixel, and it does from side to side, so
    /// that the greater part of the pixel has its centre.
    pub(super) const ONE_EDGE: u16 = 1 << 15;

    /// Adds to what the number of surfaces has more than in the pixel before it.
    #[inline(always)]
    fn add(&mut self, change: Wrapping<i32>) {
        self.change = (Wrapping(self.change) + change).0;
    }

    /// Notes that an edge passes through the pixel, which has a word that nothing of the scene was drawn to. `face` is the face of
    /// the edge as the column keeps it.
    #[inline(always)]
    fn mark(&mut self, face: u16, depth: D, word: Option<&W>) {
        if self.face == 0 {
            self.behind = word.copied().unwrap_or(W::ZERO);
            (self.face, self.depth) = (face, depth);
            return;
        }
        self.face &= !Self::ONE_EDGE;
        let face = face & !Self::ONE_EDGE;
        // Of equally near ones that of the first face, in whichever order they come.
        if self.depth < depth || (self.depth == depth && face < self.face) {
            (self.face, self.depth) = (face, depth);
        }
    }
}

impl<W: PixelWord, D: DepthWidth> Entry for EdgeColumn<W, D> {
    const EMPTY: Self = Self {
        change: 0,
        face: 0,
        depth: D::FARTHEST,
        behind: W::ZERO,
    };
}

/// Edges of silhouettes that go on from row to row: where more of them cross a row, the others are set up in each row.
const ACTIVE_EDGES: usize = 32;

impl<D: DepthWidth> Entry for [ActiveEdge<D>; ACTIVE_EDGES] {
    const EMPTY: Self = [ActiveEdge::EMPTY; ACTIVE_EDGES];
}

impl Entry for FaceEdges {
    const EMPTY: Self = Self::EMPTY;
}

/// The columns of a row, and those of them that silhouettes touch.
pub(crate) struct EdgeRow<'c, W, D> {
    pub(super) columns: &'c mut [EdgeColumn<W, D>],
    pub(super) touched: Touched,
    /// [`EdgeColumn::ONE_EDGE`], or 0 where a face of the frame is cut: the edges of those are not known.
    one_edge: u16,
    /// The row in the picture, and its first column.
    y: i32,
    left: i32,
}

/// What a row that is drawn knows of the silhouettes in it: nothing (`()`), or their columns.
pub(crate) trait RowEdges<'c, W, D> {
    fn columns(&mut self) -> Option<&mut EdgeRow<'c, W, D>>;
}

impl<'c, W, D> RowEdges<'c, W, D> for () {
    #[inline(always)]
    fn columns(&mut self) -> Option<&mut EdgeRow<'c, W, D>> {
        None
    }
}

impl<'c, W, D> RowEdges<'c, W, D> for EdgeRow<'c, W, D> {
    #[inline(always)]
    fn columns(&mut self) -> Option<&mut Self> {
        Some(self)
    }
}

/// The part of an edge that lies in a row.
#[derive(Debug, Copy, Clone)]
struct Part {
    /// Left and right end in 1/8192 pixel, from the left side of the row.
    ends: [i32; 2],
    /// Height of the part in 1/16384 pixel.
    height: i32,
    /// 1 where the edge goes up, -1 where it goes down.
    sign: i32,
}

impl<'c, W: PixelWord, D: DepthWidth> EdgeRow<'c, W, D> {
    /// A row of so many columns, into which no edge was added yet. The columns were left so by the row before it; with fewer
    /// columns than that, those on the right have no silhouettes.
    pub(crate) fn new(columns: &'c mut [EdgeColumn<W, D>], width: usize, [left, y]: [i32; 2]) -> Self {
        let (columns, _) = columns.split_at_mut(width.min(columns.len()));
        let touched = Touched::none(columns.len());
        Self {
            columns,
            touched,
            one_edge: EdgeColumn::<W, D>::ONE_EDGE,
            y,
            left,
        }
    }

    /// Whether no silhouette passes through the row.
    #[inline(always)]
    pub(super) fn is_untouched(&self) -> bool {
        self.touched.is_empty()
    }

    /// Does not tell pixels through which one edge alone passes from the others.
    pub(crate) fn leave_out_single_edges(&mut self) {
        self.one_edge = 0;
    }

    /// The first column of the row in the picture.
    #[inline]
    pub(crate) fn left(&self) -> i32 {
        self.left
    }

    /// y of the upper and of the lower side of the row.
    #[inline(always)]
    pub(crate) fn sides<S: ScreenPrecision>(&self) -> [i32; 2] {
        let one = 1 << S::FRACTION_BITS;
        let top = (self.y << S::FRACTION_BITS) - one / 2;
        [top, top + one]
    }

    /// Adds the active edges, and moves those together that go on below the row. Returns how many these are. `words` are the
    /// pixels of the row, which nothing of the scene was drawn to yet. `corners` looks the corners of a face up, clockwise, or
    /// the other way round where it is reversed.
    #[inline(always)]
    pub(crate) fn add_active<'v, S: ScreenPrecision>(
        &mut self,
        words: &[W],
        edges: &mut [ActiveEdge<D>],
        corners: impl Fn(u16) -> Option<[&'v ScreenVertex<S, D>; 3]>,
    ) -> usize
    where
        D: 'v,
    {
        let [_, bottom] = self.sides::<S>();
        let (mut index, mut used) = (0, edges.len());
        while let Some(edge) = edges.get(index).filter(|_| index < used) {
            self.add(words, edge, &corners);
            if edge.last() > bottom {
                index += 1;
                continue;
            }
            // In any order: the last one comes next.
            used -= 1;
            if let Some((edges, [last, ..])) = edges.split_at_mut_checked(used) {
                if let Some(ended) = edges.get_mut(index) {
                    last.move_to(ended);
                }
            }
        }
        used
    }

    /// Adds an edge for which there is no room among the active ones.
    #[cold]
    #[inline(never)]
    pub(crate) fn add_once<'v, S: ScreenPrecision>(
        &mut self,
        words: &[W],
        edge: &ActiveEdge<D>,
        corners: impl Fn(u16) -> Option<[&'v ScreenVertex<S, D>; 3]>,
    ) where
        D: 'v,
    {
        self.add(words, edge, &corners);
    }

    /// Adds the part of an edge that lies in the row.
    #[inline(always)]
    fn add<'v, S: ScreenPrecision>(
        &mut self,
        words: &[W],
        edge: &ActiveEdge<D>,
        corners: &impl Fn(u16) -> Option<[&'v ScreenVertex<S, D>; 3]>,
    ) where
        D: 'v,
    {
        if edge.is_long() || !self.add_narrow(words, edge, &self.part::<S>(edge)) {
            self.add_any(words, edge, corners);
        }
    }

    /// The part of an edge that lies in the row.
    #[inline(always)]
    fn part<S: ScreenPrecision>(&self, edge: &ActiveEdge<D>) -> Part {
        let rows @ [start, end] = edge.part(self.sides::<S>());
        Part {
            ends: edge.ends(rows),
            height: (end - start) << (COVER_BITS - S::FRACTION_BITS),
            sign: edge.sign(),
        }
    }

    /// Adds the part of a short edge, if it passes through one column of the row or two. Otherwise returns `false`.
    #[inline(always)]
    fn add_narrow(&mut self, words: &[W], edge: &ActiveEdge<D>, part: &Part) -> bool {
        let Part { ends, height, sign } = *part;
        let ([first, last], sign) = (ends.map(|x| x >> X_BITS), Wrapping(sign));
        // Left of the row that is a huge number.
        let from = first as usize;
        let columns = self.columns.get_mut(from..).and_then(<[_]>::first_chunk_mut);
        let Some([here, other, next]) = columns else {
            return false;
        };
        let is_one = match last - first {
            0 => {
                let cell = Cell::within(ends, height);
                here.add(sign * (cell.cover - cell.area));
                other.add(sign * cell.area);
                true
            }
            1 => {
                let [left, right] = Cell::in_two(ends, height);
                here.add(sign * (left.cover - left.area));
                other.add(sign * (left.area + right.cover - right.area));
                next.add(sign * right.area);
                false
            }
            _ => return false,
        };
        self.touched.add([first, last + 1]);
        if edge.is_drawn() {
            let (face, depth) = (face(self.one_edge, edge, part), edge.depth());
            // One that ends at the boundary of two pixels passes through the left one alone.
            let [_, right] = ends;
            let marks_last = right & (X_ONE - 1) != 0;
            if marks_last || !is_one {
                here.mark(face, depth, words.get(from));
            }
            if marks_last && !is_one {
                other.mark(face, depth, words.get(from + 1));
            }
        }
        true
    }

    /// Adds the part of any edge that lies in the row.
    #[inline(never)]
    fn add_any<'v, S: ScreenPrecision>(
        &mut self,
        words: &[W],
        edge: &ActiveEdge<D>,
        corners: &impl Fn(u16) -> Option<[&'v ScreenVertex<S, D>; 3]>,
    ) where
        D: 'v,
    {
        let part = self.part::<S>(edge);
        let Some(columns) = self.add_part(&part).filter(|_| edge.is_drawn()) else {
            return;
        };
        let face = face(self.one_edge, edge, &part);
        if edge.is_long() {
            if let Some(corners) = corners(edge.face()) {
                let [from, to] = edge.corners_of(corners);
                let ends = if edge.goes_up() { [to, from] } else { [from, to] };
                let rows = edge.part(self.sides::<S>());
                self.mark_long::<S>(words, columns, face, ends, rows);
            }
        } else {
            let depth = edge.depth();
            self.mark(words, columns, face, || depth);
        }
    }

    /// Adds a part of an edge. Returns the first and the last column that it passes through, `None` where it passes through no
    /// pixel of the row.
    #[inline]
    fn add_part(&mut self, part: &Part) -> Option<[i32; 2]> {
        let [_, right] = part.ends;
        let [first, last] = part.ends.map(|x| x >> X_BITS);
        let width = self.columns.len() as i32;
        if first >= width {
            return None;
        }
        // The cell after the last column gets a change, too.
        self.touched.add([first.max(0), (last + 1).max(0).min(width - 1)]);
        if part.height != 0 {
            self.add_cells(part, width);
        }
        // One that ends at the boundary of two pixels passes through the left one alone.
        let last = if right & (X_ONE - 1) == 0 { last - 1 } else { last };
        (0 <= last && first <= last).then_some([first.max(0), last.min(width - 1)])
    }

    /// Adds the cells of a part of an edge: those of one that goes down are those of one that goes up, the other way round, so
    /// that both cancel out to the bit.
    #[inline]
    fn add_cells(&mut self, part: &Part, width: i32) {
        let columns = &mut *self.columns;
        let Part { ends, height, sign } = *part;
        let (sign, [start, end]) = (Wrapping(sign), ends);
        let mut add = |cell: Cell| {
            let mut change = |column: i32, by: Wrapping<i32>| {
                if let Some(column) = columns.get_mut(column as usize) {
                    column.add(sign * by);
                }
            };
            change(cell.x, cell.cover - cell.area);
            change(cell.x + 1, cell.area);
        };
        match (end >> X_BITS) - (start >> X_BITS) {
            0 if start >= 0 => add(Cell::within(ends, height)),
            1 if start >= 0 => Cell::in_two(ends, height).into_iter().for_each(add),
            2 if start >= 0 => Cell::in_three(ends, height).into_iter().for_each(add),
            _ => for_each_visible_cell(ends, height, width, add),
        }
    }

    /// Notes that an edge passes through the columns from the first to the last: its face as they keep it, and its depth in each
    /// of them.
    #[inline]
    fn mark(&mut self, words: &[W], [first, last]: [i32; 2], face: u16, mut depth: impl FnMut() -> D) {
        let columns = first as usize..last as usize + 1;
        let (Some(columns), Some(words)) = (self.columns.get_mut(columns.clone()), words.get(columns)) else {
            return;
        };
        for (edge, word) in columns.iter_mut().zip(words) {
            edge.mark(face, depth(), Some(word));
        }
    }

    /// Notes that a long edge passes through the columns between two y. Its depth is the same in all of them, or, where the edge
    /// is nearly level, that at the centre of each.
    #[inline]
    fn mark_long<S: ScreenPrecision>(
        &mut self,
        words: &[W],
        columns: [i32; 2],
        face: u16,
        [upper, lower]: [&ScreenVertex<S, D>; 2],
        [start, end]: [i32; 2],
    ) {
        let (width, height) = (lower.x_units() - upper.x_units(), lower.y_units() - upper.y_units());
        if height >= width.abs() {
            let part = ((start + end) >> 1) - upper.y_units();
            let change = lower.z.units() - upper.z.units();
            let depth = D::from_units(upper.z.units() + scaled(change, part, height));
            self.mark(words, columns, face, || depth);
        } else {
            let ends = if width < 0 { [lower, upper] } else { [upper, lower] };
            self.mark_level(words, columns, face, ends);
        }
    }

    /// Fractional bits of the depths along an edge: units have 16 or 24 bits, and a step beyond either end fits as well.
    const DEPTH_BITS: u32 = D::FRACTION_BITS - 2;

    /// Notes that a long, nearly level edge passes through the columns from the first to the last.
    fn mark_level<S: ScreenPrecision>(
        &mut self,
        words: &[W],
        columns: [i32; 2],
        face: u16,
        [left, right]: [&ScreenVertex<S, D>; 2],
    ) {
        let [start, end] = [left, right].map(|end| end.z.units() << Self::DEPTH_BITS);
        let one = 1 << S::FRACTION_BITS;
        let step = scaled(end - start, one, right.x_units() - left.x_units());
        // From the end of the edge on, wherever the row begins; and half a unit more, so that depths are rounded to the nearest.
        let (column, after) = (left.x_units() >> S::FRACTION_BITS, left.x_units() & (one - 1));
        let to_column = ((i64::from(step) * i64::from(after)) >> S::FRACTION_BITS) as i32;
        let half = (1 << Self::DEPTH_BITS) / 2;
        let mut depth = start + half - to_column + step * (columns[0] + self.left - column);
        // The centres of columns through which the edge passes may lie beyond its ends.
        let [least, greatest] = [start.min(end), start.max(end)];
        self.mark(words, columns, face, || {
            let here = depth.max(least).min(greatest);
            depth += step;
            D::from_units(here >> Self::DEPTH_BITS)
        });
    }
}

/// The face of an edge of which a part lies in a row, as columns keep it; with `one_edge` if the part goes through the row.
#[inline(always)]
fn face<D: DepthWidth>(one_edge: u16, edge: &ActiveEdge<D>, part: &Part) -> u16 {
    let is_whole = part.height == 1 << COVER_BITS;
    (edge.face() + 1) | if is_whole { one_edge } else { 0 }
}

/// change * part / whole, rounded down, for a part of a whole that is at least 1.
#[cold]
#[inline(never)]
fn scaled(change: i32, part: i32, whole: i32) -> i32 {
    match change.checked_mul(part) {
        Some(product) => divide_floor_large(product, whole).0,
        None => divide_long(i64::from(change) * i64::from(part), whole).0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Sub4, Sub8};

    /// The most columns of a row.
    const MOST: usize = 2_100;

    /// A corner in units, with a depth in units.
    fn corner<S: ScreenPrecision, D: DepthWidth>([x, y, z]: [i32; 3]) -> ScreenVertex<S, D> {
        ScreenVertex {
            x: S::narrow(x),
            y: S::narrow(y),
            z: D::from_units(z),
        }
    }

    /// Adds an edge to all rows that it passes through, in windows of so many columns: each depth is that of the edge at the
    /// centre of the pixel, or of the end beside it. Returns how many pixels the edge passes through.
    fn check<S: ScreenPrecision, D: DepthWidth>(ends: [[i32; 3]; 2], width: usize) -> usize {
        let ([from, to], mut marked) = (ends, 0);
        let corners = [corner::<S, D>(from), corner(to), corner(from)];
        let [upper, lower] = if to[1] < from[1] { [to, from] } else { [from, to] };
        let row_of = |units: i32| (units + (1 << S::FRACTION_BITS) / 2) >> S::FRACTION_BITS;
        let [first, last] = [from[0].min(to[0]), from[0].max(to[0])].map(row_of);
        for y in row_of(upper[1])..=row_of(lower[1]) {
            for left in (first - 1..=last + 1).step_by(width) {
                let edge = ActiveEdge::new::<S>([&corners[0], &corners[1]], (0, 0), [false, true], left);
                let mut columns = [EdgeColumn::<u16, D>::EMPTY; MOST];
                let mut row = EdgeRow::new(&mut columns, width, [left, y]);
                let [top, bottom] = row.sides::<S>();
                if edge.last() <= top || upper[1] >= bottom {
                    continue;
                }
                row.add_once(&[0; MOST], &edge, |_| Some(corners.each_ref()));
                for (column, entry) in (left..).zip(&columns).take(width).filter(|(_, entry)| entry.face != 0) {
                    let part = f64::from((column << S::FRACTION_BITS) - from[0]) / f64::from(to[0] - from[0]);
                    let exact = f64::from(from[2]) + f64::from(to[2] - from[2]) * part.clamp(0.0, 1.0);
                    let found = f64::from(entry.depth.units());
                    // A unit, and what a step is rounded by in all columns.
                    let most = 1.0 + f64::from(last - first) / f64::from(1 << (D::FRACTION_BITS - 2));
                    assert!(
                        (found - exact).abs() <= most,
                        "{ends:?}: {found} at column {column} of row {y}, not {exact}"
                    );
                    marked += 1;
                }
            }
        }
        marked
    }

    /// Flat and steep slopes of depths, in both directions, by rows of many columns and of few.
    #[test]
    fn a_nearly_level_edge_has_the_depth_of_each_column() {
        for (ends, pixels) in [
            ([[0, 3, 300], [5_120, 40, 150]], 320),
            ([[15, 3, 65_000], [281, 9, 100]], 18),
            ([[281, 3, 65_000], [15, 40, 100]], 18),
            ([[9, -3, 1], [16_000, 200, 65_535]], 1_000),
            ([[15_999, -3, 1], [-16_001, 9_000, 65_535]], 2_000),
        ] {
            let [from, to] = ends;
            for ends in [ends, [to, from]] {
                for width in [MOST, 7] {
                    let marked = check::<Sub4, u16>(ends, width);
                    assert!(marked >= pixels, "{marked} pixels of {ends:?}");
                    check::<Sub4, u32>(ends.map(|[x, y, z]| [x, y, z << 8]), width);
                    check::<Sub8, u16>(ends.map(|[x, y, z]| [x << 4, y << 4, z]), width);
                    check::<Sub8, u32>(ends.map(|[x, y, z]| [x << 4, y << 4, z << 8]), width);
                }
            }
        }
    }
}
