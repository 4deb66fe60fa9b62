//! The style that asks for antialiased edges.

/// A style whose edges are antialiased by exact area: what
/// [`PrimitiveStyle::antialiased`](crate::draw::PrimitiveStyle::antialiased) and
/// [`StrokeStyle::antialiased`](crate::draw::StrokeStyle::antialiased) give.
///
/// Shapes in such a style are drawn on an [`AntialiasedTarget`](crate::draw::AntialiasedTarget), which lends the memory,
/// by [`DrawAntialiased::draw_on`](crate::draw::DrawAntialiased::draw_on).
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Antialiased<S>(pub S);
