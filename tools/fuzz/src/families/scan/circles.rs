//! Thin circles and ellipses by several rules: inside of the window, each pixel once, and the same pixels where two rules
//! define the same outline.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::geometry::{Point, Size};
use zrow::{
    geometry::Window,
    scan::round::{
        RadiusTooLarge, bresenham_circle, midpoint_circle, midpoint_ellipse, parametric_circle, parametric_ellipse,
        square_root_circle, square_root_ellipse,
    },
};

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
    outline: Result<impl Iterator<Item = Point>, RadiusTooLarge>,
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

impl Case for OutlinesCase {
    fn check(&self) -> Verdict {
        let (center, window) = (self.stage.point(self.center), &self.stage.window);
        let [radius, other] = self.radii.map(|radius| radius.0);
        let circle = pixels("bresenham_circle", bresenham_circle(center, radius, window), window)?;
        let midpoint = pixels("midpoint_circle", midpoint_circle(center, radius, window), window)?;
        ensure!(midpoint == circle, "midpoint_circle has other pixels");
        let root = pixels("square_root_circle", square_root_circle(center, radius, window), window)?;
        ensure!(root == circle, "square_root_circle has other pixels");
        pixels("parametric_circle", parametric_circle(center, radius, window), window)?;
        let radii = Size::new(radius, other);
        let ellipse = pixels("midpoint_ellipse", midpoint_ellipse(center, radii, window), window)?;
        let root = pixels(
            "square_root_ellipse",
            square_root_ellipse(center, radii, window),
            window,
        )?;
        ensure!(root == ellipse, "square_root_ellipse has other pixels");
        pixels("parametric_ellipse", parametric_ellipse(center, radii, window), window)?;
        Ok(())
    }
}
