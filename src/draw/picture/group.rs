//! Groups: items side by side in painter's order that are clipped together, and blended together over what lies behind them.
//!
//! ```text
//!     painter's order:   item   begin   item   item   end   item
//!
//!     a row:             draw   keep    draw   draw   mix   draw        keep: a copy of the row's pixels in the clip
//!                                  columns of the clip                  mix:  the pixels now over those of the copy
//! ```
//!
//! Both ends of a group are items that every row meets; between them the band of the row has the columns of the clip only,
//! or none. Groups may lie in groups. What is not clipped and is opaque costs two items. A clip path is an antialiased
//! outline, whose coverage of a pixel weakens the opacity of the group there.
//!
//! Guarantees: the pixels are those of the items drawn into a picture of their own, whose pixels in the clip are blended
//! over those behind it. Cost of a row: for a group that is not opaque or has a clip path a copy of its pixels, and blending
//! them; for a clip path what an antialiased outline takes.

use core::{convert::Infallible, ops::Range};

use embedded_graphics::{geometry::Point, primitives::Rectangle};

use crate::{
    band::Band,
    draw::{
        FillRule, SubOutline,
        outline::{self, Progress, StoredOutline},
        payload::{Payload, Reader},
        picture::{
            item::{Extent, ItemId, NONE, PictureItem, PictureSlot, Role, WHOLE},
            picture::{ItemMemory, Picture},
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::{InputError, TooSmall, Window},
    shade::ChannelColor,
    surface::{Order, Target},
};

/// How the items of a group are drawn: for [`Picture::begin_group`]. Opaque and not clipped by default.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, Rectangle}};
/// use zrow::{band::Band, draw::{Group, Picture, PictureSlot, PrimitiveStyle}};
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 4], [0; 6], [0; 64]);
/// let mut kept = [0; 64];
/// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut buckets).with_group_rows(&mut kept);
///
/// let group = picture.begin_group(Group::new().opacity(128).clip(Rectangle::new(Point::zero(), Size::new(32, 64))))?;
/// picture.add(&Circle::new(Point::new(7, 7), 50).into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE)))?;
/// picture.end_group()?;
///
/// let mut row = [0; 64];
/// let mut band = Band::<Rgb565>::new(Rectangle::new(Point::new(0, 32), Size::new(64, 1)), &mut row)?;
/// picture.draw(&mut band);
/// assert_eq!((row[31], row[32]), (Rgb565::new(16, 32, 16).into_storage(), 0));
///
/// // It fades.
/// picture.replace_group(group, Group::new().opacity(64))?;
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Group {
    clip: Window,
    opacity: u8,
}

impl Group {
    /// A group that is opaque and not clipped.
    pub const fn new() -> Self {
        Self {
            clip: WHOLE,
            opacity: u8::MAX,
        }
    }

    /// Shows what lies in a rectangle only, in pixels of the picture.
    #[must_use]
    pub fn clip(self, clip: Rectangle) -> Self {
        Self {
            clip: Window::from(clip).intersection(&WHOLE),
            ..self
        }
    }

    /// Blends the group over what lies behind it: 0 shows nothing of it, 255 is opaque. Any other one needs
    /// [`Picture::with_group_rows`], and shows the group within the picture's area only.
    #[must_use]
    pub const fn opacity(self, opacity: u8) -> Self {
        Self { opacity, ..self }
    }

    /// Whether the pixels behind the group are kept to blend it over them.
    const fn is_blended(&self) -> bool {
        self.opacity != 0 && self.opacity != u8::MAX
    }

    /// The columns that a row shows of the group. Where there are none, they begin in column 0, from which the columns of items and
    /// of bands can be counted: the row may be cut off at an area that is farther away than the number range.
    fn columns_in(&self, row: &Window) -> Range<i32> {
        let clipped = self.clip.intersection(row);
        if clipped.is_empty() || self.opacity == 0 {
            return 0..0;
        }
        clipped.left..clipped.right
    }

