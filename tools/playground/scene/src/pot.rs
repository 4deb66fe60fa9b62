//! The teapot behind the items, in the look that the state names. It is drawn in RGB565 for every panel: a look for each
//! colour would be three times as much code.

use embedded_graphics::{
    geometry::Dimensions,
    pixelcolor::{Gray8, GrayColor, Rgb565},
};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::Band,
    geometry::{InputError, Sub4, SubPoint},
    scene::{Antialiased, Camera, FaceSet, Look, Memory, Model, OnePass, Pose, Prepared, Rotation, Whole},
    shade::{
        FlatLit, FlatLitSkin, Fog, Foggy, Gouraud, GouraudSkin, LitTextured, LitTexturedSkin, Shading, Texels,
        Translucent,
    },
};
use zrow_scenes::{
    teapot::{TEAPOT, TEAPOT_COLORS, TEAPOT_COORDINATES, TEAPOT_FACE_NORMALS, TEAPOT_NEIGHBOURS, TEAPOT_NORMALS},
    teapots::{LIGHT, PORCELAIN},
};

use crate::{
    panel_color::DrawnColor,
    playground::{AREA, BACKGROUND, HEIGHT, WIDTH},
    state::{Pot, State},
};

const VERTICES: usize = TEAPOT.vertices().len();
const FACES: usize = TEAPOT.faces().len();
/// Slots for faces that cross a row, in any pose.
const ACTIVE: usize = 140;
/// A quarter of a length of 1, in units of the vertices.
const NEAR: I16F16 = I16F16::lit("128");
/// The colours of faces on black, so that a pixel is as bright as it is covered.
const WHITE: &[Gray8] = &[Gray8::WHITE; FACES];
/// From where the pot fills the width of the panel.
const DISTANCE: I16F16 = I16F16::lit("736");
/// The colour of a pot without a texture.
const CLAY: &[Rgb565] = &[Rgb565::new(236 >> 3, 188 >> 2, 150 >> 3)];
/// Where the fog begins, and where nothing is seen any more.
const FOG: [I16F16; 2] = [I16F16::lit("500"), I16F16::lit("1000")];
/// Of 255: how much of what is behind a translucent face it hides.
const HALF: u8 = 128;

