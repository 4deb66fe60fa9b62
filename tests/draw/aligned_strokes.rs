//! Antialiased strokes inside and outside of polygons and paths: the exact area of what the shape cuts off from a stroke twice
//! as wide, the fill below them, and their pixels along rows and columns.

use embedded_graphics::{
    geometry::Point,
    mock_display::MockDisplay,
    pixelcolor::{Gray8, GrayColor},
    prelude::*,
    primitives::StrokeAlignment,
};
use zrow::{
    draw::{DrawAntialiased, FillRule, Path, PathCommand, Polygon, PrimitiveStyle, SubArc, SubEllipse, SubLine},
    fixed::types::{U0F16, U24F8},
    geometry::{DrawError, Sub8, SubPoint, TooSmall, Window},
};

use crate::{
    antialiased_area::{AREA, SIDE, Xorshift, coverage, filled, in_bands, stroke},
    reference::exact_area::exact_where,
};

/// A contour, its corners in pixels.
type Contour = Vec<(f64, f64)>;

/// Corners are rounded to 1/256 pixel: less than 1/255 along each of up to three sides in a pixel, and a coverage is rounded.
const BOUND: f64 = 4.0;

/// Whether the tips of all joins are so far from the miter limit that rounding does not decide on which side of it they are.
fn has_clear_joins(contour: &[(f64, f64)], closed: bool) -> bool {
    joints(contour, closed).all(|(_, before, after)| {
        let cosine = before.0 * after.0 + before.1 * after.1;
        // The square of the tip's distance in half widths; the limit is 4.
        cosine > -0.999 && (2.0 / (1.0 + cosine) - 16.0).abs() > 0.05
    })
}

/// The corners at which two segments meet, with the directions of both.
fn joints(contour: &[(f64, f64)], closed: bool) -> impl Iterator<Item = ((f64, f64), (f64, f64), (f64, f64))> {
    let count = contour.len();
    let indices = if closed { 0..count } else { 1..count.max(1) - 1 };
    indices.map(move |index| {
        let at = |index: usize| contour[index % count];
        let (before, here, after) = (at(index + count - 1), at(index), at(index + 1));
        (here, direction(before, here), direction(here, after))
    })
}

fn direction(from: (f64, f64), to: (f64, f64)) -> (f64, f64) {
    let length = (to.0 - from.0).hypot(to.1 - from.1);
    ((to.0 - from.0) / length, (to.1 - from.1) / length)
}

/// The convex contours whose union is the stroke of a contour, all of one sense of rotation, with miter joins and butt caps.
fn ideal_stroke(contour: &[(f64, f64)], closed: bool, width: f64) -> Vec<Contour> {
    let half = width / 2.0;
    let count = contour.len();
    let mut primitives: Vec<Contour> = Vec::new();
    for index in 0..if closed { count } else { count - 1 } {
        let (from, to) = (contour[index], contour[(index + 1) % count]);
        let along = direction(from, to);
        let side = (-along.1 * half, along.0 * half);
        primitives.push(vec![
            (from.0 + side.0, from.1 + side.1),
            (to.0 + side.0, to.1 + side.1),
            (to.0 - side.0, to.1 - side.1),
            (from.0 - side.0, from.1 - side.1),
        ]);
    }
    for (here, before, after) in joints(contour, closed) {
        let sine = before.0 * after.1 - before.1 * after.0;
        let cosine = before.0 * after.0 + before.1 * after.1;
        let reach = -sine.signum() * half;
        let outer = |along: (f64, f64)| (here.0 - along.1 * reach, here.1 + along.0 * reach);
        let (one, other) = (outer(before), outer(after));
        let mut wedge = vec![here, one];
        if 2.0 / (1.0 + cosine) < 16.0 {
            // Where the outer sides meet.
            let beyond = half * sine.abs() / (1.0 + cosine);
            wedge.push((one.0 + before.0 * beyond, one.1 + before.1 * beyond));
        }
        wedge.push(other);
        primitives.push(wedge);
    }
    for primitive in &mut primitives {
        let sides = primitive.iter().zip(primitive.iter().cycle().skip(1));
        let doubled_area: f64 = sides.map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum();
        if doubled_area < 0.0 {
            primitive.reverse();
        }
    }
    primitives
}

