//! Outlines of embedded-graphics' `Arc` and `Sector` in a style.
//!
//! The stroke of an arc is the part of a ring between two angles, cut straight. The outline of a sector is a part of a
//! disc between two lines along the angles, which lie half a pixel outside of it where there is no stroke: a line of
//! pixels has its middle on the angle. A stroke moves these lines and the circle outwards and inwards:
//!
//! ```text
//!        .---.             sweep below half a turn: what lies on the inner side of both lines;
//!      .'     '.           from half a turn on: what lies on the inner side of either
//!      | outer |           a   the tip, where both lines meet
//!      |\ .-. /|           o   centre
//!      | \ f / |           f   fill
//!       \ \ / /
//!        \ o /             Where the angle between the sides is below 55 degrees, inside or outside, the tip is cut
//!         \ /              off (and the notch filled) at right angles to the middle, twice the stroke's outside part
//!          a               from the centre, as embedded-graphics does.
//! ```

use core::{f32::consts::TAU, num::NonZeroU32};

use embedded_graphics::{
    geometry::{Angle, Dimensions},
    pixelcolor::PixelColor,
    primitives::{Arc, Sector},
};

use crate::{
    draw::{
        PrimitiveStyle,
        antialiased::{
            closed_shapes::{HALF, OutlineBox, Reaches, may_meet},
            layers::{Layer, LayerSink, OutlinedShape},
            outline_arc::{OutlineArc, WidePosition},
            round_outline::{RoundContour, RoundOutline},
            turn::{TURN, direction, round_products},
        },
    },
    geometry::{InputError, Window, divide_floor_wide},
};

/// The angle from which a sector's tip is cut off.
const SHARP: i32 = (TURN as i64 * 55 / 360) as i32;

/// An angle in [`TURN`]ths of a turn; 0 where it is not a number, or so large that it has no direction.
fn turns(angle: Angle) -> i64 {
    /// 2^22 turns: from there on, neighbouring numbers are two radians apart.
    const NO_DIRECTION: f32 = (1u64 << 46) as f32;
    let units = angle.to_radians() * (TURN as f32 / TAU);
    // Neither for infinity nor for what is not a number.
    let has_direction = units.abs() < NO_DIRECTION;
    if !has_direction {
        return 0;
    }
    (units + if units < 0.0 { -0.5 } else { 0.5 }) as i64
}

/// The directions from an angle on, over a sweep: clockwise, below a whole turn.
#[derive(Copy, Clone)]
struct Sweep {
    start: i32,
    sweep: i32,
}

impl Sweep {
    /// `None` for a whole turn or more.
    fn new(start: Angle, sweep: Angle) -> Option<Self> {
        if sweep.abs() >= Angle::from_degrees(360.0) {
            return None;
        }
        let (start, sweep) = (turns(start), turns(sweep));
        // Modulo a whole turn.
        let first = (start + sweep.min(0)) & (i64::from(TURN) - 1);
        Some(Self {
            start: first as i32,
            sweep: sweep.unsigned_abs().min(TURN as u64 - 1) as i32,
        })
    }

    fn end(self) -> i32 {
        self.start + self.sweep
    }
}

impl OutlinedShape for Arc {
    // A whole turn.
    const MAY_BE_MIRRORED: bool = true;

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        let around = OutlineBox::of(&self.bounding_box());
        let reaches = Reaches::of(style);
        let (Some(color), Some(outer)) = (style.effective_stroke_color(), around.outset(reaches.outer)) else {
            return Ok(());
        };
        let inner = around.outset(reaches.inner);
        let outline = band(&outer, inner.as_ref(), Sweep::new(self.angle_start, self.angle_sweep));
        layer(&Layer::new(&outline?, color))
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        may_meet(&self.bounding_box(), window, stroke_width)
    }
}

/// The part of a ring between two angles; the whole ring without them.
fn band(outer: &OutlineBox, inner: Option<&OutlineBox>, sweep: Option<Sweep>) -> Result<RoundOutline, InputError> {
    let ellipse = |around: &OutlineBox| RoundContour::ellipse(around.center, around.radii);
    let Some(Sweep { start, sweep }) = sweep else {
        return Ok(RoundOutline::ring(ellipse(outer)?, inner.map(ellipse).transpose()?));
    };
    let forwards = OutlineArc::new(outer.center, outer.radii, (start, sweep))?;
    let backwards = match inner {
        Some(inner) => OutlineArc::new(inner.center, inner.radii, (start + sweep, -sweep))?,
        None => OutlineArc::point(outer.center)?,
    };
    Ok(RoundOutline::new(RoundContour::new(&[forwards, backwards])))
}

