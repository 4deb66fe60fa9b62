//! Fills of polygons and triangles, by all that fill one: the pixels by definition.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::Point,
    primitives::{PointsIter, StrokeAlignment},
};
use heapless::Vec as Table;
use zrow::{
    draw::FillRule,
    geometry::{Sub4, Sub8, TableFull, Vertex, Window},
    scan::{
        polygon::{
            ActiveEdge, Edge, Location, Part, active_edge_table, banded_polygon, brute_force_fill, crossing_number,
            edge_table, merged_crossings,
            naive_scanline::{self, FillError},
            quadrant_arc_length,
            scanline_polygon::{self, PartRule, Windings},
            winding_number,
        },
        triangle::{
            barycentric_triangle,
            bresenham_triangle::{self, Rows},
            edge_function_triangle, hierarchical_triangle, incremental_edge_triangle,
        },
    },
    surface::Span,
};

use crate::{
    exact,
    target::{Case, Verdict},
    values::{ByHand, Contours, Int, Rule, Spot, Stage, SubContours, SubSpot},
};

/// The pixels of a window that spans have, each once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Filled {
    window: Window,
    pixels: Vec<bool>,
    /// Spans so far.
    spans: usize,
    wrong: Option<String>,
    fails_at: Option<usize>,
    stopped: bool,
}

/// The error of a span that was told to be one.
#[derive(Debug, PartialEq, Eq)]
pub struct Told;

impl Filled {
    /// Nothing yet.
    pub fn new(window: Window) -> Self {
        let pixels = window.width() as usize * window.height() as usize;
        Self {
            window,
            pixels: vec![false; pixels],
            spans: 0,
            wrong: None,
            fails_at: None,
            stopped: false,
        }
    }

    /// Fails at that span.
    pub const fn failing_at(mut self, span: usize) -> Self {
        self.fails_at = Some(span);
        self
    }

    /// Takes a span, which lies inside and has pixels that no span had before.
    pub fn take(&mut self, span: Span) -> Result<(), Told> {
        if self.stopped {
            self.wrong = Some("a span after an error".to_owned());
        }
        if Some(self.spans) == self.fails_at {
            self.stopped = true;
            return Err(Told);
        }
        self.spans += 1;
        if span.is_empty() || span.to_window().intersection(&self.window) != span.to_window() {
            self.wrong = Some(format!("{span:?} is empty or outside"));
            return Ok(());
        }
        for x in span.start..span.end {
            let (column, row) = (x.abs_diff(self.window.left), span.y.abs_diff(self.window.top));
            let pixel = &mut self.pixels[(row * self.window.width() + column) as usize];
            if *pixel {
                self.wrong = Some(format!("{span:?} has a pixel that another span had"));
            }
            *pixel = true;
        }
        Ok(())
    }

    /// The pixels, where every span was right, and no more spans came than pixels.
    pub fn pixels(&self) -> anyhow::Result<&[bool]> {
        if let Some(wrong) = &self.wrong {
            bail!("{wrong}");
        }
        ensure!(self.spans <= self.pixels.len(), "{} spans", self.spans);
        Ok(&self.pixels)
    }
}

/// Whether two fills have the same pixels.
fn is_same(name: &str, window: &Window, expected: &[bool], found: &Filled) -> Verdict {
    let found = found.pixels().with_context(|| name.to_owned())?;
    let pixels = window.to_rectangle().points().zip(expected.iter().zip(found));
    let mut differing = pixels.filter(|(_, (expected, found))| expected != found);
    if let Some((point, (expected, _))) = differing.next() {
        bail!(
            "{name}: {point:?} is filled, by definition it is {expected}; {} more",
            differing.count()
        );
    }
    Ok(())
}

/// Edges of the contours, as they come.
fn edges<V: Vertex>(contours: &[Vec<V>]) -> Table<Edge, 64> {
    let mut edges = Table::new();
    for contour in contours {
        let Some(mut from) = contour.last() else { continue };
        for to in contour {
            if let Some(edge) = Edge::new(from, to, Part::Fill) {
                // Contours here have fewer vertices than there is room.
                let _ = edges.push(edge);
            }
            from = to;
        }
    }
    edges
}

