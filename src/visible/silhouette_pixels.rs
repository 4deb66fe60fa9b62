//! The pixels of a row through which silhouettes pass, mixed when the row is drawn: the surface that ends there by its coverage
//! over the one behind it.
//!
//! ```text
//!     surfaces at the centre of the pixel      surfaces by area    the surface that ends there
//!     one                                      3/4                 is at the centre: 3/4 of it over what was there
//!     none                                     1/4                 is beside it: 1/4 of it over what was there
//!     two, the edge is that of the nearer      1 1/2               is at the centre: 1/2 of it over the second
//!     one, behind the edge                     1 1/2               is beside it: 1/2 of the edge's face over that one
//!     two, the edge is that of the farther     1 1/2               is hidden
//! ```
//!
//! Cost: mixing, and for each pixel with several surfaces a look at each face that crosses the row, except where one edge alone
//! passes and leaves less than half of the pixel to its surface: that one is not at the centre.

use core::{borrow::Borrow, marker::PhantomData, num::Wrapping};

use embedded_graphics::geometry::Point;
use heapless::Vec;

use crate::{
    coverage::{AREA_BITS, Coverage},
    shade::{Planes, Shading},
    surface::{Order, PixelWord},
    view::{DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{
        DepthRow,
        active_face::{ActiveFace, WordOf},
        face_table::FaceTable,
        passes::{face_in_first_row, for_each_crossing, surroundings},
        shaded_span::run,
        silhouette_row::{EdgeColumn, EdgeRow},
    },
};

/// The faces that cross a row.
pub(super) trait Crossing<S: ScreenPrecision, H: Shading> {
    /// Hands over each of the faces.
    fn for_each(&self, visit: impl FnMut(&ActiveFace<S, H>));
}

/// The faces of all slots in use.
pub(super) struct InSlots<'s, S: ScreenPrecision, H: Shading>(pub(super) &'s [ActiveFace<S, H>]);

impl<S: ScreenPrecision, H: Shading> Crossing<S, H> for InSlots<'_, S, H> {
    #[inline]
    fn for_each(&self, visit: impl FnMut(&ActiveFace<S, H>)) {
        self.0.iter().for_each(visit);
    }
}

/// The faces of a table that cross a row from a column on, which are more than there are slots for.
pub(super) struct InTable<'t, F, D> {
    faces: &'t F,
    at: [i32; 2],
    depths: PhantomData<D>,
}

impl<'t, F, D> InTable<'t, F, D> {
    /// `at` is the first column, and the row.
    pub(super) fn new(faces: &'t F, at: [i32; 2]) -> Self {
        Self {
            faces,
            at,
            depths: PhantomData,
        }
    }
}

impl<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>> Crossing<S, H> for InTable<'_, F, D> {
    fn for_each(&self, mut visit: impl FnMut(&ActiveFace<S, H>)) {
        for_each_crossing(self.faces, self.at, &|_| true, &mut visit);
    }
}

/// A surface at the centre of a pixel.
#[derive(Debug, Copy, Clone)]
pub(super) struct Surface<W, D> {
    pub(super) face: u16,
    pub(super) depth: D,
    /// `None` for a hole.
    pub(super) word: Option<W>,
}

/// A pixel through which the silhouette of one of several surfaces passes.
#[derive(Debug, Copy, Clone)]
struct Crowded<W, D> {
    column: i32,
    /// The face and the depth of the edge.
    face: u16,
    depth: D,
    /// Surfaces in the pixel by area: whole ones, and the part of the one that ends here.
    whole: i32,
    coverage: Coverage,
    /// The word that the pixel of the band had before the row was drawn.
    before: W,
    /// Surfaces at the centre of the pixel, and the nearest two of them, as far as there are so many.
    surfaces: i32,
    nearest: Surface<W, D>,
    second: Surface<W, D>,
}

impl<W: PixelWord, D: DepthWidth> Crowded<W, D> {
    const EMPTY: Self = {
        let none = Surface {
            face: 0,
            depth: D::FARTHEST,
            word: None,
        };
        Self {
            column: 0,
            face: 0,
            depth: D::FARTHEST,
            whole: 0,
            coverage: 0,
            before: W::ZERO,
            surfaces: 0,
            nearest: none,
            second: none,
        }
    };
}

/// Pixels with several surfaces for which the faces of the row are looked through at once, at most.
const BATCH: usize = 8;

/// The coverage from which on a surface that ends at one edge may be at the centre of the pixel: at 1/2, and coverage is known to
/// 1/32.
const BESIDE_CENTRE: Coverage = Coverage::MAX / 2 - Coverage::MAX / 32;

