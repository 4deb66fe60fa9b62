//! Files that are no models: each gives an error or a model, in a moment, and no panic.

use std::time::Instant;

use zrow::scene::FaceSet;
use zrow_mesh::{
    mesh::Options,
    module::{self, Origin},
};

use crate::common::{CUBE, Files, OPTIONS, Random, convert};

const MODEL: &[u8] = include_bytes!("models/letter.obj");
const MATERIALS: &[u8] = include_bytes!("models/letter.mtl");
const PICTURE: &[u8] = include_bytes!("models/letter.png");

/// Converts a file and writes its module, which has to end in seconds, and says whether there is one.
fn gives_a_module(bytes: &[u8], name: &str, beside: Files<'_>, what: impl Fn() -> String) -> bool {
    let start = Instant::now();
    let mesh = convert(
        bytes,
        name,
        beside,
        Options {
            levels: 2,
            edges: Some(30),
            ..OPTIONS
        },
    );
    let is_model = match mesh {
        Ok(mesh) => {
            assert!(FaceSet::new(&mesh.vertices, &mesh.faces).is_ok(), "{}", what());
            assert!(!mesh.faces.is_empty() && mesh.colors.len() == mesh.faces.len());
            assert!(
                mesh.vertices.iter().flatten().all(|coordinate| coordinate.abs() <= 100),
                "{}",
                what()
            );
            assert_eq!(mesh.normals.len(), mesh.vertices.len());
            for level in &mesh.levels {
                let vertices = &mesh.vertices[..level.vertices];
                assert!(FaceSet::new(vertices, &level.faces).is_ok(), "{}", what());
                assert!(level.faces.len() == level.colors.len() && level.faces.len() < mesh.faces.len());
            }
            assert!(
                mesh.greatest_error.is_finite() && mesh.greatest_error < 1.0,
                "{}",
                what()
            );
            let origin = Origin { file: name, name: None };
            module::write(&mesh, OPTIONS, "MODEL", origin).bytes > 0
        }
        Err(error) => {
            let message = format!("{error:#}");
            // A message names a file, and does not repeat it.
            let begin: String = message.chars().take(500).collect();
            assert!(begin.contains("letter.") || begin.contains("cube."), "{begin}");
            assert!(message.len() < 800, "{begin}");
            false
        }
    };
    let elapsed = start.elapsed();
    assert!(elapsed.as_secs() < 5, "{elapsed:?} for {}", what());
    is_model
}

/// Words that are wrong almost everywhere, or only sometimes.
const WORDS: [&str; 24] = [
    "0",
    "-0",
    "1",
    "-1",
    "11",
    "-11",
    "65536",
    "4294967297",
    "-9223372036854775808",
    "18446744073709551616",
    "nan",
    "inf",
    "1e9",
    "-1e9",
    "1e-320",
    "1e400",
    "1//",
    "//1",
    "1/1/1/1",
    "\\",
    "#",
    "f",
    "\u{0}",
    "\u{e9}",
];

