//! A tree of boxes on the screen, which hold faces: a ray looks only into those that contain its pixel.
//!
//! ```text
//!              all faces                    Faces are halved by the middle of their boxes, along the longer side, again and
//!             /         \                   again, until few are left. A ray looks into a box only where that contains its
//!        A B C D       E F G H              pixel and reaches nearer than what the ray has met so far, into the nearer half
//!        /    \         /    \              first: so most boxes behind a face are never opened.
//!      A B    C D     E F    G H
//! ```
//!
//! The tree has no pointers: it is the order of the faces in a table, halved at its middle, and each inner node has its box at
//! the index of that middle. On the screen all rays are parallel, so that a box is a rectangle of pixels and a nearest depth.
//!
//! Guarantees: a ray comes to each face that covers its pixel, but those in boxes that are farther away than what it says. Cost:
//! building the tree takes n log n.
//!
//! Source: a tree of bounding volumes: Rubin and Whitted 1980, "A 3-dimensional representation for fast rendering of complex
//! scenes".

use core::ops::Range;

use heapless::Vec;

use crate::{
    geometry::{TooSmall, Window},
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::{FaceTable, corners_from_top},
        hidden_surfaces::{placed::for_each_node, ray_casting::depth_margin},
        painter::Painter,
        work::Work,
    },
};

/// Faces that are looked at one by one.
const FEW: usize = 3;

/// Halves of halves that a ray has still to look into, at most: of 65,535 faces.
const LEVELS: usize = 17;

/// A tree of boxes for at most so many faces.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct BoxTree<const FACES: usize> {
    nodes: [u16; FACES],
    /// For each inner node its box, at the index of the middle of its faces.
    boxes: [FaceBox; FACES],
}

/// The pixels that faces may cover, and the nearest depth in units that they may have.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct FaceBox {
    left: i16,
    top: i16,
    right: i16,
    bottom: i16,
    nearest: i32,
}

impl FaceBox {
    const EMPTY: Self = Self {
        left: 0,
        top: 0,
        right: 0,
        bottom: 0,
        nearest: 0,
    };

    /// The box of a face; a depth is at most so much nearer than those of the corners.
    fn of<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        faces: &impl FaceTable<S, D, H>,
        node: u16,
        margin: i32,
    ) -> Option<Self> {
        let [a, b, c] = corners_from_top(faces, node)?;
        // Coordinates of the domain are below 2^13 pixels in size.
        let pixel = |units: i32| (units >> S::FRACTION_BITS) as i16;
        Some(Self {
            left: pixel(a.x_units().min(b.x_units()).min(c.x_units())),
            top: pixel(a.y_units()),
            right: pixel(a.x_units().max(b.x_units()).max(c.x_units())),
            bottom: pixel(b.y_units().max(c.y_units())),
            nearest: a.z.units().max(b.z.units()).max(c.z.units()) + margin,
        })
    }

    /// The box around two boxes.
    fn around(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
            nearest: self.nearest.max(other.nearest),
        }
    }

    fn contains(&self, [column, row]: [i32; 2]) -> bool {
        (i32::from(self.left)..=i32::from(self.right)).contains(&column)
            && (i32::from(self.top)..=i32::from(self.bottom)).contains(&row)
    }

    /// The pixels of the box.
    fn pixels(&self) -> Window {
        Window {
            left: self.left.into(),
            top: self.top.into(),
            right: i32::from(self.right) + 1,
            bottom: i32::from(self.bottom) + 1,
        }
    }

    fn is_wide(&self) -> bool {
        i32::from(self.right) - i32::from(self.left) > i32::from(self.bottom) - i32::from(self.top)
    }

    /// The least and the greatest of what [`middle`](Self::middle) says of boxes within the box.
    fn middles(&self, by_columns: bool) -> [i32; 2] {
        if by_columns {
            [self.left, self.right].map(|column| 2 * i32::from(column))
        } else {
            [self.top, self.bottom].map(|row| 2 * i32::from(row))
        }
    }

    /// Twice the middle of the box: its column, or its row.
    fn middle(&self, by_columns: bool) -> i32 {
        if by_columns {
            i32::from(self.left) + i32::from(self.right)
        } else {
            i32::from(self.top) + i32::from(self.bottom)
        }
    }
}

impl<const FACES: usize> BoxTree<FACES> {
    /// A tree without faces.
    pub(super) const fn new() -> Self {
        Self {
            nodes: [0; FACES],
            boxes: [FaceBox::EMPTY; FACES],
        }
    }

