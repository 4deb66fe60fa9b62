//! Error against cost, each on a logarithmic axis, as SVG and PNG.

use anyhow::{anyhow, ensure};
use epaint_default_fonts::UBUNTU_LIGHT;
use image::RgbImage;
use plotters::{
    coord::{Shift, combinators::LogCoord},
    prelude::*,
    style::{
        FontStyle, TextStyle, register_font,
        text_anchor::{HPos, Pos, VPos},
    },
};

use super::{pareto, picture};

const SIZE: (u32, u32) = (760, 460);
const FONT: &str = "sans-serif";
const FRONT: RGBColor = RGBColor(20, 90, 170);
/// About the width and height of a character of a label.
const CHARACTER: (i32, i32) = (6, 13);

/// A chart of one group.
pub struct Chart {
    pub title: String,
    pub cost: String,
    pub error: String,
    pub marks: Vec<Mark>,
}

/// One method.
pub struct Mark {
    pub name: String,
    pub error: f64,
    pub cost: f64,
    /// Where the cost spreads.
    pub spread: Option<(f64, f64)>,
    pub memory_bytes: usize,
}

/// Makes the font known that is in this program, so that no machine needs one.
///
/// # Errors
/// It is not a font.
pub fn load_font() -> anyhow::Result<()> {
    register_font(FONT, FontStyle::Normal, UBUNTU_LIGHT).map_err(|_| anyhow!("the font of the plots cannot be read"))
}

impl Chart {
    /// As the text of an SVG file.
    pub fn svg(&self) -> anyhow::Result<String> {
        let mut text = String::new();
        self.draw(SVGBackend::with_string(&mut text, SIZE).into_drawing_area())?;
        Ok(text)
    }

    /// As a PNG file.
    pub fn png(&self) -> anyhow::Result<Vec<u8>> {
        let (width, height) = SIZE;
        let mut pixels = vec![255; width as usize * height as usize * 3];
        self.draw(BitMapBackend::with_buffer(&mut pixels, SIZE).into_drawing_area())?;
        let image = RgbImage::from_raw(width, height, pixels).ok_or_else(|| anyhow!("a plot of another size"))?;
        picture::png(&image)
    }

    fn draw<B: DrawingBackend>(&self, area: DrawingArea<B, Shift>) -> anyhow::Result<()> {
        ensure!(!self.marks.is_empty(), "a chart without marks");
        // The error type of a back end borrows from it.
        self.draw_on(&area)
            .map_err(|error| anyhow!("cannot draw {}: {error}", self.title))?;
        area.present()
            .map_err(|error| anyhow!("cannot draw {}: {error}", self.title))
    }

    fn draw_on<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        area.fill(&WHITE)?;
        let floor = self.floor();
        let costs = range(self.marks.iter().map(|mark| mark.cost), 1.6, 2.6);
        let errors = range(self.marks.iter().map(|mark| mark.error.max(floor)), 1.6, 1.8);
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, (FONT, 18))
            .margin(8)
            .margin_right(24)
            .x_label_area_size(42)
            .y_label_area_size(62)
            .build_cartesian_2d(costs.log_scale(), errors.log_scale())?;
        chart
            .configure_mesh()
            .x_labels(24)
            .y_labels(24)
            .light_line_style(WHITE)
            .bold_line_style(RGBColor(228, 228, 228))
            .x_desc(&self.cost)
            .y_desc(&self.error)
            .label_style((FONT, 13))
            .x_label_formatter(&|number| short(*number))
            .y_label_formatter(&|number| short(*number))
            .draw()?;
        let dominated = self.dominated();
        self.draw_front(&mut chart, &dominated, floor)?;
        // Labels of those that matter are placed first.
        let mut order: Vec<usize> = (0..self.marks.len()).collect();
        order.sort_by_key(|&index| dominated[index]);
        let mut taken: Vec<Place> = Vec::new();
        for mark in &self.marks {
            let (x, y) = chart.backend_coord(&(mark.cost, mark.error.max(floor)));
            taken.push(Place::around(x, y, radius(mark.memory_bytes)));
        }
        for index in order {
            let mark = &self.marks[index];
            let (color, strength) = if dominated[index] { (BLACK, 0.28) } else { (FRONT, 0.9) };
            let at = (mark.cost, mark.error.max(floor));
            if let Some((low, high)) = mark.spread {
                chart.draw_series([PathElement::new(
                    vec![(low, at.1), (high, at.1)],
                    color.mix(strength * 0.6),
                )])?;
            }
            let radius = radius(mark.memory_bytes);
            chart.draw_series([Circle::new(at, radius, color.mix(strength * 0.75).filled())])?;
            let (x, y) = chart.backend_coord(&at);
            let place = Place::free_near((x, y), radius, &mark.name, area.dim_in_pixel(), &taken);
            taken.push(place);
            let ink = BLACK.mix(if dominated[index] { 0.45 } else { 1.0 });
            let style = TextStyle::from((FONT, 12).into_font())
                .color(&ink)
                .pos(Pos::new(HPos::Left, VPos::Top));
            area.draw_text(&mark.name, &style, (place.left, place.top))?;
        }
        Ok(())
    }

    /// Steps along the methods that none dominates.
    fn draw_front<B: DrawingBackend>(
        &self,
        chart: &mut ChartContext<'_, B, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>,
        dominated: &[bool],
        floor: f64,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let marks = self.marks.iter().zip(dominated).filter(|(_, dominated)| !**dominated);
        let mut front: Vec<(f64, f64)> = marks.map(|(mark, _)| (mark.cost, mark.error.max(floor))).collect();
        front.sort_by(|a, b| a.0.total_cmp(&b.0));
        let steps = front.windows(2).flat_map(|pair| [pair[0], (pair[1].0, pair[0].1)]);
        let steps: Vec<_> = steps.chain(front.last().copied()).collect();
        chart.draw_series([PathElement::new(steps, FRONT.mix(0.35))])?;
        Ok(())
    }

    /// What errors of 0 are drawn as.
    fn floor(&self) -> f64 {
        let positive = self.marks.iter().map(|mark| mark.error).filter(|error| *error > 0.0);
        let smallest = positive.fold(f64::INFINITY, f64::min);
        if smallest.is_finite() { smallest / 4.0 } else { 0.1 }
    }

    fn dominated(&self) -> Vec<bool> {
        let figures: Vec<_> = self.marks.iter().map(|mark| (mark.error, mark.cost)).collect();
        pareto::dominated(&figures)
    }
}

