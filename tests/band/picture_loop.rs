//! The picture loop and its sinks: banded drawing equals the full frame, and errors leave everything whole.

use std::convert::Infallible;

use embedded_graphics::{
    Pixel,
    image::{Image, ImageRaw},
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{
        Bgr565, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb888,
        raw::{RawData, ToBytes},
    },
    prelude::*,
    primitives::{self, Circle, Line, Rectangle, RoundedRectangle, Triangle},
    text::Text,
};
use zrow::{
    band::{Band, BandColor, BigEndian, BytesSink, DisplaySink, LittleEndian, LoopError, Order, PictureLoop, Sink},
    draw::{DrawOn, PrimitiveStyle},
    geometry::TooSmall,
};

pub const AREA: Rectangle = Rectangle::new(Point::new(-4, 3), Size::new(61, 45));
pub const ROWS: [u32; 5] = [1, 2, 7, 16, 45];

/// A colour with four values for the scene; the first is the background.
pub trait SceneColor: BandColor + From<BinaryColor> + core::fmt::Debug {
    const COLORS: [Self; 4];
}

macro_rules! scene_color {
    ($($color:ty: [$($value:expr),+];)+) => {$(
        impl SceneColor for $color {
            const COLORS: [Self; 4] = [$($value),+];
        }
    )+};
}

scene_color! {
    BinaryColor: [BinaryColor::Off, BinaryColor::On, BinaryColor::On, BinaryColor::On];
    Gray2: [Gray2::new(1), Gray2::new(3), Gray2::new(2), Gray2::new(0)];
    Gray4: [Gray4::new(1), Gray4::new(15), Gray4::new(7), Gray4::new(4)];
    Gray8: [Gray8::new(9), Gray8::new(255), Gray8::new(100), Gray8::new(50)];
    Rgb555: [Rgb555::BLACK, Rgb555::new(1, 2, 3), Rgb555::GREEN, Rgb555::YELLOW];
    Rgb565: [Rgb565::BLUE, Rgb565::new(1, 2, 3), Rgb565::GREEN, Rgb565::YELLOW];
    Bgr565: [Bgr565::BLUE, Bgr565::new(1, 2, 3), Bgr565::GREEN, Bgr565::YELLOW];
    Rgb888: [Rgb888::BLUE, Rgb888::new(1, 2, 3), Rgb888::GREEN, Rgb888::YELLOW];
}

/// Lines of ours; text, an image and shapes of embedded-graphics in its own styles. Some of it lies outside.
pub fn scene<C: SceneColor, O: Order>(band: &mut Band<'_, C, O>) {
    let [_, one, two, three] = C::COLORS;
    let style = primitives::PrimitiveStyleBuilder::new()
        .fill_color(two)
        .stroke_color(three)
        .stroke_width(2)
        .build();
    let Ok(()) = Circle::new(Point::new(20, 12), 27).into_styled(style).draw(band);
    let Ok(()) = Triangle::new(Point::new(-9, 30), Point::new(12, 44), Point::new(2, 60))
        .into_styled(style)
        .draw(band);
    band.draw(
        &RoundedRectangle::with_equal_corners(Rectangle::new(Point::new(40, 30), Size::new(30, 9)), Size::new(4, 3))
            .into_styled(style),
    );
    for (from, to) in [
        ((-4, 3), (56, 47)),
        ((-90, 20), (90, 11)),
        ((30, -400), (33, 400)),
        ((0, 0), (9, -9)),
    ] {
        let line = Line::new(from.into(), to.into()).into_styled(PrimitiveStyle::with_stroke(one, 1));
        let Ok(()) = line.draw_on(band);
    }
    let Ok(_) = Text::new("zrow\nrows", Point::new(-2, 12), MonoTextStyle::new(&FONT_6X10, three)).draw(band);
    const BITS: [u8; 6] = [
        0b1010_1010,
        0b1100_0011,
        0b1111_0000,
        0b0000_1111,
        0b0101_0101,
        0b1001_1001,
    ];
    let image = ImageRaw::<BinaryColor>::new(&BITS, 12);
    let Ok(()) = Image::new(&image, Point::new(50, 20)).draw(&mut band.color_converted());
}

