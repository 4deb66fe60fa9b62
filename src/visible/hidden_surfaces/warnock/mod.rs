//! Warnock's algorithm: windows are divided into quarters until what is seen in them is obvious.
//!
//! ```text
//!     +---------------+-------+-------+      A window is obvious if no face is in it, if a single one is, or if a face surrounds
//!     |               |  __---|--__   |      it that is nearer than all others in it. Any other one is divided into quarters,
//!     |   no face     |-/     |    \  |      each of which narrows the list of its faces: most of them are separate from it,
//!     |               +-------+---+-\-+      and others are hidden in it by a face that surrounds it. At last a window is one
//!     |           __--|       | A |  \|      pixel, in which the depths of the faces that cover it are compared.
//!     +---------/-----+   A   +---+---+
//!     |        |      |       | A |A/B|      The stack has one window for each level, 14 for any picture, so that nothing
//!     |   A    |  A   |       |   |/  |      recurses.
//!     +---------------+-------+---+---+
//! ```
//!
//! What is decided at corners of windows is decided with a margin, the error of stored depths; where faces are nearer to each other
//! than that, windows are divided down to pixels.
//!
//! How a face lies to a window is a question of its own, which several tests answer, one file each: by its bounding box, by line
//! equations, by a ray, by angles, and by region codes.
//!
//! Guarantees: the picture of the depth row, whatever the order of faces and however short the list. Cost: windows grow in number
//! with the length of the edges that are seen, in pixels, and with that of the lines in which faces meet; each looks at the faces of
//! the window around it. Within windows nothing is compared.
//!
//! Source: Warnock 1969, "A Hidden Surface Algorithm for Computer Generated Halftone Pictures"; Foley, van Dam and others 1990,
//! section 15.7.1; Rogers 1985, section 4-4.

mod angle_sum;
mod bounding_box;
mod face_list;
mod hiding;
mod line_equations;
mod ray_crossings;
mod region_codes;
#[cfg(test)]
mod tests;
mod window_stack;
mod window_test;

use core::{fmt::Debug, marker::PhantomData};

use crate::{
    geometry::{TooSmall, Window},
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::{FaceTable, covers},
        hidden_surfaces::placed::{face_from_row, for_each_node},
        painter::Painter,
        passes::{face_in_first_row, surroundings},
        visibility::{Method, NewMethod},
        work::Work,
    },
};
use angle_sum::AngleSum;
use bounding_box::BoundingBox;
use face_list::{FaceList, UNLISTED};
use hiding::{comes_first, leave_out_hidden};
use line_equations::LineEquations;
use ray_crossings::RayCrossings;
use region_codes::RegionCodes;
use window_stack::WindowStack;
use window_test::WindowTest;

/// Warnock's algorithm ([`Visibility`](crate::visible::Visibility)): divides windows into quarters until one face is seen in them or none. `FACES` is how many
/// faces its list has room for; with fewer than a window has, the picture is the same, and quarters look through the whole table
/// of faces until their own list fits. Take it where the pixels of a picture are many and its edges few, or to see how it works.
///
/// The test of how a face lies to a window is that by bounding boxes ([`new`](Self::new)), or one that is kept to compare:
/// all of them draw the same picture.
///
/// RAM: 2 bytes for each of `FACES`, and 184 for windows and counters.
///
/// Source: Warnock 1969.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Warnock<const FACES: usize, T = BoundingBox> {
    nodes: [u16; FACES],
    stack: WindowStack,
    windows: u32,
    blocks: u32,
    pixels_compared: u32,
    test: PhantomData<T>,
}

impl<const FACES: usize> Warnock<FACES> {
    /// With the test by bounding boxes, and by line equations where boxes do not tell: the fastest one.
    pub const fn new() -> Self {
        Self::with_test()
    }
}

impl<const FACES: usize> Warnock<FACES, LineEquations> {
    /// With the test by line equations of edges at the corners of windows (Foley, van Dam and others 1990).
    pub const fn by_line_equations() -> Self {
        Self::with_test()
    }
}

impl<const FACES: usize> Warnock<FACES, RayCrossings> {
    /// With the test by the crossings of a ray from a corner of windows (Shimrat 1962).
    pub const fn by_ray_crossings() -> Self {
        Self::with_test()
    }
}

impl<const FACES: usize> Warnock<FACES, AngleSum> {
    /// With the test by the sum of angles in which edges are seen from a corner of windows, in quadrants (Weiler 1994).
    pub const fn by_angle_sum() -> Self {
        Self::with_test()
    }
}

impl<const FACES: usize> Warnock<FACES, RegionCodes> {
    /// With the test by codes of the regions around windows, along the edges (Rogers 1985).
    pub const fn by_region_codes() -> Self {
        Self::with_test()
    }
}

impl<const FACES: usize, T> Warnock<FACES, T> {
    const fn with_test() -> Self {
        Self {
            nodes: [0; FACES],
            stack: WindowStack::EMPTY,
            windows: 0,
            blocks: 0,
            pixels_compared: 0,
            test: PhantomData,
        }
    }

    /// How many windows were looked at since the method was made: wraps after 2^32.
    pub const fn windows(&self) -> u32 {
        self.windows
    }

