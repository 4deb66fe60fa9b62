//! `zrow::clip`: what is cut lies inside, and cutting it again changes nothing.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    primitives::{Circle, Rectangle},
};
use zrow::{
    clip::{Classification, Clipper, Operation, Segments},
    draw::FillRule,
    geometry::{ConvexWindow, FixedPointWindow, InputError, Sub4, Sub8, SubPixel, SubPoint, TooSmall, Window},
};

use crate::{
    exact,
    target::{Case, Verdict},
    values::{ByHand, Count, Int, Length, List, Spot, Stage, SubContours, SubSpot},
};

type Ends<S> = (SubPoint<S>, SubPoint<S>);

/// A segment against an upright window, by all that clip one.
#[derive(Debug, Arbitrary)]
pub struct SegmentCase {
    stage: Stage,
    ends: [SubSpot; 2],
    corners: [SubSpot; 2],
}

/// Whether an end is the nearest unit to a point of the segment: less than a unit beside it, on each axis.
fn is_on<S: SubPixel>(end: SubPoint<S>, (from, to): Ends<S>) -> bool {
    let units = |point: SubPoint<S>| [i128::from(point.x_units()), i128::from(point.y_units())];
    let ([ex, ey], [ax, ay], [bx, by]) = (units(end), units(from), units(to));
    let (dx, dy) = (bx - ax, by - ay);
    let cross = (ex - ax) * dy - (ey - ay) * dx;
    // Half a unit along each axis moves the cross product by at most half of both deltas.
    2 * cross.abs() <= dx.abs() + dy.abs()
}

impl SegmentCase {
    fn check_at<S: ByHand>(&self) -> Verdict {
        let [from, to] = self.ends.map(|end| end.by_hand::<S>(&self.stage));
        let [first, last] = self.corners.map(|corner| corner.inside::<S>(&self.stage));
        let window = FixedPointWindow::new(first, last).context("corners of the domain are outside of it")?;
        let default = Segments::liang_barsky(from, to, &window);
        macro_rules! clip_by_each {
            ($([$name:ident] [$($clip:tt)+])+) => {
                $(
                    let found = $($clip)+(from, to, &window);
                    ensure!(
                        found == default,
                        "{} gives {found:?}, liang_barsky {default:?}",
                        stringify!($name)
                    );
                )+
            };
        }
        zrow_methods::segments!(clip_by_each);
        let reversed = Segments::liang_barsky(to, from, &window).map(|(from, to)| (to, from));
        ensure!(reversed == default, "{reversed:?} from the other end, {default:?}");
        if let Some((a, b)) = default {
            ensure!(
                window.contains(&a) && window.contains(&b),
                "{a:?} to {b:?} is not in {window:?}"
            );
            ensure!(
                is_on(a, (from, to)) && is_on(b, (from, to)),
                "{a:?} to {b:?} is not on the segment"
            );
            let again = Segments::liang_barsky(a, b, &window);
            ensure!(again == default, "{default:?}, clipped again {again:?}");
        }
        if !window.is_empty() {
            let [ends_inside, ends_kept] = [
                [from, to].map(|end| window.contains(&end)),
                [from, to].map(|end| default.is_some_and(|(a, b)| a == end || b == end)),
            ];
            ensure!(
                ends_inside
                    .into_iter()
                    .zip(ends_kept)
                    .all(|(inside, kept)| kept || !inside),
                "{default:?} without an end that is in {window:?}"
            );
            let is_beyond =
                |[one, other]: [i32; 2], first: i32, last: i32| one.max(other) < first || one.min(other) > last;
            let (top_left, bottom_right) = (window.top_left(), window.bottom_right());
            let (columns, rows) = ([from.x_units(), to.x_units()], [from.y_units(), to.y_units()]);
            ensure!(
                default.is_none()
                    || !is_beyond(columns, top_left.x_units(), bottom_right.x_units())
                        && !is_beyond(rows, top_left.y_units(), bottom_right.y_units()),
                "{default:?}, where both ends are beyond a side of {window:?}"
            );
        }
        // As a convex window, where it is one.
        let corners = [
            first,
            S::by_hand(last.x_units().into(), first.y_units().into()),
            last,
            S::by_hand(first.x_units().into(), last.y_units().into()),
        ];
        if let Ok(convex) = ConvexWindow::new(&corners)
            && !window.is_empty()
        {
            let found = Segments::cyrus_beck(from, to, &convex).map(|part| part.ends());
            ensure!(found == default, "cyrus_beck gives {found:?}, liang_barsky {default:?}");
        }
        Ok(())
    }
}