    /// The words of a group, before those of its clip path.
    fn write(&self, payload: &mut Payload<'_>) {
        let Window {
            left,
            top,
            right,
            bottom,
        } = self.clip;
        for side in [left, top, right, bottom] {
            payload.push_signed(side);
        }
        payload.push(self.opacity.into());
    }

    fn read(words: &[u32]) -> Self {
        let mut reader = Reader::new(words);
        let mut side = || reader.next_signed();
        let clip = Window {
            left: side(),
            top: side(),
            right: side(),
            bottom: side(),
        };
        Self {
            clip,
            opacity: reader.next() as u8,
        }
    }
}

impl Default for Group {
    fn default() -> Self {
        Self::new()
    }
}

/// Words of a [`Group`].
const GROUP_WORDS: u16 = 5;

/// A group without a clip path. [`Group`] itself is no item: one that [`Picture::add`] took would be drawn without rows being checked
/// for it.
struct PlainGroup(Group);

/// A group and its clip path.
struct PathGroup<'o> {
    group: Group,
    path: &'o dyn SubOutline,
    fill_rule: FillRule,
}

/// The item before those of a group: its words are the [`Group`].
struct Begin;

/// The item before those of a group with a clip path: its words are the [`Group`] and the outline of the path, its cursor is
/// how far that is drawn.
struct BeginInPath;

/// The item behind those of a group.
struct End;

impl<'a, C: ChannelColor, O: Order> Prepare<'a, C, O> for PlainGroup {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        let Self(group) = self;
        group.write(payload);
        Draft::new(Extent::of(&WHOLE), not_used::<C>(), &Begin)
    }
}

impl<'a, C: ChannelColor, O: Order> Prepare<'a, C, O> for PathGroup<'_> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        self.group.write(payload);
        let stored = outline::store_whole(self.path, self.fill_rule, payload);
        Draft {
            segments: stored.map(|stored| stored.segments_needed()),
            ..Draft::new(Extent::of(&WHOLE), not_used::<C>(), &BeginInPath)
        }
    }
}

impl<C: ChannelColor, O: Order> PictureItem<C, O> for Begin {
    fn bounds(&self) -> Window {
        WHOLE
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn role(&self) -> Role {
        Role::GroupBegin
    }
}

impl<C: ChannelColor, O: Order> PictureItem<C, O> for BeginInPath {
    fn bounds(&self) -> Window {
        WHOLE
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn enter(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, _: i32) {
        let (words, memory) = pool.words_and_memory(slot.at);
        slot.cursor = Progress::begin(path_in(words), memory).to_words();
    }

    fn role(&self) -> Role {
        Role::GroupBegin
    }
}

impl<C: ChannelColor, O: Order> PictureItem<C, O> for End {
    fn bounds(&self) -> Window {
        WHOLE
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn role(&self) -> Role {
        Role::GroupEnd
    }
}

impl<'m, 'a, C: ChannelColor, O: Order> Picture<'m, 'a, C, O> {
    /// Lends memory to groups that are blended: one row of the picture's area for each of them that lies in another one,
    /// and one for all others.
    #[must_use]
    pub fn with_group_rows(mut self, rows: &'m mut [C::Word]) -> Self {
        self.group_rows = rows;
        self
    }

    /// Begins a group: all items that are added from now on to [`end_group`](Self::end_group), or to the last item of the picture,
    /// are clipped and blended together. Takes a slot and 5 words of the pool.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the slots, the words of the pool, or the words for rows
    /// ([`with_group_rows`](Self::with_group_rows), [`TooSmall::GroupWords`]) that are needed.
    pub fn begin_group(&mut self, group: Group) -> Result<ItemId, InputError> {
        self.check_rows(group, self.slots_used())?;
        let id = self.add_unrecorded(&PlainGroup(group))?;
        self.draw_groups = self.draw_groups.or(Some(draw::<C, O, false>));
        Ok(id)
    }

