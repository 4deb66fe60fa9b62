//! Polygons in the rows of a scene, against winding numbers and planes of each pixel in `i128`: rays are parallel and
//! a unit of space is one of the screen there, so that corners and depths are known without the library.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I8F24, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::Band,
    geometry::TooSmall,
    scan::FillRule,
    scene::{Camera, FaceSet, Memory, Model, Orthographic, Pose, Prepared, Rotation},
    visible::{DepthPolygon, DepthState},
};

use crate::common::{cases, config};

const WIDTH: usize = 48;
const HEIGHT: usize = 40;
const FAR: i32 = 128 + (1 << 14);
const COLORS: [Rgb888; 3] = [Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE];

type Contour = Vec<[i16; 2]>;

fn area() -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32))
}

/// A sixteenth of a pixel a unit, and four units of depth.
fn parallel_camera() -> Camera {
    Camera::new(area(), I16F16::from_num(128))
        .and_then(|camera| camera.with_far(I16F16::from_num(FAR)))
        .and_then(|camera| camera.with_scale(I8F24::from_num(1.0 / 16.0)))
        .unwrap()
}

/// A plane in space: z of the centre, and what it gains by x and y.
#[derive(Debug, Copy, Clone)]
struct Plane([i32; 3]);

impl Plane {
    fn z(self, [x, y]: [i32; 2]) -> i32 {
        let Self([z, by_x, by_y]) = self;
        z + by_x * x + by_y * y
    }

    fn corners(self, contour: &[[i16; 2]]) -> Vec<[i16; 3]> {
        let corner = |&[x, y]: &[i16; 2]| [x, y, self.z([x.into(), y.into()]) as i16];
        contour.iter().map(corner).collect()
    }
}

/// Where the centre of a pixel is in space.
fn centre(x: usize, y: usize) -> [i32; 2] {
    [
        16 * x as i32 - 8 * (WIDTH as i32 - 1),
        8 * (HEIGHT as i32 - 1) - 16 * y as i32,
    ]
}

/// The winding number of a point; one on an edge counts as right of it, and one on a level edge as below it.
fn winding(contours: &[Contour], [x, y]: [i32; 2]) -> i32 {
    let mut winding = 0;
    for contour in contours {
        for (index, &from) in contour.iter().enumerate() {
            let to = contour[(index + 1) % contour.len()];
            // On the screen y grows downwards.
            let [[x0, y0], [x1, y1], [x, y]] =
                [from.map(i32::from), to.map(i32::from), [x, y]].map(|[x, y]| [i128::from(x), -i128::from(y)]);
            let (top, bottom, direction) = if y0 < y1 {
                ([x0, y0], [x1, y1], 1)
            } else {
                ([x1, y1], [x0, y0], -1)
            };
            let is_crossed = top[1] <= y && y < bottom[1];
            if is_crossed && (x - top[0]) * (bottom[1] - top[1]) >= (y - top[1]) * (bottom[0] - top[0]) {
                winding += direction;
            }
        }
    }
    winding
}

/// How far a point is from a segment.
fn distance([x, y]: [f64; 2], segment: [[i16; 2]; 2]) -> f64 {
    let [[x0, y0], [x1, y1]] = segment.map(|end| end.map(f64::from));
    let ([dx, dy], [px, py]) = ([x1 - x0, y1 - y0], [x - x0, y - y0]);
    let along = ((px * dx + py * dy) / (dx * dx + dy * dy).max(1.0)).clamp(0.0, 1.0);
    (px - along * dx).hypot(py - along * dy)
}

/// Rows of the picture, in an order and in bands of a height, each drawn by the closure.
fn draw<L: zrow::scene::Look<Color = Rgb888, Shading = Rgb888, Depth = u16>, const N: usize, const M: usize>(
    prepared: &mut Prepared<'_, '_, L>,
    (polygons, others): (&mut [DepthPolygon<u16, N>], &mut [DepthPolygon<u16, M>]),
    tops: &[usize],
    height: usize,
) -> Vec<(u32, u16)> {
    let mut picture = vec![(0, 0); WIDTH * HEIGHT];
    for &top in tops {
        let part = Rectangle::new(Point::new(0, top as i32), Size::new(WIDTH as u32, height as u32));
        let mut words = vec![0; WIDTH * height];
        let mut band = Band::<Rgb888>::new(part, &mut words).unwrap();
        prepared.draw_with(&mut band, |row| {
            for (polygon, color) in polygons.iter_mut().zip(&COLORS[1..]) {
                row.draw_polygon(polygon, *color, &DepthState::NEARER);
            }
            for polygon in others.iter_mut() {
                row.draw_polygon(polygon, Rgb888::WHITE, &DepthState::NEARER);
            }
            let first = row.y() as usize * WIDTH;
            for (pixel, depth) in picture[first..].iter_mut().zip(row.depths()) {
                pixel.1 = *depth;
            }
        });
        for (pixel, word) in picture[top * WIDTH..].iter_mut().zip(words) {
            pixel.0 = word;
        }
    }
    picture
}

