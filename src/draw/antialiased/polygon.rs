//! Polygons with antialiased edges, drawn by any coverage method.
//!
//! The edges of an outline are set up once and linked into y-monotone chains, sorted by their first row. For each row
//! of pixels, the edges that lie in it are cut to segments, from which the coverage method computes the coverage of
//! each pixel.
//!
//! Guarantees: errors for tables that are too small come from [`prepare`](AntialiasedPolygon::prepare), with the exact
//! number that is needed; drawing needs only the memory for one row. Windows and bands do not change the coverage of a
//! pixel.

use core::ops::Range;

use heapless::{Vec, VecView};

use crate::{
    coverage::{
        Coverage, CoverageMethod, Mirror, SignedArea,
        edges::{
            AntialiasedEdge, RowSegment, Rows,
            antialiased_edge::NO_EDGE,
            monotone_chains::{ChainBuilder, Chains},
        },
    },
    draw::{FillRule, SubOutline},
    geometry::{DrawError, InputError, Sub8, SubPixel, TooSmall, Window},
    shade::BlendTarget,
    surface::Span,
};

/// The columns of pixels in which the domain of [`Sub8`] lies.
pub(crate) const DOMAIN: Range<i32> = (Sub8::MIN_UNITS >> 8)..(Sub8::MAX_UNITS >> 8) + 1;

/// A polygon whose edges are set up for computing the coverage of pixels.
///
/// Positions are in 1/256 pixel. A pixel is the square around its centre, which has whole coordinates, so that
/// antialiased shapes and others have the same position.
///
/// ```
/// use zrow::{
///     coverage::{CoverageMethod, SignedArea},
///     draw::{AntialiasedPolygon, FillRule},
///     geometry::{Sub8, SubPoint, Window},
/// };
///
/// // From the middle of pixel 0 to the middle of pixel 2, one row high.
/// let corner = |x, y| SubPoint::<Sub8>::from_units(x, y);
/// let corners = [corner(0, -128)?, corner(512, -128)?, corner(512, 128)?, corner(0, 128)?];
/// let polygon = AntialiasedPolygon::<2, 2>::prepare(&[corners.as_slice()], FillRule::NonZero)?;
///
/// let mut row = [0; 4];
/// let mut mask = [0; 3];
/// let window = Window { left: 0, top: 0, right: 3, bottom: 1 };
/// polygon.cover(&SignedArea, &window, &mut row, |span, coverage| {
///     mask[span.start as usize..span.end as usize].fill(coverage);
///     Ok::<_, zrow::geometry::TooSmall>(())
/// })?;
/// assert_eq!(mask, [128, 255, 128]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct AntialiasedPolygon<const EDGES: usize, const ACTIVE: usize> {
    edges: Vec<AntialiasedEdge, EDGES>,
    /// The index of the first chain's first edge.
    first: u32,
    /// The row after the last one that an edge lies in.
    end_row: i32,
    fill_rule: FillRule,
    /// The sum of a column and its mirror image, if the table has the edges of the left half alone of an outline whose right
    /// half is the mirror image of it; `None` if it has all edges.
    mirror: Option<i32>,
}

impl<const EDGES: usize, const ACTIVE: usize> AntialiasedPolygon<EDGES, ACTIVE> {
    /// Sets up the edges of an outline.
    ///
    /// `EDGES` is the number of edges that are not level, `ACTIVE` the largest number of them in one row of pixels. RAM
    /// on a 32-bit machine: `20 * EDGES` bytes, and `64 * ACTIVE` on the stack while the polygon is drawn.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a corner is outside the domain of [`Sub8`], which is possible for a point
    /// whose coordinates were set directly; [`InputError::TooSmall`] with the table that was too small and the exact
    /// number that is needed. The number of edges is checked first.
    pub fn prepare<O: SubOutline + ?Sized>(outline: &O, fill_rule: FillRule) -> Result<Self, InputError> {
        let mut polygon = Self::empty();
        polygon.set_up(outline, fill_rule)?;
        Ok(polygon)
    }

