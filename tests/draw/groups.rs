//! Groups of a picture, clipped by rectangles and by paths, and blended: the same as drawing their items on a copy and blending
//! that over what was there, in bands of any height and order, and after a group was replaced.

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{Gray8, Rgb565},
    prelude::*,
    primitives::{Circle, Ellipse, Line, PrimitiveStyleBuilder, Rectangle, Triangle},
    text::{Baseline, Text},
};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{
        AntialiasedPolygon, AntialiasingMemory, DrawAntialiased, DrawOn, DrawableItem, FillRule, Group, ItemId,
        Picture, PictureSlot, Polygon, PrimitiveStyle, SubEllipse, SubOutline,
    },
    fixed::types::U24F8,
    geometry::{InputError, Sub8, SubPoint, TooSmall, Window},
    shade::ChannelColor,
};

use crate::{
    common::{cases, config},
    picture_display::Display,
};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(40, 32));
const WIDTH: usize = 40;

/// Calls a macro's body with a shape of a kind.
macro_rules! with_shape {
    ($item:expr, |$shape:ident| $body:expr) => {{
        let Item {
            kind,
            vertices: [a, b, c],
            size,
            fill,
            stroke,
            width,
        } = $item;
        let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
            .fill_color(*fill)
            .stroke_color(*stroke)
            .stroke_width(*width)
            .build()
            .into();
        match kind {
            0 => {
                let $shape = &Rectangle::new(*a, *size).into_styled(style);
                $body
            }
            1 => {
                let $shape = &Circle::new(*a, size.width).into_styled(style);
                $body
            }
            2 => {
                let $shape = &Ellipse::new(*a, *size).into_styled(style);
                $body
            }
            3 => {
                let $shape = &Triangle::new(*a, *b, *c).into_styled(style);
                $body
            }
            4 => {
                let $shape = &Line::new(*a, *b).into_styled(style);
                $body
            }
            _ => {
                let text = MonoTextStyle::new(&FONT_6X10, *fill);
                let $shape = &Text::with_baseline("Ag4", *a, text, Baseline::Middle);
                $body
            }
        }
    }};
}

#[derive(Debug, Clone)]
struct Item {
    kind: u32,
    vertices: [Point; 3],
    size: Size,
    fill: Rgb565,
    stroke: Rgb565,
    width: u32,
}

/// The kind that is an antialiased circle.
const ANTIALIASED: u32 = 6;

/// The kind that is a polygon, whose edges are kept as chains.
const POLYGON: u32 = 7;

impl Item {
    fn antialiased(
        &self,
    ) -> embedded_graphics::primitives::Styled<Circle, zrow::draw::Antialiased<PrimitiveStyle<Rgb565>>> {
        let mut style = PrimitiveStyle::with_stroke(self.stroke, self.width);
        style.fill_color = Some(self.fill);
        Circle::new(self.vertices[0], self.size.width).into_styled(style.antialiased())
    }

    /// A polygon that crosses itself, with its style.
    fn with_polygon<R>(&self, call: impl FnOnce(&Polygon<'_, Point>, PrimitiveStyle<Rgb565>) -> R) -> R {
        let mut style = PrimitiveStyle::with_fill(self.fill);
        (style.stroke_color, style.stroke_width) = (Some(self.stroke), self.width);
        let [a, b, c] = self.vertices;
        let corners = [a, b, c, a + self.size, c - self.size];
        call(&Polygon::new(&[&corners], FillRule::EvenOdd), style)
    }

    fn draw(&self, band: &mut Band<'_, Rgb565>) {
        if self.kind == POLYGON {
            self.with_polygon(|polygon, style| {
                let prepared = polygon.prepare::<8, 8>().unwrap();
                let Ok(()) = prepared.into_styled(style).draw_on(band);
            });
        } else if self.kind == ANTIALIASED {
            let mut cells = [0; WIDTH + 1];
            self.antialiased()
                .draw_on(&mut band.antialiased::<512, 64>(&mut cells))
                .unwrap();
        } else {
            with_shape!(self, |shape| {
                let Ok(_) = shape.draw_on(band);
            });
        }
    }

    fn add(&self, picture: &mut Picture<'_, '_, Rgb565>) {
        if self.kind == POLYGON {
            self.with_polygon(|polygon, style| picture.add(&polygon.into_styled(style)).map(drop))
                .unwrap();
        } else if self.kind == ANTIALIASED {
            picture.add(&self.antialiased()).unwrap();
        } else {
            with_shape!(self, |shape| picture.add(shape).map(drop)).unwrap();
        }
    }
}

/// An item, or a group of them.
#[derive(Debug, Clone)]
enum Node {
    Item(Item),
    Group(Clip, Vec<Node>),
}

/// How a group is clipped and blended.
#[derive(Debug, Clone)]
struct Clip {
    rectangle: Rectangle,
    opacity: u8,
    path: Option<(ClipPath, FillRule)>,
}

/// A path by which a group is clipped, in 1/256 pixel.
#[derive(Debug, Clone)]
enum ClipPath {
    Polygon(Vec<SubPoint<Sub8>>),
    Ellipse(SubEllipse),
}

impl Clip {
    fn group(&self) -> Group {
        Group::new().clip(self.rectangle).opacity(self.opacity)
    }

