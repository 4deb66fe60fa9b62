//! Corners in fewer or more bits: the library's fill of the same shapes, rounded to each.

use embedded_graphics::geometry::Point;
use heapless::Vec;
use zrow::{
    draw::FillRule,
    geometry::{InputError, Sub4, Sub8, SubPoint, Vertex},
};

use crate::{
    CIRCLE_CORNERS, Rule, Shape,
    methods::{FEW, ROUND, ROUND_ACTIVE, fill},
};

/// A precision of corners.
#[derive(Debug, Clone, Copy)]
pub struct Precision {
    /// The name of this entry in the report's tables.
    pub name: &'static str,
    /// The name of this entry in what the firmware on the emulated chips reports.
    pub variant: &'static str,
    /// So many are a pixel: those of the shapes that are rounded to it.
    pub units: i32,
}

/// Every precision that the library takes.
pub const PRECISIONS: &[Precision] = &[
    Precision {
        name: "whole pixel",
        variant: "whole_pixel",
        units: 1,
    },
    Precision {
        name: "Sub4",
        variant: "sub4",
        units: 16,
    },
    Precision {
        name: "Sub8",
        variant: "sub8",
        units: 256,
    },
];

type Contours<V> = Vec<Vec<V, CIRCLE_CORNERS>, 2>;

#[derive(Debug)]
enum Corners {
    Whole(Contours<Point>),
    Sub4(Contours<SubPoint<Sub4>>),
    Sub8(Contours<SubPoint<Sub8>>),
}

/// A shape as the library takes corners of its units.
#[derive(Debug)]
pub struct Rounded {
    corners: Corners,
    rule: FillRule,
}

impl Rounded {
    /// Takes over a shape in the units of one of the [`PRECISIONS`].
    ///
    /// # Errors
    /// It lies outside the domain of the library.
    pub fn new(shape: &Shape) -> Result<Self, InputError> {
        Ok(Self {
            corners: match shape.units {
                1 => Corners::Whole(contours(shape, |x, y| Ok(Point::new(x, y)))?),
                16 => Corners::Sub4(contours(shape, SubPoint::from_units)?),
                _ => Corners::Sub8(contours(shape, SubPoint::from_units)?),
            },
            rule: match shape.rule {
                Rule::EvenOdd => FillRule::EvenOdd,
                Rule::NonZero => FillRule::NonZero,
            },
        })
    }

    /// Fills it without antialiasing, into a mask of zeros.
    pub fn fill(&self, mask: &mut [u8]) {
        match &self.corners {
            Corners::Whole(contours) => fill_contours(contours, self.rule, mask),
            Corners::Sub4(contours) => fill_contours(contours, self.rule, mask),
            Corners::Sub8(contours) => fill_contours(contours, self.rule, mask),
        }
    }
}

fn contours<V: Copy>(
    shape: &Shape,
    corner: impl Fn(i32, i32) -> Result<V, InputError>,
) -> Result<Contours<V>, InputError> {
    let contour = |corners: &crate::Contour| corners.iter().map(|&(x, y)| corner(x, y)).collect();
    shape.contours.iter().map(contour).collect()
}

fn fill_contours<V: Vertex>(contours: &Contours<V>, rule: FillRule, mask: &mut [u8]) {
    let slices: Vec<&[V], 2> = contours.iter().map(Vec::as_slice).collect();
    if contours.iter().map(|contour| contour.len()).sum::<usize>() <= FEW {
        fill::<V, FEW, FEW>(&slices, rule, mask);
    } else {
        fill::<V, ROUND, ROUND_ACTIVE>(&slices, rule, mask);
    }
}
