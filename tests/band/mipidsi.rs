//! A mipidsi display behind a recording SPI bus: exactly the window commands and pixel bytes that a picture takes.

use std::{cell::RefCell, convert::Infallible, rc::Rc};

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_10X20},
    pixelcolor::{Rgb565, Rgb666, raw::ToBytes},
    prelude::*,
    primitives::{self, Circle, Line, Rectangle},
    text::Text,
};
use embedded_hal::{
    delay::DelayNs,
    digital::{self, OutputPin},
    spi::{self, Operation, SpiDevice},
};
use mipidsi::{
    Builder, Display, NoResetPin,
    interface::SpiInterface,
    models::{ILI9341Rgb565, ILI9341Rgb666, Model, ST7789},
    options::{Orientation, Rotation},
};
use zrow::{
    band::{Band, BandColor, BigEndian, BytesSink, DisplaySink, Generic, LittleEndian, PictureLoop},
    draw::{DrawOn, PrimitiveStyle},
};

const SET_COLUMNS: u8 = 0x2a;
const SET_ROWS: u8 = 0x2b;
const WRITE_MEMORY: u8 = 0x2c;

/// A command with its data, as the panel sees them.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Command {
    code: u8,
    data: Vec<u8>,
}

/// The wires of the panel: chip select is not among them, the data/command pin is.
#[derive(Debug, Default)]
struct Wires {
    data_selected: bool,
    commands: Vec<Command>,
}

#[derive(Debug, Clone, Default)]
struct Recorder(Rc<RefCell<Wires>>);

impl Recorder {
    /// The bytes that were recorded since this was last asked for.
    fn take(&self) -> Vec<Command> {
        std::mem::take(&mut self.0.borrow_mut().commands)
    }
}

impl spi::ErrorType for Recorder {
    type Error = Infallible;
}

impl SpiDevice for Recorder {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let wires = &mut *self.0.borrow_mut();
        for operation in operations {
            let Operation::Write(bytes) = operation else {
                panic!("the panel is only written to");
            };
            for &byte in bytes.iter() {
                if wires.data_selected {
                    wires.commands.last_mut().unwrap().data.push(byte);
                } else {
                    wires.commands.push(Command {
                        code: byte,
                        data: Vec::new(),
                    });
                }
            }
        }
        Ok(())
    }
}

struct DataPin(Recorder);

impl digital::ErrorType for DataPin {
    type Error = Infallible;
}

impl OutputPin for DataPin {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.0.borrow_mut().data_selected = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.0.borrow_mut().data_selected = true;
        Ok(())
    }
}

/// Waits for nothing: recorded wires are ready at once.
pub struct NoDelay;

impl DelayNs for NoDelay {
    fn delay_ns(&mut self, _: u32) {}
}

type Panel<'a, M> = Display<SpiInterface<'a, Recorder, DataPin>, M, NoResetPin>;

/// A display that is initialized; the commands for that are left out of the record.
fn display<'a, M>(
    model: M,
    (width, height): (u16, u16),
    offset: (u16, u16),
    rotation: Rotation,
    buffer: &'a mut [u8],
) -> (Panel<'a, M>, Recorder)
where
    M: Model,
    M::ColorFormat: mipidsi::interface::InterfacePixelFormat<u8>,
{
    let recorder = Recorder::default();
    let interface = SpiInterface::new(recorder.clone(), DataPin(recorder.clone()), buffer);
    let display = Builder::new(model, interface)
        .display_size(width, height)
        .display_offset(offset.0, offset.1)
        .orientation(Orientation::new().rotate(rotation))
        .init(&mut NoDelay)
        .unwrap();
    assert!(!recorder.take().is_empty());
    (display, recorder)
}

/// The commands for one block of pixels, sides included.
fn block(left: u16, top: u16, right: u16, bottom: u16, pixels: Vec<u8>) -> [Command; 3] {
    let range = |code: u8, first: u16, last: u16| Command {
        code,
        data: [first.to_be_bytes(), last.to_be_bytes()].concat(),
    };
    [
        range(SET_COLUMNS, left, right),
        range(SET_ROWS, top, bottom),
        Command {
            code: WRITE_MEMORY,
            data: pixels,
        },
    ]
}

fn scene<C: BandColor + RgbColor, O: zrow::band::Order>(band: &mut Band<'_, C, O>) {
    band.draw(&Circle::new(Point::new(60, 40), 70).into_styled(primitives::PrimitiveStyle::with_fill(C::RED)));
    let line =
        Line::new(Point::new(-2000, -900), Point::new(900, 600)).into_styled(PrimitiveStyle::with_stroke(C::GREEN, 1));
    let Ok(()) = line.draw_on(band);
    let Ok(_) = Text::new(
        "row by row",
        Point::new(-4, 90),
        MonoTextStyle::new(&FONT_10X20, C::YELLOW),
    )
    .draw(band);
}

/// The scene in one band over the whole display.
fn picture<C: BandColor + RgbColor>(area: Rectangle) -> Vec<C> {
    let mut words = vec![C::BLUE.to_word(); (area.size.width * area.size.height) as usize];
    let mut band = Band::<C>::new(area, &mut words).unwrap();
    scene(&mut band);
    band.colors().collect()
}

#[test]
fn a_picture_of_four_pixels_is_this_on_the_wire() {
    let mut buffer = [0; 64];
    let (mut display, recorder) = display(ILI9341Rgb565, (2, 2), (0, 0), Rotation::Deg0, &mut buffer);
    let diagonal =
        Line::new(Point::new(0, 0), Point::new(1, 1)).into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1));
    PictureLoop::new(display.bounding_box(), Rgb565::BLUE)
        .draw(
            &mut [0; 2],
            &mut DisplaySink(&mut display),
            |band: &mut Band<'_, Rgb565>| {
                let Ok(()) = diagonal.draw_on(band);
            },
        )
        .unwrap();
    let command = |code: u8, data: &[u8]| Command {
        code,
        data: data.to_vec(),
    };
    assert_eq!(
        recorder.take(),
        [
            command(0x2a, &[0, 0, 0, 1]),
            command(0x2b, &[0, 0, 0, 0]),
            command(0x2c, &[0xf8, 0x00, 0x00, 0x1f]),
            command(0x2a, &[0, 0, 0, 1]),
            command(0x2b, &[0, 1, 0, 1]),
            command(0x2c, &[0x00, 0x1f, 0xf8, 0x00]),
        ]
    );
}

