//! The error of values that cannot be used: of shapes, windows, paints, cameras and scenes.

use core::fmt::{self, Display};

use crate::geometry::TooSmall;

/// What was handed in cannot be used: says what is wrong with it, where, and what would do.
///
/// Plain data without code of its own; the texts are linked only where a program displays the error.
///
/// A program draws on without the model that an error names:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     geometry::InputError,
///     scene::{Camera, FaceSet, Memory, Model, Whole},
/// };
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 0], [512, -512, 0]], &[[0, 1, 2]])?;
/// let mut models = [Model::new(mesh, &[Rgb565::RED])?; 2];
/// models[0].pose.translation = [0, 0, 1024].map(I16F16::from_num);
/// // The other one stays where the camera is.
/// let mut memory = Memory::<Whole<Rgb565>, 6, 2, 64, 64>::new();
/// let mut in_front = models.len();
/// while let Err(error) = memory.prepare(&camera, &models[..in_front]) {
///     let InputError::BeforeNearPlane { model } = error else { return Err(error) };
///     models[model..in_front].rotate_left(1);
///     in_front -= 1;
/// }
/// assert_eq!(in_front, 1);
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InputError {
    /// A coordinate lies outside the domain of its precision, or of what can be computed: move or cut the shape first. Also of
    /// a corner or a viewport, as a `SubPoint` whose fields were set directly can.
    OutOfDomain {
        /// The smallest pixel coordinate that would do.
        min: i32,
        /// The largest pixel coordinate that would do.
        max: i32,
    },
    /// Memory is too small, as a table with fewer entries than a shape has edges or vertices. Storage that was lent can be
    /// prepared again with less.
    TooSmall(TooSmall),
    /// An id is not that of an item of the [`Picture`](crate::draw::Picture), or not that of a group where one is asked for: it was
    /// returned by another picture, or by this one before it was cleared or the group was removed.
    NoSuchItem,
    /// A [`ConvexWindow`](crate::geometry::ConvexWindow) has fewer than three corners.
    TooFewCorners,
    /// This corner of a convex window repeats the one before it, or lies on a straight line with its neighbours: leave it out.
    StraightCorner {
        /// The index of the corner.
        corner: usize,
    },
    /// This corner of a convex window turns the other way than the first one: split the polygon there.
    ConcaveCorner {
        /// The index of the corner.
        corner: usize,
    },
    /// The sides of a convex window cross: every corner turns the same way, but they go around more than once, as in a star.
    CrossingSides,
    /// A radius is larger than the algorithm draws.
    RadiusTooLarge {
        /// The largest radius that the algorithm draws, in pixels.
        max: u32,
    },
    /// The step of a polynomial is too fine for exact 64-bit differences.
    StepTooFine {
        /// The binary logarithm of the largest number of steps that would do.
        log2_steps: u32,
    },
    /// The colours of a [`Pattern`](crate::shade::Pattern) do not make whole rows, or there are none.
    NotARectangle {
        /// Number of colours in a row of the picture.
        width: usize,
        /// Colours that were given: that should be a multiple of the width, and not 0.
        colors: usize,
    },
    /// The stops of a [`Ramp`](crate::shade::Ramp) do not ascend, or there are none.
    NotAscending,
    /// A face of a [`FaceSet`](crate::scene::FaceSet) names a vertex that is not there.
    IndexOutOfRange {
        /// The index of the face.
        face: usize,
        /// The largest vertex index that the face names.
        vertex: u16,
    },
    /// A polygon of a mesh has fewer than three corners, repeats a corner, has one that is straight or turns the other way, or
    /// goes around more than once: leave corners out, or cut it into convex polygons.
    NotConvex {
        /// The index of the polygon.
        polygon: usize,
    },
    /// The corners of a polygon of a mesh are more than half a unit beside its plane: cut it into triangles, or choose a finer
    /// unit.
    NotPlanar {
        /// The index of the polygon.
        polygon: usize,
    },
    /// The polygons of a mesh are cut into another number of triangles than there shall be.
    NumberOfFaces {
        /// The number of triangles that the polygons of the mesh are cut into: the length that the array of faces must have.
        needed: usize,
    },
    /// The near plane of a [`Camera`](crate::scene::Camera) must be at least 8 units of the vertices away: choose a finer unit.
    NearTooClose,
    /// The far plane of a [`Camera`](crate::scene::Camera) must be behind its near plane, that of a
    /// [`ClipMatrix`](crate::clip::ClipMatrix) at least twice as far away as the near plane.
    FarTooClose,
    /// The viewport of a camera must have pixels, and lie within -8191 to 8191 pixels, the domain of
    /// [`Sub8`](crate::geometry::Sub8).
    ViewportOutOfDomain,
    /// The focal length of a camera must be between 1 and 2047 pixels.
    FocalLengthOutOfDomain,
    /// An axis, a direction or a quaternion has no length, or `up` has the direction that something looks in: choose another
    /// one.
    NoDirection,
    /// A position, after it was turned or moved, is more than 32,767 units from the origin: choose a coarser unit.
    PositionOutOfDomain,
    /// An affine map stretches by 128 or more, or flattens space, so that nothing undoes it: choose smaller factors, or coarser
    /// units. Or the scale of a [`Camera`](crate::scene::Camera) is not above 0.
    ScaleOutOfDomain,
    /// A model that an affine map stretches reaches more than 262,143 units from the camera: choose a coarser unit.
    ModelOutOfDomain {
        /// The index of the model among the models.
        model: usize,
    },
    /// A vertex is in front of the near plane, and the frame's look does not cut faces
    /// ([`Look::CLIPS`](crate::scene::Look::CLIPS)). The storage can be prepared again.
    BeforeNearPlane {
        /// The index of the vertex's model among the models.
        model: usize,
    },
    /// A vertex is behind the far plane, and the frame's look, whose rays are parallel, does not cut faces
    /// ([`Look::CLIPS`](crate::scene::Look::CLIPS)). The storage can be prepared again.
    BehindFarPlane {
        /// The index of the vertex's model among the models.
        model: usize,
    },
    /// A vertex has coordinates on the screen beyond those of the precision, and the frame's look
    /// does not cut faces. The storage can be prepared again.
    BeyondGuardBand {
        /// The index of the vertex's model among the models.
        model: usize,
    },
}

