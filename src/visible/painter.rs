//! What a method of visibility hands over: which columns of a row show a face.

use core::marker::PhantomData;

use crate::{
    band::Band,
    geometry::Window,
    shade::{Planes, Shading},
    surface::Order,
    view::{DepthWidth, ScreenPrecision},
    visible::{DepthRow, active_face::ActiveFace, face_table::FaceTable, shaded_span::shaded_row},
};

// Not re-exported: methods are handed one.
/// Takes the faces that are seen, one span after the other.
pub trait Painter<S: ScreenPrecision, H: Shading> {
    /// Takes the columns of a row in which a face is seen. Columns count from the left side of the window that is drawn; the
    /// face's depth and its attributes do, too.
    fn span(&mut self, face: &ActiveFace<S, H>, row: i32, columns: [i32; 2]);
}

/// Shades the faces that are seen into a band.
pub(crate) struct BandPainter<'p, 'b, S, D: DepthWidth, H: Shading, F, O: Order> {
    faces: &'p F,
    window: &'p Window,
    band: &'p mut Band<'b, H::Color, O>,
    /// The depths of a row, which has them but does not use them.
    depths: &'p mut [D],
    precision: PhantomData<S>,
}

impl<'p, 'b, S, D: DepthWidth, H: Shading, F, O: Order> BandPainter<'p, 'b, S, D, H, F, O> {
    /// Shades the faces of a table into a window of a band.
    pub(crate) fn new(
        faces: &'p F,
        window: &'p Window,
        band: &'p mut Band<'b, H::Color, O>,
        depths: &'p mut [D],
    ) -> Self {
        Self {
            faces,
            window,
            band,
            depths,
            precision: PhantomData,
        }
    }
}

impl<S, D, H, F, O> Painter<S, H> for BandPainter<'_, '_, S, D, H, F, O>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
    O: Order,
{
    fn span(&mut self, face: &ActiveFace<S, H>, y: i32, [start, end]: [i32; 2]) {
        let Some(mut row) = DepthRow::new(self.band, self.window, y, self.depths) else {
            return;
        };
        if start >= end {
            return;
        }
        if H::Attributes::VARY {
            shaded_row(self.faces, &mut row).fill_seen(face, [start, end]);
        } else {
            row.fill_span(start, end, face.word);
        }
    }
}
