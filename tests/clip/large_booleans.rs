//! Polygons with more corners than a table of vertices can name.

use std::thread;

use zrow::{
    clip::{Clipper, Operation},
    geometry::{InputError, Sub8, SubPoint, TooSmall},
};

/// A comb of that many corners, its teeth upwards.
fn comb(corners: i32) -> Vec<SubPoint<Sub8>> {
    let last = corners - 1;
    let height = |number: i32| if number == last { 9 } else { -(number % 2) };
    (0..corners)
        .map(|number| SubPoint::from_units(number, height(number)).unwrap())
        .collect()
}

/// A larger table has no names for more of them: the error says that they do not fit, and nothing is lost without one.
#[test]
fn more_corners_than_have_a_name_are_an_error() {
    macro_rules! check {
        ($([$name:ident] [$($algorithm:tt)+])+) => {$(
            let mut clipper = Box::new(Clipper::<Sub8, 70_000>::new());
            for corners in [65_536, 65_537, 70_000] {
                let comb = comb(corners);
                for operation in [Operation::Union, Operation::Difference] {
                    let full = TooSmall::ContourVertices(65_536);
                    let clipped = $($algorithm)+(&mut *clipper, &[&comb], &[], operation);
                    assert_eq!(clipped.err(), Some(InputError::TooSmall(full)), "{corners}");
                }
            }
        )+};
    }
    let check = || {
        zrow_methods::booleans!(check);
    };
    // The table passes the stack on its way into the box.
    let large = thread::Builder::new().stack_size(1 << 24).spawn(check).unwrap();
    assert!(large.join().is_ok());
}
