//! The memory of a scene, with all its capacities.

use crate::{
    geometry::InputError,
    scene::{
        Frame, Look, Model, Prepared,
        frame::{RowStart, StoredOf, Tables},
        silhouette_tables::{ColumnOf, FaceEdgesOf, RowTables, RowTablesOf, SilhouetteTables},
        stored_attributes::{Stored, StoredAttributes},
    },
    view::{Camera, DepthWidth, ScreenPrecision, ScreenVertex},
    visible::{ActiveFace, ActiveFaces, Entry, LookVisibility},
};

/// A slot of the active list.
type SlotOf<L> = ActiveFace<<L as Look>::Precision, <L as Look>::Shading>;

/// All memory of a scene but for its meshes and the rows of colours: what is prepared once a frame, and the depth row. It is
/// the one type that names the capacities; what is done with it has one parameter, the [`Look`].
///
/// - `L`: what pictures are made of; a colour, such as `Rgb565`, another [`Shading`](crate::shade::Shading), or a wrapped [`Look`].
/// - `VERTICES`: vertices of all models ([`FaceSet::vertices_of`](crate::scene::FaceSet::vertices_of)), and where faces are cut
///   ([`Look::CLIPS`]) 4 for each fragment of a face that the near plane, the far plane or the guard band cuts (a cut face has 1 to 7
///   fragments; [`Prepared::vertices_needed`] says how many it took). At most 32,767.
/// - `FACES`: faces of all models ([`FaceSet::faces_of`](crate::scene::FaceSet::faces_of)). At most 32,767.
/// - `WIDTH` and `HEIGHT`: columns and rows of the viewport.
/// - `ACTIVE`: slots for faces that cross the same row, at least 1 and at most 65,535; 64 where it is not named. A row with more
///   faces is drawn in passes ([`Look::DRAWS_IN_PASSES`]): the picture is the same, and takes longer.
///   [`Prepared::active_needed`] says with how many each row takes one pass.
///
/// RAM for a colour as the look: 6 bytes a vertex, 2 a face, 2 a column, 4 a row, 48 an active face, and 48. What varies over
/// faces takes 2 bytes a vertex for each of its [`Attributes`](crate::shade::Attributes) (none for texture coordinates, where
/// no face is cut) and 12 an active face; silhouettes that are [`Antialiased`](crate::scene::Antialiased) take 12 bytes a
/// column, 4 a face, 4 a row, and 896, and a method that a look names ([`VisibleBy`](crate::scene::VisibleBy)) what it says.
/// All zero bits when new, but for some methods, so that a `static` lies in `.bss`.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use zrow::scene::{FaceSet, Memory};
///
/// const TETRAHEDRON: FaceSet = match FaceSet::new(
///     &[[0, 0, 0], [512, 0, 0], [0, 512, 0], [0, 0, 512]],
///     &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
/// ) {
///     Ok(faces) => faces,
///     Err(_) => panic!("a face names a vertex that is not there"),
/// };
/// /// Two of them on a panel of 240 x 320 pixels, which take five fragments when they come near.
/// type Scene = Memory<
///     Rgb565,
///     { FaceSet::vertices_of(&[TETRAHEDRON, TETRAHEDRON]) + 4 * 5 },
///     { FaceSet::faces_of(&[TETRAHEDRON, TETRAHEDRON]) },
///     240,
///     320,
///     8,
/// >;
/// assert_eq!(size_of::<Scene>(), 6 * 28 + 2 * 8 + 2 * 240 + 4 * 320 + 48 * 8 + 48);
/// ```
#[derive(Debug)]
pub struct Memory<
    L: Look,
    const VERTICES: usize,
    const FACES: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIVE: usize = 64,
> {
    vertices: [ScreenVertex<L::Precision, L::Depth>; VERTICES],
    attributes: [StoredOf<L>; VERTICES],
    next: [u16; FACES],
    rows: [RowStart; HEIGHT],
    depths: [L::Depth; WIDTH],
    edges_of_row: RowTablesOf<L, [ColumnOf<L>; WIDTH]>,
    edges_of_faces: [FaceEdgesOf<L>; FACES],
    edges_of_rows: [FaceEdgesOf<L>; HEIGHT],
    active: ActiveFaces<[SlotOf<L>; ACTIVE]>,
}

impl<L: Look, const VERTICES: usize, const FACES: usize, const WIDTH: usize, const HEIGHT: usize, const ACTIVE: usize>
    Memory<L, VERTICES, FACES, WIDTH, HEIGHT, ACTIVE>
{
    /// Memory in which nothing is prepared yet.
    pub const fn new() -> Self {
        const {
            assert!(
                L::StoredAttributes::ARE_ALL || !L::CLIPS,
                "cut faces need all attributes of their vertices"
            )
        };
        Self {
            vertices: [ScreenVertex {
                x: L::Precision::ZERO,
                y: L::Precision::ZERO,
                z: L::Depth::FARTHEST,
            }; VERTICES],
            attributes: [StoredOf::<L>::ZERO; VERTICES],
            next: [0; FACES],
            rows: [RowStart::ZERO; HEIGHT],
            depths: [L::Depth::FARTHEST; WIDTH],
            edges_of_row: RowTables {
                active: Entry::EMPTY,
                visibility: LookVisibility::NEW,
                columns: [<ColumnOf<L> as Entry>::EMPTY; WIDTH],
            },
            edges_of_faces: [<FaceEdgesOf<L> as Entry>::EMPTY; FACES],
            edges_of_rows: [<FaceEdgesOf<L> as Entry>::EMPTY; HEIGHT],
            active: ActiveFaces::EMPTY,
        }
    }

    /// The memory without its capacities in the type: for functions that take the memory of any scene.
    pub const fn frame(&mut self) -> Frame<'_, L> {
        Frame {
            tables: Tables {
                vertices: &mut self.vertices,
                attributes: &mut self.attributes,
                next: &mut self.next,
                rows: &mut self.rows,
            },
            depths: &mut self.depths,
            silhouettes: SilhouetteTables {
                row: &mut self.edges_of_row,
                faces: &mut self.edges_of_faces,
                rows: &mut self.edges_of_rows,
            },
            active: &mut self.active,
        }
    }

    /// Prepares a frame, as [`Frame::prepare`] does.
    ///
    /// # Errors
    /// Those of [`Frame::prepare`].
    #[inline]
    pub fn prepare<'f, 'm>(
        &'f mut self,
        camera: &Camera,
        models: &'f [Model<'m, L::Shading>],
    ) -> Result<Prepared<'f, 'm, L>, InputError> {
        Prepared::new(self.frame(), camera, models)
    }
}

impl<L: Look, const VERTICES: usize, const FACES: usize, const WIDTH: usize, const HEIGHT: usize, const ACTIVE: usize>
    Default for Memory<L, VERTICES, FACES, WIDTH, HEIGHT, ACTIVE>
{
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(feature = "defmt")]
impl<L: Look, const VERTICES: usize, const FACES: usize, const WIDTH: usize, const HEIGHT: usize, const ACTIVE: usize>
    defmt::Format for Memory<L, VERTICES, FACES, WIDTH, HEIGHT, ACTIVE>
{
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Memory for {} vertices, {} faces, {} x {} pixels, {} active faces",
            VERTICES,
            FACES,
            WIDTH,
            HEIGHT,
            ACTIVE
        );
    }
}
