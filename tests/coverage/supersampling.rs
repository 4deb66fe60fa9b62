//! Supersampling against pictures of samples that are filtered here, pixel by pixel, in plain integers.

use std::{cell::Cell, convert::Infallible};

use embedded_graphics::{
    pixelcolor::{Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::U0F16;
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor, BigEndian, LittleEndian, LoopError, Order, Supersampling},
    coverage::{Bartlett, BoxFilter, Gaussian},
    geometry::{InputError, TooSmall},
    scene::{Memory, Model, Pose, Rotation},
    shade::{ConeFilter, SampleFilter},
};

use crate::common::{
    cases,
    channels::Channels,
    config,
    meshes::{self, Mesh},
};
use crate::reference::nearest_faces::{self, Depth};
use crate::snapped_faces::{at, camera, snapped, standard_pose};

/// Some colour for a number.
pub trait AnyColor: Channels {
    fn any(number: u32) -> Self {
        let mixed = number.wrapping_mul(0x9E37_79B1) ^ number.wrapping_mul(0x85EB_CA77) >> 13;
        Self::from_channels([0, 1, 2].map(|index| (mixed >> (9 * index)) % (Self::MAX[index] + 1)))
    }
}

impl<C: Channels> AnyColor for C {}

/// The weighted mean of colours, to the nearest level, ties up.
pub fn mean<C: Channels>(colors: impl IntoIterator<Item = (C, i128)>) -> C {
    let (mut sums, mut total) = ([0i128; 3], 0);
    for (color, weight) in colors {
        total += weight;
        for (sum, level) in sums.iter_mut().zip(color.channels()) {
            *sum += i128::from(level) * weight;
        }
    }
    C::from_channels(sums.map(|sum| ((2 * sum + total) / (2 * total)) as u32))
}

pub fn sized(size: (u32, u32), corner: Point) -> Rectangle {
    Rectangle::new(corner, Size::new(size.0, size.1))
}

