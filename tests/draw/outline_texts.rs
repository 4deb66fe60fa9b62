//! Text in fonts of outlines: against exact areas, in bands of any height, by every way of drawing it, with metrics that enclose
//! it, and in memory that is too small.

use embedded_graphics::{
    geometry::AnchorPoint,
    pixelcolor::{Gray8, Rgb565},
    prelude::*,
    primitives::Rectangle,
    text::{Baseline, LineHeight, Text, renderer::TextRenderer},
};
use zrow::{
    band::Band,
    draw::{
        AntialiasedPolygon, AntialiasingMemory, DrawAntialiased, FillRule, Group, OutlineFont, OutlineGlyph,
        OutlineTextStyle, Picture, PictureSlot, PrimitiveStyle,
    },
    fixed::types::{U8F8, U24F8},
    geometry::{DrawError, InputError, Sub8, SubPoint, TooSmall, Window},
    scan::Bezier,
};

use crate::{
    common,
    reference::exact_area::{Contour, exact},
    text_area::{self, BASELINES, Recorder, check_metrics, cut, layout, recorded, with_bits},
};

/// "o" of two contours, of which the outer one has implied points and the inner one none; "A" with a bar that overlaps its legs;
/// "j" left of the pen, whose hook crosses itself; "%" of many small contours; "V", which is kerned with "A"; a space. 64 units are an em.
static FONT: OutlineFont = OutlineFont {
    units_per_em: 64,
    ranges: &[
        (' ', 1, 5),
        ('%', 1, 3),
        ('A', 1, 1),
        ('V', 1, 4),
        ('j', 1, 2),
        ('o', 1, 0),
    ],
    glyphs: &[
        glyph((0, 14), 40, [3, -1, 37, 33]),
        glyph((14, 10), 44, [0, 0, 44, 46]),
        glyph((24, 7), 18, [-8, -14, 13, 34]),
        glyph((31, 20), 60, [2, 0, 58, 46]),
        glyph((51, 7), 43, [0, 0, 43, 46]),
        glyph((58, 0), 20, [0, 0, 0, 0]),
    ],
    #[rustfmt::skip]
    small_points: &[
        // o: the outer contour, and the inner one the other way.
        [3, 16], [3, 33], [37, 33], [37, -1], [3, -1],
        [10, 16], [10, 5], [20, 5], [30, 5], [30, 16], [30, 27], [20, 27], [12, 26], [10, 20],
        // A
        [0, 0], [19, 46], [26, 46], [44, 0], [36, 0], [22, 38], [8, 0],
        [8, 12], [36, 12], [30, 19],
        // j
        [13, 34], [6, 34], [6, -4], [5, -10], [-8, -9], [-8, -14], [13, -12],
        // %
        [2, 40], [8, 46], [14, 40], [8, 34],
        [46, 6], [52, 12], [58, 6], [52, 0],
        [50, 46], [56, 46], [10, 0], [4, 0],
        [20, 20], [20, 30], [30, 30], [30, 20],
        [22, 22], [28, 22], [28, 28], [22, 28],
        // V
        [0, 46], [8, 46], [22, 8], [35, 46], [43, 46], [26, 0], [18, 0],
    ],
    points: &[],
    flags: &FLAGS,
    crossing: &[1, 2, 3],
    kerning: &[(1, 4, -7), (4, 1, -6)],
    ascent: 48,
    descent: 14,
    line_height: 75,
    underline: (5, 4),
    strikethrough: (-20, 3),
    replacement: None,
};

const fn glyph((first, points): (u32, u16), advance: u16, [left, bottom, right, top]: [i16; 4]) -> OutlineGlyph {
    OutlineGlyph {
        first,
        points,
        advance,
        left,
        bottom,
        right,
        top,
    }
}

/// `.` for a control point, `o` for a point on the contour; `C` and `O` for the last one of a contour.
const POINTS: &[u8] = b"o...Co.o.o.o.CooooooOooOooo.ooCo.oCo.oCoooOoooOoooOooooooO";

