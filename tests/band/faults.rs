//! Faults on the way to a panel, at every byte of a frame: buffers come back, the next frame is whole, and nothing hangs.

use std::{
    cell::RefCell,
    future::Future,
    pin::{Pin, pin},
    rc::Rc,
    task::{Context, Poll, Waker},
};

use embedded_graphics::{
    pixelcolor::{Rgb565, raw::ToBytes},
    prelude::*,
    primitives::Rectangle,
};
use embedded_hal::{
    digital::{self, OutputPin},
    spi::{self, Operation, SpiDevice},
};
use mipidsi::{Builder, interface::SpiInterface, models::ILI9341Rgb565};
use zrow::band::{BigEndian, DisplaySink, LittleEndian, LoopError, OverlappingSink, PictureLoop};

use crate::{
    mipidsi::NoDelay,
    picture_loop::{full_frame, scene},
};

/// Two bands of two rows and one of one: 143 bytes with the commands of their windows.
const AREA: Rectangle = Rectangle::new(Point::new(0, 0), Size::new(11, 5));
const WORDS: usize = 2 * 11;
const BAND_COMMANDS: usize = 11;
const FRAME_BYTES: usize = 3 * BAND_COMMANDS + 2 * 5 * 11;

fn picture_loop<O: zrow::band::Order>() -> PictureLoop<Rgb565, O> {
    PictureLoop::new(AREA, Rgb565::BLUE).rows(2).in_order()
}

/// The wires broke.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Unplugged;

impl spi::Error for Unplugged {
    fn kind(&self) -> spi::ErrorKind {
        spi::ErrorKind::Other
    }
}

impl digital::Error for Unplugged {
    fn kind(&self) -> digital::ErrorKind {
        digital::ErrorKind::Other
    }
}

/// A panel of 11 x 5 pixels as the ILI9341 is: a command byte ends whatever was before it.
#[derive(Debug)]
struct Panel {
    memory: [[u8; 2 * 11]; 5],
    columns: [usize; 2],
    rows: [usize; 2],
    command: u8,
    data: Vec<u8>,
}

impl Default for Panel {
    /// After a reset: noise, a window of one pixel, no command.
    fn default() -> Self {
        Self {
            memory: [[0x5a; 22]; 5],
            columns: [0; 2],
            rows: [0; 2],
            command: 0,
            data: Vec::new(),
        }
    }
}

impl Panel {
    fn take(&mut self, is_data: bool, byte: u8) {
        if !is_data {
            (self.command, self.data) = (byte, Vec::new());
            return;
        }
        self.data.push(byte);
        match (self.command, &self.data[..]) {
            (0x2a, &[0, first, 0, last]) => self.columns = [first, last].map(usize::from),
            (0x2b, &[0, first, 0, last]) => self.rows = [first, last].map(usize::from),
            (0x2c, data) => {
                let width = 2 * (self.columns[1] + 1 - self.columns[0]);
                let index = data.len() - 1;
                let (row, column) = (self.rows[0] + index / width, 2 * self.columns[0] + index % width);
                if row <= self.rows[1] {
                    self.memory[row][column] = byte;
                }
            }
            _ => {}
        }
    }

    fn shows_the_picture(&self) -> bool {
        let picture = full_frame::<Rgb565, LittleEndian>(AREA);
        self.memory.concat()
            == picture
                .iter()
                .flat_map(|color| color.to_be_bytes())
                .collect::<Vec<u8>>()
    }
}

/// The wires to a panel; they break once, before a byte.
#[derive(Debug, Default)]
struct Wires {
    panel: Panel,
    is_data: bool,
    sent: usize,
    fails_at: Option<usize>,
    resets_at: Option<usize>,
    transfers: usize,
}

impl Wires {
    fn send_byte(&mut self, is_data: bool, byte: u8) -> Result<(), Unplugged> {
        if self.fails_at == Some(self.sent) {
            self.fails_at = None;
            return Err(Unplugged);
        }
        if self.resets_at == Some(self.sent) {
            self.panel = Panel::default();
        }
        self.sent += 1;
        self.panel.take(is_data, byte);
        Ok(())
    }

    fn send(&mut self, is_data: bool, bytes: &[u8]) -> Result<(), Unplugged> {
        bytes.iter().try_for_each(|&byte| self.send_byte(is_data, byte))
    }

    fn set_window(&mut self, area: Rectangle) -> Result<(), Unplugged> {
        let ranges = [(0x2a, area.columns()), (0x2b, area.rows())];
        for (command, range) in ranges {
            self.send(false, &[command])?;
            self.send(true, &[0, range.start as u8, 0, range.end as u8 - 1])?;
        }
        self.send(false, &[0x2c])
    }
}

