use embedded_graphics::{geometry::Point, primitives::Rectangle};
use zrow::geometry::{
    ConvexWindow, FixedPointWindow, InputError, Sub4, Sub8, SubPixel, SubPoint, TooSmall, Vertex, Window,
};
use zrow_panics_firmware::{any, keep, keep_all};

use crate::foreign::{default, eq, error, from};

pub const EXERCISES: &[fn()] = &[
    convex_window::<Sub4>,
    convex_window::<Sub8>,
    sub_pixel::<Sub4>,
    sub_pixel::<Sub8>,
    sub_point::<Sub4>,
    sub_point::<Sub8>,
    fixed_point_window::<Sub4>,
    fixed_point_window::<Sub8>,
    vertex::<Point>,
    vertex::<SubPoint<Sub4>>,
    vertex::<SubPoint<Sub8>>,
    window,
    values,
];

#[inline(never)]
fn convex_window<S: SubPixel>() {
    keep(ConvexWindow::<S>::new(any()));
    keep_all(ConvexWindow::<S>::corners(any()));
    keep(ConvexWindow::<S>::bounds(any()));
    keep(ConvexWindow::<S>::contains(any(), any()));
    eq::<ConvexWindow<'_, S>>();
}

#[inline(never)]
fn sub_pixel<S: SubPixel>() {
    keep(<S as SubPixel>::from_units(any()));
    keep(<S as SubPixel>::units(any()));
}

#[inline(never)]
fn sub_point<S: SubPixel>() {
    keep(SubPoint::<S>::from_units(any(), any()));
    keep(SubPoint::<S>::from_pixel(any()));
    keep(SubPoint::<S>::x_units(any()));
    keep(SubPoint::<S>::y_units(any()));
    eq::<SubPoint<S>>();
    default::<SubPoint<S>>();
}

#[inline(never)]
fn fixed_point_window<S: SubPixel>() {
    keep(FixedPointWindow::<S>::new(any(), any()));
    keep(FixedPointWindow::<S>::between_centers(any()));
    keep(FixedPointWindow::<S>::over_areas(any()));
    keep(FixedPointWindow::<S>::top_left(any()));
    keep(FixedPointWindow::<S>::bottom_right(any()));
    keep(FixedPointWindow::<S>::is_empty(any()));
    keep(FixedPointWindow::<S>::contains(any(), any()));
    eq::<FixedPointWindow<S>>();
}

#[inline(never)]
fn vertex<V: Vertex + 'static>() {
    keep(<V as Vertex>::x_units(any()));
    keep(<V as Vertex>::y_units(any()));
}

#[inline(never)]
fn window() {
    keep(Window::is_empty(any()));
    keep(Window::width(any()));
    keep(Window::height(any()));
    keep(Window::contains(any(), any()));
    keep(Window::intersection(any(), any()));
    keep(Window::meets(any(), any()));
    keep(Window::to_rectangle(any()));
    from::<Rectangle, Window>();
    eq::<Window>();
}

#[inline(never)]
fn values() {
    eq::<Sub4>();
    default::<Sub4>();
    eq::<Sub8>();
    default::<Sub8>();
    error::<InputError>();
    eq::<InputError>();
    from::<TooSmall, InputError>();
    keep(TooSmall::needed(any()));
    error::<TooSmall>();
    eq::<TooSmall>();
}
