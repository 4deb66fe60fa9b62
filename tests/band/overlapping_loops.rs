//! Picture loops that draw a band while another is sent: by transfers that own their buffer, and by futures.

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
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use zrow::{
    band::{Band, BigEndian, LittleEndian, LoopError, Order, OverlappingSink, PictureLoop},
    geometry::TooSmall,
};

use crate::picture_loop::{AREA, ROWS, Recorder, buffer, full_frame, picture_loop, scene};

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
    full_frame::<Rgb565, LittleEndian>(AREA)
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
        let mut sink = |band: Band<'_, Rgb888, BigEndian>| {
            picture.extend(band.colors());
            Ok::<(), Infallible>(())
        };
        let buffers = [buffer(&picture_loop), buffer(&picture_loop)];
        let (_, result) = picture_loop.draw_overlapping(buffers, &mut sink, scene::<Rgb888, BigEndian>);
        assert_eq!(result, Ok(()));
        assert!(picture == full_frame::<Rgb888, BigEndian>(AREA));
    }
    let picture_loop = picture_loop::<Rgb565, _>(7);
    let mut sink = Recorder::failing_at(2);
    let buffers = [buffer(&picture_loop), buffer(&picture_loop)];
    let (buffers, result) = picture_loop.draw_overlapping(buffers, &mut sink, scene::<Rgb565, LittleEndian>);
    assert_eq!(result, Err(LoopError::Sink("unplugged")));
    assert_eq!(buffers.map(|buffer| buffer.len()), [61 * 7, 61 * 7]);
    let too_small: Result<Vec<u16>, _> = OverlappingSink::<Rgb565, LittleEndian, _>::start(&mut sink, AREA, vec![0; 9]);
    let needed = TooSmall::Words(61 * 45);
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

impl PendingSink<'_> {
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
pub fn block_on<T>(future: impl Future<Output = T>) -> T {
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
    let send = async |area: Rectangle, bytes: &[u8]| sink.send(area, bytes).await;
    block_on(picture_loop.draw_async([&mut one, &mut other], send, logged_scene(log)))
}

fn full_frame_bytes() -> Vec<u8> {
    full_frame::<Rgb565, LittleEndian>(AREA)
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
            // Nothing is drawn after that.
            assert_eq!(log.borrow().last(), Some(&Event::Finished(area.top_left.y)));
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
    let send = async |area: Rectangle, bytes: &[u8]| sink.send(area, bytes).await;
    let result = block_on(picture_loop.draw_async([&mut one, &mut other], send, logged_scene(&log)));
    assert_eq!(result, Err(LoopError::TooSmall(TooSmall::Words(61 * 7))));
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
        let send = async |area: Rectangle, bytes: &[u8]| panel.send(area, bytes).await;
        let result = block_on(picture_loop.draw_async([&mut one, &mut other], send, failing_scene));
        assert_eq!(result, Err(LoopError::Scene("no")));
        assert!(panel.state.borrow().bytes == full_frame_bytes()[..2 * pixels]);
    }
}
