//! Multisampling: polygons drawn into the samples of each pixel, which have colours of their own.
//!
//! For each row the sample pattern of the target turns the edges into spans with a mask of the covered samples, and the
//! target gives these samples the polygon's colour.

use embedded_graphics::geometry::Point;

use crate::{
    coverage::{CoverageMethod, SamplePattern},
    draw::AntialiasedPolygon,
    geometry::DrawError,
    shade::SampleTarget,
    surface::{Paint, Painted, Span, Target, contiguous::skip},
};

impl<const EDGES: usize, const ACTIVE: usize> AntialiasedPolygon<EDGES, ACTIVE> {
    /// Draws the samples that the polygon covers, over what was drawn before. With several samples in a pixel
    /// ([`Band::multisample`](crate::band::Band::multisample)), nothing of the background shows between two polygons
    /// that share an edge: each sample along the edge belongs to one of them.
    ///
    /// `row_memory` takes as many cells as [`CoverageMethod::cells`] of the target's pattern returns for the width of
    /// the target. All cells must be 0, and they are 0 again afterwards. A paint on the target
    /// ([`Target::painted`]) gives all covered samples of a pixel the same colour.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] if there are fewer cells; nothing is drawn then. [`DrawError::Target`] with the target's
    /// own error.
    pub fn draw_samples<T: SampleTarget>(
        &self,
        color: T::Color,
        target: &mut T,
        row_memory: &mut [<T::Pattern as CoverageMethod>::Cell],
    ) -> Result<(), DrawError<T::Error>> {
        let (pattern, raw) = (T::Pattern::default(), target.raw(color));
        self.for_each_row::<T::Pattern, _>(&target.window(), row_memory, |y, segments, columns, row_memory| {
            pattern.sample_row(segments, self.fill_rule(), columns, row_memory, |columns, mask| {
                let span = Span::new(y, columns.start, columns.end);
                target.fill_samples(span, mask, raw).map_err(DrawError::Target)
            })
        })
    }
}

impl<T, P> SampleTarget for Painted<'_, T, P>
where
    T: SampleTarget,
    P: Paint<Color = T::Color>,
{
    type Pattern = T::Pattern;

    fn fill_samples(&mut self, span: Span, mask: u32, (): ()) -> Result<(), T::Error> {
        let visible = span.clipped_to(&self.window());
        let painted = self.paint.colors_from(Point::new(visible.start, visible.y));
        self.target.set_samples(visible, mask, painted)
    }

    /// Paints the samples in those pixels for which `colors` has an element. The values of these colours are ignored.
    fn set_samples<I>(&mut self, span: Span, mask: u32, colors: I) -> Result<(), T::Error>
    where
        I: IntoIterator<Item = T::Color>,
    {
        let visible = span.clipped_to(&self.window());
        let mut colors = colors.into_iter();
        if visible.is_empty() || !skip(&mut colors, visible.start.abs_diff(span.start).into()) {
            return Ok(());
        }
        let painted = self.paint.colors_from(Point::new(visible.start, visible.y));
        let colors = colors.take(visible.end.abs_diff(visible.start) as usize);
        self.target
            .set_samples(visible, mask, colors.zip(painted).map(|(_, color)| color))
    }
}
