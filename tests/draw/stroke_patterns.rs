//! Caps, joins and dashes as patterns that a reader can see.

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Polyline, Rectangle},
};
use fixed::types::{I16F16, U8F8};
use zrow::draw::{LineCap, LineJoin, StrokeStyle};

use crate::checked_strokes::{STROKE, drawn, pixels};

fn pattern(shape: impl Fn(&mut MockDisplay<Rgb565>), rows: &[&str]) {
    let mut display = MockDisplay::new();
    shape(&mut display);
    let rows: Vec<String> = rows.iter().map(|row| format!("{row:20}")).collect();
    display.assert_pattern(&rows.iter().map(String::as_str).collect::<Vec<_>>());
}

#[test]
fn caps_reach_as_far_as_they_say() {
    let line = Line::new(Point::new(3, 2), Point::new(6, 2));
    for (cap, rows) in [
        (LineCap::Butt, ["", "   RRR", "   RRR", "   RRR", ""]),
        (LineCap::WholePixel, ["", "   RRRR", "   RRRR", "   RRRR", ""]),
        (LineCap::Square, ["", "  RRRRRR", "  RRRRRR", "  RRRRRR", ""]),
        (LineCap::Round, ["", "  RRRRRR", "  RRRRRR", "  RRRRRR", ""]),
    ] {
        let style = StrokeStyle::new(STROKE, 3).cap(cap);
        pattern(|display| line.into_styled(style).draw(display).unwrap(), &rows);
    }
}

#[test]
fn a_dot_has_the_caps_of_a_level_stroke() {
    let dot = [Point::new(3, 2); 3];
    for (cap, rows) in [
        (LineCap::Butt, ["", "", "", "", ""]),
        (LineCap::WholePixel, ["   R", "   R", "   R", "   R", "   R"]),
        (LineCap::Square, [" RRRRR", " RRRRR", " RRRRR", " RRRRR", " RRRRR"]),
        (LineCap::Round, ["  RRR", " RRRRR", " RRRRR", " RRRRR", "  RRR"]),
    ] {
        let style = StrokeStyle::new(STROKE, 5).cap(cap);
        pattern(
            |display| Polyline::new(&dot).into_styled(style).draw(display).unwrap(),
            &rows,
        );
        pattern(
            |display| Line::new(dot[0], dot[1]).into_styled(style).draw(display).unwrap(),
            &rows,
        );
    }
}

#[test]
fn joins_differ_at_the_outer_side() {
    let corner = [Point::new(2, 7), Point::new(2, 2), Point::new(7, 2)];
    let limit = |ratio: f32| LineJoin::Miter {
        limit: U8F8::from_num(ratio),
    };
    let mitered = [" RRRRRR", " RRRRRR"];
    let bevelled = ["  RRRRR", " RRRRRR"];
    for (join, tops) in [
        (LineJoin::MITER, mitered),
        // A right angle has the ratio 1.4142.
        (limit(1.42), mitered),
        (limit(1.41), bevelled),
        (LineJoin::Bevel, bevelled),
        (LineJoin::Round, mitered),
    ] {
        let style = StrokeStyle::new(STROKE, 3).cap(LineCap::Butt).join(join);
        let rows = ["", tops[0], tops[1], " RRRRRR", " RRR", " RRR", " RRR"];
        pattern(
            |display| Polyline::new(&corner).into_styled(style).draw(display).unwrap(),
            &rows,
        );
    }
}

#[test]
fn a_sharp_tip_is_as_long_as_its_limit_allows() {
    // Two segments of slope 1/16: the ratio is sqrt(1 + 16^2) = 16.03, and the tip is 24.05 pixels from the corner.
    let sharp = [Point::new(-16, 30), Point::new(16, 32), Point::new(-16, 34)];
    let rightmost = |ratio: f32| {
        let join = LineJoin::Miter {
            limit: U8F8::from_num(ratio),
        };
        let drawn = drawn(Polyline::new(&sharp), StrokeStyle::new(STROKE, 3).join(join));
        drawn.iter().map(|&(x, _)| x).max()
    };
    assert_eq!(rightmost(16.0), Some(16));
    assert_eq!(rightmost(16.1), Some(40));
    assert_eq!(rightmost(255.0), Some(40));
}

fn level(style: StrokeStyle<'_, Rgb565>, row: &str) {
    let line = Line::new(Point::new(0, 0), Point::new(16, 0));
    pattern(|display| line.into_styled(style).draw(display).unwrap(), &[row]);
}

