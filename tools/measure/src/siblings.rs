//! Siblings: algorithms with the same signature, counted side by side with the same inputs.

use std::collections::BTreeSet;

use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::Supersampling,
    coverage::{Bartlett, BoxFilter, CoverageMethod, Gaussian, Rooks, SamplePattern, SignedArea},
    shade::{ConeFilter, SampleFilter},
};

use zrow_methods::registry::{self, Agrees, Algorithm};

use crate::{
    accuracy,
    case::{Case, V6M, V7EM},
};

/// Algorithms with the same signature. Each is a variant of each count of one firmware.
struct Family {
    firmware: &'static str,
    /// Name and title of each count.
    counts: &'static [(&'static str, &'static str)],
    /// The algorithms of the registry that are counted; the first one is the default.
    registered: &'static [&'static [Algorithm]],
    /// What is counted beside them.
    others: &'static [Sibling],
}

/// One of a family.
#[derive(Clone, Copy)]
struct Sibling {
    /// Its name, by which the firmware knows it too; a program for footprints links nothing but the one that it names.
    variant: &'static str,
    /// Whether it has to give the default's result, pixel by pixel.
    is_exact: bool,
}

const fn exact(variant: &'static str) -> Sibling {
    Sibling {
        variant,
        is_exact: true,
    }
}

/// One that gives another result, as its module says.
const fn differing(variant: &'static str) -> Sibling {
    Sibling {
        variant,
        is_exact: false,
    }
}

/// A case for each count and sibling, on a core with and without a divider.
pub fn cases() -> impl Iterator<Item = Case> {
    [V7EM, V6M].into_iter().flat_map(|target| {
        let families = FAMILIES
            .iter()
            .chain([&INSTRUMENTS, &CLIP_PRECISION, &ROWS, &TEXTS, &TEXT_FONTS]);
        families
            .flat_map(move |family| family.cases(target))
            .chain(accuracy::classes(target))
    })
}

/// The flash of each sibling, which is linked into a program of its own.
pub fn flash() -> impl Iterator<Item = Case> {
    let mut variants = BTreeSet::new();
    let siblings = FAMILIES.iter().flat_map(Family::siblings);
    let siblings = siblings.filter(move |sibling| variants.insert(sibling.variant));
    siblings.map(|sibling| Case::sibling_flash(sibling.variant))
}

/// Columns of the pictures that samples are counted with.
const COLUMNS: usize = 48;

/// What a row of samples takes beside the row itself, 16 bits a pixel.
pub fn row_memory() -> impl Iterator<Item = Case> {
    let rows = [
        ("blended_area", cells::<SignedArea>()),
        ("multisample_4", multisampled::<Rooks<4>>()),
        ("multisample_8", multisampled::<Rooks<8>>()),
        ("multisample_16", multisampled::<Rooks<16>>()),
        ("supersample_2_box", supersampled::<2, BoxFilter>()),
        ("supersample_4_box", supersampled::<4, BoxFilter>()),
        ("supersample_8_box", supersampled::<8, BoxFilter>()),
        ("supersample_16_box", supersampled::<16, BoxFilter>()),
        ("supersample_4_bartlett", supersampled::<4, Bartlett>()),
        ("supersample_4_cone", supersampled::<4, ConeFilter>()),
        ("supersample_4_gaussian", supersampled::<4, Gaussian>()),
    ];
    rows.into_iter().map(|(variant, bytes)| {
        let title = format!("{variant}: row memory beside the row, {COLUMNS} px of 16 bits");
        Case::row_memory(format!("samples.row.{variant}"), title, bytes)
    })
}

fn cells<T: CoverageMethod>() -> usize {
    T::cells(COLUMNS) * size_of::<T::Cell>()
}

fn multisampled<P: SamplePattern>() -> usize {
    P::SAMPLES * COLUMNS * size_of::<u16>() + cells::<P>()
}

/// One row of samples at a time. It is drawn instead of the row, and the row is made in it.
fn supersampled<const N: usize, F: SampleFilter<N>>() -> usize {
    let sums = Supersampling::<Rgb565, N, F>::sums_needed(COLUMNS) * size_of::<F::Sum>();
    (N - 1) * COLUMNS * size_of::<u16>() + sums
}

