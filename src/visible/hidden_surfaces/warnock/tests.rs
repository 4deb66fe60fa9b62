//! The tests of how a face lies to a window, compared with each other and with a look at all pixel centres.

use proptest::{prelude::*, test_runner::RngSeed};

use super::{
    Warnock,
    angle_sum::AngleSum,
    bounding_box::BoundingBox,
    line_equations::LineEquations,
    ray_crossings::RayCrossings,
    region_codes::RegionCodes,
    window_test::{CenterRectangle, FaceCorners, Relation, WindowTest, side_of},
};
use crate::{
    geometry::{Sub4, Sub8, Window},
    view::{Position, ScreenPrecision},
};

const TESTS: [fn(&FaceCorners, &CenterRectangle) -> Relation; 5] = [
    BoundingBox::relation,
    LineEquations::relation,
    RayCrossings::relation,
    AngleSum::relation,
    RegionCodes::relation,
];

/// Whether a face covers a pixel centre, by the top-left rule, in 128-bit numbers.
fn covers(corners: &FaceCorners, x: i32, y: i32) -> bool {
    corners.edges().into_iter().all(|[start, end]| {
        let [x0, y0, x1, y1, x, y] = [start.x, start.y, end.x, end.y, x, y].map(i128::from);
        let side = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0);
        side > 0 || (side == 0 && (y1 < y0 || (y1 == y0 && x1 > x0)))
    })
}

/// Checks what all tests say of a face and a window; returns how the face lies to it if no edge meets it.
fn check<S: ScreenPrecision>(corners: &FaceCorners, window: &Window) -> Option<Relation> {
    let rectangle = CenterRectangle::of::<S>(window);
    let unit = 1 << S::FRACTION_BITS;
    let centers =
        (window.top..window.bottom).flat_map(|row| (window.left..window.right).map(move |column| (column, row)));
    let covered = centers
        .filter(|(column, row)| covers(corners, column * unit, row * unit))
        .count();
    let all = (window.width() * window.height()) as usize;
    let relations = TESTS.map(|relation| relation(corners, &rectangle));
    for relation in relations {
        match relation {
            Relation::Separate => assert_eq!(covered, 0, "{corners:?} {window:?} {relations:?}"),
            Relation::Surrounding => assert_eq!(covered, all, "{corners:?} {window:?} {relations:?}"),
            Relation::Intersecting => {}
        }
    }
    let [by_box, by_lines, others @ ..] = relations;
    // These two know all windows that are covered, whatever touches them.
    assert_eq!(
        by_box == Relation::Surrounding,
        covered == all,
        "{corners:?} {window:?}"
    );
    assert_eq!(by_box, by_lines, "{corners:?} {window:?}");
    if corners.any_edge_meets(&rectangle) {
        assert_eq!(others, [Relation::Intersecting; 3], "{corners:?} {window:?}");
        return None;
    }
    assert_ne!(by_box, Relation::Intersecting, "{corners:?} {window:?}");
    assert_eq!(others, [by_box; 3], "{corners:?} {window:?}");
    Some(by_box)
}

/// A face with corners at multiples of some units, clockwise, so that edges touch pixel centres often.
fn face(size: i32, step: i32) -> impl Strategy<Value = FaceCorners> {
    let corner = move || {
        (-size..=size, -size..=size).prop_map(move |(x, y)| Position {
            x: x * step,
            y: y * step,
        })
    };
    (corner(), corner(), corner())
        .prop_map(|(a, b, c)| FaceCorners(if side_of([a, b], c) < 0 { [a, c, b] } else { [a, b, c] }))
}

/// A window of up to so many columns and rows, one of which it often has.
fn window(size: i32) -> impl Strategy<Value = Window> {
    let length = || prop_oneof![Just(1), Just(2), 1..12];
    (-size..size, -size..size, length(), length()).prop_map(|(left, top, width, height)| Window {
        left,
        top,
        right: left + width,
        bottom: top + height,
    })
}

/// The same cases in every run.
fn fixed_cases() -> ProptestConfig {
    ProptestConfig {
        cases: 2_000,
        rng_seed: RngSeed::Fixed(0x0123_4567),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(fixed_cases())]

    /// Corners at centres and halfway between them.
    #[test]
    fn tests_agree_where_edges_touch_centres(face in face(20, 8), window in window(12)) {
        check::<Sub4>(&face, &window);
    }

    #[test]
    fn tests_agree_for_any_face(face in face(400, 1), window in window(25)) {
        check::<Sub4>(&face, &window);
    }

    #[test]
    fn tests_agree_for_large_faces(face in face(8191, 256), window in window(8000)) {
        check::<Sub8>(&face, &window);
    }
}

/// All windows of up to 3 x 3 pixels around one face: each relation is met, also without an edge.
#[test]
fn windows_around_a_face() {
    let corners = FaceCorners([[0, -160], [150, 100], [-140, 130]].map(|[x, y]| Position { x, y }));
    let mut counts = [0; 3];
    for (left, top) in (-14..14).flat_map(|left| (-14..14).map(move |top| (left, top))) {
        for (width, height) in (1..4).flat_map(|width| (1..4).map(move |height| (width, height))) {
            let window = Window {
                left,
                top,
                right: left + width,
                bottom: top + height,
            };
            match check::<Sub4>(&corners, &window) {
                Some(Relation::Separate) => counts[0] += 1,
                Some(_) => counts[1] += 1,
                None => counts[2] += 1,
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 500), "{counts:?}");
}

/// A window in which the whole face lies, and one that lies beyond a sharp corner, on the outer side of no edge.
#[test]
fn contained_faces_and_windows_beyond_a_corner() {
    let contained = FaceCorners([[20, 20], [60, 30], [30, 60]].map(|[x, y]| Position { x, y }));
    let whole = Window {
        left: 0,
        top: 0,
        right: 6,
        bottom: 6,
    };
    assert_eq!(check::<Sub4>(&contained, &whole), None);
    let sharp = FaceCorners([[0, 0], [320, 8], [320, 16]].map(|[x, y]| Position { x, y }));
    let beyond = Window {
        left: -20,
        top: -20,
        right: 0,
        bottom: 20,
    };
    assert_eq!(check::<Sub4>(&sharp, &beyond), Some(Relation::Separate));
}

/// The memory that the documentation states.
#[test]
fn memory_is_two_bytes_a_face_and_184() {
    assert_eq!(size_of::<Warnock<0>>(), 184);
    assert_eq!(size_of::<Warnock<100>>(), 384);
    assert_eq!(size_of::<Warnock<1_000, RegionCodes>>(), 2_184);
}
