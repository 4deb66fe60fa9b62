//! A picture in one-row bands through each driver, with the lines that a program writes, and what comes out of the wires.

use std::{
    cell::RefCell,
    convert::Infallible,
    future::Future,
    pin::pin,
    rc::Rc,
    task::{Context, Poll, Waker},
};

use display_interface::{DataFormat, DisplayError, WriteOnlyDataCommand};
use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Rgb565, raw::ToBytes},
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
    text::Text,
};
use embedded_hal::{
    delay::DelayNs,
    digital::{self, InputPin, OutputPin},
    spi::{self, Operation, SpiDevice},
};
use zrow::band::{Band, BandColor, BigEndian, DisplaySink, LittleEndian, Order, PagesSink, PictureLoop, Rotated};

/// A command with its data, as the panel sees them.
type Command = (u8, Vec<u8>);

#[derive(Debug, Clone, Default)]
struct Wires(Rc<RefCell<(bool, Vec<Command>)>>);

impl Wires {
    fn send(&self, is_data: bool, bytes: impl IntoIterator<Item = u8>) {
        let commands = &mut self.0.borrow_mut().1;
        for byte in bytes {
            match (is_data, commands.last_mut()) {
                (true, Some((_, data))) => data.push(byte),
                (true, None) => panic!("data before a command"),
                (false, _) => commands.push((byte, Vec::new())),
            }
        }
    }

    /// The bytes that were recorded since this was last asked for.
    fn take(&self) -> Vec<Command> {
        std::mem::take(&mut self.0.borrow_mut().1)
    }

    /// The data of all commands of one code since the last call, one after the other.
    fn data_of(&self, code: u8) -> Vec<u8> {
        self.take()
            .into_iter()
            .filter(|(command, _)| *command == code)
            .flat_map(|(_, data)| data)
            .collect()
    }

    fn send_format(&self, is_data: bool, format: DataFormat<'_>) -> Result<(), DisplayError> {
        match format {
            DataFormat::U8(bytes) => self.send(is_data, bytes.iter().copied()),
            DataFormat::U8Iter(bytes) => self.send(is_data, bytes),
            DataFormat::U16BE(words) => self.send(is_data, words.iter().flat_map(|word| word.to_be_bytes())),
            DataFormat::U16BEIter(words) => self.send(is_data, words.flat_map(u16::to_be_bytes)),
            _ => return Err(DisplayError::DataFormatNotImplemented),
        }
        Ok(())
    }
}

impl WriteOnlyDataCommand for Wires {
    fn send_commands(&mut self, commands: DataFormat<'_>) -> Result<(), DisplayError> {
        self.send_format(false, commands)
    }

    fn send_data(&mut self, data: DataFormat<'_>) -> Result<(), DisplayError> {
        self.send_format(true, data)
    }
}

impl spi::ErrorType for Wires {
    type Error = Infallible;
}

impl SpiDevice for Wires {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let is_data = self.0.borrow().0;
        for operation in operations {
            let Operation::Write(bytes) = operation else {
                panic!("the panel is only written to");
            };
            self.send(is_data, bytes.iter().copied());
        }
        Ok(())
    }
}

impl digital::ErrorType for Wires {
    type Error = Infallible;
}

/// The data/command pin.
impl OutputPin for Wires {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().0 = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().0 = true;
        Ok(())
    }
}

impl lcd_async::interface::Interface for Wires {
    type Word = u8;
    type Error = Infallible;
    const KIND: lcd_async::interface::InterfaceKind = lcd_async::interface::InterfaceKind::Serial4Line;

    async fn send_command(&mut self, command: u8, args: &[u8]) -> Result<(), Infallible> {
        self.send(false, [command]);
        self.send(true, args.iter().copied());
        Ok(())
    }

    async fn send_data_slice(&mut self, data: &[u8]) -> Result<(), Infallible> {
        self.send(true, data.iter().copied());
        Ok(())
    }
}

/// A pin or a delay that does nothing; as an input it is low: not busy.
#[derive(Clone, Copy)]
struct Unused;

impl digital::ErrorType for Unused {
    type Error = Infallible;
}

