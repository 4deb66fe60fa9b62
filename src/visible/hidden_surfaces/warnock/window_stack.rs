//! The windows that are being divided, one for each level, and their quarters that are still to come.
//!
//! ```text
//!     +-------+---+---+        A window of 16 x 16 pixels is being divided, and in it the second quarter, of 8 x 8. The stack has two
//!     |       |   | . |        entries. After the last quarter of the upper one it is taken off, and the third quarter of the lower
//!     |   1   +---+---+        one is the next.
//!     |       |   |   |
//!     +-------+---+---+
//!     |   3   |   4   |
//!     +-------+-------+
//! ```

use crate::geometry::Window;

/// Most levels of windows that are divided: 14 halvings make one pixel of 16,384 pixels, which is more than a domain has.
pub(super) const LEVELS: usize = 14;

/// A window that is being divided.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Divided {
    left: i16,
    top: i16,
    right: i16,
    bottom: i16,
    /// How many faces of the list are in the window, or [`UNLISTED`](super::face_list::UNLISTED).
    listed: u16,
    /// Quarters that were handed out.
    quarters: u8,
}

impl Divided {
    const NONE: Self = Self {
        left: 0,
        top: 0,
        right: 0,
        bottom: 0,
        listed: 0,
        quarters: 0,
    };

    /// The next quarter; it has no pixels where the window has one column or one row. `None` after the last one.
    fn next_quarter(&mut self) -> Option<Window> {
        let [left, top, right, bottom] = [self.left, self.top, self.right, self.bottom].map(i32::from);
        let (column, row) = ((left + right + 1) >> 1, (top + bottom + 1) >> 1);
        let quarter = self.quarters;
        self.quarters += 1;
        let (left, right) = if quarter & 1 == 0 {
            (left, column)
        } else {
            (column, right)
        };
        let (top, bottom) = if quarter & 2 == 0 { (top, row) } else { (row, bottom) };
        (quarter < 4).then_some(Window {
            left,
            top,
            right,
            bottom,
        })
    }
}

/// The windows that are being divided, the largest one first.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct WindowStack {
    divided: [Divided; LEVELS],
    levels: u8,
}

impl WindowStack {
    /// A stack without windows.
    pub(super) const EMPTY: Self = Self {
        divided: [Divided::NONE; LEVELS],
        levels: 0,
    };

    /// Begins to divide a window in which so many faces of the list are.
    pub(super) fn push(&mut self, window: &Window, listed: u16) {
        let Some(top) = self.divided.get_mut(usize::from(self.levels)) else {
            debug_assert!(false, "more levels than a picture has");
            return;
        };
        // Pixels of the domain are below 2^13 in size.
        *top = Divided {
            left: window.left as i16,
            top: window.top as i16,
            right: window.right as i16,
            bottom: window.bottom as i16,
            listed,
            quarters: 0,
        };
        self.levels += 1;
    }

    /// The next quarter of the smallest window that has one left, and how many faces of the list are in that window.
    pub(super) fn next_quarter(&mut self) -> Option<(Window, u16)> {
        loop {
            let level = self.levels.checked_sub(1)?;
            let divided = self.divided.get_mut(usize::from(level))?;
            match divided.next_quarter() {
                Some(quarter) if quarter.is_empty() => {}
                Some(quarter) => return Some((quarter, divided.listed)),
                None => self.levels = level,
            }
        }
    }
}
