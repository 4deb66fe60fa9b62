//! Prepared pictures against the same items drawn one after the other into a whole frame: in bands of any height and
//! order, after changes, and with memory of every size.

use embedded_graphics::{
    image::ImageRaw,
    mono_font::{
        DecorationDimensions, MonoFont, MonoTextStyle, MonoTextStyleBuilder,
        ascii::{FONT_4X6, FONT_6X10, FONT_10X20},
        mapping::StrGlyphMapping,
    },
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, Rectangle, RoundedRectangle, Sector, Styled, Triangle,
    },
    text::{Alignment, Baseline, LineHeight, Text, TextStyleBuilder},
};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{DrawOn, ItemId, Picture, PictureItem, PictureSlot, PrimitiveStyle, PrimitiveStyleBuilder, ThinCircle},
    geometry::{InputError, Table, TooSmall, Window},
};

use crate::common::{cases, config, hostile::any_length};

type Prepared<'m, 'a> = Picture<'m, 'a, Rgb565>;
type Slot<'a> = PictureSlot<'a, Rgb565>;
type Style = PrimitiveStyle<Rgb565>;

/// Where pictures are drawn: small, so that most items meet each other and the sides.
const AREA: Rectangle = Rectangle::new(Point::new(-3, 5), Size::new(61, 47));

/// What a picture is made of.
#[derive(Debug, Clone)]
enum Item {
    Rectangle(Rectangle, Style),
    Rounded(RoundedRectangle, Style),
    Circle(Circle, Style),
    Ellipse(Ellipse, Style),
    Triangle(Triangle, Style),
    Line(Line, Style),
    Arc(Arc, Style),
    Sector(Sector, Style),
    Thin(ThinCircle, Style),
    Text(String, Point, TextKind),
    /// By reference.
    Polyline([Point; 4], Style),
}

/// Font, colours and decorations by bits, then alignment and so on.
type TextKind = (u32, Rgb565);

fn text((bits, color): TextKind, string: &str, position: Point) -> Text<'_, MonoTextStyle<'static, Rgb565>> {
    let font = [&FONT_4X6, &FONT_6X10, &FONT_10X20][(bits % 3) as usize];
    let mut style = MonoTextStyleBuilder::new().font(font).text_color(color);
    // Most texts are plain.
    let decoration = bits >> 2 & 15;
    style = match decoration {
        0 => style.background_color(Rgb565::BLUE),
        1 => style.underline(),
        2 => style.strikethrough_with_color(Rgb565::GREEN),
        3 => style.underline_with_color(Rgb565::RED).background_color(Rgb565::WHITE),
        4 => style.reset_text_color(),
        _ => style,
    };
    let layout = TextStyleBuilder::new()
        .alignment([Alignment::Left, Alignment::Center, Alignment::Right][(bits >> 6 & 3).min(2) as usize])
        .baseline([Baseline::Top, Baseline::Bottom, Baseline::Middle, Baseline::Alphabetic][(bits >> 8 & 3) as usize])
        .line_height(if bits >> 10 & 1 == 0 {
            LineHeight::Percent(80)
        } else {
            LineHeight::Pixels(9)
        })
        .build();
    Text::with_text_style(string, position, style.build(), layout)
}

impl Item {
    /// Draws it as it is drawn without a picture.
    fn draw(&self, band: &mut Band<'_, Rgb565>) {
        fn styled<'s, S>(shape: &'s S, style: &Style, band: &mut Band<'_, Rgb565>)
        where
            Styled<&'s S, Style>: DrawOn<Color = Rgb565>,
        {
            let Ok(()) = Styled::new(shape, *style).draw_on(band);
        }
        match self {
            Self::Rectangle(shape, style) => styled(shape, style, band),
            Self::Rounded(shape, style) => styled(shape, style, band),
            Self::Circle(shape, style) => styled(shape, style, band),
            Self::Ellipse(shape, style) => styled(shape, style, band),
            Self::Triangle(shape, style) => styled(shape, style, band),
            Self::Line(shape, style) => styled(shape, style, band),
            Self::Arc(shape, style) => styled(shape, style, band),
            Self::Sector(shape, style) => styled(shape, style, band),
            Self::Thin(shape, style) => styled(shape, style, band),
            Self::Polyline(points, style) => styled(&Polyline::new(points), style, band),
            Self::Text(string, position, kind) => {
                let Ok(()) = text(*kind, string, *position).draw_on(band);
            }
        }
    }

