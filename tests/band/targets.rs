//! Every draw target against one contract: the visible pixels of what is asked for are drawn and no others, at a cost that
//! grows with them alone, whatever the numbers are.

use std::{cell::Cell, convert::Infallible};

use embedded_graphics::{
    Pixel,
    pixelcolor::{Gray8, Rgb565, Rgb888},
    prelude::*,
    primitives::{Line, Rectangle, Triangle},
};
use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor, BigEndian, Generic, LittleEndian, Order, Span, Target},
    coverage::{Rooks, SamplePattern},
    draw::{DrawOn, PrimitiveStyle},
    geometry::{Sub4, Window},
    scene::{Camera, DepthWidth, Memory},
    shade::{BlendTarget, Paint, SampleTarget},
};
use zrow_methods::LookOf;

use crate::{
    common::{cases, config},
    target_calls::{
        Call, Colors, Numbered, Reading, asked_for, blend_call, call, check_reading, in_window, points, sample_call,
    },
};

/// What pictures begin with.
fn blank<C: BandColor>() -> C {
    C::from_word(bytemuck::Zeroable::zeroed())
}

type Outcome = Result<(), TestCaseError>;

fn draw_pixels<C: Numbered, T: DrawTarget<Color = C, Error = Infallible>>(
    target: &mut T,
    call: &Call,
    window: &Window,
) -> Outcome {
    let Ok(()) = match call {
        Call::Pixels(pixels) => {
            target.draw_iter(pixels.iter().map(|&(point, number)| Pixel(point, C::numbered(number))))
        }
        Call::Contiguous(area, count) => {
            let reading = Reading::default();
            let Ok(()) = target.fill_contiguous(area, Colors::<C>::new(*count, &reading));
            return check_reading(&reading, area, *count, window);
        }
        Call::Solid(area, number) => target.fill_solid(area, C::numbered(*number)),
        Call::Clear(number) => target.clear(C::numbered(*number)),
        _ => unreachable!("a call of other targets"),
    };
    Ok(())
}

fn draw_shapes<C: Numbered, T: Target<Color = C, Error = Infallible>>(target: &mut T, call: &Call) -> Outcome {
    let window = target.window();
    let Ok(()) = match call {
        Call::Span(span, number) => target.fill_span(*span, target.raw(C::numbered(*number))),
        Call::Window(block, number) => target.fill_window(*block, target.raw(C::numbered(*number))),
        Call::Line((from, to), number) => {
            let style = PrimitiveStyle::with_stroke(C::numbered(*number), 1);
            Line::new(*from, *to).into_styled(style).draw_on(target)
        }
        Call::Triangle(vertices, number) => {
            let origin = Point::new(window.left, window.top);
            let [a, b, c] = vertices.map(|vertex| vertex + origin);
            let style = PrimitiveStyle::with_fill(C::numbered(*number));
            Triangle::new(a, b, c).into_styled(style).draw_on(target)
        }
        _ => return draw_pixels(target, call, &window),
    };
    Ok(())
}

fn draw_blended<C: Numbered, T: BlendTarget<Color = C, Error = Infallible>>(target: &mut T, call: &Call) -> Outcome {
    let Call::Blend(span, number, is_covered) = call else {
        return draw_shapes(target, call);
    };
    let Ok(()) = target.blend_span(*span, C::numbered(*number), if *is_covered { 255 } else { 0 });
    Ok(())
}

fn draw_samples<C: Numbered, T: SampleTarget<Color = C, Error = Infallible>>(target: &mut T, call: &Call) -> Outcome {
    let Ok(()) = match call {
        Call::Samples(span, number, is_covered) => {
            let mask = if *is_covered { u32::MAX } else { 0 };
            target.fill_samples(*span, mask, target.raw(C::numbered(*number)))
        }
        Call::SampleColors(span, count) => {
            let reading = Reading::default();
            let Ok(()) = target.set_samples(*span, u32::MAX, Colors::<C>::new(*count, &reading));
            let width = i64::from(span.end) - i64::from(span.start);
            let area = Rectangle::new(Point::new(span.start, span.y), Size::new(width.max(0) as u32, 1));
            return check_reading(&reading, &area, *count, &target.window());
        }
        _ => return draw_shapes(target, call),
    };
    Ok(())
}

/// Multisampled targets blend as well.
fn draw_all<C: Numbered, T>(target: &mut T, call: &Call) -> Outcome
where
    T: SampleTarget<Color = C, Error = Infallible> + BlendTarget,
{
    match call {
        Call::Blend(..) => draw_blended(target, call),
        _ => draw_samples(target, call),
    }
}

/// A display that takes only what is inside it, and counts.
struct Strict<C> {
    window: Window,
    colors: Vec<C>,
    pixels: u64,
    calls: u64,
}

