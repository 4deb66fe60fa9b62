//! The painter's algorithm: faces are sorted by depth and painted from back to front, those that hide each other in parts.
//!
//! ```text
//!     seen from above, the eye is below          the list, from its farthest end      painted
//!
//!      ____________ A      A is painted first:   A  B  C                              A
//!       ____ B             its nearest corner is B: is C in its way? C ends farther   A C B
//!          \___            as far away as any of    than B begins, but lies behind
//!     ______   \__ C       B's or C's               B's plane: C goes first
//!
//!      \   /               D and E penetrate:       D is split by the plane of E      D behind E, E, D in front of E
//!     D \ / E
//!        X
//!       / \
//! ```
//!
//! Faces wait in a list by their farthest corners. The first one may be painted when it is nowhere in front of another one that
//! waits. Only faces whose depths overlap are asked, from the cheapest test to the dearest, until one says so:
//!
//! - A: the pixels around the faces have no column or no row in common.
//! - B: all corners of the first face are behind the plane of the other one.
//! - C: all corners of the other face are in front of the plane of the first one.
//! - D: an edge of one of the faces has the other one on its outer side.
//! - The stored depths of both, at the ends of what they have in common of each row. (The paper splits here.)
//!
//! Otherwise the other face goes to the front of the list, to be painted before. A face that would go there a second time
//! is in a cycle: the first face is split, and so it is where two faces penetrate. All tests are exact: where the corners are
//! nearer to a plane than rounding can move a stored depth, the next test decides.
//!
//! A part of a face is not a new polygon, but the face with a condition: those of its pixels in which it is in front of another
//! face, or those in which it is not. So a part has the edges, the depths and the attributes of its face, to the bit. The
//! difference of two planes is even along a row: a part has few runs of pixels in a row, and where one ends is found by
//! bisection. Depths are compared pixel by pixel only where two of them are less than a unit of stored depth apart.
//!
//! ```text
//!     row of a face      . . # # # # # # # # # .       the difference of depths falls evenly: in front up to a column,
//!     other face         . . . . # # # # # # # #       found by bisection
//!     in front of it             # # # # . . .
//!     the other part         # #         # # #
//! ```
//!
//! Where there is no room for conditions, the faces of a cycle are painted at once, each in the pixels in which no other one of
//! them is in front of it. That takes no memory, but each row of each face is compared with all of the others. If what is behind
//! them may be seen through them, they are painted once for each layer: first each in the pixels in which all others are in
//! front of it, and so on to those in which none is.
//!
//! ```text
//!     A in front of B in front of C in front of A        layer 2     C . A . B .    behind both others
//!                                                        layer 1     B . C . A .    behind one
//!                                                        layer 0     A . B . C .    in front
//! ```
//!
//! Before that, from the top of the window down to the first row in which two faces have a column in common, nothing is sorted:
//! of a convex solid no face hides another.
//!
//! Translucent faces are mixed with what was painted before, and holes show it. Of equally near faces, opaque ones are painted
//! after translucent ones.
//!
//! In looks with antialiased silhouettes a surface that ends within a pixel is mixed, by its coverage, with what was painted
//! before. Coverage is known of one row at a time, so that each row is sorted and painted by itself. It is that of a whole surface,
//! and not of a face: faces that were mixed one by one would let what is behind them through along each edge that they share, and
//! along each split.
//!
//! Guarantees: the picture of the depth row, whatever the capacity for parts; with antialiased silhouettes where faces are opaque
//! and not cut, and no more than 31 surfaces cover a pixel as a whole through which a silhouette passes. Cost: the sort, for each
//! face a look at all others whose depths overlap its own (up to the square of their number), and each pixel of each face is
//! painted, hidden or not.
//!
//! Source: Newell, Newell and Sancha 1972, "A solution to the hidden surface problem"; Foley and van Dam, section 15.5.1.

mod along_rows;
mod counters;
mod disjoint_rows;
mod others;
mod pairs;
mod parts;
mod planes_in_row;
mod sort;
mod waiting;

pub use counters::DepthSortCounters;

use crate::{
    geometry::{TooSmall, Window},
    scan::polygon::edge_table::shell_sort,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::FaceTable,
        hidden_surfaces::placed::for_each_node,
        painter::Painter,
        visibility::{Method, NewMethod},
    },
};