/// The whole picture through the loop on one display: one window a band, and the bytes of the full frame.
/// `origin` is where the display lies in the memory of its controller, as it is rotated.
fn check_bands<M: Model<ColorFormat = Rgb565>>(
    model: M,
    (size, offset): ((u16, u16), (u16, u16)),
    rotation: Rotation,
    origin: (u16, u16),
    rows: u32,
) {
    let mut buffer = [0; 130];
    let (mut display, recorder) = display(model, size, offset, rotation, &mut buffer);
    let area = display.bounding_box();
    let (width, height) = (area.size.width as usize, area.size.height as usize);
    let picture_loop = PictureLoop::new(area, Rgb565::BLUE).rows(rows).in_order();
    let mut words = vec![0; picture_loop.words_needed()];
    picture_loop
        .draw(&mut words, &mut DisplaySink(&mut display), scene::<Rgb565, BigEndian>)
        .unwrap();

    let picture = picture::<Rgb565>(area);
    let mut expected = Vec::new();
    for top in (0..height).step_by(rows as usize) {
        let bottom = height.min(top + rows as usize);
        let pixels = picture[top * width..bottom * width]
            .iter()
            .flat_map(|color| color.to_be_bytes())
            .collect();
        expected.extend(block(
            origin.0,
            origin.1 + top as u16,
            origin.0 + width as u16 - 1,
            origin.1 + bottom as u16 - 1,
            pixels,
        ));
    }
    let commands = recorder.take();
    assert_eq!(commands.len(), expected.len());
    for (index, (command, expected)) in commands.iter().zip(&expected).enumerate() {
        assert!(
            command == expected,
            "command {index}: {:?} {:?}",
            command.code,
            &command.data[..4]
        );
    }
}

#[test]
fn a_band_is_one_window_and_its_pixels() {
    let whole = ((240, 320), (0, 0));
    for rows in [1, 7, 16, 320] {
        check_bands(ILI9341Rgb565, whole, Rotation::Deg0, (0, 0), rows);
    }
    check_bands(ILI9341Rgb565, whole, Rotation::Deg90, (0, 0), 16);
    // A small panel in the middle of its controller's 240 x 320: 53 columns are left on its other side.
    let part = ((135, 240), (52, 40));
    check_bands(ST7789, part, Rotation::Deg0, (52, 40), 1);
    check_bands(ST7789, part, Rotation::Deg90, (40, 53), 9);
}

#[test]
fn the_bytes_of_a_band_are_those_that_the_driver_sends() {
    let mut buffer = [0; 96];
    let (mut display, recorder) = display(ILI9341Rgb666, (240, 160), (0, 0), Rotation::Deg0, &mut buffer);
    let picture_loop = PictureLoop::new(display.bounding_box(), Rgb666::BLUE).rows(8);
    let mut words = vec![0; picture_loop.words_needed()];
    picture_loop
        .draw(
            &mut words,
            &mut DisplaySink(&mut display),
            scene::<Rgb666, LittleEndian>,
        )
        .unwrap();
    let mut sent = recorder
        .take()
        .into_iter()
        .filter(|command| command.code == WRITE_MEMORY);
    let mut sink = BytesSink(|_: Rectangle, bytes: &[u8]| {
        assert!(sent.next().unwrap().data == bytes);
        Ok::<(), Infallible>(())
    });
    picture_loop
        .in_order()
        .draw(&mut words, &mut sink, scene::<Rgb666, BigEndian>)
        .unwrap();
    assert_eq!(sent.next(), None);
}

