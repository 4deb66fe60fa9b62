//! One algorithm of a family, named by a feature, with inputs that the compiler cannot know. Without a feature: nothing.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use zrow_measure_firmware::{report, stack};

#[entry]
fn main() -> ! {
    #[cfg(any(
        feature = "cohen_sutherland",
        feature = "liang_barsky",
        feature = "midpoint_subdivision",
        feature = "nicholl_lee_nicholl"
    ))]
    core::hint::black_box(segment::work());
    #[cfg(any(feature = "cyrus_beck", feature = "sutherland_hodgman_2d"))]
    core::hint::black_box(convex::work());
    #[cfg(any(feature = "circle_against_window", feature = "rectangle_against_window"))]
    core::hint::black_box(shape::work());
    #[cfg(any(
        feature = "bresenham",
        feature = "bresenham_runs",
        feature = "dda",
        feature = "dda_fixed",
        feature = "double_step",
        feature = "midpoint",
        feature = "slope_intercept",
        feature = "supercover"
    ))]
    core::hint::black_box(line::work());
    #[cfg(feature = "gupta_sproull")]
    filtered_line::work();
    #[cfg(any(
        feature = "signed_area",
        feature = "inside_area",
        feature = "centre_sample",
        feature = "rooks_4",
        feature = "rooks_8",
        feature = "rooks_16",
        feature = "sub_scanlines_4",
        feature = "sub_scanlines_16",
        feature = "grid_2",
        feature = "grid_4",
        feature = "grid_8",
        feature = "grid_16",
        feature = "grid_8_bartlett",
        feature = "grid_8_gaussian"
    ))]
    coverage_method::work();
    #[cfg(any(
        feature = "blended_area",
        feature = "multisample_4",
        feature = "multisample_8",
        feature = "multisample_16",
        feature = "supersample_2_box",
        feature = "supersample_4_box",
        feature = "supersample_8_box",
        feature = "supersample_16_box",
        feature = "supersample_4_bartlett",
        feature = "supersample_4_cone",
        feature = "supersample_4_gaussian"
    ))]
    core::hint::black_box(samples::work());
    #[cfg(any(
        feature = "adaptive_forward_difference",
        feature = "de_casteljau",
        feature = "uniform_subdivision"
    ))]
    core::hint::black_box(curve::work());
    #[cfg(feature = "scanline_polygon")]
    core::hint::black_box(edge_table_polygon::work());
    #[cfg(feature = "naive_scanline")]
    core::hint::black_box(naive_polygon::work());
    #[cfg(any(
        feature = "crossing_number",
        feature = "merged_crossings",
        feature = "quadrant_arc_length",
        feature = "winding_number"
    ))]
    core::hint::black_box(brute_force_polygon::work());
    #[cfg(any(
        feature = "barycentric_triangle",
        feature = "edge_function_triangle",
        feature = "hierarchical_triangle",
        feature = "incremental_edge_triangle"
    ))]
    core::hint::black_box(triangle::work());
    #[cfg(any(feature = "greiner_hormann", feature = "weiler_atherton"))]
    core::hint::black_box(boolean::work());
    #[cfg(any(
        feature = "wide_stroke",
        feature = "styled_stroke",
        feature = "round_stroke",
        feature = "dashed_stroke",
        feature = "round_dashed_stroke"
    ))]
    core::hint::black_box(stroke::work());
    #[cfg(any(
        feature = "flat",
        feature = "flood_fill",
        feature = "linear_gradient",
        feature = "pattern",
        feature = "radial_gradient"
    ))]
    core::hint::black_box(paint::work());
    stack::report(0);
    report::exit(true)
}

/// Segment clippers, at 1/16 pixel.
#[cfg(any(
    feature = "cohen_sutherland",
    feature = "liang_barsky",
    feature = "midpoint_subdivision",
    feature = "nicholl_lee_nicholl"
))]
mod segment {
    use core::hint::black_box;