fn units<V: Vertex>(contours: &[Vec<V>]) -> Vec<Vec<[i128; 2]>> {
    let contours = contours.iter();
    contours
        .map(|contour| {
            contour
                .iter()
                .map(|vertex| [vertex.x_units().into(), vertex.y_units().into()])
                .collect()
        })
        .collect()
}

fn by_definition(window: &Window, contours: &[Vec<[i128; 2]>], fraction_bits: u32, rule: FillRule) -> Vec<bool> {
    let pixels = window.to_rectangle().points();
    let place = |pixel: Point| exact::wide(pixel).map(|coordinate| coordinate << fraction_bits);
    pixels
        .map(|pixel| rule.includes(exact::winding(contours, place(pixel))))
        .collect()
}

fn check_polygon<V: Vertex>(stage: &Stage, contours: &[Vec<V>], rule: FillRule) -> Verdict {
    let window = &stage.window;
    let slices: Vec<&[V]> = contours.iter().map(Vec::as_slice).collect();
    let vertices: usize = contours.iter().map(Vec::len).sum();
    let expected = by_definition(window, &units(contours), V::FRACTION_BITS, rule);

    // Tables of all edges.
    let mut sorted = edges(contours);
    edge_table::sort(&mut sorted);
    let most = edge_table::most_active(&sorted);
    ensure!(
        most <= sorted.len() && sorted.len() <= vertices,
        "{most} of {} edges",
        sorted.len()
    );
    let mut active = Table::<ActiveEdge<'_, Edge>, 64>::new();
    let mut filled = Filled::new(*window);
    let part_rule = PartRule::fill(rule);
    let scanned = scanline_polygon::scan(
        &sorted,
        &mut active,
        Windings::default(),
        part_rule,
        window,
        |span, part| {
            assert_eq!(part, Part::Fill);
            filled.take(span)
        },
    );
    ensure!(scanned == Ok(()), "an error that nobody told");
    is_same("scanline_polygon", window, &expected, &filled)?;
    let spans = filled.spans;
    // Stops at an error.
    if spans > 0 {
        let mut failing = Filled::new(*window).failing_at(stage.rows as usize % spans);
        let mut active = Table::<ActiveEdge<'_, Edge>, 64>::new();
        let scanned = scanline_polygon::scan(
            &sorted,
            &mut active,
            Windings::default(),
            part_rule,
            window,
            |span, _| failing.take(span),
        );
        ensure!(
            scanned == Err(Told) && failing.wrong.is_none(),
            "{scanned:?} of a span that fails"
        );
    }
    // With less room than there are active edges something is left out, and that is all.
    let mut active = Table::<ActiveEdge<'_, Edge>, 1>::new();
    let _ = scanline_polygon::scan(&sorted, &mut active, Windings::default(), part_rule, window, |_, _| {
        Ok::<(), Told>(())
    });

    let mut filled = Filled::new(*window);
    let source = |_: &Window, sink: &mut dyn FnMut(Edge)| edges(contours).into_iter().for_each(sink);
    let scanned = banded_polygon::scan(&source, part_rule, window, |span, _| filled.take(span));
    ensure!(scanned == Ok(()), "an error that nobody told");
    is_same("banded_polygon", window, &expected, &filled)?;

    let mut crossings = Table::<_, 64>::new();
    let mut filled = Filled::new(*window);
    let result = naive_scanline(&slices, rule, window, &mut crossings, |span| filled.take(span));
    ensure!(result == Ok(()), "naive_scanline: {result:?}");
    is_same("naive_scanline", window, &expected, &filled)?;
    let mut few = Table::<_, 2>::new();
    let mut filled = Filled::new(*window);
    match naive_scanline(&slices, rule, window, &mut few, |span| filled.take(span)) {
        Ok(()) => is_same("naive_scanline with two crossings", window, &expected, &filled)?,
        Err(FillError::TableFull(TableFull { needed, .. })) => {
            ensure!(
                needed > 2 && needed <= most && filled.spans == 0,
                "{needed} crossings of {most}"
            );
        }
        Err(FillError::Emit(Told)) => bail!("an error that nobody told"),
    }

    let locate_by = [
        crossing_number::<V, _>,
        merged_crossings,
        quadrant_arc_length,
        winding_number,
    ];
    for (number, locate) in locate_by.into_iter().enumerate() {
        let mut filled = Filled::new(*window);
        let result = brute_force_fill(&slices, rule, window, locate, |span| filled.take(span));
        ensure!(result == Ok(()), "an error that nobody told");
        is_same(
            &format!("brute_force_fill by test {number}"),
            window,
            &expected,
            &filled,
        )?;
    }
    Ok(())
}

