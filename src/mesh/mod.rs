//! Indexed face sets, as they lie in flash.

mod face_set;
mod octahedral_normal;

pub use face_set::FaceSet;
pub(crate) use octahedral_normal::{normal, unit_normal};
