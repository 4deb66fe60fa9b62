//! Seed fills and paints.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{Rgb565, Rgb888},
    prelude::Primitive,
    primitives::{Circle, Line, PointsIter, Rectangle, Triangle},
};
use zrow::{
    band::{Band, Generic, Target},
    draw::{DrawOn, SeedFill},
    geometry::{DrawError, InputError, Window},
    shade::{LinearGradient, Paint, Pattern, RadialGradient, Ramp},
};

use crate::{
    picture::{Sheet, Stopped, UsersTarget, Work, agree, background, full_picture, is_same},
    target::{Case, Verdict},
    values::{Hue, Length, List, Spot, Stage, Style},
};

/// A fill from a seed over a picture of few colours.
#[derive(Debug, Arbitrary)]
pub struct SeedFillCase {
    stage: Stage,
    /// Two bits a pixel.
    picture: [u64; 12],
    seed: Spot,
    color: Tint,
    boundary: Option<Tint>,
    diagonally: bool,
}

/// One of the colours of the picture, or one that it has not.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Tint {
    Hue(Hue),
    Background,
}

impl Tint {
    fn color(self) -> Rgb565 {
        match self {
            Self::Hue(hue) => hue.color(),
            Self::Background => background(),
        }
    }
}

impl SeedFillCase {
    /// Background for half of the pixels.
    fn color_of(&self, pixel: usize) -> Rgb565 {
        let bits = self.picture[pixel / 32 % self.picture.len()] >> (pixel % 32 * 2) & 3;
        match bits {
            0 | 1 => background(),
            2 => Hue::Even.color(),
            _ => Hue::Odd.color(),
        }
    }

    /// The picture as a search pixel by pixel leaves it.
    fn searched(&self) -> Vec<Rgb565> {
        let window = self.stage.window;
        let (width, height) = (i64::from(window.width()), i64::from(window.height()));
        let mut pixels: Vec<_> = (0..self.stage.pixels()).map(|pixel| self.color_of(pixel)).collect();
        let seed = self.stage.point(self.seed);
        if !window.contains(seed) {
            return pixels;
        }
        let index_of = |x: i64, y: i64| (y * width + x) as usize;
        let (x, y) = (
            i64::from(seed.x) - i64::from(window.left),
            i64::from(seed.y) - i64::from(window.top),
        );
        let (old, new) = (pixels[index_of(x, y)], self.color.color());
        let is_inside = |color: Rgb565| match self.boundary {
            Some(boundary) => color != boundary.color() && color != new,
            None => color == old && color != new,
        };
        let mut waiting = vec![(x, y)];
        while let Some((x, y)) = waiting.pop() {
            if !(0..width).contains(&x) || !(0..height).contains(&y) || !is_inside(pixels[index_of(x, y)]) {
                continue;
            }
            pixels[index_of(x, y)] = new;
            let sides = [(1, 0), (-1, 0), (0, 1), (0, -1)];
            let corners = [(1, 1), (1, -1), (-1, 1), (-1, -1)];
            let corners = corners.into_iter().filter(|_| self.diagonally);
            waiting.extend(sides.into_iter().chain(corners).map(|(dx, dy)| (x + dx, y + dy)));
        }
        pixels
    }

    fn start<const STACK: usize>(&self, target: &Generic<'_, UsersTarget<'_, Rgb565>>) -> SeedFill<Rgb565, STACK> {
        let (seed, color) = (self.stage.point(self.seed), self.color.color());
        match self.boundary {
            Some(boundary) => SeedFill::boundary(seed, boundary.color(), color),
            None => SeedFill::flood(target, seed, color),
        }
        .eight_connected(self.diagonally)
    }
}

/// Room for any fill of such a picture.
const ENOUGH: usize = 1_024;

