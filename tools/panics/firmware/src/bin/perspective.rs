//! A scene with perspective, prepared and drawn: a division is reached from where vertices are projected, which the command has
//! to find.

#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::LittleEndian,
    scene::{Frame, OnePass, Prepared, Whole},
};
use zrow_panics_firmware::{any, call_all, keep};

/// The look of the scene: the corners of its faces are moved to eye space, projected, and not cut.
type Look = Whole<OnePass<Rgb565>>;

static EXERCISES: &[&[fn()]] = &[&[prepare, draw]];

/// The entry point.
#[unsafe(no_mangle)]
extern "C" fn enter() -> ! {
    call_all(EXERCISES)
}

#[inline(never)]
fn prepare() {
    keep(Frame::<Look>::prepare(any(), any(), any()));
}

#[inline(never)]
fn draw() {
    keep(Prepared::<Look>::draw::<LittleEndian>(any(), any()));
}
