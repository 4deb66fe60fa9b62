//! Pages of eight rows: vertical bytes against the pixels of the full frame, and the controllers that they are for.

use std::{cell::RefCell, convert::Infallible, future::poll_fn, task::Poll};

use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray8},
    prelude::*,
    primitives::Rectangle,
};
use zrow::{
    band::{Band, Dithered, LittleEndian, LoopError, Page, PagesSink, PictureLoop, Sink},
    geometry::TooSmall,
};

use crate::{
    overlapping_loops::block_on,
    picture_loop::{AREA, ROWS, full_frame, scene},
};

/// Areas on and off the grid of pages, within one page, and as wide as several words, one and no pixel.
const AREAS: [((i32, i32), (u32, u32)); 9] = [
    ((0, 0), (128, 64)),
    ((-4, 3), (61, 45)),
    ((0, -5), (32, 5)),
    ((7, 8), (1, 8)),
    ((0, 9), (3, 6)),
    ((0, 7), (5, 2)),
    ((0, 15), (9, 1)),
    ((2, 0), (0, 8)),
    ((2, 0), (8, 0)),
];

fn area(((x, y), (width, height)): ((i32, i32), (u32, u32))) -> Rectangle {
    Rectangle::new(Point::new(x, y), Size::new(width, height))
}

/// The pages of the full frame, pixel by pixel.
fn expected_pages(area: Rectangle) -> Vec<(Rectangle, Vec<u8>)> {
    let pixels = full_frame::<BinaryColor, LittleEndian>(area);
    let (width, rows) = (area.size.width as usize, area.rows());
    if area.is_zero_sized() {
        return Vec::new();
    }
    let pages = rows.start.div_euclid(8)..=(rows.end - 1).div_euclid(8);
    let bytes = |page: i32| {
        let byte = |column: usize| {
            let is_on = |bit: &i32| {
                let y = page * 8 + bit;
                rows.contains(&y) && pixels[(y - rows.start) as usize * width + column].is_on()
            };
            (0..8).filter(is_on).map(|bit| 1 << bit).sum()
        };
        (0..width).map(byte).collect()
    };
    pages
        .map(|page| {
            let top_left = Point::new(area.top_left.x, page * 8);
            (Rectangle::new(top_left, Size::new(area.size.width, 8)), bytes(page))
        })
        .collect()
}

#[test]
fn bands_of_any_height_give_the_pages_of_the_full_frame() {
    for area in AREAS.map(area) {
        for rows in ROWS {
            let picture_loop = PictureLoop::new(area, BinaryColor::Off).rows(rows);
            let mut words = vec![1; picture_loop.words_needed()];
            // What was in the page must not show.
            let (mut page, mut pages) = (vec![0xff; area.size.width as usize], Vec::new());
            let mut sink = PagesSink::new(area, &mut page, |page| {
                pages.push((page.area, page.bytes.to_vec()));
                Ok::<(), Infallible>(())
            })
            .unwrap();
            picture_loop
                .draw(&mut words, &mut sink, scene::<BinaryColor, LittleEndian>)
                .unwrap();
            assert!(pages == expected_pages(area), "{area:?}, {rows} rows");
        }
    }
}

#[test]
fn other_columns_of_a_band_are_left_out() {
    let mut pages = Vec::new();
    let mut page = [0xff; 6];
    let mut sink = PagesSink::new(area(((2, 0), (6, 8))), &mut page, |page| {
        pages.push(page.bytes.to_vec());
        Ok::<(), Infallible>(())
    })
    .unwrap();
    let bands: [_; 5] = [
        ((0, 0), (10, 1)),
        ((-9, 1), (13, 1)),
        ((5, 2), (90, 1)),
        ((-9, 3), (9, 1)),
        ((8, 4), (1, 4)),
    ];
    for band in bands.map(area) {
        let mut words = vec![0xff; (band.size.width * band.size.height) as usize];
        let Ok(()) = sink.send(Band::<BinaryColor>::new(band, &mut words).unwrap());
    }
    assert_eq!(pages, [[3, 3, 1, 5, 5, 5]]);
}

#[test]
fn a_dithered_picture_goes_into_pages() {
    let area = area(((0, 0), (16, 8)));
    let (mut row, mut page) = ([0; 16], [0; 16]);
    let mut sent = Vec::new();
    let mut sink = Dithered::new(
        PagesSink::new(area, &mut page, |page| {
            sent.extend_from_slice(page.bytes);
            Ok::<(), Infallible>(())
        })
        .unwrap(),
    );
    PictureLoop::new(area, Gray8::new(128))
        .draw(&mut row, &mut sink, |_| {})
        .unwrap();
    assert_eq!(sent.iter().map(|byte| byte.count_ones()).sum::<u32>(), 64, "{sent:?}");
}

