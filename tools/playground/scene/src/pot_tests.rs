//! The teapot of the playground against that of the gallery, and in all poses.

extern crate std;

use core::convert::Infallible;
use std::{boxed::Box, format, string::String, vec::Vec};

use embedded_graphics::pixelcolor::Rgb565;
use zrow::band::{Band, LittleEndian};
use zrow_scenes::{Scene, teapots::TexturedTeapot};

use crate::{Playground, Pot, WIDTH};

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
    }
}
