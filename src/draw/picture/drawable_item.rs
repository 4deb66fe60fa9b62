//! What only embedded-graphics' `Drawable` can draw, as an item of a picture.

use embedded_graphics::{Drawable, geometry::Dimensions};

use crate::{
    band::Band,
    draw::picture::item::PictureItem,
    geometry::Window,
    surface::{BandColor, Order},
};

/// An embedded-graphics `Drawable` as an item for [`Picture::add_item`](crate::draw::Picture::add_item): images in file
/// formats, texts in fonts of other crates, widgets.
///
/// It is drawn anew in each band that meets its bounding box, and skipped in all others: the cost in a band is that of
/// `Drawable::draw`. Shapes, texts and images for which [`Picture`](crate::draw::Picture) has a method of its own are
/// faster by that.
///
/// ```
/// use embedded_graphics::{
///     image::{Image, ImageDrawableExt, ImageRaw}, pixelcolor::Gray8, prelude::*, primitives::Rectangle,
/// };
/// use zrow::{band::Band, draw::{DrawableItem, Picture, PictureSlot}};
///
/// let raw = ImageRaw::<Gray8>::new(&[1, 2, 3, 4, 5, 6], 3);
/// let part = raw.sub_image(&Rectangle::new(Point::new(1, 0), Size::new(2, 2)));
/// let item = DrawableItem(Image::new(&part, Point::new(0, 0)));
///
/// let area = Rectangle::new(Point::zero(), Size::new(3, 2));
/// let mut slots = [PictureSlot::EMPTY; 1];
/// let mut picture = Picture::new(area, &mut slots, &mut [], &mut []);
/// picture.add_item(&item)?;
///
/// let mut words = [0; 6];
/// picture.draw(&mut Band::<Gray8>::new(area, &mut words)?);
/// assert_eq!(words, [2, 3, 0, 5, 6, 0]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DrawableItem<D>(pub D);

impl<C: BandColor, O: Order, D: Drawable<Color = C> + Dimensions> PictureItem<C, O> for DrawableItem<D> {
    fn bounds(&self) -> Window {
        self.0.bounding_box().into()
    }

    fn draw(&self, band: &mut Band<'_, C, O>) {
        band.draw(&self.0);
    }
}
