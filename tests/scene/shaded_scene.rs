//! Shadings of the tests' own, whose pictures are numbers: the word of a pixel is one attribute with all its fractional
//! bits.

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888, raw::RawU16},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::{I16F16, U0F16};
use proptest::{prelude::*, strategy::ValueTree, test_runner::TestRunner};
use zrow::{
    band::Band,
    geometry::{SubPixel, TooSmall},
    scene::{Camera, FaceSet, Look, Memory, Model, Pose, Prepared},
    shade::{
        Bilinear, Blinn, Clamped, CutOut, DirectionalLight, Fog, Foggy, Gouraud, GouraudSkin, Indexed, IndexedImage,
        Lambert, LitTextured, LitTexturedSkin, Perspective, PointLight, Shading, Texels, Textured, TexturedSkin,
    },
};

use crate::common::config;
use crate::common::meshes::Mesh;
use crate::numbered_scene::area;
use crate::reference::nearest_faces::Face;

/// Numbers of the vertices of a model, and which of them the picture shows.
#[derive(Debug, Copy, Clone)]
pub struct Numbers<'a, const N: usize> {
    pub of_vertices: &'a [[i16; N]],
    pub shown: usize,
}

/// Numbers that vary evenly on the screen.
#[derive(Debug)]
pub struct Even<const N: usize>;

/// Numbers that vary evenly in space, divided at every `STEP`th pixel.
#[derive(Debug)]
pub struct InSpace<const N: usize, const TOLERANCE: u16 = 0, const STEP: i32 = 16>;

impl<const N: usize> Numbers<'_, N> {
    fn check(&self, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        let needed = mesh.vertices().len();
        if self.of_vertices.len() < needed {
            Err(TooSmall::Normals(needed))
        } else {
            Ok(())
        }
    }
}

macro_rules! shows_numbers {
    ($shading:ty, $attributes:ty, $tolerance:expr, $new:expr, $($parameters:tt)*) => {
        impl<$($parameters)*> Shading for $shading {
            type Color = Rgb888;
            type Skin<'a> = Numbers<'a, N>;
            type Uniforms = ();
            type Attributes = $attributes;
            const TOLERANCE: u16 = $tolerance;

            fn check(skin: &Numbers<'_, N>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
                skin.check(mesh)
            }

            fn uniforms(_: &Numbers<'_, N>, _: &Pose, _: &Camera) {}

            fn vertex(skin: &Numbers<'_, N>, (): &(), vertex: usize, _: [i32; 3]) -> $attributes {
                $new(skin.of_vertices[vertex])
            }

            fn fragment(skin: &Numbers<'_, N>, _: u32, values: &[i32; N]) -> Option<u32> {
                Some(values[skin.shown] as u32)
            }
        }
    };
}
shows_numbers!(Even<N>, [i16; N], 0, |numbers| numbers, const N: usize);
shows_numbers!(InSpace<N, TOLERANCE, STEP>, Perspective<N, STEP>, TOLERANCE, Perspective, const N: usize, const TOLERANCE: u16, const STEP: i32);

/// The word of a pixel that nothing was drawn to: no attribute has it, because the least one is half a unit above it.
pub const UNTOUCHED: u32 = 0x8000_0000;

/// The words of an area, drawn in one band.
pub fn words<L: Look<Color = Rgb888>>(prepared: &mut Prepared<'_, '_, L>, area: Rectangle) -> Vec<u32> {
    let mut words = vec![UNTOUCHED; (area.size.width * area.size.height) as usize];
    prepared.draw(&mut Band::<Rgb888>::new(area, &mut words).unwrap());
    words
}

/// Columns and rows of the viewport of [`camera_in_units`].
pub const SIZE: [u32; 2] = [121, 79];

pub type SmallMemory<L> = Memory<L, 64, 8, { SIZE[0] as usize }, { SIZE[1] as usize }, 8>;

/// A camera for which a vertex at a distance of 1,024 is as many 1/16 pixels away from pixel (60, 39) as its
/// coordinates say.
pub fn camera_in_units() -> Camera {
    Camera::new(area(SIZE[0], SIZE[1]), I16F16::from_num(128))
        .unwrap()
        .with_focal_length(I16F16::from_num(64))
        .unwrap()
}

/// Pixels that a single snapped face covers, with their positions in units and their index in the picture of an area at
/// the origin.
pub fn covered(face: &Face, area: Rectangle, unit: i128) -> impl Iterator<Item = (Point, [i128; 2], usize)> + '_ {
    area.points().enumerate().filter_map(move |(index, point)| {
        let [x, y] = [point.x, point.y].map(|pixels| i128::from(pixels) * unit);
        face.covers(x, y).then_some((point, [x, y], index))
    })
}

