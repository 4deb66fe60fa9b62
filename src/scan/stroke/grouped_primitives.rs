//! Primitives of a stroke in groups that share no pixel, so that each group can be drawn by itself.
//!
//! Guarantees: every primitive that reaches the window is in exactly one group of a band, and primitives of different
//! groups share no pixel. Groups are found by the pixels around each primitive: those that overlap are together, but for
//! primitives in one row, which lie apart anyway. Bands are halved until their primitives fit a table, and down to a row
//! where one of them is drawn row by row; a single row with more of them is one group.
//!
//! Cost: two runs of the primitives for each band, one more for each group of many edges, or whose primitives do not follow
//! on each other, and a comparison of four numbers for every two primitives in a band.

use heapless::Vec;

use crate::{
    geometry::Window,
    scan::{
        polygon::{banded_polygon::EdgeSource, bisection::Bisection},
        stroke::stroke_edge::StrokeEdge,
    },
};

/// Primitives in the table: about 1 KB of stack.
const TABLE: usize = 32;
/// Edges of a group that are kept: 1 KB more.
const EDGES: usize = 32;

/// The row of primitives, such as dashes along a segment, that one belongs to: primitives of one row share no pixel, although
/// the boxes around them may overlap.
pub(crate) type Row = (usize, usize);

/// A primitive: the pixels around it, its row if it has one, and its edges.
pub(crate) struct EdgedPrimitive<'a> {
    pub(crate) around: Window,
    pub(crate) row: Option<Row>,
    /// Whether it generates edges for windows of one row only.
    pub(crate) is_row_by_row: bool,
    pub edges: &'a EdgeSource<'a, StrokeEdge>,
}

/// Generates the primitives near a window, the same ones in the same order every time; primitives further away are allowed.
pub(crate) type PrimitiveSource<'a> = dyn Fn(&Window, &mut dyn FnMut(&EdgedPrimitive<'_>)) + 'a;

/// Draws the edges of a group in a window.
type Fill<'a> = dyn FnMut(&EdgeSource<'_, StrokeEdge>, &Window) + 'a;

/// A primitive as the table has it.
struct Entry {
    around: Window,
    row: Option<Row>,
    /// The number of the first primitive of its group.
    group: usize,
    /// Whether the group is drawn; only the entry of the group's first primitive knows.
    is_drawn: bool,
}

impl Entry {
    fn may_meet(&self, other: &Self) -> bool {
        let are_of_one_row = self.row.is_some() && self.row == other.row;
        !are_of_one_row && !self.around.intersection(&other.around).is_empty()
    }
}

/// Calls `fill` with each group of primitives and the window in which it is to be drawn.
pub(crate) fn each_group(primitives: &PrimitiveSource<'_>, window: &Window, fill: &mut Fill<'_>) {
    let mut bands = Bisection::new(window);
    while let Some(band) = bands.next_band() {
        let mut entries = Vec::<Entry, TABLE>::new();
        let (mut fits, mut is_row_by_row) = (true, false);
        each_near(primitives, &band, &mut |number, around, primitive| {
            is_row_by_row |= primitive.is_row_by_row;
            let entry = Entry {
                around,
                row: primitive.row,
                group: number,
                is_drawn: false,
            };
            fits &= entries.push(entry).is_ok();
        });
        fits &= !is_row_by_row || band.height() == 1;
        if fits {
            join(&mut entries);
            draw_groups(primitives, &band, &mut entries, fill);
        } else if band.height() > 1 {
            bands.halve(&band);
            continue;
        } else {
            fill(
                &|part, sink| primitives(part, &mut |primitive| (primitive.edges)(part, sink)),
                &band,
            );
        }
        bands.done(&band, entries.len() <= TABLE / 2 && !is_row_by_row);
    }
}

