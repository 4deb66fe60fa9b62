//! Strokes with caps, joins and dashes as items of a picture: of lines, rectangles, triangles, polylines, polygons and paths.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Polyline, Rectangle, Styled, Triangle},
};
use fixed::types::{I16F16, U8F8, U16F16};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{DrawOn, FillRule, ItemId, LineCap, LineJoin, Path, PathCommand, Polygon, StrokeStyle},
    geometry::{InputError, Sub8, SubPoint},
};

use crate::{
    picture_display::in_bands,
    picture_items::{AREA, Prepared, with_picture},
};

/// A stroke of a shape with these vertices.
#[derive(Debug, Clone)]
pub struct StrokeItem {
    /// Which shape the points are of.
    pub shape: u32,
    pub points: [Point; 4],
    pub color: Rgb565,
    pub width: u32,
    pub cap: LineCap,
    pub join: LineJoin,
    pub dashes: Option<Vec<U16F16>>,
    pub dash_offset: I16F16,
}

/// Evaluates an expression with the styled shape that an item is.
macro_rules! with_styled {
    ($item:expr, |$styled:ident| $result:expr) => {{
        let (item, style) = ($item, $item.style());
        let [a, b, c, d] = item.points;
        match item.shape % 6 {
            0 => with_styled!(Line::new(a, b), style, $styled, $result),
            1 => {
                let size = Size::new(b.x.unsigned_abs() % 70, b.y.unsigned_abs() % 5_000);
                with_styled!(Rectangle::new(inside(a), size), style, $styled, $result)
            }
            2 => with_styled!(Triangle::new(a, b, c), style, $styled, $result),
            3 => {
                let points = item.points.map(inside);
                let polyline = Polyline::new(&points).translate(Point::new(3, -2));
                with_styled!(polyline, style, $styled, $result)
            }
            4 => {
                let contours = [&item.points[..1], &item.points[1..]];
                with_styled!(Polygon::new(&contours, FillRule::NonZero), style, $styled, $result)
            }
            _ => {
                let [a, b, c, d] = [a, b, c, d].map(sub_pixel);
                let commands = [
                    PathCommand::MoveTo(a),
                    PathCommand::LineTo(b),
                    PathCommand::QuadraticTo(c, d),
                    PathCommand::Close,
                    PathCommand::MoveTo(c),
                    PathCommand::LineTo(a),
                ];
                with_styled!(
                    Path::new(&commands, FillRule::NonZero).unwrap(),
                    style,
                    $styled,
                    $result
                )
            }
        }
    }};
    ($shape:expr, $style:ident, $styled:ident, $result:expr) => {{
        let shape = $shape;
        let $styled = shape.into_styled($style);
        $result
    }};
}

/// A pixel so far inside the number range that what it is moved by, or a size, does not lead out of it.
fn inside(pixel: Point) -> Point {
    let limited = |coordinate: i32| coordinate.clamp(-1 << 30, 1 << 30);
    Point::new(limited(pixel.x), limited(pixel.y))
}

/// A position near a pixel: half of them are whole.
fn sub_pixel(pixel: Point) -> SubPoint<Sub8> {
    let units = |pixel: i32| (pixel.clamp(-8_000, 8_000) << 8) + (pixel & 1) * 77;
    SubPoint::from_units(units(pixel.x), units(pixel.y)).unwrap()
}

impl StrokeItem {
    fn style(&self) -> StrokeStyle<'_, Rgb565> {
        let mut style = StrokeStyle::new(self.color, self.width).cap(self.cap).join(self.join);
        style.dashes = self.dashes.as_deref();
        style.dash_offset(self.dash_offset)
    }

    pub fn draw(&self, band: &mut Band<'_, Rgb565>) {
        let Ok(()) = with_styled!(self, |styled| styled.draw_on(band));
    }

    pub fn add(&self, picture: &mut Prepared<'_, '_>) -> Result<ItemId, InputError> {
        with_styled!(self, |styled| picture.add(&styled))
    }

    pub fn replace(&self, picture: &mut Prepared<'_, '_>, id: ItemId) -> Result<(), InputError> {
        with_styled!(self, |styled| picture.replace(id, &styled))
    }
}

/// Strokes of all kinds with these vertices.
pub fn stroke_items(
    points: impl Strategy<Value = Point> + Clone + 'static,
    colors: impl Strategy<Value = Rgb565> + Clone + 'static,
) -> impl Strategy<Value = StrokeItem> + Clone {
    use LineCap::{Butt, Round, Square, WholePixel};
    let four_points = [points.clone(), points.clone(), points.clone(), points];
    let joins = prop_oneof![
        any::<u16>().prop_map(|bits| LineJoin::Miter {
            limit: U8F8::from_bits(bits)
        }),
        Just(LineJoin::MITER),
        Just(LineJoin::Bevel),
        Just(LineJoin::Round),
    ];
    let lengths = prop_oneof![4 => 65_536..800_000u32, 1 => 9_000..90_000u32, 1 => Just(0)].prop_map(U16F16::from_bits);
    let dashes = proptest::option::of(proptest::collection::vec(lengths, 0..4));
    let widths = prop_oneof![3 => 0..4u32, 1 => 0..30u32];
    let caps = prop_oneof![Just(WholePixel), Just(Butt), Just(Square), Just(Round)];
    let ends = (caps, joins, dashes, any::<i32>());
    (any::<u32>(), four_points, colors, widths, ends).prop_map(
        |(shape, points, color, width, (cap, join, dashes, offset))| StrokeItem {
            shape,
            points,
            color,
            width,
            cap,
            join,
            dashes,
            dash_offset: I16F16::from_bits(offset),
        },
    )
}

