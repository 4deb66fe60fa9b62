use core::hash::Hash;

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::Point,
    image::ImageRaw,
    iterator::raw::RawDataSlice,
    mono_font::{MonoFont, MonoTextStyle},
    pixelcolor::{BinaryColor, Gray4, PixelColor, Rgb565, Rgb888, raw::ByteOrder},
    primitives::{
        self, Arc, Circle, Ellipse, Line, Polyline, Primitive, Rectangle, RoundedRectangle, Sector, Styled,
        StyledDimensions, StyledDrawable, Triangle,
    },
    text::{
        Text,
        renderer::{CharacterStyle, TextRenderer},
    },
};
use zrow::{
    band::{Band, BandColor, BigEndian, Generic, LittleEndian, Order, Target},
    coverage::{
        AnyCoverage, CentreSample, CoverageMethod, Gaussian, Grid, InsideArea, Rooks, SamplePattern, SignedArea,
        SubScanlines,
    },
    draw::{
        Antialiased, AntialiasedPolygon, AntialiasingMemory, BlendOn, DrawAntialiased, DrawOn, DrawableItem,
        FilteredLine, Group, ItemId, MaskFont, MaskGlyph, MaskTextStyle, OutlineFont, OutlineGlyph, OutlineTextStyle,
        PaintedShape, Path, PathCommand, Picture, PictureItem, PictureSlot, Points, Polygon, PreparedShape,
        PrimitiveStyle, SeedFill, StrokeStyle, SubArc, SubEllipse, SubLine, SubOutline, ThinCircle,
    },
    geometry::{DrawError, Sub4, Sub8, SubPixel, SubPoint, TooSmall, Vertex},
    prelude::*,
    shade::{BlendTarget, ChannelColor, LinearGradient, Pattern, SampleTarget},
};
use zrow_panics_firmware::{Display, Failure, any, keep, keep_all, take_both};

use crate::foreign::{clone, default, dimensions, eq, error, from, hash, iterator, transform};

