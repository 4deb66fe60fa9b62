//! Polygons and paths: filled from tables of any size, stroked without one.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Dimensions, Point},
    pixelcolor::Rgb565,
    prelude::Primitive,
    primitives::PointsIter,
};
use zrow::{
    draw::{Path, Polygon, PrimitiveStyle},
    geometry::{Sub4, Sub8, SubPixel, SubPoint, TooSmall, Vertex},
};

use crate::{
    exact,
    picture::{Work, agree, agree_styled, agree_with_drawable, background, full_picture, is_same},
    target::{Case, Verdict},
    values::{ByHand, Command, Contours, Hue, List, Rule, Stage, Style, SubContours, Tolerance, commands},
};

/// Edges and active edges of a table that has room for every polygon here.
const ENOUGH: usize = 48;

/// Whether an error of a small table names more places than it has, and no more than there are edges.
fn is_right(full: TooSmall, capacities: [usize; 2], edges: usize) -> Verdict {
    let (capacity, is_exact) = match full {
        TooSmall::Edges(needed) => (capacities[0], needed == edges),
        TooSmall::ActiveEdges(needed) => (capacities[1], needed <= edges),
        other => anyhow::bail!("{other}: no table of a polygon"),
    };
    ensure!(
        capacity < full.needed() && is_exact,
        "{full}, where there are {capacity} and {edges} edges"
    );
    Ok(())
}

/// What a polygon's style is, and how it is filled.
#[derive(Debug, Arbitrary)]
pub struct Look {
    rule: Rule,
    style: Style,
}

fn check_polygon<V: Vertex>(stage: &Stage, contours: &[Vec<V>], look: &Look) -> Verdict {
    let slices: Vec<&[V]> = contours.iter().map(Vec::as_slice).collect();
    let polygon = Polygon::new(&slices, look.rule.get());
    let prepared = polygon
        .prepare::<ENOUGH, ENOUGH>()
        .context("a table with room for all edges")?;
    agree_styled(stage, &prepared, look.style, Work::ONCE)?;

    let color = Hue::Odd.color();
    let filled = PrimitiveStyle::with_fill(color);
    let picture = full_picture(stage.window, &prepared.into_styled(filled))?;
    let exact_contours: Vec<Vec<[i128; 2]>> = contours
        .iter()
        .map(|contour| {
            let units = contour
                .iter()
                .map(|vertex| [vertex.x_units().into(), vertex.y_units().into()]);
            units.collect()
        })
        .collect();
    let belongs = |pixel: Point| {
        let units = |coordinate: i32| i128::from(coordinate) << V::FRACTION_BITS;
        let winding = exact::winding(&exact_contours, [units(pixel.x), units(pixel.y)]);
        look.rule.get().includes(winding)
    };
    let expected: Vec<Rgb565> = stage
        .area()
        .points()
        .map(|pixel| if belongs(pixel) { color } else { background() })
        .collect();
    is_same(&stage.window, &expected, &picture).context("by definition, the other filled")?;

    let edges = prepared.edge_count();
    match polygon.prepare::<4, 2>() {
        Ok(small) => {
            ensure!(edges <= 4, "{edges} edges in a table for 4");
            let picture = full_picture(stage.window, &small.into_styled(filled))?;
            is_same(&stage.window, &expected, &picture).context("by definition, the other from a small table")
        }
        Err(full) => is_right(full, [4, 2], edges),
    }
}

/// Contours of whole pixels.
#[derive(Debug, Arbitrary)]
pub struct PixelPolygonCase {
    stage: Stage,
    contours: Contours<3, 8>,
    look: Look,
}

impl Case for PixelPolygonCase {
    fn check(&self) -> Verdict {
        check_polygon(&self.stage, &self.contours.get(&self.stage), &self.look)
    }
}

/// Contours between pixels, at either precision.
#[derive(Debug, Arbitrary)]
pub struct SubPolygonCase {
    stage: Stage,
    contours: SubContours<3, 8>,
    is_fine: bool,
    /// Points made by hand may be outside the domain.
    by_hand: bool,
    look: Look,
}

impl SubPolygonCase {
    fn check_at<S: ByHand>(&self) -> Verdict {
        let contours: Vec<Vec<SubPoint<S>>> = if self.by_hand {
            self.contours.by_hand(&self.stage)
        } else {
            self.contours.inside(&self.stage)
        };
        check_polygon(&self.stage, &contours, &self.look)
    }
}

impl Case for SubPolygonCase {
    fn check(&self) -> Verdict {
        if self.is_fine {
            self.check_at::<Sub8>()
        } else {
            self.check_at::<Sub4>()
        }
    }
}

/// Lines and curves, stroked and filled.
#[derive(Debug, Arbitrary)]
pub struct PathCase {
    stage: Stage,
    commands: List<Command, 6>,
    is_fine: bool,
    by_hand: bool,
    tolerance: Tolerance,
    look: Look,
}

impl PathCase {
    fn check_at<S: ByHand>(&self) -> Verdict {
        let Self { stage, look, .. } = self;
        let commands = commands::<S, 6>(&self.commands, stage, !self.by_hand);
        let Ok(path) = Path::new(&commands, look.rule.get()) else {
            ensure!(
                self.by_hand || S::MAX_UNITS > Sub8::MAX_UNITS,
                "points of the domain are outside of it"
            );
            return Ok(());
        };
        let path = path.with_tolerance(self.tolerance.0);
        let style = look.style.get();
        let is_wide = style.stroke_width > 1;
        // Every line of a flattened curve may cross the picture.
        let lines = Work::parts(6 * 4_096);
        let stroked = path.into_styled(style);
        let picture = agree(stage, &stroked, if is_wide { Work::ONCE } else { lines })?;
        agree_with_drawable(stage, &picture, &stroked)?;

        let filled = PrimitiveStyle::with_fill(Hue::Odd.color());
        let small = path.prepare::<16, 4>();
        match path.prepare::<256, 64>() {
            Ok(prepared) => {
                // Its stroke is drawn over its fill.
                let work = if is_wide { Work::parts(2) } else { lines };
                let picture = agree_styled(stage, &prepared, look.style, work)?;
                ensure!(picture.len() == stage.pixels(), "a picture of another size");
                let edges = prepared.edge_count();
                let picture = full_picture(stage.window, &prepared.into_styled(filled))?;
                match small {
                    Ok(small) => {
                        let other = full_picture(stage.window, &small.into_styled(filled))?;
                        is_same(&stage.window, &picture, &other).context("a large table, a small one")
                    }
                    Err(full) => is_right(full, [16, 4], edges),
                }
            }
            Err(full) => {
                ensure!(
                    small.is_err(),
                    "a small table has room where a large one has none: {full}"
                );
                ensure!(full.needed() > 64, "{full}, where there are 256 and 64");
                Ok(())
            }
        }
        .and_then(|()| {
            let bounds = path.bounding_box();
            ensure!(
                !commands.is_empty() || bounds.is_zero_sized(),
                "an empty path has the box {bounds:?}"
            );
            Ok(())
        })
    }
}

impl Case for PathCase {
    fn check(&self) -> Verdict {
        if self.is_fine {
            self.check_at::<Sub8>()
        } else {
            self.check_at::<Sub4>()
        }
    }
}