    #[cfg(feature = "cohen_sutherland")]
    use zrow::clip::segment::cohen_sutherland as sibling;
    #[cfg(feature = "liang_barsky")]
    use zrow::clip::segment::liang_barsky as sibling;
    #[cfg(feature = "midpoint_subdivision")]
    use zrow::clip::segment::midpoint_subdivision as sibling;
    #[cfg(feature = "nicholl_lee_nicholl")]
    use zrow::clip::segment::nicholl_lee_nicholl as sibling;
    use zrow::geometry::{FixedPointWindow, Sub4, SubPoint};

    pub fn work() -> Option<(SubPoint<Sub4>, SubPoint<Sub4>)> {
        let (from, to, window) = black_box((SubPoint::default(), SubPoint::default(), None::<FixedPointWindow<Sub4>>));
        sibling::clip(from, to, &window?)
    }
}

/// Clippers against a convex window, at 1/16 pixel; checking the window is part of them.
#[cfg(any(feature = "cyrus_beck", feature = "sutherland_hodgman_2d"))]
mod convex {
    use core::hint::black_box;

    use zrow::geometry::{ConvexWindow, Sub4, SubPoint};

    pub fn work() -> bool {
        let (points, window) = black_box(([SubPoint::<Sub4>::default(); 8], [SubPoint::default(); 6]));
        ConvexWindow::new(&window).is_ok_and(|window| black_box(clip(&points, &window)))
    }

    #[cfg(feature = "cyrus_beck")]
    fn clip(points: &[SubPoint<Sub4>; 8], window: &ConvexWindow<'_, Sub4>) -> bool {
        let [from, to, ..] = *points;
        let part = zrow::clip::convex::cyrus_beck::clip(from, to, window);
        black_box(part.map(|part| part.ends_within(window))).is_some()
    }

    #[cfg(feature = "sutherland_hodgman_2d")]
    fn clip(points: &[SubPoint<Sub4>; 8], window: &ConvexWindow<'_, Sub4>) -> bool {
        black_box(zrow::clip::convex::sutherland_hodgman_2d::clip::<_, 16, 6>(
            points, window,
        ))
        .is_ok()
    }
}

/// Polygons against polygons, at 1/16 pixel.
#[cfg(any(feature = "greiner_hormann", feature = "weiler_atherton"))]
mod boolean {
    use core::hint::black_box;

    #[cfg(feature = "greiner_hormann")]
    use zrow::clip::boolean::greiner_hormann::{Clipper, Operation};
    #[cfg(feature = "weiler_atherton")]
    use zrow::clip::boolean::weiler_atherton::{Clipper, Operation};
    use zrow::geometry::{Sub4, SubPoint};

    pub fn work() -> bool {
        let (points, operation) = black_box(([[SubPoint::<Sub4>::default(); 8]; 2], Operation::Union));
        let [subject, clip] = &points;
        let mut clipper = Clipper::<Sub4, 64>::new();
        let Ok(clipped) = clipper.clip(&[subject], &[clip], operation) else {
            return false;
        };
        clipped
            .contours()
            .for_each(|contour| contour.points().for_each(|point| _ = black_box(point)));
        true
    }
}

/// Shapes of pixels against a window.
#[cfg(any(feature = "circle_against_window", feature = "rectangle_against_window"))]
mod shape {
    use core::hint::black_box;

    use embedded_graphics::primitives::Rectangle;
    use zrow::{clip::Visibility, geometry::Window};

    pub fn work() -> Visibility {
        let (bounds, window) = black_box((Rectangle::zero(), Window::EMPTY));
        #[cfg(feature = "circle_against_window")]
        let visibility = zrow::clip::shape::circle_against_window::classify(
            &embedded_graphics::primitives::Circle::new(bounds.top_left, bounds.size.width),
            &window,
        );
        #[cfg(feature = "rectangle_against_window")]
        let visibility = zrow::clip::shape::rectangle_against_window::classify(&bounds, &window);
        visibility
    }
}

/// One-pixel lines, pixel by pixel.
#[cfg(any(
    feature = "bresenham",
    feature = "bresenham_runs",
    feature = "dda",
    feature = "dda_fixed",
    feature = "double_step",
    feature = "midpoint",
    feature = "slope_intercept",
    feature = "supercover"
))]
mod line {
    use core::hint::black_box;

