//! Lines between pixels whose ends are on the screen or far off it, and the siblings that walk them.

use core::hint::black_box;

use embedded_graphics::geometry::Point;
use zrow::{geometry::Window, scan::Lines};

use crate::Random;

/// From the first pixel to the last one.
pub type Line = (Point, Point);

/// The screen of the lines that are clipped.
pub const SCREEN: Window = Window {
    left: 0,
    top: 0,
    right: 320,
    bottom: 240,
};
/// The screen of the lines that are walked.
pub const UPRIGHT_SCREEN: Window = Window {
    left: 0,
    top: 0,
    right: 240,
    bottom: 320,
};

/// Pixels that an end may be off the screen.
const MARGIN: i32 = 7000;

/// Lines between pixels, visible and with an end off the screen, without end.
pub fn cut_lines() -> impl Iterator<Item = Line> {
    let mut random = Random::new(0x6C69_6E65);
    let mut point = move || {
        let x = random.number(SCREEN.left - MARGIN, SCREEN.right + MARGIN);
        Point::new(x, random.number(SCREEN.top - MARGIN, SCREEN.bottom + MARGIN))
    };
    let lines = core::iter::repeat_with(move || (point(), point()));
    let inside = |point: &Point| (0..SCREEN.right).contains(&point.x) && (0..SCREEN.bottom).contains(&point.y);
    lines.filter(move |(from, to)| {
        Lines::bresenham(*from, *to, &SCREEN).next().is_some() && !(inside(from) && inside(to))
    })
}

/// How far off the screen the ends of walked lines are.
#[derive(Debug, Clone, Copy)]
pub struct LineGroup {
    /// The name of this entry in the report's tables.
    pub name: &'static str,
    /// The name under which the firmware on the emulated chips reports the counts of this entry.
    pub count: &'static str,
    margin: i32,
}

/// Every group of walked lines.
pub const LINE_GROUPS: &[LineGroup] = &[
    LineGroup {
        name: "on screen",
        count: "lines.on_screen",
        margin: 0,
    },
    LineGroup {
        name: "ends up to 3,000 px off",
        count: "lines.near",
        margin: 3000,
    },
    LineGroup {
        name: "ends up to 1,000,000 px off",
        count: "lines.far",
        margin: 1_000_000,
    },
];

impl LineGroup {
    /// Its visible lines, without end.
    pub fn lines(&self) -> impl Iterator<Item = Line> {
        let margin = self.margin;
        let screen = UPRIGHT_SCREEN;
        let mut random = Random::new(0x6C69_6E65_7300 ^ margin as u64);
        let mut point = move || {
            let x = random.number(screen.left - margin, screen.right + margin);
            Point::new(x, random.number(screen.top - margin, screen.bottom + margin))
        };
        let line = move || {
            let (from, end) = (point(), point());
            let on_screen = Point::new(end.x.rem_euclid(screen.right), end.y.rem_euclid(screen.bottom));
            // Far ends seldom make visible lines: these pass by a pixel of the screen within 25 others.
            let by_screen = on_screen * 2 - from + Point::new(end.x % 50, end.y % 50);
            (from, if margin > 10_000 { by_screen } else { end })
        };
        core::iter::repeat_with(line).filter(move |(from, to)| Lines::bresenham(*from, *to, &screen).next().is_some())
    }
}

/// A way to walk a line.
#[derive(Debug, Clone, Copy)]
pub struct LineSibling {
    /// Its module in `zrow`.
    pub name: &'static str,
    /// Hands every pixel over, to see which they are.
    pub pixels: fn(&Line, &mut dyn FnMut(Point)),
    /// Does it for nothing, to see what it costs.
    pub walk: fn(&Line),
}

macro_rules! siblings {
    ($([$name:ident] [$($line:tt)+])+) => {
        &[$(LineSibling {
            name: stringify!($name),
            pixels: |(from, to), take| $($line)+(*from, *to, &UPRIGHT_SCREEN).for_each(take),
            walk: |(from, to)| {
                for point in $($line)+(*from, *to, &UPRIGHT_SCREEN) {
                    black_box(point);
                }
            },
        }),+]
    };
}

/// Every way to walk a line; the first one is exact.
pub const LINE_SIBLINGS: &[LineSibling] = lines!(siblings);
