//! Bands far from what is drawn: wherever fixed-point coordinates would wrap around, nothing shows.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, Ellipse, Line, Polyline, PrimitiveStyleBuilder, Rectangle, RoundedRectangle, Sector, Triangle,
    },
};
use zrow::{
    band::Band,
    coverage::{CentreSample, Grid, InsideArea, Rooks, SignedArea, SubScanlines},
    draw::{
        AntialiasedPolygon, DrawOn, FillRule, FilteredLine, LineCap, LineJoin, Path, PathCommand, Points, Polygon,
        PrimitiveStyle, StrokeStyle, ThinCircle,
    },
    geometry::{Sub8, SubPoint},
};

use crate::common::painted;

/// Nine columns and three rows, at every distance whose bits a shift or a product could lose.
fn bands() -> impl Iterator<Item = Rectangle> {
    let near = [-4, 0, 20];
    let far: Vec<i32> = (14..31)
        .flat_map(|bits| [1 << bits, -1 << bits, i32::MIN + (1 << bits)])
        .collect();
    let aside: Vec<Point> = far
        .iter()
        .flat_map(|&far| near.map(|near| [Point::new(far, near), Point::new(near, far)]))
        .flatten()
        .collect();
    aside.into_iter().map(|corner| Rectangle::new(corner, Size::new(9, 3)))
}

fn check(name: &str, draw: impl Fn(&mut Band<'_, Rgb565>)) {
    // Not in vain: here it is.
    let here = painted(Rectangle::new(Point::new(-20, -20), Size::new(80, 80)), &draw);
    assert!(here.len() > 20, "{name}");
    for band in bands() {
        let drawn = painted(band, &draw);
        assert!(drawn.is_empty(), "{name} in {band:?}: {drawn:?}");
    }
}

const RED: Rgb565 = Rgb565::RED;

fn styles() -> [(&'static str, PrimitiveStyle<Rgb565>); 4] {
    let both = PrimitiveStyleBuilder::new().fill_color(RED).stroke_color(RED);
    [
        ("filled", PrimitiveStyle::with_fill(RED)),
        ("thin", PrimitiveStyle::with_stroke(RED, 1)),
        ("wide", PrimitiveStyle::with_stroke(RED, 5)),
        ("both", both.stroke_width(3).build().into()),
    ]
}

#[test]
fn shapes_of_embedded_graphics() {
    macro_rules! shapes {
        ($($shape:expr),+) => { $(
            for (name, style) in styles() {
                let lines = ["Line", "Polyline", "Arc"];
                let shape = $shape;
                let name = format!("{} {name}", stringify!($shape));
                if name.ends_with("filled") && lines.iter().any(|line| name.starts_with(line)) {
                    continue;
                }
                let styled = shape.into_styled(style);
                check(&name, |band| {
                    let Ok(()) = styled.draw_on(band);
                });
                check(&name, |band| {
                    let Ok(()) = styled.draw(band);
                });
            }
        )+ };
    }
    let vertices = [Point::new(1, 2), Point::new(30, 9), Point::new(8, 33)];
    shapes!(
        Line::new(Point::new(1, 2), Point::new(40, 21)),
        Polyline::new(&vertices),
        Rectangle::new(Point::new(0, 0), Size::new(30, 20)),
        Circle::new(Point::new(0, 0), 31),
        Ellipse::new(Point::new(0, 0), Size::new(31, 20)),
        RoundedRectangle::with_equal_corners(Rectangle::new(Point::new(0, 0), Size::new(30, 20)), Size::new(5, 6)),
        Triangle::new(Point::new(1, 2), Point::new(30, 9), Point::new(8, 33)),
        Arc::new(Point::new(0, 0), 31, 10.0.deg(), 200.0.deg()),
        Sector::new(Point::new(0, 0), 31, 10.0.deg(), 200.0.deg())
    );
}

fn corners() -> [SubPoint<Sub8>; 3] {
    [(0, 0), (7_700, 2_300), (2_100, 8_000)].map(|(x, y)| SubPoint::from_units(x, y).unwrap())
}

#[test]
fn shapes_of_its_own() {
    let corners = corners();
    let contours = [corners.as_slice()];
    let polygon = Polygon::new(&contours, FillRule::NonZero).prepare::<8, 8>().unwrap();
    let commands = [
        PathCommand::MoveTo(corners[0]),
        PathCommand::QuadraticTo(corners[1], corners[2]),
        PathCommand::Close,
    ];
    let path = Path::new(&commands, FillRule::NonZero).unwrap();
    let prepared = path.prepare::<64, 8>().unwrap();
    let centers = [Point::new(3, 3), Point::new(20, 20)];
    for (name, style) in styles() {
        check(&format!("polygon {name}"), |band| {
            let Ok(()) = polygon.clone().into_styled(style).draw_on(band);
        });
        check(&format!("path {name}"), |band| {
            let Ok(()) = prepared.into_styled(style).draw_on(band);
        });
        if name == "filled" {
            for points in [Points::squares(&centers, 3), Points::discs(&centers, 3)] {
                check("points", |band| {
                    let Ok(()) = points.into_styled(style).draw_on(band);
                });
            }
        }
    }
    check("thin circle", |band| {
        let Ok(()) = ThinCircle::new(Point::new(15, 15), 12)
            .into_styled(PrimitiveStyle::with_stroke(RED, 1))
            .draw_on(band);
    });
    let lengths = [6, 4].map(|pixels| fixed::types::U16F16::from_num(pixels));
    for cap in [LineCap::Butt, LineCap::WholePixel, LineCap::Square, LineCap::Round] {
        for join in [LineJoin::MITER, LineJoin::Round, LineJoin::Bevel] {
            let style = StrokeStyle::new(RED, 4).cap(cap).join(join);
            for style in [style, style.dashes(&lengths)] {
                check(&format!("{style:?}"), |band| {
                    let Ok(()) = path.into_styled(style).draw_on(band);
                });
            }
        }
    }
}

#[test]
fn shapes_with_soft_edges() {
    let [start, end, third] = corners();
    let line = FilteredLine::new(start, end).unwrap();
    check("filtered line", |band| {
        let Ok(()) = line.draw(band, RED);
    });
    let contour = [start, end, third];
    let polygon = AntialiasedPolygon::<8, 8>::prepare(&[contour.as_slice()], FillRule::NonZero).unwrap();
    macro_rules! methods {
        ($($method:expr, $cell:ty);+) => { $(
            check(stringify!($method), |band| polygon.draw(&$method, RED, band, &mut [<$cell>::default(); 81]).unwrap());
        )+ };
    }
    methods!(CentreSample, (); Rooks::<4>, u8; Rooks::<8>, u8; SubScanlines::<4>, i16; Grid::<4>::new(), i16; SignedArea, i32; InsideArea, i32);
}
