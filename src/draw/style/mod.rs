//! Styles: which parts of a shape are drawn and in which colours; and the traits that draw a shape in a style.

mod antialiased;
mod draw_on;
mod primitive_style;
pub(crate) mod stroke;
mod stroke_style;

pub use antialiased::Antialiased;
pub use draw_on::{BlendOn, DrawOn, StyledShape};
pub use primitive_style::PrimitiveStyle;
pub use stroke_style::{StrokeStyle, StrokedShape};
