//! The picture: a panel for each stage, one below the other.

use anyhow::anyhow;
use embedded_graphics::{
    pixelcolor::{Rgb565, raw::RawU16},
    prelude::*,
};
use epaint_default_fonts::UBUNTU_LIGHT;
use plotters::{
    coord::Shift,
    prelude::*,
    style::{
        FontStyle, TextStyle, register_font,
        text_anchor::{HPos, Pos, VPos},
    },
};

use crate::row::{self, COLUMNS, OUTLINE, ROW, ROWS, Row};

const FONT: &str = "sans-serif";
const SIZE: (u32, u32) = (960, 700);
/// The left side of pixel 0, and the width of a pixel.
const LEFT: i32 = 250;
const PIXEL: i32 = 56;
const INK: RGBColor = RGBColor(40, 40, 40);
const FAINT: RGBColor = RGBColor(205, 205, 205);
const ROW_COLOR: RGBColor = RGBColor(255, 240, 200);
const SHAPE: RGBColor = RGBColor(255, 69, 0);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The text of the SVG file.
///
/// # Errors
/// The font cannot be read.
pub fn svg() -> anyhow::Result<String> {
    register_font(FONT, FontStyle::Normal, UBUNTU_LIGHT).map_err(|_| anyhow!("the font cannot be read"))?;
    let row = row::draw()?;
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        outline(&area)?;
        segments(&area)?;
        cells(&area)?;
        coverage(&area, &row)?;
        words(&area, &row)?;
        area.present()?;
    }
    Ok(text)
}

fn x(pixels: f64) -> i32 {
    LEFT + (pixels * f64::from(PIXEL)).round() as i32
}

/// A text with its middle or its left end at a point.
fn label(area: &Area<'_>, text: &str, at: (i32, i32), size: i32, centred: bool) -> anyhow::Result<()> {
    let position = Pos::new(if centred { HPos::Center } else { HPos::Left }, VPos::Center);
    let style = TextStyle::from((FONT, size)).color(&INK).pos(position);
    area.draw(&Text::new(text.to_owned(), at, style))?;
    Ok(())
}

/// The name of a stage, and what it does, left of its panel.
fn stage(area: &Area<'_>, name: &str, lines: &[&str], middle: i32) -> anyhow::Result<()> {
    let top = middle - 9 * lines.len() as i32;
    label(area, name, (14, top), 19, false)?;
    for (line, y) in lines.iter().zip((top + 20..).step_by(16)) {
        label(area, line, (14, y), 13, false)?;
    }
    Ok(())
}

/// The pixels of one row.
fn boxes(area: &Area<'_>, top: i32, bottom: i32) -> anyhow::Result<()> {
    for column in 0..COLUMNS {
        let corners = [(x(column as f64), top), (x(column as f64 + 1.0), bottom)];
        area.draw(&Rectangle::new(corners, FAINT))?;
    }
    Ok(())
}

fn outline(area: &Area<'_>) -> anyhow::Result<()> {
    const TOP: i32 = 14;
    const HEIGHT: i32 = 24;
    let y = |pixels: f64| TOP + (pixels * f64::from(HEIGHT)).round() as i32;
    stage(
        area,
        "draw, geometry",
        &["an outline in 1/256 pixel;", "one row of the band is drawn"],
        90,
    )?;
    let row = [(x(0.0), y(f64::from(ROW))), (x(COLUMNS as f64), y(f64::from(ROW + 1)))];
    area.draw(&Rectangle::new(row, ROW_COLOR.filled()))?;
    for row in 0..ROWS {
        boxes(area, y(f64::from(row)), y(f64::from(row + 1)))?;
    }
    let corner =
        |&(units_x, units_y): &(i32, i32)| (x(f64::from(units_x) / 256.0 + 0.5), y(f64::from(units_y) / 256.0 + 0.5));
    let corners: Vec<_> = OUTLINE.iter().map(corner).collect();
    area.draw(&Polygon::new(corners.clone(), SHAPE.mix(0.2)))?;
    let closed: Vec<_> = corners.iter().chain(corners.first()).copied().collect();
    area.draw(&PathElement::new(closed, SHAPE.stroke_width(2)))?;
    Ok(())
}

