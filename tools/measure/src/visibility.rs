//! What each method of visibility costs, over the number of faces and of layers: instructions, cycles, flash and RAM.

use anyhow::Context;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::I16F16;
use zrow::{
    band::Band,
    geometry::TooSmall,
    scene::{Camera, Memory},
    visible::{DepthBuffer, DepthSort, GridRayCasting, RayCasting, SpanScanLine, TileBins, Warnock},
};
use zrow_methods::{HIDDEN_SURFACES, HiddenSurfaces};
use zrow_scenes::hidden::{HiddenFaces, MOST_FACES, MOST_VERTICES, SPHERES};

use crate::{
    case::{Case, Peer, Source, V6M, V7EM, V7M, What},
    firmware::{Build, Level},
};

/// The cores that are counted.
pub const CORES: [&str; 2] = [V7EM, V6M];

/// A scene that is drawn by all methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stage {
    /// The name of its counts.
    pub name: &'static str,
    /// The number of faces, or of layers.
    pub number: usize,
}

/// One axis: what grows, and the scenes.
#[derive(Debug, Clone, Copy)]
pub struct Axis {
    /// The name of its table.
    pub name: &'static str,
    pub title: &'static str,
    pub stages: &'static [Stage],
}

macro_rules! stages {
    ($prefix:literal: $($number:literal)+) => {
        &[$(Stage { name: concat!($prefix, stringify!($number)), number: $number }),+]
    };
}

/// All axes; the first one is that of faces, the others are those of layers.
pub const AXES: [Axis; 3] = [
    Axis {
        name: "faces",
        title: "faces",
        stages: stages!("visibility.faces.": 12 48 192 768 3072 4992),
    },
    Axis {
        name: "layers",
        title: "layers, a colour a face",
        stages: stages!("visibility.layers.": 1 2 4 8 16),
    },
    Axis {
        name: "textured",
        title: "layers, textured",
        stages: stages!("visibility.textured.": 1 2 4 8 16),
    },
];

/// Of each method in each scene of an axis thousands of instructions and of cycles; none where it is not counted.
pub type Counts = Vec<Vec<Option<[u64; 2]>>>;

impl Axis {
    /// Whether a method is counted in a scene.
    pub fn has(&self, method: &HiddenSurfaces, stage: Stage) -> bool {
        if self.name == "faces" {
            method.draws_faces(stage.number)
        } else {
            method.draws_layers(stage.number)
        }
    }
}

/// The name of a method's count in a scene.
pub fn count_name(stage: Stage, method: &HiddenSurfaces) -> String {
    format!("{}.{}", stage.name, method.name)
}

/// The name of a method's flash.
pub fn flash_name(method: &HiddenSurfaces) -> String {
    format!("visibility.{}.flash", method.name)
}

/// All cases: each scene by each method on two cores, and the flash of each method.
pub fn cases() -> impl Iterator<Item = Case> {
    let counts = CORES.into_iter().flat_map(|target| {
        AXES.iter().flat_map(move |axis| {
            axis.stages.iter().flat_map(move |&stage| {
                let methods = HIDDEN_SURFACES.iter().filter(move |method| axis.has(method, stage));
                methods.map(move |method| count(target, axis, stage, method))
            })
        })
    });
    counts.chain(HIDDEN_SURFACES.iter().filter_map(flash))
}

fn count(target: &'static str, axis: &Axis, stage: Stage, method: &HiddenSurfaces) -> Case {
    let [row, ..] = HIDDEN_SURFACES;
    Case {
        name: count_name(stage, method),
        title: format!("{} {}, by {}", stage.number, axis.title, method.title),
        target,
        budget: None,
        cycles_budget: None,
        source: Source::Count {
            firmware: "visibility",
            count: stage.name,
            variant: method.name,
            peer: if method.name == row.name {
                Peer::None
            } else {
                Peer::Sibling(row.name)
            },
        },
    }
}

fn flash(method: &HiddenSurfaces) -> Option<Case> {
    const CONTENTS: [&str; HIDDEN_SURFACES.len()] = [
        "visibility.row",
        "visibility.intervals",
        "visibility.buffer",
        "visibility.bins",
        "visibility.sort",
        "visibility.quarters",
        "visibility.rays",
        "visibility.grid",
        "visibility.one",
    ];
    let content = CONTENTS
        .into_iter()
        .find(|content| content.strip_prefix("visibility.") == Some(method.name))?;
    Some(Case {
        name: flash_name(method),
        title: format!(
            "a scene by {}: flash at opt-level s, without runtime and harness",
            method.title
        ),
        target: V7M,
        budget: None,
        cycles_budget: None,
        source: Source::Memory {
            build: Build {
                target: V7M,
                level: Level::Size,
                content: Some(content),
                firmware: "footprint_visibility",
            },
            what: What::NetFlash("footprint_empty"),
        },
    })
}

/// What a scene needs of a method's memory.
struct Needs {
    faces: usize,
    /// The most faces that cross a row.
    active: usize,
    /// How often a face meets a tile.
    tile_faces: usize,
}

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(128, 64));
const PIXELS: usize = 128 * 64;
const TILES: usize = 32;

