//! A dashboard of 30 shapes and 3 texts on 240 x 320 pixels, from a series of pseudo-random numbers.

use embedded_graphics::{
    mono_font::{
        MonoTextStyle,
        ascii::{FONT_6X10, FONT_10X20},
    },
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Ellipse, Line, Rectangle, Styled, Triangle},
    text::Text,
};
use zrow::{
    band::Band,
    draw::{DrawOn, Picture, PictureSlot, PrimitiveStyle},
    geometry::InputError,
};

use crate::inputs::Uniform;

/// The seed of the dashboard's numbers.
const SEED: u32 = 0x2468_ACE1;

/// Rows and columns of the dashboard.
pub const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(240, 320));

/// What of a picture's memory the dashboard takes: slots, words of the pool, and buckets.
pub const SLOTS: usize = 33;
pub const WORDS: usize = 4 * 9 + (7 + 1) + (14 + 1) + (5 + 1);
pub const BUCKETS: usize = 320;

type Shape<S> = Styled<S, PrimitiveStyle<Rgb565>>;

/// The shapes and texts, which are drawn in this order.
pub struct Dashboard {
    rectangles: [Shape<Rectangle>; 8],
    discs: [Shape<Circle>; 5],
    outlines: [Shape<Circle>; 5],
    triangles: [Shape<Triangle>; 4],
    ellipses: [Shape<Ellipse>; 3],
    lines: [Shape<Line>; 5],
    texts: [Text<'static, MonoTextStyle<'static, Rgb565>>; 3],
}

impl Default for Dashboard {
    fn default() -> Self {
        let mut numbers = Uniform::from_seed(SEED);
        let mut center = |margin: u32| {
            let Size { width, height } = AREA.size;
            let x = margin + numbers.below(width - 2 * margin);
            let y = margin + numbers.below(height - 2 * margin);
            Point::new(x as i32, y as i32)
        };
        let mut colors = (1..).map(|index| Rgb565::new(index * 3 % 32, index * 7 % 64, 31 - index % 32));
        let mut color = || colors.next().unwrap_or_default();
        let rectangles = core::array::from_fn(|_| {
            Rectangle::with_center(center(30), Size::new(60, 40)).into_styled(PrimitiveStyle::with_fill(color()))
        });
        let discs = core::array::from_fn(|_| {
            Circle::with_center(center(25), 50).into_styled(PrimitiveStyle::with_fill(color()))
        });
        let outlines = core::array::from_fn(|_| {
            Circle::with_center(center(30), 60).into_styled(PrimitiveStyle::with_stroke(color(), 1))
        });
        let lines = core::array::from_fn(|_| {
            let (start, end) = (center(0), center(0));
            Line::new(start, end).into_styled(PrimitiveStyle::with_stroke(color(), 1))
        });
        let triangles = core::array::from_fn(|_| {
            let corner = center(20);
            Triangle::new(corner, corner + Point::new(20, 5), corner + Point::new(-6, 18))
                .into_styled(PrimitiveStyle::with_fill(color()))
        });
        let ellipses = core::array::from_fn(|_| {
            Ellipse::with_center(center(40), Size::new(80, 50)).into_styled(PrimitiveStyle::with_fill(color()))
        });
        let large = MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE);
        let small = MonoTextStyle::new(&FONT_6X10, Rgb565::YELLOW);
        Self {
            rectangles,
            discs,
            outlines,
            triangles,
            ellipses,
            lines,
            texts: [
                Text::new("42 km/h", Point::new(85, 220), large),
                Text::new("Zone 1: 21.5 C", Point::new(10, 30), small),
                Text::new("12:34", Point::new(180, 300), large),
            ],
        }
    }
}

/// Memory for the dashboard as a picture.
pub struct Memory {
    pub slots: [PictureSlot<'static, Rgb565>; SLOTS],
    pub pool: [u32; WORDS],
    pub buckets: [u16; BUCKETS],
}

impl Default for Memory {
    fn default() -> Self {
        Self {
            slots: [PictureSlot::EMPTY; SLOTS],
            pool: [0; WORDS],
            buckets: [0; BUCKETS],
        }
    }
}

impl Dashboard {
    /// Draws everything, with or without the texts.
    #[inline(never)]
    pub fn draw(&self, with_texts: bool, band: &mut Band<'_, Rgb565>) {
        fn draw_all<D: DrawOn<Color = Rgb565>>(shapes: &[D], band: &mut Band<'_, Rgb565>) {
            for shape in shapes {
                let Ok(()) = shape.draw_on(band);
            }
        }
        draw_all(&self.rectangles, band);
        draw_all(&self.discs, band);
        draw_all(&self.outlines, band);
        draw_all(&self.triangles, band);
        draw_all(&self.ellipses, band);
        draw_all(&self.lines, band);
        if with_texts {
            draw_all(&self.texts, band);
        }
    }

    /// Prepares everything, with or without the texts.
    ///
    /// # Errors
    /// Where the memory is too small.
    #[inline(never)]
    pub fn prepare<'m>(
        &self,
        with_texts: bool,
        memory: &'m mut Memory,
    ) -> Result<Picture<'m, 'static, Rgb565>, InputError> {
        let Memory { slots, pool, buckets } = memory;
        let mut picture = Picture::new(AREA, slots, pool, buckets);
        self.rectangles
            .iter()
            .try_for_each(|shape| picture.add(shape).map(drop))?;
        self.discs.iter().try_for_each(|shape| picture.add(shape).map(drop))?;
        self.outlines
            .iter()
            .try_for_each(|shape| picture.add(shape).map(drop))?;
        self.triangles
            .iter()
            .try_for_each(|shape| picture.add(shape).map(drop))?;
        self.ellipses
            .iter()
            .try_for_each(|shape| picture.add(shape).map(drop))?;
        self.lines.iter().try_for_each(|shape| picture.add(shape).map(drop))?;
        if with_texts {
            self.texts.iter().try_for_each(|text| picture.add(text).map(drop))?;
        }
        Ok(picture)
    }
}
