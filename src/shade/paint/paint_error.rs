//! The error of paints that cannot be made.

use core::fmt::{self, Display};

/// A paint cannot be made of these colours.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PaintError {
    /// The colours of a [`Pattern`](crate::shade::Pattern) do not make whole rows, or there are none.
    NotARectangle {
        /// Number of colours in a row of the picture.
        width: usize,
        /// Colours that were given: that should be a multiple of the width, and not 0.
        colors: usize,
    },
    /// The stops of a [`Ramp`](crate::shade::Ramp) do not ascend, or there are none.
    NotAscending,
}

impl Display for PaintError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotARectangle { width, colors } => write!(
                formatter,
                "{colors} colours are not whole rows of {width}: give a multiple of the width, and not 0"
            ),
            Self::NotAscending => {
                formatter.write_str("the levels of the stops must ascend, and there must be one at least")
            }
        }
    }
}

impl core::error::Error for PaintError {}
