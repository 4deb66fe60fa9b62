//! Supersampling: the picture is drawn `n` times as large, and filtered down as it passes.
//!
//! Promises: one colour per sample, whatever is drawn. Each channel of a pixel is the weighted mean of the samples in its
//! window, rounded once (ties up); the sums are integers and the weights add up to a power of two, so one colour stays
//! that colour, to the bit. Beyond the picture's edges the samples at the edge go on. Neither a frame nor rows of samples
//! are kept: a row of samples is added to the rows of pixels whose windows it is in, which are 1, 2 or 3.
//!
//! Cost: the scene once more for every band of samples, and about ten instructions for each sample in the window of each
//! pixel in each of `n` rows of samples: the filter along a row is applied once, that along the columns to its result.
//!
//! Source: Crow 1977, 1981; for the filters [`SampleFilter`].

use core::marker::PhantomData;

use embedded_graphics::primitives::Rectangle;

use crate::{
    band::{Band, BufferTooSmall, LoopError, PictureLoop, Sink},
    coverage::BoxFilter,
    geometry::{OutOfDomain, Sub8, SubPoint, Window},
    shade::{
        ChannelColor, SampleFilter, SampleSum,
        mean::{Levels, add_levels, mean_word},
    },
    target::{Order, PixelWord},
};

/// A picture loop that draws `N` x `N` samples for each pixel of the display: 2, 4, 8 or 16.
///
/// The scene draws into a band of the picture enlarged `N` times, with what draws into any band: pixel (x, y) of the
/// display is the block of samples from `(N x, N y)` on. A position between pixels goes through
/// [`enlarged`](Self::enlarged). Beside the words of the band it takes [`sums_needed`](Self::sums_needed) numbers of 16
/// or 32 bits. For 240 pixels of 16 bits and bands of one row of samples:
///
/// | samples | words | box | Bartlett | Gaussian |
/// |---|---:|---:|---:|---:|
/// | 2 x 2 | 960 B | 1,440 B | 2,880 B | 8,640 B |
/// | 4 x 4 | 1,920 B | 1,440 B | 5,760 B | 8,640 B |
/// | 8 x 8 | 3,840 B | 1,440 B | 5,760 B | 8,640 B |
/// | 16 x 16 | 7,680 B | 1,440 B | 5,760 B | 8,640 B |
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8, prelude::*, primitives::*};
/// use zrow::{
///     band::{Band, DisplaySink, Supersampling},
///     coverage::Bartlett,
///     draw::{DrawOn, PrimitiveStyle},
/// };
///
/// type Smooth = Supersampling<Gray8, 4, Bartlett>;
/// const WIDTH: usize = 16;
///
/// let mut display = MockDisplay::<Gray8>::new();
/// let area = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 16));
/// let mut samples = [0; 4 * WIDTH];
/// let mut sums = [0; Smooth::sums_needed(WIDTH)];
/// // A disc of 10 pixels.
/// let disc = Circle::new(Point::new(12, 12), 40).into_styled(PrimitiveStyle::with_fill(Gray8::WHITE));
/// Smooth::new(area, Gray8::BLACK)?
///     .draw(&mut samples, &mut sums, &mut DisplaySink(&mut display), |band: &mut Band<Gray8>| {
///         let Ok(()) = disc.draw_on(band);
///     })
///     .unwrap();
/// assert_eq!(display.get_pixel(Point::new(8, 8)), Some(Gray8::WHITE));
/// assert_eq!(display.get_pixel(Point::new(8, 2)), Some(Gray8::new(29)));
/// # Ok::<(), zrow::geometry::OutOfDomain>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Supersampling<C, const N: usize, F = BoxFilter> {
    display: Window,
    enlarged: PictureLoop<C>,
    filter: PhantomData<F>,
}

/// Where samples may be, so that what is computed of their places stays below 2^31.
const FURTHEST: i32 = 1 << 30;

impl<C: ChannelColor, const N: usize, F: SampleFilter<N>> Supersampling<C, N, F> {
    /// Pixels along one side of a window.
    const PIXELS: usize = {
        let weights = F::WEIGHTS;
        assert!(N.is_power_of_two() && N >= 2 && N <= 16, "2, 4, 8 or 16 samples");
        let pixels = weights.len() / N;
        assert!(
            pixels >= 1 && pixels <= 3 && weights.len() == pixels * N,
            "whole pixels"
        );
        pixels
    };

    /// Numbers of a pixel.
    const SUMS: usize = Self::PIXELS * C::CHANNELS;

