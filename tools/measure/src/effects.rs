//! What each effect costs the Utah teapot: instructions, cycles, flash and RAM.

use crate::{
    case::{Case, Peer, Source, V6M, V7EM, V7M, What},
    firmware::{Build, Level},
};

/// An effect: the name of its counts, and what it is in a few words.
#[derive(Debug, Clone, Copy)]
pub struct Effect {
    pub name: &'static str,
    pub what: &'static str,
}

macro_rules! list {
    ($($name:ident: $what:literal, $subject:ty, [$($look:tt)+];)+) => {
        /// All effects: none, each alone, and all at once.
        pub const EFFECTS: &[Effect] = &[$(Effect {
            name: concat!("effect.", stringify!($name)),
            what: $what,
        }),+];
    };
}
zrow_scenes::effects!(list);

/// All cases: two cores, flash, static RAM and stack of each effect.
pub fn cases() -> impl Iterator<Item = Case> {
    let counts = [V7EM, V6M]
        .into_iter()
        .flat_map(|target| EFFECTS.iter().map(move |effect| effect.count(target)));
    counts.chain(EFFECTS.iter().flat_map(Effect::memory))
}

impl Effect {
    /// A frame of the teapot.
    fn count(&self, target: &'static str) -> Case {
        Case {
            name: self.name.into(),
            title: format!("Utah teapot: {}", self.what),
            target,
            budget: None,
            cycles_budget: None,
            source: Source::Count {
                firmware: "effects",
                count: self.name,
                variant: "draw",
                peer: Peer::None,
            },
        }
    }

    /// The names of flash, static RAM and stack.
    pub fn memory_names(&self) -> [String; 3] {
        ["flash", "ram", "stack"].map(|kind| format!("{}.{kind}", self.name))
    }

    fn memory(&self) -> impl Iterator<Item = Case> {
        let kinds = [
            (
                "flash at opt-level s, without runtime, harness and model",
                What::NetCode("footprint_effect_model"),
                Level::Size,
            ),
            ("static RAM", What::Statics, Level::Size),
            ("deepest stack", What::Stack, Level::Size),
        ];
        self.memory_names()
            .into_iter()
            .zip(kinds)
            .map(|(name, (kind, what, level))| Case {
                name,
                title: format!("Utah teapot: {}: {kind}", self.what),
                target: V7M,
                budget: None,
                cycles_budget: None,
                source: Source::Memory {
                    build: Build {
                        target: V7M,
                        level,
                        content: Some(self.name),
                        firmware: "footprint_effect",
                    },
                    what,
                },
            })
    }
}
