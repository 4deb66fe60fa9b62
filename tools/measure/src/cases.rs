//! Everything that is measured: the list of all cases.

use crate::{
    case::{Case, Peer, RASTERIZER_VARIANTS, Source, V6M, V7EM, V7M, What},
    depth_test, effects,
    firmware::{Build, Level},
    siblings,
};

/// Everything there is to measure.
pub fn all() -> Vec<Case> {
    let shapes = |target| SHAPES.iter().flat_map(move |shape| shape.cases(target));
    let footprints = FOOTPRINTS.iter().flat_map(Footprint::cases);
    let families = FAMILIES.iter().flat_map(Family::cases);
    [V7EM, V6M]
        .into_iter()
        .flat_map(shapes)
        .chain(siblings::cases())
        .chain(siblings::row_memory())
        .chain(rasterizers())
        .chain(SCENES.iter().flat_map(Scene::cases))
        .chain(teapots())
        .chain(teapots_with_planes())
        .chain([teapot_as_item()])
        .chain(teapots_in_samples())
        .chain(estimates())
        .chain(effects::budgeted())
        .chain(looks())
        .chain(crowds())
        .chain(squares())
        .chain(hidden_surfaces())
        .chain(hidden_lines())
        .chain(depth_test::cases())
        .chain(pictures())
        .chain(contours())
        .chain(instruments())
        .chain(needle())
        .chain(blended())
        .chain(dithered())
        .chain(PICTURE_MEMORY.iter().map(PictureMemory::case))
        .chain(footprints)
        .chain(families)
        .collect()
}

/// The exact areas, each against each of the other rasterizers.
fn rasterizers() -> impl Iterator<Item = Case> {
    let counts = [
        ("coverage.triangle", "a triangle", Some(16_000.0)),
        ("coverage.star", "a {7/3} star", Some(32_000.0)),
        ("coverage.triangles", "random triangles", None),
        ("coverage.stars", "turned {7/3} stars", None),
    ];
    let methods = [("signed_area", 1.0), ("inside_area", 1.5)];
    counts.into_iter().flat_map(move |(count, shape, budget)| {
        methods.into_iter().flat_map(move |(variant, factor)| {
            RASTERIZER_VARIANTS.into_iter().map(move |peer| Case {
                name: format!("{count}.{variant}.{peer}"),
                title: format!("cover 48 x 48 px with {shape}: {variant} and {peer}"),
                target: V7EM,
                budget: budget.map(|budget| budget * factor),
                cycles_budget: None,
                source: Source::Count {
                    firmware: "coverage",
                    count,
                    variant,
                    peer: Peer::Rasterizer(peer),
                },
            })
        })
    })
}

/// The dashboard, whose items are prepared anew for each frame, or replayed into each band.
fn pictures() -> impl Iterator<Item = Case> {
    [V7EM, V6M].into_iter().flat_map(|target| {
        PICTURES.iter().flat_map(move |&(count, title, budget)| {
            [("", "prepared", "replayed"), (".replayed", "replayed", "prepared")]
                .into_iter()
                .map(move |(suffix, variant, sibling)| Case {
                    name: format!("{count}{suffix}"),
                    title: format!("{title}, {variant}"),
                    target,
                    budget: budget.filter(|_| target == V7EM && variant == "prepared"),
                    cycles_budget: None,
                    source: Source::Count {
                        firmware: "pictures",
                        count,
                        variant,
                        peer: Peer::Sibling(sibling),
                    },
                })
        })
    })
}

/// Frames of a picture with one item of many corners, by copy and by reference, and of one without items.
fn contours() -> impl Iterator<Item = Case> {
    let case = |count, suffix: &str, title, variant, peer| Case {
        name: format!("{count}{suffix}"),
        title,
        target: V7EM,
        budget: None,
        cycles_budget: None,
        source: Source::Count {
            firmware: "contours",
            count,
            variant,
            peer,
        },
    };
    let empty = "a picture without items, 200 x 200, bands of 1 row".to_owned();
    let shapes = [
        ("picture.star", "a filled star of 10 corners"),
        ("picture.star_stroke", "a star of 10 corners, its stroke 3 pixels wide"),
        ("picture.chart", "a polyline of 60 vertices, 1 pixel wide"),
        ("picture.wide_chart", "a polyline of 60 vertices, 3 pixels wide"),
        (
            "picture.dashed_chart",
            "a polyline of 60 vertices, 3 pixels wide, dashed with round caps",
        ),
        (
            "picture.inner_star",
            "a star of 10 corners, its stroke 3 pixels wide inside",
        ),
    ];
    let ways = [("", "copy", "reference"), (".reference", "reference", "copy")];
    let shapes = shapes.into_iter().flat_map(move |(count, shape)| {
        ways.map(|(suffix, variant, sibling)| {
            let title = format!("{shape} as an item by {variant}, 200 x 200, bands of 1 row");
            case(count, suffix, title, variant, Peer::Sibling(sibling))
        })
    });
    core::iter::once(case("picture.empty", "", empty, "copy", Peer::None)).chain(shapes)
}

