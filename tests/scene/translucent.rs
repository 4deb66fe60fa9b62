//! Translucent faces against single ones that are mixed in the order of their exact depths.

use embedded_graphics::{
    pixelcolor::{BinaryColor, Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor},
    scene::{Affine, Counted, Deep, DepthWidth, Fine, Look, Memory, Model, Orthographic, Pose, Prepared},
    shade::{ChannelColor, Fog, Foggy, Shading, Transformed, Translucent},
};

use crate::common::meshes::{Mesh, cube, torus};
use crate::common::{cases, config};
use crate::holes::{
    EvenHoles, HEIGHT, Holed, Pattern, UNTOUCHED, WIDTH, any_coordinates, check_painted, drawn, leak, single, skins,
    twice,
};
use crate::numbered_scene::area;
use crate::random_faces::{faces, pose};
use crate::reference::nearest_faces::Depth;
use crate::shaded_scene::unit;
use crate::snapped_faces::{at, camera, snapped, standard_pose};

type Many<L> = Memory<L, 400, 64, WIDTH, HEIGHT, 64>;
type One<L> = Memory<L, 400, 64, WIDTH, HEIGHT, 1>;

/// What is seen of a face at a pixel.
#[derive(Debug, Copy, Clone)]
struct Fragment {
    depth: i128,
    order: usize,
    word: u32,
    alpha: u8,
}

/// A colour over another one, as exact as its levels can be.
fn over(color: u32, below: u32, alpha: u8) -> u32 {
    let level = |shift: u32| {
        let [color, below] = [color, below].map(|word| word >> shift & 0xff);
        let sum = color * u32::from(alpha) + below * (255 - u32::from(alpha));
        ((2 * sum + 255) / 510) << shift
    };
    level(16) | level(8) | level(0)
}

/// Mixes the fragments of a pixel: opaque ones hide what is behind them, and those that are as near. `None` where it depends on
/// how depths are rounded.
fn mixed(mut fragments: Vec<Fragment>, most: i128) -> Option<u32> {
    fragments.retain(|fragment| fragment.alpha > 0);
    let is_opaque = |fragment: &&Fragment| fragment.alpha == 255;
    let nearest = fragments.iter().filter(is_opaque).map(|fragment| fragment.depth).max();
    let first = fragments
        .iter()
        .filter(is_opaque)
        .filter(|fragment| Some(fragment.depth) == nearest)
        .min_by_key(|fragment| fragment.order);
    let mut word = first.map_or(UNTOUCHED, |fragment| fragment.word);
    let mut seen: Vec<_> = fragments
        .iter()
        .filter(|fragment| fragment.alpha < 255 && nearest.is_none_or(|nearest| fragment.depth > nearest))
        .collect();
    seen.sort_by_key(|fragment| (fragment.depth, usize::MAX - fragment.order));
    let mut depths: Vec<_> = fragments.iter().map(|fragment| fragment.depth).collect();
    depths.sort_unstable();
    if depths
        .windows(2)
        .any(|pair| pair[0] != pair[1] && pair[1] - pair[0] <= most)
    {
        return None;
    }
    for fragment in seen {
        word = over(fragment.word, word, fragment.alpha);
    }
    Some(word)
}

