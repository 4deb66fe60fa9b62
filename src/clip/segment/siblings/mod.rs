//! Segment clippers that are kept to compare them with the default one.

mod cohen_sutherland;
mod midpoint_subdivision;
mod nicholl_lee_nicholl;

pub use {
    cohen_sutherland::cohen_sutherland, midpoint_subdivision::midpoint_subdivision,
    nicholl_lee_nicholl::nicholl_lee_nicholl,
};
