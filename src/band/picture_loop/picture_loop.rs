//! Walks a band of N rows down an area of the display.

use core::{
    convert::Infallible,
    fmt::{self, Display},
    hint::black_box,
    marker::PhantomData,
};

use embedded_graphics::primitives::Rectangle;

use crate::{
    band::{Band, Sink, too_few_words, words_needed},
    geometry::{TooSmall, Window, coordinate_after},
    surface::{BandColor, LittleEndian, Order, PixelWord, not_constant},
};

/// Draws a picture band by band: fill with the background, draw the scene, send, next band.
///
/// The scene is a closure that is called once for every band and draws into it whatever it likes; what falls outside
/// the band is clipped. It returns nothing, or a `Result` whose error ends the loop. The last band is shorter where
/// the area's height is no multiple of a band's.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::*};
/// use zrow::{band::{DisplaySink, PictureLoop}, draw::{DrawOn, PrimitiveStyle}};
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let mut row = [0u16; 64];
/// let line = Line::new(Point::zero(), Point::new(63, 40)).into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1));
/// PictureLoop::new(display.bounding_box(), Rgb565::BLACK)
///     .draw(&mut row, &mut DisplaySink(&mut display), |band| line.draw_on(band))?;
/// assert_eq!(display.get_pixel(Point::new(63, 40)), Some(Rgb565::RED));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct PictureLoop<C, O = LittleEndian> {
    /// The byte order of the bands' words.
    order: PhantomData<O>,
    /// The area that is drawn, as a window.
    window: Window,
    /// Rows of a band, before they are rounded up to a multiple of `row_grid`.
    rows: u32,
    /// The number of which the rows of every band but the last are a multiple.
    row_grid: u32,
    /// The colour that every band begins with.
    background: C,
}

impl<C: BandColor> PictureLoop<C> {
    /// A loop over bands of one row, in little-endian order, that of most machines. Every band starts in the background colour.
    pub fn new(area: Rectangle, background: C) -> Self {
        Self {
            order: PhantomData,
            window: area.into(),
            rows: 1,
            row_grid: 1,
            background,
        }
    }
}

impl<C: BandColor, O: Order> PictureLoop<C, O> {
    /// The loop with bands of another byte order: [`BigEndian`](crate::surface::BigEndian) is what displays take, so that the
    /// bytes of a band are ready to be sent, where bands in the machine's order swap those of each word first
    /// ([`Band::into_bytes`]).
    #[must_use]
    pub fn in_order<P: Order>(self) -> PictureLoop<C, P> {
        let Self {
            window,
            rows,
            row_grid,
            background,
            ..
        } = self;
        PictureLoop {
            order: PhantomData,
            window,
            rows,
            row_grid,
            background,
        }
    }

    /// The loop with bands of this many rows; 0 counts as 1.
    #[must_use]
    pub fn rows(self, rows: u32) -> Self {
        Self {
            rows: rows.max(1),
            ..self
        }
    }

    /// For panels that take only windows on a grid (even columns, pages of 8 rows): the area grows outwards to whole
    /// multiples of `x` columns and `y` rows, and the rows of a band are rounded up to a multiple of `y`, whether
    /// [`rows`](Self::rows) is called before or after. An `x` or `y` of 0 counts as 1. An area
    /// that would grow beyond the number range of a `Point` is cut there; where its first row is, multiples count from that row.
    #[must_use]
    pub fn aligned(self, x: u32, y: u32) -> Self {
        let y = y.max(1);
        Self {
            window: self.window.aligned(x, y),
            row_grid: y,
            ..self
        }
    }

    /// Words that a buffer must have for this loop: one for each pixel of its largest band.
    pub fn words_needed(&self) -> usize {
        words_needed(&self.band_at(self.window.top))
    }

    /// The areas of the bands, top to bottom. The last one has fewer rows where the area's height is no multiple of a band's.
    pub fn bands(&self) -> impl Iterator<Item = Rectangle> + use<C, O> {
        self.windows().map(|window| window.to_rectangle())
    }

