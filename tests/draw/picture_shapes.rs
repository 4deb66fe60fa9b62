//! Shapes and texts of a prepared picture, each of every size or slope that could be entered wrongly in some row, and what moves
//! in a gauge.

use embedded_graphics::{
    image::ImageRaw,
    mono_font::{DecorationDimensions, MonoFont, MonoTextStyle, ascii::FONT_10X20, mapping::StrGlyphMapping},
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Ellipse, Line, PrimitiveStyleBuilder, Rectangle, Triangle},
    text::Text,
};
use zrow::{
    band::Band,
    draw::{DrawOn, ItemId},
    geometry::{InputError, Window},
};

use crate::{
    picture_display::in_bands,
    picture_items::{AREA, Item, Prepared, Slot, Style, replayed, with_picture},
};

/// A gauge on 240 x 320 pixels: what a needle of 100 pixels and a value send when they change.
#[test]
fn a_needle_and_a_value_change_few_pixels() {
    let area = Rectangle::new(Point::zero(), Size::new(240, 320));
    let (mut slots, mut pool, mut buckets, mut areas) = ([Slot::EMPTY; 4], [0; 64], [0; 320], [Window::EMPTY; 16]);
    let mut picture = Prepared::new(area, &mut slots, &mut pool, &mut buckets).with_damage(&mut areas, (1, 1));
    let center = Point::new(120, 120);
    let needle = |degrees: i32, width: u32| {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let tip = center + Point::new((100.0 * cosine).round() as i32, (100.0 * sine).round() as i32);
        Line::new(center, tip).into_styled(Style::with_stroke(Rgb565::RED, width))
    };
    let value = |string| {
        Text::new(
            string,
            Point::new(85, 220),
            MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE),
        )
    };
    let back = Rectangle::new(Point::zero(), Size::new(240, 320)).into_styled(Style::with_fill(Rgb565::BLUE));
    picture.add(&back).unwrap();
    for (width, bound) in [(1, 3_900), (5, 4_100)] {
        picture.clear();
        picture.add(&back).unwrap();
        let needle_id = picture.add(&needle(0, width)).unwrap();
        let value_id = picture.add(&value("42 km/h")).unwrap();
        let mut most = 0;
        picture.clear_damage();
        for degrees in (6..=720).step_by(6) {
            picture.replace(needle_id, &needle(degrees, width)).unwrap();
            picture.replace(value_id, &value("43 km/h")).unwrap();
            let areas = core::iter::from_fn(|| picture.next_damage());
            let changed = areas.map(|area| area.size.width * area.size.height).sum();
            most = most.max(changed);
        }
        // The value takes 1,400 of them; 3,900 are 5 percent of the panel.
        assert!(most <= bound, "{most} for a needle {width} px wide");
    }
}

/// What is documented of the pool of a picture.
#[test]
fn words_of_closed_shapes() {
    fn words_of(add: impl FnOnce(&mut Prepared<'_, '_>) -> Result<ItemId, InputError>) -> usize {
        let (mut slots, mut pool) = ([Slot::EMPTY; 1], [0; 64]);
        let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut []);
        add(&mut picture).unwrap();
        picture.words_used()
    }
    let rectangle = Rectangle::new(Point::new(3, 4), Size::new(30, 20));
    let circle = Circle::new(Point::new(3, 4), 20);
    let ellipse = Ellipse::new(Point::new(3, 4), Size::new(30, 20));
    let fill = Style::with_fill(Rgb565::BLUE);
    for width in 1..6 {
        let stroke = Style::with_stroke(Rgb565::RED, width);
        let mut both = stroke;
        both.fill_color = fill.fill_color;
        let styles = [
            (fill, [0, 0, 0]),
            (stroke, [2, if width == 1 { 0 } else { 4 }, 4]),
            (both, [2, 4, 4]),
        ];
        for (style, words) in styles {
            let used = [
                words_of(|picture| picture.add(&rectangle.into_styled(style))),
                words_of(|picture| picture.add(&circle.into_styled(style))),
                words_of(|picture| picture.add(&ellipse.into_styled(style))),
            ];
            assert_eq!(used, words, "{style:?}");
        }
    }
}

