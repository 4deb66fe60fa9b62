//! Which radii a thin circle or ellipse may have.

use crate::geometry::InputError;

/// An error where the radius is larger than `max`.
pub(crate) const fn check_radius(radius: u32, max: u32) -> Result<(), InputError> {
    if radius > max {
        Err(InputError::RadiusTooLarge { max })
    } else {
        Ok(())
    }
}
