//! Pictures: a display that counts what it is asked for, and all ways to draw one picture.

mod agreement;
mod canvas;
mod sheet;
mod users_target;

pub use agreement::{
    OnBand, Work, agree, agree_on_bands, agree_styled, agree_with_drawable, cut, full_picture, is_same, sure,
};
pub use canvas::{Canvas, background};
pub use sheet::{Counted, Sheet, Stopped};
pub use users_target::UsersTarget;
