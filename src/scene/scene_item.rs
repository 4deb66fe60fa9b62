//! A scene as an item of a picture: in painter's order with shapes and texts, in groups, behind clips, with opacity.
//!
//! A picture borrows its items, and a scene that turns is prepared anew for each frame: so the item keeps what is prepared
//! behind a cell ([`RefCell`]), and is prepared through a shared reference. Drawing goes on from row to row as a scene that is
//! drawn by itself does.

use core::{cell::RefCell, fmt, ops::Range};

use crate::{
    band::Band,
    draw::PictureItem,
    geometry::{InputError, SubPixel, TooSmall, Window},
    scene::{
        Frame, Look, Model,
        back_faces::is_not_transformed,
        faces,
        off_screen::is_outside,
        prepared_faces::{FrameUniforms, PreparedFaces, RowMemory},
    },
    surface::Order,
    view::Camera,
    visible::{ByMethod, Silhouettes},
};

/// A scene as an item for [`Picture::add_item`](crate::draw::Picture::add_item): drawn over what was added before it, and
/// below what is added after it.
///
/// `L` is the [`Look`] of the scene's [`Memory`](crate::scene::Memory); `MODELS` is the number of models. All of them are
/// prepared together, as by [`Frame::prepare`], and the item draws what was prepared last. RAM beside that of the memory and
/// the models: 192 bytes on a 32-bit machine, and twice what is the same for all vertices of a model
/// ([`Shading::Uniforms`](crate::shade::Shading::Uniforms)), for one light 32.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, Rectangle}};
/// use zrow::fixed::types::{I16F16, U0F16};
/// use zrow::{
///     band::Band,
///     draw::{Picture, PictureSlot, PrimitiveStyle},
///     scene::{Camera, FaceSet, Memory, Model, Pose, Rotation, SceneItem},
/// };
///
/// let mesh = FaceSet::new(&[[-512, -512, 0], [0, 512, 0], [512, -512, 0]], &[[0, 1, 2]])?;
/// let triangle = Model::new(mesh, &[Rgb565::RED])?;
/// let turned = |turns| {
///     let rotation = Rotation::about_y(U0F16::from_num(turns));
///     triangle.with_pose(Pose::new(rotation, [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(1024)]))
/// };
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// let camera = Camera::new(area, I16F16::from_num(128))?;
/// let mut memory = Memory::<Rgb565, 3, 1, 64, 64, 1>::new();
/// let scene = SceneItem::new(memory.frame(), &camera, [turned(0.0)])?;
///
/// let (mut slots, mut buckets) = ([PictureSlot::EMPTY; 2], [0; 64]);
/// let mut picture = Picture::new(area, &mut slots, &mut [], &mut buckets);
/// let id = picture.add_item(&scene)?;
/// picture.add(&Circle::new(Point::new(30, 30), 5).into_styled(PrimitiveStyle::with_fill(Rgb565::WHITE)))?;
/// for step in 0..4 {
///     scene.prepare(&camera, [turned(step as f32 / 32.0)])?;
///     // It may have moved.
///     picture.replace_item(id, &scene)?;
///     let mut row = [0; 64];
///     picture.draw(&mut Band::<Rgb565>::new(Rectangle::new(Point::new(0, 32), Size::new(64, 1)), &mut row)?);
///     assert_eq!(row[28], Rgb565::RED.into_storage());
///     assert_eq!(row[32], Rgb565::WHITE.into_storage());
/// }
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
pub struct SceneItem<'f, 'm, L: Look, const MODELS: usize>(RefCell<Storage<'f, 'm, L, MODELS>>);

