//! Sampled coverage against the exact inside: every sample of every pixel by itself, in `i128`. Edges are rounded to 1/8192
//! pixel, so only a sample nearer than that to an edge may be taken for one on its other side.

use std::ops::Range;

use embedded_graphics::{pixelcolor::Gray8, prelude::*};
use proptest::prelude::*;
use zrow::{
    band::Band,
    coverage::{Bartlett, CentreSample, CoverageMethod, Gaussian, Grid, Rooks, SamplePattern, SubScanlines},
    draw::{AntialiasedPolygon, FillRule},
    geometry::{Sub8, SubPoint, TooSmall, Window},
};

use crate::common::{cases, config};

/// The largest coordinate of a corner, in 1/256 pixel.
const MOST: i32 = 8191 * 256;

/// Corners in 1/256 pixel from the centre of pixel (0, 0).
type Corner = (i32, i32);

type Contour = Vec<Corner>;

/// An outline of these contours.
fn prepared(contours: &[Contour], fill_rule: FillRule) -> AntialiasedPolygon<64, 64> {
    let point = |&(x, y): &Corner| SubPoint::<Sub8>::from_units(x, y).unwrap();
    let contours: Vec<Vec<_>> = contours
        .iter()
        .map(|contour| contour.iter().map(point).collect())
        .collect();
    let contours: Vec<&[_]> = contours.iter().map(Vec::as_slice).collect();
    AntialiasedPolygon::prepare(contours.as_slice(), fill_rule).unwrap()
}

/// Hands over the spans of a polygon, each with its row.
fn cover<T: CoverageMethod>(
    method: &T,
    contours: &[Contour],
    fill_rule: FillRule,
    window: &Window,
    mut emit: impl FnMut(i32, Range<i32>, u8),
) {
    let polygon = prepared(contours, fill_rule);
    let mut memory = vec![T::Cell::default(); T::cells((window.right - window.left) as usize)];
    let covered = polygon.cover(method, window, &mut memory, |span, coverage| {
        emit(span.y, span.start..span.end, coverage);
        Ok::<_, TooSmall>(())
    });
    assert_eq!(covered, Ok(()));
}

/// Whether a position, in 1/256 pixel from the corner of pixel (0, 0), is inside, or on a top or left edge. `None` where it is
/// nearer than 1/8192 pixel to an edge in its row.
fn is_inside(contours: &[Contour], fill_rule: FillRule, position: (i128, i128)) -> Option<bool> {
    let mut windings = 0;
    for contour in contours {
        for (from, to) in contour.iter().zip(contour.iter().cycle().skip(1)) {
            let from_corner = |&(x, y): &Corner| (i128::from(x) + 128, i128::from(y) + 128);
            let (from, to) = (from_corner(from), from_corner(to));
            let (top, bottom) = if from.1 < to.1 { (from, to) } else { (to, from) };
            if !(top.1..bottom.1).contains(&position.1) {
                continue;
            }
            // How far it is right of the edge, in 1/256 pixel times the height.
            let height = bottom.1 - top.1;
            let right_of_edge = (position.0 - top.0) * height - (bottom.0 - top.0) * (position.1 - top.1);
            if 32 * right_of_edge.abs() < height {
                return None;
            }
            if right_of_edge > 0 {
                windings += if from.1 < to.1 { 1 } else { -1 };
            }
        }
    }
    Some(fill_rule.includes(windings))
}

fn position_in(pixel: (i32, i32), [x, y]: [i32; 2]) -> (i128, i128) {
    let corner = |pixel: i32| i128::from(pixel) * 256;
    (corner(pixel.0) + i128::from(x), corner(pixel.1) + i128::from(y))
}

fn pixels(window: &Window) -> impl Iterator<Item = (i32, i32)> {
    let columns = window.left..window.right;
    (window.top..window.bottom).flat_map(move |y| columns.clone().map(move |x| (x, y)))
}