impl From<TooSmall> for InputError {
    fn from(error: TooSmall) -> Self {
        Self::TooSmall(error)
    }
}

impl Display for InputError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfDomain { min, max } => {
                write!(
                    formatter,
                    "coordinate outside {min} to {max} pixels: move or cut it first"
                )
            }
            Self::TooSmall(error) => error.fmt(formatter),
            Self::NoSuchItem => formatter
                .write_str("the id names no such item or group: take the one that this picture returned for it"),
            Self::TooFewCorners => formatter.write_str("a convex window has at least three corners"),
            Self::StraightCorner { corner } => {
                write!(formatter, "corner {corner} is repeated or straight: leave it out")
            }
            Self::ConcaveCorner { corner } => {
                write!(
                    formatter,
                    "corner {corner} turns the other way: split the polygon there"
                )
            }
            Self::CrossingSides => formatter.write_str("the sides cross: they go around more than once"),
            Self::RadiusTooLarge { max } => {
                write!(formatter, "radius above {max} pixels: take another algorithm")
            }
            Self::StepTooFine { log2_steps } => {
                write!(
                    formatter,
                    "too many steps for exact differences: at most 2^{log2_steps}"
                )
            }
            Self::NotARectangle { width, colors } => write!(
                formatter,
                "{colors} colours are not whole rows of {width}: give a multiple of the width, and not 0"
            ),
            Self::NotAscending => {
                formatter.write_str("the levels of the stops must ascend, and there must be one at least")
            }
            Self::IndexOutOfRange { face, vertex } => {
                write!(formatter, "face {face} names vertex {vertex}, which is not there")
            }
            Self::NotConvex { polygon } => write!(
                formatter,
                "polygon {polygon} is not convex, or has fewer than three corners, a repeated or a straight one"
            ),
            Self::NotPlanar { polygon } => write!(
                formatter,
                "polygon {polygon} has corners more than half a unit beside its plane: cut it into triangles"
            ),
            Self::NumberOfFaces { needed } => write!(
                formatter,
                "the polygons are cut into {needed} triangles: name that number"
            ),
            Self::NearTooClose => formatter.write_str("the near plane must be at least 8 units away"),
            Self::FarTooClose => formatter
                .write_str("the far plane must be behind the near plane, for a 4x4 matrix at least twice as far away"),
            Self::ViewportOutOfDomain => {
                formatter.write_str("the viewport is empty or reaches beyond the coordinates of the precision")
            }
            Self::FocalLengthOutOfDomain => formatter.write_str("the focal length must be between 1 and 2047 pixels"),
            Self::NoDirection => {
                formatter.write_str("a direction of length 0, or the same one as `up`: choose another one")
            }
            Self::PositionOutOfDomain => {
                formatter.write_str("a position more than 32,767 units from the origin: choose a coarser unit")
            }
            Self::ScaleOutOfDomain => formatter
                .write_str("an affine map stretches by 128 or more, or flattens space so that nothing undoes it"),
            Self::ModelOutOfDomain { model } => {
                write!(
                    formatter,
                    "model {model} reaches more than 262,143 units from the camera: choose a coarser unit"
                )
            }
            Self::BeforeNearPlane { model } => write_off_screen(formatter, *model, "in front of the near plane"),
            Self::BehindFarPlane { model } => write_off_screen(formatter, *model, "behind the far plane"),
            Self::BeyondGuardBand { model } => write_off_screen(formatter, *model, "too far beside the viewport"),
        }
    }
}

fn write_off_screen(formatter: &mut fmt::Formatter<'_>, model: usize, beyond: &str) -> fmt::Result {
    write!(
        formatter,
        "a vertex of model {model} is {beyond}: keep the model away from there, or let the frame cut faces (Look::CLIPS)"
    )
}

impl core::error::Error for InputError {}
