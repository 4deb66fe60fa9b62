//! `zrow::clip` in space: what is left of a segment is visible, the same by all that clip one, and nothing of it is cut again;
//! what is visible of a face is kept.

use core::convert::Infallible;

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};
use fixed::types::I16F16;
use zrow::{
    clip::{ClipMatrix, ClipPlane, ClipPoint, Segments},
    geometry::{InputError, Sub4, Sub8, Window},
    scene::{Camera, Pose},
};

use crate::{
    families::view::Turn,
    target::{Case, Verdict},
    values::{Int, List, Number},
};

/// A camera, and a model in a pose in front of it, or anywhere.
#[derive(Debug, Arbitrary)]
pub struct View {
    size: [Number<u16>; 2],
    near: Int,
    far: Int,
    focal_length: Option<Int>,
    turns: [Turn; 2],
    places: Option<[[Int; 3]; 2]>,
}

impl View {
    /// The matrix; `None` where there is no such camera.
    pub fn get(&self) -> anyhow::Result<Option<(Camera, ClipMatrix)>> {
        let [width, height] = self.size.map(|size| size.0.into());
        let [near, far] = [self.near, self.far].map(|distance| I16F16::from_bits(distance.0));
        let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(width, height)), near);
        let Ok(mut camera) = camera else { return Ok(None) };
        if let Some(length) = self.focal_length {
            camera = camera.with_focal_length(I16F16::from_bits(length.0)).unwrap_or(camera);
        }
        let place = |index: usize| {
            let places = self.places.and_then(|places| places.get(index).copied());
            places.map_or([I16F16::ZERO; 3], |place| place.map(|axis| I16F16::from_bits(axis.0)))
        };
        let [model, eye] = self.turns.map(Turn::get);
        let camera = camera.with_pose(Pose::new(eye, place(0)));
        match ClipMatrix::new(&camera, &Pose::new(model, place(1)), far) {
            Ok(matrix) => Ok(Some((camera, matrix))),
            Err(InputError::FarTooClose) => {
                ensure!(
                    i64::from(far.to_bits()) < 2 * i64::from(near.to_bits()),
                    "{near}, {far}"
                );
                Ok(None)
            }
            Err(error) => anyhow::bail!("{error}, which is new"),
        }
    }
}

/// Whether a point is visible, but for what rounding moves it.
pub fn is_nearly_inside(point: &ClipPoint) -> bool {
    let [x, y, z, w] = [point.x, point.y, point.z, point.w].map(i128::from);
    w >= 0 && x.abs() <= w + 1 && y.abs() <= w + 1 && (-1..=w + 1).contains(&z)
}

/// A segment between two vertices, against what a camera sees and any planes.
#[derive(Debug, Arbitrary)]
pub struct SpaceSegmentCase {
    view: View,
    ends: [[Number<i16>; 3]; 2],
    planes: List<([Number<i16>; 3], [Int; 3]), 6>,
}

impl Case for SpaceSegmentCase {
    fn check(&self) -> Verdict {
        let [from, to] = self.ends.map(|end| end.map(|axis| axis.0));
        let Some((camera, matrix)) = self.view.get()? else {
            return Ok(());
        };
        let default = Segments::homogeneous_liang_barsky(from, to, &matrix);
        macro_rules! clip_by_each {
            ($([$name:ident] [$($clip:tt)+])+) => {
                $(
                    let found = $($clip)+(from, to, &matrix);
                    ensure!(found == default, "{} gives {found:?}, not {default:?}", stringify!($name));
                )+
            };
        }
        zrow_methods::space_segments!(clip_by_each);
        let planes = matrix.planes();
        macro_rules! clip_to_planes {
            ($([$name:ident] [$($clip:tt)+])+) => {
                $(
                    let found = $($clip)+(from, to, &planes);
                    ensure!(found == default, "{} gives {found:?}, not {default:?}", stringify!($name));
                )+
            };
        }
        zrow_methods::volume_segments!(clip_to_planes);
        let ends = default.map(|part| part.ends(&matrix));
        let reversed = Segments::homogeneous_liang_barsky(to, from, &matrix).map(|part| part.ends(&matrix));
        ensure!(
            reversed.map(|(to, from)| (from, to)) == ends,
            "{reversed:?} from the other end, {ends:?}"
        );
        let again = default.and_then(|part| part.clip(&planes));
        ensure!(again == default, "{default:?}, clipped again {again:?}");
        for end in ends.iter().flat_map(|(from, to)| [from, to]) {
            ensure!(is_nearly_inside(end), "{end:?} is outside");
            // Wherever it is: no panic.
            let _ = (end.on_screen::<Sub4>(&camera), end.on_screen::<Sub8>(&camera));
        }
        self.check_volume(from, to)
    }
}

