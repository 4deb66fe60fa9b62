//! Rotated bands against the picture rotated pixel by pixel, and the band that reports the picture's box.

use std::{collections::BTreeMap, convert::Infallible};

use embedded_graphics::{
    Pixel,
    pixelcolor::{BinaryColor, Rgb565, Rgb888},
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
};
use zrow::band::{
    Band, BigEndian, BytesSink, LittleEndian, LoopError, Order, OverlappingSink, PanelRotation, PictureLoop,
    Supersampling,
};

use crate::{
    overlapping_loops::block_on,
    picture_loop::{AREA, ROWS, SceneColor, full_frame, scene},
};

/// A rotation by so many quarter turns.
fn rotation(turns: i32, picture: Rectangle) -> PanelRotation {
    match turns {
        1 => PanelRotation::by_90(picture),
        2 => PanelRotation::by_180(picture),
        _ => PanelRotation::by_270(picture),
    }
}

/// The position of a pixel of a picture that is rotated clockwise by so many quarter turns.
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

/// The pixels of the panel by row and column.
#[derive(Debug, PartialEq)]
struct Panel<C>(BTreeMap<(i32, i32), C>);

impl<C: SceneColor> Panel<C> {
    fn show<O: Order>(&mut self, band: Band<'_, C, O>) {
        for (point, color) in band.bounding_box().points().zip(band.colors()) {
            assert_eq!(self.0.insert((point.y, point.x), color), None, "sent once");
        }
    }
}

/// A transfer owns its buffer, and shows it at the end.
impl OverlappingSink<Rgb565, BigEndian, Vec<u16>> for Panel<Rgb565> {
    type Transfer = (Rectangle, Vec<u16>);
    type Error = Infallible;

    fn start(
        &mut self,
        area: Rectangle,
        buffer: Vec<u16>,
    ) -> Result<Self::Transfer, (Vec<u16>, LoopError<Infallible>)> {
        Ok((area, buffer))
    }

    fn finish(&mut self, (area, mut buffer): Self::Transfer) -> (Vec<u16>, Result<(), Infallible>) {
        self.show(Band::<_, BigEndian>::new(area, &mut buffer).unwrap());
        (buffer, Ok(()))
    }
}

/// The panel with a part of a picture, rotated pixel by pixel.
fn expected<C: SceneColor, O: Order>(turns: i32, part: Rectangle, picture: Rectangle) -> Panel<C> {
    let pixels = part
        .points()
        .map(|point| turned(point, turns, picture))
        .map(|point| (point.y, point.x))
        .zip(full_frame::<C, O>(part))
        .collect();
    Panel(pixels)
}

/// A loop over a part of a picture, and a buffer for it.
fn loop_of<C: SceneColor, O: Order>(part: Rectangle, rows: u32) -> (PictureLoop<C, O>, Vec<C::Word>) {
    let picture_loop = PictureLoop::new(part, C::COLORS[0]).rows(rows).in_order::<O>();
    let buffer = vec![C::COLORS[3].to_word(); picture_loop.words_needed()];
    (picture_loop, buffer)
}

/// The scene, and the band rotated after it.
fn rotated_scene<C: SceneColor, O: Order>(rotation: PanelRotation) -> impl FnMut(&mut Band<'_, C, O>) {
    move |band| {
        scene(band);
        rotation.rotate(band);
    }
}

/// All pixels of a picture that was rotated: sent at once, and by futures.
fn check<C: SceneColor, O: Order>(part: Rectangle, picture: Rectangle) {
    for turns in 1..=3 {
        let expected = expected::<C, O>(turns, part, picture);
        let rotation = rotation(turns, picture);
        for rows in ROWS {
            let (picture_loop, mut buffer) = loop_of::<C, O>(part, rows);
            let mut panel = Panel(BTreeMap::new());
            let mut sink = |band: Band<'_, C, O>| {
                panel.show(band);
                Ok::<(), Infallible>(())
            };
            picture_loop
                .draw(&mut buffer, &mut sink, rotated_scene(rotation))
                .unwrap();
            assert!(panel == expected, "{turns} quarter turns, {rows} rows");

            let (mut sent, mut other) = (Vec::new(), buffer.clone());
            let send = async |area: Rectangle, bytes: &[u8]| {
                sent.push((area, bytes.to_vec()));
                Ok::<(), Infallible>(())
            };
            block_on(picture_loop.draw_async([&mut buffer, &mut other], send, rotated_scene(rotation))).unwrap();
            for (area, bytes) in &sent {
                assert!(
                    *bytes == bytes_of::<C, O>(&expected, *area),
                    "{turns} quarter turns, {rows} rows"
                );
            }
            let pixels: u32 = sent.iter().map(|(area, _)| area.size.width * area.size.height).sum();
            assert_eq!(pixels as usize, expected.0.len());
        }
    }
}