#[derive(Debug, Clone, Default)]
struct Shared(Rc<RefCell<Wires>>);

impl Shared {
    fn failing_at(byte: usize) -> Self {
        let shared = Self::default();
        shared.0.borrow_mut().fails_at = Some(byte);
        shared
    }

    fn sent(&self) -> usize {
        self.0.borrow().sent
    }

    fn shows_the_picture(&self) -> bool {
        self.0.borrow().panel.shows_the_picture()
    }
}

impl spi::ErrorType for Shared {
    type Error = Unplugged;
}

impl SpiDevice for Shared {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Unplugged> {
        let wires = &mut *self.0.borrow_mut();
        operations.iter().try_for_each(|operation| match operation {
            Operation::Write(bytes) => wires.send(wires.is_data, bytes),
            _ => panic!("the panel is only written to"),
        })
    }
}

impl digital::ErrorType for Shared {
    type Error = Unplugged;
}

impl OutputPin for Shared {
    fn set_low(&mut self) -> Result<(), Unplugged> {
        self.0.borrow_mut().is_data = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Unplugged> {
        self.0.borrow_mut().is_data = true;
        Ok(())
    }
}

/// Draws two frames by mipidsi, of which the first one has a fault, and checks the second one.
fn check_driver(fault: impl FnOnce(&mut Wires), fails: bool) {
    let shared = Shared::default();
    let mut buffer = [0; 8];
    let interface = SpiInterface::new(shared.clone(), shared.clone(), &mut buffer);
    let mut display = Builder::new(ILI9341Rgb565, interface)
        .display_size(11, 5)
        .init(&mut NoDelay)
        .unwrap();
    let mut words = [0; WORDS];
    let mut draw = || {
        picture_loop().draw(
            &mut words,
            &mut DisplaySink(&mut display),
            scene::<Rgb565, LittleEndian>,
        )
    };
    shared.0.borrow_mut().sent = 0;
    fault(&mut shared.0.borrow_mut());
    assert_eq!(draw().is_err(), fails);
    shared.0.borrow_mut().resets_at = None;
    draw().unwrap();
    assert!(shared.shows_the_picture());
}

#[test]
fn a_driver_whose_wires_break_at_any_byte_shows_the_next_frame_whole() {
    for byte in 0..FRAME_BYTES {
        check_driver(|wires| wires.fails_at = Some(byte), true);
    }
}

#[test]
fn a_panel_that_is_reset_at_any_byte_shows_the_next_frame_whole() {
    for byte in 0..FRAME_BYTES {
        check_driver(|wires| wires.resets_at = Some(byte), false);
    }
}

/// How a transfer by DMA ends that does not get to its last byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    /// An error says so.
    Error,
    /// No one notices.
    Early,
}

/// DMA that takes what it can get at the end of the transfer.
struct Dma {
    shared: Shared,
    end: End,
}

/// A buffer that can be told from another one.
struct Named(char, [u16; WORDS]);

impl AsMut<[u16]> for Named {
    fn as_mut(&mut self) -> &mut [u16] {
        &mut self.1
    }
}

impl OverlappingSink<Rgb565, BigEndian, Named> for Dma {
    type Transfer = (Rectangle, Named);
    type Error = Unplugged;

    fn start(&mut self, area: Rectangle, buffer: Named) -> Result<Self::Transfer, (Named, LoopError<Unplugged>)> {
        let wires = &mut *self.shared.0.borrow_mut();
        if let Err(error) = wires.set_window(area) {
            return Err((buffer, LoopError::Sink(error)));
        }
        wires.transfers += 1;
        Ok((area, buffer))
    }

    fn finish(&mut self, (area, buffer): Self::Transfer) -> (Named, Result<(), Unplugged>) {
        let wires = &mut *self.shared.0.borrow_mut();
        wires.transfers -= 1;
        let words = (area.size.width * area.size.height) as usize;
        let sent = wires.send(true, bytemuck::cast_slice(&buffer.1[..words]));
        (buffer, if self.end == End::Early { Ok(()) } else { sent })
    }
}

