//! LCDs that take colours of 16 bits, the high byte first.

use std::{
    future::Future,
    pin::pin,
    task::{Context, Poll, Waker},
};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use zrow::band::{Band, BigEndian, DisplaySink, LittleEndian, PictureLoop};

use crate::{
    scene::{box_of, rgb565_bytes, scene},
    wires::{Unused, Wires},
};

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

/// Its target is one of an older embedded-graphics, but it takes pixels as numbers.
#[test]
fn st7789_by_its_pixels() {
    use st7789::ST7789;

    let wires = Wires::default();
    let mut display = ST7789::new(wires.clone(), Some(Unused), Some(Unused), 240, 240);
    display.init(&mut Unused).unwrap();
    wires.take();
    let mut sink = |band: Band<'_, Rgb565>| {
        let ([left, top], [right, bottom]) = corners(band.bounding_box());
        display.set_pixels(left, top, right, bottom, band.words().iter().copied())
    };
    PictureLoop::new(box_of(240, 240), Rgb565::BLACK)
        .draw(&mut [0; 240], &mut sink, scene::<Rgb565, LittleEndian>)
        .unwrap();
    let commands = wires.take();
    let windows: Vec<u8> = commands
        .iter()
        .filter(|(code, _)| *code == 0x2b)
        .flat_map(|(_, rows)| rows.clone())
        .collect();
    assert_eq!(windows, (0..240).flat_map(|row| [0, row, 0, row]).collect::<Vec<u8>>());
    let sent: Vec<u8> = commands
        .into_iter()
        .filter(|(code, _)| *code == 0x2c)
        .flat_map(|(_, data)| data)
        .collect();
    assert!(sent == rgb565_bytes(box_of(240, 240)));
}

/// The first and the last pixel of a box.
fn corners(area: Rectangle) -> ([u16; 2], [u16; 2]) {
    let last = area.bottom_right().unwrap();
    (
        [area.top_left.x as u16, area.top_left.y as u16],
        [last.x as u16, last.y as u16],
    )
}

/// Polls a future to its end, which comes by itself.
pub fn block_on<T>(future: impl Future<Output = T>) -> T {
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
