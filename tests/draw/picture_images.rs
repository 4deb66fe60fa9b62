//! Images, what embedded-graphics' `Drawable`s draw, and painted shapes as items of a picture: the same as drawn one after
//! the other into a whole frame, in bands of any height and of any columns.

use core::hash::Hash;

use embedded_graphics::{
    image::{Image, ImageDrawableExt, ImageRaw},
    iterator::raw::RawDataSlice,
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{
        BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb666, Rgb888,
        raw::{BigEndian, ByteOrder, LittleEndian},
    },
    prelude::*,
    primitives::{Circle, Rectangle},
    text::Text,
};
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor, Order},
    draw::{DrawOn, DrawableItem, PaintedShape, Picture, PictureSlot, PrimitiveStyle},
    geometry::{InputError, TooSmall},
    shade::{LinearGradient, Pattern, Ramp},
};

use crate::common::{cases, config};

const AREA: Rectangle = Rectangle::new(Point::new(-3, 5), Size::new(41, 23));

/// The words of an area, drawn in bands of some rows from the top down.
fn in_bands<C: BandColor, O: Order>(
    area: Rectangle,
    rows: u32,
    mut draw: impl FnMut(&mut Band<'_, C, O>),
) -> Vec<C::Word>
where
    C::Word: DefaultWord,
{
    let mut words = vec![<C::Word as DefaultWord>::default_word(); (area.size.width * area.size.height) as usize];
    let mut rest = words.as_mut_slice();
    let mut y = 0;
    while y < area.size.height {
        let size = Size::new(area.size.width, rows.min(area.size.height - y));
        let (here, below) = rest.split_at_mut((size.width * size.height) as usize);
        let top_left = area.top_left + Point::new(0, y as i32);
        draw(&mut Band::new(Rectangle::new(top_left, size), here).unwrap());
        rest = below;
        y += size.height;
    }
    words
}

/// A word of zeros.
trait DefaultWord: Copy {
    fn default_word() -> Self;
}

macro_rules! default_word {
    ($($word:ty),+) => {$(
        impl DefaultWord for $word {
            fn default_word() -> Self {
                0
            }
        }
    )+};
}
default_word!(u8, u16, u32);

/// An image's bytes, its columns, where it is, and how it is drawn.
#[derive(Debug, Clone)]
struct Case {
    bytes: Vec<u8>,
    width: u32,
    top_left: Point,
    rows: u32,
    left: i32,
}

fn any_case() -> impl Strategy<Value = Case> {
    let number = || prop_oneof![8 => -30..60, 1 => any::<i32>(), 1 => -33_000..33_000];
    (
        proptest::collection::vec(any::<u8>(), 0..200),
        0..40u32,
        (number(), number()).prop_map(|(x, y)| Point::new(x, y)),
        1..30u32,
        -20..20,
    )
        .prop_map(|(bytes, width, top_left, rows, left)| Case {
            bytes,
            width,
            top_left,
            rows,
            left,
        })
}

/// Draws an image as an item of a picture and with embedded-graphics.
fn same_pixels<C, BO, O>(case: &Case) -> Result<(), TestCaseError>
where
    C: BandColor + From<C::Raw> + Hash,
    C::Word: DefaultWord,
    BO: ByteOrder + Hash,
    O: Order,
    for<'b> RawDataSlice<'b, C::Raw, BO>: IntoIterator<Item = C::Raw>,
{
    let image = ImageRaw::<C, BO>::new(&case.bytes, case.width);
    let mut area = AREA;
    area.top_left.x += case.left;
    // embedded-graphics adds size and position as they are: further off, where its numbers overflow, nothing is visible.
    let is_near = [case.top_left.x, case.top_left.y]
        .iter()
        .all(|number| number.abs() < 1 << 20);
    let expected = in_bands::<C, O>(area, 100, |band| {
        if is_near {
            let Ok(()) = Image::new(&image, case.top_left).draw(band);
        }
    });
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 2], [0; 20]);
    let mut picture = Picture::<C, O>::new(area, &mut slots, &mut pool, &mut buckets);
    picture.add_image(&image, case.top_left).unwrap();
    for rows in [case.rows, 1] {
        prop_assert_eq!(&in_bands::<C, O>(area, rows, |band| picture.draw(band)), &expected);
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(cases(300, 5_000)))]

    #[test]
    fn images_have_the_pixels_of_embedded_graphics(case in any_case()) {
        same_pixels::<BinaryColor, BigEndian, LittleEndian>(&case)?;
        same_pixels::<Gray2, LittleEndian, LittleEndian>(&case)?;
        same_pixels::<Gray4, BigEndian, BigEndian>(&case)?;
        same_pixels::<Gray8, BigEndian, LittleEndian>(&case)?;
        same_pixels::<Rgb565, BigEndian, LittleEndian>(&case)?;
        same_pixels::<Rgb565, BigEndian, BigEndian>(&case)?;
        same_pixels::<Rgb565, LittleEndian, LittleEndian>(&case)?;
        same_pixels::<Rgb565, LittleEndian, BigEndian>(&case)?;
        same_pixels::<Rgb666, LittleEndian, LittleEndian>(&case)?;
        same_pixels::<Rgb888, BigEndian, LittleEndian>(&case)?;
        same_pixels::<Rgb888, LittleEndian, BigEndian>(&case)?;
    }

    /// A part of an image, a text, and shapes in a gradient and in a pattern.
    #[test]
    fn what_is_kept_by_reference_is_what_is_drawn(case in any_case(), diameter in 0..60u32) {
        let raw = ImageRaw::<Rgb565>::new(&case.bytes, case.width);
        let part = raw.sub_image(&Rectangle::new(Point::new(1, 0), Size::new(5, 3)));
        let near = Point::new(case.top_left.x % 64, case.top_left.y % 64);
        let part = DrawableItem(Image::new(&part, near));
        let text = DrawableItem(Text::new("Ag", near, MonoTextStyle::new(&FONT_6X10, Rgb565::RED)));
        let ramp = Ramp::between(Rgb888::RED, Rgb888::BLUE);
        let gradient = LinearGradient::<Rgb565, 2>::new(Point::zero(), Point::new(20, 31), ramp).unwrap();
        let disc = Circle::with_center(near, diameter).into_styled(PrimitiveStyle::with_fill(Rgb565::GREEN));
        let disc = PaintedShape { shape: disc, paint: &gradient };
        let tile = [Rgb565::WHITE, Rgb565::BLACK, Rgb565::RED, Rgb565::GREEN];
        let pattern = Pattern::new(2, &tile).unwrap();
        let painted_text = PaintedShape {
            shape: Text::new("42", Point::new(4, 18), MonoTextStyle::new(&FONT_6X10, Rgb565::RED)),
            paint: pattern,
        };
        let expected = in_bands::<Rgb565, LittleEndian>(AREA, 100, |band| {
            let Ok(()) = disc.draw_on(band);
            let Ok(()) = part.0.draw(band);
            let Ok(_) = text.0.draw(band);
            let Ok(()) = painted_text.draw_on(band);
        });
        let (mut slots, mut buckets) = ([PictureSlot::EMPTY; 4], [0; 20]);
        let mut picture = Picture::<Rgb565>::new(AREA, &mut slots, &mut [], &mut buckets);
        picture.add_item(&disc).unwrap();
        picture.add_item(&part).unwrap();
        picture.add_item(&text).unwrap();
        picture.add_item(&painted_text).unwrap();
        for rows in [case.rows, 1] {
            prop_assert_eq!(&in_bands::<Rgb565, LittleEndian>(AREA, rows, |band| picture.draw(band)), &expected);
        }
    }
}

