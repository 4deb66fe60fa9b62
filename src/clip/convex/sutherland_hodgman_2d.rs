//! Sutherland and Hodgman's polygon clipping (1974, "Reentrant Polygon Clipping", Communications of the ACM 17(1)):
//! against any convex window, one side after the other.
//!
//! As in the paper nothing between two sides is stored: a side hands on each edge as it gets it, and remembers only its
//! first and its last one. An edge is known by the line it lies on, that of an edge of the polygon or that of a side of
//! the window, and a corner by the two lines that meet in it. So no cut works with what another has rounded.
//!
//! Guarantees: what is inside is decided exactly; every corner of the result is a corner of the polygon, one of the window,
//! or an exact crossing rounded once to the nearest unit (ties to the larger coordinate), which may lie outside an
//! oblique side by half a unit in x and in y. No corner is repeated right behind itself. The order of the polygon's corners
//! stays, clockwise or not, and so does its first corner where nothing is cut off. Clipping the result again changes
//! nothing where the window is upright; an oblique side may cut what was rounded outwards.
//!
//! The area is that of the exact result but for this rounding, which moves it by `length / 2 + corners / 4` square units
//! at most: `length` is the sum of the sizes of all edges between the rounded corners, on both axes, and `corners` the
//! number of corners of the exact result. Where rounding brings corners together, one of them stays. So a part thinner than
//! a unit may be left with no area, or, with fewer than three corners, be left out: what is lost has the same bound.
//!
//! A concave polygon that falls apart stays one: its parts are joined by bridges along the sides of the window, edges
//! that lie on each other and enclose nothing. Fills do not show them, outlines do. A concave polygon that only reaches
//! around the window may leave nothing but a bridge.
//!
//! Cost: two products for each corner of the polygon and each side of the window, for trivial accept and reject.
//! Then each edge goes through the sides that cut the polygon, with eight products and two long ones for a corner that a
//! cut made, and each crossing that is left costs a long division an axis. Take it when the window is convex, as a display
//! or a panel in perspective is; a concave one needs a boolean operation.

use core::iter;

use heapless::{Vec, VecView};

use crate::{
    clip::{Outcode, convex::convex_crossing::Fraction},
    geometry::{ConvexWindow, SideLine, SubPixel, SubPoint, TooSmall},
};

impl<S: SubPixel> ConvexWindow<'_, S> {
    /// The part of a polygon inside this closed window; without corners where nothing is left of it.
    ///
    /// Takes any numbers the coordinates can hold, also outside the domain of `S`, and polygons that cross themselves.
    /// RAM on a 32-bit machine: `CORNERS` points of 4 or 8 bytes in the result, and 40 bytes for each of `SIDES`
    /// while it is made. [`clip`](crate::clip) says when to take it.
    /// Source: Sutherland and Hodgman 1974.
    ///
    /// # Errors
    /// [`TooSmall`] with the exact number that is needed: [`TooSmall::WindowSides`] where more than `SIDES` sides of the
    /// window have a corner of the polygon beyond them, [`TooSmall::Corners`] where the result has more than `CORNERS`
    /// corners.
    ///
    /// ```
    /// use zrow::geometry::{ConvexWindow, Sub4, SubPoint};
    ///
    /// let at = SubPoint::<Sub4>::from_units;
    /// let square = [at(0, 0)?, at(80, 0)?, at(80, 80)?, at(0, 80)?];
    /// let triangle = [at(40, 40)?, at(120, 40)?, at(40, 120)?];
    /// let window = ConvexWindow::new(&square)?;
    /// let part = window.sutherland_hodgman_2d::<8, 4>(&triangle)?;
    /// assert_eq!(part[..], [at(80, 80)?, at(40, 80)?, at(40, 40)?, at(80, 40)?]);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn sutherland_hodgman_2d<const CORNERS: usize, const SIDES: usize>(
        &self,
        polygon: &[SubPoint<S>],
    ) -> Result<Vec<SubPoint<S>, CORNERS>, TooSmall> {
        let mut corners = Vec::new();
        let mut stages = Vec::<Stage, SIDES>::new();
        if is_visible(polygon, self) && set_up(polygon, self, stages.as_mut_view())? {
            let mut pipeline = Pipeline {
                lines: Lines { polygon, window: self },
                stages: stages.as_mut_view(),
                result: Corners::new(corners.as_mut_view()),
            };
            pipeline.run();
            pipeline.result.close()?;
        }
        Ok(corners)
    }
}

