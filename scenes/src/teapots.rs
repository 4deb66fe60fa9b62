//! The Utah teapot as scenes: flat, under a light in one colour, and under a light with a texture. And a square with a texture.

use core::marker::PhantomData;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use fixed::types::{I16F16, U0F16};
use zrow::{
    scene::{Counted, FacePlanes, FaceSet, Model, Rotation, Whole},
    shade::{
        DirectionalLight, FlatLit, FlatLitSkin, Gouraud, GouraudSkin, Lambert, LitTextured, LitTexturedSkin, Shading,
        Texels, Textured, TexturedSkin, WithPlanes,
    },
};

use crate::{
    meshes::face_set,
    paint::rgb,
    standard::{Subject, Turning, angle, model},
    teapot::{TEAPOT, TEAPOT_COLORS, TEAPOT_COORDINATES, TEAPOT_FACE_NORMALS, TEAPOT_NORMALS, TEAPOT_PLANES},
};

/// From where the teapot fills the width of an upright panel when its spout swings outwards.
pub(crate) const DISTANCE: I16F16 = I16F16::lit("736");
/// The frame in which lid, handle and spout are seen.
pub(crate) const PORTRAIT: u32 = 63;
/// An upright panel.
pub(crate) const SIZE: Size = Size::new(240, 320);
/// Texels of a side of the texture.
pub(crate) const TEXELS: usize = 64;

/// The colour of a teapot without a texture.
pub(crate) const CLAY: &[Rgb565] = &[rgb(236, 188, 150)];

/// The light of the teapots, from the upper left.
pub const LIGHT: Lambert<1> = one_light(
    U0F16::lit("0.25"),
    [I16F16::lit("-0.5"), I16F16::lit("0.7"), I16F16::lit("-0.6")],
    U0F16::lit("0.75"),
);

/// Ambient light, and one light from a direction.
pub(crate) const fn one_light(ambient: U0F16, direction: [I16F16; 3], intensity: U0F16) -> Lambert<1> {
    let light = match DirectionalLight::from_direction(direction, intensity) {
        Ok(light) => light,
        Err(_) => panic!("a direction without length"),
    };
    Lambert {
        ambient,
        lights: [light],
        points: [],
    }
}

/// Blue on white, as on porcelain: rings, and between them a row of diamonds.
pub static PORCELAIN: [[u16; TEXELS]; TEXELS] = {
    let mut texels = [[0; TEXELS]; TEXELS];
    let mut row = 0;
    while row < TEXELS {
        let mut column = 0;
        while column < TEXELS {
            texels[row][column] = porcelain(column as i32, row as i32);
            column += 1;
        }
        row += 1;
    }
    texels
};

/// A texel of the texture, as a word.
pub(crate) const fn porcelain(column: i32, row: i32) -> u16 {
    const WHITE: u16 = word(244, 244, 236);
    const BLUE: u16 = word(36, 70, 170);
    const PALE_BLUE: u16 = word(140, 170, 224);
    // The pattern repeats twice in each direction.
    let (x, y) = (column % 32, row % 32);
    let (across, down) = ((x - 16).abs(), (y - 14).abs());
    if y >= 28 {
        BLUE
    } else if across + down < 5 {
        PALE_BLUE
    } else if across + down < 10 {
        BLUE
    } else if y == 26 {
        PALE_BLUE
    } else {
        WHITE
    }
}

/// A colour as a word: the levels of red, green and blue, from 0 to 255.
pub(crate) const fn word(red: u16, green: u16, blue: u16) -> u16 {
    (red >> 3) << 11 | (green >> 2) << 5 | blue >> 3
}

/// A model whose skin is checked against its mesh by the tests.
pub(crate) fn shaded<H: Shading>(mesh: FaceSet<'static>, skin: H::Skin<'static>) -> Model<'static, H> {
    match Model::with_skin(mesh, skin) {
        Ok(model) => model,
        Err(_) => panic!("a skin that is too small for its mesh"),
    }
}

/// The teapot in a colour for each face.
#[derive(Debug)]
pub struct FlatPot;

impl Subject for FlatPot {
    const NAME: &'static str = "teapot-flat";
    const TITLE: &'static str = "Utah teapot, flat";
    const SIZE: Size = SIZE;
    const DISTANCE: I16F16 = DISTANCE;
    const PORTRAIT: u32 = PORTRAIT;
    type Shading = Rgb565;

    fn model() -> Model<'static, Rgb565> {
        const { model(TEAPOT, &TEAPOT_COLORS) }
    }
}

/// The teapot in one colour under a light, each face in one brightness.
#[derive(Debug)]
pub struct FlatLitPot;

impl Subject for FlatLitPot {
    const NAME: &'static str = "teapot-flat-lit";
    const TITLE: &'static str = "Utah teapot, flat shading";
    const SIZE: Size = SIZE;
    const DISTANCE: I16F16 = DISTANCE;
    const PORTRAIT: u32 = PORTRAIT;
    type Shading = FlatLit<Rgb565>;

