//! Counts what drawing a prepared frame takes, and reports what was predicted, in scenes of many sizes and poses.
#![no_std]
#![no_main]

use core::{hint::black_box, marker::PhantomData};

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use fixed::types::{I16F16, U0F16};
use zrow::{
    scene::{Antialiased, Deep, FaceSet, Fine, Look, Model, Rotation},
    shade::{Bilinear, FlatLit, Gouraud, GouraudSkin, Lambert, LitTextured, Texels, Textured},
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    standard::Stage,
    stopwatch::Stopwatch,
};
use zrow_scenes::{
    effects::{
        EverythingPot, FoggyPot, IndexedPot, LacePot, ShadingOf, SmoothPot, SurfacePot, TranslucentPot, UnlitPot,
        WithEverything,
    },
    meshes::ICOSPHERE,
    standard::{SmallCube, SmallSphere, SmallTorus, Subject},
    teapot::{SMALL_TEAPOT, SMALL_TEAPOT_COLORS},
    teapots::{FlatLitPot, FlatPot, GouraudPot, TexturedPot, TexturedSquare},
};

/// Frames of a scene, a sixteenth of a turn about the upright axis apart.
const FRAMES: [u32; 16] = [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60];

/// A subject at another distance, in parts of 1/100 of its own.
#[derive(Debug)]
struct At<S, const PERCENT: i32>(PhantomData<S>);

impl<S: Subject, const PERCENT: i32> Subject for At<S, PERCENT> {
    const NAME: &'static str = S::NAME;
    const TITLE: &'static str = S::TITLE;
    const SIZE: Size = S::SIZE;
    const DISTANCE: I16F16 = I16F16::from_bits(S::DISTANCE.to_bits() / 100 * PERCENT);
    type Shading = S::Shading;

    fn rotation(frame: u32) -> Rotation {
        S::rotation(frame)
    }

    fn model() -> Model<'static, S::Shading> {
        S::model()
    }
}

/// A subject that turns about another axis.
#[derive(Debug)]
struct Rolling<S>(PhantomData<S>);

impl<S: Subject> Subject for Rolling<S> {
    const NAME: &'static str = S::NAME;
    const TITLE: &'static str = S::TITLE;
    const SIZE: Size = S::SIZE;
    const DISTANCE: I16F16 = S::DISTANCE;
    type Shading = S::Shading;

    fn rotation(frame: u32) -> Rotation {
        let turn = U0F16::from_bits((frame * 1_024) as u16);
        Rotation::about_x(U0F16::from_num(0.125)).then(&Rotation::about_z(turn))
    }

    fn model() -> Model<'static, S::Shading> {
        S::model()
    }
}

