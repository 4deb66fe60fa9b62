//! Counts a torus and a cube at 128 x 64 in one band, prepared and drawn by each method of visibility; and an icosphere, of which
//! no face hides another, by the depth row and by the painter's algorithm.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::Band,
    scan::Polygons,
    scene::{Look, Prepared},
    visible::{
        DepthBuffer, DepthSort, GridRayCasting, OneDepth, RayCasting, SpanScanLine, TileBins, Visibility, Warnock,
    },
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    standard::Stage,
    stopwatch::Stopwatch,
};
use zrow_scenes::standard::{SmallSphere, SmallTorus, Subject};

const PIXELS: usize = 128 * 64;
const FACES: usize = 588;

/// The frames that are counted. By one depth the last one alone, because that takes a hundred times longer.
const FRAMES: [u32; 4] = [0, 16, 32, 48];

/// A scene of up to `V` vertices and `F` faces, `A` of them in a row, and its picture.
struct Picture<S, const V: usize, const F: usize, const A: usize> {
    scene: Stage<S, Rgb565, V, F, A>,
    words: [u16; PIXELS],
}

/// A torus and a cube within it.
type Torus = Picture<SmallTorus, 296, FACES, 60>;
/// An icosphere.
type Sphere = Picture<SmallSphere, 162, 320, 20>;

impl<S, const V: usize, const F: usize, const A: usize> Picture<S, V, F, A>
where
    S: Subject<Shading = <Rgb565 as Look>::Shading>,
{
    const EMPTY: Self = Self {
        scene: Stage::EMPTY,
        words: [0; PIXELS],
    };

    /// Prepares a frame and draws it into the cleared picture.
    #[inline(always)]
    fn draw(&mut self, frame: u32, draw: impl FnOnce(&mut Prepared<'_, '_, Rgb565>, &mut Band<'_, Rgb565>)) {
        self.words.fill(0);
        self.scene.draw_whole(frame, &mut self.words, draw);
    }

    /// Counts drawing by the depth row.
    fn count_row(&mut self, runner: &mut Runner, name: &str) {
        runner.count(name, "row", self, &FRAMES, |picture, &frame| {
            picture.draw(frame, |prepared, band| prepared.draw(band));
        });
    }

    /// Counts drawing by a method, whose memory is enough.
    fn count(
        &mut self,
        runner: &mut Runner,
        [name, variant]: [&str; 2],
        frames: &[u32],
        method: &mut impl Visibility<u16>,
    ) {
        runner.count(name, variant, self, frames, |picture, &frame| {
            picture.draw(frame, |prepared, band| {
                if prepared.draw_by(method, band).is_err() {
                    report::exit(false)
                }
            });
        });
    }
}

impl<S, const V: usize, const F: usize, const A: usize> Canvas for Picture<S, V, F, A> {
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
    let picture = cortex_m::singleton!(: Torus = Torus::EMPTY);
    let sphere = cortex_m::singleton!(: Sphere = Sphere::EMPTY);
    let buffer = cortex_m::singleton!(: DepthBuffer<u16, PIXELS> = DepthBuffer::new());
    let sort = cortex_m::singleton!(: DepthSort<FACES, 100> = DepthSort::new());
    let rays = cortex_m::singleton!(: RayCasting<FACES> = RayCasting::new());
    let grid = cortex_m::singleton!(: GridRayCasting<FACES, { 8 * FACES }, { 16 * FACES }> = GridRayCasting::new());
    let spans = cortex_m::singleton!(: SpanScanLine<60> = SpanScanLine::new());
    let bins = cortex_m::singleton!(: TileBins<u16, 32, 2_000> = TileBins::new());
    let quarters = cortex_m::singleton!(: Warnock<FACES> = Warnock::new());
    let (Some(peripherals), Some(picture), Some(sphere)) = (Peripherals::take(), picture, sphere) else {
        report::exit(false)
    };
    let (Some(buffer), Some(sort), Some(rays)) = (buffer, sort, rays) else {
        report::exit(false)
    };
    let (Some(grid), Some(spans), Some(bins), Some(quarters)) = (grid, spans, bins, quarters) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    picture.count_row(&mut runner, "hidden_surfaces");
    picture.count(&mut runner, ["hidden_surfaces", "intervals"], &FRAMES, spans);
    picture.count(&mut runner, ["hidden_surfaces", "buffer"], &FRAMES, buffer);
    picture.count(&mut runner, ["hidden_surfaces", "bins"], &FRAMES, bins);
    picture.count(&mut runner, ["hidden_surfaces", "sort"], &FRAMES, sort);
    picture.count(&mut runner, ["hidden_surfaces", "quarters"], &FRAMES, quarters);
    picture.count(&mut runner, ["hidden_surfaces", "rays"], &FRAMES, rays);
    picture.count(&mut runner, ["hidden_surfaces", "grid"], &FRAMES, grid);
    picture.count(
        &mut runner,
        ["hidden_surfaces", "one"],
        &FRAMES[3..],
        &mut OneDepth::new(Polygons::winding_number),
    );
    sphere.count_row(&mut runner, "convex_solid");
    sphere.count(&mut runner, ["convex_solid", "sort"], &FRAMES, sort);
    report::exit(true)
}
