//! Lines of two pixels and more by copy, which go on from row to row, against the same lines drawn anew.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Line, Rectangle, Styled},
};
use proptest::prelude::*;
use zrow::{band::Band, draw::DrawOn, geometry::Window};

use crate::{
    common::{cases, config},
    picture_display::{Display, in_bands},
    picture_items::{AREA, Prepared, Slot, Style},
    walked_strokes::{check_pools, check_rows, vertices, with_picture},
};

fn wide(start: Point, end: Point, width: u32) -> Styled<Line, Style> {
    Line::new(start, end).into_styled(Style::with_stroke(Rgb565::RED, width))
}

fn anew(line: &Styled<Line, Style>) -> Vec<u16> {
    let mut words = vec![0; (AREA.size.width * AREA.size.height) as usize];
    let Ok(()) = line.draw_on(&mut Band::<Rgb565>::new(AREA, &mut words).unwrap());
    words
}

/// Ends as for polylines, also just within and beyond what is stepped through.
fn ends() -> impl Strategy<Value = Point> + Clone {
    let limit = (-2..3, -2..3, 0..2).prop_map(|(x, y, less)| Point::new(16_384 * x - less, 16_384 * y - less));
    prop_oneof![9 => vertices(), 1 => limit]
}

fn widths() -> impl Strategy<Value = u32> + Clone {
    prop_oneof![6 => 2..9u32, 2 => 9..60u32, 1 => 4_000..9_000u32, 1 => any::<u32>().prop_map(|width| width.max(2))]
}

proptest! {
    #![proptest_config(config(cases(300, 10_000)))]

    #[test]
    fn lines_are_those_that_are_drawn_anew(start in ends(), end in ends(), width in widths()) {
        let line = wide(start, end, width);
        with_picture(AREA, |picture| {
            picture.add(&line).unwrap();
            check_rows(picture, AREA, &anew(&line));
        });
    }

    /// Moved after some rows were drawn.
    #[test]
    fn moved_lines_are_those_that_are_drawn_anew(
        start in ends(),
        end in ends(),
        width in widths(),
        by in prop_oneof![4 => (-60..60, -60..60), 1 => (-30_000..30_000, -30_000..30_000)].prop_map(Point::from),
        rows in 1..60u32,
    ) {
        let line = wide(start, end, width);
        with_picture(AREA, |picture| {
            let id = picture.add(&line).unwrap();
            in_bands(picture, Rectangle::new(AREA.top_left, Size::new(AREA.size.width, rows)), &[1]);
            if picture.translate(id, by).is_ok() {
                let moved = wide(start + by, end + by, width);
                assert!(in_bands(picture, AREA, &[1]) == anew(&moved), "by {by}");
                assert!(in_bands(picture, AREA, &[7]) == anew(&moved), "by {by}");
            }
        });
    }
}

/// A line that is drawn to its end and put in its own place sends nothing, and one that is replaced is drawn.
#[test]
fn the_same_line_again_changes_nothing() {
    let area = Rectangle::new(Point::zero(), Size::new(200, 200));
    let (mut slots, mut pool, mut buckets, mut areas) = ([Slot::EMPTY; 1], [0; 20], [0; 200], [Window::EMPTY; 4]);
    let mut picture = Prepared::new(area, &mut slots, &mut pool, &mut buckets).with_damage(&mut areas, (1, 1));
    let ends = [(10, 10), (150, 10), (10, 160), (140, 190), (199, 20)].map(Point::from);
    for (start, end) in ends.into_iter().flat_map(|start| ends.map(|end| (start, end))) {
        picture.clear();
        let line = wide(start, end, 6);
        let id = picture.add(&line).unwrap();
        assert_eq!(picture.words_used(), 10);
        let mut display = Display::new(area);
        display.draw_damage(&mut picture, &[1]);
        in_bands(&mut picture, area, &[1]);
        picture.replace(id, &line).unwrap();
        assert_eq!(picture.next_damage(), None, "{start} {end}");
        picture.replace(id, &wide(end, start + Point::new(3, 2), 5)).unwrap();
        display.draw_damage(&mut picture, &[1]);
        assert_eq!(display.words, in_bands(&mut picture, area, &[1]), "{start} {end}");
    }
}

#[test]
fn pools_of_every_size() {
    check_pools(AREA, |picture| {
        picture.add(&wide(Point::new(3, 4), Point::new(50, 20), 7))
    });
}
