//! The OLED driver of the LM3S6965EVB over a recording bus: exactly these bytes, with exactly these levels of the
//! data/command pin. The whole panel is compared by `cargo run --release -- emulate`.

#[path = "../../../boards/lm3s6965evb/src/ssd0323.rs"]
mod ssd0323;

use embedded_hal::{
    digital::{self, OutputPin},
    spi::{self, Operation, SpiDevice},
};
use ssd0323::{Error, Ssd0323};
use std::{cell::RefCell, convert::Infallible};

/// What the panel saw: each byte, and whether it was data.
#[derive(Default)]
struct Wires {
    data: bool,
    bytes: Vec<(bool, u8)>,
    broken: bool,
}

struct Bus<'a>(&'a RefCell<Wires>);

impl spi::ErrorType for Bus<'_> {
    type Error = spi::ErrorKind;
}

impl SpiDevice for Bus<'_> {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), spi::ErrorKind> {
        let mut wires = self.0.borrow_mut();
        if wires.broken {
            return Err(spi::ErrorKind::Other);
        }
        for operation in operations {
            let Operation::Write(bytes) = operation else {
                panic!("the panel cannot be read")
            };
            let data = wires.data;
            wires.bytes.extend(bytes.iter().map(|&byte| (data, byte)));
        }
        Ok(())
    }
}

struct Pin<'a>(&'a RefCell<Wires>);

impl digital::ErrorType for Pin<'_> {
    type Error = Infallible;
}

impl OutputPin for Pin<'_> {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().data = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().data = true;
        Ok(())
    }
}

fn commands(bytes: &[u8]) -> Vec<(bool, u8)> {
    bytes.iter().map(|&byte| (false, byte)).collect()
}

fn data(bytes: &[u8]) -> Vec<(bool, u8)> {
    bytes.iter().map(|&byte| (true, byte)).collect()
}

#[test]
fn rows_are_a_window_and_their_bytes() {
    let wires = RefCell::new(Wires::default());
    let mut panel = Ssd0323::new(Bus(&wires), Pin(&wires));
    let packed: Vec<u8> = (0..128).collect();
    panel.write_rows(62, &packed).unwrap();
    let expected = [commands(&[0x75, 62, 63, 0x15, 0, 63]), data(&packed)].concat();
    assert_eq!(wires.take().bytes, expected);
}

#[test]
fn rows_outside_the_panel_are_refused_before_anything_is_sent() {
    let wires = RefCell::new(Wires::default());
    let mut panel = Ssd0323::new(Bus(&wires), Pin(&wires));
    for (first, bytes) in [
        (-1, 64),
        (64, 64),
        (63, 128),
        (0, 63),
        (0, 65),
        (0, 65 * 64),
        (i32::MIN, 64),
        (i32::MAX, 64),
    ] {
        assert_eq!(
            panel.write_rows(first, &vec![0; bytes]),
            Err(Error::OutsidePanel),
            "{first}, {bytes}"
        );
    }
    assert_eq!(panel.write_rows(0, &[]), Ok(()));
    assert!(wires.take().bytes.is_empty());
}

#[test]
fn the_panel_is_black_before_it_is_switched_on() {
    let wires = RefCell::new(Wires::default());
    Ssd0323::new(Bus(&wires), Pin(&wires)).initialize().unwrap();
    let bytes = wires.take().bytes;
    assert_eq!(bytes.first(), Some(&(false, 0xae)));
    assert_eq!(bytes.last(), Some(&(false, 0xaf)));
    assert_eq!(
        bytes.iter().filter(|&&(is_data, _)| is_data).collect::<Vec<_>>(),
        vec![&(true, 0); 64 * 64]
    );
}

#[test]
fn a_broken_bus_is_reported() {
    let wires = RefCell::new(Wires {
        broken: true,
        ..Wires::default()
    });
    let mut panel = Ssd0323::new(Bus(&wires), Pin(&wires));
    assert_eq!(panel.write_rows(0, &[0; 64]), Err(Error::Spi(spi::ErrorKind::Other)));
}
