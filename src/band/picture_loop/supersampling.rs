//! Supersampling: the picture is drawn `n` times as large, and filtered down as it passes.
//!
//! Guarantees: one colour per sample, whatever is drawn. Each channel of a pixel is the weighted mean of the samples in its
//! window, rounded once (ties up); the sums are integers and the weights add up to a power of two, so one colour stays
//! that colour, to the bit. Of `BinaryColor` an ordered threshold takes one or the other. Outside the picture's edges the
//! samples at the edge go on. Neither a frame nor rows of samples are kept: a row of samples is added to the rows of pixels
//! whose windows it is in, which are 1, 2 or 3.
//!
//! Cost: the scene once more for every band of samples, and about ten instructions for each sample in the window of each
//! pixel in each of `n` rows of samples: the filter along a row is applied once, that along the columns to its result. A
//! filter that is no such product is applied to a row of samples once for each row of pixels whose window it is in.
//!
//! Source: Crow 1977, 1981; for the filters [`SampleFilter`].

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::{geometry::Point, primitives::Rectangle};

use crate::{
    band::{Band, LoopError, PictureLoop, SceneResult, Sink},
    coverage::BoxFilter,
    geometry::{InputError, Sub8, SubPoint, TooSmall, Window},
    shade::{
        ChannelColor, SampleFilter, SampleSum, SampleWeights,
        samples::mean::{Levels, add_levels},
    },
    surface::{LittleEndian, Order, PixelWord},
};

/// A picture loop that draws `N` x `N` samples for each pixel of the display: 2, 4, 8 or 16.
///
/// The scene draws into a band of the picture enlarged `N` times, with what draws into any band: pixel (x, y) of the
/// display is the block of samples from `(N x, N y)` on. A position between pixels goes through
/// [`enlarged`](Self::enlarged). Beside the words of the band it takes [`sums_needed`](Self::sums_needed) numbers of 16
/// or 32 bits. For 240 pixels of 16 bits and bands of one row of samples:
///
/// | samples | words | box | Bartlett | cone | Gaussian |
/// |---|---:|---:|---:|---:|---:|
/// | 2 x 2 | 960 B | 1,440 B | 2,880 B | 5,760 B | 8,640 B |
/// | 4 x 4 | 1,920 B | 1,440 B | 5,760 B | 5,760 B | 8,640 B |
/// | 8 x 8 | 3,840 B | 1,440 B | 5,760 B | 5,760 B | 8,640 B |
/// | 16 x 16 | 7,680 B | 1,440 B | 5,760 B | 5,760 B | 8,640 B |
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
///     .draw(&mut samples, &mut sums, &mut DisplaySink(&mut display), |band| {
///         let Ok(()) = disc.draw_on(band);
///     })?;
/// assert_eq!(display.get_pixel(Point::new(8, 8)), Some(Gray8::WHITE));
/// assert_eq!(display.get_pixel(Point::new(8, 2)), Some(Gray8::new(29)));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Supersampling<C, const N: usize, F = BoxFilter, O = LittleEndian> {
    display: Window,
    enlarged: PictureLoop<C, O>,
    filter: PhantomData<F>,
}

/// Where samples may be, so that what is computed of their positions stays below 2^31.
const FURTHEST: i32 = 1 << 30;