static FLAGS: [u8; 15] = {
    let mut flags = [0; 15];
    let mut index = 0;
    while index < POINTS.len() {
        let bits = match POINTS[index] {
            b'.' => 0,
            b'o' => 1,
            b'C' => 2,
            _ => 3,
        };
        flags[index / 4] |= bits << (2 * (index % 4));
        index += 1;
    }
    flags
};

const EDGES: usize = 512;
const ACTIVE: usize = 128;

pub type OutlineText<'t> = Text<'t, OutlineTextStyle<Rgb565>>;

/// A style by bits: with text, with a background, underlined, struck through. The size is in 1/256 pixel.
pub fn style(font: &'static OutlineFont, size: u32, bits: u8) -> OutlineTextStyle<Rgb565> {
    with_bits(
        OutlineTextStyle::new(font, U24F8::from_bits(size), Rgb565::YELLOW),
        bits,
    )
}

fn draw_on(text: &OutlineText<'_>, band: &mut Band<'_, Rgb565>) {
    let mut cells = [0; 256];
    text.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut cells))
        .unwrap();
    assert_eq!(cells, [0; 256]);
}

/// Draws on a band over a pattern of colours.
fn on_pattern(window: Rectangle, text: &OutlineText<'_>) -> Vec<Rgb565> {
    text_area::on_pattern(window, |band| draw_on(text, band))
}

/// Draws a prepared picture of the text in bands of this height, from the last one up and then from the first one down.
fn prepared(window: Rectangle, height: u32, text: &OutlineText<'_>) -> [Vec<Rgb565>; 2] {
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 96], [0; 40]);
    let mut memory = AntialiasingMemory::<40, ACTIVE, 1>::new();
    let mut picture =
        Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
    picture.add(text).unwrap();
    text_area::prepared(window, height, &mut picture)
}

/// Font units in 1/256 pixel at a size in 1/256 pixel, rounded to the nearest. The units are doubled.
fn scaled(doubled: i32, size: i32) -> i32 {
    (doubled * size + 64).div_euclid(128)
}

/// The contours of a glyph, flattened, by a reading of the format that is written for this test: every contour becomes a list of
/// curves and lines first. `origin` is where the pen and the baseline are, in 1/256 pixel from the centre of pixel (0, 0).
fn contours_of(glyph: &OutlineGlyph, size: i32, origin: (i32, i32)) -> Vec<Contour> {
    let (first, end) = (glyph.first as usize, glyph.first as usize + usize::from(glyph.points));
    let kinds = POINTS[first..end].split_inclusive(|kind| matches!(kind, b'C' | b'O'));
    let mut points = FONT.small_points[first..end]
        .iter()
        .map(|&[x, y]| [2 * i32::from(x), 2 * i32::from(y)]);
    let at = |[x, y]: [i32; 2]| {
        let (x, y) = (origin.0 + scaled(x, size), origin.1 - scaled(y, size));
        SubPoint::<Sub8>::from_units(x, y).unwrap()
    };
    kinds
        .map(|kinds| {
            // Points on the contour and control points by turns, with none where a line is.
            let mut explicit: Vec<([i32; 2], bool)> = Vec::new();
            for (kind, point) in kinds.iter().zip(points.by_ref()) {
                let is_on = matches!(kind, b'o' | b'O');
                if let (Some(&(before, false)), false) = (explicit.last(), is_on) {
                    explicit.push(([0, 1].map(|axis| (before[axis] + point[axis]) / 2), true));
                }
                explicit.push((point, is_on));
            }
            explicit.push(explicit[0]);
            let mut contour = vec![at(explicit[0].0)];
            let mut index = 1;
            while let Some(&(point, is_on)) = explicit.get(index) {
                if is_on {
                    contour.push(at(point));
                    index += 1;
                } else {
                    let curve = Bezier::new([*contour.last().unwrap(), at(point), at(explicit[index + 1].0)]).unwrap();
                    contour.extend(curve.de_casteljau(U8F8::from_bits(4)));
                    index += 2;
                }
            }
            contour.iter().map(|point| (point.x_units(), point.y_units())).collect()
        })
        .collect()
}