impl Case for SegmentCase {
    fn check(&self) -> Verdict {
        self.check_at::<Sub4>()?;
        self.check_at::<Sub8>()
    }
}

/// A convex window: a few corners in order around a middle.
#[derive(Debug, Arbitrary)]
pub struct Convex(List<SubSpot, 6>);

impl Convex {
    /// The corners of the convex hull of the points, in the domain; fewer than three where they lie in a line.
    pub fn corners<S: ByHand>(&self, stage: &Stage) -> Vec<SubPoint<S>> {
        let mut places: Vec<_> = self.0.0.iter().map(|spot| spot.inside::<S>(stage)).collect();
        places.sort_by_key(|point| (point.x_units(), point.y_units()));
        places.dedup();
        let turn = |a: &SubPoint<S>, b: &SubPoint<S>, c: &SubPoint<S>| {
            let wide = |units: i32| i64::from(units);
            (wide(b.x_units()) - wide(a.x_units())) * (wide(c.y_units()) - wide(a.y_units()))
                - (wide(b.y_units()) - wide(a.y_units())) * (wide(c.x_units()) - wide(a.x_units()))
        };
        // Andrew's monotone chain.
        let chain = |points: &mut dyn Iterator<Item = SubPoint<S>>| {
            let mut hull: Vec<SubPoint<S>> = Vec::new();
            for point in points {
                while let [.., a, b] = hull[..] {
                    if turn(&a, &b, &point) > 0 {
                        break;
                    }
                    hull.pop();
                }
                hull.push(point);
            }
            hull.pop();
            hull
        };
        let mut hull = chain(&mut places.iter().copied());
        hull.extend(chain(&mut places.iter().rev().copied()));
        hull
    }
}

/// A segment and a polygon against convex windows.
#[derive(Debug, Arbitrary)]
pub struct ConvexCase {
    stage: Stage,
    window: Convex,
    other: Convex,
    ends: [SubSpot; 2],
    polygon: List<SubSpot, 7>,
    by_hand: bool,
}

