//! The playground as WebAssembly: the page writes a state into a static buffer, calls a function with numbers, and reads
//! pixels out of another static buffer.
//!
//! Buffers are named by their addresses in the linear memory. One thread calls: each function borrows everything and
//! returns without it.
#![no_std]

mod border;
mod canvas;

use core::panic::PanicInfo;

/// Nothing here panics on input; if something does, the page gets an exception.
#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
