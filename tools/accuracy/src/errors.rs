//! Errors summed up: root mean square and largest, over coverage or displacements.

/// Full coverage in a mask.
pub const FULL: f64 = 255.0;

/// Sums over errors.
#[derive(Debug, Clone, Default)]
pub struct Errors {
    squares: f64,
    count: u64,
    max: f64,
    /// Pixels that are not on an edge and wrong all the same.
    strays: u64,
}

impl Errors {
    /// Adds one error.
    pub fn add(&mut self, error: f64) {
        self.squares += error * error;
        self.count += 1;
        self.max = self.max.max(error.abs());
    }

    /// Adds a mask: errors in 1/255, over the pixels on an edge, which are covered in part.
    pub fn add_mask(&mut self, exact: &[f64], mask: &[u8]) {
        for (coverage, covered) in exact.iter().zip(mask) {
            let error = f64::from(*covered) - coverage * FULL;
            if 0.0 < *coverage && *coverage < 1.0 {
                self.add(error);
            } else if error != 0.0 {
                self.strays += 1;
            }
        }
    }

    /// Adds what another one has summed up.
    pub fn add_all(&mut self, other: &Self) {
        self.squares += other.squares;
        self.count += other.count;
        self.strays += other.strays;
        self.max = self.max.max(other.max);
    }

    /// The root of the mean square; 0 where there is nothing.
    pub fn rms(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }

    /// The largest one.
    pub fn max(&self) -> f64 {
        self.max
    }

    /// How many there are.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Pixels that are not on an edge and wrong all the same.
    pub fn strays(&self) -> u64 {
        self.strays
    }
}

#[cfg(test)]
mod tests {
    use super::Errors;

    #[test]
    fn only_pixels_on_an_edge_count() {
        let mut errors = Errors::default();
        errors.add_mask(&[0.0, 0.0, 1.0, 0.2, 0.4], &[0, 9, 255, 54, 98]);
        assert_eq!((errors.count(), errors.strays()), (2, 1));
        assert!((errors.rms() - (9.0f64 + 16.0).sqrt() / 2f64.sqrt()).abs() < 1e-9);
        assert!((errors.max() - 4.0).abs() < 1e-9);
    }
}
