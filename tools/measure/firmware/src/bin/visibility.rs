//! Counts scenes of 12 to 4,992 faces, and of 1 to 16 layers in one colour a face and with a texture, prepared and drawn at
//! 128 x 64 in one band by each method of visibility.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::I16F16;
use zrow::{
    band::Band,
    scene::{Camera, Look, Memory, Model, Prepared},
    shade::{Texels, Textured},
    visible::Visibility,
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_methods::{HIDDEN_SURFACES, HiddenSurfaces};
use zrow_scenes::hidden::{HiddenFaces, LAYERS, MOST_FACES, MOST_VERTICES, SPHERES};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(128, 64));
const PIXELS: usize = 128 * 64;
const TILES: usize = 32;
const TILE_FACES: usize = 20_000;
const FACES: usize = MOST_FACES;
const CELLS: usize = 8 * FACES;
const ENTRIES: usize = 60_000;
const ACTIVE: usize = 700;

/// The frame that is counted.
const FRAME: &[u32] = &[16];

/// How many frames are drawn before the first one that is counted.
const WARM_UP: u32 = 20;

/// A scene, the memory that it is prepared in, and its picture.
struct Picture<'s, L: Look> {
    scene: &'s HiddenFaces,
    model: fn(&'s HiddenFaces, u32) -> Option<Model<'s, L::Shading>>,
    memory: &'s mut Memory<L, { MOST_VERTICES }, { MOST_FACES }, 128, 64, ACTIVE>,
    words: &'s mut [u16; PIXELS],
}

impl<'s, L: Look<Color = Rgb565>> Picture<'s, L> {
    /// Prepares a frame and draws it into the cleared picture.
    #[inline(always)]
    fn draw(&mut self, frame: u32, draw: impl FnOnce(&mut Prepared<'_, 's, L>, &mut Band<'_, Rgb565>) -> bool) {
        self.words.fill(0);
        let Some(model) = (self.model)(self.scene, frame) else {
            report::exit(false)
        };
        let models = [model];
        let Ok(camera) = Camera::new(AREA, I16F16::from_num(128)) else {
            report::exit(false)
        };
        let (Ok(mut prepared), Ok(mut band)) = (self.memory.prepare(&camera, &models), Band::new(AREA, self.words))
        else {
            report::exit(false)
        };
        if !draw(&mut prepared, &mut band) {
            report::exit(false)
        }
    }

    /// Counts drawing by the depth row and by each method of which that is wanted.
    fn count_all(&mut self, runner: &mut Runner, name: &str, is_counted: impl Fn(&HiddenSurfaces) -> bool)
    where
        L: Look<Depth = u16>,
    {
        let is_counted = |name| {
            HIDDEN_SURFACES
                .iter()
                .any(|method| method.name == name && is_counted(method))
        };
        // A memory knows from the last frames whether faces overlap: as it is after so many of them.
        for _ in 0..WARM_UP {
            self.draw(FRAME[0], |prepared, band| {
                prepared.draw(band);
                true
            });
        }
        runner.count(name, "row", self, FRAME, |picture, &frame| {
            picture.draw(frame, |prepared, band| {
                prepared.draw(band);
                true
            });
        });
        macro_rules! count {
            ($([$method:ident] [$new:expr])+) => {$(
                if is_counted(stringify!($method)) {
                    self.count(runner, name, stringify!($method), &mut $new);
                }
            )+};
        }
        zrow_methods::hidden_surfaces!(count);
    }

    /// Counts drawing by a method, whose memory is enough.
    #[inline(never)]
    fn count(&mut self, runner: &mut Runner, name: &str, variant: &str, method: &mut impl Visibility<L::Depth>) {
        runner.count(name, variant, self, FRAME, |picture, &frame| {
            picture.draw(frame, |prepared, band| prepared.draw_by(method, band).is_ok());
        });
    }
}

impl<L: Look<Color = Rgb565>> Canvas for Picture<'_, L> {
    fn erase(&mut self) {
        self.words.fill(0);
    }

    /// Of the pixels of the last frame.
    fn checksum(&mut self) -> u32 {
        Checksum::of(self.words.iter().copied())
    }
}

/// The names of the counts with so many faces or layers.
macro_rules! names {
    ($prefix:literal: $($number:literal)+) => {
        [$(concat!($prefix, stringify!($number))),+]
    };
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let scene = cortex_m::singleton!(: HiddenFaces = HiddenFaces::EMPTY);
    let picture = cortex_m::singleton!(: [u16; PIXELS] = [0; PIXELS]);
    let flat =
        cortex_m::singleton!(: Memory<Rgb565, { MOST_VERTICES }, { MOST_FACES }, 128, 64, ACTIVE> = Memory::new());
    let textured = cortex_m::singleton!(
        : Memory<Textured<Texels<Rgb565, 64, 64>>, { MOST_VERTICES }, { MOST_FACES }, 128, 64, ACTIVE> = Memory::new()
    );
    let (Some(peripherals), Some(scene), Some(words), Some(flat), Some(textured)) =
        (Peripherals::take(), scene, picture, flat, textured)
    else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let of_faces = names!("visibility.faces.": 12 48 192 768 3072 4992);
    for (name, spheres) in of_faces.into_iter().zip(&SPHERES) {
        if runner.wants(name) {
            scene.set_spheres(spheres);
            Picture {
                scene: &*scene,
                model: flat_model,
                memory: &mut *flat,
                words: &mut *words,
            }
            .count_all(&mut runner, name, |method| method.draws_faces(spheres.faces));
        }
    }
    let of_layers = names!("visibility.layers.": 1 2 4 8 16);
    for (name, layers) in of_layers.into_iter().zip(LAYERS) {
        if runner.wants(name) {
            scene.set_layers(layers);
            Picture {
                scene: &*scene,
                model: flat_model,
                memory: &mut *flat,
                words: &mut *words,
            }
            .count_all(&mut runner, name, |method| method.draws_layers(layers));
        }
    }
    let with_texture = names!("visibility.textured.": 1 2 4 8 16);
    for (name, layers) in with_texture.into_iter().zip(LAYERS) {
        if runner.wants(name) {
            scene.set_layers(layers);
            Picture {
                scene: &*scene,
                model: textured_model,
                memory: &mut *textured,
                words: &mut *words,
            }
            .count_all(&mut runner, name, |method| method.draws_layers(layers));
        }
    }
    report::exit(true)
}

/// The scene in a colour a face.
fn flat_model(scene: &HiddenFaces, frame: u32) -> Option<Model<'_, Rgb565>> {
    scene.flat(frame).ok()
}

/// The scene with a texture.
fn textured_model(scene: &HiddenFaces, frame: u32) -> Option<Model<'_, Textured<Texels<Rgb565, 64, 64>>>> {
    scene.textured(frame).ok()
}
