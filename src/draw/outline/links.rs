//! The list of an outline's chains, by the rows in which they begin, in the words of the outline.

use crate::{
    coverage::edges::{Y_BITS, Y_ONE},
    draw::{
        outline::stored::{Corner, Header, NONE, StoredOutline},
        payload::Payload,
    },
    geometry::Window,
};

/// What is known of an outline once it is stored.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Stored {
    /// The pixels in which edges lie, and those between them.
    pub(crate) bounds: Window,
    /// Segments that a row of the outline has at most.
    pub(crate) segments: usize,
}

impl Stored {
    /// The segments for which there has to be memory; `None` where the outline has no pixels.
    pub(crate) const fn segments_needed(&self) -> Option<usize> {
        if self.bounds.is_empty() {
            None
        } else {
            Some(self.segments)
        }
    }
}

/// Writes the header of an outline that begins at a word.
pub(super) fn set_header(payload: &mut Payload<'_>, start: usize, header: Header) {
    for (index, word) in (start..).zip(header.to_words()) {
        payload.set(index, word);
    }
}

/// The chains between which one belongs that is to be linked behind the last one which begins in its first row or above.
pub(super) fn neighbours(payload: &Payload<'_>, start: usize, position: u16, first_chain: u16) -> (u16, u16) {
    let outline = StoredOutline::new(payload.written_from(start));
    let Some(row) = outline.chain(position).map(|chain| outline.first_row(chain)) else {
        return (NONE, NONE);
    };
    let (mut before, mut next) = (NONE, first_chain);
    while let Some(chain) = outline.chain(next) {
        if outline.first_row(chain) > row {
            break;
        }
        (before, next) = (next, chain.next);
    }
    (before, next)
}

/// Links a chain behind the one whose first word has that index.
pub(super) fn set_next(payload: &mut Payload<'_>, word: usize, position: u16) {
    let before = payload.get(word);
    payload.set(word, before & 0xffff_0000 | u32::from(position));
}

/// The pixels around all corners of edges; none where there are no edges.
pub(super) fn bounds([left, top]: Corner, [right, bottom]: Corner) -> Window {
    if left > right {
        return Window::EMPTY;
    }
    let (down, up) = (
        |units: i32| (units + Y_ONE / 2) >> Y_BITS,
        |units: i32| (units + Y_ONE / 2 + Y_ONE - 1) >> Y_BITS,
    );
    Window {
        left: down(left),
        top: down(top),
        right: up(right),
        bottom: up(bottom),
    }
}
