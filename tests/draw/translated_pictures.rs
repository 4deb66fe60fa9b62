//! Pictures whose items and groups are moved: the same pixels as the picture before it was moved, seen from the other side, in
//! bands of any height, and by the damage alone.

use embedded_graphics::{
    image::ImageRaw,
    mono_font::{MonoTextStyle, MonoTextStyleBuilder, ascii::FONT_6X10},
    pixelcolor::Rgb888,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, PrimitiveStyleBuilder, Rectangle, RoundedRectangle, Sector,
        Styled, Triangle,
    },
    text::Text,
};
use fixed::types::{U0F16, U24F8};
use proptest::prelude::*;
use zrow::{
    draw::{
        AntialiasingMemory, FillRule, Group, ItemId, MaskTextStyle, Path, PathCommand, Picture, PictureSlot, Polygon,
        PrimitiveStyle, StrokeAlignment, SubArc, SubEllipse, ThinCircle,
    },
    geometry::{InputError, Sub8, SubPoint, Window},
};
use zrow_scenes::fonts::DEJAVU_SANS_16;

use crate::{
    common::{cases, config},
    picture_display::{Display, in_bands},
};

const AREA: Rectangle = Rectangle::new(Point::new(-7, 3), Size::new(64, 50));
const PIXELS: usize = 64 * 50;

type Style = PrimitiveStyle<Rgb888>;
type Prepared<'m, 'a> = Picture<'m, 'a, Rgb888>;

/// Memory of a picture.
struct Memory<'a> {
    slots: [PictureSlot<'a, Rgb888>; 32],
    pool: [u32; 6_000],
    buckets: [u16; 50],
    areas: [Window; 8],
    antialiasing: AntialiasingMemory<65, 96, 24>,
    kept: [u32; 64],
}

impl Memory<'_> {
    const fn new() -> Self {
        Self {
            slots: [PictureSlot::EMPTY; 32],
            pool: [0; 6_000],
            buckets: [0; 50],
            areas: [Window::EMPTY; 8],
            antialiasing: AntialiasingMemory::new(),
            kept: [0; 64],
        }
    }
}

impl<'a> Memory<'a> {
    fn picture(&mut self) -> Prepared<'_, 'a> {
        Picture::new(AREA, &mut self.slots, &mut self.pool, &mut self.buckets)
            .with_damage(&mut self.areas, (1, 1))
            .with_antialiasing(&mut self.antialiasing)
            .with_group_rows(&mut self.kept)
    }
}

/// What an item is made of; each kind takes of it what it needs.
#[derive(Debug, Clone)]
struct Item {
    kind: u32,
    points: [Point; 4],
    size: Size,
    angles: (i32, i32),
    style: Style,
}

fn items() -> impl Strategy<Value = Item> {
    let point = || (-20..70, -20..70).prop_map(|(x, y)| Point::new(x, y));
    let points = [point(), point(), point(), point()];
    let size = (0..50u32, 0..50u32).prop_map(|(width, height)| Size::new(width, height));
    let color = || prop::option::of((1..=255u8, any::<u8>(), any::<u8>()).prop_map(|(r, g, b)| Rgb888::new(r, g, b)));
    let style = (color(), color(), 0..6u32).prop_map(|(fill, stroke, width)| {
        let mut style = PrimitiveStyleBuilder::new().stroke_width(width);
        if let Some(color) = fill {
            style = style.fill_color(color);
        }
        if let Some(color) = stroke {
            style = style.stroke_color(color);
        }
        style.build().into()
    });
    (0..KINDS, points, size, (0..360, -360..360), style).prop_map(|(kind, points, size, angles, style)| Item {
        kind,
        points,
        size,
        angles,
        style,
    })
}

const KINDS: u32 = 26;

/// A polyline, which a picture has by reference.
type ByReference<'a> = Styled<Polyline<'a>, Style>;

