//! Images by reference: each row copies the image's row of pixels, decoded from its bytes.
//!
//! The words are the column and the row of the image's first pixel. Guarantees: the pixels of embedded-graphics' `Image`
//! at that position. Cost of a row: some instructions for each of its visible pixels, whatever lies beside them.

use core::hash::Hash;

use embedded_graphics::{
    geometry::{Dimensions, OriginDimensions, Point},
    image::{GetPixel, ImageRaw},
    iterator::raw::RawDataSlice,
    pixelcolor::raw::ByteOrder,
};

use crate::{
    band::Band,
    draw::{
        eg::image_bytes::{bytes_per_row, with_bytes},
        payload::Payload,
        picture::{
            item::{Extent, ItemId, PictureItem, PictureSlot, each_row, span_of},
            kinds::replayed::translate_point,
            picture::Picture,
            pool::Pool,
            prepare::{Draft, Prepare, not_used},
        },
    },
    geometry::{InputError, Window},
    surface::{BandColor, Order, Target},
};

impl<'a, C, O> Picture<'_, 'a, C, O>
where
    C: BandColor + From<C::Raw> + Hash,
    O: Order,
{
    /// Adds an image in front of all other items, by reference, with its first pixel at a point. Takes 2 words of the pool.
    ///
    /// ```
    /// use embedded_graphics::{image::ImageRaw, pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::{band::Band, draw::{Picture, PictureSlot}};
    ///
    /// let image = ImageRaw::<Rgb565>::new(&[0xF8, 0x00, 0x07, 0xE0], 2);
    /// let area = Rectangle::new(Point::zero(), Size::new(4, 1));
    /// let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 2]);
    /// let mut picture = Picture::new(area, &mut slots, &mut pool, &mut []);
    /// picture.add_image(&image, Point::new(1, 0))?;
    ///
    /// let mut row = [0; 4];
    /// picture.draw(&mut Band::<Rgb565>::new(area, &mut row)?);
    /// assert_eq!(row, [0x0000, 0xF800, 0x07E0, 0x0000]);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// As [`add`](Picture::add).
    pub fn add_image<BO>(&mut self, image: &'a ImageRaw<'a, C, BO>, top_left: Point) -> Result<ItemId, InputError>
    where
        BO: ByteOrder + Hash,
        for<'b> RawDataSlice<'b, C::Raw, BO>: IntoIterator<Item = C::Raw>,
    {
        self.add(&PlacedImage { image, top_left })
    }

    /// Puts an image in the place of an item, as [`add_image`](Picture::add_image) adds it.
    ///
    /// # Errors
    /// As [`replace`](Picture::replace).
    pub fn replace_image<BO>(
        &mut self,
        id: ItemId,
        image: &'a ImageRaw<'a, C, BO>,
        top_left: Point,
    ) -> Result<(), InputError>
    where
        BO: ByteOrder + Hash,
        for<'b> RawDataSlice<'b, C::Raw, BO>: IntoIterator<Item = C::Raw>,
    {
        self.replace(id, &PlacedImage { image, top_left })
    }
}

/// An image whose first pixel is at a point.
struct PlacedImage<'a, C, BO>
where
    C: BandColor + From<C::Raw>,
    BO: ByteOrder,
{
    image: &'a ImageRaw<'a, C, BO>,
    top_left: Point,
}

impl<'a, C, BO, O> Prepare<'a, C, O> for PlacedImage<'a, C, BO>
where
    C: BandColor + From<C::Raw> + Hash,
    BO: ByteOrder + Hash,
    O: Order,
    for<'b> RawDataSlice<'b, C::Raw, BO>: IntoIterator<Item = C::Raw>,
{
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        let mut area = self.image.bounding_box();
        area.top_left = self.top_left;
        payload.push_signed(self.top_left.x);
        payload.push_signed(self.top_left.y);
        Draft::new(Extent::of(&area.into()), not_used::<C>(), self.image)
    }
}

/// An image draws itself from its slot; alone it has nothing to draw.
impl<C, BO, O> PictureItem<C, O> for ImageRaw<'_, C, BO>
where
    C: BandColor + From<C::Raw> + Hash,
    BO: ByteOrder + Hash,
    O: Order,
    for<'b> RawDataSlice<'b, C::Raw, BO>: IntoIterator<Item = C::Raw>,
{
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        translate_point(pool.slice_mut(slot.at, slot.words), by);
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let Some([left, top]) = pool.array::<2>(slot.at) else {
            return;
        };
        let window = band.window();
        let (first, end) = slot.extent.columns();
        let columns = (first.max(window.left), end.min(window.right));
        // The first visible pixel, counted from the image's first one.
        let (x, y) = (columns.0.abs_diff(*left as i32), window.top.abs_diff(*top as i32));
        let Some(words) = span_of(band, columns) else { return };
        let stride = bytes_per_row::<C>(self.size().width);
        let is_drawn = with_bytes(self, |bytes| {
            let row = bytes.get(y as usize * stride..).unwrap_or_default();
            let mut pixels = RawDataSlice::<C::Raw, BO>::new(row).into_iter();
            if let Some(before) = x.checked_sub(1) {
                pixels.nth(before as usize);
            }
            set_pixels::<C, O>(words, pixels.map(C::from));
        });
        if is_drawn.is_none() {
            // Bytes behind the last row hide all others. An image has fewer than 2^31 columns and rows.
            let pixels = (x..).map_while(|x| self.pixel(Point::new(x as i32, y as i32)));
            set_pixels::<C, O>(words, pixels);
        }
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        each_row(slot, band, |slot, row| self.draw_row(slot, pool, row));
    }
}

/// Sets the pixels of a row to these colours.
#[inline]
fn set_pixels<C: BandColor, O: Order>(words: &mut [C::Word], colors: impl Iterator<Item = C>) {
    for (word, color) in words.iter_mut().zip(colors) {
        *word = Band::<C, O>::word(color);
    }
}
