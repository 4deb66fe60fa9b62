//! Turns the Utah teapot with a texture under a light through eight steps, each drawn through one row of colours and one of
//! depths, and writes the last one to `target/teapot.png`.
//!
//! `cargo run --release --example teapot`

use std::error::Error;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::{
    band::{DisplaySink, PictureLoop},
    fixed::types::{I16F16, U0F16},
    scene::{Camera, Memory, Model, Pose, Rotation},
    shade::{DirectionalLight, Lambert, LitTextured, LitTexturedSkin, Texels},
};
// `cargo run --release -- mesh MODEL.obj` writes such tables.
use zrow_scenes::{
    teapot::{TEAPOT, TEAPOT_COORDINATES, TEAPOT_NORMALS},
    teapots::PORCELAIN,
};

/// The look of the scene: RGB565, and a texture of 64 x 64 texels under one light.
type Pot = LitTextured<Texels<Rgb565, 64, 64>>;
const VERTICES: usize = TEAPOT.vertices().len();
const FACES: usize = TEAPOT.faces().len();

fn main() -> Result<(), Box<dyn Error>> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(320, 160));
    let mut memory = Memory::<Pot, VERTICES, FACES, 320, 160, 91>::new();
    let camera = Camera::new(display.bounding_box(), I16F16::from_num(128))?;
    let sun = DirectionalLight::from_direction([-2, 3, -2].map(I16F16::from_num), U0F16::from_num(0.7))?;
    let lights = Lambert {
        ambient: U0F16::from_num(0.3),
        lights: [sun],
        points: [],
    };
    let (image, coordinates, normals) = (&PORCELAIN, &TEAPOT_COORDINATES, &TEAPOT_NORMALS);
    let pot = Model::<Pot>::with_skin(
        TEAPOT,
        LitTexturedSkin {
            image,
            coordinates,
            normals,
            lights,
        },
    )?;

    let mut row = [0; 320];
    for turn in (0..8).map(|step| U0F16::from_bits(step * 0x2000)) {
        let tilted = Rotation::about_y(turn).then(&Rotation::about_x(U0F16::from_num(0.95)));
        let models = [pot.with_pose(Pose::new(tilted, [0, 0, 1000].map(I16F16::from_num)))];
        let mut scene = memory.prepare(&camera, &models)?;
        PictureLoop::new(display.bounding_box(), Rgb565::CSS_MIDNIGHT_BLUE).draw(
            &mut row,
            &mut DisplaySink(&mut display),
            |band| scene.draw(band),
        )?;
    }
    display
        .to_rgb_output_image(&OutputSettings::default())
        .save_png("target/teapot.png")?;
    Ok(())
}
