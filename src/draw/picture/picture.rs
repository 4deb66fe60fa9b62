//! The picture: items in painter's order, in buckets by their first row, and those that a row meets.

use core::{fmt, ops::Range};

use embedded_graphics::primitives::Rectangle;

use crate::{
    band::Band,
    draw::{
        AntialiasingMemory,
        payload::Payload,
        picture::{
            buckets::Buckets,
            damage::Damage,
            item::{Extent, ItemId, NONE, PictureItem, PictureSlot, Role},
            pool::{Pool, position_of},
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::{InputError, TooSmall, Window},
    surface::{BandColor, LittleEndian, Order},
};

/// No band begins in this row, which would be its last one as well.
pub(super) const NOWHERE: i32 = i32::MAX;

/// No item begins above this row.
pub(super) const NEVER_QUIET: i16 = i16::MIN;

/// Shapes, texts and items of the program's own, prepared once and drawn row by row in the order in which they were
/// added.
///
/// Its memory is lent: a slot an item, a pool of words (none for rectangles, discs, ellipses, thin lines and outlines of
/// circles one pixel wide, 9 for the inside of a triangle and 12 with a stroke, 10 for a wider line, 2 for a stroked rectangle, 4
/// for any other stroked circle or ellipse, 18 for a rounded rectangle, 11 for an arc or a sector, one a character and one more for a
/// plain text of one line, 18 and its bytes for any other one, some for each corner of a polygon), and buckets of rows. One bucket
/// for each row of the picture is fastest, fewer work as well. What is too small is an error that says how much is needed; a
/// picture has up to 65,535 items, whose words begin within the first 65,536.
///
/// Draws into bands of any height and in any order. Going on from row to row is the fast case; every other band is
/// found by looking at each item once. Rows and columns below -32,768 and from 32,767 on are not drawn.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::*};
/// use zrow::{
///     band::{DisplaySink, PictureLoop},
///     draw::{Picture, PictureSlot, PrimitiveStyle},
/// };
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let area = display.bounding_box();
/// let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 2], [0; 9], [0; 64]);
/// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut buckets);
///
/// let triangle = Triangle::new(Point::new(0, 40), Point::new(20, 0), Point::new(40, 40));
/// picture.add(&triangle.into_styled(PrimitiveStyle::with_fill(Rgb565::BLUE)))?;
/// let needle = Line::new(Point::new(20, 20), Point::new(20, 2));
/// let needle = picture.add(&needle.into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1)))?;
///
/// let mut row = [0; 64];
/// let picture_loop = PictureLoop::new(area, Rgb565::BLACK);
/// picture_loop.draw(&mut row, &mut DisplaySink(&mut display), |band| picture.draw(band))?;
/// assert_eq!(display.get_pixel(Point::new(20, 10)), Some(Rgb565::RED));
///
/// // Only what changes is prepared again.
/// let moved = Line::new(Point::new(20, 20), Point::new(2, 20));
/// picture.replace(needle, &moved.into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1)))?;
/// display.set_allow_overdraw(true);
/// picture_loop.draw(&mut row, &mut DisplaySink(&mut display), |band| picture.draw(band))?;
/// assert_eq!(display.get_pixel(Point::new(20, 10)), Some(Rgb565::BLUE));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct Picture<'m, 'a, C: BandColor, O: Order = LittleEndian> {
    pub(super) slots: &'m mut [PictureSlot<'a, C, O>],
    /// Slots that were given to items.
    pub(super) len: usize,
    pub(super) pool: Pool<'m>,
    pub(super) buckets: Buckets<'m>,
    pub(super) damage: Damage<'m>,
    /// Rows in which pixels behind groups are kept.
    pub(super) group_rows: &'m mut [C::Word],
    /// How bands are drawn as soon as there is a group: what does not begin one links no function for groups.
    pub(super) draw_groups: Option<DrawGroups<'m, 'a, C, O>>,
    pub(super) area: Window,
    /// The first item of the active list.
    pub(super) active: u16,
    /// The first row below one of the active items.
    pub(super) next_end: i32,
    /// From `next_row` on and above this row, no item begins or ends and all items have cursors: nothing is looked up there.
    /// [`NEVER_QUIET`] where that is not known. In 16 bits, so that it takes no memory beside `active`.
    pub(super) next_event: i16,
    /// The row at which all cursors are; [`NOWHERE`] where they are void.
    pub(super) next_row: i32,
    /// Where items have cursors, if they are met: bands outside begin anew.
    pub(super) cursors: Window,
    /// What is drawn next, probably: the damage that was taken last.
    pub(super) announced: Window,
}

