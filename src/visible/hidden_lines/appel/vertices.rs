//! The vertices whose quantitative invisibility is known: an open hash table.

use crate::visible::hidden_lines::LinePoint;

/// Slots that are looked at for a vertex.
const PROBES: usize = 8;

/// A vertex, and one more than its quantitative invisibility; 0 in a free slot.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Vertex {
    point: LinePoint,
    count: u32,
}

impl Vertex {
    pub(super) const FREE: Self = Self {
        point: LinePoint { x: 0, y: 0, depth: 0 },
        count: 0,
    };
}

/// The slots in which a vertex may be, the first one first.
fn first_slot(slots: usize, point: LinePoint) -> usize {
    // Multiplicative hashing (Knuth 1973) by odd numbers near the golden ratio.
    let mixed = (point.x as u32).wrapping_mul(0x9e37_79b1) ^ (point.y as u32).wrapping_mul(0x85eb_ca6b).rotate_left(15);
    let hash = (mixed ^ point.depth as u32).wrapping_mul(0xc2b2_ae35);
    ((u64::from(hash) * slots as u64) >> 32) as usize
}

/// The quantitative invisibility of a vertex, if it is known.
pub(super) fn find(slots: &[Vertex], point: LinePoint) -> Option<i32> {
    let (before, after) = slots.split_at_checked(first_slot(slots.len(), point))?;
    let mut probes = after.iter().chain(before).take(PROBES);
    let known = probes.find(|slot| slot.count == 0 || slot.point == point)?;
    known.count.checked_sub(1).map(|count| count as i32)
}

/// Keeps the quantitative invisibility of a vertex, if there is room for it.
pub(super) fn keep(slots: &mut [Vertex], point: LinePoint, count: i32) {
    let Some((before, after)) = slots.split_at_mut_checked(first_slot(slots.len(), point)) else {
        return;
    };
    // A number of faces: the least is a guard.
    let count = count.max(0) as u32 + 1;
    let mut probes = after.iter_mut().chain(before).take(PROBES);
    if let Some(slot) = probes.find(|slot| slot.count == 0 || slot.point == point) {
        *slot = Vertex { point, count };
    }
}
