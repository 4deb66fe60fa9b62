//! Moving items of a picture, or all items of a group, by whole pixels: their words stay prepared.

use embedded_graphics::geometry::Point;

use crate::{
    draw::picture::{
        item::{Extent, ItemId, Role},
        picture::Picture,
    },
    geometry::InputError,
    surface::{BandColor, Order},
};

/// The smallest and the largest pixel coordinate of what can be moved: beyond them, pixels may have been cut off.
const DOMAIN: (i32, i32) = (i16::MIN as i32 + 1, i16::MAX as i32 - 2);

impl<C: BandColor, O: Order> Picture<'_, '_, C, O> {
    /// Moves an item by some columns and rows, or all items of a group, whose clip stays where it is: what scrolls in a
    /// window. Nothing is prepared anew. An item by reference is moved, too, until something is put in its place.
    ///
    /// Cost: some instructions an item, and for some kinds a few for each of its words.
    ///
    /// ```
    /// # use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, Rectangle}};
    /// # use zrow::{band::Band, draw::{Picture, PictureSlot, PrimitiveStyle}};
    /// # let area = Rectangle::new(Point::zero(), Size::new(8, 1));
    /// # let (mut slots, mut row) = ([PictureSlot::EMPTY; 1], [0; 8]);
    /// let mut picture = Picture::new(area, &mut slots, &mut [], &mut []);
    /// let dot = picture.add(&Circle::new(Point::zero(), 1).into_styled(PrimitiveStyle::with_fill(Rgb565::RED)))?;
    /// picture.translate(dot, Point::new(5, 0))?;
    /// picture.draw(&mut Band::<Rgb565>::new(area, &mut row)?);
    /// assert_eq!(row[5], Rgb565::RED.into_storage());
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where an item has or would have pixels that a picture cannot tell (16 bits), or that lie
    /// outside of the domain of antialiased outlines, and for strokes that may reach so far around vertices beyond 16,384 pixels;
    /// [`InputError::NoSuchItem`] for an id that names no item here. Then nothing is moved.
    pub fn translate(&mut self, id: ItemId, by: Point) -> Result<(), InputError> {
        self.check_id(id)?;
        let ItemId(first) = id;
        let items = usize::from(first)..self.end_of(first.into());
        for index in items.clone() {
            self.check_translated(index, by)?;
        }
        for index in items {
            self.translate_one(index, by);
        }
        Ok(())
    }

    /// The index behind an item, or behind the end of the group that it begins.
    pub(super) fn end_of(&self, first: usize) -> usize {
        let mut open = 0;
        for index in first..self.slots_used() {
            match self.role_of(index) {
                Role::GroupBegin => open += 1,
                Role::GroupEnd => open -= 1,
                Role::Item | Role::Outline => {}
            }
            if open <= 0 {
                return index + 1;
            }
        }
        self.slots_used()
    }

    fn check_translated(&self, index: usize, by: Point) -> Result<(), InputError> {
        let Some((slot, kind)) = self.slots.get(index).and_then(|slot| Some((slot, slot.kind?))) else {
            return Ok(());
        };
        let role = kind.role();
        if slot.extent.has_nothing() || matches!(role, Role::GroupBegin | Role::GroupEnd) {
            return Ok(());
        }
        let (min, max) = DOMAIN;
        let window = slot.extent.window();
        let moved = window.translated(by).ok_or(InputError::OutOfDomain { min, max })?;
        window.check_domain(DOMAIN)?;
        moved.check_domain(DOMAIN)?;
        kind.check_translated(&moved)
    }

    fn translate_one(&mut self, index: usize, by: Point) {
        // An item without pixels may be moved by any numbers: its position could leave the number range, and shows nowhere.
        let has_nothing = self.slots.get(index).is_none_or(|slot| slot.extent.has_nothing());
        if has_nothing || by == Point::zero() || matches!(self.role_of(index), Role::GroupBegin | Role::GroupEnd) {
            return;
        }
        self.record_all(index);
        if let Some((slot, kind)) = self
            .slots
            .get_mut(index)
            .and_then(|slot| slot.kind.map(|kind| (slot, kind)))
        {
            // It was checked that it can be moved.
            if let Some(moved) = slot.extent.window().translated(by) {
                slot.extent = Extent::of(&moved);
                kind.translate(slot, &mut self.pool, by);
            }
        }
        self.begin_anew();
        self.record_all(index);
    }
}