impl OutputPin for Unused {
    fn set_low(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

impl InputPin for Unused {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        Ok(false)
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        Ok(true)
    }
}

impl DelayNs for Unused {
    fn delay_ns(&mut self, _: u32) {}
}

fn scene<C: BandColor + From<BinaryColor>, O: Order>(band: &mut Band<'_, C, O>) {
    let on = C::from(BinaryColor::On);
    band.draw(&Circle::new(Point::new(20, 9), 41).into_styled(PrimitiveStyle::with_stroke(on, 3)));
    band.draw(&Text::new(
        "zrow",
        Point::new(28, 32),
        MonoTextStyle::new(&FONT_6X10, on),
    ));
}

/// The picture in one band over the whole panel.
fn picture<C: BandColor + From<BinaryColor>>(area: Rectangle) -> Vec<C> {
    let mut words = vec![C::from(BinaryColor::Off).to_word(); (area.size.width * area.size.height) as usize];
    let mut band = Band::<C>::new(area, &mut words).unwrap();
    scene(&mut band);
    band.colors().collect()
}

fn rgb565_bytes(area: Rectangle) -> Vec<u8> {
    picture::<Rgb565>(area)
        .iter()
        .flat_map(|color| color.to_be_bytes())
        .collect()
}

/// Horizontal bytes, eight pixels each, from the top to the bottom.
fn packed(area: Rectangle) -> Vec<u8> {
    let mut words: Vec<u8> = picture::<BinaryColor>(area)
        .iter()
        .map(|color| u8::from(color.is_on()))
        .collect();
    Band::<BinaryColor>::new(area, &mut words)
        .unwrap()
        .into_bytes()
        .to_vec()
}

fn box_of(width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::zero(), Size::new(width, height))
}

#[test]
fn ssd1306_in_pages() {
    use ssd1306::{Ssd1306, prelude::*};

    let wires = Wires::default();
    let mut display = Ssd1306::new(wires.clone(), DisplaySize128x64, DisplayRotation::Rotate0);
    display
        .init_with_addr_mode(ssd1306::command::AddrMode::Horizontal)
        .unwrap();
    wires.take();
    let (area, mut row, mut page) = (box_of(128, 64), [0; 128], [0; 128]);
    let mut sink = PagesSink::new(area, &mut page, |page| {
        let top = page.area.top_left.y as u8;
        display.set_draw_area((0, top), (128, top + 8))?;
        display.draw(page.bytes)
    })
    .unwrap();
    PictureLoop::new(area, BinaryColor::Off)
        .draw(&mut row, &mut sink, scene::<BinaryColor, LittleEndian>)
        .unwrap();
    let commands = wires.take();
    let pages: Vec<u8> = commands.iter().flat_map(|(_, data)| data.clone()).collect();
    let codes: Vec<u8> = commands.iter().map(|(code, _)| *code).collect();
    let windows: Vec<u8> = (0..8).flat_map(|page| [0x21, 0, 127, 0x22, page, page]).collect();
    assert_eq!(codes, windows);
    let pixels = picture::<BinaryColor>(area);
    let byte = |index: usize| {
        let (page, column) = (index / 128, index % 128);
        (0..8)
            .map(|bit| u8::from(pixels[(8 * page + bit) * 128 + column].is_on()) << bit)
            .sum::<u8>()
    };
    assert_eq!(pages, (0..1024).map(byte).collect::<Vec<u8>>());
}

#[test]
fn ili9341_by_its_draw_target() {
    use ili9341::{DisplaySize240x320, Ili9341, Orientation};

    let wires = Wires::default();
    let mut display = Ili9341::new(
        wires.clone(),
        Unused,
        &mut Unused,
        Orientation::Portrait,
        DisplaySize240x320,
    )
    .unwrap();
    wires.take();
    let area = display.bounding_box();
    PictureLoop::new(area, Rgb565::BLACK)
        .draw(
            &mut [0; 240],
            &mut DisplaySink(&mut display),
            scene::<Rgb565, LittleEndian>,
        )
        .unwrap();
    assert!(wires.data_of(0x2c) == rgb565_bytes(area));
}

/// Polls a future to its end, which comes by itself.
fn block_on<T>(future: impl Future<Output = T>) -> T {
    let mut future = pin!(future);
    let mut context = Context::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(output) = future.as_mut().poll(&mut context) {
            return output;
        }
    }
}

/// A delay that is over at once.
struct NoDelay;

impl embedded_hal_async::delay::DelayNs for NoDelay {
    async fn delay_ns(&mut self, _: u32) {}
}

#[test]
fn lcd_async_by_its_raw_data() {
    use lcd_async::{Builder, models::ST7789};

    let wires = Wires::default();
    block_on(async {
        let mut display = Builder::new(ST7789, wires.clone())
            .display_size(240, 240)
            .init(&mut NoDelay)
            .await
            .unwrap();
        wires.take();
        let send = async |area: Rectangle, bytes: &[u8]| {
            let (Point { x, y }, Size { width, height }) = (area.top_left, area.size);
            display
                .show_raw_data(x as u16, y as u16, width as u16, height as u16, bytes)
                .await
        };
        PictureLoop::new(box_of(240, 240), Rgb565::BLACK)
            .in_order::<BigEndian>()
            .draw_async([&mut [0; 240], &mut [0; 240]], send, scene::<Rgb565, BigEndian>)
            .await
            .unwrap();
    });
    assert!(wires.data_of(0x2c) == rgb565_bytes(box_of(240, 240)));
}