/// How many units a pixel has in a look.
pub fn unit<L: Look>() -> i128 {
    1 << L::Precision::FRACTION_BITS
}

/// A mesh of one triangle, seen from both sides.
pub fn triangle(corners: [[i16; 3]; 3]) -> Mesh {
    Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).two_sided()
}

/// A model of a mesh that shows a number of its vertices.
pub fn model<'a, H, const N: usize>(mesh: &'a Mesh, of_vertices: &'a [[i16; N]], shown: usize) -> Model<'a, H>
where
    H: for<'s> Shading<Skin<'s> = Numbers<'s, N>>,
{
    Model::with_skin(mesh.face_set(), Numbers { of_vertices, shown }).unwrap()
}

/// Any attribute, more often one of the greatest.
pub fn number() -> BoxedStrategy<i16> {
    prop_oneof![
        3 => any::<i16>(),
        1 => prop::sample::select(vec![i16::MIN, i16::MIN + 1, -1, 0, 1, i16::MAX]),
    ]
    .boxed()
}

/// Corners at a distance of 1,024, in 1/16 pixel from the middle of the viewport: of triangles of any size that are not
/// cut, and of slivers.
pub fn flat_corners() -> BoxedStrategy<[[i16; 3]; 3]> {
    let within = |size: i16| prop::array::uniform3(prop::array::uniform2(-size..=size));
    let sliver = (
        prop::array::uniform2(-900i16..=900),
        prop::array::uniform2(-3i16..=3),
        prop::array::uniform2(-900i16..=900),
    )
        .prop_map(|(a, [x, y], c)| [a, [a[0] + x, a[1] + y], c]);
    prop_oneof![3 => within(1_100), 1 => within(100), 2 => within(15_000), 2 => sliver]
        .prop_map(|corners| corners.map(|[x, y]| [x, y, 1_024]))
        .boxed()
}

/// What vertices may have beside their positions.
#[derive(Debug, Clone)]
pub struct VertexData {
    pub colors: Vec<Rgb565>,
    pub normals: Vec<[i8; 2]>,
    /// Texture coordinates, or any numbers.
    pub coordinates: Vec<[i16; 2]>,
    pub light: DirectionalLight,
}

pub fn vertex_data(count: usize) -> BoxedStrategy<VertexData> {
    let colors = prop::collection::vec(any::<u16>().prop_map(|word| Rgb565::from(RawU16::new(word))), count);
    let normals = prop::collection::vec(any::<[i8; 2]>(), count);
    let coordinates = prop::collection::vec(prop::array::uniform2(-8_000i16..8_000), count);
    let light = prop::array::uniform3(-100i32..100).prop_map(|[x, y, z]| {
        let towards = [x, y, z - 101].map(I16F16::from_num);
        DirectionalLight::from_direction(towards, U0F16::MAX).unwrap()
    });
    (colors, normals, coordinates, light)
        .prop_map(|(colors, normals, coordinates, light)| VertexData {
            colors,
            normals,
            coordinates,
            light,
        })
        .boxed()
}

/// Normals, colours and texture coordinates of so many vertices, always the same ones.
pub fn data(count: usize) -> VertexData {
    vertex_data(count)
        .new_tree(&mut TestRunner::new(config(1)))
        .expect("a strategy without filters")
        .current()
}

/// A shading that makes a model of any data.
pub trait Skinned: Shading {
    fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self>
    where
        Self: Sized;
}

fn lights(data: &VertexData) -> Lambert<1> {
    Lambert {
        ambient: U0F16::from_num(0.25),
        lights: [data.light],
        points: [],
    }
}