impl Family {
    fn siblings(&self) -> impl Iterator<Item = Sibling> + use<> {
        let registered = self.registered.iter().copied().flatten().map(|algorithm| Sibling {
            variant: algorithm.name,
            is_exact: algorithm.agrees != Agrees::No,
        });
        registered.chain(self.others.iter().copied())
    }

    fn cases(&'static self, target: &'static str) -> impl Iterator<Item = Case> {
        self.counts.iter().flat_map(move |(count, title)| {
            self.siblings().map(move |sibling| {
                let default = self.siblings().next().filter(|_| sibling.is_exact);
                let default = default.map(|default| default.variant);
                Case::sibling(self.firmware, count, title, target, sibling.variant, default)
            })
        })
    }
}

const FAMILIES: &[Family] = &[
    SEGMENTS,
    SPACE_SEGMENTS,
    SPACE_POLYGONS,
    HOMOGENEOUS_TRIANGLES,
    CONVEX_POLYGONS,
    BOOLEANS,
    CIRCLES,
    RECTANGLES,
    LINE_WALKS,
    WHOLE_LINES,
    THIN_CIRCLES,
    THIN_ELLIPSES,
    CURVES,
    POLYGON_FILLS,
    TRIANGLE_FILLS,
    INTERPOLATIONS,
    STROKES,
    SEED_FILLS,
    PAINTS,
    COVERAGE,
    SAMPLES,
];

/// Segment clippers, against an upright window.
const SEGMENTS: Family = Family {
    firmware: "segments",
    counts: &[
        (
            "segment.inside.sub4",
            "clip a segment that is wholly inside, 1/16 pixel",
        ),
        (
            "segment.inside.sub8",
            "clip a segment that is wholly inside, 1/256 pixel",
        ),
        ("segment.crossing.sub4", "clip a segment that is cut, 1/16 pixel"),
        ("segment.crossing.sub8", "clip a segment that is cut, 1/256 pixel"),
        ("segment.outside.sub4", "clip a segment that is not visible, 1/16 pixel"),
        (
            "segment.outside.sub8",
            "clip a segment that is not visible, 1/256 pixel",
        ),
        (
            "segment.mixed.sub4",
            "clip a segment: 25 % inside, 25 % cut, 50 % not visible, 1/16 pixel",
        ),
        (
            "segment.mixed.sub8",
            "clip a segment: 25 % inside, 25 % cut, 50 % not visible, 1/256 pixel",
        ),
    ],
    registered: &[registry::SEGMENTS, registry::CONVEX_SEGMENTS],
    others: &[],
};

/// Segments between vertices of a model in a pose, against what a camera sees.
const SPACE_SEGMENTS: Family = Family {
    firmware: "space",
    counts: &[
        ("space.segment.inside", "clip a segment in space that is wholly visible"),
        ("space.segment.crossing", "clip a segment in space that is cut"),
        ("space.segment.outside", "clip a segment in space that is not visible"),
        (
            "space.segment.mixed",
            "clip a segment in space: 25 % inside, 25 % cut, 50 % not visible",
        ),
    ],
    registered: &[registry::SPACE_SEGMENTS, registry::VOLUME_SEGMENTS],
    others: &[],
};

/// Faces of a model in a pose, against what a camera sees.
const SPACE_POLYGONS: Family = Family {
    firmware: "space",
    counts: &[(
        "space.face.crossing",
        "clip a face in space that is cut, with two attributes",
    )],
    registered: &[registry::SPACE_POLYGONS],
    others: &[],
};

/// Triangles in homogeneous coordinates, without clipping, on 240 x 320 pixels; beside them what clips them first.
const HOMOGENEOUS_TRIANGLES: Family = Family {
    firmware: "space",
    counts: &[(
        "space.triangle",
        "spans of a triangle in space that is cut, 240 x 320 pixels",
    )],
    registered: &[registry::HOMOGENEOUS_TRIANGLES],
    others: &[],
};

