//! The signature of all methods that find out which face is seen in each pixel, and how a look names one.

use core::{convert::Infallible, fmt::Debug};

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
/// A look that is [`VisibleBy`](crate::scene::VisibleBy) a method names it, and
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

// Not re-exported: a method that takes something to begin with, as a tree of solids, is made by the program.
/// A method that a look can name: its memory is there from the start.
pub trait NewMethod<D: DepthWidth>: Method<D> + Debug + 'static {
    /// The method, with nothing drawn.
    const NEW: Self;
}

// Not re-exported: which method it is is said by a wrapper of the look.
/// How a look finds out which face is seen in each pixel: by the depth row (`()`), or [by another method](ByMethod).
pub trait LookVisibility<D: DepthWidth>: Debug + 'static {
    /// What is kept from frame to frame: nothing is drawn yet.
    const NEW: Self;
    /// The method that is named.
    type Method: Method<D>;

    /// Begins a frame.
    fn restart(&mut self);

    /// The method, and why it did not draw a band; `None` where the depth row draws.
    fn method(&mut self) -> Option<(&mut Self::Method, &mut Option<TooSmall>)>;
}

impl<D: DepthWidth> LookVisibility<D> for () {
    const NEW: () = ();
    type Method = Infallible;

    #[inline(always)]
    fn restart(&mut self) {}

    #[inline(always)]
    fn method(&mut self) -> Option<(&mut Infallible, &mut Option<TooSmall>)> {
        None
    }
}

/// No method.
impl<D: DepthWidth> Method<D> for Infallible {
    const PAINTS_FROM_BACK: bool = true;

    fn draw<S, H, F>(&mut self, _: &F, _: &Window, _: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        match *self {}
    }
}

/// By a method that a look names.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ByMethod<M> {
    pub(crate) method: M,
    /// Why the method did not draw a band of the frame.
    pub(crate) error: Option<TooSmall>,
}

impl<D: DepthWidth, M: NewMethod<D>> LookVisibility<D> for ByMethod<M> {
    const NEW: Self = Self {
        method: M::NEW,
        error: None,
    };
    type Method = M;

    fn restart(&mut self) {
        self.error = None;
    }

    fn method(&mut self) -> Option<(&mut M, &mut Option<TooSmall>)> {
        Some((&mut self.method, &mut self.error))
    }
}
