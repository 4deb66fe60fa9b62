//! A cut gem three times: its vertices as points, its edges as antialiased lines, and its facets filled.

use core::fmt;

use embedded_graphics::{
    mono_font::ascii::FONT_5X8, pixelcolor::Rgb565, prelude::*, primitives::Rectangle, text::Alignment,
};
use fixed::types::{I2F14, I16F16, U0F16};
use zrow::{
    band::{Band, Order},
    draw::{DrawOn, FilteredLine, PrimitiveStyle},
    scene::{self, Camera, Edge, FaceSet, Fine, Memory, Model, Pose, Rotation},
    shade::{FlatLit, FlatLitSkin, Lambert},
};

use crate::{
    PrepareError, Prepared, Scene,
    meshes::face_set,
    paint::{label, rgb},
    sine::TURN,
    standard::{NEAR, angle, model},
    teapots::{one_light, shaded},
};

/// The look of what is drawn as points and lines: vertices in 1/256 pixel, of which only the places are asked for.
type Outlined = Fine<Rgb565>;
/// The look of what is filled.
type Filled = FlatLit<Rgb565>;

const COLUMNS: usize = 320;
const ROWS: usize = 120;
const FRAMES: u32 = 64;
const DISTANCE: I16F16 = I16F16::lit("1960");
/// From the middle of one gem to that of the next, in units of the vertices.
const ASIDE: I16F16 = I16F16::lit("1130");

/// The captions below the three gems, each with the column of the picture on which it is centred.
const CAPTIONS: [(&str, i32); 3] = [("vertices", 63), ("edges", 160), ("facets", 257)];

const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const DIM: Rgb565 = rgb(96, 148, 150);
const BRIGHT: Rgb565 = rgb(196, 244, 232);
static COLOR: [Rgb565; 1] = [rgb(52, 214, 178)];
/// A light from the left before the gem, so that its table is darker than the facets of its crown.
const LIGHT: Lambert<1> = one_light(
    U0F16::lit("0.16"),
    [I16F16::lit("-0.6"), I16F16::lit("0.25"), I16F16::lit("-0.9")],
    U0F16::lit("0.84"),
);

/// The table above, the girdle around the middle, and the culet below.
#[rustfmt::skip]
const VERTICES: [[i16; 3]; 17] = [
    [-110, 250, -264], [-264, 250, -110], [-264, 250, 110], [-110, 250, 264],
    [110, 250, 264], [264, 250, 110], [264, 250, -110], [110, 250, -264],
    [-200, 80, -480], [-480, 80, -200], [-480, 80, 200], [-200, 80, 480],
    [200, 80, 480], [480, 80, 200], [480, 80, -200], [200, 80, -480],
    [0, -430, 0],
];

/// The table, the crown's trapezoids from girdle to table, and the pavilion's triangles from girdle to culet.
#[rustfmt::skip]
const FACETS: [&[u16]; 17] = [
    &[0, 1, 2, 3, 4, 5, 6, 7],
    &[8, 9, 1, 0], &[9, 10, 2, 1], &[10, 11, 3, 2], &[11, 12, 4, 3],
    &[12, 13, 5, 4], &[13, 14, 6, 5], &[14, 15, 7, 6], &[15, 8, 0, 7],
    &[9, 8, 16], &[10, 9, 16], &[11, 10, 16], &[12, 11, 16],
    &[13, 12, 16], &[14, 13, 16], &[15, 14, 16], &[8, 15, 16],
];

const FACES: [[u16; 3]; FaceSet::count_triangles(&FACETS)] = match FaceSet::triangulate(&VERTICES, &FACETS) {
    Ok(faces) => faces,
    Err(_) => panic!("a facet is not planar or not convex"),
};

/// The edges between facets. Diagonals that cut a facet into triangles are none, because both sides lie in one plane.
static EDGES: [Edge; FaceSet::count_edges(&VERTICES, &FACES)] =
    match FaceSet::find_edges(&VERTICES, &FACES, I2F14::lit("0.99")) {
        Ok(edges) => edges,
        Err(_) => panic!("a face names a vertex that is not there"),
    };

const GEM: FaceSet<'static> = face_set(&VERTICES, &FACES);

/// The normals of the faces, on an octahedron.
static NORMALS: [[i8; 2]; FACES.len()] = {
    let mut normals = [[0; 2]; FACES.len()];
    let mut face = 0;
    while face < FACES.len() {
        let [a, b, c] = FACES[face];
        normals[face] = normal(VERTICES[a as usize], VERTICES[b as usize], VERTICES[c as usize]);
        face += 1;
    }
    normals
};

