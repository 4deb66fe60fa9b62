//! Bands, the targets that zrow draws into: a band is a few rows of a picture, in memory as one word for each pixel.
//!
//! A [`Band`] is a [`Target`] and an embedded-graphics `DrawTarget`, as any other display is in a [`Generic`]; the [`PictureLoop`] walks it
//! down the picture, and a [`Sink`] takes each band towards the display.

mod blending;
mod dithering;
mod fill;
mod in_picture;
mod multisampling;
mod pack;
mod picture_loop;
mod row_blender;
mod rows;

pub use crate::surface::{BandColor, Generic, Order, Span, Target};
#[doc(no_inline)]
pub use crate::surface::{BigEndian, LittleEndian};
pub(crate) use blending::InLinearLight;
pub(crate) use multisampling::Multisampled;
pub(crate) use picture_loop::SceneResult;
pub use picture_loop::{
    BytesSink, DisplaySink, Dithered, LoopError, OverlappingSink, Page, PagesSink, PanelRotation, PictureLoop, Sink,
    Supersampling,
};

use core::marker::PhantomData;

use embedded_graphics::{
    Drawable,
    geometry::{Dimensions, Point},
    image::GetPixel,
    primitives::Rectangle,
};

use crate::{
    geometry::{TooSmall, Window, distance, offset_from},
    surface::{PixelWord, not_constant},
};

/// Words for the pixels of a rectangle of the picture, row by row, without gaps.
///
/// Coordinates are those of the picture: the band's bounding box is the rectangle it stands for, and what lies outside
/// is not drawn. RAM: the words, and 32 bytes for the band itself on a 32-bit machine.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::band::Band;
///
/// let mut row = [0u16; 240];
/// let area = Rectangle::new(Point::new(0, 100), Size::new(240, 1));
/// let mut band = Band::<Rgb565>::new(area, &mut row)?;
/// let Ok(()) = Pixel(Point::new(7, 100), Rgb565::RED).draw(&mut band);
/// assert_eq!(row[7], Rgb565::RED.into_storage());
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
#[derive(Debug)]
pub struct Band<'a, C: BandColor, O: Order = LittleEndian> {
    window: Window,
    stride: usize,
    words: &'a mut [C::Word],
    order: PhantomData<O>,
}

impl<'a, C: BandColor, O: Order> Band<'a, C, O> {
    /// A band over the first `width * height` words of a buffer. The words stay as they are.
    ///
    /// # Errors
    /// [`TooSmall`] with the number of words needed.
    pub fn new(area: Rectangle, words: &'a mut [C::Word]) -> Result<Self, TooSmall> {
        Self::over(area.into(), words).map_err(too_few_words)
    }

    /// The band of a window over its words, or the number of words that it needs.
    fn over(window: Window, words: &'a mut [C::Word]) -> Result<Self, usize> {
        let needed = words_needed(&window);
        match words.get_mut(..needed) {
            Some(words) => Ok(Self {
                window,
                stride: window.width() as usize,
                words,
                order: PhantomData,
            }),
            None => Err(needed),
        }
    }

    /// Draws what meets this band and skips what does not.
    ///
    /// `None` where it was skipped. Costs the drawable's bounding box for what is skipped, which is what makes
    /// replaying a scene for every band affordable. It is meant for embedded-graphics' texts and images: zrow's own shapes
    /// find out in [`DrawOn::draw_on`](crate::draw::DrawOn::draw_on) that they are not met, mostly at less cost.
    pub fn draw<D>(&mut self, drawable: &D) -> Option<D::Output>
    where
        D: Drawable<Color = C> + Dimensions,
    {
        if !self.window.meets(&drawable.bounding_box().into()) {
            return None;
        }
        let Ok(output) = drawable.draw(self);
        Some(output)
    }

    /// The words of a row of the picture; `None` where the band does not hold that row.
    pub fn row_mut(&mut self, y: i32) -> Option<&mut [C::Word]> {
        if y < self.window.top || y >= self.window.bottom {
            return None;
        }
        // Below the height, so the product is at most the number of words.
        let start = distance(self.window.top, y) as usize * self.stride;
        self.words.get_mut(start..start + self.stride)
    }

