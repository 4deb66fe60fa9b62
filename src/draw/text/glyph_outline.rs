//! The outline of a glyph in pixels: its contours are walked along in flash, and each curve is flattened where it is met.
//!
//! ```text
//!     1 ------ 2         on the contour: 1, 2 and 4; a control point: 3
//!     |         `.
//!     |      3    4      line 1-2, curve 2-3-4, line 4-1; a row of pixels looks at the y of the points,
//!      `---------´       and flattens what it meets: nothing is kept from row to row
//! ```
//!
//! Points are rounded to 1/256 pixel; curves between them become lines by adaptive forward differences, which are nowhere
//! further than 1/64 pixel from the curve. Each row has the edges that the whole outline has there.
//!
//! Cost of a row: some 15 instructions for each point of the glyph, and what the curves take that are met.

use fixed::types::U8F8;

use crate::{
    coverage::{AnyCoverage, EmitRows, InsideArea, RowSegment, UnorderedRow, edges::AntialiasedEdge},
    draw::{
        FillRule, SubOutline,
        outline::RowMemory,
        text::{
            outline_font::{OutlineFont, OutlineGlyph},
            scale::Scale,
        },
    },
    geometry::Window,
    scan::curve::parabola,
    shade::BlendTarget,
};

/// A corner of an outline: x and y in 1/256 pixel.
type Corner = [i32; 2];

/// A point of a contour: x and y in half a font unit, y upwards.
type HalfUnits = [i32; 2];

/// How far lines may be from their curve: 1/64 pixel, as for paths. Half of that would be 1.4 times as many lines.
const TOLERANCE: U8F8 = U8F8::from_bits(4);

/// 1/256 pixel, in a pixel.
const PIXEL: i32 = 256;

/// Bits of an edge's index below those of its piece: a curve has 4,096 lines at most.
const LINE_BITS: u32 = 13;

/// The outline of a glyph at a position. All of its corners lie in the domain of [`Sub8`](crate::geometry::Sub8).
#[derive(Debug, Copy, Clone)]
pub(in crate::draw) struct GlyphOutline<'f> {
    pub(super) font: &'f OutlineFont,
    /// The glyph, whose bounds must lie in the domain of [`Sub8`](crate::geometry::Sub8) where its pen and baseline are.
    pub(super) glyph: &'static OutlineGlyph,
    pub(super) scale: Scale,
    /// Whether contours cross, overlap or touch.
    pub(super) is_crossing: bool,
    /// Where the pen and the baseline are, in 1/256 pixel from the centre of pixel (0, 0).
    pub(super) origin: Corner,
}

/// A part of a contour: a straight line, or with a control point a curve.
#[derive(Debug, Copy, Clone)]
struct Piece {
    from: HalfUnits,
    control: Option<HalfUnits>,
    to: HalfUnits,
}

/// A contour along which points are walked.
#[derive(Debug, Copy, Clone)]
struct OpenContour {
    start: HalfUnits,
    at: HalfUnits,
    control: Option<HalfUnits>,
}

impl OpenContour {
    const fn beginning(start: HalfUnits) -> Self {
        Self {
            start,
            at: start,
            control: None,
        }
    }

    /// The piece to a point that lies on the contour.
    #[inline(always)]
    const fn piece_to(&mut self, to: HalfUnits) -> Piece {
        let piece = Piece {
            from: self.at,
            control: self.control,
            to,
        };
        (self.at, self.control) = (to, None);
        piece
    }

    /// Goes on to the next control point, and returns the piece that ends in the middle between the one before and this.
    #[inline(always)]
    fn control(&mut self, control: HalfUnits) -> Option<Piece> {
        // Both are even, being whole font units.
        let middle = self
            .control
            .map(|before| [0, 1].map(|axis: usize| middle(before, control, axis)));
        let piece = middle.map(|middle| self.piece_to(middle));
        self.control = Some(control);
        piece
    }
}

/// A coordinate of the middle between two points.
#[inline(always)]
fn middle([x, y]: HalfUnits, [other_x, other_y]: HalfUnits, axis: usize) -> i32 {
    if axis == 0 {
        (x + other_x) >> 1
    } else {
        (y + other_y) >> 1
    }
}

