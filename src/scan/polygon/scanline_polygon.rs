//! Scan-line conversion of polygons (Wylie et al. 1967; Foley, van Dam et al. 1990, section 3.6): concave,
//! self-crossing, with holes, under both fill rules.
//!
//! ```text
//!         /\      /\           The edge table has all edges in order by their first row. Going down, an edge moves from there
//!      a /  \b  c/  \ d       to the active edge table in its first row, and leaves that after its last one. In each row the
//!   ----x####x--x####x----    active edges are in order by x. From left to right, each adds 1 to the winding number if it
//!      /      \/      \       runs down, or else takes 1 away; up to the next edge, pixels are filled where the fill rule
//!     /________________\      includes that number. From row to row an edge's x moves by a quotient with an error term.
//! ```
//!
//! Guarantees: each pixel at most once, whatever overlaps; a pixel belongs by the winding number of its centre, and on an
//! edge by the top-left rule. Cost: about 30 instructions for each edge that crosses a row, besides `emit`.

use embedded_graphics::primitives::StrokeAlignment;
use heapless::{Vec, VecView};

use crate::{
    geometry::{DrawError, TooSmall, Vertex, Window},
    scan::polygon::{
        active_edge_table::{self, ActiveEdge},
        edge::{Edge, Part, ScanEdge},
        edge_table,
        polygons::Polygons,
    },
    surface::Span,
};

/// Which winding numbers are inside.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use zrow::draw::{FillRule, Polygon, PrimitiveStyle};
///
/// // Both contours run clockwise, so that the inner one is surrounded twice.
/// let outer = [Point::new(0, 0), Point::new(8, 0), Point::new(8, 4), Point::new(0, 4)];
/// let inner = [Point::new(2, 1), Point::new(6, 1), Point::new(6, 3), Point::new(2, 3)];
/// let contours: [&[Point]; 2] = [&outer, &inner];
/// for (rule, row) in [(FillRule::EvenOdd, "##    ##"), (FillRule::NonZero, "########")] {
///     let mut display = MockDisplay::new();
///     let polygon = Polygon::new(&contours, rule).prepare::<4, 4>()?;
///     let Ok(()) = polygon.into_styled(PrimitiveStyle::with_fill(BinaryColor::On)).draw(&mut display);
///     display.assert_pattern(&["########", row, row, "########"]);
/// }
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FillRule {
    /// Odd winding numbers are inside: an area that is surrounded twice is a hole.
    #[default]
    EvenOdd,
    /// All winding numbers but 0 are inside: only what is surrounded as often leftwards as rightwards is a hole.
    NonZero,
}

impl FillRule {
    /// Whether a winding number is inside.
    pub const fn includes(self, winding: i32) -> bool {
        match self {
            Self::EvenOdd => winding & 1 != 0,
            Self::NonZero => winding != 0,
        }
    }
}

/// The winding numbers of a pixel: how often outlines surround it, clockwise counted up and the other way down.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Windings {
    /// Winding number in the outline of the shape.
    pub fill: i32,
    /// Winding number in the outline of the shape's stroke.
    pub stroke: i32,
}

impl Windings {
    /// Turns the winding numbers left of an edge into those right of it.
    #[inline]
    pub fn cross<G: ScanEdge>(&mut self, edge: &G) {
        let (fill, stroke) = edge.windings();
        self.fill += i32::from(fill);
        self.stroke += i32::from(stroke);
    }
}

/// Which part of a shape, its fill or its stroke, a pixel with given winding numbers is drawn as.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PartRule {
    /// Which winding numbers in the outline of the shape are inside it.
    pub fill_rule: FillRule,
    /// Which pixels of the stroke are drawn: those inside of the shape, those outside, or all (`Center`).
    pub stroke_alignment: StrokeAlignment,
}

impl PartRule {
    /// The rule of a shape that is filled and has no stroke.
    pub const fn fill(fill_rule: FillRule) -> Self {
        Self {
            fill_rule,
            stroke_alignment: StrokeAlignment::Center,
        }
    }

    /// The part of a shape that a pixel belongs to, from whether it is inside the shape and on its stroke.
    fn part(&self, inside: bool, on_stroke: bool) -> Option<Part> {
        let stroked = on_stroke
            && match self.stroke_alignment {
                StrokeAlignment::Center => true,
                StrokeAlignment::Inside => inside,
                StrokeAlignment::Outside => !inside,
            };
        if stroked {
            Some(Part::Stroke)
        } else {
            inside.then_some(Part::Fill)
        }
    }
}

/// A [`PartRule`] as a table of part codes, which is made once a shape and looked up at every edge.
struct PartTable {
    fill_mask: i32,
    outside: PartCodes,
    inside: PartCodes,
}

/// Two packed [`PartCode`]s: of a pixel off the stroke in the low [`CODE_BITS`] bits, of one on the stroke above them.
type PartCodes = u32;

/// What a pixel belongs to: [`NO_PART`], [`FILL`] or [`STROKE`], so that parts are compared and kept as numbers.
type PartCode = u32;

/// The code of a pixel that is not drawn.
const NO_PART: PartCode = 0;
/// The code of a pixel of the fill.
const FILL: PartCode = 1;
/// The code of a pixel of the stroke.
const STROKE: PartCode = 2;

/// The bits of a part code within [`PartCodes`].
const CODE_BITS: u32 = 8;