/// Panels of antialiased shapes as pictures: the instruments against the same frame without a picture, and the cockpit.
fn instruments() -> impl Iterator<Item = Case> {
    let panels = [
        (
            "picture.instruments",
            "21 antialiased outlines, 6 texts and a line, 240 x 320, bands of 1 row, prepared",
            "scene.instruments",
            Peer::Sibling("antialiased"),
            Some(1_200_000.0),
        ),
        (
            "picture.cockpit",
            "38 antialiased shapes and 24 antialiased texts, 240 x 320, bands of 1 row, prepared",
            "scene.cockpit",
            Peer::None,
            None,
        ),
    ];
    [V7EM, V6M].into_iter().flat_map(move |target| {
        panels.map(|(name, title, count, peer, budget)| Case {
            name: name.to_owned(),
            title: title.to_owned(),
            target,
            budget: budget.filter(|_| target == V7EM),
            cycles_budget: None,
            source: Source::Count {
                firmware: "instruments",
                count,
                variant: "picture",
                peer,
            },
        })
    })
}

/// A step of the panel's arc, needle and digits: prepared, and what changes drawn.
fn needle() -> impl Iterator<Item = Case> {
    [V7EM, V6M].into_iter().map(|target| Case {
        name: "picture.instruments.needle".to_owned(),
        title: "the panel's arc, needle and digits move by a frame, what changes is drawn in bands of 1 row".to_owned(),
        target,
        budget: (target == V7EM).then_some(320_000.0),
        cycles_budget: None,
        source: Source::Count {
            firmware: "instruments",
            count: "scene.instruments.needle",
            variant: "picture",
            peer: Peer::None,
        },
    })
}

/// Antialiased shapes, blended into 16 bits on a band as high as the frame, against bands of one row.
fn blended() -> impl Iterator<Item = Case> {
    let shapes = [
        ("blend.disc", "antialiased disc, r = 50", 80_000.0),
        ("blend.line", "antialiased line, 5 px wide", 45_000.0),
        ("blend.triangle", "antialiased triangle, random", 70_000.0),
    ];
    let variants = [("", "frame", "rows"), (".rows", "rows", "frame")];
    [V7EM, V6M].into_iter().flat_map(move |target| {
        shapes.into_iter().flat_map(move |(count, title, budget)| {
            variants.map(move |(suffix, variant, sibling)| Case {
                name: format!("{count}{suffix}"),
                title: match variant {
                    "rows" => format!("{title}, drawn again in bands of 1 row"),
                    _ => format!("{title}, blended into RGB565"),
                },
                target,
                budget: (target == V7EM && variant == "frame").then_some(budget),
                cycles_budget: None,
                source: Source::Count {
                    firmware: "blended",
                    count,
                    variant,
                    peer: Peer::Sibling(sibling),
                },
            })
        })
    })
}

/// Frames that are dithered row by row: those in which no pixel is as the one before it, and those of one colour.
fn dithered() -> impl Iterator<Item = Case> {
    let frames = [
        ("dither.rgb565", "RGB888 to RGB565, neighbours differ"),
        ("dither.rgb565.flat", "RGB888 to RGB565, one colour"),
        ("dither.gray4", "8-bit to 4-bit grey, neighbours differ"),
        ("dither.gray4.flat", "8-bit to 4-bit grey, one grey"),
        ("dither.binary", "8-bit grey to black and white, neighbours differ"),
    ];
    [V7EM, V6M].into_iter().flat_map(move |target| {
        frames.map(|(count, title)| Case {
            name: count.to_owned(),
            title: format!("dither 240 x 320, {title}"),
            target,
            budget: None,
            cycles_budget: None,
            source: Source::Count {
                firmware: "dither",
                count,
                variant: "dither",
                peer: Peer::None,
            },
        })
    })
}

/// Bytes of a picture's memory.
struct PictureMemory {
    name: &'static str,
    title: &'static str,
    firmware: &'static str,
    what: What,
    budget: f64,
}

impl PictureMemory {
    fn case(&self) -> Case {
        Case {
            name: self.name.to_owned(),
            title: self.title.to_owned(),
            target: V7M,
            budget: Some(self.budget),
            cycles_budget: None,
            source: Source::Memory {
                build: Build {
                    target: V7M,
                    level: Level::Speed,
                    content: None,
                    firmware: self.firmware,
                },
                what: self.what,
            },
        }
    }
}

