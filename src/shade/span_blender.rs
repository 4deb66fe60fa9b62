//! A colour blended into a target by the spans that it takes: for targets without a shorter way.

use core::ops::Range;

use crate::{
    coverage::{Coverage, Emit, EmitRows},
    shade::BatchBlend,
    surface::{Span, Target},
};

/// Blends a colour by the spans that a target takes.
#[derive(Debug)]
pub struct SpanBlender<'t, T: Target> {
    target: &'t mut T,
    color: T::Color,
}

impl<'t, T: Target> SpanBlender<'t, T> {
    pub(crate) const fn new(target: &'t mut T, color: T::Color) -> Self {
        Self { target, color }
    }
}

impl<T: BatchBlend> EmitRows<T::Error> for SpanBlender<'_, T> {
    type Row<'r>
        = SpanRow<'r, T>
    where
        Self: 'r;

    fn row(&mut self, y: i32) -> SpanRow<'_, T> {
        SpanRow {
            target: self.target,
            color: self.color,
            y,
        }
    }
}

/// A row of a target into which a colour is blended by spans.
#[derive(Debug)]
pub struct SpanRow<'t, T: Target> {
    target: &'t mut T,
    color: T::Color,
    y: i32,
}

impl<T: BatchBlend> Emit<T::Error> for SpanRow<'_, T> {
    fn span(&mut self, columns: Range<i32>, coverage: Coverage) -> Result<(), T::Error> {
        let span = Span::new(self.y, columns.start, columns.end);
        self.target.blend_clipped_span(span, self.color, coverage)
    }
}

#[cfg(feature = "defmt")]
impl<T: Target> defmt::Format for SpanBlender<'_, T> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "SpanBlender");
    }
}

#[cfg(feature = "defmt")]
impl<T: Target> defmt::Format for SpanRow<'_, T> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "SpanRow of row {}", self.y);
    }
}
