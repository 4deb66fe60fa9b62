//! The ST7789 of the Raspberry Pi Pico in rp2040js, against the simulator.

mod rp2040;
mod st7789;

use crate::firmware;
use anyhow::{Context, Result, bail, ensure};
use embedded_graphics::{
    pixelcolor::{Rgb565, raw::RawU16},
    prelude::*,
};
use image::{Rgb, RgbImage};
use rp2040::{Rp2040, Wire};
use st7789::St7789;
use std::{
    convert::Infallible,
    path::Path,
    time::{Duration, Instant},
};
use zrow::band::Band;
use zrow_scenes::{Prepared, Scene, instruments::Instruments, needle::Needle, teapots::TexturedTeapot};

/// Frames of each scene, where no number is given.
const FRAMES: u32 = 3;
/// How often the firmware's loop of known length turns.
const LOOP_TURNS: u32 = 10_000;
/// A subtraction and a branch that is taken, by the Technical Reference Manual of the Cortex-M0+.
const CYCLES_A_TURN: u32 = 1 + 2;
/// What reading the stopwatch twice adds to the loop at most.
const STOPWATCH_CYCLES: u32 = 30;

/// Compares so many frames of each scene; returns how many pixels differ.
pub fn compare_scenes(frames: Option<u32>, output: &Path) -> Result<usize> {
    Rp2040::check_installed()?;
    let program = firmware::build("pico", "thumbv6m-none-eabi")?;
    let frames = frames.unwrap_or(FRAMES);
    let (mut board, line) = Board::start(&program, frames, None)?;
    let cycles = loop_cycles(&line).with_context(|| format!("instead of a loop the firmware said: {line}"))?;
    let expected = LOOP_TURNS * CYCLES_A_TURN;
    ensure!(
        (expected - 1..expected + STOPWATCH_CYCLES).contains(&cycles),
        "a loop of {expected} cycles is counted as {cycles}"
    );
    println!("core cycles a frame, by SysTick in rp2040js, which counts {cycles} for a loop of {expected}:");
    let differing = compare::<Needle>(&mut board, frames, output)?
        + compare::<Instruments>(&mut board, frames, output)?
        + compare::<TexturedTeapot>(&mut board, frames, output)?;
    drop(board);
    Ok(differing + compare_after_a_fault(&program)?)
}

/// Compares a frame after one whose transfer by DMA never ends: the firmware has to say that the one is lost, and to go on.
/// Returns how many pixels differ in the other.
fn compare_after_a_fault(program: &Path) -> Result<usize> {
    // The black panel takes a transfer for each of its rows, the first frame one for each of the picture's.
    let in_the_middle = st7789::HEIGHT as u32 + Needle::AREA.size.height / 2;
    let (mut board, _) = Board::start(program, FRAMES, Some(in_the_middle))?;
    let mut scene = Needle::default();
    simulate(&mut scene, 0)?;
    let line = board.next_line()?;
    let lost = format!("{} frame 0: lost, Sink(Timeout)", Needle::NAME);
    ensure!(line == lost, "instead of a lost frame the firmware said: {line}");
    let line = board.next_line()?;
    ensure!(
        Cycles::of_frame(Needle::NAME, 1, &line).is_some(),
        "after a lost frame the firmware said: {line}"
    );
    let (emulated, drawn) = (board.panel.pixels(Needle::AREA)?, simulate(&mut scene, 1)?);
    let differing = emulated.iter().zip(&drawn).filter(|(one, other)| one != other).count();
    println!("a transfer by DMA that never ends: its frame is lost, {differing} differing pixels in the next one");
    Ok(differing)
}

/// Compares the frames of a scene, and prints what they took on average.
fn compare<S: Scene<Color = Rgb565>>(board: &mut Board, frames: u32, output: &Path) -> Result<usize> {
    let (mut scene, mut differing, mut sum) = (S::default(), 0, Cycles::default());
    let mut emulating = Duration::ZERO;
    for frame in 0..frames {
        let begin = Instant::now();
        let line = board.next_line()?;
        emulating += begin.elapsed();
        let cycles = Cycles::of_frame(S::NAME, frame, &line)
            .with_context(|| format!("instead of frame {frame} of {} the firmware said: {line}", S::NAME))?;
        sum = sum.plus(cycles);
        let emulated = board.panel.pixels(S::AREA)?;
        let drawn = simulate(&mut scene, frame)?;
        for (side, pixels) in [("emulated", &emulated), ("simulator", &drawn)] {
            save::<S>(pixels, &output.join(format!("pico-{}-{frame:02}-{side}.png", S::NAME)))?;
        }
        differing += emulated.iter().zip(&drawn).filter(|(one, other)| one != other).count();
    }
    let Size { width, height } = S::AREA.size;
    println!(
        "{}: {differing} differing pixels of {} in {frames} frames ({:.1} s a frame)",
        S::NAME,
        frames * width * height,
        emulating.as_secs_f32() / frames as f32
    );
    let mean = |cycles: u64| cycles / u64::from(frames);
    println!(
        "{width} x {height}: {} to prepare, {} to draw, {} to send by DMA, {} waiting for the bus",
        mean(sum.preparing),
        mean(sum.drawing),
        mean(sum.sending),
        mean(sum.waiting)
    );
    Ok(differing)
}

