//! The meshes of the standard scenes, as constants in flash. A length of 1 is 512 units.

include!(concat!(env!("OUT_DIR"), "/meshes.rs"));
