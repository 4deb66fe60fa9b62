//! Whatever zrow has in public is in the firmware that shows which panics are linked: `tools/panics/firmware`.

mod api;
mod mentions;

use std::{
    fs,
    path::{Path, PathBuf},
};

use api::Item;
use mentions::Mentions;

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn every_public_function_is_exercised() {
    let items = api::items(&api::modules(&repository().join("src/lib.rs")));
    let mut mentions = Mentions::default();
    let exercises = repository().join("tools/panics/firmware/src/bin/exercises");
    for file in fs::read_dir(&exercises).unwrap() {
        mentions.read(&fs::read_to_string(file.unwrap().path()).unwrap());
    }
    let missing: Vec<_> = items
        .iter()
        .filter(|item| !mentions.include(item))
        .map(Item::to_string)
        .collect();
    assert!(
        missing.is_empty(),
        "{} of {} are missing in tools/panics/firmware/src/bin/exercises:\n{}",
        missing.len(),
        items.len(),
        missing.join("\n")
    );
}

/// `scan` exports `Lines`, to which a file in a private folder adds `dda`, `band` exports `PictureLoop` through two private modules.
#[test]
fn what_private_folders_hand_on_is_public() {
    let items = api::items(&api::modules(&repository().join("src/lib.rs")));
    let has = |path: &str| items.iter().any(|item| item.to_string() == path);
    for path in ["Lines::dda", "PictureLoop::new", "Ramp::new", "impl Paint for Pattern"] {
        assert!(has(path), "{path}");
    }
    assert!(!has("kuzmin::divide"));
}
