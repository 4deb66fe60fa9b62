//! A textured cube that spins in perspective over a label: one row of colours, one row of depths.
//!
//! `cargo run --release --example textured_cube` turns it on a simulated display and writes `target/textured_cube.png`.

use std::{array::from_fn, error::Error, fmt::Debug};

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_9X15_BOLD};
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, text::Alignment, text::Text};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::fixed::types::{I16F16, U0F16};
use zrow::scene::{Camera, FaceSet, Memory, Model, Pose, Rotation, Whole};
use zrow::shade::{Texels, Textured, TexturedSkin};
use zrow::{geometry::InputError, prelude::*};

/// A texture of 16 x 16 texels on every face. In a scene of this look no face is ever cut.
type Skin = Textured<Texels<Rgb565, 16, 16>>;
/// The corners of each side, clockwise as it is seen from outside. Corner n lies at the bits of n.
const SIDES: [[usize; 4]; 6] = [
    [2, 3, 1, 0],
    [5, 7, 6, 4],
    [1, 5, 4, 0],
    [6, 7, 3, 2],
    [4, 6, 2, 0],
    [3, 7, 5, 1],
];

/// Turns the cube by 1/64 of a turn in each frame, on a display of 160 x 128 pixels.
fn show<D: DrawTarget<Color = Rgb565, Error: Debug>>(display: &mut D, frames: u16) -> Result<(), InputError> {
    // Each side has four vertices of its own, in the corners of the texture; 512 units are a length of 1.
    let vertices: [[i16; 3]; 24] = from_fn(|n| from_fn(|axis| [-512, 512][SIDES[n / 4][n % 4] >> axis & 1]));
    let coordinates: &[[i16; 2]; 24] = &from_fn(|n| [[0, 0], [4096, 0], [4096, 4096], [0, 4096]][n % 4]);
    let faces: [[u16; 3]; 12] = from_fn(|n| [[0, 1, 2], [0, 2, 3]][n % 2].map(|corner| corner + 4 * (n as u16 / 2)));
    let palette = [Rgb565::CSS_ORANGE_RED, Rgb565::CSS_MAROON].map(BandColor::to_word);
    let image: &[[u16; 16]; 16] = &from_fn(|y| from_fn(|x| palette[(x / 4 + y / 4) % 2]));
    let cube = Model::<Skin>::with_skin(FaceSet::new(&vertices, &faces)?, TexturedSkin { image, coordinates })?;
    let font = MonoTextStyle::new(&FONT_9X15_BOLD, Rgb565::WHITE);
    let label = Text::with_alignment("textured", Point::new(80, 122), font, Alignment::Center);
    // Vertices, faces, columns and rows: on a microcontroller in a `static`.
    let (mut row, mut memory) = ([0; 160], Memory::<Whole<Skin>, 24, 12, 160, 128>::new());
    let camera = Camera::new(display.bounding_box(), I16F16::from_num(512))?;
    for turn in (0..frames).map(|frame| U0F16::from_bits(frame << 10)) {
        let rotation = Rotation::about_y(turn).then(&Rotation::about_x(U0F16::from_num(0.92)));
        let models = [cube.with_pose(Pose::new(rotation, [0, 100, 1700].map(I16F16::from_num)))];
        let mut scene = memory.prepare(&camera, &models)?;
        let picture = PictureLoop::new(display.bounding_box(), Rgb565::CSS_MIDNIGHT_BLUE);
        let draw = |band: &mut Band<'_, Rgb565>| {
            scene.draw(band);
            label.draw_on(band)
        };
        picture.draw(&mut row, &mut DisplaySink(display), draw).unwrap();
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(160, 128));
    show(&mut display, 71)?;
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok(image.save_png("target/textured_cube.png")?)
}
