//! rp2040js with the firmware in it: a script that Node.js runs prints what goes over the wires, a line each.

use crate::child::{KillOnDrop, lines};
use anyhow::{Context, Result, anyhow, bail, ensure};
use std::{
    io::ErrorKind,
    path::Path,
    process::{Command, Stdio},
    sync::mpsc::{Receiver, RecvTimeoutError},
    time::Duration,
};

/// The first line comes when the panel is on and black; a frame is emulated within seconds.
const TIMEOUT: Duration = Duration::from_secs(120);

/// What went over the wires.
#[derive(Debug, PartialEq, Eq)]
pub enum Wire {
    /// To the panel, with the data/command pin low.
    Commands(Vec<u8>),
    /// To the panel, with that pin high.
    Data(Vec<u8>),
    /// A line of the serial port.
    Says(String),
}

impl Wire {
    fn from_line(line: &str) -> Option<Self> {
        let (kind, content) = line.split_once(' ')?;
        Some(match kind {
            "command" => Self::Commands(bytes(content)?),
            "data" => Self::Data(bytes(content)?),
            "says" => Self::Says(content.to_owned()),
            _ => return None,
        })
    }
}

/// Reads two hexadecimal digits a byte.
fn bytes(digits: &str) -> Option<Vec<u8>> {
    let pairs = digits.as_bytes().chunks(2);
    pairs
        .map(|pair| {
            u8::from_str_radix(str::from_utf8(pair).ok()?, 16)
                .ok()
                .filter(|_| pair.len() == 2)
        })
        .collect()
}

/// A running emulator. Dropping it ends it.
pub struct Rp2040 {
    // In this order: the child is dropped first, which ends the threads that listen to it.
    _child: KillOnDrop,
    wires: Receiver<String>,
    complaints: Receiver<String>,
}

impl Rp2040 {
    /// Says what is missing.
    ///
    /// # Errors
    /// Node.js or rp2040js is not installed.
    pub fn check_installed() -> Result<()> {
        let version = Command::new("node").arg("--version").stdout(Stdio::null()).status();
        match version {
            Err(error) if error.kind() == ErrorKind::NotFound => {
                bail!("Node.js is not installed; on Debian: apt-get install nodejs npm")
            }
            other => ensure!(other.context("cannot start node")?.success(), "node --version failed"),
        }
        ensure!(
            folder().join("node_modules/rp2040js").is_dir(),
            "rp2040js is not installed: npm ci --prefix tools/emulate/rp2040"
        );
        Ok(())
    }

    /// Starts the firmware, whose button is pressed after so many frames of a scene; the DMA's transfer of a number, from 1 on,
    /// never ends where there is one.
    pub fn start(program: &Path, frames: u32, stalled_transfer: Option<u32>) -> Result<Self> {
        let child = Command::new("node")
            .arg(folder().join("run.mjs"))
            .arg(program)
            .arg(frames.to_string())
            .args(stalled_transfer.map(|number| number.to_string()))
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .context("cannot start node")?;
        let mut child = KillOnDrop(child);
        let wires = lines(child.0.stdout.take().context("the emulator's output")?);
        let complaints = lines(child.0.stderr.take().context("the emulator's error output")?);
        Ok(Self {
            _child: child,
            wires,
            complaints,
        })
    }

    /// Waits for what goes over the wires next.
    pub fn next(&mut self) -> Result<Wire> {
        let line = self.wires.recv_timeout(TIMEOUT).map_err(|error| match error {
            RecvTimeoutError::Timeout => anyhow!("the emulator is silent for {} s", TIMEOUT.as_secs()),
            RecvTimeoutError::Disconnected => {
                let complaints: Vec<_> = self.complaints.iter().collect();
                anyhow!("the emulator ended: {}", complaints.join("; "))
            }
        })?;
        Wire::from_line(&line).with_context(|| format!("the emulator said: {line:.80}"))
    }
}

/// Where the script is.
fn folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/rp2040"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_as_the_script_prints_them() {
        assert_eq!(Wire::from_line("command 2a"), Some(Wire::Commands(vec![0x2a])));
        assert_eq!(Wire::from_line("data 00efff"), Some(Wire::Data(vec![0, 0xef, 0xff])));
        assert_eq!(
            Wire::from_line("says a frame 1: 2"),
            Some(Wire::Says("a frame 1: 2".into()))
        );
        for wrong in ["", "data", "data 0", "data 00e", "data zz", "noise 00"] {
            assert_eq!(Wire::from_line(wrong), None, "{wrong}");
        }
    }
}
