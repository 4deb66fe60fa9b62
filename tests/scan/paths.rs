//! Paths of lines and curves, against the polygons and polylines of what their curves are flattened to.

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Rgb565},
    prelude::*,
    primitives::{Polyline, PrimitiveStyleBuilder, Rectangle, StyledDimensions},
};
use fixed::types::U8F8;
use proptest::prelude::*;
use zrow::{
    draw::{DrawOn, FillRule, Path, PathCommand, Polygon, PrimitiveStyle},
    geometry::{Sub4, Sub8, SubPixel, SubPoint, TooSmall},
    scan::Bezier,
};

use crate::common::{self, cases, config, encloses, in_bands_and_whole, painted};
use crate::curves::{FINE, Position, control, is_near, rounded_point, tolerance};

/// A command in units, to be made at either precision.
#[derive(Debug, Copy, Clone)]
enum Command {
    Move((i32, i32)),
    Line((i32, i32)),
    Quadratic([(i32, i32); 2]),
    Cubic([(i32, i32); 3]),
    Close,
}

/// The ends of the straight lines of a contour, and whether it is closed.
type Contour = (Vec<SubPoint<Sub8>>, bool);

fn command<S: SubPixel>(command: &Command) -> PathCommand<S> {
    let at = |(x, y): (i32, i32)| SubPoint::from_units(x, y).unwrap();
    match *command {
        Command::Move(to) => PathCommand::MoveTo(at(to)),
        Command::Line(to) => PathCommand::LineTo(at(to)),
        Command::Quadratic([control, to]) => PathCommand::QuadraticTo(at(control), at(to)),
        Command::Cubic([one, other, to]) => PathCommand::CubicTo(at(one), at(other), at(to)),
        Command::Close => PathCommand::Close,
    }
}

/// The contours that a path of 1/256 pixel has, by the sibling that halves.
fn contours(commands: &[Command], tolerance: U8F8) -> Vec<Contour> {
    let at = |(x, y): (i32, i32)| SubPoint::<Sub8>::from_units(x, y).unwrap();
    let mut contours = vec![(vec![at((0, 0))], false)];
    for command in commands {
        let (points, closed) = contours.last_mut().unwrap();
        let from = *points.last().unwrap();
        match *command {
            Command::Move(to) => contours.push((vec![at(to)], false)),
            Command::Line(to) => points.push(at(to)),
            Command::Quadratic([control, to]) => {
                let curve = Bezier::new([from, at(control), at(to)]).unwrap();
                points.extend(Bezier::de_casteljau(&curve, tolerance));
            }
            Command::Cubic([one, other, to]) => {
                let curve = Bezier::new([from, at(one), at(other), at(to)]).unwrap();
                points.extend(Bezier::de_casteljau(&curve, tolerance));
            }
            Command::Close => {
                *closed = true;
                let begins = vec![points[0]];
                contours.push((begins, false));
            }
        }
    }
    contours.retain(|(points, closed)| points.len() > 1 || *closed);
    contours
}

const EDGES: usize = 2000;

fn window() -> Rectangle {
    Rectangle::new(Point::new(-3, 5), Size::new(60, 44))
}

/// The fill is that of the polygon of the same lines, the thin stroke that of their polylines, the wide one that of closed
/// polygons and open polylines; each inside its bounding box.
fn check_path(commands: &[Command], tolerance: u16, window: Rectangle) {
    let tolerance = U8F8::from_bits(tolerance);
    let path: Vec<PathCommand<Sub8>> = commands.iter().map(command).collect();
    let contours = contours(commands, tolerance);
    let points: Vec<&[SubPoint<Sub8>]> = contours.iter().map(|(points, _)| points.as_slice()).collect();
    for rule in [FillRule::EvenOdd, FillRule::NonZero] {
        let path = Path::new(&path, rule).unwrap().with_tolerance(tolerance);
        let prepared = path.prepare::<EDGES, EDGES>().unwrap();
        let polygon = Polygon::new(&points, rule).prepare::<EDGES, EDGES>().unwrap();
        assert_eq!(prepared.edge_count(), polygon.edge_count());
        let fill = PrimitiveStyle::with_fill(Rgb565::WHITE);
        let bounds = prepared.bounding_box();
        let filled = in_bands_and_whole(&prepared.into_styled(fill), window);
        let expected = painted(window, |band| {
            let Ok(()) = polygon.into_styled(fill).draw_on(band);
        });
        assert_eq!(filled, expected, "{rule:?} {commands:?}");
        assert!(
            filled.iter().all(|&pixel| encloses(&bounds, pixel)),
            "{commands:?}, {bounds:?}"
        );
    }
    let path = Path::new(&path, FillRule::NonZero).unwrap().with_tolerance(tolerance);
    for width in [1, 2, 5] {
        let stroke = PrimitiveStyle::with_stroke(Rgb565::WHITE, width);
        let bounds = path.styled_bounding_box(&stroke);
        let stroked = in_bands_and_whole(&path.into_styled(stroke), window);
        let expected = painted(window, |band| {
            for (points, closed) in &contours {
                draw_stroke(points, *closed, stroke, band);
            }
        });
        assert_eq!(stroked, expected, "width {width}, {commands:?}");
        assert!(
            stroked.iter().all(|&pixel| encloses(&bounds, pixel)),
            "{commands:?}, {bounds:?}"
        );
    }
}

