//! The solids of a scene: their boxes, which models are convex on the screen, and the interval of a line that one hides.

use crate::{
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::{
        hiding::cut,
        line_table::{LineFace, LinePoint, LineTable},
        parts::END,
        roberts::plane::Plane,
    },
};

/// A model among those that may hide lines.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Solid {
    /// Around all faces.
    pub(super) bounds: Bounds,
    /// The first of its planes, and the one after the last; none of a model that is not convex.
    planes: [u32; 2],
    /// The interval that it hides of the line that is tested, as parameters; empty where it hides nothing. Of a model that is
    /// not convex, all of the line if it may hide something.
    pub(super) hidden: [u32; 2],
}

/// A box on the screen, and how near what is in it comes to the viewer.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Bounds {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
    nearest: i32,
    farthest: i32,
}

/// What the planes of a model say.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) enum Volume {
    /// The model is convex on the screen and has so many planes.
    Convex(usize),
    /// It is not, or was cut.
    Other,
}

/// What a solid hides of a line, and how many inequalities were solved.
pub(super) struct Hidden {
    pub(super) interval: Option<[u32; 2]>,
    pub(super) inequalities: u32,
}

impl Solid {
    pub(super) const ZERO: Self = Self {
        bounds: Bounds {
            left: 0,
            top: 0,
            right: 0,
            bottom: 0,
            nearest: 0,
            farthest: 0,
        },
        planes: [0; 2],
        hidden: [0; 2],
    };

    pub(super) fn new(bounds: Bounds, planes: [usize; 2]) -> Self {
        Self {
            bounds,
            planes: planes.map(|plane| plane as u32),
            hidden: [0; 2],
        }
    }

    pub(super) const fn is_convex(&self) -> bool {
        let [first, end] = self.planes;
        first < end
    }

    /// Whether a face is part of the surface of the model that may be seen.
    pub(super) const fn shows(&self, face: &LineFace) -> bool {
        face.is_front || (face.is_seen && !self.is_convex())
    }

    /// The interval of a line that the solid hides: where all inequalities hold.
    pub(super) fn hidden_interval(&self, planes: &[Plane], ends: [LinePoint; 2]) -> Hidden {
        let [first, end] = self.planes.map(|plane| plane as usize);
        let (mut interval, mut inequalities) = (Some([0, END]), 0);
        for plane in planes.get(first..end).unwrap_or_default() {
            let Some(rest) = interval else { break };
            interval = cut(rest, ends.map(|end| plane.at(end)));
            inequalities += 1;
        }
        Hidden { interval, inequalities }
    }
}

impl Bounds {
    /// Around no point: meets nothing.
    const NONE: Self = Self {
        left: i32::MAX,
        top: i32::MAX,
        right: i32::MIN,
        bottom: i32::MIN,
        nearest: i32::MIN,
        farthest: i32::MAX,
    };

    pub(super) fn of_points(points: &[LinePoint]) -> Self {
        points.iter().fold(Self::NONE, |bounds, point| Self {
            left: bounds.left.min(point.x),
            top: bounds.top.min(point.y),
            right: bounds.right.max(point.x),
            bottom: bounds.bottom.max(point.y),
            nearest: bounds.nearest.max(point.depth),
            farthest: bounds.farthest.min(point.depth),
        })
    }

    pub(super) fn of_faces(faces: impl Iterator<Item = LineFace>) -> Self {
        faces.fold(Self::NONE, |bounds, face| {
            let of_face = Self::of_points(&face.corners);
            Self {
                left: bounds.left.min(of_face.left),
                top: bounds.top.min(of_face.top),
                right: bounds.right.max(of_face.right),
                bottom: bounds.bottom.max(of_face.bottom),
                nearest: bounds.nearest.max(of_face.nearest),
                farthest: bounds.farthest.min(of_face.farthest),
            }
        })
    }

    /// Whether what is in the box may hide something in another one.
    pub(super) const fn may_hide(&self, other: &Self) -> bool {
        self.nearest > other.farthest
            && self.left <= other.right
            && other.left <= self.right
            && self.top <= other.bottom
            && other.top <= self.bottom
    }

    /// Whether two boxes have a point in common.
    pub(super) const fn meets(&self, other: &Self) -> bool {
        self.nearest >= other.farthest
            && other.nearest >= self.farthest
            && self.left <= other.right
            && other.left <= self.right
            && self.top <= other.bottom
            && other.top <= self.bottom
    }
}

/// The faces of a model, and the fragments of those that were cut.
pub(super) fn faces_of<S: ScreenPrecision, D: DepthWidth>(
    table: &impl LineTable<S, D>,
    model: usize,
) -> impl Iterator<Item = LineFace> {
    let last = table.models().saturating_sub(1);
    let fragments = table.faces_of_model(last).end..table.face_indices();
    let indices = table.faces_of_model(model).chain(fragments);
    indices
        .filter_map(|index| table.face(index))
        .filter(move |face| face.model == model)
}

/// The planes of a model that is convex on the screen, as many as there is room for.
pub(super) fn volume<S: ScreenPrecision, D: DepthWidth>(
    table: &impl LineTable<S, D>,
    model: usize,
    room: &mut [Plane],
) -> Volume {
    let (mut count, mut room) = (0, room.iter_mut());
    for index in table.faces_of_model(model) {
        let Some(face) = table.face(index) else {
            return Volume::Other;
        };
        let Some(plane) = front(&face) else { continue };
        let tolerance = plane.tolerance::<D>();
        if !has_all_corners(table, model, &plane, tolerance) {
            return Volume::Other;
        }
        if let Some(slot) = room.next() {
            *slot = plane.set_back::<D>();
        }
        count += 1;
        let [a, b, c] = face.corners;
        for side in [[a, b], [b, c], [c, a]] {
            if is_between_fronts(table, model, side) {
                continue;
            }
            let plane = Plane::beside(side);
            if !has_all_corners(table, model, &plane, plane.tolerance::<D>()) {
                return Volume::Other;
            }
            if let Some(slot) = room.next() {
                *slot = plane;
            }
            count += 1;
        }
    }
    if count == 0 {
        Volume::Other
    } else {
        Volume::Convex(count)
    }
}

/// The plane of a face, if it is seen from the front.
fn front(face: &LineFace) -> Option<Plane> {
    if !face.is_front {
        return None;
    }
    Plane::behind(face.corners)
}

/// Whether all corners of a model are inside, or outside by no more than a tolerance.
fn has_all_corners<S: ScreenPrecision, D: DepthWidth>(
    table: &impl LineTable<S, D>,
    model: usize,
    plane: &Plane,
    tolerance: i64,
) -> bool {
    let mut faces = table.faces_of_model(model).filter_map(|index| table.face(index));
    faces.all(|face| face.corners.into_iter().all(|corner| plane.at(corner) >= -tolerance))
}

/// Whether another face that is seen from the front has a side the other way round.
fn is_between_fronts<S: ScreenPrecision, D: DepthWidth>(
    table: &impl LineTable<S, D>,
    model: usize,
    [from, to]: [LinePoint; 2],
) -> bool {
    let mut fronts = table.faces_of_model(model).filter_map(|index| table.face(index));
    fronts.any(|face| {
        let [a, b, c] = face.corners;
        face.is_front && [[b, a], [c, b], [a, c]].contains(&[from, to])
    })
}
