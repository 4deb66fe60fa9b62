//! Colour of a fragment. Nothing here yet: faces have one flat colour.