/// The rows that a supersampled picture sends, in order.
pub fn supersampled<C: Channels, const N: usize, F: SampleFilter<N>, O: Order>(
    area: Rectangle,
    background: C,
    rows: u32,
    scene: &mut dyn FnMut(&mut Band<'_, C, O>),
) -> Vec<C> {
    // Of one type for both pictures, so that the library's code for them is compiled once.
    type Scene<'s, C, O> = &'s mut dyn FnMut(&mut Band<'_, C, O>) -> Result<(), ()>;
    type AnySink<'s, C, O> = &'s mut dyn FnMut(Band<'_, C, O>) -> Result<(), Infallible>;
    let picture = |background: C, rows: u32| {
        let picture = Supersampling::<C, N, F>::new(area, background).unwrap();
        picture.rows(rows).in_order::<O>()
    };
    let mut samples = vec![<C as BandColor>::to_word(C::any(77)); picture(background, rows).words_needed()];
    let mut sums = vec![F::Sum::default(); Supersampling::<C, N, F>::sums_needed(area.size.width as usize)];
    let mut draw = |background: C, rows: u32, mut sink: AnySink<'_, C, O>, scene: Scene<'_, C, O>| {
        picture(background, rows).draw(&mut samples, &mut sums, &mut sink, scene)
    };
    // What is left over from another picture, whose scene failed in its second row of samples.
    let mut drawn = 0;
    let failed = draw(C::any(3), 1, &mut |_| Ok(()), &mut |band| {
        noisy(band, 12_345);
        drawn += 1;
        if drawn == 2 { Err(()) } else { Ok(()) }
    });
    assert_eq!(failed.is_err(), drawn == 2);
    let mut colors = Vec::new();
    let mut next_row = area.top_left.y;
    let mut sink = |band: Band<'_, C, O>| {
        let expected = Rectangle::new(Point::new(area.top_left.x, next_row), Size::new(area.size.width, 1));
        assert_eq!(band.bounding_box(), expected);
        next_row += 1;
        colors.extend(band.colors());
        Ok(())
    };
    let drawn = draw(background, rows, &mut sink, &mut |band| {
        scene(band);
        Ok(())
    });
    drawn.unwrap();
    colors
}

/// The weights of the samples in a window about a pixel, row by row.
type Kernel = Vec<Vec<i128>>;

/// The samples in the window of each pixel and what they count, from all samples of a picture, row by row.
fn windows<C: Channels>(size: (u32, u32), n: i64, samples: &[C], kernel: &Kernel) -> Vec<Vec<(C, i128)>> {
    let (width, height) = (i64::from(size.0) * n, i64::from(size.1) * n);
    let before = (kernel.len() as i64 - n) / 2;
    let mut windows = Vec::new();
    for y in 0..i64::from(size.1) {
        for x in 0..i64::from(size.0) {
            let mut window = Vec::new();
            for (row, weights) in (y * n - before..).zip(kernel) {
                for (column, &weight) in (x * n - before..).zip(weights) {
                    let (row, column) = (row.clamp(0, height - 1), column.clamp(0, width - 1));
                    window.push((samples[(row * width + column) as usize], weight));
                }
            }
            windows.push(window);
        }
    }
    windows
}

fn filtered<C: Channels>(size: (u32, u32), n: i64, samples: &[C], kernel: &Kernel) -> Vec<C> {
    let windows = windows(size, n, samples, kernel);
    windows.into_iter().map(mean).collect()
}

fn product(weights: &[i128]) -> Kernel {
    let row = |down: &i128| weights.iter().map(|across| down * across).collect();
    weights.iter().map(row).collect()
}

/// Kernels, each from its definition.
fn box_kernel(n: usize) -> Kernel {
    product(&vec![1; n])
}

fn bartlett_kernel(n: usize) -> Kernel {
    // In halves of a sample: 2 n less the distance from the middle.
    let weight = |index: usize| 2 * n as i128 - (2 * index as i128 + 1 - 2 * n as i128).abs();
    product(&(0..2 * n).map(weight).collect::<Vec<_>>())
}

/// The tables of the library, which are held against the closed forms below and by its own tests.
fn kernel_of<const N: usize, F: SampleFilter<N>>() -> Kernel {
    let side = F::PIXELS * N;
    let row = |row| (0..side).map(|column| F::weight(column, row).into()).collect();
    (0..side).map(row).collect()
}

pub fn noise(point: Point, seed: u32) -> u32 {
    (point.x as u32).wrapping_mul(0x27D4_EB2F) ^ (point.y as u32).wrapping_mul(0x1656_67B1) ^ seed
}

/// A picture in which every sample is its own, and some of the neighbours alike.
pub fn noisy<C: Channels, O: Order>(band: &mut Band<'_, C, O>, seed: u32) {
    for point in band.bounding_box().points() {
        let position = if seed.is_multiple_of(3) {
            Point::new(point.x >> 3, point.y >> 2)
        } else {
            point
        };
        let Ok(()) = Pixel(point, C::any(noise(position, seed))).draw(band);
    }
}

fn check_filter<C: Channels, const N: usize, F: SampleFilter<N>, O: Order>(
    size: (u32, u32),
    corner: Point,
    rows: u32,
    seed: u32,
    kernel: &Kernel,
) {
    let area = sized(size, corner);
    let enlarged = sized((size.0 * N as u32, size.1 * N as u32), corner * N as i32);
    let mut words = vec![<C as BandColor>::to_word(C::any(0)); (enlarged.size.width * enlarged.size.height) as usize];
    let mut whole = Band::<C>::new(enlarged, &mut words).unwrap();
    noisy(&mut whole, seed);
    let samples: Vec<C> = whole.colors().collect();
    let found = supersampled::<C, N, F, O>(area, C::any(5), rows, &mut |band| noisy(band, seed));
    assert_eq!(
        found,
        filtered(size, N as i64, &samples, kernel),
        "{N} {size:?} {rows} {seed}"
    );
}

fn check_filters<C: Channels, const N: usize, O: Order>(size: (u32, u32), corner: Point, rows: u32, seed: u32)
where
    BoxFilter: SampleFilter<N>,
    Bartlett: SampleFilter<N>,
    ConeFilter: SampleFilter<N>,
    Gaussian: SampleFilter<N>,
{
    check_filter::<C, N, BoxFilter, O>(size, corner, rows, seed, &box_kernel(N));
    check_filter::<C, N, Bartlett, O>(size, corner, rows, seed, &bartlett_kernel(N));
    check_filter::<C, N, ConeFilter, O>(size, corner, rows, seed, &kernel_of::<N, ConeFilter>());
    check_filter::<C, N, Gaussian, O>(size, corner, rows, seed, &kernel_of::<N, Gaussian>());
}

macro_rules! every_color {
    ($check:ident $(, $generic:tt)*; $($argument:expr),*) => {
        $check::<Gray2 $(, $generic)*>($($argument),*);
        $check::<Gray4 $(, $generic)*>($($argument),*);
        $check::<Gray8 $(, $generic)*>($($argument),*);
        $check::<Rgb555 $(, $generic)*>($($argument),*);
        $check::<Bgr555 $(, $generic)*>($($argument),*);
        $check::<Rgb565 $(, $generic)*>($($argument),*);
        $check::<Bgr565 $(, $generic)*>($($argument),*);
        $check::<Rgb666 $(, $generic)*>($($argument),*);
        $check::<Bgr666 $(, $generic)*>($($argument),*);
        $check::<Rgb888 $(, $generic)*>($($argument),*);
        $check::<Bgr888 $(, $generic)*>($($argument),*);
    };
}

pub(crate) use every_color;

/// A narrow filter and a wide one; that a filter does not depend on the colour type is left to those that go through all four.
#[test]
fn every_colour_type_is_filtered() {
    let wide = kernel_of::<4, Gaussian>();
    for seed in 0..6 {
        every_color!(check_filter, 2, BoxFilter, LittleEndian; (4, 3), Point::new(-2, 5), 1, seed, &box_kernel(2));
        every_color!(check_filter, 4, Gaussian, BigEndian; (3, 4), Point::new(7, -1), 3, seed, &wide);
        check_filters::<Rgb565, 2, LittleEndian>((4, 3), Point::new(-2, 5), 1, seed);
        check_filters::<Rgb565, 4, BigEndian>((3, 4), Point::new(7, -1), 3, seed);
    }
    check_filters::<Rgb888, 8, LittleEndian>((3, 2), Point::zero(), 8, 1);
    check_filters::<Gray8, 16, LittleEndian>((2, 3), Point::zero(), 5, 2);
}

proptest! {
    #![proptest_config(config(cases(15, 60)))]

    /// The loop over bands of any height is the whole picture filtered.
    #[test]
    fn bands_of_any_height_give_the_filtered_picture(
        width in 1..7u32, height in 1..7u32, x in -50..50i32, y in -50..50i32, rows in 0..40u32, seed: u32,
    ) {
        let (size, corner) = ((width, height), Point::new(x, y));
        check_filters::<Rgb565, 2, LittleEndian>(size, corner, rows, seed);
        check_filters::<Rgb565, 4, BigEndian>(size, corner, rows, seed);
        check_filters::<Rgb888, 8, LittleEndian>(size, corner, rows, seed);
        check_filters::<Gray8, 16, LittleEndian>(size, corner, rows, seed);
    }
}

/// A picture of 6 x 5 pixels and the same in floating point, from the weight at a position in pixels off the pixel's centre.
fn check_closed_form<const N: usize, F: SampleFilter<N>>(tolerance: f64, weight: impl Fn(f64, f64) -> f64) {
    let (size, n) = ((6u32, 5u32), N as i32);
    let enlarged = sized((size.0 * N as u32, size.1 * N as u32), Point::zero());
    let found = supersampled::<Gray8, N, F, LittleEndian>(sized(size, Point::zero()), Gray8::BLACK, 1, &mut |band| {
        noisy(band, 1);
    });
    let mut words = vec![0; (enlarged.size.width * enlarged.size.height) as usize];
    let mut whole = Band::<Gray8>::new(enlarged, &mut words).unwrap();
    noisy(&mut whole, 1);
    for (pixel, found) in sized(size, Point::zero()).points().zip(found) {
        let (mut sum, mut total) = (0.0, 0.0);
        for offset in sized((3 * N as u32, 3 * N as u32), Point::new(-n, -n)).points() {
            let part = |offset: i32| (f64::from(offset) + 0.5) / f64::from(n) - 0.5;
            let weight = weight(part(offset.x), part(offset.y));
            let position = pixel * n + offset;
            let position = Point::new(position.x.clamp(0, 6 * n - 1), position.y.clamp(0, 5 * n - 1));
            let color = embedded_graphics::image::GetPixel::pixel(&whole, position).unwrap();
            sum += f64::from(color.luma()) * weight;
            total += weight;
        }
        assert!(
            (f64::from(found.luma()) - sum / total).abs() < tolerance,
            "{N} {pixel:?}"
        );
    }
}

/// A rounded level is within half a level; the tables are rounded besides.
#[test]
fn the_tables_are_the_closed_forms() {
    let cone = |x: f64, y: f64| (1.0 - x.hypot(y)).max(0.0);
    check_closed_form::<2, ConeFilter>(0.51, cone);
    check_closed_form::<4, ConeFilter>(0.51, cone);
    check_closed_form::<8, ConeFilter>(0.51, cone);
    check_closed_form::<16, ConeFilter>(0.51, cone);
    check_closed_form::<4, Gaussian>(1.5, |x, y| (-2.0 * (x * x + y * y)).exp());
}

/// Which of 64 pixels a pixel is, in the order in which they are taken: the matrix of Bayer from its recursion.
pub fn bayer(position: Point, size: i32) -> i128 {
    if size == 1 {
        return 0;
    }
    let quadrant = match (position.x.rem_euclid(2), position.y.rem_euclid(2)) {
        (0, 0) => 0,
        (1, 1) => 1,
        (1, 0) => 2,
        _ => 3,
    };
    quadrant * i128::from(size * size / 4) + bayer(Point::new(position.x >> 1, position.y >> 1), size / 2)
}

/// On and off: so many of 64 pixels are on as the samples in the window are, to the nearest.
fn check_binary<const N: usize, F: SampleFilter<N>>(size: (u32, u32), corner: Point, rows: u32, seed: u32) {
    let (area, n) = (sized(size, corner), N as i32);
    let mut scene = |band: &mut Band<'_, BinaryColor>| {
        for point in band.bounding_box().points() {
            let position = Point::new(point.x.div_euclid(n), point.y.div_euclid(n));
            let is_on = noise(point, seed) >> 9 & 255 < noise(position, seed) >> 9 & 255;
            let Ok(()) = Pixel(point, BinaryColor::from(is_on)).draw(band);
        }
    };
    let enlarged = sized((size.0 * N as u32, size.1 * N as u32), corner * n);
    let mut words = vec![0; (enlarged.size.width * enlarged.size.height) as usize];
    let mut whole = Band::<BinaryColor>::new(enlarged, &mut words).unwrap();
    scene(&mut whole);
    let samples: Vec<BinaryColor> = whole.colors().collect();
    let found = supersampled::<BinaryColor, N, F, LittleEndian>(area, BinaryColor::Off, rows, &mut scene);
    let windows = windows(size, N as i64, &samples, &kernel_of::<N, F>());
    for ((position, found), window) in area.points().zip(found).zip(windows) {
        let total: i128 = window.iter().map(|(_, weight)| weight).sum();
        let on: i128 = window
            .iter()
            .filter(|(color, _)| color.is_on())
            .map(|(_, weight)| weight)
            .sum();
        let count = (2 * 64 * on + total) / (2 * total);
        assert_eq!(
            found.is_on(),
            bayer(position, 8) < count,
            "{N} {position:?} {on} of {total}"
        );
    }
}

#[test]
fn two_colours_are_mixed_by_their_positions() {
    for seed in 0..4 {
        check_binary::<2, BoxFilter>((9, 8), Point::new(-3, 5), 1, seed);
        check_binary::<4, Bartlett>((8, 9), Point::new(12, -2), 3, seed);
        check_binary::<4, ConeFilter>((8, 9), Point::zero(), 1, seed);
        check_binary::<8, Gaussian>((5, 4), Point::new(1, 1), 9, seed);
    }
    stays::<BinaryColor, 2, BoxFilter, LittleEndian>();
    stays::<BinaryColor, 4, Bartlett, LittleEndian>();
    stays::<BinaryColor, 4, ConeFilter, LittleEndian>();
    stays::<BinaryColor, 8, Gaussian, LittleEndian>();
}

fn stays<C: Channels, const N: usize, F: SampleFilter<N>, O: Order>() {
    let area = sized((4, 3), Point::new(3, -9));
    for number in 0..if N > 4 { 3 } else { 24 } {
        let color = match number {
            0 => C::from_channels(C::MAX),
            number => C::any(number),
        };
        for rows in [1, 3, 4] {
            assert!(supersampled::<C, N, F, O>(area, color, rows, &mut |_| {}) == [color; 12]);
        }
    }
}

fn stays_with_every_filter<C: Channels, const N: usize, O: Order>()
where
    BoxFilter: SampleFilter<N>,
    Bartlett: SampleFilter<N>,
    ConeFilter: SampleFilter<N>,
    Gaussian: SampleFilter<N>,
{
    stays::<C, N, BoxFilter, O>();
    stays::<C, N, Bartlett, O>();
    stays::<C, N, ConeFilter, O>();
    stays::<C, N, Gaussian, O>();
}

#[test]
fn one_colour_stays_that_colour() {
    every_color!(stays, 2, BoxFilter, LittleEndian;);
    every_color!(stays, 4, Gaussian, BigEndian;);
    stays_with_every_filter::<Rgb565, 2, LittleEndian>();
    stays_with_every_filter::<Rgb565, 4, BigEndian>();
    stays_with_every_filter::<Rgb888, 8, LittleEndian>();
    stays_with_every_filter::<Gray8, 16, LittleEndian>();
}

#[test]
fn far_pictures_are_drawn_or_refused() {
    type Picture = Supersampling<Gray8, 4, Gaussian>;
    let furthest = (1 << 30) / 4;
    for corner in [Point::new(-furthest, furthest - 2), Point::new(furthest - 2, -furthest)] {
        check_filters::<Gray8, 4, LittleEndian>((2, 2), corner, 3, 9);
    }
    for area in [
        sized((2, 1), Point::new(furthest - 1, 0)),
        sized((2, 1), Point::new(0, -furthest - 1)),
        sized((u32::MAX, u32::MAX), Point::new(i32::MIN, i32::MIN)),
        sized((1, 1), Point::new(i32::MAX, i32::MAX)),
    ] {
        let error = Picture::new(area, Gray8::BLACK).unwrap_err();
        assert_eq!(
            error,
            InputError::OutOfDomain {
                min: -furthest,
                max: furthest
            }
        );
    }
    for area in [Rectangle::zero(), sized((0, 5), Point::new(i32::MIN, 3))] {
        let drawn = supersampled::<Gray8, 4, Gaussian, LittleEndian>(area, Gray8::BLACK, 1, &mut |_| panic!("no band"));
        assert!(drawn.is_empty());
    }
    // Larger than any memory.
    let huge = Picture::new(sized((furthest as u32, furthest as u32), Point::zero()), Gray8::BLACK).unwrap();
    let drawn = huge.draw(
        &mut [0; 4],
        &mut [0; 4],
        &mut |_: Band<'_, Gray8>| Ok::<(), ()>(()),
        |_| {},
    );
    assert_eq!(drawn, Err(TooSmall::Words(1 << 30).into()));
}

#[test]
fn what_is_missing_is_said_before_anything_is_drawn() {
    type Picture = Supersampling<Rgb565, 2, Bartlett>;
    let picture = Picture::new(sized((5, 4), Point::zero()), Rgb565::BLACK)
        .unwrap()
        .rows(3);
    let draw = |samples: usize, sums: usize| {
        picture.draw(
            &mut vec![0; samples],
            &mut vec![0; sums],
            &mut |_: Band<'_, Rgb565>| Ok::<(), ()>(()),
            |_| {},
        )
    };
    assert_eq!((picture.words_needed(), Picture::sums_needed(5)), (30, 30));
    assert_eq!(draw(29, 0), Err(TooSmall::Words(30).into()));
    assert_eq!(draw(30, 29), Err(TooSmall::Sums(30).into()));
    assert_eq!(draw(30, 30), Ok(()));
    // And what the display reports ends it.
    let sent = Cell::new(0);
    let failed = picture.draw(
        &mut [0; 30],
        &mut [0; 30],
        &mut |_: Band<'_, Rgb565>| {
            sent.set(sent.get() + 1);
            if sent.get() == 2 { Err("unplugged") } else { Ok(()) }
        },
        |_| {},
    );
    assert_eq!((failed, sent.get()), (Err(LoopError::Sink("unplugged")), 2));
}

