//! Skins: levels and texels that come through unchanged, channels that never wrap, errors, and many skins at once.

use embedded_graphics::{
    pixelcolor::{
        Bgr555, Bgr666, BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888,
        raw::{RawU16, RawU24},
    },
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::{I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor},
    geometry::{InputError, TooSmall},
    scene::{Camera, FaceSet, Memory, Model, Pose, Rotation, Whole},
    shade::{
        ChannelColor, DirectionalLight, FlatLit, FlatLitSkin, Gouraud, GouraudSkin, Lambert, LitTextured,
        LitTexturedSkin, Shading, Texels, Textured, TexturedSkin,
    },
};

use crate::common::channels::Channels;
use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::numbered_scene::area;
use crate::random_faces::{faces, pose};
use crate::reference::nearest_faces::{Depth, owners};
use crate::shaded_scene::{SmallMemory, TEXELS, UNTOUCHED, camera_in_units, covered, flat_corners, triangle, words};
use crate::snapped_faces::{at, camera, snapped};

/// Full ambient light alone.
const FULL: Lambert<0> = Lambert {
    ambient: U0F16::MAX,
    lights: [],
    points: [],
};

/// The words of an area of a scene of one model, on words of the background.
fn drawn<L: Shading>(
    model: Model<'_, L>,
    camera: &Camera,
    background: <L::Color as BandColor>::Word,
) -> Vec<<L::Color as BandColor>::Word> {
    let area = camera.viewport().to_rectangle();
    let mut memory = Box::new(Memory::<L, 64, 16, 128, 79, 16>::new());
    let mut words = vec![background; (area.size.width * area.size.height) as usize];
    let models = [model];
    memory
        .prepare(camera, &models)
        .unwrap()
        .draw(&mut Band::<L::Color>::new(area, &mut words).unwrap());
    words
}

/// A square that fills a picture of 4 x 4 pixels.
fn square() -> Mesh {
    let vertices = vec![[-900, -900, 0], [-900, 900, 0], [900, 900, 0], [900, -900, 0]];
    Mesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]])
}

fn before_camera() -> Pose {
    Pose::new(Rotation::IDENTITY, at(0, 0, 600))
}

type Smooth<C> = Gouraud<C, Lambert<0>>;
type Flat<C> = FlatLit<C, Lambert<0>>;

fn smooth_skin<C>(colors: &[C]) -> GouraudSkin<'_, C, Lambert<0>> {
    GouraudSkin {
        colors,
        normals: &[],
        lights: FULL,
    }
}

fn flat_skin<C>(colors: &[C]) -> FlatLitSkin<'_, C, Lambert<0>> {
    FlatLitSkin {
        colors,
        normals: &[[0; 2]; 2],
        lights: FULL,
    }
}

/// The attributes of a vertex as a face has them at a pixel whose centre is that vertex, in 1/65,536 unit: half a unit more,
/// so that the upper half is the nearest unit, and off by `error`.
fn at_pixel(attributes: [i16; 3], error: i32) -> [i32; 3] {
    attributes.map(|attribute| (i32::from(attribute) << 16) + (1 << 15) + error)
}

/// The greatest error of an attribute at a pixel, in 1/65,536 unit, which the tests of `shading_attributes` do not let pass.
const MOST_ERROR: i32 = 1_024;

/// A vertex and a face of one colour under full light have that colour.
fn full_light_keeps<C: ChannelColor + std::fmt::Debug>(colors: impl Iterator<Item = C>, background: C)
where
    C::Word: std::fmt::Debug + PartialEq,
{
    let (mesh, camera, pose) = (square(), camera(area(4, 4)), before_camera());
    for color in colors {
        let (colors, under) = (&[color], background.to_word());
        let skin = smooth_skin(colors);
        let lights = Smooth::<C>::uniforms(&skin, &pose, &camera);
        let attributes = Smooth::<C>::vertex(&skin, &lights, 0, [-900, -900, 0]);
        let smooth =
            [-MOST_ERROR, 0, MOST_ERROR].map(|error| Smooth::<C>::fragment(&skin, under, &at_pixel(attributes, error)));
        let skin = flat_skin(colors);
        let lights = Flat::<C>::uniforms(&skin, &pose, &camera);
        let face = Flat::<C>::face(&skin, &lights, &mesh.face_set(), 0).unwrap();
        let flat = Flat::<C>::fragment(&skin, face, &());
        assert_eq!(
            (smooth, flat),
            ([Some(color.to_word()); 3], Some(color.to_word())),
            "{color:?}"
        );
    }
}

