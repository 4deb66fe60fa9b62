//! The standard scenes at 128 x 64 and the teapot at 240 x 320, drawn through one row of colours and one row of depths.

use core::{convert::Infallible, hint::black_box, marker::PhantomData, ptr};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use zrow::{
    band::{Band, PictureLoop},
    coverage::{Rooks, SamplePattern},
    draw::{Picture, PictureSlot},
    scene::{Antialiased, InstructionSet, Look, Memory, Multisampled, Prepared, SceneItem},
    shade::{Bilinear, FlatLit, Gouraud, LitTextured, Texels, Textured, WithPlanes},
    visible::Visibility,
};
use zrow_scenes::{
    effects::{SmoothPot, SurfacePot},
    standard::{SmallCube, SmallSphere, SmallTorus, Subject, stage},
    teapots::{FlatLitPot, FlatPot, GouraudPot, PlanePot, TexturedPot, TexturedSquare},
};

use crate::{
    report,
    run::Runner,
    run::{Canvas, Checksum},
};

/// Frames of a scene.
pub const FRAMES: u32 = 64;
/// The instruction set that the program was compiled for: the smaller one cannot exchange a byte in memory.
pub const INSTRUCTION_SET: InstructionSet = if cfg!(target_has_atomic = "8") {
    InstructionSet::Armv7M
} else {
    InstructionSet::Armv6M
};
/// The frames, to count each of them.
pub const FRAME_NUMBERS: [u32; FRAMES as usize] = {
    let mut numbers = [0; FRAMES as usize];
    let mut frame = 0;
    while frame < FRAMES {
        numbers[frame as usize] = frame;
        frame += 1;
    }
    numbers
};
/// Every second frame, for scenes of which all frames together take longer than the stopwatch counts on a Cortex-M0+, 671 million
/// instructions.
const EVERY_SECOND_FRAME: [u32; FRAMES as usize / 2] = {
    let mut numbers = [0; FRAMES as usize / 2];
    let mut index = 0;
    while index < numbers.len() {
        numbers[index] = 2 * index as u32;
        index += 1;
    }
    numbers
};

/// Standard scene 1, a torus and a cube within it, in the plainest look or another one, with slots for all faces in a row.
pub type Sc1<L = Rgb565, const ACTIVE: usize = 60> = Stage<SmallTorus, L, 296, 588, ACTIVE>;
/// Standard scene 1 with a quarter of the slots that it needs: half of its rows are drawn in passes.
pub type Sc1InPasses = Stage<SmallTorus, Rgb565, 296, 588, 15>;
/// Standard scene 2: an icosphere.
pub type Sc2 = Stage<SmallSphere, Rgb565, 162, 320, 20>;
/// Standard scene 3: a cube.
pub type Sc3 = Stage<SmallCube, Rgb565, 8, 12, 6>;
/// The Utah teapot.
pub type FlatTeapot = Stage<FlatPot, Rgb565, 560, 992, 91, 240, 320>;
/// The Utah teapot in one colour under a light, each face in one brightness.
pub type FlatLitTeapot = Stage<FlatLitPot, FlatLit<Rgb565>, 560, 992, 91, 240, 320>;
/// The Utah teapot in one colour under a light.
pub type GouraudTeapot = Stage<GouraudPot, Gouraud<Rgb565>, 560, 992, 91, 240, 320>;
/// The Utah teapot with a texture under a light.
pub type TexturedTeapot = Stage<TexturedPot, LitTextured<Texels<Rgb565, 64, 64>>, 560, 992, 91, 240, 320>;
/// The Utah teapot under a light with a texture whose texels are mixed.
pub type BilinearTeapot = Stage<SmoothPot, LitTextured<Bilinear<Texels<Rgb565, 64, 64>>>, 560, 992, 91, 240, 320>;
/// The Utah teapot with antialiased silhouettes.
pub type SilhouetteTeapot = Stage<SurfacePot, Antialiased<Rgb565>, 560, 992, 91, 240, 320>;
/// The Utah teapot with four samples a pixel.
pub type MultisampledTeapot = through::Samples<FlatPot, Multisampled<Rgb565>>;
/// The Utah teapot whose back faces are culled by their planes.
pub type FlatPlaneTeapot = PlaneTeapot<FlatPot>;
/// The Utah teapot in one colour under a light, each face in one brightness, whose back faces are culled by their planes.
pub type FlatLitPlaneTeapot = PlaneTeapot<FlatLitPot>;
/// The Utah teapot in one colour under a light, whose back faces are culled by their planes.
pub type GouraudPlaneTeapot = PlaneTeapot<GouraudPot>;
/// The Utah teapot with a texture under a light, whose back faces are culled by their planes.
pub type TexturedPlaneTeapot = PlaneTeapot<TexturedPot>;
/// A Utah teapot whose back faces are culled by their planes.
pub type PlaneTeapot<S> = Stage<PlanePot<S>, WithPlanes<<S as Subject>::Shading>, 560, 992, 91, 240, 320>;
/// A square of up to 200 x 200 pixels with a texture in perspective.
pub type TexturedQuad = Stage<TexturedSquare, Textured<Texels<Rgb565, 64, 64>>, 4, 2, 2, 240, 320>;

