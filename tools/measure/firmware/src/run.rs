//! One count: many operations on one target, between two readings of the stopwatch.

use core::hint::black_box;

use crate::{report, stopwatch::Stopwatch};

/// Something that keeps the drawn pixels.
pub trait Canvas {
    /// Makes every pixel 0.
    fn erase(&mut self);
    /// A number that depends on every pixel.
    fn checksum(&mut self) -> u32;
}

/// FNV-1a (Fowler, Noll, Vo, 1991) over pixels in row-major order.
pub struct Checksum(pub u32);

impl Default for Checksum {
    fn default() -> Self {
        Self(0x811C_9DC5)
    }
}

impl Checksum {
    /// Adds pixels.
    pub fn add(&mut self, pixels: impl Iterator<Item = u16>) {
        self.0 = pixels.fold(self.0, |sum, pixel| (sum ^ u32::from(pixel)).wrapping_mul(0x0100_0193));
    }

    /// The checksum of these pixels alone.
    pub fn of(pixels: impl Iterator<Item = u16>) -> u32 {
        let mut sum = Self::default();
        sum.add(pixels);
        sum.0
    }
}

/// Times the counts the host asked for, and reports them.
pub struct Runner<'a> {
    stopwatch: Stopwatch,
    wanted: &'a str,
}

impl<'a> Runner<'a> {
    /// Calibrates the stopwatch; `wanted` names the counts to run, blank-separated, or none for all.
    pub fn new(mut stopwatch: Stopwatch, wanted: &'a str) -> Self {
        stopwatch.calibrate();
        Self { stopwatch, wanted }
    }

    /// Whether the host asked for `name`.
    pub fn wants(&self, name: &str) -> bool {
        self.wanted.is_empty() || self.wanted.split(' ').any(|wanted| wanted == name)
    }

    /// Performs `operation` once for every input, on a canvas that was erased.
    ///
    /// The canvas passes through `black_box` around every operation, so that none is merged with another or dropped.
    #[inline(never)]
    pub fn count<C: Canvas, Input>(
        &mut self,
        name: &str,
        variant: &str,
        canvas: &mut C,
        inputs: &[Input],
        mut operation: impl FnMut(&mut C, &Input),
    ) {
        canvas.erase();
        let inputs = black_box(inputs);
        let ticks = self.stopwatch.time(|| {
            for input in inputs {
                operation(black_box(&mut *canvas), input);
                black_box(&mut *canvas);
            }
        });
        let line = report::line("count").text("name", name).text("variant", variant);
        let line = line
            .number("operations", inputs.len() as u32)
            .number("checksum", canvas.checksum());
        match ticks {
            Some(ticks) => line.number("ticks", ticks).end(),
            None => line.text("ticks", "wrapped").end(),
        }
    }
}
