//! Draws the demo scenes into picture files and reports what they cost.

mod animation;
mod draw;
mod files;
mod options;
mod report;
mod window;

use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::Context;
use indicatif::{ProgressBar, ProgressStyle};
use zrow_scenes::{Scene, Visitor};

pub use options::Options;

use draw::Player;
use report::Report;

/// Runs the command.
pub fn run(options: &Options) -> anyhow::Result<()> {
    if options.window {
        return window::show(options);
    }
    let folder = options.output.clone().unwrap_or_else(default_folder);
    fs::create_dir_all(&folder).with_context(|| format!("cannot make the folder {}", folder.display()))?;
    let mut gallery = Gallery::new(options, &folder)?;
    options.visit(&mut gallery);
    let (report, written) = gallery.finish()?;
    println!("{report}");
    println!("{written} files in {}", folder.display());
    Ok(())
}

fn default_folder() -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    workspace.canonicalize().unwrap_or(workspace).join("target/gallery")
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
        options.visit(&mut total);
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
        let settings = self.options.output_settings::<S>();
        let mut player = Player::<S>::default();
        let portrait = player.image(S::PORTRAIT, &settings)?;
        self.write(S::NAME, "png", &files::png(&portrait)?)?;
        let frames = self.options.frames::<S>();
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
        let frames_per_second = player.frames_per_second(frames)?;
        self.report.add::<S>(frames_per_second, player.capacities_used());
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
        self.frames += u64::from(self.options.frames::<S>());
    }
}
