//! Hidden surfaces by each method: the same picture, with the work that was done for it drawn over it.

use core::fmt::Write;

use embedded_graphics::{
    mono_font::ascii::FONT_5X8, pixelcolor::Rgb565, prelude::*, primitives::Rectangle, text::Alignment,
};
use zrow::{
    band::{Band, BandColor, Order},
    draw::PrimitiveStyle,
    scan::Polygons,
    visible::{DepthBuffer, DepthSort, OneDepth, RayCasting, SpanScanLine, TileBins, Warnock},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{TITLE_COLOR, label, rgb, shape},
    visibility::{
        order::{TESTS, color_of_number, color_of_tests},
        panel::{Line, PANEL, Panel},
        solids::{ACTIVE, FACES, Frame},
        work::{BEHIND, COLUMNS, PIXELS, Painted, Record, Subject},
    },
};

/// Where the panels are.
const LEFT: [i32; 3] = [8, 218, 428];
const TOP: [i32; 3] = [20, 210, 400];

/// Tiles of 16 x 16 pixels, and the faces in their lists.
const TILES: usize = 20;
const FACES_IN_TILES: usize = 800;

/// The solids, and a panel for each method.
#[derive(Debug)]
pub struct VisibilitySiblings {
    subject: Subject,
    panels: [Panel; 9],
}

impl Default for VisibilitySiblings {
    fn default() -> Self {
        Self {
            subject: Subject::default(),
            panels: [Panel::EMPTY; 9],
        }
    }
}

impl Scene for VisibilitySiblings {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "visibility-siblings";
    const TITLE: &'static str = "hidden surfaces: the work of each method";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(640, 590));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);
    const DEPTH_ROW_BYTES: usize = size_of::<[u16; COLUMNS]>();

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        // A memory that has drawn remembers whether depths were needed, and what is counted would differ.
        self.subject = Subject::default();
        let mut frame = self.subject.prepare()?;
        let picture = Record::by_rows(&mut frame)?;
        let mut differing = 0;
        let mut compare = |record: &Record| {
            let pixels = record.words.iter().zip(&picture.words);
            differing += pixels.filter(|(word, expected)| word != expected).count();
        };
        let [rows, intervals, buffer, one, sort, windows, rays, tiles, last] = &mut self.panels;
        *rows = by_rows(&frame, &picture);
        *intervals = by_intervals(&mut frame, &mut compare)?;
        *buffer = by_buffer(&mut frame, &mut compare)?;
        *one = by_one_depth(&mut frame, &mut compare)?;
        *sort = by_sort(&mut frame, &mut compare)?;
        *windows = by_windows(&mut frame, &mut compare)?;
        *rays = by_rays(&mut frame, &mut compare)?;
        *tiles = by_tiles(&mut frame, &mut compare)?;
        *last = Panel::of(|pixel| Rgb565::from_word(picture.words.get(pixel).copied().unwrap_or_default()));
        last.name = "The picture";
        last.about = "by any method, from the depth row's";
        // Long enough for any number, as all texts here.
        let _ = write!(last.counted, "{differing} pixels differ");
        Ok(self)
    }
}

/// Takes what a method has drawn.
type Compare<'c> = &'c mut dyn FnMut(&Record);

fn by_rows(frame: &Frame<'_>, record: &Record) -> Panel {
    let counters = frame.counters();
    let mut panel = Panel::darkened(record).with_starts(record);
    panel.name = "Depth row (Myers 1975)";
    panel.about = "ticks: where the spans of faces begin";
    let spans = counters.spans_tested + counters.spans_filled;
    let _ = write!(panel.counted, "{spans} spans, {} depths tested", counters.pixels_tested);
    panel
}

fn by_intervals(frame: &mut Frame<'_>, compare: Compare<'_>) -> Result<Panel, PrepareError> {
    let mut method = SpanScanLine::<ACTIVE>::new();
    let record = Record::by(frame, &mut method)?;
    compare(&record);
    let mut panel = Panel::darkened(&record).with_starts(&record);
    panel.name = "Interval scan line (Watkins 1970)";
    panel.about = "ticks: where another face is seen";
    let _ = write!(
        panel.counted,
        "{} intervals, {} depths compared",
        method.intervals(),
        method.comparisons()
    );
    Ok(panel)
}

fn by_buffer(frame: &mut Frame<'_>, compare: Compare<'_>) -> Result<Panel, PrepareError> {
    let record = Record::by(frame, &mut DepthBuffer::<u16, PIXELS>::new())?;
    compare(&record);
    let mut panel = tests(&record);
    panel.name = "Depth buffer (Catmull 1974)";
    panel.about = "colours: faces tested in a pixel";
    let _ = write!(panel.counted, "{} depths tested", record.tested);
    Ok(panel)
}

fn by_one_depth(frame: &mut Frame<'_>, compare: Compare<'_>) -> Result<Panel, PrepareError> {
    let record = Record::by(frame, &mut OneDepth::new(Polygons::winding_number))?;
    compare(&record);
    let mut panel = tests(&record);
    panel.name = "One depth (Rogers 1985)";
    panel.about = "colours: faces that may cover a pixel";
    let _ = write!(panel.counted, "{} points tested", record.tested);
    Ok(panel)
}

