//! Antialiased silhouettes against the exact area of the faces in each pixel, and against the same scenes without.

use embedded_graphics::{
    pixelcolor::{Gray8, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::{I8F24, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::Band,
    geometry::SubPixel,
    scene::{
        Affine, Antialiased, Camera, Deep, DoubleSided, FaceSet, Fine, Look, Memory, Model, OnePass, Orthographic,
        Pose, Prepared, Rotation, Whole,
    },
    shade::{Gouraud, GouraudSkin, Lambert, Shading, Transformed, Translucent},
};

use crate::common::meshes::{Mesh, cube, icosphere, torus};
use crate::common::{cases, config};
use crate::numbered_scene::area;
use crate::random_faces::{faces, pose};
use crate::snapped_faces::{at, camera, snapped};

const WIDTH: u32 = 64;
const HEIGHT: u32 = 64;
type Many<L> = Memory<L, 2_000, 1_000, 64, 64, 200>;
type One<L> = Memory<L, 2_000, 1_000, 64, 64, 1>;

/// The neighbours of faces by looking at all pairs of edges.
pub fn neighbours(faces: &[[u16; 3]]) -> Vec<[u16; 3]> {
    let edges = |face: [u16; 3]| [(face[0], face[1]), (face[1], face[2]), (face[2], face[0])];
    let across = |(from, to): (u16, u16)| {
        let with = |edge: (u16, u16)| -> Vec<usize> {
            (0..faces.len())
                .flat_map(|index| vec![index; edges(faces[index]).iter().filter(|other| **other == edge).count()])
                .collect()
        };
        match (&with((from, to))[..], &with((to, from))[..]) {
            ([_], [other]) => *other as u16,
            _ => FaceSet::NO_NEIGHBOUR,
        }
    };
    faces.iter().map(|face| edges(*face).map(across)).collect()
}

/// A mesh with its neighbours.
pub struct Surface {
    pub mesh: Mesh,
    neighbours: Vec<[u16; 3]>,
}

impl Surface {
    pub fn new(mesh: Mesh) -> Self {
        let neighbours = neighbours(&mesh.faces);
        Self { mesh, neighbours }
    }

    pub fn face_set(&self) -> FaceSet<'_> {
        self.mesh.face_set().with_neighbours(&self.neighbours)
    }
}

/// What is in the band before the scene is drawn.
pub fn background(point: Point) -> Rgb888 {
    let number = (point.x * 71 + point.y * 137) as u32;
    Rgb888::new(number as u8, (number / 3) as u8, (number * 5) as u8)
}

/// Draws a scene over the background in bands, from the top or from the bottom.
fn drawn<L: Look<Color = Rgb888>>(prepared: &mut Prepared<'_, '_, L>, height: u32, downwards: bool) -> Vec<Rgb888> {
    let whole = area(WIDTH, HEIGHT);
    let mut picture: Vec<_> = whole.points().map(background).collect();
    let mut tops: Vec<_> = (0..HEIGHT).step_by(height as usize).collect();
    if !downwards {
        tops.reverse();
    }
    for top in tops {
        let height = height.min(HEIGHT - top);
        let part = Rectangle::new(Point::new(0, top as i32), Size::new(WIDTH, height));
        let range = (top * WIDTH) as usize..((top + height) * WIDTH) as usize;
        let mut words: Vec<u32> = picture[range.clone()]
            .iter()
            .map(|color| color.into_storage())
            .collect();
        let mut band = Band::<Rgb888>::new(part, &mut words).unwrap();
        prepared.draw(&mut band);
        let colors: Vec<_> = band.colors().collect();
        picture[range].copy_from_slice(&colors);
    }
    picture
}

/// The area of a triangle within a pixel, whose corners are in pixels: cut at each side of the pixel.
fn area_within(triangle: [[f64; 2]; 3], pixel: Point) -> f64 {
    let mut polygon = triangle.to_vec();
    let sides = [
        (0, 1.0, f64::from(pixel.x) - 0.5),
        (0, -1.0, -f64::from(pixel.x) - 0.5),
        (1, 1.0, f64::from(pixel.y) - 0.5),
        (1, -1.0, -f64::from(pixel.y) - 0.5),
    ];
    for (axis, sign, limit) in sides {
        let inside = |corner: [f64; 2]| sign * corner[axis] - limit;
        let mut cut = Vec::new();
        for (index, from) in polygon.iter().enumerate() {
            let to = polygon[(index + 1) % polygon.len()];
            let (one, other) = (inside(*from), inside(to));
            if one >= 0.0 {
                cut.push(*from);
            }
            if (one < 0.0) != (other < 0.0) {
                let part = one / (one - other);
                cut.push([0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part));
            }
        }
        polygon = cut;
    }
    let corners = polygon.iter().zip(polygon.iter().cycle().skip(1));
    corners.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>() / 2.0
}

/// The area of each pixel that the faces of some orders cover which are seen from the front, or from any side.
pub fn coverage<L: Look>(prepared: &Prepared<'_, '_, L>, orders: std::ops::Range<usize>, backs: bool) -> Vec<f64> {
    let unit = f64::from(1 << L::Precision::FRACTION_BITS);
    let mut areas = vec![0.0; (WIDTH * HEIGHT) as usize];
    for face in snapped(prepared) {
        if !orders.contains(&face.order) {
            continue;
        }
        let triangle = face.corners.map(|[x, y, _]| [x as f64 / unit, y as f64 / unit]);
        let [a, b, c] = triangle;
        let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        if doubled <= 0.0 && !backs {
            continue;
        }
        let ends = |axis: usize, most: u32| {
            let least = a[axis].min(b[axis]).min(c[axis]).round().max(0.0) as i32;
            let greatest = a[axis].max(b[axis]).max(c[axis]).round().min(f64::from(most) - 1.0) as i32;
            least..=greatest
        };
        for y in ends(1, HEIGHT) {
            for x in ends(0, WIDTH) {
                areas[(y * WIDTH as i32 + x) as usize] += area_within(triangle, Point::new(x, y)).abs();
            }
        }
    }
    areas
}

pub fn mixed(over: Rgb888, below: Rgb888, part: f64) -> [f64; 3] {
    let channels = |color: Rgb888| [color.r(), color.g(), color.b()].map(f64::from);
    let (over, below) = (channels(over), channels(below));
    [0, 1, 2].map(|channel| below[channel] + (over[channel] - below[channel]) * part)
}

pub fn difference(found: Rgb888, expected: [f64; 3]) -> f64 {
    let found = [found.r(), found.g(), found.b()].map(f64::from);
    (0..3)
        .map(|channel| (found[channel] - expected[channel]).abs())
        .fold(0.0, f64::max)
}

/// Levels by which a pixel of a silhouette may be off: 1/255 by rounding the coverage, half a level by mixing, and what edges
/// that are rounded to 1/8192 pixel miss.
pub const OFF: f64 = 1.6;

pub const COLORS: [Rgb888; 3] = [Rgb888::WHITE, Rgb888::new(255, 60, 0), Rgb888::new(0, 90, 255)];

/// Draws convex bodies, the nearest first, in one colour each. Returns how many pixels lie on one silhouette, and on several.
fn check<L: Look<Color = Rgb888, Shading = Rgb888>>(meshes: &[Mesh], poses: &[Pose]) -> [usize; 2]
where
    Antialiased<L>: Look<Color = Rgb888, Shading = Rgb888, Precision = L::Precision>,
{
    let whole = area(WIDTH, HEIGHT);
    let camera = camera(whole);
    let surfaces: Vec<_> = meshes.iter().cloned().map(Surface::new).collect();
    let colors: Vec<_> = COLORS.iter().map(|color| vec![*color; 1_000]).collect();
    let model = |index: usize| {
        Model::new(surfaces[index].face_set(), &colors[index])
            .unwrap()
            .with_pose(poses[index])
    };
    let models: Vec<_> = (0..meshes.len()).map(model).collect();
    let mut memory = Box::new(Many::<Antialiased<L>>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut first = 0;
    let parts: Vec<_> = meshes
        .iter()
        .map(|mesh| {
            first += mesh.faces.len();
            coverage(&prepared, first - mesh.faces.len()..first, false)
        })
        .collect();
    let picture = drawn(&mut prepared, HEIGHT, true);
    let (mut on_one, mut on_several) = (0, 0);
    for (index, point) in whole.points().enumerate() {
        let is_partial = |part: &&Vec<f64>| (1e-9..1.0 - 1e-9).contains(&part[index]);
        match parts.iter().filter(is_partial).count() {
            2.. => {
                on_several += 1;
                continue;
            }
            count => on_one += count,
        }
        let mut expected = mixed(background(point), background(point), 1.0);
        for (part, color) in parts.iter().zip(COLORS).rev() {
            for (channel, level) in expected.iter_mut().enumerate() {
                *level += (mixed(color, color, 1.0)[channel] - *level) * part[index].min(1.0);
            }
        }
        let off = difference(picture[index], expected);
        assert!(
            off < OFF,
            "{point:?}: {:?}, {expected:?}, off by {off}, parts {:?}, before {:?}, {}",
            picture[index],
            parts.iter().map(|part| part[index]).collect::<Vec<_>>(),
            background(point),
            std::any::type_name::<L>()
        );
    }
    [on_one, on_several]
}

/// Bodies one behind the other; behind them may be one that fills the picture.
fn bodies() -> impl Strategy<Value = (Vec<Mesh>, Vec<Pose>)> {
    let body =
        (0..3usize, pose(0..1)).prop_map(|(kind, pose)| ([cube(0.4), icosphere(0.45), cube(0.2)][kind].clone(), pose));
    (prop::collection::vec(body, 1..=2), any::<bool>()).prop_map(|(bodies, has_wall)| {
        let (mut meshes, mut poses): (Vec<_>, Vec<_>) = bodies.into_iter().unzip();
        for (pose, index) in poses.iter_mut().zip(0..) {
            pose.translation[2] = I16F16::from_num(1_100 + 900 * index);
        }
        if has_wall {
            meshes.push(cube(4.0));
            poses.push(Pose::new(Rotation::IDENTITY, at(0, 0, 6_000)));
        }
        (meshes, poses)
    })
}

proptest! {
    #![proptest_config(config(cases(12, 300)))]

    #[test]
    fn silhouettes_of_convex_bodies_cover_their_exact_area((meshes, poses) in bodies()) {
        let [on_one, on_several] = check::<Rgb888>(&meshes, &poses);
        prop_assert!(on_one > 10 && on_several < on_one, "{on_one} on one, {on_several} on several");
        check::<Fine<Rgb888>>(&meshes, &poses);
        check::<Deep<Rgb888>>(&meshes, &poses);
        check::<OnePass<Whole<Rgb888>>>(&meshes, &poses);
    }
}

/// A triangle that faces the camera, with an edge through the middle of the picture: up to 64,000 units wide and as high.
fn large_triangle() -> impl Strategy<Value = Mesh> {
    let coordinates = |most: i16| prop::array::uniform2(-most..=most);
    // Neither level nor vertical: such an edge may lie between two pixels.
    let away =
        prop::array::uniform2((1_000..=32_000i16, any::<bool>()).prop_map(|(far, back)| if back { -far } else { far }));
    (coordinates(200), away, 1..=100, coordinates(32_000)).prop_map(|(middle, away, percent, third)| {
        let from = [0, 1].map(|axis| middle[axis] - away[axis]);
        let to = [0, 1].map(|axis| middle[axis] + (i32::from(away[axis]) * percent / 100) as i16);
        let corners = [from, to, third].map(|[x, y]| [x, y, 0]);
        Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).two_sided()
    })
}

proptest! {
    #![proptest_config(config(cases(40, 2_000)))]

    /// Edges of up to 4,000 pixels on either side of the picture, or, at 1/16 pixel, up to 900: the guard band cuts none.
    #[test]
    fn silhouettes_of_large_faces_cover_their_exact_area(mesh in large_triangle()) {
        let poses = |z| [Pose::new(Rotation::IDENTITY, at(0, 0, z))];
        let meshes = [mesh];
        let [fine, _] = check::<Fine<Rgb888>>(&meshes, &poses(256));
        let [coarse, _] = check::<Rgb888>(&meshes, &poses(1_100));
        prop_assert!(fine > 10 && coarse > 10, "{fine} and {coarse} pixels");
        check::<Fine<Deep<Rgb888>>>(&meshes, &poses(1_100));
    }
}

/// Draws models in a look without and with antialiased silhouettes; each picture in several ways that must not change it.
/// Returns both.
fn both_pictures<L: Look<Color = Rgb888>>(camera: &Camera, models: &[Model<'_, L::Shading>]) -> [Vec<Rgb888>; 2]
where
    Antialiased<L>: Look<Color = Rgb888, Shading = L::Shading>,
{
    let (mut plain, mut many) = (Box::new(Many::<L>::new()), Box::new(Many::<Antialiased<L>>::new()));
    let aliased = drawn(&mut plain.prepare(camera, models).unwrap(), HEIGHT, true);
    let mut prepared = many.prepare(camera, models).unwrap();
    let picture = drawn(&mut prepared, HEIGHT, true);
    for (height, downwards) in [(1, true), (1, false), (7, true), (5, false), (64, true)] {
        let other = drawn(&mut prepared, height, downwards);
        assert!(other == picture, "in bands of {height} rows, downwards: {downwards}");
    }
    // In windows of some columns, which are fewer than there is memory for.
    for left in (0..WIDTH).step_by(13) {
        let part = Rectangle::new(Point::new(left as i32, 0), Size::new(13.min(WIDTH - left), HEIGHT));
        let mut words: Vec<u32> = part.points().map(|point| background(point).into_storage()).collect();
        let mut band = Band::<Rgb888>::new(part, &mut words).unwrap();
        prepared.draw(&mut band);
        for (point, color) in part.points().zip(band.colors()) {
            assert_eq!(color, at_point(&picture, point), "{point:?} in columns from {left} on");
        }
    }
    if L::DRAWS_IN_PASSES {
        let mut one = Box::new(One::<Antialiased<L>>::new());
        let mut prepared = one.prepare(camera, models).unwrap();
        assert!(drawn(&mut prepared, 3, true) == picture, "with one slot");
    }
    [aliased, picture]
}

/// The pixels that an edge of some face passes through, also where it only touches a corner.
pub fn on_edges<L: Look>(prepared: &Prepared<'_, '_, L>) -> Vec<bool> {
    let unit = f64::from(1 << L::Precision::FRACTION_BITS);
    let mut passed = vec![false; (WIDTH * HEIGHT) as usize];
    for face in snapped(prepared) {
        let corners = face.corners.map(|[x, y, _]| [x as f64 / unit, y as f64 / unit]);
        for (from, to) in [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (corners[from], corners[to])) {
            for (pixel, point) in passed.iter_mut().zip(area(WIDTH, HEIGHT).points()) {
                *pixel |= touches(from, to, point);
            }
        }
    }
    passed
}

/// Whether a segment touches a pixel.
fn touches(from: [f64; 2], to: [f64; 2], pixel: Point) -> bool {
    let center = [f64::from(pixel.x), f64::from(pixel.y)];
    let (mut start, mut end) = (0.0f64, 1.0f64);
    for axis in 0..2 {
        let (least, most) = (center[axis] - 0.500_1, center[axis] + 0.500_1);
        let change = to[axis] - from[axis];
        if change == 0.0 {
            if from[axis] < least || from[axis] > most {
                return false;
            }
            continue;
        }
        let cuts = [(least - from[axis]) / change, (most - from[axis]) / change];
        start = start.max(cuts[0].min(cuts[1]));
        end = end.min(cuts[0].max(cuts[1]));
    }
    start <= end
}

/// Whatever models there are: pixels that no edge passes through are as without.
fn only_edges_change<L: Look<Color = Rgb888>>(camera: &Camera, models: &[Model<'_, L::Shading>]) -> usize
where
    Antialiased<L>: Look<Color = Rgb888, Shading = L::Shading>,
{
    let [aliased, picture] = both_pictures::<L>(camera, models);
    let mut memory = Box::new(Many::<L>::new());
    let passed = on_edges(&memory.prepare(camera, models).unwrap());
    let mut changed = 0;
    for (index, point) in area(WIDTH, HEIGHT).points().enumerate() {
        let differs = aliased[index] != picture[index];
        assert!(!differs || passed[index], "{point:?} has no edge and changes");
        changed += usize::from(differs);
    }
    changed
}

fn numbered_colors(count: usize) -> Vec<Rgb888> {
    (0..count as u32)
        .map(|number| Rgb888::new((number * 83) as u8, (number * 37 + 90) as u8, (number * 151) as u8))
        .collect()
}

proptest! {
    #![proptest_config(config(cases(8, 200)))]

    #[test]
    fn pixels_without_an_edge_stay_as_they_are(mesh in faces(700, 8), pose in pose(-300..1_500)) {
        let camera = camera(area(WIDTH, HEIGHT)).with_far(I16F16::from_num(1_800)).unwrap();
        let colors = numbered_colors(100);
        let surface = Surface::new(mesh);
        let models = [Model::new(surface.face_set(), &colors).unwrap().with_pose(pose)];
        only_edges_change::<Rgb888>(&camera, &models);
        only_edges_change::<Fine<Deep<Rgb888>>>(&camera, &models);
        only_edges_change::<DoubleSided<Rgb888>>(&camera, &models);
        only_edges_change::<Orthographic<Rgb888>>(&camera, &models);
    }

    /// What a face has on the other side of an edge only says where not to look: edges inside a surface cancel out.
    #[test]
    fn edges_inside_a_surface_change_nothing(kind in 0..2usize, pose in pose(700..1_500)) {
        let camera = camera(area(WIDTH, HEIGHT));
        let surface = Surface::new([cube(0.6), icosphere(0.8)][kind].clone());
        let colors = vec![Rgb888::WHITE; 1_000];
        let with = [Model::new(surface.face_set(), &colors).unwrap().with_pose(pose)];
        let without = [Model::new(surface.mesh.face_set(), &colors).unwrap().with_pose(pose)];
        let [aliased, picture] = both_pictures::<Rgb888>(&camera, &with);
        prop_assert!(aliased != picture);
        let [_, other] = both_pictures::<Rgb888>(&camera, &without);
        let mut memory = Box::new(Many::<Antialiased<Rgb888>>::new());
        let part = coverage(&memory.prepare(&camera, &with).unwrap(), 0..1_000, false);
        for (index, point) in area(WIDTH, HEIGHT).points().enumerate() {
            prop_assert!(
                picture[index] == other[index],
                "{point:?}: {:?}, without {:?}, before {:?}, aliased {:?}, covered {}", picture[index], other[index], background(point), aliased[index], part[index]
            );
        }
    }

    #[test]
    fn tables_of_neighbours_are_those_of_all_pairs(faces in prop::collection::vec(prop::array::uniform3(0..12u16), 20)) {
        let table: [[u16; 3]; 20] = faces.clone().try_into().unwrap();
        prop_assert_eq!(FaceSet::find_neighbours(&table).to_vec(), neighbours(&faces));
    }
}

#[test]
fn closed_meshes_have_neighbours_everywhere() {
    let torus = torus();
    let table: [[u16; 3]; 576] = torus.faces.clone().try_into().unwrap();
    let found = FaceSet::find_neighbours(&table);
    assert_eq!(found.to_vec(), neighbours(&torus.faces));
    assert!(
        found
            .as_flattened()
            .iter()
            .all(|neighbour| *neighbour != FaceSet::NO_NEIGHBOUR)
    );
    assert_eq!(FaceSet::find_neighbours::<0>(&[]), [[0; 3]; 0]);
}

/// Draws rectangles, where a unit at distance 1,024 is 1/32 pixel, in one row and returns some of its pixels.
fn row_of_rectangles<L: Look<Color = Gray8>>(
    rectangles: &[[i16; 5]],
    skin: impl Fn(usize) -> <L::Shading as Shading>::Skin<'static>,
    columns: std::ops::Range<usize>,
) -> Vec<u8> {
    let whole = area(WIDTH, HEIGHT);
    let camera = camera(whole);
    let vertices: &'static [[[i16; 3]; 4]] = rectangles
        .iter()
        .map(|[left, right, top, bottom, z]| {
            [
                [*left, *top, *z],
                [*right, *top, *z],
                [*right, *bottom, *z],
                [*left, *bottom, *z],
            ]
        })
        .collect::<Vec<_>>()
        .leak();
    const FACES: [[u16; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
    static NEIGHBOURS: [[u16; 3]; 2] = FaceSet::find_neighbours(&FACES);
    let models: Vec<_> = vertices
        .iter()
        .enumerate()
        .map(|(index, vertices)| {
            let mesh = FaceSet::new(vertices, &FACES).unwrap().with_neighbours(&NEIGHBOURS);
            Model::<L::Shading>::with_skin(mesh, skin(index)).unwrap()
        })
        .collect();
    let mut memory = Memory::<L, 40, 20, 64, 64>::new();
    let mut words = vec![40; 64 * 64];
    let mut band = Band::<Gray8>::new(whole, &mut words).unwrap();
    memory.prepare(&camera, &models).unwrap().draw(&mut band);
    words[32 * 64..][columns].to_vec()
}

static LEVELS: [[Gray8; 2]; 3] = [[Gray8::new(200); 2], [Gray8::new(100); 2], [Gray8::new(0); 2]];

fn levels(index: usize) -> &'static [Gray8] {
    &LEVELS[index]
}

/// The camera's axis goes through pixel (32, 32), whose centre is half a pixel right of the axis and below it.
#[test]
fn a_level_side_covers_what_it_covers() {
    let over_40 = |level: i32, part: f64| 40.0 + f64::from(level - 40) * part;
    for (left, part) in [(0, 1.0), (8, 0.75), (16, 0.5), (24, 0.25)] {
        let found = row_of_rectangles::<Antialiased<Gray8>>(&[[left, 400, 100, -100, 1024]], levels, 31..34);
        assert_eq!(found[0], 40, "{left}");
        assert!(
            (f64::from(found[1]) - over_40(200, part)).abs() < 1.2,
            "{left}: {found:?}"
        );
        assert_eq!(found[2], 200, "{left}");
    }
}

/// A side over another surface: the one behind it, not what the band had, shows through. A hidden side changes nothing.
#[test]
fn the_next_surface_is_behind_a_side() {
    let near_first = [[8, 400, 100, -100, 1024], [-800, 800, 200, -200, 2048]];
    let mut far_first = near_first;
    far_first.reverse();
    let expected = |near: f64, far: f64| far + (near - far) * 0.75;
    let found = row_of_rectangles::<Antialiased<Gray8>>(&near_first, levels, 31..34);
    assert_eq!((found[0], found[2]), (100, 200));
    assert!((f64::from(found[1]) - expected(200.0, 100.0)).abs() < 1.2, "{found:?}");
    let found = row_of_rectangles::<Antialiased<Gray8>>(&far_first, levels, 31..34);
    assert_eq!((found[0], found[2]), (200, 100));
    assert!((f64::from(found[1]) - expected(100.0, 200.0)).abs() < 1.2, "{found:?}");
    // The side of the far one behind the near one, also where that of the near one is exactly between two pixels.
    let hidden = [[0, 400, 100, -100, 1024], [16, 800, 200, -200, 2048]];
    assert_eq!(
        row_of_rectangles::<Antialiased<Gray8>>(&hidden, levels, 31..34),
        [40, 200, 200]
    );
    let hidden = [[-400, 400, 100, -100, 1024], [16, 800, 200, -200, 2048]];
    assert_eq!(
        row_of_rectangles::<Antialiased<Gray8>>(&hidden, levels, 30..35),
        [200; 5]
    );
}

/// Surfaces that end where another one begins leave no gap in the pixel that they share.
#[test]
fn abutting_surfaces_have_no_seam() {
    let rectangles = [[-400, 13, 100, -100, 1024], [13, 400, 100, -100, 1024]];
    let found = row_of_rectangles::<Antialiased<Gray8>>(&rectangles, levels, 31..34);
    assert!(found.iter().all(|level| (100..=200).contains(level)), "{found:?}");
}

/// Beside a face attributes are at most those of its corners.
#[test]
fn colours_beside_a_face_are_those_of_its_corners() {
    const NORMALS: [[i8; 2]; 4] = [[0, 0]; 4];
    let skin = |index: usize| GouraudSkin {
        colors: levels(index),
        normals: &NORMALS,
        lights: Lambert {
            ambient: U0F16::MAX,
            lights: [],
            points: [],
        },
    };
    let rectangles = [[8, 400, 100, -100, 1024]];
    type Look = Antialiased<Gouraud<Gray8, Lambert<0>>>;
    let found = row_of_rectangles::<Look>(&rectangles, skin, 31..34);
    assert_eq!((found[0], found[2]), (40, 200));
    assert!((158..=162).contains(&found[1]), "{found:?}");
}

/// The level of grey is a number of each vertex, and whatever it is past them.
#[derive(Debug)]
struct Steep;

impl Shading for Steep {
    type Color = Gray8;
    type Skin<'a> = &'a [i16];
    type Uniforms = ();
    type Attributes = [i16; 1];

    fn uniforms(_: &&[i16], _: &Pose, _: &Camera) {}

    fn vertex(levels: &&[i16], (): &(), vertex: usize, _: [i32; 3]) -> [i16; 1] {
        [levels[vertex]]
    }

    fn fragment(_: &&[i16], _: u8, [level]: &[i32; 1]) -> Option<u8> {
        Some((level >> 16) as u8)
    }
}

proptest! {
    #![proptest_config(config(cases(8, 200)))]

    /// Where faces are thin, their attributes are soon far from those of the corners.
    #[test]
    fn attributes_beside_thin_faces_are_between_those_of_their_corners(
        mesh in faces(300, 8),
        pose in pose(700..1_500),
        levels in prop::collection::vec(prop::sample::select(vec![100i16, 200]), 24),
    ) {
        let whole = area(WIDTH, HEIGHT);
        let surface = Surface::new(mesh);
        let models = [Model::<Steep>::with_skin(surface.face_set(), &levels).unwrap().with_pose(pose)];
        let mut memory = Box::new(Many::<Antialiased<Steep>>::new());
        // As bright as the brightest: nothing is brighter.
        let mut words = vec![200; 64 * 64];
        let mut band = Band::<Gray8>::new(whole, &mut words).unwrap();
        memory.prepare(&camera(whole), &models).unwrap().draw(&mut band);
        prop_assert!(words.iter().all(|level| (100..=200).contains(level)));
    }
}

/// A floor of 8 x 8 squares of 200 units, from a column on.
fn floor(left: i16) -> Surface {
    const SIDE: u16 = 8;
    let row = |z: u16| (0..=SIDE).map(move |x| [left + x as i16 * 200, -150, z as i16 * 200 - 400]);
    let square = |x: u16, z: u16| {
        let [a, b] = [z * (SIDE + 1) + x, (z + 1) * (SIDE + 1) + x];
        [[a, b, b + 1], [a, b + 1, a + 1]]
    };
    Surface::new(Mesh::new(
        (0..=SIDE).flat_map(row).collect(),
        (0..SIDE)
            .flat_map(|z| (0..SIDE).flat_map(move |x| square(x, z)))
            .collect(),
    ))
}

/// The pixels around a pixel, and itself.
fn around(point: Point) -> impl Iterator<Item = Point> + Clone {
    let all = (-1..=1).flat_map(move |y| (-1..=1).map(move |x| point + Point::new(x, y)));
    all.filter(|point| area(WIDTH, HEIGHT).contains(*point))
}

fn at_point(picture: &[Rgb888], point: Point) -> Rgb888 {
    picture[(point.y * WIDTH as i32 + point.x) as usize]
}

/// A floor of many faces that the near plane cuts is whole: no seam runs along the cut ones.
#[test]
fn cut_faces_leave_no_seam() {
    let surface = floor(-800);
    let colors = vec![Rgb888::WHITE; 200];
    let mut inside = 0;
    for turn in 0..16 {
        let rotation = Rotation::about_y(U0F16::from_num(f64::from(turn) / 64.0));
        let pose = Pose::new(rotation, at(0, 0, 200));
        let models = [Model::new(surface.face_set(), &colors).unwrap().with_pose(pose)];
        let [aliased, picture] = both_pictures::<Rgb888>(&camera(area(WIDTH, HEIGHT)), &models);
        for point in area(WIDTH, HEIGHT).points() {
            if around(point).all(|point| at_point(&aliased, point) == Rgb888::WHITE) {
                inside += 1;
                assert_eq!(at_point(&picture, point), Rgb888::WHITE, "{point:?}, turn {turn}");
            }
        }
    }
    assert!(inside > 5_000, "{inside} pixels of floor");
}

/// What is right of faces that are cut has the silhouettes that it has without them.
#[test]
fn cut_faces_change_nothing_beside_them() {
    let (ground, body) = (floor(-1_700), Surface::new(icosphere(0.5)));
    let colors = vec![Rgb888::WHITE; 400];
    let model = |surface: &'static Surface, turns: f64, position: [i32; 3]| {
        Model::new(surface.face_set(), colors.clone().leak())
            .unwrap()
            .with_pose(Pose::new(
                Rotation::about_y(U0F16::from_num(turns)),
                position.map(I16F16::from_num),
            ))
    };
    let (ground, body) = (&*Box::leak(Box::new(ground)), &*Box::leak(Box::new(body)));
    let mut compared = 0;
    for step in 0..20 {
        let (floor, ball) = (
            model(ground, 0.97, [0, 0, 200]),
            model(body, 0.0, [150, -750 + 15 * step, 900]),
        );
        let camera = camera(area(WIDTH, HEIGHT));
        let [aliased, picture] = both_pictures::<Rgb888>(&camera, &[floor, ball]);
        let [aliased_alone, alone] = both_pictures::<Rgb888>(&camera, &[ball]);
        for point in area(WIDTH, HEIGHT).points() {
            if around(point).all(|point| at_point(&aliased, point) == at_point(&aliased_alone, point)) {
                assert_eq!(
                    at_point(&picture, point),
                    at_point(&alone, point),
                    "{point:?}, step {step}"
                );
                compared += usize::from(at_point(&alone, point) != at_point(&aliased_alone, point));
            }
        }
    }
    assert!(compared > 500, "{compared} pixels of silhouettes");
}

/// Translucent models have no silhouettes by area; those of the others are seen through them.
#[test]
fn silhouettes_are_seen_through_translucent_models() {
    type Plain = Antialiased<Translucent<Gray8>>;
    let skin = |alpha: [u8; 2]| move |index: usize| (levels(index), alpha[index]);
    let rectangles = [[-800, 800, 200, -200, 512], [8, 400, 100, -100, 1024]];
    let opaque = row_of_rectangles::<Plain>(&rectangles, skin([0, 255]), 31..34);
    assert!((f64::from(opaque[1]) - 85.0).abs() < 1.2, "{opaque:?}");
    let through = row_of_rectangles::<Plain>(&rectangles, skin([128, 255]), 31..34);
    for (through, level) in through.iter().zip(opaque) {
        let expected = (128.0 * 200.0 + 127.0 * f64::from(level)) / 255.0;
        assert!((f64::from(*through) - expected).abs() < 1.2, "{through} {expected}");
    }
}

/// A mirrored model has its outside where its mirror image has it.
#[test]
fn mirrored_models_have_silhouettes() {
    type Mirrored = Antialiased<Transformed<Gray8>>;
    let mirror = Affine::scaled([-1, 1, 1].map(I8F24::from_num));
    let skin = |index: usize| (levels(index), mirror);
    let found = row_of_rectangles::<Mirrored>(&[[-400, -8, 100, -100, 1024]], skin, 31..34);
    assert_eq!((found[0], found[2]), (40, 200), "{found:?}");
    assert!((158..=162).contains(&found[1]), "{found:?}");
}