/// The bytes of an area of a panel, row by row.
fn bytes_of<C: SceneColor, O: Order>(panel: &Panel<C>, area: Rectangle) -> Vec<u8> {
    let mut words: Vec<_> = area
        .points()
        .map(|point| Band::<C, O>::word(panel.0[&(point.y, point.x)]))
        .collect();
    Band::<C, O>::new(area, &mut words).unwrap().into_bytes().to_vec()
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
fn bands_are_rotated_before_a_transfer_takes_them() {
    for turns in 1..=3 {
        let expected = expected::<Rgb565, BigEndian>(turns, AREA, AREA);
        for rows in ROWS {
            let (picture_loop, buffer) = loop_of::<Rgb565, BigEndian>(AREA, rows);
            let (mut panel, buffers) = (Panel(BTreeMap::new()), [buffer.clone(), buffer]);
            let scene = rotated_scene(rotation(turns, AREA));
            let (_, result) = picture_loop.draw_overlapping(buffers, &mut panel, scene);
            result.unwrap();
            assert!(panel == expected, "{turns} quarter turns, {rows} rows");
        }
    }
}

#[test]
fn eight_rows_become_whole_bytes_of_an_upright_e_paper() {
    let picture = Rectangle::new(Point::zero(), Size::new(3, 16));
    let mut sent = Vec::new();
    let mut sink = BytesSink(|area: Rectangle, bytes: &[u8]| {
        sent.push((area, bytes.to_vec()));
        Ok::<(), Infallible>(())
    });
    let pixels = [(0, 0), (1, 1), (2, 7), (0, 8)].map(|(x, y)| Pixel(Point::new(x, y), BinaryColor::On));
    PictureLoop::new(picture, BinaryColor::Off)
        .rows(8)
        .draw(&mut [0; 24], &mut sink, |band| {
            let Ok(()) = band.draw_iter(pixels);
            PanelRotation::by_270(picture).rotate(band);
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
            let mut pixels = 0;
            let mut sink = |band: Band<'_, Rgb565>| {
                let Size { width, height } = band.bounding_box().size;
                assert_eq!(band.words().len(), (width * height) as usize);
                pixels += band.into_bytes().len() / 2;
                Ok::<(), Infallible>(())
            };
            PictureLoop::new(picture, Rgb565::RED)
                .rows(4)
                .draw(&mut [0; 16], &mut sink, |band| rotation(turns, picture).rotate(band))
                .unwrap();
            let expected = if sent || turns == 2 { 8 } else { 0 };
            assert_eq!(pixels, expected, "{picture:?}, {turns} quarter turns");
        }
    }
}

/// A picture with four samples a pixel, whose finished rows go through `send`.
fn supersampled(
    picture: Rectangle,
    rows: u32,
    mut send: impl FnMut(Band<'_, Rgb565>),
    draw: impl FnMut(&mut Band<'_, Rgb565>),
) {
    type Smooth = Supersampling<Rgb565, 2>;
    let picture_loop = Smooth::new(picture, Rgb565::BLACK).unwrap().rows(rows);
    let mut samples = vec![0; picture_loop.words_needed()];
    let mut sums = vec![0; Smooth::sums_needed(picture.size.width as usize)];
    let mut sink = |band: Band<'_, Rgb565>| {
        send(band);
        Ok::<(), Infallible>(())
    };
    picture_loop.draw(&mut samples, &mut sums, &mut sink, draw).unwrap();
}

/// A closure around the sink rotates what is sent.
#[test]
fn supersampled_rows_are_rotated_on_their_way_to_the_sink() {
    let draw = |band: &mut Band<'_, Rgb565>| {
        let disc = Circle::new(AREA.top_left * 2 + Point::new(7, 3), 61);
        let Ok(()) = disc.into_styled(PrimitiveStyle::with_fill(Rgb565::YELLOW)).draw(band);
    };
    let mut upright = Panel(BTreeMap::new());
    supersampled(AREA, 1, |band| upright.show(band), draw);
    for turns in 1..=3 {
        let expected = upright.0.iter().map(|(&(y, x), &color)| {
            let point = turned(Point::new(x, y), turns, AREA);
            ((point.y, point.x), color)
        });
        let expected = Panel(expected.collect());
        for rows in ROWS {
            let mut panel = Panel(BTreeMap::new());
            let send = |mut band: Band<'_, Rgb565>| {
                rotation(turns, AREA).rotate(&mut band);
                panel.show(band);
            };
            supersampled(AREA, rows, send, draw);
            assert!(panel == expected, "{turns} quarter turns, {rows} rows");
        }
    }
}

/// A scene that rotates its samples, by boxes that bring them to the ends of the number range, and beyond.
#[test]
fn rotated_samples_are_left_out_wherever_they_would_be() {
    // Two samples a pixel: from -8 to 114 in x.
    let lefts = (-12..-4).chain(48..56).chain([i32::MIN, 0, i32::MAX]);
    let tops = [i32::MIN, i32::MIN + 1, 0, i32::MAX - 124, i32::MAX - 122, i32::MAX];
    let corners = lefts.flat_map(|left| tops.map(|top| Point::new(left, top)));
    let boxes: Vec<_> = corners
        .map(|corner| Rectangle::new(corner, Size::new(64, 64)))
        .chain([AREA])
        .collect();
    for area in [AREA, AREA.translate(Point::new(0, -40))] {
        for (picture, rows) in boxes.iter().flat_map(|&picture| [1, 16].map(|rows| (picture, rows))) {
            for turns in 1..=3 {
                let (mut bands, mut sent) = (0, 0);
                let send = |band: Band<'_, Rgb565>| {
                    let row = band.bounding_box();
                    assert!(row.size.height == 1 && row.size.width == area.size.width, "{row:?}");
                    assert_eq!(row.intersection(&area), row);
                    sent += 1;
                };
                supersampled(area, rows, send, |band| {
                    bands += 1;
                    rotation(turns, picture).rotate(band);
                });
                assert!(bands > 0 && sent <= area.size.height, "{sent} rows from {bands} bands");
            }
        }
    }
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
