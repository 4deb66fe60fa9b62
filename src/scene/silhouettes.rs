//! Which edges of a frame's faces are silhouettes, and in which row they begin.
//!
//! An edge between two faces that are seen is inside a surface; one that has a face that is seen on one side only is a
//! silhouette. Faces with silhouettes lie in buckets by the first row that those touch, and move to the bucket of the next row
//! with each row that is drawn.
//!
//! Guarantees: the silhouettes of the faces that are seen are closed, so that a sum over their edges is a whole number wherever
//! none of them passes. That needs all faces that are seen, also those between the centres of pixels.
//!
//! Cost: a look at each face, and at its neighbours if it is seen, where drawing begins; then two links a row for each face
//! with silhouettes.

use crate::{
    geometry::{SubPixel, offset_from},
    mesh::FaceSet,
    scene::{
        Look, Model,
        culling::is_left_out,
        faces,
        frame::corners,
        lens::ScreenVertexOf,
        off_screen::is_outside,
        preparation::is_front,
        prepared_faces::PreparedFaces,
        silhouette_tables::{SilhouetteTables, SilhouettesOf},
    },
    shade::Shading,
    surface::{BandColor, Order},
    view::ScreenVertex,
    visible::{DepthRow, EdgeRow, FaceEdges, NONE, Silhouettes},
};

/// The row of silhouettes of a look.
type EdgeRowOf<'c, L> = EdgeRow<'c, <<L as Look>::Color as BandColor>::Word, <L as Look>::Depth>;

impl<'m, L: Look> PreparedFaces<'_, 'm, L> {
    /// Finds the silhouettes of a row that nothing was drawn to yet. `follows` where the last row that this was called for is
    /// the one above it.
    #[inline(never)]
    pub(super) fn begin_silhouettes<'c, O: Order>(
        &self,
        tables: &'c mut SilhouetteTables<'_, L>,
        row: &DepthRow<'_, L::Color, O, L::Depth>,
        follows: bool,
    ) -> EdgeRowOf<'c, L> {
        let faces = SilhouettesOf::<L>::faces(tables.faces);
        let rows = SilhouettesOf::<L>::faces(tables.rows);
        if !follows {
            self.find_silhouettes(faces);
            self.enter_silhouettes(faces, rows, row.y());
        }
        let columns = SilhouettesOf::<L>::columns(tables.columns);
        let mut edges = EdgeRow::new(columns, row.words().len(), row.start());
        let index = offset_from(self.viewport.top, row.y()) as usize;
        let mut node = rows.get(index).map_or(NONE, |row| row.next());
        while let Some(face) = faces.get(usize::from(node)).copied() {
            if self.add_edges(&mut edges, row, node, face) {
                if let (Some(head), Some(face)) = (rows.get_mut(index + 1), faces.get_mut(usize::from(node))) {
                    *face = face.with_next(head.next());
                    *head = head.with_next(node);
                }
            }
            node = face.next();
        }
        edges
    }

    /// Adds the silhouettes of a face to a row. Returns whether one of them goes on below it.
    #[inline(always)]
    fn add_edges<O: Order>(
        &self,
        edges: &mut EdgeRowOf<'_, L>,
        row: &DepthRow<'_, L::Color, O, L::Depth>,
        node: u16,
        face: FaceEdges,
    ) -> bool {
        let Some(mut corners) = self.corners_in_mesh(node) else {
            return false;
        };
        let (mut goes_on, mut left) = (false, face.edges());
        while left.has_any() {
            let [from, to, _] = corners;
            if let (true, is_drawn) = left.first() {
                goes_on |= edges.add::<L::Precision>(row.words(), node, [from, to], face.is_reversed(), is_drawn);
            }
            corners.rotate_left(1);
            left = left.others();
        }
        goes_on
    }

    /// The corners of a whole face in the order of its mesh.
    #[inline]
    pub(super) fn corners_in_mesh(&self, node: u16) -> Option<[&ScreenVertexOf<L>; 3]> {
        if let Some(face) = self.first_faces.get(usize::from(node)) {
            return corners(self.vertices, face);
        }
        let (model, first_vertex, face) = faces::find(self.models, node)?;
        corners(self.vertices.get(first_vertex..)?, model.mesh().faces().get(face)?)
    }

    /// Finds out which edges of all faces are silhouettes.
    #[cold]
    #[inline(never)]
    fn find_silhouettes(&self, all: &mut [FaceEdges]) {
        let (mut rest, mut first_vertex) = (all, 0);
        for model in self.models {
            let mesh = model.mesh();
            let count = mesh.faces().len().min(rest.len());
            let (faces, others) = rest.split_at_mut(count);
            let vertices = self.vertices.get(first_vertex..).unwrap_or_default();
            if is_left_out::<L>(self.vertices, first_vertex) || L::Shading::is_translucent(model.skin()) {
                faces.fill(FaceEdges::seen(false, false));
            } else {
                see_faces::<L>(model, vertices, faces);
                see_neighbours(mesh, faces);
            }
            first_vertex += mesh.vertices().len();
            rest = others;
        }
        // What is behind the last face is none.
        rest.fill(FaceEdges::seen(false, false));
    }

    /// Puts all faces with silhouettes that touch a row or one below it into the buckets of the first such row.
    #[cold]
    #[inline(never)]
    fn enter_silhouettes(&self, faces: &mut [FaceEdges], rows: &mut [FaceEdges], row: i32) {
        rows.fill(FaceEdges::seen(false, false).with_next(NONE));
        let one = 1 << <L::Precision as SubPixel>::FRACTION_BITS;
        // The row that a coordinate lies in, and that which ends at it or around it.
        let row_of = |units: i32| (units + one / 2) >> <L::Precision as SubPixel>::FRACTION_BITS;
        for (node, face) in (0..).zip(faces) {
            if !face.has_any() {
                continue;
            }
            let Some(corners) = self.corners_in_mesh(node) else {
                continue;
            };
            let [a, b, c] = corners.map(ScreenVertex::y_units);
            let first = row_of(a.min(b).min(c)).max(row);
            if row_of(a.max(b).max(c)) < row {
                continue;
            }
            let index = offset_from(self.viewport.top, first) as usize;
            if let Some(head) = rows.get_mut(index) {
                *face = face.with_next(head.next());
                *head = head.with_next(node);
            }
        }
    }
}

