//! Bands that are rotated by quarter turns on their way to a panel.
//!
//! A band of N rows becomes one of N columns when it is rotated by 90 or 270 degrees: its words are transposed in place, then
//! mirrored.
//!
//! ```text
//! row 0   a b c d                  e a
//! row 1   e f g h   -- 90 -->      f b
//!                                  g c
//!                                  h d
//! ```
//!
//! Transposition in place is a permutation of the words: the one that belongs to the position p was at (p mod N) * width + p / N. Each
//! position in turn is exchanged with the position where its word is by now, which is found by following that formula
//! until it leads beyond the positions that are done. Guarantees: no memory besides the band; any band, also without pixels.
//! Cost: a band of one row stays as it is or is reversed. Source: Windley, Transposing matrices in a digital computer (1959).

use core::{cell::Cell, mem::swap};

use embedded_graphics::primitives::Rectangle;

use crate::{
    band::Band,
    geometry::Window,
    surface::{BandColor, Order},
};

/// Rotates finished bands clockwise, for panels that are mounted sideways and whose controller cannot exchange rows and columns,
/// as the SSD1306 and those of most e-paper cannot.
///
/// The picture loop draws the picture as the viewer sees it, and the last thing that its scene does is to rotate the band: in a loop
/// that sends a band before it returns, by DMA or by futures alike. The panel's box begins where the picture's does: a picture of 64 x
/// 128 pixels at the origin goes to a panel of 128 x 64, from (0, 0) on. Bands go to the panel from its right to its left side
/// after 90 degrees, from its left to its right after 270. Where a sink packs pixels into bytes, the rows of a band have to be
/// whole bytes of the panel: [`PictureLoop::rows`](crate::band::PictureLoop::rows) of 8 for one-bit pixels. A
/// [`PagesSink`](crate::band::PagesSink) cannot follow, since it needs bands from top to bottom.
/// In a [`Supersampling`](crate::band::Supersampling), whose scene draws samples, a closure around the sink rotates the band instead.
///
/// Cost: a band of one row is sent as one column as it is, or reversed. One of more rows is transposed in place, in 3 to 7 steps a
/// pixel (counted with 2 to 16 rows of 128 to 320 pixels), each a product and no division. RAM: 20 bytes.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::*};
/// use zrow::{band::{DisplaySink, PanelRotation, PictureLoop}, draw::{DrawOn, PrimitiveStyle}};
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let picture = Rectangle::new(Point::zero(), Size::new(24, 32));
/// let line = Line::new(Point::new(3, 0), Point::new(20, 0)).into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1));
/// let rotation = PanelRotation::by_90(picture);
/// PictureLoop::new(picture, Rgb565::BLACK).draw(&mut [0; 24], &mut DisplaySink(&mut display), |band| {
///     let Ok(()) = line.draw_on(band);
///     rotation.rotate(band);
/// })?;
/// // The top of the picture is on the right side of a panel of 32 x 24.
/// assert_eq!(display.get_pixel(Point::new(31, 20)), Some(Rgb565::RED));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct PanelRotation {
    picture: Window,
    quarter_turns: QuarterTurns,
}

/// By how many quarter turns, clockwise, a picture is rotated on its way to the panel.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum QuarterTurns {
    One,
    Two,
    Three,
}

impl PanelRotation {
    /// Rotates bands of a picture by 90 degrees clockwise: its first row becomes the last column.
    pub fn by_90(picture: Rectangle) -> Self {
        Self::new(picture, QuarterTurns::One)
    }

    /// Rotates bands of a picture by 180 degrees: its first row becomes the last one, from right to left.
    pub fn by_180(picture: Rectangle) -> Self {
        Self::new(picture, QuarterTurns::Two)
    }

    /// Rotates bands of a picture by 270 degrees clockwise: its first row becomes the first column, from bottom to top.
    pub fn by_270(picture: Rectangle) -> Self {
        Self::new(picture, QuarterTurns::Three)
    }

    fn new(picture: Rectangle, quarter_turns: QuarterTurns) -> Self {
        Self {
            picture: picture.into(),
            quarter_turns,
        }
    }

