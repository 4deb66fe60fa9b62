//! What inputs are made of: ordinary values mostly, small ones, the edges of their types and of zrow's domains, and
//! arbitrary bits.
//!
//! Each type decodes itself from bytes. Short inputs are simple ones: zeros decode to small values.

mod curves;
mod list;
mod numbers;
mod outlines;
mod stage;
mod styles;
mod sub_points;

pub use curves::{Command, Tolerance, commands};
pub use list::List;
pub use numbers::{Count, Degrees, Int, Large, Length, Number, Px, Spot};
pub use outlines::{Contours, Rule};
pub use stage::Stage;
pub use styles::{Alignment, Dashes, Hue, Stroke, Style, TAKEN_DASHES};
pub use sub_points::{ByHand, SubContours, SubSpot, Units};