impl Case for SeedFillCase {
    fn check(&self) -> Verdict {
        let stage = &self.stage;
        let mut sheet = Sheet::new(stage.window, background());
        for (index, point) in stage.area().points().enumerate() {
            sheet.put(point, self.color_of(index));
        }
        let before = sheet.pixels().to_vec();
        let expected = self.searched();
        // Each pixel is read about three times; twice that, and the ends of rows.
        let most_reads = 6 * stage.pixels() as u64 + 8 * u64::from(stage.window.height()) + 8;

        let mut users = UsersTarget::new(&mut sheet).with_most_reads(2 * most_reads);
        let mut target = Generic(&mut users);
        let mut fill = self.start::<ENOUGH>(&target);
        ensure!(fill.run(&mut target).is_ok(), "no room for {ENOUGH} searches");
        let reads = users.reads();
        ensure!(reads <= most_reads, "{reads} reads of {} pixels", stage.pixels());
        sheet.was_treated_well()?;
        is_same(&stage.window, &expected, sheet.pixels()).context("searched, the other filled")?;
        ensure!(sheet.most_writes() <= 1, "a pixel is drawn twice");

        // With a stack that is too small, and on a display that fails, and on from there.
        let mut sheet = Sheet::new(stage.window, background());
        for (point, color) in stage.area().points().zip(&before) {
            sheet.put(point, *color);
        }
        let mut sheet = sheet.failing_at(u64::from(stage.rows));
        let mut users = UsersTarget::new(&mut sheet);
        let mut target = Generic(&mut users);
        let mut small = self.start::<4>(&target);
        let result = small.run(&mut target);
        let mut large = small.with_stack::<ENOUGH>().context("more room")?;
        match result {
            Ok(()) => {}
            Err(DrawError::TooSmall(full)) => ensure!(full.needed() > 4, "{full}, where there are 4"),
            Err(DrawError::OutOfDomain { .. }) => bail!("out of the domain, in a fill"),
            Err(DrawError::Target(Stopped::AsTold)) => {}
            Err(DrawError::Target(Stopped::TooMuchWork)) => bail!("too much work"),
        }
        let so_far = before.iter().zip(&expected).zip(sheet.pixels());
        let is_part = so_far
            .clone()
            .all(|((before, after), now)| now == before || now == after);
        ensure!(is_part, "a fill that stopped painted what it should not");
        sheet.mend();
        let mut users = UsersTarget::new(&mut sheet);
        let mut target = Generic(&mut users);
        ensure!(large.run(&mut target).is_ok(), "no room for {ENOUGH} searches");
        is_same(&stage.window, &expected, sheet.pixels()).context("searched, the other filled after it stopped")?;

        let mut words: Vec<u16> = vec![0; stage.pixels()];
        let mut band = Band::<Rgb565>::new(stage.area(), &mut words)?;
        for (word, color) in band.words_mut().iter_mut().zip(&before) {
            *word = Band::<Rgb565>::word(*color);
        }
        let (seed, color) = (stage.point(self.seed), self.color.color());
        let mut fill = match self.boundary {
            Some(boundary) => SeedFill::<_, ENOUGH>::boundary(seed, boundary.color(), color),
            None => SeedFill::flood(&band, seed, color),
        };
        fill = fill.eight_connected(self.diagonally);
        ensure!(fill.run(&mut band).is_ok(), "no room for {ENOUGH} searches");
        is_same(&stage.window, &expected, &band.colors().collect::<Vec<_>>()).context("searched, the other on a band")
    }
}

/// A paint of any kind.
#[derive(Debug, Arbitrary)]
enum AnyPaint {
    Pattern {
        width: u8,
        colors: List<Hue, 12>,
        origin: Spot,
    },
    Linear {
        ends: [Spot; 2],
        ramp: Stops,
    },
    Radial {
        center: Spot,
        radius: Length,
        ramp: Stops,
    },
}

/// Colours and levels, in order.
#[derive(Debug, Arbitrary)]
struct Stops([(u8, [u8; 3]); 3]);

impl Stops {
    fn ramp(&self) -> anyhow::Result<Ramp<3>> {
        let mut stops = self
            .0
            .map(|(level, [red, green, blue])| (level, Rgb888::new(red, green, blue)));
        stops.sort_by_key(|&(level, _)| level);
        Ramp::new(stops).context("stops in order")
    }
}

/// A shape that is drawn with a paint.
#[derive(Debug, Arbitrary)]
enum Shape {
    Rectangle(Spot, Length, Length),
    Circle(Spot, Length),
    Line(Spot, Spot),
    Triangle([Spot; 3]),
}

/// A shape in a paint: in each pixel that it has, the colour of the paint there.
#[derive(Debug, Arbitrary)]
pub struct PaintedCase {
    stage: Stage,
    shape: Shape,
    style: Style,
    paint: AnyPaint,
}

struct InPaint<'d, P> {
    case: &'d PaintedCase,
    paint: &'d P,
}

impl PaintedCase {
    fn draw<T: Target<Color = Rgb565>>(&self, target: &mut T) -> Result<(), T::Error> {
        let style = self.style.get();
        let point = |spot: Spot| self.stage.point(spot);
        match self.shape {
            Shape::Rectangle(corner, width, height) => {
                let size: Size = width.by(height);
                Rectangle::new(point(corner), size).into_styled(style).draw_on(target)
            }
            Shape::Circle(corner, diameter) => Circle::new(point(corner), diameter.0)
                .into_styled(style)
                .draw_on(target),
            Shape::Line(from, to) => Line::new(point(from), point(to)).into_styled(style).draw_on(target),
            Shape::Triangle([a, b, c]) => Triangle::new(point(a), point(b), point(c))
                .into_styled(style)
                .draw_on(target),
        }
    }

    fn check_with<P: Paint<Color = Rgb565>>(&self, paint: &P) -> Verdict {
        let stage = &self.stage;
        let painted = agree(stage, &InPaint { case: self, paint }, Work::ONCE)?;
        let plain = full_picture(stage.window, &Plain(self))?;
        let pixels = stage.area().points().zip(&plain);
        let expected: Vec<Rgb565> = pixels
            .map(|(point, color)| {
                if *color == background() {
                    Ok(background())
                } else {
                    paint.colors_from(point).next().context("a paint ends")
                }
            })
            .collect::<Result<_, _>>()?;
        is_same(&stage.window, &expected, &painted).context("pixel by pixel, the other in spans")
    }
}

