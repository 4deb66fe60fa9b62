//! zrow on the LM3S6965EVB: a Cortex-M3 draws the OLED scene one row at a time and pushes each row over SPI.

#![no_std]
#![no_main]

mod gpio;
mod host;
mod registers;
mod ssd0323;
mod ssi;

use cortex_m_semihosting::{debug, hprintln};
use embedded_hal::digital::OutputPin;
use embedded_hal_bus::spi::ExclusiveDevice;
use host::Mode;
use registers::{ClockGate2, Peripherals};
use tock_registers::interfaces::ReadWriteable;

/// Frames of one turn of the animation.
const FRAMES: u32 = 64;

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
    let mut panel = ssd0323::Ssd0323::new(device, data_not_command);
    panel.initialize().map_err(|_| ())?;
    for frame in 0..FRAMES {
        for y in 0..64 {
            let mut row = [0u8; 128];
            for (x, p) in row.iter_mut().enumerate() {
                *p = if x % 16 == y % 16 || y == 0 || x == 0 { 15 } else { (x as u8 / 8).wrapping_add(frame as u8) & 15 };
            }
            let mut packed = [0u8; 64];
            ssd0323::pack(&row, &mut packed);
            panel.write_rows(y, &packed).map_err(|_| ())?;
        }
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
