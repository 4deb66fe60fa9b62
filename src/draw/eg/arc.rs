//! embedded-graphics' `Arc` and `Sector`, at any diameter, position and angle.
//!
//! Each visible row of the ring (of the disc, for a sector) is walked like that of a circle, and cut to the columns
//! that lie in the half planes beside the two angles: in both of them for an angle below half a turn, in either of them
//! from half a turn on. A whole turn is not cut.
//!
//! The stroke of a sector also runs along its two straight sides: each side has a half plane for the outer border of
//! its stroke and one for the inner border. A further half plane (the bevel) cuts off the outer tip of the corner where
//! the sides meet, if the angle is small, or fills the inner corner, if the angle is nearly a turn.
//!
//! Guarantees: embedded-graphics' pixels wherever its numbers do not overflow, with micromath's sine and cosine. Each
//! pixel is drawn once.

use embedded_graphics::{
    geometry::{Angle, Dimensions},
    pixelcolor::PixelColor,
    primitives::{Arc, Rectangle, Sector, StyledDimensions},
};

use crate::{
    draw::{
        PrimitiveStyle, StyledShape, drawable_through_generic,
        eg::{areas::may_meet, circle},
    },
    geometry::{WideRectangle, Window},
    scan::{
        polygon::{Part, shrunk_box::shrunk_by_rows},
        round::{
            SymmetricRows,
            plane_sector::{Center, Columns, HalfPlane, NORMAL_LENGTH, PlaneSector, runs},
        },
    },
    surface::{Span, SymmetricBox, Target},
};

/// The boxes of a ring's two circles: the outer one, and the concentric inner one, which is the ring's hole.
struct ArcRing {
    outer: WideRectangle,
    inner: WideRectangle,
}

/// A row of a ring: the columns from `start` to before `end`, without those of `hole`.
struct RingRow {
    y: i32,
    start: i32,
    hole: Columns,
    end: i32,
}

impl ArcRing {
    fn new<C: PixelColor>(bounding_box: Rectangle, style: &PrimitiveStyle<C>) -> Self {
        let bounding_box = WideRectangle::from(bounding_box);
        Self {
            outer: bounding_box.outset(style.outside_stroke_width()),
            inner: bounding_box.inset(style.inside_stroke_width()),
        }
    }

    /// The ring with columns and rows exchanged.
    const fn transposed(&self) -> Self {
        Self {
            outer: self.outer.transposed(),
            inner: self.inner.transposed(),
        }
    }

    /// The radii of the outer and the inner circle, in half pixels.
    const fn radii(&self) -> [u32; 2] {
        [self.outer.size.width, self.inner.size.width]
    }

    /// Calls `call` with each visible row, from the outside to the middle: each row of the upper half together with its
    /// mirrored row.
    fn for_each_row<E>(&self, window: &Window, mut call: impl FnMut(&RingRow) -> Result<(), E>) -> Result<(), E> {
        let Some(shape) = SymmetricBox::new(self.outer, window) else {
            return Ok(());
        };
        let mut rows = SymmetricRows::new(self.outer, self.inner, circle::CURVE, &shape);
        shape.for_each_batch(&mut rows, |first_row, batch| {
            for (row, &span) in (first_row..).zip(batch) {
                let [start, hole_start, hole_end, end] = shape.bounds(span);
                let hole = Columns {
                    start: hole_start,
                    end: hole_end,
                };
                for y in shape.lines(row).into_iter().flatten() {
                    call(&RingRow { y, start, hole, end })?;
                }
            }
            Ok(())
        })
    }
}

impl RingRow {
    /// The columns of the row, the hole included.
    fn columns(&self) -> Columns {
        Columns {
            start: self.start,
            end: self.end,
        }
    }

    /// The columns before the hole and those after it. In a row without a hole, all columns are before it.
    fn sides(&self) -> [Columns; 2] {
        [
            Columns {
                start: self.start,
                end: self.hole.start,
            },
            Columns {
                start: self.hole.end.max(self.hole.start),
                end: self.end,
            },
        ]
    }
}

