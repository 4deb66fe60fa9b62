//! Strokes in pictures along vertices that are far out, as far as a picture or a stroke can tell: moved into sight they are what
//! the moved shape is, or it is an error to move them.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Polyline, Rectangle, StrokeAlignment, Triangle},
};
use fixed::types::{U8F8, U16F16};
use zrow::{
    band::Band,
    draw::{
        AntialiasingMemory, DrawAntialiased, DrawOn, FillRule, ItemId, LineCap, LineJoin, Picture, PictureSlot,
        Polygon, PrimitiveStyle, StrokeStyle,
    },
    geometry::InputError,
};

use crate::{picture_display::in_bands, picture_items::AREA};

type Prepared<'m, 'a> = Picture<'m, 'a, Rgb565>;

/// A shape of three vertices in a style.
#[derive(Debug, Copy, Clone)]
struct Far {
    shape: u32,
    style: u32,
    vertices: [Point; 3],
}

const SHAPES: u32 = 6;
const STYLES: u32 = 18;
const DASHES: [U16F16; 2] = [U16F16::lit("7"), U16F16::lit("5")];

impl Far {
    fn stroke_style(&self) -> StrokeStyle<'static, Rgb565> {
        let style = StrokeStyle::new(Rgb565::RED, 1 + self.style % 3 * 2);
        match self.style / 3 {
            0 => style.cap(LineCap::Round).join(LineJoin::Round),
            1 => style.cap(LineCap::Square).dashes(&DASHES),
            _ => style.join(LineJoin::Miter { limit: U8F8::MAX }),
        }
    }

    fn primitive_style(&self) -> PrimitiveStyle<Rgb565> {
        use StrokeAlignment::{Center, Inside, Outside};
        let kind = self.style - 9;
        let mut style = PrimitiveStyle::with_stroke(Rgb565::RED, 1 + kind / 3 * 2);
        style.stroke_alignment = [Center, Inside, Outside][kind as usize % 3];
        style
    }
}

/// Evaluates an expression with the shape that a far one is.
macro_rules! with_shape {
    ($far:expr, |$shape:ident| $result:expr) => {{
        let [a, b, c] = $far.vertices;
        match $far.shape {
            0 => with_shape!(Line::new(a, b), $shape, $result),
            1 => with_shape!(Triangle::new(a, b, c), $shape, $result),
            2 => {
                let size = Size::new((b.x - a.x).unsigned_abs(), (b.y - a.y).unsigned_abs());
                with_shape!(Rectangle::new(a.component_min(b), size), $shape, $result)
            }
            3 => with_shape!(Polyline::new(&$far.vertices), $shape, $result),
            _ => {
                let contours = $far.contours();
                with_shape!(Polygon::new(&contours, FillRule::EvenOdd), $shape, $result)
            }
        }
    }};
    ($value:expr, $shape:ident, $result:expr) => {{
        let $shape = $value;
        $result
    }};
}

impl Far {
    fn is_in_stroke_style(&self) -> bool {
        self.style < 9
    }

    fn contours(&self) -> [&[Point]; 2] {
        match self.shape {
            4 => [self.vertices.as_slice(), &[]],
            _ => [&self.vertices[..2], &self.vertices[2..]],
        }
    }

    fn draw(&self, band: &mut Band<'_, Rgb565>) {
        if self.is_in_stroke_style() {
            let Ok(()) = with_shape!(self, |shape| shape.into_styled(self.stroke_style()).draw(band));
        } else if self.shape < 4 {
            let style = self.primitive_style();
            let [a, b, c] = self.vertices;
            let Ok(()) = match self.shape {
                0 => DrawOn::draw_on(&Line::new(a, b).into_styled(style), band),
                1 => DrawOn::draw_on(&Triangle::new(a, b, c).into_styled(style), band),
                2 => {
                    let size = Size::new((b.x - a.x).unsigned_abs(), (b.y - a.y).unsigned_abs());
                    DrawOn::draw_on(&Rectangle::new(a.component_min(b), size).into_styled(style), band)
                }
                _ => DrawOn::draw_on(&Polyline::new(&self.vertices).into_styled(style), band),
            };
        } else {
            let contours = self.contours();
            let prepared = Polygon::new(&contours, FillRule::EvenOdd).prepare::<64, 64>().unwrap();
            let Ok(()) = prepared.into_styled(self.primitive_style()).draw_on(band);
        }
    }

    fn add(&self, picture: &mut Prepared<'_, '_>) -> Result<ItemId, InputError> {
        with_shape!(self, |shape| if self.is_in_stroke_style() {
            picture.add(&shape.into_styled(self.stroke_style()))
        } else {
            picture.add(&shape.into_styled(self.primitive_style()))
        })
    }

    fn draw_antialiased(&self, band: &mut Band<'_, Rgb565>) {
        let mut cells = vec![0; 62];
        let target = &mut band.antialiased::<5_120, 512>(&mut cells);
        with_shape!(self, |shape| if self.is_in_stroke_style() {
            DrawAntialiased::draw_on(&shape.into_styled(self.stroke_style().antialiased()), target)
        } else {
            DrawAntialiased::draw_on(&shape.into_styled(self.primitive_style().antialiased()), target)
        })
        .unwrap();
    }

