//! Looks of scenes by precision, width of depths and clipping, to see what each of them does.

use core::marker::PhantomData;

use zrow::{
    band::BandColor,
    geometry::Sub4,
    scene::{DepthWidth, Look, ScreenPrecision},
};

/// The look of a precision `S` and depths `D`, whose faces are cut where `CLIPS` says so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LookOf<C, S = Sub4, D = u16, const CLIPS: bool = true>(PhantomData<(C, S, D)>);

impl<C, S, D, const CLIPS: bool> Look for LookOf<C, S, D, CLIPS>
where
    C: BandColor,
    S: ScreenPrecision,
    D: DepthWidth + 'static,
{
    type Color = C;
    type Precision = S;
    type Depth = D;
    const CLIPS: bool = CLIPS;
}
