//! What was run, and on what.

use std::fs;

/// Lines for the report: command, profile, machine.
pub fn facts() -> Vec<(&'static str, String)> {
    vec![
        ("command", command()),
        ("version", format!("zrow {}", env!("CARGO_PKG_VERSION"))),
        ("profile of the host's program", profile()),
        (
            "profile of the firmware",
            "opt-level 3, link-time optimization, one codegen unit, no overflow checks; thumbv7em-none-eabi (Cortex-M4) in \
             QEMU with -icount shift=0; instructions are not cycles"
                .to_owned(),
        ),
        ("machine", machine()),
        ("load of the machine", load()),
    ]
}

fn command() -> String {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let cargo = if cfg!(debug_assertions) {
        "cargo run"
    } else {
        "cargo run --release"
    };
    format!("{cargo} -- {}", arguments.join(" "))
}

/// What Cargo.toml says, which is what was compiled.
fn profile() -> String {
    if cfg!(debug_assertions) {
        return "dev: times say little".to_owned();
    }
    let manifest = include_str!("../../../Cargo.toml");
    let (_, section) = manifest.split_once("[profile.release]").unwrap_or_default();
    let settings: Vec<&str> = section.lines().skip(1).take_while(|line| !line.is_empty()).collect();
    format!("release, opt-level 3, {}", settings.join(", "))
}

/// Processes that wanted a core in the last minute: more than cores make times uncertain.
fn load() -> String {
    let text = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let load = text.split(' ').next().filter(|load| !load.is_empty());
    load.map_or_else(
        || "unknown".to_owned(),
        |load| format!("{load} in the last minute, of which this run is 1"),
    )
}

fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let model = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        line.split_once(": ").map(|(_, model)| model.to_owned())
    });
    let model = model.unwrap_or_else(|| "unnamed processor".to_owned());
    format!(
        "{}, {}, {model}, {cores} cores",
        std::env::consts::OS,
        std::env::consts::ARCH
    )
}
