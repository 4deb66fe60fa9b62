//! The depth row: one row of pixels, one row of depths, and the loop that tests one against the other.

use core::num::Wrapping;

use crate::{
    band::Band,
    geometry::Window,
    shade::{Flat, Shade, Shading},
    surface::{BandColor, Order, PixelWord, not_constant},
    view::{DepthWidth, ScreenPrecision},
    visible::{active_face::ActiveFace, depth_plane::DepthPlane},
};

/// A row of a band and the depths of its pixels, while it is drawn.
///
/// Source: the scan-line z-buffer (Myers 1975; Foley, van Dam, Feiner, Hughes 1990, section 15.6).
#[derive(Debug)]
pub struct DepthRow<'a, C: BandColor, O: Order, D: DepthWidth> {
    pub(super) y: i32,
    /// Column of the first pixel.
    pub(super) left: i32,
    pub(super) words: &'a mut [C::Word],
    pub(super) depths: &'a mut [D],
    /// Whether spans are tested against the depths; not where no span of the row overlaps another and nothing reads the depths.
    pub(super) is_tested: bool,
    order: core::marker::PhantomData<O>,
}

impl<'a, C: BandColor, O: Order, D: DepthWidth> DepthRow<'a, C, O, D> {
    /// Row `y` of a band, from column `window.left` to `window.right`, which the band has; the depths are not cleared yet.
    /// `None` where the band has no such row.
    pub(crate) fn new<'b: 'a>(
        band: &'a mut Band<'b, C, O>,
        window: &Window,
        y: i32,
        depths: &'a mut [D],
    ) -> Option<Self> {
        use crate::surface::Target;
        let band_left = band.window().left;
        let start = usize::try_from(window.left - band_left).ok()?;
        // A window without columns has a huge number of them here, which no band has.
        let width = (window.right - window.left) as usize;
        let words = band.row_mut(y)?.get_mut(start..)?.get_mut(..width)?;
        let depths = depths.get_mut(..width)?;
        Some(Self {
            y,
            left: window.left,
            words,
            depths,
            is_tested: true,
            order: core::marker::PhantomData,
        })
    }

