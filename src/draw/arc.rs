//! embedded-graphics' `Arc` and `Sector`, at any diameter, position and angle.

use embedded_graphics::{
    geometry::{Angle, Dimensions},
    pixelcolor::PixelColor,
    primitives::{Arc, Rectangle, Sector, StyledDimensions},
};

use crate::{
    draw::{PrimitiveStyle, StyledShape, areas::styled_box, circle, drawable_through_generic},
    geometry::Outline,
    scan::{
        MirroredRows, Part,
        plane_sector::{Center, Columns, HalfPlane, NORMAL_LENGTH, PlaneSector, runs},
    },
    target::{Clipped, MirroredBox, Span, Target},
};

/// The visible rows of a circle and a smaller one in its middle.
struct Ring {
    outer: Outline,
    inner: Outline,
}

/// A row of a ring: where it begins, where its hole begins and ends, and where it ends.
struct RingRow {
    y: i32,
    start: i32,
    hole: Columns,
    end: i32,
}

impl Ring {
    fn new<C: PixelColor>(outline: Rectangle, style: &PrimitiveStyle<C>) -> Self {
        let outline = Outline::from(outline);
        Self {
            outer: outline.outset(style.outside_stroke_width()),
            inner: outline.inset(style.inside_stroke_width()),
        }
    }

    /// Hands over each visible row; the lower half comes along with the upper one, from the outside to the middle.
    fn for_each_row<T: Target>(
        &self,
        target: &mut T,
        mut draw: impl FnMut(&mut T, &RingRow) -> Result<(), T::Error>,
    ) -> Result<(), T::Error> {
        let Some(shape) = MirroredBox::new(self.outer, &target.window()) else {
            return Ok(());
        };
        let mut rows = MirroredRows::new(self.outer, self.inner, circle::CURVE, &shape);
        shape.for_each_batch(&mut rows, |first_row, batch| {
            for (row, &insets) in (first_row..).zip(batch) {
                let [start, hole_start, hole_end, end] = shape.bounds(insets);
                let hole = Columns {
                    start: hole_start,
                    end: hole_end,
                };
                for y in shape.lines(row).into_iter().flatten() {
                    draw(target, &RingRow { y, start, hole, end })?;
                }
            }
            Ok(())
        })
    }
}

impl RingRow {
    fn columns(&self) -> Columns {
        Columns {
            start: self.start,
            end: self.end,
        }
    }

    /// What is before the hole and what is after it; without a hole, all is before it.
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

fn fill_columns<T: Target>(target: &mut T, y: i32, columns: Columns, ink: T::Ink) -> Result<(), T::Error> {
    if columns.is_empty() {
        return Ok(());
    }
    target.fill_clipped_span(Clipped(Span::new(y, columns.start, columns.end)), ink)
}

impl StyledShape for Arc {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        let Some(color) = style.effective_stroke_color() else {
            return Ok(());
        };
        let ink = target.ink(color);
        let ring = Ring::new(self.bounding_box(), style);
        let center = Center::of(&self.bounding_box());
        let sector = PlaneSector::new(self.angle_start, self.angle_sweep);
        let half_planes = sector.half_planes(0);
        ring.for_each_row(target, |target, row| {
            let columns = half_planes.map(|half_plane| half_plane.columns(center, row.y, row.columns()));
            for piece in sector.pieces(columns, row.columns()) {
                for side in row.sides() {
                    fill_columns(target, row.y, piece.intersection(side), ink)?;
                }
            }
            Ok(())
        })
    }
}

/// What a stroke cuts off the corner where both sides of a sector meet.
#[derive(Copy, Clone, PartialEq, Eq)]
enum Bevel {
    /// A corner that points outwards is left out.
    Outside,
    /// One that points inwards is filled.
    Inside,
}

