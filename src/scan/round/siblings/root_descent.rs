//! An arc whose columns are computed one by one, each by a square root.

use crate::scan::round::siblings::arcs::{Arc, Descent};

/// A column of an arc and its height, from the arc's equation.
#[derive(Debug, Clone)]
pub(crate) struct RootDescent<A> {
    arc: A,
    column: u32,
    height: u32,
}

impl<A: Arc + Copy> Descent for RootDescent<A> {
    type Arc = A;

    fn enter(arc: &A, column: u32, height: u32) -> Self {
        Self {
            arc: *arc,
            column,
            height,
        }
    }

    #[inline]
    fn descends(&mut self) -> bool {
        self.column += 1;
        let height = self.arc.height(self.column);
        let descends = height < self.height;
        self.height = height;
        descends
    }
}
