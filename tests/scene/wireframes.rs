//! Meshes as lines: the edges that a scene hands out, drawn with the lines of the library, against edges that
//! are projected in `f64`.

use embedded_graphics::{
    pixelcolor::{Rgb565, RgbColor},
    prelude::*,
    primitives::{Line, Rectangle},
};
use fixed::types::I2F14;
use zrow::{
    band::Band,
    draw::{DrawOn, PrimitiveStyle},
    scene::{Edge, FaceSet, Memory, Model, Prepared},
};

use crate::common::meshes;
use crate::numbered_scene::area;
use crate::snapped_faces::{camera, standard_pose};

/// Draws the edges of the only model that are to be seen.
fn draw_edges(scene: &Prepared<'_, '_, Rgb565>, edges: &[Edge], band: &mut Band<'_, Rgb565>) {
    for edge in scene.edges(0, edges) {
        let [start, end] = edge.ends.map(|end| end.pixel());
        let Ok(()) = Line::new(start, end)
            .into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1))
            .draw_on(band);
    }
}

/// The distance of a point from a segment.
fn distance(point: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
    let (way, offset) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
    let square = way[0] * way[0] + way[1] * way[1];
    let at = ((way[0] * offset[0] + way[1] * offset[1]) / square).clamp(0.0, 1.0);
    (offset[0] - at * way[0]).hypot(offset[1] - at * way[1])
}

#[test]
fn edges_are_where_they_are_projected_to() {
    let (area, mesh) = (area(96, 80), meshes::cube(1.0));
    let colors = [Rgb565::BLACK; 12];
    let faces: &[_; 12] = mesh.faces[..].try_into().unwrap();
    let edges: [Edge; 12] = FaceSet::find_edges(&mesh.vertices, faces, I2F14::lit("0.866")).unwrap();
    let mut lit = 0;
    for frame in 0..24 {
        let pose = standard_pose(frame * 21 + 4);
        let models = [Model::new(mesh.face_set(), &colors).unwrap().with_pose(pose)];
        let mut memory = Box::new(Memory::<Rgb565, 8, 12, 96, 80>::new());
        let scene = memory.prepare(&camera(area), &models).unwrap();
        let mut words = vec![0; 96 * 80];
        draw_edges(&scene, &edges, &mut Band::<Rgb565>::new(area, &mut words).unwrap());
        // Row by row it is the same picture.
        for (y, row) in words.chunks(96).enumerate() {
            let mut alone = vec![0; 96];
            let place = Rectangle::new(Point::new(0, y as i32), Size::new(96, 1));
            draw_edges(&scene, &edges, &mut Band::<Rgb565>::new(place, &mut alone).unwrap());
            assert_eq!(alone, row, "row {y}");
        }

        let corners: Vec<[f64; 2]> = mesh
            .vertices
            .iter()
            .map(|vertex| {
                let matrix = pose.rotation.matrix().map(|row| row.map(|part| part.to_num::<f64>()));
                let point = matrix.map(|row| {
                    row.iter()
                        .zip(vertex)
                        .map(|(part, at)| part * f64::from(*at))
                        .sum::<f64>()
                });
                let distance = point[2] + 1_536.0;
                [47.5 + 48.0 * point[0] / distance, 39.5 - 48.0 * point[1] / distance]
            })
            .collect();
        let area_of = |face: [u16; 3]| {
            let [a, b, c] = face.map(|index| corners[usize::from(index)]);
            (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        };
        // Without the diagonals: vertex n of the cube lies at the bits of n.
        let sides = |[a, b, c]: [u16; 3]| {
            let sides = [[a, b], [b, c], [c, a]].into_iter();
            let sides = sides.filter(|[from, to]| (from ^ to).is_power_of_two());
            sides.map(|side| side.map(|vertex| corners[usize::from(vertex)]))
        };
        // What is nearly on edge may be seen or not.
        let of_faces = |least: f64| {
            let faces = mesh.faces.iter().copied().filter(move |face| area_of(*face) > least);
            faces.flat_map(sides).collect::<Vec<_>>()
        };
        let (may, must) = (of_faces(-30.0), of_faces(30.0));
        let drawn: Vec<[f64; 2]> = area
            .points()
            .zip(&words)
            .filter(|(_, word)| **word != 0)
            .map(|(point, _)| [f64::from(point.x), f64::from(point.y)])
            .collect();
        lit += drawn.len();
        for pixel in &drawn {
            let nearest = may.iter().map(|side| distance(*pixel, *side)).fold(f64::MAX, f64::min);
            assert!(nearest < 1.3, "{pixel:?} is {nearest} from an edge in frame {frame}");
        }
        for [a, b] in must {
            for step in 0..=64 {
                let at = f64::from(step) / 64.0;
                let point = [a[0] + at * (b[0] - a[0]), a[1] + at * (b[1] - a[1])];
                let nearest = drawn
                    .iter()
                    .map(|pixel| distance(*pixel, [point, [point[0] + 1e-9, point[1]]]));
                assert!(
                    nearest.fold(f64::MAX, f64::min) < 1.3,
                    "{point:?} is not drawn in frame {frame}"
                );
            }
        }
    }
    assert!(lit > 4_000, "{lit}");
}
