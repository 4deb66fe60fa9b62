//! Counters of a frame: what was there to do, what was left out, and what was done.
//!
//! They lie in the prepared frame and nowhere else, and only where a look [counts](crate::scene::Counted): otherwise their type
//! is `()`, and what adds to them is no code.

use core::{cell::Cell, fmt::Debug};

use crate::visible::Count;

/// What a frame took: what there was, what was left out, and what was done, in a look that is
/// [`Counted`](crate::scene::Counted).
///
/// Numbers of faces are those of the whole frame; the others are of the rows that were drawn since it was prepared, and begin
/// again at 0 after the greatest number.
///
/// Depths that were tested for each pixel of the panel say how many surfaces lie behind each other there; faces that were left
/// out say how much of the models is not seen:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     band::Band,
///     scene::{Camera, Counted, Counters, FaceSet, Memory, Model},
/// };
///
/// // A wall, another one behind it, and one that is seen from behind.
/// const WALL: [[i16; 3]; 3] = [[-512, -512, 512], [0, 512, 512], [512, -512, 512]];
/// const BEHIND: [[i16; 3]; 3] = [[-512, -512, 700], [0, 512, 700], [512, -512, 700]];
/// let models = [
///     Model::new(FaceSet::new(&BEHIND, &[[0, 1, 2], [0, 2, 1]])?, &[Rgb565::BLUE; 2])?,
///     Model::new(FaceSet::new(&WALL, &[[0, 1, 2]])?, &[Rgb565::RED])?,
/// ];
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mut memory = Memory::<Counted<Rgb565>, 6, 3, 64, 64>::new();
/// let mut scene = memory.prepare(&camera, &models)?;
/// scene.draw_with(&mut Band::<Rgb565>::new(area, &mut [0; 64 * 64])?, |_| {});
/// let Counters { faces, faces_culled, pixels_tested, .. } = scene.counters();
/// assert_eq!((faces, faces_culled), (3, 1));
/// // A half of the picture for the wall, a quarter for the hidden one.
/// assert_eq!(100 * pixels_tested / (64 * 64), 75);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counters {
    /// Faces of all models.
    pub faces: u32,
    /// Faces that are left out: seen from behind, beyond a side of the picture, or between the centres of pixels.
    pub faces_culled: u32,
    /// Of these, faces of models that were left out as a whole ([`Bounded`](crate::shade::Bounded)).
    pub faces_culled_by_bounds: u32,
    /// Faces that were left out because the eye is behind their planes ([`WithPlanes`](crate::shade::WithPlanes)), before their
    /// vertices were transformed: a part of [`faces_culled`](Self::faces_culled).
    pub faces_culled_by_planes: u32,
    /// Vertices that were not transformed, because all of their faces were left out by their planes.
    pub vertices_not_transformed: u32,
    /// Faces that were cut at the near plane, the far plane or the guard band.
    pub faces_cut: u32,
    /// Rows that were drawn.
    pub rows: u32,
    /// Rows that were drawn without depths, because no face overlaps another in them.
    pub rows_without_depth: u32,
    /// Rows that were drawn in more than one pass.
    pub rows_in_passes: u32,
    /// Spans that were filled without depths.
    pub spans_filled: u32,
    /// Pixels of such spans: depth tests that were left out. A row in which an overlap turns up is drawn once more.
    pub pixels_filled: u32,
    /// Spans whose depths were tested.
    pub spans_tested: u32,
    /// Pixels of such spans: depth tests that were made.
    pub pixels_tested: u32,
    /// Pixels whose colour was computed from attributes: for a texture, its texels.
    pub fragments: u32,
    /// Pixels of translucent faces whose colour was mixed with what is behind them.
    pub fragments_blended: u32,
    /// Divisions by a depth, for attributes in perspective.
    pub divisions: u32,
}

// Not re-exported: whether a look counts is said by its wrapper.
/// Where the counters of a frame are: nowhere (`()`), or in the prepared frame.
pub trait Counting: Default + Debug {
    /// What code has that may count.
    type Count<'c>: Count
    where
        Self: 'c;

    /// The counters, to add to.
    fn count(&self) -> Self::Count<'_>;
}

impl Counting for () {
    type Count<'c> = ();

    #[inline(always)]
    fn count(&self) {}
}

impl Counting for Cell<Counters> {
    type Count<'c> = &'c Self;

    #[inline]
    fn count(&self) -> &Self {
        self
    }
}

impl Count for &Cell<Counters> {
    fn filled(self, pixels: usize) {
        add(self, |counters| {
            increase(&mut counters.spans_filled, u32::from(pixels > 0));
            increase(&mut counters.pixels_filled, pixels as u32);
        });
    }

    fn tested(self, pixels: usize) {
        add(self, |counters| {
            increase(&mut counters.spans_tested, u32::from(pixels > 0));
            increase(&mut counters.pixels_tested, pixels as u32);
        });
    }

    fn fragment(self) {
        add(self, |counters| increase(&mut counters.fragments, 1));
    }

    fn blended(self) {
        add(self, |counters| increase(&mut counters.fragments_blended, 1));
    }

    fn divisions(self, number: u32) {
        add(self, |counters| increase(&mut counters.divisions, number));
    }

    fn row(self) {
        add(self, |counters| increase(&mut counters.rows, 1));
    }
}

/// Adds to a counter, modulo 2^32.
fn increase(counter: &mut u32, by: u32) {
    *counter = counter.wrapping_add(by);
}

/// Changes counters in their cell.
fn add(cell: &Cell<Counters>, change: impl FnOnce(&mut Counters)) {
    let mut counters = cell.get();
    change(&mut counters);
    cell.set(counters);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A frame that is prepared once and drawn for days.
    #[test]
    fn counters_begin_again_after_the_greatest_number() {
        let counters = Cell::new(Counters {
            rows: u32::MAX,
            spans_filled: u32::MAX,
            pixels_filled: u32::MAX - 2,
            spans_tested: u32::MAX,
            pixels_tested: u32::MAX - 2,
            fragments: u32::MAX,
            fragments_blended: u32::MAX,
            divisions: u32::MAX - 2,
            ..Counters::default()
        });
        let count = &counters;
        count.row();
        count.filled(7);
        count.tested(7);
        count.fragment();
        count.blended();
        count.divisions(7);
        let expected = Counters {
            pixels_filled: 4,
            pixels_tested: 4,
            divisions: 4,
            ..Counters::default()
        };
        assert_eq!(counters.get(), expected);
    }
}
