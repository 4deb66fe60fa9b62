//! The chart of `docs/visibility.md` and those of the accuracy report: cycles or instructions of a frame over the number of faces and
//! of layers, a curve for each method, on logarithmic axes.

use anyhow::Context;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use zrow_methods::HIDDEN_SURFACES;

use crate::{
    docs::plot::{Area, FAINT, INK, label, part, with_font},
    report::grouped,
    visibility::{AXES, Axis, Counts},
};

const SIZE: (i32, i32) = (1180, 470);
const TOP: i32 = 70;
const BOTTOM: i32 = SIZE.1 - 96;
/// The left sides of the panels, and how wide each is.
const LEFT: i32 = 110;
const PANEL: i32 = 310;
const STEP: i32 = 355;
/// Labels that are closer than this would overlap.
const CLOSE: i32 = 40;

const COLORS: [RGBColor; HIDDEN_SURFACES.len()] = [
    RGBColor(20, 90, 170),
    RGBColor(200, 70, 20),
    RGBColor(60, 140, 60),
    RGBColor(130, 90, 170),
    RGBColor(190, 150, 20),
    RGBColor(200, 60, 120),
    RGBColor(90, 90, 90),
    RGBColor(150, 110, 70),
    RGBColor(40, 170, 180),
];

/// What a chart shows of a count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cost {
    Instructions,
    Cycles,
}

impl Cost {
    /// What it is called in a title.
    pub fn title(self) -> &'static str {
        match self {
            Self::Instructions => "instructions",
            Self::Cycles => "estimated cycles",
        }
    }

    /// From a count in thousands.
    fn of(self, [instructions, cycles]: [u64; 2]) -> f64 {
        let thousands = match self {
            Self::Instructions => instructions,
            Self::Cycles => cycles,
        };
        thousands as f64 * 1000.0
    }
}

/// The text of the SVG file, from what was counted on each axis of a core in thousands, as the tables have it.
///
/// # Errors
/// The font cannot be read, or nothing was measured.
pub fn svg(counts: &[Counts], core: &str, cost: Cost) -> anyhow::Result<String> {
    with_font()?;
    let all = counts.iter().flatten().flatten().flatten().map(|count| cost.of(*count));
    let (least, most) = all.fold((f64::MAX, 0.0f64), |(least, most), number| {
        (least.min(number), most.max(number))
    });
    let range = (most > 0.0)
        .then_some([least / 1.5, most * 1.5])
        .context("a plot of nothing")?;
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, (SIZE.0 as u32, SIZE.1 as u32)).into_drawing_area();
        area.fill(&WHITE)?;
        let cost_title = cost.title();
        let title = format!("A frame of 128 x 64 pixels by each method of visibility, {core}: {cost_title}");
        label(&area, &title, (SIZE.0 / 2, 20), 17, INK, (HPos::Center, VPos::Center))?;
        for ((axis, counts), panel) in AXES.iter().zip(counts).zip(0..) {
            Panel {
                axis,
                cost,
                left: LEFT + STEP * panel,
                range,
            }
            .draw(&area, counts, panel == 0)?;
        }
        legend(&area)?;
        area.present()?;
    }
    Ok(text)
}

/// One of the plots beside each other.
struct Panel<'a> {
    axis: &'a Axis,
    cost: Cost,
    left: i32,
    /// The least and the greatest cost.
    range: [f64; 2],
}

impl Panel<'_> {
    fn x(&self, number: usize) -> i32 {
        let ends = [self.axis.stages.first(), self.axis.stages.last()];
        let ends = ends.map(|stage| stage.map_or(1.0, |stage| stage.number as f64));
        self.left + (part(number as f64, ends) * f64::from(PANEL)).round() as i32
    }

    fn y(&self, cost: f64) -> i32 {
        BOTTOM - (part(cost, self.range) * f64::from(BOTTOM - TOP)).round() as i32
    }

    fn draw(&self, area: &Area<'_>, counts: &Counts, has_labels: bool) -> anyhow::Result<()> {
        self.grid(area, has_labels)?;
        for (counts, color) in counts.iter().zip(COLORS) {
            let points = self.axis.stages.iter().zip(counts);
            let points = points
                .filter_map(|(stage, count)| count.map(|count| (self.x(stage.number), self.y(self.cost.of(count)))));
            let points: Vec<_> = points.collect();
            area.draw(&PathElement::new(points.clone(), color.stroke_width(2)))?;
            for point in points {
                area.draw(&Circle::new(point, 3, color.filled()))?;
            }
        }
        Ok(())
    }

    /// A line for each power of ten and for each scene, the axes, and what they are.
    fn grid(&self, area: &Area<'_>, has_labels: bool) -> anyhow::Result<()> {
        let [least, most] = self.range;
        let right = self.left + PANEL;
        let powers = (0..12).map(|power| 10f64.powi(power));
        for power in powers.filter(|power| (least..=most).contains(power)) {
            let y = self.y(power);
            area.draw(&PathElement::new([(self.left, y), (right, y)], FAINT))?;
            if has_labels {
                label(
                    area,
                    &grouped(power),
                    (self.left - 8, y),
                    13,
                    INK,
                    (HPos::Right, VPos::Center),
                )?;
            }
        }
        // Right to left: a label that has no room beside the one on its right ends at its line.
        let mut right_label = i32::MAX;
        for stage in self.axis.stages.iter().rev() {
            let x = self.x(stage.number);
            area.draw(&PathElement::new([(x, TOP), (x, BOTTOM)], FAINT))?;
            let side = if right_label.saturating_sub(x) < CLOSE {
                HPos::Right
            } else {
                HPos::Center
            };
            let number = grouped(stage.number as f64);
            label(area, &number, (x, BOTTOM + 8), 13, INK, (side, VPos::Top))?;
            right_label = x;
        }
        area.draw(&PathElement::new(
            [(self.left, TOP), (self.left, BOTTOM), (right, BOTTOM)],
            INK,
        ))?;
        let middle = (self.left + PANEL / 2, TOP - 18);
        label(area, self.axis.title, middle, 15, INK, (HPos::Center, VPos::Center))
    }
}

/// The colour of each method.
fn legend(area: &Area<'_>) -> anyhow::Result<()> {
    let step = (SIZE.0 - 60) / HIDDEN_SURFACES.len() as i32;
    for ((method, color), index) in HIDDEN_SURFACES.iter().zip(COLORS).zip(0..) {
        let (x, y) = (40 + step * index, SIZE.1 - 34);
        area.draw(&PathElement::new([(x, y), (x + 22, y)], color.stroke_width(3)))?;
        label(area, method.title, (x + 28, y), 14, INK, (HPos::Left, VPos::Center))?;
    }
    Ok(())
}
