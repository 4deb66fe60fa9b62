//! The items of a picture: where they are, how they are drawn, and how far they are drawn.

use core::{fmt, hint::black_box, marker::PhantomData, ops::Range};

use embedded_graphics::geometry::{Dimensions, Point};

use crate::{
    band::Band,
    draw::{
        DrawOn,
        outline::{Common, EdgeSink},
        picture::pool::Pool,
    },
    geometry::{InputError, WideRectangle, Window},
    surface::{BandColor, LittleEndian, Order, PixelWord, Target},
};

/// The link of the last item of a list, and the list without items.
pub(super) const NONE: u16 = u16::MAX;

/// The columns and rows that an item of a picture may take: all that 16 bits hold.
pub(super) const WHOLE: Window = Window {
    left: i16::MIN as i32,
    top: i16::MIN as i32,
    right: i16::MAX as i32,
    bottom: i16::MAX as i32,
};

/// Identifies an item of a picture, to change it: the number of its slot.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::{Circle, Rectangle}};
/// use zrow::{band::Band, draw::{Picture, PictureSlot, PrimitiveStyle}};
///
/// let area = Rectangle::new(Point::zero(), Size::new(8, 1));
/// let (mut slots, mut row) = ([PictureSlot::EMPTY; 2], [0; 8]);
/// let mut picture = Picture::new(area, &mut slots, &mut [], &mut []);
/// let lamp = Circle::new(Point::zero(), 4).into_styled(PrimitiveStyle::with_fill(Gray8::new(9)));
/// let frame = Rectangle::new(Point::new(2, 0), Size::new(4, 1)).into_styled(PrimitiveStyle::with_fill(Gray8::new(5)));
/// let lamp_id = picture.add(&lamp)?;
/// picture.add(&frame)?;
///
/// // A lamp that blinks stays behind what was added after it.
/// picture.remove(lamp_id);
/// picture.draw(&mut Band::<Gray8>::new(area, &mut row)?);
/// assert_eq!(row, [0, 0, 5, 5, 5, 5, 0, 0]);
/// picture.replace(lamp_id, &lamp)?;
/// picture.draw(&mut Band::<Gray8>::new(area, &mut row)?);
/// assert_eq!(row, [0, 9, 5, 5, 5, 5, 0, 0]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ItemId(pub(super) u16);

/// An item that a program draws in a [`Picture`](crate::draw::Picture) in a way of its own.
///
/// Whatever implements [`DrawOn`] and embedded-graphics' `Dimensions` is one: every styled shape, texts, prepared
/// polygons and paths. The item is asked to draw only into bands that meet its rows.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{
///     band::{Band, Target},
///     draw::{Picture, PictureItem, PictureSlot},
///     geometry::Window,
/// };
///
/// /// A plot of samples from the left to the right, one a column, as bars above row 4.
/// struct Plot<const N: usize>([i32; N]);
///
/// impl<const N: usize> PictureItem<Gray8> for Plot<N> {
///     fn bounds(&self) -> Window {
///         Window { left: 0, top: 0, right: N as i32, bottom: 4 }
///     }
///
///     fn draw(&self, band: &mut Band<'_, Gray8>) {
///         let raw = band.raw(Gray8::WHITE);
///         for (x, sample) in (0..).zip(self.0) {
///             let Ok(()) = band.fill_window(Window { left: x, top: 4 - sample, right: x + 1, bottom: 4 }, raw);
///         }
///     }
/// }
///
/// let plot = Plot([1, 3, 2]);
/// let area = Rectangle::new(Point::zero(), Size::new(4, 4));
/// let (mut slots, mut words) = ([PictureSlot::EMPTY; 1], [0; 4]);
/// let mut picture = Picture::new(area, &mut slots, &mut [], &mut []);
/// picture.add_item(&plot)?;
/// // Row 2 shows the samples of 2 and more.
/// picture.draw(&mut Band::<Gray8>::new(Rectangle::new(Point::new(0, 2), Size::new(4, 1)), &mut words)?);
/// assert_eq!(words, [0, 255, 255, 0]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
pub trait PictureItem<C: BandColor, O: Order = LittleEndian> {
    /// A rectangle around all that is drawn, in pixels of the picture.
    fn bounds(&self) -> Window;

    /// Draws what the band shows of the item.
    fn draw(&self, band: &mut Band<'_, C, O>);

    /// Sets the cursor in an item's slot to a row.
    #[doc(hidden)]
    fn enter(&self, _slot: &mut PictureSlot<'_, C, O>, _pool: &mut Pool<'_>, _row: i32) {}

    /// The columns of an item in some of its rows, or more of them: the narrower, the less is drawn again when the item
    /// moves.
    #[doc(hidden)]
    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, _pool: &Pool<'_>, _rows: Range<i32>) -> (i32, i32) {
        slot.extent.columns()
    }