/// Mixes all pixels of a row through which silhouettes pass, and leaves the columns empty.
#[inline(never)]
pub(super) fn mix_silhouettes<S, O, D, H, F>(
    faces: &F,
    row: &mut DepthRow<'_, H::Color, O, D>,
    edges: &mut EdgeRow<'_, WordOf<H>, D>,
    crossing: &impl Crossing<S, H>,
) where
    S: ScreenPrecision,
    O: Order,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    if edges.is_untouched() {
        return;
    }
    let mut area = Wrapping(0);
    let mut crowded = Vec::<_, BATCH>::new();
    let EdgeRow { columns, touched, .. } = edges;
    touched.for_each_run(|run| {
        let first = run.start;
        let columns = columns.get_mut(first..).unwrap_or_default();
        for (index, edge) in run.zip(columns) {
            area += edge.change;
            edge.change = 0;
            let marked = edge.face;
            if marked == 0 {
                continue;
            }
            edge.face = 0;
            let part = (area.0 & ((1 << AREA_BITS) - 1)) * i32::from(Coverage::MAX) + (1 << (AREA_BITS - 1));
            let coverage = (part >> AREA_BITS) as Coverage;
            if coverage == 0 {
                continue;
            }
            let whole = area.0 >> AREA_BITS;
            let (Some(pixel), Some(depth)) = (row.words.get(index), row.depths.get(index)) else {
                continue;
            };
            let (column, before) = (index as i32, O::reorder(edge.behind));
            let face = (marked & !EdgeColumn::<WordOf<H>, D>::ONE_EDGE) - 1;
            let is_beside = marked & EdgeColumn::<WordOf<H>, D>::ONE_EDGE != 0 && coverage < BESIDE_CENTRE && whole > 0;
            if is_beside && edge.depth < *depth {
                // The surface that ends here is not at the centre, and hidden.
                continue;
            }
            let behind = if *depth == D::FARTHEST {
                // No surface is at the centre of the pixel.
                Some(before)
            } else if is_beside && !H::Attributes::VARY {
                Some(O::reorder(*pixel))
            } else {
                None
            };
            if let Some(behind) = behind {
                if let Some(word) = word_of_face(faces, face, [column, row.y], row.left, crossing) {
                    mix::<_, _, _, _, F>(row, column, word, behind, coverage);
                }
            } else if whole == 0 {
                // One surface, which is at the centre.
                let word = O::reorder(*pixel);
                mix::<_, _, _, _, F>(row, column, word, before, coverage);
            } else {
                if crowded.is_full() {
                    mix_crowded(faces, row, &mut crowded, crossing);
                    crowded.clear();
                }
                let pushed = crowded.push(Crowded {
                    column,
                    face,
                    depth: edge.depth,
                    whole,
                    coverage,
                    before,
                    ..Crowded::EMPTY
                });
                debug_assert!(pushed.is_ok(), "room was made");
            }
        }
    });
    mix_crowded(faces, row, &mut crowded, crossing);
}

/// Mixes a pixel.
#[inline]
pub(super) fn mix<S, O, D, H, F>(
    row: &mut DepthRow<'_, H::Color, O, D>,
    column: i32,
    word: WordOf<H>,
    behind: WordOf<H>,
    coverage: Coverage,
) where
    S: ScreenPrecision,
    O: Order,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    if let Some(pixel) = row.words.get_mut(column as usize) {
        let position = Point::new(column + row.left, row.y);
        *pixel = O::reorder(F::mix(word, behind, coverage, position));
    }
}

/// Mixes the pixels of a batch, which come from left to right.
#[inline(never)]
fn mix_crowded<S, O, D, H, F>(
    faces: &F,
    row: &mut DepthRow<'_, H::Color, O, D>,
    crowded: &mut [Crowded<WordOf<H>, D>],
    crossing: &impl Crossing<S, H>,
) where
    S: ScreenPrecision,
    O: Order,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    let (Some(leftmost), Some(rightmost)) = (crowded.first(), crowded.last()) else {
        return;
    };
    let [leftmost, rightmost] = [leftmost, rightmost].map(|pixel| pixel.column);
    let at = [row.y, row.left];
    crossing.for_each(|face| {
        let [start, end] = face.span();
        // Most faces are elsewhere.
        if rightmost < start || end <= leftmost || face.is_translucent() {
            return;
        }
        for pixel in &mut *crowded {
            if pixel.column >= end {
                break;
            }
            if pixel.column >= start {
                add_surface(faces, pixel, face, at);
            }
        }
    });
    for pixel in crowded {
        if let Some((word, behind)) = mixed(faces, pixel, at, crossing) {
            mix::<_, _, _, _, F>(row, pixel.column, word, behind, pixel.coverage);
        }
    }
}

/// Adds a face that is at the centre of a pixel to its surfaces.
#[inline(always)]
fn add_surface<S, D, H, F>(faces: &F, pixel: &mut Crowded<WordOf<H>, D>, face: &ActiveFace<S, H>, [y, left]: [i32; 2])
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    let at = [pixel.column, y];
    let surface = Surface {
        face: face.node,
        depth: D::from_interpolated(face.plane.at(pixel.column, y).0),
        word: word_of(faces, face, at, left),
    };
    if pixel.surfaces == 0 || is_before(faces, &surface, &pixel.nearest) {
        (pixel.nearest, pixel.second) = (surface, pixel.nearest);
    } else if pixel.surfaces == 1 || is_before(faces, &surface, &pixel.second) {
        pixel.second = surface;
    }
    pixel.surfaces += 1;
}

