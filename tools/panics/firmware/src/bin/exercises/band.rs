use core::{
    future::Future,
    pin::pin,
    task::{Context, Poll, Waker},
};

use embedded_graphics::{
    Drawable,
    draw_target::DrawTarget,
    geometry::Dimensions,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb666, Rgb888},
    primitives::Rectangle,
};
use zrow::{
    band::{
        Band, BandColor, BigEndian, BytesSink, DisplaySink, Dithered, LittleEndian, LoopError, Order, OverlappingSink,
        Page, PagesSink, PanelRotation, PictureLoop, Sink, Supersampling,
    },
    coverage::{Bartlett, BoxFilter, Gaussian, Grid, Rooks, SamplePattern},
    geometry::TooSmall,
    shade::{ChannelColor, ConeFilter, SampleFilter},
};
use zrow_panics_firmware::{Display, Dot, Failure, any, keep, keep_all, take, take_both};

use crate::foreign::{eq, error, from, get_pixel};

pub const EXERCISES: &[fn()] = &[
    band::<BinaryColor, LittleEndian>,
    band::<Gray2, LittleEndian>,
    band::<Gray4, BigEndian>,
    band::<Gray8, LittleEndian>,
    band::<Rgb565, LittleEndian>,
    band::<Rgb565, BigEndian>,
    band::<Rgb666, LittleEndian>,
    band::<Rgb888, LittleEndian>,
    band::<Rgb888, BigEndian>,
    multisample::<BinaryColor, Rooks<4>>,
    multisample::<Rgb565, Rooks<4>>,
    multisample::<Rgb565, Rooks<8>>,
    multisample::<Rgb888, Rooks<16>>,
    multisample::<Rgb565, Grid<2>>,
    picture_loop::<BinaryColor, LittleEndian>,
    picture_loop::<Rgb565, BigEndian>,
    overlapping_sink::<Rgb565, LittleEndian, &mut [u16], DisplaySink<'_, Display<Rgb565>>>,
    draw_async,
    draw_pages_async,
    sinks,
    pages,
    rotated::<Rgb565, LittleEndian>,
    rotated::<Rgb888, BigEndian>,
    rotated::<BinaryColor, LittleEndian>,
    supersampling::<Rgb565, LittleEndian, 2, BoxFilter>,
    supersampling::<Rgb565, BigEndian, 4, Bartlett>,
    supersampling::<Rgb888, LittleEndian, 4, ConeFilter>,
    supersampling::<BinaryColor, LittleEndian, 8, BoxFilter>,
    supersampling::<Gray4, LittleEndian, 16, Gaussian>,
    values,
];

#[inline(never)]
fn band<C: ChannelColor + 'static, O: Order>() {
    keep(Band::<C, O>::new(any(), any()));
    keep(Band::<C, O>::draw(any(), any::<&Dot<C>>()));
    keep(Band::<C, O>::row_mut(any(), any()));
    keep(Band::<C, O>::words(any()));
    keep(Band::<C, O>::words_mut(any()));
    keep(Band::<C, O>::word(any()));
    keep_all(Band::<C, O>::colors(any()));
    Band::<C, O>::fill(any(), any());
    keep(Band::<C, O>::into_bytes(any()));
    keep(Band::<C::EightBit, O>::into_dithered::<C>(any()));
    get_pixel::<Band<'_, C, O>>();
}

#[inline(never)]
fn multisample<C: ChannelColor + 'static, P: SamplePattern + 'static>() {
    keep(Band::<C, LittleEndian>::multisample(
        any(),
        any::<P>(),
        any(),
        |target| keep(target),
    ));
}

#[inline(never)]
fn picture_loop<C: BandColor + PartialEq + 'static, O: Order>() {
    keep(PictureLoop::<C>::new(any(), any()));
    keep(PictureLoop::<C>::in_order::<O>(any()));
    keep(PictureLoop::<C>::rows(any(), any()));
    keep(PictureLoop::<C>::aligned(any(), any(), any()));
    keep(PictureLoop::<C>::words_needed(any()));
    keep_all(PictureLoop::<C>::bands(any()));
    keep(PictureLoop::<C, O>::draw(
        any(),
        any(),
        &mut |band: Band<'_, C, O>| take(band),
        |band| keep(band),
    ));
    keep(PictureLoop::<C, O>::draw(
        any(),
        any(),
        any::<&mut DisplaySink<'_, Display<C>>>(),
        |band| keep(band),
    ));
    keep(PictureLoop::<C, O>::draw(
        any(),
        any(),
        &mut BytesSink(|area: Rectangle, bytes: &[u8]| take_both(area, bytes)),
        |band| keep(band),
    ));
    keep(
        PictureLoop::<C, O>::draw_overlapping::<&'static mut [C::Word], _, _, _>(
            any(),
            any(),
            any::<&mut DisplaySink<'_, Display<C>>>(),
            |band| keep(band),
        ),
    );
    eq::<PictureLoop<C>>();
}

