//! What to draw, and the prepared frame.
//!
//! A [`Memory`] holds what a scene takes: vertices on the screen, faces by their first row, the active list and the depth row.
//! Preparing it takes a [`Camera`] and [`Model`]s and finds everything that can go wrong; drawing what is prepared cannot fail.
//! The capacities are named once, in its type; functions that take the memory of any scene take a [`Frame`].
//!
//! What pictures are made of is a [`Look`], the memory's first parameter: a colour, another [`Shading`](crate::shade::Shading)
//! such as [`Gouraud`](crate::shade::Gouraud), or a wrapper around another look that changes one thing, such as [`Whole`] for
//! objects that always stay in front of the camera. What a look does not name takes no flash, no RAM and no time.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
//! use zrow::fixed::types::{I16F16, U0F16};
//! use zrow::{
//!     band::{Band, DisplaySink, PictureLoop},
//!     scene::{Camera, FaceSet, Memory, Model, Pose, Rotation},
//! };
//!
//! // One unit is 1/512 here: a pyramid's front.
//! let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 0], [512, -512, 0]], &[[0, 1, 2]]).unwrap();
//! let model = Model::new(mesh, &[Rgb565::RED]).unwrap();
//!
//! let mut display = MockDisplay::<Rgb565>::new();
//! let camera = Camera::new(display.bounding_box(), I16F16::from_num(128)).unwrap();
//! // Three vertices, one face, 64 x 64 pixels.
//! let mut memory = Memory::<Rgb565, 3, 1, 64, 64>::new();
//! let mut row = [0; 64];
//!
//! let rotation = Rotation::about_y(U0F16::from_num(1.0 / 16.0));
//! let distance = [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(1024)];
//! let models = [model.with_pose(Pose::new(rotation, distance))];
//! let mut scene = memory.prepare(&camera, &models).unwrap();
//! PictureLoop::new(display.bounding_box(), Rgb565::BLACK)
//!     .draw(&mut row, &mut DisplaySink(&mut display), |band| scene.draw(band))
//!     .unwrap();
//! assert_eq!(display.get_pixel(Point::new(32, 32)), Some(Rgb565::RED));
//! ```

// The measured reason for functions that are marked as cold here is in `visible`.

mod back_faces;
mod by_method;
mod clipping;
mod counters;
mod culling;
mod depth_lines;
mod depth_polygons;
mod edges;
mod estimate;
mod faces;
mod frame;
mod lens;
mod lines;
mod look;
mod memory;
mod model;
mod near_plane;
mod off_screen;
mod preparation;
mod prepare;
mod prepared;
mod prepared_faces;
mod prepared_lines;
mod scene_item;
mod seen_vertices;
mod silhouette_tables;
mod silhouettes;
mod stored_attributes;

pub use crate::{
    mesh::{BoundingBox, BoundingCylinder, BoundingSphere, BoundingVolume, Edge, EdgeKind, FacePlanes, FaceSet},
    shade::InstructionSet,
    view::{Affine, Camera, DepthWidth, Pose, Rotation, ScreenPrecision},
};
pub use counters::Counters;
pub use frame::Frame;
pub use look::{
    Antialiased, Counted, Deep, DoubleSided, Fine, Look, Multisampled, OnePass, Orthographic, Unhurried, VisibleBy,
    Whole,
};
pub use memory::Memory;
pub use model::Model;
pub use prepared::Prepared;
pub use scene_item::SceneItem;
