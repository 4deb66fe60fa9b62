//! `zrow::scene` and `zrow::scene`: faces of any models, by their depth.

use anyhow::{Context, bail, ensure};
use arbitrary::{Arbitrary, Unstructured};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point, Size},
    pixelcolor::{
        Rgb565,
        raw::{RawData, RawU16},
    },
    primitives::{PointsIter, Rectangle},
};
use fixed::types::I16F16;
use zrow::{
    band::{Band, BigEndian, LittleEndian, Order},
    draw::{Picture, PictureSlot},
    geometry::{InputError, Sub4, Sub8, TooSmall, Window},
    scene::{
        Camera, DepthWidth, Edge as SceneEdge, FaceSet, Memory, Model, Pose, Prepared, Rotation, SceneItem,
        ScreenPrecision,
    },
};
use zrow_methods::LookOf;

use crate::{
    families::view::Turn,
    picture::{Canvas, background, cut, is_same, sure},
    target::{Case, Verdict},
    values::{Int, Length, List, Number, Spot},
};

/// A coordinate of a vertex: around the origin mostly.
#[derive(Debug, Copy, Clone)]
pub struct Coordinate(pub i16);

impl<'a> Arbitrary<'a> for Coordinate {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=219 => i16::from(bytes.arbitrary::<i8>()?) * 8,
            _ => Number::<i16>::arbitrary(bytes)?.0,
        }))
    }
}

/// A translation along an axis, in units of the vertices.
#[derive(Debug, Copy, Clone)]
struct Way(I16F16);

impl<'a> Arbitrary<'a> for Way {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=199 => I16F16::from_num(i16::from(bytes.arbitrary::<i8>()?) * 4),
            200..=239 => I16F16::from_bits(bytes.arbitrary::<i32>()? >> 4),
            _ => I16F16::from_bits(Int::arbitrary(bytes)?.0),
        }))
    }
}

/// Where a model or the camera is.
#[derive(Debug, Clone, Arbitrary)]
pub struct AnyPose {
    turns: List<Turn, 2>,
    position: [Way; 3],
}

impl AnyPose {
    /// The pose, so many units farther along z.
    pub fn get(&self, ahead: i16) -> Pose {
        let rotation = self
            .turns
            .0
            .iter()
            .fold(Rotation::IDENTITY, |all, turn| all.then(&turn.get()));
        let [x, y, z] = self.position.map(|way| way.0);
        Pose::new(rotation, [x, y, z.saturating_add(I16F16::from_num(ahead))])
    }
}

/// A model of few faces.
#[derive(Debug, Clone, Arbitrary)]
struct AnyModel {
    vertices: List<[Coordinate; 3], 7>,
    faces: List<[u8; 3], 6>,
    pose: AnyPose,
    /// Colours that are missing.
    lacks: u8,
}

/// What a model is made of.
pub struct Mesh {
    vertices: Vec<[i16; 3]>,
    faces: Vec<[u16; 3]>,
    pose: Pose,
}

impl Mesh {
    /// The vertices, one after the other: the corners of a contour that may cross itself.
    pub fn contour(&self) -> &[[i16; 3]] {
        &self.vertices
    }

    /// Where the model is.
    pub const fn pose(&self) -> &Pose {
        &self.pose
    }
}

impl AnyModel {
    fn mesh(&self) -> Mesh {
        let vertices: Vec<_> = self.vertices.0.iter().map(|vertex| vertex.map(|axis| axis.0)).collect();
        let count = vertices.len() as u16;
        let faces = self.faces.0.iter().filter(|_| count > 0);
        let faces = faces.map(|face| face.map(|index| u16::from(index) % count)).collect();
        Mesh {
            vertices,
            faces,
            // In front of the camera, mostly.
            pose: self.pose.get(1_200),
        }
    }
}

/// A camera and models before it.
#[derive(Debug, Clone, Arbitrary)]
pub struct AnyScene {
    models: List<AnyModel, 3>,
    view: AnyView,
}

/// A camera.
#[derive(Debug, Clone, Arbitrary)]
pub struct AnyView {
    camera: AnyPose,
    moves: bool,
    corner: [Edge; 2],
    size: [u8; 2],
    near: Number<u16>,
    focal_length: Option<Number<u16>>,
}

/// Where a viewport begins.
#[derive(Debug, Copy, Clone, Arbitrary)]
enum Edge {
    Origin,
    Near(i8),
    Far(i16),
}

