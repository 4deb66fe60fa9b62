//! Patterns and gradients against exact arithmetic, and what is drawn with them.

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::{Circle, Ellipse, Line, Rectangle, Triangle},
    text::Text,
};
use proptest::prelude::*;
use zrow::{
    band::{Band, Target},
    draw::{DrawOn, PrimitiveStyle},
    geometry::InputError,
    shade::{LinearGradient, Paint, Pattern, RadialGradient, Ramp},
};

use crate::common::{cases, config, picture};

/// Level n is the colour n: a ramp that shows its levels.
fn levels() -> Ramp<2> {
    Ramp::between(Rgb888::BLACK, Rgb888::WHITE)
}

fn shown(paint: &impl Paint<Color = Rgb888>, start: Point, count: usize) -> Vec<i128> {
    let colors = paint.colors_from(start).take(count);
    colors.map(|color| i128::from(color.g())).collect()
}

fn any_point() -> impl Strategy<Value = Point> {
    let number = || {
        prop_oneof![
            -40..360i32,
            -8191..=8191i32,
            Just(i32::MIN),
            Just(i32::MAX - 64),
            any::<i32>()
        ]
    };
    (number(), number()).prop_map(|(x, y)| Point::new(x.min(i32::MAX - 64), y))
}

fn near_point() -> impl Strategy<Value = Point> {
    let number = || prop_oneof![4 => -40..360i32, 1 => -8191..=8191i32, 1 => Just(8191), 1 => Just(-8191)];
    (number(), number()).prop_map(|(x, y)| Point::new(x, y))
}

proptest! {
    #![proptest_config(config(cases(4_000, 4_000)))]

    #[test]
    fn a_linear_level_is_the_exact_place_rounded(from in near_point(), to in near_point(), start in any_point()) {
        let gradient = LinearGradient::new(from, to, levels()).unwrap();
        let (x, y) = (i128::from(to.x - from.x), i128::from(to.y - from.y));
        for (column, level) in shown(&gradient, start, 64).into_iter().enumerate() {
            let along = (i128::from(start.x) + column as i128 - i128::from(from.x)) * x
                + (i128::from(start.y) - i128::from(from.y)) * y;
            let length = x * x + y * y;
            let exact = match length {
                0 => 255,
                // floor(255 along / length + 1/2)
                length => (510 * along + length).div_euclid(2 * length).clamp(0, 255),
            };
            prop_assert_eq!(level, exact);
        }
    }

    #[test]
    fn a_radial_level_is_the_exact_distance_rounded(
        center in any_point(),
        radius in prop_oneof![0..4u32, 0..400u32, Just(8191u32)],
        aside in prop_oneof![4 => -500..500i32, 1 => any::<i32>()],
        below in prop_oneof![4 => -500..500i32, 1 => any::<i32>()],
    ) {
        let gradient = RadialGradient::new(center, radius, levels()).unwrap();
        let start = Point::new(center.x.saturating_add(aside).min(i32::MAX - 64), center.y.saturating_add(below));
        for (column, level) in shown(&gradient, start, 64).into_iter().enumerate() {
            let x = i128::from(start.x) + column as i128 - i128::from(center.x);
            let y = i128::from(start.y) - i128::from(center.y);
            // The greatest level whose lower border, (level - 1/2) radius / 255, is not beyond the pixel.
            let radius = i128::from(radius);
            let exact = (0..=255i128)
                .rev()
                .find(|&level| level == 0 || ((2 * level - 1) * radius).pow(2) <= 510 * 510 * (x * x + y * y));
            prop_assert_eq!(Some(level), if radius == 0 { Some(255) } else { exact });
        }
    }

    #[test]
    fn a_ramp_is_within_half_a_level_of_the_straight_line(first: [u8; 4], between: [u8; 4], last: [u8; 4], level: u8) {
        let mut stops = [first, between, last].map(|[level, red, green, blue]| (level, Rgb888::new(red, green, blue)));
        stops.sort_by_key(|&(level, _)| level);
        let color = Ramp::new(stops).unwrap().color_at(level);
        let after = stops.iter().find(|(stop, _)| *stop > level);
        let before = stops.iter().rev().find(|(stop, _)| *stop <= level);
        let channels = |color: Rgb888| [color.r(), color.g(), color.b()].map(f64::from);
        let exact = match (before, after) {
            (Some(before), Some(after)) => {
                let fraction = f64::from(level - before.0) / f64::from(after.0 - before.0);
                let (start, end) = (channels(before.1), channels(after.1));
                [0, 1, 2].map(|channel| start[channel] + fraction * (end[channel] - start[channel]))
            }
            (Some(stop), None) | (None, Some(stop)) => channels(stop.1),
            (None, None) => unreachable!(),
        };
        for (found, exact) in channels(color).into_iter().zip(exact) {
            prop_assert!((found - exact).abs() <= 0.502, "{} instead of {}", found, exact);
        }
    }

    #[test]
    fn a_pattern_repeats_from_its_origin(
        width in 1..6usize,
        height in 1..6usize,
        origin in any_point(),
        start in any_point(),
    ) {
        let colors: Vec<Rgb888> = (0..(width * height) as u8).map(|number| Rgb888::new(0, number, 0)).collect();
        let pattern = Pattern::new(width, &colors).unwrap().with_origin(origin);
        let offset = |coordinate: i128, origin: i32, size: usize| (coordinate - i128::from(origin)).rem_euclid(size as i128);
        let row = offset(i128::from(start.y), origin.y, height);
        for (column, number) in shown(&pattern, start, 16).into_iter().enumerate() {
            let column = offset(i128::from(start.x) + column as i128, origin.x, width);
            prop_assert_eq!(number, row * width as i128 + column);
        }
    }
}

