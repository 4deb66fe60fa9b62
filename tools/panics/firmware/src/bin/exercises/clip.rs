use zrow::{
    clip::{
        Outcode, Visibility,
        boolean::{
            greiner_hormann::{ClipError, Clipped, Clipper, Contour, Operation},
            weiler_atherton,
        },
        convex::{
            cyrus_beck::{self, ParametricSegment},
            sutherland_hodgman_2d,
        },
        segment::{cohen_sutherland, liang_barsky, midpoint_subdivision, nicholl_lee_nicholl},
        shape::{circle_against_window, rectangle_against_window},
    },
    geometry::{Sub4, Sub8, SubPixel},
};
use zrow_panics_firmware::{any, keep, keep_all};

use crate::foreign::{clone, default, eq, error};

pub const EXERCISES: &[fn()] = &[
    outcode,
    shapes,
    liang_barsky::<Sub4>,
    liang_barsky::<Sub8>,
    cohen_sutherland::<Sub4>,
    cohen_sutherland::<Sub8>,
    nicholl_lee_nicholl::<Sub4>,
    nicholl_lee_nicholl::<Sub8>,
    midpoint_subdivision::<Sub4>,
    midpoint_subdivision::<Sub8>,
    cyrus_beck::<Sub4>,
    cyrus_beck::<Sub8>,
    sutherland_hodgman::<Sub4>,
    sutherland_hodgman::<Sub8>,
    greiner_hormann::<Sub4>,
    greiner_hormann::<Sub8>,
    weiler_atherton::<Sub4>,
    weiler_atherton::<Sub8>,
];

#[inline(never)]
fn outcode() {
    keep(Outcode::of(any(), any()));
    keep(Outcode::of_sub_point::<Sub4>(any(), any()));
    keep(Outcode::of_sub_point::<Sub8>(any(), any()));
    keep(Outcode::is_inside(any()));
    keep(Outcode::shared(any(), any()));
    keep(Outcode::either(any(), any()));
    keep(Outcode::meets(any(), any()));
    eq::<Outcode>();
    default::<Outcode>();
    eq::<Visibility>();
}

#[inline(never)]
fn shapes() {
    keep(circle_against_window(any(), any()));
    keep(rectangle_against_window(any(), any()));
    keep(clip_rectangle(any(), any()));
}

#[inline(never)]
fn liang_barsky<S: SubPixel>() {
    keep(liang_barsky::<S>(any(), any(), any()));
}

#[inline(never)]
fn cohen_sutherland<S: SubPixel>() {
    keep(cohen_sutherland::<S>(any(), any(), any()));
}

#[inline(never)]
fn nicholl_lee_nicholl<S: SubPixel>() {
    keep(nicholl_lee_nicholl::<S>(any(), any(), any()));
}

#[inline(never)]
fn midpoint_subdivision<S: SubPixel>() {
    keep(midpoint_subdivision::<S>(any(), any(), any()));
}

#[inline(never)]
fn cyrus_beck<S: SubPixel>() {
    keep(cyrus_beck::<S>(any(), any(), any()));
    keep(ParametricSegment::<S>::clip(any(), any()));
    keep(ParametricSegment::<S>::ends(any()));
    keep(ParametricSegment::<S>::ends_within(any(), any()));
    eq::<ParametricSegment<S>>();
}

#[inline(never)]
fn sutherland_hodgman<S: SubPixel>() {
    keep(sutherland_hodgman_2d::<S, 32, 8>(any(), any()));
}

#[inline(never)]
fn weiler_atherton<S: SubPixel>() {
    default::<weiler_atherton::Clipper<S, 64>>();
    keep(weiler_atherton::Clipper::<S, 64>::new());
    keep(weiler_atherton::Clipper::<S, 64>::clip(any(), any(), any(), any()));
}

#[inline(never)]
fn greiner_hormann<S: SubPixel>() {
    default::<Clipper<S, 64>>();
    keep(Clipper::<S, 64>::new());
    keep(Clipper::<S, 64>::clip(any(), any(), any(), any()));
    keep_all(Clipped::<S>::contours(any()));
    keep(Contour::<S>::is_hole(any()));
    keep_all(Contour::<S>::points(any()));
    clone::<Contour<'_, S>>();
    eq::<Operation>();
    error::<ClipError>();
    eq::<ClipError>();
}
