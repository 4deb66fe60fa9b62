//! What frames count, against pictures and against faces counted otherwise.

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use zrow::{
    band::Band,
    geometry::{Sub4, SubPixel},
    scene::{Counted, Counters, FaceSet, Look, Memory, Model, OnePass, Pose, Prepared, Rotation, Unhurried, Whole},
    shade::{Texels, Textured, TexturedSkin},
};

use crate::common::{cases, meshes};
use crate::numbered_scene::{Scene, area, picture};
use crate::reference::nearest_faces::Face;
use crate::snapped_faces::{at, camera, snapped, standard_pose};

/// Units of a pixel.
const UNIT: i128 = 1 << <Sub4 as SubPixel>::FRACTION_BITS;

type Many<L> = Memory<L, 900, 600, 128, 64, 256>;

/// How many pixels of an area a face covers, and in how many rows.
fn covered(face: &Face, area: Rectangle) -> (u32, u32) {
    let is_covered = |point: &Point| face.covers(i128::from(point.x) * UNIT, i128::from(point.y) * UNIT);
    let pixels: Vec<_> = area.points().filter(is_covered).map(|point| point.y).collect();
    let mut rows = pixels.clone();
    rows.dedup();
    (pixels.len() as u32, rows.len() as u32)
}

/// Pixels and spans of all faces of a frame.
fn covered_by_all<L: Look>(prepared: &Prepared<'_, '_, L>, area: Rectangle) -> (u32, u32) {
    let faces = snapped(prepared).into_iter();
    let covered = faces.map(|face| covered(&face, area));
    covered.fold((0, 0), |(pixels, rows), (more, others)| (pixels + more, rows + others))
}

/// The meshes of the standard scene, in a look that counts, prepared and drawn.
fn counted<L: Look<Color = Rgb888, Shading = Rgb888, Counting = core::cell::Cell<Counters>>>(
    pose: Pose,
) -> (Counters, Vec<Option<usize>>, (u32, u32)) {
    let (area, scene) = (area(128, 64), Scene::new(vec![meshes::torus(), meshes::cube(0.5)]));
    let models = scene.models(pose);
    let mut memory = Box::new(Many::<L>::new());
    let mut prepared = memory.prepare(&camera(area), &models).unwrap();
    let picture = picture(&mut prepared, area);
    (prepared.counters(), picture, covered_by_all(&prepared, area))
}

/// Rows with depths test each pixel that a face covers, once; faces that are not drawn are those seen from behind or without a
/// pixel in their box.
#[test]
fn depth_tests_are_those_of_all_covered_pixels() {
    for frame in 0..cases(3, 8) as u16 {
        let (counters, _, (pixels, spans)) = counted::<Unhurried<Counted<Rgb888>>>(standard_pose(frame * 7));
        assert_eq!((counters.pixels_tested, counters.spans_tested), (pixels, spans));
        assert_eq!((counters.pixels_filled, counters.spans_filled), (0, 0));
        assert_eq!((counters.rows, counters.rows_without_depth), (64, 0));
        assert_eq!((counters.fragments, counters.divisions), (0, 0));
        let (hurried, ..) = counted::<Counted<Rgb888>>(standard_pose(frame * 7));
        assert_eq!(hurried.faces, 588);
        assert_eq!(hurried.faces_culled, counters.faces_culled);
        // About half of them are seen from behind.
        assert!((200..500).contains(&counters.faces_culled), "{counters:?}");
        // A row that overlaps is begun without depths and drawn once more with them.
        assert!(hurried.pixels_tested <= pixels && hurried.pixels_tested + hurried.pixels_filled >= pixels);
    }
}

/// Faces that are left out leave no pixel out, and all others are in the table of faces.
#[test]
fn culled_faces_are_seen_nowhere() {
    for frame in 0..cases(3, 8) as u16 {
        let pose = standard_pose(frame * 9);
        let (counters, picture, _) = counted::<Counted<Rgb888>>(pose);
        let mut seen: Vec<_> = picture.into_iter().flatten().collect();
        seen.sort_unstable();
        seen.dedup();
        let left = counters.faces - counters.faces_culled;
        assert!(seen.len() as u32 <= left && left <= counters.faces, "{counters:?}");
    }
}

/// A mesh around the camera: some faces are cut, and each of them counts once, however many fragments it has.
#[test]
fn cut_faces_count_once() {
    let (area, scene) = (area(128, 64), Scene::new(vec![meshes::torus()]));
    let mut memory = Box::new(Many::<Counted<Rgb888>>::new());
    let (mut all_cut, mut all_fragments) = (0, 0);
    for frame in 0..16 {
        let models = scene.models(Pose::new(standard_pose(frame * 4).rotation, at(100, 0, 250)));
        let prepared = memory.prepare(&camera(area), &models).unwrap();
        let faces: Vec<_> = prepared.faces().map(|face| face.order).collect();
        // Whole faces come first, in ascending order; the fragments of each cut one lie together after them.
        let whole = faces.windows(2).take_while(|pair| pair[0] < pair[1]).count() + 1;
        let mut cut = faces[whole.min(faces.len())..].to_vec();
        all_fragments += cut.len();
        cut.dedup();
        all_cut += cut.len();
        let counters = prepared.counters();
        assert_eq!(counters.faces_cut as usize, cut.len());
        assert!(counters.faces_cut + counters.faces_culled <= counters.faces);
    }
    assert!(
        all_cut > 10 && all_fragments > all_cut,
        "{all_cut} faces, {all_fragments} fragments"
    );
}

