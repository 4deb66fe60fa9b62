//! Where ellipses of any size have their first pixel, against their definition in 256 bits.

#[path = "../../../../tests/reference/wide_product.rs"]
mod wide_product;

use proptest::{prelude::*, test_runner::RngSeed};
use wide_product::{product, sum};

use super::*;

/// Whether a row of an ellipse's box has a pixel: the one nearest to the middle column, in doubled distances.
fn row_has_a_pixel(size: Size, row: u32) -> bool {
    let (width, height) = (u128::from(size.width), u128::from(size.height));
    if width == 0 || row >= size.height {
        return false;
    }
    let (dx, dy) = ((width - 1) % 2, (height - 1).abs_diff(2 * u128::from(row)));
    let square = |number: u128| product(number, number);
    sum(square(height * dx), square(width * dy)) < square(width * height)
}

#[test]
fn the_first_row_of_every_small_ellipse_has_its_first_pixel() {
    for size in (0..80).flat_map(|width| (0..200).map(move |height| Size::new(width, height))) {
        let first = (0..size.height).find(|row| row_has_a_pixel(size, *row));
        assert_eq!(first_row(size), first.unwrap_or(size.height), "{size:?}");
    }
}

/// Sides of boxes: small ones, powers of two and their neighbours, and any.
fn side() -> impl Strategy<Value = u32> {
    prop_oneof![
        0..300u32,
        (0..32u32, 0..3u32).prop_map(|(bits, more)| ((1u32 << bits) - 1).saturating_add(more)),
        any::<u32>(),
        Just(u32::MAX),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, rng_seed: RngSeed::Fixed(0x0123_4567), ..ProptestConfig::default() })]

    #[test]
    fn the_first_row_of_any_ellipse_has_its_first_pixel(width in side(), height in side()) {
        for size in [Size::new(width, height), Size::new(width & !1, height), Size::new(0, height), Size::new(width, 0)] {
            let first = first_row(size);
            prop_assert!(first == size.height || row_has_a_pixel(size, first), "{:?}", size);
            prop_assert!(first == 0 || !row_has_a_pixel(size, first - 1), "{:?}", size);
        }
    }
}
