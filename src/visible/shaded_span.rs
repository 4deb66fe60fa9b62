//! Draws the spans of faces over which attributes vary, in runs along which these step evenly.

use core::{marker::PhantomData, num::Wrapping};

use crate::{
    clip::convex::CutAttributes,
    shade::{Planes, Run, Shade, Shading},
    surface::Order,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        DepthRow,
        active_face::{ActiveFace, WordOf},
        count::Count,
        depth_row::store_nearer_block,
        divided_runs::{DividedRuns, WHOLE_RUN},
        face_table::{FaceTable, covers},
    },
};

/// The attributes of a shading at a pixel.
type ValuesOf<H> = <<H as Shading>::Attributes as Planes>::Values;

/// The colours of a face of a table along a run.
struct Varying<'s, S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H> + 's, O> {
    /// Where fragments read it: of a copy, so that what they take of it stays in registers.
    skin: &'s F::Skin,
    word: WordOf<H>,
    run: Run<ValuesOf<H>>,
    count: F::Count<'s>,
    order: PhantomData<(S, D, O)>,
}

impl<S, D, H, F, O> Shade<WordOf<H>> for Varying<'_, S, D, H, F, O>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
    O: Order,
{
    #[inline(always)]
    fn word(&self) -> Option<WordOf<H>> {
        self.count.fragment();
        F::fragment(self.skin, self.word, &self.run.values).map(O::reorder)
    }

    #[inline(always)]
    fn step_right(&mut self) {
        H::Attributes::step(&mut self.run.values, &self.run.per_column);
    }
}

/// A row as it is drawn, and the faces of the frame.
pub(super) struct ShadedRow<'r, 'a, S, D: DepthWidth, H: Shading, F, O: Order> {
    pub(super) faces: &'r F,
    pub(super) row: &'r mut DepthRow<'a, H::Color, O, D>,
    pub(super) precision: PhantomData<S>,
}

