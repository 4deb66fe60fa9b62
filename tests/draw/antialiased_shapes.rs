//! Antialiased fills and strokes of closed shapes and arcs, against the ideal shapes.

use std::f64::consts::TAU;

use embedded_graphics::{
    geometry::{Angle, Point, Size},
    pixelcolor::{Gray8, GrayColor},
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Rectangle, RoundedRectangle, Sector, StrokeAlignment, Styled, Triangle,
    },
};
use zrow::{
    band::Band,
    draw::{AntialiasingMemory, DrawAntialiased, ItemId, Picture, PictureSlot, PrimitiveStyle},
    geometry::InputError,
};

use crate::{
    antialiased_area::{ALIGNMENTS, AREA, SIDE, Xorshift, compare, coverage, fill, filled, stroke, widths},
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
            in_rounded_rectangle(&shape, beyond, x, y)
        });
    }
}

/// Whether a point is in a rounded rectangle whose sides are moved outwards. Where radii do not fit then, all of them are scaled
/// down, so that the tightest side fits.
fn in_rounded_rectangle(shape: &RoundedRectangle, beyond: f64, x: f64, y: f64) -> bool {
    let (around, corners) = (shape.rectangle, shape.corners);
    let (left, top) = (f64::from(around.top_left.x) - 0.5, f64::from(around.top_left.y) - 0.5);
    let (width, height) = (f64::from(around.size.width), f64::from(around.size.height));
    let radii = |radius: Size| [radius.width, radius.height].map(|radius| (f64::from(radius) + beyond).max(0.0));
    let [top_left, top_right] = [corners.top_left, corners.top_right].map(radii);
    let [bottom_right, bottom_left] = [corners.bottom_right, corners.bottom_left].map(radii);
    let fits = |side: f64, one: f64, other: f64| (side + 2.0 * beyond) / (one + other);
    let factor = fits(width, top_left[0], top_right[0])
        .min(fits(width, bottom_left[0], bottom_right[0]))
        .min(fits(height, top_left[1], bottom_left[1]))
        .min(fits(height, top_right[1], bottom_right[1]))
        .min(1.0);
    let corner = |from_left: f64, from_top: f64, radii: [f64; 2]| {
        let [across, down] = radii.map(|radius| radius * factor);
        let (right, down_from) = (across - from_left, down - from_top);
        across <= 0.0
            || down <= 0.0
            || right <= 0.0
            || down_from <= 0.0
            || (right / across).powi(2) + (down_from / down).powi(2) < 1.0
    };
    let (from_left, from_top) = (x - left + beyond, y - top + beyond);
    let (from_right, from_bottom) = (left + width + beyond - x, top + height + beyond - y);
    from_left.min(from_right).min(from_top).min(from_bottom) > 0.0
        && corner(from_left, from_top, top_left)
        && corner(from_right, from_top, top_right)
        && corner(from_right, from_bottom, bottom_right)
        && corner(from_left, from_bottom, bottom_left)
}

/// Radii of one corner alone that take most of the box: the hole of a stroke inside is scaled down on its own, and is cut off
/// along the outer curve.
#[test]
fn rounded_rectangles_with_a_hole_that_is_cut_off() {
    for (index, (size, radius, width)) in [
        ((7, 100), (7, 50), 3),
        ((7, 40), (7, 40), 3),
        ((40, 7), (40, 7), 3),
        ((11, 30), (10, 30), 4),
    ]
    .into_iter()
    .enumerate()
    {
        let mut radii = [Size::zero(); 4];
        // Of the first one, no other corner is in the area.
        radii[index] = Size::from(radius);
        let shape = RoundedRectangle::new(Rectangle::new(Point::zero(), Size::from(size)), corner_radii(radii));
        compare_closed(shape, width, |x, y, beyond| in_rounded_rectangle(&shape, beyond, x, y));
        check_cut_off(&shape, width);
    }
}

/// Radii beyond the box, and strokes of which nothing may be left inside.
#[test]
fn rounded_rectangles_with_radii_that_do_not_fit() {
    let mut random = Xorshift::new(0x4e42);
    for _ in 0..cases(400, 4_000) {
        let top_left = Point::new(random.between(-8, 10), random.between(-8, 10));
        let size = Size::new(random.between(5, 12) as u32, random.between(20, 44) as u32);
        let radii = [(); 4].map(|()| {
            let mut length = |side: u32| random.between(side as i32 - 4, side as i32 + 1) as u32;
            let radius = Size::new(length(size.width), length(size.height));
            // A large corner beside sharp ones has an inner curve of another form.
            if random.between(0, 2) > 0 { Size::zero() } else { radius }
        });
        let shape = RoundedRectangle::new(Rectangle::new(top_left, size), corner_radii(radii));
        check_cut_off(&shape, random.between(1, 4) as u32);
    }
}

const fn corner_radii([top_left, top_right, bottom_right, bottom_left]: [Size; 4]) -> CornerRadii {
    CornerRadii {
        top_left,
        top_right,
        bottom_right,
        bottom_left,
    }
}