/// The scene in one band that holds the whole picture.
pub fn full_frame<C: SceneColor, O: Order>(area: Rectangle) -> Vec<C> {
    let mut words = vec![C::COLORS[0].to_word(); (area.size.width * area.size.height) as usize];
    let mut band = Band::<C, O>::new(area, &mut words).unwrap();
    band.fill(C::COLORS[0]);
    scene(&mut band);
    band.colors().collect()
}

pub fn picture_loop<C: SceneColor, O: Order>(rows: u32) -> PictureLoop<C, O> {
    PictureLoop::new(AREA, C::COLORS[0]).rows(rows).in_order()
}

pub fn buffer<C: SceneColor, O: Order>(picture_loop: &PictureLoop<C, O>) -> Vec<C::Word> {
    // What was in the buffer must not show.
    vec![C::COLORS[3].to_word(); picture_loop.words_needed()]
}

fn check_equals_full_frame<C: SceneColor, O: Order>() {
    let expected = full_frame::<C, O>(AREA);
    assert!(
        C::COLORS.iter().all(|color| expected.contains(color)),
        "the scene shows every colour"
    );
    for rows in ROWS {
        let picture_loop = picture_loop::<C, O>(rows);
        let (mut picture, mut areas) = (Vec::new(), Vec::new());
        let mut sink = |band: Band<'_, C, O>| {
            areas.push(band.bounding_box());
            picture.extend(band.colors());
            Ok::<(), Infallible>(())
        };
        picture_loop
            .draw(&mut buffer(&picture_loop), &mut sink, scene::<C, O>)
            .unwrap();
        assert!(picture == expected, "{rows} rows");
        assert_eq!(areas, picture_loop.bands().collect::<Vec<_>>());
        let heights: Vec<u32> = areas.iter().map(|area| area.size.height).collect();
        let (last, others) = heights.split_last().unwrap();
        assert!(others.iter().all(|&height| height == rows));
        assert_eq!(*last, (45 - 1) % rows + 1, "the last band holds the rest");
    }
}

#[test]
fn bands_of_any_height_give_the_full_frame() {
    check_equals_full_frame::<Rgb565, LittleEndian>();
    check_equals_full_frame::<Rgb565, BigEndian>();
    check_equals_full_frame::<Bgr565, BigEndian>();
    check_equals_full_frame::<Rgb555, LittleEndian>();
    check_equals_full_frame::<Rgb888, LittleEndian>();
    check_equals_full_frame::<Rgb888, BigEndian>();
    check_equals_full_frame::<Gray8, LittleEndian>();
    check_equals_full_frame::<Gray4, BigEndian>();
    check_equals_full_frame::<Gray2, LittleEndian>();
    check_equals_full_frame::<BinaryColor, LittleEndian>();
}

#[test]
fn alignment_grows_outwards_and_rounds_the_rows_up() {
    let area = Rectangle::new(Point::new(-3, 5), Size::new(50, 36));
    let bands = |picture_loop: PictureLoop<Rgb565>| -> Vec<(i32, i32, u32, u32)> {
        picture_loop
            .bands()
            .map(|band| (band.top_left.x, band.top_left.y, band.size.width, band.size.height))
            .collect()
    };
    let picture_loop = PictureLoop::new(area, Rgb565::BLACK);
    let pages = vec![(-4, 0, 52, 16), (-4, 16, 52, 16), (-4, 32, 52, 16)];
    assert_eq!(bands(picture_loop.rows(9).aligned(4, 8)), pages);
    assert_eq!(bands(picture_loop.aligned(4, 8).rows(9)), pages);
    assert_eq!(picture_loop.aligned(4, 8).rows(9).words_needed(), 52 * 16);

    let pages: Vec<_> = (0..6).map(|page| (-3, page * 8, 50, 8)).collect();
    assert_eq!(bands(picture_loop.aligned(0, 8)), pages);
    let last_is_lower = vec![(-4, 5, 52, 20), (-4, 25, 52, 16)];
    assert_eq!(bands(picture_loop.aligned(2, 1).rows(20)), last_is_lower);
    assert_eq!(
        bands(picture_loop.aligned(2, 8).rows(32)).last(),
        Some(&(-4, 32, 52, 16))
    );
}

