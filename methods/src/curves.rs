//! Cubic Bezier curves on the screen, and the siblings that flatten them.

use core::hint::black_box;

use fixed::types::U8F8;
use zrow::{
    geometry::{InputError, Sub8, SubPoint},
    scan::Bezier,
};

use crate::{Corner, Random};

/// Curves of a whole run.
pub const CURVES: usize = 50;
/// Columns and rows of the control points.
pub const CURVE_SCREEN: (i32, i32) = (240, 320);

/// A curve.
#[derive(Debug, Clone)]
pub struct CurveInput {
    /// As the library takes it.
    pub curve: Bezier<4>,
    /// Its control points in 1/256 pixel.
    pub controls: [Corner; 4],
}

/// Curves of random control points, without end.
pub fn curves() -> impl Iterator<Item = Result<CurveInput, InputError>> {
    let mut random = Random::new(0x6375_7276_6573);
    core::iter::repeat_with(move || {
        let controls: [Corner; 4] = core::array::from_fn(|_| {
            let x = random.number(0, CURVE_SCREEN.0 * 256);
            (x, random.number(0, CURVE_SCREEN.1 * 256))
        });
        let mut points = [SubPoint::<Sub8>::default(); 4];
        for (point, (x, y)) in points.iter_mut().zip(controls) {
            *point = SubPoint::from_units(x, y)?;
        }
        let curve = Bezier::<4>::new(points)?;
        Ok(CurveInput { curve, controls })
    })
}

/// How far lines may be from their curve.
#[derive(Debug, Clone, Copy)]
pub struct Tolerance {
    /// In pixels, as in tables.
    pub name: &'static str,
    /// What the chips report its counts as.
    pub count: &'static str,
    /// In 1/256 pixel.
    pub units: u16,
}

const fn tolerance(units: u16, name: &'static str, count: &'static str) -> Tolerance {
    Tolerance { name, count, units }
}

/// Every tolerance.
pub const TOLERANCES: &[Tolerance] = &[
    tolerance(2, "1/128", "tolerance.1_128"),
    tolerance(8, "1/32", "tolerance.1_32"),
    tolerance(16, "1/16", "tolerance.1_16"),
    tolerance(32, "1/8", "tolerance.1_8"),
    tolerance(64, "1/4", "tolerance.1_4"),
    tolerance(128, "1/2", "tolerance.1_2"),
    tolerance(256, "1", "tolerance.1"),
    tolerance(512, "2", "tolerance.2"),
];

/// A way to flatten a curve.
#[derive(Debug, Clone, Copy)]
pub struct CurveSibling {
    /// Its module in `zrow`.
    pub name: &'static str,
    /// Hands the end of every line over, to see where they are.
    pub ends: fn(&Bezier<4>, U8F8, &mut dyn FnMut(SubPoint<Sub8>)),
    /// Does it for nothing, to see what it costs.
    pub walk: fn(&Bezier<4>, U8F8),
}

macro_rules! siblings {
    ($([$name:ident] [$($flatten:tt)+])+) => {
        &[$(CurveSibling {
            name: stringify!($name),
            ends: |curve, tolerance, take| $($flatten)+(curve, tolerance).for_each(take),
            walk: |curve, tolerance| {
                for end in $($flatten)+(curve, tolerance) {
                    black_box(end);
                }
            },
        }),+]
    };
}

/// Every way to flatten a curve.
pub const CURVE_SIBLINGS: &[CurveSibling] = curves!(siblings);
