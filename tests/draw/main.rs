//! Styled shapes, ours and those of embedded-graphics.

#[path = "../common/mod.rs"]
mod common;
#[path = "../reference"]
mod reference {
    pub mod box_axis;
    pub mod directions;
    pub mod exact_area;
    pub mod ideal_coverage;
    pub mod ideal_stroke;
    pub mod nearest_pixels;
    pub mod rounded_rectangle;
    pub mod wide_product;
}

mod aligned_strokes;
mod antialiased_area;
mod antialiased_outlines;
mod antialiased_pictures;
mod antialiased_shapes;
mod antialiased_strokes;
mod antialiased_styles;
mod any_outline_fonts;
mod any_window;
mod arcs;
mod bounding_boxes;
mod changing_over;
mod checked_strokes;
mod closed_shapes;
mod contour_items;
mod dense_dashes;
mod far_strokes;
mod far_windows;
mod flood_fill;
mod groups;
mod large_pools;
mod lines;
mod mask_texts;
mod mirrored_ellipses;
mod moved_lines;
mod outline_texts;
mod picture_contours;
mod picture_display;
mod picture_images;
mod picture_items;
mod picture_shapes;
mod points;
mod polygons;
mod polylines;
mod prepared_pictures;
mod rounded_rectangles;
mod stroke_items;
mod stroke_patterns;
mod stroke_styles;
mod strokes;
mod text_area;
mod texts;
mod thin_circle;
mod translated_pictures;
mod triangles;
mod walked_strokes;
mod walked_styles;
mod wide_lines;
