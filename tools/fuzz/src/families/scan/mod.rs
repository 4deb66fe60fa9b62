//! `zrow::scan`.

pub mod circles;
pub mod curves;
pub mod fills;
pub mod lines;
