//! Writing the edges of contours into words, as chains.

use crate::{
    draw::{
        FillRule,
        chains::{
            rows::ACTIVE_WORDS,
            stored::{Corner, HEADER_WORDS, Header, MOST_EDGES, NONE, StoredChains},
        },
        outline::ChainRows,
        payload::Payload,
    },
    geometry::Window,
    scan::polygon::ceil_pixel,
};

/// Calls with both ends of each edge of closed contours: the same ones at each call.
type Edges<'s> = dyn Fn(&mut dyn FnMut(Corner, Corner)) + 's;

/// The edges of closed contours, and which points they surround.
#[derive(Copy, Clone)]
pub(crate) struct ContourEdges<'s> {
    /// Ends (x, y) in units of `1 / (1 << fraction_bits)` pixel.
    pub(crate) each: &'s Edges<'s>,
    /// At most 16.
    pub(crate) fraction_bits: u32,
    pub(crate) fill_rule: FillRule,
}

/// Writes the edges of contours, and room for as many active ones as a row may have. Returns a box around the pixels inside.
pub(crate) fn store(contours: &ContourEdges<'_>, payload: &mut Payload<'_>) -> Window {
    let start = payload.needed();
    if let Some(bounds) = store_in(contours, payload, false) {
        return bounds;
    }
    payload.truncate(start);
    // Wide corners always fit.
    store_in(contours, payload, true).unwrap_or(Window::EMPTY)
}

/// Writes edges with wide corners or without; `None` where a corner is too far from the first one.
#[inline(never)]
fn store_in(contours: &ContourEdges<'_>, payload: &mut Payload<'_>, is_wide: bool) -> Option<Window> {
    let mut writer = Writer::new(contours, payload, is_wide);
    (contours.each)(&mut |from, to| writer.add_edge(from, to));
    writer.fits.then(|| writer.finish())
}

/// A chain whose last edge is not known yet.
#[derive(Debug)]
struct OpenChain {
    /// The index of its word.
    index: usize,
    runs_up: bool,
    edges: u32,
    last: Corner,
    /// The rows of its first and its last corner, in the direction of the contour.
    rows: [i32; 2],
}

struct Writer<'p, 'm> {
    payload: &'p mut Payload<'m>,
    /// The index of the first word of the polygon that is being written.
    start: usize,
    header: Header,
    /// Whether all corners are so near the origin that they can be written.
    fits: bool,
    has_origin: bool,
    open: Option<OpenChain>,
    rows: ChainRows,
    least: Corner,
    most: Corner,
}

impl<'p, 'm> Writer<'p, 'm> {
    fn new(contours: &ContourEdges<'_>, payload: &'p mut Payload<'m>, is_wide: bool) -> Self {
        let start = payload.needed();
        payload.push_all(&[0; HEADER_WORDS]);
        Self {
            payload,
            start,
            header: Header {
                fraction_bits: contours.fraction_bits,
                fill_rule: contours.fill_rule,
                is_wide,
                first_chain: NONE,
                origin: [0; 2],
            },
            fits: true,
            has_origin: false,
            open: None,
            rows: ChainRows::NONE,
            least: [i32::MAX; 2],
            most: [i32::MIN; 2],
        }
    }

    /// Adds an edge to the open chain where that ends in the row in which the edge begins, or to a new one. Edges between two rows of
    /// pixel centres are left out: what goes on behind them may begin elsewhere in the row.
    fn add_edge(&mut self, from: Corner, to: Corner) {
        let [first, last] = [from, to].map(|[_, y]| ceil_pixel(y, self.header.fraction_bits));
        if first == last || !self.fits {
            return;
        }
        let runs_up = last < first;
        let goes_on =
            |chain: &OpenChain| chain.runs_up == runs_up && chain.rows[1] == first && chain.edges + 2 <= MOST_EDGES;
        match &mut self.open {
            Some(chain) if goes_on(chain) => {
                chain.rows[1] = last;
                let is_gap = chain.last != from;
                chain.last = to;
                chain.edges += 1 + u32::from(is_gap);
                if is_gap {
                    self.push_corner(from);
                }
            }
            _ => {
                self.close_chain();
                self.open = Some(OpenChain {
                    index: self.payload.needed(),
                    runs_up,
                    edges: 1,
                    last: to,
                    rows: [first, last],
                });
                self.payload.push(0);
                self.push_corner(from);
            }
        }
        self.push_corner(to);
    }