/// Draws a scene at the size of the samples and filters it, in bands of several heights; holds that against the filtered
/// picture of the scene as a whole and, where that is without doubt, as exact arithmetic has it.
fn check_scene<const N: usize, F: SampleFilter<N>>(meshes: &[Mesh], pose: Pose, kernel: &Kernel, is_exact: bool) {
    const SCENE: (u32, u32) = (23, 15);
    let corner = Point::new(5, -3);
    let enlarged = sized((SCENE.0 * N as u32, SCENE.1 * N as u32), corner * N as i32);
    let mut numbers = 0..;
    let numbered = |mesh: &Mesh| numbers.by_ref().take(mesh.faces.len()).map(Rgb888::any).collect();
    let colors: Vec<Vec<Rgb888>> = meshes.iter().map(numbered).collect();
    let models: Vec<_> = meshes
        .iter()
        .zip(&colors)
        .map(|(mesh, colors)| Model::new(mesh.face_set(), colors).unwrap().with_pose(pose))
        .collect();
    let mut memory = Box::new(Memory::<Rgb888, 296, 588, 128, 64, 128>::new());
    let mut prepared = memory.prepare(&camera(enlarged), &models).unwrap();
    let background = Rgb888::new(9, 99, 199);

    let mut words = vec![background.to_word(); (enlarged.size.width * enlarged.size.height) as usize];
    let mut whole = Band::<Rgb888>::new(enlarged, &mut words).unwrap();
    prepared.draw(&mut whole);
    let samples: Vec<Rgb888> = whole.colors().collect();
    if is_exact {
        let owners = nearest_faces::owners(&snapped(&prepared), enlarged, 16, Depth::Bits16);
        let exact = owners
            .iter()
            .map(|owner| owner.map_or(background, |owner| Rgb888::any(owner as u32)));
        assert!(samples.iter().copied().eq(exact));
    }
    let expected = filtered(SCENE, N as i64, &samples, kernel);
    for rows in [1, 2, 3, N as u32, 7, enlarged.size.height] {
        let found = supersampled::<Rgb888, N, F, LittleEndian>(sized(SCENE, corner), background, rows, &mut |band| {
            prepared.draw(band);
        });
        assert!(found == expected, "{N} {rows}");
    }
}