impl<C: ChannelColor, const N: usize, F: SampleFilter<N>> Supersampling<C, N, F> {
    /// A loop over bands of one row of samples. Every band starts in the background colour.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] if the enlarged picture reaches beyond 2^30 samples.
    pub fn new(area: Rectangle, background: C) -> Result<Self, InputError> {
        const { assert!(Self::PIXELS > 0 && F::SUM_BITS <= 12) };
        let (min, max) = (-FURTHEST / N as i32, FURTHEST / N as i32);
        let display = Window::from(area);
        let times = |coordinate: i32| {
            let is_inside = (min..=max).contains(&coordinate);
            is_inside
                .then(|| coordinate * N as i32)
                .ok_or(InputError::OutOfDomain { min, max })
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
}

impl<C: ChannelColor, const N: usize, F: SampleFilter<N>, O: Order> Supersampling<C, N, F, O> {
    /// The loop with bands and pictures of another byte order.
    #[must_use]
    pub fn in_order<P: Order>(self) -> Supersampling<C, N, F, P> {
        Supersampling {
            display: self.display,
            enlarged: self.enlarged.in_order(),
            filter: PhantomData,
        }
    }

    /// Pixels along one side of a window.
    const PIXELS: usize = {
        assert!(N.is_power_of_two() && N >= 2 && N <= 16, "2, 4, 8 or 16 samples");
        assert!(F::PIXELS >= 1 && F::PIXELS <= 3, "whole pixels");
        let side = F::PIXELS * N;
        match F::WEIGHTS {
            SampleWeights::Product(weights) => assert!(weights.len() == side, "one for each column"),
            SampleWeights::EachSample(weights) => assert!(weights.len() == side * side / 2, "one for each sample"),
        }
        F::PIXELS
    };

    /// Sums that a pixel takes: one a channel, in each row of pixels under way.
    const SUMS: usize = Self::PIXELS * C::CHANNELS;

    /// The loop with bands of this many rows of samples, so that the scene is drawn less often; 0 counts as 1.
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

    /// Numbers that `sums` needs for a display of so many columns.
    pub const fn sums_needed(columns: usize) -> usize {
        columns.saturating_mul(Self::SUMS)
    }

    /// Where a position of the display is in the enlarged picture, to the bit. A pixel's centre becomes the middle of its
    /// samples, which is a corner between four of them.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] if that is too far out.
    pub fn enlarged(point: SubPoint<Sub8>) -> Result<SubPoint<Sub8>, InputError> {
        // What is outside the domain is so too when it is enlarged; of what is inside, nothing overflows.
        let inside = SubPoint::<Sub8>::from_units(point.x_units(), point.y_units())?;
        // 128 units are from a pixel's corner to its centre.
        let sample = |units: i32| (units + 128) * N as i32 - 128;
        SubPoint::from_units(sample(inside.x_units()), sample(inside.y_units()))
    }

    /// Draws the whole picture once.
    ///
    /// The sink takes each row of the display by itself. `samples` and `sums` are drawn over; what was in them does not
    /// matter.
    ///
    /// # Errors
    /// [`LoopError::TooSmall`] before anything is drawn, with what `samples` should have or, if those are enough, what
    /// `sums` should have; [`LoopError::Sink`] with the error of the sink, after which nothing more is sent.
    pub fn draw<S, D, R>(
        &self,
        samples: &mut [C::Word],
        sums: &mut [F::Sum],
        sink: &mut S,
        scene: D,
    ) -> Result<(), LoopError<S::Error, R::Error>>
    where
        S: Sink<C, O>,
        D: FnMut(&mut Band<'_, C, O>) -> R,
        R: SceneResult,
    {
        self.enlarged.check(samples)?;
        let needed = Self::sums_needed(self.display.width() as usize);
        let sums = sums.get_mut(..needed).ok_or(TooSmall::Sums(needed))?;
        sums.fill(F::Sum::default());
        let mut filtering = Filtering::<C, S, N, F> {
            display: self.display,
            sums,
            stride: needed / Self::PIXELS,
            sink,
            color: PhantomData,
        };
        self.enlarged.draw(samples, &mut filtering, scene)
    }
}

/// Takes bands of samples and hands over rows of pixels.
struct Filtering<'a, C, S, const N: usize, F: SampleFilter<N>> {
    display: Window,
    /// The sums of all rows of pixels under way: for each row, for each of its pixels, one for each channel.
    sums: &'a mut [F::Sum],
    /// Number of sums of a row of pixels.
    stride: usize,
    sink: &'a mut S,
    color: PhantomData<C>,
}

/// A row of pixels whose window has the current row of samples in it.
struct OpenRow {
    /// The row's number, from the top of the picture.
    row: i32,
    /// The index of the row's sums among those of all rows under way.
    slot: usize,
    /// The rows of the window that the row of samples stands for: one, and at an end of the picture those beyond it too.
    window_rows: Range<usize>,
    /// Whether the current row of samples is the last one in the window, so that the pixels' colours are known.
    is_finished: bool,
}

fn sum_of(weights: &[u16]) -> u32 {
    weights.iter().map(|&weight| u32::from(weight)).sum()
}

impl<C: ChannelColor, S, const N: usize, F: SampleFilter<N>> Filtering<'_, C, S, N, F> {
    const PIXELS: usize = Supersampling::<C, N, F>::PIXELS;
    /// Samples of a window before the first one of its pixel.
    const REACH: usize = (Self::PIXELS - 1) * N / 2;
    /// Samples along one side of a window.
    const SIDE: usize = Self::PIXELS * N;

    /// The rows whose window has a row of samples in it, counted from the top of the picture; top to bottom.
    fn open_rows(&self, sample_row: i32) -> impl Iterator<Item = OpenRow> + use<C, S, N, F> {
        // Up to 2^31 rows of samples, see `FURTHEST`: the number of the one after the last may wrap. (Without a sign they would
        // fit, for 1.2 % more instructions with four samples a pixel.)
        let height = self.display.height() as i32;
        let (is_first, is_last) = (
            sample_row == 0,
            sample_row.wrapping_add(1) == height.wrapping_mul(N as i32),
        );
        let from_top = sample_row.wrapping_add(Self::REACH as i32);
        let (lowest, row_in_pixel) = (from_top >> N.trailing_zeros(), from_top as usize & (N - 1));
        (0..Self::PIXELS).rev().filter_map(move |back| {
            let row = lowest - back as i32;
            let window_row = back * N + row_in_pixel;
            (0 <= row && row < height).then(|| OpenRow {
                row,
                slot: row as usize % Self::PIXELS,
                window_rows: Range {
                    start: if is_first { 0 } else { window_row },
                    end: if is_last { Self::SIDE } else { window_row + 1 },
                },
                is_finished: is_last || window_row + 1 == Self::SIDE,
            })
        })
    }

    /// Adds a row of samples to all rows of pixels that it counts for.
    fn add_row<O: Order>(&mut self, samples: &[C::Word], sample_row: i32) {
        match F::WEIGHTS {
            SampleWeights::Product(weights) => {
                let mut row_weights = [0; 3];
                for open in self.open_rows(sample_row) {
                    if let Some(weight) = row_weights.get_mut(open.slot) {
                        *weight = sum_of(weights.get(open.window_rows).unwrap_or_default());
                    }
                }
                self.add_weighted::<O>(samples, weights, 1 << F::SUM_BITS, row_weights);
            }
            SampleWeights::EachSample(upper) => {
                for open in self.open_rows(sample_row) {
                    let row_weights = [0, 1, 2].map(|slot| u32::from(slot == open.slot));
                    for row in open.window_rows {
                        let mirrored = row.min(Self::SIDE - row - 1);
                        let weights = upper.chunks_exact(Self::SIDE).nth(mirrored).unwrap_or_default();
                        self.add_weighted::<O>(samples, weights, sum_of(weights), row_weights);
                    }
                }
            }
        }
    }

    /// Adds a row of samples to rows of pixels: weighed along the row, with a sum of weights, and then for each row.
    #[inline(always)]
    fn add_weighted<O: Order>(&mut self, samples: &[C::Word], weights: &[u16], sum: u32, row_weights: [u32; 3]) {
        let mut walk = UniformBlocks::new(samples, Self::PIXELS, N);
        let mut column = 0usize;
        while column < self.display.width() as usize {
            let (levels, columns) = match walk.next_window::<N>(Self::PIXELS) {
                Some(word) => {
                    let columns = walk.skip_alike::<N>() + 1;
                    (filter_one::<C, O>(word, sum), columns)
                }
                None => {
                    // Before the row it wraps: 1 % fewer instructions than a checked difference.
                    let first = (column * N).wrapping_sub(Self::REACH);
                    // Where the window reaches beyond the row, there is no such slice.
                    let levels = match samples.get(first..).and_then(|rest| rest.get(..Self::SIDE)) {
                        Some(window) => filter::<C, O>(window, weights),
                        None => filter_at_end::<C, O>(samples, first as isize, weights),
                    };
                    (levels, 1)
                }
            };
            self.add_levels(column, columns, levels, row_weights);
            column += columns;
        }
    }

    /// Adds the same levels to the sums of some columns, as often as the weight of each row says.
    #[inline(always)]
    fn add_levels(&mut self, column: usize, columns: usize, levels: Levels, row_weights: [u32; 3]) {
        let start = column * C::CHANNELS;
        let end = start + columns * C::CHANNELS;
        for (row, weight) in self.sums.chunks_exact_mut(self.stride.max(1)).zip(row_weights) {
            // Weights that add up to more than their trait says give wrong colours, but no overflow.
            let more = levels.map(|level| level.wrapping_mul(weight));
            let sums = row.get_mut(start..end).unwrap_or_default();
            for pixel in sums.chunks_exact_mut(C::CHANNELS) {
                for (sum, more) in pixel.iter_mut().zip(more) {
                    *sum = sum.plus(more);
                }
            }
        }
    }

    /// Turns the sums of a row of pixels at height `y` into words, and resets the sums to 0.
    fn take_row<O: Order>(&mut self, slot: usize, y: i32, words: &mut [C::Word]) {
        let mut rows = self.sums.chunks_exact_mut(self.stride.max(1));
        let sums = rows.nth(slot).unwrap_or_default();
        let pixels = words.iter_mut().zip(sums.chunks_exact_mut(C::CHANNELS));
        for (x, (word, sums)) in (self.display.left..).zip(pixels) {
            let mut levels = [0; 3];
            for (level, sum) in levels.iter_mut().zip(sums) {
                *level = core::mem::take(sum).get();
            }
            *word = C::mean::<O>(levels, 2 * F::SUM_BITS, || Point::new(x, y));
        }
    }
}

/// Finds windows of one colour, as most are: comparing takes less than adding up.
///
/// A window of one, two or three pixels is as many blocks of `n` samples, and begins a block later than the one before it.
struct UniformBlocks<'s, W> {
    rest: &'s [W],
    /// The blocks up to the current one that hold nothing but one word, and that word.
    alike: usize,
    word: W,
}

