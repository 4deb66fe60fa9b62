//! What to draw, and the prepared frame.
