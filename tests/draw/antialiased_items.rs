//! Antialiased polygons in pictures: the same as drawn without a picture, boxes that are tight, damage that leaves
//! nothing out.

use core::cell::RefCell;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::Band,
    coverage::{AnyCoverage, CoverageMethod, InsideArea, SignedArea},
    draw::{AntialiasedItem, AntialiasedPolygon, DrawOn, FillRule, Picture, PictureItem, PictureSlot, PrimitiveStyle},
    geometry::{Sub8, SubPoint, Table, TooSmall, Window},
};

use crate::common::{cases, config};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(50, 40));
const WIDTH: usize = 50;

type Polygon = AntialiasedPolygon<8, 8>;

fn polygons() -> impl Strategy<Value = (Vec<SubPoint<Sub8>>, FillRule, Rgb565)> {
    // Some on the boundaries of pixels, where boxes begin and end.
    let units = |end: i32| prop_oneof![3 => -10 * 256..end * 256, 1 => (-10..end).prop_map(|x| x * 256 + 128)];
    let points = (units(60), units(50)).prop_map(|(x, y)| SubPoint::from_units(x, y).unwrap());
    let rules = prop_oneof![Just(FillRule::NonZero), Just(FillRule::EvenOdd)];
    let colors = (1..32u8, 0..64u8, 0..32u8).prop_map(|(red, green, blue)| Rgb565::new(red, green, blue));
    (proptest::collection::vec(points, 3..8), rules, colors)
}

fn prepared(corners: &[SubPoint<Sub8>], fill_rule: FillRule) -> Polygon {
    Polygon::prepare(&[corners], fill_rule).unwrap()
}

