use embedded_graphics::{
    mono_font::MonoTextStyle,
    pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888},
    primitives::{Circle, Line, Styled, Triangle},
    text::Text,
};
use zrow::{
    band::{Band, BandColor, BigEndian, LittleEndian, Order, Target},
    coverage::{Grid, Rooks, SamplePattern},
    draw::{DrawOn, PictureItem, PrimitiveStyle},
    geometry::{Sub4, Sub8},
    scene::{
        Antialiased, BoundingBox, BoundingCylinder, BoundingSphere, BoundingVolume, Counted, Counters, Deep,
        DepthWidth, DoubleSided, Edge, EdgeKind, FacePlanes, FaceSet, Fine, Frame, InstructionSet, Look, Memory, Model,
        Multisampled, OnePass, Orthographic, Prepared, SceneItem, ScreenPrecision, Unhurried, Whole,
    },
    shade::{
        Bilinear, Blinn, Bounded, ChannelColor, Clamped, CutOut, FlatLit, Foggy, Gouraud, Indexed, Lambert,
        LitTextured, Shading, Texels, Textured, Transformed, Translucent, TwoSided, WithPlanes,
    },
};
use zrow_methods::LookOf;
use zrow_panics_firmware::{any, items, keep, keep_all};

use crate::{
    foreign::{clone, default, eq, from},
    shade::{EvenStripes, Stripes},
};

pub const EXERCISES: &[fn()] = &[
    memory::<Gray4, Sub4, u16, true>,
    memory::<Rgb565, Sub4, u16, true>,
    memory::<Rgb565, Sub4, u16, false>,
    memory::<Rgb565, Sub4, u32, true>,
    memory::<Rgb565, Sub8, u16, false>,
    memory::<Rgb888, Sub8, u32, true>,
    look::<Fine<Whole<Rgb565>>>,
    in_all_formats::<FlatLit<Rgb565>>,
    shaded::<FlatLit<Gray4, Lambert<0>>>,
    in_all_formats::<Gouraud<Rgb565>>,
    shaded::<Gouraud<Gray4, Lambert<3>>>,
    shaded::<Textured<Texels<BinaryColor, 8, 4>>>,
    shaded::<Textured<Texels<Rgb565, 64, 64>>>,
    shaded::<Textured<Texels<Rgb565, 64, 64>, 1>>,
    in_all_formats::<LitTextured<Texels<Rgb565, 64, 64>>>,
    shaded::<LitTextured<Texels<Rgb888, 1, 16>, Lambert<2>>>,
    shaded::<Textured<CutOut<Indexed<Rgb565, 16, 64, 16>>>>,
    shaded::<LitTextured<Bilinear<Clamped<Texels<Rgb565, 64, 64>>>, Blinn<1, 1>>>,
    shaded::<Foggy<Rgb565>>,
    shaded::<Foggy<Gouraud<Rgb565, Lambert<1, 1>>>>,
    shaded::<Translucent<Rgb565>>,
    in_all_formats::<Foggy<Translucent<Textured<CutOut<Indexed<Rgb565, 16, 64, 16>>>>>>,
    look::<Whole<Deep<Translucent<Gouraud<Gray4>>>>>,
    shaded::<EvenStripes>,
    shaded::<Stripes>,
    shaded::<Transformed<Gouraud<Rgb565>>>,
    shaded::<Bounded<Rgb565>>,
    shaded::<Bounded<Rgb565, BoundingSphere>>,
    look::<Fine<Transformed<Bounded<Gouraud<Rgb565>, BoundingCylinder>>>>,
    look::<Whole<Orthographic<Bounded<Transformed<Foggy<Rgb565>>>>>>,
    shaded::<WithPlanes<Rgb565>>,
    look::<Fine<Orthographic<WithPlanes<Gouraud<Rgb565>>>>>,
    look::<Antialiased<Bounded<WithPlanes<Rgb565>>>>,
    look::<Transformed<Rgb565>>,
    look::<Whole<Fine<Transformed<LitTextured<Texels<Rgb565, 64, 64>>>>>>,
    look::<Deep<Transformed<FlatLit<Gray4>>>>,
    look::<Orthographic<Rgb565>>,
    look::<DoubleSided<Rgb565>>,
    look::<DoubleSided<LitTextured<Texels<Rgb565, 64, 64>>>>,
    look::<Whole<Fine<DoubleSided<Transformed<FlatLit<Gray4, TwoSided<Lambert<1>>>>>>>>,
    look::<Antialiased<Rgb565>>,
    look::<Antialiased<Fine<Deep<DoubleSided<Translucent<Gouraud<Rgb888>>>>>>>,
    look::<Whole<OnePass<Antialiased<Transformed<LitTextured<Texels<Rgb565, 64, 64>>>>>>>,
    look::<Multisampled<Rgb565>>,
    samples::<Multisampled<Rgb565>, Rooks<4>>,
    samples::<Fine<Deep<Multisampled<Rgb888>>>, Rooks<16>>,
    samples::<Multisampled<Translucent<Textured<CutOut<Indexed<Rgb565, 16, 64, 16>>>>>, Grid<2>>,
    samples::<Whole<Orthographic<Multisampled<Gouraud<Rgb565>>>>, Rooks<8>>,
    look::<Counted<Rgb565>>,
    look::<Unhurried<Counted<LitTextured<Texels<Rgb565, 64, 64>>>>>,
    counted,
    look::<Whole<Orthographic<Deep<Gouraud<Rgb565>>>>>,
    look::<Orthographic<Fine<LitTextured<Texels<Rgb565, 64, 64>>>>>,
    orthographic_depths,
    model,
    scene_item::<LookOf<Rgb565, Sub4, u16, true>>,
    scene_item::<LookOf<Gray4, Sub8, u32, true>>,
    scene_item::<Gouraud<Rgb565>>,
    scene_item::<Whole<LitTextured<Texels<Rgb565, 64, 64>>>>,
];

