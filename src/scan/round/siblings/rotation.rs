//! An ellipse by its parametric form, `x = a sin t`, `y = b cos t`: points at equal steps of `t`, each from the one before.
//!
//! ```text
//!   # # o          o  samples less than a pixel apart, rounded: consecutive
//!       x # o         ones touch, so no pixel is skipped
//!           x #    x  a pixel between two that touch at a corner is left out:
//!             #       the outline stays one pixel thin
//! ```
//!
//! A step of `t` by a fixed angle turns the point on the circle that has the longer semi-axis as its radius, `x' = x cos + y sin`,
//! `y' = y cos - x sin`; along the shorter semi-axis, its coordinate is squeezed. (Turning the point on the ellipse itself needs
//! sines times the ratio of the axes, which loses thin ellipses in fixed point.) Coordinates have 24 bits of fraction. What a
//! step changes is less than a pixel on each axis, so its two products are, too, and the factors can have 38 bits of fraction.

use core::num::NonZero;

use embedded_graphics::geometry::{Point, Size};

use crate::geometry::Window;

/// The largest semi-axis in pixels, 32,767: its coordinates fit 40 bits, and the samples are less than 1/64 pixel off.
pub(crate) const MAX_RADIUS: u32 = (1 << 15) - 1;

const COORDINATE_BITS: u32 = 24;
const FACTOR_BITS: u32 = 38;
const SQUEEZE_BITS: u32 = 23;
const ANGLE_BITS: u32 = 60;

/// A quarter turn in units of 2^-60.
const QUARTER_TURN: u64 = 0x1921_FB54_442D_1847;

/// How far a sampled outline goes from the top.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) enum Sweep {
    /// From the top to the diagonal, at which the other half of the quarter is mirrored.
    Eighth,
    /// From the top to the side.
    Quarter,
}

/// A point on a circle, relative to the center.
#[derive(Debug, Clone)]
struct Rotation {
    x: i64,
    y: i64,
    sine: i64,
    /// `1 - cos`.
    versine: i64,
    /// What each coordinate is multiplied by for the ellipse, at most 1.
    squeeze: (i64, i64),
}

impl Rotation {
    /// The rotation that steps along an ellipse from its top on, by an angle in units of 2^-60, up to an eighth of a turn.
    fn new(radii: Size, angle: u64) -> Self {
        let (sine, versine) = sine_and_versine(angle);
        let Size { width, height } = radii;
        let radius = width.max(height);
        let longer = NonZero::new(u64::from(radius)).unwrap_or(NonZero::<u64>::MIN);
        let ratio = |radius: u32| (((u64::from(radius) << SQUEEZE_BITS) + longer.get() / 2) / longer) as i64;
        Self {
            x: 0,
            y: i64::from(radius) << COORDINATE_BITS,
            sine: rounded(sine, ANGLE_BITS - FACTOR_BITS),
            versine: rounded(versine, ANGLE_BITS - FACTOR_BITS),
            squeeze: (ratio(width), ratio(height)),
        }
    }

    #[inline]
    fn advance(&mut self) {
        const HALF: i64 = 1 << (FACTOR_BITS - 1);
        let Self {
            x, y, sine, versine, ..
        } = *self;
        // Each sum of products stands for less than a pixel and a bit: below 2^63.
        self.x += (y * sine - x * versine + HALF) >> FACTOR_BITS;
        self.y -= (x * sine + y * versine + HALF) >> FACTOR_BITS;
    }

    /// The nearest pixel, as distances from the center.
    #[inline]
    fn pixel(&self) -> (u32, u32) {
        const BITS: u32 = COORDINATE_BITS + SQUEEZE_BITS;
        // A coordinate is below 2^39, so its product is below 2^62. The last one may be a little below 0, and is rounded to 0.
        let nearest = |coordinate: i64, squeeze: i64| ((coordinate * squeeze + (1 << (BITS - 1))) >> BITS) as u32;
        (nearest(self.x, self.squeeze.0), nearest(self.y, self.squeeze.1))
    }
}

/// The number without its lowest `bits` bits, rounded to the nearest.
const fn rounded(number: u64, bits: u32) -> i64 {
    ((number + (1 << (bits - 1))) >> bits) as i64
}

