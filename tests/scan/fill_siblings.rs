//! All ways to fill a polygon or a triangle against winding numbers in `i128`, and so against each other.

use std::convert::Infallible;

use embedded_graphics::{geometry::Size, prelude::*, primitives::Rectangle};
use fixed::types::{I12F4, I24F8};
use proptest::{prelude::*, sample::select};
use zrow::{
    geometry::{self, DrawError, Sub4, Sub8, SubPixel, SubPoint, TooSmall, Vertex, Window},
    scan::{FillRule, Location, Polygons},
    surface::Span,
};

use crate::common::{cases, config, outlines::star};

const RULES: [FillRule; 2] = [FillRule::EvenOdd, FillRule::NonZero];

type Units = (i32, i32);
type Pixels = Vec<(i32, i32)>;

// The reference.

fn wide((x, y): Units) -> (i128, i128) {
    (i128::from(x), i128::from(y))
}

fn edges(contours: &[Vec<Units>]) -> impl Iterator<Item = ((i128, i128), (i128, i128))> {
    contours.iter().flat_map(|contour| {
        (0..contour.len()).map(|index| (wide(contour[index]), wide(contour[(index + 1) % contour.len()])))
    })
}

/// Edges at or left of a point, with their direction; an edge has its upper end and not its lower one.
fn winding(contours: &[Vec<Units>], (x, y): (i128, i128)) -> i128 {
    let mut winding = 0;
    for (from, to) in edges(contours) {
        let (direction, (x0, y0), (x1, y1)) = if from.1 < to.1 { (1, from, to) } else { (-1, to, from) };
        if y0 <= y && y < y1 && (x - x0) * (y1 - y0) >= (y - y0) * (x1 - x0) {
            winding += direction;
        }
    }
    winding
}

fn is_inside(winding: i128, rule: FillRule) -> bool {
    match rule {
        FillRule::EvenOdd => winding % 2 != 0,
        FillRule::NonZero => winding != 0,
    }
}

fn reference(contours: &[Vec<Units>], fraction_bits: u32, rule: FillRule, window: &Window) -> Pixels {
    let mut pixels = Vec::new();
    for y in window.top..window.bottom {
        for x in window.left..window.right {
            let centre = (i128::from(x) << fraction_bits, i128::from(y) << fraction_bits);
            if is_inside(winding(contours, centre), rule) {
                pixels.push((y, x));
            }
        }
    }
    pixels
}

fn reference_location(contours: &[Vec<Units>], rule: FillRule, point: Units) -> Location {
    let (x, y) = wide(point);
    let is_on = |(from, to): ((i128, i128), (i128, i128))| {
        (to.0 - from.0) * (y - from.1) == (to.1 - from.1) * (x - from.0)
            && from.0.min(to.0) <= x
            && x <= from.0.max(to.0)
            && from.1.min(to.1) <= y
            && y <= from.1.max(to.1)
    };
    if edges(contours).any(is_on) {
        Location::OnBoundary
    } else if is_inside(winding(contours, (x, y)), rule) {
        Location::Inside
    } else {
        Location::Outside
    }
}

// What is held against it.

/// Collects spans: each of them has pixels, and they come top to bottom and left to right without a pixel twice.
fn collected(window: &Window, fill: impl FnOnce(&mut dyn FnMut(Span) -> Result<(), Infallible>)) -> Pixels {
    let mut pixels = Pixels::new();
    fill(&mut |span| {
        assert!(span.start < span.end, "{span:?}");
        assert!(
            window.left <= span.start && span.end <= window.right,
            "{span:?} leaves {window:?}"
        );
        assert!(
            window.top <= span.y && span.y < window.bottom,
            "{span:?} leaves {window:?}"
        );
        if let Some(&(y, x)) = pixels.last() {
            assert!((y, x) < (span.y, span.start), "{span:?} after ({x}, {y})");
        }
        pixels.extend((span.start..span.end).map(|x| (span.y, x)));
        Ok(())
    });
    pixels
}

fn by_edge_table<V: Vertex>(contours: &[&[V]], rule: FillRule, window: &Window) -> Pixels {
    collected(window, |emit| {
        Polygons::scanline::<_, _, 1200>(contours, rule, window, emit).unwrap()
    })
}

