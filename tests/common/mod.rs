//! Shared by the tests of all stages: full-frame pictures of what is drawn, proptest with a fixed seed, the number of its cases.
#![allow(dead_code, reason = "each test program uses a part")]

mod cases;
pub mod channels;
pub mod hostile;
pub mod meshes;
pub mod numbers;
pub mod outlines;

use embedded_graphics::{
    pixelcolor::{Rgb565, RgbColor},
    prelude::*,
    primitives::Rectangle,
};
use zrow::{band::Band, draw::DrawOn};

pub use cases::*;

/// One of three numbers, such as how large a shape is or every how many-th case is tried: `quick` where [`is_quick`], `deep` where
/// [`is_deep`], and `default` otherwise.
pub fn by_depth(quick: usize, default: usize, deep: usize) -> usize {
    match (is_quick(), is_deep()) {
        (true, _) => quick,
        (_, true) => deep,
        _ => default,
    }
}

/// The pixels of `area` that a drawing turned from black to another colour, row by row.
pub fn painted(area: Rectangle, draw: impl FnOnce(&mut Band<'_, Rgb565>)) -> Vec<Point> {
    let mut words = vec![0u16; (area.size.width * area.size.height) as usize];
    let mut band = Band::new(area, &mut words).unwrap();
    draw(&mut band);
    let colors: Vec<Rgb565> = band.colors().collect();
    area.points()
        .zip(colors)
        .filter(|&(_, color)| color != Rgb565::BLACK)
        .map(|(point, _)| point)
        .collect()
}

/// What is painted in bands of different heights, the lower ones first, and whole: the same.
pub fn in_bands_and_whole(drawable: &impl DrawOn<Color = Rgb565>, window: Rectangle) -> Vec<Point> {
    let whole = painted(window, |band| {
        let Ok(()) = drawable.draw_on(band);
    });
    let mut rows: Vec<Point> = Vec::new();
    let mut top = window.top_left.y + window.size.height as i32;
    for height in [1, 2, 7, 3].into_iter().cycle() {
        if top == window.top_left.y {
            break;
        }
        let height = height.min(top - window.top_left.y);
        top -= height;
        let band = Rectangle::new(
            Point::new(window.top_left.x, top),
            Size::new(window.size.width, height as u32),
        );
        let mut part = painted(band, |band| {
            let Ok(()) = drawable.draw_on(band);
        });
        part.extend(rows);
        rows = part;
    }
    assert_eq!(rows, whole, "band after band");
    whole
}

/// `Rectangle::contains` for rectangles of any size: embedded-graphics' own overflows.
pub fn encloses(rectangle: &Rectangle, point: Point) -> bool {
    let inside = |at: i32, start: i32, size: u32| {
        let offset = i64::from(at) - i64::from(start);
        offset >= 0 && offset < i64::from(size)
    };
    inside(point.x, rectangle.top_left.x, rectangle.size.width)
        && inside(point.y, rectangle.top_left.y, rectangle.size.height)
}

/// The colours of all pixels of `area` after a drawing on black, row by row.
pub fn picture(area: Rectangle, draw: impl FnOnce(&mut Band<'_, Rgb565>)) -> Vec<Rgb565> {
    let mut words = vec![0u16; (area.size.width * area.size.height) as usize];
    let mut band = Band::new(area, &mut words).unwrap();
    draw(&mut band);
    band.colors().collect()
}
