//! Reads what a firmware reported, and the sizes of its program.

use std::{collections::HashMap, fs};

use anyhow::{Context, bail, ensure};
use object::{Object, ObjectSection};

use crate::firmware::{Build, Run};

/// One timing: `operations` operations took `instructions` in all.
#[derive(Clone, Copy, Debug)]
pub struct Count {
    pub operations: u32,
    pub instructions: u64,
    /// Estimated; none where the plugin was not there.
    pub cycles: Option<u64>,
    pub checksum: u32,
}

impl Count {
    /// Instructions per operation.
    pub fn mean(&self) -> f64 {
        self.instructions as f64 / f64::from(self.operations)
    }

    /// Cycles per operation.
    pub fn mean_cycles(&self) -> Option<f64> {
        Some(self.cycles? as f64 / f64::from(self.operations))
    }
}

/// What a program takes, in bytes.
#[derive(Clone, Copy, Debug)]
pub struct Memory {
    /// `.text` and `.rodata`.
    pub flash: u64,
    /// `.data`, `.bss` and `.uninit`.
    pub statics: u64,
    /// Deepest use of the stack, if the program reports it.
    pub stack: Option<u64>,
}

/// Everything that was reported.
#[derive(Debug, Default)]
pub struct Counts {
    counts: HashMap<(Build, String, String), Count>,
    memory: HashMap<Build, Memory>,
    /// Instructions that were predicted for drawing, a mean.
    predictions: HashMap<(Build, String), f64>,
    /// Loops of known length: the program, its instructions, and as how many they were counted.
    calibrations: Vec<(Build, u64, u64)>,
}

