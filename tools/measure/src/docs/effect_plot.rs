//! The chart of `docs/effects.md`: a bar for each effect, as long as a frame takes cycles, with flash and RAM beside it.

use anyhow::Context;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use crate::{
    docs::{
        effect_cost::Cost,
        plot::{Area, FAINT, INK, label, with_font},
    },
    report::grouped,
};

const WIDTH: i32 = 860;
/// Where bars begin, and where the longest one ends.
const LEFT: i32 = 300;
const RIGHT: i32 = 600;
const TOP: i32 = 74;
const LINE: i32 = 26;
/// What a plain frame takes, and what the effect adds.
const PLAIN: RGBColor = RGBColor(150, 175, 205);
const ADDED: RGBColor = RGBColor(20, 90, 170);

/// The text of the SVG file.
///
/// # Errors
/// The font cannot be read, or nothing was measured.
pub fn svg(costs: &[Cost]) -> anyhow::Result<String> {
    with_font()?;
    let plain = costs.first().context("a chart of nothing")?.m4[1];
    let most = costs
        .iter()
        .map(|cost| cost.m4[1])
        .max()
        .context("a chart of nothing")?;
    let height = TOP + LINE * costs.len() as i32 + 14;
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, (WIDTH as u32, height as u32)).into_drawing_area();
        area.fill(&WHITE)?;
        captions(&area)?;
        for (index, cost) in costs.iter().enumerate() {
            bar(&area, cost, TOP + LINE * index as i32, plain, most)?;
        }
        area.draw(&PathElement::new([(LEFT, TOP - 6), (LEFT, height - 10)], INK))?;
        area.present()?;
    }
    Ok(text)
}

/// What is drawn, and what the columns are.
fn captions(area: &Area<'_>) -> anyhow::Result<()> {
    let title = "A frame of the Utah teapot, 992 faces, 240 x 320 pixels, Cortex-M4 without FPU";
    label(area, title, (WIDTH / 2, 20), 17, INK, (HPos::Center, VPos::Center))?;
    let middle = VPos::Center;
    label(area, "estimated cycles", (LEFT, 52), 14, INK, (HPos::Left, middle))?;
    label(area, "flash", (WIDTH - 96, 52), 14, INK, (HPos::Right, middle))?;
    label(area, "RAM", (WIDTH - 20, 52), 14, INK, (HPos::Right, middle))?;
    Ok(())
}

/// The line of an effect: its name, its bar, and its figures.
fn bar(area: &Area<'_>, cost: &Cost, top: i32, plain: u64, most: u64) -> anyhow::Result<()> {
    let x = |cycles: u64| LEFT + (cycles as f64 / most as f64 * f64::from(RIGHT - LEFT)).round() as i32;
    let cycles = cost.m4[1];
    let middle = top + LINE / 2;
    label(
        area,
        &cost.what,
        (LEFT - 10, middle),
        14,
        INK,
        (HPos::Right, VPos::Center),
    )?;
    let (top, bottom) = (top + 4, top + LINE - 4);
    area.draw(&Rectangle::new(
        [(LEFT, top), (x(cycles.min(plain)), bottom)],
        PLAIN.filled(),
    ))?;
    if cycles > plain {
        area.draw(&Rectangle::new([(x(plain), top), (x(cycles), bottom)], ADDED.filled()))?;
    }
    let place = (HPos::Left, VPos::Center);
    label(area, &grouped(cycles as f64), (x(cycles) + 8, middle), 13, INK, place)?;
    for (bytes, right) in [(cost.flash, WIDTH - 96), (cost.ram, WIDTH - 20)] {
        label(
            area,
            &grouped(bytes as f64),
            (right, middle),
            13,
            INK,
            (HPos::Right, VPos::Center),
        )?;
    }
    area.draw(&PathElement::new(
        [(LEFT, middle + LINE / 2), (WIDTH - 20, middle + LINE / 2)],
        FAINT,
    ))?;
    Ok(())
}
