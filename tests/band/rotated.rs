//! Rotated bands against the picture rotated pixel by pixel, and the band that reports the picture's box.

use std::{collections::BTreeMap, convert::Infallible};

use embedded_graphics::{
    Pixel,
    pixelcolor::{BinaryColor, Rgb565, Rgb888},
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
};
use zrow::band::{Band, BigEndian, BytesSink, LittleEndian, LoopError, Order, PictureLoop, Rotated};

use crate::picture_loop::{AREA, ROWS, Recorder, SceneColor, full_frame, scene};

/// The sink after so many quarter turns.
fn rotated<S>(turns: i32, picture: Rectangle, sink: S) -> Rotated<S> {
    match turns {
        1 => Rotated::by_90(picture, sink),
        2 => Rotated::by_180(picture, sink),
        _ => Rotated::by_270(picture, sink),
    }
}

/// Where a pixel of a picture is after so many quarter turns.
fn turned(point: Point, turns: i32, picture: Rectangle) -> Point {
    let Size { width, height } = picture.size;
    let (Point { x, y }, right, bottom) = (point - picture.top_left, width as i32 - 1, height as i32 - 1);
    picture.top_left
        + match turns {
            1 => Point::new(bottom - y, x),
            2 => Point::new(right - x, bottom - y),
            _ => Point::new(y, right - x),
        }
}

/// All pixels of a picture that went through the rotation, by position.
fn check<C: SceneColor, O: Order>(part: Rectangle, picture: Rectangle) {
    let full = full_frame::<C, O>(part);
    for turns in 1..=3 {
        let expected: BTreeMap<_, _> = part
            .points()
            .map(|point| turned(point, turns, picture))
            .map(|point| (point.y, point.x))
            .zip(full.iter().copied())
            .collect();
        for rows in ROWS {
            let picture_loop = PictureLoop::new(part, C::COLORS[0]).rows(rows).in_order::<O>();
            let mut words = vec![C::COLORS[3].to_word(); picture_loop.words_needed()];
            let mut pixels = BTreeMap::new();
            let sink = |band: Band<'_, C, O>| {
                for (point, color) in band.bounding_box().points().zip(band.colors()) {
                    assert_eq!(pixels.insert((point.y, point.x), color), None, "sent once");
                }
                Ok::<(), Infallible>(())
            };
            picture_loop
                .draw(&mut words, &mut rotated(turns, picture, sink), scene::<C, O>)
                .unwrap();
            assert!(pixels == expected, "{turns} quarter turns, {rows} rows");
        }
    }
}

#[test]
fn bands_of_any_height_give_the_rotated_picture() {
    check::<Rgb565, LittleEndian>(AREA, AREA);
    check::<Rgb565, BigEndian>(AREA, AREA);
    check::<Rgb888, LittleEndian>(AREA, AREA);
    check::<BinaryColor, LittleEndian>(AREA, AREA);
    // A part of the picture, as where only that has changed; one column; no pixel.
    check::<Rgb565, LittleEndian>(Rectangle::new(Point::new(3, 9), Size::new(20, 17)), AREA);
    check::<Rgb565, LittleEndian>(Rectangle::new(Point::new(3, 9), Size::new(1, 17)), AREA);
    check::<Rgb565, LittleEndian>(Rectangle::new(Point::new(3, 9), Size::new(0, 17)), AREA);
}

#[test]
fn eight_rows_become_whole_bytes_of_an_upright_e_paper() {
    let picture = Rectangle::new(Point::zero(), Size::new(3, 16));
    let mut sent = Vec::new();
    let sink = BytesSink(|area: Rectangle, bytes: &[u8]| {
        sent.push((area, bytes.to_vec()));
        Ok::<(), Infallible>(())
    });
    let pixels = [(0, 0), (1, 1), (2, 7), (0, 8)].map(|(x, y)| Pixel(Point::new(x, y), BinaryColor::On));
    PictureLoop::new(picture, BinaryColor::Off)
        .rows(8)
        .draw(&mut [0; 24], &mut Rotated::by_270(picture, sink), |band| {
            band.draw_iter(pixels)
        })
        .unwrap();
    let area = |left| Rectangle::new(Point::new(left, 0), Size::new(8, 3));
    assert_eq!(
        sent,
        [(area(0), vec![0x01, 0x40, 0x80]), (area(8), vec![0x00, 0x00, 0x80])]
    );
}

#[test]
fn a_picture_at_the_end_of_the_number_range_is_left_out() {
    for (picture, sent) in [
        (Rectangle::new(Point::new(i32::MAX - 4, 0), Size::new(4, 2)), true),
        (Rectangle::new(Point::new(i32::MAX - 2, 0), Size::new(2, 4)), false),
        (Rectangle::new(Point::new(0, i32::MAX - 2), Size::new(4, 2)), false),
        (Rectangle::new(Point::new(i32::MIN, i32::MIN), Size::new(4, 2)), true),
    ] {
        for turns in 1..=3 {
            let mut bands = 0;
            let sink = |_: Band<'_, Rgb565>| {
                bands += 1;
                Ok::<(), Infallible>(())
            };
            PictureLoop::new(picture, Rgb565::RED)
                .rows(4)
                .draw(&mut [0; 16], &mut rotated(turns, picture, sink), |_| {})
                .unwrap();
            assert_eq!(bands > 0, sent || turns == 2, "{picture:?}, {turns} quarter turns");
        }
    }
}

#[test]
fn an_error_of_the_other_sink_comes_through() {
    let mut sink = Rotated::by_90(AREA, Recorder::failing_at(2));
    let result = PictureLoop::new(AREA, Rgb565::RED).draw(&mut [0; 61], &mut sink, |_: &mut Band<'_, Rgb565>| {});
    assert_eq!(result, Err(LoopError::Sink("unplugged")));
}

/// A layout by the box of the target, in bands of any height.
#[test]
fn a_band_in_a_picture_is_laid_out_as_the_picture() {
    fn layout<D: DrawTarget<Color = Rgb565>>(target: &mut D) -> Result<(), D::Error> {
        let area = target.bounding_box();
        target.clear(Rgb565::BLUE)?;
        Circle::with_center(area.center(), 19)
            .into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 3))
            .draw(target)?;
        let corner = Rectangle::new(area.bottom_right().unwrap() - Point::new(5, 5), Size::new(6, 6));
        target.fill_solid(&corner, Rgb565::GREEN)?;
        target.fill_contiguous(&corner, [Rgb565::WHITE; 9])?;
        Pixel(area.top_left, Rgb565::YELLOW).draw(target)
    }
    let mut whole = vec![0; 61 * 45];
    let mut band = Band::<Rgb565>::new(AREA, &mut whole).unwrap();
    let Ok(()) = layout(&mut band);
    for rows in ROWS {
        let picture_loop = PictureLoop::new(AREA, Rgb565::BLACK).rows(rows);
        let (mut words, mut sent) = (vec![0; picture_loop.words_needed()], Vec::new());
        let mut sink = |band: Band<'_, Rgb565>| {
            sent.extend_from_slice(band.words());
            Ok::<(), Infallible>(())
        };
        picture_loop
            .draw(&mut words, &mut sink, |band| layout(&mut band.in_picture(AREA)))
            .unwrap();
        assert!(sent == whole, "{rows} rows");
    }
}
