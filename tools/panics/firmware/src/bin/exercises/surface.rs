use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
};
use zrow::{
    band::{Band, BandColor, BigEndian, Generic, LittleEndian, Order, Span, Target},
    coverage::{Grid, Rooks, SamplePattern},
    shade::{ChannelColor, LinearGradient, Paint, Pattern, RadialGradient},
};
use zrow_panics_firmware::{Display, any, keep};

use crate::foreign::{draw_target, eq, get_pixel};

pub const EXERCISES: &[fn()] = &[
    target::<Band<'_, BinaryColor, LittleEndian>>,
    target::<Band<'_, Gray4, BigEndian>>,
    target::<Band<'_, Rgb565, LittleEndian>>,
    target::<Band<'_, Rgb565, BigEndian>>,
    target::<Band<'_, Rgb888, LittleEndian>>,
    target::<Band<'_, Rgb888, BigEndian>>,
    || target_of(|| any::<&'static mut Band<'static, Rgb565, LittleEndian>>().antialiased::<64, 16>(any())),
    target::<Generic<'_, Display<Rgb565>>>,
    || target_of(|| any::<&'static mut Band<'static, BinaryColor, LittleEndian>>().in_linear_light::<22>()),
    || target_of(|| any::<&'static mut Band<'static, Rgb565, BigEndian>>().in_linear_light::<24>()),
    || target_of(|| any::<&'static mut Band<'static, Rgb888, LittleEndian>>().in_linear_light::<10>()),
    samples::<Gray4, LittleEndian, Rooks<16>>,
    samples::<Rgb565, BigEndian, Rooks<4>>,
    samples::<Rgb888, LittleEndian, Grid<4>>,
    painted::<Band<'_, Rgb565, LittleEndian>, LinearGradient<Rgb565, 2>>,
    painted::<Band<'_, Rgb888, BigEndian>, RadialGradient<Rgb888, 3>>,
    painted::<Band<'_, BinaryColor, LittleEndian>, Pattern<'_, BinaryColor>>,
    painted::<Generic<'_, Display<Rgb565>>, &Pattern<'_, Rgb565>>,
    painted_samples::<Rgb565, LittleEndian, Rooks<8>>,
    get_pixel::<Generic<'_, Display<Rgb565>>>,
    order::<LittleEndian>,
    order::<BigEndian>,
    colors,
    span,
];

/// The target that a function returns, whose type has no public name.
#[inline(never)]
fn target_of<T: Target + 'static>(_: fn() -> T) {
    target::<T>();
}

/// The target of a function, whose type has no public name.
fn target_like<T: Target>(_: &mut T) {
    target::<T>();
}

#[inline(never)]
fn samples<C: ChannelColor + 'static, O: Order, P: SamplePattern + 'static>() {
    keep(Band::<C, O>::multisample(any(), any::<P>(), any(), |samples| {
        target_like(samples)
    }));
}

#[inline(never)]
fn painted_samples<C: ChannelColor + 'static, O: Order, P: SamplePattern + 'static>() {
    keep(Band::<C, O>::multisample(any(), any::<P>(), any(), |samples| {
        target_like(&mut samples.painted(any::<Pattern<'_, C>>()));
    }));
}

#[inline(never)]
fn painted<T: Target, P: Paint<Color = T::Color>>() {
    target_like(&mut <T as Target>::painted(any(), any::<P>()));
}

/// `DrawTarget` as well.
#[inline(never)]
fn target<T: Target>() {
    draw_target::<T>();
    let target: &mut T = any();
    keep(Target::window(target));
    keep(Target::raw(target, any()));
    keep(Target::fill_span(target, any(), any()));
    keep(Target::fill_window(target, any(), any()));
}

#[inline(never)]
fn order<O: Order>() {
    keep(<O as Order>::reorder(any::<u8>()));
    keep(<O as Order>::reorder(any::<u16>()));
    keep(<O as Order>::reorder(any::<u32>()));
}

#[inline(never)]
fn colors() {
    band_color::<BinaryColor>();
    band_color::<Gray2>();
    band_color::<Gray4>();
    band_color::<Gray8>();
    band_color::<Rgb555>();
    band_color::<Bgr555>();
    band_color::<Rgb565>();
    band_color::<Bgr565>();
    band_color::<Rgb666>();
    band_color::<Bgr666>();
    band_color::<Rgb888>();
    band_color::<Bgr888>();
}

#[inline(never)]
fn band_color<C: BandColor>() {
    keep(<C as BandColor>::to_word(any()));
    keep(<C as BandColor>::from_word(any()));
}

#[inline(never)]
fn span() {
    keep(Span::new(any(), any(), any()));
    keep(Span::is_empty(any()));
    keep(Span::clipped_to(any(), any()));
    keep(Span::to_window(any()));
    eq::<Span>();
}