/// A panel of 128 x 296 that lies on its side: eight rows of the picture are a column of bytes.
#[test]
fn weact_by_its_partial_buffer() {
    use weact_studio_epd::WeActStudio290BlackWhiteDriver;
    use zrow::band::BytesSink;

    let wires = Wires::default();
    let mut driver = WeActStudio290BlackWhiteDriver::new(wires.clone(), Unused, Unused, Unused);
    let send = |area: Rectangle, bytes: &[u8]| {
        let (Point { x, y }, Size { width, height }) = (area.top_left, area.size);
        driver.write_partial_bw_buffer(bytes, x as u32, y as u32, width, height)
    };
    // Upright: eight rows, since the driver refuses windows of one.
    PictureLoop::new(box_of(128, 296), BinaryColor::Off)
        .rows(8)
        .draw(&mut [0; 1024], &mut BytesSink(send), scene::<BinaryColor, LittleEndian>)
        .unwrap();
    assert!(wires.data_of(0x24) == packed(box_of(128, 296)));

    let send = |area: Rectangle, bytes: &[u8]| {
        let (Point { x, y }, Size { width, height }) = (area.top_left, area.size);
        driver.write_partial_bw_buffer(bytes, x as u32, y as u32, width, height)
    };
    let picture_box = box_of(296, 128);
    PictureLoop::new(picture_box, BinaryColor::Off)
        .rows(8)
        .draw(
            &mut [0; 8 * 296],
            &mut Rotated::by_270(picture_box, BytesSink(send)),
            scene::<BinaryColor, LittleEndian>,
        )
        .unwrap();
    let pixels = picture::<BinaryColor>(picture_box);
    let byte = |column: usize, row: usize| {
        let bit = |bit: usize| u8::from(pixels[(8 * column + bit) * 296 + 295 - row].is_on()) << (7 - bit);
        (0..8).map(bit).sum::<u8>()
    };
    let columns: Vec<u8> = (0..16)
        .flat_map(|column| (0..296).map(move |row| byte(column, row)))
        .collect();
    assert!(wires.data_of(0x24) == columns);
}

/// Colours that are not embedded-graphics' own: the picture is binary, and the driver's frame takes it converted.
#[test]
fn epd_waveshare_by_its_frame() {
    use epd_waveshare::{
        color::Color,
        epd2in13_v2::{Display2in13, Epd2in13},
        prelude::WaveshareDisplay,
    };

    let (mut wires, mut frame) = (Wires::default(), Display2in13::default());
    let (dc, mut delay) = (wires.clone(), Unused);
    let mut panel = Epd2in13::new(&mut wires, Unused, dc, Unused, &mut delay, None).unwrap();
    let area = frame.bounding_box();
    let mut target = frame.color_converted::<BinaryColor>();
    PictureLoop::new(area, BinaryColor::Off)
        .draw(
            &mut [0; 122],
            &mut DisplaySink(&mut target),
            scene::<BinaryColor, LittleEndian>,
        )
        .unwrap();
    wires.take();
    panel.update_frame(&mut wires, frame.buffer(), &mut delay).unwrap();
    let sent = wires.data_of(0x24);
    assert_eq!(sent.len(), 16 * 250);
    let pixels = picture::<BinaryColor>(area);
    for (index, color) in pixels.iter().enumerate() {
        let (x, y) = (index % 122, index / 122);
        let is_white = sent[16 * y + x / 8] >> (7 - x % 8) & 1 == 1;
        assert_eq!(is_white, Color::from(*color) == Color::White, "{x}, {y}");
    }
}

/// A layout that asks the target for its box, in one-row bands.
#[test]
fn embedded_layout_in_the_picture() {
    use embedded_layout::{layout::linear::LinearLayout, prelude::*};

    fn layout<D: DrawTarget<Color = Rgb565>>(target: &mut D) -> Result<(), D::Error> {
        let text = Text::new("zrow", Point::zero(), MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE));
        let disc = Circle::new(Point::zero(), 15).into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
        LinearLayout::vertical(Chain::new(text).append(disc))
            .with_alignment(horizontal::Center)
            .arrange()
            .align_to(&target.bounding_box(), horizontal::Center, vertical::Center)
            .draw(target)
    }

    let area = box_of(64, 48);
    let mut whole = vec![0; 64 * 48];
    let Ok(()) = layout(&mut Band::<Rgb565>::new(area, &mut whole).unwrap());
    assert!(whole.contains(&Rgb565::RED.into_storage()));
    let mut sent = Vec::new();
    let mut sink = |band: Band<'_, Rgb565>| {
        sent.extend_from_slice(band.words());
        Ok::<(), Infallible>(())
    };
    PictureLoop::new(area, Rgb565::BLACK)
        .draw(&mut [0; 64], &mut sink, |band| layout(&mut band.in_picture(area)))
        .unwrap();
    assert!(sent == whole);
}
