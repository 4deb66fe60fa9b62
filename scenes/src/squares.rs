//! Squares with a texture that overlap and go through each other: few large faces whose pixels take long to shade.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use zrow::{
    scene::{FaceSet, Model, Rotation},
    shade::{Texels, Textured, TexturedSkin},
};

use crate::{
    meshes::face_set,
    standard::{Subject, angle},
    teapots::{PORCELAIN, SIZE, TEXELS, shaded},
};

/// The number of squares, each of two faces. By their area, four faces lie behind each other in the mean pixel.
const SQUARES: usize = 20;

/// Half the side of a square, in units of the vertices: 12.8 are a pixel at the distance of a standard scene.
const HALF: i16 = 790;

/// Overlapping squares, which sway by a sixteenth of a turn to both sides.
#[derive(Debug)]
pub struct OverlappingSquares;

impl Subject for OverlappingSquares {
    const NAME: &'static str = "squares";
    const TITLE: &'static str = "squares with a texture that go through each other";
    const SIZE: Size = SIZE;
    type Shading = Textured<Texels<Rgb565, TEXELS, TEXELS>>;

    fn rotation(frame: u32) -> Rotation {
        Rotation::about_y(angle(512 - 32 + frame % 64))
    }

    fn model() -> Model<'static, Self::Shading> {
        static SQUARES_AS_FACES: FaceSet = face_set(VERTICES.as_flattened(), FACES.as_flattened());
        shaded(
            SQUARES_AS_FACES,
            TexturedSkin {
                image: &PORCELAIN,
                coordinates: COORDINATES.as_flattened(),
            },
        )
    }
}

const FACES: &[[[u16; 3]; 2]; SQUARES] = &{
    let mut faces = [[[0; 3]; 2]; SQUARES];
    let mut square = 0;
    while square < SQUARES {
        let first = 4 * square as u16;
        faces[square] = [[first, first + 2, first + 1], [first, first + 3, first + 2]];
        square += 1;
    }
    faces
};

const COORDINATES: &[[[i16; 2]; 4]; SQUARES] = &[[[0, 8192], [8192, 8192], [8192, 0], [0, 0]]; SQUARES];

const VERTICES: &[[[i16; 3]; 4]; SQUARES] = &{
    let mut vertices = [[[0; 3]; 4]; SQUARES];
    // xorshift32 (Marsaglia 2003).
    let mut state = 0x1234_5678_u32;
    let mut square = 0;
    while square < SQUARES {
        let mut random = [0; 5];
        let most = [746, 1258, 400, 300, 300];
        let mut index = 0;
        while index < 5 {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            random[index] = ((state >> 8) % (2 * most[index] + 1)) as i16 - most[index] as i16;
            index += 1;
        }
        let [x, y, z, right, up] = random;
        vertices[square] = [
            [x - HALF, y - HALF, z - right - up],
            [x + HALF, y - HALF, z + right - up],
            [x + HALF, y + HALF, z + right + up],
            [x - HALF, y + HALF, z - right + up],
        ];
        square += 1;
    }
    vertices
};
