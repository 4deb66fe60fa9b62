//! Another algorithm for the exact area, whose pixels are equal bit for bit.

pub(super) mod dense_rows;
