//! The camera: in perspective, or with parallel rays.

use core::num::{NonZeroU32, NonZeroU64};

use embedded_graphics::primitives::Rectangle;
use fixed::types::{I8F24, I16F16, U0F16};

use crate::{
    geometry::{InputError, Sub4, Window, pixel_domain},
    view::{
        Pose, Rotation,
        sine::{cosine, sine},
    },
};

/// A camera that looks along its z axis, x to the right and y up: in perspective, or with parallel rays for a look that is
/// [`Orthographic`](crate::scene::Orthographic).
///
/// A point (x, y, z) of eye space is seen at the continuous position u = c + f x/z, v = d - f y/z of a viewport of W by H
/// pixels, where pixel i covers i <= u < i + 1. Pixel centres are at integer coordinates, so the screen coordinates are u - 1/2
/// and v - 1/2 (and the viewport's top left corner added). The centre (c, d) is (W/2, H/2) until it is set: a symmetric scene
/// gives a symmetric picture. The focal length f is W/2 pixels until it is set: a horizontal field of view of 90 degrees.
/// Without perspective u = c + s x and v = d - s y, for a scale s of one pixel a unit until it is set.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I16F16, U0F16};
/// use zrow::scene::{BoundingSphere, Camera, Pose};
///
/// // Sixty degrees wide, from 64 to 8,000 units.
/// let panel = Rectangle::new(Point::zero(), Size::new(320, 240));
/// let lens = Camera::new(panel, I16F16::from_num(64))?
///     .with_field_of_view(U0F16::from_num(1.0 / 6.0))?
///     .with_far(I16F16::from_num(8000))?;
/// assert_eq!(lens.focal_length().round(), 277);
///
/// // The same lens in each frame, at another place: a lighthouse comes out of the haze.
/// let lighthouse = BoundingSphere::around(&[[0, 0, 9000], [0, 400, 9000]]);
/// let is_seen_from = |z: i32| {
///     let camera = lens.with_pose(Pose { translation: [0, 100, z].map(I16F16::from_num), ..Pose::IDENTITY });
///     camera.may_see::<Rgb565>(lighthouse, &Pose::IDENTITY)
/// };
/// assert_eq!([0, 500, 1000, 1500].map(is_seen_from), [false, false, true, true]);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub struct Camera {
    viewport: Window,
    near: I16F16,
    /// 0 where there is none.
    far: I16F16,
    focal_length: I16F16,
    /// From the middle of the viewport to the point that the camera looks at.
    offset: [I16F16; 2],
    /// 0 for one pixel a unit.
    scale: I8F24,
    pose: Pose,
}

const LEAST_NEAR: I16F16 = I16F16::lit("8");
const LEAST_FOCAL_LENGTH: I16F16 = I16F16::lit("1");
const GREATEST_FOCAL_LENGTH: I16F16 = I16F16::lit("2047");

