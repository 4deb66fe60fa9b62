//! `zrow::band`: memory of any size, loops over any area, and sinks that fail.

use std::{
    cell::RefCell,
    future::{self, Future},
    pin::pin,
    task::{Context as TaskContext, Poll, Waker},
};

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Dimensions, Point, Size},
    image::GetPixel,
    pixelcolor::{
        BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb565, Rgb666, Rgb888, RgbColor,
        raw::{RawData, RawU1, RawU2, RawU4, RawU8, RawU16, RawU24, ToBytes},
    },
    prelude::Primitive,
    primitives::{Circle, Line, PointsIter, Rectangle},
};
use zrow::{
    band::{
        Band, BandColor, BigEndian, BytesSink, DisplaySink, LittleEndian, LoopError, Order, OverlappingSink,
        PictureLoop, Supersampling, Target,
    },
    coverage::{Bartlett, BoxFilter, Gaussian},
    draw::{DrawOn, PrimitiveStyle},
    geometry::{Sub8, SubPoint, Table, TooSmall, Window},
    shade::{ConeFilter, SampleFilter},
};

use crate::{
    picture::{Sheet, Stopped, background, is_same},
    target::{Case, Verdict},
    values::{Count, Hue, Int, Length, List, Spot, Stage, SubSpot},
};

/// The words and bytes of a band of any size.
#[derive(Debug, Arbitrary)]
pub struct MemoryCase {
    stage: Stage,
    words: u16,
    any: [Int; 2],
    any_size: [Count; 2],
    point: Spot,
    raw: [u32; 8],
}

impl MemoryCase {
    /// Bytes that a display takes: whole ones for each row, several pixels in a byte below 8 bits. Channels of 24-bit
    /// colours leave some bits of their byte unused.
    fn check_bytes<C, R, O>(&self, unused_bits: u32) -> Verdict
    where
        C: BandColor + PixelColor<Raw = R> + From<R> + ToBytes,
        <C as ToBytes>::Bytes: AsRef<[u8]>,
        R: RawData + From<C>,
        R::Storage: Into<u32>,
        O: Order,
    {
        let (width, height) = (self.stage.window.width() as usize, self.stage.window.height() as usize);
        let colors: Vec<C> = (0..width * height)
            .map(|index| C::from(R::from_u32(self.raw[index % 8].rotate_left(index as u32))))
            .collect();
        let words: Vec<C::Word> = colors.iter().map(|color| Band::<C, O>::word(*color)).collect();
        let mut memory = words.clone();
        let band = Band::<C, O>::new(self.stage.area(), &mut memory)?;
        let bytes = band.into_bytes().to_vec();
        let bits = R::BITS_PER_PIXEL;
        let expected: Vec<u8> = match bits {
            0..8 => {
                let rows = colors.chunks(width);
                let packed = |group: &[C]| {
                    let levels = group.iter().map(|color| R::from(*color).into_inner().into() as u8);
                    let byte = levels.fold(0, |byte: u32, level| byte << bits | u32::from(level));
                    (byte << (bits * (8 / bits - group.len()))) as u8
                };
                rows.flat_map(|row| row.chunks(8 / bits).map(packed).collect::<Vec<_>>())
                    .collect()
            }
            // Three bytes a pixel, with the channel at the top of its byte.
            24 => {
                let channel_bits = 8 - unused_bits;
                let to_bytes = |color: &C| {
                    let word: u32 = R::from(*color).into_inner().into();
                    let channels = [word >> (2 * channel_bits), word >> channel_bits, word];
                    channels.map(|channel| (channel << unused_bits) as u8)
                };
                colors.iter().flat_map(to_bytes).collect()
            }
            _ => colors
                .iter()
                .flat_map(|color| color.to_be_bytes().as_ref().to_vec())
                .collect(),
        };
        ensure!(bytes == expected, "{bits} bits a pixel: {bytes:?}, not {expected:?}");
        Ok(())
    }
}

