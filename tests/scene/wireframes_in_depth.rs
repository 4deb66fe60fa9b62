//! Wireframes over the faces of their own scene: with a polygon offset every pixel of an edge is seen that no faces but those
//! beside the edge cover, and none that something hides by more than the offset.

use std::collections::BTreeMap;

use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
use zrow::{
    band::Band,
    geometry::{Sub4, Sub8, Window},
    scan::Lines,
    scene::{DepthWidth, Edge, FaceSet, Memory, Pose},
    visible::{DepthState, PolygonOffset},
};

use crate::common::cases;
use crate::common::meshes::{self, Mesh};
use crate::numbered_scene::{Format, LookIn, Scene, area};
use crate::reference::nearest_faces::Face;
use crate::snapped_faces::{at, camera, snapped, standard_pose};

const WIDTH: u32 = 96;
const HEIGHT: u32 = 72;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

type MemoryOf<S, D> = Memory<LookIn<S, D>, 2_000, 1_000, { WIDTH as usize }, { HEIGHT as usize }, 200>;

/// All sides of the faces of a mesh as edges, each once.
fn sides(mesh: &Mesh) -> Vec<Edge> {
    let mut faces_of = BTreeMap::<[u16; 2], Vec<u16>>::new();
    for (number, [a, b, c]) in mesh.faces.iter().enumerate() {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let side = [*from.min(to), *from.max(to)];
            faces_of.entry(side).or_default().push(number as u16);
        }
    }
    let edge = |(side, faces): ([u16; 2], Vec<u16>)| match faces[..] {
        [one] => Edge::boundary(side, one),
        [one, other, ..] => Edge::crease(side, [one, other]),
        [] => unreachable!("each side has a face"),
    };
    faces_of.into_iter().map(edge).collect()
}

