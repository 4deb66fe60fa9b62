//! Shrinks a box until a pixel lies on each of its sides, by asking whether strips along the sides have one.
//!
//! From a side inwards, strips of one row, two rows, four rows and so on are asked until one has a pixel; halving that one
//! then finds its first row with a pixel. Columns are found in the same way, between the rows that are left.
//!
//! ```text
//! . . . . . . .   1 row: no pixel
//! . . . . . . .   2 rows: no pixel
//! . . . . . . .
//! . . . . . . .   4 rows: has a pixel; its first 2: no pixel
//! . . . . . . .
//! . . # # . . .   its third: has a pixel, the box begins here
//! . # # # . . .
//! ```
//!
//! Guarantees: no pixel is left out. The box is the smallest one where no side has to move by more than [`MOST_LINES`] rows
//! or columns. Cost: one question a side where the box is the smallest one already, otherwise about 2 log2(n) for a side
//! that moves by n.

use crate::geometry::Window;

/// A side moves inwards by at most about this number of rows or columns, which bounds the work for hairlines without
/// pixels.
pub(crate) const MOST_LINES: u32 = 1024;

/// A side of a box.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) enum Side {
    Left,
    Top,
    Right,
    Bottom,
}

impl Side {
    /// Whether strips along the side are columns.
    pub const fn is_upright(self) -> bool {
        matches!(self, Self::Left | Self::Right)
    }

    /// How many rows or columns a box has, counted from this side.
    const fn lines(self, window: &Window) -> u32 {
        if self.is_upright() {
            window.width()
        } else {
            window.height()
        }
    }

    /// The strip of `lines` rows or columns along this side of a box, without the outermost ones up to `skipped`.
    const fn strip(self, window: &Window, skipped: u32, lines: u32) -> Window {
        // Nothing saturates: the strip lies in the window.
        let end = skipped + lines;
        debug_assert!(end <= self.lines(window));
        match self {
            Self::Left => Window {
                left: window.left.saturating_add_unsigned(skipped),
                right: window.left.saturating_add_unsigned(end),
                ..*window
            },
            Self::Top => Window {
                top: window.top.saturating_add_unsigned(skipped),
                bottom: window.top.saturating_add_unsigned(end),
                ..*window
            },
            Self::Right => Window {
                left: window.right.saturating_sub_unsigned(end),
                right: window.right.saturating_sub_unsigned(skipped),
                ..*window
            },
            Self::Bottom => Window {
                top: window.bottom.saturating_sub_unsigned(end),
                bottom: window.bottom.saturating_sub_unsigned(skipped),
                ..*window
            },
        }
    }

    /// The rows or columns along this side that have no pixel: all of them, or up to the first one with a pixel.
    fn lines_without_pixel(self, window: &Window, has_pixel: &mut dyn FnMut(&Window) -> bool) -> u32 {
        let all = self.lines(window);
        let (mut empty, mut lines) = (0, 1);
        while empty < all.min(MOST_LINES) {
            lines = all.min(empty + lines) - empty;
            if has_pixel(&self.strip(window, empty, lines)) {
                return self.halve(window, (empty, lines), has_pixel);
            }
            empty += lines;
            lines *= 2;
        }
        empty
    }

    /// The number of the first row or column with a pixel in a strip that has one.
    fn halve(
        self,
        window: &Window,
        (mut first, mut lines): (u32, u32),
        has_pixel: &mut dyn FnMut(&Window) -> bool,
    ) -> u32 {
        while lines > 1 {
            let half = lines / 2;
            if has_pixel(&self.strip(window, first, half)) {
                lines = half;
            } else {
                first += half;
                lines -= half;
            }
        }
        first
    }
}

/// The smallest box around the pixels in a window; empty where there are none. `has_pixel` says whether there is one in a
/// strip along a side of the window.
pub(crate) fn shrunk(window: Window, has_pixel: &mut dyn FnMut(Side, &Window) -> bool) -> Window {
    let mut window = window;
    for side in [Side::Top, Side::Bottom, Side::Left, Side::Right] {
        let lines = side.lines_without_pixel(&window, &mut |strip| has_pixel(side, strip));
        window = side.strip(&window, lines, side.lines(&window) - lines);
        if window.is_empty() {
            return Window::EMPTY;
        }
    }
    window
}

/// Shrinks a window as [`shrunk`] does, where pixels are looked for row by row: `transposed` is the shape with columns
/// and rows exchanged.
pub(crate) fn shrunk_by_rows<S>(
    window: Window,
    shape: &S,
    transposed: &S,
    has_pixel: fn(&S, &Window) -> bool,
) -> Window {
    shrunk(window, &mut |side, strip| {
        if side.is_upright() {
            has_pixel(transposed, &strip.transposed())
        } else {
            has_pixel(shape, strip)
        }
    })
}