/// Sine, and one minus the cosine, of an angle up to an eighth of a turn, by their series.
fn sine_and_versine(angle: u64) -> (u64, u64) {
    let one = 1 << ANGLE_BITS;
    let times_angle = |number: u64| ((u128::from(number) * u128::from(angle)) >> ANGLE_BITS) as u64;
    let (mut sums, mut term) = ([0i64; 2], one);
    // The terms angle^n / n!, even ones into one minus the cosine, odd ones into the sine; two of each sign.
    for power in NonZero::<u64>::MIN.get()..=22 {
        let Some(divisor) = NonZero::new(power) else { break };
        term = times_angle(term) / divisor;
        let [even, odd] = &mut sums;
        match power % 4 {
            1 => *odd += term as i64,
            2 => *even += term as i64,
            3 => *odd -= term as i64,
            _ => *even -= term as i64,
        }
    }
    (sums[1].unsigned_abs(), sums[0].unsigned_abs())
}

/// The pixels of the samples, one thin path from the top, as distances from the center.
#[derive(Debug, Clone)]
struct ThinPath {
    rotation: Rotation,
    /// The number of samples that are still to come.
    remaining: u32,
    sweep: Sweep,
    /// The pixel that was returned last.
    returned: Option<(u32, u32)>,
    /// The pixel after `returned`, which may still be left out.
    candidate: Option<(u32, u32)>,
}

/// The first sample of an outline, and how many more there are: at most 2^16.
fn samples(radii: Size, sweep: Sweep) -> (Rotation, u32) {
    let sweep_angle = match sweep {
        Sweep::Eighth => QUARTER_TURN / 2,
        Sweep::Quarter => QUARTER_TURN,
    };
    // As many steps as make one shorter than a pixel where the outline is furthest out.
    let length = (u128::from(sweep_angle) * u128::from(radii.width.max(radii.height) + 1)) >> ANGLE_BITS;
    let steps = length as u32 + 1;
    let angle = sweep_angle / NonZero::new(u64::from(steps)).unwrap_or(NonZero::<u64>::MIN);
    (Rotation::new(radii, angle), steps)
}

impl ThinPath {
    fn new(radii: Size, sweep: Sweep) -> Self {
        let (rotation, steps) = samples(radii, sweep);
        let mut path = Self {
            rotation,
            remaining: steps + 1,
            sweep,
            returned: None,
            candidate: None,
        };
        path.candidate = path.next_other();
        path
    }

    /// The next sampled pixel that is not the candidate.
    #[inline]
    fn next_other(&mut self) -> Option<(u32, u32)> {
        while self.remaining > 0 {
            self.remaining -= 1;
            let (x, y) = self.rotation.pixel();
            self.rotation.advance();
            // The last sample of an eighth is on the diagonal, and may be rounded to either side of it.
            let pixel = if self.sweep == Sweep::Eighth {
                (x.min(y), x.max(y))
            } else {
                (x, y)
            };
            if self.candidate != Some(pixel) {
                return Some(pixel);
            }
        }
        None
    }
}

impl Iterator for ThinPath {
    type Item = (u32, u32);

    fn next(&mut self) -> Option<(u32, u32)> {
        let mut pixel = self.candidate?;
        let mut after = self.next_other();
        if let (Some(before), Some(next)) = (self.returned, after) {
            // Samples go right and down: one step on each axis is a pixel at a corner.
            if next.0 == before.0 + 1 && before.1 == next.1 + 1 {
                self.candidate = after;
                pixel = next;
                after = self.next_other();
            }
        }
        // What follows the last pixel of an eighth is the mirrored one before it: it may touch that across the diagonal.
        let touches_mirrored = self.returned.is_some_and(|(x, y)| x + 1 == y);
        if self.sweep == Sweep::Eighth && after.is_none() && pixel.0 == pixel.1 && touches_mirrored {
            self.candidate = None;
            return None;
        }
        self.returned = Some(pixel);
        self.candidate = after;
        Some(pixel)
    }
}

