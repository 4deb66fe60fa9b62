//! Textures: each texel of each kind, what is seen beyond their edges, and four texels mixed, against rational arithmetic.

use embedded_graphics::{
    pixelcolor::{Gray8, Rgb565, Rgb888, raw::RawU16},
    prelude::*,
};
use proptest::prelude::*;
use zrow::{
    band::BandColor,
    scene::{Deep, Fine, Look, Model},
    shade::{Bilinear, Clamped, CutOut, Indexed, IndexedImage, Sampler, Texels, Texture, Textured, TexturedSkin},
};

use crate::common::channels::Channels;
use crate::common::{cases, config};
use crate::shaded_scene::{SIZE, SmallMemory, UNTOUCHED, camera_in_units, flat_corners, triangle, unit, words};
use crate::shading_perspective::{in_space, span};
use crate::snapped_faces::snapped;

/// Fractional bits of a texture coordinate, as a part of the texture.
const BITS: i64 = 28;

type WordOf<T> = <<T as Texture>::Color as BandColor>::Word;

/// Numbers that look random: xorshift32 (Marsaglia 2003).
fn random(seed: u32) -> impl FnMut() -> u32 {
    let mut state = seed | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        state
    }
}

/// Coordinates over the whole range, in steps of less than 1/64 of a texture, and the least and greatest.
fn all_coordinates() -> impl Iterator<Item = i32> {
    let ends = [0x8000_0000u32, 0x8000_0001, 0x7fff_ffff, 0xffff_ffff, 0, 1].map(|bits| bits as i32);
    ends.into_iter()
        .chain((i32::MIN..=i32::MAX).step_by((1 << 21) + 12_345))
}