    /// A row of this band as a band of its own; `None` where the band does not hold that row.
    #[inline(always)]
    pub(crate) fn one_row(&mut self, y: i32) -> Option<Band<'_, C, O>> {
        let window = Window {
            top: y,
            bottom: y + 1,
            ..self.window
        };
        let stride = self.stride;
        Some(Band {
            words: self.row_mut(y)?,
            window,
            stride,
            order: PhantomData,
        })
    }

    /// A band of the words of this one whose window is moved by some pixels. Where that is out of the number range, the band
    /// has no words.
    pub(crate) fn translated(&mut self, by: Point) -> Band<'_, C, O> {
        let window = self.window.translated(by);
        Band {
            words: if window.is_some() { self.words } else { &mut [] },
            window: window.unwrap_or(Window::EMPTY),
            stride: self.stride,
            order: PhantomData,
        }
    }

    /// Some columns of a band of one row as a band of its own; without columns where the band does not have them.
    pub(crate) fn cropped_row(&mut self, columns: core::ops::Range<i32>) -> Band<'_, C, O> {
        let Window { left, top, bottom, .. } = self.window;
        let words = usize::try_from(columns.start - left).ok().and_then(|start| {
            let width = usize::try_from(columns.end - columns.start).ok()?;
            self.words.get_mut(start..)?.get_mut(..width)
        });
        let words = words.unwrap_or_default();
        let stride = words.len();
        Band {
            window: Window {
                left: columns.start,
                top,
                // A part of the row.
                right: columns.start + stride as i32,
                bottom,
            },
            words,
            stride,
            order: PhantomData,
        }
    }

    /// All words, row by row, in this band's byte order.
    pub fn words(&self) -> &[C::Word] {
        self.words
    }

    /// All words, row by row, in this band's byte order, to be written.
    pub fn words_mut(&mut self) -> &mut [C::Word] {
        self.words
    }

    /// The word of a colour, in this band's byte order.
    pub fn word(color: C) -> C::Word {
        O::reorder(color.to_word())
    }

    /// The colours of all pixels, row by row.
    pub fn colors(&self) -> impl Iterator<Item = C> + '_ {
        self.words.iter().map(|&word| C::from_word(O::reorder(word)))
    }

    /// Fills the band with one colour.
    pub fn fill(&mut self, color: C) {
        PixelWord::fill(self.words, not_constant(Self::word(color)));
    }

    /// The index of a pixel among the words; `None` outside the window.
    fn index(&self, point: Point) -> Option<usize> {
        let Window { left, top, .. } = self.window;
        // As unsigned numbers, columns left of the window and rows above it are beyond its right and lower sides.
        let (column, row) = (offset_from(left, point.x), offset_from(top, point.y));
        let (width, height) = (distance(left, self.window.right), distance(top, self.window.bottom));
        let is_inside = column < width && row < height;
        is_inside.then(|| self.index_unchecked(point.x, point.y))
    }

    /// The index of a pixel that is inside the window; some number for any other.
    fn index_unchecked(&self, x: i32, y: i32) -> usize {
        // Of a pixel outside the window an index of 32 bits may wrap.
        let row = offset_from(self.window.top, y) as usize;
        let column = offset_from(self.window.left, x) as usize;
        row.wrapping_mul(self.stride).wrapping_add(column)
    }

    /// Whether all pixels of a span are inside the window, and its start is not behind its end.
    #[inline(always)]
    fn encloses(&self, span: Span) -> bool {
        let Window { left, top, bottom, .. } = self.window;
        // As unsigned numbers, columns left of the window and rows above it are beyond its right and lower sides.
        let (start, end) = (offset_from(left, span.start), offset_from(left, span.end));
        let row = offset_from(top, span.y);
        row < distance(top, bottom) && start <= end && end as usize <= self.stride
    }

    /// The words of the pixels of a span that is inside the window; of another one, some or none.
    #[inline(always)]
    fn words_of(&mut self, span: Span) -> Option<&mut [C::Word]> {
        let start = self.index_unchecked(span.start, span.y);
        let end = self.index_unchecked(span.end, span.y);
        self.words.get_mut(start..end)
    }
}

impl<C: BandColor, O: Order> GetPixel for Band<'_, C, O> {
    type Color = C;

    /// Reads a pixel back; `None` outside the band.
    fn pixel(&self, point: Point) -> Option<C> {
        // Compares rows and columns together, so that the comparison of rows is hoisted out of loops along a row.
        if !self.window.contains(point) {
            return None;
        }
        let word = *self.words.get(self.index_unchecked(point.x, point.y))?;
        Some(C::from_word(O::reorder(word)))
    }
}

#[cfg(feature = "defmt")]
impl<C: BandColor, O: Order> defmt::Format for Band<'_, C, O> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Band {}", self.window);
    }
}

/// The error of a buffer that has fewer words than a band needs.
const fn too_few_words(needed: usize) -> TooSmall {
    TooSmall::Words(needed)
}

/// Words for the pixels of a window; `usize::MAX` where no buffer could hold them.
fn words_needed(window: &Window) -> usize {
    usize::try_from(u64::from(window.width()) * u64::from(window.height())).unwrap_or(usize::MAX)
}