impl<S, D, H, F, O> ShadedRow<'_, '_, S, D, H, F, O>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
    O: Order,
{
    /// Draws the pixels of a span of a face that are nearer than the stored depths, up to the first that is exactly as near.
    /// Returns how many visible pixels of the span are left, that one included; `None` if there is no such pixel. Columns count
    /// from the first pixel of the row, and may lie outside it.
    #[inline(always)]
    pub(super) fn draw_span(&mut self, face: &ActiveFace<S, H>, [start, end]: [i32; 2]) -> Option<usize> {
        if !are_even::<S, D, H, F>(face) {
            return self.draw_divided_span(face, [start, end]);
        }
        if H::HAS_HOLES {
            return self.draw_in_pixels(face, [start, end]);
        }
        if self.row.pixels(start, end).is_none() {
            return self.draw_cut_span(face, [start, end]);
        }
        self.count_pixels(end - start);
        let left = self.store_nearer(start, end, face)?;
        if left > 0 {
            return self.draw_rest(face, [start, end], left);
        }
        let skin = *self.faces.skin(face.node)?;
        let run = H::Attributes::even_run(&face.attributes, start, end, self.row.y);
        varying::<S, D, H, F, O>(self.faces, &skin, face.word, run).fill(self.row.pixels(start, end)?);
        None
    }

    /// Whether the depths of the row are tested.
    #[inline(always)]
    fn is_tested(&self) -> bool {
        !may_be_untested::<S, D, H, F>() || self.row.is_tested
    }

    /// Counts the pixels of a span that is drawn.
    #[inline(always)]
    fn count_pixels(&self, pixels: i32) {
        if self.is_tested() {
            self.faces.count().tested(pixels as usize);
        } else {
            self.faces.count().filled(pixels as usize);
        }
    }

    /// Stores the depths of a face at pixels inside the row from a column on, as long as they are nearer than the stored ones.
    /// Returns how many pixels are left; 0 where depths are not tested, and none is stored.
    #[inline(always)]
    fn store_nearer(&mut self, start: i32, end: i32, face: &ActiveFace<S, H>) -> Option<usize> {
        if self.is_tested() {
            self.row.store_nearer(start, end, &face.plane)
        } else {
            Some(0)
        }
    }

    /// Draws the part of a span of a face that is inside the row and whose attributes step evenly, pixel by pixel: each may be
    /// a hole.
    #[inline(always)]
    fn draw_in_pixels(&mut self, face: &ActiveFace<S, H>, [start, end]: [i32; 2]) -> Option<usize> {
        let (column, end) = (start.max(0), end.min(self.row.words.len() as i32));
        if column >= end {
            return None;
        }
        self.faces.count().tested((end - column) as usize);
        let skin = *self.faces.skin(face.node)?;
        let run = H::Attributes::even_run(&face.attributes, column, end, self.row.y);
        let shade = varying::<S, D, H, F, O>(self.faces, &skin, face.word, run);
        self.row.draw_run(column, end, shade, &face.plane)
    }

    /// Draws a span of a face that is inside the row and whose attributes step evenly, where so many pixels are left from the
    /// first one on that is not nearer than its stored depth; the depths of those before it are stored.
    #[inline(never)]
    fn draw_rest(&mut self, face: &ActiveFace<S, H>, [start, end]: [i32; 2], left: usize) -> Option<usize> {
        let column = end - left as i32;
        if start < column {
            self.fill_part(face, [start, start, column], None);
        }
        self.draw_parts(face, [start, column, end], None)
    }

    /// Draws the part of a span of a face that is inside the row and whose attributes step evenly, of a shading without holes.
    #[cold]
    #[inline(never)]
    fn draw_cut_span(&mut self, face: &ActiveFace<S, H>, [start, end]: [i32; 2]) -> Option<usize> {
        let (column, end) = (start.max(0), end.min(self.row.words.len() as i32));
        if column >= end {
            return None;
        }
        self.count_pixels(end - column);
        self.draw_parts(face, [column, column, end], None)
    }

    /// Draws the pixels of a run that is inside the row, of a shading without holes, from a column on: depths first, and then
    /// the visible pixels. The run is `None` where attributes step evenly along the whole span.
    #[inline(never)]
    fn draw_parts(
        &mut self,
        face: &ActiveFace<S, H>,
        [start, mut column, end]: [i32; 3],
        run: Option<&Run<ValuesOf<H>>>,
    ) -> Option<usize> {
        if !self.is_tested() {
            self.fill_part(face, [start, column, end], run);
            return None;
        }
        loop {
            column = self.row.skip_farther(column, end, &face.plane);
            if column == end {
                return None;
            }
            let left = self.row.store_nearer(column, end, &face.plane)? as i32;
            if column + left == end {
                return Some(left as usize);
            }
            self.fill_part(face, [start, column, end - left], run);
            column = end - left;
        }
    }

    /// Fills pixels from a column of a run to another one, without depths.
    #[inline(never)]
    fn fill_part(&mut self, face: &ActiveFace<S, H>, [start, column, end]: [i32; 3], run: Option<&Run<ValuesOf<H>>>) {
        let run = match run {
            Some(run) => {
                let mut run = *run;
                H::Attributes::step_by(&mut run.values, &run.per_column, column - start);
                run
            }
            None => H::Attributes::even_run(&face.attributes, column, end, self.row.y),
        };
        if let (Some(skin), Some(pixels)) = (self.faces.skin(face.node), self.row.pixels(column, end)) {
            varying::<S, D, H, F, O>(self.faces, skin, face.word, run).fill(pixels);
        }
    }

    /// Draws a span of a face whose attributes do not step evenly.
    #[inline(never)]
    fn draw_divided_span(&mut self, face: &ActiveFace<S, H>, span: [i32; 2]) -> Option<usize> {
        let (mut column, last) = (span[0].max(0), span[1].min(self.row.words.len() as i32));
        let skin = *self.faces.skin(face.node)?;
        if column >= last {
            return None;
        }
        self.count_pixels(last - column);
        let mut runs = DividedRuns::new::<S, D, H>(face, span, [column, self.row.y], self.row.left);
        self.faces.count().divisions(1);
        while column < last {
            if !H::HAS_HOLES && runs.is_whole(column) {
                match self.draw_whole_runs(face, &skin, &mut runs, [column, last]) {
                    Ok(reached) => column = reached,
                    Err(equal) => return Some((last - equal) as usize),
                }
            }
            let run = runs.next_run(column);
            self.faces.count().divisions(1);
            let run_end = run.end.min(last);
            let left_over = if H::HAS_HOLES {
                let shade = varying::<S, D, H, F, O>(self.faces, &skin, face.word, run);
                self.row.draw_run(column, run_end, shade, &face.plane)
            } else {
                self.draw_divided_run(face, &skin, [column, run_end], &run)
            };
            if let Some(left_over) = left_over {
                return Some(left_over + (last - run_end) as usize);
            }
            column = run_end;
        }
        None
    }

    /// Draws the pixels of a run that is inside the row, of a shading without holes: depths first, and then the visible pixels.
    #[inline(always)]
    fn draw_divided_run(
        &mut self,
        face: &ActiveFace<S, H>,
        skin: &F::Skin,
        [start, end]: [i32; 2],
        run: &Run<ValuesOf<H>>,
    ) -> Option<usize> {
        let left = self.store_nearer(start, end, face)?;
        if left > 0 {
            return self.draw_hidden_run(face, [start, end], left as i32, run);
        }
        varying::<S, D, H, F, O>(self.faces, skin, face.word, *run).fill(self.row.pixels(start, end)?);
        None
    }

    /// Draws whole runs of a shading without holes, from a column on and before another one, up to one that is hidden in part.
    /// Returns the column after them, or the first one whose depth is exactly the stored one.
    #[inline(always)]
    fn draw_whole_runs(
        &mut self,
        face: &ActiveFace<S, H>,
        skin: &F::Skin,
        runs: &mut DividedRuns<'_, H::Attributes>,
        [mut column, last]: [i32; 2],
    ) -> Result<i32, i32> {
        let range = column as usize..runs.last_column().min(last) as usize;
        let is_tested = self.is_tested();
        let words = self.row.words.get_mut(range.clone()).unwrap_or_default();
        let depths = self.row.depths.get_mut(range).unwrap_or_default();
        let (mut depth, per_column) = (face.plane.at(column, self.row.y), face.plane.per_column);
        let mut hidden = None;
        for (words, depths) in blocks_of(words).zip(blocks_of(depths)) {
            let run = runs.next_whole_run();
            self.faces.count().divisions(1);
            let left = if is_tested {
                store_nearer_block(depths, depth, per_column)
            } else {
                0
            };
            if left > 0 {
                hidden = Some((left as i32, run));
                break;
            }
            varying::<S, D, H, F, O>(self.faces, skin, face.word, run).fill_block(words);
            depth += per_column * Wrapping(WHOLE_RUN as u32);
            column += WHOLE_RUN;
        }
        let Some((left, run)) = hidden else {
            return Ok(column);
        };
        match self.draw_hidden_run(face, [column, run.end], left, &run) {
            Some(left) => Err(run.end - left as i32),
            None => Ok(run.end),
        }
    }

    /// Draws a run that is hidden in part: so many pixels are left from the first one on that is not nearer than its stored
    /// depth; the depths of those before it are stored.
    #[inline(never)]
    fn draw_hidden_run(
        &mut self,
        face: &ActiveFace<S, H>,
        [start, end]: [i32; 2],
        left: i32,
        run: &Run<ValuesOf<H>>,
    ) -> Option<usize> {
        let column = end - left;
        if start < column {
            self.fill_part(face, [start, start, column], Some(run));
        }
        self.draw_parts(face, [start, column, end], Some(run))
    }

    /// Fills the part of a span of a face that is inside the row, without depths.
    #[inline(never)]
    pub(super) fn fill_span(&mut self, face: &ActiveFace<S, H>, [start, end]: [i32; 2]) {
        let (column, end) = (start.max(0), end.min(self.row.words.len() as i32));
        let skin = self.faces.skin(face.node);
        if let (Some(skin), Some(words)) = (skin, self.row.words.get_mut(column as usize..end as usize)) {
            let run = H::Attributes::even_run(&face.attributes, column, end, self.row.y);
            // No copy: such attributes are those of shadings that take nothing of a skin for a fragment.
            varying::<S, D, H, F, O>(self.faces, skin, face.word, run).fill(words);
        }
    }
}