fn coordinate() -> impl Strategy<Value = i16> {
    prop_oneof![
        -420i16..420,
        (-50i16..50).prop_map(|pixel| 8 * pixel),
        -1_000i16..1_000,
        (-4i16..4).prop_map(|x| 100 * x)
    ]
}

fn plane() -> impl Strategy<Value = Plane> {
    [8_200..8_400, -3..4, -3..4].prop_map(Plane)
}

fn contour(most: usize) -> impl Strategy<Value = Contour> {
    prop::collection::vec([coordinate(), coordinate()], 0..most)
}

proptest! {
    #![proptest_config(config(cases(300, 20_000)))]

    /// Two polygons that may penetrate each other, and a face of the scene: each pixel has the owner and the depth of the exact
    /// planes, in bands of any height and in any order of rows.
    #[test]
    fn owners_and_depths_are_exact(
        face in prop::array::uniform3([coordinate(), coordinate()]),
        contours in prop::array::uniform2(prop::collection::vec(contour(9), 1..4)),
        planes in prop::array::uniform3(plane()),
        is_even_odd in any::<bool>(),
        shuffle in 1usize..40,
    ) {
        let camera = parallel_camera();
        let vertices = planes[0].corners(&face);
        let colors = [COLORS[0]];
        let mesh = FaceSet::new(&vertices, &[[0, 1, 2]]).unwrap();
        let models = [Model::new(mesh, &colors).unwrap()];
        let mut memory = Memory::<Orthographic<Rgb888>, 12, 4, WIDTH, HEIGHT>::new();
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        let rule = if is_even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let mut polygons = [DepthPolygon::<u16, 24>::new(), DepthPolygon::new()];
        for ((polygon, contours), plane) in polygons.iter_mut().zip(&contours).zip(&planes[1..]) {
            let corners: Vec<_> = contours.iter().map(|contour| plane.corners(contour)).collect();
            let corners: Vec<&[_]> = corners.iter().map(Vec::as_slice).collect();
            prepared.prepare_polygon(polygon, &Pose::IDENTITY, &corners, rule).unwrap();
        }
        let mut expected = Vec::new();
        for pixel in 0..WIDTH * HEIGHT {
            let point = centre(pixel % WIDTH, pixel / WIDTH);
            let depth = |plane: Plane| (4 * (FAR - plane.z(point)) + 1) as u16;
            let mut owner = (0, 0);
            // Clockwise on the screen: seen from the front.
            if winding(&[face.to_vec()], point) != 0 {
                let [a, b, c] = face.map(|corner| corner.map(i32::from));
                let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
                if area < 0 {
                    owner = (COLORS[0].into_storage(), depth(planes[0]));
                }
            }
            for ((contours, plane), color) in contours.iter().zip(&planes[1..]).zip(&COLORS[1..]) {
                if rule.includes(winding(contours, point)) && depth(*plane) > owner.1 {
                    owner = (color.into_storage(), depth(*plane));
                }
            }
            expected.push(owner);
        }
        let downwards: Vec<usize> = (0..HEIGHT).collect();
        let upwards: Vec<usize> = (0..HEIGHT).rev().collect();
        let mixed: Vec<usize> = (0..HEIGHT).map(|row| (row * 7 + shuffle) % HEIGHT).collect();
        let none: &mut [DepthPolygon<u16, 0>] = &mut [];
        for (tops, height) in [(&[0][..], HEIGHT), (&downwards, 1), (&upwards, 1), (&mixed, 1), (&downwards, 1)] {
            let drawn = draw(&mut prepared, (&mut polygons, &mut *none), tops, height);
            let differing = drawn.iter().zip(&expected).filter(|(drawn, expected)| drawn != expected).count();
            prop_assert_eq!(differing, 0, "height {} of {:?}", height, tops);
        }
    }

    /// A concave polygon in perspective has the pixels of its triangles, and the depths but for what rounded corners do to planes.
    ///
    /// A corner is wrong by half a unit of depth, and by half of 1/16 pixel along both axes, together by `e`. In a triangle no
    /// pixel is wrong by more. The three far corners of a polygon have weights 4, 2 and 1 at most at a pixel inside: the third
    /// one is as far as any from the line through the others, and of those the second one is as far as any from the first. So
    /// the planes differ by `8 * e`, and by 1/6 unit each for their own rounding; both are rounded down to units.
    #[test]
    fn triangles_are_the_same_but_for_rounded_corners(angles in prop::array::uniform3(-3_000i32..3_000), distance in 700i32..3_000) {
        const CORNERS: [[i16; 3]; 6] = [[-300, -300, 0], [-300, 300, 0], [0, 300, 0], [0, 0, 0], [300, 0, 0], [300, -300, 0]];
        const FACES: [[u16; 3]; 4] = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
        let [a, b, c] = angles.map(|angle| U0F16::from_bits(angle as u16));
        let rotation = Rotation::about_x(a).then(&Rotation::about_y(b)).then(&Rotation::about_z(c));
        let pose = Pose::new(rotation, [0, 0, distance].map(I16F16::from_num));
        let camera = Camera::new(area(), I16F16::from_num(48)).unwrap();
        let models = [Model::new(FaceSet::new(&CORNERS, &FACES).unwrap(), &[Rgb888::GREEN; 4]).unwrap().with_pose(pose)];
        let mut memory = Memory::<Rgb888, 30, 10, WIDTH, HEIGHT>::new();
        let mut as_faces = memory.prepare(&camera, &models).unwrap();
        let none: &mut [DepthPolygon<u16, 0>] = &mut [];
        let expected = draw(&mut as_faces, (&mut [] as &mut [DepthPolygon<u16, 8>], &mut *none), &[0], HEIGHT);
        let mut memory = Memory::<Rgb888, 0, 0, WIDTH, HEIGHT>::new();
        let mut empty = memory.prepare(&camera, &[]).unwrap();
        let mut polygons = [DepthPolygon::<u16, 8>::new()];
        empty.prepare_polygon(&mut polygons[0], &pose, &[&CORNERS], FillRule::EvenOdd).unwrap();
        let drawn = draw(&mut empty, (&mut polygons, none), &[0], HEIGHT);
        let most = |step: usize| {
            let pairs = drawn.iter().zip(&drawn[step..]).filter(|(one, other)| one.0 != 0 && other.0 != 0);
            // Both are rounded down to units.
            pairs.map(|(one, other)| one.1.abs_diff(other.1) + 1).max().unwrap_or(0)
        };
        let slope = f64::from(most(1)) + f64::from(most(WIDTH));
        let bound = 8.0 * (0.5 + slope / 32.0) + 1.0 / 3.0 + 1.0;
        for (drawn, expected) in drawn.iter().zip(&expected) {
            prop_assert_eq!(drawn.0, expected.0);
            prop_assert!(f64::from(drawn.1.abs_diff(expected.1)) < bound, "{:?} for {:?}, {}", drawn, expected, bound);
        }
    }

    /// Polygons through the near plane, around the camera and far beyond the screen have the pixels of the points in space that
    /// rays through the pixels meet, but for those close to an edge.
    #[test]
    fn cut_polygons_are_what_rays_meet(
        contour in prop::collection::vec([-20_000i16..20_000, -20_000i16..20_000], 3..8),
        height in 20i16..800,
    ) {
        // On a floor below the camera: (x, z).
        let corners: Vec<[i16; 3]> = contour.iter().map(|&[x, z]| [x, -height, z]).collect();
        let camera = Camera::new(area(), I16F16::from_num(24)).unwrap();
        let mut memory = Memory::<Rgb888, 0, 0, WIDTH, HEIGHT>::new();
        let mut scene = memory.prepare(&camera, &[]).unwrap();
        let mut polygons = [DepthPolygon::<u16, 24>::new()];
        scene.prepare_polygon(&mut polygons[0], &Pose::IDENTITY, &[&corners], FillRule::NonZero).unwrap();
        let none: &mut [DepthPolygon<u16, 0>] = &mut [];
        let drawn = draw(&mut scene, (&mut polygons, none), &[0], HEIGHT);
        for (pixel, drawn) in drawn.iter().enumerate() {
            let inside = |shift_x: f64, shift_y: f64| {
                let x = (pixel % WIDTH) as f64 - 23.5 + shift_x;
                let down = (pixel / WIDTH) as f64 - 19.5 + shift_y;
                let z = f64::from(height) * 24.0 / down;
                down > 0.0 && z >= f64::from(camera.near().to_num::<f32>()) && {
                    let point = [(x * z / 24.0) as i32, z as i32];
                    point.iter().all(|part| part.abs() < 1 << 20) && winding(std::slice::from_ref(&contour), point) != 0
                }
            };
            let down = (pixel / WIDTH) as f64 - 19.5;
            let z = f64::from(height) * 24.0 / down;
            let point = [((pixel % WIDTH) as f64 - 23.5) * z / 24.0, z];
            // Half a pixel to the right and down is less far than that; numbers are rounded as well.
            let margin = 0.7 * z / 24.0 * (1.0 + f64::from(height) / down).max(1.0) + 2.0;
            let is_clear = (0..contour.len()).all(|index| {
                distance(point, [contour[index], contour[(index + 1) % contour.len()]]) > margin
            });
            if is_clear && down > 2.0 && (z - camera.near().to_num::<f64>()).abs() > margin {
                prop_assert_eq!(drawn.0 != 0, inside(0.0, 0.0), "{} {}", pixel % WIDTH, pixel / WIDTH);
            }
        }
    }
}