pub const EXERCISES: &[fn()] = &[
    styled_shape::<Arc>,
    styled_shape::<Circle>,
    styled_shape::<Ellipse>,
    styled_shape::<Line>,
    styled_shape::<Path<'_, Sub4>>,
    styled_shape::<Path<'_, Sub8>>,
    styled_shape::<Points<'_>>,
    styled_shape::<Polyline<'_>>,
    styled_shape::<&PreparedShape<Path<'_, Sub4>, 64, 16>>,
    styled_shape::<&PreparedShape<Path<'_, Sub8>, 64, 16>>,
    styled_shape::<&PreparedShape<Polygon<'_, Point>, 64, 16>>,
    styled_shape::<&PreparedShape<Polygon<'_, SubPoint<Sub4>>, 64, 16>>,
    styled_shape::<&PreparedShape<Polygon<'_, SubPoint<Sub8>>, 64, 16>>,
    styled_shape::<Rectangle>,
    styled_shape::<RoundedRectangle>,
    styled_shape::<Sector>,
    styled_shape::<ThinCircle>,
    styled_shape::<Triangle>,
    every_target::<Circle>,
    every_target::<Line>,
    every_target::<Rectangle>,
    every_target::<Triangle>,
    styled_pixels,
    styled_areas,
    stroked_shape::<Line>,
    stroked_shape::<Path<'_, Sub4>>,
    stroked_shape::<Path<'_, Sub8>>,
    stroked_shape::<Polygon<'_, Point>>,
    stroked_shape::<Polygon<'_, SubPoint<Sub8>>>,
    stroked_shape::<Polyline<'_>>,
    stroked_shape::<Rectangle>,
    stroked_shape::<Triangle>,
    path::<Sub4>,
    path::<Sub8>,
    points,
    polygon::<Point>,
    polygon::<SubPoint<Sub4>>,
    polygon::<SubPoint<Sub8>>,
    primitive_style::<BinaryColor>,
    primitive_style::<Rgb565>,
    primitive_style::<Rgb888>,
    stroke_style,
    thin_circle,
    sub_outlines,
    sub_outline::<Path<'_, Sub4>>,
    sub_outline::<Path<'_, Sub8>>,
    sub_outline::<SubArc>,
    sub_outline::<SubEllipse>,
    sub_outline::<SubLine>,
    sub_outline::<Text<'_, OutlineTextStyle<Rgb565>>>,
    sub_outline::<[&[SubPoint<Sub4>]; 2]>,
    sub_outline::<[&[SubPoint<Sub8>]; 2]>,
    sub_outline::<Polygon<'_, Point>>,
    sub_outline::<Polygon<'_, SubPoint<Sub8>>>,
    antialiased_styles,
    groups,
    wrapped_items,
    picture_image::<BinaryColor, LittleEndian, BigEndian>,
    picture_image::<Rgb565, LittleEndian, BigEndian>,
    picture_image::<Rgb565, BigEndian, LittleEndian>,
    picture_image::<Rgb888, LittleEndian, BigEndian>,
    in_linear_light,
    antialiased_style::<Styled<Arc, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<Circle, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<Ellipse, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<Line, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<Path<'static, Sub8>, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<
        Styled<Polygon<'static, Point>, Antialiased<PrimitiveStyle<Rgb565>>>,
        Band<'_, Rgb565, LittleEndian>,
    >,
    antialiased_style::<Styled<Polyline<'static>, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<Rectangle, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<RoundedRectangle, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<Sector, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<SubArc, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<SubEllipse, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<SubLine, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<Triangle, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<Styled<Line, Antialiased<StrokeStyle<'static, Rgb565>>>, Band<'_, Rgb565, LittleEndian>>,
    antialiased_style::<
        Styled<Path<'static, Sub8>, Antialiased<StrokeStyle<'static, Rgb565>>>,
        Band<'_, Rgb565, LittleEndian>,
    >,
    antialiased_style::<
        Styled<Polyline<'static>, Antialiased<StrokeStyle<'static, Rgb565>>>,
        Band<'_, Rgb565, LittleEndian>,
    >,
    antialiased_bounds,
    antialiased_polygon::<SignedArea>,
    antialiased_polygon::<Rooks<4>>,
    draw_antialiased::<CentreSample, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<Grid<16, Gaussian>, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<InsideArea, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<Rooks<4>, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<Rooks<8>, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<Rooks<16>, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<SignedArea, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<SubScanlines<16>, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<AnyCoverage, Band<'_, Rgb565, LittleEndian>>,
    draw_antialiased::<SignedArea, Band<'_, BinaryColor, LittleEndian>>,
    samples::<Gray4, LittleEndian, Rooks<16>>,
    samples::<Rgb565, LittleEndian, Rooks<4>>,
    samples::<Rgb565, LittleEndian, Rooks<8>>,
    samples::<Rgb565, BigEndian, Rooks<4>>,
    samples::<Rgb888, LittleEndian, Grid<4>>,
    filtered_line,
    seed_fill,
    text,
    mask_text,
    outline_text,
    antialiased_outline,
    picture::<BinaryColor, LittleEndian>,
    picture::<Rgb565, LittleEndian>,
    picture::<Rgb888, BigEndian>,
    picture_item::<Text<'static, MonoTextStyle<'static, Rgb565>>>,
    picture_item::<Styled<Polyline<'static>, PrimitiveStyle<Rgb565>>>,
    picture_item::<MaskFont>,
    picture_item::<OutlineFont>,
    picture_item::<MonoFont<'static>>,
    picture_item::<ImageRaw<'static, Rgb565>>,
    prepare,
    values,
];

#[inline(never)]
fn text() {
    draw_on::<Text<'_, MonoTextStyle<'_, Rgb565>>, Band<'_, Rgb565, LittleEndian>>();
    let mut painted = any::<&mut Band<'_, Rgb565, LittleEndian>>().painted(any::<Pattern<'_, Rgb565>>());
    keep(any::<&Text<'_, MonoTextStyle<'_, Rgb565>>>().draw_on(&mut painted));
}

