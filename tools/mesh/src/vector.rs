//! Vectors of three numbers.

/// x, y and z.
pub type Vector = [f64; 3];

/// One less the other.
pub fn difference(one: Vector, other: Vector) -> Vector {
    [one[0] - other[0], one[1] - other[1], one[2] - other[2]]
}

/// The sum of two vectors.
pub fn sum(one: Vector, other: Vector) -> Vector {
    [one[0] + other[0], one[1] + other[1], one[2] + other[2]]
}

/// Each component times a number.
pub fn scaled(vector: Vector, factor: f64) -> Vector {
    vector.map(|component| component * factor)
}

/// The scalar product.
pub fn dot(one: Vector, other: Vector) -> f64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

/// The vector product.
pub fn cross(one: Vector, other: Vector) -> Vector {
    [
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    ]
}

/// The length.
pub fn length(vector: Vector) -> f64 {
    dot(vector, vector).sqrt()
}

/// The vector of length 1 in the same direction, if it has one.
pub fn unit(vector: Vector) -> Option<Vector> {
    // Scaled first: squares of small components would vanish.
    let greatest = vector
        .iter()
        .fold(0.0, |greatest: f64, component| greatest.max(component.abs()));
    if greatest == 0.0 || !greatest.is_finite() {
        return None;
    }
    let vector = vector.map(|component| component / greatest);
    Some(scaled(vector, 1.0 / length(vector)))
}

/// The normal of a polygon by Newell's method, as long as twice its area: the sum of the vector products of the corners that
/// follow each other. It is right for concave polygons, and a mean for those that are not planar.
pub fn newell(corners: &[Vector]) -> Vector {
    let Some(&first) = corners.first() else {
        return [0.0; 3];
    };
    let next = corners.iter().skip(1).chain([&first]);
    let products = corners
        .iter()
        .zip(next)
        .map(|(&one, &other)| cross(difference(one, first), difference(other, first)));
    products.fold([0.0; 3], sum)
}
