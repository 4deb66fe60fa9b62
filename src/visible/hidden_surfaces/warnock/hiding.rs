//! Whether a face that surrounds a window hides another one in it, decided at corners.
//!
//! ```text
//!     depth                           The stored depths of a face are a plane of whole numbers, and a plane that is nearer than
//!       |A______                      another one at the four corners of a rectangle is nearer everywhere in it. A is a face that
//!       |       ------_____A          surrounds the window: what it stores is known at the corners. B covers only a part: where
//!       |    B--.__                   its pixels are, it is below the highest of its corners, and below its exact plane and the
//!       |           --B               error of the stored one, at the corners of the pixels that its box and the window share.
//!       +--|--------|-----|--- x
//!         the part of B
//! ```
//!
//! Guarantees: a face that is said to be hidden is seen in no pixel of the window. The other way round, of faces that are nearer to
//! each other than the error of stored depths, none is said to hide the other one.

use core::marker::PhantomData;

use crate::{
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, Position, ScreenPrecision, ScreenVertex},
    visible::{
        depth_plane::{DepthPlane, rounding},
        edge::row_after,
        face_table::{FaceTable, corners_from_top},
        hidden_surfaces::warnock::face_list::FaceList,
        passes::{face_in_first_row, surroundings},
        sides::Sides,
    },
};

/// A face that surrounds a window, with its stored depths at the corner pixels.
#[derive(Debug, Copy, Clone)]
struct Surrounder {
    node: u16,
    plane: DepthPlane,
    depths: [i64; 4],
}

/// Takes those faces off the list of a window that are hidden in it by a face that surrounds it. Columns of the picture count from
/// a column.
pub(super) fn leave_out_hidden<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    list: &mut FaceList<'_>,
    faces: &impl FaceTable<S, D, H>,
    window: &Window,
    first_column: i32,
) {
    let Some(nearest) = nearest_surrounder(list, faces, window, first_column) else {
        return;
    };
    let mut index = list.surrounding();
    while let Some(node) = list.node(index) {
        if hides_part(&nearest, faces, node, window, first_column) {
            list.leave_out(index);
        } else {
            index += 1;
        }
    }
}

/// A face that surrounds the window and is hidden by no other one that does, put first in the list; those that it hides are taken
/// off.
fn nearest_surrounder<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    list: &mut FaceList<'_>,
    faces: &impl FaceTable<S, D, H>,
    window: &Window,
    first_column: i32,
) -> Option<Surrounder> {
    if list.surrounding() == 0 {
        return None;
    }
    let surrounder = |node| surrounder(faces, node, window, first_column);
    let mut nearest = surrounder(list.node(0)?)?;
    let mut index = 1;
    while index < list.surrounding() {
        let other = surrounder(list.node(index)?)?;
        if hides_all(&other, &nearest, faces) {
            list.exchange(0, index);
            nearest = other;
            list.leave_out(index);
        } else if hides_all(&nearest, &other, faces) {
            list.leave_out(index);
        } else {
            index += 1;
        }
    }
    Some(nearest)
}

fn surrounder<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
    window: &Window,
    first_column: i32,
) -> Option<Surrounder> {
    let plane = face_in_first_row(faces, node, &surroundings(faces, first_column))?.plane;
    Some(Surrounder {
        node,
        plane,
        depths: at_corners(&plane, window, first_column),
    })
}

/// The stored depths of a face at the corner pixels of a window that it covers, with fractional bits.
fn at_corners(plane: &DepthPlane, window: &Window, first_column: i32) -> [i64; 4] {
    corner_pixels(window).map(|[column, row]| plane.at(column - first_column, row).0.into())
}

/// The corner pixels of a window.
fn corner_pixels(window: &Window) -> [[i32; 2]; 4] {
    let (right, bottom) = (window.right - 1, window.bottom - 1);
    [
        [window.left, window.top],
        [right, window.top],
        [window.left, bottom],
        [right, bottom],
    ]
}

/// Whether a face hides another one in a window that both surround.
fn hides_all<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    front: &Surrounder,
    back: &Surrounder,
    faces: &impl FaceTable<S, D, H>,
) -> bool {
    let gap = least_gap(faces, front.node, back.node);
    let mut corners = front.depths.iter().zip(&back.depths);
    corners.all(|(front, back)| front - back >= gap)
}

