//! Counts panels of antialiased shapes at 240 x 320 through one row: the instruments, their aliased twin, and the cockpit.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::{draw::Picture, geometry::Window};
use zrow_measure_firmware::{
    panel::{draw_area, draw_changes, draw_frame},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_scenes::{
    Scene,
    cockpit::Cockpit,
    instruments::{Changing, DAMAGE_AREAS, Instruments, Jagged, Replayed, Smooth},
};

const FRAMES: usize = 16;

/// A scene and its one row.
struct Shown<S> {
    scene: S,
    row: [u16; 240],
}

impl<S: Scene<Color = Rgb565>> Shown<S> {
    fn new() -> Self {
        Self {
            scene: S::default(),
            row: [0; 240],
        }
    }

    /// Prepares a frame, draws it row by row, and hands on every row.
    fn draw(&mut self, frame: u32, output: impl FnMut(&[u16])) {
        draw_frame(&mut self.scene, frame, &mut self.row, output);
    }
}

impl<S: Scene<Color = Rgb565>> Canvas for Shown<S> {
    fn erase(&mut self) {}

    fn checksum(&mut self) -> u32 {
        checksum_of(|frame, sum| self.draw(frame, |words| sum.add(words.iter().copied())))
    }
}

/// The checksum of all pixels of all frames, which are drawn once more for that.
fn checksum_of(mut draw: impl FnMut(u32, &mut Checksum)) -> u32 {
    let mut sum = Checksum::default();
    for frame in frames() {
        draw(frame, &mut sum);
    }
    sum.0
}

/// The frames that are drawn.
fn frames() -> [u32; FRAMES] {
    core::array::from_fn(|frame| 4 * frame as u32)
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    count::<Replayed<Smooth>>(&mut runner, "scene.instruments", "antialiased");
    count::<Replayed<Jagged>>(&mut runner, "scene.instruments", "aliased");
    count::<Instruments>(&mut runner, "scene.instruments", "picture");
    count::<Cockpit>(&mut runner, "scene.cockpit", "picture");
    count_change(&mut runner);
    report::exit(true)
}

/// The panel as a picture that lives on, of which only what changes is drawn.
struct Moving<'m> {
    picture: Picture<'m, 'static, Rgb565>,
    changing: Changing,
    row: [u16; 240],
}

impl Moving<'_> {
    /// Draws what has changed, and hands on every row of it.
    fn draw_changes(&mut self, output: impl FnMut(&[u16])) {
        draw_changes(&mut self.picture, Instruments::BACKGROUND, &mut self.row, output);
    }
}

impl Canvas for Moving<'_> {
    /// What is there already is on the display.
    fn erase(&mut self) {
        self.picture.clear_damage();
    }

    /// The checksum of the whole picture as it is in the end.
    fn checksum(&mut self) -> u32 {
        let mut sum = Checksum::default();
        let whole = (Instruments::AREA, Instruments::BACKGROUND);
        draw_area(&mut self.picture, whole, &mut self.row, |words| {
            sum.add(words.iter().copied())
        });
        sum.0
    }
}

/// The arc, the needle and the digits in each of the 64 frames after the one before: preparing them and drawing what changes.
#[inline(never)]
fn count_change(runner: &mut Runner) {
    let (mut panel, mut areas) = (Instruments::new(), [Window::EMPTY; DAMAGE_AREAS]);
    let mut picture = panel.picture_with_damage(&mut areas);
    let Ok(changing) = Changing::add(&mut picture, 0) else {
        report::exit(false)
    };
    let mut moving = Moving {
        picture,
        changing,
        row: [0; 240],
    };
    let steps: [u32; 64] = core::array::from_fn(|frame| frame as u32 + 1);
    runner.count(
        "scene.instruments.needle",
        "picture",
        &mut moving,
        &steps,
        |moving, &frame| {
            if moving.changing.show(&mut moving.picture, frame).is_err() {
                report::exit(false)
            }
            moving.draw_changes(|words| {
                black_box(words);
            });
        },
    );
}

#[inline(never)]
fn count<S: Scene<Color = Rgb565>>(runner: &mut Runner, name: &str, variant: &str) {
    let mut panel = Shown::<S>::new();
    runner.count(name, variant, &mut panel, &frames(), |panel, &frame| {
        // A display would take the row by DMA from here on.
        panel.draw(frame, |words| {
            black_box(words);
        });
    });
}
