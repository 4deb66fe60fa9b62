//! The simulator's command line, run as a user would.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Output},
};

fn simulator(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_zrow-simulator"));
    command.args(arguments).output().expect("the simulator runs")
}

fn error(output: &Output) -> String {
    assert!(!output.status.success());
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// An empty folder of its own for a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("the folder of an earlier run goes");
    }
    folder
}

#[test]
fn a_wrong_name_lists_the_right_ones() {
    let output = simulator(&["--scene", "no-such-scene"]);
    let message = error(&output);
    for name in zrow_scenes::NAMES {
        assert!(message.contains(name), "{name} is not in: {message}");
    }
    assert!(output.stdout.is_empty());
}

#[test]
fn numbers_out_of_range_are_refused() {
    for (option, value) in [
        ("--scale", "0"),
        ("--scale", "17"),
        ("--frames", "0"),
        ("--frames", "many"),
    ] {
        let message = error(&simulator(&[option, value]));
        assert!(message.contains(option) && message.contains(value), "{message}");
    }
}

#[test]
fn a_window_needs_a_scene() {
    assert!(error(&simulator(&["--window"])).contains("--scene"));
}

#[cfg(not(feature = "window"))]
#[test]
fn without_windows_it_says_how_to_get_them() {
    let message = error(&simulator(&["--window", "--scene", "sc3"]));
    assert!(
        message.contains("--features window") && message.contains("SDL2"),
        "{message}"
    );
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let file = folder("file");
    fs::write(&file, "").expect("a file in the way");
    let output = file.join("pictures");
    let message = error(&simulator(&["--scene", "sc3", "--output", &output.to_string_lossy()]));
    assert!(message.contains("pictures"), "{message}");
    fs::remove_file(file).expect("the file goes");
}

#[test]
fn one_scene_at_a_scale_with_some_frames() {
    let folder = folder("one-scene");
    let output = simulator(&[
        "--scene",
        "sc3",
        "--scale",
        "3",
        "--frames",
        "4",
        "--output",
        &folder.to_string_lossy(),
    ]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    // 256 bytes of colour row, 256 of depth row, and what 128 x 64 pixels of 16 bits would take twice.
    for cell in ["sc3", "128 x 64", "16 bit", "256", "32,768"] {
        assert!(table.contains(cell), "{cell} is not in\n{table}");
    }
    assert_eq!(fs::read_dir(&folder).expect("it was made").count(), 2);
    let picture = image::open(folder.join("sc3.png")).expect("a picture");
    assert_eq!((picture.width(), picture.height()), (3 * 128, 3 * 64));
    assert_eq!(frames_of_gif(&folder.join("sc3.gif")), (4, 3 * 128, 3 * 64));
}

/// A second table has the capacities of scenes that are pictures, and of no others.
#[test]
fn a_picture_prints_the_capacities_that_it_takes() {
    let printed = |scene: &str| {
        let folder = folder(&format!("capacities-{scene}"));
        let output = simulator(&["--scene", scene, "--scale", "1", "--output", &folder.to_string_lossy()]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let text = printed("instruments");
    let lines = text
        .lines()
        .filter(|line| line.contains("instruments") && line.contains('┆'));
    let lines: Vec<Vec<_>> = lines
        .map(|line| line.split(['│', '┆']).map(str::trim).collect())
        .collect();
    let [scene, picture] = lines.as_slice() else {
        panic!("not one line in either table of\n{text}");
    };
    let capacities = ["instruments", "28 / 28", "512 / 538", "23 / 23", "22 / 22", "16"];
    assert_eq!(picture[1..=capacities.len()], capacities, "{text}");
    // Scene data, and 16 bytes for each of the rectangles.
    let number = |cell: &str| cell.replace(',', "").parse::<usize>().expect("a number");
    assert_eq!(number(picture[7]), number(scene[6]) + 16 * 16, "{text}");

    let text = printed("sc3");
    assert!(text.contains("sc3") && !text.contains("damage rectangles"), "{text}");
}

fn frames_of_gif(path: &Path) -> (usize, u16, u16) {
    let file = fs::File::open(path).expect("an animation");
    let mut decoder = gif::DecodeOptions::new().read_info(file).expect("a GIF");
    let (width, height) = (decoder.width(), decoder.height());
    let mut frames = 0;
    while decoder.read_next_frame().expect("a frame").is_some() {
        frames += 1;
    }
    (frames, width, height)
}

/// The GIF holds the same pixels as the PNG of the same frame.
#[test]
fn animations_lose_nothing() {
    for scene in ["sc1", "dashboard", "oled", "oled-teapot"] {
        let folder = folder(&format!("lossless-{scene}"));
        let path = folder.to_string_lossy();
        // Enough frames for the one that the PNG shows.
        let arguments = ["--scene", scene, "--scale", "1", "--frames", "14", "--output", &path];
        let output = simulator(&arguments);
        assert!(output.status.success());
        let picture = image::open(folder.join(scene).with_extension("png")).expect("a picture");
        assert!(
            shows(&folder.join(scene).with_extension("gif"), &picture.into_rgb8()),
            "no frame of {scene}.gif is the PNG"
        );
    }
}

/// Whether a frame of an animation is that picture.
fn shows(animation: &Path, picture: &image::RgbImage) -> bool {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let file = fs::File::open(animation).expect("an animation");
    let mut decoder = options.read_info(file).expect("a GIF");
    let mut shown = image::RgbImage::new(picture.width(), picture.height());
    let mut found = false;
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        let width = u32::from(frame.width);
        for (index, color) in (0..).zip(frame.buffer.chunks(4)).filter(|(_, color)| color[3] != 0) {
            let (x, y) = (
                index % width + u32::from(frame.left),
                index / width + u32::from(frame.top),
            );
            shown.put_pixel(x, y, image::Rgb([color[0], color[1], color[2]]));
        }
        found |= shown == *picture;
    }
    found
}
