//! Outlines that tests of several stages fill.

/// A star through every `step`-th of `count` points on a circle about (5300, 6300), in any unit.
pub fn star(count: usize, step: usize) -> Vec<(i32, i32)> {
    (0..count)
        .map(|index| {
            let angle = std::f64::consts::TAU * (index * step % count) as f64 / count as f64;
            (
                (5300.0 + 4600.0 * angle.sin()) as i32,
                (6300.0 - 4600.0 * angle.cos()) as i32,
            )
        })
        .collect()
}
