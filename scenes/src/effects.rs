//! The Utah teapot with one effect at a time, and with all of them: what each adds to a plain one is what it costs.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use fixed::types::{I16F16, U0F16};
use zrow::{
    scene::{Antialiased, Deep, FaceSet, Fine, Model, Multisampled, OnePass, Whole},
    shade::{
        Bilinear, Blinn, CutOut, Fog, Foggy, Gouraud, GouraudSkin, Indexed, IndexedImage, Lambert, LitTextured,
        LitTexturedSkin, PointLight, Texels, Textured, TexturedSkin, Translucent,
    },
};

use crate::{
    paint::rgb,
    standard::{Subject, Turning},
    teapot::{TEAPOT, TEAPOT_COLORS, TEAPOT_COORDINATES, TEAPOT_NEIGHBOURS, TEAPOT_NORMALS},
    teapots::{CLAY, DISTANCE, LIGHT, PORCELAIN, PORTRAIT, SIZE, TEXELS, porcelain, shaded},
};

/// A lamp at the upper right, near the pot.
const LAMP: PointLight = PointLight {
    position: [I16F16::lit("420"), I16F16::lit("420"), I16F16::lit("300")],
    intensity: U0F16::lit("0.99"),
    half_distance: 500,
};

/// The light of a lamp alone.
const LAMPLIGHT: Lambert<0, 1> = Lambert {
    ambient: U0F16::lit("0.125"),
    lights: [],
    points: [LAMP],
};

/// The teapots' light, on glazed clay.
const GLAZE: Blinn<1> = Blinn {
    diffuse: LIGHT,
    strength: U0F16::lit("0.6"),
    sharpness: 5,
};

/// The teapots' light and a lamp, on glazed clay.
const GLAZE_IN_LAMPLIGHT: Blinn<1, 1> = Blinn {
    diffuse: Lambert {
        ambient: LIGHT.ambient,
        lights: LIGHT.lights,
        points: [LAMP],
    },
    strength: U0F16::lit("0.6"),
    sharpness: 5,
};

/// A fog in which the far side of the pot is half gone.
const FOG: Fog<'static, Rgb565> = Fog {
    color: rgb(12, 16, 24),
    start: I16F16::lit("500"),
    end: I16F16::lit("1000"),
    curve: Fog::LINEAR,
};

/// Bytes of a row of the texture in 16 colours.
const BYTES: usize = TEXELS / 2;
/// The texture in 16 colours.
type SixteenColors = Indexed<Rgb565, BYTES, TEXELS, 16>;

/// The porcelain in 16 colours.
const PORCELAIN_INDEXED: IndexedImage<'static, Rgb565, BYTES, TEXELS, 16> = {
    static INDICES: [[u8; BYTES]; TEXELS] = indices();
    static PALETTE: [u16; 16] = palette();
    IndexedImage {
        indices: &INDICES,
        palette: &PALETTE,
    }
};

/// The colours of the porcelain, the blue that may be a hole first.
const fn palette() -> [u16; 16] {
    let mut palette = [0; 16];
    palette[0] = porcelain(0, 28);
    palette[1] = porcelain(0, 0);
    palette[2] = porcelain(16, 14);
    palette
}

/// The numbers of the texels' colours, two a byte.
const fn indices() -> [[u8; BYTES]; TEXELS] {
    let mut indices = [[0; BYTES]; TEXELS];
    let mut row = 0;
    while row < TEXELS {
        let mut byte = 0;
        while byte < BYTES {
            let (left, right) = (PORCELAIN[row][2 * byte], PORCELAIN[row][2 * byte + 1]);
            indices[row][byte] = number(left) << 4 | number(right);
            byte += 1;
        }
        row += 1;
    }
    indices
}

/// The number of a colour in the palette.
const fn number(texel: u16) -> u8 {
    let palette = palette();
    let mut number = 0;
    while palette[number] != texel {
        number += 1;
    }
    number as u8
}

/// The pot as a surface: each face knows its neighbours.
const SURFACE: FaceSet = TEAPOT.with_neighbours(&TEAPOT_NEIGHBOURS);

