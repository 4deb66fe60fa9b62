//! Draws the demo scenes into picture files and reports what they cost.

mod animation;
mod draw;
mod files;
mod report;
mod window;

use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::Context;
use clap::builder::PossibleValuesParser;
use embedded_graphics_simulator::OutputSettingsBuilder;
use indicatif::{ProgressBar, ProgressStyle};
use zrow_scenes::{Scene, Visitor};

use draw::Player;
use report::Report;

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
    output: Option<PathBuf>,
    /// Magnify each pixel N times [default: what suits the panel]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=16))]
    scale: Option<u32>,
    /// Frames of each animation [default: one whole turn]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    frames: Option<u32>,
    /// Show the scene in a window until it is closed (cargo feature `window`, needs SDL2)
    #[arg(long, requires = "scene")]
    window: bool,
}

/// Runs the command.
pub fn run(options: &Options) -> anyhow::Result<()> {
    if options.window {
        return window::show(options);
    }
    let folder = options.output.clone().unwrap_or_else(default_folder);
    fs::create_dir_all(&folder).with_context(|| format!("cannot make the folder {}", folder.display()))?;
    let mut gallery = Gallery::new(options, &folder)?;
    visit(options, &mut gallery);
    let (report, written) = gallery.finish()?;
    println!("{report}");
    println!("{written} files in {}", folder.display());
    Ok(())
}

fn visit(options: &Options, visitor: &mut impl Visitor) {
    zrow_scenes::visit(options.scene.as_deref(), visitor);
}

fn default_folder() -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    workspace.canonicalize().unwrap_or(workspace).join("target/gallery")
}

/// Output settings of a scene: the scale that was asked for, or one that suits its size.
fn output_settings<S: Scene>(options: &Options) -> embedded_graphics_simulator::OutputSettings {
    let width = S::AREA.size.width.max(1);
    let fitting = (PICTURE_WIDTH / width).max(1);
    OutputSettingsBuilder::new()
        .scale(options.scale.unwrap_or(fitting))
        .build()
}

/// Frames of a scene's animation; 1 for a still picture.
fn frames<S: Scene>(options: &Options) -> u32 {
    match S::FRAMES {
        1 => 1,
        whole_turn => options.frames.unwrap_or(whole_turn),
    }
}

/// Draws every scene it visits into files, until something fails.
struct Gallery<'a> {
    options: &'a Options,
    folder: &'a Path,
    report: Report,
    written: usize,
    progress: ProgressBar,
    failure: anyhow::Result<()>,
}

impl<'a> Gallery<'a> {
    fn new(options: &'a Options, folder: &'a Path) -> anyhow::Result<Self> {
        let mut total = Total { options, frames: 0 };
        visit(options, &mut total);
        let style = ProgressStyle::with_template("{msg:14} {bar:40} {pos}/{len} frames")?;
        Ok(Self {
            options,
            folder,
            report: Report::default(),
            written: 0,
            progress: ProgressBar::new(total.frames).with_style(style),
            failure: Ok(()),
        })
    }

    fn finish(self) -> anyhow::Result<(Report, usize)> {
        self.progress.finish_and_clear();
        self.failure.map(|()| (self.report, self.written))
    }

    fn draw_scene<S: Scene>(&mut self) -> anyhow::Result<()> {
        self.progress.set_message(S::NAME);
        let settings = output_settings::<S>(self.options);
        let mut player = Player::<S>::default();
        let portrait = player.image(S::PORTRAIT, &settings)?;
        self.write(S::NAME, "png", &files::png(&portrait)?)?;
        let frames = frames::<S>(self.options);
        if frames > 1 {
            let images = (0..frames).map(|frame| {
                self.progress.inc(1);
                player.image(frame, &settings)
            });
            let animation = animation::gif(images.collect::<anyhow::Result<Vec<_>>>()?)?;
            self.write(S::NAME, "gif", &animation)?;
        } else {
            self.progress.inc(1);
        }
        self.report.add::<S>(player.frames_per_second(frames)?);
        Ok(())
    }

    fn write(&mut self, name: &str, extension: &str, bytes: &[u8]) -> anyhow::Result<()> {
        let path = self.folder.join(name).with_extension(extension);
        fs::write(&path, bytes).with_context(|| format!("cannot write {}", path.display()))?;
        self.written += 1;
        Ok(())
    }
}

impl Visitor for Gallery<'_> {
    fn visit<S: Scene>(&mut self) {
        if self.failure.is_ok() {
            self.failure = self.draw_scene::<S>().with_context(|| format!("scene {}", S::NAME));
        }
    }
}

/// Adds up the frames that there are to draw.
struct Total<'a> {
    options: &'a Options,
    frames: u64,
}

impl Visitor for Total<'_> {
    fn visit<S: Scene>(&mut self) {
        self.frames += u64::from(frames::<S>(self.options));
    }
}