/// What is prepared, and what it is drawn with.
struct Storage<'f, 'm, L: Look, const MODELS: usize> {
    frame: Frame<'f, L>,
    models: [Model<'m, L::Shading>; MODELS],
    /// What it was prepared for; `None` where that failed.
    camera: Option<Camera>,
    fragments: Range<usize>,
    uniforms: FrameUniforms<L>,
}

impl<'f, 'm, L: Look, const MODELS: usize> SceneItem<'f, 'm, L, MODELS> {
    /// Prepares models for their first frame.
    ///
    /// # Errors
    /// Those of [`Frame::prepare`].
    pub fn new(
        frame: Frame<'f, L>,
        camera: &Camera,
        models: [Model<'m, L::Shading>; MODELS],
    ) -> Result<Self, InputError> {
        let mut storage = Storage {
            frame,
            models,
            camera: None,
            fragments: 0..0,
            uniforms: FrameUniforms::NONE,
        };
        storage.prepare(camera)?;
        Ok(Self(RefCell::new(storage)))
    }

    /// Prepares models, which need not be the same as before, for the frames from now on.
    ///
    /// Where they are on the screen may be somewhere else then: put the item in its own place again with
    /// [`Picture::replace_item`](crate::draw::Picture::replace_item), which also records what has changed.
    ///
    /// # Errors
    /// Those of [`Frame::prepare`]. The item then draws nothing until it is prepared.
    pub fn prepare(&self, camera: &Camera, models: [Model<'m, L::Shading>; MODELS]) -> Result<(), InputError> {
        // It is borrowed while it is drawn only, and that calls nothing of the program's.
        let Ok(mut storage) = self.0.try_borrow_mut() else {
            return Ok(());
        };
        storage.models = models;
        storage.prepare(camera)
    }
}

impl<M, L: Look<Visibility = ByMethod<M>>, const MODELS: usize> SceneItem<'_, '_, L, MODELS> {
    /// Why the method of a look that is [`VisibleBy`](crate::scene::VisibleBy) one did not draw a band since the item was prepared:
    /// the depth row drew it, and with so much memory the method would have. Of several bands the one that takes most; `None` where
    /// the method drew all of them.
    pub fn method_error(&self) -> Option<TooSmall> {
        self.0.try_borrow().ok()?.frame.silhouettes.row.visibility.error
    }
}

impl<L: Look, const MODELS: usize> Storage<'_, '_, L, MODELS> {
    fn prepare(&mut self, camera: &Camera) -> Result<(), InputError> {
        self.camera = None;
        self.fragments = self.frame.fill(camera, &self.models)?;
        self.uniforms = FrameUniforms::of(&self.models, camera);
        self.camera = Some(*camera);
        Ok(())
    }
}

impl<L: Look, O: Order, const MODELS: usize> PictureItem<L::Color, O> for SceneItem<'_, '_, L, MODELS> {
    /// The smallest box around the vertices as they were snapped, within the viewport; where some are off the screen, around
    /// what is left of the faces. Vertices all of whose faces were left out by their planes do not count. Cost: a look at each
    /// vertex, or at each face.
    fn bounds(&self) -> Window {
        let Ok(storage) = self.0.try_borrow() else {
            return Window::EMPTY;
        };
        let Storage { frame, models, .. } = &*storage;
        let vertices = frame.tables.vertices.get(..storage.fragments.start).unwrap_or_default();
        let Some(camera) = &storage.camera else {
            return Window::EMPTY;
        };
        let transformed = vertices.iter().filter(|vertex| !is_not_transformed::<L>(vertex));
        let around = if transformed.clone().any(is_outside) {
            let faces = faces::all::<L>(frame.tables.vertices, models, camera, storage.fragments.clone());
            let corners = faces.flat_map(|face| face.corners);
            box_around(corners.map(|corner| [corner.point.x_units(), corner.point.y_units()]))
        } else {
            box_around(transformed.map(|vertex| [vertex.x_units(), vertex.y_units()]))
        };
        // The first pixel whose centre is at a corner or after it, of silhouettes by area the one that the corner lies in, which may
        // begin half a pixel before; and the pixel after the last one whose centre is before a corner, or that a corner lies in.
        let one = 1 << <L::Precision as SubPixel>::FRACTION_BITS;
        let before = if L::Silhouettes::BY_AREA { one / 2 } else { one - 1 };
        let pixel = |units: i32, before: i32| (units + before) >> <L::Precision as SubPixel>::FRACTION_BITS;
        match around {
            Some([least, most]) => {
                let [left, top] = least.map(|units| pixel(units, before));
                let [right, bottom] = most.map(|units| pixel(units, one - 1));
                let around = Window {
                    left,
                    top,
                    right: right + 1,
                    bottom: bottom + 1,
                };
                around.intersection(&camera.viewport())
            }
            None => Window::EMPTY,
        }
    }

    fn draw(&self, band: &mut Band<'_, L::Color, O>) {
        let Ok(mut storage) = self.0.try_borrow_mut() else {
            return;
        };
        let Storage {
            frame,
            models,
            camera: Some(camera),
            uniforms,
            ..
        } = &mut *storage
        else {
            return;
        };
        let Frame {
            tables,
            depths,
            mut silhouettes,
            active,
        } = frame.reborrow();
        let faces = PreparedFaces::new(tables, models, camera, *uniforms);
        let (visibility, silhouettes) = silhouettes.parts();
        let rows = RowMemory {
            active,
            depths,
            silhouettes,
        };
        faces.draw_as_look(visibility, rows, band);
        *uniforms = faces.frame_uniforms();
    }
}

/// The least and the greatest x and y of some points; `None` where there are none.
#[inline]
fn box_around(mut points: impl Iterator<Item = [i32; 2]>) -> Option<[[i32; 2]; 2]> {
    let first = points.next()?;
    Some(points.fold([first; 2], |[[left, top], [right, bottom]], [x, y]| {
        [[left.min(x), top.min(y)], [right.max(x), bottom.max(y)]]
    }))
}

impl<L: Look, const MODELS: usize> fmt::Debug for SceneItem<'_, '_, L, MODELS> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debug = formatter.debug_struct("SceneItem");
        if let Ok(storage) = self.0.try_borrow() {
            debug.field("camera", &storage.camera);
        }
        debug.field("models", &MODELS).finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<L: Look, const MODELS: usize> defmt::Format for SceneItem<'_, '_, L, MODELS> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "SceneItem of {} models", MODELS);
    }
}
