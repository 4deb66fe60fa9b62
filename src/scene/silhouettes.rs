//! Which edges of a frame's faces are silhouettes, and in which row they begin.
//!
//! An edge between two faces that are seen is inside a surface; one that has a face that is seen on one side only is a
//! silhouette. Faces with silhouettes lie in buckets by the first row that those touch. In the row in which an edge begins it
//! is set up and becomes active: from there on it goes on from row to row by itself. A face with other edges moves on to the
//! bucket of the row in which the next of them begins, or to that of the next row where one found no room among the active ones.
//!
//! Guarantees: the silhouettes of the faces that are seen are closed, so that a sum over their edges is a whole number wherever
//! none of them passes. That needs all faces that are seen, also those between the centres of pixels.
//!
//! Cost: a look at each face, and at its neighbours if it is seen, where drawing begins; a division for each edge where it
//! begins, and in each row with an edge for which there is no room.

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
        silhouette_tables::{EdgeTables, SilhouettesOf},
    },
    shade::Shading,
    surface::{BandColor, Order},
    view::ScreenVertex,
    visible::{ActiveEdge, DepthRow, EdgeRow, FaceEdges, NONE, Silhouettes},
};

/// The row of silhouettes of a look.
type EdgeRowOf<'c, L> = EdgeRow<'c, <<L as Look>::Color as BandColor>::Word, <L as Look>::Depth>;

