//! Models become Rust modules: what they hold, what is an error, and what hostile files do.

mod common;
mod edges;
mod errors;
mod hostile;
mod levels;
mod models;