impl ConvexCase {
    fn check_at<S: ByHand>(&self) -> Verdict {
        let Self { stage, .. } = self;
        let point = |spot: &SubSpot| {
            if self.by_hand {
                spot.by_hand::<S>(stage)
            } else {
                spot.inside(stage)
            }
        };
        let corners = self.window.corners::<S>(stage);
        let Ok(window) = ConvexWindow::new(&corners) else {
            ensure!(corners.len() < 3, "the hull {corners:?} is not convex");
            return Ok(());
        };
        let [from, to] = self.ends.each_ref().map(point);
        let part = Segments::cyrus_beck(from, to, &window);
        let turned: Vec<_> = corners.iter().rev().copied().collect();
        let other_way = ConvexWindow::new(&turned).context("the other orientation")?;
        ensure!(
            Segments::cyrus_beck(from, to, &other_way) == part,
            "the orientation counts"
        );
        let reversed = Segments::cyrus_beck(to, from, &window).map(|part| part.ends());
        ensure!(
            reversed.map(|(from, to)| (to, from)) == part.map(|part| part.ends()),
            "from the other end {reversed:?}"
        );
        if let Some(part) = part {
            ensure!(part.clip(&window) == Some(part), "clipping again changes {part:?}");
            let (a, b) = part.ends_within(&window);
            ensure!(
                window.bounds().contains(&a) && window.bounds().contains(&b),
                "{a:?} to {b:?} is not in the bounds"
            );
            let others = self.other.corners::<S>(stage);
            if let Ok(other) = ConvexWindow::new(&others) {
                let one_way = part.clip(&other);
                let another = Segments::cyrus_beck(from, to, &other).and_then(|part| part.clip(&window));
                ensure!(one_way == another, "the order of windows counts");
            }
        } else {
            ensure!(
                !window.contains(from) && !window.contains(to),
                "a segment with an end inside is clipped to nothing"
            );
        }

        let polygon: Vec<_> = self.polygon.0.iter().map(point).collect();
        let result = window
            .sutherland_hodgman_2d::<40, 8>(&polygon)
            .context("room for all corners")?;
        ensure!(result.is_empty() || result.len() >= 3, "{} corners", result.len());
        for corner in &result {
            ensure!(
                is_near(&corners, corner),
                "{corner:?} is outside of the window {corners:?}"
            );
        }
        match window.sutherland_hodgman_2d::<3, 2>(&polygon) {
            Ok(small) => ensure!(small[..] == result[..], "a small table gives another polygon"),
            Err(full) => match full {
                TooSmall::WindowSides(needed) => ensure!(2 < needed && needed <= corners.len(), "{full}"),
                TooSmall::Corners(needed) => {
                    ensure!(needed == result.len(), "{full}, where there are {}", result.len())
                }
                other => anyhow::bail!("{other}: no table of a clipper"),
            },
        }
        Ok(())
    }
}

/// Whether a point is inside a convex window, or half a unit outside along each axis. The inside is right of each side.
fn is_near<S: SubPixel>(corners: &[SubPoint<S>], point: &SubPoint<S>) -> bool {
    let units = |point: &SubPoint<S>| [i128::from(point.x_units()), i128::from(point.y_units())];
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let [x, y] = units(point);
    ends.into_iter().all(|(from, to)| {
        let ([ax, ay], [bx, by]) = (units(from), units(to));
        let (dx, dy) = (bx - ax, by - ay);
        2 * (dx * (y - ay) - dy * (x - ax)) >= -(dx.abs() + dy.abs())
    })
}

impl Case for ConvexCase {
    fn check(&self) -> Verdict {
        self.check_at::<Sub4>()?;
        self.check_at::<Sub8>()
    }
}

/// Boolean operations on polygons.
#[derive(Debug, Arbitrary)]
pub struct BooleanCase {
    stage: Stage,
    subject: SubContours<2, 6>,
    clip: SubContours<2, 6>,
    by_hand: bool,
    probes: [SubSpot; 6],
}

fn units<S: SubPixel>(contours: &[Vec<SubPoint<S>>]) -> Vec<Vec<[i128; 2]>> {
    let contours = contours.iter();
    contours
        .map(|contour| {
            contour
                .iter()
                .map(|point| [point.x_units().into(), point.y_units().into()])
                .collect()
        })
        .collect()
}

/// Contours in an order of their own, each from the corner on from which its corners are the smallest.
fn canonical(contours: &[Vec<[i128; 2]>]) -> Vec<Vec<[i128; 2]>> {
    let rotated = |contour: &Vec<[i128; 2]>| {
        let from = |first: usize| [&contour[first..], &contour[..first]].concat();
        (0..contour.len()).map(from).min().unwrap_or_default()
    };
    let mut contours: Vec<_> = contours.iter().map(rotated).collect();
    contours.sort();
    contours
}

