//! The deepest use of the stack, read off the paint that cortex-m-rt lays over it at reset.

use core::ptr;

use crate::report;

/// What `paint-stack` of cortex-m-rt writes.
const PAINT: u32 = 0xCCCC_CCCC;

unsafe extern "C" {
    static _stack_start: u32;
    static _stack_end: u32;
}

/// Bytes between the top of the stack and the lowest word that lost its paint.
pub fn high_water_mark() -> u32 {
    let top = &raw const _stack_start;
    let mut word = &raw const _stack_end;
    // SAFETY: the linker script places both symbols at the ends of the free RAM, which is readable; reads are volatile
    // because the words belong to nobody.
    while word < top && unsafe { ptr::read_volatile(word) } == PAINT {
        word = word.wrapping_add(1);
    }
    (top as u32).wrapping_sub(word as u32)
}

/// Reports the mark, and the checksum of what was drawn up to then.
pub fn report(checksum: u32) {
    report::line("stack")
        .number("bytes", high_water_mark())
        .number("checksum", checksum)
        .end();
}
