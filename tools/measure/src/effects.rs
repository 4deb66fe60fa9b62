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
    ($($name:ident: $what:literal, $subject:ty, through $target:ident: [$($look:tt)+];)+) => {
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
            ),
            ("static RAM", What::Statics),
            ("deepest stack", What::Stack),
        ];
        self.memory_names()
            .into_iter()
            .zip(kinds)
            .map(|(name, (kind, what))| Case {
                name,
                title: format!("Utah teapot: {}: {kind}", self.what),
                target: V7M,
                budget: None,
                cycles_budget: None,
                source: memory(self.name, what),
            })
    }
}

/// The memory of the teapot that has budgets: flash without any effect and under a light with a texture, and RAM of the latter.
pub fn budgeted() -> impl Iterator<Item = Case> {
    const FLAT: &str = "effect.nothing";
    const TEXTURED: &str = "effect.lit_texture";
    let code = What::NetCode("footprint_effect_model");
    [
        (
            "flash.flat",
            "a colour a face: flash at opt-level s, without runtime, harness and model",
            FLAT,
            code,
            8.2,
        ),
        (
            "flash.textured_lit",
            "textured and lit: flash at opt-level s, without runtime, harness and model",
            TEXTURED,
            code,
            14.0,
        ),
        (
            "ram.teapot",
            "textured and lit: RAM without the stack",
            TEXTURED,
            What::Statics,
            18.0,
        ),
    ]
    .into_iter()
    .map(|(name, title, content, what, kilobytes)| Case {
        name: name.into(),
        title: format!("Utah teapot, {title}"),
        target: V7M,
        budget: Some(kilobytes * 1024.0),
        cycles_budget: None,
        source: memory(content, what),
    })
}

/// A figure of the program that draws the teapot with an effect, at opt-level "s".
fn memory(effect: &'static str, what: What) -> Source {
    Source::Memory {
        build: Build {
            target: V7M,
            level: Level::Size,
            content: Some(effect),
            firmware: "footprint_effect",
        },
        what,
    }
}
