//! Looks: each wrapper around each other one, in both orders, names the same look, and draws the picture of it.

use embedded_graphics::{pixelcolor::Rgb888, primitives::Rectangle};
use fixed::types::I8F24;
use zrow::{
    band::Band,
    geometry::{InputError, Sub4, Sub8, SubPixel, TooSmall},
    scene::{
        Antialiased, Camera, Counted, Deep, DoubleSided, Fine, Look, Memory, Model, OnePass, Orthographic, Pose,
        Rotation, Unhurried, VisibleBy, Whole,
    },
    visible::SpanScanLine,
};
use zrow_methods::LookOf;

use crate::common::meshes;
use crate::numbered_scene::{Scene, area};
use crate::same_looks::{SameTypes, assert_same_items};
use crate::snapped_faces::{at, camera, standard_pose};

/// A look whose faces are seen by the scan line with spans.
type BySpans<L> = VisibleBy<SpanScanLine<9>, L>;

/// What a look does with a scene.
#[derive(Debug, PartialEq, Eq)]
struct Outcome {
    picture: Vec<u32>,
    /// What it says to a corner behind the camera, where faces may have to be cut.
    behind: Option<InputError>,
    /// What it says to fewer slots than faces in a row.
    crowded: Option<InputError>,
    fraction_bits: u32,
    depth_bytes: usize,
}

