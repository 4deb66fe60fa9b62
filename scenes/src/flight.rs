//! A flight around a clearing in the fog: the ground in perspective, cut at the near plane, firs on two triangles each, with
//! holes, which turn to the viewer, and a sky behind them.

use core::fmt;

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::I16F16;
use zrow::{
    band::{Band, Order, Target},
    draw::PrimitiveStyle,
    scene::{self, Camera, FaceSet, Memory, Model, Pose, Rotation},
    shade::{CutOut, Fog, Foggy, Indexed, IndexedImage, LinearGradient, Ramp, Textured, TexturedSkin},
};

use crate::{
    PrepareError, Prepared, Scene,
    meshes::face_set,
    paint::{self, rgb},
    sine::{TURN, sine},
    standard::angle,
    teapots::{shaded, word},
};

/// Texels of a side of a texture, and bytes of a row.
const TEXELS: usize = 64;
const BYTES: usize = TEXELS / 2;
/// The texture of ground and firs: 16 colours.
type Sixteen = Indexed<Rgb565, BYTES, TEXELS, 16>;
/// The look of the flight: textures with holes, in fog.
type Forest = Foggy<Textured<CutOut<Sixteen>>>;

const COLUMNS: usize = 320;
const ROWS: usize = 240;
const FRAMES: u32 = 128;

/// The grey in which everything ends.
const HAZE: Rgb565 = rgb(170, 184, 196);
/// The colours of the sky, from the top of the picture down to the tops of the farthest firs, which are grey already.
const SKY: [(u8, Rgb888); 3] = [
    (0, Rgb888::new(62, 112, 176)),
    (150, Rgb888::new(126, 160, 196)),
    (255, Rgb888::new(170, 184, 196)),
];
const SKY_ROWS: i32 = 104;
const FOG: Fog<'static, Rgb565> = Fog {
    color: HAZE,
    start: I16F16::lit("300"),
    end: I16F16::lit("2200"),
    curve: Fog::EXPONENTIAL,
};

/// Cells of a side of the ground, and how large they are.
const CELLS: usize = 8;
const CELL: i16 = 512;
const GROUND_VERTICES: usize = (CELLS + 1) * (CELLS + 1);
const GROUND_FACES: usize = 2 * CELLS * CELLS;

/// The radius of the circle around the clearing on which the camera flies.
const RADIUS: i32 = 760;
/// The height of the camera above the ground.
const HEIGHT: I16F16 = I16F16::lit("150");

/// The places of the firs on the ground, x and z of each.
const PLACES: [[i16; 2]; 24] = [
    [-300, -220],
    [180, -420],
    [420, 130],
    [-60, 380],
    [-1180, -160],
    [-1040, 620],
    [-420, 1160],
    [260, 1240],
    [900, 940],
    [1260, 300],
    [1160, -480],
    [640, -1080],
    [-80, -1300],
    [-700, -1040],
    [-1240, -640],
    [80, 40],
    [1500, 1300],
    [-1500, 1200],
    [-1600, -1300],
    [1450, -1350],
    [0, 1750],
    [1850, 0],
    [-1850, 100],
    [300, -1800],
];
/// Vertices and faces of all models, and room for the faces that the near plane cuts.
const VERTICES: usize = GROUND_VERTICES + 4 * PLACES.len() + 4 * 40;
const FACES: usize = GROUND_FACES + 2 * PLACES.len();

static GROUND_CORNERS: [[i16; 3]; GROUND_VERTICES] = {
    let mut corners = [[0; 3]; GROUND_VERTICES];
    let mut index = 0;
    while index < GROUND_VERTICES {
        let (column, row) = ((index % (CELLS + 1)) as i16, (index / (CELLS + 1)) as i16);
        let middle = CELLS as i16 / 2;
        corners[index] = [(column - middle) * CELL, 0, (row - middle) * CELL];
        index += 1;
    }
    corners
};

