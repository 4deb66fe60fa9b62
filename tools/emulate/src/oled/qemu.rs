//! QEMU with the board in it: starts it, listens to the firmware, asks the monitor for pictures, and ends it.
//!
//! Two channels. The firmware's semihosting console is QEMU's standard input and output: the firmware reports a frame
//! and halts until a byte comes back, so that a picture taken in between is of that frame, whole. QEMU's monitor (QMP,
//! one JSON object a line) is a TCP connection that QEMU opens to this program. Every wait has a time-out.

use crate::child::{KillOnDrop, lines};
use anyhow::{Context, Result, anyhow, bail, ensure};
use image::RgbImage;
use serde_json::{Value, json};
use std::{
    io::{BufRead, BufReader, ErrorKind, Write},
    net::{TcpListener, TcpStream},
    path::Path,
    process::{Child, ChildStdin, Command, Stdio},
    sync::mpsc::{Receiver, RecvTimeoutError},
    thread::sleep,
    time::{Duration, Instant},
};

const MONITOR_TIMEOUT: Duration = Duration::from_secs(20);
const FRAME_TIMEOUT: Duration = Duration::from_secs(60);
const LAST_WORDS_TIMEOUT: Duration = Duration::from_millis(300);

/// A running QEMU. Dropping it ends it.
pub struct Qemu {
    // In this order: the child is dropped first, which ends the threads that listen to it.
    child: KillOnDrop,
    to_firmware: ChildStdin,
    reports: Receiver<String>,
    monitor: Monitor,
}

impl Qemu {
    /// Starts the firmware and connects to the monitor.
    pub fn start(program: &Path) -> Result<Self> {
        let listener = TcpListener::bind(("127.0.0.1", 0)).context("no port for QEMU's monitor")?;
        let port = listener.local_addr()?.port();
        let child = Command::new("qemu-system-arm")
            .args([
                "-M",
                "lm3s6965evb",
                "-nodefaults",
                "-display",
                "none",
                "-icount",
                "shift=0",
            ])
            .args(["-chardev", &format!("socket,id=monitor,host=127.0.0.1,port={port}")])
            .args(["-mon", "chardev=monitor,mode=control"])
            .args(["-chardev", "stdio,id=console,signal=off"])
            .args([
                "-semihosting-config",
                "enable=on,target=native,chardev=console,arg=zrow,arg=step",
            ])
            .arg("-kernel")
            .arg(program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| match error.kind() {
                ErrorKind::NotFound => {
                    anyhow!("qemu-system-arm is not installed; on Debian: apt-get install qemu-system-arm")
                }
                _ => anyhow!(error).context("cannot start qemu-system-arm"),
            })?;
        let mut child = KillOnDrop(child);
        let to_firmware = child.0.stdin.take().context("QEMU's input")?;
        let reports = lines(child.0.stdout.take().context("QEMU's output")?);
        let complaints = lines(child.0.stderr.take().context("QEMU's error output")?);
        let monitor = accept(&listener, &mut child.0)
            .and_then(Monitor::new)
            .map_err(|error| {
                let complaints: Vec<_> = complaints.try_iter().collect();
                error.context(format!("QEMU said: {}", complaints.join("; ")))
            })?;
        Ok(Self {
            child,
            to_firmware,
            reports,
            monitor,
        })
    }

    /// Waits until the firmware has a frame of a scene on the panel; returns how long that took.
    pub fn wait_for_frame(&mut self, scene: &str, frame: u32) -> Result<Ticks> {
        let line = self.reports.recv_timeout(FRAME_TIMEOUT).map_err(|error| match error {
            RecvTimeoutError::Timeout => anyhow!("no frame {frame} of {scene} within {} s", FRAME_TIMEOUT.as_secs()),
            RecvTimeoutError::Disconnected => anyhow!(
                "QEMU ended before frame {frame} of {scene}: {:?}",
                self.child.0.try_wait()
            ),
        })?;
        // A panic message has more lines, and the firmware ends after it.
        Ticks::of_frame(scene, frame, &line).ok_or_else(|| {
            anyhow!(
                "instead of frame {frame} of {scene} the firmware said: {line} {}",
                self.last_words()
            )
        })
    }

    /// What the firmware says from here on, for a short while.
    fn last_words(&self) -> String {
        let mut words = Vec::new();
        while let Ok(line) = self.reports.recv_timeout(LAST_WORDS_TIMEOUT) {
            words.push(line);
        }
        words.join(" ")
    }

