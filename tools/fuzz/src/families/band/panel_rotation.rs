//! Bands that are rotated on their way to a panel.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Dimensions, Point, Size},
    pixelcolor::Rgb565,
    primitives::Rectangle,
};
use zrow::{
    band::{Band, PanelRotation, PictureLoop},
    geometry::Window,
};

use super::Scene;
use crate::{
    picture::background,
    target::{Case, Verdict},
    values::{Count, Int, Stage},
};

/// Bands of any height, each of which has to arrive where its pixels belong.
#[derive(Debug, Arbitrary)]
pub struct PanelRotationCase {
    stage: Stage,
    quarter_turns: u8,
    scene: Scene,
    any: [Int; 4],
    any_size: [Count; 2],
}

impl PanelRotationCase {
    fn rotation(&self, picture: Rectangle) -> PanelRotation {
        match self.quarter_turns % 3 {
            0 => PanelRotation::by_90(picture),
            1 => PanelRotation::by_180(picture),
            _ => PanelRotation::by_270(picture),
        }
    }

    /// The column and the row in the picture of a pixel of the panel, both from the upper left pixel on.
    fn on_the_picture(&self, [x, y]: [i64; 2]) -> [i64; 2] {
        let window = self.stage.window;
        let (right, bottom) = (i64::from(window.width()) - 1, i64::from(window.height()) - 1);
        match self.quarter_turns % 3 {
            0 => [y, bottom - x],
            1 => [right - x, bottom - y],
            _ => [right - y, x],
        }
    }

    /// A band anywhere beside a picture anywhere.
    fn check_anywhere(&self) -> Verdict {
        let [x, y, left, top] = self.any.map(|coordinate| coordinate.0);
        let size = Size::from(self.any_size.map(|count| count.0));
        let mut words = [0; 64];
        let mut band = Band::<Rgb565>::new(Rectangle::new(Point::new(left, top), Size::new(16, 4)), &mut words)?;
        self.rotation(Rectangle::new(Point::new(x, y), size)).rotate(&mut band);
        let (size, words) = (band.bounding_box().size, band.words().len());
        ensure!((size.width * size.height) as usize == words, "{words} words for {size}");
        Ok(())
    }
}

impl Case for PanelRotationCase {
    fn check(&self) -> Verdict {
        self.check_anywhere()?;
        let Self { stage, scene, .. } = self;
        let area = stage.area();
        let mut whole = vec![0; stage.pixels()];
        let mut band = Band::<Rgb565>::new(area, &mut whole)?;
        band.fill(background());
        let Ok(()) = scene.draw(stage, 1, &mut band);
        let (left, top) = (i64::from(stage.window.left), i64::from(stage.window.top));
        let mut checked = 0;
        let mut sink = |band: Band<'_, Rgb565>| {
            let panel = Window::from(band.bounding_box());
            let columns = panel.width() as usize;
            for (index, word) in band.words().iter().enumerate() {
                let x = i64::from(panel.left) - left + (index % columns) as i64;
                let y = i64::from(panel.top) - top + (index / columns) as i64;
                let [x, y] = self.on_the_picture([x, y]);
                let position = y * i64::from(stage.window.width()) + x;
                let expected = usize::try_from(position).ok().and_then(|position| whole.get(position));
                ensure!(expected == Some(word), "{word} at {x}, {y}: {expected:?}");
                checked += 1;
            }
            Ok(())
        };
        let picture_loop = PictureLoop::new(area, background()).rows(stage.rows);
        let mut words = vec![0; picture_loop.words_needed()];
        let rotation = self.rotation(area);
        let sent = picture_loop.draw(&mut words, &mut sink, |band| {
            let Ok(()) = scene.draw(stage, 1, band);
            rotation.rotate(band);
        });
        match sent {
            Ok(()) => {}
            Err(zrow::band::LoopError::Sink(error)) => return Err(error).context("a rotated band"),
            Err(error) => ensure!(false, "{error:?}"),
        }
        // What does not fit into the number range is left out.
        let Window { right, bottom, .. } = stage.window;
        let fits = right.max(bottom) < i32::MAX - 64;
        ensure!(checked == whole.len() || !fits, "{checked} of {} pixels", whole.len());
        Ok(())
    }
}