#[test]
fn too_few_bytes_are_an_error_that_says_how_many_would_do() {
    for bytes in 0..AREA.size.width as usize + 2 {
        let mut page = vec![0; bytes];
        let sink = PagesSink::new(AREA, &mut page, |_| Ok::<(), Infallible>(()));
        let needed = AREA.size.width as usize;
        assert_eq!(
            sink.err(),
            (bytes < needed).then_some(TooSmall::PageBytes(needed)),
            "{bytes}"
        );
    }
}

#[test]
fn pages_at_the_ends_of_the_number_range() {
    let [mut page, mut row] = [[0; 2], [0; 2]];
    for (top, height, expected) in [(i32::MIN, 3, 1), (i32::MAX - 3, 3, 1), (i32::MAX - 12, 12, 2)] {
        let area = area(((i32::MAX - 2, top), (2, height)));
        let mut pages = 0;
        let mut sink = PagesSink::new(area, &mut page, |page| {
            pages += 1;
            assert_eq!(page.area.top_left.y.rem_euclid(8), 0);
            page.ssd1306_window(255);
            page.sh1106_window(255);
            Ok::<(), Infallible>(())
        })
        .unwrap();
        PictureLoop::new(area, BinaryColor::On)
            .draw(&mut row, &mut sink, |_| {})
            .unwrap();
        assert_eq!(pages, expected);
    }
}

#[test]
fn window_commands_are_those_of_the_data_sheets() {
    let page = |left: i32, top: i32, bytes: &'static [u8]| Page {
        area: Rectangle::new(Point::new(left, top), Size::new(bytes.len() as u32, 8)),
        bytes,
    };
    let whole = page(0, 56, &[0; 128]);
    assert_eq!(whole.ssd1306_window(0), [0x21, 0, 127, 0x22, 7, 7]);
    assert_eq!(whole.sh1106_window(2), [0xb7, 0x02, 0x10]);
    let part = page(20, 8, &[0; 72]);
    assert_eq!(part.ssd1306_window(28), [0x21, 48, 119, 0x22, 1, 1]);
    assert_eq!(part.sh1106_window(2), [0xb1, 0x06, 0x11]);
}

/// The bytes on the wires of a panel: `(is_data, byte)`, up to one that fails.
#[derive(Default)]
struct Wires {
    bytes: Vec<(bool, u8)>,
    fails_at: Option<usize>,
}

impl Wires {
    fn send(&mut self, is_data: bool, bytes: &[u8]) -> Result<(), &'static str> {
        for &byte in bytes {
            if Some(self.bytes.len()) == self.fails_at {
                return Err("unplugged");
            }
            self.bytes.push((is_data, byte));
        }
        Ok(())
    }
}

/// The memory of a controller: 8 pages of 132 columns, noise before the first byte.
struct Controller {
    memory: [[u8; 132]; 8],
    columns: [u8; 2],
    page: u8,
    column: u8,
    /// The command whose arguments are still to come, and those that came.
    command: Vec<u8>,
}

impl Default for Controller {
    fn default() -> Self {
        Self {
            memory: [[0xa5; 132]; 8],
            columns: [0, 131],
            page: 0,
            column: 0,
            command: Vec::new(),
        }
    }
}

impl Controller {
    fn take(&mut self, wires: &Wires) {
        for &(is_data, byte) in &wires.bytes {
            if is_data {
                self.memory[usize::from(self.page)][usize::from(self.column)] = byte;
                self.column = if self.column == self.columns[1] {
                    self.columns[0]
                } else {
                    self.column + 1
                };
                continue;
            }
            self.command.push(byte);
            match self.command[..] {
                [0x21 | 0x22] | [0x21 | 0x22, _] => continue,
                [0x21, first, last] => (self.columns, self.column) = ([first, last], first),
                [0x22, first, last] => {
                    assert_eq!(first, last);
                    self.page = first;
                }
                [low @ 0x00..=0x0f] => self.column = self.column & 0xf0 | low,
                [high @ 0x10..=0x1f] => self.column = self.column & 0x0f | high << 4,
                [page @ 0xb0..=0xbf] => self.page = page & 0x0f,
                [..] => panic!("command {:x?}", self.command),
            }
            self.command.clear();
        }
    }

