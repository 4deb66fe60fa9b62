//! Turns a cube through eight steps, draws each in bands of one row with a depth row, and writes all to `target/cube.png`.
//!
//! `cargo run --release --example cube`

use std::{array::from_fn, error::Error};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::{
    band::{DisplaySink, PictureLoop},
    fixed::types::{I16F16, U0F16},
    scene::{Camera, FaceSet, Memory, Model, Pose, Rotation},
};

const SIZE: usize = 120;
/// The corners of each side, clockwise as it is seen from outside. Corner n lies at the bits of n.
const SIDES: [&[u16]; 6] = [
    &[2, 3, 1, 0],
    &[5, 7, 6, 4],
    &[1, 5, 4, 0],
    &[6, 7, 3, 2],
    &[4, 6, 2, 0],
    &[3, 7, 5, 1],
];

fn main() -> Result<(), Box<dyn Error>> {
    // 512 units are a length of 1.
    let vertices: [[i16; 3]; 8] = from_fn(|n| from_fn(|axis| if n >> axis & 1 == 0 { -512 } else { 512 }));
    let faces: [[u16; 3]; 12] = FaceSet::triangulate(&vertices, &SIDES)?;
    // Blue, green, cyan, red, magenta, yellow.
    let side_color = |bits: u8| Rgb565::new(31 * (bits >> 2 & 1), 63 * (bits >> 1 & 1), 31 * (bits & 1));
    let colors: Vec<Rgb565> = (1..7).flat_map(|bits| [side_color(bits); 2]).collect();
    let cube = Model::new(FaceSet::new(&vertices, &faces)?, &colors)?;
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(8 * SIZE as u32, SIZE as u32));
    // The memory of a scene: vertices, faces, columns and rows.
    let mut memory = Memory::<Rgb565, 8, 12, SIZE, SIZE>::new();
    let mut row = [0; SIZE];
    for step in 0..8 {
        let angle = U0F16::from_num(step as f32 / 32.0);
        let rotation = Rotation::about_y(angle).then(&Rotation::about_x(U0F16::from_num(0.92)));
        let distance = [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(2300)];
        let models = [cube.with_pose(Pose::new(rotation, distance))];
        let area = Rectangle::new(Point::new(step * SIZE as i32, 0), Size::new_equal(SIZE as u32));
        let camera = Camera::new(area, I16F16::from_num(512))?.with_focal_length(I16F16::from_num(130))?;
        let mut scene = memory.prepare(&camera, &models)?;
        PictureLoop::new(area, Rgb565::BLACK)
            .draw(&mut row, &mut DisplaySink(&mut display), |band| scene.draw(band))?;
    }
    display
        .to_rgb_output_image(&OutputSettings::default())
        .save_png("target/cube.png")?;
    Ok(())
}