impl Edge {
    const fn get(self) -> i32 {
        match self {
            Self::Origin => 0,
            Self::Near(coordinate) => coordinate as i32,
            Self::Far(coordinate) => coordinate as i32,
        }
    }
}

/// Columns and rows of a viewport at most.
const MOST_SIZE: u32 = 24;

impl AnyView {
    /// A camera whose viewport is small; `None` where there is none.
    pub fn camera(&self) -> Option<Camera> {
        let [x, y] = self.corner.map(Edge::get);
        let [width, height] = self.size.map(|length| 1 + u32::from(length) % MOST_SIZE);
        let viewport = Rectangle::new(Point::new(x, y), Size::new(width, height));
        let near = I16F16::from_num(8 + self.near.0 % 2_000);
        let camera = Camera::new(viewport, near).ok()?;
        let camera = match self.focal_length {
            Some(length) => camera.with_focal_length(I16F16::from_num(1 + length.0 % 2_047)).ok()?,
            None => camera,
        };
        Some(if self.moves {
            camera.with_pose(self.camera.get(0))
        } else {
            camera
        })
    }
}

impl AnyScene {
    /// The camera before the models.
    pub fn camera(&self) -> Option<Camera> {
        self.view.camera()
    }

    pub fn meshes(&self) -> Vec<Mesh> {
        self.models.0.iter().map(AnyModel::mesh).collect()
    }

