//! Tile bins: the window in tiles of 16 x 16 pixels, each with a list of the faces that may meet it, and a depth buffer of one
//! tile.
//!
//! ```text
//!     +------+------+------+      First pass: each face is counted in the tiles that its box meets. Second pass: it is put
//!     | A    | A B  |   B  |      into their lists, which lie one after the other in one table:
//!     +------+------+------+
//!     | A    | A B C| B C  |         tile     1   2     3   4   5       6
//!     +------+------+------+         faces  | A | A B | B | A | A B C | B C |
//!
//!     Then tile after tile is drawn with the same small depth buffer, by edge functions that accept or reject blocks of
//!     8 x 8 pixels as a whole, and handed over when it is finished.
//! ```
//!
//! Guarantees: the picture of the depth row. Cost: two looks at each face and each tile of its box; its plane and its edge
//! functions are set up for each of them.
//!
//! Source: tiles with lists of faces: Fuchs and others 1989, "Pixel-Planes 5"; blocks by edge functions: Pineda 1988, "A parallel
//! algorithm for polygon rasterization", and McCormack and McNamara 2000, "Tiled polygon traversal using half-plane edge functions".

use core::ops::Range;

use crate::{
    geometry::{SubPoint, TooSmall, Window},
    scan::Polygons,
    shade::Shading,
    surface::Span,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_face::ActiveFace,
        face_table::{FaceTable, NONE, corners_from_top},
        hidden_surfaces::placed::{face_from_row, for_each_node, keep_nearer, paint_nodes},
        painter::Painter,
        visibility::{Method, NewMethod},
        work::Work,
    },
};

/// Pixels along a side of a tile.
const SIDE: i32 = 16;

/// Pixels of a tile.
const PIXELS: usize = (SIDE * SIDE) as usize;

/// Tile bins ([`Visibility`](crate::visible::Visibility)): at most so many tiles of 16 x 16 pixels, which the window that is drawn is cut into from its upper
/// left corner on, and so many faces in the lists of all of them together; a face is in the list of each tile that its box meets.
/// `D` is the depth of the look.
///
/// Take it for wide panels without memory for a depth buffer, or where tiles are handed out to several cores.
///
/// RAM: 2 bytes a tile, 2 a face in a list, and 1,024 with depths of 16 bits, 1,536 with 32.
///
/// Source: Fuchs and others 1989; Pineda 1988.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TileBins<D, const TILES: usize, const FACES: usize> {
    /// For each tile where its list ends in the table of lists, and the list of the next tile begins.
    ends: [u16; TILES],
    /// The lists of all tiles.
    nodes: [u16; FACES],
    tile: Tile<D>,
}

impl<D: DepthWidth, const TILES: usize, const FACES: usize> TileBins<D, TILES, FACES> {
    /// Bins in which nothing is drawn.
    pub const fn new() -> Self {
        const { assert!(FACES <= u16::MAX as usize, "lists of at most 65,535 faces") }
        Self {
            ends: [0; TILES],
            nodes: [0; FACES],
            tile: Tile {
                depths: [D::FARTHEST; PIXELS],
                nodes: [0; PIXELS],
            },
        }
    }

    /// Puts the faces into the lists of the tiles that their boxes meet.
    fn bin<S: ScreenPrecision, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        grid: &Grid<'_>,
    ) -> Result<(), TooSmall> {
        let tiles = grid.across * grid.down;
        let ends = self.ends.get_mut(..tiles).ok_or(TooSmall::Tiles(tiles))?;
        let mut needed = 0;
        ends.fill(0);
        grid.for_each(faces, |tile, _| {
            needed += 1;
            if let Some(count) = ends.get_mut(tile) {
                *count = count.saturating_add(1);
            }
        });
        if needed > FACES {
            return Err(TooSmall::TileFaces(needed));
        }
        // Counts become the starts of the lists, and these the ends as the lists are filled.
        let mut start = 0;
        for end in &mut *ends {
            (*end, start) = (start, start + *end);
        }
        let nodes = &mut self.nodes;
        grid.for_each(faces, |tile, node| {
            if let Some(end) = ends.get_mut(tile) {
                if let Some(entry) = nodes.get_mut(usize::from(*end)) {
                    *entry = node;
                    *end += 1;
                }
            }
        });
        Ok(())
    }
}

impl<D: DepthWidth, const TILES: usize, const FACES: usize> Default for TileBins<D, TILES, FACES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth + 'static, const TILES: usize, const FACES: usize> NewMethod<D> for TileBins<D, TILES, FACES> {
    const NEW: Self = Self::new();
}

impl<D: DepthWidth, const TILES: usize, const FACES: usize> Method<D> for TileBins<D, TILES, FACES> {
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        let grid = Grid::new(window);
        self.bin(faces, &grid)?;
        let (mut start, mut ends) = (0, self.ends.iter());
        for row in 0..grid.down {
            for (column, end) in (0..grid.across).zip(&mut ends) {
                let list = self.nodes.get(start..usize::from(*end)).unwrap_or_default();
                start = usize::from(*end);
                let area = grid.tile(column, row);
                painter.report(|| Work::Area {
                    window: area,
                    faces: list.len(),
                });
                self.tile.draw(faces, list, &area);
                self.tile.paint(faces, &area, painter, window.left);
            }
        }
        Ok(())
    }
}

