//! Random numbers over the whole of their type, and random points.

use embedded_graphics::geometry::Point;
use proptest::prelude::*;
use zrow::geometry::{Sub8, SubPixel};

/// Any number, and more often one at which something ends or begins again.
pub fn any_number() -> impl Strategy<Value = i32> {
    prop_oneof![
        2 => any::<i32>(),
        1 => (0..31u32, -2..=2i32, any::<bool>()).prop_map(|(bits, aside, is_negative)| {
            let power = (1i32 << bits).wrapping_add(aside);
            if is_negative { power.wrapping_neg() } else { power }
        }),
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX]),
        1 => (-2..=2i32, any::<bool>()).prop_map(|(aside, is_least)| {
            (if is_least { Sub8::MIN_UNITS } else { Sub8::MAX_UNITS }) + aside
        }),
    ]
}

/// Points in and around a window of 64 x 64 pixels.
pub fn near() -> impl Strategy<Value = Point> {
    (-20..84i32, -20..84i32).prop_map(|(x, y)| Point::new(x, y))
}

/// Points anywhere, and more often in and around a window of 64 x 64 pixels and at the limits of what strokes take.
pub fn far() -> impl Strategy<Value = Point> {
    let coordinate = || {
        prop_oneof![
            2 => -20..84i32,
            1 => -8192..8192i32,
            1 => any::<i32>(),
            1 => prop::sample::select(vec![i32::MIN, i32::MAX, 16_384, 16_385, -16_384, -16_385]),
        ]
    };
    (coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y))
}
