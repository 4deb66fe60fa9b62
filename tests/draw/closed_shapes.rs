//! Rectangles, circles and ellipses against the exact inequality, and against embedded-graphics where it is right.

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{self, Circle, Ellipse, PrimitiveStyleBuilder, Rectangle, StyledDimensions, StyledDrawable},
};
use proptest::prelude::*;
use zrow::{
    band::Generic,
    draw::{DrawOn, PrimitiveStyle, StrokeAlignment},
};

use crate::common::{cases, config, picture};
use crate::reference::box_axis::Axis;

const STROKE: Rgb565 = Rgb565::RED;
const FILL: Rgb565 = Rgb565::GREEN;

#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Kind {
    Rectangle,
    Circle,
    Ellipse,
}

/// A shape in its box; a circle takes the width.
#[derive(Debug, Copy, Clone)]
struct Shape {
    kind: Kind,
    x: i32,
    y: i32,
    width: u32,
    height: u32,
}

impl Shape {
    fn contains(&self, columns: Axis, rows: Axis, pixel: Point) -> bool {
        let (dx, dy) = (columns.distance(pixel.x), rows.distance(pixel.y));
        if dx >= columns.length || dy >= rows.length {
            return false;
        }
        let [dx, dy, width, height] = [dx, dy, columns.length, rows.length].map(|number| number as u128);
        match self.kind {
            Kind::Rectangle => true,
            _ if width == height => {
                let correction = if width <= 4 { width / 2 } else { 0 };
                dx * dx + dy * dy < width * width - correction
            }
            _ => height * height * dx * dx < width * width * (height * height - dy * dy),
        }
    }

    fn axes(&self) -> (Axis, Axis) {
        let height = if self.kind == Kind::Circle {
            self.width
        } else {
            self.height
        };
        (Axis::new(self.x, self.width), Axis::new(self.y, height))
    }

    fn reference(&self, style: &PrimitiveStyle<Rgb565>, window: Rectangle) -> Vec<Rgb565> {
        let (columns, rows) = self.axes();
        let (outside, inside) = match style.stroke_alignment {
            StrokeAlignment::Inside => (0, style.stroke_width),
            StrokeAlignment::Center => (style.stroke_width / 2, style.stroke_width.saturating_add(1) / 2),
            StrokeAlignment::Outside => (style.stroke_width, 0),
        };
        let outer = (columns.grown(self.x, outside), rows.grown(self.y, outside));
        let inner = (columns.shrunk(inside), rows.shrunk(inside));
        let stroke = style.stroke_color.filter(|_| style.stroke_width > 0);
        window
            .points()
            .map(|pixel| {
                let color = if self.contains(inner.0, inner.1, pixel) {
                    style.fill_color
                } else if self.contains(outer.0, outer.1, pixel) {
                    stroke
                } else {
                    None
                };
                color.unwrap_or(Rgb565::BLACK)
            })
            .collect()
    }

    fn draw_on(&self, style: PrimitiveStyle<Rgb565>, window: Rectangle) -> Vec<Rgb565> {
        let (top_left, size) = (Point::new(self.x, self.y), Size::new(self.width, self.height));
        picture(window, |band| match self.kind {
            Kind::Rectangle => Rectangle::new(top_left, size).into_styled(style).draw_on(band).unwrap(),
            Kind::Circle => Circle::new(top_left, self.width)
                .into_styled(style)
                .draw_on(band)
                .unwrap(),
            Kind::Ellipse => Ellipse::new(top_left, size).into_styled(style).draw_on(band).unwrap(),
        })
    }

