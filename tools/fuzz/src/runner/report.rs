//! What the loop prints at its end.

use std::time::Duration;

use comfy_table::{CellAlignment, Table, presets};

use crate::{
    runner::{Failure, Outcome, hex},
    series,
    target::Target,
};

/// A line for each target: how many inputs, how fast, and whether all is well.
pub fn print_table(targets: &[Target], outcomes: &[(Outcome, Duration)]) {
    let mut table = Table::new();
    table
        .load_preset(presets::NOTHING)
        .set_header(["target", "inputs", "a second", "slowest", "iteration", ""]);
    for (target, (outcome, time)) in targets.iter().zip(outcomes) {
        let per_second = outcome.next as f64 / time.as_secs_f64().max(1e-3);
        let failures = outcome.failures.len();
        table.add_row([
            target.name.to_owned(),
            outcome.next.to_string(),
            format!("{per_second:.0}"),
            format!("{:.1} ms", outcome.slowest.time as f64 / 1e3),
            outcome.slowest.iteration.to_string(),
            if failures == 0 {
                String::new()
            } else {
                format!("{failures} failed")
            },
        ]);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    println!("{table}");
    let inputs: u64 = outcomes.iter().map(|(outcome, _)| outcome.next).sum();
    println!("{inputs} inputs of {} targets", targets.len());
}

/// What went wrong, with which input, and how to do it again.
pub fn print_failure(target: &Target, failure: &Failure, seed: u64) {
    let Failure {
        iteration,
        wrong,
        smallest,
    } = failure;
    println!("\n{} {wrong}", target.name);
    println!(
        "  the input: cargo run --release -- fuzz --target {} --seed {seed} --iteration {iteration}",
        target.name
    );
    let bytes = match smallest.as_deref().map(hex::decode) {
        Some(Ok(bytes)) => {
            println!(
                "  a small one: cargo run --release -- fuzz --target {} --replay {}",
                target.name,
                hex::encode(&bytes)
            );
            bytes
        }
        _ => series::bytes(seed, target.name, *iteration),
    };
    println!("  {}", target.show(&bytes));
}
