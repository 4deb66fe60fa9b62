//! The areas of fill and stroke of a styled shape, as shapes of the same kind.

use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::{Circle, CornerRadii, Ellipse, Rectangle, RoundedRectangle, Sector, Styled},
};

use crate::{draw::PrimitiveStyle, geometry::WideRectangle};

// In the prelude, without a name.
/// The areas of a closed shape in a [`PrimitiveStyle`]: the methods that embedded-graphics' `Styled` has with its own
/// style.
///
/// Each side of the shape is moved by the stroke's inside or outside part. Coordinates of the top left corner saturate
/// at the ends of the number range.
///
/// ```
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Circle};
/// use zrow::prelude::*;
///
/// let circle = Circle::new(Point::new(10, 10), 9).into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 4));
/// assert_eq!(circle.fill_area(), Circle::new(Point::new(12, 12), 5));
/// assert_eq!(circle.stroke_area(), Circle::new(Point::new(8, 8), 13));
/// ```
pub trait StyledAreas {
    /// The type of the areas: that of the styled shape.
    type Shape;

    /// The shape whose pixels the fill colour takes: the shape without the stroke's inside part.
    fn fill_area(&self) -> Self::Shape;

    /// The shape whose pixels the stroke and the fill colour take together: the shape with the stroke's outside part.
    fn stroke_area(&self) -> Self::Shape;
}

/// The number of pixels by which each side of a shape is moved, and the direction.
#[derive(Copy, Clone)]
enum Offset {
    Inwards(u32),
    Outwards(u32),
}

impl Offset {
    /// Moves the sides of a box. The coordinates of its position saturate at the ends of the number range; the size
    /// does not depend on that.
    fn of_box(self, rectangle: Rectangle) -> Rectangle {
        let wide = WideRectangle::from(rectangle);
        let WideRectangle { left, top, size } = match self {
            Self::Inwards(by) => wide.inset(by),
            Self::Outwards(by) => wide.outset(by),
        };
        let coordinate = |value: i64| value.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32;
        Rectangle::new(Point::new(coordinate(left), coordinate(top)), size)
    }

    /// Changes a corner's radius by the offset, as embedded-graphics does.
    fn of_radius(self, radius: Size) -> Size {
        match self {
            Self::Inwards(by) => radius.saturating_sub(Size::new_equal(by)),
            Self::Outwards(by) => radius.saturating_add(Size::new_equal(by)),
        }
    }
}

/// A closed shape whose sides can be moved outwards or inwards.
trait Sides {
    /// The shape with each side moved by the offset.
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
