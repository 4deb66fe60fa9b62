//! Algorithms that clip polygons against polygons, kept to compare them with the default one.

pub mod weiler_atherton;
