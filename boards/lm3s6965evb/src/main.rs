//! zrow on the LM3S6965EVB: a Cortex-M3 draws the scenes of the OLED one row at a time and pushes each row over SPI.
//!
//! No frame buffer and no copy: a scene draws into one row of 128 bytes, which is packed in place to the 64 bytes that
//! the panel takes. The second scene draws in 256 greys, which are dithered in place to the panel's 16 before that.

#![no_std]
#![no_main]

mod gpio;
mod host;
mod registers;
mod ssd0323;
mod ssi;
mod stopwatch;

use core::convert::Infallible;
use cortex_m_semihosting::{debug, hprintln};
use embedded_graphics::{geometry::Dimensions, pixelcolor::Gray4};
use embedded_hal::digital::OutputPin;
use embedded_hal_bus::spi::{DeviceError, ExclusiveDevice, NoDelay};
use gpio::Output;
use host::Mode;
use registers::{ClockGate2, Peripherals};
use ssd0323::Ssd0323;
use ssi::Spi;
use stopwatch::Stopwatch;
use tock_registers::interfaces::ReadWriteable;
use zrow::band::{Band, Dithered, LittleEndian, LoopError, PictureLoop, Sink};
use zrow_scenes::{
    PrepareError, Prepared, Scene,
    oled::{AREA, FRAMES, Oled},
    oled_teapot::{OledTeapot, Turned},
};

type Panel = Ssd0323<ExclusiveDevice<Spi, Output, NoDelay>, Output>;
type PanelError = ssd0323::Error<DeviceError<Infallible, Infallible>, Infallible>;

/// Why the animation stopped.
#[derive(Debug)]
enum Failure {
    Scene(#[expect(dead_code, reason = "printed")] PrepareError),
    Picture(#[expect(dead_code, reason = "printed")] LoopError<PanelError>),
}

/// 25 frames a second, where somebody watches.
const TICKS_A_FRAME: u32 = 12_500_000 / 25;

#[cortex_m_rt::entry]
fn main() -> ! {
    let Some(core) = cortex_m::Peripherals::take() else {
        end(Err("the core's peripherals are taken"));
    };
    end(show(core))
}

fn show(mut core: cortex_m::Peripherals) -> Result<(), Failure> {
    let mut board = Board {
        panel: panel(&Peripherals::new(&mut core)),
        stopwatch: Stopwatch::new(core.SYST),
        mode: host::mode(),
    };
    board
        .panel
        .initialize()
        .map_err(|error| Failure::Picture(LoopError::Sink(error)))?;
    loop {
        show_oled(&mut board)?;
        show_teapot(&mut board)?;
        if board.mode != Mode::Loop {
            return Ok(());
        }
    }
}

/// The object and the gauge, drawn in the panel's 16 greys.
#[inline(never)]
fn show_oled(board: &mut Board) -> Result<(), Failure> {
    let mut scene = Oled::default();
    let mut animation = scene.animation().map_err(Failure::Scene)?;
    board.animate(Oled::NAME, |frame, row, mut sink| {
        let mut prepared = animation.prepare(frame).map_err(Failure::Scene)?;
        Oled::picture()
            .draw(row, &mut sink, |band| prepared.draw(band))
            .map_err(Failure::Picture)
    })
}

/// The teapot, drawn in 256 greys and dithered.
#[inline(never)]
fn show_teapot(board: &mut Board) -> Result<(), Failure> {
    let mut scene = OledTeapot::default();
    board.animate(OledTeapot::NAME, |frame, row, sink| {
        let mut prepared = scene.prepare(frame).map_err(Failure::Scene)?;
        PictureLoop::new(AREA, Turned::BACKGROUND)
            .draw(row, &mut Dithered::new(sink), |band| prepared.draw_undithered(band))
            .map_err(Failure::Picture)
    })
}

/// The panel, the time that a frame takes, and how the host wants the frames.
struct Board {
    panel: Panel,
    stopwatch: Stopwatch,
    mode: Mode,
}

impl Board {
    /// Shows each frame of a scene, drawn into the one row there is, and reports how long it took.
    fn animate(
        &mut self,
        scene: &str,
        mut show: impl FnMut(u32, &mut [u8], PanelSink<'_>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        for frame in 0..FRAMES {
            self.stopwatch.restart();
            let (mut row, mut sending) = ([0; ssd0323::WIDTH], 0);
            let sink = PanelSink {
                panel: &mut self.panel,
                stopwatch: &self.stopwatch,
                sending: &mut sending,
            };
            show(frame, &mut row, sink)?;
            hprintln!(
                "{} frame {}: {} ticks, {} of them to send",
                scene,
                frame,
                self.stopwatch.ticks(),
                sending
            );
            match self.mode {
                Mode::Once => {}
                Mode::Loop => while self.stopwatch.ticks() < TICKS_A_FRAME {},
                Mode::Step => host::wait_for_byte(),
            }
        }
        Ok(())
    }
}

/// Sends each row to the panel before the next one is drawn.
struct PanelSink<'a> {
    panel: &'a mut Panel,
    stopwatch: &'a Stopwatch,
    /// The ticks that sending has taken.
    sending: &'a mut u32,
}

impl Sink<Gray4, LittleEndian> for PanelSink<'_> {
    type Error = PanelError;

    fn send(&mut self, band: Band<'_, Gray4>) -> Result<(), PanelError> {
        let top = band.bounding_box().top_left.y;
        let packed = band.into_bytes();
        let begin = self.stopwatch.ticks();
        let sent = self.panel.write_rows(top, packed);
        *self.sending += self.stopwatch.ticks() - begin;
        sent
    }
}

/// Wires up the OLED: data/command on C7, select on A3, the bus on SSI0.
fn panel(peripherals: &Peripherals) -> Panel {
    let gates = ClockGate2::PORT_A::SET + ClockGate2::PORT_C::SET + ClockGate2::PORT_D::SET;
    peripherals.system_control.clock_gate2.modify(gates);
    // The SD card shares the bus and listens while its select is low; the OLED's supply hangs on C6.
    let Ok(()) = Output::new::<0>(peripherals.port_d).set_high();
    let Ok(()) = Output::new::<6>(peripherals.port_c).set_high();
    let data_not_command = Output::new::<7>(peripherals.port_c);
    let select = Output::new::<3>(peripherals.port_a);
    let Ok(device) = ExclusiveDevice::new_no_delay(Spi::new(peripherals), select);
    Ssd0323::new(device, data_not_command)
}

/// Ends the program, and QEMU with it.
fn end(result: Result<(), impl core::fmt::Debug>) -> ! {
    let status = match result {
        Ok(()) => debug::EXIT_SUCCESS,
        Err(error) => {
            hprintln!("failed: {:?}", error);
            debug::EXIT_FAILURE
        }
    };
    loop {
        debug::exit(status);
    }
}

#[panic_handler]
fn panic(information: &core::panic::PanicInfo) -> ! {
    hprintln!("{}", information);
    end(Err("panic"))
}