impl<P: Paint<Color = Rgb565>> DrawOn for InPaint<'_, P> {
    type Color = Rgb565;

    fn draw_on<T: Target<Color = Rgb565>>(&self, target: &mut T) -> Result<(), T::Error> {
        self.case.draw(&mut target.painted(self.paint))
    }
}

/// The shape in its own colours.
struct Plain<'d>(&'d PaintedCase);

impl DrawOn for Plain<'_> {
    type Color = Rgb565;

    fn draw_on<T: Target<Color = Rgb565>>(&self, target: &mut T) -> Result<(), T::Error> {
        self.0.draw(target)
    }
}

impl Case for PaintedCase {
    fn check(&self) -> Verdict {
        let point = |spot: Spot| self.stage.point(spot);
        match &self.paint {
            AnyPaint::Pattern { width, colors, origin } => {
                let colors: Vec<_> = colors.0.iter().map(|hue| hue.color()).collect();
                let width = usize::from(*width) % 6;
                let pattern = Pattern::new(width, &colors);
                let is_rectangle = width > 0 && !colors.is_empty() && colors.len().is_multiple_of(width);
                let error = InputError::NotARectangle {
                    width,
                    colors: colors.len(),
                };
                match pattern {
                    Ok(pattern) => {
                        ensure!(is_rectangle, "{} colours in rows of {width}", colors.len());
                        self.check_with(&pattern.with_origin(point(*origin)))
                    }
                    Err(found) => {
                        ensure!(!is_rectangle && found == error, "{found}");
                        Ok(())
                    }
                }
            }
            AnyPaint::Linear { ends: [from, to], ramp } => {
                match LinearGradient::<Rgb565, 3>::new(point(*from), point(*to), ramp.ramp()?) {
                    Ok(gradient) => self.check_with(&gradient),
                    Err(error) => {
                        let ends = [point(*from), point(*to)];
                        let is_outside = |end: &Point| end.x.unsigned_abs().max(end.y.unsigned_abs()) > 8_191;
                        ensure!(ends.iter().any(is_outside), "{error} for {ends:?}");
                        Ok(())
                    }
                }
            }
            AnyPaint::Radial { center, radius, ramp } => {
                match RadialGradient::<Rgb565, 3>::new(point(*center), radius.0, ramp.ramp()?) {
                    Ok(gradient) => self.check_with(&gradient),
                    Err(error) => {
                        ensure!(radius.0 > 8_191, "{error} for a radius of {}", radius.0);
                        Ok(())
                    }
                }
            }
        }
    }
}

/// Levels of gradients: in order along a row from the beginning to the end, and the same wherever a span begins.
#[derive(Debug, Arbitrary)]
pub struct GradientCase {
    stage: Stage,
    ends: [Spot; 2],
    start: Spot,
    radius: Length,
}

impl Case for GradientCase {
    fn check(&self) -> Verdict {
        const COLUMNS: usize = 40;
        let ramp = Ramp::between(Rgb888::new(0, 0, 0), Rgb888::new(255, 255, 255));
        let [from, to] = self.ends.map(|end| self.stage.point(end));
        let start = self.stage.point(self.start);
        let level = |color: Rgb888| i128::from(embedded_graphics::prelude::RgbColor::r(&color));
        let row = Window {
            left: start.x,
            top: start.y,
            right: start.x.saturating_add(COLUMNS as i32),
            bottom: start.y,
        };
        let columns = (row.left..row.right).map(|x| Point::new(x, start.y));
        let wide = |point: Point| [i128::from(point.x), i128::from(point.y)];
        if let Ok(gradient) = LinearGradient::<Rgb888, 2>::new(from, to, ramp) {
            let levels = gradient.colors_from(start).map(level);
            let ([x0, y0], [x1, y1]) = (wide(from), wide(to));
            let length = (x1 - x0).pow(2) + (y1 - y0).pow(2);
            for (point, level) in columns.clone().zip(levels) {
                let [x, y] = wide(point);
                let along = (x - x0) * (x1 - x0) + (y - y0) * (y1 - y0);
                let expected = if length == 0 {
                    255
                } else {
                    crate::exact::nearest(255 * along, length).clamp(0, 255)
                };
                ensure!(level == expected, "level {expected} at {point:?}, the gradient {level}");
            }
        }
        if let Ok(gradient) = RadialGradient::<Rgb888, 2>::new(from, self.radius.0, ramp) {
            let levels = gradient.colors_from(start).map(level);
            let ([x0, y0], radius) = (wide(from), i128::from(self.radius.0));
            for (point, level) in columns.zip(levels) {
                let [x, y] = wide(point);
                let square = (x - x0).pow(2) + (y - y0).pow(2);
                // The largest level whose border ((2 n - 1) r / 510)^2 is not beyond: ties up.
                let begins = |n: &i128| *n == 0 || ((2 * n - 1) * radius).pow(2) <= square * 510 * 510;
                let expected = (0..=255).rev().find(begins).unwrap_or(0);
                ensure!(level == expected, "level {expected} at {point:?}, the gradient {level}");
            }
        }
        Ok(())
    }
}
