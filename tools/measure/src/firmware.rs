//! Builds the bench firmware and runs it in QEMU.

use std::{
    env::consts::{DLL_PREFIX, DLL_SUFFIX},
    fs,
    io::{ErrorKind, Read},
    path::{Path, PathBuf},
    process::{Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use anyhow::{Context, anyhow, bail, ensure};

/// The compiler's optimization level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// `opt-level = 3`.
    Speed,
    /// `opt-level = "s"`.
    Size,
}

/// One program of `tools/measure/firmware`, built for one target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Build {
    pub target: &'static str,
    pub level: Level,
    /// The one thing that a program for footprints links, by its name; or else what its program has.
    pub content: Option<&'static str>,
    pub firmware: &'static str,
}

impl Build {
    /// The machine of QEMU that runs it.
    pub fn machine(&self) -> &'static str {
        match self.target {
            "thumbv7m-none-eabi" => "lm3s6965evb",
            _ => "mps2-an386",
        }
    }

    /// The program, built in the same way, that is subtracted from this one.
    pub fn baseline(&self, firmware: &'static str) -> Self {
        Self {
            content: None,
            firmware,
            ..*self
        }
    }

    /// Whether one call of the compiler makes both.
    pub fn shares_compilation(&self, other: &Self) -> bool {
        (self.target, self.level, self.content, self.feature())
            == (other.target, other.level, other.content, other.feature())
    }

    /// The feature with which the program links what others wrote, and no other program does.
    fn feature(&self) -> Option<&'static str> {
        match self.firmware {
            "coverage_peers" => Some("coverage_peers"),
            "text_fonts" | "footprint_text" => Some("text_peers"),
            _ => None,
        }
    }

    /// The program, and what is in it.
    pub fn name(&self) -> String {
        let content = self.content.map(|content| format!(" with {content}"));
        format!("{}{}", self.firmware, content.unwrap_or_default())
    }

    /// The processor whose cycles are estimated, as the plugin calls it.
    fn core(&self) -> &'static str {
        match self.target {
            "thumbv7m-none-eabi" => "m3",
            "thumbv6m-none-eabi" => "m0plus",
            _ => "m4",
        }
    }

    /// Instructions per tick of SysTick: 12.5 MHz and 25 MHz, at one instruction per nanosecond.
    pub fn instructions_per_tick(&self) -> u32 {
        match self.machine() {
            "lm3s6965evb" => 80,
            _ => 40,
        }
    }

    /// Bytes of the frame buffers that the program draws into: 240 x 320 RGB565 for the peer and for zrow.
    pub fn frame_buffers(&self) -> u64 {
        match self.firmware {
            "shapes" => 2 * 240 * 320 * 2,
            _ => 0,
        }
    }

    fn target_directory(&self) -> &'static str {
        match self.level {
            Level::Speed => "target",
            Level::Size => "target/size",
        }
    }

    fn output(&self) -> PathBuf {
        sources()
            .join(self.target_directory())
            .join(self.target)
            .join("release")
    }

    /// The linked program.
    pub fn program(&self) -> PathBuf {
        self.output().join(self.firmware)
    }

    /// What QEMU's plugin writes while the program runs.
    fn cycles(&self) -> PathBuf {
        self.output().join(format!("{}.cycles", self.firmware))
    }

    /// The linker's map of it.
    pub fn map(&self) -> PathBuf {
        self.output().join(format!("{}.map", self.firmware))
    }
}

/// The folder of the firmware's sources.
fn sources() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("firmware")
}

/// The script that builds firmware.
fn build_script() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../boards/build-firmware")
}

/// Builds programs that share target, level and content.
pub fn build(group: &[Build]) -> anyhow::Result<()> {
    let Some(first) = group.first() else { return Ok(()) };
    let mut command = Command::new(build_script());
    command
        .arg(sources())
        .arg(first.target)
        .args(["--locked", "--target-dir", first.target_directory()]);
    for build in group {
        command.args(["--bin", build.firmware]);
    }
    if let Some(feature) = first.feature() {
        command.args(["--features", feature]);
    }
    match first.content {
        Some(content) => command.env("ZROW_FOOTPRINT", content),
        None => command.env_remove("ZROW_FOOTPRINT"),
    };
    // Set by `cargo run` for this program; the script may call another compiler, which has libraries of its own.
    command.env_remove("LD_LIBRARY_PATH");
    if first.level == Level::Size {
        command.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "s");
    }
    let output = command
        .output()
        .context("cannot start boards/build-firmware, a bash script")?;
    ensure!(
        output.status.success(),
        "building the firmware:\n{}",
        String::from_utf8_lossy(&output.stderr).trim_end()
    );
    Ok(())
}