/// Every way to fill a polygon, by name.
fn fills<V: Vertex>(contours: &[&[V]], rule: FillRule, window: &Window) -> Vec<(&'static str, Pixels)> {
    macro_rules! by_table {
        ($([$name:ident] [$($fill:tt)+])+) => {
            vec![$((
                stringify!($name),
                collected(window, |emit| $($fill)+::<_, _, 1200>(contours, rule, window, emit).unwrap()),
            )),+]
        };
    }
    macro_rules! by_test {
        ($([$name:ident] [$($test:tt)+])+) => {
            [$((
                stringify!($name),
                collected(window, |emit| {
                    let Ok(()) = Polygons::brute_force(contours, rule, window, $($test)+, emit);
                }),
            )),+]
        };
    }
    let mut fills = zrow_methods::polygon_fills!(by_table);
    fills.extend(zrow_methods::point_tests!(by_test));
    fills
}

/// Every test of a point, by name.
fn locations<V: Vertex>(contours: &[&[V]], rule: FillRule, point: &V) -> Vec<(&'static str, Location)> {
    macro_rules! located {
        ($([$name:ident] [$($test:tt)+])+) => {
            vec![$((stringify!($name), $($test)+(contours, rule, point))),+]
        };
    }
    zrow_methods::point_tests!(located)
}

/// Every way to fill a triangle, by name.
fn triangle_fills<S: SubPixel>(vertices: [SubPoint<S>; 3], window: &Window) -> Vec<(&'static str, Pixels)> {
    macro_rules! filled {
        ($([$name:ident] [$($fill:tt)+])+) => {
            [$((
                stringify!($name),
                collected(window, |emit| {
                    let Ok(()) = $($fill)+(vertices, window, emit);
                }),
            )),+]
        };
    }
    let mut fills = vec![("edge table", by_edge_table(&[&vertices], FillRule::EvenOdd, window))];
    fills.extend(zrow_methods::triangles!(filled));
    fills
}

// The checks.

/// A vertex made of units.
trait Snapped: Vertex {
    fn of(units: Units) -> Self;
}

impl Snapped for Point {
    fn of((x, y): Units) -> Self {
        Self::new(x, y)
    }
}

impl<S: SubPixel> Snapped for SubPoint<S> {
    fn of((x, y): Units) -> Self {
        Self::from_units(x, y).unwrap()
    }
}

/// The window as it is, one row of it, and one pixel.
fn windows(window: Window) -> [Window; 3] {
    let row = Window {
        top: window.top + 17,
        bottom: window.top + 18,
        ..window
    };
    let pixel = Window {
        left: window.left + 21,
        right: window.left + 22,
        ..row
    };
    [window, row, pixel]
}

fn check<V: Snapped>(contours: &[Vec<Units>], window: Window) {
    let points: Vec<Vec<V>> = contours
        .iter()
        .map(|contour| contour.iter().map(|&units| V::of(units)).collect())
        .collect();
    let slices: Vec<&[V]> = points.iter().map(Vec::as_slice).collect();
    for window in windows(window) {
        for rule in RULES {
            let expected = reference(contours, V::FRACTION_BITS, rule, &window);
            for (name, pixels) in fills(&slices, rule, &window) {
                assert_eq!(pixels, expected, "{name}, {rule:?}: {contours:?} in {window:?}");
            }
        }
    }
}

/// Asks for points all over a window, for all vertices and the middles of all edges.
fn check_locations<V: Snapped>(contours: &[Vec<Units>], positions: impl Iterator<Item = Units>) {
    let points: Vec<Vec<V>> = contours
        .iter()
        .map(|contour| contour.iter().map(|&units| V::of(units)).collect())
        .collect();
    let slices: Vec<&[V]> = points.iter().map(Vec::as_slice).collect();
    let middle = |a: i128, b: i128| ((a + b) / 2) as i32;
    let middles = edges(contours).map(|(from, to)| (middle(from.0, to.0), middle(from.1, to.1)));
    let vertices = contours.iter().flatten().copied();
    for position in positions.chain(vertices).chain(middles) {
        for rule in RULES {
            let expected = reference_location(contours, rule, position);
            for (name, location) in locations(&slices, rule, &V::of(position)) {
                assert_eq!(location, expected, "{name}, {rule:?}: {position:?} in {contours:?}");
            }
        }
    }
}

