//! No shortcuts.

use core::marker::PhantomData;

use crate::scene::Look;

/// The [`Look`] `L` without the shortcuts that a frame may allow ([`Look::HURRIES`]): the picture is the same, bit for bit, and
/// takes longer. To see what the shortcuts save, and in tests.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     band::Band,
///     scene::{Camera, Counted, FaceSet, Memory, Model, Unhurried},
/// };
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mesh = FaceSet::new(&[[-512, -512, 512], [0, 512, 512], [512, -512, 512]], &[[0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Rgb565::RED])?];
/// let mut hurried = Memory::<Counted<Rgb565>, 3, 1, 64, 64>::new();
/// let mut unhurried = Memory::<Counted<Unhurried<Rgb565>>, 3, 1, 64, 64>::new();
/// let (mut scene, mut slow) = (hurried.prepare(&camera, &models)?, unhurried.prepare(&camera, &models)?);
/// let mut words = [[0; 64 * 64]; 2];
/// let [one, other] = &mut words;
/// scene.draw(&mut Band::<Rgb565>::new(area, one)?);
/// slow.draw(&mut Band::<Rgb565>::new(area, other)?);
/// assert_eq!(words[0], words[1]);
/// assert_eq!([scene.counters(), slow.counters()].map(|counters| counters.pixels_tested), [0, 2048]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Unhurried<L>(PhantomData<L>);

impl<L: Look> Look for Unhurried<L> {
    type Color = L::Color;
    type Shading = L::Shading;
    type Precision = L::Precision;
    type Depth = L::Depth;
    type Counting = L::Counting;
    type Silhouettes = L::Silhouettes;
    type Visibility = L::Visibility;
    type StoredAttributes = L::StoredAttributes;
    const CLIPS: bool = L::CLIPS;
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const HURRIES: bool = false;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const IS_MULTISAMPLED: bool = L::IS_MULTISAMPLED;
}
