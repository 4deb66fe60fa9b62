//! The painter that reports what a method of visibility does, for whoever wants to show it.
//!
//! ```text
//!     method -- span, face --> ReportingPainter -- span, face --> BandPainter --> band
//!            -- work -------->         |
//!                                      +--------- work -------> the program
//! ```
//!
//! A method tells its painter what it does. A painter that draws into a band ignores that, and because what is told is computed by
//! a closure, nothing is left of it in the machine code.

use core::marker::PhantomData;

use crate::{
    geometry::Window,
    shade::Shading,
    surface::Span,
    view::{DepthWidth, ScreenPrecision},
    visible::{active_face::ActiveFace, active_faces::ActiveList, face_table::FaceTable, painter::Painter, work::Work},
};

/// Hands faces on to another painter, and the work of a method to a closure.
pub(crate) struct ReportingPainter<'p, D, F, P, W> {
    painter: P,
    faces: &'p F,
    window: &'p Window,
    report: W,
    depth: PhantomData<D>,
}

impl<'p, D, F, P, W> ReportingPainter<'p, D, F, P, W> {
    /// Reports the work that it takes to draw the faces of a table into a window.
    pub(crate) fn new(painter: P, faces: &'p F, window: &'p Window, report: W) -> Self {
        Self {
            painter,
            faces,
            window,
            report,
            depth: PhantomData,
        }
    }

    /// Reports columns of a row that are painted; these count from the left side of the window.
    fn report_painted<S, H>(&mut self, node: u16, row: i32, [start, end]: [i32; 2])
    where
        S: ScreenPrecision,
        D: DepthWidth,
        H: Shading,
        F: FaceTable<S, D, H>,
        W: FnMut(Work),
    {
        let left = self.window.left;
        (self.report)(Work::Painted {
            face: self.faces.order(node).into(),
            span: Span::new(row, left + start, left + end),
        });
    }
}

impl<S, D, H, F, P, W> Painter<S, H> for ReportingPainter<'_, D, F, P, W>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
    P: Painter<S, H>,
    W: FnMut(Work),
{
    fn span(&mut self, face: &ActiveFace<S, H>, row: i32, columns: [i32; 2]) {
        self.report_painted::<S, H>(face.node, row, columns);
        self.painter.span(face, row, columns);
    }

    fn active(&mut self) -> Option<&mut ActiveList<S, H>> {
        self.painter.active()
    }

    fn span_of_active(&mut self, slot: u16, row: i32, columns: [i32; 2]) {
        let active = self.painter.active().map(|list| list.in_use()).unwrap_or_default();
        if let Some(node) = active.get(usize::from(slot)).map(|face| face.node) {
            self.report_painted::<S, H>(node, row, columns);
        }
        self.painter.span_of_active(slot, row, columns);
    }

    fn report(&mut self, work: impl FnOnce() -> Work) {
        (self.report)(work());
    }
}