    /// Through the other entry point, on a display that panics where a pixel is drawn twice or outside.
    fn draw<S>(&self, style: S, display: &mut MockDisplay<Rgb565>) -> Rectangle
    where
        Rectangle: StyledDrawable<S, Color = Rgb565> + StyledDimensions<S>,
        Circle: StyledDrawable<S, Color = Rgb565> + StyledDimensions<S>,
        Ellipse: StyledDrawable<S, Color = Rgb565> + StyledDimensions<S>,
    {
        let (top_left, size) = (Point::new(self.x, self.y), Size::new(self.width, self.height));
        match self.kind {
            Kind::Rectangle => draw_styled(Rectangle::new(top_left, size), style, display),
            Kind::Circle => draw_styled(Circle::new(top_left, self.width), style, display),
            Kind::Ellipse => draw_styled(Ellipse::new(top_left, size), style, display),
        }
    }

    /// embedded-graphics stops at the first row without a pixel, and high boxes of an even width begin with one.
    fn embedded_graphics_draws_nothing(&self, style: &PrimitiveStyle<Rgb565>) -> bool {
        let (mut width, mut height) = (i64::from(self.width), i64::from(self.height));
        let by = if style.stroke_color.is_some() && style.stroke_width > 0 {
            i64::from(style.outside_stroke_width())
        } else {
            -i64::from(style.inside_stroke_width())
        };
        (width, height) = ((width + 2 * by).max(0), (height + 2 * by).max(0));
        let first_row_is_empty = width > 0 && width % 2 == 0 && height * height >= width * width * (2 * height - 1);
        self.kind == Kind::Ellipse && width != height && first_row_is_empty
    }
}

fn draw_styled<P, S>(shape: P, style: S, display: &mut MockDisplay<Rgb565>) -> Rectangle
where
    P: StyledDrawable<S, Color = Rgb565> + StyledDimensions<S> + Primitive,
{
    let styled = shape.into_styled(style);
    styled.draw(display).unwrap();
    styled.bounding_box()
}

fn check(shape: Shape, style: PrimitiveStyle<Rgb565>, window: Rectangle) {
    let (expected, drawn) = (shape.reference(&style, window), shape.draw_on(style, window));
    for ((pixel, expected), drawn) in window.points().zip(expected).zip(drawn) {
        assert_eq!(drawn, expected, "{pixel} of {shape:?} in {style:?} in {window:?}");
    }
}

fn check_mock(shape: Shape, style: PrimitiveStyle<Rgb565>) {
    let mut display = MockDisplay::new();
    shape.draw(style, &mut display);
    let window = display.bounding_box();
    for (pixel, expected) in window.points().zip(shape.reference(&style, window)) {
        assert_eq!(
            display.get_pixel(pixel).unwrap_or(Rgb565::BLACK),
            expected,
            "{pixel} of {shape:?} in {style:?}"
        );
    }
}

fn kind() -> impl Strategy<Value = Kind> {
    prop::sample::select(vec![Kind::Rectangle, Kind::Circle, Kind::Ellipse])
}

fn style(width: impl Strategy<Value = u32>) -> impl Strategy<Value = PrimitiveStyle<Rgb565>> {
    (any::<bool>(), any::<bool>(), width, alignment()).prop_map(|(stroked, filled, width, alignment)| {
        let mut style = PrimitiveStyleBuilder::new()
            .stroke_width(width)
            .stroke_alignment(alignment);
        if stroked {
            style = style.stroke_color(STROKE);
        }
        if filled {
            style = style.fill_color(FILL);
        }
        style.build().into()
    })
}

fn alignment() -> impl Strategy<Value = StrokeAlignment> {
    prop::sample::select(vec![
        StrokeAlignment::Inside,
        StrokeAlignment::Center,
        StrokeAlignment::Outside,
    ])
}

fn small_shape() -> impl Strategy<Value = Shape> {
    let size = || prop_oneof![0..8u32, 0..90u32];
    (kind(), -60..80i32, -60..80i32, size(), size()).prop_map(|(kind, x, y, width, height)| Shape {
        kind,
        x,
        y,
        width,
        height,
    })
}

fn both_colors(stroke_width: u32) -> PrimitiveStyle<Rgb565> {
    PrimitiveStyleBuilder::new()
        .stroke_color(STROKE)
        .fill_color(FILL)
        .stroke_width(stroke_width)
        .build()
        .into()
}

