//! A flight around and through a closed mesh: 1,000 frames in which no pixel is left out or covered twice where faces meet, and
//! a colour that is linear in space has no step at the edges that faces of one plane share, also where faces are cut.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
use fixed::types::I16F16;
use zrow::{
    band::Band,
    geometry::SubPixel,
    scene::{Camera, Deep, Fine, Look, Memory, Model, Pose},
};
use zrow_methods::Random;

use crate::common::by_depth;
use crate::common::meshes::Mesh;
use crate::numbered_scene::{Scene, area, picture};
use crate::shaded_scene::{InSpace, model, words};

const WIDTH: usize = 48;
const HEIGHT: usize = 40;
const FRAMES: usize = 1_000;
/// Frames from one point of the flight to the next.
const STEPS: usize = 20;
/// The distance of the near plane: at this one sides of the ring reach beyond the guard band of 1/16 pixel as well.
const NEAR: i32 = 12;
/// Units of the colour from one pixel to the next, at most: where a plane is seen nearly edge-on, a pixel has many colours.
const MOST_STEP: f64 = 16.0;

/// Where the planes of the mesh's sides lie along each axis.
const PLANES: [&[i16]; 3] = [&[-896, -320, 256, 960], &[-832, -256, 384, 896], &[-320, 384]];

/// A square ring of eight boxes: closed, with a hole through it, each side a plane of several faces.
fn ring() -> Mesh {
    let is_solid = |[x, y, z]: [usize; 3]| x < 3 && y < 3 && z < 1 && [x, y] != [1, 1];
    let mut mesh = Mesh::new(vec![], vec![]);
    let boxes = (0..9).map(|index| [index % 3, index / 3, 0]).filter(|&at| is_solid(at));
    for at in boxes {
        for axis in 0..3 {
            for is_upper in [false, true] {
                let mut beside = at;
                // Of the least one this is `usize::MAX`: not solid.
                beside[axis] = at[axis].wrapping_add(if is_upper { 1 } else { usize::MAX });
                if !is_solid(beside) {
                    add_side(&mut mesh, at, axis, is_upper);
                }
            }
        }
    }
    mesh
}

/// Adds two faces of a box: the second and the third axis run so that they turn clockwise, seen from outside.
fn add_side(mesh: &mut Mesh, at: [usize; 3], axis: usize, is_upper: bool) {
    let [second, third] = [(axis + 1) % 3, (axis + 2) % 3];
    let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[along_second, along_third]| {
        let mut corner = at;
        corner[axis] += usize::from(is_upper);
        corner[second] += along_second;
        corner[third] += along_third;
        let vertex = [0, 1, 2].map(|axis| PLANES[axis][corner[axis]]);
        let known = mesh.vertices.iter().position(|other| *other == vertex);
        known.unwrap_or_else(|| {
            mesh.vertices.push(vertex);
            mesh.vertices.len() - 1
        }) as u16
    });
    let [a, b, c, d] = corners;
    // Seen from the upper side of an axis the other two run clockwise: x to the right and y up, seen from behind.
    let faces = if is_upper {
        [[a, b, c], [a, c, d]]
    } else {
        [[a, c, b], [a, d, c]]
    };
    mesh.faces.extend(faces);
}

/// The colour of a place: whole numbers at the vertices, whose coordinates are multiples of 64.
fn color([x, y, z]: [f64; 3]) -> f64 {
    (5.0 * x + 3.0 * y - 4.0 * z) / 64.0
}

/// One in how many frames is drawn.
fn frames_apart() -> usize {
    by_depth(7, 1, 1)
}

/// Camera after camera, between random points through which the flight goes, each looking at another point near the middle.
fn flight() -> impl Iterator<Item = Camera> {
    let mut random = Random::new(0x0F11_6874);
    let mut point = move |reach: f64| [0; 3].map(|_| random.between(-reach, reach));
    let points: Vec<_> = (0..FRAMES / STEPS + 1)
        .map(|_| [point(1_500.0), point(600.0)])
        .collect();
    let camera = Camera::new(area(WIDTH as u32, HEIGHT as u32), I16F16::from_num(NEAR)).unwrap();
    (0..FRAMES).step_by(frames_apart()).map(move |frame| {
        let part = (frame % STEPS) as f64 / STEPS as f64;
        let [from, to] = [points[frame / STEPS], points[frame / STEPS + 1]];
        let [position, target] = [0, 1].map(|which| {
            [0, 1, 2].map(|axis| I16F16::from_num(from[which][axis] * (1.0 - part) + to[which][axis] * part))
        });
        let up = [[0, 1, 0], [1, 0, 0]].map(|up| up.map(I16F16::from_num::<i32>));
        let looking = |up| camera.look_at(position, target, up);
        looking(up[frame / STEPS % 2])
            .or_else(|_| looking(up[(frame / STEPS + 1) % 2]))
            .unwrap()
    })
}

