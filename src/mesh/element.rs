//! One element of a slice by its index, for functions that the compiler evaluates.
//!
//! The compiler finds the edges, neighbours and planes of a mesh in a `static` step by step. Dividing a slice in two at an index,
//! to take the element there without a panic, costs it many calls; comparing the index with the length first costs one step.

#![expect(clippy::indexing_slicing, reason = "each index is compared with the length first")]

/// The element of a slice at an index, or `None` behind the last one.
pub(super) const fn element<T: Copy>(slice: &[T], index: usize) -> Option<T> {
    if index < slice.len() { Some(slice[index]) } else { None }
}

/// Overwrites the element of a slice at an index, where there is one.
pub(super) const fn set_element<T: Copy>(slice: &mut [T], index: usize, value: T) {
    if index < slice.len() {
        slice[index] = value;
    }
}
