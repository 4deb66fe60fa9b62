//! Which pixels see a triangle, by the ray through each one, in whole numbers: without clipping, without a division.

/// A camera at the origin that looks along z: size of the viewport and focal length in pixels, near and far plane.
#[derive(Debug, Clone, Copy)]
pub struct Eye {
    pub size: [i32; 2],
    pub focal_length: i32,
    pub depths: [i32; 2],
}

/// Fractions of a pixel that rays are asked for.
const FINE: i128 = 16;

fn determinant([a, b, c]: [[i128; 3]; 3]) -> i128 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

impl Eye {
    /// Whether the ray through a position meets the closed triangle between the planes; the position is in 1/16 pixel from the
    /// centre of a pixel.
    fn meets(&self, triangle: [[i16; 3]; 3], [x, y]: [i32; 2], [right, down]: [i128; 2]) -> bool {
        let from_middle = |pixel: i32, size: i32, fine: i128| i128::from(2 * pixel + 1 - size) * FINE + 2 * fine;
        let ray = [
            from_middle(x, self.size[0], right),
            -from_middle(y, self.size[1], down),
            2 * i128::from(self.focal_length) * FINE,
        ];
        let [a, b, c] = triangle.map(|vertex| vertex.map(i128::from));
        let whole = determinant([a, b, c]);
        // What each vertex weighs in the point of the ray on the triangle's plane, times `whole`.
        let weights = [
            determinant([ray, b, c]),
            determinant([a, ray, c]),
            determinant([a, b, ray]),
        ];
        let weights = weights.map(|weight| weight * whole.signum());
        let sum: i128 = weights.iter().sum();
        // The distance of that point is ray z * whole / sum.
        let depth = ray[2] * whole.abs();
        let [near, far] = self.depths.map(i128::from);
        whole != 0 && sum > 0 && weights.iter().all(|&weight| weight >= 0) && depth >= near * sum && depth <= far * sum
    }

    /// Whether a pixel sees the triangle; `None` where that changes within 1/8 pixel of its centre.
    pub fn sees(&self, triangle: [[i16; 3]; 3], pixel: [i32; 2]) -> Option<bool> {
        let sees = self.meets(triangle, pixel, [0, 0]);
        let around = [[-2, 0], [2, 0], [0, -2], [0, 2], [-2, -2], [2, -2], [-2, 2], [2, 2]];
        let is_clear = around
            .into_iter()
            .all(|offset| self.meets(triangle, pixel, offset) == sees);
        is_clear.then_some(sees)
    }
}
