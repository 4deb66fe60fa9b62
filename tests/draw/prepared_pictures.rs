//! Prepared pictures against the same items drawn one after the other into a whole frame: in bands of any height and
//! order, after changes, and with memory of every size.

use std::{cell::Cell, ops::Range};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::{Band, Target},
    draw::{ItemId, Picture, PictureItem, PictureSlot},
    geometry::{InputError, TooSmall, Window},
};

use crate::{
    common::{cases, config, hostile::any_length},
    picture_display::{Display, in_bands},
    picture_items::{AREA, Item, Prepared, Slot, hostile_items, items, points, replayed, with_picture},
};

proptest! {
    #![proptest_config(config(cases(100, 3_000)))]

    #[test]
    fn bands_of_any_height_show_what_replaying_shows(
        items in proptest::collection::vec(items(), 1..200),
        heights in proptest::collection::vec(1..9u32, 1..4),
        buckets in 0..60usize,
    ) {
        let expected = replayed(AREA, &items);
        with_picture(buckets, |picture| {
            for item in &items {
                item.add(picture).unwrap();
            }
            prop_assert_eq!(&in_bands(picture, AREA, &[1]), &expected);
            // Once more, from the top.
            prop_assert_eq!(&in_bands(picture, AREA, &heights), &expected);
            prop_assert_eq!(&in_bands(picture, AREA, &[1_000]), &expected);
            Ok(())
        })?;
    }

    /// A band of some columns and rows after the other, each where it falls.
    #[test]
    fn bands_in_any_order_show_what_replaying_shows(
        items in proptest::collection::vec(items(), 1..20),
        windows in proptest::collection::vec((points(), 1..30u32, 1..30u32), 1..12),
    ) {
        with_picture(17, |picture| {
            for item in &items {
                item.add(picture).unwrap();
            }
            for (top_left, width, height) in windows {
                let area = Rectangle::new(top_left, Size::new(width, height));
                // What lies outside of 16 bits is not drawn.
                let columns = i32::from(i16::MIN)..i32::from(i16::MAX) - 30;
                if columns.contains(&top_left.x) && columns.contains(&top_left.y) {
                    prop_assert_eq!(in_bands(picture, area, &[1, 3]), replayed(area, &items));
                }
            }
            Ok(())
        })?;
    }

    /// Areas anywhere, of any size, with any number of buckets; items are where they are.
    #[test]
    fn areas_anywhere_show_what_replaying_shows(
        items in proptest::collection::vec(items(), 1..6),
        (x, y) in (prop_oneof![any::<i32>(), i32::MAX - 50..=i32::MAX], prop_oneof![any::<i32>(), i32::MAX - 50..=i32::MAX]),
        (width, height, buckets) in (any_length(), any_length(), 0..50usize),
    ) {
        let far = Rectangle::new(Point::new(x, y), Size::new(width, height));
        let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 6], vec![0; 40_000], vec![0; buckets]);
        let mut picture = Prepared::new(far, &mut slots, &mut pool, &mut buckets);
        for item in &items {
            item.add(&mut picture).unwrap();
        }
        prop_assert_eq!(in_bands(&mut picture, AREA, &[1, 2]), replayed(AREA, &items));
        // As far as there are numbers.
        let start = Window::from(Rectangle::new(far.top_left, Size::new(width.min(4), height.min(12))));
        in_bands(&mut picture, start.to_rectangle(), &[1]);
    }

    /// Numbers of their whole type, in items and in the positions of bands.
    #[test]
    fn hostile_items_show_what_replaying_shows(
        items in proptest::collection::vec(hostile_items(), 1..12),
        (x, y) in (any::<i32>(), any::<i32>()),
        (height, buckets) in (1..5u32, 0..50usize),
    ) {
        with_picture(buckets, |picture| {
            for item in &items {
                item.add(picture).unwrap();
            }
            prop_assert_eq!(in_bands(picture, AREA, &[height]), replayed(AREA, &items));
            // Beyond 16 bits nothing is drawn.
            let far = Rectangle::new(Point::new(x, y), Size::new(5, 5));
            in_bands(picture, far, &[height]);
            Ok(())
        })?;
    }

    #[test]
    fn edited_pictures_show_what_replaying_shows(
        current in proptest::collection::vec(items(), 1..12),
        edits in proptest::collection::vec((any::<prop::sample::Index>(), proptest::option::weighted(0.8, items())), 1..12),
    ) {
        with_picture(47, |picture| {
            let mut shown: Vec<Option<&Item>> = current.iter().map(Some).collect();
            let ids: Vec<ItemId> = current.iter().map(|item| item.add(picture).unwrap()).collect();
            for (index, edit) in &edits {
                let index = index.index(shown.len());
                match edit {
                    Some(item) => item.replace(picture, ids[index]).unwrap(),
                    None => picture.remove(ids[index]),
                }
                shown[index] = edit.as_ref();
                prop_assert_eq!(in_bands(picture, AREA, &[2, 1]), replayed(AREA, shown.iter().copied().flatten()));
            }
            // No word is lost: the same items take as many words in a new picture.
            let used = picture.words_used();
            picture.clear();
            for item in shown.into_iter().flatten() {
                item.add(picture).unwrap();
            }
            prop_assert_eq!(picture.words_used(), used);
            Ok(())
        })?;
    }

    /// A display on which only the damage is drawn again.
    #[test]
    fn what_is_drawn_in_the_damage_is_the_whole_picture(
        current in proptest::collection::vec(items(), 1..12),
        edits in proptest::collection::vec((any::<prop::sample::Index>(), proptest::option::weighted(0.8, items())), 1..12),
        (rectangles, at_once, grid, clears) in (1..9usize, 1..4usize, (0..9u32, 0..9u32), any::<bool>()),
    ) {
        let (mut slots, mut pool, mut buckets) = ([Slot::EMPTY; 24], vec![0; 60_000], [0; 47]);
        let mut areas = vec![Window::EMPTY; rectangles];
        let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets);
        let mut shown: Vec<Option<&Item>> = current.iter().map(Some).collect();
        let mut ids: Vec<ItemId> = current.iter().map(|item| item.add(&mut picture).unwrap()).collect();
        let mut picture = picture.with_damage(&mut areas, grid);
        let mut display = Display { grid, ..Display::new(AREA) };
        for edits in core::iter::once(&[][..]).chain(edits.chunks(at_once)) {
            for (index, edit) in edits {
                let index = index.index(shown.len() + 1);
                match (edit, ids.get(index)) {
                    (Some(item), Some(id)) => item.replace(&mut picture, *id).unwrap(),
                    (None, Some(id)) => picture.remove(*id),
                    (Some(item), None) => {
                        ids.push(item.add(&mut picture).unwrap());
                        shown.push(None);
                    }
                    (None, None) => continue,
                }
                shown[index] = edit.as_ref();
            }
            display.draw_damage(&mut picture, &[1, 2]);
            prop_assert_eq!(&display.words, &replayed(AREA, shown.iter().copied().flatten()));
            // Nothing is drawn twice.
            prop_assert!(picture.next_damage().is_none());
        }
        if clears {
            picture.clear();
            shown.truncate(2);
            ids = shown.iter().flatten().map(|item| item.add(&mut picture).unwrap()).collect();
            display.draw_damage(&mut picture, &[1, 2]);
            prop_assert_eq!(&display.words, &replayed(AREA, shown.iter().copied().flatten()));
            prop_assert_eq!(picture.slots_used(), ids.len());
        }
    }

    /// From no memory at all to enough.
    #[test]
    fn memory_of_every_size_is_enough_or_an_error_that_says_how_much_is_needed(
        items in proptest::collection::vec(items(), 1..8),
    ) {
        let (mut slots_needed, mut words_needed) = (0, 0);
        loop {
            let (mut slots, mut pool, mut buckets) = (vec![Slot::EMPTY; slots_needed], vec![0; words_needed], [0; 47]);
            let mut picture = Prepared::new(AREA, &mut slots, &mut pool, &mut buckets);
            let mut added = 0;
            let failure = items.iter().find_map(|item| {
                let result = item.add(&mut picture);
                added += usize::from(result.is_ok());
                result.err()
            });
            // Usable, whatever happened.
            prop_assert_eq!(in_bands(&mut picture, AREA, &[1]), replayed(AREA, &items[..added]));
            match failure {
                None => break,
                Some(InputError::TooSmall(TooSmall::Items(needed))) => {
                    prop_assert!(needed == slots_needed + 1);
                    slots_needed = needed;
                }
                Some(InputError::TooSmall(TooSmall::PictureWords(needed))) => {
                    prop_assert!(needed > words_needed);
                    words_needed = needed;
                }
                Some(other) => prop_assert!(false, "{other:?}"),
            }
        }
    }
}

