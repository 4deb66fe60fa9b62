//! The edge functions of a triangle (Pineda 1988, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH), exact.
//!
//! An edge function is the cross product of an edge with the way from it to a pixel: positive on the inner side, 0 on the
//! edge. All pixel centres share the fraction of their units. So the fill rule comes first, as a bias of -1 where a pixel on
//! the edge does not belong, and then the fraction is shifted out: the sign stays right, and what is left moves from pixel
//! to pixel by the edge's own width and height (Giesen 2013, "Triangle rasterization in practice").
//!
//! Guarantees: 32-bit values, exact for all vertices in the domain and any window. [`Sub4`](crate::geometry::Sub4) is set
//! up in 32-bit products, [`Sub8`](crate::geometry::Sub8) in 64-bit ones. Where the value of an edge would outgrow 32 bits,
//! the window is walked in bands: in each the edge is either all on one side, or near enough to fit.

use core::{num::Wrapping, ops::Range};

use crate::{
    geometry::{SubPixel, SubPoint, Window},
    scan::polygon::{bisection::Bisection, pixel_bounds},
    surface::Span,
};

/// Pixels beyond the right and lower sides of a band where the values fit as well.
const MARGIN: u32 = 8;

/// A triangle with pixels in the window.
pub(crate) struct EdgeFunctions {
    /// The functions of the three edges, clockwise on the screen.
    pub(crate) edges: [EdgeFunction; 3],
    /// Twice the area, in square units, with the biases of the edges.
    pub(crate) whole: i64,
    /// The visible part of the bounding box.
    pub(crate) visible: Window,
}

impl EdgeFunctions {
    /// Sets a triangle up; `None` where no pixel is visible: without area, beyond the window, or with a vertex beyond
    /// the domain.
    pub(crate) fn visible<S: SubPixel>(vertices: [SubPoint<S>; 3], window: &Window) -> Option<Self> {
        let visible = pixel_bounds::visible(&[&vertices], window);
        if visible.is_empty() {
            return None;
        }
        let [a, b, c] = vertices.map(|vertex| in_domain(&vertex));
        let (a, b, c) = (a?, b?, c?);
        let area = EdgeFunction::between::<S>(a, b).unbiased_at::<S>(c);
        let (edges, area) = if area > 0 {
            ([(a, b), (b, c), (c, a)], area)
        } else {
            ([(a, c), (c, b), (b, a)], -area)
        };
        if area == 0 {
            return None;
        }
        let edges = edges.map(|(from, to)| EdgeFunction::between::<S>(from, to));
        let [bias_a, bias_b, bias_c] = edges.map(|edge| edge.bias());
        Some(Self {
            edges,
            whole: area + bias_a + bias_b + bias_c,
            visible,
        })
    }

    /// Walks the bands in which the values fit, top to bottom. Rows come in several bands only where the triangle is
    /// thousands of pixels in size and much of that is visible.
    pub(crate) fn bands<S: SubPixel, E>(
        &self,
        mut walk: impl FnMut(&Window, [LocalEdge; 3]) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut bands = Bisection::new(&self.visible);
        while let Some(band) = bands.next_band() {
            let [a, b, c] = self.edges.map(|edge| edge.over::<S>(&band));
            match (a, b, c) {
                (Range32::Fits(a), Range32::Fits(b), Range32::Fits(c)) => walk(&band, [a, b, c])?,
                (Range32::Outside, ..) | (_, Range32::Outside, _) | (.., Range32::Outside) => {}
                _ => {
                    bands.halve(&band);
                    continue;
                }
            }
            bands.done(&band, true);
        }
        Ok(())
    }
}

/// Column and row in units of a precision.
pub(super) type Units = (i32, i32);

/// The units of a vertex; `None` for one beyond the domain, which no constructor makes.
pub(super) fn in_domain<S: SubPixel>(vertex: &SubPoint<S>) -> Option<Units> {
    let (x, y) = (vertex.x_units(), vertex.y_units());
    SubPoint::<S>::from_units(x, y).is_ok().then_some((x, y))
}

/// The exact product; in 32 bits where all products of the precision fit.
fn product<S: SubPixel>(one: i32, other: i32) -> i64 {
    // Two differences of coordinates.
    let most = S::MAX_UNITS - S::MIN_UNITS;
    if most.checked_mul(most).is_some() {
        i64::from(one * other)
    } else {
        i64::from(one) * i64::from(other)
    }
}

