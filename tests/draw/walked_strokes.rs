//! Strokes of polygons, paths and polylines by copy, which go on from row to row, against the same strokes drawn anew.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Polyline, Rectangle, StrokeAlignment},
};
use proptest::prelude::*;
use zrow::{
    band::{Band, BigEndian},
    draw::{DrawOn, FillRule, ItemId, Picture, PictureSlot, Polygon},
    geometry::{InputError, TooSmall, Window},
};

use crate::{
    common::{cases, config, is_quick},
    contour_items::{ContourItem, Fine, STAR, contour_items, path_items},
    picture_display::{Display, in_bands},
    picture_items::{AREA, Item, Prepared, Slot, Style, replayed},
};

/// Memory for one item, whatever it is.
pub fn with_picture<'a, R>(area: Rectangle, test: impl FnOnce(&mut Prepared<'_, 'a>) -> R) -> R {
    let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 1], vec![0; 60_000], vec![0; area.size.height as usize]);
    test(&mut Prepared::new(area, &mut slots, &mut pool, &mut buckets))
}

/// Adds an item to pictures with pools of every size up to enough for it: each is enough, or an error says what is.
pub fn check_pools(area: Rectangle, add: impl Fn(&mut Prepared<'_, '_>) -> Result<ItemId, InputError>) {
    let needed = with_picture(area, |picture| {
        add(picture).unwrap();
        picture.words_used()
    });
    for size in 0..needed + 2 {
        let (mut slots, mut pool) = ([Slot::EMPTY; 1], vec![0; size]);
        let mut picture = Prepared::new(area, &mut slots, &mut pool, &mut []);
        match add(&mut picture) {
            Ok(_) => assert!(needed <= size),
            Err(error) => {
                assert_eq!(error, InputError::TooSmall(TooSmall::PictureWords(needed)), "{size}");
                assert_eq!((picture.words_used(), picture.slots_used()), (0, 0));
            }
        }
    }
}

/// Rows of an area as bands: in order, from the last one up, and in leaps.
pub fn check_rows(picture: &mut Prepared<'_, '_>, area: Rectangle, expected: &[u16]) {
    for heights in [[1], [2], [7]] {
        assert!(in_bands(picture, area, &heights) == expected, "{heights:?}");
    }
    let rows = area.size.height as usize;
    for (height, step) in [
        (1, rows - 1),
        (2, rows - 2),
        (7, rows - 7),
        (1, 17),
        (2, 29),
        (7, 11),
        (3, 4),
    ] {
        let mut row = 0;
        for _ in 0..rows {
            row = (row + step) % rows;
            let height = height.min(rows - row);
            let top_left = area.top_left + Point::new(0, row as i32);
            let band = Rectangle::new(top_left, Size::new(area.size.width, height as u32));
            let width = area.size.width as usize;
            let shown = &expected[row * width..(row + height) * width];
            assert_eq!(in_bands(picture, band, &[1_000]), shown, "{height} rows from {row}");
        }
    }
}

fn check(item: &Item) {
    let expected = replayed(AREA, [item]);
    with_picture(AREA, |picture| {
        item.add(picture).unwrap();
        check_rows(picture, AREA, &expected);
    });
}

fn at(corners: &[(i32, i32)]) -> Vec<Point> {
    corners.iter().map(|&corner| corner.into()).collect()
}

fn stroke(width: u32) -> Style {
    Style::with_stroke(Rgb565::RED, width)
}

fn over_fill(width: u32) -> Style {
    let mut style = stroke(width);
    style.fill_color = Some(Rgb565::BLUE);
    style
}

fn aside(alignment: StrokeAlignment, mut style: Style) -> Style {
    style.stroke_alignment = alignment;
    style
}

fn styles() -> impl Strategy<Value = Style> + Clone {
    use StrokeAlignment::{Center, Inside, Outside};
    let alignments = prop_oneof![3 => Just(Center), 1 => Just(Inside), 1 => Just(Outside)];
    let widths = prop_oneof![6 => Just(1), 6 => 2..9u32, 2 => 9..60u32, 1 => 4_000..9_000u32];
    (any::<bool>(), widths, alignments).prop_map(|(is_filled, width, alignment)| {
        let mut style = if is_filled { over_fill(width) } else { stroke(width) };
        style.stroke_alignment = alignment;
        style
    })
}

