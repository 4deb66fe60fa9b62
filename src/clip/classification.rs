//! What trivial accept and reject make of a shape.

/// How much of a shape a window shows.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Classification {
    /// No pixel of it: rejected.
    Nothing,
    /// Every pixel of it: accepted, and drawn without a further question.
    Whole,
    /// Some pixels of it, and they are all that the window has: the window can be filled without a look at the shape.
    Fills,
    /// Some pixels of it: to be clipped.
    Part,
}
