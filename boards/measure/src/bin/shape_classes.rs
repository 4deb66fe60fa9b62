//! Counts the tiers of antialiasing on the shape classes of the accuracy report: from corners to a mask of 48 x 48 bytes.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    pixelcolor::{Gray8, GrayColor},
    prelude::*,
    primitives::Rectangle,
};
use heapless::Vec;
use zrow::{
    band::{Band, BufferTooSmall},
    coverage::{
        Bartlett, CentreSample, Coverage, Gaussian, Grid, InsideArea, Rooks4, Rooks8, Rooks16, SignedArea, SubRows,
    },
    draw::{AntialiasedPolygon, DrawOn, FillRule, Polygon, PrimitiveStyle},
    geometry::{Sub8, SubPoint, Window},
};
use zrow_measure::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_shapes::{CIRCLE_CORNERS, Class, Rule, SHAPES, SIZE};

/// Edges of round shapes, and those of them that lie in the same row of pixels.
const ROUND: usize = 2 * CIRCLE_CORNERS;
const ROUND_ACTIVE: usize = 128;
/// The same of all others.
const FEW: usize = 8;

const AREA: Window = Window {
    left: 0,
    top: 0,
    right: SIZE as i32,
    bottom: SIZE as i32,
};

struct Mask([u8; SIZE * SIZE]);

impl Canvas for Mask {
    fn erase(&mut self) {
        self.0.fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.iter().map(|share| u16::from(*share)))
    }
}

/// A shape as the library takes it.
struct Input {
    contours: Vec<Vec<SubPoint<Sub8>, CIRCLE_CORNERS>, 2>,
    rule: FillRule,
}

impl Input {
    fn new(class: Class, number: u32) -> Self {
        let shape = class.shape(number);
        let point = |&(x, y): &(i32, i32)| SubPoint::from_units(x, y).unwrap_or_default();
        let contours = shape.contours.iter();
        Self {
            contours: contours.map(|contour| contour.iter().map(point).collect()).collect(),
            rule: match shape.rule {
                Rule::EvenOdd => FillRule::EvenOdd,
                Rule::NonZero => FillRule::NonZero,
            },
        }
    }

    fn contours(&self) -> Vec<&[SubPoint<Sub8>], 2> {
        self.contours.iter().map(Vec::as_slice).collect()
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 512];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    for class in Class::ALL {
        match class {
            _ if !runner.wants(class.count_name()) => {}
            Class::Circle | Class::Ring => tiers::<ROUND, ROUND_ACTIVE>(&mut runner, class),
            _ => tiers::<FEW, FEW>(&mut runner, class),
        }
    }
    report::exit(true)
}

/// Counts every tier with the same shapes. The last shape stays in the mask.
fn tiers<const EDGES: usize, const ACTIVE: usize>(runner: &mut Runner, class: Class) {
    let inputs: [Input; SHAPES as usize] = core::array::from_fn(|number| Input::new(class, number as u32));
    let mut mask = Mask([0; SIZE * SIZE]);
    runner.count(
        class.count_name(),
        "scanline_fill",
        &mut mask,
        &inputs,
        scanline_fill::<EDGES, ACTIVE>,
    );
    macro_rules! doors {
        ($($door:literal: $tier:ty),+ $(,)?) => {$(
            runner.count(class.count_name(), $door, &mut mask, &inputs, cover::<$tier, EDGES, ACTIVE>);
        )+};
    }
    doors![
        "centre_sample": CentreSample,
        "rooks_4": Rooks4,
        "rooks_8": Rooks8,
        "rooks_16": Rooks16,
        "sub_rows_4": SubRows<4>,
        "sub_rows_16": SubRows<16>,
        "signed_area": SignedArea,
        "inside_area": InsideArea,
        "grid_2": Grid<2>,
        "grid_4": Grid<4>,
        "grid_8": Grid<8>,
        "grid_16": Grid<16>,
        "grid_4_bartlett": Grid<4, Bartlett>,
        "grid_16_bartlett": Grid<16, Bartlett>,
        "grid_4_gaussian": Grid<4, Gaussian>,
        "grid_16_gaussian": Grid<16, Gaussian>,
    ];
}

fn scanline_fill<const EDGES: usize, const ACTIVE: usize>(mask: &mut Mask, input: &Input) {
    mask.erase();
    let area = Rectangle::new(Point::zero(), Size::new_equal(SIZE as u32));
    let Ok(mut band) = Band::<Gray8>::new(area, &mut mask.0) else {
        report::exit(false)
    };
    let contours = input.contours();
    match Polygon::new(&contours, input.rule).prepare::<EDGES, ACTIVE>() {
        Ok(polygon) => {
            let Ok(()) = polygon
                .into_styled(PrimitiveStyle::with_fill(Gray8::WHITE))
                .draw_on(&mut band);
        }
        Err(_) => report::exit(false),
    }
}

fn cover<T: Coverage + Default, const EDGES: usize, const ACTIVE: usize>(mask: &mut Mask, input: &Input) {
    mask.erase();
    let mut row_memory = [T::Cell::default(); SIZE + 2];
    let contours = input.contours();
    let Ok(polygon) = AntialiasedPolygon::<EDGES, ACTIVE>::prepare(&contours, input.rule) else {
        report::exit(false)
    };
    let covered = polygon.cover(&T::default(), &AREA, &mut row_memory, |span, share| {
        let row = mask.0.chunks_exact_mut(SIZE).nth(span.y as usize);
        if let Some(pixels) = row.and_then(|row| row.get_mut(span.start as usize..span.end as usize)) {
            pixels.fill(share);
        }
        Ok::<_, BufferTooSmall>(())
    });
    if covered.is_err() {
        report::exit(false);
    }
}