/// An item that counts the bands that it is asked to draw into, and finds its rows in each.
struct Watched {
    rows: Range<i32>,
    bands: Cell<u32>,
}

impl PictureItem<Rgb565> for Watched {
    fn bounds(&self) -> Window {
        Window {
            left: 0,
            top: self.rows.start,
            right: 8,
            bottom: self.rows.end,
        }
    }

    fn draw(&self, band: &mut Band<'_, Rgb565>) {
        let window = band.window();
        assert!(
            window.top < self.rows.end && self.rows.start < window.bottom,
            "{window:?}"
        );
        self.bands.set(self.bands.get() + 1);
    }
}

/// An item of a program's own is drawn into bands that meet its rows, and into no others, however many rows a bucket has.
#[test]
fn items_are_asked_for_bands_that_meet_their_rows_alone() {
    let area = Rectangle::new(Point::zero(), Size::new(8, 32));
    for buckets in [0, 1, 3, 8, 32] {
        for (height, bands) in [(1, 7), (2, 4), (5, 2)] {
            let watched = Watched {
                rows: 13..20,
                bands: Cell::new(0),
            };
            let (mut slots, mut buckets) = ([PictureSlot::EMPTY; 1], vec![0; buckets]);
            let mut picture = Picture::<Rgb565>::new(area, &mut slots, &mut [], &mut buckets);
            picture.add_item(&watched).unwrap();
            in_bands(&mut picture, area, &[height]);
            assert_eq!(watched.bands.get(), bands);
        }
    }
}
