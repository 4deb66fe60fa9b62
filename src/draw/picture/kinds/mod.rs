//! The kinds of items: how each shape is kept, and how it goes on from row to row.

// Why rows of rectangles, circles and ellipses are `inline(always)`: with `inline` alone, a dashboard takes 3.2 % more instructions in
// bands of a row and 7.1 % more in one band (Cortex-M4).

mod aligned_stroke;
mod antialiased;
mod aside_stroke;
mod circle_outline;
mod contour_stroke;
mod contours;
mod curve_row;
mod filled_chains;
mod image;
mod line_words;
mod mask_text;
mod outline;
mod outline_text;
mod path;
mod polygon;
mod polyline;
mod rectangle;
mod replayed;
mod round;
mod sides;
mod stored_shape;
mod stored_style;
mod strips;
mod styled_stroke;
mod text;
mod thin_line;
mod thin_stroke;
mod triangle;
mod walked_stroke;
mod walked_style;
mod wide_line;
