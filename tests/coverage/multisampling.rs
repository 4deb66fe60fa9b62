//! Multisampling against samples that are inside or outside in plain integers, and against supersampling.

use std::{cell::Cell, convert::Infallible};

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
    prelude::*,
    primitives::{Circle, Line, Rectangle},
    text::Text,
};
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor, BigEndian, LittleEndian, Order, Span, Supersampling, Target},
    coverage::{BoxFilter, CentreSample, Grid, Rooks, SamplePattern, SignedArea},
    draw::{AntialiasedPolygon, DrawOn, FillRule, PrimitiveStyle},
    geometry::{DrawError, Sub8, SubPoint, TooSmall, Window},
    scene::{Memory, Model},
    shade::{BlendTarget, LinearGradient, Paint, Ramp, SampleFilter, SampleTarget},
};

use crate::common::{self, cases, channels::Channels, config, meshes};
use crate::snapped_faces::{camera, standard_pose};
use crate::supersampling::{AnyColor, bayer, every_color, mean, noise, noisy, sized, supersampled};

/// Corners in 1/256 pixel from the corner of pixel (0, 0).
type Contour = Vec<[i32; 2]>;

const SIZE: (u32, u32) = (13, 11);

fn prepare(contours: &[Contour], fill_rule: FillRule) -> AntialiasedPolygon<64, 64> {
    let point = |corner: &[i32; 2]| SubPoint::<Sub8>::from_units(corner[0] - 128, corner[1] - 128).unwrap();
    let contours: Vec<Vec<_>> = contours
        .iter()
        .map(|contour| contour.iter().map(point).collect())
        .collect();
    let contours: Vec<&[_]> = contours.iter().map(Vec::as_slice).collect();
    AntialiasedPolygon::prepare(contours.as_slice(), fill_rule).unwrap()
}

/// Whether each edge at the height of a position runs left of the position, moved by so many units, or through it; and what
/// crossing it adds to the winding number. In integers.
fn crossings(contours: &[Contour], [x, y]: [i128; 2], slack: i128) -> Vec<(bool, i128)> {
    let edges = contours
        .iter()
        .flat_map(|contour| contour.iter().zip(contour.iter().cycle().skip(1)));
    let ends = edges.map(|(from, to)| (from.map(i128::from), to.map(i128::from)));
    let downwards = ends.map(|(from, to)| if from[1] < to[1] { (from, to, 1) } else { (to, from, -1) });
    let there = downwards.filter(|(top, bottom, _)| top[1] <= y && y < bottom[1]);
    there
        .map(|(top, bottom, sign)| {
            let aside = (top[0] - x - slack) * (bottom[1] - top[1]) + (bottom[0] - top[0]) * (y - top[1]);
            (aside <= 0, sign)
        })
        .collect()
}

fn windings(contours: &[Contour], position: [i128; 2]) -> i128 {
    let crossings = crossings(contours, position, 0);
    crossings
        .iter()
        .filter(|(is_left, _)| *is_left)
        .map(|(_, sign)| sign)
        .sum()
}

fn is_inside(windings: i128, fill_rule: FillRule) -> bool {
    match fill_rule {
        FillRule::EvenOdd => windings % 2 != 0,
        FillRule::NonZero => windings != 0,
    }
}

/// A shape of a scene: its contours, the rule, and a number for its colour.
type Layer = (Vec<Contour>, FillRule, u32);