    /// The pixels of a panel.
    fn pixels(&self, panel: Rectangle, first_column: usize) -> Vec<BinaryColor> {
        let Size { width, height } = panel.size;
        let rows = (0..height as usize).flat_map(|y| (0..width as usize).map(move |x| (x, y)));
        rows.map(|(x, y)| BinaryColor::from(self.memory[y / 8][first_column + x] >> (y % 8) & 1 == 1))
            .collect()
    }
}

fn draw(panel: Rectangle, sh1106: bool, wires: &mut Wires) -> Result<(), LoopError<&'static str>> {
    let (mut row, mut page) = ([0; 128], [0; 128]);
    let mut sink = PagesSink::new(panel, &mut page, |page| {
        if sh1106 {
            wires.send(false, &page.sh1106_window(2))?;
        } else {
            wires.send(false, &page.ssd1306_window(0))?;
        }
        wires.send(true, page.bytes)
    })
    .unwrap();
    PictureLoop::new(panel, BinaryColor::Off).draw(&mut row, &mut sink, scene::<BinaryColor, LittleEndian>)
}

#[test]
fn both_controllers_show_the_full_frame() {
    let panel = area(((0, 0), (128, 64)));
    for (sh1106, bytes) in [(false, 8 * (6 + 128)), (true, 8 * (3 + 128))] {
        let (mut wires, mut controller) = (Wires::default(), Controller::default());
        assert_eq!(draw(panel, sh1106, &mut wires), Ok(()));
        assert_eq!(wires.bytes.len(), bytes);
        controller.take(&wires);
        let first_column = if sh1106 { 2 } else { 0 };
        assert!(controller.pixels(panel, first_column) == full_frame::<BinaryColor, LittleEndian>(panel));
    }
}

/// Whatever byte a frame breaks off at, the next one is whole. A controller that still waits for the rest of a command
/// has to be reset for that, which nothing on the wires tells it otherwise.
#[test]
fn a_frame_after_a_fault_at_any_byte_is_whole() {
    let panel = area(((0, 0), (20, 16)));
    let picture = full_frame::<BinaryColor, LittleEndian>(panel);
    for sh1106 in [false, true] {
        let mut whole = Wires::default();
        assert_eq!(draw(panel, sh1106, &mut whole), Ok(()));
        for fails_at in 0..whole.bytes.len() {
            let mut wires = Wires {
                fails_at: Some(fails_at),
                ..Wires::default()
            };
            assert_eq!(draw(panel, sh1106, &mut wires), Err(LoopError::Sink("unplugged")));
            assert!(
                wires.bytes == whole.bytes[..fails_at],
                "nothing is sent after the failure"
            );
            let mut controller = Controller::default();
            controller.take(&wires);
            if !controller.command.is_empty() {
                controller = Controller::default();
            }
            let mut next = Wires::default();
            assert_eq!(draw(panel, sh1106, &mut next), Ok(()));
            assert!(next.bytes == whole.bytes);
            controller.take(&next);
            assert!(controller.pixels(panel, if sh1106 { 2 } else { 0 }) == picture);
        }
    }
}

/// Waits until it has been polled so many times.
async fn polled(mut times: usize) {
    poll_fn(|context| {
        context.waker().wake_by_ref();
        let is_ready = times == 0;
        times = times.saturating_sub(1);
        if is_ready { Poll::Ready(()) } else { Poll::Pending }
    })
    .await;
}

#[test]
fn pages_by_futures_are_those_of_the_full_frame() {
    for area in AREAS.map(area) {
        for (rows, polls) in ROWS.into_iter().flat_map(|rows| [0, 1, 3].map(|polls| (rows, polls))) {
            let picture_loop = PictureLoop::new(area, BinaryColor::Off).rows(rows);
            let mut words = vec![1; picture_loop.words_needed() + 1];
            // Longer than needed; what is in the pages must not show.
            let mut pages = [0xff, 0xaa].map(|byte| vec![byte; area.size.width as usize + 2]);
            let mut sent = Vec::new();
            let send = async |page: Page<'_>| {
                polled(polls).await;
                sent.push((page.area, page.bytes.to_vec()));
                Ok::<(), Infallible>(())
            };
            let pages = pages.each_mut().map(|page| &mut page[..]);
            let drawing = picture_loop.draw_pages_async(&mut words, pages, send, scene::<BinaryColor, LittleEndian>);
            block_on(drawing).unwrap();
            assert!(sent == expected_pages(area), "{area:?}, {rows} rows, {polls} polls");
        }
    }
}

