//! Antialiased fills and strokes of closed shapes and arcs, against the ideal shapes.

use std::f64::consts::TAU;

use embedded_graphics::{
    geometry::{Angle, Point, Size},
    pixelcolor::Gray8,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Rectangle, RoundedRectangle, Sector, StrokeAlignment, Styled, Triangle,
    },
};
use zrow::draw::{DrawAntialiased, PrimitiveStyle};

use crate::{
    antialiased_area::{ALIGNMENTS, Xorshift, compare, fill, stroke, widths},
    common::cases,
    reference::ideal_coverage::{degrees_from, in_ellipse},
};

/// Compares the fill and the strokes of a closed shape whose `curve` is given in a box that is moved outwards.
fn compare_closed<S: Primitive + Copy + std::fmt::Debug>(shape: S, width: u32, curve: impl Fn(f64, f64, f64) -> bool)
where
    Styled<S, zrow::draw::Antialiased<PrimitiveStyle<Gray8>>>: DrawAntialiased<Color = Gray8>,
{
    compare(
        &format!("{shape:?}"),
        &shape.into_styled(fill().antialiased()),
        |x, y| curve(x, y, 0.0),
    );
    for alignment in ALIGNMENTS {
        let style = stroke(width, alignment);
        let (inside, outside) = widths(&style);
        let name = format!("{shape:?}, {width} {alignment:?}");
        compare(&name, &shape.into_styled(style.antialiased()), |x, y| {
            curve(x, y, outside) && !curve(x, y, -inside)
        });
    }
}

#[test]
fn circles_and_ellipses() {
    let mut random = Xorshift::new(0x0c1e);
    for _ in 0..cases(5, 12) {
        let top_left = Point::new(random.between(-8, 20), random.between(-8, 20));
        let size = Size::new(random.between(1, 40) as u32, random.between(1, 40) as u32);
        let width = random.between(1, 6) as u32;
        let circle = Circle::new(top_left, size.width);
        compare_closed(circle, width, |x, y, beyond| {
            in_ellipse(&circle.bounding_box(), beyond, x, y)
        });
        let ellipse = Ellipse::new(top_left, size);
        compare_closed(ellipse, width, |x, y, beyond| {
            in_ellipse(&ellipse.bounding_box(), beyond, x, y)
        });
    }
}

/// Radii that fit, so that they are not scaled down.
#[test]
fn rounded_rectangles() {
    let mut random = Xorshift::new(0x4e41);
    for _ in 0..cases(5, 12) {
        let around = Rectangle::new(
            Point::new(random.between(-8, 10), random.between(-8, 10)),
            Size::new(random.between(20, 40) as u32, random.between(20, 40) as u32),
        );
        let mut radius = || Size::new(random.between(0, 10) as u32, random.between(0, 10) as u32);
        let corners = CornerRadii {
            top_left: radius(),
            top_right: radius(),
            bottom_right: radius(),
            bottom_left: radius(),
        };
        let shape = RoundedRectangle::new(around, corners);
        compare_closed(shape, random.between(1, 4) as u32, |x, y, beyond| {
            let (left, top) = (f64::from(around.top_left.x) - 0.5, f64::from(around.top_left.y) - 0.5);
            let (right, bottom) = (left + f64::from(around.size.width), top + f64::from(around.size.height));
            let corner = |from_left: f64, from_top: f64, radius: Size| {
                let (across, down) = (f64::from(radius.width) + beyond, f64::from(radius.height) + beyond);
                let (right, down_from) = (across - from_left, down - from_top);
                across <= 0.0
                    || down <= 0.0
                    || right <= 0.0
                    || down_from <= 0.0
                    || (right / across).powi(2) + (down_from / down).powi(2) < 1.0
            };
            let (from_left, from_top) = (x - left + beyond, y - top + beyond);
            let (from_right, from_bottom) = (right + beyond - x, bottom + beyond - y);
            from_left.min(from_right).min(from_top).min(from_bottom) > 0.0
                && corner(from_left, from_top, corners.top_left)
                && corner(from_right, from_top, corners.top_right)
                && corner(from_right, from_bottom, corners.bottom_right)
                && corner(from_left, from_bottom, corners.bottom_left)
        });
    }
}

/// The middle of a circle's box.
fn middle(top_left: Point, diameter: u32) -> (f64, f64) {
    let half = (f64::from(diameter) - 1.0) / 2.0;
    (f64::from(top_left.x) + half, f64::from(top_left.y) + half)
}

