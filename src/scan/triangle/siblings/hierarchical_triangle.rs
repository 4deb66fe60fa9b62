//! A triangle by blocks of 8 x 8 pixels: whole blocks are accepted or rejected by a corner, and only what an edge crosses
//! is walked pixel by pixel (Greene 1996, "Hierarchical Polygon Tiling with Coverage Masks", SIGGRAPH; the walk by tiles:
//! McCormack and McNamara 2000, "Tiled Polygon Traversal Using Half-Plane Edge Functions", Graphics Hardware).
//!
//! An edge function is largest in one corner of a block and smallest in the opposite one. Where the largest value is
//! negative, the block has no pixel; where the smallest values of all three are not, it has all.
//!
//! Guarantees: the pixels of [`Polygons::scanline`](crate::scan::Polygons::scanline), any order of the vertices; exact
//! for all vertices in the domain of `S` and any window, in 32 bits a pixel at either precision. A vertex beyond the
//! domain, which no constructor makes, gives a triangle without pixels. The eight rows of a row of blocks are collected, so
//! that spans come in the order of rows.
//!
//! Take it for large triangles and slivers without a division, and where blocks are skipped for another reason too (a
//! coarse depth buffer). For spans alone a scan line is cheaper: it does not ask about the inside at all.

use crate::{
    geometry::{SubPixel, SubPoint, Window},
    scan::{
        polygon::Polygons,
        triangle::siblings::edge_function::{EdgeFunctions, LocalEdge},
    },
    surface::Span,
};

/// Pixels along a side of a block.
const BLOCK: i32 = 8;

impl Polygons {
    /// Hands over the visible spans of a triangle, top to bottom, by blocks of 8 x 8 pixels that are accepted or rejected as a
    /// whole. A row is one span; where a triangle is thousands of pixels wide, one for each part of its columns.
    ///
    /// The pixels are those of [`Polygons::scanline`](crate::scan::Polygons::scanline), in any order of the vertices.
    ///
    /// Cost: a dozen additions and comparisons a block of the bounding box, up to the first block beyond the triangle in each
    /// row of blocks; in crossed blocks, three additions a pixel.
    /// Source: Greene 1996; McCormack and McNamara 2000.
    ///
    /// # Errors
    /// The first error that `emit` returns.
    pub fn hierarchical_triangle<S: SubPixel, E>(
        vertices: [SubPoint<S>; 3],
        window: &Window,
        mut emit: impl FnMut(Span) -> Result<(), E>,
    ) -> Result<(), E> {
        let Some(triangle) = EdgeFunctions::visible(vertices, window) else {
            return Ok(());
        };
        triangle.bands::<S, E>(|band, mut edges| {
            let reach = edges.map(|edge| Reach::of(&edge));
            let mut top = band.top;
            while top < band.bottom {
                let rows = row_of_blocks(band.left, band.right, edges, &reach);
                for ((start, end), y) in rows.into_iter().zip(top..band.bottom) {
                    if start < end {
                        emit(Span::new(y, start, end))?;
                    }
                }
                top = top.saturating_add(BLOCK);
                edges = edges.map(|edge| edge.moved(0, BLOCK));
            }
            Ok(())
        })
    }
}

/// How far an edge function changes within a block of 8 x 8 pixels, from its value in the upper left pixel.
#[derive(Copy, Clone)]
struct Reach {
    /// The change up to the corner in which the edge function is largest: 0 or more.
    up: i32,
    /// The change down to the corner in which the edge function is smallest: 0 or less.
    down: i32,
}

impl Reach {
    fn of(edge: &LocalEdge) -> Self {
        // Fits: the margin of a band is as wide as a block.
        let last = BLOCK - 1;
        let (along, down) = (edge.x_step * last, edge.y_step * last);
        Self {
            up: along.max(0) + down.max(0),
            down: along.min(0) + down.min(0),
        }
    }
}

/// Whether no pixel, every pixel or some pixels of a block of 8 x 8 pixels are in a triangle.
enum Cover {
    Nothing,
    Everything,
    Something,
}

impl Cover {
    /// The cover of a block, from the edge functions in its first pixel and how far they change over a block. `Something` too
    /// where each edge alone leaves some pixels, but all edges together leave none.
    #[inline]
    fn of(edges: &[LocalEdge; 3], reach: &[Reach; 3]) -> Self {
        let extreme = |corner: fn(&Reach) -> i32| {
            let values = edges.iter().zip(reach);
            values.fold(0, |signs, (edge, reach)| signs | (edge.value + corner(reach)))
        };
        if extreme(|reach| reach.up) < 0 {
            Self::Nothing
        } else if extreme(|reach| reach.down) >= 0 {
            Self::Everything
        } else {
            Self::Something
        }
    }
}

/// For each of the eight rows of a block the first column in the triangle and the one after the last; reversed where a row has
/// none.
type BlockRuns = [(i32, i32); BLOCK as usize];

/// The runs of eight rows, from blocks left to right.
fn row_of_blocks(left: i32, right: i32, mut edges: [LocalEdge; 3], reach: &[Reach; 3]) -> BlockRuns {
    let mut rows = [(right, left); BLOCK as usize];
    let mut met = false;
    let mut x = left;
    while x < right {
        let end = x.saturating_add(BLOCK).min(right);
        match Cover::of(&edges, reach) {
            // A triangle has no gaps: right of its last block there is none.
            Cover::Nothing if met => break,
            Cover::Nothing => {}
            Cover::Everything => {
                met = true;
                for row in &mut rows {
                    *row = (row.0.min(x), end);
                }
            }
            Cover::Something => met |= walk_block(&mut rows, x, end, edges),
        }
        x = end;
        edges = edges.map(|edge| edge.moved(BLOCK, 0));
    }
    rows
}

/// Adds the pixels of a crossed block to the runs; returns whether there are any.
fn walk_block(rows: &mut BlockRuns, left: i32, right: i32, mut edges: [LocalEdge; 3]) -> bool {
    let mut met = false;
    for row in rows {
        let [mut a, mut b, mut c] = edges.map(|edge| edge.value);
        let [a_step, b_step, c_step] = edges.map(|edge| edge.x_step);
        for x in left..right {
            if (a | b | c) >= 0 {
                *row = (row.0.min(x), x + 1);
                met = true;
            }
            a += a_step;
            b += b_step;
            c += c_step;
        }
        edges = edges.map(|edge| edge.moved(0, 1));
    }
    met
}