/// The masks of all pixels of a window: which samples take the colour of what is drawn.
fn masks<P: SamplePattern>(contours: &[Contour], fill_rule: FillRule, window: &Window) -> Vec<u32> {
    let (width, height) = (
        (window.right - window.left) as usize,
        (window.bottom - window.top) as usize,
    );
    let mut words = vec![0; width * height];
    let mut band = Band::<Gray8>::new(window.to_rectangle(), &mut words).unwrap();
    let (mut samples, mut memory) = (
        vec![0; width * height * P::SAMPLES],
        vec![P::Cell::default(); P::cells(width)],
    );
    let polygon = prepared(contours, fill_rule);
    band.multisample(P::default(), &mut samples, |target| {
        polygon.draw_samples(Gray8::WHITE, target, &mut memory)
    })
    .unwrap()
    .unwrap();
    let mask = |pixel: &[u8]| (0..).zip(pixel).map(|(bit, &word)| u32::from(word != 0) << bit).sum();
    samples.chunks(P::SAMPLES).map(mask).collect()
}

/// Compares the masks of all pixels with the samples that are inside.
fn check_masks<P: SamplePattern>(contours: &[Contour], fill_rule: FillRule, window: &Window) {
    for (pixel, found) in pixels(window).zip(masks::<P>(contours, fill_rule, window)) {
        for (sample, position) in P::positions().enumerate() {
            let expected = is_inside(contours, fill_rule, position_in(pixel, position));
            assert!(
                expected.is_none_or(|expected| expected == (found >> sample & 1 != 0)),
                "{} sample {sample} of {pixel:?} {contours:?}",
                std::any::type_name::<P>()
            );
        }
    }
}

/// Compares the coverage of all pixels with the weight of the samples that are inside.
fn check_coverage<T: CoverageMethod>(
    method: &T,
    contours: &[Contour],
    fill_rule: FillRule,
    window: &Window,
    samples: &[([i32; 2], i32)],
) {
    let width = (window.right - window.left) as usize;
    let mut found = vec![0u8; width * (window.bottom - window.top) as usize];
    cover(method, contours, fill_rule, window, |y, columns, coverage| {
        for x in columns {
            found[(y - window.top) as usize * width + (x - window.left) as usize] = coverage;
        }
    });
    let whole: i32 = samples.iter().map(|(_, weight)| weight).sum();
    for (pixel, found) in pixels(window).zip(found) {
        // The weight of samples that are inside, and of those that may be.
        let (mut least, mut most) = (0, 0);
        for (position, weight) in samples {
            let inside = is_inside(contours, fill_rule, position_in(pixel, *position));
            least += if inside == Some(true) { *weight } else { 0 };
            most += if inside == Some(false) { 0 } else { *weight };
        }
        // Rounded to the nearest, ties either way.
        let twice = 2 * i32::from(found) * whole;
        assert!(
            (2 * least * 255 - whole..=2 * most * 255 + whole).contains(&twice),
            "{}: {found} for {least} to {most} of {whole} at {pixel:?} {contours:?}",
            std::any::type_name::<T>()
        );
    }
}

/// The samples of a grid with their weights, which are the product of one for the column and one for the row.
fn grid_samples(n: i32, weight: fn(i32, i32) -> i32) -> Vec<([i32; 2], i32)> {
    let middle = |index: i32| 256 * (2 * index + 1) / (2 * n);
    let samples = (0..n * n).map(|index| (index % n, index / n));
    samples
        .map(|(x, y)| ([middle(x), middle(y)], weight(x, n) * weight(y, n)))
        .collect()
}

/// All samples of a side have the same weight.
fn alike(_index: i32, _count: i32) -> i32 {
    1
}

/// 1, 2, 3 up to the middle of a side, and down again.
fn pyramid(index: i32, count: i32) -> i32 {
    (index + 1).min(count - index)
}

/// `8 exp(-8 d^2)` at a distance of `d` pixels from the middle of a side, which is what of a bell of a quarter of a pixel the
/// samples of 16 x 16 have; coarser grids take the one that lies next further out.
fn bell(index: i32, count: i32) -> i32 {
    let step = (2 * index + 1 - count).abs() * 8 / count;
    let distance = f64::from(2 * step + 1) / 32.0;
    (8.0 * (-8.0 * distance * distance).exp()).round() as i32
}