    use embedded_graphics::geometry::Point;
    use zrow::geometry::Window;
    #[cfg(feature = "bresenham")]
    use zrow::scan::line::bresenham as sibling;
    #[cfg(feature = "bresenham_runs")]
    use zrow::scan::line::bresenham_runs as sibling;
    #[cfg(feature = "dda")]
    use zrow::scan::line::dda as sibling;
    #[cfg(feature = "dda_fixed")]
    use zrow::scan::line::dda_fixed as sibling;
    #[cfg(feature = "double_step")]
    use zrow::scan::line::double_step as sibling;
    #[cfg(feature = "midpoint")]
    use zrow::scan::line::midpoint as sibling;
    #[cfg(feature = "slope_intercept")]
    use zrow::scan::line::slope_intercept as sibling;
    #[cfg(feature = "supercover")]
    use zrow::scan::line::supercover as sibling;

    pub fn work() {
        let (from, to, window) = black_box((Point::zero(), Point::zero(), Window::EMPTY));
        for pixel in sibling::line(from, to, &window).into_iter().flatten() {
            black_box(pixel);
        }
    }
}

/// Methods of antialiasing: a polygon into a mask.
#[cfg(any(
    feature = "signed_area",
    feature = "inside_area",
    feature = "centre_sample",
    feature = "rooks_4",
    feature = "rooks_8",
    feature = "rooks_16",
    feature = "sub_scanlines_4",
    feature = "sub_scanlines_16",
    feature = "grid_2",
    feature = "grid_4",
    feature = "grid_8",
    feature = "grid_16",
    feature = "grid_8_bartlett",
    feature = "grid_8_gaussian"
))]
mod coverage_method {
    use core::hint::black_box;

    use zrow::{
        band::BufferTooSmall,
        coverage::CoverageMethod,
        draw::{AntialiasedPolygon, FillRule},
        geometry::{Sub8, SubPoint, Window},
    };

    #[cfg(feature = "signed_area")]
    type Method = zrow::coverage::SignedArea;
    #[cfg(feature = "inside_area")]
    type Method = zrow::coverage::InsideArea;
    #[cfg(feature = "centre_sample")]
    type Method = zrow::coverage::CentreSample;
    #[cfg(feature = "rooks_4")]
    type Method = zrow::coverage::Rooks4;
    #[cfg(feature = "rooks_8")]
    type Method = zrow::coverage::Rooks8;
    #[cfg(feature = "rooks_16")]
    type Method = zrow::coverage::Rooks16;
    #[cfg(feature = "sub_scanlines_4")]
    type Method = zrow::coverage::SubScanlines<4>;
    #[cfg(feature = "sub_scanlines_16")]
    type Method = zrow::coverage::SubScanlines<16>;
    #[cfg(feature = "grid_2")]
    type Method = zrow::coverage::Grid<2>;
    #[cfg(feature = "grid_4")]
    type Method = zrow::coverage::Grid<4>;
    #[cfg(feature = "grid_8")]
    type Method = zrow::coverage::Grid<8>;
    #[cfg(feature = "grid_16")]
    type Method = zrow::coverage::Grid<16>;
    #[cfg(feature = "grid_8_bartlett")]
    type Method = zrow::coverage::Grid<8, zrow::coverage::Bartlett>;
    #[cfg(feature = "grid_8_gaussian")]
    type Method = zrow::coverage::Grid<8, zrow::coverage::Gaussian>;

    pub fn work() {
        let (corners, window) = black_box(([SubPoint::<Sub8>::default(); 4], Window::EMPTY));
        let contours = [corners.as_slice()];
        let Ok(polygon) = AntialiasedPolygon::<4, 4>::prepare(&contours, FillRule::NonZero) else {
            return;
        };
        let mut memory = [<Method as CoverageMethod>::Cell::default(); 8];
        let covered = polygon.cover(&Method::default(), &window, &mut memory, |span, coverage| {
            black_box((span, coverage));
            Ok::<_, BufferTooSmall>(())
        });
        black_box(covered.is_ok());
    }
}