/// The panel's memory after some commands. Fails where a window reaches out of the panel or does not fit its pixels.
fn memory(commands: &[Command], width: u16, height: u16) -> Result<Vec<Rgb565>, String> {
    let mut pixels = vec![Rgb565::BLACK; usize::from(width) * usize::from(height)];
    let (mut columns, mut rows) = (0..=0, 0..=0);
    for command in commands {
        let range = || {
            let word = |at: usize| u16::from_be_bytes([command.data[at], command.data[at + 1]]);
            word(0)..=word(2)
        };
        match command.code {
            SET_COLUMNS => columns = range(),
            SET_ROWS => rows = range(),
            WRITE_MEMORY => {
                if *columns.end() >= width || *rows.end() >= height {
                    return Err(format!("columns {columns:?}, rows {rows:?}"));
                }
                let positions = rows
                    .clone()
                    .flat_map(|row| columns.clone().map(move |column| (row, column)));
                if positions.clone().count() * 2 != command.data.len() {
                    return Err(format!("{} bytes for {columns:?}, {rows:?}", command.data.len()));
                }
                for ((row, column), bytes) in positions.zip(command.data.chunks_exact(2)) {
                    let value = u16::from_be_bytes([bytes[0], bytes[1]]);
                    pixels[usize::from(row) * usize::from(width) + usize::from(column)] = Rgb565::from_word(value);
                }
            }
            code => return Err(format!("command {code}")),
        }
    }
    Ok(pixels)
}

#[test]
fn a_window_beyond_the_panel_is_noticed() {
    let mut buffer = [0; 64];
    let (mut display, recorder) = display(ILI9341Rgb565, (240, 320), (0, 0), Rotation::Deg90, &mut buffer);
    display.set_pixels(310, 3, 319, 3, [Rgb565::RED; 10]).unwrap();
    assert!(memory(&recorder.take(), 320, 240).is_ok());
    display.set_pixels(320, 3, 320, 3, [Rgb565::RED]).unwrap();
    assert!(memory(&recorder.take(), 320, 240).is_err());
}

#[test]
fn nothing_beyond_the_panel_is_programmed() {
    let lines = [
        ((-9000, 4), (9000, 236)),
        ((0, 0), (500, 239)),
        ((319, 239), (i32::MAX, i32::MAX)),
        ((i32::MIN, 120), (i32::MAX, 121)),
        ((300, -70_000), (310, 70_000)),
        ((5000, 0), (6000, 240)),
    ]
    .map(|(from, to)| Line::new(from.into(), to.into()).into_styled(PrimitiveStyle::with_stroke(Rgb565::GREEN, 1)));
    let theirs = Line::new(Point::new(100, 20), Point::new(500, 20))
        .into_styled(primitives::PrimitiveStyle::with_stroke(Rgb565::RED, 1));
    let circle =
        Circle::new(Point::new(290, 210), 60).into_styled(primitives::PrimitiveStyle::with_fill(Rgb565::WHITE));
    let text = Text::new(
        "far right",
        Point::new(290, 50),
        MonoTextStyle::new(&FONT_10X20, Rgb565::YELLOW),
    );
    let corner = Rectangle::new(Point::new(317, -3), Size::new(6, 5));
    let colors = (0..30).map(|index| Rgb565::new(index, 0, 31));

    let area = Rectangle::new(Point::zero(), Size::new(320, 240));
    let mut words = vec![0; 320 * 240];
    let mut band = Band::<Rgb565>::new(area, &mut words).unwrap();
    for line in &lines {
        let Ok(()) = line.draw_on(&mut band);
    }
    let Ok(()) = theirs.draw(&mut band);
    let Ok(()) = circle.draw(&mut band);
    let Ok(_) = text.draw(&mut band);
    let Ok(()) = band.fill_contiguous(&corner, colors.clone());
    let expected: Vec<Rgb565> = band.colors().collect();

    let mut buffer = [0; 64];
    let (mut display, recorder) = display(ILI9341Rgb565, (240, 320), (0, 0), Rotation::Deg90, &mut buffer);
    // The fast entry point and the other one draw the same.
    for line in &lines[..3] {
        line.draw_on(&mut Generic(&mut display)).unwrap();
    }
    for line in &lines[3..] {
        line.draw(&mut display).unwrap();
    }
    let mut target = Generic(&mut display);
    theirs.draw(&mut target).unwrap();
    circle.draw(&mut target).unwrap();
    text.draw(&mut target).unwrap();
    target.fill_contiguous(&corner, colors).unwrap();
    let sent = memory(&recorder.take(), 320, 240).unwrap();
    assert!(sent == expected);
}
