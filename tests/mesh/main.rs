//! Meshes: edges and their kinds, polygons and their triangles.

#[path = "../common/mod.rs"]
mod common;
#[path = "../reference"]
mod reference {
    pub mod wide_product;
}

mod convex;
mod edges;
mod neighbours;
mod polygons;
