//! Shapes and strokes in antialiased styles as items of a picture: the same as drawn into a band one after the other, in bands
//! of any height and order, and after any of them was replaced.

use embedded_graphics::{
    geometry::AngleUnit,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, Rectangle, RoundedRectangle, Sector, StrokeAlignment,
        Styled, Triangle,
    },
};
use fixed::types::U16F16;
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{
        Antialiased, AntialiasingMemory, DrawAntialiased, DrawOn, FillRule, ItemId, LineCap, LineJoin, Path,
        PathCommand, Picture, PictureSlot, Polygon, PrimitiveStyle, StrokeStyle,
    },
    geometry::{InputError, Sub4, SubPoint, TooSmall, Window},
};

use crate::{
    common::{cases, config},
    picture_display::Display,
};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(48, 40));
const WIDTH: usize = 48;
const BACKGROUND: Rgb565 = Rgb565::CSS_DARK_SLATE_GRAY;

type Style = Antialiased<PrimitiveStyle<Rgb565>>;

/// A shape in its style.
#[derive(Debug, Clone)]
enum Item {
    Rectangle(Styled<Rectangle, Style>),
    Rounded(Styled<RoundedRectangle, Style>),
    Circle(Styled<Circle, Style>),
    Ellipse(Styled<Ellipse, Style>),
    Triangle(Styled<Triangle, Style>),
    Line(Styled<Line, Style>),
    Arc(Styled<Arc, Style>),
    Sector(Styled<Sector, Style>),
    Polygon([Vec<Point>; 2], FillRule, Style),
    Path(Vec<PathCommand<Sub4>>, FillRule, Style),
    Stroke(Vec<Point>, u32, LineCap, LineJoin, Option<[U16F16; 2]>, Rgb565),
}

/// Calls a macro's body with whatever shape an item is.
macro_rules! with_shape {
    ($item:expr, |$shape:ident| $body:expr) => {
        match $item {
            Item::Rectangle($shape) => $body,
            Item::Rounded($shape) => $body,
            Item::Circle($shape) => $body,
            Item::Ellipse($shape) => $body,
            Item::Triangle($shape) => $body,
            Item::Line($shape) => $body,
            Item::Arc($shape) => $body,
            Item::Sector($shape) => $body,
            Item::Polygon(contours, fill_rule, style) => {
                let contours = contours.each_ref().map(Vec::as_slice);
                let $shape = &Polygon::new(&contours, *fill_rule).into_styled(*style);
                $body
            }
            Item::Path(commands, fill_rule, style) => {
                let $shape = &Path::new(commands, *fill_rule).unwrap().into_styled(*style);
                $body
            }
            Item::Stroke(vertices, width, cap, join, dashes, color) => {
                let lengths = dashes.unwrap_or_default();
                let mut style = StrokeStyle::new(*color, *width).cap(*cap).join(*join);
                if dashes.is_some() {
                    style = style.dashes(&lengths);
                }
                let $shape = &Polyline::new(vertices).into_styled(style.antialiased());
                $body
            }
        }
    };
}

impl Item {
    fn draw(&self, band: &mut Band<'_, Rgb565>, cells: &mut [i32]) {
        let mut target = band.antialiased::<5_120, 512>(cells);
        with_shape!(self, |shape| DrawAntialiased::draw_on(shape, &mut target).unwrap());
    }

    fn add(&self, picture: &mut Picture<'_, '_, Rgb565>) -> Result<ItemId, InputError> {
        with_shape!(self, |shape| picture.add(shape))
    }

    fn replace(&self, picture: &mut Picture<'_, '_, Rgb565>, id: ItemId) -> Result<(), InputError> {
        with_shape!(self, |shape| picture.replace(id, shape))
    }
}

