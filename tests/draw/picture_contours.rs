//! Polygons, paths and polylines of a picture, each as a case that could go wrong by itself: edges that cross each other, level ones,
//! many contours, corners far away, and pools of every size.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use zrow::{
    draw::{FillRule, Polygon},
    geometry::{InputError, TooSmall, Window},
};

use crate::{
    contour_items::{ContourItem, STAR},
    picture_display::{Display, in_bands},
    picture_items::{AREA, Item, Prepared, Slot, Style, replayed, with_picture},
};

fn filled(contours: Vec<Vec<Point>>, rule: FillRule) -> ContourItem {
    ContourItem {
        contours,
        precision: 0,
        rule,
        style: Style::with_fill(Rgb565::RED),
    }
}

/// What a polygon shows without a picture.
fn shown(area: Rectangle, polygon: &ContourItem) -> Vec<u16> {
    replayed(area, [&Item::Contours(polygon.clone())])
}

fn at(corners: &[(i32, i32)]) -> Vec<Point> {
    corners.iter().map(|&corner| corner.into()).collect()
}

/// Draws an item in bands of a row from the top and from each row on, in both fill rules and all precisions.
fn check(contours: &[Vec<Point>]) {
    for (rule, precision) in [FillRule::EvenOdd, FillRule::NonZero]
        .into_iter()
        .flat_map(|rule| (0..4).map(move |precision| (rule, precision)))
    {
        let item = ContourItem {
            precision,
            ..filled(contours.to_vec(), rule)
        };
        with_picture(47, |picture| {
            item.add(picture).unwrap();
            for first in 0..AREA.size.height {
                let top_left = AREA.top_left + Point::new(0, first as i32);
                let area = Rectangle::new(top_left, AREA.size - Size::new(0, first));
                assert_eq!(
                    in_bands(picture, area, &[1]),
                    shown(area, &item),
                    "{item:?} from {first}"
                );
            }
        });
    }
}

#[test]
fn stars_cross_themselves_in_any_row() {
    for step in 2..7 {
        let star = (0..13).map(|corner| {
            let angle = f64::from(corner * step) * core::f64::consts::TAU / 13.0;
            Point::new((25.0 + 28.0 * angle.cos()) as i32, (28.0 + 24.0 * angle.sin()) as i32)
        });
        check(&[star.collect()]);
    }
}

/// Level edges in chains, between chains and alone, and edges of a single row.
#[test]
fn steps_and_combs_have_level_edges() {
    let steps = at(&[(2, 8), (9, 8), (9, 15), (20, 15), (20, 16), (33, 16), (33, 40), (2, 40)]);
    let comb: Vec<Point> = (0..12)
        .flat_map(|tooth| [Point::new(4 * tooth, 10 + tooth % 3), Point::new(4 * tooth + 2, 30)])
        .chain([Point::new(48, 45), Point::new(0, 45)])
        .collect();
    check(std::slice::from_ref(&steps));
    check(std::slice::from_ref(&comb));
    check(&[steps, comb, at(&[(3, 20), (40, 20)]), at(&[(5, 5)]), vec![]]);
}

/// More chains than are told apart when they are written.
#[test]
fn a_field_of_50_squares_has_room_for_its_edges() {
    let squares: Vec<Vec<Point>> = (0..50)
        .map(|index| {
            let corner = Point::new(index % 10 * 6, 6 + index / 10 * 9);
            let beside = [(0, 0), (4, 1), (5, 6), (1, 5)];
            beside.map(|offset| corner + Point::from(offset)).to_vec()
        })
        .collect();
    check(&squares);
}

#[test]
fn corners_far_away_are_kept_exactly() {
    for far in [130, 33_000, 70_000, 1 << 24, i32::MAX] {
        check(&[at(&[(-far, 3), (far, 20), (5, 44), (-far, 30)])]);
        check(&[at(&[(10, -far), (30, far), (20, far - 7), (0, -far + 1)])]);
        check(&[at(&[(far, far), (0, far), (far, 0)])]);
    }
}

/// A chain takes a word and one for each of its corners, or two where a corner is far away; an active edge takes seven.
#[test]
fn words_of_a_polygon() {
    let square = at(&[(2, 8), (30, 8), (30, 40), (2, 40)]);
    let far = at(&[(2, 8), (40_000, 8), (30, 40), (2, 40)]);
    let star = at(&STAR);
    // Up to the first corner, down on the right, and up on the left as far as where the first chain begins.
    let of_star = 3 + (1 + 2) + (1 + 6) + (1 + 5) + 2 * 7;
    for (corners, words) in [(square, 3 + 2 * 3 + 2 * 7), (far, 3 + 2 * 5 + 2 * 7), (star, of_star)] {
        with_picture(47, |picture| {
            filled(vec![corners], FillRule::NonZero).add(picture).unwrap();
            assert_eq!(picture.words_used(), words);
        });
    }
}