    /// Of each pixel of the area, how much the group shows of itself there, out of 255.
    fn opacities(&self) -> Vec<u8> {
        let mut covered = vec![255; WIDTH * 32];
        if let Some((path, fill_rule)) = &self.path {
            covered.fill(0);
            path.with_outline(|outline| {
                let polygon = AntialiasedPolygon::<512, 200>::prepare(outline, *fill_rule).unwrap();
                let mut band = Band::<Gray8>::new(AREA, &mut covered).unwrap();
                polygon
                    .draw(
                        &polygon.exact_method(outline),
                        Gray8::WHITE,
                        &mut band,
                        &mut [0; WIDTH + 1],
                    )
                    .unwrap();
            });
        }
        let shown = |(point, coverage): (Point, u8)| {
            let opacity = f64::from(self.opacity) * f64::from(coverage) / 255.0;
            if self.rectangle.contains(point) {
                opacity.round() as u8
            } else {
                0
            }
        };
        AREA.points().zip(covered).map(shown).collect()
    }

    fn begin(&self, picture: &mut Picture<'_, '_, Rgb565>) -> Result<ItemId, InputError> {
        match &self.path {
            None => picture.begin_group(self.group()),
            Some((path, fill_rule)) => {
                path.with_outline(|outline| picture.begin_path_group(self.group(), outline, *fill_rule))
            }
        }
    }

