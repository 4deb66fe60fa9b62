//! `zrow::geometry`: numbers, points and windows, against the same in 128 bits.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};
use zrow::geometry::{ConvexWindow, FixedPointWindow, InputError, Sub4, Sub8, SubPixel, SubPoint, Window};

use crate::{
    target::{Case, Verdict},
    values::{ByHand, Count, Int, List, Stage, SubSpot},
};

/// Any rectangle.
#[derive(Debug, Copy, Clone, Arbitrary)]
struct AnyRectangle([Int; 2], [Count; 2]);

impl AnyRectangle {
    const fn get(self) -> Rectangle {
        let Self([x, y], [width, height]) = self;
        Rectangle::new(Point::new(x.0, y.0), Size::new(width.0, height.0))
    }
}

/// Any window, also one that is reversed.
#[derive(Debug, Copy, Clone, Arbitrary)]
struct AnyWindow([Int; 4]);

impl AnyWindow {
    const fn get(self) -> Window {
        let Self([left, top, right, bottom]) = self;
        Window {
            left: left.0,
            top: top.0,
            right: right.0,
            bottom: bottom.0,
        }
    }
}

/// The pixels of a rectangle from the first column to the last one, and rows too, in 128 bits; `None` without pixels.
fn sides(rectangle: &Rectangle) -> Option<[i128; 4]> {
    if rectangle.is_zero_sized() {
        return None;
    }
    let Rectangle { top_left, size } = rectangle;
    let (left, top) = (i128::from(top_left.x), i128::from(top_left.y));
    Some([
        left,
        top,
        left + i128::from(size.width) - 1,
        top + i128::from(size.height) - 1,
    ])
}

/// Windows and rectangles.
#[derive(Debug, Arbitrary)]
pub struct WindowCase {
    one: AnyWindow,
    other: AnyWindow,
    rectangle: AnyRectangle,
    point: [Int; 2],
}

impl Case for WindowCase {
    fn check(&self) -> Verdict {
        let (one, other) = (self.one.get(), self.other.get());
        let point = Point::new(self.point[0].0, self.point[1].0);
        for window in [one, other, Window::from(self.rectangle.get())] {
            let wide = [window.left, window.top, window.right, window.bottom].map(i128::from);
            let (width, height) = (wide[2] - wide[0], wide[3] - wide[1]);
            let is_empty = width <= 0 || height <= 0;
            ensure!(window.is_empty() == is_empty, "{window:?} is empty or not");
            let expected = if is_empty { (0, 0) } else { (width, height) };
            let found = (i128::from(window.width()), i128::from(window.height()));
            ensure!(found == expected, "{window:?} has {found:?} columns and rows");
            ensure!(
                is_empty || Window::from(window.to_rectangle()) == window,
                "{window:?} is another one as a rectangle"
            );
            ensure!(!window.contains(point) || !is_empty, "an empty window has a pixel");
        }
        let both = one.intersection(&other);
        let in_both = one.contains(point) && other.contains(point);
        ensure!(both.contains(point) == in_both, "{both:?} of both windows");
        ensure!(one.meets(&other) != both.is_empty(), "{one:?} meets {other:?} or not");
        let rectangle = self.rectangle.get();
        let window = Window::from(rectangle);
        let inside = sides(&rectangle).is_some_and(|[left, top, right, bottom]| {
            let (x, y) = (i128::from(point.x), i128::from(point.y));
            (left..=right).contains(&x) && (top..=bottom).contains(&y)
        });
        // The last column and row of all have no window.
        let is_last = point.x == i32::MAX || point.y == i32::MAX;
        ensure!(
            window.contains(point) == (inside && !is_last),
            "{window:?} of {rectangle:?}"
        );
        Ok(())
    }
}

/// Sub-pixel points and windows, in the domain and not.
#[derive(Debug, Arbitrary)]
pub struct SubPointCase {
    stage: Stage,
    units: [Int; 2],
    pixel: [Int; 2],
    window: AnyWindow,
    corners: [SubSpot; 2],
    point: SubSpot,
}

