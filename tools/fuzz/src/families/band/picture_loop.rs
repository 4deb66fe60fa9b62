//! Loops over any area, and sinks that fail.

use std::cell::RefCell;

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{Rgb565, raw::ToBytes},
    primitives::Rectangle,
};
use zrow::{
    band::{Band, BytesSink, DisplaySink, LoopError, PictureLoop},
    geometry::{TooSmall, Window},
};

use super::{
    Broken, Scene,
    futures::{block_on, slowly},
};
use crate::{
    picture::{Sheet, Stopped, background},
    target::{Case, Verdict},
    values::{Count, Int, Length, Stage},
};

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
            let error = LoopError::TooSmall(TooSmall::Words(needed));
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
        let send = async |area: Rectangle, bytes: &[u8]| {
            slowly().await;
            notes.take(area, bytes)
        };
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
