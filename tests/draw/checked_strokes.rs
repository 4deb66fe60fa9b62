//! Strokes drawn in whole and in parts, and compared with the ideal union of their primitives.
//!
//! The corners of rectangles and wedges, and the ends of dashes, are rounded to 1/65,536 pixel, so a pixel whose centre is
//! nearer than that to their ideal outline may go either way; every other pixel may not. Discs about vertices are exact.

use std::collections::BTreeSet;

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Primitive, Rectangle, Styled, StyledDimensions, StyledDrawable},
};
use fixed::types::{I16F16, U16F16};
use zrow::{
    draw::{DrawOn, FillRule, Path, PathCommand, Polygon, StrokeStyle},
    geometry::{Sub8, SubPoint},
};

use crate::common::{encloses, painted};
use crate::reference::ideal_stroke::{self, BITS, Location, Style, ideal, primitives};

pub const STROKE: Rgb565 = Rgb565::RED;

impl Style {
    /// Calls with zrow's style.
    pub fn with<R>(&self, call: impl FnOnce(StrokeStyle<'_, Rgb565>) -> R) -> R {
        let style = StrokeStyle::new(STROKE, self.width).cap(self.cap).join(self.join);
        let Some((lengths, offset)) = &self.dashes else {
            return call(style);
        };
        let lengths: Vec<U16F16> = lengths.iter().map(|&length| U16F16::from_bits(length)).collect();
        call(style.dashes(&lengths).dash_offset(I16F16::from_bits(*offset)))
    }
}

/// 1/256 pixel as the reference has them.
pub fn sub_pixel(points: &[(i32, i32)]) -> Vec<SubPoint<Sub8>> {
    points
        .iter()
        .map(|&(x, y)| SubPoint::from_units(x, y).unwrap())
        .collect()
}

/// An open path; one point alone is a dot.
pub fn open(points: &[(i32, i32)]) -> Vec<PathCommand<Sub8>> {
    let points = sub_pixel(points);
    let lines = points.iter().map(|&to| PathCommand::LineTo(to));
    std::iter::once(PathCommand::MoveTo(points[0])).chain(lines).collect()
}

pub fn open_path(commands: &[PathCommand<Sub8>]) -> Path<'_, Sub8> {
    Path::new(commands, FillRule::NonZero).unwrap()
}

pub fn screen() -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(64, 64))
}

/// The picture on a display that panics on a pixel drawn twice; the same in bands and in columns, and all in its bounds.
pub fn drawn<S>(shape: S, style: StrokeStyle<'_, Rgb565>) -> BTreeSet<(i32, i32)>
where
    S: Primitive
        + Clone
        + for<'d> StyledDrawable<StrokeStyle<'d, Rgb565>, Color = Rgb565, Output = ()>
        + for<'d> StyledDimensions<StrokeStyle<'d, Rgb565>>,
    for<'d> Styled<S, StrokeStyle<'d, Rgb565>>: DrawOn<Color = Rgb565>,
{
    let styled = shape.into_styled(style);
    let mut display = MockDisplay::new();
    styled.draw(&mut display).unwrap();
    let all: BTreeSet<(i32, i32)> = screen()
        .points()
        .filter(|&point| display.get_pixel(point).is_some())
        .map(|point| (point.x, point.y))
        .collect();
    let bounds = styled.bounding_box();
    for &(x, y) in &all {
        assert!(encloses(&bounds, Point::new(x, y)), "({x}, {y}) outside {bounds:?}");
    }
    let rows = (0..9).map(|band| Rectangle::new(Point::new(0, 3 * band), Size::new(64, 3)));
    let single_rows = (27..35).map(|row| Rectangle::new(Point::new(0, row), Size::new(64, 1)));
    let columns = (0..4).map(|column| Rectangle::new(Point::new(16 * column, 35), Size::new(16, 29)));
    let parts: BTreeSet<(i32, i32)> = rows
        .chain(single_rows)
        .chain(columns)
        .flat_map(|window| {
            painted(window, |band| {
                let Ok(()) = styled.draw_on(band);
            })
        })
        .map(|point| (point.x, point.y))
        .collect();
    assert_eq!(parts, all, "in parts");
    all
}

/// Compares and returns how many pixels could have gone either way.
pub fn check(
    drawn: &BTreeSet<(i32, i32)>,
    primitives: &[ideal_stroke::Primitive],
    what: &dyn std::fmt::Debug,
) -> usize {
    let mut free = 0;
    for Point { x, y } in screen().points() {
        let center = (i128::from(x) << BITS, i128::from(y) << BITS);
        let location = primitives.iter().map(|primitive| primitive.locate(center)).max();
        match location.unwrap_or(Location::Outside) {
            Location::Between => free += 1,
            location => assert_eq!(
                drawn.contains(&(x, y)),
                location == Location::Inside,
                "at {x}, {y}: {what:?}"
            ),
        }
    }
    free
}

pub fn check_sub_pixel(units: &[(i32, i32)], closed: bool, style: &Style) -> Option<usize> {
    let primitives = primitives(&ideal(units), closed, style)?;
    let points = sub_pixel(units);
    let contours = [points.as_slice()];
    let drawn = style.with(|style| match closed {
        true => drawn(Polygon::new(&contours, FillRule::EvenOdd), style),
        false => drawn(open_path(&open(units)), style),
    });
    Some(check(&drawn, &primitives, &(units, closed, style)))
}

pub fn pixels(lengths: &[u16]) -> Vec<U16F16> {
    lengths.iter().map(|&length| U16F16::from_num(length)).collect()
}
