//! The plot of `docs/band-height.md`: cycles of a frame over the height of a band, prepared and replayed, on logarithmic axes.

use anyhow::{Context, anyhow};
use epaint_default_fonts::UBUNTU_LIGHT;
use plotters::{
    coord::Shift,
    prelude::*,
    style::{
        FontStyle, TextStyle, register_font,
        text_anchor::{HPos, Pos, VPos},
    },
};

use crate::{docs::bands::Bands, report::grouped};

const FONT: &str = "sans-serif";
const SIZE: (i32, i32) = (760, 470);
/// The box that the curves are drawn in.
const LEFT: i32 = 96;
const TOP: i32 = 54;
const RIGHT: i32 = SIZE.0 - 44;
const BOTTOM: i32 = SIZE.1 - 92;

pub(super) const INK: RGBColor = RGBColor(40, 40, 40);
pub(super) const FAINT: RGBColor = RGBColor(225, 225, 225);
const PREPARED: RGBColor = RGBColor(20, 90, 170);
const REPLAYED: RGBColor = RGBColor(200, 70, 20);

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The text of the SVG file.
///
/// # Errors
/// The font cannot be read, or nothing was measured.
pub fn svg(bands: &[Bands]) -> anyhow::Result<String> {
    with_font()?;
    let scale = Scale::of(bands).context("a plot of nothing")?;
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, (SIZE.0 as u32, SIZE.1 as u32)).into_drawing_area();
        area.fill(&WHITE)?;
        captions(&area)?;
        columns(&area, bands, &scale)?;
        lines(&area, &scale)?;
        let points = |cycles: fn(&Bands) -> (u64, u64)| {
            let points = bands.iter().map(|bands| (bands.rows, cycles(bands)));
            Vec::from_iter(points)
        };
        let prepared = points(|bands| (bands.prepared.1, bands.replayed.1));
        let replayed = points(|bands| (bands.replayed.1, bands.prepared.1));
        curve(&area, &replayed, &scale, REPLAYED)?;
        curve(&area, &prepared, &scale, PREPARED)?;
        area.present()?;
    }
    Ok(text)
}

/// Makes the font of all plots known, which lies in the program.
///
/// # Errors
/// It cannot be read.
pub(super) fn with_font() -> anyhow::Result<()> {
    register_font(FONT, FontStyle::Normal, UBUNTU_LIGHT).map_err(|_| anyhow!("the font cannot be read"))
}

/// Where a number lies in the plot.
struct Scale {
    rows: [f64; 2],
    cycles: [f64; 2],
}

impl Scale {
    /// From the lowest to the tallest band, and around all cycles.
    fn of(bands: &[Bands]) -> Option<Self> {
        let cycles = || bands.iter().flat_map(|bands| [bands.prepared.1, bands.replayed.1]);
        let rows = || bands.iter().map(|bands| bands.rows);
        Some(Self {
            rows: [rows().min()?, rows().max()?].map(f64::from),
            cycles: [cycles().min()? as f64 / 1.4, cycles().max()? as f64 * 1.25],
        })
    }

    fn x(&self, rows: u32) -> i32 {
        LEFT + (part(f64::from(rows), self.rows) * f64::from(RIGHT - LEFT)).round() as i32
    }

    fn y(&self, cycles: u64) -> i32 {
        BOTTOM - (part(cycles as f64, self.cycles) * f64::from(BOTTOM - TOP)).round() as i32
    }

    /// The cycles at which there is a line: 1, 2 and 5 of each power of ten.
    fn ticks(&self) -> impl Iterator<Item = u64> {
        let [least, most] = self.cycles;
        let all = (0..18).flat_map(|power| [1, 2, 5].map(|digit| digit * 10u64.pow(power)));
        all.filter(move |&tick| least <= tick as f64 && tick as f64 <= most)
    }
}

/// How far a number is on the way from one end of a logarithmic axis to the other.
pub(super) fn part(number: f64, [start, end]: [f64; 2]) -> f64 {
    (number / start).ln() / (end / start).ln()
}

