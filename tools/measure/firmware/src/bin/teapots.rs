//! Counts the Utah teapot in each shading, and a square with a texture.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use zrow_measure_firmware::{
    report,
    run::Runner,
    standard::{
        BilinearTeapot, FlatLitTeapot, FlatTeapot, GouraudTeapot, MultisampledTeapot, SilhouetteTeapot, TexturedQuad,
        TexturedTeapot, count, count_item, count_samples,
    },
    stopwatch::Stopwatch,
};

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let flat = cortex_m::singleton!(: FlatTeapot = FlatTeapot::EMPTY);
    let flat_lit = cortex_m::singleton!(: FlatLitTeapot = FlatLitTeapot::EMPTY);
    let gouraud = cortex_m::singleton!(: GouraudTeapot = GouraudTeapot::EMPTY);
    let textured = cortex_m::singleton!(: TexturedTeapot = TexturedTeapot::EMPTY);
    let bilinear = cortex_m::singleton!(: BilinearTeapot = BilinearTeapot::EMPTY);
    let silhouettes = cortex_m::singleton!(: SilhouetteTeapot = SilhouetteTeapot::EMPTY);
    let multisampled = cortex_m::singleton!(: MultisampledTeapot = MultisampledTeapot::EMPTY);
    let quad = cortex_m::singleton!(: TexturedQuad = TexturedQuad::EMPTY);
    let (
        Some(peripherals),
        Some(flat),
        Some(flat_lit),
        Some(gouraud),
        Some(textured),
        Some(bilinear),
        Some(silhouettes),
        Some(multisampled),
        Some(quad),
    ) = (
        Peripherals::take(),
        flat,
        flat_lit,
        gouraud,
        textured,
        bilinear,
        silhouettes,
        multisampled,
        quad,
    )
    else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    count(&mut runner, "scene.teapot.flat", flat);
    count(&mut runner, "scene.teapot.flat_lit", flat_lit);
    count_item(&mut runner, "scene.teapot.flat_lit", flat_lit);
    count(&mut runner, "scene.teapot.gouraud", gouraud);
    count(&mut runner, "scene.teapot.textured_lit", textured);
    count(&mut runner, "scene.teapot.bilinear", bilinear);
    count(&mut runner, "scene.teapot.silhouettes", silhouettes);
    count_samples(&mut runner, "scene.teapot.multisampled", multisampled);
    count(&mut runner, "scene.quad.textured", quad);
    report::exit(true)
}
