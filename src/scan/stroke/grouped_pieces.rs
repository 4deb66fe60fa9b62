//! Pieces of a stroke in groups that share no pixel, so that each group can be drawn by itself.
//!
//! Guarantees: every piece that reaches the window is in exactly one group of a band, and pieces of different groups share no
//! pixel. Groups are found by the pixels around each piece: those that overlap are together, but for pieces in one row, which
//! lie apart anyway. Bands are halved until their pieces fit a table, and down to a row where one of them is drawn row by
//! row; a single row with more of them is one group.
//!
//! Cost: two runs of the pieces for each band, one more for each group of many edges, or whose pieces do not follow on each
//! other, and a comparison of four numbers for every two pieces in a band.

use heapless::Vec;

use crate::{
    geometry::Window,
    scan::{
        polygon::{banded_polygon::EdgeSource, bands::Bands},
        stroke::stroke_edge::StrokeEdge,
    },
};

/// Pieces in the table: about 1 KB of stack.
const TABLE: usize = 32;
/// Edges of a group that are kept: 1 KB more.
const EDGES: usize = 32;

/// Which pieces lie apart from each other though the pixels around them may overlap: those of the same row.
pub(crate) type Row = (usize, usize);

/// A piece: the pixels around it, its row if it has one, and its edges.
pub(crate) struct EdgedPiece<'a> {
    pub(crate) around: Window,
    pub(crate) row: Option<Row>,
    /// Whether it generates edges for windows of one row only.
    pub(crate) is_row_by_row: bool,
    pub edges: &'a EdgeSource<'a, StrokeEdge>,
}

/// Generates the pieces near a window, the same ones in the same order every time; pieces further away are allowed.
pub(crate) type PieceSource<'a> = dyn Fn(&Window, &mut dyn FnMut(&EdgedPiece<'_>)) + 'a;

/// Draws the edges of a group in a window.
type Fill<'a> = dyn FnMut(&EdgeSource<'_, StrokeEdge>, &Window) + 'a;

/// A piece as the table has it.
struct Entry {
    around: Window,
    row: Option<Row>,
    /// The number of the first piece of its group.
    group: usize,
    /// Whether the group is drawn; only the entry of the group's first piece knows.
    is_drawn: bool,
}

impl Entry {
    fn may_meet(&self, other: &Self) -> bool {
        let is_apart = self.row.is_some() && self.row == other.row;
        !is_apart && !self.around.intersection(&other.around).is_empty()
    }
}

/// Calls with each group of pieces and the window that it is to be drawn in.
pub(crate) fn each_group(pieces: &PieceSource<'_>, window: &Window, fill: &mut Fill<'_>) {
    let mut bands = Bands::new(window);
    while let Some(band) = bands.next_band() {
        let mut entries = Vec::<Entry, TABLE>::new();
        let (mut fits, mut is_row_by_row) = (true, false);
        each_near(pieces, &band, &mut |number, around, piece| {
            is_row_by_row |= piece.is_row_by_row;
            let entry = Entry {
                around,
                row: piece.row,
                group: number,
                is_drawn: false,
            };
            fits &= entries.push(entry).is_ok();
        });
        fits &= !is_row_by_row || band.height() == 1;
        if fits {
            join(&mut entries);
            draw_groups(pieces, &band, &mut entries, fill);
        } else if band.height() > 1 {
            bands.halve(&band);
            continue;
        } else {
            fill(
                &|part, sink| pieces(part, &mut |piece| (piece.edges)(part, sink)),
                &band,
            );
        }
        bands.done(&band, entries.len() <= TABLE / 2 && !is_row_by_row);
    }
}

/// Numbers the pieces that reach a band, each with the pixels around it there.
fn each_near(pieces: &PieceSource<'_>, band: &Window, call: &mut dyn FnMut(usize, Window, &EdgedPiece<'_>)) {
    let mut number = 0usize;
    pieces(band, &mut |piece| {
        let around = piece.around.intersection(band);
        if !around.is_empty() {
            call(number, around, piece);
            number = number.wrapping_add(1);
        }
    });
}

/// Puts pieces that may share a pixel into the same group.
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

/// The edges of a group whose pieces follow on each other, while they fit.
#[derive(Default)]
struct Gathered {
    group: usize,
    fits: bool,
    edges: Vec<StrokeEdge, EDGES>,
}

impl Gathered {
    /// Adds a piece. Returns whether all pieces of its group so far are in.
    fn add(&mut self, number: usize, group: usize, window: &Window, piece: &EdgedPiece<'_>) -> bool {
        if number == group {
            self.edges.clear();
            (self.group, self.fits) = (group, true);
        }
        if self.group != group || !self.fits {
            return false;
        }
        (piece.edges)(window, &mut |edge| self.fits &= self.edges.push(edge).is_ok());
        self.fits
    }
}

/// Around the pixels of a group.
fn window_of(entries: &[Entry], group: usize) -> Option<Window> {
    let members = entries.iter().filter(|entry| entry.group == group);
    members.map(|entry| entry.around).reduce(|one, other| Window {
        left: one.left.min(other.left),
        top: one.top.min(other.top),
        right: one.right.max(other.right),
        bottom: one.bottom.max(other.bottom),
    })
}

/// Draws every group.
fn draw_groups(pieces: &PieceSource<'_>, band: &Window, entries: &mut [Entry], fill: &mut Fill<'_>) {
    let mut gathered = Gathered::default();
    each_near(pieces, band, &mut |number, around, piece| {
        let Some(group) = entries.get(number).map(|entry| entry.group) else {
            return;
        };
        let later = number.wrapping_add(1)..;
        let is_last = entries
            .get(later)
            .unwrap_or_default()
            .iter()
            .all(|entry| entry.group != group);
        if number == group && is_last {
            fill(piece.edges, &around);
        } else if let Some(window) = window_of(entries, group) {
            if !gathered.add(number, group, &window, piece) || !is_last {
                return;
            }
            fill(&|_, sink| gathered.edges.iter().for_each(|&edge| sink(edge)), &window);
        }
        if let Some(first) = entries.get_mut(group) {
            first.is_drawn = true;
        }
    });
    for (first, entry) in entries.iter().enumerate() {
        // Too many edges, or pieces of others in between.
        let is_left = entry.group == first && !entry.is_drawn;
        if let Some(window) = window_of(entries, first).filter(|_| is_left) {
            let members = |call: &mut dyn FnMut(usize, &EdgedPiece<'_>)| {
                each_near(pieces, band, &mut |number, _, piece| {
                    if entries.get(number).is_some_and(|entry| entry.group == first) {
                        call(number, piece);
                    }
                });
            };
            let mut fits = false;
            members(&mut |number, piece| fits = gathered.add(number, first, &window, piece));
            if fits {
                fill(&|_, sink| gathered.edges.iter().for_each(|&edge| sink(edge)), &window);
            } else {
                fill(
                    &|part, sink| members(&mut |_, piece| (piece.edges)(part, sink)),
                    &window,
                );
            }
        }
    }
}