    /// The area that is drawn.
    pub(super) const fn area(&self) -> Window {
        self.window
    }

    /// The areas of the bands as windows, top to bottom.
    pub(crate) fn windows(&self) -> impl Iterator<Item = Window> + use<C, O> {
        let this = *self;
        let mut top = this.window.top;
        core::iter::from_fn(move || {
            let band = this.band_at(top);
            top = band.bottom;
            (!band.is_empty()).then_some(band)
        })
    }

    /// The window of the band that begins at the row `top`; empty below the last row.
    fn band_at(&self, top: i32) -> Window {
        // A multiple of the grid above `u32::MAX` is more than the rows of any window, so that one band holds all of them.
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
    /// `scene` draws a band; it returns nothing, or a `Result` whose error ends the picture. A closure that is kept in a variable
    /// before it is handed over names the type of its band: `|band: &mut Band<'_, Rgb565>| ..`, and
    /// `|band: &mut Band<'_, Rgb565, BigEndian>| ..` where [`in_order`](Self::in_order) has changed the order of bytes.
    ///
    /// # Errors
    /// [`LoopError::TooSmall`] where `buffer` has fewer than [`words_needed`](Self::words_needed): nothing is drawn then.
    /// [`LoopError::Sink`] and [`LoopError::Scene`] with the error of the sink or the scene, after which nothing more is drawn or
    /// sent. The next call draws a whole picture again.
    pub fn draw<S, F, R>(
        &self,
        buffer: &mut [C::Word],
        sink: &mut S,
        mut scene: F,
    ) -> Result<(), LoopError<S::Error, R::Error>>
    where
        S: Sink<C, O>,
        F: FnMut(&mut Band<'_, C, O>) -> R,
        R: SceneResult,
    {
        let mut window = self.band_at(self.window.top);
        let needed = words_needed(&window);
        let mut words = buffer.get_mut(..needed).ok_or_else(|| too_few_words(needed))?;
        let background = not_constant(Band::<C, O>::word(self.background));
        let (stride, rows) = (window.width() as usize, window.height());
        let mut remaining = self.window.height();
        while remaining > 0 {
            let rows = if remaining < rows {
                // The last band.
                words = words.get_mut(..stride * remaining as usize).unwrap_or_default();
                // Keeps this a branch: the compiler would select one of two slices in every band.
                black_box(());
                remaining
            } else {
                rows
            };
            remaining -= rows;
            window.bottom = coordinate_after(window.top, rows);
            PixelWord::fill(words, background);
            let mut band = Band {
                window,
                stride,
                words,
                order: PhantomData,
            };
            scene(&mut band).into_result().map_err(LoopError::Scene)?;
            sink.send(band).map_err(LoopError::Sink)?;
            window.top = window.bottom;
        }
        trace!("{}: sent", self);
        Ok(())
    }

    /// Whether a buffer has room for the largest band, else an error that says how many words are needed.
    pub(crate) fn check(&self, buffer: &[C::Word]) -> Result<(), TooSmall> {
        let needed = self.words_needed();
        if buffer.len() < needed {
            Err(too_few_words(needed))
        } else {
            Ok(())
        }
    }

    /// Fills the band of a window with the background and draws the scene into it. The buffer may be longer than the band.
    ///
    /// # Errors
    /// [`BandError::TooSmall`] for a buffer that is shorter, [`BandError::Scene`] with the scene's error.
    pub(crate) fn draw_band<'b, R: SceneResult>(
        &self,
        window: Window,
        buffer: &'b mut [C::Word],
        scene: &mut impl FnMut(&mut Band<'_, C, O>) -> R,
    ) -> Result<Band<'b, C, O>, BandError<R::Error>> {
        let mut band = Band::over(window, buffer).map_err(BandError::TooSmall)?;
        band.fill(self.background);
        scene(&mut band).into_result().map_err(BandError::Scene)?;
        Ok(band)
    }
}

#[cfg(feature = "defmt")]
impl<C: BandColor, O: Order> defmt::Format for PictureLoop<C, O> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        let first = self.band_at(self.window.top);
        defmt::write!(formatter, "PictureLoop {} by {} rows", self.window, first.height());
    }
}

