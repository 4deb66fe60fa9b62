//! Liang and Barsky's segment clipping in homogeneous space (1984, "A New Concept and Method for Line Clipping", ACM
//! Transactions on Graphics 3(1), section 5): in four dimensions, against -w <= x <= w, -w <= y <= w, 0 <= z <= w.
//!
//! ```text
//!     d >= 0 inside     left   w + x     bottom  w + y     near  z
//!                       right  w - x     top     w - y     far   w - z
//!
//!     from *---entry=====exit---* to     entry: the last plane that is crossed inwards
//!                                        exit: the first one that is crossed outwards
//! ```
//!
//! Each of the six distances changes evenly along the segment, so that it is 0 at the fraction d0 / (d0 - d1). Nothing is
//! divided by w, which may be 0 or negative: both ends may lie behind the eye, or the segment pass through it. Before the
//! division there is no such place; after it, what is behind the eye appears upside down in front of it, and the segment goes
//! the other way round.
//!
//! Guarantees: the result is exactly what of the segment lies in the closed volume, touching a corner included; exchanging the
//! end points exchanges the ends of the result and changes nothing else. [`Segments::homogeneous_cohen_sutherland`] and
//! [`Segments::eye_space`] give the same parts.

use crate::clip::{
    segment::segments::Segments,
    space::{clip_matrix::ClipMatrix, clip_point::ClipPoint, fraction::Fraction, space_segment::SpaceSegment},
};

impl Segments {
    /// The part of the segment between two vertices that a camera sees, by how far along it enters and leaves the six planes in
    /// homogeneous clip coordinates; `None` where no point of it is visible. Right for vertices beside the eye and behind it.
    ///
    /// Takes any vertices. Cost: two products with the matrix, then for each plane that is crossed four products to compare
    /// fractions. Source: Liang and Barsky 1984.
    ///
    /// ```
    /// use embedded_graphics::{prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{clip::{ClipMatrix, Segments}, geometry::{Sub4, SubPoint}, scene::{Camera, Pose}};
    ///
    /// let viewport = Rectangle::new(Point::zero(), Size::new(240, 240));
    /// let camera = Camera::new(viewport, I16F16::from_num(10))?;
    /// let matrix = ClipMatrix::new(&camera, &Pose::IDENTITY, I16F16::from_num(1000))?;
    /// // From behind the eye to a place in front of it: cut at the near plane.
    /// let part = Segments::homogeneous_liang_barsky([0, 0, -90], [0, 0, 110], &matrix).ok_or("not visible")?;
    /// assert_eq!(part.vertices(), ([0, 0, 10], [0, 0, 110]));
    /// // A brightness from 0 to 200 is 100 where the segment is cut.
    /// assert_eq!(part.attribute(0, 200), (100, 200));
    /// let (near, _) = part.ends(&matrix);
    /// assert_eq!(near.on_screen::<Sub4>(&camera), Some(SubPoint::from_units(1912, 1912)?));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn homogeneous_liang_barsky(from: [i16; 3], to: [i16; 3], matrix: &ClipMatrix) -> Option<SpaceSegment> {
        let (start, end) = (distances(matrix.apply(from)), distances(matrix.apply(to)));
        let mut part = SpaceSegment::whole(from, to);
        for (start, end) in start.into_iter().zip(end) {
            match (start < 0, end < 0) {
                (false, false) => {}
                (true, true) => return None,
                (true, false) => {
                    let cut = Fraction::of_crossing(start, end);
                    if part.entry.is_none_or(|entry| entry.compare(&cut).is_lt()) {
                        part.entry = Some(cut);
                    }
                }
                (false, true) => {
                    let cut = Fraction::of_crossing(start, end);
                    if part.exit.is_none_or(|exit| cut.compare(&exit).is_lt()) {
                        part.exit = Some(cut);
                    }
                }
            }
        }
        match (&part.entry, &part.exit) {
            (Some(entry), Some(exit)) if exit.compare(entry).is_lt() => None,
            _ => Some(part),
        }
    }
}

/// How far inside of the six planes a point is: left, right, bottom, top, near, far. Of coordinates that a matrix made, below
/// 2^60.
fn distances(ClipPoint { x, y, z, w }: ClipPoint) -> [i64; 6] {
    [w + x, w - x, w + y, w - y, z, w - z]
}