/// Fills columns of a row, which are visible or empty.
fn fill_columns<T: Target>(target: &mut T, y: i32, columns: Columns, raw: T::Raw) -> Result<(), T::Error> {
    if columns.is_empty() {
        return Ok(());
    }
    target.fill_clipped_span(Span::new(y, columns.start, columns.end), raw)
}

/// The stroke of an arc: the part of a ring that lies between two half planes.
struct StyledArc {
    ring: ArcRing,
    center: Center,
    sector: PlaneSector,
    half_planes: [HalfPlane; 2],
}

impl StyledArc {
    fn new<C: PixelColor>(arc: &Arc, style: &PrimitiveStyle<C>) -> Self {
        let bounding_box = arc.bounding_box();
        let sector = PlaneSector::new(arc.angle_start, arc.angle_sweep);
        Self {
            ring: ArcRing::new(bounding_box, style),
            center: Center::of(&bounding_box),
            half_planes: sector.half_planes(0),
            sector,
        }
    }

    fn transposed(&self) -> Self {
        Self {
            ring: self.ring.transposed(),
            center: self.center.transposed(),
            half_planes: self.half_planes.map(HalfPlane::transposed),
            sector: self.sector,
        }
    }

    /// Calls `call` with the visible runs of columns of each row; some may be empty.
    fn for_each_run<E>(&self, window: &Window, mut call: impl FnMut(i32, Columns) -> Result<(), E>) -> Result<(), E> {
        let Self {
            center,
            sector,
            half_planes,
            ..
        } = *self;
        self.ring.for_each_row(window, |row| {
            let visible = row.columns();
            let columns = half_planes.map(|half_plane| half_plane.columns(center, row.y, visible));
            for run in sector.row_runs(columns, visible) {
                if run.is_empty() {
                    continue;
                }
                for side in row.sides() {
                    call(row.y, run.intersection(side))?;
                }
            }
            Ok(())
        })
    }

    /// Whether the arc has a pixel in a window.
    fn has_pixel(&self, window: &Window) -> bool {
        let stop_at_pixel = |_, columns: Columns| if columns.is_empty() { Ok(()) } else { Err(()) };
        self.for_each_run(window, stop_at_pixel).is_err()
    }

    /// The smallest box around the pixels of the arc.
    fn smallest_box(&self) -> Rectangle {
        let bounds = self
            .sector
            .bounds(self.center, self.ring.radii(), self.half_planes, None);
        let window = bounds.to_rectangle().into();
        shrunk_by_rows(window, self, &self.transposed(), Self::has_pixel).to_rectangle()
    }
}

impl StyledShape for Arc {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let Some(color) = style.effective_stroke_color() else {
            return Ok(());
        };
        if !may_meet(&self.bounding_box(), style, &target.window()) {
            return Ok(());
        }
        draw_arc(self, style, target.raw(color), target)
    }
}

/// Draws the stroke of an arc that may be visible. Not inlined, so that a caller whose arc is not visible need not save
/// its registers.
#[inline(never)]
fn draw_arc<T: Target>(
    arc: &Arc,
    style: &PrimitiveStyle<T::Color>,
    raw: T::Raw,
    target: &mut T,
) -> Result<(), T::Error> {
    StyledArc::new(arc, style).for_each_run(&target.window(), |y, columns| fill_columns(target, y, columns, raw))
}

/// The bevel of a sector's stroke at the corner where both sides meet.
#[derive(Copy, Clone, PartialEq, Eq)]
enum Bevel {
    /// The corner points outwards, and its tip is not drawn.
    Outside,
    /// The corner points inwards, and is filled.
    Inside,
}