    fn add_antialiased(&self, picture: &mut Prepared<'_, '_>) -> Result<ItemId, InputError> {
        with_shape!(self, |shape| if self.is_in_stroke_style() {
            picture.add(&shape.into_styled(self.stroke_style().antialiased()))
        } else {
            picture.add(&shape.into_styled(self.primitive_style().antialiased()))
        })
    }
}

/// Where vertices are: as far out as a stroke is drawn uncut, beyond, also with another one 19 columns to the left that is not, and
/// beyond what a picture tells.
const FAR: [(i32, i32); 10] = [
    (16_300, 20),
    (16_403, 30),
    (-16_390, 30),
    (20_000, 20),
    (-20_000, 20),
    (30, 16_500),
    (20, -24_000),
    (25, -32_760),
    (-31_900, 31_900),
    (100_000, 20),
];

/// Adds strokes along far vertices and moves these into sight, or others of them. Where that is no error, the picture is what
/// drawing the moved shape is. Calls with whether it was moved.
fn check(
    draw: fn(&Far, &mut Band<'_, Rgb565>),
    add: fn(&Far, &mut Prepared<'_, '_>) -> Result<ItemId, InputError>,
    is_moved: &mut dyn FnMut(&Far, bool),
) {
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], vec![0; 20_000], vec![0; 47]);
    let mut memory = AntialiasingMemory::<62, 512, 64>::new();
    let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
    for (shape, style) in (0..SHAPES).flat_map(|shape| (0..STYLES).map(move |style| (shape, style))) {
        for (end, start) in FAR.into_iter().flat_map(|end| [(end, 0), (end, 1)]) {
            let end = Point::from(end);
            let start = if start == 0 {
                Point::new(3, 9)
            } else {
                end + Point::new(-19, 8)
            };
            let far = Far {
                shape,
                style,
                vertices: [start, end, start + Point::new(11, 23)],
            };
            for by in [Point::new(25, 28) - end, Point::new(1, 0), Point::new(17, 30) - start] {
                picture.clear();
                let Ok(id) = add(&far, &mut picture) else {
                    is_moved(&far, false);
                    continue;
                };
                if let Err(error) = picture.translate(id, by) {
                    assert!(matches!(error, InputError::OutOfDomain { .. }), "{error} of {far:?}");
                    is_moved(&far, false);
                    continue;
                }
                is_moved(&far, true);
                let moved = Far {
                    vertices: far.vertices.map(|vertex| vertex + by),
                    ..far
                };
                let mut expected = vec![0; 61 * 47];
                draw(&moved, &mut Band::<Rgb565>::new(AREA, &mut expected).unwrap());
                for heights in [[1], [7]] {
                    assert!(in_bands(&mut picture, AREA, &heights) == expected, "{far:?} by {by}");
                }
            }
        }
    }
}

#[test]
fn what_is_far_out_is_moved_into_sight_whole_or_not_at_all() {
    check(Far::draw, Far::add, &mut |far, is_moved| {
        let is_told = |vertex: &Point| vertex.x.abs().max(vertex.y.abs()) < 32_000;
        assert!(is_moved || !far.vertices.iter().all(is_told), "{far:?}");
    });
}

#[test]
fn what_is_far_out_and_antialiased_is_moved_into_sight_whole_or_not_at_all() {
    check(Far::draw_antialiased, Far::add_antialiased, &mut |far, is_moved| {
        let is_out = far
            .vertices
            .iter()
            .any(|vertex| vertex.x.abs().max(vertex.y.abs()) > 8_192);
        assert!(!is_moved || !is_out, "{far:?}");
    });
}

/// Strokes that are moved across the distance up to which they are drawn uncut are there what the moved shape is, and once they are
/// back what they were.
#[test]
fn what_is_moved_out_of_reach_is_the_moved_shape() {
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], vec![0; 20_000], vec![0; 47]);
    let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets);
    for (shape, style) in (0..SHAPES).flat_map(|shape| (0..STYLES).map(move |style| (shape, style))) {
        let vertices = [Point::new(8, 12), Point::new(51, 36), Point::new(30, 44)];
        for (x, y) in [(16_340, 0), (16_370, -7), (3, -16_410), (-16_392, 16_354), (20_000, 9)] {
            let stroke = Far { shape, style, vertices };
            picture.clear();
            let id = stroke.add(&mut picture).unwrap();
            for by in [Point::new(x, y), Point::zero()] {
                let moved = Far {
                    vertices: vertices.map(|vertex| vertex + by),
                    ..stroke
                };
                let back = if by == Point::zero() { -Point::new(x, y) } else { by };
                picture.translate(id, back).unwrap();
                let area = AREA.translate(by);
                let mut expected = vec![0; 61 * 47];
                moved.draw(&mut Band::<Rgb565>::new(area, &mut expected).unwrap());
                for heights in [[1], [7]] {
                    assert!(in_bands(&mut picture, area, &heights) == expected, "{moved:?}");
                }
            }
        }
    }
}
