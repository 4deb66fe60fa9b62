//! Writing an outline into words.

use core::ops::Range;

use crate::{
    coverage::{
        AnyCoverage,
        edges::{AntialiasedEdge, Y_BITS},
    },
    draw::{
        FillRule, SubOutline,
        outline::{
            chain_rows::ChainRows,
            convex::Turns,
            links::{Stored, bounds, neighbours, set_header, set_next},
            monotone, round,
            row_edges::most_edges,
            simple::is_simple,
            stored::{Corner, Corners, HEADER_WORDS, Header, NONE, StoredOutline, pair},
        },
        payload::Payload,
    },
    geometry::{InputError, Sub8, SubPixel, Window},
};

/// Writes an outline into words, with a fill rule and the cheapest method that is exact for it. Where it could have more
/// segments in a row than there is memory for, they are counted. Of one that is its own [mirror image](SubOutline::mirror), the
/// left half is written.
///
/// # Errors
/// [`InputError::OutOfDomain`] where a corner lies outside the domain of [`Sub8`].
pub(crate) fn store(
    outline: &dyn SubOutline,
    fill_rule: FillRule,
    payload: &mut Payload<'_>,
) -> Result<Stored, InputError> {
    store_as(outline, outline.mirror().is_some(), fill_rule, payload)
}

/// Writes an outline into words as [`store`] does, so that its pixels come from left to right: also of one that is its own
/// mirror image, both halves.
///
/// # Errors
/// [`InputError::OutOfDomain`] where a corner lies outside the domain of [`Sub8`].
pub(crate) fn store_whole(
    outline: &dyn SubOutline,
    fill_rule: FillRule,
    payload: &mut Payload<'_>,
) -> Result<Stored, InputError> {
    store_as(outline, false, fill_rule, payload)
}

fn store_as(
    outline: &dyn SubOutline,
    is_mirrored: bool,
    fill_rule: FillRule,
    payload: &mut Payload<'_>,
) -> Result<Stored, InputError> {
    let mut stored = match store_arcs(outline, is_mirrored, fill_rule, payload) {
        Some(stored) => stored,
        None => store_corners(outline, fill_rule, payload)?,
    };
    if stored.segments > payload.segments() {
        let Window { top, bottom, .. } = stored.bounds;
        stored.segments = most_edges(outline, top..bottom, stored.segments);
    }
    Ok(stored)
}

/// Writes an outline into words by its arcs, if it is kept as arcs. Not inlined, and neither is the other way, so that the
/// stack holds the tables of one of them only.
#[inline(never)]
fn store_arcs(
    outline: &dyn SubOutline,
    is_mirrored: bool,
    fill_rule: FillRule,
    payload: &mut Payload<'_>,
) -> Option<Stored> {
    let round = outline.round()?;
    (is_mirrored || round::is_kept_as_arcs(&round)).then(|| round::store(&round, is_mirrored, fill_rule, payload))
}

/// Writes an outline into words by its corners.
fn store_corners(
    outline: &dyn SubOutline,
    fill_rule: FillRule,
    payload: &mut Payload<'_>,
) -> Result<Stored, InputError> {
    let start = payload.needed();
    if let Some(stored) = store_in(outline, fill_rule, payload, false)? {
        return Ok(stored);
    }
    payload.truncate(start);
    // Wide corners always fit.
    let stored = store_in(outline, fill_rule, payload, true)?;
    stored.ok_or(InputError::out_of_domain::<Sub8>())
}

/// Writes an outline into words by its corners, wide ones or not; `None` where a corner is too far from the first one.
#[inline(never)]
fn store_in(
    outline: &dyn SubOutline,
    fill_rule: FillRule,
    payload: &mut Payload<'_>,
    is_wide: bool,
) -> Result<Option<Stored>, InputError> {
    // No corner is near an anchor outside of the domain.
    let anchor = outline.anchor().filter(|anchor| !is_wide && is_in_domain(*anchor));
    let mut writer = Writer::new(payload, is_wide, anchor);
    writer.write(outline)?;
    Ok(writer.fits.then(|| writer.finish(outline, fill_rule)))
}

