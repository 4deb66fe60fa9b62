//! Outlines of strokes of any width with any caps, joins and dashes.
//!
//! The outline consists of the convex contours whose union is the stroke, all counterclockwise on the screen: by the
//! nonzero rule it is one shape, without seams where contours meet. A rectangle with round caps is one contour:
//!
//! ```text
//!     .--+-----------------+--.       +--------+
//!    (   |                 |   )      |        |\          segments and a join, which reaches a
//!     '--+-----------------+--'       +--------+ \         little under both rectangles
//!                                      \     ' \  +
//! ```
//!
//! Guarantees: corners are those of [`StyledStroke`] rounded to 1/256 pixel; chords of round caps and joins are nowhere
//! further than 1/64 pixel from the circle. A stroke at whole pixels whose segments all run along rows and columns, with
//! neither round caps nor round joins nor bevelled corners, has the pixels of one that is not antialiased, if the lengths of
//! its dashes and their offset are multiples of half a pixel. Bevelled corners, and the ends of other dashes, are covered in
//! part; the sides of their strokes lie along pixels all the same.

use core::num::{NonZeroU32, NonZeroU64};

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{Line, Polyline},
};

use crate::{
    draw::{
        FillRule, LineCap, LineJoin, PrimitiveStyle, StrokeStyle, StrokedShape, SubOutline,
        antialiased::{
            layers::{Layer, LayerSink, OutlinedShape},
            sub_outline::{self, Corner, SHIFT},
            turn::{TURN_BITS, direction, edges_of_turn, round_products},
        },
    },
    geometry::{InputError, Sub8, SubPixel, TooSmall, Window, quotient_down, quotient_nearest},
    scan::stroke::{
        DashPattern,
        styled_stroke::{StrokeShape, StyledStroke},
        wide_stroke,
    },
};

/// Most dashes that an antialiased stroke has: more of them have no room in any memory.
const MOST_DASHES: u64 = 1 << 16;

/// The width of the strip that a join shares with the segments which it joins, in 1/65,536 pixel: more than corners are
/// rounded by, so that rounding opens no gap.
const OVERLAP: i64 = 2 << SHIFT;

/// A centre or a vector, in 1/65,536 pixel.
type Position = (i64, i64);

/// 1/256 pixel in a pixel.
const PIXEL: i32 = 1 << Sub8::FRACTION_BITS;

/// A function that takes the edges of an outline.
type EdgeSink<'s> = dyn FnMut(Corner, Corner) + 's;

/// What shapes a stroke, besides its path.
#[derive(Copy, Clone)]
pub(crate) struct StrokeForm<'a> {
    /// Width of the stroke in half pixels.
    pub(crate) width_in_halves: u64,
    pub(crate) cap: LineCap,
    pub(crate) join: LineJoin,
    pub(crate) dashes: Option<DashPattern<'a>>,
}

impl StrokeForm<'_> {
    /// The form of the strokes of a [`PrimitiveStyle`].
    pub(crate) fn solid(width_in_halves: u64) -> Self {
        Self {
            width_in_halves,
            cap: LineCap::WholePixel,
            join: LineJoin::MITER,
            dashes: None,
        }
    }
}

impl<'a, C: PixelColor> From<&StrokeStyle<'a, C>> for StrokeForm<'a> {
    fn from(style: &StrokeStyle<'a, C>) -> Self {
        Self {
            width_in_halves: u64::from(style.width) * 2,
            cap: style.cap,
            join: style.join,
            dashes: style.dash_pattern(),
        }
    }
}

/// The stroke of all paths of a shape.
pub(crate) struct StrokeOutline<'a> {
    shape: &'a dyn StrokedShape,
    form: StrokeForm<'a>,
    /// Whether corners at the centres of pixels are moved by half a pixel to the left and upwards, where the sides of
    /// pixels are: strokes of an even width along rows and columns then cover whole pixels.
    is_on_pixels: bool,
    /// A distance that all corners are moved by besides, in 1/256 pixel.
    shift: Corner,
    is_simple: bool,
}