/// The greatest slope of a face, in stored depths a pixel.
fn slope<S: Format<D>, D: DepthWidth>(face: &Face) -> f64 {
    let [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = face.corners;
    let area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
    let per_column = (z1 - z0) * (y2 - y0) - (z2 - z0) * (y1 - y0);
    let per_row = (x1 - x0) * (z2 - z0) - (x2 - x0) * (z1 - z0);
    let steepest = per_column.abs().max(per_row.abs()) << S::FRACTION_BITS;
    unit::<D>() * steepest as f64 / area as f64
}

/// Stored depths of a unit.
fn unit<D: DepthWidth>() -> f64 {
    if D::FRACTION_BITS == 16 { 1.0 } else { 256.0 }
}

/// How many pixels of edges there are, how many of them are seen, and how many are hidden by the faces beside them without
/// an offset.
#[derive(Debug, Default)]
struct Counts {
    pixels: usize,
    seen: usize,
    hidden_without_offset: usize,
}

/// Draws each side of a mesh's faces alone over its scene.
fn check<S: Format<D>, D: DepthWidth>(meshes: Vec<Mesh>, pose: Pose, counts: &mut Counts) {
    let camera = camera(area(WIDTH, HEIGHT));
    let scene = Scene::new(meshes.clone());
    let models = scene.models(pose);
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let faces: Vec<Face> = snapped(&prepared);
    let mut depths = vec![0u32; PIXELS];
    let mut words = vec![0; PIXELS];
    prepared.draw_with(
        &mut Band::<Rgb888>::new(area(WIDTH, HEIGHT), &mut words).unwrap(),
        |row| {
            let first = row.y() as usize * WIDTH as usize;
            for (stored, depth) in depths[first..].iter_mut().zip(row.depths()) {
                *stored = (*depth).into();
            }
        },
    );
    let mut first_face = 0;
    for (model, mesh) in meshes.iter().enumerate() {
        let edges = sides(mesh);
        let lines: Vec<_> = prepared.lines_in_depth(model, &edges).collect();
        assert_eq!(lines.len(), prepared.edges(model, &edges).count());
        for (edge, line) in lines {
            let beside = edges[edge.index].faces().map(|face| {
                if face == FaceSet::NO_NEIGHBOUR {
                    usize::MAX
                } else {
                    first_face + usize::from(face)
                }
            });
            let [shown, without] = [PolygonOffset::WIREFRAME, PolygonOffset::NONE].map(|offset| {
                let state = DepthState {
                    writes: false,
                    offset,
                    ..DepthState::NEARER
                };
                let mut words = vec![0; PIXELS];
                let mut band = Band::<Rgb888>::new(area(WIDTH, HEIGHT), &mut words).unwrap();
                prepared.draw_with(&mut band, |row| row.draw_line(&line, Rgb888::WHITE, &state));
                words
            });
            let ends = edge.ends.map(|end| (end.pixel(), f64::from(end.depth.into())));
            let parts: Vec<&Face> = faces.iter().filter(|face| beside.contains(&face.order)).collect();
            let steepest = parts
                .iter()
                .filter(is_front)
                .map(|part| slope::<S, D>(part))
                .fold(0.0, f64::max);
            let offset = 1.5 * steepest + 2.0 * unit::<D>();
            for pixel in Lines::bresenham(ends[0].0, ends[1].0, &Window::from(area(WIDTH, HEIGHT))) {
                let index = pixel.y as usize * WIDTH as usize + pixel.x as usize;
                let is_shown = shown[index] == Rgb888::WHITE.into_storage();
                counts.pixels += 1;
                counts.seen += usize::from(is_shown);
                let covers = |face: &&Face| {
                    let [x, y] = [pixel.x, pixel.y].map(|number| i128::from(number) << S::FRACTION_BITS);
                    face.covers(x, y)
                };
                let is_beside_alone = faces.iter().filter(covers).all(|face| beside.contains(&face.order));
                if is_beside_alone {
                    assert!(is_shown, "{edge:?} misses {pixel:?}");
                    let is_hidden = without[index] != Rgb888::WHITE.into_storage();
                    counts.hidden_without_offset += usize::from(is_hidden);
                }
                if is_shown {
                    let depth = depth_at(ends, pixel);
                    let nearest = f64::from(depths[index]);
                    assert!(
                        nearest < depth + offset + 2.0,
                        "{edge:?} shows {pixel:?}: {nearest} {depth} {offset}"
                    );
                } else {
                    // What is not shown is hidden: by no less than the offset, but for what is rounded.
                    let depth = depth_at(ends, pixel);
                    assert!(
                        f64::from(depths[index]) > depth + offset - 2.0,
                        "{edge:?} hides {pixel:?}"
                    );
                }
            }
        }
        first_face += mesh.faces.len();
    }
}

fn is_front(face: &&&Face) -> bool {
    let [a, b, c] = face.corners;
    (b[0] - a[0]) * (c[1] - a[1]) > (c[0] - a[0]) * (b[1] - a[1])
}

/// The depth of a pixel of a line evenly between its ends.
fn depth_at(ends: [(Point, f64); 2], pixel: Point) -> f64 {
    let [(from, first), (to, last)] = ends;
    let length = |a: Point, b: Point| f64::from((a.x - b.x).abs().max((a.y - b.y).abs()));
    if from == to {
        first.max(last)
    } else {
        first + (last - first) * length(from, pixel) / length(from, to)
    }
}

/// In all formats; how many pixels of edges there are, are seen, and need the offset.
fn in_all_formats(meshes: &[Mesh], pose: Pose) -> Counts {
    let mut counts = Counts::default();
    check::<Sub4, u16>(meshes.to_vec(), pose, &mut counts);
    check::<Sub8, u16>(meshes.to_vec(), pose, &mut counts);
    check::<Sub4, u32>(meshes.to_vec(), pose, &mut counts);
    check::<Sub8, u32>(meshes.to_vec(), pose, &mut counts);
    counts
}

#[test]
fn wireframes_over_their_own_faces_miss_no_pixel() {
    let frames = cases(1, 16) as u16;
    for frame in 0..frames {
        let pose = standard_pose(frame * 5 + 1);
        for meshes in meshes::standard_scenes() {
            let counts = in_all_formats(&meshes, pose);
            assert!(counts.seen > 600 && counts.hidden_without_offset > 20, "{counts:?}");
        }
    }
}

/// Cut by the near plane and the guard band.
#[test]
fn wireframes_around_the_camera_miss_no_pixel() {
    let mut counts = Counts::default();
    for frame in 0..12 {
        let mut pose = standard_pose(frame * 9 + 2);
        pose.translation = at(140, -160, 330 + i32::from(frame) * 20);
        let meshes = [meshes::cube(0.6), meshes::cube(0.4)];
        let Counts {
            pixels,
            seen,
            hidden_without_offset,
        } = in_all_formats(&meshes, pose);
        counts.pixels += pixels;
        counts.seen += seen;
        counts.hidden_without_offset += hidden_without_offset;
    }
    println!("{counts:?}");
    assert!(counts.seen > 1_000 && counts.hidden_without_offset > 20, "{counts:?}");
}
