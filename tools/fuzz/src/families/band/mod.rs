//! `zrow::band`: memory of any size, loops over any area, and sinks that fail.

mod futures;
mod memory;
mod overlapping;
mod pages;
mod panel_rotation;
mod picture_loop;
mod supersampling;

use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::Point,
    pixelcolor::Rgb565,
    prelude::Primitive,
    primitives::{Circle, Line},
};
use zrow::{
    band::Target,
    draw::{DrawOn, PrimitiveStyle},
};

pub use memory::MemoryCase;
pub use overlapping::OverlappingCase;
pub use pages::PagesCase;
pub use panel_rotation::PanelRotationCase;
pub use picture_loop::LoopCase;
pub use supersampling::SupersamplingCase;

use crate::values::{Hue, Length, List, Spot, Stage};

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

/// The display's error.
#[derive(Debug, PartialEq, Eq)]
struct Broken;
