//! A horizontal run of pixels: what every shape becomes.

use crate::geometry::Window;

/// Pixels `start <= x < end` of row `y`. Empty where `start >= end`.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::band::{Band, Span, Target};
///
/// // The bars of a level meter, the second of which is longer than the band is wide.
/// let mut words = [0; 6 * 2];
/// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(6, 2)), &mut words)?;
/// let raw = band.raw(Gray8::new(7));
/// for (y, level) in [4, 9].into_iter().enumerate() {
///     let Ok(()) = band.fill_span(Span::new(y as i32, 1, 1 + level), raw);
/// }
/// assert_eq!(words, [0, 7, 7, 7, 7, 0, 0, 7, 7, 7, 7, 7]);
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Span {
    /// Row.
    pub y: i32,
    /// First column.
    pub start: i32,
    /// The column after the last one.
    pub end: i32,
}

impl Span {
    /// A span of row `y`.
    pub const fn new(y: i32, start: i32, end: i32) -> Self {
        Self { y, start, end }
    }

    /// Whether the span contains no pixel.
    pub const fn is_empty(&self) -> bool {
        self.start >= self.end
    }

    /// The part of the span that is inside a window. An empty part begins and ends at the same column.
    #[must_use]
    pub fn clipped_to(&self, window: &Window) -> Self {
        let start = self.start.max(window.left);
        let is_visible = window.top <= self.y && self.y < window.bottom;
        Self {
            y: self.y,
            start,
            end: if is_visible {
                self.end.min(window.right).max(start)
            } else {
                start
            },
        }
    }

    /// The span as a window of one row.
    pub const fn to_window(&self) -> Window {
        Window {
            left: self.start,
            top: self.y,
            right: self.end,
            bottom: self.y.saturating_add(1),
        }
    }
}
