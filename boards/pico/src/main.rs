//! zrow on the Raspberry Pi Pico: draws a gauge, an antialiased instrument panel and a lit and textured teapot on an ST7789, one
//! row while the row before it is on its way to the display by DMA.
//!
//! There is no frame buffer: two rows of 480 bytes take turns. What a frame takes is reported over UART0, in core cycles that
//! SysTick counts.

#![no_std]
#![no_main]

mod panel;
mod stopwatch;

use core::{convert::Infallible, fmt::Write};

use cortex_m::{asm, singleton};
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use embedded_hal::{
    digital::{InputPin, OutputPin},
    spi::MODE_0,
};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::{Builder, interface::SpiInterface, models::ST7789, options::ColorInversion};
use panel::{Cycles, HEIGHT, Panel, WIDTH};
use rp2040_hal::{
    Sio, Spi, Timer, Watchdog,
    clocks::{Clock, init_clocks_and_plls},
    dma::{CH0, Channel, DMAExt},
    fugit::RateExtU32,
    gpio::{FunctionSio, FunctionSpi, FunctionUart, Pin, PinState, Pins, PullDown, PullUp, SioInput, SioOutput, bank0},
    pac, spi,
    uart::{self, UartConfig, UartPeripheral},
};
use stopwatch::Moment;
use zrow::band::{Band, LoopError, PictureLoop};
use zrow_scenes::{PrepareError, Prepared, Scene, instruments::Instruments, needle::Needle, teapots::TexturedTeapot};

/// The program that the boot ROM copies into RAM and runs first. It sets up the flash chip of the Pico.
// SAFETY: the linker script puts the section where the boot ROM looks for it, and nothing else into it.
#[unsafe(link_section = ".boot2")]
#[unsafe(no_mangle)]
pub static SECOND_STAGE: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// The crystal of the Pico.
const CRYSTAL_HZ: u32 = 12_000_000;
/// The fastest that the ST7789 takes: a bit in 16 ns.
const BUS_HZ: u32 = 62_500_000;
/// Words of a band: one row. What the heights of all pictures can be divided by would do as well.
const ROWS: u32 = 1;
const WORDS: usize = (WIDTH * ROWS) as usize;
/// Frames of a scene before the next one follows.
const FRAMES: u32 = 64;
/// Turns of the loop that is counted at the start.
const LOOP: u32 = 10_000;