/// How many lines of a contour have a part in a pixel, or in the box around them.
fn lines_in(contour: &Contour, pixel: Point) -> usize {
    let next = contour.iter().cycle().skip(1);
    let lines = contour.iter().zip(next).filter(|(from, to)| {
        let meets =
            |from: i32, to: i32, pixel: i32| from.min(to) <= 256 * pixel + 128 && 256 * pixel - 128 <= from.max(to);
        meets(from.0, to.0, pixel.x) && meets(from.1, to.1, pixel.y)
    });
    lines.count()
}

/// Each pixel of each glyph against the area of its outline, at the pen of a glyph that follows another one.
#[test]
fn coverage_is_the_exact_area() {
    let area = Rectangle::new(Point::new(-7, -4), Size::new(64, 64));
    for size in [256, 5 * 256 + 77, 12 * 256, 20 * 256 + 64, 35 * 256 + 201, 70 * 256] {
        let (mut off, mut pixels) = (0.0, 0.0);
        for (character, index) in [('o', 0), ('A', 1), ('j', 2), ('%', 3), ('V', 4)] {
            let (line, baseline) = (5, 40);
            let text = format!("V{character}");
            let style = OutlineTextStyle::new(&FONT, U24F8::from_bits(size), Gray8::WHITE);
            let (mut words, mut cells) = (vec![0; 64 * 64], [0; 65]);
            let mut band = Band::<Gray8>::new(area, &mut words).unwrap();
            let text = Text::new(&text, Point::new(line, baseline), style);
            text.draw_on(&mut band.antialiased::<EDGES, ACTIVE>(&mut cells))
                .unwrap();
            let step = FONT.glyphs[4].advance as i32 + if character == 'A' { -6 } else { 0 };
            let (x, y) = (256 * line - 128, 256 * baseline + 128);
            let size = size as i32;
            let glyphs = [(4, 0), (index, step)];
            let contours =
                glyphs.map(|(index, pen)| contours_of(&FONT.glyphs[index], size, (x + scaled(2 * pen, size), y)));
            let areas = contours
                .each_ref()
                .map(|contours| exact(contours, FillRule::NonZero, &area.into()));
            for (((first, second), found), point) in areas[0].iter().zip(&areas[1]).zip(&words).zip(area.points()) {
                // The right glyph is blended over the left one.
                let expected = 255.0 * (first + second * (1.0 - first));
                let error = (f64::from(*found) - expected).abs();
                // The height at which a line passes from pixel to pixel is rounded to 1/16,384, which is 1/64 of a 255th.
                let lines = contours
                    .iter()
                    .flatten()
                    .map(|contour| lines_in(contour, point))
                    .sum::<usize>();
                let bound = if second * first == 0.0 { 0.52 } else { 1.1 } + lines as f64 / 64.0;
                assert!(error <= bound, "{character} at {size}, {point}: {found} for {expected}");
                if 0.0 < expected && expected < 255.0 {
                    (off, pixels) = (off + error * error, pixels + 1.0);
                }
            }
        }
        assert!(
            f64::sqrt(off / pixels) < 0.35,
            "{size}: {} in the mean",
            f64::sqrt(off / pixels)
        );
    }
}

const TEXTS: [&str; 5] = ["oA", "VAV jo", "AV%\no j\r\n\nV", "", "%\u{65e5}jA o"];

#[test]
fn bands_of_any_height_hold_the_whole_picture() {
    let window = Rectangle::new(Point::new(-5, 3), Size::new(83, 61));
    for (number, text) in TEXTS.iter().enumerate() {
        for bits in 0..16 {
            let layout = layout(number + usize::from(bits), usize::from(bits), LineHeight::Percent(90));
            let position = window.anchor_point(AnchorPoint::Center) - Point::new(9, 8);
            let size = 12 * 256 + 701 * u32::from(bits);
            let text = Text::with_text_style(text, position, style(&FONT, size, bits), layout);
            let whole = on_pattern(window, &text);
            for height in [1, 2, 7, 60] {
                let found = text_area::in_bands(window, height, true, |band| draw_on(&text, band));
                assert_eq!(found, whole, "{text:?} in bands of {height}");
                for drawn in prepared(window, height, &text) {
                    assert_eq!(drawn, whole, "{text:?} prepared, in bands of {height}");
                }
            }
            let part = Rectangle::new(Point::new(17, 20), Size::new(19, 11));
            assert_eq!(on_pattern(part, &text), cut(&whole, window, part), "{text:?}");
        }
    }
}