/// The exact area in each pixel of a shape and the union of its strokes, where `includes` says so.
fn areas(
    contours: &[Contour],
    closed: bool,
    fill_rule: FillRule,
    width: u32,
    includes: impl Fn(bool, bool) -> bool,
) -> Vec<f64> {
    let stroke: Vec<Contour> = contours
        .iter()
        .flat_map(|contour| ideal_stroke(contour, closed, width.into()))
        .collect();
    let window = Window::from(AREA);
    let includes = |[shape, stroke]: [i32; 2]| includes(fill_rule.includes(shape), stroke != 0);
    exact_where([contours, &stroke], includes, &window)
}

/// The sides of a stroke's alignment that are drawn, by whether a point is in the shape and in a stroke twice as wide.
fn is_drawn(alignment: StrokeAlignment) -> impl Fn(bool, bool) -> bool {
    move |in_shape, in_stroke| in_stroke && in_shape == (alignment == StrokeAlignment::Inside)
}

fn assert_near(name: &str, drawn: &[u8], ideal: &[f64]) {
    for ((pixel, &drawn), ideal) in AREA.points().zip(drawn).zip(ideal) {
        let error = f64::from(drawn) - 255.0 * ideal;
        assert!(
            error.abs() <= BOUND,
            "{name}, {pixel:?}: {drawn}, not {}",
            255.0 * ideal
        );
    }
}

/// Draws a shape in white and compares it with the ideal areas; in bands of any height it is the same.
fn compare(name: &str, shape: &impl DrawAntialiased<Color = Gray8>, ideal: &[f64]) {
    let drawn = coverage(shape);
    for rows in [1, 5, 16] {
        assert_eq!(drawn, in_bands(shape, rows), "{name} in bands of {rows}");
    }
    assert_near(name, &drawn, ideal);
}

/// Contours of random corners in 1/256 pixel, not all of them along rows and columns, with clear joins.
fn random_contours(random: &mut Xorshift, closed: bool) -> Vec<Vec<SubPoint<Sub8>>> {
    loop {
        let contours: Vec<Vec<SubPoint<Sub8>>> = (0..random.between(1, 3))
            .map(|_| {
                (0..random.between(3, 7))
                    .map(|_| {
                        let mut units = || random.between(-10 * 256, 52 * 256);
                        SubPoint::from_units(units(), units()).unwrap()
                    })
                    .collect()
            })
            .collect();
        if in_pixels(&contours)
            .iter()
            .all(|contour| has_clear_joins(contour, closed))
        {
            return contours;
        }
    }
}

fn in_pixels(contours: &[Vec<SubPoint<Sub8>>]) -> Vec<Contour> {
    let pixels = |units: i32| f64::from(units) / 256.0;
    let corner = |point: &SubPoint<Sub8>| (pixels(point.x_units()), pixels(point.y_units()));
    contours
        .iter()
        .map(|contour| contour.iter().map(corner).collect())
        .collect()
}

const BESIDE: [StrokeAlignment; 2] = [StrokeAlignment::Inside, StrokeAlignment::Outside];
const RULES: [FillRule; 2] = [FillRule::EvenOdd, FillRule::NonZero];

#[test]
fn polygons_of_crossing_contours() {
    let mut random = Xorshift::new(0xa116);
    for index in 0..48 {
        let contours = random_contours(&mut random, true);
        let (alignment, fill_rule) = (BESIDE[index % 2], RULES[index / 2 % 2]);
        let width = random.between(1, 9) as u32;
        let slices: Vec<&[SubPoint<Sub8>]> = contours.iter().map(Vec::as_slice).collect();
        let polygon = Polygon::new(&slices, fill_rule);
        let ideal = areas(&in_pixels(&contours), true, fill_rule, 2 * width, is_drawn(alignment));
        compare(
            &format!("{polygon:?}, {width}, {alignment:?}"),
            &polygon.into_styled(stroke(width, alignment).antialiased()),
            &ideal,
        );
    }
}

