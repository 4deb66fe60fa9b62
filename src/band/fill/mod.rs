//! How a band takes what is drawn: spans and blocks, symmetric shapes, rings.

// Why small functions are `inline(always)` in these files, in `band` and in `surface`: with `inline` alone, on a Cortex-M4, outlines of
// circles take 12.5 % more instructions, rectangles 9.9 %, filled circles 5.2 %, rounded rectangles 4.2 %.

mod draw_target;
mod ring;
mod symmetric;
