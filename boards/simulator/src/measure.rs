/// Options of this command.
#[derive(clap::Args)]
pub struct Options {}

/// Runs the command.
pub fn run(_options: &Options) -> anyhow::Result<()> {
    Ok(())
}