    /// Whether an item that is wider than a window may have pixels in it.
    #[doc(hidden)]
    fn may_meet(&self, slot: &PictureSlot<'_, C, O>, _pool: &Pool<'_>, window: &Window) -> bool {
        let (left, right) = slot.extent.columns();
        left < window.right && window.left < right
    }

    /// What the item is among the others.
    #[doc(hidden)]
    fn role(&self) -> Role {
        Role::Item
    }

    /// Where an outline takes the place of another one: calls with the edges that only one of them has, between which the
    /// pixels lie that change, and with whether the new one has them.
    #[doc(hidden)]
    fn changed_edges(&self, _old: &[u32], _new: &[u32], _call: &mut EdgeSink<'_>) -> Common {
        Common::Unknown
    }

    /// Checks that an item can be moved so that its pixels lie in a window.
    #[doc(hidden)]
    fn check_translated(&self, _moved: &Window) -> Result<(), InputError> {
        Ok(())
    }

    /// Moves an item by some pixels, the extent of which is moved already. An item by reference stays what it is, and is
    /// drawn into bands that are moved the other way: its cursor is how far.
    #[doc(hidden)]
    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, _pool: &mut Pool<'_>, by: Point) {
        let [x, y] = slot.cursor;
        // An extent has 16 bits, so that no sum of what it was moved by has more than 17.
        slot.cursor = [x as i32 + by.x, y as i32 + by.y].map(|moved| moved as u32);
    }

    /// Draws a band of one row, that of the cursor, and moves the cursor to the next row.
    #[doc(hidden)]
    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, _pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        match slot.cursor.map(|moved| moved as i32) {
            [0, 0] => self.draw(band),
            [x, y] => self.draw(&mut band.translated(Point::new(-x, -y))),
        }
    }

    /// Draws the rows that the band has, from the cursor's row on, and moves the cursor behind them.
    #[doc(hidden)]
    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        // An item may begin below the band, in the bucket of its rows.
        if !slot.extent.rows(&band.window()).is_empty() {
            self.draw_row(slot, pool, band);
        }
    }
}

impl<C: BandColor, O: Order, T: DrawOn<Color = C> + Dimensions> PictureItem<C, O> for T {
    fn bounds(&self) -> Window {
        self.bounding_box().into()
    }

    fn draw(&self, band: &mut Band<'_, C, O>) {
        let Ok(()) = self.draw_on(band);
    }
}

/// What an item is among the others of its picture.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Role {
    /// It is drawn.
    Item,
    /// It is drawn, and its words are a colour and an outline.
    Outline,
    /// A group begins behind it.
    GroupBegin,
    /// A group ends before it.
    GroupEnd,
}

/// How all items of one kind are drawn, each from its slot and its words, in which no position is but the extent.
pub(super) trait ItemKind<C: BandColor, O: Order>: 'static {
    /// Sets the cursor to a row of the item.
    fn enter(_slot: &mut PictureSlot<'_, C, O>, _pool: &mut Pool<'_>, _row: i32) {}

    /// The columns of an item in some of its rows, or more of them.
    fn columns_in(slot: &PictureSlot<'_, C, O>, _rows: Range<i32>) -> (i32, i32) {
        slot.extent.columns()
    }

    /// Draws a band of one row, that of the cursor, and moves the cursor to the next row.
    fn draw_row(slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>);
}

/// The function table of a kind, as an item without data.
struct Kind<K>(PhantomData<K>);

impl<C: BandColor, O: Order, K: ItemKind<C, O>> PictureItem<C, O> for Kind<K> {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, row: i32) {
        K::enter(slot, pool, row);
    }

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, _: &Pool<'_>, rows: Range<i32>) -> (i32, i32) {
        K::columns_in(slot, rows)
    }

    /// Everything is computed from the extent.
    fn translate(&self, _: &mut PictureSlot<'_, C, O>, _: &mut Pool<'_>, _: Point) {}

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        K::draw_row(slot, pool, band);
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        each_row(slot, band, |slot, row| K::draw_row(slot, pool, row));
    }
}

/// Calls with each of the rows that a band has of an item, as a band of its own.
#[inline]
pub(super) fn each_row<'a, C: BandColor, O: Order>(
    slot: &mut PictureSlot<'a, C, O>,
    band: &mut Band<'_, C, O>,
    mut draw_row: impl FnMut(&mut PictureSlot<'a, C, O>, &mut Band<'_, C, O>),
) {
    for y in slot.extent.rows(&band.window()) {
        if let Some(mut row) = band.one_row(y) {
            draw_row(slot, &mut row);
        }
    }
}