/// A window in tiles, row by row.
struct Grid<'w> {
    window: &'w Window,
    across: usize,
    down: usize,
}

impl<'w> Grid<'w> {
    fn new(window: &'w Window) -> Self {
        let tiles = |pixels: u32| pixels.div_ceil(SIDE as u32) as usize;
        Self {
            window,
            across: tiles(window.width()),
            down: tiles(window.height()),
        }
    }

    /// The pixels of a tile.
    fn tile(&self, column: usize, row: usize) -> Window {
        let left = self.window.left + column as i32 * SIDE;
        let top = self.window.top + row as i32 * SIDE;
        Window {
            left,
            top,
            right: (left + SIDE).min(self.window.right),
            bottom: (top + SIDE).min(self.window.bottom),
        }
    }

    /// Visits each tile with each of the faces whose boxes meet it.
    fn for_each<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &self,
        faces: &impl FaceTable<S, D, H>,
        mut visit: impl FnMut(usize, u16),
    ) {
        for_each_node(faces, self.window, |node| {
            let Some(corners) = corners_from_top(faces, node) else {
                return;
            };
            let columns = tiles_between::<S>(corners.map(|corner| corner.x_units()), self.window.left, self.across);
            for row in tiles_between::<S>(corners.map(|corner| corner.y_units()), self.window.top, self.down) {
                for column in columns.clone() {
                    visit(row * self.across + column, node);
                }
            }
        });
    }
}

/// The columns or rows of tiles that a face may meet, by its coordinates, the side from which tiles count, and their number.
fn tiles_between<S: ScreenPrecision>([a, b, c]: [i32; 3], side: i32, tiles: usize) -> Range<usize> {
    let tile = |units: i32| ((units >> S::FRACTION_BITS) - side).div_euclid(SIDE);
    let limit = |tile: i32| (tile.max(0) as usize).min(tiles);
    limit(tile(a.min(b).min(c)))..limit(tile(a.max(b).max(c)) + 1)
}

/// The depths and the faces of the pixels of a tile, row by row.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Tile<D> {
    depths: [D; PIXELS],
    nodes: [u16; PIXELS],
}

impl<D: DepthWidth> Tile<D> {
    /// Draws the faces of a list into the cleared pixels of a tile.
    fn draw<S: ScreenPrecision, H: Shading>(&mut self, faces: &impl FaceTable<S, D, H>, list: &[u16], area: &Window) {
        self.depths.fill(D::FARTHEST);
        self.nodes.fill(NONE);
        for node in list {
            self.draw_face(faces, *node, area);
        }
    }

    /// Draws the part of a face that lies in the pixels of a tile.
    fn draw_face<S: ScreenPrecision, H: Shading>(&mut self, faces: &impl FaceTable<S, D, H>, node: u16, area: &Window) {
        let Some([a, b, c]) = corners_from_top(faces, node) else {
            return;
        };
        let point = |x, y| SubPoint::<S>::from_units(x, y).ok();
        let corners = (
            point(a.x_units(), a.y_units()),
            point(b.x_units(), b.y_units()),
            point(c.x_units(), c.y_units()),
        );
        let (Some(a), Some(b), Some(c)) = corners else {
            return;
        };
        let Some((face, _)) = face_from_row(faces, node, [area.left, area.top]) else {
            return;
        };
        let Ok(()) = Polygons::hierarchical_triangle([a, b, c], area, |span| {
            self.draw_span(faces, &face, &span, area);
            Ok::<(), core::convert::Infallible>(())
        });
    }

    /// Draws a span of a face that lies in the tile.
    fn draw_span<S: ScreenPrecision, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        face: &ActiveFace<S, H>,
        span: &Span,
        area: &Window,
    ) {
        let [start, end] = [span.start, span.end].map(|column| column - area.left);
        let first = (span.y - area.top) * SIDE;
        let pixels = (first + start) as usize..(first + end) as usize;
        if let (Some(depths), Some(nodes)) = (self.depths.get_mut(pixels.clone()), self.nodes.get_mut(pixels)) {
            keep_nearer(faces, face, [start, span.y], (depths, nodes));
        }
    }
}

impl<D: DepthWidth> Tile<D> {
    /// Hands over the pixels of a tile, in columns of a window that begins at `left`.
    fn paint<S: ScreenPrecision, H: Shading>(
        &self,
        faces: &impl FaceTable<S, D, H>,
        area: &Window,
        painter: &mut impl Painter<S, H>,
        left: i32,
    ) {
        for (row, nodes) in (area.top..area.bottom).zip(self.nodes.chunks_exact(SIDE as usize)) {
            let nodes = nodes.get(..area.width() as usize).unwrap_or_default();
            paint_nodes(painter, faces, [left, row], area.left - left, nodes);
        }
    }
}