/// A model of one colour under full light has that colour in each pixel.
fn full_light_draws<C: ChannelColor, H: Shading<Color = C>>(
    colors: impl Iterator<Item = C>,
    background: C,
    skin: for<'s> fn(&'s [C]) -> H::Skin<'s>,
) where
    C::Word: std::fmt::Debug + PartialEq,
{
    let (mesh, camera) = (square(), camera(area(4, 4)));
    for color in colors {
        let colors = [color];
        let model = Model::<H>::with_skin(mesh.face_set(), skin(&colors)).unwrap();
        let words = drawn(model.with_pose(before_camera()), &camera, background.to_word());
        assert!(words.iter().all(|word| *word == color.to_word()), "{words:?}");
    }
}

#[test]
fn full_light_keeps_every_color() {
    full_light_keeps(
        (0..=u16::MAX).map(|word| Rgb565::from(RawU16::new(word))),
        Rgb565::new(1, 2, 3),
    );
    full_light_keeps(
        (0..1 << 15).map(|word| Bgr555::from(RawU16::new(word))),
        Bgr555::new(1, 2, 3),
    );
    full_light_keeps((0..=255).map(Gray8::new), Gray8::new(9));
    full_light_keeps((0..16).map(Gray4::new), Gray4::new(9));
    full_light_keeps((0..4).map(Gray2::new), Gray2::new(2));
    full_light_keeps([BinaryColor::Off].into_iter(), BinaryColor::On);
    full_light_keeps([BinaryColor::On].into_iter(), BinaryColor::Off);
    let sampled = (0..1u32 << 24).step_by(4_099);
    full_light_keeps(sampled.clone().map(rgb888), Rgb888::new(1, 2, 3));
    full_light_keeps(
        sampled.map(|word| Bgr666::new((word >> 16) as u8 & 63, (word >> 8) as u8 & 63, word as u8 & 63)),
        Bgr666::new(1, 2, 3),
    );
}

fn rgb888(word: u32) -> Rgb888 {
    Rgb888::from(RawU24::new(word))
}

/// Scenes draw what shadings say: channels of most and of fewest bits, in both orders.
#[test]
fn full_light_draws_every_color() {
    let (on, off) = (BinaryColor::On, BinaryColor::Off);
    for (color, background) in [(on, off), (off, on)] {
        full_light_draws::<_, Smooth<BinaryColor>>([color].into_iter(), background, smooth_skin);
        full_light_draws::<_, Flat<BinaryColor>>([color].into_iter(), background, flat_skin);
    }
    let sampled = || (0..1u32 << 24).step_by(4_099).map(rgb888);
    full_light_draws::<_, Smooth<Rgb888>>(sampled(), Rgb888::new(1, 2, 3), smooth_skin);
    full_light_draws::<_, Flat<Rgb888>>(sampled(), Rgb888::new(1, 2, 3), flat_skin);
    full_light_draws::<_, Smooth<Rgb565>>(
        (0..=u16::MAX).map(|word| Rgb565::from(RawU16::new(word))),
        Rgb565::new(1, 2, 3),
        smooth_skin,
    );
    full_light_draws::<_, Smooth<Bgr555>>(
        (0..1 << 15).map(|word| Bgr555::from(RawU16::new(word))),
        Bgr555::new(1, 2, 3),
        smooth_skin,
    );
}