/// The function table of a kind of items, with which a slot draws.
pub(super) const fn kind_of<C: BandColor, O: Order, K: ItemKind<C, O>>() -> &'static dyn PictureItem<C, O> {
    const { &Kind::<K>(PhantomData) }
}

/// The box of an item: columns `left <= x < right`, rows `first <= y < end`.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Extent {
    pub(super) first: i16,
    pub(super) end: i16,
    pub(super) left: i16,
    pub(super) right: i16,
}

impl Extent {
    /// The box without pixels.
    pub(super) const EMPTY: Self = Self {
        first: 0,
        end: 0,
        left: 0,
        right: 0,
    };

    /// The first row of an empty box whose item has pixels, but none that 16 bits tell.
    const BEYOND: i16 = i16::MIN;

    /// The pixels of a window, of which those that 16 bits cannot tell are left out.
    pub(super) fn of(window: &Window) -> Self {
        let visible = window.intersection(&WHOLE);
        if visible.is_empty() {
            let row = if window.is_empty() { 0 } else { Self::BEYOND };
            return Self {
                first: row,
                end: row,
                ..Self::EMPTY
            };
        }
        let Window {
            left,
            top,
            right,
            bottom,
        } = visible;
        // Between the ends of `WHOLE`.
        let [left, first, right, end] = [left, top, right, bottom].map(|side| side as i16);
        Self {
            first,
            end,
            left,
            right,
        }
    }

    /// The pixels of a window; `None` where 16 bits cannot tell them all.
    pub(super) fn of_whole(window: &Window) -> Option<Self> {
        (window.intersection(&WHOLE) == *window && !window.is_empty()).then(|| Self::of(window))
    }

    /// The pixels of a box; `None` where it has none, or 16 bits cannot tell them all.
    pub(super) fn of_box(wide: &WideRectangle) -> Option<Self> {
        let side = |start: i64, length: u32| {
            let first = i16::try_from(start).ok()?;
            let length = i32::from(u16::try_from(length).ok()?);
            let end = i16::try_from(i32::from(first) + length).ok()?;
            (length > 0).then_some((first, end))
        };
        let (left, right) = side(wide.left, wide.size.width)?;
        let (first, end) = side(wide.top, wide.size.height)?;
        Some(Self {
            first,
            end,
            left,
            right,
        })
    }

    /// The smallest box around some pixels, of which there is one at least; `None` where 16 bits cannot tell them all.
    pub(super) fn around<const N: usize>(points: [Point; N]) -> Option<Self> {
        let greatest = Point::new(i32::MAX, i32::MAX);
        let least = Point::new(i32::MIN, i32::MIN);
        let top_left = points.into_iter().fold(greatest, Point::component_min);
        let bottom_right = points.into_iter().fold(least, Point::component_max);
        let end = |last: i32| i16::try_from(last).ok()?.checked_add(1);
        Some(Self {
            first: i16::try_from(top_left.y).ok()?,
            end: end(bottom_right.y)?,
            left: i16::try_from(top_left.x).ok()?,
            right: end(bottom_right.x)?,
        })
    }

    pub(super) const fn is_empty(self) -> bool {
        self.first >= self.end
    }

    /// Whether the item has no pixels, also none that 16 bits do not tell.
    pub(super) const fn has_nothing(self) -> bool {
        self.is_empty() && self.first != Self::BEYOND
    }

    /// The box as a window.
    pub(super) fn window(self) -> Window {
        Window {
            left: self.left.into(),
            top: self.first.into(),
            right: self.right.into(),
            bottom: self.end.into(),
        }
    }

    /// The rows that a band has of the box.
    #[inline]
    pub(super) fn rows(self, band: &Window) -> Range<i32> {
        i32::from(self.first).max(band.top)..i32::from(self.end).min(band.bottom)
    }

    /// First column, and the one after the last.
    #[inline]
    pub(super) fn columns(self) -> (i32, i32) {
        (i32::from(self.left), i32::from(self.right))
    }

    /// Columns of the box.
    #[inline]
    pub(super) fn width(self) -> i32 {
        i32::from(self.right) - i32::from(self.left)
    }

    /// Rows of the box.
    #[inline]
    pub(super) fn height(self) -> i32 {
        i32::from(self.end) - i32::from(self.first)
    }

    /// How far the upper edge of a row is below the middle of the box, doubled.
    #[inline]
    pub(super) fn edge_below_middle(self, row: i32) -> i32 {
        2 * row - i32::from(self.first) - i32::from(self.end)
    }
}

