use zrow::{
    clip::{
        Classification, ClipMatrix, ClipPlane, ClipPoint, Clipper, Contour, Operation, ParametricSegment, SpaceSegment,
    },
    geometry::{ConvexWindow, Sub4, Sub8, SubPixel, Window},
};
use zrow_panics_firmware::{any, keep, keep_all};

use crate::foreign::{clone, default, eq};

pub const EXERCISES: &[fn()] = &[
    shapes,
    segments::<Sub4>,
    segments::<Sub8>,
    parametric_segment::<Sub4>,
    parametric_segment::<Sub8>,
    polygons::<Sub4>,
    polygons::<Sub8>,
    boolean_methods,
    booleans::<Sub4>,
    booleans::<Sub8>,
    space,
];

#[inline(never)]
fn shapes() {
    macro_rules! clip_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+(any(), any()));)+
        };
    }
    zrow_methods::shapes_in_window!(clip_by_each);
    keep(Window::clip_rectangle(any(), any()));
    eq::<Classification>();
}

#[inline(never)]
fn segments<S: SubPixel>() {
    macro_rules! clip_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+::<S>(any(), any(), any()));)+
        };
    }
    zrow_methods::segments!(clip_by_each);
    zrow_methods::convex_segments!(clip_by_each);
}

#[inline(never)]
fn parametric_segment<S: SubPixel>() {
    keep(ParametricSegment::<S>::clip(any(), any()));
    keep(ParametricSegment::<S>::ends(any()));
    keep(ParametricSegment::<S>::ends_within(any(), any()));
    eq::<ParametricSegment<S>>();
}

#[inline(never)]
fn polygons<S: SubPixel>() {
    macro_rules! clip_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+::<32, 8>(any::<&ConvexWindow<'_, S>>(), any()));)+
        };
    }
    zrow_methods::convex_polygons!(clip_by_each);
}

#[inline(never)]
fn boolean_methods() {
    macro_rules! exercise_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(
                keep($($item)+(any::<&mut Clipper<Sub4, 64>>(), any(), any(), any()).map(|contours| keep_all(contours)));
                keep($($item)+(any::<&mut Clipper<Sub8, 64>>(), any(), any(), any()).map(|contours| keep_all(contours)));
            )+
        };
    }
    zrow_methods::booleans!(exercise_each);
}

#[inline(never)]
fn booleans<S: SubPixel + 'static>() {
    default::<Clipper<S, 64>>();
    keep(Clipper::<S, 64>::new());
    keep(Contour::<S>::is_hole(any()));
    keep_all(Contour::<S>::points(any()));
    clone::<Contour<'_, S>>();
    eq::<Operation>();
}

#[inline(never)]
fn space() {
    keep(ClipMatrix::new(any(), any(), any()));
    keep(ClipMatrix::apply(any(), any()));
    keep(ClipPoint::is_inside(any()));
    keep(ClipPoint::on_screen::<Sub4>(any(), any()));
    keep(ClipPoint::on_screen::<Sub8>(any(), any()));
    keep(ClipMatrix::planes(any()));
    keep(ClipPlane::through(any(), any()));
    macro_rules! clip_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+(any(), any(), any()));)+
        };
    }
    zrow_methods::space_segments!(clip_by_each);
    zrow_methods::volume_segments!(clip_by_each);
    macro_rules! clip_faces_by_each {
        ($([$name:ident] [$($item:tt)+])+) => {
            $(keep($($item)+::<2>(any(), any()));)+
        };
    }
    zrow_methods::space_polygons!(clip_faces_by_each);
    keep(SpaceSegment::clip(any(), any()));
    keep(SpaceSegment::ends(any(), any()));
    keep(SpaceSegment::attribute(any(), any(), any()));
    keep(SpaceSegment::vertices(any()));
    eq::<ClipMatrix>();
    eq::<ClipPlane>();
    eq::<SpaceSegment>();
    eq::<ClipPoint>();
}