/// Whether a face that surrounds a window hides another one in it, which does not.
fn hides_part<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    front: &Surrounder,
    faces: &impl FaceTable<S, D, H>,
    back: u16,
    window: &Window,
    first_column: i32,
) -> bool {
    let Some(corners) = corners_from_top(faces, back) else {
        return true;
    };
    let part = window.intersection(&box_of_pixels(corners));
    if part.is_empty() {
        // It covers no pixel centre.
        return true;
    }
    let gap = least_gap(faces, front.node, back) + stored_error(faces);
    let depths = at_corners(&front.plane, &part, first_column);
    let highest = corners.iter().map(|corner| corner.z.units()).max().unwrap_or(0);
    let highest = with_fraction::<D>(highest);
    if depths.iter().all(|depth| depth - highest >= gap) {
        return true;
    }
    let Some(back) = UpperPlane::of(corners) else {
        return false;
    };
    let mut depths = depths.iter().zip(corner_pixels(&part));
    depths.all(|(depth, pixel)| depth - back.at(pixel) >= gap)
}

/// By how much, with fractional bits, a plane has to be nearer than another one so that its face is seen wherever both faces are.
fn least_gap<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    front: u16,
    back: u16,
) -> i64 {
    if comes_first(faces, front, back) {
        0
    } else {
        stored_unit::<D>()
    }
}

/// The difference of two neighbouring stored depths, with fractional bits: those of 16 bits are cut off, those of 32 bits are kept.
const fn stored_unit<D: DepthWidth>() -> i64 {
    if D::FRACTION_BITS == 16 { 1 << 16 } else { 1 }
}

/// Whether a face is seen where another one is as near. The parts of one face come in the order of the table.
pub(super) fn comes_first<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    one: u16,
    other: u16,
) -> bool {
    let (first, second) = (faces.order(one), faces.order(other));
    if first != second {
        return first < second;
    }
    let place = |node| {
        let row = corners_from_top(faces, node).map(|corners| Sides::of(corners, 0).first_row::<S>());
        (row.map(|row| row.max(faces.viewport().top)), node)
    };
    place(one) < place(other)
}

/// How far a stored plane may be from the exact one at a pixel that its face covers, with fractional bits: 1/4 unit with depths of
/// 16 bits, else half a step for each column and row of the viewport, and what is rounded at the anchor.
fn stored_error<S: ScreenPrecision, D: DepthWidth, H: Shading>(faces: &impl FaceTable<S, D, H>) -> i64 {
    if D::FRACTION_BITS == 16 {
        return 1 << 14;
    }
    let viewport = faces.viewport();
    (i64::from(viewport.width()) + i64::from(viewport.height())) / 2 + 4
}

/// A depth as planes have it: with fractional bits, and rounded by cutting them off.
fn with_fraction<D: DepthWidth>(units: i32) -> i64 {
    (i64::from(units) << D::FRACTION_BITS) + i64::from(rounding::<D>().0)
}

/// The pixels whose centres are in the bounding box of a face.
fn box_of_pixels<S: ScreenPrecision, D: DepthWidth>([a, b, c]: [&ScreenVertex<S, D>; 3]) -> Window {
    let [a, b, c] = [a, b, c].map(|corner| corner.position());
    let first = |x: i32, y: i32, z: i32| row_after::<S>(x.min(y).min(z));
    let after = |x: i32, y: i32, z: i32| (x.max(y).max(z) >> S::FRACTION_BITS) + 1;
    Window {
        left: first(a.x, b.x, c.x),
        top: first(a.y, b.y, c.y),
        right: after(a.x, b.x, c.x),
        bottom: after(a.y, b.y, c.y),
    }
}

/// A plane that is nowhere below the exact one of a face. Its gradients are rounded down, with four bits fewer than stored depths
/// have, and what they lose on the way is added.
#[derive(Debug, Copy, Clone)]
struct UpperPlane<S, D> {
    top: Position,
    depth: D,
    per_column: i64,
    per_row: i64,
    precision: PhantomData<S>,
}

impl<S: ScreenPrecision, D: DepthWidth> UpperPlane<S, D> {
    /// Fractional bits of the gradients.
    const BITS: u32 = D::FRACTION_BITS - 4;

