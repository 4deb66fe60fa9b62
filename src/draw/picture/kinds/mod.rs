//! The kinds of items: how each shape is kept, and how it goes on from row to row.

mod antialiased;
mod image;
mod line_words;
mod mask_text;
mod outline;
mod outline_text;
mod rectangle;
mod replayed;
mod round;
mod text;
mod thin_line;
mod triangle;