    fn replace(&self, picture: &mut Picture<'_, '_, Rgb565>, id: ItemId) -> Result<(), InputError> {
        match &self.path {
            None => picture.replace_group(id, self.group()),
            Some((path, fill_rule)) => {
                path.with_outline(|outline| picture.replace_path_group(id, self.group(), outline, *fill_rule))
            }
        }
    }
}

impl ClipPath {
    fn with_outline<R>(&self, call: impl FnOnce(&dyn SubOutline) -> R) -> R {
        match self {
            Self::Polygon(corners) => call(&[corners.as_slice()]),
            Self::Ellipse(ellipse) => call(ellipse),
        }
    }
}

fn clips() -> impl Strategy<Value = Clip> + Clone {
    let opacity = prop_oneof![Just(0), Just(255), any::<u8>(), any::<u8>()];
    let point = (-12..50, -12..44).prop_map(|(x, y)| Point::new(x, y));
    let size = (0..40u32, 0..40u32).prop_map(|(width, height)| Size::new(width, height));
    let rectangle =
        prop_oneof![2 => (point, size).prop_map(|(corner, size)| Rectangle::new(corner, size)), 1 => Just(AREA)];
    let corner = (-3_000..14_000, -3_000..11_000).prop_map(|(x, y)| SubPoint::<Sub8>::from_units(x, y).unwrap());
    let radius = || (0..9_000u32).prop_map(U24F8::from_bits);
    let path = prop_oneof![
        prop::collection::vec(corner.clone(), 0..7).prop_map(ClipPath::Polygon),
        (corner, radius(), radius())
            .prop_map(|(center, across, down)| { ClipPath::Ellipse(SubEllipse::new(center, [across, down]).unwrap()) }),
    ];
    let rule = prop_oneof![Just(FillRule::NonZero), Just(FillRule::EvenOdd)];
    (rectangle, opacity, prop::option::of((path, rule))).prop_map(|(rectangle, opacity, path)| Clip {
        rectangle,
        opacity,
        path,
    })
}

fn nodes() -> impl Strategy<Value = Vec<Node>> {
    let point = || (-12..50, -12..44).prop_map(|(x, y)| Point::new(x, y));
    let size = || (0..40u32, 0..40u32).prop_map(|(width, height)| Size::new(width, height));
    let color = || (0..32u8, 0..64u8, 0..32u8).prop_map(|(red, green, blue)| Rgb565::new(red, green, blue));
    let item = (0..8u32, [point(), point(), point()], size(), color(), color(), 0..4u32).prop_map(
        |(kind, vertices, size, fill, stroke, width)| {
            Node::Item(Item {
                kind,
                vertices,
                size,
                fill,
                stroke,
                width,
            })
        },
    );
    let node = item.prop_recursive(3, 12, 4, move |inner| {
        (clips(), prop::collection::vec(inner, 0..4)).prop_map(|(clip, nodes)| Node::Group(clip, nodes))
    });
    prop::collection::vec(node, 1..5)
}

/// Adds nodes to a picture, and the ids of groups with their items.
fn add(nodes: &[Node], picture: &mut Picture<'_, '_, Rgb565>, groups: &mut Vec<ItemId>) {
    for node in nodes {
        match node {
            Node::Item(item) => item.add(picture),
            Node::Group(clip, nodes) => {
                groups.push(clip.begin(picture).unwrap());
                add(nodes, picture, groups);
                picture.end_group().unwrap();
            }
        }
    }
}

/// Draws nodes on all of the area.
fn draw(nodes: &[Node], frame: &mut [u16]) {
    for node in nodes {
        match node {
            Node::Item(item) => item.draw(&mut Band::new(AREA, frame).unwrap()),
            Node::Group(clip, nodes) => {
                let mut copy = frame.to_vec();
                draw(nodes, &mut copy);
                for ((index, point), opacity) in AREA.points().enumerate().zip(clip.opacities()) {
                    let [above, below] = [copy[index], frame[index]]
                        .map(|word| Rgb565::from(embedded_graphics::pixelcolor::raw::RawU16::new(word)));
                    frame[index] = above.over::<10>(below, opacity, point).into_storage();
                }
            }
        }
    }
}

/// Makes all groups others, in the order in which they begin.
fn change(nodes: &mut [Node], others: &mut impl Iterator<Item = Clip>, changed: &mut Vec<Clip>) {
    for node in nodes {
        if let Node::Group(clip, nodes) = node {
            let Clip {
                rectangle,
                opacity,
                path,
            } = others.next().unwrap();
            *clip = Clip {
                rectangle,
                opacity,
                // A clip path stays where no other one is given.
                path: path.or(clip.path.take()),
            };
            changed.push(clip.clone());
            change(nodes, others, changed);
        }
    }
}

proptest! {
    #![proptest_config(config(cases(300, 5_000)))]

    #[test]
    fn groups_are_blended_as_one_picture(
        nodes in nodes(),
        bands in prop::collection::vec((0..32i32, 1..12u32, 0..40i32, 1..40u32), 1..8),
        others in prop::collection::vec(clips(), 1..4),
    ) {
        let mut nodes = nodes;
        let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 100], [0; 9_000], [0; 32]);
        let mut areas = [Window::EMPTY; 8];
        let mut memory = AntialiasingMemory::<41, 200, 24>::new();
        let mut kept = [0; 5 * WIDTH];
        let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets)
            .with_antialiasing(&mut memory)
            .with_damage(&mut areas, (1, 1))
            .with_group_rows(&mut kept);
        let mut groups = Vec::new();
        add(&nodes, &mut picture, &mut groups);
        let mut expected = vec![0; WIDTH * 32];
        draw(&nodes, &mut expected);
        let mut display = vec![0; WIDTH * 32];
        for (top, height, left, width) in (0..32).map(|y| (y, 1, 0, 40)).chain(bands) {
            let area = Rectangle::new(Point::new(left, top), Size::new(width, height)).intersection(&AREA);
            let mut words = vec![0; (area.size.width * area.size.height) as usize];
            picture.draw(&mut Band::new(area, &mut words).unwrap());
            for (y, line) in area.rows().zip(words.chunks(area.size.width.max(1) as usize)) {
                let start = y as usize * WIDTH + area.top_left.x as usize;
                display[start..start + line.len()].copy_from_slice(line);
                prop_assert_eq!(line, &expected[start..start + line.len()], "row {} of {:?}", y, area);
            }
        }
        picture.clear_damage();
        let mut changed = Vec::new();
        change(&mut nodes, &mut others.into_iter().cycle(), &mut changed);
        for (id, clip) in groups.iter().zip(changed) {
            clip.replace(&mut picture, *id).unwrap();
        }
        while let Some(area) = picture.next_damage() {
            for y in area.rows() {
                let row = Rectangle::new(Point::new(area.top_left.x, y), Size::new(area.size.width, 1));
                let mut words = vec![0; area.size.width as usize];
                picture.draw(&mut Band::new(row, &mut words).unwrap());
                let start = y as usize * WIDTH + area.top_left.x as usize;
                display[start..start + words.len()].copy_from_slice(&words);
            }
        }
        let mut expected = vec![0; WIDTH * 32];
        draw(&nodes, &mut expected);
        prop_assert_eq!(display, expected);
    }
}

