//! The standard scenes at 128 x 64, drawn through one row of colours and one row of depths.

use core::{convert::Infallible, hint::black_box};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::{Band, PictureLoop},
    geometry::Sub4,
    mesh::FaceSet,
    scene::{Frame, Model, Prepared},
    view::{Camera, Pose, Rotation},
};

use crate::run::{Canvas, Checksum};

/// Frames of a scene.
pub const FRAMES: u16 = 64;
/// Columns of the picture.
const WIDTH: usize = 128;
/// Rows of the picture.
const HEIGHT: usize = 64;
const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
/// Units of a vertex for a length of 1.
const UNIT: i32 = 512;

/// Vertices of the largest scene, faces of it, and its faces that cross one row.
const VERTICES: usize = 296;
const FACES: usize = 588;
const ACTIVE: usize = 96;

type Storage = Frame<Rgb565, VERTICES, FACES, ACTIVE, HEIGHT, Sub4, u16>;
type Ready<'f> = Prepared<'f, Rgb565, VERTICES, FACES, ACTIVE, HEIGHT, Sub4, u16>;

/// A colour for each face.
pub static COLORS: [Rgb565; FACES] = {
    let mut colors = [Rgb565::BLACK; FACES];
    let mut face = 0;
    while face < FACES {
        colors[face] = Rgb565::new((face % 31 + 1) as u8, (face % 61 + 1) as u8, (face % 29 + 1) as u8);
        face += 1;
    }
    colors
};

/// All memory that a scene takes, but for the stack.
pub struct Stage {
    storage: Storage,
    colors: [u16; WIDTH],
    depths: [u16; WIDTH],
}

impl Stage {
    /// Zeros, so that a `static` lies in `.bss`.
    pub const fn new() -> Self {
        Self {
            storage: Storage::new(),
            colors: [0; WIDTH],
            depths: [0; WIDTH],
        }
    }

    /// A scene to be drawn with this memory.
    pub fn with(&mut self, mesh: FaceSet<'static>) -> Scene<'_> {
        Scene { stage: self, mesh }
    }
}

/// A standard scene.
pub struct Scene<'a> {
    stage: &'a mut Stage,
    mesh: FaceSet<'static>,
}

impl Scene<'_> {
    /// Prepares a frame and nothing else.
    pub fn prepare(&mut self, frame: u16) {
        prepare(self.mesh, frame, &mut self.stage.storage, |prepared| {
            black_box(prepared);
        });
    }

    /// Draws a frame: clears, draws and hands on every row.
    pub fn draw(&mut self, frame: u16) {
        // A display would take the row by DMA from here on.
        self.rows(frame, |words| {
            black_box(words);
        });
    }

    fn rows(&mut self, frame: u16, mut output: impl FnMut(&[u16])) {
        let Stage {
            storage,
            colors,
            depths,
        } = &mut *self.stage;
        prepare(self.mesh, frame, storage, |prepared| {
            let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
                output(band.words());
                Ok(())
            };
            let drawn = PictureLoop::new(AREA, Rgb565::BLACK).draw(colors, &mut sink, |band: &mut Band<'_, Rgb565>| {
                if prepared.draw(band, depths).is_err() {
                    panic!()
                }
            });
            if drawn.is_err() {
                panic!()
            }
        });
    }
}

impl Canvas for Scene<'_> {
    fn erase(&mut self) {}

    /// Of all pixels of all frames, which are drawn once more for that.
    fn checksum(&mut self) -> u32 {
        let mut sum = Checksum::default();
        for frame in 0..FRAMES {
            self.rows(frame, |words| sum.add(words.iter().copied()));
        }
        sum.0
    }
}

fn prepare(mesh: FaceSet<'static>, frame: u16, storage: &mut Storage, then: impl FnOnce(&mut Ready<'_>)) {
    let steps = |angle: u16| U0F16::from_bits(angle.wrapping_mul(128));
    let rotation = Rotation::about_x(steps(frame * 8)).then(&Rotation::about_y(steps(frame * 16)));
    let translation = [I16F16::ZERO, I16F16::ZERO, I16F16::const_from_int(3 * UNIT)];
    let pose = Pose::new(rotation, translation);
    let (Ok(camera), Ok(model)) = (
        Camera::new(AREA, I16F16::const_from_int(UNIT / 4)),
        Model::new(mesh, &COLORS),
    ) else {
        panic!()
    };
    let models = [model.with_pose(pose)];
    match storage.prepare(&camera, &models) {
        Ok(mut prepared) => then(&mut prepared),
        Err(_) => panic!(),
    }
}
