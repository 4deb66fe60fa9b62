//! zrow draws 2D shapes and 3D scenes for microcontroller displays one row (or band of rows) at a time.
//!
//! A colour row and a depth row replace the frame buffer and the depth buffer. zrow takes embedded-graphics' shapes,
//! texts and images, draws into its `DrawTarget`s, and its own [`band::Band`] is one.
//!
//! The folders are the stages of the pipeline, and a stage uses only the stages before it:
//! [`geometry`], `surface`, `view`, `mesh`, [`clip`], [`scan`], [`coverage`], [`shade`], [`band`], [`draw`], `visible`,
//! [`scene`], which also has what users name of `view` and `mesh`, as [`band`] has what they name of `surface`.
//!
#![doc = include_str!("../docs/algorithms.md")]
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![warn(missing_debug_implementations)]
// Nothing here panics on input: what may be missing is asked for, and its absence handled.
#![cfg_attr(
    not(test),
    warn(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::indexing_slicing
    )
)]

// The registry of methods names the items of this crate as other crates do.
#[cfg(test)]
extern crate self as zrow;
#[cfg(test)]
extern crate std;

#[macro_use]
mod trace;

/// The number of random cases that the unit tests try; the integration tests in `tests/` include the same file.
#[cfg(test)]
#[path = "../tests/common/cases.rs"]
mod cases;

pub mod band;
pub mod clip;
pub mod coverage;
pub mod draw;
pub mod geometry;
mod mesh;
pub mod prelude;
pub mod scan;
pub mod scene;
pub mod shade;
mod surface;
mod view;
pub mod visible;

/// The number formats of public signatures, such as `U24F8`, in the version that zrow takes.
pub use fixed;
/// The tables of public signatures, such as `VecView`, in the version that zrow takes.
pub use heapless;

/// The examples of the README, compiled as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
