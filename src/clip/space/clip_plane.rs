//! Planes in space, which bound what is kept.

/// A plane in the space of a model's vertices, and the side of it that is kept; the plane itself is kept.
///
/// Several of them bound a convex volume, such as what a camera sees ([`ClipMatrix::planes`](crate::clip::ClipMatrix::planes)),
/// a room or a portal.
///
/// ```
/// use zrow::clip::{ClipPlane, Segments};
///
/// // What is not below y = 100.
/// let above = ClipPlane::through([0, 100, 0], [0, 1, 0]);
/// let segment = Segments::cyrus_beck_in_space([0, 0, 0], [0, 400, 0], &[above]);
/// assert_eq!(segment.map(|segment| segment.vertices()), Some(([0, 100, 0], [0, 400, 0])));
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ClipPlane(pub(super) [i64; 4]);

impl ClipPlane {
    /// The plane through a point, at right angles to a vector of any length that points to what is kept. A vector of length 0
    /// keeps everything.
    pub fn through(point: [i16; 3], inwards: [i32; 3]) -> Self {
        let ([a, b, c], [x, y, z]) = (inwards.map(i64::from), point.map(i64::from));
        // Three products below 2^47.
        Self([a, b, c, -(a * x + b * y + c * z)])
    }

    /// How far a vertex is on the kept side of the plane, exactly, in units of the plane's own numbers: 0 on the plane,
    /// negative on the other side.
    ///
    /// Where the plane's elements are below 2^43 and its offset below 2^60, the result is below 2^61.
    pub(super) fn distance(&self, vertex: [i16; 3]) -> i64 {
        let ([a, b, c, offset], [x, y, z]) = (self.0, vertex.map(i64::from));
        a * x + b * y + c * z + offset
    }
}