/// Draws models with alphas, and each of their faces alone and opaque: in each pixel the fragments are mixed from the farthest to
/// the nearest. A model's skin is asked for with the face that is to be its first. Returns how many pixels have more than one layer, and how many could not be told.
fn check<L, T>(
    meshes: &[Mesh],
    skin: impl Fn(usize, usize) -> <L::Shading as Shading>::Skin<'static>,
    alphas: &[u8],
    pose: Pose,
) -> [usize; 2]
where
    L: Look<Color = Rgb888>,
    T: Look<Color = Rgb888, Shading = Translucent<L::Shading>>,
{
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let camera = camera(whole);
    let depth = if L::Depth::FRACTION_BITS == 16 {
        Depth::Bits16
    } else {
        Depth::Bits32
    };
    // Depths are interpolated with an error; coplanar faces have the same.
    let most = if matches!(depth, Depth::Bits16) { 2 } else { 200 };
    let mut fragments = vec![vec![]; WIDTH * HEIGHT];
    let mut alone = Box::new(Many::<L>::new());
    let mut model_and_face = (0, 0);
    for (order, (index, mesh)) in single(meshes).into_iter().enumerate() {
        let face = if model_and_face.0 == index { model_and_face.1 } else { 0 };
        model_and_face = (index, face + 1);
        let mesh = leak(mesh);
        let models = [Model::<L::Shading>::with_skin(mesh.face_set(), skin(index, face))
            .unwrap()
            .with_pose(pose)];
        let mut prepared = alone.prepare(&camera, &models).unwrap();
        let faces = snapped(&prepared);
        let picture = drawn(&mut prepared, whole, HEIGHT as u32, true);
        for face in faces {
            for (at, point) in whole.points().enumerate() {
                let [x, y] = [point.x, point.y].map(|pixels| i128::from(pixels) * unit::<L>());
                if face.covers(x, y) && picture[at] != UNTOUCHED {
                    fragments[at].push(Fragment {
                        depth: face.stored(x, y, depth),
                        order,
                        word: picture[at],
                        alpha: alphas[index],
                    });
                }
            }
        }
    }
    let meshes = leak(meshes.to_vec());
    let model = |index: usize| {
        Model::<T::Shading>::with_skin(meshes[index].face_set(), (skin(index, 0), alphas[index]))
            .unwrap()
            .with_pose(pose)
    };
    let models: Vec<_> = (0..meshes.len()).map(model).collect();
    let (mut many, mut one) = (Box::new(Many::<T>::new()), Box::new(One::<T>::new()));
    let picture = drawn(&mut many.prepare(&camera, &models).unwrap(), whole, HEIGHT as u32, true);
    let (mut layers, mut unsure) = (0, 0);
    for (at, fragments) in fragments.into_iter().enumerate() {
        let translucent = |fragment: &&Fragment| (1..255).contains(&fragment.alpha);
        layers += usize::from(fragments.iter().filter(translucent).count() > 1);
        let (x, y) = (at % WIDTH, at / WIDTH);
        match mixed(fragments.clone(), most) {
            None => unsure += 1,
            Some(word) => assert!(
                picture[at] == word,
                "{x}, {y}: {:x}, not {word:x} of {fragments:x?}",
                picture[at]
            ),
        }
    }
    for rows in [1, 3, HEIGHT as u32] {
        for always in [true, false] {
            let of_many = drawn(&mut many.prepare(&camera, &models).unwrap(), whole, rows, always);
            assert!(of_many == picture, "in bands of {rows} rows, {always}");
        }
        let of_one = drawn(&mut one.prepare(&camera, &models).unwrap(), whole, rows, true);
        assert!(of_one == picture, "with one slot, in bands of {rows} rows");
    }
    in_columns(&mut many.prepare(&camera, &models).unwrap(), &picture);
    check_painted(&mut many.prepare(&camera, &models).unwrap(), &picture);
    [layers, unsure]
}

/// A band that is narrower than the picture has the same pixels.
fn in_columns<L: Look<Color = Rgb888>>(prepared: &mut Prepared<'_, '_, L>, picture: &[u32]) {
    let columns = Rectangle::new(Point::new(13, 0), Size::new(21, HEIGHT as u32));
    let mut words = vec![UNTOUCHED; 21 * HEIGHT];
    prepared.draw(&mut Band::<Rgb888>::new(columns, &mut words).unwrap());
    let same = words
        .chunks(21)
        .zip(picture.chunks(WIDTH))
        .all(|(row, whole)| *row == whole[13..34]);
    assert!(same, "in a band of 21 columns");
}

/// A colour for each face of a model.
fn colors(faces: usize, seed: u32) -> &'static [Rgb888] {
    let color = |face: usize| {
        let word = (face as u32 + 1).wrapping_mul(0x9e_3779).wrapping_add(seed);
        Rgb888::new((word >> 16) as u8, (word >> 8) as u8, word as u8)
    };
    leak((0..faces).map(color).collect::<Vec<_>>())
}

fn any_alpha() -> impl Strategy<Value = u8> {
    prop_oneof![4 => any::<u8>(), 1 => prop::sample::select(vec![0, 1, 254, 255])]
}

