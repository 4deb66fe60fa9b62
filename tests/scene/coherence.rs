//! Coherence from frame to frame: how much of the painter's sort an order would save that is carried on from the last frame. The
//! figures are those of the docs of algorithms; the library carries no such order.

use core::cmp::Reverse;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::scene::{FaceSet, Memory, Model, Pose, Rotation};
use zrow_scenes::{
    meshes::{ICOSPHERE, TORUS_AND_CUBE},
    teapot::TEAPOT,
};

use crate::snapped_faces::{at, camera, snapped};

const FRAMES: u16 = 30;
const UNITS: i128 = 16;
const ROWS: i128 = 64;

/// A face that waits: the row that it begins in, and its order.
type Waiting = (i128, usize);

/// What a sort of all frames took.
#[derive(Debug, Default, Copy, Clone, PartialEq, Eq)]
struct Work {
    /// Faces that were moved.
    moves: usize,
    /// How often the depth of a face was asked for.
    keys: usize,
}

/// The sort of the painter's algorithm: Shell sort with gaps of Knuth.
fn shell_sort<K: Ord>(items: &mut [usize], work: &mut Work, key: impl Fn(usize) -> K) {
    let mut gap = 1;
    while gap < items.len() / 3 {
        gap = 3 * gap + 1;
    }
    while gap > 0 {
        for end in gap..items.len() {
            let (inserted, mut index) = (items[end], end);
            work.keys += 1;
            while index >= gap {
                work.keys += 1;
                if key(items[index - gap]) <= key(inserted) {
                    break;
                }
                items[index] = items[index - gap];
                work.moves += 1;
                index -= gap;
            }
            items[index] = inserted;
        }
        gap /= 3;
    }
}

/// The work of sorting the faces of 30 frames by their farthest corners, from the order of their first rows and from the order of
/// the frame before; between two frames the mesh turns by 1 degree about x and by 2 about y.
fn work(mesh: FaceSet<'static>) -> [Work; 2] {
    let area = Rectangle::new(Point::zero(), Size::new(128, 64));
    let (camera, colors) = (camera(area), vec![Rgb565::RED; mesh.faces().len()]);
    let mut memory = Box::new(Memory::<Rgb565, 600, 1_000, 128, 64, 100>::new());
    let mut work = [Work::default(); 2];
    let mut last: Vec<usize> = Vec::new();
    for frame in 0..=FRAMES {
        let [x, y] = [1, 2].map(|degrees| U0F16::from_bits(frame * degrees * 182));
        let rotation = Rotation::about_x(x).then(&Rotation::about_y(y));
        let pose = Pose::new(rotation, at(0, 0, 1_536));
        let models = [Model::new(mesh, &colors).unwrap().with_pose(pose)];
        let prepared = memory.prepare(&camera, &models).unwrap();
        let mut farthest = vec![0; mesh.faces().len()];
        let mut waiting: Vec<Waiting> = Vec::new();
        for face in snapped(&prepared) {
            farthest[face.order] = face
                .corners
                .iter()
                .map(|[_, _, depth]| *depth)
                .min()
                .unwrap_or_default();
            let [[ax, ay, _], [bx, by, _], [cx, cy, _]] = face.corners;
            let is_front = (bx - ax) * (cy - ay) > (by - ay) * (cx - ax);
            let (top, bottom) = (ay.min(by).min(cy), ay.max(by).max(cy));
            // The first row with a pixel whose centre may be inside.
            let first = (top + UNITS - 1).div_euclid(UNITS).max(0);
            if is_front && first < ROWS && UNITS * first < bottom {
                waiting.push((first, face.order));
            }
        }
        waiting.sort();
        let mut by_rows: Vec<usize> = waiting.into_iter().map(|(_, order)| order).collect();
        // Those that were there before, in their order, then the new ones.
        let (were, are_new): (Vec<_>, Vec<_>) = by_rows.iter().partition(|order| last.contains(*order));
        let mut carried: Vec<usize> = last.into_iter().filter(|order| were.contains(order)).collect();
        carried.extend(are_new);
        let key = |order: usize| (farthest[order], Reverse(order));
        let mut of_frame = [Work::default(); 2];
        shell_sort(&mut by_rows, &mut of_frame[0], key);
        shell_sort(&mut carried, &mut of_frame[1], key);
        assert_eq!(by_rows, carried);
        if frame > 0 {
            for (work, of_frame) in work.iter_mut().zip(of_frame) {
                work.moves += of_frame.moves;
                work.keys += of_frame.keys;
            }
        }
        last = by_rows;
    }
    work
}

/// From the order of rows, and from that of the last frame.
#[test]
fn an_order_that_is_carried_on_saves_more_than_half_of_the_moves() {
    let per_frame = |mesh| work(mesh).map(|work| [work.moves, work.keys].map(|number| number / usize::from(FRAMES)));
    assert_eq!(
        [TORUS_AND_CUBE, ICOSPHERE, TEAPOT].map(per_frame),
        [
            [[1_510, 3_642], [447, 2_681]],
            [[345, 870], [148, 705]],
            [[2_237, 5_014], [948, 3_840]],
        ]
    );
}

#[test]
fn a_sort_has_its_order() {
    let mut items = [3, 1, 4, 0, 5, 9, 2, 6, 8, 7];
    let mut work = Work::default();
    shell_sort(&mut items, &mut work, I16F16::from_num::<usize>);
    assert_eq!(items, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
    assert!(work.moves > 0 && work.moves < work.keys);
}