/// The words of a band of RGB565.
pub type Words = [u16; WIDTH * HEIGHT];
/// Draws the pot into a band.
pub type DrawPot<'d> = &'d mut dyn FnMut(&mut Band<'_, Rgb565>);

/// Prepares the pot of a state and calls `draw` with what draws it into bands.
///
/// # Errors
/// Those of the scene.
pub fn with(state: &State, draw: &mut dyn FnMut(DrawPot<'_>)) -> Result<(), InputError> {
    let smooth = GouraudSkin {
        colors: CLAY,
        normals: &TEAPOT_NORMALS,
        lights: LIGHT,
    };
    match state.pot {
        Pot::None => {
            draw(&mut |_| ());
            Ok(())
        }
        Pot::Flat => prepared::<Whole<OnePass<Rgb565>>>(state, TEAPOT, &TEAPOT_COLORS, draw),
        Pot::FlatLit => {
            let skin = FlatLitSkin {
                colors: CLAY,
                normals: &TEAPOT_FACE_NORMALS,
                lights: LIGHT,
            };
            prepared::<Whole<OnePass<FlatLit<Rgb565>>>>(state, TEAPOT, skin, draw)
        }
        Pot::Gouraud => prepared::<Whole<OnePass<Gouraud<Rgb565>>>>(state, TEAPOT, smooth, draw),
        Pot::Silhouettes => {
            let surface = TEAPOT.with_neighbours(&TEAPOT_NEIGHBOURS);
            prepared::<Whole<OnePass<Antialiased<Gouraud<Rgb565>>>>>(state, surface, smooth, draw)
        }
        Pot::Textured => {
            let skin = LitTexturedSkin {
                image: &PORCELAIN,
                coordinates: &TEAPOT_COORDINATES,
                normals: &TEAPOT_NORMALS,
                lights: LIGHT,
            };
            prepared::<Whole<OnePass<LitTextured<Texels<Rgb565, 64, 64>>>>>(state, TEAPOT, skin, draw)
        }
        Pot::Translucent => {
            prepared::<Whole<OnePass<Translucent<Rgb565>>>>(state, TEAPOT, (&TEAPOT_COLORS, HALF), draw)
        }
        Pot::Foggy => {
            let [start, end] = FOG;
            let fog = Fog {
                color: BACKGROUND.into(),
                start,
                end,
                curve: Fog::LINEAR,
            };
            prepared::<Whole<OnePass<Foggy<Rgb565>>>>(state, TEAPOT, (&TEAPOT_COLORS, fog), draw)
        }
    }
}

/// Draws the pot of a state into a band of any colour: into one of RGB565 first, whose pixels become that colour.
pub fn convert<C: DrawnColor>(pot: DrawPot<'_>, words: &mut Words, band: &mut Band<'_, C>) {
    let area = band.bounding_box();
    // No error: there are words for all rows of the panel.
    let Ok(mut drawn) = Band::<Rgb565>::new(area, words) else {
        return;
    };
    drawn.fill(BACKGROUND.into());
    pot(&mut drawn);
    for (word, color) in band.words_mut().iter_mut().zip(drawn.colors()) {
        *word = C::from(color).to_word();
    }
}

/// Writes the coverage of each pixel of the panel by the pot of a state into a mask; nothing where there is no pot.
///
/// # Errors
/// Those of the scene.
pub fn cover(state: &State, mask: &mut [u8; WIDTH * HEIGHT]) -> Result<(), InputError> {
    mask.fill(0);
    match state.pot {
        Pot::None => Ok(()),
        Pot::Silhouettes => {
            let surface = TEAPOT.with_neighbours(&TEAPOT_NEIGHBOURS);
            covered::<Whole<OnePass<Antialiased<Gray8>>>>(state, surface, mask)
        }
        _ => covered::<Whole<OnePass<Gray8>>>(state, TEAPOT, mask),
    }
}

/// Calls with both ends of each edge of the faces of the pot that are turned to the viewer, clockwise, in 1/256 pixel.
///
/// # Errors
/// Those of the scene.
pub fn edges(state: &State, edge: &mut dyn FnMut([i32; 2], [i32; 2])) -> Result<(), InputError> {
    if state.pot == Pot::None {
        return Ok(());
    }
    with_prepared::<Whole<OnePass<Gray8>>>(state, TEAPOT, WHITE, &mut |pot| {
        for face in pot.faces() {
            let corners @ [a, b, c] = face.corners.map(|corner| units(corner.point));
            if is_clockwise(corners) {
                edge(a, b);
                edge(b, c);
                edge(c, a);
            }
        }
    })
}

/// A position in 1/256 pixel.
fn units(point: SubPoint<Sub4>) -> [i32; 2] {
    [point.x_units(), point.y_units()].map(|units| units * 16)
}

/// Whether corners run clockwise on the screen, as those of a face do that is turned to the viewer.
fn is_clockwise([a, b, c]: [[i32; 2]; 3]) -> bool {
    let [[x1, y1], [x2, y2]] = [b, c].map(|[x, y]| [x - a[0], y - a[1]].map(i64::from));
    x1 * y2 > x2 * y1
}

/// Draws the pot in white into a mask that is black.
fn covered<L>(state: &State, mesh: FaceSet<'_>, mask: &mut [u8; WIDTH * HEIGHT]) -> Result<(), InputError>
where
    L: Look<Color = Gray8>,
    L::Shading: for<'a> Shading<Skin<'a> = &'a [Gray8]>,
{
    with_prepared::<L>(state, mesh, WHITE, &mut |pot| {
        // No error: the mask has a byte for each pixel of the panel.
        if let Ok(mut band) = Band::<Gray8>::new(AREA, mask) {
            pot.draw(&mut band);
        }
    })
}

/// Draws the pot in a look.
#[inline(never)]
fn prepared<'a, L: Look<Color = Rgb565>>(
    state: &State,
    mesh: FaceSet<'a>,
    skin: <L::Shading as Shading>::Skin<'a>,
    draw: &mut dyn FnMut(DrawPot<'_>),
) -> Result<(), InputError> {
    with_prepared::<L>(state, mesh, skin, &mut |pot| draw(&mut |band| pot.draw(band)))
}

/// Prepares the pot in a look and calls with it.
fn with_prepared<'a, L: Look>(
    state: &State,
    mesh: FaceSet<'a>,
    skin: <L::Shading as Shading>::Skin<'a>,
    call: &mut dyn FnMut(&mut Prepared<'_, '_, L>),
) -> Result<(), InputError> {
    let mut memory = Memory::<L, VERTICES, FACES, WIDTH, HEIGHT, ACTIVE>::new();
    let camera = Camera::new(AREA, NEAR)?;
    let rotation = Rotation::about_x(angle(state.tilt)).then(&Rotation::about_y(angle(state.turn)));
    let pose = Pose::new(rotation, [I16F16::ZERO, I16F16::ZERO, DISTANCE]);
    let models = [Model::<L::Shading>::with_skin(mesh, skin)?.with_pose(pose)];
    let mut pot = memory.prepare(&camera, &models)?;
    call(&mut pot);
    Ok(())
}

/// An angle in steps of 1/512 of a turn.
fn angle(steps: u32) -> U0F16 {
    U0F16::from_bits((steps % 512 * 128) as u16)
}
