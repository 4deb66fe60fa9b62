//! Every way to fill a polygon or a triangle, and every test of a point, by the registry, held against winding numbers.

use std::convert::Infallible;

use embedded_graphics::{prelude::*, primitives::Rectangle};
use zrow::{
    band::Span,
    geometry::{SubPixel, SubPoint, Vertex, Window},
    scan::{FillRule, Location, Polygons},
};

use crate::reference::winding_numbers::{Units, edges, filled_pixels, location};

pub const RULES: [FillRule; 2] = [FillRule::EvenOdd, FillRule::NonZero];

/// Row and column of each pixel, row by row.
pub type Pixels = Vec<(i32, i32)>;

/// Collects spans: each of them has pixels, and they come top to bottom and left to right without a pixel twice.
pub fn collected(window: &Window, fill: impl FnOnce(&mut dyn FnMut(Span) -> Result<(), Infallible>)) -> Pixels {
    let mut pixels = Pixels::new();
    fill(&mut |span| {
        assert!(span.start < span.end, "{span:?}");
        assert!(
            window.left <= span.start && span.end <= window.right,
            "{span:?} leaves {window:?}"
        );
        assert!(
            window.top <= span.y && span.y < window.bottom,
            "{span:?} leaves {window:?}"
        );
        if let Some(&(y, x)) = pixels.last() {
            assert!((y, x) < (span.y, span.start), "{span:?} after ({x}, {y})");
        }
        pixels.extend((span.start..span.end).map(|x| (span.y, x)));
        Ok(())
    });
    pixels
}

fn by_edge_table<V: Vertex>(contours: &[&[V]], rule: FillRule, window: &Window) -> Pixels {
    collected(window, |emit| {
        Polygons::scanline::<_, _, 1200>(contours, rule, window, emit).unwrap()
    })
}

/// Every way to fill a polygon, by name.
fn fills<V: Vertex>(contours: &[&[V]], rule: FillRule, window: &Window) -> Vec<(&'static str, Pixels)> {
    macro_rules! by_table {
        ($([$name:ident] [$($fill:tt)+])+) => {
            vec![$((
                stringify!($name),
                collected(window, |emit| $($fill)+::<_, _, 1200>(contours, rule, window, emit).unwrap()),
            )),+]
        };
    }
    macro_rules! by_test {
        ($([$name:ident] [$($test:tt)+])+) => {
            [$((
                stringify!($name),
                collected(window, |emit| {
                    let Ok(()) = Polygons::brute_force(contours, rule, window, $($test)+, emit);
                }),
            )),+]
        };
    }
    let mut fills = zrow_methods::polygon_fills!(by_table);
    fills.extend(zrow_methods::point_tests!(by_test));
    fills
}

/// Every test of a point, by name.
fn locations<V: Vertex>(contours: &[&[V]], rule: FillRule, point: &V) -> Vec<(&'static str, Location)> {
    macro_rules! located {
        ($([$name:ident] [$($test:tt)+])+) => {
            vec![$((stringify!($name), $($test)+(contours, rule, point))),+]
        };
    }
    zrow_methods::point_tests!(located)
}

/// Every way to fill a triangle, by name.
pub fn triangle_fills<S: SubPixel>(vertices: [SubPoint<S>; 3], window: &Window) -> Vec<(&'static str, Pixels)> {
    macro_rules! filled {
        ($([$name:ident] [$($fill:tt)+])+) => {
            [$((
                stringify!($name),
                collected(window, |emit| {
                    let Ok(()) = $($fill)+(vertices, window, emit);
                }),
            )),+]
        };
    }
    let mut fills = vec![("edge table", by_edge_table(&[&vertices], FillRule::EvenOdd, window))];
    fills.extend(zrow_methods::triangles!(filled));
    fills
}

/// A vertex made of units.
pub trait Snapped: Vertex {
    fn of(units: Units) -> Self;
}

impl Snapped for Point {
    fn of((x, y): Units) -> Self {
        Self::new(x, y)
    }
}

impl<S: SubPixel> Snapped for SubPoint<S> {
    fn of((x, y): Units) -> Self {
        Self::from_units(x, y).unwrap()
    }
}

/// The window as it is, one row of it, and one pixel.
fn windows(window: Window) -> [Window; 3] {
    let row = Window {
        top: window.top + 17,
        bottom: window.top + 18,
        ..window
    };
    let pixel = Window {
        left: window.left + 21,
        right: window.left + 22,
        ..row
    };
    [window, row, pixel]
}

/// Compares every way to fill a polygon, in a window and in parts of it, by both rules.
pub fn check<V: Snapped>(contours: &[Vec<Units>], window: Window) {
    let points: Vec<Vec<V>> = contours
        .iter()
        .map(|contour| contour.iter().map(|&units| V::of(units)).collect())
        .collect();
    let slices: Vec<&[V]> = points.iter().map(Vec::as_slice).collect();
    for window in windows(window) {
        for rule in RULES {
            let expected = filled_pixels(contours, V::FRACTION_BITS, rule, &window);
            for (name, pixels) in fills(&slices, rule, &window) {
                assert_eq!(pixels, expected, "{name}, {rule:?}: {contours:?} in {window:?}");
            }
        }
    }
}

/// Asks for points all over a window, for all vertices and the middles of all edges.
pub fn check_locations<V: Snapped>(contours: &[Vec<Units>], positions: impl Iterator<Item = Units>) {
    let points: Vec<Vec<V>> = contours
        .iter()
        .map(|contour| contour.iter().map(|&units| V::of(units)).collect())
        .collect();
    let slices: Vec<&[V]> = points.iter().map(Vec::as_slice).collect();
    let middle = |a: i128, b: i128| ((a + b) / 2) as i32;
    let middles = edges(contours).map(|(from, to)| (middle(from.0, to.0), middle(from.1, to.1)));
    let vertices = contours.iter().flatten().copied();
    for position in positions.chain(vertices).chain(middles) {
        for rule in RULES {
            let expected = location(contours, rule, position);
            for (name, found) in locations(&slices, rule, &V::of(position)) {
                assert_eq!(found, expected, "{name}, {rule:?}: {position:?} in {contours:?}");
            }
        }
    }
}

/// Compares every way to fill a triangle, in a window and in parts of it, with its vertices in any order.
pub fn check_triangle<S: SubPixel>([a, b, c]: [Units; 3], window: Window) {
    for window in windows(window) {
        let expected = filled_pixels(&[vec![a, b, c]], S::FRACTION_BITS, FillRule::NonZero, &window);
        for order in [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
            for (name, pixels) in triangle_fills::<S>(order.map(SubPoint::of), &window) {
                assert_eq!(pixels, expected, "{name}: {order:?} in {window:?}");
            }
        }
    }
}

pub fn window() -> Window {
    Window::from(Rectangle::new(Point::new(-3, 5), Size::new(44, 38)))
}
