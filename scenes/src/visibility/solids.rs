//! Three beams, each of which lies in front of the next one, and an octahedron that goes through them: what is hard for methods
//! that sort faces, with few enough faces to tell them apart.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::scene::{Camera, Counted, FaceSet, Memory, Model, Pose, Prepared, Rotation};

use crate::{
    PrepareError,
    meshes::face_set,
    paint::rgb,
    standard::{NEAR, model},
};

/// Faces that are prepared and drawn, and counted meanwhile.
pub type Frame<'f> = Prepared<'f, 'static, Counted<Rgb565>>;

const BEAMS: usize = 3;
/// Vertices and faces of all solids.
const VERTICES: usize = BEAMS * BEAM.vertices().len() + OCTAHEDRON.vertices().len();
pub const FACES: usize = BEAMS * BEAM.faces().len() + OCTAHEDRON.faces().len();
/// The most faces that cross a row.
pub const ACTIVE: usize = 40;

/// Half of a beam's length, height and depth.
const HALF: [i16; 3] = [520, 84, 66];
/// How far the beams are from the middle, and the octahedron's corners.
const ASIDE: I16F16 = I16F16::lit("196");
const RADIUS: i16 = 300;
/// Where the middle is.
const UP: I16F16 = I16F16::lit("44");
const DISTANCE: I16F16 = I16F16::lit("1400");
/// By how much a beam comes nearer from one end to the other, and how the octahedron is turned: parts of a turn.
const TILT: U0F16 = U0F16::lit("0.06");
const TURNED: [U0F16; 2] = [U0F16::lit("0.09"), U0F16::lit("0.06")];

/// Parts of a beam, along its length.
const PARTS: usize = 4;

/// Corners of the sections of a beam: bit 0 of a vertex's index is its side along y, bit 1 along z, the others its section.
const BEAM_VERTICES: [[i16; 3]; 4 * (PARTS + 1)] = {
    let mut vertices = [[0; 3]; 4 * (PARTS + 1)];
    let [x, y, z] = HALF;
    let mut index = 0;
    while index < vertices.len() {
        let part = (index / 4) as i16;
        vertices[index] = [
            part * (2 * x / PARTS as i16) - x,
            if index & 1 == 0 { -y } else { y },
            if index & 2 == 0 { -z } else { z },
        ];
        index += 1;
    }
    vertices
};
/// Eight faces around each part, then those of the two ends.
const BEAM_FACES: [[u16; 3]; 8 * PARTS + 4] = {
    // A side's corners in the section of its left end, then those of the right end.
    const SIDES: [[u16; 2]; 4] = [[0, 2], [3, 1], [1, 0], [2, 3]];
    let mut faces = [[0; 3]; 8 * PARTS + 4];
    let mut index = 0;
    while index < 4 * PARTS {
        let ([a, b], first) = (SIDES[index % 4], 4 * (index / 4) as u16);
        let (a, b) = (first + a, first + b);
        faces[2 * index] = [a, a + 4, b + 4];
        faces[2 * index + 1] = [a, b + 4, b];
        index += 1;
    }
    let last = 4 * PARTS as u16;
    faces[8 * PARTS] = [0, 2, 3];
    faces[8 * PARTS + 1] = [0, 3, 1];
    faces[8 * PARTS + 2] = [last, last + 1, last + 3];
    faces[8 * PARTS + 3] = [last, last + 3, last + 2];
    faces
};
const BEAM: FaceSet = face_set(&BEAM_VERTICES, &BEAM_FACES);

const R: i16 = RADIUS;
const OCTAHEDRON_VERTICES: [[i16; 3]; 6] = [[R, 0, 0], [-R, 0, 0], [0, R, 0], [0, -R, 0], [0, 0, R], [0, 0, -R]];
#[rustfmt::skip]
pub const OCTAHEDRON_FACES: [[u16; 3]; 8] = [
    [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
    [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
];
const OCTAHEDRON: FaceSet = face_set(&OCTAHEDRON_VERTICES, &OCTAHEDRON_FACES);

/// The colours of a beam's lower and upper side, its front and its back in each part, and its ends. The faces of a side differ a
/// little.
const fn shades([red, green, blue]: [u16; 3]) -> [Rgb565; BEAM_FACES.len()] {
    let mut colors = [Rgb565::BLACK; BEAM_FACES.len()];
    let mut face = 0;
    while face < colors.len() {
        let side = if face < 8 * PARTS { face / 2 % 4 } else { 4 };
        let light = [44, 100, 80, 50, 64][side] - 5 * ((face % 2 + face / 8 % 2) as u16);
        colors[face] = rgb(
            (red * light / 100) as u8,
            (green * light / 100) as u8,
            (blue * light / 100) as u8,
        );
        face += 1;
    }
    colors
}
static BEAM_COLORS: [[Rgb565; BEAM_FACES.len()]; BEAMS] =
    [shades([240, 120, 80]), shades([110, 200, 110]), shades([100, 160, 250])];
static OCTAHEDRON_COLORS: [Rgb565; 8] = [
    rgb(190, 180, 90),
    rgb(190, 180, 90),
    rgb(190, 180, 90),
    rgb(190, 180, 90),
    rgb(250, 236, 140),
    rgb(226, 206, 116),
    rgb(176, 158, 84),
    rgb(206, 186, 100),
];

/// The solids, and the memory in which they are drawn with that many columns and rows.
#[derive(Debug)]
pub struct Solids<const COLUMNS: usize, const ROWS: usize> {
    memory: Memory<Counted<Rgb565>, VERTICES, FACES, COLUMNS, ROWS, ACTIVE>,
    models: [Model<'static, Rgb565>; BEAMS + 1],
}

impl<const COLUMNS: usize, const ROWS: usize> Default for Solids<COLUMNS, ROWS> {
    fn default() -> Self {
        let [red, green, blue] = &BEAM_COLORS;
        Self {
            memory: Memory::new(),
            models: [
                model(BEAM, red),
                model(BEAM, green),
                model(BEAM, blue),
                model(OCTAHEDRON, &OCTAHEDRON_COLORS),
            ],
        }
    }
}

impl<const COLUMNS: usize, const ROWS: usize> Solids<COLUMNS, ROWS> {
    pub const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(COLUMNS as u32, ROWS as u32));

    /// Prepares the solids; the picture shows them as large as fits.
    pub fn prepare(&mut self) -> Result<Frame<'_>, PrepareError> {
        let focal_length = I16F16::from_num(ROWS) * I16F16::lit("1.14");
        let camera = Camera::new(Self::AREA, NEAR)?.with_focal_length(focal_length)?;
        let ahead = |rotation| Pose::new(rotation, [I16F16::ZERO, UP, DISTANCE]);
        let [beams @ .., octahedron] = &mut self.models;
        let tilted = Pose::new(Rotation::about_y(TILT), [I16F16::ZERO, ASIDE, I16F16::ZERO]);
        for (beam, number) in beams.iter_mut().zip(0..) {
            // A third of a turn.
            let angle = U0F16::from_bits(0x5555 * number);
            beam.pose = tilted.then(&ahead(Rotation::about_z(angle)))?;
        }
        let [about_x, about_y] = TURNED;
        octahedron.pose = ahead(Rotation::about_x(about_x).then(&Rotation::about_y(about_y)));
        self.memory.prepare(&camera, &self.models)
    }

    /// The colour of a face, by its index in the order of models and faces.
    pub fn color(face: usize) -> Rgb565 {
        let mut colors = BEAM_COLORS.as_flattened().iter().chain(&OCTAHEDRON_COLORS);
        colors.nth(face).copied().unwrap_or_default()
    }
}
