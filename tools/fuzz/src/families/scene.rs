//! `zrow::scene` and `zrow::visible`: faces of any models, by their depth.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::{Rgb565, raw::RawU16},
    primitives::{PointsIter, Rectangle},
};
use zrow::{
    band::{Band, BigEndian, LittleEndian},
    draw::{Picture, PictureSlot},
    geometry::{InputError, Sub4, Sub8, TooSmall, Window},
    scene::{Camera, DepthWidth, FaceSet, Memory, Model, Prepared, SceneItem, ScreenPrecision},
};
use zrow_methods::LookOf;

use crate::{
    families::any_scene::{AnyModel, AnyScene, Kind, Large, case_of_each_kind, color, colors, models},
    picture::{Canvas, background, cut, is_same, sure},
    target::{Case, Verdict},
    values::{Length, List, Spot},
};

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

/// A part of the picture.
fn draw<S: ScreenPrecision, D: DepthWidth, const CUTS: bool>(
    prepared: &mut Prepared<'_, '_, LookOf<Rgb565, S, D, CUTS>>,
    window: Window,
) -> anyhow::Result<Vec<Rgb565>> {
    Canvas::new(window).draw::<LittleEndian>(|band| {
        prepared.draw(band);
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
        let full = draw::<S, D, true>(&mut prepared, viewport)?;
        let with_depths = Canvas::new(viewport).draw::<BigEndian>(|band| {
            prepared.draw_with(band, |_| {});
            Ok(())
        })?;
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
                let picture = draw::<S, D, true>(&mut prepared, band)?;
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
        let picture = draw::<S, D, true>(&mut prepared, around)?;
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
                let whole = draw::<S, D, false>(&mut prepared, viewport)?;
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
                    let picture = draw::<S, D, CUTS>(&mut prepared, *viewport)?;
                    if count == models.len() {
                        is_same(viewport, full, &picture).context("with large tables, with small ones")?;
                    } else {
                        let mut large = Large::<S, D, CUTS>::new();
                        let mut prepared = match large.prepare(camera, &models[..count]) {
                            Ok(prepared) => prepared,
                            Err(error) => bail!("{error} with room for all, where a small table has room"),
                        };
                        let other = draw::<S, D, CUTS>(&mut prepared, *viewport)?;
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
        let mark = Rgb565::from(RawU16::new(1));
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
            Ok(mut prepared) => draw::<S, u16, true>(&mut prepared, viewport)?,
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
        let plain = draw::<Sub8, u16, true>(&mut prepared, viewport)?;
        let color = |call: usize| Rgb565::from(RawU16::new(0x0101 + call as u16));
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
