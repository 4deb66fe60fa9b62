//! How the faces of a scene get their colours: a shading is one file that implements [`Shading`].
//!
//! A shading runs in three places, as a GPU's shaders do: once a model and frame ([`Shading::uniforms`]), once a vertex and
//! frame ([`Shading::vertex`]), and once a pixel ([`Shading::fragment`]), or, where nothing varies over a face, once a face
//! ([`Shading::face`]). What a vertex has beside its position are its [`Attributes`]; a plane through its corners gives each of
//! them at each pixel of a face.

mod attributes;
mod blinn;
mod bounded;
#[cfg(test)]
mod double_vectors;
mod flat;

mod flat_lit;
mod foggy;
mod gouraud;
mod lambert;
mod lighting;
mod lit_textured;
mod mapped;
mod perspective;
mod point_light;
mod textured;
mod transformed;
mod translucent;
mod two_sided;
mod with_planes;

pub use attributes::Attributes;
pub(crate) use attributes::{AttributeInstructions, PlaneSource, Planes, Run};
pub use blinn::Blinn;
pub use bounded::Bounded;
pub(crate) use flat::Flat;
pub use flat_lit::{FlatLit, FlatLitSkin};
pub use foggy::{Fog, Foggy};
pub use gouraud::{Gouraud, GouraudSkin};
pub use lambert::{DirectionalLight, Lambert};
pub use lighting::{Lighting, ReflectedLight};
pub use lit_textured::{LitTextured, LitTexturedSkin};
pub use perspective::Perspective;
pub use point_light::PointLight;
pub use textured::{Textured, TexturedSkin};
pub use transformed::Transformed;
pub use translucent::Translucent;
pub use two_sided::TwoSided;
pub use with_planes::WithPlanes;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::TooSmall,
    mesh::{BoundingVolume, FacePlanes, FaceSet},
    shade::InstructionSet,
    surface::{BandColor, PixelWord},
    view::{Affine, Camera, Pose},
};