/// Compares each texel of a texture at its edges and in its middle, and samples everywhere. `expected` is the word of a texel
/// that is counted from the upper left one of the plane.
fn check<T: Texture>(image: &T::Image<'_>, expected: impl Fn([i64; 2]) -> Option<WordOf<T>>)
where
    WordOf<T>: Into<u32>,
{
    check_words(
        [1 << T::COLUMN_BITS, 1 << T::ROW_BITS],
        &|at| <T as Sampler>::sample(image, at).map(Into::into),
        &|[column, row]| T::texel(image, column, row).map(Into::into),
        &|at| expected(at).map(Into::into),
    );
}

fn check_words(
    size: [i64; 2],
    sample: &dyn Fn([i32; 2]) -> Option<u32>,
    texel: &dyn Fn([u32; 2]) -> Option<u32>,
    expected: &dyn Fn([i64; 2]) -> Option<u32>,
) {
    let nearest = |[u, v]: [i32; 2]| {
        let texel = [(u, size[0]), (v, size[1])].map(|(c, size)| (i64::from(c) * size).div_euclid(1 << BITS));
        assert_eq!(
            sample([u, v]),
            expected(texel),
            "texel {texel:?} at {u}, {v} of {size:?}"
        );
    };
    let [wide, high] = size.map(|size| (1i64 << BITS) / size);
    for (column, row) in (0..size[0]).flat_map(|column| (0..size[1]).map(move |row| (column, row))) {
        let direct = texel([column as u32, row as u32]);
        assert_eq!(direct, expected([column, row]), "{column}, {row} of {size:?}");
        for period in -8..8 {
            let at = |texel: i64, length: i64, part: i64| ((period << BITS) + texel * length + part) as i32;
            nearest([at(column, wide, 0), at(row, high, high - 1)]);
            nearest([at(column, wide, wide - 1), at(row, high, 0)]);
            nearest([at(column, wide, wide / 2), at(row, high, high / 2)]);
        }
    }
    let mut other = random(77);
    for coordinate in all_coordinates() {
        nearest([coordinate, other() as i32]);
        nearest([other() as i32, coordinate]);
    }
}

/// A texture as it repeats, and as it ends in its edges.
fn check_both<T: Texture>(image: &T::Image<'_>, texel: impl Fn([usize; 2]) -> Option<WordOf<T>>)
where
    WordOf<T>: Into<u32>,
{
    let size = [1i64 << T::COLUMN_BITS, 1 << T::ROW_BITS];
    let each = |at: [i64; 2], inside: fn(i64, i64) -> i64| [0, 1].map(|axis| inside(at[axis], size[axis]) as usize);
    check::<T>(image, |at| texel(each(at, i64::rem_euclid)));
    check::<Clamped<T>>(image, |at| texel(each(at, |texel, size| texel.clamp(0, size - 1))));
}

fn check_texels<const WIDTH: usize, const HEIGHT: usize>() {
    let mut random = random((WIDTH * 100 + HEIGHT) as u32);
    let image: Box<[[u16; WIDTH]; HEIGHT]> =
        Box::new(core::array::from_fn(|_| core::array::from_fn(|_| random() as u16)));
    check_both::<Texels<Rgb565, WIDTH, HEIGHT>>(&&*image, |[column, row]| Some(image[row][column]));
}

#[test]
fn each_texel_of_words_is_in_its_place() {
    check_texels::<1, 1>();
    check_texels::<2, 1>();
    check_texels::<1, 2>();
    check_texels::<1, 64>();
    check_texels::<64, 1>();
    check_texels::<4, 16>();
    check_texels::<64, 32>();
    check_texels::<4_096, 1>();
}

fn check_indexed<const BYTES: usize, const HEIGHT: usize, const COLORS: usize>() {
    let mut random = random((BYTES * 100 + HEIGHT + COLORS) as u32);
    let indices = core::array::from_fn(|_| core::array::from_fn(|_| (random() >> 9) as u8));
    let palette: Box<[u32; COLORS]> = Box::new(core::array::from_fn(|_| random() >> 8));
    let image = IndexedImage {
        indices: &indices,
        palette: &palette,
    };
    let bits = COLORS.ilog2() as usize;
    // Bit after bit from the left.
    let number = |[column, row]: [usize; 2]| {
        (column * bits..(column + 1) * bits).fold(0, |number, bit| {
            number << 1 | usize::from(indices[row][bit / 8] >> (7 - bit % 8) & 1)
        })
    };
    check_both::<Indexed<Rgb888, BYTES, HEIGHT, COLORS>>(&image, |at| Some(palette[number(at)]));
    check_both::<CutOut<Indexed<Rgb888, BYTES, HEIGHT, COLORS>>>(&image, |at| {
        let number = number(at);
        (number > 0).then(|| palette[number])
    });
}

#[test]
fn each_texel_of_a_palette_is_in_its_place() {
    check_indexed::<1, 1, 2>();
    check_indexed::<1, 1, 4>();
    check_indexed::<1, 1, 16>();
    check_indexed::<1, 1, 256>();
    check_indexed::<8, 32, 2>();
    check_indexed::<16, 32, 4>();
    check_indexed::<32, 32, 16>();
    check_indexed::<64, 32, 256>();
    check_indexed::<2, 64, 4>();
}

/// Where a sample lies between the centres of four texels: the left and upper one of the plane, and how far it is to the right
/// and down, in 1/2^32.
fn between_centers(coordinate: i32, size: i64) -> (i64, i64) {
    let texel = (1 << BITS) / size;
    let from_center = i64::from(coordinate) - texel / 2;
    (
        from_center.div_euclid(texel),
        (from_center.rem_euclid(texel) << 32) / texel,
    )
}

/// A word, and the levels of its channels.
type Levels = (u32, [u32; 3]);

/// Compares samples mixed of four texels with the sum of their levels, weighed in rational arithmetic.
fn check_bilinear<T: Texture<Color: Channels>>(image: &T::Image<'_>, inside: fn(i64, i64) -> i64)
where
    WordOf<T>: Into<u32>,
{
    let of_word = |word: WordOf<T>| (word.into(), levels::<T::Color>(word));
    check_mixed(
        [1 << T::COLUMN_BITS, 1 << T::ROW_BITS],
        inside,
        &|at| Bilinear::<T>::sample(image, at).map(of_word),
        &|at| <T as Sampler>::sample(image, at).map(of_word),
        &|[column, row]| T::texel(image, column, row).map(of_word),
    );
}

fn check_mixed(
    size: [i64; 2],
    inside: fn(i64, i64) -> i64,
    mixed: &dyn Fn([i32; 2]) -> Option<Levels>,
    nearest: &dyn Fn([i32; 2]) -> Option<Levels>,
    texel: &dyn Fn([u32; 2]) -> Option<Levels>,
) {
    let texel = |column: i64, row: i64| {
        let at = [inside(column, size[0]), inside(row, size[1])];
        texel(at.map(|at| at as u32))
    };
    let check = |at: [i32; 2]| {
        let [(column, right), (row, down)] = [between_centers(at[0], size[0]), between_centers(at[1], size[1])];
        let around = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| texel(column + x, row + y));
        let found = mixed(at);
        let [Some(a), Some(b), Some(c), Some(d)] = around else {
            assert_eq!(found, nearest(at), "beside a hole at {at:?}");
            return;
        };
        let found = found.expect("no hole is near");
        if [right, down] == [0, 0] || [b, c, d] == [a; 3] {
            assert_eq!(found, a, "at the centre of a texel, or among equal ones: {at:?}");
        }
        let [a, b, c, d, found] = [a, b, c, d, found].map(|(_, levels)| levels);
        for channel in 0..3 {
            let sum = |right: i128, down: i128, one: i128| {
                let mix = |x: u32, y: u32| i128::from(x) * (one - right) + i128::from(y) * right;
                let (upper, lower) = (mix(a[channel], b[channel]), mix(c[channel], d[channel]));
                upper * (one - down) + lower * down
            };
            // With fractions of 5 bits it is at most two levels too low, and never too high.
            let coarse = sum((right >> 27).into(), (down >> 27).into(), 32);
            let found_1024 = i128::from(found[channel]) << 10;
            assert!(
                (0..2 << 10).contains(&(coarse - found_1024)),
                "{found_1024}, not {coarse} at {at:?}, channel {channel}"
            );
            // What the fractions lack is 1/32 of the way between two levels, twice.
            let exact = sum(right.into(), down.into(), 1 << 32) as f64 / 2f64.powi(64);
            let around = [a, b, c, d].map(|levels| levels[channel]);
            let range = around.iter().max().unwrap() - around.iter().min().unwrap();
            let error = (f64::from(found[channel]) - exact).abs();
            assert!(
                error <= 2.0 + f64::from(range) / 16.0,
                "{error} at {at:?}, channel {channel}"
            );
        }
    };
    let [wide, high] = size.map(|size| (1i64 << BITS) / size);
    for (column, row) in (0..size[0]).flat_map(|column| (0..size[1]).map(move |row| (column, row))) {
        for period in [-8, -1, 0, 7] {
            let at = |texel: i64, length: i64| ((period << BITS) + texel * length + length / 2) as i32;
            check([at(column, wide), at(row, high)]);
            check([at(column, wide).wrapping_add(1), at(row, high).wrapping_sub(1)]);
        }
    }
    let mut other = random(33);
    for coordinate in all_coordinates() {
        check([coordinate, other() as i32]);
        check([other() as i32, coordinate]);
        check([coordinate, i32::MIN]);
    }
}

fn levels<C: Channels>(word: C::Word) -> [u32; 3] {
    let mut words = [word];
    let area = embedded_graphics::primitives::Rectangle::new(Point::zero(), Size::new(1, 1));
    let band = zrow::band::Band::<C>::new(area, &mut words).unwrap();
    band.colors().next().unwrap().channels()
}

fn check_both_bilinear<T: Texture<Color: Channels>>(image: &T::Image<'_>)
where
    WordOf<T>: Into<u32>,
{
    check_bilinear::<T>(image, i64::rem_euclid);
    check_bilinear::<Clamped<T>>(image, |texel, size| texel.clamp(0, size - 1));
}

fn check_bilinear_texels<C: Channels + From<C::Raw>, const WIDTH: usize, const HEIGHT: usize>()
where
    C::Word: Into<u32>,
{
    let mut random = random((WIDTH * 100 + HEIGHT) as u32);
    // Often the same colour as beside it, and often black or white.
    let mut color = move || match random() >> 16 & 3 {
        0 => C::from_channels([0; 3]),
        1 => C::from_channels(C::MAX),
        _ => C::from(<C::Raw as embedded_graphics::pixelcolor::raw::RawData>::from_u32(
            random() >> 5,
        )),
    };
    let image: Box<[[C::Word; WIDTH]; HEIGHT]> =
        Box::new(core::array::from_fn(|_| core::array::from_fn(|_| color().to_word())));
    check_both_bilinear::<Texels<C, WIDTH, HEIGHT>>(&&*image);
}

#[test]
fn four_texels_are_mixed_as_rational_arithmetic_says() {
    check_bilinear_texels::<Rgb565, 1, 1>();
    check_bilinear_texels::<Rgb565, 2, 2>();
    check_bilinear_texels::<Rgb565, 1, 16>();
    check_bilinear_texels::<Rgb565, 64, 32>();
    check_bilinear_texels::<Rgb888, 8, 8>();
    check_bilinear_texels::<Gray8, 16, 4>();
}

/// Around a hole the nearest texel is taken, and so the hole has the same edges.
#[test]
fn beside_holes_the_nearest_texel_is_taken() {
    let mut random = random(9);
    let indices: [[u8; 4]; 8] = core::array::from_fn(|_| core::array::from_fn(|_| (random() | random()) as u8));
    let palette = [0, 0xffff, 0x1234, 0xfedc];
    let image = IndexedImage {
        indices: &indices,
        palette: &palette,
    };
    check_both_bilinear::<CutOut<Indexed<Rgb565, 4, 8, 4>>>(&image);
    check_both_bilinear::<Indexed<Rgb565, 4, 8, 4>>(&image);
}

/// All words of 16 bits stay as they are where all texels are equal, wherever the sample is.
#[test]
fn a_texture_of_one_color_stays_so() {
    let mut random = random(5);
    for word in 0..=u16::MAX {
        let image = [[word; 4]; 2];
        let at = [random() as i32, random() as i32];
        assert_eq!(
            Bilinear::<Texels<Rgb565, 4, 2>>::sample(&&image, at),
            Some(word),
            "{:?}",
            Rgb565::from(RawU16::new(word))
        );
    }
}

/// A texture of 64 x 32 texels whose words are their columns and rows.
static NUMBERED: [[u32; 64]; 32] = {
    let mut texels = [[0; 64]; 32];
    let mut index = 0;
    while index < 64 * 32 {
        texels[index / 64][index % 64] = (index % 64 + (index / 64) * 256) as u32;
        index += 1;
    }
    texels
};

type Numbered = Textured<Clamped<Texels<Rgb888, 64, 32>>>;

/// Draws a textured triangle; at both ends of each span and every 16 columns the texels are within half a texel of the exact
/// coordinates. Returns how many pixels were compared.
fn check_choice<L: Look<Color = Rgb888, Shading = Numbered>>(
    corners: [[i16; 3]; 3],
    coordinates: [[i16; 2]; 3],
) -> usize {
    let (camera, mesh) = (camera_in_units(), triangle(corners));
    let coordinates: Vec<_> = coordinates.to_vec();
    let skin = TexturedSkin {
        image: &NUMBERED,
        coordinates: &coordinates,
    };
    let models = [Model::<Numbered>::with_skin(mesh.face_set(), skin).unwrap()];
    let mut memory = Box::new(SmallMemory::<L>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    if prepared.vertices_needed() > mesh.vertices.len() {
        return 0;
    }
    let faces = snapped(&prepared);
    let words = words(&mut prepared, camera.viewport().to_rectangle());
    let mut compared = 0;
    for face in &faces {
        let of_corners = mesh.faces[face.order].map(|vertex| coordinates[usize::from(vertex)]);
        for (row, words) in (0..).zip(words.chunks(SIZE[0] as usize)) {
            let Some([first, last]) = span(face, row, unit::<L>()) else {
                continue;
            };
            for (column, word) in (0..).zip(words) {
                let divided = column % 16 == 0 || column == first || column == last;
                if !divided || !(first..=last).contains(&column) {
                    continue;
                }
                assert_ne!(*word, UNTOUCHED, "{column}, {row}");
                let at = [column, row].map(|pixels| i128::from(pixels) * unit::<L>());
                for (axis, size, drawn) in [(0, 64.0, word & 0xff), (1, 32.0, word >> 8)] {
                    let exact = in_space(face, of_corners.map(|corner| corner[axis]), at) * size / 4_096.0;
                    let nearest = |texels: f64| texels.floor().clamp(0.0, size - 1.0) as u32;
                    assert!(
                        (nearest(exact - 0.5)..=nearest(exact + 0.5)).contains(&drawn),
                        "{column}, {row}: texel {drawn}, not {exact}"
                    );
                    compared += 1;
                }
            }
        }
    }
    compared
}

proptest! {
    #![proptest_config(config(cases(100, 3_000)))]

    /// Faces whose depths differ by up to a hundred times.
    #[test]
    fn texels_are_chosen_in_perspective(
        corners in prop::array::uniform3(prop::array::uniform2(-1000i16..1000)),
        distances in prop::array::uniform3(prop_oneof![Just(128i16), Just(12_800), 128i16..1000, 128i16..12_800]),
        coordinates in prop::array::uniform3(prop::array::uniform2(0i16..=4096)),
    ) {
        let corners = [0, 1, 2].map(|i| {
            let [x, y] = corners[i].map(|c| (i32::from(c) * i32::from(distances[i]) / 1_024) as i16);
            [x, y, distances[i]]
        });
        check_choice::<Numbered>(corners, coordinates);
        check_choice::<Fine<Deep<Numbered>>>(corners, coordinates);
    }

    /// Faces that lean so little that some are drawn without divisions.
    #[test]
    fn texels_of_faces_that_lean_are_within_half_a_texel(
        corners in flat_corners(),
        distances in prop::array::uniform3(-60i16..60),
        coordinates in prop::array::uniform3(prop::array::uniform2(0i16..=4096)),
    ) {
        let mut corners = corners.map(|[x, y, z]| [x.clamp(-1_100, 1_100), y.clamp(-1_100, 1_100), z]);
        for (corner, distance) in corners.iter_mut().zip(distances) {
            corner[2] += distance;
        }
        check_choice::<Numbered>(corners, coordinates);
        check_choice::<Fine<Deep<Numbered>>>(corners, coordinates);
    }
}

/// The comparison of texels sees a floor that goes far away.
#[test]
fn texels_of_a_floor_are_chosen_in_perspective() {
    let corners = [[-200, -80, 130], [200, -80, 130], [500, -300, 9_000]];
    assert!(check_choice::<Numbered>(corners, [[0, 4_096], [4_096, 4_096], [2_048, 0]]) > 100);
}
