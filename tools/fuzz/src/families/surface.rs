//! `zrow::surface`: whatever is handed over, the pixels of it that are inside are drawn, and no others, for work that does not
//! grow with what is outside.

use std::{cell::Cell, iter};

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    Pixel,
    geometry::{Point, Size},
    pixelcolor::{
        Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb666,
        Rgb888,
        raw::{RawData, RawU1, RawU2, RawU4, RawU8, RawU16, RawU24},
    },
    prelude::Primitive,
    primitives::{Line, PointsIter, Rectangle, Triangle},
};
use zrow::{
    band::{Band, BandColor, BigEndian, Generic, LittleEndian, Order, Span, Target},
    coverage::{Rooks, SamplePattern},
    draw::{DrawOn, PrimitiveStyle},
    geometry::Window,
    shade::Pattern,
};

use crate::{
    exact,
    picture::{Canvas, Counted, Sheet, Stopped, background, is_same, sure},
    target::{Case, Verdict},
    values::{Hue, Int, Length, List, Px, Spot, Stage},
};

/// A call of a target, or of a shape whose pixels reach it as steps and as trapezoids.
#[derive(Debug, Clone, Arbitrary)]
enum Call {
    Span { y: Px, start: Px, end: Px },
    Window([Spot; 2]),
    Triangle([Spot; 3]),
    Line([Spot; 2]),
    Solid(Area),
    Contiguous { area: Area, colors: Colors },
    Pixels(List<Spot, 5>),
    Clear,
}

/// A rectangle: most have pixels.
#[derive(Debug, Copy, Clone, Arbitrary)]
struct Area {
    corner: Spot,
    size: [Length; 2],
}

impl Area {
    fn get(self, stage: &Stage) -> Rectangle {
        let [width, height] = self.size;
        Rectangle::new(stage.point(self.corner), width.by(height))
    }
}

/// How many colours come for an area.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Colors {
    /// Without end.
    Endless,
    /// So many.
    Some(u8),
}

/// Calls with any numbers, on every kind of target.
#[derive(Debug, Arbitrary)]
pub struct CallsCase {
    stage: Stage,
    calls: List<(Call, Hue), 4>,
}

/// The colours of an area, one after the other.
fn colors(hue: Hue) -> impl Iterator<Item = Rgb565> + Clone {
    let other = match hue {
        Hue::Even => Hue::Odd,
        Hue::Odd => Hue::White,
        Hue::White => Hue::Even,
    };
    iter::repeat([hue.color(), other.color(), hue.color()]).flatten()
}

/// Endless colours, any of which is found at once, as those of an image are.
#[derive(Debug, Clone)]
struct Endless {
    hue: Hue,
    next: usize,
}

impl Iterator for Endless {
    type Item = Rgb565;

    fn next(&mut self) -> Option<Rgb565> {
        self.nth(0)
    }

    fn nth(&mut self, index: usize) -> Option<Rgb565> {
        let index = self.next.wrapping_add(index);
        self.next = index.wrapping_add(1);
        colors(self.hue).nth(index % 3)
    }
}

