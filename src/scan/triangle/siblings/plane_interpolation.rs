//! Attributes of a triangle by their planes over the screen: from pixel to pixel an attribute gains the same number.
//!
//! An attribute that varies evenly over a triangle is a plane, `a(x, y) = a0 + gx (x - x0) + gy (y - y0)`. Its gradients are
//! quotients of cross products by twice the area (Fuchs et al. 1985; Pineda 1988 for all parameters of a triangle). They are
//! divided once a triangle, from the pixel nearest to its first corner on; a span begins with two products, and a pixel takes
//! one addition an attribute.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline), each attribute less than 3/4 of a unit
//! from the exact plane: 1/2 for rounding, and at most 2^-17 for each column and row of the way from the first corner, of which
//! the domain has fewer than 2^15. Sums wrap around, as gradients of slivers do not fit 32 bits; attributes always do.
//!
//! The faces of [`Gouraud`](crate::shade::Gouraud) shading are interpolated by planes, too, by code of their own.

use core::num::{NonZeroU64, Wrapping};

use embedded_graphics::geometry::Point;

use crate::{
    geometry::{SubPixel, SubPoint, Window, quotient_nearest},
    scan::{
        polygon::Polygons,
        triangle::siblings::edge_function::{Units, in_domain},
    },
};

/// An attribute over a triangle, modulo 2^16, with 16 fractional bits.
#[derive(Copy, Clone)]
struct AttributePlane {
    /// The attribute at the pixel nearest to the first corner, and half a unit.
    start: Wrapping<i32>,
    per_column: Wrapping<i32>,
    per_row: Wrapping<i32>,
}

impl Polygons {
    /// Hands over the visible pixels of a convex polygon, each with its attributes, by the planes of the attributes over the
    /// triangles between its first corner and each of its sides.
    ///
    /// Corners are in either order, clockwise or not; fewer than three have no pixels. In a triangle each attribute is less
    /// than 3/4 of a unit from the exact one. Polygons of more corners show along which diagonals they were divided.
    ///
    /// Cost: three divisions an attribute and triangle, two products an attribute and row, an addition an attribute and pixel.
    /// Source: Fuchs et al. 1985; Pineda 1988.
    ///
    /// ```
    /// use core::convert::Infallible;
    /// use zrow::{geometry::{Sub4, SubPoint, Window}, scan::Polygons};
    ///
    /// let at = |x, y| SubPoint::<Sub4>::from_units(16 * x, 16 * y);
    /// let corners = [(at(0, 0)?, [0, 90]), (at(3, 0)?, [30, 90]), (at(0, 3)?, [0, 0])];
    /// let window = Window { left: 0, top: 0, right: 8, bottom: 8 };
    /// let mut row = Vec::new();
    /// let Ok(()) = Polygons::plane_interpolation(&corners, &window, |pixel, attributes| {
    ///     if pixel.y == 1 {
    ///         row.push(attributes);
    ///     }
    ///     Ok::<(), Infallible>(())
    /// });
    /// assert_eq!(row, [[0, 60], [10, 60]]);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn plane_interpolation<S: SubPixel, E, const N: usize>(
        corners: &[(SubPoint<S>, [i16; N])],
        window: &Window,
        mut emit: impl FnMut(Point, [i16; N]) -> Result<(), E>,
    ) -> Result<(), E> {
        visit_fan(corners, |triangle| {
            let Some((first, planes)) = planes(&triangle) else {
                return Ok(());
            };
            Self::incremental_edge_triangle(triangle.map(|(vertex, _)| vertex), window, |span| {
                // Both are in the domain.
                let way = (Wrapping(span.start - first.x), Wrapping(span.y - first.y));
                let mut values = planes.map(|plane| plane.start + plane.per_column * way.0 + plane.per_row * way.1);
                for x in span.start..span.end {
                    emit(Point::new(x, span.y), values.map(|value| (value.0 >> 16) as i16))?;
                    for (value, plane) in values.iter_mut().zip(&planes) {
                        *value += plane.per_column;
                    }
                }
                Ok(())
            })
        })
    }
}

/// Visits the triangles between the first corner of a polygon and each side that it is not on.
pub(super) fn visit_fan<C: Copy, E>(corners: &[C], mut visit: impl FnMut([C; 3]) -> Result<(), E>) -> Result<(), E> {
    let [first, others @ ..] = corners else { return Ok(()) };
    for side in others.windows(2) {
        if let &[second, third] = side {
            visit([*first, second, third])?;
        }
    }
    Ok(())
}

/// The pixel nearest to the first corner of a triangle, and the planes of its attributes; `None` for a triangle without area
/// or with a vertex beyond the domain.
fn planes<S: SubPixel, const N: usize>(
    triangle: &[(SubPoint<S>, [i16; N]); 3],
) -> Option<(Point, [AttributePlane; N])> {
    let [(a, of_a), (b, of_b), (c, of_c)] = triangle;
    let (a, b, c) = (in_domain(a)?, in_domain(b)?, in_domain(c)?);
    let (to_b, to_c) = (way(a, b), way(a, c));
    let area = to_b.0 * to_c.1 - to_c.0 * to_b.1;
    let size = NonZeroU64::new(area.unsigned_abs())?;
    let nearest = |units: i32| (units + (1 << (S::FRACTION_BITS - 1))) >> S::FRACTION_BITS;
    let first = (nearest(a.0), nearest(a.1));
    let to_first = way(a, (first.0 << S::FRACTION_BITS, first.1 << S::FRACTION_BITS));
    let mut others = of_b.iter().zip(of_c);
    let planes = of_a.map(|of_a| {
        let (of_b, of_c) = others.next().unwrap_or((&0, &0));
        let (b, c) = (i64::from(*of_b) - i64::from(of_a), i64::from(*of_c) - i64::from(of_a));
        // Two products below 2^16 and (16,382 << 8), and so their difference below 2^39 - 2^27: with 24 more bits it fits, and
        // so do two products of such a difference and 128 with 16 more bits.
        let (x, y) = (b * to_c.1 - c * to_b.1, to_b.0 * c - to_c.0 * b);
        let divided = |numerator: i64| Wrapping((quotient_nearest(numerator, size) * area.signum()) as i32);
        AttributePlane {
            start: divided((x * to_first.0 + y * to_first.1) << 16)
                + Wrapping(i32::from(of_a) << 16)
                + Wrapping(1 << 15),
            per_column: divided(x << (16 + S::FRACTION_BITS)),
            per_row: divided(y << (16 + S::FRACTION_BITS)),
        }
    });
    Some((Point::new(first.0, first.1), planes))
}

/// The way from one point to another, in units.
fn way(from: Units, to: Units) -> (i64, i64) {
    (i64::from(to.0) - i64::from(from.0), i64::from(to.1) - i64::from(from.1))
}
