//! What a board has to know of a scene.

use embedded_graphics::{pixelcolor::Rgb888, primitives::Rectangle};
use zrow::{
    band::{Band, BandColor, Order, PictureLoop},
    geometry::InputError,
};

use crate::picture_capacities::PictureCapacities;

/// Why a frame cannot be drawn.
pub type PrepareError = InputError;

/// A frame that is ready: what is left to do for each band.
pub trait Prepared {
    /// Colour of the panel.
    type Color: BandColor;

    /// Draws what of the frame falls into the band.
    fn draw<O: Order>(&mut self, band: &mut Band<'_, Self::Color, O>);

    /// The slots, words, segments and edges that a frame drawn as a [`Picture`](zrow::draw::Picture) has taken of its memory up to
    /// now; `None` where a frame is drawn without a picture.
    fn capacities_used(&self) -> Option<PictureCapacities> {
        None
    }
}

/// For scenes that are ready without storage of their own: `type Prepared<'s> = &'s mut Self`.
impl<P: Prepared> Prepared for &mut P {
    type Color = P::Color;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Self::Color, O>) {
        P::draw(self, band);
    }

    fn capacities_used(&self) -> Option<PictureCapacities> {
        P::capacities_used(self)
    }
}

/// A picture, or an animation, that draws itself band by band.
///
/// The value itself is everything that outlives a row: depth row, transformed vertices, prepared polygons. A board needs
/// that, and one row of colour words, and no more.
pub trait Scene: Default {
    /// Colour of the panel.
    type Color: BandColor + Into<Rgb888> + From<Rgb888>;
    /// A frame of the scene; it borrows the scene's storage.
    type Prepared<'s>: Prepared<Color = Self::Color>
    where
        Self: 's;

    /// The name by which a user asks for the scene.
    const NAME: &'static str;
    /// What there is to see, in a few words.
    const TITLE: &'static str;
    /// The whole panel.
    const AREA: Rectangle;
    /// What is there before anything is drawn.
    const BACKGROUND: Self::Color;
    /// Frames until the animation repeats; 1 for a still picture.
    const FRAMES: u32 = 1;
    /// The frame that shows the scene best.
    const PORTRAIT: u32 = 0;
    /// Bytes of depth row in the value; 0 where nothing has a depth.
    const DEPTH_ROW_BYTES: usize = 0;
    /// The capacities of a scene that is drawn as a [`Picture`](zrow::draw::Picture); `None` where it is not.
    const PICTURE: Option<PictureCapacities> = None;

    /// Gets everything ready for frame `frame`, before its rows are drawn. Any number is a frame: the animation repeats.
    ///
    /// # Errors
    /// A table of the scene is too small for this frame.
    fn prepare(&mut self, frame: u32) -> Result<Self::Prepared<'_>, PrepareError>;

    /// The loop that draws the scene, one row at a time.
    fn picture() -> PictureLoop<Self::Color> {
        PictureLoop::new(Self::AREA, Self::BACKGROUND)
    }
}