/// What is drawn, and what the axes are.
fn captions(area: &Area<'_>) -> anyhow::Result<()> {
    let title = "A frame of 30 shapes and 3 texts on 240 x 320 pixels, Cortex-M4";
    let middle = (LEFT + RIGHT) / 2;
    label(area, title, (middle, 20), 17, INK, (HPos::Center, VPos::Center))?;
    let bytes = "height of a band in rows, and its bytes in RGB565 (logarithmic)";
    label(
        area,
        bytes,
        (middle, SIZE.1 - 18),
        15,
        INK,
        (HPos::Center, VPos::Center),
    )?;
    let turned = style(15, INK, (HPos::Center, VPos::Center)).transform(FontTransform::Rotate270);
    let cycles = "estimated cycles (logarithmic)";
    area.draw(&Text::new(cycles, (14, (TOP + BOTTOM) / 2), turned))?;
    for (name, color, x) in [("replayed", REPLAYED, RIGHT - 220), ("prepared", PREPARED, RIGHT - 100)] {
        // Above all lines of the plot.
        let y = TOP - 10;
        area.draw(&PathElement::new([(x, y), (x + 24, y)], color.stroke_width(3)))?;
        label(area, name, (x + 32, y), 15, color, (HPos::Left, VPos::Center))?;
    }
    Ok(())
}

/// A line for each height, with its rows and its bytes below.
fn columns(area: &Area<'_>, bands: &[Bands], scale: &Scale) -> anyhow::Result<()> {
    for Bands { rows, bytes, .. } in bands {
        let x = scale.x(*rows);
        area.draw(&PathElement::new([(x, TOP), (x, BOTTOM)], FAINT))?;
        let below = (HPos::Center, VPos::Top);
        label(area, &rows.to_string(), (x, BOTTOM + 8), 15, INK, below)?;
        label(
            area,
            &format!("{} B", grouped((*bytes).into())),
            (x, BOTTOM + 28),
            13,
            INK,
            below,
        )?;
    }
    Ok(())
}

/// A line for each round number of cycles, and the two axes.
fn lines(area: &Area<'_>, scale: &Scale) -> anyhow::Result<()> {
    for tick in scale.ticks() {
        let y = scale.y(tick);
        area.draw(&PathElement::new([(LEFT, y), (RIGHT, y)], FAINT))?;
        label(
            area,
            &grouped(tick as f64),
            (LEFT - 8, y),
            13,
            INK,
            (HPos::Right, VPos::Center),
        )?;
    }
    area.draw(&PathElement::new([(LEFT, TOP), (LEFT, BOTTOM), (RIGHT, BOTTOM)], INK))?;
    Ok(())
}

/// A curve through points of rows, cycles, and the other curve's cycles: each is named on the side where that one is not.
fn curve(area: &Area<'_>, points: &[(u32, (u64, u64))], scale: &Scale, color: RGBColor) -> anyhow::Result<()> {
    let place = |rows, cycles| (scale.x(rows), scale.y(cycles));
    let path: Vec<_> = points.iter().map(|&(rows, (cycles, _))| place(rows, cycles)).collect();
    area.draw(&PathElement::new(path, color.stroke_width(2)))?;
    for &(rows, (cycles, other)) in points {
        let (x, y) = place(rows, cycles);
        area.draw(&Circle::new((x, y), 4, color.filled()))?;
        let (y, vertical) = if cycles > other {
            (y - 6, VPos::Bottom)
        } else {
            (y + 8, VPos::Top)
        };
        // Right of the axis, and of a curve that falls.
        let is_beside = x < RIGHT && (x == LEFT || cycles > other);
        let (x, horizontal) = if is_beside {
            (x + 8, HPos::Left)
        } else {
            (x, HPos::Center)
        };
        label(area, &grouped(cycles as f64), (x, y), 13, color, (horizontal, vertical))?;
    }
    Ok(())
}

fn style(size: i32, color: RGBColor, (horizontal, vertical): (HPos, VPos)) -> TextStyle<'static> {
    TextStyle {
        font: (FONT, size).into_font(),
        color: color.to_backend_color(),
        pos: Pos::new(horizontal, vertical),
    }
}

pub(super) fn label(
    area: &Area<'_>,
    text: &str,
    at: (i32, i32),
    size: i32,
    color: RGBColor,
    side: (HPos, VPos),
) -> anyhow::Result<()> {
    area.draw(&Text::new(text.to_owned(), at, style(size, color, side)))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_axes_are_the_ends_of_the_plot() {
        let bands = [(1, 1_000), (320, 200)].map(|(rows, cycles)| Bands {
            rows,
            bytes: rows * 480,
            prepared: (1, cycles),
            replayed: (1, 2 * cycles),
        });
        let scale = Scale::of(&bands).unwrap();
        assert_eq!([1, 320].map(|rows| scale.x(rows)), [LEFT, RIGHT]);
        let inside = TOP..=BOTTOM;
        assert!([200, 2_000].iter().all(|&cycles| inside.contains(&scale.y(cycles))));
        assert!(scale.y(2_000) < scale.y(200));
        assert_eq!(scale.ticks().collect::<Vec<_>>(), [200, 500, 1_000, 2_000]);
        assert!(svg(&[]).is_err());
    }
}