    /// A polygon without edges, which covers nothing: a place for [`set_up`](Self::set_up).
    #[inline]
    pub const fn empty() -> Self {
        Self {
            edges: Vec::new(),
            first: NO_EDGE,
            end_row: i32::MIN,
            fill_rule: FillRule::NonZero,
            mirror: None,
        }
    }

    /// Makes a polygon that of another outline, where it is: [`prepare`](Self::prepare) without moving the table of edges, which
    /// may lie in a `static` or be used for one outline after the other.
    ///
    /// ```
    /// use zrow::{draw::{AntialiasedPolygon, FillRule}, geometry::{Sub8, SubPoint}};
    ///
    /// let corner = |x, y| SubPoint::<Sub8>::from_units(x, y);
    /// let mut polygon = AntialiasedPolygon::<3, 3>::empty();
    /// for right in [512, 768] {
    ///     let corners = [corner(0, 0)?, corner(right, 300)?, corner(0, 600)?];
    ///     polygon.set_up(&[corners.as_slice()], FillRule::NonZero)?;
    ///     assert_eq!(polygon.bounds().right, 1 + right / 256);
    /// }
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a corner is outside the domain of [`Sub8`]; [`InputError::TooSmall`] with the table that is
    /// too small and the number that is needed. The polygon is empty then.
    pub fn set_up<O: SubOutline + ?Sized>(&mut self, outline: &O, fill_rule: FillRule) -> Result<(), InputError> {
        self.collect(fill_rule, |edge| outline.edges(edge))
    }

    /// [`set_up`](Self::set_up) for some rows: edges outside of them may be left out.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a corner is outside the domain of [`Sub8`]; [`InputError::TooSmall`] with the table that is
    /// too small and the number that is needed. The polygon is empty then.
    pub(super) fn set_up_for(
        &mut self,
        rows: &Range<i32>,
        outline: &dyn SubOutline,
        fill_rule: FillRule,
    ) -> Result<(), InputError> {
        self.collect(fill_rule, |edge| outline.edges_in_rows(rows, edge))
    }

    /// [`set_up_for`](Self::set_up_for) the left half of an outline whose right half is its [mirror image](SubOutline::mirror),
    /// for [`draw_mirrored`](Self::draw_mirrored). `mirror` is the sum of a column and its mirror image.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a corner is outside the domain of [`Sub8`]; [`InputError::TooSmall`] with the table
    /// that is too small and the number that is needed. The polygon is empty then.
    pub(super) fn set_up_left_half(
        &mut self,
        rows: &Range<i32>,
        outline: &dyn SubOutline,
        mirror: i32,
    ) -> Result<(), InputError> {
        self.collect(FillRule::NonZero, |edge| outline.left_edges_in_rows(rows, edge))?;
        self.mirror = Some(mirror);
        Ok(())
    }

