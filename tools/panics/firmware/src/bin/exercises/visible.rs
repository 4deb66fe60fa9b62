use embedded_graphics::{
    draw_target::DrawTarget,
    pixelcolor::{Gray4, Rgb565, Rgb888},
};
use zrow::{
    scene::{DepthRow, DepthWidth},
    surface::{BandColor, BigEndian, Native, Order},
};
use zrow_panics_firmware::{any, keep};

use crate::foreign::draw_target;

pub const EXERCISES: &[fn()] = &[
    depth_row::<Gray4, Native, u16>,
    depth_row::<Rgb565, BigEndian, u16>,
    depth_row::<Rgb565, Native, u32>,
    depth_row::<Rgb888, Native, u32>,
];

#[inline(never)]
fn depth_row<C: BandColor + 'static, O: Order, D: DepthWidth + 'static>() {
    keep(DepthRow::<C, O, D>::at_depth(any(), any()));
    keep(DepthRow::<C, O, D>::y(any()));
    at_depth(|| DepthRow::<C, O, D>::at_depth(any(), any()));
}

/// The target that the function returns; its type has no public name.
fn at_depth<T: DrawTarget + 'static>(_: fn() -> T) {
    draw_target::<T>();
}
