//! Shapes in antialiased styles: equal to those without antialiasing where they are to be, at sub-pixel positions, and in
//! memory of any size.

use std::convert::Infallible;

use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{Gray8, GrayColor},
    prelude::*,
    primitives::{Circle, Line, Polyline, Rectangle, StrokeAlignment, Triangle},
};
use fixed::types::{U0F16, U16F16, U24F8};
use zrow::{
    band::Band,
    draw::{
        DrawAntialiased, DrawOn, FillRule, LineCap, LineJoin, Path, PathCommand, Polygon, PrimitiveStyle, StrokeStyle,
        SubArc, SubEllipse, SubLine,
    },
    geometry::{DrawError, Sub8, SubPoint, TooSmall},
};

use crate::{
    antialiased_area::{ACTIVE, ALIGNMENTS, AREA, EDGES, SIDE, Xorshift, compare, coverage, fill, filled, stroke},
    reference::ideal_coverage::{along, degrees_from, distance, in_ellipse},
};

/// What is drawn without antialiasing.
fn aliased(shape: &impl DrawOn<Color = Gray8>) -> Vec<u8> {
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let Ok(()) = shape.draw_on(&mut band);
    words
}

/// Asserts that a shape has the same pixels with and without antialiasing.
fn assert_equals_aliased(name: &str, smooth: &impl DrawAntialiased<Color = Gray8>, hard: &impl DrawOn<Color = Gray8>) {
    for (pixel, (smooth, hard)) in AREA.points().zip(coverage(smooth).iter().zip(aliased(hard))) {
        assert_eq!(*smooth, hard, "{name}, {pixel:?}");
    }
}

#[test]
fn level_and_upright_strokes_equal_those_without_antialiasing() {
    let ends = [(4, 9), (30, 9), (4, 33), (-20, 9)].map(|(x, y)| Point::new(x, y));
    for (width, end) in (1..9).flat_map(|width| ends.map(|end| (width, end))) {
        let line = Line::new(ends[0], end);
        let style = PrimitiveStyle::with_stroke(Gray8::WHITE, width);
        let name = format!("{line:?}, {width}");
        assert_equals_aliased(&name, &line.into_styled(style.antialiased()), &line.into_styled(style));
        for cap in [LineCap::WholePixel, LineCap::Butt, LineCap::Square] {
            let style = StrokeStyle::new(Gray8::WHITE, width).cap(cap);
            let name = format!("{name}, {cap:?}");
            assert_equals_aliased(&name, &line.into_styled(style.antialiased()), &line.into_styled(style));
        }
        let vertices = [(2, 3), (30, 3), (30, 20), (9, 20), (9, 40)].map(|(x, y)| Point::new(x, y));
        let polyline = Polyline::new(&vertices);
        let style = StrokeStyle::new(Gray8::WHITE, width);
        let name = format!("polyline, {width}");
        assert_equals_aliased(
            &name,
            &polyline.into_styled(style.antialiased()),
            &polyline.into_styled(style),
        );
    }
}

#[test]
fn rectangles_equal_those_without_antialiasing() {
    let mut random = Xorshift::new(0x4ec7);
    for index in 0..60 {
        let rectangle = Rectangle::new(
            Point::new(random.between(-8, 20), random.between(-8, 20)),
            Size::new(random.between(0, 30) as u32, random.between(0, 30) as u32),
        );
        let mut style = stroke(random.between(0, 7) as u32, ALIGNMENTS[index % 3]);
        style.fill_color = (index % 2 == 0).then_some(Gray8::new(90));
        let name = format!("{rectangle:?}, {style:?}");
        assert_equals_aliased(
            &name,
            &rectangle.into_styled(style.antialiased()),
            &rectangle.into_styled(style),
        );
    }
}

/// White in white: where black shows through between fill and stroke, a pixel inside is not white.
#[test]
fn nothing_shows_between_fill_and_stroke() {
    for (width, alignment) in (2..6).flat_map(|width| ALIGNMENTS.map(|alignment| (width, alignment))) {
        let style = filled(Gray8::WHITE, width, alignment).antialiased();
        let is_inside = |around: Rectangle| {
            let beyond = f64::from(style.0.outside_stroke_width());
            move |pixel: &Point| in_ellipse(&around, beyond - 0.75, pixel.x.into(), pixel.y.into())
        };
        let circle = Circle::new(Point::new(6, 6), 29);
        let drawn = coverage(&circle.into_styled(style));
        let inside = AREA
            .points()
            .zip(drawn)
            .filter(|(pixel, _)| is_inside(circle.bounding_box())(pixel));
        for (pixel, drawn) in inside {
            assert_eq!(drawn, 255, "{style:?}, {pixel:?}");
        }
    }
}

fn at(x: i32, y: i32) -> SubPoint<Sub8> {
    SubPoint::from_units(x, y).unwrap()
}

