//! Every target, entered once: its name, its input, and the modules and families of algorithms of zrow that it reaches.
//!
//! A test fails where a public module or a family has no target here.

use crate::{
    families::{
        band, clip, coverage, depth_state,
        draw::{antialiased, closed, fills, lines, outline_texts, pictures, polygons, strokes, styles, texts},
        geometry, hidden_lines, mesh, planted,
        scan::{circles, curves, fills as scan_fills, lines as scan_lines},
        scene, shade, shading, space, surface, view, visible,
    },
    target::Target,
};

/// What a run takes.
pub const TARGETS: &[Target] = &[
    Target::new::<geometry::WindowCase>("geometry.window", &["geometry"]),
    Target::new::<geometry::SubPointCase>("geometry.sub_point", &["geometry"]),
    Target::new::<geometry::ConvexWindowCase>("geometry.convex_window", &["geometry"]),
    Target::new::<surface::CallsCase>("surface.calls", &["band", "draw", "prelude", "scan"]),
    Target::new::<surface::WordsCase>("surface.words", &["band"]),
    Target::new::<surface::SpansCase>("surface.spans", &["band"]),
    Target::new::<view::RotationCase>("view.rotation", &["scene"]),
    Target::new::<view::AffineCase>("view.affine", &["scene"]),
    Target::new::<view::CameraCase>("view.camera", &["scene"]),
    Target::new::<view::StorageCase>("view.storage", &["scene"]),
    Target::new::<mesh::FaceSetCase>("mesh.face_set", &["scene"]),
    Target::new::<clip::SegmentCase>("clip.segment", &["clip", "clip::Segments"]),
    Target::new::<clip::ConvexCase>("clip.convex", &["clip"]),
    Target::new::<clip::BooleanCase>("clip.boolean", &["clip"]),
    Target::new::<space::SpaceSegmentCase>("clip.space", &["clip", "clip::Segments", "scene"]),
    Target::new::<space::SpaceFaceCase>("clip.space_face", &["clip", "scene"]),
    Target::new::<clip::PixelsCase>("clip.pixels", &["clip"]),
    Target::new::<circles::OutlinesCase>("scan.circles", &["scan", "scan::Conics"]),
    Target::new::<scan_lines::SiblingsCase>("scan.lines", &["scan", "scan::Lines"]),
    Target::new::<scan_lines::RunsCase>("scan.runs", &["scan", "scan::Lines"]),
    Target::new::<curves::FlattenCase>("scan.flatten", &["scan"]),
    Target::new::<curves::PolynomialCase>("scan.polynomial", &["scan"]),
    Target::new::<scan_fills::PolygonCase>("scan.polygon", &["scan", "scan::Polygons"]),
    Target::new::<scan_fills::LocateCase>("scan.locate", &["scan", "scan::Polygons"]),
    Target::new::<space::HomogeneousTriangleCase>("scan.homogeneous", &["clip", "scan", "scan::Polygons", "scene"]),
    Target::new::<scan_fills::SubTriangleCase>("scan.sub_triangle", &["scan", "scan::Polygons"]),
    Target::new::<coverage::MethodCase>("coverage.method", &["coverage"]),
    Target::new::<coverage::AreaCase>("coverage.area", &["coverage"]),
    Target::new::<coverage::FilteredCase>("coverage.filtered", &["coverage"]),
    Target::new::<shade::BlendCase>("shade.blend", &["shade"]),
    Target::new::<shade::RampCase>("shade.ramp", &["shade"]),
    Target::new::<shade::FilterCase>("shade.filter", &["coverage", "shade"]),
    Target::new::<fills::GradientCase>("shade.gradient", &["shade"]),
    Target::new::<band::MemoryCase>("band.memory", &["band", "shade"]),
    Target::new::<band::LoopCase>("band.picture_loop", &["band"]),
    Target::new::<band::OverlappingCase>("band.overlapping", &["band"]),
    Target::new::<band::PagesCase>("band.pages", &["band"]),
    Target::new::<band::PanelRotationCase>("band.panel_rotation", &["band"]),
    Target::new::<band::SupersamplingCase>("band.supersampling", &["band", "shade"]),
    Target::new::<closed::RectangleCase>("draw.rectangle", &["draw"]),
    Target::new::<closed::RoundedRectangleCase>("draw.rounded_rectangle", &["draw", "scan"]),
    Target::new::<closed::CircleCase>("draw.circle", &["draw", "scan"]),
    Target::new::<closed::EllipseCase>("draw.ellipse", &["draw", "scan"]),
    Target::new::<closed::ThinCircleCase>("draw.thin_circle", &["draw", "scan"]),
    Target::new::<closed::ArcCase>("draw.arc", &["draw", "scan"]),
    Target::new::<closed::SectorCase>("draw.sector", &["draw", "scan"]),
    Target::new::<closed::TriangleCase>("draw.triangle", &["draw", "scan"]),
    Target::new::<lines::LineCase>("draw.line", &["draw", "scan"]),
    Target::new::<lines::PolylineCase>("draw.polyline", &["draw", "scan"]),
    Target::new::<lines::PointsCase>("draw.points", &["draw", "scan"]),
    Target::new::<lines::BoundsCase>("draw.bounds", &["draw"]),
    Target::new::<polygons::PixelPolygonCase>("draw.polygon", &["draw", "scan"]),
    Target::new::<polygons::SubPolygonCase>("draw.sub_polygon", &["draw", "scan"]),
    Target::new::<polygons::PathCase>("draw.path", &["draw", "scan"]),
    Target::new::<strokes::StrokeCase>("draw.stroke", &["draw", "scan"]),
    Target::new::<strokes::SubStrokeCase>("draw.sub_stroke", &["draw", "scan"]),
    Target::new::<antialiased::AntialiasedCase>("draw.antialiased", &["coverage", "draw"]),
    Target::new::<styles::StyledCase>("draw.antialiased_style", &["coverage", "draw"]),
    Target::new::<styles::StrokedCase>("draw.antialiased_stroke", &["coverage", "draw"]),
    Target::new::<antialiased::GreyCase>("draw.grey", &["coverage", "draw", "shade"]),
    Target::new::<antialiased::SubShapeCase>("draw.sub_shape", &["draw"]),
    Target::new::<antialiased::FilteredLineCase>("draw.filtered_line", &["coverage", "draw"]),
    Target::new::<fills::SeedFillCase>("draw.seed_fill", &["draw"]),
    Target::new::<fills::PaintedCase>("draw.painted", &["draw", "shade"]),
    Target::new::<texts::MaskTextCase>("draw.mask_text", &["draw"]),
    Target::new::<outline_texts::OutlineTextCase>("draw.outline_text", &["coverage", "draw"]),
    Target::new::<pictures::PictureCase>("draw.picture", &["band", "draw"]),
    Target::new::<scene::FrameCase>("scene.frame", &["scene"]),
    Target::new::<scene::ModelCase>("scene.model", &["scene"]),
    Target::new::<shading::ShadingCase>("scene.shading", &["scene", "shade"]),
    Target::new::<visible::VisibilityCase>("visible.methods", &["visible"]),
    Target::new::<hidden_lines::HiddenLinesCase>("visible.lines", &["visible"]),
    Target::new::<depth_state::DepthStateCase>("visible.depth_state", &["scene", "visible"]),
    Target::new::<scene::DepthCase>("visible.depth", &["scene"]),
    Target::new::<scene::AtDepthCase>("visible.at_depth", &["scene"]),
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
