//! The OLED of the LM3S6965EVB in QEMU, against the simulator.

mod panel;
mod qemu;

use crate::firmware;
use anyhow::{Context, Result};
use embedded_graphics::{pixelcolor::Gray4, prelude::*};
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use indicatif::{ProgressBar, ProgressStyle};
use panel::Panel;
use qemu::Qemu;
use std::path::Path;
use zrow::band::DisplaySink;
use zrow_scenes::{
    Prepared, Scene,
    oled::{self, Oled},
    oled_teapot::OledTeapot,
};

/// With `-icount shift=0` an instruction takes 1 ns, and SysTick ticks at the board's 12.5 MHz.
const INSTRUCTIONS_PER_TICK: u64 = 80;

/// Compares so many frames of both scenes, all where no number is given; returns how many pixels differ.
pub fn compare_scenes(frames: Option<u32>, output: &Path) -> Result<usize> {
    let run = Run {
        frames: frames.map_or(oled::FRAMES, |frames| frames.min(oled::FRAMES)),
        output,
    };
    let program = firmware::build("lm3s6965evb", "thumbv7m-none-eabi")?;
    let mut qemu = Qemu::start(&program)?;
    Ok(compare::<Oled>(&mut qemu, &run)? + compare::<OledTeapot>(&mut qemu, &run)?)
}

/// How many frames are compared, and where their pictures go.
struct Run<'a> {
    frames: u32,
    output: &'a Path,
}

/// Compares the frames of a scene; returns how many pixels differ.
fn compare<S: Scene<Color = Gray4>>(qemu: &mut Qemu, run: &Run<'_>) -> Result<usize> {
    let mut simulator = Simulator::<S>::default();
    let progress = ProgressBar::new(run.frames.into()).with_style(ProgressStyle::with_template(
        "{prefix} {bar:40} frame {pos}/{len} {msg}",
    )?);
    progress.set_prefix(S::NAME);
    let (mut differing, mut ticks, mut sending) = (0, 0, 0);
    for frame in 0..S::FRAMES {
        let taken = qemu.wait_for_frame(S::NAME, frame)?;
        // The firmware shows all frames of a scene before it goes on to the next one.
        if frame < run.frames {
            ticks += taken.frame;
            sending += taken.sending;
            let emulated = Panel::from_screendump(&qemu.screendump(&run.output.join("panel.ppm"))?)?;
            let drawn = simulator.draw(frame)?;
            let picture = |side| run.output.join(format!("{}-{frame:02}-{side}.png", S::NAME));
            emulated.save(&picture("emulated"))?;
            simulator.save(&picture("simulator"))?;
            differing += emulated.differing_pixels(&drawn);
            progress.set_message(format!("{differing} differing pixels"));
            progress.inc(1);
        }
        qemu.next_frame()?;
    }
    progress.finish_and_clear();
    let pixels = run.frames * S::AREA.size.width * S::AREA.size.height;
    println!(
        "{}: {differing} differing pixels of {pixels} in {} frames",
        S::NAME,
        run.frames
    );
    let instructions = |ticks: u64| ticks * INSTRUCTIONS_PER_TICK / u64::from(run.frames);
    println!(
        "{} instructions a frame on the emulated Cortex-M3 (mean): {} to prepare and draw it, {} to send it over SPI",
        instructions(ticks),
        instructions(ticks - sending),
        instructions(sending)
    );
    Ok(differing)
}

/// The desktop's side: the same scene code, the same one row.
struct Simulator<S> {
    scene: S,
    display: SimulatorDisplay<Gray4>,
}

impl<S: Scene<Color = Gray4>> Default for Simulator<S> {
    fn default() -> Self {
        Self {
            scene: S::default(),
            display: SimulatorDisplay::new(S::AREA.size),
        }
    }
}

impl<S: Scene<Color = Gray4>> Simulator<S> {
    fn draw(&mut self, frame: u32) -> Result<Panel> {
        let mut row = vec![0; S::AREA.size.width as usize];
        let mut prepared = self.scene.prepare(frame)?;
        S::picture()
            .draw(&mut row, &mut DisplaySink(&mut self.display), |band| {
                prepared.draw(band)
            })
            .context("the simulator's picture")?;
        Ok(Panel::from_pixels(|point| self.display.get_pixel(point).luma()))
    }

    fn save(&self, path: &Path) -> Result<()> {
        let settings = OutputSettingsBuilder::new().scale(panel::MAGNIFICATION).build();
        let image = self.display.to_grayscale_output_image(&settings);
        image
            .save_png(path)
            .with_context(|| format!("cannot write {}", path.display()))
    }
}
