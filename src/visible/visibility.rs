//! The signature of all methods that find out which face is seen in each pixel.

use crate::{
    geometry::{TooSmall, Window},
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{face_table::FaceTable, painter::Painter},
};

/// A method that finds out which face is seen in each pixel, for depths `D`: `u16`, or `u32` where a look is
/// [`Deep`](crate::scene::Deep).
///
/// All methods draw the same picture, to the bit: in each pixel that face is seen which has the greatest stored depth there, of
/// equally near ones the first in the order of models. They differ in memory, and in time. Only
/// [`SolidCombination`](crate::visible::SolidCombination) has a picture of its own, and
/// [`DepthSort`](crate::visible::DepthSort) shows translucent and cut faces also beside antialiased silhouettes in front of them.
///
/// [`Prepared::draw_by`](crate::scene::Prepared::draw_by) takes one.
pub trait Visibility<D: DepthWidth>: Method<D> {}

impl<D: DepthWidth, M: Method<D>> Visibility<D> for M {}

// Not re-exported: only prepared frames have the faces that a method takes.
/// What a method does.
pub trait Method<D: DepthWidth> {
    /// Whether all faces are handed over, hidden ones as well, in each pixel from back to front: then faces may have holes, be
    /// mixed with what is behind them, or end within a pixel.
    const PAINTS_FROM_BACK: bool = false;

    /// Whether the method has enough memory for the faces of a table in a window, so that it also draws parts of the window.
    ///
    /// # Errors
    /// The method has too little memory: says how much would do.
    fn check<S, H, F>(&mut self, _faces: &F, _window: &Window) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        Ok(())
    }

    /// Finds the faces of a table that are seen in a window, which lies in the viewport and has pixels, and hands them over.
    ///
    /// # Errors
    /// The method has too little memory: says how much would do. Nothing was handed over.
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>;
}
