//! The methods of antialiasing that are held against each other: one entry each, for the desktop and the chips.

use crate::{CIRCLE_CORNERS, Rule, SIZE, Shape};
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{Gray8, GrayColor},
    primitives::Rectangle,
};
use heapless::Vec;
use zrow::{
    band::Band,
    coverage::CoverageMethod,
    draw::{AntialiasedPolygon, DrawOn, FillRule, Polygon, PrimitiveStyle},
    geometry::{InputError, Sub8, SubPoint, TooSmall, Vertex, Window},
};

/// A method that finds the coverage of each pixel.
#[derive(Debug)]
pub struct Method {
    /// As in tables and in the reports of the chips.
    pub name: &'static str,
    /// Memory of a row of that many pixels, beside the row itself.
    pub bytes_per_row: fn(usize) -> usize,
    /// Adds the coverage to a mask of zeros, 255 for a pixel that is covered wholly.
    pub cover: fn(&Input, &mut [u8]),
}

macro_rules! methods {
    ($([$name:ident] [$($method:tt)+])+) => {
        &[
            Method {
                name: "scanline_fill",
                bytes_per_row: |_| 0,
                cover: scanline_fill,
            },
            $(method::<$($method)+>(stringify!($name))),+
        ]
    };
}

/// Every method.
pub const METHODS: &[Method] = coverage_methods!(methods);

/// A coverage method of the library.
const fn method<T: CoverageMethod + Default>(name: &'static str) -> Method {
    Method {
        name,
        bytes_per_row: |width| T::cells(width) * size_of::<T::Cell>(),
        cover: cover::<T>,
    }
}

/// A shape as the library takes it.
#[derive(Debug)]
pub struct Input {
    contours: Vec<Vec<SubPoint<Sub8>, CIRCLE_CORNERS>, 2>,
    rule: FillRule,
}

impl Input {
    /// Takes over a shape in 1/256 pixel.
    ///
    /// # Errors
    /// It lies outside the domain of the library.
    pub fn new(shape: &Shape) -> Result<Self, InputError> {
        let contours = shape.contours.iter().map(|contour| {
            let corners = contour.iter().map(|&(x, y)| SubPoint::from_units(x, y));
            corners.collect::<Result<_, _>>()
        });
        Ok(Self {
            contours: contours.collect::<Result<_, _>>()?,
            rule: match shape.rule {
                Rule::EvenOdd => FillRule::EvenOdd,
                Rule::NonZero => FillRule::NonZero,
            },
        })
    }

    /// Whether a small table holds them.
    fn has_few_edges(&self) -> bool {
        self.contours.iter().map(|contour| contour.len()).sum::<usize>() <= FEW
    }

    fn contours(&self) -> Vec<&[SubPoint<Sub8>], 2> {
        self.contours.iter().map(Vec::as_slice).collect()
    }
}

/// Edges of round shapes, and those of them that lie in the same row of pixels.
pub(crate) const ROUND: usize = 2 * CIRCLE_CORNERS;
pub(crate) const ROUND_ACTIVE: usize = 128;
/// Edges of shapes that are not round; all of them may lie in the same row.
pub(crate) const FEW: usize = 8;

const AREA: Window = Window {
    left: 0,
    top: 0,
    right: SIZE as i32,
    bottom: SIZE as i32,
};

/// The library's polygon without antialiasing: each pixel all or nothing.
fn scanline_fill(input: &Input, mask: &mut [u8]) {
    if input.has_few_edges() {
        fill::<_, FEW, FEW>(&input.contours(), input.rule, mask);
    } else {
        fill::<_, ROUND, ROUND_ACTIVE>(&input.contours(), input.rule, mask);
    }
}

pub(crate) fn fill<V: Vertex, const EDGES: usize, const ACTIVE: usize>(
    contours: &[&[V]],
    rule: FillRule,
    mask: &mut [u8],
) {
    let area = Rectangle::new(Point::zero(), Size::new_equal(SIZE as u32));
    let Ok(mut band) = Band::<Gray8>::new(area, mask) else {
        return;
    };
    // A table that is too small shows as an error of the whole shape.
    if let Ok(polygon) = Polygon::new(contours, rule).prepare::<EDGES, ACTIVE>() {
        let Ok(()) = polygon
            .into_styled(PrimitiveStyle::with_fill(Gray8::WHITE))
            .draw_on(&mut band);
    }
}

/// The coverage by a method.
fn cover<T: CoverageMethod + Default>(input: &Input, mask: &mut [u8]) {
    if input.has_few_edges() {
        cover_in::<T, FEW, FEW>(input, mask);
    } else {
        cover_in::<T, ROUND, ROUND_ACTIVE>(input, mask);
    }
}

fn cover_in<T: CoverageMethod + Default, const EDGES: usize, const ACTIVE: usize>(input: &Input, mask: &mut [u8]) {
    let mut row_memory = [T::Cell::default(); SIZE + 2];
    // A table that is too small shows as an error of the whole shape, here too.
    let Ok(polygon) = AntialiasedPolygon::<EDGES, ACTIVE>::prepare(input.contours().as_slice(), input.rule) else {
        return;
    };
    let _ = polygon.cover(&T::default(), &AREA, &mut row_memory, |span, coverage| {
        let row = mask.chunks_exact_mut(SIZE).nth(span.y as usize);
        if let Some(pixels) = row.and_then(|row| row.get_mut(span.start as usize..span.end as usize)) {
            pixels.fill(coverage);
        }
        Ok::<_, TooSmall>(())
    });
}
