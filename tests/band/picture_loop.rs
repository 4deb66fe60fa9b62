//! The picture loop, its sinks and the band: banded drawing equals the full frame, and errors leave everything whole.

use std::{
    cell::RefCell,
    convert::Infallible,
    future::Future,
    pin::Pin,
    sync::{
        Arc,
        atomic::{AtomicUsize, Ordering},
    },
    task::{Context, Poll, Wake, Waker},
};

use embedded_graphics::{
    Pixel,
    image::{Image, ImageRaw},
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{
        Bgr565, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb888,
        raw::{RawData, ToBytes},
    },
    prelude::*,
    primitives::{self, Circle, Line, Rectangle, RoundedRectangle, Triangle},
    text::Text,
};
use zrow::{
    band::{AsyncSink, Band, Blocking, BytesSink, DisplaySink, LoopError, OverlappingSink, PictureLoop, Sink},
    draw::{DrawOn, PrimitiveStyle},
    geometry::{Table, TooSmall},
    surface::{BandColor, BigEndian, Native, Order},
};

const AREA: Rectangle = Rectangle::new(Point::new(-4, 3), Size::new(61, 45));
const ROWS: [u32; 5] = [1, 2, 7, 16, 45];

/// A colour with four values for the scene; the first is the background.
trait SceneColor: BandColor + From<BinaryColor> + core::fmt::Debug {
    const COLORS: [Self; 4];
}

macro_rules! scene_color {
    ($($color:ty: [$($value:expr),+];)+) => {$(
        impl SceneColor for $color {
            const COLORS: [Self; 4] = [$($value),+];
        }
    )+};
}

scene_color! {
    BinaryColor: [BinaryColor::Off, BinaryColor::On, BinaryColor::On, BinaryColor::On];
    Gray2: [Gray2::new(1), Gray2::new(3), Gray2::new(2), Gray2::new(0)];
    Gray4: [Gray4::new(1), Gray4::new(15), Gray4::new(7), Gray4::new(4)];
    Gray8: [Gray8::new(9), Gray8::new(255), Gray8::new(100), Gray8::new(50)];
    Rgb555: [Rgb555::BLACK, Rgb555::new(1, 2, 3), Rgb555::GREEN, Rgb555::YELLOW];
    Rgb565: [Rgb565::BLUE, Rgb565::new(1, 2, 3), Rgb565::GREEN, Rgb565::YELLOW];
    Bgr565: [Bgr565::BLUE, Bgr565::new(1, 2, 3), Bgr565::GREEN, Bgr565::YELLOW];
    Rgb888: [Rgb888::BLUE, Rgb888::new(1, 2, 3), Rgb888::GREEN, Rgb888::YELLOW];
}

/// Lines of ours; text, an image and shapes of embedded-graphics in its own styles. Some of it lies outside.
fn scene<C: SceneColor, O: Order>(band: &mut Band<'_, C, O>) {
    let [_, one, two, three] = C::COLORS;
    let style = primitives::PrimitiveStyleBuilder::new()
        .fill_color(two)
        .stroke_color(three)
        .stroke_width(2)
        .build();
    let Ok(()) = Circle::new(Point::new(20, 12), 27).into_styled(style).draw(band);
    let Ok(()) = Triangle::new(Point::new(-9, 30), Point::new(12, 44), Point::new(2, 60))
        .into_styled(style)
        .draw(band);
    band.draw(
        &RoundedRectangle::with_equal_corners(Rectangle::new(Point::new(40, 30), Size::new(30, 9)), Size::new(4, 3))
            .into_styled(style),
    );
    for (from, to) in [
        ((-4, 3), (56, 47)),
        ((-90, 20), (90, 11)),
        ((30, -400), (33, 400)),
        ((0, 0), (9, -9)),
    ] {
        let line = Line::new(from.into(), to.into()).into_styled(PrimitiveStyle::with_stroke(one, 1));
        let Ok(()) = line.draw_on(band);
    }
    let Ok(_) = Text::new("zrow\nrows", Point::new(-2, 12), MonoTextStyle::new(&FONT_6X10, three)).draw(band);
    const BITS: [u8; 6] = [
        0b1010_1010,
        0b1100_0011,
        0b1111_0000,
        0b0000_1111,
        0b0101_0101,
        0b1001_1001,
    ];
    let image = ImageRaw::<BinaryColor>::new(&BITS, 12);
    let Ok(()) = Image::new(&image, Point::new(50, 20)).draw(&mut band.color_converted());
}

