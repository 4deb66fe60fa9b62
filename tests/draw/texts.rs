//! Text against embedded-graphics' own renderer, whole and in bands, for all of its fonts, decorations and alignments.

use embedded_graphics::{
    geometry::AnchorPoint,
    image::ImageRaw,
    mono_font::{self, DecorationDimensions, MonoFont, MonoTextStyle, MonoTextStyleBuilder, mapping::StrGlyphMapping},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::Rectangle,
    text::{Alignment, Baseline, LineHeight, Text, TextStyle, TextStyleBuilder},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, Picture, PictureSlot};

use crate::{
    common::{cases, config, picture},
    picture_display::in_bands,
};

/// All fonts of embedded-graphics in the character sets that have the usual sizes, and those of JIS X 0201.
fn fonts() -> Vec<&'static MonoFont<'static>> {
    macro_rules! fonts {
        ($fonts:ident: $($set:ident)+) => { $(
            $fonts.extend({
                use mono_font::$set::*;
                [
                    &FONT_4X6, &FONT_5X7, &FONT_5X8, &FONT_6X9, &FONT_6X10, &FONT_6X12, &FONT_6X13, &FONT_6X13_BOLD,
                    &FONT_6X13_ITALIC, &FONT_7X13, &FONT_7X13_BOLD, &FONT_7X13_ITALIC, &FONT_7X14, &FONT_7X14_BOLD,
                    &FONT_8X13, &FONT_8X13_BOLD, &FONT_8X13_ITALIC, &FONT_9X15, &FONT_9X15_BOLD, &FONT_9X18,
                    &FONT_9X18_BOLD, &FONT_10X20,
                ]
            });
        )+ };
    }
    let mut fonts = Vec::new();
    fonts!(fonts: ascii iso_8859_1 iso_8859_2 iso_8859_3 iso_8859_4 iso_8859_5 iso_8859_7 iso_8859_9 iso_8859_10
        iso_8859_13 iso_8859_14 iso_8859_15 iso_8859_16);
    fonts.extend({
        use mono_font::jis_x0201::*;
        [&FONT_6X13, &FONT_7X14, &FONT_8X13, &FONT_9X15, &FONT_9X18, &FONT_10X20]
    });
    fonts
}

/// A font with wide glyphs, more characters than glyphs, and space between them. Its bytes are any.
fn wide_font<'a>(bytes: &'a [u8], width: u32, character: Size, spacing: u32) -> MonoFont<'a> {
    MonoFont {
        image: ImageRaw::new(bytes, width),
        character_size: character,
        character_spacing: spacing,
        baseline: character.height / 2,
        strikethrough: DecorationDimensions::new(character.height / 2, 2),
        underline: DecorationDimensions::new(character.height + 3, 3),
        glyph_mapping: &MAPPING,
    }
}

static MAPPING: StrGlyphMapping<'static> = StrGlyphMapping::new("\0 ~", 3);

const TEXT: Rgb565 = Rgb565::YELLOW;
const BACKGROUND: Rgb565 = Rgb565::BLUE;

/// A style by bits: colours of the text and of its background; each decoration has none, the text's or its own colour.
fn style<'a>(font: &'a MonoFont<'a>, colors: u8, underline: u8, strikethrough: u8) -> MonoTextStyle<'a, Rgb565> {
    let mut builder = MonoTextStyleBuilder::new().font(font);
    if colors & 1 != 0 {
        builder = builder.text_color(TEXT);
    }
    if colors & 2 != 0 {
        builder = builder.background_color(BACKGROUND);
    }
    builder = match underline {
        0 => builder,
        1 => builder.underline(),
        _ => builder.underline_with_color(Rgb565::RED),
    };
    builder = match strikethrough {
        0 => builder,
        1 => builder.strikethrough(),
        _ => builder.strikethrough_with_color(Rgb565::GREEN),
    };
    builder.build()
}

