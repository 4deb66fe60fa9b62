//! Report lines over semihosting, without `core::fmt`.

use cortex_m_semihosting::{debug, hio, syscall1};

/// Writes a line that begins with `kind`; `key`s follow, `end` ends it.
pub fn line(kind: &str) -> Line {
    let mut line = Line(hio::hstdout().ok());
    line.write(kind);
    line
}

/// A line being written.
#[must_use = "the line has no end yet"]
pub struct Line(Option<hio::HostStream>);

impl Line {
    /// Appends ` key=value`.
    pub fn text(mut self, key: &str, value: &str) -> Self {
        for part in [" ", key, "=", value] {
            self.write(part);
        }
        self
    }

    /// Appends ` key=value` in decimal.
    pub fn number(self, key: &str, value: u32) -> Self {
        let mut digits = [b'0'; 10];
        let mut rest = value;
        let mut first = digits.len();
        for (index, digit) in digits.iter_mut().enumerate().rev() {
            *digit += (rest % 10) as u8;
            rest /= 10;
            first = index;
            if rest == 0 {
                break;
            }
        }
        let text = digits.get(first..).unwrap_or_default();
        self.text(key, core::str::from_utf8(text).unwrap_or_default())
    }

    /// Ends the line.
    pub fn end(mut self) {
        self.write("\n");
    }

    /// A lost line is noticed by the host, which misses it.
    fn write(&mut self, text: &str) {
        if let Some(stream) = &mut self.0 {
            let _ = stream.write_all(text.as_bytes());
        }
    }
}

/// Ends the emulation.
pub fn exit(success: bool) -> ! {
    debug::exit(if success {
        debug::EXIT_SUCCESS
    } else {
        debug::EXIT_FAILURE
    });
    loop {
        cortex_m::asm::bkpt();
    }
}

/// The names of the counts that the host wants, blank-separated; none for all.
pub fn wanted(buffer: &mut [u8]) -> &str {
    // The first word is the program.
    command_line(buffer).split_once(' ').map_or("", |(_, counts)| counts)
}

/// The words the host passed to the emulator, blank-separated.
fn command_line(buffer: &mut [u8]) -> &str {
    let block = [buffer.as_mut_ptr() as usize, buffer.len()];
    // SAFETY: the block holds the address and the length of a buffer that is borrowed mutably for the whole call; the
    // host writes a text with a final zero into it and its length into the block.
    let length = unsafe {
        let failed = syscall1!(GET_CMDLINE, core::ptr::from_ref(&block) as usize);
        core::hint::black_box(&block);
        if failed == 0 {
            core::ptr::read_volatile(&block[1])
        } else {
            0
        }
    };
    let text = buffer.get(..length).unwrap_or_default();
    core::str::from_utf8(text).unwrap_or_default().trim_end_matches('\0')
}
