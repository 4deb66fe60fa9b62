//! zrow on the LM3S6965EVB: a Cortex-M3 draws the OLED scene one row at a time and pushes each row over SPI.
//!
//! No frame buffer and no copy: the scene draws into one row of 128 bytes, which is packed in place to the 64 bytes that
//! the panel takes.

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
use embedded_graphics::primitives::Rectangle;
use embedded_hal::digital::OutputPin;
use embedded_hal_bus::spi::{DeviceError, ExclusiveDevice, NoDelay};
use gpio::Output;
use host::Mode;
use registers::{ClockGate2, Peripherals};
use ssd0323::Ssd0323;
use ssi::Spi;
use stopwatch::Stopwatch;
use tock_registers::interfaces::ReadWriteable;
use zrow::band::{BytesSink, LoopError};
use zrow_scenes::{
    PrepareError, Prepared, Scene,
    oled::{self, Animation, Oled},
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
    let mut panel = panel(&Peripherals::new(&mut core));
    panel
        .initialize()
        .map_err(|error| Failure::Picture(LoopError::Sink(error)))?;
    let mut stopwatch = Stopwatch::new(core.SYST);
    let mut scene = Oled::default();
    let mut animation = scene.animation().map_err(Failure::Scene)?;
    let mode = host::mode();
    let frames = if mode == Mode::Loop { u32::MAX } else { oled::FRAMES };
    for frame in 0..frames {
        stopwatch.restart();
        let sending = show_frame(&mut panel, &mut animation, frame, &stopwatch)?;
        hprintln!(
            "frame {}: {} ticks, {} of them to send",
            frame,
            stopwatch.ticks(),
            sending
        );
        match mode {
            Mode::Once => {}
            Mode::Loop => while stopwatch.ticks() < TICKS_A_FRAME {},
            Mode::Step => host::wait_for_byte(),
        }
    }
    Ok(())
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

/// Draws each row of a frame into the one row there is, and sends it before the next. Returns the ticks that sending took.
fn show_frame(
    panel: &mut Panel,
    animation: &mut Animation<'_>,
    frame: u32,
    stopwatch: &Stopwatch,
) -> Result<u32, Failure> {
    let (mut row, mut sending) = ([0; ssd0323::WIDTH], 0);
    let mut sink = BytesSink(|area: Rectangle, packed: &[u8]| {
        let begin = stopwatch.ticks();
        let sent = panel.write_rows(area.top_left.y, packed);
        sending += stopwatch.ticks() - begin;
        sent
    });
    let mut prepared = animation.prepare(frame).map_err(Failure::Scene)?;
    Oled::picture()
        .draw(&mut row, &mut sink, |band| prepared.draw(band))
        .map_err(Failure::Picture)?;
    Ok(sending)
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
