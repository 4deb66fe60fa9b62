use embedded_graphics::geometry::Point;
use zrow::{
    draw::{DashPattern, LineCap, LineJoin},
    geometry::{Sub4, Sub8, SubPixel, SubPoint, Vertex},
    scan::{
        curve::{
            Bezier, Cubic, PolynomialForwardDifference, Quadratic, StepTooFine, adaptive_forward_difference,
            de_casteljau, uniform_subdivision,
        },
        line::{
            Run, bresenham, bresenham_runs, dda, dda_fixed, double_step, line_runs, midpoint, slope_intercept,
            supercover,
        },
        polygon::{
            FillError, FillRule, Location, brute_force_fill, crossing_number, merged_crossings, naive_scanline,
            quadrant_arc_length, scanline_polygon, winding_number,
        },
        round::{
            RadiusTooLarge, bresenham_circle, midpoint_circle, midpoint_ellipse, parametric_circle, parametric_ellipse,
            square_root_circle, square_root_ellipse,
        },
        triangle::{barycentric_triangle, edge_function_triangle, hierarchical_triangle, incremental_edge_triangle},
    },
};
use zrow_panics_firmware::{Failure, any, keep, keep_all, take};

use crate::foreign::{default, eq, error, hash};

pub const EXERCISES: &[fn()] = &[
    lines,
    runs,
    circles,
    ellipses,
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
    walk(bresenham(any(), any(), any()));
    walk(bresenham_runs(any(), any(), any()));
    walk(dda(any(), any(), any()));
    walk(dda_fixed(any(), any(), any()));
    walk(double_step(any(), any(), any()));
    walk(midpoint(any(), any(), any()));
    walk(slope_intercept(any(), any(), any()));
    walk(supercover(any(), any(), any()));
}

#[inline(never)]
fn runs() {
    walk(line_runs(any(), any(), any()));
    keep(Run::to_window(any()));
    eq::<Run>();
}

#[inline(never)]
fn circles() {
    keep_all(bresenham_circle(any(), any(), any()).into_iter().flatten());
    keep_all(midpoint_circle(any(), any(), any()).into_iter().flatten());
    keep_all(parametric_circle(any(), any(), any()).into_iter().flatten());
    keep_all(square_root_circle(any(), any(), any()).into_iter().flatten());
    eq::<RadiusTooLarge>();
    error::<RadiusTooLarge>();
}

#[inline(never)]
fn ellipses() {
    keep_all(midpoint_ellipse(any(), any(), any()).into_iter().flatten());
    keep_all(parametric_ellipse(any(), any(), any()).into_iter().flatten());
    keep_all(square_root_ellipse(any(), any(), any()).into_iter().flatten());
}

#[inline(never)]
fn bezier<const CONTROLS: usize, S: SubPixel>() {
    keep(Bezier::<CONTROLS>::new::<S>(any()));
    keep(Bezier::<CONTROLS>::power_basis(any()));
    eq::<Bezier<CONTROLS>>();
    eq::<Quadratic>();
    eq::<Cubic>();
}

#[inline(never)]
fn flattened<const CONTROLS: usize>() {
    walk(adaptive_forward_difference::<CONTROLS>(any(), any()));
    walk(de_casteljau::<CONTROLS>(any(), any()));
    walk(uniform_subdivision::<CONTROLS>(any(), any()));
    keep(uniform_subdivision::<CONTROLS>(any(), any()).len());
}

#[inline(never)]
fn polynomial<const TERMS: usize>() {
    keep(PolynomialForwardDifference::<TERMS>::dyadic(any(), any()));
    keep(PolynomialForwardDifference::<TERMS>::rounded(any(), any(), any()));
    keep(PolynomialForwardDifference::<TERMS>::value(any()));
    PolynomialForwardDifference::<TERMS>::advance(any());
    eq::<PolynomialForwardDifference<TERMS>>();
    error::<StepTooFine>();
    eq::<StepTooFine>();
}

#[inline(never)]
fn filled_polygon<V: Vertex + 'static>() {
    keep(scanline_polygon::<V, Failure, 64>(any(), any(), any(), take));
    keep(naive_scanline::<V, Failure, 16>(any(), any(), any(), take));
    keep(FillRule::includes(any(), any()));
    eq::<FillRule>();
    default::<FillRule>();
    error::<FillError<Failure>>();
    eq::<FillError<Failure>>();
}

/// A fill that asks for each pixel, by any test and by all that there are.
#[inline(never)]
fn tested_pixels<V: Vertex + 'static>() {
    keep(brute_force_fill::<V, Failure>(
        any(),
        any(),
        any(),
        |_, _, pixel| {
            keep((pixel.clone(), pixel.x_units(), pixel.y_units()));
            any()
        },
        take,
    ));
    keep(brute_force_fill::<V, Failure>(
        any(),
        any(),
        any(),
        crossing_number,
        take,
    ));
    keep(brute_force_fill::<V, Failure>(
        any(),
        any(),
        any(),
        merged_crossings,
        take,
    ));
    keep(brute_force_fill::<V, Failure>(
        any(),
        any(),
        any(),
        quadrant_arc_length,
        take,
    ));
    keep(brute_force_fill::<V, Failure>(
        any(),
        any(),
        any(),
        winding_number,
        take,
    ));
}

#[inline(never)]
fn located<V: Vertex + 'static>() {
    keep(crossing_number::<V, V>(any(), any(), any()));
    keep(merged_crossings::<V, V>(any(), any(), any()));
    keep(quadrant_arc_length::<V, V>(any(), any(), any()));
    keep(winding_number::<V, V>(any(), any(), any()));
    eq::<Location>();
}

#[inline(never)]
fn filled_triangle<S: SubPixel>() {
    keep(barycentric_triangle::<S, Failure>(any(), any(), take));
    keep(edge_function_triangle::<S, Failure>(any(), any(), take));
    keep(hierarchical_triangle::<S, Failure>(any(), any(), take));
    keep(incremental_edge_triangle::<S, Failure>(any(), any(), take));
}

#[inline(never)]
fn styles() {
    keep(DashPattern::new(any()));
    keep(DashPattern::offset(any(), any()));
    hash::<DashPattern<'_>>();
    hash::<LineCap>();
    default::<LineCap>();
    hash::<LineJoin>();
    default::<LineJoin>();
}
