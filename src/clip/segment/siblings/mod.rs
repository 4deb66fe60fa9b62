//! Segment clippers that are kept to compare them with the default one.

mod cohen_sutherland;
mod midpoint_subdivision;
mod nicholl_lee_nicholl;