/// The scene in one band that holds the whole picture.
fn full_frame<C: SceneColor, O: Order>(area: Rectangle) -> Vec<C> {
    let mut words = vec![C::COLORS[0].to_word(); (area.size.width * area.size.height) as usize];
    let mut band = Band::<C, O>::new(area, &mut words).unwrap();
    band.fill(C::COLORS[0]);
    scene(&mut band);
    band.colors().collect()
}

fn picture_loop<C: SceneColor, O: Order>(rows: u32) -> PictureLoop<C, O> {
    PictureLoop::new(AREA, C::COLORS[0]).rows(rows).in_order()
}

fn buffer<C: SceneColor, O: Order>(picture_loop: &PictureLoop<C, O>) -> Vec<C::Word> {
    // What was in the buffer must not show.
    vec![C::COLORS[3].to_word(); picture_loop.words_needed()]
}

fn check_equals_full_frame<C: SceneColor, O: Order>() {
    let expected = full_frame::<C, O>(AREA);
    assert!(
        C::COLORS.iter().all(|color| expected.contains(color)),
        "the scene shows every colour"
    );
    for rows in ROWS {
        let picture_loop = picture_loop::<C, O>(rows);
        let (mut picture, mut areas) = (Vec::new(), Vec::new());
        let mut sink = |band: Band<'_, C, O>| {
            areas.push(band.bounding_box());
            picture.extend(band.colors());
            Ok::<(), Infallible>(())
        };
        picture_loop
            .draw(&mut buffer(&picture_loop), &mut sink, scene::<C, O>)
            .unwrap();
        assert!(picture == expected, "{rows} rows");
        assert_eq!(areas, picture_loop.bands().collect::<Vec<_>>());
        let heights: Vec<u32> = areas.iter().map(|area| area.size.height).collect();
        let (last, others) = heights.split_last().unwrap();
        assert!(others.iter().all(|&height| height == rows));
        assert_eq!(*last, (45 - 1) % rows + 1, "the last band holds the rest");
    }
}

#[test]
fn bands_of_any_height_give_the_full_frame() {
    check_equals_full_frame::<Rgb565, Native>();
    check_equals_full_frame::<Rgb565, BigEndian>();
    check_equals_full_frame::<Bgr565, BigEndian>();
    check_equals_full_frame::<Rgb555, Native>();
    check_equals_full_frame::<Rgb888, Native>();
    check_equals_full_frame::<Rgb888, BigEndian>();
    check_equals_full_frame::<Gray8, Native>();
    check_equals_full_frame::<Gray4, BigEndian>();
    check_equals_full_frame::<Gray2, Native>();
    check_equals_full_frame::<BinaryColor, Native>();
}

