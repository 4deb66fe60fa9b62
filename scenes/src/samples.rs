//! One small picture by samples and by coverage, magnified: where the background shows between two triangles, and what
//! becomes of stripes that are finer than a pixel.

use core::convert::Infallible;

use embedded_graphics::{
    mono_font::ascii::FONT_5X8,
    pixelcolor::{Rgb565, raw::RawU16},
    prelude::*,
    primitives::{Line, Rectangle},
    text::Alignment,
};
use fixed::types::U24F8;
use zrow::{
    band::{Band, Order, PictureLoop, Supersampling, Target},
    coverage::{Bartlett, BoxFilter, CentreSample, CoverageMethod, Gaussian, Rooks, SamplePattern, SignedArea},
    draw::{AntialiasedPolygon, FillRule, PrimitiveStyle, SubEllipse, SubOutline},
    geometry::{InputError, Sub8, SubPoint, TooSmall},
    shade::{BlendTarget, Paint, SampleFilter},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape, title},
};

const LABEL_COLOR: Rgb565 = rgb(150, 165, 190);
const PAPER: Rgb565 = rgb(20, 30, 70);
const HALVES: Rgb565 = rgb(255, 213, 79);
const NEEDLE: Rgb565 = rgb(255, 112, 97);
const STRIPES: [Rgb565; 2] = [rgb(230, 245, 255), rgb(0, 96, 128)];

/// Columns and rows of a small picture.
const WIDTH: usize = 24;
const HEIGHT: usize = 23;
const SMALL: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
/// Its pixels on the panel.
const SCALE: u32 = 4;
/// Samples along a side of a pixel.
const SAMPLES: usize = 4;

/// Where each small picture is, and what it is called.
const PANELS: [(Point, &str); 6] = [
    (Point::new(8, 32), "centres of pixels"),
    (Point::new(112, 32), "coverage, blended"),
    (Point::new(216, 32), "multisampled, 4"),
    (Point::new(8, 142), "4 x 4, box"),
    (Point::new(112, 142), "4 x 4, Bartlett"),
    (Point::new(216, 142), "4 x 4, Gaussian"),
];

/// On the panel whose coverage is blended: a word over one half of the quadrangle, and an arrow from it to the seam, tip first.
const SEAM_LABEL: Point = Point::new(147, 41);
const SEAM_ARROW: [(Point, Point); 3] = [
    (Point::new(144, 59), Point::new(152, 51)),
    (Point::new(144, 59), Point::new(148, 59)),
    (Point::new(144, 59), Point::new(144, 55)),
];

/// Corners in 1/256 pixel: a quadrangle that is cut in two, and a thin triangle.
const QUADRANGLE: [(i32, i32); 4] = [(340, 440), (3_700, 250), (3_330, 3_380), (520, 3_100)];
const POINTED: [(i32, i32); 3] = [(200, 5_500), (5_850, 700), (400, 5_690)];
const DISC: (i32, i32) = (4_300, 4_090);
const RADIUS: u32 = 1_480;

/// A shape that is set up.
type Ready = AntialiasedPolygon<96, 64>;

/// Stripes three quarters of a pixel wide, at an angle: the colour of a position, asked for pixels or for samples.
#[derive(Clone, Copy)]
struct Stripes {
    /// Samples from one position to the next, and up to the first one.
    step: i32,
    first: i32,
}

impl Paint for Stripes {
    type Color = Rgb565;

    fn colors_from(&self, start: Point) -> impl Iterator<Item = Rgb565> {
        let Self { step, first } = *self;
        let position = move |coordinate: i32| coordinate * step + first;
        let odd = move |x: i32| (position(x) * 3 + position(start.y)).div_euclid(9) & 1 != 0;
        (start.x..).map(move |x| if odd(x) { STRIPES[1] } else { STRIPES[0] })
    }
}

/// What is asked once a pixel, in its middle.
const BY_PIXEL: Stripes = Stripes { step: 4, first: 2 };
/// What is asked once a sample.
const BY_SAMPLE: Stripes = Stripes { step: 1, first: 0 };

/// The shapes of a small picture.
struct Shapes {
    flat: [(Ready, Rgb565); 3],
    striped: Ready,
}

