//! Gouraud shading: light and colour at the vertices, and evenly between them.
//!
//! A face of one colour under lights becomes a face whose channels vary; a plane through the corners gives each channel at each
//! pixel. What is bright inside a face but not at a corner is not seen: that is what finer meshes are for.
//!
//! Guarantees: at a pixel centre a channel is the nearest level to the exact plane through its corners' levels, to within 1/256
//! of a level; no level wraps. Cost: three additions a pixel; 12 bytes a channel for each active face, 6 bytes a vertex.
//!
//! Source: Gouraud (1971), "Continuous shading of curved surfaces".

use core::marker::PhantomData;

use crate::{
    geometry::TooSmall,
    mesh::{FaceSet, normal, unit_normal},
    shade::{
        ChannelColor, InstructionSet, Shading,
        layout::{Channel, Channels, Layout},
        shading::{
            lambert::Lambert,
            lighting::{FULL, LIGHT_BITS, Lighting, ReflectedLight},
        },
    },
    view::{Affine, Camera, Pose},
};

/// Colours at the vertices under lights ([`Lighting`]), and evenly between them on the screen (Gouraud 1971).
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<Gouraud<Rgb565>>`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gouraud<C, L = Lambert<1>>(PhantomData<(C, L)>);

/// What [`Gouraud`] shading takes beside a mesh.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GouraudSkin<'a, C, L = Lambert<1>> {
    /// The colours of the vertices; the last one is that of all vertices after it, so that one colour does for a model.
    pub colors: &'a [C],
    /// The normals of the vertices, on an octahedron: for a normal of length 1, x / s and y / s in 1/127, where s is |x| +
    /// |y| + |z|; where z is below 0, (1 - |y| / s) with the sign of x, and (1 - |x| / s) with the sign of y.
    /// A coordinate of 0 has either sign. Not used without lights.
    pub normals: &'a [[i8; 2]],
    /// The lights.
    pub lights: L,
}

impl<C: ChannelColor, L: Lighting> Shading for Gouraud<C, L> {
    type Color = C;
    type Skin<'a> = GouraudSkin<'a, C, L>;
    type Uniforms = L::OfModel;
    type Attributes = [i16; 3];
    const HAS_HOLES: bool = false;

    fn check(skin: &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        let vertices = mesh.vertices().len();
        if skin.colors.is_empty() && vertices > 0 {
            return Err(TooSmall::Colors(1));
        }
        if L::NEEDS_NORMALS && skin.normals.len() < vertices {
            return Err(TooSmall::Normals(vertices));
        }
        Ok(())
    }

    fn uniforms(skin: &Self::Skin<'_>, pose: &Pose, camera: &Camera) -> L::OfModel {
        skin.lights.seen_from(pose, camera)
    }

    #[inline]
    fn vertex(skin: &Self::Skin<'_>, lights: &L::OfModel, vertex: usize, position: [i32; 3]) -> [i16; 3] {
        skin.lit_vertex(vertex, |bytes| L::reflected(lights, unit_normal(bytes), position))
    }

    #[inline]
    fn transformed_vertex(
        skin: &Self::Skin<'_>,
        lights: &L::OfModel,
        normals: &Affine,
        vertex: usize,
        position: [i32; 3],
    ) -> [i16; 3] {
        skin.lit_vertex(vertex, |bytes| {
            L::reflected(lights, normals.unit_vector(normal(bytes)), position)
        })
    }

    #[inline]
    fn instructions(set: InstructionSet) -> [u32; 2] {
        [0, set.of([25, 7])]
    }

    #[inline(always)]
    fn fragment(_: &Self::Skin<'_>, _: C::Word, [low, middle, high]: &[i32; 3]) -> Option<C::Word> {
        Some(word_of::<C>([*low, *middle, *high]))
    }
}

impl<C: ChannelColor, L: Lighting> GouraudSkin<'_, C, L> {
    /// The channels of a vertex, for the light on the two bytes of a normal.
    #[inline(always)]
    fn lit_vertex(&self, vertex: usize, light: impl FnOnce([i8; 2]) -> ReflectedLight) -> [i16; 3] {
        let color = self.colors.get(vertex).or(self.colors.last());
        let normal = if L::NEEDS_NORMALS {
            self.normals.get(vertex).copied().unwrap_or_default()
        } else {
            [0; 2]
        };
        let word = color.map_or(C::Layout::narrow(0), |color| color.to_word());
        levels::<C::Layout>(C::Layout::split(word), light(normal))
    }
}

/// Bits of a channel at a vertex: few, so that no gradient but that of a sliver is too steep for one division a face.
const CHANNEL_BITS: u32 = 12;

/// The levels of the channels of a colour under a light, as fractions of the channel in 1/4,096, in the middle of the level.
#[inline]
fn levels<L: Layout>(Channels { pair, middle }: Channels, light: ReflectedLight) -> [i16; 3] {
    let level = |channel: Channel, level: u32| {
        if channel.bits == 0 {
            return 0;
        }
        // Half a level from both ends: what rounding adds stays between them.
        let half = 1 << (CHANNEL_BITS - 1 - channel.bits);
        let scaled = |level: u32, light: i32| (((level << (CHANNEL_BITS - channel.bits)) as i32) * light) >> LIGHT_BITS;
        let mut lit = scaled(level, light.diffuse);
        if light.specular > 0 {
            lit = (lit + scaled(channel.max(), light.specular)).min(scaled(channel.max(), FULL));
        }
        (lit + half) as i16
    };
    [
        level(L::LOW, pair & 0xffff),
        level(L::MIDDLE, middle),
        level(L::HIGH, pair >> 16),
    ]
}

/// The word of channels in 1/4,096 with 16 fractional bits.
#[inline(always)]
fn word_of<C: ChannelColor>([low, middle, high]: [i32; 3]) -> C::Word {
    let level = |channel: Channel, value: i32| {
        if channel.bits == 0 {
            0
        } else {
            value as u32 >> (CHANNEL_BITS + 16 - channel.bits)
        }
    };
    C::Layout::join(Channels {
        pair: level(C::Layout::LOW, low) | level(C::Layout::HIGH, high) << 16,
        middle: level(C::Layout::MIDDLE, middle),
    })
}
