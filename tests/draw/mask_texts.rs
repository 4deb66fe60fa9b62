//! Text in fonts of coverage masks: in bands of any height, by every way of drawing it, with metrics that enclose it, and
//! with fonts and positions of any numbers.

use embedded_graphics::{
    geometry::AnchorPoint,
    mono_font::DecorationDimensions,
    pixelcolor::{Gray8, Rgb565},
    prelude::*,
    primitives::Rectangle,
    text::{Baseline, LineHeight, Text, renderer::TextRenderer},
};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{BlendOn, MaskFont, MaskGlyph, MaskTextStyle, Picture, PictureSlot},
    geometry::Window,
    shade::ChannelColor,
};
use zrow_scenes::fonts::{DEJAVU_SANS_16, DEJAVU_SANS_24};

use crate::{
    common::{cases, config, numbers::any_number, picture},
    text_area::{self, BASELINES, Recorder, below, check_metrics, cut, layout, recorded, with_bits},
};

const FONTS: [&MaskFont; 2] = [&DEJAVU_SANS_16, &DEJAVU_SANS_24];

/// A style by bits: with text, with a background, underlined, struck through.
fn style(font: &'static MaskFont, bits: u8) -> MaskTextStyle<Rgb565> {
    with_bits(MaskTextStyle::new(font, Rgb565::YELLOW), bits)
}

type MaskText<'t> = Text<'t, MaskTextStyle<Rgb565>>;

/// Draws on a band over a pattern of colours.
fn on_pattern(window: Rectangle, text: &MaskText<'_>) -> Vec<Rgb565> {
    text_area::on_pattern(window, |band| {
        let Ok(()) = text.draw_on(band);
    })
}

/// Draws in bands of this height, from the last one up.
fn in_bands(window: Rectangle, height: u32, text: &MaskText<'_>) -> Vec<Rgb565> {
    text_area::in_bands(window, height, true, |band| {
        let Ok(()) = text.draw_on(band);
    })
}

/// Draws a prepared picture of the text in bands of this height, from the last one up and then from the first one down.
fn prepared(window: Rectangle, height: u32, text: &MaskText<'_>) -> [Vec<Rgb565>; 2] {
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 64], [0; 40]);
    let mut picture = Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut buckets);
    picture.add(text).unwrap();
    text_area::prepared(window, height, &mut picture)
}

const TEXTS: [&str; 5] = ["12:34", "-7.5 \u{b0}C", "AVATAR\nTo. Ye\r\n\nj", "", "gy\u{65e5}% k/h"];

