//! The first screen of the page: what each step of accuracy costs, in a sentence, a chart, and the same star four times.

use std::fmt::Write;

use zrow_methods::Class;

use super::{
    axis::{Chapter, Entry},
    coverage::ALL,
    digits::digits,
    figures::{Cost, charts},
    names,
    picture::{Picture, around},
};

/// The steps, by the names of their methods.
const STEPS: [&str; 4] = ["scanline_fill", "rooks_16", "signed_area", "inside_area"];

/// The first screen; nothing where antialiasing was not asked for.
///
/// # Errors
/// A chart or a picture cannot be drawn.
pub fn html(chapters: &[Chapter]) -> anyhow::Result<String> {
    let mut html = String::new();
    let Some(chapter) = chapters.iter().find(|chapter| chapter.name == "coverage") else {
        return Ok(html);
    };
    let of_all = chapter.of_group(ALL);
    if let Some(sentence) = sentence(&of_all) {
        writeln!(html, "<p class=\"answer\">{sentence}</p>")?;
    }
    let charts = charts(chapter, ALL);
    if let Some((_, chart)) = charts.iter().find(|(cost, _)| *cost == cost_of(&of_all)) {
        writeln!(html, "<div class=\"diagram\">{}</div>", chart.svg()?)?;
    }
    html += "<div class=\"steps\">";
    let of_star = chapter.of_group(Class::Star.name());
    let stars = STEPS.map(|step| of_star.iter().find(|entry| entry.method == step));
    let pictures = stars.iter().flatten().filter_map(|star| star.picture.as_ref());
    // The same pixels of all of them.
    let shown = pictures.filter_map(Picture::covered).reduce(around).unwrap_or_default();
    for star in stars.into_iter().flatten() {
        let [rms, largest, ..] = star.figures[..] else { continue };
        let picture = match &star.picture {
            Some(picture) => picture.magnified(shown, STAR_SIZE)?,
            None => String::new(),
        };
        write!(
            html,
            "<figure>{picture}<figcaption><b>{}</b><br>rms error {}, largest {} of 255</figcaption></figure>",
            names::title(&star.method),
            digits(rms),
            digits(largest)
        )?;
    }
    html += "</div>\n";
    Ok(html)
}

/// Pixels of the page for the width of a star.
const STAR_SIZE: u32 = 288;

/// The best cost that is known of all entries: what does not vary with the load of the machine comes first.
fn cost_of(entries: &[&Entry]) -> Cost {
    let is_known = |cost: &Cost| entries.iter().all(|entry| cost.of(entry).is_some());
    let costs = [Cost::Cycles, Cost::Instructions];
    costs.into_iter().find(is_known).unwrap_or(Cost::Time)
}

fn sentence(entries: &[&Entry]) -> Option<String> {
    let cost = cost_of(entries);
    let find = |method: &str| entries.iter().find(|entry| entry.method == method);
    let (none, samples, exact) = (find(STEPS[0])?, find(STEPS[1])?, find(STEPS[2])?);
    let times = |entry: &Entry| Some(format!("{:.1}", cost.of(entry)? / cost.of(none)?));
    let unit = match cost {
        Cost::Cycles => "estimated cycles of a Cortex-M4",
        Cost::Instructions => "instructions of a Cortex-M4",
        Cost::Time | Cost::Flash => "nanoseconds of this machine",
    };
    Some(format!(
        "A shape takes {} {unit} without antialiasing, with an error of {} of 255 in its edge pixels (rms, against the exact \
         area); {} times as many with 16 samples, whose error is {}; and {} times as many with the exact area, whose error is {}.",
        digits(cost.of(none)?),
        digits(none.error()),
        times(samples)?,
        digits(samples.error()),
        times(exact)?,
        digits(exact.error()),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::counted::Chip;

    fn entry(method: &str, error: f64, cycles: Option<f64>) -> Entry {
        Entry {
            group: ALL.to_owned(),
            method: method.to_owned(),
            figures: vec![error],
            memory_bytes: 0,
            time: None,
            chip: Chip {
                instructions: Some(100.0),
                cycles,
                flash_bytes: None,
            },
            picture: None,
        }
    }

    #[test]
    fn the_sentence_has_what_was_counted() {
        let entries = [
            entry("scanline_fill", 69.0, Some(2_000.0)),
            entry("rooks_16", 8.6, Some(9_000.0)),
            entry("signed_area", 0.5, Some(5_000.0)),
        ];
        let entries: Vec<&Entry> = entries.iter().collect();
        let said = sentence(&entries).unwrap_or_default();
        for part in [
            "2,000 estimated cycles",
            "error of 69 ",
            "4.5 times",
            "is 8.60;",
            "2.5 times",
            "is 0.500.",
        ] {
            assert!(said.contains(part), "{part}: {said}");
        }
        let without = [
            entry("scanline_fill", 69.0, None),
            entry("rooks_16", 8.6, Some(9_000.0)),
            entry("signed_area", 0.5, Some(5_000.0)),
        ];
        let without: Vec<&Entry> = without.iter().collect();
        assert!(sentence(&without).unwrap_or_default().contains("100 instructions"));
    }
}
