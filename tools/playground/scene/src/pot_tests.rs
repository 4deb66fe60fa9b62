//! The teapot of the playground against that of the gallery, and in all poses.

extern crate std;

use core::convert::Infallible;
use std::{boxed::Box, format, string::String, vec::Vec};

use embedded_graphics::pixelcolor::{IntoStorage, Rgb565};
use zrow::{
    band::{Band, LittleEndian},
    coverage::InsideArea,
    draw::{AntialiasedPolygon, FillRule, SubOutline},
    geometry::{TooSmall, Window},
};
use zrow_scenes::{Scene, teapots::TexturedTeapot};

use crate::{BACKGROUND, HEIGHT, POT_EDGES, Playground, Pot, WIDTH};

/// Draws a state of an RGB565 panel.
fn drawn(playground: &mut Playground, address: &str) -> Vec<u16> {
    playground.prepare(address).unwrap();
    let mut words = Vec::new();
    playground
        .draw::<Rgb565, _>(|band: Band<'_, Rgb565, LittleEndian>| {
            words.extend_from_slice(band.words());
            Ok::<_, Infallible>(())
        })
        .unwrap();
    words
}

fn pot(pot: Pot, turn: u32, tilt: u32, depth: &str) -> String {
    format!("pot={}&turn={turn}&tilt={tilt}&rows=1&depth={depth}", pot.name())
}

#[test]
fn the_textured_pot_is_that_of_the_gallery() {
    let mut playground = Box::new(Playground::new());
    let mut scene = Box::<TexturedTeapot>::default();
    for frame in [0, 7, TexturedTeapot::PORTRAIT] {
        let mut expected = Vec::new();
        let mut prepared = scene.prepare(frame).unwrap();
        let mut sink = |band: Band<'_, Rgb565, LittleEndian>| {
            expected.extend_from_slice(band.words());
            Ok::<_, Infallible>(())
        };
        TexturedTeapot::picture()
            .draw(&mut [0; WIDTH], &mut sink, |band| prepared.draw(band))
            .unwrap();
        let address = pot(Pot::Textured, frame * 16 % 512, frame * 8 % 512, "rgb565");
        assert!(drawn(&mut playground, &address) == expected, "frame {frame}");
    }
}

/// The pot is drawn in RGB565, whatever the colours of the panel are: between 8 bits a channel and those, nothing is lost.
#[test]
fn colours_come_back_from_another_panel() {
    let mut playground = Box::new(Playground::new());
    let [direct, dithered] =
        ["rgb565", "dithered_rgb565"].map(|depth| drawn(&mut playground, &pot(Pot::Textured, 30, 8, depth)));
    assert!(direct == dithered);
}