fn check_triangle<S: SubPixel>([a, b, c]: [Units; 3], window: Window) {
    for window in windows(window) {
        let expected = reference(&[vec![a, b, c]], S::FRACTION_BITS, FillRule::NonZero, &window);
        for order in [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
            for (name, pixels) in triangle_fills::<S>(order.map(SubPoint::of), &window) {
                assert_eq!(pixels, expected, "{name}: {order:?} in {window:?}");
            }
        }
    }
}

fn window() -> Window {
    Window::from(Rectangle::new(Point::new(-3, 5), Size::new(44, 38)))
}

// Random polygons.

/// Vertices at rising angles around a centre: simple, seldom convex.
fn simple(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    let centre = (0..side, 0..side);
    let radii = prop::collection::vec(0.05..0.6f64, 3..14);
    (centre, radii, any::<bool>()).prop_map(move |((x, y), radii, reversed)| {
        let contour = radii.iter().enumerate().map(|(index, radius)| {
            let angle = std::f64::consts::TAU * index as f64 / radii.len() as f64;
            let radius = radius * f64::from(side);
            (x + (radius * angle.cos()) as i32, y + (radius * angle.sin()) as i32)
        });
        let mut contour: Vec<Units> = contour.collect();
        if reversed {
            contour.reverse();
        }
        vec![contour]
    })
}

fn self_crossing(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    let vertex = (-side / 4..side * 5 / 4, -side / 4..side * 5 / 4);
    prop::collection::vec(prop::collection::vec(vertex, 0..12), 0..3)
}

/// A ring around one or two smaller ones, each in either direction; they may touch, cross or leave it.
fn with_holes(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    (simple(side), prop::collection::vec(simple(side / 3), 1..3), 0..side / 2).prop_map(|(mut outer, holes, offset)| {
        let moved = |(x, y): Units| (x + offset, y + offset);
        outer.extend(
            holes
                .into_iter()
                .flatten()
                .map(|hole| hole.into_iter().map(moved).collect()),
        );
        outer
    })
}

/// Few coordinates, so that vertices meet vertices, edges and pixel centres.
fn coarse(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    let coordinate = move || (0..8).prop_map(move |eighth| eighth * (side / 8));
    prop::collection::vec(prop::collection::vec((coordinate(), coordinate()), 0..9), 1..4)
}

fn polygon(side: i32) -> impl Strategy<Value = Vec<Vec<Units>>> {
    prop_oneof![simple(side), self_crossing(side), with_holes(side), coarse(side)]
}

proptest! {
    #![proptest_config(config(cases(100, 1_000)))]

    #[test]
    fn random_polygons_of_pixels_are_the_same(contours in polygon(48)) {
        check::<Point>(&contours, window());
    }
}

proptest! {
    #![proptest_config(config(cases(50, 500)))]

    #[test]
    fn random_polygons_of_sixteenths_are_the_same(contours in polygon(48 * 16)) {
        check::<SubPoint<Sub4>>(&contours, window());
    }

    #[test]
    fn random_polygons_of_256ths_are_the_same(contours in polygon(48 * 256)) {
        check::<SubPoint<Sub8>>(&contours, window());
    }

    #[test]
    fn random_points_are_where_they_are(contours in polygon(16), far in prop::collection::vec((any::<i32>(), any::<i32>()), 8)) {
        let near = (-2..18).flat_map(|y| (-2..18).map(move |x| (x, y)));
        check_locations::<Point>(&contours, near.chain(far));
    }
}

/// Numbers at the ends of the range and around the window.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        3 => -10..60i32,
        2 => any::<i32>(),
        2 => select(vec![i32::MIN, i32::MIN + 1, i32::MAX, i32::MAX - 1, 0, -8191, 8191, -4, -3, 41, 42, 4, 5]),
    ]
}

