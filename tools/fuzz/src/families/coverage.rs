//! `zrow::coverage`: every method, the same in any window, with its row memory as it was.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::geometry::Dimensions;
use zrow::{
    band::Span,
    coverage::{
        AnyCoverage, Bartlett, BoxFilter, CentreSample, CoverageMethod, Gaussian, Grid, InsideArea, Rooks,
        SamplePattern, SignedArea, SubScanlines,
    },
    draw::{FillRule, FilteredLine, SubOutline},
    geometry::{Sub8, SubPoint, TooSmall, Window},
};

use crate::{
    families::draw::antialiased::{Outline, Prepared, WithOutline},
    target::{Case, Verdict},
    values::{Int, Rule, Stage, SubContours, SubSpot},
};

/// The coverage of the pixels of a window.
#[derive(Debug, Clone, PartialEq, Eq)]
struct CoverageMask {
    window: Window,
    coverages: Vec<Option<u8>>,
    last: Option<Span>,
}

/// Why handing over stopped.
#[derive(Debug, PartialEq, Eq)]
enum Stop {
    RowMemory(TooSmall),
    Told,
    Wrong(String),
}

impl From<TooSmall> for Stop {
    fn from(error: TooSmall) -> Self {
        Self::RowMemory(error)
    }
}

impl CoverageMask {
    fn new(window: Window) -> Self {
        let pixels = window.width() as usize * window.height() as usize;
        Self {
            window,
            coverages: vec![None; pixels],
            last: None,
        }
    }

    /// Takes a span: inside, behind the one before, each pixel once.
    fn take(&mut self, span: Span, coverage: u8) -> Result<(), Stop> {
        let is_inside = !span.is_empty() && span.to_window().intersection(&self.window) == span.to_window();
        let follows = self
            .last
            .is_none_or(|last| last.y < span.y || last.y == span.y && last.end <= span.start);
        if !is_inside || !follows {
            return Err(Stop::Wrong(format!(
                "{span:?} after {:?} in {:?}",
                self.last, self.window
            )));
        }
        self.last = Some(span);
        for x in span.start..span.end {
            let (column, row) = (x.abs_diff(self.window.left), span.y.abs_diff(self.window.top));
            self.coverages[(row * self.window.width() + column) as usize] = Some(coverage);
        }
        Ok(())
    }

    fn at(&self, x: i32, y: i32) -> u8 {
        let (column, row) = (x.abs_diff(self.window.left), y.abs_diff(self.window.top));
        self.coverages[(row * self.window.width() + column) as usize].unwrap_or(0)
    }

    fn sum(&self) -> i64 {
        self.coverages
            .iter()
            .flatten()
            .map(|coverage| i64::from(*coverage))
            .sum()
    }
}

fn cover<T: CoverageMethod>(method: &T, polygon: &Prepared, window: &Window) -> anyhow::Result<CoverageMask>
where
    T::Cell: PartialEq,
{
    let mut memory = vec![T::Cell::default(); T::cells(window.width() as usize)];
    let mut coverages = CoverageMask::new(*window);
    let covered = polygon.cover(method, window, &mut memory, |span, coverage| {
        coverages.take(span, coverage)
    });
    ensure!(covered == Ok(()), "{covered:?}");
    let is_clean = memory.iter().all(|cell| *cell == T::Cell::default());
    ensure!(is_clean, "the row memory is not as it was");
    Ok(coverages)
}

fn is_part(whole: &CoverageMask, part: &CoverageMask) -> Verdict {
    let Window {
        left,
        top,
        right,
        bottom,
    } = part.window;
    for y in top..bottom {
        for x in left..right {
            let (expected, found) = (whole.at(x, y), part.at(x, y));
            ensure!(
                expected == found,
                "({x}, {y}) is covered by {expected} in {:?}, by {found} in {:?}",
                whole.window,
                part.window
            );
        }
    }
    Ok(())
}

