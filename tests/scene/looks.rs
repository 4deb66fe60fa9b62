//! Looks: each wrapper around each other one, in both orders, draws the picture of the look that it names.

use embedded_graphics::{pixelcolor::Rgb888, primitives::Rectangle};
use fixed::types::I8F24;
use zrow::{
    band::Band,
    geometry::{InputError, Sub4, Sub8, SubPixel, TooSmall},
    scene::{
        Antialiased, Camera, Counted, Deep, DoubleSided, Fine, Look, Memory, Model, OnePass, Orthographic, Pose,
        Rotation, Unhurried, Whole,
    },
};
use zrow_methods::LookOf;

use crate::common::meshes;
use crate::numbered_scene::{Scene, area};
use crate::shading_looks::{SameTypes, assert_same_items};
use crate::snapped_faces::{at, camera, standard_pose};

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
    let mut few = Box::new(Memory::<L, 600, 600, 128, 64, 10>::new());
    Outcome {
        picture: picture::<L>(&turned, &camera, area),
        behind: few.prepare(&camera, &near).err(),
        crowded: few.prepare(&camera, &turned).err(),
        fraction_bits: L::Precision::FRACTION_BITS,
        depth_bytes: size_of::<L::Depth>(),
    }
}

/// Whether a look draws and refuses what another one does.
fn check<L: Look<Color = Rgb888, Shading = Rgb888>, Same: Look<Color = Rgb888, Shading = Rgb888>>() {
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

/// Whether a pair of wrappers in both orders draws the same, and both name what a look of the methods crate has. That one is not
/// drawn: each look that draws takes half a second to compile.
fn check_orders<L, Reversed, Same>()
where
    L: Look<Color = Rgb888, Shading = Rgb888>,
    Reversed: SameTypes<L>,
    Same: SameTypes<L>,
{
    assert_same_items::<L, Same>();
    assert_same_items::<L, Reversed>();
    check::<L, Reversed>();
}

#[test]
fn each_wrapper_changes_one_thing() {
    let plain = outcome::<Rgb888>();
    assert_eq!((plain.fraction_bits, plain.depth_bytes), (4, 2));
    assert_eq!((&plain.behind, &plain.crowded), (&None, &None));
    check::<Rgb888, LookOf<Rgb888, Sub4, u16, true, true>>();
    check::<Fine<Rgb888>, LookOf<Rgb888, Sub8, u16, true, true>>();
    check::<Deep<Rgb888>, LookOf<Rgb888, Sub4, u32, true, true>>();
    check::<Whole<Rgb888>, LookOf<Rgb888, Sub4, u16, false, true>>();
    check::<OnePass<Rgb888>, LookOf<Rgb888, Sub4, u16, true, false>>();

    check::<Orthographic<Rgb888>, Orthographic<LookOf<Rgb888, Sub4, u16, true, true>>>();

    assert!(
        outcome::<Orthographic<Rgb888>>().picture != plain.picture,
        "what is nearer is not larger"
    );
    assert!(
        outcome::<Fine<Rgb888>>().picture != plain.picture,
        "1/256 pixel moves some edge"
    );
    let whole = outcome::<Whole<Rgb888>>();
    assert_eq!(whole.behind, Some(InputError::BeforeNearPlane { model: 0 }));
    let crowded = outcome::<OnePass<Rgb888>>().crowded;
    assert!(
        matches!(crowded, Some(InputError::TooSmall(TooSmall::ActiveFaces(11..)))),
        "{crowded:?}"
    );
}

#[test]
fn every_pair_of_wrappers_goes_in_both_orders() {
    check_orders::<Fine<Deep<Rgb888>>, Deep<Fine<Rgb888>>, LookOf<Rgb888, Sub8, u32, true, true>>();
    check_orders::<Fine<Whole<Rgb888>>, Whole<Fine<Rgb888>>, LookOf<Rgb888, Sub8, u16, false, true>>();
    check_orders::<Fine<OnePass<Rgb888>>, OnePass<Fine<Rgb888>>, LookOf<Rgb888, Sub8, u16, true, false>>();
    check_orders::<Deep<Whole<Rgb888>>, Whole<Deep<Rgb888>>, LookOf<Rgb888, Sub4, u32, false, true>>();
    check_orders::<Deep<OnePass<Rgb888>>, OnePass<Deep<Rgb888>>, LookOf<Rgb888, Sub4, u32, true, false>>();
    check_orders::<Whole<OnePass<Rgb888>>, OnePass<Whole<Rgb888>>, LookOf<Rgb888, Sub4, u16, false, false>>();
    check_orders::<
        Orthographic<Fine<Rgb888>>,
        Fine<Orthographic<Rgb888>>,
        Orthographic<LookOf<Rgb888, Sub8, u16, true, true>>,
    >();
    check_orders::<
        Orthographic<Deep<Rgb888>>,
        Deep<Orthographic<Rgb888>>,
        Orthographic<LookOf<Rgb888, Sub4, u32, true, true>>,
    >();
    check_orders::<
        Orthographic<Whole<Rgb888>>,
        Whole<Orthographic<Rgb888>>,
        Orthographic<LookOf<Rgb888, Sub4, u16, false, true>>,
    >();
    check_orders::<
        Orthographic<OnePass<Rgb888>>,
        OnePass<Orthographic<Rgb888>>,
        Orthographic<LookOf<Rgb888, Sub4, u16, true, false>>,
    >();
    check_orders::<
        DoubleSided<Fine<Rgb888>>,
        Fine<DoubleSided<Rgb888>>,
        DoubleSided<LookOf<Rgb888, Sub8, u16, true, true>>,
    >();
    check_orders::<
        DoubleSided<Deep<Rgb888>>,
        Deep<DoubleSided<Rgb888>>,
        DoubleSided<LookOf<Rgb888, Sub4, u32, true, true>>,
    >();
    check_orders::<
        DoubleSided<Whole<Rgb888>>,
        Whole<DoubleSided<Rgb888>>,
        DoubleSided<LookOf<Rgb888, Sub4, u16, false, true>>,
    >();
    check_orders::<
        DoubleSided<OnePass<Rgb888>>,
        OnePass<DoubleSided<Rgb888>>,
        DoubleSided<LookOf<Rgb888, Sub4, u16, true, false>>,
    >();
    check_orders::<
        Antialiased<Fine<Rgb888>>,
        Fine<Antialiased<Rgb888>>,
        Antialiased<LookOf<Rgb888, Sub8, u16, true, true>>,
    >();
    check_orders::<
        Antialiased<Deep<Rgb888>>,
        Deep<Antialiased<Rgb888>>,
        Antialiased<LookOf<Rgb888, Sub4, u32, true, true>>,
    >();
    check_orders::<
        Antialiased<Whole<Rgb888>>,
        Whole<Antialiased<Rgb888>>,
        Antialiased<LookOf<Rgb888, Sub4, u16, false, true>>,
    >();
    check_orders::<
        Antialiased<OnePass<Rgb888>>,
        OnePass<Antialiased<Rgb888>>,
        Antialiased<LookOf<Rgb888, Sub4, u16, true, false>>,
    >();
    check_orders::<
        Antialiased<Orthographic<Rgb888>>,
        Orthographic<Antialiased<Rgb888>>,
        Orthographic<Antialiased<LookOf<Rgb888, Sub4, u16, true, true>>>,
    >();
    check_orders::<
        Antialiased<DoubleSided<Rgb888>>,
        DoubleSided<Antialiased<Rgb888>>,
        DoubleSided<Antialiased<LookOf<Rgb888, Sub4, u16, true, true>>>,
    >();
    check_orders::<
        DoubleSided<Orthographic<Rgb888>>,
        Orthographic<DoubleSided<Rgb888>>,
        Orthographic<DoubleSided<LookOf<Rgb888, Sub4, u16, true, true>>>,
    >();
}

#[test]
fn wrappers_go_around_each_other_and_twice() {
    check::<Whole<Deep<OnePass<Fine<Rgb888>>>>, LookOf<Rgb888, Sub8, u32, false, false>>();
    check::<Counted<Rgb888>, LookOf<Rgb888, Sub4, u16, true, true>>();
    check::<Unhurried<Rgb888>, LookOf<Rgb888, Sub4, u16, true, true>>();
    check::<Counted<Fine<Unhurried<Rgb888>>>, LookOf<Rgb888, Sub8, u16, true, true>>();
    check::<Unhurried<Whole<Counted<Deep<Rgb888>>>>, LookOf<Rgb888, Sub4, u32, false, true>>();
    check::<Deep<Counted<OnePass<Rgb888>>>, LookOf<Rgb888, Sub4, u32, true, false>>();
    check::<Fine<Fine<Rgb888>>, LookOf<Rgb888, Sub8, u16, true, true>>();
    check::<Whole<Orthographic<Deep<OnePass<Fine<Rgb888>>>>>, Orthographic<LookOf<Rgb888, Sub8, u32, false, false>>>();
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
