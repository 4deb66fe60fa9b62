//! An area in which antialiased shapes are drawn, in bands of any height, and compared with the ideal ones.

use embedded_graphics::{
    pixelcolor::{Gray8, GrayColor},
    prelude::*,
    primitives::{PrimitiveStyleBuilder, Rectangle, StrokeAlignment},
};
use zrow::{
    band::Band,
    draw::{DrawAntialiased, LineCap, PrimitiveStyle},
};

use crate::reference::ideal_coverage::ideal;

/// Random numbers from a fixed seed (xorshift32, Marsaglia 2003).
pub struct Xorshift(u32);

impl Xorshift {
    pub fn new(seed: u32) -> Self {
        Self(seed)
    }

    /// A number from the first one to the last one.
    pub fn between(&mut self, first: i32, last: i32) -> i32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        first + (self.0 % (last - first + 1) as u32) as i32
    }
}

pub const SIDE: u32 = 48;
pub const AREA: Rectangle = Rectangle::new(Point::new(-3, -2), Size::new(SIDE, SIDE));
pub const ALIGNMENTS: [StrokeAlignment; 3] = [
    StrokeAlignment::Inside,
    StrokeAlignment::Center,
    StrokeAlignment::Outside,
];
pub const CAPS: [LineCap; 4] = [LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round];

/// Edges of every outline of these tests, and those in one row.
pub const EDGES: usize = 4_096;
pub const ACTIVE: usize = 512;

/// The coverage of each pixel of the area by what is drawn in white on black.
pub fn coverage(shape: &impl DrawAntialiased<Color = Gray8>) -> Vec<u8> {
    in_bands(shape, SIDE)
}

/// The coverage of each pixel of the area, drawn in bands of so many rows.
pub fn in_bands(shape: &impl DrawAntialiased<Color = Gray8>, rows: u32) -> Vec<u8> {
    let mut row = [0; SIDE as usize + 1];
    let mut picture = Vec::new();
    for top in (0..SIDE).step_by(rows as usize) {
        let mut words = vec![0; (SIDE * rows) as usize];
        let area = Rectangle::new(AREA.top_left + Point::new(0, top as i32), Size::new(SIDE, rows));
        let mut band = Band::<Gray8>::new(area, &mut words).unwrap();
        shape.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut row)).unwrap();
        assert_eq!(row, [0; SIDE as usize + 1]);
        picture.extend(words);
    }
    picture.truncate((SIDE * SIDE) as usize);
    picture
}

/// Chords are up to 1/64 pixel inside of a curve, 5.7/255 along the diagonal of a pixel; corners are rounded to 1/256 pixel,
/// 1.5/255; the ideal is sampled, up to 4/255 along a row.
const BOUND: f64 = 12.0;

/// Compares a drawn shape with an ideal one: every pixel within the bound, and all edge pixels together within a quarter of
/// it.
pub fn compare(name: &str, shape: &impl DrawAntialiased<Color = Gray8>, is_inside: impl Fn(f64, f64) -> bool) {
    let drawn = coverage(shape);
    assert_eq!(drawn, in_bands(shape, 1), "{name} in bands");
    let (mut sum, mut edges) = (0.0, 0);
    for (pixel, (&drawn, ideal)) in AREA.points().zip(drawn.iter().zip(ideal(&AREA, is_inside))) {
        let error = f64::from(drawn) - 255.0 * ideal;
        assert!(
            error.abs() <= BOUND,
            "{name}, {pixel:?}: {drawn}, not {}",
            255.0 * ideal
        );
        if 0.0 < ideal && ideal < 1.0 {
            (sum, edges) = (sum + error, edges + 1);
        }
    }
    let mean = sum / f64::from(edges.max(40));
    assert!(
        mean.abs() <= BOUND / 4.0,
        "{name}: {mean} in the mean over {edges} pixels"
    );
}

pub fn fill() -> PrimitiveStyle<Gray8> {
    PrimitiveStyle::with_fill(Gray8::WHITE)
}

pub fn stroke(width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Gray8> {
    PrimitiveStyleBuilder::new()
        .stroke_color(Gray8::WHITE)
        .stroke_width(width)
        .stroke_alignment(alignment)
        .build()
        .into()
}

/// A fill in a colour, in a white stroke.
pub fn filled(color: Gray8, width: u32, alignment: StrokeAlignment) -> PrimitiveStyle<Gray8> {
    let mut style = stroke(width, alignment);
    style.fill_color = Some(color);
    style
}

/// The widths of a stroke inside and outside of a shape of whole pixels.
pub fn widths(style: &PrimitiveStyle<Gray8>) -> (f64, f64) {
    (style.inside_stroke_width().into(), style.outside_stroke_width().into())
}
