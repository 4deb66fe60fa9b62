//! Where something is and how it is turned.

use fixed::types::I16F16;

use crate::{geometry::InputError, view::Rotation};

/// A rotation, then a translation in units of the models' vertices.
///
/// ```
/// use zrow::fixed::types::{I16F16, U0F16};
/// use zrow::scene::{Pose, Rotation};
///
/// let at = |x, y, z| [x, y, z].map(I16F16::from_num::<i32>);
/// let [right, left] = [0.25, 0.75].map(|turns| Rotation::about_y(U0F16::from_num(turns)));
/// // A tank that has turned right, its turret above it, which looks to the left, and the muzzle of its gun.
/// let tank = Pose::new(right, at(1000, 0, 2000));
/// let turret = Pose::new(left, at(0, 80, 0));
/// let muzzle = Pose::new(Rotation::IDENTITY, at(0, 10, 150));
/// let in_world = muzzle.then(&turret)?.then(&tank)?;
/// assert_eq!(in_world, Pose::new(Rotation::IDENTITY, at(1000, 90, 2150)));
/// // Where the muzzle is for someone who sits in the tank.
/// assert_eq!(in_world.then(&tank.inverse()?)?.translation, at(-150, 90, 0));
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Pose {
    /// The orientation of the object.
    pub rotation: Rotation,
    /// The position of the object's origin: x, y, z.
    pub translation: [I16F16; 3],
}

impl Pose {
    /// The pose at the origin, without rotation.
    pub const IDENTITY: Self = Self {
        rotation: Rotation::IDENTITY,
        translation: [I16F16::ZERO; 3],
    };

    /// The pose with this rotation, and then this translation.
    pub const fn new(rotation: Rotation, translation: [I16F16; 3]) -> Self {
        Self { rotation, translation }
    }

    /// This pose, and `next` after it: where an object is in the world whose pose in another object is this one, and that other
    /// object's pose is `next`. For hierarchies of any depth, from the innermost object outwards.
    ///
    /// The position is rounded to 2^-16 units. Cost: that of [`Rotation::then`] and nine multiplications.
    ///
    /// # Errors
    /// [`InputError::PositionOutOfDomain`].
    pub fn then(&self, next: &Self) -> Result<Self, InputError> {
        let turned = next.rotation.turned(&self.translation);
        let [x, y, z] = next.translation.map(|coordinate| i64::from(coordinate.to_bits()));
        let [turned_x, turned_y, turned_z] = turned;
        Ok(Self {
            rotation: self.rotation.then(&next.rotation),
            translation: position([turned_x + x, turned_y + y, turned_z + z])?,
        })
    }

    /// The pose that undoes this one: the world as an object in this pose sees it.
    ///
    /// # Errors
    /// [`InputError::PositionOutOfDomain`].
    pub fn inverse(&self) -> Result<Self, InputError> {
        let rotation = self.rotation.inverse();
        let translation = position(rotation.turned(&self.translation).map(|coordinate| -coordinate))?;
        Ok(Self { rotation, translation })
    }
}

/// Coordinates with 16 fractional bits, where they fit.
pub(super) fn position([x, y, z]: [i64; 3]) -> Result<[I16F16; 3], InputError> {
    let coordinate = |bits: i64| i32::try_from(bits).map(I16F16::from_bits);
    match (coordinate(x), coordinate(y), coordinate(z)) {
        (Ok(x), Ok(y), Ok(z)) => Ok([x, y, z]),
        _ => Err(InputError::PositionOutOfDomain),
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Pose {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "{} at {}",
            self.rotation,
            self.translation.map(|coordinate| coordinate.to_num::<f32>())
        );
    }
}