/// What a program did.
#[derive(Debug)]
pub struct Run {
    /// What it wrote.
    pub report: String,
    /// For each stretch that it timed a line with instructions and cycles; none where no cycles are estimated.
    pub cycles: Option<String>,
}

/// Builds the plugin of QEMU that estimates cycles, and returns its path.
pub fn plugin() -> anyhow::Result<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |folder| root.join(folder));
    let output = Command::new(cargo)
        .args(["build", "--release", "--package", "zrow-cycles-plugin", "--target-dir"])
        .arg(&target)
        .current_dir(&root)
        .output()
        .context("cannot start cargo")?;
    ensure!(
        output.status.success(),
        "building the plugin for QEMU:\n{}",
        String::from_utf8_lossy(&output.stderr).trim_end()
    );
    let library = format!("{DLL_PREFIX}zrow_cycles_plugin{DLL_SUFFIX}");
    Ok(target.join("release").join(library))
}

/// Runs a program; `counts` names what it shall count.
pub fn run(build: &Build, counts: &[&str], plugin: Option<&Path>) -> anyhow::Result<Run> {
    let mut semihosting = format!("enable=on,target=native,arg={}", build.firmware);
    for count in counts {
        semihosting.push_str(",arg=");
        semihosting.push_str(count);
    }
    let mut emulator = Command::new("qemu-system-arm");
    if let Some(plugin) = plugin {
        let (plugin, core, output) = (plugin.display(), build.core(), build.cycles());
        emulator.arg("-plugin");
        emulator.arg(format!("file={plugin},core={core},output={}", output.display()));
    }
    let mut emulator = emulator
        .args([
            "-M",
            build.machine(),
            "-display",
            "none",
            "-monitor",
            "none",
            "-serial",
            "none",
        ])
        .args(["-icount", "shift=0", "-semihosting-config", &semihosting, "-kernel"])
        .arg(build.program())
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| match error.kind() {
            ErrorKind::NotFound => anyhow!("qemu-system-arm is missing (Debian: apt-get install qemu-system-arm)"),
            _ => anyhow!(error).context("cannot start qemu-system-arm"),
        })?;
    let reports = emulator.stdout.take().map(read_all);
    let complaints = emulator.stderr.take().map(read_all);
    let deadline = Instant::now() + Duration::from_secs(120);
    let status = loop {
        if let Some(status) = emulator.try_wait()? {
            break status;
        }
        if Instant::now() > deadline {
            emulator.kill()?;
            emulator.wait()?;
            bail!(
                "{} did not end within two minutes on {}",
                build.firmware,
                build.machine()
            );
        }
        thread::sleep(Duration::from_millis(10));
    };
    let hint = if plugin.is_some() && !status.success() {
        "\nIf this QEMU takes no plugin of version 1 (4.2 to 8.1 do), --no-cycles counts instructions alone."
    } else {
        ""
    };
    let text = |reader: Option<thread::JoinHandle<String>>| reader.and_then(|reader| reader.join().ok());
    let reports = text(reports).unwrap_or_default();
    ensure!(
        status.success(),
        "{} failed on {}:\n{reports}{}{hint}",
        build.firmware,
        build.machine(),
        text(complaints).unwrap_or_default()
    );
    let cycles = plugin.map(|_| {
        let path = build.cycles();
        fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))
    });
    Ok(Run {
        report: reports,
        cycles: cycles.transpose()?,
    })
}

/// Reads on while the emulator runs, because a full pipe would stop it.
fn read_all(mut stream: impl Read + Send + 'static) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        // What came before a broken pipe is worth showing.
        let _ = stream.read_to_end(&mut bytes);
        String::from_utf8_lossy(&bytes).into_owned()
    })
}