    /// The part of the row that is in a window; `None` where it has no pixels there.
    pub(super) fn within(&mut self, window: &Window) -> Option<DepthRow<'_, C, O, D>> {
        let (left, right) = (
            self.left.max(window.left),
            (self.left + self.words.len() as i32).min(window.right),
        );
        if left >= right || self.y < window.top || self.y >= window.bottom {
            return None;
        }
        let columns = (left - self.left) as usize..(right - self.left) as usize;
        Some(DepthRow {
            y: self.y,
            left,
            words: self.words.get_mut(columns.clone())?,
            depths: self.depths.get_mut(columns)?,
            is_tested: self.is_tested,
            order: core::marker::PhantomData,
        })
    }

    /// Resets all depths of the row to the farthest one.
    pub(crate) fn clear_depths(&mut self) {
        PixelWord::fill(self.depths, not_constant(D::FARTHEST));
    }

    /// Gives the pixels of the row the colours of one sample of each: of the sample `index` of `per_pixel` that each has.
    pub(crate) fn load_samples(&mut self, samples: &[C::Word], [index, per_pixel]: [usize; 2]) {
        let samples = samples
            .get(index..)
            .unwrap_or_default()
            .iter()
            .step_by(per_pixel.max(1));
        for (word, sample) in self.words.iter_mut().zip(samples) {
            *word = *sample;
        }
    }

    /// Gives one sample of each pixel its colour, where something has been drawn in it: the sample `index` of `per_pixel`. The
    /// samples are those of all pixels of the row.
    pub(crate) fn store_samples(&self, columns: [i32; 2], samples: &mut [C::Word], [index, per_pixel]: [usize; 2]) {
        let [start, end] = columns.map(|column| column.max(0) as usize);
        let first = start * per_pixel + index;
        let samples = samples
            .get_mut(first..)
            .unwrap_or_default()
            .iter_mut()
            .step_by(per_pixel.max(1));
        let (Some(words), Some(depths)) = (self.words.get(start..end), self.depths.get(start..end)) else {
            return;
        };
        for ((sample, word), depth) in samples.zip(words).zip(depths) {
            if *depth > D::FARTHEST {
                *sample = *word;
            }
        }
    }

    /// The column and the row of the first pixel.
    #[inline]
    pub(crate) fn start(&self) -> [i32; 2] {
        [self.left, self.y]
    }

    /// The pixels of the row.
    #[inline]
    pub(crate) fn words(&self) -> &[C::Word] {
        self.words
    }

    /// The depths of the row's pixels as they are stored, from left to right: nearer is larger, and 0 is where nothing is.
    pub const fn depths(&self) -> &[D] {
        self.depths
    }

    /// The number of the row in the picture.
    pub const fn y(&self) -> i32 {
        self.y
    }

    /// Draws the pixels of a span that are nearer than the stored depths, up to the first that is exactly as near.
    /// Returns how many visible pixels of the span are left, that one included; `None` if there is no such pixel.
    /// Columns count from the first pixel of the row, and may lie outside it.
    #[inline]
    pub(super) fn draw_span<S: ScreenPrecision, H: Shading<Color = C>>(
        &mut self,
        face: &ActiveFace<S, H>,
        [start, end]: [i32; 2],
    ) -> Option<usize> {
        // One comparison tells that the span has pixels and begins inside the row: a column left of it is a huge number here.
        let (column, last) = (start as usize, end as usize);
        if column >= last {
            return if start < end {
                self.draw_cut_span(face, [start, end])
            } else {
                None
            };
        }
        if let (Some(words), Some(depths)) = (self.words.get_mut(..last), self.depths.get_mut(..last)) {
            let depth = face.plane.at(start, self.y);
            let shade = Flat(O::reorder(face.word));
            test_and_store(words, depths, column, shade, depth, face.plane.per_column)
        } else {
            self.draw_cut_span(face, [start, end])
        }
    }

    /// Draws pixels inside the row that are nearer than the stored depths, up to the first that is exactly as near. Returns how
    /// many are left, that one included; `None` if there is no such pixel.
    #[inline(always)]
    pub(super) fn draw_run(
        &mut self,
        start: i32,
        end: i32,
        shade: impl Shade<C::Word>,
        plane: &DepthPlane,
    ) -> Option<usize> {
        let last = end as usize;
        let (words, depths) = (self.words.get_mut(..last)?, self.depths.get_mut(..last)?);
        let depth = plane.at(start, self.y);
        test_and_store(words, depths, start as usize, shade, depth, plane.per_column)
    }

    /// The pixels from a column to another one; `None` where one of them is outside the row.
    #[inline(always)]
    pub(super) fn pixels(&mut self, start: i32, end: i32) -> Option<&mut [C::Word]> {
        self.words.get_mut(start as usize..end as usize)
    }

    /// Stores the depths of pixels inside the row from a column on, as long as they are nearer than the stored ones. Returns
    /// how many pixels are left.
    #[inline(always)]
    pub(super) fn store_nearer(&mut self, start: i32, end: i32, plane: &DepthPlane) -> Option<usize> {
        let depths = self.depths.get_mut(start as usize..end as usize)?;
        Some(store_nearer(depths, plane.at(start, self.y), plane.per_column))
    }

    /// The first column from one on, and before another one, whose depth is not farther than the stored one; else the latter.
    #[inline(always)]
    pub(super) fn skip_farther(&self, mut start: i32, end: i32, plane: &DepthPlane) -> i32 {
        let depths = self.depths.get(start as usize..end as usize).unwrap_or_default();
        let mut depth = plane.at(start, self.y);
        for stored in depths {
            if D::from_interpolated(depth.0) >= *stored {
                return start;
            }
            depth += plane.per_column;
            start += 1;
            core::hint::black_box(());
        }
        end
    }

    /// Draws a pixel if it is nearer than the stored depth, or exactly as near and `first` returns `true`.
    pub(super) fn draw_pixel(&mut self, column: i32, word: C::Word, depth: D, first: impl FnOnce() -> bool) {
        let index = column as usize;
        if let (Some(pixel), Some(stored)) = (self.words.get_mut(index), self.depths.get_mut(index)) {
            if depth > *stored || (depth == *stored && first()) {
                *stored = depth;
                *pixel = O::reorder(word);
            }
        }
    }

    /// Draws a span that has pixels and that no other overlaps: without depths.
    #[inline]
    pub(super) fn fill_span(&mut self, start: i32, end: i32, word: C::Word) {
        let word = O::reorder(word);
        let range = start as usize..end as usize;
        match self.words.get_mut(range) {
            Some(words) if words.len() < SHORT => fill_short(words, word),
            Some(words) => PixelWord::fill(words, word),
            None => self.fill_cut_span(start, end, word),
        }
    }

    /// Fills the part of a span that is inside the row. The word is in the band's byte order.
    #[cold]
    #[inline(never)]
    pub(super) fn fill_cut_span(&mut self, start: i32, end: i32, word: C::Word) {
        let column = |x: i32| x.max(0) as usize;
        let (first, last) = (column(start), column(end).min(self.words.len()));
        if let Some(words) = self.words.get_mut(first..last) {
            PixelWord::fill(words, word);
        }
    }

    /// Draws the part of a span that is inside the row.
    #[cold]
    #[inline(never)]
    fn draw_cut_span<S: ScreenPrecision, H: Shading<Color = C>>(
        &mut self,
        face: &ActiveFace<S, H>,
        [start, end]: [i32; 2],
    ) -> Option<usize> {
        let start = start.max(0);
        let end = end.min(self.words.len() as i32);
        if start < end {
            self.draw_span(face, [start, end])
        } else {
            None
        }
    }
}