/// A display's area at a corner of the number range or at the origin.
fn far_window() -> impl Strategy<Value = Rectangle> {
    let start = || prop::sample::select(vec![0, -9, i32::MIN, i32::MAX - 48, i32::MAX - 47, 1_000_000]);
    (start(), start()).prop_map(|(x, y)| Rectangle::new(Point::new(x, y), Size::new(47, 40)))
}

fn any_size() -> impl Strategy<Value = u32> {
    let edges = vec![
        0,
        1,
        2,
        3,
        4,
        5,
        1625,
        1626,
        32_768,
        46_340,
        46_341,
        65_535,
        65_536,
        92_681,
        92_682,
        1 << 31,
        u32::MAX - 1,
        u32::MAX,
    ];
    prop_oneof![
        2 => prop::sample::select(edges),
        1 => any::<u32>(),
        2 => 0..70_000u32,
        2 => 0..2000u32,
    ]
}

/// A shape whose outline passes near a pixel of the window: a random point of the outline is moved there.
fn shape_through(window: Rectangle) -> impl Strategy<Value = Shape> {
    (
        kind(),
        any_size(),
        any_size(),
        any::<u32>(),
        any::<bool>(),
        any::<bool>(),
        -30..70i64,
        -30..60i64,
    )
        .prop_map(move |(kind, width, height, along, right, below, x, y)| {
            let height = if kind == Kind::Circle { width } else { height };
            let (w, h) = (u128::from(width.max(1)), u128::from(height.max(1)));
            // Doubled distances on the curve; only roughly so on a rectangle, where the sides are what counts.
            let dx = (u128::from(along) * w) >> 32;
            let dy = ((w * w - dx * dx) * h / w * h / w).isqrt();
            let inset = |length: u128, distance: u128, mirrored: bool| {
                let distance = distance.min(length) as i64;
                let length = length as i64;
                if mirrored {
                    (length + distance) / 2
                } else {
                    (length - distance) / 2
                }
            };
            let from = |start: i32, offset: i64, inset: i64| {
                (i64::from(start) + offset - inset).clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
            };
            Shape {
                kind,
                x: from(window.top_left.x, x, inset(w, dx, right)),
                y: from(window.top_left.y, y, inset(h, dy, below)),
                width,
                height,
            }
        })
}

fn far_case() -> impl Strategy<Value = (Rectangle, Shape)> {
    far_window().prop_flat_map(|window| (Just(window), shape_through(window)))
}

proptest! {
    #![proptest_config(config(cases(150, 1_500)))]

    #[test]
    fn shapes_are_embedded_graphics_own(shape in small_shape(), style in style(0..40u32)) {
        if !shape.embedded_graphics_draws_nothing(&style) {
            let mut theirs = MockDisplay::new();
            theirs.set_allow_out_of_bounds_drawing(true);
            theirs.set_allow_overdraw(true);
            let mut their_style = primitives::PrimitiveStyle::new();
            their_style.fill_color = style.fill_color;
            their_style.stroke_color = style.stroke_color;
            their_style.stroke_width = style.stroke_width;
            their_style.stroke_alignment = style.stroke_alignment;
            let their_box = shape.draw(their_style, &mut theirs);

            let mut ours = MockDisplay::new();
            let our_box = shape.draw(style, &mut ours);
            // Theirs is that of all ellipses as wide and high; ours is the smallest one around the pixels.
            let expected_box = match shape.kind {
                Kind::Ellipse if !their_box.is_zero_sized() => their_box.intersection(&our_box),
                _ => their_box,
            };
            prop_assert_eq!(our_box, expected_box);
            prop_assert_eq!(ours.diff(&theirs).affected_area(), Rectangle::zero(), "{:?} in {:?}", shape, style);
            let drawn = shape.draw_on(style, ours.bounding_box());
            for (pixel, drawn) in ours.bounding_box().points().zip(drawn) {
                prop_assert_eq!(drawn, ours.get_pixel(pixel).unwrap_or(Rgb565::BLACK));
            }
        }
    }

    #[test]
    fn shapes_are_exact_and_draw_each_pixel_once(shape in small_shape(), style in style(0..40u32)) {
        check_mock(shape, style);
    }

    #[test]
    fn shapes_are_exact_in_one_row(shape in small_shape(), style in style(0..40u32), y in -9..80i32) {
        check(shape, style, Rectangle::new(Point::new(-3, y), Size::new(60, 1)));
    }

    #[test]
    fn shapes_of_any_size_are_exact_anywhere((window, shape) in far_case(), style in style(prop_oneof![0..60u32, any::<u32>()])) {
        check(shape, style, window);
    }

    #[test]
    fn what_is_clipped_is_what_is_seen_of_the_whole(
        shape in small_shape(),
        style in style(0..40u32),
        (x, y) in (-40..60i32, -40..60i32),
        (width, height) in (1..50u32, 1..50u32),
    ) {
        let whole = Rectangle::new(Point::new(-150, -150), Size::new(400, 400));
        let window = Rectangle::new(Point::new(x, y), Size::new(width, height));
        let drawn = shape.draw_on(style, whole);
        let seen: Vec<Rgb565> = whole.points().zip(drawn).filter(|(pixel, _)| window.contains(*pixel)).map(|(_, color)| color).collect();
        prop_assert_eq!(shape.draw_on(style, window), seen);
    }
}

