//! Polygon clipping that is kept to compare it with the default.

mod weiler_atherton;
