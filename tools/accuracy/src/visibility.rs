//! What methods of visibility cost over the number of faces and of layers, from figures that were recorded.

use zrow_measure::{RecordedTable, recorded_visibility};

use super::axis::{Axis, Cell, Chapter, Context, Diagram, Summary};

/// Methods that find out which face is seen: all of them exact, so that time and memory are what differs.
pub struct Visibility;

impl Axis for Visibility {
    fn name(&self) -> &'static str {
        "visibility"
    }

    /// None: some minutes of measuring are a report of their own.
    fn counts(&self) -> Vec<String> {
        Vec::new()
    }

    fn run(&self, _: &Context<'_>) -> anyhow::Result<Chapter> {
        let recorded = recorded_visibility()?;
        Ok(Chapter {
            name: self.name(),
            title: "Visibility: faces and layers",
            about: vec![
                "Every method draws the same picture, to the bit: their error is 0, and what differs is time and memory. Two \
                 scenes at 128 x 64 pixels, prepared and drawn in one band: two spheres that go through each other, of 12 to \
                 4,992 faces; and 1 to 16 walls, of two faces each, that fill the picture one behind the other in a random \
                 order and go through each other, in a colour a face and with a texture."
                    .to_owned(),
                format!(
                    "{} This report takes the figures over from docs/visibility.md, where is said which method to take when, \
                     and measures none of them; cargo run --release -- visibility counts them anew.",
                    recorded.measured
                ),
                "A method has no figure where a frame takes longer than the stopwatch of the emulated chips counts, or all of \
                 them longer than they may run. RAM is what a method takes beside what the depth row needs too."
                    .to_owned(),
            ],
            operation: "one frame",
            memory: None,
            figures: Vec::new(),
            diagrams: recorded
                .charts
                .into_iter()
                .map(|chart| Diagram {
                    name: chart.name,
                    title: chart.title,
                    svg: chart.svg,
                })
                .collect(),
            summaries: recorded.tables.into_iter().map(summary).collect(),
            entries: Vec::new(),
        })
    }
}

fn summary(table: RecordedTable) -> Summary {
    Summary {
        title: table.title,
        columns: table.columns,
        rows: table
            .rows
            .into_iter()
            .map(|row| row.into_iter().map(Cell::from).collect())
            .collect(),
    }
}