/// Changes one line of a text: bytes, words, the end, the line as a whole.
fn mutated(text: &[u8], line: usize, random: &mut Random) -> Vec<u8> {
    let mut lines: Vec<Vec<u8>> = text.split(|&byte| byte == b'\n').map(<[u8]>::to_vec).collect();
    let other = lines[random.below(lines.len())].clone();
    let changed = &mut lines[line];
    match random.below(7) {
        0 => {
            for _ in 0..1 + random.below(3) {
                let at = random.below(changed.len());
                if let Some(byte) = changed.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
        }
        1 => changed.truncate(random.below(changed.len())),
        2 => {
            let times = [2, 2, 3, 2_000][random.below(4)];
            let one = [changed.as_slice(), b"\n"].concat();
            *changed = one.repeat(times);
        }
        3 => {
            let mut words: Vec<String> = String::from_utf8_lossy(changed).split(' ').map(str::to_owned).collect();
            let at = random.below(words.len());
            words[at] = WORDS[random.below(WORDS.len())].to_owned();
            *changed = words.join(" ").into_bytes();
        }
        4 => {
            let word = WORDS[random.below(WORDS.len())];
            let times = [1, 2, 1_000, 100_000][random.below(4)];
            changed.extend(format!(" {word}").repeat(times).into_bytes());
        }
        5 => *changed = other,
        _ => changed.clear(),
    }
    lines.join(&b'\n')
}

#[test]
fn every_line_of_a_model_is_mutated() {
    let mut random = Random(0x2468_ace1);
    let (mut models, mut attempts) = (0, 0);
    for line in 0..MODEL.split(|&byte| byte == b'\n').count() {
        for _ in 0..15 {
            let bytes = mutated(MODEL, line, &mut random);
            let beside: Files<'_> = &[("letter.mtl", MATERIALS), ("letter.png", PICTURE)];
            let what = || String::from_utf8_lossy(&bytes[..bytes.len().min(2_000)]).into_owned();
            models += usize::from(gives_a_module(&bytes, "letter.obj", beside, what));
            attempts += 1;
        }
    }
    assert!(
        models > attempts / 10 && models < attempts * 9 / 10,
        "{models} of {attempts}"
    );
}

#[test]
fn every_line_of_the_materials_is_mutated() {
    let mut random = Random(0x1357_9bdf);
    let mut models = 0;
    for line in 0..MATERIALS.split(|&byte| byte == b'\n').count() {
        for _ in 0..60 {
            let materials = mutated(MATERIALS, line, &mut random);
            let beside: Files<'_> = &[("letter.mtl", &materials), ("letter.png", PICTURE)];
            let what = || String::from_utf8_lossy(&materials[..materials.len().min(2_000)]).into_owned();
            models += usize::from(gives_a_module(MODEL, "letter.obj", beside, what));
        }
    }
    assert!(models > 60, "{models}");
}

#[test]
fn bytes_of_the_picture_are_mutated() {
    let mut random = Random(0xfedc_ba98);
    for attempt in 0..2_000 {
        let mut picture = PICTURE.to_vec();
        for _ in 0..1 + random.below(4) {
            let at = random.below(picture.len());
            picture[at] = random.below(256) as u8;
        }
        if random.below(4) == 0 {
            picture.truncate(random.below(picture.len()));
        }
        // Most of them with the right checksums, so that they are decoded.
        if random.below(4) > 0 {
            correct_checksums(&mut picture);
        }
        let beside: Files<'_> = &[("letter.mtl", MATERIALS), ("letter.png", &picture)];
        gives_a_module(MODEL, "letter.obj", beside, || format!("attempt {attempt}"));
    }
}

/// Writes the checksum of each chunk of a PNG.
fn correct_checksums(picture: &mut [u8]) {
    let mut at = 8;
    while let Some(length) = picture.get(at..).and_then(|rest| rest.first_chunk()).copied() {
        let end = at + 8 + u32::from_be_bytes(length) as usize;
        let Some(chunk) = picture.get(at + 4..end) else {
            return;
        };
        let mut remainder = u32::MAX;
        for &byte in chunk {
            remainder ^= u32::from(byte);
            for _ in 0..8 {
                remainder = remainder >> 1 ^ (0xedb8_8320 & (remainder & 1).wrapping_neg());
            }
        }
        if let Some(sum) = picture.get_mut(end..end + 4) {
            sum.copy_from_slice(&(!remainder).to_be_bytes());
        }
        at = end + 4;
    }
}

#[test]
fn stl_files_are_mutated() {
    let mut text = "solid cube\n".to_owned();
    let mut binary = [[0; 80].as_slice(), &4u32.to_le_bytes()].concat();
    for corners in [
        [[0, 0, 0], [9, 0, 0], [0, 9, 0]],
        [[0, 0, 0], [0, 0, 9], [9, 0, 0]],
        [[0, 0, 0], [0, 9, 0], [0, 0, 9]],
        [[9, 0, 0], [0, 0, 9], [0, 9, 0]],
    ] {
        text += "facet normal 0 0 0\nouter loop\n";
        binary.extend([0; 12]);
        for [x, y, z] in corners {
            text += &format!("vertex {x} {y} {z}\n");
            binary.extend([x, y, z].iter().flat_map(|&number| (number as f32).to_le_bytes()));
        }
        text += "endloop\nendfacet\n";
        binary.extend([0; 2]);
    }
    text += "endsolid\n";
    let mut random = Random(0x0f1e_2d3c);
    let mut models = [0; 2];
    for line in 0..text.lines().count() {
        for attempt in 0..60 {
            let bytes = mutated(text.as_bytes(), line, &mut random);
            models[0] += u32::from(gives_a_module(&bytes, "cube.stl", &[], || {
                format!("line {line}, {attempt}")
            }));
            let mut bytes = binary.clone();
            for _ in 0..1 + random.below(3) {
                let at = random.below(bytes.len());
                bytes[at] = random.below(256) as u8;
            }
            if random.below(8) == 0 {
                bytes.truncate(random.below(bytes.len()));
            }
            models[1] += u32::from(gives_a_module(&bytes, "cube.stl", &[], || {
                format!("binary {line}, {attempt}")
            }));
        }
    }
    assert!(models.iter().all(|&models| models > 100), "{models:?}");
}

#[test]
fn models_that_end_early() {
    let beside: Files<'_> = &[("letter.mtl", MATERIALS), ("letter.png", PICTURE)];
    let gives = |length: usize| gives_a_module(&MODEL[..length], "letter.obj", beside, || format!("{length} bytes"));
    let models = (0..MODEL.len()).filter(|&length| gives(length)).count();
    assert!(models > 0 && models < MODEL.len() / 2, "{models}");
    for length in 0..PICTURE.len() {
        let beside: Files<'_> = &[("letter.mtl", MATERIALS), ("letter.png", &PICTURE[..length])];
        gives_a_module(MODEL, "letter.obj", beside, || format!("{length} bytes of the picture"));
    }
}

#[test]
fn any_bytes_are_no_model() {
    let mut random = Random(0x7777_1234);
    for attempt in 0..2_000 {
        let length = random.below(400);
        let bytes: Vec<u8> = (0..length).map(|_| random.below(256) as u8).collect();
        for name in ["cube.obj", "cube.stl"] {
            assert!(!gives_a_module(&bytes, name, &[], || format!("attempt {attempt}")));
        }
    }
}

/// Random corners of a polygon of the greatest size cross each other everywhere.
#[test]
fn tangled_faces_take_a_moment() {
    let mut random = Random(0x3141_5926);
    let mut text = CUBE.to_owned();
    for _ in 0..1_000 {
        let [x, y, z] = [0; 3].map(|_| random.below(2_001) as f64 / 1_000.0 - 1.0);
        text += &format!("v {x} {y} {z}\n");
    }
    for _ in 0..4 {
        let corners: String = (0..1_024).map(|_| format!(" {}", 1 + random.below(1_008))).collect();
        text += &format!("f{corners}\n");
    }
    assert!(gives_a_module(text.as_bytes(), "cube.obj", &[], || "tangled".to_owned()));
}