const ALIGNMENTS: [Alignment; 3] = [Alignment::Left, Alignment::Center, Alignment::Right];
const BASELINES: [Baseline; 4] = [Baseline::Top, Baseline::Bottom, Baseline::Middle, Baseline::Alphabetic];

fn layout(alignment: usize, baseline: usize, line_height: LineHeight) -> TextStyle {
    TextStyleBuilder::new()
        .alignment(ALIGNMENTS[alignment % 3])
        .baseline(BASELINES[baseline % 4])
        .line_height(line_height)
        .build()
}

/// Holds a text against embedded-graphics' renderer in a window, in bands of each of these heights, from the last one up.
fn check(text: &Text<'_, MonoTextStyle<'_, Rgb565>>, window: Rectangle, heights: &[u32]) -> Result<(), TestCaseError> {
    let expected = picture(window, |band| {
        let Ok(_) = text.draw(band);
    });
    for &height in heights {
        let mut found = Vec::new();
        let mut bottom = window.size.height;
        while bottom > 0 {
            let rows = height.min(bottom);
            bottom -= rows;
            let top_left = window.top_left + Size::new(0, bottom);
            let band = Rectangle::new(top_left, Size::new(window.size.width, rows));
            let mut part = picture(band, |band| {
                let Ok(()) = text.draw_on(band);
            });
            part.append(&mut found);
            found = part;
        }
        prop_assert!(found == expected, "{text:?} in {window:?}, bands of {height}");
    }
    Ok(())
}

#[test]
fn every_font_has_the_pixels_of_embedded_graphics() {
    let lines = "Ag|j~ {}\u{e4}\u{3a9}\u{ff71}\u{65e5}\r\n\nQ\0y\n";
    let window = Rectangle::new(Point::new(-3, 2), Size::new(97, 71));
    for (index, font) in fonts().into_iter().enumerate() {
        let number = index as u8;
        // Every font in a few of the styles, so that all styles come up.
        for shift in 0..4 {
            let style = style(font, number.wrapping_add(shift), number / 4 + shift, number / 2 + shift);
            let layout = layout(
                index,
                index / 3 + usize::from(shift),
                LineHeight::Percent(80 + 10 * u32::from(shift)),
            );
            let position = window.anchor_point(AnchorPoint::Center) - Point::new(0, 15);
            let text = Text::with_text_style(lines, position, style, layout);
            check(&text, window, &[1, 8, 71]).unwrap();
        }
    }
}

/// A font whose image has no rows, and so many columns that they are no 32-bit number when rounded up to whole bytes, or that a few
/// rows of bytes are none: it has no glyphs.
#[test]
fn fonts_with_images_of_all_columns_show_nothing() {
    let area = Rectangle::new(Point::zero(), Size::new(20, 24));
    for width in [1 << 31, u32::MAX - 7, u32::MAX] {
        let font = wide_font(&[], width, Size::new(6, 20), 0);
        let plain = MonoTextStyle::new(&font, TEXT);
        let text = Text::with_baseline("~ ", Point::zero(), plain, Baseline::Top);
        let drawn = picture(area, |band| {
            let Ok(()) = text.draw_on(band);
        });
        assert!(drawn.iter().all(|color| *color == Rgb565::BLACK));
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 40]);
        let mut prepared = Picture::new(area, &mut slots, &mut pool, &mut []);
        prepared.add(&text).unwrap();
        assert!(in_bands(&mut prepared, area, &[1]).iter().all(|word| *word == 0));
    }
}

