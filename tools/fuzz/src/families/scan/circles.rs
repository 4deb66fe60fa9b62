//! Thin circles and ellipses by several rules: inside of the window, each pixel once, and the same pixels where two rules
//! define the same outline.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::geometry::{Point, Size};
use zrow::geometry::{InputError, Window};
use zrow_methods::registry::{Agrees, Algorithm, CIRCLES, ELLIPSES};

use crate::{
    target::{Case, Verdict},
    values::{Length, Spot, Stage},
};

/// An outline around a centre.
#[derive(Debug, Arbitrary)]
pub struct OutlinesCase {
    stage: Stage,
    center: Spot,
    radii: [Length; 2],
}

/// More pixels than an outline has in such a window.
const TOO_MANY: usize = 4_000;

/// The pixels in order, if the radius is in the domain.
fn pixels(
    name: &str,
    outline: Result<impl Iterator<Item = Point>, InputError>,
    window: &Window,
) -> anyhow::Result<Option<Vec<(i32, i32)>>> {
    let Ok(outline) = outline else { return Ok(None) };
    let mut pixels: Vec<_> = outline.take(TOO_MANY).map(|pixel| (pixel.y, pixel.x)).collect();
    ensure!(pixels.len() < TOO_MANY, "{name}: pixels without end");
    ensure!(
        pixels.iter().all(|&(y, x)| window.contains(Point::new(x, y))),
        "{name}: a pixel outside of {window:?}"
    );
    pixels.sort_unstable();
    ensure!(
        pixels.windows(2).all(|pair| pair[0] != pair[1]),
        "{name}: a pixel twice"
    );
    Ok(Some(pixels))
}

/// Whether those that are exact have the pixels of the first.
fn agree(family: &[Algorithm], pixels: &[Option<Vec<(i32, i32)>>]) -> Verdict {
    for (algorithm, found) in family.iter().zip(pixels) {
        ensure!(
            algorithm.agrees != Agrees::Always || Some(found) == pixels.first(),
            "{} has other pixels",
            algorithm.name
        );
    }
    Ok(())
}

impl Case for OutlinesCase {
    fn check(&self) -> Verdict {
        let (center, window) = (self.stage.point(self.center), &self.stage.window);
        let [radius, other] = self.radii.map(|radius| radius.0);
        let radii = Size::new(radius, other);
        macro_rules! circles {
            ($([$name:ident] [$($draw:tt)+])+) => {
                &[$(pixels(stringify!($name), $($draw)+(center, radius, window), window)?),+]
            };
        }
        macro_rules! ellipses {
            ($([$name:ident] [$($draw:tt)+])+) => {
                &[$(pixels(stringify!($name), $($draw)+(center, radii, window), window)?),+]
            };
        }
        agree(CIRCLES, zrow_methods::circles!(circles))?;
        agree(ELLIPSES, zrow_methods::ellipses!(ellipses))?;
        Ok(())
    }
}
