//! A scene with parallel rays, prepared and drawn: no division may be reached from where vertices are projected.

#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::LittleEndian,
    scene::{Deep, Fine, Frame, OnePass, Orthographic, Prepared, Whole},
};
use zrow_panics_firmware::{any, call_all, keep};

/// The look of the scene: the corners of its faces are moved to eye space, projected, and not cut.
type Look = Whole<OnePass<Orthographic<Rgb565>>>;

static EXERCISES: &[&[fn()]] = &[&[prepare, prepare_fine, draw]];

/// The entry point.
#[unsafe(no_mangle)]
extern "C" fn enter() -> ! {
    call_all(EXERCISES)
}

#[inline(never)]
fn prepare() {
    keep(Frame::<Look>::prepare(any(), any(), any()));
}

/// At 1/256 pixel, with depths of 32 bits.
#[inline(never)]
fn prepare_fine() {
    keep(Frame::<Fine<Deep<Look>>>::prepare(any(), any(), any()));
}

#[inline(never)]
fn draw() {
    keep(Prepared::<Look>::draw::<LittleEndian>(any(), any()));
}
