//! Small scenes of some kinds, with fixed seeds.

use fixed::types::{I16F16, U0F16};
use zrow::scene::{Pose, Rotation};

use crate::{
    random::Random,
    space::input::{FOCAL_LENGTH, SPACE_SIZE, SpaceInput},
};

/// Scenes of a group.
pub const SPACE_SCENES: usize = 20;

/// A kind of small scenes.
#[derive(Debug, Clone, Copy)]
pub struct SpaceGroup {
    /// As in tables.
    pub name: &'static str,
    /// What the chips report its counts as.
    pub count: &'static str,
    fill: fn(&mut SpaceInput, &mut Random),
}

impl SpaceGroup {
    /// One of its scenes, seen by a camera with its near plane at this distance.
    pub fn input(&self, number: u32, near: i32) -> SpaceInput {
        let mut random = Random::new(0x3D ^ (u64::from(number) << 8));
        let mut input = SpaceInput::new(near);
        (self.fill)(&mut input, &mut random);
        input
    }
}

/// Faces of which others are in front, at distances of 150 to 6,300 units.
pub const DEPTH_GROUPS: &[SpaceGroup] = &[
    SpaceGroup {
        name: "faces through each other",
        count: "space.depth.through",
        fill: penetrating,
    },
    SpaceGroup {
        name: "faces 2 to 16 units apart",
        count: "space.depth.close",
        fill: close,
    },
];

/// Faces all of whose corners are on the screen.
pub const POSITION_GROUPS: &[SpaceGroup] = &[
    SpaceGroup {
        name: "at 300 units",
        count: "space.position.near",
        fill: |input, random| positions(input, random, 300.0, 0.0),
    },
    SpaceGroup {
        name: "at 3,000 units",
        count: "space.position.far",
        fill: |input, random| positions(input, random, 3_000.0, 0.0),
    },
];

/// Faces far from the origin of their model.
pub const MATRIX_GROUPS: &[SpaceGroup] = &[
    SpaceGroup {
        name: "2,000 from the origin, at 600",
        count: "space.matrix.2000_600",
        fill: |input, random| positions(input, random, 600.0, 2_000.0),
    },
    SpaceGroup {
        name: "20,000 from the origin, at 600",
        count: "space.matrix.20000_600",
        fill: |input, random| positions(input, random, 600.0, 20_000.0),
    },
    SpaceGroup {
        name: "20,000 from the origin, at 150",
        count: "space.matrix.20000_150",
        fill: |input, random| positions(input, random, 150.0, 20_000.0),
    },
];

/// Quadrangles with a texture, by how many times as far away one side is as the other.
pub const PERSPECTIVE_GROUPS: &[SpaceGroup] = &[
    SpaceGroup {
        name: "depths 1 to 1.01",
        count: "space.perspective.1_01",
        fill: |input, random| textured(input, random, 1.01),
    },
    SpaceGroup {
        name: "depths 1 to 2",
        count: "space.perspective.2",
        fill: |input, random| textured(input, random, 2.0),
    },
    SpaceGroup {
        name: "depths 1 to 8",
        count: "space.perspective.8",
        fill: |input, random| textured(input, random, 8.0),
    },
];

/// The place that is seen at a position of the picture, in pixels, from a distance.
fn seen_at([x, y]: [f64; 2], z: f64) -> [f64; 3] {
    let centre = (SPACE_SIZE / 2) as f64;
    let across = |pixels: f64| (pixels + 0.5 - centre) / f64::from(FOCAL_LENGTH) * z;
    [across(x), -across(y), z]
}

fn rounded(point: [f64; 3]) -> [i16; 3] {
    point.map(|coordinate| libm::floor(coordinate + 0.5) as i16)
}

/// Three positions in a square of the picture, clockwise, with an area of at least a fortieth of the square's.
fn triangle(random: &mut Random, from: f64, to: f64) -> [[f64; 2]; 3] {
    loop {
        let mut position = || [random.between(from, to), random.between(from, to)];
        let [a, b, c] = [position(), position(), position()];
        let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if doubled >= (to - from) * (to - from) / 20.0 {
            return [a, b, c];
        }
    }
}

