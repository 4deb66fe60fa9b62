//! The picture that all panels show.

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Rgb565, raw::ToBytes},
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
    text::Text,
};
use zrow::band::{Band, BandColor, Order};

pub fn scene<C: BandColor + From<BinaryColor>, O: Order>(band: &mut Band<'_, C, O>) {
    let on = C::from(BinaryColor::On);
    band.draw(&Circle::new(Point::new(20, 9), 41).into_styled(PrimitiveStyle::with_stroke(on, 3)));
    band.draw(&Text::new(
        "zrow",
        Point::new(28, 32),
        MonoTextStyle::new(&FONT_6X10, on),
    ));
}

/// The picture in one band over the whole panel.
pub fn picture<C: BandColor + From<BinaryColor>>(area: Rectangle) -> Vec<C> {
    let mut words = vec![C::from(BinaryColor::Off).to_word(); (area.size.width * area.size.height) as usize];
    let mut band = Band::<C>::new(area, &mut words).unwrap();
    scene(&mut band);
    band.colors().collect()
}

pub fn rgb565_bytes(area: Rectangle) -> Vec<u8> {
    picture::<Rgb565>(area)
        .iter()
        .flat_map(|color| color.to_be_bytes())
        .collect()
}

/// Horizontal bytes, eight pixels each, from the top to the bottom.
pub fn packed(area: Rectangle) -> Vec<u8> {
    let mut words: Vec<u8> = picture::<BinaryColor>(area)
        .iter()
        .map(|color| u8::from(color.is_on()))
        .collect();
    Band::<BinaryColor>::new(area, &mut words)
        .unwrap()
        .into_bytes()
        .to_vec()
}

pub fn box_of(width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(width, height))
}
