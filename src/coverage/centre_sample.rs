//! Coverage by the centre of the pixel: all or nothing.
//!
//! Promises: exact by the top-left rule; on edges that run along pixel boundaries it is the exact coverage too. Elsewhere
//! it is wrong by up to one pixel's share, which is what the other tiers are for. No memory.

use heapless::VecView;

use crate::{
    coverage::{Coverage, Share},
    geometry::Window,
    scan::{
        ActiveEdge, Edge,
        scanline_polygon::{self, FillRule, PartRule, Windings},
    },
    target::Span,
};

/// No antialiasing: for flat user interfaces and wherever speed counts most.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CentreSample;

impl Coverage for CentreSample {
    #[inline]
    fn cover<E>(
        &self,
        edges: &[Edge],
        active: &mut VecView<ActiveEdge>,
        fill_rule: FillRule,
        window: &Window,
        mut emit: impl FnMut(Span, Share) -> Result<(), E>,
    ) -> Result<(), E> {
        let rule = PartRule::fill(fill_rule);
        scanline_polygon::scan(edges, active, Windings::default(), rule, window, |span, _| {
            emit(span, Share::MAX)
        })
    }
}
