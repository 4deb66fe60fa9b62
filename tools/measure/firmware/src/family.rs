//! Families of 2D shapes, each of which can be [chosen](crate::content) to be drawn alone.

use core::hint::black_box;

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, PrimitiveStyleBuilder, Rectangle, RoundedRectangle, Sector,
        StrokeAlignment, Triangle,
    },
};
use fixed::types::U16F16;
use zrow::{
    band::Band,
    coverage::{CoverageMethod, SignedArea},
    draw::{
        AntialiasedPolygon, DrawOn, FillRule, FilteredLine, LineCap, LineJoin, Path, PathCommand, Polygon,
        PrimitiveStyle, StrokeStyle, ThinCircle,
    },
    geometry::{Sub8, SubPoint},
};

use crate::{content, picture, report};

/// Draws the family that was chosen for this program into a band; all of them where none was.
pub fn draw(band: &mut Band<'_, Rgb565>) {
    macro_rules! families {
        ($($name:literal => $draw:ident),*) => {
            $(
                if const { !content::IS_ANY || content::is($name) } {
                    $draw(band);
                }
            )*
        };
    }
    families!(
        "family_rectangles" => rectangles,
        "family_ellipses" => ellipses,
        "family_arcs" => arcs,
        "family_rounded_rectangles" => rounded_rectangles,
        "family_thin_lines" => thin_lines,
        "family_triangles" => triangles,
        "family_wide_strokes" => wide_strokes,
        "family_stroke_styles" => stroke_styles,
        "family_dashes" => dashes,
        "family_polygons" => polygons,
        "family_paths" => paths,
        "family_filtered_lines" => filtered_lines,
        "family_antialiased" => antialiased
    );
}

/// The middle of the picture, which the compiler does not know.
fn center() -> Point {
    black_box(Point::new(120, 160))
}

/// Fill and stroke, of which the compiler knows nothing.
fn style(stroke_width: u32) -> PrimitiveStyle<Rgb565> {
    let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
        .stroke_color(Rgb565::CSS_WHITE)
        .stroke_width(stroke_width)
        .stroke_alignment(StrokeAlignment::Inside)
        .fill_color(Rgb565::CSS_NAVY)
        .build()
        .into();
    black_box(style)
}

/// The corners of a figure that crosses itself.
fn corners() -> [Point; 5] {
    [(-90, 40), (90, 40), (-60, -80), (0, 90), (60, -80)].map(|(x, y)| center() + Point::new(x, y))
}

fn rectangles(band: &mut Band<'_, Rgb565>) {
    let shape = Rectangle::with_center(center(), Size::new(100, 70));
    let Ok(()) = shape.into_styled(style(3)).draw_on(band);
}

fn ellipses(band: &mut Band<'_, Rgb565>) {
    let Ok(()) = Circle::with_center(center(), 101).into_styled(style(3)).draw_on(band);
    let ellipse = Ellipse::with_center(center(), Size::new(120, 80));
    let Ok(()) = ellipse.into_styled(style(3)).draw_on(band);
}

fn arcs(band: &mut Band<'_, Rgb565>) {
    let (start, sweep) = black_box((90.0.deg(), 120.0.deg()));
    let arc = Arc::with_center(center(), 101, start, sweep);
    let Ok(()) = arc.into_styled(style(3)).draw_on(band);
    let sector = Sector::with_center(center(), 61, start, sweep);
    let Ok(()) = sector.into_styled(style(3)).draw_on(band);
}

fn rounded_rectangles(band: &mut Band<'_, Rgb565>) {
    let radii = [4, 12, 20, 28].map(|radius| black_box(Size::new_equal(radius)));
    let [top_left, top_right, bottom_right, bottom_left] = radii;
    let corners = CornerRadii {
        top_left,
        top_right,
        bottom_right,
        bottom_left,
    };
    let shape = RoundedRectangle::new(Rectangle::with_center(center(), Size::new(100, 70)), corners);
    let Ok(()) = shape.into_styled(style(3)).draw_on(band);
}