    fn add<'a>(&'a self, picture: &mut Prepared<'_, 'a>) -> Result<ItemId, InputError> {
        match self {
            Self::Rectangle(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Rounded(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Circle(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Ellipse(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Triangle(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Line(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Arc(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Sector(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Thin(shape, style) => picture.add(&shape.into_styled(*style)),
            Self::Text(string, position, kind) => picture.add(&text(*kind, string, *position)),
            Self::Polyline(..) => picture.add_item(self),
        }
    }

    fn replace<'a>(&'a self, picture: &mut Prepared<'_, 'a>, id: ItemId) -> Result<(), InputError> {
        match self {
            Self::Rectangle(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Rounded(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Circle(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Ellipse(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Triangle(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Line(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Arc(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Sector(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Thin(shape, style) => picture.replace(id, &shape.into_styled(*style)),
            Self::Text(string, position, kind) => picture.replace(id, &text(*kind, string, *position)),
            Self::Polyline(..) => picture.replace_item(id, self),
        }
    }
}

/// An item of the program's own.
impl PictureItem<Rgb565> for Item {
    fn bounds(&self) -> Window {
        match self {
            Self::Polyline(points, style) => Polyline::new(points).into_styled(*style).bounding_box().into(),
            other => unreachable!("{other:?} is added by copy"),
        }
    }

    fn draw(&self, band: &mut Band<'_, Rgb565>) {
        Item::draw(self, band);
    }
}

fn points() -> impl Strategy<Value = Point> + Clone {
    let near = (-30..90, -30..80);
    let far = (-40_000..40_000, -40_000..40_000);
    prop_oneof![12 => near, 1 => far].prop_map(|(x, y)| Point::new(x, y))
}

fn sizes() -> impl Strategy<Value = Size> + Clone {
    let small = (0..50u32, 0..50u32);
    let thin = (0..5u32, 0..90u32);
    let large = (0..3_000u32, 0..3_000u32);
    let huge = (0..100_000u32, 0..100_000u32);
    prop_oneof![12 => small, 3 => thin, 2 => large, 1 => huge].prop_map(|(width, height)| Size::new(width, height))
}

fn colors() -> impl Strategy<Value = Rgb565> + Clone {
    (1..32u8, 0..64u8, 0..32u8).prop_map(|(red, green, blue)| Rgb565::new(red, green, blue))
}

fn styles() -> impl Strategy<Value = Style> + Clone {
    use embedded_graphics::primitives::StrokeAlignment::{Center, Inside, Outside};
    let alignments = prop_oneof![Just(Inside), Just(Center), Just(Outside)];
    let widths = prop_oneof![4 => Just(1), 2 => 2..6u32, 1 => 0..40u32];
    (
        proptest::option::of(colors()),
        proptest::option::of(colors()),
        widths,
        alignments,
    )
        .prop_map(|(fill, stroke, width, alignment)| {
            let mut style = PrimitiveStyleBuilder::new().stroke_alignment(alignment);
            if let Some(color) = fill {
                style = style.fill_color(color);
            }
            if let Some(color) = stroke {
                style = style.stroke_color(color).stroke_width(width);
            }
            style.build()
        })
}

fn items() -> impl Strategy<Value = Item> + Clone {
    items_of(points(), sizes())
}

/// Items with numbers of their whole type.
fn hostile_items() -> impl Strategy<Value = Item> + Clone {
    let number = || prop_oneof![2 => -50..50, 1 => any::<i32>(), 1 => (0..40).prop_map(|by| i32::MAX - by), 1 => (0..40).prop_map(|by| i32::MIN + by)];
    let points = (number(), number()).prop_map(|(x, y)| Point::new(x, y));
    let sizes = (any_length(), any_length()).prop_map(|(width, height)| Size::new(width, height));
    items_of(points, sizes)
}

fn items_of(
    points: impl Strategy<Value = Point> + Clone + 'static,
    sizes: impl Strategy<Value = Size> + Clone + 'static,
) -> impl Strategy<Value = Item> + Clone {
    let boxes = (points.clone(), sizes.clone()).prop_map(|(point, size)| Rectangle::new(point, size));
    let circles = (points.clone(), sizes.clone()).prop_map(|(point, size)| Circle::new(point, size.width));
    let angles = (-720.0..720.0f32, -400.0..400.0f32).prop_map(|(start, sweep)| (start.deg(), sweep.deg()));
    let corners = (sizes.clone(), sizes.clone(), sizes.clone(), sizes.clone()).prop_map(|(a, b, c, d)| CornerRadii {
        top_left: a,
        top_right: b,
        bottom_right: c,
        bottom_left: d,
    });
    prop_oneof![
        (boxes.clone(), styles()).prop_map(|(shape, style)| Item::Rectangle(shape, style)),
        (circles.clone(), styles()).prop_map(|(shape, style)| Item::Circle(shape, style)),
        (boxes.clone(), styles())
            .prop_map(|(shape, style)| Item::Ellipse(Ellipse::new(shape.top_left, shape.size), style)),
        (points.clone(), points.clone(), points.clone(), styles())
            .prop_map(|(a, b, c, style)| Item::Triangle(Triangle::new(a, b, c), style)),
        (points.clone(), points.clone(), styles()).prop_map(|(a, b, style)| Item::Line(Line::new(a, b), style)),
        (boxes, corners, styles())
            .prop_map(|(shape, corners, style)| Item::Rounded(RoundedRectangle::new(shape, corners), style)),
        (circles.clone(), angles.clone(), styles())
            .prop_map(|(circle, (start, sweep), style)| Item::Arc(Arc::from_circle(circle, start, sweep), style)),
        (circles.clone(), angles, styles())
            .prop_map(|(circle, (start, sweep), style)| Item::Sector(Sector::from_circle(circle, start, sweep), style)),
        (circles, styles())
            .prop_map(|(circle, style)| Item::Thin(ThinCircle::new(circle.top_left, circle.diameter), style)),
        ("[ -~\n\r]{0,3}|[0-9A-z ]{0,9}", points.clone(), any::<u32>(), colors())
            .prop_map(|(string, point, bits, color)| Item::Text(string, point, (bits, color))),
        (
            [points.clone(), points.clone(), points.clone(), points.clone()],
            styles()
        )
            .prop_map(|(points, style)| Item::Polyline(points, style)),
    ]
}

/// Every item drawn one after the other into a band of a whole area.
fn replayed<'i>(area: Rectangle, items: impl IntoIterator<Item = &'i Item>) -> Vec<u16> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    let mut band = Band::new(area, &mut words).unwrap();
    for item in items {
        item.draw(&mut band);
    }
    words
}

/// The picture in bands of these heights, from the top down, again and again.
fn in_bands(picture: &mut Prepared<'_, '_>, area: Rectangle, heights: &[u32]) -> Vec<u16> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    let mut rest = words.as_mut_slice();
    let mut y = 0;
    for height in heights.iter().cycle() {
        let height = (*height).min(area.size.height - y);
        if height == 0 {
            break;
        }
        let (here, below) = rest.split_at_mut((area.size.width * height) as usize);
        let top_left = area.top_left + Point::new(0, y as i32);
        let mut band = Band::new(Rectangle::new(top_left, Size::new(area.size.width, height)), here).unwrap();
        picture.draw(&mut band);
        rest = below;
        y += height;
    }
    words
}

/// Draws the rectangles that have changed, and takes no pixel twice; those outside of the area are not on the display.
fn draw_damage(picture: &mut Prepared<'_, '_>, display: &mut [u16]) {
    let mut drawn = vec![false; display.len()];
    while let Some(area) = picture.next_damage() {
        let area = area.intersection(&AREA);
        for (point, word) in area.points().zip(in_bands(picture, area, &[1, 2])) {
            let Point { x, y } = point - AREA.top_left;
            let index = y as usize * AREA.size.width as usize + x as usize;
            assert!(!drawn[index], "{point} was drawn twice");
            (display[index], drawn[index]) = (word, true);
        }
    }
}

/// As much memory as any picture here needs.
fn with_picture<'a, R>(buckets: usize, test: impl FnOnce(&mut Prepared<'_, 'a>) -> R) -> R {
    let (mut slots, mut pool, mut buckets) = (vec![Slot::EMPTY; 256], vec![0; 6_000], vec![0; buckets]);
    test(&mut Prepared::new(AREA, &mut slots, &mut pool, &mut buckets))
}

proptest! {
    #![proptest_config(config(cases(1_000, 10_000)))]

    #[test]
    fn bands_of_any_height_show_what_replaying_shows(
        items in proptest::collection::vec(items(), 1..200),
        heights in proptest::collection::vec(1..9u32, 1..4),
        buckets in 0..60usize,
    ) {
        let expected = replayed(AREA, &items);
        with_picture(buckets, |picture| {
            for item in &items {
                item.add(picture).unwrap();
            }
            prop_assert_eq!(&in_bands(picture, AREA, &[1]), &expected);
            // Once more, from the top.
            prop_assert_eq!(&in_bands(picture, AREA, &heights), &expected);
            prop_assert_eq!(&in_bands(picture, AREA, &[1_000]), &expected);
            Ok(())
        })?;
    }

    /// A band of some columns and rows after the other, each where it falls.
    #[test]
    fn bands_in_any_order_show_what_replaying_shows(
        items in proptest::collection::vec(items(), 1..20),
        windows in proptest::collection::vec((points(), 1..30u32, 1..30u32), 1..12),
    ) {
        with_picture(17, |picture| {
            for item in &items {
                item.add(picture).unwrap();
            }
            for (top_left, width, height) in windows {
                let area = Rectangle::new(top_left, Size::new(width, height));
                // What lies outside of 16 bits is not drawn.
                let columns = i32::from(i16::MIN)..i32::from(i16::MAX) - 30;
                if columns.contains(&top_left.x) && columns.contains(&top_left.y) {
                    prop_assert_eq!(in_bands(picture, area, &[1, 3]), replayed(area, &items));
                }
            }
            Ok(())
        })?;
    }

    /// Areas anywhere, of any size, with any number of buckets; items are where they are.
    #[test]
    fn areas_anywhere_show_what_replaying_shows(
        items in proptest::collection::vec(items(), 1..6),
        (x, y) in (prop_oneof![any::<i32>(), i32::MAX - 50..=i32::MAX], prop_oneof![any::<i32>(), i32::MAX - 50..=i32::MAX]),
        (width, height, buckets) in (any_length(), any_length(), 0..50usize),
    ) {
        let far = Rectangle::new(Point::new(x, y), Size::new(width, height));
        let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 6], vec![0; 1_000], vec![0; buckets]);
        let mut picture = Prepared::new(far, &mut slots, &mut pool, &mut buckets);
        for item in &items {
            item.add(&mut picture).unwrap();
        }
        prop_assert_eq!(in_bands(&mut picture, AREA, &[1, 2]), replayed(AREA, &items));
        // As far as there are numbers.
        let start = Window::from(Rectangle::new(far.top_left, Size::new(width.min(4), height.min(12))));
        in_bands(&mut picture, start.to_rectangle(), &[1]);
    }

    /// Numbers of their whole type, in items and in the positions of bands.
    #[test]
    fn hostile_items_show_what_replaying_shows(
        items in proptest::collection::vec(hostile_items(), 1..12),
        (x, y) in (any::<i32>(), any::<i32>()),
        (height, buckets) in (1..5u32, 0..50usize),
    ) {
        with_picture(buckets, |picture| {
            for item in &items {
                item.add(picture).unwrap();
            }
            prop_assert_eq!(in_bands(picture, AREA, &[height]), replayed(AREA, &items));
            // Beyond 16 bits nothing is drawn.
            let far = Rectangle::new(Point::new(x, y), Size::new(5, 5));
            in_bands(picture, far, &[height]);
            Ok(())
        })?;
    }

    #[test]
    fn edited_pictures_show_what_replaying_shows(
        current in proptest::collection::vec(items(), 1..12),
        edits in proptest::collection::vec((any::<prop::sample::Index>(), proptest::option::weighted(0.8, items())), 1..12),
    ) {
        with_picture(47, |picture| {
            let mut shown: Vec<Option<&Item>> = current.iter().map(Some).collect();
            let ids: Vec<ItemId> = current.iter().map(|item| item.add(picture).unwrap()).collect();
            for (index, edit) in &edits {
                let index = index.index(shown.len());
                match edit {
                    Some(item) => item.replace(picture, ids[index]).unwrap(),
                    None => picture.remove(ids[index]),
                }
                shown[index] = edit.as_ref();
                prop_assert_eq!(in_bands(picture, AREA, &[2, 1]), replayed(AREA, shown.iter().copied().flatten()));
            }
            // No word is lost: the same items take as many words in a new picture.
            let used = picture.words_used();
            picture.clear();
            for item in shown.into_iter().flatten() {
                item.add(picture).unwrap();
            }
            prop_assert_eq!(picture.words_used(), used);
            Ok(())
        })?;
    }

    /// A display on which only the damage is drawn again.
    #[test]
    fn what_is_drawn_in_the_damage_is_the_whole_picture(
        current in proptest::collection::vec(items(), 1..12),
        edits in proptest::collection::vec((any::<prop::sample::Index>(), proptest::option::weighted(0.8, items())), 1..12),
        (rectangles, at_once, grid, clears) in (1..9usize, 1..4usize, (0..9u32, 0..9u32), any::<bool>()),
    ) {
        let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 24], vec![0; 2_000], [0; 47]);
        let mut areas = vec![Window::EMPTY; rectangles];
        let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets);
        let mut shown: Vec<Option<&Item>> = current.iter().map(Some).collect();
        let mut ids: Vec<ItemId> = current.iter().map(|item| item.add(&mut picture).unwrap()).collect();
        let mut picture = picture.with_damage(&mut areas, grid);
        let mut display = vec![0; (AREA.size.width * AREA.size.height) as usize];
        for edits in core::iter::once(&[][..]).chain(edits.chunks(at_once)) {
            for (index, edit) in edits {
                let index = index.index(shown.len() + 1);
                match (edit, ids.get(index)) {
                    (Some(item), Some(id)) => item.replace(&mut picture, *id).unwrap(),
                    (None, Some(id)) => picture.remove(*id),
                    (Some(item), None) => {
                        ids.push(item.add(&mut picture).unwrap());
                        shown.push(None);
                    }
                    (None, None) => continue,
                }
                shown[index] = edit.as_ref();
            }
            draw_damage(&mut picture, &mut display);
            prop_assert_eq!(&display, &replayed(AREA, shown.iter().copied().flatten()));
            // Nothing is drawn twice.
            prop_assert!(picture.next_damage().is_none());
        }
        if clears {
            picture.clear();
            shown.truncate(2);
            ids = shown.iter().flatten().map(|item| item.add(&mut picture).unwrap()).collect();
            draw_damage(&mut picture, &mut display);
            prop_assert_eq!(&display, &replayed(AREA, shown.iter().copied().flatten()));
            prop_assert_eq!(picture.slots_used(), ids.len());
        }
    }

    /// From no memory at all to enough.
    #[test]
    fn memory_of_every_size_is_enough_or_an_error_that_says_how_much_is_needed(
        items in proptest::collection::vec(items(), 1..8),
    ) {
        let (mut slots_needed, mut words_needed) = (0, 0);
        loop {
            let (mut slots, mut pool, mut buckets) = (vec![Slot::EMPTY; slots_needed], vec![0; words_needed], [0; 47]);
            let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets);
            let mut added = 0;
            let failure = items.iter().find_map(|item| {
                let result = item.add(&mut picture);
                added += usize::from(result.is_ok());
                result.err()
            });
            // Usable, whatever happened.
            prop_assert_eq!(in_bands(&mut picture, AREA, &[1]), replayed(AREA, &items[..added]));
            match failure {
                None => break,
                Some(InputError::TooSmall(TooSmall { table: Table::Items, needed })) => {
                    prop_assert!(needed == slots_needed + 1);
                    slots_needed = needed;
                }
                Some(InputError::TooSmall(TooSmall { table: Table::PictureWords, needed })) => {
                    prop_assert!(needed > words_needed);
                    words_needed = needed;
                }
                Some(other) => prop_assert!(false, "{other:?}"),
            }
        }
    }
}

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
        let style = PrimitiveStyleBuilder::new()
            .fill_color(Rgb565::RED)
            .stroke_color(Rgb565::GREEN)
            .stroke_width(1)
            .build();
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
