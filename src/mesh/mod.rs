//! Indexed face sets, and their edges, as they lie in flash.

mod bounding_box;
mod bounding_cylinder;
mod bounding_sphere;
mod bounding_volume;
mod convex;
mod edge;
mod edges;
mod element;
mod enclosing_ball;
mod face_normal;
mod face_planes;
mod face_set;
mod neighbours;
mod octahedral_normal;
mod polygons;
mod sides;

pub use bounding_box::BoundingBox;
pub use bounding_cylinder::BoundingCylinder;
pub use bounding_sphere::BoundingSphere;
pub use bounding_volume::BoundingVolume;
pub use edge::{Edge, EdgeKind};
pub use face_planes::FacePlanes;
pub use face_set::FaceSet;
pub(crate) use octahedral_normal::{normal, unit_normal};
