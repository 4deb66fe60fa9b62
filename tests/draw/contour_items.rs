//! Polygons and paths as items of a picture: contours of whole pixels or of parts of them, with a fill, a stroke or both.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{DrawOn, FillRule, ItemId, Path, PathCommand, Polygon},
    geometry::{InputError, Sub4, Sub8, SubPixel, SubPoint, Vertex},
};

use crate::picture_items::{Prepared, Style};

/// As many lines as any path here is flattened to.
const LINES: usize = 3_000;

/// As many edges as any polygon here has.
const EDGES: usize = 256;

/// The corners of a star, the first one of which is its highest point.
pub const STAR: [(i32, i32); 10] = [
    (100, 3),
    (123, 71),
    (196, 72),
    (138, 115),
    (160, 184),
    (101, 193),
    (41, 185),
    (62, 116),
    (4, 73),
    (77, 70),
];

/// A polygon of some contours.
#[derive(Debug, Clone)]
pub struct ContourItem {
    pub contours: Vec<Vec<Point>>,
    /// Which vertices: whole pixels, or parts of 1/16, 1/256 or 1/65,536 pixel.
    pub precision: u32,
    pub rule: FillRule,
    pub style: Style,
}

/// A vertex in 1/65,536 pixel.
#[derive(Debug, Copy, Clone)]
pub struct Fine(pub i32, pub i32);

impl Vertex for Fine {
    const FRACTION_BITS: u32 = 16;

    fn x_units(&self) -> i32 {
        self.0
    }

    fn y_units(&self) -> i32 {
        self.1
    }
}

/// Units of a pixel's coordinate and of a part of it that is always the same, in a range.
fn units(pixel: i32, bits: u32, (min, max): (i32, i32)) -> i32 {
    let part = i64::from(pixel).wrapping_mul(0x9e37_79b9) & ((1 << bits) - 1);
    // Half of them are whole.
    let part = if pixel & 1 == 0 { part } else { 0 };
    ((i64::from(pixel) << bits) + part).clamp(min.into(), max.into()) as i32
}

fn sub<S: SubPixel>(point: Point) -> SubPoint<S> {
    let at = |pixel| units(pixel, S::FRACTION_BITS, (S::MIN_UNITS, S::MAX_UNITS));
    SubPoint::from_units(at(point.x), at(point.y)).unwrap()
}

fn fine(point: Point) -> Fine {
    let at = |pixel| units(pixel, 16, (i32::MIN, i32::MAX));
    Fine(at(point.x), at(point.y))
}

/// What is done with a polygon, whatever its vertices are.
pub trait Call {
    type Output;

    fn call<V: Vertex>(self, polygon: &Polygon<'_, V>) -> Self::Output;
}

impl ContourItem {
    pub fn with_polygon<A: Call>(&self, call: A) -> A::Output {
        match self.precision {
            0 => self.converted(|point| point, call),
            1 => self.converted(sub::<Sub4>, call),
            2 => self.converted(sub::<Sub8>, call),
            _ => self.converted(fine, call),
        }
    }

    fn converted<V: Vertex, A: Call>(&self, vertex: fn(Point) -> V, call: A) -> A::Output {
        let convert = |contour: &Vec<Point>| contour.iter().copied().map(vertex).collect::<Vec<_>>();
        let contours: Vec<_> = self.contours.iter().map(convert).collect();
        let contours: Vec<_> = contours.iter().map(Vec::as_slice).collect();
        call.call(&Polygon::new(&contours, self.rule))
    }

    pub fn draw(&self, band: &mut Band<'_, Rgb565>) {
        self.with_polygon(Draw(band, self.style));
    }

    pub fn add(&self, picture: &mut Prepared<'_, '_>) -> Result<ItemId, InputError> {
        self.with_polygon(Add(picture, self.style))
    }

