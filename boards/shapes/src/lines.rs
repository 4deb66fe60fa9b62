//! Lines whose ends are far off the screen.

use embedded_graphics::geometry::Point;
use zrow::{geometry::Window, scan::bresenham};

use crate::Random;

/// The screen.
pub const SCREEN: Window = Window {
    left: 0,
    top: 0,
    right: 320,
    bottom: 240,
};

/// Pixels that an end may be off the screen.
const MARGIN: i32 = 7000;

/// Lines between pixels, visible and with an end off the screen, without end.
pub fn cut_lines() -> impl Iterator<Item = (Point, Point)> {
    let mut random = Random::new(0x6C69_6E65);
    let mut point = move || {
        let x = random.number(SCREEN.left - MARGIN, SCREEN.right + MARGIN);
        Point::new(x, random.number(SCREEN.top - MARGIN, SCREEN.bottom + MARGIN))
    };
    let lines = core::iter::repeat_with(move || (point(), point()));
    let inside = |point: &Point| (0..SCREEN.right).contains(&point.x) && (0..SCREEN.bottom).contains(&point.y);
    lines.filter(move |(from, to)| bresenham::line(*from, *to, &SCREEN).is_some() && !(inside(from) && inside(to)))
}