/// A polygon through one row: blended, with several samples a pixel, or drawn larger and filtered.
#[cfg(any(
    feature = "blended_area",
    feature = "multisample_4",
    feature = "multisample_8",
    feature = "multisample_16",
    feature = "supersample_2_box",
    feature = "supersample_4_box",
    feature = "supersample_8_box",
    feature = "supersample_16_box",
    feature = "supersample_4_bartlett",
    feature = "supersample_4_cone",
    feature = "supersample_4_gaussian"
))]
mod samples {
    use core::{convert::Infallible, hint::black_box};

    use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    use zrow::{
        band::Band,
        draw::FillRule,
        geometry::{Sub8, SubPoint},
    };

    #[cfg(any(
        feature = "supersample_2_box",
        feature = "supersample_4_box",
        feature = "supersample_8_box",
        feature = "supersample_16_box",
        feature = "supersample_4_bartlett",
        feature = "supersample_4_cone",
        feature = "supersample_4_gaussian"
    ))]
    pub fn work() -> Option<()> {
        use zrow::{band::Supersampling, coverage::CentreSample, draw::AntialiasedPolygon};

        #[cfg(feature = "supersample_2_box")]
        type Picture = Supersampling<Rgb565, 2>;
        #[cfg(feature = "supersample_4_box")]
        type Picture = Supersampling<Rgb565, 4>;
        #[cfg(feature = "supersample_8_box")]
        type Picture = Supersampling<Rgb565, 8>;
        #[cfg(feature = "supersample_16_box")]
        type Picture = Supersampling<Rgb565, 16>;
        #[cfg(feature = "supersample_4_bartlett")]
        type Picture = Supersampling<Rgb565, 4, zrow::coverage::Bartlett>;
        #[cfg(feature = "supersample_4_cone")]
        type Picture = Supersampling<Rgb565, 4, zrow::shade::ConeFilter>;
        #[cfg(feature = "supersample_4_gaussian")]
        type Picture = Supersampling<Rgb565, 4, zrow::coverage::Gaussian>;

        let corners = black_box([SubPoint::<Sub8>::default(); 4]);
        let polygon = AntialiasedPolygon::<4, 4>::prepare(&[corners.as_slice()], FillRule::NonZero).ok()?;
        let (mut samples, mut sums) = ([0; 128], [0; Picture::sums_needed(8)]);
        let drawn = Picture::new(black_box(Rectangle::zero()), Rgb565::BLACK).ok()?.draw(
            &mut samples,
            &mut sums,
            &mut keep,
            |band: &mut Band<'_, Rgb565>| {
                // A style could stroke, too, and what strokes might be linked.
                let drawn = polygon.draw(&CentreSample, black_box(Rgb565::WHITE), band, &mut []);
                black_box(drawn.is_ok());
            },
        );
        drawn.ok()
    }

    #[cfg(any(
        feature = "blended_area",
        feature = "multisample_4",
        feature = "multisample_8",
        feature = "multisample_16"
    ))]
    pub fn work() -> Option<()> {
        use zrow::{band::PictureLoop, draw::AntialiasedPolygon};

        let corners = black_box([SubPoint::<Sub8>::default(); 4]);
        let polygon = AntialiasedPolygon::<4, 4>::prepare(&[corners.as_slice()], FillRule::NonZero).ok()?;
        let drawn = PictureLoop::new(black_box(Rectangle::zero()), Rgb565::BLACK).draw(
            &mut [0; 8],
            &mut keep,
            |band: &mut Band<'_, Rgb565>| {
                black_box(draw(band, &polygon));
            },
        );
        drawn.ok()
    }

    #[cfg(feature = "blended_area")]
    fn draw(band: &mut Band<'_, Rgb565>, polygon: &zrow::draw::AntialiasedPolygon<4, 4>) -> bool {
        let method = zrow::coverage::SignedArea;
        polygon.draw(&method, black_box(Rgb565::WHITE), band, &mut [0; 9]).is_ok()
    }

    #[cfg(any(feature = "multisample_4", feature = "multisample_8", feature = "multisample_16"))]
    fn draw(band: &mut Band<'_, Rgb565>, polygon: &zrow::draw::AntialiasedPolygon<4, 4>) -> bool {
        #[cfg(feature = "multisample_4")]
        use zrow::coverage::Rooks4 as Pattern;
        #[cfg(feature = "multisample_8")]
        use zrow::coverage::Rooks8 as Pattern;
        #[cfg(feature = "multisample_16")]
        use zrow::coverage::Rooks16 as Pattern;

        let drawn = band.multisample(Pattern, &mut [0; 128], |target| {
            polygon.draw_samples(black_box(Rgb565::WHITE), target, &mut [0; 8])
        });
        matches!(drawn, Ok(Ok(())))
    }

    fn keep(band: Band<'_, Rgb565>) -> Result<(), Infallible> {
        black_box(band.words());
        Ok(())
    }
}

