//! Offsets between coordinates: two `i32` are up to 2^32 - 1 apart, which only a `u32` holds, and so the differences and
//! sums of this file are those of plain numbers although they are found modulo 2^32.

/// How far `end` lies behind `start`, which must not be behind it. Cost: a subtraction.
#[inline]
pub(crate) const fn distance(start: i32, end: i32) -> u32 {
    debug_assert!(start <= end, "a distance is counted from the smaller coordinate");
    offset_from(start, end)
}

/// `coordinate - origin` modulo 2^32. A coordinate before the origin has a larger offset than any behind it, so that one
/// comparison, `offset_from(left, x) < width`, says whether x is within a window. Cost: a subtraction.
#[inline]
pub(crate) const fn offset_from(origin: i32, coordinate: i32) -> u32 {
    coordinate.wrapping_sub(origin) as u32
}

/// The coordinate that lies so far behind `start`. It must fit; otherwise it is right modulo 2^32. Cost: an addition.
#[inline]
pub(crate) const fn coordinate_after(start: i32, distance: u32) -> i32 {
    debug_assert!(
        start.checked_add_unsigned(distance).is_some(),
        "beyond the largest coordinate"
    );
    start.wrapping_add_unsigned(distance)
}

/// The coordinate that lies so far before `start`. It must fit; otherwise it is right modulo 2^32. Cost: a subtraction.
#[inline]
pub(crate) const fn coordinate_before(start: i32, distance: u32) -> i32 {
    debug_assert!(
        start.checked_sub_unsigned(distance).is_some(),
        "before the smallest coordinate"
    );
    start.wrapping_sub_unsigned(distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    const COORDINATES: [i32; 9] = [i32::MIN, i32::MIN + 1, -7, -1, 0, 1, 5, i32::MAX - 1, i32::MAX];

    #[test]
    fn distances_are_those_of_wider_numbers() {
        for start in COORDINATES {
            for end in COORDINATES.into_iter().filter(|&end| end >= start) {
                let expected = i64::from(end) - i64::from(start);
                assert_eq!(i64::from(distance(start, end)), expected, "{start} {end}");
                assert_eq!(coordinate_after(start, distance(start, end)), end);
                assert_eq!(coordinate_before(end, distance(start, end)), start);
            }
        }
    }

    #[test]
    fn an_offset_is_below_a_length_exactly_within_it() {
        for origin in COORDINATES {
            for end in COORDINATES.into_iter().filter(|&end| end >= origin) {
                for coordinate in COORDINATES {
                    let is_within = offset_from(origin, coordinate) < distance(origin, end);
                    assert_eq!(
                        is_within,
                        (origin..end).contains(&coordinate),
                        "{coordinate} in {origin}..{end}"
                    );
                }
            }
        }
    }
}
