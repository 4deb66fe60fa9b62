//! Error against cost, each on a logarithmic axis, as SVG and PNG.

use anyhow::{Context, anyhow, ensure};
use epaint_default_fonts::UBUNTU_LIGHT;
use plotters::{
    coord::Shift,
    prelude::*,
    style::{
        FontStyle, TextStyle, register_font,
        text_anchor::{HPos, Pos, VPos},
    },
};

use resvg::{tiny_skia, usvg};

use super::pareto;

const SIZE: (u32, u32) = (720, 460);
const FONT: &str = "sans-serif";
const FRONT: RGBColor = RGBColor(20, 90, 170);
const GRID: RGBColor = RGBColor(226, 226, 226);
/// About the width and height of a character of a label.
const CHARACTER: (i32, i32) = (7, 15);
/// By how much the radius of a mark grows with its memory, at most.
const MOST_GROWTH: f64 = 12.0;
/// Pixels around the plot: left, top, right, bottom.
const MARGINS: (i32, i32, i32, i32) = (66, 38, 20, 54);

/// A chart of one group.
pub struct Chart {
    pub title: String,
    pub cost: String,
    pub error: String,
    /// What the area of a mark shows, if anything.
    pub memory: Option<&'static str>,
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
        let mut options = usvg::Options::default();
        let fonts = options.fontdb_mut();
        fonts.load_font_data(UBUNTU_LIGHT.to_vec());
        let face = fonts.faces().next().context("the font of the plots has no face")?;
        let (family, _) = face
            .families
            .first()
            .context("the font of the plots has no name")?
            .clone();
        fonts.set_sans_serif_family(family);
        let tree = usvg::Tree::from_str(&self.svg()?, &options)?;
        let (width, height) = SIZE;
        let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or_else(|| anyhow!("a plot without pixels"))?;
        resvg::render(&tree, tiny_skia::Transform::identity(), &mut pixels.as_mut());
        Ok(pixels.encode_png()?)
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
        let (left, top, right, bottom) = MARGINS;
        let mut chart = ChartBuilder::on(area)
            .margin_top(top)
            .margin_right(right)
            .x_label_area_size(bottom)
            .y_label_area_size(left)
            .build_cartesian_2d(costs.clone().log_scale(), errors.clone().log_scale())?;
        let middle = ((SIZE.0 as i32 + left - right) / 2, (SIZE.1 as i32 + top - bottom) / 2);
        // To the right of it is what the sizes of marks mean, where they mean something.
        let (horizontal, title_x) = match self.memory {
            Some(_) => (HPos::Left, left),
            None => (HPos::Center, middle.0),
        };
        let title = text(17, 1.0, horizontal, VPos::Center);
        area.draw_text(&self.title, &title, (title_x, top / 2))?;
        let caption = text(15, 1.0, HPos::Center, VPos::Bottom);
        area.draw_text(&self.cost, &caption, (middle.0, SIZE.1 as i32 - 6))?;
        let turned = text(15, 1.0, HPos::Center, VPos::Top).transform(FontTransform::Rotate270);
        area.draw_text(&self.error, &turned, (6, middle.1))?;
        for (tick, is_named) in ticks(&costs) {
            let line = PathElement::new(vec![(tick, errors.start), (tick, errors.end)], GRID);
            chart.draw_series([line])?;
            if is_named {
                let (x, y) = chart.backend_coord(&(tick, errors.start));
                let style = text(13, 1.0, HPos::Center, VPos::Top);
                area.draw_text(&short(tick), &style, (x, y + 5))?;
            }
        }
        // Where errors of 0 are drawn, the axis says so.
        let zero = self.marks.iter().any(|mark| mark.error <= 0.0).then_some((floor, true));
        let from = if zero.is_some() { floor * 2.0 } else { errors.start };
        for (tick, is_named) in ticks(&(from..errors.end)).into_iter().chain(zero) {
            let line = PathElement::new(vec![(costs.start, tick), (costs.end, tick)], GRID);
            chart.draw_series([line])?;
            if is_named {
                let (x, y) = chart.backend_coord(&(costs.start, tick));
                let style = text(13, 1.0, HPos::Right, VPos::Center);
                let name = if tick > floor { short(tick) } else { "0".to_owned() };
                area.draw_text(&name, &style, (x - 6, y))?;
            }
        }
        let frame = [
            (costs.start, errors.end),
            (costs.start, errors.start),
            (costs.end, errors.start),
        ];
        chart.draw_series([PathElement::new(frame.to_vec(), BLACK)])?;
        let dominated = self.dominated();
        let steps = self.steps(&dominated, floor);
        chart.draw_series([PathElement::new(steps.clone(), FRONT.mix(0.45))])?;
        let at = |mark: &Mark| chart.backend_coord(&(mark.cost, mark.error.max(floor)));
        let spread = |mark: &Mark| {
            let end = |cost| chart.backend_coord(&(cost, mark.error.max(floor))).0;
            mark.spread.map(|(low, high)| [end(low), end(high)])
        };
        let steps: Vec<_> = steps.iter().map(|step| chart.backend_coord(step)).collect();
        let mut taken: Vec<LabelBox> = steps
            .windows(2)
            .map(|step| LabelBox::between(step[0], step[1]))
            .collect();
        for mark in &self.marks {
            let (x, y) = at(mark);
            taken.push(LabelBox::around((x, y), self.radius(mark.memory_bytes)));
            taken.extend(spread(mark).map(|[low, high]| LabelBox::between((low, y - 3), (high, y + 3))));
        }
        self.draw_sizes(area)?;
        // Those that matter last, over the others; their labels first, in the best places.
        let mut order: Vec<usize> = (0..self.marks.len()).collect();
        order.sort_by_key(|&index| !dominated[index]);
        for &index in &order {
            let mark = &self.marks[index];
            let (color, strength) = if dominated[index] { (BLACK, 0.22) } else { (FRONT, 0.7) };
            let (x, y) = at(mark);
            area.draw(&Circle::new(
                (x, y),
                self.radius(mark.memory_bytes),
                color.mix(strength).filled(),
            ))?;
            if let Some(ends) = spread(mark) {
                draw_spread(area, ends, y, &color.mix((strength + 0.3).min(1.0)))?;
            }
        }
        for &index in order.iter().rev() {
            let mark = &self.marks[index];
            let (center, radius) = (at(mark), self.radius(mark.memory_bytes));
            let label_box = LabelBox::free_near(center, radius, &mark.name, &taken);
            taken.push(label_box);
            let strength = if dominated[index] { 0.6 } else { 1.0 };
            if let Some(line) = label_box.leader(center, radius) {
                area.draw(&PathElement::new(line.to_vec(), BLACK.mix(strength * 0.8)))?;
            }
            // Names are narrower than their places: towards the mark.
            let (horizontal, x) = if label_box.left + label_box.width <= center.0 {
                (HPos::Right, label_box.left + label_box.width - 2)
            } else {
                (HPos::Left, label_box.left + 2)
            };
            let style = text(13, strength, horizontal, VPos::Top);
            area.draw_text(&mark.name, &style, (x, label_box.top))?;
        }
        Ok(())
    }

    /// What the sizes of marks mean, beside the title.
    fn draw_sizes<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let Some(memory) = self.memory else { return Ok(()) };
        let mut sizes: Vec<usize> = self.marks.iter().map(|mark| mark.memory_bytes).collect();
        sizes.sort_unstable();
        sizes.dedup();
        // The least, the one in the middle, the most.
        let mut shown = vec![0, sizes.len() / 2, sizes.len() - 1];
        shown.dedup();
        let right = SIZE.0 as i32 - MARGINS.2 - 4;
        let (mut x, y) = (right, MARGINS.1 / 2);
        let style = text(12, 0.8, HPos::Right, VPos::Center);
        for index in shown.into_iter().rev() {
            let label = sizes[index].to_string();
            area.draw_text(&label, &style, (x, y))?;
            x -= label.len() as i32 * CHARACTER.0 + 2 + self.radius(sizes[index]);
            area.draw(&Circle::new(
                (x, y),
                self.radius(sizes[index]),
                BLACK.mix(0.22).filled(),
            ))?;
            x -= self.radius(sizes[index]) + 10;
        }
        area.draw_text(memory, &style, (x, y))
    }

    /// Along the methods that none dominates.
    fn steps(&self, dominated: &[bool], floor: f64) -> Vec<(f64, f64)> {
        let marks = self.marks.iter().zip(dominated).filter(|(_, dominated)| !**dominated);
        let mut front: Vec<(f64, f64)> = marks.map(|(mark, _)| (mark.cost, mark.error.max(floor))).collect();
        front.sort_by(|a, b| a.0.total_cmp(&b.0));
        let steps = front.windows(2).flat_map(|pair| [pair[0], (pair[1].0, pair[0].1)]);
        steps.chain(front.last().copied()).collect()
    }

    /// The area of a mark grows with its memory, up to the greatest of the chart.
    fn radius(&self, memory_bytes: usize) -> i32 {
        let greatest = self
            .marks
            .iter()
            .map(|mark| mark.memory_bytes)
            .max()
            .unwrap_or_default();
        let scale = (greatest as f64 / MOST_GROWTH.powi(2)).max(8.0);
        4 + (memory_bytes as f64 / scale).sqrt() as i32
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

/// A bar with ends.
fn draw_spread<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    [low, high]: [i32; 2],
    y: i32,
    color: &RGBAColor,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    for line in [
        [(low, y), (high, y)],
        [(low, y - 4), (low, y + 4)],
        [(high, y - 4), (high, y + 4)],
    ] {
        area.draw(&PathElement::new(line.to_vec(), *color))?;
    }
    Ok(())
}