impl CallsCase {
    /// Makes all calls. Where a call asks an iterator of colours for more than the visible pixels and rows, that ends.
    fn call<T: Target<Color = Rgb565>>(&self, target: &mut T) -> anyhow::Result<Result<(), T::Error>> {
        let stage = &self.stage;
        for (call, hue) in &self.calls.0 {
            let raw = target.raw(hue.color());
            let done = match call {
                Call::Span { y, start, end } => {
                    let Point { x, y: row } = stage.origin();
                    target.fill_span(Span::new(y.from(row), start.from(x), end.from(x)), raw)
                }
                Call::Window([first, end]) => target.fill_window(window(stage, first, end), raw),
                Call::Triangle(corners) => {
                    let [a, b, c] = corners.map(|corner| stage.point(corner));
                    let style = PrimitiveStyle::with_fill(hue.color());
                    Triangle::new(a, b, c).into_styled(style).draw_on(target)
                }
                Call::Line(ends) => {
                    let [from, to] = ends.map(|end| stage.point(end));
                    let style = PrimitiveStyle::with_stroke(hue.color(), 1);
                    Line::new(from, to).into_styled(style).draw_on(target)
                }
                Call::Solid(area) => target.fill_solid(&area.get(stage), hue.color()),
                Call::Contiguous { area, colors } => {
                    let area = area.get(stage);
                    let visible = Window::from(area).intersection(&target.window());
                    // One question for each visible pixel, one before each row and one behind the last pixel.
                    let most = u64::from(visible.width() + 1) * u64::from(visible.height()) + 2;
                    let asked = Cell::new(0);
                    let endless = Endless { hue: *hue, next: 0 };
                    let done = match colors {
                        Colors::Endless => target.fill_contiguous(&area, Counted::new(endless, &asked, most)),
                        Colors::Some(count) => {
                            target.fill_contiguous(&area, Counted::new(endless.take((*count).into()), &asked, most))
                        }
                    };
                    ensure!(
                        asked.get() <= most,
                        "more than {most} questions for colours of {visible:?}"
                    );
                    done
                }
                Call::Pixels(spots) => {
                    let points = spots.0.iter().map(|spot| stage.point(*spot));
                    target.draw_iter(points.map(|point| Pixel(point, hue.color())))
                }
                Call::Clear => target.clear(hue.color()),
            };
            if done.is_err() {
                return Ok(done);
            }
        }
        Ok(Ok(()))
    }

    /// The picture by definition; `paint` takes the place of every colour.
    fn expected(&self, paint: Option<Rgb565>) -> anyhow::Result<Vec<Rgb565>> {
        let stage = &self.stage;
        let mut sheet = Sheet::new(stage.window, background());
        for (call, hue) in &self.calls.0 {
            let color = paint.unwrap_or(hue.color());
            let mut put = |point: Point, color: Rgb565| sheet.put(point, paint.unwrap_or(color));
            let inside = |window: &Window| window.intersection(&stage.window).to_rectangle().points();
            match call {
                Call::Span { y, start, end } => {
                    let Point { x, y: row } = stage.origin();
                    let (row, start, end) = (y.from(row), start.from(x), end.from(x));
                    let on_span = stage.area().points();
                    let on_span = on_span.filter(|point| point.y == row && start <= point.x && point.x < end);
                    on_span.for_each(|point| put(point, color));
                }
                Call::Window([first, end]) => {
                    inside(&window(stage, first, end)).for_each(|point| put(point, color));
                }
                Call::Triangle(corners) => {
                    let corners = corners.map(|corner| exact::wide(stage.point(corner)));
                    let pixels = stage.area().points();
                    let filled = pixels.filter(|point| exact::filled_triangle_has(corners, exact::wide(*point)));
                    filled.for_each(|point| put(point, color));
                }
                Call::Line(ends) => {
                    let [from, to] = ends.map(|end| exact::wide(stage.point(end)));
                    let pixels = stage.area().points();
                    let on_line = pixels.filter(|point| exact::line_has(from, to, exact::wide(*point)));
                    on_line.for_each(|point| put(point, color));
                }
                Call::Solid(area) => {
                    inside(&Window::from(area.get(stage))).for_each(|point| put(point, color));
                }
                Call::Contiguous { area, colors } => {
                    let area = area.get(stage);
                    for point in inside(&Window::from(area)) {
                        let along = |pixel: i32, first: i32| (i128::from(pixel) - i128::from(first)) as u128;
                        let (column, row) = (along(point.x, area.top_left.x), along(point.y, area.top_left.y));
                        let index = row * u128::from(area.size.width) + column;
                        let is_there = match colors {
                            Colors::Endless => true,
                            Colors::Some(count) => index < u128::from(*count),
                        };
                        let endless = Endless { hue: *hue, next: 0 };
                        if let Some(color) = endless.take(3).nth((index % 3) as usize).filter(|_| is_there) {
                            put(point, color);
                        }
                    }
                }
                Call::Pixels(spots) => spots.0.iter().for_each(|spot| put(stage.point(*spot), color)),
                Call::Clear => stage.area().points().for_each(|point| put(point, color)),
            }
        }
        Ok(sheet.pixels().to_vec())
    }
}