impl SpaceInput {
    /// Adds a face.
    fn add(&mut self, corners: [[i16; 3]; 3]) {
        let first = self.vertices.len() as u16;
        for corner in corners {
            // No scene has more than there is room for.
            let _ = self.vertices.push(corner);
            let _ = self.coordinates.push([0; 2]);
        }
        let _ = self.faces.push([first, first + 1, first + 2]);
    }
}

/// A distance of that many times twice another one, and less: evenly on a logarithmic scale.
fn distance(random: &mut Random, from: f64, octaves: f64) -> f64 {
    from * libm::exp2(random.between(0.0, octaves))
}

fn penetrating(input: &mut SpaceInput, random: &mut Random) {
    for _ in 0..10 {
        let positions = triangle(random, 3.0, 92.0);
        input.add(positions.map(|position| rounded(seen_at(position, distance(random, 150.0, 5.4)))));
    }
}

fn close(input: &mut SpaceInput, random: &mut Random) {
    for _ in 0..5 {
        let positions = triangle(random, 3.0, 92.0);
        let around = distance(random, 180.0, 4.9);
        let gap = random.between(2.0, 16.0);
        let distances = [0; 3].map(|_| around * random.between(0.8, 1.2));
        for more in [gap, 0.0] {
            let mut distances = distances.iter();
            let corners = positions.map(|position| {
                let distance = distances.next().copied().unwrap_or(around);
                rounded(seen_at(position, distance + more))
            });
            input.add(corners);
        }
    }
}

fn turned([x, y, z]: [f64; 3], rotation: &Rotation) -> [f64; 3] {
    let scale = f64::from(1 << 30);
    rotation
        .matrix()
        .map(|[a, b, c]| (f64::from(a.to_bits()) * x + f64::from(b.to_bits()) * y + f64::from(c.to_bits()) * z) / scale)
}

/// Faces in the upper left quarter of the picture about a distance, so far from the origin of a model that is turned.
fn positions(input: &mut SpaceInput, random: &mut Random, around: f64, from_origin: f64) {
    let mut angle = || U0F16::from_bits(random.bits() as u16);
    let rotation = Rotation::about_x(angle()).then(&Rotation::about_y(angle()));
    let to_model = rotation.inverse();
    // In any direction from the eye; the model is moved so that it comes to lie in front.
    let direction = turned(
        [0.0, 0.0, 1.0],
        &Rotation::about_x(angle()).then(&Rotation::about_y(angle())),
    );
    let middle = [0.0, 0.0, around];
    let mut origin = [0.0; 3];
    for ((origin, middle), direction) in origin.iter_mut().zip(middle).zip(direction) {
        *origin = libm::floor((middle - from_origin * direction) * 16.0 + 0.5) / 16.0;
    }
    input.pose = Pose::new(rotation, origin.map(I16F16::from_num));
    for _ in 0..10 {
        let positions = triangle(random, 3.0, 44.0);
        let corners = positions.map(|position| {
            let mut place = seen_at(position, around * random.between(0.8, 1.2));
            for (coordinate, origin) in place.iter_mut().zip(origin) {
                *coordinate -= origin;
            }
            rounded(turned(place, &to_model))
        });
        input.add(corners);
    }
}

/// A quadrangle over most of the picture, tilted about any axis.
fn textured(input: &mut SpaceInput, random: &mut Random, ratio: f64) {
    let mut near_corner = || random.between(3.0, 20.0);
    let far = SPACE_SIZE as f64 - 1.0;
    let positions = [
        [near_corner(), near_corner()],
        [far - near_corner(), near_corner()],
        [far - near_corner(), far - near_corner()],
        [near_corner(), far - near_corner()],
    ];
    let angle = random.between(0.0, core::f64::consts::TAU);
    let along = positions.map(|[x, y]| x * libm::cos(angle) + y * libm::sin(angle));
    let (least, most) = along
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), along| {
            (least.min(*along), most.max(*along))
        });
    // Evenly on the screen varies the reciprocal of the distance.
    for (position, along) in positions.into_iter().zip(along) {
        let part = (along - least) / (most - least);
        let place = seen_at(position, 3_200.0 / (1.0 + (ratio - 1.0) * part));
        let _ = input.vertices.push(rounded(place));
    }
    for coordinates in [[0, 0], [4_096, 0], [4_096, 4_096], [0, 4_096]] {
        let _ = input.coordinates.push(coordinates);
    }
    for face in [[0, 1, 2], [0, 2, 3]] {
        let _ = input.faces.push(face);
    }
}
