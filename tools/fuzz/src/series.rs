//! The bytes of each input: a function of seed, target and iteration alone, so that any input can be made again.

use zrow_methods::Random;

/// Bytes of an input. A target that needs more of them reads zeros.
pub const INPUT_BYTES: usize = 768;

/// The bytes of an input.
pub fn bytes(seed: u64, target: &str, iteration: u64) -> Vec<u8> {
    // Each of the three moves the start of the series by a mixed number.
    let name = target
        .bytes()
        .fold(seed, |state, byte| Random::new(state ^ u64::from(byte)).bits());
    let mut random = Random::new(name ^ Random::new(iteration).bits());
    let mut bytes = Vec::with_capacity(INPUT_BYTES);
    while bytes.len() < INPUT_BYTES {
        bytes.extend_from_slice(&random.bits().to_le_bytes());
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_seed_gives_the_same_inputs_and_another_one_others() {
        assert_eq!(bytes(1, "draw.circle", 7), bytes(1, "draw.circle", 7));
        let others = [
            bytes(2, "draw.circle", 7),
            bytes(1, "draw.circle", 8),
            bytes(1, "draw.ellipse", 7),
        ];
        for other in others {
            assert_ne!(bytes(1, "draw.circle", 7), other);
        }
    }
}
