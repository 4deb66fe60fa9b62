//! Neighbours of the faces of meshes that have more of them than there are numbers.

use zrow::scene::FaceSet;

/// The last face that has a number.
const LAST: usize = FaceSet::NO_NEIGHBOUR as usize - 1;
const FACES: usize = LAST + 7;

/// A face that has no number is nobody's neighbour, but has neighbours.
#[test]
fn a_face_without_a_number_is_no_neighbour() {
    let find = || {
        let mut faces = [[0; 3]; FACES];
        for (index, face) in faces.iter_mut().enumerate() {
            let first = 10 + (index % 60_000) as u16;
            *face = [first, first + 1, first + 2];
        }
        faces[0] = [0, 1, 2];
        faces[LAST] = [2, 1, 4];
        faces[LAST + 1] = [0, 2, 5];
        faces[FACES - 1] = [1, 0, 3];
        let neighbours = FaceSet::find_neighbours(&faces);
        [0, LAST, LAST + 1, FACES - 1].map(|face| neighbours[face])
    };
    // Several tables of half a megabyte each.
    let thread = std::thread::Builder::new().stack_size(64 << 20).spawn(find).unwrap();
    let none = FaceSet::NO_NEIGHBOUR;
    assert_eq!(
        thread.join().unwrap(),
        [
            [none, LAST as u16, none],
            [0, none, none],
            [0, none, none],
            [0, none, none]
        ]
    );
}