/// One row for the group, and one more for the group that lies in it; groups that are opaque or not shown need none, wherever they
/// lie.
#[test]
fn too_few_rows_are_an_error_that_says_how_many() {
    let too_small = |needed| Err(InputError::TooSmall(TooSmall::GroupWords(needed * WIDTH)));
    let (mut slots, mut pool, mut kept) = ([PictureSlot::EMPTY; 8], [0; 40], [0; WIDTH]);
    let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut []).with_group_rows(&mut kept);
    let (opaque, hidden) = (Group::new(), Group::new().opacity(0));
    let blended = |opacity| Group::new().opacity(opacity);
    let outer = picture.begin_group(opaque).unwrap();
    let group = picture.begin_group(blended(9)).unwrap();
    assert_eq!(picture.begin_group(blended(9)), too_small(2));
    assert_eq!((picture.slots_used(), picture.words_used()), (2, 10));
    let inner = picture.begin_group(hidden).unwrap();
    assert_eq!(picture.replace_group(group, blended(7)), Ok(()));
    assert_eq!(picture.replace_group(outer, blended(1)), too_small(2).map(drop));
    assert_eq!(picture.replace_group(inner, blended(1)), too_small(2).map(drop));
    picture.end_group().unwrap();
    picture.end_group().unwrap();
    // Beside the other one.
    picture.begin_group(blended(9)).unwrap();
    assert_eq!(picture.replace_group(outer, blended(1)), too_small(2).map(drop));
    assert_eq!(picture.replace_group(group, opaque), Ok(()));
    assert_eq!(picture.replace_group(inner, blended(1)), Ok(()));
    assert_eq!(picture.replace_group(outer, hidden), Ok(()));
}

/// An end without a beginning, a beginning without an end, and a beginning that was taken out.
#[test]
fn groups_without_one_of_their_ends() {
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 8], [0; 40]);
    let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut []);
    let frame = AREA.into_styled(PrimitiveStyle::with_fill(Rgb565::GREEN));
    let pixels = |picture: &mut Picture<'_, '_, Rgb565>| {
        let mut words = [0; WIDTH * 32];
        picture.draw(&mut Band::new(AREA, &mut words).unwrap());
        words
            .iter()
            .filter(|word| **word == Rgb565::GREEN.into_storage())
            .count()
    };
    picture.end_group().unwrap();
    let clip = Rectangle::new(Point::new(3, 4), Size::new(5, 6));
    let group = picture.begin_group(Group::new().clip(clip)).unwrap();
    picture.add(&frame).unwrap();
    assert_eq!(pixels(&mut picture), 30);
    picture.remove(group);
    assert_eq!(pixels(&mut picture), WIDTH * 32);
    assert_eq!(picture.replace_group(group, Group::new()), Err(InputError::NoSuchItem));
}

