use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    geometry::{Sub4, Sub8},
    scene::{
        Affine, BoundingBox, BoundingCylinder, BoundingSphere, Camera, DepthWidth, Fine, Orthographic, Pose, Rotation,
        ScreenPrecision, Whole,
    },
    shade::Transformed,
};
use zrow_panics_firmware::{any, keep};

use crate::foreign::{eq, from};

pub const EXERCISES: &[fn()] = &[
    affine,
    camera,
    depth_width::<u16>,
    depth_width::<u32>,
    pose,
    rotation,
    screen_precision::<Sub4>,
    screen_precision::<Sub8>,
];

#[inline(never)]
fn affine() {
    keep(Affine::scaled(any()));
    keep(Affine::then(any(), any()));
    keep(Affine::inverse(any()));
    keep(Affine::normals(any()));
    from::<Pose, Affine>();
    eq::<Affine>();
}

#[inline(never)]
fn camera() {
    keep(Camera::new(any(), any()));
    keep(Camera::with_focal_length(any(), any()));
    keep(Camera::with_field_of_view(any(), any()));
    keep(Camera::look_at(any(), any(), any(), any()));
    keep(Camera::with_scale(any(), any()));
    keep(Camera::with_centre(any(), any()));
    keep(Camera::with_far(any(), any()));
    keep(Camera::near_for::<Rgb565>(any(), any()));
    keep(Camera::may_see::<Rgb565>(any(), any::<BoundingBox>(), any()));
    keep(Camera::may_see::<Rgb565>(any(), any::<BoundingSphere>(), any()));
    keep(Camera::may_see::<Whole<Fine<Orthographic<Rgb565>>>>(
        any(),
        any::<BoundingCylinder>(),
        any(),
    ));
    keep(Camera::near_for::<Transformed<Rgb565>>(any(), any()));
    keep(Camera::with_pose(any(), any()));
    keep(Camera::far(any()));
    keep(Camera::scale(any()));
    keep(Camera::centre(any()));
    keep(Camera::pose(any()));
    keep(Camera::viewport(any()));
    keep(Camera::near(any()));
    keep(Camera::focal_length(any()));
    keep(Camera::depth_at::<Sub4, u16>(any(), any()));
    keep(Camera::depth_at::<Sub8, u32>(any(), any()));
    eq::<Camera>();
}

#[inline(never)]
fn depth_width<D: DepthWidth>() {
    keep(<D as DepthWidth>::from_near_over_z(any()));
    keep(<D as DepthWidth>::units(any()));
    keep(<D as DepthWidth>::from_units(any()));
    keep(<D as DepthWidth>::from_interpolated(any()));
}

#[inline(never)]
fn pose() {
    keep(Pose::new(any(), any()));
    keep(Pose::then(any(), any()));
    keep(Pose::inverse(any()));
    eq::<Pose>();
}

#[inline(never)]
fn rotation() {
    keep(Rotation::about_x(any()));
    keep(Rotation::about_y(any()));
    keep(Rotation::about_z(any()));
    keep(Rotation::about(any(), any()));
    keep(Rotation::from_quaternion(any()));
    keep(Rotation::look_at(any(), any()));
    keep(Rotation::then(any(), any()));
    keep(Rotation::inverse(any()));
    keep(Rotation::matrix(any()));
    eq::<Rotation>();
}

#[inline(never)]
fn screen_precision<S: ScreenPrecision>() {
    keep(<S as ScreenPrecision>::wide(any()));
    keep(<S as ScreenPrecision>::eye_element(any()));
    keep(<S as ScreenPrecision>::eye_offset(any(), any()));
    keep(<S as ScreenPrecision>::eye_coordinate(any(), any(), any()));
    keep(<S as ScreenPrecision>::eye_element_bits(any()));
    keep(<S as ScreenPrecision>::eye_offset_bits(any()));
    keep(<S as ScreenPrecision>::narrow(any()));
}
