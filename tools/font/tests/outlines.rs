//! The outlines of DejaVu Sans against those of the font file, and text in the checked-in module against masks of the same glyphs.

use embedded_graphics::{
    pixelcolor::{Gray8, GrayColor},
    prelude::*,
    primitives::Rectangle,
    text::Text,
};
use skrifa::{
    FontRef, MetadataProvider,
    instance::{self, LocationRef},
    outline::{DrawSettings, OutlinePen},
    raw::TableProvider,
};
use zrow::{
    band::Band,
    coverage::InsideArea,
    draw::{AntialiasedPolygon, DrawAntialiased, FillRule, OutlineTextStyle},
    fixed::types::U24F8,
};
use zrow_font::{
    characters,
    font::{Hinting, Source},
    module_parts::Origin,
    outline_module,
    outlines::{OutlineOptions, Outlines},
};
use zrow_scenes::fonts::DEJAVU_SANS_OUTLINES;

/// The characters of the checked-in font.
const CHARACTERS: &str = r" 0-9.:°%/\-+CFkmh";

fn options(units: Option<u16>) -> OutlineOptions {
    OutlineOptions {
        units,
        characters: characters::parse(CHARACTERS).unwrap(),
        kerning: true,
        replacement: None,
    }
}

fn converted(units: Option<u16>) -> Outlines {
    let source = Source::new(dejavu::sans::regular()).unwrap();
    source.convert_outlines(&options(units)).unwrap()
}

/// The module of the scenes compiles, as part of another crate, and is what the converter writes today.
#[test]
fn the_checked_in_module_is_what_is_converted_today() {
    let kept = include_str!("../../../scenes/src/fonts/dejavu_sans_outlines.rs");
    let font = converted(None);
    let origin = Origin {
        file: "DejaVuSans.ttf",
        characters: CHARACTERS,
        name: None,
    };
    let name = outline_module::static_name(&font.names.family);
    assert_eq!(name, "DEJAVU_SANS_OUTLINES");
    let module = outline_module::write(&font, &options(None), &name, origin);
    assert!(
        module.source == kept,
        "convert it again: the command stands in its head"
    );
    let font = &DEJAVU_SANS_OUTLINES;
    let tables = 16 * font.glyphs.len() + 6 * font.kerning.len() + 8 * font.ranges.len();
    assert_eq!(module.bytes, tables + size_of_val(font.points) + font.flags.len());
    assert_eq!(font.flags.len(), font.points.len().div_ceil(4));
}

/// The same for the module of the playground, whose name was chosen.
#[test]
fn the_module_of_the_playground_is_what_is_converted_today() {
    let kept = include_str!("../../playground/scene/src/letters.rs");
    let options = OutlineOptions {
        characters: characters::parse(" -~°").unwrap(),
        ..options(None)
    };
    let source = Source::new(dejavu::sans::regular()).unwrap();
    let font = source.convert_outlines(&options).unwrap();
    let origin = Origin {
        file: "DejaVuSans.ttf",
        characters: " -~°",
        name: Some("LETTERS"),
    };
    let module = outline_module::write(&font, &options, "LETTERS", origin);
    assert!(
        module.source == kept,
        "convert it again: the command stands in its head"
    );
}

#[test]
fn few_units_take_half_the_bytes() {
    let origin = Origin {
        file: "DejaVuSans.ttf",
        characters: CHARACTERS,
        name: Some("SMALL"),
    };
    let small = converted(Some(128));
    let module = outline_module::write(&small, &options(Some(128)), "SMALL", origin);
    for part in [
        "font DejaVuSans.ttf --outlines --units 128 --chars ' 0-9",
        "CFkmh' --name SMALL\n",
        "    units_per_em: 128,\n",
        "    small_points: &POINTS,\n    points: &[],\n",
        "static POINTS: [[i8; 2]; ",
    ] {
        assert!(module.source.contains(part), "no {part} in\n{}", module.source);
    }
    let large = outline_module::write(&converted(None), &options(None), "LARGE", origin);
    assert!(
        module.points <= large.points && module.point_bytes < large.point_bytes * 6 / 10,
        "{} {}",
        module.point_bytes,
        large.point_bytes
    );
}