/// A wall far larger than the guard band that surrounds the viewport has all its pixels.
#[test]
fn a_wall_around_the_viewport_is_drawn() {
    const WALL: [[i16; 3]; 4] = [
        [-32_000, -32_000, 200],
        [-32_000, 32_000, 200],
        [32_000, 32_000, 200],
        [32_000, -32_000, 200],
    ];
    let camera = Camera::new(area(), I16F16::from_num(48)).unwrap();
    let mut memory = Memory::<Rgb888, 0, 0, WIDTH, HEIGHT>::new();
    let mut scene = memory.prepare(&camera, &[]).unwrap();
    let mut polygons = [DepthPolygon::<u16, 2>::new()];
    scene
        .prepare_polygon(&mut polygons[0], &Pose::IDENTITY, &[&WALL], FillRule::EvenOdd)
        .unwrap();
    let none: &mut [DepthPolygon<u16, 0>] = &mut [];
    let drawn = draw(&mut scene, (&mut polygons, none), &[0], HEIGHT);
    assert!(
        drawn
            .iter()
            .all(|pixel| *pixel == (Rgb888::GREEN.into_storage(), drawn[0].1))
    );
}

/// A bow tie, whose halves cancel in a sum of areas, is drawn by both rules; collinear corners have no pixels, and too small
/// a table says what would do and leaves nothing.
#[test]
fn capacities_and_degenerate_polygons() {
    const BOW_TIE: [[i16; 3]; 4] = [
        [-300, -300, 1_000],
        [300, 300, 1_000],
        [300, -300, 1_000],
        [-300, 300, 1_000],
    ];
    const LINE: [[i16; 3]; 3] = [[-300, -300, 1_000], [300, 300, 1_200], [0, 0, 1_100]];
    let camera = parallel_camera();
    let mut memory = Memory::<Orthographic<Rgb888>, 0, 0, WIDTH, HEIGHT>::new();
    let mut scene = memory.prepare(&camera, &[]).unwrap();
    let mut polygons = [DepthPolygon::<u16, 4>::new()];
    let mut shown = |contours: &[&[[i16; 3]]]| {
        scene
            .prepare_polygon(&mut polygons[0], &Pose::IDENTITY, contours, FillRule::NonZero)
            .unwrap();
        let none: &mut [DepthPolygon<u16, 0>] = &mut [];
        let drawn = draw(&mut scene, (&mut polygons, none), &[0], HEIGHT);
        drawn.iter().filter(|pixel| pixel.0 != 0).count()
    };
    assert!(shown(&[&BOW_TIE]) > 600);
    assert_eq!(
        (shown(&[&LINE]), shown(&[]), shown(&[&[]]), shown(&[&BOW_TIE[..1]])),
        (0, 0, 0, 0)
    );
    fn needed<const N: usize>(scene: &Prepared<'_, '_, Orthographic<Rgb888>>) -> Result<(), TooSmall> {
        let mut polygon = DepthPolygon::<u16, N>::new();
        scene.prepare_polygon(&mut polygon, &Pose::IDENTITY, &[&BOW_TIE], FillRule::EvenOdd)
    }
    let few = [needed::<0>(&scene), needed::<1>(&scene), needed::<3>(&scene)];
    assert_eq!(few, [Err(TooSmall::Edges(4)); 3]);
    assert_eq!(needed::<4>(&scene), Ok(()));
}
