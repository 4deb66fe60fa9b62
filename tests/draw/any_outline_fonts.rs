//! Text in fonts of outlines whose tables hold any numbers, at positions and in sizes of any numbers.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::Rectangle,
    text::{Baseline, LineHeight, Text, renderer::TextRenderer},
};
use proptest::prelude::*;
use zrow::{
    draw::{AntialiasingMemory, DrawAntialiased, OutlineFont, OutlineGlyph, Picture, PictureSlot},
    geometry::DrawError,
};

use crate::{
    common::{self, cases, config, numbers::any_number},
    outline_texts::{OutlineText, style},
    text_area::{self, cut, layout},
};

/// A font with any tables. It stays in memory, because fonts are `static`.
fn any_font() -> impl Strategy<Value = &'static OutlineFont> {
    let range = (any::<char>(), any::<u16>(), 0..10u16).prop_map(|(first, count, glyph)| {
        let first = if count % 2 == 0 { 'a' } else { first };
        (first, count, glyph)
    });
    let near = || -70..70i16;
    let side = || prop_oneof![3 => near(), 1 => any::<i16>()];
    let glyph = (
        0..40u32,
        0..30u16,
        any::<u16>(),
        [side(), side(), side(), side()],
        any::<u32>(),
    )
        .prop_map(
            |(first, points, advance, [left, bottom, right, top], any)| OutlineGlyph {
                first: if any % 9 == 0 { any } else { first },
                points: if any % 7 == 0 { any as u16 } else { points },
                advance: if any % 5 == 0 { advance } else { advance % 99 },
                left: left.min(right),
                bottom: bottom.min(top),
                right: if any % 11 == 0 { left } else { left.max(right) },
                top: top.max(bottom),
            },
        );
    let point = || prop_oneof![5 => [near(), near()], 1 => [any::<i16>(), any::<i16>()]];
    let units = prop_oneof![3 => 30..99u16, 1 => any::<u16>()];
    let metric = || prop_oneof![3 => 0..99u16, 1 => any::<u16>()];
    (
        prop::collection::vec(range, 0..4),
        prop::collection::vec(glyph, 1..10),
        (
            prop::collection::vec([any::<i8>(), any::<i8>()], 0..60),
            prop::collection::vec(point(), 0..60),
            any::<bool>(),
        ),
        prop::collection::vec(any::<u8>(), 10..20),
        (
            prop::collection::vec((0..4u16, 0..4u16, any::<i16>()), 0..6),
            prop::option::of(0..10u16),
        ),
        (
            units,
            [metric(), metric(), metric()],
            (any::<i16>(), 0..999u16),
            (-99..99i16, any::<u16>()),
        ),
    )
        .prop_map(
            |(
                ranges,
                glyphs,
                (small_points, points, is_small),
                flags,
                (kerning, replacement),
                (units_per_em, [ascent, descent, line_height], underline, strikethrough),
            )| {
                &*Box::leak(Box::new(OutlineFont {
                    units_per_em,
                    ranges: ranges.leak(),
                    glyphs: glyphs.leak(),
                    small_points: if is_small { small_points.leak() } else { &[] },
                    points: points.leak(),
                    flags: flags.leak(),
                    crossing: if units_per_em % 2 == 0 { &[0, 1, 2] } else { &[2, 1] },
                    kerning: kerning.leak(),
                    ascent,
                    descent,
                    line_height,
                    underline,
                    strikethrough,
                    replacement,
                }))
            },
        )
}

/// Draws a text in a window of a few pixels, as far as it can be drawn there.
fn try_on_pattern(
    window: Rectangle,
    text: &OutlineText<'_>,
) -> Result<Vec<Rgb565>, DrawError<core::convert::Infallible>> {
    let mut drawn = Ok(());
    let pixels = text_area::on_pattern(window, |band| {
        drawn = text.draw_on(&mut band.antialiased::<4_096, 1_024>(&mut [0; 99]));
    });
    drawn.map(|()| pixels)
}

proptest! {
    #![proptest_config(config(cases(200, 4_000)))]

    /// What cannot be drawn on a band cannot be added to a picture either; what can be added is drawn alike.
    #[test]
    fn any_font_is_drawn_in_any_window(
        font in any_font(),
        text in "[a-e\\u{3a9}\\n]{0,8}",
        (bits, alignment, baseline, height) in (0..16u8, 0..3usize, 0..4usize, 0..40u32),
        size in prop_oneof![4 => 200..9_000u32, 1 => any::<u32>()],
        (x, y) in (-60..60i32, -60..60i32),
        (left, top) in (0..30i32, 0..30i32),
    ) {
        let around = Rectangle::new(Point::new(-10, -10), Size::new(60, 60));
        let layout = layout(alignment, baseline, LineHeight::Pixels(height));
        let text = Text::with_text_style(&text, Point::new(x, y), style(font, size, bits), layout);
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 96]);
        let mut memory = AntialiasingMemory::<40, 1_024, 1>::new();
        let mut picture = Picture::<Rgb565>::new(around, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
        let added = picture.add(&text);
        let Ok(whole) = try_on_pattern(around, &text) else {
            prop_assert!(added.is_err());
            return Ok(());
        };
        let window = Rectangle::new(Point::new(left, top), Size::new(11, 9));
        prop_assert_eq!(try_on_pattern(window, &text).unwrap(), cut(&whole, around, window));
        let rows = text_area::in_bands(around, 1, true, |band| {
            text.draw_on(&mut band.antialiased::<4_096, 1_024>(&mut [0; 99])).unwrap();
        });
        prop_assert_eq!(&rows, &whole);
        if added.is_ok() {
            for drawn in text_area::prepared(around, 1, &mut picture) {
                prop_assert_eq!(&drawn, &whole);
            }
        }
    }

    #[test]
    fn no_number_makes_it_panic(
        font in any_font(),
        (x, y) in (any_number(), any_number()),
        (bits, number, width, size) in (0..16u8, 0..12usize, any::<u32>(), any::<u32>()),
        line_height in prop_oneof![any::<u32>().prop_map(LineHeight::Pixels), any::<u32>().prop_map(LineHeight::Percent)],
    ) {
        let style = style(font, size >> (number * 2), bits);
        let text = Text::with_text_style("ab\nc\n\na", Point::new(x, y), style, layout(number, number, line_height));
        let window = Rectangle::new(Point::new(x.saturating_sub(4), y.saturating_sub(4)), Size::new_equal(8));
        common::picture(window, |band| {
            let _ = text.draw_on(&mut band.antialiased::<256, 64>(&mut [0; 9]));
            let Ok(_) = style.draw_string("ab", text.position, Baseline::Middle, band);
            let Ok(_) = style.draw_whitespace(width, text.position, Baseline::Bottom, band);
        });
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 96]);
        let mut memory = AntialiasingMemory::<9, 64, 1>::new();
        let mut picture = Picture::<Rgb565>::new(window, &mut slots, &mut pool, &mut []).with_antialiasing(&mut memory);
        if let Ok(id) = picture.add(&text) {
            let _ = picture.translate(id, Point::new(y, x));
        }
        text_area::prepared(Rectangle::new(Point::new(-4, -4), Size::new_equal(8)), 3, &mut picture);
        let metrics = style.measure_string("abc", text.position, Baseline::Alphabetic);
        prop_assert_eq!(metrics.next_position.y, y);
    }
}