fn pixel(point: &SubPoint<Sub8>) -> Point {
    Point::new(
        (point.x_units() + 128).div_euclid(256),
        (point.y_units() + 128).div_euclid(256),
    )
}

/// The stroke of a contour through other entry points: a thin one as a polyline, a closed wide one as a polygon. What is left, an
/// open wide one, is compared where its vertices are pixels: see [`an_open_path_of_pixels_is_a_polyline`].
fn draw_stroke(
    points: &[SubPoint<Sub8>],
    closed: bool,
    stroke: PrimitiveStyle<Rgb565>,
    band: &mut zrow::band::Band<'_, Rgb565>,
) {
    if stroke.stroke_width == 1 {
        let mut pixels: Vec<Point> = points.iter().map(pixel).collect();
        if closed {
            pixels.push(pixels[0]);
        }
        let Ok(()) = Polyline::new(&pixels).into_styled(stroke).draw_on(band);
    } else if closed {
        let contours = [points];
        let polygon = Polygon::new(&contours, FillRule::NonZero)
            .prepare::<EDGES, EDGES>()
            .unwrap();
        let Ok(()) = polygon.into_styled(stroke).draw_on(band);
    } else {
        let commands: Vec<PathCommand<Sub8>> = points
            .iter()
            .enumerate()
            .map(|(index, &point)| match index {
                0 => PathCommand::MoveTo(point),
                _ => PathCommand::LineTo(point),
            })
            .collect();
        let path = Path::new(&commands, FillRule::NonZero).unwrap();
        let Ok(()) = path.into_styled(stroke).draw_on(band);
    }
}

fn commands(least: i32, most: i32) -> impl Strategy<Value = Vec<Command>> {
    let point = move || control(least, most);
    let command = prop_oneof![
        2 => point().prop_map(Command::Move),
        3 => point().prop_map(Command::Line),
        3 => [point(), point()].prop_map(Command::Quadratic),
        3 => [point(), point(), point()].prop_map(Command::Cubic),
        2 => Just(Command::Close),
    ];
    prop::collection::vec(command, 0..12)
}

