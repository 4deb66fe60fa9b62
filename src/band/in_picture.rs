//! A band as a target whose bounding box is that of the whole picture.

use core::convert::Infallible;

use embedded_graphics::{Pixel, draw_target::DrawTarget, geometry::Dimensions, primitives::Rectangle};

use crate::{
    band::Band,
    surface::{BandColor, Order},
};

/// Draws into a band; the bounding box is that of the picture.
struct InPicture<'b, 'a, C: BandColor, O: Order> {
    band: &'b mut Band<'a, C, O>,
    picture: Rectangle,
}

impl<'a, C: BandColor, O: Order> Band<'a, C, O> {
    /// This band as a target that reports the whole picture's box as its `bounding_box()`, for crates that lay out by the box of
    /// the target they draw on: kolibri, embedded-layout, and widgets that align to the screen. The band itself reports the
    /// few rows that it holds, which is what lets shapes skip it.
    ///
    /// Drawing on this target gives the pixels that drawing on the band gives, and what lies outside of the band is dropped. zrow's
    /// own shapes need it not: they are drawn on the band.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::*};
    /// use zrow::band::Band;
    ///
    /// /// A widget in the middle of the screen, as a layout crate places it.
    /// fn widget<D: DrawTarget<Color = Rgb565>>(target: &mut D) -> Result<(), D::Error> {
    ///     let center = target.bounding_box().center();
    ///     Pixel(center, Rgb565::RED).draw(target)
    /// }
    ///
    /// let picture = Rectangle::new(Point::zero(), Size::new(9, 5));
    /// let mut row = [0; 9];
    /// let mut band = Band::<Rgb565>::new(Rectangle::new(Point::new(0, 2), Size::new(9, 1)), &mut row)?;
    /// let Ok(()) = widget(&mut band.in_picture(picture));
    /// assert_eq!(row[4], Rgb565::RED.into_storage());
    /// # Ok::<(), zrow::geometry::TooSmall>(())
    /// ```
    pub fn in_picture(&mut self, picture: Rectangle) -> impl DrawTarget<Color = C, Error = Infallible> {
        InPicture { band: self, picture }
    }
}

impl<C: BandColor, O: Order> Dimensions for InPicture<'_, '_, C, O> {
    fn bounding_box(&self) -> Rectangle {
        self.picture
    }
}

impl<C: BandColor, O: Order> DrawTarget for InPicture<'_, '_, C, O> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.band.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible> {
        self.band.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        self.band.fill_solid(area, color)
    }

    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        self.band.clear(color)
    }
}