const PICTURE_MEMORY: &[PictureMemory] = &[
    PictureMemory {
        name: "ram.instruments",
        title: "the panel of instruments as a picture: row, cells, picture, damage",
        firmware: "footprint_instruments",
        what: What::Statics,
        budget: 8_192.0,
    },
    PictureMemory {
        name: "ram.gauge76",
        title: "a gauge of 76 antialiased outlines as a picture: row, cells, picture, damage",
        firmware: "footprint_gauge",
        what: What::Statics,
        budget: 10_240.0,
    },
    PictureMemory {
        name: "ram.cockpit",
        title: "the cockpit as a picture: row, cells, picture",
        firmware: "footprint_cockpit",
        what: What::Statics,
        budget: 12_288.0,
    },
    PictureMemory {
        name: "stack.picture",
        title: "the panel of instruments as a picture: deepest stack",
        firmware: "footprint_instruments",
        what: What::Stack,
        budget: 2_560.0,
    },
];

/// Counts of a frame of the dashboard, and what a prepared one may take.
const PICTURES: &[(&str, &str, Option<f64>)] = &[
    (
        "picture.shapes",
        "30 shapes, 240 x 320, bands of 1 row",
        Some(175_000.0),
    ),
    (
        "picture.dashboard",
        "30 shapes and 3 texts, 240 x 320, bands of 1 row",
        Some(210_000.0),
    ),
    ("picture.dashboard.rows_2", "the dashboard, bands of 2 rows", None),
    ("picture.dashboard.rows_4", "the dashboard, bands of 4 rows", None),
    ("picture.dashboard.rows_8", "the dashboard, bands of 8 rows", None),
    ("picture.dashboard.rows_16", "the dashboard, bands of 16 rows", None),
    ("picture.dashboard.rows_32", "the dashboard, bands of 32 rows", None),
    (
        "picture.dashboard.rows_320",
        "the dashboard, one band of 320 rows",
        None,
    ),
];

/// Standard scene 1 in each look, prepared and drawn: what an effect costs a frame.
fn looks() -> impl Iterator<Item = Case> {
    [V7M, V6M].into_iter().flat_map(|target| {
        LOOKS.iter().map(move |&(count, what)| Case {
            name: count.into(),
            title: format!("sc1: torus and cube, {what}"),
            target,
            budget: None,
            cycles_budget: None,
            source: Source::Count {
                firmware: "looks",
                count,
                variant: "draw",
                peer: Peer::None,
            },
        })
    })
}

const LOOKS: &[(&str, &str)] = &[
    ("look.plain", "the plainest look"),
    ("look.whole", "no face is cut"),
    ("look.one_pass", "no row in passes"),
    ("look.deep", "depths of 32 bits"),
    ("look.fine", "positions at 1/256 pixel"),
    ("look.fine_deep", "positions at 1/256 pixel and depths of 32 bits"),
    ("look.double_sided", "faces seen from both sides"),
];

/// Thirty spheres of which five are seen: what bounds around models save.
fn crowds() -> impl Iterator<Item = Case> {
    let boxes = [
        ("crowd.plain", "no boxes"),
        ("crowd.bounded", "boxes that are constants"),
        ("crowd.spheres", "spheres that are constants"),
        ("crowd.found", "boxes found in each frame"),
    ];
    let parts = [("draw", "", ""), ("prepare", ".prepare", ": preparing alone")];
    [V7EM, V6M].into_iter().flat_map(move |target| {
        boxes.into_iter().flat_map(move |(count, what)| {
            parts.into_iter().map(move |(variant, suffix, part)| Case {
                name: format!("{count}{suffix}"),
                title: format!("30 spheres, 25 outside of the picture, {what}{part}"),
                target,
                budget: None,
                cycles_budget: None,
                source: Source::Count {
                    firmware: "crowds",
                    count,
                    variant,
                    peer: Peer::None,
                },
            })
        })
    })
}

/// Few large faces with a texture that hide each other: by the depth row, and by intervals, which shade each pixel once.
fn squares() -> impl Iterator<Item = Case> {
    let variants = [
        ("draw", "", "by the depth row"),
        ("intervals", ".intervals", "by intervals"),
    ];
    [V7EM, V6M].into_iter().flat_map(move |target| {
        variants.into_iter().map(move |(variant, suffix, method)| Case {
            name: format!("scene.squares{suffix}"),
            title: format!("40 large textured faces, four deep in the mean pixel, {method}"),
            target,
            // 0.65 times what the depth row takes.
            budget: (variant == "intervals" && target == V7EM).then_some(7_390_000.0),
            cycles_budget: None,
            source: Source::Count {
                firmware: "squares",
                count: "scene.squares",
                variant,
                peer: Peer::None,
            },
        })
    })
}