#[test]
fn the_buffer_must_hold_one_band_and_no_more() {
    let picture_loop = picture_loop::<Rgb565, _>(7);
    assert_eq!(picture_loop.words_needed(), 61 * 7);
    let mut words = vec![0; 61 * 7];
    let mut sink = |_: Band<'_, Rgb565>| Ok::<(), Infallible>(());
    assert_eq!(picture_loop.draw(&mut words, &mut sink, scene), Ok(()));
    words.pop();
    let needed = TooSmall::Words(61 * 7);
    assert_eq!(
        picture_loop.draw(&mut words, &mut sink, |_| -> () {
            panic!("drawn into a buffer that is too small")
        }),
        Err(LoopError::TooSmall(needed))
    );
    let (buffers, result) = picture_loop.draw_overlapping([vec![0; 61 * 7], words.clone()], &mut sink, |_| -> () {
        panic!("drawn although one buffer is too small")
    });
    assert_eq!(result, Err(LoopError::TooSmall(needed)));
    assert_eq!(buffers.map(|buffer| buffer.len()), [61 * 7, 61 * 7 - 1]);
    assert_eq!(Band::<Rgb565>::new(AREA, &mut words).unwrap_err().needed(), 61 * 45);
    // The whole picture is lower than the band: it is enough for that.
    assert_eq!(picture_loop.rows(1000).words_needed(), 61 * 45);
    assert_eq!(
        PictureLoop::new(Rectangle::zero(), Rgb565::BLACK)
            .rows(9)
            .words_needed(),
        0
    );
}

#[test]
fn an_empty_area_sends_nothing() {
    let picture_loop = PictureLoop::new(Rectangle::new(Point::new(3, 3), Size::new(0, 9)), Rgb565::BLACK);
    let mut sink = |_: Band<'_, Rgb565>| Err("sent");
    assert_eq!(
        picture_loop.draw(&mut [], &mut sink, |_| -> () { panic!("drawn") }),
        Ok(())
    );
}

/// A sink that keeps the picture and fails at one band of the first picture.
pub struct Recorder<C> {
    picture: Vec<C>,
    sent: usize,
    fails_at: Option<usize>,
}

impl<C> Recorder<C> {
    pub fn failing_at(band: usize) -> Self {
        Self {
            picture: Vec::new(),
            sent: 0,
            fails_at: Some(band),
        }
    }
}

impl<C: BandColor, O: Order> Sink<C, O> for Recorder<C> {
    type Error = &'static str;

    fn send(&mut self, band: Band<'_, C, O>) -> Result<(), &'static str> {
        if self.fails_at == Some(self.sent) {
            self.fails_at = None;
            return Err("unplugged");
        }
        self.sent += 1;
        self.picture.extend(band.colors());
        Ok(())
    }
}

#[test]
fn a_sink_that_fails_stops_the_loop_and_the_next_picture_is_whole() {
    let picture_loop = picture_loop::<Rgb565, _>(7);
    let mut words = buffer(&picture_loop);
    for fails_at in [0, 3, 6] {
        let mut sink = Recorder::failing_at(fails_at);
        let mut drawn = 0;
        let result = picture_loop.draw(&mut words, &mut sink, |band: &mut Band<'_, Rgb565>| {
            drawn += 1;
            scene(band);
        });
        assert_eq!(result, Err(LoopError::Sink("unplugged")));
        assert_eq!(
            (sink.sent, drawn),
            (fails_at, fails_at + 1),
            "nothing is drawn or sent after the failure"
        );
        sink.picture.clear();
        assert_eq!(
            picture_loop.draw(&mut words, &mut sink, scene::<Rgb565, LittleEndian>),
            Ok(())
        );
        assert!(sink.picture == full_frame::<Rgb565, LittleEndian>(AREA));
    }
}