/// Rows that grow with the first edge.
const EMPTY: Range<i32> = Range {
    start: i32::MAX,
    end: i32::MIN,
};

/// The most corners of a chain, whose first word has 15 bits for their number. What is longer goes on as another chain.
const MOST_CORNERS: u32 = (1 << 15) - 1;

/// A chain whose last edge is not known yet.
#[derive(Debug)]
struct OpenChain {
    /// Its position.
    position: usize,
    runs_up: bool,
    corners: u32,
    last: Corner,
    /// The rows in which it lies.
    rows: Range<i32>,
    /// The row in which the last edge ends, or begins where the outline goes up.
    row: i32,
    /// Edges of the chain in that row.
    edges_in_row: usize,
    /// Edges of the chain in one row at most.
    most_edges: usize,
}

struct Writer<'p, 'm> {
    payload: &'p mut Payload<'m>,
    /// Where the outline's words begin.
    start: usize,
    is_wide: bool,
    /// The pixel of the anchor or of the first corner.
    origin: Option<Corner>,
    /// Whether all corners are so near the origin that they can be written.
    fits: bool,
    is_inside: bool,
    is_aligned: bool,
    open: Option<OpenChain>,
    first_chain: u16,
    /// The rows of the chains.
    rows: ChainRows,
    turns: Turns,
    least: Corner,
    most: Corner,
}

impl<'p, 'm> Writer<'p, 'm> {
    fn new(payload: &'p mut Payload<'m>, is_wide: bool, anchor: Option<Corner>) -> Self {
        let start = payload.needed();
        // Chains begin at positions that are multiples of a corner.
        for _ in 0..if is_wide { HEADER_WORDS + 1 } else { HEADER_WORDS } {
            payload.push(0);
        }
        Self {
            payload,
            start,
            is_wide,
            origin: anchor.map(pixel_of),
            fits: true,
            is_inside: true,
            is_aligned: true,
            open: None,
            first_chain: NONE,
            rows: ChainRows::NONE,
            turns: Turns::default(),
            least: [i32::MAX; 2],
            most: [i32::MIN; 2],
        }
    }

    fn write(&mut self, outline: &dyn SubOutline) -> Result<(), InputError> {
        outline.edges(&mut |from, to| {
            self.is_inside &= is_in_domain(from) && is_in_domain(to);
            if self.is_inside {
                self.turns.add(from, to);
                self.add_edge(from, to);
            }
        });
        self.close_chain();
        if self.is_inside {
            Ok(())
        } else {
            Err(InputError::out_of_domain::<Sub8>())
        }
    }

    fn add_edge(&mut self, from: Corner, to: Corner) {
        let Some(edge) = AntialiasedEdge::from_units(from, to) else {
            self.close_chain();
            return;
        };
        let runs_up = edge.winding() < 0;
        self.is_aligned &= edge.is_aligned();
        let goes_on =
            |chain: &OpenChain| chain.runs_up == runs_up && chain.last == from && chain.corners < MOST_CORNERS;
        if !self.open.as_ref().is_some_and(goes_on) {
            self.close_chain();
            self.open_chain(from, runs_up);
        }
        self.push_corner(to);
        let (first, last) = (edge.first_row(), edge.end_row() - 1);
        let Some(chain) = &mut self.open else { return };
        chain.corners += 1;
        chain.last = to;
        chain.rows = chain.rows.start.min(first)..chain.rows.end.max(last + 1);
        let (joined, end) = if runs_up { (last, first) } else { (first, last) };
        chain.edges_in_row = if chain.row == joined { chain.edges_in_row + 1 } else { 1 };
        chain.most_edges = chain.most_edges.max(chain.edges_in_row);
        if joined != end {
            (chain.row, chain.edges_in_row) = (end, 1);
        } else {
            chain.row = joined;
        }
    }

    fn open_chain(&mut self, from: Corner, runs_up: bool) {
        let position = self.position();
        self.payload.push(0);
        if self.is_wide {
            self.payload.push(0);
        }
        self.push_corner(from);
        self.open = Some(OpenChain {
            position,
            runs_up,
            corners: 1,
            last: from,
            rows: EMPTY,
            most_edges: 0,
            row: i32::MIN,
            edges_in_row: 0,
        });
    }