    /// The plane of a face; `None` where it is too steep for 64 bits.
    fn of(corners: [&ScreenVertex<S, D>; 3]) -> Option<Self> {
        let Sides { top, right, left } = Sides::of(corners, 0);
        let [depth, z1, z2] = corners.map(|corner| corner.z);
        let [z1, z2] = [z1, z2].map(|other| other.units() - depth.units());
        let difference = |a: i32, b: i32, c: i32, d: i32| i64::from(a) * i64::from(b) - i64::from(c) * i64::from(d);
        let area = difference(right.x, left.y, left.x, right.y);
        if area <= 0 {
            return None;
        }
        // Differences of positions are below 2^23, those of depths below 2^24 with 4 bits here and 2^16 with 12: below 2^60.
        let gradient = |numerator: i64| (numerator << (S::FRACTION_BITS + Self::BITS)).div_euclid(area);
        let per_column = gradient(difference(z1, left.y, z2, right.y));
        let per_row = gradient(difference(right.x, z2, left.x, z1));
        let is_steep = |gradient: i64| gradient.unsigned_abs() >= 1 << 38;
        if is_steep(per_column) || is_steep(per_row) {
            return None;
        }
        Some(Self {
            top,
            depth,
            per_column,
            per_row,
            precision: PhantomData,
        })
    }

    /// The plane at a pixel, with the fractional bits of stored depths.
    fn at(&self, [column, row]: [i32; 2]) -> i64 {
        let right = i64::from((column << S::FRACTION_BITS) - self.top.x);
        let down = i64::from((row << S::FRACTION_BITS) - self.top.y);
        // Below 2^38 times 2^23 each.
        let gained = (self.per_column * right + self.per_row * down) >> S::FRACTION_BITS;
        // A gradient is less than a step too low, for each pixel on the way.
        let lost = ((right.abs() + down.abs()) >> S::FRACTION_BITS) + 2;
        with_fraction::<D>(self.depth.units()) + ((gained + lost) << 4)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{
        cases::config,
        geometry::{Sub4, Sub8},
        visible::active_face::from_top,
    };

    /// Checks the upper plane of a face at pixels in its box against the exact plane in 128-bit numbers, times the area.
    fn check<S: ScreenPrecision, D: DepthWidth>(positions: [[i32; 2]; 3], depths: [i32; 3]) {
        let [a, b, c] = [0, 1, 2].map(|corner| ScreenVertex::<S, D> {
            x: S::narrow(positions[corner][0]),
            y: S::narrow(positions[corner][1]),
            z: D::from_units(depths[corner]),
        });
        let corners = from_top([&a, &b, &c]);
        let Some(plane) = UpperPlane::of(corners) else {
            return;
        };
        let [top, right, left] =
            corners.map(|corner| [corner.x_units(), corner.y_units(), corner.z.units()].map(i128::from));
        let [x1, y1, z1] = [0, 1, 2].map(|axis| right[axis] - top[axis]);
        let [x2, y2, z2] = [0, 1, 2].map(|axis| left[axis] - top[axis]);
        let (area, unit) = (x1 * y2 - x2 * y1, 1i128 << S::FRACTION_BITS);
        let pixels = box_of_pixels(corners);
        if pixels.is_empty() {
            return;
        }
        for [column, row] in corner_pixels(&pixels) {
            let (x, y) = (i128::from(column) * unit - top[0], i128::from(row) * unit - top[1]);
            let gained = (z1 * y2 - z2 * y1) * x + (x1 * z2 - x2 * z1) * y;
            let exact = ((top[2] * area + gained) << D::FRACTION_BITS) + i128::from(rounding::<D>().0) * area;
            let above = i128::from(plane.at([column, row])) * area - exact;
            // To the left, gradients that are too low gain too much, and what is added to make up for them comes on top.
            let most = (2 * (x.abs() + y.abs()) / unit + 4) * 16;
            assert!(
                (0..=most * area).contains(&above),
                "{positions:?} {depths:?} {column} {row}"
            );
        }
    }

    fn positions(size: i32) -> impl Strategy<Value = [[i32; 2]; 3]> {
        prop::array::uniform3(prop::array::uniform2(-size..=size))
    }

    proptest! {
        #![proptest_config(config(2_000))]

        #[test]
        fn upper_planes_are_little_above_the_exact_ones(
            positions_in_16ths in positions(16_368),
            small in positions(300),
            positions_in_256ths in positions(8191 * 256),
            depths in prop::array::uniform3(1..0x1_0000),
            deep in prop::array::uniform3(16..0x100_0000 - 16),
        ) {
            for positions in [positions_in_16ths, small] {
                check::<Sub4, u16>(positions, depths);
                check::<Sub4, u32>(positions, deep);
            }
            for positions in [positions_in_256ths, small] {
                check::<Sub8, u16>(positions, depths);
                check::<Sub8, u32>(positions, deep);
            }
        }
    }
}
