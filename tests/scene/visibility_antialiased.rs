//! The painter's algorithm with antialiased silhouettes: the picture of the depth row, to the bit, and seen through translucent
//! faces what is behind them in each pixel by its exact area.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::Band,
    geometry::TooSmall,
    scene::{Antialiased, Deep, DoubleSided, Fine, Look, Memory, Model, Pose, Prepared, Rotation},
    shade::{CutOut, Indexed, IndexedImage, Textured, TexturedSkin, Translucent},
    visible::{DepthSort, Work},
};
use zrow_scenes::teapot::TEAPOT;

use crate::antialiased::{COLORS, OFF, Surface, background, coverage, difference, mixed, on_edges};
use crate::common::meshes::{self, Mesh, cube, icosphere, torus};
use crate::common::{cases, config};
use crate::holes::{any_coordinates, leak};
use crate::numbered_scene::area;
use crate::random_faces::{faces, pose};
use crate::snapped_faces::{at, camera, standard_pose};
use crate::visibility::differing;
use crate::visibility_depth_sort::{cycle, penetrating};
use crate::visibility_shading::Even;

const SIDE: u32 = 64;
type Many<L> = Memory<L, 3_000, 1_500, 64, 64, 300>;
type Image = Indexed<Rgb888, 2, 4, 4>;

