//! Turns positions to zrow's axes, scales them, and rounds them to 16 bits.

use anyhow::{Context, ensure};

use crate::{
    model::Model,
    vector::{Vector, difference, length, scaled},
};

/// Which axis of a file points up. Files are right-handed; zrow has x to the right, y up and z away from the viewer.
///
/// Either way one axis is mirrored, so that the corners of faces are taken in the opposite order.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub enum Up {
    /// y is up and z points to the viewer, as in most OBJ files.
    Y,
    /// z is up and y points away from the viewer, as in files of CAD programs.
    Z,
}

impl Up {
    /// A vector of the file in zrow's axes.
    pub fn turned(self, [x, y, z]: Vector) -> Vector {
        match self {
            Self::Y => [x, y, -z],
            Self::Z => [x, z, y],
        }
    }
}

/// Positions in zrow's axes and units.
#[derive(Debug, Clone)]
pub struct Positions {
    /// Before rounding.
    pub exact: Vec<Vector>,
    /// After it.
    pub rounded: Vec<[i16; 3]>,
    /// The greatest distance between the two, of positions that faces name.
    pub greatest_error: f64,
    /// The mean distance.
    pub mean_error: f64,
}

/// Scales a model about its origin, so that the greatest coordinate that a face names becomes `size`.
///
/// # Errors
/// A model without faces, or with all of them in the origin.
pub fn quantize(model: &Model, up: Up, size: u16) -> anyhow::Result<Positions> {
    let mut used = vec![false; model.positions.len()];
    for corner in &model.corners {
        *used.get_mut(corner.position).context("a face names no position")? = true;
    }
    let coordinates = model.positions.iter().zip(&used).filter(|(_, used)| **used);
    let greatest = coordinates
        .flat_map(|(position, _)| position)
        .fold(0.0, |greatest: f64, coordinate| greatest.max(coordinate.abs()));
    ensure!(
        !model.faces.is_empty(),
        "{} has no faces: export polygons or triangles",
        model.file
    );
    let factor = f64::from(size) / greatest;
    ensure!(
        factor.is_finite() && factor <= 1e12,
        "{} is a point, its greatest coordinate is {greatest}: export the model again, in smaller units",
        model.file
    );
    let exact: Vec<Vector> = model
        .positions
        .iter()
        .map(|&position| scaled(up.turned(position), factor))
        .collect();
    // What no face names may be out of range; `as` saturates.
    let rounded: Vec<[i16; 3]> = exact
        .iter()
        .map(|position| position.map(|coordinate| coordinate.round() as i16))
        .collect();
    let errors: Vec<f64> = exact
        .iter()
        .zip(&rounded)
        .zip(&used)
        .filter(|(_, used)| **used)
        .map(|((exact, rounded), _)| length(difference(*exact, rounded.map(f64::from))))
        .collect();
    Ok(Positions {
        greatest_error: errors.iter().copied().fold(0.0, f64::max),
        mean_error: errors.iter().sum::<f64>() / errors.len().max(1) as f64,
        exact,
        rounded,
    })
}
