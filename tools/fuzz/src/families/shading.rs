//! `zrow::scene` in the shadings of `zrow::shade`: any meshes, attributes and lights.

use anyhow::{Context, bail, ensure};
use arbitrary::{Arbitrary, Unstructured};
use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888, raw::RawData},
    prelude::PixelColor,
    primitives::PointsIter,
};
use fixed::types::{I16F16, U0F16};
use zrow::{
    band::{Band, BandColor, BigEndian, LittleEndian, Order},
    geometry::{InputError, Window},
    scene::{Antialiased, Camera, Deep, FaceSet, Fine, Look, Memory, Model, Pose, Prepared, Whole},
    shade::{
        Bilinear, Blinn, ChannelColor, Clamped, CutOut, DirectionalLight, FlatLit, FlatLitSkin, Fog, Foggy, Gouraud,
        GouraudSkin, Indexed, IndexedImage, Lambert, LitTextured, LitTexturedSkin, PointLight, Shading, Texels,
        Textured, TexturedSkin, Translucent,
    },
};

use crate::{
    families::any_scene::{AnyPose, AnyView, Coordinate},
    target::{Case, Verdict},
    values::{Int, List, Number},
};

/// A vertex: anywhere, or so near to others that faces are slivers or points.
#[derive(Debug, Clone, Arbitrary)]
enum Vertex {
    Free([Coordinate; 3]),
    /// At a distance from the vertex before it.
    Near([i8; 3]),
    /// Between the two before it, in 1/256 of the way, and some units beside.
    Between(u8, [i8; 3]),
}

/// What a vertex has.
#[derive(Debug, Clone, Arbitrary)]
struct AnyVertex {
    vertex: Vertex,
    normal: [i8; 2],
    coordinates: [TextureCoordinate; 2],
    color: u32,
}

/// A texture coordinate: within some textures mostly.
#[derive(Debug, Copy, Clone)]
struct TextureCoordinate(i16);

impl<'a> Arbitrary<'a> for TextureCoordinate {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            0..=99 => i16::from(bytes.arbitrary::<i8>()?) * 64,
            100..=199 => bytes.arbitrary()?,
            _ => Number::<i16>::arbitrary(bytes)?.0,
        }))
    }
}

/// A model of few faces, and what any shading takes.
#[derive(Debug, Clone, Arbitrary)]
struct AnyModel {
    vertices: List<AnyVertex, 7>,
    faces: List<[u8; 3], 6>,
    pose: AnyPose,
    /// Three lights: where they come from, and how bright they are.
    lights: [([Int; 3], Number<u16>); 3],
    ambient: Number<u16>,
    /// Whether all vertices have the colour of the first one.
    has_one_color: bool,
    texels: [u32; 5],
}

/// A model's tables, in the colours of a display.
struct Tables<C: BandColor> {
    vertices: Vec<[i16; 3]>,
    faces: Vec<[u16; 3]>,
    normals: Vec<[i8; 2]>,
    /// Each face has the normal of its first vertex.
    face_normals: Vec<[i8; 2]>,
    coordinates: Vec<[i16; 2]>,
    colors: Vec<C>,
    lights: [DirectionalLight; 3],
    ambient: U0F16,
    wide: [[C::Word; 8]; 4],
    high: [[C::Word; 1]; 16],
    indices: [[u8; 2]; 4],
    palette: [C::Word; 4],
    points: [PointLight; 2],
    sharpness: u8,
    fog: [I16F16; 2],
    curve: [u8; 64],
    alpha: u8,
    pose: Pose,
}

/// The colour of a number.
fn color<C: BandColor + From<<C as PixelColor>::Raw>>(number: u32) -> C {
    C::from(C::Raw::from_u32(number))
}

impl AnyModel {
    fn positions(&self) -> Vec<[i16; 3]> {
        let mut positions = vec![[0; 3]; 2];
        for vertex in &self.vertices.0 {
            let [one, other] = [positions[positions.len() - 2], positions[positions.len() - 1]];
            let axes = [0, 1, 2];
            positions.push(match &vertex.vertex {
                Vertex::Free(position) => position.map(|axis| axis.0),
                Vertex::Near(offsets) => axes.map(|axis| other[axis].saturating_add((offsets[axis] / 8).into())),
                Vertex::Between(part, beside) => axes.map(|axis| {
                    let way = (i32::from(other[axis]) - i32::from(one[axis])) * i32::from(*part) / 256;
                    one[axis]
                        .saturating_add(way as i16)
                        .saturating_add((beside[axis] / 64).into())
                }),
            });
        }
        positions.split_off(2)
    }

