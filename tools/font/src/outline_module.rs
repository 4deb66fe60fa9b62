//! The Rust module of a font of outlines, formatted as rustfmt would.

use std::fmt::Write;

use crate::{
    crossing::cross_or_overlap,
    module_parts::{self, Origin, grouped, plain, quoted},
    outlines::{OutlineOptions, Outlines},
    quadratics::Point,
};

/// Columns of the lines of points at most.
const COLUMNS: usize = 100;

/// A module, and how many bytes of flash its tables take.
#[derive(Debug, Clone)]
pub struct OutlineModule {
    /// The Rust source.
    pub source: String,
    /// How many points the outlines have.
    pub points: usize,
    /// Bytes of the points and their flags.
    pub point_bytes: usize,
    /// Bytes of all tables.
    pub bytes: usize,
}

/// The name of a font's `static`, such as `DEJAVU_SANS_OUTLINES`.
pub fn static_name(family: &str) -> String {
    module_parts::name_of(&format!("{family} outlines"))
}

/// Writes a font as a module with a `static` of that name.
pub fn write(font: &Outlines, options: &OutlineOptions, name: &str, origin: Origin<'_>) -> OutlineModule {
    let ranges = module_parts::ranges(font.glyphs.iter().map(|glyph| glyph.character));
    let points: usize = font.glyphs.iter().map(|glyph| glyph.points().count()).sum();
    let flags = flags(font);
    let point_bytes = points * if is_small(font) { 2 } else { 4 } + flags.len();
    let bytes =
        point_bytes + 16 * font.glyphs.len() + 2 * crossing(font).len() + 6 * font.kerning.len() + 8 * ranges.len();
    let mut source = head(font, options, origin, bytes);
    // Writing to a string does not fail.
    let _ = write_font(&mut source, font, options, name);
    let _ = module_parts::write_ranges(&mut source, &ranges);
    let _ = write_glyphs(&mut source, font);
    let _ = module_parts::write_kerning(&mut source, &font.kerning);
    let _ = write_points(&mut source, font, points);
    let _ = write_flags(&mut source, &flags);
    OutlineModule {
        source,
        points,
        point_bytes,
        bytes,
    }
}

/// Whether all points fit 8 bits.
fn is_small(font: &Outlines) -> bool {
    let fits = |number: i16| i8::try_from(number).is_ok();
    let mut points = font.glyphs.iter().flat_map(|glyph| glyph.points());
    points.all(|point| fits(point.x) && fits(point.y))
}

/// The indices of glyphs whose contours cross, overlap or touch.
fn crossing(font: &Outlines) -> Vec<usize> {
    let glyphs = font.glyphs.iter().enumerate();
    let crossing = glyphs.filter(|(_, glyph)| cross_or_overlap(&glyph.contours));
    crossing.map(|(index, _)| index).collect()
}

/// Two bits a point.
fn flags(font: &Outlines) -> Vec<u8> {
    let contours = font.glyphs.iter().flat_map(|glyph| &glyph.contours);
    let flags: Vec<u8> = contours
        .flat_map(|contour| {
            let last = contour.len() - 1;
            let flags =
                move |(index, point): (usize, &Point)| u8::from(point.is_on_contour) | u8::from(index == last) << 1;
            contour.iter().enumerate().map(flags)
        })
        .collect();
    let byte = |four: &[u8]| four.iter().rev().fold(0, |byte, flags| byte << 2 | flags);
    flags.chunks(4).map(byte).collect()
}

fn head(font: &Outlines, options: &OutlineOptions, origin: Origin<'_>, bytes: usize) -> String {
    let title = format!(
        "{}: outlines of {} characters, {} units an em, {} bytes of flash.",
        module_parts::title(&font.names),
        font.glyphs.len(),
        grouped(font.units.into()),
        grouped(bytes)
    );
    let mut arguments = "--outlines".to_owned();
    if let Some(units) = options.units {
        let _ = write!(arguments, " --units {units}");
    }
    let _ = write!(arguments, " --chars {}", quoted(origin.characters));
    module_parts::add_choices(&mut arguments, options.kerning, options.replacement);
    module_parts::head(&font.names, &title, origin, &arguments)
}

