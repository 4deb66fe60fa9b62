//! Small scenes on which the formats of numbers in 3D are measured: the same on the desktop and on the chips.

mod groups;
mod input;
mod registry;
mod shading;
mod stage;

pub use groups::{DEPTH_GROUPS, MATRIX_GROUPS, PERSPECTIVE_GROUPS, POSITION_GROUPS, SPACE_SCENES, SpaceGroup};
pub use input::{FOCAL_LENGTH, SPACE_SIZE, SpaceInput};
pub use registry::{DEPTH_WIDTHS, MATRIX_FORMATS, PERSPECTIVES, POSITIONS, SpaceMethod};
pub use shading::{Coordinates, EveryPixel, InSpace, Plain, SpaceShading, face_of};
pub use stage::{ScreenCorner, SpaceRun, SpaceStage};
