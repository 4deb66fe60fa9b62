//! A panic of every kind that a program could hold, each in a function of its own: the command has to find them all.

#![no_std]
#![no_main]

use core::cell::RefCell;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use zrow::band::{Band, PictureLoop};
use zrow_panics_firmware::{any, call_all, keep, take};

static PLANTED: &[&[fn()]] = &[&[
    index,
    slice,
    chunks,
    division_by_zero,
    division_overflow,
    remainder,
    clamp,
    unwrap,
    expect,
    assertion,
    text,
    borrow,
    vector,
    through_zrow,
]];

/// The entry point.
#[unsafe(no_mangle)]
extern "C" fn enter() -> ! {
    call_all(PLANTED)
}

#[inline(never)]
fn index() {
    keep(any::<&[u32]>()[any::<usize>()]);
}

#[inline(never)]
fn slice() {
    keep(&any::<&[u32]>()[any::<usize>()..any::<usize>()]);
}

#[inline(never)]
fn chunks() {
    keep(any::<&[u32]>().chunks(any()));
}

#[inline(never)]
fn division_by_zero() {
    keep(any::<u64>() / any::<u64>());
}

#[inline(never)]
fn division_overflow() {
    keep(any::<i32>() / -any::<i32>().abs().max(1));
}

#[inline(never)]
fn remainder() {
    keep(any::<u32>() % any::<u32>());
}

#[inline(never)]
fn clamp() {
    keep(any::<i32>().clamp(any(), any()));
}

#[inline(never)]
fn unwrap() {
    keep(any::<Option<u32>>().unwrap());
}

#[inline(never)]
fn expect() {
    keep(any::<Result<u32, core::fmt::Error>>().expect("planted"));
}

#[inline(never)]
fn assertion() {
    assert_eq!(any::<u32>(), any::<u32>());
}

#[inline(never)]
fn text() {
    keep(&any::<&str>()[any::<usize>()..]);
}

#[inline(never)]
fn borrow() {
    keep(any::<&RefCell<u32>>().borrow_mut());
}

#[inline(never)]
fn vector() {
    keep(any::<&mut heapless::Vec<u32, 8>>().swap_remove(any()));
}

#[inline(never)]
fn through_zrow() {
    let scene = |band: &mut Band<'_, Rgb565>| {
        let words = band.words_mut();
        words[any::<usize>()] = Rgb565::RED.into_storage();
    };
    let picture: &PictureLoop<Rgb565> = any();
    keep(picture.draw(any(), &mut |band: Band<'_, Rgb565>| take(band), scene));
}