/// A mesh as a subject.
macro_rules! subject {
    ($(#[$doc:meta])+ $subject:ident, $shading:ty, $mesh:expr, $skin:expr) => {
        $(#[$doc])+
        #[derive(Debug)]
        struct $subject;

        impl Subject for $subject {
            const NAME: &'static str = stringify!($subject);
            const TITLE: &'static str = Self::NAME;
            const SIZE: Size = Size::new(240, 320);
            const DISTANCE: I16F16 = I16F16::lit("1000");
            type Shading = $shading;

            fn model() -> Model<'static, $shading> {
                match Model::with_skin($mesh, $skin) {
                    Ok(model) => model,
                    Err(_) => report::exit(false),
                }
            }
        }
    };
}

subject!(
    /// The teapot of fewer faces.
    SmallPot, Rgb565, SMALL_TEAPOT, SMALL_TEAPOT_COLORS.as_slice()
);
subject!(
    /// A sphere whose colours vary over each face.
    ShadedSphere, Gouraud<Rgb565, Lambert<0>>, ICOSPHERE, GouraudSkin {
        colors: &SPHERE_COLORS,
        normals: &[],
        lights: Lambert { ambient: U0F16::MAX, lights: [], points: [] },
    }
);
subject!(
    /// A sheet of hills.
    Hills, Rgb565, HILLS, HILL_COLORS.as_slice()
);

/// A colour for each vertex of the sphere.
static SPHERE_COLORS: [Rgb565; 162] = {
    let mut colors = [Rgb565::BLACK; 162];
    let mut vertex = 0;
    while vertex < 162 {
        colors[vertex] = Rgb565::new(vertex as u8 % 32, vertex as u8 % 64, 31 - vertex as u8 % 32);
        vertex += 1;
    }
    colors
};

/// Cells of a side of the hills.
const CELLS: usize = 16;
const HILL_VERTICES: usize = (CELLS + 1) * (CELLS + 1);
const HILL_FACES: usize = 2 * CELLS * CELLS;

static HILL_COLORS: [Rgb565; HILL_FACES] = [Rgb565::CSS_SEA_GREEN; HILL_FACES];

static HILLS: FaceSet = {
    static VERTICES: [[i16; 3]; HILL_VERTICES] = {
        let mut vertices = [[0; 3]; HILL_VERTICES];
        let mut index = 0;
        while index < HILL_VERTICES {
            let (x, y) = ((index % (CELLS + 1)) as i16, (index / (CELLS + 1)) as i16);
            vertices[index] = [x * 80 - 640, y * 80 - 640, (x * 37 + y * 53 + x * y * 11) % 90];
            index += 1;
        }
        vertices
    };
    static FACES: [[u16; 3]; HILL_FACES] = {
        let mut faces = [[0; 3]; HILL_FACES];
        let mut cell = 0;
        while cell < CELLS * CELLS {
            let side = CELLS as u16 + 1;
            let corner = (cell / CELLS) as u16 * side + (cell % CELLS) as u16;
            faces[2 * cell] = [corner, corner + side, corner + side + 1];
            faces[2 * cell + 1] = [corner, corner + side + 1, corner + 1];
            cell += 1;
        }
        faces
    };
    match FaceSet::new(&VERTICES, &FACES) {
        Ok(faces) => faces,
        Err(_) => panic!("a face names a vertex that is not there"),
    }
};

/// A scene of which the pixels of one frame are kept: of all frames they would take most of the time.
struct OneFrame<'s, T>(&'s mut T);

impl<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize> Canvas
    for OneFrame<'_, Stage<S, L, V, F, A, COLUMNS, ROWS>>
where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        let mut sum = Checksum::default();
        self.0.rows(FRAMES[5], |words| sum.add(words.iter().copied()));
        sum.0
    }
}

/// Counts preparing, predicting and drawing, and reports the mean of what was predicted.
fn count<S, L, const V: usize, const F: usize, const A: usize, const COLUMNS: usize, const ROWS: usize>(
    runner: &mut Runner,
    name: &str,
    stage: &mut Stage<S, L, V, F, A, COLUMNS, ROWS>,
) where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    let scene = &mut OneFrame(stage);
    runner.count(name, "prepare", scene, &FRAMES, |scene, &frame| scene.0.prepare(frame));
    runner.count(name, "estimate", scene, &FRAMES, |scene, &frame| {
        black_box(scene.0.estimate(frame));
    });
    // Predicted where it is counted: whether rows need depths depends on the frames before.
    let mut sum = 0;
    runner.count(name, "draw", scene, &FRAMES, |scene, &frame| {
        sum += scene.0.estimate_and_draw(frame) / FRAMES.len() as u32;
    });
    report::line("prediction")
        .text("name", name)
        .number("instructions", sum)
        .end();
}

/// Counts each scene that is asked for, in memory of its own.
macro_rules! count {
    ($runner:ident, $($name:literal: $subject:ty, $look:ty, [$($size:literal),+];)+) => {$(
        if $runner.wants($name) {
            type Scene = Stage<$subject, $look, $($size),+>;
            let Some(stage) = cortex_m::singleton!(: Scene = Scene::EMPTY) else {
                report::exit(false)
            };
            count(&mut $runner, $name, stage);
        }
    )+};
}

