//! Antialiased outlines by copy: their corners lie in the pool, their edges are set up in the rows in which they begin.

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::{
    band::Band,
    coverage::EmitRows,
    draw::{
        FillRule, SubOutline,
        outline::{self, Common, EdgeSink, Progress, RowMemory, StoredOutline},
        payload::Payload,
        picture::{
            item::{Extent, ItemId, PictureItem, PictureSlot, Role},
            picture::Picture,
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::{InputError, Window},
    shade::{BatchBlend, ChannelColor},
    surface::{BandColor, Order, PixelWord, Target},
};

impl<'a, C: ChannelColor, O: Order> Picture<'_, 'a, C, O> {
    /// Adds a copy of the inside of an outline, by a fill rule, in a colour, with edges antialiased by exact area, in front of
    /// all other items.
    ///
    /// It is blended over what lies behind it in the picture. The method is picked by the outline: centre samples where all
    /// its edges lie along pixels, the signed area where it is one contour that does not cross itself, and else the area
    /// inside.
    ///
    /// In the picture's pool it takes 16 bytes, and for each y-monotone chain of its edges 4 bytes and 4 for each corner; where
    /// a corner is more than 127 pixels from the first one, 20 bytes, and twice that for each chain. Of large curves, arcs are
    /// kept in the place of corners: 28 bytes an arc and 8 a chain. The picture needs
    /// [`with_antialiasing`](Picture::with_antialiasing).
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::{
    ///     band::Band,
    ///     draw::{AntialiasingMemory, FillRule, Picture, PictureSlot, SubEllipse},
    ///     fixed::types::U24F8,
    ///     geometry::{Sub8, SubPoint},
    /// };
    ///
    /// let disc = SubEllipse::circle(SubPoint::<Sub8>::from_units(32 * 256, 32 * 256)?, U24F8::from_num(20.5))?;
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 96], [0; 64]);
    /// let mut memory = AntialiasingMemory::<65, 16, 4>::new();
    /// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
    /// picture.add_outline(&disc, FillRule::NonZero, Rgb565::RED)?;
    ///
    /// let mut row = [0; 64];
    /// let mut band = Band::<Rgb565>::new(Rectangle::new(Point::new(0, 32), Size::new(64, 1)), &mut row)?;
    /// picture.draw(&mut band);
    /// assert_eq!(row[32], Rgb565::RED.into_storage());
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`add`](Picture::add).
    pub fn add_outline(
        &mut self,
        outline: &dyn SubOutline,
        fill_rule: FillRule,
        color: C,
    ) -> Result<ItemId, InputError> {
        self.add(&ColoredOutline {
            outline,
            fill_rule,
            color,
        })
    }

    /// Puts a copy of the inside of an outline in the place of an item, as [`add_outline`](Picture::add_outline) adds it.
    ///
    /// # Errors
    /// As [`replace`](Picture::replace).
    pub fn replace_outline(
        &mut self,
        id: ItemId,
        outline: &dyn SubOutline,
        fill_rule: FillRule,
        color: C,
    ) -> Result<(), InputError> {
        let outline = ColoredOutline {
            outline,
            fill_rule,
            color,
        };
        self.replace(id, &outline)
    }
}

/// The inside of an outline, by a fill rule, in a colour.
struct ColoredOutline<'o, C> {
    outline: &'o dyn SubOutline,
    fill_rule: FillRule,
    color: C,
}

impl<'a, C: ChannelColor, O: Order> Prepare<'a, C, O> for ColoredOutline<'_, C> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        payload.push_pixel(self.color.to_word());
        match outline::store(self.outline, self.fill_rule, payload) {
            Ok(stored) => Draft {
                segments: Ok(stored.segments_needed()),
                ..Draft::new(Extent::of(&stored.bounds), not_used::<C>(), &Outline)
            },
            Err(error) => Draft {
                segments: Err(error),
                ..Draft::nothing()
            },
        }
    }
}

/// Draws a row of an outline that is an item or a part of one, and returns the cursor of the next row.
#[inline(always)]
pub(super) fn draw_row<C: ChannelColor, O: Order>(
    slot: &PictureSlot<'_, C, O>,
    mut progress: Progress,
    (color, outline): (C, StoredOutline<'_>),
    memory: &mut RowMemory<'_>,
    band: &mut Band<'_, C, O>,
) -> [u32; 2] {
    let Window { left, right, .. } = band.window();
    let row = band.window().top;
    let (first, end) = slot.extent.columns();
    let is_cut = first < left || right < end;
    let (mut blender, columns) = (band.blender(color), left..right);
    let Ok(()) = progress.draw_row(outline, memory, row, columns, is_cut, &mut blender.row(row));
    if row + 1 >= i32::from(slot.extent.end) {
        progress.end(outline, memory);
    }
    progress.to_words()
}

/// How outlines are drawn: the colour is the first word, the cursor is the [`Progress`].
pub(super) struct Outline;

impl Outline {
    /// The outline of an item and the memory that all of them share.
    fn split<'p, 'm, C: BandColor>(
        slot: &PictureSlot<'_, C, impl Order>,
        pool: &'p mut Pool<'m>,
    ) -> (C, StoredOutline<'p>, &'p mut RowMemory<'m>) {
        let (words, memory) = pool.words_and_memory(slot.at);
        let (color, words) = words.split_first().unwrap_or((&0, &[]));
        (
            C::from_word(C::Word::from_repeated(*color)),
            StoredOutline::new(words),
            memory,
        )
    }
}

impl<C: ChannelColor, O: Order> PictureItem<C, O> for Outline {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn check_translated(&self, moved: &Window) -> Result<(), InputError> {
        outline::check_moved(moved)
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        if let Some((_, outline)) = pool.slice_mut(slot.at, slot.words).split_first_mut() {
            outline::translate(outline, by.into());
        }
    }

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, _: i32) {
        let (_, outline, memory) = Self::split(slot, pool);
        slot.cursor = Progress::begin(outline, memory).to_words();
    }

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, pool: &Pool<'_>, rows: Range<i32>) -> (i32, i32) {
        let words = pool.slice(slot.at, slot.words);
        StoredOutline::new(words.get(1..).unwrap_or_default()).columns_in(&rows)
    }

    fn may_meet(&self, slot: &PictureSlot<'_, C, O>, pool: &Pool<'_>, window: &Window) -> bool {
        let (left, right) = slot.extent.columns();
        let words = pool.slice(slot.at, slot.words);
        left < window.right
            && window.left < right
            && !StoredOutline::new(words.get(1..).unwrap_or_default()).is_around(window)
    }

    fn role(&self) -> Role {
        Role::Outline
    }

    fn changed_edges(&self, old: &[u32], new: &[u32], call: &mut EdgeSink<'_>) -> Common {
        match (old.split_first(), new.split_first()) {
            (Some((old_color, old)), Some((new_color, new))) if old_color == new_color => {
                outline::changed_edges(StoredOutline::new(old), StoredOutline::new(new), call)
            }
            _ => Common::Unknown,
        }
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let (color, outline, memory) = Self::split(slot, pool);
        slot.cursor = draw_row(slot, Progress::of(slot.cursor), (color, outline), memory, band);
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        for row in slot.extent.rows(&band.window()) {
            if let Some(mut band) = band.one_row(row) {
                self.draw_row(slot, pool, &mut band);
            }
        }
    }
}