fn items() -> impl Strategy<Value = Item> {
    let point = || (-15..60, -15..55).prop_map(|(x, y)| Point::new(x, y));
    let size = || (0..50u32, 0..50u32).prop_map(|(width, height)| Size::new(width, height));
    let color = || (0..32u8, 0..64u8, 0..32u8).prop_map(|(red, green, blue)| Rgb565::new(red, green, blue));
    let rectangle = move || (point(), size()).prop_map(|(corner, size)| Rectangle::new(corner, size));
    let alignment = prop_oneof![
        Just(StrokeAlignment::Inside),
        Just(StrokeAlignment::Center),
        Just(StrokeAlignment::Outside)
    ];
    let option = move || prop::option::weighted(0.8, color());
    let style = (option(), option(), 0..9u32, alignment).prop_map(|(fill, stroke, width, alignment)| {
        let mut style = PrimitiveStyle::default();
        (style.fill_color, style.stroke_color) = (fill, stroke);
        (style.stroke_width, style.stroke_alignment) = (width, alignment);
        style.antialiased()
    });
    let angle = || (-400..400i32).prop_map(|degrees| (degrees as f32).deg());
    let shape = (rectangle(), size(), [point(), point(), point()], angle(), angle(), 0..8);
    let outlines = outlines(style.clone());
    let shapes = (shape, style).prop_map(|((rectangle, radius, vertices, start, sweep, kind), style)| {
        let (corner, diameter) = (rectangle.top_left, rectangle.size.width);
        match kind {
            0 => Item::Rectangle(rectangle.into_styled(style)),
            1 => Item::Rounded(RoundedRectangle::new(rectangle, CornerRadii::new(radius)).into_styled(style)),
            2 => Item::Circle(Circle::new(corner, diameter).into_styled(style)),
            3 => Item::Ellipse(Ellipse::new(corner, rectangle.size).into_styled(style)),
            4 => Item::Triangle(Triangle::new(vertices[0], vertices[1], vertices[2]).into_styled(style)),
            5 => Item::Line(Line::new(vertices[0], vertices[1]).into_styled(style)),
            6 => Item::Arc(Arc::new(corner, diameter, start, sweep).into_styled(style)),
            _ => Item::Sector(Sector::new(corner, diameter, start, sweep).into_styled(style)),
        }
    });
    let cap = prop_oneof![
        Just(LineCap::WholePixel),
        Just(LineCap::Butt),
        Just(LineCap::Square),
        Just(LineCap::Round)
    ];
    let join = prop_oneof![Just(LineJoin::MITER), Just(LineJoin::Bevel), Just(LineJoin::Round)];
    let length = || (128..2_000u32).prop_map(|length| U16F16::from_bits(length << 8));
    let dashes = prop::option::of([length(), length()]);
    let strokes = (
        prop::collection::vec(point(), 2..6),
        1..9u32,
        cap,
        join,
        dashes,
        color(),
    )
        .prop_map(|(vertices, width, cap, join, dashes, color)| {
            Item::Stroke(vertices, width, cap, join, dashes, color)
        });
    prop_oneof![3 => shapes, 1 => strokes, 2 => outlines]
}

/// Polygons and paths: some corners lie in rows or columns with others.
fn outlines(style: impl Strategy<Value = Style> + Clone) -> impl Strategy<Value = Item> {
    let point = || {
        prop_oneof![
            (-15..60, -15..55),
            (0..4i32, 0..3i32).prop_map(|(x, y)| (x * 12, y * 15))
        ]
    };
    let contour = || prop::collection::vec(point().prop_map(|(x, y)| Point::new(x, y)), 0..6);
    let fill_rule = || prop_oneof![Just(FillRule::EvenOdd), Just(FillRule::NonZero)];
    let polygons = ([contour(), contour()], fill_rule(), style.clone())
        .prop_map(|(contours, fill_rule, style)| Item::Polygon(contours, fill_rule, style));
    let at = || point().prop_map(|(x, y)| SubPoint::from_units(x * 16 + 3, y * 16 - 5).unwrap());
    let command = prop_oneof![
        1 => at().prop_map(PathCommand::MoveTo),
        3 => at().prop_map(PathCommand::LineTo),
        1 => (at(), at()).prop_map(|(control, to)| PathCommand::QuadraticTo(control, to)),
        1 => Just(PathCommand::Close),
    ];
    let paths = (prop::collection::vec(command, 0..8), fill_rule(), style)
        .prop_map(|(commands, fill_rule, style)| Item::Path(commands, fill_rule, style));
    prop_oneof![polygons, paths]
}