proptest! {
    #![proptest_config(config(cases(50, 400)))]

    #[test]
    fn polygons_beyond_everything_are_the_same(contours in prop::collection::vec(prop::collection::vec((coordinate(), coordinate()), 0..7), 0..3)) {
        check::<Point>(&contours, window());
        check_locations::<Point>(&contours, [(i32::MIN, i32::MAX), (i32::MIN, 0), (0, i32::MAX), (7, 9)].into_iter());
    }

    #[test]
    fn a_window_at_the_end_of_the_numbers_is_as_good(contours in prop::collection::vec(prop::collection::vec((0..40i32, 0..40i32), 3..7), 1..3), low in any::<bool>()) {
        let moved = |(x, y): Units| if low { (i32::MIN + x, i32::MIN + y) } else { (i32::MAX - x, i32::MAX - y) };
        let contours: Vec<Vec<Units>> = contours.into_iter().map(|contour| contour.into_iter().map(moved).collect()).collect();
        let corner = if low { i32::MIN } else { i32::MAX - 38 };
        check::<Point>(&contours, Window { left: corner, top: corner, right: corner + 38, bottom: corner + 38 });
    }

    #[test]
    fn polygons_to_the_ends_of_the_domain_are_the_same(contours in prop::collection::vec(prop::collection::vec((Sub8::MIN_UNITS..=Sub8::MAX_UNITS, Sub8::MIN_UNITS..=Sub8::MAX_UNITS), 3..7), 0..3)) {
        check::<SubPoint<Sub8>>(&contours, window());
    }
}

// Random triangles.

fn triangle(low: i32, high: i32) -> impl Strategy<Value = [Units; 3]> {
    let vertex = || (low..=high, low..=high);
    [vertex(), vertex(), vertex()]
}

/// Three vertices nearly on a line.
fn sliver(side: i32) -> impl Strategy<Value = [Units; 3]> {
    let end = || (-side / 4..side * 5 / 4, -side / 4..side * 5 / 4);
    (end(), end(), 0..=16i32, (-2..=2i32, -2..=2i32)).prop_map(|(a, b, part, (x, y))| {
        let between = |from: i32, to: i32| from + (to - from) * part / 16;
        [a, b, (between(a.0, b.0) + x, between(a.1, b.1) + y)]
    })
}

proptest! {
    #![proptest_config(config(cases(75, 700)))]

    #[test]
    fn triangles_of_sixteenths_are_the_same(vertices in prop_oneof![triangle(-200, 900), triangle(-100, 100), sliver(700)]) {
        check_triangle::<Sub4>(vertices, window());
    }

    #[test]
    fn triangles_of_256ths_are_the_same(vertices in prop_oneof![triangle(-3000, 14_000), triangle(0, 3000), sliver(11_000)]) {
        check_triangle::<Sub8>(vertices, window());
    }

    #[test]
    fn triangles_with_vertices_on_pixel_centres_are_the_same(vertices in prop_oneof![triangle(-4, 48), triangle(4, 16)]) {
        check_triangle::<Sub4>(vertices.map(|(x, y)| (x * 16, y * 16)), window());
        check_triangle::<Sub8>(vertices.map(|(x, y)| (x * 256, y * 256)), window());
    }

    #[test]
    fn triangles_to_the_ends_of_the_domain_are_the_same(fine in triangle(Sub8::MIN_UNITS, Sub8::MAX_UNITS), coarse in triangle(Sub4::MIN_UNITS, Sub4::MAX_UNITS)) {
        check_triangle::<Sub8>(fine, window());
        check_triangle::<Sub4>(coarse, window());
    }
}

