//! The tree of a combination of solids, in postorder, and whether a point is inside of it.
//!
//! ```text
//!          -                A B + C -            From left to right, a solid puts onto a stack whether the point is inside of it,
//!         / \                                    and an operation takes the two on top and puts its result there. In the end
//!        +   C              A B C: solids        that of the whole tree is on top.
//!       / \
//!      A   B
//! ```
//!
//! The stack is an integer, a bit for each entry.
//!
//! Source: the tree: Requicha and Voelcker 1977, "Constructive solid geometry"; a stack of results for operations behind their
//! operands: Burks, Warren and Wright 1954, "An analysis of a logical machine using parenthesis-free notation".

use core::ops::Range;

/// A node of a tree of solids ([`SolidCombination`](crate::visible::SolidCombination)), in postorder: each operation stands
/// behind its two operands, first the left one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SolidNode {
    /// A solid: faces that bound it, by their indices in the order of models and faces.
    Primitive(Range<u16>),
    /// What is in one of two solids, or in both.
    Union,
    /// What is in both of two solids.
    Intersection,
    /// What is in the left one of two solids and not in the right one.
    Difference,
}

#[cfg(feature = "defmt")]
impl defmt::Format for SolidNode {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        match self {
            Self::Primitive(Range { start, end }) => defmt::write!(formatter, "Primitive {}..{}", start, end),
            Self::Union => defmt::write!(formatter, "Union"),
            Self::Intersection => defmt::write!(formatter, "Intersection"),
            Self::Difference => defmt::write!(formatter, "Difference"),
        }
    }
}

/// The solids that a face bounds, or that a point is inside of: a bit for each, the lowest for the first.
pub(super) type Solids = u32;

/// The first 32 solids of a tree that a face bounds.
pub(super) fn solids_of(tree: &[SolidNode], face: u16) -> Solids {
    let (mut solids, mut bit) = (0, 1);
    for node in tree {
        if let SolidNode::Primitive(faces) = node {
            if faces.contains(&face) {
                solids |= bit;
            }
            bit <<= 1;
        }
    }
    solids
}

/// Whether a point is inside of the combination, given the solids that it is inside of.
pub(super) fn is_inside(tree: &[SolidNode], solids: Solids) -> bool {
    let (mut stack, mut rest) = (0u32, solids);
    for node in tree {
        let (below, left, right) = (stack >> 2 << 1, stack >> 1 & 1, stack & 1);
        stack = match node {
            SolidNode::Primitive(_) => {
                let solid = rest & 1;
                rest >>= 1;
                stack << 1 | solid
            }
            SolidNode::Union => below | left | right,
            SolidNode::Intersection => below | (left & right),
            SolidNode::Difference => below | (left & !right),
        };
    }
    stack & 1 != 0
}