#[test]
fn alignment_grows_outwards_and_rounds_the_rows_up() {
    let area = Rectangle::new(Point::new(-3, 5), Size::new(50, 36));
    let bands = |picture_loop: PictureLoop<Rgb565>| -> Vec<(i32, i32, u32, u32)> {
        picture_loop
            .bands()
            .map(|band| (band.top_left.x, band.top_left.y, band.size.width, band.size.height))
            .collect()
    };
    let picture_loop = PictureLoop::new(area, Rgb565::BLACK);
    let pages = vec![(-4, 0, 52, 16), (-4, 16, 52, 16), (-4, 32, 52, 16)];
    assert_eq!(bands(picture_loop.rows(9).aligned(4, 8)), pages);
    assert_eq!(bands(picture_loop.aligned(4, 8).rows(9)), pages);
    assert_eq!(picture_loop.aligned(4, 8).rows(9).words_needed(), 52 * 16);

    let pages: Vec<_> = (0..6).map(|page| (-3, page * 8, 50, 8)).collect();
    assert_eq!(bands(picture_loop.aligned(0, 8)), pages);
    let last_is_lower = vec![(-4, 5, 52, 20), (-4, 25, 52, 16)];
    assert_eq!(bands(picture_loop.aligned(2, 1).rows(20)), last_is_lower);
    assert_eq!(
        bands(picture_loop.aligned(2, 8).rows(32)).last(),
        Some(&(-4, 32, 52, 16))
    );
}

#[test]
fn the_buffer_must_hold_one_band_and_no_more() {
    let picture_loop = picture_loop::<Rgb565, _>(7);
    assert_eq!(picture_loop.words_needed(), 61 * 7);
    let mut words = vec![0; 61 * 7];
    let mut sink = |_: Band<'_, Rgb565>| Ok::<(), Infallible>(());
    assert_eq!(picture_loop.draw(&mut words, &mut sink, scene), Ok(()));
    words.pop();
    let needed = TooSmall {
        table: Table::Words,
        needed: 61 * 7,
    };
    assert_eq!(
        picture_loop.draw(&mut words, &mut sink, |_| -> () {
            panic!("drawn into a buffer that is too small")
        }),
        Err(LoopError::TooSmall(needed))
    );
    let (buffers, result) =
        picture_loop.draw_overlapping([vec![0; 61 * 7], words.clone()], &mut Blocking(&mut sink), |_| -> () {
            panic!("drawn although one buffer is too small")
        });
    assert_eq!(result, Err(LoopError::TooSmall(needed)));
    assert_eq!(buffers.map(|buffer| buffer.len()), [61 * 7, 61 * 7 - 1]);
    assert_eq!(Band::<Rgb565>::new(AREA, &mut words).unwrap_err().needed, 61 * 45);
    // The whole picture is lower than the band: it is enough for that.
    assert_eq!(picture_loop.rows(1000).words_needed(), 61 * 45);
    assert_eq!(
        PictureLoop::new(Rectangle::zero(), Rgb565::BLACK)
            .rows(9)
            .words_needed(),
        0
    );
}

#[test]
fn an_empty_area_sends_nothing() {
    let picture_loop = PictureLoop::new(Rectangle::new(Point::new(3, 3), Size::new(0, 9)), Rgb565::BLACK);
    let mut sink = |_: Band<'_, Rgb565>| Err("sent");
    assert_eq!(
        picture_loop.draw(&mut [], &mut sink, |_| -> () { panic!("drawn") }),
        Ok(())
    );
}

/// A sink that keeps the picture and fails at one band of the first picture.
struct Recorder<C> {
    picture: Vec<C>,
    sent: usize,
    fails_at: Option<usize>,
}

impl<C> Recorder<C> {
    fn failing_at(band: usize) -> Self {
        Self {
            picture: Vec::new(),
            sent: 0,
            fails_at: Some(band),
        }
    }
}

impl<C: BandColor, O: Order> Sink<C, O> for Recorder<C> {
    type Error = &'static str;