fn check_all(contours: &[Contour], fill_rule: FillRule, window: &Window) {
    macro_rules! check_each {
        ($([$name:ident] [$($pattern:tt)+])+) => {
            $(check_masks::<$($pattern)+>(contours, fill_rule, window);)+
        };
    }
    zrow_methods::sample_patterns!(check_each);
    check_coverage(&CentreSample, contours, fill_rule, window, &[([128, 128], 1)]);
    check_coverage(
        &Grid::<8, Bartlett>::new(),
        contours,
        fill_rule,
        window,
        &grid_samples(8, pyramid),
    );
    check_coverage(
        &Grid::<4, Gaussian>::new(),
        contours,
        fill_rule,
        window,
        &grid_samples(4, bell),
    );
    check_coverage(
        &Grid::<16>::new(),
        contours,
        fill_rule,
        window,
        &grid_samples(16, alike),
    );
}

fn around(pixel: (i32, i32), radius: i32) -> Window {
    Window {
        left: pixel.0 - radius,
        top: pixel.1 - radius,
        right: pixel.0 + radius + 1,
        bottom: pixel.1 + radius + 1,
    }
}

/// Whole numbers `x` and `y` with `a x - b y = g`, the greatest common divisor of both, and that.
fn extended_euclid(a: i64, b: i64) -> (i64, i64, i64) {
    if b == 0 {
        return (a.signum(), 0, a.abs());
    }
    let (x, y, divisor) = extended_euclid(b, a.rem_euclid(b));
    // b x - (a - q b) y = g.
    (-y, -(x + a.div_euclid(b) * y), divisor)
}

/// An edge which a sample, in 1/256 pixel from the corner of pixel (0, 0), is as near to as one can be, left or right of it
/// or on it: `side` times the least area that their triangle may have. `along` says which of such positions on the edge.
fn edge_beside(sample: (i64, i64), direction: (i64, i64), side: i64, along: i64) -> Option<[Corner; 2]> {
    let (x, y, divisor) = extended_euclid(direction.0, direction.1);
    let [dx, dy] = [direction.0 / divisor, direction.1 / divisor];
    // Of the vectors from the top to the sample, all with that area, those within the height of the edge.
    let (mut right, mut down) = (side * y, side * x);
    let steps = down.div_euclid(dy) - along % divisor;
    (right, down) = (right - steps * dx, down - steps * dy);
    assert_eq!(direction.0 * down - direction.1 * right, side * divisor);
    assert!((0..direction.1).contains(&down));
    let top = (sample.0 - right, sample.1 - down);
    let corner = |(x, y): (i64, i64)| {
        let units = |units: i64| i32::try_from(units - 128).ok().filter(|units| units.abs() <= MOST);
        Some((units(x)?, units(y)?))
    };
    Some([corner(top)?, corner((top.0 + direction.0, top.1 + direction.1))?])
}

/// Directions of every length, and such that cross each row, or some rows, by whole 1/8192 pixels.
fn direction() -> impl Strategy<Value = (i64, i64)> {
    let any_length = (-MOST..=MOST, 1..=MOST, 0..21u32, 0..21u32)
        .prop_map(|(x, y, x_bits, y_bits)| (i64::from(x >> x_bits), i64::from(y >> y_bits).max(1)));
    let whole = (-3..=3i64, 8..16u32, 1..=400i64).prop_map(|(x, y_bits, times)| (x * times, times << y_bits));
    prop_oneof![
        any_length,
        whole.prop_filter("longer than the domain", |direction| direction.1 <= 2 * i64::from(MOST))
    ]
}

fn far_corner() -> impl Strategy<Value = Corner> {
    let coordinate = || prop_oneof![2 => -MOST..=MOST, 1 => -9000..9000i32, 1 => Just(MOST), 1 => Just(-MOST)];
    (coordinate(), coordinate())
}

fn near_contours() -> impl Strategy<Value = Vec<Contour>> {
    let coordinate = || prop_oneof![3 => -1500..1500i32, 1 => (-6..6i32).prop_map(|pixel| pixel * 256 + 128), 1 => (-40..40i32).prop_map(|step| step * 16)];
    let contour = proptest::collection::vec((coordinate(), coordinate()), 3..7);
    proptest::collection::vec(contour, 1..3)
}

