//! Builds the firmware of every board, and prints how much flash and static RAM each takes.

mod board;
mod sizes;

use std::fs;

use anyhow::{Context, ensure};
use board::{BOARDS, Board};
use clap::Parser;
use comfy_table::{CellAlignment, Table, presets};
use sizes::Sizes;

/// The page with the table.
const PAGE: &str = "boards/README.md";
/// What the table is between in it.
const BEGIN: &str = "<!-- boards -->\n\n";
const END: &str = "\n\n<!-- end -->";
/// Bytes of RAM that have to be left for the stack.
const STACK: u64 = 24 << 10;

/// Builds the firmware of every board, and prints how much flash and static RAM it takes; fails where that is too much.
#[derive(clap::Parser)]
#[command(name = "boards", version)]
struct Options {
    /// Only boards with this text in their name.
    #[arg(long, default_value = "", hide_default_value = true)]
    only: String,
    /// Writes the table into boards/README.md, too.
    #[arg(long, conflicts_with = "only")]
    docs: bool,
}

fn main() -> anyhow::Result<()> {
    let options = Options::parse();
    let boards: Vec<&Board> = BOARDS
        .iter()
        .filter(|board| board.name.contains(&options.only))
        .collect();
    ensure!(!boards.is_empty(), "no board has {} in its name", options.only);
    let measure = |board: &&'static Board| Ok((*board, Sizes::of_program(&board.build()?, &board.ram)?));
    let measured = boards.iter().map(measure).collect::<anyhow::Result<Vec<_>>>()?;
    let table = table(&measured).to_string();
    println!("{table}");
    if options.docs {
        let path = board::root().join(PAGE);
        let page = fs::read_to_string(&path).with_context(|| format!("cannot read {PAGE}"))?;
        fs::write(&path, with_table(&page, &table)?).with_context(|| format!("cannot write {PAGE}"))?;
    }
    measured.iter().try_for_each(|(board, sizes)| check(board, *sizes))
}

/// Bytes of each board.
fn table(measured: &[(&Board, Sizes)]) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN);
    table.set_header(["board", "chip", "core", "flash", "of", "static RAM", "of"]);
    for (board, sizes) in measured {
        let [flash, ram] = [board.flash, board.ram.end - board.ram.start];
        let numbers = [sizes.flash, flash, sizes.statics, ram].map(with_commas);
        let names = [board.name, board.chip, board.core].map(str::to_owned);
        table.add_row(names.into_iter().chain(numbers));
    }
    for column in table.column_iter_mut().skip(3) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

/// Whether a program fits, with room for a stack.
fn check(board: &Board, sizes: Sizes) -> anyhow::Result<()> {
    let ram = board.ram.end - board.ram.start;
    ensure!(
        sizes.flash <= board.flash,
        "{}: {} bytes do not fit into the flash",
        board.name,
        with_commas(sizes.flash)
    );
    ensure!(
        sizes.statics + STACK <= ram,
        "{}: {} bytes of variables leave fewer than {} for the stack",
        board.name,
        with_commas(sizes.statics),
        with_commas(STACK)
    );
    Ok(())
}

/// The page with another table.
fn with_table(page: &str, table: &str) -> anyhow::Result<String> {
    let (before, rest) = page.split_once(BEGIN).context("the page has no table of boards")?;
    let (_, after) = rest.split_once(END).context("the table of boards has no end")?;
    Ok([before, BEGIN, table, END, after].concat())
}

/// A number with commas between thousands.
fn with_commas(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.char_indices() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_have_commas() {
        let numbers = [0, 12, 999, 1_000, 12_345, 123_456, 1_234_567];
        let texts = ["0", "12", "999", "1,000", "12,345", "123,456", "1,234,567"];
        assert_eq!(numbers.map(with_commas), texts);
    }

    #[test]
    fn what_does_not_fit_is_an_error() {
        let [board, ..] = &BOARDS;
        let fits = |flash, statics| check(board, Sizes { flash, statics }).is_ok();
        assert!(fits(256 << 10, 40 << 10));
        assert!(!fits((256 << 10) + 1, 0));
        assert!(!fits(0, (40 << 10) + 1));
    }

    #[test]
    fn a_table_takes_the_place_of_another_one() {
        let page = "before\n<!-- boards -->\n\n| old |\n\n<!-- end -->\nafter";
        let expected = "before\n<!-- boards -->\n\n| new |\n\n<!-- end -->\nafter";
        assert_eq!(with_table(page, "| new |").unwrap(), expected);
        assert!(with_table("no table", "").is_err());
    }

    /// Each folder of `boards/` with a memory map or without one, whose firmware is no member of the workspace, is built.
    #[test]
    fn every_board_is_built_and_in_the_table() {
        let manifest = fs::read_to_string(board::root().join("Cargo.toml")).unwrap();
        let excluded = manifest.lines().find(|line| line.starts_with("exclude")).unwrap();
        let mut folders: Vec<&str> = excluded
            .split('"')
            .filter_map(|path| path.strip_prefix("boards/"))
            .collect();
        folders.sort();
        let mut names = BOARDS.map(|board| board.name);
        names.sort();
        assert_eq!(folders, names);
        let page = fs::read_to_string(board::root().join(PAGE)).unwrap();
        let (_, table) = page.split_once(BEGIN).unwrap();
        let (table, _) = table.split_once(END).unwrap();
        for name in names {
            assert!(table.contains(&format!("| {name} ")), "{name} is not in {PAGE}");
        }
    }
}
