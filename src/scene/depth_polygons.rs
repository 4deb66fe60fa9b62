//! Planar polygons beside the models of a scene: from their own space through the camera into the memory of a
//! [`DepthPolygon`].
//!
//! ```text
//!   corners -> eye space -> cut at the near and the far plane -> projected -> cut at the guard band -> y table
//! ```
//!
//! Planes cut as Sutherland and Hodgman 1974 do, one corner after the other, so that no cut contour is ever stored. Around a
//! point inside of all planes the cut contour winds as often as the whole one, whatever its shape: what is cut off is replaced by
//! edges along the planes.
//!
//! Nothing of it is linked into programs that do not ask for it.

use crate::{
    clip::convex::{Plane, cut_segment},
    geometry::{SubPixel, TooSmall},
    scan::FillRule,
    scene::{
        Look, Prepared,
        lens::{ProjectionOf, ScreenVertexOf, has_far_plane, projection},
        off_screen::{eye_corner, guard_band, project_corner},
    },
    view::{DepthWidth, EyeTransform, Pose, ScreenPrecision, ScreenVertex},
    visible::{DepthPolygon, twice_the_area},
};

/// A position of a look in the wide numbers that polygons are cut in.
type Position<L> = [<<L as Look>::Precision as ScreenPrecision>::Wide; 3];

impl<L: Look> Prepared<'_, '_, L> {
    /// Puts a planar polygon into memory from which `row.draw_polygon` draws it into the rows of this frame, beside the faces of
    /// the models and hidden by them, without triangles. The polygon may be concave, have holes, and cross itself.
    ///
    /// A contour is a closed chain of corners in the polygon's own space, from where `pose` brings them to the world, as those
    /// of a model. `rule` says what is inside of several contours, or of one that crosses itself. The corners should lie on one
    /// plane: [`DepthPolygon`] says which one is drawn if they do not. Contours of fewer than three corners have no pixels.
    ///
    /// Near plane, far plane and guard band cut the polygon as they cut faces: a face with an edge of the polygon has the same
    /// pixels along it.
    ///
    /// Cost: each corner is transformed and projected twice; two divisions an edge, and a sort.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     scan::FillRule,
    ///     scene::{Camera, FaceSet, Memory, Model, Pose},
    ///     visible::{DepthPolygon, DepthState},
    /// };
    ///
    /// // A wall with a window, and a spike that pierces it there.
    /// const WALL: [[i16; 3]; 4] = [[-400, -400, 1024], [-400, 400, 1024], [400, 400, 1024], [400, -400, 1024]];
    /// const WINDOW: [[i16; 3]; 4] = [[-200, -200, 1024], [200, -200, 1024], [200, 200, 1024], [-200, 200, 1024]];
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(64))?;
    /// let mesh = FaceSet::new(&[[-100, 0, 900], [0, 500, 2000], [100, 0, 900]], &[[0, 1, 2]])?;
    /// let models = [Model::new(mesh, &[Rgb565::RED])?];
    /// let mut memory = Memory::<Rgb565, 3, 1, 64, 64>::new();
    /// let mut scene = memory.prepare(&camera, &models)?;
    ///
    /// let mut wall = DepthPolygon::<u16, 8>::new();
    /// scene.prepare_polygon(&mut wall, &Pose::IDENTITY, &[&WALL, &WINDOW], FillRule::EvenOdd)?;
    /// let mut words = [0; 64 * 64];
    /// scene.draw_with(&mut Band::<Rgb565>::new(area, &mut words)?, |row| {
    ///     row.draw_polygon(&mut wall, Rgb565::GREEN, &DepthState::NEARER);
    /// });
    /// let color_at = |x: usize, y: usize| words[64 * y + x];
    /// assert_eq!(color_at(21, 32), Rgb565::GREEN.into_storage());
    /// assert_eq!(color_at(32, 30), Rgb565::RED.into_storage());
    /// assert_eq!(color_at(27, 27), 0);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// [`TooSmall::Edges`] with the number that would do: one for each edge that crosses a row of the viewport, and those that
    /// cutting adds. The polygon then has no pixels.
    pub fn prepare_polygon<const N: usize>(
        &self,
        polygon: &mut DepthPolygon<L::Depth, N>,
        pose: &Pose,
        contours: &[&[[i16; 3]]],
        rule: FillRule,
    ) -> Result<(), TooSmall> {
        let camera = &self.faces.camera;
        let source = Source::<L> {
            transform: EyeTransform::new(pose, camera.pose()),
            projection: projection::<L>(camera),
            contours,
        };
        let viewport = camera.viewport();
        let mut table = polygon.begin(rule);
        let mut corners = FarCorners::<L>::default();
        source.for_each_edge(&mut |ends| {
            let positions = ends.each_ref().map(|end| (end.x_units(), end.y_units()));
            table.add(positions, L::Precision::FRACTION_BITS, &viewport);
            ends.into_iter().for_each(|end| corners.see(end));
        });
        if let Some(needed) = table.missing() {
            polygon.clear();
            return Err(TooSmall::Edges(needed));
        }
        let Some([first, farthest]) = corners.ends else {
            polygon.clear();
            return Ok(());
        };
        let mut third = (0, first);
        source.for_each_edge(&mut |[_, end]| {
            let area = twice_the_area([&first, &farthest, &end]).unsigned_abs();
            if area > third.0 {
                third = (area, end);
            }
        });
        polygon.finish([first, farthest, third.1], corners.range, &viewport);
        Ok(())
    }
}