/// Returns the two words that are mixed in a pixel with several surfaces: that of the surface whose silhouette passes through
/// the pixel, and that of the surface behind it; `None` where the silhouette is hidden.
#[inline]
fn mixed<S, D, H, F>(
    faces: &F,
    pixel: &Crowded<WordOf<H>, D>,
    [y, left]: [i32; 2],
    crossing: &impl Crossing<S, H>,
) -> Option<(WordOf<H>, WordOf<H>)>
where
    S: ScreenPrecision,
    D: DepthWidth,
    H: Shading,
    F: FaceTable<S, D, H>,
{
    let Crowded { nearest, second, .. } = pixel;
    if pixel.surfaces == 0 {
        return None;
    }
    if pixel.surfaces > pixel.whole {
        // The surface that ends here is at the centre of the pixel.
        let behind = if pixel.surfaces == 1 {
            pixel.before
        } else if ends(faces, (pixel.face, pixel.depth), nearest, second) {
            second.word.unwrap_or(pixel.before)
        } else {
            return None;
        };
        return nearest.word.map(|word| (word, behind));
    }
    if pixel.depth < nearest.depth {
        return None;
    }
    let word = word_of_face(faces, pixel.face, [pixel.column, y], left, crossing)?;
    Some((word, nearest.word.unwrap_or(pixel.before)))
}

/// Whether it is the nearest of two surfaces that ends at an edge, of which the face and the depth are known: that which has
/// the face of the edge or one with a common corner; of two such, or none, that which is nearer to the edge. An edge in front
/// of both, or behind both, needs no look.
pub(super) fn ends<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    (face, depth): (u16, D),
    nearest: &Surface<WordOf<H>, D>,
    second: &Surface<WordOf<H>, D>,
) -> bool {
    if depth >= nearest.depth || depth <= second.depth {
        return depth >= nearest.depth;
    }
    let corners = |face: u16| corners_of(faces, face);
    let of_edge = corners(face);
    let is_next_to = |surface: &Surface<WordOf<H>, D>| match (of_edge, corners(surface.face)) {
        (Some(of_edge), Some(corners)) => of_edge.into_iter().any(|corner| corners.contains(&corner)),
        _ => false,
    };
    let distance = |surface: &Surface<WordOf<H>, D>| (depth.units() - surface.depth.units()).abs();
    // In this order, because for most edges the second one needs no look.
    if distance(second) >= distance(nearest) {
        is_next_to(nearest) || !is_next_to(second)
    } else {
        is_next_to(nearest) && !is_next_to(second)
    }
}

/// The corners of a face, clockwise.
#[inline(never)]
fn corners_of<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
) -> Option<[&ScreenVertex<S, D>; 3]> {
    faces.face(node).map(|(corners, _)| corners)
}

/// Whether a surface is in front of another one: nearer, or as near and first in the order of the models.
#[inline]
fn is_before<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    surface: &Surface<WordOf<H>, D>,
    other: &Surface<WordOf<H>, D>,
) -> bool {
    surface.depth > other.depth || (surface.depth == other.depth && faces.order(surface.face) < faces.order(other.face))
}

/// The word of a face at a pixel of the row that it covers, or that is beside it: attributes are at most those of its corners.
#[inline]
pub(super) fn word_of<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    faces: &F,
    face: &ActiveFace<S, H>,
    [column, row]: [i32; 2],
    left: i32,
) -> Option<WordOf<H>> {
    if H::Attributes::VARY {
        shaded_word_of(faces, face, [column, row], left)
    } else {
        Some(face.word)
    }
}

#[inline(never)]
fn shaded_word_of<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    faces: &F,
    face: &ActiveFace<S, H>,
    [column, row]: [i32; 2],
    left: i32,
) -> Option<WordOf<H>> {
    let skin = faces.skin(face.node)?;
    let mut values = run::<S, D, H, F>(face, [column, column + 1], [column, row], left).values;
    let attributes = faces.attributes(face.node, |of_corners| of_corners)?;
    H::Attributes::clamp(&mut values, attributes.each_ref().map(Borrow::borrow));
    F::fragment(skin, face.word, &values)
}

/// The word of a face at a pixel of the row beside it.
#[inline]
pub(super) fn word_of_face<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    faces: &F,
    node: u16,
    at: [i32; 2],
    left: i32,
    crossing: &impl Crossing<S, H>,
) -> Option<WordOf<H>> {
    if !H::Attributes::VARY {
        return faces.word(node);
    }
    let mut found = None;
    crossing.for_each(|face| {
        if face.node == node {
            found = word_of(faces, face, at, left);
        }
    });
    found.or_else(|| word_of_absent_face(faces, node, at, left))
}

/// The word of a face at a pixel of the row beside it, which it does not cross.
#[cold]
#[inline(never)]
fn word_of_absent_face<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
    faces: &F,
    node: u16,
    at: [i32; 2],
    left: i32,
) -> Option<WordOf<H>> {
    let face = face_in_first_row(faces, node, &surroundings(faces, left))?;
    word_of(faces, &face, at, left)
}
