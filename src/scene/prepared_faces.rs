//! The faces of a prepared frame, by the row in which they begin: how they are drawn, each looked up with its corners and its
//! colour when that row comes.

use core::{cell::Cell, fmt, num::Wrapping};

use embedded_graphics::geometry::Point;

use crate::{
    band::{Band, Multisampled},
    coverage::{Coverage, SamplePattern},
    geometry::{SubPixel, Window, offset_from},
    mesh::FaceSet,
    scene::{
        Look, Model,
        counters::Counting,
        faces,
        frame::{
            ActiveListOf, AttributesOf, FRAGMENT, FRAGMENT_VERTICES, RowStart, StoredOf, Tables, corners, is_whole,
        },
        model::outward,
        preparation::clockwise,
        silhouette_tables::EdgeTables,
        stored_attributes::{Stored, StoredAttributes},
    },
    shade::{Attributes, ChannelColor, Planes, Shading},
    surface::{BandColor, Order, Target},
    view::{Camera, Position, ScreenVertex},
    visible::{ColoredFace, Count, DepthRow, DepthUse, FaceTable, NONE, RowEdges, Silhouettes},
};

/// A face of a frame with its colour, as the row loop takes it.
type FaceOf<'a, L> = ColoredFace<'a, <L as Look>::Precision, <L as Look>::Depth, <L as Look>::Shading>;

/// What a model has beside its mesh, what is the same for all its vertices in the frame, and its mesh.
type SkinOf<'f, 'm, L> = (
    <<L as Look>::Shading as Shading>::Skin<'m>,
    UniformsOf<L>,
    &'f FaceSet<'m>,
);

/// What is the same for all vertices of a model in a frame.
pub(super) type UniformsOf<L> = <<L as Look>::Shading as Shading>::Uniforms;

/// What is the same for all vertices of models in a frame, as far as it is known.
pub(super) struct FrameUniforms<L: Look> {
    /// That of the first model.
    first: Option<UniformsOf<L>>,
    /// The number of the first face of the model that was asked for last, and that of this model.
    last: Option<(u32, UniformsOf<L>)>,
}

impl<L: Look> Copy for FrameUniforms<L> {}

impl<L: Look> Clone for FrameUniforms<L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<L: Look> FrameUniforms<L> {
    /// No model is known.
    pub(super) const NONE: Self = Self {
        first: None,
        last: None,
    };

    /// The first of some models is known.
    pub(super) fn of(models: &[Model<'_, L::Shading>], camera: &Camera) -> Self {
        let first = models.first();
        Self {
            first: first.map(|model| L::Shading::uniforms(model.skin(), &model.pose, camera)),
            last: None,
        }
    }
}

/// The memory that changes while the rows of a prepared frame are drawn: the active list, the depths of a row, and its
/// silhouettes.
pub(super) struct RowMemory<'r, L: Look> {
    pub(super) active: &'r mut ActiveListOf<L>,
    pub(super) depths: &'r mut [L::Depth],
    pub(super) silhouettes: EdgeTables<'r, L>,
}

impl<L: Look> RowMemory<'_, L> {
    /// The memory of rows, borrowed once more for a shorter time.
    pub(super) fn reborrow(&mut self) -> RowMemory<'_, L> {
        RowMemory {
            active: self.active,
            depths: self.depths,
            silhouettes: self.silhouettes.reborrow(),
        }
    }
}

/// The filled tables of a frame, and the models that they were filled from. Kept from row to row.
pub(super) struct PreparedFaces<'f, 'm, L: Look> {
    pub(super) vertices: &'f [ScreenVertex<L::Precision, L::Depth>],
    attributes: &'f [StoredOf<L>],
    pub(super) next: &'f [u16],
    pub(super) rows: &'f [RowStart],
    pub(super) models: &'f [Model<'m, L::Shading>],
    /// The faces of the first model, and its skin with its uniforms and its mesh.
    pub(super) first_faces: &'f [[u16; 3]],
    first_skin: Option<SkinOf<'f, 'm, L>>,
    pub(super) viewport: Window,
    pub(super) camera: Camera,
    /// The number of the first face of the model that was asked for last, and its uniforms.
    last_uniforms: Cell<Option<(u32, UniformsOf<L>)>>,
    pub(super) counting: L::Counting,
}

