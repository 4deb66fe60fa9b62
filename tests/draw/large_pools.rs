//! Pictures whose pool has more than 65,536 words: the words of an item begin within the first 65,536, and may end behind them.

use embedded_graphics::{
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Circle, Polyline, PrimitiveStyleBuilder, Rectangle, Triangle},
};
use zrow::{
    draw::{AntialiasingMemory, Picture, PictureSlot, PrimitiveStyle},
    geometry::{InputError, TooSmall, Window},
};

use crate::picture_display::{Display, in_bands};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(40, 30));

/// The words that a filled triangle takes.
const TRIANGLE_WORDS: usize = 9;

/// As many triangles as leave the next item the last of the first 65,536 words but a few.
const TRIANGLES: usize = 65_535 / TRIANGLE_WORDS;

type Slot<'a> = PictureSlot<'a, Rgb565>;

/// Adds triangles that lie above the area.
fn add_triangles(picture: &mut Picture<'_, '_, Rgb565>) {
    let triangle = Triangle::new(Point::new(0, -9), Point::new(9, -20), Point::new(20, -5));
    let triangle = triangle.into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
    for _ in 0..TRIANGLES {
        picture.add(&triangle).unwrap();
    }
    assert_eq!(picture.words_used(), TRIANGLES * TRIANGLE_WORDS);
}

/// Items without words are added, put in the place of others and taken out, however many words are taken; only what has words
/// finds no room behind the first 65,536.
#[test]
fn items_without_words_need_no_room() {
    let (mut slots, mut pool) = (vec![Slot::EMPTY; TRIANGLES + 4], vec![0; 80_000]);
    let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut []);
    let shown = Triangle::new(Point::new(0, 0), Point::new(9, 0), Point::new(0, 9));
    let shown = shown.into_styled(PrimitiveStyle::with_fill(Rgb565::BLUE));
    let panel =
        |x| Rectangle::new(Point::new(x, 20), Size::new(5, 5)).into_styled(PrimitiveStyle::with_fill(Rgb565::GREEN));
    let vertices: Vec<Point> = (0..4_700).map(|y| Point::new(30, y)).collect();
    let line = Polyline::new(&vertices).into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1));

    let [first, second] = [(); 2].map(|()| picture.add(&shown).unwrap());
    for _ in 2..TRIANGLES {
        picture.add(&shown.translate(Point::new(0, -50))).unwrap();
    }
    picture.add(&line).unwrap();
    let used = picture.words_used();
    assert!((70_000..80_000).contains(&used), "{used}");
    let pixels = |picture: &mut Picture<'_, '_, Rgb565>| {
        let words = in_bands(picture, AREA, &[1, 4]);
        [(1, 1), (22, 22), (12, 22), (30, 15)].map(|(x, y)| words[y * 40 + x])
    };
    let [blue, green, white] = [Rgb565::BLUE, Rgb565::GREEN, Rgb565::WHITE].map(IntoStorage::into_storage);
    assert_eq!(pixels(&mut picture), [blue, 0, 0, white]);

    // A triangle would begin behind the last word that an item can begin at.
    let added = picture.add(&shown);
    assert!(
        matches!(added, Err(InputError::TooSmall(TooSmall::PictureWords(_)))),
        "{added:?}"
    );
    picture.add(&panel(20)).unwrap();
    assert_eq!(pixels(&mut picture), [blue, green, 0, white]);

    picture.replace(second, &panel(10)).unwrap();
    assert_eq!(picture.words_used(), used - TRIANGLE_WORDS);
    assert_eq!(pixels(&mut picture), [blue, green, green, white]);

    picture.remove(first);
    assert_eq!(picture.words_used(), used - 2 * TRIANGLE_WORDS);
    assert_eq!(pixels(&mut picture), [0, green, green, white]);
}

/// The words of a fill begin within the first 65,536, and those of its stroke behind them.
#[test]
fn layers_may_lie_behind_the_words_that_items_begin_at() {
    let style = PrimitiveStyleBuilder::new()
        .fill_color(Rgb565::RED)
        .stroke_color(Rgb565::YELLOW)
        .stroke_width(3);
    let style = PrimitiveStyle::from(style.build()).antialiased();
    let disc = |x| Circle::new(Point::new(x, 3), 21).into_styled(style);
    let shown_by = |triangles: bool, x: i32| {
        let (mut slots, mut pool, mut buckets) = (vec![Slot::EMPTY; TRIANGLES + 1], vec![0; 70_000], [0; 30]);
        let (mut areas, mut memory) = ([Window::EMPTY; 8], AntialiasingMemory::<41, 64, 8>::new());
        let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets)
            .with_antialiasing(&mut memory)
            .with_damage(&mut areas, (1, 1));
        if triangles {
            add_triangles(&mut picture);
        }
        let id = picture.add(&disc(5)).unwrap();
        let mut display = Display::new(AREA);
        display.draw_damage(&mut picture, &[1]);
        picture.translate(id, Point::new(x - 5, 0)).unwrap();
        display.draw_damage(&mut picture, &[1, 3]);
        assert_eq!(in_bands(&mut picture, AREA, &[2]), display.words);
        display.words
    };
    for x in [5, 11] {
        assert_eq!(shown_by(true, x), shown_by(false, x));
    }
}