impl<'a> StrokeOutline<'a> {
    /// # Errors
    /// [`InputError::TooSmall`] where there are so many dashes that no memory has room for them, [`InputError::OutOfDomain`] where a
    /// vertex is so far out that nothing is generated around it.
    pub(crate) fn new(shape: &'a dyn StrokedShape, form: StrokeForm<'a>) -> Result<Self, InputError> {
        let mut outline = Self {
            shape,
            form,
            is_on_pixels: false,
            shift: Corner::default(),
            is_simple: false,
        };
        let form = &mut outline.form;
        if shape.is_sub_pixel() && form.cap == LineCap::WholePixel {
            form.cap = LineCap::Butt;
        }
        let is_angular = form.cap != LineCap::Round && form.join != LineJoin::Round;
        let mut is_along_pixels = is_angular && !shape.is_sub_pixel();
        // An odd width has sides along pixels already. There, only ends and some coordinates of bevels would be moved.
        let is_even = form.width_in_halves.is_multiple_of(4);
        // Of other dashes only the ends at the centres of pixels would be moved, and make them longer.
        let (mut has_dashes_in_halves, mut axes) = (true, [false; 2]);
        let (mut paths, mut are_rectangles, mut dashes, mut is_near) = (0u32, true, 0u64, true);
        outline.strokes(&mut |stroke| {
            is_along_pixels = is_along_pixels && stroke.is_along_pixels() && (is_even || !stroke.bevels_along_pixels());
            if is_along_pixels {
                has_dashes_in_halves &= stroke.has_dashes_in_halves();
                let [is_upright, is_level] = stroke.axes_along_pixels();
                axes = [axes[0] | is_upright, axes[1] | is_level];
            }
            are_rectangles &= stroke.is_one_rectangle();
            dashes = dashes.saturating_add(stroke.most_dashes_along());
            paths = paths.saturating_add(1);
            is_near &= stroke.is_near();
        });
        if !is_near {
            return Err(InputError::out_of_domain::<Sub8>());
        }
        if dashes > MOST_DASHES {
            let edges = usize::try_from(dashes.saturating_mul(4)).unwrap_or(usize::MAX);
            return Err(TooSmall::Edges(edges).into());
        }
        outline.is_on_pixels = is_along_pixels && has_dashes_in_halves;
        if is_along_pixels && !has_dashes_in_halves && is_even {
            outline.shift = axes.map(|has_sides| if has_sides { -PIXEL / 2 } else { 0 });
        }
        outline.is_simple = paths == 1 && are_rectangles;
        Ok(outline)
    }

