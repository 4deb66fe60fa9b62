//! Damage: rectangles that cover all that has changed, no more of them than there is room for.
//!
//! A rectangle that comes in is fused with one that is there where the box around both has hardly more pixels than the
//! two: what a window costs on the bus, its corners and the command, is worth some pixels. Where it only meets another
//! one, it is cut there. Where there is no room, the two rectangles are fused whose box grows least.
//!
//! Guarantees: no pixel is lost, and none is in two rectangles.

use core::{num::NonZeroU32, ops::Range};

use crate::geometry::Window;

/// The rectangles, in memory that is lent: the first ones of a slice, which do not overlap.
#[derive(Debug)]
pub(super) struct Damage<'m> {
    areas: &'m mut [Window],
    len: usize,
    /// Columns and rows whose multiples every rectangle begins and ends at.
    grid: (u32, u32),
}

/// The pixels that one window less is worth: the 11 bytes that name a window, in pixels of 16 bits, the time around them,
/// and finding out which items lie in it.
const PIXELS_A_WINDOW: u64 = 40;

/// The pixels that one row less in a window is worth: what the items of a row take besides their pixels.
const PIXELS_A_ROW: u64 = 32;

/// The fewest rows that a part of an item is recorded by itself for.
const LEAST_ROWS: u32 = 4;

/// How often what comes in is cut at other rectangles.
const MOST_CUTS: u32 = 3;

impl<'m> Damage<'m> {
    /// The most parts that an item's rows are cut into.
    pub(super) const MOST_PARTS: usize = 8;

    /// No damage. Without memory for a rectangle none is recorded.
    pub(super) const fn new(areas: &'m mut [Window], grid: (u32, u32)) -> Self {
        Self { areas, len: 0, grid }
    }

    /// Whether there is memory for damage.
    pub(super) const fn is_recorded(&self) -> bool {
        !self.areas.is_empty()
    }

    /// Whether all pixels of a rectangle are recorded already, in one rectangle.
    pub(super) fn covers(&self, window: &Window) -> bool {
        self.taken().iter().any(|area| area.intersection(window) == *window)
    }

    /// The number of parts that some rows are cut into when the pixels in them are recorded: half the rectangles that there
    /// is memory for, from 1 to 8, none of them lower than four rows.
    pub(super) fn parts_of(&self, rows: &Range<i32>) -> NonZeroU32 {
        let parts = (self.areas.len() / 2).min(Self::MOST_PARTS) as u32;
        let most = (rows.end - rows.start).unsigned_abs() / LEAST_ROWS;
        NonZeroU32::new(parts.min(most)).unwrap_or(NonZeroU32::MIN)
    }

    /// Forgets all damage.
    pub(super) const fn clear(&mut self) {
        self.len = 0;
    }

    /// Takes one of the rectangles out.
    pub(super) fn pop(&mut self) -> Option<Window> {
        self.len = self.len.checked_sub(1)?;
        self.areas.get(self.len).copied()
    }

    /// Adds the pixels of a rectangle. Cost: a look at each of the other rectangles, once more for each that is fused.
    pub(super) fn add(&mut self, window: Window) {
        if self.is_recorded() && !window.is_empty() {
            self.insert(window.aligned(self.grid.0, self.grid.1), 0);
        }
    }

    /// Adds a rectangle, or what of it no other one has. After so many cuts it is no longer cut, but fused with what it
    /// meets, so that there is an end.
    #[inline(never)]
    fn insert(&mut self, mut window: Window, cuts: u32) {
        loop {
            // What is fused may meet another one that was apart before.
            while let Some(index) = self.taken().iter().position(|other| is_worth_fusing(other, &window)) {
                window = self.take(index).around(&window);
            }
            let met = self.taken().iter().position(|other| other.meets(&window));
            match met {
                Some(index) if cuts < MOST_CUTS => {
                    let other = self.taken().get(index).copied().unwrap_or(Window::EMPTY);
                    for part in without(&window, &other) {
                        if !part.is_empty() {
                            self.insert(part, cuts + 1);
                        }
                    }
                    return;
                }
                Some(index) => window = self.take(index).around(&window),
                None => match self.areas.get_mut(self.len) {
                    Some(free) => {
                        *free = window;
                        self.len += 1;
                        return;
                    }
                    None => return self.insert_without_room(window),
                },
            }
        }
    }

    /// Adds a rectangle by fusing the two whose box grows least, and whatever that box meets.
    fn insert_without_room(&mut self, window: Window) {
        let fused = self.take_nearest(window);
        self.insert(fused, MOST_CUTS);
    }

    fn taken(&self) -> &[Window] {
        self.areas.get(..self.len).unwrap_or_default()
    }

    /// Takes a rectangle out; the last one takes its place.
    fn take(&mut self, index: usize) -> Window {
        let last = self.pop().unwrap_or(Window::EMPTY);
        match self.areas.get_mut(..self.len).and_then(|areas| areas.get_mut(index)) {
            Some(area) => core::mem::replace(area, last),
            None => last,
        }
    }

