//! The first changes of an edge in order, as many as there is room for.

use core::mem::swap;

use crate::visible::hidden_lines::appel::exact::Change;

/// The first changes of an edge from a parameter on, in ascending order. Those at one parameter are one change.
#[derive(Debug)]
pub(super) struct Changes<'c> {
    slots: &'c mut [Change],
    used: usize,
    /// The least parameter of changes that count.
    from: u32,
    /// Whether changes found no room, which all have greater parameters than those that did.
    are_more: bool,
    /// The sum of all changes, whether they found room or not.
    pub(super) sum: i32,
}

impl<'c> Changes<'c> {
    /// No changes, in some slots. Those below a parameter will be left out.
    pub(super) fn new(slots: &'c mut [Change], from: u32) -> Self {
        Self {
            slots,
            used: 0,
            from,
            are_more: false,
            sum: 0,
        }
    }

    /// The first changes.
    pub(super) fn first(&self) -> &[Change] {
        self.slots.get(..self.used).unwrap_or_default()
    }

    /// The parameter from which on more changes follow those that found room; `None` where none follow.
    pub(super) fn next(&self) -> Option<u32> {
        let last = self.first().last()?;
        self.are_more.then(|| last.at + 1)
    }

    /// Adds a change, if there is one.
    pub(super) fn add(&mut self, change: Option<Change>) {
        let Some(change) = change.filter(|change| change.at >= self.from) else {
            return;
        };
        self.sum += change.by;
        // Put in its place, from where on each moves on by one.
        let mut moved = change;
        for slot in self.slots.get_mut(..self.used).unwrap_or_default() {
            if slot.at == moved.at {
                slot.by += moved.by;
                return;
            }
            if slot.at > moved.at {
                swap(slot, &mut moved);
            }
        }
        match self.slots.get_mut(self.used) {
            Some(slot) => {
                *slot = moved;
                self.used += 1;
            }
            None => self.are_more = true,
        }
    }
}
