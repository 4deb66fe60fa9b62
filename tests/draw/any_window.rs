//! Closed shapes in any window: one-row bands, bands of several rows, the whole frame, a wrapped display and any part of
//! the window show the same picture, and a display is given each pixel once.

use core::convert::Infallible;

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Arc, Circle, CornerRadii, Ellipse, Rectangle, RoundedRectangle, Sector},
};
use proptest::prelude::*;
use zrow::{
    band::{Generic, Target},
    draw::{DrawOn, PrimitiveStyle, StrokeAlignment, ThinCircle},
};

use crate::common::{
    by_depth, cases, config, encloses,
    hostile::{ALIGNMENTS, View, any_corners, any_length, any_style, any_view, style},
    is_quick, picture,
};

/// A display with memory, which takes nothing outside of it, and each pixel once.
struct Display {
    area: Rectangle,
    colors: Vec<Option<Rgb565>>,
    what: String,
}

impl Dimensions for Display {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Display {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(point, color) in pixels {
            assert!(encloses(&self.area, point), "{point} is outside, {}", self.what);
            let row = point.y.abs_diff(self.area.top_left.y) as usize;
            let column = point.x.abs_diff(self.area.top_left.x) as usize;
            let pixel = &mut self.colors[row * self.area.size.width as usize + column];
            assert_eq!(pixel.replace(color), None, "{point} is drawn twice, {}", self.what);
        }
        Ok(())
    }
}

#[derive(Debug, Copy, Clone)]
enum Shape {
    Rectangle(Rectangle),
    Circle(Circle),
    Ellipse(Ellipse),
    Rounded(RoundedRectangle),
    Arc(Arc),
    Sector(Sector),
    Thin(ThinCircle),
}

impl Shape {
    fn draw<T: Target<Color = Rgb565, Error = Infallible>>(&self, style: &PrimitiveStyle<Rgb565>, target: &mut T) {
        let Ok(()) = match self {
            Self::Rectangle(shape) => shape.into_styled(*style).draw_on(target),
            Self::Circle(shape) => shape.into_styled(*style).draw_on(target),
            Self::Ellipse(shape) => shape.into_styled(*style).draw_on(target),
            Self::Rounded(shape) => shape.into_styled(*style).draw_on(target),
            Self::Arc(shape) => shape.into_styled(*style).draw_on(target),
            Self::Sector(shape) => shape.into_styled(*style).draw_on(target),
            Self::Thin(shape) => shape.into_styled(*style).draw_on(target),
        };
    }

    fn on_band(&self, style: &PrimitiveStyle<Rgb565>, window: Rectangle) -> Vec<Rgb565> {
        picture(window, |band| self.draw(style, band))
    }

    fn on_display(&self, style: &PrimitiveStyle<Rgb565>, window: Rectangle) -> Vec<Rgb565> {
        let mut display = Display {
            area: window,
            colors: vec![None; (window.size.width * window.size.height) as usize],
            what: format!("{self:?} in {style:?} in {window:?}"),
        };
        self.draw(style, &mut Generic(&mut display));
        let color = |color: Option<Rgb565>| color.unwrap_or(Rgb565::BLACK);
        display.colors.into_iter().map(color).collect()
    }

    /// Compares what parts of a window show with the whole; `cut` is where the window is cut apart.
    fn check(&self, style: &PrimitiveStyle<Rgb565>, window: Rectangle, cut: Point) {
        let whole = self.on_band(style, window);
        let same = |drawn: &[Rgb565], part: Rectangle, on: &str| {
            let columns = part.top_left.x.abs_diff(window.top_left.x) as usize;
            let rows = part.top_left.y.abs_diff(window.top_left.y) as usize;
            let width = part.size.width as usize;
            for (row, drawn) in drawn.chunks(width.max(1)).enumerate() {
                let first = (rows + row) * window.size.width as usize + columns;
                let what = || format!("row {row} of {part:?} of {window:?} on a {on}: {self:?} in {style:?}");
                assert_eq!(drawn, &whole[first..first + width], "{}", what());
            }
        };
        same(&self.on_display(style, window), window, "display");
        let Size { width, height } = window.size;
        for rows in [1, 2, 5, cut.y as u32] {
            for first in (0..height).step_by(rows as usize) {
                let corner = window.top_left + Point::new(0, first as i32);
                let part = Rectangle::new(corner, Size::new(width, rows.min(height - first)));
                same(&self.on_band(style, part), part, "band");
            }
        }
        // Four parts around one point.
        for (x, columns) in [(0, cut.x as u32), (cut.x, width - cut.x as u32)] {
            for (y, rows) in [(0, cut.y as u32), (cut.y, height - cut.y as u32)] {
                let part = Rectangle::new(window.top_left + Point::new(x, y), Size::new(columns, rows));
                same(&self.on_band(style, part), part, "band");
                same(&self.on_display(style, part), part, "display");
            }
        }
    }
}

#[derive(Debug, Copy, Clone)]
enum Kind {
    Rectangle,
    Circle,
    Ellipse,
    Rounded,
    Arc,
    Sector,
    Thin,
}

const KINDS: [Kind; 7] = [
    Kind::Rectangle,
    Kind::Circle,
    Kind::Ellipse,
    Kind::Rounded,
    Kind::Arc,
    Kind::Sector,
    Kind::Thin,
];

/// What shapes are made of. Those that are round have the width as their diameter, or their radius.
#[derive(Debug, Copy, Clone)]
struct Parts {
    size: Size,
    corners: CornerRadii,
    /// Start and sweep in degrees.
    angles: [f32; 2],
}