/// The Utah teapot with an effect, in a look.
pub mod through {
    use super::{InSamples, Stage};

    /// Through a row of pixels.
    pub type Row<S, L> = Stage<S, L, 560, 992, 91, 240, 320>;
    /// Through a row of samples, in which more faces are met than in one of pixels.
    pub type Samples<S, L> = InSamples<Stage<S, L, 560, 992, 128, 240, 320>, 240>;
}

/// All memory that a scene takes, but for the stack: `V` vertices, `F` faces, `A` of them in a row, and the size of the
/// picture.
pub struct Stage<
    S,
    L: Look,
    const V: usize,
    const F: usize,
    const A: usize,
    const COLUMNS: usize = 128,
    const ROWS: usize = 64,
> {
    memory: Memory<L, V, F, COLUMNS, ROWS, A>,
    colors: [u16; COLUMNS],
    subject: PhantomData<S>,
}

impl<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize>
    Stage<S, L, V, F, A, COLUMNS, ROWS>
where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(COLUMNS as u32, ROWS as u32));
    /// Zeros, so that a `static` lies in `.bss` and nothing comes from the stack.
    pub const EMPTY: Self = Self {
        memory: Memory::new(),
        colors: [0; COLUMNS],
        subject: PhantomData,
    };

    /// Prepares a frame and nothing else.
    pub fn prepare(&mut self, frame: u32) {
        let Ok((camera, pose)) = stage::<S>(Self::AREA, frame) else {
            report::exit(false)
        };
        let models = [S::model().with_pose(pose)];
        match self.memory.prepare(&camera, &models) {
            Ok(mut prepared) => {
                black_box(&mut prepared);
            }
            Err(_) => report::exit(false),
        }
    }

    /// Prepares a frame and predicts what drawing it takes.
    pub fn estimate(&mut self, frame: u32) -> u32 {
        let Ok((camera, pose)) = stage::<S>(Self::AREA, frame) else {
            report::exit(false)
        };
        let models = [S::model().with_pose(pose)];
        let Ok(mut prepared) = self.memory.prepare(&camera, &models) else {
            report::exit(false)
        };
        black_box(&mut prepared).estimate(INSTRUCTION_SET)
    }

    /// Prepares a frame, predicts what drawing it takes, and draws it.
    pub fn estimate_and_draw(&mut self, frame: u32) -> u32 {
        let mut estimate = 0;
        self.prepared_rows(
            frame,
            |prepared| estimate = black_box(prepared).estimate(INSTRUCTION_SET),
            |words| {
                black_box(words);
            },
        );
        estimate
    }

    /// Draws a frame: prepares it, clears and draws every row. A display would take the row by DMA from here on.
    pub fn draw(&mut self, frame: u32) {
        self.rows(frame, |words| {
            black_box(words);
        });
    }

    /// Draws a frame and stores every pixel, big-endian, in one place, as in the register of a display without DMA.
    pub fn display(&mut self, frame: u32) {
        let mut register = 0;
        self.rows(frame, |words| {
            for &word in words {
                // SAFETY: a variable of its own; volatile, so that every store is made.
                unsafe { ptr::write_volatile(&mut register, word.swap_bytes()) };
            }
        });
    }

    /// Draws a frame by another method than the depth row, and hands over its rows.
    #[inline(always)]
    pub fn rows_by(&mut self, frame: u32, method: &mut impl Visibility<L::Depth>, output: impl FnMut(&[u16])) {
        let draw = |prepared: &mut Prepared<'_, '_, L>, band: &mut Band<'_, Rgb565>| {
            if prepared.draw_by(method, band).is_err() {
                report::exit(false)
            }
        };
        self.drawn_rows(frame, |_| {}, draw, output);
    }

    /// Prepares a frame and draws it into a band of the whole picture.
    #[inline(always)]
    pub fn draw_whole(
        &mut self,
        frame: u32,
        words: &mut [u16],
        draw: impl FnOnce(&mut Prepared<'_, '_, L>, &mut Band<'_, Rgb565>),
    ) {
        let Ok((camera, pose)) = stage::<S>(Self::AREA, frame) else {
            report::exit(false)
        };
        let models = [S::model().with_pose(pose)];
        let (Ok(mut prepared), Ok(mut band)) = (self.memory.prepare(&camera, &models), Band::new(Self::AREA, words))
        else {
            report::exit(false)
        };
        draw(&mut prepared, &mut band);
    }

    /// Draws a frame as the only item of a picture.
    pub fn draw_item(&mut self, frame: u32) {
        let Ok((camera, pose)) = stage::<S>(Self::AREA, frame) else {
            report::exit(false)
        };
        let (mut slots, mut buckets) = ([PictureSlot::EMPTY; 1], [0; ROWS]);
        let Ok(scene) = SceneItem::new(self.memory.frame(), &camera, [S::model().with_pose(pose)]) else {
            report::exit(false)
        };
        let mut picture = Picture::new(Self::AREA, &mut slots, &mut [], &mut buckets);
        if picture.add_item(&scene).is_err() {
            report::exit(false)
        }
        let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
            black_box(band.words());
            Ok(())
        };
        let drawn = PictureLoop::new(Self::AREA, Rgb565::BLACK).draw(&mut self.colors, &mut sink, |band| {
            picture.draw(band);
        });
        if drawn.is_err() {
            report::exit(false)
        }
    }

    /// Draws a frame and hands over its rows.
    #[inline(always)]
    pub fn rows(&mut self, frame: u32, output: impl FnMut(&[u16])) {
        self.prepared_rows(frame, |_| {}, output);
    }

    #[inline(always)]
    fn prepared_rows(&mut self, frame: u32, before: impl FnMut(&mut Prepared<'_, '_, L>), output: impl FnMut(&[u16])) {
        self.drawn_rows(frame, before, |prepared, band| prepared.draw(band), output);
    }

    #[inline(always)]
    fn drawn_rows(
        &mut self,
        frame: u32,
        mut before: impl FnMut(&mut Prepared<'_, '_, L>),
        mut draw: impl FnMut(&mut Prepared<'_, '_, L>, &mut Band<'_, Rgb565>),
        mut output: impl FnMut(&[u16]),
    ) {
        let Ok((camera, pose)) = stage::<S>(Self::AREA, frame) else {
            report::exit(false)
        };
        let models = [S::model().with_pose(pose)];
        let Ok(mut prepared) = self.memory.prepare(&camera, &models) else {
            report::exit(false)
        };
        before(&mut prepared);
        let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
            output(band.words());
            Ok(())
        };
        let picture = PictureLoop::new(Self::AREA, Rgb565::BLACK);
        let drawn = picture.draw(&mut self.colors, &mut sink, |band: &mut Band<'_, Rgb565>| {
            draw(&mut prepared, band);
        });
        if drawn.is_err() {
            report::exit(false)
        }
    }
}

