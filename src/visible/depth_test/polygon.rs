//! Planar polygons of any shape, drawn into the rows of a scene without being cut into triangles: the y table, the active
//! polygon table and active edge pairs of the scan-line z-buffer (Rogers 1985, section 4-9).
//!
//! ```text
//!       y table: edges by first row         row y:   a        b    c        d      active edges, from left to right
//!         /\          /\                    ---------+########+----+########+---   inside between a and b, c and d
//!        /  \   ____ /  \                   depth:   z, z + per_column, ...        one plane for the whole polygon
//!       a    b /    c    d
//!      /      X      \    \                 At X two edges cross: the active ones are in order by x again in the
//!     /______/ \______\____\                next row, so that other edges are a pair from there on.
//! ```
//!
//! An edge enters the active table in its first row and leaves it after its last one; from row to row its column moves by a
//! quotient with an error term. The plane of the depths is fixed once, from three corners that lie far apart, so that all
//! pixels lie on one plane, however the polygon is shaped or crosses itself.
//!
//! Guarantees: the pixels whose centres are inside the corners on the screen by the fill rule, in exact arithmetic and by the
//! top-left rule, each once; the same pixels and depths in any order of rows. Cost: a row that follows the last one drawn, two
//! additions for each active edge; any other row, a division for each edge that crosses it.
//!
//! Source: Wylie, Romney, Evans and Erdahl 1967 (edges); Myers 1975; Rogers 1985, section 4-9.

use heapless::{Vec, VecView};

use crate::{
    band::Band,
    geometry::{ScreenPlane, Window},
    scan::{
        FillRule,
        polygon::{Crossing, Edge, Part, edge_table},
    },
    surface::{BandColor, Order},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{
        DepthRow,
        active_face::from_top,
        depth_plane::DepthPlane,
        depth_test::state::{DepthState, DepthTest, Test, slope_of_face},
    },
};

/// A planar polygon of any shape, to be drawn into the rows of a scene: `row.draw_polygon(&mut polygon, color, &state)`. It may
/// be concave, have holes and cross itself; `N` is how many edges it has room for.
///
/// [`Prepared::prepare_polygon`](crate::scene::Prepared::prepare_polygon) puts a polygon into this memory, once a frame. It is
/// seen from both sides. A new one has no pixels.
///
/// Each pixel has the depth of one plane, kept between the nearest and the farthest corner. The plane goes through three
/// corners on the screen that lie far apart: the first one, the one farthest from it, and the one farthest from the line
/// through both. For a triangle that is its own plane. Other corners may lie beside it, because positions and depths of corners
/// are rounded: what depths rounded by half a unit at the three do to any pixel inside is less than four units, and what
/// rounded positions do grows with the slope.
///
/// RAM: 44 bytes for each of `N` edges, and about 40.
///
/// Source: active edges, Wylie, Romney, Evans and Erdahl 1967; a plane for each polygon, Rogers 1985, section 4-9.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DepthPolygon<D, const N: usize> {
    /// The y table: edges by their first row.
    edges: Vec<Edge, N>,
    /// The edges that cross the row above `next_row`, from left to right.
    active: Vec<ActiveEdge, N>,
    surface: Surface<D>,
    /// The edges that the rows above `next_row` have passed.
    entered: u16,
    /// The row that the active edges go on with.
    next_row: i32,
    rule: FillRule,
}

/// An edge that crosses the row that was drawn last.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct ActiveEdge {
    crossing: Crossing,
    /// The index of the edge in the y table.
    edge: u16,
}

/// The depths of a polygon.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Surface<D> {
    /// Depths with their fractional bits, from column 0 of the picture.
    plane: ScreenPlane,
    /// The depths of the farthest and of the nearest corner.
    range: [D; 2],
    /// The greatest slope, for a polygon offset.
    slope: u32,
}

impl<D: DepthWidth> Surface<D> {
    const NOTHING: Self = Self {
        plane: ScreenPlane::ZERO,
        range: [D::FARTHEST; 2],
        slope: 0,
    };

