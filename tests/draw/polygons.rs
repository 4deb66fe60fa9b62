//! Polygons against exact crossing counts at pixel centres, under both fill rules.

use embedded_graphics::{
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Rgb565},
    prelude::*,
    primitives::Rectangle,
};
use proptest::prelude::*;
use zrow::{
    draw::{FillRule, Polygon, PrimitiveStyle},
    geometry::{Sub4, Sub8, SubPixel, SubPoint, TooSmall, Vertex},
};

use crate::common::{cases, config, encloses, in_bands_and_whole, outlines::star};

/// Vertices in units of `1 / scale` pixel.
struct Shape {
    contours: Vec<Vec<(i32, i32)>>,
    scale: i128,
}

/// Edges at or left of the centre of a pixel, counted by their direction.
fn winding(shape: &Shape, x: i32, y: i32) -> i128 {
    let (x, y) = (i128::from(x) * shape.scale, i128::from(y) * shape.scale);
    let mut winding = 0;
    for contour in &shape.contours {
        for (index, &from) in contour.iter().enumerate() {
            let to = contour[(index + 1) % contour.len()];
            let (direction, top, bottom) = if from.1 < to.1 { (1, from, to) } else { (-1, to, from) };
            let (x0, y0) = (i128::from(top.0), i128::from(top.1));
            let (dx, dy) = (i128::from(bottom.0) - x0, i128::from(bottom.1) - y0);
            if y0 <= y && y < y0 + dy && (x - x0) * dy >= (y - y0) * dx {
                winding += direction;
            }
        }
    }
    winding
}

fn reference(shape: &Shape, rule: FillRule, window: Rectangle) -> Vec<Point> {
    window
        .points()
        .filter(|point| {
            let winding = winding(shape, point.x, point.y);
            match rule {
                FillRule::EvenOdd => winding % 2 != 0,
                FillRule::NonZero => winding != 0,
            }
        })
        .collect()
}

const EDGES: usize = 600;
const ACTIVE: usize = 600;

fn drawn<V: Vertex>(contours: &[Vec<V>], rule: FillRule, window: Rectangle) -> Vec<Point> {
    let contours: Vec<&[V]> = contours.iter().map(Vec::as_slice).collect();
    let prepared = Polygon::new(&contours, rule).prepare::<EDGES, ACTIVE>().unwrap();
    let bounds = prepared.bounding_box();
    let styled = prepared.into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE));
    let whole = in_bands_and_whole(&styled, window);
    assert!(whole.iter().all(|&point| encloses(&bounds, point)));
    whole
}

fn check(contours: &[Vec<Point>], window: Rectangle) {
    let shape = Shape {
        contours: contours
            .iter()
            .map(|contour| contour.iter().map(|point| (point.x, point.y)).collect())
            .collect(),
        scale: 1,
    };
    for rule in [FillRule::EvenOdd, FillRule::NonZero] {
        assert_eq!(
            drawn(contours, rule, window),
            reference(&shape, rule, window),
            "{rule:?} {contours:?} in {window:?}"
        );
    }
}

fn check_sub<S: SubPixel>(contours: &[Vec<(i32, i32)>], window: Rectangle) {
    let points: Vec<Vec<SubPoint<S>>> = contours
        .iter()
        .map(|contour| {
            contour
                .iter()
                .map(|&(x, y)| SubPoint::from_units(x, y).unwrap())
                .collect()
        })
        .collect();
    let shape = Shape {
        contours: contours.to_vec(),
        scale: 1 << S::FRACTION_BITS,
    };
    for rule in [FillRule::EvenOdd, FillRule::NonZero] {
        assert_eq!(
            drawn(&points, rule, window),
            reference(&shape, rule, window),
            "{rule:?} {contours:?} in {window:?}"
        );
    }
}

fn window() -> Rectangle {
    Rectangle::new(Point::new(-3, 5), Size::new(48, 40))
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        6 => -10..60i32,
        1 => -3000..3000i32,
        1 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, i32::MAX, i32::MAX - 1, -8191, 8191, -4, -3, 44, 45, 4, 5]),
    ]
}