fn by_sort(frame: &mut Frame<'_>, compare: Compare<'_>) -> Result<Panel, PrepareError> {
    let mut method = DepthSort::<{ 3 * FACES }, { 4 * FACES }>::new();
    let record = Record::by(frame, &mut method)?;
    compare(&record);
    let mut panel = Panel::of(|pixel| match record.painted.get(pixel) {
        Some(painted) if painted.number > 0 => color_of_number(painted.number, record.numbers),
        _ => BEHIND,
    });
    let at = |pixel: Option<usize>| {
        pixel
            .and_then(|pixel| record.painted.get(pixel))
            .copied()
            .unwrap_or_default()
    };
    for (pixel, cell) in panel.cells.iter_mut().enumerate() {
        let line = |beside| line_between(&record, [at(Some(pixel)), at(beside)]);
        (cell.left, cell.top) = (line(pixel.checked_sub(1)), line(pixel.checked_sub(COLUMNS)));
    }
    for number in 1..=record.numbers {
        if let Some((middle, 10..)) = record.middle_of(number) {
            // As many as there is room for.
            let _ = panel.numbers.push((middle, number.into()));
        }
    }
    panel.name = "Painter (Newell, Newell and Sancha 1972)";
    panel.about = "numbers: order of painting; red: splits";
    let counters = method.counters();
    let _ = write!(
        panel.counted,
        "{} pairs, {} moves, {} splits",
        counters.pairs, counters.moves, counters.splits
    );
    Ok(panel)
}

/// The line between two pixels: where one of their faces was split by the other, or parts of one face meet.
fn line_between(record: &Record, [one, other]: [Painted; 2]) -> Line {
    if one.number == other.number {
        return Line::No;
    }
    let is_split = |faces| record.splits.contains(&faces);
    let are_faces = one.number > 0 && other.number > 0;
    if are_faces && (one.face == other.face || is_split([one.face, other.face]) || is_split([other.face, one.face])) {
        Line::Special
    } else {
        Line::Dark
    }
}

fn by_windows(frame: &mut Frame<'_>, compare: Compare<'_>) -> Result<Panel, PrepareError> {
    let mut method = Warnock::<FACES>::new();
    let record = Record::by(frame, &mut method)?;
    compare(&record);
    let mut panel = Panel::darkened(&record).with_areas(&record);
    panel.name = "Warnock's subdivision (1969)";
    panel.about = "lines: windows, divided down to pixels";
    let _ = write!(
        panel.counted,
        "{} windows, {} pixels compared",
        method.windows(),
        method.pixels_compared()
    );
    Ok(panel)
}

fn by_rays(frame: &mut Frame<'_>, compare: Compare<'_>) -> Result<Panel, PrepareError> {
    let record = Record::by(frame, &mut RayCasting::<FACES>::new())?;
    compare(&record);
    let mut panel = tests(&record).with_areas(&record);
    panel.name = "Ray casting (Appel 1968)";
    panel.about = "lines: boxes; colours: faces tested";
    let _ = write!(panel.counted, "{} boxes, {} faces tested", record.areas, record.tested);
    Ok(panel)
}

fn by_tiles(frame: &mut Frame<'_>, compare: Compare<'_>) -> Result<Panel, PrepareError> {
    let record = Record::by(frame, &mut TileBins::<u16, TILES, FACES_IN_TILES>::new())?;
    compare(&record);
    let mut panel = Panel::darkened(&record).with_areas(&record);
    for (window, faces) in &record.first_areas {
        let middle = [window.left + window.right, window.top + window.bottom];
        let _ = panel.numbers.push((middle, *faces as u32));
    }
    panel.name = "Tile bins (Fuchs and others 1989)";
    panel.about = "numbers: faces in the list of a tile";
    let faces: usize = record.first_areas.iter().map(|(_, faces)| faces).sum();
    let _ = write!(panel.counted, "{} tiles, {faces} faces in their lists", record.areas);
    Ok(panel)
}

/// Each pixel in the colour of its tests.
fn tests(record: &Record) -> Panel {
    Panel::of(|pixel| color_of_tests(record.tests.get(pixel).copied().unwrap_or_default()))
}

impl Prepared for VisibilitySiblings {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        let title = <Self as Scene>::TITLE;
        label(band, title, Point::new(8, 6), Alignment::Left, &FONT_5X8, TITLE_COLOR);
        draw_legend(band);
        let positions = TOP
            .into_iter()
            .flat_map(|y| LEFT.into_iter().map(move |x| Point::new(x, y)));
        for (panel, position) in self.panels.iter().zip(positions) {
            panel.draw(band, position);
        }
    }
}

/// What the colours of tested pixels mean.
fn draw_legend<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let names = ["0", "1", "2", "4", "8", "16 tests"];
    for ((color, name), index) in TESTS.into_iter().zip(names).zip(0..) {
        let at = Point::new(428 + 28 * index, 6);
        let swatch = Rectangle::new(at, Size::new_equal(8));
        shape(band, &swatch.into_styled(PrimitiveStyle::with_fill(color)));
        label(
            band,
            name,
            at + Point::new(11, 0),
            Alignment::Left,
            &FONT_5X8,
            TITLE_COLOR,
        );
    }
}

const _: () = assert!(LEFT[2] + PANEL.width as i32 <= 640 && TOP[2] + PANEL.height as i32 <= 590);
