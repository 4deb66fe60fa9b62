use embedded_graphics::pixelcolor::{Gray4, Rgb565, Rgb888};
use zrow::{
    surface::{BandColor, BigEndian, Native, Order},
    view::DepthWidth,
    visible::{AtDepth, DepthRow},
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
    draw_target::<AtDepth<'_, '_, C, O, D>>();
}