impl PartTable {
    fn new(rule: PartRule) -> Self {
        let code = |inside, on_stroke| match rule.part(inside, on_stroke) {
            None => NO_PART,
            Some(Part::Fill) => FILL,
            Some(Part::Stroke) => STROKE,
        };
        let codes = |inside| code(inside, false) | (code(inside, true) << CODE_BITS);
        Self {
            fill_mask: match rule.fill_rule {
                FillRule::EvenOdd => 1,
                FillRule::NonZero => -1,
            },
            outside: codes(false),
            inside: codes(true),
        }
    }

    #[inline]
    fn code(&self, windings: Windings) -> PartCode {
        let codes = if windings.fill & self.fill_mask != 0 {
            self.inside
        } else {
            self.outside
        };
        let codes = if windings.stroke != 0 {
            codes >> CODE_BITS
        } else {
            codes
        };
        codes & ((1 << CODE_BITS) - 1)
    }
}

/// The part of a shape that a part code stands for; `None` for [`NO_PART`].
#[inline]
fn part(code: PartCode) -> Option<Part> {
    match code {
        FILL => Some(Part::Fill),
        STROKE => Some(Part::Stroke),
        _ => None,
    }
}

impl Polygons {
    /// Hands over the visible spans of a polygon, top to bottom and left to right in each row, through tables of `N` edges and
    /// as many active ones on the stack: the default.
    ///
    /// [`Polygon`](crate::draw::Polygon) keeps the edges from row to row; this is what the siblings are compared with.
    ///
    /// Cost: one or two divisions an edge and a sort; then a sum and a comparison for each active edge and row. Source: Wylie,
    /// Romney, Evans and Erdahl 1967.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] with the number that would do, before anything is handed over; then the first error that `emit` returns.
    pub fn scanline<V: Vertex, E, const N: usize>(
        contours: &[&[V]],
        rule: FillRule,
        window: &Window,
        mut emit: impl FnMut(Span) -> Result<(), E>,
    ) -> Result<(), DrawError<E>> {
        let mut edges = Vec::<Edge, N>::new();
        let mut needed = 0usize;
        for contour in contours {
            let starts = contour.last().into_iter().chain(contour.iter());
            for (from, to) in starts.zip(contour.iter()) {
                if let Some(edge) = Edge::new(from, to, Part::Fill) {
                    needed += usize::from(edges.push(edge).is_err());
                }
            }
        }
        if needed > 0 {
            return Err(DrawError::TooSmall(TooSmall::Edges(needed + N)));
        }
        edge_table::sort(edges.as_mut_view());
        let mut active = Vec::<ActiveEdge<'_, Edge>, N>::new();
        let rule = PartRule::fill(rule);
        scan(
            &edges,
            active.as_mut_view(),
            Windings::default(),
            rule,
            window,
            |span, _| emit(span),
        )
        .map_err(DrawError::Target)
    }
}

/// Hands over the visible spans of a sorted edge table, top to bottom and left to right in each row.
///
/// `left_of_window` is the winding numbers of what lies left of the window and has no edges in the table. The active
/// table has room for every edge that crosses one row.
///
/// # Errors
/// The first error that `emit` returns.
pub fn scan<'e, G: ScanEdge + Copy, E>(
    edges: &'e [G],
    active: &mut VecView<ActiveEdge<'e, G>>,
    left_of_window: Windings,
    rule: PartRule,
    window: &Window,
    mut emit: impl FnMut(Span, Part) -> Result<(), E>,
) -> Result<(), E> {
    let rule = PartTable::new(rule);
    let Some(first_row) = edges.first().map(|edge| edge.first_row().max(window.top)) else {
        // Without an edge in the table, the whole window has the winding numbers left of it.
        if let Some(part) = part(rule.code(left_of_window)) {
            for y in window.top..window.bottom {
                emit(Span::new(y, window.left, window.right), part)?;
            }
        }
        return Ok(());
    };
    if window.is_empty() || first_row >= window.bottom {
        return Ok(());
    }
    active.clear();
    let mut waiting = edges;
    // Before `next_change` no edge begins or ends.
    let (mut y, mut next_change) = (first_row, first_row);
    while y < window.bottom {
        if y < next_change {
            active_edge_table::step(active, y);
        } else {
            next_change = active_edge_table::change(active, &mut waiting, y);
            if active.is_empty() && waiting.is_empty() {
                break;
            }
        }
        row(active, left_of_window, &rule, y, window, &mut emit)?;
        y += 1;
    }
    Ok(())
}

/// Hands over the visible spans of row `y`, whose active edges come from left to right.
#[inline]
fn row<G: ScanEdge, E>(
    active: &[ActiveEdge<'_, G>],
    left_of_window: Windings,
    rule: &PartTable,
    y: i32,
    window: &Window,
    emit: &mut impl FnMut(Span, Part) -> Result<(), E>,
) -> Result<(), E> {
    let mut windings = left_of_window;
    let mut code = rule.code(windings);
    let mut start = window.left;
    for crossed in active {
        windings.cross(crossed.edge);
        let next_code = rule.code(windings);
        if next_code == code {
            continue;
        }
        let end = crossed.crossing.x.min(window.right);
        if end > start {
            if let Some(part) = part(code) {
                emit(Span::new(y, start, end), part)?;
            }
            start = end;
        }
        code = next_code;
    }
    match part(code) {
        Some(part) if window.right > start => emit(Span::new(y, start, window.right), part),
        _ => Ok(()),
    }
}