fn contours<T: std::fmt::Debug + Clone + 'static>(
    vertex: impl Strategy<Value = T> + 'static,
) -> impl Strategy<Value = Vec<Vec<T>>> {
    prop::collection::vec(prop::collection::vec(vertex, 0..9), 0..4)
}

proptest! {
    #![proptest_config(config(cases(50, 400)))]

    #[test]
    fn polygons_of_pixels_are_exact(contours in contours((coordinate(), coordinate()).prop_map(|(x, y)| Point::new(x, y)))) {
        check(&contours, window());
    }

    #[test]
    fn polygons_of_sixteenths_are_exact(contours in contours((-100..900i32, -100..900i32))) {
        check_sub::<Sub4>(&contours, window());
    }

    #[test]
    fn polygons_of_sixteenths_to_the_ends_of_the_domain_are_exact(contours in contours((Sub4::MIN_UNITS..=Sub4::MAX_UNITS, Sub4::MIN_UNITS..=Sub4::MAX_UNITS))) {
        check_sub::<Sub4>(&contours, window());
    }

    #[test]
    fn polygons_of_256ths_are_exact(contours in contours((-1500..12_000i32, -1500..12_000i32))) {
        check_sub::<Sub8>(&contours, window());
    }

    #[test]
    fn polygons_of_256ths_to_the_ends_of_the_domain_are_exact(contours in contours((Sub8::MIN_UNITS..=Sub8::MAX_UNITS, Sub8::MIN_UNITS..=Sub8::MAX_UNITS))) {
        check_sub::<Sub8>(&contours, window());
    }

    #[test]
    fn nearly_horizontal_edges_are_exact(heights in prop::collection::vec((-1500..12_000i32, 1000..11_000i32, -64..64i32), 1..5)) {
        let contours: Vec<Vec<(i32, i32)>> = heights
            .iter()
            .map(|&(x, y, rise)| vec![(x, y), (x + 9000, y + rise), (x + 9500, y + rise + 40), (x + 20, y + 90)])
            .collect();
        check_sub::<Sub8>(&contours, window());
    }

    #[test]
    fn a_needed_number_is_exact(contours in contours((-5..40i32, -5..40i32))) {
        let points: Vec<Vec<Point>> = contours.iter().map(|contour| contour.iter().map(|&(x, y)| Point::new(x, y)).collect()).collect();
        let slices: Vec<&[Point]> = points.iter().map(Vec::as_slice).collect();
        let edges: Vec<(i32, i32)> = points
            .iter()
            .flat_map(|contour| (0..contour.len()).map(move |index| (contour[index].y, contour[(index + 1) % contour.len()].y)))
            .filter(|(from, to)| from != to)
            .collect();
        let active = (-5..40).map(|row| edges.iter().filter(|(from, to)| from.min(to) <= &row && &row < from.max(to)).count()).max().unwrap();
        check_needed(&Polygon::new(&slices, FillRule::EvenOdd), edges.len(), active);
    }
}

/// Prepares with exactly enough and with one slot less. Capacities are constants, so each has a line here.
fn check_needed(polygon: &Polygon<'_, Point>, edges: usize, active: usize) {
    fn with<const EDGES: usize, const ACTIVE: usize>(polygon: &Polygon<'_, Point>) -> Option<TooSmall> {
        polygon.prepare::<EDGES, ACTIVE>().err()
    }
    macro_rules! edge_capacities {
        ($($capacity:literal)+) => {
            match edges {
                $($capacity => {
                    assert_eq!(with::<$capacity, 64>(polygon), None);
                    if let Some(full) = with::<{ if $capacity == 0 { 0 } else { $capacity - 1 } }, 64>(polygon) {
                        assert_eq!(full, TooSmall::Edges(edges));
                    } else {
                        assert_eq!(edges, 0);
                    }
                })+
                _ => assert_eq!(with::<0, 0>(polygon), Some(TooSmall::Edges(edges))),
            }
        };
    }
    macro_rules! active_capacities {
        ($($capacity:literal)+) => {
            match active {
                $($capacity => {
                    assert_eq!(with::<64, $capacity>(polygon), None);
                    if let Some(full) = with::<64, { if $capacity == 0 { 0 } else { $capacity - 1 } }>(polygon) {
                        assert_eq!(full, TooSmall::ActiveEdges(active));
                    } else {
                        assert_eq!(active, 0);
                    }
                })+
                _ => assert_eq!(with::<64, 0>(polygon), Some(TooSmall::ActiveEdges(active))),
            }
        };
    }
    edge_capacities!(0 2 3 4 5 6 7 8 9 10 11 12);
    active_capacities!(0 2 4 6 8 10 12);
}

