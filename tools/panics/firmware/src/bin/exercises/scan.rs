use embedded_graphics::geometry::Point;
use zrow::{
    draw::{LineCap, LineJoin},
    geometry::{DrawError, Sub4, Sub8, SubPixel, SubPoint, Vertex},
    scan::{Bezier, FillRule, Lines, Location, Polygons, PolynomialForwardDifference},
};
use zrow_panics_firmware::{Failure, any, keep, keep_all, take, take_both};

use crate::foreign::{default, eq, error, hash};

pub const EXERCISES: &[fn()] = &[
    lines,
    runs,
    rounds,
    bezier::<3, Sub4>,
    bezier::<4, Sub8>,
    flattened::<3>,
    flattened::<4>,
    polynomial::<2>,
    polynomial::<4>,
    filled_polygon::<Point>,
    filled_polygon::<SubPoint<Sub4>>,
    filled_polygon::<SubPoint<Sub8>>,
    tested_pixels::<Point>,
    tested_pixels::<SubPoint<Sub8>>,
    located::<Point>,
    located::<SubPoint<Sub4>>,
    located::<SubPoint<Sub8>>,
    filled_triangle::<Sub4>,
    filled_triangle::<Sub8>,
    interpolated_polygon::<Sub4>,
    interpolated_polygon::<Sub8>,
    homogeneous_triangle,
    styles,
];

/// Computes all items, of a copy too.
#[inline(always)]
fn walk(items: impl Iterator + Clone) {
    keep(items.size_hint());
    keep_all(items.clone());
    keep_all(items);
}

#[inline(never)]
fn lines() {
    macro_rules! walk_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(walk($($item)+(any(), any(), any()));)+
        };
    }
    zrow_methods::lines!(walk_each);
}

#[inline(never)]
fn runs() {
    walk(Lines::runs(any(), any(), any()));
}

#[inline(never)]
fn rounds() {
    macro_rules! keep_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep_all($($item)+(any(), any(), any()).into_iter().flatten());)+
        };
    }
    zrow_methods::circles!(keep_each);
    zrow_methods::ellipses!(keep_each);
}

#[inline(never)]
fn bezier<const CONTROLS: usize, S: SubPixel>() {
    keep(Bezier::<CONTROLS>::new::<S>(any()));
    keep(Bezier::<CONTROLS>::power_basis(any()));
    eq::<Bezier<CONTROLS>>();
    eq::<Bezier<3>>();
    eq::<Bezier<4>>();
}

#[inline(never)]
fn flattened<const CONTROLS: usize>() {
    macro_rules! walk_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(walk($($item)+(any::<&Bezier<CONTROLS>>(), any()));)+
        };
    }
    zrow_methods::curves!(walk_each);
    keep(Bezier::<CONTROLS>::uniform_subdivision(any(), any()).len());
}

#[inline(never)]
fn polynomial<const TERMS: usize>() {
    keep(PolynomialForwardDifference::<TERMS>::dyadic(any(), any()));
    keep(PolynomialForwardDifference::<TERMS>::rounded(any(), any(), any()));
    keep(PolynomialForwardDifference::<TERMS>::value(any()));
    PolynomialForwardDifference::<TERMS>::advance(any());
    eq::<PolynomialForwardDifference<TERMS>>();
}

#[inline(never)]
fn filled_polygon<V: Vertex + 'static>() {
    macro_rules! fill_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+::<V, Failure, 64>(any(), any(), any(), take));)+
        };
    }
    zrow_methods::polygon_fills!(fill_by_each);
    keep(FillRule::includes(any(), any()));
    eq::<FillRule>();
    default::<FillRule>();
    error::<DrawError<Failure>>();
    eq::<DrawError<Failure>>();
}

/// A fill that asks for each pixel, by any test and by all that there are.
#[inline(never)]
fn tested_pixels<V: Vertex + 'static>() {
    keep(Polygons::brute_force::<V, Failure>(
        any(),
        any(),
        any(),
        |_, _, pixel| {
            keep((pixel.clone(), pixel.x_units(), pixel.y_units()));
            any()
        },
        take,
    ));
    macro_rules! fill_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep(Polygons::brute_force::<V, Failure>(any(), any(), any(), $($item)+, take));)+
        };
    }
    zrow_methods::point_tests!(fill_by_each);
}

#[inline(never)]
fn located<V: Vertex + 'static>() {
    macro_rules! locate_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+::<V, V>(any(), any(), any()));)+
        };
    }
    zrow_methods::point_tests!(locate_by_each);
    eq::<Location>();
}

#[inline(never)]
fn filled_triangle<S: SubPixel>() {
    macro_rules! fill_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+::<S, Failure>(any(), any(), take));)+
        };
    }
    zrow_methods::triangles!(fill_by_each);
}

#[inline(never)]
fn interpolated_polygon<S: SubPixel>() {
    macro_rules! interpolate_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+::<S, Failure, 3>(any(), any(), take_both));)+
        };
    }
    zrow_methods::interpolations!(interpolate_by_each);
}

#[inline(never)]
fn homogeneous_triangle() {
    macro_rules! fill_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+::<Failure>(any(), any(), any(), take));)+
        };
    }
    zrow_methods::homogeneous_triangles!(fill_by_each);
}

#[inline(never)]
fn styles() {
    hash::<LineCap>();
    default::<LineCap>();
    hash::<LineJoin>();
    default::<LineJoin>();
}
