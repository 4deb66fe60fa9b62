//! The storage of a scene.

use crate::{
    scene::Look,
    surface::BandColor,
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{ActiveFaces, NONE},
};

/// The bit that marks a node as a clipped fragment of a face; the other bits are then its index among the vertices.
pub(super) const FRAGMENT: u16 = 0x8000;

/// Vertices that a fragment of a cut face takes: a header and three corners.
pub(super) const FRAGMENT_VERTICES: usize = 4;

/// The most vertices and the most faces that a table can index.
pub(super) const MOST_NODES: usize = FRAGMENT as usize - 1;

/// Storage for a scene, to be prepared once a frame.
///
/// - `L`: what pictures are made of; a colour, such as `Rgb565`, or another [`Look`].
/// - `VERTICES`: vertices of all models, and where faces are cut ([`Look::CLIPS`]) 4 for each fragment of a face that the near
///   plane or the guard band cuts (a cut face has 1 to 6 fragments). At most 32,767.
/// - `FACES`: faces of all models. At most 32,767.
/// - `ACTIVE`: slots for faces that cross the same row, at least 1 and at most 65,535. A row with more faces is drawn in passes
///   ([`Look::DRAWS_IN_PASSES`]): the picture is the same, and takes longer.
///   [`Prepared::active_needed`](crate::scene::Prepared::active_needed) says with how many each row takes one pass.
/// - `ROWS`: rows of the viewport.
///
/// RAM for a colour as the look: 6 bytes a vertex, 2 a face, 52 an active face, 4 a row. All zero bits when new, so that a
/// `static` lies in `.bss`.
#[derive(Debug)]
pub struct Frame<L: Look, const VERTICES: usize, const FACES: usize, const ACTIVE: usize, const ROWS: usize> {
    pub(super) tables: Tables<L, VERTICES, FACES, ROWS>,
    pub(super) active: ActiveFaces<L::Precision, <L::Color as BandColor>::Word, ACTIVE>,
}

/// The tables of a frame, which preparing fills in and drawing reads.
#[derive(Debug)]
pub(super) struct Tables<L: Look, const VERTICES: usize, const FACES: usize, const ROWS: usize> {
    /// The vertices of the models, then the fragments of cut faces. The header of a fragment holds its index in the order of
    /// faces in `x`, and the next node of its row in `y`.
    pub(super) vertices: [ScreenVertex<L::Precision, L::Depth>; VERTICES],
    /// For each face the next node of its row.
    pub(super) next: [u16; FACES],
    pub(super) rows: [RowStart; ROWS],
}

/// A bucket: which faces begin and end in a row of the viewport. The lower half is the bucket head, the first of the
/// nodes that begin in the row; the upper half is how many more faces cross the row than the row before. Both in one
/// integer, because both change at once.
#[derive(Debug, Copy, Clone)]
pub(super) struct RowStart(u32);

impl RowStart {
    const NOTHING: Self = Self(NONE as u32);
    /// One face in the upper half. Fewer than 32,768 nodes fit the tables, so their count fits.
    const FACE: u32 = 1 << 16;

    #[inline]
    pub(super) fn first(self) -> u16 {
        self.0 as u16
    }

    #[inline]
    pub(super) fn change(self) -> i32 {
        self.0 as i32 >> 16
    }

    /// Makes a node the bucket head, and returns the previous head.
    #[inline]
    pub(super) fn begin(&mut self, node: u16) -> u16 {
        let Self(before) = *self;
        // The count in the upper half is signed, and so modulo 2^16.
        self.0 = (before.wrapping_add(Self::FACE) & 0xffff_0000) | u32::from(node);
        before as u16
    }

    /// Counts a node that ends in the row above.
    #[inline]
    pub(super) fn end(&mut self) {
        // Where more nodes end than begin, the count is negative: modulo 2^16.
        self.0 = self.0.wrapping_sub(Self::FACE);
    }
}

impl<L: Look, const VERTICES: usize, const FACES: usize, const ACTIVE: usize, const ROWS: usize>
    Frame<L, VERTICES, FACES, ACTIVE, ROWS>
{
    /// Storage for frames, in which nothing is prepared yet.
    pub const fn new() -> Self {
        Self {
            tables: Tables {
                vertices: [ScreenVertex {
                    x: L::Precision::ZERO,
                    y: L::Precision::ZERO,
                    z: L::Depth::FARTHEST,
                }; VERTICES],
                next: [0; FACES],
                rows: [RowStart(0); ROWS],
            },
            active: ActiveFaces::EMPTY,
        }
    }
}

impl<L: Look, const VERTICES: usize, const FACES: usize, const ACTIVE: usize, const ROWS: usize> Default
    for Frame<L, VERTICES, FACES, ACTIVE, ROWS>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<L: Look, const VERTICES: usize, const FACES: usize, const ROWS: usize> Tables<L, VERTICES, FACES, ROWS> {
    pub(super) fn clear_rows(&mut self) {
        self.rows.fill(RowStart::NOTHING);
    }

    #[inline]
    pub(super) fn next(&self, node: u16) -> u16 {
        // A fragment has a greater number than any face.
        match self.next.get(usize::from(node)) {
            Some(next) => *next,
            None => self.next_after_fragment(node),
        }
    }

    #[cold]
    #[inline(never)]
    fn next_after_fragment(&self, node: u16) -> u16 {
        if is_whole::<L>(node) {
            return NONE;
        }
        self.header(node).map_or(NONE, |header| header.y_units() as u16)
    }

    /// Index of a node in the order of models and faces; after all faces for [`NONE`].
    #[inline]
    pub(super) fn order(&self, node: u16) -> u16 {
        if is_whole::<L>(node) {
            node
        } else {
            self.order_of_fragment(node)
        }
    }

    #[cold]
    #[inline(never)]
    fn order_of_fragment(&self, node: u16) -> u16 {
        self.header(node).map_or(NONE, |header| header.x_units() as u16)
    }

    /// The corners of a fragment.
    #[cold]
    #[inline(never)]
    pub(super) fn fragment(&self, node: u16) -> Option<[&ScreenVertex<L::Precision, L::Depth>; 3]> {
        let start = usize::from(node & !FRAGMENT) + 1;
        self.vertices
            .get(start..)?
            .first_chunk()
            .map(|corners| corners.each_ref())
    }

    fn header(&self, node: u16) -> Option<&ScreenVertex<L::Precision, L::Depth>> {
        self.vertices.get(usize::from(node & !FRAGMENT))
    }
}

#[cfg(feature = "defmt")]
impl<L: Look, const VERTICES: usize, const FACES: usize, const ACTIVE: usize, const ROWS: usize> defmt::Format
    for Frame<L, VERTICES, FACES, ACTIVE, ROWS>
{
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Frame for {} vertices, {} faces, {} active faces, {} rows, cuts {}",
            VERTICES,
            FACES,
            ACTIVE,
            ROWS,
            L::CLIPS
        );
    }
}

/// Whether a node stands for a face as the model has it, not for a fragment of one.
#[inline]
pub(super) fn is_whole<L: Look>(node: u16) -> bool {
    !L::CLIPS || node & FRAGMENT == 0
}

/// The corners of a face among the vertices of its model.
#[inline]
pub(super) fn corners<'v, S: ScreenPrecision, D: DepthWidth>(
    vertices: &'v [ScreenVertex<S, D>],
    face: &[u16; 3],
) -> Option<[&'v ScreenVertex<S, D>; 3]> {
    let [a, b, c] = *face;
    let vertex = |index: u16| vertices.get(usize::from(index));
    Some([vertex(a)?, vertex(b)?, vertex(c)?])
}