/// The corners of the domain, and what lies between them, in windows where an edge function takes more than 32 bits.
#[test]
fn the_largest_triangles_are_the_same() {
    let ends = [Sub8::MIN_UNITS, Sub8::MIN_UNITS + 1, 77, Sub8::MAX_UNITS];
    let corners: Vec<Units> = ends.iter().flat_map(|&x| ends.iter().map(move |&y| (x, y))).collect();
    let rows = |top, height| Window {
        left: -8200,
        top,
        right: 8200,
        bottom: top + height,
    };
    let column = Window {
        left: -3,
        top: -8200,
        right: 5,
        bottom: 8200,
    };
    for (index, &a) in corners.iter().enumerate() {
        for &b in &corners[index + 1..] {
            for &c in corners.iter().step_by(3) {
                for window in [rows(-8192, 2), rows(-1, 3), column] {
                    // The scan line is checked above, also for large ones.
                    let fills = triangle_fills::<Sub8>([a, b, c].map(SubPoint::of), &window);
                    let expected = &fills[0].1;
                    for (name, pixels) in &fills[1..] {
                        assert!(pixels == expected, "{name}: {:?} in {window:?}", [a, b, c]);
                    }
                }
            }
        }
    }
}

/// Coordinates that no constructor makes: any pixels or none, in the window, and no panic.
#[test]
fn triangles_beyond_the_domain_end() {
    let ends = [i32::MIN, -1, i32::MAX];
    let everything = Window {
        left: i32::MIN,
        top: i32::MIN,
        right: i32::MAX,
        bottom: i32::MAX,
    };
    for index in 0..729usize {
        let end = |digit: u32| ends[index / 3usize.pow(digit) % 3];
        let fine = |digit| SubPoint::<Sub8> {
            x: I24F8::from_bits(end(digit)),
            y: I24F8::from_bits(end(digit + 1)),
        };
        let coarse = |digit| SubPoint::<Sub4> {
            x: I12F4::from_bits(end(digit) as i16),
            y: I12F4::from_bits((end(digit + 1) >> 16) as i16),
        };
        for window in [everything, window(), Window::EMPTY] {
            let (fine, coarse) = ([fine(0), fine(2), fine(4)], [coarse(0), coarse(2), coarse(4)]);
            macro_rules! fill {
                ($([$name:ident] [$($fill:tt)+])+) => {
                    $(
                        let _ = $($fill)+(fine, &window, |span| first_only(span, &window));
                        let _ = $($fill)+(coarse, &window, |span| first_only(span, &window));
                    )+
                };
            }
            zrow_methods::triangles!(fill);
        }
    }
}

/// Stops at the first span.
fn first_only(span: Span, window: &Window) -> Result<(), ()> {
    assert!(window.contains(Point::new(span.start, span.y)));
    Err(())
}

// Hard cases.

/// As pixels, in sixteenths and in 256ths.
fn check_all(contours: &[Vec<Units>]) {
    let times = |factor: i32| -> Vec<Vec<Units>> {
        let scaled = |&(x, y): &Units| (x * factor, y * factor);
        contours
            .iter()
            .map(|contour| contour.iter().map(scaled).collect())
            .collect()
    };
    check::<Point>(contours, window());
    check::<SubPoint<Sub4>>(&times(16), window());
    check::<SubPoint<Sub8>>(&times(256), window());
    let everywhere = (-6..46).flat_map(|y| (-6..46).map(move |x| (x, y)));
    check_locations::<Point>(contours, everywhere);
}

#[test]
fn bow_ties_and_stars_are_the_same() {
    check_all(&[vec![(1, 6), (8, 6), (1, 13), (8, 13)]]);
    check_all(&[vec![(1, 6), (38, 6), (1, 39), (38, 39)]]);
    for stars in [vec![star(5, 2)], vec![star(7, 3)], vec![star(7, 2), star(5, 2)]] {
        check::<SubPoint<Sub8>>(&stars, window());
        let pixels: Vec<Vec<Units>> = stars
            .iter()
            .map(|star| star.iter().map(|&(x, y)| (x >> 8, y >> 8)).collect())
            .collect();
        check_all(&pixels);
    }
}

#[test]
fn holes_that_touch_are_the_same() {
    let outer = vec![(2, 8), (30, 8), (30, 36), (2, 36)];
    let at_a_vertex = vec![(2, 8), (12, 14), (9, 20)];
    let along_an_edge = vec![(30, 12), (30, 22), (20, 22), (20, 12)];
    let reversed: Vec<Units> = outer.iter().rev().copied().collect();
    for inner in [at_a_vertex, along_an_edge, outer.clone(), reversed] {
        check_all(&[outer.clone(), inner.clone()]);
        check_all(&[inner.into_iter().rev().collect(), outer.clone()]);
    }
}

