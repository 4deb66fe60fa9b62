//! The edges of filled polygons and paths as words of a pool that the caller lends, which live from row to row and from frame to
//! frame.
//!
//! ```text
//!        o  0            contours are cut into y-monotone chains; each is a word that says how many edges it has, in which
//!     A / \ B            direction the contour runs along it, and which chain begins next below it, and then its corners
//!      o   \   1         from the top to the bottom:
//!      |    o  2
//!      o   /   3         | header | A: 3 edges, down | 0 | 1 | 3 | 4 | B: 2 edges, up | 0 | 2 | 4 | active | active |
//!       \ /
//!        o  4            a chain crosses each row of pixel centres that it passes exactly once: there is room for as many
//!                        active edges as one row has chains
//! ```
//!
//! An edge is set up when the row comes in which it begins, and takes the place of the one above it in its chain. A corner takes 4
//! bytes where all corners are within 32,767 units of the first one's pixel, or else 8.
//!
//! Guarantees: the pixels of [`PreparedShape`](crate::draw::PreparedShape) by the top-left rule, each once. Cost of a row: an addition
//! and a comparison for each edge that crosses it; where an edge begins one or two divisions, and a look at each active edge.
//!
//! Source: the active edge table (Wylie, Romney, Evans and Erdahl 1967) over y-monotone chains (FreeType, Turner 1996).

mod rows;
mod store;
mod stored;

pub(crate) use rows::{Cursor, enter};
pub(crate) use store::{ContourEdges, store};
pub(crate) use stored::{StoredChains, translate};
