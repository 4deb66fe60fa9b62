//! A torus and a cube that go through each other, with four samples a pixel: smooth wherever one face ends before another.

use core::fmt;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use zrow::{
    band::{Band, Order},
    coverage::{Rooks, SamplePattern},
    scene::{self, Memory, Model, Multisampled},
};

use crate::{
    PrepareError, Prepared, Scene,
    meshes::TORUS_AND_CUBE,
    standard::{TORUS_AND_CUBE_MODEL, Torus, TorusAndCube, stage},
};

const COLUMNS: usize = 320;
const ROWS: usize = 240;
const VERTICES: usize = TORUS_AND_CUBE.vertices().len();
const FACES: usize = TORUS_AND_CUBE.faces().len();

/// The scene as it is prepared.
type Smooth<'s> = scene::Prepared<'s, 'static, Multisampled<Rgb565>>;

/// The samples of a row, those of a pixel one after the other.
type Samples = [[u16; Rooks::<4>::SAMPLES]; COLUMNS];

/// The torus and the cube of [`TorusAndCube`], smooth.
pub struct SmoothTorusAndCube {
    memory: Memory<Multisampled<Rgb565>, VERTICES, FACES, COLUMNS, ROWS, 80>,
    models: [Model<'static, Rgb565>; 1],
    samples: Samples,
}

impl fmt::Debug for SmoothTorusAndCube {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("SmoothTorusAndCube").finish_non_exhaustive()
    }
}

impl Default for SmoothTorusAndCube {
    fn default() -> Self {
        Self {
            memory: Memory::new(),
            models: [TORUS_AND_CUBE_MODEL],
            samples: [[0; Rooks::<4>::SAMPLES]; COLUMNS],
        }
    }
}

impl Scene for SmoothTorusAndCube {
    type Color = Rgb565;
    type Prepared<'s> = InSamples<'s, Smooth<'s>>;
    const NAME: &'static str = "torus-cube-multisampled";
    const TITLE: &'static str = "torus and cube, four samples a pixel";
    const AREA: Rectangle = TorusAndCube::AREA;
    const BACKGROUND: Rgb565 = TorusAndCube::BACKGROUND;
    const FRAMES: u32 = TorusAndCube::FRAMES;
    const PORTRAIT: u32 = TorusAndCube::PORTRAIT;
    const DEPTH_ROW_BYTES: usize = size_of::<[u16; COLUMNS]>();

    fn prepare(&mut self, frame: u32) -> Result<Self::Prepared<'_>, PrepareError> {
        let (camera, pose) = stage::<Torus>(Self::AREA, frame % Self::FRAMES)?;
        for model in &mut self.models {
            model.pose = pose;
        }
        Ok(InSamples {
            scene: self.memory.prepare(&camera, &self.models)?,
            samples: &mut self.samples,
        })
    }
}

/// A prepared scene and the samples of a row.
#[derive(Debug)]
pub struct InSamples<'s, P> {
    samples: &'s mut Samples,
    scene: P,
}

impl Prepared for InSamples<'_, Smooth<'_>> {
    type Color = Rgb565;

    /// One row after the other, because there are samples of one row.
    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let whole = band.bounding_box();
        for y in whole.rows() {
            let row = Rectangle::new(Point::new(whole.top_left.x, y), Size::new(whole.size.width, 1));
            let Some(Ok(mut row)) = band.row_mut(y).map(|words| Band::<Rgb565, O>::new(row, words)) else {
                continue;
            };
            let drawn = row.multisample(Rooks::<4>, self.samples.as_flattened_mut(), |samples| {
                self.scene.draw_samples(samples);
            });
            debug_assert!(drawn.is_ok(), "bands are no wider than the picture");
        }
    }
}
