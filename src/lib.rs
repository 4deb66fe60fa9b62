//! zrow draws 2D shapes and 3D scenes for microcontroller displays one row at a time.
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
