//! Panels of 240 x 320 pixels through one row: a frame of a scene, or what changes in a picture. What cannot be drawn ends the
//! emulation as failed.

use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Rgb565, primitives::Rectangle};
use zrow::{
    band::{Band, PictureLoop},
    draw::Picture,
};
use zrow_scenes::{Prepared as _, Scene};

use crate::report;

/// Prepares a frame, draws it row by row, and hands on every row.
#[inline(always)]
pub fn draw_frame<S: Scene<Color = Rgb565>>(scene: &mut S, frame: u32, row: &mut [u16], output: impl FnMut(&[u16])) {
    let Ok(mut prepared) = scene.prepare(frame) else {
        report::exit(false)
    };
    draw_rows(S::picture(), row, output, |band| prepared.draw(band));
}

/// Draws an area of a picture, and hands on every row of it.
#[inline(always)]
pub fn draw_area(
    picture: &mut Picture<'_, 'static, Rgb565>,
    (area, background): (Rectangle, Rgb565),
    row: &mut [u16],
    output: impl FnMut(&[u16]),
) {
    draw_rows(PictureLoop::new(area, background), row, output, |band| {
        picture.draw(band)
    });
}

/// Draws what has changed in a picture, and hands on every row of it.
#[inline(always)]
pub fn draw_changes(
    picture: &mut Picture<'_, 'static, Rgb565>,
    background: Rgb565,
    row: &mut [u16],
    mut output: impl FnMut(&[u16]),
) {
    while let Some(area) = picture.next_damage() {
        draw_area(picture, (area, background), row, &mut output);
    }
}

#[inline(always)]
fn draw_rows(
    bands: PictureLoop<Rgb565>,
    row: &mut [u16],
    mut output: impl FnMut(&[u16]),
    draw: impl FnMut(&mut Band<'_, Rgb565>),
) {
    let mut sink = |band: Band<'_, _>| -> Result<(), Infallible> {
        output(band.words());
        Ok(())
    };
    if bands.draw(row, &mut sink, draw).is_err() {
        report::exit(false)
    }
}