impl SpaceSegmentCase {
    /// Any planes: their order and how often they cut is all the same.
    fn check_volume(&self, from: [i16; 3], to: [i16; 3]) -> Verdict {
        let planes = self
            .planes
            .0
            .iter()
            .map(|(point, inwards)| ClipPlane::through(point.map(|axis| axis.0), inwards.map(|axis| axis.0)));
        let mut planes: Vec<ClipPlane> = planes.collect();
        let part = Segments::cyrus_beck_in_space(from, to, &planes);
        planes.reverse();
        let mut one_by_one = Segments::cyrus_beck_in_space(from, to, &[]);
        for plane in &planes {
            one_by_one = one_by_one.and_then(|part| part.clip(&[*plane]));
        }
        ensure!(one_by_one == part, "{part:?}, plane by plane {one_by_one:?}");
        Ok(())
    }
}

/// A face, against what a camera sees.
#[derive(Debug, Arbitrary)]
pub struct SpaceFaceCase {
    view: View,
    vertices: [([Number<i16>; 3], [Int; 2]); 3],
}

impl Case for SpaceFaceCase {
    fn check(&self) -> Verdict {
        let face = self
            .vertices
            .map(|(vertex, attributes)| (vertex.map(|axis| axis.0), attributes.map(|attribute| attribute.0)));
        let Some((camera, matrix)) = self.view.get()? else {
            return Ok(());
        };
        let between = [0, 1].map(|index: usize| {
            let attributes = face.map(|(_, attributes)| attributes.get(index).copied().unwrap_or_default());
            attributes.iter().copied().min().zip(attributes.iter().copied().max())
        });
        macro_rules! clip_by_each {
            ($([$name:ident] [$($clip:tt)+])+) => {
                [$((stringify!($name), $($clip)+(&matrix, &face))),+]
            };
        }
        for (name, polygon) in zrow_methods::space_polygons!(clip_by_each) {
            for (point, attributes) in &polygon {
                for (attribute, range) in attributes.iter().zip(between) {
                    let is_between = range.is_some_and(|(least, most)| (least..=most).contains(attribute));
                    ensure!(is_between, "{name}: {attribute} is not within {range:?}");
                }
                let _ = (point.on_screen::<Sub4>(&camera), point.on_screen::<Sub8>(&camera));
            }
        }
        let polygon = matrix.sutherland_hodgman(&face);
        let is_inside = face.map(|(vertex, _)| matrix.apply(vertex).is_inside());
        for ((vertex, _), is_inside) in face.iter().zip(is_inside) {
            let point = matrix.apply(*vertex);
            let is_kept = polygon.iter().any(|(corner, _)| *corner == point);
            ensure!(is_kept == is_inside || is_kept, "{point:?} is lost");
        }
        if is_inside == [true; 3] {
            ensure!(polygon.len() == 3, "{polygon:?} of a visible face");
        }
        Ok(())
    }
}

/// A triangle in homogeneous coordinates: of a model, or of any numbers.
#[derive(Debug, Arbitrary)]
pub struct HomogeneousTriangleCase {
    view: View,
    vertices: [[Number<i16>; 3]; 3],
    by_hand: Option<[[Number<i64>; 4]; 3]>,
    corner: [Number<u16>; 2],
}

impl Case for HomogeneousTriangleCase {
    fn check(&self) -> Verdict {
        let Some((camera, matrix)) = self.view.get()? else {
            return Ok(());
        };
        let of_model = self.vertices.map(|vertex| matrix.apply(vertex.map(|axis| axis.0)));
        let by_hand = self.by_hand.map(|corners| {
            corners.map(|corner| {
                let [x, y, z, w] = corner.map(|number| number.0);
                ClipPoint { x, y, z, w }
            })
        });
        let [a, b, c] = by_hand.unwrap_or(of_model);
        let viewport = camera.viewport();
        let [left, top] = self.corner.map(|corner| i32::from(corner.0));
        let window = Window {
            left: viewport.left.saturating_add(left),
            top: viewport.top.saturating_add(top),
            right: viewport.left.saturating_add(left + 32),
            bottom: viewport.top.saturating_add(top + 32),
        };
        macro_rules! fill_by_each {
            ($([$name:ident] [$($fill:tt)+])+) => {
                $(
                    let filled = |corners: [ClipPoint; 3]| {
                        let mut spans = Vec::new();
                        let Ok(()) = $($fill)+(corners, &camera, &window, |span| {
                            spans.push((span.y, span.start, span.end));
                            Ok::<(), Infallible>(())
                        });
                        spans
                    };
                    let spans = filled([a, b, c]);
                    let visible = window.intersection(&viewport);
                    for &(y, start, end) in &spans {
                        let is_inside = (visible.top..visible.bottom).contains(&y)
                            && visible.left <= start && start < end && end <= visible.right;
                        ensure!(is_inside, "{start} to {end} in row {y} of {visible:?}");
                    }
                    ensure!(spans.windows(2).all(|rows| rows[0].0 < rows[1].0), "{spans:?} are not in order");
                    ensure!(filled([b, c, a]) == spans, "another first corner, other pixels");
                    ensure!(filled([c, b, a]) == spans, "the other way round, other pixels");
                )+
            };
        }
        zrow_methods::homogeneous_triangles!(fill_by_each);
        Ok(())
    }
}
