//! The style that asks for antialiased edges.

/// A style whose edges are antialiased by exact area: what
/// [`PrimitiveStyle::antialiased`](crate::draw::PrimitiveStyle::antialiased) and
/// [`StrokeStyle::antialiased`](crate::draw::StrokeStyle::antialiased) give.
///
/// Shapes in such a style are drawn on [`Band::antialiased`](crate::band::Band::antialiased), the band with the memory that
/// they take, by [`DrawAntialiased::draw_on`](crate::draw::DrawAntialiased::draw_on); or they are items of a
/// [`Picture`](crate::draw::Picture), which prepares each of them once:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, PrimitiveStyleBuilder, Rectangle}};
/// use zrow::draw::{AntialiasingMemory, Picture, PictureSlot, PrimitiveStyle};
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 64], [0; 64]);
/// let mut memory = AntialiasingMemory::<65, 32, 8>::new();
/// let mut picture: Picture<Rgb565> =
///     Picture::new(area, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
/// let style = PrimitiveStyleBuilder::new().fill_color(Rgb565::BLUE).stroke_color(Rgb565::WHITE).stroke_width(3);
/// let style = PrimitiveStyle::from(style.build());
/// picture.add(&Circle::new(Point::new(4, 4), 50).into_styled(style.antialiased()))?;
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Antialiased<S>(pub S);