#[inline(never)]
fn overlapping_sink<C: BandColor, O: Order, B: AsMut<[C::Word]> + 'static, S: OverlappingSink<C, O, B> + 'static>() {
    keep(<S as OverlappingSink<C, O, B>>::start(any(), any(), any()).is_ok());
    keep(<S as OverlappingSink<C, O, B>>::finish(any(), any()).1.is_ok());
}

#[inline(never)]
fn draw_async() {
    // No async closure: its own future has a panic of its own.
    let send = |area: Rectangle, bytes: &[u8]| {
        keep((area, bytes));
        core::future::poll_fn(|_| any::<Poll<Result<(), Failure>>>())
    };
    poll_to_the_end(PictureLoop::<Rgb565>::draw_async(any(), any(), send, |band| keep(band)));
}

#[inline(never)]
fn draw_pages_async() {
    let send = |page: Page<'_>| {
        keep(page);
        core::future::poll_fn(|_| any::<Poll<Result<(), Failure>>>())
    };
    let drawing = PictureLoop::<BinaryColor>::draw_pages_async(any(), any(), any(), send, |band| keep(band));
    poll_to_the_end(drawing);
}

/// A future of an `async fn` panics where it is polled once more after its end: this is how one is polled to it.
#[inline(always)]
fn poll_to_the_end(future: impl Future) {
    let mut future = pin!(future);
    let mut context = Context::from_waker(Waker::noop());
    while future.as_mut().poll(&mut context).is_pending() {}
}

#[inline(never)]
fn sinks() {
    sink::<Rgb565, LittleEndian, DisplaySink<'_, Display<Rgb565>>>();
    sink::<BinaryColor, LittleEndian, BytesSink<fn(Rectangle, &[u8]) -> Result<(), Failure>>>();
    sink::<Rgb888, BigEndian, fn(Band<'_, Rgb888, BigEndian>) -> Result<(), Failure>>();
    keep(Dithered::<Rgb565, _>::new(any::<DisplaySink<'_, Display<Rgb565>>>()));
    sink::<Rgb888, LittleEndian, Dithered<Rgb565, DisplaySink<'_, Display<Rgb565>>>>();
    sink::<Gray8, BigEndian, Dithered<Gray4, BytesSink<fn(Rectangle, &[u8]) -> Result<(), Failure>>>>();
}

#[inline(never)]
fn pages() {
    keep(PagesSink::new(any(), any(), any::<fn(Page<'_>) -> Result<(), Failure>>()).is_ok());
    sink::<BinaryColor, LittleEndian, PagesSink<'static, fn(Page<'_>) -> Result<(), Failure>>>();
    keep(Page::ssd1306_window(any(), any()));
    keep(Page::sh1106_window(any(), any()));
    eq::<Page<'_>>();
}

#[inline(never)]
fn rotated<C: BandColor + 'static, O: Order>() {
    keep(PanelRotation::by_90(any()));
    keep(PanelRotation::by_180(any()));
    keep(PanelRotation::by_270(any()));
    keep(PanelRotation::rotate(any(), any::<&mut Band<'_, C, O>>()));
    eq::<PanelRotation>();
    let mut band = any::<Band<'_, C, O>>();
    let mut in_picture = Band::<C, O>::in_picture(&mut band, any());
    keep(in_picture.bounding_box());
    keep(any::<&Dot<C>>().draw(&mut in_picture));
    keep(in_picture.fill_solid(any(), any()));
    keep(in_picture.fill_contiguous(any(), any::<&[C]>().iter().copied()));
    keep(in_picture.clear(any()));
}

#[inline(never)]
fn sink<C: BandColor + 'static, O: Order, S: Sink<C, O> + 'static>() {
    keep(<S as Sink<C, O>>::send(any(), any()).is_ok());
}

#[inline(never)]
fn supersampling<C: ChannelColor + PartialEq + 'static, O: Order, const N: usize, F>()
where
    F: SampleFilter<N> + PartialEq + Clone,
    F::Sum: 'static,
{
    keep(Supersampling::<C, N, F>::new(any(), any()));
    keep(Supersampling::<C, N, F>::in_order::<O>(any()));
    keep(Supersampling::<C, N, F>::rows(any(), any()));
    keep(Supersampling::<C, N, F>::words_needed(any()));
    keep(Supersampling::<C, N, F>::sums_needed(any()));
    keep(Supersampling::<C, N, F>::enlarged(any()));
    keep(Supersampling::<C, N, F, O>::draw(
        any(),
        any(),
        any(),
        any::<&mut DisplaySink<'_, Display<C>>>(),
        |band| keep(band),
    ));
    eq::<Supersampling<C, N, F>>();
}

#[inline(never)]
fn values() {
    error::<LoopError<Failure>>();
    eq::<LoopError<Failure>>();
    from::<TooSmall, LoopError<Failure>>();
}
