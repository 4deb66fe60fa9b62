//! Values of which the compiler knows nothing but their types, and what the programs of this package share.

#![no_std]

use core::{fmt, hint::black_box, marker::PhantomData, panic::PanicInfo};

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::Dimensions,
    image::GetPixel,
    pixelcolor::PixelColor,
    prelude::{Drawable, Point},
    primitives::Rectangle,
};

/// A value that may be any of its type: what a caller could hand over, and what a constructor could have left in a private
/// field. Nothing is constant-folded behind it. The programs are linked and read, never run: they would wait here forever.
#[inline(always)]
pub fn any<T>() -> T {
    loop {
        if let Some(value) = black_box(None) {
            return value;
        }
    }
}

/// Makes the compiler compute a value that nobody reads.
#[inline(always)]
pub fn keep<T>(value: T) {
    black_box(value);
}

/// Makes the compiler compute all items of an iterator.
#[inline(always)]
pub fn keep_all(items: impl IntoIterator) {
    for item in items {
        keep(item);
    }
}

/// A callback that may fail.
#[inline(always)]
pub fn take<T>(value: T) -> Result<(), Failure> {
    keep(value);
    any()
}

/// A callback for two values that may fail.
#[inline(always)]
pub fn take_both<A, B>(one: A, other: B) -> Result<(), Failure> {
    take((one, other))
}

/// An iterator that may return anything.
#[derive(Debug, Clone)]
pub struct Items<T>(PhantomData<T>);

impl<T> Iterator for Items<T> {
    type Item = T;

    #[inline(always)]
    fn next(&mut self) -> Option<T> {
        any()
    }
}

/// Any items.
pub fn items<T>() -> Items<T> {
    Items(PhantomData)
}

/// What goes wrong in a display, in a sink, in a callback.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Failure(pub u8);

impl fmt::Display for Failure {
    fn fmt(&self, _: &mut fmt::Formatter<'_>) -> fmt::Result {
        any()
    }
}

impl core::error::Error for Failure {}

/// Some display's driver: a draw target that can be read back, and nothing else.
#[derive(Debug)]
pub struct Display<C>(PhantomData<C>);

impl<C> Dimensions for Display<C> {
    fn bounding_box(&self) -> Rectangle {
        any()
    }
}

impl<C: PixelColor> DrawTarget for Display<C> {
    type Color = C;
    type Error = Failure;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Failure> {
        keep_all(pixels);
        any()
    }
}

impl<C: PixelColor> GetPixel for Display<C> {
    type Color = C;

    fn pixel(&self, _: Point) -> Option<C> {
        any()
    }
}

/// Something of embedded-graphics' kind that draws one pixel.
#[derive(Debug)]
pub struct Dot<C: PixelColor>(pub Pixel<C>);

impl<C: PixelColor> Dimensions for Dot<C> {
    fn bounding_box(&self) -> Rectangle {
        any()
    }
}

impl<C: PixelColor> Drawable for Dot<C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        target.draw_iter([self.0])
    }
}

/// Calls functions through pointers of which the compiler does not know where they lead.
pub fn call_all(functions: &'static [&'static [fn()]]) -> ! {
    for function in black_box(functions).iter().copied().flatten() {
        function();
    }
    halt()
}

/// Every panic ends here. Where there is none, this is not linked.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    black_box(info);
    halt()
}

fn halt() -> ! {
    loop {
        core::hint::spin_loop();
    }
}
