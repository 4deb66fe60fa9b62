//! Draws embedded-graphics' shapes, texts and images into a row at a constant depth.

use core::convert::Infallible;

use embedded_graphics::{Pixel, draw_target::DrawTarget, geometry::Dimensions, primitives::Rectangle};

use crate::{
    band::Band,
    geometry::Window,
    target::{BandColor, Order},
    view::DepthWidth,
    visible::DepthRow,
};

/// The pixels of a row as a draw target, behind what is nearer and in front of what is farther.
#[derive(Debug)]
pub struct AtDepth<'r, 'a, C: BandColor, O: Order, D: DepthWidth> {
    pub(super) row: &'r mut DepthRow<'a, C, O, D>,
    pub(super) depth: D,
}

impl<C: BandColor, O: Order, D: DepthWidth> Dimensions for AtDepth<'_, '_, C, O, D> {
    fn bounding_box(&self) -> Rectangle {
        let DepthRow { y, left, words, .. } = &*self.row;
        Window {
            left: *left,
            top: *y,
            // As many columns as a window has, so that this is its right side again.
            right: left.wrapping_add(words.len() as i32),
            bottom: y.saturating_add(1),
        }
        .to_rectangle()
    }
}

impl<C: BandColor, O: Order, D: DepthWidth> DrawTarget for AtDepth<'_, '_, C, O, D> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        let DepthRow {
            y, left, words, depths, ..
        } = &mut *self.row;
        for Pixel(point, color) in pixels {
            if point.y != *y || point.x < *left {
                continue;
            }
            let column = point.x.wrapping_sub(*left) as usize;
            if let (Some(word), Some(stored)) = (words.get_mut(column), depths.get_mut(column)) {
                if self.depth > *stored {
                    *stored = self.depth;
                    *word = Band::<C, O>::word(color);
                }
            }
        }
        Ok(())
    }
}

#[cfg(feature = "defmt")]
impl<C: BandColor, O: Order, D: DepthWidth> defmt::Format for AtDepth<'_, '_, C, O, D> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "AtDepth {}", self.row);
    }
}
