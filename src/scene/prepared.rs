//! A frame ready to be drawn, band by band, in any order of rows.

use core::{cell::Cell, ops::Range};

use embedded_graphics::geometry::Point;

use crate::{
    band::{Band, Multisampled},
    coverage::SamplePattern,
    geometry::{InputError, TooSmall},
    scene::{
        Counters, Frame, Look, Model,
        back_faces::{faces_culled, vertices_not_transformed},
        by_method::check_method,
        culling::faces_left_out,
        estimate::RowDrawing,
        faces::{self, ScreenFace},
        frame::ActiveListOf,
        prepared_faces::{FrameUniforms, PreparedFaces, RowMemory},
        silhouette_tables::SilhouetteTables,
    },
    shade::{ChannelColor, InstructionSet},
    surface::Order,
    view::Camera,
    visible::{ByMethod, DepthRow, DepthState, DepthUse, GridRayCasting, Silhouettes, Visibility, Work, face_at},
};

/// A scene ready to be drawn, in the memory of a [`Frame`].
///
/// # Behind and in front of a scene
///
/// A scene draws the pixels that its faces cover and leaves the others as they were. What is drawn into a band before the
/// scene is behind all of it, at any distance, and what is drawn after it is in front of all of it. So a sky is one more line:
/// the band filled in a [`Paint`](crate::shade::Paint), such as a [`LinearGradient`](crate::shade::LinearGradient) or one of
/// the program's own that asks the camera where it looks. A sky box is a scene of its own that is drawn first, and what the
/// viewer holds in its hands one that is drawn last: each scene begins with cleared depths, so that neither needs a part of the
/// range of depths for itself (`glDepthRange`).
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::fixed::types::{I16F16, U0F16};
/// use zrow::{
///     band::{Band, Target},
///     draw::{DrawOn, PrimitiveStyle},
///     scene::{Camera, FaceSet, Memory, Model, Pose, Rotation},
///     shade::Paint,
/// };
///
/// /// Blue where the ray of a pixel rises, brown where it falls.
/// struct Horizon(Camera);
///
/// impl Paint for Horizon {
///     type Color = Rgb565;
///
///     fn colors_from(&self, start: Point) -> impl Iterator<Item = Rgb565> {
///         let camera = &self.0;
///         let (viewport, [x, y]) = (camera.viewport(), camera.centre());
///         // The direction of the ray in eye space, in half pixels, and how much it rises, with 14 fractional bits.
///         let right = 2 * (start.x - viewport.left) + 1 - (x.to_bits() >> 15);
///         let up = (y.to_bits() >> 15) - 2 * (start.y - viewport.top) - 1;
///         let ahead = camera.focal_length().to_bits() >> 15;
///         let [_, [rise_right, rise_up, rise_ahead], _] =
///             camera.pose().rotation.matrix().map(|row| row.map(|part| part.to_bits() >> 16));
///         let mut rise = right * rise_right + up * rise_up + ahead * rise_ahead;
///         core::iter::repeat_with(move || {
///             let color = if rise > 0 { Rgb565::CSS_SKY_BLUE } else { Rgb565::CSS_SADDLE_BROWN };
///             // To the next column, which is two half pixels away.
///             rise += 2 * rise_right;
///             color
///         })
///     }
/// }
///
/// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
/// // Looking up by a twelfth of a turn: the horizon goes down, by 32 pixels times tan 30 degrees.
/// let pose = Pose::new(Rotation::about_x(U0F16::from_num(11.0 / 12.0)), [I16F16::ZERO; 3]);
/// let camera = Camera::new(area, I16F16::from_num(128))?.with_pose(pose);
/// let mesh = FaceSet::new(&[[-256, 256, 1024], [0, 768, 1024], [256, 256, 1024]], &[[0, 1, 2]])?;
/// let models = [Model::new(mesh, &[Rgb565::RED])?];
/// let mut memory = Memory::<Rgb565, 3, 1, 64, 64>::new();
/// let mut scene = memory.prepare(&camera, &models)?;
///
/// let sky = area.into_styled(PrimitiveStyle::with_fill(Rgb565::BLACK));
/// let mut words = [0; 64 * 64];
/// let mut band = Band::<Rgb565>::new(area, &mut words)?;
/// let Ok(()) = sky.draw_on(&mut band.painted(&Horizon(camera)));
/// scene.draw(&mut band);
/// let color_at = |row: usize| band.words()[64 * row + 32];
/// assert_eq!(color_at(0), Rgb565::CSS_SKY_BLUE.into_storage());
/// assert_eq!(color_at(32), Rgb565::RED.into_storage());
/// assert_eq!(color_at(49), Rgb565::CSS_SKY_BLUE.into_storage());
/// assert_eq!(color_at(50), Rgb565::CSS_SADDLE_BROWN.into_storage());
/// # Ok::<(), zrow::geometry::InputError>(())
/// ```
///
/// A paint that takes long for a pixel can go where no face is instead, after the scene: [`draw_with`](Self::draw_with) hands
/// over each row, and `sky.draw_on(&mut row.at_depth(1).painted(&paint))` draws behind all that has a depth, which is 1 at
/// least. All rows are then drawn with depths, and translucent faces are mixed with what was in the band before.
#[derive(Debug)]
pub struct Prepared<'f, 'm, L: Look> {
    pub(super) faces: PreparedFaces<'f, 'm, L>,
    depths: &'f mut [L::Depth],
    silhouettes: SilhouetteTables<'f, L>,
    active: &'f mut ActiveListOf<L>,
    pub(super) fragments: Range<usize>,
}

