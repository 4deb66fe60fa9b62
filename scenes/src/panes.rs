//! A revolving door of coloured glass around a teapot: panes that go through each other and through the pot, in any order.

use core::fmt;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::{
    scene::{self, Camera, FaceSet, Memory, Model, Pose, Rotation, Whole},
    shade::{Gouraud, GouraudSkin, Lambert, Translucent},
};

use crate::{
    PrepareError, Scene,
    meshes::face_set,
    paint::rgb,
    sine::TURN,
    standard::angle,
    teapot::{TEAPOT, TEAPOT_NORMALS},
    teapots::{CLAY, LIGHT, shaded},
};

/// The look of the scene: lit, and seen through.
type Glass = Translucent<Gouraud<Rgb565>>;

const COLUMNS: usize = 320;
const ROWS: usize = 240;
const FRAMES: u32 = 128;
const PANES: usize = 3;
/// The pot and both sides of each pane.
const VERTICES: usize = TEAPOT.vertices().len() + 4 * PANES;
const FACES: usize = TEAPOT.faces().len() + 4 * PANES;
/// From where the panes fill the picture.
const DISTANCE: I16F16 = I16F16::lit("1060");

static PANE: FaceSet = face_set(
    &[[-560, -400, 0], [-560, 400, 0], [560, 400, 0], [560, -400, 0]],
    &[[0, 1, 2], [0, 2, 3], [0, 2, 1], [0, 3, 2]],
);
static PANE_NORMALS: [[i8; 2]; 4] = [[0, 0]; 4];
/// The colours of the panes.
static TINTS: [[Rgb565; 1]; PANES] = [[rgb(220, 60, 70)], [rgb(60, 190, 90)], [rgb(70, 110, 230)]];
/// How much of the light of a pane is its own, of 255.
const ALPHA: u8 = 104;
/// Light that is the same from everywhere.
const EVEN: Lambert<1> = Lambert {
    ambient: U0F16::MAX,
    lights: LIGHT.lights,
    points: [],
};

/// The scene: a pot, and the panes around its axis.
pub struct Panes {
    memory: Memory<Whole<Glass>, VERTICES, FACES, COLUMNS, ROWS, 112>,
    models: [Model<'static, Glass>; PANES + 1],
}

impl fmt::Debug for Panes {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Panes")
            .field("models", &self.models.len())
            .finish_non_exhaustive()
    }
}

impl Default for Panes {
    fn default() -> Self {
        let skin = |colors: &'static [Rgb565], normals, lights, alpha| {
            let skin = GouraudSkin {
                colors,
                normals,
                lights,
            };
            (skin, alpha)
        };
        let pot = shaded(TEAPOT, skin(CLAY, TEAPOT_NORMALS.as_slice(), LIGHT, 255));
        let [first, second, third] = TINTS
            .each_ref()
            .map(|tint| shaded(PANE, skin(tint, PANE_NORMALS.as_slice(), EVEN, ALPHA)));
        Self {
            memory: Memory::new(),
            models: [first, second, third, pot],
        }
    }
}

impl Scene for Panes {
    type Color = Rgb565;
    type Prepared<'s> = scene::Prepared<'s, 'static, Whole<Glass>>;
    const NAME: &'static str = "panes";
    const TITLE: &'static str = "a teapot in a revolving door of glass";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(COLUMNS as u32, ROWS as u32));
    const BACKGROUND: Rgb565 = rgb(20, 24, 34);
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = 1;
    const DEPTH_ROW_BYTES: usize = size_of::<[u16; COLUMNS]>();

    fn prepare(&mut self, frame: u32) -> Result<Self::Prepared<'_>, PrepareError> {
        // Each pane looks the same after half a turn.
        let steps = frame % FRAMES * (TURN / 2 / FRAMES);
        let tilt = Rotation::about_x(angle(TURN - 36));
        let translation = [I16F16::ZERO, I16F16::ZERO, DISTANCE];
        let third = TURN / 2 / PANES as u32;
        let turns = (0..PANES as u32)
            .map(|pane| steps + pane * third)
            .chain([TURN - 2 * steps]);
        for (model, turn) in self.models.iter_mut().zip(turns) {
            model.pose = Pose::new(Rotation::about_y(angle(turn)).then(&tilt), translation);
        }
        let camera = Camera::new(Self::AREA, I16F16::lit("128"))?;
        self.memory.prepare(&camera, &self.models)
    }
}