    /// Builds the tree of the faces that begin above the lower side of a window, and reports its boxes. Returns how many faces
    /// these are.
    pub(super) fn build<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        window: &Window,
        painter: &mut impl Painter<S, H>,
    ) -> Result<usize, TooSmall> {
        let mut count = 0;
        for_each_node(faces, window, |node| {
            if let Some(entry) = self.nodes.get_mut(count) {
                *entry = node;
            }
            count += 1;
        });
        let nodes = self.nodes.get_mut(..count).ok_or(TooSmall::Faces(count))?;
        let margin = depth_margin(faces.viewport());
        let mut open = Stack::new(0..count);
        while let Some(range) = open.pop() {
            let (Some(nodes), true) = (nodes.get_mut(range.clone()), range.len() > FEW) else {
                continue;
            };
            let box_of = |node: &u16| FaceBox::of(faces, *node, margin).unwrap_or(FaceBox::EMPTY);
            let all = nodes
                .iter()
                .map(box_of)
                .reduce(FaceBox::around)
                .unwrap_or(FaceBox::EMPTY);
            painter.report(|| Work::Area {
                window: all.pixels(),
                faces: nodes.len(),
            });
            let half = nodes.len() / 2;
            let by_columns = all.is_wide();
            put_in_halves(nodes, half, all.middles(by_columns), |node| {
                box_of(node).middle(by_columns)
            });
            let middle = range.start + half;
            if let Some(entry) = self.boxes.get_mut(middle) {
                *entry = all;
            }
            open.push(range.start..middle);
            open.push(middle..range.end);
        }
        Ok(count)
    }

    /// Visits faces of the tree that the ray through a pixel may meet, of so many: all that cover the pixel, but those of boxes
    /// that are farther away than a depth in units, which may grow from face to face. Each visit is handed what the last one
    /// has found out, and the last of all is returned.
    pub(super) fn fold<T>(
        &self,
        (count, pixel): (usize, [i32; 2]),
        first: T,
        depth: impl Fn(&T) -> i32,
        mut visit: impl FnMut(T, u16) -> T,
    ) -> T {
        let mut found = first;
        let mut open = Stack::new(0..count);
        while let Some(range) = open.pop() {
            if range.len() <= FEW {
                for node in self.nodes.get(range).unwrap_or_default() {
                    found = visit(found, *node);
                }
                continue;
            }
            let middle = range.start + range.len() / 2;
            let is_met = |face_box: &&FaceBox| face_box.contains(pixel) && face_box.nearest >= depth(&found);
            if self.boxes.get(middle).filter(is_met).is_none() {
                continue;
            }
            let halves = [range.start..middle, middle..range.end];
            let nearest = |half: &Range<usize>| {
                let inner = self.boxes.get(half.start + half.len() / 2);
                inner
                    .filter(|_| half.len() > FEW)
                    .map_or(i32::MAX, |inner| inner.nearest)
            };
            let [first, second] = halves;
            let (first, second) = if nearest(&first) >= nearest(&second) {
                (first, second)
            } else {
                (second, first)
            };
            // The last one comes first.
            open.push(second);
            open.push(first);
        }
        found
    }
}

/// Puts the nodes with the least keys first, so many of them, those with greater keys behind them. The keys lie between two
/// numbers: these are halved, and the nodes between them, until the one that comes next has the same key as all around it
/// (Hoare 1961, "Algorithm 65: Find").
fn put_in_halves(
    mut nodes: &mut [u16],
    mut count: usize,
    [mut least, mut greatest]: [i32; 2],
    key: impl Fn(&u16) -> i32,
) {
    while least < greatest {
        let middle = least + ((greatest - least) >> 1);
        let lower = partition(nodes, |node| key(node) <= middle);
        let Some((front, back)) = core::mem::take(&mut nodes).split_at_mut_checked(lower) else {
            return;
        };
        if count < lower {
            (nodes, greatest) = (front, middle);
        } else {
            (nodes, least, count) = (back, middle + 1, count - lower);
        }
    }
}

/// Puts the nodes first that belong to the front. Returns how many these are.
fn partition(nodes: &mut [u16], is_front: impl Fn(&u16) -> bool) -> usize {
    let (mut nodes, mut front) = (nodes.iter_mut(), 0);
    while let Some(first) = nodes.next() {
        if !is_front(first) {
            let Some(last) = nodes.rfind(|node| is_front(node)) else {
                break;
            };
            core::mem::swap(first, last);
        }
        front += 1;
    }
    front
}

/// Ranges of faces that have still to be looked into.
struct Stack(Vec<Range<usize>, LEVELS>);

impl Stack {
    fn new(all: Range<usize>) -> Self {
        let mut stack = Self(Vec::new());
        stack.push(all);
        stack
    }

    /// Adds a range. There is room: of each level at most one half waits, and two of the last one.
    fn push(&mut self, range: Range<usize>) {
        let pushed = self.0.push(range);
        debug_assert!(pushed.is_ok(), "as many levels as halves of 65,535 faces");
    }

    fn pop(&mut self) -> Option<Range<usize>> {
        self.0.pop()
    }
}