/// The eye, and the direction in the world in which a camera sees the centre of a pixel.
fn ray(camera: &Camera, column: usize, row: usize) -> [[f64; 3]; 2] {
    let focal_length = camera.focal_length().to_num::<f64>();
    let [x, y] = [
        (column as f64 + 0.5 - WIDTH as f64 / 2.0) / focal_length,
        (HEIGHT as f64 / 2.0 - row as f64 - 0.5) / focal_length,
    ];
    let Pose { rotation, translation } = camera.pose();
    let direction = rotation.matrix().map(|row| {
        let [a, b, c] = row.map(|element| element.to_num::<f64>());
        a * x + b * y + c
    });
    [translation.map(|coordinate| coordinate.to_num::<f64>()), direction]
}

/// The plane of a face, which all three corners share one coordinate of: its axis, and the coordinate.
fn plane(corners: [[i16; 3]; 3]) -> (usize, i16) {
    let [a, b, c] = corners;
    let axis = (0..3).find(|&axis| a[axis] == b[axis] && b[axis] == c[axis]).unwrap();
    (axis, a[axis])
}

/// The colour of a plane across an axis at a pixel.
fn exact(camera: &Camera, (axis, position): (usize, i16), column: usize, row: usize) -> f64 {
    let [eye, direction] = ray(camera, column, row);
    let distance = (f64::from(position) - eye[axis]) / direction[axis];
    color([0, 1, 2].map(|axis| eye[axis] + distance * direction[axis]))
}

/// What the seams of a flight were.
#[derive(Debug, Default)]
struct Seams {
    /// Pairs of neighbouring pixels on both sides of an edge in a plane.
    pairs: usize,
    /// Those of them at faces that reach before the near plane.
    cut: usize,
    /// The largest step, beyond that of the exact colour and what a rounded position makes of it.
    largest: f64,
}

impl Seams {
    /// Adds a frame of colours that are divided in each row at both ends of a span and at each `step`th column, and step evenly
    /// in between: pixels below one another are compared in those columns.
    fn add_frame(
        &mut self,
        mesh: &Mesh,
        camera: &Camera,
        owners: &[Option<usize>],
        numbers: &[u32],
        sub_pixels: f64,
        step: usize,
    ) {
        let corners = |face: usize| mesh.faces[face].map(|vertex| mesh.vertices[usize::from(vertex)]);
        for index in 0..WIDTH * HEIGHT {
            let (column, row) = (index % WIDTH, index / WIDTH);
            let right = (column + 1 < WIDTH).then_some((column + 1, row));
            let below = (row + 1 < HEIGHT && column % step == 0).then_some((column, row + 1));
            for (other_column, other_row) in [right, below].into_iter().flatten() {
                let other = other_row * WIDTH + other_column;
                let (Some(one), Some(two)) = (owners[index], owners[other]) else {
                    continue;
                };
                let shared = mesh.faces[one].iter().filter(|vertex| mesh.faces[two].contains(vertex));
                let plane_of_both = plane(corners(one));
                if one == two || shared.count() < 2 || plane(corners(two)) != plane_of_both {
                    continue;
                }
                let drawn = |index: usize| f64::from(numbers[index] as i32) / 65_536.0;
                let there = exact(camera, plane_of_both, other_column, other_row);
                let step = there - exact(camera, plane_of_both, column, row);
                if step.abs() > MOST_STEP {
                    continue;
                }
                let error = (drawn(other) - drawn(index) - step).abs() - step.abs() / sub_pixels;
                self.pairs += 1;
                self.cut += usize::from([one, two].iter().any(|&face| is_cut(camera, corners(face))));
                self.largest = self.largest.max(error);
            }
        }
    }
}