fn window(stage: &Stage, first: &Spot, end: &Spot) -> Window {
    let (first, end) = (stage.point(*first), stage.point(*end));
    Window {
        left: first.x,
        top: first.y,
        right: end.x,
        bottom: end.y,
    }
}

impl Case for CallsCase {
    fn check(&self) -> Verdict {
        let window = &self.stage.window;
        let expected = self.expected(None)?;
        let band = Canvas::new(*window).draw::<LittleEndian>(|band| self.call(band).map(sure))?;
        is_same(window, &expected, &band).context("by definition, the other on a band")?;
        let band = Canvas::new(*window).draw::<BigEndian>(|band| self.call(band).map(sure))?;
        is_same(window, &expected, &band).context("by definition, the other on a band of big-endian words")?;
        let band =
            Canvas::new(*window).draw::<LittleEndian>(|band| self.call(&mut band.in_linear_light::<22>()).map(sure))?;
        is_same(window, &expected, &band).context("by definition, the other on a band in linear light")?;
        let samples = Canvas::new(*window).draw::<LittleEndian>(|band| {
            let mut samples = vec![0; Rooks::<4>::SAMPLES * self.stage.pixels()];
            band.multisample(Rooks::<4>, &mut samples, |target| self.call(target).map(sure))?
        })?;
        is_same(window, &expected, &samples).context("by definition, the other with samples")?;
        let colors = [Hue::White.color()];
        let paint = Pattern::new(1, &colors).context("a pattern of one colour")?;
        let painted =
            Canvas::new(*window).draw::<LittleEndian>(|band| self.call(&mut band.painted(&paint)).map(sure))?;
        is_same(window, &self.expected(Some(colors[0]))?, &painted).context("by definition, the other painted")?;

        // Each call may write every pixel, and each pixel of its own list.
        let calls = self.calls.0.len() as u64;
        let pixels = calls * (self.stage.pixels() as u64 + 8);
        let mut sheet = Sheet::new(*window, background()).with_most(pixels, pixels);
        match self.call(&mut Generic(&mut sheet))? {
            Ok(()) => {}
            Err(Stopped::TooMuchWork) => bail!("{} calls and {} pixels on a display", sheet.calls, sheet.taken),
            Err(Stopped::AsTold) => bail!("an error that nobody told"),
        }
        sheet.was_treated_well()?;
        is_same(window, &expected, sheet.pixels()).context("by definition, the other on a display")
    }
}

/// Words of colours, and runs of them.
#[derive(Debug, Arbitrary)]
pub struct WordsCase {
    raw: u32,
    length: u8,
    offset: u8,
    stride: u8,
    width: u8,
    word: u32,
}

fn check_color<C, R>(raw: u32) -> Verdict
where
    C: BandColor + PixelColor<Raw = R> + From<R> + PartialEq + std::fmt::Debug,
    R: RawData + From<C>,
    R::Storage: Into<u32>,
{
    let color = C::from(R::from_u32(raw));
    let word = color.to_word();
    ensure!(C::from_word(word) == color, "{color:?} is another one as a word");
    ensure!(
        BigEndian::reorder(BigEndian::reorder(word)) == word && LittleEndian::reorder(word) == word,
        "{word:?} in another order is another word"
    );
    Ok(())
}

