//! The colours of panels: those that are drawn in, and those that are dithered on the way to the panel.

use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888};
use zrow::{
    band::{BandColor, Dithered, LittleEndian, LoopError, Sink},
    geometry::InputError,
    shade::ChannelColor,
};

use crate::{playground::Playground, state::Depth};

/// A colour that is drawn in.
pub trait DrawnColor: ChannelColor + From<Rgb888> + From<Rgb565> {}

impl DrawnColor for Rgb888 {}
impl DrawnColor for Rgb565 {}
impl DrawnColor for Gray8 {}

/// How drawing ends.
pub type Drawn<E> = Result<(), LoopError<E, InputError>>;

/// A colour of a panel.
pub trait PanelColor: BandColor + Into<Rgb888> {
    /// Draws the prepared state in bands, which the sink gets in the colour of the panel.
    ///
    /// # Errors
    /// The sink's own, and those of the scene.
    fn draw<S: Sink<Self, LittleEndian>>(playground: &mut Playground, sink: S) -> Drawn<S::Error>;
}

impl PanelColor for Rgb888 {
    fn draw<S: Sink<Self, LittleEndian>>(playground: &mut Playground, mut sink: S) -> Drawn<S::Error> {
        playground.draw_bands(&mut sink)
    }
}

impl PanelColor for Rgb565 {
    fn draw<S: Sink<Self, LittleEndian>>(playground: &mut Playground, mut sink: S) -> Drawn<S::Error> {
        if playground.state().depth == Depth::DitheredRgb565 {
            playground.draw_bands::<Rgb888, _>(&mut Dithered::new(sink))
        } else {
            playground.draw_bands(&mut sink)
        }
    }
}

impl PanelColor for Gray4 {
    fn draw<S: Sink<Self, LittleEndian>>(playground: &mut Playground, sink: S) -> Drawn<S::Error> {
        playground.draw_bands::<Gray8, _>(&mut Dithered::new(sink))
    }
}

impl PanelColor for BinaryColor {
    fn draw<S: Sink<Self, LittleEndian>>(playground: &mut Playground, sink: S) -> Drawn<S::Error> {
        playground.draw_bands::<Gray8, _>(&mut Dithered::new(sink))
    }
}
