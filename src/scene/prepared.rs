//! A frame ready to be drawn, band by band, in any order of rows.

use core::ops::Range;

use crate::{
    band::Band,
    geometry::{TooSmall, Window, offset_from},
    scene::{
        Frame, Look, Model,
        faces::{self, ScreenFace},
        frame::{Tables, corners, is_whole},
    },
    surface::{BandColor, Order, Target},
    visible::{ColoredFace, DepthRow, DepthUse, FaceTable, NONE},
};

/// A scene ready to be drawn, in the storage of a [`Frame`], which is the type `F`.
#[derive(Debug)]
pub struct Prepared<'f, C, F> {
    frame: &'f mut F,
    models: &'f [Model<'f, C>],
    viewport: Window,
    fragments: Range<usize>,
}

impl<'f, L: Look, const VERTICES: usize, const FACES: usize, const ACTIVE: usize, const ROWS: usize>
    Prepared<'f, L::Color, Frame<L, VERTICES, FACES, ACTIVE, ROWS>>
{
    pub(super) fn new(
        frame: &'f mut Frame<L, VERTICES, FACES, ACTIVE, ROWS>,
        models: &'f [Model<'f, L::Color>],
        viewport: Window,
        fragments: Range<usize>,
    ) -> Self {
        Self {
            frame,
            models,
            viewport,
            fragments,
        }
    }

    /// Draws the rows of a band. Bands from top to bottom carry the active list on; any other order works and costs a
    /// new start.
    ///
    /// `depths` is the depth row: as many as the viewport and the band have columns in common.
    ///
    /// # Errors
    /// [`TooSmall`] if `depths` has fewer entries; then nothing is drawn.
    pub fn draw<O: Order>(
        &mut self,
        band: &mut Band<'_, L::Color, O>,
        depths: &mut [L::Depth],
    ) -> Result<(), TooSmall> {
        self.draw_rows(band, depths, DepthUse::WhereFacesMayOverlap, |_| {})
    }

    /// Draws as [`draw`](Self::draw) does, and hands over each row when the scene is in it, so that more can be drawn
    /// with its depths: `|row| text.draw_on(&mut row.at_depth(depth))`.
    ///
    /// `row.at_depth(depth)` is a [`Target`](crate::surface::Target) of the row's pixels at a constant depth: what the scene has
    /// nearer stays, and of equal depths what was drawn first. `row.y()` is the number of the row in the picture.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub fn draw_with<O: Order>(
        &mut self,
        band: &mut Band<'_, L::Color, O>,
        depths: &mut [L::Depth],
        more: impl FnMut(&mut DepthRow<'_, L::Color, O, L::Depth>),
    ) -> Result<(), TooSmall> {
        self.draw_rows(band, depths, DepthUse::Always, more)
    }

    /// How many rows [`draw`](Self::draw) has drawn without depths since the frame was prepared, because no face overlapped
    /// another in them. The picture is the same with depths, which is what `draw_with` does.
    ///
    /// From the first row with an overlap on, the frame is drawn with depths, and so are the 16 that are prepared after it.
    pub const fn rows_without_depth(&self) -> u32 {
        self.frame.active.rows_without_depth()
    }

    /// How many rows were drawn in more than one pass since the frame was prepared, because more faces cross them than the frame
    /// has room for (`ACTIVE`). The picture is the same; such rows take longer.
    pub const fn rows_in_passes(&self) -> u32 {
        self.frame.active.rows_in_passes()
    }

    /// The most faces that cross one row: with so many for `ACTIVE`, each row is drawn in one pass.
    pub fn active_needed(&self) -> usize {
        self.frame.tables.most_active()
    }

    fn draw_rows<O: Order>(
        &mut self,
        band: &mut Band<'_, L::Color, O>,
        depths: &mut [L::Depth],
        depth_use: DepthUse,
        mut more: impl FnMut(&mut DepthRow<'_, L::Color, O, L::Depth>),
    ) -> Result<(), TooSmall> {
        let window = self.viewport.intersection(&band.window());
        let needed = window.width() as usize;
        if depths.len() < needed {
            return Err(TooSmall::Depths(needed));
        }
        if needed == 0 {
            return Ok(());
        }
        let Frame { tables, active } = &mut *self.frame;
        let faces = Entries::new(tables, self.models, self.viewport);
        for y in window.top..window.bottom {
            if let Some(mut row) = DepthRow::new(band, &window, y, depths) {
                if L::DRAWS_IN_PASSES && active.needs_passes() {
                    active.draw_row_in_passes(&faces, &mut row);
                } else {
                    active.draw_row(&faces, &mut row, depth_use);
                }
                more(&mut row);
            }
        }
        Ok(())
    }

    /// All faces on the screen as they were snapped: the whole ones in the order of models and faces, whether they face
    /// the viewer or not, then the visible fragments of those that were cut, in the same order.
    ///
    /// A face has an `order`, its index in the order of models and faces (of two fragments with the same depth, the
    /// lower one is drawn), and three `corners` in the order of the mesh, each with the `point` that it was snapped to
    /// and its `depth` as stored: nearer is larger.
    pub fn faces(&self) -> impl Iterator<Item = ScreenFace<L::Precision, L::Depth>> + '_ {
        let whole = faces::whole(&self.frame.tables, self.models);
        let fragments = faces::fragments(&self.frame.tables, self.fragments.clone());
        whole.chain(fragments)
    }
}