impl<S, D, H, F, O> ShadedRow<'_, '_, S, D, H, F, O>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
    O: Order,
{
    /// Fills pixels of a span of a face that lie in the row, from a column to another one, without depths.
    pub(super) fn fill_seen(&mut self, face: &ActiveFace<S, H>, [mut column, end]: [i32; 2]) {
        if are_even::<S, D, H, F>(face) {
            self.fill_part(face, [column, column, end], None);
            return;
        }
        let mut runs = DividedRuns::new::<S, D, H>(face, face.span(), [column, self.row.y], self.row.left);
        self.faces.count().divisions(1);
        while column < end {
            if runs.is_whole(column) {
                column = self.fill_whole_runs(face, &mut runs, [column, end]);
            }
            if column < end {
                let run = runs.next_run(column);
                self.faces.count().divisions(1);
                self.fill_part(face, [column, column, run.end.min(end)], Some(&run));
                column = run.end;
            }
        }
    }

    /// Fills whole runs that lie in the row, from a column on and before another one, without depths. Returns the column after
    /// them.
    fn fill_whole_runs(
        &mut self,
        face: &ActiveFace<S, H>,
        runs: &mut DividedRuns<'_, H::Attributes>,
        [mut column, end]: [i32; 2],
    ) -> i32 {
        let range = column as usize..runs.last_column().min(end) as usize;
        let words = self.row.words.get_mut(range).unwrap_or_default();
        let Some(skin) = self.faces.skin(face.node).copied() else {
            return end;
        };
        for words in blocks_of(words) {
            let run = runs.next_whole_run();
            self.faces.count().divisions(1);
            varying::<S, D, H, F, O>(self.faces, &skin, face.word, run).fill_block(words);
            column += WHOLE_RUN;
        }
        column
    }
}