    /// Rotates a band of the picture after all has been drawn into it: it stands for the panel's columns or rows from then on, so
    /// that what were drawn later would be elsewhere. A band that would lie beyond the number range of a `Point` after 90
    /// or 270 degrees has no pixels any more.
    pub fn rotate<C: BandColor, O: Order>(&self, band: &mut Band<'_, C, O>) {
        let Some(window) = self.on_the_panel(band.window) else {
            let Window { left, top, .. } = band.window;
            band.window = Window {
                right: left,
                bottom: top,
                ..band.window
            };
            band.stride = 0;
            band.words = &mut [];
            return;
        };
        let (rows, columns) = (band.window.height() as usize, band.window.width() as usize);
        if self.quarter_turns != QuarterTurns::Two {
            transpose(band.words, rows, columns);
        }
        if self.quarter_turns != QuarterTurns::One {
            reverse(band.words);
        }
        if self.quarter_turns != QuarterTurns::Two {
            band.words.chunks_mut(rows.max(1)).for_each(reverse);
        }
        band.window = window;
        band.stride = window.width() as usize;
    }

    /// The window of the panel that a part of the picture covers after its rotation; `None` where it would not fit the number
    /// range of a `Point`.
    fn on_the_panel(&self, part: Window) -> Option<Window> {
        let Window {
            left,
            top,
            right,
            bottom,
        } = self.picture;
        // Distances from each side of the picture, and from there on from the left and the upper side of the panel.
        let from = |side: i32, coordinate: i32| i64::from(coordinate) - i64::from(side);
        let from_left = [from(left, part.left), from(left, part.right)];
        let from_top = [from(top, part.top), from(top, part.bottom)];
        let from_right = [-from(right, part.right), -from(right, part.left)];
        let from_bottom = [-from(bottom, part.bottom), -from(bottom, part.top)];
        let (columns, rows) = match self.quarter_turns {
            QuarterTurns::One => (from_bottom, from_left),
            QuarterTurns::Two => (from_right, from_bottom),
            QuarterTurns::Three => (from_top, from_right),
        };
        let coordinate = |side: i32, distance: i64| i32::try_from(i64::from(side) + distance).ok();
        Some(Window {
            left: coordinate(left, columns[0])?,
            top: coordinate(top, rows[0])?,
            right: coordinate(left, columns[1])?,
            bottom: coordinate(top, rows[1])?,
        })
    }
}

/// Exchanges rows and columns of a matrix in its memory.
fn transpose<W: Copy>(words: &mut [W], rows: usize, columns: usize) {
    if rows <= 1 || columns <= 1 {
        return;
    }
    let divisor = Divisor::new(rows, columns);
    let source = |index: usize| {
        let (quotient, remainder) = divisor.divide(index);
        remainder * columns + quotient
    };
    let cells = Cell::from_mut(words).as_slice_of_cells();
    for (index, cell) in cells.iter().enumerate() {
        let mut from = source(index);
        while from < index {
            from = source(from);
        }
        if let Some(other) = cells.get(from) {
            cell.set(other.replace(cell.get()));
        }
    }
}

/// The number of rows of a matrix, by which indices of its words are divided: by a product with its reciprocal, and at most a few
/// subtractions.
#[derive(Copy, Clone)]
struct Divisor {
    rows: usize,
    /// `2^shift / rows`, rounded down.
    reciprocal: usize,
    shift: u32,
}

impl Divisor {
    /// For indices below `rows * columns`; there is one row at least.
    fn new(rows: usize, columns: usize) -> Self {
        // An index is below rows * columns and the reciprocal at most 2^shift / rows: the product is below columns * 2^shift.
        let shift = columns.leading_zeros().min(16);
        Self {
            rows,
            reciprocal: (1 << shift) / rows.max(1),
            shift,
        }
    }

    /// The quotient and the remainder.
    fn divide(&self, index: usize) -> (usize, usize) {
        // The reciprocal lacks less than 1, so that the quotient lacks less than index / 2^shift + 1.
        let mut quotient = (index * self.reciprocal) >> self.shift;
        let mut remainder = index - quotient * self.rows;
        while remainder >= self.rows {
            remainder -= self.rows;
            quotient += 1;
        }
        (quotient, remainder)
    }
}

/// Exchanges the first word with the last one, and so on.
fn reverse<W>(words: &mut [W]) {
    let mut words = words.iter_mut();
    while let (Some(first), Some(last)) = (words.next(), words.next_back()) {
        swap(first, last);
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for PanelRotation {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "PanelRotation of {}", self.picture);
    }
}