fn check_scenes(meshes: &[Mesh], pose: Pose, is_exact: bool) {
    check_scene::<2, BoxFilter>(meshes, pose, &box_kernel(2), is_exact);
    check_scene::<4, BoxFilter>(meshes, pose, &box_kernel(4), is_exact);
    check_scene::<2, Bartlett>(meshes, pose, &bartlett_kernel(2), is_exact);
    check_scene::<4, Bartlett>(meshes, pose, &bartlett_kernel(4), is_exact);
    check_scene::<4, ConeFilter>(meshes, pose, &kernel_of::<4, ConeFilter>(), is_exact);
    check_scene::<2, Gaussian>(meshes, pose, &kernel_of::<2, Gaussian>(), is_exact);
    check_scene::<4, Gaussian>(meshes, pose, &kernel_of::<4, Gaussian>(), is_exact);
}

/// The corners of the cube go through the ring.
#[test]
fn a_scene_is_filtered_as_anything_else() {
    let meshes = [meshes::torus(), meshes::cube(0.5)];
    for number in [0, 7, 40] {
        check_scenes(&meshes, standard_pose(number), true);
    }
}

proptest! {
    #![proptest_config(config(cases(6, 24)))]

    /// Faces that go through each other.
    #[test]
    fn interpenetrating_faces_are_filtered(
        faces in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-600i16..600)), 1..12),
        turn in any::<(u16, u16)>(),
        distance in 1300..2500i32,
    ) {
        let corners = (0..faces.len() as u16).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]);
        let mesh = Mesh::new(faces.concat(), corners.collect()).two_sided();
        let rotation = Rotation::about_x(U0F16::from_bits(turn.0)).then(&Rotation::about_y(U0F16::from_bits(turn.1)));
        check_scenes(&[mesh], Pose::new(rotation, at(0, 0, distance)), false);
    }
}