/// Whether the corners of a polygon are not all beyond one side of the window's bounds; `false` for one without corners.
fn is_visible<S: SubPixel>(polygon: &[SubPoint<S>], window: &ConvexWindow<'_, S>) -> bool {
    let codes = polygon
        .iter()
        .map(|&corner| Outcode::of_sub_point(corner, window.bounds()));
    codes.reduce(Outcode::shared).is_some_and(Outcode::is_inside)
}

/// Adds a stage for each side that has a corner of the polygon beyond it; `false` where all corners are beyond one side.
///
/// Any other side cuts nothing off: what is left of a polygon lies in the convex hull of its corners.
///
/// # Errors
/// [`TooSmall::WindowSides`] with the number of such sides, where there are fewer stages.
fn set_up<S: SubPixel>(
    polygon: &[SubPoint<S>],
    window: &ConvexWindow<'_, S>,
    stages: &mut VecView<Stage>,
) -> Result<bool, TooSmall> {
    let mut needed = 0usize;
    for (number, side) in window.sides().enumerate() {
        let beyond = polygon.iter().filter(|&&corner| side.distance(corner) < 0).count();
        if beyond == polygon.len() {
            return Ok(false);
        }
        if beyond > 0 {
            needed += 1;
            // Without room it is only counted.
            let _ = stages.push(Stage::new(number, side));
        }
    }
    if needed > stages.len() {
        return Err(TooSmall::WindowSides(needed));
    }
    Ok(true)
}

/// The line that an edge lies on, by number: edge or side `n` joins corner `n` to the next one.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum EdgeLine {
    Polygon(usize),
    Window(usize),
}

/// A corner, by the two lines that meet in it.
enum CutVertex {
    /// A corner of the polygon, by its number.
    OfPolygon(usize),
    /// A corner of the window, by its number.
    OfWindow(usize),
    /// The crossing of an edge of the polygon, by its number, with a side of the window, by its number.
    Crossing(usize, usize),
    /// The point outside the window where the lines of two sides meet that are no neighbours.
    Beyond,
}

/// The lines that numbers of edges and sides stand for.
struct Lines<'a, S: SubPixel> {
    polygon: &'a [SubPoint<S>],
    window: &'a ConvexWindow<'a, S>,
}