/// Contours of whole pixels or between pixels.
#[derive(Debug, Arbitrary)]
pub struct PolygonCase {
    stage: Stage,
    contours: AnyContours,
    rule: Rule,
}

#[derive(Debug, Arbitrary)]
enum AnyContours {
    Pixels(Contours<3, 7>),
    Coarse(SubContours<3, 7>),
    Fine(SubContours<3, 7>),
    ByHand(SubContours<2, 6>),
}

impl Case for PolygonCase {
    fn check(&self) -> Verdict {
        let Self { stage, rule, .. } = self;
        match &self.contours {
            AnyContours::Pixels(contours) => check_polygon(stage, &contours.get(stage), rule.get()),
            AnyContours::Coarse(contours) => check_polygon(stage, &contours.inside::<Sub4>(stage), rule.get()),
            AnyContours::Fine(contours) => check_polygon(stage, &contours.inside::<Sub8>(stage), rule.get()),
            AnyContours::ByHand(contours) => check_polygon(stage, &contours.by_hand::<Sub8>(stage), rule.get()),
        }
    }
}

/// A point and a polygon.
#[derive(Debug, Arbitrary)]
pub struct LocateCase {
    stage: Stage,
    contours: Contours<3, 7>,
    rule: Rule,
    point: Spot,
    on_edge: bool,
}

/// Whether a point lies on the segment between two others.
fn is_between([ax, ay]: [i128; 2], [bx, by]: [i128; 2], [x, y]: [i128; 2]) -> bool {
    let is_in = |one: i128, other: i128, middle: i128| one.min(other) <= middle && middle <= one.max(other);
    (bx - ax) * (y - ay) == (by - ay) * (x - ax) && is_in(ax, bx, x) && is_in(ay, by, y)
}

impl Case for LocateCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        let rule = self.rule.get();
        let contours = self.contours.get(stage);
        let mut point = stage.point(self.point);
        let first = contours.iter().find_map(|contour| contour.first());
        if let Some(first) = first.filter(|_| self.on_edge) {
            point = *first;
        }
        let exact_contours = units(&contours);
        let place = exact::wide(point);
        let on_boundary = exact_contours.iter().any(|contour| {
            let ends = contour.iter().zip(contour.iter().cycle().skip(1));
            ends.into_iter().any(|(from, to)| is_between(*from, *to, place))
        });
        let expected = if on_boundary {
            Location::OnBoundary
        } else if rule.includes(exact::winding(&exact_contours, place)) {
            Location::Inside
        } else {
            Location::Outside
        };
        let slices: Vec<&[Point]> = contours.iter().map(Vec::as_slice).collect();
        let found = [
            crossing_number(&slices, rule, &point),
            merged_crossings(&slices, rule, &point),
            quadrant_arc_length(&slices, rule, &point),
            winding_number(&slices, rule, &point),
        ];
        ensure!(found == [expected; 4], "{found:?}, by definition {expected:?}");
        Ok(())
    }
}

/// A triangle of sub-pixel corners, often in a line.
#[derive(Debug, Arbitrary)]
pub struct SubTriangleCase {
    stage: Stage,
    corners: [SubSpot; 3],
    is_sliver: bool,
    by_hand: bool,
}

