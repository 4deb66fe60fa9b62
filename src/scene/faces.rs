//! The faces of a prepared frame, to be read.

use core::ops::Range;

use embedded_graphics::geometry::Point;

use crate::{
    geometry::SubPoint,
    scene::{
        Look, Model,
        back_faces::transformed,
        culling::is_left_out,
        frame::{FRAGMENT_VERTICES, corners},
        lens::ScreenVertexOf,
        model::outward,
        off_screen::is_outside,
        preparation::clockwise,
    },
    shade::Shading,
    view::{Camera, DepthWidth, ScreenPrecision, ScreenVertex},
};

/// A corner of a face on the screen.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Corner<S: ScreenPrecision, D> {
    /// The position that the corner was snapped to.
    pub point: SubPoint<S>,
    /// The corner's depth as stored: nearer is larger.
    pub depth: D,
}

/// A face on the screen, or a fragment of one that was cut.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScreenFace<S: ScreenPrecision, D> {
    /// Index of the face in the order of models and faces: of two fragments with the same depth, the lower one is
    /// drawn.
    pub order: usize,
    /// Corners in the order of the mesh; the second and the third exchanged where a map mirrors the model, and once more where
    /// the face's back is drawn.
    pub corners: [Corner<S, D>; 3],
}

impl<S: ScreenPrecision, D: DepthWidth> Corner<S, D> {
    pub(super) fn new(vertex: &ScreenVertex<S, D>) -> Option<Self> {
        Some(Self {
            point: SubPoint::from_units(vertex.x_units(), vertex.y_units()).ok()?,
            depth: vertex.z,
        })
    }

    /// The pixel that the corner is in: its position to the nearest pixel, halves to the right and down.
    pub fn pixel(&self) -> Point {
        let nearest = |units: i32| (units + (1 << (S::FRACTION_BITS - 1))) >> S::FRACTION_BITS;
        Point::new(nearest(self.point.x_units()), nearest(self.point.y_units()))
    }
}

impl<S: ScreenPrecision, D: DepthWidth> ScreenFace<S, D> {
    fn new(order: usize, [a, b, c]: [&ScreenVertex<S, D>; 3]) -> Option<Self> {
        Some(Self {
            order,
            corners: [Corner::new(a)?, Corner::new(b)?, Corner::new(c)?],
        })
    }
}

/// The faces of a prepared frame, the whole ones in the order of models and faces, then the fragments of those that were cut.
pub(super) fn all<'t, 'm, L: Look>(
    vertices: &'t [ScreenVertex<L::Precision, L::Depth>],
    models: &'t [Model<'m, L::Shading>],
    camera: &'t Camera,
    fragments: Range<usize>,
) -> impl Iterator<Item = ScreenFace<L::Precision, L::Depth>> + use<'t, 'm, L> {
    let fragments = vertices.get(fragments).unwrap_or_default();
    whole::<L>(vertices, models, camera).chain(clipped(fragments))
}

/// The corners of a face of a model, whose vertices these are, in the order of the mesh. Those that were not transformed, because
/// none of their faces is drawn, are transformed now.
pub(super) fn corners_of<L: Look>(
    vertices: &[ScreenVertexOf<L>],
    model: &Model<'_, L::Shading>,
    camera: &Camera,
    face: usize,
) -> Option<[ScreenVertexOf<L>; 3]> {
    let face = model.mesh().faces().get(face)?;
    let ([a, b, c], [i, j, k]) = (corners(vertices, face)?, face.map(usize::from));
    Some([(a, i), (b, j), (c, k)].map(|(vertex, index)| transformed::<L>(vertex, index, model, camera)))
}

/// The faces of a prepared frame that were not cut.
fn whole<'t, 'm, L: Look>(
    vertices: &'t [ScreenVertex<L::Precision, L::Depth>],
    models: &'t [Model<'m, L::Shading>],
    camera: &'t Camera,
) -> impl Iterator<Item = ScreenFace<L::Precision, L::Depth>> + use<'t, 'm, L> {
    let faces = models.iter().map(|model| model.mesh().faces().len()).sum::<usize>();
    (0..faces).filter_map(move |order| {
        let (model, first_vertex, face) = find(models, order as u16)?;
        if is_left_out::<L>(vertices, first_vertex) {
            return None;
        }
        let corners = corners_of::<L>(vertices.get(first_vertex..)?, model, camera, face)?;
        let corners = outward::<L::Shading, _>(model.skin(), corners.each_ref());
        if L::CLIPS && corners.into_iter().any(is_outside) {
            return None;
        }
        ScreenFace::new(order, clockwise::<L, _>(corners, corners))
    })
}

/// The fragments of the faces that were cut, in the order of faces: the table was filled backwards.
fn clipped<S: ScreenPrecision, D: DepthWidth>(
    fragments: &[ScreenVertex<S, D>],
) -> impl Iterator<Item = ScreenFace<S, D>> + '_ {
    fragments
        .chunks_exact(FRAGMENT_VERTICES)
        .filter_map(|fragment| match fragment {
            [header, a, b, c] => ScreenFace::new(usize::from(header.x_units() as u16), [a, b, c]),
            _ => None,
        })
}

/// The model of a face, the index of its first vertex, and the face's index in it.
pub(super) fn find<'t, 'm, H: Shading>(
    models: &'t [Model<'m, H>],
    order: u16,
) -> Option<(&'t Model<'m, H>, usize, usize)> {
    let mut face = usize::from(order);
    let mut first_vertex = 0usize;
    for model in models {
        let mesh = model.mesh();
        match face.checked_sub(mesh.faces().len()) {
            None => return Some((model, first_vertex, face)),
            Some(rest) => face = rest,
        }
        first_vertex += mesh.vertices().len();
    }
    None
}
