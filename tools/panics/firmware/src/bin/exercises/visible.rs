use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::{BigEndian, LittleEndian, Order},
    scan::Polygons,
    scene::{Deep, Fine, Look, Prepared},
    shade::{Texels, Textured},
    visible::{DepthBuffer, OneDepth, RayCasting, TileBins, Visibility},
};
use zrow_panics_firmware::{any, keep};

use crate::foreign::default;

pub const EXERCISES: &[fn()] = &[
    methods::<Rgb565, BigEndian>,
    methods::<Fine<Deep<Textured<Texels<Rgb565, 64, 64>>>>, LittleEndian>,
];

/// Each method in a look.
#[inline(never)]
fn methods<L: Look, O: Order + 'static>() {
    keep(Prepared::<L>::face_at(any(), any()));

    keep(DepthBuffer::<L::Depth, 4_800>::new());
    default::<DepthBuffer<L::Depth, 4_800>>();
    visibility::<L, O, DepthBuffer<L::Depth, 4_800>>();

    keep(OneDepth::new(Polygons::winding_number));
    keep(OneDepth::points_tested(any()));
    visibility::<L, O, OneDepth>();

    keep(RayCasting::<500>::new());
    keep(RayCasting::<500>::faces_tested(any()));
    default::<RayCasting<500>>();
    visibility::<L, O, RayCasting<500>>();

    keep(TileBins::<L::Depth, 300, 2_000>::new());
    default::<TileBins<L::Depth, 300, 2_000>>();
    visibility::<L, O, TileBins<L::Depth, 300, 2_000>>();
}

#[inline(never)]
fn visibility<L: Look, O: Order + 'static, V: Visibility<L::Depth> + 'static>() {
    keep(Prepared::<L>::draw_by::<O>(any(), any::<&mut V>(), any()));
}