/// The bevel of a sector and the half plane that it applies to; `None` where the corner is not sharp. `outside_width`
/// is the width of the stroke's outer part in pixels.
fn bevel(sector: &Sector, outside_width: i64) -> Option<(Bevel, HalfPlane)> {
    let sweep = sector.angle_sweep.abs();
    let half = sector.angle_start + Angle::from_radians(sector.angle_sweep.to_radians() / 2.0);
    let quarter = Angle::from_radians(core::f32::consts::FRAC_PI_2);
    // The bevel is twice the outside width from the centre, which is four half pixels for each pixel of that width.
    let beyond = -4 * outside_width * i64::from(NORMAL_LENGTH);
    if sweep < Angle::from_degrees(55.0) {
        Some((Bevel::Outside, HalfPlane::left_of(half - quarter, beyond)))
    } else if sweep > Angle::from_degrees(305.0) && sweep < Angle::from_degrees(360.0) {
        Some((Bevel::Inside, HalfPlane::left_of(half + quarter, beyond)))
    } else {
        None
    }
}

/// A sector with its stroke. The shape is the part of a disc between the half planes `whole`; its fill is the part of
/// the ring's hole between the half planes `inner`. The bevel changes both at the corner.
struct StyledSector {
    ring: ArcRing,
    center: Center,
    sector: PlaneSector,
    /// The half planes between the outer borders of the sides' strokes.
    whole: [HalfPlane; 2],
    /// The half planes between the inner borders of the sides' strokes.
    inner: [HalfPlane; 2],
    bevel: Option<(Bevel, HalfPlane)>,
}

impl StyledSector {
    fn new<C: PixelColor>(shape: &Sector, style: &PrimitiveStyle<C>) -> Self {
        let bounding_box = shape.bounding_box();
        let sector = PlaneSector::new(shape.angle_start, shape.angle_sweep);
        // The outer border is half a pixel further from a side than the outside width, the inner border half a pixel
        // nearer than the inside width.
        let half_pixels = |width: u32, more: i64| (2 * i64::from(width) + more) * i64::from(NORMAL_LENGTH);
        Self {
            ring: ArcRing::new(bounding_box, style),
            center: Center::of(&bounding_box),
            whole: sector.half_planes(half_pixels(style.outside_stroke_width(), 1)),
            inner: sector.half_planes(-half_pixels(style.inside_stroke_width(), -1)),
            bevel: bevel(shape, i64::from(style.outside_stroke_width())),
            sector,
        }
    }

    fn transposed(&self) -> Self {
        Self {
            ring: self.ring.transposed(),
            center: self.center.transposed(),
            sector: self.sector,
            whole: self.whole.map(HalfPlane::transposed),
            inner: self.inner.map(HalfPlane::transposed),
            bevel: self.bevel.map(|(kind, half_plane)| (kind, half_plane.transposed())),
        }
    }

    /// Calls `call` with the visible runs of the fill of a sector whose stroke has no colour; some may be empty. The
    /// sector must not have a bevel that fills its corner ([`Bevel::Inside`]).
    fn for_each_fill_run<E>(
        &self,
        window: &Window,
        mut call: impl FnMut(i32, Columns) -> Result<(), E>,
    ) -> Result<(), E> {
        let is_one = self.whole == self.inner;
        self.ring.for_each_row(window, |row| {
            let visible = row.hole;
            if visible.is_empty() {
                return Ok(());
            }
            let runs = |half_planes: [HalfPlane; 2]| {
                let columns = half_planes.map(|half_plane| half_plane.columns(self.center, row.y, visible));
                self.sector.row_runs(columns, visible)
            };
            for run in runs(self.whole) {
                if is_one {
                    call(row.y, run)?;
                    continue;
                }
                for inner_run in runs(self.inner) {
                    call(row.y, run.intersection(inner_run))?;
                }
            }
            Ok(())
        })
    }