/// The words of an area after drawing, row by row.
fn words(area: Rectangle, draw: impl FnOnce(&mut Band<'_, Rgb565>)) -> Vec<u16> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    draw(&mut Band::new(area, &mut words).unwrap());
    words
}

/// Draws the damage of a picture onto a display.
fn draw_damage(picture: &mut Picture<'_, '_, Rgb565>, display: &mut [u16]) {
    while let Some(area) = picture.next_damage() {
        let area = area.intersection(&AREA);
        for y in area.rows() {
            let row = Rectangle::new(Point::new(area.top_left.x, y), Size::new(area.size.width, 1));
            let found = words(row, |band| picture.draw(band));
            let start = y as usize * WIDTH + area.top_left.x as usize;
            display[start..start + found.len()].copy_from_slice(&found);
        }
    }
}

proptest! {
    #![proptest_config(config(cases(500, 5_000)))]

    /// All that has coverage is in the box, and the box has nothing to spare but for corners of pixels that an edge
    /// passes.
    #[test]
    fn boxes_are_tight((corners, fill_rule, _) in polygons()) {
        let polygon = prepared(&corners, fill_rule);
        let bounds = polygon.bounds();
        let everywhere = Window { left: -20, top: -20, right: 80, bottom: 80 };
        let mut cells = vec![0; InsideArea::cells(100)];
        polygon.cover::<_, TooSmall>(&InsideArea, &everywhere, &mut cells, |span, coverage| {
            assert!(coverage == 0 || bounds.contains(Point::new(span.start, span.y)), "{span:?} of {bounds:?}");
            assert!(coverage == 0 || bounds.contains(Point::new(span.end - 1, span.y)), "{span:?} of {bounds:?}");
            Ok(())
        }).unwrap();
        // The box of the corners, in pixels around their centres.
        let sides = |units: fn(&SubPoint<Sub8>) -> i32| {
            let units = || corners.iter().map(units).map(|unit| unit + 128);
            (units().min().unwrap() >> 8, (units().max().unwrap() + 255) >> 8)
        };
        let (top, bottom) = sides(|point| point.y_units());
        if bounds != Window::EMPTY {
            let (left, right) = sides(|point| point.x_units());
            prop_assert!((bounds.top, bounds.bottom) == (top, bottom));
            prop_assert!(left <= bounds.left && bounds.right <= right, "{bounds:?} in {left} {right}");
        }
    }

    #[test]
    fn pictures_show_what_is_drawn_without_them(
        before in proptest::collection::vec(polygons(), 1..6),
        after in proptest::collection::vec(polygons(), 1..6),
    ) {
        let row_memory = RefCell::new([0; WIDTH + 1]);
        let prepare = |shapes: &[(Vec<SubPoint<Sub8>>, FillRule, Rgb565)]| -> Vec<(Polygon, Rgb565)> {
            shapes.iter().map(|(corners, rule, color)| (prepared(corners, *rule), *color)).collect()
        };
        let (before, after) = (prepare(&before), prepare(&after));
        let all: Vec<(Polygon, Rgb565)> = before.iter().chain(&after).cloned().collect();
        let items: Vec<_> = all
            .iter()
            .map(|(polygon, color)| AntialiasedItem::new(polygon, AnyCoverage::InsideArea, *color, &row_memory, WIDTH).unwrap())
            .collect();
        let drawn = |shown: &[usize]| words(AREA, |band| {
            let Ok(()) = AREA.into_styled(PrimitiveStyle::with_fill(Rgb565::CSS_DARK_GREEN)).draw_on(band);
            for &index in shown {
                all[index].0.draw(&InsideArea, all[index].1, band, &mut [0; WIDTH + 1]).unwrap();
            }
        });

        let (mut slots, mut buckets, mut areas) = ([PictureSlot::EMPTY; 8], [0; 40], [Window::EMPTY; 8]);
        let mut picture = Picture::new(AREA, &mut slots, &mut [], &mut buckets).with_damage(&mut areas, (1, 1));
        picture.add(&AREA.into_styled(PrimitiveStyle::with_fill(Rgb565::CSS_DARK_GREEN))).unwrap();
        let mut shown: Vec<usize> = (0..before.len()).collect();
        let ids: Vec<_> = shown.iter().map(|&index| picture.add_item(&items[index]).unwrap()).collect();
        let mut display = vec![0; WIDTH * 40];
        draw_damage(&mut picture, &mut display);
        prop_assert_eq!(&display, &drawn(&shown));
        for number in 0..after.len() {
            let place = number % ids.len();
            shown[place] = before.len() + number;
            picture.replace_item(ids[place], &items[shown[place]]).unwrap();
            draw_damage(&mut picture, &mut display);
            prop_assert_eq!(&display, &drawn(&shown));
        }
    }
}

#[test]
fn a_row_memory_that_is_too_small_is_an_error() {
    let corners = [(0, 0), (2_560, 0), (0, 2_560)].map(|(x, y)| SubPoint::<Sub8>::from_units(x, y).unwrap());
    let polygon = prepared(&corners, FillRule::NonZero);
    let row_memory = RefCell::new([0; WIDTH]);
    let item = AntialiasedItem::new(&polygon, SignedArea, Rgb565::RED, &row_memory, WIDTH);
    let needed = SignedArea::cells(WIDTH);
    assert_eq!(
        item.err(),
        Some(TooSmall {
            table: Table::Cells,
            needed
        })
    );
    let item = AntialiasedItem::new(&polygon, SignedArea, Rgb565::RED, &row_memory, WIDTH - 1).unwrap();
    assert_eq!(
        PictureItem::<Rgb565>::bounds(&item),
        Window {
            left: 0,
            top: 0,
            right: 11,
            bottom: 11
        }
    );
    // A band that is wider than the row memory is drawn in strips.
    let narrow_memory = RefCell::new([0; 8]);
    let in_strips = AntialiasedItem::new(&polygon, SignedArea, Rgb565::RED, &narrow_memory, 7).unwrap();
    let whole = words(AREA, |band| {
        let mut row_memory = [0; WIDTH + 1];
        polygon.draw(&SignedArea, Rgb565::RED, band, &mut row_memory).unwrap();
    });
    assert_eq!(words(AREA, |band| in_strips.draw(band)), whole);
    assert_eq!(words(AREA, |band| item.draw(band)), whole);
}