impl<'f, 'm, L: Look> PreparedFaces<'f, 'm, L> {
    pub(super) fn new(
        tables: Tables<'f, L>,
        models: &'f [Model<'m, L::Shading>],
        camera: &Camera,
        uniforms: FrameUniforms<L>,
    ) -> Self {
        let first = models.first();
        let first_faces = first.map_or(&[][..], |model| model.mesh().faces());
        Self {
            vertices: tables.vertices,
            attributes: tables.attributes,
            next: tables.next,
            rows: tables.rows,
            models,
            first_faces,
            first_skin: first
                .zip(uniforms.first)
                .map(|(model, uniforms)| (*model.skin(), uniforms, model.mesh())),
            viewport: camera.viewport(),
            camera: *camera,
            last_uniforms: Cell::new(uniforms.last),
            counting: L::Counting::default(),
        }
    }

    /// What is known of the models, to go on with in the next rows.
    pub(super) fn frame_uniforms(&self) -> FrameUniforms<L> {
        FrameUniforms {
            first: self.first_skin.as_ref().map(|(_, uniforms, _)| *uniforms),
            last: self.last_uniforms.get(),
        }
    }

    /// Draws the rows of a band, as they were prepared for a viewport, and hands each of them over.
    pub(super) fn draw<O: Order>(
        &self,
        rows: RowMemory<'_, L>,
        band: &mut Band<'_, L::Color, O>,
        depth_use: DepthUse,
        mut more: impl FnMut(&mut DepthRow<'_, L::Color, O, L::Depth>),
    ) {
        let RowMemory {
            active,
            depths,
            mut silhouettes,
        } = rows;
        let depth_use = if L::HURRIES { depth_use } else { DepthUse::Always };
        let window = self.viewport.intersection(&band.window());
        if window.width() == 0 {
            return;
        }
        for y in window.top..window.bottom {
            if let Some(mut row) = DepthRow::new(band, &window, y, depths) {
                self.counting.count().row();
                if L::IS_MULTISAMPLED {
                    self.draw_centres(active, &mut row);
                } else if L::Silhouettes::BY_AREA {
                    let edges = self.begin_silhouettes(&mut silhouettes, &row, active.is_at(&row));
                    self.draw_row(active, &mut row, depth_use, edges);
                } else {
                    self.draw_row(active, &mut row, depth_use, ());
                }
                more(&mut row);
            }
        }
    }

    /// Draws a row with one sample a pixel, in a look that may have several.
    fn draw_centres<O: Order>(&self, active: &mut ActiveListOf<L>, row: &mut DepthRow<'_, L::Color, O, L::Depth>) {
        if active.begin_samples(self, row) {
            active.draw_sample(self, row, Position { x: 0, y: 0 });
        } else {
            row.clear_depths();
        }
    }

    /// Draws the rows of a band into the samples of its pixels, as they were prepared for a viewport.
    pub(super) fn draw_samples<O: Order, P: SamplePattern>(
        &self,
        rows: RowMemory<'_, L>,
        target: &mut Multisampled<'_, L::Color, O, P>,
    ) where
        L::Color: ChannelColor,
    {
        let RowMemory { active, depths, .. } = rows;
        let whole = target.window();
        let window = self.viewport.intersection(&whole);
        if window.width() == 0 {
            return;
        }
        for y in window.top..window.bottom {
            let Some((mut band, samples)) = target.row_of_samples(y) else {
                continue;
            };
            let first = offset_from(whole.left, window.left) as usize * P::SAMPLES;
            let Some(samples) = samples.get_mut(first..) else {
                continue;
            };
            if let Some(mut row) = DepthRow::new(&mut band, &window, y, depths) {
                self.counting.count().row();
                if active.begin_samples(self, &row) {
                    self.draw_row_of_samples::<O, P>(active, &mut row, samples);
                }
            }
        }
    }

    #[inline(always)]
    fn draw_row_of_samples<O: Order, P: SamplePattern>(
        &self,
        active: &mut ActiveListOf<L>,
        row: &mut DepthRow<'_, L::Color, O, L::Depth>,
        samples: &mut [<L::Color as BandColor>::Word],
    ) {
        for (index, position) in P::positions().enumerate() {
            let sample = [index, P::SAMPLES];
            if L::Shading::BLENDS {
                row.load_samples(samples, sample);
            }
            let columns = active.draw_sample(self, row, from_centre::<L>(position));
            row.store_samples(columns, samples, sample);
        }
    }

    #[inline(always)]
    fn draw_row<'e, O: Order>(
        &self,
        active: &mut ActiveListOf<L>,
        row: &mut DepthRow<'_, L::Color, O, L::Depth>,
        depth_use: DepthUse,
        edges: impl RowEdges<'e, <L::Color as BandColor>::Word, L::Depth>,
    ) {
        if L::DRAWS_IN_PASSES && active.needs_passes() {
            active.draw_row_in_passes(self, row, edges);
        } else {
            active.draw_row(self, row, depth_use, edges);
        }
    }

    /// How many faces are to be drawn whole, and how many are cut. The fragments of those begin with a vertex of the table.
    pub(super) fn drawn(&self, first_fragment: usize) -> [u32; 2] {
        let nodes = self.rows.iter().flat_map(|row| {
            let mut node = row.first();
            core::iter::from_fn(move || {
                let this = node;
                node = if this == NONE { NONE } else { self.next(this) };
                (this != NONE).then_some(this)
            })
        });
        let mut drawn = [0; 2];
        for node in nodes {
            let [whole, cut] = &mut drawn;
            if is_whole::<L>(node) {
                *whole += 1;
            } else if self.is_first_of_face(node, first_fragment) {
                *cut += 1;
            }
        }
        drawn
    }

    /// Whether a fragment is the first one of its face in the table, where the fragments of a face lie one after the other.
    fn is_first_of_face(&self, node: u16, first_fragment: usize) -> bool {
        let index = usize::from(node & !FRAGMENT);
        let before = index
            .checked_sub(FRAGMENT_VERTICES)
            .filter(|before| *before >= first_fragment);
        let order = |index: usize| self.vertices.get(index).map(ScreenVertex::x_units);
        before.is_none_or(|before| order(before) != order(index))
    }

    /// The most faces that cross a row.
    pub(super) fn most_active(&self) -> usize {
        RowStart::most_active(self.rows)
    }

    #[cold]
    #[inline(never)]
    fn next_after_fragment(&self, node: u16) -> u16 {
        if is_whole::<L>(node) {
            return NONE;
        }
        self.header(node).map_or(NONE, |header| header.y_units() as u16)
    }

    #[cold]
    #[inline(never)]
    fn order_of_fragment(&self, node: u16) -> u16 {
        self.header(node).map_or(NONE, |header| header.x_units() as u16)
    }

    /// The corners of a fragment.
    #[cold]
    #[inline(never)]
    pub(super) fn fragment(&self, node: u16) -> Option<[&ScreenVertex<L::Precision, L::Depth>; 3]> {
        let start = usize::from(node & !FRAGMENT) + 1;
        self.vertices
            .get(start..)?
            .first_chunk()
            .map(|corners| corners.each_ref())
    }

    fn header(&self, node: u16) -> Option<&ScreenVertex<L::Precision, L::Depth>> {
        self.vertices.get(usize::from(node & !FRAGMENT))
    }
}

