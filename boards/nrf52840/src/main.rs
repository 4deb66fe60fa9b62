//! zrow on the nRF52840-DK: draws an antialiased instrument panel and a lit and textured teapot on an ST7789, with embassy: a band
//! is a future that EasyDMA fulfils, while the next band is drawn.
//!
//! defmt prints over RTT what each frame took, with the microseconds since the start.

#![no_std]
#![no_main]

mod bus;

use bus::{Blocks, Bus};
use defmt_rtt as _;
use embassy_executor::Spawner;
use embassy_nrf::{
    Peripherals, bind_interrupts, config,
    gpio::{Level, Output, OutputDrive},
    peripherals,
    spim::{self, Frequency, Spim},
};
use embassy_time::Delay;
use panic_probe as _;
use static_cell::ConstStaticCell;
use zrow_async_st7789::{Panel, Pins, show_scenes};

bind_interrupts!(struct Interrupts {
    SPIM3 => spim::InterruptHandler<peripherals::SPI3>;
});

static BLOCKS: ConstStaticCell<Blocks> = ConstStaticCell::new(Blocks::EMPTY);

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let mut config = config::Config::default();
    // The clock of a fast SPI is to be as steady as the crystal.
    config.hfclk_source = config::HfclkSource::ExternalXtal;
    let (spim, pins) = wires(embassy_nrf::init(config));
    let (bands, bus) = BLOCKS.take().split(spim);
    let Ok(mut panel) = Panel::start(bus, Bus::settle, pins, &mut Delay) else {
        defmt::panic!("the panel does not start");
    };
    let Err(failure) = show_scenes(&mut panel, bands, |frame| defmt::info!("{}", frame)).await;
    defmt::panic!("{}", failure);
}

/// The bus, and the pins of the panel. The bus is on port 0: most pins of port 1 are for slow signals only.
fn wires(chip: Peripherals) -> (Spim<'static>, Pins<Output<'static>>) {
    let mut config = spim::Config::default();
    config.frequency = Frequency::M32;
    let spim = Spim::new_txonly(chip.SPI3, Interrupts, chip.P0_27, chip.P0_26, config);
    let pins = Pins {
        data_not_command: Output::new(chip.P1_11, Level::High, OutputDrive::Standard),
        select: Output::new(chip.P1_12, Level::High, OutputDrive::Standard),
        reset: Output::new(chip.P1_10, Level::High, OutputDrive::Standard),
        backlight: Output::new(chip.P1_08, Level::Low, OutputDrive::Standard),
    };
    (spim, pins)
}
