//! The figures as tables and as JSON.

use comfy_table::{CellAlignment, Table, presets};
use serde::Serialize;

use crate::{case::Figure, counts::Counts};

/// What has to be known about the figures.
const NOTES: &str = "
Instructions are not cycles: QEMU executes the real instructions of the target and counts each as one. By the prices of the
Technical Reference Manual, without wait states, a Cortex-M4 takes 1.3 to 1.6 cycles for an instruction of most code, and more
where stores prevail: 1.8 for a disc, 2.0 for a rectangle, 2.8 for clearing the picture, whose loop stores two words at once.
Compiled with link-time optimization, one codegen unit and no overflow checks; opt-level 3 where nothing else is said.
Peers: embedded-graphics 0.8.2 on its Framebuffer, in the same firmware; for scenes small3dlib in C at -O3, with a full
32-bit depth buffer, measured separately on the same emulated machines; for coverage zeno 0.3.3, ab_glyph_rasterizer
0.1.10 and tiny-skia 0.11.4 in a firmware of their own with hardware floats (thumbv7em-none-eabihf), where zrow has none.
A checksum is that of all pixels drawn. It has to be the peer's where both draw the same pixels, and the same on every
target; otherwise the count is void. The second one is that of a peer that rounds coverages otherwise.";

/// A figure as other programs read it.
#[derive(Debug, Serialize)]
pub struct Record<'a> {
    name: &'a str,
    target: &'a str,
    zrow: f64,
    peer: Option<f64>,
    budget: Option<f64>,
    pass: Option<bool>,
}

/// The figures as other programs read them.
pub fn json(figures: &[Figure]) -> Vec<Record<'_>> {
    figures
        .iter()
        .map(|figure| Record {
            name: &figure.case.name,
            target: figure.case.target,
            zrow: figure.zrow,
            peer: figure.peer,
            budget: figure.case.budget,
            pass: figure.pass(),
        })
        .collect()
}

/// Prints a table for every target, and what has to be known about them.
pub fn print(figures: &[Figure], counts: &Counts) {
    for group in figures.chunk_by(|a, b| (a.case.target, a.case.unit()) == (b.case.target, b.case.unit())) {
        println!("{}: {}", group[0].case.target, group[0].case.unit());
        println!("{}\n", table(group));
    }
    for calibration in counts.calibrations() {
        println!("{calibration}");
    }
    println!("{NOTES}");
}

fn table(figures: &[Figure]) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_FULL_CONDENSED);
    table.set_header(["what", "name", "peer", "zrow", "peer / zrow", "budget", "", "checksum"]);
    for index in 2..6 {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    for figure in figures {
        let Figure { case, zrow, peer, .. } = figure;
        let verdict = match (figure.void_reason(), figure.pass()) {
            (Some(_), _) => "void",
            (None, Some(true)) => "pass",
            (None, Some(false)) => "fail",
            (None, None) => "",
        };
        table.add_row([
            case.title.clone(),
            case.name.clone(),
            peer.map(grouped).unwrap_or_default(),
            grouped(*zrow),
            peer.map(|peer| format!("{:.1}", peer / zrow)).unwrap_or_default(),
            case.budget.map(grouped).unwrap_or_default(),
            verdict.to_owned(),
            Vec::from_iter(figure.checksums.iter().map(|sum| format!("{sum:08x}"))).join(" / "),
        ]);
    }
    table
}

/// A number, rounded, with its digits in groups of three.
pub fn grouped(number: f64) -> String {
    let digits = format!("{number:.0}");
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Figure, grouped};
    use crate::cases;

    #[test]
    fn other_pixels_make_a_count_void() {
        let case = cases::all().into_iter().find(|case| case.budget == Some(24_000.0));
        let mut figure = Figure {
            case: case.unwrap(),
            zrow: 20_000.0,
            peer: None,
            checksums: vec![1],
            equal: true,
        };
        assert_eq!((figure.pass(), figure.void_reason()), (Some(true), None));
        figure.equal = false;
        assert_eq!(figure.pass(), Some(false));
        assert!(figure.void_reason().is_some());
    }

    #[test]
    fn digits_are_grouped_from_the_right() {
        assert_eq!(grouped(7.4), "7");
        assert_eq!(grouped(1234.5), "1,234");
        assert_eq!(grouped(999_999.6), "1,000,000");
    }
}
