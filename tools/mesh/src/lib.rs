//! Converts Wavefront OBJ and STL models to face sets for zrow, written as a Rust module.
//!
//! A model is read as it stands in its file ([`obj`], [`mtl`], [`stl`], [`texture`]), turned to zrow's axes and rounded to 16
//! bits ([`quantize`]), its faces are cut into triangles ([`triangulate`]), and equal vertices become one ([`convert`]).
//! Coarser levels of detail are made of the vertices that are there ([`levels`]), and so is a table of edges
//! ([`edges`](mod@edges)).
//!
//! OBJ and STL are parsed here: the crates that read them give no line numbers with their errors, or none at all.

pub mod convert;
pub mod coordinates;
pub mod edges;
pub mod level;
pub mod levels;
pub mod lines;
pub mod mesh;
pub mod model;
pub mod module;
pub mod module_parts;
pub mod mtl;
pub mod normals;
pub mod obj;
pub mod octahedral;
pub mod quadric;
pub mod quantize;
pub mod read;
pub mod simplify;
pub mod stl;
pub mod texture;
pub mod triangulate;
pub mod vector;