impl<L: Look> PreparedFaces<'_, '_, L> {
    /// The uniforms of a model whose first face has a number: kept for the next face, which mostly is of the same model.
    fn uniforms(&self, model: &Model<'_, L::Shading>, first_face: u32) -> UniformsOf<L> {
        match self.last_uniforms.get() {
            Some((number, uniforms)) if number == first_face => uniforms,
            _ => {
                let uniforms = L::Shading::uniforms(model.skin(), &model.pose, &self.camera);
                self.last_uniforms.set(Some((first_face, uniforms)));
                uniforms
            }
        }
    }
}

impl<'m, L: Look> FaceTable<L::Precision, L::Depth, L::Shading> for PreparedFaces<'_, 'm, L> {
    const DRAWS_IN_PASSES: bool = L::DRAWS_IN_PASSES;
    const IS_ORTHOGRAPHIC: bool = L::IS_ORTHOGRAPHIC;
    const DRAWS_BACKS: bool = L::DRAWS_BACKS;
    const ANTIALIASES: bool = L::Silhouettes::BY_AREA;
    type Count<'c>
        = <L::Counting as Counting>::Count<'c>
    where
        Self: 'c;

    #[inline(always)]
    fn count(&self) -> Self::Count<'_> {
        self.counting.count()
    }

    fn viewport(&self) -> &Window {
        &self.viewport
    }

    fn change(&self, row: i32) -> Wrapping<u16> {
        let row = offset_from(self.viewport.top, row) as usize;
        self.rows.get(row).map_or(Wrapping(0), |row| row.change())
    }

    fn first_in_row(&self, row: i32) -> u16 {
        let row = offset_from(self.viewport.top, row) as usize;
        self.rows.get(row).map_or(NONE, |row| row.first())
    }

    fn next(&self, node: u16) -> u16 {
        // A fragment has a greater number than any face.
        match self.next.get(usize::from(node)) {
            Some(next) => *next,
            None => self.next_after_fragment(node),
        }
    }

    fn most_nodes(&self) -> usize {
        let fragments = if L::CLIPS {
            let of_models = self.models.iter().map(|model| model.mesh().vertices().len());
            self.vertices.len().saturating_sub(of_models.sum()) / FRAGMENT_VERTICES
        } else {
            0
        };
        self.next.len() + fragments
    }

    /// Index of a node in the order of models and faces; after all faces for [`NONE`].
    fn order(&self, node: u16) -> u16 {
        if is_whole::<L>(node) {
            node
        } else {
            self.order_of_fragment(node)
        }
    }

    #[inline]
    fn face_of_first_model(&self, node: u16) -> Option<FaceOf<'_, L>> {
        let face = self.first_faces.get(usize::from(node))?;
        let (skin, uniforms, mesh) = self.first_skin.as_ref()?;
        let word = L::Shading::face(skin, uniforms, mesh, usize::from(node))?;
        let corners = outward::<L::Shading, _>(skin, corners(self.vertices, face)?);
        Some((clockwise::<L, _>(corners, corners), word))
    }

    /// A face of another model, or a fragment.
    #[cold]
    #[inline(never)]
    fn other_face(&self, node: u16) -> Option<FaceOf<'_, L>> {
        let (model, first_vertex, face) = faces::find(self.models, self.order(node))?;
        let uniforms = self.uniforms(model, u32::from(self.order(node)) - face as u32);
        let word = L::Shading::face(model.skin(), &uniforms, model.mesh(), face)?;
        let corners = if is_whole::<L>(node) {
            let corners = corners(self.vertices.get(first_vertex..)?, model.mesh().faces().get(face)?);
            corners.map(|corners| {
                let corners = outward::<L::Shading, _>(model.skin(), corners);
                clockwise::<L, _>(corners, corners)
            })
        } else {
            self.fragment(node)
        };
        Some((corners?, word))
    }

    #[inline]
    fn word(&self, node: u16) -> Option<<L::Color as BandColor>::Word> {
        match &self.first_skin {
            Some((skin, uniforms, mesh)) if usize::from(node) < self.first_faces.len() => {
                L::Shading::face(skin, uniforms, mesh, usize::from(node))
            }
            _ => self.other_face(node).map(|(_, word)| word),
        }
    }

    type CornerAttributes<'c>
        = <StoredOf<L> as Stored<AttributesOf<L>>>::Attributes<'c>
    where
        Self: 'c;

    fn attributes(
        &self,
        node: u16,
        in_order: impl FnOnce([u16; 3]) -> [u16; 3],
    ) -> Option<[Self::CornerAttributes<'_>; 3]> {
        let stored = |vertex: usize| self.attributes.get(vertex);
        if !is_whole::<L>(node) {
            let [a, b, c] = in_order([1, 2, 3]).map(|corner| stored(usize::from((node & !FRAGMENT) + corner)));
            // All are kept, none is asked for.
            let none = || AttributesOf::<L>::ZERO;
            return Some([a?.attributes(none), b?.attributes(none), c?.attributes(none)]);
        }
        let (first_vertex, mesh, skin, uniforms, face) = match self.first_faces.get(usize::from(node)) {
            Some(face) => {
                let (skin, uniforms, mesh) = self.first_skin.as_ref()?;
                (0, *mesh, skin, Some(*uniforms), face)
            }
            None => {
                let (model, first_vertex, face) = faces::find(self.models, node)?;
                // Asked for where not all attributes are kept.
                let uniforms = || self.uniforms(model, u32::from(node) - face as u32);
                (
                    first_vertex,
                    model.mesh(),
                    model.skin(),
                    (!L::StoredAttributes::ARE_ALL).then(uniforms),
                    model.mesh().faces().get(face)?,
                )
            }
        };
        let face = outward::<L::Shading, _>(skin, *face);
        let face = if L::DRAWS_BACKS {
            clockwise::<L, _>(corners(self.vertices.get(first_vertex..)?, &face)?, face)
        } else {
            face
        };
        let all = |vertex: usize| {
            let position = mesh.vertices().get(vertex).copied().unwrap_or_default();
            uniforms.as_ref().map_or(AttributesOf::<L>::ZERO, |uniforms| {
                L::Shading::vertex(skin, uniforms, vertex, position.map(i32::from))
            })
        };
        let [a, b, c] = in_order(face).map(usize::from);
        let [at_a, at_b, at_c] = [a, b, c].map(|vertex| stored(first_vertex + vertex));
        Some([
            at_a?.attributes(|| all(a)),
            at_b?.attributes(|| all(b)),
            at_c?.attributes(|| all(c)),
        ])
    }

    type Skin = <L::Shading as Shading>::Skin<'m>;

    fn skin(&self, node: u16) -> Option<&Self::Skin> {
        if usize::from(node) < self.first_faces.len() {
            return self.first_skin.as_ref().map(|(skin, ..)| skin);
        }
        faces::find(self.models, self.order(node)).map(|(model, ..)| model.skin())
    }

    #[inline(always)]
    fn fragment(
        skin: &Self::Skin,
        face: <L::Color as BandColor>::Word,
        attributes: &<AttributesOf<L> as Planes>::Values,
    ) -> Option<<L::Color as BandColor>::Word> {
        L::Shading::fragment(skin, face, attributes)
    }

    #[inline]
    fn is_blended(skin: &Self::Skin) -> bool {
        L::Shading::is_translucent(skin)
    }

    #[inline(always)]
    fn blend(
        skin: &Self::Skin,
        fragment: <L::Color as BandColor>::Word,
        behind: <L::Color as BandColor>::Word,
        position: Point,
    ) -> <L::Color as BandColor>::Word {
        L::Shading::blend(skin, fragment, behind, position)
    }

    #[inline]
    fn mix(
        fragment: <L::Color as BandColor>::Word,
        behind: <L::Color as BandColor>::Word,
        coverage: Coverage,
        position: Point,
    ) -> <L::Color as BandColor>::Word {
        L::Silhouettes::mix(fragment, behind, coverage, position)
    }
}

/// Converts the position of a sample, x and y in 1/256 pixel from the top left corner of its pixel, to that from the centre of
/// the pixel in units of the look's precision, rounded down.
fn from_centre<L: Look>([x, y]: [i32; 2]) -> Position {
    let bits = L::Precision::FRACTION_BITS;
    let units = |part: i32| ((part << bits) >> 8) - (1 << bits) / 2;
    Position {
        x: units(x),
        y: units(y),
    }
}

impl<L: Look> fmt::Debug for PreparedFaces<'_, '_, L> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debug = formatter.debug_struct("PreparedFaces");
        debug.field("viewport", &self.viewport).finish_non_exhaustive()
    }
}
