//! The bytes that the panel sends, decoded as an ST7789 does, against the pictures of the scenes, pixel by pixel; and that a band is
//! on its way while the next one is drawn.

#[path = "../../../tools/emulate/src/pico/st7789.rs"]
mod st7789;

use std::{
    cell::RefCell,
    convert::Infallible,
    future::{Future, poll_fn},
    pin::pin,
    rc::Rc,
    task::{Context, Poll, Waker},
};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use embedded_hal::{delay::DelayNs, digital::OutputPin, spi};
use st7789::St7789;
use zrow::{
    band::{Band, PictureLoop},
    geometry::Window,
};
use zrow_async_st7789::{Error, Failure, Frame, HEIGHT, Panel, Pins, WIDTH, show_scenes};
use zrow_scenes::{
    Prepared, Scene,
    instruments::{Changing, DAMAGE_AREAS, Instruments},
    teapots::TexturedTeapot,
};

const WHOLE: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH, HEIGHT));

/// The display, and what else is seen of the wires.
struct Wires {
    panel: St7789,
    is_data: bool,
    is_selected: bool,
    /// Bytes of commands, without operands.
    commands: usize,
    /// Pixels that futures have sent, two bytes each.
    pixels: usize,
    /// Futures that have begun and that have ended.
    begun: usize,
    ended: usize,
    /// Bytes until the bus fails.
    bytes_left: usize,
    /// Bytes of a future that the DMA has not sent: it goes on where the future is dropped.
    on_the_way: Vec<u8>,
}

impl Wires {
    fn new() -> Rc<RefCell<Self>> {
        Rc::new(RefCell::new(Self {
            panel: St7789::new(),
            is_data: true,
            is_selected: false,
            commands: 0,
            pixels: 0,
            begun: 0,
            ended: 0,
            bytes_left: usize::MAX,
            on_the_way: Vec::new(),
        }))
    }

    /// Waits until the DMA has sent its bytes.
    fn wait(&mut self) -> Result<(), spi::ErrorKind> {
        let bytes = std::mem::take(&mut self.on_the_way);
        self.take(&bytes)
    }

    fn set_data(&mut self, is_data: bool) {
        assert!(self.on_the_way.is_empty(), "pixels as commands");
        self.is_data = is_data;
    }

    fn take(&mut self, bytes: &[u8]) -> Result<(), spi::ErrorKind> {
        assert!(self.on_the_way.is_empty(), "two transfers at once");
        assert!(self.is_selected, "nobody listens to {bytes:?}");
        self.bytes_left = self.bytes_left.checked_sub(bytes.len()).ok_or(spi::ErrorKind::Other)?;
        match self.is_data {
            true => self.panel.take_data(bytes).unwrap(),
            false => {
                self.commands += bytes.len();
                self.panel.take_commands(bytes).unwrap();
            }
        }
        Ok(())
    }
}

/// A bus with DMA: what a future sends is on its way at the first poll, and sent at the third one; of a future that is dropped when
/// the bus settles or is flushed.
struct Bus(Rc<RefCell<Wires>>);

impl Bus {
    fn settle(&mut self) {
        self.0.borrow_mut().wait().unwrap();
    }
}

impl spi::ErrorType for Bus {
    type Error = spi::ErrorKind;
}

impl spi::SpiBus for Bus {
    fn write(&mut self, words: &[u8]) -> Result<(), spi::ErrorKind> {
        self.0.borrow_mut().take(words)
    }

    fn read(&mut self, _: &mut [u8]) -> Result<(), spi::ErrorKind> {
        unreachable!("the panel is never read")
    }

    fn transfer(&mut self, _: &mut [u8], _: &[u8]) -> Result<(), spi::ErrorKind> {
        unreachable!("the panel is never read")
    }

    fn transfer_in_place(&mut self, _: &mut [u8]) -> Result<(), spi::ErrorKind> {
        unreachable!("the panel is never read")
    }

    fn flush(&mut self) -> Result<(), spi::ErrorKind> {
        self.0.borrow_mut().wait()
    }
}

impl embedded_hal_async::spi::SpiBus for Bus {
    async fn write(&mut self, words: &[u8]) -> Result<(), spi::ErrorKind> {
        {
            let mut wires = self.0.borrow_mut();
            assert!(wires.is_data, "pixels as commands");
            wires.begun += 1;
            wires.pixels += words.len() / 2;
            assert!(wires.on_the_way.is_empty(), "two transfers at once");
            wires.on_the_way.extend_from_slice(words);
        }
        let mut polls = [Poll::Pending, Poll::Pending, Poll::Ready(())].into_iter();
        poll_fn(|_| polls.next().unwrap()).await;
        let mut wires = self.0.borrow_mut();
        wires.wait()?;
        wires.ended += 1;
        Ok(())
    }

    async fn read(&mut self, _: &mut [u8]) -> Result<(), spi::ErrorKind> {
        unreachable!("the panel is never read")
    }

    async fn transfer(&mut self, _: &mut [u8], _: &[u8]) -> Result<(), spi::ErrorKind> {
        unreachable!("the panel is never read")
    }