#[inline(never)]
fn mask_text() {
    blend_on::<Text<'_, MaskTextStyle<Rgb565>>, Band<'_, Rgb565, LittleEndian>>();
    blend_on::<Text<'_, MaskTextStyle<BinaryColor>>, Band<'_, BinaryColor, LittleEndian>>();
    text_renderer::<MaskTextStyle<Rgb565>, Display<Rgb565>>();
    text_renderer::<MaskTextStyle<Rgb565>, Band<'_, Rgb565, LittleEndian>>();
    character_style::<MaskTextStyle<Rgb565>>();
    keep(MaskTextStyle::<Rgb565>::new(any(), any()));
    keep(MaskTextStyle::<Rgb565>::on_background(any(), any()));
    clone::<MaskTextStyle<Rgb565>>();
    clone::<MaskGlyph>();
}

#[inline(never)]
fn outline_text() {
    antialiased_style::<Text<'_, OutlineTextStyle<Rgb565>>, Band<'_, Rgb565, LittleEndian>>();
    antialiased_style::<Text<'_, OutlineTextStyle<BinaryColor>>, Band<'_, BinaryColor, LittleEndian>>();
    text_renderer::<OutlineTextStyle<Rgb565>, Display<Rgb565>>();
    text_renderer::<OutlineTextStyle<Rgb565>, Band<'_, Rgb565, LittleEndian>>();
    character_style::<OutlineTextStyle<Rgb565>>();
    keep(OutlineTextStyle::<Rgb565>::new(any(), any(), any()));
    keep(OutlineTextStyle::<Rgb565>::on_background(any(), any()));
    clone::<OutlineTextStyle<Rgb565>>();
    clone::<OutlineGlyph>();
}

#[inline(never)]
fn blend_on<S: BlendOn + 'static, T: BlendTarget<Color = S::Color> + 'static>() {
    keep(<S as BlendOn>::draw_on::<T>(any(), any()));
}

#[inline(never)]
fn text_renderer<S: TextRenderer + 'static, T: DrawTarget<Color = S::Color> + 'static>() {
    keep(<S as TextRenderer>::draw_string::<T>(any(), any(), any(), any(), any()));
    keep(<S as TextRenderer>::draw_whitespace::<T>(
        any(),
        any(),
        any(),
        any(),
        any(),
    ));
    keep(<S as TextRenderer>::measure_string(any(), any(), any(), any()));
    keep(<S as TextRenderer>::line_height(any()));
}

#[inline(never)]
fn character_style<S: CharacterStyle + 'static>() {
    <S as CharacterStyle>::set_text_color(any(), any());
    <S as CharacterStyle>::set_background_color(any(), any());
    <S as CharacterStyle>::set_underline_color(any(), any());
    <S as CharacterStyle>::set_strikethrough_color(any(), any());
}

/// `Dimensions`, `StyledDrawable`, `StyledDimensions` and `DrawOn` as well.
#[inline(never)]
fn styled_shape<S>()
where
    S: Primitive
        + StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565>
        + StyledDimensions<PrimitiveStyle<Rgb565>>
        + Clone
        + 'static,
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
    Styled<S, primitives::PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
{
    dimensions::<S>();
    keep(<S as StyledDimensions<PrimitiveStyle<Rgb565>>>::styled_bounding_box(
        any(),
        any(),
    ));
    keep(
        <S as StyledDrawable<PrimitiveStyle<Rgb565>>>::draw_styled(any(), any(), any::<&mut Display<Rgb565>>()).is_ok(),
    );
    draw_on::<Styled<S, PrimitiveStyle<Rgb565>>, Band<'_, Rgb565, LittleEndian>>();
    draw_on::<Styled<S, primitives::PrimitiveStyle<Rgb565>>, Band<'_, Rgb565, LittleEndian>>();
}

/// What the iterators of a styled shape, whose types have no public names, do.
fn each_pixel<I: Iterator + Clone + 'static>(make: fn() -> I) {
    keep_all(make());
    iterator::<I>();
    clone::<I>();
}