/// A scene with several samples a pixel, from first to last, over a background that is not one colour.
fn multisampled<C: Channels, O: Order, P: SamplePattern>(layers: &[Layer], rows: u32, pattern: P) -> Vec<C> {
    let mut colors = Vec::new();
    let mut memory = vec![P::Cell::default(); P::cells(SIZE.0 as usize) + 3];
    for top in (0..SIZE.1).step_by(rows as usize) {
        let area = sized((SIZE.0, rows.min(SIZE.1 - top)), Point::new(0, top as i32));
        let mut words = vec![<C as BandColor>::to_word(C::any(0)); (area.size.width * area.size.height) as usize];
        let mut band = Band::<C, O>::new(area, &mut words).unwrap();
        noisy(&mut band, 3);
        let mut samples = vec![<C as BandColor>::to_word(C::any(1)); band.words().len() * P::SAMPLES];
        band.multisample(P::default(), &mut samples, |target| {
            for (contours, fill_rule, color) in layers {
                let polygon = prepare(contours, *fill_rule);
                polygon.draw_samples(C::any(*color), target, &mut memory).unwrap();
            }
        })
        .unwrap();
        colors.extend(band.colors());
    }
    let is_empty = |cell: &P::Cell| format!("{cell:?}") == format!("{:?}", P::Cell::default());
    assert!(memory.iter().all(is_empty), "{}", std::any::type_name_of_val(&pattern));
    colors
}

/// The colour of each pixel by definition: the mean of its samples, each found by itself. `None` where a sample lies within two units of a side.
fn expected<C: Channels, P: SamplePattern>(layers: &[Layer], is_exact: bool) -> Vec<Option<C>> {
    let pixels = sized(SIZE, Point::zero()).points();
    let sample = |pixel: Point, [x, y]: [i32; 2]| {
        let position = [i128::from(pixel.x * 256 + x), i128::from(pixel.y * 256 + y)];
        let mut color = C::any(noise(Point::new(pixel.x >> 3, pixel.y >> 2), 3));
        for (contours, fill_rule, number) in layers {
            if !is_exact && crossings(contours, position, -2) != crossings(contours, position, 2) {
                return None;
            }
            if is_inside(windings(contours, position), *fill_rule) {
                color = C::any(*number);
            }
        }
        Some(color)
    };
    let color = |pixel: Point| {
        let colors: Option<Vec<C>> = P::positions().map(|position| sample(pixel, position)).collect();
        Some(mean(colors?.into_iter().map(|color| (color, 1))))
    };
    pixels.map(color).collect()
}

/// A quadrangle between two levels with sides at slopes of eighths: where it passes a sample is a whole number of units.
fn straight_sides() -> impl Strategy<Value = Contour> + Clone {
    let side = || (-300..3600i32, -16..=16i32);
    (-20..360i32, 1..200i32, side(), side()).prop_map(|(top, height, left, right)| {
        let x = |(x, slope): (i32, i32), down: i32| x + slope * down;
        vec![
            [x(left, 0), top * 8],
            [x(right, 0), top * 8],
            [x(right, height), (top + height) * 8],
            [x(left, height), (top + height) * 8],
        ]
    })
}

fn layers(contour: impl Strategy<Value = Contour> + Clone) -> impl Strategy<Value = Vec<Layer>> {
    let rule = prop_oneof![Just(FillRule::EvenOdd), Just(FillRule::NonZero)];
    let layer = (prop::collection::vec(contour, 1..3), rule, any::<u32>());
    prop::collection::vec(layer, 1..4)
}

fn check_samples<C: Channels, O: Order, P: SamplePattern + Copy>(
    pattern: P,
    layers: &[Layer],
    rows: u32,
    is_exact: bool,
) {
    let found = multisampled::<C, O, P>(layers, rows, pattern);
    for (index, (found, expected)) in found.into_iter().zip(expected::<C, P>(layers, is_exact)).enumerate() {
        assert!(
            expected.is_none_or(|expected| expected == found),
            "{index}: {found:?} {expected:?}"
        );
    }
}

fn check_patterns<C: Channels, O: Order>(layers: &[Layer], rows: u32, is_exact: bool) {
    macro_rules! check_each {
        ($([$name:ident] [$($pattern:tt)+])+) => {
            $(check_samples::<C, O, $($pattern)+>(<$($pattern)+>::default(), layers, rows, is_exact);)+
        };
    }
    zrow_methods::sample_patterns!(check_each);
}