    fn model() -> Model<'static, FlatLit<Rgb565>> {
        shaded(
            TEAPOT,
            FlatLitSkin {
                colors: CLAY,
                normals: &TEAPOT_FACE_NORMALS,
                lights: LIGHT,
            },
        )
    }
}

/// The teapot in one colour under a light.
#[derive(Debug)]
pub struct GouraudPot;

impl Subject for GouraudPot {
    const NAME: &'static str = "teapot-gouraud";
    const TITLE: &'static str = "Utah teapot, Gouraud shading";
    const SIZE: Size = SIZE;
    const DISTANCE: I16F16 = DISTANCE;
    const PORTRAIT: u32 = PORTRAIT;
    type Shading = Gouraud<Rgb565>;

    fn model() -> Model<'static, Gouraud<Rgb565>> {
        shaded(
            TEAPOT,
            GouraudSkin {
                colors: CLAY,
                normals: &TEAPOT_NORMALS,
                lights: LIGHT,
            },
        )
    }
}

/// The teapot with a texture under a light.
#[derive(Debug)]
pub struct TexturedPot;

impl Subject for TexturedPot {
    const NAME: &'static str = "teapot";
    const TITLE: &'static str = "Utah teapot, lit and textured";
    const SIZE: Size = SIZE;
    const DISTANCE: I16F16 = DISTANCE;
    const PORTRAIT: u32 = PORTRAIT;
    type Shading = LitTextured<Texels<Rgb565, TEXELS, TEXELS>>;

    fn model() -> Model<'static, Self::Shading> {
        shaded(
            TEAPOT,
            LitTexturedSkin {
                image: &PORCELAIN,
                coordinates: &TEAPOT_COORDINATES,
                normals: &TEAPOT_NORMALS,
                lights: LIGHT,
            },
        )
    }
}

/// A teapot with the planes of its faces, by which those are left out that are turned away.
#[derive(Debug)]
pub struct PlanePot<S>(PhantomData<S>);

impl<S: Subject> Subject for PlanePot<S> {
    const NAME: &'static str = "teapot-planes";
    const TITLE: &'static str = "Utah teapot, back faces culled by their planes";
    const SIZE: Size = SIZE;
    const DISTANCE: I16F16 = DISTANCE;
    const PORTRAIT: u32 = PORTRAIT;
    type Shading = WithPlanes<S::Shading>;

    fn model() -> Model<'static, Self::Shading> {
        const PLANES: FacePlanes = match FacePlanes::new(&TEAPOT, &TEAPOT_PLANES) {
            Ok(planes) => planes,
            Err(_) => panic!("a plane is missing"),
        };
        shaded(TEAPOT, (*S::model().skin(), PLANES))
    }
}

/// A square with a texture, askew: it covers about as much as one of 200 x 200 pixels that faces the viewer.
#[derive(Debug)]
pub struct TexturedSquare;

impl Subject for TexturedSquare {
    const NAME: &'static str = "square";
    const TITLE: &'static str = "a square with a texture";
    const SIZE: Size = SIZE;
    type Shading = Textured<Texels<Rgb565, TEXELS, TEXELS>>;

    /// The rotation of the square in a frame: tilted back, it sways by a sixteenth of a turn to both sides.
    fn rotation(frame: u32) -> Rotation {
        let swing = frame % 64;
        Rotation::about_x(angle(32)).then(&Rotation::about_y(angle(512 - 32 + swing)))
    }

    fn model() -> Model<'static, Self::Shading> {
        // At the distance of a standard scene, where 12.8 units are a pixel.
        static SQUARE: FaceSet = face_set(
            &[[-1280, -1280, 0], [1280, -1280, 0], [1280, 1280, 0], [-1280, 1280, 0]],
            &[[0, 2, 1], [0, 3, 2]],
        );
        shaded(
            SQUARE,
            TexturedSkin {
                image: &PORCELAIN,
                coordinates: &[[0, 8192], [8192, 8192], [8192, 0], [0, 0]],
            },
        )
    }
}

/// The teapot in one colour under a light, turning: up to 91 faces cross a row.
pub type GouraudTeapot = Turning<GouraudPot, { TEAPOT.vertices().len() }, { TEAPOT.faces().len() }, 240, 320, 91>;
/// The teapot with a texture under a light, turning: up to 91 faces cross a row.
/// No face has to be cut, so that no vertex keeps its texture coordinates.
pub type TexturedTeapot = Turning<
    TexturedPot,
    { TEAPOT.vertices().len() },
    { TEAPOT.faces().len() },
    240,
    320,
    91,
    Whole<<TexturedPot as Subject>::Shading>,
>;
/// [`TexturedTeapot`] with counters of what each frame takes.
pub type CountedTeapot = Turning<
    TexturedPot,
    { TEAPOT.vertices().len() },
    { TEAPOT.faces().len() },
    240,
    320,
    91,
    Counted<Whole<<TexturedPot as Subject>::Shading>>,
>;