    /// How many windows of them were handed over as a whole, because one face was seen in them: wraps after 2^32.
    pub const fn blocks(&self) -> u32 {
        self.blocks
    }

    /// How many windows of them were single pixels in which the depths of faces were compared: wraps after 2^32.
    pub const fn pixels_compared(&self) -> u32 {
        self.pixels_compared
    }
}

impl<const FACES: usize> Default for Warnock<FACES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth, const FACES: usize, T: WindowTest + Debug + 'static> NewMethod<D> for Warnock<FACES, T> {
    const NEW: Self = Self::with_test();
}

impl<D: DepthWidth, const FACES: usize, T: WindowTest> Method<D> for Warnock<FACES, T> {
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        let picture = Picture {
            faces,
            first_column: window.left,
        };
        self.stack = WindowStack::EMPTY;
        let mut next = Some((*window, UNLISTED));
        while let Some((window, listed)) = next {
            self.windows = self.windows.wrapping_add(1);
            let mut list = FaceList::narrowed::<T, S, D, H>(&mut self.nodes, faces, &window, listed);
            let seen = picture.seen_in(&mut list, &window);
            painter.report(|| Work::Area {
                window,
                faces: list.listed().into(),
            });
            match seen {
                Seen::Nothing => {}
                Seen::Face(node) => {
                    self.blocks = self.blocks.wrapping_add(1);
                    picture.hand_over(painter, node, &window);
                }
                Seen::Pixel => {
                    let compared = picture.hand_over_nearest(painter, &list, &window);
                    self.pixels_compared = self.pixels_compared.wrapping_add(compared.into());
                }
                Seen::Several => self.stack.push(&window, list.listed()),
            }
            next = self.stack.next_quarter();
        }
        Ok(())
    }
}

/// What is seen in a window.
#[derive(Debug, Copy, Clone)]
enum Seen {
    Nothing,
    /// One face and nothing else, or nothing where it does not cover the window.
    Face(u16),
    /// The nearest of several faces in a pixel.
    Pixel,
    /// The window has to be divided.
    Several,
}

/// The faces of a picture whose columns count from a column.
struct Picture<'f, F> {
    faces: &'f F,
    first_column: i32,
}

impl<F> Picture<'_, F> {
    /// What is seen in a window, with the list of its faces, off which hidden ones are taken.
    fn seen_in<S, D, H>(&self, list: &mut FaceList<'_>, window: &Window) -> Seen
    where
        S: ScreenPrecision,
        D: DepthWidth,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        if let Some(seen) = seen_of(list) {
            return seen;
        }
        if window.width() == 1 && window.height() == 1 {
            return Seen::Pixel;
        }
        leave_out_hidden(list, self.faces, window, self.first_column);
        seen_of(list).unwrap_or(Seen::Several)
    }

    /// Hands over the pixels of a window that a face covers, row by row.
    fn hand_over<S, D, H>(&self, painter: &mut impl Painter<S, H>, node: u16, window: &Window)
    where
        S: ScreenPrecision,
        D: DepthWidth,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        let Some((mut face, first_row)) = face_from_row(self.faces, node, [self.first_column, window.top]) else {
            return;
        };
        let [left, right] = [window.left, window.right].map(|column| column - self.first_column);
        for row in first_row..window.bottom {
            let [start, end] = face.span();
            let (start, end) = (start.max(left), end.min(right));
            if start < end {
                painter.span(&face, row, [start, end]);
            }
            face.next_span();
            if !face.leave_row(row) {
                return;
            }
        }
    }

    /// Hands over the face that is nearest in the only pixel of a window. Returns whether depths were compared to find it.
    fn hand_over_nearest<S, D, H>(&self, painter: &mut impl Painter<S, H>, list: &FaceList<'_>, window: &Window) -> bool
    where
        S: ScreenPrecision,
        D: DepthWidth,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        let (mut nearest, mut compared) = (None, false);
        let mut compare = |node| {
            let Some(depth) = self.depth_of(node, window) else {
                return;
            };
            compared |= nearest.is_some();
            let is_nearer = nearest.is_none_or(|(nearest, first)| {
                depth > nearest || (depth == nearest && comes_first(self.faces, node, first))
            });
            if is_nearer {
                nearest = Some((depth, node));
            }
        };
        if list.listed() == UNLISTED {
            for_each_node(self.faces, window, compare);
        } else {
            list.nodes().for_each(&mut compare);
        }
        if let Some((_, node)) = nearest {
            self.hand_over(painter, node, window);
        }
        compared
    }

    /// The stored depth of a face in the first pixel of a window; `None` where it does not cover that.
    fn depth_of<S, D, H>(&self, node: u16, window: &Window) -> Option<D>
    where
        S: ScreenPrecision,
        D: DepthWidth,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        if !covers(self.faces, node, window.left, window.top) {
            return None;
        }
        let face = face_in_first_row(self.faces, node, &surroundings(self.faces, self.first_column))?;
        let depth = face.plane.at(window.left - self.first_column, window.top);
        Some(D::from_interpolated(depth.0))
    }
}

/// What is seen in a window, as far as the length of its list tells.
fn seen_of(list: &FaceList<'_>) -> Option<Seen> {
    match list.listed() {
        0 => Some(Seen::Nothing),
        1 => list.node(0).map(Seen::Face),
        _ => None,
    }
}
