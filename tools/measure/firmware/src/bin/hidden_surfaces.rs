//! Counts a torus and a cube at 128 x 64 in one band, prepared and drawn by each method of visibility; and an icosphere, of which
//! no face hides another, a translucent teapot, and one with antialiased silhouettes, by the depth row and by the painter's
//! algorithm.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::Band,
    scan::Polygons,
    scene::{Antialiased, Look, Prepared},
    shade::Translucent,
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
use zrow_scenes::{
    effects::{SurfacePot, TranslucentPot},
    standard::{SmallSphere, SmallTorus, Subject},
};

const PIXELS: usize = 128 * 64;
const FACES: usize = 588;
const TEAPOT_FACES: usize = 992;

/// The frames that are counted. By one depth the last one alone, because that takes a hundred times longer.
const FRAMES: [u32; 4] = [0, 16, 32, 48];

/// A scene of up to `V` vertices and `F` faces, `A` of them in a row, and its picture.
struct Picture<S, L: Look, const V: usize, const F: usize, const A: usize> {
    scene: Stage<S, L, V, F, A>,
    words: [u16; PIXELS],
}

/// A torus and a cube within it.
type Torus = Picture<SmallTorus, Rgb565, 296, FACES, 60>;
/// An icosphere.
type Sphere = Picture<SmallSphere, Rgb565, 162, 320, 20>;
/// The Utah teapot, with an alpha of 128.
type Glass = Picture<TranslucentPot, Translucent<Rgb565>, 560, TEAPOT_FACES, 160>;
/// The Utah teapot with antialiased silhouettes.
type Surface = Picture<SurfacePot, Antialiased<Rgb565>, 560, TEAPOT_FACES, 160>;

impl<S, L, const V: usize, const F: usize, const A: usize> Picture<S, L, V, F, A>
where
    S: Subject,
    L: Look<Color = Rgb565, Shading = S::Shading>,
{
    const EMPTY: Self = Self {
        scene: Stage::EMPTY,
        words: [0; PIXELS],
    };

    /// Prepares a frame and draws it into the cleared picture.
    #[inline(always)]
    fn draw(&mut self, frame: u32, draw: impl FnOnce(&mut Prepared<'_, '_, L>, &mut Band<'_, Rgb565>)) {
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
        method: &mut impl Visibility<L::Depth>,
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

impl<S, L: Look, const V: usize, const F: usize, const A: usize> Canvas for Picture<S, L, V, F, A> {
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
    let glass = cortex_m::singleton!(: Glass = Glass::EMPTY);
    let surface = cortex_m::singleton!(: Surface = Surface::EMPTY);
    let buffer = cortex_m::singleton!(: DepthBuffer<u16, PIXELS> = DepthBuffer::new());
    let sort = cortex_m::singleton!(: DepthSort<FACES, 100> = DepthSort::new());
    let sort_teapot = cortex_m::singleton!(: DepthSort<TEAPOT_FACES, 100> = DepthSort::new());
    let rays = cortex_m::singleton!(: RayCasting<FACES> = RayCasting::new());
    let grid = cortex_m::singleton!(: GridRayCasting<FACES, { 8 * FACES }, { 16 * FACES }> = GridRayCasting::new());
    let spans = cortex_m::singleton!(: SpanScanLine<60> = SpanScanLine::new());
    let bins = cortex_m::singleton!(: TileBins<u16, 32, 2_000> = TileBins::new());
    let quarters = cortex_m::singleton!(: Warnock<FACES> = Warnock::new());
    let (Some(peripherals), Some(picture), Some(sphere)) = (Peripherals::take(), picture, sphere) else {
        report::exit(false)
    };
    let (Some(glass), Some(surface), Some(sort_teapot)) = (glass, surface, sort_teapot) else {
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
    glass.count_row(&mut runner, "painted.translucent");
    glass.count(&mut runner, ["painted.translucent", "sort"], &FRAMES, sort_teapot);
    surface.count_row(&mut runner, "painted.silhouettes");
    surface.count(&mut runner, ["painted.silhouettes", "sort"], &FRAMES, sort_teapot);
    report::exit(true)
}
