//! What a method of visibility hands over: which columns of a row show a face.

use crate::{
    band::Band,
    geometry::Window,
    shade::{Planes, Shading},
    surface::Order,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        DepthRow, active_face::ActiveFace, active_faces::ActiveList, blended_row::blend_span, face_table::FaceTable,
        shaded_span::shaded_row, work::Work,
    },
};

// Not re-exported: methods are handed one.
/// Takes the faces that are seen, one span after the other.
pub trait Painter<S: ScreenPrecision, H: Shading> {
    /// Takes the columns of a row in which a face is seen. Columns count from the left side of the window that is drawn; the
    /// face's depth and its attributes do, too.
    fn span(&mut self, face: &ActiveFace<S, H>, row: i32, columns: [i32; 2]);

    /// The active list of the frame, for methods that carry faces on from row to row. `None` where there is none.
    fn active(&mut self) -> Option<&mut ActiveList<S, H>> {
        None
    }

    /// Takes the columns of a row in which the face in a slot of the [active](Self::active) list is seen, as
    /// [`span`](Self::span) does.
    fn span_of_active(&mut self, _slot: u16, _row: i32, _columns: [i32; 2]) {}

    /// Takes the spans of all faces of the [active](Self::active) list, which are in a row and in the order of columns, and steps
    /// the faces to the next row. `false` where two of them have a column in common, or such rows are not taken: some spans may
    /// have been taken then, and the list has to be entered anew.
    fn disjoint_row(&mut self, _row: i32) -> bool {
        false
    }

    /// Takes note of the work that a method does. Ignored where nobody wants to know: nothing is computed then.
    fn report(&mut self, _work: impl FnOnce() -> Work) {}
}

impl<S: ScreenPrecision, H: Shading, P: Painter<S, H>> Painter<S, H> for &mut P {
    fn span(&mut self, face: &ActiveFace<S, H>, row: i32, columns: [i32; 2]) {
        P::span(self, face, row, columns);
    }

    fn active(&mut self) -> Option<&mut ActiveList<S, H>> {
        P::active(self)
    }

    fn span_of_active(&mut self, slot: u16, row: i32, columns: [i32; 2]) {
        P::span_of_active(self, slot, row, columns);
    }

    fn disjoint_row(&mut self, row: i32) -> bool {
        P::disjoint_row(self, row)
    }

    fn report(&mut self, work: impl FnOnce() -> Work) {
        P::report(self, work);
    }
}

/// Shades the faces that are seen into a band.
pub(crate) struct BandPainter<'p, 'b, S: ScreenPrecision, D: DepthWidth, H: Shading, F, O: Order> {
    target: BandRows<'p, 'b, D, H, F, O>,
    active: &'p mut ActiveList<S, H>,
}

/// The rows of a band into which the faces of a table are shaded.
struct BandRows<'p, 'b, D: DepthWidth, H: Shading, F, O: Order> {
    faces: &'p F,
    window: &'p Window,
    band: &'p mut Band<'b, H::Color, O>,
    /// The depths of a row, which has them but does not use them.
    depths: &'p mut [D],
}

impl<'p, 'b, S: ScreenPrecision, D: DepthWidth, H: Shading, F, O: Order> BandPainter<'p, 'b, S, D, H, F, O> {
    /// Shades the faces of a table into a window of a band. The row of depths and the active list are those of the frame.
    pub(crate) fn new(
        faces: &'p F,
        window: &'p Window,
        band: &'p mut Band<'b, H::Color, O>,
        depths: &'p mut [D],
        active: &'p mut ActiveList<S, H>,
    ) -> Self {
        Self {
            target: BandRows {
                faces,
                window,
                band,
                depths,
            },
            active,
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
    fn span(&mut self, face: &ActiveFace<S, H>, row: i32, columns: [i32; 2]) {
        self.target.shade(face, row, columns);
    }

    fn active(&mut self) -> Option<&mut ActiveList<S, H>> {
        Some(self.active)
    }

    fn span_of_active(&mut self, slot: u16, row: i32, columns: [i32; 2]) {
        if let Some(face) = self.active.in_use().get(usize::from(slot)) {
            self.target.shade(face, row, columns);
        }
    }

    fn disjoint_row(&mut self, row: i32) -> bool {
        let BandRows {
            faces,
            window,
            band,
            depths,
        } = &mut self.target;
        DepthRow::new(band, window, row, depths).is_some_and(|mut row| self.active.fill_spans(*faces, &mut row))
    }
}

impl<D: DepthWidth, H: Shading, F, O: Order> BandRows<'_, '_, D, H, F, O> {
    /// Shades columns of a row in which a face is seen.
    fn shade<S: ScreenPrecision>(&mut self, face: &ActiveFace<S, H>, y: i32, [start, end]: [i32; 2])
    where
        F: FaceTable<S, D, H>,
    {
        let Some(mut row) = DepthRow::new(self.band, self.window, y, self.depths) else {
            return;
        };
        if start >= end {
            return;
        }
        if face.is_translucent() {
            blend_span(self.faces, &mut row, face, [start, end]);
        } else if H::Attributes::VARY {
            shaded_row(self.faces, &mut row).fill_seen(face, [start, end]);
        } else {
            row.fill_span(start, end, face.word);
        }
    }
}