    /// Calls `call` with the stroke of each path.
    fn strokes(&self, call: &mut dyn FnMut(&StyledStroke<'_>)) {
        let StrokeForm {
            width_in_halves,
            cap,
            join,
            dashes,
        } = self.form;
        self.shape.paths(width_in_halves, &mut |path| {
            call(&StyledStroke::new(path, cap, join, dashes));
        });
    }

    /// A position rounded to 1/256 pixel.
    fn rounded(&self, (x, y): Position) -> Corner {
        // Within the limits of strokes, which fit 32 bits.
        self.on_pixels([x, y].map(|coordinate| sub_outline::rounded(coordinate) as i32))
    }

    /// A corner, moved to the sides of pixels from where the stroke's corners are moved there.
    #[inline(always)]
    pub(crate) fn on_pixels(&self, [x, y]: Corner) -> Corner {
        let moved = |units: i32, shift: i32| {
            let is_centre = units & (PIXEL - 1) == 0;
            if self.is_on_pixels && is_centre {
                units.saturating_sub(PIXEL / 2)
            } else {
                units.saturating_add(shift)
            }
        };
        [moved(x, self.shift[0]), moved(y, self.shift[1])]
    }

    /// Hands over the contour of a convex polygon, unless rounding leaves nothing of it or turns it over.
    fn polygon(&self, corners: &[Position], edge: &mut EdgeSink<'_>) {
        let rounded = || corners.iter().map(|&corner| self.rounded(corner));
        let Some([x, y]) = rounded().next() else { return };
        let from_first = |[to_x, to_y]: Corner| [i64::from(to_x - x), i64::from(to_y - y)];
        let pairs = rounded().zip(rounded().skip(1));
        let doubled_area: i64 = pairs
            .map(|(one, other)| {
                let ([ax, ay], [bx, by]) = (from_first(one), from_first(other));
                ax * by - ay * bx
            })
            .sum();
        if doubled_area < 0 {
            sub_outline::close(rounded(), edge);
        }
    }

    /// Hands over the rectangle along a part of a segment, with its round caps.
    fn part(&self, corners: &[[i32; 2]; 4], discs: [Option<Position>; 2], half_width: i64, edge: &mut EdgeSink<'_>) {
        let [first, second, third, fourth] = corners.map(|[x, y]| (i64::from(x), i64::from(y)));
        let (right, down) = (second.0 - first.0, second.1 - first.1);
        let is_short = right * right + down * down < half_width * half_width;
        match discs {
            [None, None] => self.polygon(&[first, second, third, fourth], edge),
            // A dot.
            [Some(center), None] if first == second => self.disc(center, half_width, edge),
            // The disc reaches further back than the rectangle.
            [Some(center), None] | [None, Some(center)] if is_short => {
                self.polygon(&[first, second, third, fourth], edge);
                self.disc(center, half_width, edge);
            }
            [from, to] => {
                let half_disc = |center: Option<Position>, begin: Position| {
                    center
                        .into_iter()
                        .flat_map(move |center| half_disc(center, begin, half_width))
                };
                let corners = [first, second]
                    .into_iter()
                    .chain(half_disc(to, second))
                    .chain([third, fourth])
                    .chain(half_disc(from, fourth));
                sub_outline::close(corners.map(|corner| self.rounded(corner)), edge);
            }
        }
    }

    /// Hands over the disc of a round join.
    fn disc(&self, center: Position, half_width: i64, edge: &mut EdgeSink<'_>) {
        let begin = (center.0, center.1 + half_width);
        let end = (center.0, center.1 - half_width);
        let halves = [begin]
            .into_iter()
            .chain(half_disc(center, begin, half_width))
            .chain([end])
            .chain(half_disc(center, end, half_width));
        sub_outline::close(halves.map(|corner| self.rounded(corner)), edge);
    }

    /// Hands over what a join adds, and a little of the segments below it: where three rounded corners should lie on one
    /// line, no gap is left between them.
    fn join(&self, corners: &[wide_stroke::Corner], edge: &mut EdgeSink<'_>) {
        let mut room = [Position::default(); 4];
        for (position, &(x, y)) in room.iter_mut().zip(corners) {
            *position = (i64::from(x), i64::from(y));
        }
        let corners = room.get_mut(..corners.len()).unwrap_or_default();
        // Along pixels, rounding moves no corner off a line.
        if let (false, [center, one, .., other]) = (self.is_on_pixels, &mut *corners) {
            let outwards = (one.0 + other.0 - 2 * center.0, one.1 + other.1 - 2 * center.1);
            let size = NonZeroU64::new(outwards.0.unsigned_abs().max(outwards.1.unsigned_abs()));
            if let Some(size) = size {
                center.0 -= quotient_nearest(outwards.0 * OVERLAP, size);
                center.1 -= quotient_nearest(outwards.1 * OVERLAP, size);
            }
        }
        self.polygon(corners, edge);
    }
}

/// The corners of half a disc that is left counterclockwise at `begin`, without both ends.
fn half_disc(center: Position, begin: Position, radius: i64) -> impl Iterator<Item = Position> {
    let across = (begin.0 - center.0, begin.1 - center.1);
    // A quarter turn on.
    let along = (across.1, -across.0);
    // The radius is below 2^27; rounded up to 1/256 pixel.
    let chords = edges_of_turn((radius >> SHIFT) as u32 + 1).get() >> 1;
    let chords = NonZeroU32::new(chords).unwrap_or(NonZeroU32::MIN);
    (1..chords.get()).map(move |index| {
        let angle = quotient_down(u64::from(index) << (TURN_BITS - 1), chords);
        let [cosine, sine] = direction(angle as i32).map(i64::from);
        let turned = |across: i64, along: i64| round_products(across * cosine + along * sine);
        (
            center.0 + turned(across.0, along.0),
            center.1 + turned(across.1, along.1),
        )
    })
}

impl SubOutline for StrokeOutline<'_> {
    fn edges(&self, edge: &mut EdgeSink<'_>) {
        let wide = |(x, y): wide_stroke::Corner| (i64::from(x), i64::from(y));
        self.strokes(&mut |stroke| {
            let half_width = stroke.half_width();
            stroke.all_shapes(&mut |shape| match shape {
                StrokeShape::Polygon(&[first, second, third, fourth], discs) => {
                    let corners = [first, second, third, fourth].map(|(x, y)| [x, y]);
                    self.part(&corners, discs.map(|disc| disc.map(wide)), half_width, edge);
                }
                StrokeShape::Polygon(_, discs) => {
                    for center in discs.into_iter().flatten() {
                        self.disc(wide(center), half_width, edge);
                    }
                }
                StrokeShape::Join(corners) => self.join(corners, edge),
                // All dashes are handed over one by one.
                StrokeShape::Dashes(_) => {}
            });
        });
    }

