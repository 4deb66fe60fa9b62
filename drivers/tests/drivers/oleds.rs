//! OLEDs that take pages of eight rows.

use embedded_graphics::{pixelcolor::BinaryColor, primitives::Rectangle};
use zrow::band::{LittleEndian, Page, PagesSink, PictureLoop};

use crate::{
    lcds::block_on,
    scene::{box_of, picture, scene},
    wires::{Unused, Wires},
};

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
    check_ssd1306(&wires, area);
}

#[test]
fn ssd1306_in_pages_by_futures() {
    use ssd1306::{Ssd1306Async, prelude::*};

    let wires = Wires::default();
    let area = box_of(128, 64);
    block_on(async {
        let mut display = Ssd1306Async::new(wires.clone(), DisplaySize128x64, DisplayRotation::Rotate0);
        display
            .init_with_addr_mode(ssd1306::command::AddrMode::Horizontal)
            .await
            .unwrap();
        wires.take();
        let send = async |page: Page<'_>| {
            let top = page.area.top_left.y as u8;
            display.set_draw_area((0, top), (128, top + 8)).await?;
            display.draw(page.bytes).await
        };
        let pages = [&mut [0; 128][..], &mut [0; 128]];
        PictureLoop::new(area, BinaryColor::Off)
            .draw_pages_async(&mut [0; 128], pages, send, scene::<BinaryColor, LittleEndian>)
            .await
            .unwrap();
    });
    check_ssd1306(&wires, area);
}

/// Eight windows of a page each, and the bytes of the picture.
fn check_ssd1306(wires: &Wires, area: Rectangle) {
    let commands = wires.take();
    let pages: Vec<u8> = commands.iter().flat_map(|(_, data)| data.clone()).collect();
    let codes: Vec<u8> = commands.iter().map(|(code, _)| *code).collect();
    let windows: Vec<u8> = (0..8).flat_map(|page| [0x21, 0, 127, 0x22, page, page]).collect();
    assert_eq!(codes, windows);
    assert!(pages == vertical_bytes(area));
}

/// Its memory has 132 columns, the panel shows those from the third on; three commands of their own set a page and a column.
#[test]
fn sh1106_in_pages() {
    use sh1106::{displayrotation::DisplayRotation, displaysize::DisplaySize, interface::SpiInterface};

    let wires = Wires::default();
    let interface = SpiInterface::new(wires.clone(), wires.clone(), Unused);
    let mut display =
        sh1106::properties::DisplayProperties::new(interface, DisplaySize::Display128x64, DisplayRotation::Rotate0);
    display.init_column_mode().unwrap();
    wires.take();
    let (area, mut row, mut page) = (box_of(128, 64), [0; 128], [0; 128]);
    let mut sink = PagesSink::new(area, &mut page, |page| {
        let top = page.area.top_left.y as u8;
        display.set_draw_area((2, top), (130, top + 8))?;
        display.draw(page.bytes)
    })
    .unwrap();
    PictureLoop::new(area, BinaryColor::Off)
        .draw(&mut row, &mut sink, scene::<BinaryColor, LittleEndian>)
        .unwrap();
    // Behind a page, the driver sets the address of its first column once more.
    let address = |page: u8| [0xb0 + page, 0x02, 0x10];
    let commands = wires.take();
    let codes: Vec<u8> = commands.iter().map(|(code, _)| *code).collect();
    assert_eq!(
        codes,
        (0..8)
            .flat_map(|page| [address(page), address(page)].concat())
            .collect::<Vec<u8>>()
    );
    let pages: Vec<u8> = commands.into_iter().flat_map(|(_, data)| data).collect();
    assert!(pages == vertical_bytes(area));
}

/// The picture in pages: a byte holds eight pixels of a column, the uppermost in its lowest bit.
fn vertical_bytes(area: Rectangle) -> Vec<u8> {
    let pixels = picture::<BinaryColor>(area);
    let width = area.size.width as usize;
    let byte = |index: usize| {
        let (page, column) = (index / width, index % width);
        let bit = |bit: usize| u8::from(pixels[(8 * page + bit) * width + column].is_on()) << bit;
        (0..8).map(bit).sum::<u8>()
    };
    (0..pixels.len() / 8).map(byte).collect()
}
