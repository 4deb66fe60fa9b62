//! The perspective camera.

use embedded_graphics::primitives::Rectangle;
use fixed::types::I16F16;

use crate::{
    geometry::{InputError, Window},
    view::Pose,
};

/// A perspective camera that looks along its z axis, x to the right and y up.
///
/// A point (x, y, z) of eye space is seen at the continuous position u = W/2 + f x/z, v = H/2 - f y/z of a viewport of
/// W by H pixels, where pixel i covers i <= u < i + 1. Pixel centres are at integer coordinates, so the screen
/// coordinates are u - 1/2 and v - 1/2 (and the viewport's top left corner added): a symmetric scene gives a symmetric
/// picture. The focal length f is W/2 pixels until it is set: a horizontal field of view of 90 degrees.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Camera {
    viewport: Window,
    near: I16F16,
    focal_length: I16F16,
    pose: Pose,
}

const LEAST_NEAR: I16F16 = I16F16::lit("8");
const LEAST_FOCAL_LENGTH: I16F16 = I16F16::lit("1");
const GREATEST_FOCAL_LENGTH: I16F16 = I16F16::lit("2047");

impl Camera {
    /// A camera at the origin. What is nearer than `near` units is cut away.
    ///
    /// # Errors
    /// [`InputError::NearTooClose`]; [`InputError::ViewportOutOfDomain`] where it has no pixels or is too large for any
    /// precision.
    pub fn new(viewport: Rectangle, near: I16F16) -> Result<Self, InputError> {
        let viewport = Window::from(viewport);
        if near < LEAST_NEAR {
            return Err(InputError::NearTooClose);
        }
        let domain = -8191..=8191;
        let corners = [viewport.left, viewport.top, viewport.right, viewport.bottom];
        if viewport.is_empty() || !corners.iter().all(|corner| domain.contains(corner)) {
            return Err(InputError::ViewportOutOfDomain);
        }
        // Below 16,383 pixels wide, so half of it fits; the greatest focal length still bounds it.
        let half_width = I16F16::from_bits((viewport.width() as i32) << 15);
        Self {
            viewport,
            near,
            focal_length: I16F16::ONE,
            pose: Pose::IDENTITY,
        }
        .with_focal_length(half_width.max(LEAST_FOCAL_LENGTH))
    }

    /// The camera with another focal length, in pixels: the size of an object at a distance of its own size.
    ///
    /// # Errors
    /// [`InputError::FocalLengthOutOfDomain`].
    pub fn with_focal_length(self, focal_length: I16F16) -> Result<Self, InputError> {
        if !(LEAST_FOCAL_LENGTH..=GREATEST_FOCAL_LENGTH).contains(&focal_length) {
            return Err(InputError::FocalLengthOutOfDomain);
        }
        Ok(Self { focal_length, ..self })
    }

    /// The camera at another position in the world, turned from looking along z.
    #[must_use]
    pub const fn with_pose(self, pose: Pose) -> Self {
        Self { pose, ..self }
    }

    /// Where the camera is.
    pub const fn pose(&self) -> &Pose {
        &self.pose
    }

    /// The pixels that the camera draws.
    pub const fn viewport(&self) -> Window {
        self.viewport
    }

    /// Distance of the near plane.
    pub const fn near(&self) -> I16F16 {
        self.near
    }

    /// Focal length in pixels.
    pub const fn focal_length(&self) -> I16F16 {
        self.focal_length
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Camera {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Camera {} near {} focal length {} {}",
            self.viewport,
            self.near.to_num::<f32>(),
            self.focal_length.to_num::<f32>(),
            self.pose
        );
    }
}
