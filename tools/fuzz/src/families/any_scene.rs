//! Scenes as hostile inputs: cameras, poses and models of few faces, for the families that draw scenes.

use anyhow::Context;
use arbitrary::{Arbitrary, Unstructured};
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{
        Rgb565,
        raw::{RawData, RawU16},
    },
    primitives::Rectangle,
};
use fixed::types::I16F16;
use zrow::scene::{
    Camera, DepthWidth, Edge as SceneEdge, FaceSet, Memory, Model, Pose, Prepared, Rotation, ScreenPrecision,
};
use zrow_methods::LookOf;

use crate::{
    families::view::Turn,
    target::Verdict,
    values::{Int, List, Number},
};

/// A coordinate of a vertex: around the origin mostly.
#[derive(Debug, Copy, Clone)]
pub struct Coordinate(pub i16);

impl<'a> Arbitrary<'a> for Coordinate {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=219 => i16::from(bytes.arbitrary::<i8>()?) * 8,
            _ => Number::<i16>::arbitrary(bytes)?.0,
        }))
    }
}

/// A translation along an axis, in units of the vertices.
#[derive(Debug, Copy, Clone)]
struct Way(I16F16);

impl<'a> Arbitrary<'a> for Way {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=199 => I16F16::from_num(i16::from(bytes.arbitrary::<i8>()?) * 4),
            200..=239 => I16F16::from_bits(bytes.arbitrary::<i32>()? >> 4),
            _ => I16F16::from_bits(Int::arbitrary(bytes)?.0),
        }))
    }
}

/// Where a model or the camera is.
#[derive(Debug, Clone, Arbitrary)]
pub struct AnyPose {
    turns: List<Turn, 2>,
    position: [Way; 3],
}

impl AnyPose {
    /// The pose, so many units farther along z.
    pub fn get(&self, ahead: i16) -> Pose {
        let rotation = self
            .turns
            .0
            .iter()
            .fold(Rotation::IDENTITY, |all, turn| all.then(&turn.get()));
        let [x, y, z] = self.position.map(|way| way.0);
        Pose::new(rotation, [x, y, z.saturating_add(I16F16::from_num(ahead))])
    }
}

/// A model of few faces.
#[derive(Debug, Clone, Arbitrary)]
pub struct AnyModel {
    vertices: List<[Coordinate; 3], 7>,
    faces: List<[u8; 3], 6>,
    pose: AnyPose,
    /// Colours that are missing.
    pub lacks: u8,
}

/// What a model is made of.
pub struct Mesh {
    pub vertices: Vec<[i16; 3]>,
    pub faces: Vec<[u16; 3]>,
    pub pose: Pose,
}

impl AnyModel {
    pub fn mesh(&self) -> Mesh {
        let vertices: Vec<_> = self.vertices.0.iter().map(|vertex| vertex.map(|axis| axis.0)).collect();
        let count = vertices.len() as u16;
        let faces = self.faces.0.iter().filter(|_| count > 0);
        let faces = faces.map(|face| face.map(|index| u16::from(index) % count)).collect();
        Mesh {
            vertices,
            faces,
            // In front of the camera, mostly.
            pose: self.pose.get(1_200),
        }
    }
}

/// A camera and models before it.
#[derive(Debug, Clone, Arbitrary)]
pub struct AnyScene {
    models: List<AnyModel, 3>,
    view: AnyView,
}

/// A camera.
#[derive(Debug, Clone, Arbitrary)]
pub struct AnyView {
    camera: AnyPose,
    moves: bool,
    corner: [Edge; 2],
    size: [u8; 2],
    near: Number<u16>,
    focal_length: Option<Number<u16>>,
}

/// Where a viewport begins.
#[derive(Debug, Copy, Clone, Arbitrary)]
enum Edge {
    Origin,
    Near(i8),
    Far(i16),
}

impl Edge {
    const fn get(self) -> i32 {
        match self {
            Self::Origin => 0,
            Self::Near(coordinate) => coordinate as i32,
            Self::Far(coordinate) => coordinate as i32,
        }
    }
}

/// Columns and rows of a viewport at most.
const MOST_SIZE: u32 = 24;