    fn send(&mut self, band: Band<'_, C, O>) -> Result<(), &'static str> {
        if self.fails_at == Some(self.sent) {
            self.fails_at = None;
            return Err("unplugged");
        }
        self.sent += 1;
        self.picture.extend(band.colors());
        Ok(())
    }
}

#[test]
fn a_sink_that_fails_stops_the_loop_and_the_next_picture_is_whole() {
    let picture_loop = picture_loop::<Rgb565, _>(7);
    let mut words = buffer(&picture_loop);
    for fails_at in [0, 3, 6] {
        let mut sink = Recorder::failing_at(fails_at);
        let mut drawn = 0;
        let result = picture_loop.draw(&mut words, &mut sink, |band: &mut Band<'_, Rgb565>| {
            drawn += 1;
            scene(band);
        });
        assert_eq!(result, Err(LoopError::Sink("unplugged")));
        assert_eq!(
            (sink.sent, drawn),
            (fails_at, fails_at + 1),
            "nothing is drawn or sent after the failure"
        );
        sink.picture.clear();
        assert_eq!(
            picture_loop.draw(&mut words, &mut sink, scene::<Rgb565, Native>),
            Ok(())
        );
        assert!(sink.picture == full_frame::<Rgb565, Native>(AREA));
    }
}

/// A display that counts how it is written to.
struct Counting {
    area: Rectangle,
    picture: Vec<Rgb565>,
    fills: Vec<Rectangle>,
}

impl Dimensions for Counting {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Counting {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, _: I) -> Result<(), Infallible> {
        panic!("a band goes out in one piece");
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        self.fills.push(*area);
        self.picture.extend(colors);
        Ok(())
    }

    fn fill_solid(&mut self, _: &Rectangle, _: Rgb565) -> Result<(), Infallible> {
        panic!("a band goes out in one piece");
    }
}

#[test]
fn a_display_gets_one_fill_contiguous_a_band() {
    for rows in ROWS {
        let mut display = Counting {
            area: AREA,
            picture: Vec::new(),
            fills: Vec::new(),
        };
        let picture_loop = picture_loop(rows);
        picture_loop
            .draw(
                &mut buffer(&picture_loop),
                &mut DisplaySink(&mut display),
                scene::<Rgb565, BigEndian>,
            )
            .unwrap();
        assert!(display.picture == full_frame::<Rgb565, Native>(AREA));
        assert_eq!(display.fills, picture_loop.bands().collect::<Vec<_>>());
    }
}

/// The bytes of a row as the documentation of `into_bytes` describes them, pixel by pixel.
fn packed_row<C>(row: &[C]) -> Vec<u8>
where
    C: SceneColor + ToBytes + Into<<C as PixelColor>::Raw>,
    <C as ToBytes>::Bytes: AsRef<[u8]>,
    u32: From<<<C as PixelColor>::Raw as RawData>::Storage>,
{
    let bits = <C as PixelColor>::Raw::BITS_PER_PIXEL;
    if bits >= 8 {
        return row
            .iter()
            .flat_map(|&color| color.to_be_bytes().as_ref().to_vec())
            .collect();
    }
    let mut bytes = vec![0u8; (row.len() * bits).div_ceil(8)];
    for (column, &color) in row.iter().enumerate() {
        let value = u32::from(color.into().into_inner());
        for bit in 0..bits {
            if value >> (bits - 1 - bit) & 1 == 1 {
                let place = column * bits + bit;
                bytes[place / 8] |= 0x80 >> (place % 8);
            }
        }
    }
    bytes
}

fn check_bytes<C, O: Order>()
where
    C: SceneColor + ToBytes + Into<<C as PixelColor>::Raw>,
    <C as ToBytes>::Bytes: AsRef<[u8]>,
    u32: From<<<C as PixelColor>::Raw as RawData>::Storage>,
{
    let expected: Vec<u8> = full_frame::<C, O>(AREA).chunks(61).flat_map(packed_row).collect();
    for rows in ROWS {
        let picture_loop = picture_loop::<C, O>(rows);
        let (mut bytes, mut areas) = (Vec::new(), Vec::new());
        let mut sink = BytesSink(|area: Rectangle, band: &[u8]| {
            areas.push(area);
            bytes.extend_from_slice(band);
            Ok::<(), Infallible>(())
        });
        picture_loop
            .draw(&mut buffer(&picture_loop), &mut sink, scene::<C, O>)
            .unwrap();
        assert!(bytes == expected, "{rows} rows");
        assert_eq!(areas, picture_loop.bands().collect::<Vec<_>>());
    }
}