/// Sizes that overflow embedded-graphics, whole.
#[test]
fn large_ellipses_are_exact() {
    let window = Rectangle::new(Point::new(-5, -5), Size::new(340, 260));
    for (width, height) in [
        (310, 230),
        (300, 200),
        (319, 1),
        (1, 239),
        (2, 200),
        (320, 240),
        (217, 216),
    ] {
        let shape = Shape {
            kind: Kind::Ellipse,
            x: 3,
            y: 2,
            width,
            height,
        };
        check(shape, both_colors(1), window);
        check(shape, both_colors(7), window);
        check(shape, PrimitiveStyle::with_fill(FILL), window);
    }
}

#[test]
fn diameters_at_the_ends_of_16_bits_are_exact() {
    for diameter in [46_341, 65_535] {
        for (x, y) in [
            (0, 0),
            (-(diameter as i32) / 2, -40),
            (-40, -(diameter as i32) / 2),
            (-6787, -6787),
            (40 - diameter as i32, -32_000),
        ] {
            for (kind, height) in [(Kind::Circle, diameter), (Kind::Ellipse, 46_340)] {
                let shape = Shape {
                    kind,
                    x,
                    y,
                    width: diameter,
                    height,
                };
                check(
                    shape,
                    both_colors(1),
                    Rectangle::new(Point::new(-9, -9), Size::new(80, 80)),
                );
            }
        }
    }
}

#[test]
fn all_small_circles_are_exact_and_symmetric() {
    for diameter in 1..=64 {
        let shape = Shape {
            kind: Kind::Circle,
            x: 0,
            y: 0,
            width: diameter,
            height: 0,
        };
        for stroke_width in [0, 1, 2] {
            for alignment in [StrokeAlignment::Inside, StrokeAlignment::Center] {
                let mut style = both_colors(stroke_width);
                style.stroke_alignment = alignment;
                let window = Rectangle::new(Point::new(-2, -2), Size::new(diameter + 4, diameter + 4));
                check(shape, style, window);
                let drawn = shape.draw_on(style, window);
                let side = (diameter + 4) as usize;
                for (index, color) in drawn.iter().enumerate() {
                    let (x, y) = (index % side, index / side);
                    assert_eq!(*color, drawn[x * side + y]);
                    assert_eq!(*color, drawn[y * side + (side - 1 - x)]);
                    assert_eq!(*color, drawn[(side - 1 - y) * side + x]);
                }
            }
        }
    }
}

