//! One axis of a shape's box in `i128`: how a stroke makes it longer and shorter about its centre.

/// An axis of a box: the sum of its first and last coordinate, and its length.
#[derive(Debug, Copy, Clone)]
pub struct Axis {
    center_2x: i128,
    pub length: i128,
}

impl Axis {
    pub fn new(start: i32, length: u32) -> Self {
        Self {
            center_2x: 2 * i128::from(start) + i128::from(length) - 1,
            length: i128::from(length),
        }
    }

    /// Lengths end at `u32::MAX`, with the centre where it was.
    pub fn grown(self, start: i32, by: u32) -> Self {
        let by = i128::from(by).min((i128::from(u32::MAX) - self.length) / 2);
        let start = i128::from(start);
        let center_2x = if self.length == 0 {
            2 * start + 1
        } else {
            self.center_2x
        };
        Self {
            center_2x,
            length: self.length + 2 * by,
        }
    }

    pub fn shrunk(self, by: u32) -> Self {
        Self {
            length: (self.length - 2 * i128::from(by)).max(0),
            ..self
        }
    }

    /// Doubled distance of a coordinate from the centre.
    pub fn distance(self, coordinate: i32) -> i128 {
        (2 * i128::from(coordinate) - self.center_2x).abs()
    }

    /// Pixels between a coordinate and the first one of the axis, and between it and the last one; negative outside.
    pub fn distances_from_ends(self, coordinate: i32) -> [i128; 2] {
        let first = (self.center_2x - self.length + 1).div_euclid(2);
        let from_first = i128::from(coordinate) - first;
        [from_first, self.length - 1 - from_first]
    }
}
