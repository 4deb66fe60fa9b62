//! Greiner and Hormann's polygon clipping (1998, "Efficient Clipping of Arbitrary Polygons", ACM Transactions on Graphics
//! 17(2), a linked-list form of Weiler and Atherton's of 1977), with its degenerate cases resolved by labels as Foster,
//! Hormann and Popa do (2019, "Clipping Simple Polygons with Degenerate Intersections", Computers & Graphics: X 2).
//!
//! Guarantees: intersection, union and difference of two polygons with any number of contours each, which have parts,
//! holes and islands by the even-odd rule. Contours may touch, share edges, cross and coincide, with each other and with
//! themselves; repeated corners, spikes and contours without area count for nothing. What meets what is decided by
//! exact orientation in 64 bits, before anything is rounded, and nothing is perturbed. So the number of parts and holes is that
//! of the exact result: parts are what hangs together by more than points, each with one outer contour. Only then a
//! crossing is rounded, once, to the nearest unit (ties to the larger coordinate): the same point whichever edge and end
//! it is computed from, and corners stay where they are.
//!
//! The area is that of the exact result but for this rounding: each crossing is off by half a unit at most on each axis,
//! which moves the area by less than `length / 2 + corners / 4` square units in all, `length` the sum of the sizes of
//! all edges of the result, on both axes. A part thinner than a unit may so be left with no area, or meet itself or
//! another one; it is handed over all the same.
//!
//! Cost: a comparison of extents for every two edges of both polygons, four products where these meet, two 64-bit
//! divisions for each coordinate of a crossing. Polygons whose extents are apart are told at once. RAM: 20 bytes a
//! vertex with [`Sub4`](crate::geometry::Sub4), 24 with [`Sub8`](crate::geometry::Sub8).
//!
//! Take it when either polygon is not convex, has holes, or is to be joined or subtracted. Its number of steps grows with
//! the square of the number of edges.

mod crossings;
mod direction;
mod labels;
mod operation;
mod outlines;
mod segment;
mod vertices;

use core::{
    fmt::{self, Display},
    iter,
};

use heapless::{Vec, VecView};

use crate::geometry::{OutOfDomain, SubPixel, SubPoint, Table, TableFull};

pub use operation::Operation;
use segment::{Extent, Meeting};
use vertices::{Full, Place, Polygons, Vertex, Vertices, Walk};

/// Two polygons cannot be clipped.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ClipError {
    /// A corner lies outside the domain of its precision, which a point made by hand can.
    OutOfDomain(OutOfDomain),
    /// There are too many vertices. The number that is needed is exact where no three edges meet in a point, and enough
    /// everywhere. Above 65,535 no table will do: clip parts of the polygons. With more corners than that, no more is
    /// counted.
    TableFull(TableFull),
}

impl Display for ClipError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfDomain(error) => error.fmt(formatter),
            Self::TableFull(error) => error.fmt(formatter),
        }
    }
}

impl core::error::Error for ClipError {}

/// Clips polygons, and keeps the result.
///
/// `N` is the number of vertices that it has room for, of which 65,535 are used at most: the corners of both polygons, two for
/// every crossing of two edges, and one for every corner that lies inside an edge.
///
/// ```
/// use zrow::clip::boolean::greiner_hormann::{Clipper, Operation};
/// use zrow::geometry::{Sub8, SubPoint};
///
/// let corner = |x: i32, y: i32| SubPoint::<Sub8>::from_units(x << 8, y << 8);
/// let square = [corner(0, 0)?, corner(8, 0)?, corner(8, 8)?, corner(0, 8)?];
/// // Its upper side lies on the square's.
/// let slot = [corner(3, 0)?, corner(5, 0)?, corner(5, 4)?, corner(3, 4)?];
///
/// let mut clipper = Clipper::<Sub8, 16>::new();
/// let result = clipper.clip(&[&square], &[&slot], Operation::Difference)?;
/// let contours: Vec<_> = result.contours().collect();
/// assert_eq!(contours.len(), 1);
/// assert!(!contours[0].is_hole());
/// assert_eq!(contours[0].points().count(), 8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Clipper<S: SubPixel, const N: usize> {
    vertices: Vec<Vertex<S>, N>,
}

impl<S: SubPixel, const N: usize> Default for Clipper<S, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: SubPixel, const N: usize> Clipper<S, N> {
    /// One that has clipped nothing yet.
    pub const fn new() -> Self {
        Self { vertices: Vec::new() }
    }

    /// Clips the subject by another polygon, which [`Operation::Intersection`] keeps and [`Operation::Difference`] takes
    /// away. What was clipped before is gone.
    ///
    /// A contour is closed by itself and may run either way.
    ///
    /// # Errors
    /// [`ClipError::OutOfDomain`]; [`ClipError::TableFull`] with a number of vertices that would do.
    pub fn clip(
        &mut self,
        subject: &[&[SubPoint<S>]],
        clip: &[&[SubPoint<S>]],
        operation: Operation,
    ) -> Result<Clipped<'_, S>, ClipError> {
        let vertices = self.vertices.as_mut_view();
        run(vertices, subject, clip, operation)?;
        Ok(Clipped { vertices })
    }
}