impl Item {
    fn by_reference(&self) -> ByReference<'_> {
        Polyline::new(&self.points).into_styled(self.style)
    }

    /// The style with one of the three alignments.
    fn aligned_style(&self) -> Style {
        use StrokeAlignment::{Center, Inside, Outside};
        let mut style = self.style;
        style.stroke_alignment = [Inside, Center, Outside][self.size.width as usize % 3];
        style
    }

    fn add<'a>(
        &self,
        picture: &mut Prepared<'_, 'a>,
        by_reference: &'a ByReference<'a>,
        image: &'a ImageRaw<'a, Rgb888>,
    ) -> Result<ItemId, InputError> {
        let Self {
            kind,
            points: [a, b, c, d],
            size,
            angles: (start, sweep),
            style,
        } = self;
        let (start, sweep) = ((*start as f32).deg(), (*sweep as f32).deg());
        let rectangle = Rectangle::new(*a, *size);
        let circle = Circle::new(*a, size.width);
        let ellipse = Ellipse::new(*a, *size);
        let triangle = Triangle::new(*a, *b, *c);
        let line = Line::new(*a, *b);
        let rounded = RoundedRectangle::new(rectangle, CornerRadii::new(Size::new(9, 5)));
        let arc = Arc::from_circle(circle, start, sweep);
        let color = style.fill_color.unwrap_or(Rgb888::RED);
        let plain = MonoTextStyle::new(&FONT_6X10, color);
        match kind {
            0 => picture.add(&rectangle.into_styled(*style)),
            1 => picture.add(&circle.into_styled(*style)),
            2 => picture.add(&ellipse.into_styled(*style)),
            3 => picture.add(&triangle.into_styled(*style)),
            4 => picture.add(&line.into_styled(*style)),
            5 => picture.add(&rounded.into_styled(*style)),
            6 => picture.add(&arc.into_styled(*style)),
            7 => picture.add(&Sector::from_circle(circle, start, sweep).into_styled(*style)),
            8 => picture.add(&ThinCircle::new(*a, size.width).into_styled(*style)),
            9 => picture.add(&Text::new("42 km", *a, plain)),
            10 => {
                let decorated = MonoTextStyleBuilder::from(&plain)
                    .background_color(Rgb888::BLUE)
                    .underline();
                picture.add(&Text::new("a\nb", *a, decorated.build()))
            }
            11 => picture.add(&Text::new("4\u{b0}\n7", *a, MaskTextStyle::new(&DEJAVU_SANS_16, color))),
            12 => picture.add(&circle.into_styled(style.antialiased())),
            13 => picture.add(&rounded.into_styled(style.antialiased())),
            14 => picture.add(&triangle.into_styled(style.antialiased())),
            15 => picture.add(&arc.into_styled(style.antialiased())),
            16 => {
                let center = SubPoint::<Sub8>::from_units(a.x * 256 + 77, a.y * 256 + 5).unwrap();
                let radii = [U24F8::from_num(size.height), U24F8::from_num(size.height + 4)];
                let arc = SubArc::new(
                    center,
                    radii,
                    U0F16::from_bits(start.to_degrees() as u16 * 99),
                    U0F16::from_bits(40_000),
                );
                picture.add_outline(&arc.unwrap(), FillRule::NonZero, color)
            }
            // Corners that are far from each other.
            17 => {
                let corners = [*a, *b * 8, *c * 5]
                    .map(SubPoint::<Sub8>::from_pixel)
                    .map(Result::unwrap);
                picture.add_outline(&[corners.as_slice()], FillRule::EvenOdd, color)
            }
            // Near corners and, in the other kind, far ones.
            18 | 19 => {
                let corners = [*a, *b * (*kind as i32 - 17), *c * (*kind as i32 * 4 - 71)];
                let mut style = *style;
                style.stroke_alignment = [StrokeAlignment::Inside, StrokeAlignment::Outside][size.width as usize % 2];
                let contours = [corners.as_slice()];
                picture.add(&Polygon::new(&contours, FillRule::EvenOdd).into_styled(style.antialiased()))
            }
            20 => picture.add_image(image, *a),
            // Whole pixels, and parts of them: near corners or far ones.
            21 => {
                let (first, second) = ([*a, *b, *c], [*d, *c, *a + Point::new(9, 5)]);
                let contours = [first.as_slice(), second.as_slice()];
                picture.add(&Polygon::new(&contours, FillRule::EvenOdd).into_styled(self.aligned_style()))
            }
            22 => {
                let corners = [*a, *b * 8, *c, *d].map(|pixel| {
                    let at = |pixel| (pixel * 256 + pixel * 77) / 2;
                    SubPoint::<Sub8>::from_units(at(pixel.x), at(pixel.y)).unwrap()
                });
                let contours = [corners.as_slice()];
                picture.add(&Polygon::new(&contours, FillRule::NonZero).into_styled(self.aligned_style()))
            }
            23 => {
                let [a, b, c, d] = self.points.map(SubPoint::<Sub8>::from_pixel).map(Result::unwrap);
                let commands = [
                    PathCommand::MoveTo(a),
                    PathCommand::CubicTo(b, c, d),
                    PathCommand::LineTo(b),
                    PathCommand::Close,
                ];
                let path = Path::new(&commands, FillRule::EvenOdd).unwrap();
                picture.add(&path.into_styled(*style))
            }
            24 => picture.add(&Polyline::new(&self.points).translate(*a).into_styled(*style)),
            _ => picture.add_item(by_reference),
        }
    }
}