/// The outer normal of a face, the cross product of two sides, on an octahedron.
const fn normal(a: [i16; 3], b: [i16; 3], c: [i16; 3]) -> [i8; 2] {
    let (u, v) = (difference(a, b), difference(a, c));
    let [x, y, z] = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    let sum = x.abs() + y.abs() + z.abs();
    let (across, up) = if z < 0 {
        // Either sign where it is 0.
        ((sum - y.abs()) * (x | 1).signum(), (sum - x.abs()) * (y | 1).signum())
    } else {
        (x, y)
    };
    [(across * 127 / sum) as i8, (up * 127 / sum) as i8]
}

const fn difference(from: [i16; 3], to: [i16; 3]) -> [i32; 3] {
    [
        to[0] as i32 - from[0] as i32,
        to[1] as i32 - from[1] as i32,
        to[2] as i32 - from[2] as i32,
    ]
}

/// The scene: two gems that are drawn as points and as lines, and one that is filled.
pub struct Gem {
    outlined: Memory<Outlined, { 2 * VERTICES.len() }, { 2 * FACES.len() }, COLUMNS, ROWS, 1>,
    filled: Memory<Filled, { VERTICES.len() }, { FACES.len() }, COLUMNS, ROWS, 16>,
    outlined_models: [Model<'static, Rgb565>; 2],
    filled_models: [Model<'static, Filled>; 1],
}

impl fmt::Debug for Gem {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Gem").finish_non_exhaustive()
    }
}

impl Default for Gem {
    fn default() -> Self {
        let skin = FlatLitSkin {
            colors: &COLOR,
            normals: NORMALS.as_slice(),
            lights: LIGHT,
        };
        Self {
            outlined: Memory::new(),
            filled: Memory::new(),
            outlined_models: [const { model(face_set(&VERTICES, &FACES), &[DIM; FACES.len()]) }; 2],
            filled_models: [shaded(GEM, skin)],
        }
    }
}

/// A frame of the scene: what is drawn beside a gem that is filled.
pub struct Beside<'s, P> {
    outlined: scene::Prepared<'s, 'static, Outlined>,
    filled: P,
}

impl Scene for Gem {
    type Color = Rgb565;
    type Prepared<'s> = Beside<'s, scene::Prepared<'s, 'static, Filled>>;
    const NAME: &'static str = "gem";
    const TITLE: &'static str = "a gem as points, as lines and filled";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(COLUMNS as u32, ROWS as u32));
    const BACKGROUND: Rgb565 = rgb(14, 18, 28);
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = 7;
    const DEPTH_ROW_BYTES: usize = 2 * size_of::<[u16; COLUMNS]>();

    fn prepare(&mut self, frame: u32) -> Result<Self::Prepared<'_>, PrepareError> {
        // It looks the same after a quarter of a turn.
        let turn = Rotation::about_y(angle(frame % FRAMES * (TURN / 4 / FRAMES)));
        let rotation = turn.then(&Rotation::about_x(angle(TURN - 40)));
        let pose = |x| Pose::new(rotation, [x, I16F16::ZERO, DISTANCE]);
        let [points, lines] = &mut self.outlined_models;
        points.pose = pose(-ASIDE);
        lines.pose = pose(I16F16::ZERO);
        let [filled] = &mut self.filled_models;
        filled.pose = pose(ASIDE);
        let camera = Camera::new(Self::AREA, NEAR)?;
        Ok(Beside {
            outlined: self.outlined.prepare(&camera, &self.outlined_models)?,
            filled: self.filled.prepare(&camera, &self.filled_models)?,
        })
    }
}

impl<P: Prepared<Color = Rgb565>> Prepared for Beside<'_, P> {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        for point in self.outlined.points().filter(|point| point.model == 0) {
            let square = Rectangle::with_center(point.corner.pixel(), Size::new_equal(3));
            let Ok(()) = square.into_styled(PrimitiveStyle::with_fill(BRIGHT)).draw_on(band);
        }
        for edge in self.outlined.edges(1, &EDGES) {
            let [start, end] = edge.ends.map(|end| end.point);
            let color = if edge.is_silhouette { BRIGHT } else { DIM };
            let Ok(line) = FilteredLine::new(start, end) else {
                continue;
            };
            let Ok(()) = line.draw(band, color);
        }
        self.filled.draw(band);
        for (name, x) in CAPTIONS {
            label(
                band,
                name,
                Point::new(x, 107),
                Alignment::Center,
                &FONT_5X8,
                LABEL_COLOR,
            );
        }
    }
}
