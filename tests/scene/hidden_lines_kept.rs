//! Parts of hidden lines that are kept in a picture, in buckets by row, against the same parts drawn at once.

use embedded_graphics::{
    pixelcolor::Gray8,
    prelude::*,
    primitives::{Line, Rectangle, Styled},
};
use fixed::types::{U16F16, U24F8};
use zrow::{
    band::Band,
    draw::{
        Antialiased, AntialiasingMemory, DrawAntialiased, DrawOn, Picture, PictureSlot, PrimitiveStyle, StrokeStyle,
        SubLine,
    },
    geometry::{Sub8, TooSmall},
    visible::{Appel, FaceAgainstSegment, LinePart},
};

use crate::common::meshes;
use crate::hidden_lines::{parts_by, table};
use crate::numbered_scene::Scene;
use crate::snapped_faces::{at, camera, standard_pose};
use crate::visibility::{self, MemoryOf};

const DASHES: [U16F16; 2] = [U16F16::lit("3"), U16F16::lit("2.5")];
const WIDTH: usize = visibility::WIDTH as usize;
const HEIGHT: usize = visibility::HEIGHT as usize;
const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));

/// A visible part: a line of a pixel and a half, antialiased.
fn visible(part: &LinePart<Sub8>) -> Styled<SubLine, Antialiased<PrimitiveStyle<Gray8>>> {
    let [start, end] = part.ends;
    let line = SubLine::new(start, end, U24F8::lit("1.5")).unwrap();
    line.into_styled(Antialiased(PrimitiveStyle::with_fill(Gray8::new(200))))
}

/// A hidden part, dashed.
fn hidden(part: &LinePart<Sub8>) -> Styled<Line, StrokeStyle<'static, Gray8>> {
    let [start, end] = part.pixels();
    Line::new(start, end).into_styled(StrokeStyle::new(Gray8::new(90), 1).dashes(&DASHES))
}

/// The parts of a torus and a cube that go through each other.
fn parts(frame: u16) -> Vec<LinePart<Sub8>> {
    let (torus, cube) = (meshes::torus(), meshes::cube(0.8));
    let (of_torus, of_cube) = (table::<576>(&torus), table::<12>(&cube));
    let scene = Scene::new(vec![torus, cube]);
    let mut models = scene.models(standard_pose(frame));
    models[1].pose.translation = at(400, 100, 3 * 512 - 200);
    let mut memory = Box::new(MemoryOf::<Sub8, u16>::new());
    let prepared = memory.prepare(&camera(AREA), &models).unwrap();
    let tables = [&of_torus[..], &of_cube];
    if frame.is_multiple_of(2) {
        parts_by(&prepared, &tables, &mut FaceAgainstSegment::<2_000, 8, true>::new())
    } else {
        parts_by(&prepared, &tables, &mut Appel::<2_000, 40, 4_000, true>::new())
    }
}

/// All parts, drawn into a whole frame one after the other.
fn drawn_at_once(parts: &[LinePart<Sub8>]) -> Vec<u8> {
    let mut words = vec![0; WIDTH * HEIGHT];
    let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
    let mut row_memory = [0; WIDTH + 1];
    for part in parts {
        if part.is_hidden {
            let Ok(()) = hidden(part).draw_on(&mut band);
        } else {
            let mut target = band.antialiased::<8, 8>(&mut row_memory);
            DrawAntialiased::draw_on(&visible(part), &mut target).unwrap();
        }
    }
    words
}

#[test]
fn parts_in_a_picture_are_those_drawn_at_once_in_any_order_of_rows() {
    for frame in 0..4 {
        let parts = parts(frame);
        let hidden_parts = parts.iter().filter(|part| part.is_hidden).count();
        assert!(hidden_parts > 20 && parts.len() - hidden_parts > 20, "{hidden_parts}");
        let expected = drawn_at_once(&parts);

        let (mut slots, mut pool, mut buckets) = (
            (0..parts.len()).map(|_| PictureSlot::EMPTY).collect::<Vec<_>>(),
            vec![0; 40_000],
            [0; HEIGHT],
        );
        let mut memory = AntialiasingMemory::<{ WIDTH + 1 }, 64, 64>::new();
        let mut picture =
            Picture::<Gray8>::new(AREA, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
        for part in &parts {
            if part.is_hidden {
                picture.add(&hidden(part)).unwrap();
            } else {
                picture.add(&visible(part)).unwrap();
            }
        }
        let downwards: Vec<_> = (0..HEIGHT).collect();
        let upwards: Vec<_> = (0..HEIGHT).rev().collect();
        let leaping: Vec<_> = (0..HEIGHT).map(|row| row * 7 % HEIGHT).collect();
        for rows in [downwards, upwards, leaping] {
            for row in rows {
                let mut words = [0; WIDTH];
                let window = Rectangle::new(Point::new(0, row as i32), Size::new(WIDTH as u32, 1));
                picture.draw(&mut Band::new(window, &mut words).unwrap());
                assert_eq!(words, expected[row * WIDTH..][..WIDTH], "row {row} of frame {frame}");
            }
        }
    }
}

#[test]
fn a_picture_says_how_many_slots_the_parts_take() {
    let parts = parts(0);
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 3], vec![0; 40_000], [0; HEIGHT]);
    let mut picture = Picture::<Gray8>::new(AREA, &mut slots, &mut pool, &mut buckets);
    let errors: Vec<_> = parts
        .iter()
        .filter_map(|part| picture.add(&hidden(part)).err())
        .collect();
    assert_eq!(errors.len(), parts.len() - 3);
    assert_eq!(errors[0], TooSmall::Items(4).into());
}