/// With a background, embedded-graphics' `draw` mixes against it what the band mixes with what it holds: the same colours
/// where no glyphs overlap.
#[test]
fn every_target_gets_what_a_band_gets() {
    let window = Rectangle::new(Point::zero(), Size::new(150, 70));
    for (number, text) in ["oo", "o%", "oV o\no"].into_iter().enumerate() {
        for bits in [3, 7, 11, 15, 2] {
            let layout = layout(number, 3, LineHeight::Percent(100));
            let text = Text::with_text_style(text, Point::new(78, 30), style(&FONT, 6_100, bits), layout);
            assert_eq!(recorded(window, &text).0, on_pattern(window, &text), "{text:?}");
        }
    }
}

#[test]
fn metrics_enclose_what_is_drawn() {
    for text in ["jAVA", "o", "%%", "", " ", "oj"] {
        for bits in [1, 5, 9] {
            for (baseline, size) in BASELINES.into_iter().zip([2_222, 3_000, 3_001, 4_567]) {
                check_metrics(text, style(&FONT, size, bits), baseline, &on_pattern);
            }
        }
    }
    let style = style(&FONT, 32 * 256, 1);
    let width = |text: &str| style.measure_string(text, Point::zero(), Baseline::Top).next_position.x;
    // 37.5 rows, and 43 + 44 - 6 half pixels: rounded once.
    assert_eq!(
        (style.line_height(), width("VA"), width("V"), width("A")),
        (38, 41, 22, 22)
    );
    let metrics = style.measure_string("j", Point::new(9, 50), Baseline::Alphabetic);
    assert_eq!(
        metrics.bounding_box,
        Rectangle::new(Point::new(5, 27), Size::new(13, 31))
    );
}

#[test]
fn whitespace_has_the_background_and_the_decorations() {
    let window = Rectangle::new(Point::zero(), Size::new(30, 40));
    let style = style(&FONT, 16 * 256, 14);
    let mut recorder = Recorder {
        area: window,
        colors: vec![Rgb565::BLACK; 30 * 40],
    };
    let Ok(next) = style.draw_whitespace(9, Point::new(4, 20), Baseline::Alphabetic, &mut recorder);
    assert_eq!(next, Point::new(13, 20));
    for (point, color) in window.points().zip(recorder.colors) {
        // 12 rows above the baseline and 3.5 below, a strikethrough of 0.75 rows from 5 rows above the baseline on.
        let expected = match (point.x, point.y) {
            (4..13, 16) => Rgb565::GREEN,
            (4..13, 9..25) => Rgb565::BLUE,
            _ => Rgb565::BLACK,
        };
        assert_eq!(color, expected, "{point}");
    }
}

