//! What is measured, where, and the bar each figure has to reach.

use anyhow::Context;

use super::{
    counts::Counts,
    firmware::{Build, Level},
    report::Figure,
    siblings,
};

/// Cortex-M4.
pub const V7EM: &str = "thumbv7em-none-eabi";
/// Cortex-M0: no divide, no long multiply.
pub const V6M: &str = "thumbv6m-none-eabi";
/// Cortex-M3.
const V7M: &str = "thumbv7m-none-eabi";
/// Cortex-M4 with its floating-point unit in use, for peers that compute in `f32`.
const V7EM_HARD_FLOAT: &str = "thumbv7em-none-eabihf";

/// Rasterizers with antialiasing.
const RASTERIZERS: Build = Build {
    target: V7EM_HARD_FLOAT,
    level: Level::Speed,
    feature: Some("coverage_peers"),
    firmware: "coverage_peers",
};

/// What their program calls them.
pub const RASTERIZER_DOORS: [&str; 3] = ["zeno", "ab_glyph_rasterizer", "tiny_skia"];

/// One figure to be measured.
#[derive(Clone, Debug)]
pub struct Case {
    pub name: String,
    pub title: String,
    pub target: &'static str,
    pub bar: Option<f64>,
    source: Source,
}

#[derive(Clone, Debug)]
enum Source {
    /// Instructions of one operation, drawn through a door.
    Count {
        firmware: &'static str,
        count: &'static str,
        door: &'static str,
        peer: Peer,
    },
    /// Bytes that a program takes.
    Memory { build: Build, what: What },
    /// Bytes of row memory, which follow from types.
    RowMemory(usize),
}

