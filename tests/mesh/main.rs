//! Meshes: edges and their kinds.

#[path = "../common/mod.rs"]
mod common;
#[path = "../reference"]
mod reference {
    pub mod wide_product;
}

mod edges;