#[test]
fn bytes_are_packed_for_the_display() {
    check_bytes::<BinaryColor, Native>();
    check_bytes::<Gray2, BigEndian>();
    check_bytes::<Gray4, Native>();
    check_bytes::<Gray8, Native>();
    check_bytes::<Rgb555, BigEndian>();
    check_bytes::<Rgb565, Native>();
    check_bytes::<Rgb565, BigEndian>();
    check_bytes::<Bgr565, Native>();
    check_bytes::<Rgb888, Native>();
    check_bytes::<Rgb888, BigEndian>();
}

/// What happened, in order; bands by their top row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Event {
    Drawn(i32),
    Started(i32),
    Finished(i32),
    Polled(i32),
}

type Log = RefCell<Vec<Event>>;

/// A buffer that can be told from another one.
#[derive(Debug)]
struct Buffer {
    name: char,
    words: Vec<u16>,
}

impl AsMut<[u16]> for Buffer {
    fn as_mut(&mut self) -> &mut [u16] {
        &mut self.words
    }
}

fn buffers<O: Order>(picture_loop: &PictureLoop<Rgb565, O>) -> [Buffer; 2] {
    ['a', 'b'].map(|name| Buffer {
        name,
        words: buffer(picture_loop),
    })
}

/// DMA: the transfer owns the buffer, and what the display gets is read at the end.
struct Dma<'a> {
    log: &'a Log,
    picture: Vec<u16>,
    start_fails_at: Option<i32>,
    finish_fails_at: Option<i32>,
    under_way: usize,
}

impl<'a> Dma<'a> {
    fn new(log: &'a Log) -> Self {
        Self {
            log,
            picture: Vec::new(),
            start_fails_at: None,
            finish_fails_at: None,
            under_way: 0,
        }
    }
}

impl OverlappingSink<Rgb565, BigEndian, Buffer> for Dma<'_> {
    type Transfer = (Rectangle, Buffer);
    type Error = &'static str;

    fn start(&mut self, area: Rectangle, buffer: Buffer) -> Result<Self::Transfer, (Buffer, LoopError<&'static str>)> {
        let y = area.top_left.y;
        if self.start_fails_at.take_if(|fails_at| *fails_at == y).is_some() {
            return Err((buffer, LoopError::Sink("start")));
        }
        self.log.borrow_mut().push(Event::Started(y));
        self.under_way += 1;
        Ok((area, buffer))
    }

    fn finish(&mut self, (area, buffer): Self::Transfer) -> (Buffer, Result<(), &'static str>) {
        let y = area.top_left.y;
        self.log.borrow_mut().push(Event::Finished(y));
        self.under_way -= 1;
        if self.finish_fails_at.take_if(|fails_at| *fails_at == y).is_some() {
            return (buffer, Err("finish"));
        }
        let words = (area.size.width * area.size.height) as usize;
        self.picture.extend_from_slice(&buffer.words[..words]);
        (buffer, Ok(()))
    }
}

fn logged_scene(log: &Log) -> impl FnMut(&mut Band<'_, Rgb565, BigEndian>) {
    |band| {
        log.borrow_mut().push(Event::Drawn(band.bounding_box().top_left.y));
        scene(band);
    }
}

fn full_frame_words() -> Vec<u16> {
    full_frame::<Rgb565, Native>(AREA)
        .into_iter()
        .map(|color| color.into_storage().to_be())
        .collect()
}