#[test]
fn bands_of_any_height_hold_the_whole_picture() {
    let window = Rectangle::new(Point::new(-5, 3), Size::new(83, 61));
    for (number, text) in TEXTS.iter().enumerate() {
        for bits in 0..16 {
            let font = FONTS[number % 2];
            let layout = layout(number + usize::from(bits), usize::from(bits), LineHeight::Percent(90));
            let position = window.anchor_point(AnchorPoint::Center) - Point::new(9, 8);
            let text = Text::with_text_style(text, position, style(font, bits), layout);
            let whole = on_pattern(window, &text);
            for height in [1, 2, 7, 60] {
                assert_eq!(in_bands(window, height, &text), whole, "{text:?} in bands of {height}");
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
    let window = Rectangle::new(Point::zero(), Size::new(120, 70));
    for (number, text) in ["12:34", "-7.5 \u{b0}C", "42 km/h\n100 %"].into_iter().enumerate() {
        for bits in [3, 7, 11, 15, 2] {
            let layout = layout(number, 3, LineHeight::Percent(100));
            let text = Text::with_text_style(text, Point::new(58, 30), style(&DEJAVU_SANS_24, bits), layout);
            assert_eq!(recorded(window, &text).0, on_pattern(window, &text), "{text:?}");
        }
    }
}

/// Without a background nothing but the text's colour can be drawn, where the band has it to half at least.
#[test]
fn without_a_background_pixels_are_drawn_that_are_covered_to_half() {
    let window = Rectangle::new(Point::zero(), Size::new(120, 40));
    let text = Text::new("AVo 4.", Point::new(3, 25), style(&DEJAVU_SANS_16, 1));
    let mut words = [0; 120 * 40];
    let mut band = Band::<Gray8>::new(window, &mut words).unwrap();
    let style = MaskTextStyle::new(&DEJAVU_SANS_16, Gray8::WHITE);
    let Ok(()) = Text::new(text.text, text.position, style).draw_on(&mut band);
    let covered = |(point, coverage)| if coverage >= 128 { Rgb565::YELLOW } else { below(point) };
    let expected: Vec<Rgb565> = window.points().zip(words).map(covered).collect();
    assert_eq!(recorded(window, &text).0, expected);
}

/// The box encloses what is drawn, reaches as far as the pen, and both are what `Text` finds for alignments.
#[test]
fn metrics_enclose_what_is_drawn() {
    for (number, text) in ["jAVA", "f", "12:34", "", " ", "To. /j"].into_iter().enumerate() {
        for bits in [1, 5, 9] {
            for baseline in BASELINES {
                check_metrics(text, style(FONTS[number % 2], bits), baseline, &on_pattern);
            }
        }
    }
    let style = style(&DEJAVU_SANS_24, 1);
    assert_eq!(style.line_height(), 28);
    // Digits have equal widths, so that a value does not move when it changes.
    let widths = (0..10).map(|digit| {
        let text = digit.to_string();
        style
            .measure_string(&text, Point::zero(), Baseline::Top)
            .next_position
            .x
    });
    assert!(widths.into_iter().all(|width| width == 15));
    // "AV" is kerned by -1 pixel at 16 pixels.
    let kerned = MaskTextStyle::new(&DEJAVU_SANS_16, Rgb565::RED);
    let width = |text: &str| {
        kerned
            .measure_string(text, Point::zero(), Baseline::Top)
            .next_position
            .x
    };
    assert_eq!(width("AV"), width("A") + width("V") - 1);
}

#[test]
fn whitespace_has_the_background_and_the_decorations() {
    let window = Rectangle::new(Point::zero(), Size::new(30, 40));
    let style = style(&DEJAVU_SANS_16, 14);
    let mut recorder = Recorder {
        area: window,
        colors: vec![Rgb565::BLACK; 30 * 40],
    };
    let Ok(next) = style.draw_whitespace(9, Point::new(4, 20), Baseline::Alphabetic, &mut recorder);
    assert_eq!(next, Point::new(13, 20));
    let top = 20 - i32::from(DEJAVU_SANS_16.baseline);
    for (point, color) in window.points().zip(recorder.colors) {
        let row = point.y - top;
        let is_inside = (4..13).contains(&point.x);
        let is_struck = (DEJAVU_SANS_16.strikethrough.offset as i32..).contains(&row)
            && row < (DEJAVU_SANS_16.strikethrough.offset + DEJAVU_SANS_16.strikethrough.height) as i32;
        let expected = match () {
            () if is_inside && is_struck => Rgb565::GREEN,
            () if is_inside && (0..i32::from(DEJAVU_SANS_16.height)).contains(&row) => Rgb565::BLUE,
            () => Rgb565::BLACK,
        };
        assert_eq!(color, expected, "{point}");
    }
}

/// A glyph's mask over any colour is what the colours mix to at 17 times its fifteenths.
#[test]
fn fifteenths_are_multiples_of_17() {
    static FONT: MaskFont = MaskFont {
        ranges: &[('x', 1, 0)],
        glyphs: &[MaskGlyph {
            offset: 0,
            left: 0,
            top: 0,
            width: 16,
            height: 1,
            advance: 16 * 16,
        }],
        coverage: &[0x01, 0x23, 0x45, 0x67, 0x89, 0xab, 0xcd, 0xef],
        kerning: &[],
        height: 1,
        baseline: 0,
        line_height: 1,
        underline: DecorationDimensions::new(0, 0),
        strikethrough: DecorationDimensions::new(0, 0),
        replacement: None,
    };
    let window = Rectangle::new(Point::zero(), Size::new(16, 1));
    let text = Text::new("x", Point::zero(), MaskTextStyle::new(&FONT, Rgb565::YELLOW));
    let drawn = on_pattern(window, &text);
    for (fifteenths, (point, color)) in (0u8..).zip(window.points().zip(drawn)) {
        let mixed = Rgb565::YELLOW.over::<10>(below(point), fifteenths * 17, point);
        assert_eq!(color, mixed, "{fifteenths}");
    }
}

/// A font with any tables. It stays in memory, because fonts are `static`.
fn any_font() -> impl Strategy<Value = &'static MaskFont> {
    let range = (any::<char>(), any::<u16>(), 0..40u16).prop_map(|(first, count, glyph)| {
        let first = if count % 2 == 0 { 'a' } else { first };
        (first, count, glyph)
    });
    let glyph = (
        any::<u32>(),
        any::<i16>(),
        -20..20i16,
        any::<u8>(),
        any::<u8>(),
        any::<u16>(),
    )
        .prop_map(|(offset, left, top, width, height, advance)| MaskGlyph {
            offset: if height % 3 == 0 { offset } else { offset % 100 },
            left: if advance % 2 == 0 { left } else { left % 16 },
            top,
            width,
            height,
            advance: if width % 2 == 0 { advance } else { advance % 400 },
        });
    let pair = (0..4u16, 0..4u16, any::<i16>());
    (
        prop::collection::vec(range, 0..4),
        prop::collection::vec(glyph, 0..30),
        prop::collection::vec(any::<u8>(), 0..300),
        prop::collection::vec(pair, 0..6),
        (0..40u16, any::<u16>(), any::<u16>(), prop::option::of(0..40u16)),
    )
        .prop_map(
            |(ranges, glyphs, coverage, kerning, (height, baseline, line_height, replacement))| {
                &*Box::leak(Box::new(MaskFont {
                    ranges: ranges.leak(),
                    glyphs: glyphs.leak(),
                    coverage: coverage.leak(),
                    kerning: kerning.leak(),
                    height,
                    baseline: baseline % 50,
                    line_height,
                    underline: DecorationDimensions::new(u32::from(baseline), 3),
                    strikethrough: DecorationDimensions::new(2, u32::from(line_height)),
                    replacement,
                }))
            },
        )
}

proptest! {
    #![proptest_config(config(cases(300, 300)))]

    #[test]
    fn any_font_is_drawn_in_any_window(
        font in any_font(),
        text in "[a-e\\u{3a9}\\n]{0,8}",
        (bits, alignment, baseline, height) in (0..16u8, 0..3usize, 0..4usize, 0..40u32),
        (x, y) in (-60..60i32, -60..60i32),
        (left, top) in (0..30i32, 0..30i32),
    ) {
        let around = Rectangle::new(Point::new(-10, -10), Size::new(60, 60));
        let layout = layout(alignment, baseline, LineHeight::Pixels(height));
        let text = Text::with_text_style(&text, Point::new(x, y), style(font, bits), layout);
        let whole = on_pattern(around, &text);
        let window = Rectangle::new(Point::new(left, top), Size::new(11, 9));
        prop_assert_eq!(on_pattern(window, &text), cut(&whole, around, window));
        for drawn in prepared(around, 1, &text) {
            prop_assert_eq!(&drawn, &whole);
        }
        prop_assert_eq!(in_bands(around, 1, &text), whole);
    }

    #[test]
    fn no_number_makes_it_panic(
        font in any_font(),
        (x, y) in (any_number(), any_number()),
        (bits, number, width) in (0..16u8, 0..12usize, any::<u32>()),
        line_height in prop_oneof![any::<u32>().prop_map(LineHeight::Pixels), any::<u32>().prop_map(LineHeight::Percent)],
    ) {
        let style = style(font, bits);
        let text = Text::with_text_style("ab\nc\n\na", Point::new(x, y), style, layout(number, number, line_height));
        let window = Rectangle::new(Point::new(x.saturating_sub(4), y.saturating_sub(4)), Size::new_equal(8));
        picture(window, |band| {
            let Ok(()) = text.draw_on(band);
            let Ok(_) = style.draw_string("ab", text.position, Baseline::Middle, band);
            let Ok(_) = style.draw_whitespace(width, text.position, Baseline::Bottom, band);
        });
        prepared(Rectangle::new(Point::new(-4, -4), Size::new_equal(8)), 3, &text);
        let metrics = style.measure_string("abc", text.position, Baseline::Alphabetic);
        prop_assert_eq!(metrics.next_position.y, y);
    }
}

/// A picture of two texts, of which one is put in another's place: what has changed is the box of both, and the picture is
/// that of the texts as they are.
#[test]
fn a_text_in_a_picture_is_replaced() {
    let window = Rectangle::new(Point::zero(), Size::new(100, 60));
    let style = MaskTextStyle::new(&DEJAVU_SANS_24, Rgb565::YELLOW);
    let text = |text: &'static str, y: i32| Text::new(text, Point::new(8, y), style);
    let (mut slots, mut pool, mut areas) = ([PictureSlot::EMPTY; 2], [0; 16], [Window::EMPTY; 8]);
    let mut picture = Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut []).with_damage(&mut areas, (1, 1));
    let changing = picture.add(&text("12.5", 25)).unwrap();
    picture.add(&text("km", 52)).unwrap();
    // One word for the colours, four for the line and one for each glyph.
    assert_eq!(picture.words_used(), 1 + 4 + 4 + 1 + 4 + 2);
    picture.clear_damage();
    picture.replace(changing, &text("7.50", 25)).unwrap();
    let mut damage = Vec::new();
    while let Some(area) = picture.next_damage() {
        damage.push(area);
    }
    let draw = |texts: &[MaskText<'_>]| {
        self::picture(window, |band| {
            for text in texts {
                let Ok(()) = text.draw_on(band);
            }
        })
    };
    let (before, after) = (
        draw(&[text("12.5", 25), text("km", 52)]),
        draw(&[text("7.50", 25), text("km", 52)]),
    );
    assert_eq!(self::picture(window, |band| picture.draw(band)), after);
    for (point, (before, after)) in window.points().zip(before.iter().zip(&after)) {
        assert!(
            before == after || damage.iter().any(|area| area.contains(point)),
            "{point}"
        );
    }
    let sent: u32 = damage.iter().map(|area| area.size.width * area.size.height).sum();
    assert!(sent < 28 * 62, "{damage:?}");
}