    /// The depth of a pixel inside, kept between those of the corners. What is rounded may lead a little beyond one of them,
    /// and from there past the end of 32 bits.
    #[inline]
    fn depth(&self, interpolated: u32) -> D {
        let [farthest, nearest] = self.range.map(|depth| depth.into() << (32 - 8 * size_of::<D>()));
        // The fraction that is not stored does not count as beyond.
        let nearest = nearest | ((1 << (32 - 8 * size_of::<D>())) - 1);
        let from_farthest = interpolated.wrapping_sub(farthest);
        if from_farthest <= nearest - farthest {
            return D::from_interpolated(interpolated);
        }
        let (above, below) = (interpolated.wrapping_sub(nearest), farthest.wrapping_sub(interpolated));
        D::from_interpolated(if above < below { nearest } else { farthest })
    }
}

impl<D: DepthWidth, const N: usize> DepthPolygon<D, N> {
    /// A polygon that has no edges.
    pub const fn new() -> Self {
        const { assert!(N <= u16::MAX as usize, "edges are numbered in 16 bits") }
        Self {
            edges: Vec::new(),
            active: Vec::new(),
            surface: Surface::NOTHING,
            entered: 0,
            next_row: i32::MIN,
            rule: FillRule::EvenOdd,
        }
    }

    /// The polygon as the functions that do not depend on its capacity take it, without edges from here on.
    pub(crate) fn begin(&mut self, rule: FillRule) -> PolygonTable<'_> {
        self.rule = rule;
        self.surface = Surface::NOTHING;
        self.restart();
        self.edges.clear();
        PolygonTable {
            edges: self.edges.as_mut_view(),
            needed: 0,
        }
    }

    /// Ends the polygon: sorts its edges and fixes its plane through three corners in any order, of which the depths of all
    /// corners have a range. Without an area it has no pixels.
    pub(crate) fn finish<S: ScreenPrecision>(
        &mut self,
        [a, b, c]: [ScreenVertex<S, D>; 3],
        range: [D; 2],
        viewport: &Window,
    ) {
        let area = twice_the_area([&a, &b, &c]);
        if area == 0 {
            self.edges.clear();
            return;
        }
        let clockwise = if area > 0 { [&a, &b, &c] } else { [&a, &c, &b] };
        self.surface = Surface {
            plane: DepthPlane::wide(from_top(clockwise), viewport, 0),
            range,
            slope: slope_of_face(clockwise),
        };
        edge_table::sort(self.edges.as_mut_view());
    }

    /// Takes all edges out, so that the polygon has no pixels.
    pub(crate) fn clear(&mut self) {
        self.restart();
        self.edges.clear();
    }

    /// Begins anew with the first row.
    fn restart(&mut self) {
        self.active.clear();
        self.entered = 0;
        self.next_row = i32::MIN;
    }
}

impl<D: DepthWidth, const N: usize> Default for DepthPolygon<D, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Twice the area of a triangle in square units, above 0 where its corners run clockwise on the screen.
pub(crate) fn twice_the_area<S: ScreenPrecision, D: DepthWidth>([a, b, c]: [&ScreenVertex<S, D>; 3]) -> i64 {
    let (to_b, to_c) = (b.position().minus(a.position()), c.position().minus(a.position()));
    // Differences of positions are below 2^25.
    i64::from(to_b.x) * i64::from(to_c.y) - i64::from(to_c.x) * i64::from(to_b.y)
}

/// The y table of a polygon that is being prepared.
#[derive(Debug)]
pub(crate) struct PolygonTable<'a> {
    edges: &'a mut VecView<Edge>,
    /// The edges that were added, whether there was room for them or not.
    needed: usize,
}

impl PolygonTable<'_> {
    /// Adds an edge between two positions in units, where it crosses a row of the viewport.
    pub(crate) fn add(&mut self, [from, to]: [(i32, i32); 2], fraction_bits: u32, viewport: &Window) {
        let Some(edge) = Edge::from_units(from, to, fraction_bits, Part::Fill) else {
            return;
        };
        if edge.end_row > viewport.top && edge.first_row < viewport.bottom {
            self.needed += 1;
            // Where there is no room it is only counted.
            let _ = self.edges.push(edge);
        }
    }

    /// How many edges there should be room for, where there is not enough.
    pub(crate) fn missing(&self) -> Option<usize> {
        (self.needed > self.edges.len()).then_some(self.needed)
    }
}

/// The active edges of a polygon on their way from row to row.
struct ActiveEdges<'a> {
    edges: &'a [Edge],
    active: &'a mut VecView<ActiveEdge>,
    entered: &'a mut u16,
}