fn fill_rule() -> impl Strategy<Value = FillRule> {
    prop_oneof![Just(FillRule::NonZero), Just(FillRule::EvenOdd)]
}

proptest! {
    #![proptest_config(config(cases(75, 600)))]

    /// An edge that passes a sample at the least distance there is, or goes through it.
    #[test]
    fn the_nearest_edges_are_on_the_right_side(
        pixel in (-8000..8000i32, -8000..8000i32), near: bool, position in (0..16i64, 0..16i64),
        direction in direction(), along in 0..1000i64, third in far_corner(), rule in fill_rule(),
    ) {
        let pixel = if near { (pixel.0 % 8, pixel.1 % 8) } else { pixel };
        let sample = |pixel: i32, position: i64| i64::from(pixel) * 256 + 8 + position * 16;
        let sample = (sample(pixel.0, position.0), sample(pixel.1, position.1));
        for side in [-1, 0, 1] {
            if let Some([top, bottom]) = edge_beside(sample, direction, side, along) {
                check_all(&[vec![top, bottom, third]], rule, &around(pixel, 1));
                check_all(&[vec![bottom, top, third]], rule, &around(pixel, 1));
            }
        }
    }

    #[test]
    fn polygons_with_corners_anywhere_are_sampled_to_the_bound(
        corners in proptest::collection::vec(far_corner(), 3..6), pixel in (-20..20i32, -20..20i32), rule in fill_rule(),
    ) {
        check_all(&[corners], rule, &around(pixel, 3));
    }

    #[test]
    fn polygons_near_by_are_sampled_to_the_bound(contours in near_contours(), rule in fill_rule()) {
        check_all(&contours, rule, &around((0, 0), 7));
    }

    /// Both triangles of a quadrangle round their common side alike: no sample is in both, and none is left out.
    #[test]
    fn polygons_that_share_an_edge_share_no_sample(
        near: bool, far in [far_corner(), far_corner(), far_corner(), far_corner()],
        close in [(-900..900i32, -900..900i32), (-900..900i32, -900..900i32), (-900..900i32, -900..900i32), (-900..900i32, -900..900i32)],
    ) {
        let [a, b, c, d] = if near { close } else { far };
        macro_rules! check_each {
            ($([$name:ident] [$($pattern:tt)+])+) => {
                $(check_shared_side::<$($pattern)+>([a, b, c, d]);)+
            };
        }
        zrow_methods::sample_patterns!(check_each);
    }
}

/// Also where the triangles overlap: what is in both is not in the quadrangle, whose sides cross then.
fn check_shared_side<P: SamplePattern>([a, b, c, d]: [Corner; 4]) {
    let masks = |contour: &[Corner]| masks::<P>(&[contour.to_vec()], FillRule::EvenOdd, &around((0, 0), 4));
    let halves = masks(&[a, b, c]).into_iter().zip(masks(&[a, c, d]));
    let halves: Vec<u32> = halves.map(|(one, other)| one ^ other).collect();
    assert_eq!(halves, masks(&[a, b, c, d]));
}

