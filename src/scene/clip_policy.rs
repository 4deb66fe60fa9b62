//! Whether a frame clips faces: a type parameter of the frame, so that clipping is linked only where it is used.

use core::fmt::Debug;

// Seals `Clipping`, and is not re-exported: who writes code for both kinds of frames has `CUTS` as a parameter.
/// What a frame does with a face that reaches in front of the near plane or beyond the guard band.
pub trait ClipPolicy: Copy + Debug + Send + Sync + sealed::Sealed {
    /// Whether faces that reach beyond the near plane or the guard band are cut.
    const CUTS: bool;
}

mod sealed {
    pub trait Sealed {}
    impl<const CUTS: bool> Sealed for super::Clipping<CUTS> {}
}

/// Whether a frame cuts faces; by default it does.
///
/// `Clipping`: faces are cut at the near plane and at the guard band, so that a scene may be anywhere, also around the camera.
/// Flash: about 3 KB on a Cortex-M3 at opt-level "s".
///
/// `Clipping<false>`: faces are never cut: for objects that stay in front of the camera, such as one that turns.
/// Each vertex of the models must be on the screen: not in front of the near plane, and within the guard band,
/// which reaches from the viewport's centre on each side as far as the coordinates of the precision do on the nearest:
/// 959 pixels for 128 x 64 pixels at the origin with [`Sub4`](crate::geometry::Sub4). Otherwise
/// [`Frame::prepare`](crate::scene::Frame::prepare) is an error that says which model and why; no picture is ever wrong. All
/// pictures are those of `Clipping`.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use fixed::types::I16F16;
/// use zrow::{
///     geometry::{InputError, Sub4},
///     scene::{Camera, Clipping, FaceSet, Frame, Model},
/// };
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
/// let mut frame = Frame::<Rgb565, 3, 1, 1, 64, Sub4, u16, Clipping<false>>::new();
/// let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 800], [512, -512, 800]], &[[0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Rgb565::RED])?];
/// assert_eq!(frame.prepare(&camera, &models).err(), Some(InputError::BeforeNearPlane { model: 0 }));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Clipping<const CUTS: bool = true>;

impl<const CUTS: bool> ClipPolicy for Clipping<CUTS> {
    const CUTS: bool = CUTS;
}
