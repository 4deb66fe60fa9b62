//! The depth comparison functions.

use core::cmp::Ordering;

/// When a pixel is drawn, by how its depth compares with the one that is stored there. **In this library what is nearer has the
/// larger depth**, so that [`Greater`](Self::Greater) draws what is nearer: `GL_LESS` of OpenGL, where it is smaller.
///
/// The three lowest bits of the number say for a smaller, an equal and a larger depth whether the pixel is drawn, as the numbers
/// of `glDepthFunc` do.
///
/// ```
/// use zrow::visible::Comparison;
///
/// assert!(Comparison::Greater.passes(7, 5));
/// assert!(!Comparison::Greater.passes(5, 5));
/// assert_eq!(Comparison::Greater.opposite(), Comparison::LessOrEqual);
/// ```
///
/// Source: `glDepthFunc` of OpenGL 1.0 (Segal and Akeley 1992), with the sense of nearer and farther exchanged.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Comparison {
    /// Nothing is drawn.
    Never,
    /// What is farther is drawn.
    Less,
    /// What is exactly as near is drawn.
    Equal,
    /// What is farther or as near is drawn.
    LessOrEqual,
    /// What is nearer is drawn; of what is equally near the first stays. The default.
    #[default]
    Greater,
    /// What is nearer or farther is drawn.
    NotEqual,
    /// What is nearer or as near is drawn: of what is equally near the last stays.
    GreaterOrEqual,
    /// Everything is drawn.
    Always,
}

impl Comparison {
    /// Whether a pixel is drawn whose depth is `depth`, where `stored` is there.
    #[inline]
    pub fn passes<D: Ord>(self, depth: D, stored: D) -> bool {
        let relation = match depth.cmp(&stored) {
            Ordering::Less => Self::Less,
            Ordering::Equal => Self::Equal,
            Ordering::Greater => Self::Greater,
        };
        self as u8 & relation as u8 != 0
    }

    /// The comparison that draws all the pixels which this one does not: for hidden parts in another style.
    pub const fn opposite(self) -> Self {
        match self {
            Self::Never => Self::Always,
            Self::Less => Self::GreaterOrEqual,
            Self::Equal => Self::NotEqual,
            Self::LessOrEqual => Self::Greater,
            Self::Greater => Self::LessOrEqual,
            Self::NotEqual => Self::Equal,
            Self::GreaterOrEqual => Self::Less,
            Self::Always => Self::Never,
        }
    }
}
