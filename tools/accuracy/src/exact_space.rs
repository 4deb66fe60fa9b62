//! Small scenes in `f64`, from vertices on: where they are on the screen, and which face is in front. Nothing here is zrow's
//! but the elements of its rotations, which are taken as they are.

use zrow_methods::space::{FOCAL_LENGTH, SPACE_SIZE, SpaceInput};

/// A place in eye space.
pub type Place = [f64; 3];

/// Three corners of each face in eye space. Exact: products of 30 and 16 bits.
pub fn faces(input: &SpaceInput) -> Vec<[Place; 3]> {
    let scale = f64::from(1 << 30);
    let matrix = input
        .pose
        .rotation
        .matrix()
        .map(|row| row.map(|element| f64::from(element.to_bits()) / scale));
    let moved = input.pose.translation.map(|coordinate| coordinate.to_num::<f64>());
    let place = |vertex: [i16; 3]| -> Place {
        let [x, y, z] = vertex.map(f64::from);
        std::array::from_fn(|axis| {
            let [a, b, c] = matrix[axis];
            a * x + b * y + c * z + moved[axis]
        })
    };
    let face = |face: &[u16; 3]| face.map(|vertex| place(input.vertices[usize::from(vertex)]));
    input.faces.iter().map(face).collect()
}

/// Column and row of a place, with pixel centres at whole numbers.
pub fn projected([x, y, z]: Place) -> [f64; 2] {
    let centre = (SPACE_SIZE / 2) as f64 - 0.5;
    let focal_length = f64::from(FOCAL_LENGTH);
    [centre + focal_length * x / z, centre - focal_length * y / z]
}

/// How far away the face is that is seen at a pixel through its centre, along z; nothing beside it.
pub fn distance([a, b, c]: &[Place; 3], column: usize, row: usize) -> Option<f64> {
    let (across, centre) = (f64::from(FOCAL_LENGTH), (SPACE_SIZE / 2) as f64 - 0.5);
    let ray = [(column as f64 - centre) / across, (centre - row as f64) / across, 1.0];
    // The volumes between the ray and each side have one sign inside.
    let sides = [cross(*a, *b), cross(*b, *c), cross(*c, *a)].map(|side| dot(side, ray));
    let is_inside = sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0);
    let normal = cross(between(*a, *b), between(*a, *c));
    is_inside.then(|| dot(normal, *a) / dot(normal, ray))
}

fn between(from: Place, to: Place) -> Place {
    std::array::from_fn(|axis| to[axis] - from[axis])
}

fn cross([ax, ay, az]: Place, [bx, by, bz]: Place) -> Place {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn dot([ax, ay, az]: Place, [bx, by, bz]: Place) -> f64 {
    ax * bx + ay * by + az * bz
}

#[cfg(test)]
mod tests {
    use super::{distance, projected};

    #[test]
    fn a_face_across_the_picture_is_as_far_away_as_its_plane() {
        // z = 100 + x: at the ray x = r z, z = 100 / (1 - r).
        let face = [[-50.0, -60.0, 50.0], [-50.0, 60.0, 50.0], [150.0, 0.0, 250.0]];
        let centre = projected([0.0, 0.0, 1.0]);
        assert_eq!(centre, [47.5, 47.5]);
        let found = distance(&face, 56, 47).unwrap();
        let ray = (56.0 - 47.5) / 96.0;
        assert!((found - 100.0 / (1.0 - ray)).abs() < 1e-9, "{found}");
        let seen = projected([found * ray, 0.5 / 96.0 * found, found]);
        assert!((seen[0] - 56.0).abs() < 1e-9 && (seen[1] - 47.0).abs() < 1e-9);
        assert_eq!(distance(&face, 95, 0), None);
    }
}