#[inline(never)]
fn styled_pixels() {
    macro_rules! pixels {
        ($($shape:ty)+) => {
            $(each_pixel(|| any::<&'static Styled<$shape, PrimitiveStyle<Rgb565>>>().pixels());)+
        };
    }
    pixels! {
        Arc Circle Ellipse Line Path<'static, Sub4> Path<'static, Sub8> Points<'static> Polyline<'static>
        &'static PreparedShape<Path<'static, Sub4>, 64, 16> &'static PreparedShape<Path<'static, Sub8>, 64, 16>
        &'static PreparedShape<Polygon<'static, Point>, 64, 16> &'static PreparedShape<Polygon<'static, SubPoint<Sub4>>, 64, 16>
        &'static PreparedShape<Polygon<'static, SubPoint<Sub8>>, 64, 16> Rectangle RoundedRectangle Sector ThinCircle Triangle
    }
}

#[inline(never)]
fn styled_areas() {
    macro_rules! areas {
        ($($shape:ty)+) => {
            $(
                keep(any::<&Styled<$shape, PrimitiveStyle<Rgb565>>>().fill_area());
                keep(any::<&Styled<$shape, PrimitiveStyle<Rgb565>>>().stroke_area());
            )+
        };
    }
    areas!(Circle Ellipse Rectangle RoundedRectangle Sector);
}

/// A shape on the other kinds of targets. What a shape hands to a target does not depend on its kind, so a few shapes are
/// enough; every target takes whatever there is in the exercises of `surface`.
#[inline(never)]
fn every_target<S: 'static>()
where
    Styled<S, PrimitiveStyle<BinaryColor>>: DrawOn<Color = BinaryColor>,
    Styled<S, PrimitiveStyle<Gray4>>: DrawOn<Color = Gray4>,
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
    Styled<S, PrimitiveStyle<Rgb888>>: DrawOn<Color = Rgb888>,
{
    draw_on::<Styled<S, PrimitiveStyle<BinaryColor>>, Band<'_, BinaryColor, LittleEndian>>();
    draw_on::<Styled<S, PrimitiveStyle<Gray4>>, Band<'_, Gray4, BigEndian>>();
    draw_on::<Styled<S, PrimitiveStyle<Rgb888>>, Generic<'_, Display<Rgb888>>>();
    let light = || any::<&'static mut Band<'static, Rgb565, LittleEndian>>().in_linear_light::<22>();
    draw_on_light::<Styled<S, PrimitiveStyle<Rgb565>>, _>(light);
    keep(Band::<Rgb565, LittleEndian>::multisample(
        any(),
        any::<Rooks<4>>(),
        any(),
        |samples| {
            keep(any::<&Styled<S, PrimitiveStyle<Rgb565>>>().draw_on(samples));
        },
    ));
    let mut painted = any::<&mut Band<'_, Rgb888, BigEndian>>().painted(any::<LinearGradient<Rgb888, 2>>());
    keep(any::<&Styled<S, PrimitiveStyle<Rgb888>>>().draw_on(&mut painted));
}

/// A target whose type has no public name.
fn draw_on_light<S: DrawOn + 'static, T: Target<Color = S::Color> + 'static>(_: fn() -> T) {
    draw_on::<S, T>();
}

/// What blends, on a band in linear light, whose type has no public name.
#[inline(never)]
fn in_linear_light() {
    let mut light = Band::<'_, Rgb565, LittleEndian>::in_linear_light::<22>(any());
    keep(light.antialiased::<64, 16>(any()));
    keep(
        any::<&Styled<Circle, Antialiased<PrimitiveStyle<Rgb565>>>>().draw_on(&mut light.antialiased::<64, 16>(any())),
    );
    keep(any::<&AntialiasedPolygon<64, 16>>().draw(any::<&SignedArea>(), any(), &mut light, any()));
    keep(any::<&FilteredLine>().draw(&mut light, any()));
    let mut light = any::<&mut Band<'_, Rgb888, LittleEndian>>().in_linear_light::<22>();
    keep(any::<&Text<'_, MaskTextStyle<Rgb888>>>().draw_on(&mut light));
    keep(any::<&FilteredLine>().draw(&mut light, any()));
}

#[inline(never)]
fn draw_on<S: DrawOn + 'static, T: Target<Color = S::Color> + 'static>() {
    keep(<S as DrawOn>::draw_on::<T>(any(), any()));
}

/// `StyledDrawable`, `StyledDimensions` and `DrawOn` as well.
#[inline(never)]
fn stroked_shape<S>()
where
    S: Primitive
        + StyledDrawable<StrokeStyle<'static, Rgb565>, Color = Rgb565>
        + StyledDimensions<StrokeStyle<'static, Rgb565>>
        + 'static,
    Styled<S, StrokeStyle<'static, Rgb565>>: DrawOn<Color = Rgb565>,
{
    keep(<S as StyledDimensions<StrokeStyle<'static, Rgb565>>>::styled_bounding_box(any(), any()));
    keep(
        <S as StyledDrawable<StrokeStyle<'static, Rgb565>>>::draw_styled(any(), any(), any::<&mut Display<Rgb565>>())
            .is_ok(),
    );
    draw_on::<Styled<S, StrokeStyle<'static, Rgb565>>, Band<'_, Rgb565, LittleEndian>>();
}

#[inline(never)]
fn path<S: SubPixel>() {
    keep(Path::<S>::new(any(), any()));
    keep(Path::<S>::with_tolerance(any(), any()));
    keep(Path::<S>::prepare::<64, 16>(any()));
    clone::<Path<'_, S>>();
    eq::<PathCommand<S>>();
    keep(PreparedShape::<Path<'_, S>, 64, 16>::edge_count(any()));
    keep(PreparedShape::<Path<'_, S>, 64, 16>::into_styled::<
        PrimitiveStyle<Rgb565>,
    >(any(), any()));
    clone::<PreparedShape<Path<'_, S>, 64, 16>>();
}

#[inline(never)]
fn points() {
    keep(Points::squares(any(), any()));
    keep(Points::discs(any(), any()));
    hash::<Points<'_>>();
}

#[inline(never)]
fn polygon<V: Vertex + 'static>() {
    keep(Polygon::<V>::new(any(), any()));
    keep(Polygon::<V>::prepare::<64, 16>(any()));
    dimensions::<Polygon<'_, V>>();
    clone::<Polygon<'_, V>>();
    keep(PreparedShape::<Polygon<'_, V>, 64, 16>::edge_count(any()));
    clone::<PreparedShape<Polygon<'_, V>, 64, 16>>();
}

#[inline(never)]
fn primitive_style<C: PixelColor + Hash + 'static>() {
    keep(PrimitiveStyle::<C>::new());
    keep(PrimitiveStyle::<C>::with_stroke(any(), any()));
    keep(PrimitiveStyle::<C>::with_fill(any()));
    keep(PrimitiveStyle::<C>::is_transparent(any()));
    keep(PrimitiveStyle::<C>::effective_stroke_color(any()));
    keep(PrimitiveStyle::<C>::outside_stroke_width(any()));
    keep(PrimitiveStyle::<C>::inside_stroke_width(any()));
    hash::<PrimitiveStyle<C>>();
    default::<PrimitiveStyle<C>>();
    from::<primitives::PrimitiveStyle<C>, PrimitiveStyle<C>>();
    from::<PrimitiveStyle<C>, primitives::PrimitiveStyle<C>>();
}

#[inline(never)]
fn picture<C: BandColor, O: Order>() {
    keep(Picture::<C, O>::new(any(), any(), any(), any()));
    keep(Picture::<C, O>::with_damage(any(), any(), any()));
    keep(Picture::<C, O>::next_damage(any()));
    Picture::<C, O>::clear_damage(any());
    Picture::<C, O>::remove(any(), any());
    keep(Picture::<C, O>::translate(any(), any(), any()));
    Picture::<C, O>::clear(any());
    keep(Picture::<C, O>::slots_used(any()));
    keep(Picture::<C, O>::words_used(any()));
    keep(Picture::<C, O>::segments_needed(any()));
    keep(Picture::<C, O>::edges_needed(any()));
    Picture::<C, O>::draw(any(), any());
    default::<PictureSlot<'static, C, O>>();
    clone::<PictureSlot<'static, C, O>>();
    hash::<ItemId>();
}

#[inline(never)]
fn antialiased_outline() {
    let outline = keep_outline(any());
    keep(Picture::<'static, 'static, Rgb565>::add_outline(
        any(),
        outline,
        any(),
        any(),
    ));
    keep(Picture::<'static, 'static, Rgb565>::replace_outline(
        any(),
        any(),
        outline,
        any(),
        any(),
    ));
    keep(AntialiasingMemory::<65, 16, 8>::new());
    default::<AntialiasingMemory<65, 16, 8>>();
    keep(Picture::<'static, 'static, Rgb565>::with_antialiasing::<65, 16, 8>(
        any(),
        any(),
    ));
}

/// An outline of a kind that is not known.
#[inline(never)]
fn keep_outline(outline: &'static SubEllipse) -> &'static dyn SubOutline {
    outline
}

#[inline(never)]
fn picture_item<T: PictureItem<Rgb565> + 'static>() {
    keep(<T as PictureItem<Rgb565>>::bounds(any()));
    <T as PictureItem<Rgb565>>::draw(any(), any());
    keep(Picture::<Rgb565>::add_item::<T>(any(), any()));
    keep(Picture::<Rgb565>::replace_item::<T>(any(), any(), any()));
}

/// A picture draws what it prepares through function tables, all of which are linked with what fills them.
#[inline(never)]
fn prepare() {
    macro_rules! prepare {
        ($($item:ty),+ $(,)?) => {$(
            keep(Picture::<Rgb565>::add(any(), any::<&$item>()));
            keep(Picture::<Rgb565>::replace(any(), any(), any::<&$item>()));
        )+};
    }
    prepare!(
        Styled<Arc, PrimitiveStyle<Rgb565>>,
        Styled<Circle, PrimitiveStyle<Rgb565>>,
        Styled<Circle, primitives::PrimitiveStyle<Rgb565>>,
        Styled<Ellipse, PrimitiveStyle<Rgb565>>,
        Styled<Line, PrimitiveStyle<Rgb565>>,
        Styled<Line, StrokeStyle<'static, Rgb565>>,
        Styled<Path<'static, Sub8>, StrokeStyle<'static, Rgb565>>,
        Styled<Path<'static, Sub8>, PrimitiveStyle<Rgb565>>,
        Styled<Polygon<'static, Point>, PrimitiveStyle<Rgb565>>,
        Styled<Polyline<'static>, PrimitiveStyle<Rgb565>>,
        Styled<Rectangle, PrimitiveStyle<Rgb565>>,
        Styled<RoundedRectangle, PrimitiveStyle<Rgb565>>,
        Styled<Sector, PrimitiveStyle<Rgb565>>,
        Styled<ThinCircle, PrimitiveStyle<Rgb565>>,
        Styled<Triangle, PrimitiveStyle<Rgb565>>,
        Styled<Arc, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<Ellipse, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<Line, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<Path<'static, Sub8>, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<Polygon<'static, Point>, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<Rectangle, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<RoundedRectangle, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<Sector, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<SubArc, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<Triangle, Antialiased<PrimitiveStyle<Rgb565>>>,
        Styled<Polyline<'static>, Antialiased<StrokeStyle<'static, Rgb565>>>,
        Text<'static, MaskTextStyle<Rgb565>>,
        Text<'static, OutlineTextStyle<Rgb565>>,
        Text<'static, MonoTextStyle<'static, Rgb565>>,
    );
    type Disc = Styled<Circle, Antialiased<PrimitiveStyle<Rgb565>>>;
    keep(Picture::<Rgb565>::add(any(), any::<&Disc>()));
    keep(Picture::<Rgb565>::replace(any(), any(), any::<&Disc>()));
}

#[inline(never)]
fn groups() {
    keep(Group::new());
    keep(Group::clip(any(), any()));
    keep(Group::opacity(any(), any()));
    default::<Group>();
    eq::<Group>();
    keep(Picture::<'static, 'static, Rgb565>::with_group_rows(any(), any()));
    keep(Picture::<Rgb565>::begin_group(any(), any()));
    keep(Picture::<Rgb565>::end_group(any()));
    keep(Picture::<Rgb565>::replace_group(any(), any(), any()));
    keep(Picture::<BinaryColor>::begin_group(any(), any()));
    let path = keep_outline(any());
    keep(Picture::<'static, 'static, Rgb565>::begin_path_group(
        any(),
        any(),
        path,
        any(),
    ));
    keep(Picture::<'static, 'static, Rgb565>::replace_path_group(
        any(),
        any(),
        any(),
        path,
        any(),
    ));
}

#[inline(never)]
fn picture_image<C, O, BO>()
where
    C: BandColor + From<C::Raw> + Hash,
    O: Order,
    BO: ByteOrder + Hash + 'static,
    for<'b> RawDataSlice<'b, C::Raw, BO>: IntoIterator<Item = C::Raw>,
{
    keep(Picture::<'static, 'static, C, O>::add_image::<BO>(any(), any(), any()));
    keep(Picture::<'static, 'static, C, O>::replace_image::<BO>(
        any(),
        any(),
        any(),
        any(),
    ));
    Picture::<'static, 'static, C, O>::draw(any(), any());
}

/// Items by reference that wrap what is drawn.
#[inline(never)]
fn wrapped_items() {
    picture_item::<DrawableItem<Styled<Rectangle, PrimitiveStyle<Rgb565>>>>();
    eq::<DrawableItem<Styled<Rectangle, PrimitiveStyle<Rgb565>>>>();
    clone::<DrawableItem<Point>>();
    picture_item::<PaintedShape<Styled<Circle, PrimitiveStyle<Rgb565>>, LinearGradient<Rgb565, 2>>>();
    eq::<PaintedShape<Styled<Circle, PrimitiveStyle<Rgb565>>, Point>>();
    clone::<PaintedShape<Styled<Circle, PrimitiveStyle<Rgb565>>, LinearGradient<Rgb565, 2>>>();
    dimensions::<PaintedShape<Styled<Circle, PrimitiveStyle<Rgb565>>, LinearGradient<Rgb565, 2>>>();
    draw_on::<
        PaintedShape<Styled<Circle, PrimitiveStyle<Rgb565>>, LinearGradient<Rgb565, 2>>,
        Band<'_, Rgb565, LittleEndian>,
    >();
}

#[inline(never)]
fn stroke_style() {
    keep(StrokeStyle::<Rgb565>::new(any(), any()));
    keep(StrokeStyle::<Rgb565>::cap(any(), any()));
    keep(StrokeStyle::<Rgb565>::join(any(), any()));
    keep(StrokeStyle::<Rgb565>::dashes(any(), any()));
    keep(StrokeStyle::<Rgb565>::dash_offset(any(), any()));
    hash::<StrokeStyle<'_, Rgb565>>();
    from::<PrimitiveStyle<Rgb565>, StrokeStyle<'_, Rgb565>>();
    from::<primitives::PrimitiveStyle<Rgb565>, StrokeStyle<'_, Rgb565>>();
}

#[inline(never)]
fn thin_circle() {
    keep(ThinCircle::new(any(), any()));
    transform::<ThinCircle>();
    hash::<ThinCircle>();
    default::<ThinCircle>();
}

#[inline(never)]
fn sub_outlines() {
    keep(SubArc::new(any(), any(), any(), any()));
    keep(SubArc::ring(any(), any()));
    dimensions::<SubArc>();
    dimensions::<SubEllipse>();
    dimensions::<SubLine>();
    eq::<SubArc>();
    keep(SubEllipse::new(any(), any()));
    keep(SubEllipse::circle(any(), any()));
    keep(SubEllipse::edge_count(any()));
    eq::<SubEllipse>();
    keep(SubLine::new(any(), any(), any()));
    eq::<SubLine>();
}

/// A target with memory for antialiasing, and the styles that ask for it.
#[inline(never)]
fn antialiased_styles() {
    keep(PrimitiveStyle::<Rgb565>::antialiased(any()));
    keep(StrokeStyle::<Rgb565>::antialiased(any()));
    clone::<Antialiased<PrimitiveStyle<Rgb565>>>();
    eq::<Antialiased<PrimitiveStyle<Rgb565>>>();
    hash::<Antialiased<PrimitiveStyle<Rgb565>>>();
    keep(Band::<Rgb565, LittleEndian>::antialiased::<64, 16>(any(), any()));
    antialiased_style::<Styled<Circle, Antialiased<PrimitiveStyle<Rgb565>>>, Band<'_, Rgb565, LittleEndian>>();
}

#[inline(never)]
fn antialiased_style<S: DrawAntialiased + 'static, T: BlendTarget<Color = S::Color> + 'static>() {
    keep(<S as DrawAntialiased>::draw_on::<T, 64, 16>(any(), any()));
}

#[inline(never)]
fn sub_outline<O: SubOutline + 'static>() {
    <O as SubOutline>::edges(any(), any());
    keep(<O as SubOutline>::is_simple(any()));
    keep(<O as SubOutline>::anchor(any()));
    keep(AntialiasedPolygon::<64, 16>::prepare::<O>(any(), any()));
    keep(AntialiasedPolygon::<64, 16>::empty());
    keep(AntialiasedPolygon::<64, 16>::set_up::<O>(any(), any(), any()));
    keep(AntialiasedPolygon::<64, 16>::exact_method::<O>(any(), any()));
}

#[inline(never)]
fn antialiased_bounds() {
    keep(AntialiasedPolygon::<64, 16>::bounds(any()));
}

#[inline(never)]
fn antialiased_polygon<T: CoverageMethod + 'static>() {
    keep(AntialiasedPolygon::<64, 16>::cover::<T, DrawError<Failure>>(
        any(),
        any(),
        any(),
        any(),
        |span, coverage| take_both(span, coverage).map_err(DrawError::Target),
    ));
}

#[inline(never)]
fn draw_antialiased<T: CoverageMethod + 'static, B: BlendTarget + 'static>() {
    keep(AntialiasedPolygon::<64, 16>::draw::<T, B>(
        any(),
        any(),
        any(),
        any(),
        any(),
    ));
}

/// On targets with samples, whose types have no public name.
#[inline(never)]
fn samples<C: ChannelColor + 'static, O: Order, P: SamplePattern + 'static>() {
    keep(Band::<C, O>::multisample(any(), any::<P>(), any(), |samples| {
        keep(any::<&AntialiasedPolygon<64, 16>>().draw(any::<&SignedArea>(), any(), samples, any()));
        draw_samples(samples);
        draw_samples(&mut samples.painted(any::<Pattern<'_, C>>()));
    }));
}

#[inline(never)]
fn draw_samples<T: SampleTarget>(samples: &mut T) {
    keep(AntialiasedPolygon::<64, 16>::draw_samples::<T>(
        any(),
        any(),
        samples,
        any(),
    ));
}

#[inline(never)]
fn filtered_line() {
    keep(FilteredLine::new(any(), any()));
    keep(FilteredLine::draw(
        any(),
        any::<&mut Band<'_, Rgb565, LittleEndian>>(),
        any(),
    ));
    keep(FilteredLine::cover(any(), any(), take_both));
    dimensions::<FilteredLine>();
    eq::<FilteredLine>();
}

#[inline(never)]
fn seed_fill() {
    keep(SeedFill::<Rgb565, 32>::flood(
        any::<&Band<'_, Rgb565, LittleEndian>>(),
        any(),
        any(),
    ));
    keep(SeedFill::<Rgb565, 32>::flood(any::<&Display<Rgb565>>(), any(), any()));
    keep(SeedFill::<Rgb565, 32>::boundary(any(), any(), any()));
    keep(SeedFill::<Rgb565, 32>::eight_connected(any(), any()));
    keep(SeedFill::<Rgb565, 32>::with_stack::<64>(any()));
    keep(SeedFill::<Rgb565, 32>::run(
        any(),
        any::<&mut Band<'_, Rgb565, LittleEndian>>(),
    ));
    clone::<SeedFill<Rgb565, 32>>();
}

#[inline(never)]
fn values() {
    clone::<AntialiasedPolygon<64, 16>>();
    error::<DrawError<Failure>>();
    eq::<DrawError<Failure>>();
    from::<TooSmall, DrawError<Failure>>();
}
