//! Faces of a row with antialiased silhouettes, painted from back to front: where a silhouette passes through a pixel, the surface
//! that ends there is composited, by its coverage, over what was painted before it.
//!
//! ```text
//!     painted, from back to front     coverage 3/4 of the surface that ends in the pixel
//!
//!     A, B, C    whole, whole, ends   the number of surfaces by area is 2 3/4: C is one more than the two whole ones, so
//!                                     it is the one that ends: A, B over it, 3/4 of C over that
//!     A, B       whole, whole         no third surface comes: E, which has the edge, is beside the centre of the pixel: A, B over
//!                                     it, 3/4 of E over that, unless E is behind B
//!     A, T, C    T is translucent     A, T mixed with it, 3/4 of C over that: T is seen beside C
//! ```
//!
//! The coverage in a pixel is that of the depth row: a sum over all silhouettes of the row, in which edges between the faces of a
//! surface, and the places where the painter splits a face, do not occur. So neither leaves a seam. A surface beside the centre of
//! its pixel is composited at its depth: before the first translucent face that is nearer than its edge, or at the end.
//!
//! Guarantees: the picture of the depth row, which mixes when the row is drawn, where all faces are opaque, none is cut, and no more
//! than 31 surfaces cover a pixel as a whole through which a silhouette passes. Where a translucent face lies between a surface
//! that ends and what is behind it, it is seen there, which the depth row leaves out.
//! Memory: what the depth row has for a column is reused. Cost: a look at each column of a span in rows with silhouettes.
//!
//! Source: Newell, Newell and Sancha 1972 for the order; `over` of Porter and Duff 1984, with coverage as alpha (Carpenter 1984).

use core::num::Wrapping;

use crate::{
    coverage::{AREA_BITS, Coverage},
    shade::{Planes, Shading},
    surface::{Order, PixelWord},
    view::{DepthWidth, ScreenPrecision},
    visible::{
        DepthRow,
        active_face::{ActiveFace, WordOf},
        blended_row::blend_span,
        face_table::{FaceTable, NONE},
        painter::Painter,
        passes::{face_in_first_row, surroundings},
        shaded_span::shaded_row,
        silhouette_pixels::{InSlots, Surface, ends, mix, word_of, word_of_face},
        silhouette_row::{EdgeColumn, EdgeRow},
    },
};

/// How far a pixel through which silhouettes pass is painted: takes the place of the change of the number of surfaces in its
/// column, once that is summed up.
///
/// The number of whole surfaces that are still to come is kept up to 31: of more than that one may be taken for the one that
/// ends.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
struct PaintedPixel {
    /// The part of the pixel that belongs to the surface which ends there.
    coverage: Coverage,
    /// Whole surfaces by area, less those that were painted at the centre of the pixel.
    whole_left: u8,
    /// Whether the surface that ends is still to be painted: beside the centre, if no further surface comes.
    is_pending: bool,
    /// Whether a translucent face was painted after the last opaque one.
    is_veiled: bool,
    /// Whether there are no whole surfaces: what is behind the one that ends is what was there before all.
    is_single: bool,
    /// The opaque face that was painted last, or [`NONE`].
    last: u16,
}

impl PaintedPixel {
    const WHOLE: u32 = 8;
    const MOST_WHOLE: u8 = 31;
    const SINGLE: u32 = 1 << 13;
    const PENDING: u32 = 1 << 14;
    const VEILED: u32 = 1 << 15;
    const LAST: u32 = 16;

    /// A pixel to which nothing was painted, with a number of surfaces by area.
    fn new(area: i32) -> Self {
        let part = (area & ((1 << AREA_BITS) - 1)) * i32::from(Coverage::MAX) + (1 << (AREA_BITS - 1));
        let whole = (area >> AREA_BITS).clamp(0, Self::MOST_WHOLE.into());
        Self {
            coverage: (part >> AREA_BITS) as Coverage,
            whole_left: whole as u8,
            is_pending: true,
            is_veiled: false,
            is_single: whole == 0,
            last: NONE,
        }
    }