impl Case for MemoryCase {
    fn check(&self) -> Verdict {
        let Self { stage, .. } = self;
        // Any area, with few words.
        let area = Rectangle::new(
            Point::new(self.any[0].0, self.any[1].0),
            Size::new(self.any_size[0].0, self.any_size[1].0),
        );
        let mut words = vec![0u16; usize::from(self.words % 512)];
        for area in [area, stage.area()] {
            let window = Window::from(area);
            let needed = u128::from(window.width()) * u128::from(window.height());
            let length = words.len();
            match Band::<Rgb565>::new(area, &mut words) {
                Ok(mut band) => {
                    ensure!(
                        needed <= length as u128 && band.words().len() as u128 == needed,
                        "{needed} words"
                    );
                    ensure!(
                        band.words_mut().len() as u128 == needed,
                        "{needed} words, to be written"
                    );
                    ensure!(band.colors().count() as u128 == needed, "{needed} colours");
                    ensure!(
                        Window::from(band.bounding_box()) == window || window.is_empty(),
                        "another box"
                    );
                    ensure!(band.window() == window, "another window");
                    let point = stage.point(self.point);
                    let has_row = (window.top..window.bottom).contains(&point.y);
                    let row = band.row_mut(point.y).map(|row| row.len());
                    ensure!(
                        row == has_row.then_some(window.width() as usize),
                        "row {} has {row:?} words of {window:?}",
                        point.y
                    );
                    ensure!(
                        band.pixel(point).is_some() == window.contains(point),
                        "{point:?} in {window:?}"
                    );
                    band.fill(Hue::Odd.color());
                    ensure!(
                        band.colors().all(|color| color == Hue::Odd.color()),
                        "a fill leaves something out"
                    );
                }
                Err(TooSmall { table, needed: said }) => {
                    ensure!(
                        table == Table::Words && needed > length as u128 && said as u128 == needed,
                        "{said} {table} for {needed} pixels"
                    );
                }
            }
        }
        self.check_bytes::<BinaryColor, RawU1, LittleEndian>(0)?;
        self.check_bytes::<Gray2, RawU2, LittleEndian>(0)?;
        self.check_bytes::<Gray4, RawU4, BigEndian>(0)?;
        self.check_bytes::<Gray8, RawU8, LittleEndian>(0)?;
        self.check_bytes::<Rgb565, RawU16, LittleEndian>(0)?;
        self.check_bytes::<Rgb565, RawU16, BigEndian>(0)?;
        self.check_bytes::<Rgb666, RawU24, LittleEndian>(2)?;
        self.check_bytes::<Rgb888, RawU24, LittleEndian>(0)?;
        self.check_bytes::<Rgb888, RawU24, BigEndian>(0)
    }
}

/// A few shapes.
#[derive(Debug, Arbitrary)]
struct Scene(List<(Spot, Spot, Length, Hue), 3>);

impl Scene {
    fn draw<T: Target<Color = Rgb565>>(&self, stage: &Stage, times: i32, target: &mut T) -> Result<(), T::Error> {
        for (one, other, diameter, hue) in &self.0.0 {
            let point = |spot: &Spot| {
                let point = stage.point(*spot);
                Point::new(point.x.saturating_mul(times), point.y.saturating_mul(times))
            };
            let diameter = diameter.0.saturating_mul(times.unsigned_abs());
            Circle::new(point(one), diameter)
                .into_styled(PrimitiveStyle::with_fill(hue.color()))
                .draw_on(target)?;
            Line::new(point(one), point(other))
                .into_styled(PrimitiveStyle::with_stroke(hue.color(), times.unsigned_abs()))
                .draw_on(target)?;
        }
        Ok(())
    }
}

/// Loops over an area in bands of any height on any grid.
#[derive(Debug, Arbitrary)]
pub struct LoopCase {
    stage: Stage,
    rows: Count,
    grid: Option<[Length; 2]>,
    scene: Scene,
    any: [Int; 2],
    any_size: [Count; 2],
    /// Words that the buffer lacks.
    lacks: u8,
    fails_at: u8,
}

