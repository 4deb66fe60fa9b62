//! Counts finding the hidden lines of the teapot and of two solids that go through each other, by each method.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{I2F14, I16F16, U0F16};
use zrow::{
    scene::{Camera, Edge, FaceSet, Memory, Model, Pose, Rotation},
    visible::{Appel, FaceAgainstSegment, HiddenLines, Roberts},
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Runner},
    stopwatch::Stopwatch,
};
use zrow_scenes::{meshes::CUBE, teapot::TEAPOT};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(128, 64));
const FACES: usize = TEAPOT.faces().len();

static COLORS: [Rgb565; FACES] = [Rgb565::BLACK; FACES];

/// The edges of a mesh; faces that turn by more than 30 degrees meet in a crease.
macro_rules! edges {
    ($name:ident: $mesh:expr) => {
        static $name: [Edge; {
            match $mesh.faces().first_chunk::<{ $mesh.faces().len() }>() {
                Some(faces) => FaceSet::count_edges($mesh.vertices(), faces),
                None => panic!("as many faces as there are"),
            }
        }] = match $mesh.faces().first_chunk::<{ $mesh.faces().len() }>() {
            Some(faces) => match FaceSet::find_edges($mesh.vertices(), faces, I2F14::lit("0.866")) {
                Ok(edges) => edges,
                Err(_) => panic!("a face names a vertex that is not there"),
            },
            None => panic!("as many faces as there are"),
        };
    };
}
edges!(TEAPOT_EDGES: TEAPOT);
edges!(CUBE_EDGES: CUBE);

/// Turns about the upright axis that are counted; of the teapot the first one alone, because that takes a hundred times longer.
const FIRST_TURN: U0F16 = U0F16::lit("0.07");
const TURNS: [U0F16; 4] = [FIRST_TURN, U0F16::lit("0.3"), U0F16::lit("0.55"), U0F16::lit("0.8")];

/// The memory of a scene, and a number that depends on every part.
struct Drawing {
    memory: Memory<Rgb565, { TEAPOT.vertices().len() }, FACES, 128, 64>,
    sum: u32,
}

impl Drawing {
    const EMPTY: Self = Self {
        memory: Memory::new(),
        sum: 0,
    };

    /// Prepares models and finds the parts of their edges.
    fn find(&mut self, models: &[Model<'_, Rgb565>], edges: &[&[Edge]], method: &mut impl HiddenLines<u16>) {
        let Self { memory, sum } = self;
        let Ok(camera) = Camera::new(AREA, I16F16::lit("128")) else {
            report::exit(false)
        };
        let Ok(prepared) = memory.prepare(&camera, models) else {
            report::exit(false)
        };
        let found = prepared.visible_parts(method, edges, |part| {
            let [from, to] = part.ends;
            for number in [
                from.x_units(),
                from.y_units(),
                to.x_units(),
                to.y_units(),
                part.is_hidden.into(),
            ] {
                *sum = (*sum ^ number as u32).wrapping_mul(0x0100_0193);
            }
        });
        if found.is_err() {
            report::exit(false)
        }
    }

    /// Counts the teapot.
    fn count_teapot(&mut self, runner: &mut Runner, variant: &str, method: &mut impl HiddenLines<u16>) {
        runner.count("hidden_lines.teapot", variant, self, &[FIRST_TURN], |drawing, &turn| {
            let rotation = Rotation::about_y(turn).then(&Rotation::about_x(U0F16::lit("0.94")));
            drawing.find(&[model(TEAPOT, rotation, [0, 0, 720])], &[&TEAPOT_EDGES], method);
        });
    }

    /// Counts two cubes.
    fn count_solids(&mut self, runner: &mut Runner, variant: &str, method: &mut impl HiddenLines<u16>) {
        runner.count("hidden_lines.solids", variant, self, &TURNS, |drawing, &turn| {
            let rotation = Rotation::about_y(turn).then(&Rotation::about_x(U0F16::lit("0.93")));
            let other = rotation.then(&Rotation::about_x(U0F16::lit("0.1")));
            let models = [
                model(CUBE, rotation, [-120, -130, 1_450]),
                model(CUBE, other, [330, 230, 1_450]),
            ];
            drawing.find(&models, &[&CUBE_EDGES, &CUBE_EDGES], method);
        });
    }
}

fn model(mesh: FaceSet<'static>, rotation: Rotation, at: [i32; 3]) -> Model<'static, Rgb565> {
    let Ok(model) = Model::new(mesh, COLORS.get(..mesh.faces().len()).unwrap_or_default()) else {
        report::exit(false)
    };
    model.with_pose(Pose::new(rotation, at.map(I16F16::from_num)))
}

impl Canvas for Drawing {
    fn erase(&mut self) {
        self.sum = 0x811C_9DC5;
    }

    /// Of the parts of all frames: their ends, and whether they are hidden.
    fn checksum(&mut self) -> u32 {
        self.sum
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let drawing = cortex_m::singleton!(: Drawing = Drawing::EMPTY);
    let segments = cortex_m::singleton!(: FaceAgainstSegment<FACES, 16> = FaceAgainstSegment::new());
    let crossing = cortex_m::singleton!(: FaceAgainstSegment<24, 16, true> = FaceAgainstSegment::new());
    let appel = cortex_m::singleton!(: Appel<300, 64, 1_024> = Appel::new());
    let appel_crossing = cortex_m::singleton!(: Appel<40, 16, 64, true> = Appel::new());
    let roberts = cortex_m::singleton!(: Roberts<2, 60> = Roberts::new());
    let (Some(peripherals), Some(drawing), Some(segments)) = (Peripherals::take(), drawing, segments) else {
        report::exit(false)
    };
    let (Some(crossing), Some(appel), Some(appel_crossing), Some(roberts)) = (crossing, appel, appel_crossing, roberts)
    else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    if runner.wants("hidden_lines.teapot") {
        drawing.count_teapot(&mut runner, "segments", segments);
        drawing.count_teapot(&mut runner, "appel", appel);
        drawing.count_teapot(&mut runner, "roberts", roberts);
    }
    if runner.wants("hidden_lines.solids") {
        drawing.count_solids(&mut runner, "segments", crossing);
        drawing.count_solids(&mut runner, "appel", appel_crossing);
        drawing.count_solids(&mut runner, "roberts", roberts);
    }
    report::exit(true)
}