#[test]
fn shapes_at_sub_pixel_positions() {
    let radii = [U24F8::from_num(12.3), U24F8::from_num(15.9)];
    let (x, y) = (20.0 + 77.0 / 256.0, 18.0 + 200.0 / 256.0);
    let center = at(20 * 256 + 77, 18 * 256 + 200);
    let radius = |x_: f64, y_: f64| (x_ - x).hypot(y_ - y);
    let [inner, outer] = radii.map(f64::from);
    let ring = SubArc::ring(center, radii).unwrap().into_styled(fill().antialiased());
    compare("ring", &ring, |x, y| (inner..outer).contains(&radius(x, y)));
    let arc = SubArc::new(center, radii, U0F16::from_num(0.1), U0F16::from_num(0.65)).unwrap();
    compare("arc", &arc.into_styled(fill().antialiased()), |x_, y_| {
        (inner..outer).contains(&radius(x_, y_)) && degrees_from(36.0, x_ - x, y_ - y) < 0.65 * 360.0
    });
    let disc = SubEllipse::circle(center, radii[0]).unwrap();
    compare("disc", &disc.into_styled(fill().antialiased()), |x, y| {
        radius(x, y) < inner
    });
    let style = stroke(3, StrokeAlignment::Center).antialiased();
    compare("circle", &disc.into_styled(style), |x, y| {
        (radius(x, y) - inner).abs() < 1.5
    });
    let line = SubLine::new(at(300, 500), at(9_000, 9_000), U24F8::from_num(4.5)).unwrap();
    let bar = |x: f64, y: f64, more: f64| {
        let (right, down) = (8_700.0 / 256.0, 8_500.0 / 256.0);
        let length = f64::hypot(right, down);
        let (x, y) = (x - 300.0 / 256.0, y - 500.0 / 256.0);
        let (along, across) = ((x * right + y * down) / length, (y * right - x * down) / length);
        (-along).max(along - length) < more && across.abs() < 2.25 + more
    };
    compare("line", &line.into_styled(fill().antialiased()), |x, y| bar(x, y, 0.0));
    let style = stroke(2, StrokeAlignment::Center).antialiased();
    compare("border", &line.into_styled(style), |x, y| {
        bar(x, y, 1.0) && !bar(x, y, -1.0)
    });
}

/// The stroke of a path begins and ends at its ends, whatever the cap of whole pixels is.
#[test]
fn paths_have_butt_caps() {
    let commands = [
        PathCommand::MoveTo(at(1_000, 1_500)),
        PathCommand::LineTo(at(8_000, 6_500)),
    ];
    let path = Path::new(&commands, FillRule::NonZero).unwrap();
    let line = SubLine::new(at(1_000, 1_500), at(8_000, 6_500), U24F8::from_num(3)).unwrap();
    let by_line = coverage(&line.into_styled(fill().antialiased()));
    let by_path = coverage(&path.into_styled(stroke(3, StrokeAlignment::Center).antialiased()));
    for (pixel, (line, path)) in AREA.points().zip(by_line.iter().zip(&by_path)) {
        assert!(line.abs_diff(*path) <= 2, "{pixel:?}: {line}, {path}");
    }
}

#[test]
fn polygons_have_fill_and_stroke() {
    let corners = [(3, 4), (40, 9), (12, 41)].map(|(x, y)| Point::new(x, y));
    let contours = [corners.as_slice()];
    let polygon = Polygon::new(&contours, FillRule::NonZero);
    let closed = [corners.as_slice(), &corners[..1]].concat();
    let is_inside = |x: f64, y: f64| {
        closed
            .windows(2)
            .all(|pair| along(&Line::new(pair[0], pair[1]), x, y).1 > 0.0)
    };
    compare("fill", &polygon.into_styled(fill().antialiased()), is_inside);
    let style = StrokeStyle::new(Gray8::WHITE, 3).join(LineJoin::Round).antialiased();
    compare("stroke", &polygon.into_styled(style), |x, y| {
        distance(&closed, x, y) < 1.5
    });
}

/// An error says which memory is too small and how much is needed, and nothing is drawn; with that, it is drawn.
#[test]
fn too_little_memory_is_an_error_that_says_how_much() {
    let style = filled(Gray8::new(90), 3, StrokeAlignment::Center);
    let circle = Circle::new(Point::new(2, 2), 38).into_styled(style.antialiased());
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut row = [0; SIDE as usize + 1];
    fn drawn<const EDGES: usize, const ACTIVE: usize>(
        shape: &impl DrawAntialiased<Color = Gray8>,
        words: &mut [u8],
        row: &mut [i32],
    ) -> Result<(), DrawError<Infallible>> {
        let mut band = Band::<Gray8>::new(AREA, words).unwrap();
        shape.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(row))
    }
    let too_small = |needed: TooSmall| Err(DrawError::TooSmall(needed));
    // The stroke has more edges than the fill: two circles, without the level edges of either.
    assert_eq!(
        drawn::<80, 64>(&circle, &mut words, &mut row),
        too_small(TooSmall::Edges(156))
    );
    assert_eq!(
        drawn::<155, 64>(&circle, &mut words, &mut row),
        too_small(TooSmall::Edges(156))
    );
    assert_eq!(
        drawn::<156, 1>(&circle, &mut words, &mut row),
        too_small(TooSmall::ActiveEdges(4))
    );
    assert_eq!(
        drawn::<156, 9>(&circle, &mut words, &mut row),
        too_small(TooSmall::ActiveEdges(14))
    );
    assert_eq!(
        drawn::<156, 14>(&circle, &mut words, &mut row[..48]),
        too_small(TooSmall::Cells(49))
    );
    assert!(words.iter().all(|&word| word == 0));
    assert_eq!(drawn::<156, 14>(&circle, &mut words, &mut row), Ok(()));
    assert_eq!(words, coverage(&circle));
}

