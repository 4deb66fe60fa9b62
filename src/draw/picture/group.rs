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
//! or none. Groups may lie in groups. What is not clipped and is opaque costs two items.
//!
//! Guarantees: the pixels are those of the items drawn into a picture of their own, whose pixels in the clip are blended
//! over those behind it. Cost of a row: for a group that is not opaque a copy of its pixels, and blending them.

use embedded_graphics::{geometry::Point, primitives::Rectangle};

use crate::{
    band::Band,
    draw::{
        payload::{Payload, Reader},
        picture::{
            item::{Extent, ItemId, NONE, PictureItem, Role, WHOLE},
            picture::{ItemMemory, Picture},
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::{InputError, Table, TooSmall, Window},
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

    /// The columns that a row shows of the group.
    fn columns_in(&self, row: &Window) -> core::ops::Range<i32> {
        let clipped = self.clip.intersection(row);
        if clipped.is_empty() || self.opacity == 0 {
            return row.left..row.left;
        }
        clipped.left..clipped.right
    }

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

/// The item before those of a group: its words are the [`Group`].
struct Begin;

/// The item behind those of a group.
struct End;

impl<'a, C: ChannelColor, O: Order> Prepare<'a, C, O> for Group {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        self.write(payload);
        Draft::new(Extent::of(&WHOLE), not_used::<C>(), &Begin)
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

    /// Begins a group: all items that are added from now on to [`end_group`](Self::end_group) are clipped and blended
    /// together. Takes a slot and 5 words of the pool.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the slots, the words of the pool, or the words for rows
    /// ([`with_group_rows`](Self::with_group_rows), [`Table::Words`]) that are needed.
    pub fn begin_group(&mut self, group: Group) -> Result<ItemId, InputError> {
        self.check_rows(group, self.slots_used())?;
        let id = self.add_unrecorded(&group)?;
        self.draw_groups = Some(draw::<C, O>);
        Ok(id)
    }

    /// Ends the group that was begun last. Takes a slot.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the slots that are needed.
    pub fn end_group(&mut self) -> Result<ItemId, InputError> {
        self.add_item_unrecorded(&End)
    }

    /// Clips and blends the items of a group in another way.
    ///
    /// # Errors
    /// As [`begin_group`](Self::begin_group); the group stays as it was. [`Table::Items`] for an id that names no group.
    pub fn replace_group(&mut self, id: ItemId, group: Group) -> Result<(), InputError> {
        let index = self.index_of_group(id)?;
        self.check_rows(group, index)?;
        self.rewrite(id, &group);
        let mut open = 1;
        for index in index + 1..self.slots_used() {
            match self.role_of(index) {
                Role::GroupBegin => open += 1,
                Role::GroupEnd => open -= 1,
                Role::Item | Role::Outline => self.record_all(index),
            }
            if open == 0 {
                break;
            }
        }
        Ok(())
    }

    /// Checks that there are rows for all groups that are blended, with one more before an item.
    fn check_rows(&self, group: Group, index: usize) -> Result<(), TooSmall> {
        if !group.is_blended() {
            return Ok(());
        }
        // Groups around it, and the most that lie in each other in it.
        let (mut around, mut inside, mut most_inside) = (0usize, 0usize, 0usize);
        for before in 0..index {
            match self.role_of(before) {
                Role::GroupBegin => around += 1,
                Role::GroupEnd => around = around.saturating_sub(1),
                Role::Item | Role::Outline => {}
            }
        }
        for behind in index + 1..self.slots_used() {
            match self.role_of(behind) {
                Role::GroupBegin => inside += 1,
                Role::GroupEnd if inside == 0 => break,
                Role::GroupEnd => inside -= 1,
                Role::Item | Role::Outline => {}
            }
            most_inside = most_inside.max(inside);
        }
        let needed = (around + 1 + most_inside) * self.area.width() as usize;
        if needed <= self.group_rows.len() {
            Ok(())
        } else {
            Err(TooSmall {
                table: Table::Words,
                needed,
            })
        }
    }
}

/// Draws a band of a picture that has groups, row by row.
fn draw<C: ChannelColor, O: Order>(picture: &mut Picture<'_, '_, C, O>, band: &mut Band<'_, C, O>) {
    let Window { top, bottom, .. } = band.window();
    for y in top..bottom {
        let Some(mut row) = band.one_row(y) else { break };
        if !picture.go_to(&row.window()) {
            break;
        }
        let area = picture.area;
        let (mut index, mut memory) = picture.active_items();
        // An end without a beginning ends nothing.
        while index != NONE {
            index = draw_items(&mut memory, index, &area, &mut row);
        }
    }
}

/// Draws the active items from one on to the end of the group that it is in, and returns the item behind that.
fn draw_items<C: ChannelColor, O: Order>(
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
            Role::GroupBegin => {
                let group = Group::read(memory.pool.slice(slot.at, slot.words));
                draw_group(memory, group, next, area, row)
            }
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

/// Draws a group whose first item has an index, and returns the item behind the group.
fn draw_group<C: ChannelColor, O: Order>(
    memory: &mut ItemMemory<'_, '_, '_, C, O>,
    group: Group,
    first: u16,
    area: &Window,
    row: &mut Band<'_, C, O>,
) -> u16 {
    if !group.is_blended() {
        let columns = group.columns_in(&row.window());
        return draw_items(memory, first, area, &mut row.cropped_row(columns));
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
    let next = draw_items(&mut inner, first, area, &mut row);
    let Window { left, top, .. } = row.window();
    for ((x, word), below) in (left..).zip(row.words_mut()).zip(&*kept) {
        if word != below {
            let [above, below] = [*word, *below].map(|word| C::from_word(O::reorder(word)));
            *word = O::reorder(above.over::<10>(below, group.opacity, Point::new(x, top)).to_word());
        }
    }
    next
}