impl Counts {
    /// What the stopwatches made of loops of known length.
    pub fn calibrations(&self) -> impl Iterator<Item = String> + '_ {
        self.calibrations.iter().map(|(build, expected, counted)| {
            format!(
                "calibration of {} for {} on {}: a loop of {expected} instructions was counted as {counted}",
                build.firmware,
                build.target,
                build.machine()
            )
        })
    }

    /// The timing of `name` through `variant`.
    pub fn count(&self, build: Build, name: &str, variant: &str) -> anyhow::Result<Count> {
        let key = (build, name.to_owned(), variant.to_owned());
        self.counts
            .get(&key)
            .copied()
            .with_context(|| format!("{} did not count {name} ({variant})", build.firmware))
    }

    /// What was predicted for drawing `name`.
    pub fn prediction(&self, build: Build, name: &str) -> anyhow::Result<f64> {
        let prediction = self.predictions.get(&(build, name.to_owned())).copied();
        prediction.with_context(|| format!("{} did not predict {name}", build.firmware))
    }

    /// Whether every target drew the same.
    pub fn same_everywhere(&self, name: &str, variant: &str) -> bool {
        let mut checksums = self
            .counts
            .iter()
            .filter(|((_, other_name, other_variant), _)| other_name == name && other_variant == variant)
            .map(|(_, count)| count.checksum);
        checksums
            .next()
            .is_none_or(|first| checksums.all(|other| other == first))
    }

    /// The memory of a program that ran.
    pub fn memory(&self, build: Build) -> anyhow::Result<Memory> {
        self.memory
            .get(&build)
            .copied()
            .with_context(|| format!("{} was not measured", build.firmware))
    }

    /// Takes in the report of a program that ran, and reads its files.
    ///
    /// # Errors
    ///
    /// As [`read_report`](Self::read_report); or static RAM is too small for the buffers it says it drew into.
    pub fn read(&mut self, build: &Build, run: &Run) -> anyhow::Result<()> {
        let mut memory = sizes(build)?;
        ensure!(
            memory.statics >= build.frame_buffers(),
            "void: {} has {} bytes of static RAM, too few for its frame buffers",
            build.firmware,
            memory.statics
        );
        memory.stack = self.read_report(build, run)?;
        self.memory.insert(*build, memory);
        Ok(())
    }

    /// Takes in the report of a program; returns its deepest use of the stack.
    ///
    /// # Errors
    ///
    /// Nothing it says counts: a calibration loop did not take the ticks it has to, or the stopwatch was not calibrated,
    /// or it wrapped; or the plugin that estimates cycles counted other instructions.
    fn read_report(&mut self, build: &Build, run: &Run) -> anyhow::Result<Option<u64>> {
        let mut stack = None;
        let mut stretches = run.cycles.as_deref().map(str::lines);
        let mut is_calibrated = false;
        for line in run.report.lines() {
            let (kind, pairs) = line.split_once(' ').unwrap_or((line, ""));
            let pairs: HashMap<_, _> = pairs.split(' ').filter_map(|pair| pair.split_once('=')).collect();
            let text = |key: &str| pairs.get(key).copied().with_context(|| format!("no {key} in: {line}"));
            let number = |key| {
                text(key)?
                    .parse::<u32>()
                    .with_context(|| format!("void: {key} is no number in: {line}"))
            };
            let instructions = |ticks| u64::from(ticks) * u64::from(build.instructions_per_tick());
            let mut cycles_of = |counted: u64| -> anyhow::Result<Option<u64>> {
                let Some(stretches) = &mut stretches else {
                    return Ok(None);
                };
                let stretch = stretches.next().with_context(|| format!("no cycles for: {line}"))?;
                let (by_plugin, cycles) = stretch.split_once(' ').context("the plugin wrote no two numbers")?;
                let by_plugin: u64 = by_plugin.parse()?;
                ensure!(
                    by_plugin.abs_diff(counted) <= instructions(2),
                    "void: {} on {}: {by_plugin} instructions were executed, {counted} counted, in: {line}",
                    build.firmware,
                    build.machine()
                );
                Ok(Some(cycles.parse()?))
            };
            match kind {
                "calibration" => {
                    let (expected, counted) = (u64::from(number("instructions")?), instructions(number("ticks")?));
                    ensure!(
                        counted.abs_diff(expected) <= instructions(2),
                        "void: {} on {}: a loop of {expected} instructions was counted as {counted}",
                        build.firmware,
                        build.machine()
                    );
                    cycles_of(counted)?;
                    self.calibrations.push((*build, expected, counted));
                    is_calibrated = true;
                }
                "count" => {
                    ensure!(is_calibrated, "void: {} was not calibrated", build.firmware);
                    let counted = instructions(number("ticks")?);
                    let count = Count {
                        operations: number("operations")?,
                        instructions: counted,
                        cycles: cycles_of(counted)?,
                        checksum: number("checksum")?,
                    };
                    self.counts
                        .insert((*build, text("name")?.to_owned(), text("variant")?.to_owned()), count);
                }
                "prediction" => {
                    ensure!(is_calibrated, "void: {} was not calibrated", build.firmware);
                    let key = (*build, text("name")?.to_owned());
                    self.predictions.insert(key, number("instructions")?.into());
                }
                "stack" => stack = Some(u64::from(number("bytes")?)),
                _ => bail!("{} wrote: {line}", build.firmware),
            }
        }
        Ok(stack)
    }
}

/// Flash from the program's section headers, static RAM from the linker's map.
fn sizes(build: &Build) -> anyhow::Result<Memory> {
    let program = build.program();
    let bytes = fs::read(&program).with_context(|| format!("cannot read {}", program.display()))?;
    let elf = object::File::parse(&*bytes)?;
    let section = |name| elf.section_by_name(name).map_or(0, |section| section.size());
    let path = build.map();
    let map = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let statics = [".data", ".bss", ".uninit"]
        .into_iter()
        .filter_map(|name| mapped_size(&map, name))
        .sum();
    let flash = section(".text") + section(".rodata");
    Ok(Memory {
        flash,
        statics,
        stack: None,
    })
}

