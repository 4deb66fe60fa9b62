//! A polygon from row to row: its active edges, in order of their columns, at the end of its words.

use crate::{
    draw::chains::stored::{Chain, StoredChains},
    scan::polygon::EdgeWalk,
};

/// Words of an active edge: its walk, the row after its last one, and what is left of its chain below it.
pub(super) const ACTIVE_WORDS: usize = EdgeWalk::WORDS + 2;

/// The indices of the last row and of the rest of the chain in the words of an active edge.
const END_ROW: usize = EdgeWalk::WORDS;
const REST: usize = EdgeWalk::WORDS + 1;

type Active = [u32; ACTIVE_WORDS];

/// The state of drawing a stored polygon from top to bottom, between two rows: how many of its edges go on into the next row,
/// and which chain of edges begins next.
#[derive(Debug, Copy, Clone)]
pub(crate) struct Cursor {
    /// The number of active edges, whose words are the last ones of the stored polygon.
    active: u16,
    /// The position of the chain that begins next.
    waiting: u16,
    /// Before this row no edge begins or ends.
    next_change: i32,
}

impl Cursor {
    /// The cursor that [`to_words`](Self::to_words) wrote.
    #[inline(always)]
    pub(crate) const fn of([chains, next_change]: [u32; 2]) -> Self {
        Self {
            active: chains as u16,
            waiting: (chains >> 16) as u16,
            next_change: next_change as i32,
        }
    }

    /// The cursor as two words.
    #[inline(always)]
    pub(crate) fn to_words(self) -> [u32; 2] {
        [
            u32::from(self.active) | u32::from(self.waiting) << 16,
            self.next_change as u32,
        ]
    }

    /// Calls with first column and the one after the last of each run of pixels in a row, from left to right, and moves on to the
    /// next row. The columns of neighbouring runs may touch. A run may be empty.
    #[inline(always)]
    pub(crate) fn draw_row(&mut self, words: &mut [u32], row: i32, mut emit: impl FnMut(i32, i32)) {
        let mask = StoredChains::new(words).fill_mask();
        let (mut winding, mut start, mut last, mut is_sorted) = (0i32, 0, i32::MIN, true);
        for active in split(words, self.active).1.chunks_exact_mut(ACTIVE_WORDS) {
            let [x, error, step, error_step, height, _, rest] = active else {
                continue;
            };
            let mut walk = EdgeWalk::of_words([*x, *error, *step, *error_step, *height]);
            let is_inside = winding & mask != 0;
            winding += if *rest & 1 == 0 { 1 } else { -1 };
            if !is_inside {
                start = walk.x();
            } else if winding & mask == 0 {
                emit(start, walk.x());
            }
            walk.step();
            is_sorted &= last <= walk.x();
            last = walk.x();
            [*x, *error, ..] = walk.to_words();
        }
        if row + 1 >= self.next_change {
            self.change(words, row + 1);
        } else if !is_sorted {
            sort(split(words, self.active).1);
        }
    }

    /// Puts the edges that begin in a row in the place of those that have ended, or beside them.
    #[inline(never)]
    fn change(&mut self, words: &mut [u32], row: i32) {
        self.next_change = i32::MAX;
        self.go_on(words, row);
        self.begin(words, row);
        sort(split(words, self.active).1);
    }

    /// Goes on to the next edges of chains whose edges have ended, and drops the chains that have ended.
    fn go_on(&mut self, words: &mut [u32], row: i32) {
        let (chains, active) = split(words, self.active);
        let chains = StoredChains::new(chains);
        let mut first_kept = usize::from(self.active);
        for index in (0..usize::from(self.active)).rev() {
            let Some(mut edge) = get(active, index) else { continue };
            if edge[END_ROW] as i32 <= row {
                match entered(chains, Chain::of_word(edge[REST]), row) {
                    Some(next) => edge = next,
                    None => continue,
                }
            }
            self.next_change = self.next_change.min(edge[END_ROW] as i32);
            first_kept -= 1;
            set(active, first_kept, edge);
        }
        // What has ended leaves nothing: two polygons that are drawn to their ends have the same words if they are the same.
        active.get_mut(..first_kept * ACTIVE_WORDS).unwrap_or_default().fill(0);
        // Not more than there were.
        self.active -= first_kept as u16;
    }

    /// Enters the chains that begin in a row or above it.
    fn begin(&mut self, words: &mut [u32], row: i32) {
        while let Some((chain, behind)) = StoredChains::new(words).chain(self.waiting) {
            let first_row = StoredChains::new(words).row_of(chain.top);
            if first_row > row {
                self.next_change = self.next_change.min(first_row);
                return;
            }
            self.waiting = behind;
            if let Some(edge) = entered(StoredChains::new(words), chain, row) {
                self.next_change = self.next_change.min(edge[END_ROW] as i32);
                self.active += 1;
                set(split(words, self.active).1, 0, edge);
            }
        }
    }
}

/// The cursor in a row of a polygon.
pub(crate) fn enter(words: &mut [u32], row: i32) -> Cursor {
    let mut cursor = Cursor {
        active: 0,
        waiting: StoredChains::new(words).first_chain(),
        next_change: row,
    };
    cursor.change(words, row);
    cursor
}

/// The edge that a chain has in a row; `None` where it has ended.
fn entered(chains: StoredChains<'_>, chain: Chain, row: i32) -> Option<Active> {
    let (edge, rest) = chains.edge_below(chain, row)?;
    let [x, error, step, error_step, height] = edge.walk_from(row).to_words();
    Some([x, error, step, error_step, height, edge.end_row as u32, rest.to_word()])
}

/// The words before so many active edges, and those of these edges, which are the last ones.
#[inline(always)]
fn split(words: &mut [u32], active: u16) -> (&mut [u32], &mut [u32]) {
    let start = words.len().saturating_sub(usize::from(active) * ACTIVE_WORDS);
    words.split_at_mut_checked(start).unwrap_or_default()
}

fn get(active: &[u32], index: usize) -> Option<Active> {
    active.get(index * ACTIVE_WORDS..)?.first_chunk().copied()
}

fn set(active: &mut [u32], index: usize, edge: Active) {
    if let Some(room) = active
        .get_mut(index * ACTIVE_WORDS..)
        .and_then(<[u32]>::first_chunk_mut)
    {
        *room = edge;
    }
}

/// Puts active edges into the order of their columns: insertion sort, because neighbouring rows have nearly the same order.
#[inline(never)]
fn sort(active: &mut [u32]) {
    let column = |edge: &Active| edge[0] as i32;
    for end in 1..active.len() / ACTIVE_WORDS {
        let Some(inserted) = get(active, end) else { return };
        let mut index = end;
        while let Some(before) = index.checked_sub(1).and_then(|before| get(active, before)) {
            if column(&before) <= column(&inserted) {
                break;
            }
            set(active, index, before);
            index -= 1;
        }
        if index != end {
            set(active, index, inserted);
        }
    }
}
