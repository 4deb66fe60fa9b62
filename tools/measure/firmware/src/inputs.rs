//! Reproducible inputs: uniform points from xorshift32 (Marsaglia, 2003).

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};

/// The seed that every series of inputs starts from.
const SEED: u32 = 0x0123_4567;

/// A series of pseudo-random numbers.
pub struct Uniform(u32);

impl Default for Uniform {
    fn default() -> Self {
        Self(SEED)
    }
}

impl Uniform {
    /// The series that begins after a seed.
    pub const fn from_seed(seed: u32) -> Self {
        Self(seed)
    }

    /// A number below another one.
    pub fn below(&mut self, end: u32) -> u32 {
        self.next() % end
    }

    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// A number of `low..high`.
    pub fn number(&mut self, low: i32, high: i32) -> i32 {
        low + (self.next() % high.abs_diff(low)) as i32
    }

    /// A point of the screen.
    pub fn on_screen(&mut self, screen: Size) -> Point {
        self.around_screen(screen, 0)
    }

    /// A point at most `margin` pixels off the screen.
    pub fn around_screen(&mut self, screen: Size, margin: i32) -> Point {
        let x = self.number(-margin, screen.width as i32 + margin);
        let y = self.number(-margin, screen.height as i32 + margin);
        Point::new(x, y)
    }
}

/// A shape and its colour.
pub struct Colored<Shape> {
    /// What to draw.
    pub shape: Shape,
    /// A colour of its own, so that the checksum notices the order of drawing too.
    pub color: Rgb565,
}

/// `N` shapes made from a fresh series of numbers.
pub fn colored<Shape, const N: usize>(mut shape: impl FnMut(&mut Uniform) -> Shape) -> [Colored<Shape>; N] {
    let mut uniform = Uniform::default();
    core::array::from_fn(|index| {
        let color = Rgb565::new((index % 31 + 1) as u8, (index % 61 + 1) as u8, (index % 29 + 1) as u8);
        Colored {
            shape: shape(&mut uniform),
            color,
        }
    })
}