#[test]
fn concentric_rings_leave_no_hole() {
    let mut style = PrimitiveStyle::with_stroke(STROKE, 1);
    style.stroke_alignment = StrokeAlignment::Inside;
    for odd in [0, 1] {
        // Overdraw panics: each ring fills exactly what the next smaller circle leaves.
        let mut display = MockDisplay::new();
        for radius in 0..=30u32 {
            let diameter = 2 * radius + odd;
            Circle::new(Point::new_equal(31 - radius as i32), diameter)
                .into_styled(style)
                .draw(&mut display)
                .unwrap();
        }
        let mut disc = MockDisplay::new();
        Circle::new(Point::new_equal(1), 60 + odd)
            .into_styled(PrimitiveStyle::with_fill(STROKE))
            .draw(&mut disc)
            .unwrap();
        display.assert_eq(&disc);
    }
}

/// Rings, which a band draws in a loop of their own, and strokes that are a little too wide or too long for it.
#[test]
fn rings_are_exact_wherever_they_are_cut() {
    let diameters = (1..=40).chain([64, 65, 101, 254, 255, 256, 511, 512, 1023, 1024, 1025]);
    for diameter in diameters {
        let shape = Shape {
            kind: Kind::Circle,
            x: -3,
            y: 5,
            width: diameter,
            height: 0,
        };
        for stroke_width in [1, 2, 3, 4, 5, 16] {
            let mut style = PrimitiveStyle::with_stroke(STROKE, stroke_width);
            style.stroke_alignment = StrokeAlignment::Inside;
            let half = diameter as i32 / 2;
            // Windows at the corners, at the sides and in the middle, and one that shows nearly all of it.
            for x in [-2, half - 5, half, diameter as i32 - 9] {
                for y in [-2, half - 5, half, diameter as i32 - 9] {
                    let corner = Point::new(x - 3, y + 5);
                    check(shape, style, Rectangle::new(corner, Size::new(11, 9)));
                }
            }
            if diameter < 256 {
                let window = Rectangle::new(Point::new(-4, 3), Size::new(diameter + 1, diameter + 1));
                check(shape, style, window);
            }
        }
    }
}

#[test]
fn the_largest_shapes_are_exact_at_the_ends_of_the_number_range() {
    let coordinates = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    let window = Rectangle::new(Point::new(-4, -4), Size::new(9, 9));
    for kind in [Kind::Rectangle, Kind::Circle, Kind::Ellipse] {
        for x in coordinates {
            for y in coordinates {
                for size in [u32::MAX, u32::MAX - 1, 1 << 31, (1 << 31) - 1] {
                    for stroke_width in [0, 1, u32::MAX] {
                        let shape = Shape {
                            kind,
                            x,
                            y,
                            width: size,
                            height: size - 2,
                        };
                        check(shape, both_colors(stroke_width), window);
                        let mut stroke = PrimitiveStyle::with_stroke(STROKE, stroke_width);
                        stroke.stroke_alignment = StrokeAlignment::Outside;
                        check(shape, stroke, window);
                    }
                }
            }
        }
    }
}

#[test]
fn the_box_of_the_largest_stroke_has_no_overflow() {
    let mut style = PrimitiveStyle::with_stroke(STROKE, u32::MAX);
    style.stroke_alignment = StrokeAlignment::Outside;
    let circle = Circle::new(Point::new(i32::MAX, i32::MIN), u32::MAX);
    assert_eq!(circle.styled_bounding_box(&style), circle.bounding_box());
    let ellipse = Ellipse::new(Point::new(0, i32::MIN), Size::new(1, 1));
    assert_eq!(
        ellipse.styled_bounding_box(&style),
        Rectangle::new(Point::new(-i32::MAX, i32::MIN), Size::new(u32::MAX, 1 << 31))
    );
}

#[test]
fn a_generic_target_is_drawn_on_directly() {
    let mut display = MockDisplay::new();
    Rectangle::new(Point::new(1, 1), Size::new(4, 3))
        .into_styled(both_colors(1))
        .draw_on(&mut Generic(&mut display))
        .unwrap();
    display.assert_pattern(&["     ", " RRRR", " RGGR", " RRRR"]);
}
