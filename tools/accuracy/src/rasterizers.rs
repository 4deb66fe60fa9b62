//! Other rasterizers: the same figures into a mask, in time, instructions and error.
//!
//! They are no dependencies of this program: the benchmark `rounds` of `tools/bench` is built and run for their times and
//! masks.

use std::{
    ffi::OsString,
    fs,
    io::{BufRead, BufReader, Read},
    path::{Path, PathBuf},
    process::{Command, Stdio},
    thread,
};

use anyhow::{Context as _, ensure};
use serde::Deserialize;
use zrow_methods::{FIGURE_SIZES, Figure};

use super::{
    axis::{Axis, Cell, Chapter, Context, Entry, Summary},
    errors::Errors,
    picture::Picture,
    reference,
    timing::Spread,
};

/// Who fills masks too.
pub struct Rasterizers;

/// What its chips and the benchmark call each; those of zrow first.
const VARIANTS: &[(&str, Option<&str>)] = &[
    ("zrow signed_area", Some("signed_area")),
    ("zrow inside_area", Some("inside_area")),
    ("zeno", Some("zeno")),
    ("ab_glyph_rasterizer", Some("ab_glyph_rasterizer")),
    ("tiny_skia", Some("tiny_skia")),
    // It needs an operating system.
    ("raqote", None),
];

/// A line of the benchmark.
#[derive(Debug, Deserialize)]
struct Timed {
    figure: String,
    size: u32,
    rasterizer: String,
    ns: f64,
    #[serde(rename = "ns lower quartile")]
    low: f64,
    #[serde(rename = "ns upper quartile")]
    high: f64,
    rounds: usize,
}

impl Axis for Rasterizers {
    fn name(&self) -> &'static str {
        "rasterizers"
    }

    fn counts(&self) -> Vec<String> {
        let variants = || VARIANTS.iter().filter_map(|(_, variant)| *variant);
        let names = |(figure, size): (Figure, u32)| variants().map(move |variant| count_name(figure, size, variant));
        figures().flat_map(names).collect()
    }

    fn run(&self, context: &Context<'_>) -> anyhow::Result<Chapter> {
        let mut about = about();
        let found = if context.plan.quick {
            Err(anyhow::anyhow!("a quick run does not build them"))
        } else {
            run_benchmark(context.progress)
        };
        let mut entries = Vec::new();
        match &found {
            Ok((timed, masks)) => {
                for (figure, size) in figures() {
                    (context.progress)(figure.name());
                    entries.extend(entries_of(figure, size, timed, masks, context)?);
                }
            }
            Err(why) => about.push(format!("They were not run: {why:#}.")),
        }
        if let Ok((_, masks)) = &found {
            // Read already; what stays behind is not worth failing.
            let _ = fs::remove_dir_all(masks);
        }
        Ok(Chapter {
            name: self.name(),
            title: "Other rasterizers: the same figures into a mask",
            about,
            operation: "one figure",
            memory: None,
            figures: vec!["rms error in 1/255", "largest error in 1/255"],
            diagrams: Vec::new(),
            summaries: summaries(&entries),
            entries,
        })
    }
}

fn about() -> Vec<String> {
    vec![
        "Fills a mask of 8 bits a pixel from the corners on, nonzero rule, memory allocated anew each time as each interface \
         demands: a triangle, a ring of two circles of 128 and 96 corners, a {7/3} star and a letter with a hole, with \
         corners in 1/256 pixel, in squares of 16, 48 and 200 pixels. zrow's signed_area is its method T3, inside_area is T4 \
         (right where edges cross inside a pixel)."
            .to_owned(),
        "Ratios are to the fastest of the others, so below 1 is faster than all of them, and bold. On this host: cargo bench \
         -p zrow-bench --bench rounds, run by this command; Cargo's bench profile without overflow checks, zeno 0.3, \
         ab_glyph_rasterizer 0.1, tiny-skia 0.11, raqote 0.8 (the alpha of a picture, for it has no masks). With criterion's \
         statistics: cargo bench -p zrow-bench --bench coverage."
            .to_owned(),
        "On the emulated Cortex-M4 the others compute in its floating-point unit (thumbv7em-none-eabihf); zrow has integers \
         only (thumbv7em-none-eabi). Giving memory back costs them nothing there. raqote needs an operating system and was \
         not counted."
            .to_owned(),
    ]
}