    async fn transfer_in_place(&mut self, _: &mut [u8]) -> Result<(), spi::ErrorKind> {
        unreachable!("the panel is never read")
    }

    async fn flush(&mut self) -> Result<(), spi::ErrorKind> {
        Ok(())
    }
}

/// A pin that the wires hear of, or not.
struct Pin(Rc<RefCell<Wires>>, fn(&mut Wires, bool));

impl embedded_hal::digital::ErrorType for Pin {
    type Error = Infallible;
}

impl OutputPin for Pin {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.1(&mut self.0.borrow_mut(), false);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.1(&mut self.0.borrow_mut(), true);
        Ok(())
    }
}

struct NoDelay;

impl DelayNs for NoDelay {
    fn delay_ns(&mut self, _: u32) {}
}

fn start(wires: &Rc<RefCell<Wires>>) -> Panel<Bus, Pin> {
    start_with(wires, Bus::settle)
}

fn start_with(wires: &Rc<RefCell<Wires>>, settle: fn(&mut Bus)) -> Panel<Bus, Pin> {
    let pin = |set| Pin(Rc::clone(wires), set);
    let pins = Pins {
        data_not_command: pin(Wires::set_data),
        select: pin(|wires, is_high| wires.is_selected = !is_high),
        reset: pin(|_, _| {}),
        backlight: pin(|_, _| {}),
    };
    Panel::start(Bus(Rc::clone(wires)), settle, pins, &mut NoDelay).unwrap()
}

/// Polls a future until it is ready.
fn wait<F: Future>(future: F) -> F::Output {
    let mut future = pin!(future);
    loop {
        if let Poll::Ready(output) = future.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            return output;
        }
    }
}

/// The words of a picture that is drawn on the desktop, row by row.
fn drawn(background: Rgb565, mut draw: impl FnMut(&mut Band<'_, Rgb565>)) -> Vec<u16> {
    let (mut row, mut words) = (vec![0; WIDTH as usize], Vec::new());
    let mut sink = |band: Band<'_, Rgb565>| -> Result<(), Infallible> {
        words.extend_from_slice(band.words());
        Ok(())
    };
    let result = PictureLoop::new(WHOLE, background).draw(&mut row, &mut sink, |band| draw(band));
    result.unwrap();
    words
}

/// The instruments in a frame, changed to it from the one before.
fn instruments(picture: &mut zrow::draw::Picture<'_, 'static, Rgb565>) -> Vec<u16> {
    drawn(Instruments::BACKGROUND, |band| picture.draw(band))
}

/// Runs the scenes until so many frames are reported, in bands of so many words; each frame is handed over with the wires.
fn show(frames: usize, words: usize, mut check: impl FnMut(Frame, &mut Wires)) {
    let wires = Wires::new();
    let mut panel = start(&wires);
    let (mut one, mut other) = (vec![0; words], vec![0; words]);
    let mut count = 0;
    let report = |frame| {
        check(frame, &mut wires.borrow_mut());
        count += 1;
        if count == frames {
            // The bus fails, which is how these scenes end.
            wires.borrow_mut().bytes_left = 0;
        }
    };
    let shown = wait(show_scenes(&mut panel, [&mut one, &mut other], report));
    assert!(matches!(shown, Err(Failure::Picture(_))));
    assert_eq!(count, frames);
}

/// One row a band and sixteen, as the boards have them, and a number that no height can be divided by.
const WORDS: [usize; 3] = [240, 7 * 240 + 11, 16 * 240];

#[test]
fn the_panel_shows_the_scenes() {
    for words in WORDS {
        let (mut panel, mut areas) = (Instruments::new(), [Window::EMPTY; DAMAGE_AREAS]);
        let mut picture = panel.picture_with_damage(&mut areas);
        let changing = Changing::add(&mut picture, 0).unwrap();
        let mut teapot = TexturedTeapot::default();
        // All instruments, three teapots.
        show(64 + 3, words, |frame, wires| {
            let expected = match frame {
                Frame::Instruments { frame, areas, pixels } => {
                    changing.show(&mut picture, frame).unwrap();
                    assert_eq!(wires.pixels, pixels as usize, "frame {frame}");
                    // The first frame is sent whole.
                    let is_small = areas as usize <= DAMAGE_AREAS && pixels < 2_400;
                    assert!(is_small || frame == 0 && areas == 1, "frame {frame}: {pixels}");
                    instruments(&mut picture)
                }
                Frame::Teapot { frame, counters } => {
                    assert_eq!((counters.rows, wires.pixels), (HEIGHT, (WIDTH * HEIGHT) as usize));
                    let mut prepared = teapot.prepare(frame).unwrap();
                    drawn(TexturedTeapot::BACKGROUND, |band| Prepared::draw(&mut prepared, band))
                }
            };
            wires.pixels = 0;
            let shown = wires.panel.pixels(WHOLE).unwrap();
            let differing = shown.iter().zip(&expected).filter(|(one, other)| one != other).count();
            assert_eq!(differing, 0, "{frame:?} in bands of {words} words");
        });
    }
}