impl SubTriangleCase {
    fn check_at<S: ByHand>(&self) -> Verdict {
        let Self { stage, .. } = self;
        let mut corners = self.corners.map(|corner| {
            if self.by_hand {
                corner.by_hand::<S>(stage)
            } else {
                corner.inside(stage)
            }
        });
        if self.is_sliver {
            let [a, b, _] = corners;
            let middle = |one: i32, other: i32| (i64::from(one) + i64::from(other)) / 2;
            corners[2] = S::by_hand(middle(a.x_units(), b.x_units()), middle(a.y_units(), b.y_units()) + 1);
        }
        let domain = S::MIN_UNITS..=S::MAX_UNITS;
        let is_inside = corners
            .iter()
            .all(|corner| domain.contains(&corner.x_units()) && domain.contains(&corner.y_units()));
        let contours = if is_inside { vec![corners.to_vec()] } else { Vec::new() };
        let window = &stage.window;
        let expected = by_definition(window, &units(&contours), S::FRACTION_BITS, FillRule::NonZero);
        let mut filled = [(); 4].map(|()| Filled::new(*window));
        let [one, two, three, four] = &mut filled;
        let results = [
            barycentric_triangle(corners, window, |span| one.take(span)),
            edge_function_triangle(corners, window, |span| two.take(span)),
            hierarchical_triangle(corners, window, |span| three.take(span)),
            incremental_edge_triangle(corners, window, |span| four.take(span)),
        ];
        ensure!(
            results.iter().all(|result| *result == Ok(())),
            "an error that nobody told"
        );
        let names = ["barycentric", "edge_function", "hierarchical", "incremental_edge"];
        for (name, filled) in names.into_iter().zip(&filled) {
            is_same(name, window, &expected, filled)?;
        }
        Ok(())
    }
}

impl Case for SubTriangleCase {
    fn check(&self) -> Verdict {
        self.check_at::<Sub4>()?;
        self.check_at::<Sub8>()
    }
}

/// The pixels of an outline, and those between them in each row. Its lines are walked clockwise on the display; those of a
/// triangle without an area go down along the middle corner and return.
fn outlined_by_definition(corners: [Point; 3], window: &Window) -> Vec<bool> {
    let [mut a, mut b, mut c] = corners.map(exact::wide);
    let doubled_area = exact::doubled_area([a, b, c]);
    if doubled_area < 0 {
        (a, b) = (b, a);
    } else if doubled_area == 0 {
        let mut sorted = [a, b, c];
        sorted.sort_by_key(|[x, y]| (*y, *x));
        [a, b, c] = sorted;
    }
    let lines = [(a, b), (b, c), (c, a)];
    let belongs = |point: Point| {
        let row = || {
            lines
                .into_iter()
                .filter_map(|(from, to)| exact::walked_row(from, to, point.y.into()))
        };
        let x = i128::from(point.x);
        row().any(|[first, _]| first <= x) && row().any(|[_, last]| x <= last)
    };
    window.to_rectangle().points().map(belongs).collect()
}

/// A triangle of whole pixels: its fill and its outline have the pixels by definition, and its edges those of the fill.
#[derive(Debug, Arbitrary)]
pub struct TriangleCase {
    stage: Stage,
    corners: [Spot; 3],
}

impl Case for TriangleCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        let window = &stage.window;
        let corners = self.corners.map(|corner| stage.point(corner));
        let mut filled = Filled::new(*window);
        let mut rows = 0u32;
        let result = bresenham_triangle::fill(corners, window, |part| match part {
            Rows::One(span) => {
                rows += 1;
                filled.take(span)
            }
            Rows::Many(trapezoids) => {
                let mut spans = trapezoids.spans(window).take(stage.window.height() as usize + 1);
                spans.try_for_each(|span| {
                    rows += 1;
                    if span.is_empty() { Ok(()) } else { filled.take(span) }
                })
            }
        });
        ensure!(result == Ok(()) && rows <= window.height(), "{result:?} in {rows} rows");
        let expected = filled.pixels()?.to_vec();
        let mut outlined = Filled::new(*window);
        let mut rows = 0u32;
        let result = bresenham_triangle::outline(corners, window, |row| {
            rows += 1;
            let parts = [row.left, row.inside, row.right].into_iter();
            parts
                .filter(|span| !span.is_empty())
                .try_for_each(|span| outlined.take(span))
        });
        ensure!(result == Ok(()) && rows <= window.height(), "{result:?} in {rows} rows");
        is_same("outline", window, &outlined_by_definition(corners, window), &outlined)?;
        let mut table = Table::<Edge, 64>::new();
        let mut left_out = 0;
        bresenham_triangle::edges(corners, window, &mut |edge| {
            left_out += usize::from(table.push(edge).is_err());
        });
        ensure!(left_out == 0, "{left_out} edges more than 64");
        edge_table::sort(&mut table);
        let mut active = Table::<ActiveEdge<'_, Edge>, 64>::new();
        let mut scanned = Filled::new(*window);
        let rule = PartRule::fill(FillRule::NonZero);
        let result = scanline_polygon::scan(&table, &mut active, Windings::default(), rule, window, |span, _| {
            scanned.take(span)
        });
        ensure!(result == Ok(()), "an error that nobody told");
        is_same("edges", window, &expected, &scanned)
    }
}

