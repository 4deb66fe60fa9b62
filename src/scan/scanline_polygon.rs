//! Scan-line conversion of polygons (Wylie et al. 1967; Foley, van Dam et al. 1990, section 3.6): concave,
//! self-crossing, with holes, under both fill rules.
//!
//! Promises: each pixel at most once, whatever overlaps; a pixel belongs by the winding number of its centre, and on an
//! edge by the top-left rule. Cost: about a dozen instructions for each edge that crosses a row, besides `emit`.

use heapless::VecView;

use crate::{
    geometry::Window,
    scan::{ActiveEdge, Part, ScanEdge, active_edge_table},
    target::Span,
};

/// Which winding numbers are inside.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FillRule {
    /// Odd ones: what is surrounded twice is a hole.
    #[default]
    EvenOdd,
    /// All but 0: only what is surrounded as often leftwards as rightwards is a hole.
    NonZero,
}

impl FillRule {
    /// Whether that winding number is inside.
    pub const fn includes(self, winding: i32) -> bool {
        match self {
            Self::EvenOdd => winding & 1 != 0,
            Self::NonZero => winding != 0,
        }
    }
}

/// Which pixels the stroke takes of those near the outline.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum StrokePlace {
    /// All.
    Everywhere,
    /// Those of the inside.
    Inside,
    /// Those of the outside.
    Outside,
}

/// How often a pixel is surrounded.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Windings {
    /// By the shape.
    pub fill: i32,
    /// By its stroke.
    pub stroke: i32,
}

impl Windings {
    /// To the right of an edge.
    #[inline(always)]
    pub fn cross<G: ScanEdge>(&mut self, edge: &G) {
        let (fill, stroke) = edge.windings();
        self.fill = self.fill.wrapping_add(i32::from(fill));
        self.stroke = self.stroke.wrapping_add(i32::from(stroke));
    }
}

/// What winding numbers mean.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PartRule {
    /// Which of the shape's are inside.
    pub fill_rule: FillRule,
    /// Which of the stroke's pixels it takes.
    pub stroke_place: StrokePlace,
}

impl PartRule {
    /// A shape without a stroke.
    pub const fn fill(fill_rule: FillRule) -> Self {
        Self {
            fill_rule,
            stroke_place: StrokePlace::Everywhere,
        }
    }

    /// What a pixel inside or outside the shape, and on its stroke or not, belongs to.
    fn part(&self, inside: bool, on_stroke: bool) -> Option<Part> {
        let stroked = on_stroke
            && match self.stroke_place {
                StrokePlace::Everywhere => true,
                StrokePlace::Inside => inside,
                StrokePlace::Outside => !inside,
            };
        if stroked {
            Some(Part::Stroke)
        } else {
            inside.then_some(Part::Fill)
        }
    }
}

/// A [`PartRule`] as a table: found once a shape, looked up at every edge.
struct PartTable {
    fill_mask: i32,
    outside: [Option<Part>; 2],
    inside: [Option<Part>; 2],
}

impl PartTable {
    fn new(rule: PartRule) -> Self {
        Self {
            fill_mask: match rule.fill_rule {
                FillRule::EvenOdd => 1,
                FillRule::NonZero => -1,
            },
            outside: [false, true].map(|on_stroke| rule.part(false, on_stroke)),
            inside: [false, true].map(|on_stroke| rule.part(true, on_stroke)),
        }
    }

    #[inline(always)]
    fn part(&self, windings: Windings) -> Option<Part> {
        let [off_stroke, on_stroke] = if windings.fill & self.fill_mask != 0 {
            self.inside
        } else {
            self.outside
        };
        if windings.stroke != 0 { on_stroke } else { off_stroke }
    }
}

/// Hands over the visible spans of a sorted edge table, top to bottom and left to right in each row.
///
/// `left_of_window` is the winding numbers of what lies left of the window and has no edges in the table. The active
/// table has room for every edge that crosses one row.
///
/// # Errors
/// The first of `emit`.
pub fn scan<G: ScanEdge, E>(
    edges: &[G],
    active: &mut VecView<ActiveEdge>,
    left_of_window: Windings,
    rule: PartRule,
    window: &Window,
    mut emit: impl FnMut(Span, Part) -> Result<(), E>,
) -> Result<(), E> {
    let rule = PartTable::new(rule);
    let Some(first_row) = edges.first().map(|edge| edge.first_row().max(window.top)) else {
        // Only what surrounds the whole window.
        if let Some(part) = rule.part(left_of_window) {
            for y in window.top..window.bottom {
                emit(Span::new(y, window.left, window.right), part)?;
            }
        }
        return Ok(());
    };
    if window.is_empty() || first_row >= window.bottom {
        return Ok(());
    }
    let mut next = active_edge_table::begin(active, edges, first_row);
    let mut y = first_row;
    loop {
        row(edges, active, left_of_window, &rule, y, window, &mut emit)?;
        y = y.wrapping_add(1);
        if y >= window.bottom || (active.is_empty() && next >= edges.len()) {
            return Ok(());
        }
        active_edge_table::advance(active, edges, &mut next, y);
    }
}

#[inline(always)]
fn row<G: ScanEdge, E>(
    edges: &[G],
    active: &VecView<ActiveEdge>,
    left_of_window: Windings,
    rule: &PartTable,
    y: i32,
    window: &Window,
    emit: &mut impl FnMut(Span, Part) -> Result<(), E>,
) -> Result<(), E> {
    let mut windings = left_of_window;
    let mut part = rule.part(windings);
    let mut start = window.left;
    for crossed in active {
        let Some(edge) = edges.get(crossed.edge) else { continue };
        windings.cross(edge);
        let next_part = rule.part(windings);
        if next_part == part {
            continue;
        }
        let end = crossed.crossing.x.min(window.right);
        if end > start {
            if let Some(part) = part {
                emit(Span::new(y, start, end), part)?;
            }
            start = end;
        }
        part = next_part;
    }
    match part {
        Some(part) if window.right > start => emit(Span::new(y, start, window.right), part),
        _ => Ok(()),
    }
}
