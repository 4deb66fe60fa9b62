//! Electronic paper.

use embedded_graphics::{
    pixelcolor::BinaryColor,
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
};
use zrow::band::{Band, BandColor, DisplaySink, LittleEndian, PanelRotation, PictureLoop};

use crate::{
    scene::{box_of, packed, picture, scene},
    wires::{Unused, Wires},
};

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
            &mut BytesSink(send),
            |band: &mut Band<'_, BinaryColor>| {
                scene(band);
                PanelRotation::by_270(picture_box).rotate(band);
            },
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

/// Three inks of the driver's own colour type: a colour of its own holds it, with a byte a pixel in the row.
#[test]
fn epd_waveshare_in_its_own_colours() {
    use embedded_graphics::pixelcolor::raw::RawU8;
    use epd_waveshare::{color::TriColor, epd2in13bc::Display2in13bc};

    #[derive(Debug, Copy, Clone, PartialEq)]
    struct Ink(TriColor);

    impl PixelColor for Ink {
        type Raw = RawU8;
    }

    impl BandColor for Ink {
        type Word = u8;

        fn to_word(self) -> u8 {
            INKS.iter().position(|ink| *ink == self.0).unwrap() as u8
        }

        fn from_word(word: u8) -> Self {
            Self(INKS[usize::from(word)])
        }
    }

    impl From<Ink> for TriColor {
        fn from(ink: Ink) -> Self {
            ink.0
        }
    }

    const INKS: [TriColor; 3] = [TriColor::White, TriColor::Black, TriColor::Chromatic];
    let draw = |target: &mut dyn FnMut(Point, u32, TriColor)| {
        target(Point::new(10, 20), 60, TriColor::Black);
        target(Point::new(40, 70), 50, TriColor::Chromatic);
    };
    let (mut frame, mut direct) = (Display2in13bc::default(), Display2in13bc::default());
    let area = frame.bounding_box();
    let mut target = frame.color_converted::<Ink>();
    PictureLoop::new(area, Ink(TriColor::White))
        .draw(&mut [0; 104], &mut DisplaySink(&mut target), |band| {
            draw(&mut |place, diameter, ink| {
                band.draw(&Circle::new(place, diameter).into_styled(PrimitiveStyle::with_fill(Ink(ink))));
            });
        })
        .unwrap();
    direct.clear(TriColor::White).unwrap();
    draw(&mut |place, diameter, ink| {
        let disc = Circle::new(place, diameter).into_styled(PrimitiveStyle::with_fill(ink));
        disc.draw(&mut direct).unwrap();
    });
    assert!(frame.buffer() == direct.buffer());
    assert!(direct.bw_buffer().iter().any(|byte| *byte != 0xff));
}
