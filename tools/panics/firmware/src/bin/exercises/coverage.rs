use zrow::coverage::{
    AntialiasedEdge, AnyCoverage, Bartlett, BoxFilter, CoverageMethod, Gaussian, Grid, Rooks, RowSegment, Rows,
    SamplePattern,
};
use zrow_panics_firmware::{any, keep, keep_all, take_both};

use crate::foreign::{default, eq};

pub const EXERCISES: &[fn()] = &[
    coverage_methods,
    coverage_method::<AnyCoverage>,
    sample_pattern::<Grid<2>>,
    sample_pattern::<Grid<4>>,
    sample_pattern::<Rooks<4>>,
    sample_pattern::<Rooks<8>>,
    sample_pattern::<Rooks<16>>,
    antialiased_edge,
    row_segment,
    values,
];

#[inline(never)]
fn coverage_methods() {
    macro_rules! exercise_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(
                coverage_method::<$($item)+>();
                eq::<$($item)+>();
                default::<$($item)+>();
            )+
        };
    }
    zrow_methods::coverage_methods!(exercise_each);
}

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
    keep(Rows::for_each(any(), |y, segments| take_both(y, segments)));
}

#[inline(never)]
fn values() {
    keep(Grid::<4>::new());
    eq::<Bartlett>();
    default::<Bartlett>();
    eq::<BoxFilter>();
    default::<BoxFilter>();
    eq::<Gaussian>();
    default::<Gaussian>();
    eq::<AnyCoverage>();
    default::<AnyCoverage>();
}