impl SubPointCase {
    fn check_at<S: ByHand>(&self) -> Verdict {
        let domain = S::MIN_UNITS..=S::MAX_UNITS;
        let [x, y] = self.units.map(|units| units.0);
        let fits = domain.contains(&x) && domain.contains(&y);
        match SubPoint::<S>::from_units(x, y) {
            Ok(point) => ensure!(
                fits && (point.x_units(), point.y_units()) == (x, y),
                "{point:?} of {x}, {y}"
            ),
            Err(error) => ensure!(!fits, "{error} for {x}, {y}"),
        }
        let [x, y] = self.pixel.map(|pixel| i64::from(pixel.0) << S::FRACTION_BITS);
        let is_inside = |units: i64| i32::try_from(units).is_ok_and(|units| domain.contains(&units));
        let pixel = Point::new(self.pixel[0].0, self.pixel[1].0);
        match SubPoint::<S>::from_pixel(pixel) {
            Ok(point) => ensure!(
                (i64::from(point.x_units()), i64::from(point.y_units())) == (x, y),
                "{point:?} of {pixel:?}"
            ),
            Err(error) => ensure!(!(is_inside(x) && is_inside(y)), "{error} for {pixel:?}"),
        }
        let window = self.window.get();
        let half = 1i64 << (S::FRACTION_BITS - 1);
        let made = [
            (FixedPointWindow::<S>::between_centers(&window), 0),
            (FixedPointWindow::over_areas(&window), half),
        ];
        for (found, margin) in made {
            let units = |pixel: i32| i64::from(pixel) << S::FRACTION_BITS;
            let one = 1i64 << S::FRACTION_BITS;
            let sides = [
                units(window.left) - margin,
                units(window.top) - margin,
                units(window.right) - one + margin,
                units(window.bottom) - one + margin,
            ];
            let fits = sides.into_iter().all(is_inside);
            ensure!(found.is_ok() == fits, "{found:?} of {window:?}");
            if let Ok(found) = found {
                let (first, last) = (found.top_left(), found.bottom_right());
                let corners = [first.x_units(), first.y_units(), last.x_units(), last.y_units()];
                ensure!(corners.map(i64::from) == sides, "{found:?} of {window:?}");
            }
        }
        let [first, last] = self.corners.map(|corner| corner.by_hand::<S>(&self.stage));
        if let Ok(window) = FixedPointWindow::new(first, last) {
            let point = self.point.by_hand::<S>(&self.stage);
            let is_between = |low: i32, middle: i32, high: i32| low <= middle && middle <= high;
            let inside = is_between(first.x_units(), point.x_units(), last.x_units())
                && is_between(first.y_units(), point.y_units(), last.y_units());
            ensure!(window.contains(&point) == inside, "{point:?} in {window:?}");
            ensure!(!(window.is_empty() && inside), "{window:?} is empty and has {point:?}");
        }
        Ok(())
    }
}

impl Case for SubPointCase {
    fn check(&self) -> Verdict {
        self.check_at::<Sub4>()?;
        self.check_at::<Sub8>()
    }
}

/// Corners that make a convex window or not.
#[derive(Debug, Arbitrary)]
pub struct ConvexWindowCase {
    stage: Stage,
    corners: List<SubSpot, 7>,
    point: SubSpot,
}

/// To which side of the way from `a` to `b` the point `c` lies: positive to its right on the display.
fn side([ax, ay]: [i128; 2], [bx, by]: [i128; 2], [cx, cy]: [i128; 2]) -> i128 {
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

fn units<S: SubPixel>(point: &SubPoint<S>) -> [i128; 2] {
    [point.x_units().into(), point.y_units().into()]
}

impl ConvexWindowCase {
    fn check_at<S: ByHand>(&self) -> Verdict {
        let corners = self.corners.0.iter().map(|corner| corner.by_hand::<S>(&self.stage));
        let corners: Vec<SubPoint<S>> = corners.collect();
        let places: Vec<_> = corners.iter().map(units).collect();
        let at = |index: usize| places[index % places.len()];
        let made = ConvexWindow::new(&corners);
        let Ok(window) = made else {
            ensure!(
                made != Err(InputError::TooFewCorners) || corners.len() < 3,
                "{} corners are too few",
                corners.len()
            );
            let domain = S::MIN_UNITS..=S::MAX_UNITS;
            let is_inside = corners
                .iter()
                .all(|corner| domain.contains(&corner.x_units()) && domain.contains(&corner.y_units()));
            ensure!(
                !matches!(made, Err(InputError::OutOfDomain { .. })) || !is_inside,
                "points of the domain are outside of it"
            );
            if let Err(InputError::StraightCorner { corner }) = made {
                ensure!(
                    side(at(corner + places.len() - 1), at(corner), at(corner + 1)) == 0,
                    "corner {corner} is straight"
                );
            }
            return Ok(());
        };
        // Every other corner lies on the same side of every side.
        let signs = (0..places.len()).flat_map(|first| {
            let sides = places
                .iter()
                .map(move |corner| side(at(first), at(first + 1), *corner).signum());
            sides.filter(|sign| *sign != 0)
        });
        let signs: Vec<_> = signs.collect();
        ensure!(
            signs.iter().all(|sign| *sign == signs[0]),
            "{corners:?} is taken for convex"
        );
        let point = self.point.by_hand::<S>(&self.stage);
        let inside = (0..places.len()).all(|first| side(at(first), at(first + 1), units(&point)) * signs[0] >= 0);
        ensure!(window.contains(point) == inside, "{point:?} in {corners:?}");
        ensure!(window.corners() == corners, "other corners");
        let in_bounds = corners.iter().all(|corner| window.bounds().contains(corner));
        ensure!(in_bounds, "a corner outside of the bounds");
        Ok(())
    }
}

impl Case for ConvexWindowCase {
    fn check(&self) -> Verdict {
        self.check_at::<Sub4>()?;
        self.check_at::<Sub8>()
    }
}