/// An outline in a method.
#[derive(Debug, Arbitrary)]
pub struct MethodCase {
    stage: Stage,
    outline: Outline,
    rule: Rule,
    method: Method,
    lacks: u8,
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Method {
    CentreSample,
    Rooks4,
    Rooks8,
    Rooks16,
    SubScanlines4,
    SubScanlines16,
    Grid2,
    Grid4,
    Grid16,
    GridBartlett,
    GridGaussian,
    SignedArea,
    InsideArea,
    Chosen,
}

impl MethodCase {
    fn check_method<T: CoverageMethod>(&self, method: &T, polygon: &Prepared) -> Verdict
    where
        T::Cell: PartialEq,
    {
        let Self { stage, .. } = self;
        let window = stage.window;
        let whole = cover(method, polygon, &window)?;
        for rows in [1, stage.rows] {
            for band in stage.bands(rows) {
                is_part(&whole, &cover(method, polygon, &band)?)?;
            }
        }
        // Pixels do not depend on the window's sides.
        is_part(&whole, &cover(method, polygon, &stage.part)?)?;
        // Row memory that is too small is an error before anything is handed over.
        let needed = T::cells(window.width() as usize);
        let lacking = usize::from(self.lacks).min(needed);
        if lacking > 0 {
            let mut memory = vec![T::Cell::default(); needed - lacking];
            let covered = polygon.cover(method, &window, &mut memory, |_, _| Err(Stop::Told));
            ensure!(
                covered == Err(Stop::RowMemory(TooSmall::Cells(needed))),
                "{covered:?} of {needed} cells"
            );
        }
        // After an error the row memory is as it was, and the same again gives the same picture.
        let mut memory = vec![T::Cell::default(); needed];
        let mut spans = stage.rows;
        let _ = polygon.cover(method, &window, &mut memory, |_, _| {
            spans -= 1;
            if spans == 0 { Err(Stop::Told) } else { Ok(()) }
        });
        let mut again = CoverageMask::new(window);
        let covered = polygon.cover(method, &window, &mut memory, |span, coverage| {
            again.take(span, coverage)
        });
        ensure!(covered == Ok(()), "{covered:?} after an error");
        is_part(&whole, &again).context("after an error")
    }

    fn check_samples<T: SamplePattern>(&self, method: &T, polygon: &Prepared) -> Verdict
    where
        T::Cell: PartialEq,
    {
        self.check_method(method, polygon)?;
        let positions: Vec<_> = T::positions().collect();
        ensure!(
            positions.len() == T::SAMPLES,
            "{} positions of {} samples",
            positions.len(),
            T::SAMPLES
        );
        ensure!(
            positions.iter().flatten().all(|position| (0..256).contains(position)),
            "a sample outside of its pixel: {positions:?}"
        );
        Ok(())
    }
}

struct CheckMethod<'c>(&'c MethodCase);

impl WithOutline for CheckMethod<'_> {
    fn check<O: SubOutline + ?Sized>(self, outline: &O) -> Verdict {
        let case = self.0;
        let Ok(polygon) = Prepared::prepare(outline, case.rule.get()) else {
            return Ok(());
        };
        match case.method {
            Method::CentreSample => case.check_method(&CentreSample, &polygon),
            Method::Rooks4 => case.check_samples(&Rooks::<4>, &polygon),
            Method::Rooks8 => case.check_samples(&Rooks::<8>, &polygon),
            Method::Rooks16 => case.check_samples(&Rooks::<16>, &polygon),
            Method::SubScanlines4 => case.check_method(&SubScanlines::<4>, &polygon),
            Method::SubScanlines16 => case.check_method(&SubScanlines::<16>, &polygon),
            Method::Grid2 => case.check_samples(&Grid::<2>::new(), &polygon),
            Method::Grid4 => case.check_samples(&Grid::<4, BoxFilter>::new(), &polygon),
            Method::Grid16 => case.check_method(&Grid::<16>::new(), &polygon),
            Method::GridBartlett => case.check_method(&Grid::<4, Bartlett>::new(), &polygon),
            Method::GridGaussian => case.check_method(&Grid::<8, Gaussian>::new(), &polygon),
            Method::SignedArea => case.check_method(&SignedArea, &polygon),
            Method::InsideArea => case.check_method(&InsideArea, &polygon),
            Method::Chosen => case.check_method(&AnyCoverage::default(), &polygon),
        }
    }
}

impl Case for MethodCase {
    fn check(&self) -> Verdict {
        self.outline.with(&self.stage, self.rule.get(), CheckMethod(self))
    }
}

/// Areas that add up.
#[derive(Debug, Arbitrary)]
pub struct AreaCase {
    stage: Stage,
    contours: SubContours<2, 6>,
    corners: [SubSpot; 3],
}

/// What rounding coverage takes, in 1/255 of a pixel: half of one, and what the exact methods promise besides.
const ROUNDING: f64 = 0.7;

/// What both coverages of a pixel may be off together, in 1/255, where edges cross.
const CROSSINGS: u32 = 2 * 4;

