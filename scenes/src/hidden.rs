//! Scenes in which faces hide each other, of any number of faces and of any number of layers, to compare methods of visibility.

use embedded_graphics::pixelcolor::Rgb565;
use fixed::types::I16F16;
use zrow::{
    geometry::InputError,
    scene::{FaceSet, Model, Pose, Rotation},
    shade::{Texels, Textured, TexturedSkin},
};

use crate::{
    paint::rgb,
    sine::{TURN, sine},
    standard::angle,
    teapots::{PORCELAIN, TEXELS},
};

/// The most faces of a scene, and the vertices that they need.
pub const MOST_FACES: usize = 4_992;
/// The most vertices of a scene.
pub const MOST_VERTICES: usize = 2_500;

/// How the faces of two spheres are counted: segments around each sphere, and bands from pole to pole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Spheres {
    /// The number of faces of both spheres together: four for each segment and each ring of vertices between the poles.
    pub faces: usize,
    segments: u16,
    bands: u16,
}

/// Two spheres that go through each other, from bodies of six faces on.
pub const SPHERES: [Spheres; 6] = [
    spheres(3, 2),
    spheres(4, 4),
    spheres(8, 7),
    spheres(16, 13),
    spheres(32, 25),
    spheres(48, 27),
];

/// The numbers of walls, one behind the other, of the scenes that [`HiddenFaces::set_layers`] makes.
pub const LAYERS: [usize; 5] = [1, 2, 4, 8, 16];

const fn spheres(segments: u16, bands: u16) -> Spheres {
    Spheres {
        faces: 4 * segments as usize * (bands as usize - 1),
        segments,
        bands,
    }
}

/// A scene in memory.
#[derive(Debug)]
pub struct HiddenFaces {
    vertices: [[i16; 3]; MOST_VERTICES],
    faces: [[u16; 3]; MOST_FACES],
    colors: [Rgb565; MOST_FACES],
    coordinates: [[i16; 2]; MOST_VERTICES],
    vertex_count: usize,
    face_count: usize,
}

impl HiddenFaces {
    /// A scene without faces.
    pub const EMPTY: Self = Self {
        vertices: [[0; 3]; MOST_VERTICES],
        faces: [[0; 3]; MOST_FACES],
        colors: [rgb(0, 0, 0); MOST_FACES],
        coordinates: [[0; 2]; MOST_VERTICES],
        vertex_count: 0,
        face_count: 0,
    };

    /// The number of vertices.
    pub const fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The number of faces.
    pub const fn face_count(&self) -> usize {
        self.face_count
    }

    /// Makes it two spheres side by side that go through each other.
    pub fn set_spheres(&mut self, spheres: &Spheres) {
        (self.vertex_count, self.face_count) = (0, 0);
        for center in [[-260, -40, 0], [260, 40, 90]] {
            self.add_sphere(center, spheres);
        }
    }

    fn add_sphere(&mut self, [x, y, z]: [i32; 3], &Spheres { segments, bands, .. }: &Spheres) {
        const RADIUS: i32 = 600;
        let first = self.vertex_count as u16;
        let along = |length: i32, sine: i32| (length * sine + 8192) >> 14;
        // Rings of vertices between the poles, which come last.
        for ring in 1..bands {
            let polar = TURN / 2 * u32::from(ring) / u32::from(bands);
            let (radius, height) = (along(RADIUS, sine(polar)), along(RADIUS, sine(polar + TURN / 4)));
            for segment in 0..segments {
                let turn = TURN * u32::from(segment) / u32::from(segments);
                let [right, ahead] = [sine(turn + TURN / 4), sine(turn)].map(|sine| along(radius, sine));
                self.add_vertex([x + right, y + height, z + ahead]);
            }
        }
        let [top, bottom] = [RADIUS, -RADIUS].map(|height| self.add_vertex([x, y + height, z]));
        let vertex = |ring: u16, segment: u16| first + (ring - 1) * segments + segment % segments;
        for segment in 0..segments {
            let next = segment + 1;
            self.add_face([top, vertex(1, next), vertex(1, segment)]);
            for ring in 1..bands - 1 {
                let [a, b, c, d] = [
                    vertex(ring, segment),
                    vertex(ring, next),
                    vertex(ring + 1, next),
                    vertex(ring + 1, segment),
                ];
                self.add_face([a, b, c]);
                self.add_face([a, c, d]);
            }
            self.add_face([bottom, vertex(bands - 1, segment), vertex(bands - 1, next)]);
        }
    }