/// Methods of hidden surfaces: preparing a frame and drawing it in one band.
fn hidden_surfaces() -> impl Iterator<Item = Case> {
    let torus = ["hidden_surfaces", "torus in one band"];
    let all = [
        ("row", "the depth row"),
        ("intervals", "intervals"),
        ("buffer", "a depth buffer"),
        ("bins", "tile bins"),
        ("sort", "the painter's algorithm"),
        ("quarters", "Warnock's quarters"),
        ("rays", "rays through a tree of boxes"),
        ("grid", "rays through a grid"),
        ("one", "one depth, pixel by pixel"),
    ];
    // Of a convex solid no face hides another.
    let solid = ["convex_solid", "icosphere in one band"];
    let row_and_painter = [("row", "the depth row"), ("sort", "the painter's algorithm")];
    let translucent = ["painted.translucent", "translucent teapot at 128 x 64 in one band"];
    let silhouettes = [
        "painted.silhouettes",
        "teapot with antialiased silhouettes at 128 x 64 in one band",
    ];
    by_methods("hidden_surfaces", torus, all)
        .chain(by_methods("hidden_surfaces", solid, row_and_painter))
        .chain(by_methods("hidden_surfaces", translucent, row_and_painter))
        .chain(by_methods("hidden_surfaces", silhouettes, row_and_painter))
}

/// Methods of hidden lines: preparing a frame, and finding the parts of its edges.
fn hidden_lines() -> impl Iterator<Item = Case> {
    let teapot = ["hidden_lines.teapot", "edges of the teapot"];
    let solids = [
        "hidden_lines.solids",
        "edges of two cubes that go through each other, and their intersections",
    ];
    let all = [
        ("segments", "face against segment"),
        ("appel", "Appel"),
        ("roberts", "Roberts"),
    ];
    by_methods("hidden_lines", teapot, all).chain(by_methods("hidden_lines", solids, all))
}

