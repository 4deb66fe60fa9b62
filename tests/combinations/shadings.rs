//! Looks of shadings: each wrapper around each other one names the same look in both orders, and draws the picture of it.

use std::{any::type_name, marker::PhantomData};

use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::Band,
    geometry::{InputError, Sub4, Sub8, SubPixel, TooSmall},
    scene::{
        Counted, Deep, DepthWidth, Fine, Frame, Look, Memory, Model, OnePass, Pose, Rotation, ScreenPrecision,
        Unhurried, Whole,
    },
    shade::{Attributes, Bilinear, Clamped, CutOut, Foggy, Gouraud, LitTextured, Shading, Texels, Textured},
};

use crate::common::meshes;
use crate::numbered_scene::area;
use crate::same_looks::{Careful, assert_same_items};
use crate::shaded_scene::{FourColors, Shiny, Skinned, data};
use crate::snapped_faces::{at, camera, standard_pose};

/// A look of a shading that is named in full.
struct Named<H, S, D, const CLIPS: bool, const PASSES: bool>(PhantomData<(H, S, D)>);

impl<H: Shading, S: ScreenPrecision, D: DepthWidth + 'static, const CLIPS: bool, const PASSES: bool> Look
    for Named<H, S, D, CLIPS, PASSES>
{
    type Color = H::Color;
    type Shading = H;
    type Precision = S;
    type Depth = D;
    type Counting = ();
    type Silhouettes = ();
    type Visibility = ();
    type StoredAttributes = ();
    const CLIPS: bool = CLIPS;
    const DRAWS_IN_PASSES: bool = PASSES;
}

/// What a look does with a scene.
#[derive(Debug, PartialEq, Eq)]
struct Outcome {
    picture: Vec<u16>,
    /// What it says to a corner behind the camera, and what it draws.
    near: Result<Vec<u16>, InputError>,
    /// What it says to fewer slots than faces in a row, and what it draws.
    crowded: Result<Vec<u16>, InputError>,
    fraction_bits: u32,
    depth_bytes: usize,
}

fn outcome<L: Look<Color = Rgb565, Shading: Skinned>>() -> Outcome {
    let area = area(128, 64);
    let camera = camera(area);
    let (torus, cube) = (meshes::torus(), meshes::cube(0.5));
    let (of_torus, of_cube) = (data(torus.vertices.len()), data(cube.vertices.len()));
    let models = |pose: Pose| {
        [L::Shading::model(&torus, &of_torus), L::Shading::model(&cube, &of_cube)].map(|model| model.with_pose(pose))
    };
    let (turned, near) = (
        models(standard_pose(5)),
        models(Pose::new(Rotation::IDENTITY, at(0, 0, 300))),
    );
    let mut many = Box::new(Memory::<L, 900, 600, 128, 64, 256>::new());
    let mut few = Box::new(Memory::<L, 900, 600, 128, 64, 10>::new());
    let result = |memory: &mut Frame<'_, L>, models: &[Model<'_, L::Shading>]| {
        let mut words = vec![0; 128 * 64];
        let mut prepared = memory.prepare(&camera, models)?;
        prepared.draw(&mut Band::<Rgb565>::new(area, &mut words).unwrap());
        Ok(words)
    };
    Outcome {
        picture: result(&mut many.frame(), &turned).unwrap(),
        near: result(&mut many.frame(), &near),
        crowded: result(&mut few.frame(), &turned),
        fraction_bits: L::Precision::FRACTION_BITS,
        depth_bytes: size_of::<L::Depth>(),
    }
}

/// Calls a macro with a shading in every pair of wrappers, in both orders, and with the look that both name.
macro_rules! for_each_pair {
    ($check:ident, $shading:ident) => {
        $check!(Fine, Deep, $shading, Named<$shading, Sub8, u32, true, true>);
        $check!(Fine, Whole, $shading, Named<$shading, Sub8, u16, false, true>);
        $check!(Fine, OnePass, $shading, Named<$shading, Sub8, u16, true, false>);
        $check!(Deep, Whole, $shading, Named<$shading, Sub4, u32, false, true>);
        $check!(Deep, OnePass, $shading, Named<$shading, Sub4, u32, true, false>);
        $check!(Whole, OnePass, $shading, Named<$shading, Sub4, u16, false, false>);
    };
}

/// Compares the items of a pair of wrappers in both orders with those of the look that both name.
macro_rules! check_items {
    ($one:ident, $other:ident, $shading:ident, $named:ty) => {
        assert_same_items::<$one<$other<$shading>>, $named>();
        assert_same_items::<$other<$one<$shading>>, $named>();
    };
}

/// Compares the items of every pair of wrappers around a shading.
fn check_names<H: Skinned<Color = Rgb565>>() {
    assert_same_items::<H, Named<H, Sub4, u16, true, true>>();
    assert_same_items::<Whole<Deep<OnePass<Fine<H>>>>, Named<H, Sub8, u32, false, false>>();
    assert_same_items::<Careful<H>, Unhurried<Fine<Counted<OnePass<Deep<Whole<H>>>>>>>();
    for_each_pair!(check_items, H);
}

/// Whether a frame is refused because more than ten faces cross one of its rows, which is as many as the memory has slots for.
fn is_too_few(crowded: &Result<Vec<u16>, InputError>) -> bool {
    matches!(crowded, Err(InputError::TooSmall(TooSmall::ActiveFaces(11..))))
}