/// Vertices that often are the ones before them, or one of few others, so that segments have no length, return, or are level.
pub fn vertices() -> impl Strategy<Value = Point> + Clone {
    let crossing = (-30..90, -20..80).prop_map(Point::from);
    let few = (0..3, 0..3).prop_map(|(x, y)| Point::new(20 * x, 10 + 15 * y));
    let far = (-40_000..40_000, -40_000..40_000).prop_map(Point::from);
    let limit = (-2..3, -2..3).prop_map(|(x, y)| Point::new(8_192 * x, 8_192 * y));
    let any = (any::<i32>(), any::<i32>()).prop_map(Point::from);
    prop_oneof![9 => crossing, 9 => few, 2 => far, 1 => limit, 1 => any]
}

proptest! {
    #![proptest_config(config(cases(75, 1_500)))]

    #[test]
    fn strokes_of_polygons_are_those_that_are_drawn_anew(contours in contour_items(vertices(), styles())) {
        check(&Item::Contours(contours));
    }

    #[test]
    fn strokes_of_paths_are_those_that_are_drawn_anew(path in path_items(vertices(), styles())) {
        check(&Item::Path(path));
    }

    #[test]
    fn strokes_of_polylines_are_those_that_are_drawn_anew(
        vertices in proptest::collection::vec(vertices(), 0..14),
        offset in prop_oneof![4 => Just(Point::zero()), 1 => vertices()],
        style in styles(),
    ) {
        let polyline = Polyline::new(&vertices).translate(offset).into_styled(style);
        let mut expected = vec![0; (AREA.size.width * AREA.size.height) as usize];
        let Ok(()) = polyline.draw_on(&mut Band::<Rgb565>::new(AREA, &mut expected).unwrap());
        with_picture(AREA, |picture| {
            picture.add(&polyline).unwrap();
            check_rows(picture, AREA, &expected);
        });
        // The colour in the other order of bytes.
        let (mut slots, mut pool) = ([PictureSlot::EMPTY; 1], vec![0; 60_000]);
        let mut picture = Picture::<Rgb565, BigEndian>::new(AREA, &mut slots, &mut pool, &mut []);
        picture.add(&polyline).unwrap();
        let mut words = vec![0; expected.len()];
        picture.draw(&mut Band::new(AREA, &mut words).unwrap());
        let swapped: Vec<_> = expected.iter().map(|word| word.swap_bytes()).collect();
        prop_assert_eq!(words, swapped);
    }

    /// Turns so small that the tip of a miter lies between the sides that it joins, where it is rounded.
    #[test]
    fn nearly_straight_paths_have_the_same_joins(
        steps in proptest::collection::vec((-3..4i32, -3..4i32, 1..9i32), 2..9),
        width in 1..9u32,
        is_level in any::<bool>(),
    ) {
        let area = Rectangle::new(Point::new(-10, -12), Size::new(70, 24));
        let (mut length, mut aside) = (-20 * 65_536, 0);
        let vertices: Vec<Fine> = steps.iter().map(|&(to_side, rest, pixels)| {
            length += pixels * 65_536 + if rest == 3 { 1 } else { 0 };
            aside += to_side;
            if is_level { Fine(length, aside) } else { Fine(aside, length) }
        }).collect();
        let contours = [vertices.as_slice()];
        let polygon = Polygon::new(&contours, FillRule::NonZero);
        let prepared = polygon.prepare::<32, 32>().unwrap();
        let mut expected = vec![0; (area.size.width * area.size.height) as usize];
        let Ok(()) = prepared.into_styled(stroke(width)).draw_on(&mut Band::<Rgb565>::new(area, &mut expected).unwrap());
        with_picture(area, |picture| {
            picture.add(&polygon.into_styled(stroke(width))).unwrap();
            check_rows(picture, area, &expected);
        });
    }
}

fn polygon(contours: &[&[(i32, i32)]], style: Style) -> ContourItem {
    ContourItem {
        contours: contours.iter().map(|corners| at(corners)).collect(),
        precision: 0,
        rule: FillRule::NonZero,
        style,
    }
}

/// Checks a polyline in several widths and places against the same one that is drawn into a band.
fn check_polyline(vertices: &[Point], offset: Point) {
    for width in [1, 2, 3, 8, 40] {
        let polyline = Polyline::new(vertices).translate(offset).into_styled(stroke(width));
        let mut expected = vec![0; (AREA.size.width * AREA.size.height) as usize];
        let Ok(()) = polyline.draw_on(&mut Band::<Rgb565>::new(AREA, &mut expected).unwrap());
        with_picture(AREA, |picture| {
            picture.add(&polyline).unwrap();
            check_rows(picture, AREA, &expected);
        });
    }
}