/// The words of an area after drawing over a background.
fn words(area: Rectangle, draw: impl FnOnce(&mut Band<'_, Rgb565>)) -> Vec<u16> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    let mut band = Band::new(area, &mut words).unwrap();
    let background = AREA.into_styled(PrimitiveStyle::with_fill(BACKGROUND));
    let Ok(()) = background.draw_on(&mut band);
    draw(&mut band);
    words
}

fn drawn(items: &[Item]) -> Vec<u16> {
    let mut cells = vec![0; WIDTH + 1];
    words(AREA, |band| items.iter().for_each(|item| item.draw(band, &mut cells)))
}

proptest! {
    #![proptest_config(config(cases(150, 1_500)))]

    #[test]
    fn pictures_show_what_is_drawn_without_them(
        items in prop::collection::vec(items(), 1..6),
        other in items(),
        replaced: usize,
        bands in prop::collection::vec((0..40i32, 1..12u32, 0..40i32, 1..48u32), 1..8),
    ) {
        let mut items = items;
        let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 6], vec![0; 40_000], [0; 40]);
        let mut areas = [Window::EMPTY; 8];
        let mut memory = AntialiasingMemory::<30, 512, 24>::new();
        let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets)
            .with_antialiasing(&mut memory)
            .with_damage(&mut areas, (1, 1));
        let ids: Vec<_> = items.iter().map(|item| item.add(&mut picture).unwrap()).collect();
        let rows = (0..40).map(|y| (y, 1, 0, 48));
        let expected = drawn(&items);
        let mut display = Display { background: BACKGROUND, ..Display::new(AREA) };
        for (top, height, left, width) in rows.chain(bands) {
            let band = Rectangle::new(Point::new(left, top), Size::new(width, height)).intersection(&AREA);
            let found = words(band, |band| picture.draw(band));
            for (y, line) in band.rows().zip(found.chunks(band.size.width.max(1) as usize)) {
                let start = y as usize * WIDTH + band.top_left.x as usize;
                display.words[start..start + line.len()].copy_from_slice(line);
                prop_assert_eq!(line, &expected[start..start + line.len()], "row {} of {:?}", y, band);
            }
        }
        picture.clear_damage();
        let replaced = replaced % items.len();
        other.replace(&mut picture, ids[replaced]).unwrap();
        items[replaced] = other;
        display.draw_damage(&mut picture, &[1]);
        prop_assert_eq!(&display.words, &drawn(&items));
    }
}

/// Adds an item, or puts it in the place of another one, in a picture with memory of some capacities. Returns what the picture shows,
/// or the error.
fn shown_with<const CELLS: usize, const SEGMENTS: usize>(
    item: &Item,
    is_replaced: bool,
) -> Result<Vec<u16>, InputError> {
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], vec![0; 40_000], [0; 40]);
    let mut memory = AntialiasingMemory::<CELLS, SEGMENTS, 0>::new();
    let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
    if is_replaced {
        let square = Rectangle::new(Point::new(3, 3), Size::new(9, 9));
        let square = picture.add(&square.into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE)))?;
        item.replace(&mut picture, square)?;
    } else {
        item.add(&mut picture)?;
    }
    Ok(words(AREA, |band| picture.draw(band)))
}

proptest! {
    #![proptest_config(config(cases(4_000, 40_000)))]
    /// What is taken is shown, however little memory there is: also what needs cells alone, as discs and ellipses do.
    #[test]
    fn no_item_is_taken_and_not_shown(item in items(), is_replaced in any::<bool>()) {
        let expected = drawn(std::slice::from_ref(&item));
        for (cells, shown) in [
            (0, shown_with::<0, 0>(&item, is_replaced)),
            (1, shown_with::<1, 500>(&item, is_replaced)),
            (2, shown_with::<2, 0>(&item, is_replaced)),
            (2, shown_with::<2, 6>(&item, is_replaced)),
            (49, shown_with::<49, 500>(&item, is_replaced)),
        ] {
            match shown {
                Ok(shown) => prop_assert_eq!(shown.iter().zip(&expected).position(|(one, other)| one != other), None),
                Err(InputError::TooSmall(TooSmall::PictureCells(needed))) => prop_assert!(cells < needed && needed == 2),
                Err(InputError::TooSmall(TooSmall::Segments(_))) => prop_assert!(cells == 2),
                Err(error) => prop_assert!(false, "{}", error),
            }
        }
    }
}

