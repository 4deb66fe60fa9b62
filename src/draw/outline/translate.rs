//! Moving a stored outline by whole pixels: what its words say of positions changes, and nothing is prepared anew.

use crate::{
    coverage::edges::Y_BITS,
    draw::{
        antialiased::{ARC_WORDS, DOMAIN},
        outline::stored::{Corner, Corners, HEADER_WORDS, StoredOutline, pair, unpaired},
    },
    geometry::{InputError, Window},
};

/// Moves an outline by so many columns and rows, the words of which may be followed by others. A window around its corners
/// has to pass [`check_moved`] first.
pub(crate) fn translate(words: &mut [u32], by: Corner) {
    let outline = StoredOutline::new(words);
    let count = usize::from(outline.words());
    match outline.corners() {
        Corners::Near => {
            if let Some(origin) = words.get_mut(HEADER_WORDS - 1) {
                let [left, top] = unpaired(*origin);
                *origin = pair([left + by[0], top + by[1]]);
            }
        }
        Corners::Wide => {
            // Pairs of words: one for each chain, and one for each of its corners.
            let mut position = HEADER_WORDS.div_ceil(2) as u16;
            while let Some(chain) = StoredOutline::new(words)
                .chain(position)
                .filter(|_| 2 * usize::from(position) < count)
            {
                let corners = chain.corners();
                let first = 2 * (usize::from(position) + 1);
                let corners_words = words
                    .get_mut(first..first + 2 * usize::from(corners))
                    .unwrap_or_default();
                corners_words
                    .chunks_exact_mut(2)
                    .for_each(|corner| add_pixels(corner, by));
                position += corners + 1;
            }
        }
        Corners::Round => {
            let arcs = usize::from(outline.arcs());
            let parameters = words
                .get_mut(HEADER_WORDS..HEADER_WORDS + arcs * ARC_WORDS)
                .unwrap_or_default();
            // Each arc begins with the x and the y of its centre.
            parameters
                .chunks_exact_mut(ARC_WORDS)
                .for_each(|arc| add_pixels(arc, by));
        }
    }
}

/// Adds pixels to a position in 1/256 pixel, the first two of some words.
fn add_pixels(words: &mut [u32], by: Corner) {
    for (word, by) in words.iter_mut().zip(by) {
        *word = (*word as i32 + (by << Y_BITS)) as u32;
    }
}

/// Checks that an outline stays in its domain whose corners lie in a window after it was moved.
///
/// # Errors
/// [`InputError::OutOfDomain`] with the smallest and the largest pixel coordinate that would do.
pub(crate) fn check_moved(window: &Window) -> Result<(), InputError> {
    window.check_domain((DOMAIN.start + 1, DOMAIN.end - 2))
}
