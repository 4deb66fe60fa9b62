//! The figures as tables and as JSON.

use comfy_table::{CellAlignment, Table, presets};
use serde::Serialize;

use crate::{case::Figure, counts::Counts};

/// What has to be known about the figures.
const NOTES: &str = "
Instructions are counted: QEMU executes the real instructions of the target. Cycles are estimated from the same run: every
executed instruction and every taken branch has its price in the Technical Reference Manual of the Cortex-M3, M4 or M0+,
memory without wait states (tools/cycles/src/lib.rs has the table and says what it leaves out).
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
    /// Instructions or bytes.
    zrow: f64,
    /// Estimated cycles of what counts instructions.
    cycles: Option<f64>,
    peer: Option<f64>,
    peer_cycles: Option<f64>,
    #[serde(rename = "bar")]
    budget: Option<f64>,
    #[serde(rename = "cycles_bar")]
    cycles_budget: Option<f64>,
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
            cycles: figure.cycles,
            peer: figure.peer,
            peer_cycles: figure.peer_cycles,
            budget: figure.case.budget,
            cycles_budget: figure.case.cycles_budget,
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
    table.set_header([
        "what",
        "name",
        "peer",
        "zrow",
        "peer / zrow",
        "budget",
        "peer cycles",
        "cycles",
        "peer / zrow",
        "budget",
        "",
        "checksum",
    ]);
    for index in 2..10 {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    for figure in figures {
        let Figure {
            case,
            zrow,
            cycles,
            peer,
            peer_cycles,
            ..
        } = figure;
        let ratio = |peer: Option<f64>, zrow: Option<f64>| {
            let both = peer.zip(zrow);
            both.map(|(peer, zrow)| format!("{:.1}", peer / zrow))
                .unwrap_or_default()
        };
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
            ratio(*peer, Some(*zrow)),
            case.budget.map(grouped).unwrap_or_default(),
            peer_cycles.map(grouped).unwrap_or_default(),
            cycles.map(grouped).unwrap_or_default(),
            ratio(*peer_cycles, *cycles),
            case.cycles_budget.map(grouped).unwrap_or_default(),
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
        let case = cases::all().into_iter().find(|case| case.name == "clear");
        let mut figure = Figure {
            case: case.unwrap(),
            zrow: 20_000.0,
            cycles: Some(40_000.0),
            peer: None,
            peer_cycles: None,
            checksums: vec![1],
            equal: true,
        };
        assert_eq!((figure.pass(), figure.void_reason()), (Some(true), None));
        figure.cycles = Some(50_000.0);
        assert_eq!(figure.pass(), Some(false));
        figure.cycles = Some(40_000.0);
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
