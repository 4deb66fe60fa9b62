use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
};
use zrow::{
    band::{Band, BandColor, BigEndian, LittleEndian, Order, Target},
    coverage::{Bartlett, BoxFilter, Gaussian, Grid, Rooks, SamplePattern},
    geometry::TooSmall,
    scene::{Camera, FaceSet, Pose},
    shade::{
        Attributes, Bilinear, BlendTarget, Blinn, Bounded, ChannelColor, Clamped, ConeFilter, CutOut, DirectionalLight,
        FlatLit, FlatLitSkin, Fog, Foggy, Gouraud, GouraudSkin, Indexed, IndexedImage, Lambert, Lighting,
        LinearGradient, LitTextured, LitTexturedSkin, Paint, Pattern, Perspective, PointLight, RadialGradient, Ramp,
        ReflectedLight, SampleFilter, SampleTarget, Sampler, Shading, Texels, Texture, Textured, TexturedSkin,
        Transformed, Translucent, TwoSided, WithPlanes,
    },
};
use zrow_panics_firmware::{any, items, keep};

use crate::foreign::{clone, default, eq};

pub const EXERCISES: &[fn()] = &[
    channel_color::<BinaryColor>,
    channel_color::<Gray2>,
    channel_color::<Gray4>,
    channel_color::<Gray8>,
    channel_color::<Rgb555>,
    channel_color::<Bgr555>,
    channel_color::<Rgb565>,
    channel_color::<Bgr565>,
    channel_color::<Rgb666>,
    channel_color::<Bgr666>,
    channel_color::<Rgb888>,
    channel_color::<Bgr888>,
    over::<Rgb888, 24>,
    blend_target::<Band<'_, BinaryColor, LittleEndian>>,
    blend_target::<Band<'_, Rgb565, BigEndian>>,
    blend_target::<Band<'_, Rgb888, LittleEndian>>,
    || blend_target_of(|| any::<&'static mut Band<'static, Rgb565, LittleEndian>>().in_linear_light::<22>()),
    || blend_target_of(|| any::<&'static mut Band<'static, Rgb888, BigEndian>>().in_linear_light::<24>()),
    || blend_target_of(|| any::<&'static mut Band<'static, Rgb888, LittleEndian>>().in_linear_light::<10>()),
    linear_gradient::<2>,
    linear_gradient::<5>,
    radial_gradient::<2>,
    radial_gradient::<5>,
    pattern,
    ramp::<2>,
    ramp::<5>,
    paint::<LinearGradient<Rgb565, 2>>,
    paint::<LinearGradient<Rgb888, 5>>,
    paint::<RadialGradient<Rgb565, 2>>,
    paint::<RadialGradient<Rgb888, 5>>,
    paint::<Pattern<'_, BinaryColor>>,
    paint::<&Pattern<'_, Rgb565>>,
    sample_filters,
    samples::<Gray4, LittleEndian, Rooks<16>>,
    samples::<Rgb565, LittleEndian, Rooks<4>>,
    samples::<Rgb565, BigEndian, Rooks<4>>,
    samples::<Rgb888, LittleEndian, Grid<4>>,
    lights,
    skins,
    attributes::<()>,
    attributes::<[i16; 3]>,
    attributes::<Perspective<2>>,
    attributes::<Perspective<3, 1>>,
    shading::<Rgb565>,
    shading::<FlatLit<Rgb565>>,
    shading::<FlatLit<Rgb888, Lambert<4>>>,
    shading::<Gouraud<Rgb565>>,
    shading::<Gouraud<BinaryColor, Lambert<0>>>,
    shading::<Gouraud<Rgb888, Lambert<16>>>,
    shading::<Textured<Texels<Gray8, 1, 4096>>>,
    shading::<Textured<Texels<Rgb565, 64, 64>>>,
    shading::<Textured<Texels<Rgb565, 64, 64>, 8>>,
    shading::<LitTextured<Texels<Rgb565, 64, 64>, Lambert<1>, 4>>,
    shading::<LitTextured<Texels<Rgb565, 64, 64>>>,
    shading::<LitTextured<Texels<Rgb888, 1, 16>, Lambert<16>>>,
    shading::<Textured<Indexed<Rgb565, 8, 32, 2>>>,
    shading::<Textured<Bilinear<Clamped<CutOut<Indexed<Rgb888, 32, 32, 256>>>>>>,
    shading::<LitTextured<CutOut<Indexed<Rgb565, 16, 64, 16>>, Blinn<1, 1>>>,
    shading::<Gouraud<Rgb565, Lambert<1, 2>>>,
    shading::<FlatLit<Rgb888, Blinn<2, 3>>>,
    shading::<Foggy<Rgb565>>,
    shading::<Foggy<Gouraud<Rgb888, Blinn<1>>>>,
    shading::<Foggy<LitTextured<Bilinear<Texels<Rgb565, 64, 64>>>>>,
    shading::<Translucent<Rgb565>>,
    shading::<Translucent<Transformed<Gouraud<BinaryColor>>>>,
    shading::<Stripes>,
    shading::<Transformed<Rgb565>>,
    shading::<Transformed<FlatLit<Rgb888, Lambert<4>>>>,
    shading::<Transformed<Gouraud<Rgb565>>>,
    shading::<Transformed<LitTextured<Texels<Rgb565, 64, 64>>>>,
    shading::<Transformed<Stripes>>,
    shading::<Bounded<Rgb565>>,
    shading::<WithPlanes<Rgb565>>,
    shading::<WithPlanes<Foggy<Translucent<Gouraud<Rgb888>>>>>,
    shading::<Bounded<Transformed<LitTextured<Texels<Rgb565, 64, 64>>>>>,
    attributes::<([i16; 2], Perspective<1>)>,
    lighting::<Lambert<0>>,
    lighting::<Lambert<2, 2>>,
    lighting::<Blinn<2, 2>>,
    lighting::<TwoSided<Lambert<2, 2>>>,
    lighting::<TwoSided<Blinn<1>>>,
    texture::<Texels<Gray8, 1, 4096>>,
    texture::<Texels<Rgb565, 64, 64>>,
    texture::<Indexed<Rgb565, 1, 1, 2>>,
    texture::<Indexed<Rgb565, 8, 8, 4>>,
    texture::<Indexed<Rgb888, 8, 8, 16>>,
    texture::<CutOut<Indexed<Rgb888, 64, 8, 256>>>,
    texture::<Clamped<Texels<Rgb565, 2, 2>>>,
    sampler::<Bilinear<Texels<Rgb565, 64, 64>>>,
];