/// The pixels of a sampled outline inside a window, each once.
#[derive(Debug, Clone)]
pub(crate) struct SampledPixels {
    center: Point,
    window: Window,
    path: ThinPath,
    /// A pixel of the path, and which of its mirrored ones come next: bit 0 to the left, bit 1 upwards, bit 2 with the axes
    /// exchanged.
    pixel: (u32, u32),
    next_image: u8,
    /// Four, or eight where the axes are exchanged too.
    images: u8,
}

impl SampledPixels {
    /// The outline with these semi-axes, up to [`MAX_RADIUS`]; for an eighth they are equal.
    pub fn new(center: Point, radii: Size, sweep: Sweep, window: &Window) -> Self {
        let images = match sweep {
            Sweep::Eighth => 8,
            Sweep::Quarter => 4,
        };
        let mut path = ThinPath::new(radii, sweep);
        if !meets(center, radii, window) {
            // Nothing is visible: no sample is taken.
            (path.remaining, path.candidate) = (0, None);
        }
        Self {
            center,
            window: *window,
            path,
            pixel: (0, 0),
            next_image: images,
            images,
        }
    }

    /// One of the mirrored pixels, if it is visible and no other one is the same pixel.
    #[inline]
    fn image(&self, image: u8) -> Option<Point> {
        let (x, y) = self.pixel;
        let (left, up, exchanged) = (image & 1 != 0, image & 2 != 0, image & 4 != 0);
        if exchanged && x == y {
            return None;
        }
        let (x, y) = if exchanged { (y, x) } else { (x, y) };
        if left && x == 0 || up && y == 0 {
            return None;
        }
        let at = |center: i32, distance: u32, backwards: bool| {
            if backwards {
                center.checked_sub_unsigned(distance)
            } else {
                center.checked_add_unsigned(distance)
            }
        };
        let point = Point::new(at(self.center.x, x, left)?, at(self.center.y, y, up)?);
        self.window.contains(point).then_some(point)
    }
}

impl Iterator for SampledPixels {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        loop {
            while self.next_image < self.images {
                let image = self.next_image;
                self.next_image += 1;
                if let Some(point) = self.image(image) {
                    return Some(point);
                }
            }
            self.pixel = self.path.next()?;
            self.next_image = 0;
        }
    }
}

/// Whether a pixel of the outline's box is in the window.
fn meets(center: Point, radii: Size, window: &Window) -> bool {
    let overlaps = |center: i32, radius: u32, start: i32, end: i32| {
        let [center, start, end] = [center, start, end].map(i64::from);
        let radius = i64::from(radius);
        center - radius < end && start <= center + radius
    };
    !window.is_empty()
        && overlaps(center.x, radii.width, window.left, window.right)
        && overlaps(center.y, radii.height, window.top, window.bottom)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How far a circle's last sample is from the diagonal's point, on the worse axis, in units of 2^-24 pixel.
    fn drift(radius: u32) -> i64 {
        let (mut rotation, steps) = samples(Size::new_equal(radius), Sweep::Eighth);
        for _ in 0..steps {
            rotation.advance();
        }
        let doubled = ((u128::from(radius).pow(2)) << (2 * COORDINATE_BITS + 1)).isqrt() as i64;
        (2 * rotation.x - doubled).abs().max((2 * rotation.y - doubled).abs()) / 2
    }

    #[test]
    fn samples_drift_no_further_than_stated() {
        for radius in (0..200)
            .chain([999, 4_095, 8_191, 16_383, 31_234])
            .chain(32_740..=MAX_RADIUS)
        {
            assert!(
                drift(radius) < 1 << (COORDINATE_BITS - 6),
                "{radius}: {}",
                drift(radius)
            );
        }
    }

    #[test]
    fn sine_and_versine_of_an_eighth_are_exact() {
        let (sine, versine) = sine_and_versine(QUARTER_TURN / 2);
        let exact = (1u128 << (2 * ANGLE_BITS - 1)).isqrt() as u64;
        assert!(sine.abs_diff(exact) < 32, "{sine} {exact}");
        assert!(versine.abs_diff((1 << ANGLE_BITS) - exact) < 32, "{versine}");
    }
}