proptest! {
    #![proptest_config(config(cases(12, 300)))]

    /// Faces that go through each other, of three models.
    #[test]
    fn fragments_are_mixed_from_the_farthest_to_the_nearest(
        meshes in prop::array::uniform3(faces(1_200, 6)),
        alphas in prop::array::uniform3(any_alpha()),
        pose in pose(1300..2500),
    ) {
        let skin = |index: usize, face: usize| &colors(12, index as u32 * 0x12_3457)[face..];
        check::<Rgb888, Translucent<Rgb888>>(&meshes, skin, &alphas, pose);
        check::<Fine<Deep<Rgb888>>, Fine<Deep<Translucent<Rgb888>>>>(&meshes, skin, &alphas, pose);
    }

    /// Faces that are cut, with the camera among them.
    #[test]
    fn cut_faces_are_mixed(
        meshes in [faces(1_200, 4), faces(1_200, 4)],
        alphas in prop::array::uniform2(any_alpha()),
        pose in pose(-300..700),
    ) {
        let skin = |index: usize, face: usize| &colors(12, index as u32 * 0x12_3457)[face..];
        check::<Rgb888, Translucent<Rgb888>>(&meshes, skin, &alphas, pose);
    }

    /// Two models in one place, with different holes, and models that go through each other.
    #[test]
    fn holes_of_translucent_faces_are_holes(
        meshes in [faces(1_000, 4), faces(1_000, 4)],
        same in any::<bool>(),
        patterns in any::<[Pattern; 2]>(),
        coordinates in [any_coordinates(12), any_coordinates(12)],
        alphas in prop::array::uniform2(any_alpha()),
        pose in pose(1300..2500),
    ) {
        let meshes = if same { twice(&meshes[0], 1) } else { meshes };
        let skins = skins(&patterns, &coordinates);
        check::<Holed, Translucent<Holed>>(&meshes, |index, _| skins[index], &alphas, pose);
        let numbers = coordinates.clone().map(|coordinates| &**leak(coordinates));
        let even = |index: usize, _| (numbers[index], 0x50_0000 + 0x50_0000 * index as u32);
        check::<EvenHoles, Translucent<EvenHoles>>(&meshes, even, &alphas, pose);
        check::<Fine<Deep<Holed>>, Fine<Deep<Translucent<Holed>>>>(&meshes, |index, _| skins[index], &alphas, pose);
    }

    /// The order of models does not matter where no two fragments are equally near.
    #[test]
    fn the_order_of_models_does_not_matter(
        meshes in prop::array::uniform3(faces(1_200, 4)),
        alphas in prop::array::uniform3(any_alpha()),
        pose in pose(1300..2500),
    ) {
        type Scene = Fine<Deep<Translucent<Rgb888>>>;
        let whole = area(WIDTH as u32, HEIGHT as u32);
        let mut memory = Box::new(Many::<Scene>::new());
        let mut picture = |order: [usize; 3]| {
            let models = order.map(|index| {
                let skin = (colors(12, index as u32 * 0x12_3457), alphas[index]);
                Model::with_skin(meshes[index].face_set(), skin).unwrap().with_pose(pose)
            });
            drawn(&mut memory.prepare(&camera(whole), &models).unwrap(), whole, 1, true)
        };
        let (one, other) = (picture([0, 1, 2]), picture([2, 0, 1]));
        let differing = one.iter().zip(&other).filter(|(one, other)| one != other).count();
        // Lines in which faces meet go through the centre of a pixel seldom.
        prop_assert!(differing <= 2, "{differing} pixels");
    }
}

/// A square at a distance.
fn square(half: i16, z: i16) -> Mesh {
    Mesh::new(
        vec![[-half, -half, z], [-half, half, z], [half, half, z], [half, -half, z]],
        vec![[0, 1, 2], [0, 2, 3]],
    )
}

/// Squares in one plane: the first translucent one lies over the others, and an opaque one over all that are as near.
#[test]
fn of_equally_near_fragments_the_first_lies_over_the_others() {
    let meshes = [500, 420, 340].map(|half| square(half, 1_000));
    let skin = |index: usize, face: usize| &colors(12, index as u32 * 0x31_2357)[face..];
    let [layers, unsure] = check::<Rgb888, Translucent<Rgb888>>(&meshes, skin, &[100, 90, 80], Pose::IDENTITY);
    assert!(layers > 300 && unsure == 0, "{layers}, {unsure}");
    for alphas in [[255, 90, 80], [100, 255, 80], [100, 90, 255], [255, 90, 255]] {
        let [_, unsure] = check::<Rgb888, Translucent<Rgb888>>(&meshes, skin, &alphas, Pose::IDENTITY);
        assert_eq!(unsure, 0);
    }
}

