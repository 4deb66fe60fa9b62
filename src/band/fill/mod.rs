//! How a band takes what is drawn: spans and blocks, symmetric shapes, rings.

// Why small functions are `inline(always)` in these files, in those of `surface` and in `geometry::division`: with `inline` alone,
// on a Cortex-M4, outlines of circles take 10.9 % more instructions, rectangles 8.7 % (drawn by `draw` 5.9 % fewer), filled circles
// 3.7 %, rounded rectangles 3.0 %; on a Cortex-M0+ rectangles 2.2 % more, filled circles 2.0 % fewer.

mod draw_target;
mod ring;
mod symmetric;
