//! Antialiased outlines that live from row to row and from frame to frame, as words of a pool that the caller lends.
//!
//! ```text
//!        o  0            an outline is cut into y-monotone chains; each is a word that says how long it is, in which
//!     A / \ B            direction the outline runs along it, and which chain begins next below it, and then its corners:
//!      o   \   1
//!      |    o  2         | header | A: 4 corners, down | 0 | 1 | 3 | 4 | B: 3 corners, up | 4 | 2 | 0 |
//!      o   /   3
//!       \ /              a chain has one edge at the bottom of each row that it passes: that edge is kept, as an
//!        o  4            active edge, and the next row's segments are made from it
//! ```
//!
//! An edge is set up when the row comes in which it begins. A corner takes 4 bytes where all corners are within 127 pixels
//! of the first one, or else 8.
//!
//! Guarantees: the segments of a row are those of [`AntialiasedPolygon`](crate::draw::AntialiasedPolygon), and so is each
//! pixel's coverage. Cost of a row: an addition for each chain in it, besides what its method measures.
//!
//! Source: the active edge table (Wylie, Romney, Evans and Erdahl 1967) over y-monotone chains (FreeType, Turner 1996), which
//! here is kept between the rows of several outlines at once.

// Why small functions are `inline(always)` in `stored` and `rows`, and what they call in `outline_arc` and draws in
// `picture::kinds::outline`: with `inline` alone, the panel of instruments as a picture takes 6.2 % more instructions on a Cortex-M4,
// the cockpit 4.9 %.

mod chain_rows;
mod convex;
mod difference;
mod links;
mod memory;
mod monotone;
mod round;
mod row_edges;
mod rows;
mod simple;
mod store;
mod stored;
mod translate;

pub(crate) use chain_rows::ChainRows;
pub use difference::Common;
pub(crate) use difference::{EdgeSink, changed_edges};
pub use memory::AntialiasingMemory;
pub(crate) use memory::RowMemory;
pub(crate) use row_edges::most_edges;
pub(crate) use rows::Progress;
pub(crate) use store::{store, store_whole};
pub(crate) use stored::StoredOutline;
pub(crate) use translate::{check_moved, translate};