/// A scene, by the name and the title of its counts, by several methods, by the name and the title of each.
fn by_methods<const METHODS: usize>(
    firmware: &'static str,
    [count, scene]: [&'static str; 2],
    methods: [(&'static str, &'static str); METHODS],
) -> impl Iterator<Item = Case> {
    [V7EM, V6M].into_iter().flat_map(move |target| {
        methods.into_iter().map(move |(variant, method)| Case {
            name: format!("{count}.{variant}"),
            title: format!("{scene} by {method}"),
            target,
            budget: None,
            cycles_budget: None,
            source: Source::Count {
                firmware,
                count,
                variant,
                peer: Peer::None,
            },
        })
    })
}

/// A standard scene at 128 x 64, without a frame buffer.
struct Scene {
    count: &'static str,
    title: &'static str,
    target: &'static str,
    /// small3dlib, flat colours, full 32-bit z-buffer, `-O3`.
    small3dlib: f64,
    /// Estimated cycles: rows of colours and depths are filled word by word, which takes more instructions and fewer cycles
    /// than two words at a time.
    cycles_budget: f64,
}

impl Scene {
    /// A frame up to its finished rows, what of it is preparing, and the frame on a display.
    fn cases(&self) -> impl Iterator<Item = Case> {
        [
            (
                "",
                "",
                "draw",
                Peer::Published(self.small3dlib),
                Some(self.cycles_budget),
            ),
            (".prepare", ": preparing alone", "prepare", Peer::None, None),
            (
                ".display",
                ": and every pixel handed to a display",
                "display",
                Peer::None,
                None,
            ),
        ]
        .into_iter()
        .chain((self.count == "scene.sc1").then_some((
            ".passes",
            ": with 15 slots, where 60 would do, so in passes",
            "passes",
            Peer::None,
            None,
        )))
        .map(|(suffix, what, variant, peer, cycles_budget)| Case {
            name: format!("{}{suffix}", self.count),
            title: format!("{}{what}", self.title),
            target: self.target,
            budget: None,
            cycles_budget,
            source: Source::Count {
                firmware: "scenes",
                count: self.count,
                variant,
                peer,
            },
        })
    }
}

/// The Utah teapot at 240 x 320 in each shading, and a square with a texture: a frame up to its finished rows, what of it is
/// preparing, and the frame on a display. Budgets are in instructions.
fn teapots() -> impl Iterator<Item = Case> {
    let counts = [
        (
            V7EM,
            "scene.teapot.flat",
            "Utah teapot, 992 faces, 240 x 320",
            Some(560_000.0),
        ),
        (
            V6M,
            "scene.teapot.flat",
            "Utah teapot, 992 faces, 240 x 320",
            Some(1_050_000.0),
        ),
        (
            V7EM,
            "scene.teapot.flat_lit",
            "Utah teapot under a light, one brightness a face",
            Some(600_000.0),
        ),
        (
            V6M,
            "scene.teapot.flat_lit",
            "Utah teapot under a light, one brightness a face",
            None,
        ),
        (
            V7EM,
            "scene.teapot.gouraud",
            "Utah teapot under a light, three channels",
            Some(730_000.0),
        ),
        (
            V6M,
            "scene.teapot.gouraud",
            "Utah teapot under a light, three channels",
            None,
        ),
        (
            V7EM,
            "scene.teapot.textured_lit",
            "Utah teapot under a light, textured",
            Some(1_100_000.0),
        ),
        (
            V6M,
            "scene.teapot.textured_lit",
            "Utah teapot under a light, textured",
            Some(2_600_000.0),
        ),
        (
            V7EM,
            "scene.teapot.bilinear",
            "Utah teapot under a light, textured, bilinear",
            Some(1_650_000.0),
        ),
        // 1.6 times the flat one without.
        (
            V7EM,
            "scene.teapot.silhouettes",
            "Utah teapot, flat, antialiased silhouettes",
            Some(948_000.0),
        ),
        (
            V6M,
            "scene.teapot.silhouettes",
            "Utah teapot, flat, antialiased silhouettes",
            None,
        ),
        (
            V7EM,
            "scene.quad.textured",
            "a square of up to 200 x 200 px, textured",
            None,
        ),
    ];
    counts.into_iter().flat_map(|(target, count, title, budget)| {
        [
            ("", "", "draw", budget),
            (".prepare", ": preparing alone", "prepare", None),
            (".display", ": and every pixel handed to a display", "display", None),
        ]
        .map(|(suffix, what, variant, budget)| Case {
            name: format!("{count}{suffix}"),
            title: format!("{title}{what}"),
            target,
            budget,
            cycles_budget: None,
            source: Source::Count {
                firmware: "teapots",
                count,
                variant,
                peer: Peer::None,
            },
        })
    })
}

/// The Utah teapot at 240 x 320 in each shading, its back faces culled by their planes: a frame up to its finished rows, and what
/// of it is preparing.
fn teapots_with_planes() -> impl Iterator<Item = Case> {
    let counts = [
        ("scene.teapot_planes.flat", "Utah teapot with planes, flat"),
        (
            "scene.teapot_planes.flat_lit",
            "Utah teapot with planes, one brightness a face",
        ),
        ("scene.teapot_planes.gouraud", "Utah teapot with planes, three channels"),
        ("scene.teapot_planes.textured_lit", "Utah teapot with planes, textured"),
    ];
    let variants = [("", "", "draw"), (".prepare", ": preparing alone", "prepare")];
    counts.into_iter().flat_map(move |(count, title)| {
        [V7EM, V6M].into_iter().flat_map(move |target| {
            variants.map(|(suffix, what, variant)| Case {
                name: format!("{count}{suffix}"),
                title: format!("{title}{what}"),
                target,
                budget: None,
                cycles_budget: None,
                source: Source::Count {
                    firmware: "face_planes",
                    count,
                    variant,
                    peer: Peer::None,
                },
            })
        })
    })
}

/// The Utah teapot at 240 x 320 as the only item of a prepared picture: a frame up to its finished rows.
fn teapot_as_item() -> Case {
    Case {
        name: "scene.teapot.flat_lit.item".into(),
        title: "Utah teapot under a light, one brightness a face, as an item of a picture".into(),
        target: V7EM,
        budget: None,
        cycles_budget: None,
        source: Source::Count {
            firmware: "teapots",
            count: "scene.teapot.flat_lit",
            variant: "item",
            peer: Peer::None,
        },
    }
}

/// The Utah teapot at 240 x 320 with four samples a pixel: a frame up to its finished rows.
fn teapots_in_samples() -> impl Iterator<Item = Case> {
    [V7EM, V6M].into_iter().map(|target| Case {
        name: "scene.teapot.multisampled".into(),
        title: "Utah teapot, flat, four samples a pixel, every second frame".into(),
        target,
        budget: None,
        cycles_budget: None,
        source: Source::Count {
            firmware: "teapots",
            count: "scene.teapot.multisampled",
            variant: "draw",
            peer: Peer::None,
        },
    })
}

/// What `Prepared::estimate` predicts for drawing a scene, on both instruction sets, and what predicting takes. The first ones
/// are scenes to which all weights were fitted, the others are of other sizes and poses: to those only the weights were fitted
/// that all scenes share.
fn estimates() -> impl Iterator<Item = Case> {
    let scenes = [
        ("estimate.sc1", "sc1: torus and cube"),
        ("estimate.sc1_passes", "sc1 with 15 slots, so in passes"),
        ("estimate.sc1_fine", "sc1 at 1/256 pixel"),
        ("estimate.sc1_deep", "sc1 with depths of 32 bits"),
        ("estimate.sc2", "sc2: icosphere"),
        ("estimate.sc3", "sc3: cube"),
        ("estimate.flat", "Utah teapot, 240 x 320"),
        (
            "estimate.fine_deep",
            "Utah teapot at 1/256 pixel with depths of 32 bits",
        ),
        ("estimate.flat_lit", "Utah teapot under a light, one brightness a face"),
        ("estimate.gouraud", "Utah teapot under a light, three channels"),
        ("estimate.textured", "Utah teapot, textured"),
        ("estimate.textured_lit", "Utah teapot under a light, textured"),
        ("estimate.bilinear", "Utah teapot under a light, textured, bilinear"),
        ("estimate.indexed", "Utah teapot, a texture of 16 colours"),
        ("estimate.holes", "Utah teapot, a texture of 16 colours, one a hole"),
        ("estimate.fog", "Utah teapot in fog"),
        ("estimate.translucent", "Utah teapot, translucent"),
        ("estimate.silhouettes", "Utah teapot, antialiased silhouettes"),
        ("estimate.everything", "Utah teapot with every effect"),
        ("estimate.square", "a square, textured"),
        ("estimate.other.torus", "torus and cube, 3/4 as far, 320 x 240"),
        ("estimate.other.cube", "cube, 4/5 as far, 320 x 240"),
        ("estimate.other.sphere", "icosphere, 7/10 as far, 240 x 320"),
        ("estimate.other.shaded_sphere", "icosphere, Gouraud shading, 240 x 320"),
        ("estimate.other.hills", "hills, rolling"),
        ("estimate.other.cut_hills", "hills, rolling, cut at all sides"),
        ("estimate.other.small_pot", "teapot of 240 faces, rolling"),
        ("estimate.other.near", "Utah teapot, half as far, rolling"),
        ("estimate.other.far", "Utah teapot, twice as far, 128 x 64"),
        (
            "estimate.other.gouraud",
            "Utah teapot, three channels, rolling, 320 x 240",
        ),
        (
            "estimate.other.gouraud_far",
            "Utah teapot, three channels, twice as far, 128 x 64",
        ),
        (
            "estimate.other.textured",
            "Utah teapot, lit and textured, rolling, 320 x 240",
        ),
        (
            "estimate.other.textured_far",
            "Utah teapot, lit and textured, twice as far, 128 x 64",
        ),
        ("estimate.other.fog", "Utah teapot in fog, rolling, 320 x 240"),
        ("estimate.other.translucent", "Utah teapot, translucent, rolling"),
        (
            "estimate.other.silhouettes",
            "Utah teapot, antialiased silhouettes, half as far again, rolling",
        ),
        ("estimate.other.square", "a square, textured, half as far again"),
    ];
    let predicted = [V7EM, V6M].into_iter().flat_map(move |target| {
        scenes.map(|(count, title)| Case {
            name: count.to_owned(),
            title: format!("{title}: drawing, as predicted"),
            target,
            budget: None,
            cycles_budget: None,
            source: Source::Prediction { count },
        })
    });
    // 5 % of the frame.
    let cost = [("estimate.flat", Some(29_600.0)), ("estimate.textured_lit", None)];
    predicted.chain(cost.map(|(count, budget)| Case {
        name: format!("{count}.cost"),
        title: "predicting it".to_owned(),
        target: V7EM,
        budget,
        cycles_budget: None,
        source: Source::PredictionCost { count },
    }))
}

const fn scene(
    count: &'static str,
    title: &'static str,
    target: &'static str,
    small3dlib: f64,
    cycles_budget: f64,
) -> Scene {
    Scene {
        count,
        title,
        target,
        small3dlib,
        cycles_budget,
    }
}

const SCENES: &[Scene] = &[
    scene("scene.sc1", "sc1: torus and cube, 588 faces", V7M, 519_017.0, 326_000.0),
    scene("scene.sc2", "sc2: icosphere, 320 faces", V7M, 373_187.0, 209_000.0),
    scene("scene.sc3", "sc3: cube, 12 faces", V7M, 164_148.0, 102_000.0),
    scene(
        "scene.sc1",
        "sc1: torus and cube, 588 faces",
        V6M,
        1_439_195.0,
        752_000.0,
    ),
];

/// A program that does one thing, for the memory that takes.
struct Footprint {
    firmware: &'static str,
    name: &'static str,
    title: &'static str,
    /// The program without it.
    baseline: &'static str,
    /// What its flash is without that program.
    net: &'static str,
    /// Bytes of RAM that the budget leaves out.
    beside: u64,
    /// Statics and stack.
    ram_bar: Option<f64>,
    /// At opt-level "s", without the empty program.
    flash_bar: Option<f64>,
}

impl Footprint {
    /// Every kind of memory, at both levels.
    fn cases(&self) -> impl Iterator<Item = Case> {
        let total = if self.beside == 0 {
            "statics + stack"
        } else {
            "statics + stack, beside the row"
        };
        let kinds = [
            ("flash", "flash", What::Flash),
            ("flash.net", self.net, What::NetFlash(self.baseline)),
            ("ram.statics", "static RAM", What::Statics),
            ("ram.stack", "deepest stack", What::Stack),
            ("ram.total", total, What::RamBeside(self.beside)),
        ];
        [(Level::Speed, "o3"), (Level::Size, "os")]
            .into_iter()
            .flat_map(move |(level, suffix)| {
                kinds.into_iter().map(move |(kind, description, what)| Case {
                    name: format!("{kind}.{}.{suffix}", self.name),
                    title: format!("{}: {description}", self.title),
                    target: V7M,
                    cycles_budget: None,
                    budget: match (what, level) {
                        (What::NetFlash(_), Level::Size) => self.flash_bar,
                        (What::RamBeside(_), _) => self.ram_bar,
                        _ => None,
                    },
                    source: Source::Memory {
                        build: Build {
                            target: V7M,
                            level,
                            content: None,
                            firmware: self.firmware,
                        },
                        what,
                    },
                })
            })
    }
}

const FOOTPRINTS: &[Footprint] = &[
    Footprint {
        firmware: "footprint_2d",
        name: "2d",
        title: "rectangle, circle, ellipse, triangle and thin line, 240 px wide",
        baseline: "footprint_empty",
        net: "flash, without runtime and harness",
        beside: 2 * 240,
        ram_bar: Some(1024.0),
        flash_bar: None,
    },
    Footprint {
        firmware: "footprint_depth",
        name: "depth",
        title: "sc1 through the depth row, no face cut, no row in passes",
        baseline: "footprint_mesh",
        net: "flash, without runtime, harness and mesh",
        beside: 0,
        ram_bar: Some(9.0 * 1024.0),
        flash_bar: Some(8.0 * 1024.0),
    },
    Footprint {
        firmware: "footprint_depth_cutting",
        name: "depth.cutting",
        title: "sc1 through the depth row, faces may be cut, rows may take passes",
        baseline: "footprint_mesh",
        net: "flash, without runtime, harness and mesh",
        beside: 0,
        ram_bar: None,
        flash_bar: None,
    },
    Footprint {
        firmware: "footprint_both",
        name: "both",
        title: "2D shapes and sc1, no face cut, no row in passes",
        baseline: "footprint_mesh",
        net: "flash, without runtime, harness and mesh",
        beside: 0,
        ram_bar: None,
        flash_bar: None,
    },
];

/// What one program draws alone through a row of pixels, a family of 2D shapes or a text, for the memory that takes.
struct Family {
    firmware: &'static str,
    /// What the program links; `None` is every family.
    content: Option<&'static str>,
    title: &'static str,
}

impl Family {
    /// The cases of a family: the flash of its program less that of an empty one, at opt-levels 3 and "s", and its
    /// deepest stack at opt-level 3.
    fn cases(&self) -> impl Iterator<Item = Case> {
        let flash = What::NetFlash("footprint_empty");
        let kinds = [
            (
                "flash.net",
                "flash, without runtime and harness",
                flash,
                Level::Speed,
                "o3",
            ),
            (
                "flash.net",
                "flash, without runtime and harness",
                flash,
                Level::Size,
                "os",
            ),
            ("ram.stack", "deepest stack", What::Stack, Level::Speed, "o3"),
        ];
        kinds.into_iter().map(|(kind, description, what, level, suffix)| Case {
            name: format!("{kind}.{}.{suffix}", self.content.unwrap_or("family_all")),
            title: format!("{}: {description}", self.title),
            target: V7M,
            budget: None,
            cycles_budget: None,
            source: Source::Memory {
                build: Build {
                    target: V7M,
                    level,
                    content: self.content,
                    firmware: self.firmware,
                },
                what,
            },
        })
    }
}

/// A short text in one font.
const fn text(content: &'static str, title: &'static str) -> Family {
    Family {
        firmware: "footprint_text",
        content: Some(content),
        title,
    }
}

const fn family(content: &'static str, title: &'static str) -> Family {
    Family {
        firmware: "footprint_shape",
        content: Some(content),
        title,
    }
}

const FAMILIES: &[Family] = &[
    family("family_rectangles", "rectangles"),
    family("family_ellipses", "circles and ellipses"),
    family("family_arcs", "arcs and sectors"),
    family("family_rounded_rectangles", "rounded rectangles"),
    family("family_thin_lines", "lines, polylines and circles of 1 px"),
    family("family_triangles", "triangles, outlines of 1 px"),
    family("family_wide_strokes", "wide strokes of lines, polylines and triangles"),
    family("family_stroke_styles", "strokes with caps and joins"),
    family("family_dashes", "dashed strokes"),
    family("family_polygons", "polygons, a table of 8 edges"),
    family("family_paths", "paths of curves, a table of 80 edges"),
    family("family_filtered_lines", "filtered lines"),
    family(
        "family_antialiased",
        "an antialiased outline, a table of 8 edges and a row of cells",
    ),
    Family {
        firmware: "footprint_shape",
        content: None,
        title: "all families of 2D shapes",
    },
    text("text_outlines", "\"42 km/h\" from outlines, drawn again for each row"),
    text("text_outlines_prepared", "\"42 km/h\" from outlines, in a picture"),
    text("text_masks", "\"42 km/h\" from masks, drawn again for each row"),
    text("text_masks_prepared", "\"42 km/h\" from masks, in a picture"),
    text("text_mono", "\"42 km/h\" in FONT_10X20"),
    text(
        "text_embedded_graphics",
        "\"42 km/h\" in FONT_10X20 by embedded-graphics",
    ),
    text("text_u8g2", "\"42 km/h\" in helvR18 by u8g2-fonts"),
];

/// A shape at 240 x 320 RGB565.
struct Shape {
    count: &'static str,
    title: &'static str,
    /// Instructions on thumbv7em, through the fastest variant.
    budget: Option<f64>,
    /// Estimated cycles on thumbv7em, through the fastest variant.
    cycles_budget: Option<f64>,
    /// The firmware's variants: name, and what has to draw the same pixels. The first one has the budget.
    variants: &'static [(&'static str, Peer)],
}

