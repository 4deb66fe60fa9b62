//! The memory of a scene as a frame uses it: slices, whatever the capacities.

use core::num::Wrapping;

use crate::{
    scene::{Look, silhouette_tables::SilhouetteTables, stored_attributes::StoredAttributes},
    shade::Shading,
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{ActiveList, NONE},
};

/// The bit that marks a node as a clipped fragment of a face; the other bits are then its index among the vertices.
pub(super) const FRAGMENT: u16 = 0x8000;

/// Vertices that a fragment of a cut face takes: a header and three corners.
pub(super) const FRAGMENT_VERTICES: usize = 4;

/// The most vertices and the most faces that a table can index.
pub(super) const MOST_NODES: usize = FRAGMENT as usize - 1;

/// The memory of a scene of any size: a view of a [`Memory`](crate::scene::Memory), for functions that take every scene of
/// a [`Look`]. A function with a `Frame` is in flash once, whatever the capacities.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     geometry::InputError,
///     scene::{Camera, Frame, Look, Memory, Model},
/// };
///
/// /// How many faces of the models are on the screen, whether they face the viewer or not.
/// fn faces_on_screen<L: Look>(
///     frame: &mut Frame<'_, L>,
///     camera: &Camera,
///     models: &[Model<'_, L::Shading>],
/// ) -> Result<usize, InputError> {
///     Ok(frame.prepare(camera, models)?.faces().count())
/// }
///
/// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 48)), I16F16::from_num(128))?;
/// let mut memory = Memory::<Rgb565, 0, 0, 64, 48>::new();
/// assert_eq!(faces_on_screen(&mut memory.frame(), &camera, &[]), Ok(0));
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug)]
pub struct Frame<'m, L: Look> {
    pub(super) tables: Tables<'m, L>,
    /// The depth row.
    pub(super) depths: &'m mut [L::Depth],
    pub(super) silhouettes: SilhouetteTables<'m, L>,
    pub(super) active: &'m mut ActiveListOf<L>,
}

/// The active list of a look.
pub(super) type ActiveListOf<L> = ActiveList<<L as Look>::Precision, <L as Look>::Shading>;

/// What a vertex of a look has beside its position.
pub(super) type AttributesOf<L> = <<L as Look>::Shading as Shading>::Attributes;

/// What is kept of the attributes of a vertex of a look.
pub(super) type StoredOf<L> = <<L as Look>::StoredAttributes as StoredAttributes>::Of<AttributesOf<L>>;

/// The tables of a frame, which preparing fills in and drawing reads.
#[derive(Debug)]
pub(super) struct Tables<'m, L: Look> {
    /// The vertices of the models, then the fragments of cut faces. The header of a fragment holds its index in the order of
    /// faces in `x`, and the next node of its row in `y`.
    pub(super) vertices: &'m mut [ScreenVertex<L::Precision, L::Depth>],
    /// What is kept of what each of the vertices has beside its position.
    pub(super) attributes: &'m mut [StoredOf<L>],
    /// For each face the next node of its row; in looks with silhouettes by area a face that is not seen has itself.
    pub(super) next: &'m mut [u16],
    pub(super) rows: &'m mut [RowStart],
}

/// A bucket: which faces begin and end in a row of the viewport. The lower half is the bucket head, the first of the
/// nodes that begin in the row; the upper half is how many more faces cross the row than the row before, modulo 2^16. Both
/// in one integer, because both change at once.
///
/// At most 32,767 whole faces and 8,191 fragments, of four vertices each, fit the tables: how many cross a row is below 2^16,
/// though it may change by more than a signed number of 16 bits holds.
#[derive(Debug, Copy, Clone)]
pub(super) struct RowStart(u32);

impl RowStart {
    pub(super) const ZERO: Self = Self(0);
    const NOTHING: Self = Self(NONE as u32);
    /// One face in the upper half.
    const FACE: u32 = 1 << 16;

    #[inline]
    pub(super) fn first(self) -> u16 {
        self.0 as u16
    }

    /// How many more faces cross the row than the row before.
    #[inline]
    pub(super) fn change(self) -> Wrapping<u16> {
        Wrapping((self.0 >> 16) as u16)
    }

    /// Makes a node the bucket head, and returns the previous head.
    #[inline]
    pub(super) fn begin(&mut self, node: u16) -> u16 {
        let Self(before) = *self;
        self.0 = (before.wrapping_add(Self::FACE) & 0xffff_0000) | u32::from(node);
        before as u16
    }

    /// The most faces that cross one of the rows of a viewport.
    pub(super) fn most_active(rows: &[Self]) -> usize {
        let mut active = Wrapping(0);
        let mut most = 0;
        for row in rows {
            // As a signed number: where a change does not fit one, a count is negative and so a huge number, or it is too great.
            active += Wrapping((row.0 as i32 >> 16) as u32);
            most = most.max(active.0);
        }
        match u16::try_from(most) {
            Ok(most) => most.into(),
            Err(_) => Self::most_active_of_many(rows),
        }
    }

    /// The most faces that cross one of the rows of a viewport, of which more than 32,767 may begin in one row.
    #[cold]
    #[inline(never)]
    fn most_active_of_many(rows: &[Self]) -> usize {
        let mut active = Wrapping(0);
        let counts = rows.iter().map(|row| {
            active += row.change();
            active.0
        });
        counts.max().unwrap_or(0).into()
    }

    /// Counts a node that ends in the row above.
    #[inline]
    pub(super) fn end(&mut self) {
        // More nodes may end than begin.
        self.0 = self.0.wrapping_sub(Self::FACE);
    }
}

impl<L: Look> Frame<'_, L> {
    /// The memory of the scene, borrowed once more for a shorter time.
    pub(super) const fn reborrow(&mut self) -> Frame<'_, L> {
        Frame {
            tables: self.tables.reborrow(),
            depths: self.depths,
            silhouettes: self.silhouettes.reborrow(),
            active: self.active,
        }
    }
}

impl<L: Look> Tables<'_, L> {
    /// The tables of the frame, borrowed once more for a shorter time.
    pub(super) const fn reborrow(&mut self) -> Tables<'_, L> {
        Tables {
            vertices: self.vertices,
            attributes: self.attributes,
            next: self.next,
            rows: self.rows,
        }
    }

    pub(super) fn clear_rows(&mut self) {
        self.rows.fill(RowStart::NOTHING);
    }
}

#[cfg(feature = "defmt")]
impl<L: Look> defmt::Format for Frame<'_, L> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Frame for {} vertices, {} faces, {} x {} pixels, {} active faces, cuts {}",
            self.tables.vertices.len(),
            self.tables.next.len(),
            self.depths.len(),
            self.tables.rows.len(),
            self.active.capacity(),
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
