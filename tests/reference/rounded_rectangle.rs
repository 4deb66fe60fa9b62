//! The pixels of a rounded rectangle by their definition: those of the rectangle that no corner's quarter of an ellipse
//! cuts off, in exact numbers.

use embedded_graphics::{
    prelude::*,
    primitives::{CornerRadii, RoundedRectangle},
};
use zrow::draw::{PrimitiveStyle, StrokeAlignment};

use super::{
    box_axis::Axis,
    wide_product::{product, sum},
};

/// A rounded rectangle whose radii are confined.
#[derive(Debug, Copy, Clone)]
struct Rounded {
    columns: Axis,
    rows: Axis,
    /// Width and height of the radius at the top left, top right, bottom right and bottom left.
    radii: [[u128; 2]; 4],
}

impl Rounded {
    fn new(columns: Axis, rows: Axis, corners: CornerRadii, change: impl Fn(u32) -> u32) -> Self {
        let CornerRadii {
            top_left,
            top_right,
            bottom_right,
            bottom_left,
        } = corners;
        let radii = [top_left, top_right, bottom_right, bottom_left]
            .map(|radius| [radius.width, radius.height].map(|length| u128::from(change(length))));
        let radii = confined(radii, [columns.length, rows.length].map(|length| length as u128));
        Self { columns, rows, radii }
    }

    /// The shape with the outside of its stroke, and without the inside of it.
    fn areas<C: PixelColor>(shape: &RoundedRectangle, style: &PrimitiveStyle<C>) -> [Self; 2] {
        let (outside, inside) = match style.stroke_alignment {
            StrokeAlignment::Inside => (0, style.stroke_width),
            StrokeAlignment::Center => (style.stroke_width / 2, style.stroke_width.div_ceil(2)),
            StrokeAlignment::Outside => (style.stroke_width, 0),
        };
        let (Point { x, y }, Size { width, height }) = (shape.rectangle.top_left, shape.rectangle.size);
        let (columns, rows) = (Axis::new(x, width), Axis::new(y, height));
        [
            Self::new(
                columns.grown(x, outside),
                rows.grown(y, outside),
                shape.corners,
                |length| length.saturating_add(outside),
            ),
            Self::new(columns.shrunk(inside), rows.shrunk(inside), shape.corners, |length| {
                length.saturating_sub(inside)
            }),
        ]
    }

    fn contains(&self, pixel: Point) -> bool {
        let ([left, right], [top, bottom]) = (
            self.columns.distances_from_ends(pixel.x),
            self.rows.distances_from_ends(pixel.y),
        );
        let is_in_box = [left, right, top, bottom].into_iter().all(|distance| distance >= 0);
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let cuts = |(&from_corner, radius)| is_cut_off(from_corner, radius);
        is_in_box && !corners.iter().zip(self.radii).any(cuts)
    }
}

/// A rounded rectangle in a style.
#[derive(Debug, Copy, Clone)]
pub struct StyledRounded<C: PixelColor> {
    outer: Option<Rounded>,
    inner: Rounded,
    style: PrimitiveStyle<C>,
}

impl<C: PixelColor> StyledRounded<C> {
    pub fn new(shape: &RoundedRectangle, style: PrimitiveStyle<C>) -> Self {
        let [outer, inner] = Rounded::areas(shape, &style);
        let is_stroked = style.stroke_width > 0 && style.stroke_color.is_some();
        Self {
            outer: is_stroked.then_some(outer),
            inner,
            style,
        }
    }

    /// The stroke is what the outer shape has and the inner one has not, the fill is what both have.
    pub fn color(&self, pixel: Point) -> Option<C> {
        let is_inside = self.inner.contains(pixel);
        match self.outer {
            Some(outer) if !outer.contains(pixel) => None,
            Some(_) if !is_inside => self.style.stroke_color,
            _ => self.style.fill_color.filter(|_| is_inside),
        }
    }
}

/// embedded-graphics' rule: where the radii of sides take more than the side has, all of them are scaled so that those of
/// the side with the largest overlap fit.
fn confined(radii: [[u128; 2]; 4], [width, height]: [u128; 2]) -> [[u128; 2]; 4] {
    let [top_left, top_right, bottom_right, bottom_left] = radii;
    let sides = [
        (top_left[0] + top_right[0], width),
        (top_right[1] + bottom_right[1], height),
        (bottom_left[0] + bottom_right[0], width),
        (top_left[1] + bottom_left[1], height),
    ];
    let overlap = |&(taken, side): &(u128, u128)| taken.saturating_sub(side);
    let largest = sides.iter().map(overlap).max().unwrap_or(0);
    match sides.iter().find(|side| overlap(side) == largest && largest > 0) {
        Some(&(taken, side)) => radii.map(|radius| radius.map(|length| length * side / taken)),
        None => radii,
    }
}

/// Whether a pixel of the corner's box is outside the ellipse `(dx / 2 width)^2 + (dy / 2 height)^2 < 1`, where distances
/// from the middle are doubled.
fn is_cut_off([x, y]: [i128; 2], [width, height]: [u128; 2]) -> bool {
    let (x, y) = (x as u128, y as u128);
    if x >= width || y >= height {
        return false;
    }
    let (dx, dy) = (2 * (width - x) - 1, 2 * (height - y) - 1);
    let square = |number: u128| product(number, number);
    sum(square(height * dx), square(width * dy)) >= square(2 * width * height)
}
