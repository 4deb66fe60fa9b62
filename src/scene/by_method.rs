//! Draws the rows of a prepared frame by a method that finds out which face is seen in each pixel: the one that its look names, or
//! one that a program hands over.
//!
//! All methods draw the picture of the depth row. Where the method that a look names has too little memory for a band, the depth
//! row draws the band, so that drawing what is prepared cannot fail, and the frame keeps what the method said.

use crate::{
    band::Band,
    geometry::{TooSmall, Window},
    scene::{
        Look,
        prepared_faces::{PreparedFaces, RowMemory},
    },
    shade::Shading,
    surface::{Order, Target},
    visible::{
        BandPainter, DepthRow, DepthUse, LookVisibility, Method, ReportingPainter, SilhouettePainter, Silhouettes, Work,
    },
};

/// The method that a look names.
type MethodOf<L> = <<L as Look>::Visibility as LookVisibility<<L as Look>::Depth>>::Method;

/// Does not compile where a method, which paints from back to front or not, does not draw a look.
pub(super) const fn check_method<L: Look>(paints_from_back: bool) {
    // Nothing is seen through a face, or beside it.
    let has_owners = !L::Shading::HAS_HOLES && !L::Shading::BLENDS && !L::Silhouettes::BY_AREA;
    assert!(
        has_owners || paints_from_back,
        "only the depth row and DepthSort draw looks with holes, translucent faces or silhouettes by area"
    );
}

impl<L: Look> PreparedFaces<'_, '_, L> {
    /// Draws the rows of a band by the method that the look names, or by the depth row.
    #[inline]
    pub(super) fn draw_as_look<O: Order>(
        &self,
        visibility: &mut L::Visibility,
        mut rows: RowMemory<'_, L>,
        band: &mut Band<'_, L::Color, O>,
    ) {
        const { check_method::<L>(MethodOf::<L>::PAINTS_FROM_BACK) }
        if let Some((method, error)) = visibility.method() {
            match self.draw_by(method, rows.reborrow(), band) {
                Ok(()) => return,
                Err(too_small) if error.is_none_or(|before| before.needed() < too_small.needed()) => {
                    *error = Some(too_small);
                }
                Err(_) => {}
            }
        }
        self.draw(rows, band, DepthUse::WhereFacesMayOverlap, |_| {});
    }

    /// Draws the rows of a band by a method.
    ///
    /// # Errors
    /// The method has too little memory: says how much would do. The band is as it was.
    pub(super) fn draw_by<O: Order, M: Method<L::Depth>>(
        &self,
        method: &mut M,
        rows: RowMemory<'_, L>,
        band: &mut Band<'_, L::Color, O>,
    ) -> Result<(), TooSmall> {
        let window = self.viewport.intersection(&band.window());
        if window.is_empty() {
            return Ok(());
        }
        if L::Silhouettes::BY_AREA {
            return self.paint_silhouettes(method, rows, band, &window, |_| {});
        }
        let mut painter = BandPainter::new(self, &window, band, rows.depths, rows.active);
        method.draw(self, &window, &mut painter)
    }

    /// Draws the rows of a band by a method, and reports the work that the method does.
    ///
    /// # Errors
    /// The method has too little memory: says how much would do. The band is as it was, and nothing was reported.
    pub(super) fn draw_by_with<O: Order, M: Method<L::Depth>>(
        &self,
        method: &mut M,
        rows: RowMemory<'_, L>,
        band: &mut Band<'_, L::Color, O>,
        report: impl FnMut(Work),
    ) -> Result<(), TooSmall> {
        let window = self.viewport.intersection(&band.window());
        if window.is_empty() {
            return Ok(());
        }
        if L::Silhouettes::BY_AREA {
            return self.paint_silhouettes(method, rows, band, &window, report);
        }
        let painter = BandPainter::new(self, &window, band, rows.depths, rows.active);
        let mut painter = ReportingPainter::new(painter, self, &window, report);
        method.draw(self, &window, &mut painter)
    }

    /// Paints the rows of a window by a method that paints from back to front, one row after the other, with silhouettes by
    /// area.
    ///
    /// # Errors
    /// The method has too little memory for the window: says how much would do. The band is as it was.
    fn paint_silhouettes<O: Order, M: Method<L::Depth>>(
        &self,
        method: &mut M,
        mut rows: RowMemory<'_, L>,
        band: &mut Band<'_, L::Color, O>,
        window: &Window,
        mut report: impl FnMut(Work),
    ) -> Result<(), TooSmall> {
        method.check(self, window)?;
        // The silhouettes of the rows are followed, but not their faces.
        rows.active.leave_rows();
        for y in window.top..window.bottom {
            let Some(row) = DepthRow::new(band, window, y, rows.depths) else {
                continue;
            };
            let edges = self.begin_silhouettes(&mut rows.silhouettes, &row, y > window.top);
            let mut painter = SilhouettePainter::new(self, row, edges);
            let row = Window {
                top: y,
                bottom: y + 1,
                ..*window
            };
            let reporting = ReportingPainter::new(&mut painter, self, &row, &mut report);
            let drawn = method.draw(self, &row, &mut { reporting });
            painter.finish();
            drawn?;
        }
        Ok(())
    }
}
