//! Outlines with corners anywhere: what leaves the domain is an error, and everything else is the same in all bands.

use embedded_graphics::pixelcolor::Rgb565;
use fixed::types::{I24F8, U0F16, U24F8};
use proptest::prelude::*;
use zrow::{
    band::Supersampling,
    coverage::CoverageMethod,
    draw::{AntialiasedPolygon, FillRule, SubArc, SubEllipse, SubLine, SubOutline},
    geometry::{InputError, Sub8, SubPixel, SubPoint, TooSmall, Window},
};

use crate::common::numbers::any_number;
use crate::common::{cases, config};

/// A number in the domain, or nearly.
fn domain_number() -> impl Strategy<Value = i32> {
    prop_oneof![
        2 => Sub8::MIN_UNITS..=Sub8::MAX_UNITS,
        2 => -4_000..4_000i32,
        1 => (-1..=1i32, any::<bool>()).prop_map(|(aside, is_least)| {
            (if is_least { Sub8::MIN_UNITS } else { Sub8::MAX_UNITS }) + aside
        }),
    ]
}

fn made_by_hand((x, y): (i32, i32)) -> SubPoint<Sub8> {
    SubPoint {
        x: I24F8::from_bits(x),
        y: I24F8::from_bits(y),
    }
}

fn out_of_domain() -> InputError {
    InputError::OutOfDomain { min: -8191, max: 8191 }
}

/// Whether a square of that half side around a point lies in the domain.
fn has_room((x, y): (i32, i32), extent: u32) -> bool {
    let domain = i128::from(Sub8::MIN_UNITS)..=i128::from(Sub8::MAX_UNITS);
    [x, y]
        .map(i128::from)
        .iter()
        .all(|units| domain.contains(&(units - i128::from(extent))) && domain.contains(&(units + i128::from(extent))))
}

/// The edges of an outline, each of whose corners is in the domain.
fn edges_in_domain(outline: &dyn SubOutline) -> usize {
    let mut count = 0;
    outline.edges(&mut |from, to| {
        for corner in [from, to] {
            assert!(has_room((corner[0], corner[1]), 0), "{corner:?}");
        }
        count += 1;
    });
    count
}

proptest! {
    #![proptest_config(config(cases(20_000, 20_000)))]

    /// A line, an ellipse or an arc is one exactly where all of its box lies in the domain, and has no corner outside.
    #[test]
    fn outlines_stay_in_the_domain(
        start in prop_oneof![(any_number(), any_number()), (domain_number(), domain_number())],
        end in prop_oneof![(any_number(), any_number()), (domain_number(), domain_number())],
        width in prop_oneof![any::<u32>(), 0..600u32, any_number().prop_map(|number| number as u32)],
        other_radius in prop_oneof![any::<u32>(), 0..600u32],
        angle: u16,
        sweep: u16,
    ) {
        let (from, to) = (made_by_hand(start), made_by_hand(end));
        let line = SubLine::new(from, to, U24F8::from_bits(width));
        let fits = has_room(start, width / 2 + 1) && has_room(end, width / 2 + 1);
        prop_assert_eq!(line.err(), (!fits).then(out_of_domain));
        if let Ok(line) = line {
            prop_assert_eq!(edges_in_domain(&line), if start == end { 0 } else { 4 });
        }

        let radii = [width, other_radius].map(U24F8::from_bits);
        let fits = has_room(start, width.max(other_radius));
        let ellipse = SubEllipse::new(from, radii);
        prop_assert_eq!(ellipse.err(), (!fits).then(out_of_domain));
        if let Ok(ellipse) = ellipse {
            prop_assert_eq!(edges_in_domain(&ellipse), ellipse.edge_count());
            let is_point = radii == [U24F8::ZERO; 2];
            let expected = if is_point { 1..=1 } else { 8..=1_612 };
            prop_assert!(expected.contains(&ellipse.edge_count()));
        }
        let arc = SubArc::new(from, radii, U0F16::from_bits(angle), U0F16::from_bits(sweep));
        prop_assert_eq!(arc.err(), (!fits).then(out_of_domain));
        if let Ok(arc) = arc {
            // Two corners along each radius, one where that is 0.
            let along = |radius: U24F8| if radius == U24F8::ZERO { 1 } else { 2 };
            prop_assert!(edges_in_domain(&arc) >= radii.map(along).iter().sum::<usize>());
        }
    }
}