proptest! {
    #![proptest_config(config(cases(15, 150)))]

    #[test]
    fn samples_are_those_inside_and_a_pixel_is_their_mean(layers in layers(straight_sides()), rows in 1..12u32) {
        check_patterns::<Rgb565, LittleEndian>(&layers, rows, true);
    }

    /// Any corners: sides are rounded to 1/256 pixel in each row and at each sample.
    #[test]
    fn samples_of_any_polygon(
        layers in layers(prop::collection::vec([-800..4200i32, -800..3600i32], 3..7)), rows in 1..12u32,
    ) {
        check_patterns::<Rgb888, BigEndian>(&layers, rows, false);
    }

    #[test]
    fn the_ends_of_the_domain_are_drawn(
        contour in prop::collection::vec([-2_096_000..=2_096_000i32, -2_096_000..=2_096_000i32], 3..7), even_odd: bool,
    ) {
        let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        // Sides here are flat enough to move by more than two units from one sample to the next: only that nothing panics.
        let layers = [(vec![contour], rule, 4)];
        macro_rules! draw_each {
            ($([$name:ident] [$($pattern:tt)+])+) => {
                $(multisampled::<Gray8, LittleEndian, _>(&layers, 4, <$($pattern)+>::default());)+
            };
        }
        zrow_methods::sample_patterns!(draw_each);
    }

    /// Shapes in one colour, samples in the same positions: the two ways are one.
    #[test]
    fn flat_colours_are_the_same_by_supersampling(layers in layers(straight_sides())) {
        same_picture::<2>(&layers, Grid::<2>::new());
        same_picture::<4>(&layers, Grid::<4>::new());
    }
}

/// Samples in a grid and rooks; every pattern is averaged in two colour types by the tests of random polygons.
#[test]
fn every_colour_type_is_averaged() {
    let slanted = vec![[100, 90], [3000, 90], [2500, 2100], [900, 2700]];
    let crossing = vec![[0, 0], [3300, 2800], [3300, 0], [0, 2800]];
    let layers = [
        (vec![slanted], FillRule::NonZero, 71),
        (vec![crossing], FillRule::EvenOdd, 1_234_567),
    ];
    every_color!(check_samples, LittleEndian, _; Grid::<4>::new(), &layers, 1, false);
    every_color!(check_samples, BigEndian, _; Rooks::<8>, &layers, 11, false);
}

/// What is drawn at the size of the samples, each all or nothing, and filtered by a box.
fn supersampled_layers<const N: usize>(
    layers: &[Layer],
    mut draw: impl FnMut(&mut Band<'_, Rgb565>, &AntialiasedPolygon<64, 64>, u32),
) -> Vec<Rgb565>
where
    BoxFilter: SampleFilter<N>,
{
    let enlarged = |corner: &[i32; 2]| {
        let point = SubPoint::from_units(corner[0] - 128, corner[1] - 128).unwrap();
        let point = Supersampling::<Rgb565, N>::enlarged(point).unwrap();
        [point.x_units() + 128, point.y_units() + 128]
    };
    let polygons: Vec<_> = layers
        .iter()
        .map(|(contours, fill_rule, color)| {
            let contours: Vec<Contour> = contours.iter().map(|c| c.iter().map(enlarged).collect()).collect();
            (prepare(&contours, *fill_rule), *color)
        })
        .collect();
    supersampled::<Rgb565, N, BoxFilter, LittleEndian>(sized(SIZE, Point::zero()), Rgb565::BLACK, 1, &mut |band| {
        for point in band.bounding_box().points() {
            let pixel = Point::new(point.x / N as i32, point.y / N as i32);
            let color = Rgb565::any(noise(Point::new(pixel.x >> 3, pixel.y >> 2), 3));
            let Ok(()) = Pixel(point, color).draw(band);
        }
        for (polygon, color) in &polygons {
            draw(band, polygon, *color);
        }
    })
}

fn same_picture<const N: usize>(layers: &[Layer], pattern: impl SamplePattern)
where
    BoxFilter: SampleFilter<N>,
{
    let supersampled = supersampled_layers::<N>(layers, |band, polygon, color| {
        let color = Rgb565::any(color);
        polygon.draw(&CentreSample, color, band, &mut []).unwrap();
    });
    assert_eq!(
        multisampled::<Rgb565, LittleEndian, _>(layers, 1, pattern),
        supersampled
    );
}

/// A target that draws only where samples are taken, and remembers how often it was asked for a colour.
struct Counting<'c, P> {
    paint: P,
    asked: &'c Cell<usize>,
}