/// The first corner of a polygon on the screen, the one farthest from it, and the range of depths.
struct FarCorners<L: Look> {
    ends: Option<[ScreenVertexOf<L>; 2]>,
    /// The square of the distance of both.
    distance: u64,
    range: [L::Depth; 2],
}

impl<L: Look> Default for FarCorners<L> {
    fn default() -> Self {
        Self {
            ends: None,
            distance: 0,
            range: [L::Depth::NEAREST, L::Depth::FARTHEST],
        }
    }
}

impl<L: Look> FarCorners<L> {
    fn see(&mut self, corner: ScreenVertexOf<L>) {
        let [farthest, nearest] = self.range;
        self.range = [farthest.min(corner.z), nearest.max(corner.z)];
        let [first, _] = *self.ends.get_or_insert([corner; 2]);
        let way = corner.position().minus(first.position());
        // Differences of positions are below 2^25.
        let distance = [way.x, way.y].map(|way| u64::from(way.unsigned_abs()).pow(2));
        let [columns, rows] = distance;
        if columns + rows > self.distance {
            self.distance = columns + rows;
            self.ends = Some([first, corner]);
        }
    }
}

/// The contours of a polygon, and the way from its space to the screen.
struct Source<'a, L: Look> {
    transform: EyeTransform<L::Precision>,
    projection: ProjectionOf<L>,
    contours: &'a [&'a [[i16; 3]]],
}

impl<L: Look> Source<'_, L> {
    /// Hands over the edges on the screen of what all planes leave of all contours.
    fn for_each_edge(&self, edge: &mut dyn FnMut([ScreenVertexOf<L>; 2])) {
        for contour in self.contours {
            let mut cuts = self.cuts();
            let mut outline = Outline::<L>(None);
            for vertex in *contour {
                let corner = eye_corner::<L::Precision>(&self.transform, *vertex);
                self.cut(&mut cuts, 0, corner, &mut |corner| outline.line_to(corner, edge));
            }
            for index in 0..PLANES {
                // The last edge, back to the first corner.
                if let Some(corner) = cuts.get(index).and_then(CutContour::close) {
                    let corner = self.after(index, corner);
                    self.cut(&mut cuts, index + 1, corner, &mut |corner| {
                        outline.line_to(corner, edge)
                    });
                }
            }
            outline.close(edge);
        }
    }

    /// A contour that all planes are going to cut: the near and the far plane in eye space, then the guard band on the screen.
    fn cuts(&self) -> [CutContour<L>; PLANES] {
        let far = has_far_plane::<L>(&self.projection).then(|| Plane::far(self.projection.far));
        let [left, right, top, bottom] = guard_band::<L>().map(Some);
        [Some(Plane::near(self.projection.near)), far, left, right, top, bottom].map(CutContour::new)
    }

    /// Hands over the corners that a contour gets by its next corner, which the planes before `first` have already cut.
    fn cut(
        &self,
        cuts: &mut [CutContour<L>; PLANES],
        first: usize,
        corner: Position<L>,
        emit: &mut dyn FnMut(Position<L>),
    ) {
        // A corner becomes two at most at each plane. The first one goes through all planes that follow before the second one
        // does, so that never more than two wait for a plane.
        let mut waiting = [[None; 2]; PLANES + 1];
        if let Some(slot) = waiting.get_mut(first) {
            *slot = [Some(corner), None];
        }
        while let Some((index, corner)) = take_last::<L>(&mut waiting) {
            let Some(cut) = cuts.get_mut(index) else {
                emit(corner);
                continue;
            };
            let corners = cut
                .next(corner)
                .map(|corner| corner.map(|corner| self.after(index, corner)));
            if let Some(slot) = waiting.get_mut(index + 1) {
                *slot = corners;
            }
        }
    }

    /// A corner that a plane has cut, as the next plane takes it: it is projected between the far plane and the guard band.
    fn after(&self, index: usize, mut corner: Position<L>) -> Position<L> {
        if index == LAST_IN_EYE_SPACE {
            project_corner::<L>(&self.projection, &mut corner);
        }
        corner
    }
}

