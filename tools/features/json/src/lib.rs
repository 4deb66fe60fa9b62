//! Nothing but dependencies: each program that reads or writes JSON asks for the same features of serde.
//!
//! This is no feature of `zrow-features`: with and without a feature, Cargo compiles two versions of a crate, and of each crate
//! that uses it.