impl Parts {
    fn shape(&self, kind: Kind, corner: Point) -> Shape {
        let Size { width, height } = self.size;
        let rectangle = Rectangle::new(corner, Size::new(width, height));
        let [start, sweep] = self.angles.map(|degrees| degrees.deg());
        match kind {
            Kind::Rectangle => Shape::Rectangle(rectangle),
            Kind::Circle => Shape::Circle(Circle::new(corner, width)),
            Kind::Ellipse => Shape::Ellipse(Ellipse::new(corner, rectangle.size)),
            Kind::Rounded => Shape::Rounded(RoundedRectangle::new(rectangle, self.corners)),
            Kind::Arc => Shape::Arc(Arc::new(corner, width, start, sweep)),
            Kind::Sector => Shape::Sector(Sector::new(corner, width, start, sweep)),
            Kind::Thin => {
                let center = |start: i32| start.saturating_add_unsigned(width.min(i32::MAX as u32));
                Shape::Thin(ThinCircle::new(Point::new(center(corner.x), center(corner.y)), width))
            }
        }
    }

    /// A shape that shows its border in a window.
    fn shape_in_view(&self, kind: Kind, view: &View, style: &PrimitiveStyle<Rgb565>) -> (Rectangle, Shape) {
        let (size, outside) = match kind {
            Kind::Rectangle | Kind::Ellipse | Kind::Rounded => (self.size, style.outside_stroke_width()),
            Kind::Circle | Kind::Arc | Kind::Sector => (Size::new_equal(self.size.width), style.outside_stroke_width()),
            Kind::Thin => (Size::new_equal(2 * self.size.width.min(i32::MAX as u32) + 1), 0),
        };
        let radius = match kind {
            Kind::Rectangle => Size::zero(),
            Kind::Rounded => view.radius_of(&self.corners),
            _ => size / 2,
        };
        let (window, corner) = view.position(size, radius, outside);
        (window, self.shape(kind, corner))
    }
}

proptest! {
    #![proptest_config(config(cases(300, 2_500)))]

    #[test]
    fn small_shapes_are_the_same_in_any_window(
        corner in (-4..8i32, -4..8i32),
        (width, height) in (0..24u32, 0..24u32),
        corners in any_corners(0..30u32),
        style in any_style(0..9u32),
        angles in prop::array::uniform2(-400.0..400.0f32),
        cut in (1..30i32, 1..30i32),
    ) {
        let window = Rectangle::new(Point::new(-9, -9), Size::new(41, 40));
        let parts = Parts { size: Size::new(width, height), corners, angles };
        for kind in KINDS {
            parts.shape(kind, corner.into()).check(&style, window, cut.into());
        }
    }

    #[test]
    fn shapes_of_any_size_are_the_same_in_any_window(
        (width, height) in (any_length(), any_length()),
        corners in any_corners(any_length()),
        style in any_style(any_length()),
        angles in prop::array::uniform2(-400.0..400.0f32),
        view in any_view(),
        cut in (1..40i32, 1..36i32),
    ) {
        let parts = Parts { size: Size::new(width, height), corners, angles };
        for kind in KINDS {
            let (window, shape) = parts.shape_in_view(kind, &view, &style);
            shape.check(&style, window, cut.into());
        }
    }
}

/// Rounded rectangles of which narrow boxes and high radii leave little.
#[test]
fn all_small_rounded_rectangles_are_the_same_in_any_window() {
    let lengths = |most: u32| (0..=most).flat_map(move |width| (0..=12).map(move |height| Size::new(width, height)));
    for size in lengths(if is_quick() { 2 } else { cases(2, 5) }) {
        let window = Rectangle::new(Point::new(-1, -1), size + Size::new(7, 7));
        for radius in lengths(8).step_by(by_depth(7, 1, 1)) {
            for (stroke_width, alignment) in [(0, 0), (1, 0), (1, 2), (2, 1), (3, 2)] {
                let style = style((true, stroke_width != 1), stroke_width, ALIGNMENTS[alignment]);
                let rectangle = Rectangle::new(Point::new(2, 2), size);
                let rounded = RoundedRectangle::with_equal_corners(rectangle, radius);
                Shape::Rounded(rounded).check(&style, window, Point::new(3, 3));
                let mut corners = rounded.corners;
                corners.top_left = Size::new(radius.height, radius.width);
                let rounded = RoundedRectangle::new(rectangle, corners);
                Shape::Rounded(rounded).check(&style, window, Point::new(2, 4));
            }
        }
    }
}

#[test]
fn thin_circles_beyond_the_largest_are_the_largest() {
    let stroke = style((true, false), 1, StrokeAlignment::Inside);
    let both = style((true, true), 1, StrokeAlignment::Inside);
    let window = Rectangle::new(Point::zero(), Size::new(64, 48));
    for center in [
        (32, i32::MAX),
        (i32::MAX, 24),
        (32, i32::MIN + 1),
        (i32::MIN, i32::MIN),
        (0, 0),
    ] {
        let largest = Shape::Thin(ThinCircle::new(center.into(), i32::MAX as u32));
        for radius in [1 << 31, (1 << 31) + 1, u32::MAX - 1, u32::MAX] {
            let circle = Shape::Thin(ThinCircle::new(center.into(), radius));
            for style in [stroke, both] {
                assert_eq!(
                    circle.on_band(&style, window),
                    largest.on_band(&style, window),
                    "{circle:?}"
                );
                circle.check(&style, window, Point::new(7, 11));
            }
        }
    }
    // The upper end of the circle is level over so few columns.
    let circle = Shape::Thin(ThinCircle::new(Point::new(32, i32::MAX), u32::MAX));
    let drawn = circle.on_band(&stroke, window);
    let painted = drawn.iter().filter(|color| **color != Rgb565::BLACK).count();
    assert_eq!(painted, 64);
}
