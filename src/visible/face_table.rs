//! The faces of a prepared frame as the row loop reads them: by their first row, each with its corners and its colour.

use core::{borrow::Borrow, num::Wrapping};

use embedded_graphics::geometry::Point;

use crate::{
    coverage::Coverage,
    geometry::Window,
    shade::{Planes, Shading},
    view::{DepthWidth, Position, ScreenPrecision, ScreenVertex},
    visible::{
        active_face::{ActiveFace, LeftOver, Surroundings, WordOf, from_top},
        count::Count,
    },
};

/// The index that stands for no node and no slot.
pub(crate) const NONE: u16 = u16::MAX;

/// The corners of a face, clockwise on the screen, and its colour.
pub type ColoredFace<'t, S, D, H> = ([&'t ScreenVertex<S, D>; 3], WordOf<H>);

// Not re-exported.
/// The faces of a prepared frame, by the row in which they begin. Entries of one row come in ascending order.
pub trait FaceTable<S: ScreenPrecision, D: DepthWidth, H: Shading> {
    /// Whether rows with more faces than slots are drawn in passes.
    const DRAWS_IN_PASSES: bool;
    /// Whether what varies evenly in space does so on the screen: whether rays are parallel.
    const IS_ORTHOGRAPHIC: bool;
    /// Whether faces are seen from both sides: then those that face away are in the table, too, the other way round.
    const DRAWS_BACKS: bool;
    /// Whether silhouettes are drawn by area.
    const ANTIALIASES: bool;
    /// What counts.
    type Count<'c>: Count
    where
        Self: 'c;
    /// Where it is counted what drawing takes.
    fn count(&self) -> Self::Count<'_>;
    /// The pixels that the frame was prepared for.
    fn viewport(&self) -> &Window;
    /// How many more faces cross a row of the viewport than the row above it, modulo 2^16: fewer cross any row.
    fn change(&self, row: i32) -> Wrapping<u16>;
    /// First of the faces that begin in a row, or [`NONE`].
    fn first_in_row(&self, row: i32) -> u16;
    /// The face after a node that begins in the same row, or [`NONE`].
    fn next(&self, node: u16) -> u16;
    /// A number that the nodes do not exceed: of all faces, and of the fragments for which there is room.
    fn most_nodes(&self) -> usize;
    /// Index of a node in the order of models and faces.
    fn order(&self, node: u16) -> u16;
    /// The face of a node, with its colour, where it is found without a search: that of the first model, if it was not cut.
    fn face_of_first_model(&self, node: u16) -> Option<ColoredFace<'_, S, D, H>>;
    /// The face of a node, with its colour, where it has to be searched.
    fn other_face(&self, node: u16) -> Option<ColoredFace<'_, S, D, H>>;
    /// The face of a node, with its colour; `None` where there is no such node.
    #[inline]
    fn face(&self, node: u16) -> Option<ColoredFace<'_, S, D, H>> {
        self.face_of_first_model(node).or_else(|| self.other_face(node))
    }
    /// The colour of the face of a node; `None` where there is no such node.
    fn word(&self, node: u16) -> Option<WordOf<H>>;
    /// The attributes of a corner, or where they are.
    type CornerAttributes<'c>: Copy + Borrow<H::Attributes>
    where
        Self: 'c;
    /// The attributes of the corners of a node, in the order into which what belongs to its corners is put.
    fn attributes(
        &self,
        node: u16,
        in_order: impl FnOnce([u16; 3]) -> [u16; 3],
    ) -> Option<[Self::CornerAttributes<'_>; 3]>;
    /// What a model has beside its mesh.
    type Skin: Copy;
    /// What the model of a node has beside its mesh.
    fn skin(&self, node: u16) -> Option<&Self::Skin>;
    /// The word of a pixel, in the machine's byte order; `None` for a hole ([`Shading::fragment`]).
    fn fragment(
        skin: &Self::Skin,
        face: WordOf<H>,
        attributes: &<H::Attributes as Planes>::Values,
    ) -> Option<WordOf<H>>;
    /// Whether the face of a node is mixed with what is behind it.
    fn is_translucent(&self, node: u16) -> bool {
        H::BLENDS && self.skin(node).is_some_and(Self::is_blended)
    }
    /// Whether the faces of a model are mixed with what is behind them ([`Shading::is_translucent`]).
    fn is_blended(skin: &Self::Skin) -> bool;
    /// The word of a pixel, mixed with the one behind it, both in the machine's byte order ([`Shading::blend`]).
    fn blend(skin: &Self::Skin, fragment: WordOf<H>, behind: WordOf<H>, position: Point) -> WordOf<H>;
    /// The word of a pixel of which a part is covered, all of them in the machine's byte order.
    fn mix(fragment: WordOf<H>, behind: WordOf<H>, coverage: Coverage, position: Point) -> WordOf<H>;
}

/// Sets up the parts of a face that are not small.
// It is looked up once more, because what is handed over has to be in memory, for the many small ones too.
#[cold]
#[inline(never)]
pub(super) fn set_up_rest<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    face: &mut ActiveFace<S, H>,
    faces: &impl FaceTable<S, D, H>,
    left_over: LeftOver,
    surroundings: &Surroundings<'_>,
) {
    if let Some(corners) = corners_from_top(faces, face.node) {
        face.set_up_rest(left_over, corners, surroundings);
    }
}

#[cold]
#[inline(never)]
pub(super) fn corners_from_top<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
) -> Option<[&ScreenVertex<S, D>; 3]> {
    faces.face(node).map(|(corners, _)| from_top(corners))
}

/// Whether a face covers a pixel. Computed from its corners, because its edges were stepped past the row.
pub(super) fn covers<S: ScreenPrecision, D: DepthWidth, H: Shading>(
    faces: &impl FaceTable<S, D, H>,
    node: u16,
    column: i32,
    row: i32,
) -> bool {
    match corners_from_top(faces, node) {
        Some(corners) => covers_center(corners, column, row),
        None => false,
    }
}

/// Whether a face with these corners, clockwise, covers a pixel.
fn covers_center<S: ScreenPrecision, D: DepthWidth>(
    [a, b, c]: [&ScreenVertex<S, D>; 3],
    column: i32,
    row: i32,
) -> bool {
    let center = Position {
        x: column << S::FRACTION_BITS,
        y: row << S::FRACTION_BITS,
    };
    [(a, b), (b, c), (c, a)]
        .into_iter()
        .all(|(start, end)| is_right_of(center, start.position(), end.position()))
}

/// Whether a pixel centre is on the inner side of an edge of a face whose corners run clockwise, or on a top or left one.
fn is_right_of(center: Position, start: Position, end: Position) -> bool {
    let (width, height) = (end.x - start.x, end.y - start.y);
    let (x, y) = (center.x - start.x, center.y - start.y);
    // Differences below 2^24.
    let side = i64::from(width) * i64::from(y) - i64::from(height) * i64::from(x);
    // Going up, or level and to the right.
    let is_top_or_left = i64::from(height) << 32 < i64::from(width);
    side > 0 || (side == 0 && is_top_or_left)
}
