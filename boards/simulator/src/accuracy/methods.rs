//! The methods of antialiasing: one entry each.

use embedded_graphics::{
    Drawable,
    geometry::{Point, Size},
    pixelcolor::{Gray8, GrayColor},
    primitives::{Primitive, Rectangle},
};
use zrow::{
    band::Band,
    draw::{FillRule, Polygon, PrimitiveStyle},
    geometry::{Sub8, SubPoint},
};
use zrow_shapes::{CIRCLE_CORNERS, Rule, SIZE, Shape};

/// A method that finds the share of each pixel.
pub struct Method {
    /// As in tables and as `measure` counts it.
    pub name: &'static str,
    /// Memory of a row of that many pixels, beside the row itself.
    pub bytes_per_row: fn(usize) -> usize,
    /// Adds the shares to a mask of zeros, 255 for a pixel that is covered wholly.
    pub cover: fn(&Input, &mut [u8]),
}

/// Every method.
pub const METHODS: &[Method] = &[Method {
    name: "centre_sample",
    bytes_per_row: |_| 0,
    cover: centre_sample,
}];

/// A shape as the library takes it.
pub struct Input {
    pub shape: Shape,
    contours: Vec<Vec<SubPoint<Sub8>>>,
    rule: FillRule,
}

impl Input {
    /// Takes over a shape in 1/256 pixel.
    pub fn new(shape: Shape) -> anyhow::Result<Self> {
        let contours = shape.contours.iter().map(|contour| {
            let corners = contour.iter().map(|&(x, y)| SubPoint::from_units(x, y));
            corners.collect::<Result<Vec<_>, _>>()
        });
        Ok(Self {
            contours: contours.collect::<Result<_, _>>()?,
            rule: match shape.rule {
                Rule::EvenOdd => FillRule::EvenOdd,
                Rule::NonZero => FillRule::NonZero,
            },
            shape,
        })
    }

    /// Calls with it as a polygon.
    fn polygon<R>(&self, call: impl FnOnce(Polygon<'_, SubPoint<Sub8>>) -> R) -> R {
        let mut contours: [&[SubPoint<Sub8>]; 2] = [&[]; 2];
        for (place, contour) in contours.iter_mut().zip(&self.contours) {
            *place = contour;
        }
        call(Polygon::new(&contours, self.rule))
    }
}

/// Edges of the largest shape, and those of them that cross a row.
const EDGES: usize = 2 * CIRCLE_CORNERS;
const ACTIVE: usize = 16;

/// The library's polygon, each pixel all or nothing.
fn centre_sample(input: &Input, mask: &mut [u8]) {
    let area = Rectangle::new(Point::zero(), Size::new_equal(SIZE as u32));
    let Ok(mut band) = Band::<Gray8>::new(area, mask) else {
        return;
    };
    input.polygon(|polygon| {
        if let Ok(polygon) = polygon.prepare::<EDGES, ACTIVE>() {
            let Ok(()) = polygon
                .into_styled(PrimitiveStyle::with_fill(Gray8::WHITE))
                .draw(&mut band);
        }
    });
}