/// Polygons of five corners in up to 80 x 80 pixels, against a panel with six.
const CONVEX_POLYGONS: Family = Family {
    firmware: "windows",
    counts: &[
        (
            "polygon.convex.inside.sub4",
            "clip a polygon of 5 corners to a hexagon, wholly inside, 1/16 pixel",
        ),
        (
            "polygon.convex.inside.sub8",
            "clip a polygon of 5 corners to a hexagon, wholly inside, 1/256 pixel",
        ),
        (
            "polygon.convex.crossing.sub4",
            "clip a polygon of 5 corners to a hexagon, cut, 1/16 pixel",
        ),
        (
            "polygon.convex.crossing.sub8",
            "clip a polygon of 5 corners to a hexagon, cut, 1/256 pixel",
        ),
        (
            "polygon.convex.outside.sub4",
            "clip a polygon of 5 corners to a hexagon, not visible, 1/16 pixel",
        ),
        (
            "polygon.convex.outside.sub8",
            "clip a polygon of 5 corners to a hexagon, not visible, 1/256 pixel",
        ),
    ],
    registered: &[registry::CONVEX_POLYGONS],
    // Parts of their own instead of bridges, and corners in another order.
    others: &[differing("greiner_hormann")],
};

/// Stars of 8 corners, each with a hole of 4, up to 160 pixels wide.
const BOOLEANS: Family = Family {
    firmware: "booleans",
    counts: &[
        (
            "polygon.apart.sub4",
            "intersection of two polygons of 12 corners, apart, 1/16 pixel",
        ),
        (
            "polygon.apart.sub8",
            "intersection of two polygons of 12 corners, apart, 1/256 pixel",
        ),
        (
            "polygon.intersection.sub4",
            "intersection of two polygons of 12 corners, 1/16 pixel",
        ),
        (
            "polygon.intersection.sub8",
            "intersection of two polygons of 12 corners, 1/256 pixel",
        ),
        ("polygon.union.sub4", "union of two polygons of 12 corners, 1/16 pixel"),
        ("polygon.union.sub8", "union of two polygons of 12 corners, 1/256 pixel"),
        (
            "polygon.difference.sub4",
            "difference of two polygons of 12 corners, 1/16 pixel",
        ),
        (
            "polygon.difference.sub8",
            "difference of two polygons of 12 corners, 1/256 pixel",
        ),
        (
            "polygon.same.sub4",
            "intersection of a polygon of 12 corners with itself, 1/16 pixel",
        ),
        (
            "polygon.same.sub8",
            "intersection of a polygon of 12 corners with itself, 1/256 pixel",
        ),
    ],
    registered: &[registry::BOOLEANS],
    others: &[],
};

/// Circles of 50 pixels, against the screen.
const CIRCLES: Family = Family {
    firmware: "windows",
    counts: &[
        ("circle.window.inside", "classify a circle that is wholly inside"),
        ("circle.window.crossing", "classify a circle that is partly visible"),
        ("circle.window.outside", "classify a circle that is not visible"),
    ],
    registered: &[],
    others: &[exact("circle_against_window")],
};

/// Rectangles of 60 x 10 pixels, against the screen.
const RECTANGLES: Family = Family {
    firmware: "windows",
    counts: &[
        ("rectangle.window.inside", "classify a rectangle that is wholly inside"),
        (
            "rectangle.window.crossing",
            "classify a rectangle that is partly visible",
        ),
        ("rectangle.window.outside", "classify a rectangle that is not visible"),
    ],
    registered: &[],
    others: &[exact("rectangle_against_window")],
};

/// One-pixel lines on 240 x 320 pixels, each pixel through the same `draw_iter`.
const LINE_WALKS: Family = Family {
    firmware: "lines",
    counts: &[
        ("walk.on_screen", "line on screen, pixel by pixel"),
        ("walk.shallow", "line, at most a row in 16 columns, pixel by pixel"),
        ("walk.level", "level line, pixel by pixel"),
        ("walk.off_screen", "line up to 3,000 px off screen, pixel by pixel"),
    ],
    registered: &[registry::LINES],
    others: &[],
};

/// The same lines as a band takes them: `Line`, which steps but where runs are long, against runs alone, and
/// filtered.
const WHOLE_LINES: Family = Family {
    firmware: "lines",
    counts: &[
        ("line.whole.on_screen", "line on screen, as a whole"),
        ("line.whole.shallow", "line, at most a row in 16 columns, as a whole"),
        ("line.whole.level", "level line, as a whole"),
        ("line.whole.off_screen", "line up to 3,000 px off screen, as a whole"),
    ],
    registered: &[],
    others: &[exact("bresenham"), exact("bresenham_runs"), differing("gupta_sproull")],
};

