//! A colour ramp: colours at levels from 0 to 255, and straight lines between them.
//!
//! Guarantees: each channel is within 0.502 of the exact straight line, and exact at every stop. Cost: three products a
//! level, no division; the divisions are done once, where the ramp is made.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use crate::geometry::InputError;

/// A colour of a [`Ramp`].
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
struct Stop {
    /// The position of the stop: 0 is the beginning of a gradient, 255 its end.
    level: u8,
    /// The colour of the gradient at the stop.
    color: Rgb888,
}

/// Colours interpolated between stops. The first stop's colour is used before it, the last stop's after it.
///
/// RAM: 16 bytes a stop.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use zrow::shade::Ramp;
///
/// let ramp = Ramp::between(Rgb888::BLACK, Rgb888::new(255, 100, 0));
/// assert_eq!(ramp.color_at(51), Rgb888::new(51, 20, 0));
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Ramp<const STOPS: usize> {
    segments: [RampSegment; STOPS],
}

/// A stop, and the slopes of the channels towards the next stop, in 1/65,536 per level.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
struct RampSegment {
    level: u8,
    channels: [u8; 3],
    slopes: [i32; 3],
}

const ONE: i32 = 1 << 16;

/// The colours of all levels.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) struct Colors<C>([C; 256]);

impl<C: Copy> Colors<C> {
    #[inline]
    pub(crate) fn at(&self, level: u8) -> C {
        let Self(colors) = self;
        let [first, ..] = colors;
        // There is a colour for each level.
        *colors.get(usize::from(level)).unwrap_or(first)
    }
}

impl Ramp<2> {
    /// The ramp from one colour to another.
    pub fn between(from: Rgb888, to: Rgb888) -> Self {
        let stops = [Stop { level: 0, color: from }, Stop { level: 255, color: to }];
        Self::from_ascending(stops)
    }
}

impl<const STOPS: usize> Ramp<STOPS> {
    /// A ramp of stops, each a level and the colour there: 0 is the beginning of a gradient, 255 its end. Where two have the same
    /// level, the colour jumps there to the last one's.
    ///
    /// # Errors
    /// [`InputError::NotAscending`].
    pub fn new(stops: [(u8, Rgb888); STOPS]) -> Result<Self, InputError> {
        let stops = stops.map(|(level, color)| Stop { level, color });
        if stops.is_empty() || !stops.is_sorted_by_key(|stop| stop.level) {
            return Err(InputError::NotAscending);
        }
        Ok(Self::from_ascending(stops))
    }

    /// The colours at all levels, to be looked up.
    pub(crate) fn colors<C: From<Rgb888>>(&self) -> Colors<C> {
        Colors(core::array::from_fn(|level| C::from(self.color_at(level as u8))))
    }

    fn from_ascending(stops: [Stop; STOPS]) -> Self {
        let mut next = stops.iter().skip(1);
        Self {
            segments: stops.map(|stop| RampSegment::between(stop, next.next().copied().unwrap_or(stop))),
        }
    }

    /// The colour at a level.
    pub fn color_at(&self, level: u8) -> Rgb888 {
        let mut segments = self.segments.iter();
        let Some(mut found) = segments.next() else {
            return Rgb888::BLACK;
        };
        for segment in segments {
            if segment.level <= level {
                found = segment;
            }
        }
        found.color_at(level)
    }
}

impl RampSegment {
    fn between(from: Stop, to: Stop) -> Self {
        let levels = i32::from(to.level) - i32::from(from.level);
        let starts = channels(from.color);
        let mut ends = channels(to.color).into_iter();
        let slopes = starts.map(|start| {
            let rise = i32::from(ends.next().unwrap_or(start)) - i32::from(start);
            // Rounded to the nearest. Two stops at the same level have no slope.
            (rise * ONE * 2 + levels * rise.signum())
                .checked_div(levels * 2)
                .unwrap_or(0)
        });
        Self {
            level: from.level,
            channels: starts,
            slopes,
        }
    }

    fn color_at(&self, level: u8) -> Rgb888 {
        let way = i32::from(level.saturating_sub(self.level));
        let mut slopes = self.slopes.into_iter();
        let [red, green, blue] = self.channels.map(|channel| {
            // Below 2^24, and between two channels.
            let risen = (slopes.next().unwrap_or(0) * way + (ONE / 2)) >> 16;
            (i32::from(channel) + risen) as u8
        });
        Rgb888::new(red, green, blue)
    }
}

fn channels(color: Rgb888) -> [u8; 3] {
    [color.r(), color.g(), color.b()]
}

#[cfg(feature = "defmt")]
impl<const STOPS: usize> defmt::Format for Ramp<STOPS> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Ramp of {} stops", STOPS);
    }
}
