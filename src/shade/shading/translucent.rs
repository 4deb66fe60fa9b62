//! Models through which what is behind them is seen: windows, water, ghosts.

use core::marker::PhantomData;

use embedded_graphics::geometry::Point;

use crate::{
    coverage::Coverage,
    geometry::TooSmall,
    mesh::{BoundingVolume, FacePlanes, FaceSet},
    shade::{BlendedColor, ChannelColor, Encoded, InstructionSet, Planes, Shading},
    surface::{BandColor, LittleEndian, Order},
    view::{Affine, Camera, Pose},
};

/// The shading `H` of models some of which are mixed with what is behind them.
///
/// What a model takes beside its mesh is that of `H` and an alpha: `(skin, alpha)`. A model of alpha 255 is opaque, its picture
/// that of `H` to the bit; one of alpha 0 is not there; others are blended as
/// [`blend_span`](crate::shade::BlendTarget::blend_span) blends, over all that is behind them.
///
/// The order of models does not matter, and faces may go through each other: in each pixel the farthest fragment is mixed
/// first, and of equally near ones the first in the order of the models lies over the others. A translucent fragment that is
/// exactly as near as an opaque one is behind it. What is drawn with the depths of a row afterwards
/// ([`draw_with`](crate::scene::Prepared::draw_with)) is hidden by translucent faces as by others.
///
/// Cost: no row of such a look is drawn without depths. A pixel of a translucent face is visited twice, and twice more for each
/// other translucent face in front of or behind it within 64 columns; mixing takes some 20 instructions. Memory: none, and up
/// to 512 bytes of stack. Where faces are drawn in passes ([`rows_in_passes`](crate::scene::Prepared::rows_in_passes)),
/// translucent ones are set up anew for each of those visits.
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<Translucent<Gouraud<Rgb565>>>`, within
/// [`Foggy`](crate::shade::Foggy) and [`Transformed`](crate::shade::Transformed).
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::{
///     band::Band,
///     geometry::InputError,
///     scene::{Camera, FaceSet, Memory, Model, Pose},
///     shade::Translucent,
/// };
/// use zrow::fixed::types::I16F16;
///
/// type Scene = Translucent<Gray8>;
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 0], [512, -512, 0]], &[[0, 1, 2]])?;
/// let mut memory = Memory::<Scene, 6, 2, 64, 64>::new();
/// // In front a window, through which a quarter of the light of the bright face behind it gets.
/// let mut window = Model::<Scene>::with_skin(mesh, (&[Gray8::BLACK], 192))?;
/// let mut bright = Model::<Scene>::with_skin(mesh, (&[Gray8::WHITE], 255))?;
/// window.pose.translation = [0, 0, 1024].map(I16F16::from_num);
/// bright.pose.translation = [0, 0, 1536].map(I16F16::from_num);
/// let models = [window, bright];
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mut words = [0; 64 * 64];
/// let mut band = Band::<Gray8>::new(area, &mut words)?;
/// memory.prepare(&camera, &models)?.draw(&mut band);
/// assert_eq!(band.words()[34 * 64 + 32], 63);
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Translucent<H>(PhantomData<H>);

impl<H: Shading<Color: ChannelColor>> Shading for Translucent<H> {
    type Color = H::Color;
    type Skin<'a> = (H::Skin<'a>, Coverage);
    type Uniforms = H::Uniforms;
    type Attributes = H::Attributes;
    const TOLERANCE: <H::Attributes as Planes>::Tolerance = H::TOLERANCE;
    const HAS_HOLES: bool = H::HAS_HOLES;
    const BLENDS: bool = {
        assert!(
            !H::BLENDS,
            "multiply the alphas instead of Translucent around Translucent"
        );
        true
    };
    const HAS_AFFINE_MAP: bool = H::HAS_AFFINE_MAP;
    const HAS_BOUNDS: bool = H::HAS_BOUNDS;
    const HAS_PLANES: bool = H::HAS_PLANES;

    fn check((skin, _): &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        H::check(skin, mesh)
    }

    fn uniforms((skin, _): &Self::Skin<'_>, pose: &Pose, camera: &Camera) -> Self::Uniforms {
        H::uniforms(skin, pose, camera)
    }

    #[inline]
    fn vertex(
        (skin, _): &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        vertex: usize,
        position: [i32; 3],
    ) -> H::Attributes {
        H::vertex(skin, uniforms, vertex, position)
    }

    #[inline]
    fn face(
        (skin, alpha): &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<<H::Color as BandColor>::Word> {
        if *alpha == 0 {
            return None;
        }
        H::face(skin, uniforms, mesh, face)
    }

    #[inline]
    fn instructions(set: InstructionSet) -> [u32; 2] {
        H::instructions(set)
    }

    #[inline(always)]
    fn fragment(
        (skin, _): &Self::Skin<'_>,
        face: <H::Color as BandColor>::Word,
        attributes: &<H::Attributes as Planes>::Values,
    ) -> Option<<H::Color as BandColor>::Word> {
        H::fragment(skin, face, attributes)
    }

    #[inline]
    fn is_translucent((_, alpha): &Self::Skin<'_>) -> bool {
        *alpha < Coverage::MAX
    }

    #[inline]
    fn blend(
        (_, alpha): &Self::Skin<'_>,
        fragment: <H::Color as BandColor>::Word,
        behind: <H::Color as BandColor>::Word,
        position: Point,
    ) -> <H::Color as BandColor>::Word {
        let mut word = [LittleEndian::reorder(behind)];
        H::Color::blend_run::<Encoded, LittleEndian>(&mut word, position, H::Color::from_word(fragment), *alpha);
        let [word] = word;
        LittleEndian::reorder(word)
    }

    #[inline]
    fn bounds((skin, _): &Self::Skin<'_>) -> Option<BoundingVolume> {
        H::bounds(skin)
    }

    #[inline]
    fn planes<'a>((skin, _): &Self::Skin<'a>) -> Option<FacePlanes<'a>> {
        H::planes(skin)
    }

    #[inline]
    fn affine<'s>((skin, _): &'s Self::Skin<'_>) -> &'s Affine {
        H::affine(skin)
    }

    #[inline]
    fn transformed_vertex(
        (skin, _): &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        normals: &Affine,
        vertex: usize,
        position: [i32; 3],
    ) -> H::Attributes {
        H::transformed_vertex(skin, uniforms, normals, vertex, position)
    }

    #[inline]
    fn transformed_face(
        (skin, alpha): &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        maps: [&Affine; 2],
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<<H::Color as BandColor>::Word> {
        if *alpha == 0 {
            return None;
        }
        H::transformed_face(skin, uniforms, maps, mesh, face)
    }
}
