//! The volume of the cone that filters a line, over a line of width 1: factors from tables of distances.
//!
//! Source: Gupta and Sproull 1981; the tables are closed forms, which the tests compute again.

/// Fractional bits of distances: 16 pixels are the range of 32 bits. The lowest bit says whether a distance has been
/// rounded, see `rounded_to_odd` of `gupta_sproull`, so that directions have one bit less: 2^14 pixels from the middle
/// of the longest line a distance is off by 1/2^13 pixel at most.
pub(super) const FRACTION_BITS: u32 = 27;
pub(super) const PIXEL: i32 = 1 << FRACTION_BITS;

/// `A`, the volume of the cone over a line of width 1 without ends, in 1/256 of a level (1/65,280); and `Q`, what the
/// product lacks half a pixel inside an end, in 1/8192 of a level. At distances of 1/16 pixel from the line.
pub(super) const ACROSS: [(u16, i16); 25] = [
    (50_949, -19_437),
    (50_629, -18_874),
    (49_673, -17_236),
    (48_100, -14_678),
    (45_940, -11_464),
    (43_239, -7_965),
    (40_059, -4_678),
    (36_486, -2_041),
    (32_643, 0),
    (28_759, 1_882),
    (24_984, 3_792),
    (21_376, 5_637),
    (17_984, 7_289),
    (14_843, 8_620),
    (11_980, 9_518),
    (9_416, 9_899),
    (7_165, 9_718),
    (5_235, 8_974),
    (3_627, 7_718),
    (2_337, 6_058),
    (1_356, 4_175),
    (665, 2_329),
    (238, 886),
    (35, 159),
    (0, 0),
];

/// `L`, the volume of the cone between its axis and an end, in 1/65,536; and `P`, what the product lacks there a quarter of
/// a pixel beside the line, as a part of what it lacks half a pixel inside the end, in 1/2^14. At distances of 1/16 pixel
/// from the end.
const ALONG: [(u16, i16); 17] = [
    (0, 0),
    (3_896, 2_904),
    (7_686, 6_056),
    (11_308, 9_258),
    (14_713, 12_204),
    (17_867, 14_591),
    (20_741, 16_175),
    (23_315, 16_792),
    (25_575, 16_384),
    (27_513, 15_005),
    (29_127, 12_842),
    (30_422, 10_226),
    (31_407, 7_463),
    (32_101, 4_742),
    (32_530, 2_320),
    (32_733, 567),
    (32_768, 0),
];

/// Factors of the two products that stand for the volume of the cone: what depends on one distance.
#[derive(Copy, Clone, Default)]
pub(super) struct Factors {
    pub(super) product: i32,
    pub(super) correction: i32,
}

impl Factors {
    /// The factors at a distance to an end, which is negative where the end is passed.
    #[inline]
    pub(super) fn to_end(distance: i32) -> Self {
        let Self { product, correction } = interpolated(&ALONG, distance.unsigned_abs());
        // All ones where the distance is negative.
        let sign = distance >> 31;
        Self {
            product: (product ^ sign) - sign,
            correction: (correction ^ sign) - sign,
        }
    }
}