proptest! {
    #![proptest_config(config(cases(15, 120)))]

    #[test]
    fn paths_are_what_is_made_of_their_lines(commands in commands(-1500, 14_000), tolerance in tolerance()) {
        check_path(&commands, tolerance, window());
    }

    #[test]
    fn an_open_path_of_pixels_is_a_polyline(points in prop::collection::vec((-10..60i32, -10..60i32), 2..8), width in 1..7u32) {
        let pixels: Vec<Point> = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let to = |pixel: &Point| PathCommand::LineTo(SubPoint::<Sub4>::from_pixel(*pixel).unwrap());
        let mut commands: Vec<_> = pixels.iter().map(to).collect();
        commands[0] = PathCommand::MoveTo(SubPoint::from_pixel(pixels[0]).unwrap());
        let path = Path::new(&commands, FillRule::EvenOdd).unwrap();
        let stroke = PrimitiveStyle::with_stroke(Rgb565::WHITE, width);
        let expected = painted(window(), |band| {
            let Ok(()) = Polyline::new(&pixels).into_styled(stroke).draw_on(band);
        });
        prop_assert_eq!(in_bands_and_whole(&path.into_styled(stroke), window()), expected);
    }

    #[test]
    fn both_precisions_fill_alike(commands in commands(-100, 900), tolerance in tolerance()) {
        let coarse: Vec<PathCommand<Sub4>> = commands.iter().map(command).collect();
        let finer = |(x, y)| (16 * x, 16 * y);
        let fine: Vec<PathCommand<Sub8>> = commands
            .iter()
            .map(|coarse| match *coarse {
                Command::Move(to) => Command::Move(finer(to)),
                Command::Line(to) => Command::Line(finer(to)),
                Command::Quadratic(points) => Command::Quadratic(points.map(finer)),
                Command::Cubic(points) => Command::Cubic(points.map(finer)),
                Command::Close => Command::Close,
            })
            .map(|fine| command(&fine))
            .collect();
        let tolerance = U8F8::from_bits(tolerance);
        let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new().fill_color(Rgb565::RED).stroke_color(Rgb565::WHITE).stroke_width(1).build().into();
        let coarse = Path::new(&coarse, FillRule::EvenOdd).unwrap().with_tolerance(tolerance).prepare::<EDGES, EDGES>().unwrap();
        let fine = Path::new(&fine, FillRule::EvenOdd).unwrap().with_tolerance(tolerance).prepare::<EDGES, EDGES>().unwrap();
        prop_assert_eq!(coarse.bounding_box(), fine.bounding_box());
        let draw = |drawable: &dyn Fn(&mut zrow::band::Band<'_, Rgb565>)| common::picture(window(), drawable);
        prop_assert_eq!(
            draw(&|band| { let Ok(()) = coarse.into_styled(style).draw_on(band); }),
            draw(&|band| { let Ok(()) = fine.into_styled(style).draw_on(band); })
        );
    }

    #[test]
    fn the_thin_stroke_of_a_curve_is_near_it(controls in prop::collection::vec(control(-1500, 14_000), 4), tolerance in 2..400u16) {
        let command = [
            Command::Move(controls[0]),
            Command::Cubic([controls[1], controls[2], controls[3]]),
        ];
        let commands = command.map(|it| self::command::<Sub8>(&it));
        let path = Path::new(&commands, FillRule::EvenOdd).unwrap().with_tolerance(U8F8::from_bits(tolerance));
        let area = Rectangle::new(Point::new(-8, -8), Size::new(72, 72));
        let pixels = painted(area, |band| {
            let Ok(()) = path.into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1)).draw_on(band);
        });
        let curve: Vec<Position> = (0..=512).map(|step| rounded_point(&controls, step, 512, FINE)).collect();
        // The ends of a line move by sqrt(1/2) pixel at most to their pixels, and it by 1/2 pixel to its own.
        let most = (i128::from(tolerance) + 182 + 128 + 1) * FINE;
        let mut found = 0;
        for pixel in pixels {
            let centre = (i128::from(pixel.x) * 256 * FINE, i128::from(pixel.y) * 256 * FINE);
            assert!(is_near(centre, &curve, most, &mut found), "{controls:?}, {pixel:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(12))]

    #[test]
    fn paths_of_the_whole_domain_are_what_is_made_of_their_lines(commands in commands(Sub8::MIN_UNITS, Sub8::MAX_UNITS), tolerance in 16..300u16) {
        check_path(&commands, tolerance, window());
    }
}

/// A circle of four cubics, from its rightmost point on, in 1/256 pixel.
fn circle(center: (i32, i32), radius: i32) -> [Command; 6] {
    // 4/3 (sqrt(2) - 1) of the radius.
    let handle = (f64::from(radius) * 0.552_284_749_830_793_4).round() as i32;
    let at = |x: i32, y: i32| (center.0 + x, center.1 + y);
    let (r, h) = (radius, handle);
    [
        Command::Move(at(r, 0)),
        Command::Cubic([at(r, h), at(h, r), at(0, r)]),
        Command::Cubic([at(-h, r), at(-r, h), at(-r, 0)]),
        Command::Cubic([at(-r, -h), at(-h, -r), at(0, -r)]),
        Command::Cubic([at(h, -r), at(r, -h), at(r, 0)]),
        Command::Close,
    ]
}

#[test]
fn a_circle_of_four_cubics_is_a_circle_within_its_error() {
    let mut off_by = 0.0f64;
    for radius in [256, 1000, 5000, 12_800, 25_600] {
        for tolerance in [2u16, 8, 32] {
            let outline = contours(&circle((0, 0), radius), U8F8::from_bits(tolerance));
            // The cubics are up to 2.73/10,000 of the radius outside the circle; their handles are rounded by half a unit
            // each way, of which 3/4 show at most. Lines are inside the cubics by the tolerance.
            let outside = f64::from(radius) * 2.73e-4 + 0.75 * 0.708 + f64::from(tolerance);
            let inside = 0.75 * 0.708 + f64::from(tolerance);
            for pair in outline[0].0.windows(2) {
                for part in 0..=8 {
                    let between = |from: i32, to: i32| f64::from(from) + f64::from(to - from) * f64::from(part) / 8.0;
                    let x = between(pair[0].x_units(), pair[1].x_units());
                    let y = between(pair[0].y_units(), pair[1].y_units());
                    let error = x.hypot(y) - f64::from(radius);
                    assert!(-inside <= error && error <= outside, "{radius} {tolerance}: {error}");
                    off_by = off_by.max(error.abs() / outside);
                }
            }
        }
    }
    println!("circles of four cubics: up to {off_by:.2} of the allowed error");
    // Pixels: whoever is clearly inside or outside the circle is inside or outside the path.
    let (center, radius) = ((30 * 256 + 77, 28 * 256 - 31), 22 * 256);
    let commands = circle(center, radius).map(|it| command::<Sub8>(&it));
    let path = Path::new(&commands, FillRule::NonZero)
        .unwrap()
        .prepare::<200, 4>()
        .unwrap();
    let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    let filled = painted(area, |band| {
        let Ok(()) = path.into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE)).draw_on(band);
    });
    for pixel in area.points() {
        let distance = f64::from(pixel.x * 256 - center.0).hypot(f64::from(pixel.y * 256 - center.1));
        if (distance - f64::from(radius)).abs() > 34.1 {
            assert_eq!(filled.contains(&pixel), distance < f64::from(radius), "{pixel:?}");
        }
    }
}

