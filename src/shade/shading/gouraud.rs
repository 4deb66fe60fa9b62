//! Gouraud shading: light and colour at the vertices, and evenly between them.
//!
//! A face of one colour under lights becomes a face whose channels vary; a plane through the corners gives each channel at each
//! pixel. What is bright inside a face but not at a corner is not seen: that is what finer meshes are for.
//!
//! Guarantees: at a pixel centre a channel is the nearest level to the exact plane through its corners' levels, to within 1/256 of a
//! level; no level wraps. Cost: three additions a pixel; 12 bytes a channel for each active face, 6 bytes a vertex.
//!
//! Source: Gouraud (1971), "Continuous shading of curved surfaces".

use core::marker::PhantomData;

use crate::{
    geometry::TooSmall,
    mesh::{FaceSet, normal, unit_normal},
    shade::{
        ChannelColor, Shading,
        layout::{Channel, Channels, Layout},
        shading::lambert::{LIGHT_BITS, Lambert, ModelLights},
    },
    view::{Affine, Pose},
};

/// Colours at the vertices under `LIGHTS` lights, and evenly between them on the screen (Gouraud 1971).
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<Gouraud<Rgb565>>`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gouraud<C, const LIGHTS: usize = 1>(PhantomData<C>);

/// What [`Gouraud`] shading takes beside a mesh.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GouraudSkin<'a, C, const LIGHTS: usize = 1> {
    /// The colours of the vertices; the last one is that of all vertices after it, so that one colour does for a model.
    pub colors: &'a [C],
    /// The normals of the vertices, on an octahedron: for a normal of length 1, x / s and y / s in 1/127, where s is |x| + |y| + |z|;
    /// where z is below 0, (1 - |y| / s) with the sign of x, and (1 - |x| / s) with the sign of y. Not used without lights.
    pub normals: &'a [[i8; 2]],
    /// The lights.
    pub lights: Lambert<LIGHTS>,
}

impl<C: ChannelColor, const LIGHTS: usize> Shading for Gouraud<C, LIGHTS> {
    type Color = C;
    type Skin<'a> = GouraudSkin<'a, C, LIGHTS>;
    type Uniforms = ModelLights<LIGHTS>;
    type Attributes = [i16; 3];

    fn check(skin: &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        let vertices = mesh.vertices().len();
        if skin.colors.is_empty() && vertices > 0 {
            return Err(TooSmall::Colors(1));
        }
        if LIGHTS > 0 && skin.normals.len() < vertices {
            return Err(TooSmall::Normals(vertices));
        }
        Ok(())
    }

    fn uniforms(skin: &Self::Skin<'_>, pose: &Pose) -> ModelLights<LIGHTS> {
        skin.lights.seen_from(pose)
    }

    #[inline]
    fn vertex(skin: &Self::Skin<'_>, lights: &ModelLights<LIGHTS>, vertex: usize) -> [i16; 3] {
        skin.lit_vertex(lights, vertex, unit_normal)
    }

    #[inline]
    fn transformed_vertex(
        skin: &Self::Skin<'_>,
        lights: &ModelLights<LIGHTS>,
        normals: &Affine,
        vertex: usize,
    ) -> [i16; 3] {
        skin.lit_vertex(lights, vertex, |bytes| normals.unit_vector(normal(bytes)))
    }

    #[inline]
    fn face(_: &Self::Skin<'_>, _: &ModelLights<LIGHTS>, _: usize) -> Option<C::Word> {
        Some(C::Layout::narrow(0))
    }

    #[inline(always)]
    fn fragment(_: &Self::Skin<'_>, _: C::Word, [low, middle, high]: &[i32; 3]) -> C::Word {
        word_of::<C>([*low, *middle, *high])
    }
}

impl<C: ChannelColor, const LIGHTS: usize> GouraudSkin<'_, C, LIGHTS> {
    /// The channels of a vertex under lights, for how two bytes are a normal of length 1.
    #[inline(always)]
    fn lit_vertex(
        &self,
        lights: &ModelLights<LIGHTS>,
        vertex: usize,
        unit_normal: impl FnOnce([i8; 2]) -> [i32; 3],
    ) -> [i16; 3] {
        let color = self.colors.get(vertex).or(self.colors.last());
        let normal = if LIGHTS == 0 {
            [0; 3]
        } else {
            unit_normal(self.normals.get(vertex).copied().unwrap_or_default())
        };
        let word = color.map_or(C::Layout::narrow(0), |color| color.to_word());
        levels::<C::Layout>(C::Layout::split(word), lights.on(normal))
    }
}

/// Bits of a channel at a vertex: few, so that no gradient but that of a sliver is too steep for one division a face.
const CHANNEL_BITS: u32 = 12;

/// The levels of the channels of a colour under a light, as fractions of the channel in 1/4,096, in the middle of the level.
#[inline]
fn levels<L: Layout>(Channels { pair, middle }: Channels, light: i32) -> [i16; 3] {
    let level = |channel: Channel, level: u32| {
        if channel.bits == 0 {
            return 0;
        }
        // Half a level from both ends: what rounding adds stays between them.
        let half = 1 << (CHANNEL_BITS - 1 - channel.bits);
        let full = (level << (CHANNEL_BITS - channel.bits)) as i32;
        (((full * light) >> LIGHT_BITS) + half) as i16
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