    fn tables<C: BandColor + From<<C as PixelColor>::Raw>>(&self) -> Tables<C> {
        let all = &self.vertices.0;
        let count = all.len() as u16;
        let faces = self.faces.0.iter().filter(|_| count > 0);
        // xorshift32 (Marsaglia 2003), of few words, so that inputs are short.
        let mut states = self.texels.map(|texel| texel | 1);
        let mut texel = |row: usize| {
            let state = &mut states[row % 5];
            *state ^= *state << 13;
            *state ^= *state >> 17;
            *state ^= *state << 5;
            color::<C>(*state >> 5).to_word()
        };
        let faces: Vec<[u16; 3]> = faces.map(|face| face.map(|index| u16::from(index) % count)).collect();
        Tables {
            vertices: self.positions(),
            face_normals: faces
                .iter()
                .map(|[first, ..]| all[usize::from(*first)].normal)
                .collect(),
            faces,
            normals: all.iter().map(|vertex| vertex.normal).collect(),
            coordinates: all.iter().map(|vertex| vertex.coordinates.map(|axis| axis.0)).collect(),
            colors: all
                .iter()
                .take(if self.has_one_color { 1 } else { all.len() })
                .map(|vertex| color(vertex.color))
                .collect(),
            lights: self.lights.map(|(towards, intensity)| {
                let towards = towards.map(|axis| I16F16::from_bits(axis.0));
                DirectionalLight::from_direction(towards, U0F16::from_bits(intensity.0))
                    .unwrap_or(DirectionalLight::NONE)
            }),
            ambient: U0F16::from_bits(self.ambient.0),
            wide: core::array::from_fn(|row| core::array::from_fn(|_| texel(row))),
            high: core::array::from_fn(|row| [texel(row)]),
            indices: core::array::from_fn(|row| [(self.texels[row] >> 3) as u8, (self.texels[row] >> 13) as u8]),
            palette: core::array::from_fn(|index| color::<C>(self.texels[index + 1]).to_word()),
            points: [0, 1].map(|index| {
                let (position, intensity) = &self.lights[index];
                PointLight {
                    // As near to the model as its camera, or anywhere.
                    position: [0, 1, 2].map(|axis| I16F16::from_bits(position[axis].0)),
                    intensity: U0F16::from_bits(intensity.0),
                    half_distance: self.lights[2].1.0,
                }
            }),
            sharpness: self.texels[0] as u8 % 12,
            fog: [self.lights[2].0[0], self.lights[2].0[1]].map(|distance| I16F16::from_bits(distance.0)),
            curve: core::array::from_fn(|step| (self.texels[step % 5] >> (step / 3)) as u8 & 63),
            alpha: match self.texels[1] as u8 {
                opaque @ 192.. => opaque | 63,
                alpha => alpha,
            },
            pose: self.pose.get(1_200),
        }
    }
}

/// A shading whose skin is made of any model's tables.
trait AnyShading: Shading<Color: From<<Self::Color as PixelColor>::Raw>> {
    fn skin(tables: &Tables<Self::Color>) -> Self::Skin<'_>;
}

/// As many of three lights as a shading takes.
fn lambert<C: BandColor, const LIGHTS: usize>(tables: &Tables<C>) -> Lambert<LIGHTS> {
    Lambert {
        ambient: tables.ambient,
        lights: core::array::from_fn(|light| tables.lights[light]),
        points: [],
    }
}

impl<C: ChannelColor + From<<C as PixelColor>::Raw>, const LIGHTS: usize> AnyShading for FlatLit<C, Lambert<LIGHTS>> {
    fn skin(tables: &Tables<C>) -> FlatLitSkin<'_, C, Lambert<LIGHTS>> {
        FlatLitSkin {
            colors: &tables.colors,
            normals: &tables.face_normals,
            lights: lambert(tables),
        }
    }
}

impl<C: ChannelColor + From<<C as PixelColor>::Raw>, const LIGHTS: usize> AnyShading for Gouraud<C, Lambert<LIGHTS>> {
    fn skin(tables: &Tables<C>) -> GouraudSkin<'_, C, Lambert<LIGHTS>> {
        GouraudSkin {
            colors: &tables.colors,
            normals: &tables.normals,
            lights: lambert(tables),
        }
    }
}

