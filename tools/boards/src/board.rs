//! The boards, and how their firmware is built.

use std::{
    ops::Range,
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context, ensure};

/// A board with firmware in `boards/`.
pub struct Board {
    /// Its folder; the program is `zrow-` and that name.
    pub name: &'static str,
    pub chip: &'static str,
    pub core: &'static str,
    pub target: &'static str,
    /// Bytes of flash that a program may take.
    pub flash: u64,
    /// The addresses of the RAM that a program may take, the stack included.
    pub ram: Range<u64>,
}

/// Every board with firmware.
pub const BOARDS: [Board; 5] = [
    Board {
        name: "lm3s6965evb",
        chip: "LM3S6965",
        core: "Cortex-M3",
        target: "thumbv7m-none-eabi",
        flash: 256 << 10,
        ram: 0x2000_0000..0x2001_0000,
    },
    Board {
        name: "pico",
        chip: "RP2040",
        core: "Cortex-M0+",
        target: "thumbv6m-none-eabi",
        flash: 2 << 20,
        ram: 0x2000_0000..0x2004_2000,
    },
    Board {
        name: "stm32f411",
        chip: "STM32F411CE",
        core: "Cortex-M4F",
        target: "thumbv7em-none-eabihf",
        flash: 512 << 10,
        ram: 0x2000_0000..0x2002_0000,
    },
    Board {
        name: "nrf52840",
        chip: "nRF52840",
        core: "Cortex-M4F",
        target: "thumbv7em-none-eabihf",
        flash: 1 << 20,
        ram: 0x2000_0000..0x2004_0000,
    },
    // The addresses of data are those that esp-hal's memory map has; the rest of the 400 KiB are a cache and the loader's.
    Board {
        name: "esp32c3",
        chip: "ESP32-C3",
        core: "RISC-V, RV32IMC",
        target: "riscv32imc-unknown-none-elf",
        flash: 4 << 20,
        ram: 0x3fc8_0000..0x3fcc_e400,
    },
];

/// The root of the repository.
pub fn root() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    root.canonicalize().unwrap_or(root)
}

impl Board {
    /// Builds the firmware by the script with which it is built by hand, and says where the program is. Cargo's own progress and
    /// the script's advice what to install go to the terminal.
    ///
    /// # Errors
    /// The script cannot be started, or the build fails.
    pub fn build(&self) -> anyhow::Result<PathBuf> {
        let output = root().join("target/boards");
        let script = root().join("boards/build-firmware");
        let status = Command::new(&script)
            .arg(root().join("boards").join(self.name))
            .args([self.target, "--locked", "--target-dir"])
            .arg(&output)
            // Set by `cargo run` for this program; the script may call another compiler, which has libraries of its own.
            .env_remove("LD_LIBRARY_PATH")
            .status()
            .with_context(|| format!("cannot run {}", script.display()))?;
        ensure!(
            status.success(),
            "the firmware of {} was not built ({status})",
            self.name
        );
        let program = format!("{}/release/zrow-{}", self.target, self.name);
        Ok(output.join(program))
    }
}
