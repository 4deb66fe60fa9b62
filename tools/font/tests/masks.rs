//! The masks of DejaVu Sans against exact areas, metrics and kerning of its tables, and the checked-in modules against fresh
//! conversions.

#[path = "../../../tests/reference/exact_area.rs"]
mod exact_area;

use skrifa::{FontRef, MetadataProvider, raw::TableProvider};
use zrow::{draw::FillRule, geometry::Window};
use zrow_font::{
    characters,
    font::{Hinting, Options, Source},
    mask::Mask,
    module,
    module_parts::Origin,
};

fn options(size: f32, characters: &str) -> Options {
    Options {
        size,
        characters: characters::parse(characters).unwrap(),
        hinting: Hinting::None,
        kerning: true,
        replacement: None,
    }
}

/// Each pixel of a mask against the area of the outline in `f64`. Coverage is rounded twice, to 255ths and to fifteenths,
/// which moves the limit between two fifteenths by half a 255th.
fn check(source: &Source<'_>, character: char, size: f32, hinting: Hinting) {
    let contours = source.outline_of(character, size, hinting).unwrap();
    let mask = Mask::of(&contours).unwrap();
    let corners = || contours.0.iter().flatten();
    let (Some(left), Some(top)) = (corners().map(|c| c.0).min(), corners().map(|c| c.1).min()) else {
        assert!(mask.window.is_empty(), "{character:?}");
        return;
    };
    let around = Window {
        left: (left >> 8) - 1,
        top: (top >> 8) - 1,
        right: (corners().map(|c| c.0).max().unwrap() >> 8) + 3,
        bottom: (corners().map(|c| c.1).max().unwrap() >> 8) + 3,
    };
    let areas = exact_area::exact(&contours.0, FillRule::NonZero, &around);
    let points = (around.top..around.bottom).flat_map(|y| (around.left..around.right).map(move |x| (x, y)));
    for ((x, y), area) in points.zip(areas) {
        let window = mask.window;
        let is_inside = (window.left..window.right).contains(&x) && (window.top..window.bottom).contains(&y);
        let index = || (y - window.top) as usize * window.width() as usize + (x - window.left) as usize;
        let found = if is_inside { mask.fifteenths[index()] } else { 0 };
        let off = (f64::from(found) - area * 15.0).abs();
        assert!(
            off <= 0.5 + 0.6 * 15.0 / 255.0,
            "{character:?} at {size}, ({x}, {y}): {found} for {area}"
        );
    }
}

#[test]
fn masks_are_exact_areas() {
    let source = Source::new(dejavu::sans::regular()).unwrap();
    for size in [12.0, 16.0, 24.0] {
        for character in characters::parse(" -~°éÅ").unwrap() {
            check(&source, character, size, Hinting::None);
        }
    }
}

/// Letters without curves at their ends reach from a whole row to a whole row, and stay in their columns.
#[test]
fn hinted_masks_are_exact_areas_and_stand_on_whole_rows() {
    let source = Source::new(dejavu::sans::regular()).unwrap();
    for size in [12.0, 16.0] {
        for character in characters::parse("0-9EHTexz").unwrap() {
            check(&source, character, size, Hinting::Vertical);
        }
        for character in ['E', 'H', 'T', 'z'] {
            let contours = source.outline_of(character, size, Hinting::Vertical).unwrap();
            let rows = || {
                contours
                    .0
                    .iter()
                    .flatten()
                    .map(|corner| (corner.1 + 128) as f32 / 256.0)
            };
            let (top, bottom) = (rows().fold(f32::MAX, f32::min), rows().fold(f32::MIN, f32::max));
            assert_eq!(
                (top.fract(), bottom.fract()),
                (0.0, 0.0),
                "{character:?} at {size}: {top} to {bottom}"
            );
            // Columns stay where they are, to the 64th of a pixel that the interpreter counts in.
            let plain = source.outline_of(character, size, Hinting::None).unwrap();
            let columns = |contours: &zrow_font::outline::Contours| {
                let columns = || contours.0.iter().flatten().map(|corner| corner.0);
                (columns().min().unwrap(), columns().max().unwrap())
            };
            let (hinted, plain) = (columns(&contours), columns(&plain));
            assert!(
                hinted.0.abs_diff(plain.0) <= 5 && hinted.1.abs_diff(plain.1) <= 5,
                "{character:?}"
            );
        }
    }
}