/// Whether a face reaches before the near plane.
fn is_cut(camera: &Camera, corners: [[i16; 3]; 3]) -> bool {
    let Pose { rotation, translation } = camera.pose();
    corners.iter().any(|corner| {
        let along = (0..3).map(|axis| {
            (f64::from(corner[axis]) - translation[axis].to_num::<f64>()) * rotation.matrix()[axis][2].to_num::<f64>()
        });
        along.sum::<f64>() < f64::from(NEAR)
    })
}

/// Flies, and checks each frame. The colours of `N` are divided at each `STEP`th column.
fn fly<N, O, const STEP: i32>() -> Seams
where
    N: Look<Color = Rgb888, Shading = InSpace<1, 0, STEP>>,
    O: Look<Color = Rgb888, Shading = Rgb888>,
{
    let mesh = ring();
    let numbers: Vec<[i16; 1]> = mesh
        .vertices
        .iter()
        .map(|vertex| [color(vertex.map(f64::from)) as i16])
        .collect();
    let scene = Scene::new(vec![mesh.clone()]);
    // Each face alone, and what is behind it: the front has number 1, the back 2.
    let alone: Vec<Scene> = mesh
        .faces
        .iter()
        .map(|face| Scene::new(vec![Mesh::new(mesh.vertices.clone(), vec![*face]).two_sided()]))
        .collect();
    let mut memory = Box::new(Memory::<O, 1_000, 64, WIDTH, HEIGHT, 64>::new());
    let mut shaded_memory = Box::new(Memory::<N, 1_000, 64, WIDTH, HEIGHT, 64>::new());
    let mut single = Box::new(Memory::<O, 100, 2, WIDTH, HEIGHT, 8>::new());
    let area = area(WIDTH as u32, HEIGHT as u32);
    let mut seams = Seams::default();
    for (frame, camera) in flight().enumerate() {
        let owners = picture(
            &mut memory.prepare(&camera, &scene.models(Pose::IDENTITY)).unwrap(),
            area,
        );
        let models = [model::<InSpace<1, 0, STEP>, 1>(&mesh, &numbers, 0)];
        let colors = words(&mut shaded_memory.prepare(&camera, &models).unwrap(), area);
        seams.add_frame(
            &mesh,
            &camera,
            &owners,
            &colors,
            f64::from(1 << O::Precision::FRACTION_BITS),
            STEP as usize,
        );

        let mut balance = vec![[0i32; 2]; WIDTH * HEIGHT];
        for one in &alone {
            let models: Vec<Model<'_, Rgb888>> = one.models(Pose::IDENTITY);
            let mut prepared = single.prepare(&camera, &models).unwrap();
            let mut words = [0; WIDTH * HEIGHT];
            prepared.draw(&mut Band::<Rgb888>::new(area, &mut words).unwrap());
            for (balance, word) in balance.iter_mut().zip(words).filter(|(_, word)| *word > 0) {
                balance[word as usize - 1] += 1;
            }
        }
        for (index, ([front, back], owner)) in balance.iter().zip(owners).enumerate() {
            let place = Point::new((index % WIDTH) as i32, (index / WIDTH) as i32);
            assert!(
                [0, -1].contains(&(front - back)),
                "frame {frame} at {place}: {front} fronts and {back} backs"
            );
            assert_eq!(owner.is_some(), *front > 0, "frame {frame} at {place}");
        }
    }
    seams
}

#[test]
fn a_flight_at_sixteenths_has_no_seam() {
    let seams = fly::<InSpace<1>, Rgb888, 16>();
    assert!(
        seams.pairs > 70_000 / frames_apart() && seams.cut > 5_000 / frames_apart() && seams.largest <= 1.0,
        "{seams:?}"
    );
}

#[test]
fn a_flight_at_256ths_has_no_seam() {
    let seams = fly::<Fine<Deep<InSpace<1>>>, Fine<Deep<Rgb888>>, 16>();
    assert!(
        seams.pairs > 70_000 / frames_apart() && seams.cut > 5_000 / frames_apart() && seams.largest <= 1.0,
        "{seams:?}"
    );
}

/// Where a colour is divided at each pixel, there is no step to the pixel below in any column.
#[test]
fn a_flight_that_is_divided_at_each_pixel_has_no_seam() {
    let seams = fly::<Fine<Deep<InSpace<1, 0, 1>>>, Fine<Deep<Rgb888>>, 1>();
    assert!(
        seams.pairs > 130_000 / frames_apart() && seams.cut > 10_000 / frames_apart() && seams.largest <= 1.0,
        "{seams:?}"
    );
}