/// Numbers the primitives that reach a band, each with the pixels around it there.
fn each_near(
    primitives: &PrimitiveSource<'_>,
    band: &Window,
    call: &mut dyn FnMut(usize, Window, &EdgedPrimitive<'_>),
) {
    let mut number = 0usize;
    primitives(band, &mut |primitive| {
        let around = primitive.around.intersection(band);
        if !around.is_empty() {
            call(number, around, primitive);
            number += 1;
        }
    });
}

/// Puts primitives that may share a pixel into the same group.
fn join(entries: &mut [Entry]) {
    for end in 1..entries.len() {
        let Some((newest, before)) = entries.get_mut(..=end).and_then(<[Entry]>::split_last_mut) else {
            return;
        };
        for index in 0..before.len() {
            let joined = match before.get(index) {
                Some(entry) if entry.group != newest.group && entry.may_meet(newest) => entry.group,
                _ => continue,
            };
            let (kept, replaced) = (joined.min(newest.group), joined.max(newest.group));
            newest.group = kept;
            for entry in before.iter_mut().filter(|entry| entry.group == replaced) {
                entry.group = kept;
            }
        }
    }
}

/// The edges of a group whose primitives follow on each other, while they fit.
#[derive(Default)]
struct Gathered {
    group: usize,
    fits: bool,
    edges: Vec<StrokeEdge, EDGES>,
}

impl Gathered {
    /// Adds a primitive. Returns whether all primitives of its group so far are in.
    fn add(&mut self, number: usize, group: usize, window: &Window, primitive: &EdgedPrimitive<'_>) -> bool {
        if number == group {
            self.edges.clear();
            (self.group, self.fits) = (group, true);
        }
        if self.group != group || !self.fits {
            return false;
        }
        (primitive.edges)(window, &mut |edge| self.fits &= self.edges.push(edge).is_ok());
        self.fits
    }
}

/// The smallest window around the pixels of a group.
fn window_of(entries: &[Entry], group: usize) -> Option<Window> {
    let members = entries.iter().filter(|entry| entry.group == group);
    members.map(|entry| entry.around).reduce(|one, other| Window {
        left: one.left.min(other.left),
        top: one.top.min(other.top),
        right: one.right.max(other.right),
        bottom: one.bottom.max(other.bottom),
    })
}

/// Draws every group of primitives that is not drawn yet.
fn draw_groups(primitives: &PrimitiveSource<'_>, band: &Window, entries: &mut [Entry], fill: &mut Fill<'_>) {
    let mut gathered = Gathered::default();
    each_near(primitives, band, &mut |number, around, primitive| {
        let Some(group) = entries.get(number).map(|entry| entry.group) else {
            return;
        };
        let later = number + 1..;
        let is_last = entries
            .get(later)
            .unwrap_or_default()
            .iter()
            .all(|entry| entry.group != group);
        if number == group && is_last {
            fill(primitive.edges, &around);
        } else if let Some(window) = window_of(entries, group) {
            if !gathered.add(number, group, &window, primitive) || !is_last {
                return;
            }
            fill(&|_, sink| gathered.edges.iter().for_each(|&edge| sink(edge)), &window);
        }
        if let Some(first) = entries.get_mut(group) {
            first.is_drawn = true;
        }
    });
    for (first, entry) in entries.iter().enumerate() {
        // Too many edges, or primitives of others in between.
        let is_left = entry.group == first && !entry.is_drawn;
        if let Some(window) = window_of(entries, first).filter(|_| is_left) {
            let members = |call: &mut dyn FnMut(usize, &EdgedPrimitive<'_>)| {
                each_near(primitives, band, &mut |number, _, primitive| {
                    if entries.get(number).is_some_and(|entry| entry.group == first) {
                        call(number, primitive);
                    }
                });
            };
            let mut fits = false;
            members(&mut |number, primitive| fits = gathered.add(number, first, &window, primitive));
            if fits {
                fill(&|_, sink| gathered.edges.iter().for_each(|&edge| sink(edge)), &window);
            } else {
                fill(
                    &|part, sink| members(&mut |_, primitive| (primitive.edges)(part, sink)),
                    &window,
                );
            }
        }
    }
}
