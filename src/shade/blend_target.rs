//! The entry point for antialiased drawing: a target that can be read back.

use crate::{
    coverage::{Coverage, EmitRows},
    geometry::leading_zeros,
    surface::{Span, Target},
};

/// The part of a [`BlendTarget`] that only zrow's own shapes call, and that only its own targets have: it seals that trait.
pub trait BatchBlend: Target {
    /// The type that blends one colour into this target, row by row.
    type Blender<'t>: EmitRows<Self::Error>
    where
        Self: 't;

    /// Begins to blend a colour over pixels that lie inside the target's window.
    fn blender(&mut self, color: Self::Color) -> Self::Blender<'_>;

    /// Draws a colour over a span that lies inside the target's window or is empty.
    ///
    /// # Errors
    /// The target's own error.
    fn blend_clipped_span(&mut self, span: Span, color: Self::Color, alpha: Coverage) -> Result<(), Self::Error>;

    /// Draws a colour over eight pixels of row `y` from column `start` on, each covered by a number of fifteenths: the
    /// first one in the highest four bits. Those that are covered lie inside the target's window.
    ///
    /// # Errors
    /// The target's own error.
    fn blend_clipped_fifteenths(
        &mut self,
        y: i32,
        start: i32,
        eight: u32,
        color: Self::Color,
    ) -> Result<(), Self::Error> {
        for_each_run(eight, |first, end, fifteenths| {
            self.blend_clipped_span(Span::new(y, start + first, start + end), color, fifteenths * 17)
        })
    }
}

/// A target that mixes what is drawn with what is there already.
///
/// [`Band`](crate::band::Band) is one, and [`in_linear_light`](crate::band::Band::in_linear_light) makes it mix light. What is handed
/// over is drawn at once over all that was drawn before it, as all targets do: painter's order. A display that cannot be
/// read back is none.
pub trait BlendTarget: BatchBlend {
    /// Draws a colour over the visible pixels of a span, each to the same alpha: 0 draws nothing and 255 is a fill.
    ///
    /// # Errors
    /// The target's own error.
    fn blend_span(&mut self, span: Span, color: Self::Color, alpha: Coverage) -> Result<(), Self::Error> {
        let visible = span.clipped_to(&self.window());
        self.blend_clipped_span(visible, color, alpha)
    }
}

/// Calls `run` with the first pixel of each run of equal coverage that is not 0, the pixel behind its last one, and the
/// coverage in fifteenths.
#[inline]
fn for_each_run<E>(mut pixels: u32, mut run: impl FnMut(i32, i32, u8) -> Result<(), E>) -> Result<(), E> {
    let mut start = 0;
    while pixels != 0 {
        let gap = leading_zeros(pixels) / 4;
        pixels <<= 4 * gap;
        let fifteenths = pixels >> 28;
        // At least 1: the first pixel equals itself. Shifted in two steps, because 32 bits are too many for one.
        let equal = leading_zeros(pixels ^ (fifteenths * 0x1111_1111)) / 4;
        pixels = pixels << 4 << (4 * equal - 4);
        start += gap as i32;
        let end = start + equal as i32;
        run(start, end, fifteenths as u8)?;
        start = end;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;

    /// The runs of eight pixels.
    fn runs(pixels: u32) -> Vec<(i32, i32, u8)> {
        let mut runs = Vec::new();
        let Ok(()) = for_each_run(pixels, |start, end, fifteenths| {
            runs.push((start, end, fifteenths));
            Ok::<_, core::convert::Infallible>(())
        });
        runs
    }

    #[test]
    fn runs_of_equal_coverage() {
        assert_eq!(runs(0), []);
        assert_eq!(runs(0xffff_ffff), [(0, 8, 15)]);
        assert_eq!(runs(0x0330_ff04), [(1, 3, 3), (4, 6, 15), (7, 8, 4)]);
        assert_eq!(runs(0x1000_0000), [(0, 1, 1)]);
        assert_eq!(runs(0x1234_5678).len(), 8);
    }
}
