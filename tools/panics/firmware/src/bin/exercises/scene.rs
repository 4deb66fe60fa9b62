use embedded_graphics::{
    draw_target::DrawTarget,
    pixelcolor::{Gray4, Rgb565, Rgb888},
};
use zrow::{
    band::{BandColor, BigEndian, LittleEndian},
    geometry::{Sub4, Sub8},
    scene::{Clipping, DepthWidth, Frame, Model, Prepared, ScreenPrecision},
};
use zrow_panics_firmware::{any, items, keep, keep_all};

use crate::foreign::{default, eq};

pub const EXERCISES: &[fn()] = &[
    frame::<Gray4, Sub4, u16, true>,
    frame::<Rgb565, Sub4, u16, true>,
    frame::<Rgb565, Sub4, u16, false>,
    frame::<Rgb565, Sub4, u32, true>,
    frame::<Rgb565, Sub8, u16, false>,
    frame::<Rgb888, Sub8, u32, true>,
    model,
    values,
];

#[inline(never)]
fn frame<C: BandColor + 'static, S: ScreenPrecision, D: DepthWidth + 'static, const CUTS: bool>() {
    keep(Frame::<C, 320, 588, 64, 128, S, D, Clipping<CUTS>>::new());
    default::<Frame<C, 320, 588, 64, 128, S, D, Clipping<CUTS>>>();
    keep(Frame::<C, 320, 588, 64, 128, S, D, Clipping<CUTS>>::prepare(
        any(),
        any(),
        any(),
    ));
    keep(Prepared::<C, Frame<C, 320, 588, 64, 128, S, D, Clipping<CUTS>>>::draw::<LittleEndian>(any(), any(), any()));
    keep(Prepared::<C, Frame<C, 320, 588, 64, 128, S, D, Clipping<CUTS>>>::draw::<BigEndian>(any(), any(), any()));
    keep(
        Prepared::<C, Frame<C, 320, 588, 64, 128, S, D, Clipping<CUTS>>>::draw_with::<LittleEndian>(
            any(),
            any(),
            any(),
            |row| {
                keep(row.y());
                row_target(row.at_depth(any()));
                keep(row);
            },
        ),
    );
    keep(Prepared::<C, Frame<C, 320, 588, 64, 128, S, D, Clipping<CUTS>>>::rows_without_depth(any()));
    keep_all(Prepared::<C, Frame<C, 320, 588, 64, 128, S, D, Clipping<CUTS>>>::faces(
        any(),
    ));
}

#[inline(never)]
fn model() {
    keep(Model::<Rgb565>::new(any(), any()));
    keep(Model::<Rgb565>::with_pose(any(), any()));
    keep(Model::<Rgb565>::mesh(any()));
    keep(Model::<Rgb565>::colors(any()));
    eq::<Model<'_, Rgb565>>();
}

#[inline(never)]
fn values() {
    eq::<Clipping>();
    default::<Clipping>();
    eq::<Clipping<false>>();
    default::<Clipping<false>>();
}

/// The target that a row hands out; its type has no public name.
fn row_target(mut target: impl DrawTarget) {
    keep(target.bounding_box());
    keep(target.draw_iter(items()));
    keep(target.fill_contiguous(any(), items()));
    keep(target.fill_solid(any(), any()));
    keep(target.clear(any()));
}
