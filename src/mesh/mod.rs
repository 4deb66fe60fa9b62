//! Indexed face sets, as they lie in flash.

mod bounding_box;
mod face_set;
mod neighbours;
mod octahedral_normal;

pub use bounding_box::BoundingBox;
pub use face_set::FaceSet;
pub(crate) use octahedral_normal::{normal, unit_normal};