static GROUND_COORDINATES: [[i16; 2]; GROUND_VERTICES] = {
    let mut coordinates = [[0; 2]; GROUND_VERTICES];
    let mut index = 0;
    while index < GROUND_VERTICES {
        let [x, _, z] = GROUND_CORNERS[index];
        // A texture of 256 units: two in a cell.
        coordinates[index] = [x * 8, z * 8];
        index += 1;
    }
    coordinates
};

static GROUND_TRIANGLES: [[u16; 3]; GROUND_FACES] = {
    let mut faces = [[0; 3]; GROUND_FACES];
    let mut cell = 0;
    while cell < CELLS * CELLS {
        let near_left = (cell % CELLS + cell / CELLS * (CELLS + 1)) as u16;
        let (near_right, far_left) = (near_left + 1, near_left + CELLS as u16 + 1);
        faces[2 * cell] = [near_left, far_left, far_left + 1];
        faces[2 * cell + 1] = [near_left, far_left + 1, near_right];
        cell += 1;
    }
    faces
};

static GROUND: FaceSet = face_set(&GROUND_CORNERS, &GROUND_TRIANGLES);
static FIR: FaceSet = face_set(
    &[[-110, 0, 0], [-110, 330, 0], [110, 330, 0], [110, 0, 0]],
    &[[0, 1, 2], [0, 2, 3]],
);
static FIR_COORDINATES: [[i16; 2]; 4] = [[0, 4095], [0, 0], [4095, 0], [4095, 4095]];

/// Colours of both textures; the first one is a hole.
static PALETTE: [u16; 16] = {
    let mut palette = [0; 16];
    palette[1] = word(24, 56, 40);
    palette[2] = word(34, 76, 50);
    palette[3] = word(52, 98, 60);
    palette[4] = word(70, 48, 34);
    palette[5] = word(92, 112, 62);
    palette[6] = word(104, 122, 66);
    palette[7] = word(84, 102, 58);
    palette[8] = word(122, 118, 76);
    palette
};

/// A picture of numbers of colours.
macro_rules! indices {
    ($number:path) => {{
        let mut indices = [[0; BYTES]; TEXELS];
        let mut row = 0;
        while row < TEXELS {
            let mut byte = 0;
            while byte < BYTES {
                let column = 2 * byte as i32;
                indices[row][byte] = $number(column, row as i32) << 4 | $number(column + 1, row as i32);
                byte += 1;
            }
            row += 1;
        }
        indices
    }};
}

static GRASS_INDICES: [[u8; BYTES]; TEXELS] = indices!(grass);
static FIR_INDICES: [[u8; BYTES]; TEXELS] = indices!(fir);

/// A number that looks random, below 2^16.
const fn noise(column: i32, row: i32) -> i32 {
    let mixed = (column as u32).wrapping_mul(0x9e37_79b1) ^ (row as u32).wrapping_mul(0x85eb_ca77);
    ((mixed ^ mixed >> 15).wrapping_mul(0x2c1b_3c6d) >> 16) as i32
}

/// The colour of the ground.
const fn grass(column: i32, row: i32) -> u8 {
    // In patches of 4 x 4 texels, with blades.
    let (patch, blade) = (noise(column / 4, row / 4) % 8, noise(column, row + 100) % 6);
    match (patch, blade) {
        (0, 0..=2) => 8,
        (_, 0) => 7,
        (_, 1) => 6,
        (1..=3, _) => 6,
        _ => 5,
    }
}

/// The colour of a fir, or of what is around it.
const fn fir(column: i32, row: i32) -> u8 {
    // In half texels from the middle.
    let across = 2 * column + 1 - TEXELS as i32;
    let mut tier = 0;
    while tier < 3 {
        let from_top = row - 2 - 15 * tier;
        // Ragged, but for the top.
        let needles = if tier == 0 && from_top < 4 {
            0
        } else {
            noise(row, tier) % 7 - 3
        };
        let reach = from_top * 4 / 3 + 6 * tier + needles;
        if from_top >= 0 && from_top < 22 && across.abs() <= reach {
            let is_shade = from_top > 17 || across > reach / 3;
            return match noise(column, row) % 5 {
                0 => 3,
                1 | 2 if !is_shade => 3,
                3 if is_shade => 1,
                _ if is_shade => 1,
                _ => 2,
            };
        }
        tier += 1;
    }
    if row >= 50 && across.abs() < 6 { 4 } else { 0 }
}

