//! Indexed face sets, as they lie in flash.

mod face_set;

pub use face_set::FaceSet;