#[test]
fn degenerate_contours_are_the_same() {
    check_all(&[]);
    check_all(&[vec![]]);
    check_all(&[vec![(5, 9)]]);
    check_all(&[vec![(5, 9), (5, 9)], vec![], vec![(6, 9), (20, 9), (12, 9)]]);
    check_all(&[vec![(5, 9), (20, 30)]]);
    // Collinear and repeated vertices.
    check_all(&[vec![
        (5, 9),
        (5, 9),
        (15, 9),
        (25, 9),
        (25, 9),
        (25, 20),
        (25, 31),
        (15, 20),
    ]]);
    // Spikes without width, up, to the side and down, and one along a row and back.
    check_all(&[vec![
        (5, 20),
        (15, 20),
        (15, 8),
        (15, 20),
        (25, 20),
        (25, 30),
        (40, 30),
        (25, 30),
        (12, 30),
        (12, 38),
        (12, 30),
        (5, 30),
        (-2, 30),
        (5, 30),
    ]]);
    // Vertices that pass the row, return from it, and run along it on both sides.
    check_all(&[vec![
        (0, 20),
        (5, 20),
        (10, 10),
        (15, 20),
        (20, 20),
        (25, 30),
        (30, 20),
        (35, 20),
        (35, 10),
        (40, 20),
        (38, 35),
        (2, 35),
    ]]);
}

#[test]
fn combs_with_the_finest_teeth_are_the_same() {
    for spacing in [40, 256] {
        let mut comb = vec![(200, 2500)];
        for tooth in 0..10_000 / spacing {
            comb.push((200 + spacing * tooth, 9000));
            comb.push((201 + spacing * tooth, 9000));
            comb.push((201 + spacing * tooth, 2600));
        }
        comb.push((10_300, 2500));
        check::<SubPoint<Sub8>>(&[comb.clone()], window());
        let upright: Vec<Units> = comb.into_iter().map(|(x, y)| (y, x)).collect();
        check::<SubPoint<Sub8>>(&[upright], window());
    }
}

#[test]
fn overlapping_windings_are_the_same() {
    let ring = vec![(1, 7), (40, 9), (38, 40), (3, 37)];
    for times in [63, 64, 128, 255] {
        check::<Point>(&vec![ring.clone(); times], window());
    }
    let mut both_ways = vec![ring.clone(); 64];
    both_ways.extend(vec![ring.into_iter().rev().collect::<Vec<Units>>(); 64]);
    check::<Point>(&both_ways, window());
    let spiral: Vec<Units> = (0..64 * 4)
        .map(|corner| {
            let reach = 2 + corner / 16;
            let (x, y) = [(-1, -1), (1, -1), (1, 1), (-1, 1)][corner as usize % 4];
            (20 + x * reach, 24 + y * reach)
        })
        .collect();
    check::<Point>(&[spiral], window());
}

#[test]
fn nearly_level_edges_are_the_same() {
    for rise in [-64, -3, -1, 0, 1, 2, 63] {
        let contour = vec![(20, 5000), (9000, 5000 + rise), (9500, 5100 + rise), (100, 5090)];
        check::<SubPoint<Sub8>>(&[contour], window());
    }
}

// Triangles that meet.

/// Each pixel of a fan belongs to one triangle: no gaps, and none twice.
#[test]
fn triangles_of_a_fan_share_no_pixel() {
    let rim = star(11, 1);
    let hub = (5301, 6250);
    let whole = reference(std::slice::from_ref(&rim), 8, FillRule::NonZero, &window());
    for way in 0..5 {
        let mut drawn = Pixels::new();
        for (index, &corner) in rim.iter().enumerate() {
            let mut face = [hub, corner, rim[(index + 1) % rim.len()]];
            face.rotate_left(index % 3);
            if index % 2 == 0 {
                face.reverse();
            }
            let fills = triangle_fills::<Sub8>(face.map(SubPoint::of), &window());
            let (_, pixels) = &fills[way];
            drawn.extend(pixels);
        }
        drawn.sort_unstable();
        assert_eq!(drawn, whole);
    }
}