/// The commands along contours.
fn commands(contours: &[Vec<SubPoint<Sub8>>], closed: bool) -> Vec<PathCommand<Sub8>> {
    let along = |contour: &Vec<SubPoint<Sub8>>| {
        let mut commands: Vec<_> = contour.iter().map(|point| PathCommand::LineTo(*point)).collect();
        commands[0] = PathCommand::MoveTo(contour[0]);
        if closed {
            commands.push(PathCommand::Close);
        }
        commands
    };
    contours.iter().flat_map(along).collect()
}

/// An open contour is closed by a straight line for the fill, but has no stroke along that line.
#[test]
fn paths_of_open_and_closed_contours() {
    let mut random = Xorshift::new(0x0be7);
    for index in 0..32 {
        let closed = index % 4 < 2;
        let contours = random_contours(&mut random, closed);
        let (alignment, fill_rule) = (BESIDE[index % 2], RULES[index / 4 % 2]);
        let width = random.between(1, 9) as u32;
        let commands = commands(&contours, closed);
        let path = Path::new(&commands, fill_rule).unwrap();
        let ideal = areas(&in_pixels(&contours), closed, fill_rule, 2 * width, is_drawn(alignment));
        compare(
            &format!("{path:?}, {width}, {alignment:?}"),
            &path.into_styled(stroke(width, alignment).antialiased()),
            &ideal,
        );
    }
}

/// Fill and stroke over each other: the fill, up to the middle of the stroke, and the stroke over it have their exact areas. So
/// the background shows through nowhere between them, and no fill outside of the shape with a stroke inside.
#[test]
fn the_fill_reaches_to_the_middle_of_the_stroke() {
    const FILL: f64 = 120.0;
    let mut random = Xorshift::new(0xf111);
    for index in 0..24 {
        let contours = random_contours(&mut random, true);
        let (alignment, fill_rule) = (BESIDE[index % 2], RULES[index / 2 % 2]);
        let width = random.between(1, 9) as u32;
        let slices: Vec<&[SubPoint<Sub8>]> = contours.iter().map(Vec::as_slice).collect();
        let style = filled(Gray8::new(FILL as u8), width, alignment).antialiased();
        let drawn = coverage(&Polygon::new(&slices, fill_rule).into_styled(style));
        let contours = in_pixels(&contours);
        let whole_stroke = areas(&contours, true, fill_rule, 2 * width, is_drawn(alignment));
        let fill = areas(
            &contours,
            true,
            fill_rule,
            width,
            |in_shape, in_stroke| match alignment {
                StrokeAlignment::Inside => in_shape && !in_stroke,
                _ => in_shape || in_stroke,
            },
        );
        let blended = fill.iter().zip(&whole_stroke);
        let ideal: Vec<f64> = blended
            .map(|(fill, stroke)| fill * FILL / 255.0 * (1.0 - stroke) + stroke)
            .collect();
        assert_near(&format!("{slices:?}, {style:?}"), &drawn, &ideal);
    }
}

/// A stroke along rows and columns has the pixels of one that is not antialiased, whole ones.
#[test]
fn strokes_along_pixels_are_those_without_antialiasing() {
    let corners = |corners: &[(i32, i32)]| -> Vec<Point> { corners.iter().map(|&(x, y)| Point::new(x, y)).collect() };
    let outside = corners(&[(6, 7), (38, 7), (38, 20), (25, 20), (25, 36), (6, 36)]);
    let hole = corners(&[(12, 12), (12, 30), (20, 30), (20, 12)]);
    let contours = [outside.as_slice(), hole.as_slice()];
    for (alignment, width) in BESIDE
        .into_iter()
        .flat_map(|alignment| (1..5).map(move |width| (alignment, width)))
    {
        let polygon = Polygon::new(&contours, FillRule::EvenOdd);
        for fill in [None, Some(Gray8::new(90))] {
            let mut style = stroke(width, alignment);
            style.fill_color = fill;
            let aliased = polygon.prepare::<10, 12>().unwrap();
            let pixels = aliased_pixels(&aliased.into_styled(style));
            let drawn = coverage(&polygon.into_styled(style.antialiased()));
            assert_eq!(drawn, pixels, "{style:?}");
        }
    }
}