/// An edge function: 0 or more for a pixel on the inner side of the edge, which belongs to the triangle.
#[derive(Copy, Clone)]
pub(crate) struct EdgeFunction {
    /// What a unit to the right adds, in square units.
    x_step: i32,
    /// What a unit downwards adds, in square units.
    y_step: i32,
    /// The value at the centre of pixel (0, 0), in square units, with the bias.
    at_origin: i64,
}

impl EdgeFunction {
    /// The function of an edge with the inside on its right hand. All numbers here are below 2^46.
    fn between<S: SubPixel>(from: Units, to: Units) -> Self {
        let edge = Self {
            x_step: from.1 - to.1,
            y_step: to.0 - from.0,
            at_origin: 0,
        };
        Self {
            at_origin: edge.bias() - product::<S>(edge.x_step, from.0) - product::<S>(edge.y_step, from.1),
            ..edge
        }
    }

    /// The top-left rule: a pixel on the edge belongs to a left one, which runs upwards, and to a level one at the top.
    fn bias(&self) -> i64 {
        let is_left = self.x_step > 0;
        let is_top = self.x_step == 0 && self.y_step > 0;
        if is_left || is_top { 0 } else { -1 }
    }

    /// The value at a point in units.
    fn unbiased_at<S: SubPixel>(&self, (x, y): Units) -> i64 {
        self.at_origin - self.bias() + product::<S>(self.x_step, x) + product::<S>(self.y_step, y)
    }

    /// The value at the centre of a pixel of the bounding box, in square units.
    pub(crate) fn at<S: SubPixel>(&self, x: i32, y: i32) -> i64 {
        self.at_origin
            + product::<S>(self.x_step, x << S::FRACTION_BITS)
            + product::<S>(self.y_step, y << S::FRACTION_BITS)
    }

    /// The edge function in a band and the margin around it, with the fraction shifted out.
    fn over<S: SubPixel>(&self, band: &Window) -> Range32 {
        let first = (self.at_origin >> S::FRACTION_BITS)
            + product::<S>(self.x_step, band.left)
            + product::<S>(self.y_step, band.top);
        // Below 2^15 pixels, 2^23 a step.
        let change = |step: i32, pixels: u32| i64::from(step) * i64::from(pixels + MARGIN);
        let (along, down) = (change(self.x_step, band.width()), change(self.y_step, band.height()));
        let lowest = first + along.min(0) + down.min(0);
        let highest = first + along.max(0) + down.max(0);
        if highest < 0 {
            return Range32::Outside;
        }
        if lowest >= 0 {
            return Range32::Fits(LocalEdge::default());
        }
        match (i32::try_from(first), i32::try_from(lowest), i32::try_from(highest)) {
            (Ok(value), Ok(_), Ok(_)) => Range32::Fits(LocalEdge {
                value,
                x_step: self.x_step,
                y_step: self.y_step,
            }),
            _ => Range32::TooLarge,
        }
    }
}

/// Whether an edge function fits 32 bits in every pixel of a band.
enum Range32 {
    /// The edge function is negative in the whole band, which is outside the triangle.
    Outside,
    /// The edge function fits 32 bits in the whole band.
    Fits(LocalEdge),
    /// The edge function is beyond 32 bits somewhere in the band.
    TooLarge,
}

/// An edge function in a band. It is 0 and stays 0 for an edge that no pixel of the band is beyond.
#[derive(Copy, Clone, Default)]
pub(crate) struct LocalEdge {
    /// The value at the first pixel; 0 or more for one that belongs to the shape.
    pub(crate) value: i32,
    /// What a pixel to the right adds.
    pub(crate) x_step: i32,
    /// What the edge function grows by from a row to the next.
    pub(crate) y_step: i32,
}

impl LocalEdge {
    /// The edge function as seen from a pixel further to the right and below, in the band or its margin. The sum fits,
    /// whatever wraps on the way.
    #[inline(always)]
    pub(crate) fn moved(self, columns: i32, rows: i32) -> Self {
        let along = Wrapping(self.x_step) * Wrapping(columns);
        let down = Wrapping(self.y_step) * Wrapping(rows);
        Self {
            value: (Wrapping(self.value) + along + down).0,
            ..self
        }
    }
}

/// The pixels of a row that are inside, asked from left to right up to the first one beyond: a triangle has one run a row.
#[inline(always)]
pub(crate) fn row_span(y: i32, columns: Range<i32>, mut is_inside: impl FnMut(i32) -> bool) -> Option<Span> {
    let right = columns.end;
    let mut columns = columns;
    let start = columns.find(|&x| is_inside(x))?;
    let end = columns.find(|&x| !is_inside(x)).unwrap_or(right);
    Some(Span::new(y, start, end))
}