/// While a band is drawn, the one before it is on its way: its pixels have been taken, not its commands alone. These are sent once a
/// picture.
#[test]
fn a_band_is_sent_while_the_next_is_drawn() {
    let wires = Wires::new();
    let mut panel = start(&wires);
    let (mut one, mut other) = ([0; 240], [0; 240]);
    let (mut drawing, commands) = (0, wires.borrow().commands);
    let scene = |_: &mut Band<'_, Rgb565, zrow::band::BigEndian>| {
        let wires = wires.borrow();
        assert_eq!((wires.begun, wires.pixels), (drawing, 240 * drawing));
        assert_eq!(wires.ended, drawing.saturating_sub(1), "band {drawing}");
        drawing += 1;
    };
    let send = async |area: Rectangle, bytes: &[u8]| panel.send(area, bytes).await;
    let picture = PictureLoop::new(WHOLE, Rgb565::GREEN).in_order();
    wait(picture.draw_async([&mut one, &mut other], send, scene)).unwrap();
    assert_eq!((drawing, wires.borrow().ended), (320, 320));
    assert_eq!(wires.borrow().commands - commands, 3);
}

/// The pixels of a band whose future is dropped are lost; those of the next one are where they belong. Nothing of the band is on the
/// way once its future is dropped: it is drawn over.
#[test]
fn a_dropped_transfer_does_not_move_the_next_band() {
    let wires = Wires::new();
    let mut panel = start(&wires);
    send_after_a_dropped_transfer(&mut panel, || assert!(wires.borrow().on_the_way.is_empty()));
    check_rows(&wires);
}

/// A bus that is only idle after a flush is flushed before a command.
#[test]
fn a_command_waits_for_the_bus() {
    let wires = Wires::new();
    let mut panel = start_with(&wires, |_| {});
    send_after_a_dropped_transfer(&mut panel, || assert_eq!(wires.borrow().on_the_way, [2; 480]));
    check_rows(&wires);
}

/// A transfer that has ended, or failed, has nothing to wait for.
#[test]
fn the_bus_settles_after_dropped_transfers_alone() {
    let wires = Wires::new();
    let mut panel = start_with(&wires, |_| panic!("nothing to wait for"));
    let (area, bytes) = row(10, 1);
    wait(panel.send(area, &bytes)).unwrap();
    // No future is there before the first poll.
    drop(panel.send(area, &bytes));
    let commands = 11;
    wires.borrow_mut().bytes_left = commands;
    assert!(matches!(wait(panel.send(area, &bytes)), Err(Error::Bus(_))));
    assert_eq!(wires.borrow().begun, 2);
}

/// A row of the panel, and bytes for it.
fn row(top: i32, byte: u8) -> (Rectangle, [u8; 480]) {
    (Rectangle::new(Point::new(0, top), Size::new(240, 1)), [byte; 480])
}

/// Sends the rows 10 to 12; the future of row 11 is dropped, and it is sent again.
fn send_after_a_dropped_transfer(panel: &mut Panel<Bus, Pin>, check_dropped: impl Fn()) {
    let (area, bytes) = row(10, 1);
    wait(panel.send(area, &bytes)).unwrap();
    let (area, bytes) = row(11, 2);
    {
        let mut dropped = pin!(panel.send(area, &bytes));
        let pending = dropped.as_mut().poll(&mut Context::from_waker(Waker::noop()));
        assert!(pending.is_pending());
    }
    check_dropped();
    // The same rows again, as where a picture is drawn anew.
    let (area, bytes) = row(11, 4);
    wait(panel.send(area, &bytes)).unwrap();
    let (area, bytes) = row(12, 3);
    wait(panel.send(area, &bytes)).unwrap();
}

/// The rows 10 to 12 have their pixels, and no other row has any.
fn check_rows(wires: &RefCell<Wires>) {
    let shown = wires.borrow().panel.pixels(WHOLE).unwrap();
    let rows: Vec<_> = shown.chunks(240).collect();
    let expected = |row| match row {
        10 => 0x0101,
        11 => 0x0404,
        12 => 0x0303,
        _ => 0,
    };
    assert!((0..320).all(|row| rows[row] == [expected(row); 240]));
}

#[test]
fn what_is_not_within_the_panel_is_an_error() {
    let wires = Wires::new();
    let mut panel = start(&wires);
    for (left, top, width, height) in [
        (-1, 0, 2, 1),
        (0, -1, 2, 1),
        (239, 0, 2, 1),
        (0, 319, 2, 2),
        (0, 320, 2, 1),
        (0, 0, 0, 5),
    ] {
        let area = Rectangle::new(Point::new(left, top), Size::new(width, height));
        let bytes = vec![0; (width * height * 2) as usize];
        assert!(matches!(wait(panel.send(area, &bytes)), Err(Error::Area)), "{area:?}");
    }
    let area = Rectangle::new(Point::zero(), Size::new(2, 2));
    assert!(matches!(wait(panel.send(area, &[0; 7])), Err(Error::Area)));
    assert_eq!(wires.borrow().begun, 0);
}
