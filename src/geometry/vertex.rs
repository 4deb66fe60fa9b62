//! Vertices of polygons: whole pixels or sub-pixel points.

use core::fmt::Debug;

use embedded_graphics::geometry::Point;

use crate::geometry::{SubPixel, SubPoint};

/// A corner of a polygon: a pixel (any `i32`), or a [`SubPoint`] of either precision.
///
/// Points of a font in 1/64 pixel, filled as they are:
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use zrow::{
///     draw::{FillRule, Polygon, PrimitiveStyle},
///     geometry::Vertex,
/// };
///
/// /// 26.6 fixed point, as FreeType has it.
/// #[derive(Debug, Copy, Clone)]
/// struct FontPoint(i16, i16);
///
/// impl Vertex for FontPoint {
///     const FRACTION_BITS: u32 = 6;
///     fn x_units(&self) -> i32 { self.0.into() }
///     fn y_units(&self) -> i32 { self.1.into() }
/// }
///
/// let contours = [[FontPoint(96, -32), FontPoint(224, 160), FontPoint(-32, 160)].as_slice()];
/// let glyph = Polygon::new(&contours, FillRule::NonZero).prepare::<2, 2>()?;
/// let mut display = MockDisplay::new();
/// let Ok(()) = glyph.into_styled(PrimitiveStyle::with_fill(BinaryColor::On)).draw(&mut display);
/// display.assert_pattern(&["    ", " ## ", "####"]);
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
///
/// A vertex type with more than 16 fractional bits does not compile where it is used:
///
/// ```compile_fail,E0080
/// use embedded_graphics::geometry::Dimensions;
/// use zrow::{draw::{FillRule, Polygon}, geometry::Vertex};
///
/// #[derive(Debug, Copy, Clone)]
/// struct Fine;
///
/// impl Vertex for Fine {
///     const FRACTION_BITS: u32 = 17;
///     fn x_units(&self) -> i32 { 0 }
///     fn y_units(&self) -> i32 { 0 }
/// }
///
/// let contours = [&[Fine; 3][..]];
/// let pixels = Polygon::new(&contours, FillRule::NonZero).bounding_box();
/// ```
pub trait Vertex: Copy + Debug {
    /// Fractional bits: a pixel is `1 << FRACTION_BITS` units. At most 16.
    const FRACTION_BITS: u32;

    /// Column in units.
    fn x_units(&self) -> i32;

    /// Row in units.
    fn y_units(&self) -> i32;
}

/// Refuses a vertex type with more than 16 fractional bits: at compile time, when called in a `const` block.
pub(crate) const fn assert_fraction_bits<V: Vertex>() {
    assert!(V::FRACTION_BITS <= 16, "a vertex has at most 16 fractional bits");
}

impl Vertex for Point {
    const FRACTION_BITS: u32 = 0;

    fn x_units(&self) -> i32 {
        self.x
    }

    fn y_units(&self) -> i32 {
        self.y
    }
}

impl<S: SubPixel> Vertex for SubPoint<S> {
    const FRACTION_BITS: u32 = S::FRACTION_BITS;

    fn x_units(&self) -> i32 {
        SubPoint::x_units(self)
    }

    fn y_units(&self) -> i32 {
        SubPoint::y_units(self)
    }
}