/// The size of an output section: lines of the map are address, load address, size, alignment (in hex) and name.
fn mapped_size(map: &str, section: &str) -> Option<u64> {
    map.lines().find_map(|line| {
        let words: Vec<_> = line.split_whitespace().collect();
        match words[..] {
            [_, _, size, _, name] if name == section => u64::from_str_radix(size, 16).ok(),
            _ => None,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::firmware::Level;

    const BUILD: Build = Build {
        target: "thumbv7em-none-eabi",
        level: Level::Speed,
        content: None,
        firmware: "shapes",
    };
    const CALIBRATION: &str = "calibration instructions=2000000 ticks=50001\n";

    fn read(report: &str) -> anyhow::Result<Counts> {
        let mut counts = Counts::default();
        let report = report.to_owned();
        counts.read_report(&BUILD, &Run { report, cycles: None })?;
        Ok(counts)
    }

    #[test]
    fn ticks_become_instructions_an_operation() {
        let counts = read(&format!(
            "{CALIBRATION}count name=clear variant=peer operations=50 checksum=7 ticks=100\n"
        ));
        let count = counts.unwrap().count(BUILD, "clear", "peer").unwrap();
        assert_eq!((count.mean(), count.checksum), (80.0, 7));
    }

    #[test]
    fn a_prediction_belongs_to_its_name() -> anyhow::Result<()> {
        let counts = read(&format!(
            "{CALIBRATION}prediction name=estimate.sc1 instructions=170000\n"
        ))?;
        assert_eq!(counts.prediction(BUILD, "estimate.sc1")?, 170_000.0);
        assert!(counts.prediction(BUILD, "estimate.sc2").is_err());
        Ok(())
    }

    #[test]
    fn a_wrong_calibration_voids_everything() {
        assert!(read("calibration instructions=2000000 ticks=50003\n").is_err());
        assert!(read("calibration instructions=2000000 ticks=49997\n").is_err());
        assert!(read("count name=clear variant=peer operations=50 checksum=7 ticks=100\n").is_err());
    }

    #[test]
    fn a_stopwatch_that_wrapped_voids_everything() {
        let report = format!("{CALIBRATION}count name=clear variant=peer operations=50 checksum=7 ticks=wrapped\n");
        assert!(read(&report).is_err());
    }

    #[test]
    fn cycles_belong_to_the_counts_in_their_order() -> anyhow::Result<()> {
        let count = |name, ticks| format!("count name={name} variant=zrow operations=10 checksum=7 ticks={ticks}\n");
        let report = format!("{CALIBRATION}{}{}", count("disc", 100), count("clear", 200));
        let read = |cycles: &str| {
            let mut counts = Counts::default();
            let (report, cycles) = (report.clone(), Some(cycles.to_owned()));
            counts.read_report(&BUILD, &Run { report, cycles }).map(|_| counts)
        };
        let counts = read("2000000 4000000\n4000 5000\n8000 24000\n")?;
        assert_eq!(counts.count(BUILD, "disc", "zrow")?.mean_cycles(), Some(500.0));
        assert_eq!(counts.count(BUILD, "clear", "zrow")?.mean_cycles(), Some(2400.0));
        // A stretch is missing; the plugin saw other instructions.
        assert!(read("2000000 4000000\n4000 5000\n").is_err());
        assert!(read("2000000 4000000\n4000 5000\n9000 24000\n").is_err());
        Ok(())
    }

    #[test]
    fn an_unknown_line_is_an_error() {
        assert!(read(&format!("{CALIBRATION}panic\n")).is_err());
    }

    #[test]
    fn the_size_of_an_output_section_is_read_from_the_map() {
        let map = "     VMA      LMA     Size Align Out     In      Symbol\n\
                   20000000     3e98       1c     4 .data\n\
                   2000001c 2000001c     4b04     4 .bss\n\
                   2000001c 2000001c     4b00     4         shapes.o:(.bss.frame)\n";
        assert_eq!(mapped_size(map, ".data"), Some(0x1c));
        assert_eq!(mapped_size(map, ".bss"), Some(0x4b04));
        assert_eq!(mapped_size(map, ".uninit"), None);
    }
}