#[derive(Clone, Copy, Debug)]
enum What {
    Flash,
    /// Without what this program takes, built in the same way.
    NetFlash(&'static str),
    Statics,
    Stack,
    /// Statics and stack, without so many bytes.
    RamBeside(u64),
}

/// What a count is held against.
#[derive(Clone, Copy, Debug)]
enum Peer {
    /// Another door of the same firmware, which did the same work: the checksums have to be equal.
    Door(&'static str),
    /// A sibling in zrow with the same result: the checksums have to be equal, but it is no peer.
    Sibling(&'static str),
    /// Another rasterizer in a program of its own, which draws other pixels.
    Rasterizer(&'static str),
    /// Measured separately: instructions of small3dlib on the same machine with the same scene.
    Published(f64),
    None,
}

impl Case {
    /// A door of a count; `default` is the door that has to give the same result.
    pub fn sibling(
        firmware: &'static str,
        count: &'static str,
        title: &str,
        target: &'static str,
        door: &'static str,
        default: Option<&'static str>,
    ) -> Self {
        Self {
            name: format!("{count}.{door}"),
            title: title.to_owned(),
            target,
            bar: None,
            source: Source::Count {
                firmware,
                count,
                door,
                peer: default.map_or(Peer::None, Peer::Sibling),
            },
        }
    }

    /// A door of a count in the program of the other rasterizers, by itself.
    pub fn rasterizer(count: &'static str, door: &'static str) -> Self {
        let target = RASTERIZERS.target;
        Self::sibling(RASTERIZERS.firmware, count, count, target, door, None)
    }

    /// The flash that a sibling adds to a program that does nothing, at opt-level "s".
    pub fn sibling_flash(door: &'static str) -> Self {
        Self {
            name: format!("flash.sibling.{door}"),
            title: format!("{door}: flash, without runtime and harness, at opt-level s"),
            target: V7M,
            bar: None,
            source: Source::Memory {
                build: Build {
                    target: V7M,
                    level: Level::Size,
                    feature: Some(door),
                    firmware: "footprint_sibling",
                },
                what: What::NetFlash("footprint_empty"),
            },
        }
    }

    /// The bytes that drawing a row takes.
    pub fn row_memory(name: String, title: String, bytes: usize) -> Self {
        Self {
            name,
            title,
            target: V7M,
            bar: None,
            source: Source::RowMemory(bytes),
        }
    }

    /// The programs it needs.
    pub fn builds(&self) -> Vec<Build> {
        match self.source {
            Source::Count { firmware, peer, .. } => {
                let zrow = Build {
                    target: self.target,
                    level: Level::Speed,
                    feature: None,
                    firmware,
                };
                let zrow = if firmware == RASTERIZERS.firmware {
                    RASTERIZERS
                } else {
                    zrow
                };
                match peer {
                    Peer::Rasterizer(_) => vec![zrow, RASTERIZERS],
                    _ => vec![zrow],
                }
            }
            Source::Memory {
                build,
                what: What::NetFlash(baseline),
            } => vec![build, build.baseline(baseline)],
            Source::Memory { build, .. } => vec![build],
            Source::RowMemory(_) => vec![],
        }
    }

    /// Whether it counts instructions of a Cortex-M4.
    pub fn is_count_on_m4(&self) -> bool {
        matches!(self.source, Source::Count { .. }) && [V7EM, V7EM_HARD_FLOAT].contains(&self.target)
    }

    /// What it counts.
    pub fn unit(&self) -> &'static str {
        match self.source {
            Source::Count { .. } => "instructions per operation",
            Source::Memory { .. } | Source::RowMemory(_) => "bytes",
        }
    }

    /// What the program calls it, if it is counted by this one.
    pub fn count_name(&self, build: &Build) -> Option<&'static str> {
        match self.source {
            Source::Count { count, .. } => self.builds().contains(build).then_some(count),
            Source::Memory { .. } | Source::RowMemory(_) => None,
        }
    }

    /// Looks its figure up in what was reported.
    pub fn figure(&self, counts: &Counts) -> anyhow::Result<Figure> {
        let (zrow, peer, checksums, equal) = match self.source {
            Source::Memory { build, what } => (what.bytes(build, counts)? as f64, None, vec![], true),
            Source::RowMemory(bytes) => (bytes as f64, None, vec![], true),
            Source::Count { count, door, peer, .. } => {
                let build = self.builds()[0];
                let zrow = counts.count(build, count, door)?;
                let (other, published) = match peer {
                    Peer::Door(other) | Peer::Sibling(other) => (Some(counts.count(build, count, other)?), None),
                    Peer::Published(mean) => (None, Some(mean)),
                    Peer::Rasterizer(other) => (Some(counts.count(RASTERIZERS, count, other)?), None),
                    Peer::None => (None, None),
                };
                let measured = other
                    .filter(|_| matches!(peer, Peer::Door(_) | Peer::Rasterizer(_)))
                    .map(|other| other.mean());
                let is_rasterizer = matches!(peer, Peer::Rasterizer(_));
                let equal = other.is_none_or(|other| is_rasterizer || other.checksum == zrow.checksum)
                    && counts.same_everywhere(count, door);
                let mut checksums = vec![zrow.checksum];
                checksums.extend(other.filter(|_| is_rasterizer).map(|other| other.checksum));
                (zrow.mean(), measured.or(published), checksums, equal)
            }
        };
        Ok(Figure {
            case: self.clone(),
            zrow,
            peer,
            checksums,
            equal,
        })
    }
}

impl What {
    fn bytes(self, build: Build, counts: &Counts) -> anyhow::Result<u64> {
        let memory = counts.memory(build)?;
        let stack = || {
            memory
                .stack
                .with_context(|| format!("{} reported no stack", build.firmware))
        };
        Ok(match self {
            Self::Flash => memory.flash,
            Self::NetFlash(firmware) => {
                let baseline = counts.memory(build.baseline(firmware))?;
                memory.flash.saturating_sub(baseline.flash)
            }
            Self::Statics => memory.statics,
            Self::Stack => stack()?,
            Self::RamBeside(bytes) => (memory.statics + stack()?).saturating_sub(bytes),
        })
    }
}

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
    let tiers = [("signed_area", 1.0), ("inside_area", 1.5)];
    counts.into_iter().flat_map(move |(count, shape, bar)| {
        tiers.into_iter().flat_map(move |(door, factor)| {
            RASTERIZER_DOORS.into_iter().map(move |peer| Case {
                name: format!("{count}.{door}.{peer}"),
                title: format!("cover 48 x 48 px with {shape}: {door} and {peer}"),
                target: V7EM,
                bar: bar.map(|bar| bar * factor),
                source: Source::Count {
                    firmware: "coverage",
                    count,
                    door,
                    peer: Peer::Rasterizer(peer),
                },
            })
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
    bar: f64,
}

impl Scene {
    /// A frame up to its finished rows, what of it is preparing, and the frame on a display.
    fn cases(&self) -> impl Iterator<Item = Case> {
        [
            ("", "", "draw", Peer::Published(self.small3dlib), Some(self.bar)),
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
        .map(|(suffix, what, door, peer, bar)| Case {
            name: format!("{}{suffix}", self.count),
            title: format!("{}{what}", self.title),
            target: self.target,
            bar,
            source: Source::Count {
                firmware: "scenes",
                count: self.count,
                door,
                peer,
            },
        })
    }
}

const fn scene(count: &'static str, title: &'static str, target: &'static str, small3dlib: f64, bar: f64) -> Scene {
    Scene {
        count,
        title,
        target,
        small3dlib,
        bar,
    }
}

const SCENES: &[Scene] = &[
    scene("scene.sc1", "sc1: torus and cube, 588 faces", V7M, 519_017.0, 220_000.0),
    scene("scene.sc2", "sc2: icosphere, 320 faces", V7M, 373_187.0, 140_000.0),
    scene("scene.sc3", "sc3: cube, 12 faces", V7M, 164_148.0, 60_000.0),
    scene(
        "scene.sc1",
        "sc1: torus and cube, 588 faces",
        V6M,
        1_439_195.0,
        500_000.0,
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
    /// Bytes of RAM that the bar leaves out.
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
                    bar: match (what, level) {
                        (What::NetFlash(_), Level::Size) => self.flash_bar,
                        (What::RamBeside(_), _) => self.ram_bar,
                        _ => None,
                    },
                    source: Source::Memory {
                        build: Build {
                            target: V7M,
                            level,
                            feature: None,
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
        title: "sc1 through the depth row, no face cut",
        baseline: "footprint_mesh",
        net: "flash, without runtime, harness and mesh",
        beside: 0,
        ram_bar: Some(9.0 * 1024.0),
        flash_bar: Some(8.0 * 1024.0),
    },
    Footprint {
        firmware: "footprint_depth_cutting",
        name: "depth.cutting",
        title: "sc1 through the depth row, faces may be cut",
        baseline: "footprint_mesh",
        net: "flash, without runtime, harness and mesh",
        beside: 0,
        ram_bar: None,
        flash_bar: None,
    },
    Footprint {
        firmware: "footprint_both",
        name: "both",
        title: "2D shapes and sc1, no face cut",
        baseline: "footprint_mesh",
        net: "flash, without runtime, harness and mesh",
        beside: 0,
        ram_bar: None,
        flash_bar: None,
    },
];

/// A family of 2D shapes that one program draws alone through a row of 240 pixels, for the memory that takes.
struct Family {
    /// The program's feature; `None` is every family.
    feature: Option<&'static str>,
    title: &'static str,
}

impl Family {
    /// The cases of a family of shapes: the flash of its program less that of an empty one, at opt-levels 3 and "s", and its
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
            name: format!("{kind}.{}.{suffix}", self.feature.unwrap_or("family_all")),
            title: format!("{}: {description}", self.title),
            target: V7M,
            bar: None,
            source: Source::Memory {
                build: Build {
                    target: V7M,
                    level,
                    feature: self.feature,
                    firmware: "footprint_shape",
                },
                what,
            },
        })
    }
}

const fn family(feature: &'static str, title: &'static str) -> Family {
    Family {
        feature: Some(feature),
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
        feature: None,
        title: "all families of 2D shapes",
    },
];

/// A shape at 240 x 320 RGB565.
struct Shape {
    count: &'static str,
    title: &'static str,
    /// Instructions on thumbv7em, through the fastest door.
    bar: Option<f64>,
    /// The firmware's doors: name, and what has to draw the same pixels. The first one has the bar.
    doors: &'static [(&'static str, Peer)],
}

/// Both doors of zrow, held against the peer.
const DOORS: &[(&str, Peer)] = &[("fast", Peer::Door("peer")), ("draw", Peer::Door("peer"))];

impl Shape {
    const fn new(count: &'static str, title: &'static str, bar: f64) -> Self {
        Self {
            bar: Some(bar),
            ..Self::without_bar(count, title)
        }
    }

    const fn without_bar(count: &'static str, title: &'static str) -> Self {
        Self {
            count,
            title,
            bar: None,
            doors: DOORS,
        }
    }

    /// A case for each door.
    fn cases(&self, target: &'static str) -> impl Iterator<Item = Case> {
        self.doors.iter().enumerate().map(move |(index, &(door, peer))| Case {
            name: if index == 0 {
                self.count.to_owned()
            } else {
                format!("{}.{door}", self.count)
            },
            title: self.title.to_owned(),
            target,
            bar: self.bar.filter(|_| index == 0 && target == V7EM),
            source: Source::Count {
                firmware: "shapes",
                count: self.count,
                door,
                peer,
            },
        })
    }
}

const SHAPES: &[Shape] = &[
    Shape {
        doors: &[("draw", Peer::Door("peer"))],
        ..Shape::new("clear", "clear", 24_000.0)
    },
    Shape::new("line.on_screen", "1-px line, end points on screen", 1_900.0),
    Shape::new(
        "line.off_screen",
        "1-px line, end points up to 3,000 px off screen",
        500.0,
    ),
    Shape::new("circle.outline", "circle outline, r = 50", 3_000.0),
    Shape {
        doors: &[("fast", Peer::Sibling("draw")), ("draw", Peer::Sibling("fast"))],
        ..Shape::without_bar("circle.thin", "thin Bresenham circle, r = 50")
    },
    Shape::new("circle.filled", "circle filled, r = 50", 8_000.0),
    Shape::new("triangle.filled", "triangle filled, random", 9_000.0),
    Shape::new("triangle.small", "triangle filled, within 16 px", 600.0),
    Shape::new("rectangle.filled", "rectangle 100 x 100 filled", 7_000.0),
    Shape::new("ellipse.filled", "ellipse 120 x 80 filled", 8_000.0),
    Shape::without_bar("arc.outline", "arc r = 50 from 90 to 270 degrees, 1-px stroke"),
    Shape::without_bar("sector.filled", "sector r = 50 of 120 degrees filled"),
    Shape::without_bar("rounded.equal", "rounded rectangle 100 x 60, r = 12, filled"),
    Shape::without_bar(
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
