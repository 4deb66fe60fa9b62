//! Which vertices of a model are corners of faces that rows may reach, so that no light is computed at the others: in a closed
//! mesh about half of them are on its far side.

/// A bit for the vertices of a model that are corners of faces that rows may reach: of more than 1,024 vertices, those whose
/// numbers differ by a multiple of 1,024 share one.
#[derive(Debug)]
pub(super) struct SeenVertices([u32; Self::WORDS]);

impl SeenVertices {
    const WORDS: usize = 32;

    /// How many vertices [`of_chunk`](Self::of_chunk) tells at once.
    pub(super) const CHUNK: usize = 32;

    /// No face was marked yet.
    pub(super) const fn none() -> Self {
        Self([0; Self::WORDS])
    }

    /// Marks the corners of a face.
    #[inline(always)]
    pub(super) fn mark(&mut self, face: [u16; 3]) {
        for vertex in face {
            // The remainder tells the compiler that there is such a word.
            if let Some(word) = self.0.get_mut(usize::from(vertex) / 32 % Self::WORDS) {
                *word |= 1 << (vertex % 32);
            }
        }
    }

    /// Which vertices of a chunk of [`CHUNK`](Self::CHUNK) are corners of faces, or share the bit of one, the first in the lowest
    /// bit.
    #[inline(always)]
    pub(super) fn of_chunk(&self, chunk: usize) -> u32 {
        self.0.get(chunk % Self::WORDS).copied().unwrap_or(u32::MAX)
    }
}