/// The bytes that each method takes beside the scene, the row of depths, the active list and the band, for spheres of each number of
/// faces.
///
/// # Errors
/// A scene cannot be prepared.
pub fn memory() -> anyhow::Result<Vec<[usize; SPHERES.len()]>> {
    let mut scene = Box::new(HiddenFaces::EMPTY);
    let mut needs = Vec::new();
    for spheres in &SPHERES {
        scene.set_spheres(spheres);
        needs.push(needs_of(&scene)?);
    }
    let bytes = |method: &HiddenSurfaces| {
        let mut bytes = [0; SPHERES.len()];
        for (bytes, needs) in bytes.iter_mut().zip(&needs) {
            *bytes = bytes_of(method, needs);
        }
        bytes
    };
    Ok(HIDDEN_SURFACES.iter().map(bytes).collect())
}

fn needs_of(scene: &HiddenFaces) -> anyhow::Result<Needs> {
    let mut memory = Box::new(Memory::<Rgb565, MOST_VERTICES, MOST_FACES, 128, 64, 700>::new());
    let models = [scene.flat(16)?];
    let camera = Camera::new(AREA, I16F16::from_num(128))?;
    let mut prepared = memory.prepare(&camera, &models)?;
    let mut words = vec![0; PIXELS];
    let mut band = Band::<Rgb565>::new(AREA, &mut words)?;
    let drawn = prepared.draw_by(&mut TileBins::<u16, TILES, 0>::new(), &mut band);
    let tile_faces = match drawn {
        Err(TooSmall::TileFaces(needed)) => Some(needed),
        _ => None,
    };
    Ok(Needs {
        faces: scene.face_count(),
        active: prepared.active_needed(),
        tile_faces: tile_faces.context("no face meets a tile")?,
    })
}

/// The bytes of a method with room for what a scene needs: they grow by as many for each thing that there is room for.
fn bytes_of(method: &HiddenSurfaces, needs: &Needs) -> usize {
    let grown = |[none, one_hundred]: [usize; 2], number: usize| none + (one_hundred - none) * number / 100;
    match method.name {
        "intervals" => grown(
            [size_of::<SpanScanLine<0>>(), size_of::<SpanScanLine<100>>()],
            needs.active,
        ),
        "buffer" => size_of::<DepthBuffer<u16, PIXELS>>(),
        "bins" => grown(
            [
                size_of::<TileBins<u16, TILES, 0>>(),
                size_of::<TileBins<u16, TILES, 100>>(),
            ],
            needs.tile_faces,
        ),
        "sort" => grown(
            [size_of::<DepthSort<0, 200>>(), size_of::<DepthSort<100, 200>>()],
            needs.faces,
        ),
        "quarters" => grown([size_of::<Warnock<0>>(), size_of::<Warnock<100>>()], needs.faces),
        "rays" => grown([size_of::<RayCasting<0>>(), size_of::<RayCasting<100>>()], needs.faces),
        // With eight cells and sixteen entries for each face.
        "grid" => grown(
            [
                size_of::<GridRayCasting<0, 0, 0>>(),
                size_of::<GridRayCasting<100, 800, 1_600>>(),
            ],
            needs.faces,
        ),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use zrow_scenes::hidden::LAYERS;

    #[test]
    fn the_axes_are_the_scenes() {
        let [faces, layers, textured] = AXES.map(|axis| axis.stages.iter().map(|stage| stage.number));
        assert!(faces.eq(SPHERES.map(|spheres| spheres.faces)));
        assert!(layers.eq(LAYERS) && textured.eq(LAYERS));
    }

    #[test]
    fn each_method_has_its_flash() {
        assert_eq!(HIDDEN_SURFACES.iter().filter_map(flash).count(), HIDDEN_SURFACES.len());
    }

    #[test]
    fn memory_grows_with_what_there_is_room_for() -> anyhow::Result<()> {
        let [first, second] = [100, 1000].map(|faces| Needs {
            faces,
            active: faces,
            tile_faces: faces,
        });
        let sizes = [
            [size_of::<SpanScanLine<100>>(), size_of::<SpanScanLine<1000>>()],
            [size_of::<DepthBuffer<u16, PIXELS>>(); 2],
            [
                size_of::<TileBins<u16, TILES, 100>>(),
                size_of::<TileBins<u16, TILES, 1000>>(),
            ],
            [size_of::<DepthSort<100, 200>>(), size_of::<DepthSort<1000, 200>>()],
            [size_of::<Warnock<100>>(), size_of::<Warnock<1000>>()],
            [size_of::<RayCasting<100>>(), size_of::<RayCasting<1000>>()],
            [
                size_of::<GridRayCasting<100, 800, 1_600>>(),
                size_of::<GridRayCasting<1000, 8_000, 16_000>>(),
            ],
        ];
        for (method, sizes) in HIDDEN_SURFACES.iter().skip(1).zip(sizes) {
            // A type may end in up to seven bytes of padding.
            for (needs, size) in [&first, &second].into_iter().zip(sizes) {
                assert!(bytes_of(method, needs).abs_diff(size) < 16, "{}", method.name);
            }
        }
        assert_eq!(memory()?.len(), HIDDEN_SURFACES.len());
        Ok(())
    }
}
