//! Circles against a window: outcodes of the box, then the pixels of the window that are nearest to the centre and
//! farthest from it.
//!
//! Guarantees: exact for the pixels of every filled embedded-graphics circle, with any position and any diameter; a circle
//! whose box meets a corner of the window while its pixels do not is not visible.
//!
//! Cost: eight comparisons where the box decides, and four squares where it does not. Take it before drawing circles of
//! which many are off the screen, or larger than it.

use embedded_graphics::{
    geometry::Size,
    primitives::{Circle, Rectangle},
};

use crate::{
    clip::{Classification, Outcode, shape::rectangle_against_window::corners},
    geometry::Window,
};

impl Classification {
    /// How much of a filled circle the window shows: exact for its pixels.
    ///
    /// Cost: eight comparisons where the box decides, and four squares where it does not.
    ///
    /// ```
    /// use embedded_graphics::{prelude::*, primitives::Circle};
    /// use zrow::{clip::Classification, geometry::Window};
    ///
    /// let panel = Window { left: 0, top: 0, right: 128, bottom: 64 };
    /// let at = |x, y| Circle::with_center(Point::new(x, y), 41);
    /// assert_eq!(Classification::circle_against_window(&at(60, 30), &panel), Classification::Whole);
    /// assert_eq!(Classification::circle_against_window(&at(-10, 30), &panel), Classification::Part);
    /// // Only the box meets the panel.
    /// assert_eq!(Classification::circle_against_window(&at(-15, -15), &panel), Classification::Nothing);
    /// ```
    pub fn circle_against_window(circle: &Circle, window: &Window) -> Classification {
        let bounds = Rectangle::new(circle.top_left, Size::new_equal(circle.diameter));
        let Some((first, last)) = corners(&bounds).filter(|_| !window.is_empty()) else {
            return Classification::Nothing;
        };
        let (first_code, last_code) = (Outcode::of(first, window), Outcode::of(last, window));
        if !first_code.shared(last_code).is_inside() {
            return Classification::Nothing;
        }
        if first_code.either(last_code).is_inside() {
            return Classification::Whole;
        }
        let x = Distances::of(circle.top_left.x, circle.diameter, (window.left, window.right));
        let y = Distances::of(circle.top_left.y, circle.diameter, (window.top, window.bottom));
        if !is_in_circle(circle.diameter, x.nearest, y.nearest) {
            Classification::Nothing
        } else if is_in_circle(circle.diameter, x.farthest, y.farthest) {
            Classification::Fills
        } else {
            Classification::Part
        }
    }
}

/// Whether a pixel belongs to a circle whose centre is `dx / 2` columns and `dy / 2` rows away. (The centre of a circle with an
/// even diameter lies between pixels, so that doubled distances are whole numbers.)
fn is_in_circle(diameter: u32, dx: u64, dy: u64) -> bool {
    let square = |distance: u64| distance.checked_mul(distance);
    let sum = square(dx).zip(square(dy)).and_then(|(x, y)| x.checked_add(y));
    sum.is_some_and(|sum| sum < circle_limit(diameter))
}

/// A pixel belongs to a circle where the square of its doubled distance is less than this: embedded-graphics' rule.
pub(crate) fn circle_limit(diameter: u32) -> u64 {
    let correction = if diameter <= 4 { diameter / 2 } else { 0 };
    u64::from(diameter) * u64::from(diameter) - u64::from(correction)
}

/// The distances of a window's columns from a circle's centre, or those of its rows; doubled, since the centre may lie between
/// pixels.
struct Distances {
    /// Twice the distance of the nearest column or row; 0 where the centre lies between the first and the last one.
    nearest: u64,
    /// Twice the distance of the farthest column or row.
    farthest: u64,
}

impl Distances {
    /// The distances along one axis. `start` is the first column or row of the circle's box; `first` is that of the window, and
    /// `end` the one after its last.
    fn of(start: i32, diameter: u32, (first, end): (i32, i32)) -> Self {
        // All numbers here stay below 2^35.
        let center = 2 * i64::from(start) + i64::from(diameter) - 1;
        let from_first = 2 * i64::from(first) - center;
        let to_last = 2 * (i64::from(end) - 1) - center;
        Self {
            // 0 where the window reaches to both sides of the centre, even where the centre lies between two columns and the
            // nearest one is at distance 1. That makes no difference: beside its centre a circle has a pixel in every row of
            // its box, and the box meets the window. So it is for rows and columns exchanged.
            nearest: from_first.max(-to_last).max(0).unsigned_abs(),
            farthest: from_first.unsigned_abs().max(to_last.unsigned_abs()),
        }
    }
}
