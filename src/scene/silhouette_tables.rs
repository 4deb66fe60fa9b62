//! The memory that antialiased silhouettes take: what is kept of columns, faces and rows, nothing in looks without.

use crate::{scene::Look, visible::Silhouettes};

/// How a look draws silhouettes.
pub(super) type SilhouettesOf<L> = <L as Look>::Silhouettes;

/// What a look keeps of a column.
pub(super) type ColumnOf<L> = <SilhouettesOf<L> as Silhouettes<<L as Look>::Color>>::Column<<L as Look>::Depth>;

/// What a look keeps of a face, or of the first one in a row.
pub(super) type FaceEdgesOf<L> = <SilhouettesOf<L> as Silhouettes<<L as Look>::Color>>::FaceEdges;

/// The memory that silhouettes take: none in looks without.
#[derive(Debug)]
pub(super) struct SilhouetteTables<'m, L: Look> {
    pub(super) columns: &'m mut [ColumnOf<L>],
    /// For each face its edges, and the next face of its row.
    pub(super) faces: &'m mut [FaceEdgesOf<L>],
    /// For each row the first face.
    pub(super) rows: &'m mut [FaceEdgesOf<L>],
}

impl<L: Look> SilhouetteTables<'_, L> {
    /// The same tables for a shorter time.
    pub(super) const fn reborrow(&mut self) -> SilhouetteTables<'_, L> {
        SilhouetteTables {
            columns: self.columns,
            faces: self.faces,
            rows: self.rows,
        }
    }
}
