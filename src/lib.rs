//! zrow draws 2D shapes and 3D scenes on microcontroller displays, one row (or band of rows) at a time.
//!
//! A colour row and a depth row replace the frame buffer and the depth buffer: 480 + 480 bytes at 240 pixels in RGB565, where
//! buffers of 240 x 320 pixels take 307,200. zrow takes embedded-graphics' shapes, texts and images, draws into its
//! `DrawTarget`s, and its own [`band::Band`] is one. It needs no FPU, no allocator and no `unsafe`.
//!
//! ![A dashboard drawn through one row: a gauge, a turning stone, icons and texts][dashboard]
//!
//! # Quick start
//!
//! A picture is built once, prepared where it changes, and drawn row by row; only what has changed is sent. `display` is any
//! `DrawTarget`, such as that of mipidsi.
//!
//! ```
//! use embedded_graphics::{
//!     mono_font::{MonoTextStyle, ascii::FONT_6X10},
//!     pixelcolor::Rgb565,
//!     prelude::*,
//!     primitives::{Circle, Line},
//!     text::Text,
//! };
//! use zrow::{
//!     draw::{Picture, PictureSlot},
//!     geometry::{InputError, Window},
//!     prelude::*,
//! };
//!
//! fn show<D: DrawTarget<Color = Rgb565>>(display: &mut D, tips: &[Point]) -> Result<(), InputError> {
//!     // All memory there is: three items and their words, a bucket for each row, eight rectangles of changes, one row.
//!     let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 3], [0; 20], [0; 64]);
//!     let (mut areas, mut row) = ([Window::EMPTY; 8], [0; 64]);
//!     let mut picture = Picture::new(display.bounding_box(), &mut slots, &mut pool, &mut buckets)
//!         .with_damage(&mut areas, (1, 1));
//!     let centre = Point::new(32, 32);
//!     let needle_to = |tip| Line::new(centre, tip).into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 2));
//!     picture.add(&Circle::with_center(centre, 61).into_styled(PrimitiveStyle::with_fill(Rgb565::BLUE)))?;
//!     let needle = picture.add(&needle_to(centre))?;
//!     picture.add(&Text::new("km/h", Point::new(20, 50), MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE)))?;
//!     for tip in tips {
//!         picture.replace(needle, &needle_to(*tip))?;
//!         while let Some(area) = picture.next_damage() {
//!             let (area, sink) = (PictureLoop::new(area, Rgb565::BLACK), &mut DisplaySink(display));
//!             // What goes wrong here is an error of the display: the next frame is whole all the same.
//!             let _ = area.draw(&mut row, sink, |band| picture.draw(band));
//!         }
//!     }
//!     Ok(())
//! }
//! # let mut display = embedded_graphics::mock_display::MockDisplay::new();
//! # display.set_allow_overdraw(true);
//! # show(&mut display, &[Point::new(32, 8), Point::new(50, 20)])?;
//! # assert_eq!(display.get_pixel(Point::new(32, 60)), Some(Rgb565::BLUE));
//! # assert_eq!(display.get_pixel(Point::new(41, 26)), Some(Rgb565::RED));
//! # Ok::<(), InputError>(())
//! ```
//!
//! # Where to go on
//!
//! | to | take |
//! |---|---|
//! | know which way to draw, how tall a band should be, how large tables are, what a driver needs, what effects cost | [`guide`] |
//! | draw shapes, texts and images | [`draw`]: [`draw::Picture`], or [`draw::DrawOn`] in a closure |
//! | have smooth edges | [`draw::Antialiased`]: `style.antialiased()` |
//! | have smooth text | [`draw::MaskTextStyle`] in one size, [`draw::OutlineTextStyle`] in any |
//! | send rows | [`band::PictureLoop`] with a [`band::Sink`]: [`DisplaySink`](band::DisplaySink), [`BytesSink`](band::BytesSink), [`PagesSink`](band::PagesSink), [`OverlappingSink`](band::OverlappingSink) for DMA; `draw_async` and `draw_pages_async` |
//! | show 3D models | [`scene`]: [`scene::Memory`], [`scene::Model`], [`scene::Camera`] |
//! | light, texture and blend them | [`shade`] |
//! | place them among shapes | [`scene::SceneItem`] |
//! | compare algorithms | [`algorithms`], [`scan`], [`clip`], [`coverage`], [`visible`] |
//!
//! # Errors
//!
//! Whatever may lack memory or domain returns a [`geometry::InputError`], which says what was wrong and how much would do. After any error
//! the object is usable, and the picture is what it was. Nothing panics.
//!
//! # Features
//!
//! | feature | what it does |
//! |---|---|
//! | none | all of the library: what a program does not call is not linked |
//! | `defmt` | public types implement `defmt::Format`, and trace points reach the probe |
//!
//! # Boards
//!
//! The repository has firmware for a Raspberry Pi Pico with an ST7789 over SPI and DMA, for a Cortex-M3 with an OLED that QEMU emulates,
//! and a simulator; all draw the same scenes with the same code.
//!
//! # Stages
//!
//! The folders are the stages of the pipeline, and a stage uses only the stages before it:
//! [`geometry`], `surface`, `view`, `mesh`, [`clip`], [`scan`], [`coverage`], [`shade`], [`band`], [`draw`], [`visible`],
//! [`scene`], which also has what users name of `view` and `mesh`, as [`band`] has what they name of `surface`.
//!
#![doc = concat!("[dashboard]: data:image/png;base64,", include_str!("../docs/embedded/dashboard.png.txt"))]
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

pub mod algorithms;
pub mod band;
pub mod clip;
pub mod coverage;
pub mod draw;
pub mod geometry;
pub mod guide;
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
