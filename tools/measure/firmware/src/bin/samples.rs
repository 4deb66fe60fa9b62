//! Counts antialiasing by samples with a colour each: a shape into 48 x 48 pixels of 16 bits, from its corners on, row by
//! row.
#![no_std]
#![no_main]

use core::convert::Infallible;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use zrow::{
    band::{Band, PictureLoop, Supersampling},
    coverage::{Bartlett, BoxFilter, Gaussian, Rooks, SamplePattern, SignedArea},
    draw::{AntialiasedPolygon, DrawOn, FillRule, Polygon, PrimitiveStyle},
    geometry::{Sub8, SubPoint},
    shade::{ConeFilter, SampleFilter},
};
use zrow_measure_firmware::{
    outlines::{SIZE, STAR, TRIANGLE},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(SIZE as u32, SIZE as u32));
/// Edges of a shape.
const EDGES: usize = 7;
/// Words of the samples of a row: 16 samples a pixel.
const ROW: usize = 16 * SIZE;

/// Corners in 1/256 pixel from the corner of the picture.
type Shape = [(i32, i32)];

const INK: Rgb565 = Rgb565::CSS_GOLD;
const PAPER: Rgb565 = Rgb565::CSS_NAVY;

struct Picture {
    words: [[u16; SIZE]; SIZE],
    row: [u16; SIZE],
    samples: [u16; ROW],
    sums: [u32; 9 * SIZE],
    narrow_sums: [u16; 6 * SIZE],
}

impl Canvas for Picture {
    fn erase(&mut self) {
        self.words = [[0; SIZE]; SIZE];
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.words.as_flattened().iter().copied())
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let picture = cortex_m::singleton!(: Picture = Picture {
        words: [[0; SIZE]; SIZE],
        row: [0; SIZE],
        samples: [0; ROW],
        sums: [0; 9 * SIZE],
        narrow_sums: [0; 6 * SIZE],
    });
    let (Some(peripherals), Some(picture)) = (Peripherals::take(), picture) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    methods(&mut runner, picture, "samples.triangle", &TRIANGLE);
    methods(&mut runner, picture, "samples.star", &STAR);
    report::exit(true)
}

fn methods(runner: &mut Runner, picture: &mut Picture, name: &str, shape: &Shape) {
    if !runner.wants(name) {
        return;
    }
    macro_rules! count {
        ($($variant:literal, $draw:expr;)*) => { $(
            runner.count(name, $variant, picture, &[shape], |picture, shape| $draw(picture, shape));
        )* };
    }
    count! {
        "blended_area", blended;
        "multisample_4", multisampled::<Rooks<4>>;
        "multisample_8", multisampled::<Rooks<8>>;
        "multisample_16", multisampled::<Rooks<16>>;
        "supersample_2_box", |Picture { words, samples, narrow_sums, .. }: &mut Picture, shape: &Shape| {
            supersampled::<2, BoxFilter>(words, samples, narrow_sums, shape);
        };
        "supersample_4_box", |Picture { words, samples, narrow_sums, .. }: &mut Picture, shape: &Shape| {
            supersampled::<4, BoxFilter>(words, samples, narrow_sums, shape);
        };
        "supersample_8_box", |Picture { words, samples, narrow_sums, .. }: &mut Picture, shape: &Shape| {
            supersampled::<8, BoxFilter>(words, samples, narrow_sums, shape);
        };
        "supersample_16_box", |Picture { words, samples, narrow_sums, .. }: &mut Picture, shape: &Shape| {
            supersampled::<16, BoxFilter>(words, samples, narrow_sums, shape);
        };
        "supersample_4_bartlett", |Picture { words, samples, sums, .. }: &mut Picture, shape: &Shape| {
            supersampled::<4, Bartlett>(words, samples, sums, shape);
        };
        "supersample_4_cone", |Picture { words, samples, sums, .. }: &mut Picture, shape: &Shape| {
            supersampled::<4, ConeFilter>(words, samples, sums, shape);
        };
        "supersample_4_gaussian", |Picture { words, samples, sums, .. }: &mut Picture, shape: &Shape| {
            supersampled::<4, Gaussian>(words, samples, sums, shape);
        };
    }
}

