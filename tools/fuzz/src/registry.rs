//! Every target, entered once: its name, its input, and the modules of zrow that it reaches.
//!
//! A test fails where a public module of zrow has no target here.

use crate::{
    families::{
        band, clip, coverage,
        draw::{antialiased, closed, fills, lines, polygons, strokes},
        geometry, mesh, planted,
        scan::{circles, curves, edges, fills as scan_fills, lines as scan_lines, sectors},
        scene, shade, surface, view,
    },
    target::Target,
};

/// What a run takes.
pub const TARGETS: &[Target] = &[
    Target::new::<geometry::BoundsCase>("geometry.bounds", &["geometry"]),
    Target::new::<geometry::WindowCase>("geometry.window", &["geometry"]),
    Target::new::<geometry::SubPointCase>("geometry.sub_point", &["geometry"]),
    Target::new::<geometry::ConvexWindowCase>("geometry.convex_window", &["geometry"]),
    Target::new::<surface::CallsCase>("surface.calls", &["band", "draw", "prelude", "surface"]),
    Target::new::<surface::WordsCase>("surface.words", &["surface"]),
    Target::new::<surface::SpansCase>("surface.spans", &["surface"]),
    Target::new::<view::RotationCase>("view.rotation", &["view"]),
    Target::new::<view::CameraCase>("view.camera", &["view"]),
    Target::new::<view::StorageCase>("view.storage", &["view"]),
    Target::new::<mesh::FaceSetCase>("mesh.face_set", &["mesh"]),
    Target::new::<clip::SegmentCase>(
        "clip.segment",
        &[
            "clip",
            "clip::convex",
            "clip::convex::cyrus_beck",
            "clip::segment",
            "clip::segment::cohen_sutherland",
            "clip::segment::liang_barsky",
            "clip::segment::midpoint_subdivision",
            "clip::segment::nicholl_lee_nicholl",
        ],
    ),
    Target::new::<clip::ConvexCase>(
        "clip.convex",
        &[
            "clip",
            "clip::convex",
            "clip::convex::cyrus_beck",
            "clip::convex::sutherland_hodgman_2d",
        ],
    ),
    Target::new::<clip::BooleanCase>(
        "clip.boolean",
        &[
            "clip",
            "clip::boolean",
            "clip::boolean::greiner_hormann",
            "clip::boolean::weiler_atherton",
        ],
    ),
    Target::new::<clip::PixelsCase>(
        "clip.pixels",
        &[
            "clip",
            "clip::shape",
            "clip::shape::circle_against_window",
            "clip::shape::rectangle_against_window",
        ],
    ),
    Target::new::<circles::OutlinesCase>(
        "scan.circles",
        &[
            "scan",
            "scan::round",
            "scan::round::bresenham_circle",
            "scan::round::midpoint_circle",
            "scan::round::midpoint_ellipse",
            "scan::round::parametric_circle",
            "scan::round::parametric_ellipse",
            "scan::round::square_root_circle",
            "scan::round::square_root_ellipse",
        ],
    ),
    Target::new::<scan_lines::SiblingsCase>(
        "scan.lines",
        &[
            "scan",
            "scan::line",
            "scan::line::bresenham",
            "scan::line::bresenham_runs",
            "scan::line::dda",
            "scan::line::dda_fixed",
            "scan::line::double_step",
            "scan::line::midpoint",
            "scan::line::slope_intercept",
            "scan::line::supercover",
        ],
    ),
    Target::new::<scan_lines::RunsCase>("scan.runs", &["scan", "scan::line", "scan::line::bresenham_runs"]),
    Target::new::<curves::FlattenCase>(
        "scan.flatten",
        &[
            "scan",
            "scan::curve",
            "scan::curve::adaptive_forward_difference",
            "scan::curve::bezier",
            "scan::curve::de_casteljau",
            "scan::curve::flatten",
            "scan::curve::uniform_subdivision",
        ],
    ),
    Target::new::<curves::PolynomialCase>(
        "scan.polynomial",
        &["scan", "scan::curve", "scan::curve::polynomial_forward_difference"],
    ),
    Target::new::<scan_fills::PolygonCase>(
        "scan.polygon",
        &[
            "scan",
            "scan::polygon",
            "scan::polygon::active_edge_table",
            "scan::polygon::banded_polygon",
            "scan::polygon::brute_force_fill",
            "scan::polygon::edge_table",
            "scan::polygon::naive_scanline",
            "scan::polygon::point_in_polygon",
            "scan::polygon::scanline_polygon",
        ],
    ),
    Target::new::<scan_fills::PartsCase>(
        "scan.parts",
        &[
            "scan",
            "scan::polygon",
            "scan::polygon::active_edge_table",
            "scan::polygon::scanline_polygon",
        ],
    ),
    Target::new::<scan_fills::LocateCase>(
        "scan.locate",
        &[
            "scan",
            "scan::polygon",
            "scan::polygon::point_in_polygon",
            "scan::polygon::point_in_polygon::crossing_number",
            "scan::polygon::point_in_polygon::merged_crossings",
            "scan::polygon::point_in_polygon::quadrant_arc_length",
            "scan::polygon::point_in_polygon::winding_number",
        ],
    ),
    Target::new::<scan_fills::SubTriangleCase>(
        "scan.sub_triangle",
        &[
            "scan",
            "scan::triangle",
            "scan::triangle::barycentric_triangle",
            "scan::triangle::edge_function_triangle",
            "scan::triangle::hierarchical_triangle",
            "scan::triangle::incremental_edge_triangle",
        ],
    ),
    Target::new::<scan_fills::TriangleCase>(
        "scan.triangle",
        &["scan", "scan::triangle", "scan::triangle::bresenham_triangle"],
    ),
    Target::new::<edges::EdgeCase>("scan.edge", &["scan"]),
    Target::new::<edges::SubEdgeCase>("scan.sub_edge", &["scan"]),
    Target::new::<sectors::SectorCase>("scan.sector", &["scan", "scan::round", "scan::round::plane_sector"]),
    Target::new::<coverage::MethodCase>(
        "coverage.method",
        &["coverage", "coverage::edges", "coverage::edges::row_segments"],
    ),
    Target::new::<coverage::AreaCase>("coverage.area", &["coverage"]),
    Target::new::<coverage::RowCase>("coverage.row", &["coverage"]),
    Target::new::<coverage::FilteredCase>(
        "coverage.filtered",
        &["coverage", "coverage::line", "coverage::line::gupta_sproull"],
    ),
    Target::new::<shade::BlendCase>("shade.blend", &["shade", "shade::blend"]),
    Target::new::<shade::RampCase>("shade.ramp", &["shade"]),
    Target::new::<shade::FilterCase>("shade.filter", &["coverage", "shade"]),
    Target::new::<fills::GradientCase>("shade.gradient", &["shade"]),
    Target::new::<band::MemoryCase>("band.memory", &["band"]),
    Target::new::<band::LoopCase>("band.picture_loop", &["band"]),
    Target::new::<band::OverlappingCase>("band.overlapping", &["band"]),
    Target::new::<band::SupersamplingCase>("band.supersampling", &["band", "shade"]),
    Target::new::<closed::RectangleCase>("draw.rectangle", &["draw"]),
    Target::new::<closed::RoundedRectangleCase>(
        "draw.rounded_rectangle",
        &["draw", "scan", "scan::round", "scan::round::rounded_corners"],
    ),
    Target::new::<closed::CircleCase>("draw.circle", &["draw", "scan", "scan::round", "scan::round::circle"]),
    Target::new::<closed::EllipseCase>("draw.ellipse", &["draw", "scan", "scan::round", "scan::round::ellipse"]),
    Target::new::<closed::ThinCircleCase>(
        "draw.thin_circle",
        &["draw", "scan", "scan::round", "scan::round::bresenham_circle"],
    ),
    Target::new::<closed::ArcCase>(
        "draw.arc",
        &["draw", "scan", "scan::round", "scan::round::plane_sector"],
    ),
    Target::new::<closed::SectorCase>(
        "draw.sector",
        &["draw", "scan", "scan::round", "scan::round::plane_sector"],
    ),
    Target::new::<closed::TriangleCase>(
        "draw.triangle",
        &["draw", "scan", "scan::triangle", "scan::triangle::bresenham_triangle"],
    ),
    Target::new::<lines::LineCase>(
        "draw.line",
        &[
            "draw",
            "scan",
            "scan::line",
            "scan::line::bresenham",
            "scan::line::bresenham_runs",
        ],
    ),
    Target::new::<lines::PolylineCase>(
        "draw.polyline",
        &["draw", "scan", "scan::line", "scan::line::bresenham"],
    ),
    Target::new::<lines::PointsCase>("draw.points", &["draw", "scan", "scan::round", "scan::round::circle"]),
    Target::new::<polygons::PixelPolygonCase>(
        "draw.polygon",
        &[
            "draw",
            "scan",
            "scan::polygon",
            "scan::polygon::banded_polygon",
            "scan::polygon::scanline_polygon",
        ],
    ),
    Target::new::<polygons::SubPolygonCase>(
        "draw.sub_polygon",
        &[
            "draw",
            "scan",
            "scan::polygon",
            "scan::polygon::banded_polygon",
            "scan::polygon::scanline_polygon",
        ],
    ),
    Target::new::<polygons::PathCase>(
        "draw.path",
        &[
            "draw",
            "scan",
            "scan::curve",
            "scan::curve::adaptive_forward_difference",
            "scan::curve::flatten",
        ],
    ),
    Target::new::<strokes::StrokeCase>(
        "draw.stroke",
        &[
            "draw",
            "scan::stroke",
            "scan",
            "scan::polygon",
            "scan::polygon::banded_polygon",
        ],
    ),
    Target::new::<strokes::SubStrokeCase>(
        "draw.sub_stroke",
        &["draw", "scan", "scan::polygon", "scan::polygon::banded_polygon"],
    ),
    Target::new::<antialiased::AntialiasedCase>(
        "draw.antialiased",
        &["coverage", "coverage::edges", "coverage::edges::row_segments", "draw"],
    ),
    Target::new::<antialiased::GreyCase>("draw.grey", &["coverage", "draw", "shade", "shade::blend"]),
    Target::new::<antialiased::SubShapeCase>("draw.sub_shape", &["draw"]),
    Target::new::<antialiased::FilteredLineCase>(
        "draw.filtered_line",
        &["coverage", "coverage::line", "coverage::line::gupta_sproull", "draw"],
    ),
    Target::new::<fills::SeedFillCase>("draw.seed_fill", &["draw"]),
    Target::new::<fills::PaintedCase>("draw.painted", &["draw", "shade"]),
    Target::new::<scene::FrameCase>("scene.frame", &["mesh", "scene", "view", "visible"]),
    Target::new::<scene::ModelCase>("scene.model", &["mesh", "scene", "view"]),
    Target::new::<scene::DepthCase>("visible.depth", &["scene", "visible"]),
    Target::new::<scene::AtDepthCase>("visible.at_depth", &["scene", "visible"]),
];

/// Targets with a defect, which the loop has to find; only their whole name chooses them.
const PLANTED: &[Target] = &[
    Target::new::<planted::Panic>("planted.panic", &[]),
    Target::new::<planted::Outside>("planted.outside", &[]),
    Target::new::<planted::Slow>("planted.slow", &[]),
    Target::new::<planted::Deep>("planted.deep", &[]),
];

/// The targets with one of these texts in their name, or all where there is no text.
pub fn find(texts: &[String]) -> Vec<Target> {
    let is_chosen = |target: &&Target| texts.is_empty() || texts.iter().any(|text| target.name.contains(text.as_str()));
    let planted = PLANTED
        .iter()
        .filter(|target| texts.iter().any(|text| text == target.name));
    TARGETS.iter().filter(is_chosen).chain(planted).copied().collect()
}

/// The target of that name.
pub fn named(name: &str) -> Option<Target> {
    TARGETS
        .iter()
        .chain(PLANTED)
        .find(|target| target.name == name)
        .copied()
}

/// The names of all targets that a run takes.
pub fn names() -> Vec<&'static str> {
    TARGETS.iter().map(|target| target.name).collect()
}