#[test]
fn the_next_band_is_drawn_while_one_is_sent() {
    for rows in ROWS {
        let log = Log::default();
        let mut sink = Dma::new(&log);
        let picture_loop = picture_loop(rows);
        let (buffers, result) = picture_loop.draw_overlapping(buffers(&picture_loop), &mut sink, logged_scene(&log));
        assert_eq!(result, Ok(()));
        assert_ne!(buffers[0].name, buffers[1].name);
        assert!(sink.picture == full_frame_words(), "{rows} rows");

        let tops: Vec<i32> = picture_loop.bands().map(|area| area.top_left.y).collect();
        let mut expected = vec![Event::Drawn(tops[0])];
        for (index, &top) in tops.iter().enumerate() {
            expected.push(Event::Started(top));
            expected.extend(tops.get(index + 1).map(|&next| Event::Drawn(next)));
            expected.push(Event::Finished(top));
        }
        assert_eq!(*log.borrow(), expected);
    }
}

#[test]
fn a_transfer_that_fails_gives_both_buffers_back() {
    let picture_loop = picture_loop(7);
    let tops: Vec<i32> = picture_loop.bands().map(|area| area.top_left.y).collect();
    for (at_start, band) in [(true, 0), (true, 3), (true, 6), (false, 0), (false, 3), (false, 6)] {
        let log = Log::default();
        let mut sink = Dma::new(&log);
        let fails_at = if at_start {
            &mut sink.start_fails_at
        } else {
            &mut sink.finish_fails_at
        };
        *fails_at = Some(tops[band]);
        let (buffers, result) = picture_loop.draw_overlapping(buffers(&picture_loop), &mut sink, logged_scene(&log));
        assert_eq!(result, Err(LoopError::Sink(if at_start { "start" } else { "finish" })));
        assert_eq!(sink.under_way, 0, "no transfer is under way");
        let mut names = buffers.each_ref().map(|buffer| buffer.name);
        names.sort();
        assert_eq!(names, ['a', 'b']);
        let started = log
            .borrow()
            .iter()
            .filter(|event| matches!(event, Event::Started(_)))
            .count();
        assert_eq!(
            started,
            if at_start { band } else { band + 1 },
            "nothing is sent after the failure"
        );

        sink.picture.clear();
        let (_, result) = picture_loop.draw_overlapping(buffers, &mut sink, logged_scene(&log));
        assert_eq!(result, Ok(()));
        assert!(sink.picture == full_frame_words(), "the next picture is whole");
    }
}

#[test]
fn blocking_transfers_give_the_plain_picture() {
    for rows in ROWS {
        let picture_loop = picture_loop::<Rgb888, _>(rows);
        let mut picture = Vec::new();
        let mut sink = Blocking(|band: Band<'_, Rgb888, BigEndian>| {
            picture.extend(band.colors());
            Ok::<(), Infallible>(())
        });
        let buffers = [buffer(&picture_loop), buffer(&picture_loop)];
        let (_, result) = picture_loop.draw_overlapping(buffers, &mut sink, scene::<Rgb888, BigEndian>);
        assert_eq!(result, Ok(()));
        assert!(picture == full_frame::<Rgb888, BigEndian>(AREA));
    }
    let picture_loop = picture_loop::<Rgb565, _>(7);
    let mut sink = Blocking(Recorder::failing_at(2));
    let buffers = [buffer(&picture_loop), buffer(&picture_loop)];
    let (buffers, result) = picture_loop.draw_overlapping(buffers, &mut sink, scene::<Rgb565, Native>);
    assert_eq!(result, Err(LoopError::Sink("unplugged")));
    assert_eq!(buffers.map(|buffer| buffer.len()), [61 * 7, 61 * 7]);
    let too_small: Result<Vec<u16>, _> = OverlappingSink::<Rgb565, Native, _>::start(&mut sink, AREA, vec![0; 9]);
    let needed = TooSmall {
        table: Table::Words,
        needed: 61 * 45,
    };
    assert_eq!(too_small, Err((vec![0; 9], LoopError::TooSmall(needed))));
}

