//! Looks of scenes by precision, width of depths, clipping and passes, to see what each of them does.

use core::marker::PhantomData;

use zrow::{
    band::BandColor,
    geometry::Sub4,
    scene::{DepthWidth, Look, ScreenPrecision},
};

/// The look of a precision `S` and depths `D`, whose faces are cut where `CLIPS` says so, and whose rows with more faces than
/// slots are drawn in passes where `PASSES` does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LookOf<C, S = Sub4, D = u16, const CLIPS: bool = true, const PASSES: bool = true>(PhantomData<(C, S, D)>);

impl<C, S, D, const CLIPS: bool, const PASSES: bool> Look for LookOf<C, S, D, CLIPS, PASSES>
where
    C: BandColor,
    S: ScreenPrecision,
    D: DepthWidth + 'static,
{
    type Color = C;
    type Shading = C;
    type Precision = S;
    type Depth = D;
    type Counting = ();
    type Silhouettes = ();
    type Visibility = ();
    type StoredAttributes = ();
    const CLIPS: bool = CLIPS;
    const DRAWS_IN_PASSES: bool = PASSES;
}
