//! What is measured, where, and the bar each figure has to reach.

use anyhow::bail;

use super::{
    counts::Counts,
    firmware::{Build, Level},
    report::Figure,
};

/// Cortex-M4.
const V7EM: &str = "thumbv7em-none-eabi";
/// Cortex-M0: no divide, no long multiply.
const V6M: &str = "thumbv6m-none-eabi";

/// One figure to be measured.
#[derive(Clone, Debug)]
pub struct Case {
    pub name: String,
    pub title: &'static str,
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
}

#[derive(Clone, Copy, Debug)]
enum Peer {
    /// Counted by the same firmware; the pixels are the same, so the checksums have to be.
    SamePixels,
    /// Counted by the same firmware; the pixels may differ.
    OtherPixels,
}

impl Case {
    /// The programs it needs.
    pub fn builds(&self) -> Vec<Build> {
        match self.source {
            Source::Count { firmware, .. } => vec![Build {
                target: self.target,
                level: Level::Speed,
                firmware,
            }],
        }
    }

    /// What the program calls it, if it is counted by this one.
    pub fn count_name(&self, build: &Build) -> Option<&'static str> {
        match self.source {
            Source::Count { count, .. } => self.builds().contains(build).then_some(count),
        }
    }

    /// Looks its figure up in what was reported.
    pub fn figure(&self, counts: &Counts) -> anyhow::Result<Figure> {
        let [build] = self.builds()[..] else {
            bail!("{} needs one program", self.name)
        };
        match self.source {
            Source::Count {
                count: name,
                door,
                peer,
                ..
            } => {
                let zrow = counts.count(build, name, door)?;
                let (peer, equal) = match peer {
                    Peer::OtherPixels => (Some(counts.count(build, name, "peer")?.mean()), None),
                    Peer::SamePixels => {
                        let peer = counts.count(build, name, "peer")?;
                        (Some(peer.mean()), Some(peer.checksum == zrow.checksum))
                    }
                };
                Ok(Figure {
                    case: self.clone(),
                    zrow: zrow.mean(),
                    peer,
                    equal,
                })
            }
        }
    }
}

/// Everything there is to measure.
pub fn all() -> Vec<Case> {
    let shapes = |target| SHAPES.iter().flat_map(move |shape| shape.cases(target));
    [V7EM, V6M].into_iter().flat_map(shapes).collect()
}

/// A shape at 240 x 320 RGB565.
struct Shape {
    count: &'static str,
    title: &'static str,
    /// Instructions on thumbv7em, through the fastest door.
    bar: f64,
    peer: Peer,
    doors: &'static [&'static str],
}

impl Shape {
    const fn new(count: &'static str, title: &'static str, bar: f64, peer: Peer) -> Self {
        Self {
            count,
            title,
            bar,
            peer,
            doors: &["fast", "draw"],
        }
    }

    /// A case for each door; the first has the bar.
    fn cases(&self, target: &'static str) -> impl Iterator<Item = Case> {
        self.doors.iter().enumerate().map(move |(index, door)| Case {
            name: if index == 0 {
                self.count.to_owned()
            } else {
                format!("{}.{door}", self.count)
            },
            title: self.title,
            target,
            bar: (index == 0 && target == V7EM).then_some(self.bar),
            source: Source::Count {
                firmware: "shapes",
                count: self.count,
                door,
                peer: self.peer,
            },
        })
    }
}

const SHAPES: &[Shape] = &[
    Shape {
        doors: &["draw"],
        ..Shape::new("clear", "clear", 24_000.0, Peer::SamePixels)
    },
    Shape::new(
        "line.on_screen",
        "1-px line, end points on screen",
        1_900.0,
        Peer::OtherPixels,
    ),
    Shape::new(
        "line.off_screen",
        "1-px line, end points up to 3,000 px off screen",
        500.0,
        Peer::OtherPixels,
    ),
];