#[inline(never)]
fn memory<C: BandColor + 'static, S: ScreenPrecision, D: DepthWidth + 'static, const CUTS: bool>() {
    keep(Memory::<LookOf<C, S, D, CUTS>, 320, 588, 240, 128>::new());
    default::<Memory<LookOf<C, S, D, CUTS>, 320, 588, 240, 128>>();
    keep(Memory::<LookOf<C, S, D, CUTS>, 320, 588, 240, 128>::frame(any()));
    keep(Memory::<LookOf<C, S, D, CUTS>, 320, 588, 240, 128>::prepare(
        any(),
        any(),
        any(),
    ));
    look::<LookOf<C, S, D, CUTS>>();
    // An order only swaps the bytes of a word: looks of each precision and depth are drawn in both, others in one of them.
    drawings::<LookOf<C, S, D, CUTS>, BigEndian>();
}

/// A scene in the samples of a band.
#[inline(never)]
fn samples<L: Look<Color: ChannelColor>, P: SamplePattern + 'static>() {
    keep(Band::<L::Color, LittleEndian>::multisample(
        any(),
        any::<P>(),
        any(),
        |samples| {
            keep(Prepared::<L>::draw_samples(any(), samples));
        },
    ));
    keep(Band::<L::Color, BigEndian>::multisample(
        any(),
        any::<P>(),
        any(),
        |samples| {
            keep(Prepared::<L>::draw_samples(any(), samples));
        },
    ));
}

/// Calls the functions of scenes whose types have no capacities, with both ways to draw in the same order of bytes, in which they
/// share the functions that take seconds to compile.
#[inline(never)]
fn look<L: Look>() {
    look_in::<L, LittleEndian>();
}

#[inline(never)]
fn look_in<L: Look, O: Order + 'static>() {
    keep(Frame::<L>::prepare(any(), any(), any()));
    drawings::<L, O>();
    keep(Prepared::<L>::rows_without_depth(any()));
    keep(Prepared::<L>::rows_in_passes(any()));
    keep(Prepared::<L>::active_needed(any()));
    keep(Prepared::<L>::vertices_needed(any()));
    keep(Prepared::<L>::estimate(any(), any()));
    keep_all(Prepared::<L>::faces(any()));
    for point in Prepared::<L>::points(any()) {
        keep(point.corner.pixel());
        keep(point);
    }
    keep_all(Prepared::<L>::edges(any(), any(), any()));
}

#[inline(never)]
fn drawings<L: Look, O: Order + 'static>() {
    keep(Prepared::<L>::draw::<O>(any(), any()));
    keep(Prepared::<L>::draw_with::<O>(any(), any(), |row| {
        keep(row.y());
        row_target(row.at_depth(any()));
        keep(row);
    }));
}

#[inline(never)]
fn orthographic_depths() {
    keep(Orthographic::<Rgb565>::depth_at(any(), any()));
    keep(Orthographic::<Fine<Deep<Rgb565>>>::depth_at(any(), any()));
}

#[inline(never)]
fn counted() {
    keep(Prepared::<Counted<Rgb565>>::counters(any()));
    default::<Counters>();
    eq::<Counters>();
    eq::<InstructionSet>();
    clone::<InstructionSet>();
}