#[test]
fn polylines_of_many_vertices() {
    let many = if is_quick() { 70 } else { cases(100, 300) as i32 };
    let zigzag = |index: i32| (index % 61, index * index * 7 % 83 - 12);
    let level = |index: i32| (index * 37 % 71 - 10, 21);
    let twice = |index: i32| zigzag(index / 2 * 2);
    let off_screen = |index: i32| match index % 4 {
        0 => (index % 60, -50 - index),
        1 => (index * 7 % 60, 30),
        2 => (-200, index % 50),
        _ => (index % 50, 900 + index),
    };
    let extreme = |index: i32| match index % 5 {
        0 => (i32::MIN + index, i32::MIN),
        1 => (index % 60, index * 11 % 50),
        2 => (i32::MAX, 20 - index),
        3 => (index % 40, i32::MAX - index),
        _ => (20_000 - 7 * index, 30),
    };
    let all: [&dyn Fn(i32) -> (i32, i32); 5] = [&zigzag, &level, &twice, &off_screen, &extreme];
    for corner in all {
        let vertices: Vec<_> = (0..many).map(corner).map(Point::from).collect();
        check_polyline(&vertices, Point::zero());
        check_polyline(&vertices, Point::new(-7, 5));
    }
    // What an offset moves beyond the number range, and back.
    let far: Vec<_> = (0..many)
        .map(|index| Point::from(zigzag(index)) + Point::new(0, i32::MAX - 100))
        .collect();
    check_polyline(&far, Point::new(0, 100 - i32::MAX));
    check_polyline(&far, Point::new(0, i32::MAX));
}

/// A polyline of which parts are outside of the picture is moved in steps, between rows and far away and back again.
#[test]
fn a_polyline_of_many_vertices_is_moved() {
    let vertices: Vec<_> = (0..120)
        .map(|index| Point::new(index % 61, index * index * 7 % 183 - 60))
        .collect();
    for width in [1, 3, 9] {
        with_picture(AREA, |picture| {
            let polyline = Polyline::new(&vertices).into_styled(stroke(width));
            let id = picture.add(&polyline).unwrap();
            let mut offset = Point::zero();
            for by in [(0, 17), (3, -40), (0, 32_500), (0, -32_480), (0, -32_500), (-5, 32_520)] {
                let by = Point::from(by);
                in_bands(
                    picture,
                    Rectangle::new(AREA.top_left, Size::new(AREA.size.width, 19)),
                    &[1],
                );
                picture.translate(id, by).unwrap();
                offset += by;
                let moved = Polyline::new(&vertices).translate(offset).into_styled(stroke(width));
                let mut expected = vec![0; (AREA.size.width * AREA.size.height) as usize];
                let Ok(()) = moved.draw_on(&mut Band::<Rgb565>::new(AREA, &mut expected).unwrap());
                check_rows(picture, AREA, &expected);
            }
        });
    }
}

#[test]
fn dots_spikes_and_returns() {
    let degenerate: [&[(i32, i32)]; 7] = [
        &[],
        &[(20, 20)],
        &[(20, 20), (20, 20), (20, 20)],
        &[(10, 20), (40, 30)],
        &[(10, 20), (10, 20), (40, 30), (40, 30), (10, 20)],
        &[(10, 10), (50, 12), (10, 14), (50, 16)],
        &[(10, 25), (50, 25), (30, 25), (30, 10), (30, 45)],
    ];
    for width in 1..30 {
        for contour in degenerate {
            check(&Item::Contours(polygon(&[contour], stroke(width))));
        }
        check(&Item::Contours(polygon(&degenerate, stroke(width))));
    }
}

/// Eight bytes a vertex, 4 for each segment and each corner, and 76 for each rectangle and each join of the row with the most
/// of them, here 4 of 5 corners.
#[test]
fn words_of_a_stroke() {
    let square = [(10, 10), (40, 10), (40, 40), (10, 40)];
    for (corners, polygons) in [(square.as_slice(), 5), (&STAR, 10)] {
        with_picture(AREA, |picture| {
            polygon(&[corners], stroke(3)).add(picture).unwrap();
            let of_vertices = 5 + 2 + 1 + (2 + 2) * corners.len();
            assert_eq!(picture.words_used(), of_vertices + 19 * polygons);
        });
    }
}

/// A word for each contour, and one more word where the stroke lies over a fill or on one side.
#[test]
fn words_of_a_stroke_of_several_contours() {
    let square = [(10, 10), (40, 10), (40, 40), (10, 40)];
    let words = |contours: usize, style| {
        with_picture(AREA, |picture| {
            polygon(&vec![square.as_slice(); contours], style).add(picture).unwrap();
            picture.words_used()
        })
    };
    for contours in 1..5 {
        let corners = square.len() * contours;
        let alone = 7 + contours + (2 + 2) * corners + 19 * 5 * contours;
        assert_eq!(words(contours, stroke(3)), alone);
        let fill = words(contours, Style::with_fill(Rgb565::BLUE));
        assert_eq!(words(contours, over_fill(3)), 1 + alone + fill);
    }
}

