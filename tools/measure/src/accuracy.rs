//! Counts for the accuracy report: what is counted comes from the lists that the report runs on this host.

use zrow_methods::{
    CURVE_SIBLINGS, Class, DISCS, FIGURE_SIZES, Figure, LINE_GROUPS, LINE_SIBLINGS, METHODS, OUTLINES, PRECISIONS,
    TOLERANCES, TRIGONOMETRY, TRIGONOMETRY_COUNT,
    space::{
        DEPTH_GROUPS, DEPTH_WIDTHS, MATRIX_FORMATS, MATRIX_GROUPS, PERSPECTIVE_GROUPS, PERSPECTIVES, POSITION_GROUPS,
        POSITIONS,
    },
};

use crate::case::{Case, RASTERIZER_VARIANTS, V7EM};

/// Every method of antialiasing on the shape classes.
pub fn classes(target: &'static str) -> impl Iterator<Item = Case> {
    let count = move |class: Class, variant| {
        let title = format!("coverages in 48 x 48 px: {}", class.title());
        Case::sibling("shape_classes", class.count_name(), &title, target, variant, None)
    };
    Class::ALL
        .into_iter()
        .flat_map(move |class| METHODS.iter().map(move |method| count(class, method.name)))
}

/// What only the report asks for: on its own lines, curves, circles and corners, and on the figures that other rasterizers
/// fill as well.
pub fn report_cases() -> impl Iterator<Item = Case> {
    let lines = pairs(LINE_GROUPS, LINE_SIBLINGS).map(|(group, sibling)| (group.count, sibling.name));
    let curves = pairs(TOLERANCES, CURVE_SIBLINGS).map(|(tolerance, sibling)| (tolerance.count, sibling.name));
    let outlines = OUTLINES.iter().map(|method| ("circles.outline", method.variant));
    let discs = DISCS.iter().map(|method| ("circles.disc", method.variant));
    let corners =
        pairs(&Class::ALL, PRECISIONS).map(|(class, precision)| (class.corners_count_name(), precision.variant));
    let methods = pairs(figure_counts(), &["signed_area", "inside_area"]).map(|(figure, method)| (figure, *method));
    let zrow = lines
        .chain(curves)
        .chain(outlines)
        .chain(discs)
        .chain(corners)
        .chain(methods);
    let zrow = zrow.map(|(count, variant)| Case::sibling("accuracy", count, count, V7EM, variant, None));
    let peers = pairs(figure_counts(), &RASTERIZER_VARIANTS);
    zrow.chain(in_space())
        .chain(peers.map(|(count, variant)| Case::rasterizer(count, variant)))
}

/// Formats of numbers in 3D on small scenes, sines and cosines, and the flash of the latter.
fn in_space() -> impl Iterator<Item = Case> {
    let scenes = pairs(DEPTH_GROUPS, DEPTH_WIDTHS)
        .chain(pairs(POSITION_GROUPS, POSITIONS))
        .chain(pairs(MATRIX_GROUPS, MATRIX_FORMATS))
        .chain(pairs(PERSPECTIVE_GROUPS, PERSPECTIVES))
        .map(|(group, method)| (group.count, method.variant));
    let sines = TRIGONOMETRY.iter().map(|method| (TRIGONOMETRY_COUNT, method.variant));
    let counts = scenes.chain(sines);
    let counts = counts.map(|(count, variant)| Case::sibling("formats", count, count, V7EM, variant, None));
    counts.chain(TRIGONOMETRY.iter().map(|method| Case::sibling_flash(method.variant)))
}

fn figure_counts() -> impl Iterator<Item = &'static str> {
    pairs(&Figure::ALL, &FIGURE_SIZES).map(|(figure, size)| figure.count_name(*size))
}

/// Each with each.
fn pairs<A: Copy, B: 'static>(
    these: impl IntoIterator<Item = A>,
    those: &'static [B],
) -> impl Iterator<Item = (A, &'static B)> {
    these
        .into_iter()
        .flat_map(move |this| those.iter().map(move |that| (this, that)))
}
