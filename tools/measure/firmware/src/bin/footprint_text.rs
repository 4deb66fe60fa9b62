//! A short text in a font of one kind, named when it is built, through one row of 160 pixels, and nothing else.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::Rgb565,
    primitives::Rectangle,
};
use zrow::band::Band;
use zrow_measure_firmware::{
    content, report,
    run::Checksum,
    stack,
    text::{self, HEIGHT, Memory, WIDTH},
};

#[entry]
fn main() -> ! {
    static mut MEMORY: Memory = Memory::new();
    let mut sum = Checksum::default();
    macro_rules! kinds {
        ($($name:literal => $draw:expr),*) => {
            $(
                if const { content::is($name) } {
                    rows(&mut sum, $draw);
                }
            )*
        };
    }
    kinds!(
        "text_outlines" => text::outlines,
        "text_masks" => text::masks,
        "text_mono" => text::mono,
        "text_embedded_graphics" => text::embedded_graphics,
        "text_u8g2" => text::u8g2
    );
    if const { content::is("text_outlines_prepared") } {
        let mut picture = MEMORY.outlines();
        rows(&mut sum, |band| picture.draw(band));
    }
    if const { content::is("text_masks_prepared") } {
        let mut picture = MEMORY.masks();
        rows(&mut sum, |band| picture.draw(band));
    }
    stack::report(sum.0);
    report::exit(true)
}

/// Draws row by row.
fn rows(sum: &mut Checksum, mut draw: impl FnMut(&mut Band<'_, Rgb565>)) {
    for y in 0..HEIGHT as i32 {
        let mut words = [0; WIDTH];
        let area = Rectangle::new(Point::new(0, y), Size::new(WIDTH as u32, 1));
        let Ok(mut band) = Band::new(area, &mut words) else {
            report::exit(false)
        };
        draw(&mut band);
        sum.add(words.into_iter());
    }
}
