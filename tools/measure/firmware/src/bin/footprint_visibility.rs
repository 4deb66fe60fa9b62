//! A model through a band by one method of visibility, which is named when the program is built. Without a name: nothing.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::I16F16;
use zrow::{
    band::Band,
    scene::{Camera, FaceSet, Memory, Model, Prepared},
};
use zrow_measure_firmware::{content, report, stack};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
const WIDTH: usize = 64;
const HEIGHT: usize = 16;
const PIXELS: usize = WIDTH * HEIGHT;
const TILES: usize = 4;
const TILE_FACES: usize = 100;
const FACES: usize = 100;
const CELLS: usize = 100;
const ENTRIES: usize = 200;
const ACTIVE: usize = 50;

#[entry]
fn main() -> ! {
    if const { content::is("visibility.row") } {
        draw(|prepared, band| prepared.draw(band));
    }
    macro_rules! link {
        ($([$method:ident] [$new:expr])+) => {$(
            if const { content::is(concat!("visibility.", stringify!($method))) } {
                let mut method = $new;
                draw(|prepared, band| _ = black_box(prepared.draw_by(&mut method, band)));
                black_box(&method);
            }
        )+};
    }
    zrow_methods::hidden_surfaces!(link);
    stack::report(0);
    report::exit(true)
}

/// Prepares a frame of a mesh that the compiler does not know, and draws it.
#[inline(always)]
fn draw(draw: impl FnOnce(&mut Prepared<'_, '_, Rgb565>, &mut Band<'_, Rgb565>)) {
    let vertices = black_box([[0; 3]; 8]);
    let faces = black_box([[0; 3]; 12]);
    let colors = black_box([Rgb565::BLACK; 12]);
    let mut words = black_box([0; PIXELS]);
    let memory = cortex_m::singleton!(: Memory<Rgb565, 100, FACES, WIDTH, HEIGHT, ACTIVE> = Memory::new());
    let (Some(memory), Ok(mesh), Ok(camera)) = (
        memory,
        FaceSet::new(&vertices, &faces),
        Camera::new(AREA, I16F16::from_num(128)),
    ) else {
        report::exit(false)
    };
    let (Ok(model), Ok(mut band)) = (Model::new(mesh, &colors), Band::new(AREA, &mut words)) else {
        report::exit(false)
    };
    let models = [model];
    if let Ok(mut prepared) = memory.prepare(&camera, &models) {
        draw(&mut prepared, &mut band);
    }
    black_box(&words);
}