/// Notes what it is sent, up to a failure.
#[derive(Debug, Default)]
struct Notes {
    areas: RefCell<Vec<Rectangle>>,
    bytes: RefCell<Vec<u8>>,
    fails_at: Option<usize>,
}

/// The display's error.
#[derive(Debug, PartialEq, Eq)]
struct Broken;

impl Notes {
    fn take(&self, area: Rectangle, bytes: &[u8]) -> Result<(), Broken> {
        let mut areas = self.areas.borrow_mut();
        if Some(areas.len()) == self.fails_at {
            return Err(Broken);
        }
        areas.push(area);
        self.bytes.borrow_mut().extend_from_slice(bytes);
        Ok(())
    }
}

/// A transfer that is pending twice.
async fn send_slowly(notes: &Notes, area: Rectangle, bytes: &[u8]) -> Result<(), Broken> {
    let mut polls = 0;
    future::poll_fn(|_| {
        polls += 1;
        if polls > 2 { Poll::Ready(()) } else { Poll::Pending }
    })
    .await;
    notes.take(area, bytes)
}

/// Polls a future to its end, which comes by itself.
fn block_on<F: Future>(future: F) -> F::Output {
    let mut future = pin!(future);
    let mut context = TaskContext::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(output) = future.as_mut().poll(&mut context) {
            return output;
        }
    }
}

impl LoopCase {
    fn picture_loop(&self, area: Rectangle) -> PictureLoop<Rgb565> {
        let picture_loop = PictureLoop::new(area, background()).rows(self.rows.0);
        match self.grid {
            Some([x, y]) => picture_loop.aligned(x.0, y.0),
            None => picture_loop,
        }
    }

    /// Bands of any area: one below the other, on the grid, around the area.
    fn check_bands(&self, area: Rectangle) -> Verdict {
        let picture_loop = self.picture_loop(area);
        let bands: Vec<Window> = picture_loop.bands().take(40).map(Window::from).collect();
        let area = Window::from(area);
        if area.is_empty() {
            return Ok(());
        }
        let first = bands.first().context("an area without a band")?;
        ensure!(
            first.left <= area.left && first.top <= area.top && first.right >= area.right,
            "{first:?} is not around {area:?}"
        );
        let follows = |[one, next]: [&Window; 2]| {
            one.bottom == next.top && (one.left, one.right) == (next.left, next.right) && !next.is_empty()
        };
        let pairs = bands.iter().zip(bands.iter().skip(1));
        ensure!(
            pairs.clone().all(|(one, next)| follows([one, next])),
            "bands that do not follow: {bands:?}"
        );
        ensure!(
            bands.iter().all(|band| band.height() <= first.height()),
            "a band higher than the first one: {bands:?}"
        );
        let needed = u128::from(first.width()) * u128::from(first.height());
        ensure!(picture_loop.words_needed() as u128 == needed, "{needed} words");
        if let Some([x, y]) = self.grid.map(|grid| grid.map(|length| i64::from(length.0.max(1)))) {
            let ends = [i64::from(i32::MIN), i64::from(i32::MAX)];
            let is_on = |side: i32, grid: i64| i64::from(side).rem_euclid(grid) == 0 || ends.contains(&side.into());
            ensure!(
                is_on(first.left, x) && is_on(first.right, x),
                "{first:?} on a grid of {x} columns"
            );
            ensure!(is_on(first.top, y), "{first:?} on a grid of {y} rows");
            let counts_from = if first.top == i32::MIN { i64::from(i32::MIN) } else { 0 };
            let end = (i64::from(area.bottom) + y - 1).div_euclid(y) * y;
            let is_row_on = |row: i32| {
                (i64::from(row) - counts_from).rem_euclid(y) == 0 || i64::from(row) == end.min(i32::MAX.into())
            };
            ensure!(
                bands.iter().all(|band| is_row_on(band.bottom)),
                "{bands:?} on a grid of {y} rows"
            );
        }
        Ok(())
    }