use counters::add;
use disjoint_rows::paint_disjoint_rows;
use pairs::Extents;
use sort::{Sort, from_back};
use waiting::{Condition, Waiting};

/// The painter's algorithm with splits ([`Visibility`](crate::visible::Visibility)): it sorts the faces by depth and paints them
/// from back to front. Take it where few faces overlap, or to paint over what is behind.
///
/// `FACES` is the greatest number of faces in what is drawn at once, and some more for their parts; `SPLITS` is the number of
/// conditions on parts of faces that wait, two for each face that is split once. With fewer of them, or none, the
/// picture is the same; it takes longer where faces penetrate or overlap in a cycle.
///
/// Looks with holes, with translucent faces and with silhouettes that are [`Antialiased`](crate::scene::Antialiased) are drawn
/// as well: what is seen through a face, or beside it, was painted before it. Of a surface that ends within a pixel the colour is
/// composited, by its coverage, over what is there: also over translucent faces and faces that are cut, which the depth row leaves
/// out there. Otherwise pictures are those of the depth row, to the bit. Edges between faces and those of splits leave no seam.
/// Two silhouettes at different depths that pass through one pixel are taken for one. In a pixel that more than 31 surfaces
/// cover as a whole, one behind the other, another one of them may be taken for the one that ends there.
///
/// Silhouettes are antialiased row by row: each row of a band is sorted by itself, with a look at all faces that begin above its
/// end. `FACES` is that of the whole band nevertheless, so that nothing is drawn where it is too small.
///
/// RAM: 2 bytes a face, 6 bytes a condition, 40 bytes of counters.
///
/// Source: Newell, Newell and Sancha 1972.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DepthSort<const FACES: usize, const SPLITS: usize> {
    nodes: [u16; FACES],
    conditions: [Condition; SPLITS],
    counters: DepthSortCounters,
}

impl<const FACES: usize, const SPLITS: usize> DepthSort<FACES, SPLITS> {
    /// A method that has drawn nothing.
    pub const fn new() -> Self {
        Self {
            nodes: [0; FACES],
            conditions: [Condition::EMPTY; SPLITS],
            counters: DepthSortCounters::NONE,
        }
    }

    /// What was done since the method was made.
    pub const fn counters(&self) -> &DepthSortCounters {
        &self.counters
    }
}

impl<const FACES: usize, const SPLITS: usize> DepthSort<FACES, SPLITS> {
    /// Keeps the nodes of the faces that may cover pixels of a window, and returns how many they are.
    fn collect<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        window: &Window,
    ) -> Result<usize, TooSmall> {
        let mut count = 0;
        for_each_node(faces, window, |node| {
            if Extents::of(faces, node).is_some_and(|face| face.meets(window)) {
                if let Some(slot) = self.nodes.get_mut(count) {
                    *slot = node;
                }
                count += 1;
            }
        });
        if count <= FACES {
            Ok(count)
        } else {
            Err(TooSmall::Faces(count))
        }
    }
}

impl<const FACES: usize, const SPLITS: usize> Default for DepthSort<FACES, SPLITS> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth, const FACES: usize, const SPLITS: usize> NewMethod<D> for DepthSort<FACES, SPLITS> {
    const NEW: Self = Self::new();
}

impl<D: DepthWidth, const FACES: usize, const SPLITS: usize> Method<D> for DepthSort<FACES, SPLITS> {
    const PAINTS_FROM_BACK: bool = true;

    fn check<S, H, F>(&mut self, faces: &F, window: &Window) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        self.collect(faces, window).map(|_| ())
    }

    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        // Not all of so many meet the window.
        if faces.most_nodes() > FACES {
            self.collect(faces, window)?;
        }
        let top = paint_disjoint_rows(faces, window, painter);
        add(&mut self.counters.disjoint_rows, (top - window.top) as u32);
        let rest = &Window { top, ..*window };
        if rest.is_empty() {
            return Ok(());
        }
        // No more faces than in the whole window, for which there is room.
        let count = self.collect(faces, rest)?;
        let nodes = self.nodes.get_mut(..count).unwrap_or_default();
        shell_sort(nodes, |node| from_back(faces, *node));
        let waiting = Waiting::new(&mut self.nodes, count, &mut self.conditions);
        Sort::new(faces, rest, waiting, &mut self.counters).paint_all(painter);
        Ok(())
    }
}
