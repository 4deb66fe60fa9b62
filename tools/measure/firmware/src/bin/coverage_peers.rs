//! Counts other rasterizers: the shapes of `coverage` into the same mask of 48 x 48 bytes, and the figures of `accuracy`
//! into squares of several sizes, from their corners on.
//!
//! They compute in `f32`, and are built for a core with a unit for that. What they allocate is counted too; giving it back
//! costs nothing here.
#![no_std]
#![no_main]

extern crate alloc;

use core::{
    alloc::{GlobalAlloc, Layout},
    cell::UnsafeCell,
    sync::atomic::{AtomicUsize, Ordering},
};

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use heapless::Vec;
use zrow_measure_firmware::{
    outlines::{self, MANY, SIZE, STAR, TRIANGLE, random_triangles, turned_stars},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_methods::{CIRCLE_CORNERS, FIGURE_SIZES, Figure, UNITS};

/// Columns and rows of the largest one.
const LARGEST: usize = 200;

/// In pixels from the corner of the mask.
type Corner = (f32, f32);
/// Contours.
type Shape<'a> = [&'a [Corner]];

/// In 1/256 pixel, as in `coverage`.
const fn corner(x: i32, y: i32) -> Corner {
    (x as f32 / 256.0, y as f32 / 256.0)
}

struct Mask {
    pixels: [u8; LARGEST * LARGEST],
    size: usize,
}

impl Mask {
    fn square(&mut self) -> &mut [u8] {
        self.pixels.get_mut(..self.size * self.size).unwrap_or_default()
    }
}

impl Canvas for Mask {
    fn erase(&mut self) {
        self.pixels.fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.square().iter().map(|coverage| u16::from(*coverage)))
    }
}

/// Bytes for all the shapes together.
const HEAP: usize = 3 << 20;

/// Hands memory out once, in order.
#[repr(align(8))]
struct Bump {
    memory: UnsafeCell<[u8; HEAP]>,
    used: AtomicUsize,
}

// SAFETY: there is one thread, and no interrupt allocates.
unsafe impl Sync for Bump {}

// SAFETY: every block is aligned, lies in the memory and begins where the last one ended.
unsafe impl GlobalAlloc for Bump {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let used = self.used.load(Ordering::Relaxed);
        let start = used.next_multiple_of(layout.align());
        let end = start.saturating_add(layout.size());
        if layout.align() > 8 || end > HEAP {
            return core::ptr::null_mut();
        }
        self.used.store(end, Ordering::Relaxed);
        // SAFETY: within the memory.
        unsafe { self.memory.get().cast::<u8>().add(start) }
    }

    unsafe fn dealloc(&self, _block: *mut u8, _layout: Layout) {}
}

#[global_allocator]
static ALLOCATOR: Bump = Bump {
    memory: UnsafeCell::new([0; HEAP]),
    used: AtomicUsize::new(0),
};

#[entry]
fn main() -> ! {
    let mut words = [0; 1024];
    let wanted = report::wanted(&mut words);
    let mask = cortex_m::singleton!(: Mask = Mask { pixels: [0; LARGEST * LARGEST], size: SIZE });
    let (Some(peripherals), Some(mask)) = (Peripherals::take(), mask) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    many(&mut runner, mask, "coverage.triangle", &[TRIANGLE]);
    many(&mut runner, mask, "coverage.star", &[STAR]);
    many(&mut runner, mask, "coverage.triangles", &random_triangles());
    many(&mut runner, mask, "coverage.stars", &turned_stars());
    for (figure, size) in Figure::ALL
        .into_iter()
        .flat_map(|figure| FIGURE_SIZES.map(|size| (figure, size)))
    {
        let in_pixels = |&(x, y): &(i32, i32)| corner(x + UNITS / 2, y + UNITS / 2);
        let shape = figure.shape(size);
        let contours = shape.contours.iter();
        let contours: Vec<Vec<Corner, CIRCLE_CORNERS>, 2> = contours
            .map(|contour| contour.iter().map(in_pixels).collect())
            .collect();
        let contours: Vec<&[Corner], 2> = contours.iter().map(Vec::as_slice).collect();
        mask.size = size as usize;
        peers(&mut runner, mask, figure.count_name(size), &[&contours]);
    }
    report::exit(true)
}