/// Circles with radii of 10 to 100 pixels, each pixel through the same `draw_iter`.
const THIN_CIRCLES: Family = Family {
    firmware: "thin_rounds",
    counts: &[("round.circle", "circle of 1 px, r = 10 to 100, pixel by pixel")],
    registered: &[registry::CIRCLES],
    others: &[],
};

/// Ellipses with semi-axes of 10 to 100 pixels, each pixel through the same `draw_iter`.
const THIN_ELLIPSES: Family = Family {
    firmware: "thin_rounds",
    counts: &[(
        "round.ellipse",
        "ellipse of 1 px, semi-axes of 10 to 100, pixel by pixel",
    )],
    registered: &[registry::ELLIPSES],
    others: &[],
};

/// Bezier curves of random control points: on 240 x 320 pixels, or as in a glyph.
const CURVES: Family = Family {
    firmware: "curves",
    counts: &[
        (
            "curve.quadratic",
            "flatten a quadratic Bezier curve on screen to 1/8 pixel",
        ),
        ("curve.cubic", "flatten a cubic Bezier curve on screen to 1/8 pixel"),
        (
            "curve.cubic.fine",
            "flatten a cubic Bezier curve on screen to 1/128 pixel",
        ),
        (
            "curve.cubic.glyph",
            "flatten a cubic Bezier curve within 16 px to 1/8 pixel",
        ),
    ],
    registered: &[registry::CURVES],
    others: &[],
};

/// Polygons on 240 x 320 pixels, their spans handed to a band.
const POLYGON_FILLS: Family = Family {
    firmware: "fills",
    counts: &[
        ("fill.polygon.small", "fill a polygon of 16 edges, r = 8"),
        ("fill.polygon.large", "fill a polygon of 16 edges, r = 100"),
        ("fill.polygon.rings", "fill four crossing rings of 16 edges, r = 100"),
    ],
    registered: &[registry::POLYGON_FILLS, registry::POINT_TESTS],
    others: &[],
};

/// The same with triangles under the top-left rule.
const TRIANGLE_FILLS: Family = Family {
    firmware: "fills",
    counts: &[
        ("fill.triangle.small.sub4", "fill a triangle within 16 px, 1/16 pixel"),
        ("fill.triangle.large.sub4", "fill a triangle, random, 1/16 pixel"),
        ("fill.triangle.sliver.sub4", "fill a sliver, random, 1/16 pixel"),
        ("fill.triangle.small.sub8", "fill a triangle within 16 px, 1/256 pixel"),
        ("fill.triangle.large.sub8", "fill a triangle, random, 1/256 pixel"),
        ("fill.triangle.sliver.sub8", "fill a sliver, random, 1/256 pixel"),
    ],
    registered: &[registry::POLYGON_FILLS.split_at(1).0, registry::TRIANGLES],
    others: &[],
};

/// Three attributes of triangles at 1/16 pixel, as the channels of colours.
const INTERPOLATIONS: Family = Family {
    firmware: "fills",
    counts: &[
        ("interpolation.small", "three attributes of a triangle within 16 px"),
        ("interpolation.large", "three attributes of a triangle, random"),
    ],
    registered: &[registry::INTERPOLATIONS],
    others: &[],
};

/// Strokes five pixels wide on 240 x 320 pixels: those of a `PrimitiveStyle`, and of a `StrokeStyle` plain and otherwise.
const STROKES: Family = Family {
    firmware: "strokes",
    counts: &[
        ("stroke.line", "line 5 px wide on screen"),
        ("stroke.polyline", "polyline 5 px wide, 7 segments of up to 40 x 40 px"),
    ],
    registered: &[],
    others: &[
        exact("wide_stroke"),
        exact("styled_stroke"),
        differing("round_stroke"),
        differing("dashed_stroke"),
        differing("round_dashed_stroke"),
    ],
};

/// A disc within a ring, on a picture that can be read back.
const SEED_FILLS: Family = Family {
    firmware: "paints",
    counts: &[
        ("seed_fill.disc.four", "flood a disc of 95 px, 4-connected"),
        ("seed_fill.disc.eight", "flood a disc of 95 px, 8-connected"),
    ],
    registered: &[],
    others: &[exact("flood_fill")],
};

