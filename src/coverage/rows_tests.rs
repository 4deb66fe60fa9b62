//! The protocol between shapes and methods: the segments that an edge is cut into, exactly, and what methods make of any segments.

use std::{vec, vec::Vec};

use proptest::{prelude::*, test_runner::RngSeed};

use super::{
    edges::{AntialiasedEdge, RowSegment, Rows},
    *,
};
use crate::{
    coverage::edges::{X_ONE, Y_ONE},
    geometry::SubPoint,
    surface::Span,
};

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(0x0123_4567),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// Coordinates in 1/256 pixel: close together, near the ends of the domain, and any.
fn units() -> impl Strategy<Value = i32> + Clone {
    prop_oneof![
        4 => -3_000..3_000,
        1 => (0..3_000).prop_map(|units| Sub8::MAX_UNITS - units),
        1 => (0..3_000).prop_map(|units| Sub8::MIN_UNITS + units),
        2 => Sub8::MIN_UNITS..=Sub8::MAX_UNITS,
    ]
}

fn point() -> impl Strategy<Value = SubPoint<Sub8>> + Clone {
    (units(), units()).prop_map(|(x, y)| SubPoint::from_units(x, y).unwrap())
}

/// To the nearest, ties upwards.
fn nearest(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

/// (x, y) in 1/256 pixel from the corner of a pixel, where a point is given from its centre.
fn from_corner(point: SubPoint<Sub8>) -> [i128; 2] {
    [point.x_units(), point.y_units()].map(|units| i128::from(units) + 128)
}

/// The columns of a segment at its top and its bottom, and the two rows, in the units of a row.
fn corners(segment: &RowSegment) -> [(i128, i128); 2] {
    [
        (segment.x_top.into(), segment.y_top.into()),
        (segment.x_bottom.into(), segment.y_bottom.into()),
    ]
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn an_edge_crosses_rows_exactly(from in point(), to in point(), row: u32, any_row: i32, ordinate: u8) {
        let (a, b) = (from_corner(from), from_corner(to));
        let Some(edge) = AntialiasedEdge::new(&from, &to) else {
            prop_assert_eq!(a[1], b[1]);
            return Ok(());
        };
        let (top, bottom) = if a[1] < b[1] { (a, b) } else { (b, a) };
        let unit = i128::from(Y_ONE);
        let (first, end) = (top[1].div_euclid(unit), -((-bottom[1]).div_euclid(unit)));
        prop_assert_eq!((i128::from(edge.first_row()), i128::from(edge.end_row())), (first, end));
        let fine = i128::from(X_ONE / Y_ONE);
        let (dx, dy) = (bottom[0] - top[0], bottom[1] - top[1]);
        // Where it passes an ordinate, in 1/8192 pixel, rounded to the nearest.
        let column = |y: i128| fine * top[0] + nearest(fine * dx * (y - top[1]), dy);
        let row = first + i128::from(row) % (end - first);
        let mut segment = edge.begin(row as i32);
        for row in row..end.min(row + 3) {
            let (from_y, to_y) = (top[1].max(row * unit), bottom[1].min((row + 1) * unit));
            prop_assert_eq!(
                corners(&segment),
                [(column(from_y), from_y - row * unit), (column(to_y), to_y - row * unit)],
                "row {}", row
            );
            let ends = segment.ends();
            prop_assert_eq!(
                ends,
                (segment.x_top.min(segment.x_bottom), segment.x_top.max(segment.x_bottom))
            );
            let height = (to_y - from_y) as i32;
            prop_assert_eq!(segment.signed_height(), (height << 6) * segment.winding);
            let ordinate = segment.y_top + i32::from(ordinate) * height / 255;
            let x = segment.x_at(ordinate);
            prop_assert!(ends.0 <= x && x <= ends.1, "{} at {}", x, ordinate);
            // Steps lead from a whole row to a whole row.
            if i128::from(segment.last_row()) <= row + 1 || segment.y_top > 0 {
                break;
            }
            segment.step();
        }
        // Any row, and what follows on it: numbers, and no panic.
        let mut segment = edge.begin(any_row);
        segment.step();
        let _ = (segment.x_at(ordinate.into()), segment.ends(), segment.last_row());
    }
}

/// Whatever the segments, columns and row memory are, what a method hands over is in the columns, from left to right.
fn check_row<T: CoverageMethod>(
    method: &T,
    segments: &[RowSegment],
    rule: FillRule,
    columns: &Range<i32>,
    cells: usize,
) {
    let mut last = columns.start;
    let covered = method.cover_row(
        &mut segments.to_vec(),
        rule,
        columns.clone(),
        &mut vec![T::Cell::default(); cells],
        &mut |span: Range<i32>, _: u8| {
            assert!(
                last <= span.start && span.start < span.end && span.end <= columns.end,
                "{span:?} in {columns:?}"
            );
            last = span.end;
            Ok::<(), ()>(())
        },
    );
    assert_eq!(covered, Ok(()));
}

/// The masks of a pattern have no other bits than those of its samples.
fn check_samples<T: SamplePattern>(
    method: &T,
    segments: &[RowSegment],
    rule: FillRule,
    columns: &Range<i32>,
    cells: usize,
) {
    let memory = &mut vec![T::Cell::default(); cells];
    let sampled = method.sample_row(&mut segments.to_vec(), rule, columns.clone(), memory, |_, mask| {
        assert_eq!(mask & !(u32::MAX >> (32 - T::SAMPLES)), 0);
        Ok::<(), ()>(())
    });
    assert_eq!(sampled, Ok(()));
}

proptest! {
    #![proptest_config(config(3_000))]

    /// Segments may be none of this row, row memory too short, and columns reversed or anywhere.
    #[test]
    fn any_segments_are_covered_in_the_columns(
        ends in prop::collection::vec((point(), point()), 0..6),
        row in prop_oneof![-12..12i32, any::<i32>()],
        columns in prop_oneof![(-12..12i32, -12..40i32), any::<(i32, i32)>()],
        cells in 0..60usize,
        is_even_odd: bool,
    ) {
        let edges = ends.iter().filter_map(|(from, to)| AntialiasedEdge::new(from, to));
        let segments: Vec<RowSegment> = edges.map(|edge| edge.begin(row)).collect();
        let rule = if is_even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let columns = Range { start: columns.0, end: columns.1 };
        let columns = &columns;
        macro_rules! check_rows {
            ($([$name:ident] [$($method:tt)+])+) => {
                $(check_row(&<$($method)+>::default(), &segments, rule, columns, cells);)+
            };
        }
        macro_rules! check_masks {
            ($([$name:ident] [$($pattern:tt)+])+) => {
                $(check_samples(&<$($pattern)+>::default(), &segments, rule, columns, cells);)+
            };
        }
        zrow_methods::coverage_methods!(check_rows);
        zrow_methods::sample_patterns!(check_masks);
        check_row(&AnyCoverage::default(), &segments, rule, columns, cells);
    }
}

/// Columns that begin anywhere are covered only where the shape is, by edges across the whole domain too.
#[test]
fn columns_far_from_a_shape_have_none_of_it() {
    fn check<T: CoverageMethod<Cell = i32>>(method: &T) {
        let point = |(x, y): (i32, i32)| SubPoint::<Sub8>::from_units(x, y).unwrap();
        let edge = |from, to| AntialiasedEdge::new(&point(from), &point(to)).unwrap();
        let (left, right) = (Sub8::MIN_UNITS + 1, Sub8::MAX_UNITS - 1);
        let edges = [edge((left, -128), (right, 90)), edge((right, 128), (left, -70))];
        let starts = (-262_200..-245_000).chain(-12_000..12_000).chain(245_000..262_200);
        let starts = starts.step_by(37).chain([i32::MIN, -262_143, 262_143, i32::MAX]);
        for start in starts {
            let mut segments = edges.map(|edge| edge.begin(0));
            segments.sort_by_key(|segment| segment.ends().0);
            let columns = start..start.saturating_add(40);
            let mut emit = |columns: Range<i32>, coverage: u8| -> Result<(), ()> {
                let is_near = columns.start >= -8_193 && columns.end <= 8_193;
                assert!(is_near && coverage > 0, "{columns:?} from {start} on: {coverage}");
                Ok(())
            };
            method
                .cover_row(&mut segments, FillRule::NonZero, columns, &mut [0; 41], &mut emit)
                .unwrap();
        }
    }
    // The methods that sum up areas: the two edges are no closed outline, so samples beside one of them may have it alone.
    check(&SignedArea);
    check(&InsideArea);
    check(&AnyCoverage::SignedArea);
}

/// Bit `n` is the sample at position `n`: right of a slanted side, and nothing else is.
#[test]
fn bits_are_the_samples_at_their_positions() {
    fn check<P: SamplePattern>() {
        // From the corner of pixel 0 down by a row, aside by a pixel and a half; and far off the way back.
        let side =
            |x: i32, dx: i32| [[x, 0], [x + dx, 256]].map(|[x, y]| SubPoint::from_units(x - 128, y - 128).unwrap());
        let ([top, bottom], [far_top, far_bottom]) = (side(40, 384), side(5_000, 0));
        let edges = [
            AntialiasedEdge::new(&top, &bottom),
            AntialiasedEdge::new(&far_bottom, &far_top),
        ];
        let mut segments = edges.map(|edge| edge.unwrap().begin(0));
        let mut memory = [P::Cell::default(); 5];
        let mut masks = [0u32; 4];
        let sampled = P::default().sample_row(&mut segments, FillRule::NonZero, 0..4, &mut memory, |span, mask| {
            masks[span.start as usize..span.end as usize].fill(mask);
            Ok::<(), ()>(())
        });
        assert_eq!(sampled, Ok(()));
        for (pixel, mask) in (0..).zip(masks) {
            for (bit, [x, y]) in P::positions().enumerate() {
                let is_right = (pixel * 256 + x - 40) * 256 >= 384 * y;
                assert_eq!(mask >> bit & 1 != 0, is_right, "{pixel} {bit}");
            }
        }
        assert_eq!(P::positions().count(), P::SAMPLES);
        let nothing = P::default().sample_row(&mut [], FillRule::NonZero, 0..0, &mut [], |_, _| Err(()));
        assert_eq!(nothing, Ok(()));
    }
    macro_rules! check_each {
        ($([$name:ident] [$($pattern:tt)+])+) => {
            $(check::<$($pattern)+>();)+
        };
    }
    zrow_methods::sample_patterns!(check_each);
}

/// The spans of a polygon's rows, all at once as the method takes them, or row by row.
fn covered(
    edges: &[AntialiasedEdge],
    rule: FillRule,
    window: &crate::geometry::Window,
    row_by_row: bool,
) -> Vec<(Span, u8)> {
    let mut table = heapless::Vec::<AntialiasedEdge, 128>::new();
    let mut builder = edges::monotone_chains::ChainBuilder::new(table.as_mut_view());
    for edge in edges {
        // Edges count from the corner of a pixel, outlines from its centre.
        let [top, bottom] = edge.ends().map(|end| end.map(|units| units - edges::Y_ONE / 2));
        let (from, to) = if edge.winding() > 0 {
            (top, bottom)
        } else {
            (bottom, top)
        };
        builder.add(from, to);
    }
    let (first, end_row) = builder.finish();
    let chains = edges::monotone_chains::Chains::new(&table, first);
    if table.is_empty() || end_row <= window.top || chains.first_row() >= window.bottom {
        return Vec::new();
    }
    let mut segments = heapless::Vec::<RowSegment, 128>::new();
    let rows = Rows {
        height: (end_row - chains.first_row()) as usize,
        chains,
        segments: segments.as_mut_view(),
        rows: window.top..window.bottom,
    };
    let (columns, mut cells, mut spans) = (window.left..window.right, [0; 64], Vec::new());
    let mut emit = |span: Span, coverage: u8| -> Result<(), ()> {
        spans.push((span, coverage));
        Ok(())
    };
    let result = if row_by_row {
        rows.for_each(|y, segments| SignedArea.cover_row(segments, rule, columns.clone(), &mut cells, emit.row(y)))
    } else {
        SignedArea.cover_rows(rows, rule, columns, &mut cells, &mut emit)
    };
    assert_eq!(result, Ok(()));
    spans
}

/// The coverage of each pixel of a window, from spans in any order.
fn pixels(spans: &[(Span, u8)], window: &crate::geometry::Window) -> Vec<u8> {
    let width = (window.right - window.left) as usize;
    let mut pixels = vec![0; width * (window.bottom - window.top) as usize];
    for (span, coverage) in spans {
        for x in span.start..span.end {
            pixels[(span.y - window.top) as usize * width + (x - window.left) as usize] = *coverage;
        }
    }
    pixels
}

proptest! {
    #![proptest_config(config(1_000))]

    /// Many edges in few rows take a way of their own, to the same pixels.
    #[test]
    fn rows_of_many_edges_are_covered_like_others(
        contour in prop::collection::vec(
            (-900..5_000i32, prop_oneof![-300..1_500i32, (-1..6i32).prop_map(|row| row * 256 - 128)]), 3..100,
        ),
        is_even_odd: bool,
        left in -3..9i32,
        top in -2..5i32,
    ) {
        let window = crate::geometry::Window { left, top, right: left + 11, bottom: top + 4 };
        let rule = if is_even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let points: Vec<[i32; 2]> = contour.iter().map(|&(x, y)| [x, y]).collect();
        let ends = points.iter().zip(points.iter().cycle().skip(1));
        let edges: Vec<AntialiasedEdge> = ends.filter_map(|(&from, &to)| AntialiasedEdge::from_units(from, to)).collect();
        let [whole, by_row] = [false, true].map(|row_by_row| pixels(&covered(&edges, rule, &window, row_by_row), &window));
        prop_assert_eq!(whole, by_row);
    }

    /// Edges inside of other contours, which most rows leave out, whichever way round all of them are: to the pixels of all
    /// edges' cells, added up in few rows of many edges.
    #[test]
    fn edges_within_the_inside_are_left_out(
        quadrilaterals in prop::collection::vec(
            ([-300..2_000i32, -300..2_000i32], [-300..2_000i32, -300..2_000i32], [-300..600i32, 700..2_100i32]), 2..8,
        ),
        is_even_odd: bool,
        is_reversed: bool,
        odd_one in 0..16usize,
        left in -3..9i32,
    ) {
        let window = crate::geometry::Window { left, top: -2, right: left + 30, bottom: 9 };
        let rule = if is_even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let mut edges = Vec::new();
        for (index, ([left, other_left], [right, other_right], [top, bottom])) in quadrilaterals.into_iter().enumerate() {
            let mut contour =
                [[left, top], [right + 4_000, top + 90], [other_right + 4_000, bottom], [other_left, bottom - 70]];
            if is_reversed != (index == odd_one) {
                contour.reverse();
            }
            let ends = contour.iter().zip(contour.iter().cycle().skip(1));
            edges.extend(ends.filter_map(|(&from, &to)| AntialiasedEdge::from_units(from, to)));
        }
        let [whole, by_row] = [false, true].map(|row_by_row| pixels(&covered(&edges, rule, &window, row_by_row), &window));
        prop_assert_eq!(whole, by_row);
    }

    /// Rows that two edges pass take a way of their own, to the same pixels, from left to right.
    #[test]
    fn rows_between_two_edges_are_covered_like_others(
        contour in prop::collection::vec(
            (
                prop_oneof![-900..9_000i32, (-2..30i32).prop_map(|column| column * 256 - 128)],
                prop_oneof![-900..9_000i32, (-2..30i32).prop_map(|row| row * 256 - 128)],
            ),
            3..8,
        ),
        is_even_odd: bool,
        (left, top) in (-3..9i32, -2..9i32),
    ) {
        let window = crate::geometry::Window { left, top, right: left + 21, bottom: top + 20 };
        let rule = if is_even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let points: Vec<[i32; 2]> = contour.iter().map(|&(x, y)| [x, y]).collect();
        let ends = points.iter().zip(points.iter().cycle().skip(1));
        let edges: Vec<AntialiasedEdge> = ends.filter_map(|(&from, &to)| AntialiasedEdge::from_units(from, to)).collect();
        let [whole, by_row] = [false, true].map(|row_by_row| covered(&edges, rule, &window, row_by_row));
        prop_assert_eq!(pixels(&whole, &window), pixels(&by_row, &window));
        for pair in whole.windows(2) {
            let [(before, _), (after, _)] = pair else { unreachable!() };
            prop_assert!(before.y < after.y || before.y == after.y && before.end <= after.start, "{:?}", pair);
        }
        prop_assert!(whole.iter().all(|(span, coverage)| span.start < span.end && *coverage > 0));
    }

    /// Two chains with few corners or many in a row, corners on its sides, and edges that cross those of the other chain: to
    /// the same pixels, from left to right.
    #[test]
    fn rows_between_two_chains_are_covered_like_others(
        [one, other] in [chain(), chain()],
        bottom in 2_000..9_000i32,
        (left, top) in (-3..9i32, -2..9i32),
    ) {
        let window = crate::geometry::Window { left, top, right: left + 21, bottom: top + 20 };
        let mut contour: Vec<[i32; 2]> = vec![[1_500, -200]];
        let corners = |chain: Vec<(i32, i32)>| {
            let mut y = -200;
            let corners = chain.into_iter().map(move |(x, height)| {
                y = if height < 0 { (y & -256) + 384 } else { y + height };
                [x, y]
            });
            corners.take_while(|[_, y]| *y < bottom).collect::<Vec<_>>()
        };
        contour.extend(corners(one));
        contour.push([1_700, bottom]);
        contour.extend(corners(other).into_iter().rev());
        let ends = contour.iter().zip(contour.iter().cycle().skip(1));
        let edges: Vec<AntialiasedEdge> = ends.filter_map(|(&from, &to)| AntialiasedEdge::from_units(from, to)).collect();
        let [whole, by_row] =
            [false, true].map(|row_by_row| covered(&edges, FillRule::NonZero, &window, row_by_row));
        prop_assert_eq!(pixels(&whole, &window), pixels(&by_row, &window));
        for pair in whole.windows(2) {
            let [(before, _), (after, _)] = pair else { unreachable!() };
            prop_assert!(before.y < after.y || before.y == after.y && before.end <= after.start, "{:?}", pair);
        }
    }
}

/// The corners of a y-monotone chain: x, and how far below the one before each lies, in 1/256 pixel; negative where it lies on
/// the next boundary between two rows.
fn chain() -> impl Strategy<Value = Vec<(i32, i32)>> {
    let height = prop_oneof![3 => 0..40i32, 2 => 200..900i32, 1 => Just(-1)];
    prop::collection::vec((-900..5_000i32, height), 0..40)
}