/// The levels of the area's pixels after drawing on black.
fn aliased_pixels(shape: &impl Drawable<Color = Gray8>) -> Vec<u8> {
    let mut display = MockDisplay::new();
    display.set_allow_out_of_bounds_drawing(true);
    assert!(shape.draw(&mut display).is_ok());
    let level = |pixel: Point| {
        let is_shown = pixel.x >= 0 && pixel.y >= 0;
        let color = is_shown.then(|| display.get_pixel(pixel)).flatten();
        color.map_or(0, |color| color.luma())
    };
    AREA.points().map(level).collect()
}

/// Both outlines of a layer take room: an error says how many edges they have.
#[test]
fn too_small_a_table_is_an_error_with_the_edges_of_both() {
    let triangle = [(2, 3), (30, 8), (11, 33)].map(|(x, y)| Point::new(x, y));
    let contours = [triangle.as_slice()];
    let shape =
        Polygon::new(&contours, FillRule::NonZero).into_styled(stroke(2, StrokeAlignment::Inside).antialiased());
    let mut words = vec![Gray8::BLACK.into_storage(); (SIDE * SIDE) as usize];
    let mut row = [0; SIDE as usize + 1];
    let mut band = zrow::band::Band::<Gray8>::new(AREA, &mut words).unwrap();
    let Err(DrawError::TooSmall(error)) = shape.draw_on(&mut band.antialiased::<8, 8>(&mut row)) else {
        panic!("a table of 8 edges was enough");
    };
    // Three sides of the triangle, four of each rectangle, and at most four of each join.
    assert!(matches!(error, TooSmall::Edges(15..=27)), "{error}");
    let Err(DrawError::TooSmall(error)) = shape.draw_on(&mut band.antialiased::<27, 3>(&mut row)) else {
        panic!("3 edges in a row were enough");
    };
    assert!(matches!(error, TooSmall::ActiveEdges(_)), "{error}");
    shape.draw_on(&mut band.antialiased::<27, 27>(&mut row)).unwrap();
}

/// An arc and a line with a width are filled whole, too: their strokes run around them.
#[test]
fn a_stroke_without_a_colour_is_none_around_an_arc_and_a_line() {
    let at = |(x, y): (i32, i32)| SubPoint::<Sub8>::from_units(x * 64, y * 64).unwrap();
    let pixels = U24F8::from_num;
    let arc = SubArc::new(at((80, 80)), [pixels(15), pixels(6)], U0F16::ZERO, U0F16::from_num(0.3)).unwrap();
    let line = SubLine::new(at((10, 20)), at((130, 90)), pixels(9)).unwrap();
    let circle = SubEllipse::circle(at((80, 80)), pixels(15)).unwrap();
    let fill = PrimitiveStyle::with_fill(Gray8::WHITE);
    for alignment in [
        StrokeAlignment::Inside,
        StrokeAlignment::Center,
        StrokeAlignment::Outside,
    ] {
        let mut style = filled(Gray8::WHITE, 4, alignment);
        style.stroke_color = None;
        let (style, fill) = (style.antialiased(), fill.antialiased());
        assert_eq!(coverage(&arc.into_styled(style)), coverage(&arc.into_styled(fill)));
        assert_eq!(coverage(&line.into_styled(style)), coverage(&line.into_styled(fill)));
        // Any other shape leaves the stroke out.
        let is_whole = coverage(&circle.into_styled(style)) == coverage(&circle.into_styled(fill));
        assert_eq!(is_whole, alignment == StrokeAlignment::Outside);
    }
}

/// A style without a stroke's colour draws the fill alone, as wide as the shape.
#[test]
fn a_stroke_without_a_colour_is_none() {
    let triangle = [(2, 3), (30, 8), (11, 33)].map(|(x, y)| Point::new(x, y));
    let contours = [triangle.as_slice()];
    let polygon = Polygon::new(&contours, FillRule::NonZero);
    let fill = PrimitiveStyle::with_fill(Gray8::WHITE);
    let whole = coverage(&polygon.into_styled(fill.antialiased()));
    for alignment in BESIDE {
        let mut style = filled(Gray8::WHITE, 4, alignment);
        style.stroke_color = None;
        assert_eq!(coverage(&polygon.into_styled(style.antialiased())), whole);
    }
}