fn figures() -> impl Iterator<Item = (Figure, u32)> {
    let sized = |figure| FIGURE_SIZES.into_iter().map(move |size| (figure, size));
    Figure::ALL.into_iter().flat_map(sized)
}

fn count_name(figure: Figure, size: u32, variant: &str) -> String {
    format!("{}.{variant}", figure.count_name(size))
}

fn group_name(figure: Figure, size: u32) -> String {
    format!("{}, {size} px", figure.name())
}

fn entries_of(
    figure: Figure,
    size: u32,
    timed: &[Timed],
    masks: &Path,
    context: &Context<'_>,
) -> anyhow::Result<Vec<Entry>> {
    let shape = figure.shape(size);
    let exact = reference::exact(&shape, size as usize);
    let entries = VARIANTS.iter().map(|(name, variant)| {
        let timed = timed
            .iter()
            .find(|timed| timed.figure == figure.name() && timed.size == size && timed.rasterizer == *name)
            .with_context(|| format!("the benchmark did not run {name} on {}", group_name(figure, size)))?;
        let mask = read_mask(&masks.join(format!("{}-{size}-{name}.pgm", figure.name())), size)?;
        let mut errors = Errors::default();
        errors.add_mask(&exact, &mask);
        Ok(Entry {
            group: group_name(figure, size),
            method: (*name).to_owned(),
            figures: vec![errors.rms(), errors.max()],
            memory_bytes: 0,
            time: Some(timed.spread()),
            chip: variant
                .map(|variant| context.counted.get(&count_name(figure, size, variant)))
                .unwrap_or_default(),
            picture: Some(Picture::of_coverage_in(size as usize, &shape, &exact, &mask)),
        })
    });
    entries.collect()
}

impl Timed {
    fn spread(&self) -> Spread {
        Spread {
            median: self.ns,
            low: self.low,
            high: self.high,
            rounds: self.rounds,
        }
    }
}

fn read_mask(path: &Path, size: u32) -> anyhow::Result<Vec<u8>> {
    let image = image::open(path).with_context(|| format!("cannot read {}", path.display()))?;
    let mask = image.into_luma8();
    ensure!(mask.dimensions() == (size, size), "{} has another size", path.display());
    Ok(mask.into_raw())
}

/// Builds and runs it; returns its lines and the folder of its masks.
fn run_benchmark(progress: &dyn Fn(&str)) -> anyhow::Result<(Vec<Timed>, PathBuf)> {
    let masks = std::env::temp_dir().join(format!("zrow-masks-{}", std::process::id()));
    fs::create_dir_all(&masks).with_context(|| format!("cannot make the folder {}", masks.display()))?;
    progress("building the other rasterizers");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut benchmark = Command::new(cargo)
        .args(["bench", "--quiet", "-p", "zrow-bench", "--bench", "rounds", "--"])
        .arg(&masks)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        // Set by `cargo run` for this program alone.
        .env_remove("LD_LIBRARY_PATH")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .context("cannot start cargo")?;
    // Read on meanwhile, because a full pipe would stop it.
    let complaints = benchmark.stderr.take().map(|mut stream| {
        thread::spawn(move || {
            let mut text = String::new();
            // What came before a broken pipe is worth showing.
            let _ = stream.read_to_string(&mut text);
            text
        })
    });
    let mut lines = String::new();
    for line in benchmark
        .stdout
        .take()
        .map(BufReader::new)
        .into_iter()
        .flat_map(BufRead::lines)
    {
        let line = line?;
        let name: Vec<&str> = line.split(',').take(3).collect();
        progress(&format!("timing {}", name.join(" ")));
        lines += &line;
        lines.push('\n');
    }
    let status = benchmark.wait()?;
    let complaints = complaints.and_then(|thread| thread.join().ok()).unwrap_or_default();
    ensure!(
        status.success(),
        "cargo bench -p zrow-bench failed:\n{}",
        complaints.trim_end()
    );
    Ok((parse(&lines)?, masks))
}

fn parse(lines: &str) -> anyhow::Result<Vec<Timed>> {
    let mut reader = csv::Reader::from_reader(lines.as_bytes());
    let timed = reader.deserialize().collect::<Result<Vec<Timed>, _>>();
    timed.context("the benchmark wrote something else")
}

