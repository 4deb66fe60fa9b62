//! embedded-graphics' `TextRenderer` for antialiased text: on any `DrawTarget`.
//!
//! A target that cannot be read back does not tell what is below, so the style says against which background the glyphs are
//! blended. A part of a line at a time is drawn on a band of one row of coverage, and the colours of its pixels are
//! handed on.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::{Gray8, GrayColor},
    primitives::{PointsIter, Rectangle},
    text::{
        Baseline,
        renderer::{TextMetrics, TextRenderer},
    },
};

use crate::{
    band::Band,
    draw::text::{
        MaskTextStyle, OutlineTextStyle,
        line::{Line, LineFont, LineStyle, above_baseline, rows_with_decorations},
        mask_text, outline_text,
    },
    geometry::Window,
    shade::ChannelColor,
};

/// Words of the band through which a part of a row is drawn.
const COLUMNS: usize = outline_text::COLUMNS;

/// Coverage in grey: white text on black.
type CoverageBand<'a> = Band<'a, Gray8>;

/// A style whose glyphs can be drawn on a band of one row.
trait CoverageStyle: LineStyle<Color: ChannelColor> {
    /// Draws the glyphs of a line in white, those that the band shows, without background and decorations.
    fn draw_coverage(&self, line: &Line<'_>, band: &mut CoverageBand<'_>);
}

impl<C: ChannelColor> CoverageStyle for MaskTextStyle<C> {
    fn draw_coverage(&self, line: &Line<'_>, band: &mut CoverageBand<'_>) {
        let window = Window::from(band.bounding_box());
        let style = MaskTextStyle::new(self.font, Gray8::WHITE);
        let Ok(()) = mask_text::draw_line(band, &window, &style, line);
    }
}

impl<C: ChannelColor> CoverageStyle for OutlineTextStyle<C> {
    fn draw_coverage(&self, line: &Line<'_>, band: &mut CoverageBand<'_>) {
        outline_text::draw_row(self.font(), line, band);
    }
}

macro_rules! text_renderer {
    ($($style:ident),+) => {$(
        impl<C: ChannelColor> TextRenderer for $style<C> {
            type Color = C;

            fn draw_string<D: DrawTarget<Color = C>>(
                &self,
                text: &str,
                position: Point,
                baseline: Baseline,
                target: &mut D,
            ) -> Result<Point, D::Error> {
                draw_string(self, text, position, baseline, target)
            }

            fn draw_whitespace<D: DrawTarget<Color = C>>(
                &self,
                width: u32,
                position: Point,
                baseline: Baseline,
                target: &mut D,
            ) -> Result<Point, D::Error> {
                draw_whitespace(self, width, position, baseline, target)
            }

            fn measure_string(&self, text: &str, position: Point, baseline: Baseline) -> TextMetrics {
                measure_string(self, text, position, baseline)
            }

            fn line_height(&self) -> u32 {
                LineStyle::font(self).line_height()
            }
        }
    )+};
}
text_renderer!(MaskTextStyle, OutlineTextStyle);

fn draw_string<S: CoverageStyle, D: DrawTarget<Color = S::Color>>(
    style: &S,
    text: &str,
    position: Point,
    baseline: Baseline,
    target: &mut D,
) -> Result<Point, D::Error> {
    let line = line(style, text, position, baseline);
    let columns = line.columns(style.font());
    let rows = (line.top, line.top + style.font().rows());
    let behind = (line.left, columns.next);
    let visible = window_of((columns.start, columns.end), rows).intersection(&target.bounding_box().into());
    for y in visible.top..visible.bottom {
        let mut left = visible.left;
        while left < visible.right {
            let right = visible.right.min(left.saturating_add(COLUMNS as i32));
            draw_part(style, target, &line, behind, (y, left, right))?;
            left = right;
        }
    }
    decorate(style, target, behind, line.top)?;
    Ok(Point::new(saturated(columns.next), position.y))
}