/// The skin of a mesh.
const fn skin(
    indices: &'static [[u8; BYTES]; TEXELS],
    coordinates: &'static [[i16; 2]],
) -> (TexturedSkin<'static, CutOut<Sixteen>>, Fog<'static, Rgb565>) {
    let image = IndexedImage {
        indices,
        palette: &PALETTE,
    };
    (TexturedSkin { image, coordinates }, FOG)
}

/// A gradient from the top to the bottom.
type Sky = LinearGradient<Rgb565, 3>;

/// The scene: the ground, the firs, and the sky.
pub struct Flight {
    memory: Memory<Forest, VERTICES, FACES, COLUMNS, ROWS, 96>,
    /// `None` for colours that are not in order.
    sky: Option<Sky>,
    models: [Model<'static, Forest>; 1 + PLACES.len()],
}

impl fmt::Debug for Flight {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Flight")
            .field("models", &self.models.len())
            .finish_non_exhaustive()
    }
}

impl Default for Flight {
    fn default() -> Self {
        let fir = shaded(FIR, skin(&FIR_INDICES, &FIR_COORDINATES));
        let mut models = [fir; 1 + PLACES.len()];
        for (model, [x, z]) in models.iter_mut().zip(PLACES) {
            model.pose.translation = [x, 0, z].map(I16F16::from);
        }
        // The last one, behind everything.
        let [.., ground] = &mut models;
        *ground = shaded(GROUND, skin(&GRASS_INDICES, &GROUND_COORDINATES));
        Self {
            memory: Memory::new(),
            sky: Ramp::new(SKY)
                .and_then(|ramp| LinearGradient::new(Point::zero(), Point::new(0, SKY_ROWS), ramp))
                .ok(),
            models,
        }
    }
}

/// A frame of a scene with a sky behind it.
#[derive(Debug)]
pub struct BeforeSky<'s, P> {
    scene: P,
    sky: &'s Option<Sky>,
}

impl<P: Prepared<Color = Rgb565>> Prepared for BeforeSky<'_, P> {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        if let Some(gradient) = self.sky {
            // Below these rows, the band is grey already.
            let sky = Rectangle::new(Point::zero(), Size::new(COLUMNS as u32, SKY_ROWS as u32));
            let sky = sky.into_styled(PrimitiveStyle::with_fill(HAZE));
            paint::shape(&mut band.painted(gradient), &sky);
        }
        self.scene.draw(band);
    }
}

impl Scene for Flight {
    type Color = Rgb565;
    type Prepared<'s> = BeforeSky<'s, scene::Prepared<'s, 'static, Forest>>;
    const NAME: &'static str = "flight";
    const TITLE: &'static str = "flight around a clearing in fog";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(COLUMNS as u32, ROWS as u32));
    const BACKGROUND: Rgb565 = HAZE;
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = 20;
    const DEPTH_ROW_BYTES: usize = size_of::<[u16; COLUMNS]>();

    fn prepare(&mut self, frame: u32) -> Result<Self::Prepared<'_>, PrepareError> {
        // Round the clearing, with the middle to the right.
        let steps = frame % FRAMES * (TURN / FRAMES);
        let along = |angle: u32| I16F16::from_bits((RADIUS * sine(angle)) << 2);
        let position = [along(steps), HEIGHT, along(steps + TURN / 2 + TURN / 4)];
        // To the middle, and somewhat past it.
        let rotation = Rotation::about_y(angle(TURN - steps + 40));
        let camera = Camera::new(Self::AREA, I16F16::lit("16"))?.with_pose(Pose::new(rotation, position));
        for fir in self.models.iter_mut().take(PLACES.len()) {
            fir.pose.rotation = rotation;
        }
        Ok(BeforeSky {
            scene: self.memory.prepare(&camera, &self.models)?,
            sky: &self.sky,
        })
    }
}
