//! Scenes in several samples a pixel: each sample against the nearest face in exact arithmetic, and against the picture of a
//! camera that is moved by as much.

use std::any::type_name;

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::{I8F24, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor, BigEndian, LittleEndian, Order},
    coverage::{BoxFilter, Grid, Rooks, SamplePattern},
    geometry::{InputError, SubPixel, TooSmall},
    scene::{
        Antialiased, Camera, Counted, Deep, DoubleSided, Fine, Look, Memory, Model, Multisampled, OnePass,
        Orthographic, Pose, Prepared, Rotation, Whole,
    },
    shade::{Bilinear, ChannelColor, Clamped, CutOut, Foggy, Gouraud, LitTextured, Texels, Textured, Translucent},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{Scene, area, depth_and_tolerance};
use crate::random_faces::{faces, pose};
use crate::reference::nearest_faces::{Face, owners};
use crate::same_looks::assert_same_items;
use crate::shaded_scene::{FourColors, Skinned, data};
use crate::snapped_faces::{at, camera, snapped, standard_pose};

const WIDTH: usize = 64;
const HEIGHT: usize = 48;
type Many<L> = Memory<L, 3_000, 1_000, WIDTH, HEIGHT, 400>;

fn whole() -> Rectangle {
    area(WIDTH as u32, HEIGHT as u32)
}

/// How far each sample of a pattern is right of and below the centre of its pixel, in units of which a pixel has so many.
fn offsets<P: SamplePattern>(unit: i32) -> Vec<[i32; 2]> {
    let from_centre = |part: i32| (part * unit).div_euclid(256) - unit / 2;
    P::positions().map(|position| position.map(from_centre)).collect()
}

/// The samples of the pixels of an area that is drawn in one band, those of a pixel one after the other.
fn samples<P, L, O>(
    prepared: &mut Prepared<'_, '_, L>,
    area: Rectangle,
    word: <L::Color as BandColor>::Word,
) -> Vec<<L::Color as BandColor>::Word>
where
    P: SamplePattern,
    L: Look<Color: ChannelColor>,
    O: Order,
{
    let pixels = (area.size.width * area.size.height) as usize;
    let mut words = vec![word; pixels];
    let mut samples = vec![word; pixels * P::SAMPLES];
    let mut band = Band::<L::Color, O>::new(area, &mut words).unwrap();
    band.multisample(P::default(), &mut samples, |samples| prepared.draw_samples(samples))
        .unwrap();
    samples
}

/// Compares each sample with the nearest face by exact arithmetic. Returns how many differ, all of them where two depths are
/// closer than the tolerance.
fn differing<P: SamplePattern, L: Look<Color = Rgb888, Shading = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    area: Rectangle,
) -> usize {
    let unit = 1 << L::Precision::FRACTION_BITS;
    let (depth, tolerance) = depth_and_tolerance::<L::Depth>(area);
    let faces = snapped(prepared);
    let drawn = samples::<P, L, LittleEndian>(prepared, area, 0);
    let mut differing = 0;
    for (sample, [right, down]) in offsets::<P>(unit).into_iter().enumerate() {
        let [right, down] = [right, down].map(i128::from);
        let moved: Vec<_> = faces
            .iter()
            .map(|face| Face {
                corners: face.corners.map(|[x, y, z]| [x - right, y - down, z]),
                ..*face
            })
            .collect();
        let expected = owners(&moved, area, unit.into(), depth);
        for ((point, expected), pixel) in area.points().zip(expected).zip(drawn.chunks_exact(P::SAMPLES)) {
            if pixel[sample] == expected.map_or(0, |owner| owner as u32 + 1) {
                continue;
            }
            differing += 1;
            let [x, y] = [point.x, point.y].map(|pixels| i128::from(pixels) * i128::from(unit));
            let nearest = |owner: usize| {
                moved
                    .iter()
                    .filter(|face| face.order == owner && face.covers(x, y))
                    .map(|face| face.hundredths(x, y, depth))
                    .max()
                    .unwrap_or_else(|| panic!("{point:?} {sample}: face {owner} does not cover it"))
            };
            let expected = expected.unwrap_or_else(|| panic!("{point:?} {sample}: drawn {}", pixel[sample]));
            assert_ne!(pixel[sample], 0, "{point:?} {sample}: face {expected} is not there");
            let gap = nearest(expected) - nearest(pixel[sample] as usize - 1);
            assert!(gap <= tolerance, "{point:?} {sample}: {gap}/100 steps apart");
        }
    }
    differing
}

