//! The faces that are not separate from a window: one array for the windows of all levels.
//!
//! ```text
//!     list of a window      A B C D E F G          The list of a window is the front of the array. Each of its quarters rearranges
//!     list of a quarter     E B A|D C F G          this front, so that its own list is a shorter front; what else is in the
//!     list of a quarter     B|E A C D F G          array, the lists of the windows above, keep their faces.
//!       of the quarter
//! ```
//!
//! Where more faces are in a window than the array has room for, the window has no list, and its quarters look through the whole
//! table of faces.

use crate::{
    geometry::Window,
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::{FaceTable, corners_from_top},
        hidden_surfaces::{
            placed::for_each_node,
            warnock::window_test::{CenterRectangle, FaceCorners, Relation, WindowTest},
        },
    },
};

/// The length of a list that does not fit.
pub(super) const UNLISTED: u16 = u16::MAX;

/// The faces of a window, as the front of an array of nodes: those that surround it, and then those that intersect it.
#[derive(Debug)]
pub(super) struct FaceList<'n> {
    nodes: &'n mut [u16],
    /// How many faces are in the list, or [`UNLISTED`].
    listed: u16,
    surrounding: u16,
}

impl<'n> FaceList<'n> {
    /// The faces of a window, found in the list of a window around it, which has so many faces.
    pub(super) fn narrowed<T: WindowTest, S: ScreenPrecision, D: DepthWidth, H: Shading>(
        nodes: &'n mut [u16],
        faces: &impl FaceTable<S, D, H>,
        window: &Window,
        listed: u16,
    ) -> Self {
        let rectangle = CenterRectangle::of::<S>(window);
        if listed == UNLISTED {
            return Self::of_table::<T, S, D, H>(nodes, faces, window, &rectangle);
        }
        let mut list = Self {
            nodes,
            listed,
            surrounding: 0,
        };
        let mut index = 0;
        while let Some(node) = list.node(index) {
            match relation::<T, S, D, H>(faces, node, &rectangle) {
                Relation::Separate => {
                    list.leave_out(index);
                    continue;
                }
                Relation::Surrounding => list.move_to_surrounding(index),
                Relation::Intersecting => {}
            }
            index += 1;
        }
        list
    }

    /// The faces of a window, found in the whole table.
    fn of_table<T: WindowTest, S: ScreenPrecision, D: DepthWidth, H: Shading>(
        nodes: &'n mut [u16],
        faces: &impl FaceTable<S, D, H>,
        window: &Window,
        rectangle: &CenterRectangle,
    ) -> Self {
        let mut list = Self {
            nodes,
            listed: 0,
            surrounding: 0,
        };
        for_each_node(faces, window, |node| {
            if list.listed == UNLISTED {
                return;
            }
            let relation = relation::<T, S, D, H>(faces, node, rectangle);
            if relation != Relation::Separate {
                list.push(node, relation);
            }
        });
        list
    }

    fn push(&mut self, node: u16, relation: Relation) {
        let index = self.listed;
        let Some(slot) = self.nodes.get_mut(usize::from(index)) else {
            self.listed = UNLISTED;
            return;
        };
        *slot = node;
        self.listed += 1;
        if relation == Relation::Surrounding {
            self.move_to_surrounding(index);
        }
    }

    /// Moves a face to the end of those that surround the window.
    fn move_to_surrounding(&mut self, index: u16) {
        self.exchange(index, self.surrounding);
        self.surrounding += 1;
    }

    /// How many faces are in the list, or [`UNLISTED`].
    pub(super) fn listed(&self) -> u16 {
        self.listed
    }

    /// How many faces of the list surround the window: the first ones.
    pub(super) fn surrounding(&self) -> u16 {
        self.surrounding
    }

    /// A face of the list.
    pub(super) fn node(&self, index: u16) -> Option<u16> {
        let is_listed = index < self.listed && self.listed != UNLISTED;
        self.nodes.get(usize::from(index)).copied().filter(|_| is_listed)
    }

    /// The faces of the list.
    pub(super) fn nodes(&self) -> impl Iterator<Item = u16> + '_ {
        (0..self.listed).map_while(|index| self.node(index))
    }

    /// Takes a face off the list, whose place another one takes that was not looked at.
    pub(super) fn leave_out(&mut self, index: u16) {
        let mut index = index;
        if index < self.surrounding {
            self.surrounding -= 1;
            self.exchange(index, self.surrounding);
            index = self.surrounding;
        }
        self.listed -= 1;
        self.exchange(index, self.listed);
    }

    /// Exchanges two faces.
    pub(super) fn exchange(&mut self, one: u16, other: u16) {
        let (one, other) = (usize::from(one), usize::from(other));
        let (Some(first), Some(second)) = (self.nodes.get(one).copied(), self.nodes.get(other).copied()) else {
            return;
        };
        if let Some(slot) = self.nodes.get_mut(one) {
            *slot = second;
        }
        if let Some(slot) = self.nodes.get_mut(other) {
            *slot = first;
        }
    }
}

/// How a face of the table lies to a window.
fn relation<T: WindowTest, S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
    window: &CenterRectangle,
) -> Relation {
    match corners_from_top(faces, node) {
        Some([a, b, c]) => T::relation(&FaceCorners([a.position(), b.position(), c.position()]), window),
        None => Relation::Separate,
    }
}
