//! Textured rows that few faces cross: without depths where no face overlaps another, and the same picture with depths.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::I16F16;
use zrow::{
    band::Band,
    scene::{Camera, Counted, Counters, FaceSet, Look, Memory, Model, Unhurried, Whole},
    shade::{Texels, Textured, TexturedSkin},
};

type Image = Textured<Texels<Rgb565, 16, 16>>;

/// xorshift32 (Marsaglia 2003).
struct Numbers(u32);

impl Numbers {
    /// A number from -most to most - 1.
    fn up_to(&mut self, most: i16) -> i16 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        ((self.0 >> 8) % (2 * most as u32)) as i16 - most
    }
}

/// Draws models into a picture of 72 x 40 pixels.
fn draw<L>(models: &[Model<'_, Image>]) -> (Vec<u16>, Counters)
where
    L: Look<Color = Rgb565, Shading = Image, Counting = core::cell::Cell<Counters>>,
{
    let area = Rectangle::new(Point::new(-3, 5), Size::new(72, 40));
    let camera = Camera::new(area, I16F16::from_num(60)).unwrap();
    let mut memory = Box::new(Memory::<L, 40, 10, 72, 40, 10>::new());
    let mut prepared = memory.prepare(&camera, models).unwrap();
    let mut words = vec![0; 72 * 40];
    prepared.draw(&mut Band::<Rgb565>::new(area, &mut words).unwrap());
    (words, prepared.counters())
}

/// One to six triangles, which reach beyond the sides of the picture and overlap each other in some of the scenes.
#[test]
fn rows_without_depths_have_the_pixels_of_those_with_depths() {
    let texels = core::array::from_fn(|y| core::array::from_fn(|x| (1 + 16 * y + x) as u16 * 0x00ff));
    let mut numbers = Numbers(0x0123_4567);
    let (mut filled, mut tested, mut both) = (0, 0, 0);
    for round in 0..400 {
        let (mut vertices, mut coordinates, mut faces) = (Vec::new(), Vec::new(), Vec::new());
        for face in 0..1 + round % 6 {
            let (middle, size) = ([numbers.up_to(700), numbers.up_to(400)], 60 + 60 * (round as i16 % 9));
            for _ in 0..3 {
                let [x, y] = middle.map(|part| part + numbers.up_to(size));
                vertices.push([x, y, numbers.up_to(300) + 800]);
                coordinates.push([(); 2].map(|()| numbers.up_to(6_000)));
            }
            // Of both sides one is seen.
            let corners = [3 * face, 3 * face + 1, 3 * face + 2];
            faces.extend([corners, [corners[0], corners[2], corners[1]]]);
        }
        faces.truncate(10);
        let skin = TexturedSkin {
            image: &texels,
            coordinates: &coordinates,
        };
        let mesh = FaceSet::new(&vertices, &faces).unwrap();
        let models = [Model::<Image>::with_skin(mesh, skin).unwrap()];
        let (words, counters) = draw::<Counted<Whole<Image>>>(&models);
        let (expected, with_depths) = draw::<Unhurried<Counted<Whole<Image>>>>(&models);
        assert_eq!(words, expected, "round {round}");
        assert_eq!(with_depths.pixels_filled, 0);
        assert_eq!(
            counters.pixels_filled + counters.pixels_tested,
            with_depths.pixels_tested
        );
        filled += u32::from(counters.pixels_filled > 0);
        tested += u32::from(counters.pixels_tested > 0);
        both += u32::from(counters.pixels_filled > 0 && counters.pixels_tested > 0);
    }
    assert!(filled > 100 && tested > 50 && both > 30, "{filled} {tested} {both}");
}
