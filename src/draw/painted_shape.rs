//! A shape in its style, every pixel of which takes its colour from a paint.

use embedded_graphics::{geometry::Dimensions, primitives::Rectangle};

use crate::{draw::DrawOn, shade::Paint, surface::Target};

/// What draws on a target, a shape in its style or a text, in the colours of a pattern or a gradient instead of its own.
///
/// The paint lies in the picture's coordinates: it does not move with the shape. A shape with a painted fill and a stroke
/// of one colour is two of them: the fill in the paint, and the stroke as it is.
///
/// Its edges are not antialiased. In a picture a smooth shape in a gradient is a
/// [group with a clip path](crate::draw::Picture::begin_path_group), the outline of the shape, around a painted rectangle.
///
/// As an item of a picture it is kept by reference ([`Picture::add_item`](crate::draw::Picture::add_item)), and drawn in
/// each band that meets it:
///
/// ```
/// use embedded_graphics::{pixelcolor::{Gray8, Rgb888}, prelude::*, primitives::{Circle, Rectangle}};
/// use zrow::{
///     band::Band,
///     draw::{PaintedShape, Picture, PictureSlot, PrimitiveStyle},
///     shade::{LinearGradient, Ramp},
/// };
///
/// let ramp = Ramp::between(Rgb888::WHITE, Rgb888::BLACK);
/// let gradient = LinearGradient::<Gray8, 2>::new(Point::new(0, 0), Point::new(0, 15), ramp).unwrap();
/// let disc = Circle::new(Point::zero(), 16).into_styled(PrimitiveStyle::with_fill(Gray8::WHITE));
/// let disc = PaintedShape { shape: disc, paint: &gradient };
///
/// let area = Rectangle::new(Point::zero(), Size::new(16, 16));
/// let mut slots = [PictureSlot::EMPTY; 1];
/// let mut picture = Picture::new(area, &mut slots, &mut [], &mut []);
/// picture.add_item(&disc)?;
///
/// let mut words = [0; 16 * 16];
/// picture.draw(&mut Band::<Gray8>::new(area, &mut words)?);
/// assert_eq!((words[8], words[5 * 16 + 8]), (255, 170));
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PaintedShape<S, P> {
    /// What is drawn.
    pub shape: S,
    /// Where the colour of each pixel comes from.
    pub paint: P,
}

impl<S, P> DrawOn for PaintedShape<S, P>
where
    S: DrawOn,
    P: Paint<Color = S::Color>,
{
    type Color = S::Color;

    fn draw_on<T: Target<Color = S::Color>>(&self, target: &mut T) -> Result<(), T::Error> {
        self.shape.draw_on(&mut target.painted(&self.paint))
    }
}

impl<S: Dimensions, P> Dimensions for PaintedShape<S, P> {
    fn bounding_box(&self) -> Rectangle {
        self.shape.bounding_box()
    }
}
