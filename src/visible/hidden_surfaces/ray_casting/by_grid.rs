//! Ray casting through a uniform grid: for each pixel a ray from the eye, through the cells of a box around all faces.
//!
//! ```text
//!          +-----+-----+-----+-----+        Each cell has a list of the faces whose boxes meet it. A ray comes to the cells in
//!          |     |     |  AA |     |        the order of their distances and asks the faces of each: where it has met one, it
//!          +-----+-----+-AA--+--..-+        stops at the first cell that is farther away than that.
//!          |     |    A|A .. | '   |
//!          +-----+--A..+-----+-----+        A face lies in many cells, but is asked once a ray: it remembers the number of
//!     eye -|- ' '| A   |     |     |        the ray that asked it last (its mailbox).
//!          +-----+-----+-----+-----+
//! ```
//!
//! The lists are parts of one table, in the order of cells, which is filled by counting. If it is too small for all cells, they
//! are made twice as large, again and again.
//!
//! Guarantees: the picture of the depth row, because a cell that a ray needs is never left out, and a face that is asked answers as
//! in all methods. Cost: building the grid for each window that is drawn, a few divisions for each face and ray and an addition
//! for each cell; a test of the sides of each face that a ray comes to and the plane of each that covers the pixel.
//!
//! Source: Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing"; the grid: Fujimoto, Tanaka and Iwata
//! 1986, "ARTS: accelerated ray-tracing system".

use core::ops::Range;

use crate::{
    geometry::{TooSmall, Window},
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::{FaceTable, NONE, corners_from_top, covers},
        hidden_surfaces::{
            placed::{for_each_node, nearer_of, paint_row},
            ray_casting::{
                depth_margin,
                eye_space::{EyeBox, EyeSpace},
                ray_march::{MOST_EARLY, RayMarch},
                uniform_grid::UniformGrid,
            },
        },
        painter::Painter,
        visibility::{Method, NewMethod},
    },
};

/// More cells for each face do not make lists shorter by as much as they take to march through.
const CELLS_FOR_EACH_FACE: usize = 8;

/// Ray casting through a uniform grid ([`Visibility`](crate::visible::Visibility)): rays march from the eye through at most
/// `CELLS` cells, whose lists have `ENTRIES` entries together, for at most `FACES` faces that are not all beside the window.
///
/// Take it to compare: on emulated chips, for 12 to 4,992 faces and for one or two walls, it took 0.95 to 3.9 times as many
/// instructions as the tree of [`RayCasting`](crate::visible::RayCasting), because cells are marched through for each ray. With fewer
/// cells or entries the picture is the same, and rays ask more faces; without any they ask all.
///
/// [`Prepared::picking`](crate::scene::Prepared::picking) asks the same grid which faces are seen in single pixels.
///
/// RAM: 4 bytes a face, 2 a cell and 2 an entry, and 16. Eight cells and sixteen entries for each face are much; more cells than
/// eight for each face are not used.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::I16F16;
/// use zrow::{
///     band::Band,
///     scene::{Camera, FaceSet, Memory, Model},
///     visible::GridRayCasting,
/// };
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mut memory = Memory::<Rgb565, 6, 2, 64, 64>::new();
/// let near = FaceSet::new(&[[-512, -512, 512], [0, 512, 512], [512, -512, 512]], &[[0, 1, 2]])?;
/// let far = FaceSet::new(&[[-512, -512, 700], [-512, 512, 700], [512, 512, 700]], &[[0, 1, 2]])?;
/// let models = [Model::new(near, &[Rgb565::RED])?, Model::new(far, &[Rgb565::BLUE])?];
/// let mut scene = memory.prepare(&camera, &models)?;
///
/// let (mut by_rows, mut by_rays) = ([0; 64 * 64], [0; 64 * 64]);
/// scene.draw(&mut Band::<Rgb565>::new(area, &mut by_rows)?);
/// let mut rays = GridRayCasting::<2, 16, 32>::new();
/// scene.draw_by(&mut rays, &mut Band::<Rgb565>::new(area, &mut by_rays)?)?;
/// assert_eq!(by_rows, by_rays);
/// // No ray asks a face twice.
/// assert!(rays.faces_tested() <= 2 * 64 * 64);
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
///
/// Source: Amanatides and Woo 1987.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GridRayCasting<const FACES: usize, const CELLS: usize, const ENTRIES: usize> {
    nodes: [u16; FACES],
    /// For each face the number of the ray that tested it last.
    mailboxes: [u16; FACES],
    /// For each cell the index of the first entry of its list, which ends where that of the next cell begins.
    starts: [u16; CELLS],
    /// The indices of faces in the lists of all cells.
    entries: [u16; ENTRIES],
    /// The number of the ray.
    ray: u16,
    faces_tested: u32,
    cells_visited: u32,
    mailbox_hits: u32,
}

/// The grid of some faces.
#[derive(Debug)]
struct Scene {
    space: EyeSpace,
    grid: UniformGrid,
    faces: usize,
    entries: usize,
    depth_margin: i32,
}

