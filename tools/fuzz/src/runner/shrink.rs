//! Makes the bytes of a failing input fewer and smaller, as long as it fails in the same way.

use std::time::{Duration, Instant};

use crate::{runner::attempt::attempt, target::Target};

/// A smaller input that goes wrong in the same way; found within that time.
pub fn shrink(target: &Target, bytes: &[u8], kind: &str, time: Duration) -> Vec<u8> {
    let end = Instant::now() + time;
    let fails = |bytes: &[u8]| Instant::now() < end && attempt(target, bytes).is_err_and(|wrong| wrong.kind() == kind);
    let mut smallest = without_zeros(bytes.to_vec());
    loop {
        let before = smallest.clone();
        let mut length = smallest.len();
        while length > 0 {
            smallest = without_blocks(smallest, length, &fails);
            smallest = with_zero_blocks(smallest, length, &fails);
            length /= 2;
        }
        smallest = with_smaller_bytes(smallest, &fails);
        smallest = without_zeros(smallest);
        if smallest == before || Instant::now() >= end {
            return smallest;
        }
    }
}

/// Bytes behind the last one are read as zeros.
fn without_zeros(mut bytes: Vec<u8>) -> Vec<u8> {
    let length = bytes.iter().rposition(|byte| *byte != 0).map_or(0, |last| last + 1);
    bytes.truncate(length);
    bytes
}

fn without_blocks(mut bytes: Vec<u8>, length: usize, fails: &impl Fn(&[u8]) -> bool) -> Vec<u8> {
    let mut start = 0;
    while start + length <= bytes.len() {
        let mut shorter = bytes.clone();
        shorter.drain(start..start + length);
        if fails(&shorter) {
            bytes = shorter;
        } else {
            start += length;
        }
    }
    bytes
}

fn with_zero_blocks(mut bytes: Vec<u8>, length: usize, fails: &impl Fn(&[u8]) -> bool) -> Vec<u8> {
    for start in (0..bytes.len()).step_by(length) {
        let end = bytes.len().min(start + length);
        let mut simpler = bytes.clone();
        simpler[start..end].fill(0);
        if simpler != bytes && fails(&simpler) {
            bytes = simpler;
        }
    }
    bytes
}

fn with_smaller_bytes(mut bytes: Vec<u8>, fails: &impl Fn(&[u8]) -> bool) -> Vec<u8> {
    for index in 0..bytes.len() {
        // Bisects to the smallest byte, where a smaller one fails as well as a larger one.
        let (mut least, mut most) = (0, bytes[index]);
        while least < most {
            let middle = least + (most - least) / 2;
            let mut simpler = bytes.clone();
            simpler[index] = middle;
            if fails(&simpler) {
                most = middle;
            } else {
                least = middle + 1;
            }
        }
        bytes[index] = most;
    }
    bytes
}
