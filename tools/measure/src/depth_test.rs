//! What is drawn into the rows of a scene by the test of its depths, and solids that are combined by rays.

use crate::{
    case::{Case, Peer, Source, V6M, V7EM, V7M, What},
    firmware::{Build, Level},
};

/// The cores that are counted.
pub const CORES: [&str; 2] = [V7EM, V6M];

/// What is counted beside others in one scene.
#[derive(Debug, Clone, Copy)]
pub struct Drawing {
    /// Its name in the firmware.
    variant: &'static str,
    pub title: &'static str,
    /// What has the same picture.
    same_as: Option<&'static str>,
    /// The name of a program that draws it alone.
    program: Option<&'static str>,
}

/// Several drawings of one scene: rows of a table.
#[derive(Debug, Clone, Copy)]
pub struct Group {
    /// The name of the counts and of the table.
    pub name: &'static str,
    /// What is drawn in the rows of which scene, or which solids.
    pub scene: &'static str,
    pub drawings: &'static [Drawing],
}

/// All that is counted.
pub const GROUPS: [Group; 2] = [
    Group {
        name: "depth_test",
        scene: "torus and cube in one band",
        drawings: &[
            drawing("nothing", "nothing beside it").linked_as("depth_test.nothing"),
            drawing("scene", "an icosphere, 320 faces, by `Prepared::draw_in`")
                .like("scene_as_model")
                .linked_as("depth_test.scene"),
            drawing("scene_as_model", "the icosphere as another model").like("scene"),
            drawing("lines", "its wireframe, by `draw_line`").linked_as("depth_test.lines"),
            drawing("polygon", "a star of 16 corners, by `draw_polygon`")
                .like("polygon_as_triangles")
                .linked_as("depth_test.polygon"),
            drawing("polygon_as_triangles", "the star as a model of 14 triangles").like("polygon"),
        ],
    },
    Group {
        name: "combined_solids",
        scene: "cube and sphere of 332 faces in one band",
        drawings: &[
            drawing("row", "by the depth row").like("rays"),
            drawing("rays", "by `RayCasting`").like("row"),
            drawing("union", "their union, by `SolidCombination`").like("row"),
            drawing("intersection", "their intersection"),
            drawing("difference", "the cube without the sphere").linked_as("depth_test.solids"),
        ],
    },
];

const fn drawing(variant: &'static str, title: &'static str) -> Drawing {
    Drawing {
        variant,
        title,
        same_as: None,
        program: None,
    }
}

impl Drawing {
    const fn like(self, other: &'static str) -> Self {
        Self {
            same_as: Some(other),
            ..self
        }
    }

    const fn linked_as(self, program: &'static str) -> Self {
        Self {
            program: Some(program),
            ..self
        }
    }

    /// The name of its count.
    pub fn count_name(&self, group: &Group) -> String {
        format!("{}.{}", group.name, self.variant)
    }

    /// The name of the flash of its program, if it has one.
    pub fn flash_name(&self, group: &Group) -> Option<String> {
        self.program.map(|_| format!("{}.flash", self.count_name(group)))
    }

    fn count(&self, group: &Group, target: &'static str) -> Case {
        Case {
            name: self.count_name(group),
            title: format!("{}: {}", group.scene, self.title),
            target,
            budget: None,
            cycles_budget: None,
            source: Source::Count {
                firmware: "depth_test",
                count: group.name,
                variant: self.variant,
                peer: self.same_as.map_or(Peer::None, Peer::Sibling),
            },
        }
    }

    fn flash(&self, group: &Group) -> Option<Case> {
        Some(Case {
            name: self.flash_name(group)?,
            title: format!(
                "a scene and {}: flash at opt-level s, without runtime and harness",
                self.title
            ),
            target: V7M,
            budget: None,
            cycles_budget: None,
            source: Source::Memory {
                build: Build {
                    target: V7M,
                    level: Level::Size,
                    content: Some(self.program?),
                    firmware: "footprint_depth_test",
                },
                what: What::NetFlash("footprint_empty"),
            },
        })
    }
}

/// Instructions and cycles on both cores.
pub fn cases() -> impl Iterator<Item = Case> {
    CORES.into_iter().flat_map(|target| {
        let groups = GROUPS.iter();
        groups.flat_map(move |group| group.drawings.iter().map(move |drawing| drawing.count(group, target)))
    })
}

/// The flash of programs that draw one of them each.
pub fn flash() -> impl Iterator<Item = Case> {
    GROUPS
        .iter()
        .flat_map(|group| group.drawings.iter().filter_map(|drawing| drawing.flash(group)))
}