fn thin_lines(band: &mut Band<'_, Rgb565>) {
    let style = PrimitiveStyle::with_stroke(Rgb565::CSS_WHITE, 1);
    let corners = corners();
    let [from, to, ..] = corners;
    let Ok(()) = Line::new(from, to).into_styled(style).draw_on(band);
    let Ok(()) = Polyline::new(&corners).into_styled(style).draw_on(band);
    let Ok(()) = ThinCircle::new(center(), 50).into_styled(style).draw_on(band);
}

fn triangles(band: &mut Band<'_, Rgb565>) {
    let [a, b, c, ..] = corners();
    // The compiler knows that the stroke is not wide, and no more.
    let mut style = style(1);
    style.stroke_width = style.stroke_width.min(1);
    let Ok(()) = Triangle::new(a, b, c).into_styled(style).draw_on(band);
}

fn wide_strokes(band: &mut Band<'_, Rgb565>) {
    let style = style(5);
    let corners = corners();
    let [a, b, c, ..] = corners;
    let Ok(()) = Line::new(a, b).into_styled(style).draw_on(band);
    let Ok(()) = Polyline::new(&corners).into_styled(style).draw_on(band);
    let Ok(()) = Triangle::new(a, b, c).into_styled(style).draw_on(band);
}

/// A stroke with round ends and corners.
fn stroke_style() -> StrokeStyle<'static, Rgb565> {
    let style = StrokeStyle::new(Rgb565::CSS_WHITE, 5);
    style.cap(black_box(LineCap::Round)).join(black_box(LineJoin::Round))
}

fn stroke_styles(band: &mut Band<'_, Rgb565>) {
    let corners = corners();
    let Ok(()) = Polyline::new(&corners).into_styled(stroke_style()).draw_on(band);
}

fn dashes(band: &mut Band<'_, Rgb565>) {
    static DASHES: [U16F16; 2] = [U16F16::lit("12"), U16F16::lit("8")];
    let style = stroke_style().dashes(black_box(&DASHES));
    let corners = corners();
    let Ok(()) = Polyline::new(&corners).into_styled(style).draw_on(band);
}

/// With a table of 8 edges on the stack.
fn polygons(band: &mut Band<'_, Rgb565>) {
    let corners = corners();
    let contours: [&[Point]; 1] = [&corners];
    let Ok(polygon) = Polygon::new(&contours, black_box(FillRule::EvenOdd)).prepare::<8, 8>() else {
        report::exit(false)
    };
    let Ok(()) = polygon.into_styled(style(3)).draw_on(band);
}

fn positions() -> [SubPoint<Sub8>; 5] {
    corners().map(|corner| SubPoint::from_pixel(corner).unwrap_or_default())
}

/// With a table of 80 edges on the stack.
fn paths(band: &mut Band<'_, Rgb565>) {
    let [a, b, c, d, e] = positions();
    let commands = black_box([
        PathCommand::MoveTo(a),
        PathCommand::LineTo(b),
        PathCommand::QuadraticTo(c, d),
        PathCommand::CubicTo(e, a, b),
        PathCommand::Close,
    ]);
    let path = Path::new(&commands, FillRule::EvenOdd).map(|path| path.prepare::<80, 8>());
    let Ok(Ok(path)) = path else { report::exit(false) };
    let Ok(()) = path.into_styled(style(3)).draw_on(band);
}

fn filtered_lines(band: &mut Band<'_, Rgb565>) {
    let [from, to, ..] = positions();
    let Ok(line) = FilteredLine::new(from, to) else {
        report::exit(false)
    };
    let Ok(()) = line.draw(band, Rgb565::CSS_WHITE);
}

/// With a table of 8 edges and a row of cells on the stack.
fn antialiased(band: &mut Band<'_, Rgb565>) {
    let corners = positions();
    let outline: [&[SubPoint<Sub8>]; 1] = [&corners];
    let Ok(polygon) = AntialiasedPolygon::<8, 8>::prepare(&outline, black_box(FillRule::NonZero)) else {
        report::exit(false)
    };
    let mut cells = [<SignedArea as CoverageMethod>::Cell::default(); picture::WIDTH + 1];
    let drawn = polygon.draw(&SignedArea, Rgb565::CSS_WHITE, band, &mut cells);
    if drawn.is_err() {
        report::exit(false)
    }
}
