//! The second scene of the 128 x 64 OLED: the Utah teapot under a light, shaded in 256 greys and dithered to the 16 that the panel has.

use embedded_graphics::{
    pixelcolor::{Gray4, Gray8},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::{Band, Order},
    scene::{self, Camera, Memory, Model, OnePass, Pose, Rotation, Whole},
    shade::{Gouraud, GouraudSkin, Lambert},
};

use crate::{
    PrepareError, Prepared, Scene,
    oled::{AREA, FRAMES},
    standard::{NEAR, angle},
    teapot::{TEAPOT, TEAPOT_NORMALS},
    teapots::{one_light, shaded},
};

/// No face is ever cut, and no row takes several passes.
type Look = Whole<OnePass<Gouraud<Gray8>>>;

const DISTANCE: I16F16 = I16F16::lit("1400");
/// In pixels.
const FOCAL_LENGTH: I16F16 = I16F16::lit("124");
/// A light from the upper left that leaves the other side nearly dark.
const SPOT: Lambert<1> = one_light(
    U0F16::lit("0.1"),
    [I16F16::lit("-0.7"), I16F16::lit("0.6"), I16F16::lit("-0.4")],
    U0F16::lit("0.9"),
);
/// The most faces that cross a row in any frame.
const ACTIVE: usize = 58;

/// The scene's storage.
#[derive(Debug)]
pub struct OledTeapot {
    memory: Memory<
        Look,
        { TEAPOT.vertices().len() },
        { TEAPOT.faces().len() },
        { AREA.size.width as usize },
        { AREA.size.height as usize },
        ACTIVE,
    >,
    models: [Model<'static, Gouraud<Gray8>>; 1],
}

impl Default for OledTeapot {
    fn default() -> Self {
        let skin = GouraudSkin {
            colors: const { &[Gray8::WHITE] },
            normals: &TEAPOT_NORMALS,
            lights: SPOT,
        };
        Self {
            memory: Memory::new(),
            models: [shaded(TEAPOT, skin)],
        }
    }
}

impl Scene for OledTeapot {
    type Color = Gray4;
    type Prepared<'s> = Turned<'s>;
    const NAME: &'static str = "oled-teapot";
    const TITLE: &'static str = "Utah teapot, dithered to 16 greys";
    const AREA: Rectangle = AREA;
    const BACKGROUND: Gray4 = Gray4::BLACK;
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = 6;
    const DEPTH_ROW_BYTES: usize = 2 * AREA.size.width as usize;

    fn prepare(&mut self, frame: u32) -> Result<Turned<'_>, PrepareError> {
        let camera = Camera::new(AREA, NEAR)?.with_focal_length(FOCAL_LENGTH)?;
        // Once about y in the animation, seen from a little above.
        let rotation = Rotation::about_y(angle(frame % FRAMES * 8)).then(&Rotation::about_x(U0F16::lit("0.94")));
        for model in &mut self.models {
            model.pose = Pose::new(rotation, [I16F16::ZERO, I16F16::ZERO, DISTANCE]);
        }
        Ok(Turned(self.memory.prepare(&camera, &self.models)?))
    }
}

/// The teapot as it is in a frame.
#[derive(Debug)]
pub struct Turned<'s>(scene::Prepared<'s, 'static, Look>);

impl Turned<'_> {
    /// What the colours of the loop that draws in 256 greys begin with.
    pub const BACKGROUND: Gray8 = Gray8::BLACK;

    /// Draws in 256 greys what a [`Dithered`](zrow::band::Dithered) sink makes the panel's 16 of.
    pub fn draw_undithered<O: Order>(&mut self, band: &mut Band<'_, Gray8, O>) {
        self.0.draw(band);
    }
}

impl Prepared for Turned<'_> {
    type Color = Gray4;

    /// Draws in 256 greys where the band's words are, which have as many bits, and dithers them in place.
    fn draw<O: Order>(&mut self, band: &mut Band<'_, Gray4, O>) {
        let area = band.bounding_box();
        // Does not fail: there are as many words as the area has pixels.
        if let Ok(mut band) = Band::<Gray8, O>::new(area, band.words_mut()) {
            band.fill(Self::BACKGROUND);
            self.draw_undithered(&mut band);
            band.into_dithered::<Gray4>();
        }
    }
}