/// A pixel in which each channel is that of the darkest corner has exactly that level, however far its attributes may be off,
/// and so has one of the brightest corner: between the two no level is left.
fn ends_are_kept<C: Channels + ChannelColor>(levels: [[u32; 3]; 3])
where
    C::Word: std::fmt::Debug + PartialEq,
{
    let levels = levels.map(|levels| [0, 1, 2].map(|channel| levels[channel] * C::MAX[channel] / 255));
    let colors = levels.map(C::from_channels);
    let skin = smooth_skin(&colors);
    let lights = Smooth::<C>::uniforms(&skin, &before_camera(), &camera(area(4, 4)));
    let corners = [0, 1, 2].map(|corner| Smooth::<C>::vertex(&skin, &lights, corner, [0; 3]));
    for end in [i16::min, i16::max] {
        let attributes =
            [0, 1, 2].map(|channel| corners.map(|corner| corner[channel]).into_iter().reduce(end).unwrap());
        let end = if end(0, 1) == 0 { u32::min } else { u32::max };
        let levels = [0, 1, 2].map(|channel| levels.map(|levels| levels[channel]).into_iter().reduce(end).unwrap());
        for error in [-MOST_ERROR, MOST_ERROR] {
            let word = Smooth::<C>::fragment(&skin, colors[0].to_word(), &at_pixel(attributes, error));
            assert_eq!(
                word,
                Some(C::from_channels(levels).to_word()),
                "{corners:?}, {levels:?}"
            );
        }
    }
}

