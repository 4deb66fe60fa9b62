//! How a picture goes on from row to row: the active list of the items that the row meets.
//!
//! ```text
//!   buckets by first row            the active list, in painter's order, before and after row 7
//!   row 6   -> item 2               item 0 -> item 2 -> item 5
//!   row 7   -> item 1 -> item 4     item 0 -> item 1 -> item 2 -> item 4        item 5 has ended, 1 and 4 begin
//! ```
//!
//! A row at which all cursors are links the items of its bucket in and draws. Any other band begins anew: each item of the picture
//! is looked at once, and is put into the bucket of its first row, or into the list where it has begun.
//!
//! Source: the y-bucket table and the active list of scan-line algorithms (Wylie, Romney, Evans and Erdahl 1967).

use crate::{
    band::Band,
    draw::picture::{
        item::{NONE, PictureItem, PictureSlot},
        picture::{ItemMemory, NEVER_QUIET, Picture},
        pool::Pool,
    },
    geometry::{Window, offset_from},
    surface::{BandColor, Order, Target},
};

/// Whether columns can be counted from a band's first one: from -2^30 to 2^30 - 1. Bands that begin elsewhere show nothing: no item
/// is so far to the right, and from so far to the left only a row of more than 2^30 pixels would reach an item.
#[inline]
const fn is_near(left: i32) -> bool {
    -(1 << 30) <= left && left < 1 << 30
}

impl<'m, 'a, C: BandColor, O: Order> Picture<'m, 'a, C, O> {
    /// Draws what the band shows of the picture.
    // Inlined: in bands of one row a dashboard takes 2 % fewer cycles (Cortex-M4).
    #[inline]
    pub fn draw(&mut self, band: &mut Band<'_, C, O>) {
        let window = band.window();
        let is_row = window.left < window.right && offset_from(window.top, window.bottom) == 1;
        let goes_on = is_row && self.is_next(&window);
        if !goes_on || window.top >= i32::from(self.next_event) && !self.open_row(&window) {
            return self.draw_any(band);
        }
        self.next_row = window.bottom;
        self.for_each_active(|slot, kind, pool| kind.draw_row(slot, pool, band));
    }

    /// Whether cursors are at the first row of a window, those of all items that may lie in its columns.
    #[inline]
    fn is_next(&self, window: &Window) -> bool {
        // The columns with cursors are near.
        window.top == self.next_row && self.cursors.left <= window.left && window.right <= self.cursors.right
    }

    /// Whether cursors are at the first row of a window, those of all items that may lie in it.
    fn goes_on(&self, window: &Window) -> bool {
        self.is_next(window) && window.bottom <= self.cursors.bottom
    }

    /// Links the items that begin in the row that comes next, and takes those out that end above it. `false` where some items
    /// have no cursor there, or the row has no bucket of its own.
    #[inline(never)]
    fn open_row(&mut self, window: &Window) -> bool {
        let row = window.top;
        if self.draw_groups.is_some() || window.bottom > self.cursors.bottom {
            return false;
        }
        let Some(first) = self.buckets.of_one_row(row) else {
            return false;
        };
        if self.next_end <= row {
            self.take_out_ended(row);
        }
        if first != NONE {
            self.begin(first, row);
        }
        // No item begins or ends in rows that do not fit.
        let next_event = self.buckets.next_begin(row, self.next_end.min(self.cursors.bottom));
        self.next_event = next_event.clamp(i16::MIN.into(), i16::MAX.into()) as i16;
        true
    }

    /// Draws a band of any rows.
    #[inline(never)]
    fn draw_any(&mut self, band: &mut Band<'_, C, O>) {
        if let Some(draw) = self.draw_groups {
            return draw(self, band);
        }
        if self.go_to(&band.window()) {
            self.for_each_active(|slot, kind, pool| kind.draw_rows(slot, pool, band));
        }
    }

    /// Makes the items active that a window may show; `false` where it shows none.
    pub(super) fn go_to(&mut self, window: &Window) -> bool {
        // Rows above those that fit 16 bits show nothing.
        if window.is_empty() || !is_near(window.left) || window.bottom <= i32::from(NEVER_QUIET) {
            return false;
        }
        let is_first = !self.goes_on(window);
        if is_first {
            self.restart(window);
        } else if self.next_end <= window.top {
            self.take_out_ended(window.top);
        }
        for bucket in self.buckets.opened_by(window.top..window.bottom, is_first) {
            match self.buckets.list(bucket) {
                Some(first) if first != NONE => self.begin(first, window.top),
                _ => {}
            }
        }
        self.next_row = window.bottom;
        self.next_event = NEVER_QUIET;
        true
    }

