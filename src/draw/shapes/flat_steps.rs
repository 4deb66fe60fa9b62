//! The way of a pen along a path of curves, flattened to lines one at a time, so that the flattened path takes no memory.
//!
//! Curves are flattened by adaptive forward differencing. What needs the lines again walks from the first command once more.

use core::{cell::RefCell, slice};

use embedded_graphics::geometry::Point;
use fixed::types::U8F8;

use crate::{
    draw::shapes::path_command::PathCommand,
    geometry::{Sub8, SubPixel, SubPoint},
    scan::{
        curve::{
            Bezier,
            adaptive_forward_difference::{self, AdaptiveForwardDifference},
            bezier,
        },
        stroke::wide_stroke::{self, Position},
    },
};

/// An end of a line of the flattened path.
pub(crate) type FlatPoint = SubPoint<Sub8>;

/// A step of the pen after curves have been flattened to lines.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(crate) enum FlatStep {
    MoveTo(FlatPoint),
    LineTo(FlatPoint),
    Close,
}

/// The steps of the pen along a path, from its first command to its last.
#[derive(Debug, Clone)]
pub(crate) struct FlatSteps<'a, S: SubPixel> {
    commands: slice::Iter<'a, PathCommand<S>>,
    tolerance: U8F8,
    /// The point at which the current contour began.
    start: FlatPoint,
    /// The position of the pen; the start of the curve while one is being flattened.
    at: FlatPoint,
    /// The lines of the current curve that are still to come.
    curve: Option<AdaptiveForwardDifference>,
}

impl<'a, S: SubPixel> FlatSteps<'a, S> {
    /// The pen's steps along a path with these commands, whose points are in the domain of [`Sub8`]. No line is further
    /// than the tolerance from its curve.
    pub fn new(commands: &'a [PathCommand<S>], tolerance: U8F8) -> Self {
        Self {
            commands: commands.iter(),
            tolerance,
            start: FlatPoint::default(),
            at: FlatPoint::default(),
            curve: None,
        }
    }

    /// The lines that a Bézier curve with these control points is flattened to.
    fn lines_of<const CONTROLS: usize>(&self, controls: [FlatPoint; CONTROLS]) -> Option<AdaptiveForwardDifference> {
        let curve = Bezier::new(controls).ok()?;
        Some(adaptive_forward_difference::flatten(&curve, self.tolerance))
    }
}

impl<S: SubPixel> Iterator for FlatSteps<'_, S> {
    type Item = FlatStep;

    fn next(&mut self) -> Option<FlatStep> {
        loop {
            if let Some(end) = self.curve.as_mut().and_then(Iterator::next) {
                self.at = end;
                return Some(FlatStep::LineTo(end));
            }
            // Every point is in the domain, as the constructor asks for.
            let flat = |point: &SubPoint<S>| bezier::to_sub8(point).unwrap_or_default();
            match self.commands.next()? {
                PathCommand::MoveTo(to) => {
                    self.at = flat(to);
                    self.start = self.at;
                    return Some(FlatStep::MoveTo(self.at));
                }
                PathCommand::LineTo(to) => {
                    self.at = flat(to);
                    return Some(FlatStep::LineTo(self.at));
                }
                PathCommand::QuadraticTo(control, end) => {
                    self.curve = self.lines_of([self.at, flat(control), flat(end)]);
                }
                PathCommand::CubicTo(one, other, end) => {
                    self.curve = self.lines_of([self.at, flat(one), flat(other), flat(end)]);
                }
                PathCommand::Close => {
                    self.at = self.start;
                    return Some(FlatStep::Close);
                }
            }
        }
    }
}

/// A contour of a flattened path: its first vertex, and the pen's steps that follow it.
#[derive(Debug, Clone)]
pub(crate) struct FlatContour<'a, S: SubPixel> {
    pub first: FlatPoint,
    pub steps: FlatSteps<'a, S>,
}

impl<S: SubPixel> FlatContour<'_, S> {
    /// Calls `call` with the contour as the path of a wide stroke, whose vertices are read by their index. A vertex
    /// takes one step of the pen if it follows the one read before; an earlier one takes all steps from the first
    /// vertex on.
    pub fn as_wide_stroke(
        &self,
        count: usize,
        closed: bool,
        width_in_halves: u64,
        call: &mut dyn FnMut(&wide_stroke::Path<'_>),
    ) {
        let pen = RefCell::new((0, self.clone()));
        let vertex = |wanted: usize| -> Position {
            // Always succeeds: while the pen is borrowed, nothing reads another vertex.
            let Ok(mut pen) = pen.try_borrow_mut() else {
                return (0, 0);
            };
            if wanted < pen.0 {
                *pen = (0, self.clone());
            }
            while pen.0 < wanted {
                let Some(FlatStep::LineTo(to)) = pen.1.steps.next() else {
                    break;
                };
                pen.1.first = to;
                pen.0 += 1;
            }
            let shift = wide_stroke::FRACTION_BITS - Sub8::FRACTION_BITS;
            let at = pen.1.first;
            (i64::from(at.x_units()) << shift, i64::from(at.y_units()) << shift)
        };
        call(&wide_stroke::Path::new(&vertex, count, closed, width_in_halves));
    }
}

/// The pixel whose centre is nearest to a point; halfway between two, the one with the larger coordinate.
pub(crate) fn nearest_pixel(point: &FlatPoint) -> Point {
    let half = 1 << (Sub8::FRACTION_BITS - 1);
    let pixel = |units: i32| (units + half) >> Sub8::FRACTION_BITS;
    Point::new(pixel(point.x_units()), pixel(point.y_units()))
}