/// Spans of fewer pixels are filled in a loop over single pixels.
const SHORT: usize = 12;

#[inline]
fn fill_short<W: PixelWord>(words: &mut [W], word: W) {
    for pixel in words {
        *pixel = word;
        // Keeps the compiler from unrolling, and from a call.
        core::hint::black_box(());
    }
}

/// The inner loop, from a column of a row to the end of its slices: one addition, one comparison and two stores a pixel. Stops
/// at a pixel that is as near as the stored depth, and returns how many pixels are left, that one included.
// By column, so that a span needs no pointers to its own first word and depth: an Arm adds an index to a pointer as it loads.
#[inline(always)]
fn test_and_store<W: PixelWord, D: DepthWidth>(
    words: &mut [W],
    depths: &mut [D],
    mut column: usize,
    mut shade: impl Shade<W>,
    mut depth: Wrapping<u32>,
    per_column: Wrapping<u32>,
) -> Option<usize> {
    while let (Some(pixel), Some(stored)) = (words.get_mut(column), depths.get_mut(column)) {
        let candidate = D::from_interpolated(depth.0);
        if candidate > *stored {
            if let Some(word) = shade.word() {
                *stored = candidate;
                *pixel = word;
            }
        } else if candidate == *stored {
            return Some(words.len() - column);
        }
        shade.step_right();
        depth += per_column;
        column += 1;
        // Keeps the compiler from unrolling: most spans are shorter than what it would prepare for.
        core::hint::black_box(());
    }
    None
}

/// Stores depths as long as they are nearer than the stored ones. Returns how many are left.
#[inline(always)]
fn store_nearer<D: DepthWidth>(depths: &mut [D], mut depth: Wrapping<u32>, per_column: Wrapping<u32>) -> usize {
    let mut others = depths.iter_mut();
    while let Some(stored) = others.next() {
        let candidate = D::from_interpolated(depth.0);
        if candidate <= *stored {
            return others.len() + 1;
        }
        *stored = candidate;
        depth += per_column;
        // Keeps the compiler from unrolling: most spans are shorter than what it would prepare for.
        core::hint::black_box(());
    }
    0
}

/// [`store_nearer`] of so many pixels that the compiler may unroll it.
#[inline(always)]
pub(super) fn store_nearer_block<D: DepthWidth, const N: usize>(
    depths: &mut [D; N],
    depth: Wrapping<u32>,
    per_column: Wrapping<u32>,
) -> usize {
    // Keeps the compiler from carrying the depth of each pixel of a block on to the next block.
    let mut depth = core::hint::black_box(depth);
    for (index, stored) in depths.iter_mut().enumerate() {
        let candidate = D::from_interpolated(depth.0);
        if candidate <= *stored {
            return N - index;
        }
        *stored = candidate;
        depth += per_column;
    }
    0
}

#[cfg(feature = "defmt")]
impl<C: BandColor, O: Order, D: DepthWidth> defmt::Format for DepthRow<'_, C, O, D> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "DepthRow {} from column {}", self.y, self.left);
    }
}