/// Circles and ellipses of every small size in each row: both halves of the walk, and every start.
#[test]
fn round_shapes_of_every_size_are_entered_in_every_row() {
    let style = Style::with_fill(Rgb565::RED);
    let area = |y: i32, height: u32| Rectangle::new(Point::new(0, y), Size::new(40, height));
    for (width, height) in (1..40).flat_map(|width| (1..40).map(move |height| (width, height))) {
        let ellipse = Ellipse::new(Point::zero(), Size::new(width, height)).into_styled(style);
        with_picture(47, |picture| {
            picture.add(&ellipse).unwrap();
            for first in 0..height {
                let area = area(first as i32, height - first);
                let item = Item::Ellipse(ellipse.primitive, style);
                assert_eq!(
                    in_bands(picture, area, &[1]),
                    replayed(area, [&item]),
                    "{width} x {height} from {first}"
                );
            }
        });
    }
}

/// Outlines of circles, one pixel wide, of every small size in each row, whole and cut off on both sides.
#[test]
fn outlines_of_circles_of_every_size_are_entered_in_every_row() {
    let style = Style::with_stroke(Rgb565::RED, 1);
    for (diameter, (left, columns)) in (1..70).flat_map(|diameter| [(0, 70), (3, 20)].map(|cut| (diameter, cut))) {
        let circle = Circle::new(Point::zero(), diameter);
        let item = Item::Circle(circle, style);
        with_picture(47, |picture| {
            item.add(picture).unwrap();
            for first in 0..diameter {
                let area = Rectangle::new(Point::new(left, first as i32), Size::new(columns, diameter - first));
                assert_eq!(
                    in_bands(picture, area, &[1]),
                    replayed(area, [&item]),
                    "{diameter} from {first}, {columns} columns from {left}"
                );
            }
        });
    }
}

/// The upper ends, the middles and the lower ends of circles around the largest one that is kept in two words.
#[test]
fn outlines_of_large_circles_show_what_replaying_shows() {
    let style = Style::with_stroke(Rgb565::RED, 1);
    let diameters = [1_001, 32_000, 32_767, 32_768, 32_769, 60_000];
    for (diameter, at) in diameters
        .into_iter()
        .flat_map(|diameter| [0, 1, 2].map(|at| (diameter, at)))
    {
        let radius = diameter as i32 / 2;
        let top_left = match at {
            0 => Point::new(20 - radius, 3),
            1 => Point::new(3, 20 - radius),
            _ => Point::new(20 - radius, 30 - diameter as i32),
        };
        let item = Item::Circle(Circle::new(top_left, diameter), style);
        with_picture(47, |picture| {
            item.add(picture).unwrap();
            assert_eq!(
                in_bands(picture, AREA, &[1]),
                replayed(AREA, [&item]),
                "{diameter} at {top_left}"
            );
        });
    }
}

/// Ellipses whose height squared is the largest `i32`, the next one, and the largest that an item of 16 bits can have.
#[test]
fn tall_ellipses_show_what_replaying_shows() {
    for (width, height, top) in [
        (3, 46_340, -300),
        (3, 46_341, -300),
        (1, 65_535, -32_768),
        (1, 65_535, -32_767),
    ] {
        let ellipse = Ellipse::new(Point::new(20, top), Size::new(width, height));
        let style: Style = PrimitiveStyleBuilder::new()
            .fill_color(Rgb565::RED)
            .stroke_color(Rgb565::GREEN)
            .stroke_width(1)
            .build()
            .into();
        for style in [style, Style::with_fill(Rgb565::RED)] {
            let item = Item::Ellipse(ellipse, style);
            with_picture(47, |picture| {
                item.add(picture).unwrap();
                assert_eq!(in_bands(picture, AREA, &[1]), replayed(AREA, [&item]), "{item:?}");
            });
        }
    }
}