    /// A loop over bands of one row of samples. Every band starts in the background colour.
    ///
    /// # Errors
    /// [`OutOfDomain`] if the enlarged picture reaches beyond 2^30 samples.
    pub fn new(area: Rectangle, background: C) -> Result<Self, OutOfDomain> {
        const { assert!(Self::PIXELS > 0 && F::SUM_BITS <= 12) };
        let domain = OutOfDomain {
            min: -FURTHEST / N as i32,
            max: FURTHEST / N as i32,
        };
        let display = Window::from(area);
        let times = |coordinate: i32| {
            let is_inside = (domain.min..=domain.max).contains(&coordinate);
            is_inside.then(|| coordinate.wrapping_mul(N as i32)).ok_or(domain)
        };
        let enlarged = Window {
            left: times(display.left)?,
            top: times(display.top)?,
            right: times(display.right)?,
            bottom: times(display.bottom)?,
        };
        Ok(Self {
            display,
            enlarged: PictureLoop::new(enlarged.to_rectangle(), background),
            filter: PhantomData,
        })
    }

    /// Bands of this many rows of samples, so that the scene is drawn less often; 0 counts as 1.
    #[must_use]
    pub fn rows(self, rows: u32) -> Self {
        Self {
            enlarged: self.enlarged.rows(rows),
            ..self
        }
    }

    /// Words that the samples of a band take.
    pub fn words_needed(&self) -> usize {
        self.enlarged.words_needed()
    }

    /// Numbers that the sums of a display of so many columns take.
    pub const fn sums_needed(columns: usize) -> usize {
        columns.saturating_mul(Self::SUMS)
    }

    /// Where a position of the display is in the enlarged picture, to the bit. A pixel's centre becomes the middle of its
    /// samples, which is a corner between four of them.
    ///
    /// # Errors
    /// [`OutOfDomain`] if that is too far out.
    pub fn enlarged(point: SubPoint<Sub8>) -> Result<SubPoint<Sub8>, OutOfDomain> {
        // Below 2^25 with any N; 128 units are from a pixel's corner to its centre.
        let place = |units: i32| units.wrapping_add(128).wrapping_mul(N as i32).wrapping_sub(128);
        SubPoint::from_units(place(point.x_units()), place(point.y_units()))
    }

    /// Draws the whole picture once.
    ///
    /// The sink takes each row of the display by itself. `samples` and `sums` are drawn over; what was in them does not
    /// matter.
    ///
    /// # Errors
    /// [`LoopError::BufferTooSmall`] before anything is drawn, with what `samples` should have or, if those are enough, what
    /// `sums` should have; [`LoopError::Sink`] with the error of the sink, after which nothing more is sent.
    pub fn draw<O, S, D>(
        &self,
        samples: &mut [C::Word],
        sums: &mut [F::Sum],
        sink: &mut S,
        scene: D,
    ) -> Result<(), LoopError<S::Error>>
    where
        O: Order,
        S: Sink<C, O>,
        D: FnMut(&mut Band<'_, C, O>),
    {
        self.enlarged.check(samples)?;
        let needed = Self::sums_needed(self.display.width() as usize);
        let sums = sums.get_mut(..needed).ok_or(BufferTooSmall { needed })?;
        sums.fill(F::Sum::default());
        let mut filtering = Filtering::<C, S, N, F> {
            display: self.display,
            sums,
            sink,
            color: PhantomData,
        };
        self.enlarged.draw(samples, &mut filtering, scene)
    }
}

/// Takes bands of samples and hands over rows of pixels.
struct Filtering<'a, C, S, const N: usize, F: SampleFilter<N>> {
    display: Window,
    /// For each pixel of a row of the display, for each row that is under way, in turn: one for each channel.
    sums: &'a mut [F::Sum],
    sink: &'a mut S,
    color: PhantomData<C>,
}

/// A row of pixels whose window has the current row of samples in it.
struct OpenRow {
    /// From the top of the picture.
    row: i32,
    /// Which of the sums are its own.
    slot: usize,
    /// How much the row of samples counts.
    weight: u32,
    is_finished: bool,
}

/// The weight of a row of samples at a place of a window. At an end of the picture, that of all that would lie beyond it
/// comes on top.
fn weight_at(weights: &[u16], place: usize, is_first: bool, is_last: bool) -> u32 {
    let start = if is_first { 0 } else { place };
    let end = if is_last { weights.len() } else { place.wrapping_add(1) };
    let weights = weights.get(start..end).unwrap_or_default();
    weights.iter().map(|&weight| u32::from(weight)).sum()
}