/// What a pool lacks is named exactly, and the picture is as it was.
#[test]
fn a_pool_too_small_says_how_many_words_are_needed() {
    let star = at(&[(20, 8), (40, 45), (0, 20), (45, 20), (4, 45)]);
    let item = filled(vec![star], FillRule::EvenOdd);
    let needed = with_picture(47, |picture| {
        item.add(picture).unwrap();
        picture.words_used()
    });
    let before = filled(vec![at(&[(0, 10), (9, 10), (9, 30)])], FillRule::NonZero);
    for missing in 1..needed {
        let (mut slots, mut buckets) = ([Slot::EMPTY; 2], [0; 47]);
        let mut pool = vec![0; 17 + 6 + needed - missing];
        let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets);
        let id = before.add(&mut picture).unwrap();
        let first = picture.words_used();
        let full = |needed| Err(InputError::TooSmall(TooSmall::PictureWords(needed)));
        let is_full = first + needed > 17 + 6 + needed - missing;
        if is_full {
            assert_eq!(item.add(&mut picture).map(drop), full(first + needed));
            assert_eq!((picture.slots_used(), picture.words_used()), (1, first));
        }
        if needed > 17 + 6 + needed - missing {
            assert_eq!(item.replace(&mut picture, id), full(needed));
        }
        if is_full {
            assert_eq!(in_bands(&mut picture, AREA, &[1]), shown(AREA, &before));
        }
    }
}

/// A hand of a clock that turns sends what it leaves and what it takes, not the box around both; what is put in its own place sends
/// nothing once it was drawn.
#[test]
fn a_hand_that_turns_changes_few_pixels() {
    let area = Rectangle::new(Point::zero(), Size::new(240, 240));
    let hand = |degrees: i32| {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let along = |length: f64, aside: f64| {
            let (x, y) = (length * cosine - aside * sine, length * sine + aside * cosine);
            Point::new(120 + x.round() as i32, 120 + y.round() as i32)
        };
        vec![along(-20.0, 0.0), along(0.0, 6.0), along(105.0, 0.0), along(0.0, -6.0)]
    };
    let (mut slots, mut pool, mut buckets, mut areas) = ([Slot::EMPTY; 1], [0; 200], [0; 240], [Window::EMPTY; 16]);
    let mut picture = Prepared::new(area, &mut slots, &mut pool, &mut buckets).with_damage(&mut areas, (1, 1));
    let id = filled(vec![hand(0)], FillRule::NonZero).add(&mut picture).unwrap();
    let mut display = Display::new(area);
    display.draw_damage(&mut picture, &[1]);
    for degrees in (6..=360).step_by(6) {
        let item = filled(vec![hand(degrees)], FillRule::NonZero);
        item.replace(&mut picture, id).unwrap();
        let mut changed = 0;
        let mut words = display.words.clone();
        while let Some(damage) = picture.next_damage() {
            changed += damage.size.width * damage.size.height;
            let drawn = in_bands(&mut picture, damage, &[1]);
            for (point, word) in damage.points().zip(drawn) {
                words[point.y as usize * 240 + point.x as usize] = word;
            }
        }
        assert_eq!(words, shown(area, &item), "{degrees}");
        display.words = words;
        assert!(changed <= 6_500, "{changed} at {degrees}");
        in_bands(&mut picture, area, &[1]);
        item.replace(&mut picture, id).unwrap();
        assert_eq!(picture.next_damage(), None, "{degrees}");
    }
}

/// The copy lives on when the contours are gone.
#[test]
fn the_shape_may_be_dropped() {
    let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 1], [0; 40], [0; 47]);
    let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets);
    let corners = at(&[(2, 8), (30, 8), (30, 40), (2, 40)]);
    let expected = shown(AREA, &filled(vec![corners.clone()], FillRule::NonZero));
    {
        let contours = [corners.as_slice()];
        let polygon = Polygon::new(&contours, FillRule::NonZero);
        picture
            .add(&polygon.into_styled(Style::with_fill(Rgb565::RED)))
            .unwrap();
    }
    drop(corners);
    assert_eq!(in_bands(&mut picture, AREA, &[1]), expected);
}

/// A picture draws rows up to 32,766. Chains that begin in the row after it are entered with that row, though it is never drawn.
#[test]
fn chains_begin_below_the_last_row_that_is_drawn() {
    let area = Rectangle::new(Point::new(0, 32_760), Size::new(61, 12));
    let upper = at(&[(2, 32_740), (50, 32_750), (20, 32_766)]);
    let lower = |row| at(&[(5, row), (40, row + 9), (9, i32::MAX)]);
    for row in [32_766, 32_767, 32_768, 70_000] {
        let contours = vec![lower(row), lower(row), lower(row + 1), upper.clone()];
        let item = filled(contours, FillRule::NonZero);
        let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 1], [0; 120], [0; 12]);
        let mut picture = Prepared::new(area, &mut slots, &mut pool, &mut buckets);
        item.add(&mut picture).unwrap();
        let drawn = Rectangle::new(area.top_left, Size::new(61, 7));
        let expected = shown(drawn, &item);
        for _ in 0..3 {
            assert_eq!(in_bands(&mut picture, area, &[1])[..61 * 7], expected, "{row}");
        }
    }
}
