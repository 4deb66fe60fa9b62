//! What changes in a picture where an item takes the place of another one, or is added or taken out: rectangles of damage.
//!
//! The rows of an item are cut into a few parts, and in each part only the columns are recorded in which it has pixels there.
//! Of two outlines only what lies between the edges that they do not share.

use core::{num::NonZeroU32, ops::Range};

use crate::{
    draw::{
        outline::Common,
        picture::{
            damage::Damage,
            item::{Extent, ItemId, PictureSlot, Role},
            picture::Picture,
            prepare::Draft,
        },
    },
    geometry::Window,
    surface::{BandColor, Order},
};

impl<'a, C: BandColor, O: Order> Picture<'_, 'a, C, O> {
    /// Makes an item another one, whose words were appended to the pool, and records what changes.
    pub(super) fn exchange(&mut self, id: ItemId, (at, words, draft): (u16, u16, Draft<'a, C, O>)) {
        let ItemId(index) = id;
        let Some(old) = self.slots.get(usize::from(index)).copied() else {
            return;
        };
        let rows = self.rows_with(id, draft.extent);
        let is_recorded = self.damage.is_recorded() && !self.record_difference(&old, (at, words, &draft));
        if is_recorded {
            self.record(id, &rows);
        }
        let first = i32::from(draft.extent.first);
        self.take_end_out(id);
        self.put_last(id, &old, (at, words, draft));
        if is_recorded {
            self.record(id, &if rows.contains(&first) { rows } else { self.rows_of(id) });
        }
    }

    /// Makes an item another one, whose words were appended to the pool.
    pub(super) fn put_last(
        &mut self,
        id: ItemId,
        old: &PictureSlot<'a, C, O>,
        (at, words, draft): (u16, u16, Draft<'a, C, O>),
    ) {
        let at = if words == old.words {
            self.pool.move_last(old.at, words);
            old.at
        } else {
            self.take_words(old.at, old.words);
            at.saturating_sub(if at > old.at { old.words } else { 0 })
        };
        self.set(id, (at, words, draft));
    }

    /// Records what changes where words of the pool take the place of an item, if that is less than both of them; or else
    /// returns `false`.
    #[inline(never)]
    fn record_difference(
        &mut self,
        old: &PictureSlot<'a, C, O>,
        (at, words, draft): (u16, u16, &Draft<'a, C, O>),
    ) -> bool {
        let (Some(kind), Some(old_kind)) = (draft.kind, old.kind) else {
            return false;
        };
        let (old_words, new_words) = (self.pool.slice(old.at, old.words), self.pool.slice(at, words));
        let is_same_kind = core::ptr::eq(kind, old_kind) && words > 0;
        if is_same_kind && (draft.extent, draft.word) == (old.extent, old.word) && old_words == new_words {
            return true;
        }
        if [kind.role(), old_kind.role()] != [Role::Outline; 2] {
            return false;
        }
        let (mut first, mut end) = (i32::MAX, i32::MIN);
        let common = kind.changed_edges(old_words, new_words, &mut |edge, _| {
            (first, end) = (edge.first_row().min(first), edge.end_row().max(end));
        });
        let rows = first..end;
        if common == Common::Unknown || rows.is_empty() {
            return common != Common::Unknown;
        }
        let parts = self.damage.parts_of(&rows);
        // The columns in each part: of all edges where they have some in common, or else of each outline by itself.
        let mut columns = [[(i32::MAX, i32::MIN); Damage::MOST_PARTS]; 2];
        kind.changed_edges(old_words, new_words, &mut |edge, is_new| {
            let [old, new] = &mut columns;
            let columns = if is_new && common == Common::Nothing { new } else { old };
            for (part, (left, right)) in (0..parts.get()).zip(columns) {
                let rows = part_of(&rows, part, parts);
                if edge.first_row() < rows.end && rows.start < edge.end_row() {
                    let [start, end] = edge.columns_in(&rows);
                    (*left, *right) = (start.min(*left), end.max(*right));
                }
            }
        });
        for columns in columns {
            for (part, (left, right)) in (0..parts.get()).zip(columns) {
                let Range { start, end } = part_of(&rows, part, parts);
                if left < right {
                    let part = Window {
                        left,
                        top: start,
                        right,
                        bottom: end,
                    };
                    self.damage.add(part.intersection(&self.area));
                }
            }
        }
        true
    }

    /// Records the pixels of an item as changed, as it is, in some parts of these rows, one below the other. The parts
    /// are narrower where the item is slanted, and do not overlap with those of what is recorded with the same rows.
    pub(super) fn record(&mut self, ItemId(index): ItemId, rows: &Range<i32>) {
        if !self.damage.is_recorded() {
            return;
        }
        let Some(slot) = self.slots.get(usize::from(index)) else {
            return;
        };
        let Some(kind) = slot.kind else { return };
        if self.damage.covers(&slot.extent.window()) {
            return;
        }
        let parts = self.damage.parts_of(rows);
        for part in 0..parts.get() {
            let part = part_of(rows, part, parts);
            let rows = part.start.max(slot.extent.first.into())..part.end.min(slot.extent.end.into());
            if !rows.is_empty() {
                let (left, right) = kind.columns_in(slot, &self.pool, rows.clone());
                let part = Window {
                    left,
                    top: rows.start,
                    right,
                    bottom: rows.end,
                };
                self.damage.add(part.intersection(&self.area));
            }
        }
    }

    /// Records all pixels of an item as changed, by its index.
    pub(super) fn record_all(&mut self, index: usize) {
        // Indices of items fit.
        let id = ItemId(index as u16);
        self.record(id, &self.rows_of(id));
    }

    /// The rows of an item.
    pub(super) fn rows_of(&self, ItemId(index): ItemId) -> Range<i32> {
        let extent = self
            .slots
            .get(usize::from(index))
            .map_or(Extent::EMPTY, |slot| slot.extent);
        extent.first.into()..extent.end.into()
    }

    /// The rows of an item that is about to become another one, and of that other one where they overlap.
    pub(super) fn rows_with(&self, id: ItemId, other: Extent) -> Range<i32> {
        let (rows, others) = (self.rows_of(id), i32::from(other.first)..i32::from(other.end));
        if rows.start.max(others.start) < rows.end.min(others.end) {
            rows.start.min(others.start)..rows.end.max(others.end)
        } else {
            rows
        }
    }
}

/// One of so many parts of some rows.
fn part_of(rows: &Range<i32>, part: u32, parts: NonZeroU32) -> Range<i32> {
    // Rows are numbers of 16 bits, and parts are few.
    let height = (rows.end - rows.start).unsigned_abs();
    let row = |part: u32| rows.start + (height * part / parts) as i32;
    row(part)..row(part + 1)
}