impl<'f, 'm, L: Look> Prepared<'f, 'm, L> {
    /// Does not compile where a method that a program hands over does not draw the look.
    const fn check_method(paints_from_back: bool) {
        assert!(
            !L::IS_MULTISAMPLED,
            "only the depth row draws looks with several samples a pixel"
        );
        check_method::<L>(paints_from_back);
    }

    /// Prepares a frame in its memory.
    // Inlined, so that it is put together where it stays.
    #[inline]
    pub(super) fn new(
        mut frame: Frame<'f, L>,
        camera: &Camera,
        models: &'f [Model<'m, L::Shading>],
    ) -> Result<Self, InputError> {
        let fragments = frame.fill(camera, models)?;
        let Frame {
            tables,
            depths,
            silhouettes,
            active,
        } = frame;
        Ok(Self {
            faces: PreparedFaces::new(tables, models, camera, FrameUniforms::of(models, camera)),
            depths,
            silhouettes,
            active,
            fragments,
        })
    }

    /// Draws the rows of a band. Bands from top to bottom carry the active list on; any other order works and costs a
    /// new start.
    ///
    /// Pixels of the viewport outside the band, and of the band outside the viewport, are left alone.
    ///
    /// A look that is [`VisibleBy`](crate::scene::VisibleBy) a method is drawn by that.
    #[inline]
    pub fn draw<O: Order>(&mut self, band: &mut Band<'_, L::Color, O>) {
        let (faces, visibility, rows) = self.parts();
        faces.draw_as_look(visibility, rows, band);
    }

    /// Draws as [`draw`](Self::draw) does, and hands over each row when the scene is in it, so that more can be drawn
    /// with its depths: `|row| text.draw_on(&mut row.at_depth(depth))`.
    ///
    /// `row.at_depth(depth)` is a [`Target`](crate::surface::Target) of the row's pixels at a constant depth: what the scene
    /// has nearer stays, and of equal depths what was drawn first. `row.at_depth_with(depth, &state)` is one that tests depths by
    /// a [`DepthState`]. `row.draw_line(&line, color, &state)` draws a
    /// [`DepthLine`](crate::visible::DepthLine), and [`draw_in`](Self::draw_in) another
    /// scene. `row.depths()` are the depths, and `row.y()` is the number of the row in the picture.
    pub fn draw_with<O: Order>(
        &mut self,
        band: &mut Band<'_, L::Color, O>,
        more: impl FnMut(&mut DepthRow<'_, L::Color, O, L::Depth>),
    ) {
        self.draw_rows(band, DepthUse::Always, more);
    }

    /// Draws the faces of this scene into a row that another one hands over in its [`draw_with`](Self::draw_with), tested against
    /// the depths of the row by a state.
    ///
    /// Faces come in the order of models and faces, and of equally near ones the first stays where what is
    /// [nearer](DepthState::NEARER) is drawn. Each pixel is what a depth buffer of the whole picture would have. Translucent
    /// faces are mixed with what the row has when their turn comes. Pixels of the row outside of this scene's viewport are left
    /// alone. In looks with antialiased silhouettes or several samples a pixel this does not compile.
    ///
    /// A scene that is to be tested by a state as a whole is drawn into the rows of one without models. One that is drawn twice
    /// into the same row starts with all its faces anew each time: prepared twice it does not.
    ///
    /// RAM: none beside that of this scene, whose active list goes on from row to row. Cost: more than that of a row with depths
    /// by sorting the list, which is nearly in order, and by the test of each pixel, which no loop is specialized for; with a factor
    /// in the offset two long divisions a face and row. Where more faces cross a row than there are slots (`ACTIVE`), all faces
    /// are looked at for every 16 that are drawn.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     scene::{Camera, FaceSet, Memory, Model},
    ///     visible::{Comparison, DepthState},
    /// };
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// let wall = FaceSet::new(&[[-512, -512, 600], [-512, 512, 600], [0, 0, 600]], &[[0, 1, 2]])?;
    /// let walls = [Model::new(wall, &[Rgb565::BLUE])?];
    /// let behind = FaceSet::new(&[[-512, -512, 900], [0, 512, 900], [512, -512, 900]], &[[0, 1, 2]])?;
    /// let (seen, hidden) = ([Model::new(behind, &[Rgb565::RED])?], [Model::new(behind, &[Rgb565::CSS_DARK_RED])?]);
    ///
    /// let mut memories = [(); 3].map(|()| Memory::<Rgb565, 3, 1, 64, 64>::new());
    /// let [first, second, third] = &mut memories;
    /// let mut scene = first.prepare(&camera, &walls)?;
    /// let (mut seen, mut hidden) = (second.prepare(&camera, &seen)?, third.prepare(&camera, &hidden)?);
    ///
    /// // What is behind the wall is darker.
    /// let farther = DepthState { comparison: Comparison::Less, writes: false, ..DepthState::NEARER };
    /// let mut words = [0; 64 * 64];
    /// scene.draw_with(&mut Band::<Rgb565>::new(area, &mut words)?, |row| {
    ///     hidden.draw_in(row, &farther);
    ///     seen.draw_in(row, &DepthState::NEARER);
    /// });
    /// let row: Vec<_> = words[36 * 64..37 * 64].iter().map(|word| Rgb565::from(RawU16::new(*word))).collect();
    /// assert_eq!([row[6], row[25], row[34]], [Rgb565::BLUE, Rgb565::CSS_DARK_RED, Rgb565::RED]);
    /// # use embedded_graphics::pixelcolor::raw::RawU16;
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn draw_in<O: Order>(&mut self, row: &mut DepthRow<'_, L::Color, O, L::Depth>, state: &DepthState<L::Depth>) {
        const {
            assert!(
                !L::IS_MULTISAMPLED && !L::Silhouettes::BY_AREA,
                "such looks are drawn into rows of their own alone"
            )
        }
        self.active.draw_row_by_state(&self.faces, row, state);
    }

    /// Draws the rows of a band by another method than the depth row: the same picture, in other time and memory.
    ///
    /// A program that compares methods names them here, one that always draws by the same method names it in the look
    /// ([`VisibleBy`](crate::scene::VisibleBy)); what is not named is not linked.
    /// Looks with several samples a pixel need the depth row: with them this does not compile. Those with holes, translucent faces
    /// or antialiased silhouettes need the depth row or a method that paints from back to front:
    /// [`DepthSort`](crate::visible::DepthSort).
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     scene::{Camera, FaceSet, Memory, Model},
    ///     visible::DepthBuffer,
    /// };
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// let mut memory = Memory::<Rgb565, 3, 1, 64, 64>::new();
    /// let mesh = FaceSet::new(&[[-512, -512, 512], [0, 512, 512], [512, -512, 512]], &[[0, 1, 2]])?;
    /// let models = [Model::new(mesh, &[Rgb565::RED])?];
    /// let mut scene = memory.prepare(&camera, &models)?;
    ///
    /// let (mut by_rows, mut by_buffer) = ([0; 64 * 64], [0; 64 * 64]);
    /// scene.draw(&mut Band::<Rgb565>::new(area, &mut by_rows)?);
    /// let mut method = DepthBuffer::<u16, { 64 * 64 }>::new();
    /// scene.draw_by(&mut method, &mut Band::<Rgb565>::new(area, &mut by_buffer)?)?;
    /// assert_eq!(by_rows, by_buffer);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// The method has too little memory: says how much would do. The band is as it was.
    pub fn draw_by<O: Order, M: Visibility<L::Depth>>(
        &mut self,
        method: &mut M,
        band: &mut Band<'_, L::Color, O>,
    ) -> Result<(), TooSmall> {
        const { Self::check_method(M::PAINTS_FROM_BACK) }
        let (faces, _, rows) = self.parts();
        faces.draw_by(method, rows, band)
    }

    /// Draws as [`draw_by`](Self::draw_by) does, and reports the work that the method does, step by step: to show it, to count it,
    /// or to see which pixels a face has.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     scene::{Camera, FaceSet, Memory, Model},
    ///     visible::{Warnock, Work},
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
    /// let (mut method, mut windows, mut pixels) = (Warnock::<2>::new(), 0, [0; 2]);
    /// let mut words = [0; 64 * 64];
    /// scene.draw_by_with(&mut method, &mut Band::<Rgb565>::new(area, &mut words)?, |work| match work {
    ///     Work::Area { .. } => windows += 1,
    ///     Work::Painted { face, span } => pixels[face] += (span.end - span.start) as usize,
    ///     _ => {}
    /// })?;
    /// assert_eq!(windows, method.windows());
    /// let red = words.iter().filter(|word| **word == Rgb565::RED.into_storage());
    /// assert_eq!(pixels[0], red.count());
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// # Errors
    /// The method has too little memory: says how much would do. The band is as it was, and nothing was reported.
    pub fn draw_by_with<O: Order, M: Visibility<L::Depth>>(
        &mut self,
        method: &mut M,
        band: &mut Band<'_, L::Color, O>,
        report: impl FnMut(Work),
    ) -> Result<(), TooSmall> {
        const { Self::check_method(M::PAINTS_FROM_BACK) }
        let (faces, _, rows) = self.parts();
        faces.draw_by_with(method, rows, band, report)
    }

    /// Which face is seen in a pixel, as where a finger touches the panel: its index in the order of models and faces. `None`
    /// where none is, or outside the viewport. A face is also seen where it is translucent or has a hole.
    ///
    /// Cost: a look at each face that begins in the pixel's row or above it, and the depth of each that covers the pixel. For many
    /// pixels of a frame take [`picking`](Self::picking).
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::scene::{Camera, FaceSet, Memory, Model};
    ///
    /// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
    /// let mut memory = Memory::<Rgb565, 6, 2, 64, 64>::new();
    /// let near = FaceSet::new(&[[-512, -512, 512], [0, 512, 512], [512, -512, 512]], &[[0, 1, 2]])?;
    /// let far = FaceSet::new(&[[-512, -512, 700], [-512, 512, 700], [512, 512, 700]], &[[0, 1, 2]])?;
    /// let models = [Model::new(near, &[Rgb565::RED])?, Model::new(far, &[Rgb565::BLUE])?];
    /// let scene = memory.prepare(&camera, &models)?;
    /// assert_eq!(scene.face_at(Point::new(32, 32)), Some(0));
    /// assert_eq!(scene.face_at(Point::new(12, 12)), Some(1));
    /// assert_eq!(scene.face_at(Point::new(100, 4)), None);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn face_at(&self, point: Point) -> Option<usize> {
        let is_inside = self.faces.viewport.to_rectangle().contains(point);
        is_inside.then(|| face_at(&self.faces, [point.x, point.y])).flatten()
    }

    /// Puts the faces of the frame into a uniform grid, once, and returns a closure that says which face is seen in a pixel, as
    /// [`face_at`](Self::face_at) does: for many pixels of one frame.
    ///
    /// A ray from the eye marches through the cells (Amanatides and Woo 1987) and asks the faces in their lists: of a torus and a
    /// cube (588 faces), 8.7 a pixel that shows one, where `face_at` looks at 153. Memory is that of the [`GridRayCasting`], whose
    /// counters go on.
    ///
    /// # Errors
    /// [`TooSmall::Faces`] with the number of faces in the viewport, where the grid has room for less.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     scene::{Camera, FaceSet, Memory, Model},
    ///     visible::GridRayCasting,
    /// };
    ///
    /// let camera = Camera::new(Rectangle::new(Point::zero(), Size::new(64, 64)), I16F16::from_num(128))?;
    /// let mut memory = Memory::<Rgb565, 6, 2, 64, 64>::new();
    /// let near = FaceSet::new(&[[-512, -512, 512], [0, 512, 512], [512, -512, 512]], &[[0, 1, 2]])?;
    /// let far = FaceSet::new(&[[-512, -512, 700], [-512, 512, 700], [512, 512, 700]], &[[0, 1, 2]])?;
    /// let models = [Model::new(near, &[Rgb565::RED])?, Model::new(far, &[Rgb565::BLUE])?];
    /// let scene = memory.prepare(&camera, &models)?;
    ///
    /// let mut grid = GridRayCasting::<2, 16, 32>::new();
    /// let mut face_at = scene.picking(&mut grid)?;
    /// assert_eq!(face_at(Point::new(32, 32)), Some(0));
    /// assert_eq!(face_at(Point::new(12, 12)), Some(1));
    /// assert_eq!(face_at(Point::new(100, 4)), None);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn picking<'p, const FACES: usize, const CELLS: usize, const ENTRIES: usize>(
        &'p self,
        grid: &'p mut GridRayCasting<FACES, CELLS, ENTRIES>,
    ) -> Result<impl FnMut(Point) -> Option<usize>, TooSmall> {
        let viewport = self.faces.viewport.to_rectangle();
        let mut face_at = grid.picking(&self.faces)?;
        Ok(move |point: Point| viewport.contains(point).then(|| face_at([point.x, point.y])).flatten())
    }

    #[inline]
    fn draw_rows<O: Order>(
        &mut self,
        band: &mut Band<'_, L::Color, O>,
        depth_use: DepthUse,
        more: impl FnMut(&mut DepthRow<'_, L::Color, O, L::Depth>),
    ) {
        let (faces, _, rows) = self.parts();
        faces.draw(rows, band, depth_use, more);
    }

    /// The faces, how the look finds out which are seen, and the memory of rows.
    #[inline(always)]
    fn parts(&mut self) -> (&PreparedFaces<'f, 'm, L>, &mut L::Visibility, RowMemory<'_, L>) {
        let (visibility, silhouettes) = self.silhouettes.parts();
        let rows = RowMemory {
            active: self.active,
            depths: self.depths,
            silhouettes,
        };
        (&self.faces, visibility, rows)
    }

    /// Draws the rows of a band into the samples of its pixels, which [`Band::multisample`] hands over, in a look that is
    /// [`Multisampled`](crate::scene::Multisampled). Shapes before and after it keep painter's order, sample by sample.
    ///
    /// A sample is covered by the rule of the centre of a pixel (on a top or left edge it is, on a bottom or right edge it is
    /// not), exactly: faces that share an edge share no sample and leave none out. Each sample has a depth, that of the face
    /// where the sample is, and shows the nearest face; of equally near ones the first in the order of models. A face has one
    /// colour in all samples of a pixel if nothing varies over it; otherwise each sample is shaded where it is, not at the
    /// centre of the pixel, which may be outside of the face.
    ///
    /// Positions of samples are rounded down to the units of the look: those of 4 and 8 rooks and of grids are multiples of
    /// 1/16 pixel, those of 16 rooks are 1/32 pixel higher and farther left in looks that are not
    /// [`Fine`](crate::scene::Fine).
    ///
    /// Bands may come in any order; from top to bottom the list of faces goes on. Cost: each row is drawn once a sample, one
    /// after the other with the same row of depths, and each face of the row is set up for that.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     coverage::{Rooks, SamplePattern},
    ///     scene::{Camera, FaceSet, Memory, Model, Multisampled},
    /// };
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// // One unit is 1/32 pixel there: the left side is 1/4 pixel right of the middle of the picture.
    /// let mesh = FaceSet::new(&[[8, -400, 1024], [8, 400, 1024], [800, 0, 1024]], &[[0, 1, 2]])?;
    /// let models = [Model::new(mesh, &[Gray8::WHITE])?];
    /// let mut memory = Memory::<Multisampled<Gray8>, 3, 1, 64, 64>::new();
    /// let mut scene = memory.prepare(&camera, &models)?;
    ///
    /// // A band of one row.
    /// let (mut row, mut samples) = ([0; 64], [0; 64 * Rooks::<4>::SAMPLES]);
    /// let mut band = Band::<Gray8>::new(Rectangle::new(Point::new(0, 32), Size::new(64, 1)), &mut row)?;
    /// band.multisample(Rooks::<4>, &mut samples, |samples| scene.draw_samples(samples))?;
    /// // Three of four samples are right of the side.
    /// assert_eq!(row[31..34], [0, 191, 255]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn draw_samples<O: Order, P: SamplePattern>(&mut self, samples: &mut Multisampled<'_, L::Color, O, P>)
    where
        L::Color: ChannelColor,
    {
        const {
            assert!(
                L::IS_MULTISAMPLED,
                "only looks that are `Multisampled` are drawn into samples"
            )
        }
        let (faces, _, rows) = self.parts();
        faces.draw_samples(rows, samples);
    }

    /// How many rows [`draw`](Self::draw) has drawn without depths since the frame was prepared, because no face overlapped
    /// another in them. The picture is the same with depths, which is what `draw_with` does.
    ///
    /// From the first row with an overlap on, the frame is drawn with depths, and so are the 16 that are prepared after it. In
    /// looks whose attributes are divided by the depth, such as textures, each row that at most four faces cross is looked at by
    /// itself.
    pub const fn rows_without_depth(&self) -> u32 {
        self.active.rows_without_depth()
    }

    /// How many rows were drawn in more than one pass since the frame was prepared, because more faces cross them than the
    /// frame has room for (`ACTIVE`). The picture is the same; such rows take longer.
    pub const fn rows_in_passes(&self) -> u32 {
        self.active.rows_in_passes()
    }

    /// Predicts how many instructions of a set drawing all rows of the frame will take, so that a program picks a coarser mesh
    /// before it draws, or leaves something out. Where this is not called nothing is linked for it.
    ///
    /// Counted are the rows that [`PictureLoop`](crate::band::PictureLoop) draws in bands of one row and fills with a
    /// background before; not what the sink does with them, and not what preparing the frame took. The weights were found on
    /// emulated chips, for code at opt-level 3 with link-time optimization, one codegen unit and no overflow checks; other
    /// settings take another multiple of it. The mean of a turn is within 15 % in every scene that `cargo run --release --
    /// measure --only estimate` counts, to all of which the weights were fitted; a single frame may be off by more.
    ///
    /// - Whether faces overlap, so that a row needs depths, shows when it is drawn: a frame is predicted to be as the last one
    ///   that was drawn in the same memory, the first one to need depths. A frame in which that changes may be off by a half.
    /// - All pixels of faces are predicted to be seen. Those that others hide take less: much less where textures are mixed, or
    ///   in fog.
    /// - [Rows in passes](Self::rows_in_passes) may be off by a third, and so may translucent faces, of which several are seen
    ///   through each other. Two faces that have the same depth in many pixels take more than is predicted.
    ///
    /// Cost: some 110 instructions for each face to be drawn, of a first model with more than 256 faces for every fourth one,
    /// and some 20 a row and each face that is left out of that. On a Cortex-M4 that is 24,500 for a teapot of 992 faces at 240
    /// x 320, 5 % of its frame in one colour a face; twice as many where attributes are divided or silhouettes are antialiased.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     geometry::InputError,
    ///     scene::{Camera, FaceSet, InstructionSet, Memory, Model},
    /// };
    ///
    /// const VERTICES: [[i16; 3]; 5] = [[-512, -512, 0], [-512, 512, 0], [512, 512, 0], [512, -512, 0], [0, 0, -256]];
    /// /// A pyramid, and its base: levels of detail with the same vertices, as `--levels` writes them.
    /// const LEVELS: [&[[u16; 3]]; 2] = [&[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], &[[0, 1, 2], [0, 2, 3]]];
    /// /// A frame shall take 40,000 instructions at most.
    /// const BUDGET: u32 = 40_000;
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// let mut memory = Memory::<Rgb565, 5, 4, 64, 64>::new();
    /// let mut words = [0; 64 * 64];
    /// let mut drawn = [0; 2];
    /// for distance in [600, 1000, 2000] {
    ///     for (level, faces) in LEVELS.iter().enumerate() {
    ///         let mut model = Model::new(FaceSet::new(&VERTICES, faces)?, &[Rgb565::RED; 4])?;
    ///         model.pose.translation = [0, 0, distance].map(I16F16::from_num);
    ///         let models = [model];
    ///         let mut scene = memory.prepare(&camera, &models)?;
    ///         let is_coarsest = level + 1 == LEVELS.len();
    ///         if is_coarsest || scene.estimate(InstructionSet::Armv7M) <= BUDGET {
    ///             scene.draw(&mut Band::<Rgb565>::new(area, &mut words)?);
    ///             drawn[level] += 1;
    ///             break;
    ///         }
    ///     }
    /// }
    /// assert_eq!(drawn, [2, 1]);
    /// # Ok::<(), InputError>(())
    /// ```
    pub fn estimate(&self, set: InstructionSet) -> u32 {
        let drawing = if L::DRAWS_IN_PASSES && self.active.needs_passes() {
            RowDrawing::InPasses(self.active.capacity())
        } else if self.active.is_disjoint() {
            RowDrawing::Disjoint
        } else {
            RowDrawing::WithDepths
        };
        self.faces.estimate(set, drawing)
    }

    /// How many vertices the frame took: those of the models, and of the fragments of faces that were cut. With so many for
    /// `VERTICES` it can be prepared.
    pub const fn vertices_needed(&self) -> usize {
        self.fragments.end
    }

    /// The most faces that cross one row: with so many for `ACTIVE`, each row is drawn in one pass.
    pub fn active_needed(&self) -> usize {
        self.faces.most_active()
    }

    /// All faces on the screen as they were snapped: the whole ones in the order of models and faces, whether they face
    /// the viewer or not, then the visible fragments of those that were cut, in the same order.
    ///
    /// A face has an `order`, its index in the order of models and faces (of two fragments with the same depth, the
    /// lower one is drawn), and three `corners` in the order of the mesh (the second and the third exchanged where a map
    /// mirrors the model, and once more where its back is [drawn](crate::scene::DoubleSided)), each with the `point` that it
    /// was snapped to and its `depth` as stored: nearer is larger.
    ///
    /// [`points`](Self::points) and [`edges`](Self::edges) are what a mesh is drawn as points or lines with.
    pub fn faces(&self) -> impl Iterator<Item = ScreenFace<L::Precision, L::Depth>> + '_ {
        faces::all::<L>(
            self.faces.vertices,
            self.faces.models,
            &self.faces.camera,
            self.fragments.clone(),
        )
    }
}

