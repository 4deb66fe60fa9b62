//! Models that stand in the tests.

use anyhow::Context;
use zrow_mesh::{
    convert,
    mesh::{Mesh, Options},
    model::Model,
    quantize::Up,
    read,
};

/// A size of 100, y up, with normals.
pub const OPTIONS: Options = Options {
    size: 100,
    up: Up::Y,
    flat: false,
    levels: 0,
    edges: None,
};

/// A cube from -1 to 1 of four-cornered faces, counter-clockwise from outside.
pub const CUBE: &str = "\
v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";

/// Files beside a model.
pub type Files<'a> = &'a [(&'a str, &'a [u8])];

/// Reads a model.
pub fn read(bytes: &[u8], name: &str, beside: Files<'_>) -> anyhow::Result<Model> {
    read::model(bytes, name, &|path| file(beside, path))
}

/// Reads and converts a model.
pub fn convert(bytes: &[u8], name: &str, beside: Files<'_>, options: Options) -> anyhow::Result<Mesh> {
    convert::convert(&read(bytes, name, beside)?, options, &|path| file(beside, path))
}

/// Converts an OBJ of text.
pub fn obj(text: &str, beside: Files<'_>) -> anyhow::Result<Mesh> {
    convert(text.as_bytes(), "model.obj", beside, OPTIONS)
}

fn file(beside: Files<'_>, path: &str) -> anyhow::Result<Vec<u8>> {
    let found = beside.iter().find(|(name, _)| *name == path);
    found
        .map(|(_, bytes)| bytes.to_vec())
        .with_context(|| format!("{path} is missing"))
}

/// The message of an error.
pub fn message<T>(result: anyhow::Result<T>) -> String {
    match result {
        Ok(_) => panic!("no error"),
        Err(error) => format!("{error:#}"),
    }
}

/// The corners of a face as whole numbers.
pub fn corners(mesh: &Mesh, face: [u16; 3]) -> [[i64; 3]; 3] {
    face.map(|index| mesh.vertices[usize::from(index)].map(i64::from))
}

/// cross(b - a, c - a).
pub fn cross([a, b, c]: [[i64; 3]; 3]) -> [i64; 3] {
    let (b, c) = (
        [0, 1, 2].map(|axis| b[axis] - a[axis]),
        [0, 1, 2].map(|axis| c[axis] - a[axis]),
    );
    [
        b[1] * c[2] - b[2] * c[1],
        b[2] * c[0] - b[0] * c[2],
        b[0] * c[1] - b[1] * c[0],
    ]
}

/// Six times the volume: positive if faces are seen from outside.
pub fn volume(mesh: &Mesh) -> i64 {
    let volume = |&face: &[u16; 3]| {
        let corners = corners(mesh, face);
        // The product of a corner with the cross product of the edges is that of all three corners.
        let normal = cross(corners);
        (0..3).map(|axis| corners[0][axis] * normal[axis]).sum::<i64>()
    };
    mesh.faces.iter().map(volume).sum()
}

/// A PNG file.
pub fn png(width: u32, height: u32, color: png::ColorType, depth: png::BitDepth, bytes: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == png::ColorType::Indexed {
        encoder.set_palette(vec![255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255]);
    }
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(bytes).unwrap();
    writer.finish().unwrap();
    file
}

/// xorshift32.
pub struct Random(pub u32);

impl Random {
    pub fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0 as usize % bound.max(1)
    }
}