impl<P: Paint> Paint for Counting<'_, P> {
    type Color = P::Color;

    fn colors_from(&self, start: Point) -> impl Iterator<Item = P::Color> {
        self.paint
            .colors_from(start)
            .inspect(|_| self.asked.set(self.asked.get() + 1))
    }
}

/// With a gradient the two ways differ: one colour for all samples of a pixel, and one for each.
#[test]
fn a_gradient_is_one_colour_a_fragment_or_one_a_sample() {
    const N: usize = 4;
    let layer = vec![[0, 0], [13 * 256, 0], [13 * 256, 11 * 256], [300, 11 * 256]];
    let layers = [(vec![layer.clone()], FillRule::NonZero, 1)];
    // Steep, so that the samples of a pixel have different colours, and their mean is not that of the middle.
    let ramp = Ramp::between(Rgb888::new(0, 0, 0), Rgb888::new(255, 255, 255));
    let fine = LinearGradient::<Rgb565, 2>::new(Point::new(5 * 4 + 1, 0), Point::new(6 * 4 + 1, 0), ramp).unwrap();
    let coarse = LinearGradient::<Rgb565, 2>::new(Point::new(5, 0), Point::new(6, 0), ramp).unwrap();
    let supersampled = supersampled_layers::<N>(&layers, |band, polygon, _| {
        polygon
            .cover(&CentreSample, &band.window(), &mut [], |span, _| {
                let Ok(()) = band.painted(&fine).fill_span(span, ());
                Ok::<(), TooSmall>(())
            })
            .unwrap();
    });
    let asked = Cell::new(0);
    let polygon = prepare(&[layer], FillRule::NonZero);
    let mut words = vec![0; (SIZE.0 * SIZE.1) as usize];
    let mut band = Band::<Rgb565>::new(sized(SIZE, Point::zero()), &mut words).unwrap();
    noisy(&mut band, 3);
    let background: Vec<Rgb565> = band.colors().collect();
    let mut samples = vec![0; words_of::<Grid<4>>()];
    band.multisample(Grid::<4>::new(), &mut samples, |target| {
        let paint = Counting {
            paint: &coarse,
            asked: &asked,
        };
        let mut painted = target.painted(&paint);
        polygon.draw_samples(Rgb565::BLACK, &mut painted, &mut [0; 14]).unwrap();
    })
    .unwrap();
    let multisampled: Vec<Rgb565> = band.colors().collect();

    // Once a pixel that it touches.
    let touched = |pixel: &Point| {
        let inside = |position: [i32; 2]| {
            let position = [
                i128::from(pixel.x * 256 + position[0]),
                i128::from(pixel.y * 256 + position[1]),
            ];
            windings(&layers[0].0, position) != 0
        };
        Grid::<4>::positions().any(inside)
    };
    let pixels = sized(SIZE, Point::zero()).points();
    assert_eq!(asked.get(), pixels.clone().filter(touched).count());
    // All the samples of a pixel have the colour of its middle.
    for (index, pixel) in pixels.enumerate() {
        let colors = Grid::<4>::positions().map(|position| {
            let position = [
                i128::from(pixel.x * 256 + position[0]),
                i128::from(pixel.y * 256 + position[1]),
            ];
            let is_inside = windings(&layers[0].0, position) != 0;
            let paint = coarse.colors_from(pixel).next().unwrap();
            (if is_inside { paint } else { background[index] }, 1)
        });
        assert_eq!(multisampled[index], mean(colors), "{pixel:?}");
    }
    // The pixel on the ramp is in between by the one way and at an end by the other.
    let column = |picture: &[Rgb565]| picture[13 * 5..][5].channels();
    assert_eq!(column(&multisampled), [0, 0, 0]);
    assert!(column(&supersampled)[1] > 8, "{:?}", column(&supersampled));
    assert_eq!(multisampled[13 * 5 + 9], supersampled[13 * 5 + 9]);
}

