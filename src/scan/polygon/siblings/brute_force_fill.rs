//! Filling by asking for every pixel of the bounding box where it lies: the definition of a fill, for contours of any kind.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline) whichever test of
//! [`point_in_polygon`] is taken; a pixel whose centre is on the boundary belongs by the
//! top-left rule. No table, nothing that can be full.
//!
//! Cost: pixels times edges. Take it where there is no memory for a table, for the few pixels of a tiny polygon, or as the
//! reference that others are held against.

use core::{
    fmt::{self, Debug},
    marker::PhantomData,
};

use crate::{
    geometry::{Vertex, Window},
    scan::polygon::{
        pixel_bounds,
        point_in_polygon::{self, Location},
        polygons::Polygons,
        scanline_polygon::FillRule,
    },
    surface::Span,
};

/// The centre of a pixel, in the units of vertices `V`.
#[derive(Copy, Clone)]
pub struct PixelCentre<V> {
    x: i32,
    y: i32,
    units: PhantomData<V>,
}

impl<V> Debug for PixelCentre<V> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_tuple("PixelCentre")
            .field(&self.x)
            .field(&self.y)
            .finish()
    }
}

#[cfg(feature = "defmt")]
impl<V> defmt::Format for PixelCentre<V> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "PixelCentre({}, {})", self.x, self.y);
    }
}

impl<V: Vertex> Vertex for PixelCentre<V> {
    const FRACTION_BITS: u32 = V::FRACTION_BITS;

    fn x_units(&self) -> i32 {
        self.x
    }

    fn y_units(&self) -> i32 {
        self.y
    }
}

impl Polygons {
    /// Hands over the visible spans of a polygon, top to bottom and left to right in each row, by asking where each pixel lies.
    ///
    /// `locate` is one of the tests of a point, such as [`Polygons::winding_number`](crate::scan::Polygons::winding_number). The pixels are
    /// those of [`Polygons::scanline`](crate::scan::Polygons::scanline). Cost: pixels times edges.
    ///
    /// ```
    /// use core::convert::Infallible;
    /// use embedded_graphics::geometry::Point;
    /// use zrow::{
    ///     geometry::Window,
    ///     scan::{FillRule, Polygons},
    /// };
    ///
    /// let diamond = [Point::new(3, 0), Point::new(6, 3), Point::new(3, 6), Point::new(0, 3)];
    /// let window = Window { left: 0, top: 0, right: 8, bottom: 8 };
    /// let mut pixels = 0;
    /// Polygons::brute_force(&[&diamond], FillRule::EvenOdd, &window, Polygons::winding_number, |span| {
    ///     pixels += span.end - span.start;
    ///     Ok::<(), Infallible>(())
    /// })?;
    /// assert_eq!(pixels, 18);
    /// # Ok::<(), Infallible>(())
    /// ```
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn brute_force<V: Vertex, E>(
        contours: &[&[V]],
        rule: FillRule,
        window: &Window,
        mut locate: impl FnMut(&[&[V]], FillRule, &PixelCentre<V>) -> Location,
        mut emit: impl FnMut(Span) -> Result<(), E>,
    ) -> Result<(), E> {
        let visible = pixel_bounds::visible(contours, window);
        if visible.is_empty() {
            return Ok(());
        }
        let mut belongs = |x: i32, y: i32| {
            let centre = PixelCentre {
                x: x << V::FRACTION_BITS,
                y: y << V::FRACTION_BITS,
                units: PhantomData,
            };
            match locate(contours, rule, &centre) {
                Location::Inside => true,
                Location::Outside => false,
                Location::OnBoundary => is_right_or_below(contours, rule, &centre),
            }
        };
        for y in visible.top..visible.bottom {
            let mut start = None;
            for x in visible.left..visible.right {
                match (belongs(x, y), start) {
                    (true, None) => start = Some(x),
                    (false, Some(first)) => {
                        emit(Span::new(y, first, x))?;
                        start = None;
                    }
                    _ => {}
                }
            }
            if let Some(first) = start {
                emit(Span::new(y, first, visible.right))?;
            }
        }
        Ok(())
    }
}

/// The top-left rule: whether the inside is right of a point, or below it where an edge runs on to the right.
///
/// That is the winding number of a point a little to the right and far less downwards: edges count from their upper end to
/// before their lower one, and where they go through the point.
fn is_right_or_below<V: Vertex>(contours: &[&[V]], rule: FillRule, centre: &PixelCentre<V>) -> bool {
    let row = centre.y;
    let mut winding = 0i32;
    point_in_polygon::visit_edges(contours, |from, to| {
        let crosses = (from.1 <= row) != (to.1 <= row);
        if crosses && point_in_polygon::from_edge((centre.x, row), from, to).is_ge() {
            winding += if from.1 < to.1 { 1 } else { -1 };
        }
        Some(())
    });
    rule.includes(winding)
}
