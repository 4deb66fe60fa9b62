//! Blending: a colour over what is drawn already, as much of it as its alpha says.
//!
//! Guarantees: each channel is `(alpha * color + (255 - alpha) * below) / 255`, rounded once to the nearest level, so that
//! it is never off by more than half a level; alpha 0 leaves what is below and alpha 255 writes the colour, to the bit; a
//! colour over itself stays the same. Integers only, and no division a pixel. [`Gamma`] does the same in linear light.
//!
//! `BinaryColor` has nothing between its two: a pixel takes the colour or stays, by an ordered threshold (Bayer 1973) at its
//! position in the picture. Of every 8 x 8 pixels, `alpha * 64 / 255` take it, rounded to the nearest.
//!
//! Source: `over` of Porter and Duff 1984 on what is opaque; the division by 255 is Blinn 1994 ("Three wrongs make a
//! right"), tested for every sum.

mod encoded;
mod gamma;

pub use encoded::Encoded;
pub use gamma::Gamma;

use crate::{coverage::Coverage, shade::layout::Layout, surface::Order};

/// What the levels of a channel mean where two colours are mixed: [`Encoded`] or [`Gamma`].
// Not re-exported: users name the number of a gamma.
pub trait TransferFunction: Copy + core::fmt::Debug + Default + 'static {
    /// Blends a colour over a run of words.
    fn blend<L: Layout, O: Order>(words: &mut [L::Word], color: L::Word, alpha: Coverage);
}