fn range(numbers: impl Iterator<Item = f64>, below: f64, above: f64) -> std::ops::Range<f64> {
    let (low, high) = numbers.fold((f64::INFINITY, 0.0f64), |(low, high), number| {
        (low.min(number), high.max(number))
    });
    low / below..high * above
}

/// The area of a mark grows with its memory.
fn radius(memory_bytes: usize) -> i32 {
    4 + (memory_bytes as f64 / 8.0).sqrt().min(14.0) as i32
}

/// A number at an axis; only 1, 2 and 5 of each power of ten, because the others have no room.
fn short(number: f64) -> String {
    let leading = number / 10f64.powf((number.log10() + 1e-9).floor());
    if ![1.0, 2.0, 5.0].iter().any(|shown| (leading - shown).abs() < 1e-6) {
        return String::new();
    }
    if number >= 1e6 {
        format!("{} M", number / 1e6)
    } else if number >= 1e3 {
        format!("{} k", number / 1e3)
    } else {
        format!("{}", (number * 1e6).round() / 1e6)
    }
}

/// A rectangle of the picture that a label or a mark takes.
#[derive(Clone, Copy)]
struct Place {
    left: i32,
    top: i32,
    width: i32,
    height: i32,
}

impl Place {
    fn around(x: i32, y: i32, radius: i32) -> Self {
        Self {
            left: x - radius,
            top: y - radius,
            width: 2 * radius,
            height: 2 * radius,
        }
    }

    /// Beside, above or below a mark, where there is nothing yet; or where there is least.
    fn free_near((x, y): (i32, i32), radius: i32, label: &str, (right, bottom): (u32, u32), taken: &[Self]) -> Self {
        let (width, height) = (label.chars().count() as i32 * CHARACTER.0 + 4, CHARACTER.1);
        let columns = [x + radius + 2, x - radius - 2 - width, x - width / 2];
        let rows = (0..8).flat_map(|step| [y - height / 2 - step * 7, y - height / 2 + step * 7]);
        let candidates = rows.flat_map(|top| {
            columns.map(|left| Self {
                left,
                top,
                width,
                height,
            })
        });
        let inside = |place: &Self| {
            place.left >= 66
                && place.left + width <= right as i32
                && place.top >= 30
                && place.top + height <= bottom as i32 - 50
        };
        let hidden = |place: &Self| taken.iter().map(|other| place.common(other)).sum::<i32>();
        candidates.filter(inside).min_by_key(hidden).unwrap_or(Self {
            left: x + radius + 2,
            top: y - height / 2,
            width,
            height,
        })
    }

    /// Pixels in both.
    fn common(&self, other: &Self) -> i32 {
        let along = |start: i32, length: i32, other: i32, other_length: i32| {
            ((start + length).min(other + other_length) - start.max(other)).max(0)
        };
        along(self.left, self.width, other.left, other.width) * along(self.top, self.height, other.top, other.height)
    }
}