/// The square of the distance from a point to the nearest edge is at least that of four units.
fn is_far<const CONTOURS: usize>(contours: [&[Vec<[i128; 2]>]; CONTOURS], [x, y]: [i128; 2]) -> bool {
    let edges = contours.into_iter().flatten().flat_map(|contour| {
        let ends = contour.iter().cycle().skip(1);
        contour.iter().zip(ends)
    });
    edges.into_iter().all(|([ax, ay], [bx, by])| {
        let (dx, dy) = (bx - ax, by - ay);
        let (px, py) = (x - ax, y - ay);
        let along = px * dx + py * dy;
        let length = dx * dx + dy * dy;
        if along <= 0 {
            px * px + py * py >= 16
        } else if along >= length {
            (x - bx).pow(2) + (y - by).pow(2) >= 16
        } else {
            (px * dy - py * dx).pow(2) >= 16 * length
        }
    })
}

impl BooleanCase {
    fn check_at<S: ByHand>(&self) -> Verdict {
        let Self { stage, .. } = self;
        let (subject, clip) = if self.by_hand {
            (self.subject.by_hand::<S>(stage), self.clip.by_hand::<S>(stage))
        } else {
            (self.subject.inside::<S>(stage), self.clip.inside::<S>(stage))
        };
        let slices = |contours: &'_ [Vec<SubPoint<S>>]| -> Vec<Vec<SubPoint<S>>> { contours.to_vec() };
        let (subject, clip) = (slices(&subject), slices(&clip));
        let subject_slices: Vec<&[SubPoint<S>]> = subject.iter().map(Vec::as_slice).collect();
        let clip_slices: Vec<&[SubPoint<S>]> = clip.iter().map(Vec::as_slice).collect();
        let mut clipper = Clipper::<S, 512>::new();
        let mut small = Clipper::<S, 12>::new();
        let mut sibling = Clipper::<S, 512>::new();
        let (one, other) = (units(&subject), units(&clip));
        for operation in [Operation::Intersection, Operation::Union, Operation::Difference] {
            let result = match clipper.greiner_hormann(&subject_slices, &clip_slices, operation) {
                Ok(result) => result,
                Err(error @ InputError::OutOfDomain { .. }) => {
                    ensure!(self.by_hand, "{error}, where all points are of the domain");
                    return Ok(());
                }
                Err(InputError::TooSmall(full)) => {
                    ensure!(full.needed() > 512, "{full}, where there are 512");
                    return Ok(());
                }
                Err(error) => anyhow::bail!("{error}, which is no error of clipping"),
            };
            let contours: Vec<Vec<SubPoint<S>>> = result.map(|contour| contour.points().collect()).collect();
            let found = units(&contours);
            let Ok(of_sibling) = sibling.weiler_atherton(&subject_slices, &clip_slices, operation) else {
                anyhow::bail!("an error of Weiler and Atherton's clipping only");
            };
            let of_sibling: Vec<Vec<SubPoint<S>>> = of_sibling.map(|contour| contour.points().collect()).collect();
            ensure!(
                canonical(&units(&of_sibling)) == canonical(&found),
                "{operation:?}: Weiler and Atherton's clipping gives other contours"
            );
            for probe in self.probes {
                let probe = probe.inside::<S>(stage);
                let point = [probe.x_units().into(), probe.y_units().into()];
                if !is_far([&one, &other, &found], point) {
                    continue;
                }
                let is_inside =
                    |contours: &[Vec<[i128; 2]>]| FillRule::EvenOdd.includes(exact::winding(contours, point));
                let (in_one, in_other) = (is_inside(&one), is_inside(&other));
                let expected = match operation {
                    Operation::Intersection => in_one && in_other,
                    Operation::Union => in_one || in_other,
                    Operation::Difference => in_one && !in_other,
                };
                ensure!(is_inside(&found) == expected, "{operation:?} at {probe:?}: {expected}");
            }
            match small.greiner_hormann(&subject_slices, &clip_slices, operation) {
                Ok(small) => {
                    let again: Vec<Vec<SubPoint<S>>> = small.map(|contour| contour.points().collect()).collect();
                    ensure!(again == contours, "a small table gives another result");
                }
                Err(InputError::TooSmall(full)) => ensure!(full.needed() > 12, "{full}, where there are 12"),
                Err(error) => anyhow::bail!("{error} with a small table only"),
            }
        }
        Ok(())
    }
}