impl Skinned for Gouraud<Rgb565> {
    fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self> {
        let skin = GouraudSkin {
            colors: &data.colors,
            normals: &data.normals,
            lights: lights(data),
        };
        Model::with_skin(mesh.face_set(), skin).unwrap()
    }
}

/// Texels that all differ.
pub static TEXELS: [[u16; 16]; 16] = {
    let mut texels = [[0; 16]; 16];
    let mut index = 0;
    while index < 256 {
        texels[index / 16][index % 16] = (index * 251 + 77) as u16;
        index += 1;
    }
    texels
};

impl Skinned for Textured<Texels<Rgb565, 16, 16>> {
    fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self> {
        let skin = TexturedSkin {
            image: &TEXELS,
            coordinates: &data.coordinates,
        };
        Model::with_skin(mesh.face_set(), skin).unwrap()
    }
}

impl Skinned for LitTextured<Texels<Rgb565, 16, 16>> {
    fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self> {
        let skin = LitTexturedSkin {
            image: &TEXELS,
            coordinates: &data.coordinates,
            normals: &data.normals,
            lights: lights(data),
        };
        Model::with_skin(mesh.face_set(), skin).unwrap()
    }
}

/// Indices of four colours of a palette, one of which is a hole for some textures.
static INDICES: [[u8; 2]; 8] = [
    [0x1b, 0xe4],
    [0xff, 0x50],
    [0x3c, 0xc3],
    [0xaa, 0x05],
    [0x72, 0x8d],
    [0x0f, 0xf1],
    [0x99, 0x66],
    [0x58, 0x2b],
];
static PALETTE: [u16; 4] = [0xf81f, 0xffe0, 0x07ff, 0x8410];

/// A texture of four colours.
pub type FourColors = Indexed<Rgb565, 2, 8, 4>;

macro_rules! skinned_by_palette {
    ($($texture:ty),+) => {$(
        impl Skinned for Textured<$texture> {
            fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self> {
                let image = IndexedImage {
                    indices: &INDICES,
                    palette: &PALETTE,
                };
                let coordinates = &data.coordinates;
                Model::with_skin(mesh.face_set(), TexturedSkin { image, coordinates }).unwrap()
            }
        }
    )+};
}
skinned_by_palette!(FourColors, CutOut<FourColors>, Bilinear<Clamped<CutOut<FourColors>>>);

/// Directional light, a light from a point and highlights.
pub type Shiny = Blinn<1, 1>;

impl Skinned for Gouraud<Rgb565, Shiny> {
    fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self> {
        let point = PointLight {
            position: [-300, 500, 400].map(I16F16::from_num),
            intensity: U0F16::MAX,
            half_distance: 900,
        };
        let Lambert { ambient, lights, .. } = lights(data);
        let skin = GouraudSkin {
            colors: &data.colors,
            normals: &data.normals,
            lights: Blinn {
                diffuse: Lambert {
                    ambient,
                    lights,
                    points: [point],
                },
                strength: U0F16::from_num(0.5),
                sharpness: 3,
            },
        };
        Model::with_skin(mesh.face_set(), skin).unwrap()
    }
}

impl<H: Skinned<Color = Rgb565>> Skinned for Foggy<H> {
    fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self> {
        // Each model in a fog of its own, so that pictures tell them apart.
        let fog = Fog {
            color: data.colors.first().copied().unwrap_or(Rgb565::WHITE),
            start: I16F16::from_num(900 + i32::from(data.normals.first().map_or(0, |normal| normal[0]))),
            end: I16F16::from_num(2_400),
            curve: Fog::LINEAR,
        };
        Model::with_skin(mesh.face_set(), (*H::model(mesh, data).skin(), fog)).unwrap()
    }
}

impl Skinned for Even<2> {
    fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self> {
        model(mesh, &data.coordinates, 0)
    }
}

impl<const TOLERANCE: u16, const STEP: i32> Skinned for InSpace<2, TOLERANCE, STEP> {
    fn model<'a>(mesh: &'a Mesh, data: &'a VertexData) -> Model<'a, Self> {
        model(mesh, &data.coordinates, 1)
    }
}
