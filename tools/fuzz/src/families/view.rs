//! `zrow::scene`: rotations, cameras, and how depths are stored.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::Gray8,
    primitives::Rectangle,
};
use fixed::types::{I2F30, I8F24, I16F16, U0F16};
use zrow::{
    band::Band,
    geometry::{InputError, Sub4, Sub8, Window},
    scene::{
        Affine, Camera, Deep, DepthWidth, FaceSet, Fine, Look, Memory, Model, Orthographic, Pose, Rotation,
        ScreenPrecision,
    },
    shade::{DirectionalLight, FlatLit, FlatLitSkin, Lambert, Transformed},
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

/// An affine map: its matrix, its translation, and by how much both are smaller.
type AnyMap = ([[Int; 3]; 3], [Int; 3], Number<u8>);

/// Affine maps one after the other, and a model that they put before a camera.
#[derive(Debug, Arbitrary)]
pub struct AffineCase {
    maps: List<AnyMap, 4>,
    turn: Turn,
    position: [Int; 3],
    vertices: [[Number<i16>; 3]; 4],
    normal: [u8; 2],
}

impl AffineCase {
    /// The maps, one after the other as far as they fit.
    fn map(&self) -> Affine {
        let maps = self.maps.0.iter().map(|(matrix, translation, shift)| Affine {
            matrix: matrix.map(|row| row.map(|part| I8F24::from_bits(part.0 >> (shift.0 % 12)))),
            translation: translation.map(|part| I16F16::from_bits(part.0 >> (shift.0 % 16))),
        });
        maps.fold(Affine::IDENTITY, |map, next| map.then(&next).unwrap_or(map))
    }

    /// Prepares and draws a model in a look; its pixels are in the middle of the words.
    fn check_in<L: Look<Color = Gray8, Shading = Transformed<FlatLit<Gray8>>>>(&self, map: Affine) -> Verdict {
        let vertices = self.vertices.map(|vertex| vertex.map(|part| part.0));
        let mesh = FaceSet::new(&vertices, &[[0, 1, 2], [0, 2, 1], [1, 2, 3], [3, 2, 1]])?;
        let normals = [self.normal.map(|byte| byte as i8); 4];
        let light = DirectionalLight::from_direction([1, -2, -3].map(I16F16::from_num::<i32>), U0F16::MAX)?;
        let lights = Lambert {
            ambient: U0F16::from_bits(100),
            lights: [light],
            points: [],
        };
        let skin = FlatLitSkin {
            colors: &[Gray8::new(255)],
            normals: &normals,
            lights,
        };
        let model = Model::<L::Shading>::with_skin(mesh, (skin, map))?;
        let position = self.position.map(|coordinate| I16F16::from_bits(coordinate.0));
        let models = [model.with_pose(Pose::new(self.turn.get(), position))];
        let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(24, 16)), I16F16::from_num(8))?
            .with_far(I16F16::from_num(20_000))?;
        let mut memory = Memory::<L, 120, 4, 24, 16, 4>::new();
        let mut prepared = match memory.prepare(&camera, &models) {
            Ok(prepared) => prepared,
            Err(error) => {
                ensure!(
                    error == InputError::ModelOutOfDomain { model: 0 },
                    "{error}, which is new"
                );
                return Ok(());
            }
        };
        let mut words = [0; 24 * 16];
        prepared.draw(&mut Band::<Gray8>::new(camera.viewport().to_rectangle(), &mut words)?);
        // One normal, one light.
        let drawn: Vec<_> = words.iter().filter(|&&word| word != 0).collect();
        ensure!(drawn.windows(2).all(|pair| pair[0] == pair[1]), "{words:?}");
        Ok(())
    }
}

impl Case for AffineCase {
    fn check(&self) -> Verdict {
        let map = self.map();
        if let Ok(inverse) = map.inverse() {
            ensure!(inverse != Affine::scaled([I8F24::ZERO; 3]), "of {map:?}");
            let _ = inverse.inverse();
        }
        let greatest = map
            .normals()
            .matrix
            .into_iter()
            .flatten()
            .map(I8F24::unsigned_abs)
            .max();
        ensure!(
            greatest.is_some_and(|part| part == 0 || (32..=64).contains(&part.to_num::<u8>())),
            "{map:?}"
        );
        self.check_in::<Transformed<FlatLit<Gray8>>>(map)?;
        self.check_in::<Orthographic<Transformed<FlatLit<Gray8>>>>(map)?;
        self.check_in::<Fine<Deep<Transformed<FlatLit<Gray8>>>>>(map)
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
    centre: [Int; 2],
    far: Int,
    scale: Int,
    pose: Turn,
    position: [Int; 3],
}

impl CameraCase {
    /// The camera with another centre, far plane and scale, as far as they are in their domains.
    fn refined(&self, camera: Camera) -> Result<Camera, anyhow::Error> {
        let centre = self.centre.map(|coordinate| I16F16::from_bits(coordinate.0));
        let camera = match camera.with_centre(centre) {
            Ok(camera) => camera,
            Err(error) => {
                let corner = [camera.viewport().left, camera.viewport().top];
                let pixels = corner
                    .into_iter()
                    .zip(centre)
                    .map(|(corner, centre)| corner + (centre.to_bits() >> 16));
                let is_inside = pixels.into_iter().all(|pixel| (-1_024..=1_023).contains(&pixel));
                ensure!(!is_inside, "{error} for {centre:?} of {camera:?}");
                camera
            }
        };
        let far = I16F16::from_bits(self.far.0);
        let camera = match camera.with_far(far) {
            Ok(camera) => camera,
            Err(error) => {
                ensure!(
                    error == InputError::FarTooClose && far <= camera.near(),
                    "{error} for {far}"
                );
                camera
            }
        };
        match camera.with_scale(I8F24::from_bits(self.scale.0)) {
            Ok(camera) => Ok(camera),
            Err(error) => {
                ensure!(self.scale.0 <= 0, "{error} for a scale of {}", self.scale.0);
                Ok(camera)
            }
        }
    }

    /// Depths of parallel rays fall from the near to the far plane.
    fn check_parallel<L: Look>(&self, camera: &Camera) -> Verdict {
        let [one, other] = self.distances.map(|distance| I16F16::from_bits(distance.0));
        let depths = [one.min(other), one.max(other)].map(|distance| Orthographic::<L>::depth_at(camera, distance));
        ensure!(depths[0] >= depths[1] && depths[1] > L::Depth::FARTHEST, "{depths:?}");
        Ok(())
    }

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
        let camera = self.refined(camera)?;
        self.check_parallel::<Gray8>(&camera)?;
        self.check_parallel::<Fine<Deep<Gray8>>>(&camera)?;
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
