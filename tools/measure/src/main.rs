//! The command `measure`.

use clap::{CommandFactory, Parser, error::ErrorKind};
use zrow_measure::{NothingSelected, Options};

fn main() -> anyhow::Result<()> {
    let measured = zrow_measure::run(&Options::parse());
    measured.map_err(|error| match error.downcast::<NothingSelected>() {
        // As any other wrong option: no backtrace helps.
        Ok(nothing) => Options::command().error(ErrorKind::InvalidValue, nothing).exit(),
        Err(error) => error,
    })
}