fn run<S: SubPixel>(
    vertices: &mut VecView<Vertex<S>>,
    subject: &[&[SubPoint<S>]],
    clip: &[&[SubPoint<S>]],
    operation: Operation,
) -> Result<(), ClipError> {
    vertices.clear();
    check_domain(subject)?;
    check_domain(clip)?;
    let are_apart = !extent(subject).meets(&extent(clip));
    let (subject, clip): (&[&[_]], &[&[_]]) = match operation {
        Operation::Intersection if are_apart => return Ok(()),
        Operation::Difference if are_apart => (subject, &[]),
        _ => (subject, clip),
    };
    if add_vertices(vertices, subject, clip).is_err() {
        vertices.clear();
        return Err(ClipError::TableFull(TableFull {
            table: Table::ContourVertices,
            needed: vertices_needed(subject, clip),
        }));
    }
    labels::label(vertices, operation);
    outlines::connect(vertices);
    Ok(())
}

fn check_domain<S: SubPixel>(contours: &[&[SubPoint<S>]]) -> Result<(), ClipError> {
    contours
        .iter()
        .copied()
        .flatten()
        .try_for_each(|point| SubPoint::<S>::from_units(point.x_units(), point.y_units()).map(|_| ()))
        .map_err(ClipError::OutOfDomain)
}

fn extent<S: SubPixel>(contours: &[&[SubPoint<S>]]) -> Extent {
    Extent::of(contours.iter().copied().flatten().copied())
}

fn add_vertices<S: SubPixel>(
    vertices: &mut VecView<Vertex<S>>,
    subject: &[&[SubPoint<S>]],
    clip: &[&[SubPoint<S>]],
) -> Result<(), Full> {
    for contour in subject {
        crossings::add_contour(vertices, contour, Polygons::SUBJECT)?;
    }
    for contour in clip {
        crossings::add_contour(vertices, contour, Polygons::CLIP)?;
    }
    crossings::add_meetings(vertices)
}

/// One for each corner, and those that every two edges add where they meet.
fn vertices_needed<S: SubPixel>(subject: &[&[SubPoint<S>]], clip: &[&[SubPoint<S>]]) -> usize {
    let edges = || subject.iter().chain(clip).flat_map(|contour| crossings::edges(contour));
    let most = usize::from(Place::MAX);
    let corners = edges().take(most + 1).count();
    if corners > most {
        return corners;
    }
    // Two vertices for every two of 2^16 edges fit 32 bits.
    edges().enumerate().fold(corners, |needed, (index, first)| {
        let meetings = edges()
            .skip(index + 1)
            .map(|second| Meeting::of(&first, &second).vertices());
        needed + meetings.sum::<usize>()
    })
}

/// The polygon that is left.
#[derive(Debug)]
pub struct Clipped<'a, S: SubPixel> {
    vertices: &'a [Vertex<S>],
}

impl<'a, S: SubPixel> Clipped<'a, S> {
    /// The contours of the result, in no order that means something. None where nothing is left.
    pub fn contours(&self) -> impl Iterator<Item = Contour<'a, S>> + Clone + use<'a, S> {
        let vertices = self.vertices;
        let places = 0..vertices.len() as Place;
        places
            .filter(move |&piece| matches!(vertices.at(piece).walk, Walk::Outer | Walk::Hole))
            .map(move |first| Contour { vertices, first })
    }
}

/// A contour of the result, without corners on straight lines. It passes no point twice, but for crossings that rounding
/// brings together.
#[derive(Debug, Copy, Clone)]
pub struct Contour<'a, S: SubPixel> {
    vertices: &'a [Vertex<S>],
    first: Place,
}

impl<'a, S: SubPixel> Contour<'a, S> {
    /// Whether the result lies around it and not in it. Holes run counter-clockwise on the screen, where y grows
    /// downwards, and outer contours clockwise.
    pub fn is_hole(&self) -> bool {
        self.vertices.at(self.first).walk == Walk::Hole
    }

    /// The corners of the contour in order; the last one joins the first.
    pub fn points(&self) -> impl Iterator<Item = SubPoint<S>> + Clone + use<'a, S> {
        let Self { vertices, first } = *self;
        iter::successors(Some(first), move |&piece| {
            Some(vertices.at(piece).follower).filter(|&follower| follower != first)
        })
        .filter_map(move |piece| outlines::corner_after(vertices, piece))
    }
}

#[cfg(feature = "defmt")]
mod formats {
    //! Tables are too long for the probe: their sizes will do.

    use super::{Clipped, Clipper, Contour, SubPixel};

    impl<S: SubPixel, const N: usize> defmt::Format for Clipper<S, N> {
        fn format(&self, formatter: defmt::Formatter<'_>) {
            defmt::write!(formatter, "Clipper with {} of {} vertices", self.vertices.len(), N);
        }
    }

    impl<S: SubPixel> defmt::Format for Clipped<'_, S> {
        fn format(&self, formatter: defmt::Formatter<'_>) {
            defmt::write!(formatter, "Clipped of {} vertices", self.vertices.len());
        }
    }

    impl<S: SubPixel> defmt::Format for Contour<'_, S> {
        fn format(&self, formatter: defmt::Formatter<'_>) {
            defmt::write!(formatter, "Contour, hole: {}", self.is_hole());
        }
    }
}