#[test]
fn patterns_repeat_and_swap() {
    let butt = StrokeStyle::new(STROKE, 1).cap(LineCap::Butt);
    for (lengths, row) in [
        (&[3, 2][..], "RRR  RRR  RRR  R"),
        (&[3], "RRR   RRR   RRR "),
        (&[1, 2, 3], "R  RRR RR   R  R"),
        (&[2, 0, 1, 3], "RRR   RRR   RRR "),
        (&[0, 1, 2, 3], " RR    RR    RR "),
        (&[4, 0], "RRRRRRRRRRRRRRRR"),
        (&[0, 4], ""),
        (&[0, 0], "RRRRRRRRRRRRRRRR"),
        (&[0], "RRRRRRRRRRRRRRRR"),
        (&[], "RRRRRRRRRRRRRRRR"),
        (&[100], "RRRRRRRRRRRRRRRR"),
    ] {
        level(butt.dashes(&pixels(lengths)), row);
    }
    let lengths = pixels(&[3, 2]);
    for (offset, row) in [
        (0, "RRR  RRR  RRR  R"),
        (1, "RR  RRR  RRR  RR"),
        (3, "  RRR  RRR  RRR "),
        (-1, " RRR  RRR  RRR  "),
        (5_000, "RRR  RRR  RRR  R"),
        (-32_768, "R  RRR  RRR  RRR"),
    ] {
        level(butt.dashes(&lengths).dash_offset(I16F16::from_num(offset)), row);
    }
}

#[test]
fn every_dash_has_caps() {
    let lengths = pixels(&[0, 6]);
    let line = Line::new(Point::new(2, 2), Point::new(16, 2));
    for (cap, rows) in [
        (LineCap::Butt, ["", "", "", "", ""]),
        (
            LineCap::WholePixel,
            ["", "  R     R     R", "  R     R     R", "  R     R     R", ""],
        ),
        (
            LineCap::Square,
            ["", " RRR   RRR   RRR", " RRR   RRR   RRR", " RRR   RRR   RRR", ""],
        ),
        (
            LineCap::Round,
            ["", " RRR   RRR   RRR", " RRR   RRR   RRR", " RRR   RRR   RRR", ""],
        ),
    ] {
        let style = StrokeStyle::new(STROKE, 3).cap(cap).dashes(&lengths);
        pattern(|display| line.into_styled(style).draw(display).unwrap(), &rows);
    }
}

#[test]
fn dashes_go_on_behind_corners_and_around_closed_paths() {
    let square = Rectangle::new(Point::new(1, 1), Size::new(8, 6));
    // 7 + 5 + 7 + 5 pixels around: four cycles of 6, and none begins at a corner but the first.
    let lengths = pixels(&[4, 2]);
    let style = StrokeStyle::new(STROKE, 1).cap(LineCap::Butt).dashes(&lengths);
    pattern(
        |display| square.into_styled(style).draw(display).unwrap(),
        &[
            "         ",
            " RRRR  RR",
            "        R",
            " R      R",
            " R       ",
            " R       ",
            " R  RRRR",
        ],
    );
    // Two pixels into the first dash: it is joined with what comes back.
    let style = style.dash_offset(I16F16::from_num(2));
    pattern(
        |display| square.into_styled(style).draw(display).unwrap(),
        &["", " RR  RRRR", " R", "", "        R", " R      R", " RRR  RRR"],
    );
}

#[test]
fn a_dash_that_ends_at_a_corner_has_its_cap_there() {
    let corner = [Point::new(2, 2), Point::new(8, 2), Point::new(8, 8)];
    let lengths = pixels(&[6, 3]);
    let style = StrokeStyle::new(STROKE, 3).dashes(&lengths);
    let draw = |cap: LineCap, rows: &[&str]| {
        let styled = Polyline::new(&corner).into_styled(style.cap(cap));
        pattern(|display| styled.draw(display).unwrap(), rows);
    };
    let (level, upright) = (" RRRRRRRRR", "       RRR");
    let rows = [
        "", level, level, level, upright, upright, upright, upright, upright, upright,
    ];
    draw(LineCap::Square, &rows);
    let level = "  RRRRRR";
    let rows = ["", level, level, level, "", upright, upright, upright];
    draw(LineCap::Butt, &rows);
}