    /// Puts the edges that `hand_over` hands over in the place of those before, and links their chains. The table is empty after
    /// an error.
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] where a corner is outside the domain of [`Sub8`]; [`InputError::TooSmall`] with the table that is
    /// too small and the number that is needed. The polygon is empty then.
    #[inline]
    fn collect(
        &mut self,
        fill_rule: FillRule,
        hand_over: impl FnOnce(&mut dyn FnMut([i32; 2], [i32; 2])),
    ) -> Result<(), InputError> {
        self.clear();
        self.fill_rule = fill_rule;
        let mut chains = ChainBuilder::new(self.edges.as_mut_view());
        hand_over(&mut |from, to| chains.add(from, to));
        let (is_in_domain, needed) = (chains.is_in_domain(), chains.needed());
        let result = if is_in_domain {
            (self.first, self.end_row) = chains.finish();
            self.check_tables(needed)
        } else {
            Err(InputError::out_of_domain::<Sub8>())
        };
        if result.is_err() {
            self.clear();
        }
        result
    }

    /// Checks that the tables have room for the edges, `needed` in all.
    ///
    /// # Errors
    /// [`InputError::TooSmall`] with the table that has not.
    fn check_tables(&self, needed: usize) -> Result<(), InputError> {
        check(EDGES, TooSmall::Edges(needed))?;
        let chains = Chains::new(&self.edges, self.first);
        if needed > ACTIVE && !chains.have_at_most(ACTIVE) {
            let most_active = chains.most_active(Vec::<_, EDGES>::new().as_mut_view());
            check(ACTIVE, TooSmall::ActiveEdges(most_active))?;
        }
        Ok(())
    }

    /// Takes all edges away.
    fn clear(&mut self) {
        self.edges.clear();
        self.first = NO_EDGE;
        self.end_row = i32::MIN;
        self.mirror = None;
    }

    /// A window around all pixels of which something is covered; empty where the outline has no edge that is not level.
    /// The window is the smallest one around the pixels in which the edges lie, except for a column more where an edge
    /// passes through a corner of a pixel.
    pub fn bounds(&self) -> Window {
        let rows = Chains::new(&self.edges, self.first).first_row()..self.end_row;
        if rows.is_empty() {
            return Window::EMPTY;
        }
        let (left, right) = self.columns_in(&rows);
        Window {
            left,
            top: rows.start,
            right,
            bottom: rows.end,
        }
    }

    /// The first column of the edges in these rows and the one after the last; the first is larger where no edge lies
    /// in them.
    pub(crate) fn columns_in(&self, rows: &Range<i32>) -> (i32, i32) {
        let (mut left, mut right) = (i32::MAX, i32::MIN);
        for edge in &self.edges {
            if edge.first_row() < rows.end && rows.start < edge.end_row() {
                let [start, end] = edge.columns_in(rows);
                (left, right) = (left.min(start), right.max(end));
            }
        }
        (left, right)
    }

    /// The edges that are not level, in the order of the outline's contours.
    pub(crate) fn edges(&self) -> &[AntialiasedEdge] {
        &self.edges
    }

    pub(crate) fn fill_rule(&self) -> FillRule {
        self.fill_rule
    }

    /// Whether the edges are those of the left half alone, and the right half is its mirror image.
    pub(super) fn is_mirrored(&self) -> bool {
        self.mirror.is_some()
    }

    /// Blends the visible part of the polygon over the target, with coverage from `method`. `row_memory` is as for
    /// [`cover`](Self::cover), for the width of the target's window.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] if `row_memory` has too few cells; nothing is drawn then. [`DrawError::Target`] with the
    /// target's own error.
    pub fn draw<T: CoverageMethod, B: BlendTarget>(
        &self,
        method: &T,
        color: B::Color,
        target: &mut B,
        row_memory: &mut [T::Cell],
    ) -> Result<(), DrawError<B::Error>> {
        self.draw_in(&target.window(), method, color, target, row_memory)
    }

    /// Blends the part of the polygon that lies in a window, which lies in that of the target, as [`draw`](Self::draw) does.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] if `row_memory` has too few cells for the width of the window; nothing is drawn then.
    /// [`DrawError::Target`] with the target's own error.
    pub(crate) fn draw_in<T: CoverageMethod, B: BlendTarget>(
        &self,
        window: &Window,
        method: &T,
        color: B::Color,
        target: &mut B,
        row_memory: &mut [T::Cell],
    ) -> Result<(), DrawError<B::Error>> {
        let mut segments = Vec::<RowSegment, ACTIVE>::new();
        let visible = self.rows::<T>(window, row_memory, segments.as_mut_view());
        let Some((rows, columns)) = visible.map_err(DrawError::TooSmall)? else {
            return Ok(());
        };
        let mut blender = target.blender(color);
        let drawn = method.cover_rows(rows, self.fill_rule, columns, row_memory, &mut blender);
        drawn.map_err(DrawError::Target)
    }

    /// Blends the visible part of an outline over the target of which the left half is set up.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] if `row_memory` has too few cells; nothing is drawn then. [`DrawError::Target`] with the
    /// target's own error.
    pub(super) fn draw_mirrored<B: BlendTarget>(
        &self,
        color: B::Color,
        target: &mut B,
        row_memory: &mut [i32],
    ) -> Result<(), DrawError<B::Error>> {
        let window = target.window();
        let mut segments = Vec::<RowSegment, 0>::new();
        let visible = self.rows::<SignedArea>(&window, row_memory, segments.as_mut_view());
        let (Some((rows, columns)), Some(mirror)) = (visible.map_err(DrawError::TooSmall)?, self.mirror) else {
            return Ok(());
        };
        let mirror = Mirror::of(mirror, &columns);
        let drawn = SignedArea::cover_mirrored_rows(rows, mirror, row_memory, &mut target.blender(color));
        drawn.map_err(DrawError::Target)
    }

    /// Calls `emit` with the covered pixels of a window, in spans of equal coverage: rows from top to bottom, spans
    /// from left to right, each pixel at most once.
    ///
    /// `row_memory` takes as many cells as [`CoverageMethod::cells`] returns for the window's width. All cells must be
    /// 0, and they are 0 again afterwards.
    ///
    /// # Errors
    /// [`TooSmall`] if `row_memory` has fewer cells; nothing was emitted then. The first error that `emit` returns.
    pub fn cover<T: CoverageMethod, E: From<TooSmall>>(
        &self,
        method: &T,
        window: &Window,
        row_memory: &mut [T::Cell],
        mut emit: impl FnMut(Span, Coverage) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut segments = Vec::<RowSegment, ACTIVE>::new();
        let Some((rows, columns)) = self.rows::<T>(window, row_memory, segments.as_mut_view())? else {
            return Ok(());
        };
        method.cover_rows(rows, self.fill_rule, columns, row_memory, &mut emit)
    }

    /// Calls `row` for each visible row that has segments, from top to bottom: with its y, its segments, the visible
    /// columns in the domain, and the row memory.
    ///
    /// # Errors
    /// [`TooSmall`] if `row_memory` has fewer cells than [`CoverageMethod::cells`] of the window's width. The first
    /// error that `row` returns.
    #[inline]
    pub(crate) fn for_each_row<T: CoverageMethod, E: From<TooSmall>>(
        &self,
        window: &Window,
        row_memory: &mut [T::Cell],
        mut row: impl FnMut(i32, &mut [RowSegment], Range<i32>, &mut [T::Cell]) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut segments = Vec::<RowSegment, ACTIVE>::new();
        let Some((rows, columns)) = self.rows::<T>(window, row_memory, segments.as_mut_view())? else {
            return Ok(());
        };
        rows.for_each(|y, segments| row(y, segments, columns.clone(), row_memory))
    }

    /// The visible rows of the polygon and the columns of the window that are in the domain; `None` where there are
    /// none.
    #[inline]
    fn rows<'r, T: CoverageMethod>(
        &'r self,
        window: &Window,
        row_memory: &[T::Cell],
        segments: &'r mut VecView<RowSegment>,
    ) -> Result<Option<(Rows<'r>, Range<i32>)>, TooSmall> {
        let needed = T::cells(window.width() as usize);
        if row_memory.len() < needed {
            return Err(TooSmall::Cells(needed));
        }
        let chains = Chains::new(&self.edges, self.first);
        let first_row = chains.first_row();
        // The most frequent case for bands of one row: no edge lies in the window.
        if self.end_row <= window.top || first_row >= window.bottom {
            return Ok(None);
        }
        // Columns outside the domain are cut off: their position in 1/8192 pixel could overflow.
        let columns = window.left.max(DOMAIN.start)..window.right.min(DOMAIN.end);
        if columns.is_empty() {
            return Ok(None);
        }
        let rows = Rows {
            height: (self.end_row - first_row) as usize,
            chains,
            segments,
            rows: window.top..window.bottom,
        };
        Ok(Some((rows, columns)))
    }
}

