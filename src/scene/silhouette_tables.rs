//! The memory that antialiased silhouettes take: what is kept of columns, faces and rows, nothing in looks without.

use crate::{scene::Look, visible::Silhouettes};

/// How a look draws silhouettes.
pub(super) type SilhouettesOf<L> = <L as Look>::Silhouettes;

/// What a look keeps of a column of the row that is drawn: the silhouettes that pass through its pixel, nothing in looks
/// without.
pub(super) type ColumnOf<L> = <SilhouettesOf<L> as Silhouettes<<L as Look>::Color>>::Column<<L as Look>::Depth>;

/// What a look keeps of a face: which of its edges are silhouettes, and the next face with some in the same row. Of a row the
/// first such face, and how many edges are active. Nothing in looks without.
pub(super) type FaceEdgesOf<L> = <SilhouettesOf<L> as Silhouettes<<L as Look>::Color>>::FaceEdges;

/// The tables of one row in looks with antialiased silhouettes: the silhouette edges that cross the row (`A`), and an entry for
/// each of its pixels (`C`, an array or a slice).
// One reference to both, because in looks without silhouettes it is carried along, too.
#[derive(Debug)]
pub(super) struct RowTables<A, C: ?Sized> {
    /// The edges that go on into the row that comes next, before others.
    pub(super) active: A,
    pub(super) columns: C,
}

/// The [`RowTables`] of a look, with columns `C` (an array or a slice); of no size in looks without antialiased silhouettes.
pub(super) type RowTablesOf<L, C> =
    RowTables<<SilhouettesOf<L> as Silhouettes<<L as Look>::Color>>::ActiveEdges<<L as Look>::Depth>, C>;

/// The memory that silhouettes take: none in looks without.
#[derive(Debug)]
pub(super) struct SilhouetteTables<'m, L: Look> {
    pub(super) row: &'m mut RowTablesOf<L, [ColumnOf<L>]>,
    /// For each face its edges, and the next face of its row.
    pub(super) faces: &'m mut [FaceEdgesOf<L>],
    /// For each row the first face.
    pub(super) rows: &'m mut [FaceEdgesOf<L>],
}

impl<L: Look> SilhouetteTables<'_, L> {
    /// The tables of silhouettes, borrowed once more for a shorter time.
    pub(super) const fn reborrow(&mut self) -> SilhouetteTables<'_, L> {
        SilhouetteTables {
            row: self.row,
            faces: self.faces,
            rows: self.rows,
        }
    }
}