impl<C: BandColor + From<<C as PixelColor>::Raw>, const STEP: i32> AnyShading for Textured<Texels<C, 8, 4>, STEP> {
    fn skin(tables: &Tables<C>) -> TexturedSkin<'_, Texels<C, 8, 4>> {
        TexturedSkin {
            image: &tables.wide,
            coordinates: &tables.coordinates,
        }
    }
}

impl<C: ChannelColor + From<<C as PixelColor>::Raw>, const LIGHTS: usize> AnyShading
    for LitTextured<Texels<C, 1, 16>, Lambert<LIGHTS>>
{
    fn skin(tables: &Tables<C>) -> LitTexturedSkin<'_, Texels<C, 1, 16>, Lambert<LIGHTS>> {
        LitTexturedSkin {
            image: &tables.high,
            coordinates: &tables.coordinates,
            normals: &tables.normals,
            lights: lambert(tables),
        }
    }
}

/// A texture of four colours in rows of two bytes, from the words of a wide one.
fn indexed<C: BandColor>(tables: &Tables<C>) -> IndexedImage<'_, C, 2, 4, 4> {
    IndexedImage {
        indices: &tables.indices,
        palette: &tables.palette,
    }
}

impl<C: ChannelColor + From<<C as PixelColor>::Raw>> AnyShading for Textured<CutOut<Indexed<C, 2, 4, 4>>> {
    fn skin(tables: &Tables<C>) -> TexturedSkin<'_, CutOut<Indexed<C, 2, 4, 4>>> {
        TexturedSkin {
            image: indexed(tables),
            coordinates: &tables.coordinates,
        }
    }
}

impl<C: ChannelColor + From<<C as PixelColor>::Raw>> AnyShading
    for LitTextured<Bilinear<Clamped<CutOut<Indexed<C, 2, 4, 4>>>>, Blinn<2, 2>>
{
    fn skin(tables: &Tables<C>) -> LitTexturedSkin<'_, Bilinear<Clamped<CutOut<Indexed<C, 2, 4, 4>>>>, Blinn<2, 2>> {
        LitTexturedSkin {
            image: indexed(tables),
            coordinates: &tables.coordinates,
            normals: &tables.normals,
            lights: blinn(tables),
        }
    }
}

/// Two lights from a direction and two from a point, with highlights.
fn blinn<C: BandColor>(tables: &Tables<C>) -> Blinn<2, 2> {
    Blinn {
        diffuse: Lambert {
            ambient: tables.ambient,
            lights: [tables.lights[0], tables.lights[1]],
            points: tables.points,
        },
        strength: tables.ambient,
        sharpness: tables.sharpness,
    }
}

impl<C: ChannelColor + From<<C as PixelColor>::Raw>> AnyShading for Gouraud<C, Blinn<2, 2>> {
    fn skin(tables: &Tables<C>) -> GouraudSkin<'_, C, Blinn<2, 2>> {
        GouraudSkin {
            colors: &tables.colors,
            normals: &tables.normals,
            lights: blinn(tables),
        }
    }
}

impl<C: ChannelColor + From<<C as PixelColor>::Raw>> AnyShading for FlatLit<C, Blinn<2, 2>> {
    fn skin(tables: &Tables<C>) -> FlatLitSkin<'_, C, Blinn<2, 2>> {
        FlatLitSkin {
            colors: &tables.colors,
            normals: &tables.face_normals,
            lights: blinn(tables),
        }
    }
}

impl<H: AnyShading<Color: ChannelColor>> AnyShading for Foggy<H> {
    fn skin(tables: &Tables<H::Color>) -> Self::Skin<'_> {
        let fog = Fog {
            color: tables.colors.first().copied().unwrap_or(color(0)),
            start: tables.fog[0],
            end: tables.fog[1],
            curve: &tables.curve,
        };
        (H::skin(tables), fog)
    }
}

/// One model in four is opaque.
impl<H: AnyShading<Color: ChannelColor>> AnyShading for Translucent<H> {
    fn skin(tables: &Tables<H::Color>) -> Self::Skin<'_> {
        (H::skin(tables), tables.alpha)
    }
}