    pub fn replace(&self, picture: &mut Prepared<'_, '_>, id: ItemId) -> Result<(), InputError> {
        self.with_polygon(Replace(picture, id, self.style))
    }
}

struct Draw<'b, 'w>(&'b mut Band<'w, Rgb565>, Style);

impl Call for Draw<'_, '_> {
    type Output = ();

    fn call<V: Vertex>(self, polygon: &Polygon<'_, V>) {
        let prepared = polygon.prepare::<EDGES, EDGES>().unwrap();
        let Ok(()) = prepared.into_styled(self.1).draw_on(self.0);
    }
}

struct Add<'p, 'm, 'a>(&'p mut Prepared<'m, 'a>, Style);

impl Call for Add<'_, '_, '_> {
    type Output = Result<ItemId, InputError>;

    fn call<V: Vertex>(self, polygon: &Polygon<'_, V>) -> Self::Output {
        self.0.add(&polygon.into_styled(self.1))
    }
}

struct Replace<'p, 'm, 'a>(&'p mut Prepared<'m, 'a>, ItemId, Style);

impl Call for Replace<'_, '_, '_> {
    type Output = Result<(), InputError>;

    fn call<V: Vertex>(self, polygon: &Polygon<'_, V>) -> Self::Output {
        self.0.replace(self.1, &polygon.into_styled(self.2))
    }
}

/// Polygons of a few contours with these vertices, which mostly cross themselves and each other.
pub fn contour_items(
    points: impl Strategy<Value = Point> + Clone + 'static,
    styles: impl Strategy<Value = Style> + Clone + 'static,
) -> impl Strategy<Value = ContourItem> + Clone {
    let contours = proptest::collection::vec(proptest::collection::vec(points, 0..8), 1..4);
    let rules = prop_oneof![Just(FillRule::EvenOdd), Just(FillRule::NonZero)];
    (contours, 0..4u32, rules, styles).prop_map(|(contours, precision, rule, style)| ContourItem {
        contours,
        precision,
        rule,
        style,
    })
}

/// A path of lines and curves.
#[derive(Debug, Clone)]
pub struct PathItem {
    pub commands: Vec<PathCommand<Sub8>>,
    pub rule: FillRule,
    pub style: Style,
}

impl PathItem {
    fn path(&self) -> Path<'_, Sub8> {
        Path::new(&self.commands, self.rule).unwrap()
    }

    pub fn draw(&self, band: &mut Band<'_, Rgb565>) {
        let prepared = self.path().prepare::<LINES, LINES>().unwrap();
        let Ok(()) = prepared.into_styled(self.style).draw_on(band);
    }

    pub fn add(&self, picture: &mut Prepared<'_, '_>) -> Result<ItemId, InputError> {
        picture.add(&self.path().into_styled(self.style))
    }

    pub fn replace(&self, picture: &mut Prepared<'_, '_>, id: ItemId) -> Result<(), InputError> {
        picture.replace(id, &self.path().into_styled(self.style))
    }
}

/// Paths of a few commands with these points.
pub fn path_items(
    points: impl Strategy<Value = Point> + Clone + 'static,
    styles: impl Strategy<Value = Style> + Clone + 'static,
) -> impl Strategy<Value = PathItem> + Clone {
    let point = move || points.clone().prop_map(sub::<Sub8>);
    let commands = prop_oneof![
        2 => point().prop_map(PathCommand::MoveTo),
        6 => point().prop_map(PathCommand::LineTo),
        2 => (point(), point()).prop_map(|(control, end)| PathCommand::QuadraticTo(control, end)),
        2 => (point(), point(), point()).prop_map(|(one, other, end)| PathCommand::CubicTo(one, other, end)),
        1 => Just(PathCommand::Close),
    ];
    let rules = prop_oneof![Just(FillRule::EvenOdd), Just(FillRule::NonZero)];
    (proptest::collection::vec(commands, 0..9), rules, styles).prop_map(|(commands, rule, style)| PathItem {
        commands,
        rule,
        style,
    })
}