    fn from_bits(bits: i32) -> Self {
        let bits = bits as u32;
        Self {
            coverage: bits as Coverage,
            whole_left: (bits >> Self::WHOLE) as u8 & Self::MOST_WHOLE,
            is_pending: bits & Self::PENDING != 0,
            is_veiled: bits & Self::VEILED != 0,
            is_single: bits & Self::SINGLE != 0,
            last: (bits >> Self::LAST) as u16,
        }
    }

    fn to_bits(self) -> i32 {
        let flag = |is_set: bool, flag: u32| if is_set { flag } else { 0 };
        let bits = u32::from(self.coverage)
            | u32::from(self.whole_left) << Self::WHOLE
            | flag(self.is_pending, Self::PENDING)
            | flag(self.is_veiled, Self::VEILED)
            | flag(self.is_single, Self::SINGLE)
            | u32::from(self.last) << Self::LAST;
        bits as i32
    }
}

/// A pixel through which silhouettes pass, taken out of its column: what was painted to it, and the nearest edge.
struct EdgePixel<D> {
    column: i32,
    painted: PaintedPixel,
    /// The face and the depth of the nearest edge.
    face: u16,
    depth: D,
}

/// Paints the faces of a row that come from back to front, with antialiased silhouettes.
pub(crate) struct SilhouettePainter<'p, 'r, 'c, D: DepthWidth, H: Shading, F, O: Order> {
    faces: &'p F,
    row: DepthRow<'r, H::Color, O, D>,
    edges: EdgeRow<'c, WordOf<H>, D>,
}

impl<'p, 'r, 'c, D: DepthWidth, H: Shading, F, O: Order> SilhouettePainter<'p, 'r, 'c, D, H, F, O> {
    /// Paints faces of a table into a row that nothing was drawn to yet, whose silhouettes have been added.
    pub(crate) fn new(faces: &'p F, row: DepthRow<'r, H::Color, O, D>, mut edges: EdgeRow<'c, WordOf<H>, D>) -> Self {
        sum_up(&mut edges);
        Self { faces, row, edges }
    }

    /// Composites what is still to be painted when all faces were, and leaves the columns of the row empty.
    pub(crate) fn finish<S: ScreenPrecision>(mut self)
    where
        F: FaceTable<S, D, H>,
    {
        let touched = self.edges.touched;
        touched.for_each_run(|run| {
            for column in run {
                let column = column as i32;
                if let Some(pixel) = self.edge_pixel(column) {
                    self.composite_beside(pixel);
                }
                if let Some(entry) = self.edges.columns.get_mut(column as usize) {
                    (entry.face, entry.change) = (0, 0);
                }
            }
        });
    }

    /// What is known of a pixel, if a silhouette passes through it.
    fn edge_pixel(&self, column: i32) -> Option<EdgePixel<D>> {
        let entry = self.edges.columns.get(column as usize)?;
        let face = entry.face & !EdgeColumn::<WordOf<H>, D>::ONE_EDGE;
        Some(EdgePixel {
            column,
            painted: PaintedPixel::from_bits(entry.change),
            face: face.checked_sub(1)?,
            depth: entry.depth,
        })
    }

    /// Keeps how far a pixel is painted.
    fn keep(&mut self, column: i32, painted: PaintedPixel) {
        if let Some(entry) = self.edges.columns.get_mut(column as usize) {
            entry.change = painted.to_bits();
        }
    }

    /// The first column from one on, and before another one, through which a silhouette passes; else the latter.
    fn next_edge(&self, [start, end]: [i32; 2]) -> i32 {
        if self.edges.is_untouched() {
            return end;
        }
        let columns = self.edges.columns.get(start as usize..end as usize).unwrap_or_default();
        let before = columns.iter().position(|entry| entry.face != 0);
        before.map_or(end, |before| start + before as i32)
    }

    /// Visits the columns of a span through which silhouettes pass.
    fn for_each_edge(&mut self, [mut start, end]: [i32; 2], mut visit: impl FnMut(&mut Self, EdgePixel<D>)) {
        loop {
            start = self.next_edge([start, end]);
            let Some(pixel) = self.edge_pixel(start).filter(|_| start < end) else {
                return;
            };
            visit(self, pixel);
            start += 1;
        }
    }

