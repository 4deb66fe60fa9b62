//! Counts other rasterizers: the shapes of `coverage` into the same mask of 48 x 48 bytes, from their corners on.
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
use zrow_measure::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const SIZE: usize = 48;

/// Corners in pixels from the corner of the mask.
type Shape = [(f32, f32)];

/// In 1/256 pixel, as in `coverage`.
const fn corner(x: i32, y: i32) -> (f32, f32) {
    (x as f32 / 256.0, y as f32 / 256.0)
}

const TRIANGLE: [(f32, f32); 3] = [corner(845, 538), corner(11_315, 4_531), corner(3_226, 11_622)];
const STAR: [(f32, f32); 7] = [
    corner(6_144, 512),
    corner(8_588, 11_218),
    corner(1_741, 2_632),
    corner(11_635, 7_397),
    corner(653, 7_397),
    corner(10_547, 2_632),
    corner(3_700, 11_218),
];

struct Mask([[u8; SIZE]; SIZE]);

impl Canvas for Mask {
    fn erase(&mut self) {
        self.0 = [[0; SIZE]; SIZE];
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.as_flattened().iter().map(|share| u16::from(*share)))
    }
}

/// Bytes for all the shapes together.
const HEAP: usize = 1 << 20;

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
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let mask = cortex_m::singleton!(: Mask = Mask([[0; SIZE]; SIZE]));
    let (Some(peripherals), Some(mask)) = (Peripherals::take(), mask) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    peers(&mut runner, mask, "coverage.triangle", &TRIANGLE);
    peers(&mut runner, mask, "coverage.star", &STAR);
    report::exit(true)
}

fn peers(runner: &mut Runner, mask: &mut Mask, name: &str, shape: &Shape) {
    if !runner.wants(name) {
        return;
    }
    // It keeps its memory from shape to shape, and so has it all here.
    let mut scratch = zeno::Scratch::new();
    with_zeno(&mut scratch, mask, shape);
    runner.count(name, "zeno", mask, &[shape], |mask, shape| {
        with_zeno(&mut scratch, mask, shape)
    });
    runner.count(name, "ab_glyph_rasterizer", mask, &[shape], |mask, shape| {
        with_ab_glyph_rasterizer(mask, shape);
    });
    runner.count(name, "tiny_skia", mask, &[shape], |mask, shape| {
        with_tiny_skia(mask, shape)
    });
}

#[inline(never)]
fn with_zeno(scratch: &mut zeno::Scratch, mask: &mut Mask, shape: &Shape) {
    use zeno::Command;
    let mut commands = [Command::Close; 8];
    let vectors = shape.iter().map(|&(x, y)| zeno::Vector::new(x, y));
    for (index, (command, vector)) in commands.iter_mut().zip(vectors).enumerate() {
        *command = if index == 0 {
            Command::MoveTo(vector)
        } else {
            Command::LineTo(vector)
        };
    }
    let commands = commands.get(..=shape.len()).unwrap_or_default();
    zeno::Mask::with_scratch(commands, scratch)
        .size(SIZE as u32, SIZE as u32)
        .render_into(mask.0.as_flattened_mut(), None);
}

#[inline(never)]
fn with_ab_glyph_rasterizer(mask: &mut Mask, shape: &Shape) {
    use ab_glyph_rasterizer::{Rasterizer, point};
    let mut rasterizer = Rasterizer::new(SIZE, SIZE);
    let mut from = shape.last().copied().unwrap_or_default();
    for &to in shape {
        rasterizer.draw_line(point(from.0, from.1), point(to.0, to.1));
        from = to;
    }
    let pixels = mask.0.as_flattened_mut();
    rasterizer.for_each_pixel(|index, share| {
        if let Some(pixel) = pixels.get_mut(index) {
            *pixel = (share * 255.0 + 0.5) as u8;
        }
    });
}

#[inline(never)]
fn with_tiny_skia(mask: &mut Mask, shape: &Shape) {
    use tiny_skia::{FillRule, PathBuilder, Transform};
    let mut path = PathBuilder::new();
    for (index, &(x, y)) in shape.iter().enumerate() {
        if index == 0 {
            path.move_to(x, y);
        } else {
            path.line_to(x, y);
        }
    }
    path.close();
    let drawn = tiny_skia::Mask::new(SIZE as u32, SIZE as u32).zip(path.finish());
    let Some((mut drawn, path)) = drawn else {
        report::exit(false)
    };
    drawn.fill_path(&path, FillRule::Winding, true, Transform::identity());
    mask.0.as_flattened_mut().copy_from_slice(drawn.data());
}
