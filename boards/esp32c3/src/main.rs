//! zrow on the ESP32-C3-DevKitM-1: draws an antialiased instrument panel and a lit and textured teapot on an ST7789, with embassy: a
//! band is a future that the DMA fulfils, while the next band is drawn.
//!
//! The counters of each frame are printed on the serial line that the USB socket of the board leads to.

#![no_std]
#![no_main]

use embassy_time::Delay;
use esp_hal::{
    Async,
    clock::CpuClock,
    delay,
    gpio::{Level, Output, OutputConfig},
    peripherals::Peripherals,
    spi::{
        Mode,
        master::{Config, Spi, SpiDma},
    },
    time::Rate,
    timer::timg::TimerGroup,
};
use esp_println::println;
use static_cell::ConstStaticCell;
use zrow_async_st7789::{Panel, Pins, WIDTH, show_scenes};

esp_bootloader_esp_idf::esp_app_desc!();

/// The bus of the panel.
type Bus = SpiDma<'static, Async>;

/// Half of the clock of SPI2: the ST7789 takes no more than 62.5 MHz.
const BUS_CLOCK: Rate = Rate::from_mhz(40);
/// The fewest bytes that are sent by DMA. The core puts fewer into the FIFO of 64 bytes: they are commands, which may be constants in
/// flash, where the DMA cannot read.
const SHORTEST_DMA: usize = 65;
/// Words of a band: four rows.
const WORDS: usize = 4 * WIDTH as usize;

/// Two bands that take turns.
static BANDS: ConstStaticCell<[[u16; WORDS]; 2]> = ConstStaticCell::new([[0; WORDS]; 2]);

#[esp_rtos::main]
async fn main(_spawner: embassy_executor::Spawner) {
    let chip = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));
    let Some((bus, pins)) = wires(chip) else {
        stop("the bus has no such clock");
    };
    let Ok(mut panel) = Panel::start(bus, settle, pins, &mut Delay) else {
        stop("the panel does not start");
    };
    let bands = BANDS.take().each_mut().map(|band| &mut band[..]);
    let Err(failure) = show_scenes(&mut panel, bands, |frame| println!("{frame:?}")).await;
    stop(failure)
}

/// Starts the timer of embassy; the bus, and the pins of the panel. The pins of the bus are those that need no matrix.
fn wires(chip: Peripherals) -> Option<(Bus, Pins<Output<'static>>)> {
    esp_rtos::start(TimerGroup::new(chip.TIMG0).timer0, chip.FROM_CPU_INTR0);
    let config = Config::default()
        .with_frequency(BUS_CLOCK)
        .with_mode(Mode::_0)
        .with_min_async_transfer_size(SHORTEST_DMA);
    let bus = Spi::new(chip.SPI2, config)
        .ok()?
        .with_sck(chip.GPIO6)
        .with_mosi(chip.GPIO7)
        .with_dma(chip.DMA_CH0)
        .into_async();
    let pins = Pins {
        data_not_command: Output::new(chip.GPIO4, Level::High, OutputConfig::default()),
        select: Output::new(chip.GPIO10, Level::High, OutputConfig::default()),
        reset: Output::new(chip.GPIO5, Level::High, OutputConfig::default()),
        backlight: Output::new(chip.GPIO3, Level::Low, OutputConfig::default()),
    };
    Some((bus, pins))
}

/// Waits until the bus is idle after the future of a transfer was dropped: the HAL stops the DMA, and has SPI2 stop after the byte that
/// it sends, which takes 0.2 us more. The clock counts whole microseconds; of two, at least one passes.
fn settle(_: &mut Bus) {
    delay::Delay::new().delay_micros(2);
}

/// Says why, and stops for ever.
fn stop(reason: impl core::fmt::Debug) -> ! {
    println!("stopped: {reason:?}");
    loop {
        core::hint::spin_loop();
    }
}

#[panic_handler]
fn panic(information: &core::panic::PanicInfo) -> ! {
    stop(information)
}