/// Finds out which faces of a model are seen, and from which side.
fn see_faces<L: Look>(model: &Model<'_, L::Shading>, vertices: &[ScreenVertexOf<L>], faces: &mut [FaceEdges]) {
    let is_mirrored = model.is_mirrored();
    for (face, indices) in faces.iter_mut().zip(model.mesh().faces()) {
        *face = FaceEdges::seen(false, false);
        let Some(corners) = corners(vertices, indices) else {
            continue;
        };
        if L::CLIPS && corners.into_iter().any(is_outside) {
            *face = FaceEdges::CUT;
            continue;
        }
        let [a, b, c] = corners.map(ScreenVertex::position);
        let is_clockwise = is_front::<L::Precision>(a, b, c);
        let is_counterclockwise = || !is_clockwise && is_front::<L::Precision>(a, c, b);
        *face = if L::DRAWS_BACKS {
            FaceEdges::seen(is_clockwise, is_counterclockwise())
        } else if is_mirrored {
            FaceEdges::seen(false, is_counterclockwise())
        } else {
            FaceEdges::seen(is_clockwise, false)
        };
    }
}

/// Finds out which edges of the faces of a mesh that are seen are silhouettes.
fn see_neighbours(mesh: &FaceSet<'_>, faces: &mut [FaceEdges]) {
    for index in 0..faces.len() {
        let Some(mut face) = faces.get(index).copied().filter(|face| face.is_seen()) else {
            continue;
        };
        let neighbours = mesh.neighbours().get(index).copied().unwrap_or([NONE; 3]);
        for (number, neighbour) in (0..).zip(neighbours) {
            let neighbour = faces.get(usize::from(neighbour)).copied();
            face = face.with_neighbour(number, neighbour.unwrap_or(FaceEdges::seen(false, false)));
        }
        if let Some(entry) = faces.get_mut(index) {
            *entry = face;
        }
    }
}
