//! Another way to the pixels of the exact area, bit for bit equal.

pub(super) mod dense_rows;