/// A path's last contour may be a single point: the first one is convex all the same, and drawn by the method for those.
#[test]
fn a_contour_of_a_single_point_changes_nothing() {
    let point = |x: i32, y: i32| SubPoint::<Sub4>::from_units(x, y).unwrap();
    let commands = [
        PathCommand::QuadraticTo(point(851, 43), point(307, 155)),
        PathCommand::MoveTo(point(3, -5)),
    ];
    for fill_rule in [FillRule::EvenOdd, FillRule::NonZero] {
        let style = PrimitiveStyle::with_fill(Rgb565::new(21, 0, 0)).antialiased();
        for commands in [&commands[..1], &commands] {
            let item = Item::Path(commands.to_vec(), fill_rule, style);
            let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 400], [0; 40]);
            let mut memory = AntialiasingMemory::<49, 64, 16>::new();
            let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
            item.add(&mut picture).unwrap();
            assert_eq!(
                words(AREA, |band| picture.draw(band)),
                drawn(&[item]),
                "{fill_rule:?}, {commands:?}"
            );
        }
    }
}

/// What a picture needs, what it shows, and the first error.
type Needed = (usize, usize, Vec<u16>, Option<InputError>);

/// Three rings, a star and a needle, which share some rows, drawn row by row in memory of some capacities.
fn drawn_with<const SEGMENTS: usize, const EDGES: usize>() -> Needed {
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 5], vec![0; 1_000], [0; 40]);
    let mut memory = AntialiasingMemory::<49, SEGMENTS, EDGES>::new();
    let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
    let ring = PrimitiveStyle::with_stroke(Rgb565::RED, 3).antialiased();
    let ring = |(x, y, diameter)| Circle::new(Point::new(x, y), diameter).into_styled(ring);
    let rings = [(1, 1, 20), (12, 9, 29), (25, 2, 17)].map(ring);
    let mut added: Vec<_> = rings.iter().map(|ring| picture.add(ring)).collect();
    let star = [(24, 0), (30, 38), (2, 12), (46, 12), (18, 38), (24, 0)].map(|(x, y)| Point::new(x, y));
    added.push(picture.add(&Polyline::new(&star).into_styled(StrokeStyle::new(Rgb565::BLUE, 2).antialiased())));
    let needle = PrimitiveStyle::with_stroke(Rgb565::WHITE, 3).antialiased();
    added.push(picture.add(&Line::new(Point::new(5, 33), Point::new(40, 6)).into_styled(needle)));
    let rows = (0..40).map(|y| Rectangle::new(Point::new(0, y), Size::new(48, 1)));
    let pixels = rows.flat_map(|row| words(row, |band| picture.draw(band))).collect();
    let error = added.into_iter().find_map(Result::err);
    (picture.segments_needed(), picture.edges_needed(), pixels, error)
}

/// What a picture tells that it needs is enough, and one less is not.
#[test]
fn the_capacities_that_a_picture_needs_are_told() {
    let (_, edges, expected, _) = drawn_with::<500, 500>();
    assert_eq!(edges, 30);
    // Where no outline has room, its edges are counted.
    let (segments, ..) = drawn_with::<0, 0>();
    assert_eq!(segments, 16);
    let (_, edges, pixels, error) = drawn_with::<16, 30>();
    assert_eq!((edges, &pixels, error), (30, &expected, None));
    // Outlines that find no room are begun anew in each row.
    let (_, edges, pixels, error) = drawn_with::<16, 29>();
    assert!(edges > 29, "{edges}");
    assert_eq!((&pixels, error), (&expected, None));
    let (_, edges, pixels, error) = drawn_with::<16, 0>();
    assert!(edges > 0, "{edges}");
    assert_eq!((&pixels, error), (&expected, None));
    let too_small = TooSmall::Segments(16);
    assert_eq!(drawn_with::<15, 30>().3, Some(InputError::TooSmall(too_small)));
}
