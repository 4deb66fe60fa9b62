//! One figure to be measured: by which program on which target, beside which peer, within which budget.

use anyhow::Context;

use crate::{
    counts::Counts,
    firmware::{Build, Level},
};

/// Cortex-M4.
pub const V7EM: &str = "thumbv7em-none-eabi";
/// Cortex-M0: no divide, no long multiply.
pub const V6M: &str = "thumbv6m-none-eabi";
/// Cortex-M3.
pub const V7M: &str = "thumbv7m-none-eabi";
/// Cortex-M4 with its floating-point unit in use, for peers that compute in `f32`.
pub const V7EM_HARD_FLOAT: &str = "thumbv7em-none-eabihf";

/// Rasterizers with antialiasing.
pub const RASTERIZERS: Build = Build {
    target: V7EM_HARD_FLOAT,
    level: Level::Speed,
    content: None,
    firmware: "coverage_peers",
};

/// What their program calls them.
pub const RASTERIZER_VARIANTS: [&str; 3] = ["zeno", "ab_glyph_rasterizer", "tiny_skia"];

/// The program that counts what is predicted.
pub const ESTIMATES: &str = "estimates";

/// How far a prediction may be from what was counted, as a part of that.
const PREDICTION_ERROR: f64 = 0.15;

/// One figure to be measured.
#[derive(Clone, Debug)]
pub struct Case {
    pub name: String,
    pub title: String,
    pub target: &'static str,
    /// What `zrow` may take at most, in instructions or bytes.
    pub budget: Option<f64>,
    /// Estimated cycles that a count may take at most.
    pub cycles_budget: Option<f64>,
    pub source: Source,
}