#[test]
fn advances_and_kerning_are_those_of_the_tables() {
    let bytes = dejavu::sans::regular();
    let font = FontRef::new(bytes).unwrap();
    let converted = Source::new(bytes).unwrap().convert(&options(24.0, " -~")).unwrap();
    let hmtx = font.hmtx().unwrap();
    let kern = font.kern().unwrap();
    let tables: Vec<_> = kern.subtables().map(|table| table.unwrap().kind().unwrap()).collect();
    let id = |character: char| font.charmap().map(character).unwrap();
    let scaled = |units: i32| f64::from(units) * 24.0 / 2048.0 * 16.0;
    for glyph in &converted.glyphs {
        let units = hmtx.advance(id(glyph.character)).unwrap();
        assert!(
            (f64::from(glyph.advance) - scaled(units.into())).abs() <= 0.5,
            "{:?}",
            glyph.character
        );
    }
    // This font has its kerning in GPOS and in kern, and says the same in both.
    let mut pairs = 0;
    for (left, one) in converted.glyphs.iter().enumerate() {
        for (right, other) in converted.glyphs.iter().enumerate() {
            let units: i32 = tables
                .iter()
                .map(|table| match table {
                    skrifa::raw::tables::kern::SubtableKind::Format0(table) => {
                        table.kerning(id(one.character), id(other.character)).unwrap_or(0)
                    }
                    _ => panic!("a table of another format"),
                })
                .sum();
            let found = converted
                .kerning
                .binary_search_by_key(&(left as u16, right as u16), |pair| (pair.0, pair.1));
            let found = found.map_or(0, |index| converted.kerning[index].2);
            assert!(
                (f64::from(found) - scaled(units)).abs() <= 0.5,
                "{:?} {:?}",
                one.character,
                other.character
            );
            pairs += usize::from(found != 0);
        }
    }
    assert!(pairs == converted.kerning.len() && pairs > 150, "{pairs}");
}

/// The modules of the scenes compile, as part of another crate, and are what the converter writes today.
#[test]
fn checked_in_modules_are_what_is_converted_today() {
    let (regular, bold) = (dejavu::sans::regular(), dejavu::sans::bold());
    let vertical = Options {
        hinting: Hinting::Vertical,
        ..options(12.0, " 0-9A-Za-z.:°%/")
    };
    let without_kerning = Options {
        kerning: false,
        ..options(36.0, "0-9")
    };
    for (name, options, characters, (file, bytes), kept) in [
        (
            "DEJAVU_SANS_12",
            vertical,
            " 0-9A-Za-z.:°%/",
            ("DejaVuSans.ttf", regular),
            include_str!("../../../scenes/src/fonts/dejavu_sans_12.rs"),
        ),
        (
            "DEJAVU_SANS_16",
            options(16.0, " -~°"),
            " -~°",
            ("DejaVuSans.ttf", regular),
            include_str!("../../../scenes/src/fonts/dejavu_sans_16.rs"),
        ),
        (
            "DEJAVU_SANS_24",
            options(24.0, r" 0-9.:°%/\-+CFkmh"),
            r" 0-9.:°%/\-+CFkmh",
            ("DejaVuSans.ttf", regular),
            include_str!("../../../scenes/src/fonts/dejavu_sans_24.rs"),
        ),
        (
            "DEJAVU_SANS_BOLD_36",
            without_kerning,
            "0-9",
            ("DejaVuSans-Bold.ttf", bold),
            include_str!("../../../scenes/src/fonts/dejavu_sans_bold_36.rs"),
        ),
    ] {
        let font = Source::new(bytes).unwrap().convert(&options).unwrap();
        let origin = Origin {
            file,
            characters,
            name: None,
        };
        let module = module::write(&font, &options, name, origin);
        assert!(
            module.source == kept,
            "convert {name} again: the command stands in its head"
        );
    }
    assert_eq!(module::static_name("DejaVu Sans", 24.0), "DEJAVU_SANS_24");
}

#[test]
fn a_module_says_where_it_comes_from() {
    let options = Options {
        hinting: Hinting::Vertical,
        kerning: false,
        replacement: Some('?'),
        ..options(12.5, "'?A")
    };
    let font = Source::new(dejavu::sans::regular()).unwrap().convert(&options).unwrap();
    let origin = Origin {
        file: "A [b].ttf",
        characters: "'?A",
        name: Some("NAME"),
    };
    let module = module::write(&font, &options, "NAME", origin);
    for part in [
        "//! DejaVu Sans Book at 12.5 px: coverage masks of 3 characters",
        concat!(
            "\n//! cargo run --release -- font 'A b.ttf' --size 12.5 --chars ''\\''?A'",
            " --hinting vertical --no-kerning --replacement '?' --name NAME\n"
        ),
        "// Copyright, as the font says: Copyright (c) 2003 by Bitstream, Inc.",
        "Permission is hereby granted",
        "    kerning: &[],\n",
        "    replacement: Some(1),\n",
    ] {
        assert!(module.source.contains(part), "no {part} in\n{}", module.source);
    }
    assert_eq!(module.bytes, module.mask_bytes + 3 * 12 + 3 * 8);
    assert_eq!(module::static_name("3 Font-Name (x)", 8.0), "FONT_3_FONT_NAME_X_8");
}