impl GlyphOutline<'_> {
    /// The method that is exact for the outline and takes least.
    pub(super) const fn method(&self) -> AnyCoverage {
        if self.is_crossing {
            AnyCoverage::InsideArea
        } else {
            AnyCoverage::SignedArea
        }
    }

    /// Calls with each piece of all contours, in their order.
    #[inline(always)]
    fn for_each_piece(&self, mut call: impl FnMut(Piece)) {
        let mut contour: Option<OpenContour> = None;
        let first = self.glyph.first as usize;
        for index in first..first.saturating_add(self.glyph.points.into()) {
            let Some(point) = self.font.point(index) else { break };
            let position = point.position;
            match &mut contour {
                None => contour = Some(OpenContour::beginning(position)),
                Some(open) if point.is_on_contour => call(open.piece_to(position)),
                Some(open) => {
                    if let Some(piece) = open.control(position) {
                        call(piece);
                    }
                }
            }
            if point.is_last {
                if let Some(mut open) = contour.take() {
                    call(open.piece_to(open.start));
                }
            }
        }
        if let Some(mut open) = contour {
            call(open.piece_to(open.start));
        }
    }

    /// A point in 1/256 pixel, moved into the glyph's bounds.
    #[inline(always)]
    fn corner(&self, [x, y]: HalfUnits) -> Corner {
        let OutlineGlyph {
            left,
            bottom,
            right,
            top,
            ..
        } = *self.glyph;
        let inside = |value: i32, least: i16, most: i16| value.min(2 * i32::from(most)).max(2 * i32::from(least));
        let length = |half_units: i32| self.scale.coordinate(half_units) as i32;
        let [origin_x, origin_y] = self.origin;
        [
            origin_x + length(inside(x, left, right)),
            origin_y - length(inside(y, bottom, top)),
        ]
    }

    /// Calls with the lines of a piece.
    #[inline(always)]
    fn flatten(&self, piece: &Piece, mut line: impl FnMut(Corner, Corner)) {
        let (from, to) = (self.corner(piece.from), self.corner(piece.to));
        match piece.control {
            Some(control) => parabola::flatten([from, self.corner(control), to], TOLERANCE, line),
            None => line(from, to),
        }
    }

    /// Blends what the outline covers of a window that has one row; nothing where the memory has too little room for the segments
    /// of the row. `units` are the row's [half units](Scale::half_units_in_row).
    #[inline(always)]
    pub(in crate::draw) fn blend_row<B: BlendTarget>(
        &self,
        target: &mut B,
        color: B::Color,
        memory: &mut RowMemory<'_>,
        units: &[i32; 2],
        window: &Window,
    ) -> Result<(), B::Error> {
        let (row, columns) = (window.top, window.left..window.right);
        let mut blender = target.blender(color);
        let mut blend = blender.row(row);
        if self.is_crossing {
            let count = self.segments_in_row(row, units, memory.segments_mut());
            memory.sort_segments(count);
            return memory.cover_columns(count, &InsideArea, FillRule::NonZero, columns, &mut blend);
        }
        // One strip, where the memory is not very small.
        let step = i32::try_from(memory.cells_mut().len().saturating_sub(1)).unwrap_or(i32::MAX);
        let mut start = columns.start;
        while start < columns.end && step > 0 {
            let strip = start..columns.end.min(start.saturating_add(step));
            let mut areas = UnorderedRow::new(row, &strip, memory.cells_mut());
            self.lines_in_row(row, units, |_, from, to| areas.add(from, to));
            areas.finish(&mut blend)?;
            start = strip.end;
        }
        Ok(())
    }

    /// Calls with each line of the outline that has a part in a row, and with its index, which grows along the outline.
    #[inline(always)]
    fn lines_in_row(&self, row: i32, &[first, last]: &[i32; 2], mut call: impl FnMut(u32, Corner, Corner)) {
        let (top, bottom) = (row * PIXEL - PIXEL / 2, row * PIXEL + PIXEL / 2);
        let mut number = 0;
        self.for_each_piece(|piece| {
            number += 1;
            let ([_, from], [_, to]) = (piece.from, piece.to);
            let [_, control] = piece.control.unwrap_or(piece.from);
            let (lowest, highest) = (from.min(to).min(control), from.max(to).max(control));
            if highest < first || last < lowest {
                return;
            }
            let mut index = number << LINE_BITS;
            self.flatten(&piece, |from, to| {
                index += 1;
                let (upper, lower) = (from[1].min(to[1]), from[1].max(to[1]));
                if upper < bottom && top < lower && upper < lower {
                    call(index, from, to);
                }
            });
        });
    }

    /// Makes the segments that a row of pixels has of the outline, as many as there is room for, and returns how many it has.
    #[inline(never)]
    fn segments_in_row(&self, row: i32, units: &[i32; 2], room: &mut [RowSegment]) -> usize {
        let mut count = 0;
        self.lines_in_row(row, units, |index, from, to| {
            let edge = AntialiasedEdge::from_units(from, to);
            if let (Some(edge), Some(room)) = (edge, room.get_mut(count)) {
                *room = edge.begin_at(index, row);
            }
            count += 1;
        });
        count
    }
}

impl SubOutline for GlyphOutline<'_> {
    fn edges(&self, edge: &mut dyn FnMut(Corner, Corner)) {
        self.for_each_piece(|piece| self.flatten(&piece, &mut *edge));
    }

    fn is_simple(&self) -> bool {
        !self.is_crossing
    }
}