/// Memory for one item of a [`Picture`](crate::draw::Picture): 32 bytes on a 32-bit machine, 36 for 32-bit colours.
///
/// All zero bits when empty, so that a `static` lies in `.bss`.
///
/// A picture whose slots are too few says how many it needs:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::{
///     draw::{Picture, PictureSlot, PrimitiveStyle},
///     geometry::{InputError, TooSmall},
/// };
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let panel = area.into_styled(PrimitiveStyle::with_fill(Rgb565::BLUE));
/// let mut slots = [PictureSlot::EMPTY; 1];
/// let mut picture = Picture::<Rgb565>::new(area, &mut slots, &mut [], &mut []);
/// picture.add(&panel)?;
/// assert_eq!(picture.add(&panel), Err(InputError::TooSmall(TooSmall::Items(2))));
/// # Ok::<(), InputError>(())
/// ```
pub struct PictureSlot<'a, C: BandColor, O: Order = LittleEndian> {
    pub(super) extent: Extent,
    /// The next item of the bucket or of the active list.
    pub(super) next: u16,
    /// Where the item's words begin in the pool.
    pub(super) at: u16,
    /// How many words of the pool the item has.
    pub(super) words: u16,
    /// The colour, in the band's byte order.
    pub(super) word: C::Word,
    /// Where the item is in the row that comes next; each kind has its own meaning for it.
    pub(super) cursor: [u32; 2],
    /// How it is drawn; `None` draws nothing.
    pub(super) kind: Option<&'a dyn PictureItem<C, O>>,
}

impl<C: BandColor, O: Order> PictureSlot<'_, C, O> {
    /// Memory without an item.
    pub const EMPTY: Self = Self {
        extent: Extent::EMPTY,
        next: 0,
        at: 0,
        words: 0,
        word: C::Word::ZERO,
        cursor: [0; 2],
        kind: None,
    };
}

impl<C: BandColor, O: Order> Copy for PictureSlot<'_, C, O> {}

impl<C: BandColor, O: Order> Clone for PictureSlot<'_, C, O> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C: BandColor, O: Order> Default for PictureSlot<'_, C, O> {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl<C: BandColor, O: Order> fmt::Debug for PictureSlot<'_, C, O> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("PictureSlot")
            .field("extent", &self.extent)
            .field("words", &self.words)
            .finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<C: BandColor, O: Order> defmt::Format for PictureSlot<'_, C, O> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "PictureSlot {}, {} words", self.extent, self.words);
    }
}

/// Fills columns of a band of one row, those that it has.
#[inline]
pub(super) fn fill_span<C: BandColor, O: Order>(band: &mut Band<'_, C, O>, columns: (i32, i32), word: C::Word) {
    match span_of(band, columns) {
        Some(words) => PixelWord::fill(words, word),
        None => fill_cut_span(band, columns.0, columns.1, word),
    }
}

/// The words of columns of a band of one row; `None` where it does not have all, or their start is behind their end.
#[inline]
pub(super) fn span_of<'b, C: BandColor, O: Order>(
    band: &'b mut Band<'_, C, O>,
    (start, end): (i32, i32),
) -> Option<&'b mut [C::Word]> {
    // Less than a range from one column to the other takes: only one of them is counted from the band's first one.
    let width = (end - start) as usize;
    let start = (start - band.window().left) as usize;
    band.words_mut().get_mut(start..)?.get_mut(..width)
}

/// Fills columns of which some are outside the row, or none are left.
#[cold]
#[inline(never)]
fn fill_cut_span<C: BandColor, O: Order>(band: &mut Band<'_, C, O>, start: i32, end: i32, word: C::Word) {
    let left = band.window().left;
    let row = band.words_mut();
    let visible = (start - left).max(0) as usize..row.len().min((end - left).max(0) as usize);
    if let Some(words) = row.get_mut(visible) {
        PixelWord::fill(words, word);
    }
}

/// Fills a few columns of a band of one row, those that it has, pixel by pixel.
#[inline]
pub(super) fn fill_short_span<C: BandColor, O: Order>(band: &mut Band<'_, C, O>, columns: (i32, i32), word: C::Word) {
    match span_of(band, columns) {
        Some(words) => fill_singly(words, word),
        None => fill_cut_span(band, columns.0, columns.1, word),
    }
}

/// Fills a few pixels, one by one.
#[inline]
pub(super) fn fill_singly<W: PixelWord>(words: &mut [W], word: W) {
    for pixel in words {
        *pixel = word;
        // Most runs are short: the compiler would prepare for long ones.
        black_box(());
    }
}

/// Sets a pixel of a row, by its index; nothing where the row has none.
#[inline]
pub(super) fn set_pixel<W: PixelWord>(row: &mut [W], column: i32, word: W) {
    if let Some(pixel) = row.get_mut(column as usize) {
        *pixel = word;
    }
}
