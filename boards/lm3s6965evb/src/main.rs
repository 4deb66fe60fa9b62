//! zrow on the LM3S6965EVB: a Cortex-M3 draws the OLED scene one row at a time and pushes each row over SPI.

#![no_std]
#![no_main]

mod gpio;
mod host;
mod registers;
mod ssd0323;
mod ssi;

use cortex_m_semihosting::{debug, hprintln};
use embedded_graphics::primitives::Rectangle;
use embedded_hal::{digital::OutputPin, spi::SpiDevice};
use embedded_hal_bus::spi::ExclusiveDevice;
use host::Mode;
use registers::{ClockGate2, Peripherals};
use ssd0323::Ssd0323;
use tock_registers::interfaces::ReadWriteable;
use zrow::{band::BytesSink, target::Native};
use zrow_scenes::oled::{self, Oled};

#[cortex_m_rt::entry]
fn main() -> ! {
    let mode = host::mode();
    let status = match cortex_m::Peripherals::take().map(|core| show(core, mode)) {
        Some(Ok(())) => debug::EXIT_SUCCESS,
        _ => debug::EXIT_FAILURE,
    };
    loop {
        debug::exit(status);
    }
}

fn show(mut core: cortex_m::Peripherals, mode: Mode) -> Result<(), ()> {
    let peripherals = Peripherals::new(&mut core);
    peripherals
        .system_control
        .clock_gate2
        .modify(ClockGate2::PORT_A::SET + ClockGate2::PORT_C::SET + ClockGate2::PORT_D::SET);
    // The SD card shares the bus and listens while its select is low; the OLED's supply hangs on C6.
    gpio::Output::new::<0>(peripherals.port_d).set_high().map_err(|_| ())?;
    gpio::Output::new::<6>(peripherals.port_c).set_high().map_err(|_| ())?;
    let data_not_command = gpio::Output::new::<7>(peripherals.port_c);
    let select = gpio::Output::new::<3>(peripherals.port_a);
    let device = ExclusiveDevice::new_no_delay(ssi::Spi::new(&peripherals), select).map_err(|_| ())?;
    let mut panel = Ssd0323::new(device, data_not_command);
    panel.initialize().map_err(|_| ())?;
    show_frames(&mut panel, mode)
}

/// Draws every row of every frame into the one row there is, and sends it before the next.
fn show_frames<Spi: SpiDevice, Pin: OutputPin>(panel: &mut Ssd0323<Spi, Pin>, mode: Mode) -> Result<(), ()> {
    let picture = Oled::picture();
    let mut scene = Oled::default();
    let mut row = [0_u8; ssd0323::WIDTH];
    for frame in 0..oled::FRAMES {
        scene.prepare(frame);
        let mut sink = BytesSink(|area: Rectangle, packed: &[u8]| panel.write_rows(area.top_left.y, packed));
        picture
            .draw::<Native, _, _>(&mut row, &mut sink, |band| scene.draw(band))
            .map_err(|_| ())?;
        hprintln!("frame {}", frame);
        if mode == Mode::Step {
            host::wait_for_byte();
        }
    }
    Ok(())
}

#[panic_handler]
fn panic(information: &core::panic::PanicInfo) -> ! {
    hprintln!("{}", information);
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}