#[derive(Clone, Debug)]
pub enum Source {
    /// Instructions of one operation, drawn through a variant.
    Count {
        firmware: &'static str,
        count: &'static str,
        variant: &'static str,
        peer: Peer,
    },
    /// Instructions that `Prepared::estimate` predicts for drawing a scene, beside those that it takes.
    Prediction { count: &'static str },
    /// Instructions of predicting.
    PredictionCost { count: &'static str },
    /// Bytes that a program takes.
    Memory { build: Build, what: What },
    /// Bytes of row memory, which follow from types.
    RowMemory(usize),
}

#[derive(Clone, Copy, Debug)]
pub enum What {
    Flash,
    /// Without what this program takes, built in the same way.
    NetFlash(&'static str),
    /// Without what this program takes, built in the same way and with the same content.
    NetCode(&'static str),
    Statics,
    Stack,
    /// Statics and stack, without so many bytes.
    RamBeside(u64),
}

/// What a count is held against.
#[derive(Clone, Copy, Debug)]
pub enum Peer {
    /// Another variant of the same firmware, which did the same work: the checksums have to be equal.
    Variant(&'static str),
    /// A sibling in zrow with the same result: the checksums have to be equal, but it is no peer.
    Sibling(&'static str),
    /// Another rasterizer in a program of its own, which draws other pixels.
    Rasterizer(&'static str),
    /// Measured separately: instructions of small3dlib on the same machine with the same scene.
    Published(f64),
    None,
}

impl Case {
    /// A variant of a count; `default` is the variant that has to give the same result.
    pub fn sibling(
        firmware: &'static str,
        count: &'static str,
        title: &str,
        target: &'static str,
        variant: &'static str,
        default: Option<&'static str>,
    ) -> Self {
        Self {
            name: format!("{count}.{variant}"),
            title: title.to_owned(),
            target,
            budget: None,
            cycles_budget: None,
            source: Source::Count {
                firmware,
                count,
                variant,
                peer: default.map_or(Peer::None, Peer::Sibling),
            },
        }
    }

    /// A variant of a count in the program of the other rasterizers, by itself.
    pub fn rasterizer(count: &'static str, variant: &'static str) -> Self {
        let target = RASTERIZERS.target;
        Self::sibling(RASTERIZERS.firmware, count, count, target, variant, None)
    }

    /// The flash that a sibling adds to a program that does nothing, at opt-level "s".
    pub fn sibling_flash(variant: &'static str) -> Self {
        Self {
            name: format!("flash.sibling.{variant}"),
            title: format!("{variant}: flash, without runtime and harness, at opt-level s"),
            target: V7M,
            budget: None,
            cycles_budget: None,
            source: Source::Memory {
                build: Build {
                    target: V7M,
                    level: Level::Size,
                    content: Some(variant),
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
            budget: None,
            cycles_budget: None,
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
                    content: None,
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
            Source::Prediction { .. } | Source::PredictionCost { .. } => vec![Build {
                target: self.target,
                level: Level::Speed,
                content: None,
                firmware: ESTIMATES,
            }],
            Source::Memory {
                build,
                what: What::NetFlash(baseline),
            } => vec![build, build.baseline(baseline)],
            Source::Memory {
                build,
                what: What::NetCode(firmware),
            } => vec![build, Build { firmware, ..build }],
            Source::Memory { build, .. } => vec![build],
            Source::RowMemory(_) => vec![],
        }
    }

    /// Whether it counts instructions of a Cortex-M4.
    pub fn is_count_on_m4(&self) -> bool {
        matches!(self.source, Source::Count { .. }) && [V7EM, V7EM_HARD_FLOAT].contains(&self.target)
    }

    /// Whether it is what a program takes.
    pub fn is_memory(&self) -> bool {
        matches!(self.source, Source::Memory { .. })
    }

    /// What it counts.
    pub fn unit(&self) -> &'static str {
        match self.source {
            Source::Count { .. } | Source::PredictionCost { .. } => "instructions per operation",
            Source::Prediction { .. } => "instructions predicted for drawing, those counted as the peer",
            Source::Memory { .. } | Source::RowMemory(_) => "bytes",
        }
    }

    /// What the program calls it, if it is counted by this one.
    pub fn count_name(&self, build: &Build) -> Option<&'static str> {
        match self.source {
            Source::Count { count, .. } | Source::Prediction { count } | Source::PredictionCost { count } => {
                self.builds().contains(build).then_some(count)
            }
            Source::Memory { .. } | Source::RowMemory(_) => None,
        }
    }

    /// Looks its figure up in what was reported.
    pub fn figure(&self, counts: &Counts) -> anyhow::Result<Figure> {
        let (zrow, cycles, peer, peer_cycles, checksums, equal) = match self.source {
            Source::Memory { build, what } => {
                let bytes = what.bytes(build, counts)?;
                (bytes as f64, None, None, None, vec![], true)
            }
            Source::RowMemory(bytes) => (bytes as f64, None, None, None, vec![], true),
            Source::Prediction { count } => {
                let build = self.builds()[0];
                let (counted, checksum) = difference(counts, build, count, ["draw", "estimate"])?;
                let equal = counts.same_everywhere(count, "draw");
                let predicted = counts.prediction(build, count)?;
                (predicted, None, Some(counted), None, vec![checksum], equal)
            }
            Source::PredictionCost { count } => {
                let (counted, checksum) = difference(counts, self.builds()[0], count, ["estimate", "prepare"])?;
                (counted, None, None, None, vec![checksum], true)
            }
            Source::Count {
                count, variant, peer, ..
            } => {
                let build = self.builds()[0];
                let zrow = counts.count(build, count, variant)?;
                let (other, published) = match peer {
                    Peer::Variant(other) | Peer::Sibling(other) => (Some(counts.count(build, count, other)?), None),
                    Peer::Published(mean) => (None, Some(mean)),
                    Peer::Rasterizer(other) => (Some(counts.count(RASTERIZERS, count, other)?), None),
                    Peer::None => (None, None),
                };
                let of_peer = other.filter(|_| matches!(peer, Peer::Variant(_) | Peer::Rasterizer(_)));
                let measured = of_peer.map(|other| other.mean());
                let peer_cycles = of_peer.and_then(|other| other.mean_cycles());
                let is_rasterizer = matches!(peer, Peer::Rasterizer(_));
                let equal = other.is_none_or(|other| is_rasterizer || other.checksum == zrow.checksum)
                    && counts.same_everywhere(count, variant);
                let mut checksums = vec![zrow.checksum];
                checksums.extend(other.filter(|_| is_rasterizer).map(|other| other.checksum));
                (
                    zrow.mean(),
                    zrow.mean_cycles(),
                    measured.or(published),
                    peer_cycles,
                    checksums,
                    equal,
                )
            }
        };
        Ok(Figure {
            case: self.clone(),
            zrow,
            cycles,
            peer,
            peer_cycles,
            checksums,
            equal,
        })
    }
}

/// Instructions of an operation through one variant beyond those through another one, and the checksum of the first.
fn difference(counts: &Counts, build: Build, count: &str, variants: [&str; 2]) -> anyhow::Result<(f64, u32)> {
    let [whole, part] = variants.map(|variant| counts.count(build, count, variant));
    let (whole, part) = (whole?, part?);
    Ok((whole.mean() - part.mean(), whole.checksum))
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
            Self::NetCode(firmware) => {
                let data = counts.memory(Build { firmware, ..build })?;
                memory.flash.saturating_sub(data.flash)
            }
            Self::Statics => memory.statics,
            Self::Stack => stack()?,
            Self::RamBeside(bytes) => (memory.statics + stack()?).saturating_sub(bytes),
        })
    }
}

/// One measured figure.
#[derive(Clone, Debug)]
pub struct Figure {
    pub case: Case,
    pub zrow: f64,
    /// Estimated cycles of a count.
    pub cycles: Option<f64>,
    pub peer: Option<f64>,
    /// Estimated cycles of the peer.
    pub peer_cycles: Option<f64>,
    /// Of the pixels it drew, and of those that a peer drew otherwise.
    pub checksums: Vec<u32>,
    /// Whether whatever does the same work, peers and other targets, drew the same pixels.
    pub equal: bool,
}

impl Figure {
    /// Whether all budgets are kept, if there is one. Cycles that were not estimated break none.
    pub fn pass(&self) -> Option<bool> {
        let in_number = match (&self.case.source, self.peer) {
            (Source::Prediction { .. }, Some(counted)) => {
                Some((self.zrow - counted).abs() <= PREDICTION_ERROR * counted)
            }
            _ => self.case.budget.map(|budget| self.zrow <= budget),
        };
        let estimated = self.case.cycles_budget.zip(self.cycles);
        let in_cycles = estimated.map(|(budget, cycles)| cycles <= budget);
        let is_kept = match (in_number, in_cycles) {
            (Some(one), Some(other)) => one && other,
            (one, other) => one.or(other)?,
        };
        Some(is_kept && self.void_reason().is_none())
    }

    /// Why the figure says nothing.
    pub fn void_reason(&self) -> Option<String> {
        let Case { name, target, .. } = &self.case;
        (!self.equal).then(|| format!("{name} on {target}: its checksum is not that of the same work done otherwise"))
    }
}