/// A face of a frame with its colour, as the row loop takes it.
type FaceOf<'a, L> =
    ColoredFace<'a, <L as Look>::Precision, <L as Look>::Depth, <<L as Look>::Color as BandColor>::Word>;

/// The tables and the models as the row loop reads them.
struct Entries<'t, 'm, C, T> {
    tables: &'t T,
    models: &'m [Model<'m, C>],
    /// Faces and colours of the first model.
    first_faces: &'m [[u16; 3]],
    first_colors: &'m [C],
    viewport: Window,
}

impl<'t, 'm, C, T> Entries<'t, 'm, C, T> {
    fn new(tables: &'t T, models: &'m [Model<'m, C>], viewport: Window) -> Self {
        let (first_faces, first_colors) = models
            .first()
            .map_or((&[][..], &[][..]), |model| (model.mesh().faces(), model.colors()));
        Self {
            tables,
            models,
            first_faces,
            first_colors,
            viewport,
        }
    }
}

impl<L: Look, const VERTICES: usize, const FACES: usize, const ROWS: usize>
    FaceTable<L::Precision, L::Depth, <L::Color as BandColor>::Word>
    for Entries<'_, '_, L::Color, Tables<L, VERTICES, FACES, ROWS>>
{
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;

    fn viewport(&self) -> &Window {
        &self.viewport
    }

    fn change(&self, row: i32) -> i32 {
        let row = offset_from(self.viewport.top, row) as usize;
        self.tables.rows.get(row).map_or(0, |row| row.change())
    }

    fn first_in_row(&self, row: i32) -> u16 {
        let row = offset_from(self.viewport.top, row) as usize;
        self.tables.rows.get(row).map_or(NONE, |row| row.first())
    }

    fn next(&self, node: u16) -> u16 {
        self.tables.next(node)
    }

    fn order(&self, node: u16) -> u16 {
        self.tables.order(node)
    }

    #[inline]
    fn face(&self, node: u16) -> Option<FaceOf<'_, L>> {
        // Faces of the first model, which is all of them mostly, need no search.
        let Some(face) = self.first_faces.get(usize::from(node)) else {
            return self.other_face(node);
        };
        let word = self.first_colors.get(usize::from(node))?.to_word();
        Some((corners(&self.tables.vertices, face)?, word))
    }
}

impl<L: Look, const VERTICES: usize, const FACES: usize, const ROWS: usize>
    Entries<'_, '_, L::Color, Tables<L, VERTICES, FACES, ROWS>>
{
    /// A face of another model, or a fragment.
    #[inline(never)]
    fn other_face(&self, node: u16) -> Option<FaceOf<'_, L>> {
        let (model, first_vertex, face) = faces::find(self.models, self.tables.order(node))?;
        let word = model.colors().get(face)?.to_word();
        let corners = if is_whole::<L>(node) {
            corners(
                self.tables.vertices.get(first_vertex..)?,
                model.mesh().faces().get(face)?,
            )
        } else {
            self.tables.fragment(node)
        };
        Some((corners?, word))
    }
}

#[cfg(feature = "defmt")]
impl<C, F: defmt::Format> defmt::Format for Prepared<'_, C, F> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Prepared {} in {}", self.frame, self.viewport);
    }
}