impl<'s, W: PixelWord> UniformBlocks<'s, W> {
    /// A walk that stands before the first window. The samples beyond the beginning of the row are as the first one.
    #[inline(always)]
    fn new(samples: &'s [W], pixels: usize, n: usize) -> Self {
        let mut walk = Self {
            rest: samples,
            alike: usize::from(pixels == 3),
            word: samples.first().copied().unwrap_or(W::ZERO),
        };
        let reach = (pixels - 1) * n / 2;
        if let Some((block, rest)) = samples.split_at_checked(reach).filter(|_| reach > 0) {
            walk.rest = rest;
            walk.add(block);
        }
        walk
    }

    /// Goes on by a block; the word of the whole window if there is one.
    #[inline(always)]
    fn next_window<const N: usize>(&mut self, pixels: usize) -> Option<W> {
        match self.rest.split_first_chunk::<N>() {
            Some((block, rest)) => {
                self.rest = rest;
                self.add(block);
            }
            // The rest of the last block lies beyond the row, and is as the last sample.
            None => {
                let block = core::mem::take(&mut self.rest);
                self.add(block);
            }
        }
        (self.alike >= pixels).then_some(self.word)
    }

    /// How many windows of the same word follow right on; goes past them.
    #[inline(always)]
    fn skip_alike<const N: usize>(&mut self) -> usize {
        let mut windows = 0usize;
        while let Some((block, rest)) = self.rest.split_first_chunk::<N>() {
            if block.iter().any(|&word| word != self.word) {
                break;
            }
            self.rest = rest;
            windows += 1;
        }
        windows
    }