#[test]
fn arcs() {
    let mut random = Xorshift::new(0xa4c5);
    for index in 0..cases(10, 24) as usize {
        let diameter = random.between(8, 40) as u32;
        let top_left = Point::new(random.between(-8, 10), random.between(-8, 10));
        let (start, sweep) = (random.between(-400, 400), random.between(-359, 359));
        let sweep = if index == 0 { 360 } else { sweep };
        let (start, sweep) = (start as f32, sweep as f32);
        let arc = Arc::new(
            top_left,
            diameter,
            Angle::from_degrees(start),
            Angle::from_degrees(sweep),
        );
        let style = stroke(random.between(1, 6) as u32, ALIGNMENTS[index % 3]);
        let (inside, outside) = widths(&style);
        let first = f64::from(start + sweep.min(0.0));
        let (center_x, center_y) = middle(top_left, diameter);
        compare(
            &format!("{arc:?}, {style:?}"),
            &arc.into_styled(style.antialiased()),
            |x, y| {
                let around = arc.bounding_box();
                let is_between = degrees_from(first, x - center_x, y - center_y) < f64::from(sweep.abs());
                is_between && in_ellipse(&around, outside, x, y) && !in_ellipse(&around, -inside, x, y)
            },
        );
    }
}

/// Between 60 and 300 degrees: sharper corners are cut off.
#[test]
fn sectors() {
    let mut random = Xorshift::new(0x5ec7);
    for _ in 0..cases(3, 12) {
        let diameter = random.between(20, 40) as u32;
        let top_left = Point::new(random.between(-8, 10), random.between(-8, 10));
        let (start, sweep) = (f64::from(random.between(-400, 400)), f64::from(random.between(60, 300)));
        let angle = |degrees: f64| Angle::from_degrees(degrees as f32);
        let sector = Sector::new(top_left, diameter, angle(start), angle(sweep));
        let (center_x, center_y) = middle(top_left, diameter);
        compare_closed(sector, random.between(1, 4) as u32, |x, y, beyond| {
            // How far the point lies beyond a side: to its left or to its right.
            let beyond_side = |degrees: f64, sign: f64| {
                let (sine, cosine) = degrees.to_radians().sin_cos();
                sign * ((y - center_y) * cosine - (x - center_x) * sine)
            };
            let (first, last) = (beyond_side(start, -1.0), beyond_side(start + sweep, 1.0));
            let nearest = if sweep < 180.0 {
                first.max(last)
            } else {
                first.min(last)
            };
            nearest < beyond + 0.5 && in_ellipse(&sector.bounding_box(), beyond, x, y)
        });
    }
}

/// Angles above 40 degrees, so that the corners are miters.
#[test]
fn triangles() {
    let mut random = Xorshift::new(0x7419);
    let mut compared = 0;
    while compared < cases(2, 12) {
        let mut vertex = || Point::new(random.between(-8, 50), random.between(-8, 50));
        let triangle = Triangle::new(vertex(), vertex(), vertex());
        let [a, b, c] = triangle
            .vertices
            .map(|vertex| (f64::from(vertex.x), f64::from(vertex.y)));
        let angle = |at: (f64, f64), one: (f64, f64), other: (f64, f64)| {
            let direction = |to: (f64, f64)| (to.1 - at.1).atan2(to.0 - at.0);
            let between = (direction(one) - direction(other)).abs();
            between.min(TAU - between).to_degrees()
        };
        let sharpest = angle(a, b, c).min(angle(b, c, a)).min(angle(c, a, b));
        if sharpest < 40.0 {
            continue;
        }
        compared += 1;
        let sides = [(a, b), (b, c), (c, a)];
        let area = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
        // How far a point lies beyond the nearest line.
        let beyond = |x: f64, y: f64| {
            let distance = |(from, to): ((f64, f64), (f64, f64))| {
                let (right, down) = (to.0 - from.0, to.1 - from.1);
                (down * (x - from.0) - right * (y - from.1)) / right.hypot(down) * area.signum()
            };
            sides.map(distance).into_iter().fold(f64::MIN, f64::max)
        };
        compare(
            &format!("{triangle:?}"),
            &triangle.into_styled(fill().antialiased()),
            |x, y| beyond(x, y) < 0.5,
        );
        for alignment in ALIGNMENTS {
            let width = random.between(1, 5) as u32;
            let wide = f64::from(width);
            let (inner, outer) = match alignment {
                StrokeAlignment::Inside => (0.5 - wide, 0.5),
                StrokeAlignment::Center => (-wide / 2.0, wide / 2.0),
                StrokeAlignment::Outside => (0.5, 0.5 + wide),
            };
            let style = stroke(width, alignment).antialiased();
            compare(
                &format!("{triangle:?}, {style:?}"),
                &triangle.into_styled(style),
                |x, y| (inner..outer).contains(&beyond(x, y)),
            );
        }
    }
}
