//! Draws the demo scenes into picture files and reports what they cost.

mod animation;
mod draw;
mod files;
mod options;
mod report;
mod window;

use std::{
    fs,
    num::NonZero,
    panic::resume_unwind,
    path::{Path, PathBuf},
    sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed},
    thread::{self, available_parallelism},
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
    let gallery = Gallery::new(options, &folder)?;
    gallery.draw_all()?;
    let report = gallery.time_all()?;
    println!("{report}");
    println!("{} files in {}", gallery.written.into_inner(), folder.display());
    Ok(())
}

fn default_folder() -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    workspace.canonicalize().unwrap_or(workspace).join("target/gallery")
}

/// The scenes that are drawn into picture files by some threads, the folder of these files, and which scenes are taken already.
struct Gallery<'a> {
    options: &'a Options,
    folder: &'a Path,
    /// Which scenes a thread has taken to draw, in the order of the catalogue.
    taken: Vec<AtomicBool>,
    written: AtomicUsize,
    progress: ProgressBar,
}

impl<'a> Gallery<'a> {
    fn new(options: &'a Options, folder: &'a Path) -> anyhow::Result<Self> {
        let mut total = Total {
            options,
            frames: 0,
            scenes: 0,
        };
        options.visit(&mut total);
        let style = ProgressStyle::with_template("{msg:14} {bar:40} {pos}/{len} frames")?;
        Ok(Self {
            options,
            folder,
            taken: (0..total.scenes).map(|_| AtomicBool::new(false)).collect(),
            written: AtomicUsize::new(0),
            progress: ProgressBar::new(total.frames).with_style(style),
        })
    }

    /// Draws every scene into files, on as many threads as the machine runs at a time: most of the time goes into encoding.
    fn draw_all(&self) -> anyhow::Result<()> {
        let threads = available_parallelism().map_or(1, NonZero::get).min(self.taken.len());
        let drawn = thread::scope(|scope| {
            let threads: Vec<_> = (0..threads).map(|_| scope.spawn(|| self.draw_untaken())).collect();
            let drawn = threads.into_iter().map(|thread| thread.join());
            drawn.collect::<Result<Vec<_>, _>>()
        });
        self.progress.finish_and_clear();
        match drawn {
            Ok(drawn) => drawn.into_iter().collect(),
            Err(panic) => resume_unwind(panic),
        }
    }

    /// Draws the scenes that no other thread has taken, until one fails.
    fn draw_untaken(&self) -> anyhow::Result<()> {
        let mut artist = Artist {
            gallery: self,
            next: 0,
            failure: Ok(()),
        };
        self.options.visit(&mut artist);
        artist.failure
    }

    /// Measures how fast each scene is, one after the other, so that none waits for another one.
    fn time_all(&self) -> anyhow::Result<Report> {
        let mut timing = Timing {
            options: self.options,
            report: Ok(Report::default()),
        };
        self.options.visit(&mut timing);
        timing.report
    }

    fn draw_scene<S: Scene>(&self) -> anyhow::Result<()> {
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
        Ok(())
    }

    fn write(&self, name: &str, extension: &str, bytes: &[u8]) -> anyhow::Result<()> {
        let path = self.folder.join(name).with_extension(extension);
        fs::write(&path, bytes).with_context(|| format!("cannot write {}", path.display()))?;
        self.written.fetch_add(1, Relaxed);
        Ok(())
    }
}

/// Draws the scenes that it visits and that no other thread has taken, until one fails.
struct Artist<'a> {
    gallery: &'a Gallery<'a>,
    /// The place of the next scene in the catalogue.
    next: usize,
    failure: anyhow::Result<()>,
}

impl Visitor for Artist<'_> {
    fn visit<S: Scene>(&mut self) {
        let is_taken = self.gallery.taken.get(self.next);
        self.next += 1;
        if self.failure.is_ok() && is_taken.is_some_and(|is_taken| !is_taken.swap(true, Relaxed)) {
            let drawn = self.gallery.draw_scene::<S>();
            self.failure = drawn.with_context(|| format!("scene {}", S::NAME));
        }
    }
}

/// Measures the scenes that it visits, until one fails.
struct Timing<'a> {
    options: &'a Options,
    report: anyhow::Result<Report>,
}

impl Timing<'_> {
    fn measure<S: Scene>(options: &Options, report: &mut Report) -> anyhow::Result<()> {
        let mut player = Player::<S>::default();
        let frames_per_second = player.frames_per_second(options.frames::<S>())?;
        report.add::<S>(frames_per_second, player.capacities_used());
        Ok(())
    }
}

impl Visitor for Timing<'_> {
    fn visit<S: Scene>(&mut self) {
        if let Ok(report) = &mut self.report
            && let Err(failure) = Self::measure::<S>(self.options, report)
        {
            self.report = Err(failure.context(format!("scene {}", S::NAME)));
        }
    }
}

/// Adds up the scenes and the frames that there are to draw.
struct Total<'a> {
    options: &'a Options,
    frames: u64,
    scenes: usize,
}

impl Visitor for Total<'_> {
    fn visit<S: Scene>(&mut self) {
        self.frames += u64::from(self.options.frames::<S>());
        self.scenes += 1;
    }
}
