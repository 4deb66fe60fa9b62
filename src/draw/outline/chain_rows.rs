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

    /// The largest sum over all that lies in one row. Cost: as many steps as there are pairs.
    fn most(&self, value: impl Fn(&ChainExtent) -> u16) -> usize {
        let known = self.extents.get(..self.count).unwrap_or(&self.extents);
        // The sum grows only where a chain begins.
        let in_row = |row: i16| {
            known
                .iter()
                .filter(move |extent| (extent.first_row..extent.end_row).contains(&row))
        };
        let sum = |extent: &ChainExtent| in_row(extent.first_row).map(|extent| usize::from(value(extent))).sum();
        known.iter().map(sum).max().unwrap_or(0)
    }

    /// The most chains that lie in one row, or more than that where there are many.
    pub(crate) fn most_chains(&self) -> usize {
        self.most(|extent| extent.chains) + self.other_chains
    }

    /// Whether all rows were told apart, so that sums are not much too large.
    pub(crate) const fn are_known(&self) -> bool {
        self.count <= self.extents.len()
    }

    /// The most edges that lie in one row, or more.
    pub(crate) fn most_edges(&self) -> usize {
        self.most(|extent| extent.most_edges) + self.other_edges
    }
}
