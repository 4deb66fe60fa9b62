//! Meshes between two poses, against exact integers.

use fixed::types::U1F15;
use proptest::prelude::*;
use zrow::{
    geometry::TooSmall,
    scene::{BoundingBox, FaceSet},
};

use crate::common::{cases, config};

const FACES: [[u16; 3]; 2] = [[0, 1, 2], [2, 1, 0]];

fn vertex() -> impl Strategy<Value = [i16; 3]> {
    let coordinate = prop_oneof![3 => any::<i16>(), 1 => -3i16..4, 1 => Just(i16::MIN), 1 => Just(i16::MAX)];
    prop::array::uniform3(coordinate)
}

fn part() -> impl Strategy<Value = u16> {
    prop_oneof![4 => 0u16..=32_768, 1 => any::<u16>(), 1 => Just(32_768), 1 => Just(16_384), 1 => 0u16..3]
}

proptest! {
    #![proptest_config(config(cases(3_000, 300_000)))]

    #[test]
    fn vertices_are_the_exact_ones_rounded_once(
        from in prop::collection::vec(vertex(), 3..6),
        to in prop::collection::vec(vertex(), 6),
        part in part(),
    ) {
        let mesh = FaceSet::new(&from, &FACES).unwrap();
        let mut into = [[1; 3]; 7];
        let morphed = mesh.morphed(&to, U1F15::from_bits(part), &mut into).unwrap();
        prop_assert_eq!(morphed.faces(), FACES);
        prop_assert_eq!(morphed.vertices().len(), from.len());
        let weight = i128::from(part.min(32_768));
        for (found, (from, to)) in morphed.vertices().iter().zip(from.iter().zip(&to)) {
            for (found, (from, to)) in found.iter().zip(from.iter().zip(to)) {
                // The nearest, halves up, of a sum of weights that add up to 2^15.
                let sum = (32_768 - weight) * i128::from(*from) + weight * i128::from(*to);
                prop_assert_eq!(i128::from(*found), (2 * sum + 32_768).div_euclid(65_536));
            }
        }
        // The same pose from the other end, and never outside of both.
        let mut back = [[1; 3]; 7];
        let other = FaceSet::new(&to[..from.len()], &FACES).unwrap();
        let rest = U1F15::from_bits(32_768 - part.min(32_768));
        let returned = other.morphed(&from, rest, &mut back).unwrap();
        prop_assert_eq!(returned.vertices(), morphed.vertices());
        let around = mesh.bounds().joined(&other.bounds());
        prop_assert_eq!(around.joined(&BoundingBox::around(morphed.vertices())), around);
        prop_assert!(into[from.len()..].iter().all(|vertex| *vertex == [1; 3]));
    }
}

#[test]
fn both_ends_are_exact() {
    let (from, to) = (
        [[i16::MIN, 7, -1], [0; 3], [i16::MAX; 3]],
        [[i16::MAX, -8, 0], [i16::MIN; 3], [i16::MIN; 3]],
    );
    let mesh = FaceSet::new(&from, &FACES).unwrap();
    let mut into = [[0; 3]; 3];
    assert_eq!(mesh.morphed(&to, U1F15::ZERO, &mut into).unwrap().vertices(), from);
    assert_eq!(mesh.morphed(&to, U1F15::ONE, &mut into).unwrap().vertices(), to);
    assert_eq!(mesh.morphed(&to, U1F15::MAX, &mut into).unwrap().vertices(), to);
}

#[test]
fn too_few_vertices_are_an_error() {
    let mesh = FaceSet::new(&[[0; 3]; 3], &FACES).unwrap();
    let needed = Err(TooSmall::Vertices(3));
    assert_eq!(mesh.morphed(&[[1; 3]; 2], U1F15::ONE, &mut [[0; 3]; 3]), needed);
    assert_eq!(mesh.morphed(&[[1; 3]; 3], U1F15::ONE, &mut [[0; 3]; 2]), needed);
}