/// Why a band could not be drawn. It is turned into a [`LoopError`] by a `match`, which shows the compiler the values that the
/// result of an asynchronous loop can have: without that, a panic is linked for a future that is polled after its end.
pub(crate) enum BandError<X> {
    /// The number of words that the band needs.
    TooSmall(usize),
    /// The error of the scene.
    Scene(X),
}

impl<E, X> From<BandError<X>> for LoopError<E, X> {
    fn from(error: BandError<X>) -> Self {
        match error {
            BandError::TooSmall(needed) => Self::TooSmall(too_few_words(needed)),
            BandError::Scene(error) => Self::Scene(error),
        }
    }
}

/// The result of a scene, the closure that draws a band: `()`, or a `Result` whose error ends the [`PictureLoop`].
pub trait SceneResult {
    /// The scene's error, which [`LoopError::Scene`] carries; `Infallible` for a scene that returns `()`.
    type Error;

    /// This value as a `Result`; `Ok` for `()`.
    ///
    /// # Errors
    /// The error that the scene returned.
    fn into_result(self) -> Result<(), Self::Error>;
}

impl SceneResult for () {
    type Error = Infallible;

    fn into_result(self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl<E> SceneResult for Result<(), E> {
    type Error = E;

    fn into_result(self) -> Self {
        self
    }
}

/// A picture was not drawn to its end. `E` is the error of the sink, `X` that of the scene.
///
/// A program that refreshes a display again and again sets the display up anew after an error of the sink, and goes on:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::band::{BytesSink, LoopError, PictureLoop};
///
/// # struct Bus { failures: u32, resets: u32 }
/// # impl Bus {
/// #     fn write(&mut self, _: &[u8]) -> Result<(), core::fmt::Error> {
/// #         let left = self.failures.checked_sub(1);
/// #         self.failures = left.unwrap_or(0);
/// #         left.map_or(Ok(()), |_| Err(core::fmt::Error))
/// #     }
/// #     fn reset(&mut self) { self.resets += 1 }
/// # }
/// # let mut bus = Bus { failures: 1, resets: 0 };
/// let mut row = [0; 64];
/// let area = Rectangle::new(Point::zero(), Size::new(64, 48));
/// for _frame in 0..3 {
///     let mut sink = BytesSink(|_, bytes: &[u8]| bus.write(bytes));
///     match PictureLoop::new(area, Rgb565::BLUE).draw(&mut row, &mut sink, |_band| {}) {
///         Ok(()) => {}
///         Err(LoopError::Sink(_)) => bus.reset(),
///         // Without words enough for a band, no frame can be drawn: the error says how many are needed.
///         Err(LoopError::TooSmall(error)) => return Err(error),
///         // This scene returns nothing, so that it cannot fail.
///         Err(LoopError::Scene(never)) => match never {},
///     }
/// }
/// assert_eq!(bus.resets, 1);
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LoopError<E, X = Infallible> {
    /// A buffer is too small for a band.
    TooSmall(TooSmall),
    /// The sink failed, with its error.
    Sink(E),
    /// The scene failed, with its error; [`Infallible`] for scenes that return nothing.
    Scene(X),
}

impl<E, X> From<TooSmall> for LoopError<E, X> {
    fn from(error: TooSmall) -> Self {
        Self::TooSmall(error)
    }
}

impl<E: Display, X: Display> Display for LoopError<E, X> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooSmall(error) => error.fmt(formatter),
            Self::Sink(error) => write!(formatter, "the sink failed: {error}"),
            Self::Scene(error) => write!(formatter, "the scene failed: {error}"),
        }
    }
}

impl<E: core::error::Error, X: core::error::Error> core::error::Error for LoopError<E, X> {}
