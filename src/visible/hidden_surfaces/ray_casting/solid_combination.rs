//! Constructive solid geometry along a ray: solids combined by union, intersection and difference.
//!
//! ```text
//!                        A                        Where the ray of a pixel meets the faces of closed solids, it goes into them
//!                  .-----------.                  and out of them in turn. Sorted by depth, these crossings say for each part
//!     eye ---------|-----.-----|-----.------>     of the ray in which solids it is, and so whether it is in the combination.
//!                  '-----|-----'     |            The pixel shows the first face at which that changes:
//!                        '-----------'
//!                        |     B     |            union             the front of A
//!          in A    ======------======             intersection      the front of B
//!     A - B seen   *                              A - B             the front of A
//!     B - A seen               *                  B - A             the back of A, from inside
//! ```
//!
//! No new face is computed: the faces are those of the solids, and of some of them the back is seen.
//!
//! # A solid that is cut open
//!
//! Far away a ray is outside of all solids. Where it meets the faces of a solid an odd number of times, it begins inside: the near
//! plane has cut the solid open, and there is no face where it is cut. The pixel shows the first face at which something changes,
//! which is the wall on the other side. Solids are not to reach behind a far plane: those that do count as cut open, too.
//!
//! Guarantees: of the faces that cover a pixel, in the order of their stored depths and of equally near ones in the order of models,
//! the first one at which the combination begins or ends. For two solids that do not touch, the union is the picture of the depth
//! row. Cost: a walk down a tree of boxes for each pixel; a test of the sides of each face that it comes to; the plane of each face
//! that covers the pixel, and sorting these by insertion. With too little room for them the nearest ones are selected, then those
//! behind them, and so on, each time by another walk.
//!
//! Source: Roth 1982, "Ray casting for modeling solids"; the operations on solids: Requicha and Voelcker 1977, "Constructive solid
//! geometry".

use crate::{
    geometry::{TooSmall, Window},
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::{FaceTable, NONE, covers},
        hidden_surfaces::{
            placed::{face_from_row, paint_row},
            ray_casting::{
                box_tree::BoxTree,
                solid_tree::{SolidNode, Solids, is_inside, solids_of},
            },
        },
        painter::Painter,
        visibility::Method,
    },
};

/// Solids combined by union, intersection and difference, drawn by rays ([`Visibility`](crate::visible::Visibility)): for at most
/// `FACES` faces that begin above the lower side of the window, and with room for the `CROSSINGS` of a ray with faces.
///
/// A solid is a range of faces that together have no hole: a closed mesh, or several of them that do not go through each other.
/// Faces in no solid are not drawn. The look has to be [`DoubleSided`](crate::scene::DoubleSided), because a hole that is
/// drilled into a solid shows the faces of the drill from behind; with any other look it does not compile. Unlike that of all other
/// methods the picture is not that of the depth row.
///
/// A ray with more crossings than there is room for takes several passes, which are [counted](Self::passes); the picture is the same. Where the near plane cuts a solid open, the wall behind is seen from inside.
///
/// RAM: 14 bytes a face, 8 a crossing, and 16.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     band::Band,
///     scene::{Camera, DoubleSided, FaceSet, Memory, Model, Pose},
///     visible::{SolidCombination, SolidNode},
/// };
///
/// /// A pyramid without the tip of another one that is nearer: the first has faces 0 to 3, the second 4 to 7.
/// const CUT: [SolidNode; 3] = [SolidNode::Primitive(0..4), SolidNode::Primitive(4..8), SolidNode::Difference];
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let faces = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
/// let large = FaceSet::new(&[[0, 0, 1000], [-800, -800, 1500], [0, 800, 1500], [800, -800, 1500]], &faces)?;
/// let small = FaceSet::new(&[[0, 0, 1200], [-150, -150, 800], [0, 150, 800], [150, -150, 800]], &faces)?;
/// let models = [Model::new(large, &[Rgb565::RED; 4])?, Model::new(small, &[Rgb565::BLUE; 4])?];
/// let mut memory = Memory::<DoubleSided<Rgb565>, 8, 8, 64, 64>::new();
/// let mut scene = memory.prepare(&camera, &models)?;
///
/// let mut words = [0; 64 * 64];
/// let mut solids = SolidCombination::<8, 4>::new(&CUT);
/// scene.draw_by(&mut solids, &mut Band::<Rgb565>::new(area, &mut words)?)?;
/// // The small one is nearer, but what is seen of it is the dent in the large one.
/// let count = |color: Rgb565| words.iter().filter(|word| **word == color.into_storage()).count();
/// assert!(count(Rgb565::BLUE) > 0 && count(Rgb565::BLUE) < count(Rgb565::RED));
/// assert_eq!(solids.passes(), 64 * 64);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
///
/// Source: Roth 1982.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SolidCombination<'t, const FACES: usize, const CROSSINGS: usize> {
    tree: &'t [SolidNode],
    boxes: BoxTree<FACES>,
    crossings: [Crossing; CROSSINGS],
    passes: u32,
    faces_tested: u32,
}

/// Where a ray meets a face.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Crossing {
    /// The face's interpolated depth.
    depth: u32,
    node: u16,
}

impl Crossing {
    const NONE: Self = Self { depth: 0, node: NONE };