    #[inline(always)]
    fn add(&mut self, block: &[W]) {
        let first = block.first().copied().unwrap_or(self.word);
        if !block.iter().all(|&word| word == first) {
            self.alike = 0;
        } else if first == self.word {
            self.alike += 1;
        } else {
            (self.alike, self.word) = (1, first);
        }
    }
}

/// The weighted sum of the samples in a window where all are alike.
#[inline(always)]
fn filter_one<C: ChannelColor, O: Order>(word: C::Word, sum: u32) -> Levels {
    let mut levels = [0; 3];
    add_levels::<C::Layout, O>(&mut levels, word, sum);
    levels
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

/// The weighted sums of a filter window that begins before the row or ends after it: there the outermost sample of the row
/// stands for those that are missing.
#[inline(never)]
fn filter_at_end<C: ChannelColor, O: Order>(samples: &[C::Word], first: isize, weights: &[u16]) -> Levels {
    let mut levels = [0; 3];
    let last = samples.len().saturating_sub(1) as isize;
    for (column, &weight) in (first..).zip(weights) {
        let word = samples.get(column.clamp(0, last) as usize).copied();
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
        let Window {
            left,
            top,
            right,
            bottom,
        } = self.display;
        let [left, top, right, bottom] = [left, top, right, bottom].map(|side| side * N as i32);
        let samples = Window {
            left,
            top,
            right,
            bottom,
        };
        // A band that its scene has rotated need not be one of samples.
        if band.window.left != left || band.window.intersection(&samples) != band.window {
            return Ok(());
        }
        let first = band.window.top - top;
        // The samples come first: behind the last ones there may be no row.
        for (samples, sample_row) in band.words.chunks_exact_mut(band.stride.max(1)).zip(first..) {
            self.add_row::<O>(samples, sample_row);
            for open in self.open_rows(sample_row).filter(|open| open.is_finished) {
                let top = self.display.top + open.row;
                // The samples are used up, and there are more of them than pixels.
                self.take_row::<O>(open.slot, top, samples);
                let window = Window {
                    top,
                    bottom: top + 1,
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
impl<C, const N: usize, F, O> defmt::Format for Supersampling<C, N, F, O> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Supersampling {} by {} x {}", self.display, N, N);
    }
}
