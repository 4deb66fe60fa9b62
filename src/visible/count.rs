//! Where the row loop counts what it does, in looks that count; in all others it is no code.

/// Adds to the counters of a frame; nothing for `()`.
pub trait Count: Copy {
    /// A span was filled without depths.
    #[inline(always)]
    fn filled(self, _pixels: usize) {}

    /// The depths of a span were tested.
    #[inline(always)]
    fn tested(self, _pixels: usize) {}

    /// The colour of a pixel was computed from attributes.
    #[inline(always)]
    fn fragment(self) {}

    /// The colour of a pixel was mixed with the one behind it.
    #[inline(always)]
    fn blended(self) {}

    /// Attributes were divided by a depth.
    #[inline(always)]
    fn divisions(self, _number: u32) {}

    /// A row was drawn.
    #[inline(always)]
    fn row(self) {}
}

impl Count for () {}
