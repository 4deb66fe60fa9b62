//! Talking to the machine that runs the emulator (or holds the debug probe), over semihosting.

use cortex_m_semihosting::{nr, syscall1};

/// How the host wants the frames.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// One turn of the animation at full speed, then the end.
    Once,
    /// The animation for ever, at the pace of the eye.
    Loop,
    /// After each frame wait for a byte from the host.
    Step,
}

/// Reads the mode from the program's arguments (`-semihosting-config ...,arg=zrow,arg=step`).
pub fn mode() -> Mode {
    let mut text = [0_u8; 256];
    let mut words = arguments(&mut text).split(|&byte| byte == b' ');
    words
        .find_map(|word| match word {
            b"loop" => Some(Mode::Loop),
            b"step" => Some(Mode::Step),
            _ => None,
        })
        .unwrap_or(Mode::Once)
}

/// Waits until the host sends a byte.
pub fn wait_for_byte() {
    // SAFETY: SYS_READC takes no argument and touches no memory.
    unsafe { syscall1(nr::READC, 0) };
}

/// The command line in `text`, empty where the host has none.
fn arguments(text: &mut [u8]) -> &[u8] {
    // What SYS_GET_CMDLINE reads and writes: where the text goes, and its length.
    let mut block = [text.as_mut_ptr() as usize, text.len()];
    // SAFETY: the host writes the text into the buffer the block points at, its length into the block, and no more.
    let status = unsafe { syscall1(nr::GET_CMDLINE, block.as_mut_ptr() as usize) };
    let length = if status == 0 { block[1] } else { 0 };
    text.get(..length).unwrap_or(&[])
}
