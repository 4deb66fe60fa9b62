//! What a scene's pictures are made of: one type parameter, so that only what it names is linked.
//!
//! A shading is a look, and a colour the plainest one. Each other file here is a wrapper around any look that changes one thing
//! of it; wrappers go around each other in any order: `Fine<Whole<Rgb565>>`.

mod antialiased;
mod counted;
mod deep;
mod double_sided;
mod fine;
mod multisampled;
mod one_pass;
mod orthographic;
mod unhurried;
mod visible_by;
mod whole;

pub use antialiased::Antialiased;
pub use counted::Counted;
pub use deep::Deep;
pub use double_sided::DoubleSided;
pub use fine::Fine;
pub use multisampled::Multisampled;
pub use one_pass::OnePass;
pub use orthographic::Orthographic;
pub use unhurried::Unhurried;
pub use visible_by::VisibleBy;
pub use whole::Whole;

use crate::{
    geometry::Sub4,
    scene::{counters::Counting, stored_attributes::StoredAttributes},
    shade::Shading,
    surface::BandColor,
    view::{DepthWidth, ScreenPrecision},
    visible::{LookVisibility, Silhouettes},
};

/// What the pictures of a scene are made of: colours, the precision of positions and depths, whether faces are cut, and whether
/// rows are drawn in passes. What a look does not name takes no flash, no RAM and no time.
///
/// Every [`Shading`] is a look, and a colour is the plainest one, with a colour a face: positions at 1/16 pixel ([`Sub4`]),
/// depths of 16 bits, faces are cut, rows are drawn in passes where they must. A wrapper changes one thing of another look, in
/// any order: [`Fine`] (positions at 1/256 pixel), [`Deep`] (depths of 32 bits), [`Whole`] (no face is cut), [`OnePass`] (no
/// row is drawn in passes), [`Orthographic`] (parallel rays), [`DoubleSided`] (faces are seen from both sides), [`Antialiased`]
/// (silhouettes), [`Multisampled`] (several samples a pixel), [`VisibleBy`] (another method of visibility), [`Counted`] (counters), [`Unhurried`]
/// (no shortcuts). A look can
/// also be a type of the program's own.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     geometry::InputError,
///     scene::{Camera, FaceSet, Fine, Memory, Model, Whole},
/// };
///
/// /// Objects that stay in front of the camera, at 1/256 pixel.
/// type InFront = Whole<Fine<Rgb565>>;
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mut memory = Memory::<InFront, 3, 1, 64, 64>::new();
/// let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 800], [512, -512, 800]], &[[0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Rgb565::RED])?];
/// assert_eq!(memory.prepare(&camera, &models).err(), Some(InputError::BeforeNearPlane { model: 0 }));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub trait Look: 'static {
    /// The colour of the display that the pictures are for.
    type Color: BandColor;
    /// How faces get their colours.
    type Shading: Shading<Color = Self::Color>;

    /// The sub-pixel precision of vertices and edges on the screen: [`Sub4`] or [`Sub8`](crate::geometry::Sub8).
    type Precision: ScreenPrecision;

    /// The width of a stored depth: `u16` or `u32`.
    ///
    /// Depth is NDC z, affine in 1/w: nearly the greatest value at the near plane, falling to the smallest at infinity.
    /// The cleared row holds 0, which is farther than everything. One unit at distance z is z²/(near * 65,535) of space
    /// with `u16`, 256 times finer with `u32`, whose low 8 bits hold the fraction of a 24-bit depth.
    type Depth: DepthWidth;

    /// `()`; in looks that are [`Counted`], the counters of a frame.
    type Counting: Counting;

    /// `()`; in looks that are [`Antialiased`], how silhouettes are.
    type Silhouettes: Silhouettes<Self::Color>;

    /// `()`, the depth row; in looks that are [`VisibleBy`] another method, that.
    type Visibility: LookVisibility<Self::Depth>;

    /// `()`; in looks that are [`Whole`], what is kept of the attributes of vertices.
    type StoredAttributes: StoredAttributes;

    /// Whether faces are cut at the near plane, at the far plane and at the guard band, so that a scene may be anywhere, also
    /// around the camera. Flash: about 3 KB on a Cortex-M3 at opt-level "s".
    ///
    /// Without, each vertex of the models must be on the screen: not in front of the near plane, and within the guard band,
    /// which reaches from the picture's centre on each side as far as the coordinates of the precision do on the nearest: 959
    /// pixels for 128 x 64 pixels at the origin with [`Sub4`]. Otherwise [`Frame::prepare`](crate::scene::Frame::prepare) is an
    /// error that says which model and why; no picture is ever wrong. All pictures are those with cut faces. But for a far
    /// plane: in perspective faces behind it are drawn.
    const CLIPS: bool = true;

    /// Whether a row that more faces cross than the memory has slots for (`ACTIVE`) is drawn in as many passes as it takes: the
    /// picture is the same, and takes longer. Flash: about 2 KB on a Cortex-M3 at opt-level "s".
    ///
    /// Without, [`Frame::prepare`](crate::scene::Frame::prepare) is an error that says how many slots would do.
    const DRAWS_IN_PASSES: bool = true;

    /// Whether frames take the shortcuts that they allow: rows in which no face overlaps another are filled without depths, and
    /// faces are looked through for those to be cut only where a vertex is off the screen.
    const HURRIES: bool = true;

    /// Whether rays are parallel, so that things are as large wherever they are, and no vertex is divided by its distance.
    const IS_ORTHOGRAPHIC: bool = false;

    /// Whether faces that are seen from behind are drawn like those that are seen from the front.
    const DRAWS_BACKS: bool = false;

    /// Whether a scene is drawn into several samples a pixel, so that faces are kept which cover some of them and not the
    /// centre. Then no row is drawn in passes.
    const IS_MULTISAMPLED: bool = false;
}

impl<H: Shading> Look for H {
    type Color = H::Color;
    type Shading = H;
    type Precision = Sub4;
    type Depth = u16;
    type Counting = ();
    type Silhouettes = ();
    type Visibility = ();
    type StoredAttributes = ();
}