impl Shapes {
    /// At its own size or so many times as large.
    fn new(
        scale: u32,
        enlarged: impl Fn(SubPoint<Sub8>) -> Result<SubPoint<Sub8>, InputError>,
    ) -> Result<Self, PrepareError> {
        let point = |(x, y)| enlarged(SubPoint::from_units(x, y)?);
        let polygon = |corners: [(i32, i32); 3]| -> Result<Ready, PrepareError> {
            let [a, b, c] = corners.map(point);
            prepare(&[[a?, b?, c?].as_slice()])
        };
        let [a, b, c, d] = QUADRANGLE;
        let disc = SubEllipse::circle(point(DISC)?, U24F8::from_bits(RADIUS * scale))?;
        Ok(Self {
            flat: [
                (polygon([a, b, c])?, HALVES),
                (polygon([a, c, d])?, HALVES),
                (polygon(POINTED)?, NEEDLE),
            ],
            striped: prepare(&disc)?,
        })
    }

    /// Draws each pixel all or nothing.
    fn draw_aliased<O: Order>(&self, band: &mut Band<'_, Rgb565, O>, stripes: Stripes) {
        for (polygon, color) in &self.flat {
            // No row memory is needed, so there is never too little.
            let _ = polygon.draw(&CentreSample, *color, band, &mut []);
        }
        let window = band.window();
        let mut painted = band.painted(stripes);
        let _ = self.striped.cover(&CentreSample, &window, &mut [], |span, _| {
            let Ok(()) = painted.fill_span(span, ());
            Ok::<_, TooSmall>(())
        });
    }

    /// Blends the coverage of each pixel.
    fn draw_blended(&self, band: &mut Band<'_, Rgb565>) -> Result<(), TooSmall> {
        let mut memory = [0; WIDTH + 1];
        let window = band.window();
        for (polygon, color) in &self.flat {
            polygon.cover(&SignedArea, &window, &mut memory, |span, coverage| {
                let Ok(()) = band.blend_span(span, *color, coverage);
                Ok::<_, TooSmall>(())
            })?;
        }
        self.striped.cover(&SignedArea, &window, &mut memory, |span, coverage| {
            let colors = BY_PIXEL.colors_from(Point::new(span.start, span.y));
            for (pixel, color) in span.to_window().to_rectangle().points().zip(colors) {
                let pixel = zrow::band::Span::new(pixel.y, pixel.x, pixel.x + 1);
                let Ok(()) = band.blend_span(pixel, color, coverage);
            }
            Ok::<_, TooSmall>(())
        })
    }

    /// Takes the samples that are covered, in one colour a pixel.
    fn draw_multisampled(&self, band: &mut Band<'_, Rgb565>) -> Result<(), TooSmall> {
        let mut memory = [<Rooks<4> as CoverageMethod>::Cell::default(); WIDTH / 2];
        let mut samples = [0; Rooks::<4>::SAMPLES * WIDTH];
        band.multisample(Rooks::<4>, &mut samples, |target| {
            for (polygon, color) in &self.flat {
                // There is one number for two pixels.
                let _ = polygon.draw_samples(*color, target, &mut memory);
            }
            let mut painted = target.painted(BY_PIXEL);
            let _ = self.striped.draw_samples(STRIPES[0], &mut painted, &mut memory);
        })
    }
}

fn prepare<O: SubOutline + ?Sized>(outline: &O) -> Result<Ready, PrepareError> {
    AntialiasedPolygon::prepare(outline, FillRule::NonZero)
}

/// The scene: small pictures that outlive a row, because each of their pixels is shown in four rows.
#[derive(Debug)]
pub struct Samples {
    pictures: [[u16; WIDTH * HEIGHT]; 6],
}

impl Default for Samples {
    fn default() -> Self {
        Self {
            pictures: [[0; WIDTH * HEIGHT]; 6],
        }
    }
}

