//! How a band takes what is drawn: spans and blocks, symmetric shapes, rings.

mod draw_target;
mod ring;
mod symmetric;