/// A group in another one, whose beginning is taken out: its end does not become that of the group around it.
#[test]
fn the_end_of_a_group_goes_with_its_beginning() {
    let square = |left, color| {
        Rectangle::new(Point::new(left, 0), Size::new(10, 10)).into_styled(PrimitiveStyle::with_fill(color))
    };
    let pixel = Rectangle::new(Point::zero(), Size::new_equal(1)).into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE));
    let clips = [Size::new(15, 5), Size::new(12, 2)].map(|size| Group::new().clip(Rectangle::new(Point::zero(), size)));
    for change in 0..3 {
        let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 7], [0; 12], [0; 32]);
        let mut damage = [Window::EMPTY; 4];
        let mut picture =
            Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut buckets).with_damage(&mut damage, (1, 1));
        picture.begin_group(clips[0]).unwrap();
        let inner = picture.begin_group(clips[1]).unwrap();
        picture.add(&square(0, Rgb565::RED)).unwrap();
        picture.end_group().unwrap();
        picture.add(&square(10, Rgb565::BLUE)).unwrap();
        picture.end_group().unwrap();
        picture.add(&square(20, Rgb565::GREEN)).unwrap();
        let mut display = Display::new(AREA);
        display.draw_damage(&mut picture, &[1]);
        match change {
            0 => picture.remove(inner),
            1 => picture.replace(inner, &pixel).unwrap(),
            _ => picture.replace_item(inner, &pixel).unwrap(),
        }
        display.draw_damage(&mut picture, &[1]);
        let expected = |Point { x, y }: Point| match x {
            0..10 if y < 5 => Rgb565::RED,
            10..15 if y < 5 => Rgb565::BLUE,
            20..30 if y < 10 => Rgb565::GREEN,
            _ => Rgb565::BLACK,
        };
        let expected: Vec<u16> = AREA.points().map(|point| expected(point).into_storage()).collect();
        assert_eq!(display.words, expected, "change {change}");
    }
}

/// What changes where a group begins or ends no more is drawn anew: all of its items, or all behind it.
#[test]
fn ends_that_are_taken_out_are_damage() {
    let square = |left, color| {
        Rectangle::new(Point::new(left, 2), Size::new(10, 10)).into_styled(PrimitiveStyle::with_fill(color))
    };
    let clip = Rectangle::new(Point::new(4, 4), Size::new(12, 3));
    let style = PrimitiveStyle::with_fill(Rgb565::WHITE);
    for change in 0..4 {
        let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 4], [0; 40], [0; 32]);
        let mut damage = [Window::EMPTY; 4];
        let mut picture =
            Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut buckets).with_damage(&mut damage, (1, 1));
        let begin = picture.begin_group(Group::new().clip(clip)).unwrap();
        picture.add(&square(2, Rgb565::RED)).unwrap();
        let end = picture.end_group().unwrap();
        picture.add(&square(14, Rgb565::BLUE)).unwrap();
        let mut display = Display::new(AREA);
        display.draw_damage(&mut picture, &[1]);
        match change {
            0 => picture.remove(begin),
            1 => picture.remove(end),
            2 => picture
                .replace(
                    begin,
                    &Rectangle::new(Point::zero(), Size::new_equal(1)).into_styled(style),
                )
                .unwrap(),
            _ => picture
                .replace(
                    end,
                    &Rectangle::new(Point::zero(), Size::new_equal(1)).into_styled(style),
                )
                .unwrap(),
        }
        display.draw_damage(&mut picture, &[1]);
        let mut words = [0; WIDTH * 32];
        picture.draw(&mut Band::new(AREA, &mut words).unwrap());
        let different = display.words.iter().zip(words).position(|(shown, word)| *shown != word);
        assert_eq!(different, None, "change {change}");
    }
}

/// Where the end of a group is taken out, the next one lies in it and has no row of its own: it is drawn opaque.
#[test]
fn a_group_without_a_row_is_opaque() {
    let (mut slots, mut pool, mut kept) = ([PictureSlot::EMPTY; 5], [0; 40], [0; WIDTH]);
    let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut []).with_group_rows(&mut kept);
    let frame = AREA.into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE));
    picture.begin_group(Group::new().opacity(9)).unwrap();
    let end = picture.end_group().unwrap();
    let group = picture.begin_group(Group::new().opacity(128)).unwrap();
    picture.add(&frame).unwrap();
    picture.end_group().unwrap();
    let first_pixel = |picture: &mut Picture<'_, '_, Rgb565>| {
        let mut words = [0; WIDTH];
        let row = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 1));
        picture.draw(&mut Band::new(row, &mut words).unwrap());
        words[0]
    };
    let white_over_black = |opacity| Rgb565::WHITE.over::<10>(Rgb565::BLACK, opacity, Point::zero());
    assert_eq!(first_pixel(&mut picture), white_over_black(128).into_storage());
    picture.remove(end);
    assert_eq!(first_pixel(&mut picture), white_over_black(9).into_storage());
    // Such a group cannot be changed either, before there are rows for it.
    let error = picture.replace_group(group, Group::new().opacity(64));
    assert_eq!(error, Err(InputError::TooSmall(TooSmall::GroupWords(2 * WIDTH))));
}