    /// The word of a pixel of the row.
    fn word(&self, column: i32) -> Option<WordOf<H>> {
        self.row.words.get(column as usize).copied().map(O::reorder)
    }

    /// Paints columns of an opaque face, whole pixels.
    fn fill<S: ScreenPrecision>(&mut self, face: &ActiveFace<S, H>, [start, end]: [i32; 2])
    where
        F: FaceTable<S, D, H>,
    {
        if start >= end {
            return;
        }
        if H::Attributes::VARY {
            shaded_row(self.faces, &mut self.row).fill_seen(face, [start, end]);
        } else {
            self.row.fill_span(start, end, face.word);
        }
    }

    /// Paints a pixel through which a silhouette passes with an opaque face that is at its centre: by its coverage if it is of
    /// the surface that ends there, else whole.
    fn paint_pixel<S: ScreenPrecision>(&mut self, face: &ActiveFace<S, H>, pixel: EdgePixel<D>)
    where
        F: FaceTable<S, D, H>,
    {
        let EdgePixel {
            column, mut painted, ..
        } = pixel;
        let at = [column, self.row.y];
        let depth = D::from_interpolated(face.plane.at(column, self.row.y).0);
        let behind = self.behind(&pixel);
        self.fill(face, [column, column + 1]);
        // A fragment of a cut face has another number than its face. The edges of those are not known, and do not count.
        let is_cut = self.faces.order(face.node) != face.node;
        let is_one_more = !is_cut && painted.whole_left == 0;
        let word = word_of(self.faces, face, at, self.row.left);
        let is_hole = H::HAS_HOLES && word.is_none();
        if !painted.is_single || is_cut {
            self.keep_behind(column, self.word(column));
        } else if painted.is_veiled {
            self.keep_behind(column, behind);
        }
        if is_one_more && !is_hole {
            let nearest = Surface {
                face: face.node,
                depth,
                word,
            };
            if let Some(behind) = behind.filter(|_| self.is_end(&pixel, &nearest)) {
                self.composite_at_centre(&pixel, word, behind);
            }
        }
        // Behind the face the one that ends is hidden; through a hole it is seen.
        painted.is_pending &= is_hole || (pixel.depth >= depth && !is_one_more);
        if !is_cut {
            painted.whole_left = painted.whole_left.saturating_sub(1);
            painted.last = face.node;
        }
        painted.is_veiled &= is_hole;
        self.keep(column, painted);
    }

    /// What is behind the face that is painted next to a pixel, if the face is of the surface that ends there.
    fn behind(&self, pixel: &EdgePixel<D>) -> Option<WordOf<H>> {
        if pixel.painted.is_veiled {
            return self.word(pixel.column);
        }
        let entry = self.edges.columns.get(pixel.column as usize)?;
        Some(O::reorder(entry.behind))
    }

    /// Keeps what is behind the next surface in a pixel.
    fn keep_behind(&mut self, column: i32, word: Option<WordOf<H>>) {
        if let (Some(entry), Some(word)) = (self.edges.columns.get_mut(column as usize), word) {
            entry.behind = O::reorder(word);
        }
    }

    /// Whether a surface at the centre of a pixel, which is one more than there are whole ones, is the one that ends there: else
    /// it is one behind it.
    fn is_end<S: ScreenPrecision>(&self, pixel: &EdgePixel<D>, nearest: &Surface<WordOf<H>, D>) -> bool
    where
        F: FaceTable<S, D, H>,
    {
        if pixel.painted.is_single || pixel.depth >= nearest.depth {
            return true;
        }
        let surroundings = surroundings(self.faces, self.row.left);
        let Some(second) = face_in_first_row(self.faces, pixel.painted.last, &surroundings) else {
            return true;
        };
        let second = Surface {
            face: second.node,
            depth: D::from_interpolated(second.plane.at(pixel.column, self.row.y).0),
            word: None,
        };
        ends(self.faces, (pixel.face, pixel.depth), nearest, &second)
    }

