//! Colours for numbers: how often a pixel is tested, and when a face is painted.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};

use crate::paint::rgb;

/// The colours of pixels by their tests: none, one, two or three, four to seven and so on.
pub const TESTS: [Rgb565; 6] = [
    rgb(24, 30, 42),
    rgb(36, 66, 110),
    rgb(30, 120, 130),
    rgb(110, 170, 70),
    rgb(230, 170, 50),
    rgb(240, 80, 60),
];

/// The colour of a pixel that was tested so often.
pub fn color_of_tests(tests: u16) -> Rgb565 {
    let bits = (u16::BITS - tests.leading_zeros()) as usize;
    TESTS.get(bits).or(TESTS.last()).copied().unwrap_or_default()
}

/// From the face that is painted first to the one that is painted last.
pub const FIRST_AND_LAST: [Rgb565; 3] = [rgb(30, 50, 120), rgb(60, 150, 140), rgb(255, 224, 120)];

/// The colour of one of so many numbers.
pub fn color_of_number(number: u16, numbers: u16) -> Rgb565 {
    let [first, middle, last] = FIRST_AND_LAST;
    let (number, half) = (u32::from(number), u32::from(numbers).div_ceil(2).max(1));
    if number < half {
        between([first, middle], number, half)
    } else {
        between([middle, last], (number - half).min(half), half)
    }
}

/// The colour at so many of some steps from one colour to another.
fn between([from, to]: [Rgb565; 2], step: u32, steps: u32) -> Rgb565 {
    let mix = |from: u8, to: u8| ((u32::from(from) * (steps - step) + u32::from(to) * step) / steps) as u8;
    Rgb565::new(mix(from.r(), to.r()), mix(from.g(), to.g()), mix(from.b(), to.b()))
}