#[test]
fn every_stop_has_its_own_color() {
    let stop = |level, red| (level, Rgb888::new(red, 0, 255 - red));
    let ramp = Ramp::new([stop(0, 7), stop(100, 200), stop(100, 20), stop(255, 255)]).unwrap();
    assert_eq!([0, 100, 255].map(|level| ramp.color_at(level).r()), [7, 20, 255]);
    // The one before the jump is not far from the first of both.
    assert_eq!(ramp.color_at(99).r(), 198);
    assert_eq!(Ramp::new([stop(3, 7)]).unwrap().color_at(0).r(), 7);
    assert_eq!(Ramp::new([stop(2, 7), stop(1, 7)]), Err(InputError::NotAscending));
    assert_eq!(Ramp::new([]), Err(InputError::NotAscending));
}

#[test]
fn what_is_out_of_the_domain_is_an_error() {
    let far = InputError::OutOfDomain { min: -8191, max: 8191 };
    let linear = |from, to| LinearGradient::<Rgb888, 2>::new(from, to, levels()).err();
    assert_eq!(linear(Point::zero(), Point::new(0, 8192)), Some(far));
    assert_eq!(linear(Point::new(i32::MIN, 0), Point::zero()), Some(far));
    let radial = |radius| RadialGradient::<Rgb888, 2>::new(Point::zero(), radius, levels()).err();
    assert_eq!((radial(8191), radial(8192)), (None, Some(far)));
    let pattern = |width, colors| Pattern::new(width, &[Rgb565::RED; 6][..colors]).err();
    assert_eq!(pattern(3, 6), None);
    assert_eq!(pattern(4, 6), Some(InputError::NotARectangle { width: 4, colors: 6 }));
    assert_eq!(pattern(0, 6), Some(InputError::NotARectangle { width: 0, colors: 6 }));
    assert_eq!(pattern(2, 0), Some(InputError::NotARectangle { width: 2, colors: 0 }));
}

const AREA: Rectangle = Rectangle::new(Point::new(-5, 2), Size::new(60, 50));

fn gradient() -> LinearGradient<Rgb565, 2> {
    let ramp = Ramp::between(Rgb888::new(255, 0, 40), Rgb888::new(20, 255, 255));
    LinearGradient::new(Point::new(3, 5), Point::new(40, 30), ramp).unwrap()
}

/// Shapes in white, of every kind that a target takes: spans, blocks, lines, trapezoids, mirrored rows, pixels.
fn draw_shapes(target: &mut impl zrow::band::Target<Color = Rgb565>) {
    let fill = PrimitiveStyle::with_fill(Rgb565::WHITE);
    let thin = PrimitiveStyle::with_stroke(Rgb565::WHITE, 1);
    let wide = PrimitiveStyle::with_stroke(Rgb565::WHITE, 5);
    let results = [
        Circle::new(Point::new(-9, 0), 24).into_styled(fill).draw_on(target),
        Ellipse::new(Point::new(20, 5), Size::new(30, 16))
            .into_styled(wide)
            .draw_on(target),
        Rectangle::new(Point::new(30, 30), Size::new(9, 12))
            .into_styled(fill)
            .draw_on(target),
        Triangle::new(Point::new(0, 30), Point::new(25, 26), Point::new(8, 70))
            .into_styled(fill)
            .draw_on(target),
        Line::new(Point::new(-20, 3), Point::new(70, 44))
            .into_styled(thin)
            .draw_on(target),
        Line::new(Point::new(50, 3), Point::new(41, 44))
            .into_styled(wide)
            .draw_on(target),
    ];
    assert!(results.into_iter().all(|result| result.is_ok()));
    let text = Text::new("Row", Point::new(14, 40), MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE));
    assert!(text.draw(target).is_ok());
}

/// What is drawn through the paint has the shapes' pixels and the paint's colours; a band at a time too.
#[test]
fn painted_shapes_have_their_pixels_in_the_colors_of_the_paint() {
    let white = picture(AREA, |band| draw_shapes(band));
    let painted = picture(AREA, |band| draw_shapes(&mut band.painted(gradient())));
    let expected: Vec<Rgb565> = AREA
        .points()
        .zip(&white)
        .map(|(point, &drawn)| match drawn {
            Rgb565::WHITE => gradient().colors_from(point).next().unwrap(),
            _ => Rgb565::BLACK,
        })
        .collect();
    assert_eq!(painted, expected);
    assert!(white.iter().filter(|&&color| color == Rgb565::WHITE).count() > 800);

    let mut in_bands = Vec::new();
    for first_row in AREA.rows().step_by(7) {
        let height = (AREA.rows().end - first_row).min(7) as u32;
        let area = Rectangle::new(
            Point::new(AREA.top_left.x, first_row),
            Size::new(AREA.size.width, height),
        );
        let mut words = vec![0; (area.size.width * height) as usize];
        let mut band = Band::<Rgb565>::new(area, &mut words).unwrap();
        draw_shapes(&mut band.painted(gradient()));
        in_bands.extend(band.colors());
    }
    assert_eq!(in_bands, expected);
}

/// Through the other entry point of embedded-graphics too, on any display.
#[test]
fn a_display_takes_painted_shapes() {
    use zrow::band::Generic;
    let mut display = embedded_graphics::mock_display::MockDisplay::<Rgb565>::new();
    let colors = [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE];
    let pattern = Pattern::new(3, &colors).unwrap();
    let mut target = Generic(&mut display);
    Circle::new(Point::new(1, 0), 5)
        .into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE))
        .draw(&mut target.painted(pattern))
        .unwrap();
    display.assert_pattern(&["  BRG ", " GBRGB", " GBRGB", " GBRGB", "  BRG "]);
}