impl OutlinedShape for Sector {
    // A whole turn.
    const MAY_BE_MIRRORED: bool = true;

    fn layers<C: PixelColor>(&self, style: &PrimitiveStyle<C>, layer: &mut LayerSink<'_, C>) -> Result<(), InputError> {
        let around = OutlineBox::of(&self.bounding_box());
        let reaches = Reaches::of(style);
        if let Some(outer) = around.outset(reaches.outer) {
            // Where the whole disc is in the domain, all positions below are in the number range.
            RoundContour::ellipse(outer.center, outer.radii)?;
        }
        let sides = Sides {
            sweep: Sweep::new(self.angle_start, self.angle_sweep),
            bevel: 2 * reaches.outer,
        };
        let contour = |reach: i64, beyond: i64| {
            let around = around.outset(reach);
            around.map_or(Ok(None), |around| sides.contour(&around, beyond))
        };
        let stroke_color = style.effective_stroke_color();
        let inner = contour(reaches.inner, reaches.inner + HALF)?;
        if let (Some(color), Some(mut filled)) = (style.fill_color, inner) {
            if stroke_color.is_some() {
                filled = contour(reaches.middle, reaches.middle + HALF)?.unwrap_or(filled);
            }
            layer(&Layer::new(&RoundOutline::new(filled), color))?;
        }
        if let Some(color) = stroke_color {
            if let Some(outer) = contour(reaches.outer, reaches.outer + HALF)? {
                layer(&Layer::new(&RoundOutline::ring(outer, inner), color))?;
            }
        }
        Ok(())
    }

    fn may_meet(&self, window: &Window, stroke_width: u32) -> bool {
        may_meet(&self.bounding_box(), window, stroke_width)
    }
}

/// The two straight sides of a sector.
struct Sides {
    /// `None` for a whole turn, which has no sides.
    sweep: Option<Sweep>,
    /// The distance from the centre at which a sharp corner is cut off, in 1/256 pixel.
    bevel: i64,
}

impl Sides {
    /// The part of the disc in a box between both sides, which lie `beyond` the angles, in 1/256 pixel; negative numbers
    /// are inside. `None` where nothing is left.
    fn contour(&self, around: &OutlineBox, beyond: i64) -> Result<Option<RoundContour>, InputError> {
        let center = around.center;
        let [radius, _] = around.radii;
        let disc = || RoundContour::ellipse(center, around.radii).map(Some);
        let Some(sweep) = self.sweep else { return disc() };
        let arc = |start: i32, sweep: i32| OutlineArc::new(center, around.radii, (start, sweep));
        let half_sweep = sweep.sweep >> 1;
        let middle = sweep.start + half_sweep;
        let tip = Tip {
            center,
            middle: direction(middle),
            half_sine: direction(half_sweep)[1],
            beyond,
        };
        let is_sharp = sweep.sweep < SHARP && beyond > 0 || sweep.sweep > TURN - SHARP && beyond < 0;
        let is_cut = is_sharp && tip.distance() > self.bevel;
        // Half of the angle over which the bevel passes through the disc.
        let bevelled = if is_cut { arc_cosine(self.bevel, radius) } else { 0 };
        if beyond.abs() >= radius {
            // The sides pass the disc on the outside, or on the inside.
            return if beyond > 0 && sweep.sweep > 0 {
                disc()
            } else if beyond < 0 && bevelled > 0 {
                Ok(Some(RoundContour::new(&[arc(middle - bevelled, 2 * bevelled)?])))
            } else {
                Ok(None)
            };
        }
        // The sides meet the circle behind the angles by this one.
        let behind = arc_sine(beyond, radius);
        let round = sweep.sweep + 2 * behind;
        if round <= 0 {
            return Ok(None);
        }
        if round >= TURN {
            return disc();
        }
        let outer = arc(sweep.start - behind, round)?;
        // Where the sides meet outside of the disc, the angle on its back from each of them to the other one or to the bevel.
        let back = behind - half_sweep - bevelled;
        let contour = if back > 0 {
            let opposite = middle + TURN / 2;
            let (last, first) = (arc(opposite - bevelled - back, back)?, arc(opposite + bevelled, back)?);
            RoundContour::new(&[outer, last, first])
        } else if bevelled == 0 && behind + (TURN >> 1) < half_sweep {
            segments([
                arc(sweep.start - behind, TURN / 2 + 2 * behind)?,
                arc(sweep.end() - TURN / 2 - behind, TURN / 2 + 2 * behind)?,
            ])?
        } else if is_cut {
            let at = if beyond > 0 { -self.bevel } else { self.bevel };
            let [one, other] = tip.bevelled(at, sweep);
            RoundContour::new(&[outer, OutlineArc::point(one)?, OutlineArc::point(other)?])
        } else {
            RoundContour::new(&[outer, OutlineArc::point(tip.position())?])
        };
        Ok(Some(contour))
    }
}