#[test]
fn dma_that_ends_at_any_byte_gives_both_buffers_back() {
    for (byte, end) in (0..FRAME_BYTES).flat_map(|byte| [(byte, End::Error), (byte, End::Early)]) {
        let mut dma = Dma {
            shared: Shared::failing_at(byte),
            end,
        };
        let buffers = ['a', 'b'].map(|name| Named(name, [0x1234; WORDS]));
        let (buffers, result) = picture_loop().draw_overlapping(buffers, &mut dma, scene::<Rgb565, BigEndian>);
        if end == End::Error {
            assert_eq!(result, Err(LoopError::Sink(Unplugged)));
            assert_eq!(dma.shared.sent(), byte, "nothing is sent after the failure");
        }
        assert_eq!(dma.shared.0.borrow().transfers, 0, "no transfer is under way");
        let mut names = buffers.each_ref().map(|buffer| buffer.0);
        names.sort();
        assert_eq!(names, ['a', 'b']);
        let (_, result) = picture_loop().draw_overlapping(buffers, &mut dma, scene::<Rgb565, BigEndian>);
        assert_eq!(result, Ok(()));
        assert!(dma.shared.shows_the_picture(), "byte {byte}, {end:?}");
    }
}

/// A transfer that sends a byte with each poll, and stops when it is dropped.
struct ByteByByte<'a> {
    shared: Shared,
    bytes: &'a [u8],
}

impl<'a> ByteByByte<'a> {
    fn start(shared: Shared, bytes: &'a [u8]) -> Self {
        shared.0.borrow_mut().transfers += 1;
        Self { shared, bytes }
    }
}

impl Drop for ByteByByte<'_> {
    fn drop(&mut self) {
        self.shared.0.borrow_mut().transfers -= 1;
    }
}

impl Future for ByteByByte<'_> {
    type Output = Result<(), Unplugged>;

    fn poll(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Self::Output> {
        let Some((&byte, rest)) = self.bytes.split_first() else {
            return Poll::Ready(Ok(()));
        };
        self.shared.0.borrow_mut().send_byte(true, byte)?;
        self.bytes = rest;
        context.waker().wake_by_ref();
        Poll::Pending
    }
}

/// Draws asynchronously with at most so many polls. `None` where the future was dropped before its end.
fn draw_async(
    shared: &Shared,
    [one, other]: [&mut [u16]; 2],
    polls: usize,
) -> Option<Result<(), LoopError<Unplugged>>> {
    let send = async |area: Rectangle, bytes: &[u8]| {
        shared.0.borrow_mut().set_window(area)?;
        ByteByByte::start(shared.clone(), bytes).await
    };
    let picture_loop = picture_loop();
    let mut drawing = pin!(picture_loop.draw_async([one, other], send, scene::<Rgb565, BigEndian>));
    let mut context = Context::from_waker(Waker::noop());
    (0..polls).find_map(|_| match drawing.as_mut().poll(&mut context) {
        Poll::Ready(result) => Some(result),
        Poll::Pending => None,
    })
}

#[test]
fn a_future_that_fails_at_any_byte_leaves_its_buffers_usable() {
    let (mut one, mut other) = ([0x1234; WORDS], [0x1234; WORDS]);
    for byte in 0..FRAME_BYTES {
        let shared = Shared::failing_at(byte);
        let drawn = draw_async(&shared, [&mut one, &mut other], 2 * FRAME_BYTES);
        assert_eq!(drawn, Some(Err(LoopError::Sink(Unplugged))));
        assert_eq!((shared.sent(), shared.0.borrow().transfers), (byte, 0));
        let drawn = draw_async(&shared, [&mut one, &mut other], 2 * FRAME_BYTES);
        assert_eq!(drawn, Some(Ok(())), "it has come to its end");
        assert!(shared.shows_the_picture());
    }
}

#[test]
fn a_future_that_is_dropped_at_any_poll_leaves_its_buffers_usable() {
    let (mut one, mut other) = ([0x1234; WORDS], [0x1234; WORDS]);
    let mut ends = 0;
    for polls in 0..2 * FRAME_BYTES {
        let shared = Shared::default();
        let drawn = draw_async(&shared, [&mut one, &mut other], polls);
        ends += usize::from(drawn.is_some());
        assert!(matches!(drawn, None | Some(Ok(()))));
        assert_eq!(shared.0.borrow().transfers, 0, "its transfer is dropped with it");
        let sent = shared.sent();
        assert!(drawn.is_none() || sent == FRAME_BYTES && shared.shows_the_picture());
        let drawn = draw_async(&shared, [&mut one, &mut other], 2 * FRAME_BYTES);
        assert_eq!(drawn, Some(Ok(())));
        assert!(shared.shows_the_picture());
        assert_eq!(shared.sent(), sent + FRAME_BYTES);
    }
    assert!(ends > 0);
}