/// A stroke inside or outside takes what a centred one of twice the width does, and what the fill does.
#[test]
fn words_of_a_stroke_aside() {
    let square = [(10, 10), (40, 10), (40, 40), (10, 40)];
    let words = |style| {
        with_picture(AREA, |picture| {
            polygon(&[&square], style).add(picture).unwrap();
            picture.words_used()
        })
    };
    let fill = words(Style::with_fill(Rgb565::BLUE));
    for alignment in [StrokeAlignment::Inside, StrokeAlignment::Outside] {
        for style in [stroke(3), over_fill(3)] {
            assert_eq!(words(aside(alignment, style)), 1 + words(stroke(6)) + fill);
        }
    }
}

/// From no memory to enough, each size is enough or an error with the words that are needed, and the picture stays as it was.
#[test]
fn pools_of_every_size() {
    use StrokeAlignment::{Center, Inside, Outside};
    let alignments = [Center, Inside, Outside];
    let styles = alignments.map(|alignment| aside(alignment, over_fill(4)));
    for style in styles {
        let star: Vec<_> = STAR.iter().map(|(x, y)| (x / 4, y / 4)).collect();
        check_pools(AREA, |picture| polygon(&[&star], style).add(picture));
    }
}

/// A stroke of one pixel's width takes 8 bytes a vertex, and 16 for each segment of the row with the most of them; for none where a segment
/// is longer than 16 bits tell.
#[test]
fn words_of_a_thin_stroke() {
    let zigzag = [(0, 10), (10, 40), (20, 10), (30, 40), (40, 20)];
    let far = [(0, 10), (40_000, 20)];
    for (corners, segments) in [(zigzag.as_slice(), 4), (&far, 0)] {
        with_picture(AREA, |picture| {
            picture
                .add(&Polyline::new(&at(corners)).into_styled(stroke(1)))
                .unwrap();
            assert_eq!(picture.words_used(), 3 + 2 + 1 + 2 * corners.len() + 4 * segments);
        });
    }
}

/// A stroke that is drawn to its end and put in its own place sends nothing.
#[test]
fn the_same_stroke_again_changes_nothing() {
    let area = Rectangle::new(Point::zero(), Size::new(200, 200));
    let (mut slots, mut pool, mut buckets, mut areas) = ([Slot::EMPTY; 2], [0; 1_200], [0; 200], [Window::EMPTY; 4]);
    let mut picture = Prepared::new(area, &mut slots, &mut pool, &mut buckets).with_damage(&mut areas, (1, 1));
    let (inside, outside) = (StrokeAlignment::Inside, StrokeAlignment::Outside);
    let styles = [
        stroke(3),
        stroke(8),
        over_fill(5),
        aside(inside, stroke(4)),
        aside(outside, over_fill(6)),
    ];
    for style in styles {
        picture.clear();
        let star = polygon(&[&STAR], style);
        let id = star.add(&mut picture).unwrap();
        let zigzag = at(&STAR);
        let thin = Polyline::new(&zigzag).into_styled(stroke(1));
        let of_thin = picture.add(&thin).unwrap();
        let mut display = Display::new(area);
        display.draw_damage(&mut picture, &[1]);
        in_bands(&mut picture, area, &[1]);
        star.replace(&mut picture, id).unwrap();
        picture.replace(of_thin, &thin).unwrap();
        assert_eq!(picture.next_damage(), None);
    }
}

#[test]
fn a_stroke_that_is_moved_between_two_rows_is_where_it_was_moved_to() {
    let area = Rectangle::new(Point::zero(), Size::new(220, 220));
    let moved: Vec<_> = STAR.iter().map(|&(x, y)| (x + 9, y + 17)).collect();
    let (inside, outside) = (StrokeAlignment::Inside, StrokeAlignment::Outside);
    for style in [
        stroke(4),
        over_fill(5),
        aside(inside, over_fill(4)),
        aside(outside, stroke(3)),
    ] {
        let expected = replayed(area, [&Item::Contours(polygon(&[&moved], style))]);
        with_picture(area, |picture| {
            let id = polygon(&[&STAR], style).add(picture).unwrap();
            in_bands(picture, Rectangle::new(area.top_left, Size::new(220, 71)), &[1]);
            picture.translate(id, Point::new(9, 17)).unwrap();
            check_rows(picture, area, &expected);
        });
    }
}
