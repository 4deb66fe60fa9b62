//! One algorithm of a family, named when it is built, with inputs that the compiler cannot know. Without a name: nothing.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

use cortex_m_rt::entry;
use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::{Circle, Polyline, Rectangle},
};
use fixed::types::{I16F16, U8F8, U16F16};
use zrow::{
    band::{Band, PictureLoop, Span, Supersampling, Target},
    clip::{Classification, ClipMatrix, Clipper, Operation, Segments},
    coverage::{Bartlett, BoxFilter, CentreSample, CoverageMethod, Gaussian, Rooks, SamplePattern, SignedArea},
    draw::{
        AntialiasedPolygon, DrawOn, FillRule, FilteredLine, LineCap, LineJoin, PrimitiveStyle, SeedFill, StrokeStyle,
    },
    geometry::{ConvexWindow, FixedPointWindow, Sub4, Sub8, SubPoint, TooSmall, Window},
    scan::{Bezier, Polygons},
    scene::{Camera, Pose},
    shade::{ConeFilter, LinearGradient, Paint, Pattern, RadialGradient, Ramp, SampleFilter},
};
use zrow_measure_firmware::{content, report, stack};

/// Links what follows a name where that is chosen.
macro_rules! link {
    ($($name:literal => $work:expr;)+) => {$(
        if const { content::is($name) } {
            black_box($work);
        }
    )+};
}

#[entry]
fn main() -> ! {
    lines();
    round_outlines();
    curves();
    polygons();
    triangles();
    segments();
    in_space_by_each();
    clippers();
    coverage();
    samples();
    strokes();
    paints();
    sines();
    stack::report(0);
    report::exit(true)
}