impl<M, L: Look<Visibility = ByMethod<M>>> Prepared<'_, '_, L> {
    /// The method of a look that is [`VisibleBy`](crate::scene::VisibleBy) one, with what it has counted since its memory was made.
    pub const fn method(&self) -> &M {
        &self.silhouettes.row.visibility.method
    }

    /// Why the method of a look that is [`VisibleBy`](crate::scene::VisibleBy) one did not draw a band since the frame was
    /// prepared: the depth row drew it, and with so much memory the method would have. Of several bands the one that takes most;
    /// `None` where the method drew all of them.
    pub const fn method_error(&self) -> Option<TooSmall> {
        self.silhouettes.row.visibility.error
    }
}

impl<L: Look<Counting = Cell<Counters>>> Prepared<'_, '_, L> {
    /// What the frame took, and what its rows took that were drawn up to now.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     scene::{Camera, Counted, FaceSet, Memory, Model},
    /// };
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// let mut memory = Memory::<Counted<Rgb565>, 3, 1, 64, 64>::new();
    /// let mesh = FaceSet::new(&[[-512, -512, 512], [0, 512, 512], [512, -512, 512]], &[[0, 1, 2]])?;
    /// let models = [Model::new(mesh, &[Rgb565::RED])?];
    /// let mut scene = memory.prepare(&camera, &models)?;
    /// scene.draw(&mut Band::<Rgb565>::new(area, &mut [0; 64 * 64])?);
    /// let counters = scene.counters();
    /// // Nothing overlaps: no depth is tested.
    /// assert!(counters.spans_filled > 0 && counters.pixels_tested == 0);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn counters(&self) -> Counters {
        let [whole, cut] = self.faces.drawn(self.fragments.start);
        let models = self.faces.models.iter();
        let faces = models.map(|model| model.mesh().faces().len() as u32).sum::<u32>();
        Counters {
            faces,
            faces_culled: faces - whole - cut,
            faces_culled_by_bounds: faces_left_out::<L>(self.faces.vertices, self.faces.models),
            faces_culled_by_planes: faces_culled::<L>(self.faces.vertices, self.faces.models, &self.faces.camera),
            vertices_not_transformed: vertices_not_transformed::<L>(self.faces.vertices, self.faces.models),
            faces_cut: cut,
            rows_without_depth: self.rows_without_depth(),
            rows_in_passes: self.rows_in_passes(),
            ..self.faces.counting.get()
        }
    }
}

#[cfg(feature = "defmt")]
impl<L: Look> defmt::Format for Prepared<'_, '_, L> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(
            formatter,
            "Prepared {} vertices, {} faces in a row of {}",
            self.vertices_needed(),
            self.active_needed(),
            self.faces.viewport
        );
    }
}