    /// Begins a group that is clipped by a path as well: it shows as much in a pixel as the path, filled by a rule, covers of
    /// it, by exact area. Beyond a group's memory it takes that of an antialiased outline
    /// ([`add_outline`](Self::add_outline)), and needs [`with_group_rows`](Self::with_group_rows) whatever its opacity is.
    ///
    /// ```
    /// # use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// # use zrow::{
    /// #     band::Band,
    /// #     draw::{AntialiasingMemory, FillRule, Group, Picture, PictureSlot, PrimitiveStyle, SubEllipse},
    /// #     fixed::types::U24F8,
    /// #     geometry::{Sub8, SubPoint},
    /// # };
    /// # let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// # let (mut slots, mut pool, mut kept, mut row) = ([PictureSlot::EMPTY; 3], [0; 64], [0; 64], [0; 64]);
    /// # let mut memory = AntialiasingMemory::<65, 16, 4>::new();
    /// # let mut picture = Picture::new(area, &mut slots, &mut pool, &mut [])
    /// #     .with_antialiasing(&mut memory)
    /// #     .with_group_rows(&mut kept);
    /// let disc = SubEllipse::circle(SubPoint::<Sub8>::from_units(32 * 256, 32 * 256)?, U24F8::from_num(20))?;
    /// picture.begin_path_group(Group::new(), &disc, FillRule::NonZero)?;
    /// picture.add(&area.into_styled(PrimitiveStyle::with_fill(Rgb565::RED)))?;
    /// picture.end_group()?;
    /// # picture.draw(&mut Band::<Rgb565>::new(Rectangle::new(Point::new(0, 32), Size::new(64, 1)), &mut row)?);
    /// assert_eq!((row[11], row[32]), (0, Rgb565::RED.into_storage()));
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// As [`begin_group`](Self::begin_group), and as [`add_outline`](Self::add_outline) for the path.
    pub fn begin_path_group(
        &mut self,
        group: Group,
        path: &dyn SubOutline,
        fill_rule: FillRule,
    ) -> Result<ItemId, InputError> {
        self.check_kept_rows(self.slots_used())?;
        let id = self.add_unrecorded(&PathGroup { group, path, fill_rule })?;
        self.draw_groups = Some(draw::<C, O, true>);
        Ok(id)
    }

    /// Ends the group that was begun last and has not ended. Takes a slot, also where there is no such group: then it does nothing.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the slots that are needed.
    pub fn end_group(&mut self) -> Result<ItemId, InputError> {
        self.add_item_unrecorded(&End)
    }

    /// Clips and blends the items of a group in another way. A clip path stays.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the words for rows ([`with_group_rows`](Self::with_group_rows), [`TooSmall::GroupWords`]) that are
    /// needed; [`InputError::NoSuchItem`] for an id that names no group. Then every group stays as it was.
    pub fn replace_group(&mut self, id: ItemId, group: Group) -> Result<(), InputError> {
        let index = self.index_of_group(id)?;
        self.check_rows(group, index)?;
        self.rewrite(id, |payload| group.write(payload));
        self.record_group(index);
        Ok(())
    }

    /// Clips and blends the items of a group in another way, and gives it another clip path, or its first one. The pool has to
    /// have room for the words of both.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with what is needed: words of the pool, words for rows
    /// ([`with_group_rows`](Self::with_group_rows), [`TooSmall::GroupWords`]), or memory for antialiasing; [`InputError::NoSuchItem`] for
    /// an id that names no group. [`InputError::OutOfDomain`] where the path leaves the domain of antialiased outlines. Then every group
    /// stays as it was.
    pub fn replace_path_group(
        &mut self,
        id: ItemId,
        group: Group,
        path: &dyn SubOutline,
        fill_rule: FillRule,
    ) -> Result<(), InputError> {
        let index = self.index_of_group(id)?;
        self.check_kept_rows(index)?;
        self.exchange_unrecorded(id, &PathGroup { group, path, fill_rule })?;
        self.draw_groups = Some(draw::<C, O, true>);
        self.record_group(index);
        Ok(())
    }

    /// Records all items of a group as changed.
    fn record_group(&mut self, index: usize) {
        for index in index..self.end_of(index) {
            if matches!(self.role_of(index), Role::Item | Role::Outline) {
                self.record_all(index);
            }
        }
    }

