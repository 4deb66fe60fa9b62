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

    fn disjoint_row(&mut self, row: i32) -> bool {
        let Some(list) = self.painter.active() else {
            return false;
        };
        // Nothing is reported of a row that is not taken.
        let mut free_from = i32::MIN;
        let are_disjoint = list.in_order().map(ActiveFace::span).all(|[start, end]| {
            let is_right = start >= end || start >= free_from;
            free_from = free_from.max(end);
            is_right
        });
        if !are_disjoint {
            return false;
        }
        let (left, width) = (self.window.left, self.window.width() as i32);
        for face in list.in_order() {
            let [start, end] = face.span().map(|column| column.max(0).min(width));
            if start < end {
                (self.report)(Work::Painted {
                    face: self.faces.order(face.node).into(),
                    span: Span::new(row, left + start, left + end),
                });
            }
        }
        self.painter.disjoint_row(row)
    }

    fn report(&mut self, work: impl FnOnce() -> Work) {
        (self.report)(work());
    }
}
