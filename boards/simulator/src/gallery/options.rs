//! What the gallery is asked for: which scenes, where to, how large, how many frames.

use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use embedded_graphics_simulator::{OutputSettings, OutputSettingsBuilder};
use zrow_scenes::{Scene, Visitor};

/// Pictures are magnified to about this many pixels across.
const PICTURE_WIDTH: u32 = 640;

/// Options of this command.
#[derive(clap::Args)]
pub struct Options {
    /// Draw this scene only
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(zrow_scenes::NAMES))]
    scene: Option<String>,
    /// Folder for the pictures; it is made where it is missing [default: target/gallery of the workspace]
    #[arg(long, value_name = "FOLDER")]
    pub(super) output: Option<PathBuf>,
    /// Magnify each pixel N times [default: what suits the panel]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=16))]
    scale: Option<u32>,
    /// Frames of each animation [default: one whole turn]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    frames: Option<u32>,
    /// Show the scene in a window until it is closed (cargo feature `window`, needs SDL2)
    #[arg(long, requires = "scene")]
    pub(super) window: bool,
}

impl Options {
    /// Visits the scenes that are to be drawn.
    pub fn visit(&self, visitor: &mut impl Visitor) {
        zrow_scenes::visit(self.scene.as_deref(), visitor);
    }

    /// Output settings of a scene: the scale that was asked for, or one that suits its size.
    pub fn output_settings<S: Scene>(&self) -> OutputSettings {
        let width = S::AREA.size.width.max(1);
        let fitting = (PICTURE_WIDTH / width).max(1);
        OutputSettingsBuilder::new()
            .scale(self.scale.unwrap_or(fitting))
            .build()
    }

    /// Frames of a scene's animation; 1 for a still picture.
    pub fn frames<S: Scene>(&self) -> u32 {
        match S::FRAMES {
            1 => 1,
            whole_turn => self.frames.unwrap_or(whole_turn),
        }
    }
}