/// Filtered lines, blended into a row.
#[cfg(feature = "gupta_sproull")]
mod filtered_line {
    use core::hint::black_box;

    use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    use zrow::{band::Band, draw::FilteredLine, geometry::SubPoint};

    pub fn work() {
        let mut words = [0; 8];
        let (area, [start, end]) = black_box((Rectangle::zero(), [SubPoint::default(); 2]));
        let (Ok(mut band), Ok(line)) = (Band::<Rgb565>::new(area, &mut words), FilteredLine::new(start, end)) else {
            return;
        };
        let Ok(()) = line.draw(&mut band, black_box(Rgb565::WHITE));
        black_box(&band);
    }
}

/// Flattening of cubic Bezier curves.
#[cfg(any(
    feature = "adaptive_forward_difference",
    feature = "de_casteljau",
    feature = "uniform_subdivision"
))]
mod curve {
    use core::hint::black_box;

    use fixed::types::U8F8;
    #[cfg(feature = "adaptive_forward_difference")]
    use zrow::scan::curve::adaptive_forward_difference as sibling;
    #[cfg(feature = "de_casteljau")]
    use zrow::scan::curve::de_casteljau as sibling;
    #[cfg(feature = "uniform_subdivision")]
    use zrow::scan::curve::uniform_subdivision as sibling;
    use zrow::{
        geometry::{Sub8, SubPoint},
        scan::curve::Cubic,
    };

    pub fn work() {
        let (controls, tolerance) = black_box(([SubPoint::<Sub8>::default(); 4], U8F8::ONE));
        let Ok(curve) = Cubic::new(controls) else { return };
        sibling::flatten(&curve, tolerance).for_each(|end| {
            black_box(end);
        });
    }
}

/// Polygons at 1/16 pixel, from an edge table.
#[cfg(feature = "scanline_polygon")]
mod edge_table_polygon {
    use core::hint::black_box;

    use heapless::Vec;
    use zrow::{
        geometry::{Sub4, SubPoint, Window},
        scan::polygon::{
            ActiveEdge, Edge, Part, edge_table,
            scanline_polygon::{self, FillRule, PartRule, Windings},
        },
    };

    pub fn work() -> Result<(), ()> {
        let (contour, window, rule) = black_box(([SubPoint::<Sub4>::default(); 16], Window::EMPTY, FillRule::EvenOdd));
        let mut edges = Vec::<Edge, 16>::new();
        let mut active = Vec::<ActiveEdge<'_, Edge>, 16>::new();
        let starts = contour.last().into_iter().chain(&contour);
        edges.extend(
            starts
                .zip(&contour)
                .filter_map(|(from, to)| Edge::new(from, to, Part::Fill)),
        );
        edge_table::sort(edges.as_mut_view());
        scanline_polygon::scan(
            &edges,
            active.as_mut_view(),
            Windings::default(),
            PartRule::fill(rule),
            &window,
            |span, _| black_box((Ok(()), span)).0,
        )
    }
}

/// Polygons at 1/16 pixel, from their vertices.
#[cfg(feature = "naive_scanline")]
mod naive_polygon {
    use core::hint::black_box;