/// From the corner of a pixel to its centre.
fn corners(shape: &Shape) -> [SubPoint<Sub8>; EDGES] {
    let mut corners = [SubPoint::<Sub8>::default(); EDGES];
    for (corner, (x, y)) in corners.iter_mut().zip(shape) {
        *corner = SubPoint::from_units(x - 128, y - 128).unwrap_or_default();
    }
    corners
}

fn prepare(shape: &Shape) -> AntialiasedPolygon<EDGES, EDGES> {
    let corners = corners(shape);
    let contour = corners.get(..shape.len()).unwrap_or_default();
    AntialiasedPolygon::prepare(&[contour], FillRule::NonZero).unwrap_or_else(|_| report::exit(false))
}

/// Keeps the rows of a picture.
fn keep<'w>(words: &'w mut [[u16; SIZE]; SIZE]) -> impl FnMut(Band<'_, Rgb565>) -> Result<(), Infallible> + 'w {
    |band| {
        let y = band.bounding_box().top_left.y;
        if let (Some(kept), Some(row)) = (words.get_mut(y as usize), band.words().first_chunk()) {
            *kept = *row;
        }
        Ok(())
    }
}

/// The exact area, blended.
#[inline(never)]
fn blended(picture: &mut Picture, shape: &Shape) {
    let polygon = prepare(shape);
    let mut memory = [0; SIZE + 1];
    let drawn = PictureLoop::new(AREA, PAPER).draw(
        &mut picture.row,
        &mut keep(&mut picture.words),
        |band: &mut Band<'_, Rgb565>| {
            let _ = polygon.draw(&SignedArea, INK, band, &mut memory);
        },
    );
    if drawn.is_err() {
        report::exit(false)
    }
}

/// Several samples a pixel.
#[inline(never)]
fn multisampled<P: SamplePattern>(picture: &mut Picture, shape: &Shape) {
    let polygon = prepare(shape);
    let mut memory = [P::Cell::default(); SIZE];
    let Picture {
        words, row, samples, ..
    } = picture;
    let drawn = PictureLoop::new(AREA, PAPER).draw(row, &mut keep(words), |band: &mut Band<'_, Rgb565>| {
        let drawn = band.multisample(P::default(), samples, |target| {
            polygon.draw_samples(INK, target, &mut memory)
        });
        if !matches!(drawn, Ok(Ok(()))) {
            report::exit(false)
        }
    });
    if drawn.is_err() {
        report::exit(false)
    }
}

/// Many times as large, row of samples by row of samples.
#[inline(never)]
fn supersampled<const N: usize, F: SampleFilter<N>>(
    words: &mut [[u16; SIZE]; SIZE],
    samples: &mut [u16],
    sums: &mut [F::Sum],
    shape: &Shape,
) {
    let corners = corners(shape);
    let corners = corners.map(|corner| Supersampling::<Rgb565, N, F>::enlarged(corner).unwrap_or_default());
    let contour = corners.get(..shape.len()).unwrap_or_default();
    let contours = [contour];
    let polygon = Polygon::new(&contours, FillRule::NonZero).prepare::<EDGES, EDGES>();
    let (Ok(polygon), Ok(picture)) = (polygon, Supersampling::<Rgb565, N, F>::new(AREA, PAPER)) else {
        report::exit(false)
    };
    let polygon = polygon.into_styled(PrimitiveStyle::with_fill(INK));
    let drawn = picture.draw(samples, sums, &mut keep(words), |band: &mut Band<'_, Rgb565>| {
        let Ok(()) = polygon.draw_on(band);
    });
    if drawn.is_err() {
        report::exit(false)
    }
}