/// Ids of another picture, of one that was cleared, and of items that are no groups.
#[test]
fn wrong_ids_are_no_lack_of_memory() {
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 20], [0; 40]);
    let mut other = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut []);
    let frame = AREA.into_styled(PrimitiveStyle::with_fill(Rgb565::GREEN));
    let ids = [(); 9].map(|()| other.add(&frame).unwrap());
    let (mut slots, mut pool) = ([PictureSlot::EMPTY; 20], [0; 40]);
    let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut []);
    let group = picture.begin_group(Group::new()).unwrap();
    let item = picture.add(&frame).unwrap();
    let error = Err(InputError::NoSuchItem);
    let drawable = DrawableItem(frame);
    assert_eq!(picture.replace_group(item, Group::new()), error);
    assert_eq!(picture.replace(ids[8], &frame), error);
    assert_eq!(picture.replace_item(ids[8], &drawable), error);
    assert_eq!(picture.translate(ids[8], Point::new(1, 1)), error);
    assert_eq!(picture.replace_group(ids[8], Group::new()), error);
    picture.remove(ids[8]);
    assert_eq!((picture.slots_used(), picture.words_used()), (2, 5));
    picture.clear();
    assert_eq!(picture.translate(group, Point::new(1, 1)), error);
}

/// A band of rows so far above the picture that 1/256 of them are more than 32 bits tell, and one that begins above all rows of a
/// picture and ends in them.
#[test]
fn bands_above_all_rows_show_nothing_of_a_group_in_a_path() {
    let center = SubPoint::<Sub8>::from_units(0, -8_180 * 256).unwrap();
    let disc = SubEllipse::circle(center, U24F8::from_num(2)).unwrap();
    let frame = Rectangle::new(Point::new(-4, -32_768), Size::new(8, 32_768))
        .into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
    for buckets in [0, 4] {
        let (mut slots, mut pool, mut kept) = ([PictureSlot::EMPTY; 4], [0; 64], [0; WIDTH]);
        let (mut memory, mut buckets) = (AntialiasingMemory::<41, 8, 4>::new(), vec![0; buckets]);
        let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut pool, &mut buckets)
            .with_antialiasing(&mut memory)
            .with_group_rows(&mut kept);
        picture.add(&frame).unwrap();
        picture
            .begin_path_group(Group::new(), &disc, FillRule::NonZero)
            .unwrap();
        picture.end_group().unwrap();
        let mut red_pixels = |top| {
            let mut words = [0; 8 * 4];
            let area = Rectangle::new(Point::new(-4, top), Size::new(8, 4));
            picture.draw(&mut Band::new(area, &mut words).unwrap());
            words.iter().filter(|word| **word != 0).count()
        };
        assert_eq!([i32::MIN, -20_000_000, -32_772].map(&mut red_pixels), [0; 3]);
        assert_eq!([-32_770, -20_000_000, -32_768].map(&mut red_pixels), [16, 0, 32]);
    }
}

/// From the band to the picture's area there are more columns than 31 bits tell.
#[test]
fn a_band_far_left_of_the_area_shows_nothing_of_a_group() {
    let area = Rectangle::new(Point::new(i32::MAX - 10, 0), Size::new(10, 10));
    let (mut slots, mut pool, mut kept) = ([PictureSlot::EMPTY; 3], [0; 5], [0; 10]);
    let mut picture = Picture::<Rgb565>::new(area, &mut slots, &mut pool, &mut []).with_group_rows(&mut kept);
    let frame =
        Rectangle::new(Point::new(-20, 0), Size::new(40, 10)).into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
    picture.begin_group(Group::new().opacity(128)).unwrap();
    picture.add(&frame).unwrap();
    picture.end_group().unwrap();
    for left in [-20, -(1 << 30)] {
        let mut words = [0; 40];
        picture.draw(&mut Band::new(Rectangle::new(Point::new(left, 0), Size::new(40, 1)), &mut words).unwrap());
        assert_eq!(words, [0; 40]);
    }
}