impl<S: SubPixel> Lines<'_, S> {
    /// The corner where the edge on one line ends and the edge on another line begins.
    fn corner(&self, before: EdgeLine, after: EdgeLine) -> CutVertex {
        match (before, after) {
            (EdgeLine::Polygon(_), EdgeLine::Polygon(corner)) => CutVertex::OfPolygon(corner),
            (EdgeLine::Polygon(edge), EdgeLine::Window(side)) | (EdgeLine::Window(side), EdgeLine::Polygon(edge)) => {
                CutVertex::Crossing(edge, side)
            }
            (EdgeLine::Window(one), EdgeLine::Window(other)) => {
                let (low, high) = (one.min(other), one.max(other));
                if high - low == 1 {
                    CutVertex::OfWindow(high)
                } else if low == 0 && high + 1 == self.window.corners().len() {
                    CutVertex::OfWindow(0)
                } else {
                    CutVertex::Beyond
                }
            }
        }
    }

    /// The ends of an edge of the polygon.
    fn edge(&self, number: usize) -> Option<(SubPoint<S>, SubPoint<S>)> {
        let start = self.polygon.get(number)?;
        let end = self.polygon.get(number + 1).or(self.polygon.first())?;
        Some((*start, *end))
    }

    /// The ends of an edge, and how far along it crosses the line of a side; `None` for numbers that are none.
    fn crossing(&self, edge: usize, side: usize) -> Option<(SubPoint<S>, SubPoint<S>, Fraction)> {
        let (from, to) = self.edge(edge)?;
        let side = self.window.side(side)?;
        let fraction = Fraction::of_crossing(side.distance(from), side.distance(to));
        Some((from, to, fraction))
    }

    /// Whether the corner where two lines meet is on the inner side of a later side, or on it.
    fn is_kept(&self, before: EdgeLine, after: EdgeLine, side: &SideLine) -> Option<bool> {
        Some(match self.corner(before, after) {
            CutVertex::OfPolygon(corner) => side.distance(*self.polygon.get(corner)?) >= 0,
            CutVertex::OfWindow(_) => true,
            CutVertex::Beyond => false,
            CutVertex::Crossing(edge, other) => {
                let (from, to, fraction) = self.crossing(edge, other)?;
                fraction.is_not_below_zero::<S>(side.distance(from), side.distance(to))
            }
        })
    }

    /// The nearest point to the corner where two lines meet.
    fn point(&self, before: EdgeLine, after: EdgeLine) -> Option<SubPoint<S>> {
        match self.corner(before, after) {
            CutVertex::OfPolygon(corner) => self.polygon.get(corner).copied(),
            CutVertex::OfWindow(corner) => self.window.corners().get(corner).copied(),
            CutVertex::Beyond => None,
            CutVertex::Crossing(edge, side) => {
                let (from, to, fraction) = self.crossing(edge, side)?;
                fraction.point(from, to)
            }
        }
    }
}

/// One side of the window, and what it remembers of the edges that came.
struct Stage {
    number: usize,
    side: SideLine,
    /// The first edge that came.
    first: Option<EdgeLine>,
    /// Whether the end of the first edge is inside this side.
    first_end_is_kept: bool,
    /// The last edge that came.
    last: EdgeLine,
    /// Whether the start of the last edge is inside this side; `None` for the first edge, of which that is not known until the end.
    last_start_is_kept: Option<bool>,
    /// Whether an edge left the window here, so that one along the side comes next.
    owes_side: bool,
}

impl Stage {
    const fn new(number: usize, side: SideLine) -> Self {
        Self {
            number,
            side,
            first: None,
            first_end_is_kept: false,
            last: EdgeLine::Window(number),
            last_start_is_kept: None,
            owes_side: false,
        }
    }

    /// Takes the next edge in; gives the one before, where something of it is kept.
    fn take<S: SubPixel>(&mut self, line: EdgeLine, lines: &Lines<'_, S>) -> Option<EdgeLine> {
        if self.first.is_none() {
            self.first = Some(line);
            self.last = line;
            return None;
        }
        let end_is_kept = lines.is_kept(self.last, line, &self.side)?;
        let handed_on = match self.last_start_is_kept {
            Some(start_is_kept) => self.hand_on(start_is_kept, end_is_kept),
            None => {
                self.first_end_is_kept = end_is_kept;
                None
            }
        };
        self.last = line;
        self.last_start_is_kept = Some(end_is_kept);
        handed_on
    }

    /// Takes the first edge in again, as the one behind the last.
    fn take_first_again<S: SubPixel>(&mut self, lines: &Lines<'_, S>) -> Option<EdgeLine> {
        self.take(self.first?, lines)
    }

    /// Gives the first edge, which had to wait for its start.
    fn hand_on_first(&mut self) -> Option<EdgeLine> {
        self.hand_on(self.last_start_is_kept?, self.first_end_is_kept)
    }

    /// Gives the last edge where something of it is kept, and notes whether a part of the side follows it.
    fn hand_on(&mut self, start_is_kept: bool, end_is_kept: bool) -> Option<EdgeLine> {
        self.owes_side = start_is_kept && !end_is_kept;
        (start_is_kept || end_is_kept).then_some(self.last)
    }
}

