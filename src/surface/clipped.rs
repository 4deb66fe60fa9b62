//! What is known to lie inside a target's window.

/// Something that lies inside the window of the target that it is handed to, or is empty.
///
/// Only this crate makes one, where it has clipped: so a target need not clip again, and what comes from anywhere else goes
/// through the methods that do.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Clipped<T>(pub(crate) T);