/// Counts outlines of one contour.
fn many<const CORNERS: usize>(
    runner: &mut Runner,
    mask: &mut Mask,
    name: &str,
    outlines: &[[outlines::Corner; CORNERS]],
) {
    let outlines: Vec<[Corner; CORNERS], MANY> = outlines
        .iter()
        .map(|outline| outline.map(|(x, y)| corner(x, y)))
        .collect();
    let contours: Vec<[&[Corner]; 1], MANY> = outlines.iter().map(|outline| [outline.as_slice()]).collect();
    let shapes: Vec<&Shape<'_>, MANY> = contours.iter().map(|contours| contours.as_slice()).collect();
    peers(runner, mask, name, &shapes);
}

fn peers(runner: &mut Runner, mask: &mut Mask, name: &str, shapes: &[&Shape<'_>]) {
    if !runner.wants(name) {
        return;
    }
    // It keeps its memory from shape to shape, and so has it all here.
    let mut scratch = zeno::Scratch::new();
    for shape in shapes {
        with_zeno(&mut scratch, mask, shape);
    }
    runner.count(name, "zeno", mask, shapes, |mask, shape| {
        with_zeno(&mut scratch, mask, shape)
    });
    runner.count(name, "ab_glyph_rasterizer", mask, shapes, |mask, shape| {
        with_ab_glyph_rasterizer(mask, shape);
    });
    runner.count(name, "tiny_skia", mask, shapes, |mask, shape| {
        with_tiny_skia(mask, shape)
    });
}

#[inline(never)]
fn with_zeno(scratch: &mut zeno::Scratch, mask: &mut Mask, shape: &Shape<'_>) {
    use zeno::{Command, Vector};
    let mut commands = Vec::<Command, { 2 * CIRCLE_CORNERS + 2 }>::new();
    for contour in shape {
        for (index, &(x, y)) in contour.iter().enumerate() {
            let corner = Vector::new(x, y);
            // It has room for every figure.
            let _ = commands.push(if index == 0 {
                Command::MoveTo(corner)
            } else {
                Command::LineTo(corner)
            });
        }
        let _ = commands.push(Command::Close);
    }
    let size = mask.size as u32;
    zeno::Mask::with_scratch(commands.as_slice(), scratch)
        .size(size, size)
        .render_into(mask.square(), None);
}

#[inline(never)]
fn with_ab_glyph_rasterizer(mask: &mut Mask, shape: &Shape<'_>) {
    use ab_glyph_rasterizer::{Rasterizer, point};
    let mut rasterizer = Rasterizer::new(mask.size, mask.size);
    for contour in shape {
        let mut from = contour.last().copied().unwrap_or_default();
        for &to in *contour {
            rasterizer.draw_line(point(from.0, from.1), point(to.0, to.1));
            from = to;
        }
    }
    let pixels = mask.square();
    rasterizer.for_each_pixel(|index, coverage| {
        if let Some(pixel) = pixels.get_mut(index) {
            *pixel = (coverage * 255.0 + 0.5) as u8;
        }
    });
}

#[inline(never)]
fn with_tiny_skia(mask: &mut Mask, shape: &Shape<'_>) {
    use tiny_skia::{FillRule, PathBuilder, Transform};
    let mut path = PathBuilder::new();
    for contour in shape {
        for (index, &(x, y)) in contour.iter().enumerate() {
            if index == 0 {
                path.move_to(x, y);
            } else {
                path.line_to(x, y);
            }
        }
        path.close();
    }
    let size = mask.size as u32;
    let drawn = tiny_skia::Mask::new(size, size).zip(path.finish());
    let Some((mut drawn, path)) = drawn else {
        report::exit(false)
    };
    drawn.fill_path(&path, FillRule::Winding, true, Transform::identity());
    mask.square().copy_from_slice(drawn.data());
}
