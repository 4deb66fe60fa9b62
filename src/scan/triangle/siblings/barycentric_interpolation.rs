//! Attributes of a triangle by barycentric coordinates (Möbius 1827): the mean of the corners' attributes, each weighted with
//! the area of the triangle between the pixel and the opposite side.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline), each attribute the exact one, rounded to
//! the nearest; so never outside of those of the corners. Weights are whole numbers, 46 bits at most, and are stepped from
//! pixel to pixel.

use core::num::NonZeroU64;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::{SubPixel, SubPoint, Window, quotient_nearest},
    scan::{
        polygon::Polygons,
        triangle::siblings::{
            edge_function::{Units, in_domain},
            plane_interpolation::visit_fan,
        },
    },
};

impl Polygons {
    /// Hands over the visible pixels of a convex polygon, each with its attributes, by barycentric coordinates in the triangles
    /// between its first corner and each of its sides.
    ///
    /// The pixels are those of [`plane_interpolation`](Self::plane_interpolation), and so are the attributes to within one
    /// unit; here they are the exact ones, rounded to the nearest.
    ///
    /// Cost: three products and a division of 64 bits an attribute and pixel. Source: Möbius 1827.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn barycentric_interpolation<S: SubPixel, E, const N: usize>(
        corners: &[(SubPoint<S>, [i16; N])],
        window: &Window,
        mut emit: impl FnMut(Point, [i16; N]) -> Result<(), E>,
    ) -> Result<(), E> {
        visit_fan(corners, |triangle| {
            let [(a, of_a), (b, of_b), (c, of_c)] = triangle;
            let (Some(units_a), Some(units_b), Some(units_c)) = (in_domain(&a), in_domain(&b), in_domain(&c)) else {
                return Ok(());
            };
            let area = cross(units_a, units_b, units_c);
            let Some(size) = NonZeroU64::new(area.unsigned_abs()) else {
                return Ok(());
            };
            // What a pixel to the right adds to the weights of b and c.
            let to_right = |from: Units, to: Units| (i64::from(from.1) - i64::from(to.1)) << S::FRACTION_BITS;
            let (step_b, step_c) = (to_right(units_c, units_a), to_right(units_a, units_b));
            Self::incremental_edge_triangle([a, b, c], window, |span| {
                let pixel = (span.start << S::FRACTION_BITS, span.y << S::FRACTION_BITS);
                let (mut weight_b, mut weight_c) = (cross(units_c, units_a, pixel), cross(units_a, units_b, pixel));
                for x in span.start..span.end {
                    let weight_a = area - weight_b - weight_c;
                    let mut others = of_b.iter().zip(&of_c);
                    let values = of_a.map(|of_a| {
                        let (of_b, of_c) = others.next().unwrap_or((&0, &0));
                        // All weights have the sign of the area, which is their sum: below 2^61.
                        let sum =
                            weight_a * i64::from(of_a) + weight_b * i64::from(*of_b) + weight_c * i64::from(*of_c);
                        (quotient_nearest(sum, size) * area.signum()) as i16
                    });
                    emit(Point::new(x, span.y), values)?;
                    weight_b += step_b;
                    weight_c += step_c;
                }
                Ok(())
            })
        })
    }
}

/// Twice the area of a triangle in square units: positive clockwise on the screen. The cross product of the way from the first
/// point to the second with that to the third.
fn cross(from: Units, to: Units, point: Units) -> i64 {
    let way = |from: i32, to: i32| i64::from(to) - i64::from(from);
    way(from.0, to.0) * way(from.1, point.1) - way(from.1, to.1) * way(from.0, point.0)
}
