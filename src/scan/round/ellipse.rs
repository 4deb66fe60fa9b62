//! The ellipse `h^2 dx^2 + w^2 dy^2 < w^2 h^2` in doubled coordinates, from the middle of its box.
//!
//! Guarantees: embedded-graphics' pixels wherever its 32-bit numbers suffice, and the exact inequality for every size that
//! a `Size` holds. Equal sides are a circle. embedded-graphics draws nothing at all where the first row of the box has
//! no pixel (2 x 8, 4 x 32): here the other rows are drawn.

use core::num::NonZero;

use embedded_graphics::geometry::Size;

use crate::scan::round::{ForwardDifference, circle};

/// Whether the walk fits `u32`: up to 1,625 x 1,625, and longer ones that are thinner.
pub fn is_narrow(size: Size) -> bool {
    let (width, height) = (u64::from(size.width.max(2)), u64::from(size.height.max(2)));
    // Costs stay below width * height^2, gains below height * width^2.
    size.width == size.height
        || (width < 1 << 16 && height < 1 << 16 && width * height * width.max(height) <= u64::from(u32::MAX))
}

macro_rules! entry {
    ($enter:ident, $first_row:ident, $number:ty, $product:ty) => {
        /// The ellipse in a row of the upper half of its box that has pixels.
        ///
        /// Cost: one division and one integer square root.
        pub(crate) fn $enter(size: Size, row: u32) -> ForwardDifference<$number> {
            // No product exceeds width^2 * height^2 or twice a square. Costs and gains are a quarter of what a column or a row
            // adds, so that the walk's numbers hold them (`is_narrow`).
            let (width, height) = (<$product>::from(size.width), <$product>::from(size.height));
            // A box with a row has a height.
            let height_2 = NonZero::new(height * height).unwrap_or(NonZero::<$product>::MIN);
            let dy = height - 1 - 2 * <$product>::from(row);
            let decision_variable = width * width * (height * height - dy * dy) - 1;
            let root = (decision_variable / height_2).isqrt() as u32;
            // Doubled distances have the parity of width - 1.
            let dx = root - ((root ^ (size.width - 1)) & 1);
            let slack = (decision_variable - height * height * <$product>::from(dx) * <$product>::from(dx)) / 4;
            let column_increment = height * height * (<$product>::from(dx) + 1);
            ForwardDifference {
                inset: (size.width - 1 - dx) / 2,
                error_term: (column_increment - slack) as $number,
                column_increment: column_increment as $number,
                column_increment_step: (2 * height * height) as $number,
                row_increment: (width * width * dy.saturating_sub(1)) as $number,
                row_increment_step: (2 * width * width) as $number,
            }
        }

        /// The first row of a box that is higher than wide, and of an even width.
        fn $first_row(size: Size) -> u32 {
            let (width, height) = (<$product>::from(size.width), <$product>::from(size.height));
            // An even width is at least 2.
            let width_2 = NonZero::new(width * width).unwrap_or(NonZero::<$product>::MIN);
            // The columns nearest to the middle of an even width have dx = 1: h^2 + w^2 dy^2 < w^2 h^2.
            let root = ((width * width - 1) * height * height - 1) / width_2;
            let root = root.isqrt() as u32;
            let dy = root - ((root ^ (size.height - 1)) & 1);
            (size.height - 1 - dy) / 2
        }
    };
}

entry!(enter_narrow_ellipse, first_row_narrow, u32, u64);
entry!(enter_wide, first_row_wide, u128, u128);

/// The ellipse in a row of the upper half of its box that has pixels, where [`is_narrow`] says that `u32` suffices.
pub(crate) fn enter_narrow(size: Size, row: u32) -> ForwardDifference<u32> {
    if size.width == size.height {
        circle::enter(size.width, row)
    } else {
        enter_narrow_ellipse(size, row)
    }
}

/// The first row of the box that has a pixel: 0, except in narrow and high boxes. A box without pixels has its height here.
pub fn first_row(size: Size) -> u32 {
    if size.width % 2 == 1 || size.width >= size.height {
        0
    } else if size.width == 0 {
        size.height
    } else if is_narrow(size) {
        first_row_narrow(size)
    } else {
        first_row_wide(size)
    }
}

#[cfg(test)]
mod tests;