/// A transfer that is pending for some polls and then takes the bytes.
struct Pending<'a> {
    remaining: usize,
    y: i32,
    bytes: &'a [u8],
    sink: &'a RefCell<AsyncState>,
    log: &'a Log,
}

#[derive(Default)]
struct AsyncState {
    bytes: Vec<u8>,
    fails_at: Option<i32>,
}

impl Future for Pending<'_> {
    type Output = Result<(), &'static str>;

    fn poll(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Self::Output> {
        self.log.borrow_mut().push(Event::Polled(self.y));
        if self.remaining > 0 {
            self.remaining -= 1;
            context.waker().wake_by_ref();
            return Poll::Pending;
        }
        self.log.borrow_mut().push(Event::Finished(self.y));
        let mut state = self.sink.borrow_mut();
        let y = self.y;
        if state.fails_at.take_if(|fails_at| *fails_at == y).is_some() {
            return Poll::Ready(Err("unplugged"));
        }
        state.bytes.extend_from_slice(self.bytes);
        Poll::Ready(Ok(()))
    }
}

struct PendingSink<'a> {
    state: RefCell<AsyncState>,
    log: &'a Log,
    polls: usize,
}

impl AsyncSink for PendingSink<'_> {
    type Error = &'static str;

    async fn send(&mut self, area: Rectangle, bytes: &[u8]) -> Result<(), &'static str> {
        let transfer = Pending {
            remaining: self.polls,
            y: area.top_left.y,
            bytes,
            sink: &self.state,
            log: self.log,
        };
        transfer.await
    }
}

/// Counts how often it is woken.
#[derive(Default)]
struct Wakes(AtomicUsize);

impl Wake for Wakes {
    fn wake(self: Arc<Self>) {
        self.0.fetch_add(1, Ordering::Relaxed);
    }
}

/// Polls a future to its end, and only when it has asked for it.
fn block_on<T>(future: impl Future<Output = T>) -> T {
    let wakes = Arc::new(Wakes::default());
    let waker = Waker::from(wakes.clone());
    let mut future = Box::pin(future);
    loop {
        if let Poll::Ready(output) = future.as_mut().poll(&mut Context::from_waker(&waker)) {
            return output;
        }
        assert_ne!(
            wakes.0.swap(0, Ordering::Relaxed),
            0,
            "pending without a wake-up: would sleep forever"
        );
    }
}

fn draw_async(
    picture_loop: &PictureLoop<Rgb565, BigEndian>,
    sink: &mut PendingSink<'_>,
) -> Result<(), LoopError<&'static str>> {
    let (mut one, mut other) = (buffer(picture_loop), buffer(picture_loop));
    let log = sink.log;
    block_on(picture_loop.draw_async([&mut one, &mut other], sink, logged_scene(log)))
}

fn full_frame_bytes() -> Vec<u8> {
    full_frame::<Rgb565, Native>(AREA)
        .into_iter()
        .flat_map(|color| color.to_be_bytes())
        .collect()
}

#[test]
fn the_async_loop_draws_while_a_transfer_is_pending() {
    for polls in [0, 1, 4] {
        for rows in ROWS {
            let log = Log::default();
            let picture_loop = picture_loop(rows);
            let mut sink = PendingSink {
                state: RefCell::default(),
                log: &log,
                polls,
            };
            assert_eq!(draw_async(&picture_loop, &mut sink), Ok(()));
            assert!(
                sink.state.borrow().bytes == full_frame_bytes(),
                "{polls} polls, {rows} rows"
            );

            let tops: Vec<i32> = picture_loop.bands().map(|area| area.top_left.y).collect();
            let mut expected = vec![Event::Drawn(tops[0])];
            for (index, &top) in tops.iter().enumerate() {
                let next = tops.get(index + 1).map(|&next| Event::Drawn(next));
                expected.push(Event::Polled(top));
                if polls == 0 {
                    expected.push(Event::Finished(top));
                    expected.extend(next);
                } else {
                    expected.extend(next);
                    expected.extend(vec![Event::Polled(top); polls]);
                    expected.push(Event::Finished(top));
                }
            }
            assert_eq!(*log.borrow(), expected);
        }
    }
}