/// A round shape needs room for the edges in the rows of a band alone, and has the pixels that it has at once.
#[test]
fn a_round_shape_needs_room_for_the_edges_of_a_band() {
    let style = filled(Gray8::new(90), 3, StrokeAlignment::Center);
    let circle = Circle::new(Point::new(2, 2), 38).into_styled(style.antialiased());
    let radii = [17.3, 12.8].map(U24F8::from_num);
    let arc = SubArc::new(at(4_800, 5_000), radii, U0F16::from_num(0.2), U0F16::from_num(0.6)).unwrap();
    let arc = arc.into_styled(fill().antialiased());
    fn in_bands<const EDGES: usize>(shape: &impl DrawAntialiased<Color = Gray8>, rows: usize) -> Vec<u8> {
        let mut words = vec![0; (SIDE * SIDE) as usize];
        let mut cells = [0; SIDE as usize + 1];
        for (top, words) in (AREA.top_left.y..)
            .step_by(rows)
            .zip(words.chunks_mut(rows * SIDE as usize))
        {
            let height = words.len() as u32 / SIDE;
            let area = Rectangle::new(Point::new(AREA.top_left.x, top), Size::new(SIDE, height));
            let mut band = Band::<Gray8>::new(area, words).unwrap();
            let drawn = shape.draw_on(&mut band.antialiased::<EDGES, 48>(&mut cells));
            assert_eq!(drawn, Ok(()), "{area:?}");
        }
        words
    }
    assert!(in_bands::<32>(&circle, 1) == coverage(&circle));
    assert!(in_bands::<64>(&circle, 3) == coverage(&circle));
    assert!(in_bands::<32>(&arc, 1) == coverage(&arc));
    assert!(in_bands::<64>(&arc, 5) == coverage(&arc));
}

#[test]
fn what_leaves_the_domain_is_an_error() {
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let mut row = [0; SIDE as usize + 1];
    let mut target = band.antialiased::<EDGES, ACTIVE>(&mut row);
    let far = Point::new(9_000, 10);
    let outcomes = [
        Line::new(Point::zero(), far)
            .into_styled(stroke(3, StrokeAlignment::Center).antialiased())
            .draw_on(&mut target),
        Triangle::new(Point::zero(), far, Point::new(3, 30))
            .into_styled(fill().antialiased())
            .draw_on(&mut target),
        Circle::new(Point::new(-9_000, -9_000), 18_000)
            .into_styled(fill().antialiased())
            .draw_on(&mut target),
        Rectangle::new(Point::zero(), Size::new(9_000, 20))
            .into_styled(fill().antialiased())
            .draw_on(&mut target),
    ];
    for outcome in outcomes {
        assert!(
            matches!(outcome, Err(DrawError::<Infallible>::OutOfDomain { .. })),
            "{outcome:?}"
        );
    }
    assert!(words.iter().all(|&word| word == 0));
}

/// A dash pattern far below a pixel has no room anywhere, which is found without counting dashes one by one.
#[test]
fn too_many_dashes_are_an_error() {
    let lengths = [U16F16::from_bits(1); 2];
    let style = StrokeStyle::new(Gray8::WHITE, 3).dashes(&lengths).antialiased();
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let outcome = Line::new(Point::zero(), Point::new(8_000, 9))
        .into_styled(style)
        .draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut [0; SIDE as usize + 1]));
    assert!(matches!(
        outcome,
        Err(DrawError::TooSmall(TooSmall::Edges(1_000_000..)))
    ));
}

/// Shapes in styles without antialiasing have their usual pixels on a target that can antialias.
#[test]
fn other_shapes_are_drawn_as_on_the_target_itself() {
    let mut words = vec![0; (SIDE * SIDE) as usize];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let mut row = [0; SIDE as usize + 1];
    let mut target = band.antialiased::<EDGES, ACTIVE>(&mut row);
    let circle = Circle::new(Point::new(2, 2), 30).into_styled(stroke(3, StrokeAlignment::Inside));
    let triangle = Triangle::new(Point::new(2, 40), Point::new(30, 33), Point::new(41, 3)).into_styled(fill());
    let line = Line::new(Point::new(-9, 4), Point::new(40, 44)).into_styled(stroke(1, StrokeAlignment::Center));
    let Ok(()) = circle.draw_on(&mut target);
    let Ok(()) = triangle.draw_on(&mut target);
    let Ok(()) = line.draw_on(&mut target);
    let expected = [aliased(&circle), aliased(&triangle), aliased(&line)];
    let expected: Vec<u8> = (0..words.len())
        .map(|index| expected.iter().map(|words| words[index]).max().unwrap())
        .collect();
    assert_eq!(words, expected);
}