impl Case for AreaCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        if !stage.is_in_domain() {
            return Ok(());
        }
        // With a frame around the window, the inside by the even-odd rule is what was outside.
        let window = stage.window;
        let units = |pixel: i32| pixel * 256;
        let corner = |x: i32, y: i32| SubPoint::<Sub8>::from_units(units(x) - 128 * 5, units(y) - 128 * 5);
        let frame = vec![
            corner(window.left, window.top)?,
            corner(window.right + 6, window.top)?,
            corner(window.right + 6, window.bottom + 6)?,
            corner(window.left, window.bottom + 6)?,
        ];
        let mut contours = self.contours.inside::<Sub8>(stage);
        let slices: Vec<_> = contours.iter().map(Vec::as_slice).collect();
        let rule = FillRule::EvenOdd;
        let inside = Prepared::prepare(slices.as_slice(), rule).context("room for all edges")?;
        contours.push(frame);
        let slices: Vec<_> = contours.iter().map(Vec::as_slice).collect();
        let outside = Prepared::prepare(slices.as_slice(), rule).context("room for all edges")?;
        let (inside, outside) = (
            cover(&InsideArea, &inside, &window)?,
            cover(&InsideArea, &outside, &window)?,
        );
        for y in window.top..window.bottom {
            for x in window.left..window.right {
                let sum = u32::from(inside.at(x, y)) + u32::from(outside.at(x, y));
                ensure!(
                    sum.abs_diff(255) <= CROSSINGS,
                    "inside and outside of ({x}, {y}) add up to {sum}"
                );
            }
        }
        // The coverage of a triangle adds up to its area.
        let triangle: [SubPoint<Sub8>; 3] = self.corners.map(|corner| corner.inside(stage));
        let is_inside = |point: &SubPoint<Sub8>| {
            let between = |low: i32, units: i32, high: i32| low * 256 - 128 <= units && units <= high * 256 - 128;
            between(window.left, point.x_units(), window.right) && between(window.top, point.y_units(), window.bottom)
        };
        if triangle.iter().all(is_inside) {
            let [a, b, c] = triangle.map(|point| [i64::from(point.x_units()), i64::from(point.y_units())]);
            let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            let area = doubled.abs() as f64 / 2.0 / 65_536.0;
            let polygon =
                Prepared::prepare(&[triangle.as_slice()], FillRule::NonZero).context("room for three edges")?;
            for coverages in [
                cover(&SignedArea, &polygon, &window)?,
                cover(&InsideArea, &polygon, &window)?,
            ] {
                let touched = coverages
                    .coverages
                    .iter()
                    .flatten()
                    .filter(|coverage| **coverage < 255)
                    .count();
                // A pixel with less than half coverage has none.
                let most = ROUNDING * (touched + stage.pixels()) as f64;
                let off = (coverages.sum() as f64 - 255.0 * area).abs();
                ensure!(off <= most, "{off}/255 pixels off of {area}, {most} for rounding");
            }
        }
        Ok(())
    }
}

/// A filtered segment in any window.
#[derive(Debug, Arbitrary)]
pub struct FilteredCase {
    stage: Stage,
    ends: [SubSpot; 2],
    any: [Int; 4],
}

impl FilteredCase {
    fn cover(segment: &FilteredLine, window: &Window) -> anyhow::Result<CoverageMask> {
        let mut coverages = CoverageMask::new(*window);
        // Steep segments come column by column.
        let mut taken = vec![0u8; coverages.coverages.len()];
        let covered = segment.cover(window, |span, coverage| {
            coverages.last = None;
            coverages.take(span, coverage)?;
            for x in span.start..span.end {
                let (column, row) = (x.abs_diff(window.left), span.y.abs_diff(window.top));
                taken[(row * window.width() + column) as usize] += 1;
            }
            Ok::<(), Stop>(())
        });
        ensure!(covered == Ok(()), "{covered:?}");
        ensure!(taken.iter().all(|times| *times <= 1), "a pixel comes twice");
        Ok(coverages)
    }
}

impl Case for FilteredCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        let [from, to]: [SubPoint<Sub8>; 2] = self.ends.map(|end| end.by_hand(stage));
        let Ok(segment) = FilteredLine::new(from, to) else {
            return Ok(());
        };
        let whole = Self::cover(&segment, &stage.window)?;
        for rows in [1, stage.rows] {
            for band in stage.bands(rows) {
                is_part(&whole, &Self::cover(&segment, &band)?)?;
            }
        }
        is_part(&whole, &Self::cover(&segment, &stage.part)?)?;
        let reversed = FilteredLine::new(to, from).context("the other order")?;
        is_part(&whole, &Self::cover(&reversed, &stage.window)?).context("from the other end")?;
        let bounds = Window::from(segment.bounding_box());
        for y in stage.window.top..stage.window.bottom {
            for x in stage.window.left..stage.window.right {
                let is_inside = bounds.contains(embedded_graphics::geometry::Point::new(x, y));
                ensure!(is_inside || whole.at(x, y) == 0, "({x}, {y}) is outside of {bounds:?}");
            }
        }
        // Any window: the work is bounded by what is visible of it in the domain, so one error ends it.
        let [left, top, right, bottom] = self.any.map(|side| side.0);
        let window = Window {
            left,
            top,
            right,
            bottom,
        };
        let stopped = segment.cover(&window, |span, _| {
            let inside = span.to_window().intersection(&window) == span.to_window();
            Err(if inside {
                Stop::Told
            } else {
                Stop::Wrong(format!("{span:?}"))
            })
        });
        ensure!(matches!(stopped, Ok(()) | Err(Stop::Told)), "{stopped:?} in {window:?}");
        Ok(())
    }
}