fn text(size: i32, strength: f64, horizontal: HPos, vertical: VPos) -> TextStyle<'static> {
    TextStyle {
        font: (FONT, size).into_font(),
        color: BLACK.mix(strength).to_backend_color(),
        pos: Pos::new(horizontal, vertical),
    }
}

/// Every 1 to 9 of every power of ten in the range, and whether it is named: 1, 2 and 5, or 1 alone where many are.
fn ticks(range: &std::ops::Range<f64>) -> Vec<(f64, bool)> {
    let (low, high) = (range.start.log10().floor() as i32, range.end.log10().ceil() as i32);
    let named: &[u32] = if high - low > 6 { &[1] } else { &[1, 2, 5] };
    let all = (low..=high).flat_map(|power| (1..=9).map(move |digit| (digit, f64::from(digit) * 10f64.powi(power))));
    all.filter(|(_, tick)| range.contains(tick))
        .map(|(digit, tick)| (tick, named.contains(&digit)))
        .collect()
}

/// A number at an axis.
fn short(number: f64) -> String {
    if number > 9e5 {
        format!("{} M", (number / 1e4).round() / 1e2)
    } else if number > 9e2 {
        format!("{} k", (number / 1e1).round() / 1e2)
    } else {
        format!("{}", (number * 1e6).round() / 1e6)
    }
}