    use heapless::Vec;
    use zrow::{
        geometry::{Sub4, SubPoint, Window},
        scan::polygon::{
            naive_scanline::{self, FillError, RowCrossing},
            scanline_polygon::FillRule,
        },
    };

    pub fn work() -> Result<(), FillError<()>> {
        let (contour, window, rule) = black_box(([SubPoint::<Sub4>::default(); 16], Window::EMPTY, FillRule::EvenOdd));
        let mut crossings = Vec::<RowCrossing, 16>::new();
        naive_scanline::fill(&[&contour], rule, &window, crossings.as_mut_view(), |span| {
            black_box((Ok(()), span)).0
        })
    }
}

/// Polygons at 1/16 pixel, pixel by pixel.
#[cfg(any(
    feature = "crossing_number",
    feature = "merged_crossings",
    feature = "quadrant_arc_length",
    feature = "winding_number"
))]
mod brute_force_polygon {
    use core::hint::black_box;

    #[cfg(feature = "crossing_number")]
    use zrow::scan::polygon::point_in_polygon::crossing_number as sibling;
    #[cfg(feature = "merged_crossings")]
    use zrow::scan::polygon::point_in_polygon::merged_crossings as sibling;
    #[cfg(feature = "quadrant_arc_length")]
    use zrow::scan::polygon::point_in_polygon::quadrant_arc_length as sibling;
    #[cfg(feature = "winding_number")]
    use zrow::scan::polygon::point_in_polygon::winding_number as sibling;
    use zrow::{
        geometry::{Sub4, SubPoint, Window},
        scan::polygon::{brute_force_fill, scanline_polygon::FillRule},
    };

    pub fn work() -> Result<(), ()> {
        let (contour, window, rule) = black_box(([SubPoint::<Sub4>::default(); 16], Window::EMPTY, FillRule::EvenOdd));
        brute_force_fill::fill(&[&contour], rule, &window, sibling::locate, |span| {
            black_box((Ok(()), span)).0
        })
    }
}

/// Triangles at 1/16 pixel.
#[cfg(any(
    feature = "barycentric_triangle",
    feature = "edge_function_triangle",
    feature = "hierarchical_triangle",
    feature = "incremental_edge_triangle"
))]
mod triangle {
    use core::hint::black_box;

    use zrow::geometry::{Sub4, SubPoint, Window};
    #[cfg(feature = "barycentric_triangle")]
    use zrow::scan::triangle::barycentric_triangle as sibling;
    #[cfg(feature = "edge_function_triangle")]
    use zrow::scan::triangle::edge_function_triangle as sibling;
    #[cfg(feature = "hierarchical_triangle")]
    use zrow::scan::triangle::hierarchical_triangle as sibling;
    #[cfg(feature = "incremental_edge_triangle")]
    use zrow::scan::triangle::incremental_edge_triangle as sibling;

    pub fn work() -> Result<(), ()> {
        let (vertices, window) = black_box(([SubPoint::<Sub4>::default(); 3], Window::EMPTY));
        sibling::fill(vertices, &window, |span| black_box((Ok(()), span)).0)
    }
}

/// Strokes of a polyline on a band, with what draws the band.
#[cfg(any(
    feature = "wide_stroke",
    feature = "styled_stroke",
    feature = "round_stroke",
    feature = "dashed_stroke",
    feature = "round_dashed_stroke"
))]
mod stroke {
    use core::hint::black_box;

    use embedded_graphics::{
        pixelcolor::Rgb565,
        prelude::*,
        primitives::{Polyline, Rectangle},
    };
    use zrow::{band::Band, draw::DrawOn};

    pub fn work() {
        let (area, mut words, vertices, width) = black_box((Rectangle::zero(), [0u16; 8], [Point::zero(); 4], 5));
        if let Ok(mut band) = Band::<Rgb565>::new(area, &mut words) {
            let Ok(()) = Polyline::new(&vertices).into_styled(style(width)).draw_on(&mut band);
            black_box(&mut words);
        }
    }

