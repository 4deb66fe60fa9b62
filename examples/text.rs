//! Draws antialiased text over a gradient in bands of one row and writes `target/text.png`.
//!
//! `cargo run --release --example text`
//!
//! The fonts are DejaVu Sans, with the licence of Bitstream Vera. Another one becomes such a module by
//! `cargo run --release -- font FILE.ttf --size 24 --chars '0-9.:°C'`.

use std::error::Error;

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{PrimitiveStyle, Rectangle},
    text::{Alignment, DecorationColor, Text, renderer::CharacterStyle},
};
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use zrow::{
    band::{DisplaySink, PictureLoop},
    draw::{BlendOn, DrawOn, MaskTextStyle},
};
use zrow_scenes::fonts::{DEJAVU_SANS_16, DEJAVU_SANS_24};

fn main() -> Result<(), Box<dyn Error>> {
    let large = MaskTextStyle::new(&DEJAVU_SANS_24, Rgb565::CSS_GOLD);
    let small = MaskTextStyle::new(&DEJAVU_SANS_16, Rgb565::WHITE);
    let mut underlined = small;
    underlined.set_underline_color(DecorationColor::Custom(Rgb565::CSS_TOMATO));
    let texts = [
        Text::new("12:34", Point::new(12, 34), large),
        Text::with_alignment("42 km/h", Point::new(227, 34), large, Alignment::Right),
        Text::with_alignment("-7.5 °C", Point::new(227, 62), large, Alignment::Right),
        // Kerned: the pairs are closer than their advances say.
        Text::new("AVATAR, To. Ye. LTV", Point::new(12, 92), small),
        Text::new(
            "The quick brown fox jumps\nover (the) lazy dog: 100 %",
            Point::new(12, 116),
            small,
        ),
        Text::new("Underlined gypsy", Point::new(12, 162), underlined),
    ];
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(240, 176));
    let mut row = [0; 240];
    PictureLoop::new(display.bounding_box(), Rgb565::BLACK).draw(&mut row, &mut DisplaySink(&mut display), |band| {
        // Whatever lies below is blended with: here, stripes from blue to violet.
        for stripe in 0..30 {
            let area = Rectangle::new(Point::new(8 * stripe, 0), Size::new(8, 176));
            let style = PrimitiveStyle::with_fill(Rgb565::new(stripe as u8 / 2, 8, 12 + stripe as u8 / 4));
            let Ok(()) = area.into_styled(style).draw_on(band);
        }
        for text in &texts {
            let Ok(()) = text.draw_on(band);
        }
    })?;
    let settings = OutputSettingsBuilder::new().scale(3).build();
    display.to_rgb_output_image(&settings).save_png("target/text.png")?;
    Ok(())
}