impl<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize> Canvas
    for Stage<S, L, V, F, A, COLUMNS, ROWS>
where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    fn erase(&mut self) {}

    /// Of all pixels of all frames, which are drawn once more for that.
    fn checksum(&mut self) -> u32 {
        checksum_of_frames(|frame, words| self.rows(frame, words))
    }
}

/// The checksum of all pixels of all frames. `rows` draws a frame and hands over each of its rows.
pub fn checksum_of_frames(mut rows: impl FnMut(u32, &mut dyn FnMut(&[u16]))) -> u32 {
    let mut sum = Checksum::default();
    for frame in 0..FRAMES {
        rows(frame, &mut |words| sum.add(words.iter().copied()));
    }
    sum.0
}

/// Counts what preparing a frame takes, drawing it, and drawing it for a display, where it is asked for.
pub fn count<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize>(
    runner: &mut Runner,
    name: &str,
    stage: &mut Stage<S, L, V, F, A, COLUMNS, ROWS>,
) where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    if runner.wants(name) {
        runner.count(name, "prepare", stage, &FRAME_NUMBERS, |stage, &frame| {
            stage.prepare(frame)
        });
        runner.count(name, "draw", stage, &FRAME_NUMBERS, |stage, &frame| stage.draw(frame));
        runner.count(name, "display", stage, &FRAME_NUMBERS, |stage, &frame| {
            stage.display(frame)
        });
    }
}