    /// Makes room by fusing the two whose box has the fewest pixels that the larger one has not, of all rectangles and
    /// one more. Returns the box; the one more then lies among the rectangles, unless it is in the box.
    fn take_nearest(&mut self, window: Window) -> Window {
        let growth = |one: &Window, other: &Window| pixels(&one.around(other)) - pixels(one).max(pixels(other));
        let mut nearest = (u64::MAX, 0, None);
        for (index, one) in self.taken().iter().enumerate() {
            let with_new = growth(one, &window);
            if with_new < nearest.0 {
                nearest = (with_new, index, None);
            }
            for (other_index, other) in self.taken().iter().enumerate().skip(index + 1) {
                let with_other = growth(one, other);
                if with_other < nearest.0 {
                    nearest = (with_other, index, Some(other_index));
                }
            }
        }
        let (_, index, other) = nearest;
        let Some(other) = other else {
            return self.take(index).around(&window);
        };
        // The later one first, because taking it out moves none before it.
        let later = self.take(other);
        let fused = later.around(&self.take(index));
        if let Some(free) = self.areas.get_mut(self.len) {
            *free = window;
            self.len += 1;
        }
        fused
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Damage<'_> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Damage {}", self.taken());
    }
}

/// Whether the box around two rectangles takes hardly more than they do.
fn is_worth_fusing(one: &Window, other: &Window) -> bool {
    let common = one.intersection(other);
    // A grid may be so coarse that a rectangle has all columns and rows, whose pixels alone take nearly 64 bits.
    let cost = |window: &Window| pixels(window).saturating_add(PIXELS_A_ROW * u64::from(window.height()));
    let apart = cost(one).saturating_add(cost(other)).saturating_add(PIXELS_A_WINDOW);
    cost(&one.around(other)).saturating_add(pixels(&common)) <= apart
}

/// The difference of a rectangle and another one that it overlaps, as four rectangles, some of them empty: what lies
/// above the other one, below it, to its left and to its right.
fn without(window: &Window, other: &Window) -> [Window; 4] {
    let rows = Window {
        top: window.top.max(other.top),
        bottom: window.bottom.min(other.bottom),
        ..*window
    };
    [
        Window {
            bottom: rows.top,
            ..*window
        },
        Window {
            top: rows.bottom,
            ..*window
        },
        Window {
            right: other.left,
            ..rows
        },
        Window {
            left: other.right,
            ..rows
        },
    ]
}

fn pixels(window: &Window) -> u64 {
    u64::from(window.width()) * u64::from(window.height())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{vec, vec::Vec};

    /// Numbers that follow from each other (xorshift32).
    fn numbers() -> impl Iterator<Item = i32> {
        let mut state = 0x2468_ACE1u32;
        core::iter::repeat_with(move || {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            (state >> 8) as i32
        })
    }

    #[test]
    fn random_rectangles_are_covered_once() {
        let mut numbers = numbers();
        let mut below = |end: i32| numbers.next().map_or(0, |number| number % end);
        for room in 1..7 {
            for count in 1..12 {
                let windows: Vec<Window> = (0..count)
                    .map(|_| {
                        let (left, top) = (below(60), below(60));
                        Window {
                            left,
                            top,
                            right: left + below(25),
                            bottom: top + below(25),
                        }
                    })
                    .collect();
                let mut memory = vec![Window::EMPTY; room];
                let mut damage = Damage::new(&mut memory, (1, 1));
                for window in &windows {
                    damage.add(*window);
                }
                assert!(damage.len <= room);
                for (x, y) in (0..90).flat_map(|x| (0..90).map(move |y| (x, y))) {
                    let has = |window: &&Window| window.contains(embedded_graphics::geometry::Point::new(x, y));
                    let covering = damage.taken().iter().filter(has).count();
                    assert!(covering <= 1, "{x} {y} in {damage:?} of {windows:?}");
                    assert!(
                        covering == 1 || !windows.iter().any(|window| has(&window)),
                        "{x} {y} is not in {damage:?} of {windows:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn rectangles_far_apart_stay_apart_until_there_is_no_room() {
        let window = |left: i32, top: i32| Window {
            left,
            top,
            right: left + 10,
            bottom: top + 10,
        };
        let mut memory = [Window::EMPTY; 2];
        let mut damage = Damage::new(&mut memory, (8, 8));
        damage.add(window(3, 3));
        damage.add(window(203, 3));
        assert_eq!(damage.len, 2);
        // The nearer one takes it in; every side is a multiple of 8.
        damage.add(window(203, 60));
        assert_eq!(damage.len, 2);
        let all: Vec<Window> = core::iter::from_fn(|| damage.pop()).collect();
        assert!(all.contains(&Window {
            left: 0,
            top: 0,
            right: 16,
            bottom: 16
        }));
        assert!(all.contains(&Window {
            left: 200,
            top: 0,
            right: 216,
            bottom: 72
        }));
    }

    /// The costs of what is fused are more than 64 bits tell.
    #[test]
    fn rectangles_of_all_columns_and_rows_are_covered() {
        let window = |left: i32, top: i32| Window {
            left,
            top,
            right: left + 2,
            bottom: top + 2,
        };
        for room in 1..4 {
            let mut memory = vec![Window::EMPTY; room];
            let mut damage = Damage::new(&mut memory, (u32::MAX, u32::MAX));
            for window in [window(-5, -5), window(3, 3), window(-1, -1), window(-1, 1)] {
                damage.add(window);
                assert!(
                    damage.taken().iter().any(|area| area.meets(&window)),
                    "{window:?} in {damage:?}"
                );
            }
        }
    }
}
