//! What to draw, and the prepared frame.
//!
//! A [`Frame`] is the storage of a scene: vertices on the screen, faces by their first row, the active list. Preparing
//! it takes a [`Camera`] and [`Model`]s and finds everything that can go wrong; drawing what is
//! prepared cannot fail but for a depth buffer that is too small.
//!
//! What pictures are made of is a [`Look`], the frame's first parameter: a colour, or a type of the program's own that names
//! another precision, or leaves out that faces are cut, for objects that always stay in front of the camera. What a look does
//! not name takes no flash, no RAM and no time.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
//! use fixed::types::{I16F16, U0F16};
//! use zrow::{
//!     band::{Band, DisplaySink, PictureLoop},
//!     scene::{Camera, FaceSet, Frame, Model, Pose, Rotation},
//! };
//!
//! // One unit is 1/512 here: a pyramid's front.
//! let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 0], [512, -512, 0]], &[[0, 1, 2]]).unwrap();
//! let model = Model::new(mesh, &[Rgb565::RED]).unwrap();
//!
//! let mut display = MockDisplay::<Rgb565>::new();
//! let camera = Camera::new(display.bounding_box(), I16F16::from_num(128)).unwrap();
//! let mut frame = Frame::<Rgb565, 3, 1, 1, 64>::new();
//! let (mut row, mut depths) = ([0; 64], [0; 64]);
//!
//! let rotation = Rotation::about_y(U0F16::from_num(1.0 / 16.0));
//! let distance = [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(1024)];
//! let models = [model.with_pose(Pose::new(rotation, distance))];
//! let mut scene = frame.prepare(&camera, &models).unwrap();
//! PictureLoop::new(display.bounding_box(), Rgb565::BLACK)
//!     .draw(&mut row, &mut DisplaySink(&mut display), |band| {
//!         scene.draw(band, &mut depths).unwrap();
//!     })
//!     .unwrap();
//! assert_eq!(display.get_pixel(Point::new(32, 32)), Some(Rgb565::RED));
//! ```

// The measured reason for functions that are marked as cold here is in `visible`.

mod clipping;
mod faces;
mod frame;
mod look;
mod model;
mod off_screen;
mod preparation;
mod prepare;
mod prepared;
mod scene_item;

pub use crate::{
    mesh::FaceSet,
    view::{Camera, DepthWidth, Pose, Rotation, ScreenPrecision},
};
pub use frame::Frame;
pub use look::Look;
pub use model::Model;
pub use prepared::Prepared;
pub use scene_item::SceneItem;