    /// Whether a ray comes to a crossing before another one.
    fn is_before<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &self,
        other: &Self,
        faces: &impl FaceTable<S, D, H>,
    ) -> bool {
        let (depth, other_depth) = (D::from_interpolated(self.depth), D::from_interpolated(other.depth));
        if depth != other_depth {
            return depth > other_depth;
        }
        // Two fragments of a face have the same order.
        (faces.order(self.node), self.node) < (faces.order(other.node), other.node)
    }
}

/// What a ray has met behind a crossing.
#[derive(Debug, Copy, Clone)]
struct Met {
    crossings: usize,
    /// How many of them are in the table, the nearest ones.
    kept: usize,
    /// The solids with an odd number of crossings.
    odd: Solids,
}

impl<'t, const FACES: usize, const CROSSINGS: usize> SolidCombination<'t, FACES, CROSSINGS> {
    /// The combination that a tree in postorder names: operations behind their operands, so that (A or B) without C is A, B,
    /// [`Union`](SolidNode::Union), C, [`Difference`](SolidNode::Difference).
    ///
    /// An operation without two operands before it takes the empty solid for those that are missing, and of several trees the last
    /// one counts. Solids after the 32nd are empty, and so are the first ones of more than 32 that wait for an operation.
    pub const fn new(tree: &'t [SolidNode]) -> Self {
        Self {
            tree,
            boxes: BoxTree::new(),
            crossings: [Crossing::NONE; CROSSINGS],
            passes: 0,
            faces_tested: 0,
        }
    }

    /// How often a ray was sent through the scene since the method was made, modulo 2^32: once for each pixel, and once more for each
    /// time that its crossings did not fit.
    pub const fn passes(&self) -> u32 {
        self.passes
    }

    /// How often a ray was tested to meet a face since the method was made, modulo 2^32.
    pub const fn faces_tested(&self) -> u32 {
        self.faces_tested
    }

    /// The node of the face that is seen in a pixel of a row, or [`NONE`], of so many faces. `at` are the first column of the row,
    /// from which the column counts, and the row.
    fn seen_in<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        count: usize,
        at: ([i32; 2], i32),
    ) -> u16 {
        let mut one = [Crossing::NONE];
        let mut after = None;
        let mut inside: Option<(Solids, bool)> = None;
        loop {
            let met = self.pass(faces, count, (at, after), &mut one);
            let (mut solids, begins_inside) = inside.unwrap_or((met.odd, is_inside(self.tree, met.odd)));
            let table: &[Crossing] = if CROSSINGS == 0 { &one } else { &self.crossings };
            for crossing in table.iter().take(met.kept) {
                solids ^= solids_of(self.tree, faces.order(crossing.node));
                if is_inside(self.tree, solids) != begins_inside {
                    return crossing.node;
                }
                after = Some(*crossing);
            }
            if met.kept == met.crossings {
                return NONE;
            }
            inside = Some((solids, begins_inside));
        }
    }

    /// Sends a ray through the scene, and puts the first crossings with faces of solids into the table, after one of them. In a
    /// method without a table there is room for one.
    fn pass<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        count: usize,
        ((at, column), after): (([i32; 2], i32), Option<Crossing>),
        one: &mut [Crossing],
    ) -> Met {
        let [first_column, row] = at;
        let pixel = [first_column + column, row];
        let table = if CROSSINGS == 0 { one } else { &mut self.crossings };
        let (tree, faces_tested) = (self.tree, &mut self.faces_tested);
        self.passes = self.passes.wrapping_add(1);
        let nothing = Met {
            crossings: 0,
            kept: 0,
            odd: 0,
        };
        self.boxes.fold(
            (count, pixel),
            nothing,
            |_| i32::MIN,
            |met, node| {
                let solids = solids_of(tree, faces.order(node));
                *faces_tested = faces_tested.wrapping_add(1);
                if solids == 0 || !covers(faces, node, first_column + column, row) {
                    return met;
                }
                let Some((face, _)) = face_from_row(faces, node, at) else {
                    return met;
                };
                let depth = face.plane.at(column, row).0;
                let crossing = Crossing { depth, node };
                if after.is_some_and(|after| !after.is_before(&crossing, faces)) {
                    return met;
                }
                Met {
                    crossings: met.crossings + 1,
                    kept: insert(table, met.kept, crossing, |a, b| a.is_before(b, faces)),
                    odd: met.odd ^ solids,
                }
            },
        )
    }
}

/// Inserts a crossing into a table with so many of them in order; the last one of all falls out where there is no room. Returns how
/// many there are.
fn insert(
    table: &mut [Crossing],
    kept: usize,
    crossing: Crossing,
    is_before: impl Fn(&Crossing, &Crossing) -> bool,
) -> usize {
    let mut last = crossing;
    for entry in table.iter_mut().take(kept) {
        if is_before(&last, entry) {
            core::mem::swap(&mut last, entry);
        }
    }
    match table.get_mut(kept) {
        Some(entry) => {
            *entry = last;
            kept + 1
        }
        None => kept,
    }
}

impl<D: DepthWidth, const FACES: usize, const CROSSINGS: usize> Method<D> for SolidCombination<'_, FACES, CROSSINGS> {
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        const {
            assert!(
                F::DRAWS_BACKS,
                "of combined solids backs are seen: only looks that are `DoubleSided` have them"
            )
        }
        let count = self.boxes.build(faces, window, painter)?;
        for row in window.top..window.bottom {
            let at = [window.left, row];
            paint_row(painter, faces, at, 0..window.width() as i32, |column| {
                self.seen_in(faces, count, (at, column))
            });
        }
        Ok(())
    }
}