    #[cfg(feature = "wide_stroke")]
    fn style(width: u32) -> zrow::draw::PrimitiveStyle<Rgb565> {
        zrow::draw::PrimitiveStyle::with_stroke(Rgb565::WHITE, width)
    }

    #[cfg(not(feature = "wide_stroke"))]
    fn style(width: u32) -> zrow::draw::StrokeStyle<'static, Rgb565> {
        use fixed::types::U16F16;
        use zrow::draw::{DashPattern, LineCap, LineJoin, StrokeStyle};

        static DASHES: [U16F16; 2] = [U16F16::lit("12"), U16F16::lit("8")];
        let mut style = StrokeStyle::new(Rgb565::WHITE, width);
        if cfg!(any(feature = "round_stroke", feature = "round_dashed_stroke")) {
            style = style.cap(LineCap::Round).join(LineJoin::Round);
        }
        if cfg!(any(feature = "dashed_stroke", feature = "round_dashed_stroke")) {
            style = style.dashes(DashPattern::new(&DASHES));
        }
        style
    }
}

/// A seed fill, or a square in a paint; the colour alone is the sibling to compare with.
#[cfg(any(
    feature = "flat",
    feature = "flood_fill",
    feature = "linear_gradient",
    feature = "pattern",
    feature = "radial_gradient"
))]
mod paint {
    use core::hint::black_box;

    use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    use zrow::band::Band;

    const SIDE: u32 = 16;
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(SIDE, SIDE));

    pub fn work() -> Option<u16> {
        let mut words = black_box([0; (SIDE * SIDE) as usize]);
        let mut band = Band::<Rgb565>::new(AREA, &mut words).ok()?;
        draw(&mut band)?;
        words.first().copied()
    }

    #[cfg(feature = "flood_fill")]
    fn draw(band: &mut Band<'_, Rgb565>) -> Option<()> {
        use zrow::draw::{Connectivity, SeedFill};
        let mut fill = SeedFill::<_, 16>::flood(band, black_box(Point::zero()), Rgb565::RED, Connectivity::Four);
        fill.run(band).ok()
    }

    #[cfg(not(feature = "flood_fill"))]
    fn square() -> impl zrow::draw::DrawOn<Color = Rgb565> {
        let style = zrow::draw::PrimitiveStyle::with_fill(Rgb565::RED);
        black_box(AREA).into_styled(style)
    }

    #[cfg(feature = "flat")]
    fn draw(band: &mut Band<'_, Rgb565>) -> Option<()> {
        zrow::draw::DrawOn::draw_on(&square(), band).ok()
    }

    #[cfg(any(feature = "linear_gradient", feature = "pattern", feature = "radial_gradient"))]
    fn draw(band: &mut Band<'_, Rgb565>) -> Option<()> {
        let mut painted = zrow::draw::Painted::new(band, paint()?);
        zrow::draw::DrawOn::draw_on(&square(), &mut painted).ok()
    }

    #[cfg(any(feature = "linear_gradient", feature = "radial_gradient"))]
    fn ramp() -> zrow::shade::Ramp<2> {
        use embedded_graphics::pixelcolor::Rgb888;
        zrow::shade::Ramp::between(black_box(Rgb888::RED), black_box(Rgb888::GREEN))
    }

    #[cfg(feature = "linear_gradient")]
    fn paint() -> Option<zrow::shade::LinearGradient<Rgb565, 2>> {
        zrow::shade::LinearGradient::new(black_box(Point::zero()), black_box(Point::new(9, 5)), ramp()).ok()
    }

    #[cfg(feature = "radial_gradient")]
    fn paint() -> Option<zrow::shade::RadialGradient<Rgb565, 2>> {
        zrow::shade::RadialGradient::new(black_box(Point::zero()), black_box(9), ramp()).ok()
    }

    #[cfg(feature = "pattern")]
    fn paint() -> Option<zrow::shade::Pattern<'static, Rgb565>> {
        zrow::shade::Pattern::new(black_box(2), &[Rgb565::RED, Rgb565::BLUE]).ok()
    }
}