/// Sub-scanlines do not sample, but round each side to the nearest 1/256 pixel, from a position that is off by less than
/// 1/8192 pixel: 0.54 / 256 pixels in all.
fn check_sub_scanlines<const N: i32>(corners: &[Corner; 3], window: &Window) {
    let width = (window.right - window.left) as usize;
    let mut found = vec![0u8; width * (window.bottom - window.top) as usize];
    cover(
        &SubScanlines::<N>,
        &[corners.to_vec()],
        FillRule::NonZero,
        window,
        |y, columns, coverage| {
            for x in columns {
                found[(y - window.top) as usize * width + (x - window.left) as usize] = coverage;
            }
        },
    );
    for (pixel, found) in pixels(window).zip(found) {
        let (mut exact, mut sides) = (0.0, 0.0);
        for sub_scanline in 0..N {
            let y = f64::from(pixel.1 * 256 - 128) + 256.0 * (f64::from(sub_scanline) + 0.5) / f64::from(N);
            let mut crossings: Vec<f64> = (0..3)
                .filter_map(|index| {
                    let [(x0, y0), (x1, y1)] =
                        [corners[index], corners[(index + 1) % 3]].map(|(x, y)| (f64::from(x), f64::from(y)));
                    let is_there = y0.min(y1) <= y && y < y0.max(y1);
                    is_there.then(|| x0 + (x1 - x0) * (y - y0) / (y1 - y0))
                })
                .collect();
            crossings.sort_by(f64::total_cmp);
            let left = f64::from(pixel.0 * 256 - 128);
            let clamped = |x: f64| (x - left).clamp(0.0, 256.0);
            if let [one, other] = crossings[..] {
                exact += (clamped(other) - clamped(one)) / 256.0 / f64::from(N);
                // Those that may be in the pixel.
                let near = [one, other]
                    .into_iter()
                    .filter(|x| (left - 1.0..=left + 257.0).contains(x));
                sides += near.count() as f64 / f64::from(N);
            }
        }
        let error = (f64::from(found) - exact * 255.0).abs();
        assert!(
            error <= 0.5 + sides * 0.54 * 255.0 / 256.0 + 1e-6,
            "{N}: {found} for {exact} at {pixel:?} {corners:?}"
        );
    }
}

proptest! {
    #![proptest_config(config(cases(30, 300)))]

    #[test]
    fn sub_scanlines_are_within_the_stated_bound(
        corners in [far_corner(), far_corner(), far_corner()], near in [(-900..900i32, -900..900i32), (-900..900i32, -900..900i32), (-900..900i32, -900..900i32)],
    ) {
        for corners in [corners, near, [near[0], near[1], corners[2]]] {
            check_sub_scanlines::<1>(&corners, &around((0, 0), 4));
            check_sub_scanlines::<4>(&corners, &around((0, 0), 4));
            check_sub_scanlines::<64>(&corners, &around((0, 0), 1));
        }
    }
}

/// Steep edges from every column to every column of two rows of pixels: through most samples, and between them.
#[test]
fn every_edge_over_two_rows_is_on_the_right_side() {
    for index in 0..33i32.pow(2) {
        let (top, bottom) = (index % 33 * 8 - 128, index / 33 * 8 - 128);
        for (first, last) in [(-128, 384), (-120, 383), (-127, 128), (-1, 129)] {
            let contours = [vec![(top, first), (bottom, last), (600, last), (600, first)]];
            macro_rules! check_each {
                ($([$name:ident] [$($pattern:tt)+])+) => {
                    $(check_masks::<$($pattern)+>(&contours, FillRule::NonZero, &around((0, 0), 1));)+
                };
            }
            zrow_methods::sample_patterns!(check_each);
        }
    }
}

/// Edges that move by few 1/8192 pixels a row and pass through samples: what their ends are rounded by stays the same.
#[test]
fn edges_that_move_by_whole_8192ths_a_row_are_on_the_right_side() {
    for (width, height) in [(-1, 8192), (1, 8192), (-2, 8192), (-1, 4096), (-3, 8192), (1, 1 << 14)] {
        for sample in [(8, 8), (8, 120), (72, 136), (128, 128), (248, 248)] {
            for along in 0..40 {
                for side in [-1, 0, 1] {
                    let edge = edge_beside(sample, (40 * width, 40 * height), side, along);
                    let [top, bottom] = edge.unwrap();
                    let contours = [vec![top, bottom, (2000, bottom.1), (2000, top.1)]];
                    check_masks::<Rooks<16>>(&contours, FillRule::NonZero, &around((0, 0), 0));
                    check_coverage(
                        &CentreSample,
                        &contours,
                        FillRule::NonZero,
                        &around((0, 0), 1),
                        &[([128, 128], 1)],
                    );
                    check_coverage(
                        &Grid::<16>::new(),
                        &contours,
                        FillRule::NonZero,
                        &around((0, 0), 0),
                        &grid_samples(16, alike),
                    );
                }
            }
        }
    }
}
