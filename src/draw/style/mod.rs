//! Styles: what of a shape is drawn and in which colours, and how a style draws a shape.

mod draw_on;
mod primitive_style;
pub(crate) mod stroke;
mod stroke_style;

pub use draw_on::{DrawOn, StyledShape};
pub use primitive_style::{PrimitiveStyle, PrimitiveStyleBuilder};
pub use stroke_style::{StrokeStyle, StrokedShape};
