//! Hidden surfaces: the row loop with the depth row.