/// An event while a picture of three pages is drawn and sent.
#[derive(Debug, PartialEq)]
enum Event {
    /// A band is drawn, from this row on.
    Drawn(i32),
    /// The transfer of a page is begun, which begins in this row.
    Begun(i32),
    Sent(i32),
}

/// Draws rows 5 to 20, and logs what happens; the scene fails in one row, the transfer in another.
fn logged(rows: u32, fails: [Option<i32>; 2]) -> (Vec<Event>, Result<(), LoopError<&'static str, &'static str>>) {
    let log = RefCell::new(Vec::new());
    let [scene_fails, send_fails] = fails;
    let fail = |at: Option<i32>, row: i32| if at == Some(row) { Err("no") } else { Ok(()) };
    let send = async |page: Page<'_>| {
        let row = page.area.top_left.y;
        log.borrow_mut().push(Event::Begun(row));
        polled(2).await;
        fail(send_fails, row)?;
        log.borrow_mut().push(Event::Sent(row));
        Ok(())
    };
    let scene = |band: &mut Band<'_, BinaryColor>| {
        let row = band.bounding_box().top_left.y;
        log.borrow_mut().push(Event::Drawn(row));
        fail(scene_fails, row)
    };
    let picture_loop = PictureLoop::new(area(((0, 5), (4, 16))), BinaryColor::Off).rows(rows);
    let (mut words, mut pages) = (vec![0; picture_loop.words_needed()], [[0; 4]; 2]);
    let pages = pages.each_mut().map(|page| &mut page[..]);
    let result = block_on(picture_loop.draw_pages_async(&mut words, pages, send, scene));
    (log.into_inner(), result)
}

#[test]
fn the_next_page_is_drawn_while_one_is_sent() {
    use Event::{Begun, Drawn, Sent};
    let (log, result) = logged(1, [None; 2]);
    assert_eq!(result, Ok(()));
    let mut expected: Vec<_> = (5..8).map(Drawn).collect();
    expected.push(Begun(0));
    expected.extend((8..16).map(Drawn));
    expected.extend([Sent(0), Begun(8)]);
    expected.extend((16..21).map(Drawn));
    expected.extend([Sent(8), Begun(16), Sent(16)]);
    assert_eq!(log, expected);
    // Bands with the ends of two pages and of one.
    let (log, result) = logged(12, [None; 2]);
    assert_eq!(result, Ok(()));
    let pages = [
        Drawn(5),
        Begun(0),
        Sent(0),
        Begun(8),
        Drawn(17),
        Sent(8),
        Begun(16),
        Sent(16),
    ];
    assert_eq!(log, pages);
}

#[test]
fn a_loop_of_pages_that_fails_sends_nothing_more() {
    use Event::{Begun, Drawn, Sent};
    // The page before the row is whole, and is sent.
    let (log, result) = logged(1, [Some(9), None]);
    assert_eq!(result, Err(LoopError::Scene("no")));
    assert_eq!(
        log,
        [Drawn(5), Drawn(6), Drawn(7), Begun(0), Drawn(8), Drawn(9), Sent(0)]
    );
    let (log, result) = logged(8, [None, Some(8)]);
    assert_eq!(result, Err(LoopError::Sink("no")));
    assert_eq!(log, [Drawn(5), Begun(0), Drawn(13), Sent(0), Begun(8)]);
    let (log, result) = logged(1, [Some(5), None]);
    assert_eq!((log, result), (vec![Drawn(5)], Err(LoopError::Scene("no"))));
}

#[test]
fn too_small_buffers_of_pages_are_errors_before_anything_is_drawn() {
    let picture_loop = PictureLoop::new(AREA, BinaryColor::Off).rows(2);
    let width = AREA.size.width as usize;
    for lengths in [
        [2 * width - 1, 0, 0],
        [2 * width, width - 1, width],
        [2 * width, width, width - 1],
    ] {
        let [mut words, mut page, mut other] = lengths.map(|length| vec![0; length]);
        let send = async |_: Page<'_>| -> Result<(), Infallible> { panic!("sent") };
        let scene = |_: &mut Band<'_, BinaryColor>| -> Result<(), Infallible> { panic!("drawn") };
        let result = block_on(picture_loop.draw_pages_async(&mut words, [&mut page, &mut other], send, scene));
        let needed = if lengths[0] < 2 * width {
            TooSmall::Words(2 * width)
        } else {
            TooSmall::PageBytes(width)
        };
        assert_eq!(result, Err(LoopError::TooSmall(needed)));
    }
}
