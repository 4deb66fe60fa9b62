//! Flat shading under lights: one colour a face, as bright as the light on its normal. Computed once a face and frame, when
//! rows reach it, so that faces which are not seen take no time; nothing is kept for it, and a pixel costs what it costs
//! without lights.
//!
//! Source: Lambert (1760), with one normal a face (Bouknight 1970, "A procedure for generation of three-dimensional half-toned
//! computer graphics presentations").

use core::marker::PhantomData;

use crate::{
    geometry::TooSmall,
    mesh::{FaceSet, normal, unit_normal},
    shade::{
        ChannelColor, InstructionSet, Shading,
        layout::{Channel, Channels, Layout},
        shading::{
            lambert::Lambert,
            lighting::{LIGHT_BITS, Lighting, ReflectedLight},
        },
    },
    view::{Affine, Camera, Pose},
};

/// A colour for each face under lights ([`Lighting`]), the same all over the face.
///
/// As a [`Look`](crate::scene::Look), or as the shading of one: `Whole<FlatLit<Rgb565>>`.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FlatLit<C, L = Lambert<1>>(PhantomData<(C, L)>);

/// What [`FlatLit`] shading takes beside a mesh.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FlatLitSkin<'a, C, L = Lambert<1>> {
    /// The colours of the faces; the last one is that of all faces after it, so that one colour does for a model.
    pub colors: &'a [C],
    /// The normals of the faces, on an octahedron: for a normal of length 1, x / s and y / s in 1/127, where s is |x| + |y| +
    /// |z|; where z is below 0, (1 - |y| / s) with the sign of x, and (1 - |x| / s) with the sign of y.
    /// A coordinate of 0 has either sign.
    pub normals: &'a [[i8; 2]],
    /// The lights.
    pub lights: L,
}

impl<C: ChannelColor, L: Lighting> Shading for FlatLit<C, L> {
    type Color = C;
    type Skin<'a> = FlatLitSkin<'a, C, L>;
    type Uniforms = L::OfModel;
    type Attributes = ();
    const HAS_HOLES: bool = false;

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

    fn uniforms(skin: &Self::Skin<'_>, pose: &Pose, camera: &Camera) -> L::OfModel {
        skin.lights.seen_from(pose, camera)
    }

    #[inline]
    fn vertex(_: &Self::Skin<'_>, _: &L::OfModel, _: usize, _: [i32; 3]) {}

    #[inline]
    fn face(skin: &Self::Skin<'_>, lights: &L::OfModel, mesh: &FaceSet<'_>, face: usize) -> Option<C::Word> {
        let normal = unit_normal(*skin.normals.get(face)?);
        let position = if L::NEEDS_POSITIONS { middle(mesh, face) } else { [0; 3] };
        skin.lit_face(face, L::reflected(lights, normal, position))
    }

    #[inline]
    fn transformed_face(
        skin: &Self::Skin<'_>,
        lights: &L::OfModel,
        [map, normals]: [&Affine; 2],
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<C::Word> {
        let normal = normals.unit_vector(normal(*skin.normals.get(face)?));
        let position = if L::NEEDS_POSITIONS {
            map.position(middle(mesh, face))
        } else {
            [0; 3]
        };
        skin.lit_face(face, L::reflected(lights, normal, position))
    }

    #[inline]
    fn instructions(set: InstructionSet) -> [u32; 2] {
        [L::instructions(set).saturating_add(set.of([110, 65])), 0]
    }

    #[inline]
    fn fragment(_: &Self::Skin<'_>, face: C::Word, (): &()) -> Option<C::Word> {
        Some(face)
    }
}

/// The middle of a face: the mean of its corners.
fn middle(mesh: &FaceSet<'_>, face: usize) -> [i32; 3] {
    let mut middle = [0; 3];
    for corner in mesh.faces().get(face).into_iter().flatten() {
        let position = mesh.vertices().get(usize::from(*corner)).copied().unwrap_or_default();
        for (sum, coordinate) in middle.iter_mut().zip(position) {
            *sum += i32::from(coordinate);
        }
    }
    middle.map(|sum| sum / 3)
}

impl<C: ChannelColor, L> FlatLitSkin<'_, C, L> {
    /// The word of a face under a light.
    #[inline]
    fn lit_face(&self, face: usize, light: ReflectedLight) -> Option<C::Word> {
        let color = self.colors.get(face).or(self.colors.last())?;
        Some(lit::<C::Layout>(color.to_word(), light))
    }
}

/// A word under a light: its levels multiplied by the diffuse part and rounded to the nearest, and the highlight added.
#[inline]
fn lit<L: Layout>(word: L::Word, light: ReflectedLight) -> L::Word {
    let Channels { pair, middle } = L::split(word);
    let level = |channel: Channel, level: u32| {
        // A level of 8 bits at most times 2^15.
        let scaled = |level: u32, light: i32| (level * light as u32 + (1 << (LIGHT_BITS - 1))) >> LIGHT_BITS;
        let lit = scaled(level, light.diffuse);
        if light.specular > 0 {
            (lit + scaled(channel.max(), light.specular)).min(channel.max())
        } else {
            lit
        }
    };
    L::join(Channels {
        pair: level(L::LOW, pair & 0xffff) | level(L::HIGH, pair >> 16) << 16,
        middle: level(L::MIDDLE, middle),
    })
}
