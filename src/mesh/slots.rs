//! One element of a slice by its index, in few steps of the compiler.
//!
//! Where a mesh lies in a `static`, the compiler finds its edges, neighbours and planes step by step. A slice that is divided
//! in two at an index takes it many calls, and the element at an index a comparison and a step.

#![expect(clippy::indexing_slicing, reason = "each index is compared with the length first")]

/// The element at an index, or `None` behind the last one.
pub(super) const fn get<T: Copy>(slots: &[T], index: usize) -> Option<T> {
    if index < slots.len() { Some(slots[index]) } else { None }
}

/// Overwrites the element at an index, where there is one.
pub(super) const fn set<T: Copy>(slots: &mut [T], index: usize, value: T) {
    if index < slots.len() {
        slots[index] = value;
    }
}