/// A pin with a function of a peripheral.
type Wire<I, F> = Pin<I, F, PullDown>;
type Output<I> = Wire<I, FunctionSio<SioOutput>>;
type Bus = Spi<spi::Enabled, pac::SPI0, (Wire<bank0::Gpio19, FunctionSpi>, Wire<bank0::Gpio18, FunctionSpi>), 16>;
type DmaPanel = Panel<Channel<CH0>, Bus, Output<bank0::Gpio16>>;
type Serial = (Wire<bank0::Gpio0, FunctionUart>, Wire<bank0::Gpio1, FunctionUart>);
type Report = UartPeripheral<uart::Enabled, pac::UART0, Serial>;
/// Two rows that take turns.
type Rows = [&'static mut [u16; WORDS]; 2];

/// What came of a picture.
type Drawn = Result<(), LoopError<panel::Error>>;

#[rp2040_hal::entry]
fn main() -> ! {
    let (Some(core), Some(chip)) = (pac::CorePeripherals::take(), pac::Peripherals::take()) else {
        stop();
    };
    let Some((mut board, rows)) = Board::new(core, chip) else {
        stop();
    };
    let begin = Moment::now();
    asm::delay(LOOP - 1);
    let cycles = begin.elapsed();
    let _ = writeln!(board.report, "loop of {LOOP} turns: {cycles} cycles");
    let Err(failure) = board.show_scenes(rows);
    let _ = writeln!(board.report, "failed: {failure:?}");
    stop()
}

/// The panel, what a frame takes is reported to, and the button that goes on to the next scene.
struct Board {
    panel: DmaPanel,
    backlight: Output<bank0::Gpio20>,
    report: Report,
    button: Pin<bank0::Gpio12, FunctionSio<SioInput>, PullUp>,
}

impl Board {
    /// Wires up the board and switches the panel on; the second value is the memory of the rows. `None` where that fails.
    fn new(mut core: pac::CorePeripherals, mut chip: pac::Peripherals) -> Option<(Self, Rows)> {
        let resets = &mut chip.RESETS;
        let mut watchdog = Watchdog::new(chip.WATCHDOG);
        let clocks = init_clocks_and_plls(
            CRYSTAL_HZ,
            chip.XOSC,
            chip.CLOCKS,
            chip.PLL_SYS,
            chip.PLL_USB,
            resets,
            &mut watchdog,
        )
        .ok()?;
        stopwatch::start(&mut core.SYST);
        let peripherals_hz = clocks.peripheral_clock.freq();
        let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, Sio::new(chip.SIO).gpio_bank0, resets);
        let serial = (pins.gpio0.into_function(), pins.gpio1.into_function());
        let report = UartPeripheral::new(chip.UART0, serial, resets)
            .enable(UartConfig::default(), peripherals_hz)
            .ok()?;

        let mut data_not_command = pins.gpio16.into_push_pull_output();
        let mut select = pins.gpio17.into_push_pull_output_in_state(PinState::High);
        let wires = (pins.gpio19.into_function(), pins.gpio18.into_function());
        let mut bytes = Spi::<_, _, _, 8>::new(chip.SPI0, wires).init(resets, peripherals_hz, BUS_HZ.Hz(), MODE_0);
        // mipidsi switches the panel on, over a bus of bytes and pins that it only borrows.
        let device = ExclusiveDevice::new_no_delay(&mut bytes, &mut select).ok()?;
        Builder::new(ST7789, SpiInterface::new(device, &mut data_not_command, &mut [0; 16]))
            .reset_pin(pins.gpio21.into_push_pull_output())
            .display_size(WIDTH as u16, HEIGHT as u16)
            .invert_colors(ColorInversion::Inverted)
            .init(&mut Timer::new(chip.TIMER, resets, &clocks))
            .ok()?;
        let (spi, wires) = bytes.free();
        let words = Spi::<_, _, _, 16>::new(spi, wires).init(resets, peripherals_hz, BUS_HZ.Hz(), MODE_0);
        let Ok(()) = select.set_low();
        let board = Self {
            panel: Panel::new(chip.DMA.split(resets).ch0, words, data_not_command),
            backlight: pins.gpio20.into_push_pull_output(),
            report,
            button: pins.gpio12.into_pull_up_input(),
        };
        let one = singleton!(ROW: [u16; WORDS] = [0; WORDS])?;
        let other = singleton!(OTHER_ROW: [u16; WORDS] = [0; WORDS])?;
        Some((board, [one, other]))
    }

    /// Shows one scene after the other, for ever.
    fn show_scenes(&mut self, mut rows: Rows) -> Result<Infallible, PrepareError> {
        loop {
            rows = self.show::<Needle>(rows)?;
            rows = self.show::<Instruments>(rows)?;
            rows = self.show::<TexturedTeapot>(rows)?;
        }
    }

    /// Shows the frames of a scene until the last one, or until one at whose end the button is held down. A frame that could not be
    /// sent is lost, and the next one is drawn.
    #[inline(never)]
    fn show<S: Scene<Color = Rgb565>>(&mut self, rows: Rows) -> Result<Rows, PrepareError> {
        let mut rows = self.clear(rows);
        let Ok(()) = self.backlight.set_high();
        let mut scene = S::default();
        for frame in 0..FRAMES {
            let begin = Moment::now();
            let mut prepared = scene.prepare(frame)?;
            let ready = Moment::now();
            let drawn;
            (rows, drawn) = self.draw(&S::picture(), rows, |band| prepared.draw(band));
            let total = ready.elapsed();
            let sent = self.panel.end_picture();
            let cycles = FrameCycles {
                preparing: begin.cycles_to(ready),
                drawing: total - sent.sending - sent.waiting,
                sent,
            };
            let _ = match drawn {
                Ok(()) => writeln!(self.report, "{} frame {frame}: {cycles}", S::NAME),
                Err(error) => writeln!(self.report, "{} frame {frame}: lost, {error:?}", S::NAME),
            };
            if self.button.is_low() == Ok(true) {
                break;
            }
        }
        Ok(rows)
    }

    /// Makes the whole panel black.
    fn clear(&mut self, rows: Rows) -> Rows {
        let whole = Rectangle::new(Point::zero(), Size::new(WIDTH, HEIGHT));
        let (rows, drawn) = self.draw(&PictureLoop::new(whole, Rgb565::BLACK), rows, |_| {});
        self.panel.end_picture();
        if let Err(error) = drawn {
            let _ = writeln!(self.report, "not black: {error:?}");
        }
        rows
    }

    /// Draws a picture, each band while the one before it is sent.
    fn draw(
        &mut self,
        picture_loop: &PictureLoop<Rgb565>,
        rows: Rows,
        scene: impl FnMut(&mut Band<'_, Rgb565>),
    ) -> (Rows, Drawn) {
        picture_loop.rows(ROWS).draw_overlapping(rows, &mut self.panel, scene)
    }
}

/// Core cycles that a frame takes.
struct FrameCycles {
    preparing: u32,
    /// All of the loop over the rows but for what sending takes.
    drawing: u32,
    sent: Cycles,
}

impl core::fmt::Display for FrameCycles {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self {
            preparing,
            drawing,
            sent,
        } = self;
        write!(
            formatter,
            "{preparing} cycles to prepare, {drawing} to draw, {} to send, {} waiting",
            sent.sending, sent.waiting
        )
    }
}

/// Stops for ever; a debug probe sees where.
fn stop() -> ! {
    loop {
        asm::bkpt();
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    stop()
}