/// A table of ratios for each cost, and one of errors.
fn summaries(entries: &[Entry]) -> Vec<Summary> {
    if entries.is_empty() {
        return Vec::new();
    }
    let time = |entry: &Entry| entry.time.map(|time| time.median);
    vec![
        summary(
            "Time by that of the fastest other one, on this host (median in ns)",
            entries,
            |entry, group| ratio(entry, group, time),
        ),
        summary(
            "Instructions by the fewest of another one, on the emulated Cortex-M4",
            entries,
            |entry, group| ratio(entry, group, |entry| entry.chip.instructions),
        ),
        summary("Root mean square error in 1/255", entries, |entry, _| Cell {
            text: format!("{:.2}", entry.error()),
            is_strong: false,
        }),
    ]
}

fn summary(title: &'static str, entries: &[Entry], cell: impl Fn(&Entry, &[Entry]) -> Cell) -> Summary {
    let mut columns = vec!["figure".to_owned()];
    columns.extend(VARIANTS.iter().map(|(name, _)| (*name).to_owned()));
    let rows = entries.chunk_by(|a, b| a.group == b.group).map(|group| {
        let first = Cell {
            text: group[0].group.clone(),
            is_strong: false,
        };
        std::iter::once(first)
            .chain(group.iter().map(|entry| cell(entry, group)))
            .collect()
    });
    Summary {
        title: title.to_owned(),
        columns,
        rows: rows.collect(),
    }
}

/// To the least of the others; strong where one of zrow's is below all of them.
fn ratio(entry: &Entry, group: &[Entry], cost: impl Fn(&Entry) -> Option<f64>) -> Cell {
    let is_zrow = |entry: &Entry| entry.method.starts_with("zrow");
    let others = group.iter().filter(|entry| !is_zrow(entry)).filter_map(&cost);
    let least = others.fold(f64::INFINITY, f64::min);
    match cost(entry) {
        Some(own) if least.is_finite() => Cell {
            text: format!("{:.2} ({})", own / least, super::digits::digits(own.round())),
            is_strong: is_zrow(entry) && own <= least,
        },
        _ => Cell {
            text: "not counted".to_owned(),
            is_strong: false,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::super::counted::Chip;
    use super::*;

    fn entry(method: &str, ns: f64, instructions: Option<f64>) -> Entry {
        Entry {
            group: "star, 48 px".to_owned(),
            method: method.to_owned(),
            figures: vec![0.25, 1.0],
            memory_bytes: 0,
            time: Some(Spread {
                median: ns,
                ..Spread::default()
            }),
            chip: Chip {
                instructions,
                ..Chip::default()
            },
            picture: None,
        }
    }

    #[test]
    fn ratios_are_to_the_fastest_of_the_others() {
        let entries = [
            entry("zrow signed_area", 50.0, Some(300.0)),
            entry("zeno", 100.0, Some(200.0)),
            entry("raqote", 400.0, None),
        ];
        let [time, instructions, error] = &summaries(&entries)[..] else {
            panic!("three tables");
        };
        let cells = |summary: &Summary| -> Vec<(String, bool)> {
            let cells = summary.rows[0].iter().skip(1);
            cells.map(|cell| (cell.text.clone(), cell.is_strong)).collect()
        };
        let weak = |text: &str| (text.to_owned(), false);
        assert_eq!(
            cells(time),
            [("0.50 (50)".to_owned(), true), weak("1.00 (100)"), weak("4.00 (400)")]
        );
        assert_eq!(
            cells(instructions),
            [weak("1.50 (300)"), weak("1.00 (200)"), weak("not counted")]
        );
        assert_eq!(cells(error)[0], weak("0.25"));
    }

    #[test]
    fn the_lines_of_the_benchmark_are_read() {
        let lines =
            "figure,size,rasterizer,ns,ns lower quartile,ns upper quartile,rounds\nstar,48,zeno,3.5,3.0,4.0,101\n";
        let timed = parse(lines).unwrap();
        assert_eq!(timed[0].rasterizer, "zeno");
        assert_eq!(
            timed[0].spread(),
            Spread {
                median: 3.5,
                low: 3.0,
                high: 4.0,
                rounds: 101
            }
        );
        assert!(parse("figure,size\nstar,48\n").is_err());
    }
}
