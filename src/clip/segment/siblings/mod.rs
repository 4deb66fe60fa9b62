//! Ways to clip a segment that are kept to compare them with the default one.

pub mod cohen_sutherland;
pub mod midpoint_subdivision;
pub mod nicholl_lee_nicholl;
