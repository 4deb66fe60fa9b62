//! Once a frame: vertices to the screen, faces culled, cut and sorted by their first row.

use core::fmt::{self, Display};

use crate::{
    clip::{CutFace, guard_band, near_plane},
    geometry::{OutOfDomain, Table, TableFull, Window},
    scene::{
        Frame, Model, Prepared,
        frame::{MOST_ENTRIES, PIECE, PIECE_VERTICES, Tables},
    },
    target::BandColor,
    view::{Camera, DepthWidth, EyeTransform, Projection, ScreenPrecision, ScreenVertex, WideVertex},
};

/// A scene cannot be prepared.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PrepareError {
    /// A table is too small. The storage can be prepared again with fewer models.
    TableFull(TableFull),
    /// The viewport reaches beyond the coordinates of the precision.
    ViewportOutOfDomain(OutOfDomain),
}

impl<C, const VERTICES: usize, const FACES: usize, const ACTIVE: usize, const ROWS: usize, S, D>
    Frame<C, VERTICES, FACES, ACTIVE, ROWS, S, D>
where
    C: BandColor,
    S: ScreenPrecision,
    D: DepthWidth,
{
    /// Prepares a frame: each vertex is transformed once; faces that are seen from behind or cover no pixel of the
    /// viewport are left out; faces that cross the near plane or leave the guard band are cut.
    ///
    /// # Errors
    /// [`PrepareError::TableFull`] with the capacity that would do, exactly; [`PrepareError::ViewportOutOfDomain`].
    pub fn prepare<'f>(
        &'f mut self,
        camera: &Camera,
        models: &'f [Model<'f, C>],
    ) -> Result<Prepared<'f, C, VERTICES, FACES, ACTIVE, ROWS, S, D>, PrepareError> {
        let viewport = camera.viewport();
        check_viewport::<S>(&viewport)?;
        let vertices = models.iter().map(|model| model.mesh().vertices().len()).sum();
        let faces = models.iter().map(|model| model.mesh().faces().len()).sum();
        check(Table::Vertices, VERTICES.min(MOST_ENTRIES), vertices)?;
        check(Table::Faces, FACES.min(MOST_ENTRIES), faces)?;
        check(Table::Rows, ROWS, viewport.height() as usize)?;

        let mut preparation = Preparation {
            tables: &mut self.tables,
            projection: Projection::new(camera),
            viewport,
            vertices_needed: vertices,
        };
        preparation.tables.clear_rows();
        preparation.transform_vertices(camera, models);
        preparation.sort_faces(camera, models, vertices, faces);
        let vertices_needed = preparation.vertices_needed;
        check(Table::Vertices, VERTICES.min(MOST_ENTRIES), vertices_needed)?;
        check(Table::ActiveFaces, ACTIVE, self.tables.most_active())?;
        self.active.restart();
        Ok(Prepared::new(self, models, viewport, vertices..vertices_needed))
    }
}

fn check_viewport<S: ScreenPrecision>(viewport: &Window) -> Result<(), PrepareError> {
    let domain = OutOfDomain::of::<S>();
    let inside = domain.min <= viewport.left.min(viewport.top) && viewport.right.max(viewport.bottom) <= domain.max;
    if inside {
        Ok(())
    } else {
        Err(PrepareError::ViewportOutOfDomain(domain))
    }
}

fn check(table: Table, capacity: usize, needed: usize) -> Result<(), PrepareError> {
    trace!("{}: {} of {} in use", table, needed, capacity);
    if needed <= capacity {
        Ok(())
    } else {
        Err(PrepareError::TableFull(TableFull { table, needed }))
    }
}

struct Preparation<'f, S: ScreenPrecision, D: DepthWidth, const VERTICES: usize, const FACES: usize, const ROWS: usize>
{
    tables: &'f mut Tables<S, D, VERTICES, FACES, ROWS>,
    projection: Projection<S, D>,
    viewport: Window,
    /// Vertices of the models and of the pieces so far, whether there was room or not.
    vertices_needed: usize,
}

