//! Colour of a fragment, and of the pixels of a 2D shape.
//!
//! A [`Shading`] gives the faces of a scene their colours: any colour itself (one a face), [`FlatLit`], [`Gouraud`],
//! [`Textured`], [`LitTextured`], or a type of the program's own. The row loop of the depth row is generic over it, so that
//! each shading gets its own loop and carries only what it interpolates. [`Lambert`] is the light on their vertices.
//!
//! A paint is one file with the signature of [`Paint`]: [`Pattern`], [`LinearGradient`], [`RadialGradient`].
//! [`Target::painted`](crate::band::Target::painted) makes a target on which any shape is drawn in one.
//!
//! [`ChannelColor`] mixes a colour with what is below it; [`BlendTarget`] is the entry point of what is drawn so.
//!
//! A [`SampleFilter`] weighs the samples of supersampling, and a [`SampleTarget`] takes those of multisampling.

mod blend;
mod blend_target;
mod channel_color;
mod instruction_set;
pub(crate) mod layout;
mod ordered_dither;
mod ordered_threshold;
mod paint;
pub(crate) mod samples;
mod shading;
mod span_blender;
mod texture;

pub use crate::surface::Paint;
pub(crate) use blend::{Encoded, Gamma, TransferFunction};
pub(crate) use blend_target::BatchBlend;
pub use blend_target::BlendTarget;
pub use channel_color::ChannelColor;
pub(crate) use channel_color::{BlendedColor, blend_words};
pub use instruction_set::InstructionSet;
pub(crate) use ordered_dither::dither;
pub use paint::{LinearGradient, Pattern, RadialGradient, Ramp};
pub use samples::{ConeFilter, SampleFilter, SampleTarget};
pub(crate) use samples::{SampleSum, SampleWeights};
pub(crate) use shading::{AttributeInstructions, Flat, PlaneSource, Planes, Run, Shade};
pub use shading::{
    Attributes, Blinn, Bounded, DirectionalLight, FlatLit, FlatLitSkin, Fog, Foggy, Gouraud, GouraudSkin, Lambert,
    Lighting, LitTextured, LitTexturedSkin, Perspective, PointLight, ReflectedLight, Shading, Textured, TexturedSkin,
    Transformed, Translucent, TwoSided, WithPlanes,
};
pub(crate) use span_blender::SpanBlender;
pub use texture::{Bilinear, Clamped, CutOut, Indexed, IndexedImage, Sampler, Texels, Texture};