/// The front of a cube: no depth is tested, and each pixel is filled once.
#[test]
fn nothing_is_tested_where_nothing_overlaps() {
    let (area, scene) = (area(128, 64), Scene::new(vec![meshes::cube(0.5)]));
    let models = scene.models(Pose::new(Rotation::IDENTITY, at(0, 0, 1024)));
    let mut memory = Box::new(Many::<Counted<Rgb888>>::new());
    let mut prepared = memory.prepare(&camera(area), &models).unwrap();
    let drawn = picture(&mut prepared, area).into_iter().flatten().count() as u32;
    let counters = prepared.counters();
    assert!(drawn > 100);
    assert_eq!((counters.pixels_filled, counters.pixels_tested), (drawn, 0));
    assert_eq!((counters.rows, counters.rows_without_depth), (64, 64));
}

/// With fewer slots than faces, rows take passes, and test what they test otherwise.
#[test]
fn passes_test_each_pixel_once() {
    let (area, scene) = (area(128, 64), Scene::new(vec![meshes::torus(), meshes::cube(0.5)]));
    let models = scene.models(standard_pose(5));
    let mut memory = Box::new(Memory::<Counted<Rgb888>, 900, 600, 128, 64, 10>::new());
    let mut prepared = memory.prepare(&camera(area), &models).unwrap();
    picture(&mut prepared, area);
    let counters = prepared.counters();
    assert!(counters.rows_in_passes > 20, "{counters:?}");
    assert_eq!(counters.rows_in_passes, prepared.rows_in_passes());
    let (pixels, spans) = covered_by_all(&prepared, area);
    assert_eq!((counters.pixels_tested, counters.spans_tested), (pixels, spans));
}

static TEXELS: [[u16; 16]; 16] = [[0x1234; 16]; 16];

/// Draws textured quadrangles, each at a distance and turned about y, from the front to the back.
fn quadrangles(places: &[(i32, f32)]) -> (Counters, u32) {
    let area = area(128, 64);
    let mesh = FaceSet::new(
        &[[-300, -300, 0], [-300, 300, 0], [300, 300, 0], [300, -300, 0]],
        &[[0, 1, 2], [0, 2, 3]],
    )
    .unwrap();
    let skin = TexturedSkin {
        image: &TEXELS,
        coordinates: &[[0, 4096], [0, 0], [4096, 0], [4096, 4096]],
    };
    let model = Model::<Textured<Texels<Rgb565, 16, 16>>>::with_skin(mesh, skin).unwrap();
    let place = |&(distance, turns): &(i32, f32)| {
        let rotation = Rotation::about_y(fixed::types::U0F16::from_num(turns));
        model.with_pose(Pose::new(rotation, at(0, 0, distance)))
    };
    let models: Vec<_> = places.iter().map(place).collect();
    let mut memory = Box::new(Memory::<
        Counted<Whole<OnePass<Textured<Texels<Rgb565, 16, 16>>>>>,
        16,
        8,
        128,
        64,
        8,
    >::new());
    let mut prepared = memory.prepare(&camera(area), &models).unwrap();
    let mut words = vec![0; 128 * 64];
    prepared.draw(&mut Band::<Rgb565>::new(area, &mut words).unwrap());
    let seen = words.iter().filter(|word| **word != 0).count() as u32;
    (prepared.counters(), seen)
}

/// A face at one distance divides nothing; each of its pixels is one texel.
#[test]
fn faces_at_one_distance_divide_nothing() {
    let (counters, seen) = quadrangles(&[(1024, 0.0)]);
    assert!(seen > 500);
    assert_eq!((counters.fragments, counters.divisions), (seen, 0));
    let (askew, seen) = quadrangles(&[(1024, 0.125)]);
    assert_eq!(askew.fragments, seen);
    // At both ends of each span at least, and where the column is a multiple of 16 at most.
    let (spans, pixels) = (askew.spans_filled, askew.pixels_filled);
    assert!(
        (2 * spans..=2 * spans + pixels / 16 + spans).contains(&askew.divisions),
        "{askew:?}"
    );
}

/// What is hidden has no texels: a second quadrangle behind the first one takes depth tests and nothing else.
#[test]
fn hidden_pixels_have_no_texels() {
    let (one, seen) = quadrangles(&[(1024, 0.0)]);
    let (both, seen_of_both) = quadrangles(&[(1024, 0.0), (1536, 0.0)]);
    assert_eq!(seen, seen_of_both);
    assert_eq!(both.fragments, one.fragments);
    assert!(both.pixels_tested > one.pixels_tested);
}

/// Rows of a textured scene in which no face overlaps another need no depths; those have them in which one lies behind another.
#[test]
fn rows_have_depths_where_one_face_lies_behind_another() {
    let (one, seen) = quadrangles(&[(4096, 0.0)]);
    assert_eq!((one.rows, one.rows_without_depth), (64, 64));
    assert_eq!((one.pixels_filled, one.pixels_tested), (seen, 0));
    // The second one is smaller on the screen: above and below it, the first one is alone.
    let (both, _) = quadrangles(&[(4096, 0.0), (5000, 0.0)]);
    let crossed = both.rows - both.rows_without_depth;
    assert!((5..60).contains(&crossed), "{both:?}");
    assert!(both.pixels_filled > 0, "{both:?}");
    // Four faces to a row, but for those in which the diagonals leave some of them empty.
    assert!((2 * crossed..=4 * crossed).contains(&both.spans_tested), "{both:?}");
}