    fn check_sinks(&self) -> Verdict {
        let Self { stage, scene, .. } = self;
        // A loop around a grid may be as large as the grid.
        let fits = |grid: [Length; 2]| grid.iter().all(|length| length.0 <= 16);
        if !self.grid.is_none_or(fits) {
            return Ok(());
        }
        let picture_loop = self.picture_loop(stage.area());
        let needed = picture_loop.words_needed();
        let areas: Vec<Rectangle> = picture_loop.bands().collect();
        let draw = |band: &mut Band<'_, Rgb565>| {
            let Ok(()) = scene.draw(stage, 1, band);
        };
        let whole = Notes::default();
        let mut words = vec![0; needed];
        let sent = picture_loop.draw(
            &mut words,
            &mut BytesSink(|area, bytes: &[u8]| whole.take(area, bytes)),
            draw,
        );
        ensure!(sent == Ok(()), "{sent:?}");
        ensure!(*whole.areas.borrow() == areas, "other bands are sent");
        let bytes = whole.bytes.into_inner();

        // A buffer that is too small is an error before anything is sent.
        let lacking = usize::from(self.lacks).min(needed);
        if lacking > 0 {
            let notes = Notes::default();
            let mut sink = BytesSink(|area, bytes: &[u8]| notes.take(area, bytes));
            let sent = picture_loop.draw(&mut words[lacking..], &mut sink, draw);
            let error = LoopError::TooSmall(TooSmall {
                table: Table::Words,
                needed,
            });
            ensure!(
                sent == Err(error) && notes.areas.borrow().is_empty(),
                "{sent:?} of {needed} words"
            );
        }

        // A sink that fails gets nothing more; the bands before were right.
        let fails_at = usize::from(self.fails_at) % (areas.len() + 1);
        let failing = || Notes {
            fails_at: Some(fails_at),
            ..Notes::default()
        };
        let expected = if fails_at < areas.len() {
            Err(LoopError::Sink(Broken))
        } else {
            Ok(())
        };
        let is_right = |sent: Result<(), LoopError<Broken>>, notes: Notes, way: &str| -> Verdict {
            ensure!(sent == expected, "{way}: {sent:?}");
            let (areas_sent, bytes_sent) = (notes.areas.into_inner(), notes.bytes.into_inner());
            ensure!(
                areas.starts_with(&areas_sent) && areas_sent.len() == fails_at,
                "{way}: {areas_sent:?}"
            );
            ensure!(bytes.starts_with(&bytes_sent), "{way}: other bytes");
            Ok(())
        };
        let notes = failing();
        let sent = picture_loop.draw(
            &mut words,
            &mut BytesSink(|area, bytes: &[u8]| notes.take(area, bytes)),
            draw,
        );
        is_right(sent, notes, "draw")?;
        let notes = failing();
        let mut others = vec![0; needed];
        let mut sink = BytesSink(|area, bytes: &[u8]| notes.take(area, bytes));
        let (_, sent) = picture_loop.draw_overlapping([&mut words[..], &mut others[..]], &mut sink, draw);
        is_right(sent, notes, "draw_overlapping")?;
        let notes = failing();
        let send = async |area: Rectangle, bytes: &[u8]| send_slowly(&notes, area, bytes).await;
        let sent = block_on(picture_loop.draw_async([&mut words, &mut others], send, draw));
        is_right(sent, notes, "draw_async")?;

        // On a display, in one call a band.
        let window = areas.iter().copied().map(Window::from).reduce(|one, other| Window {
            bottom: other.bottom,
            ..one
        });
        let mut sheet = Sheet::new(window.context("an area without a band")?, background());
        let sent = picture_loop.draw(&mut words, &mut DisplaySink(&mut sheet), draw);
        ensure!(sent == Ok::<(), LoopError<Stopped>>(()), "{sent:?}");
        ensure!(
            sheet.calls == areas.len() as u64,
            "{} calls for {} bands",
            sheet.calls,
            areas.len()
        );
        sheet.was_treated_well()?;
        let big_endian = sheet.pixels().iter().flat_map(|color| color.to_be_bytes());
        ensure!(big_endian.eq(bytes.iter().copied()), "a display has another picture");
        Ok(())
    }
}

