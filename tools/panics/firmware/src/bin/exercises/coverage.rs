use zrow::coverage::{
    AnyCoverage, Bartlett, BoxFilter, CentreSample, CoverageMethod, FilteredSegment, Gaussian, Grid, InsideArea,
    Rooks4, Rooks8, Rooks16, SamplePattern, SignedArea, SubScanlines, Weights,
    edges::{AntialiasedEdge, RowSegment, row_segments},
};
use zrow_panics_firmware::{any, keep, keep_all, take_both};

use crate::foreign::{default, eq};

pub const EXERCISES: &[fn()] = &[
    coverage_method::<CentreSample>,
    coverage_method::<Grid<2>>,
    coverage_method::<Grid<8, Bartlett>>,
    coverage_method::<Grid<16, Gaussian>>,
    coverage_method::<InsideArea>,
    coverage_method::<Rooks4>,
    coverage_method::<Rooks8>,
    coverage_method::<Rooks16>,
    coverage_method::<SignedArea>,
    coverage_method::<SubScanlines<16>>,
    coverage_method::<AnyCoverage>,
    sample_pattern::<Grid<2>>,
    sample_pattern::<Grid<4>>,
    sample_pattern::<Rooks4>,
    sample_pattern::<Rooks8>,
    sample_pattern::<Rooks16>,
    weights::<Bartlett>,
    weights::<BoxFilter>,
    weights::<Gaussian>,
    filtered_segment,
    antialiased_edge,
    row_segment,
    values,
];

#[inline(never)]
fn coverage_method<T: CoverageMethod + 'static>() {
    keep(<T as CoverageMethod>::cells(any()));
    keep(<T as CoverageMethod>::cover_row(
        any(),
        any(),
        any(),
        any(),
        any(),
        take_both,
    ));
    keep(<T as CoverageMethod>::cover_rows(
        any(),
        any(),
        any(),
        any(),
        any(),
        take_both,
    ));
}

#[inline(never)]
fn sample_pattern<P: SamplePattern + 'static>() {
    keep_all(<P as SamplePattern>::positions());
    keep(<P as SamplePattern>::sample_row(
        any(),
        any(),
        any(),
        any(),
        any(),
        take_both,
    ));
}

#[inline(never)]
fn weights<W: Weights>() {
    keep(<W as Weights>::weight(any(), any()));
}

#[inline(never)]
fn filtered_segment() {
    keep(FilteredSegment::new(any(), any()));
    keep(FilteredSegment::window(any()));
    keep(FilteredSegment::cover(any(), any(), take_both));
    eq::<FilteredSegment>();
}

#[inline(never)]
fn antialiased_edge() {
    keep(AntialiasedEdge::new(any(), any()));
    keep(AntialiasedEdge::first_row(any()));
    keep(AntialiasedEdge::end_row(any()));
    keep(AntialiasedEdge::begin(any(), any()));
    eq::<AntialiasedEdge>();
}

#[inline(never)]
fn row_segment() {
    keep(RowSegment::top(any()));
    keep(RowSegment::bottom(any()));
    keep(RowSegment::winding(any()));
    RowSegment::step(any());
    keep(RowSegment::last_row(any()));
    keep(RowSegment::ends(any()));
    keep(RowSegment::signed_height(any()));
    keep(RowSegment::x_at(any(), any()));
    eq::<RowSegment>();
    default::<RowSegment>();
    keep(row_segments::Rows::for_each(any(), |y, segments| {
        take_both(y, segments)
    }));
}

#[inline(never)]
fn values() {
    keep(Grid::<4>::new());
    eq::<Grid<4>>();
    default::<Grid<4>>();
    eq::<Bartlett>();
    default::<Bartlett>();
    eq::<BoxFilter>();
    default::<BoxFilter>();
    eq::<CentreSample>();
    default::<CentreSample>();
    eq::<Gaussian>();
    default::<Gaussian>();
    eq::<InsideArea>();
    default::<InsideArea>();
    eq::<Rooks4>();
    default::<Rooks4>();
    eq::<Rooks8>();
    default::<Rooks8>();
    eq::<Rooks16>();
    default::<Rooks16>();
    eq::<SignedArea>();
    default::<SignedArea>();
    eq::<SubScanlines<4>>();
    default::<SubScanlines<4>>();
    eq::<AnyCoverage>();
    default::<AnyCoverage>();
}