impl<C: Numbered> Strict<C> {
    fn new(window: Window) -> Self {
        Self {
            window,
            colors: vec![blank::<C>(); points(&window).count()],
            pixels: 0,
            calls: 0,
        }
    }

    fn set(&mut self, point: Point, color: C) {
        assert!(self.window.contains(point), "{point:?} is outside the display");
        let row = i64::from(point.y) - i64::from(self.window.top);
        let column = i64::from(point.x) - i64::from(self.window.left);
        self.colors[(row * i64::from(self.window.width()) + column) as usize] = color;
        self.pixels += 1;
    }
}

impl<C: Numbered> Dimensions for Strict<C> {
    fn bounding_box(&self) -> Rectangle {
        self.window.to_rectangle()
    }
}

impl<C: Numbered> DrawTarget for Strict<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.calls += 1;
        for Pixel(point, color) in pixels {
            self.set(point, color);
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible> {
        self.calls += 1;
        // As drivers do, this one reads no further than the area.
        for (point, color) in points(&Window::from(*area)).zip(colors) {
            self.set(point, color);
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        self.calls += 1;
        for point in points(&Window::from(*area)) {
            self.set(point, color);
        }
        Ok(())
    }
}

/// A paint that shows where it was asked, and counts how often.
struct Coordinates<C>(Cell<u64>, core::marker::PhantomData<C>);

fn number_at(point: Point) -> u16 {
    (point.x.wrapping_mul(31) ^ point.y.wrapping_mul(7)) as u16
}

impl<C: Numbered> Paint for Coordinates<C> {
    type Color = C;

    fn colors_from(&self, start: Point) -> impl Iterator<Item = C> {
        self.0.set(self.0.get() + 1);
        (0i32..).map(move |column| C::numbered(number_at(Point::new(start.x.wrapping_add(column), start.y))))
    }
}

/// The picture that calls make.
fn reference<C: Numbered>(window: &Window, calls: &[Call], is_painted: bool) -> Vec<C> {
    let mut pixels: Vec<(Point, C)> = points(window).map(|point| (point, blank::<C>())).collect();
    for call in calls {
        let mut asked = asked_for(call, window).into_iter().peekable();
        for (point, color) in &mut pixels {
            if let Some((_, number)) = asked.next_if(|asked| asked.0 == *point) {
                *color = C::numbered(if is_painted { number_at(*point) } else { number });
            }
        }
    }
    pixels.into_iter().map(|(_, color)| color).collect()
}

fn banded<C: Numbered, O: Order>(
    window: &Window,
    draw: impl FnOnce(&mut Band<'_, C, O>) -> Outcome,
) -> Result<Vec<C>, TestCaseError> {
    // What lies behind the band's own words stays as it is.
    let (mut words, needed) = (vec![C::numbered(1).to_word(); 200], points(window).count());
    let mut band = Band::<C, O>::new(window.to_rectangle(), &mut words).unwrap();
    band.words_mut().fill(bytemuck::Zeroable::zeroed());
    draw(&mut band)?;
    let colors = band.colors().collect();
    prop_assert!(words[needed..].iter().all(|&word| word == C::numbered(1).to_word()));
    Ok(colors)
}

fn paint<C>() -> Coordinates<C> {
    Coordinates(Cell::new(0), core::marker::PhantomData)
}

/// Draws the calls that all targets take into all of them.
fn check_targets<C: Numbered, O: Order>(window: &Window, calls: &[Call]) -> Outcome {
    let expected = reference::<C>(window, calls, false);
    let found = banded::<C, O>(window, |band| calls.iter().try_for_each(|call| draw_shapes(band, call)))?;
    prop_assert_eq!(&found, &expected, "a band");
    let mut display = Strict::<C>::new(*window);
    for call in calls {
        let (pixels, visible) = (display.pixels, asked_for(call, window));
        draw_shapes(&mut Generic(&mut display), call)?;
        if !matches!(call, Call::Pixels(_)) {
            prop_assert_eq!(display.pixels - pixels, visible.len() as u64);
        }
    }
    prop_assert_eq!(&display.colors, &expected, "a display");
    let rows = calls.len() as u64 * u64::from(window.height() + 2);
    prop_assert!(display.calls <= rows, "{} calls of a display", display.calls);

    let expected = reference::<C>(window, calls, true);
    let paint = paint();
    let mut display = Strict::<C>::new(*window);
    for call in calls {
        draw_shapes(&mut Generic(&mut display).painted(&paint), call)?;
    }
    prop_assert_eq!(&display.colors, &expected, "a painted display");
    let found = banded::<C, O>(window, |band| {
        let mut target = band.painted(&paint);
        calls.iter().try_for_each(|call| draw_shapes(&mut target, call))
    })?;
    prop_assert_eq!(&found, &expected, "a painted band");
    let single = |call: &Call| match call {
        Call::Pixels(pixels) => pixels.len() as u64,
        _ => u64::from(window.height() + window.width()),
    };
    prop_assert!(paint.0.get() <= 2 * calls.iter().map(single).sum::<u64>());
    Ok(())
}

/// Draws the calls that blending targets take.
fn check_blending<C: Numbered, O: Order>(window: &Window, calls: &[Call]) -> Outcome {
    let expected = reference::<C>(window, calls, false);
    let found = banded::<C, O>(window, |band| {
        calls.iter().try_for_each(|call| draw_blended(band, call))
    })?;
    prop_assert_eq!(&found, &expected, "a band");
    let found = banded::<C, O>(window, |band| {
        let mut target = band.in_linear_light::<22>();
        calls.iter().try_for_each(|call| draw_blended(&mut target, call))
    })?;
    prop_assert_eq!(&found, &expected, "in linear light");
    Ok(())
}

/// Draws the calls that multisampled targets take.
fn check_samples<C: Numbered, O: Order, P: SamplePattern + Copy>(
    window: &Window,
    calls: &[Call],
    pattern: P,
) -> Outcome {
    let mut samples = vec![bytemuck::Zeroable::zeroed(); P::SAMPLES * points(window).count()];
    let found = banded::<C, O>(window, |band| {
        band.multisample(pattern, &mut samples, |target| {
            calls.iter().try_for_each(|call| draw_all(target, call))
        })
        .unwrap()
    })?;
    prop_assert_eq!(found, reference::<C>(window, calls, false), "multisampled");
    let paint = paint();
    // Blending takes no paint.
    let calls: Vec<Call> = calls
        .iter()
        .filter(|call| !matches!(call, Call::Blend(..)))
        .cloned()
        .collect();
    let found = banded::<C, O>(window, |band| {
        band.multisample(pattern, &mut samples, |target| {
            let mut target = target.painted(&paint);
            calls.iter().try_for_each(|call| draw_samples(&mut target, call))
        })
        .unwrap()
    })?;
    prop_assert_eq!(found, reference::<C>(window, &calls, true), "multisampled and painted");
    Ok(())
}

/// Draws into the rows of a scene without faces, each call at a depth of its own. Columns of the band to both sides of the
/// viewport are no part of the scene.
fn check_depth<C: Numbered, O: Order, D: DepthWidth>(window: &Window, calls: &[(Call, D)]) -> Outcome {
    let camera = Camera::new(window.to_rectangle(), I16F16::from_num(128)).unwrap();
    let mut memory = Memory::<LookOf<C, Sub4, D>, 1, 1, 128, 16, 1>::new();
    let mut prepared = memory.prepare(&camera, &[]).unwrap();
    let whole = Window {
        left: window.left - 2,
        right: window.right + 3,
        ..*window
    };
    let mut outcome = Ok(());
    let found = banded::<C, O>(&whole, |band| {
        prepared.draw_with(band, |row| {
            for (call, depth) in calls {
                let mut target = row.at_depth(*depth);
                if outcome.is_ok() {
                    outcome = draw_shapes(&mut target, call);
                }
            }
        });
        Ok(())
    })?;
    outcome?;
    let expected: Vec<C> = points(&whole)
        .map(|point| {
            let row = Window {
                top: point.y,
                bottom: point.y + 1,
                ..*window
            };
            let (mut color, mut stored) = (blank::<C>(), D::FARTHEST);
            for (call, depth) in calls {
                if *depth > stored {
                    let asked = asked_for(call, &row).into_iter().find(|asked| asked.0 == point);
                    // Of several pixels at the same position, the first is in front of the others.
                    let number = match call {
                        Call::Pixels(pixels) => {
                            let pixel = pixels.iter().find(|pixel| pixel.0 == point);
                            pixel.filter(|_| asked.is_some()).map(|pixel| pixel.1)
                        }
                        _ => asked.map(|asked| asked.1),
                    };
                    if let Some(number) = number {
                        (color, stored) = (C::numbered(number), *depth);
                    }
                }
            }
            color
        })
        .collect();
    prop_assert_eq!(found, expected, "a depth row");
    Ok(())
}

proptest! {
    #![proptest_config(config(cases(750, 6_000)))]

    #[test]
    fn targets_draw_what_is_visible((window, calls) in in_window(call)) {
        check_targets::<Rgb565, LittleEndian>(&window, &calls)?;
        check_targets::<Rgb565, BigEndian>(&window, &calls)?;
        check_targets::<Gray8, LittleEndian>(&window, &calls)?;
        check_targets::<Rgb888, LittleEndian>(&window, &calls)?;
    }

    #[test]
    fn blending_targets_draw_what_is_visible(
        (window, calls) in in_window(|window| prop_oneof![call(window), blend_call(window)]),
    ) {
        check_blending::<Rgb565, LittleEndian>(&window, &calls)?;
        check_blending::<Gray8, BigEndian>(&window, &calls)?;
    }

    #[test]
    fn multisampled_targets_draw_what_is_visible(
        (window, calls) in in_window(|window| prop_oneof![call(window), blend_call(window), sample_call(window)]),
    ) {
        check_samples::<Rgb565, LittleEndian, _>(&window, &calls, Rooks::<4>)?;
        check_samples::<Gray8, BigEndian, _>(&window, &calls, Rooks::<8>)?;
    }

    #[test]
    fn depth_rows_draw_what_is_visible(
        (window, calls) in (-1_000..900i32, -1_000..900i32, 1..=12i32, 1..=6i32).prop_flat_map(|(left, top, width, height)| {
            let window = Window { left, top, right: left + width, bottom: top + height };
            (Just(window), prop::collection::vec((call(window), 0..4u16), 1..5))
        }),
    ) {
        check_depth::<Rgb565, LittleEndian, u16>(&window, &calls)?;
        let calls: Vec<(Call, u32)> = calls.into_iter().map(|(call, depth)| (call, u32::from(depth) << 16)).collect();
        check_depth::<Gray8, BigEndian, u32>(&window, &calls)?;
    }
}

/// The pixels of a multisampled window that are not what they began as, where an area is filled with colours or with one.
fn multisampled(window: Window, area: &Rectangle, colors: Option<Colors<Rgb565>>) -> usize {
    let mut samples = vec![0; Rooks::<4>::SAMPLES * points(&window).count()];
    let mut words = vec![0; points(&window).count()];
    let mut band = Band::<Rgb565>::new(window.to_rectangle(), &mut words).unwrap();
    let drawn = band.multisample(Rooks::<4>, &mut samples, |target| match colors {
        Some(colors) => target.fill_contiguous(area, colors),
        None => target.fill_solid(area, Rgb565::RED),
    });
    assert_eq!(drawn, Ok(Ok(())));
    band.colors().filter(|&color| color != Rgb565::BLACK).count()
}

const LAST_COLUMNS: Window = Window {
    left: i32::MAX - 64,
    top: 0,
    right: i32::MAX,
    bottom: 48,
};

/// What lies between the rectangle and the window is as wide as the number range.
#[test]
fn a_rectangle_far_left_of_the_last_columns_is_not_in_them() {
    let area = Rectangle::new(Point::new(-2_147_483_644, 7), Size::new(13, 13));
    assert_eq!(multisampled(LAST_COLUMNS, &area, None), 0);
}

#[test]
fn a_span_that_reaches_out_of_a_display_is_cut_to_it() {
    let mut display = Strict::<Rgb565>::new(LAST_COLUMNS);
    let mut target = Generic(&mut display);
    for (span, pixels) in [
        (Span::new(3, i32::MIN, i32::MAX), 64),
        (Span::new(3, i32::MAX - 70, i32::MAX - 60), 4),
        (Span::new(48, i32::MIN, i32::MAX), 0),
        (Span::new(-1, i32::MIN, i32::MAX), 0),
        (Span::new(3, i32::MAX, i32::MIN), 0),
    ] {
        let before = target.0.pixels;
        let Ok(()) = target.fill_span(span, Rgb565::RED);
        assert_eq!(target.0.pixels - before, pixels, "{span:?}");
    }
}

/// An area as large as one can be: 64 x 48 of its colours are read, and one step leads to each row.
#[test]
fn endless_areas_cost_what_is_visible() {
    // A step is as long as a `usize`: with 32 bits one leads to the next row, and not past 2^31 rows.
    let top = if usize::BITS < 64 { LAST_COLUMNS.top } else { i32::MIN };
    let area = Rectangle::new(Point::new(i32::MIN, top), Size::new(u32::MAX, u32::MAX));
    let check = |draw: &dyn Fn(Colors<Rgb565>)| {
        let reading = Reading::default();
        draw(Colors::new(u128::MAX, &reading));
        assert_eq!(reading.calls.get(), 64 * 48 + 48);
    };
    check(&|colors| {
        assert_eq!(multisampled(LAST_COLUMNS, &area, Some(colors)), 64 * 48);
    });
    check(&|colors| {
        let mut display = Strict::<Rgb565>::new(LAST_COLUMNS);
        let Ok(()) = Generic(&mut display).painted(paint()).fill_contiguous(&area, colors);
        assert_eq!((display.pixels, display.calls), (64 * 48, 48));
    });
}