fn write_font(to: &mut String, font: &Outlines, options: &OutlineOptions, name: &str) -> std::fmt::Result {
    let kerning = if font.kerning.is_empty() { "&[]" } else { "&KERNING" };
    let (small, large) = if is_small(font) {
        ("&POINTS", "&[]")
    } else {
        ("&[]", "&POINTS")
    };
    writeln!(to, "use zrow::draw::{{OutlineFont, OutlineGlyph}};\n")?;
    writeln!(to, "/// {} in any size.", plain(&font.names.family))?;
    writeln!(to, "pub static {name}: OutlineFont = OutlineFont {{")?;
    writeln!(to, "    units_per_em: {},", font.units)?;
    writeln!(to, "    ranges: &RANGES,\n    glyphs: &GLYPHS,")?;
    writeln!(
        to,
        "    small_points: {small},\n    points: {large},\n    flags: &FLAGS,"
    )?;
    writeln!(to, "    crossing: &{:?},", crossing(font))?;
    writeln!(to, "    kerning: {kerning},")?;
    writeln!(to, "    ascent: {},\n    descent: {},", font.ascent, font.descent)?;
    writeln!(to, "    line_height: {},", font.line_height)?;
    writeln!(to, "    underline: {:?},", font.underline)?;
    writeln!(to, "    strikethrough: {:?},", font.strikethrough)?;
    let index = |replacement| font.glyphs.iter().position(|glyph| glyph.character == replacement);
    module_parts::write_replacement(to, options.replacement.and_then(index))
}

fn write_glyphs(to: &mut String, font: &Outlines) -> std::fmt::Result {
    writeln!(
        to,
        "\n#[rustfmt::skip]\nstatic GLYPHS: [OutlineGlyph; {}] = [",
        font.glyphs.len()
    )?;
    let mut first = 0;
    for glyph in &font.glyphs {
        let ([left, bottom, right, top], points) = (glyph.bounds(), glyph.points().count());
        writeln!(
            to,
            "    OutlineGlyph {{ first: {first}, points: {points}, advance: {}, left: {left}, bottom: {bottom}, right: {right}, top: {top} }}, // {:?}",
            glyph.advance, glyph.character
        )?;
        first += points;
    }
    writeln!(to, "];")
}

fn write_points(to: &mut String, font: &Outlines, points: usize) -> std::fmt::Result {
    let number = if is_small(font) { "i8" } else { "i16" };
    writeln!(to, "\n#[rustfmt::skip]\nstatic POINTS: [[{number}; 2]; {points}] = [")?;
    for glyph in &font.glyphs {
        if !glyph.contours.is_empty() {
            writeln!(to, "    // {:?}", glyph.character)?;
        }
        for contour in &glyph.contours {
            write_lines(to, contour.iter().map(|point| format!("[{}, {}],", point.x, point.y)))?;
        }
    }
    writeln!(to, "];")
}

fn write_flags(to: &mut String, flags: &[u8]) -> std::fmt::Result {
    writeln!(to, "\n#[rustfmt::skip]\nstatic FLAGS: [u8; {}] = [", flags.len())?;
    write_lines(to, flags.iter().map(|byte| format!("0x{byte:02x},")))?;
    writeln!(to, "];")
}

/// Writes entries in lines of up to [`COLUMNS`] columns.
fn write_lines(to: &mut String, entries: impl Iterator<Item = String>) -> std::fmt::Result {
    let mut columns = 0;
    for entry in entries {
        if columns > 0 && columns + 1 + entry.len() <= COLUMNS {
            write!(to, " {entry}")?;
            columns += 1 + entry.len();
        } else {
            write!(to, "{}    {entry}", if columns > 0 { "\n" } else { "" })?;
            columns = 4 + entry.len();
        }
    }
    writeln!(to)
}
