//! pebble.obj: 42 vertices, 80 faces, 1,456 bytes of flash.
//!
//! Written by zrow's converter; do not edit it, but convert again:
//! ```text
//! cargo run --release -- mesh pebble.obj --size 512 --levels 2
//! ```
//!
//! A level is picked by its distance from the camera in units: its error is half a pixel at twice the error times
//! the focal length in pixels. All levels take the first vertices of one table, so normals and texture coordinates
//! are those of PEBBLE. With a focal length of 160 pixels:
//! ```text
//! let (mesh, colors) = match distance {
//!     ..24473 => (&PEBBLE, &PEBBLE_COLORS[..]),
//!     ..40699 => (&PEBBLE_LEVEL_1, &PEBBLE_LEVEL_1_COLORS[..]),
//!     _ => (&PEBBLE_LEVEL_2, &PEBBLE_LEVEL_2_COLORS[..]),
//! };
//! ```

use embedded_graphics::pixelcolor::Rgb565;
use zrow::scene::FaceSet;

/// pebble.obj: 42 vertices, 80 faces.
pub static PEBBLE: FaceSet = match FaceSet::new(&VERTICES, &FACES) {
    Ok(faces) => faces,
    Err(_) => panic!("a face names a vertex that is not there"),
};

/// The faces beside each face, 6 bytes each where they are used: `PEBBLE.with_neighbours(&PEBBLE_NEIGHBOURS)`.
#[allow(dead_code, reason = "for antialiased silhouettes alone")]
pub static PEBBLE_NEIGHBOURS: [[u16; 3]; 80] = FaceSet::find_neighbours(&FACES);

/// The colour of each face.
pub static PEBBLE_COLORS: [Rgb565; 80] = [Rgb565::new(31, 63, 31); 80];

/// The normal of each vertex: octahedral, 127 is 1, with x to the right, y up and z away from the viewer.
#[rustfmt::skip]
pub static PEBBLE_NORMALS: [[i8; 2]; 42] = [
    [37, 90], [-37, 90], [127, 0], [127, 70], [-127, -127], [-127, -70], [-127, 0], [-57, 0],
    [0, 0], [57, 0], [37, -90], [-21, -76], [-51, 106], [21, 76], [83, -91], [-77, -127],
    [-83, -91], [-36, -44], [0, -50], [36, -44], [51, -106], [-37, -90], [0, 127], [51, 106],
    [43, 127], [-21, 76], [0, 84], [70, 57], [83, 91], [77, 127], [-83, 91], [-70, 57], [-36, 44],
    [0, 50], [36, 44], [70, -57], [-70, -57], [-43, -127], [-51, -106], [0, -84], [21, -76],
    [0, -127],
];

/// 22 vertices, the first of all, and 40 faces: within 76.48 units of the finest mesh.
#[rustfmt::skip]
pub static PEBBLE_LEVEL_1: FaceSet = match FaceSet::new(VERTICES.split_at(22).0, &PEBBLE_LEVEL_1_FACES) {
    Ok(faces) => faces,
    Err(_) => panic!("a face names a vertex that is not there"),
};

/// The colour of each face.
pub static PEBBLE_LEVEL_1_COLORS: [Rgb565; 40] = [Rgb565::new(31, 63, 31); 40];

/// 12 vertices, the first of all, and 20 faces: within 127.18 units of the finest mesh.
#[rustfmt::skip]
pub static PEBBLE_LEVEL_2: FaceSet = match FaceSet::new(VERTICES.split_at(12).0, &PEBBLE_LEVEL_2_FACES) {
    Ok(faces) => faces,
    Err(_) => panic!("a face names a vertex that is not there"),
};

/// The colour of each face.
pub static PEBBLE_LEVEL_2_COLORS: [Rgb565; 20] = [Rgb565::new(31, 63, 31); 20];