/// Memory that is too small is an error that says how much would do for all glyphs, and a text too far out one of the domain.
#[test]
fn what_does_not_fit_says_what_would() {
    let window = Rectangle::new(Point::zero(), Size::new(120, 40));
    let mut words = vec![0; 120 * 40];
    let mut band = Band::<Rgb565>::new(window, &mut words).unwrap();
    let mut cells = [0; 121];
    /// The most edges that one of the glyphs has in a row.
    const SEGMENTS: usize = 20;
    /// Those that "%" has, whose contours cross: a picture needs memory for no others.
    const CROSSING_SEGMENTS: usize = 18;
    let text = Text::new("Vo%", Point::new(2, 30), style(&FONT, 24 * 256, 1));
    let error = text.draw_on(&mut band.antialiased::<8, 8>(&mut cells));
    assert_eq!(error, Err(DrawError::TooSmall(TooSmall::Edges(124))));
    let error = text.draw_on(&mut band.antialiased::<124, 3>(&mut cells));
    assert_eq!(error, Err(DrawError::TooSmall(TooSmall::ActiveEdges(SEGMENTS))));
    assert_eq!(text.draw_on(&mut band.antialiased::<124, SEGMENTS>(&mut cells)), Ok(()));
    let error = text.draw_on(&mut band.antialiased::<124, SEGMENTS>(&mut cells[..120]));
    assert_eq!(error, Err(DrawError::TooSmall(TooSmall::Cells(121))));

    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 16]);
    let mut memory = AntialiasingMemory::<121, { CROSSING_SEGMENTS - 1 }, 0>::new();
    let mut picture = Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
    let error = InputError::TooSmall(TooSmall::Segments(CROSSING_SEGMENTS));
    assert_eq!(picture.add(&text), Err(error));
    let far = Text::new("Vo", Point::new(8_170, 30), style(&FONT, 24 * 256, 1));
    assert_eq!(
        picture.add(&far),
        Err(InputError::OutOfDomain { min: -8191, max: 8191 })
    );
    assert_eq!(picture.slots_used(), 0);
    // Scale, colours, four words of the line and one for each glyph.
    picture
        .add(&Text::new("VVV", Point::new(2, 30), style(&FONT, 24 * 256, 1)))
        .unwrap();
    assert_eq!(picture.words_used(), 1 + 1 + 4 + 3);
}

/// A text whose glyphs do not cross themselves needs cells alone, and is no item where there are none.
#[test]
fn simple_glyphs_need_cells_alone() {
    fn shown<const CELLS: usize, const SEGMENTS: usize>() -> Result<Vec<u16>, InputError> {
        let window = Rectangle::new(Point::zero(), Size::new(60, 40));
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 16]);
        let mut memory = AntialiasingMemory::<CELLS, SEGMENTS, 0>::new();
        let mut picture = Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
        picture.add(&Text::new("VoV", Point::new(2, 30), style(&FONT, 24 * 256, 1)))?;
        let mut words = vec![0; 60 * 40];
        picture.draw(&mut Band::<Rgb565>::new(window, &mut words)?);
        Ok(words)
    }
    let expected = shown::<61, 64>().unwrap();
    assert!(expected.iter().any(|word| *word > 0));
    assert_eq!(shown::<61, 0>().as_ref(), Ok(&expected));
    assert_eq!(shown::<2, 0>().as_ref(), Ok(&expected));
    assert_eq!(shown::<1, 64>(), Err(InputError::TooSmall(TooSmall::PictureCells(2))));
}

/// A text as one outline, in bands of any height from the last one up and from the first one down, and as the clip path of a
/// group: where no two glyphs overlap, it is the text.
#[test]
fn the_outline_of_a_text_is_the_text() {
    let window = Rectangle::new(Point::new(-5, 3), Size::new(83, 61));
    for (number, text) in ["oo V", "V\no o", "%  j", ""].into_iter().enumerate() {
        for size in [3_077, 5_555, 2_816] {
            let layout = layout(number, number + size as usize, LineHeight::Percent(110));
            let position = window.anchor_point(AnchorPoint::Center) - Point::new(9, 8);
            let text = Text::with_text_style(text, position, style(&FONT, size, 1), layout);
            let expected = on_pattern(window, &text);
            let polygon = AntialiasedPolygon::<EDGES, ACTIVE>::prepare(&text, FillRule::NonZero).unwrap();
            let drawn = text_area::on_pattern(window, |band| {
                let method = polygon.exact_method(&text);
                polygon.draw(&method, Rgb565::YELLOW, band, &mut [0; 84]).unwrap();
            });
            assert!(drawn == expected, "{:?}, {size}", text.text);

            let (mut slots, mut pool, mut kept, mut buckets) = ([PictureSlot::EMPTY; 4], [0; 400], [0; 83], [0; 61]);
            let mut memory = AntialiasingMemory::<40, ACTIVE, 40>::new();
            let mut picture = Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut buckets)
                .with_antialiasing(&mut memory)
                .with_group_rows(&mut kept);
            let id = picture.add_outline(&text, FillRule::NonZero, Rgb565::YELLOW).unwrap();
            for height in [1, 4, 61] {
                for drawn in text_area::prepared(window, height, &mut picture) {
                    assert!(drawn == expected, "{:?}, {size}, bands of {height}", text.text);
                }
            }
            picture.remove(id);
            picture
                .begin_path_group(Group::new(), &text, FillRule::NonZero)
                .unwrap();
            picture
                .add(&window.into_styled(PrimitiveStyle::with_fill(Rgb565::YELLOW)))
                .unwrap();
            picture.end_group().unwrap();
            let [clipped, _] = text_area::prepared(window, 1, &mut picture);
            assert!(clipped == expected, "{:?}, {size}, as a clip path", text.text);
        }
    }
}

