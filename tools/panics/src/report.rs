//! The ways to panics as a person reads them.

use std::{collections::BTreeMap, fmt::Write, path::Path};

use super::{
    names::{is_exercise, shortened},
    program::{Finding, Frame},
};

/// Each panic with its callers, from the inside out; one way for each place in zrow's source.
pub fn report(findings: &[Finding], root: &Path) -> String {
    let mut places = BTreeMap::<_, Vec<&Finding>>::new();
    for finding in findings {
        let location = finding.culprit().and_then(|frame| frame.location.clone());
        places
            .entry((location, finding.panic.first()))
            .or_default()
            .push(finding);
    }
    let mut text = String::new();
    for ways in places.values() {
        // The shortest way is the easiest one to read.
        let Some(way) = ways.iter().min_by_key(|way| way.callers.len()) else {
            continue;
        };
        // Nothing fails that writes to a string.
        let _ = writeln!(text, "{}", way.panic.join("\n    <- "));
        for frame in &way.callers {
            let _ = writeln!(text, "    <- {}", line(frame, root));
        }
        if way.callers.last().is_some_and(|frame| !is_exercise(&frame.function)) {
            // A trait object: whose function it calls is not in the program.
            text += "    <- a pointer to the function\n";
        }
        if ways.len() > 1 {
            let _ = writeln!(text, "    more calls from there: {}", ways.len() - 1);
        }
    }
    text
}

fn line(frame: &Frame, root: &Path) -> String {
    let function = shortened(&frame.function);
    match &frame.location {
        Some((file, line)) => format!("{function}, {}:{line}", source(file, root)),
        None => function,
    }
}

/// The path of a file of this repository, of the core library or of another crate, without where that is kept.
fn source<'f>(file: &'f str, root: &Path) -> &'f str {
    let in_repository = Path::new(file).strip_prefix(root).ok().and_then(Path::to_str);
    let elsewhere = ["/library/", "/registry/src/"]
        .iter()
        .find_map(|part| Some(file.split_once(part)?.1));
    in_repository.or(elsewhere).unwrap_or(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(function: &str, file: &str, line: u32) -> Frame {
        Frame {
            function: function.to_owned(),
            location: Some((file.to_owned(), line)),
        }
    }

    #[test]
    fn one_way_is_shown_for_each_place() {
        let way = |target: &str| Finding {
            panic: vec!["core::panicking::panic_bounds_check".to_owned()],
            callers: vec![
                frame(
                    "<[u8] as core::ops::Index>::index",
                    "/usr/src/library/core/src/slice/index.rs",
                    7,
                ),
                frame("zrow::band::fill", "/home/zrow/src/band/mod.rs", 12),
                Frame {
                    function: format!("exercises::band::target::<zrow::band::{target}>"),
                    location: None,
                },
            ],
        };
        let other = Finding {
            panic: vec![
                "core::panicking::panic".to_owned(),
                "heapless::Vec::swap_remove".to_owned(),
            ],
            callers: vec![frame(
                "exercises::scan::fill",
                "/home/.cargo/registry/src/index/other-1.0/src/lib.rs",
                3,
            )],
        };
        let through_pointer = Finding {
            panic: vec!["core::panicking::panic_fmt".to_owned()],
            callers: vec![frame("zrow::scan::step", "/home/zrow/src/scan/step.rs", 5)],
        };
        assert_eq!(
            report(
                &[way("Band"), way("Other"), other, through_pointer],
                Path::new("/home/zrow")
            ),
            "core::panicking::panic
    <- heapless::Vec::swap_remove
    <- exercises::scan::fill, index/other-1.0/src/lib.rs:3
core::panicking::panic_bounds_check
    <- <[u8] as Index>::index, core/src/slice/index.rs:7
    <- zrow::band::fill, src/band/mod.rs:12
    <- exercises::band::target::<Band>
    more calls from there: 1
core::panicking::panic_fmt
    <- zrow::scan::step, src/scan/step.rs:5
    <- a pointer to the function
"
        );
    }
}