/// The near plane, the far plane, and the sides of the guard band.
const PLANES: usize = 6;
/// The index of the last plane that cuts in eye space.
const LAST_IN_EYE_SPACE: usize = 1;

/// Takes the corner that waits for the last plane out, with the index of the plane.
fn take_last<L: Look>(waiting: &mut [[Option<Position<L>>; 2]; PLANES + 1]) -> Option<(usize, Position<L>)> {
    let slots = waiting.iter_mut().enumerate().rev();
    slots
        .filter_map(|(index, [first, second])| Some((index, first.take().or_else(|| second.take())?)))
        .next()
}

/// A closed contour that is cut by a plane, one corner after the other (Sutherland and Hodgman 1974).
struct CutContour<L: Look> {
    /// The plane; `None` where nothing is cut off.
    plane: Option<Plane>,
    /// The first corner of the contour and the one before the next.
    ends: Option<[Position<L>; 2]>,
}

impl<L: Look> CutContour<L> {
    const fn new(plane: Option<Plane>) -> Self {
        Self { plane, ends: None }
    }

    /// The corners of the cut contour for the next one of the whole: where the edge to it crosses the plane, and the corner
    /// itself where it is kept.
    fn next(&mut self, corner: Position<L>) -> [Option<Position<L>>; 2] {
        let cut = self.ends.and_then(|[_, previous]| self.crossing(previous, corner));
        let [first, _] = self.ends.unwrap_or([corner; 2]);
        self.ends = Some([first, corner]);
        [cut, self.keeps(&corner).then_some(corner)]
    }

    /// The corner of the cut contour where the last edge of the whole, back to its first corner, crosses the plane.
    fn close(&self) -> Option<Position<L>> {
        let [first, last] = self.ends?;
        self.crossing(last, first)
    }

    fn keeps(&self, corner: &Position<L>) -> bool {
        self.plane
            .as_ref()
            .is_none_or(|plane| plane.distance::<L::Precision>(corner) >= 0)
    }

    fn crossing(&self, from: Position<L>, to: Position<L>) -> Option<Position<L>> {
        let plane = self.plane.as_ref()?;
        let is_entered = self.keeps(&to);
        if self.keeps(&from) == is_entered {
            return None;
        }
        let [start, end] = cut_segment::<L::Precision>([from, to], plane)?;
        Some(if is_entered { start } else { end })
    }
}

/// A contour on the screen: its first corner and its last one so far.
struct Outline<L: Look>(Option<[ScreenVertexOf<L>; 2]>);

impl<L: Look> Outline<L> {
    /// Hands over the edge to the next corner, which is inside of the guard band.
    fn line_to(&mut self, [x, y, z]: Position<L>, edge: &mut dyn FnMut([ScreenVertexOf<L>; 2])) {
        let corner = ScreenVertex {
            x: L::Precision::narrow(x.into() as i32),
            y: L::Precision::narrow(y.into() as i32),
            z: L::Depth::from_units(z.into() as i32),
        };
        if let Some([_, last]) = self.0 {
            edge([last, corner]);
        }
        let [first, _] = self.0.unwrap_or([corner; 2]);
        self.0 = Some([first, corner]);
    }

    fn close(&self, edge: &mut dyn FnMut([ScreenVertexOf<L>; 2])) {
        if let Some([first, last]) = self.0 {
            edge([last, first]);
        }
    }
}
