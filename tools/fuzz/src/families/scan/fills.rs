//! Fills of polygons and triangles, by all that fill one: the pixels by definition.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{geometry::Point, primitives::PointsIter};
use zrow::{
    band::Span,
    draw::FillRule,
    geometry::{DrawError, Sub4, Sub8, TooSmall, Vertex, Window},
    scan::{Location, Polygons},
};

use crate::{
    exact,
    target::{Case, Verdict},
    values::{ByHand, Contours, Rule, Spot, Stage, SubContours, SubSpot},
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

/// The edges between vertices of each contour that cross a row of pixels: an edge has its upper end and not its lower one.
fn edge_count<V: Vertex>(contours: &[Vec<V>]) -> usize {
    let ends = contours.iter().flat_map(|contour| {
        let next = contour.iter().cycle().skip(1);
        contour.iter().zip(next)
    });
    let first_row = |vertex: &V| {
        let one = 1i64 << V::FRACTION_BITS;
        -((-i64::from(vertex.y_units())).div_euclid(one))
    };
    ends.filter(|(from, to)| first_row(from) != first_row(to)).count()
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
    let position = |pixel: Point| exact::wide(pixel).map(|coordinate| coordinate << fraction_bits);
    pixels
        .map(|pixel| rule.includes(exact::winding(contours, position(pixel))))
        .collect()
}

fn check_polygon<V: Vertex>(stage: &Stage, contours: &[Vec<V>], rule: FillRule) -> Verdict {
    let window = &stage.window;
    let slices: Vec<&[V]> = contours.iter().map(Vec::as_slice).collect();
    let expected = by_definition(window, &units(contours), V::FRACTION_BITS, rule);

    macro_rules! fill_by_each {
        ($([$name:ident] [$($fill:tt)+])+) => {
            $(
                let mut filled = Filled::new(*window);
                let result = $($fill)+::<_, _, 64>(&slices, rule, window, |span| filled.take(span));
                ensure!(result == Ok(()), "{}: {result:?}", stringify!($name));
                is_same(stringify!($name), window, &expected, &filled)?;
                // Stops at an error.
                if filled.spans > 0 {
                    let mut failing = Filled::new(*window).failing_at(stage.rows as usize % filled.spans);
                    let result = $($fill)+::<_, _, 64>(&slices, rule, window, |span| failing.take(span));
                    ensure!(
                        result == Err(DrawError::Target(Told)) && failing.wrong.is_none(),
                        "{}: {result:?} of a span that fails",
                        stringify!($name)
                    );
                }
            )+
        };
    }
    zrow_methods::polygon_fills!(fill_by_each);
    let edges = edge_count(contours);
    let mut filled = Filled::new(*window);
    match Polygons::scanline::<_, _, 4>(&slices, rule, window, |span| filled.take(span)) {
        Ok(()) => {
            ensure!(edges <= 4, "{edges} edges in a table for 4");
            is_same("scanline_polygon with four edges", window, &expected, &filled)?;
        }
        Err(DrawError::TooSmall(full)) => {
            let is_right = full == TooSmall::Edges(edges);
            ensure!(
                edges > 4 && is_right && filled.spans == 0,
                "{full}, where there are {edges} edges"
            );
        }
        Err(DrawError::OutOfDomain { .. } | DrawError::Target(Told)) => bail!("an error that nobody told"),
    }

    let mut filled = Filled::new(*window);
    match Polygons::naive_scanline::<_, _, 2>(&slices, rule, window, |span| filled.take(span)) {
        Ok(()) => is_same("naive_scanline with two crossings", window, &expected, &filled)?,
        Err(DrawError::TooSmall(full)) => {
            let is_right = matches!(full, TooSmall::Crossings(3..)) && full.needed() <= edges;
            ensure!(is_right && filled.spans == 0, "{full}, where there are {edges} edges");
        }
        Err(DrawError::OutOfDomain { .. } | DrawError::Target(Told)) => bail!("an error that nobody told"),
    }

    macro_rules! fill_by_each {
        ($([$name:ident] [$($locate:tt)+])+) => {
            $(
                let mut filled = Filled::new(*window);
                let result = Polygons::brute_force(&slices, rule, window, $($locate)+, |span| filled.take(span));
                ensure!(result == Ok(()), "an error that nobody told");
                let name = concat!("brute_force_fill by ", stringify!($name));
                is_same(name, window, &expected, &filled)?;
            )+
        };
    }
    zrow_methods::point_tests!(fill_by_each);
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
        let position = exact::wide(point);
        let on_boundary = exact_contours.iter().any(|contour| {
            let ends = contour.iter().zip(contour.iter().cycle().skip(1));
            ends.into_iter().any(|(from, to)| is_between(*from, *to, position))
        });
        let expected = if on_boundary {
            Location::OnBoundary
        } else if rule.includes(exact::winding(&exact_contours, position)) {
            Location::Inside
        } else {
            Location::Outside
        };
        let slices: Vec<&[Point]> = contours.iter().map(Vec::as_slice).collect();
        macro_rules! locate_by_each {
            ($([$name:ident] [$($locate:tt)+])+) => {
                $(
                    let found = $($locate)+(&slices, rule, &point);
                    ensure!(
                        found == expected,
                        "{}: {found:?}, by definition {expected:?}",
                        stringify!($name)
                    );
                )+
            };
        }
        zrow_methods::point_tests!(locate_by_each);
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
        macro_rules! fill_by_each {
            ($([$name:ident] [$($fill:tt)+])+) => {
                $(
                    let mut filled = Filled::new(*window);
                    let result = $($fill)+(corners, window, |span| filled.take(span));
                    ensure!(result == Ok(()), "an error that nobody told");
                    is_same(stringify!($name), window, &expected, &filled)?;
                )+
            };
        }
        zrow_methods::triangles!(fill_by_each);
        let [a, b, c] = corners;
        // One attribute is the same everywhere.
        let with_attributes = [
            (a, [i16::MIN, 7]),
            (b, [i16::MAX, 7]),
            (c, [self.corners.len() as i16, 7]),
        ];
        macro_rules! interpolate_by_each {
            ($([$name:ident] [$($interpolate:tt)+])+) => {
                $(
                    let mut filled = Filled::new(*window);
                    let mut is_even = true;
                    let result = $($interpolate)+(&with_attributes, window, |pixel, [_, even]| {
                        is_even &= even == 7;
                        filled.take(Span::new(pixel.y, pixel.x, pixel.x + 1))
                    });
                    ensure!(result == Ok(()), "an error that nobody told");
                    ensure!(is_even, "an attribute that all corners have is another one inside");
                    is_same(stringify!($name), window, &expected, &filled)?;
                )+
            };
        }
        zrow_methods::interpolations!(interpolate_by_each);
        Ok(())
    }
}

impl Case for SubTriangleCase {
    fn check(&self) -> Verdict {
        self.check_at::<Sub4>()?;
        self.check_at::<Sub8>()
    }
}
