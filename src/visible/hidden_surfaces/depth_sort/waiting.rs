//! The list of faces and parts of faces that are still to be painted.
//!
//! ```text
//!     nodes       painted |  D    C    A  |  B    E    F    G   |  free
//!                            ^            ^
//!                            first        behind it all is sorted by depth
//!
//!     conditions  (entry of the list, other face, in front of it or not), in no order
//! ```

use core::ops::Range;

/// The pixels of a face in which it is in front of another face, or the ones in which it is not: it is behind, or the other face
/// does not cover them.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Condition {
    /// The entry of the list that it belongs to.
    entry: u16,
    /// The node of the other face.
    pub(super) other: u16,
    pub(super) is_in_front: bool,
}

impl Condition {
    pub(super) const EMPTY: Self = Self {
        entry: 0,
        other: 0,
        is_in_front: false,
    };
}

/// The most conditions of a part. A part with more takes longer than all faces of a cycle at once.
pub(super) const MOST_CONDITIONS: usize = 8;

/// The conditions of a part; none for a whole face.
#[derive(Copy, Clone)]
pub(super) struct PartConditions {
    conditions: [Condition; MOST_CONDITIONS],
    count: usize,
}

impl PartConditions {
    pub(super) fn iter(&self) -> impl Iterator<Item = &Condition> {
        self.conditions.iter().take(self.count)
    }
}

/// The faces that wait, and the conditions of parts.
pub(super) struct Waiting<'w> {
    nodes: &'w mut [u16],
    entries: Range<usize>,
    /// How many entries are not sorted by depth: those that were moved to the front, and the one that was there before them.
    moved: usize,
    conditions: &'w mut [Condition],
    /// How many conditions there are.
    count: usize,
}