fn words_of<P: SamplePattern>() -> usize {
    (SIZE.0 * SIZE.1) as usize * P::SAMPLES
}

/// Triangles about a point that cover everything.
fn fan(middle: [i32; 2], around: &[[i32; 2]]) -> Vec<Contour> {
    let next = around.iter().cycle().skip(1);
    around
        .iter()
        .zip(next)
        .map(|(&one, &other)| vec![middle, one, other])
        .collect()
}

fn leaves_no_seam<P: SamplePattern>(fan: &[Contour]) {
    let layers: Vec<Layer> = fan
        .iter()
        .map(|contour| (vec![contour.clone()], FillRule::NonZero, 99))
        .collect();
    let found = multisampled::<Rgb565, LittleEndian, P>(&layers, 1, P::default());
    assert!(found == [Rgb565::any(99); (SIZE.0 * SIZE.1) as usize]);
}

proptest! {
    #![proptest_config(config(cases(15, 150)))]

    /// Polygons that share their edges leave nothing of the background, wherever the edges run.
    #[test]
    fn complementary_edges_leave_no_seam(
        middle in [0..13 * 256i32, 0..11 * 256i32], top in 0..13 * 256i32, right in 0..11 * 256i32,
        bottom in 0..13 * 256i32, left in 0..11 * 256i32,
    ) {
        let (east, south) = (13 * 256, 11 * 256);
        let around = [
            [0, 0], [top, 0], [east, 0], [east, right], [east, south], [bottom, south], [0, south], [0, left],
        ];
        let fan = fan(middle, &around);
        macro_rules! check_each {
            ($([$name:ident] [$($pattern:tt)+])+) => {
                $(leaves_no_seam::<$($pattern)+>(&fan);)+
            };
        }
        zrow_methods::sample_patterns!(check_each);
    }
}

/// Blending by exact coverage does: half of white over half of white over black is three quarters.
#[test]
fn blending_leaves_a_seam() {
    let (east, south) = (13 * 256, 13 * 256);
    let halves = fan([0, 0], &[[east, 0], [east, south], [0, south]]);
    let mut words = vec![0; 13 * 11];
    let mut band = Band::<Gray8>::new(sized(SIZE, Point::zero()), &mut words).unwrap();
    for contour in &halves[..2] {
        let polygon = prepare(std::slice::from_ref(contour), FillRule::NonZero);
        polygon
            .draw(&SignedArea, Gray8::WHITE, &mut band, &mut [0; 14])
            .unwrap();
    }
    assert!(band.colors().enumerate().all(|(index, color)| {
        let seam = index / 13 == index % 13;
        color == Gray8::new(if seam { 192 } else { 255 })
    }));
}