#[entry]
fn main() -> ! {
    let mut words = [0; 2_048];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    type Texture = Texels<Rgb565, 64, 64>;
    // The numbers are vertices, faces, faces in a row, columns and rows. A scene with cut faces has room for the fragments.
    count!(
        runner,
        "estimate.sc1": SmallTorus, Rgb565, [296, 588, 60];
        "estimate.sc1_passes": SmallTorus, Rgb565, [296, 588, 15];
        "estimate.sc1_fine": SmallTorus, Fine<Rgb565>, [296, 588, 60];
        "estimate.sc1_deep": SmallTorus, Deep<Rgb565>, [296, 588, 60];
        "estimate.sc2": SmallSphere, Rgb565, [162, 320, 20];
        "estimate.sc3": SmallCube, Rgb565, [8, 12, 6];
        "estimate.flat": FlatPot, Rgb565, [560, 992, 91, 240, 320];
        "estimate.fine_deep": FlatPot, Fine<Deep<Rgb565>>, [560, 992, 91, 240, 320];
        "estimate.flat_lit": FlatLitPot, FlatLit<Rgb565>, [560, 992, 91, 240, 320];
        "estimate.gouraud": GouraudPot, Gouraud<Rgb565>, [560, 992, 91, 240, 320];
        "estimate.textured": UnlitPot, Textured<Texture>, [560, 992, 91, 240, 320];
        "estimate.textured_lit": TexturedPot, LitTextured<Texture>, [560, 992, 91, 240, 320];
        "estimate.bilinear": SmoothPot, LitTextured<Bilinear<Texture>>, [560, 992, 91, 240, 320];
        "estimate.indexed": IndexedPot, ShadingOf<IndexedPot>, [560, 992, 91, 240, 320];
        "estimate.holes": LacePot, ShadingOf<LacePot>, [560, 992, 91, 240, 320];
        "estimate.fog": FoggyPot, ShadingOf<FoggyPot>, [560, 992, 91, 240, 320];
        "estimate.translucent": TranslucentPot, ShadingOf<TranslucentPot>, [560, 992, 91, 240, 320];
        "estimate.silhouettes": SurfacePot, Antialiased<Rgb565>, [560, 992, 91, 240, 320];
        "estimate.everything": EverythingPot, WithEverything<EverythingPot>, [560, 992, 91, 240, 320];
        "estimate.square": TexturedSquare, Textured<Texture>, [4, 2, 2, 240, 320];
        // Scenes that no weight was fitted to.
        "estimate.other.torus": At<SmallTorus, 75>, Rgb565, [296, 588, 90, 320, 240];
        "estimate.other.cube": At<SmallCube, 80>, Rgb565, [8, 12, 6, 320, 240];
        "estimate.other.sphere": At<SmallSphere, 70>, Rgb565, [162, 320, 30, 240, 320];
        "estimate.other.shaded_sphere": ShadedSphere, Gouraud<Rgb565, Lambert<0>>, [162, 320, 30, 240, 320];
        "estimate.other.hills": Rolling<Hills>, Rgb565, [289, 512, 100, 240, 320];
        "estimate.other.cut_hills": At<Rolling<Hills>, 30>, Rgb565, [1_200, 512, 100, 240, 320];
        "estimate.other.small_pot": Rolling<SmallPot>, Rgb565, [156, 240, 60, 240, 320];
        "estimate.other.near": At<Rolling<FlatPot>, 55>, Rgb565, [1_600, 992, 91, 240, 320];
        "estimate.other.far": At<FlatPot, 220>, Rgb565, [560, 992, 120, 128, 64];
        "estimate.other.gouraud": At<Rolling<GouraudPot>, 80>, Gouraud<Rgb565>, [560, 992, 120, 320, 240];
        "estimate.other.gouraud_far": At<GouraudPot, 200>, Gouraud<Rgb565>, [560, 992, 120, 128, 64];
        "estimate.other.textured": At<Rolling<TexturedPot>, 130>, LitTextured<Texture>, [560, 992, 120, 320, 240];
        "estimate.other.textured_far": At<TexturedPot, 200>, LitTextured<Texture>, [560, 992, 120, 128, 64];
        "estimate.other.fog": At<Rolling<FoggyPot>, 80>, ShadingOf<FoggyPot>, [1_600, 992, 120, 320, 240];
        "estimate.other.translucent": Rolling<TranslucentPot>, ShadingOf<TranslucentPot>, [560, 992, 120, 240, 320];
        "estimate.other.silhouettes": At<Rolling<SurfacePot>, 150>, Antialiased<Rgb565>, [560, 992, 120, 240, 320];
        "estimate.other.square": At<TexturedSquare, 150>, Textured<Texture>, [4, 2, 2, 240, 320];
    );
    report::exit(true)
}
