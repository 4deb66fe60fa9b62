//! The signature of all methods that find out which parts of edges are hidden.

use crate::{
    geometry::TooSmall,
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::{line_part::LinePart, line_table::LineTable},
};

/// A method that finds out which parts of the edges of a prepared frame are hidden, for depths `D`: `u16`, or `u32` where a
/// look is [`Deep`](crate::scene::Deep).
///
/// [`Prepared::visible_parts`](crate::scene::Prepared::visible_parts) takes one.
pub trait HiddenLines<D: DepthWidth>: Method<D> {}

impl<D: DepthWidth, M: Method<D>> HiddenLines<D> for M {}

// Not re-exported: only prepared frames have the edges that a method takes.
/// What a method does.
pub trait Method<D: DepthWidth> {
    /// Hands over all edges of a table in parts. Those of one edge follow each other, from its first to its second end,
    /// hidden and visible ones in turns, and cover it without gaps; an edge whose ends are the same point on the screen has none.
    ///
    /// # Errors
    /// The method has too little memory: says how much would do. Nothing was handed over.
    fn visible_parts<S, T>(&mut self, table: &T, part: &mut impl FnMut(LinePart<S>)) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        T: LineTable<S, D>;
}