/// What of a picture's memory items are drawn with.
pub(super) struct ItemMemory<'p, 'm, 'a, C: BandColor, O: Order> {
    pub(super) slots: &'p mut [PictureSlot<'a, C, O>],
    pub(super) pool: &'p mut Pool<'m>,
    /// Rows in which pixels behind groups are kept.
    pub(super) group_rows: &'p mut [C::Word],
}

/// A function that draws a band of a picture with groups.
type DrawGroups<'m, 'a, C, O> = fn(&mut Picture<'m, 'a, C, O>, &mut Band<'_, C, O>);

impl<C: BandColor, O: Order> fmt::Debug for Picture<'_, '_, C, O> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Picture")
            .field("slots_used", &self.slots_used())
            .field("words_used", &self.words_used())
            .finish_non_exhaustive()
    }
}

impl<'m, 'a, C: BandColor, O: Order> Picture<'m, 'a, C, O> {
    /// A picture without items. The area is where its bands are, mostly; the buckets are for the rows of the area.
    pub fn new(
        area: Rectangle,
        slots: &'m mut [PictureSlot<'a, C, O>],
        pool: &'m mut [u32],
        buckets: &'m mut [u16],
    ) -> Self {
        let area = Window::from(area);
        Self {
            slots,
            len: 0,
            pool: Pool::new(pool),
            buckets: Buckets::new(&area, buckets),
            area,
            damage: Damage::new(&mut [], (1, 1)),
            group_rows: &mut [],
            draw_groups: None,
            active: NONE,
            next_end: i32::MAX,
            next_event: NEVER_QUIET,
            next_row: NOWHERE,
            cursors: Window::EMPTY,
            announced: Window::EMPTY,
        }
    }

    /// Has the picture record what changes, as up to so many rectangles. The rows of an item are cut into half as many
    /// parts, up to 8, each of four rows or more and as narrow as the item is there: where a needle moves, 8 rectangles are good,
    /// and 16 better.
    /// Their sides are multiples of `grid`, columns and rows, for panels that take only such windows, and so may lie outside of the
    /// area: the buffer of a band has to hold such a row. 1 and 0 are any. [Pages](crate::band::PagesSink) of eight rows take `(1, 8)`.
    /// At first all of the area has changed.
    #[must_use]
    pub fn with_damage(mut self, areas: &'m mut [Window], grid: (u32, u32)) -> Self {
        self.damage = Damage::new(areas, grid);
        self.damage.add(self.area);
        self
    }

    /// Lends memory to antialiased items, which all of them share.
    #[must_use]
    pub fn with_antialiasing<const CELLS: usize, const SEGMENTS: usize, const EDGES: usize>(
        mut self,
        memory: &'m mut AntialiasingMemory<CELLS, SEGMENTS, EDGES>,
    ) -> Self {
        self.pool.set_memory(memory.lend());
        self
    }

    /// Takes one of the rectangles out that cover all pixels which have changed since the last one was taken. No two
    /// have a pixel in common. What is drawn there, and nowhere else, leaves the display as if all of the picture had
    /// been drawn:
    ///
    /// ```
    /// # use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::*};
    /// # use zrow::{band::{DisplaySink, PictureLoop}, draw::{Picture, PictureSlot, PrimitiveStyle}, geometry::Window};
    /// # let mut display = MockDisplay::<Rgb565>::new();
    /// # let (mut slots, mut areas, mut row) = ([PictureSlot::EMPTY; 2], [Window::EMPTY; 8], [0; 64]);
    /// # let mut picture = Picture::new(display.bounding_box(), &mut slots, &mut [], &mut []).with_damage(&mut areas, (1, 1));
    /// # picture.add(&Circle::new(Point::new(9, 9), 9).into_styled(PrimitiveStyle::with_fill(Rgb565::RED)))?;
    /// while let Some(area) = picture.next_damage() {
    ///     PictureLoop::new(area, Rgb565::BLACK)
    ///         .draw(&mut row, &mut DisplaySink(&mut display), |band| picture.draw(band))?;
    /// }
    /// # assert_eq!(display.get_pixel(Point::new(13, 13)), Some(Rgb565::RED));
    /// # assert_eq!(display.affected_area(), display.bounding_box());
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn next_damage(&mut self) -> Option<Rectangle> {
        self.announced = self.damage.pop()?;
        Some(self.announced.to_rectangle())
    }

    /// Forgets what has changed: for after the whole picture was drawn.
    pub const fn clear_damage(&mut self) {
        self.damage.clear();
    }

    /// Adds a copy of a shape or a text in front of all others: the shapes of embedded-graphics, a
    /// [`Polygon`](crate::draw::Polygon), a [`Path`](crate::draw::Path) or a [`ThinCircle`](crate::draw::ThinCircle) in either
    /// `PrimitiveStyle`, every stroke in a [`StrokeStyle`](crate::draw::StrokeStyle), `Text` in a monospaced font or in a font of
    /// coverage masks, and, where the picture has memory [`with_antialiasing`](Self::with_antialiasing), every shape and stroke in an
    /// [`Antialiased`](crate::draw::Antialiased) style and `Text` in a font of outlines. What else is drawn is a [`PictureItem`]
    /// instead. Cost: what its first row takes, and a copy.
    ///
    /// Of a line of text that begins 2^30 or more columns away from column 0, no glyph is drawn: only in a font of outlines with
    /// few units per em, at a size of thousands of pixels, could one be in the picture.
    ///
    /// Polygons and paths have the pixels of their prepared forms, fill and stroke, without tables: the fill takes 12 bytes of
    /// the pool, for each y-monotone chain of its edges 4 bytes and 4 for each corner (8 where one is more than 32,767 units
    /// from the first one's pixel), and 28 for each chain that one row has at most. A stroke takes up to 32 bytes, 4 for each
    /// contour and 8 for each vertex; one of one pixel's width also 16 for each segment that one row meets at most, a wider one,
    /// or any one of a polygon, 4 for each segment and each join, and 76 for each that one row meets at most, and inside or
    /// outside of a polygon what the fill takes; one in a `StrokeStyle` 52 bytes, 4 for each length of its dashes, 4 for each
    /// path and 8 for each vertex, 8 more with dashes; and, where no segment has more than 64 dashes and no vertex is beyond
    /// 16,384 pixels, 8 for each dash, segment and join, and for those that one row meets at most 76 each and 20 for each end or
    /// join that is round.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the slots, the words of the pool or the memory of antialiasing that are needed (an item whose
    /// words would begin behind the first 65,536, or are more than 65,535, finds no room in any pool), and
    /// [`InputError::OutOfDomain`] for an outline or the vertices of a stroke beyond their number range; the picture is as it was.
    pub fn add(&mut self, item: &impl Prepare<'a, C, O>) -> Result<ItemId, InputError> {
        let id = self.add_unrecorded(item)?;
        self.record(id, &self.rows_of(id));
        Ok(id)
    }

    /// Adds an item that has no pixels which change.
    pub(super) fn add_unrecorded(&mut self, item: &impl Prepare<'a, C, O>) -> Result<ItemId, InputError> {
        let id = self.next_id()?;
        let added = self.append(item)?;
        self.set(id, added);
        self.len += 1;
        Ok(id)
    }

    /// Adds an item by reference that has no pixels which change.
    pub(super) fn add_item_unrecorded<T: PictureItem<C, O>>(&mut self, item: &'a T) -> Result<ItemId, InputError> {
        let id = self.next_id()?;
        self.set(id, (0, 0, by_reference(item)));
        self.len += 1;
        Ok(id)
    }

    /// Adds an item of a kind of its own in front of all others, by reference: it takes no words of the pool.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the slots that are needed.
    pub fn add_item<T: PictureItem<C, O>>(&mut self, item: &'a T) -> Result<ItemId, InputError> {
        let id = self.add_item_unrecorded(item)?;
        self.record(id, &self.rows_of(id));
        Ok(id)
    }

    /// Puts a shape or a text in the place of an item, wherever in the painter's order that is. An item that begins or ends a group
    /// is [removed](Self::remove) by that.
    ///
    /// Where the pool has room for the words of both, they are compared: an outline that has some of the edges of the one
    /// before, such as an arc that grows, changes only the pixels between the other edges, and what is the same as before
    /// changes nothing. Else all pixels of both have changed, and the shape is prepared twice.
    ///
    /// # Errors
    /// The errors of [`add`](Self::add), and [`InputError::NoSuchItem`] for an id that names no item here. The item then stays.
    pub fn replace(&mut self, id: ItemId, item: &impl Prepare<'a, C, O>) -> Result<(), InputError> {
        self.check_id(id)?;
        if let Ok((at, words, draft)) = self.pool.append(|payload| item.prepare(payload)) {
            if let Err(error) = self.check(draft.segments) {
                self.pool.undo(words);
                return Err(error);
            }
            self.exchange(id, (at, words, draft));
            return Ok(());
        }
        let mut counted = Payload::counting(self.pool.memory().most_segments());
        let Draft { extent, segments, .. } = item.prepare(&mut counted);
        self.check(segments)?;
        self.change(id, counted.needed(), extent, |picture, at, words| {
            picture.pool.rewrite(at, words, |payload| item.prepare(payload))
        })?;
        Ok(())
    }

    /// Puts an item of a kind of its own in the place of another one, also of itself when it has moved.
    ///
    /// # Errors
    /// As [`replace`](Self::replace).
    pub fn replace_item<T: PictureItem<C, O>>(&mut self, id: ItemId, item: &'a T) -> Result<(), InputError> {
        self.check_id(id)?;
        let draft = by_reference(item);
        self.change(id, 0, draft.extent, |_, _, _| draft)?;
        Ok(())
    }

    /// Takes an item's pixels out of the picture and its words out of the pool. Its position in the painter's order stays:
    /// [`replace`](Self::replace) puts something there again.
    ///
    /// A group is dissolved where the item that [`begin_group`](Self::begin_group) added is taken out: with it goes the one that
    /// [`end_group`](Self::end_group) added, and its items stay, neither clipped nor blended by it any more. Without the end alone,
    /// the group goes on to the end of the group around it, which then goes on likewise, or to that of the picture; groups behind it then
    /// lie in it, and are drawn opaque where too few rows are lent ([`with_group_rows`](Self::with_group_rows)) for all of them. An id
    /// that names no item here does nothing.
    pub fn remove(&mut self, id: ItemId) {
        if self.check_id(id).is_ok() {
            // No error: it needs no words.
            let _ = self.change(id, 0, Extent::EMPTY, |_, _, _| Draft::nothing());
        }
    }

    /// Takes all items out. Ids of the items that were in it are void.
    pub fn clear(&mut self) {
        for id in (0..self.len as u16).map(ItemId) {
            self.record(id, &self.rows_of(id));
        }
        self.len = 0;
        self.draw_groups = None;
        self.pool.clear();
        self.next_row = NOWHERE;
    }

    /// How many slots are taken.
    pub const fn slots_used(&self) -> usize {
        self.len
    }

    /// How many words of the pool are taken.
    pub const fn words_used(&self) -> usize {
        self.pool.used()
    }

    /// The `SEGMENTS` that an [`AntialiasingMemory`] needs: the most segments that one row has of an antialiased item, of all for
    /// which [`add`](Self::add) was called so far, also of those that found no room. Where memory is short they are counted, so
    /// that this is exact with memory for 0 segments; otherwise it may be more than is needed.
    pub const fn segments_needed(&self) -> usize {
        self.pool.memory_ref().segments_needed()
    }

    /// The most chains of edges that went on from row to row at the same time, in all bands that were drawn so far: the `EDGES`
    /// that an [`AntialiasingMemory`] needs so that no outline is begun anew in each row.
    ///
    /// A program finds its capacities on the desktop: slots and words that are used, and segments and edges that are needed.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::{Circle, Rectangle}};
    /// use zrow::{band::Band, draw::{AntialiasingMemory, Picture, PictureSlot, PrimitiveStyle}};
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 100], [0; 1_000], [0; 64]);
    /// let ring = Circle::new(Point::new(7, 7), 50).into_styled(PrimitiveStyle::with_stroke(Gray8::WHITE, 9).antialiased());
    ///
    /// let mut none = AntialiasingMemory::<65, 0, 0>::new();
    /// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut none);
    /// assert!(picture.add(&ring).is_err());
    /// assert_eq!(picture.segments_needed(), 14);
    ///
    /// let mut memory = AntialiasingMemory::<65, 14, 100>::new();
    /// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
    /// picture.add(&ring)?;
    /// for y in 0..64 {
    ///     picture.draw(&mut Band::<Gray8>::new(Rectangle::new(Point::new(0, y), Size::new(64, 1)), &mut [0; 64])?);
    /// }
    /// assert_eq!((picture.slots_used(), picture.words_used(), picture.edges_needed()), (1, 26, 4));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub const fn edges_needed(&self) -> usize {
        self.pool.memory_ref().edges_needed()
    }

    /// What an item is, by its index.
    pub(super) fn role_of(&self, index: usize) -> Role {
        let kind = self.slots.get(index).and_then(|slot| slot.kind);
        kind.map_or(Role::Item, |kind| kind.role())
    }

    /// The index of an item that begins a group.
    pub(super) fn index_of_group(&self, id: ItemId) -> Result<usize, InputError> {
        self.check_id(id)?;
        let ItemId(index) = id;
        let index = usize::from(index);
        match self.role_of(index) {
            Role::GroupBegin => Ok(index),
            _ => Err(InputError::NoSuchItem),
        }
    }

    /// Makes an item another one where the pool has room for the words of both, and records nothing.
    pub(super) fn exchange_unrecorded(&mut self, id: ItemId, item: &impl Prepare<'a, C, O>) -> Result<(), InputError> {
        let appended = self.append(item)?;
        let ItemId(index) = id;
        if let Some(old) = self.slots.get(usize::from(index)).copied() {
            self.put_last(id, &old, appended);
        }
        Ok(())
    }

    /// Writes the words of an item behind those of all others.
    fn append(&mut self, item: &impl Prepare<'a, C, O>) -> Result<(u16, u16, Draft<'a, C, O>), InputError> {
        let appended = self.pool.append(|payload| item.prepare(payload));
        let (at, words, draft) = appended.map_err(too_few_words)?;
        match self.check(draft.segments) {
            Ok(()) => Ok((at, words, draft)),
            Err(error) => {
                self.pool.undo(words);
                Err(error)
            }
        }
    }

    /// Has the next band begin all items anew.
    pub(super) const fn begin_anew(&mut self) {
        self.next_row = NOWHERE;
    }

    /// Writes the words of an item again, or the first ones of them; its kind and its box stay.
    pub(super) fn rewrite(&mut self, id: ItemId, write: impl FnOnce(&mut Payload<'_>)) {
        let (at, words) = self.words_of(id);
        self.pool.rewrite(at, words, write);
        self.begin_anew();
    }

    /// Whether there is memory for an item that has so many segments in a row, if it needs any.
    fn check(&mut self, segments: Result<Option<usize>, InputError>) -> Result<(), InputError> {
        match segments? {
            None => Ok(()),
            Some(segments) => Ok(self.pool.memory().check(segments)?),
        }
    }

    /// Whether an id is that of an item.
    pub(super) fn check_id(&self, ItemId(index): ItemId) -> Result<(), InputError> {
        if usize::from(index) < self.len {
            Ok(())
        } else {
            Err(InputError::NoSuchItem)
        }
    }

    /// The id of the next item that is added.
    fn next_id(&self) -> Result<ItemId, TooSmall> {
        match u16::try_from(self.len) {
            Ok(index) if index != NONE && self.len < self.slots.len() => Ok(ItemId(index)),
            _ => Err(too_few_slots(self.len + 1)),
        }
    }

    /// Where an item's words begin, and how many they are.
    fn words_of(&self, ItemId(index): ItemId) -> (u16, u16) {
        self.slots
            .get(usize::from(index))
            .map_or((0, 0), |slot| (slot.at, slot.words))
    }

    /// Makes an item another one, which has so many words, and records both as changed.
    fn change(
        &mut self,
        id: ItemId,
        needed: usize,
        extent: Extent,
        draft: impl FnOnce(&mut Self, u16, u16) -> Draft<'a, C, O>,
    ) -> Result<(), TooSmall> {
        let rows = self.rows_with(id, extent);
        self.make_room(id, needed, &rows)?;
        let (at, words) = self.words_of(id);
        let draft = draft(self, at, words);
        self.take_end_out(id);
        self.set(id, (at, words, draft));
        let rows = if rows.contains(&i32::from(extent.first)) {
            rows
        } else {
            self.rows_of(id)
        };
        self.record(id, &rows);
        Ok(())
    }

    /// Takes the end of a group out whose beginning is about to go: it would end the group around that one. All that begins a group is
    /// recorded as changed in the whole picture.
    #[inline(never)]
    pub(super) fn take_end_out(&mut self, ItemId(begin): ItemId) {
        let begin = usize::from(begin);
        let mut open = 0u32;
        for index in begin..self.len {
            match self.role_of(index) {
                Role::GroupBegin => open += 1,
                Role::GroupEnd => open = open.saturating_sub(1),
                Role::Item | Role::Outline => {}
            }
            if open == 0 {
                // The item itself where it begins no group.
                if let Some(end) = self.slots.get_mut(index).filter(|_| index > begin) {
                    *end = PictureSlot::EMPTY;
                }
                return;
            }
        }
    }

    /// Takes the words of an item out of the pool, whose place others then have.
    pub(super) fn take_words(&mut self, at: u16, words: u16) {
        self.pool.remove(at, words);
        for slot in self.slots.iter_mut().take(self.len) {
            if slot.at > at {
                slot.at -= words;
            }
        }
    }

    /// Gives an item so many words, whatever it had before. What it had is void, and recorded as changed.
    #[inline(never)]
    fn make_room(&mut self, id: ItemId, needed: usize, rows: &Range<i32>) -> Result<(), TooSmall> {
        let ItemId(index) = id;
        let (at, words) = self.words_of(id);
        let had = usize::from(words);
        if needed == had {
            self.record(id, rows);
            return Ok(());
        }
        let used = self.pool.used() - had + needed;
        let Some((new_at, new_words)) = position_of(used - needed, needed) else {
            return Err(too_few_words(used));
        };
        if used > self.pool.len() {
            return Err(too_few_words(used));
        }
        self.record(id, rows);
        self.take_words(at, words);
        let appended = self.pool.append(|payload| (0..needed).for_each(|_| payload.push(0)));
        debug_assert!(appended.is_ok(), "there is room, as was just found");
        if let Some(slot) = self.slots.get_mut(usize::from(index)) {
            (slot.at, slot.words) = (new_at, new_words);
        }
        Ok(())
    }

    /// Puts an item into the slot of its id; the next band is entered anew.
    #[inline(never)]
    pub(super) fn set(&mut self, ItemId(index): ItemId, (at, words, draft): (u16, u16, Draft<'a, C, O>)) {
        self.next_row = NOWHERE;
        if let Some(slot) = self.slots.get_mut(usize::from(index)) {
            *slot = PictureSlot {
                extent: draft.extent,
                next: NONE,
                at,
                words,
                word: draft.word,
                cursor: [0; 2],
                kind: draft.kind,
            };
        }
    }
}

/// An item that the picture has by reference.
fn by_reference<'a, C: BandColor, O: Order, T: PictureItem<C, O>>(item: &'a T) -> Draft<'a, C, O> {
    Draft::new(Extent::of(&item.bounds()), not_used::<C>(), item)
}

const fn too_few_slots(needed: usize) -> TooSmall {
    TooSmall::Items(needed)
}

const fn too_few_words(needed: usize) -> TooSmall {
    TooSmall::PictureWords(needed)
}

#[cfg(feature = "defmt")]
impl<C: BandColor, O: Order> defmt::Format for Picture<'_, '_, C, O> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Picture of {} items and {} words",
            self.slots_used(),
            self.words_used()
        );
    }
}