impl<const FACES: usize, const CELLS: usize, const ENTRIES: usize> GridRayCasting<FACES, CELLS, ENTRIES> {
    /// A grid without faces.
    pub const fn new() -> Self {
        Self {
            nodes: [0; FACES],
            mailboxes: [0; FACES],
            starts: [0; CELLS],
            entries: [0; ENTRIES],
            ray: 0,
            faces_tested: 0,
            cells_visited: 0,
            mailbox_hits: 0,
        }
    }

    /// How often a ray was tested to meet a face since the method was made, modulo 2^32.
    pub const fn faces_tested(&self) -> u32 {
        self.faces_tested
    }

    /// How many cells rays came to since the method was made, modulo 2^32.
    pub const fn cells_visited(&self) -> u32 {
        self.cells_visited
    }

    /// How often a ray came to a face that it had tested before, in another cell, since the method was made, modulo 2^32.
    pub const fn mailbox_hits(&self) -> u32 {
        self.mailbox_hits
    }

    /// Puts the faces whose boxes on the screen meet a window into a grid. `None` where there are none.
    fn build<S: ScreenPrecision, D: DepthWidth, H: Shading, F: FaceTable<S, D, H>>(
        &mut self,
        faces: &F,
        window: &Window,
    ) -> Result<Option<Scene>, TooSmall> {
        let (count, depths) = self.collect(faces, window);
        if count > FACES {
            return Err(TooSmall::Faces(count));
        }
        let viewport = faces.viewport();
        let space = EyeSpace::new::<S>(viewport, depths, F::IS_ORTHOGRAPHIC);
        self.mailboxes.fill(0);
        self.ray = 0;
        let boxes = (0..count).filter_map(|index| self.box_of(faces, &space, index));
        let Some(all) = boxes.reduce(EyeBox::around) else {
            return Ok(None);
        };
        let mut most_cells = CELLS.min(CELLS_FOR_EACH_FACE * count);
        loop {
            let grid = UniformGrid::new(&all, space.sides(&all), most_cells);
            let entries = if grid.cells() == 1 {
                Some(count)
            } else {
                self.fill_lists(faces, &space, &grid, count)
            };
            if let Some(entries) = entries {
                return Ok(Some(Scene {
                    space,
                    grid,
                    faces: count,
                    entries,
                    depth_margin: depth_margin(viewport),
                }));
            }
            most_cells = grid.cells() / 2;
        }
    }