/// Both variants of zrow, held against the peer.
const VARIANTS: &[(&str, Peer)] = &[("fast", Peer::Variant("peer")), ("draw", Peer::Variant("peer"))];

impl Shape {
    const fn new(count: &'static str, title: &'static str, budget: f64) -> Self {
        Self {
            budget: Some(budget),
            ..Self::without_budget(count, title)
        }
    }

    /// A shape that is filled: one store of a word is an instruction and a cycle, one of two words an instruction and three
    /// cycles, so that cycles are what counts.
    const fn filled(count: &'static str, title: &'static str, cycles: f64) -> Self {
        Self {
            cycles_budget: Some(cycles),
            ..Self::without_budget(count, title)
        }
    }

    const fn without_budget(count: &'static str, title: &'static str) -> Self {
        Self {
            count,
            title,
            budget: None,
            cycles_budget: None,
            variants: VARIANTS,
        }
    }

    /// A case for each variant.
    fn cases(&self, target: &'static str) -> impl Iterator<Item = Case> {
        self.variants
            .iter()
            .enumerate()
            .map(move |(index, &(variant, peer))| Case {
                name: if index == 0 {
                    self.count.to_owned()
                } else {
                    format!("{}.{variant}", self.count)
                },
                title: self.title.to_owned(),
                target,
                budget: self.budget.filter(|_| index == 0 && target == V7EM),
                cycles_budget: self.cycles_budget.filter(|_| index == 0 && target == V7EM),
                source: Source::Count {
                    firmware: "shapes",
                    count: self.count,
                    variant,
                    peer,
                },
            })
    }
}

