//! Paints: a colour for each pixel of the display.

mod linear_gradient;
mod pattern;
mod radial_gradient;
mod ramp;

pub use linear_gradient::LinearGradient;
pub use pattern::Pattern;
pub use radial_gradient::RadialGradient;
pub use ramp::Ramp;
