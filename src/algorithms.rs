//! Which algorithm for what, with costs and sources. Nothing is defined here.
//!
#![doc = include_str!("../docs/algorithms.md")]