#[inline(never)]
fn channel_color<C: ChannelColor>() {
    over::<C, 10>();
    over::<C, 22>();
}

#[inline(never)]
fn over<C: ChannelColor, const TENTHS: u32>() {
    keep(<C as ChannelColor>::over::<TENTHS>(any(), any(), any(), any()));
}

/// The target that a function returns, whose type has no public name.
#[inline(never)]
fn blend_target_of<T: BlendTarget + 'static>(_: fn() -> T) {
    blend_target::<T>();
}

#[inline(never)]
fn blend_target<T: BlendTarget>() {
    keep(<T as BlendTarget>::blend_span(any(), any(), any(), any()));
}

#[inline(never)]
fn linear_gradient<const STOPS: usize>() {
    keep(LinearGradient::<Rgb565, STOPS>::new(any(), any(), any()));
    eq::<LinearGradient<Rgb565, STOPS>>();
}

#[inline(never)]
fn radial_gradient<const STOPS: usize>() {
    keep(RadialGradient::<Rgb565, STOPS>::new(any(), any(), any()));
    eq::<RadialGradient<Rgb565, STOPS>>();
}

#[inline(never)]
fn pattern() {
    keep(Pattern::<Rgb565>::new(any(), any()));
    keep(Pattern::<Rgb565>::with_origin(any(), any()));
    eq::<Pattern<'_, Rgb565>>();
}

#[inline(never)]
fn ramp<const STOPS: usize>() {
    keep(Ramp::between(any(), any()));
    keep(Ramp::<STOPS>::new(any()));
    keep(Ramp::<STOPS>::color_at(any(), any()));
    eq::<Ramp<STOPS>>();
}

#[inline(never)]
fn paint<P: Paint + 'static>() {
    for color in <P as Paint>::colors_from(any(), any()) {
        keep(color);
    }
}

#[inline(never)]
fn sample_filters() {
    sample_filter::<2, BoxFilter>();
    sample_filter::<4, Bartlett>();
    sample_filter::<8, ConeFilter>();
    sample_filter::<16, Gaussian>();
    eq::<ConeFilter>();
    default::<ConeFilter>();
}

#[inline(never)]
fn sample_filter<const N: usize, F: SampleFilter<N>>() {
    keep(<F as SampleFilter<N>>::weight(any(), any()));
    keep(<F as SampleFilter<N>>::PIXELS);
    keep(<F as SampleFilter<N>>::SUM_BITS);
}

