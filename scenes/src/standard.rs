//! The standard scenes: meshes that turn in front of the camera, on a small panel and on a larger one.

use core::marker::PhantomData;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::{Band, Order},
    scene::{self, Camera, FaceSet, Look, Memory, Model, Pose, Rotation},
    shade::Shading,
};

use crate::{
    PrepareError, Prepared, Scene,
    meshes::{CUBE, CUBE_COLORS, ICOSPHERE, ICOSPHERE_COLORS, TORUS_AND_CUBE, TORUS_AND_CUBE_COLORS},
    paint::rgb,
};

/// A quarter of a length of 1, in units of the vertices.
pub(crate) const NEAR: I16F16 = I16F16::lit("128");
const FRAMES: u32 = 64;

/// The camera of a standard scene, and where its subject is in a frame.
pub fn stage<S: Subject>(area: Rectangle, frame: u32) -> Result<(Camera, Pose), PrepareError> {
    Ok((
        Camera::new(area, NEAR)?,
        Pose::new(S::rotation(frame), [I16F16::ZERO, I16F16::ZERO, S::DISTANCE]),
    ))
}

/// An angle in steps of 1/512 of a turn.
pub(crate) fn angle(steps: u32) -> U0F16 {
    U0F16::from_bits((steps % 512 * 128) as u16)
}

/// What turns, and where it is shown.
pub trait Subject: core::fmt::Debug {
    /// See [`Scene::NAME`].
    const NAME: &'static str;
    /// See [`Scene::TITLE`].
    const TITLE: &'static str;
    /// Size of the panel.
    const SIZE: Size;
    /// From the camera to the middle of the mesh: three lengths of 1, where nothing else is said.
    const DISTANCE: I16F16 = I16F16::lit("1536");
    /// The frame that shows it best.
    const PORTRAIT: u32 = 5;
    /// How its faces get their colours.
    type Shading: Shading<Color = Rgb565>;

    /// How it is turned in a frame: once about x and twice about y in 64 frames, where nothing else is said.
    fn rotation(frame: u32) -> Rotation {
        Rotation::about_x(angle(frame * 8)).then(&Rotation::about_y(angle(frame * 16)))
    }

    /// The mesh and its skin.
    fn model() -> Model<'static, Self::Shading>;
}

/// A mesh of `V` vertices and `F` faces that turns on a panel of `COLUMNS` by `ROWS` pixels; up to `A` faces cross a row. Its
/// look is the shading, where no other one is named.
#[derive(Debug)]
pub struct Turning<
    S: Subject,
    const V: usize,
    const F: usize,
    const COLUMNS: usize,
    const ROWS: usize,
    const A: usize,
    L: Look<Color = Rgb565, Shading = S::Shading> = <S as Subject>::Shading,
> {
    memory: Memory<L, V, F, COLUMNS, ROWS, A>,
    models: [Model<'static, S::Shading>; 1],
    subject: PhantomData<S>,
}

impl<S: Subject, L, const V: usize, const F: usize, const COLUMNS: usize, const ROWS: usize, const A: usize> Default
    for Turning<S, V, F, COLUMNS, ROWS, A, L>
where
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    fn default() -> Self {
        Self {
            memory: Memory::new(),
            models: [S::model()],
            subject: PhantomData,
        }
    }
}

impl<S: Subject, L, const V: usize, const F: usize, const COLUMNS: usize, const ROWS: usize, const A: usize> Scene
    for Turning<S, V, F, COLUMNS, ROWS, A, L>
where
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    type Color = Rgb565;
    type Prepared<'s>
        = scene::Prepared<'s, 'static, L>
    where
        S: 's;
    const NAME: &'static str = S::NAME;
    const TITLE: &'static str = S::TITLE;
    const AREA: Rectangle = Rectangle::new(Point::zero(), S::SIZE);
    const BACKGROUND: Rgb565 = rgb(12, 16, 24);
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = S::PORTRAIT;
    const DEPTH_ROW_BYTES: usize = size_of::<[u16; COLUMNS]>();

    fn prepare(&mut self, frame: u32) -> Result<Self::Prepared<'_>, PrepareError> {
        let (camera, pose) = stage::<S>(Self::AREA, frame % FRAMES)?;
        for model in &mut self.models {
            model.pose = pose;
        }
        self.memory.prepare(&camera, &self.models)
    }
}

impl<L: Look<Color = Rgb565>> Prepared for scene::Prepared<'_, '_, L> {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        Self::draw(self, band);
    }
}

/// The torus and the cube with their colours.
pub(crate) const TORUS_AND_CUBE_MODEL: Model<'static, Rgb565> = model(TORUS_AND_CUBE, &TORUS_AND_CUBE_COLORS);

pub(crate) const fn model(mesh: FaceSet<'static>, colors: &'static [Rgb565]) -> Model<'static, Rgb565> {
    match Model::new(mesh, colors) {
        Ok(model) => model,
        Err(_) => panic!("a face has no colour"),
    }
}

macro_rules! subjects {
    ($($subject:ident: $name:literal, $title:literal, $width:literal x $height:literal, $mesh:ident, $colors:ident;)+) => {$(
        #[doc = concat!("The ", $title, ", as it is set up for its panel.")]
        #[derive(Debug)]
        pub struct $subject;

        impl Subject for $subject {
            const NAME: &'static str = $name;
            const TITLE: &'static str = $title;
            const SIZE: Size = Size::new($width, $height);
            type Shading = Rgb565;

            fn model() -> Model<'static, Rgb565> {
                const { model($mesh, &$colors) }
            }
        }
    )+};
}

subjects! {
    SmallTorus: "sc1", "torus and cube, small", 128 x 64, TORUS_AND_CUBE, TORUS_AND_CUBE_COLORS;
    SmallSphere: "sc2", "icosphere, small", 128 x 64, ICOSPHERE, ICOSPHERE_COLORS;
    SmallCube: "sc3", "cube, small", 128 x 64, CUBE, CUBE_COLORS;
    Torus: "torus-cube", "torus and cube", 320 x 240, TORUS_AND_CUBE, TORUS_AND_CUBE_COLORS;
    Sphere: "icosphere", "icosphere", 320 x 240, ICOSPHERE, ICOSPHERE_COLORS;
    Cube: "cube", "cube", 320 x 240, CUBE, CUBE_COLORS;
}

/// Standard scene 1: 588 faces.
pub type Sc1 = Turning<SmallTorus, { TORUS_AND_CUBE.vertices().len() }, { TORUS_AND_CUBE.faces().len() }, 128, 64, 60>;
/// Standard scene 2: 320 faces.
pub type Sc2 = Turning<SmallSphere, { ICOSPHERE.vertices().len() }, { ICOSPHERE.faces().len() }, 128, 64, 20>;
/// Standard scene 3: 12 faces.
pub type Sc3 = Turning<SmallCube, { CUBE.vertices().len() }, { CUBE.faces().len() }, 128, 64, 6>;
/// Standard scene 1 on a larger panel.
pub type TorusAndCube =
    Turning<Torus, { TORUS_AND_CUBE.vertices().len() }, { TORUS_AND_CUBE.faces().len() }, 320, 240, 60>;
/// Standard scene 2 on a larger panel.
pub type Icosphere = Turning<Sphere, { ICOSPHERE.vertices().len() }, { ICOSPHERE.faces().len() }, 320, 240, 20>;
/// Standard scene 3 on a larger panel.
pub type TurningCube = Turning<Cube, { CUBE.vertices().len() }, { CUBE.faces().len() }, 320, 240, 6>;