/// Draws a triangle whose corners have channels of 0 or the greatest level, or others, and checks that each pixel is
/// between them.
fn channels_stay_between<C: Channels>(corners: [[i16; 3]; 3], levels: [[u32; 3]; 3]) {
    let (mesh, camera) = (triangle(corners), camera_in_units());
    let levels = levels.map(|levels| [0, 1, 2].map(|channel| levels[channel] * C::MAX[channel] / 255));
    let skin = GouraudSkin {
        colors: &levels.map(C::from_channels),
        normals: &[],
        lights: FULL,
    };
    let area = camera.viewport().to_rectangle();
    let model = Model::<Gouraud<C, Lambert<0>>>::with_skin(mesh.face_set(), skin).unwrap();
    let models = [model];
    let mut memory = Box::new(SmallMemory::<Gouraud<C, Lambert<0>>>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let faces = snapped(&prepared);
    let mut words = vec![C::from_channels([0; 3]).to_word(); (area.size.width * area.size.height) as usize];
    let mut band = Band::<C>::new(area, &mut words).unwrap();
    prepared.draw(&mut band);
    let colors: Vec<C> = band.colors().collect();
    for (point, _, index) in faces.iter().flat_map(|face| covered(face, area, 16)) {
        for (channel, level) in colors[index].channels().into_iter().enumerate() {
            let of_corners = levels.map(|levels| levels[channel]);
            let between = *of_corners.iter().min().unwrap()..=*of_corners.iter().max().unwrap();
            assert!(between.contains(&level), "{point:?}: {level} is not in {between:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(cases(60, 2_000)))]

    #[test]
    fn channels_never_wrap(
        corners in flat_corners(),
        levels in prop::array::uniform3(prop::array::uniform3(prop_oneof![Just(0u32), Just(255), 0u32..256])),
    ) {
        channels_stay_between::<Rgb888>(corners, levels);
        channels_stay_between::<Rgb565>(corners, levels);
        channels_stay_between::<Bgr555>(corners, levels);
        channels_stay_between::<BinaryColor>(corners, levels);
        ends_are_kept::<Gray8>(levels);
        ends_are_kept::<Gray4>(levels);
        ends_are_kept::<Gray2>(levels);
        ends_are_kept::<Bgr666>(levels);
    }

    /// A texture under full light is the texture, also where light is from a direction.
    #[test]
    fn full_light_keeps_textures(
        mesh in faces(900, 6),
        coordinates in prop::collection::vec(prop::array::uniform2(-8_000i16..8_000), 18),
        normals in prop::collection::vec(any::<[i8; 2]>(), 18),
        pose in pose(-200..2500),
    ) {
        let camera = camera(area(48, 40));
        let skin = TexturedSkin { image: &TEXELS, coordinates: &coordinates };
        let textured = Model::<Textured<Texels<Rgb565, 16, 16>>>::with_skin(mesh.face_set(), skin).unwrap();
        let expected = drawn(textured.with_pose(pose), &camera, 0);
        let light = DirectionalLight::from_direction([I16F16::ONE; 3], U0F16::MAX).unwrap();
        let lights = Lambert { ambient: U0F16::MAX, lights: [light], points: [] };
        let skin = LitTexturedSkin { image: &TEXELS, coordinates: &coordinates, normals: &normals, lights };
        let lit = Model::<LitTextured<Texels<Rgb565, 16, 16>>>::with_skin(mesh.face_set(), skin).unwrap();
        prop_assert!(drawn(lit.with_pose(pose), &camera, 0) == expected);
    }
}

/// Each texel of a texture that is as large as the picture is in its own pixel, under full light as well, and half as
/// bright in half of the light.
#[test]
fn a_texture_that_faces_the_camera_is_copied() {
    let camera = Camera::new(area(16, 16), I16F16::from_num(128)).unwrap();
    // Eight pixels on each side of the middle, at a distance of the focal length's pixels times 128.
    let vertices = [
        [-1_024, 1_024, 1_024],
        [1_024, 1_024, 1_024],
        [1_024, -1_024, 1_024],
        [-1_024, -1_024, 1_024],
    ];
    let coordinates = [[0, 0], [4_096, 0], [4_096, 4_096], [0, 4_096]];
    let mesh = FaceSet::new(&vertices, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let skin = TexturedSkin {
        image: &TEXELS,
        coordinates: &coordinates,
    };
    let model = Model::<Textured<Texels<Rgb565, 16, 16>>>::with_skin(mesh, skin).unwrap();
    assert_eq!(drawn(model, &camera, 0), TEXELS.concat());

    let dark = DirectionalLight::from_direction([I16F16::ONE; 3], U0F16::ZERO).unwrap();
    let lit = |ambient| {
        let lights = Lambert {
            ambient,
            lights: [dark],
            points: [],
        };
        let skin = LitTexturedSkin {
            image: &TEXELS,
            coordinates: &coordinates,
            normals: &[[0; 2]; 4],
            lights,
        };
        let model = Model::<LitTextured<Texels<Rgb565, 16, 16>>>::with_skin(mesh, skin).unwrap();
        drawn(model, &camera, 0)
    };
    assert_eq!(lit(U0F16::MAX), TEXELS.concat());
    for (half, full) in lit(U0F16::from_num(0.5)).into_iter().zip(TEXELS.concat()) {
        let [half, full] = [half, full].map(|word| Rgb565::from(RawU16::new(word)));
        let pairs = [(half.r(), full.r()), (half.g(), full.g()), (half.b(), full.b())];
        // Light has 32 steps, of which the one in the middle is left out: 15/32 or 17/32.
        let steps = |full: u8| [15, 17].map(|step| (u32::from(full) * step / 32) as u8);
        assert!(
            pairs.iter().all(|&(half, full)| steps(full).contains(&half)),
            "{half:?} of {full:?}"
        );
    }
}

/// What is too short says how much would do; with as much a model can be drawn.
#[test]
fn skins_that_are_too_short_are_errors() {
    let mesh = square();
    let (colors, normals, coordinates) = ([Rgb565::RED; 4], [[0; 2]; 4], [[0; 2]; 4]);
    let lights = Lambert {
        ambient: U0F16::MAX,
        lights: [],
        points: [],
    };
    let light = DirectionalLight::from_direction([I16F16::ONE; 3], U0F16::MAX).unwrap();
    let directed = Lambert {
        ambient: U0F16::MAX,
        lights: [light],
        points: [],
    };

    let gouraud = |colors: usize, normals: usize| {
        let skin = GouraudSkin {
            colors: &[Rgb565::RED; 4][..colors],
            normals: &[[0; 2]; 4][..normals],
            lights: directed,
        };
        Model::<Gouraud<Rgb565>>::with_skin(mesh.face_set(), skin).err()
    };
    assert_eq!(gouraud(0, 4), Some(TooSmall::Colors(1)));
    assert_eq!(gouraud(1, 3), Some(TooSmall::Normals(4)));
    assert_eq!(gouraud(1, 4), None);
    let flat_lit = |colors: usize, normals: usize| {
        let skin = FlatLitSkin {
            colors: &[Rgb565::RED; 4][..colors],
            normals: &[[0; 2]; 4][..normals],
            lights: directed,
        };
        Model::<FlatLit<Rgb565>>::with_skin(mesh.face_set(), skin).err()
    };
    assert_eq!(flat_lit(0, 4), Some(TooSmall::Colors(1)));
    assert_eq!(flat_lit(1, 1), Some(TooSmall::Normals(2)));
    assert_eq!(flat_lit(1, 2), None);
    let unlit = GouraudSkin {
        colors: &colors,
        normals: &[],
        lights,
    };
    assert!(Model::<Gouraud<Rgb565, Lambert<0>>>::with_skin(mesh.face_set(), unlit).is_ok());

    let textured = |count: usize| {
        let skin = TexturedSkin {
            image: &TEXELS,
            coordinates: &coordinates[..count],
        };
        Model::<Textured<Texels<Rgb565, 16, 16>>>::with_skin(mesh.face_set(), skin).err()
    };
    assert_eq!(textured(3), Some(TooSmall::TextureCoordinates(4)));
    assert_eq!(textured(4), None);

    let lit = |count: usize, count_of_normals: usize| {
        let (coordinates, normals) = (&coordinates[..count], &normals[..count_of_normals]);
        let skin = LitTexturedSkin {
            image: &TEXELS,
            coordinates,
            normals,
            lights: directed,
        };
        Model::<LitTextured<Texels<Rgb565, 16, 16>>>::with_skin(mesh.face_set(), skin).err()
    };
    assert_eq!(lit(3, 0), Some(TooSmall::TextureCoordinates(4)));
    assert_eq!(lit(4, 3), Some(TooSmall::Normals(4)));
    assert_eq!(lit(4, 4), None);

    let flat = Model::<Rgb565>::with_skin(mesh.face_set(), &colors[..1]).err();
    assert_eq!(flat, Some(TooSmall::Colors(2)));
}

/// After each error of preparing, the memory draws the next frame as a new one does.
#[test]
fn memory_is_of_use_after_an_error() {
    type Look = Whole<LitTextured<Texels<Rgb565, 16, 16>>>;
    let (mesh, camera) = (square(), camera(area(8, 8)));
    let light = DirectionalLight::from_direction([I16F16::ONE; 3], U0F16::MAX).unwrap();
    let skin = LitTexturedSkin {
        image: &TEXELS,
        coordinates: &[[0, 0], [0, 4_096], [4_096, 4_096], [4_096, 0]],
        normals: &[[0; 2]; 4],
        lights: Lambert {
            ambient: U0F16::MAX,
            lights: [light],
            points: [],
        },
    };
    let model = Model::<LitTextured<Texels<Rgb565, 16, 16>>>::with_skin(mesh.face_set(), skin).unwrap();
    let good = [model.with_pose(before_camera())];
    let picture = |memory: &mut Memory<Look, 4, 2, 8, 8, 2>| {
        let mut words = [0; 64];
        memory
            .prepare(&camera, &good)
            .unwrap()
            .draw(&mut Band::<Rgb565>::new(area(8, 8), &mut words).unwrap());
        words
    };
    let mut memory = Memory::<Look, 4, 2, 8, 8, 2>::new();
    let expected = picture(&mut memory);
    assert!(expected.iter().all(|&word| word != 0));

    let (twice, behind) = ([good[0]; 2], [good[0], model]);
    assert_eq!(
        memory.prepare(&camera, &twice).err(),
        Some(InputError::TooSmall(TooSmall::Vertices(8)))
    );
    assert_eq!(picture(&mut memory), expected);
    let error = memory.prepare(&camera, &behind[1..]).err();
    assert_eq!(error, Some(InputError::BeforeNearPlane { model: 0 }));
    assert_eq!(picture(&mut memory), expected);
    let wide = Camera::new(area(9, 8), I16F16::from_num(128)).unwrap();
    assert_eq!(
        memory.prepare(&wide, &good).err(),
        Some(InputError::TooSmall(TooSmall::Columns(9)))
    );
    assert_eq!(picture(&mut memory), expected);
}

/// A shading whose pixels say which skin they have, and what the vertices of the model are numbered with.
#[derive(Debug)]
struct Marked;

impl Shading for Marked {
    type Color = Rgb888;
    type Skin<'a> = u16;
    type Uniforms = u16;
    type Attributes = [i16; 1];

    fn uniforms(skin: &u16, _: &Pose, _: &Camera) -> u16 {
        *skin
    }

    fn vertex(_: &u16, uniforms: &u16, _: usize, _: [i32; 3]) -> [i16; 1] {
        [*uniforms as i16]
    }

    fn face(_: &u16, uniforms: &u16, _: &FaceSet<'_>, _: usize) -> Option<u32> {
        Some(u32::from(*uniforms))
    }

    fn fragment(skin: &u16, face: u32, [number]: &[i32; 1]) -> Option<u32> {
        // All three are the model's own, or the word is no number of a model.
        let same = face == u32::from(*skin) && *number >> 16 == i32::from(*skin);
        Some(if same { face } else { u32::MAX })
    }
}

/// Draws thirty models in one place or another, each with a number for its skin, and compares all pixels.
fn check_models(meshes: &[Mesh], picture: Rectangle, active: bool) {
    let models: Vec<_> = (0..)
        .zip(meshes)
        .map(|(number, mesh)| Model::<Marked>::with_skin(mesh.face_set(), number).unwrap())
        .collect();
    let camera = camera(picture);
    let numbers: Vec<_> = (0u32..)
        .zip(meshes)
        .flat_map(|(number, mesh)| vec![number; mesh.faces.len()])
        .collect();
    let (mut all, mut few) = (
        Box::new(Memory::<Marked, 2_000, 400, 64, 64, 64>::new()),
        Box::new(Memory::<Marked, 2_000, 400, 64, 64, 3>::new()),
    );
    let mut prepared = if active {
        all.prepare(&camera, &models)
    } else {
        few.prepare(&camera, &models)
    }
    .unwrap();
    let expected = owners(&snapped(&prepared), picture, 16, Depth::Bits16);
    let drawn = words(&mut prepared, picture);
    for ((point, drawn), owner) in picture.points().zip(drawn).zip(expected) {
        let expected = owner.map_or(UNTOUCHED, |face| numbers[face]);
        assert_eq!(drawn, expected, "{point:?}");
    }
}

proptest! {
    #![proptest_config(config(cases(30, 1_000)))]

    /// Faces parallel to the screen, at distances that differ or are equal, some of them cut.
    #[test]
    fn each_of_thirty_models_has_its_own_skin(
        corners in prop::collection::vec(prop::array::uniform3(prop::array::uniform2(-900i16..900)), 60),
        distances in prop::collection::vec(0i16..20, 30),
        shares in prop::collection::vec(any::<bool>(), 30),
    ) {
        let mesh = |index: usize| {
            let distance = 130 + 60 * distances[index];
            // A mesh of one face or two, and some that have vertices beyond the guard band.
            let scale = if shares[index] { 1 } else { 5 };
            let vertices = corners[2 * index..2 * index + 2].concat();
            let vertices = vertices.iter().map(|&[x, y]| [scale * x, scale * y, distance]).collect();
            let faces = if shares[index] { vec![[0, 1, 2]] } else { vec![[0, 1, 2], [3, 4, 5]] };
            Mesh::new(vertices, faces).two_sided()
        };
        let meshes: Vec<_> = (0..30).map(mesh).collect();
        check_models(&meshes, area(48, 40), true);
        check_models(&meshes, area(48, 40), false);
    }
}