/// Glyphs that overlap are one shape: its coverage is the area of their union.
#[test]
fn glyphs_that_overlap_are_one_outline() {
    let area = Rectangle::new(Point::zero(), Size::new(80, 64));
    let size = 35 * 256 + 201;
    let style = OutlineTextStyle::new(&FONT, U24F8::from_bits(size), Gray8::WHITE);
    let text = Text::with_text_style("o\nV", Point::new(9, 40), style, layout(0, 3, LineHeight::Pixels(7)));
    let polygon = AntialiasedPolygon::<EDGES, ACTIVE>::prepare(&text, FillRule::NonZero).unwrap();
    let mut words = vec![0; 80 * 64];
    let mut band = Band::<Gray8>::new(area, &mut words).unwrap();
    let method = polygon.exact_method(&text);
    polygon.draw(&method, Gray8::WHITE, &mut band, &mut [0; 81]).unwrap();
    let (x, y) = (256 * 9 - 128, 256 * 40 + 128);
    let [o, v] = [(0, y), (4, y + 256 * 7)].map(|(index, y)| contours_of(&FONT.glyphs[index], size as i32, (x, y)));
    let [each_o, each_v] = [&o, &v].map(|contours| exact(contours, FillRule::NonZero, &area.into()));
    let overlap = each_o.iter().zip(&each_v).filter(|(o, v)| **o + **v > 1.0).count();
    assert!(overlap > 20, "{overlap}");
    let contours = [o, v].concat();
    let areas = exact(&contours, FillRule::NonZero, &area.into());
    for ((expected, found), point) in areas.iter().zip(&words).zip(area.points()) {
        let lines: usize = contours.iter().map(|contour| lines_in(contour, point)).sum();
        let error = (f64::from(*found) - 255.0 * expected).abs();
        assert!(
            error <= 0.52 + lines as f64 / 64.0,
            "{point}: {found} for {}",
            255.0 * expected
        );
    }
}

/// A text too far out has no outline.
#[test]
fn the_outline_of_a_text_beyond_the_domain_is_an_error() {
    let far = Text::new("Vo", Point::new(8_170, 30), style(&FONT, 24 * 256, 1));
    let prepared = AntialiasedPolygon::<EDGES, ACTIVE>::prepare(&far, FillRule::NonZero);
    assert_eq!(prepared.err(), Some(InputError::OutOfDomain { min: -8191, max: 8191 }));
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 400]);
    let mut memory = AntialiasingMemory::<40, ACTIVE, 1>::new();
    let window = Rectangle::new(Point::zero(), Size::new(120, 40));
    let mut picture = Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
    let added = picture.add_outline(&far, FillRule::NonZero, Rgb565::RED);
    assert_eq!(added.err(), Some(InputError::OutOfDomain { min: -8191, max: 8191 }));
    assert_eq!(picture.words_used(), 0);
}