proptest! {
    #![proptest_config(config(cases(500, 10_000)))]

    /// A picture whose items all move shows what it showed in an area moved the other way, and shows it again when they
    /// move back.
    #[test]
    fn a_moved_picture_is_the_picture_seen_from_elsewhere(
        items in prop::collection::vec(items(), 1..9),
        (x, y) in (-40..40, -40..40),
        height in 1..60u32,
    ) {
        let by = Point::new(x, y);
        let bytes: Vec<u8> = (0..11 * 7 * 3).map(|byte| byte as u8).collect();
        let image = ImageRaw::new(&bytes, 11);
        let by_reference: Vec<_> = items.iter().map(Item::by_reference).collect();
        let mut memory = Memory::new();
        let mut picture = memory.picture();
        let ids: Vec<_> = items
            .iter()
            .zip(&by_reference)
            .map(|(item, by_reference)| item.add(&mut picture, by_reference, &image).unwrap())
            .collect();
        let before = in_bands(&mut picture, AREA, &[height]);
        let mut display = Display { words: before.clone(), ..Display::new(AREA) };
        picture.clear_damage();
        let mut elsewhere = AREA;
        elsewhere.top_left -= by;
        let expected = in_bands(&mut picture, elsewhere, &[1]);
        for id in &ids {
            picture.translate(*id, by).unwrap();
        }
        prop_assert_eq!(&in_bands(&mut picture, AREA, &[1]), &expected);
        prop_assert_eq!(&in_bands(&mut picture, AREA, &[height]), &expected);
        display.draw_damage(&mut picture, &[1, 3]);
        prop_assert_eq!(&display.words, &expected);
        for id in &ids {
            picture.translate(*id, -by).unwrap();
        }
        prop_assert_eq!(&in_bands(&mut picture, AREA, &[height, 1]), &before);
    }

    /// The items of a group move, its clip does not.
    #[test]
    fn a_group_scrolls_in_its_clip(
        items in prop::collection::vec(items(), 1..5),
        (x, y) in (-40..40, -40..40),
    ) {
        let by = Point::new(x, y);
        let clip = Rectangle::new(Point::new(5, 9), Size::new(30, 25));
        let bytes = [7; 11 * 7 * 3];
        let image = ImageRaw::new(&bytes, 11);
        let by_reference: Vec<_> = items.iter().map(Item::by_reference).collect();
        let mut memory = Memory::new();
        let mut picture = memory.picture();
        let group = picture.begin_group(Group::new().clip(clip)).unwrap();
        for (item, by_reference) in items.iter().zip(&by_reference) {
            item.add(&mut picture, by_reference, &image).unwrap();
        }
        picture.end_group().unwrap();
        let words = in_bands(&mut picture, AREA, &[1]);
        let mut display = Display { words, ..Display::new(AREA) };
        picture.clear_damage();
        // The same items without a clip, seen from elsewhere.
        let mut moved_memory = Memory::new();
        let mut moved = moved_memory.picture();
        for (item, by_reference) in items.iter().zip(&by_reference) {
            item.add(&mut moved, by_reference, &image).unwrap();
        }
        let mut elsewhere = AREA;
        elsewhere.top_left -= by;
        let mut expected = in_bands(&mut moved, elsewhere, &[1]);
        for (point, word) in AREA.points().zip(&mut expected) {
            if !clip.contains(point) {
                *word = 0;
            }
        }
        picture.translate(group, by).unwrap();
        prop_assert_eq!(&in_bands(&mut picture, AREA, &[2]), &expected);
        display.draw_damage(&mut picture, &[1, 3]);
        prop_assert_eq!(&display.words, &expected);
    }
}