/// A shading in two looks that have nothing in common: faces are cut or not, in positions of 16 or 32 bits, with depths of 16 or
/// 32 bits, in passes or in one, in either order of bytes. The other combinations are those of [`in_all_formats`].
#[inline(never)]
fn shaded<H: Shading>() {
    look::<H>();
    look_in::<Fine<Whole<Deep<OnePass<H>>>>, BigEndian>();
    // So few slots that all rows are drawn in passes.
    keep(Memory::<H, 320, 588, 240, 128, 1>::new());
    keep(Memory::<H, 320, 588, 240, 128, 1>::prepare(any(), any(), any()));
    keep(Model::<H>::with_skin(any(), any()));
    keep(Model::<H>::with_pose(any(), any()));
    keep(Model::<H>::mesh(any()));
    keep(Model::<H>::skin(any()));
    clone::<Model<'_, H>>();
}

/// A shading whose faces are cut or not, at each precision and width of depths, in passes and not: for a shading of each kind of
/// attributes, because each look takes seconds to compile.
#[inline(never)]
fn in_all_formats<H: Shading>() {
    shaded::<H>();
    look::<Whole<H>>();
    look::<Fine<Whole<H>>>();
    look::<Deep<H>>();
    look::<Fine<Deep<OnePass<H>>>>();
}

#[inline(never)]
fn scene_item<L: Look>() {
    keep(SceneItem::<L, 2>::new(any(), any(), any()));
    keep(SceneItem::<L, 2>::prepare(any(), any(), any()));
    picture_item::<L::Color, LittleEndian, SceneItem<L, 2>>();
    picture_item::<L::Color, BigEndian, SceneItem<L, 2>>();
}

#[inline(never)]
pub fn picture_item<C: BandColor, O: Order, T: PictureItem<C, O> + 'static>() {
    keep(<T as PictureItem<C, O>>::bounds(any()));
    <T as PictureItem<C, O>>::draw(any(), any());
}

#[inline(never)]
fn model() {
    keep(FaceSet::vertices_of(any()));
    keep(FaceSet::bounds(any()));
    keep(FaceSet::is_convex(any()));
    keep(FaceSet::morphed(any(), any(), any(), any()));
    keep(FaceSet::with_neighbours(any(), any()));
    keep(FaceSet::neighbours(any()));
    keep(FaceSet::find_neighbours::<12>(any()));
    keep(FaceSet::find_edges::<12, 18>(any(), any(), any()));
    keep(FaceSet::count_edges::<12>(any(), any()));
    keep(FaceSet::triangulate::<12>(any(), any()));
    keep(FaceSet::count_triangles(any()));
    keep(Edge::boundary(any(), any()));
    keep(Edge::crease(any(), any()));
    keep(Edge::smooth(any(), any()));
    keep(Edge::vertices(any()));
    keep(Edge::faces(any()));
    keep(Edge::kind(any()));
    eq::<Edge>();
    eq::<EdgeKind>();
    keep(BoundingBox::around(any()));
    keep(BoundingBox::joined(any(), any()));
    eq::<BoundingBox>();
    keep(BoundingSphere::around(any()));
    eq::<BoundingSphere>();
    keep(BoundingCylinder::around(any()));
    eq::<BoundingCylinder>();
    from::<BoundingBox, BoundingVolume>();
    from::<BoundingSphere, BoundingVolume>();
    from::<BoundingCylinder, BoundingVolume>();
    eq::<BoundingVolume>();
    keep(FacePlanes::find::<12>(any(), any()));
    keep(FacePlanes::find_in(any(), any()));
    keep(FacePlanes::new(any(), any()));
    keep(FacePlanes::table(any()));
    eq::<FacePlanes<'_>>();
    keep(FaceSet::faces_of(any()));
    keep(Model::<Rgb565>::new(any(), any()));
    keep(Model::<Rgb565>::with_pose(any(), any()));
    keep(Model::<Rgb565>::mesh(any()));
    keep(Model::<Rgb565>::colors(any()));
    clone::<Model<'_, Rgb565>>();
}

/// The target that a row hands out; its type has no public name.
pub fn row_target<T: Target>(mut target: T) {
    keep(target.bounding_box());
    keep(target.window());
    keep(target.fill_span(any(), target.raw(any())));
    keep(target.fill_window(any(), target.raw(any())));
    keep(any::<Styled<Triangle, PrimitiveStyle<T::Color>>>().draw_on(&mut target));
    keep(any::<Styled<Line, PrimitiveStyle<T::Color>>>().draw_on(&mut target));
    keep(any::<Styled<Circle, PrimitiveStyle<T::Color>>>().draw_on(&mut target));
    keep(any::<Text<'static, MonoTextStyle<'static, T::Color>>>().draw_on(&mut target));
    keep(target.draw_iter(items()));
    keep(target.fill_contiguous(any(), items()));
    keep(target.fill_solid(any(), any()));
    keep(target.clear(any()));
}
