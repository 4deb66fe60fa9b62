//! An ST7789 whose transfers are futures, and the scenes that the boards with embassy show on it. The firmware of a board adds its
//! clocks, its pins and its bus.
#![no_std]
#![forbid(unsafe_code)]

mod panel;
mod show;

pub use panel::{Error, HEIGHT, Panel, Pins, StartError, WIDTH};
pub use show::{Failure, Frame, show_scenes};