/// A rectangle of the picture that a label or a mark takes.
#[derive(Clone, Copy)]
struct LabelBox {
    left: i32,
    top: i32,
    width: i32,
    height: i32,
}

impl LabelBox {
    fn around((x, y): (i32, i32), radius: i32) -> Self {
        Self {
            left: x - radius,
            top: y - radius,
            width: 2 * radius,
            height: 2 * radius,
        }
    }

    /// Around a line, along an axis.
    fn between(one: (i32, i32), other: (i32, i32)) -> Self {
        Self {
            left: one.0.min(other.0) - 1,
            top: one.1.min(other.1) - 1,
            width: one.0.abs_diff(other.0) as i32 + 2,
            height: one.1.abs_diff(other.1) as i32 + 2,
        }
    }

    /// Beside, above or below a mark, where there is nothing yet; or where there is least.
    fn free_near((x, y): (i32, i32), radius: i32, label: &str, taken: &[Self]) -> Self {
        let (width, height) = (label.chars().count() as i32 * CHARACTER.0 + 4, CHARACTER.1);
        let at = |left: i32, top: i32| Self {
            left,
            top,
            width,
            height,
        };
        let columns = [
            x + radius + 3,
            x - radius - 3 - width,
            x - width / 2,
            x + 24,
            x - 24 - width,
        ];
        let rows = (0..14).flat_map(|step| [y - height / 2 - step * 6, y - height / 2 + step * 6]);
        let candidates = rows.flat_map(|top| columns.map(|left| at(left, top)));
        let (left, top, right, bottom) = MARGINS;
        let inside = |label_box: &Self| {
            label_box.left >= left + 2
                && label_box.left + width <= SIZE.0 as i32 - right
                && label_box.top >= top
                && label_box.top + height <= SIZE.1 as i32 - bottom
        };
        let hidden = |label_box: &Self| taken.iter().map(|other| label_box.common(other)).sum::<i32>();
        let best = candidates.filter(inside).min_by_key(hidden);
        best.unwrap_or_else(|| at(x + radius + 3, y - height / 2))
    }

    /// A line from the mark to the label, where that is not beside it.
    fn leader(&self, (x, y): (i32, i32), radius: i32) -> Option<[(i32, i32); 2]> {
        let end = (
            x.clamp(self.left, self.left + self.width),
            y.clamp(self.top + 2, self.top + self.height - 2),
        );
        let (dx, dy) = (f64::from(end.0 - x), f64::from(end.1 - y));
        let distance = dx.hypot(dy);
        let part = f64::from(radius) / distance;
        let start = (x + (dx * part) as i32, y + (dy * part) as i32);
        (distance > f64::from(radius + 6)).then_some([start, end])
    }

    /// Pixels in both.
    fn common(&self, other: &Self) -> i32 {
        let along = |start: i32, length: i32, other: i32, other_length: i32| {
            ((start + length).min(other + other_length) - start.max(other)).max(0)
        };
        along(self.left, self.width, other.left, other.width) * along(self.top, self.height, other.top, other.height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_decade_has_names() {
        let named: Vec<String> = ticks(&(1300.0..32_000.0))
            .into_iter()
            .filter(|(_, is_named)| *is_named)
            .map(|(tick, _)| short(tick))
            .collect();
        assert_eq!(named, ["2 k", "5 k", "10 k", "20 k"]);
        assert_eq!(short(0.05), "0.05");
        assert_eq!(short(2e6), "2 M");
    }

    #[test]
    fn labels_keep_clear_of_each_other() {
        let mut taken = vec![LabelBox::around((300, 200), 8)];
        for _ in 0..6 {
            let label_box = LabelBox::free_near((300, 200), 8, "grid_16_gaussian", &taken);
            assert!(taken.iter().all(|other| label_box.common(other) == 0));
            taken.push(label_box);
        }
        assert!(taken[1].leader((300, 200), 8).is_none());
        assert!(taken[6].leader((300, 200), 8).is_some());
    }
}
