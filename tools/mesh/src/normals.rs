//! Normals of positions: the mean of the faces around them, weighted by the angle that each has there (Thürmer and Wüthrich,
//! "Computing Vertex Normals from Polygonal Facets", 1998), so that it does not matter how polygons are cut into triangles.

use std::collections::HashMap;

use crate::vector::{Vector, cross, difference, dot, length, scaled, sum, unit};

/// A triangle: its corners before rounding, and after it.
#[derive(Debug, Copy, Clone)]
pub struct Triangle {
    /// Before rounding.
    pub exact: [Vector; 3],
    /// After rounding: equal positions are one.
    pub rounded: [[i16; 3]; 3],
}

impl Triangle {
    /// The direction out of the face; of a triangle that has an area only after rounding, that one's.
    pub fn normal(&self) -> Vector {
        let normal = |[a, b, c]: [Vector; 3]| unit(cross(difference(b, a), difference(c, a)));
        let rounded = self.rounded.map(|position| position.map(f64::from));
        normal(self.exact).or(normal(rounded)).unwrap_or([0.0, 0.0, -1.0])
    }

    /// The angle at a corner.
    fn angle(&self, corner: usize) -> f64 {
        let at = |step: usize| self.exact[(corner + step) % 3];
        let (one, other) = (difference(at(1), at(0)), difference(at(2), at(0)));
        length(cross(one, other)).atan2(dot(one, other))
    }
}

/// The normals of all positions of some triangles.
#[derive(Debug, Clone)]
pub struct SmoothNormals(HashMap<[i16; 3], Vector>);

impl SmoothNormals {
    /// Adds up the normals around each position.
    pub fn of<'a>(triangles: impl Iterator<Item = &'a Triangle>) -> Self {
        let mut sums: HashMap<[i16; 3], Vector> = HashMap::new();
        for triangle in triangles {
            let normal = triangle.normal();
            for (corner, &position) in triangle.rounded.iter().enumerate() {
                let total = sums.entry(position).or_default();
                *total = sum(*total, scaled(normal, triangle.angle(corner)));
            }
        }
        Self(sums)
    }

    /// The normal at a corner of a triangle: that of the triangle where all around the position cancel out.
    pub fn at(&self, triangle: &Triangle, corner: usize) -> Vector {
        let total = self.0.get(&triangle.rounded[corner]).copied().unwrap_or_default();
        if length(total) < 1e-6 { triangle.normal() } else { total }
    }
}
