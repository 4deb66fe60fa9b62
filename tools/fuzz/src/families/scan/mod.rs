//! `zrow::scan`.

pub mod circles;
pub mod curves;
pub mod edges;
pub mod fills;
pub mod lines;
pub mod sectors;