/// A display that counts how it is written to.
struct Counting {
    area: Rectangle,
    picture: Vec<Rgb565>,
    fills: Vec<Rectangle>,
}

impl Dimensions for Counting {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Counting {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, _: I) -> Result<(), Infallible> {
        panic!("a band goes out in one piece");
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        self.fills.push(*area);
        self.picture.extend(colors);
        Ok(())
    }

    fn fill_solid(&mut self, _: &Rectangle, _: Rgb565) -> Result<(), Infallible> {
        panic!("a band goes out in one piece");
    }
}

#[test]
fn a_display_gets_one_fill_contiguous_a_band() {
    for rows in ROWS {
        let mut display = Counting {
            area: AREA,
            picture: Vec::new(),
            fills: Vec::new(),
        };
        let picture_loop = picture_loop(rows);
        picture_loop
            .draw(
                &mut buffer(&picture_loop),
                &mut DisplaySink(&mut display),
                scene::<Rgb565, BigEndian>,
            )
            .unwrap();
        assert!(display.picture == full_frame::<Rgb565, LittleEndian>(AREA));
        assert_eq!(display.fills, picture_loop.bands().collect::<Vec<_>>());
    }
}

/// The bytes of a row as the documentation of `into_bytes` describes them, pixel by pixel.
fn packed_row<C>(row: &[C]) -> Vec<u8>
where
    C: SceneColor + ToBytes + Into<<C as PixelColor>::Raw>,
    <C as ToBytes>::Bytes: AsRef<[u8]>,
    u32: From<<<C as PixelColor>::Raw as RawData>::Storage>,
{
    let bits = <C as PixelColor>::Raw::BITS_PER_PIXEL;
    if bits >= 8 {
        return row
            .iter()
            .flat_map(|&color| color.to_be_bytes().as_ref().to_vec())
            .collect();
    }
    let mut bytes = vec![0u8; (row.len() * bits).div_ceil(8)];
    for (column, &color) in row.iter().enumerate() {
        let value = u32::from(color.into().into_inner());
        for bit in 0..bits {
            if value >> (bits - 1 - bit) & 1 == 1 {
                let index = column * bits + bit;
                bytes[index / 8] |= 0x80 >> (index % 8);
            }
        }
    }
    bytes
}

fn check_bytes<C, O: Order>()
where
    C: SceneColor + ToBytes + Into<<C as PixelColor>::Raw>,
    <C as ToBytes>::Bytes: AsRef<[u8]>,
    u32: From<<<C as PixelColor>::Raw as RawData>::Storage>,
{
    let expected: Vec<u8> = full_frame::<C, O>(AREA).chunks(61).flat_map(packed_row).collect();
    for rows in ROWS {
        let picture_loop = picture_loop::<C, O>(rows);
        let (mut bytes, mut areas) = (Vec::new(), Vec::new());
        let mut sink = BytesSink(|area: Rectangle, band: &[u8]| {
            areas.push(area);
            bytes.extend_from_slice(band);
            Ok::<(), Infallible>(())
        });
        picture_loop
            .draw(&mut buffer(&picture_loop), &mut sink, scene::<C, O>)
            .unwrap();
        assert!(bytes == expected, "{rows} rows");
        assert_eq!(areas, picture_loop.bands().collect::<Vec<_>>());
    }
}

#[test]
fn bytes_are_packed_for_the_display() {
    check_bytes::<BinaryColor, LittleEndian>();
    check_bytes::<Gray2, BigEndian>();
    check_bytes::<Gray4, LittleEndian>();
    check_bytes::<Gray8, LittleEndian>();
    check_bytes::<Rgb555, BigEndian>();
    check_bytes::<Rgb565, LittleEndian>();
    check_bytes::<Rgb565, BigEndian>();
    check_bytes::<Bgr565, LittleEndian>();
    check_bytes::<Rgb888, LittleEndian>();
    check_bytes::<Rgb888, BigEndian>();
}
