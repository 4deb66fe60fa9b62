//! Nothing but dependencies: each program of the workspace asks for the same features of the crates that zrow depends on.
//!
//! Cargo chooses the features of a crate for the packages that a command names. Without this one, `cargo test`,
//! `cargo test --workspace` and each tool would choose others, and each would compile embedded-graphics, zrow and the demo
//! scenes anew.
