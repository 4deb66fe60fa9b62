//! The loop finds what goes wrong: defects that are there on purpose, each of another kind.

use std::process::{Command, Output};

fn fuzz(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_zrow-fuzz"))
        .args(arguments)
        .output()
        .unwrap()
}

/// Finds the defect of a target. Returns the report.
fn found(target: &str) -> String {
    let output = fuzz(&[
        "--target",
        target,
        "--seed",
        "1",
        "--seconds",
        "20",
        "--limit-ms",
        "200",
    ]);
    let report = String::from_utf8(output.stdout).unwrap();
    assert!(!output.status.success(), "{target} went well: {report}");
    report
}

/// What comes after `words` in the line of a report that has them.
fn after<'r>(report: &'r str, words: &str) -> &'r str {
    let line = report.lines().find(|line| line.contains(words)).unwrap();
    line.split(words).nth(1).unwrap()
}

#[test]
fn a_panic_is_found_and_comes_again() {
    let report = found("planted.panic");
    assert!(
        report.contains("panics at tools/fuzz/src/families/planted.rs"),
        "{report}"
    );
    let bytes = after(&report, "--replay ").trim();
    let again = fuzz(&["--target", "planted.panic", "--replay", bytes]);
    assert!(!again.status.success() && String::from_utf8_lossy(&again.stderr).contains("planted for"));
    let iteration = after(&report, "--iteration ").trim();
    let again = fuzz(&["--target", "planted.panic", "--seed", "1", "--iteration", iteration]);
    assert!(!again.status.success());
}

#[test]
fn a_pixel_outside_of_the_display_is_found() {
    let report = found("planted.outside");
    assert!(report.contains("outside"), "{report}");
}

#[test]
fn unbounded_work_is_found() {
    let report = found("planted.slow");
    assert!(report.contains("takes more than 200 ms"), "{report}");
}

#[test]
fn a_stack_overflow_ends_a_process_of_its_own() {
    let report = found("planted.deep");
    assert!(report.contains("ends the process"), "{report}");
}

#[test]
fn the_inputs_of_a_seed_are_always_the_same() {
    let show = || fuzz(&["--target", "clip.segment", "--seed", "7", "--iteration", "123"]).stdout;
    let lines = |output: Vec<u8>| {
        String::from_utf8(output)
            .unwrap()
            .lines()
            .take(2)
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(lines(show()), lines(show()));
    let other = fuzz(&["--target", "clip.segment", "--seed", "8", "--iteration", "123"]).stdout;
    assert_ne!(lines(show()), lines(other));
}
