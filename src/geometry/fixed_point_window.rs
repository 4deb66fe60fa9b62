//! A closed rectangle at sub-pixel precision: what sub-pixel segments are clipped to.

use crate::geometry::{InputError, SubPixel, SubPoint, Window};

/// A closed rectangle `left <= x <= right`, `top <= y <= bottom` at sub-pixel precision `S`.
///
/// All of it lies in the domain of `S`: whatever is cut to it does too. It holds no point where `left > right` or
/// `top > bottom`, and a single point where both are equal.
///
/// The trace of a chart, cut where its frame ends:
///
/// ```
/// use embedded_graphics::{prelude::*, primitives::Rectangle};
/// use zrow::{
///     clip::Segments,
///     geometry::{FixedPointWindow, Sub8, SubPoint, Window},
/// };
///
/// let frame = Window::from(Rectangle::new(Point::new(10, 10), Size::new(100, 40)));
/// let window = FixedPointWindow::<Sub8>::over_areas(&frame)?;
/// let at = |x, y| SubPoint::from_pixel(Point::new(x, y));
/// // The line leaves through the upper side, half a pixel above the centres of row 10.
/// let (start, end) = (at(20, 30)?, at(80, -30)?);
/// let part = Segments::liang_barsky(start, end, &window);
/// assert_eq!(part, Some((start, SubPoint::from_units(81 * 128, 19 * 128)?)));
/// assert_eq!(Segments::liang_barsky(at(20, 5)?, at(80, 9)?, &window), None);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct FixedPointWindow<S: SubPixel> {
    top_left: SubPoint<S>,
    bottom_right: SubPoint<S>,
}

impl<S: SubPixel> FixedPointWindow<S> {
    /// The window between two corners, both included.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a corner lies outside the domain of `S`, as a [`SubPoint`] whose fields were set directly
    /// can.
    pub fn new(top_left: SubPoint<S>, bottom_right: SubPoint<S>) -> Result<Self, InputError> {
        Ok(Self {
            top_left: SubPoint::from_units(top_left.x_units(), top_left.y_units())?,
            bottom_right: SubPoint::from_units(bottom_right.x_units(), bottom_right.y_units())?,
        })
    }

    /// The window from the centre of the first pixel to the centre of the last one.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a pixel lies outside the domain of `S`.
    pub fn between_centers(window: &Window) -> Result<Self, InputError> {
        Self::with_margin(window, 0)
    }

    /// The window over the whole area of its pixels: half a pixel more than their centres on each side.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a side lies outside the domain of `S`.
    pub fn over_areas(window: &Window) -> Result<Self, InputError> {
        Self::with_margin(window, 1 << (S::FRACTION_BITS - 1))
    }

    fn with_margin(window: &Window, margin: i32) -> Result<Self, InputError> {
        let side = |pixel: i32, before: i32, margin: i32| {
            pixel
                .checked_sub(before)?
                .checked_mul(1 << S::FRACTION_BITS)?
                .checked_add(margin)
        };
        let sides = (
            side(window.left, 0, -margin),
            side(window.top, 0, -margin),
            side(window.right, 1, margin),
            side(window.bottom, 1, margin),
        );
        let (Some(left), Some(top), Some(right), Some(bottom)) = sides else {
            return Err(InputError::out_of_domain::<S>());
        };
        Ok(Self {
            top_left: SubPoint::from_units(left, top)?,
            bottom_right: SubPoint::from_units(right, bottom)?,
        })
    }

    /// The corner with the smallest coordinates.
    pub const fn top_left(&self) -> SubPoint<S> {
        self.top_left
    }

    /// The corner with the largest coordinates.
    pub const fn bottom_right(&self) -> SubPoint<S> {
        self.bottom_right
    }

    /// Whether the window contains no point.
    pub fn is_empty(&self) -> bool {
        self.top_left.x > self.bottom_right.x || self.top_left.y > self.bottom_right.y
    }

    /// Whether the point is inside or on a side.
    pub fn contains(&self, point: &SubPoint<S>) -> bool {
        (self.top_left.x..=self.bottom_right.x).contains(&point.x)
            && (self.top_left.y..=self.bottom_right.y).contains(&point.y)
    }
}

#[cfg(feature = "defmt")]
impl<S: SubPixel> defmt::Format for FixedPointWindow<S> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "FixedPointWindow {} to {}", self.top_left, self.bottom_right);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Sub4, Sub8};
    use fixed::types::{I12F4, I24F8};

    const WINDOW: Window = Window {
        left: 0,
        top: -2,
        right: 8,
        bottom: 3,
    };

    #[test]
    fn centers_and_areas_differ_by_half_a_pixel() {
        let centers = FixedPointWindow::<Sub4>::between_centers(&WINDOW).unwrap();
        assert_eq!(centers.top_left(), SubPoint::from_units(0, -32).unwrap());
        assert_eq!(centers.bottom_right(), SubPoint::from_units(112, 32).unwrap());
        let areas = FixedPointWindow::<Sub8>::over_areas(&WINDOW).unwrap();
        assert_eq!(areas.top_left(), SubPoint::from_units(-128, -640).unwrap());
        assert_eq!(areas.bottom_right(), SubPoint::from_units(1920, 640).unwrap());
    }

    #[test]
    fn an_empty_pixel_window_has_no_points_between_its_centers() {
        let empty = FixedPointWindow::<Sub4>::between_centers(&Window::EMPTY).unwrap();
        assert!(empty.is_empty());
        assert!(!empty.contains(&SubPoint::from_units(0, 0).unwrap()));
    }

    #[test]
    fn no_window_reaches_out_of_the_domain() {
        let far = Window {
            left: i32::MIN,
            right: i32::MIN,
            ..WINDOW
        };
        assert!(FixedPointWindow::<Sub8>::between_centers(&far).is_err());
        let inside = SubPoint::<Sub4>::default();
        let outside = SubPoint::<Sub4> {
            x: I12F4::MAX,
            y: I12F4::ZERO,
        };
        assert!(FixedPointWindow::new(inside, outside).is_err());
        let outside = SubPoint::<Sub8> {
            x: I24F8::MIN,
            y: I24F8::ZERO,
        };
        assert!(FixedPointWindow::new(outside, SubPoint::default()).is_err());
    }
}