    /// Calls `call` with the visible runs of columns of each row, left to right, each with whether it belongs to the
    /// fill or the stroke.
    fn for_each_run<E>(
        &self,
        window: &Window,
        mut call: impl FnMut(i32, Columns, Part) -> Result<(), E>,
    ) -> Result<(), E> {
        self.ring.for_each_row(window, |row| {
            let visible = row.columns();
            let columns = |half_plane: HalfPlane| half_plane.columns(self.center, row.y, visible);
            let (whole, inner) = (self.whole.map(columns), self.inner.map(columns));
            let cut = self.bevel.map(|(kind, half_plane)| (kind, columns(half_plane)));
            let cut_columns = cut.map_or(visible, |(_, columns)| columns);
            let mut borders = [
                row.start,
                row.hole.start,
                row.hole.end,
                cut_columns.start,
                cut_columns.end,
                whole[0].start,
                whole[0].end,
                whole[1].start,
                whole[1].end,
                inner[0].start,
                inner[0].end,
                inner[1].start,
                inner[1].end,
            ];
            let part = |x: i32| {
                if !self.sector.contains(&whole, x) {
                    return None;
                }
                let is_inside = self.sector.contains(&inner, x)
                    || match cut {
                        Some((kind, columns)) if columns.contains(x) => match kind {
                            Bevel::Outside => return None,
                            Bevel::Inside => true,
                        },
                        _ => false,
                    };
                Some(if is_inside && row.hole.contains(x) {
                    Part::Fill
                } else {
                    Part::Stroke
                })
            };
            runs(visible, &mut borders, part, |columns, part| call(row.y, columns, part))
        })
    }

    /// Whether the sector has a pixel in a window.
    fn has_pixel(&self, window: &Window) -> bool {
        let stop_at_pixel = |_, columns: Columns, _| if columns.is_empty() { Ok(()) } else { Err(()) };
        self.for_each_run(window, stop_at_pixel).is_err()
    }

    /// The smallest box around the pixels of the sector and its stroke.
    fn smallest_box(&self) -> Rectangle {
        let [radius, _] = self.ring.radii();
        let between = |half_planes, another| self.sector.bounds(self.center, [radius, 0], half_planes, another);
        let bounds = match self.bevel {
            // An outside bevel cuts off nothing between the inner borders, so that these bound the fill without it.
            Some((Bevel::Outside, half_plane)) => {
                between(self.whole, Some(half_plane.opposite())).around(&between(self.inner, None))
            }
            _ => between(self.whole, None),
        };
        let window = bounds.to_rectangle().into();
        shrunk_by_rows(window, self, &self.transposed(), Self::has_pixel).to_rectangle()
    }
}

impl StyledShape for Sector {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        if style.is_transparent() || !may_meet(&self.bounding_box(), style, &target.window()) {
            return Ok(());
        }
        draw_sector(self, style, target)
    }
}

/// Draws a sector that may be visible. Not inlined, so that a caller whose sector is not visible need not save its
/// registers.
#[inline(never)]
fn draw_sector<T: Target>(shape: &Sector, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
    let stroke = style.stroke_color.map(|color| target.raw(color));
    let fill = style.fill_color.map(|color| target.raw(color));
    let sector = StyledSector::new(shape, style);
    // An outside bevel affects the stroke only.
    let fills_bevel = matches!(sector.bevel, Some((Bevel::Inside, _)));
    let window = target.window();
    if let (None, Some(raw), false) = (stroke, fill, fills_bevel) {
        return sector.for_each_fill_run(&window, |y, columns| fill_columns(target, y, columns, raw));
    }
    sector.for_each_run(&window, |y, columns, part| {
        let raw = match part {
            Part::Fill => fill,
            Part::Stroke => stroke,
        };
        match raw {
            Some(raw) => fill_columns(target, y, columns, raw),
            None => Ok(()),
        }
    })
}

drawable_through_generic!(Arc, Sector);

/// The smallest box around the pixels of the stroke, with or without a colour; the box of the whole circle where the
/// stroke has no width.
///
/// Cost: that of a few rows, however large the arc is (13,500 instructions on a Cortex-M4, half of drawing 101 pixels).
impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Arc {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        if style.stroke_width == 0 {
            return self.bounding_box();
        }
        StyledArc::new(self, style).smallest_box()
    }
}