/// Targets with samples, whose types have no public name: they blend as well, and take a paint.
#[inline(never)]
fn samples<C: ChannelColor + 'static, O: Order, P: SamplePattern + 'static>() {
    keep(Band::<C, O>::multisample(any(), any::<P>(), any(), |samples| {
        blend_target_like(samples);
        sample_target(samples);
        sample_target(&mut samples.painted(any::<Pattern<'_, C>>()));
    }));
}

fn blend_target_like<T: BlendTarget>(_: &mut T) {
    blend_target::<T>();
}

#[inline(never)]
fn sample_target<T: SampleTarget>(samples: &mut T) {
    keep(<T as SampleTarget>::fill_samples(samples, any(), any(), any()));
    keep(<T as SampleTarget>::set_samples(samples, any(), any(), items()));
}

#[inline(never)]
fn lights() {
    keep(DirectionalLight::from_direction(any(), any()));
    eq::<DirectionalLight>();
    eq::<Lambert<2>>();
    eq::<Lambert<2, 2>>();
    eq::<PointLight>();
    eq::<Blinn<1, 1>>();
    eq::<ReflectedLight>();
    eq::<Fog<'_, Rgb565>>();
    eq::<IndexedImage<'_, Rgb565, 8, 8, 4>>();
}

#[inline(never)]
fn skins() {
    eq::<FlatLitSkin<'_, Rgb565>>();
    eq::<TwoSided<Lambert<1>>>();
    eq::<GouraudSkin<'_, Rgb565>>();
    clone::<TexturedSkin<'_, Texels<Rgb565, 64, 64>>>();
    clone::<LitTexturedSkin<'_, Texels<Rgb565, 64, 64>>>();
    eq::<Perspective<2>>();
}

#[inline(never)]
fn attributes<A: Attributes>() {
    keep(A::ZERO);
}

#[inline(never)]
fn shading<H: Shading>() {
    keep(<H as Shading>::check(any(), any()));
    keep(<H as Shading>::uniforms(any(), any(), any()));
    keep(<H as Shading>::vertex(any(), any(), any(), any()));
    keep(<H as Shading>::face(any(), any(), any(), any()));
    keep(<H as Shading>::fragment(any(), any(), any()));
    keep(<H as Shading>::instructions(any()));
    keep(<H as Shading>::affine(any()));
    keep(<H as Shading>::transformed_vertex(any(), any(), any(), any(), any()));
    keep(<H as Shading>::transformed_face(any(), any(), any(), any(), any()));
    keep(<H as Shading>::bounds(any()));
    keep(<H as Shading>::planes(any()));
    keep(<H as Shading>::is_translucent(any()));
    keep(<H as Shading>::blend(any(), any(), any(), any()));
    keep((H::TOLERANCE, H::HAS_AFFINE_MAP, H::HAS_BOUNDS, H::HAS_PLANES, H::BLENDS));
}

#[inline(never)]
fn lighting<L: Lighting>() {
    keep(<L as Lighting>::seen_from(any(), any(), any()));
    keep(<L as Lighting>::reflected(any(), any(), any()));
    keep(<L as Lighting>::instructions(any()));
    keep(L::NEEDS_NORMALS);
    keep(L::NEEDS_POSITIONS);
}

#[inline(never)]
fn texture<T: Texture<Color: ChannelColor>>() {
    keep(<T as Texture>::texel(any(), any(), any()));
    keep(<T as Texture>::instructions(any()));
    keep(<T as Texture>::column(any()));
    keep(<T as Texture>::row(any()));
    sampler::<T>();
    sampler::<Bilinear<T>>();
}

#[inline(never)]
fn sampler<T: Sampler>() {
    keep(<T as Sampler>::sample(any(), any()));
    keep(<T as Sampler>::instructions(any()));
}

/// A program's own shading, in perspective.
#[derive(Debug)]
pub struct Stripes;

/// The same with attributes that vary evenly on the screen.
#[derive(Debug)]
pub struct EvenStripes;

macro_rules! own_shading {
    ($name:ident, $attributes:ty, $values:ty) => {
        impl Shading for $name {
            type Color = Rgb565;
            type Skin<'a> = &'a [Rgb565];
            type Uniforms = i32;
            type Attributes = $attributes;
            const TOLERANCE: u16 = 3;

            fn check(_: &Self::Skin<'_>, _: &FaceSet<'_>) -> Result<(), TooSmall> {
                any()
            }

            fn uniforms(_: &Self::Skin<'_>, _: &Pose, _: &Camera) -> i32 {
                any()
            }

            fn vertex(_: &Self::Skin<'_>, _: &i32, _: usize, _: [i32; 3]) -> Self::Attributes {
                any()
            }

            fn face(_: &Self::Skin<'_>, _: &i32, _: &FaceSet<'_>, _: usize) -> Option<<Rgb565 as BandColor>::Word> {
                any()
            }

            fn fragment(skin: &Self::Skin<'_>, face: u16, values: &$values) -> Option<u16> {
                let word = values
                    .iter()
                    .fold(face, |word, value| match skin.get(*value as usize) {
                        Some(color) => word ^ color.to_word(),
                        None => word,
                    });
                (word != 0).then_some(word)
            }
        }
    };
}

own_shading!(Stripes, Perspective<5>, [i32; 5]);
own_shading!(EvenStripes, [i16; 4], [i32; 4]);