    /// Checks the prepared scene, with its camera and its models. What cannot be prepared is right: errors are `FrameCase`'s.
    pub fn with_prepared<S: ScreenPrecision, D: DepthWidth>(
        &self,
        check: impl FnOnce(&Camera, &[Model<'_, Rgb565>], Prepared<'_, '_, LookOf<Rgb565, S, D, true>>) -> Verdict,
    ) -> Verdict {
        let Some(camera) = self.camera() else {
            return Ok(());
        };
        let meshes = self.meshes();
        let colors = colors(&meshes);
        let models = models(&meshes, &colors)?;
        let mut frame = Large::<S, D, true>::new();
        match frame.prepare(&camera, &models) {
            Ok(prepared) => check(&camera, &models, prepared),
            Err(_) => Ok(()),
        }
    }
}

impl Mesh {
    /// The sides of all faces: those of faces with an even number as boundaries, the others as creases that have no other face.
    pub fn edges(&self) -> Vec<SceneEdge> {
        let sides = (0..).zip(&self.faces).flat_map(|(face, &[a, b, c])| {
            [[a, b], [b, c], [c, a]].map(|ends| match face % 2 {
                0 => SceneEdge::boundary(ends, face),
                _ => SceneEdge::crease(ends, [face; 2]),
            })
        });
        sides.collect()
    }
}

/// The colour of a face by its position in the order of models and faces.
pub fn color(face: usize) -> Rgb565 {
    Rgb565::from(RawU16::from_u32(0x8421 + 0x0102 * face as u32))
}

/// Models of the meshes, each face in a colour of its own.
pub fn models<'m>(meshes: &'m [Mesh], colors: &'m [Vec<Rgb565>]) -> anyhow::Result<Vec<Model<'m, Rgb565>>> {
    let pairs = meshes.iter().zip(colors);
    pairs
        .map(|(mesh, colors)| {
            let set = FaceSet::new(&mesh.vertices, &mesh.faces).context("indices that are there")?;
            Ok(Model::new(set, colors)
                .context("as many colours as faces")?
                .with_pose(mesh.pose))
        })
        .collect()
}

/// Colours of the faces of meshes, each of its own.
pub fn colors(meshes: &[Mesh]) -> Vec<Vec<Rgb565>> {
    let mut first = 0;
    meshes
        .iter()
        .map(|mesh| {
            let colors = (first..first + mesh.faces.len()).map(color).collect();
            first += mesh.faces.len();
            colors
        })
        .collect()
}

/// Room for every scene here.
pub type Large<S, D, const CLIPS: bool> = Memory<LookOf<Rgb565, S, D, CLIPS>, 512, 24, 24, 24, 24>;
/// Room for few.
type Small<S, D, const CLIPS: bool> = Memory<LookOf<Rgb565, S, D, CLIPS>, 9, 6, 16, 24, 2>;

/// Scenes in bands of any height and order, from tables of any size.
#[derive(Debug, Arbitrary)]
pub struct FrameCase {
    scene: AnyScene,
    rows: u8,
    upwards: bool,
    part: [u8; 4],
    kind: Kind,
}

/// A precision with a width of depths.
#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
pub enum Kind {
    CoarseNarrow,
    CoarseWide,
    FineNarrow,
    FineWide,
}

/// A case that is checked with the precision and the width of depths of its `kind`.
macro_rules! case_of_each_kind {
    ($case:ty) => {
        impl Case for $case {
            fn check(&self) -> Verdict {
                match self.kind {
                    Kind::CoarseNarrow => self.check_kind::<Sub4, u16>(),
                    Kind::CoarseWide => self.check_kind::<Sub4, u32>(),
                    Kind::FineNarrow => self.check_kind::<Sub8, u16>(),
                    Kind::FineWide => self.check_kind::<Sub8, u32>(),
                }
            }
        }
    };
}
pub(crate) use case_of_each_kind;

/// A picture and whether depths were used for it in every row.
fn draw<S, D, const CUTS: bool, O>(
    prepared: &mut zrow::scene::Prepared<'_, '_, LookOf<Rgb565, S, D, CUTS>>,
    window: Window,
    always: bool,
) -> anyhow::Result<Vec<Rgb565>>
where
    S: ScreenPrecision,
    D: DepthWidth,
    O: Order,
{
    Canvas::new(window).draw::<O>(|band| {
        if always {
            prepared.draw_with(band, |_| {});
        } else {
            prepared.draw(band);
        }
        Ok(())
    })
}

/// As the item of a picture, row by row, a scene has the same pixels.
fn check_item<S: ScreenPrecision, D: DepthWidth>(
    camera: &Camera,
    models: &[Model<'_, Rgb565>],
    viewport: &Window,
    full: &[Rgb565],
) -> Verdict {
    match *models {
        [one] => check_item_of::<S, D, 1>(camera, [one], viewport, full),
        [one, two] => check_item_of::<S, D, 2>(camera, [one, two], viewport, full),
        [one, two, three] => check_item_of::<S, D, 3>(camera, [one, two, three], viewport, full),
        _ => Ok(()),
    }
}

fn check_item_of<S: ScreenPrecision, D: DepthWidth, const MODELS: usize>(
    camera: &Camera,
    models: [Model<'_, Rgb565>; MODELS],
    viewport: &Window,
    full: &[Rgb565],
) -> Verdict {
    let mut memory = Large::<S, D, true>::new();
    let item = SceneItem::new(memory.frame(), camera, models).context("what a frame could prepare")?;
    let (mut slots, mut buckets) = ([PictureSlot::EMPTY; 1], [0; 24]);
    let mut picture = Picture::new(viewport.to_rectangle(), &mut slots, &mut [], &mut buckets);
    picture.add_item(&item)?;
    for top in viewport.top..viewport.bottom {
        let bottom = top + 1;
        let row = Window {
            top,
            bottom,
            ..*viewport
        };
        let pixels = Canvas::new(row).draw::<LittleEndian>(|band| {
            picture.draw(band);
            Ok(())
        })?;
        is_same(&row, &cut(viewport, full, &row), &pixels).context("by itself, the other in a picture")?;
    }
    Ok(())
}

impl FrameCase {
    fn check_kind<S: ScreenPrecision, D: DepthWidth>(&self) -> Verdict {
        let Some(camera) = self.scene.camera() else {
            return Ok(());
        };
        let viewport = camera.viewport();
        let meshes = self.scene.meshes();
        let colors = colors(&meshes);
        let models = models(&meshes, &colors)?;
        let mut frame = Large::<S, D, true>::new();
        let mut prepared = match frame.prepare(&camera, &models) {
            Ok(prepared) => prepared,
            Err(error @ InputError::OutOfDomain { min, max }) => {
                let sides = [viewport.left, viewport.top, viewport.right, viewport.bottom];
                let is_inside = sides.iter().all(|side| (min..=max).contains(side));
                ensure!(!is_inside, "{error} for {viewport:?}");
                return Ok(());
            }
            Err(error) => bail!("{error} with room for all"),
        };
        let full = draw::<S, D, true, LittleEndian>(&mut prepared, viewport, false)?;
        let with_depths = draw::<S, D, true, BigEndian>(&mut prepared, viewport, true)?;
        is_same(&viewport, &full, &with_depths).context("where faces overlap, the other with depths always")?;
        // Bands of some rows, in any order.
        let rows = 1 + usize::from(self.rows) % 8;
        for rows in [1, rows] {
            let mut bands: Vec<Window> = (viewport.top..viewport.bottom)
                .step_by(rows)
                .map(|top| Window {
                    top,
                    bottom: viewport.bottom.min(top + rows as i32),
                    ..viewport
                })
                .collect();
            if self.upwards {
                bands.reverse();
            }
            for band in bands {
                let picture = draw::<S, D, true, LittleEndian>(&mut prepared, band, false)?;
                is_same(&band, &cut(&viewport, &full, &band), &picture).context("whole, the other in bands")?;
            }
        }
        // A band beside the viewport, or larger than it.
        let [left, top, right, bottom] = self.part.map(|margin| i32::from(margin % 16) - 8);
        let around = Window {
            left: viewport.left + left,
            top: viewport.top + top,
            right: viewport.right + right,
            bottom: viewport.bottom + bottom,
        };
        let picture = draw::<S, D, true, LittleEndian>(&mut prepared, around, false)?;
        for (point, found) in around.to_rectangle().points().zip(&picture) {
            let index = viewport.contains(point).then(|| {
                let (column, row) = (point.x.abs_diff(viewport.left), point.y.abs_diff(viewport.top));
                (row * viewport.width() + column) as usize
            });
            let expected = index.map_or(background(), |index| full[index]);
            ensure!(expected == *found, "{point:?} is another one in the band {around:?}");
        }
        let faces = prepared.faces().count();
        ensure!(
            prepared.rows_without_depth() <= 16 * viewport.height(),
            "more rows than were drawn"
        );
        let is_untouched = full.iter().all(|color| *color == background());
        ensure!(faces > 0 || is_untouched, "a picture of no face");

        check_item::<S, D>(&camera, &models, &viewport, &full)?;
        self.check_small::<S, D, true>(&camera, &models, &viewport, &full)?;
        // Faces that need not be cut are the same without a frame that can cut.
        let mut frame = Large::<S, D, false>::new();
        match frame.prepare(&camera, &models) {
            Ok(mut prepared) => {
                let whole = draw::<S, D, false, LittleEndian>(&mut prepared, viewport, false)?;
                is_same(&viewport, &full, &whole).context("with a frame that cuts, without")?;
            }
            Err(InputError::BeforeNearPlane { model } | InputError::BeyondGuardBand { model }) => {
                ensure!(model < models.len(), "model {model} of {}", models.len());
            }
            Err(error) => bail!("{error} with room for all"),
        }
        self.check_small::<S, D, false>(&camera, &models, &viewport, &full)
    }

    /// Small tables: the same picture, or an error that says what is missing; then another scene fits.
    fn check_small<S: ScreenPrecision, D: DepthWidth, const CUTS: bool>(
        &self,
        camera: &Camera,
        models: &[Model<'_, Rgb565>],
        viewport: &Window,
        full: &[Rgb565],
    ) -> Verdict {
        let mut frame = Small::<S, D, CUTS>::new();
        for count in (0..=models.len()).rev() {
            match frame.prepare(camera, &models[..count]) {
                Ok(mut prepared) => {
                    let picture = draw::<S, D, CUTS, LittleEndian>(&mut prepared, *viewport, false)?;
                    if count == models.len() {
                        is_same(viewport, full, &picture).context("with large tables, with small ones")?;
                    } else {
                        let mut large = Large::<S, D, CUTS>::new();
                        let mut prepared = match large.prepare(camera, &models[..count]) {
                            Ok(prepared) => prepared,
                            Err(error) => bail!("{error} with room for all, where a small table has room"),
                        };
                        let other = draw::<S, D, CUTS, LittleEndian>(&mut prepared, *viewport, false)?;
                        is_same(viewport, &other, &picture)
                            .context("with large tables, with small ones after an error")?;
                    }
                }
                Err(InputError::TooSmall(full)) => {
                    let capacity = match full {
                        TooSmall::Vertices(_) => 9,
                        TooSmall::Faces(_) => 6,
                        TooSmall::Columns(_) => 16,
                        other => bail!("{other}: it has room"),
                    };
                    ensure!(full.needed() > capacity, "{full}, where there are {capacity}");
                }
                Err(InputError::BeforeNearPlane { .. } | InputError::BeyondGuardBand { .. }) if !CUTS => {}
                Err(error) => bail!("{error} with small tables only"),
            }
        }
        Ok(())
    }
}

case_of_each_kind!(FrameCase);

/// What is seen in a pixel is the nearest face there, each drawn by itself; of equally near ones the first.
#[derive(Debug, Arbitrary)]
pub struct DepthCase {
    scene: AnyScene,
    is_fine: bool,
}

type Depths<S> = Memory<LookOf<Rgb565, S>, 512, 24, 24, 24, 24>;

/// The depth that each pixel of a scene has been given: found by drawing at depths, a bit at a time.
fn depths<S: ScreenPrecision>(
    frame: &mut Depths<S>,
    camera: &Camera,
    models: &[Model<'_, Rgb565>],
) -> anyhow::Result<Vec<u16>> {
    let viewport = camera.viewport();
    let pixels: Vec<Point> = viewport.to_rectangle().points().collect();
    let mut found = vec![0u16; pixels.len()];
    let width = viewport.width() as usize;
    for bit in (0..16).rev() {
        let mut prepared = match frame.prepare(camera, models) {
            Ok(prepared) => prepared,
            Err(error) => bail!("{error} with room for all"),
        };
        let mark = Rgb565::from(RawU16::from_u32(1));
        let mut words = vec![0; pixels.len()];
        let mut band = Band::<Rgb565>::new(viewport.to_rectangle(), &mut words)?;
        prepared.draw_with(&mut band, |row| {
            let first = row.y().abs_diff(viewport.top) as usize * width;
            for index in first..first + width {
                // Drawn where it is nearer than what is there.
                let tried = found[index] | 1 << bit;
                sure(row.at_depth(tried).draw_iter([Pixel(pixels[index], mark)]));
            }
        });
        for (found, color) in found.iter_mut().zip(band.colors()) {
            // Not drawn: what is there is as near, or nearer.
            if color != mark {
                *found |= 1 << bit;
            }
        }
    }
    Ok(found)
}

impl DepthCase {
    fn check_at<S: ScreenPrecision>(&self) -> Verdict {
        let Some(camera) = self.scene.camera() else {
            return Ok(());
        };
        let viewport = camera.viewport();
        let meshes = self.scene.meshes();
        let all_colors = colors(&meshes);
        let models = models(&meshes, &all_colors)?;
        let mut frame = Depths::<S>::new();
        let picture = match frame.prepare(&camera, &models) {
            Ok(mut prepared) => draw::<S, u16, true, LittleEndian>(&mut prepared, viewport, false)?,
            Err(_) => return Ok(()),
        };
        let mut nearest = vec![(0, background()); picture.len()];
        for (mesh, colors) in meshes.iter().zip(&all_colors) {
            for (face, color) in mesh.faces.iter().zip(colors) {
                let (faces, colors) = ([*face], [*color]);
                let set = FaceSet::new(&mesh.vertices, &faces).context("indices that are there")?;
                let alone = [Model::new(set, &colors).context("a colour")?.with_pose(mesh.pose)];
                for (nearest, depth) in nearest.iter_mut().zip(depths(&mut frame, &camera, &alone)?) {
                    if depth > nearest.0 {
                        *nearest = (depth, *color);
                    }
                }
            }
        }
        let expected: Vec<_> = nearest.into_iter().map(|(_, color)| color).collect();
        is_same(&viewport, &expected, &picture).context("face by face, the other together")
    }
}

impl Case for DepthCase {
    fn check(&self) -> Verdict {
        if self.is_fine {
            self.check_at::<Sub8>()
        } else {
            self.check_at::<Sub4>()
        }
    }
}

/// Drawing at a depth into the rows of a scene: any calls, any depths.
#[derive(Debug, Arbitrary)]
pub struct AtDepthCase {
    scene: AnyScene,
    calls: List<(u16, Call), 3>,
}

#[derive(Debug, Arbitrary)]
enum Call {
    Solid(Spot, [Length; 2]),
    Contiguous(Spot, [Length; 2]),
    Pixels(List<Spot, 4>),
    Clear,
}

impl Case for AtDepthCase {
    fn check(&self) -> Verdict {
        let Some(camera) = self.scene.camera() else {
            return Ok(());
        };
        let viewport = camera.viewport();
        let meshes = self.scene.meshes();
        let colors = colors(&meshes);
        let models = models(&meshes, &colors)?;
        let mut frame = Depths::<Sub8>::new();
        let scene_depths = depths(&mut frame, &camera, &models)?;
        let mut prepared = match frame.prepare(&camera, &models) {
            Ok(prepared) => prepared,
            Err(error) => bail!("{error} with room for all"),
        };
        let plain = draw::<Sub8, u16, true, LittleEndian>(&mut prepared, viewport, false)?;
        let color = |call: usize| Rgb565::from(RawU16::from_u32(0x0101 + call as u32));
        let origin = Point::new(viewport.left, viewport.top);
        let area =
            |corner: &Spot, [width, height]: &[Length; 2]| Rectangle::new(corner.from(origin), width.by(*height));
        let mut asked_too_often = false;
        let picture = Canvas::new(viewport).draw::<LittleEndian>(|band| {
            prepared.draw_with(band, |row| {
                for (number, (depth, call)) in self.calls.0.iter().enumerate() {
                    let mut target = row.at_depth(*depth);
                    let color = color(number);
                    match call {
                        Call::Solid(corner, size) => sure(target.fill_solid(&area(corner, size), color)),
                        Call::Contiguous(corner, size) => {
                            let area = area(corner, size);
                            let visible = Window::from(area).intersection(&Window::from(target.bounding_box()));
                            let most = u64::from(visible.width()) + 4;
                            let asked = std::cell::Cell::new(0);
                            let colors = crate::picture::Counted::new(std::iter::repeat(color), &asked, most);
                            sure(target.fill_contiguous(&area, colors));
                            asked_too_often |= asked.get() > most;
                        }
                        Call::Pixels(spots) => {
                            let points = spots.0.iter().map(|spot| spot.from(origin));
                            sure(target.draw_iter(points.map(|point| Pixel(point, color))));
                        }
                        Call::Clear => sure(target.clear(color)),
                    }
                }
            });
            Ok(())
        })?;
        ensure!(!asked_too_often, "a row asks for more colours than it has pixels");
        let points = viewport.to_rectangle().points();
        let expected = points
            .zip(plain.iter().zip(&scene_depths))
            .map(|(point, (color_there, depth_there))| {
                let (mut seen, mut nearest) = (*color_there, *depth_there);
                for (number, (depth, call)) in self.calls.0.iter().enumerate() {
                    let is_drawn = match call {
                        Call::Solid(corner, size) | Call::Contiguous(corner, size) => {
                            Window::from(area(corner, size)).contains(point)
                        }
                        Call::Pixels(spots) => spots.0.iter().any(|spot| spot.from(origin) == point),
                        Call::Clear => true,
                    };
                    if is_drawn && *depth > nearest {
                        (seen, nearest) = (color(number), *depth);
                    }
                }
                seen
            });
        is_same(&viewport, &expected.collect::<Vec<_>>(), &picture).context("by definition, the other drawn")
    }
}

/// Models that cannot be, and poses of any numbers.
#[derive(Debug, Arbitrary)]
pub struct ModelCase {
    model: AnyModel,
    camera: AnyScene,
}

impl Case for ModelCase {
    fn check(&self) -> Verdict {
        let mesh = self.model.mesh();
        let set = FaceSet::new(&mesh.vertices, &mesh.faces).context("indices that are there")?;
        let needed = mesh.faces.len();
        let count = needed.saturating_sub(usize::from(self.model.lacks % 4)) + usize::from(self.model.lacks / 128);
        let colors: Vec<_> = (0..count).map(color).collect();
        match Model::new(set, &colors) {
            Ok(model) => {
                ensure!(count >= needed, "{count} colours for {needed} faces");
                ensure!(*model.mesh() == set && model.colors() == colors, "another model");
                let model = model.with_pose(mesh.pose);
                ensure!(model.pose == mesh.pose, "another pose");
                if let Some(camera) = self.camera.camera() {
                    // Twice as a model: 14 vertices, 12 faces.
                    let models = [model, model];
                    let mut frame = Large::<Sub4, u16, true>::new();
                    if let Ok(prepared) = frame.prepare(&camera, &models) {
                        let domain = |units: i32| (-1_024 * 16..=1_023 * 16).contains(&units);
                        let is_inside = prepared.faces().all(|face| {
                            face.corners.iter().all(|corner| {
                                domain(corner.point.x_units()) && domain(corner.point.y_units()) && corner.depth > 0
                            })
                        });
                        ensure!(is_inside, "a corner on the screen that is outside of the domain");
                        ensure!(
                            prepared.faces().all(|face| face.order < 2 * needed),
                            "a face of no model"
                        );
                    }
                }
            }
            Err(error) => ensure!(
                count < needed && error == TooSmall::Colors(needed),
                "{error} for {count} colours"
            ),
        }
        Ok(())
    }
}
