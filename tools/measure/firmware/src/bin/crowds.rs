//! Counts thirty round models of which five are seen: without bounds, with boxes or spheres that are constants, and with boxes
//! that are found anew in each frame.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::{Band, PictureLoop},
    scene::{BoundingBox, BoundingSphere, Camera, Memory, Model, Pose, Rotation},
    shade::{Bounded, Shading},
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    standard::{FRAME_NUMBERS, FRAMES},
    stopwatch::Stopwatch,
};
use zrow_scenes::meshes::{ICOSPHERE, ICOSPHERE_COLORS};

static BOUNDS: BoundingBox = ICOSPHERE.bounds();
static SPHERE: BoundingSphere = BoundingSphere::around(ICOSPHERE.vertices());
const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(128, 64));

/// Where the spheres are: five side by side before the camera, the others to the left, to the right and behind it.
const PLACES: [[i32; 2]; 30] = {
    let mut places = [[0; 2]; 30];
    let mut at = 0;
    while at < 30 {
        let step = at as i32;
        places[at] = match at {
            0..5 => [1_500 * step - 3_000, 4_000],
            5..13 => [-8_000 - 500 * step, 2_000],
            13..21 => [2_000 + 500 * step, 1_000],
            _ => [1_500 * step - 37_500, -3_000],
        };
        at += 1;
    }
    places
};

/// Spheres in a shading, with its skin.
struct Crowd<H: Shading> {
    memory: Memory<H, { 30 * 162 }, { 30 * 320 }, 128, 64, 100>,
    words: [u16; 128],
    skin: fn() -> H::Skin<'static>,
}

impl<H: Shading<Color = Rgb565>> Crowd<H> {
    const fn new(skin: fn() -> H::Skin<'static>) -> Self {
        Self {
            memory: Memory::new(),
            words: [0; 128],
            skin,
        }
    }

    /// Prepares a frame, draws it if it is to be drawn, and hands over its rows.
    fn rows(&mut self, frame: u32, is_drawn: bool, mut output: impl FnMut(&[u16])) {
        let rotation = Rotation::about_y(U0F16::from_bits((frame % 64 * 1_024) as u16));
        let Ok(sphere) = Model::<H>::with_skin(ICOSPHERE, (self.skin)()) else {
            report::exit(false)
        };
        let mut models = [sphere; 30];
        for (model, [x, z]) in models.iter_mut().zip(black_box(&PLACES)) {
            model.pose = Pose::new(rotation, [*x, 0, *z].map(I16F16::from_num::<i32>));
        }
        let camera = Camera::new(AREA, I16F16::from_num(128));
        let Ok(mut prepared) = camera.and_then(|camera| self.memory.prepare(&camera, &models)) else {
            report::exit(false)
        };
        if !is_drawn {
            black_box(&mut prepared);
            return;
        }
        let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
            output(band.words());
            Ok(())
        };
        let picture = PictureLoop::new(AREA, Rgb565::BLACK);
        let drawn = picture.draw(&mut self.words, &mut sink, |band: &mut Band<'_, Rgb565>| {
            prepared.draw(band)
        });
        if drawn.is_err() {
            report::exit(false)
        }
    }
}

impl<H: Shading<Color = Rgb565>> Canvas for Crowd<H> {
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        let mut sum = Checksum::default();
        for frame in 0..FRAMES {
            self.rows(frame, true, |words| sum.add(words.iter().copied()));
        }
        sum.0
    }
}

fn count<H: Shading<Color = Rgb565>>(runner: &mut Runner, name: &str, crowd: &mut Crowd<H>) {
    if runner.wants(name) {
        for (variant, is_drawn) in [("prepare", false), ("draw", true)] {
            runner.count(name, variant, crowd, &FRAME_NUMBERS, |crowd, &frame| {
                crowd.rows(frame, is_drawn, |words| {
                    black_box(words);
                });
            });
        }
    }
}

fn colors() -> &'static [Rgb565] {
    &ICOSPHERE_COLORS
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let plain = cortex_m::singleton!(: Crowd<Rgb565> = Crowd::new(colors));
    let bounded = cortex_m::singleton!(: Crowd<Bounded<Rgb565>> = Crowd::new(|| (colors(), *black_box(&BOUNDS))));
    let spheres =
        cortex_m::singleton!(: Crowd<Bounded<Rgb565, BoundingSphere>> = Crowd::new(|| (colors(), *black_box(&SPHERE))));
    let found = cortex_m::singleton!(: Crowd<Bounded<Rgb565>> = Crowd::new(|| {
        // Thirty different meshes would be searched once each.
        let mut bounds = BoundingBox::around(&[]);
        for _ in 0..30 {
            bounds = black_box(ICOSPHERE).bounds().joined(&black_box(bounds));
        }
        (colors(), bounds)
    }));
    let (Some(peripherals), Some(plain), Some(bounded), Some(spheres), Some(found)) =
        (Peripherals::take(), plain, bounded, spheres, found)
    else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    count(&mut runner, "crowd.plain", plain);
    count(&mut runner, "crowd.bounded", bounded);
    count(&mut runner, "crowd.spheres", spheres);
    count(&mut runner, "crowd.found", found);
    report::exit(true)
}
