use embedded_graphics::geometry::Point;
use heapless::VecView;
use zrow::{
    coverage::edges::{AntialiasedEdge, RowSegment, row_segments},
    draw::FillRule,
    geometry::{Sub4, Sub8, SubPixel, SubPoint, Vertex},
    scan::{
        curve::{
            Bezier, Cubic, PolynomialForwardDifference, Quadratic, StepTooFine,
            adaptive_forward_difference::{self, AdaptiveForwardDifference},
            de_casteljau::{self, Subdivision},
            uniform_subdivision::{self, UniformSubdivision},
        },
        line::{
            bresenham,
            bresenham_runs::{self, LineRuns, Run, RunPoints, Runs},
            dda::{self, DdaPoints},
            dda_fixed::{self, FixedDdaPoints},
            double_step::{self, DoubleStepPoints},
            midpoint::{self, MidpointPoints},
            slope_intercept::{self, SlopeInterceptPoints},
            supercover::{self, SupercoverCells},
        },
        polygon::{
            ActiveEdge, Crossing, Edge, Part, ScanEdge, active_edge_table,
            banded_polygon::{self, EdgeSource},
            brute_force_fill::{self, PixelCentre},
            edge_table,
            naive_scanline::{self, FillError, RowCrossing},
            Location, crossing_number, merged_crossings, quadrant_arc_length, winding_number,
            scanline_polygon::{self, PartRule, Windings},
        },
        round::{
            RadiusTooLarge, bresenham_circle, ellipse, midpoint_circle, midpoint_ellipse, parametric_circle,
            parametric_ellipse,
            plane_sector::{self, Center, Columns, HalfPlane, PlaneSector},
            square_root_circle, square_root_ellipse,
        },
        stroke::{DashPattern, DiscSide, LineCap, LineJoin},
        triangle::{
            barycentric_triangle,
            bresenham_triangle::{self, OutlineRow},
            edge_function_triangle, hierarchical_triangle, incremental_edge_triangle,
        },
    },
    surface::LineSteps,
};
use zrow_panics_firmware::{Failure, any, keep, keep_all, take, take_both};

use crate::foreign::{clone, default, eq, error, from, hash, into_iterator, iterator};

pub const EXERCISES: &[fn()] = &[
    bresenham,
    bresenham_runs,
    dda,
    dda_fixed,
    double_step,
    midpoint,
    slope_intercept,
    circles,
    ellipses,
    supercover,
    bezier::<3, Sub4>,
    bezier::<4, Sub8>,
    adaptive_forward_difference::<3>,
    adaptive_forward_difference::<4>,
    de_casteljau::<3>,
    de_casteljau::<4>,
    uniform_subdivision::<3>,
    uniform_subdivision::<4>,
    polynomial_forward_difference::<2>,
    polynomial_forward_difference::<4>,
    ellipse,
    plane_sector,
    active_edge_table::<Edge>,
    active_edge_table::<DiscSide>,
    edge_table,
    scan_edge::<Edge>,
    scan_edge::<DiscSide>,
    edge::<Point>,
    edge::<SubPoint<Sub4>>,
    edge::<SubPoint<Sub8>>,
    sub_edge,
    row_segments,
    scanline_polygon::<Edge>,
    scanline_polygon::<DiscSide>,
    banded_polygon::<Edge>,
    banded_polygon::<DiscSide>,
    naive_scanline::<Point>,
    naive_scanline::<SubPoint<Sub4>>,
    naive_scanline::<SubPoint<Sub8>>,
    brute_force_fill::<Point>,
    brute_force_fill::<SubPoint<Sub8>>,
    point_in_polygon::<Point>,
    point_in_polygon::<SubPoint<Sub4>>,
    point_in_polygon::<SubPoint<Sub8>>,
    triangle,
    barycentric_triangle::<Sub4>,
    barycentric_triangle::<Sub8>,
    edge_function_triangle::<Sub4>,
    edge_function_triangle::<Sub8>,
    hierarchical_triangle::<Sub4>,
    hierarchical_triangle::<Sub8>,
    incremental_edge_triangle::<Sub4>,
    incremental_edge_triangle::<Sub8>,
    styles,
];

#[inline(never)]
fn bresenham() {
    keep(bresenham(any(), any(), any()));
    keep(bresenham::moved_line(any(), any(), any(), any()));
}