/// embedded-graphics overflows there: so the text is held against itself near the origin.
#[test]
fn far_texts_are_moved_texts() {
    let font = &mono_font::ascii::FONT_9X15;
    for colors in 1..4 {
        for (number, underline) in [(0, 0), (1, 1), (2, 2), (5, 1)] {
            let style = style(font, colors, underline, 2);
            let layout = layout(number, number + 1, LineHeight::Pixels(9));
            let size = Size::new(60, 40);
            let near = Text::with_text_style("far\naway, indeed", Point::new(30, 20), style, layout);
            let expected = picture(Rectangle::new(Point::zero(), size), |band| {
                let Ok(()) = near.draw_on(band);
            });
            for x in [i32::MIN, i32::MAX - 60] {
                for y in [i32::MIN, i32::MAX - 40] {
                    let corner = Point::new(x, y);
                    let far = Text::with_text_style(near.text, corner + near.position, style, layout);
                    let found = picture(Rectangle::new(corner, size), |band| {
                        let Ok(()) = far.draw_on(band);
                    });
                    assert!(found == expected, "{far:?}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(config(cases(300, 300)))]

    #[test]
    fn any_font_has_the_pixels_of_embedded_graphics(
        bytes in prop::collection::vec(any::<u8>(), 0..400),
        (width, columns, rows, spacing) in (0..120u32, 0..70u32, 0..14u32, 0..4u32),
        (colors, underline, strikethrough) in (0..4u8, 0..3u8, 0..3u8),
        (alignment, baseline) in (0..3usize, 0..4usize),
        line_height in prop_oneof![(0..30u32).prop_map(LineHeight::Pixels), (0..200u32).prop_map(LineHeight::Percent)],
        text in "[ -~\\u{7f}\\u{80}\n\r]{0,12}",
        position in (-80..80i32, -40..60i32),
        (left, top, right, bottom) in (-30..30i32, -20..20i32, 1..60i32, 1..40i32),
    ) {
        // The image takes whole rows only.
        let stride = width.div_ceil(8) as usize;
        let whole = bytes.len().checked_div(stride).unwrap_or(0) * stride;
        prop_assume!(width > 0);
        let font = wide_font(&bytes[..whole], width, Size::new(columns, rows), spacing);
        let style = style(&font, colors, underline, strikethrough);
        let layout = layout(alignment, baseline, line_height);
        let text = Text::with_text_style(&text, Point::from(position), style, layout);
        let window = Rectangle::new(Point::new(left, top), Size::new(right as u32, bottom as u32));
        check(&text, window, &[1, 7, 40])?;
    }

    #[test]
    fn no_number_makes_it_panic(
        x in crate::common::numbers::any_number(),
        y in crate::common::numbers::any_number(),
        number in 0..12usize,
        line_height in prop_oneof![any::<u32>().prop_map(LineHeight::Pixels), any::<u32>().prop_map(LineHeight::Percent)],
    ) {
        let style = style(&mono_font::ascii::FONT_5X7, 3, 1, 2);
        let layout = layout(number, number, line_height);
        let text = Text::with_text_style("a\nb\n\nc", Point::new(x, y), style, layout);
        let window = Rectangle::new(Point::new(x.saturating_sub(4), y.saturating_sub(4)), Size::new_equal(8));
        picture(window, |band| {
            let Ok(()) = text.draw_on(band);
        });
    }
}

/// A text that is empty as yet takes no words, and what is put in its place is drawn.
#[test]
fn an_empty_text_takes_no_words() {
    let area = Rectangle::new(Point::zero(), Size::new(64, 32));
    let style = MonoTextStyle::new(&mono_font::ascii::FONT_6X10, Rgb565::WHITE);
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], [0; 6]);
    let mut picture = Picture::<Rgb565>::new(area, &mut slots, &mut pool, &mut []);
    let text = picture.add(&Text::new("", Point::new(3, 9), style)).unwrap();
    assert_eq!(picture.words_used(), 0);
    picture.translate(text, Point::new(i32::MAX, 0)).unwrap();
    picture
        .replace(text, &Text::new("42 km", Point::new(3, 9), style))
        .unwrap();
    assert_eq!(picture.words_used(), 6);
    assert!(in_bands(&mut picture, area, &[1]).contains(&Rgb565::WHITE.into_storage()));
}