fn pixels(corners: &[(i32, i32)]) -> Vec<Point> {
    corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

#[test]
fn a_bow_tie_is_exact() {
    check(&[pixels(&[(1, 6), (8, 6), (1, 13), (8, 13)])], window());
    check(&[pixels(&[(1, 6), (41, 6), (1, 39), (41, 39)])], window());
}

#[test]
fn stars_are_exact() {
    check_sub::<Sub8>(&[star(5, 2)], window());
    check_sub::<Sub8>(&[star(7, 3)], window());
    check_sub::<Sub8>(&[star(7, 2), star(5, 2)], window());
}

#[test]
fn holes_on_the_outer_ring_are_exact() {
    let outer = pixels(&[(2, 8), (30, 8), (30, 36), (2, 36)]);
    let at_a_vertex = pixels(&[(2, 8), (12, 14), (9, 20)]);
    let along_an_edge = pixels(&[(30, 12), (30, 22), (20, 22), (20, 12)]);
    let mut reversed = outer.clone();
    reversed.reverse();
    check(&[outer.clone(), at_a_vertex], window());
    check(&[outer.clone(), along_an_edge], window());
    check(&[outer.clone(), outer.clone()], window());
    check(&[outer, reversed], window());
}

#[test]
fn degenerate_contours_are_exact() {
    check(&[], window());
    check(&[vec![]], window());
    check(&[pixels(&[(5, 9)])], window());
    check(&[pixels(&[(5, 9), (20, 30)])], window());
    // Collinear and repeated vertices.
    check(
        &[pixels(&[
            (5, 9),
            (5, 9),
            (15, 9),
            (25, 9),
            (25, 9),
            (25, 20),
            (25, 31),
            (15, 20),
        ])],
        window(),
    );
    // A spike without width, up and to the side.
    check(
        &[pixels(&[
            (5, 20),
            (15, 20),
            (15, 8),
            (15, 20),
            (25, 20),
            (25, 30),
            (40, 30),
            (25, 30),
            (5, 30),
        ])],
        window(),
    );
}

#[test]
fn a_comb_with_the_finest_teeth_is_exact() {
    let mut comb = vec![(200, 2500)];
    for tooth in 0..200 {
        comb.push((200 + 40 * tooth, 9000));
        comb.push((201 + 40 * tooth, 9000));
        comb.push((201 + 40 * tooth, 2600));
    }
    comb.push((8300, 2500));
    check_sub::<Sub8>(&[comb], window());
}

#[test]
fn sixty_four_windings_are_exact() {
    let rings: Vec<Vec<Point>> = (0..64)
        .map(|ring| pixels(&[(ring % 8, 6 + ring / 8), (38, 7), (40, 40), (1, 38 - ring % 5)]))
        .collect();
    check(&rings, window());
    let same: Vec<Vec<Point>> = (0..64).map(|_| pixels(&[(2, 7), (38, 9), (30, 40)])).collect();
    check(&same, window());
}

#[test]
fn hilbert_curves_are_exact() {
    fn hilbert(order: u32, index: u32) -> (i32, i32) {
        let (mut x, mut y, mut rest) = (0, 0, index);
        let mut side = 1;
        while side < 1 << order {
            let right = 1 & (rest / 2);
            let up = 1 & (rest ^ right);
            if up == 0 {
                if right == 1 {
                    (x, y) = (side - 1 - x, side - 1 - y);
                }
                (x, y) = (y, x);
            }
            x += side * right;
            y += side * up;
            rest /= 4;
            side *= 2;
        }
        (x as i32, y as i32)
    }
    let curve: Vec<(i32, i32)> = (0..256)
        .map(|index| hilbert(4, index))
        .map(|(x, y)| (x * 2 + 2, y * 2 + 8))
        .collect();
    check(&[pixels(&curve)], window());
    let fine: Vec<(i32, i32)> = (0..256)
        .map(|index| hilbert(4, index))
        .map(|(x, y)| (x * 613 + 77, y * 551 + 1500))
        .collect();
    check_sub::<Sub8>(&[fine], window());
}

proptest! {
    #![proptest_config(config(cases(15, 120)))]

    /// The display panics on a pixel drawn twice; the union leaves none out.
    #[test]
    fn shared_edges_of_a_fan_are_drawn_once(hub in (20..44i32, 20..44i32), radii in prop::collection::vec(4..19i32, 3..9), flips in any::<u16>(), rotation in 0..3usize) {
        let count = radii.len();
        let rim: Vec<Point> = radii
            .iter()
            .enumerate()
            .map(|(index, &radius)| {
                let angle = std::f64::consts::TAU * index as f64 / count as f64;
                Point::new(hub.0 + (f64::from(radius) * angle.cos()) as i32, hub.1 + (f64::from(radius) * angle.sin()) as i32)
            })
            .collect();
        let hub = Point::new(hub.0, hub.1);
        let mut display = MockDisplay::new();
        for index in 0..count {
            let mut face = vec![hub, rim[index], rim[(index + 1) % count]];
            face.rotate_left(rotation);
            if flips >> index & 1 != 0 {
                face.reverse();
            }
            draw_face(&face, &mut display);
        }
        let mut whole = MockDisplay::new();
        draw_face(&rim, &mut whole);
        prop_assert!(display.eq(&whole), "{rim:?} {display:?} {whole:?}");
    }

    #[test]
    fn shared_edges_of_a_strip_are_drawn_once(heights in prop::collection::vec((2..30i32, 31..60i32), 2..8), flips in any::<u16>()) {
        let step = 60 / heights.len() as i32;
        let mut strip = Vec::new();
        for (index, &(top, bottom)) in heights.iter().enumerate() {
            strip.push(Point::new(index as i32 * step + 1, top));
            strip.push(Point::new(index as i32 * step + 3, bottom));
        }
        let mut display = MockDisplay::new();
        for (index, face) in strip.windows(3).enumerate() {
            let mut face = face.to_vec();
            if flips >> index & 1 != 0 {
                face.reverse();
            }
            draw_face(&face, &mut display);
        }
        let outline: Vec<Point> = strip.iter().step_by(2).copied().chain(strip.iter().skip(1).step_by(2).rev().copied()).collect();
        let mut whole = MockDisplay::new();
        draw_face(&outline, &mut whole);
        prop_assert!(display.eq(&whole), "{strip:?}");
    }
}

fn draw_face(face: &[Point], display: &mut MockDisplay<BinaryColor>) {
    let contours = [face];
    let prepared = Polygon::new(&contours, FillRule::NonZero).prepare::<16, 16>().unwrap();
    prepared
        .into_styled(PrimitiveStyle::with_fill(BinaryColor::On))
        .draw(display)
        .unwrap();
}

#[test]
fn a_full_table_leaves_the_polygon_usable() {
    let square = pixels(&[(1, 1), (5, 1), (5, 5), (1, 5)]);
    let contours: [&[Point]; 2] = [&square, &square];
    let polygon = Polygon::new(&contours, FillRule::NonZero);
    let full = polygon.prepare::<3, 4>().unwrap_err();
    assert_eq!(full, TooSmall::Edges(4));
    assert_eq!(
        full.to_string(),
        "the table of edges is too small: 4 are needed, raise its capacity"
    );
    assert_eq!(polygon.prepare::<4, 3>().unwrap_err(), TooSmall::ActiveEdges(4));
    let prepared = polygon.prepare::<4, 4>().unwrap();
    assert_eq!(prepared.edge_count(), 4);
    let mut display = MockDisplay::new();
    prepared
        .into_styled(PrimitiveStyle::with_fill(BinaryColor::On))
        .draw(&mut display)
        .unwrap();
    display.assert_pattern(&["     ", " ####", " ####", " ####", " ####"]);
}
