//! Lines, polylines and points of whole pixels, in a style of fill and stroke.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Dimensions, Point},
    prelude::{Primitive, Transform},
    primitives::{Line, PointsIter, Polyline, Rectangle},
};
use zrow::draw::{Points, PrimitiveStyle};

use crate::{
    exact,
    picture::{Work, agree_styled, background, full_picture, is_same},
    target::{Case, Verdict},
    values::{Count, Hue, Int, Length, List, Spot, Stage, Style},
};

/// A line in either direction, thin or wide.
#[derive(Debug, Arbitrary)]
pub struct LineCase {
    stage: Stage,
    ends: [Spot; 2],
    style: Style,
}

impl Case for LineCase {
    fn check(&self) -> Verdict {
        let Self { stage, style, .. } = self;
        let [from, to] = self.ends.map(|end| stage.point(end));
        agree_styled(stage, Line::new(from, to), *style, Work::ONCE)?;
        let color = Hue::Odd.color();
        let thin = PrimitiveStyle::with_stroke(color, 1);
        let expected: Vec<_> = stage
            .area()
            .points()
            .map(|pixel| {
                let is_on = exact::line_has(exact::wide(from), exact::wide(to), exact::wide(pixel));
                if is_on { color } else { background() }
            })
            .collect();
        for (from, to) in [(from, to), (to, from)] {
            let picture = full_picture(stage.window, &Line::new(from, to).into_styled(thin))?;
            is_same(&stage.window, &expected, &picture).context("by definition, the other drawn")?;
        }
        Ok(())
    }
}

/// A polyline, also without vertices or with repeated ones, moved.
#[derive(Debug, Arbitrary)]
pub struct PolylineCase {
    stage: Stage,
    vertices: List<Spot, 6>,
    offset: Option<[Int; 2]>,
    style: Style,
}

impl Case for PolylineCase {
    fn check(&self) -> Verdict {
        let vertices: Vec<_> = self.vertices.0.iter().map(|spot| self.stage.point(*spot)).collect();
        let polyline = Polyline::new(&vertices);
        let polyline = match self.offset {
            Some([x, y]) => polyline.translate(Point::new(x.0, y.0)),
            None => polyline,
        };
        let work = if self.style.width() > 1 {
            Work::ONCE
        } else {
            Work::parts(vertices.len().max(2))
        };
        agree_styled(&self.stage, polyline, self.style, work).map(drop)
    }
}

/// Squares and discs of a radius.
#[derive(Debug, Arbitrary)]
pub struct PointsCase {
    stage: Stage,
    centers: List<Spot, 4>,
    radius: Length,
    are_discs: bool,
    style: Style,
}

impl Case for PointsCase {
    fn check(&self) -> Verdict {
        let centers: Vec<_> = self.centers.0.iter().map(|spot| self.stage.point(*spot)).collect();
        let points = if self.are_discs {
            Points::discs(&centers, self.radius.0)
        } else {
            Points::squares(&centers, self.radius.0)
        };
        let work = Work::parts(centers.len().max(2));
        agree_styled(&self.stage, points, self.style, work).map(drop)
    }
}

/// The bounding box of squares anywhere, of any radius.
#[derive(Debug, Arbitrary)]
pub struct BoundsCase {
    centers: List<[Int; 2], 6>,
    radius: Count,
}

/// The first and the last column, and the first and the last row, of the squares that exist, in 128 bits.
fn sides_of_squares(centers: &[Point], radius: u32) -> Option<[i128; 4]> {
    // The largest radius of a square whose columns a size counts.
    let radius = i128::from(radius.min(i32::MAX as u32));
    let squares = centers.iter().map(|center| {
        let [x, y] = exact::wide(*center);
        [x - radius, x + radius, y - radius, y + radius]
    });
    let around = |one: [i128; 4], other: [i128; 4]| {
        [
            one[0].min(other[0]),
            one[1].max(other[1]),
            one[2].min(other[2]),
            one[3].max(other[3]),
        ]
    };
    let [left, right, top, bottom] = squares.reduce(around)?;
    let (first, last) = (i128::from(i32::MIN), i128::from(i32::MAX));
    // A size ends at u32::MAX, one short of the whole number range.
    let end = |start: i128, end: i128| end.min(last).min(start + i128::from(u32::MAX) - 1);
    let (left, top) = (left.max(first), top.max(first));
    Some([left, end(left, right), top, end(top, bottom)])
}

impl Case for BoundsCase {
    fn check(&self) -> Verdict {
        let centers: Vec<_> = self.centers.0.iter().map(|[x, y]| Point::new(x.0, y.0)).collect();
        let found = Points::squares(&centers, self.radius.0).bounding_box();
        let Rectangle { top_left, size } = found;
        let [left, top] = exact::wide(top_left);
        let sides = [
            left,
            left + i128::from(size.width) - 1,
            top,
            top + i128::from(size.height) - 1,
        ];
        let sides = (!found.is_zero_sized()).then_some(sides);
        let expected = sides_of_squares(&centers, self.radius.0);
        ensure!(
            sides == expected,
            "{found:?} around {centers:?} of radius {}: {expected:?}",
            self.radius.0
        );
        Ok(())
    }
}
