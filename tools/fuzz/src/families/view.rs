//! `zrow::scene`: rotations, cameras, and how depths are stored.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};
use fixed::types::{I2F30, I16F16, U0F16};
use zrow::{
    geometry::{InputError, Sub4, Sub8, Window},
    scene::{Camera, DepthWidth, Pose, Rotation, ScreenPrecision},
};

use crate::{
    target::{Case, Verdict},
    values::{Int, Large, List, Number},
};

/// A turn about an axis.
#[derive(Debug, Copy, Clone, Arbitrary)]
pub enum Turn {
    /// About x.
    X(u16),
    /// About y.
    Y(u16),
    /// About z.
    Z(u16),
    /// About any axis.
    About([Int; 3], u16),
    /// Of a quaternion.
    Quaternion([Int; 4]),
    /// Towards a direction, with another one up.
    LookAt([Int; 3], [Int; 3]),
}

impl Turn {
    /// The rotation; none where there is no such one.
    pub fn get(self) -> Rotation {
        let vector = |parts: [Int; 3]| parts.map(|part| I16F16::from_bits(part.0));
        let turn = match self {
            Self::X(angle) => Ok(Rotation::about_x(U0F16::from_bits(angle))),
            Self::Y(angle) => Ok(Rotation::about_y(U0F16::from_bits(angle))),
            Self::Z(angle) => Ok(Rotation::about_z(U0F16::from_bits(angle))),
            Self::About(axis, angle) => Rotation::about(vector(axis), U0F16::from_bits(angle)),
            Self::Quaternion(parts) => Rotation::from_quaternion(parts.map(|part| I2F30::from_bits(part.0))),
            Self::LookAt(direction, up) => Rotation::look_at(vector(direction), vector(up)),
        };
        turn.unwrap_or(Rotation::IDENTITY)
    }
}

/// Rotations one after the other, and one that is squared many times.
#[derive(Debug, Arbitrary)]
pub struct RotationCase {
    turns: List<Turn, 12>,
    squared: Number<u8>,
}

/// How far the rows of a matrix may be from unit vectors at right angles, in each step: a little more than rounding.
const DRIFT: f64 = 1e-6;

fn is_orthonormal(rotation: &Rotation, steps: usize) -> Verdict {
    let matrix = rotation.matrix().map(|row| row.map(|element| element.to_num::<f64>()));
    for (index, one) in matrix.iter().enumerate() {
        for (other_index, other) in matrix.iter().enumerate() {
            let product: f64 = one.iter().zip(other).map(|(one, other)| one * other).sum();
            let expected = if index == other_index { 1.0 } else { 0.0 };
            ensure!(
                (product - expected).abs() <= DRIFT * (steps + 1) as f64,
                "rows {index} and {other_index} of {matrix:?} after {steps} steps"
            );
        }
    }
    Ok(())
}

impl Case for RotationCase {
    fn check(&self) -> Verdict {
        let mut all = Rotation::IDENTITY;
        for (steps, turn) in self.turns.0.iter().enumerate() {
            let turn = turn.get();
            is_orthonormal(&turn, 1)?;
            all = all.then(&turn);
            is_orthonormal(&all, steps + 2)?;
        }
        ensure!(all.inverse().inverse() == all, "turned back twice");
        is_orthonormal(&all.then(&all.inverse()), self.turns.0.len() + 2)?;
        // However often it is squared, it is a rotation.
        for _ in 0..self.squared.0 % 64 {
            all = all.then(&all);
            is_orthonormal(&all, 64)?;
        }
        Ok(())
    }
}

/// A camera of any numbers.
#[derive(Debug, Arbitrary)]
pub struct CameraCase {
    corner: [Int; 2],
    size: [Number<u16>; 2],
    near: Int,
    focal_length: Option<Int>,
    distances: [Int; 2],
    pose: Turn,
    position: [Int; 3],
}