impl ActiveEdges<'_> {
    /// Drops the edges that have ended above a row, and steps the others from the row before.
    fn go_on(&mut self, y: i32) {
        let edges = self.edges;
        self.active.retain_mut(|active| {
            let Some(edge) = edges.get(usize::from(active.edge)).filter(|edge| edge.end_row > y) else {
                return false;
            };
            active.crossing = edge.next_crossing(active.crossing);
            true
        });
    }

    /// Enters the edges that begin in a row, or began above it; then all are in order by column, whichever have crossed.
    fn enter(&mut self, y: i32) {
        while let Some(edge) = self.edges.get(usize::from(*self.entered)) {
            if edge.first_row > y {
                break;
            }
            if edge.end_row > y {
                let pushed = self.active.push(ActiveEdge {
                    crossing: edge.crossing_at(y),
                    edge: *self.entered,
                });
                debug_assert!(pushed.is_ok(), "there is room for all edges");
            }
            *self.entered += 1;
        }
        edge_table::insertion_sort(self.active, 1, |active| active.crossing.x);
    }

    /// Hands over the columns of each span of the row, the second one excluded, from left to right.
    fn spans(&self, rule: FillRule, mut span: impl FnMut(i32, i32)) {
        let (mut winding, mut start) = (0, 0);
        for active in self.active.iter() {
            let Some(edge) = self.edges.get(usize::from(active.edge)) else {
                continue;
            };
            let was_inside = rule.includes(winding);
            winding += i32::from(edge.fill_winding);
            match (was_inside, rule.includes(winding)) {
                (false, true) => start = active.crossing.x,
                (true, false) => span(start, active.crossing.x),
                _ => {}
            }
        }
    }
}

impl<C: BandColor, O: Order, D: DepthWidth> DepthRow<'_, C, O, D> {
    /// Draws the pixels of a polygon that are in the row and pass the test of their depths. Rows may come in any order; a row
    /// below the one that was drawn last is the cheapest.
    ///
    /// Cost: two comparisons where the polygon does not reach the row. In the row below the one before, two additions and a
    /// comparison for each edge that crosses it, and a division for each that begins there; in any other row, a division for
    /// each edge that crosses it. Then an addition and the test for each pixel.
    #[inline]
    pub fn draw_polygon<const N: usize>(&mut self, polygon: &mut DepthPolygon<D, N>, color: C, state: &DepthState<D>) {
        let DepthPolygon {
            edges,
            active,
            surface,
            entered,
            next_row,
            rule,
        } = polygon;
        if edges.first().is_none_or(|edge| edge.first_row > self.y) {
            return;
        }
        let is_next = *next_row == self.y;
        *next_row = self.y.saturating_add(1);
        let table = ActiveEdges {
            edges,
            active: active.as_mut_view(),
            entered,
        };
        self.draw_edge_pairs(table, is_next, *rule, surface, (color, state));
    }

    /// Draws the pixels between the active edges of the row, which is the one below the row that they were in, or another one.
    #[inline(never)]
    fn draw_edge_pairs(
        &mut self,
        mut table: ActiveEdges<'_>,
        is_next: bool,
        rule: FillRule,
        surface: &Surface<D>,
        (color, state): (C, &DepthState<D>),
    ) {
        if is_next {
            table.go_on(self.y);
        } else {
            table.active.clear();
            *table.entered = 0;
        }
        table.enter(self.y);
        if table.active.is_empty() {
            return;
        }
        let (word, test) = (Band::<C, O>::word(color), DepthTest::new(state, surface.slope));
        table.spans(rule, |start, end| self.draw_span_of(surface, (start, end), word, &test));
    }

    /// Draws the pixels of a span that are in the row and pass the test.
    fn draw_span_of(&mut self, surface: &Surface<D>, (start, end): (i32, i32), word: C::Word, test: &DepthTest) {
        let first = start.max(self.left);
        let end = end.min(self.left + self.words.len() as i32);
        if first >= end {
            return;
        }
        let columns = (first - self.left) as usize..(end - self.left) as usize;
        let (Some(words), Some(depths)) = (self.words.get_mut(columns.clone()), self.depths.get_mut(columns)) else {
            return;
        };
        let mut interpolated = surface.plane.at(first, self.y);
        for (shown, stored) in words.iter_mut().zip(depths) {
            let depth = test.depth(surface.depth(interpolated.0));
            if test.passes(depth, *stored) {
                *shown = word;
                if Test::<D>::writes(test) {
                    *stored = depth;
                }
            }
            interpolated += surface.plane.per_column;
        }
    }
}