    fn is_simple(&self) -> bool {
        self.is_simple
    }
}

/// Hands over the stroke of a shape in a form, if it has a colour and a width.
pub(crate) fn stroke_layer<C: PixelColor>(
    shape: &dyn StrokedShape,
    form: StrokeForm<'_>,
    color: Option<C>,
    layer: &mut LayerSink<'_, C>,
) -> Result<(), InputError> {
    let Some(color) = color.filter(|_| form.width_in_halves > 0) else {
        return Ok(());
    };
    let outline = StrokeOutline::new(shape, form)?;
    layer(&Layer::new(&outline, color))
}

/// Hands over the fill of a shape by a rule, and the centred stroke over it.
pub(crate) fn fill_and_stroke<C: PixelColor, S: SubOutline + StrokedShape>(
    shape: &S,
    fill_rule: FillRule,
    style: &PrimitiveStyle<C>,
    layer: &mut LayerSink<'_, C>,
) -> Result<(), InputError> {
    if let Some(color) = style.fill_color {
        layer(&Layer {
            outline: shape,
            fill_rule,
            color,
        })?;
    }
    let form = StrokeForm::solid(u64::from(style.stroke_width) * 2);
    stroke_layer(shape, form, style.stroke_color, layer)
}

/// A corner of an outline as a position of a path.
pub(crate) fn position([x, y]: Corner) -> Position {
    (i64::from(x) << SHIFT, i64::from(y) << SHIFT)
}