    /// Writes how long the open chain is, and links it.
    fn close_chain(&mut self) {
        let Some(chain) = self.open.take() else { return };
        self.rows.push(chain.rows, 1, chain.most_edges);
        // What finds no room is only counted. A position of more than 16 bits finds none.
        if !self.payload.is_complete() {
            return;
        }
        let position = chain.position as u16;
        let length = chain.corners << 17 | u32::from(chain.runs_up) << 16;
        let word = self.word_of(position);
        self.payload.set(word, length | u32::from(NONE));
        self.write_header_so_far();
        let (before, next) = neighbours(self.payload, self.start, position, self.first_chain);
        self.payload.set(word, length | u32::from(next));
        match before {
            NONE => self.first_chain = position,
            before => set_next(self.payload, self.word_of(before), position),
        }
    }

    /// Writes the header as far as it is needed to read corners.
    fn write_header_so_far(&mut self) {
        let header = Header {
            words: self.payload.needed() - self.start,
            corners: if self.is_wide { Corners::Wide } else { Corners::Near },
            fill_rule: FillRule::NonZero,
            method: AnyCoverage::InsideArea,
            is_mirrored: false,
            first_chain: self.first_chain,
            most_chains: 0,
            origin: self.origin.unwrap_or_default(),
        };
        self.set_header(header);
    }

    fn set_header(&mut self, header: Header) {
        set_header(self.payload, self.start, header);
    }

    fn word_of(&self, position: u16) -> usize {
        let index = usize::from(position);
        self.start + if self.is_wide { 2 * index } else { index }
    }

    /// The position of the next corner or chain.
    fn position(&self) -> usize {
        let words = self.payload.needed() - self.start;
        if self.is_wide { words / 2 } else { words }
    }

    fn push_corner(&mut self, corner: Corner) {
        let [x, y] = corner;
        for (axis, units) in corner.into_iter().enumerate() {
            if let (Some(least), Some(most)) = (self.least.get_mut(axis), self.most.get_mut(axis)) {
                *least = units.min(*least);
                *most = units.max(*most);
            }
        }
        let [left, top] = *self.origin.get_or_insert(pixel_of(corner));
        if self.is_wide {
            self.payload.push_signed(x);
            self.payload.push_signed(y);
            return;
        }
        let near = [x - (left << Y_BITS), y - (top << Y_BITS)];
        self.fits &= near.iter().all(|units| i16::try_from(*units).is_ok());
        self.payload.push(pair(near));
    }

    fn finish(&mut self, outline: &dyn SubOutline, fill_rule: FillRule) -> Stored {
        self.write_header_so_far();
        let stored = StoredOutline::new(self.payload.written_from(self.start));
        let bounds = bounds(self.least, self.most);
        let [most_chains, segments] = if self.rows.are_known() || !self.payload.is_complete() {
            self.rows.most()
        } else {
            stored.most_in(bounds.top..bounds.bottom)
        };
        self.turns.close();
        let method = if self.is_aligned {
            AnyCoverage::CentreSample
        } else if outline.is_simple()
            || self.turns.are_convex()
            || self.turns.are_one_contour()
                && self.payload.is_complete()
                && monotone::is_simple(stored).unwrap_or_else(|| is_simple(outline, stored))
        {
            AnyCoverage::SignedArea
        } else {
            AnyCoverage::InsideArea
        };
        self.set_header(Header {
            words: self.payload.needed() - self.start,
            corners: if self.is_wide { Corners::Wide } else { Corners::Near },
            fill_rule,
            method,
            is_mirrored: false,
            first_chain: self.first_chain,
            most_chains: u16::try_from(most_chains).unwrap_or(u16::MAX),
            origin: self.origin.unwrap_or_default(),
        });
        Stored { bounds, segments }
    }
}

/// Whether a corner lies in the domain of [`Sub8`].
fn is_in_domain(corner: Corner) -> bool {
    corner
        .iter()
        .all(|units| (Sub8::MIN_UNITS..=Sub8::MAX_UNITS).contains(units))
}

/// The pixel from which the corners of an outline count.
fn pixel_of(corner: Corner) -> Corner {
    corner.map(|units| units >> Y_BITS)
}