impl<C: ChannelColor, S, const N: usize, F: SampleFilter<N>> Filtering<'_, C, S, N, F> {
    const PIXELS: usize = Supersampling::<C, N, F>::PIXELS;
    const SUMS: usize = Supersampling::<C, N, F>::SUMS;
    /// Samples of a window before the first one of its pixel.
    const REACH: usize = (Self::PIXELS - 1) * N / 2;

    /// The rows whose window has a row of samples in it, counted from the top of the picture; top to bottom.
    fn open_rows(&self, sample_row: i32) -> impl Iterator<Item = OpenRow> + use<C, S, N, F> {
        // All of it within 2^31, see `FURTHEST`.
        let height = self.display.height() as i32;
        let (is_first, is_last) = (
            sample_row == 0,
            sample_row.wrapping_add(1) == height.wrapping_mul(N as i32),
        );
        let from_top = sample_row.wrapping_add(Self::REACH as i32);
        let (lowest, place) = (from_top >> N.trailing_zeros(), from_top as usize & (N - 1));
        (0..Self::PIXELS).rev().filter_map(move |back| {
            let row = lowest.wrapping_sub(back as i32);
            let place = back.wrapping_mul(N).wrapping_add(place);
            (0 <= row && row < height).then(|| OpenRow {
                row,
                slot: row as usize % Self::PIXELS,
                weight: weight_at(F::WEIGHTS, place, is_first, is_last),
                is_finished: is_last || place.wrapping_add(1) == F::WEIGHTS.len(),
            })
        })
    }

    /// Adds a row of samples to all rows of pixels that it counts for.
    fn add_row<O: Order>(&mut self, samples: &[C::Word], sample_row: i32) {
        let mut row_weights = [0; 3];
        for open in self.open_rows(sample_row) {
            if let Some(weight) = row_weights.get_mut(open.slot) {
                *weight = open.weight;
            }
        }
        let mut first = 0usize.wrapping_sub(Self::REACH);
        for pixel in self.sums.chunks_exact_mut(Self::SUMS) {
            // Where the window reaches beyond the row, there is no such slice.
            let window = samples.get(first..).and_then(|rest| rest.get(..F::WEIGHTS.len()));
            let levels = match window {
                Some(window) => filter::<C, O>(window, F::WEIGHTS),
                None => filter_at_end::<C, O>(samples, first as isize, F::WEIGHTS),
            };
            for (sums, weight) in pixel.chunks_exact_mut(C::CHANNELS).zip(row_weights) {
                for (sum, level) in sums.iter_mut().zip(levels) {
                    *sum = sum.plus(level.wrapping_mul(weight));
                }
            }
            first = first.wrapping_add(N);
        }
    }

    /// Makes words of the sums of a row, which are 0 afterwards.
    fn take_row<O: Order>(&mut self, slot: usize, words: &mut [C::Word]) {
        let rest = self.sums.get_mut(slot.wrapping_mul(C::CHANNELS)..).unwrap_or_default();
        for (word, sums) in words.iter_mut().zip(rest.chunks_mut(Self::SUMS)) {
            let mut levels = [0; 3];
            for (level, sum) in levels.iter_mut().zip(sums).take(C::CHANNELS) {
                *level = core::mem::take(sum).get();
            }
            *word = mean_word::<C::Layout, O>(levels, 2 * F::SUM_BITS);
        }
    }
}

/// The weighted sum of the samples in a window.
#[inline(always)]
fn filter<C: ChannelColor, O: Order>(window: &[C::Word], weights: &[u16]) -> Levels {
    let mut levels = [0; 3];
    for (&word, &weight) in window.iter().zip(weights) {
        add_levels::<C::Layout, O>(&mut levels, word, weight.into());
    }
    levels
}

/// The same for a window that begins before the row or ends after it: there the last sample goes on.
#[inline(never)]
fn filter_at_end<C: ChannelColor, O: Order>(samples: &[C::Word], first: isize, weights: &[u16]) -> Levels {
    let mut levels = [0; 3];
    let last = samples.len().saturating_sub(1) as isize;
    for (place, &weight) in (first..).zip(weights) {
        let word = samples.get(place.clamp(0, last) as usize).copied();
        add_levels::<C::Layout, O>(&mut levels, word.unwrap_or(<C::Word as PixelWord>::ZERO), weight.into());
    }
    levels
}

impl<C, O, S, const N: usize, F> Sink<C, O> for Filtering<'_, C, S, N, F>
where
    C: ChannelColor,
    O: Order,
    S: Sink<C, O>,
    F: SampleFilter<N>,
{
    type Error = S::Error;

    fn send(&mut self, band: Band<'_, C, O>) -> Result<(), S::Error> {
        let first = band.window.top.wrapping_sub(self.display.top.wrapping_mul(N as i32));
        for (sample_row, samples) in (first..).zip(band.words.chunks_exact_mut(band.stride.max(1))) {
            self.add_row::<O>(samples, sample_row);
            for open in self.open_rows(sample_row).filter(|open| open.is_finished) {
                // The samples are used up, and there are more of them than pixels.
                self.take_row::<O>(open.slot, samples);
                let top = self.display.top.wrapping_add(open.row);
                let window = Window {
                    top,
                    bottom: top.wrapping_add(1),
                    ..self.display
                };
                if let Ok(row) = Band::over(window, samples) {
                    self.sink.send(row)?;
                }
            }
        }
        Ok(())
    }
}

#[cfg(feature = "defmt")]
impl<C, const N: usize, F> defmt::Format for Supersampling<C, N, F> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Supersampling {} by {} x {}", self.display, N, N);
    }
}
