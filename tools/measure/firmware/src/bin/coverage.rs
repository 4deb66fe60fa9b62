//! Counts the methods of antialiasing: outlines into a mask of 48 x 48 bytes, from their corners on.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow::{
    coverage::CoverageMethod,
    draw::{AntialiasedPolygon, FillRule},
    geometry::TooSmall,
    geometry::{Sub8, SubPoint, Window},
};
use zrow_measure_firmware::{
    coverages,
    outlines::{Corner, SIZE, STAR, TRIANGLE, random_triangles, turned_stars},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const WINDOW: Window = Window {
    left: 0,
    top: 0,
    right: SIZE as i32,
    bottom: SIZE as i32,
};
/// Edges of a shape.
const EDGES: usize = 7;

struct Mask([[u8; SIZE]; SIZE]);

impl Canvas for Mask {
    fn erase(&mut self) {
        self.0 = [[0; SIZE]; SIZE];
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.as_flattened().iter().map(|coverage| u16::from(*coverage)))
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let mask = cortex_m::singleton!(: Mask = Mask([[0; SIZE]; SIZE]));
    let (Some(peripherals), Some(mask)) = (Peripherals::take(), mask) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    methods(&mut runner, mask, "coverage.triangle", &[TRIANGLE]);
    methods(&mut runner, mask, "coverage.star", &[STAR]);
    methods(&mut runner, mask, "coverage.triangles", &random_triangles());
    methods(&mut runner, mask, "coverage.stars", &turned_stars());
    report::exit(true)
}

fn methods<const CORNERS: usize>(runner: &mut Runner, mask: &mut Mask, name: &str, outlines: &[[Corner; CORNERS]]) {
    if !runner.wants(name) {
        return;
    }
    macro_rules! count {
        ($([$name:ident] [$($method:tt)+])+) => {$(
            let method = <$($method)+>::default();
            // The caller's, and empty after each shape.
            let mut memory = row_memory(&method);
            runner.count(name, stringify!($name), mask, outlines, |mask, outline| cover(&method, mask, &mut memory, outline));
        )+};
    }
    zrow_methods::coverage_methods!(count);
}

fn row_memory<T: CoverageMethod>(_method: &T) -> [T::Cell; SIZE + 1] {
    [T::Cell::default(); SIZE + 1]
}

/// Sets the outline up and covers the mask with it.
#[inline(never)]
fn cover<T: CoverageMethod>(method: &T, mask: &mut Mask, memory: &mut [T::Cell], outline: &[Corner]) {
    let mut corners = [SubPoint::<Sub8>::default(); EDGES];
    for (corner, (x, y)) in corners.iter_mut().zip(outline) {
        // From the corner of a pixel to its centre.
        *corner = SubPoint::from_units(x - 128, y - 128).unwrap_or_default();
    }
    let contour = corners.get(..outline.len()).unwrap_or_default();
    let mut polygon = AntialiasedPolygon::<EDGES, EDGES>::empty();
    if polygon.set_up(&[contour], FillRule::NonZero).is_err() {
        report::exit(false)
    }
    let covered = polygon.cover(method, &WINDOW, memory, |span, coverage| {
        let row = mask.0.get_mut(span.y as usize);
        if let Some(pixels) = row.and_then(|row| row.get_mut(span.start as usize..span.end as usize)) {
            coverages::fill(pixels, coverage);
        }
        Ok::<_, TooSmall>(())
    });
    if covered.is_err() {
        report::exit(false)
    }
}