#[test]
fn what_has_no_mask_takes_whole_pixels() {
    fn scene<T: Target<Color = Rgb565, Error = Infallible> + BlendTarget>(target: &mut T) {
        let style = PrimitiveStyle::with_stroke(Rgb565::YELLOW, 1);
        let Ok(_) = Text::new("ab", Point::new(1, 8), MonoTextStyle::new(&FONT_6X10, Rgb565::RED)).draw(target);
        let Ok(()) = Line::new(Point::new(-3, 1), Point::new(40, 12))
            .into_styled(style)
            .draw_on(target);
        let Ok(()) = Circle::new(Point::new(4, 2), 7).into_styled(style).draw_on(target);
        let fill = PrimitiveStyle::with_fill(Rgb565::BLUE);
        let Ok(()) = Rectangle::new(Point::new(9, 6), Size::new(90, 2))
            .into_styled(fill)
            .draw_on(target);
        let polygon = prepare(&[vec![[700, 300], [2900, 800], [1500, 2500]]], FillRule::NonZero);
        polygon.draw(&SignedArea, Rgb565::GREEN, target, &mut [0; 14]).unwrap();
    }
    let area = sized(SIZE, Point::zero());
    let direct = common::picture(area, |band| scene(band));
    let sampled = common::picture(area, |band| {
        band.multisample(Rooks::<8>, &mut vec![0; words_of::<Rooks<8>>()], |target| scene(target))
            .unwrap();
    });
    assert!(direct == sampled && direct.contains(&Rgb565::RED));
}

/// Coverage of one of two colours takes all samples of a pixel or none, as it does without samples.
#[test]
fn two_colours_among_samples() {
    let area = sized(SIZE, Point::zero());
    let draw = |is_sampled: bool, coverage: u8, mask: u32| -> Vec<BinaryColor> {
        let mut words = [0; (SIZE.0 * SIZE.1) as usize];
        let mut band = Band::<BinaryColor>::new(area, &mut words).unwrap();
        let spans = || (0..SIZE.1 as i32).map(|y| Span::new(y, 1, SIZE.0 as i32));
        if is_sampled {
            band.multisample(Rooks::<8>, &mut vec![0; words_of::<Rooks<8>>()], |target| {
                for span in spans() {
                    let Ok(()) = target.blend_span(span, BinaryColor::On, coverage);
                    let Ok(()) = target.fill_samples(span, mask, BinaryColor::On.to_word());
                }
            })
            .unwrap();
        } else {
            for span in spans() {
                let Ok(()) = band.blend_span(span, BinaryColor::On, coverage);
            }
        }
        band.colors().collect()
    };
    for coverage in [0, 1, 30, 128, 200, 255] {
        assert_eq!(draw(true, coverage, 0), draw(false, coverage, 0), "{coverage}");
    }
    // Of every 64 pixels as many as there are eighths of one.
    for (mask, count) in [(0, 0), (0b100, 8), (0b101_0110, 32), (0xff, 64)] {
        for (position, color) in area.points().zip(draw(true, 0, mask)) {
            assert_eq!(
                color.is_on(),
                position.x > 0 && bayer(position, 8) < count,
                "{position:?} {mask:b}"
            );
        }
    }
}

#[test]
fn too_few_samples_and_broken_promises() {
    let mut words = [0u16; 12];
    let mut band = Band::<Rgb565>::new(sized((4, 3), Point::new(5, 6)), &mut words).unwrap();
    let drawn = band.multisample(Rooks::<4>, &mut [0; 47], |_| panic!("drawn"));
    assert_eq!(drawn, Err(TooSmall::Words(48)));
    let drawn = band.multisample(Rooks::<4>, &mut [0; 48], |target| {
        let polygon = prepare(&[vec![[0, 0], [9000, 0], [9000, 9000]]], FillRule::NonZero);
        polygon.draw_samples(Rgb565::RED, target, &mut [0; 1])
    });
    assert_eq!(drawn, Ok(Err(DrawError::TooSmall(TooSmall::Cells(2)))));
    assert!(band.colors().all(|color| color == Rgb565::BLACK));
    let ends = [i32::MIN, -1, 0, 5, 6, 7, 8, 9, 10, i32::MAX];
    let drawn = band.multisample(Rooks::<4>, &mut [0; 48], |target| {
        for y in ends {
            for (start, end) in ends.into_iter().flat_map(|start| ends.map(|end| (start, end))) {
                let span = Span::new(y, start, end);
                let Ok(()) = target.fill_samples(span, u32::MAX, 7);
                let Ok(()) = target.fill_samples(span, 5, 7);
                let Ok(()) = target.set_samples(span, 3, [Rgb565::RED; 9]);
                let Ok(()) = target.fill_span(span, 7);
                let Ok(()) = target.blend_span(span, Rgb565::RED, 99);
                let Ok(()) = target.fill_window(
                    Window {
                        left: start,
                        top: y,
                        right: end,
                        bottom: start,
                    },
                    7,
                );
                let Ok(()) = Pixel(Point::new(start, end), Rgb565::RED).draw(target);
            }
        }
    });
    assert_eq!(drawn, Ok(()));
    let mut nothing = Band::<Rgb565>::new(Rectangle::zero(), &mut []).unwrap();
    assert_eq!(nothing.multisample(Rooks::<4>, &mut [], |_| 5), Ok(5));
}

