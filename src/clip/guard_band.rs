//! The guard band: cuts faces on the screen where a coordinate would leave the domain of its precision.
//!
//! The domain is much larger than a display, so few faces meet it. Depth is affine on the screen, so it is cut along.

use heapless::Vec;

use crate::{
    clip::near_plane::cut_polygon,
    view::{ScreenPrecision, WideVertex},
};

/// A face has three corners, the near plane adds one, and each side of the guard band one.
pub(crate) type CutFace = Vec<WideVertex, 8>;

/// The part of a convex polygon that lies in the domain of `S`.
pub(crate) fn guard_band<S: ScreenPrecision>(corners: &[WideVertex]) -> CutFace {
    let (least, greatest) = (i64::from(S::MIN_UNITS), i64::from(S::MAX_UNITS));
    let left: CutFace = cut_polygon(corners, |corner| corner.x >= least, |a, b| cut_x::<S>(a, b, least));
    let right: CutFace = cut_polygon(&left, |corner| corner.x <= greatest, |a, b| cut_x::<S>(a, b, greatest));
    let top: CutFace = cut_polygon(&right, |corner| corner.y >= least, |a, b| cut_y::<S>(a, b, least));
    cut_polygon(&top, |corner| corner.y <= greatest, |a, b| cut_y::<S>(a, b, greatest))
}

fn cut_x<S: ScreenPrecision>(inside: &WideVertex, outside: &WideVertex, x: i64) -> WideVertex {
    let (part, whole) = (x - inside.x, outside.x - inside.x);
    WideVertex {
        x,
        y: between::<S>(inside.y, outside.y, part, whole),
        z: between::<S>(inside.z.into(), outside.z.into(), part, whole) as i32,
    }
}

fn cut_y<S: ScreenPrecision>(inside: &WideVertex, outside: &WideVertex, y: i64) -> WideVertex {
    let (part, whole) = (y - inside.y, outside.y - inside.y);
    WideVertex {
        x: between::<S>(inside.x, outside.x, part, whole),
        y,
        z: between::<S>(inside.z.into(), outside.z.into(), part, whole) as i32,
    }
}

/// `from + (to - from) * part / whole`, rounded down.
///
/// |x/z| < 2^15 times a focal length of 2,047 pixels: a coordinate is below 2^30 units with `Sub4`, below 2^34 with
/// `Sub8`. So products of two differences need 62 and 70 bits.
fn between<S: ScreenPrecision>(from: i64, to: i64, part: i64, whole: i64) -> i64 {
    if S::FRACTION_BITS <= 4 {
        from + ((to - from) * part * whole.signum()).div_euclid(whole.abs())
    } else {
        let product = i128::from(to - from) * i128::from(part * whole.signum());
        // Between 0 and `to - from`, so it fits again.
        from + product.div_euclid(i128::from(whole.abs())) as i64
    }
}