/// What the same square is painted with.
const PAINTS: Family = Family {
    firmware: "paints",
    counts: &[("paint.square", "paint a square of 100 x 100")],
    registered: &[],
    others: &[
        exact("flat"),
        differing("pattern"),
        differing("linear_gradient"),
        differing("radial_gradient"),
    ],
};

/// Methods of antialiasing, into a mask of 48 x 48 bytes.
const COVERAGE: Family = Family {
    firmware: "coverage",
    counts: &[
        ("coverage.triangle", "cover 48 x 48 px with a triangle"),
        ("coverage.star", "cover 48 x 48 px with a {7/3} star"),
    ],
    registered: &[registry::COVERAGE_METHODS],
    others: &[],
};

/// Samples with a colour each, and coverage that is blended, into 48 x 48 pixels of 16 bits through one row.
const SAMPLES: Family = Family {
    firmware: "samples",
    counts: &[
        ("samples.triangle", "draw a triangle on 48 x 48 px, row by row"),
        ("samples.star", "draw a {7/3} star on 48 x 48 px, row by row"),
    ],
    registered: &[],
    others: &[
        differing("blended_area"),
        differing("multisample_4"),
        differing("multisample_8"),
        differing("multisample_16"),
        differing("supersample_2_box"),
        differing("supersample_4_box"),
        differing("supersample_8_box"),
        differing("supersample_16_box"),
        differing("supersample_4_bartlett"),
        differing("supersample_4_cone"),
        differing("supersample_4_gaussian"),
    ],
};

/// The instrument panel, a frame in all; its twins are no algorithms that could be linked alone.
const INSTRUMENTS: Family = Family {
    firmware: "instruments",
    counts: &[("scene.instruments", "instruments, 240 x 320, through one row")],
    registered: &[],
    others: &[differing("antialiased"), differing("aliased")],
};

/// Shapes through one row, of 240 pixels; `nothing` is what the band and the call take.
const ROWS: Family = Family {
    firmware: "rows",
    counts: &[
        ("row.above", "a row above the shape"),
        ("row.below", "a row below the shape"),
        ("row.met", "a row that the shape meets"),
    ],
    registered: &[],
    others: &[
        differing("nothing"),
        differing("rectangle"),
        differing("disc"),
        differing("circle"),
        differing("ellipse"),
        differing("rounded_rectangle"),
        differing("triangle"),
        differing("line"),
        differing("line_5_px"),
        differing("polyline"),
        differing("polyline_5_px"),
        differing("arc"),
        differing("sector"),
    ],
};

/// Texts through one row: by zrow, and by embedded-graphics' renderer, which has the same pixels.
const TEXTS: Family = Family {
    firmware: "texts",
    counts: &[
        ("text.met", "7 characters of 10 x 20 px: a row of them"),
        ("text.above", "7 characters of 10 x 20 px: a row above them"),
        ("text.below", "7 characters of 10 x 20 px: a row below them"),
        (
            "text.dashboard",
            "3 texts of 26 characters: a row of 240 px, mean of 320",
        ),
    ],
    registered: &[],
    others: &[exact("draw_on"), exact("embedded_graphics")],
};

/// A text in fonts of several kinds, which draw other pixels.
const TEXT_FONTS: Family = Family {
    firmware: "text_fonts",
    counts: &[
        ("text.frame", "\"42 km/h\", 20 to 24 px high: into 160 x 32 px at once"),
        ("text.row", "\"42 km/h\", 20 to 24 px high: a row of 160 px, mean of 32"),
    ],
    registered: &[],
    others: &[
        differing("outlines"),
        differing("outlines_prepared"),
        differing("masks"),
        differing("masks_prepared"),
        differing("mono"),
        differing("embedded_graphics"),
        differing("u8g2"),
    ],
};

/// The clipped end of a line, rounded to whole pixels and finer, or its error term kept.
const CLIP_PRECISION: Family = Family {
    firmware: "clip_precision",
    counts: &[("clip.precision", "clip a line with ends up to 7,000 px off 320 x 240")],
    registered: &[],
    others: &[
        differing("error_term_kept"),
        differing("whole_pixel"),
        differing("1_16"),
        differing("1_256"),
        differing("1_65536"),
        differing("1_256_grown"),
        differing("1_65536_grown"),
    ],
};
