use zrow::{
    clip::{
        Visibility,
        boolean::{BooleanMethod, ClipError, Clipped, Clipper, Contour, GreinerHormann, Operation, WeilerAtherton},
        convex::{ParametricSegment, cyrus_beck, sutherland_hodgman_2d},
        segment::{cohen_sutherland, liang_barsky, midpoint_subdivision, nicholl_lee_nicholl},
        shape::{circle_against_window, clip_rectangle, rectangle_against_window},
    },
    geometry::{Sub4, Sub8, SubPixel},
};
use zrow_panics_firmware::{any, keep, keep_all};

use crate::foreign::{clone, default, eq, error};

pub const EXERCISES: &[fn()] = &[
    shapes,
    segments::<Sub4>,
    segments::<Sub8>,
    parametric_segment::<Sub4>,
    parametric_segment::<Sub8>,
    sutherland_hodgman::<Sub4>,
    sutherland_hodgman::<Sub8>,
    clipper::<Sub4, GreinerHormann>,
    clipper::<Sub8, GreinerHormann>,
    clipper::<Sub4, WeilerAtherton>,
    clipper::<Sub8, WeilerAtherton>,
    boolean_method::<GreinerHormann>,
    boolean_method::<WeilerAtherton>,
    booleans::<Sub4>,
    booleans::<Sub8>,
];

#[inline(never)]
fn shapes() {
    keep(circle_against_window(any(), any()));
    keep(rectangle_against_window(any(), any()));
    keep(clip_rectangle(any(), any()));
    eq::<Visibility>();
}

#[inline(never)]
fn segments<S: SubPixel>() {
    keep(liang_barsky::<S>(any(), any(), any()));
    keep(cohen_sutherland::<S>(any(), any(), any()));
    keep(nicholl_lee_nicholl::<S>(any(), any(), any()));
    keep(midpoint_subdivision::<S>(any(), any(), any()));
}

#[inline(never)]
fn parametric_segment<S: SubPixel>() {
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
fn clipper<S: SubPixel + 'static, M: BooleanMethod + 'static>() {
    default::<Clipper<S, 64, M>>();
    keep(Clipper::<S, 64, M>::clip(any(), any(), any(), any()));
}

#[inline(never)]
fn boolean_method<M: BooleanMethod>() {
    <M as BooleanMethod>::link::<Sub4>(any(), any());
    <M as BooleanMethod>::link::<Sub8>(any(), any());
}

#[inline(never)]
fn booleans<S: SubPixel>() {
    keep(Clipper::<S, 64>::new());
    keep_all(Clipped::<S>::contours(any()));
    keep(Contour::<S>::is_hole(any()));
    keep_all(Contour::<S>::points(any()));
    clone::<Contour<'_, S>>();
    eq::<Operation>();
    error::<ClipError>();
    eq::<ClipError>();
}