/// The factors at a distance, interpolated between two entries of a table; beyond the table those of its last entry.
#[inline]
pub(super) fn interpolated<const ENTRIES: usize>(table: &[(u16, i16); ENTRIES], distance: u32) -> Factors {
    const PITCH_BITS: u32 = FRACTION_BITS - 4;
    let factors = |&(product, correction): &(u16, i16)| Factors {
        product: product.into(),
        correction: correction.into(),
    };
    let index = (distance >> PITCH_BITS) as usize;
    let (Some(from), Some(to)) = (table.get(index), table.get(index + 1)) else {
        return table.last().map_or_else(Factors::default, factors);
    };
    // In 1/2^12 of the pitch: no two neighbours differ by more than 2^13.
    let part = ((distance >> (PITCH_BITS - 12)) & 0xfff) as i32;
    let between = |from: i32, to: i32| from + (((to - from) * part) >> 12);
    let (from, to) = (factors(from), factors(to));
    Factors {
        product: between(from.product, to.product),
        correction: between(from.correction, to.correction),
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use core::f64::consts::PI;

    use super::*;

    /// Volume of the cone between its middle and a distance: the integral of its section.
    fn closed_form(distance: f64) -> f64 {
        let u = distance.abs().min(1.0);
        let cubic = if u == 0.0 { 0.0 } else { u.powi(3) * (1.0 / u).acosh() };
        ((2.0 * u * (1.0 - u * u).sqrt() + u.asin() - cubic) / PI).copysign(distance)
    }

    fn line_closed_form(distance: f64) -> f64 {
        closed_form(distance + 0.5) - closed_form(distance - 0.5)
    }

    /// Volume of the cone between its axis and the corner of a rectangle: the integral of its height.
    fn corner(x: f64, y: f64) -> f64 {
        let sign = x.signum() * y.signum();
        let (x, y) = (x.abs().min(1.0), y.abs().min(1.0));
        let radius = x.hypot(y);
        let volume = if x == 0.0 || y == 0.0 {
            0.0
        } else if radius > 1.0 {
            (closed_form(x) + closed_form(y)) / 2.0 - 0.25
        } else {
            let distances = x.powi(3) * (y / x).asinh() + y.powi(3) * (x / y).asinh();
            3.0 / PI * (x * y - x * y * radius / 3.0 - distances / 6.0)
        };
        sign * volume
    }

    /// Volume of the cone over the line from the axis to an end, less the product.
    fn lacking(to_end: f64, distance: f64) -> f64 {
        let volume = corner(to_end, distance + 0.5) - corner(to_end, distance - 0.5);
        volume - line_closed_form(distance) * closed_form(to_end)
    }

    /// A value that is off by as much as what is interpolated in the middle between two such is, the other way.
    fn between_errors(curve: fn(f64) -> f64, at: f64) -> f64 {
        let pitch = 1.0 / 16.0;
        curve(at) + (2.0 * curve(at) - curve(at - pitch) - curve(at + pitch)) / 16.0
    }

    #[test]
    fn tables_are_their_closed_forms() {
        for (distance, exact) in [(0.0, 198.86), (0.5, 127.5), (1.0, 28.07), (1.5, 0.0)] {
            assert!((line_closed_form(distance) * 255.0 - exact).abs() < 0.005, "{distance}");
        }
        let sixteenths = |index: usize| index as f64 / 16.0;
        for (index, &(volume, correction)) in ACROSS.iter().enumerate() {
            let exact = between_errors(line_closed_form, sixteenths(index)) * 65_280.0;
            assert_eq!(f64::from(volume), exact.round().max(0.0), "{index}");
            let exact = lacking(0.5, sixteenths(index)) * 255.0 * 8192.0;
            assert_eq!(f64::from(correction), exact.round(), "{index}");
        }
        for (index, &(volume, correction)) in ALONG.iter().enumerate() {
            let exact = between_errors(closed_form, sixteenths(index)) * 65_536.0;
            assert_eq!(f64::from(volume), exact.round().min(32_768.0), "{index}");
            let exact = lacking(sixteenths(index), 0.25) / lacking(0.5, 0.25) * f64::from(1 << 14);
            assert_eq!(f64::from(correction), exact.round(), "{index}");
        }
    }

    #[test]
    fn interpolation_is_within_a_sixth_of_a_level() {
        let mut largest = (0f64, 0f64);
        for step in 0..=15_500 {
            let distance = f64::from(step) / 10_000.0;
            let units = (distance * f64::from(PIXEL)) as u32;
            let across = f64::from(interpolated(&ACROSS, units).product) / 65_280.0;
            let along = f64::from(interpolated(&ALONG, units).product) / 65_536.0;
            largest.0 = largest.0.max((across - line_closed_form(distance)).abs() * 255.0);
            largest.1 = largest.1.max((along - closed_form(distance)).abs() * 255.0);
        }
        assert!(largest.0 < 0.165 && largest.1 < 0.085, "{largest:?}");
    }

    #[test]
    fn the_product_lacks_a_product() {
        let (mut without, mut with) = (0f64, 0f64);
        for to_end in (0..=100).map(|step| f64::from(step) / 100.0) {
            for distance in (0..=150).map(|step| f64::from(step) / 100.0) {
                let exact = lacking(to_end, distance) * 255.0;
                let product = lacking(0.5, distance) * lacking(to_end, 0.25) / lacking(0.5, 0.25) * 255.0;
                without = without.max(exact.abs());
                with = with.max((exact - product).abs());
            }
        }
        assert!(without < 2.42 && with < 0.16, "{without} {with}");
    }
}
