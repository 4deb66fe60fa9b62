//! Line drawings by the three methods for hidden lines: the teapot, two solids that go through each other, and a wireframe. What is
//! hidden is dashed, as in technical drawing, or left out.

use core::fmt::Write;

use embedded_graphics::{
    mono_font::ascii::FONT_5X8, pixelcolor::Rgb565, prelude::*, primitives::Rectangle, text::Alignment,
};
use fixed::types::{I2F14, I16F16, U0F16};
use heapless::{String, Vec};
use zrow::{
    band::{Band, Order},
    draw::FilteredLine,
    geometry::{Sub8, SubPoint, TooSmall, Window},
    scene::{Camera, Edge, FaceSet, Fine, Memory, Model, Pose, Rotation},
    visible::{Appel, FaceAgainstSegment, HiddenLines, LinePart, PartKind, Roberts},
};

use crate::{
    PrepareError, Prepared, Scene,
    meshes::{CUBE, TORUS_AND_CUBE, face_set},
    paint::{TITLE_COLOR, label, rgb},
    standard::{NEAR, model},
    teapot::TEAPOT,
    visibility::{panel::caption, solids::OCTAHEDRON_FACES},
};

const R: i16 = 700;
const OCTAHEDRON_VERTICES: [[i16; 3]; 6] = [[R, 0, 0], [-R, 0, 0], [0, R, 0], [0, -R, 0], [0, 0, R], [0, 0, -R]];
const OCTAHEDRON: FaceSet = face_set(&OCTAHEDRON_VERTICES, &OCTAHEDRON_FACES);

/// One colour for as many faces as any mesh has: lines have colours of their own.
static BLACK: [Rgb565; TEAPOT.faces().len()] = [Rgb565::BLACK; TEAPOT.faces().len()];

/// Positions at 1/256 pixel, as antialiased lines take them.
type Look = Fine<Rgb565>;
type Part = LinePart<Sub8>;

/// The edges of a mesh, whose number is given: to count them would take the compiler as long as to find them. Faces that turn
/// by more than the angle of a cosine meet in a crease.
macro_rules! edges {
    ($name:ident: $mesh:expr, $count:literal, $cosine:literal) => {
        static $name: [Edge; $count] = {
            let mesh: FaceSet = $mesh;
            match mesh.faces().first_chunk::<{ $mesh.faces().len() }>() {
                Some(faces) => match FaceSet::find_edges(mesh.vertices(), faces, I2F14::lit($cosine)) {
                    Ok(edges) => edges,
                    Err(_) => panic!("a face names a vertex that is not there"),
                },
                None => panic!("as many faces as there are"),
            }
        };
    };
}
edges!(TEAPOT_EDGES: TEAPOT, 1_506, "0.866");
edges!(CUBE_EDGES: CUBE, 12, "0.866");
edges!(OCTAHEDRON_EDGES: OCTAHEDRON, 12, "0.866");
edges!(WIRE_EDGES: TORUS_AND_CUBE, 876, "0.999");

/// The parts of the page in which the three drawings are: the teapot, the solids, the wireframe.
const AREAS: [Rectangle; 3] = [
    Rectangle::new(Point::new(6, 22), Size::new(256, 190)),
    Rectangle::new(Point::new(268, 22), Size::new(180, 190)),
    Rectangle::new(Point::new(454, 22), Size::new(180, 190)),
];
/// How long a dash is and how far the next one begins, in 1/256 pixel.
const DASH: i64 = 3 * 256;
const PERIOD: i64 = 5 * 256 + 128;

/// A drawing and its caption.
#[derive(Debug, Default)]
struct Drawing {
    parts: Vec<Part, 1_400>,
    counted: String<44>,
}

/// The drawings, and the memory in which they are prepared one after the other.
#[derive(Debug)]
pub struct HiddenLineDrawings {
    memory: Memory<Look, { TEAPOT.vertices().len() }, { TEAPOT.faces().len() }, 256, 240>,
    drawings: [Drawing; 3],
}

