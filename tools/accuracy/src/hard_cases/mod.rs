//! What rasterizers fail on: the exact answer, what zrow gives, and what others give in the same run.

mod booleans;
mod circles;
mod lines;
mod peers;
mod polygons;
mod round_shapes;

use crate::axis::{Axis, Chapter, Context};

/// Lines, circles, polygons and regions that are degenerate, cross themselves, or reach far outside.
pub struct HardCases;

impl Axis for HardCases {
    fn name(&self) -> &'static str {
        "hard_cases"
    }

    /// None: what they cost is no question here.
    fn counts(&self) -> Vec<String> {
        Vec::new()
    }

    fn run(&self, _: &Context<'_>) -> anyhow::Result<Chapter> {
        Ok(Chapter {
            name: self.name(),
            title: "Hard cases",
            about: vec![
                "Polygons that are degenerate, cross themselves or reach far outside, antialiased by zrow in this run, beside \
                 their exact areas. zrow draws them by the exact area of the inside; the area \"without crossings\" is for contours \
                 that do not cross themselves. zeno, ab_glyph_rasterizer and tiny-skia draw the same polygons in this run; the \
                 last column was read from trackers, or seen when they were run by hand."
                    .to_owned(),
                "Lines and circles of one pixel are compared with the nearest pixels, by whole numbers of 128 bits. A pixel is \
                 wrong where another one of its step is nearer, or where a step has none; of two that are equally near, either is \
                 right. A line \"cut at whole pixels\" has its ends on the screen's border by Liang and Barsky's algorithm, \
                 rounded, and is drawn exactly from there on, as textbooks have it. Filled circles and ellipses are compared with \
                 their inequalities in the same numbers; a filled shape of embedded-graphics panics where its numbers overflow, \
                 or, without overflow checks, is another one. Regions are clipped by Greiner and Hormann's \
                 algorithm; their areas follow from the corners by hand."
                    .to_owned(),
            ],
            operation: "one polygon",
            memory: None,
            figures: Vec::new(),
            diagrams: Vec::new(),
            summaries: vec![
                polygons::summary()?,
                lines::summary()?,
                circles::summary()?,
                round_shapes::summary(),
                booleans::summary()?,
            ],
            entries: Vec::new(),
        })
    }
}