/// Counts what drawing a frame takes as an item of a picture, where it is asked for.
pub fn count_item<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize>(
    runner: &mut Runner,
    name: &str,
    stage: &mut Stage<S, L, V, F, A, COLUMNS, ROWS>,
) where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    if runner.wants(name) {
        runner.count(name, "item", stage, &FRAME_NUMBERS, |stage, &frame| {
            stage.draw_item(frame);
        });
    }
}

/// A stage and the four samples of each pixel of a row.
pub struct InSamples<T, const COLUMNS: usize> {
    stage: T,
    samples: [[u16; Rooks::<4>::SAMPLES]; COLUMNS],
}

impl<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize>
    InSamples<Stage<S, L, V, F, A, COLUMNS, ROWS>, COLUMNS>
where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    /// Zeros, so that a `static` lies in `.bss` and nothing comes from the stack.
    pub const EMPTY: Self = Self {
        stage: Stage::EMPTY,
        samples: [[0; Rooks::<4>::SAMPLES]; COLUMNS],
    };

    /// Draws a frame: prepares it, clears and draws every row, and averages its samples.
    pub fn draw(&mut self, frame: u32) {
        self.rows(frame, |words| {
            black_box(words);
        });
    }

    fn rows(&mut self, frame: u32, output: impl FnMut(&[u16])) {
        let Self { stage, samples } = self;
        let draw = |prepared: &mut Prepared<'_, '_, L>, band: &mut Band<'_, Rgb565>| {
            let drawn = band.multisample(Rooks::<4>, samples.as_flattened_mut(), |samples| {
                prepared.draw_samples(samples);
            });
            if drawn.is_err() {
                report::exit(false)
            }
        };
        stage.drawn_rows(frame, |_| {}, draw, output);
    }
}

impl<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize> Canvas
    for InSamples<Stage<S, L, V, F, A, COLUMNS, ROWS>, COLUMNS>
where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    fn erase(&mut self) {}

    /// Of all pixels of all frames, which are drawn once more for that.
    fn checksum(&mut self) -> u32 {
        checksum_of_frames(|frame, words| self.rows(frame, words))
    }
}

/// Counts what drawing a frame takes with four samples a pixel, where it is asked for.
pub fn count_samples<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize>(
    runner: &mut Runner,
    name: &str,
    stage: &mut InSamples<Stage<S, L, V, F, A, COLUMNS, ROWS>, COLUMNS>,
) where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    if runner.wants(name) {
        runner.count(name, "draw", stage, &EVERY_SECOND_FRAME, |stage, &frame| {
            stage.draw(frame)
        });
    }
}
