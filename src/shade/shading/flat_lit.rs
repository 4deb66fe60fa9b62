//! Flat shading under lights: one colour a face, as bright as the light on its normal. Computed once a face and frame, when rows
//! reach it, so that faces which are not seen take no time; nothing is kept for it, and a pixel costs what it costs without lights.
//!
//! Source: Lambert (1760), with one normal a face (Bouknight 1970, "A procedure for generation of three-dimensional half-toned computer
//! graphics presentations").

use core::marker::PhantomData;

use crate::{
    geometry::TooSmall,
    mesh::{FaceSet, normal, unit_normal},
    shade::{
        ChannelColor, Shading,
        layout::{Channels, Layout},
        shading::lambert::{LIGHT_BITS, Lambert, ModelLights},
    },
    view::{Affine, Pose},
};

/// A colour for each face under `LIGHTS` lights, the same all over the face.
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<FlatLit<Rgb565>>`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FlatLit<C, const LIGHTS: usize = 1>(PhantomData<C>);

/// What [`FlatLit`] shading takes beside a mesh.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FlatLitSkin<'a, C, const LIGHTS: usize = 1> {
    /// The colours of the faces; the last one is that of all faces after it, so that one colour does for a model.
    pub colors: &'a [C],
    /// The normals of the faces, on an octahedron: for a normal of length 1, x / s and y / s in 1/127, where s is |x| + |y| + |z|;
    /// where z is below 0, (1 - |y| / s) with the sign of x, and (1 - |x| / s) with the sign of y.
    pub normals: &'a [[i8; 2]],
    /// The lights.
    pub lights: Lambert<LIGHTS>,
}

impl<C: ChannelColor, const LIGHTS: usize> Shading for FlatLit<C, LIGHTS> {
    type Color = C;
    type Skin<'a> = FlatLitSkin<'a, C, LIGHTS>;
    type Uniforms = ModelLights<LIGHTS>;
    type Attributes = ();

    fn check(skin: &Self::Skin<'_>, mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        let faces = mesh.faces().len();
        if skin.colors.is_empty() && faces > 0 {
            return Err(TooSmall::Colors(1));
        }
        if skin.normals.len() < faces {
            return Err(TooSmall::Normals(faces));
        }
        Ok(())
    }

    fn uniforms(skin: &Self::Skin<'_>, pose: &Pose) -> ModelLights<LIGHTS> {
        skin.lights.seen_from(pose)
    }

    #[inline]
    fn vertex(_: &Self::Skin<'_>, _: &ModelLights<LIGHTS>, _: usize) {}

    #[inline]
    fn face(skin: &Self::Skin<'_>, lights: &ModelLights<LIGHTS>, face: usize) -> Option<C::Word> {
        let light = lights.on(unit_normal(*skin.normals.get(face)?));
        skin.lit_face(face, light)
    }

    #[inline]
    fn transformed_face(
        skin: &Self::Skin<'_>,
        lights: &ModelLights<LIGHTS>,
        normals: &Affine,
        face: usize,
    ) -> Option<C::Word> {
        let light = lights.on(normals.unit_vector(normal(*skin.normals.get(face)?)));
        skin.lit_face(face, light)
    }

    #[inline]
    fn fragment(_: &Self::Skin<'_>, face: C::Word, (): &()) -> C::Word {
        face
    }
}

impl<C: ChannelColor, const LIGHTS: usize> FlatLitSkin<'_, C, LIGHTS> {
    /// The word of a face under a light in 1/32,768.
    #[inline]
    fn lit_face(&self, face: usize, light: i32) -> Option<C::Word> {
        let color = self.colors.get(face).or(self.colors.last())?;
        Some(lit::<C::Layout>(color.to_word(), light))
    }
}

/// A word whose levels are multiplied by a light in 1/32,768 and rounded to the nearest.
#[inline]
fn lit<L: Layout>(word: L::Word, light: i32) -> L::Word {
    let Channels { pair, middle } = L::split(word);
    // A level of 8 bits at most times 2^15.
    let level = |level: u32| (level * light as u32 + (1 << (LIGHT_BITS - 1))) >> LIGHT_BITS;
    L::join(Channels {
        pair: level(pair & 0xffff) | level(pair >> 16) << 16,
        middle: level(middle),
    })
}