/// The word of a pixel of a span of a face, in the machine's byte order; `None` for a hole. The span counts from the first
/// column of the row, the pixel lies in the picture.
#[cold]
#[inline(never)]
pub(super) fn word_at<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    faces: &F,
    face: &ActiveFace<S, H>,
    span: [i32; 2],
    [column, row]: [i32; 2],
    first_column: i32,
) -> Option<WordOf<H>> {
    let skin = faces.skin(face.node)?;
    let column = column - first_column;
    let run = run::<S, D, H, F>(face, span, [column, row], first_column);
    F::fragment(skin, face.word, &run.values)
}

/// The attributes of a face from a column of a span on, as far as they step evenly.
#[inline]
pub(super) fn run<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    face: &ActiveFace<S, H>,
    span: [i32; 2],
    [column, row]: [i32; 2],
    first_column: i32,
) -> Run<ValuesOf<H>> {
    if are_even::<S, D, H, F>(face) {
        H::Attributes::even_run(&face.attributes, column, span[1], row)
    } else {
        DividedRuns::new::<S, D, H>(face, span, [column, row], first_column).next_run(column)
    }
}

/// Whether rows may be drawn without testing depths though faces have depth planes, which their attributes are divided by: the
/// faces are opaque, have no holes, and nothing but them is compared with the depths.
pub(super) const fn may_be_untested<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>() -> bool {
    H::Attributes::NEED_DEPTH && !H::HAS_HOLES && !H::BLENDS && !F::ANTIALIASES
}

/// Whether the attributes of a face step evenly along whole spans.
#[inline(always)]
pub(super) fn are_even<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    face: &ActiveFace<S, H>,
) -> bool {
    F::IS_ORTHOGRAPHIC || H::Attributes::are_even(&face.attributes)
}

/// Whether a face covers a pixel of the picture, is no hole there, and nothing is seen through it.
#[cold]
#[inline(never)]
pub(super) fn is_seen<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    face: &ActiveFace<S, H>,
    [column, row]: [i32; 2],
    first_column: i32,
) -> bool {
    if face.is_translucent() || !covers(faces, face.node, column, row) {
        return false;
    }
    if !H::Attributes::VARY {
        return true;
    }
    let is_covered = |column: i32| covers(faces, face.node, column + first_column, row);
    let span = span_around(&is_covered, column - first_column + 1);
    word_at(faces, face, span, [column, row], first_column).is_some()
}

/// The colours of a face along a run.
#[inline(always)]
fn varying<'s, S, D, H, F, O>(
    faces: &'s F,
    skin: &'s F::Skin,
    word: WordOf<H>,
    run: Run<ValuesOf<H>>,
) -> Varying<'s, S, D, H, F, O>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    Varying {
        skin,
        word,
        run,
        count: faces.count(),
        order: PhantomData,
    }
}

/// Some pixels of a row as whole runs, from the first one on.
#[inline(always)]
fn blocks_of<T>(pixels: &mut [T]) -> impl Iterator<Item = &mut [T; WHOLE_RUN as usize]> {
    pixels
        .chunks_exact_mut(WHOLE_RUN as usize)
        .filter_map(|block| block.try_into().ok())
}

/// A row, for faces over which attributes vary.
pub(super) fn shaded_row<'r, 'a, S, D, H: Shading, F, O>(
    faces: &'r F,
    row: &'r mut DepthRow<'a, H::Color, O, D>,
) -> ShadedRow<'r, 'a, S, D, H, F, O>
where
    D: DepthWidth,
    O: Order,
{
    ShadedRow {
        faces,
        row,
        precision: PhantomData,
    }
}

/// The columns of a span of which the pixel before `end` is one: it may go on on both sides of the row.
// Once in flash, whatever the look: it is seldom asked.
pub(super) fn span_around(is_covered: &dyn Fn(i32) -> bool, end: i32) -> [i32; 2] {
    let before = (i32::MIN..end).rev().take_while(|column| is_covered(*column));
    let start = before.last().unwrap_or(end);
    [start, (end..).find(|column| !is_covered(*column)).unwrap_or(end)]
}