/// What lies right of the columns leaves nothing in the row memory, however long that is.
#[test]
fn row_memory_is_empty_beyond_the_columns_too() {
    fn check<P: SamplePattern<Cell: PartialEq>>() {
        let polygon = prepare(&[vec![[0, 0], [1900, 0], [2600, 2000], [0, 2000]]], FillRule::NonZero);
        let window = Window {
            left: 0,
            top: 0,
            right: 5,
            bottom: 9,
        };
        let mut memory = [P::Cell::default(); 40];
        polygon
            .cover(&P::default(), &window, &mut memory, |_, _| Ok::<(), TooSmall>(()))
            .unwrap();
        assert!(memory == [P::Cell::default(); 40]);
    }
    macro_rules! check_each {
        ($([$name:ident] [$($pattern:tt)+])+) => {
            $(check::<$($pattern)+>();)+
        };
    }
    zrow_methods::sample_patterns!(check_each);
}

/// A scene has no samples: what it drew into the band is what every sample of a pixel begins as.
#[test]
fn a_scene_lies_below_what_is_multisampled() {
    let area = sized(SIZE, Point::zero());
    let mesh = meshes::cube(1.0);
    let colors: Vec<Rgb565> = (0..12).map(Rgb565::any).collect();
    let models = [Model::new(mesh.face_set(), &colors)
        .unwrap()
        .with_pose(standard_pose(7))];
    let mut memory = Memory::<Rgb565, 8, 12, { SIZE.0 as usize }, 16>::new();
    let mut prepared = memory.prepare(&camera(area), &models).unwrap();
    let mut scene = |band: &mut Band<'_, Rgb565>| prepared.draw(band);
    let contour = vec![[300, 500], [2900, 800], [1500, 2500]];
    let below = common::picture(area, &mut scene);
    let found = common::picture(area, |band| {
        scene(band);
        band.multisample(Rooks::<4>, &mut vec![0; words_of::<Rooks<4>>()], |target| {
            prepare(std::slice::from_ref(&contour), FillRule::NonZero)
                .draw_samples(Rgb565::RED, target, &mut [0; 14])
                .unwrap();
        })
        .unwrap();
    });
    let mut mixed = 0;
    for ((pixel, found), below) in area.points().zip(found).zip(below) {
        let position = |[x, y]: [i32; 2]| [i128::from(pixel.x * 256 + x), i128::from(pixel.y * 256 + y)];
        let samples = Rooks::<4>::positions().map(|sample| {
            let is_inside = windings(std::slice::from_ref(&contour), position(sample)) != 0;
            (if is_inside { Rgb565::RED } else { below }, 1)
        });
        let expected = mean(samples);
        mixed += usize::from(expected != below && expected != Rgb565::RED);
        assert_eq!(found, expected, "{pixel:?}");
    }
    assert!(mixed > 10);
}