const SHAPES: &[Shape] = &[
    Shape {
        variants: &[("draw", Peer::Variant("peer"))],
        ..Shape::filled("clear", "clear", 47_000.0)
    },
    Shape::new("line.on_screen", "1-px line, end points on screen", 1_900.0),
    Shape::new(
        "line.off_screen",
        "1-px line, end points up to 3,000 px off screen",
        500.0,
    ),
    Shape::new("circle.outline", "circle outline, r = 50", 3_000.0),
    Shape {
        variants: &[("fast", Peer::Sibling("draw")), ("draw", Peer::Sibling("fast"))],
        ..Shape::without_budget("circle.thin", "thin Bresenham circle, r = 50")
    },
    Shape::filled("circle.filled", "circle filled, r = 50", 12_000.0),
    Shape::filled("triangle.filled", "triangle filled, random", 11_500.0),
    Shape::new("triangle.small", "triangle filled, within 16 px", 600.0),
    Shape::filled("rectangle.filled", "rectangle 100 x 100 filled", 9_000.0),
    Shape::filled("ellipse.filled", "ellipse 120 x 80 filled", 11_000.0),
    Shape::without_budget("arc.outline", "arc r = 50 from 90 to 270 degrees, 1-px stroke"),
    Shape::without_budget("sector.filled", "sector r = 50 of 120 degrees filled"),
    Shape::without_budget("rounded.equal", "rounded rectangle 100 x 60, r = 12, filled"),
    Shape::without_budget(
        "rounded.unequal",
        "rounded rectangle 100 x 60, r = 4, 12, 20 and 28, filled",
    ),
];

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::all;

    #[test]
    fn a_name_stands_for_one_figure_of_a_target() {
        let cases = all();
        let names: HashSet<_> = cases.iter().map(|case| (case.target, &case.name)).collect();
        assert_eq!(names.len(), cases.len());
    }
}