/// The bevel of a sharp corner, and where it is.
fn bevel(sector: &Sector, outside_width: i64) -> Option<(Bevel, HalfPlane)> {
    let sweep = sector.angle_sweep.abs();
    let half = sector.angle_start + Angle::from_radians(sector.angle_sweep.to_radians() / 2.0);
    let quarter = Angle::from_radians(core::f32::consts::FRAC_PI_2);
    // Four half pixels for each pixel of the stroke.
    let beyond = -4 * outside_width * i64::from(NORMAL_LENGTH);
    if sweep < Angle::from_degrees(55.0) {
        Some((Bevel::Outside, HalfPlane::left_of(half - quarter, beyond)))
    } else if sweep > Angle::from_degrees(305.0) && sweep < Angle::from_degrees(360.0) {
        Some((Bevel::Inside, HalfPlane::left_of(half + quarter, beyond)))
    } else {
        None
    }
}

/// Fills what of the hole lies between both pairs of half planes: a sector whose stroke has no colour.
fn fill_between<T: Target>(
    target: &mut T,
    ring: &Ring,
    center: Center,
    sector: &PlaneSector,
    [outer, inner]: [[HalfPlane; 2]; 2],
    ink: T::Ink,
) -> Result<(), T::Error> {
    let is_one = outer == inner;
    ring.for_each_row(target, |target, row| {
        let visible = row.hole;
        if visible.is_empty() {
            return Ok(());
        }
        let pieces = |half_planes: [HalfPlane; 2]| {
            let columns = half_planes.map(|half_plane| half_plane.columns(center, row.y, visible));
            sector.pieces(columns, visible)
        };
        for piece in pieces(outer) {
            if is_one {
                fill_columns(target, row.y, piece, ink)?;
                continue;
            }
            for inner_piece in pieces(inner) {
                fill_columns(target, row.y, piece.intersection(inner_piece), ink)?;
            }
        }
        Ok(())
    })
}

impl StyledShape for Sector {
    fn draw_styled_on<T: Target>(&self, style: &PrimitiveStyle<T::Color>, target: &mut T) -> Result<(), T::Error> {
        if style.is_transparent() {
            return Ok(());
        }
        let stroke = style.stroke_color.map(|color| target.ink(color));
        let fill = style.fill_color.map(|color| target.ink(color));
        let ring = Ring::new(self.bounding_box(), style);
        let center = Center::of(&self.bounding_box());
        let sector = PlaneSector::new(self.angle_start, self.angle_sweep);
        // The sides run through the middle of their stroke; each side of it is half a pixel wider.
        let half_pixels = |width: u32, more: i64| (2 * i64::from(width) + more) * i64::from(NORMAL_LENGTH);
        let outside = half_pixels(style.outside_stroke_width(), 1);
        let inside = half_pixels(style.inside_stroke_width(), -1);
        let whole = sector.half_planes(outside);
        let inner = sector.half_planes(-inside);
        let bevel = bevel(self, i64::from(style.outside_stroke_width()));
        // A corner that is left out is one of the stroke.
        let fills_bevel = matches!(bevel, Some((Bevel::Inside, _)));
        if let (None, Some(ink), false) = (stroke, fill, fills_bevel) {
            return fill_between(target, &ring, center, &sector, [whole, inner], ink);
        }
        ring.for_each_row(target, |target, row| {
            let visible = row.columns();
            let columns = |half_plane: HalfPlane| half_plane.columns(center, row.y, visible);
            let (whole, inner) = (whole.map(columns), inner.map(columns));
            let cut = bevel.map(|(kind, half_plane)| (kind, columns(half_plane)));
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
                if !sector.contains(&whole, x) {
                    return None;
                }
                let is_inside = sector.contains(&inner, x)
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
            runs(visible, &mut borders, part, |columns, part| {
                let ink = match part {
                    Part::Fill => fill,
                    Part::Stroke => stroke,
                };
                match ink {
                    Some(ink) => fill_columns(target, row.y, columns, ink),
                    None => Ok(()),
                }
            })
        })
    }
}

drawable_through_generic!(Arc, Sector);

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Arc {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        styled_box(self.bounding_box(), style)
    }
}

impl<C: PixelColor> StyledDimensions<PrimitiveStyle<C>> for Sector {
    fn styled_bounding_box(&self, style: &PrimitiveStyle<C>) -> Rectangle {
        styled_box(self.bounding_box(), style)
    }
}