#[test]
fn an_image_without_room_says_what_it_needs() {
    let image = ImageRaw::<Gray8>::new(&[1, 2, 3, 4], 2);
    let mut slots = [PictureSlot::EMPTY; 1];
    let mut pool = [0; 1];
    let mut picture = Picture::<Gray8>::new(AREA, &mut slots, &mut pool, &mut []);
    let too_small = TooSmall::PictureWords(2);
    assert_eq!(
        picture.add_image(&image, Point::zero()),
        Err(InputError::TooSmall(too_small))
    );
    assert_eq!((picture.slots_used(), picture.words_used()), (0, 0));
}

#[test]
fn a_replaced_image_changes_its_own_pixels_and_those_of_the_other() {
    use zrow::geometry::Window;

    let (one, other) = ([7; 12], [9; 6]);
    let (one, other) = (ImageRaw::<Gray8>::new(&one, 4), ImageRaw::<Gray8>::new(&other, 2));
    let (mut slots, mut pool, mut areas) = ([PictureSlot::EMPTY; 1], [0; 4], [Window::EMPTY; 4]);
    let mut picture = Picture::<Gray8>::new(AREA, &mut slots, &mut pool, &mut []).with_damage(&mut areas, (1, 1));
    let id = picture.add_image(&one, Point::new(0, 6)).unwrap();
    picture.clear_damage();
    picture.replace_image(id, &one, Point::new(0, 6)).unwrap();
    assert_eq!(picture.next_damage(), None);
    picture.replace_image(id, &other, Point::new(20, 22)).unwrap();
    let mut changed: Vec<_> = core::iter::from_fn(|| picture.next_damage()).collect();
    changed.sort_by_key(|area| area.top_left.x);
    assert_eq!(
        changed,
        [
            Rectangle::new(Point::new(0, 6), Size::new(4, 3)),
            Rectangle::new(Point::new(20, 22), Size::new(2, 3)),
        ]
    );
}
