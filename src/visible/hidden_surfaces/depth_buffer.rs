//! The depth buffer: a depth for each pixel of the picture, and the face that has it.
//!
//! ```text
//!     faces, in any order          depths        owners
//!        /\                        . 7 . .       . A . .      Each face is drawn into the buffer as if it were alone. A pixel
//!       /A \___                    7 7 5 5       A A B B      that is nearer than what is there takes its place, of equally
//!      /____\B |                   7 7 7 5       A A A B      near ones that of the first face. When all faces are drawn,
//!        |_____|                   . . 5 5       . . B B      each pixel gets its colour, once.
//! ```
//!
//! Guarantees: the picture of the depth row, whatever the order of faces. Cost: a comparison for each pixel of each face, and
//! setting a face up again for each run of pixels that shows it.
//!
//! Source: Catmull 1974, "A Subdivision Algorithm for Computer Display of Curved Surfaces"; that colours are computed after all
//! comparisons: Deering and others 1988, "The triangle processor and normal vector shader".

use crate::{
    geometry::{TooSmall, Window},
    shade::Shading,
    surface::Span,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        active_face::ActiveFace,
        face_table::{FaceTable, NONE},
        hidden_surfaces::placed::{face_from_row, for_each_node, keep_nearer, paint_nodes},
        painter::Painter,
        visibility::{Method, NewMethod},
        work::Work,
    },
};

/// The depth buffer ([`Visibility`](crate::visible::Visibility)): a depth and a face for each of so many pixels, the most that are drawn at once. `D` is
/// the depth of the look. Take it where memory is plenty; it is what the other methods are compared with.
///
/// RAM: 4 bytes a pixel with depths of 16 bits, 6 with 32.
///
/// Source: Catmull 1974.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DepthBuffer<D, const PIXELS: usize> {
    depths: [D; PIXELS],
    nodes: [u16; PIXELS],
}

impl<D: DepthWidth, const PIXELS: usize> DepthBuffer<D, PIXELS> {
    /// A buffer in which nothing is drawn.
    pub const fn new() -> Self {
        Self {
            depths: [D::FARTHEST; PIXELS],
            nodes: [0; PIXELS],
        }
    }
}

impl<D: DepthWidth, const PIXELS: usize> Default for DepthBuffer<D, PIXELS> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth + 'static, const PIXELS: usize> NewMethod<D> for DepthBuffer<D, PIXELS> {
    const NEW: Self = Self::new();
}

impl<D: DepthWidth, const PIXELS: usize> Method<D> for DepthBuffer<D, PIXELS> {
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        let (width, height) = (window.width() as usize, window.height() as usize);
        let needed = width * height;
        let (Some(depths), Some(nodes)) = (self.depths.get_mut(..needed), self.nodes.get_mut(..needed)) else {
            return Err(TooSmall::Pixels(needed));
        };
        depths.fill(D::FARTHEST);
        nodes.fill(NONE);
        let mut buffer = Buffer { depths, nodes, window };
        for_each_node(faces, window, |node| {
            if let Some((face, row)) = face_from_row(faces, node, [window.left, window.top]) {
                buffer.draw_face(faces, face, row, painter);
            }
        });
        for (row, nodes) in (window.top..).zip(nodes.chunks(width.max(1))) {
            paint_nodes(painter, faces, [window.left, row], 0, nodes);
        }
        Ok(())
    }
}

/// The depths and the faces of the pixels of a window, row by row.
struct Buffer<'b, D> {
    depths: &'b mut [D],
    nodes: &'b mut [u16],
    window: &'b Window,
}

impl<D: DepthWidth> Buffer<'_, D> {
    /// Draws the part of a face that lies in the window, from a row on.
    fn draw_face<S: ScreenPrecision, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        mut face: ActiveFace<S, H>,
        first_row: i32,
        painter: &mut impl Painter<S, H>,
    ) {
        for row in first_row..self.window.bottom {
            let span = face.next_span();
            self.draw_span(faces, &face, row, span, painter);
            if !face.leave_row(row) {
                return;
            }
        }
    }

    /// Draws the part of a span of a face that lies in the window.
    fn draw_span<S: ScreenPrecision, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        face: &ActiveFace<S, H>,
        row: i32,
        span: [i32; 2],
        painter: &mut impl Painter<S, H>,
    ) {
        let width = self.window.width() as i32;
        let [start, end] = span.map(|column| column.max(0).min(width));
        painter.report(|| Work::Tested {
            face: faces.order(face.node).into(),
            span: Span::new(row, self.window.left + start, self.window.left + end.max(start)),
        });
        let first = (row - self.window.top) as usize * width as usize;
        let pixels = first + start as usize..first + end as usize;
        if let (Some(depths), Some(nodes)) = (self.depths.get_mut(pixels.clone()), self.nodes.get_mut(pixels)) {
            keep_nearer(faces, face, [start, row], (depths, nodes));
        }
    }
}