#[rustfmt::skip]
static VERTICES: [[i16; 3]; 42] = [
    [256, 253, 0], [-256, 253, 0], [512, 0, 0], [362, 0, -259], [0, 0, -366], [-362, 0, -259],
    [-512, 0, 0], [-362, 0, 259], [0, 0, 366], [362, 0, 259], [256, -253, 0], [-181, -253, 129],
    [-181, 253, -129], [181, 253, 129], [314, -146, -224], [0, -146, -317], [-314, -146, -224],
    [-314, -146, 224], [0, -146, 317], [314, -146, 224], [181, -253, -129], [-256, -253, 0],
    [0, 293, 0], [181, 253, -129], [0, 253, -183], [-181, 253, 129], [0, 253, 183], [443, 146, 0],
    [314, 146, -224], [0, 146, -317], [-314, 146, -224], [-443, 146, 0], [-314, 146, 224],
    [0, 146, 317], [314, 146, 224], [443, -146, 0], [-443, -146, 0], [0, -253, -183],
    [-181, -253, -129], [0, -253, 183], [181, -253, 129], [0, -293, 0],
];

#[rustfmt::skip]
static FACES: [[u16; 3]; 80] = [
    [22, 0, 23], [22, 23, 24], [22, 24, 12], [22, 12, 1], [22, 1, 25], [22, 25, 26], [22, 26, 13],
    [22, 13, 0], [0, 27, 28], [0, 28, 23], [23, 28, 29], [23, 29, 24], [24, 29, 12], [29, 30, 12],
    [12, 30, 1], [30, 31, 1], [1, 31, 32], [1, 32, 25], [25, 32, 33], [25, 33, 26], [26, 33, 13],
    [33, 34, 13], [13, 34, 0], [34, 27, 0], [27, 2, 3], [27, 3, 28], [28, 3, 4], [28, 4, 29],
    [29, 4, 30], [4, 5, 30], [30, 5, 31], [5, 6, 31], [31, 6, 7], [31, 7, 32], [32, 7, 8],
    [32, 8, 33], [33, 8, 34], [8, 9, 34], [34, 9, 27], [9, 2, 27], [2, 35, 3], [35, 14, 3],
    [3, 14, 4], [14, 15, 4], [4, 15, 16], [4, 16, 5], [5, 16, 36], [5, 36, 6], [6, 36, 7],
    [36, 17, 7], [7, 17, 8], [17, 18, 8], [8, 18, 19], [8, 19, 9], [9, 19, 35], [9, 35, 2],
    [35, 10, 14], [10, 20, 14], [14, 20, 15], [20, 37, 15], [15, 37, 38], [15, 38, 16],
    [16, 38, 21], [16, 21, 36], [36, 21, 17], [21, 11, 17], [17, 11, 18], [11, 39, 18],
    [18, 39, 40], [18, 40, 19], [19, 40, 10], [19, 10, 35], [41, 20, 10], [41, 37, 20],
    [41, 38, 37], [41, 21, 38], [41, 11, 21], [41, 39, 11], [41, 40, 39], [41, 10, 40],
];

#[rustfmt::skip]
static PEBBLE_LEVEL_1_FACES: [[u16; 3]; 40] = [
    [12, 1, 13], [12, 13, 0], [0, 2, 3], [0, 3, 4], [0, 4, 12], [4, 5, 12], [12, 5, 1], [5, 6, 1],
    [1, 6, 7], [1, 7, 8], [1, 8, 13], [8, 9, 13], [13, 9, 0], [9, 2, 0], [2, 14, 3], [3, 14, 4],
    [14, 15, 4], [4, 15, 16], [4, 16, 5], [5, 16, 6], [6, 17, 7], [7, 17, 8], [17, 18, 8],
    [8, 18, 19], [8, 19, 9], [9, 19, 2], [2, 10, 14], [10, 20, 14], [14, 20, 15], [15, 20, 21],
    [15, 21, 16], [16, 21, 6], [6, 21, 17], [21, 11, 17], [17, 11, 18], [18, 11, 10], [18, 10, 19],
    [19, 10, 2], [20, 11, 21], [20, 10, 11],
];

#[rustfmt::skip]
static PEBBLE_LEVEL_2_FACES: [[u16; 3]; 20] = [
    [0, 2, 3], [0, 3, 4], [0, 4, 1], [4, 5, 1], [5, 6, 1], [1, 6, 7], [1, 7, 8], [1, 8, 0],
    [8, 9, 0], [9, 2, 0], [6, 11, 7], [7, 11, 8], [2, 10, 3], [3, 10, 4], [4, 10, 11], [4, 11, 5],
    [5, 11, 6], [8, 11, 10], [8, 10, 9], [9, 10, 2],
];