/// The same where the slots of opaque faces are not in the order of models, because the last face begins first: a translucent
/// face that comes before both, and is as near, decides nothing between them.
#[test]
fn equally_near_opaque_faces_are_in_order_behind_a_translucent_one() {
    let meshes = [340, 420, 500].map(|half| square(half, 1_000));
    let skin = |index: usize, face: usize| &colors(12, index as u32 * 0x31_2357)[face..];
    for alphas in [[100, 255, 255], [255, 100, 255], [255, 255, 100]] {
        let [_, unsure] = check::<Rgb888, Translucent<Rgb888>>(&meshes, skin, &alphas, Pose::IDENTITY);
        assert_eq!(unsure, 0);
    }
}

/// More layers than a byte counts columns, all of them seen.
#[test]
fn twenty_layers_are_mixed_in_any_order() {
    let meshes: Vec<_> = (0..20).map(|layer| square(400, 900 + layer * 7 % 20 * 30)).collect();
    let skin = |index: usize, face: usize| &colors(12, index as u32 * 0x17_3d57)[face..];
    let alphas: Vec<_> = (0..20).map(|layer| 40 + layer * 9).collect();
    let [layers, unsure] = check::<Rgb888, Translucent<Rgb888>>(&meshes, skin, &alphas, Pose::IDENTITY);
    assert!(layers > 300 && unsure == 0, "{layers}, {unsure}");
}

/// Rows that are wider than the columns whose layers are found together: narrow bands, which begin those elsewhere, have the same
/// pixels.
#[test]
fn wide_rows_are_mixed_as_narrow_ones() {
    let meshes = [torus(), cube(0.5)];
    let whole = area(200, 64);
    let models = [0, 1].map(|index| {
        let colors = colors(1_200, index as u32 * 0x12_3457);
        let pose = Pose::new(standard_pose(7).rotation, at(0, 0, 210));
        Model::<Translucent<Rgb888>>::with_skin(meshes[index].face_set(), (colors, [140, 90][index]))
            .unwrap()
            .with_pose(pose)
    });
    let mut memory = Box::new(Memory::<Translucent<Rgb888>, 2_000, 700, 200, 64, 200>::new());
    let camera = camera(whole);
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut words = |window: Rectangle| {
        let mut words = vec![UNTOUCHED; (window.size.width * window.size.height) as usize];
        prepared.draw(&mut Band::<Rgb888>::new(window, &mut words).unwrap());
        words
    };
    let picture = words(whole);
    let seen = |word: &&u32| **word != UNTOUCHED;
    let widest = picture.chunks(200).map(|row| row.iter().filter(seen).count()).max();
    assert!(widest > Some(100), "{widest:?}");
    for (left, width) in [(0, 31), (31, 64), (95, 65), (160, 40)] {
        let part = words(Rectangle::new(Point::new(left, 0), Size::new(width, 64)));
        let columns = left as usize..left as usize + width as usize;
        let same = part
            .chunks(width as usize)
            .zip(picture.chunks(200))
            .all(|(row, whole)| *row == whole[columns.clone()]);
        assert!(same, "{width} columns from {left} on");
    }
}

