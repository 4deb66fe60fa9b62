//! zrow on the STM32F411 "Black Pill": draws an antialiased instrument panel and a lit and textured teapot on an ST7789, with
//! embassy: a band is a future that the DMA fulfils, while the next band is drawn.
//!
//! The blue LED changes its state with each frame, so that a logic analyser measures them.

#![no_std]
#![no_main]

use embassy_executor::Spawner;
use embassy_stm32::{
    Peripherals, bind_interrupts, dma,
    gpio::{Level, Output, Speed},
    mode::Async,
    pac::SPI1,
    peripherals,
    rcc::{APBPrescaler, Hse, HseMode, Pll, PllMul, PllPDiv, PllPreDiv, PllSource, Sysclk},
    spi::{self, Spi, mode::Master},
    time::Hertz,
};
use embassy_time::Delay;
use static_cell::ConstStaticCell;
use zrow_async_st7789::{Panel, Pins, WIDTH, show_scenes};

bind_interrupts!(struct Interrupts {
    DMA2_STREAM3 => dma::InterruptHandler<peripherals::DMA2_CH3>;
});

/// The bus of the panel.
type Bus = Spi<'static, Async, Master>;

/// The fastest of SPI1: half of the clock of its bus.
const BUS_CLOCK: Hertz = Hertz::mhz(50);
/// Words of a band: four rows.
const WORDS: usize = 4 * WIDTH as usize;

/// Two bands that take turns.
static BANDS: ConstStaticCell<[[u16; WORDS]; 2]> = ConstStaticCell::new([[0; WORDS]; 2]);

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let chip = embassy_stm32::init(clocks());
    let (bus, pins, mut led) = wires(chip);
    let Ok(mut panel) = Panel::start(bus, settle, pins, &mut Delay) else {
        stop();
    };
    let bands = BANDS.take().each_mut().map(|band| &mut band[..]);
    let Err(_) = show_scenes(&mut panel, bands, |_| led.toggle()).await;
    stop()
}

/// 100 MHz from the crystal of 25 MHz.
fn clocks() -> embassy_stm32::Config {
    let mut config = embassy_stm32::Config::default();
    config.rcc.hse = Some(Hse {
        freq: Hertz::mhz(25),
        mode: HseMode::Oscillator,
    });
    config.rcc.pll_src = PllSource::HSE;
    config.rcc.pll = Some(Pll {
        prediv: PllPreDiv::DIV25,
        mul: PllMul::MUL200,
        divp: Some(PllPDiv::DIV2),
        divq: None,
        divr: None,
    });
    config.rcc.sys = Sysclk::PLL1_P;
    // This bus takes no more than 50 MHz.
    config.rcc.apb1_pre = APBPrescaler::DIV2;
    config
}

/// The bus, the pins of the panel, and the LED.
fn wires(chip: Peripherals) -> (Bus, Pins<Output<'static>>, Output<'static>) {
    let mut config = spi::Config::default();
    config.frequency = BUS_CLOCK;
    let bus = Spi::new_txonly(chip.SPI1, chip.PA5, chip.PA7, chip.DMA2_CH3, Interrupts, config);
    let pins = Pins {
        data_not_command: Output::new(chip.PB0, Level::High, Speed::VeryHigh),
        select: Output::new(chip.PA4, Level::High, Speed::VeryHigh),
        reset: Output::new(chip.PB1, Level::High, Speed::Low),
        backlight: Output::new(chip.PB10, Level::Low, Speed::Low),
    };
    (bus, pins, Output::new(chip.PC13, Level::High, Speed::Low))
}

/// Waits until the bus is idle after the future of a transfer was dropped: the HAL stops the DMA only, and SPI1 may have two bytes left.
/// Then SPI1 asks the DMA for no more, as at the end of a transfer.
fn settle(_: &mut Bus) {
    while !SPI1.sr().read().txe() {}
    while SPI1.sr().read().bsy() {}
    SPI1.cr2().modify(|register| register.set_txdmaen(false));
}

/// Stops for ever; a debug probe sees where.
fn stop() -> ! {
    loop {
        cortex_m::asm::bkpt();
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    stop()
}