impl Scene for Samples {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "samples";
    const TITLE: &'static str = "samples: multisampling, supersampling";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        let shapes = Shapes::new(1, Ok)?;
        let [aliased, blended, multisampled, boxed, bartlett, gaussian] = &mut self.pictures;
        by_rows(aliased, |band| shapes.draw_aliased(band, BY_PIXEL));
        by_rows(blended, |band| {
            let drawn = shapes.draw_blended(band);
            debug_assert!(drawn.is_ok(), "the row memory is as wide as the picture");
        });
        by_rows(multisampled, |band| {
            let drawn = shapes.draw_multisampled(band);
            debug_assert!(drawn.is_ok(), "there are four words a pixel");
        });
        supersample::<BoxFilter>(
            boxed,
            &mut [0; Supersampling::<Rgb565, SAMPLES, BoxFilter>::sums_needed(WIDTH)],
        )?;
        supersample::<Bartlett>(
            bartlett,
            &mut [0; Supersampling::<Rgb565, SAMPLES, Bartlett>::sums_needed(WIDTH)],
        )?;
        supersample::<Gaussian>(
            gaussian,
            &mut [0; Supersampling::<Rgb565, SAMPLES, Gaussian>::sums_needed(WIDTH)],
        )?;
        Ok(self)
    }
}

/// Keeps the rows of a small picture.
fn keep(picture: &mut [u16; WIDTH * HEIGHT]) -> impl FnMut(Band<'_, Rgb565>) -> Result<(), Infallible> + '_ {
    let mut rows = picture.chunks_exact_mut(WIDTH);
    move |band| {
        for (kept, &word) in rows.next().into_iter().flatten().zip(band.words()) {
            *kept = word;
        }
        Ok(())
    }
}

fn by_rows(picture: &mut [u16; WIDTH * HEIGHT], draw: impl FnMut(&mut Band<'_, Rgb565>)) {
    let drawn = PictureLoop::new(SMALL, PAPER).draw(&mut [0; WIDTH], &mut keep(picture), draw);
    debug_assert!(drawn.is_ok(), "the row is as wide as the picture");
}

fn supersample<F: SampleFilter<SAMPLES>>(
    picture: &mut [u16; WIDTH * HEIGHT],
    sums: &mut [F::Sum],
) -> Result<(), PrepareError> {
    let shapes = Shapes::new(SAMPLES as u32, Supersampling::<Rgb565, SAMPLES, F>::enlarged)?;
    let drawn = Supersampling::<Rgb565, SAMPLES, F>::new(SMALL, PAPER)?.draw(
        &mut [0; SAMPLES * WIDTH],
        sums,
        &mut keep(picture),
        |band: &mut Band<'_, Rgb565>| shapes.draw_aliased(band, BY_SAMPLE),
    );
    debug_assert!(drawn.is_ok(), "the rows are as wide as they have to be");
    Ok(())
}

impl Prepared for Samples {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        title::<Self, O>(band);
        for (picture, (position, name)) in self.pictures.iter().zip(PANELS) {
            let middle = position + Point::new(WIDTH as i32 * SCALE as i32 / 2, -11);
            label(band, name, middle, Alignment::Center, &FONT_5X8, LABEL_COLOR);
            for (row, words) in (0..).zip(picture.chunks_exact(WIDTH)) {
                draw_magnified(band, words, position + Point::new(0, row * SCALE as i32));
            }
        }
        label(band, "seam", SEAM_LABEL, Alignment::Left, &FONT_5X8, PAPER);
        for (tip, end) in SEAM_ARROW {
            shape(
                band,
                &Line::new(tip, end).into_styled(PrimitiveStyle::with_stroke(PAPER, 1)),
            );
        }
    }
}

/// A row of pixels as squares.
fn draw_magnified<O: Order>(band: &mut Band<'_, Rgb565, O>, words: &[u16], position: Point) {
    let row = Rectangle::new(position, Size::new(WIDTH as u32 * SCALE, SCALE));
    if band.bounding_box().intersection(&row).is_zero_sized() {
        return;
    }
    for (column, &word) in (0..).zip(words) {
        let square = Rectangle::new(position + Point::new(column * SCALE as i32, 0), Size::new_equal(SCALE));
        let style = PrimitiveStyle::with_fill(Rgb565::from(RawU16::new(word)));
        shape(band, &square.into_styled(style));
    }
}