/// The picture of models in a look.
fn picture<L: Look<Color = Rgb888>>(models: &[Model<'_, L::Shading>]) -> Vec<u32> {
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let mut memory = Box::new(Many::<L>::new());
    drawn(&mut memory.prepare(&camera(whole), models).unwrap(), whole, 3, false)
}

/// Draws the models of a shading, all opaque and with one of them not there: what they are without alpha.
fn identities<'a, H, L, T>(meshes: &'a [Mesh; 2], skins: [H::Skin<'a>; 2], pose: Pose)
where
    H: Shading<Color = Rgb888>,
    L: Look<Color = Rgb888, Shading = H>,
    T: Look<Color = Rgb888, Shading = Translucent<H>>,
{
    let plain = |index: usize| {
        Model::<H>::with_skin(meshes[index].face_set(), skins[index])
            .unwrap()
            .with_pose(pose)
    };
    let with_alpha = |index: usize, alpha: u8| {
        Model::<Translucent<H>>::with_skin(meshes[index].face_set(), (skins[index], alpha))
            .unwrap()
            .with_pose(pose)
    };
    let opaque = picture::<T>(&[with_alpha(0, 255), with_alpha(1, 255)]);
    assert!(opaque == picture::<L>(&[plain(0), plain(1)]), "alpha 255");
    let first = picture::<T>(&[with_alpha(0, 255), with_alpha(1, 0)]);
    assert!(first == picture::<L>(&[plain(0)]), "alpha 0 of the second");
    let second = picture::<T>(&[with_alpha(0, 0), with_alpha(1, 255)]);
    assert!(second == picture::<L>(&[plain(1)]), "alpha 0 of the first");
}

proptest! {
    #![proptest_config(config(cases(24, 400)))]

    #[test]
    fn alpha_0_and_255_are_identities(
        meshes in [faces(1_200, 5), faces(1_200, 5)],
        patterns in any::<[Pattern; 2]>(),
        coordinates in [any_coordinates(15), any_coordinates(15)],
        pose in pose(-300..2500),
    ) {
        let flat = [colors(12, 0), colors(12, 0x12_3457)];
        identities::<Rgb888, Rgb888, Translucent<Rgb888>>(&meshes, flat, pose);
        identities::<Rgb888, Orthographic<Rgb888>, Orthographic<Translucent<Rgb888>>>(&meshes, flat, pose);
        let skins = skins(&patterns, &coordinates);
        type Lace = Fine<Deep<Translucent<Holed>>>;
        identities::<Holed, Fine<Deep<Holed>>, Lace>(leak(meshes.clone()), [skins[0], skins[1]], pose);
    }
}

/// Fog and maps around translucent models do what they do within.
#[test]
fn wrappers_forward_what_is_translucent() {
    let meshes = [square(400, 1_000), square(300, 1_200)];
    let fog = Fog {
        color: Rgb888::new(200, 30, 90),
        start: I16F16::from_num(800),
        end: I16F16::from_num(1_500),
        curve: Fog::LINEAR,
    };
    let flat = |index: usize| colors(2, index as u32 * 0x12_3457);
    let alpha = [120, 255];
    let outside = [0, 1].map(|index| {
        Model::<Foggy<Translucent<Rgb888>>>::with_skin(meshes[index].face_set(), ((flat(index), alpha[index]), fog))
            .unwrap()
    });
    let inside = [0, 1].map(|index| {
        Model::<Translucent<Foggy<Rgb888>>>::with_skin(meshes[index].face_set(), ((flat(index), fog), alpha[index]))
            .unwrap()
    });
    let opaque = inside.map(|model| Model::with_skin(*model.mesh(), (model.skin().0, 255)).unwrap());
    let [outside, inside, opaque] = [
        picture::<Foggy<Translucent<Rgb888>>>(&outside),
        picture::<Translucent<Foggy<Rgb888>>>(&inside),
        picture::<Translucent<Foggy<Rgb888>>>(&opaque),
    ];
    assert!(outside == inside && inside != opaque);

    let map = Affine::scaled([2, 1, 1].map(fixed::types::I8F24::from_num::<i32>));
    let outside = [0, 1].map(|index| {
        let skin = ((flat(index), alpha[index]), map);
        Model::<Transformed<Translucent<Rgb888>>>::with_skin(meshes[index].face_set(), skin).unwrap()
    });
    let inside = [0, 1].map(|index| {
        let skin = ((flat(index), map), alpha[index]);
        Model::<Translucent<Transformed<Rgb888>>>::with_skin(meshes[index].face_set(), skin).unwrap()
    });
    let [outside, inside] = [
        picture::<Transformed<Translucent<Rgb888>>>(&outside),
        picture::<Translucent<Transformed<Rgb888>>>(&inside),
    ];
    assert!(outside == inside);
}

/// Words in the order of a display are mixed as those of the machine are, and two colours by their threshold.
#[test]
fn words_in_any_order_and_two_colours_are_mixed() {
    let meshes = [square(400, 1_000), square(400, 1_200)];
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let colors = [[Rgb565::new(30, 7, 2); 2], [Rgb565::new(3, 50, 19); 2]];
    let models = [0, 1].map(|index| {
        let skin = (&colors[index][..], [77, 255][index]);
        Model::<Translucent<Rgb565>>::with_skin(meshes[index].face_set(), skin).unwrap()
    });
    let mut memory = Box::new(Many::<Translucent<Rgb565>>::new());
    let camera = camera(whole);
    let (mut little, mut big) = (vec![0u16; WIDTH * HEIGHT], vec![0u16; WIDTH * HEIGHT]);
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    prepared.draw(&mut Band::<Rgb565>::new(whole, &mut little).unwrap());
    prepared.draw(&mut Band::<Rgb565, zrow::band::BigEndian>::new(whole, &mut big).unwrap());
    assert!(little.iter().zip(&big).all(|(little, big)| little.swap_bytes() == *big));
    let middle = little[HEIGHT / 2 * WIDTH + WIDTH / 2];
    let expected = colors[0][0].over::<10>(colors[1][0], 77, Point::zero());
    assert_eq!(middle, expected.into_storage());

    let on = [BinaryColor::On; 2];
    let models = [Model::<Translucent<BinaryColor>>::with_skin(meshes[0].face_set(), (&on[..], 96)).unwrap()];
    let mut memory = Box::new(Many::<Translucent<BinaryColor>>::new());
    let mut words = vec![0; WIDTH * HEIGHT];
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    prepared.draw(&mut Band::<BinaryColor>::new(whole, &mut words).unwrap());
    let inner = Rectangle::new(Point::new(16, 16), Size::new(8, 8)).points();
    for point in inner {
        let expected = BinaryColor::On.over::<10>(BinaryColor::Off, 96, point).is_on();
        assert_eq!(
            words[point.y as usize * WIDTH + point.x as usize],
            u8::from(expected),
            "{point}"
        );
    }
}

/// Each translucent fragment is mixed once, and opaque faces are mixed with nothing.
#[test]
fn mixes_are_counted() {
    let meshes = [square(400, 1_000), square(300, 1_200)];
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let mut memory = Box::new(Many::<Counted<Translucent<Rgb888>>>::new());
    let mut blended = |alphas: [u8; 2]| {
        let models = [0, 1].map(|index| {
            let skin = (colors(2, 5), alphas[index]);
            Model::with_skin(meshes[index].face_set(), skin)
                .unwrap()
                .with_pose(Pose::new(zrow::scene::Rotation::IDENTITY, at(0, 0, 0)))
        });
        let camera = camera(whole);
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        drawn(&mut prepared, whole, 1, false);
        prepared.counters().fragments_blended
    };
    let [both, front, back, none] = [[90, 90], [90, 255], [255, 90], [255, 255]].map(&mut blended);
    assert!(front > 100 && both > front, "{both} {front}");
    // The square in front hides the one behind it.
    assert_eq!((back, none), (0, 0));
}

/// What is drawn with the depths of a row is hidden by translucent faces, but seen through their holes.
#[test]
fn holes_of_translucent_faces_hide_nothing_that_is_drawn_later() {
    let whole = area(WIDTH as u32, HEIGHT as u32);
    let coordinates = vec![[0, 4_096], [0, 0], [4_096, 0], [4_096, 4_096]];
    let pattern: Pattern = [[0x0f, 0xa5], [0, 0xff], [0xff, 0], [0x30, 0x0c]];
    let skins = skins(&[pattern, pattern], &[coordinates.clone(), coordinates]);
    let mesh = leak(square(500, 1_000));
    let mut memory = Box::new(Many::<Translucent<Holed>>::new());
    let mut behind = |alpha: u8| {
        let models = [Model::<Translucent<Holed>>::with_skin(mesh.face_set(), (skins[0], alpha)).unwrap()];
        let mut words = vec![UNTOUCHED; WIDTH * HEIGHT];
        let camera = camera(whole);
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        prepared.draw_with(&mut Band::<Rgb888>::new(whole, &mut words).unwrap(), |row| {
            let Ok(()) = row.at_depth(1).fill_solid(&whole, Rgb888::GREEN);
        });
        let green = Rgb888::GREEN.to_word();
        words.into_iter().map(|word| word == green).collect::<Vec<_>>()
    };
    let (through_glass, through_lace) = (behind(120), behind(255));
    assert!(through_glass == through_lace);
    let holes = through_lace.iter().filter(|&&is_green| is_green).count();
    assert!((400..1_800).contains(&holes), "{holes}");
}
