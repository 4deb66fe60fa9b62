//! A window in bands of whole rows and, where one row is still too much, in pieces of that row.
//!
//! Band bisection as in FreeType's smooth rasterizer (Turner 1996-2002): what does not fit is halved, and after what fits
//! with room to spare twice as much is tried.

use crate::geometry::Window;

/// Walks a window in bands, top to bottom; a row that is too much for a band is walked in pieces, left to right.
pub(crate) struct Bisection {
    window: Window,
    /// The first pixel that no band has covered yet.
    left: i32,
    top: i32,
    height: u32,
    width: u32,
}

impl Bisection {
    pub(crate) fn new(window: &Window) -> Self {
        Self {
            window: *window,
            left: window.left,
            top: window.top,
            height: window.height(),
            width: window.width(),
        }
    }

    /// The next band; the same one until it is done or halved.
    pub(crate) fn next_band(&self) -> Option<Window> {
        if self.window.is_empty() || self.top >= self.window.bottom {
            return None;
        }
        Some(Window {
            left: self.left,
            top: self.top,
            right: self.left.saturating_add_unsigned(self.width).min(self.window.right),
            bottom: self.top.saturating_add_unsigned(self.height).min(self.window.bottom),
        })
    }

    /// Halves the rows of the next band, or its columns where it has one row. One pixel always has to fit.
    pub(crate) fn halve(&mut self, band: &Window) {
        if band.height() > 1 {
            self.height = band.height() / 2;
        } else {
            self.width = (band.width() / 2).max(1);
        }
    }

    /// Goes on after a band that fitted: with a band twice as large where there was room to spare.
    pub(crate) fn done(&mut self, band: &Window, had_room: bool) {
        let larger = |size: u32| size.saturating_mul(1 + u32::from(had_room));
        if band.right < self.window.right {
            self.left = band.right;
            self.width = larger(band.width());
            return;
        }
        self.left = self.window.left;
        self.width = self.window.width();
        self.top = band.bottom;
        self.height = larger(band.height());
    }
}
