//! letter.obj: 30 vertices, 16 faces, 672 bytes of flash.
//!
//! Written by zrow's converter; do not edit it, but convert again:
//! ```text
//! cargo run --release -- mesh letter.obj --size 512 --edges 30
//! ```

use embedded_graphics::pixelcolor::Rgb565;
use zrow::scene::{Edge, FaceSet};

/// letter.obj: 30 vertices, 16 faces.
pub static LETTER: FaceSet = match FaceSet::new(&VERTICES, &FACES) {
    Ok(faces) => faces,
    Err(_) => panic!("a face names a vertex that is not there"),
};

/// The faces beside each face, 6 bytes each where they are used: `LETTER.with_neighbours(&LETTER_NEIGHBOURS)`.
#[allow(dead_code, reason = "for antialiased silhouettes alone")]
pub static LETTER_NEIGHBOURS: [[u16; 3]; 16] = FaceSet::find_neighbours(&FACES);

/// The colour of each face.
#[rustfmt::skip]
pub static LETTER_COLORS: [Rgb565; 16] = [
    Rgb565::new(31, 32, 0), Rgb565::new(31, 32, 0), Rgb565::new(31, 32, 0), Rgb565::new(31, 32, 0),
    Rgb565::new(31, 32, 0), Rgb565::new(31, 32, 0), Rgb565::new(6, 25, 25), Rgb565::new(6, 25, 25),
    Rgb565::new(6, 25, 25), Rgb565::new(6, 25, 25), Rgb565::new(6, 25, 25), Rgb565::new(6, 25, 25),
    Rgb565::new(6, 25, 25), Rgb565::new(6, 25, 25), Rgb565::new(6, 25, 25), Rgb565::new(6, 25, 25),
];

/// The normal of each vertex: octahedral, 127 is 1, with x to the right, y up and z away from the viewer.
#[rustfmt::skip]
pub static LETTER_NORMALS: [[i8; 2]; 30] = [
    [127, 127], [127, 127], [127, 127], [127, 127], [127, 127], [0, 0], [0, 0], [0, 0], [0, 0],
    [0, 0], [-85, -85], [84, -85], [-42, -42], [42, -42], [84, -85], [70, 99], [42, -42], [28, 57],
    [70, 99], [-81, 127], [28, 57], [0, 46], [-81, 127], [-70, 99], [0, 46], [-28, 57], [-70, 99],
    [-85, -85], [-28, 57], [-42, -42],
];

/// The texture coordinates of each vertex: u to the right and v down, in 1/4096 of the texture's width and height.
#[rustfmt::skip]
pub static LETTER_COORDINATES: [[i16; 2]; 30] = [
    [0, 4096], [0, 1024], [2048, 2560], [4096, 4096], [4096, 1024], [0, 1024], [0, 4096],
    [2048, 2560], [4096, 4096], [4096, 1024], [0, 4096], [4096, 4096], [0, 0], [4096, 0], [0, 4096],
    [4096, 4096], [0, 0], [4096, 0], [0, 4096], [4096, 4096], [0, 0], [4096, 0], [0, 4096],
    [4096, 4096], [0, 0], [4096, 0], [0, 4096], [4096, 4096], [0, 0], [4096, 0],
];

/// The texture: RGB565 words, rows from the top on.
#[rustfmt::skip]
pub static LETTER_TEXTURE: [[u16; 8]; 4] = [
    [
        0xc0e4, 0xc0e4, 0xc0e4, 0xc0e4, 0xc0e4, 0xc0e4, 0xc0e4, 0xc0e4,
    ],
    [
        0x29f8, 0x29f8, 0xffff, 0xffff, 0x29f8, 0x29f8, 0xffff, 0xffff,
    ],
    [
        0xffff, 0xffff, 0x29f8, 0x29f8, 0xffff, 0xffff, 0x29f8, 0x29f8,
    ],
    [
        0x29f8, 0x29f8, 0xffff, 0xffff, 0x29f8, 0x29f8, 0xffff, 0xffff,
    ],
];

/// Edges, for `Prepared::edges`: at creases faces turn by more than 30 degrees.
#[rustfmt::skip]
pub static LETTER_EDGES: [Edge; 15] = [
    Edge::crease([0, 1], [0, 14]), Edge::crease([1, 2], [0, 12]), Edge::crease([3, 0], [1, 6]),
    Edge::crease([2, 4], [2, 10]), Edge::crease([4, 3], [2, 8]), Edge::crease([5, 6], [3, 15]),
    Edge::crease([7, 5], [3, 13]), Edge::crease([6, 8], [4, 7]), Edge::crease([8, 9], [5, 9]),
    Edge::crease([9, 7], [5, 11]), Edge::crease([12, 10], [6, 15]), Edge::crease([11, 13], [7, 8]),
    Edge::crease([15, 17], [9, 10]), Edge::crease([19, 21], [11, 12]),
    Edge::crease([23, 25], [13, 14]),
];

#[rustfmt::skip]
static VERTICES: [[i16; 3]; 30] = [
    [-341, 0, -171], [-341, 512, -171], [0, 256, -171], [341, 0, -171], [341, 512, -171],
    [-341, 512, 171], [-341, 0, 171], [0, 256, 171], [341, 0, 171], [341, 512, 171],
    [-341, 0, -171], [341, 0, -171], [-341, 0, 171], [341, 0, 171], [341, 0, -171],
    [341, 512, -171], [341, 0, 171], [341, 512, 171], [341, 512, -171], [0, 256, -171],
    [341, 512, 171], [0, 256, 171], [0, 256, -171], [-341, 512, -171], [0, 256, 171],
    [-341, 512, 171], [-341, 512, -171], [-341, 0, -171], [-341, 512, 171], [-341, 0, 171],
];

#[rustfmt::skip]
static FACES: [[u16; 3]; 16] = [
    [0, 1, 2], [0, 2, 3], [2, 4, 3], [5, 6, 7], [6, 8, 7], [8, 9, 7], [10, 11, 12], [11, 13, 12],
    [14, 15, 16], [15, 17, 16], [18, 19, 20], [19, 21, 20], [22, 23, 24], [23, 25, 24],
    [26, 27, 28], [27, 29, 28],
];
