//! Counts a torus and a cube at 128 x 64 in one band, prepared and drawn by each method of visibility.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::Band,
    scan::Polygons,
    scene::Prepared,
    visible::{
        DepthBuffer, DepthSort, GridRayCasting, OneDepth, RayCasting, SpanScanLine, TileBins, Visibility, Warnock,
    },
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    standard::Sc1,
    stopwatch::Stopwatch,
};

const PIXELS: usize = 128 * 64;
const FACES: usize = 588;

/// The frames that are counted. By one depth the last one alone, because that takes a hundred times longer.
const FRAMES: [u32; 4] = [0, 16, 32, 48];

/// The scene, and its picture.
struct Picture {
    scene: Sc1,
    words: [u16; PIXELS],
}

impl Picture {
    const EMPTY: Self = Self {
        scene: Sc1::EMPTY,
        words: [0; PIXELS],
    };

    /// Prepares a frame and draws it into the cleared picture.
    #[inline(always)]
    fn draw(&mut self, frame: u32, draw: impl FnOnce(&mut Prepared<'_, '_, Rgb565>, &mut Band<'_, Rgb565>)) {
        self.words.fill(0);
        self.scene.draw_whole(frame, &mut self.words, draw);
    }

    /// Counts drawing by a method, whose memory is enough.
    fn count(&mut self, runner: &mut Runner, variant: &str, frames: &[u32], method: &mut impl Visibility<u16>) {
        runner.count("hidden_surfaces", variant, self, frames, |picture, &frame| {
            picture.draw(frame, |prepared, band| {
                if prepared.draw_by(method, band).is_err() {
                    report::exit(false)
                }
            });
        });
    }
}

impl Canvas for Picture {
    fn erase(&mut self) {
        self.words.fill(0);
    }

    /// Of the pixels of the last frame.
    fn checksum(&mut self) -> u32 {
        Checksum::of(self.words.iter().copied())
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let picture = cortex_m::singleton!(: Picture = Picture::EMPTY);
    let buffer = cortex_m::singleton!(: DepthBuffer<u16, PIXELS> = DepthBuffer::new());
    let sort = cortex_m::singleton!(: DepthSort<FACES, 100> = DepthSort::new());
    let rays = cortex_m::singleton!(: RayCasting<FACES> = RayCasting::new());
    let grid = cortex_m::singleton!(: GridRayCasting<FACES, { 8 * FACES }, { 16 * FACES }> = GridRayCasting::new());
    let spans = cortex_m::singleton!(: SpanScanLine<60> = SpanScanLine::new());
    let bins = cortex_m::singleton!(: TileBins<u16, 32, 2_000> = TileBins::new());
    let quarters = cortex_m::singleton!(: Warnock<FACES> = Warnock::new());
    let (Some(peripherals), Some(picture)) = (Peripherals::take(), picture) else {
        report::exit(false)
    };
    let (Some(buffer), Some(sort), Some(rays)) = (buffer, sort, rays) else {
        report::exit(false)
    };
    let (Some(grid), Some(spans), Some(bins), Some(quarters)) = (grid, spans, bins, quarters) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    runner.count("hidden_surfaces", "row", picture, &FRAMES, |picture, &frame| {
        picture.draw(frame, |prepared, band| prepared.draw(band));
    });
    picture.count(&mut runner, "intervals", &FRAMES, spans);
    picture.count(&mut runner, "buffer", &FRAMES, buffer);
    picture.count(&mut runner, "bins", &FRAMES, bins);
    picture.count(&mut runner, "sort", &FRAMES, sort);
    picture.count(&mut runner, "quarters", &FRAMES, quarters);
    picture.count(&mut runner, "rays", &FRAMES, rays);
    picture.count(&mut runner, "grid", &FRAMES, grid);
    picture.count(
        &mut runner,
        "one",
        &FRAMES[3..],
        &mut OneDepth::new(Polygons::winding_number),
    );
    report::exit(true)
}
