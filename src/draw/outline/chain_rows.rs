//! How many chains and edges of an outline a row of pixels has at most, from the rows in which each chain lies.

use core::ops::Range;

/// The first chains of an outline, as far as they are told apart: the others could be anywhere.
#[derive(Debug)]
pub(crate) struct ChainRows {
    extents: [ChainExtent; 32],
    count: usize,
    /// The chains that found no room, and the edges that they have in one row at most, together.
    other_chains: usize,
    other_edges: usize,
}

/// Where a chain or a part of it lies.
#[derive(Debug, Copy, Clone)]
struct ChainExtent {
    first_row: i16,
    end_row: i16,
    /// Whole chains, none for a part of one.
    chains: u16,
    /// Edges that it has in one row at most.
    most_edges: u16,
}

impl ChainRows {
    /// No rows.
    pub(crate) const NONE: Self = Self {
        extents: [ChainExtent {
            first_row: 0,
            end_row: 0,
            chains: 0,
            most_edges: 0,
        }; 32],
        count: 0,
        other_chains: 0,
        other_edges: 0,
    };

    /// Adds the rows of so many chains, or of a part of one, with the edges that they have in one row at most.
    pub(crate) fn push(&mut self, rows: Range<i32>, chains: u16, most_edges: usize) {
        match self.extents.get_mut(self.count) {
            Some(extent) => {
                *extent = ChainExtent {
                    // Rows of the domain fit.
                    first_row: rows.start as i16,
                    end_row: rows.end as i16,
                    chains,
                    most_edges: u16::try_from(most_edges).unwrap_or(u16::MAX),
                }
            }
            None => {
                self.other_chains += usize::from(chains);
                self.other_edges += most_edges;
            }
        }
        self.count += 1;
    }

    /// The most chains and the most edges that lie in one row, or more than that where there are many. Cost: as many steps as
    /// there are pairs.
    pub(crate) fn most(&self) -> [usize; 2] {
        let known = self.extents.get(..self.count).unwrap_or(&self.extents);
        let (mut most_chains, mut most_edges) = (0, 0);
        // The sums grow only where a chain begins.
        for &ChainExtent { first_row: row, .. } in known {
            let (mut chains, mut edges) = (0u32, 0u32);
            for extent in known {
                if extent.first_row <= row && row < extent.end_row {
                    chains += u32::from(extent.chains);
                    edges += u32::from(extent.most_edges);
                }
            }
            (most_chains, most_edges) = (chains.max(most_chains), edges.max(most_edges));
        }
        [
            most_chains as usize + self.other_chains,
            most_edges as usize + self.other_edges,
        ]
    }

    /// Whether all rows were told apart, so that sums are not much too large.
    pub(crate) const fn are_known(&self) -> bool {
        self.count <= self.extents.len()
    }
}
