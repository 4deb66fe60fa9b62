//! What the inside and the stroke of a closed shape reach to, as shapes of the same kind.

use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::{Circle, CornerRadii, Ellipse, Rectangle, RoundedRectangle, Sector, Styled},
};

use crate::{draw::PrimitiveStyle, geometry::WideRectangle};

/// The areas of a closed shape in a [`PrimitiveStyle`], under the names that embedded-graphics' `Styled` has for its style.
///
/// A top left corner that lies outside the number range ends there.
///
/// ```
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Circle};
/// use zrow::draw::{PrimitiveStyle, StyledAreas};
///
/// let circle = Circle::new(Point::new(10, 10), 9).into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 4));
/// assert_eq!(circle.fill_area(), Circle::new(Point::new(12, 12), 5));
/// assert_eq!(circle.stroke_area(), Circle::new(Point::new(8, 8), 13));
/// ```
pub trait StyledAreas {
    /// The shape of the areas: of the same kind as the styled one.
    type Shape;

    /// The shape whose pixels the fill color takes: the shape itself without what of the stroke lies inside.
    fn fill_area(&self) -> Self::Shape;

    /// The shape whose pixels the stroke and the fill color take together.
    fn stroke_area(&self) -> Self::Shape;
}

/// How many pixels each side of a shape moves, and which way.
#[derive(Copy, Clone)]
enum Offset {
    Inwards(u32),
    Outwards(u32),
}

impl Offset {
    /// Moves the sides of a box. A position outside the number range ends there, and the size stays.
    fn of_box(self, rectangle: Rectangle) -> Rectangle {
        let outline = WideRectangle::from(rectangle);
        let WideRectangle { left, top, size } = match self {
            Self::Inwards(by) => outline.inset(by),
            Self::Outwards(by) => outline.outset(by),
        };
        let coordinate = |value: i64| value.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32;
        Rectangle::new(Point::new(coordinate(left), coordinate(top)), size)
    }

    /// Changes the radius of a corner, as embedded-graphics does.
    fn of_radius(self, radius: Size) -> Size {
        match self {
            Self::Inwards(by) => radius.saturating_sub(Size::new_equal(by)),
            Self::Outwards(by) => radius.saturating_add(Size::new_equal(by)),
        }
    }
}

/// A shape whose sides can be moved.
trait Sides {
    fn moved_by(&self, offset: Offset) -> Self;
}

impl Sides for Rectangle {
    fn moved_by(&self, offset: Offset) -> Self {
        offset.of_box(*self)
    }
}

impl Sides for RoundedRectangle {
    fn moved_by(&self, offset: Offset) -> Self {
        let corners = CornerRadii {
            top_left: offset.of_radius(self.corners.top_left),
            top_right: offset.of_radius(self.corners.top_right),
            bottom_right: offset.of_radius(self.corners.bottom_right),
            bottom_left: offset.of_radius(self.corners.bottom_left),
        };
        Self::new(offset.of_box(self.rectangle), corners)
    }
}

impl Sides for Ellipse {
    fn moved_by(&self, offset: Offset) -> Self {
        let resized = offset.of_box(Rectangle::new(self.top_left, self.size));
        Self::new(resized.top_left, resized.size)
    }
}

impl Sides for Circle {
    fn moved_by(&self, offset: Offset) -> Self {
        let resized = offset.of_box(Rectangle::new(self.top_left, Size::new_equal(self.diameter)));
        Self::new(resized.top_left, resized.size.width)
    }
}

impl Sides for Sector {
    fn moved_by(&self, offset: Offset) -> Self {
        Self::from_circle(self.to_circle().moved_by(offset), self.angle_start, self.angle_sweep)
    }
}

macro_rules! styled_areas {
    ($($shape:ty),+) => {$(
        impl<C: PixelColor> StyledAreas for Styled<$shape, PrimitiveStyle<C>> {
            type Shape = $shape;

            fn fill_area(&self) -> $shape {
                self.primitive.moved_by(Offset::Inwards(self.style.inside_stroke_width()))
            }

            fn stroke_area(&self) -> $shape {
                self.primitive.moved_by(Offset::Outwards(self.style.outside_stroke_width()))
            }
        }
    )+};
}
styled_areas!(Rectangle, RoundedRectangle, Circle, Ellipse, Sector);