impl<'w> Waiting<'w> {
    /// The first so many nodes wait, sorted by depth.
    pub(super) fn new(nodes: &'w mut [u16], count: usize, conditions: &'w mut [Condition]) -> Self {
        Self {
            nodes,
            entries: 0..count,
            moved: 1,
            conditions,
            count: 0,
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The first entry.
    pub(super) fn first(&self) -> usize {
        self.entries.start
    }

    /// The entry after the last one.
    pub(super) fn end(&self) -> usize {
        self.entries.end
    }

    /// The node of an entry.
    pub(super) fn node(&self, entry: usize) -> Option<u16> {
        self.nodes.get(entry).copied()
    }

    /// Whether an entry was moved to the front, or another one before it. Entries that were not are sorted by depth.
    pub(super) fn was_moved(&self, entry: usize) -> bool {
        entry < self.sorted().start
    }

    /// The entries that are sorted by depth.
    fn sorted(&self) -> Range<usize> {
        (self.entries.start + self.moved).min(self.entries.end)..self.entries.end
    }

    /// Whether an entry has conditions.
    pub(super) fn is_part(&self, entry: usize) -> bool {
        self.all_conditions()
            .any(|condition| usize::from(condition.entry) == entry)
    }

    fn all_conditions(&self) -> impl Iterator<Item = &Condition> {
        self.conditions.iter().take(self.count)
    }

    /// The conditions of an entry.
    pub(super) fn conditions(&self, entry: usize) -> PartConditions {
        let mut part = PartConditions {
            conditions: [Condition::EMPTY; MOST_CONDITIONS],
            count: 0,
        };
        let conditions = self
            .all_conditions()
            .filter(|condition| usize::from(condition.entry) == entry);
        for (slot, condition) in part.conditions.iter_mut().zip(conditions) {
            *slot = *condition;
            part.count += 1;
        }
        part
    }

    /// Whether an entry is known to be nowhere in front of another one, because one of them was split by the other one's plane.
    pub(super) fn is_known_behind(&self, entries: [usize; 2], [node, other]: [u16; 2]) -> bool {
        let [entry, other_entry] = entries.map(|entry| entry as u16);
        self.all_conditions().any(|condition| {
            (condition.entry == entry && condition.other == other && !condition.is_in_front)
                || (condition.entry == other_entry && condition.other == node && condition.is_in_front)
        })
    }

    /// Moves an entry to the front.
    pub(super) fn move_to_front(&mut self, entry: usize) {
        let first = self.entries.start;
        if let Some(nodes) = self.nodes.get_mut(first..entry + 1) {
            let moved = nodes.last().copied();
            insert_at_front(nodes, moved.unwrap_or_default());
        }
        self.renumber(|moved| match moved {
            moved if moved == entry => first,
            moved if (first..entry).contains(&moved) => moved + 1,
            moved => moved,
        });
        self.moved += 1;
    }

    /// Takes entries away that begin with the first one, and their conditions.
    pub(super) fn remove(&mut self, entries: Range<usize>) {
        let mut index = 0;
        while let Some(condition) = self.conditions.get(index).filter(|_| index < self.count) {
            if entries.contains(&usize::from(condition.entry)) {
                self.count -= 1;
                let last = self.conditions.get(self.count).copied();
                if let (Some(slot), Some(last)) = (self.conditions.get_mut(index), last) {
                    *slot = last;
                }
            } else {
                index += 1;
            }
        }
        self.entries.start = entries.end;
        self.moved = self.moved.saturating_sub(entries.len()).max(1);
    }

    /// Splits the first entry by the plane of a face: it stays where it is not in front, and the part in front comes after all
    /// sorted entries that are before it. Returns `false` where there is no room, or it has a condition of this face.
    pub(super) fn split_first(&mut self, other: u16, is_before: impl FnMut(u16) -> bool) -> bool {
        let conditions = self.conditions(self.entries.start);
        let has_room = conditions.count < MOST_CONDITIONS && self.count + conditions.count + 2 <= self.conditions.len();
        if !has_room || conditions.iter().any(|condition| condition.other == other) {
            return false;
        }
        let Some(entry) = self.insert_first_again(is_before) else {
            return false;
        };
        for condition in conditions.iter() {
            self.push(entry, condition.other, condition.is_in_front);
        }
        self.push(self.entries.start, other, false);
        self.push(entry, other, true);
        true
    }

    /// Adds a condition, for which there is room.
    fn push(&mut self, entry: usize, other: u16, is_in_front: bool) {
        if let Some(slot) = self.conditions.get_mut(self.count) {
            *slot = Condition {
                entry: entry as u16,
                other,
                is_in_front,
            };
            self.count += 1;
        }
    }

    /// Puts the node of the first entry into the list once more, after all sorted entries that are before it. Returns its
    /// entry; `None` where there is no room.
    fn insert_first_again(&mut self, mut is_before: impl FnMut(u16) -> bool) -> Option<usize> {
        let node = self.node(self.entries.start)?;
        let sorted = self.sorted();
        let nodes = self.nodes.get(sorted.clone())?;
        let entry = sorted.start + nodes.partition_point(|node| is_before(*node));
        if let Some(nodes) = self.nodes.get_mut(entry..self.entries.end + 1) {
            insert_at_front(nodes, node);
            self.entries.end += 1;
            self.renumber(|moved| if moved >= entry { moved + 1 } else { moved });
            return Some(entry);
        }
        // Entries that were painted have left room.
        let first = self.entries.start.checked_sub(1)?;
        let nodes = self.nodes.get_mut(first..entry)?;
        insert_at_back(nodes, node);
        self.entries.start = first;
        self.renumber(|moved| if moved < entry { moved - 1 } else { moved });
        Some(entry - 1)
    }

    /// Gives the entries of all conditions other numbers.
    fn renumber(&mut self, number: impl Fn(usize) -> usize) {
        for condition in self.conditions.iter_mut().take(self.count) {
            condition.entry = number(condition.entry.into()) as u16;
        }
    }
}

/// Puts a node before others, the last of which is lost.
fn insert_at_front(nodes: &mut [u16], mut node: u16) {
    for slot in nodes {
        core::mem::swap(slot, &mut node);
    }
}

/// Puts a node behind others, the first of which is lost.
fn insert_at_back(nodes: &mut [u16], mut node: u16) {
    for slot in nodes.iter_mut().rev() {
        core::mem::swap(slot, &mut node);
    }
}
