//! The memory that antialiased silhouettes take, what is kept of columns, faces and rows, and that of a method of visibility:
//! nothing in looks without.

use crate::{scene::Look, visible::Silhouettes};

/// How a look draws silhouettes.
pub(super) type SilhouettesOf<L> = <L as Look>::Silhouettes;

/// What a look keeps of a column of the row that is drawn: the silhouettes that pass through its pixel, nothing in looks
/// without.
pub(super) type ColumnOf<L> = <SilhouettesOf<L> as Silhouettes<<L as Look>::Color>>::Column<<L as Look>::Depth>;

/// What a look keeps of a face: which of its edges are silhouettes, and the next face with some in the same row. Of a row the
/// first such face, and how many edges are active. Nothing in looks without.
pub(super) type FaceEdgesOf<L> = <SilhouettesOf<L> as Silhouettes<<L as Look>::Color>>::FaceEdges;

/// The silhouette edges that cross a row, as a look keeps them; nothing in looks without.
type ActiveEdgesOf<L> = <SilhouettesOf<L> as Silhouettes<<L as Look>::Color>>::ActiveEdges<<L as Look>::Depth>;

/// The tables of one row, and the memory of the method of visibility (`V`), in looks that have more than a depth row: the silhouette
/// edges that cross the row (`A`), and an entry for each of its pixels (`C`, an array or a slice).
// One reference to all of them, because in looks with none of them it is carried along, too.
#[derive(Debug)]
pub(super) struct RowTables<A, V, C: ?Sized> {
    /// The edges that go on into the row that comes next, before others.
    pub(super) active: A,
    pub(super) visibility: V,
    pub(super) columns: C,
}

/// The [`RowTables`] of a look, with columns `C` (an array or a slice); of no size in looks by the depth row without antialiased
/// silhouettes.
pub(super) type RowTablesOf<L, C> = RowTables<ActiveEdgesOf<L>, <L as Look>::Visibility, C>;

/// The memory that silhouettes and a method of visibility take: none in looks without.
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

    /// The method of visibility, and the tables of silhouettes.
    #[inline(always)]
    pub(super) const fn parts(&mut self) -> (&mut L::Visibility, EdgeTables<'_, L>) {
        let RowTables {
            active,
            visibility,
            columns,
        } = &mut *self.row;
        let edges = EdgeTables {
            active,
            columns,
            faces: self.faces,
            rows: self.rows,
        };
        (visibility, edges)
    }
}

/// The tables of silhouettes alone.
#[derive(Debug)]
pub(super) struct EdgeTables<'t, L: Look> {
    pub(super) active: &'t mut ActiveEdgesOf<L>,
    pub(super) columns: &'t mut [ColumnOf<L>],
    pub(super) faces: &'t mut [FaceEdgesOf<L>],
    pub(super) rows: &'t mut [FaceEdgesOf<L>],
}

impl<L: Look> EdgeTables<'_, L> {
    /// The tables of silhouettes alone, borrowed once more for a shorter time.
    pub(super) const fn reborrow(&mut self) -> EdgeTables<'_, L> {
        EdgeTables {
            active: self.active,
            columns: self.columns,
            faces: self.faces,
            rows: self.rows,
        }
    }
}
