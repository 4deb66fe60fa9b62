//! A full-frame reference in exact arithmetic. It starts from the snapped corners and uses nothing else of the library.

use embedded_graphics::primitives::Rectangle;

/// A face as snapped: corners (x, y, z) in units, and its position in the order of faces.
#[derive(Debug, Copy, Clone)]
pub struct Face {
    pub order: usize,
    pub corners: [[i128; 3]; 3],
}

/// What interpolated depth is rounded to: units of a 16-bit depth, or 1/256 of a 24-bit one.
#[derive(Debug, Copy, Clone)]
pub enum Depth {
    Bits16,
    Bits32,
}

impl Depth {
    /// Stored steps of a depth unit.
    fn steps(self) -> i128 {
        match self {
            Self::Bits16 => 1,
            Self::Bits32 => 256,
        }
    }
}

impl Face {
    /// Twice the area; positive for a face that is seen from the front.
    fn area(&self) -> i128 {
        let [a, b, c] = self.corners;
        (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    }

    /// Whether a pixel centre is inside, or on a top or left edge.
    pub fn covers(&self, x: i128, y: i128) -> bool {
        let inside = |a: [i128; 3], b: [i128; 3]| {
            let side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
            let top = a[1] == b[1] && b[0] > a[0];
            let left = b[1] < a[1];
            side > 0 || side == 0 && (top || left)
        };
        let [a, b, c] = self.corners;
        self.area() > 0 && inside(a, b) && inside(b, c) && inside(c, a)
    }

    /// The depth of the face's plane at a point: numerator and positive denominator.
    pub fn depth(&self, x: i128, y: i128) -> (i128, i128) {
        let [a, b, c] = self.corners;
        let [x1, y1, z1] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let [x2, y2, z2] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
        let area = self.area();
        let rise = (z1 * y2 - z2 * y1) * (x - a[0]) + (x1 * z2 - x2 * z1) * (y - a[1]);
        (a[2] * area + rise, area)
    }

    /// The depth in 1/100 of a stored step, rounded down.
    pub fn hundredths(&self, x: i128, y: i128, depth: Depth) -> i128 {
        let (numerator, denominator) = self.depth(x, y);
        (100 * depth.steps() * numerator).div_euclid(denominator)
    }

    /// The stored depth, rounded to the nearest once, up on ties.
    pub fn stored(&self, x: i128, y: i128, depth: Depth) -> i128 {
        let (numerator, denominator) = self.depth(x, y);
        (2 * depth.steps() * numerator + denominator).div_euclid(2 * denominator)
    }
}

/// For each pixel of an area the order of the face that is seen there: the nearest, and of equals the first.
pub fn owners(faces: &[Face], area: Rectangle, unit: i128, depth: Depth) -> Vec<Option<usize>> {
    let width = area.size.width as usize;
    let mut owners = vec![None; width * area.size.height as usize];
    let mut nearest = vec![0i128; owners.len()];
    let mut faces: Vec<_> = faces.iter().filter(|face| face.area() > 0).collect();
    faces.sort_by_key(|face| face.order);
    for face in faces {
        // Only pixels within the bounds, which cannot matter but for time.
        let bounds = |axis: usize, start: i32, size: u32| {
            let coordinates = face.corners.map(|corner| corner[axis].div_euclid(unit));
            let least = *coordinates.iter().min().unwrap() - i128::from(start);
            let greatest = *coordinates.iter().max().unwrap() + 1 - i128::from(start);
            least.clamp(0, size.into()) as usize..(greatest + 1).clamp(0, size.into()) as usize
        };
        for row in bounds(1, area.top_left.y, area.size.height) {
            for column in bounds(0, area.top_left.x, area.size.width) {
                let x = (column as i128 + i128::from(area.top_left.x)) * unit;
                let y = (row as i128 + i128::from(area.top_left.y)) * unit;
                if !face.covers(x, y) {
                    continue;
                }
                let stored = face.stored(x, y, depth);
                let index = row * width + column;
                if stored > nearest[index] {
                    nearest[index] = stored;
                    owners[index] = Some(face.order);
                }
            }
        }
    }
    owners
}
