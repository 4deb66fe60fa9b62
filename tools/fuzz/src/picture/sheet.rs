//! A display in plain memory that counts what it is asked for, and notes what it should not have been asked for.

use std::cell::Cell;

use anyhow::ensure;
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::PixelColor,
    primitives::{PointsIter, Rectangle},
};
use zrow::geometry::Window;

use crate::target::Verdict;

/// Why a [`Sheet`] takes no more pixels.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub enum Stopped {
    /// It was told to fail at this call.
    AsTold,
    /// It was asked for more than the bound of its work.
    TooMuchWork,
}

/// A display of a few pixels.
#[derive(Debug, Clone)]
pub struct Sheet<C> {
    window: Window,
    pixels: Vec<C>,
    /// How often each pixel was written.
    writes: Vec<u32>,
    /// Calls so far.
    pub calls: u64,
    /// Pixels that came so far, those outside the display too.
    pub taken: u64,
    most_calls: u64,
    most_pixels: u64,
    fails_at: Option<u64>,
    failed: bool,
    outside: Option<Point>,
    called_after_failure: bool,
}

impl<C: PixelColor> Sheet<C> {
    /// The display over a window, in one colour, that takes any number of calls.
    pub fn new(window: Window, color: C) -> Self {
        let pixels = window.width() as usize * window.height() as usize;
        Self {
            window,
            pixels: vec![color; pixels],
            writes: vec![0; pixels],
            calls: 0,
            taken: 0,
            most_calls: u64::MAX,
            most_pixels: u64::MAX,
            fails_at: None,
            failed: false,
            outside: None,
            called_after_failure: false,
        }
    }

    /// The display that fails where it is asked for more.
    pub const fn with_most(mut self, calls: u64, pixels: u64) -> Self {
        self.most_calls = calls;
        self.most_pixels = pixels;
        self
    }

    /// The display that fails at that call; the first one has number 0.
    pub const fn failing_at(mut self, call: u64) -> Self {
        self.fails_at = Some(call);
        self
    }

    /// Works from now on, and counts anew.
    pub fn mend(&mut self) {
        self.calls = 0;
        self.taken = 0;
        self.fails_at = None;
        self.failed = false;
        self.writes.fill(0);
    }

    /// The colours, row by row.
    pub fn pixels(&self) -> &[C] {
        &self.pixels
    }

    /// Gives a pixel a colour, without a call that counts.
    pub fn put(&mut self, point: Point, color: C) {
        if let Some(index) = self.index(point) {
            self.pixels[index] = color;
        }
    }

    /// The colour of a pixel of the display.
    pub fn pixel(&self, point: Point) -> Option<C> {
        self.index(point).map(|index| self.pixels[index])
    }

    /// How often the pixels were written that were written most often.
    pub fn most_writes(&self) -> u32 {
        self.writes.iter().copied().max().unwrap_or(0)
    }

    /// Nothing came for a pixel outside the display, and nothing after it failed.
    ///
    /// # Errors
    /// Something did.
    pub fn was_treated_well(&self) -> Verdict {
        ensure!(
            self.outside.is_none(),
            "{:?} is outside of the display {:?}",
            self.outside,
            self.window
        );
        ensure!(!self.called_after_failure, "the display is called after its error");
        Ok(())
    }

    fn index(&self, point: Point) -> Option<usize> {
        let is_inside = self.window.contains(point);
        let (column, row) = (point.x.abs_diff(self.window.left), point.y.abs_diff(self.window.top));
        is_inside.then_some(row as usize * self.window.width() as usize + column as usize)
    }

    fn call(&mut self) -> Result<(), Stopped> {
        self.called_after_failure |= self.failed;
        let call = self.calls;
        self.calls += 1;
        if Some(call) == self.fails_at {
            self.failed = true;
            return Err(Stopped::AsTold);
        }
        self.is_within(self.calls <= self.most_calls)
    }

    fn is_within(&mut self, within: bool) -> Result<(), Stopped> {
        if within {
            Ok(())
        } else {
            self.failed = true;
            Err(Stopped::TooMuchWork)
        }
    }

    fn set(&mut self, Pixel(point, color): Pixel<C>) -> Result<(), Stopped> {
        self.taken += 1;
        self.is_within(self.taken <= self.most_pixels)?;
        match self.index(point) {
            Some(index) => {
                self.pixels[index] = color;
                self.writes[index] += 1;
            }
            None => self.outside = Some(point),
        }
        Ok(())
    }

    /// Whether an area without pixels came, or one outside the display: notes it.
    fn is_bad(&mut self, area: &Rectangle) -> bool {
        let window = Window::from(*area);
        let is_inside =
            window.is_empty() || window.intersection(&self.window) == window && window.to_rectangle() == *area;
        if !is_inside {
            self.outside = Some(area.top_left);
        }
        !is_inside
    }
}

impl<C: PixelColor> Dimensions for Sheet<C> {
    fn bounding_box(&self) -> Rectangle {
        self.window.to_rectangle()
    }
}

impl<C: PixelColor> DrawTarget for Sheet<C> {
    type Color = C;
    type Error = Stopped;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Stopped>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        self.call()?;
        pixels.into_iter().try_for_each(|pixel| self.set(pixel))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Stopped>
    where
        I: IntoIterator<Item = C>,
    {
        self.call()?;
        if self.is_bad(area) {
            return Ok(());
        }
        let mut pixels = area.points().zip(colors);
        pixels.try_for_each(|(point, color)| self.set(Pixel(point, color)))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Stopped> {
        self.call()?;
        if self.is_bad(area) {
            return Ok(());
        }
        area.points().try_for_each(|point| self.set(Pixel(point, color)))
    }
}

/// An iterator that counts how often it is asked, whether for the next item or for a later one, and ends where it was asked
/// too often.
#[derive(Debug)]
pub struct Counted<'c, I> {
    items: I,
    asked: &'c Cell<u64>,
    most: u64,
}

impl<'c, I> Counted<'c, I> {
    /// Counts in `asked`; ends after `most` questions.
    pub const fn new(items: I, asked: &'c Cell<u64>, most: u64) -> Self {
        Self { items, asked, most }
    }

    fn is_patient(&self) -> bool {
        self.asked.set(self.asked.get() + 1);
        self.asked.get() <= self.most
    }
}

impl<I: Iterator> Iterator for Counted<'_, I> {
    type Item = I::Item;

    fn next(&mut self) -> Option<I::Item> {
        if self.is_patient() { self.items.next() } else { None }
    }

    fn nth(&mut self, index: usize) -> Option<I::Item> {
        if self.is_patient() { self.items.nth(index) } else { None }
    }
}