#[test]
fn every_pose_has_slots_for_its_faces() {
    let mut playground = Box::new(Playground::new());
    for pose in 0..32 * 32 {
        let (turn, tilt) = (pose % 32 * 16, pose / 32 * 16);
        let address = pot(Pot::Flat, turn, tilt, "rgb565");
        playground.prepare(&address).unwrap();
        let drawn = playground.draw::<Rgb565, _>(|_: Band<'_, Rgb565, LittleEndian>| Ok::<_, Infallible>(()));
        assert!(drawn.is_ok(), "{address}: {drawn:?}");
        let mut count = 0;
        playground.pot_edges(&mut |_, _| count += 1).unwrap();
        assert!((1..=POT_EDGES).contains(&count), "{address}: {count} edges");
    }
}

/// Turns and tilts in which the pot is seen from the side, from above, from below and through its handle.
const POSES: [[u32; 2]; 5] = [[496, 504], [0, 0], [100, 448], [300, 64], [128, 500]];

/// The mask of the coverage by the pot.
fn mask(playground: &Playground) -> Box<[u8; WIDTH * HEIGHT]> {
    let mut mask = Box::new([0; WIDTH * HEIGHT]);
    playground.cover_pot(&mut mask).unwrap();
    mask
}

#[test]
fn what_is_covered_is_what_the_picture_shows() {
    let mut playground = Box::new(Playground::new());
    let background = Rgb565::from(BACKGROUND).into_storage();
    for [turn, tilt] in POSES {
        for look in [Pot::Flat, Pot::FlatLit, Pot::Gouraud, Pot::Textured, Pot::Silhouettes] {
            let words = drawn(&mut playground, &pot(look, turn, tilt, "rgb565"));
            let mask = mask(&playground);
            // A pixel that is hardly covered may have the colour of the background.
            let differs = |(word, coverage): (&u16, &u8)| match *coverage {
                0 => *word != background,
                1..64 => false,
                _ => *word == background,
            };
            let different = words.iter().zip(&*mask).position(differs);
            assert_eq!(different, None, "{look:?} {turn} {tilt}");
            assert!(mask.contains(&255));
        }
    }
    let address = pot(Pot::None, 0, 0, "rgb565");
    drawn(&mut playground, &address);
    assert!(!mask(&playground).iter().any(|coverage| *coverage > 0));
    playground.pot_edges(&mut |_, _| panic!("there is no pot")).unwrap();
}

/// The faces that are turned to the viewer, as one outline: what one of them hides of another counts once.
struct Faces<'p>(&'p Playground);

impl SubOutline for Faces<'_> {
    fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        self.0.pot_edges(edge).unwrap();
    }

    fn is_simple(&self) -> bool {
        false
    }
}

/// The exact area of the faces that are turned to the viewer, in 1/255 of each pixel, by the method for items.
fn area(playground: &Playground) -> Vec<u8> {
    let mut polygon = Box::new(AntialiasedPolygon::<POT_EDGES, POT_EDGES>::empty());
    polygon.set_up(&Faces(playground), FillRule::NonZero).unwrap();
    let mut area = std::vec![0; WIDTH * HEIGHT];
    let window = Window {
        left: 0,
        top: 0,
        right: WIDTH as i32,
        bottom: HEIGHT as i32,
    };
    let mut cells = std::vec![Default::default(); WIDTH + 2];
    polygon
        .cover(&InsideArea, &window, &mut cells, |span, coverage| {
            let first = span.y as usize * WIDTH;
            area[first + span.start as usize..first + span.end as usize].fill(coverage);
            Ok::<_, TooSmall>(())
        })
        .unwrap();
    area
}

/// Silhouettes are antialiased by their exact area, but where two of them at different depths pass through the same pixel, which
/// are taken for one.
#[test]
fn silhouettes_cover_the_area_of_the_faces() {
    let mut playground = Box::new(Playground::new());
    for [turn, tilt] in POSES {
        let mut errors_of = |look| {
            playground.prepare(&pot(look, turn, tilt, "rgb565")).unwrap();
            let (mask, area) = (mask(&playground), area(&playground));
            let of_edges = mask.iter().zip(&area).filter(|(_, area)| (1..255).contains(*area));
            let errors: Vec<u8> = of_edges.map(|(mask, area)| mask.abs_diff(*area)).collect();
            // Beside the edges nothing differs by more than what is rounded.
            let elsewhere = mask.iter().zip(&area).filter(|(_, area)| [0, 255].contains(*area));
            assert!(elsewhere.clone().all(|(mask, area)| mask.abs_diff(*area) <= 1));
            errors
        };
        let [smooth, jagged] = [Pot::Silhouettes, Pot::Flat].map(&mut errors_of);
        let of_two = smooth.iter().filter(|error| **error > 2).count();
        assert!(of_two * 6 < smooth.len(), "{turn} {tilt}: {of_two} of {}", smooth.len());
        let sum = |errors: &[u8]| errors.iter().map(|error| u32::from(*error).pow(2)).sum::<u32>();
        assert!(sum(&smooth) * 20 < sum(&jagged), "{turn} {tilt}");
    }
}
