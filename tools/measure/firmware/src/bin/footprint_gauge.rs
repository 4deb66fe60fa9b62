//! A gauge of 76 antialiased outlines as a picture, through one row of 240 pixels, and nothing else: 71 ticks, two arcs, a
//! needle and two discs.
#![no_std]
#![no_main]

use core::convert::Infallible;

use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{U0F16, U24F8};
use zrow::{
    band::{Band, PictureLoop},
    draw::{
        AntialiasedOutline, AntialiasingMemory, FillRule, Picture, PictureSlot, SubArc, SubEllipse, SubLine, SubOutline,
    },
    geometry::{InputError, Sub8, SubPoint},
};
use zrow_measure_firmware::{report, run::Checksum, stack};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(240, 240));
const OUTLINES: usize = 76;
const WORDS: usize = 1_536;

/// A point around the middle; the angle is in 1/65,536 turn, the radius in 1/256 pixel.
fn around(radius: i32, angle: u16) -> Result<SubPoint<Sub8>, InputError> {
    // A quarter of a parabola: near enough to a circle for where ticks are.
    let sine = |angle: u16| {
        let (half, place) = (angle >> 15, i32::from(angle & 0x7fff) - 0x4000);
        let size = 0x4000 - ((place * place) >> 14);
        if half == 0 { size } else { -size }
    };
    let along = |sine: i32| (radius * sine) >> 14;
    let middle = 120 * 256;
    Ok(SubPoint::from_units(
        middle + along(sine(angle)),
        middle + along(sine(angle.wrapping_add(0x4000))),
    )?)
}

fn add_all(picture: &mut Picture<'_, 'static, Rgb565>) -> Result<(), InputError> {
    let mut add = |outline: &dyn SubOutline, color: Rgb565| {
        picture
            .add(&AntialiasedOutline::new(outline, FillRule::NonZero, color))
            .map(drop)
    };
    let pixels = U24F8::from_num::<u16>;
    let middle = SubPoint::from_units(120 * 256, 120 * 256)?;
    let (start, sweep) = (U0F16::from_bits(0x6000), U0F16::from_bits(0xc000));
    add(
        &SubArc::new(middle, [pixels(104), pixels(112)], start, sweep)?,
        Rgb565::CSS_DIM_GRAY,
    )?;
    add(
        &SubArc::new(middle, [pixels(104), pixels(112)], start, U0F16::from_bits(0x7000))?,
        Rgb565::CSS_DEEP_SKY_BLUE,
    )?;
    for tick in 0..71u16 {
        let angle = tick * 700;
        let inner = if tick % 10 == 0 { 84 } else { 92 } * 256;
        let line = SubLine::new(around(inner, angle)?, around(100 * 256, angle)?, pixels(2))?;
        add(&line, Rgb565::CSS_LIGHT_GRAY)?;
    }
    let needle = [
        around(80 * 256, 0x2800)?,
        around(5 * 256, 0x6800)?,
        around(20 * 256, 0xa800)?,
        around(5 * 256, 0xe800)?,
    ];
    add(&[needle.as_slice()], Rgb565::RED)?;
    add(&SubEllipse::circle(middle, pixels(10))?, Rgb565::CSS_SLATE_GRAY)?;
    add(&SubEllipse::circle(middle, pixels(4))?, Rgb565::RED)
}

#[entry]
fn main() -> ! {
    static mut ROW: [u16; 240] = [0; 240];
    static mut SLOTS: [PictureSlot<'static, Rgb565>; OUTLINES] = [PictureSlot::EMPTY; OUTLINES];
    static mut POOL: [u32; WORDS] = [0; WORDS];
    static mut BUCKETS: [u16; 240] = [0; 240];
    static mut ANTIALIASING: AntialiasingMemory<241, 40, 40> = AntialiasingMemory::new();
    let mut picture = Picture::new(AREA, SLOTS, POOL, BUCKETS).with_antialiasing(ANTIALIASING);
    if add_all(&mut picture).is_err() {
        report::exit(false)
    }
    let mut sum = Checksum::default();
    let mut sink = |band: Band<'_, _>| -> Result<(), Infallible> {
        sum.add(band.words().iter().copied());
        Ok(())
    };
    let bands = PictureLoop::new(AREA, Rgb565::BLACK);
    if bands.draw(ROW, &mut sink, |band| picture.draw(band)).is_err() {
        report::exit(false)
    }
    stack::report(sum.0);
    report::exit(true)
}
