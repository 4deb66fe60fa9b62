//! Rounded rectangles against quarters of ellipses in exact numbers: all small ones, and the extremes of every number.

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{CornerRadii, Rectangle, RoundedRectangle},
};
use proptest::prelude::*;
use zrow::draw::{DrawOn, PrimitiveStyle, StrokeAlignment};

use crate::common::{
    by_depth, cases, config,
    hostile::{ALIGNMENTS, COLORS, any_corners, any_length, any_style, any_view, style},
    is_quick, picture,
};
use crate::reference::rounded_rectangle::StyledRounded;

/// Compares bands of so many rows with the definition, pixel by pixel.
fn check(shape: &RoundedRectangle, style: PrimitiveStyle<Rgb565>, window: Rectangle, rows: u32) {
    let exact = StyledRounded::new(shape, style);
    let Size { width, height } = window.size;
    let bands = (0..height).step_by(rows as usize).map(|row| {
        let corner = window.top_left + Point::new(0, row as i32);
        Rectangle::new(corner, Size::new(width, rows.min(height - row)))
    });
    for band in bands {
        let drawn = picture(band, |band| {
            let Ok(()) = shape.into_styled(style).draw_on(band);
        });
        for (pixel, drawn) in band.points().zip(drawn) {
            let expected = exact.color(pixel).unwrap_or(Rgb565::BLACK);
            assert_eq!(drawn, expected, "{pixel} of {shape:?} in {style:?}, band {band:?}");
        }
    }
}

/// Corners that share columns and rows, on a display that panics where a pixel is drawn twice.
#[test]
fn every_corner_cuts_off_its_pixels() {
    let shape = |size, radius| RoundedRectangle::with_equal_corners(Rectangle::new(Point::new(2, 2), size), radius);
    let draw = |shape: RoundedRectangle, style: PrimitiveStyle<Rgb565>| {
        let mut display = MockDisplay::new();
        let Ok(()) = shape.into_styled(style).draw(&mut display);
        display
    };
    let outside = style((true, true), 1, StrokeAlignment::Outside);
    draw(shape(Size::new(1, 12), Size::new(7, 13)), outside).assert_pattern(&[
        "    ", "    ", "    ", "  R ", "  R ", " RGR", " RGR", " RGR", " RGR", " RGR", " RGR", "  R ", "  R ",
    ]);
    draw(shape(Size::new(4, 16), Size::new(7, 17)), outside).assert_pattern(&[
        "       ", "       ", "   RR  ", "  RGGR ", "  RGGR ", "  RGGR ", " RGGGGR", " RGGGGR", " RGGGGR", " RGGGGR",
        " RGGGGR", " RGGGGR", " RGGGGR", " RGGGGR", "  RGGR ", "  RGGR ", "  RGGR ", "   RR  ",
    ]);
    let filled = style((false, true), 0, StrokeAlignment::Inside);
    draw(shape(Size::new(6, 11), Size::new(9, 15)), filled).assert_pattern(&[
        "        ", "        ", "    GG  ", "   GGGG ", "  GGGGGG", "  GGGGGG", "  GGGGGG", "  GGGGGG", "  GGGGGG",
        "  GGGGGG", "  GGGGGG", "   GGGG ", "    GG  ",
    ]);
}

/// Every style of a stroke that wide.
fn styles(width: u32) -> impl Iterator<Item = PrimitiveStyle<Rgb565>> {
    let styles = move |alignment| COLORS.map(|colors| style(colors, width, alignment));
    ALIGNMENTS.into_iter().flat_map(styles)
}

#[test]
fn all_small_equal_corners_are_exact() {
    let [most_width, most_height] = if is_quick() {
        [3, 6]
    } else {
        [cases(5, 7), cases(8, 12)]
    };
    for (width, height) in (0..=most_width).flat_map(|width| (0..=most_height).map(move |height| (width, height))) {
        let rectangle = Rectangle::new(Point::new(2, 2), Size::new(width, height));
        let window = Rectangle::new(Point::new(-1, -1), Size::new(width + 6, height + 6));
        for (across, down) in
            (0..=most_width + 1).flat_map(|across| (0..=most_height + 1).map(move |down| (across, down)))
        {
            let shape = RoundedRectangle::with_equal_corners(rectangle, Size::new(across, down));
            for stroke_width in 0..=3 {
                let styles = styles(stroke_width).skip(if stroke_width == 0 { 8 } else { 0 });
                for style in styles {
                    check(&shape, style, window, window.size.height);
                    check(&shape, style, window, 1);
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(config(cases(1_500, 12_000)))]

    #[test]
    fn small_corners_of_any_kind_are_exact(
        (width, height) in (0..16u32, 0..16u32),
        corners in any_corners(0..20u32),
        style in any_style(0..6u32),
        rows in 1..30u32,
    ) {
        let shape = RoundedRectangle::new(Rectangle::new(Point::new(2, 2), Size::new(width, height)), corners);
        let window = Rectangle::new(Point::new(-4, -4), Size::new(28, 28));
        check(&shape, style, window, 28);
        check(&shape, style, window, rows);
    }

    #[test]
    fn corners_of_any_size_are_exact(
        (width, height) in (any_length(), any_length()),
        corners in any_corners(any_length()),
        style in any_style(any_length()),
        view in any_view(),
        rows in 1..40u32,
    ) {
        let size = Size::new(width, height);
        let (window, corner) = view.position(size, view.radius_of(&corners), style.outside_stroke_width());
        let shape = RoundedRectangle::new(Rectangle::new(corner, size), corners);
        check(&shape, style, window, window.size.height);
        check(&shape, style, window, rows);
    }
}

/// One radius is larger than a `Size` can double; rows more than 2^31 below the first one are seen.
#[test]
fn a_corner_beyond_31_bits_is_exact() {
    let large = [Size::new(130, 21), Size::new(21, 130), Size::new(130, 130)];
    let sizes = [Size::new(718, 54), Size::new(54, 718), Size::new(718, 718)];
    for (radius, size) in large.into_iter().flat_map(|radius| sizes.map(|size| (radius, size))) {
        let mut corners = CornerRadii::new(Size::new(7, 9));
        corners.top_left = radius;
        let shape = RoundedRectangle::new(Rectangle::new(Point::new(3, -5), size), corners);
        for width in [400, 27, 26, 1, 0]
            .map(|less| (1 << 31) - less)
            .into_iter()
            .step_by(by_depth(4, 1, 1))
        {
            for style in styles(width) {
                for (x, y) in [
                    (-20, -20),
                    (20, 13),
                    (40, 46),
                    (-20, 79),
                    (690, 20),
                    (i32::MIN, i32::MIN),
                    (i32::MIN, 0),
                ] {
                    let window = Rectangle::new(Point::new(x, y), Size::new(40, 33));
                    check(&shape, style, window, 33);
                    check(&shape, style, window, 1);
                }
            }
        }
    }
}