impl WordsCase {
    /// A run of pixels, and a block of rows of a wider band, are filled whole and nothing beside them.
    fn check_runs<C: BandColor + PartialEq + std::fmt::Debug>(&self, color: C, guard: C) -> Verdict {
        let (length, offset) = (i32::from(self.length), i32::from(self.offset % 8));
        let columns = (offset + length + 8) as usize;
        let mut words = vec![guard.to_word(); columns];
        let mut band = Band::<C>::new(Rectangle::new(Point::zero(), Size::new(columns as u32, 1)), &mut words)?;
        let raw = band.raw(color);
        let Ok(()) = band.fill_span(Span::new(0, offset, offset + length), raw);
        for (x, found) in (0..).zip(&words) {
            let expected = if (offset..offset + length).contains(&x) {
                color
            } else {
                guard
            };
            ensure!(
                *found == expected.to_word(),
                "{length} words at {offset}: {found:?} at {x}"
            );
        }
        let (stride, width) = (i32::from(self.stride % 24) + 1, i32::from(self.width % 32));
        let rows = length / 8 + 1;
        let mut words = vec![guard.to_word(); (stride * rows) as usize];
        let area = Rectangle::new(Point::zero(), Size::new(stride as u32, rows as u32));
        let mut band = Band::<C>::new(area, &mut words)?;
        let window = Window {
            left: offset,
            top: 1,
            right: offset.saturating_add(width),
            bottom: rows,
        };
        let Ok(()) = band.fill_window(window, raw);
        for (point, found) in area.points().zip(&words) {
            let expected = if window.contains(point) { color } else { guard };
            ensure!(
                *found == expected.to_word(),
                "{window:?} in {stride}: {found:?} at {point:?}"
            );
        }
        Ok(())
    }
}

impl Case for WordsCase {
    fn check(&self) -> Verdict {
        check_color::<BinaryColor, RawU1>(self.raw)?;
        check_color::<Gray2, RawU2>(self.raw)?;
        check_color::<Gray4, RawU4>(self.raw)?;
        check_color::<Gray8, RawU8>(self.raw)?;
        check_color::<Rgb555, RawU16>(self.raw)?;
        check_color::<Rgb565, RawU16>(self.raw)?;
        check_color::<Bgr565, RawU16>(self.raw)?;
        check_color::<Rgb666, RawU24>(self.raw)?;
        check_color::<Bgr666, RawU24>(self.raw)?;
        check_color::<Rgb888, RawU24>(self.raw)?;
        check_color::<Bgr888, RawU24>(self.raw)?;
        let grey = Gray8::new(self.word as u8);
        self.check_runs(grey, Gray8::new(!grey.luma()))?;
        let [color, guard] = [self.word, !self.word].map(|word| Rgb565::from(RawU16::from_u32(word)));
        self.check_runs(color, guard)?;
        let [color, guard] = [self.word, !self.word].map(|word| Rgb888::from(RawU24::from_u32(word)));
        self.check_runs(color, guard)
    }
}

/// Spans by themselves.
#[derive(Debug, Arbitrary)]
pub struct SpansCase {
    span: [Int; 3],
    window: [Int; 4],
    column: Int,
}

impl Case for SpansCase {
    fn check(&self) -> Verdict {
        let [y, start, end] = self.span.map(|number| number.0);
        let span = Span::new(y, start, end);
        let area = span.to_window();
        // Row i32::MAX is none of a window.
        ensure!(
            span.is_empty() == area.is_empty() || y == i32::MAX,
            "{span:?} is empty or not as a window"
        );
        ensure!(area.height() <= 1, "{span:?} has {} rows", area.height());
        let [left, top, right, bottom] = self.window.map(|side| side.0);
        let window = Window {
            left,
            top,
            right,
            bottom,
        };
        let visible = span.clipped_to(&window);
        ensure!(visible.y == y, "{visible:?} of {span:?}");
        let has = |span: &Span, x: i32| span.start <= x && x < span.end;
        let sides = [start, end, left, right].map(|side| [side.saturating_sub(1), side]);
        for x in sides.into_iter().flatten().chain([self.column.0]) {
            let expected = has(&span, x) && window.contains(Point::new(x, y));
            ensure!(
                has(&visible, x) == expected,
                "column {x} of {span:?} in {window:?}: {visible:?}"
            );
        }
        Ok(())
    }
}
