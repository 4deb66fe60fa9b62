//! Another method of visibility than the depth row.

use core::marker::PhantomData;

use crate::{
    scene::Look,
    visible::{ByMethod, NewMethod},
};

/// The [`Look`] `L` whose faces are seen by the method `M` of [`Visibility`](crate::visible::Visibility) instead of the depth row:
/// the same picture, to the bit, in other time and memory. Its memory lies in that of the scene, so that
/// [`Prepared::draw`](crate::scene::Prepared::draw) and a [`SceneItem`](crate::scene::SceneItem) draw by it.
///
/// `M` is one of [`DepthBuffer`](crate::visible::DepthBuffer), [`DepthSort`](crate::visible::DepthSort),
/// [`GridRayCasting`](crate::visible::GridRayCasting), [`OneDepth`](crate::visible::OneDepth) (by crossing numbers),
/// [`RayCasting`](crate::visible::RayCasting), [`SpanScanLine`](crate::visible::SpanScanLine),
/// [`TileBins`](crate::visible::TileBins) and [`Warnock`](crate::visible::Warnock), for the depths of `L`; for looks with holes,
/// translucent faces or antialiased silhouettes `DepthSort`, with others they do not compile. A
/// [`SolidCombination`](crate::visible::SolidCombination) needs the solids of a program, and is handed to
/// [`Prepared::draw_by`](crate::scene::Prepared::draw_by).
///
/// A band for which the method has too little memory is drawn by the depth row, which is linked as well, and
/// [`Prepared::method_error`](crate::scene::Prepared::method_error) says how much would do. To compare methods, or to link one
/// alone, take [`Prepared::draw_by`](crate::scene::Prepared::draw_by).
///
/// [`Prepared::draw_with`](crate::scene::Prepared::draw_with), which hands over rows of depths, draws by the depth row, and so does
/// [`Multisampled`](crate::scene::Multisampled) around this look; within it there are no samples.
/// [`Prepared::estimate`](crate::scene::Prepared::estimate) predicts what the depth row takes. Memory: that of `L` and of `M`, and
/// some 8 bytes on a 32-bit machine.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     band::Band,
///     geometry::TooSmall,
///     scene::{Camera, FaceSet, Look, Memory, Model, VisibleBy},
///     visible::{DepthSort, SpanScanLine},
/// };
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let near = FaceSet::new(&[[-512, -512, 512], [0, 512, 512], [512, -512, 512]], &[[0, 1, 2]])?;
/// let far = FaceSet::new(&[[-512, -512, 700], [-512, 512, 700], [512, 512, 700]], &[[0, 1, 2]])?;
/// let models = [Model::new(near, &[Rgb565::RED])?, Model::new(far, &[Rgb565::BLUE])?];
///
/// let mut by_depth_row = Memory::<Rgb565, 6, 2, 64, 64>::new();
/// let mut by_spans = Memory::<VisibleBy<SpanScanLine<4>, Rgb565>, 6, 2, 64, 64>::new();
/// let mut by_too_small_a_sort = Memory::<VisibleBy<DepthSort<1, 0>, Rgb565>, 6, 2, 64, 64>::new();
/// let mut words = [[0; 64 * 64]; 3];
/// let [first, second, third] = &mut words;
/// by_depth_row.prepare(&camera, &models)?.draw(&mut Band::<Rgb565>::new(area, first)?);
///
/// let mut scene = by_spans.prepare(&camera, &models)?;
/// scene.draw(&mut Band::<Rgb565>::new(area, second)?);
/// assert_eq!(scene.method_error(), None);
/// assert!(scene.method().comparisons() > 0);
///
/// let mut scene = by_too_small_a_sort.prepare(&camera, &models)?;
/// scene.draw(&mut Band::<Rgb565>::new(area, third)?);
/// assert_eq!(scene.method_error(), Some(TooSmall::Faces(2)));
/// assert!(words[0] == words[1] && words[0] == words[2]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VisibleBy<M, L>(PhantomData<(M, L)>);

impl<M: NewMethod<L::Depth>, L: Look> Look for VisibleBy<M, L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    type Visibility = ByMethod<M>;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = L::HURRIES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = false;
}
