//! A model through a band and, as is named when the program is built, something else in its rows, or solids instead of it. Without
//! a name: nothing.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::I16F16;
use zrow::{
    band::Band,
    scan::FillRule,
    scene::{Camera, DoubleSided, Edge, FaceSet, Look, Memory, Model, Pose, Prepared},
    visible::{DepthLine, DepthPolygon, DepthState, PolygonOffset, SolidCombination, SolidNode},
};
use zrow_measure_firmware::{content, report, stack};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
const WIDTH: usize = 64;
const HEIGHT: usize = 16;
const FACES: usize = 100;

/// The memory of a scene.
type MemoryOf<L> = Memory<L, 100, FACES, WIDTH, HEIGHT, 50>;
/// A band that is drawn into.
type Rows<'a, 'b> = &'a mut Band<'b, Rgb565>;

#[entry]
fn main() -> ! {
    if const { content::is("depth_test.nothing") } {
        draw::<Rgb565>(|prepared, band, _| prepared.draw_with(band, |_| {}));
    }
    if const { content::is("depth_test.scene") } {
        let memory = cortex_m::singleton!(: MemoryOf<Rgb565> = Memory::new());
        draw::<Rgb565>(|prepared, band, (camera, models)| {
            let Some(Ok(mut other)) = memory.map(|memory| memory.prepare(camera, models)) else {
                return;
            };
            prepared.draw_with(band, |row| other.draw_in(row, &black_box(DepthState::NEARER)));
        });
    }
    if const { content::is("depth_test.lines") } {
        let edges = black_box([Edge::boundary([0, 1], 0); 4]);
        let mut lines: heapless::Vec<DepthLine<u16>, 4> = heapless::Vec::new();
        draw::<Rgb565>(|prepared, band, _| {
            lines.extend(prepared.lines_in_depth(0, &edges).map(|(_, line)| line));
            let state = black_box(DepthState {
                offset: PolygonOffset::WIREFRAME,
                ..DepthState::NEARER
            });
            prepared.draw_with(band, |row| {
                for line in &lines {
                    row.draw_line(line, Rgb565::WHITE, &state);
                }
            });
        });
    }
    if const { content::is("depth_test.polygon") } {
        let (corners, rule) = black_box(([[0; 3]; 8], FillRule::NonZero));
        let mut polygon = DepthPolygon::<u16, 16>::new();
        draw::<Rgb565>(|prepared, band, _| {
            if prepared
                .prepare_polygon(&mut polygon, &black_box(Pose::IDENTITY), &[&corners], rule)
                .is_err()
            {
                return;
            }
            let state = black_box(DepthState::NEARER);
            prepared.draw_with(band, |row| row.draw_polygon(&mut polygon, Rgb565::WHITE, &state));
        });
    }
    if const { content::is("depth_test.solids") } {
        let tree = black_box([
            SolidNode::Primitive(0..6),
            SolidNode::Primitive(6..12),
            SolidNode::Difference,
        ]);
        let mut method = SolidCombination::<FACES, 8>::new(&tree);
        draw::<DoubleSided<Rgb565>>(|prepared, band, _| _ = black_box(prepared.draw_by(&mut method, band)));
        black_box(&method);
    }
    stack::report(0);
    report::exit(true)
}

/// Prepares a frame of a mesh that the compiler does not know, and draws it. What draws gets the camera and the models, too.
#[inline(always)]
fn draw<L: Look<Color = Rgb565, Shading = Rgb565>>(
    draw: impl FnOnce(&mut Prepared<'_, '_, L>, Rows<'_, '_>, (&Camera, &[Model<'_, Rgb565>])),
) {
    let vertices = black_box([[0; 3]; 8]);
    let faces = black_box([[0; 3]; 12]);
    let colors = black_box([Rgb565::BLACK; 12]);
    let mut words = black_box([0; WIDTH * HEIGHT]);
    let mut memory = MemoryOf::<L>::new();
    let (Ok(mesh), Ok(camera)) = (
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
        draw(&mut prepared, &mut band, (&camera, &models));
    }
    black_box(&words);
}
