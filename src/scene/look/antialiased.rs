//! Antialiased silhouettes.

use core::marker::PhantomData;

use crate::{scene::Look, shade::ChannelColor, visible::ByArea};

/// The [`Look`] `L` with antialiased silhouettes: where a surface ends before another one or before what the band had, pixels
/// are mixed by the area of each that the surface covers, to 1/255. Edges inside a surface stay as they are, without a seam,
/// and so do all other pixels.
///
/// Which edges are silhouettes is found out from the [neighbours](crate::scene::FaceSet::with_neighbours) of the faces of a
/// mesh. Without them each of its edges takes time, and cancels out: a silhouette covers the same, but the pixels beside a face
/// may have the colour of another face that has an edge there.
///
/// Faces that are cut (at the near plane, the far plane or the guard band), and faces that are
/// [translucent](crate::shade::Translucent), have edges by the centres of pixels, as without this look. Where two silhouettes
/// at different depths pass through the same pixel, they are taken for one.
///
/// [`DepthSort`](crate::visible::DepthSort) draws such looks as well: the same picture, to the bit, of opaque faces that are not
/// cut. A translucent or a cut face that lies between a surface and what is behind it is seen beside that surface by `DepthSort`
/// alone, where the depth row mixes the pixel with what lies behind such a face.
///
/// Memory beside that of `L`: 12 bytes a column, 4 a face, 4 a row, and 896. Cost: no row is drawn without depths; a look at
/// each face a frame, some 300 instructions for each silhouette edge that a row touches (more where over 32 of them go on from
/// one row to the next), and a look at all faces of the row where it is over other ones.
///
/// ```
/// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     band::Band,
///     geometry::InputError,
///     scene::{Antialiased, Camera, FaceSet, Memory, Model},
/// };
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// // One unit is 1/32 pixel there: the left side is 1/4 pixel right of the middle of the picture.
/// let mesh = FaceSet::new(&[[8, -400, 1024], [8, 400, 1024], [800, 0, 1024]], &[[0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Gray8::WHITE])?];
/// let mut memory = Memory::<Antialiased<Gray8>, 3, 1, 64, 64>::new();
/// let mut words = [0; 64 * 64];
/// let mut band = Band::<Gray8>::new(area, &mut words)?;
/// memory.prepare(&camera, &models)?.draw(&mut band);
/// assert_eq!(band.words()[32 * 64 + 31..][..3], [0, 191, 255]);
/// # Ok::<(), InputError>(())
/// ```
///
/// Source: cells with cover and area (Turner 2000, FreeType) of silhouette edges (Sander, Hoppe, Snyder and Gortler 2001).
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Antialiased<L>(PhantomData<L>);

impl<L: Look<Color: ChannelColor>> Look for Antialiased<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = ByArea;
    type Visibility = L::Visibility;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = false;
}