macro_rules! pots {
    ($($(#[$doc:meta])+ $pot:ident: $name:literal, $title:literal, $mesh:expr, $shading:ty, $skin:expr;)+) => {$(
        $(#[$doc])+
        #[derive(Debug)]
        pub struct $pot;

        impl Subject for $pot {
            const NAME: &'static str = $name;
            const TITLE: &'static str = $title;
            const SIZE: Size = SIZE;
            const DISTANCE: I16F16 = DISTANCE;
            const PORTRAIT: u32 = PORTRAIT;
            type Shading = $shading;

            fn model() -> Model<'static, Self::Shading> {
                shaded($mesh, $skin)
            }
        }
    )+};
}

pots! {
    /// In one colour, in the light of a lamp.
    LampPot: "teapot-lamp", "Utah teapot by a lamp", TEAPOT, Gouraud<Rgb565, Lambert<0, 1>>, GouraudSkin {
        colors: CLAY,
        normals: &TEAPOT_NORMALS,
        lights: LAMPLIGHT,
    };
    /// In one colour, with highlights.
    GlazedPot: "teapot-glazed", "Utah teapot with highlights", TEAPOT, Gouraud<Rgb565, Blinn<1>>, GouraudSkin {
        colors: CLAY,
        normals: &TEAPOT_NORMALS,
        lights: GLAZE,
    };
    /// With a texture, without light.
    UnlitPot: "teapot-unlit", "Utah teapot, textured", TEAPOT, Textured<Texels<Rgb565, TEXELS, TEXELS>>, TexturedSkin {
        image: &PORCELAIN,
        coordinates: &TEAPOT_COORDINATES,
    };
    /// With a texture whose texels are mixed, without light.
    UnlitSmoothPot: "teapot-unlit-smooth", "Utah teapot, bilinear", TEAPOT, Textured<Bilinear<Texels<Rgb565, TEXELS, TEXELS>>>, TexturedSkin {
        image: &PORCELAIN,
        coordinates: &TEAPOT_COORDINATES,
    };
    /// With a texture whose texels are mixed, under a light.
    SmoothPot: "teapot-smooth", "Utah teapot, lit and bilinear", TEAPOT, LitTextured<Bilinear<Texels<Rgb565, TEXELS, TEXELS>>>, LitTexturedSkin {
        image: &PORCELAIN,
        coordinates: &TEAPOT_COORDINATES,
        normals: &TEAPOT_NORMALS,
        lights: LIGHT,
    };
    /// With a texture of 16 colours, without light.
    IndexedPot: "teapot-indexed", "Utah teapot in 16 colours", TEAPOT, Textured<SixteenColors>, TexturedSkin {
        image: PORCELAIN_INDEXED,
        coordinates: &TEAPOT_COORDINATES,
    };
    /// With a texture of 16 colours of which the first is a hole, without light.
    LacePot: "teapot-lace", "Utah teapot with holes", TEAPOT, Textured<CutOut<SixteenColors>>, TexturedSkin {
        image: PORCELAIN_INDEXED,
        coordinates: &TEAPOT_COORDINATES,
    };
    /// In a colour for each face, in fog.
    FoggyPot: "teapot-fog", "Utah teapot in fog", TEAPOT, Foggy<Rgb565>, (TEAPOT_COLORS.as_slice(), FOG);
    /// In a colour for each face, half of what is behind it seen through it.
    TranslucentPot: "teapot-translucent", "Utah teapot, translucent", TEAPOT, Translucent<Rgb565>, (TEAPOT_COLORS.as_slice(), 128);
    /// In one colour under a light, each of its faces knows its neighbours.
    SmoothSurfacePot: "teapot-antialiased", "Utah teapot, antialiased silhouettes", SURFACE, Gouraud<Rgb565>, GouraudSkin {
        colors: CLAY,
        normals: &TEAPOT_NORMALS,
        lights: LIGHT,
    };
    /// In a colour for each face, each of which knows its neighbours.
    SurfacePot: "teapot-surface", "Utah teapot, silhouettes", SURFACE, Rgb565, TEAPOT_COLORS.as_slice();
    /// With everything at once.
    EverythingPot: "teapot-everything", "Utah teapot with every effect", SURFACE,         Foggy<Translucent<LitTextured<Bilinear<CutOut<SixteenColors>>, Blinn<1, 1>>>>, (
            (
                LitTexturedSkin {
                    image: PORCELAIN_INDEXED,
                    coordinates: &TEAPOT_COORDINATES,
                    normals: &TEAPOT_NORMALS,
                    lights: GLAZE_IN_LAMPLIGHT,
                },
                200,
            ),
            FOG,
        );
}

/// The teapot with one effect or all of them, turning: up to 91 faces cross a row.
pub type TurningPot<S, L = ShadingOf<S>> =
    Turning<S, { TEAPOT.vertices().len() }, { TEAPOT.faces().len() }, 240, 320, 91, L>;
/// The teapot with antialiased silhouettes.
pub type AntialiasedPot = TurningPot<SmoothSurfacePot, Antialiased<Gouraud<Rgb565>>>;

/// The plainest look of a subject: no face is cut, no row drawn in passes.
pub type Plain<S> = Whole<OnePass<ShadingOf<S>>>;
/// How the faces of a subject get their colours.
pub type ShadingOf<S> = <S as Subject>::Shading;

/// Calls a macro with each effect: its name, what it is in a few words, the subject that has it, whether it is drawn through a
/// row of pixels (`Row`) or of their samples (`Samples`), and the look.
///
/// The first one is none at all. Each one after it is that and one effect, and the last one has them all.
#[macro_export]
macro_rules! effects {
    ($visit:ident) => {
        $visit! {
            nothing: "a colour a face, and nothing else", $crate::teapots::FlatPot, through Row: [$crate::effects::Plain];
            cut_faces: "faces may be cut", $crate::teapots::FlatPot, through Row: [$crate::effects::MayBeCut];
            passes: "rows may be drawn in passes", $crate::teapots::FlatPot, through Row: [$crate::effects::InPasses];
            fine: "positions at 1/256 pixel", $crate::teapots::FlatPot, through Row: [$crate::effects::AtFinePositions];
            deep: "depths of 32 bits", $crate::teapots::FlatPot, through Row: [$crate::effects::WithDeepDepths];
            flat_light: "a light, one brightness a face", $crate::teapots::FlatLitPot, through Row: [$crate::effects::Plain];
            gouraud: "a light, Gouraud shading", $crate::teapots::GouraudPot, through Row: [$crate::effects::Plain];
            lamp: "a lamp nearby, Gouraud shading", $crate::effects::LampPot, through Row: [$crate::effects::Plain];
            highlights: "a light with highlights, Gouraud shading", $crate::effects::GlazedPot, through Row: [$crate::effects::Plain];
            texture: "a texture", $crate::effects::UnlitPot, through Row: [$crate::effects::Plain];
            sixteen_colors: "a texture of 16 colours", $crate::effects::IndexedPot, through Row: [$crate::effects::Plain];
            holes: "a texture of 16 colours, one a hole", $crate::effects::LacePot, through Row: [$crate::effects::Plain];
            bilinear: "a texture, bilinear", $crate::effects::UnlitSmoothPot, through Row: [$crate::effects::Plain];
            lit_texture: "a texture under a light", $crate::teapots::TexturedPot, through Row: [$crate::effects::Plain];
            lit_bilinear: "a texture under a light, bilinear", $crate::effects::SmoothPot, through Row: [$crate::effects::Plain];
            fog: "fog", $crate::effects::FoggyPot, through Row: [$crate::effects::Plain];
            translucent: "translucent faces", $crate::effects::TranslucentPot, through Row: [$crate::effects::Plain];
            silhouettes: "antialiased silhouettes", $crate::effects::SurfacePot, through Row: [$crate::effects::WithSilhouettes];
            multisampled: "four samples a pixel", $crate::teapots::FlatPot, through Samples: [$crate::effects::WithSamples];
            everything: "everything at once", $crate::effects::EverythingPot, through Row: [$crate::effects::WithEverything];
        }
    };
}

/// The plainest look of a subject, but that faces may be cut.
pub type MayBeCut<S> = OnePass<ShadingOf<S>>;
/// The plainest look of a subject, but that rows may be drawn in passes.
pub type InPasses<S> = Whole<ShadingOf<S>>;
/// The plainest look of a subject at 1/256 pixel.
pub type AtFinePositions<S> = Fine<Plain<S>>;
/// The plainest look of a subject with depths of 32 bits.
pub type WithDeepDepths<S> = Deep<Plain<S>>;
/// The plainest look of a subject with antialiased silhouettes.
pub type WithSilhouettes<S> = Antialiased<Plain<S>>;
/// The plainest look of a subject with four samples a pixel.
pub type WithSamples<S> = Multisampled<Plain<S>>;
/// Whatever a look can have, but for samples.
pub type WithEverything<S> = Antialiased<Fine<Deep<ShadingOf<S>>>>;