impl Default for HiddenLineDrawings {
    fn default() -> Self {
        Self {
            memory: Memory::new(),
            drawings: Default::default(),
        }
    }
}

impl Scene for HiddenLineDrawings {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "hidden-lines";
    const TITLE: &'static str = "hidden lines: three methods";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(640, 246));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        self.draw_teapot()?;
        self.draw_solids()?;
        self.draw_wireframe()?;
        Ok(self)
    }
}

impl HiddenLineDrawings {
    fn draw_teapot(&mut self) -> Result<(), PrepareError> {
        let [area, ..] = AREAS;
        let rotation = Rotation::about_y(U0F16::lit("0.07")).then(&Rotation::about_x(U0F16::lit("0.94")));
        let pot = model(TEAPOT, &BLACK).with_pose(Pose::new(rotation, [-50, -10, 720].map(I16F16::from_num)));
        let mut method = FaceAgainstSegment::<{ TEAPOT.faces().len() }, 16>::new();
        let [drawing, ..] = &mut self.drawings;
        drawing.fill(&mut self.memory, area, &[pot], &mut method, &[&TEAPOT_EDGES])?;
        let tested = method.faces_tested();
        drawing.say(format_args!(
            "{tested} faces tested, table of {} edges",
            TEAPOT_EDGES.len()
        ));
        Ok(())
    }

    fn draw_solids(&mut self) -> Result<(), PrepareError> {
        let [_, area, _] = AREAS;
        let turned = |x: U0F16, y: U0F16| Rotation::about_y(y).then(&Rotation::about_x(x));
        let at = |rotation, x: i32, y: i32| Pose::new(rotation, [x, y, 1450].map(I16F16::from_num));
        let cube = model(CUBE, &BLACK).with_pose(at(turned(U0F16::lit("0.93"), U0F16::lit("0.09")), -120, -130));
        let octahedron = at(turned(U0F16::lit("0.96"), U0F16::lit("0.05")), 330, 330);
        let octahedron = model(OCTAHEDRON, &BLACK).with_pose(octahedron);
        let mut method = Roberts::<2, 40>::new();
        let [_, drawing, _] = &mut self.drawings;
        let tables: [&[Edge]; 2] = [&CUBE_EDGES, &OCTAHEDRON_EDGES];
        drawing.fill(&mut self.memory, area, &[cube, octahedron], &mut method, &tables)?;
        drawing.say(format_args!("{} inequalities solved", method.inequalities()));
        Ok(())
    }

    fn draw_wireframe(&mut self) -> Result<(), PrepareError> {
        let [.., area] = AREAS;
        let rotation = Rotation::about_x(U0F16::lit("0.14")).then(&Rotation::about_y(U0F16::lit("0.06")));
        let torus = model(TORUS_AND_CUBE, &BLACK).with_pose(Pose::new(rotation, [0, 0, 1180].map(I16F16::from_num)));
        let mut method = Appel::<200, 64, 1024>::new();
        let [.., drawing] = &mut self.drawings;
        drawing.fill(&mut self.memory, area, &[torus], &mut method, &[&WIRE_EDGES])?;
        drawing.parts.retain(|part| !part.is_hidden);
        drawing.say(format_args!("{} rays for {} edges", method.rays(), method.edges()));
        Ok(())
    }
}

