//! Siblings: algorithms with the same signature, counted side by side with the same inputs.

use super::cases::{Case, V6M, V7EM};

/// Algorithms with the same signature. Each is a door of each count of one firmware.
struct Family {
    firmware: &'static str,
    /// Name and title of each count.
    counts: &'static [(&'static str, &'static str)],
    /// The first one is the default.
    siblings: &'static [Sibling],
}

/// One of a family.
#[derive(Clone, Copy)]
struct Sibling {
    /// Its module in zrow, by which the firmware knows it too; a feature of the same name links nothing but this one.
    door: &'static str,
    /// Whether it has to give the default's result, pixel by pixel.
    is_exact: bool,
}

const fn exact(door: &'static str) -> Sibling {
    Sibling { door, is_exact: true }
}

/// A case for each count and sibling, on a core with and without a divider, and the flash of each sibling.
pub fn cases() -> impl Iterator<Item = Case> {
    let counts = [V7EM, V6M]
        .into_iter()
        .flat_map(|target| FAMILIES.iter().flat_map(move |family| family.cases(target)));
    let siblings = FAMILIES.iter().flat_map(|family| family.siblings);
    counts.chain(siblings.map(|sibling| Case::sibling_flash(sibling.door)))
}

impl Family {
    fn cases(&'static self, target: &'static str) -> impl Iterator<Item = Case> {
        self.counts.iter().flat_map(move |(count, title)| {
            self.siblings.iter().map(move |sibling| {
                let default = self.siblings.first().filter(|_| sibling.is_exact);
                let default = default.map(|default| default.door);
                Case::sibling(self.firmware, count, title, target, sibling.door, default)
            })
        })
    }
}

const FAMILIES: &[Family] = &[Family {
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
    ],
    siblings: &[exact("liang_barsky"), exact("cohen_sutherland")],
}];