impl Camera {
    /// A camera at the origin, which draws into a part of the picture. What is nearer than `near` units is cut away.
    ///
    /// The viewport may be anywhere in the picture: what is drawn elsewhere stays as it is, so that several cameras draw into
    /// one picture, one after the other, each in its viewport, and a mirror or a map lies over the view of another one. The
    /// depths of a row are those of the scene that is being drawn.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     scene::{Camera, FaceSet, Memory, Model, Pose},
    /// };
    ///
    /// let mesh = FaceSet::new(&[[-900, -900, 0], [-900, 900, 0], [900, 900, 0]], &[[0, 1, 2]])?;
    /// let [road, mirror] = [Rgb565::RED, Rgb565::GREEN].map(|color| [color]);
    /// let ahead = Pose { translation: [0, 0, 600].map(I16F16::from_num::<i32>), ..Pose::IDENTITY };
    /// let (road, mirror) = ([Model::new(mesh, &road)?.with_pose(ahead)], [Model::new(mesh, &mirror)?.with_pose(ahead)]);
    /// let picture = Rectangle::new(Point::zero(), Size::new(64, 48));
    /// let corner = Rectangle::new(Point::new(4, 2), Size::new(16, 12));
    /// let (mut memory, mut small) = (Memory::<Rgb565, 3, 1, 64, 48>::new(), Memory::<Rgb565, 3, 1, 16, 12>::new());
    /// let mut scene = memory.prepare(&Camera::new(picture, I16F16::from_num(64))?, &road)?;
    /// let mut in_mirror = small.prepare(&Camera::new(corner, I16F16::from_num(64))?, &mirror)?;
    ///
    /// let mut words = [0; 64 * 48];
    /// let mut band = Band::<Rgb565>::new(picture, &mut words)?;
    /// scene.draw(&mut band);
    /// in_mirror.draw(&mut band);
    /// let color_at = |x: usize, y: usize| band.words()[64 * y + x];
    /// assert_eq!(color_at(8, 8), Rgb565::GREEN.into_storage());
    /// assert_eq!(color_at(8, 20), Rgb565::RED.into_storage());
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NearTooClose`]; [`InputError::ViewportOutOfDomain`] where it has no pixels or is too large for any
    /// precision; [`InputError::FocalLengthOutOfDomain`] where it is wider than 4,094 pixels, whose half is the focal length.
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
            far: I16F16::ZERO,
            focal_length: I16F16::ONE,
            offset: [I16F16::ZERO; 2],
            scale: I8F24::ZERO,
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

    /// The camera with the focal length for a horizontal field of view, as a fraction of a turn below a half: a quarter is 90
    /// degrees.
    ///
    /// # Errors
    /// [`InputError::FocalLengthOutOfDomain`], also for no angle and for half a turn and more.
    pub fn with_field_of_view(self, angle: U0F16) -> Result<Self, InputError> {
        // Positive where the angle is below half a turn and not 0: cot(a/2) = (1 + cos a) / sin a.
        let sine = u32::try_from(sine(angle).to_bits()).ok().and_then(NonZeroU32::new);
        let sine = sine.ok_or(InputError::FocalLengthOutOfDomain)?;
        let one_and_cosine = (i64::from(cosine(angle).to_bits()) + (1 << 30)) as u64;
        // Half of fewer than 2^14 pixels, with 16 fractional bits, times 2 in 2.30: below 2^60.
        let product = u64::from(self.viewport.width() << 15) * one_and_cosine;
        let focal_length = (product + u64::from(sine.get() / 2)) / NonZeroU64::from(sine);
        let focal_length = i32::try_from(focal_length).map_err(|_| InputError::FocalLengthOutOfDomain)?;
        self.with_focal_length(I16F16::from_bits(focal_length))
    }

    /// The camera with another scale, in pixels for a unit, for looks that are [`Orthographic`](crate::scene::Orthographic);
    /// any other look takes the focal length instead.
    ///
    /// # Errors
    /// [`InputError::ScaleOutOfDomain`] for 0 and below.
    pub fn with_scale(self, scale: I8F24) -> Result<Self, InputError> {
        if scale <= I8F24::ZERO {
            return Err(InputError::ScaleOutOfDomain);
        }
        Ok(Self { scale, ..self })
    }

    /// The camera with another point of the picture that it looks at: u to the right and v down from the viewport's top left
    /// corner, in pixels. The middle until it is set; any other point, which may be outside the viewport, makes the frustum
    /// oblique: the viewport is a part of a larger picture, the lens is shifted, or the camera is one eye of two that look
    /// through the same window.
    ///
    /// ```
    /// use embedded_graphics::{prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::scene::Camera;
    ///
    /// // The right half of a picture of 320 x 240 pixels.
    /// let half = Rectangle::new(Point::new(160, 0), Size::new(160, 240));
    /// let camera = Camera::new(half, I16F16::from_num(64))?
    ///     .with_focal_length(I16F16::from_num(160))?
    ///     .with_centre([0, 120].map(I16F16::from_num::<i32>))?;
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::OutOfDomain`] for a point that is neither inside the viewport nor within -1024 to 1023 pixels of the
    /// display, so that each precision has a place for it.
    pub fn with_centre(self, centre: [I16F16; 2]) -> Result<Self, InputError> {
        let Window {
            left,
            top,
            right,
            bottom,
        } = self.viewport;
        let ([x, y], [middle_x, middle_y]) = (centre, self.middle());
        let (min, max) = pixel_domain::<Sub4>();
        let fits = |start: i32, end: i32, from_start: I16F16| {
            let pixel = start + (from_start.to_bits() >> 16);
            (start..end).contains(&pixel) || (min..=max).contains(&pixel)
        };
        if !fits(left, right, x) || !fits(top, bottom, y) {
            return Err(InputError::out_of_domain::<Sub4>());
        }
        // Within 9,215 pixels of the viewport's corner, and the middle within 8,191.
        let offset = [x - middle_x, y - middle_y];
        Ok(Self { offset, ..self })
    }

    /// The middle of the viewport from its top left corner. Below 16,383 pixels, so half of it fits.
    fn middle(&self) -> [I16F16; 2] {
        [self.viewport.width(), self.viewport.height()].map(|pixels| I16F16::from_bits((pixels as i32) << 15))
    }

    /// The camera with a far plane: what is farther away than `far` units is not drawn, and faces that cross the plane are cut
    /// there. A look without cut faces ([`Look::CLIPS`](crate::scene::Look::CLIPS)) keeps all faces whole, also those behind
    /// the plane; where its rays are parallel, a vertex behind it is an error.
    ///
    /// Without one there is no limit. In perspective it changes no stored depth: those reach to infinity, and each vertex is
    /// transformed once more for it. Without perspective depths reach from the near to the far plane, or 32,768 units where
    /// there is none.
    ///
    /// # Errors
    /// [`InputError::FarTooClose`] where it is not behind the near plane.
    pub fn with_far(self, far: I16F16) -> Result<Self, InputError> {
        if far <= self.near {
            return Err(InputError::FarTooClose);
        }
        Ok(Self { far, ..self })
    }

    /// The camera with another near plane.
    ///
    /// # Errors
    /// [`InputError::NearTooClose`]; [`InputError::FarTooClose`] where it is not in front of the far plane.
    pub(crate) fn with_near(self, near: I16F16) -> Result<Self, InputError> {
        if near < LEAST_NEAR {
            return Err(InputError::NearTooClose);
        }
        let camera = Self { near, ..self };
        if near < camera.far() {
            Ok(camera)
        } else {
            Err(InputError::FarTooClose)
        }
    }

    /// The camera at a position of the world, looking at another one, with `up`, a direction of any length, up in the picture.
    ///
    /// ```
    /// use embedded_graphics::{prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::scene::Camera;
    ///
    /// let at = |x, y, z| [x, y, z].map(I16F16::from_num::<i32>);
    /// let viewport = Rectangle::new(Point::zero(), Size::new(240, 320));
    /// let camera = Camera::new(viewport, I16F16::from_num(64))?.look_at(at(0, 300, -1100), at(0, 0, 0), at(0, 1, 0))?;
    /// assert_eq!(camera.pose().translation, at(0, 300, -1100));
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NoDirection`] where both positions are the same one, or `up` is the direction from one to the other.
    pub fn look_at(self, position: [I16F16; 3], target: [I16F16; 3], up: [I16F16; 3]) -> Result<Self, InputError> {
        let ([x, y, z], [target_x, target_y, target_z]) = (position, target);
        let way = |from: I16F16, to: I16F16| i64::from(to.to_bits()) - i64::from(from.to_bits());
        let direction = [way(x, target_x), way(y, target_y), way(z, target_z)];
        let rotation = Rotation::towards(direction, up)?;
        Ok(self.with_pose(Pose::new(rotation, position)))
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

    /// Distance of the far plane; the greatest number where there is none.
    pub const fn far(&self) -> I16F16 {
        if self.has_far_plane() { self.far } else { I16F16::MAX }
    }

    /// Whether there is a far plane.
    const fn has_far_plane(&self) -> bool {
        self.far.to_bits() != 0
    }

    /// Distance of the far plane; 0 where there is none.
    pub(crate) const fn far_or_zero(&self) -> I16F16 {
        self.far
    }

    /// Pixels for a unit where rays are parallel.
    pub const fn scale(&self) -> I8F24 {
        if self.scale.to_bits() == 0 {
            I8F24::ONE
        } else {
            self.scale
        }
    }

    /// The point of the picture that the camera looks at, from the viewport's top left corner.
    pub fn centre(&self) -> [I16F16; 2] {
        let ([x, y], [offset_x, offset_y]) = (self.middle(), self.offset);
        [x + offset_x, y + offset_y]
    }

    /// From the middle of the viewport to the point that the camera looks at.
    pub(crate) const fn offset(&self) -> [I16F16; 2] {
        self.offset
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
