//! Counts the texts of a dashboard through one row of 240 pixels: by zrow, and by embedded-graphics' own renderer.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    Drawable,
    geometry::{Point, Size},
    mono_font::{
        MonoTextStyle,
        ascii::{FONT_6X10, FONT_10X20},
    },
    pixelcolor::{Rgb565, RgbColor},
    primitives::Rectangle,
    text::Text,
};
use zrow::{band::Band, draw::DrawOn};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

type Style = MonoTextStyle<'static, Rgb565>;

/// A row, and the checksum of all rows that were drawn.
struct Row {
    words: [u16; 240],
    sum: Checksum,
}

impl Canvas for Row {
    fn erase(&mut self) {
        self.sum = Checksum::default();
    }

    fn checksum(&mut self) -> u32 {
        self.sum.0
    }
}

impl Row {
    /// Draws texts into a row, and adds the row's pixels to the checksum where it has some.
    fn draw(&mut self, y: i32, has_pixels: bool, draw: impl FnOnce(&mut Band<'_, Rgb565>)) {
        let area = Rectangle::new(Point::new(0, y), Size::new(240, 1));
        let Ok(mut band) = Band::new(area, &mut self.words) else {
            report::exit(false)
        };
        draw(&mut band);
        black_box(band.words_mut());
        if has_pixels {
            self.sum.add(self.words.iter().copied());
            self.words.fill(0);
        }
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let large = Style::new(&FONT_10X20, Rgb565::WHITE);
    let texts = black_box([
        Text::new("42 km/h", Point::new(85, 220), large),
        Text::new(
            "Zone 1: 21.5 C",
            Point::new(10, 30),
            Style::new(&FONT_6X10, Rgb565::YELLOW),
        ),
        Text::new("12:34", Point::new(180, 300), large),
    ]);
    // The first text has rows 205 to 224.
    count(
        &mut runner,
        "text.met",
        &texts[..1],
        core::array::from_fn::<i32, 20, _>(|row| 205 + row as i32),
        true,
    );
    count(
        &mut runner,
        "text.above",
        &texts[..1],
        core::array::from_fn::<i32, 100, _>(|row| 100 + row as i32),
        false,
    );
    count(
        &mut runner,
        "text.below",
        &texts[..1],
        core::array::from_fn::<i32, 80, _>(|row| 230 + row as i32),
        false,
    );
    count(
        &mut runner,
        "text.dashboard",
        &texts,
        core::array::from_fn::<i32, 320, _>(|row| row as i32),
        true,
    );
    report::exit(true)
}

#[inline(never)]
fn count<const ROWS: usize>(
    runner: &mut Runner,
    name: &str,
    texts: &[Text<'_, Style>],
    rows: [i32; ROWS],
    has_pixels: bool,
) {
    let mut row = Row {
        words: [0; 240],
        sum: Checksum::default(),
    };
    runner.count(name, "draw_on", &mut row, &rows, |row, &y| {
        row.draw(y, has_pixels, |band| {
            for text in texts {
                let Ok(()) = text.draw_on(band);
            }
        });
    });
    runner.count(name, "embedded_graphics", &mut row, &rows, |row, &y| {
        row.draw(y, has_pixels, |band| {
            for text in texts {
                let Ok(_) = text.draw(band);
            }
        });
    });
}