#[test]
fn a_path_that_does_not_fit_says_what_is_needed() {
    let commands = circle((9000, 9000), 8000).map(|it| command::<Sub8>(&it));
    let path = Path::new(&commands, FillRule::EvenOdd).unwrap();
    let needed = path.prepare::<3, 3>().unwrap_err();
    assert!(matches!(needed, TooSmall::Edges(_)));
    let Ok(enough) = path.prepare::<100, 2>() else {
        panic!("{needed}")
    };
    assert_eq!(enough.edge_count(), needed.needed());
    assert_eq!(path.prepare::<100, 1>().unwrap_err(), TooSmall::ActiveEdges(2));
}

#[test]
fn paths_of_nothing_draw_nothing() {
    let at = |x, y| SubPoint::<Sub4>::from_units(x, y).unwrap();
    let paths: [&[PathCommand<Sub4>]; 6] = [
        &[],
        &[PathCommand::MoveTo(at(80, 80))],
        &[PathCommand::MoveTo(at(80, 80)), PathCommand::MoveTo(at(160, 80))],
        &[PathCommand::LineTo(at(0, 0))],
        &[PathCommand::MoveTo(at(80, 80)), PathCommand::LineTo(at(160, 160))],
        &[
            PathCommand::MoveTo(at(80, 80)),
            PathCommand::CubicTo(at(80, 80), at(80, 80), at(80, 80)),
        ],
    ];
    for commands in paths {
        let path = Path::new(commands, FillRule::NonZero)
            .unwrap()
            .prepare::<8, 8>()
            .unwrap();
        let mut display = MockDisplay::new();
        path.into_styled(PrimitiveStyle::with_fill(BinaryColor::On))
            .draw(&mut display)
            .unwrap();
        display.assert_eq(&MockDisplay::new());
    }
    // A stroke has a dot where a line has no length, but none where there is no line.
    let strokes = paths.map(|commands| {
        painted(window(), |band| {
            let path = Path::new(commands, FillRule::NonZero).unwrap();
            let Ok(()) = path
                .into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1))
                .draw_on(band);
        })
    });
    assert_eq!(strokes[..4], [const { Vec::new() }; 4]);
    assert_eq!(strokes[4].len(), 6);
    assert_eq!(strokes[5], [Point::new(5, 5)]);
}

#[test]
fn draw_on_and_draw_are_equal_for_styled_paths() {
    let commands = circle((8000, 8000), 6000).map(|it| command::<Sub8>(&it));
    let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
        .fill_color(Rgb565::RED)
        .stroke_color(Rgb565::WHITE)
        .stroke_width(3)
        .build()
        .into();
    let path = Path::new(&commands, FillRule::EvenOdd)
        .unwrap()
        .prepare::<100, 2>()
        .unwrap();
    let styled = path.into_styled(style);
    let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    let fast = common::picture(area, |band| {
        let Ok(()) = styled.draw_on(band);
    });
    let general = common::picture(area, |band| {
        let Ok(()) = styled.draw(band);
    });
    assert_eq!(fast, general);
    assert!(fast.contains(&Rgb565::RED) && fast.contains(&Rgb565::WHITE));
}

#[test]
fn paths_outside_the_domain_are_refused() {
    let far = SubPoint::<Sub8> {
        x: fixed::types::I24F8::MIN,
        y: fixed::types::I24F8::MAX,
    };
    let near = SubPoint::default();
    for command in [
        PathCommand::MoveTo(far),
        PathCommand::LineTo(far),
        PathCommand::QuadraticTo(far, near),
        PathCommand::CubicTo(near, far, near),
    ] {
        assert!(Path::new(&[PathCommand::MoveTo(near), command], FillRule::EvenOdd).is_err());
    }
}