/// [`InputError::TooSmall`] where more than `capacity` entries of a table are needed.
fn check(capacity: usize, needed: TooSmall) -> Result<(), InputError> {
    if needed.needed() <= capacity {
        Ok(())
    } else {
        Err(InputError::TooSmall(needed))
    }
}

#[cfg(feature = "defmt")]
impl<const EDGES: usize, const ACTIVE: usize> defmt::Format for AntialiasedPolygon<EDGES, ACTIVE> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "AntialiasedPolygon, {}, {} of {} edges",
            self.fill_rule,
            self.edges.len(),
            EDGES
        );
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        mock_display::MockDisplay,
        pixelcolor::{Gray4, GrayColor},
    };

    use super::*;
    use crate::{
        coverage::{CentreSample, InsideArea, SignedArea},
        draw::pictures::{at, blended},
        geometry::SubPoint,
    };

    /// Draws white contours, with coverage by `method`.
    fn drawn<T: CoverageMethod>(method: &T, contours: &[&[SubPoint<Sub8>]], fill_rule: FillRule) -> MockDisplay<Gray4> {
        let polygon = AntialiasedPolygon::<8, 8>::prepare(contours, fill_rule).unwrap();
        blended(|band| {
            polygon
                .draw(method, Gray4::WHITE, band, &mut [T::Cell::default(); 17])
                .unwrap()
        })
    }

    /// Half of each pixel along the sides is covered, and a quarter of each pixel at the corners.
    #[test]
    fn a_rectangle_between_the_centres_of_pixels() {
        let rectangle = [at(1.0, 1.0), at(9.0, 1.0), at(9.0, 5.0), at(1.0, 5.0)];
        drawn(&SignedArea, &[&rectangle], FillRule::NonZero).assert_pattern(&[
            "          ",
            " 488888884",
            " 8FFFFFFF8",
            " 8FFFFFFF8",
            " 8FFFFFFF8",
            " 488888884",
        ]);
    }

    #[test]
    fn a_triangle_by_area_and_by_the_centres_of_pixels() {
        let triangle = [at(-0.5, -0.5), at(12.5, 2.5), at(3.5, 8.5)];
        drawn(&SignedArea, &[&triangle], FillRule::NonZero).assert_pattern(&[
            "AA63         ",
            "5FFFEB841    ",
            " DFFFFFFFC952",
            " 7FFFFFFFFFE5",
            " 1EFFFFFFFA1 ",
            "  8FFFFFE5   ",
            "  2FFFFA1    ",
            "   AFE5      ",
            "   3A1       ",
        ]);
        drawn(&CentreSample, &[&triangle], FillRule::NonZero).assert_pattern(&[
            "FF          ",
            " FFFFF      ",
            " FFFFFFFFFF ",
            "  FFFFFFFFFF",
            "  FFFFFFFFF ",
            "  FFFFFFF   ",
            "   FFFFF    ",
            "   FFF      ",
            "    F       ",
        ]);
    }

    #[test]
    fn a_hole_by_the_even_odd_rule_cut_by_the_upper_left_corner() {
        let outside = [at(-4.5, -3.5), at(8.5, -3.5), at(8.5, 6.75), at(-4.5, 6.75)];
        let hole = [at(-2.5, -1.5), at(4.25, -1.5), at(4.25, 3.5), at(-2.5, 3.5)];
        drawn(&InsideArea, &[&outside, &hole], FillRule::EvenOdd).assert_pattern(&[
            "    4FFFF",
            "    4FFFF",
            "    4FFFF",
            "    4FFFF",
            "FFFFFFFFF",
            "FFFFFFFFF",
            "FFFFFFFFF",
            "444444444",
        ]);
    }

    /// In the pixel where both sides cross, a quarter has the winding number 1 and another quarter -1: half of the
    /// pixel is inside, but the signed areas add up to 0.
    #[test]
    fn the_sides_of_a_bow_tie_cancel_by_signed_area_alone() {
        let bow_tie = [at(0.5, 0.5), at(7.5, 0.5), at(0.5, 7.5), at(7.5, 7.5)];
        drawn(&InsideArea, &[&bow_tie], FillRule::NonZero).assert_pattern(&[
            "         ",
            " 8FFFFF8 ",
            "  8FFF8  ",
            "   8F8   ",
            "    8    ",
            "   8F8   ",
            "  8FFF8  ",
            " 8FFFFF8 ",
        ]);
        drawn(&SignedArea, &[&bow_tie], FillRule::NonZero).assert_pattern(&[
            "         ",
            " 8FFFFF8 ",
            "  8FFF8  ",
            "   8F8   ",
            "         ",
            "   8F8   ",
            "  8FFF8  ",
            " 8FFFFF8 ",
        ]);
    }
}