fn draw_whitespace<S: CoverageStyle, D: DrawTarget<Color = S::Color>>(
    style: &S,
    width: u32,
    position: Point,
    baseline: Baseline,
    target: &mut D,
) -> Result<Point, D::Error> {
    let line = line(style, "", position, baseline);
    let columns = (line.left, line.left + i64::from(width));
    if let (Some(color), true) = (style.background_color(), width > 0) {
        let rows = (line.top, line.top + style.font().rows());
        target.fill_solid(&window_of(columns, rows).to_rectangle(), color)?;
    }
    decorate(style, target, columns, line.top)?;
    Ok(Point::new(saturated(columns.1), position.y))
}

fn measure_string(style: &impl LineStyle, text: &str, position: Point, baseline: Baseline) -> TextMetrics {
    let line = line(style, text, position, baseline);
    let columns = line.columns(style.font());
    let rows = (line.top, line.top + rows_with_decorations(style));
    TextMetrics {
        bounding_box: window_of((columns.start, columns.end), rows).to_rectangle(),
        next_position: Point::new(saturated(columns.next), position.y),
    }
}

/// The line that embedded-graphics means by a position and a baseline.
fn line<'t>(style: &impl LineStyle, text: &'t str, position: Point, baseline: Baseline) -> Line<'t> {
    Line {
        text,
        left: position.x.into(),
        top: i64::from(position.y) - above_baseline(style.font(), baseline),
    }
}

/// Fills the decorations of some columns of a line.
fn decorate<S: LineStyle, D: DrawTarget<Color = S::Color>>(
    style: &S,
    target: &mut D,
    columns: (i64, i64),
    top: i64,
) -> Result<(), D::Error> {
    for (dimensions, color) in style.decorations().into_iter().flatten() {
        let first = top + i64::from(dimensions.offset);
        let rows = (first, first + i64::from(dimensions.height));
        target.fill_solid(&window_of(columns, rows).to_rectangle(), color)?;
    }
    Ok(())
}

/// Draws the visible columns `left..right` of a line's row `y`, at most [`COLUMNS`] of them. Columns in `behind` are
/// those with a background.
fn draw_part<S: CoverageStyle, D: DrawTarget<Color = S::Color>>(
    style: &S,
    target: &mut D,
    line: &Line<'_>,
    behind: (i64, i64),
    (y, left, right): (i32, i32, i32),
) -> Result<(), D::Error> {
    let area = Rectangle::new(Point::new(left, y), Size::new(left.abs_diff(right), 1));
    let mut words = [0; COLUMNS];
    // Not smaller than the area, which has no more columns.
    let Ok(mut band) = CoverageBand::new(area, &mut words) else {
        return Ok(());
    };
    if style.text_color().is_some() {
        style.draw_coverage(line, &mut band);
    }
    let pixels = || area.points().zip(band.colors());
    let is_behind = |column: i32| (behind.0..behind.1).contains(&i64::from(column));
    let Some(background) = style.background_color() else {
        let color = style.text_color();
        let covered = pixels().filter(|(_, coverage)| coverage.luma() >= 128);
        return target.draw_iter(covered.filter_map(|(point, _)| Some(Pixel(point, color?))));
    };
    let mixed = |point: Point, coverage: Gray8| match style.text_color() {
        Some(color) => color.over::<10>(background, coverage.luma(), point),
        None => background,
    };
    if is_behind(left) && is_behind(right.saturating_sub(1)) {
        return target.fill_contiguous(&area, pixels().map(|(point, coverage)| mixed(point, coverage)));
    }
    let drawn = pixels().filter(|(point, coverage)| is_behind(point.x) || coverage.luma() > 0);
    target.draw_iter(drawn.map(|(point, coverage)| Pixel(point, mixed(point, coverage))))
}

/// The nearest 32-bit number.
fn saturated(value: i64) -> i32 {
    // Not `clamp`, which contains a panic for an empty range.
    value.max(i32::MIN.into()).min(i32::MAX.into()) as i32
}

/// The pixels in some columns and rows; sides beyond the number range lie at its ends.
fn window_of((left, right): (i64, i64), (top, bottom): (i64, i64)) -> Window {
    Window {
        left: saturated(left),
        top: saturated(top),
        right: saturated(right),
        bottom: saturated(bottom),
    }
}
