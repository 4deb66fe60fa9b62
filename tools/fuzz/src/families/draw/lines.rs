//! Lines, polylines and points of whole pixels, in a style of fill and stroke.

use anyhow::Context;
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::Point,
    prelude::{Primitive, Transform},
    primitives::{Line, PointsIter, Polyline},
};
use zrow::draw::{Points, PrimitiveStyle};

use crate::{
    exact,
    picture::{Work, agree_styled, background, full_picture, is_same},
    target::{Case, Verdict},
    values::{Hue, Int, Length, List, Spot, Stage, Style},
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