impl Case for LoopCase {
    fn check(&self) -> Verdict {
        let anywhere = Rectangle::new(
            Point::new(self.any[0].0, self.any[1].0),
            Size::new(self.any_size[0].0, self.any_size[1].0),
        );
        self.check_bands(anywhere)?;
        self.check_bands(self.stage.area())?;
        self.check_sinks()
    }
}

/// What an overlapping sink is given, it gives back.
#[derive(Debug, Arbitrary)]
pub struct OverlappingCase {
    stage: Stage,
    fails_to_start_at: Option<u8>,
    fails_to_finish_at: Option<u8>,
    scene: Scene,
}

/// Counts the transfers under way.
#[derive(Debug, Default)]
struct Bus {
    started: u8,
    finished: u8,
    fails_to_start_at: Option<u8>,
    fails_to_finish_at: Option<u8>,
    words: Vec<u16>,
}

impl OverlappingSink<Rgb565, LittleEndian, Vec<u16>> for Bus {
    type Transfer = Vec<u16>;
    type Error = Broken;

    fn start(&mut self, area: Rectangle, buffer: Vec<u16>) -> Result<Vec<u16>, (Vec<u16>, LoopError<Broken>)> {
        if Some(self.started) == self.fails_to_start_at {
            return Err((buffer, LoopError::Sink(Broken)));
        }
        self.started += 1;
        let pixels = (area.size.width * area.size.height) as usize;
        self.words.extend(buffer.iter().take(pixels));
        Ok(buffer)
    }

    fn finish(&mut self, transfer: Vec<u16>) -> (Vec<u16>, Result<(), Broken>) {
        let finished = self.finished;
        self.finished += 1;
        let failed = Some(finished) == self.fails_to_finish_at;
        (transfer, if failed { Err(Broken) } else { Ok(()) })
    }
}

impl Case for OverlappingCase {
    fn check(&self) -> Verdict {
        let Self { stage, scene, .. } = self;
        let picture_loop = PictureLoop::new(stage.area(), background()).rows(stage.rows);
        let needed = picture_loop.words_needed();
        let mut bus = Bus {
            fails_to_start_at: self.fails_to_start_at.map(|call| call % 18),
            fails_to_finish_at: self.fails_to_finish_at.map(|call| call % 18),
            ..Bus::default()
        };
        let draw = |band: &mut Band<'_, Rgb565>| {
            let Ok(()) = scene.draw(stage, 1, band);
        };
        let ([one, other], result) = picture_loop.draw_overlapping([vec![1; needed], vec![2; needed]], &mut bus, draw);
        ensure!(one.len() == needed && other.len() == needed, "a buffer is lost");
        ensure!(bus.started == bus.finished, "a transfer is under way");
        let bands = picture_loop.bands().count();
        let fails = [self.fails_to_start_at, self.fails_to_finish_at];
        let first = fails.into_iter().flatten().map(|call| usize::from(call % 18)).min();
        ensure!(
            result.is_err() == first.is_some_and(|call| call < bands),
            "{result:?} with {fails:?} of {bands} bands"
        );
        // Drawn again on a bus that works: the whole picture, however the first one ended.
        let mut works = Bus::default();
        let (_, result) = picture_loop.draw_overlapping([one, other], &mut works, draw);
        ensure!(
            result.is_ok() && usize::from(works.started) == bands,
            "{result:?} again"
        );
        let mut words = vec![0; stage.pixels()];
        let mut band = Band::<Rgb565>::new(stage.area(), &mut words)?;
        band.fill(background());
        let Ok(()) = scene.draw(stage, 1, &mut band);
        ensure!(words == works.words, "another picture after {fails:?}");
        ensure!(words.starts_with(&bus.words), "another picture before {fails:?}");
        Ok(())
    }
}

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
            _ => Err(LoopError::TooSmall(TooSmall {
                table: Table::Words,
                needed: supersampling.words_needed(),
            })),
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