impl<'m, L: Look> PreparedFaces<'_, 'm, L> {
    /// Finds the silhouettes of a row that nothing was drawn to yet. `follows` where the last row that this was called for is
    /// the one above it.
    #[inline(never)]
    pub(super) fn begin_silhouettes<'c, O: Order>(
        &self,
        tables: &'c mut EdgeTables<'_, L>,
        row: &DepthRow<'_, L::Color, O, L::Depth>,
        follows: bool,
    ) -> EdgeRowOf<'c, L> {
        let faces = SilhouettesOf::<L>::faces(tables.faces);
        let rows = SilhouettesOf::<L>::faces(tables.rows);
        let active = SilhouettesOf::<L>::active(tables.active);
        let columns = SilhouettesOf::<L>::columns(tables.columns);
        let mut edges = EdgeRow::new(columns, row.words().len(), row.start());
        self.add_silhouettes_of_row(&mut edges, row, active, [faces, rows], follows);
        edges
    }

    /// Adds the silhouettes of a row to its columns.
    #[inline(always)]
    fn add_silhouettes_of_row<O: Order>(
        &self,
        edges: &mut EdgeRowOf<'_, L>,
        row: &DepthRow<'_, L::Color, O, L::Depth>,
        active: &mut [ActiveEdge<L::Depth>],
        [faces, rows]: [&mut [FaceEdges]; 2],
        follows: bool,
    ) {
        if !follows {
            self.find_silhouettes(faces, rows, row.y());
        }
        let index = offset_from(self.viewport.top, row.y()) as usize;
        let Some((mut node, mut used)) = rows.get(index).map(|row| (row.next(), row.active())) else {
            return;
        };
        if rows.first().is_some_and(|first| first.is_cut()) {
            edges.leave_out_single_edges();
        }
        let [_, bottom] = edges.sides::<L::Precision>();
        let fraction_bits = <L::Precision as SubPixel>::FRACTION_BITS;
        while let Some(face) = faces.get(usize::from(node)).copied() {
            let begun = self.begin_edges(edges, row, (node, face), (active, &mut used), follows);
            if let Some((face, units)) = begun {
                // At the lower side of the row, or below it.
                let next = index + ((units - bottom) >> fraction_bits) as usize + 1;
                if let (Some(head), Some(entry)) = (rows.get_mut(next), faces.get_mut(usize::from(node))) {
                    *entry = face.with_next(head.next());
                    *head = head.with_next(node);
                }
            }
            node = face.next();
        }
        if let (1.., Some(active)) = (used, active.get_mut(..used)) {
            let used = edges.add_active::<L::Precision>(row.words(), active, |node| self.corners_in_mesh(node));
            if let Some(head) = rows.get_mut(index + 1) {
                *head = head.with_active(used);
            }
        }
    }

    /// Makes the edges of a face active that begin in a row, also those that began above it where rows do not follow. Where
    /// there is no room for them they are added to the row. Returns the face if some are left, and the y at which the first of
    /// them begins or goes on.
    #[inline(always)]
    fn begin_edges<O: Order>(
        &self,
        edges: &mut EdgeRowOf<'_, L>,
        row: &DepthRow<'_, L::Color, O, L::Depth>,
        (node, mut face): (u16, FaceEdges),
        (active, used): (&mut [ActiveEdge<L::Depth>], &mut usize),
        follows: bool,
    ) -> Option<(FaceEdges, i32)> {
        let mut corners = self.corners_in_mesh(node)?;
        let [top, bottom] = edges.sides::<L::Precision>();
        let (mut goes_on, mut left, mut number) = (i32::MAX, face.edges(), 0);
        while left.has_any() {
            let [from, to, _] = corners;
            let (counts, is_drawn) = left.first();
            let [first, last] = [from.y_units().min(to.y_units()), from.y_units().max(to.y_units())];
            let begins = first >= top || !follows || left.is_left_out();
            // A level edge on the boundary of two rows passes through no pixel.
            if counts && first >= bottom {
                goes_on = goes_on.min(first);
            } else if counts && begins && last > top {
                let sides = [face.is_reversed(), is_drawn];
                let edge = ActiveEdge::new::<L::Precision>([from, to], (node, number), sides, edges.left());
                let entry = active.get_mut(*used);
                let is_left_out = entry.is_none();
                if let Some(entry) = entry {
                    *entry = edge;
                    *used += 1;
                } else {
                    edges.add_once::<L::Precision>(row.words(), &edge, |node| self.corners_in_mesh(node));
                    if last > bottom {
                        goes_on = bottom;
                    }
                }
                face = face.with_left_out(number, is_left_out);
            }
            corners.rotate_left(1);
            left = left.others();
            number += 1;
        }
        (goes_on < i32::MAX).then_some((face, goes_on))
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

    /// Finds out which edges of all faces are silhouettes, and puts the faces with some that touch a row or one below it into the
    /// buckets of the first such row.
    #[cold]
    #[inline(never)]
    fn find_silhouettes(&self, all: &mut [FaceEdges], rows: &mut [FaceEdges], row: i32) {
        rows.fill(FaceEdges::seen(false, false).with_next(NONE));
        let (mut rest, mut first_vertex, mut first_node) = (all, 0, 0);
        for model in self.models {
            let mesh = model.mesh();
            let count = mesh.faces().len().min(rest.len());
            let (faces, others) = rest.split_at_mut(count);
            let vertices = self.vertices.get(first_vertex..).unwrap_or_default();
            if is_left_out::<L>(self.vertices, first_vertex) || L::Shading::is_translucent(model.skin()) {
                faces.fill(FaceEdges::seen(false, false));
            } else {
                let next = self.next.get(first_node..).unwrap_or_default();
                see_faces::<L>(model, vertices, (first_node, next), faces, rows.first_mut());
                self.enter_silhouettes(mesh, vertices, (first_node, faces), (rows, row));
            }
            first_vertex += mesh.vertices().len();
            first_node += count;
            rest = others;
        }
        // What is behind the last face is none.
        rest.fill(FaceEdges::seen(false, false));
    }

    /// Finds out which edges of the faces of a mesh that are seen are silhouettes, and enters the faces with some.
    #[inline(always)]
    fn enter_silhouettes(
        &self,
        mesh: &FaceSet<'_>,
        vertices: &[ScreenVertexOf<L>],
        (first_node, faces): (usize, &mut [FaceEdges]),
        (rows, row): (&mut [FaceEdges], i32),
    ) {
        for (index, indices) in mesh.faces().iter().enumerate() {
            let Some(mut face) = faces.get(index).copied().filter(|face| face.is_seen()) else {
                continue;
            };
            let neighbours = mesh.neighbours().get(index).copied().unwrap_or([NONE; 3]);
            for (number, neighbour) in (0..).zip(neighbours) {
                let neighbour = faces.get(usize::from(neighbour)).copied();
                face = face.with_neighbour(number, neighbour.unwrap_or(FaceEdges::seen(false, false)));
            }
            if face.has_any() {
                if let Some(head) = corners(vertices, indices).and_then(|corners| self.first_row(corners, rows, row)) {
                    face = face.with_next(head.next());
                    *head = head.with_next((first_node + index) as u16);
                }
            }
            if let Some(entry) = faces.get_mut(index) {
                *entry = face;
            }
        }
    }

    /// The first row from a row on that a face touches, `None` where it touches none.
    #[inline(always)]
    fn first_row<'r>(
        &self,
        corners: [&ScreenVertexOf<L>; 3],
        rows: &'r mut [FaceEdges],
        row: i32,
    ) -> Option<&'r mut FaceEdges> {
        let one = 1 << <L::Precision as SubPixel>::FRACTION_BITS;
        // The row that a coordinate lies in, and that which ends at it or around it.
        let row_of = |units: i32| (units + one / 2) >> <L::Precision as SubPixel>::FRACTION_BITS;
        let [a, b, c] = corners.map(ScreenVertex::y_units);
        let first = row_of(a.min(b).min(c)).max(row);
        if row_of(a.max(b).max(c)) < row {
            return None;
        }
        rows.get_mut(offset_from(self.viewport.top, first) as usize)
    }
}

/// Finds out which faces of a model are seen, and from which side. `next` has for each of them the next node of its row, from the
/// first node on. If one is cut, the first row says so.
fn see_faces<L: Look>(
    model: &Model<'_, L::Shading>,
    vertices: &[ScreenVertexOf<L>],
    (first_node, next): (usize, &[u16]),
    faces: &mut [FaceEdges],
    mut first_row: Option<&mut FaceEdges>,
) {
    let is_mirrored = model.is_mirrored();
    for (index, ((face, next), indices)) in faces.iter_mut().zip(next).zip(model.mesh().faces()).enumerate() {
        *face = FaceEdges::seen(false, false);
        // Faces that are not seen were told from the others when the frame was prepared.
        if usize::from(*next) == first_node + index {
            continue;
        }
        let Some(corners) = corners(vertices, indices) else {
            continue;
        };
        if L::CLIPS && corners.into_iter().any(is_outside) {
            *face = FaceEdges::CUT;
            if let Some(row) = &mut first_row {
                **row = row.with_cut_face();
            }
            continue;
        }
        let is_reversed = if L::DRAWS_BACKS {
            let [a, b, c] = corners.map(ScreenVertex::position);
            !is_front::<L::Precision>(a, b, c)
        } else {
            is_mirrored
        };
        *face = FaceEdges::seen(!is_reversed, is_reversed);
    }
}