impl<S: ScreenPrecision, D: DepthWidth, const VERTICES: usize, const FACES: usize, const ROWS: usize>
    Preparation<'_, S, D, VERTICES, FACES, ROWS>
{
    fn transform_vertices<C>(&mut self, camera: &Camera, models: &[Model<'_, C>]) {
        let Self { tables, projection, .. } = self;
        let mut places = tables.vertices.iter_mut();
        for model in models {
            let transform = EyeTransform::new(&model.pose, camera.pose());
            // The vertices come second: a place that is taken out of the iterator must not be lost.
            for (vertex, place) in model.mesh().vertices().iter().zip(&mut places) {
                *place = on_screen(projection, &transform, *vertex);
            }
        }
    }

    /// Backwards, because each face is put before the others of its row.
    fn sort_faces<C>(&mut self, camera: &Camera, models: &[Model<'_, C>], vertices: usize, faces: usize) {
        let (mut first_vertex, mut entry) = (vertices, faces);
        for model in models.iter().rev() {
            let mesh = model.mesh();
            first_vertex = first_vertex.saturating_sub(mesh.vertices().len());
            for face in mesh.faces().iter().rev() {
                entry = entry.saturating_sub(1);
                let Some(corners) = self.tables.corners(first_vertex, face) else {
                    continue;
                };
                if corners.iter().any(is_outside) {
                    if !all_outside_alike(&corners) {
                        self.cut_face(camera, model, face, entry as u16);
                    }
                } else if let Some((row, after)) = self.visible_rows(&corners) {
                    self.tables.begin(entry as u16, row);
                    self.tables.count(row, after);
                }
            }
        }
    }

    /// The rows of the viewport, from its top, in which a face that is seen from the front may cover pixels.
    #[inline(always)]
    fn visible_rows(&self, [a, b, c]: &[ScreenVertex<S, D>; 3]) -> Option<(usize, usize)> {
        if !is_front(a, b, c) {
            return None;
        }
        let (x_a, x_b, x_c) = (a.x_units(), b.x_units(), c.x_units());
        let (y_a, y_b, y_c) = (a.y_units(), b.y_units(), c.y_units());
        // The first row or column whose centre is at that coordinate or after it.
        let ceiling = |units: i32| units.wrapping_add((1 << S::FRACTION_BITS) - 1) >> S::FRACTION_BITS;
        let top = ceiling(y_a.min(y_b).min(y_c)).max(self.viewport.top);
        let bottom = ceiling(y_a.max(y_b).max(y_c)).min(self.viewport.bottom);
        if top >= bottom {
            return None;
        }
        let left = ceiling(x_a.min(x_b).min(x_c)).max(self.viewport.left);
        let right = ceiling(x_a.max(x_b).max(x_c)).min(self.viewport.right);
        if left >= right {
            return None;
        }
        let from_top = |row: i32| row.wrapping_sub(self.viewport.top) as usize;
        Some((from_top(top), from_top(bottom)))
    }

    /// Cuts a face and puts its pieces, a fan of triangles, behind the vertices.
    #[cold]
    #[inline(never)]
    fn cut_face<C>(&mut self, camera: &Camera, model: &Model<'_, C>, face: &[u16; 3], order: u16) {
        let transform = EyeTransform::new(&model.pose, camera.pose());
        let corners = face.map(|index| {
            let vertex = model.mesh().vertices().get(usize::from(index));
            transform.apply(vertex.copied().unwrap_or_default())
        });
        let projected: CutFace = near_plane(&corners, self.projection.near)
            .iter()
            .map(|eye| self.projection.project(*eye))
            .collect();
        let cut = guard_band::<S>(&projected);
        let Some((apex, fan)) = cut.split_first() else { return };
        let pieces = fan.windows(2).rev().filter_map(|pair| match pair {
            [second, third] => Some([*apex, *second, *third].map(inside)),
            _ => None,
        });
        for corners in pieces {
            if let Some((row, after)) = self.visible_rows(&corners) {
                self.tables.count(row, after);
                self.add_piece(&corners, order, row);
            }
        }
    }

    fn add_piece(&mut self, corners: &[ScreenVertex<S, D>; 3], order: u16, row: usize) {
        let head = self.vertices_needed;
        self.vertices_needed = self.vertices_needed.saturating_add(PIECE_VERTICES);
        if self.vertices_needed > VERTICES.min(MOST_ENTRIES) {
            return;
        }
        if let Some([place, rest @ ..]) = self.tables.vertices.get_mut(head..self.vertices_needed) {
            place.x = S::narrow(i32::from(order));
            rest.copy_from_slice(corners);
        }
        self.tables.begin(PIECE | head as u16, row);
    }
}

impl<S: ScreenPrecision, D: DepthWidth, const VERTICES: usize, const FACES: usize, const ROWS: usize>
    Tables<S, D, VERTICES, FACES, ROWS>
{
    #[inline(always)]
    pub(super) fn corners(&self, first_vertex: usize, face: &[u16; 3]) -> Option<[ScreenVertex<S, D>; 3]> {
        let [a, b, c] = *face;
        let corner = |index: u16| {
            self.vertices
                .get(first_vertex.wrapping_add(usize::from(index)))
                .copied()
        };
        Some([corner(a)?, corner(b)?, corner(c)?])
    }

    /// Counts a face in the rows that it crosses. Fewer than 32,768 faces cannot leave 16 bits: cut faces have pieces,
    /// but those take four vertices each.
    #[inline(always)]
    fn count(&mut self, row: usize, after: usize) {
        if let Some(change) = self.change.get_mut(row) {
            *change = change.wrapping_add(1);
        }
        if let Some(change) = self.change.get_mut(after) {
            *change = change.wrapping_sub(1);
        }
    }

    /// The most faces that cross a row.
    fn most_active(&self) -> usize {
        let mut active = 0i32;
        let mut most = 0;
        for change in &self.change {
            active = active.wrapping_add(i32::from(*change));
            most = most.max(active);
        }
        most as usize
    }
}

/// Projects a vertex. One that has no place on the screen keeps the sides that it is beyond.
#[inline(always)]
fn on_screen<S: ScreenPrecision, D: DepthWidth>(
    projection: &Projection<S, D>,
    transform: &EyeTransform,
    vertex: [i16; 3],
) -> ScreenVertex<S, D> {
    let eye = transform.apply(vertex);
    let sides = if eye.z < projection.near {
        NEAR
    } else {
        match projection.project_inside(eye) {
            Ok(vertex) => return vertex,
            Err(wide) => sides::<S>(&wide),
        }
    };
    ScreenVertex {
        x: S::OUTSIDE,
        y: S::narrow(sides),
        z: D::FARTHEST,
    }
}

const NEAR: i32 = 16;

fn sides<S: ScreenPrecision>(vertex: &WideVertex) -> i32 {
    let (least, greatest) = (i64::from(S::MIN_UNITS), i64::from(S::MAX_UNITS));
    i32::from(vertex.x < least)
        | i32::from(vertex.x > greatest) << 1
        | i32::from(vertex.y < least) << 2
        | i32::from(vertex.y > greatest) << 3
}

#[inline(always)]
pub(super) fn is_outside<S: ScreenPrecision, D: DepthWidth>(vertex: &ScreenVertex<S, D>) -> bool {
    vertex.x == S::OUTSIDE
}

/// Whether all three are beyond the same side: nothing between them is visible.
fn all_outside_alike<S: ScreenPrecision, D: DepthWidth>(corners: &[ScreenVertex<S, D>; 3]) -> bool {
    corners
        .iter()
        .map(|corner| if is_outside(corner) { corner.y_units() } else { 0 })
        .fold(-1, |shared, sides| shared & sides)
        != 0
}

/// Whether the corners run clockwise on the screen, in exact arithmetic.
#[inline(always)]
fn is_front<S: ScreenPrecision, D: DepthWidth>(
    a: &ScreenVertex<S, D>,
    b: &ScreenVertex<S, D>,
    c: &ScreenVertex<S, D>,
) -> bool {
    let (x1, y1) = (
        b.x_units().wrapping_sub(a.x_units()),
        b.y_units().wrapping_sub(a.y_units()),
    );
    let (x2, y2) = (
        c.x_units().wrapping_sub(a.x_units()),
        c.y_units().wrapping_sub(a.y_units()),
    );
    if S::FRACTION_BITS <= 4 {
        // Differences are at most 32,752: two products fit.
        x1.wrapping_mul(y2) > x2.wrapping_mul(y1)
    } else {
        i64::from(x1) * i64::from(y2) > i64::from(x2) * i64::from(y1)
    }
}

/// A vertex that the guard band let through.
fn inside<S: ScreenPrecision, D: DepthWidth>(vertex: WideVertex) -> ScreenVertex<S, D> {
    ScreenVertex {
        x: S::narrow(vertex.x as i32),
        y: S::narrow(vertex.y as i32),
        z: D::from_units(vertex.z),
    }
}

impl Display for PrepareError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TableFull(error) => error.fmt(formatter),
            Self::ViewportOutOfDomain(error) => write!(formatter, "viewport: {error}"),
        }
    }
}

impl core::error::Error for PrepareError {}