#[test]
fn an_async_transfer_that_fails_stops_the_loop_and_the_next_picture_is_whole() {
    let picture_loop = picture_loop(7);
    for polls in [0, 2] {
        for area in picture_loop.bands() {
            let log = Log::default();
            let mut sink = PendingSink {
                state: RefCell::default(),
                log: &log,
                polls,
            };
            sink.state.borrow_mut().fails_at = Some(area.top_left.y);
            assert_eq!(draw_async(&picture_loop, &mut sink), Err(LoopError::Sink("unplugged")));
            assert_eq!(
                log.borrow().iter().rfind(|event| matches!(event, Event::Finished(_))),
                Some(&Event::Finished(area.top_left.y))
            );
            sink.state.borrow_mut().bytes.clear();
            assert_eq!(draw_async(&picture_loop, &mut sink), Ok(()));
            assert!(sink.state.borrow().bytes == full_frame_bytes());
        }
    }
    let log = Log::default();
    let mut sink = PendingSink {
        state: RefCell::default(),
        log: &log,
        polls: 1,
    };
    let (mut one, mut other) = (vec![0; 61 * 7], vec![0; 61 * 7 - 1]);
    let result = block_on(picture_loop.draw_async([&mut one, &mut other], &mut sink, logged_scene(&log)));
    assert_eq!(
        result,
        Err(LoopError::TooSmall(TooSmall {
            table: Table::Words,
            needed: 61 * 7
        }))
    );
    assert!(log.borrow().is_empty());
}

/// The rows of the bands that a display has got until a scene fails in one of them: those before it, whole.
#[test]
fn a_scene_that_fails_ends_the_loop() {
    let picture_loop: PictureLoop<Rgb565, BigEndian> = picture_loop(7);
    let areas: Vec<Rectangle> = picture_loop.bands().collect();
    for (failing, area) in areas.iter().enumerate() {
        let failing_scene = |band: &mut Band<'_, Rgb565, BigEndian>| {
            scene(band);
            if band.bounding_box() == *area {
                Err("no")
            } else {
                Ok(())
            }
        };
        let pixels = areas[..failing]
            .iter()
            .map(|area| area.size.width * area.size.height)
            .sum::<u32>() as usize;

        let mut sent = Vec::new();
        let mut sink = |band: Band<'_, Rgb565, BigEndian>| {
            sent.extend_from_slice(band.words());
            Ok::<(), Infallible>(())
        };
        let result = picture_loop.draw(&mut buffer(&picture_loop), &mut sink, failing_scene);
        assert_eq!(result, Err(LoopError::Scene("no")));
        assert!(sent == full_frame_words()[..pixels]);

        let log = Log::default();
        let mut dma = Dma::new(&log);
        let (buffers, result) = picture_loop.draw_overlapping(buffers(&picture_loop), &mut dma, failing_scene);
        assert_eq!(result, Err(LoopError::Scene("no")));
        assert_ne!(buffers[0].name, buffers[1].name);
        assert_eq!(dma.under_way, 0, "no transfer is under way");
        assert!(dma.picture == full_frame_words()[..pixels]);

        let log = Log::default();
        let mut panel = PendingSink {
            state: RefCell::default(),
            log: &log,
            polls: 2,
        };
        let (mut one, mut other) = (buffer(&picture_loop), buffer(&picture_loop));
        let result = block_on(picture_loop.draw_async([&mut one, &mut other], &mut panel, failing_scene));
        assert_eq!(result, Err(LoopError::Scene("no")));
        assert!(panel.state.borrow().bytes == full_frame_bytes()[..2 * pixels]);
    }
}