/// Lines and triangles with corners on a small grid: every slope, direction and tie.
#[test]
fn lines_and_triangles_of_every_slope_are_entered_in_every_row() {
    let area = |y: i32| Rectangle::new(Point::new(0, y), Size::new(12, 12 - y as u32));
    let grid = || (0..12).flat_map(|x| (0..12).map(move |y| Point::new(x, y)));
    let check = |item: Item| {
        with_picture(47, |picture| {
            item.add(picture).unwrap();
            for first in [0, 1, 5, 8] {
                let area = area(first);
                assert_eq!(
                    in_bands(picture, area, &[1]),
                    replayed(area, [&item]),
                    "{item:?} from {first}"
                );
            }
        });
    };
    for (a, b) in grid().flat_map(|a| grid().map(move |b| (a, b))) {
        check(Item::Line(Line::new(a, b), Style::with_stroke(Rgb565::RED, 1)));
        let corner = Point::new((a.x * 7 + b.y) % 12, (a.y * 5 + b.x) % 12);
        check(Item::Triangle(
            Triangle::new(a, b, corner),
            Style::with_fill(Rgb565::RED),
        ));
    }
}

/// A glyph with as much space behind it as a font can have: the space leads nowhere, because no glyph follows.
#[test]
fn the_space_behind_the_last_glyph_is_any() {
    let bytes = [0b1010_0000, 0b1110_0000];
    for character_spacing in [0, 3, 70_000, i32::MAX as u32, u32::MAX - 3, u32::MAX] {
        let font = MonoFont {
            image: ImageRaw::new(&bytes, 8),
            character_size: Size::new(8, 2),
            character_spacing,
            baseline: 0,
            strikethrough: DecorationDimensions::new(0, 1),
            underline: DecorationDimensions::new(2, 1),
            glyph_mapping: &StrGlyphMapping::new("A", 0),
        };
        for string in ["A", "AA"] {
            let text = Text::new(string, Point::new(2, 8), MonoTextStyle::new(&font, Rgb565::RED));
            let mut expected = vec![0; (AREA.size.width * AREA.size.height) as usize];
            let Ok(()) = text.draw_on(&mut Band::<Rgb565>::new(AREA, &mut expected).unwrap());
            let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 1], [0; 40], [0; 47]);
            let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets);
            picture.add(&text).unwrap();
            assert_eq!(
                in_bands(&mut picture, AREA, &[1]),
                expected,
                "{string} {character_spacing}"
            );
        }
    }
}

/// Columns beyond the sides of a band take no time: a line and an ellipse of 30,000 columns in a band of few.
#[test]
fn wide_items_show_what_replaying_shows() {
    let (fill, thin) = (Style::with_fill(Rgb565::RED), Style::with_stroke(Rgb565::RED, 1));
    let items = [
        Item::Line(Line::new(Point::new(-15_000, 9), Point::new(15_000, 9)), thin),
        Item::Line(Line::new(Point::new(15_000, 9), Point::new(-15_000, 12)), thin),
        Item::Ellipse(Ellipse::new(Point::new(-15_000, 12), Size::new(30_000, 3)), fill),
        Item::Ellipse(Ellipse::new(Point::new(-1_024, 20), Size::new(2_048, 7)), fill),
        Item::Ellipse(Ellipse::new(Point::new(-1_024, 30), Size::new(2_049, 7)), fill),
    ];
    with_picture(47, |picture| {
        for item in &items {
            item.add(picture).unwrap();
        }
        assert_eq!(in_bands(picture, AREA, &[1]), replayed(AREA, &items));
    });
}

/// Rows above -32,768 show nothing of items below, which have begun already where there are no buckets.
#[test]
fn rows_far_above_all_items_are_empty() {
    let mut slots = [Slot::EMPTY; 1];
    let mut picture = Prepared::new(AREA, &mut slots, &mut [], &mut []);
    let circle = Circle::new(Point::zero(), 9).into_styled(Style::with_stroke(Rgb565::RED, 1));
    picture.add(&circle).unwrap();
    for first in [i32::MIN, -40_000, -32_770] {
        for row in first..first + 4 {
            let mut words = [0; 16];
            let area = Rectangle::new(Point::new(0, row), Size::new(16, 1));
            picture.draw(&mut Band::<Rgb565>::new(area, &mut words).unwrap());
            assert_eq!(words, [0; 16], "{row}");
        }
    }
}