    /// The first active item, and the memory with which items are drawn.
    pub(super) fn active_items(&mut self) -> (u16, ItemMemory<'_, 'm, 'a, C, O>) {
        let memory = ItemMemory {
            slots: self.slots,
            pool: &mut self.pool,
            group_rows: self.group_rows,
        };
        (self.active, memory)
    }

    /// Calls with the slot and the kind of each active item.
    #[inline]
    fn for_each_active(
        &mut self,
        mut call: impl FnMut(&mut PictureSlot<'a, C, O>, &'a dyn PictureItem<C, O>, &mut Pool<'m>),
    ) {
        // In variables of their own, because what is called could change what lies in `self`.
        let (slots, pool) = (&mut *self.slots, &mut self.pool);
        let mut index = self.active;
        while let Some(slot) = slots.get_mut(usize::from(index)) {
            index = slot.next;
            // What is in the list is drawn somehow: `restart` leaves out what is not.
            let Some(kind) = slot.kind else { break };
            call(slot, kind, pool);
        }
    }

    /// Puts the items that begin in the first row of a window or below into their buckets, and those that are met already
    /// into the active list. Items beside the window are left out: what is drawn next lies in its columns, mostly.
    #[inline(never)]
    fn restart(&mut self, window: &Window) {
        let row = window.top;
        self.cursors = if self.announced.intersection(window) == *window {
            self.announced
        } else {
            // To the last row.
            Window {
                bottom: i32::MAX,
                ..*window
            }
        };
        let cursors = Window {
            top: row,
            ..self.cursors
        };
        self.buckets.empty();
        self.pool.memory().free_all();
        self.active = NONE;
        self.next_end = i32::MAX;
        let mut index = self.len as u16;
        let slots = self.slots.get_mut(..self.len).unwrap_or_default();
        for slot in slots.iter_mut().rev() {
            index -= 1;
            let (first, end) = (i32::from(slot.extent.first), i32::from(slot.extent.end));
            let Some(kind) = slot.kind else { continue };
            let (left, right) = slot.extent.columns();
            let is_cut = left < cursors.left || cursors.right < right;
            if end <= row || slot.extent.is_empty() || is_cut && !kind.may_meet(slot, &self.pool, &cursors) {
                continue;
            }
            let bucket = if first < row { None } else { self.buckets.head_of(first) };
            // From the last item to the first one, each before those that come after it.
            if let Some(head) = bucket {
                slot.next = *head;
                *head = index;
                continue;
            }
            slot.next = self.active;
            self.active = index;
            self.next_end = self.next_end.min(end);
            kind.enter(slot, &mut self.pool, first.max(row));
        }
    }

    /// Links the items of a bucket into the active list, of which both are in painter's order.
    #[inline(never)]
    fn begin(&mut self, mut new: u16, row: i32) {
        let (mut before, mut index) = (NONE, self.active);
        while let Some(slot) = self.slots.get_mut(usize::from(new)) {
            if new > index {
                before = index;
                index = self.slots.get(usize::from(index)).map_or(NONE, |slot| slot.next);
                continue;
            }
            let next = slot.next;
            slot.next = index;
            self.next_end = self.next_end.min(slot.extent.end.into());
            if let Some(kind) = slot.kind {
                kind.enter(slot, &mut self.pool, i32::from(slot.extent.first).max(row));
            }
            self.link(before, new);
            (before, new) = (new, next);
        }
    }

    /// Takes the items that end above a row out of the active list.
    #[inline(never)]
    fn take_out_ended(&mut self, row: i32) {
        let (mut before, mut index) = (NONE, self.active);
        self.next_end = i32::MAX;
        while let Some(slot) = self.slots.get(usize::from(index)) {
            let (next, end) = (slot.next, i32::from(slot.extent.end));
            if end <= row {
                self.link(before, next);
            } else {
                self.next_end = self.next_end.min(end);
                before = index;
            }
            index = next;
        }
    }

    /// Makes an item the one after another in the active list, or the first one.
    #[inline]
    fn link(&mut self, before: u16, index: u16) {
        match self.slots.get_mut(usize::from(before)) {
            Some(slot) => slot.next = index,
            None => self.active = index,
        }
    }
}
