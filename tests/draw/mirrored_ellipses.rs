//! Antialiased ellipses about an axis in the middle or at a side of pixels: the right half is the mirror image of the left
//! half, which is that of a polygon with the same corners, in every window and in pictures.

use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::Band,
    coverage::SignedArea,
    draw::{
        AntialiasedPolygon, AntialiasingMemory, DrawAntialiased, FillRule, Picture, PictureSlot, PrimitiveStyle,
        SubEllipse,
    },
    fixed::types::U24F8,
    geometry::{Sub8, SubPoint},
};

use crate::common::{cases, config};

/// Columns and rows around all pixels that are looked at.
const AROUND: Rectangle = Rectangle::new(Point::new(-40, -30), Size::new(140, 100));
const WIDTH: usize = AROUND.size.width as usize;

/// The words of a window: coverages, because white is drawn on black.
fn words(window: Rectangle, draw: impl FnOnce(&mut Band<'_, Gray8>)) -> Vec<u8> {
    let mut words = vec![0; (window.size.width * window.size.height) as usize];
    draw(&mut Band::new(window, &mut words).unwrap());
    words
}

fn styled(ellipse: SubEllipse, window: Rectangle) -> Vec<u8> {
    words(window, |band| {
        let style = PrimitiveStyle::with_fill(Gray8::WHITE).antialiased();
        let mut cells = [0; WIDTH + 1];
        let mut target = band.antialiased::<512, 256>(&mut cells);
        ellipse.into_styled(style).draw_on(&mut target).unwrap();
        assert_eq!(cells, [0; WIDTH + 1]);
    })
}

fn polygon(ellipse: SubEllipse) -> Vec<u8> {
    words(AROUND, |band| {
        let polygon = AntialiasedPolygon::<1024, 512>::prepare(&ellipse, FillRule::NonZero).unwrap();
        polygon
            .draw(&SignedArea, Gray8::WHITE, band, &mut [0; WIDTH + 1])
            .unwrap();
    })
}

fn in_picture(ellipse: SubEllipse, window: Rectangle) -> Vec<u8> {
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 32], [0; 8]);
    let mut memory = AntialiasingMemory::<30, 0, 1>::new();
    let mut picture = Picture::new(AROUND, &mut slots, &mut pool, &mut buckets).with_antialiasing(&mut memory);
    picture.add_outline(&ellipse, FillRule::NonZero, Gray8::WHITE).unwrap();
    words(window, |band| picture.draw(band))
}

/// Radii in 1/256 pixel: hardly longer than rounding, ordinary, and such that the window lies inside, or many corners in a row.
fn radius() -> impl Strategy<Value = u32> {
    prop_oneof![2 => 0..300u32, 5 => 0..9_000u32, 2 => 0..60_000u32]
}

fn ellipses() -> impl Strategy<Value = SubEllipse> {
    // Axes beside the pixels that are looked at, too.
    (-200..260i32, -9_000..20_000i32, radius(), radius()).prop_map(|(halves, y, across, down)| {
        let center = SubPoint::<Sub8>::from_units(halves * 128, y).unwrap();
        SubEllipse::new(center, [across, down].map(U24F8::from_bits)).unwrap()
    })
}

fn windows() -> impl Strategy<Value = Rectangle> {
    (-40..99i32, -30..69i32, 1..140u32, 1..40u32).prop_map(|(x, y, width, height)| {
        Rectangle::new(Point::new(x, y), Size::new(width, height)).intersection(&AROUND)
    })
}

proptest! {
    #![proptest_config(config(cases(400, 10_000)))]

    #[test]
    fn the_right_half_is_the_mirror_image_of_the_left_half(
        halves in 0..120i32,
        y in -9_000..20_000i32,
        radii in (radius(), radius()),
    ) {
        let center = SubPoint::<Sub8>::from_units(halves * 128, y).unwrap();
        let ellipse = SubEllipse::new(center, [radii.0, radii.1].map(U24F8::from_bits)).unwrap();
        let (found, expected) = (styled(ellipse, AROUND), polygon(ellipse));
        let at = |words: &[u8], Point { x, y }: Point| {
            let Point { x, y } = Point::new(x, y) - AROUND.top_left;
            words[y as usize * WIDTH + x as usize]
        };
        for point in AROUND.points() {
            let mirrored = Point::new(halves - point.x, point.y);
            let (here, polygon) = (at(&found, point), at(&expected, point));
            prop_assert!(here.abs_diff(polygon) <= 1, "{point:?}: {here}, {polygon}");
            if point.x < mirrored.x {
                prop_assert_eq!(here, polygon, "{:?}", point);
            }
            if AROUND.contains(mirrored) {
                prop_assert_eq!(here, at(&found, mirrored), "{:?}", point);
            }
        }
    }

    #[test]
    fn windows_show_the_same(ellipse in ellipses(), windows in prop::collection::vec(windows(), 1..4)) {
        let expected = styled(ellipse, AROUND);
        for window in windows {
            let (found, prepared) = (styled(ellipse, window), in_picture(ellipse, window));
            prop_assert_eq!(&found, &prepared, "{:?}", window);
            for (line, y) in found.chunks(window.size.width as usize).zip(window.rows()) {
                let Point { x, y } = Point::new(window.top_left.x, y) - AROUND.top_left;
                let start = y as usize * WIDTH + x as usize;
                prop_assert_eq!(line, &expected[start..start + line.len()], "row {} of {:?}", y, window);
            }
        }
    }
}
