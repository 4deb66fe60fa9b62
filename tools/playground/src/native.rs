//! What the simulator shows of a state: the picture that the canvas of the page has to have.

use std::convert::Infallible;

use anyhow::anyhow;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::band::{DisplaySink, LoopError};
use zrow_playground_scene::{AREA, Depth, PanelColor, Playground};

/// Red, green and blue of the pixels, row by row.
///
/// # Errors
/// The state cannot be drawn.
pub fn pixels(playground: &mut Playground, address: &str) -> anyhow::Result<Vec<u8>> {
    playground.prepare(address)?;
    match playground.state().depth {
        Depth::Rgb888 => drawn::<Rgb888>(playground),
        Depth::Rgb565 | Depth::DitheredRgb565 => drawn::<Rgb565>(playground),
        Depth::Gray4 => drawn::<Gray4>(playground),
        Depth::Binary => drawn::<BinaryColor>(playground),
    }
}

fn drawn<C: PanelColor + From<Rgb888>>(playground: &mut Playground) -> anyhow::Result<Vec<u8>> {
    let mut display = SimulatorDisplay::<C>::with_default_color(AREA.size, C::from(Rgb888::default()));
    playground
        .draw::<C, _>(DisplaySink(&mut display))
        .map_err(|error: LoopError<Infallible, _>| anyhow!("cannot draw: {error:?}"))?;
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok(image.as_image_buffer().pixels().flat_map(|pixel: &_| pixel.0).collect())
}

/// FNV-1a (Fowler, Noll, Vo, 1991) over bytes.
pub fn checksum(bytes: &[u8]) -> u32 {
    bytes.iter().fold(0x811C_9DC5, |sum, byte| {
        (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193)
    })
}
