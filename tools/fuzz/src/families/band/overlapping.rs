//! Sinks to which a band is sent while the next one is drawn.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{pixelcolor::Rgb565, primitives::Rectangle};
use zrow::band::{Band, LittleEndian, LoopError, OverlappingSink, PictureLoop};

use super::{Broken, Scene};
use crate::{
    picture::background,
    target::{Case, Verdict},
    values::Stage,
};

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