#[inline(never)]
fn bresenham_runs() {
    keep(bresenham_runs(any(), any(), any()));
    keep_all(LineRuns::runs(any()));
    keep(Run::to_window(any()));
    from::<LineSteps, LineRuns>();
    into_iterator::<LineRuns>();
    eq::<LineRuns>();
    eq::<Run>();
    iterator::<Runs>();
    clone::<Runs>();
    iterator::<RunPoints>();
    clone::<RunPoints>();
}

#[inline(never)]
fn dda() {
    keep(dda(any(), any(), any()));
    iterator::<DdaPoints>();
    clone::<DdaPoints>();
}

#[inline(never)]
fn dda_fixed() {
    keep(dda_fixed(any(), any(), any()));
    iterator::<FixedDdaPoints>();
    clone::<FixedDdaPoints>();
}

#[inline(never)]
fn double_step() {
    keep(double_step(any(), any(), any()));
    iterator::<DoubleStepPoints>();
    clone::<DoubleStepPoints>();
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
fn midpoint() {
    keep(midpoint(any(), any(), any()));
    iterator::<MidpointPoints>();
    clone::<MidpointPoints>();
}

#[inline(never)]
fn slope_intercept() {
    keep(slope_intercept(any(), any(), any()));
    iterator::<SlopeInterceptPoints>();
    clone::<SlopeInterceptPoints>();
}

#[inline(never)]
fn supercover() {
    keep(supercover(any(), any(), any()));
    iterator::<SupercoverCells>();
    clone::<SupercoverCells>();
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
fn adaptive_forward_difference<const CONTROLS: usize>() {
    keep_all(adaptive_forward_difference::<CONTROLS>(any(), any()));
    iterator::<AdaptiveForwardDifference>();
    clone::<AdaptiveForwardDifference>();
}

#[inline(never)]
fn de_casteljau<const CONTROLS: usize>() {
    keep_all(de_casteljau::<CONTROLS>(any(), any()));
    iterator::<Subdivision<CONTROLS>>();
    clone::<Subdivision<CONTROLS>>();
}

#[inline(never)]
fn uniform_subdivision<const CONTROLS: usize>() {
    keep_all(uniform_subdivision::<CONTROLS>(any(), any()));
    keep(any::<&UniformSubdivision<CONTROLS>>().len());
    iterator::<UniformSubdivision<CONTROLS>>();
    clone::<UniformSubdivision<CONTROLS>>();
}

#[inline(never)]
fn polynomial_forward_difference<const TERMS: usize>() {
    keep(PolynomialForwardDifference::<TERMS>::dyadic(any(), any()));
    keep(PolynomialForwardDifference::<TERMS>::rounded(any(), any(), any()));
    keep(PolynomialForwardDifference::<TERMS>::value(any()));
    PolynomialForwardDifference::<TERMS>::advance(any());
    eq::<PolynomialForwardDifference<TERMS>>();
    error::<StepTooFine>();
    eq::<StepTooFine>();
}

#[inline(never)]
fn ellipse() {
    keep(ellipse::is_narrow(any()));
    keep(ellipse::first_row(any()));
}

#[inline(never)]
fn plane_sector() {
    keep(Center::of(any()));
    eq::<Center>();
    keep(Columns::contains(any(), any()));
    keep(Columns::is_empty(any()));
    keep(Columns::intersection(any(), any()));
    eq::<Columns>();
    keep(HalfPlane::right_of(any(), any()));
    keep(HalfPlane::left_of(any(), any()));
    keep(HalfPlane::columns(any(), any(), any(), any()));
    eq::<HalfPlane>();
    keep(PlaneSector::new(any(), any()));
    keep(PlaneSector::half_planes(any(), any()));
    keep(PlaneSector::row_runs(any(), any(), any()));
    keep(PlaneSector::contains(any(), any(), any()));
    eq::<PlaneSector>();
    keep(plane_sector::runs(any(), any(), |_| any::<Option<u8>>(), take_both));
}

#[inline(never)]
fn active_edge_table<G: ScanEdge + Copy + PartialEq>() {
    active_edge_table::step::<G>(any(), any());
    keep(active_edge_table::change::<G>(any(), any(), any()));
    eq::<ActiveEdge<'_, G>>();
}

#[inline(never)]
fn edge_table() {
    edge_table::sort::<Edge>(any());
    edge_table::sort::<DiscSide>(any());
    keep(edge_table::most_active(any()));
}

#[inline(never)]
fn scan_edge<G: ScanEdge + Copy + 'static>() {
    keep(<G as ScanEdge>::first_row(any()));
    keep(<G as ScanEdge>::end_row(any()));
    keep(<G as ScanEdge>::crossing_at(any(), any()));
    keep(<G as ScanEdge>::next_crossing(any(), any(), any()));
    keep(<G as ScanEdge>::windings(any()));
    Windings::cross::<G>(any(), any());
}

#[inline(never)]
fn edge<V: Vertex + 'static>() {
    keep(Edge::new::<V>(any(), any(), any()));
    keep(Edge::crossing_at(any(), any()));
    keep(Edge::next_crossing(any(), any()));
    eq::<Edge>();
    eq::<DiscSide>();
    eq::<Crossing>();
    eq::<Part>();
}