/// A text of which one takes another's place, and one that is moved: what has changed is the box of both, and the picture is that
/// of the texts as they are.
#[test]
fn texts_in_a_picture_are_replaced_and_moved() {
    let window = Rectangle::new(Point::zero(), Size::new(100, 60));
    let text = |text: &'static str, x: i32, y: i32| Text::new(text, Point::new(x, y), style(&FONT, 5_555, 1));
    let (mut slots, mut pool, mut areas) = ([PictureSlot::EMPTY; 2], [0; 32], [Window::EMPTY; 8]);
    let mut memory = AntialiasingMemory::<101, ACTIVE, 1>::new();
    let mut picture = Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut [])
        .with_damage(&mut areas, (1, 1))
        .with_antialiasing(&mut memory);
    let changing = picture.add(&text("oVo", 8, 25)).unwrap();
    let moved = picture.add(&text("jA", 9, 52)).unwrap();
    picture.clear_damage();
    picture.replace(changing, &text("o%o", 8, 25)).unwrap();
    picture.translate(moved, Point::new(13, -2)).unwrap();
    let mut damage = Vec::new();
    while let Some(area) = picture.next_damage() {
        damage.push(area);
    }
    let draw =
        |texts: &[OutlineText<'_>]| common::picture(window, |band| texts.iter().for_each(|text| draw_on(text, band)));
    let before = draw(&[text("oVo", 8, 25), text("jA", 9, 52)]);
    let after = draw(&[text("o%o", 8, 25), text("jA", 22, 50)]);
    assert_eq!(common::picture(window, |band| picture.draw(band)), after);
    for (point, (before, after)) in window.points().zip(before.iter().zip(&after)) {
        assert!(
            before == after || damage.iter().any(|area| area.contains(point)),
            "{point}"
        );
    }
    let sent: u32 = damage.iter().map(|area| area.size.width * area.size.height).sum();
    assert!(sent < 100 * 60 * 2 / 3, "{damage:?}");
    let far = picture.translate(moved, Point::new(8_150, 0));
    assert_eq!(far, Err(InputError::OutOfDomain { min: -8190, max: 8190 }));
}

/// A font whose pen moves on by 2^24 pixels behind a space at the largest size.
static FAR_FONT: OutlineFont = OutlineFont {
    units_per_em: 1,
    ranges: &[(' ', 1, 0)],
    glyphs: &[glyph((0, 0), i16::MAX as u16, [0, 0, 0, 0])],
    ascent: 1,
    descent: 0,
    ..FONT
};

/// The row 0 of a band of a picture that holds a text of so many spaces with a background, drawn where the picture's area begins.
fn row_of_spaces(area: Rectangle, left: i32, spaces: usize) -> [u16; 8] {
    let spaces = " ".repeat(spaces);
    let style = OutlineTextStyle::new(&FAR_FONT, U24F8::from_num(16_384), Rgb565::YELLOW).on_background(Rgb565::BLUE);
    let text = Text::with_baseline(&spaces, Point::new(left, 0), style, Baseline::Top);
    let (mut slots, mut pool, mut areas) = ([PictureSlot::EMPTY; 1], [0; 128], [Window::EMPTY; 2]);
    let mut memory = AntialiasingMemory::<9, 1, 1>::new();
    let mut picture = Picture::<Rgb565>::new(area, &mut slots, &mut pool, &mut [])
        .with_antialiasing(&mut memory)
        .with_damage(&mut areas, (1, 1));
    picture.add(&text).unwrap();
    // Whatever has changed is made ready to be drawn with its first columns.
    assert_eq!(picture.next_damage(), Some(area));
    let mut words = [0; 8];
    picture.draw(&mut Band::new(Rectangle::new(area.top_left, Size::new(8, 1)), &mut words).unwrap());
    words
}

/// From the band's first column to the background's last one there are more columns than 31 bits tell.
#[test]
fn a_band_far_left_of_a_long_background_shows_nothing() {
    let left = -(1 << 30);
    let area = Rectangle::new(Point::new(left, 0), Size::new((1 << 30) + 100, 1));
    assert_eq!(row_of_spaces(area, 0, 70), [0; 8]);
}

/// A line that begins farther to the left than a picture keeps: its background reaches as far as it does without a picture.
#[test]
fn the_background_of_a_line_from_far_left_ends_where_it_should() {
    let area = Rectangle::new(Point::new(580, 0), Size::new(8, 1));
    let blue = Rgb565::BLUE.into_storage();
    // 96 spaces of 16,776,704 pixels.
    assert_eq!(
        row_of_spaces(area, -1_610_563_000, 96),
        [blue, blue, blue, blue, 0, 0, 0, 0]
    );
}