/// The picture over the background in bands of this size, from above or from below, each drawn by the closure.
/// The picture in bands of this size, from below or from above, each drawn by the closure. Not generic, as that of the other tests of
/// visibility.
fn in_bands([width, height]: [u32; 2], upwards: bool, draw: &mut dyn FnMut(&mut Band<'_, Rgb888>)) -> Vec<u32> {
    let mut picture = vec![0; (SIDE * SIDE) as usize];
    let mut tops: Vec<u32> = (0..SIDE).step_by(height as usize).collect();
    if upwards {
        tops.reverse();
    }
    for top in tops {
        for left in (0..SIDE).step_by(width as usize) {
            let size = Size::new(width.min(SIDE - left), height.min(SIDE - top));
            let part = Rectangle::new(Point::new(left as i32, top as i32), size);
            let mut words: Vec<u32> = part.points().map(|point| background(point).into_storage()).collect();
            draw(&mut Band::new(part, &mut words).unwrap());
            for (point, word) in part.points().zip(words) {
                picture[(point.y as u32 * SIDE + point.x as u32) as usize] = word;
            }
        }
    }
    picture
}

fn by_row<L: Look<Color = Rgb888>>(prepared: &mut Prepared<'_, '_, L>) -> Vec<u32> {
    in_bands([SIDE, SIDE], false, &mut |band| prepared.draw(band))
}

/// Compares the pictures of the painter with that of the depth row, in bands of several sizes.
fn check_painter<L: Look<Color = Rgb888>, const SPLITS: usize>(prepared: &mut Prepared<'_, '_, L>, expected: &[u32]) {
    for (size, upwards) in [([SIDE, SIDE], false), ([SIDE, 1], false), ([23, 11], true)] {
        let mut method = DepthSort::<1_500, SPLITS>::new();
        let painted = in_bands(size, upwards, &mut |band| prepared.draw_by(&mut method, band).unwrap());
        let look = std::any::type_name::<L>();
        check_same(
            &painted,
            expected,
            format_args!("bands of {size:?}, {SPLITS} conditions, {look}"),
        );
    }
}

/// Compares two pictures.
fn check_same(painted: &[u32], expected: &[u32], how: std::fmt::Arguments<'_>) {
    let differing: Vec<_> = (0..painted.len()).filter(|at| painted[*at] != expected[*at]).collect();
    let first = differing.first().map_or(0, |at| *at);
    assert!(
        differing.is_empty(),
        "{} pixels differ, the first is {}, {}: {:06x}, not {:06x}; {how}",
        differing.len(),
        first % SIDE as usize,
        first / SIDE as usize,
        painted[first],
        expected[first],
    );
}

/// Compares both in a look; returns how many pixels the silhouettes change.
fn check<L: Look<Color = Rgb888>>(models: &[Model<'_, L::Shading>]) -> usize
where
    Antialiased<L>: Look<Color = Rgb888, Shading = L::Shading, Depth = L::Depth>,
{
    let camera = camera(area(SIDE, SIDE));
    let (mut memory, mut plain) = (Box::new(Many::<Antialiased<L>>::new()), Box::new(Many::<L>::new()));
    let mut prepared = memory.prepare(&camera, models).unwrap();
    let expected = by_row(&mut prepared);
    check_painter::<_, 0>(&mut prepared, &expected);
    check_painter::<_, 7>(&mut prepared, &expected);
    check_painter::<_, 2_000>(&mut prepared, &expected);
    // The depth row goes on after the painter, and the painter after the depth row.
    let (mut method, mut number) = (DepthSort::<1_500, 100>::new(), 0);
    let by_both = in_bands([SIDE, 5], false, &mut |band| {
        number += 1;
        if number % 3 == 0 {
            prepared.draw(band);
        } else {
            prepared.draw_by(&mut method, band).unwrap();
        }
    });
    assert!(by_both == expected, "by both in turn");
    let aliased = by_row(&mut plain.prepare(&camera, models).unwrap());
    differing(&aliased, &expected)
}

fn color(word: u32) -> Rgb888 {
    Rgb888::new((word >> 16) as u8, (word >> 8) as u8, word as u8)
}

/// Colours that differ much from face to face.
fn colors(mesh: &Mesh) -> Vec<Rgb888> {
    let number = |face: u32| face.wrapping_mul(0x9e37_79b1) >> 8;
    (1..=mesh.faces.len() as u32)
        .map(|face| {
            Rgb888::new(
                (number(face) >> 16) as u8,
                (number(face) >> 8) as u8,
                number(face) as u8,
            )
        })
        .collect()
}

/// A picture of four colours, which repeats over a face.
const PATTERN: IndexedImage<'static, Rgb888, 2, 4, 4> = IndexedImage {
    indices: &[[0x1b, 0xe4], [0x72, 0x8d], [0xc9, 0x36], [0x93, 0x6c]],
    palette: &[0x10, 0xff_0020, 0x40_f030, 0x20_40f0],
};

/// Compares both in all precisions, with and without the neighbours of faces; returns how many pixels silhouettes change.
fn check_meshes(meshes: Vec<Mesh>, pose: Pose) -> usize {
    let surfaces: Vec<_> = meshes.into_iter().map(Surface::new).collect();
    let colors: Vec<_> = surfaces.iter().map(|surface| colors(&surface.mesh)).collect();
    let models = |has_neighbours: bool| {
        let mut models = vec![];
        for (surface, colors) in surfaces.iter().zip(&colors) {
            let mesh = if has_neighbours {
                surface.face_set()
            } else {
                surface.mesh.face_set()
            };
            models.push(Model::new(mesh, colors).unwrap().with_pose(pose));
        }
        models
    };
    check::<Rgb888>(&models(false));
    let with_neighbours = models(true);
    check::<Fine<Rgb888>>(&with_neighbours);
    check::<Deep<Rgb888>>(&with_neighbours);
    check::<DoubleSided<Fine<Deep<Rgb888>>>>(&with_neighbours);
    check::<Rgb888>(&with_neighbours)
}

#[test]
fn standard_scenes_have_the_picture_of_the_depth_row() {
    let frames = cases(2, 16) as u16;
    for frame in 0..frames {
        let mut changed = 0;
        for meshes in meshes::standard_scenes() {
            changed += check_meshes(meshes, standard_pose(frame * 5 + 1));
        }
        changed += check_meshes(vec![torus(), icosphere(0.5), cube(0.7)], standard_pose(frame * 3));
        assert!(changed > 200, "{changed}, frame {frame}");
    }
}

#[test]
fn the_teapot_has_the_picture_of_the_depth_row() {
    let surface = Surface::new(Mesh::new(TEAPOT.vertices().to_vec(), TEAPOT.faces().to_vec()));
    let colors = colors(&surface.mesh);
    for frame in [9, 0, 17, 26, 31].into_iter().take(cases(1, 5) as usize) {
        let mut pose = standard_pose(frame);
        // So far away that the near plane cuts no face.
        pose.translation = at(0, 0, 900);
        let models = [Model::new(surface.face_set(), &colors).unwrap().with_pose(pose)];
        let changed = check::<Rgb888>(&models);
        assert!(changed > 60, "{changed}, frame {frame}");
    }
}

/// Faces that go through each other, or hide each other in a cycle, are split by the painter: splits are no silhouettes.
#[test]
fn splits_are_no_silhouettes() {
    for frame in 0..cases(4, 8) as u16 {
        for meshes in [
            vec![penetrating()],
            vec![cycle()],
            vec![penetrating(), cycle(), cube(0.3)],
        ] {
            assert!(check_meshes(meshes, standard_pose(frame * 2)) > 30, "frame {frame}");
        }
    }
    let (surface, camera) = (Surface::new(penetrating()), camera(area(SIDE, SIDE)));
    let colors = colors(&surface.mesh);
    let pose = Pose::new(Rotation::IDENTITY, at(0, 0, 1_400));
    let models = [Model::new(surface.face_set(), &colors).unwrap().with_pose(pose)];
    let mut memory = Box::new(Many::<Antialiased<Rgb888>>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut method = DepthSort::<16, 16>::new();
    let (mut splits, mut pixels) = (0, 0);
    let painted = in_bands([SIDE, SIDE], false, &mut |band| {
        let report = |work| match work {
            Work::Split { .. } => splits += 1,
            Work::Painted { span, .. } => pixels += span.end - span.start,
            _ => {}
        };
        prepared.draw_by_with(&mut method, band, report).unwrap();
    });
    assert!(splits > 0 && method.counters().splits == splits && pixels > 500);
    assert!(painted == by_row(&mut prepared));
}

proptest! {
    #![proptest_config(config(cases(16, 400)))]

    /// Faces of all sizes through each other, many silhouettes in a pixel among them.
    #[test]
    fn random_faces_have_the_picture_of_the_depth_row(
        large in faces(500, 8),
        small in faces(60, 12),
        pose in pose(1_300..2_500),
    ) {
        check_meshes(vec![large, small], pose);
    }

    /// Attributes that are even on the screen, and such that are divided by the depth.
    #[test]
    fn shaded_faces_have_the_picture_of_the_depth_row(
        mesh in faces(500, 8),
        coordinates in any_coordinates(24),
        pose in pose(1_300..2_500),
    ) {
        let surface: &Surface = leak(Surface::new(mesh));
        let skin = TexturedSkin { image: PATTERN, coordinates: leak(coordinates) };
        check::<Even>(&[Model::<Even>::with_skin(surface.face_set(), skin).unwrap().with_pose(pose)]);
        check::<Fine<Deep<Even>>>(&[Model::<Even>::with_skin(surface.face_set(), skin).unwrap().with_pose(pose)]);
        let textured = || Model::<Textured<Image>>::with_skin(surface.face_set(), skin).unwrap().with_pose(pose);
        check::<Textured<Image>>(&[textured()]);
        check::<Fine<Deep<Textured<Image>>>>(&[textured()]);
    }
}

type Layered = Translucent<Rgb888>;

/// A wall that is larger than the picture, at a distance.
fn wall(distance: i16) -> Mesh {
    let half = distance + distance / 8;
    let corners = [[-half, -half], [-half, half], [half, half], [half, -half]];
    Mesh::new(
        corners.map(|[x, y]| [x, y, distance]).to_vec(),
        vec![[0, 1, 2], [0, 2, 3]],
    )
}

/// Compares the painter with the depth row in pixels through which no edge passes; returns how many others differ.
fn check_between_edges<L: Look<Color = Rgb888>>(models: &[Model<'_, L::Shading>]) -> usize
where
    Antialiased<L>: Look<Color = Rgb888, Shading = L::Shading, Depth = L::Depth>,
{
    let camera = camera(area(SIDE, SIDE));
    let mut memory = Box::new(Many::<Antialiased<L>>::new());
    let mut prepared = memory.prepare(&camera, models).unwrap();
    let (expected, passed) = (by_row(&mut prepared), on_edges(&prepared));
    let mut pictures = vec![];
    for (size, upwards) in [([SIDE, SIDE], false), ([29, 7], true)] {
        let mut method = DepthSort::<1_500, 0>::new();
        pictures.push(in_bands(size, upwards, &mut |band| {
            prepared.draw_by(&mut method, band).unwrap()
        }));
    }
    let mut with_parts = DepthSort::<1_500, 500>::new();
    let painted = in_bands([SIDE, 9], false, &mut |band| {
        prepared.draw_by(&mut with_parts, band).unwrap()
    });
    assert!(
        pictures.iter().all(|picture| *picture == painted),
        "in bands, or with parts"
    );
    let mut differing = 0;
    for (index, passed) in passed.into_iter().enumerate() {
        let differs = painted[index] != expected[index];
        assert!(
            !differs || passed,
            "{index}: {:06x}, not {:06x}",
            painted[index],
            expected[index]
        );
        differing += usize::from(differs);
    }
    differing
}

proptest! {
    #![proptest_config(config(cases(16, 400)))]

    /// Translucent faces and opaque ones through each other: the depth row has the same where no silhouette is.
    #[test]
    fn translucent_faces_are_mixed_in_their_order(
        meshes in prop::collection::vec(faces(500, 6), 3),
        alphas in Just([255, 0, 130, 255, 70]).prop_shuffle(),
        pose in pose(1_300..2_500),
    ) {
        let surfaces: Vec<_> = meshes.into_iter().map(Surface::new).collect();
        let colors: Vec<_> = surfaces.iter().map(|surface| colors(&surface.mesh)).collect();
        let mut models = vec![];
        for ((surface, colors), alpha) in surfaces.iter().zip(&colors).zip(alphas) {
            models.push(Model::<Layered>::with_skin(surface.face_set(), (&colors[..], alpha)).unwrap().with_pose(pose));
        }
        check_between_edges::<Layered>(&models);
        check_between_edges::<Fine<Deep<Layered>>>(&models);
    }

    /// Faces with holes, behind which others are seen.
    #[test]
    fn faces_with_holes_are_painted(
        mesh in faces(500, 10),
        coordinates in any_coordinates(30),
        pose in pose(1_300..2_500),
    ) {
        let surface: &Surface = leak(Surface::new(mesh));
        let skin = TexturedSkin { image: PATTERN, coordinates: leak(coordinates) };
        type Holed = Textured<CutOut<Image>>;
        check_between_edges::<Holed>(&[Model::<Holed>::with_skin(surface.face_set(), skin).unwrap().with_pose(pose)]);
    }
}

/// The distance of a translucent wall, its colour, and its alpha.
type Wall = (i16, Rgb888, u8);

/// What is expected of a pixel: layers over the background, from back to front, each with its colour and its coverage.
fn composited(point: Point, layers: &[(Rgb888, f64)]) -> [f64; 3] {
    let mut level = mixed(background(point), background(point), 1.0);
    for (color, part) in layers {
        let color = mixed(*color, *color, 1.0);
        for (level, color) in level.iter_mut().zip(color) {
            *level += (color - *level) * part;
        }
    }
    level
}

/// Draws two convex bodies, the nearest first, and translucent walls, by the painter and by the depth row. The first is what is
/// expected by the exact area of each body in each pixel; returns by how many levels the latter is off at most, and how many pixels
/// lie on one silhouette.
fn check_walls(bodies: &[Mesh; 2], turned: Rotation, walls: &[Wall]) -> (f64, usize) {
    const DISTANCES: [i32; 2] = [1_200, 2_700];
    let camera = camera(area(SIDE, SIDE));
    let surfaces = bodies.clone().map(Surface::new);
    let colors: Vec<_> = COLORS.iter().map(|color| vec![*color; 1_000]).collect();
    let of_walls: Vec<_> = walls
        .iter()
        .map(|(distance, color, alpha)| (wall(*distance), [*color; 2], *alpha))
        .collect();
    let mut models: Vec<_> = (0..2)
        .map(|index| {
            let model = Model::<Translucent<Rgb888>>::with_skin(surfaces[index].face_set(), (&colors[index][..], 255));
            model
                .unwrap()
                .with_pose(Pose::new(turned, at(90, -70, DISTANCES[index])))
        })
        .collect();
    for (mesh, colors, alpha) in &of_walls {
        models.push(Model::with_skin(mesh.face_set(), (&colors[..], *alpha)).unwrap());
    }
    let mut memory = Box::new(Many::<Antialiased<Layered>>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let first = bodies[0].faces.len();
    let parts = [0..first, first..first + bodies[1].faces.len()].map(|orders| coverage(&prepared, orders, false));
    let by_row = by_row(&mut prepared);
    let mut method = DepthSort::<1_500, 100>::new();
    let painted = in_bands([SIDE, 9], false, &mut |band| {
        prepared.draw_by(&mut method, band).unwrap()
    });
    assert!(
        painted
            == in_bands([SIDE, SIDE], false, &mut |band| prepared
                .draw_by(&mut method, band)
                .unwrap())
    );
    let (mut row_is_off, mut on_one) = (0.0f64, 0);
    for (index, point) in area(SIDE, SIDE).points().enumerate() {
        let is_partial = |part: &&Vec<f64>| (1e-9..1.0 - 1e-9).contains(&part[index]);
        match parts.iter().filter(is_partial).count() {
            2.. => continue,
            count => on_one += count,
        }
        let mut layers: Vec<_> = walls
            .iter()
            .map(|(distance, color, alpha)| (i32::from(*distance), *color, f64::from(*alpha) / 255.0))
            .collect();
        layers.extend((0..2).map(|body| (DISTANCES[body], COLORS[body], parts[body][index].min(1.0))));
        layers.sort_by_key(|(distance, _, _)| -distance);
        let layers: Vec<_> = layers.into_iter().map(|(_, color, part)| (color, part)).collect();
        let expected = composited(point, &layers);
        let off = difference(color(painted[index]), expected);
        // Each layer is rounded by half a level.
        assert!(
            off < OFF + 0.5 * walls.len() as f64,
            "{point:?}: {:06x}, not {expected:?}; walls {walls:?}, parts {:?}",
            painted[index],
            [parts[0][index], parts[1][index]]
        );
        row_is_off = row_is_off.max(difference(color(by_row[index]), expected));
    }
    (row_is_off, on_one)
}

/// Translucent faces between a silhouette and what is behind it are seen beside it, by the area of the pixel that is left.
#[test]
fn translucent_faces_are_seen_beside_silhouettes() {
    let (green, grey) = (Rgb888::new(0, 230, 40), Rgb888::new(90, 90, 90));
    let bodies = [cube(0.2), icosphere(0.9)];
    let frames = cases(6, 32) as u16;
    for frame in 0..frames {
        let turned = standard_pose(frame).rotation;
        // In front of all, between both bodies, behind both: the depth row leaves out the latter two.
        let (off, on_one) = check_walls(&bodies, turned, &[(350, green, 100)]);
        assert!(off < 2.2 && on_one > 40, "{off}, {on_one}");
        for distance in [1_660, 3_700] {
            let (off, _) = check_walls(&bodies, turned, &[(distance, green, 180)]);
            assert!(off > 20.0, "{off}");
        }
        check_walls(
            &bodies,
            turned,
            &[(350, green, 100), (1_660, grey, 128), (3_700, green, 200)],
        );
        check_walls(&bodies, turned, &[]);
    }
}

/// With too few faces the band is as it was, whichever row has them, and the error says how many would do; with as many, the picture is
/// the same for any number of conditions. A scene without faces needs none.
#[test]
fn all_capacities() {
    fn with<const FACES: usize, const SPLITS: usize>(models: &[Model<'_, Rgb888>]) {
        let camera = camera(area(SIDE, SIDE));
        let mut memory = Box::new(Many::<Antialiased<Rgb888>>::new());
        let mut prepared = memory.prepare(&camera, models).unwrap();
        let needed: usize = if models.is_empty() { 0 } else { 7 };
        let expected = by_row(&mut prepared);
        let mut method = DepthSort::<FACES, SPLITS>::new();
        let mut result = Ok(());
        let painted = in_bands([SIDE, SIDE], false, &mut |band| {
            result = prepared.draw_by(&mut method, band)
        });
        if FACES >= needed {
            assert_eq!(result, Ok(()));
            assert!(painted == expected, "{FACES}, {SPLITS}");
        } else {
            assert_eq!(result, Err(TooSmall::Faces(needed)));
            assert!(painted == in_bands([SIDE, SIDE], false, &mut |_| {}));
        }
    }
    let surfaces = [cycle(), penetrating()].map(Surface::new);
    let colors: Vec<_> = surfaces.iter().map(|surface| colors(&surface.mesh)).collect();
    let pose = Pose::new(Rotation::IDENTITY, at(0, 0, 1_300));
    let models: Vec<_> = surfaces
        .iter()
        .zip(&colors)
        .map(|(surface, colors)| Model::new(surface.face_set(), colors).unwrap().with_pose(pose))
        .collect();
    macro_rules! with_conditions {
        ($($faces:literal)*) => {
            $(
                for models in [&models[..], &[]] {
                    with::<$faces, 0>(models);
                    with::<$faces, 1>(models);
                    with::<$faces, 2>(models);
                    with::<$faces, 3>(models);
                    with::<$faces, 4>(models);
                    with::<$faces, 9>(models);
                    with::<$faces, 20>(models);
                }
            )*
        };
    }
    with_conditions!(0 1 6 7 8 9 10 20);
}

/// Cut faces have edges by the centres of pixels; what ends in front of them is mixed with them, where the depth row mixes it with
/// what the band had.
#[test]
fn what_ends_in_front_of_a_cut_face_is_mixed_with_it() {
    let floor = Surface::new(Mesh::new(
        vec![
            [-3_000, -400, -500],
            [-3_000, -200, 9_000],
            [3_000, -200, 9_000],
            [3_000, -400, -500],
        ],
        vec![[0, 1, 2], [0, 2, 3]],
    ));
    let body = Surface::new(icosphere(0.5));
    let (white, red) = (vec![Rgb888::WHITE; 2], vec![Rgb888::new(255, 0, 0); 1_000]);
    let pose = Pose::new(Rotation::IDENTITY, at(30, 20, 1_500));
    let models = [
        Model::new(body.face_set(), &red).unwrap().with_pose(pose),
        Model::new(floor.face_set(), &white).unwrap(),
    ];
    let camera = camera(area(SIDE, SIDE));
    let mut memory = Box::new(Many::<Antialiased<Rgb888>>::new());
    let mut method = DepthSort::<1_500, 0>::new();
    let floor = by_row(&mut memory.prepare(&camera, &models[1..]).unwrap());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let part = coverage(&prepared, 0..body.mesh.faces.len(), false);
    let by_row = by_row(&mut prepared);
    let painted = in_bands([SIDE, SIDE], false, &mut |band| {
        prepared.draw_by(&mut method, band).unwrap()
    });
    let (mut over_floor, mut over_background, mut row_is_off) = (0, 0, 0.0f64);
    for (index, word) in painted.into_iter().enumerate() {
        let expected = mixed(red[0], color(floor[index]), part[index].min(1.0));
        assert!(
            difference(color(word), expected) < OFF,
            "{index}: {word:06x}, not {expected:?}"
        );
        row_is_off = row_is_off.max(difference(color(by_row[index]), expected));
        if (0.01..0.99).contains(&part[index]) {
            let is_floor = color(floor[index]) == Rgb888::WHITE;
            (over_floor, over_background) = (
                over_floor + usize::from(is_floor),
                over_background + usize::from(!is_floor),
            );
        }
    }
    assert!(
        over_floor > 10 && over_background > 10 && row_is_off > 20.0,
        "{over_floor}, {over_background}, {row_is_off}"
    );
}
