//! Draws frames of a scene through the picture loop, one row at a time.

use std::{
    convert::Infallible,
    hint::black_box,
    time::{Duration, Instant},
};

use anyhow::anyhow;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::{OutputImage, OutputSettings, SimulatorDisplay};
use zrow::band::{Band, BandColor, DisplaySink, LittleEndian, LoopError, Sink};
use zrow_scenes::{PictureCapacities, Prepared, Scene};

/// The shortest time from which a rate is computed.
const MEASURED_TIME: Duration = Duration::from_millis(150);

/// A scene and the one row it is drawn in.
pub struct Player<S: Scene> {
    scene: S,
    row: Vec<<S::Color as BandColor>::Word>,
    capacities_used: PictureCapacities,
}

impl<S: Scene> Default for Player<S> {
    fn default() -> Self {
        let blank = <S::Color as BandColor>::to_word(S::BACKGROUND);
        Self {
            scene: S::default(),
            row: vec![blank; S::picture().words_needed()],
            capacities_used: PictureCapacities::default(),
        }
    }
}

impl<S: Scene> Player<S> {
    /// The most that one of the frames drawn so far has taken of a picture's memory, where the scene is a picture.
    pub const fn capacities_used(&self) -> PictureCapacities {
        self.capacities_used
    }

    /// Draws a frame on a simulated display.
    pub fn display(&mut self, frame: u32, display: &mut SimulatorDisplay<S::Color>) -> anyhow::Result<()> {
        self.draw(frame, &mut DisplaySink(display))
    }

    /// Draws a frame as it would look on a display.
    pub fn image(&mut self, frame: u32, settings: &OutputSettings) -> anyhow::Result<OutputImage<Rgb888>> {
        let mut display = SimulatorDisplay::with_default_color(S::AREA.size, S::BACKGROUND);
        self.display(frame, &mut display)?;
        Ok(display.to_rgb_output_image(settings))
    }

    /// How fast this machine draws whole animations, without a display.
    pub fn frames_per_second(&mut self, frames: u32) -> anyhow::Result<f64> {
        let start = Instant::now();
        let mut drawn = 0.0;
        while start.elapsed() < MEASURED_TIME {
            for frame in 0..frames {
                self.draw(frame, &mut |band: Band<'_, S::Color, LittleEndian>| {
                    black_box(band.words());
                    Ok::<(), Infallible>(())
                })?;
                drawn += 1.0;
            }
        }
        Ok(drawn / start.elapsed().as_secs_f64())
    }

    fn draw<K>(&mut self, frame: u32, sink: &mut K) -> anyhow::Result<()>
    where
        K: Sink<S::Color, LittleEndian, Error = Infallible>,
    {
        let mut prepared = self.scene.prepare(frame)?;
        S::picture()
            .draw(&mut self.row, sink, |band| prepared.draw(band))
            .map_err(|error| match error {
                LoopError::TooSmall(error) => anyhow!(error),
                LoopError::Sink(never) => match never {},
            })?;
        if let Some(used) = prepared.capacities_used() {
            self.capacities_used = self.capacities_used.max(used);
        }
        Ok(())
    }
}

/// Bytes of the row that a scene is drawn in.
pub fn row_bytes<S: Scene>() -> usize {
    S::picture().words_needed() * size_of::<<S::Color as BandColor>::Word>()
}