/// Fill and stroke, and what is left of the window.
#[derive(Debug, Arbitrary)]
pub struct PartsCase {
    stage: Stage,
    fill: Contours<2, 5>,
    stroke: Contours<2, 5>,
    rule: Rule,
    place: Place,
    left_of_window: [Int; 2],
    row: Int,
}

#[derive(Debug, Copy, Clone, Arbitrary)]
enum Place {
    Everywhere,
    Inside,
    Outside,
}

impl Case for PartsCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        let window = &stage.window;
        let contours = [self.fill.get(stage), self.stroke.get(stage)];
        let mut table = Table::<Edge, 64>::new();
        for (contours, part) in contours.iter().zip([Part::Fill, Part::Stroke]) {
            for contour in contours {
                let Some(mut from) = contour.last() else { continue };
                for to in contour {
                    if let Some(edge) = Edge::new(from, to, part) {
                        let _ = table.push(edge);
                    }
                    from = to;
                }
            }
        }
        edge_table::sort(&mut table);
        let (fill_rule, stroke_alignment) = (
            self.rule.get(),
            match self.place {
                Place::Everywhere => StrokeAlignment::Center,
                Place::Inside => StrokeAlignment::Inside,
                Place::Outside => StrokeAlignment::Outside,
            },
        );
        let rule = PartRule {
            fill_rule,
            stroke_alignment,
        };
        let mut filled = [Filled::new(*window), Filled::new(*window)];
        let mut active = Table::<ActiveEdge<'_, Edge>, 64>::new();
        let result = scanline_polygon::scan(&table, &mut active, Windings::default(), rule, window, |span, part| {
            let [fill, stroke] = &mut filled;
            match part {
                Part::Fill => fill.take(span),
                Part::Stroke => stroke.take(span),
            }
        });
        ensure!(result == Ok(()), "an error that nobody told");
        let exact_contours = contours.each_ref().map(|contours| units(contours));
        let parts = stage.area().points().map(|pixel| {
            let place = exact::wide(pixel);
            let inside = fill_rule.includes(exact::winding(&exact_contours[0], place));
            let on_stroke = exact::winding(&exact_contours[1], place) != 0
                && match stroke_alignment {
                    StrokeAlignment::Center => true,
                    StrokeAlignment::Inside => inside,
                    StrokeAlignment::Outside => !inside,
                };
            if on_stroke {
                Some(Part::Stroke)
            } else {
                inside.then_some(Part::Fill)
            }
        });
        let parts: Vec<Option<Part>> = parts.collect();
        for (part, filled) in [Part::Fill, Part::Stroke].into_iter().zip(&filled) {
            let expected: Vec<bool> = parts.iter().map(|found| *found == Some(part)).collect();
            is_same(&format!("{part:?}"), window, &expected, filled)?;
        }
        // Anything may be left of the window.
        let windings = Windings {
            fill: self.left_of_window[0].0,
            stroke: self.left_of_window[1].0,
        };
        let mut active = Table::<ActiveEdge<'_, Edge>, 64>::new();
        let _ = scanline_polygon::scan(&table, &mut active, windings, rule, window, |_, _| Ok::<(), Told>(()));
        // Begins at any row with an empty table.
        let mut waiting = &table[..];
        let mut active = Table::<ActiveEdge<'_, Edge>, 8>::new();
        let row = self.row.0;
        let next = active_edge_table::change(&mut active, &mut waiting, row);
        ensure!(next > row || row == i32::MAX, "the row after {row} is {next}");
        let is_crossed = |active: &ActiveEdge<'_, Edge>| active.edge.first_row <= row && row < active.edge.end_row;
        ensure!(active.iter().all(is_crossed), "an edge that does not cross row {row}");
        if next > row.saturating_add(1) {
            active_edge_table::step(&mut active, row + 1);
            let is_exact = |active: &ActiveEdge<'_, Edge>| active.crossing == active.edge.crossing_at(row + 1);
            ensure!(
                active.iter().all(is_exact),
                "another crossing by a step to row {}",
                row + 1
            );
        }
        Ok(())
    }
}