impl CameraCase {
    fn check_at<S: ScreenPrecision, D: DepthWidth>(&self, camera: &Camera) -> Verdict {
        let [one, other] = self.distances.map(|distance| I16F16::from_bits(distance.0));
        let (nearer, farther) = (one.min(other), one.max(other));
        if nearer >= camera.near() {
            let depths = [nearer, farther].map(|distance| camera.depth_at::<S, D>(distance));
            ensure!(
                depths[0] >= depths[1] && depths[1] > D::FARTHEST,
                "{depths:?} of {nearer} and {farther}"
            );
        } else {
            // In front of the near plane there is no depth to say; there is no panic either.
            let _ = camera.depth_at::<S, D>(nearer);
        }
        Ok(())
    }
}

impl Case for CameraCase {
    fn check(&self) -> Verdict {
        let corner = Point::new(self.corner[0].0, self.corner[1].0);
        let size = Size::new(self.size[0].0.into(), self.size[1].0.into());
        let viewport = Rectangle::new(corner, size);
        let near = I16F16::from_bits(self.near.0);
        let camera = match Camera::new(viewport, near) {
            Ok(camera) => camera,
            Err(InputError::NearTooClose) => {
                ensure!(near < 8, "{near} is not too close");
                return Ok(());
            }
            Err(InputError::ViewportOutOfDomain) => {
                let window = Window::from(viewport);
                let sides = [window.left, window.top, window.right, window.bottom];
                let is_inside = sides.iter().all(|side| (-8_191..=8_191).contains(side));
                ensure!(window.is_empty() || !is_inside, "{window:?} is in the domain");
                return Ok(());
            }
            Err(InputError::FocalLengthOutOfDomain) => {
                ensure!(size.width > 4_094, "half of {} columns is no focal length", size.width);
                return Ok(());
            }
            Err(error) => anyhow::bail!("{error}, which is new"),
        };
        ensure!(near >= 8 && camera.near() == near, "{camera:?}");
        let camera = match self.focal_length.map(|length| I16F16::from_bits(length.0)) {
            None => camera,
            Some(length) => {
                let fits = (1..=2_047).contains(&length.to_num::<i32>()) && length <= 2_047;
                match camera.with_focal_length(length) {
                    Ok(camera) => {
                        ensure!(fits && camera.focal_length() == length, "{camera:?} for {length}");
                        camera
                    }
                    Err(error) => {
                        ensure!(!fits, "{error} for {length}");
                        camera
                    }
                }
            }
        };
        let position = self.position.map(|coordinate| I16F16::from_bits(coordinate.0));
        let camera = camera.with_pose(Pose::new(self.pose.get(), position));
        ensure!(
            camera.viewport() == Window::from(viewport),
            "{camera:?} of {viewport:?}"
        );
        self.check_at::<Sub4, u16>(&camera)?;
        self.check_at::<Sub4, u32>(&camera)?;
        self.check_at::<Sub8, u16>(&camera)?;
        self.check_at::<Sub8, u32>(&camera)
    }
}

/// Depths and products as they are stored.
#[derive(Debug, Arbitrary)]
pub struct StorageCase {
    ratios: [Number<u32>; 2],
    units: Int,
    wide: Large,
}

fn check_depth<D: DepthWidth>(case: &StorageCase) -> Verdict {
    let [one, other] = case.ratios.map(|ratio| ratio.0);
    let (far, near) = (one.min(other), one.max(other));
    let depths = [far, near].map(D::from_near_over_z);
    ensure!(
        depths[0] <= depths[1] && depths[0] > D::FARTHEST,
        "{depths:?} of {far} and {near}"
    );
    let depth = depths[1];
    let again = D::from_units(depth.units());
    ensure!(
        again <= depth && again.units() == depth.units(),
        "{depth:?} is {again:?}"
    );
    let _ = (D::from_units(case.units.0), D::from_interpolated(one));
    Ok(())
}

impl Case for StorageCase {
    fn check(&self) -> Verdict {
        check_depth::<u16>(self)?;
        check_depth::<u32>(self)?;
        let _ = (Sub4::wide(self.wide.0), Sub8::wide(self.wide.0));
        let _ = (Sub4::narrow(self.units.0), Sub8::narrow(self.units.0));
        Ok(())
    }
}