#[inline(never)]
fn sub_edge() {
    keep(AntialiasedEdge::new(any(), any()));
    keep(AntialiasedEdge::first_row(any()));
    keep(AntialiasedEdge::end_row(any()));
    keep(AntialiasedEdge::begin(any(), any()));
    eq::<AntialiasedEdge>();
}

#[inline(never)]
fn row_segments() {
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
fn scanline_polygon<G: ScanEdge + Copy + 'static>() {
    keep(scanline_polygon::scan::<G, Failure>(
        any(),
        any::<&mut VecView<ActiveEdge<'static, G>>>(),
        any(),
        any(),
        any(),
        take_both,
    ));
    keep(FillRule::includes(any(), any()));
    keep(PartRule::fill(any()));
    eq::<FillRule>();
    default::<FillRule>();
    eq::<PartRule>();
    eq::<Windings>();
    default::<Windings>();
}

#[inline(never)]
fn banded_polygon<G: ScanEdge + Copy + 'static>() {
    keep(banded_polygon::scan::<G, Failure>(
        any::<&EdgeSource<'static, G>>(),
        any(),
        any(),
        take_both,
    ));
}

#[inline(never)]
fn naive_scanline<V: Vertex + 'static>() {
    keep(naive_scanline::<V, Failure>(any(), any(), any(), any(), take));
    eq::<RowCrossing>();
    error::<FillError<Failure>>();
    eq::<FillError<Failure>>();
}

#[inline(never)]
fn brute_force_fill<V: Vertex + 'static>() {
    keep(brute_force_fill::<V, Failure>(
        any(),
        any(),
        any(),
        |_, _, _| any(),
        take,
    ));
    keep(brute_force_fill::<V, Failure>(
        any(),
        any(),
        any(),
        winding_number,
        take,
    ));
    clone::<PixelCentre<V>>();
}

#[inline(never)]
fn point_in_polygon<V: Vertex + 'static>() {
    keep(crossing_number::<V, V>(any(), any(), any()));
    keep(crossing_number::<V, PixelCentre<V>>(any(), any(), any()));
    keep(merged_crossings::<V, V>(any(), any(), any()));
    keep(merged_crossings::<V, PixelCentre<V>>(any(), any(), any()));
    keep(quadrant_arc_length::<V, V>(any(), any(), any()));
    keep(quadrant_arc_length::<V, PixelCentre<V>>(any(), any(), any()));
    keep(winding_number::<V, V>(any(), any(), any()));
    keep(winding_number::<V, PixelCentre<V>>(any(), any(), any()));
    eq::<Location>();
}

#[inline(never)]
fn triangle() {
    keep(bresenham_triangle::fill::<Failure>(any(), any(), |rows| take(rows)));
    keep(bresenham_triangle::outline::<Failure>(any(), any(), take));
    bresenham_triangle::edges(any(), any(), any());
    keep(bresenham_triangle::doubled_area(any()));
    eq::<bresenham_triangle::Rows<'_>>();
    eq::<OutlineRow>();
}

#[inline(never)]
fn barycentric_triangle<S: SubPixel>() {
    keep(barycentric_triangle::<S, Failure>(any(), any(), take));
}

#[inline(never)]
fn edge_function_triangle<S: SubPixel>() {
    keep(edge_function_triangle::<S, Failure>(any(), any(), take));
}

#[inline(never)]
fn hierarchical_triangle<S: SubPixel>() {
    keep(hierarchical_triangle::<S, Failure>(any(), any(), take));
}

#[inline(never)]
fn incremental_edge_triangle<S: SubPixel>() {
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
