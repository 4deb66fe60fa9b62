//! Links the programs so that they can be read: the entry point keeps what it reaches, the relocations say what calls what.

fn main() {
    println!("cargo::rustc-link-arg-bins=--entry=enter");
    println!("cargo::rustc-link-arg-bins=--emit-relocs");
    println!("cargo::rerun-if-changed=build.rs");
}
