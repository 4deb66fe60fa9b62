//! Pictures in bands whose words are stored with either byte first: the same colours.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use fixed::types::I16F16;
use zrow::{
    band::{Band, BigEndian, LittleEndian, Order},
    scene::{Camera, FaceSet, Memory, Model},
    visible::DepthSort,
};

use crate::numbered_scene::area;

/// The pictures of a mesh by the depth row and by a method that paints.
fn pictures<O: Order>(mesh: FaceSet<'_>) -> [Vec<Rgb565>; 2] {
    let area = area(64, 64);
    let camera = Camera::new(area, I16F16::from_num(128)).unwrap();
    let colors = [Rgb565::RED, Rgb565::CSS_ORANGE, Rgb565::BLUE, Rgb565::CSS_DARK_CYAN];
    let models = [Model::new(mesh, &colors).unwrap()];
    let mut memory = Memory::<Rgb565, 12, 4, 64, 64>::new();
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let (mut by_row, mut by_sorting) = ([0; 64 * 64], [0; 64 * 64]);
    let mut band = Band::<Rgb565, O>::new(area, &mut by_row).unwrap();
    prepared.draw(&mut band);
    let mut painted = Band::<Rgb565, O>::new(area, &mut by_sorting).unwrap();
    prepared.draw_by(&mut DepthSort::<16, 16>::new(), &mut painted).unwrap();
    [band, painted].map(|band| band.colors().collect())
}

/// Spans that begin left of the picture or end right of it, in rows without depths.
#[test]
fn faces_beyond_the_sides_have_their_colours_in_either_order() {
    let vertices = [
        [[-2000, -512, 1024], [-2000, 512, 1024], [512, 0, 1024]],
        [[2000, 512, 1024], [2000, -512, 1024], [520, 0, 1024]],
        [[-512, 2000, 1024], [512, 2000, 1024], [0, 520, 1024]],
        [[512, -2000, 1024], [-512, -2000, 1024], [0, -520, 1024]],
    ];
    let faces = [[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11]];
    for count in 1..=faces.len() {
        let mesh = FaceSet::new(vertices.as_flattened(), &faces[..count]).unwrap();
        let expected = pictures::<LittleEndian>(mesh);
        let seen = expected[0].iter().filter(|color| **color != Rgb565::BLACK).count();
        assert!(seen > 150 * count, "{seen} pixels of {count} faces");
        assert_eq!(pictures::<BigEndian>(mesh), expected, "{count} faces");
    }
}
