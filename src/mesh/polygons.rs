//! Convex polygons of a mesh, checked and cut into triangles.
//!
//! A polygon's plane is that of its Newell normal (in Sutherland, Sproull and Schumacker 1974, "A Characterization of Ten
//! Hidden-Surface Algorithms", Computing Surveys 6(1)), which is as long as twice the area and takes all corners into account.
//! Corners run around once and turn the same way, seen along it, where each corner turns that way, each triangle of the fan
//! from the first corner does, and all corners are on the inner side of the first edge. All numbers are exact integers.
//!
//! Cost: three cross products and three dot products a corner.

use crate::{
    geometry::InputError,
    mesh::face_normal::{cross, dot, is_less, square, way, wide_product},
};

/// The most different corners that indices of 16 bits can name.
const MOST_CORNERS: usize = 1 << 16;

/// How many triangles polygons are cut into; those with fewer than three corners into none.
pub(super) const fn count(polygons: &[&[u16]]) -> usize {
    let (mut count, mut rest) = (0usize, polygons);
    while let [polygon, others @ ..] = rest {
        count = count.saturating_add(polygon.len().saturating_sub(2));
        rest = others;
    }
    count
}

/// The triangles of polygons: of each the fan from its first corner.
pub(super) const fn triangulate<const FACES: usize>(
    vertices: &[[i16; 3]],
    polygons: &[&[u16]],
) -> Result<[[u16; 3]; FACES], InputError> {
    let mut faces = [[0; 3]; FACES];
    let mut left: &mut [[u16; 3]] = &mut faces;
    let mut rest = polygons;
    while let [polygon, others @ ..] = rest {
        if let Err(error) = check(vertices, polygon, polygons.len() - rest.len()) {
            return Err(error);
        }
        left = write_fan(polygon, left);
        rest = others;
    }
    let needed = count(polygons);
    if needed == FACES {
        Ok(faces)
    } else {
        Err(InputError::NumberOfFaces { needed })
    }
}

/// Writes the triangles of a polygon, as many as there is room for, and returns the room that is left.
const fn write_fan<'f>(polygon: &[u16], mut left: &'f mut [[u16; 3]]) -> &'f mut [[u16; 3]] {
    let Some((apex, mut fan)) = polygon.split_first() else {
        return left;
    };
    while let [second, others @ ..] = fan {
        if let [third, ..] = others {
            left = match left {
                [face, room @ ..] => {
                    *face = [*apex, *second, *third];
                    room
                }
                [] => return left,
            };
        }
        fan = others;
    }
    left
}

/// Whether a polygon, which has a number, is planar and convex.
const fn check(vertices: &[[i16; 3]], polygon: &[u16], number: usize) -> Result<(), InputError> {
    if let Some(vertex) = missing_vertex(vertices, polygon) {
        return Err(InputError::IndexOutOfRange { face: number, vertex });
    }
    let polygon = Corners { vertices, polygon };
    let is_flat = polygon.count() < 3 || polygon.count() > MOST_CORNERS;
    let normal = if is_flat { [0; 3] } else { polygon.normal() };
    if matches!(normal, [0, 0, 0]) {
        Err(InputError::NotConvex { polygon: number })
    } else if !polygon.is_planar(normal) {
        Err(InputError::NotPlanar { polygon: number })
    } else if !polygon.is_convex(normal) {
        Err(InputError::NotConvex { polygon: number })
    } else {
        Ok(())
    }
}

/// The largest index of a vertex that is not there.
const fn missing_vertex(vertices: &[[i16; 3]], polygon: &[u16]) -> Option<u16> {
    let (mut missing, mut rest) = (None, polygon);
    while let [vertex, others @ ..] = rest {
        let is_largest = match missing {
            Some(largest) => *vertex > largest,
            None => *vertex as usize >= vertices.len(),
        };
        if is_largest {
            missing = Some(*vertex);
        }
        rest = others;
    }
    missing
}

/// The corners of a polygon, whose vertices are there.
#[derive(Copy, Clone)]
struct Corners<'a> {
    vertices: &'a [[i16; 3]],
    polygon: &'a [u16],
}

impl Corners<'_> {
    const fn count(&self) -> usize {
        self.polygon.len()
    }

    /// The position of a corner, around and around.
    const fn at(&self, corner: usize) -> [i16; 3] {
        let corner = match corner.checked_rem(self.count()) {
            Some(corner) => corner,
            None => 0,
        };
        if let Some((_, [vertex, ..])) = self.polygon.split_at_checked(corner) {
            if let Some((_, [position, ..])) = self.vertices.split_at_checked(*vertex as usize) {
                return *position;
            }
        }
        [0; 3]
    }

    /// Newell's normal: below 2^34 times the number of corners along each axis, and so below 2^50.
    const fn normal(&self) -> [i64; 3] {
        let ([mut x, mut y, mut z], mut corner) = ([0; 3], 0);
        while corner < self.count() {
            let (from, to) = (self.at(corner), self.at(corner + 1));
            let ([from_x, from_y, from_z], [to_x, to_y, to_z]) = (way([0; 3], from), way([0; 3], to));
            x += (from_y - to_y) * (from_z + to_z);
            y += (from_z - to_z) * (from_x + to_x);
            z += (from_x - to_x) * (from_y + to_y);
            corner += 1;
        }
        [x, y, z]
    }

    /// Whether all corners are within half a unit of one plane: between two planes across the normal, a unit apart.
    const fn is_planar(&self, normal: [i64; 3]) -> bool {
        let (mut least, mut greatest, mut corner) = (0, 0, 1);
        while corner < self.count() {
            let height = dot(normal, way(self.at(0), self.at(corner)));
            if height < least {
                least = height;
            }
            if height > greatest {
                greatest = height;
            }
            corner += 1;
        }
        // Times the length of the normal: below 2^70.
        let thickness = (greatest - least).unsigned_abs();
        !is_less((0, square(normal)), wide_product(thickness, thickness))
    }

    /// Whether the corners run around the normal once, and each turns the same way.
    const fn is_convex(&self, normal: [i64; 3]) -> bool {
        let mut corner = 0;
        while corner < self.count() {
            let next = corner + 1;
            let is_convex = self.turns(normal, [corner, next, next + 1])
                && (corner == 0 || next == self.count() || self.turns(normal, [0, corner, next]))
                && (corner < 2 || self.turns(normal, [0, 1, corner]));
            if !is_convex {
                return false;
            }
            corner += 1;
        }
        true
    }

    /// Whether three corners are a triangle whose sense is that of the normal.
    const fn turns(&self, normal: [i64; 3], [a, b, c]: [usize; 3]) -> bool {
        let (a, b, c) = (self.at(a), self.at(b), self.at(c));
        dot(cross(way(a, b), way(a, c)), normal) > 0
    }
}
