//! Polygons against polygons: intersection, union and difference.

pub mod greiner_hormann;
