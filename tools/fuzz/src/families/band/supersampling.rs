//! Pictures that are drawn larger and filtered down.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    image::GetPixel,
    pixelcolor::{Rgb565, RgbColor},
    primitives::{PointsIter, Rectangle},
};
use zrow::{
    band::{Band, LoopError, Supersampling},
    coverage::{Bartlett, BoxFilter, Gaussian},
    geometry::{Sub8, SubPoint, TooSmall, Window},
    shade::{ConeFilter, SampleFilter},
};

use super::{Broken, Scene};
use crate::{
    picture::{background, is_same},
    target::{Case, Verdict},
    values::{Int, Stage, SubSpot},
};

/// A picture drawn larger and filtered down.
#[derive(Debug, Arbitrary)]
pub struct SupersamplingCase {
    stage: Stage,
    scene: Scene,
    filter: Filter,
    rows: u8,
    lacks: u8,
    fails_at: u8,
    point: SubSpot,
    any: [Int; 2],
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Filter {
    Box,
    Bartlett,
    Cone,
    Gaussian,
}

impl SupersamplingCase {
    fn check_with<const N: usize, F: SampleFilter<N> + Copy>(&self) -> Verdict {
        let Self { stage, scene, .. } = self;
        // Anywhere: an error, or enough said about the memory.
        let anywhere = Rectangle::new(Point::new(self.any[0].0, self.any[1].0), stage.area().size);
        if let Ok(supersampling) = Supersampling::<Rgb565, N, F>::new(anywhere, background()) {
            ensure!(
                supersampling.words_needed() > 0 || Window::from(anywhere).is_empty(),
                "no words needed"
            );
        }
        let point: SubPoint<Sub8> = self.point.inside(stage);
        if let Ok(enlarged) = Supersampling::<Rgb565, N, F>::enlarged(point) {
            let expected = |units: i32| (units + 128) * N as i32 - 128;
            let found = (enlarged.x_units(), enlarged.y_units());
            ensure!(
                found == (expected(point.x_units()), expected(point.y_units())),
                "{enlarged:?} of {point:?}"
            );
        }
        let Ok(supersampling) = Supersampling::<Rgb565, N, F>::new(stage.area(), background()) else {
            let Point { x, y } = stage.origin();
            let is_far = |start: i32| i64::from(start).abs() * N as i64 >= (1 << 30) - 1_000;
            ensure!(is_far(x) || is_far(y), "{:?} is refused", stage.area());
            return Ok(());
        };
        let width = stage.window.width() as usize;
        let sums_needed = Supersampling::<Rgb565, N, F>::sums_needed(width);
        let times = N as i32;
        let draw = |rows: u32, fails_at: Option<usize>| -> Result<Vec<Rgb565>, (Vec<Rgb565>, bool)> {
            let supersampling = supersampling.rows(rows);
            let mut samples = vec![0; supersampling.words_needed()];
            // What was in them does not matter.
            let mut sums = vec![F::Sum::default(); sums_needed];
            let mut picture = Vec::new();
            let mut sent = 0;
            let mut sink = |band: Band<'_, Rgb565>| {
                if Some(sent) == fails_at {
                    return Err(Broken);
                }
                sent += 1;
                picture.extend(band.colors());
                Ok(())
            };
            let drawn = supersampling.draw(&mut samples, &mut sums, &mut sink, |band| {
                let Ok(()) = scene.draw(stage, times, band);
            });
            match drawn {
                Ok(()) => Ok(picture),
                Err(error) => Err((picture, error == LoopError::Sink(Broken))),
            }
        };
        let Ok(picture) = draw(1, None) else {
            anyhow::bail!("an error that nobody told");
        };
        ensure!(
            picture.len() == stage.pixels(),
            "{} pixels of {}",
            picture.len(),
            stage.pixels()
        );
        let Ok(other) = draw(u32::from(self.rows), None) else {
            anyhow::bail!("an error that nobody told");
        };
        is_same(&stage.window, &picture, &other).context("by single rows of samples, the other by several")?;
        let fails_at = usize::from(self.fails_at) % stage.window.height() as usize;
        match draw(u32::from(self.rows), Some(fails_at)) {
            Err((part, true)) => ensure!(
                picture.starts_with(&part) && part.len() == fails_at * width,
                "another picture before the sink failed"
            ),
            other => anyhow::bail!("{other:?} of a sink that fails"),
        }
        // One colour stays that colour.
        if self.scene.0.0.is_empty() {
            ensure!(
                picture.iter().all(|color| *color == background()),
                "the background is another colour"
            );
        }
        let lacking = usize::from(self.lacks % 16);
        let mut samples = vec![0; supersampling.words_needed().saturating_sub(lacking)];
        let mut sums = vec![F::Sum::default(); sums_needed.saturating_sub(lacking)];
        let mut calls = 0;
        let mut sink = |_: Band<'_, Rgb565>| -> Result<(), Broken> {
            calls += 1;
            Ok(())
        };
        let drawn = supersampling.draw(&mut samples, &mut sums, &mut sink, |_| {});
        let expected = match lacking {
            0 => Ok(()),
            _ => Err(LoopError::TooSmall(TooSmall::Words(supersampling.words_needed()))),
        };
        ensure!(
            drawn == expected && (calls == 0) == (lacking > 0),
            "{drawn:?} where {lacking} words are lacking"
        );
        if self.filter == Filter::Box {
            self.check_means::<N>(&picture)?;
        }
        Ok(())
    }

    /// The mean of each pixel's samples, each channel rounded once, ties up.
    fn check_means<const N: usize>(&self, picture: &[Rgb565]) -> Verdict {
        let Self { stage, scene, .. } = self;
        let times = N as i32;
        let Window {
            left,
            top,
            right,
            bottom,
        } = stage.window;
        let enlarged = Window {
            left: left * times,
            top: top * times,
            right: right * times,
            bottom: bottom * times,
        };
        let mut words = vec![0; stage.pixels() * N * N];
        let mut band = Band::<Rgb565>::new(enlarged.to_rectangle(), &mut words)?;
        band.fill(background());
        let Ok(()) = scene.draw(stage, times, &mut band);
        let mean = |point: Point| {
            let corner = Point::new(point.x * times, point.y * times);
            let samples = Rectangle::new(corner, Size::new_equal(N as u32)).points();
            let colors = samples.map(|point| band.pixel(point).unwrap_or(Rgb565::BLACK));
            let (red, green, blue) = colors.fold((0, 0, 0), |(red, green, blue), color| {
                (
                    red + u32::from(color.r()),
                    green + u32::from(color.g()),
                    blue + u32::from(color.b()),
                )
            });
            let samples = (N * N) as u32;
            let rounded = |sum: u32| ((2 * sum + samples) / (2 * samples)) as u8;
            Rgb565::new(rounded(red), rounded(green), rounded(blue))
        };
        let expected: Vec<_> = stage.area().points().map(mean).collect();
        is_same(&stage.window, &expected, picture).context("the means, the other filtered")
    }
}

impl Case for SupersamplingCase {
    fn check(&self) -> Verdict {
        match self.filter {
            Filter::Box => {
                self.check_with::<2, BoxFilter>()?;
                self.check_with::<4, BoxFilter>()
            }
            Filter::Bartlett => self.check_with::<4, Bartlett>(),
            Filter::Cone => self.check_with::<2, ConeFilter>(),
            Filter::Gaussian => self.check_with::<2, Gaussian>(),
        }
    }
}
