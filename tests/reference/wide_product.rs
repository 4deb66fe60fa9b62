//! Products and sums of 256 bits, the upper half first.

/// The product of two numbers: its upper and its lower 128 bits.
pub fn product(one: u128, other: u128) -> (u128, u128) {
    let halves = |number: u128| (number >> 64, number & u128::from(u64::MAX));
    let ((one_high, one_low), (other_high, other_low)) = (halves(one), halves(other));
    let shifted = |number: u128| (number >> 64, number << 64);
    let parts = [
        (one_high * other_high, 0),
        shifted(one_high * other_low),
        shifted(one_low * other_high),
        (0, one_low * other_low),
    ];
    parts.into_iter().fold((0, 0), sum)
}

/// The sum of two numbers of 256 bits, which fits them.
pub fn sum(one: (u128, u128), other: (u128, u128)) -> (u128, u128) {
    let (low, carry) = one.1.overflowing_add(other.1);
    (one.0 + other.0 + u128::from(carry), low)
}
