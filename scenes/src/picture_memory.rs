//! Memory of a scene that is a [`Picture`], and such a picture as a frame of a scene.

use embedded_graphics::{geometry::Dimensions, primitives::Rectangle};
use zrow::{
    band::{Band, BandColor, Order},
    draw::{AntialiasingMemory, Picture, PictureSlot},
};

use crate::{PictureCapacities, Prepared};

/// All memory of a picture of antialiased shapes but for a row of colours and the rectangles of what changes.
///
/// - `ITEMS`: items of the picture;
/// - `WORDS`: words of its pool;
/// - `ROWS`: buckets, one for each row of the picture;
/// - `CELLS`, `SEGMENTS`, `EDGES`: as of [`AntialiasingMemory`].
#[derive(Debug)]
pub(crate) struct PictureMemory<
    C: BandColor,
    const ITEMS: usize,
    const WORDS: usize,
    const ROWS: usize,
    const CELLS: usize,
    const SEGMENTS: usize,
    const EDGES: usize,
> {
    slots: [PictureSlot<'static, C>; ITEMS],
    pool: [u32; WORDS],
    buckets: [u16; ROWS],
    antialiasing: AntialiasingMemory<CELLS, SEGMENTS, EDGES>,
}

impl<
    C: BandColor,
    const ITEMS: usize,
    const WORDS: usize,
    const ROWS: usize,
    const CELLS: usize,
    const SEGMENTS: usize,
    const EDGES: usize,
> PictureMemory<C, ITEMS, WORDS, ROWS, CELLS, SEGMENTS, EDGES>
{
    /// The capacities of this memory, and of so many rectangles of what changes.
    pub(crate) const fn capacities(damage_areas: usize) -> PictureCapacities {
        PictureCapacities {
            slots: ITEMS,
            words: WORDS,
            segments: SEGMENTS,
            edges: EDGES,
            damage_areas,
        }
    }

    /// Memory without a picture, all zero bits.
    pub(crate) const fn new() -> Self {
        Self {
            slots: [PictureSlot::EMPTY; ITEMS],
            pool: [0; WORDS],
            buckets: [0; ROWS],
            antialiasing: AntialiasingMemory::new(),
        }
    }

    /// A picture of an area, without items.
    pub(crate) fn picture(&mut self, area: Rectangle) -> Picture<'_, 'static, C> {
        Picture::new(area, &mut self.slots, &mut self.pool, &mut self.buckets).with_antialiasing(&mut self.antialiasing)
    }
}

impl<
    C: BandColor,
    const ITEMS: usize,
    const WORDS: usize,
    const ROWS: usize,
    const CELLS: usize,
    const SEGMENTS: usize,
    const EDGES: usize,
> Default for PictureMemory<C, ITEMS, WORDS, ROWS, CELLS, SEGMENTS, EDGES>
{
    fn default() -> Self {
        Self::new()
    }
}

/// A picture is prepared in the machine's byte order. Words of a band in another order are turned into that one before they
/// are drawn on, and back behind it.
impl<C: BandColor> Prepared for Picture<'_, '_, C> {
    type Color = C;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, C, O>) {
        let area = band.bounding_box();
        let words = band.words_mut();
        reorder::<C, O>(words);
        let drawn = Band::new(area, &mut *words).map(|mut native| Picture::draw(self, &mut native));
        debug_assert!(drawn.is_ok(), "the words are those of the area");
        reorder::<C, O>(words);
    }

    /// Rectangles of what changes are not counted: a picture does not tell how many it has.
    fn capacities_used(&self) -> Option<PictureCapacities> {
        Some(PictureCapacities {
            slots: self.slots_used(),
            words: self.words_used(),
            segments: self.segments_needed(),
            edges: self.edges_needed(),
            damage_areas: 0,
        })
    }
}

/// Turns words from one byte order into the other one.
fn reorder<C: BandColor, O: Order>(words: &mut [C::Word]) {
    for word in words {
        *word = O::reorder(*word);
    }
}