/// The coverage of each pixel of a window, in bands of so many rows.
fn coverages<T: CoverageMethod>(
    method: &T,
    polygon: &AntialiasedPolygon<16, 16>,
    window: Window,
    rows: usize,
) -> Vec<u8> {
    let (width, height) = (window.width() as usize, window.height() as usize);
    let mut pixels = vec![0; width * height];
    let mut row_memory = vec![T::Cell::default(); T::cells(width)];
    for (top, pixels) in (window.top..).step_by(rows).zip(pixels.chunks_mut(width * rows)) {
        let bottom = window.bottom.min(top + rows as i32);
        let band = Window { top, bottom, ..window };
        let covered = polygon.cover(method, &band, &mut row_memory, |span, coverage| {
            let row = (span.y - top) as usize * width;
            let columns = (span.start - window.left) as usize..(span.end - window.left) as usize;
            pixels[row..row + width][columns].fill(coverage);
            Ok::<_, TooSmall>(())
        });
        assert_eq!(covered, Ok(()));
    }
    pixels
}

fn check_bands<T: CoverageMethod>(
    name: &str,
    method: &T,
    polygon: &AntialiasedPolygon<16, 16>,
    window: Window,
) -> Result<(), TestCaseError> {
    let whole = coverages(method, polygon, window, 8);
    prop_assert_eq!(&coverages(method, polygon, window, 1), &whole, "{}, {:?}", name, window);
    prop_assert_eq!(&coverages(method, polygon, window, 3), &whole, "{}, {:?}", name, window);
    Ok(())
}

proptest! {
    #![proptest_config(config(cases(4_000, 4_000)))]

    /// An outline with a corner outside the domain is an error; any other has the same coverage in bands of any height.
    #[test]
    fn an_outline_of_any_points_is_an_error_or_the_same_in_all_bands(
        corners in prop::collection::vec(
            prop_oneof![4 => (domain_number(), domain_number()), 1 => (any_number(), any_number())],
            0..6,
        ),
        at in any::<prop::sample::Index>(),
        aside in (-20..4i32, -6..2i32),
        rule in prop::sample::select(vec![FillRule::NonZero, FillRule::EvenOdd]),
    ) {
        let points: Vec<SubPoint<Sub8>> = corners.iter().copied().map(made_by_hand).collect();
        let contours = [points.as_slice()];
        let polygon = AntialiasedPolygon::<16, 16>::prepare(&contours, rule);
        if corners.iter().any(|&corner| !has_room(corner, 0)) {
            prop_assert_eq!(polygon.err(), Some(out_of_domain()));
            return Ok(());
        }
        let polygon = polygon.unwrap();
        // Any number of points asks for a method.
        polygon.exact_method(&contours);
        if corners.is_empty() {
            return Ok(());
        }
        let (x, y) = *at.get(&corners);
        let (left, top) = ((x >> 8) + aside.0, (y >> 8) + aside.1);
        let window = Window { left, top, right: left + 24, bottom: top + 8 };
        macro_rules! check_each {
            ($([$name:ident] [$($method:tt)+])+) => {
                $(check_bands(stringify!($name), &<$($method)+>::default(), &polygon, window)?;)+
            };
        }
        zrow_methods::coverage_methods!(check_each);
    }

    /// An outline of the user's own that leaves the domain is an error too, and any policy says some method for it.
    #[test]
    fn an_outline_of_ones_own_has_the_same_domain(corners in prop::collection::vec((any_number(), any_number()), 1..6)) {
        struct Own(Vec<(i32, i32)>);
        impl SubOutline for Own {
            fn edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
                for (from, to) in self.0.iter().zip(self.0.iter().cycle().skip(1)) {
                    edge((*from).into(), (*to).into());
                }
            }
        }
        let is_inside = corners.iter().all(|&corner| has_room(corner, 0));
        let own = Own(corners);
        let polygon = AntialiasedPolygon::<16, 16>::prepare(&own, FillRule::NonZero);
        prop_assert_eq!(polygon.err(), (!is_inside).then(out_of_domain));
        let square = [(0, 0), (900, 0), (900, 900), (0, 900)].map(made_by_hand);
        let other = AntialiasedPolygon::<16, 16>::prepare(&[square.as_slice()], FillRule::NonZero).unwrap();
        other.exact_method(&own);
    }
}

/// The centre of a pixel is the middle of its 4 x 4 samples: against 64 bits, also where an `i32` wraps into the domain.
#[test]
fn positions_are_enlarged_or_refused() {
    let extremes = [i32::MIN, i32::MAX, i32::MAX - 127, 1 << 30, (1 << 30) - 128];
    let near = [
        Sub8::MIN_UNITS,
        Sub8::MAX_UNITS,
        Sub8::MAX_UNITS / 4,
        -524_320,
        524_128,
        524_127,
        0,
        -128,
    ];
    for x in extremes.into_iter().chain(near) {
        let sample = (i64::from(x) + 128) * 4 - 128;
        let expected = i32::try_from(sample).map_or(Err(out_of_domain()), |sample| SubPoint::from_units(sample, 384));
        assert_eq!(
            Supersampling::<Rgb565, 4>::enlarged(made_by_hand((x, 0))),
            expected,
            "{x}"
        );
    }
}