/// The two parts of a disc between arcs and their chords. The line from one to the other is passed there and back, so that it
/// covers nothing.
fn segments([one, other]: [OutlineArc; 2]) -> Result<RoundContour, InputError> {
    let start = |arc: &OutlineArc| OutlineArc::point(arc.corner(0).map(i64::from));
    Ok(RoundContour::new(&[one, start(&one)?, other, start(&other)?]))
}

/// The corner of a sector, where both sides meet.
struct Tip {
    center: WidePosition,
    /// The direction of the middle between both sides, in 2.30 fixed point.
    middle: [i32; 2],
    /// The sine of half the angle between the sides, in 2.30 fixed point.
    half_sine: i32,
    /// The distance, in 1/256 pixel, between each straight side of the sector and the line from its centre at the angle where
    /// its sweep begins or ends; negative where the side lies on the sector's inner side of that line.
    beyond: i64,
}

impl Tip {
    /// The distance from the centre to the point in which the sides meet.
    fn distance(&self) -> i64 {
        // 0 for a sector without an angle alone, whose tip is infinitely far away.
        let sine = NonZeroU32::new(self.half_sine.unsigned_abs()).unwrap_or(NonZeroU32::MIN);
        // Less than 2^21 times 2^30.
        divide_floor_wide(self.beyond.abs() << 30, sine).0
    }

    /// The point in which the sides meet.
    fn position(&self) -> WidePosition {
        let distance = self.distance();
        self.along(if self.beyond > 0 { -distance } else { distance })
    }

    /// A point on the middle between both sides, as far from the centre.
    fn along(&self, distance: i64) -> WidePosition {
        let [x, y] = self.center;
        let [cosine, sine] = self.middle;
        let part = |factor: i32| round_products(distance * i64::from(factor));
        [x + part(cosine), y + part(sine)]
    }

    /// The points in which the last and the first side meet the line that is at right angles to the middle, at a distance
    /// from the centre.
    fn bevelled(&self, distance: i64, sweep: Sweep) -> [WidePosition; 2] {
        [(sweep.end(), 1), (sweep.start, -1)].map(|(angle, side)| {
            let [cosine, sine] = direction(angle);
            let [middle_cosine, middle_sine] = self.middle;
            // The side is all points p with n p = beyond, for its normal n to the outside; the bevel is all points with
            // m p = distance. The normal's part across the middle is the cosine of half the sweep.
            let normal = [-i64::from(sine) * side, i64::from(cosine) * side];
            let across = [-i64::from(middle_sine) * side, i64::from(middle_cosine) * side];
            let dot = |a: [i64; 2], b: [i64; 2]| (a[0] * b[0] + a[1] * b[1]) >> 30;
            let along_middle = dot(normal, [middle_cosine.into(), middle_sine.into()]);
            let along_across = dot(normal, across);
            let rest = (self.beyond << 30) - distance * along_middle;
            // Not 0: half of the sweep is below 28 degrees or above 152.
            let size = NonZeroU32::new(along_across.unsigned_abs() as u32).unwrap_or(NonZeroU32::MIN);
            let reach = divide_floor_wide(rest * along_across.signum(), size).0;
            let [x, y] = self.along(distance);
            let part = |component: i64| round_products(reach * component);
            [x + part(across[0]), y + part(across[1])]
        })
    }
}