impl Case for BooleanCase {
    fn check(&self) -> Verdict {
        self.check_at::<Sub4>()?;
        self.check_at::<Sub8>()
    }
}

/// Circles and rectangles against the pixels of a window.
#[derive(Debug, Arbitrary)]
pub struct PixelsCase {
    stage: Stage,
    corner: Spot,
    size: [Length; 2],
    any: [Int; 4],
    any_size: [Count; 2],
}

/// What a window shows of a shape, by asking for every pixel; the window has some.
fn shown(stage: &Stage, area: &Rectangle, has: impl Fn(Point) -> bool) -> (usize, bool) {
    let window = stage.window;
    let pixels = embedded_graphics::primitives::PointsIter::points(&stage.area()).filter(|point| has(*point));
    // Whether every pixel of it is one of the window.
    let wide = |coordinate: i32| i64::from(coordinate);
    let Rectangle { top_left, size } = *area;
    let is_inside = wide(top_left.x) >= wide(window.left)
        && wide(top_left.y) >= wide(window.top)
        && wide(top_left.x) + i64::from(size.width) <= wide(window.right)
        && wide(top_left.y) + i64::from(size.height) <= wide(window.bottom);
    (pixels.count(), is_inside)
}

fn is_right(found: Classification, (count, is_inside): (usize, bool), pixels: usize, is_empty: bool) -> Verdict {
    let expected = match count {
        0 => Classification::Nothing,
        _ if is_inside => Classification::Whole,
        count if count == pixels => Classification::Fills,
        _ => Classification::Part,
    };
    let expected = if is_empty { Classification::Nothing } else { expected };
    ensure!(found == expected, "{found:?}, by its pixels {expected:?}");
    Ok(())
}

impl Case for PixelsCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        let [width, height] = self.size;
        let rectangle = Rectangle::new(stage.point(self.corner), width.by(height));
        let window = Window::from(rectangle);
        let found = Classification::rectangle_against_window(&rectangle, &stage.window);
        let by_pixels = shown(stage, &rectangle, |point| window.contains(point));
        is_right(found, by_pixels, stage.pixels(), rectangle.is_zero_sized()).context("a rectangle")?;
        let part = stage.window.clip_rectangle(&rectangle);
        ensure!(
            part.is_some() == (found != Classification::Nothing),
            "{part:?} of a rectangle: {found:?}"
        );
        if let Some(part) = part {
            let again = stage.window.clip_rectangle(&part);
            ensure!(again == Some(part), "{part:?}, clipped again {again:?}");
        }
        let circle = Circle::new(rectangle.top_left, width.0);
        let area = Rectangle::new(rectangle.top_left, Size::new_equal(width.0));
        let found = Classification::circle_against_window(&circle, &stage.window);
        let by_pixels = shown(stage, &area, |point| exact::ellipse_has(&area, point));
        is_right(found, by_pixels, stage.pixels(), width.0 == 0).context("a circle")?;
        // Anything, against any window.
        let [left, top, right, bottom] = self.any.map(|number| number.0);
        let window = Window {
            left,
            top,
            right,
            bottom,
        };
        let any = Rectangle::new(Point::new(top, left), Size::new(self.any_size[0].0, self.any_size[1].0));
        for found in [
            Classification::rectangle_against_window(&any, &window),
            Classification::circle_against_window(&Circle::new(any.top_left, any.size.width), &window),
        ] {
            ensure!(
                !window.is_empty() || found == Classification::Nothing,
                "{found:?} in an empty window"
            );
        }
        let pixel = Rectangle::new(any.top_left, Size::new_equal(1));
        let found = Classification::rectangle_against_window(&pixel, &window);
        let expected = if window.contains(any.top_left) {
            Classification::Whole
        } else {
            Classification::Nothing
        };
        ensure!(found == expected, "{found:?} of {pixel:?} in {window:?}");
        Ok(())
    }
}