#[test]
fn what_cannot_be_moved_stays() {
    let mut memory = Memory::new();
    let mut picture = memory.picture();
    let fill = PrimitiveStyle::with_fill(Rgb888::WHITE);
    let group = picture.begin_group(Group::new()).unwrap();
    let near = picture.add(&AREA.into_styled(fill)).unwrap();
    let outline = picture
        .add(&Circle::new(Point::zero(), 20).into_styled(fill.antialiased()))
        .unwrap();
    let end = picture.end_group().unwrap();
    let wide = picture
        .add(&Rectangle::new(Point::zero(), Size::new(70_000, 1)).into_styled(fill))
        .unwrap();
    let before = in_bands(&mut picture, AREA, &[1]);
    picture.clear_damage();
    let out = |min, max| Err(InputError::OutOfDomain { min, max });
    let by = |x, y| Point::new(x, y);
    assert_eq!(picture.translate(near, by(40_000, 0)), out(-32_767, 32_765));
    assert_eq!(picture.translate(near, by(i32::MIN, i32::MAX)), out(-32_767, 32_765));
    // Of a rectangle that was cut off, nobody knows what would come into view.
    assert_eq!(picture.translate(wide, by(-1, 0)), out(-32_767, 32_765));
    assert_eq!(picture.translate(outline, by(0, -9_000)), out(-8_190, 8_190));
    // The whole group stays where one of its items has to.
    assert_eq!(picture.translate(group, by(9_000, 0)), out(-8_190, 8_190));
    assert_eq!(picture.translate(end, by(9_000, 0)), Ok(()));
    assert_eq!(picture.next_damage(), None);
    assert_eq!(in_bands(&mut picture, AREA, &[1]), before);
    assert_eq!(before.len(), PIXELS);
    picture.clear();
    assert_eq!(picture.translate(near, by(1, 1)), Err(InputError::NoSuchItem));
}

/// An item without pixels has none wherever it is: it is moved by any numbers, which its words need not hold.
#[test]
fn items_without_pixels_are_moved_by_any_numbers() {
    let fill = PrimitiveStyle::with_fill(Rgb888::WHITE);
    let by_reference = Rectangle::new(Point::new(3, 3), Size::zero()).into_styled(fill);
    let far = Rectangle::new(Point::new(40_000, 3), Size::new(4, 4)).into_styled(fill);
    let center = SubPoint::<Sub8>::from_units(-1_280, 0).unwrap();
    let disc = SubEllipse::circle(center, U24F8::ZERO).unwrap();
    let mut memory = Memory::new();
    let mut picture = memory.picture();
    let ids = [
        picture.add_item(&by_reference).unwrap(),
        picture.add_outline(&disc, FillRule::NonZero, Rgb888::WHITE).unwrap(),
        picture
            .add(&Text::new(
                "",
                Point::zero(),
                MaskTextStyle::new(&DEJAVU_SANS_16, Rgb888::WHITE),
            ))
            .unwrap(),
        picture
            .add(&Text::new(
                "",
                Point::zero(),
                MonoTextStyle::new(&FONT_6X10, Rgb888::WHITE),
            ))
            .unwrap(),
    ];
    let far = picture.add_item(&far).unwrap();
    picture.clear_damage();
    for id in ids {
        for by in [i32::MAX, i32::MAX, i32::MIN, i32::MIN] {
            assert_eq!(picture.translate(id, Point::new(by, 0)), Ok(()));
            assert_eq!(picture.translate(id, Point::new(0, by)), Ok(()));
        }
    }
    assert_eq!(picture.next_damage(), None);
    assert_eq!(in_bands(&mut picture, AREA, &[1]), [0; PIXELS]);
    // One that has pixels, if none that a picture can tell, stays where it is.
    let out = Err(InputError::OutOfDomain {
        min: -32_767,
        max: 32_765,
    });
    assert_eq!(picture.translate(far, Point::new(-39_990, 0)), out);
}
