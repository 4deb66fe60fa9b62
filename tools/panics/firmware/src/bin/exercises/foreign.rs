//! The traits of the standard library and of embedded-graphics, each exercised by a function of its name.
//!
//! `Debug` is left out: what it prints goes through functions of the core library that hold panics of their own, such as
//! the assertion in `Formatter::debug_struct_fields_finish`, and nothing but a program's author calls it.

use core::{
    error::Error,
    fmt::{Display, Write},
    hash::{Hash, Hasher},
};

use embedded_graphics::{draw_target::DrawTarget, geometry::Dimensions, image::GetPixel, transform::Transform};
use zrow_panics_firmware::{any, items, keep, keep_all};

/// Text that goes anywhere.
struct Text;

impl Write for Text {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        keep(text);
        any()
    }
}

/// Bytes that go anywhere.
struct Digest;

impl Hasher for Digest {
    fn finish(&self) -> u64 {
        any()
    }

    fn write(&mut self, bytes: &[u8]) {
        keep(bytes);
    }
}

#[inline(never)]
pub fn clone<T: Clone>() {
    keep(any::<&T>().clone());
}

/// `Clone` as well.
#[inline(never)]
pub fn eq<T: PartialEq + Clone>() {
    clone::<T>();
    keep(any::<&T>() == any::<&T>());
}

/// `PartialEq` and `Clone` as well.
#[inline(never)]
pub fn hash<T: Hash + PartialEq + Clone>() {
    eq::<T>();
    any::<&T>().hash(&mut Digest);
}

#[inline(never)]
pub fn default<T: Default>() {
    keep(T::default());
}

#[inline(never)]
pub fn display<T: Display>() {
    keep(write!(Text, "{}", any::<&T>()));
}

/// `Display` as well.
#[inline(never)]
pub fn error<T: Error>() {
    display::<T>();
    keep(any::<&T>().source());
}

#[inline(never)]
pub fn from<A, B: From<A>>() {
    keep(B::from(any()));
}

#[inline(never)]
pub fn iterator<I: Iterator>() {
    let mut items: I = any();
    keep(items.next());
    keep(items.size_hint());
    keep_all(items);
}

#[inline(never)]
pub fn dimensions<D: Dimensions>() {
    keep(D::bounding_box(any()));
}

#[inline(never)]
pub fn transform<T: Transform + 'static>() {
    keep(T::translate(any(), any()));
    keep(T::translate_mut(any(), any()));
}

#[inline(never)]
pub fn get_pixel<T: GetPixel + 'static>() {
    keep(T::pixel(any(), any()));
}

/// `Dimensions` as well.
#[inline(never)]
pub fn draw_target<D: DrawTarget>() {
    dimensions::<D>();
    let target: &mut D = any();
    keep(target.draw_iter(items()));
    keep(target.fill_contiguous(any(), items()));
    keep(target.fill_solid(any(), any()));
    keep(target.clear(any()));
}