    /// Writes how long the open chain is, and links it.
    fn close_chain(&mut self) {
        let Some(chain) = self.open.take() else { return };
        let [first, end] = if chain.runs_up {
            [chain.rows[1], chain.rows[0]]
        } else {
            chain.rows
        };
        // A picture has rows of 16 bits, and enters what begins below them with the last one.
        let near = |row: i32, last: i16| row.clamp(i16::MIN.into(), last.into());
        self.rows.push(near(first, i16::MAX - 1)..near(end, i16::MAX), 1, 0);
        // What finds no room is only counted. A position of more than 16 bits finds none.
        let Ok(position) = u16::try_from(chain.index - self.start) else {
            return;
        };
        if !self.fits || !self.payload.is_complete() || position == NONE {
            return;
        }
        if chain.runs_up {
            self.reverse_from(chain.index + 1);
        }
        self.write_header();
        let length = chain.edges << 17 | u32::from(chain.runs_up) << 16;
        let (before, next) = self.neighbours(first);
        self.payload.set(chain.index, length | u32::from(next));
        match before {
            NONE => self.header.first_chain = position,
            before => {
                let index = self.start + usize::from(before);
                let word = self.payload.get(index);
                self.payload.set(index, word & 0xffff_0000 | u32::from(position));
            }
        }
    }

    /// Turns the corners round that were written last.
    fn reverse_from(&mut self, mut first: usize) {
        let words = if self.header.is_wide { 2 } else { 1 };
        let mut end = self.payload.needed();
        while first + words < end {
            end -= words;
            for word in 0..words {
                let (upper, lower) = (self.payload.get(first + word), self.payload.get(end + word));
                self.payload.set(first + word, lower);
                self.payload.set(end + word, upper);
            }
            first += words;
        }
    }

    /// The chains between which one belongs that begins in a row: behind the last one that begins there or above.
    fn neighbours(&self, row: i32) -> (u16, u16) {
        let stored = StoredChains::new(self.payload.written_from(self.start));
        let (mut before, mut next) = (NONE, self.header.first_chain);
        while let Some((chain, behind)) = stored.chain(next) {
            if stored.row_of(chain.top) > row {
                break;
            }
            (before, next) = (next, behind);
        }
        (before, next)
    }

    fn write_header(&mut self) {
        for (index, word) in (self.start..).zip(self.header.to_words()) {
            self.payload.set(index, word);
        }
    }

    fn push_corner(&mut self, corner: Corner) {
        let ([x, y], bits) = (corner, self.header.fraction_bits);
        self.least = [x.min(self.least[0]), y.min(self.least[1])];
        self.most = [x.max(self.most[0]), y.max(self.most[1])];
        if self.header.is_wide {
            self.payload.push_signed(x);
            self.payload.push_signed(y);
            return;
        }
        if !self.has_origin {
            self.has_origin = true;
            self.header.origin = corner.map(|units| units >> bits);
        }
        let [left, top] = self.header.origin;
        let near = [x.checked_sub(left << bits), y.checked_sub(top << bits)];
        let [Some(x), Some(y)] = near.map(|units| i16::try_from(units?).ok()) else {
            self.fits = false;
            return;
        };
        self.payload.push(u32::from(x as u16) | u32::from(y as u16) << 16);
    }

    fn finish(&mut self) -> Window {
        self.close_chain();
        self.write_header();
        let [most_chains, _] = self.rows.most();
        for _ in 0..most_chains * ACTIVE_WORDS {
            self.payload.push(0);
        }
        if self.least[0] > self.most[0] {
            return Window::EMPTY;
        }
        let first_centre = |units: i32| ceil_pixel(units, self.header.fraction_bits);
        let ([left, top], [right, bottom]) = (self.least.map(first_centre), self.most.map(first_centre));
        Window {
            left,
            top,
            right,
            bottom,
        }
    }
}