/// The points of a glyph as they stand in the table `glyf`: skrifa's pen gives them with every implied point.
#[derive(Default)]
struct EveryPoint(Vec<([f32; 2], bool)>);

impl OutlinePen for EveryPoint {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.push(([x, y], true));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.push(([x, y], true));
    }

    fn quad_to(&mut self, cx0: f32, cy0: f32, x: f32, y: f32) {
        self.0.extend([([cx0, cy0], false), ([x, y], true)]);
    }

    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {
        panic!("a table glyf has no cubic curves");
    }

    fn close(&mut self) {}
}

/// In the font's own units, every point of the file is a point of the module, or the middle between two control points.
#[test]
fn points_and_metrics_are_those_of_the_file() {
    let font = FontRef::new(dejavu::sans::regular()).unwrap();
    let outlines = font.outline_glyphs();
    let (hmtx, charmap) = (font.hmtx().unwrap(), font.charmap());
    let found = converted(None);
    assert_eq!(found.units, font.head().unwrap().units_per_em());
    for glyph in &found.glyphs {
        let id = charmap.map(glyph.character).unwrap();
        let mut file = EveryPoint::default();
        let settings = DrawSettings::unhinted(instance::Size::unscaled(), LocationRef::default());
        outlines.get(id).unwrap().draw(settings, &mut file).unwrap();
        assert_eq!(glyph.advance, hmtx.advance(id).unwrap());
        let mut every = Vec::new();
        for contour in &glyph.contours {
            let next = contour.iter().cycle().skip(1);
            for (point, next) in contour.iter().zip(next) {
                let at = [f32::from(point.x), f32::from(point.y)];
                every.push((at, point.is_on_contour));
                if !point.is_on_contour && !next.is_on_contour {
                    every.push((
                        [(at[0] + f32::from(next.x)) / 2.0, (at[1] + f32::from(next.y)) / 2.0],
                        true,
                    ));
                }
            }
        }
        // The file's pen comes back to the first point of some contours.
        for point in &file.0 {
            assert!(every.contains(point), "{:?}: {point:?} is missing", glyph.character);
        }
        for point in &every {
            assert!(file.0.contains(point), "{:?}: {point:?} is too much", glyph.character);
        }
    }
    assert!(found.glyphs.len() == 23 && found.ascent >= 1_901 && found.descent >= 483);
}

/// Glyphs of the checked-in font in several sizes against exact areas of the file's own outlines, flattened by the converter in
/// floating point: curves of either are within 1/64 and 1/512 pixel, and their points are rounded to 1/256.
#[test]
fn text_is_the_area_of_the_outlines() {
    let source = Source::new(dejavu::sans::regular()).unwrap();
    let area = Rectangle::new(Point::new(-4, -60), Size::new(80, 80));
    let (mut sum, mut count) = (0.0, 0.0);
    for size in [9.0f32, 16.0, 24.25, 61.5] {
        for character in characters::parse(CHARACTERS).unwrap() {
            let contours = source.outline_of(character, size, Hinting::None).unwrap();
            let polygon = AntialiasedPolygon::<4_096, 512>::prepare(&contours, FillRule::NonZero).unwrap();
            let (mut expected, mut found) = (vec![0; 80 * 80], vec![0; 80 * 80]);
            let mut band = Band::<Gray8>::new(area, &mut expected).unwrap();
            polygon
                .draw(&InsideArea, Gray8::WHITE, &mut band, &mut [0; 81])
                .unwrap();
            let mut band = Band::<Gray8>::new(area, &mut found).unwrap();
            let style = OutlineTextStyle::new(&DEJAVU_SANS_OUTLINES, U24F8::from_num(size), Gray8::WHITE);
            // The row above row 0 is the last one above the baseline.
            let text = character.to_string();
            Text::new(&text, Point::new(0, -1), style)
                .draw_on(&mut band.antialiased::<1_024, 128>(&mut [0; 81]))
                .unwrap();
            for (point, (expected, found)) in area.points().zip(expected.iter().zip(&found)) {
                let off = expected.abs_diff(*found);
                assert!(off <= 8, "{character:?} at {size}, {point}: {found} for {expected}");
                if (1..255).contains(expected) {
                    (sum, count) = (sum + f64::from(off), count + 1.0);
                }
            }
        }
    }
    assert!(sum / count < 1.2, "{}", sum / count);
}
