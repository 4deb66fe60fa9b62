//! Walks a band of N rows down an area of the display.

use core::fmt::{self, Display};

use embedded_graphics::primitives::Rectangle;

use crate::{
    band::{Band, BufferTooSmall, Sink, words_needed},
    geometry::Window,
    surface::{BandColor, Order},
};

/// Draws a picture band by band: fill with the background, draw the scene, send, next band.
///
/// The scene is a closure that is called once for every band and draws into it whatever it likes; what falls outside
/// the band is clipped. The last band is shorter where the rows do not divide.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::*};
/// use zrow::{band::{Band, DisplaySink, PictureLoop}, draw::{DrawOn, PrimitiveStyle}};
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let mut row = [0u16; 64];
/// let line = Line::new(Point::zero(), Point::new(63, 40)).into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1));
/// PictureLoop::new(display.bounding_box(), Rgb565::BLACK)
///     .draw(&mut row, &mut DisplaySink(&mut display), |band: &mut Band<Rgb565>| {
///         let Ok(()) = line.draw_on(band);
///     })?;
/// assert_eq!(display.get_pixel(Point::new(63, 40)), Some(Rgb565::RED));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct PictureLoop<C> {
    window: Window,
    rows: u32,
    row_grid: u32,
    background: C,
}

impl<C: BandColor> PictureLoop<C> {
    /// A loop over bands of one row. Every band starts in the background colour.
    pub fn new(area: Rectangle, background: C) -> Self {
        Self {
            window: area.into(),
            rows: 1,
            row_grid: 1,
            background,
        }
    }

    /// Bands of this many rows; 0 counts as 1.
    #[must_use]
    pub fn rows(self, rows: u32) -> Self {
        Self {
            rows: rows.max(1),
            ..self
        }
    }

    /// For panels that take only windows on a grid (even columns, pages of 8 rows): the area grows outwards to whole
    /// multiples of `x` columns and `y` rows, and the rows of a band are rounded up to a multiple of `y`, whether
    /// [`rows`](Self::rows) is called before or after. 0 counts as 1. An area that would grow beyond the number range of a
    /// `Point` ends with it; if that is its first row, multiples count from there.
    #[must_use]
    pub fn aligned(self, x: u32, y: u32) -> Self {
        let (x, y) = (x.max(1), y.max(1));
        let window = Window {
            left: align_down(self.window.left, x),
            top: align_down(self.window.top, y),
            right: align_up(self.window.right, x),
            bottom: align_up(self.window.bottom, y),
        };
        Self {
            window,
            row_grid: y,
            ..self
        }
    }

    /// Words that a buffer must have for this loop.
    pub fn words_needed(&self) -> usize {
        words_needed(&self.band_at(self.window.top))
    }

    /// The areas of the bands, top to bottom. The last one is lower where the rows do not divide.
    pub fn bands(&self) -> impl Iterator<Item = Rectangle> + use<C> {
        self.windows().map(|window| window.to_rectangle())
    }

    pub(crate) fn windows(&self) -> impl Iterator<Item = Window> + use<C> {
        let this = *self;
        let mut top = this.window.top;
        core::iter::from_fn(move || {
            let band = this.band_at(top);
            top = band.bottom;
            (!band.is_empty()).then_some(band)
        })
    }

    fn band_at(&self, top: i32) -> Window {
        // Where the multiple does not fit, neither does any window: one band then holds all of it.
        let rows = self.rows.checked_next_multiple_of(self.row_grid).unwrap_or(u32::MAX);
        let bottom = self.window.bottom.min(top.saturating_add_unsigned(rows));
        Window {
            top,
            bottom,
            ..self.window
        }
    }

    /// Draws the whole picture once through one buffer.
    ///
    /// # Errors
    /// [`LoopError::BufferTooSmall`] before anything is drawn; [`LoopError::Sink`] with the error of the sink, after
    /// which nothing more is sent. The next call draws a whole picture again.
    pub fn draw<O, S, F>(&self, buffer: &mut [C::Word], sink: &mut S, mut scene: F) -> Result<(), LoopError<S::Error>>
    where
        O: Order,
        S: Sink<C, O>,
        F: FnMut(&mut Band<'_, C, O>),
    {
        self.check(buffer)?;
        let mut window = self.band_at(self.window.top);
        while !window.is_empty() {
            let band = self.draw_band(window, buffer, &mut scene)?;
            sink.send(band).map_err(LoopError::Sink)?;
            window = self.band_at(window.bottom);
        }
        trace!("{}: sent", self);
        Ok(())
    }

    pub(crate) fn check(&self, buffer: &[C::Word]) -> Result<(), BufferTooSmall> {
        let needed = self.words_needed();
        if buffer.len() < needed {
            Err(BufferTooSmall { needed })
        } else {
            Ok(())
        }
    }

    pub(crate) fn draw_band<'b, O: Order>(
        &self,
        window: Window,
        buffer: &'b mut [C::Word],
        scene: &mut impl FnMut(&mut Band<'_, C, O>),
    ) -> Result<Band<'b, C, O>, BufferTooSmall> {
        let mut band = Band::over(window, buffer)?;
        band.fill(self.background);
        scene(&mut band);
        Ok(band)
    }
}

#[cfg(feature = "defmt")]
impl<C> defmt::Format for PictureLoop<C> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "PictureLoop {} by {} rows", self.window, self.rows);
    }
}

fn align_down(value: i32, grid: u32) -> i32 {
    let aligned = i64::from(value).div_euclid(i64::from(grid)) * i64::from(grid);
    i32::try_from(aligned).unwrap_or(i32::MIN)
}

fn align_up(value: i32, grid: u32) -> i32 {
    let grid = i64::from(grid);
    let aligned = (i64::from(value) + grid - 1).div_euclid(grid) * grid;
    i32::try_from(aligned).unwrap_or(i32::MAX)
}

/// A picture was not drawn to its end.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LoopError<E> {
    /// A buffer is too small for a band.
    BufferTooSmall(BufferTooSmall),
    /// The sink failed.
    Sink(E),
}

impl<E> From<BufferTooSmall> for LoopError<E> {
    fn from(error: BufferTooSmall) -> Self {
        Self::BufferTooSmall(error)
    }
}

impl<E: Display> Display for LoopError<E> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BufferTooSmall(error) => error.fmt(formatter),
            Self::Sink(error) => write!(formatter, "the sink failed: {error}"),
        }
    }
}

impl<E: core::error::Error> core::error::Error for LoopError<E> {}