    /// Checks that there are rows for all groups that are blended, with one more before an item.
    fn check_rows(&self, group: Group, index: usize) -> Result<(), TooSmall> {
        if group.is_blended() {
            self.check_kept_rows(index)
        } else {
            Ok(())
        }
    }

    /// Checks that there are rows for all groups, with one more before an item that keeps a row.
    fn check_kept_rows(&self, index: usize) -> Result<(), TooSmall> {
        let kept = usize::from(self.keeps_row(index));
        let inside = (index + 1..self.end_of(index)).filter(|&inner| self.keeps_row(inner));
        let most = inside.map(|inner| self.kept_around(inner) + 1 - kept).max();
        // The groups in it count those around it, too.
        let rows = 1 + most.unwrap_or_else(|| self.kept_around(index));
        // No slice has as many words as this is where it does not fit.
        let needed = rows.saturating_mul(self.area.width() as usize);
        if needed <= self.group_rows.len() {
            Ok(())
        } else {
            Err(TooSmall::GroupWords(needed))
        }
    }

    /// The number of groups around an item of which a row is kept.
    fn kept_around(&self, index: usize) -> usize {
        let (mut ended, mut kept) = (0usize, 0);
        for before in (0..index).rev() {
            match self.role_of(before) {
                Role::GroupEnd => ended += 1,
                Role::GroupBegin if ended > 0 => ended -= 1,
                Role::GroupBegin => kept += usize::from(self.keeps_row(before)),
                Role::Item | Role::Outline => {}
            }
        }
        kept
    }

