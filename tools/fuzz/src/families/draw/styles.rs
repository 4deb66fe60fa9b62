//! Shapes in antialiased styles: the same in bands of any height, without a panic wherever they are.

use anyhow::{bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::Point,
    pixelcolor::Rgb565,
    prelude::Primitive,
    primitives::{Arc, Circle, CornerRadii, Ellipse, Line, Polyline, Rectangle, RoundedRectangle, Sector, Triangle},
};
use zrow::{
    band::{Band, Order},
    draw::{DrawAntialiased, Polygon},
    geometry::{DrawError, Window},
};

use crate::{
    picture::{OnBand, agree_on_bands, background},
    target::{Case, Verdict},
    values::{Contours, Degrees, Length, List, Rule, Spot, Stage, Stroke, Style},
};

/// Edges of an outline, and those in one row.
const EDGES: usize = 1_024;
const ACTIVE: usize = 128;

/// A shape with a fill.
#[derive(Debug, Arbitrary)]
enum Shape {
    Rectangle(Spot, [Length; 2]),
    RoundedRectangle(Spot, [Length; 2], [[Length; 2]; 4]),
    Circle(Spot, Length),
    Ellipse(Spot, [Length; 2]),
    Arc(Spot, Length, [Degrees; 2]),
    Sector(Spot, Length, [Degrees; 2]),
    Triangle([Spot; 3]),
    Line([Spot; 2]),
    Polyline(List<Spot, 5>),
    Polygon(Contours<2, 5>),
}

/// A shape in a style of fill and stroke.
#[derive(Debug, Arbitrary)]
pub struct StyledCase {
    stage: Stage,
    shape: Shape,
    style: Style,
}

/// A shape with paths, and a stroke with caps, joins and dashes.
#[derive(Debug, Arbitrary)]
pub struct StrokedCase {
    stage: Stage,
    shape: Stroked,
    stroke: Stroke,
}

#[derive(Debug, Arbitrary)]
enum Stroked {
    Line([Spot; 2]),
    Polyline(List<Spot, 5>),
    Triangle([Spot; 3]),
    Rectangle(Spot, [Length; 2]),
    Polygon(Contours<2, 5>),
}

/// What draws itself antialiased, with memory of its own.
struct Antialiased<'d, D>(&'d D);

impl<D: DrawAntialiased<Color = Rgb565>> Antialiased<'_, D> {
    fn draw<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Result<(), DrawError<core::convert::Infallible>> {
        let width = zrow::band::Target::window(band).width();
        let mut row = vec![0; width as usize + 1];
        self.0.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut row))
    }
}

impl<D: DrawAntialiased<Color = Rgb565>> OnBand for Antialiased<'_, D> {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        match self.draw(band) {
            Ok(()) => Ok(()),
            Err(error) => bail!("{error}, where there is none in the whole window"),
        }
    }
}

/// The drawing is the same in all bands; where it is an error, nothing is drawn.
fn check(stage: &Stage, styled: &impl DrawAntialiased<Color = Rgb565>) -> Verdict {
    let drawing = Antialiased(styled);
    let Window { left, top, .. } = stage.window;
    let area = stage.area();
    let raw = embedded_graphics::prelude::IntoStorage::into_storage(background());
    let mut words = vec![raw; (area.size.width * area.size.height) as usize];
    let mut band = Band::<Rgb565>::new(area, &mut words)?;
    if let Err(error) = drawing.draw(&mut band) {
        ensure!(
            words.iter().all(|word| *word == raw),
            "{error}, but something is drawn from {left}, {top} on"
        );
        return Ok(());
    }
    agree_on_bands(stage, &drawing).map(drop)
}

impl Case for StyledCase {
    fn check(&self) -> Verdict {
        let Self { stage, shape, style } = self;
        let point = |spot: &Spot| stage.point(*spot);
        let style = style.get().antialiased();
        match shape {
            Shape::Rectangle(corner, [width, height]) => check(
                stage,
                &Rectangle::new(point(corner), width.by(*height)).into_styled(style),
            ),
            Shape::RoundedRectangle(corner, [width, height], radii) => {
                let [top_left, top_right, bottom_right, bottom_left] = radii.map(|[width, height]| width.by(height));
                let corners = CornerRadii {
                    top_left,
                    top_right,
                    bottom_right,
                    bottom_left,
                };
                let area = Rectangle::new(point(corner), width.by(*height));
                check(stage, &RoundedRectangle::new(area, corners).into_styled(style))
            }
            Shape::Circle(corner, diameter) => check(stage, &Circle::new(point(corner), diameter.0).into_styled(style)),
            Shape::Ellipse(corner, [width, height]) => check(
                stage,
                &Ellipse::new(point(corner), width.by(*height)).into_styled(style),
            ),
            Shape::Arc(corner, diameter, angles) => {
                let [start, sweep] = angles.map(Degrees::angle);
                check(
                    stage,
                    &Arc::new(point(corner), diameter.0, start, sweep).into_styled(style),
                )
            }
            Shape::Sector(corner, diameter, angles) => {
                let [start, sweep] = angles.map(Degrees::angle);
                check(
                    stage,
                    &Sector::new(point(corner), diameter.0, start, sweep).into_styled(style),
                )
            }
            Shape::Triangle([a, b, c]) => check(stage, &Triangle::new(point(a), point(b), point(c)).into_styled(style)),
            Shape::Line([from, to]) => check(stage, &Line::new(point(from), point(to)).into_styled(style)),
            Shape::Polyline(spots) => {
                let vertices: Vec<Point> = spots.0.iter().map(point).collect();
                check(stage, &Polyline::new(&vertices).into_styled(style))
            }
            Shape::Polygon(contours) => {
                let contours = contours.get(stage);
                let slices: Vec<&[Point]> = contours.iter().map(Vec::as_slice).collect();
                check(stage, &Polygon::new(&slices, Rule::EvenOdd.get()).into_styled(style))
            }
        }
    }
}

impl Case for StrokedCase {
    fn check(&self) -> Verdict {
        let Self { stage, shape, stroke } = self;
        let lengths = stroke.lengths();
        let style = stroke.style(&lengths).antialiased();
        let point = |spot: &Spot| stage.point(*spot);
        match shape {
            Stroked::Line([from, to]) => check(stage, &Line::new(point(from), point(to)).into_styled(style)),
            Stroked::Polyline(spots) => {
                let vertices: Vec<Point> = spots.0.iter().map(point).collect();
                check(stage, &Polyline::new(&vertices).into_styled(style))
            }
            Stroked::Triangle([a, b, c]) => {
                check(stage, &Triangle::new(point(a), point(b), point(c)).into_styled(style))
            }
            Stroked::Rectangle(corner, [width, height]) => check(
                stage,
                &Rectangle::new(point(corner), width.by(*height)).into_styled(style),
            ),
            Stroked::Polygon(contours) => {
                let contours = contours.get(stage);
                let slices: Vec<&[Point]> = contours.iter().map(Vec::as_slice).collect();
                check(stage, &Polygon::new(&slices, Rule::EvenOdd.get()).into_styled(style))
            }
        }
    }
}
