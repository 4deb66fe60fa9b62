//! Hands the linker the memory map that esp-hal brings along.
fn main() {
    // Here and not in RUSTFLAGS, so that flags a caller sets there do not lose the linker script.
    println!("cargo::rustc-link-arg-bins=-Tlinkall.x");
}
