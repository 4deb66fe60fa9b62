use zrow::coverage::{AnyCoverage, Bartlett, BoxFilter, CoverageMethod, Gaussian, Grid, Rooks, SamplePattern};
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
        &mut take_both::<_, _>,
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
