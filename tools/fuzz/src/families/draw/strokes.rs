//! Strokes with caps, joins and dashes, of every shape that has paths.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::Point,
    pixelcolor::Rgb565,
    prelude::{Dimensions, Drawable, Primitive},
    primitives::{Line, Polyline, Rectangle, Triangle},
};
use zrow::{
    draw::{DrawOn, Path, Polygon},
    geometry::{Sub4, Sub8},
};

use crate::{
    picture::{Work, agree, agree_with_drawable},
    target::{Case, Verdict},
    values::{Command, Contours, Length, List, Rule, Spot, Stage, Stroke, SubContours, commands},
};

/// The drawing agrees with itself. Dashes may lie over each other in a stroke of paths that do.
fn check_stroke<D>(stage: &Stage, styled: &D, work: Work) -> Verdict
where
    D: DrawOn<Color = Rgb565> + Drawable<Color = Rgb565, Output = ()> + Dimensions,
{
    let picture = agree(stage, styled, work)?;
    agree_with_drawable(stage, &picture, styled)
}

/// A shape of few vertices.
#[derive(Debug, Arbitrary)]
enum Shape {
    Line([Spot; 2]),
    Polyline(List<Spot, 5>),
    Triangle([Spot; 3]),
    Rectangle(Spot, Length, Length),
    Polygon(Contours<2, 5>),
}

/// A shape of whole pixels.
#[derive(Debug, Arbitrary)]
pub struct StrokeCase {
    stage: Stage,
    shape: Shape,
    stroke: Stroke,
}

impl Case for StrokeCase {
    fn check(&self) -> Verdict {
        let Self { stage, shape, stroke } = self;
        let lengths = stroke.lengths();
        let style = stroke.style(&lengths);
        let point = |spot: &Spot| stage.point(*spot);
        match shape {
            Shape::Line([from, to]) => {
                let line = Line::new(point(from), point(to));
                check_stroke(stage, &line.into_styled(style), Work::ONCE)
            }
            Shape::Polyline(spots) => {
                let vertices: Vec<Point> = spots.0.iter().map(point).collect();
                check_stroke(stage, &Polyline::new(&vertices).into_styled(style), Work::ONCE)
            }
            Shape::Triangle([a, b, c]) => {
                let triangle = Triangle::new(point(a), point(b), point(c));
                check_stroke(stage, &triangle.into_styled(style), Work::ONCE)
            }
            Shape::Rectangle(corner, width, height) => {
                let rectangle = Rectangle::new(point(corner), width.by(*height));
                check_stroke(stage, &rectangle.into_styled(style), Work::ONCE)
            }
            Shape::Polygon(contours) => {
                let contours = contours.get(stage);
                let slices: Vec<&[Point]> = contours.iter().map(Vec::as_slice).collect();
                let polygon = Polygon::new(&slices, Rule::EvenOdd.get());
                check_stroke(stage, &polygon.into_styled(style), Work::ONCE)
            }
        }
    }
}

/// A polygon or a path between pixels.
#[derive(Debug, Arbitrary)]
pub struct SubStrokeCase {
    stage: Stage,
    shape: SubShape,
    by_hand: bool,
    stroke: Stroke,
}

#[derive(Debug, Arbitrary)]
enum SubShape {
    Polygon(SubContours<2, 5>),
    Path(List<Command, 4>),
}

impl Case for SubStrokeCase {
    fn check(&self) -> Verdict {
        let Self { stage, stroke, .. } = self;
        let lengths = stroke.lengths();
        let style = stroke.style(&lengths);
        match &self.shape {
            SubShape::Polygon(contours) => {
                let contours = if self.by_hand {
                    contours.by_hand::<Sub4>(stage)
                } else {
                    contours.inside(stage)
                };
                let slices: Vec<_> = contours.iter().map(Vec::as_slice).collect();
                let polygon = Polygon::new(&slices, Rule::NonZero.get());
                check_stroke(stage, &polygon.into_styled(style), Work::ONCE)
            }
            SubShape::Path(list) => {
                let commands = commands::<Sub8, 4>(list, stage, !self.by_hand);
                match Path::new(&commands, Rule::NonZero.get()) {
                    Ok(path) => check_stroke(stage, &path.into_styled(style), Work::ONCE),
                    Err(_) => {
                        ensure!(self.by_hand, "points of the domain are outside of it");
                        Ok(())
                    }
                }
            }
        }
    }
}