/// How the faces of a model get their colours. Every colour is the plainest shading: one colour a face.
///
/// What varies over a face are the [`Attributes`] of its vertices, numbers that are kept from preparing a frame to drawing it.
/// A shading whose attributes are `()` takes no memory and no time a pixel.
///
/// A shading of a program's own, which is a [`Look`](crate::scene::Look) at once: the nearer to the viewer a model's vertices
/// are, the brighter.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     band::Band,
///     geometry::InputError,
///     scene::{Camera, FaceSet, Memory, Model, Pose, Whole},
///     shade::Shading,
/// };
///
/// struct Nearness;
///
/// impl Shading for Nearness {
///     type Color = Gray8;
///     type Skin<'a> = ();
///     type Uniforms = ();
///     /// The level of grey, which varies evenly on the screen.
///     type Attributes = [i16; 1];
///
///     fn uniforms(_: &(), _: &Pose, _: &Camera) {}
///
///     fn vertex(_: &(), _: &(), _: usize, [_, _, z]: [i32; 3]) -> [i16; 1] {
///         [(128 - z / 8).clamp(0, 255) as i16]
///     }
///
///     fn fragment(_: &(), _: u8, [level]: &[i32; 1]) -> Option<u8> {
///         Some((level >> 16) as u8)
///     }
/// }
///
/// let mesh = FaceSet::new(&[[-512, -512, -256], [0, 512, 256], [512, -512, -256]], &[[0, 1, 2]])?;
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mut memory = Memory::<Whole<Nearness>, 3, 1, 64, 64>::new();
/// let mut model = Model::<Nearness>::with_skin(mesh, ())?;
/// model.pose.translation = [0, 0, 1024].map(I16F16::from_num);
/// let models = [model];
/// let mut scene = memory.prepare(&camera, &models)?;
///
/// let mut words = [0; 64 * 64];
/// let mut band = Band::<Gray8>::new(area, &mut words)?;
/// scene.draw(&mut band);
/// let level = |row: usize| band.words()[row * 64 + 32];
/// assert!(level(20) < level(30) && level(30) < level(45));
/// # Ok::<(), InputError>(())
/// ```
pub trait Shading: 'static {
    /// The colour of the display that the pictures are for.
    type Color: BandColor;
    /// What a model has beside its mesh: colours, normals, a texture, lights.
    type Skin<'a>: Copy;
    /// What is the same for all vertices of a model in a frame, such as the directions of lights as the model sees them.
    type Uniforms: Copy;
    /// What varies over a face: `()`, `[i16; N]`, [`Perspective<N>`](Perspective), or a pair of these.
    type Attributes: Attributes;
    /// How far attributes that vary evenly in space may be from the exact ones, in their own units: where a face is so small or
    /// so far away that no attribute is farther off, it is drawn without divisions. One number, or a pair for a pair of
    /// attributes.
    const TOLERANCE: <Self::Attributes as Planes>::Tolerance = <Self::Attributes as Planes>::EXACT;

    /// Whether there may be pixels at which [`fragment`](Self::fragment) is `None`. Where there are none, depths are tested
    /// first, and then the fragments of all visible pixels of a run are computed one after the other, which is faster.
    const HAS_HOLES: bool = true;

    /// Checks that a skin has what a mesh needs.
    ///
    /// # Errors
    /// [`TooSmall`] with how much would do.
    #[inline]
    fn check(_skin: &Self::Skin<'_>, _mesh: &FaceSet<'_>) -> Result<(), TooSmall> {
        Ok(())
    }

    /// Computes what is the same for all vertices of a model that is in a pose before a camera. Called once a model and frame.
    fn uniforms(skin: &Self::Skin<'_>, pose: &Pose, camera: &Camera) -> Self::Uniforms;

    /// The attributes of a vertex of the mesh: its index, and its position in the mesh. Called at most once a vertex and frame:
    /// where there are [uniforms](Self::Uniforms), as of lights, not for vertices all of whose faces are turned away or beside
    /// the picture.
    fn vertex(skin: &Self::Skin<'_>, uniforms: &Self::Uniforms, vertex: usize, position: [i32; 3]) -> Self::Attributes;

    /// The word of a face of the mesh, before anything varies over it. `None` for a face that is not drawn. Called when
    /// rows reach the face.
    #[inline]
    fn face(
        _skin: &Self::Skin<'_>,
        _uniforms: &Self::Uniforms,
        _mesh: &FaceSet<'_>,
        _face: usize,
    ) -> Option<<Self::Color as BandColor>::Word> {
        Some(PixelWord::ZERO)
    }

    /// The word of a pixel of a face, from the word of the face and the attributes at the pixel, each with 16 fractional bits:
    /// in a byte order that is the machine's. `None` for a hole, through which what is behind is seen. Called once a pixel
    /// where attributes vary; otherwise the word of the face is the pixel's.
    fn fragment(
        skin: &Self::Skin<'_>,
        face: <Self::Color as BandColor>::Word,
        attributes: &<Self::Attributes as Planes>::Values,
    ) -> Option<<Self::Color as BandColor>::Word>;

    /// How many instructions of a set [`face`](Self::face) takes, and how many [`fragment`](Self::fragment), for
    /// [`Prepared::estimate`](crate::scene::Prepared::estimate). If this says nothing else, a fragment is as plain as a word
    /// that is put together from one attribute.
    #[inline]
    fn instructions(set: InstructionSet) -> [u32; 2] {
        [0, set.of([16, 8])]
    }

    /// Whether there may be models whose fragments are mixed with what is behind them, as [`Translucent`] ones are. Where there
    /// are none, nothing is linked for it.
    const BLENDS: bool = false;

    /// Whether the faces of a model are mixed with what is behind them: they are drawn after all others, the farthest fragment
    /// of a pixel first. Called when rows reach a face.
    #[inline]
    fn is_translucent(_skin: &Self::Skin<'_>) -> bool {
        false
    }

    /// The word of a pixel of a [translucent](Self::is_translucent) face at a position in the picture, from that of its
    /// fragment and from that behind it, all in the machine's byte order.
    #[inline]
    fn blend(
        _skin: &Self::Skin<'_>,
        fragment: <Self::Color as BandColor>::Word,
        _behind: <Self::Color as BandColor>::Word,
        _position: Point,
    ) -> <Self::Color as BandColor>::Word {
        fragment
    }

    /// Whether models have an [affine map](Self::affine) before their poses, as [`Transformed`] ones do. Where they have none,
    /// nothing is linked for it.
    const HAS_AFFINE_MAP: bool = false;

    /// The affine map of a model, which takes its vertices to where its pose then moves them. Called a few times a model and
    /// frame, and once a face.
    fn affine<'s>(_: &'s Self::Skin<'_>) -> &'s Affine {
        &Affine::IDENTITY
    }

    /// The attributes of a vertex of a [`Transformed`] model, and its position as the map has it. A shading with normals takes
    /// them through the matrix of `normals` ([`Affine::normals`]); any other one has the attributes that it has without a map.
    #[inline]
    fn transformed_vertex(
        skin: &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        _normals: &Affine,
        vertex: usize,
        position: [i32; 3],
    ) -> Self::Attributes {
        Self::vertex(skin, uniforms, vertex, position)
    }

    /// The word of a face of a [`Transformed`] model, whose maps of positions and of normals ([`Affine::normals`]) are there. A
    /// shading with normals takes them through the matrix of the latter; any other one has the word that it has without a map.
    #[inline]
    fn transformed_face(
        skin: &Self::Skin<'_>,
        uniforms: &Self::Uniforms,
        _maps: [&Affine; 2],
        mesh: &FaceSet<'_>,
        face: usize,
    ) -> Option<<Self::Color as BandColor>::Word> {
        Self::face(skin, uniforms, mesh, face)
    }

    /// Whether models have [bounds](Self::bounds), as [`Bounded`] ones do. Where they have none, nothing is linked for it.
    const HAS_BOUNDS: bool = false;

    /// A box, a sphere or a cylinder around the vertices of a model, before any map. Called a few times a model and frame.
    #[inline]
    fn bounds(_: &Self::Skin<'_>) -> Option<BoundingVolume> {
        None
    }

    /// Whether models have [planes](Self::planes), as those [`WithPlanes`] do. Where they have none, nothing is linked for it.
    const HAS_PLANES: bool = false;

    /// The planes of the faces of a model's mesh, before any map. Called once a model and frame.
    #[inline]
    fn planes<'a>(_: &Self::Skin<'a>) -> Option<FacePlanes<'a>> {
        None
    }
}

/// The colours of the fragments along a span, from left to right.
pub(crate) trait Shade<W> {
    /// The word of the fragment at the current pixel; `None` for a hole.
    fn word(&self) -> Option<W>;

    /// Moves on to the next pixel of the row, whether the last fragment was visible or not.
    fn step_right(&mut self);

    /// Fills pixels, and moves on to the one after them.
    #[inline(always)]
    fn fill(&mut self, words: &mut [W]) {
        for pixel in words {
            if let Some(word) = self.word() {
                *pixel = word;
            }
            self.step_right();
            // Keeps the compiler from unrolling: most spans are shorter than what it would prepare for.
            core::hint::black_box(());
        }
    }

    /// [`fill`](Self::fill) of so many pixels that the compiler may unroll it.
    #[inline(always)]
    fn fill_block<const N: usize>(&mut self, words: &mut [W; N]) {
        for pixel in words {
            if let Some(word) = self.word() {
                *pixel = word;
            }
            self.step_right();
        }
    }
}