/// Scenes in a shading: the same picture however it is cut into bands, and however many slots there are.
#[derive(Debug, Arbitrary)]
pub struct ShadingCase {
    models: List<AnyModel, 3>,
    view: AnyView,
    /// Left, top, width and height of windows in which parts are drawn.
    windows: List<[u8; 4], 8>,
    background: u32,
    method: Method,
    kind: Kind,
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Method {
    Gouraud,
    Textured,
    LitTextured,
    FlatLit,
    Holes,
    Mixed,
    Shiny,
    ShinyFlat,
    FoggyFlat,
    FoggyGouraud,
    FoggyHoles,
    TranslucentFlat,
    TranslucentHoles,
    FoggyGlass,
    AntialiasedFlat,
    AntialiasedHoles,
    AntialiasedGlass,
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Kind {
    Rgb565,
    FineRgb565,
    DeepRgb565,
    FineDeepRgb565,
    DeepGray8,
    FineBinary,
    Rgb888,
}

/// The colours of a band on a background, after something has drawn into it.
fn drawn<C: BandColor, O: Order>(
    window: &Window,
    background: C,
    draw: impl FnOnce(&mut Band<'_, C, O>),
) -> anyhow::Result<Vec<C>> {
    let pixels = window.width() as usize * window.height() as usize;
    let mut words = vec![Band::<C, O>::word(background); pixels];
    let mut band = Band::<C, O>::new(window.to_rectangle(), &mut words).context("enough words")?;
    draw(&mut band);
    Ok(band.colors().collect())
}

/// A part of a picture on a background.
fn part<L: Look>(
    prepared: &mut Prepared<'_, '_, L>,
    window: &Window,
    background: L::Color,
) -> anyhow::Result<Vec<L::Color>> {
    drawn::<_, LittleEndian>(window, background, |band| {
        prepared.draw(band);
    })
}

/// A picture of a viewport.
struct Picture<C> {
    viewport: Window,
    colors: Vec<C>,
    background: C,
}

impl<C: BandColor> Picture<C> {
    /// Whether a part, drawn by itself, is as in the picture.
    fn has(&self, window: &Window, part: &[C]) -> Verdict {
        let points = self.viewport.to_rectangle().points().zip(&self.colors);
        let expected = points.filter(|(point, _)| window.contains(*point));
        let found = window.to_rectangle().points().zip(part);
        let mut differing = expected.zip(found).filter(|((_, one), (_, other))| one != other);
        if let Some(((point, one), (_, other))) = differing.next() {
            bail!(
                "{point} is {:x?}, the other {:x?}; {} pixels differ",
                one.to_word(),
                other.to_word(),
                differing.count() + 1
            );
        }
        Ok(())
    }

    /// Draws the rows, the last one first, then windows; each part is as in the picture.
    fn check_parts<L: Look<Color = C>>(&self, prepared: &mut Prepared<'_, '_, L>, windows: &[Window]) -> Verdict {
        let rows = (self.viewport.top..self.viewport.bottom).map(|top| Window {
            top,
            bottom: top + 1,
            ..self.viewport
        });
        for window in rows.clone().chain(rows.rev()).chain(windows.iter().copied()) {
            let found = part(prepared, &window, self.background)?;
            self.has(&window, &found)
                .with_context(|| format!("whole, the other in {window:?}"))?;
        }
        Ok(())
    }
}

impl ShadingCase {
    /// Windows within a viewport.
    fn windows(&self, viewport: &Window) -> Vec<Window> {
        let within = |number: u8, length: u32| (u32::from(number) % length) as i32;
        let window = |[left, top, width, height]: &[u8; 4]| {
            let (left, top) = (
                viewport.left + within(*left, viewport.width()),
                viewport.top + within(*top, viewport.height()),
            );
            Window {
                left,
                top,
                right: (left + 1 + i32::from(width % 8)).min(viewport.right),
                bottom: (top + 1 + i32::from(height % 8)).min(viewport.bottom),
            }
        };
        self.windows.0.iter().map(window).collect()
    }

    fn check_kind<L: Look>(&self) -> Verdict
    where
        L::Shading: AnyShading<Color = L::Color>,
        L::Color: From<<L::Color as PixelColor>::Raw>,
    {
        let Some(camera) = self.view.camera() else {
            return Ok(());
        };
        let tables: Vec<Tables<L::Color>> = self.models.0.iter().map(AnyModel::tables).collect();
        let models = tables.iter().map(|tables| {
            let mut mesh = FaceSet::new(&tables.vertices, &tables.faces).context("indices that are there")?;
            if self.background % 2 == 1 {
                // A wrong table of neighbours: the picture is another one, but whole.
                mesh = mesh.with_neighbours(&tables.faces);
            }
            let model = Model::with_skin(mesh, L::Shading::skin(tables)).context("all that a shading takes")?;
            Ok(model.with_pose(tables.pose))
        });
        let models = models.collect::<anyhow::Result<Vec<_>>>()?;
        let Some(picture) = self.check_cut::<L>(&camera, &models)? else {
            return Ok(());
        };
        let windows = self.windows(&picture.viewport);
        // Without cutting.
        let mut memory = Memory::<Whole<L>, 512, 24, 24, 24, 24>::new();
        match memory.prepare(&camera, &models) {
            Ok(mut prepared) => {
                let whole = part(&mut prepared, &picture.viewport, picture.background)?;
                picture
                    .has(&picture.viewport, &whole)
                    .context("with a frame that cuts, without")?;
                picture
                    .check_parts(&mut prepared, &windows)
                    .context("without cutting")?;
            }
            Err(InputError::BeforeNearPlane { .. } | InputError::BeyondGuardBand { .. }) => return Ok(()),
            Err(error) => bail!("{error} with room for all"),
        }
        let mut memory = Memory::<Whole<L>, 512, 24, 24, 24, 1>::new();
        let Ok(mut prepared) = memory.prepare(&camera, &models) else {
            bail!("an error with one slot only");
        };
        picture
            .check_parts(&mut prepared, &windows)
            .context("without cutting, with one slot")
    }

    /// Draws a scene in which faces are cut in all ways. Returns the picture, if there is one.
    fn check_cut<L: Look>(
        &self,
        camera: &Camera,
        models: &[Model<'_, L::Shading>],
    ) -> anyhow::Result<Option<Picture<L::Color>>>
    where
        L::Color: From<<L::Color as PixelColor>::Raw>,
    {
        let viewport = camera.viewport();
        let background = color(self.background);
        let mut memory = Memory::<L, 512, 24, 24, 24, 24>::new();
        let mut prepared = match memory.prepare(camera, models) {
            Ok(prepared) => prepared,
            Err(InputError::OutOfDomain { .. }) => return Ok(None),
            Err(error) => bail!("{error} with room for all"),
        };
        let picture = Picture {
            viewport,
            colors: part(&mut prepared, &viewport, background)?,
            background,
        };
        let windows = self.windows(&viewport);
        let with_depths = drawn::<_, BigEndian>(&viewport, background, |band| {
            prepared.draw_with(band, |_| {});
        })?;
        picture
            .has(&viewport, &with_depths)
            .context("where faces overlap, the other with depths always")?;
        picture.check_parts(&mut prepared, &windows)?;
        let mut memory = Memory::<L, 512, 24, 24, 24, 1>::new();
        let Ok(mut prepared) = memory.prepare(camera, models) else {
            bail!("an error with one slot only");
        };
        let one_slot = part(&mut prepared, &viewport, background)?;
        picture.has(&viewport, &one_slot).context("with many slots, with one")?;
        picture.check_parts(&mut prepared, &windows).context("with one slot")?;
        ensure!(
            prepared.faces().count() > 0 || picture.colors.iter().all(|color| *color == background),
            "a picture of no face"
        );
        Ok(Some(picture))
    }
}

impl Case for ShadingCase {
    fn check(&self) -> Verdict {
        match (self.method, self.kind) {
            // Each kind of pixels and depths with two or three of these four.
            (Method::FlatLit, Kind::FineDeepRgb565) => self.check_kind::<Fine<Deep<FlatLit<Rgb565, Lambert<2>>>>>(),
            (Method::FlatLit, Kind::FineBinary) => self.check_kind::<Fine<FlatLit<BinaryColor>>>(),
            (Method::FlatLit, Kind::Rgb888) => self.check_kind::<FlatLit<Rgb888, Lambert<2>>>(),
            (Method::FlatLit, _) => self.check_kind::<FlatLit<Rgb565>>(),
            (Method::Gouraud, Kind::FineRgb565) => self.check_kind::<Fine<Gouraud<Rgb565, Lambert<3>>>>(),
            (Method::Gouraud, Kind::DeepRgb565) => self.check_kind::<Deep<Gouraud<Rgb565, Lambert<0>>>>(),
            (Method::Gouraud, Kind::DeepGray8) => self.check_kind::<Deep<Gouraud<Gray8>>>(),
            (Method::Gouraud, _) => self.check_kind::<Gouraud<Rgb565>>(),
            (Method::Textured, Kind::DeepRgb565) => self.check_kind::<Deep<Textured<Texels<Rgb565, 8, 4>>>>(),
            (Method::Textured, Kind::FineBinary) => self.check_kind::<Fine<Textured<Texels<BinaryColor, 8, 4>, 8>>>(),
            (Method::Textured, Kind::Rgb888) => self.check_kind::<Textured<Texels<Rgb888, 8, 4>, 1>>(),
            (Method::Textured, _) => self.check_kind::<Textured<Texels<Rgb565, 8, 4>>>(),
            (Method::LitTextured, Kind::FineDeepRgb565) => {
                self.check_kind::<Fine<Deep<LitTextured<Texels<Rgb565, 1, 16>>>>>()
            }
            (Method::LitTextured, Kind::DeepGray8) => self.check_kind::<Deep<LitTextured<Texels<Gray8, 1, 16>>>>(),
            (Method::LitTextured, _) => self.check_kind::<Fine<LitTextured<Texels<Rgb565, 1, 16>, Lambert<3>>>>(),
            (Method::Holes, Kind::Rgb888) => self.check_kind::<Textured<CutOut<Indexed<Rgb888, 2, 4, 4>>>>(),
            (Method::Holes, Kind::FineDeepRgb565) => {
                self.check_kind::<Fine<Deep<Textured<CutOut<Indexed<Rgb565, 2, 4, 4>>>>>>()
            }
            (Method::Holes, _) => self.check_kind::<Textured<CutOut<Indexed<Rgb565, 2, 4, 4>>>>(),
            (Method::Mixed, _) => {
                self.check_kind::<LitTextured<Bilinear<Clamped<CutOut<Indexed<Rgb565, 2, 4, 4>>>>, Blinn<2, 2>>>()
            }
            (Method::Shiny, Kind::DeepGray8) => self.check_kind::<Deep<Gouraud<Gray8, Blinn<2, 2>>>>(),
            (Method::Shiny, _) => self.check_kind::<Gouraud<Rgb565, Blinn<2, 2>>>(),
            (Method::ShinyFlat, _) => self.check_kind::<FlatLit<Rgb888, Blinn<2, 2>>>(),
            (Method::FoggyFlat, _) => self.check_kind::<Foggy<FlatLit<Rgb565>>>(),
            (Method::FoggyGouraud, Kind::FineDeepRgb565) => {
                self.check_kind::<Fine<Deep<Foggy<Gouraud<Rgb565, Blinn<2, 2>>>>>>()
            }
            (Method::FoggyGouraud, _) => self.check_kind::<Foggy<Gouraud<Rgb565>>>(),
            (Method::FoggyHoles, _) => self.check_kind::<Foggy<Textured<CutOut<Indexed<Rgb565, 2, 4, 4>>>>>(),
            (Method::TranslucentFlat, Kind::FineBinary) => self.check_kind::<Fine<Translucent<FlatLit<BinaryColor>>>>(),
            (Method::TranslucentFlat, Kind::DeepGray8) => self.check_kind::<Deep<Translucent<FlatLit<Gray8>>>>(),
            (Method::TranslucentFlat, _) => self.check_kind::<Translucent<FlatLit<Rgb565>>>(),
            (Method::TranslucentHoles, _) => {
                self.check_kind::<Translucent<Textured<CutOut<Indexed<Rgb565, 2, 4, 4>>>>>()
            }
            (Method::AntialiasedFlat, Kind::FineBinary) => self.check_kind::<Fine<Antialiased<FlatLit<BinaryColor>>>>(),
            (Method::AntialiasedFlat, Kind::FineDeepRgb565) => {
                self.check_kind::<Antialiased<Fine<Deep<FlatLit<Rgb565>>>>>()
            }
            (Method::AntialiasedFlat, _) => self.check_kind::<Antialiased<FlatLit<Rgb888>>>(),
            (Method::AntialiasedHoles, _) => {
                self.check_kind::<Antialiased<Textured<CutOut<Indexed<Rgb565, 2, 4, 4>>>>>()
            }
            (Method::AntialiasedGlass, _) => self.check_kind::<Antialiased<Deep<Translucent<Gouraud<Rgb565>>>>>(),
            (Method::FoggyGlass, _) => self.check_kind::<Fine<Deep<Foggy<Translucent<Gouraud<Rgb565>>>>>>(),
        }
    }
}