/// A stroke takes 11 words, one for each length of its dashes, two for how far it was moved, one for each path, and two for each
/// vertex, twice as many with dashes; two for each dash, segment or join, and 19 for each polygon and 5 for each disc of the row with
/// the most of them.
#[test]
fn words_of_a_stroke() {
    let dashes = [U16F16::lit("3"), U16F16::lit("5")];
    let [a, b, c] = [(2, 8), (40, 8), (40, 40)].map(Point::from);
    let style = StrokeStyle::new(Rgb565::RED, 3);
    let contours = |vertices: usize| 2 + 1 + 2 * vertices;
    with_picture(47, |picture| {
        let mut used = 0;
        let mut words =
            |picture: &Prepared<'_, '_>| picture.words_used() - core::mem::replace(&mut used, picture.words_used());
        picture.add(&Line::new(a, b).into_styled(style)).unwrap();
        assert_eq!(words(picture), 11 + contours(2) + 2 + 19);
        // Five dashes side by side, with two discs each.
        let round = style.dashes(&dashes).cap(LineCap::Round);
        picture.add(&Line::new(a, b).into_styled(round)).unwrap();
        assert_eq!(words(picture), 11 + 2 + contours(2) + 4 + 5 * (2 + 19 + 2 * 5));
        // Segments and joins of a triangle: two of each, or one segment and two joins, are in any row.
        picture.add(&Triangle::new(a, b, c).into_styled(style)).unwrap();
        let of_triangle = words(picture);
        assert_eq!((of_triangle - 11 - contours(3) - 6 * 2) % 19, 0);
        // More dashes than are kept in a list: the style alone.
        let many = style.dashes(&DENSE);
        for (length, is_kept) in [(64, true), (65, false)] {
            let line = Line::new(Point::new(0, 7), Point::new(length, 7));
            let before = picture.words_used();
            picture.add(&line.into_styled(many)).unwrap();
            let words = picture.words_used() - before;
            assert_eq!(words == 5 + 2 + contours(2), !is_kept, "{words} for {length}");
        }
        // What has no pixels takes no words.
        let before = picture.words_used();
        picture
            .add(&Line::new(a, b).into_styled(StrokeStyle::new(Rgb565::RED, 0)))
            .unwrap();
        assert_eq!(picture.words_used(), before);
    });
}

/// Dashes of half a pixel.
const DENSE: [U16F16; 2] = [U16F16::lit("0.5"); 2];

/// The copy lives on when the vertices and the lengths of the dashes are gone.
#[test]
fn vertices_and_dashes_may_be_dropped() {
    let points = vec![Point::new(2, 8), Point::new(40, 12), Point::new(7, 40)];
    let dashes = vec![U16F16::lit("3"), U16F16::lit("2")];
    fn styled<'s>(points: &'s [Point], dashes: &'s [U16F16]) -> Styled<Polyline<'s>, StrokeStyle<'s, Rgb565>> {
        Polyline::new(points).into_styled(StrokeStyle::new(Rgb565::RED, 2).dashes(dashes))
    }
    let mut expected = vec![0; 61 * 47];
    let mut band = Band::<Rgb565>::new(AREA, &mut expected).unwrap();
    let Ok(()) = styled(&points, &dashes).draw_on(&mut band);
    with_picture(47, |picture| {
        picture.add(&styled(&points, &dashes)).unwrap();
        drop((points, dashes));
        assert_eq!(in_bands(picture, AREA, &[1]), expected);
        assert!(expected.contains(&Rgb565::RED.into_storage()));
    });
}

/// Vertices beyond the number range cannot be copied, and the picture is as it was.
#[test]
fn vertices_beyond_the_number_range_are_an_error() {
    let at = |x| Line::new(Point::new(x, 3), Point::new(x, 9));
    let style = StrokeStyle::new(Rgb565::RED, 3);
    with_picture(47, |picture| {
        picture.add(&at(i32::MAX).into_styled(style)).unwrap();
        let (words, slots) = (picture.words_used(), picture.slots_used());
        let points = [Point::new(i32::MAX, 3), Point::new(0, 9)];
        let moved = Polyline::new(&points).translate(Point::new(1, 0)).into_styled(style);
        let (min, max) = (i32::MIN, i32::MAX);
        assert_eq!(picture.add(&moved), Err(InputError::OutOfDomain { min, max }));
        assert_eq!((picture.words_used(), picture.slots_used()), (words, slots));
    });
}