// Errors.

#[test]
fn a_full_table_of_crossings_says_how_much_would_do() {
    let square = [(1, 1), (5, 1), (5, 5), (1, 5)].map(|(x, y)| Point::new(x, y));
    let contours: [&[Point]; 3] = [&square, &square, &square];
    let window = Window {
        left: -10,
        top: -10,
        right: 10,
        bottom: 10,
    };
    let mut spans = 0;
    let mut count = |_: Span| {
        spans += 1;
        Ok::<(), Infallible>(())
    };
    let full = TooSmall {
        table: geometry::Table::Crossings,
        needed: 6,
    };
    assert_eq!(
        Polygons::naive_scanline::<_, _, 5>(&contours, FillRule::NonZero, &window, &mut count),
        Err(DrawError::TooSmall(full))
    );
    assert_eq!(
        full.to_string(),
        "the table of crossings is too small: 6 are needed, raise its capacity"
    );
    // Nothing visible takes no slot.
    for elsewhere in [
        Window::EMPTY,
        Window { bottom: 1, ..window },
        Window { left: 6, ..window },
    ] {
        let filled = Polygons::naive_scanline::<_, _, 0>(&contours, FillRule::NonZero, &elsewhere, &mut count);
        assert_eq!(filled, Ok(()));
    }
    assert_eq!(spans, 0);
    let pixels = collected(&window, |emit| {
        Polygons::naive_scanline::<_, _, 6>(&contours, FillRule::NonZero, &window, emit).unwrap();
    });
    assert_eq!(pixels.len(), 16);
}

/// Two of the six sides are level and take no edge.
#[test]
fn a_scanline_fill_says_how_many_edges_it_needs() {
    let corners = [(0, 0), (9, 0), (9, 9), (6, 9), (5, 4), (0, 9)].map(|(x, y)| Point::new(x, y));
    let window = window();
    let nothing = |_: Span| Err("handed over");
    assert_eq!(
        Polygons::scanline::<_, _, 3>(&[&corners], FillRule::NonZero, &window, nothing),
        Err(DrawError::TooSmall(TooSmall {
            table: geometry::Table::Edges,
            needed: 4,
        }))
    );
    let pixels = collected(&window, |emit| {
        Polygons::scanline::<_, _, 4>(&[&corners], FillRule::NonZero, &window, emit).unwrap();
    });
    let units = vec![corners.map(|corner| (corner.x, corner.y)).to_vec()];
    assert_eq!(pixels, reference(&units, 0, FillRule::NonZero, &window));
}

type Emit<'a> = dyn FnMut(Span) -> Result<(), u8> + 'a;

#[test]
fn the_first_error_of_emit_ends_a_fill() {
    let vertices = [(0, 8 * 16), (30 * 16, 8 * 16), (0, 38 * 16)].map(SubPoint::<Sub4>::of);
    let contours: [&[SubPoint<Sub4>]; 1] = [&vertices];
    let window = window();
    let third = |fill: &dyn Fn(&mut Emit<'_>) -> bool| {
        let mut calls = 0;
        let ended = fill(&mut |_| {
            calls += 1;
            if calls == 3 { Err(7) } else { Ok(()) }
        });
        assert!(ended);
        assert_eq!(calls, 3);
    };
    let rule = FillRule::NonZero;
    macro_rules! by_table {
        ($([$name:ident] [$($fill:tt)+])+) => {
            $(third(&|emit| $($fill)+::<_, _, 4>(&contours, rule, &window, emit) == Err(DrawError::Target(7)));)+
        };
    }
    macro_rules! by_test {
        ($([$name:ident] [$($test:tt)+])+) => {
            $(third(&|emit| Polygons::brute_force(&contours, rule, &window, $($test)+, emit) == Err(7));)+
        };
    }
    macro_rules! triangles {
        ($([$name:ident] [$($fill:tt)+])+) => {
            $(third(&|emit| $($fill)+(vertices, &window, emit) == Err(7));)+
        };
    }
    zrow_methods::polygon_fills!(by_table);
    zrow_methods::point_tests!(by_test);
    zrow_methods::triangles!(triangles);
}