    /// Whether an item begins a group of which a row is kept.
    fn keeps_row(&self, index: usize) -> bool {
        let Some(slot) = self.slots.get(index) else {
            return false;
        };
        let has_path = slot.words > GROUP_WORDS;
        self.role_of(index) == Role::GroupBegin
            && (has_path || Group::read(self.pool.slice(slot.at, slot.words)).is_blended())
    }
}

/// Draws a band of a picture that has groups, with or without clip paths, row by row.
fn draw<C: ChannelColor, O: Order, const IN_PATHS: bool>(
    picture: &mut Picture<'_, '_, C, O>,
    band: &mut Band<'_, C, O>,
) {
    let Window { top, bottom, .. } = band.window();
    for y in top..bottom {
        let Some(mut row) = band.one_row(y) else { break };
        if !picture.go_to(&row.window()) {
            continue;
        }
        let area = picture.area;
        let (mut index, mut memory) = picture.active_items();
        // An end without a beginning ends nothing.
        while index != NONE {
            index = draw_items::<C, O, IN_PATHS>(&mut memory, index, &area, &mut row);
        }
    }
}

/// Draws the active items from one on to the end of the group that it is in, and returns the item behind that.
fn draw_items<C: ChannelColor, O: Order, const IN_PATHS: bool>(
    memory: &mut ItemMemory<'_, '_, '_, C, O>,
    mut index: u16,
    area: &Window,
    row: &mut Band<'_, C, O>,
) -> u16 {
    while let Some(slot) = memory.slots.get_mut(usize::from(index)) {
        let next = slot.next;
        let Some(kind) = slot.kind else { return NONE };
        index = match kind.role() {
            Role::GroupEnd => return next,
            Role::GroupBegin => draw_group::<C, O, IN_PATHS>(memory, index, next, area, row),
            Role::Item | Role::Outline => {
                // A bucket may have more rows than the item.
                if !slot.extent.rows(&row.window()).is_empty() {
                    kind.draw_row(slot, memory.pool, row);
                }
                next
            }
        };
    }
    NONE
}

/// Draws a group that an item begins, and whose first item comes next, and returns the item behind the group.
fn draw_group<C: ChannelColor, O: Order, const IN_PATHS: bool>(
    memory: &mut ItemMemory<'_, '_, '_, C, O>,
    begin: u16,
    first: u16,
    area: &Window,
    row: &mut Band<'_, C, O>,
) -> u16 {
    let Some(PictureSlot { at, words, cursor, .. }) = memory.slots.get(usize::from(begin)).copied() else {
        return NONE;
    };
    let group = Group::read(memory.pool.slice(at, words));
    let has_path = IN_PATHS && words > GROUP_WORDS;
    if !group.is_blended() && !has_path {
        let columns = group.columns_in(&row.window());
        return draw_items::<C, O, IN_PATHS>(memory, first, area, &mut row.cropped_row(columns));
    }
    // There is a row of the area for it.
    let columns = group.columns_in(&row.window().intersection(area));
    let mut row = row.cropped_row(columns);
    let width = row.words().len().min(memory.group_rows.len());
    let (kept, group_rows) = memory.group_rows.split_at_mut_checked(width).unwrap_or_default();
    for (kept, word) in kept.iter_mut().zip(row.words()) {
        *kept = *word;
    }
    let mut inner = ItemMemory {
        slots: &mut *memory.slots,
        pool: &mut *memory.pool,
        group_rows,
    };
    let next = draw_items::<C, O, IN_PATHS>(&mut inner, first, area, &mut row);
    if has_path {
        let cursor = blend_in_path((group, cursor), at, inner.pool, kept, &mut row);
        if let Some(slot) = inner.slots.get_mut(usize::from(begin)) {
            slot.cursor = cursor;
        }
    } else {
        blend_over(kept, &mut row, 0..width, group.opacity);
    }
    next
}

/// The clip path of a group that begins with these words.
fn path_in(words: &[u32]) -> StoredOutline<'_> {
    StoredOutline::new(words.get(usize::from(GROUP_WORDS)..).unwrap_or_default())
}

/// Blends a row of a group over the pixels that were kept, as far as its clip path covers them, and returns the cursor of the
/// next row.
fn blend_in_path<C: ChannelColor, O: Order>(
    (group, cursor): (Group, [u32; 2]),
    at: u16,
    pool: &mut Pool<'_>,
    kept: &[C::Word],
    row: &mut Band<'_, C, O>,
) -> [u32; 2] {
    let Window { left, right, top, .. } = row.window();
    let (words, memory) = pool.words_and_memory(at);
    let mut progress = Progress::of(cursor);
    // Pixels up to here are blended.
    let mut end = 0;
    let mut blend = |columns: Range<i32>, coverage: u8| {
        // Columns of the row, and no product exceeds 16 bits.
        let [from, to] = [columns.start, columns.end].map(|column| (column - left) as usize);
        let opacity = (u32::from(group.opacity) * u32::from(coverage) + 127) / 255;
        blend_over(kept, row, end..from, 0);
        blend_over(kept, row, from..to, opacity as u8);
        end = to;
        Ok::<(), Infallible>(())
    };
    let Ok(()) = progress.draw_row(path_in(words), memory, top, left..right, true, &mut blend);
    blend_over(kept, row, end..kept.len(), 0);
    progress.to_words()
}

/// Blends pixels of a row over those that were kept.
fn blend_over<C: ChannelColor, O: Order>(
    kept: &[C::Word],
    row: &mut Band<'_, C, O>,
    pixels: Range<usize>,
    opacity: u8,
) {
    let Window { left, top, .. } = row.window();
    // Columns of a row.
    let first = left + pixels.start as i32;
    let kept = kept.get(pixels.clone()).unwrap_or_default();
    let words = row.words_mut().get_mut(pixels).unwrap_or_default();
    match opacity {
        0 => words.iter_mut().zip(kept).for_each(|(word, below)| *word = *below),
        u8::MAX => {}
        _ => {
            // The words come first: behind the last one there may be no column.
            for ((word, below), x) in words.iter_mut().zip(kept).zip(first..) {
                if word != below {
                    let [above, below] = [*word, *below].map(|word| C::from_word(O::reorder(word)));
                    *word = O::reorder(above.over::<10>(below, opacity, Point::new(x, top)).to_word());
                }
            }
        }
    }
}