/// The stages in a row: what one hands on, the next one takes.
struct Pipeline<'a, S: SubPixel> {
    lines: Lines<'a, S>,
    stages: &'a mut VecView<Stage>,
    result: Corners<'a, S>,
}

impl<S: SubPixel> Pipeline<'_, S> {
    fn run(&mut self) {
        // Begins with the last edge, so that corner 0 is the first of the result where nothing is cut off.
        let last = self.lines.polygon.len().saturating_sub(1);
        for edge in iter::once(last).chain(0..last) {
            self.carry(0, Some(EdgeLine::Polygon(edge)));
        }
        // A stage is done when the one before it is.
        for number in 0..self.stages.len() {
            let after = number + 1;
            let last = self.stages.get_mut(number);
            let last = last.and_then(|stage| stage.take_first_again(&self.lines));
            self.carry(after, last);
            let first = self.stages.get_mut(number).and_then(Stage::hand_on_first);
            self.carry(after, first);
        }
        self.result.take_first_again(&self.lines);
    }

    /// Carries an edge from that stage on, and every side of the window that it makes follow.
    fn carry(&mut self, mut number: usize, mut line: Option<EdgeLine>) {
        loop {
            while let Some(edge) = line {
                if let Some(stage) = self.stages.get_mut(number) {
                    line = stage.take(edge, &self.lines);
                    number += 1;
                } else {
                    self.result.take(edge, &self.lines);
                    line = None;
                }
            }
            // What is further on comes first, so that the order of the edges stays.
            let Some(owing) = self.stages.iter().rposition(|stage| stage.owes_side) else {
                return;
            };
            if let Some(stage) = self.stages.get_mut(owing) {
                stage.owes_side = false;
                line = Some(EdgeLine::Window(stage.number));
            }
            number = owing + 1;
        }
    }
}

/// The end of the row: corners of the result, as many as there is room for, and the count of all.
struct Corners<'a, S: SubPixel> {
    corners: &'a mut VecView<SubPoint<S>>,
    /// The number of corners, those included for which there is no room.
    count: usize,
    /// The first corner.
    first: Option<SubPoint<S>>,
    /// The last corner so far.
    last: Option<SubPoint<S>>,
    /// The first edge that came.
    first_line: Option<EdgeLine>,
    /// The last edge that came.
    last_line: Option<EdgeLine>,
}

impl<'a, S: SubPixel> Corners<'a, S> {
    const fn new(corners: &'a mut VecView<SubPoint<S>>) -> Self {
        Self {
            corners,
            count: 0,
            first: None,
            last: None,
            first_line: None,
            last_line: None,
        }
    }

    /// Takes the next edge in: it starts where the one before ends.
    fn take(&mut self, line: EdgeLine, lines: &Lines<'_, S>) {
        if let Some(before) = self.last_line {
            let corner = lines.point(before, line);
            if corner.is_some() && corner != self.last {
                // Without room it is only counted.
                let _ = corner.map(|corner| self.corners.push(corner));
                self.count += 1;
                self.first = self.first.or(corner);
                self.last = corner;
            }
        } else {
            self.first_line = Some(line);
        }
        self.last_line = Some(line);
    }

    fn take_first_again(&mut self, lines: &Lines<'_, S>) {
        if let Some(first) = self.first_line {
            self.take(first, lines);
        }
    }

    /// Leaves a last corner that repeats the first one out, and what has too few corners to be a polygon.
    ///
    /// # Errors
    /// [`TooSmall::Corners`] with the number of corners, where there is room for fewer.
    fn close(self) -> Result<(), TooSmall> {
        let mut count = self.count;
        if self.last == self.first {
            count = count.saturating_sub(1);
        }
        if count < 3 {
            count = 0;
        }
        self.corners.truncate(count);
        if self.corners.len() < count {
            return Err(TooSmall::Corners(count));
        }
        Ok(())
    }
}
