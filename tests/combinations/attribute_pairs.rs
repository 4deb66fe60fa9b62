//! Pairs of attributes: each of both is the same integers as alone, where that is divided as often as the pair.

use embedded_graphics::pixelcolor::Rgb888;
use proptest::prelude::*;
use std::{fmt::Debug, marker::PhantomData};
use zrow::{
    scene::{Camera, Deep, Fine, Look, Pose},
    shade::{Attributes, Perspective, Shading},
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::random_faces::{faces, pose};
use crate::shaded_scene::{
    Even, InSpace, Numbers, SmallMemory, camera_in_units, flat_corners, model, number, triangle, words,
};

/// Attributes that are made of three numbers a vertex, of which a picture shows one.
trait Pair: Attributes {
    const TOLERANCES: Self::Tolerance;
    fn of(numbers: [i16; 3]) -> Self;
    fn shown(values: &Self::Values, shown: usize) -> i32;
}

/// A shading with such attributes.
#[derive(Debug)]
struct Paired<A>(PhantomData<A>);

impl<A: Pair + 'static> Shading for Paired<A> {
    type Color = Rgb888;
    type Skin<'a> = Numbers<'a, 3>;
    type Uniforms = ();
    type Attributes = A;
    const TOLERANCE: A::Tolerance = A::TOLERANCES;

    fn uniforms(_: &Numbers<'_, 3>, _: &Pose, _: &Camera) {}

    fn vertex(skin: &Numbers<'_, 3>, (): &(), vertex: usize, _: [i32; 3]) -> A {
        A::of(skin.of_vertices[vertex])
    }

    fn fragment(skin: &Numbers<'_, 3>, _: u32, values: &A::Values) -> Option<u32> {
        Some(A::shown(values, skin.shown) as u32)
    }
}

macro_rules! pair {
    ($attributes:ty, $tolerances:expr, $numbers:pat => $new:expr, $values:pat => $shown:expr) => {
        impl Pair for $attributes {
            const TOLERANCES: Self::Tolerance = $tolerances;

            fn of($numbers: [i16; 3]) -> Self {
                $new
            }

            fn shown($values: &Self::Values, shown: usize) -> i32 {
                $shown[shown]
            }
        }
    };
}

type EvenAndSpace = ([i16; 1], Perspective<2>);
type SpaceAndEven = (Perspective<1>, [i16; 2]);
type BothEven = ([i16; 2], [i16; 1]);
type BothInSpace = (Perspective<1>, Perspective<2>);
type MixedSteps = (Perspective<1>, Perspective<2, 4>);
type Nested = (((), [i16; 1]), (Perspective<1>, ([i16; 1], ())));
pair!(EvenAndSpace, (0, 4), [a, b, c] => ([a], Perspective([b, c])), ([a], [b, c]) => [*a, *b, *c]);
pair!(SpaceAndEven, (4, 0), [a, b, c] => (Perspective([a]), [b, c]), ([a], [b, c]) => [*a, *b, *c]);
pair!(BothEven, (0, 0), [a, b, c] => ([a, b], [c]), ([a, b], [c]) => [*a, *b, *c]);
pair!(BothInSpace, (4, 0), [a, b, c] => (Perspective([a]), Perspective([b, c])), ([a], [b, c]) => [*a, *b, *c]);
pair!(MixedSteps, (0, 0), [a, b, c] => (Perspective([a]), Perspective([b, c])), ([a], [b, c]) => [*a, *b, *c]);
pair!(
    Nested,
    (((), 0), (0, (0, ()))),
    [a, b, c] => (((), [a]), (Perspective([b]), ([c], ()))),
    (((), [a]), ([b], ([c], ()))) => [*a, *b, *c]
);

/// The picture of one number of the vertices of a mesh.
fn picture<L, const N: usize>(mesh: &Mesh, numbers: &[[i16; N]], shown: usize, pose: Pose) -> Vec<u32>
where
    L: Look<Color = Rgb888>,
    L::Shading: for<'s> Shading<Skin<'s> = Numbers<'s, N>>,
{
    let camera = camera_in_units();
    let models = [model::<L::Shading, N>(mesh, numbers, shown).with_pose(pose)];
    let mut memory = Box::new(SmallMemory::<L>::new());
    words(
        &mut memory.prepare(&camera, &models).unwrap(),
        camera.viewport().to_rectangle(),
    )
}

/// Compares each number of a pair with those of its own kind alone.
macro_rules! compare {
    ($mesh:expr, $numbers:expr, $pose:expr, $wrapped:ident<$pair:ty>, $($shown:literal: $alone:ty, $of:expr),+) => {$(
        let of: fn(&[i16; 3]) -> _ = $of;
        let (numbers, at) = ($numbers.iter().map(|numbers| of(numbers).0).collect::<Vec<_>>(), of(&$numbers[0]).1);
        let expected = picture::<$wrapped<$alone>, _>($mesh, &numbers, at, $pose);
        let drawn = picture::<$wrapped<Paired<$pair>>, 3>($mesh, $numbers, $shown, $pose);
        assert!(drawn == expected, "number {} of {}", $shown, stringify!($pair));
    )+};
}

type Plain<H> = H;
type FineAndDeep<H> = Fine<Deep<H>>;

/// An even number before those in space, and a pair of pairs: of each kind one.
macro_rules! compare_some {
    ($mesh:expr, $numbers:expr, $pose:expr, $wrapped:ident) => {
        compare!($mesh, $numbers, $pose, $wrapped<EvenAndSpace>,
            0: Even<1>, |&[a, ..]| ([a], 0), 1: InSpace<2, 4>, |&[_, b, c]| ([b, c], 0),
            2: InSpace<2, 4>, |&[_, b, c]| ([b, c], 1));
        compare!($mesh, $numbers, $pose, $wrapped<Nested>,
            0: Even<1>, |&[a, ..]| ([a], 0), 1: InSpace<1>, |&[_, b, _]| ([b], 0), 2: Even<1>, |&[.., c]| ([c], 0));
    };
}

macro_rules! compare_all {
    ($mesh:expr, $numbers:expr, $pose:expr, $wrapped:ident) => {
        compare_some!($mesh, $numbers, $pose, $wrapped);
        compare!($mesh, $numbers, $pose, $wrapped<SpaceAndEven>,
            0: InSpace<1, 4>, |&[a, ..]| ([a], 0), 1: Even<2>, |&[_, b, c]| ([b, c], 0), 2: Even<2>, |&[_, b, c]| ([b, c], 1));
        compare!($mesh, $numbers, $pose, $wrapped<BothEven>,
            0: Even<3>, |&all| (all, 0), 1: Even<3>, |&all| (all, 1), 2: Even<3>, |&all| (all, 2));
        compare!($mesh, $numbers, $pose, $wrapped<MixedSteps>,
            0: InSpace<1, 0, 4>, |&[a, ..]| ([a], 0), 1: InSpace<2, 0, 4>, |&[_, b, c]| ([b, c], 0),
            2: InSpace<2, 0, 4>, |&[_, b, c]| ([b, c], 1));
        compare!($mesh, $numbers, $pose, $wrapped<BothInSpace>,
            0: InSpace<1, 4>, |&[a, ..]| ([a], 0), 1: InSpace<2>, |&[_, b, c]| ([b, c], 0), 2: InSpace<2>, |&[_, b, c]| ([b, c], 1));
    };
}

proptest! {
    #![proptest_config(config(cases(40, 1_000)))]

    #[test]
    fn pairs_are_the_same_integers_as_alone(
        mesh in faces(1_200, 4),
        numbers in prop::collection::vec(prop::array::uniform3(number()), 12),
        pose in pose(1300..2500),
    ) {
        compare_all!(&mesh, &numbers[..], pose, Plain);
        // Each member has its planes for itself: which ones are beside it does not depend on precision and depth.
        compare_some!(&mesh, &numbers[..], pose, FineAndDeep);
    }

    /// Faces that are cut, and numbers so small that some are within the tolerance.
    #[test]
    fn pairs_of_cut_faces_are_the_same_integers_as_alone(
        mesh in faces(2_000, 2),
        numbers in prop::collection::vec(prop::array::uniform3(-300i16..300), 6),
        pose in pose(-500..800),
    ) {
        compare_all!(&mesh, &numbers[..], pose, Plain);
    }

    /// Faces of which one of both leans so little that it is not divided.
    #[test]
    fn pairs_of_which_one_is_even_are_the_same_integers_as_alone(
        corners in flat_corners(),
        distances in prop::array::uniform3(-120i16..120),
        numbers in prop::array::uniform3((number(), 0i16..60, 0i16..60).prop_map(|(a, b, c)| [a, b, c])),
    ) {
        let mut corners = corners;
        for (corner, distance) in corners.iter_mut().zip(distances) {
            corner[2] += distance;
        }
        compare_all!(&triangle(corners), &numbers[..], Pose::IDENTITY, Plain);
    }
}