/// The smallest box around the pixels of fill and stroke, whichever of them have a colour.
///
/// Cost: that of a few rows, however large the sector is (21,600 instructions on a Cortex-M4).
impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Sector {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        StyledSector::new(self, style).smallest_box()
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::{AngleUnit, Point},
        primitives::StrokeAlignment,
    };

    use super::*;
    use crate::draw::pictures::{FILL, drawn_by_both, green_in_red, stroke};

    #[test]
    fn an_arc_over_a_quarter_is_above_to_the_right() {
        let arc = Arc::new(Point::zero(), 13, 0.0.deg(), -90.0.deg());
        drawn_by_both(&arc, stroke(1)).assert_pattern(&[
            "      ###    ",
            "         ##  ",
            "          ## ",
            "           # ",
            "            #",
            "            #",
            "            #",
        ]);
    }

    #[test]
    fn an_arc_3_pixels_wide_with_a_gap_below() {
        let arc = Arc::new(Point::new(1, 1), 13, 135.0.deg(), 270.0.deg());
        drawn_by_both(&arc, stroke(3)).assert_pattern(&[
            "     #####     ",
            "   #########   ",
            "  ###########  ",
            " ####     #### ",
            " ###       ### ",
            "###         ###",
            "###         ###",
            "###         ###",
            "###         ###",
            "###         ###",
            " ###       ### ",
            " ###       ### ",
            "  #         #  ",
        ]);
    }

    #[test]
    fn an_arc_cut_by_the_upper_left_corner() {
        let arc = Arc::new(Point::new(-7, -7), 15, -30.0.deg(), 150.0.deg());
        drawn_by_both(&arc, stroke(2)).assert_pattern(&[
            "       ##",
            "       ##",
            "       ##",
            "      ## ",
            "      ## ",
            "     ##  ",
            "   ####  ",
            "#####    ",
            "###      ",
        ]);
    }

    #[test]
    fn a_sector_over_a_third() {
        let sector = Sector::new(Point::zero(), 15, 0.0.deg(), -120.0.deg());
        drawn_by_both(&sector, FILL).assert_pattern(&[
            "     #####     ",
            "   #########   ",
            "    #########  ",
            "     ######### ",
            "     ######### ",
            "      #########",
            "      #########",
            "       ########",
        ]);
    }

    #[test]
    fn a_disc_without_a_quarter_in_a_red_stroke() {
        let sector = Sector::new(Point::new(0, 0), 13, 45.0.deg(), 270.0.deg());
        let display = drawn_by_both(&sector, green_in_red(2, StrokeAlignment::Inside));
        display.assert_pattern(&[
            "    RRRRR  ",
            "  RRRRRRRRR",
            " RRRGGGGRRR",
            " RRGGGGRRR ",
            "RRGGGGRRR  ",
            "RRGGGRRR   ",
            "RRGGRRR    ",
            "RRGGGRRR   ",
            "RRGGGGRRR  ",
            " RRGGGGRRR ",
            " RRRGGGGRRR",
            "  RRRRRRRRR",
            "    RRRRR  ",
        ]);
    }

    /// Below 55 degrees, the outside stroke would have a long tip where both sides meet.
    #[test]
    fn the_outer_corner_of_a_narrow_sector_is_cut_off() {
        let sector = Sector::new(Point::new(-4, -3), 17, -20.0.deg(), 40.0.deg());
        let display = drawn_by_both(&sector, green_in_red(2, StrokeAlignment::Outside));
        display.assert_pattern(&[
            "           RRR ",
            "        RRRRRR ",
            "     RRRRRRGRRR",
            "   RRRRRRGGGGRR",
            " RRRRRGGGGGGGRR",
            " RRGGGGGGGGGGRR",
            " RRRRRGGGGGGGRR",
            "   RRRRRRGGGGRR",
            "     RRRRRRGRRR",
            "        RRRRRR ",
            "           RRR ",
        ]);
    }
}