fn picture<L: Look<Color = Rgb888, Shading = Rgb888>>(
    models: &[Model<'_, Rgb888>],
    camera: &Camera,
    area: Rectangle,
) -> Vec<u32> {
    let mut memory = Box::new(Memory::<L, 304, 600, 128, 64, 128>::new());
    let mut prepared = memory.prepare(camera, models).unwrap();
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    prepared.draw(&mut Band::<Rgb888>::new(area, &mut words).unwrap());
    words
}

fn outcome<L: Look<Color = Rgb888, Shading = Rgb888>>() -> Outcome {
    let (area, scene) = (area(128, 64), Scene::new(vec![meshes::torus(), meshes::cube(0.5)]));
    let camera = camera(area).with_scale(I8F24::from_num(0.05)).unwrap();
    let turned = scene.models(standard_pose(5));
    let near = scene.models(Pose::new(Rotation::IDENTITY, at(0, 0, 300)));
    let mut few = Box::new(Memory::<L, 900, 600, 128, 64, 10>::new());
    Outcome {
        picture: picture::<L>(&turned, &camera, area),
        behind: few.prepare(&camera, &near).err(),
        crowded: few.prepare(&camera, &turned).err(),
        fraction_bits: L::Precision::FRACTION_BITS,
        depth_bytes: size_of::<L::Depth>(),
    }
}

/// Whether all types and constants of a look are those of another one, and it draws and refuses what that one does.
fn check<L: SameTypes<Same> + Look<Color = Rgb888, Shading = Rgb888>, Same: Look<Color = Rgb888, Shading = Rgb888>>() {
    assert_same_items::<Same, L>();
    let (found, expected) = (outcome::<L>(), outcome::<Same>());
    assert!(found.picture == expected.picture, "the picture is another one");
    assert_eq!(
        Outcome {
            picture: Vec::new(),
            ..found
        },
        Outcome {
            picture: Vec::new(),
            ..expected
        }
    );
}

/// Whether a look draws the picture of another one, and refuses what it says: a corner behind the camera where it cuts no
/// faces, and too few slots where it does not draw in passes.
fn check_picture<L: Look<Color = Rgb888, Shading = Rgb888>, Same: Look<Color = Rgb888, Shading = Rgb888>>() {
    let found = outcome::<L>();
    assert!(found.picture == outcome::<Same>().picture, "the picture is another one");
    let too_few = |error: Option<InputError>| matches!(error, Some(InputError::TooSmall(TooSmall::ActiveFaces(11..))));
    assert_eq!(too_few(found.crowded), !L::DRAWS_IN_PASSES);
    match found.behind {
        Some(InputError::BeforeNearPlane { model: 0 } | InputError::BeyondGuardBand { model: 0 }) => assert!(!L::CLIPS),
        None => assert!(L::CLIPS && L::DRAWS_IN_PASSES),
        error => assert!(L::CLIPS && too_few(error), "{error:?}"),
    }
}

/// For each line of a list, compares the types and constants of looks with two wrappers, in both orders, with those of the look
/// that the line names.
macro_rules! check_orders {
    ($($one:ident<$other:ident<Rgb888>> as $named:ty;)+) => {$(
        assert_same_items::<$one<$other<Rgb888>>, $named>();
        assert_same_items::<$other<$one<Rgb888>>, $named>();
    )+};
}

#[test]
fn each_wrapper_changes_one_thing() {
    let plain = outcome::<Rgb888>();
    assert_eq!((plain.fraction_bits, plain.depth_bytes), (4, 2));
    assert_eq!((&plain.behind, &plain.crowded), (&None, &None));
    assert_same_items::<Rgb888, LookOf<Rgb888, Sub4, u16, true, true>>();
    assert_same_items::<Fine<Rgb888>, LookOf<Rgb888, Sub8, u16, true, true>>();
    assert_same_items::<Deep<Rgb888>, LookOf<Rgb888, Sub4, u32, true, true>>();
    assert_same_items::<Whole<Rgb888>, LookOf<Rgb888, Sub4, u16, false, true>>();
    assert_same_items::<OnePass<Rgb888>, LookOf<Rgb888, Sub4, u16, true, false>>();
    check::<Whole<Deep<OnePass<Fine<Rgb888>>>>, LookOf<Rgb888, Sub8, u32, false, false>>();
    check_picture::<Whole<Rgb888>, Rgb888>();
    check_picture::<OnePass<Rgb888>, Rgb888>();
    assert_same_items::<Orthographic<Rgb888>, Orthographic<LookOf<Rgb888, Sub4, u16, true, true>>>();

    assert!(
        outcome::<Orthographic<Rgb888>>().picture != plain.picture,
        "what is nearer is not larger"
    );
    assert!(
        outcome::<Fine<Rgb888>>().picture != plain.picture,
        "1/256 pixel moves some edge"
    );
}

/// All types and constants of a look are the same in whichever order its wrappers are, so that only one of both has to be
/// drawn: each look that draws takes half a second to compile.
#[test]
fn every_pair_of_wrappers_names_the_same_in_both_orders() {
    check_orders! {
        Fine<Deep<Rgb888>> as LookOf<Rgb888, Sub8, u32, true, true>;
        Fine<Whole<Rgb888>> as LookOf<Rgb888, Sub8, u16, false, true>;
        Fine<OnePass<Rgb888>> as LookOf<Rgb888, Sub8, u16, true, false>;
        Deep<Whole<Rgb888>> as LookOf<Rgb888, Sub4, u32, false, true>;
        Deep<OnePass<Rgb888>> as LookOf<Rgb888, Sub4, u32, true, false>;
        Whole<OnePass<Rgb888>> as LookOf<Rgb888, Sub4, u16, false, false>;
        Orthographic<Fine<Rgb888>> as Orthographic<LookOf<Rgb888, Sub8, u16, true, true>>;
        Orthographic<Deep<Rgb888>> as Orthographic<LookOf<Rgb888, Sub4, u32, true, true>>;
        Orthographic<Whole<Rgb888>> as Orthographic<LookOf<Rgb888, Sub4, u16, false, true>>;
        Orthographic<OnePass<Rgb888>> as Orthographic<LookOf<Rgb888, Sub4, u16, true, false>>;
        DoubleSided<Fine<Rgb888>> as DoubleSided<LookOf<Rgb888, Sub8, u16, true, true>>;
        DoubleSided<Deep<Rgb888>> as DoubleSided<LookOf<Rgb888, Sub4, u32, true, true>>;
        DoubleSided<Whole<Rgb888>> as DoubleSided<LookOf<Rgb888, Sub4, u16, false, true>>;
        DoubleSided<OnePass<Rgb888>> as DoubleSided<LookOf<Rgb888, Sub4, u16, true, false>>;
        Antialiased<Fine<Rgb888>> as Antialiased<LookOf<Rgb888, Sub8, u16, true, true>>;
        Antialiased<Deep<Rgb888>> as Antialiased<LookOf<Rgb888, Sub4, u32, true, true>>;
        Antialiased<Whole<Rgb888>> as Antialiased<LookOf<Rgb888, Sub4, u16, false, true>>;
        Antialiased<OnePass<Rgb888>> as Antialiased<LookOf<Rgb888, Sub4, u16, true, false>>;
        Antialiased<Orthographic<Rgb888>> as Orthographic<Antialiased<LookOf<Rgb888, Sub4, u16, true, true>>>;
        Antialiased<DoubleSided<Rgb888>> as DoubleSided<Antialiased<LookOf<Rgb888, Sub4, u16, true, true>>>;
        DoubleSided<Orthographic<Rgb888>> as Orthographic<DoubleSided<LookOf<Rgb888, Sub4, u16, true, true>>>;
        DoubleSided<Counted<Rgb888>> as Counted<DoubleSided<LookOf<Rgb888, Sub4, u16, true, true>>>;
        DoubleSided<Unhurried<Rgb888>> as Unhurried<DoubleSided<LookOf<Rgb888, Sub4, u16, true, true>>>;
        BySpans<Fine<Rgb888>> as BySpans<LookOf<Rgb888, Sub8, u16, true, true>>;
        BySpans<Deep<Rgb888>> as BySpans<LookOf<Rgb888, Sub4, u32, true, true>>;
        BySpans<Whole<Rgb888>> as BySpans<LookOf<Rgb888, Sub4, u16, false, true>>;
        BySpans<OnePass<Rgb888>> as BySpans<LookOf<Rgb888, Sub4, u16, true, false>>;
        BySpans<Orthographic<Rgb888>> as Orthographic<BySpans<LookOf<Rgb888, Sub4, u16, true, true>>>;
        BySpans<DoubleSided<Rgb888>> as DoubleSided<BySpans<LookOf<Rgb888, Sub4, u16, true, true>>>;
        BySpans<Antialiased<Rgb888>> as Antialiased<BySpans<LookOf<Rgb888, Sub4, u16, true, true>>>;
        BySpans<Counted<Rgb888>> as Counted<BySpans<LookOf<Rgb888, Sub4, u16, true, true>>>;
        BySpans<Unhurried<Rgb888>> as Unhurried<BySpans<LookOf<Rgb888, Sub4, u16, true, true>>>;
    }
}

/// Without cuts or passes each other wrapper draws its picture, and what needs them is refused. Pairs of which both change the
/// picture are drawn where they are compared with exact faces: in depth_row, orthographic, antialiased and double_sided.
#[test]
fn every_pair_of_wrappers_draws() {
    check_picture::<Fine<Whole<Rgb888>>, Fine<Rgb888>>();
    check_picture::<Deep<Whole<Rgb888>>, Deep<Rgb888>>();
    check_picture::<Whole<Deep<OnePass<Fine<Rgb888>>>>, Fine<Deep<Rgb888>>>();
    check_picture::<Whole<Orthographic<Rgb888>>, Orthographic<Rgb888>>();
    check_picture::<Whole<Orthographic<Deep<OnePass<Fine<Rgb888>>>>>, Orthographic<Fine<Deep<Rgb888>>>>();
    check_picture::<Antialiased<OnePass<Whole<Rgb888>>>, Antialiased<Rgb888>>();
    check_picture::<DoubleSided<Whole<Rgb888>>, DoubleSided<Rgb888>>();
    check_picture::<DoubleSided<OnePass<Rgb888>>, DoubleSided<Rgb888>>();
    check_picture::<Whole<BySpans<Orthographic<Rgb888>>>, Orthographic<Rgb888>>();
    check_picture::<BySpans<DoubleSided<OnePass<Fine<Deep<Rgb888>>>>>, DoubleSided<Fine<Deep<Rgb888>>>>();
}

#[test]
fn wrappers_go_around_each_other_and_twice() {
    check_picture::<Counted<Rgb888>, Rgb888>();
    check_picture::<Unhurried<Counted<Rgb888>>, Rgb888>();
    check_picture::<Unhurried<Whole<Counted<Deep<Rgb888>>>>, Deep<Rgb888>>();
    assert_same_items::<Unhurried<Counted<Rgb888>>, Counted<Unhurried<Rgb888>>>();
    assert_same_items::<Counted<Fine<Unhurried<Rgb888>>>, Fine<Unhurried<Counted<Rgb888>>>>();
    assert_same_items::<Unhurried<Whole<Counted<Deep<Rgb888>>>>, Deep<Whole<Unhurried<Counted<Rgb888>>>>>();
    assert_same_items::<Deep<Counted<OnePass<Rgb888>>>, OnePass<Deep<Counted<Rgb888>>>>();
    assert_same_items::<Whole<Deep<OnePass<Fine<Rgb888>>>>, LookOf<Rgb888, Sub8, u32, false, false>>();
    assert_same_items::<Fine<Fine<Rgb888>>, Fine<Rgb888>>();
    assert_same_items::<DoubleSided<DoubleSided<Rgb888>>, DoubleSided<Rgb888>>();
}

/// What a look does not name takes no memory: the tables of the plainest one have 6 bytes a vertex.
#[test]
fn memory_is_that_of_the_look() {
    /// Bytes of a hundred vertices, faces, columns and rows.
    fn grown<L: Look>() -> [usize; 4] {
        let small = size_of::<Memory<L, 4, 4, 4, 4, 4>>();
        [
            size_of::<Memory<L, 104, 4, 4, 4, 4>>() - small,
            size_of::<Memory<L, 4, 104, 4, 4, 4>>() - small,
            size_of::<Memory<L, 4, 4, 104, 4, 4>>() - small,
            size_of::<Memory<L, 4, 4, 4, 104, 4>>() - small,
        ]
    }
    assert_eq!(grown::<Rgb888>(), [600, 200, 200, 400]);
    assert_eq!(grown::<Whole<OnePass<Rgb888>>>(), [600, 200, 200, 400]);
    assert_eq!(grown::<Deep<Rgb888>>(), [800, 200, 400, 400]);
    assert_eq!(grown::<Fine<Rgb888>>(), [1200, 200, 200, 400]);
    assert_eq!(grown::<Orthographic<Rgb888>>(), [600, 200, 200, 400]);
    assert_eq!(grown::<DoubleSided<Rgb888>>(), [600, 200, 200, 400]);
    // Four bytes a face and a row, and of a column a change, the word behind, a depth and a face.
    assert_eq!(grown::<Antialiased<Rgb888>>(), [600, 600, 1400, 800]);
}