/// The angle whose cosine is `distance / radius`, in [`TURN`]ths of a turn; 0 from a distance of the radius on.
fn arc_cosine(distance: i64, radius: i64) -> i32 {
    if distance < radius {
        TURN / 4 - arc_sine(distance, radius)
    } else {
        0
    }
}

/// The angle whose sine is `height / radius`, in [`TURN`]ths of a turn, by bisection; the radius is larger than the
/// height.
fn arc_sine(height: i64, radius: i64) -> i32 {
    let wanted = height.abs() << 30;
    let mut angle = 0;
    let mut step = TURN / 8;
    while step > 0 {
        if i64::from(direction(angle + step)[1]) * radius <= wanted {
            angle += step;
        }
        step >>= 1;
    }
    if height < 0 { -angle } else { angle }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        geometry::{AngleUnit, Point},
        pixelcolor::{Gray4, GrayColor},
        primitives::{PrimitiveStyleBuilder, StrokeAlignment},
    };

    use super::*;
    use crate::draw::pictures::{antialiased, grey_in_white};

    #[test]
    fn an_arc_3_pixels_wide_with_a_gap_below() {
        let arc = Arc::new(Point::new(1, 1), 13, 135.0.deg(), 270.0.deg());
        antialiased(&arc, PrimitiveStyle::with_stroke(Gray4::WHITE, 3)).assert_pattern(&[
            "    5BEFEB5    ",
            "  2CFFFFFFFC2  ",
            " 2EFFFFFFFFFE2 ",
            " CFFE72 27EFFC ",
            "5FFE3     3EFF5",
            "BFF7       7FFB",
            "EFF2       2FFE",
            "FFF         FFF",
            "EFF2       2FFE",
            "BFF7       7FFB",
            "5FFE2     2EFF5",
            " CF8       8FC ",
            " 27         72 ",
        ]);
    }

    #[test]
    fn a_sector_over_a_third() {
        let sector = Sector::new(Point::zero(), 15, 0.0.deg(), -120.0.deg());
        antialiased(&sector, PrimitiveStyle::with_fill(Gray4::WHITE)).assert_pattern(&[
            "    5BEFEB5    ",
            "   7FFFFFFFC2  ",
            "   1EFFFFFFFE2 ",
            "    6FFFFFFFFC ",
            "     CFFFFFFFF5",
            "     3FFFFFFFFB",
            "      AFFFFFFFE",
            "      2EFFFFFFF",
        ]);
    }

    #[test]
    fn a_disc_without_a_quarter_in_a_stroke() {
        let sector = Sector::new(Point::new(0, 0), 13, 45.0.deg(), 270.0.deg());
        antialiased(&sector, grey_in_white(2, StrokeAlignment::Inside)).assert_pattern(&[
            "   4AEFEA4  ",
            "  9FFFFFFF9 ",
            " 9FFA767EFE3",
            "4FF8666CFE4 ",
            "AFA666CFE4  ",
            "EF766CFE4   ",
            "FF669FF7    ",
            "EF766CFE4   ",
            "AFA666CFE4  ",
            "4FF8666CFE4 ",
            " 9FFA767EFE3",
            "  9FFFFFFF9 ",
            "   4AEFEA4  ",
        ]);
    }

    #[test]
    fn the_outer_corner_of_a_narrow_sector_is_cut_off() {
        let sector = Sector::new(Point::new(-4, -3), 17, -20.0.deg(), 40.0.deg());
        let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
            .stroke_color(Gray4::WHITE)
            .stroke_width(2)
            .stroke_alignment(StrokeAlignment::Outside)
            .build()
            .into();
        antialiased(&sector, style).assert_pattern(&[
            "         15BFB ",
            "       49EFFFF3",
            "    28DFFFC69F8",
            " 16CFFFD82  4FC",
            "6FFFE94     1FE",
            "8FFA1        FF",
            "6FFFE94     1FE",
            " 16CFFFD82  4FC",
            "    28DFFFC69F8",
            "       49EFFFF3",
            "         15BFB ",
            "            12 ",
        ]);
    }
}