/// Compares the items of every pair of wrappers around a shading, and draws with two looks: one without cuts, passes and
/// shortcuts, and one with all of them. What they draw differs in nothing but what they refuse.
///
/// Only two looks draw, of which other tests draw with one as well, because each one takes a third of a second to compile.
fn check_pairs<H: Skinned<Color = Rgb565>>() {
    check_names::<H>();
    let (careful, full) = (outcome::<Careful<H>>(), outcome::<Fine<Deep<H>>>());
    assert!(
        careful.picture == full.picture,
        "{} draws something else",
        type_name::<H>()
    );
    assert_eq!(careful.near, Err(InputError::BeforeNearPlane { model: 0 }));
    assert!(is_too_few(&careful.crowded), "{:?}", careful.crowded.err());
    assert!(full.near.is_ok() && full.crowded.as_ref() == Ok(&full.picture));
    assert_eq!(
        (careful.fraction_bits, careful.depth_bytes),
        (full.fraction_bits, full.depth_bytes)
    );
}

#[test]
fn every_pair_of_wrappers_goes_around_gouraud_shading() {
    check_pairs::<Gouraud<Rgb565>>();
}

#[test]
fn every_pair_of_wrappers_goes_around_textures() {
    check_pairs::<Textured<Texels<Rgb565, 16, 16>>>();
}

#[test]
fn every_pair_of_wrappers_goes_around_lit_textures() {
    check_pairs::<LitTextured<Texels<Rgb565, 16, 16>>>();
}

#[test]
fn every_pair_of_wrappers_goes_around_palettes_and_holes() {
    check_pairs::<Textured<FourColors>>();
    check_pairs::<Textured<Bilinear<Clamped<CutOut<FourColors>>>>>();
    // Drawn in a fog below.
    check_names::<Textured<CutOut<FourColors>>>();
}

#[test]
fn every_pair_of_wrappers_goes_around_highlights_and_fog() {
    check_pairs::<Foggy<Gouraud<Rgb565, Shiny>>>();
    check_pairs::<Foggy<LitTextured<Texels<Rgb565, 16, 16>>>>();
    check_pairs::<Foggy<Textured<CutOut<FourColors>>>>();
    check_names::<Gouraud<Rgb565, Shiny>>();
    check_names::<Foggy<Gouraud<Rgb565>>>();
}

/// A scene that needs cuts and passes is drawn by the plainest look, and at another precision some edge moves.
fn check_plain<H: Skinned<Color = Rgb565>>() -> Outcome {
    let plain = outcome::<H>();
    assert!(plain.picture.iter().filter(|&&word| word != 0).count() > 1_000);
    assert!(plain.crowded.as_ref() == Ok(&plain.picture), "in passes");
    assert!(plain.near.is_ok());
    assert_eq!((plain.fraction_bits, plain.depth_bytes), (4, 2));
    assert!(
        outcome::<Fine<Deep<H>>>().picture != plain.picture,
        "1/256 pixel moves some edge"
    );
    plain
}

/// A scene that needs neither cuts nor passes is the same picture without either, and what needs one of them is an error; that
/// a look without both refuses both is what every pair of wrappers around a shading is checked for.
#[test]
fn shaded_looks_refuse_what_they_do_without() {
    check_plain::<Gouraud<Rgb565>>();
    check_plain::<Foggy<Textured<CutOut<FourColors>>>>();
    type Lit = LitTextured<Texels<Rgb565, 16, 16>>;
    let (plain, whole, one_pass) = (check_plain::<Lit>(), outcome::<Whole<Lit>>(), outcome::<OnePass<Lit>>());
    assert!(plain.picture == whole.picture && plain.picture == one_pass.picture);
    assert!(whole.crowded == plain.crowded && plain.near == one_pass.near);
    assert_eq!(whole.near, Err(InputError::BeforeNearPlane { model: 0 }));
    assert!(is_too_few(&one_pass.crowded), "{:?}", one_pass.crowded.err());
}

/// What a shading keeps of a vertex is its attributes, and a flat one keeps nothing.
#[test]
fn memory_of_a_vertex_is_that_of_its_attributes() {
    /// Bytes of a hundred vertices.
    fn grown<L: Look>() -> usize {
        size_of::<Memory<L, 104, 4, 4, 4, 4>>() - size_of::<Memory<L, 4, 4, 4, 4, 4>>()
    }
    fn attributes<H: Shading>() -> usize {
        size_of_val(&<H::Attributes as Attributes>::ZERO)
    }
    assert_eq!(grown::<Rgb565>(), 600);
    assert_eq!(
        (grown::<Gouraud<Rgb565>>(), attributes::<Gouraud<Rgb565>>()),
        (1_200, 6)
    );
    assert_eq!(grown::<Textured<Texels<Rgb565, 16, 16>>>(), 1_000);
    assert_eq!(grown::<LitTextured<Texels<Rgb565, 16, 16>>>(), 1_200);
    assert_eq!(grown::<Fine<Textured<Texels<Rgb565, 16, 16>>>>(), 1_600);
    // Where no face is cut, texture coordinates are read from the skin.
    assert_eq!(grown::<Whole<Gouraud<Rgb565>>>(), 1_200);
    assert_eq!(grown::<Whole<Textured<Texels<Rgb565, 16, 16>>>>(), 600);
    assert_eq!(grown::<Whole<LitTextured<Texels<Rgb565, 16, 16>>>>(), 800);
    assert_eq!(
        grown::<OnePass<Whole<Foggy<LitTextured<Texels<Rgb565, 16, 16>>>>>>(),
        1_000
    );
}
