//! Draws `docs/architecture.svg`: one row of an antialiased triangle on its way through the stages. The numbers in it are what
//! the library computes.

mod picture;
mod row;

use std::{fs, path::Path};

fn main() -> anyhow::Result<()> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/architecture.svg");
    fs::write(&file, picture::svg()?)?;
    println!("docs/architecture.svg is drawn anew");
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::picture;

    #[test]
    fn the_picture_is_what_the_program_draws() {
        let drawn = picture::svg().unwrap();
        let kept = include_str!("../../../docs/architecture.svg");
        assert!(drawn == kept, "run `cargo run -p zrow-architecture`");
    }
}