    /// Makes it walls of two faces each that fill the picture, in a random order.
    pub fn set_layers(&mut self, layers: usize) {
        const HALF: i32 = 2500;
        (self.vertex_count, self.face_count) = (0, 0);
        // xorshift32 (Marsaglia 2003).
        let mut state = 0x9E37_79B9_u32;
        let mut random = |most: i32| {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            ((state >> 8) % (2 * most as u32 + 1)) as i32 - most
        };
        for _ in 0..layers {
            let [z, right, up] = [400, 150, 150].map(&mut random);
            let corners = [(-1, -1), (-1, 1), (1, 1), (1, -1)];
            let [a, b, c, d] = corners.map(|(x, y)| self.add_vertex([x * HALF, y * HALF, z + x * right + y * up]));
            self.add_face([a, b, c]);
            self.add_face([a, c, d]);
        }
    }

    fn add_vertex(&mut self, position: [i32; 3]) -> u16 {
        let index = self.vertex_count;
        if let (Some(vertex), Some(coordinates)) = (self.vertices.get_mut(index), self.coordinates.get_mut(index)) {
            *vertex = position.map(|part| part as i16);
            // A side of the texture is 512 units.
            *coordinates = [0, 1].map(|axis| position.get(axis).map_or(0, |part| (part * 8) as i16));
            self.vertex_count += 1;
        }
        index as u16
    }

    fn add_face(&mut self, corners: [u16; 3]) {
        let index = self.face_count;
        if let (Some(face), Some(color)) = (self.faces.get_mut(index), self.colors.get_mut(index)) {
            *face = corners;
            let shade = (index * 37 % 160) as u8;
            *color = rgb(64 + shade, 96 + shade / 2, 200 - shade);
            self.face_count += 1;
        }
    }

    fn mesh(&self) -> Result<FaceSet<'_>, InputError> {
        FaceSet::new(
            self.vertices.get(..self.vertex_count).unwrap_or_default(),
            self.faces.get(..self.face_count).unwrap_or_default(),
        )
    }

    /// The scene in a colour a face, as it is turned in a frame.
    ///
    /// # Errors
    /// None: faces name vertices that are there, and all of them have a colour.
    pub fn flat(&self, frame: u32) -> Result<Model<'_, Rgb565>, InputError> {
        Ok(Model::new(self.mesh()?, &self.colors)?.with_pose(pose(frame)))
    }

    /// The scene with a texture, as it is turned in a frame.
    ///
    /// # Errors
    /// None: faces name vertices that are there, and all of them have texture coordinates.
    pub fn textured(&self, frame: u32) -> Result<Model<'_, Textured<Texels<Rgb565, TEXELS, TEXELS>>>, InputError> {
        let skin = TexturedSkin {
            image: &PORCELAIN,
            coordinates: &self.coordinates,
        };
        Ok(Model::with_skin(self.mesh()?, skin)?.with_pose(pose(frame)))
    }
}

/// The scene three lengths before the camera, swaying by a sixteenth of a turn.
fn pose(frame: u32) -> Pose {
    let rotation = Rotation::about_y(angle(512 - 32 + frame % 64));
    Pose::new(rotation, [I16F16::ZERO, I16F16::ZERO, I16F16::lit("1536")])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_has_as_many_faces_as_it_says() -> Result<(), InputError> {
        let mut scene = HiddenFaces::EMPTY;
        assert_eq!(
            SPHERES.map(|spheres| spheres.faces),
            [12, 48, 192, 768, 3_072, MOST_FACES]
        );
        for spheres in &SPHERES {
            scene.set_spheres(spheres);
            assert_eq!(scene.face_count(), spheres.faces);
            // Euler: of each sphere, twice as many faces as vertices less two.
            assert_eq!(scene.face_count(), 2 * scene.vertex_count() - 8);
            assert!(scene.flat(0).is_ok() && scene.textured(0).is_ok());
        }
        for layers in LAYERS {
            scene.set_layers(layers);
            assert_eq!((scene.face_count(), scene.vertex_count()), (2 * layers, 4 * layers));
        }
        Ok(())
    }
}
