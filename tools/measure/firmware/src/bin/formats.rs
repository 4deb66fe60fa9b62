//! Counts small scenes in looks whose numbers have other formats, and ways to sines and cosines.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb888;
use heapless::Vec;
use zrow::scene::Look;
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_methods::{
    TRIGONOMETRY, TRIGONOMETRY_COUNT,
    space::{
        DEPTH_GROUPS, MATRIX_GROUPS, PERSPECTIVE_GROUPS, POSITION_GROUPS, SPACE_SCENES, SpaceGroup, SpaceInput,
        SpaceRun, SpaceShading, SpaceStage,
    },
};

/// A scene in memory, and its picture.
struct Frames<L: Look>(SpaceStage<L>);

impl<L: Look<Color = Rgb888, Shading: SpaceShading>> Canvas for Frames<L> {
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        let halves = |word: &u32| [*word as u16, (word >> 16) as u16];
        Checksum::of(self.0.words().iter().flat_map(halves))
    }
}

/// A sum of all results.
struct Sum(u32);

impl Canvas for Sum {
    fn erase(&mut self) {
        self.0 = 0;
    }

    fn checksum(&mut self) -> u32 {
        self.0
    }
}

/// What is counted of a scene.
#[derive(Clone, Copy, PartialEq, Eq)]
enum What {
    Preparing,
    Drawing,
}

#[entry]
fn main() -> ! {
    let mut words = [0; 1024];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    depths(&mut runner);
    corners(&mut runner);
    matrices(&mut runner);
    textures(&mut runner);
    sines(&mut runner);
    report::exit(true)
}

/// Counts each look of a list on the scenes of each group. The first argument is a dollar sign.
macro_rules! count_looks {
    ($dollar:tt $function:ident, $list:ident, $groups:ident, $what:expr) => {
        #[inline(never)]
        fn $function(runner: &mut Runner) {
            macro_rules! each {
                ($dollar([$dollar variant:ident] [$dollar look:ty] $dollar name:literal, $dollar near:literal;)+) => {$dollar({
                    let stage = cortex_m::singleton!(: Frames<$dollar look> = Frames(SpaceStage::new()));
                    let Some(stage) = stage else { report::exit(false) };
                    count_groups(runner, stringify!($dollar variant), stage, $groups, $dollar near, $what);
                })+};
            }
            zrow_methods::$list!(each);
        }
    };
}
count_looks!($ depths, depth_widths, DEPTH_GROUPS, What::Drawing);
count_looks!($ corners, positions, POSITION_GROUPS, What::Drawing);
count_looks!($ matrices, matrix_formats, MATRIX_GROUPS, What::Preparing);
count_looks!($ textures, perspectives, PERSPECTIVE_GROUPS, What::Drawing);

#[inline(never)]
fn count_groups<L: Look<Color = Rgb888, Shading: SpaceShading>>(
    runner: &mut Runner,
    variant: &str,
    stage: &mut Frames<L>,
    groups: &[SpaceGroup],
    near: i32,
    what: What,
) {
    for group in groups {
        if runner.wants(group.count) {
            let inputs: Vec<SpaceInput, SPACE_SCENES> = (0..SPACE_SCENES as u32)
                .map(|number| group.input(number, near))
                .collect();
            runner.count(group.count, variant, stage, &inputs, |stage, input| {
                let done = match what {
                    What::Preparing => stage.0.prepare(input),
                    What::Drawing => stage.0.draw(input, 0).map(|_| ()),
                };
                if done.is_err() {
                    report::exit(false)
                }
            });
        }
    }
}

fn sines(runner: &mut Runner) {
    if !runner.wants(TRIGONOMETRY_COUNT) {
        return;
    }
    let angles: [u16; 256] = core::array::from_fn(|index| index as u16 * 257);
    for method in TRIGONOMETRY {
        runner.count(
            TRIGONOMETRY_COUNT,
            method.variant,
            &mut Sum(0),
            &angles,
            |sum, &angle| {
                let [sine, cosine] = (method.sine_cosine)(angle);
                sum.0 = sum.0.rotate_left(5) ^ sine as u32 ^ (cosine as u32).rotate_left(16);
            },
        );
    }
}
