//! Files that are no fonts: each gives an error or a font, in a moment, and no panic.

use std::time::Instant;

use zrow_font::{
    characters,
    font::{Hinting, Options, Source},
    module_parts::Origin,
    outline_module,
    outlines::OutlineOptions,
};

fn convert(bytes: &[u8], hinting: Hinting) -> anyhow::Result<usize> {
    let options = Options {
        size: 16.0,
        characters: characters::parse("AVo%é").unwrap(),
        hinting,
        kerning: true,
        replacement: None,
    };
    let source = Source::new(bytes)?;
    let font = source.convert(&options)?;
    let glyphs = font.glyphs.iter().map(|glyph| glyph.mask.bytes().len());
    Ok(glyphs.sum::<usize>() + convert_outlines(&source)?)
}

/// The bytes of the outlines of some characters, in the font's own units or in few.
fn convert_outlines(source: &Source<'_>) -> anyhow::Result<usize> {
    let mut bytes = 0;
    for units in [None, Some(96)] {
        let options = OutlineOptions {
            units,
            characters: characters::parse("AVo%é").unwrap(),
            kerning: true,
            replacement: None,
        };
        let font = source.convert_outlines(&options)?;
        let origin = Origin {
            file: "",
            characters: "",
            name: None,
        };
        bytes += outline_module::write(&font, &options, "FONT", origin).bytes;
    }
    Ok(bytes)
}

/// xorshift32.
struct Random(u32);

impl Random {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }
}

/// Runs a conversion, which has to end in a second, and says whether it gave a font.
fn gives_a_font(bytes: &[u8], hinting: Hinting, what: impl Fn() -> String) -> bool {
    let start = Instant::now();
    let converted = convert(bytes, hinting);
    let elapsed = start.elapsed();
    assert!(elapsed.as_secs() < 20, "{elapsed:?} for {}", what());
    if let Err(error) = &converted {
        assert!(!error.to_string().is_empty());
    }
    converted.is_ok()
}

#[test]
fn files_that_end_early() {
    let bytes = dejavu::sans::regular();
    let fonts = (0..bytes.len())
        .step_by(389)
        .filter(|&length| gives_a_font(&bytes[..length], Hinting::None, || format!("{length} bytes")))
        .count();
    // The tables of the chosen glyphs lie before the end of the file.
    assert!(fonts > 0 && fonts < bytes.len() / 389, "{fonts}");
}

#[test]
fn files_with_wrong_bytes() {
    let whole = dejavu::sans::regular();
    let mut random = Random(0x2468_ace1);
    for hinting in [Hinting::None, Hinting::Vertical] {
        let mut fonts = 0;
        for attempt in 0..400 {
            let mut bytes = whole.to_vec();
            // Most of them in the tables that are read: a table's record, or anywhere in a table.
            for _ in 0..1 + random.next() % 200 {
                let length = if random.next().is_multiple_of(4) {
                    400
                } else {
                    bytes.len()
                };
                let at = random.next() as usize % length;
                bytes[at] = random.next() as u8;
            }
            fonts += usize::from(gives_a_font(&bytes, hinting, || format!("attempt {attempt}")));
        }
        assert!(fonts > 10, "{fonts}");
    }
}

/// Bytes are changed in each table that a conversion reads, one table at a time.
#[test]
fn wrong_bytes_in_every_table() {
    let whole = dejavu::sans::regular();
    let mut random = Random(0x1357_9bdf);
    let number = |at: usize| u32::from_be_bytes(whole[at..at + 4].try_into().unwrap()) as usize;
    let tables = usize::from(u16::from_be_bytes([whole[4], whole[5]]));
    assert!(tables > 10);
    for table in 0..tables {
        let record = 12 + 16 * table;
        let (offset, length) = (number(record + 8), number(record + 12));
        for attempt in 0..12 {
            let mut bytes = whole.to_vec();
            for _ in 0..1 + random.next() % 40 {
                // Often near the start, where counts and offsets are.
                let within = if random.next().is_multiple_of(2) {
                    length.min(64)
                } else {
                    length
                };
                bytes[offset + random.next() as usize % within] = random.next() as u8;
            }
            gives_a_font(&bytes, Hinting::Vertical, || {
                format!("table {table}, attempt {attempt}")
            });
        }
    }
}