/// The stroke of a line or a polyline is centred, and there is no fill.
macro_rules! stroke_alone {
    ($($shape:ty, $vertices:expr);+) => {$(
        impl OutlinedShape for $shape {
            fn layers<C: PixelColor>(
                &self,
                style: &PrimitiveStyle<C>,
                layer: &mut LayerSink<'_, C>,
            ) -> Result<(), InputError> {
                let form = StrokeForm::solid(u64::from(style.stroke_width) * 2);
                stroke_layer(self, form, style.stroke_color, layer)
            }

            fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
                let rows = $vertices(self).fold(None, |rows: Option<(i32, i32)>, y| {
                    let (top, bottom) = rows.unwrap_or((y, y));
                    Some((top.min(y), bottom.max(y)))
                });
                let reach = stroke_width.saturating_mul(2).saturating_add(2);
                rows.is_some_and(|(top, bottom)| window.may_meet_rows(top, top.abs_diff(bottom), reach))
            }
        }
    )+};
}
stroke_alone!(
    Line, |line: &Self| [line.start.y, line.end.y].into_iter();
    Polyline<'_>, |polyline: &Self| {
        let down = polyline.translate.y;
        polyline.vertices.iter().map(move |vertex| vertex.y.saturating_add(down))
    }
);

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::Point,
        mock_display::MockDisplay,
        pixelcolor::{Gray4, GrayColor},
    };
    use fixed::types::U16F16;

    use super::*;
    use crate::draw::pictures::antialiased;

    /// A shape and the form of its stroke.
    struct Formed<'a, S>(S, StrokeForm<'a>);

    impl<S: StrokedShape> OutlinedShape for Formed<'_, S> {
        fn layers<C: PixelColor>(
            &self,
            style: &PrimitiveStyle<C>,
            layer: &mut LayerSink<'_, C>,
        ) -> Result<(), InputError> {
            stroke_layer(&self.0, self.1, style.stroke_color, layer)
        }
    }

    fn drawn(shape: impl StrokedShape, width: u32, cap: LineCap, join: LineJoin) -> MockDisplay<Gray4> {
        let form = StrokeForm {
            cap,
            join,
            ..StrokeForm::solid(u64::from(width) * 2)
        };
        antialiased(&Formed(shape, form), PrimitiveStyle::with_stroke(Gray4::WHITE, width))
    }

    #[test]
    fn a_slanted_line_of_one_pixel() {
        let line = Line::new(Point::new(1, 1), Point::new(13, 5));
        antialiased(&line, PrimitiveStyle::with_stroke(Gray4::WHITE, 1)).assert_pattern(&[
            "              ",
            " EA51         ",
            " 15AEA51      ",
            "    15AEA51   ",
            "       15AEA51",
            "          15AE",
        ]);
    }

    /// A line 2 pixels wide covers the row of its end points and the row above, as it does without antialiasing.
    #[test]
    fn a_level_line_of_2_pixels_has_whole_pixels() {
        let line = Line::new(Point::new(2, 3), Point::new(9, 3));
        antialiased(&line, PrimitiveStyle::with_stroke(Gray4::WHITE, 2)).assert_pattern(&[
            "          ",
            "          ",
            "  FFFFFFFF",
            "  FFFFFFFF",
        ]);
    }

    #[test]
    fn round_caps() {
        let line = Line::new(Point::new(4, 4), Point::new(11, 7));
        drawn(line, 5, LineCap::Round, LineJoin::MITER).assert_pattern(&[
            "              ",
            "              ",
            "  2BFC5       ",
            "  BFFFFE81    ",
            "  FFFFFFFFA3  ",
            "  BFFFFFFFFFC2",
            "  2CFFFFFFFFFB",
            "    3AFFFFFFFF",
            "      18EFFFFB",
            "         5CFB2",
        ]);
    }

    #[test]
    fn joins_leave_no_seam() {
        let vertices = [Point::new(2, 12), Point::new(7, 3), Point::new(12, 11)];
        let assert_tip = |join, tip: [&str; 4]| {
            let below_tip = [
                "    5FFFFF7    ",
                "    DFFFFFE2   ",
                "   7FFFFFFFB   ",
                "  1EFFFCFFFF5  ",
                "  9FFFE1BFFFE1 ",
                " 2FFFF7 2EFFF9 ",
                " AFFFD   7FFFD1",
                "1DFFF5    DF8  ",
                " 17EC     32   ",
                "   22          ",
            ];
            drawn(Polyline::new(&vertices), 4, LineCap::Butt, join).assert_pattern(&[&tip[..], &below_tip].concat());
        };
        assert_tip(
            LineJoin::MITER,
            [
                "      2D1      ",
                "      AF9      ",
                "     4FFF4     ",
                "     CFFFD     ",
            ],
        );
        assert_tip(
            LineJoin::Bevel,
            [
                "               ",
                "               ",
                "     37883     ",
                "     CFFFD     ",
            ],
        );
        assert_tip(
            LineJoin::Round,
            [
                "               ",
                "      373      ",
                "     3FFF3     ",
                "     CFFFD     ",
            ],
        );
    }

    #[test]
    fn dashes_with_round_caps() {
        let lengths = [U16F16::lit("3"), U16F16::lit("4")];
        let form = StrokeForm {
            cap: LineCap::Round,
            dashes: Some(DashPattern::new(&lengths)),
            ..StrokeForm::solid(6)
        };
        let line = Formed(Line::new(Point::new(2, 2), Point::new(13, 10)), form);
        antialiased(&line, PrimitiveStyle::with_stroke(Gray4::WHITE, 3)).assert_pattern(&[
            "             ",
            " 8E91        ",
            " EFFD3       ",
            " 8FFFF3      ",
            "  5EFF6      ",
            "   2A91AC4   ",
            "      4FFF8  ",
            "      1DFFFB ",
            "       1BFFF1",
            "         7D8 ",
        ]);
    }
}