    /// Lets the firmware go on.
    pub fn next_frame(&mut self) -> Result<()> {
        self.to_firmware
            .write_all(b"\n")
            .and_then(|()| self.to_firmware.flush())
            .context("QEMU's input")
    }

    /// The panel's picture; `file` is where QEMU puts it on the way.
    pub fn screendump(&mut self, file: &Path) -> Result<RgbImage> {
        let file = std::path::absolute(file)?;
        self.monitor.execute("screendump", json!({ "filename": file }))?;
        let picture = image::open(&file).with_context(|| format!("cannot read {}", file.display()))?;
        std::fs::remove_file(&file)?;
        Ok(picture.into_rgb8())
    }
}

/// Waits for QEMU to connect.
fn accept(listener: &TcpListener, child: &mut Child) -> Result<TcpStream> {
    listener.set_nonblocking(true)?;
    let deadline = Instant::now() + MONITOR_TIMEOUT;
    loop {
        match listener.accept() {
            Ok((stream, _)) => {
                stream.set_nonblocking(false)?;
                return Ok(stream);
            }
            Err(error) if error.kind() != ErrorKind::WouldBlock => return Err(error.into()),
            Err(_) => {}
        }
        if let Some(status) = child.try_wait()? {
            bail!("QEMU ended at once ({status})");
        }
        ensure!(Instant::now() < deadline, "QEMU did not open its monitor");
        sleep(Duration::from_millis(10));
    }
}

/// QEMU's machine protocol.
struct Monitor {
    stream: BufReader<TcpStream>,
}

impl Monitor {
    fn new(stream: TcpStream) -> Result<Self> {
        stream.set_read_timeout(Some(MONITOR_TIMEOUT))?;
        stream.set_write_timeout(Some(MONITOR_TIMEOUT))?;
        let mut monitor = Self {
            stream: BufReader::new(stream),
        };
        let greeting = monitor.read()?;
        ensure!(greeting.get("QMP").is_some(), "not QEMU's monitor: {greeting}");
        monitor.execute("qmp_capabilities", json!({}))?;
        Ok(monitor)
    }

    /// Sends a command and waits for its answer, past the events that come in between.
    fn execute(&mut self, command: &str, arguments: Value) -> Result<()> {
        let request = json!({ "execute": command, "arguments": arguments });
        self.stream
            .get_mut()
            .write_all(format!("{request}\n").as_bytes())
            .context("QEMU's monitor")?;
        loop {
            let answer = self.read()?;
            if let Some(error) = answer.get("error") {
                bail!("QEMU's monitor refused {command}: {error}");
            }
            if answer.get("return").is_some() {
                return Ok(());
            }
        }
    }

    fn read(&mut self) -> Result<Value> {
        let mut line = String::new();
        let length = self
            .stream
            .read_line(&mut line)
            .context("no answer from QEMU's monitor")?;
        ensure!(length > 0, "QEMU closed its monitor");
        serde_json::from_str(&line).with_context(|| format!("QEMU's monitor said {line}"))
    }
}

/// SysTick ticks of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ticks {
    /// All of the frame.
    pub frame: u64,
    /// Those in which rows were sent to the panel.
    pub sending: u64,
}

impl Ticks {
    /// Reads them from what the firmware says of a frame.
    fn of_frame(scene: &str, frame: u32, line: &str) -> Option<Self> {
        let line = line
            .strip_prefix(&format!("{scene} frame {frame}: "))?
            .strip_suffix(" of them to send")?;
        let (frame, sending) = line.split_once(" ticks, ")?;
        Some(Self {
            frame: frame.parse().ok()?,
            sending: sending.parse().ok()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_read_from_what_the_firmware_says() {
        let ticks = Ticks {
            frame: 8_311,
            sending: 2_090,
        };
        assert_eq!(
            Ticks::of_frame("oled", 7, "oled frame 7: 8311 ticks, 2090 of them to send"),
            Some(ticks)
        );
        for other in [
            "oled frame 8: 8311 ticks, 2090 of them to send",
            "oled-teapot frame 7: 8311 ticks, 2090 of them to send",
            "oled frame 7: 8311 ticks",
            "oled frame 7: panicked",
            "",
        ] {
            assert_eq!(Ticks::of_frame("oled", 7, other), None, "{other}");
        }
    }
}