impl Drawing {
    /// Finds the parts of the edges of models, in an area of the picture.
    fn fill<const VERTICES: usize, const FACES: usize, const WIDTH: usize, const HEIGHT: usize>(
        &mut self,
        memory: &mut Memory<Look, VERTICES, FACES, WIDTH, HEIGHT>,
        area: Rectangle,
        models: &[Model<'_, Rgb565>],
        method: &mut impl HiddenLines<u16>,
        edges: &[&[Edge]],
    ) -> Result<(), PrepareError> {
        self.parts.clear();
        let mut dropped = 0;
        let camera = Camera::new(area, NEAR)?;
        memory.prepare(&camera, models)?.visible_parts(method, edges, |part| {
            dropped += usize::from(self.parts.push(part).is_err());
        })?;
        match dropped {
            0 => Ok(()),
            _ => Err(TooSmall::Edges(self.parts.len() + dropped).into()),
        }
    }

    /// The second line of the caption.
    fn say(&mut self, text: core::fmt::Arguments<'_>) {
        self.counted.clear();
        // Long enough for any number.
        let _ = self.counted.write_fmt(text);
    }
}

impl Prepared for HiddenLineDrawings {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let title = <Self as Scene>::TITLE;
        label(band, title, Point::new(8, 6), Alignment::Left, &FONT_5X8, TITLE_COLOR);
        let captions = [
            ["Face against segment", "(Galimberti and Montanari 1969)"],
            ["Roberts 1963", "yellow: where solids meet"],
            ["Appel 1967", "hidden parts left out"],
        ];
        for ((drawing, area), [method, about]) in self.drawings.iter().zip(AREAS).zip(captions) {
            let window = Window::from(band.bounding_box());
            if window.meets(&area.into()) {
                for part in drawing.parts.iter().filter(|part| part.is_hidden) {
                    draw_dashed(band, part);
                }
                for part in drawing.parts.iter().filter(|part| !part.is_hidden) {
                    draw_line(band, part.ends, color_of(part));
                }
            }
            let below = area.top_left + Point::new(0, area.size.height as i32);
            caption(band, below, [method, about, drawing.counted.as_str()]);
        }
    }
}

fn color_of(part: &Part) -> Rgb565 {
    match part.kind {
        PartKind::Silhouette => rgb(250, 250, 255),
        PartKind::Crease | PartKind::Boundary => rgb(120, 190, 250),
        PartKind::Intersection => rgb(255, 214, 80),
    }
}

fn draw_line<O: Order>(band: &mut Band<'_, Rgb565, O>, [start, end]: [SubPoint<Sub8>; 2], color: Rgb565) {
    if let Ok(line) = FilteredLine::new(start, end) {
        let Ok(()) = line.draw(band, color);
    }
}

/// A hidden part, dashed from its first end on.
fn draw_dashed<O: Order>(band: &mut Band<'_, Rgb565, O>, part: &Part) {
    let [from, to] = part.ends.map(|end| [end.x_units(), end.y_units()].map(i64::from));
    let ([x, y], [width, height]) = (from, [to[0] - from[0], to[1] - from[1]]);
    let length = ((width * width + height * height) as u64).isqrt() as i64;
    let point = |along: i64| {
        let [x, y] = [x + width * along / length, y + height * along / length];
        SubPoint::from_units(x as i32, y as i32)
    };
    for start in (0..length).step_by(PERIOD as usize) {
        if let (Ok(start), Ok(end)) = (point(start), point((start + DASH).min(length))) {
            draw_line(band, [start, end], rgb(84, 100, 124));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tables are neither too short, which the compiler says, nor filled up with edges that are none.
    #[test]
    fn tables_have_as_many_edges_as_there_are() {
        let count = |mesh: FaceSet| FaceSet::count_edges::<{ TEAPOT.faces().len() }>(mesh.vertices(), &padded(&mesh));
        let tables: [(&[Edge], FaceSet); 4] = [
            (&TEAPOT_EDGES, TEAPOT),
            (&CUBE_EDGES, CUBE),
            (&OCTAHEDRON_EDGES, OCTAHEDRON),
            (&WIRE_EDGES, TORUS_AND_CUBE),
        ];
        assert_eq!(
            tables.map(|(table, _)| table.len()),
            tables.map(|(_, mesh)| count(mesh))
        );
    }

    /// The faces of a mesh, and others without an area, which have no edges.
    fn padded(mesh: &FaceSet) -> [[u16; 3]; TEAPOT.faces().len()] {
        let mut faces = [[0; 3]; TEAPOT.faces().len()];
        for (slot, face) in faces.iter_mut().zip(mesh.faces()) {
            *slot = *face;
        }
        faces
    }
}