/// Whether no stroke of a rounded rectangle, with and without a fill, has a pixel outside of the filled outer shape, and all are
/// the same in a picture.
fn check_cut_off(shape: &RoundedRectangle, width: u32) {
    for alignment in ALIGNMENTS {
        let style = stroke(width, alignment);
        let by = style.outside_stroke_width();
        let corners = shape.corners;
        let radii = [
            corners.top_left,
            corners.top_right,
            corners.bottom_right,
            corners.bottom_left,
        ];
        let outer = RoundedRectangle::new(
            shape.rectangle.offset(by as i32),
            corner_radii(radii.map(|radius| radius + Size::new_equal(by))),
        );
        let outer = coverage(&outer.into_styled(fill().antialiased()));
        for style in [style, filled(Gray8::WHITE, width, alignment)] {
            let styled = shape.into_styled(style.antialiased());
            let drawn = coverage(&styled);
            for ((outer, drawn), pixel) in outer.iter().zip(&drawn).zip(AREA.points()) {
                assert!(*outer > 0 || *drawn == 0, "{shape:?}, {style:?}, {pixel:?}: {drawn}");
            }
            assert_eq!(prepared(|picture| picture.add(&styled)), drawn, "{shape:?}, {style:?}");
        }
    }
}

/// The coverage of each pixel by a shape that is added to a picture.
fn prepared(add: impl FnOnce(&mut Picture<'_, '_, Gray8>) -> Result<ItemId, InputError>) -> Vec<u8> {
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], vec![0; 4_096], [0; SIDE as usize]);
    let mut memory = AntialiasingMemory::<{ SIDE as usize + 1 }, 512, 64>::new();
    let mut picture: Picture<Gray8> =
        Picture::new(AREA, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
    add(&mut picture).unwrap();
    let mut words = vec![0; (SIDE * SIDE) as usize];
    picture.draw(&mut Band::<Gray8>::new(AREA, &mut words).unwrap());
    words
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

/// A sector whose sides meet outside of the disc, or nowhere in it: narrow ones in a wide stroke outside have the disc's back
/// between their sides, and of wide ones in a wide stroke inside two parts of the disc are left, or what is beyond the bevel.
#[test]
fn sectors_whose_sides_meet_outside_of_the_disc() {
    let [inside, center, outside] = ALIGNMENTS;
    let middle = Point::new(14, 12);
    for (diameter, sweep, width, alignment) in [
        // The outer side, with and without a bevel, and the hole.
        (10, 40.0, 6, outside),
        (10, 65.0, 12, outside),
        (20, 4.0, 6, outside),
        // The hole in two parts, and the part of it that is beyond the bevel.
        (40, 270.0, 9, inside),
        (20, 318.0, 8, inside),
        (20, 340.0, 10, center),
    ] {
        let top_left = middle - Point::new_equal(diameter / 2);
        check_sector(top_left, diameter as u32, [200.0, sweep], &stroke(width, alignment));
    }
    let mut random = Xorshift::new(0xd15c);
    for index in 0..cases(16, 60) {
        let diameter = random.between(2, 24) as u32;
        let top_left = Point::new(random.between(-4, 20), random.between(-4, 20));
        let (start, narrow) = (f64::from(random.between(0, 359)), f64::from(random.between(1, 100)));
        let sweep = if index % 2 == 0 { narrow } else { 360.0 - narrow };
        let alignment = ALIGNMENTS[random.between(0, 2) as usize];
        let style = stroke(random.between(1, 14) as u32, alignment);
        check_sector(top_left, diameter, [start, sweep], &style);
    }
}

/// Compares the stroke of a sector with the ideal one, and with that in a picture.
fn check_sector(top_left: Point, diameter: u32, degrees: [f64; 2], style: &PrimitiveStyle<Gray8>) {
    let [start, sweep] = degrees.map(|degrees| Angle::from_degrees(degrees as f32));
    let sector = Sector::new(top_left, diameter, start, sweep).into_styled(style.antialiased());
    let (inside, outside) = widths(style);
    compare(&format!("{sector:?}"), &sector, |x, y| {
        let is_in = |beyond: f64| in_sector(&sector.primitive, degrees, outside, beyond, x, y);
        is_in(outside) && !is_in(-inside)
    });
    assert_eq!(
        prepared(|picture| picture.add(&sector)),
        coverage(&sector),
        "{sector:?}"
    );
}

/// Whether a point is in a sector whose border is moved outwards, and whose tip is cut off by a stroke so far outside.
fn in_sector(shape: &Sector, [start, sweep]: [f64; 2], outside: f64, beyond: f64, x: f64, y: f64) -> bool {
    let (center_x, center_y) = middle(shape.top_left, shape.diameter);
    let (right, down) = (x - center_x, y - center_y);
    // How far the point lies on the right side of a line through the centre.
    let beside = |degrees: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        down * cosine - right * sine
    };
    let (first, last) = (-beside(start), beside(start + sweep));
    let sides = beyond + 0.5;
    let along_middle = -beside(start + sweep / 2.0 + 90.0);
    let tip = sides.abs() / (sweep / 2.0).to_radians().sin();
    let is_cut = tip > 2.0 * outside;
    let is_between = if sweep < 180.0 {
        let is_cut = is_cut && sweep < 55.0 && sides > 0.0;
        first.max(last) < sides && !(is_cut && along_middle < -2.0 * outside)
    } else {
        let is_cut = is_cut && sweep > 305.0 && sides < 0.0;
        first.min(last) < sides || is_cut && along_middle > 2.0 * outside
    };
    is_between && in_ellipse(&shape.bounding_box(), beyond, x, y)
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