/// Compares the samples of all patterns in a look.
fn check<L: Look<Color = Rgb888, Shading = Rgb888>>(models: &[Model<'_, Rgb888>], camera: &Camera) -> usize {
    let mut memory = Box::new(Many::<L>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    let area = camera.viewport().to_rectangle();
    differing::<Rooks<4>, L>(&mut prepared, area)
        + differing::<Rooks<8>, L>(&mut prepared, area)
        + differing::<Rooks<16>, L>(&mut prepared, area)
        + differing::<Grid<2, BoxFilter>, L>(&mut prepared, area)
        + differing::<Grid<4, BoxFilter>, L>(&mut prepared, area)
}

fn sc1() -> Scene {
    Scene::new(vec![meshes::torus(), meshes::cube(0.5)])
}

#[test]
fn samples_show_the_nearest_face() {
    let scene = sc1();
    for frame in [0, 7, 23] {
        let models = scene.models(standard_pose(frame));
        assert_eq!(check::<Multisampled<Rgb888>>(&models, &camera(whole())), 0);
        assert_eq!(check::<Multisampled<Fine<Rgb888>>>(&models, &camera(whole())), 0);
        assert_eq!(check::<Deep<Multisampled<Rgb888>>>(&models, &camera(whole())), 0);
    }
}

proptest! {
    #![proptest_config(config(cases(24, 1_000)))]

    /// Faces that go through each other, some of them cut, some of them slivers.
    #[test]
    fn samples_of_any_faces_show_the_nearest(mesh in faces(400, 6), pose in pose(0..1_200)) {
        let scene = Scene::new(vec![mesh]);
        let models = scene.models(pose);
        check::<Multisampled<Rgb888>>(&models, &camera(whole()));
        check::<Fine<Deep<Multisampled<Rgb888>>>>(&models, &camera(whole()));
    }
}

/// Around the camera: faces that the near plane and the guard band cut.
#[test]
fn samples_of_cut_faces_show_the_nearest() {
    let mut mesh = meshes::icosphere(1.4);
    for vertex in &mut mesh.vertices {
        *vertex = vertex.map(|coordinate| coordinate / 2);
    }
    let scene = Scene::new(vec![mesh.two_sided()]);
    let models = scene.models(Pose::new(Rotation::about_x(U0F16::from_bits(5000)), at(20, 30, 100)));
    check::<Multisampled<Rgb888>>(&models, &camera(whole()));
}

/// A camera that is moved the other way sees at the centres of pixels what samples show: colours, textures, lights, fog, holes
/// and what is translucent, to the bit.
fn check_moved<P, L, O>(models: &[Model<'_, L::Shading>], camera: &Camera)
where
    P: SamplePattern,
    L: Look<Color = Rgb565>,
    O: Order,
{
    let unit = 1 << L::Precision::FRACTION_BITS;
    let mut memory = Box::new(Memory::<Multisampled<L>, 3_000, 1_200, WIDTH, HEIGHT, 400>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    let background = O::reorder(0x1234);
    let drawn = samples::<P, _, O>(&mut prepared, whole(), background);
    let mut centres = vec![background; WIDTH * HEIGHT];
    prepared.draw(&mut Band::<Rgb565, O>::new(whole(), &mut centres).unwrap());
    let mut memory = Box::new(Memory::<L, 3_000, 1_200, WIDTH, HEIGHT, 400>::new());
    let mut at_centres = |camera: &Camera| {
        let mut words = vec![background; WIDTH * HEIGHT];
        let mut band = Band::<Rgb565, O>::new(whole(), &mut words).unwrap();
        memory.prepare(camera, models).unwrap().draw(&mut band);
        words
    };
    assert!(centres == at_centres(camera), "one sample: {}", type_name::<L>());
    assert!(centres.iter().any(|word| *word != background));
    for (sample, offset) in offsets::<P>(unit).into_iter().enumerate() {
        let [x, y] = camera.centre();
        let [right, down] = offset.map(|units| I16F16::from_num(units) / I16F16::from_num(unit));
        let moved = camera.with_centre([x - right, y - down]).unwrap();
        let drawn: Vec<_> = drawn.chunks_exact(P::SAMPLES).map(|pixel| pixel[sample]).collect();
        assert!(drawn == at_centres(&moved), "sample {sample} of {}", type_name::<L>());
    }
}

/// Draws a torus and a cube with a shading, far away and so near that faces are cut.
fn check_shading<H: Skinned<Color = Rgb565>, L: Look<Color = Rgb565, Shading = H>>() {
    let (torus, cube) = (meshes::torus(), meshes::cube(0.7));
    let (of_torus, of_cube) = (data(torus.vertices.len()), data(cube.vertices.len()));
    for (frame, distance) in [(3, 3 * 512), (11, 700)] {
        let place = Pose::new(standard_pose(frame).rotation, at(0, 0, distance));
        let models = [
            H::model(&torus, &of_torus).with_pose(place),
            H::model(&cube, &of_cube).with_pose(place),
        ];
        let camera = camera(whole()).with_scale(I8F24::from_num(0.03)).unwrap();
        check_moved::<Rooks<4>, L, BigEndian>(&models, &camera);
    }
}

#[test]
fn samples_are_shaded_where_they_are() {
    check_shading::<_, Gouraud<Rgb565>>();
    check_shading::<_, Textured<Texels<Rgb565, 16, 16>>>();
    check_shading::<_, Fine<Deep<Foggy<LitTextured<Texels<Rgb565, 16, 16>>>>>>();
    check_shading::<_, Textured<Bilinear<Clamped<CutOut<FourColors>>>>>();
    check_shading::<_, DoubleSided<Orthographic<OnePass<Gouraud<Rgb565>>>>>();
}

/// Two faces in the same plane with holes, and translucent ones over them.
#[test]
fn translucent_faces_are_mixed_in_each_sample() {
    let (torus, cube) = (meshes::torus(), meshes::cube(0.7));
    let colors: Vec<_> = (0..600)
        .map(|face| Rgb565::new(face as u8 % 32, face as u8 % 64, 9))
        .collect();
    let model = |mesh: &'static Mesh, alpha| {
        let colors: &'static [Rgb565] = colors.clone().leak();
        Model::<Translucent<Rgb565>>::with_skin(mesh.face_set(), (colors, alpha)).unwrap()
    };
    let (torus, cube) = (Box::leak(Box::new(torus)), Box::leak(Box::new(cube)));
    let models = [(&*torus, 255), (&*cube, 100), (&*torus, 77), (&*cube, 255)].map(|(mesh, alpha)| {
        let model = model(mesh, alpha);
        model.with_pose(standard_pose(9))
    });
    check_moved::<Rooks<8>, Translucent<Rgb565>, LittleEndian>(&models, &camera(whole()));
}

/// The pixels of a picture with four samples each, drawn in bands from the top or in another order.
fn pixels<L: Look<Color = Rgb888, Shading = Rgb888>>(
    prepared: &mut Prepared<'_, '_, L>,
    bands: impl Iterator<Item = Rectangle>,
) -> Vec<u32> {
    let mut picture = vec![0; WIDTH * HEIGHT];
    for band in bands {
        let columns = band.size.width as usize;
        let mut words = vec![0; columns * band.size.height as usize];
        let mut memory = vec![0; words.len() * Rooks::<4>::SAMPLES];
        Band::<Rgb888>::new(band, &mut words)
            .unwrap()
            .multisample(Rooks::<4>, &mut memory, |samples| prepared.draw_samples(samples))
            .unwrap();
        for (point, word) in band.points().zip(words) {
            if whole().contains(point) {
                picture[point.y as usize * WIDTH + point.x as usize] = word;
            }
        }
    }
    picture
}

#[test]
fn bands_of_any_height_and_in_any_order_draw_the_same() {
    let scene = sc1();
    let models = scene.models(standard_pose(9));
    let mut memory = Box::new(Many::<Multisampled<Rgb888>>::new());
    let mut prepared = memory.prepare(&camera(whole()), &models).unwrap();
    let expected = pixels(&mut prepared, [whole()].into_iter());
    assert!(expected.iter().filter(|word| **word != 0).count() > 200);
    let band =
        |left: i32, top: i32, width: u32, height: u32| Rectangle::new(Point::new(left, top), Size::new(width, height));
    let rows = HEIGHT as i32;
    for height in [1, 3, 7, 48] {
        let bands = (0..rows)
            .step_by(height)
            .map(|top| band(0, top, WIDTH as u32, height as u32));
        assert!(pixels(&mut prepared, bands.clone()) == expected, "{height} rows");
        assert!(pixels(&mut prepared, bands.rev()) == expected, "{height} rows, upwards");
    }
    let shuffled = (0..rows).map(|row| band(0, row * 37 % rows, WIDTH as u32, 1));
    assert!(pixels(&mut prepared, shuffled) == expected);
    // Parts of rows, and a band that reaches beyond the viewport on all sides.
    let parts = (0..rows).flat_map(|row| [band(0, row, 13, 1), band(13, row, 51, 1)]);
    assert!(pixels(&mut prepared, parts) == expected);
    assert!(pixels(&mut prepared, [band(-5, -3, 80, 60)].into_iter()) == expected);
}

/// What an edge of a mesh leaves of the background inside of it: nothing, also where all faces are smaller than a pixel.
#[test]
fn a_mesh_of_one_colour_has_no_seams() {
    let mesh = meshes::icosphere(1.0);
    let colors = vec![Rgb888::WHITE; mesh.faces.len()];
    let mut memory = Box::new(Many::<Multisampled<Rgb888>>::new());
    for distance in [1_300, 4_000, 20_000] {
        let place = Pose::new(standard_pose(5).rotation, at(0, 0, distance));
        let models = [Model::new(mesh.face_set(), &colors).unwrap().with_pose(place)];
        let mut prepared = memory.prepare(&camera(whole()), &models).unwrap();
        let drawn = samples::<Rooks<16>, _, LittleEndian>(&mut prepared, whole(), 0);
        assert!(drawn.contains(&Rgb888::WHITE.into_storage()), "{distance}");
        // In each line of samples at the same height, those of a convex body follow each other.
        for (sample, _) in offsets::<Rooks<16>>(16).iter().enumerate() {
            for row in drawn.chunks_exact(WIDTH * 16) {
                let inside: Vec<_> = row.chunks_exact(16).map(|pixel| pixel[sample] != 0).collect();
                let sides = inside.windows(2).filter(|pair| pair[0] != pair[1]).count();
                assert!(sides <= 2, "{distance}: {inside:?}");
            }
        }
    }
}

/// Samples over what a band holds and among shapes, whole pixels and masks: painter's order, sample by sample.
#[test]
fn a_scene_keeps_the_samples_that_it_does_not_cover() {
    let mesh = Mesh::new(
        vec![[-512, -512, 1024], [0, 512, 1024], [512, -512, 1024]],
        vec![[0, 1, 2]],
    );
    let models = [Model::new(mesh.face_set(), &[Rgb888::WHITE]).unwrap()];
    let mut memory = Box::new(Many::<Multisampled<Rgb888>>::new());
    let mut prepared = memory.prepare(&camera(whole()), &models).unwrap();
    let plain = pixels(&mut prepared, [whole()].into_iter());
    let (mut words, mut memory) = (vec![0x80_8080; WIDTH * HEIGHT], vec![0; 4 * WIDTH * HEIGHT]);
    let mut band = Band::<Rgb888>::new(whole(), &mut words).unwrap();
    band.multisample(Rooks::<4>, &mut memory, |samples| prepared.draw_samples(samples))
        .unwrap();
    let mut partly = 0;
    for (word, plain) in words.iter().zip(plain) {
        let [level, plain] = [word & 0xff, plain & 0xff];
        // Of so many quarters white.
        let quarters = (plain + 1) / 64;
        assert_eq!(level, (4 * 0x80 + quarters * 0x7f + 2) / 4, "{plain}");
        partly += u32::from((1..4).contains(&quarters));
    }
    assert!(partly > 20);
}

#[test]
fn what_there_is_no_room_for_is_an_error_and_then_works() {
    let scene = sc1();
    let models = scene.models(standard_pose(2));
    let camera = camera(whole());
    let mut few = Box::new(Memory::<Multisampled<Rgb888>, 900, 600, WIDTH, HEIGHT, 10>::new());
    let Err(InputError::TooSmall(TooSmall::ActiveFaces(needed))) = few.prepare(&camera, &models) else {
        panic!("there are ten slots");
    };
    let mut many = Box::new(Many::<Multisampled<Rgb888>>::new());
    let mut prepared = many.prepare(&camera, &models).unwrap();
    assert_eq!(prepared.active_needed(), needed);
    let expected = pixels(&mut prepared, [whole()].into_iter());
    // Too few samples: nothing is drawn, and the next band is.
    let (mut words, mut memory) = (vec![7; WIDTH * HEIGHT], vec![0; 4 * WIDTH * HEIGHT]);
    let mut band = Band::<Rgb888>::new(whole(), &mut words).unwrap();
    let missing = band.multisample(Rooks::<4>, &mut memory[1..], |samples| prepared.draw_samples(samples));
    assert_eq!(missing, Err(TooSmall::Words(4 * WIDTH * HEIGHT)));
    assert!(words.iter().all(|word| *word == 7));
    assert!(pixels(&mut prepared, [whole()].into_iter()) == expected);
    // The one with ten slots draws what fits.
    let one = Scene::new(vec![meshes::cube(0.5)]);
    let models = one.models(standard_pose(2));
    assert!(few.prepare(&camera, &models).is_ok());
}

#[test]
fn the_wrapper_changes_one_thing() {
    assert_same_items::<Multisampled<Fine<Rgb888>>, Fine<Multisampled<Rgb888>>>();
    assert_same_items::<Multisampled<Deep<Rgb888>>, Deep<Multisampled<Rgb888>>>();
    assert_same_items::<Multisampled<Whole<Rgb888>>, Whole<Multisampled<Rgb888>>>();
    assert_same_items::<Multisampled<OnePass<Rgb888>>, Multisampled<Rgb888>>();
    assert_same_items::<OnePass<Multisampled<Rgb888>>, Multisampled<Rgb888>>();
    assert_same_items::<Multisampled<Counted<Rgb888>>, Counted<Multisampled<Rgb888>>>();
    assert_same_items::<Multisampled<Orthographic<Rgb888>>, Orthographic<Multisampled<Rgb888>>>();
    assert_same_items::<Multisampled<DoubleSided<Rgb888>>, DoubleSided<Multisampled<Rgb888>>>();
    assert_same_items::<Multisampled<Multisampled<Rgb888>>, Multisampled<Rgb888>>();
    // Of both ways to smooth a picture the outer one.
    assert_same_items::<Multisampled<Antialiased<Rgb888>>, Multisampled<Rgb888>>();
    assert_same_items::<Antialiased<Multisampled<Rgb888>>, Antialiased<OnePass<Rgb888>>>();
    // Nothing is kept of samples.
    assert_eq!(
        size_of::<Memory<Multisampled<Rgb888>, 4, 4, 4, 4, 4>>(),
        size_of::<Memory<Rgb888, 4, 4, 4, 4, 4>>()
    );
}