    /// Composites a face that was painted last, at the centre of a pixel, over what was there before.
    fn composite_at_centre<S: ScreenPrecision>(
        &mut self,
        pixel: &EdgePixel<D>,
        word: Option<WordOf<H>>,
        behind: WordOf<H>,
    ) where
        F: FaceTable<S, D, H>,
    {
        let is_single = pixel.painted.is_single;
        // The depth row shades pixels with several surfaces one by one.
        let word = if is_single { self.word(pixel.column) } else { word };
        let behind = if is_single { behind } else { self.shaded(pixel, behind) };
        if let Some(word) = word {
            mix::<S, _, _, _, F>(&mut self.row, pixel.column, word, behind, pixel.painted.coverage);
        }
    }

    /// Composites the surface that ends in a pixel beside its centre, if that is still to be painted.
    fn composite_beside<S: ScreenPrecision>(&mut self, pixel: EdgePixel<D>)
    where
        F: FaceTable<S, D, H>,
    {
        let EdgePixel {
            column, mut painted, ..
        } = pixel;
        let (true, Some(behind)) = (painted.is_pending, self.word(column)) else {
            return;
        };
        let at = [column, self.row.y];
        let none: InSlots<'_, S, H> = InSlots(&[]);
        if let Some(word) = word_of_face(self.faces, pixel.face, at, self.row.left, &none) {
            let behind = self.shaded(&pixel, behind);
            mix::<S, _, _, _, F>(&mut self.row, column, word, behind, painted.coverage);
        }
        painted.is_pending = false;
        self.keep(column, painted);
    }

    /// The word of a pixel to which an opaque face was painted last, as its attributes are there: painted in runs they are rounded
    /// otherwise.
    fn shaded<S: ScreenPrecision>(&self, pixel: &EdgePixel<D>, painted: WordOf<H>) -> WordOf<H>
    where
        F: FaceTable<S, D, H>,
    {
        if !H::Attributes::VARY || pixel.painted.is_veiled || pixel.painted.last == NONE {
            return painted;
        }
        let surroundings = surroundings(self.faces, self.row.left);
        let face = face_in_first_row(self.faces, pixel.painted.last, &surroundings);
        let at = [pixel.column, self.row.y];
        face.and_then(|face| word_of(self.faces, &face, at, self.row.left))
            .unwrap_or(painted)
    }

    /// Mixes columns of a translucent face with what was painted. What ends beside the centre of a pixel behind it comes before.
    fn blend<S: ScreenPrecision>(&mut self, face: &ActiveFace<S, H>, columns: [i32; 2])
    where
        F: FaceTable<S, D, H>,
    {
        self.for_each_edge(columns, |this, pixel| {
            let column = pixel.column;
            if D::from_interpolated(face.plane.at(column, this.row.y).0) > pixel.depth {
                this.composite_beside(pixel);
            }
            if let Some(EdgePixel { mut painted, .. }) = this.edge_pixel(column) {
                painted.is_veiled = true;
                this.keep(column, painted);
            }
        });
        blend_span(self.faces, &mut self.row, face, columns);
    }
}

impl<S, D, H, F, O> Painter<S, H> for SilhouettePainter<'_, '_, '_, D, H, F, O>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
    O: Order,
{
    fn span(&mut self, face: &ActiveFace<S, H>, _row: i32, [mut start, end]: [i32; 2]) {
        if face.is_translucent() {
            self.blend(face, [start, end]);
            return;
        }
        while start < end {
            let next = self.next_edge([start, end]);
            self.fill(face, [start, next]);
            if let Some(pixel) = self.edge_pixel(next).filter(|_| next < end) {
                self.paint_pixel(face, pixel);
            }
            start = next + 1;
        }
    }
}

/// Sums the number of surfaces up in all columns that silhouettes touch. Pixels of which nothing is covered in part are as if no
/// silhouette passed through them.
fn sum_up<W: PixelWord, D: DepthWidth>(edges: &mut EdgeRow<'_, W, D>) {
    let mut area = Wrapping(0);
    let EdgeRow { columns, touched, .. } = edges;
    touched.for_each_run(|run| {
        for entry in columns
            .get_mut(run.start..)
            .unwrap_or_default()
            .iter_mut()
            .take(run.len())
        {
            area += entry.change;
            let pixel = PaintedPixel::new(area.0);
            if pixel.coverage == 0 {
                entry.face = 0;
            }
            entry.change = if entry.face == 0 { 0 } else { pixel.to_bits() };
        }
    });
}