/// The chip and what its panel shows.
struct Board {
    chip: Rp2040,
    panel: St7789,
}

impl Board {
    /// Starts the firmware; the second value is the first line that it says.
    fn start(program: &Path, frames: u32, stalled_transfer: Option<u32>) -> Result<(Self, String)> {
        let mut board = Self {
            chip: Rp2040::start(program, frames, stalled_transfer)?,
            panel: St7789::new(),
        };
        let line = board.next_line()?;
        Ok((board, line))
    }

    /// What the firmware says next; up to then the panel gets what is sent to it.
    fn next_line(&mut self) -> Result<String> {
        loop {
            match self.chip.next()? {
                Wire::Commands(bytes) => self.panel.take_commands(&bytes)?,
                Wire::Data(bytes) => self.panel.take_data(&bytes)?,
                Wire::Says(line) if line.starts_with("failed") || line.starts_with("stopped") => {
                    bail!("the firmware {line}")
                }
                Wire::Says(line) => return Ok(line),
            }
        }
    }
}

/// The desktop's side: the same scene code, one row after the other.
fn simulate<S: Scene<Color = Rgb565>>(scene: &mut S, frame: u32) -> Result<Vec<u16>> {
    let (mut row, mut pixels) = (vec![0; S::AREA.size.width as usize], Vec::new());
    let mut prepared = scene.prepare(frame)?;
    let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
        pixels.extend_from_slice(band.words());
        Ok(())
    };
    S::picture()
        .draw(&mut row, &mut sink, |band| prepared.draw(band))
        .context("the simulator's picture")?;
    Ok(pixels)
}

/// Writes a PNG of the pixels of a scene.
fn save<S: Scene>(pixels: &[u16], path: &Path) -> Result<()> {
    let Size { width, height } = S::AREA.size;
    let color = |x, y| {
        let color = Rgb565::from(RawU16::new(pixels[(y * width + x) as usize]));
        let scaled = |level: u8, largest: u8| (u16::from(level) * 255 / u16::from(largest)) as u8;
        Rgb([
            scaled(color.r(), Rgb565::MAX_R),
            scaled(color.g(), Rgb565::MAX_G),
            scaled(color.b(), Rgb565::MAX_B),
        ])
    };
    RgbImage::from_fn(width, height, color)
        .save(path)
        .with_context(|| format!("cannot write {}", path.display()))
}

/// Core cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Cycles {
    preparing: u64,
    drawing: u64,
    sending: u64,
    waiting: u64,
}

impl Cycles {
    /// Reads them from what the firmware says of a frame.
    fn of_frame(scene: &str, frame: u32, line: &str) -> Option<Self> {
        let mut rest = line.strip_prefix(&format!("{scene} frame {frame}: "))?;
        let mut next = |end: &str| {
            let (number, others) = rest.split_once(end)?;
            rest = others;
            number.parse().ok()
        };
        Some(Self {
            preparing: next(" cycles to prepare, ")?,
            drawing: next(" to draw, ")?,
            sending: next(" to send, ")?,
            waiting: next(" waiting")?,
        })
    }

    fn plus(self, other: Self) -> Self {
        Self {
            preparing: self.preparing + other.preparing,
            drawing: self.drawing + other.drawing,
            sending: self.sending + other.sending,
            waiting: self.waiting + other.waiting,
        }
    }
}

/// Reads the cycles of the loop of known length from what the firmware says first.
fn loop_cycles(line: &str) -> Option<u32> {
    let cycles = line.strip_prefix(&format!("loop of {LOOP_TURNS} turns: "))?;
    cycles.strip_suffix(" cycles")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_are_read_from_what_the_firmware_says() {
        let line = "gauge frame 2: 1 cycles to prepare, 20 to draw, 300 to send, 4000 waiting";
        let cycles = Cycles {
            preparing: 1,
            drawing: 20,
            sending: 300,
            waiting: 4_000,
        };
        assert_eq!(Cycles::of_frame("gauge", 2, line), Some(cycles));
        assert_eq!(Cycles::of_frame("gauge", 3, line), None);
        assert_eq!(Cycles::of_frame("teapot", 2, line), None);
        assert_eq!(Cycles::of_frame("gauge", 2, "gauge frame 2: 1 cycles to prepare"), None);
        assert_eq!(loop_cycles("loop of 10000 turns: 30010 cycles"), Some(30_010));
        assert_eq!(loop_cycles("loop of 1 turns: 3 cycles"), None);
    }
}