/// One-pixel lines, pixel by pixel, and filtered ones.
fn lines() {
    macro_rules! walk {
        ($([$name:ident] [$($line:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (from, to, window) = black_box((Point::zero(), Point::zero(), Window::EMPTY));
                for pixel in $($line)+(from, to, &window) {
                    black_box(pixel);
                }
            }
        )+};
    }
    zrow_methods::lines!(walk);
    link! { "gupta_sproull" => filtered_line(); }
}

/// A filtered line, blended into a row.
fn filtered_line() {
    let mut words = [0; 8];
    let (area, [start, end]) = black_box((Rectangle::zero(), [SubPoint::default(); 2]));
    let (Ok(mut band), Ok(line)) = (Band::<Rgb565>::new(area, &mut words), FilteredLine::new(start, end)) else {
        return;
    };
    let Ok(()) = line.draw(&mut band, black_box(Rgb565::WHITE));
    black_box(&band);
}

/// Thin circles and ellipses, pixel by pixel.
fn round_outlines() {
    macro_rules! circles {
        ($([$name:ident] [$($circle:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (center, radius, window) = black_box((Point::zero(), 9, Window::EMPTY));
                $($circle)+(center, radius, &window).into_iter().flatten().for_each(|pixel| _ = black_box(pixel));
            }
        )+};
    }
    zrow_methods::circles!(circles);
    macro_rules! ellipses {
        ($([$name:ident] [$($ellipse:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (center, radii, window) = black_box((Point::zero(), Size::new(9, 5), Window::EMPTY));
                $($ellipse)+(center, radii, &window).into_iter().flatten().for_each(|pixel| _ = black_box(pixel));
            }
        )+};
    }
    zrow_methods::ellipses!(ellipses);
}

/// Flattening of cubic Bézier curves.
fn curves() {
    macro_rules! flatten {
        ($([$name:ident] [$($flatten:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (controls, tolerance) = black_box(([SubPoint::<Sub8>::default(); 4], U8F8::ONE));
                if let Ok(curve) = Bezier::<4>::new(controls) {
                    $($flatten)+(&curve, tolerance).for_each(|end| _ = black_box(end));
                }
            }
        )+};
    }
    zrow_methods::curves!(flatten);
}

/// A contour of 16 vertices at 1/16 pixel, a rule and a window.
fn polygon() -> ([SubPoint<Sub4>; 16], FillRule, Window) {
    black_box(([SubPoint::default(); 16], FillRule::EvenOdd, Window::EMPTY))
}

fn keep_span(span: Span) -> Result<(), ()> {
    black_box((Ok(()), span)).0
}

/// Polygons at 1/16 pixel: through tables, and pixel by pixel.
fn polygons() {
    macro_rules! fill {
        ($([$name:ident] [$($fill:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (contour, rule, window) = polygon();
                black_box($($fill)+::<_, _, 16>(&[&contour], rule, &window, keep_span).is_ok());
            }
        )+};
    }
    zrow_methods::polygon_fills!(fill);
    macro_rules! fill_by_test {
        ($([$name:ident] [$($test:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (contour, rule, window) = polygon();
                black_box(Polygons::brute_force(&[&contour], rule, &window, $($test)+, keep_span).is_ok());
            }
        )+};
    }
    zrow_methods::point_tests!(fill_by_test);
}

/// Triangles at 1/16 pixel, and three attributes of them.
fn triangles() {
    macro_rules! fill {
        ($([$name:ident] [$($fill:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (vertices, window) = black_box(([SubPoint::<Sub4>::default(); 3], Window::EMPTY));
                black_box($($fill)+(vertices, &window, keep_span).is_ok());
            }
        )+};
    }
    zrow_methods::triangles!(fill);
    macro_rules! interpolate {
        ($([$name:ident] [$($interpolate:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (corners, window) = black_box(([(SubPoint::<Sub4>::default(), [0; 3]); 3], Window::EMPTY));
                black_box($($interpolate)+(&corners, &window, |pixel, attributes| {
                    black_box((pixel, attributes));
                    Ok::<(), Infallible>(())
                }).is_ok());
            }
        )+};
    }
    zrow_methods::interpolations!(interpolate);
}

/// Segment clippers, at 1/16 pixel.
fn segments() {
    macro_rules! clip {
        ($([$name:ident] [$($clip:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                let (from, to, window) =
                    black_box((SubPoint::default(), SubPoint::default(), None::<FixedPointWindow<Sub4>>));
                black_box(window.and_then(|window| $($clip)+(from, to, &window)));
            }
        )+};
    }
    zrow_methods::segments!(clip);
}

/// Clippers in space, the set-up of the matrix included.
fn in_space_by_each() {
    macro_rules! clip {
        ($([$name:ident] [$($clip:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                in_space(|from, to, matrix| $($clip)+(from, to, matrix).map(|part| part.ends(matrix)));
            }
        )+};
    }
    zrow_methods::space_segments!(clip);
    macro_rules! clip_to_planes {
        ($([$name:ident] [$($clip:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                in_space(|from, to, matrix| {
                    $($clip)+(from, to, &matrix.planes()).map(|part| part.ends(matrix))
                });
            }
        )+};
    }
    zrow_methods::volume_segments!(clip_to_planes);
    macro_rules! clip_face {
        ($([$name:ident] [$($clip:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                in_space(|from, to, matrix| {
                    black_box($($clip)+(matrix, &[(from, [0; 2]), (to, [0; 2]), (from, [0; 2])]).len())
                });
            }
        )+};
    }
    zrow_methods::space_polygons!(clip_face);
    macro_rules! fill {
        ($([$name:ident] [$($fill:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                in_space(|from, to, matrix| {
                    let (corners, camera) = black_box(([from, to, from], None::<Camera>));
                    let corners = corners.map(|vertex| matrix.apply(vertex));
                    let fill = |camera: Camera| $($fill)+(corners, &camera, &camera.viewport(), keep_span).is_ok();
                    black_box(camera.map(fill))
                });
            }
        )+};
    }
    zrow_methods::homogeneous_triangles!(fill);
}

fn in_space<T>(clip: impl FnOnce([i16; 3], [i16; 3], &ClipMatrix) -> T) {
    let (from, to, far, camera) = black_box(([0; 3], [0; 3], I16F16::ONE, None::<Camera>));
    let matrix = camera.and_then(|camera| ClipMatrix::new(&camera, &Pose::IDENTITY, far).ok());
    black_box(matrix.map(|matrix| clip(from, to, &matrix)));
}

/// Clippers against a convex window, checking it included, against polygons, and shapes of pixels against a window.
fn clippers() {
    link! {
        "cyrus_beck" => convex(|points, window| {
            let [from, to, ..] = *points;
            black_box(Segments::cyrus_beck(from, to, window).map(|part| part.ends_within(window))).is_some()
        });
        "sutherland_hodgman_2d" => convex(|points, window| {
            black_box(window.sutherland_hodgman_2d::<16, 6>(points)).is_ok()
        });
        "circle_against_window" => {
            let (circle, window) = black_box((Circle::new(Point::zero(), 9), Window::EMPTY));
            Classification::circle_against_window(&circle, &window)
        };
        "rectangle_against_window" => {
            let (bounds, window) = black_box((Rectangle::zero(), Window::EMPTY));
            Classification::rectangle_against_window(&bounds, &window)
        };
    }
    macro_rules! boolean {
        ($([$name:ident] [$($algorithm:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                boolean(|clipper, subject, clip, operation| {
                    for contour in $($algorithm)+(clipper, subject, clip, operation).into_iter().flatten() {
                        contour.points().for_each(|point| _ = black_box(point));
                    }
                });
            }
        )+};
    }
    zrow_methods::booleans!(boolean);
}

fn convex(clip: impl FnOnce(&[SubPoint<Sub4>; 8], &ConvexWindow<'_, Sub4>) -> bool) -> bool {
    let (points, window) = black_box(([SubPoint::<Sub4>::default(); 8], [SubPoint::default(); 6]));
    ConvexWindow::new(&window).is_ok_and(|window| clip(&points, &window))
}

type Vertices<'a> = &'a [&'a [SubPoint<Sub4>]];

fn boolean(clip_by: impl FnOnce(&mut Clipper<Sub4, 64>, Vertices<'_>, Vertices<'_>, Operation)) {
    let (points, operation) = black_box(([[SubPoint::<Sub4>::default(); 8]; 2], Operation::Union));
    let [subject, clip] = &points;
    let mut clipper = Clipper::<Sub4, 64>::new();
    clip_by(&mut clipper, &[subject], &[clip], operation);
}

/// Methods of antialiasing: a polygon into a mask.
fn coverage() {
    macro_rules! cover {
        ($([$name:ident] [$($method:tt)+])+) => {$(
            if const { content::is(stringify!($name)) } {
                cover::<$($method)+>();
            }
        )+};
    }
    zrow_methods::coverage_methods!(cover);
}

fn cover<T: CoverageMethod + Default>() {
    let (corners, window) = black_box(([SubPoint::<Sub8>::default(); 4], Window::EMPTY));
    let contours = [corners.as_slice()];
    let Ok(polygon) = AntialiasedPolygon::<4, 4>::prepare(&contours, FillRule::NonZero) else {
        return;
    };
    let mut memory = [T::Cell::default(); 8];
    let covered = polygon.cover(&T::default(), &window, &mut memory, |span, coverage| {
        black_box((span, coverage));
        Ok::<_, TooSmall>(())
    });
    black_box(covered.is_ok());
}

/// A polygon through one row: blended, with several samples a pixel, or drawn larger and filtered.
fn samples() {
    link! {
        "blended_area" => through_one_row(|band, polygon| {
            polygon.draw(&SignedArea, black_box(Rgb565::WHITE), band, &mut [0; 9]).is_ok()
        });
        "multisample_4" => through_one_row(multisampled::<Rooks<4>>);
        "multisample_8" => through_one_row(multisampled::<Rooks<8>>);
        "multisample_16" => through_one_row(multisampled::<Rooks<16>>);
        "supersample_2_box" => supersampled::<2, BoxFilter>();
        "supersample_4_box" => supersampled::<4, BoxFilter>();
        "supersample_8_box" => supersampled::<8, BoxFilter>();
        "supersample_16_box" => supersampled::<16, BoxFilter>();
        "supersample_4_bartlett" => supersampled::<4, Bartlett>();
        "supersample_4_cone" => supersampled::<4, ConeFilter>();
        "supersample_4_gaussian" => supersampled::<4, Gaussian>();
    }
}

type Quadrilateral = AntialiasedPolygon<4, 4>;

fn quadrilateral() -> Option<Quadrilateral> {
    let corners = black_box([SubPoint::<Sub8>::default(); 4]);
    Quadrilateral::prepare(&[corners.as_slice()], FillRule::NonZero).ok()
}

fn keep(band: Band<'_, Rgb565>) -> Result<(), Infallible> {
    black_box(band.words());
    Ok(())
}

fn through_one_row(draw: impl Fn(&mut Band<'_, Rgb565>, &Quadrilateral) -> bool) -> Option<()> {
    let polygon = quadrilateral()?;
    let picture_loop = PictureLoop::new(black_box(Rectangle::zero()), Rgb565::BLACK);
    let drawn = picture_loop.draw(&mut [0; 8], &mut keep, |band: &mut Band<'_, Rgb565>| {
        black_box(draw(band, &polygon));
    });
    drawn.ok()
}

fn multisampled<P: SamplePattern + Default>(band: &mut Band<'_, Rgb565>, polygon: &Quadrilateral) -> bool {
    let drawn = band.multisample(P::default(), &mut [0; 128], |target| {
        polygon.draw_samples(black_box(Rgb565::WHITE), target, &mut [P::Cell::default(); 8])
    });
    matches!(drawn, Ok(Ok(())))
}

fn supersampled<const N: usize, F: SampleFilter<N>>() -> Option<()> {
    let polygon = quadrilateral()?;
    let (mut samples, mut sums) = ([0; 128], [F::Sum::default(); 128]);
    let picture = Supersampling::<Rgb565, N, F>::new(black_box(Rectangle::zero()), Rgb565::BLACK).ok()?;
    let drawn = picture.draw(&mut samples, &mut sums, &mut keep, |band: &mut Band<'_, Rgb565>| {
        // A style could stroke, too, and what strokes might be linked.
        let drawn = polygon.draw(&CentreSample, black_box(Rgb565::WHITE), band, &mut []);
        black_box(drawn.is_ok());
    });
    drawn.ok()
}

/// Strokes of a polyline on a band, with what draws the band.
fn strokes() {
    static DASHES: [U16F16; 2] = [U16F16::lit("12"), U16F16::lit("8")];
    let plain = || StrokeStyle::new(Rgb565::WHITE, black_box(5));
    let round = || plain().cap(LineCap::Round).join(LineJoin::Round);
    link! {
        "wide_stroke" => stroke(|line, band| {
            line.into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, black_box(5))).draw_on(band)
        });
        "styled_stroke" => stroke(|line, band| line.into_styled(plain()).draw_on(band));
        "round_stroke" => stroke(|line, band| line.into_styled(round()).draw_on(band));
        "dashed_stroke" => stroke(|line, band| {
            line.into_styled(plain().dashes(&DASHES)).draw_on(band)
        });
        "round_dashed_stroke" => stroke(|line, band| {
            line.into_styled(round().dashes(&DASHES)).draw_on(band)
        });
    }
}

fn stroke(draw: impl FnOnce(Polyline<'_>, &mut Band<'_, Rgb565>) -> Result<(), Infallible>) {
    let (area, mut words, vertices) = black_box((Rectangle::zero(), [0u16; 8], [Point::zero(); 4]));
    if let Ok(mut band) = Band::<Rgb565>::new(area, &mut words) {
        let Ok(()) = draw(Polyline::new(&vertices), &mut band);
        black_box(&mut words);
    }
}

const SIDE: u32 = 16;
const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(SIDE, SIDE));

/// A seed fill, or a square in a paint; the colour alone is the sibling to compare with.
fn paints() {
    let ramp = || Ramp::between(black_box(Rgb888::RED), black_box(Rgb888::GREEN));
    link! {
        "flat" => painted(|band| square().draw_on(band).ok());
        "flood_fill" => painted(|band| {
            let mut fill = SeedFill::<_, 16>::flood(band, black_box(Point::zero()), Rgb565::RED);
            fill.run(band).ok()
        });
        "pattern" => in_paint(Pattern::new(black_box(2), &[Rgb565::RED, Rgb565::BLUE]).ok());
        "linear_gradient" => in_paint(
            LinearGradient::<Rgb565, 2>::new(black_box(Point::zero()), black_box(Point::new(9, 5)), ramp()).ok()
        );
        "radial_gradient" => in_paint(
            RadialGradient::<Rgb565, 2>::new(black_box(Point::zero()), black_box(9), ramp()).ok()
        );
    }
}

fn square() -> impl DrawOn<Color = Rgb565> {
    black_box(AREA).into_styled(PrimitiveStyle::with_fill(Rgb565::RED))
}

fn in_paint(paint: Option<impl Paint<Color = Rgb565>>) -> Option<u16> {
    painted(|band| square().draw_on(&mut band.painted(paint?)).ok())
}

fn painted(draw: impl FnOnce(&mut Band<'_, Rgb565>) -> Option<()>) -> Option<u16> {
    let mut words = black_box([0; (SIDE * SIDE) as usize]);
    let mut band = Band::<Rgb565>::new(AREA, &mut words).ok()?;
    draw(&mut band)?;
    words.first().copied()
}

/// Sine and cosine of an angle.
fn sines() {
    macro_rules! sine {
        ($([$variant:ident] [$($function:tt)+] $name:literal, $bytes:literal;)+) => {$(
            if const { content::is(stringify!($variant)) } {
                black_box($($function)+(black_box(0)));
            }
        )+};
    }
    zrow_methods::trigonometry!(sine);
}