#[test]
fn errors_say_what_to_do() {
    let whole = dejavu::sans::regular();
    let error = |bytes: &[u8], size: f32, characters: &str| {
        let options = Options {
            size,
            characters: characters.chars().collect(),
            hinting: Hinting::None,
            kerning: true,
            replacement: None,
        };
        let converted = Source::new(bytes).and_then(|source| source.convert(&options));
        format!("{:#}", converted.map(|_| ()).unwrap_err())
    };
    for (message, part) in [
        (error(b"", 16.0, "A"), "pass a TTF or OTF file"),
        (error(b"wOF2....", 16.0, "A"), "unpack it"),
        (error(&whole[..2000], 16.0, "A"), "pass another one"),
        (error(whole, 16.0, "A\u{65e5}\u{672c}"), "'日', '本': leave them out"),
        (error(whole, 1.0, "A"), "choose one from 4 to 300"),
        (error(whole, f32::NAN, "A"), "choose one from 4 to 300"),
        (error(whole, 300.0, "A@"), "smaller --size"),
        (error(whole, 16.0, ""), "name some with --chars"),
    ] {
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn errors_of_outlines_say_what_to_do() {
    let source = Source::new(dejavu::sans::regular()).unwrap();
    let error = |units: u16, characters: &str| {
        let options = OutlineOptions {
            units: Some(units),
            characters: characters.chars().collect(),
            kerning: true,
            replacement: None,
        };
        format!("{:#}", source.convert_outlines(&options).map(|_| ()).unwrap_err())
    };
    for (message, part) in [
        (error(15, "A"), "choose 16 to 16384"),
        (error(16_385, "A"), "choose 16 to 16384"),
        (error(100, ""), "name some with --chars"),
        (error(100, "\u{65e5}"), "leave them out"),
    ] {
        assert!(message.contains(part), "{message}");
    }
}

/// The program ends with an error where it cannot write a font, and says why.
#[test]
fn the_program_fails_with_a_message() {
    let folder = std::env::temp_dir().join(format!("zrow-font-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (good, bad) = (folder.join("good.ttf"), folder.join("bad.ttf"));
    std::fs::write(&good, dejavu::sans::regular()).unwrap();
    std::fs::write(&bad, b"not a font").unwrap();
    let run = |file: &std::path::Path, arguments: &[&str]| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_zrow-font"))
            .arg(file)
            .args(arguments)
            .arg("--output")
            .arg(folder.join("font.rs"))
            .output()
            .unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.success(), message)
    };
    for (file, arguments, part) in [
        (&bad, &["--outlines", "--chars", "A"][..], "pass a TTF or OTF file"),
        (
            &folder.join("none.ttf"),
            &["--outlines", "--chars", "A"],
            "pass the path of a font",
        ),
        (&good, &["--chars", "A"], "--size"),
        (
            &good,
            &["--outlines", "--size", "12", "--chars", "A"],
            "cannot be used with",
        ),
        (
            &good,
            &["--size", "12", "--units", "99", "--chars", "A"],
            "cannot be used with",
        ),
        (
            &good,
            &["--outlines", "--units", "9", "--chars", "A"],
            "choose 16 to 16384",
        ),
        (&good, &["--outlines", "--units", "70000", "--chars", "A"], "70000"),
        (&good, &["--outlines", "--chars", "9-0"], "write 0-9"),
    ] {
        let (is_success, message) = run(file, arguments);
        assert!(!is_success && message.contains(part), "{arguments:?}: {message}");
        assert!(!folder.join("font.rs").exists());
    }
    let (is_success, message) = run(&good, &["--outlines", "--units", "100", "--chars", "0-9"]);
    assert!(is_success, "{message}");
    assert!(
        std::fs::read_to_string(folder.join("font.rs"))
            .unwrap()
            .contains("DEJAVU_SANS_OUTLINES")
    );
    std::fs::remove_dir_all(&folder).unwrap();
}

/// Names of the module's own tables and keywords are refused, and so is a file that the program has not written.
#[test]
fn the_program_refuses_names_that_are_taken() {
    let folder = std::env::temp_dir().join(format!("zrow-font-names-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("good.ttf"), dejavu::sans::regular()).unwrap();
    std::fs::write(folder.join("lib.rs"), "mod digits;\n").unwrap();
    let run = |arguments: &[&str]| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_zrow-font"))
            .args(["good.ttf", "--chars", "0-9"])
            .args(arguments)
            .current_dir(&folder)
            .output()
            .unwrap();
        (
            output.status.success(),
            String::from_utf8_lossy(&output.stderr).into_owned(),
        )
    };
    for kind in [&["--size", "12"][..], &["--outlines"]] {
        for name in [
            "RANGES", "GLYPHS", "KERNING", "COVERAGE", "POINTS", "FLAGS", "static", "Self", "A B", "_", "1X", "",
        ] {
            let (is_success, message) = run(&[kind, &["--name", name]].concat());
            assert!(
                !is_success && message.contains("is no name of a static"),
                "{name}: {message}"
            );
        }
        let (is_success, message) = run(&[kind, &["--name", "LIB"]].concat());
        assert!(
            !is_success && message.contains("lib.rs is there") && message.contains("--output"),
            "{message}"
        );
        // What it wrote itself is written again.
        for _ in 0..2 {
            let (is_success, message) = run(&[kind, &["--name", "DIGITS"]].concat());
            assert!(is_success, "{message}");
        }
    }
    assert_eq!(std::fs::read_to_string(folder.join("lib.rs")).unwrap(), "mod digits;\n");
    let (is_success, message) = run(&["--size", "12", "--name", "LIB", "--output", "lib.rs"]);
    assert!(is_success, "{message}");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 3);
    std::fs::remove_dir_all(&folder).unwrap();
}