fn segments(area: &Area<'_>) -> anyhow::Result<()> {
    const TOP: i32 = 208;
    stage(
        area,
        "coverage: edges",
        &["one segment of each edge", "that meets the row"],
        245,
    )?;
    let y = |pixels: f64| TOP + ((pixels - f64::from(ROW)) * 70.0).round() as i32;
    area.draw(&Rectangle::new(
        [(x(0.0), TOP), (x(COLUMNS as f64), TOP + 70)],
        ROW_COLOR.filled(),
    ))?;
    boxes(area, TOP, TOP + 70)?;
    for ends in row::segments() {
        let ends = ends.map(|(column, row)| (x(column), y(row)));
        area.draw(&PathElement::new(ends.to_vec(), SHAPE.stroke_width(3)))?;
    }
    Ok(())
}

fn cells(area: &Area<'_>) -> anyhow::Result<()> {
    const TOP: i32 = 312;
    stage(
        area,
        "coverage: area",
        &["a cell for each pixel that an", "edge crosses: cover and area"],
        340,
    )?;
    boxes(area, TOP, TOP + 56)?;
    for (column, (cover, cell_area)) in row::cells().into_iter().enumerate() {
        if cover != 0.0 || cell_area != 0.0 {
            let middle = x(column as f64 + 0.5);
            label(area, &format!("{cover:+.2}"), (middle, TOP + 18), 14, true)?;
            label(area, &format!("{cell_area:+.2}"), (middle, TOP + 39), 14, true)?;
        }
    }
    Ok(())
}

fn coverage(area: &Area<'_>, row: &Row) -> anyhow::Result<()> {
    const TOP: i32 = 402;
    stage(
        area,
        "coverage: sweep",
        &["covers to the left and the", "pixel's own area: 0 to 255"],
        428,
    )?;
    for (column, value) in row.coverage.into_iter().enumerate() {
        let corners = [(x(column as f64), TOP), (x(column as f64 + 1.0), TOP + 50)];
        area.draw(&Rectangle::new(corners, SHAPE.mix(f64::from(value) / 255.0).filled()))?;
        label(area, &value.to_string(), (x(column as f64 + 0.5), TOP + 25), 15, true)?;
    }
    boxes(area, TOP, TOP + 50)
}

fn words(area: &Area<'_>, row: &Row) -> anyhow::Result<()> {
    const TOP: i32 = 486;
    stage(
        area,
        "shade, band",
        &["the colour over what was", "there, in the band's words"],
        520,
    )?;
    for (column, &word) in row.words.iter().enumerate() {
        let color = Rgb565::from(RawU16::new(word));
        let level = |channel: u8, most: u8| (u32::from(channel) * 255 / u32::from(most)) as u8;
        let fill = RGBColor(level(color.r(), 31), level(color.g(), 63), level(color.b(), 31));
        let corners = [(x(column as f64), TOP), (x(column as f64 + 1.0), TOP + 50)];
        area.draw(&Rectangle::new(corners, fill.filled()))?;
        label(
            area,
            &format!("{word:04x}"),
            (x(column as f64 + 0.5), TOP + 64),
            14,
            true,
        )?;
    }
    boxes(area, TOP, TOP + 50)?;
    const SINK: i32 = 602;
    stage(
        area,
        "band: sink",
        &["sends the words to the panel;", "the next row takes their place"],
        625,
    )?;
    let (start, end) = ((x(0.0), SINK + 24), (x(COLUMNS as f64), SINK + 24));
    area.draw(&PathElement::new(vec![start, end], INK.stroke_width(2)))?;
    let tip = vec![(end.0, end.1), (end.0 - 14, end.1 - 7), (end.0 - 14, end.1 + 7)];
    area.draw(&Polygon::new(tip, INK.filled()))?;
    label(
        area,
        "SPI, DMA, a frame buffer: whatever a Sink does",
        (x(COLUMNS as f64 / 2.0), SINK + 8),
        14,
        true,
    )
}