    /// Takes the faces whose boxes on the screen meet a window, as far as there is room. Returns how many these are, and the least
    /// and the greatest depth of their corners in units.
    fn collect<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        window: &Window,
    ) -> (usize, [i32; 2]) {
        let (mut count, mut depths) = (0, [i32::MAX, 0]);
        for_each_node(faces, window, |node| {
            let Some([a, b, c]) = corners_from_top(faces, node) else {
                return;
            };
            let pixel = |units: i32| units >> S::FRACTION_BITS;
            let left = pixel(a.x_units().min(b.x_units()).min(c.x_units()));
            let right = pixel(a.x_units().max(b.x_units()).max(c.x_units()));
            let bottom = pixel(a.y_units().max(b.y_units()).max(c.y_units()));
            if left >= window.right || right < window.left || bottom < window.top {
                return;
            }
            if let Some(entry) = self.nodes.get_mut(count) {
                *entry = node;
            }
            count += 1;
            let [least, greatest] = depths;
            let [a, b, c] = [a, b, c].map(|corner| corner.z.units());
            depths = [least.min(a).min(b).min(c), greatest.max(a).max(b).max(c)];
        });
        (count, depths)
    }

    /// The box in eye space of a face by its index, with room for rays that turn into the next cell too early.
    fn box_of<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &self,
        faces: &impl FaceTable<S, D, H>,
        space: &EyeSpace,
        index: usize,
    ) -> Option<EyeBox> {
        let corners = corners_from_top(faces, *self.nodes.get(index)?)?;
        Some(space.box_of(corners).padded(space.padding(MOST_EARLY)))
    }

    /// Fills the lists of the cells of a grid, by counting. Returns how many entries there are, or `None` where there are too many.
    fn fill_lists<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        space: &EyeSpace,
        grid: &UniformGrid,
        count: usize,
    ) -> Option<usize> {
        let most = ENTRIES.min(u16::MAX.into());
        let mut entries = 0;
        self.starts.get_mut(..grid.cells())?.fill(0);
        for index in 0..count {
            let Some(face_box) = self.box_of(faces, space, index) else {
                continue;
            };
            grid.for_each_cell(&face_box, |cell| {
                entries += 1;
                if let (Some(start), true) = (self.starts.get_mut(cell), entries <= most) {
                    *start += 1;
                }
            });
            if entries > most {
                return None;
            }
        }
        let mut end = 0;
        for start in self.starts.get_mut(..grid.cells())? {
            end += *start;
            *start = end;
        }
        // Each list is filled from its end, where the next one begins.
        for index in (0..count).rev() {
            let Some(face_box) = self.box_of(faces, space, index) else {
                continue;
            };
            grid.for_each_cell(&face_box, |cell| {
                let Some(start) = self.starts.get_mut(cell) else {
                    return;
                };
                *start -= 1;
                if let Some(entry) = self.entries.get_mut(usize::from(*start)) {
                    *entry = index as u16;
                }
            });
        }
        Some(entries)
    }

    /// The entries of the list of a cell.
    fn entries_of(&self, scene: &Scene, cell: usize) -> Range<usize> {
        if scene.grid.cells() == 1 {
            return 0..scene.faces;
        }
        let start = |cell: usize| self.starts.get(cell).map_or(scene.entries, |start| usize::from(*start));
        let end = if cell + 1 < scene.grid.cells() {
            start(cell + 1)
        } else {
            scene.entries
        };
        start(cell)..end
    }

    /// Gives a ray its number.
    fn begin_ray(&mut self) {
        self.ray = self.ray.wrapping_add(1);
        if self.ray == 0 {
            self.mailboxes.fill(0);
            self.ray = 1;
        }
    }

    /// The node of a face by its entry in a list, where the ray has not tested it before.
    fn node_to_test(&mut self, scene: &Scene, entry: usize) -> Option<u16> {
        let index = if scene.grid.cells() == 1 {
            entry
        } else {
            usize::from(*self.entries.get(entry)?)
        };
        let mailbox = self.mailboxes.get_mut(index)?;
        if *mailbox == self.ray {
            self.mailbox_hits = self.mailbox_hits.wrapping_add(1);
            return None;
        }
        *mailbox = self.ray;
        self.faces_tested = self.faces_tested.wrapping_add(1);
        self.nodes.get(index).copied()
    }

    /// Builds the grid of all faces of a frame. What is returned answers which face is seen in a pixel of the viewport: its index
    /// in the order of models and faces.
    ///
    /// # Errors
    /// [`TooSmall::Faces`] with the number of faces, where that is more than there is room for.
    pub(crate) fn picking<'p, S, D, H, F>(
        &'p mut self,
        faces: &'p F,
    ) -> Result<impl FnMut([i32; 2]) -> Option<usize> + 'p, TooSmall>
    where
        S: ScreenPrecision + 'p,
        D: DepthWidth + 'p,
        H: Shading + 'p,
        F: FaceTable<S, D, H>,
    {
        let scene = self.build(faces, faces.viewport())?;
        Ok(move |pixel| {
            let node = self.cast(faces, scene.as_ref()?, (pixel, 0));
            (node != NONE).then(|| usize::from(faces.order(node)))
        })
    }

    /// The face that the ray through a pixel of a row meets first, or [`NONE`]. `at` are the first column of the row and the
    /// row; the column counts from there.
    fn cast<S: ScreenPrecision, D: DepthWidth, H: Shading>(
        &mut self,
        faces: &impl FaceTable<S, D, H>,
        scene: &Scene,
        (at, column): ([i32; 2], i32),
    ) -> u16 {
        let [first_column, row] = at;
        let pixel = [first_column + column, row];
        let Some(mut march) = RayMarch::enter(&scene.grid, &scene.space.ray::<S>(pixel)) else {
            return NONE;
        };
        self.begin_ray();
        let (mut seen, mut farthest) = ((D::FARTHEST, NONE), i32::MAX);
        loop {
            self.cells_visited = self.cells_visited.wrapping_add(1);
            for entry in self.entries_of(scene, scene.grid.index(march.cell())) {
                let Some(node) = self.node_to_test(scene, entry) else {
                    continue;
                };
                if covers(faces, node, first_column + column, row) {
                    seen = nearer_of(faces, node, (at, column), seen);
                    let (depth, _) = seen;
                    farthest = scene.space.farthest_distance(depth.units() - scene.depth_margin);
                }
            }
            if !march.step(farthest) {
                let (_, node) = seen;
                return node;
            }
        }
    }
}

impl<const FACES: usize, const CELLS: usize, const ENTRIES: usize> Default for GridRayCasting<FACES, CELLS, ENTRIES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<D: DepthWidth, const FACES: usize, const CELLS: usize, const ENTRIES: usize> NewMethod<D>
    for GridRayCasting<FACES, CELLS, ENTRIES>
{
    const NEW: Self = Self::new();
}

impl<D: DepthWidth, const FACES: usize, const CELLS: usize, const ENTRIES: usize> Method<D>
    for GridRayCasting<FACES, CELLS, ENTRIES>
{
    fn draw<S, H, F>(&mut self, faces: &F, window: &Window, painter: &mut impl Painter<S, H>) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        H: Shading,
        F: FaceTable<S, D, H>,
    {
        let Some(scene) = self.build(faces, window)? else {
            return Ok(());
        };
        for row in window.top..window.bottom {
            let at = [window.left, row];
            paint_row(painter, faces, at, 0..window.width() as i32, |column| {
                self.cast(faces, &scene, (at, column))
            });
        }
        Ok(())
    }
}