impl AnyView {
    /// A camera whose viewport is small; `None` where there is none.
    pub fn camera(&self) -> Option<Camera> {
        let [x, y] = self.corner.map(Edge::get);
        let [width, height] = self.size.map(|length| 1 + u32::from(length) % MOST_SIZE);
        let viewport = Rectangle::new(Point::new(x, y), Size::new(width, height));
        let near = I16F16::from_num(8 + self.near.0 % 2_000);
        let camera = Camera::new(viewport, near).ok()?;
        let camera = match self.focal_length {
            Some(length) => camera.with_focal_length(I16F16::from_num(1 + length.0 % 2_047)).ok()?,
            None => camera,
        };
        Some(if self.moves {
            camera.with_pose(self.camera.get(0))
        } else {
            camera
        })
    }
}

impl AnyScene {
    /// The camera before the models.
    pub fn camera(&self) -> Option<Camera> {
        self.view.camera()
    }

    pub fn meshes(&self) -> Vec<Mesh> {
        self.models.0.iter().map(AnyModel::mesh).collect()
    }

    /// Checks the prepared scene, with its camera and its models. What cannot be prepared is right: errors are `FrameCase`'s.
    pub fn with_prepared<S: ScreenPrecision, D: DepthWidth>(
        &self,
        check: impl FnOnce(&Camera, &[Model<'_, Rgb565>], Prepared<'_, '_, LookOf<Rgb565, S, D, true>>) -> Verdict,
    ) -> Verdict {
        let Some(camera) = self.camera() else {
            return Ok(());
        };
        let meshes = self.meshes();
        let colors = colors(&meshes);
        let models = models(&meshes, &colors)?;
        let mut frame = Large::<S, D, true>::new();
        match frame.prepare(&camera, &models) {
            Ok(prepared) => check(&camera, &models, prepared),
            Err(_) => Ok(()),
        }
    }
}

impl Mesh {
    /// The sides of all faces: those of faces with an even number as boundaries, the others as creases that have no other face.
    pub fn edges(&self) -> Vec<SceneEdge> {
        let sides = (0..).zip(&self.faces).flat_map(|(face, &[a, b, c])| {
            [[a, b], [b, c], [c, a]].map(|ends| match face % 2 {
                0 => SceneEdge::boundary(ends, face),
                _ => SceneEdge::crease(ends, [face; 2]),
            })
        });
        sides.collect()
    }
}

/// The colour of a face by its position in the order of models and faces.
pub fn color(face: usize) -> Rgb565 {
    Rgb565::from(RawU16::from_u32(0x8421 + 0x0102 * face as u32))
}

/// Models of the meshes, each face in a colour of its own.
pub fn models<'m>(meshes: &'m [Mesh], colors: &'m [Vec<Rgb565>]) -> anyhow::Result<Vec<Model<'m, Rgb565>>> {
    let pairs = meshes.iter().zip(colors);
    pairs
        .map(|(mesh, colors)| {
            let set = FaceSet::new(&mesh.vertices, &mesh.faces).context("indices that are there")?;
            Ok(Model::new(set, colors)
                .context("as many colours as faces")?
                .with_pose(mesh.pose))
        })
        .collect()
}

/// Colours of the faces of meshes, each of its own.
pub fn colors(meshes: &[Mesh]) -> Vec<Vec<Rgb565>> {
    let mut first = 0;
    meshes
        .iter()
        .map(|mesh| {
            let colors = (first..first + mesh.faces.len()).map(color).collect();
            first += mesh.faces.len();
            colors
        })
        .collect()
}

/// Room for every scene here.
pub type Large<S, D, const CLIPS: bool> = Memory<LookOf<Rgb565, S, D, CLIPS>, 512, 24, 24, 24, 24>;
/// A precision with a width of depths.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub enum Kind {
    CoarseNarrow,
    CoarseWide,
    FineNarrow,
    FineWide,
}

/// A case that is checked with the precision and the width of depths of its `kind`.
macro_rules! case_of_each_kind {
    ($case:ty) => {
        impl Case for $case {
            fn check(&self) -> Verdict {
                match self.kind {
                    Kind::CoarseNarrow => self.check_kind::<Sub4, u16>(),
                    Kind::CoarseWide => self.check_kind::<Sub4, u32>(),
                    Kind::FineNarrow => self.check_kind::<Sub8, u16>(),
                    Kind::FineWide => self.check_kind::<Sub8, u32>(),
                }
            }
        }
    };
}
pub(crate) use case_of_each_kind;
