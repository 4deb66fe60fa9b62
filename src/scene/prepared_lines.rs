//! The points and lines of a prepared frame: vertices, edges, their hidden and visible parts, and edges as lines in depth.

use crate::{
    geometry::TooSmall,
    mesh::Edge,
    scene::{
        Look, Prepared,
        depth_lines::{LineOf, lines_in_depth},
        edges::{self, ScreenEdge, ScreenPoint},
        lines::Lines,
    },
    visible::{HiddenLines, LinePart},
};

impl<'f, 'm, L: Look> Prepared<'f, 'm, L> {
    /// The vertices of all models that are on the screen, in the order of models and vertices, to draw a mesh as points.
    /// Vertices in front of the near plane, behind the far plane or beyond the guard band are left out; those that faces hide
    /// are not.
    ///
    /// A point has the index of its `model`, that of the `vertex` in its mesh, and its `corner`: the `point` that the vertex
    /// was snapped to and its `depth` as stored, nearer is larger. `corner.pixel()` is the pixel that it is in, which may be
    /// outside of the viewport.
    ///
    /// Cost: one comparison a vertex. Nothing is computed when the frame is prepared, and nothing linked where this is not
    /// called.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::I16F16;
    /// use zrow::{
    ///     band::Band,
    ///     scene::{Camera, FaceSet, Memory, Model},
    /// };
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// let mesh = FaceSet::new(&[[-512, -512, 1024], [0, 512, 1024], [512, -512, 1024]], &[[0, 1, 2]])?;
    /// let models = [Model::new(mesh, &[Rgb565::RED])?];
    /// let mut memory = Memory::<Rgb565, 3, 1, 64, 64>::new();
    /// let scene = memory.prepare(&camera, &models)?;
    /// let mut words = [0; 64 * 64];
    /// let mut band = Band::<Rgb565>::new(area, &mut words)?;
    /// for point in scene.points() {
    ///     let Ok(()) = Pixel(point.corner.pixel(), Rgb565::YELLOW).draw(&mut band);
    /// }
    /// assert_eq!(words.iter().filter(|word| **word != 0).count(), 3);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn points(&self) -> impl Iterator<Item = ScreenPoint<L::Precision, L::Depth>> + '_ {
        edges::points::<L>(self.faces.vertices, self.faces.models, &self.faces.camera)
    }

    /// The edges of a model that are to be drawn when it is drawn as lines: boundaries and creases where a face beside them is
    /// seen from the front, and smooth edges where one face is and the other one is not, which is where they are silhouettes.
    /// In a look that [draws backs](crate::scene::DoubleSided), boundaries and creases of faces that are seen from behind, too.
    ///
    /// `model` is an index of the models that were prepared, and `edges` a table of the edges of its mesh, as
    /// [`FaceSet::find_edges`](crate::scene::FaceSet::find_edges) finds them and `cargo run --release -- mesh MODEL.obj
    /// --edges 30` writes them. A model that is not there has no edges, and an edge of vertices or faces that are not there is
    /// left out.
    ///
    /// An edge has its `index` in the table, two `ends` (each the `point` that a vertex was snapped to, its `depth` as stored,
    /// and the `pixel()` that it is in), its [`kind`](crate::scene::EdgeKind), and `is_silhouette`: the surface ends there as
    /// it is seen. Edges are cut by the near plane, the far plane and the guard band, as faces are, and not by the viewport.
    /// What nearer faces hide of an edge is not cut off.
    ///
    /// Cost: the sense of two faces an edge, two to four products. Nothing is computed when the frame is prepared, and nothing
    /// linked where this is not called.
    ///
    /// ```
    /// use embedded_graphics::{
    ///     pixelcolor::Rgb565,
    ///     prelude::*,
    ///     primitives::{Line, Rectangle},
    /// };
    /// use zrow::fixed::types::{I2F14, I16F16};
    /// use zrow::{
    ///     band::Band,
    ///     draw::{DrawOn, PrimitiveStyle},
    ///     scene::{Camera, Edge, FaceSet, Memory, Model},
    /// };
    ///
    /// const VERTICES: [[i16; 3]; 4] = [[-512, -512, 1024], [-512, 512, 1024], [512, 512, 1024], [512, -512, 1024]];
    /// const FACES: [[u16; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
    /// /// The four sides, without the diagonal.
    /// static EDGES: [Edge; 4] = match FaceSet::find_edges(&VERTICES, &FACES, I2F14::lit("0.866")) {
    ///     Ok(edges) => edges,
    ///     Err(_) => panic!("a face names a vertex that is not there, or the table is too small"),
    /// };
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// let models = [Model::new(FaceSet::new(&VERTICES, &FACES)?, &[Rgb565::RED; 2])?];
    /// let mut memory = Memory::<Rgb565, 4, 2, 64, 64>::new();
    /// let scene = memory.prepare(&camera, &models)?;
    /// let mut words = [0; 64 * 64];
    /// let mut band = Band::<Rgb565>::new(area, &mut words)?;
    /// for edge in scene.edges(0, &EDGES) {
    ///     let [start, end] = edge.ends.map(|end| end.pixel());
    ///     let Ok(()) = Line::new(start, end)
    ///         .into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1))
    ///         .draw_on(&mut band);
    /// }
    /// // The sides left and right.
    /// assert_eq!(words[32 * 64..33 * 64].iter().filter(|word| **word != 0).count(), 2);
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn edges<'e>(
        &'e self,
        model: usize,
        edges: &'e [Edge],
    ) -> impl Iterator<Item = ScreenEdge<L::Precision, L::Depth>> + use<'e, 'f, 'm, L> {
        edges::edges::<L>(self.faces.vertices, self.faces.models, &self.faces.camera, model, edges)
    }

    /// The [`edges`](Self::edges) of a model that are to be drawn, each with the [`DepthLine`](crate::visible::DepthLine) that
    /// draws it over the faces of the scene: as a wireframe whose hidden parts are left out, or have another style.
    ///
    /// ```text
    ///           +---------+
    ///           |         |          an edge behind a box: its hidden part by the opposite comparison, in another colour
    ///     ------|- - - - -|------
    ///           |         |          the edges of the box over its own faces: by the offset no pixel is missing because
    ///           +---------+          depths are rounded, or taken half a pixel beside the edge
    /// ```
    ///
    /// With [`PolygonOffset::WIREFRAME`](crate::visible::PolygonOffset::WIREFRAME) a pixel of a line is in front of the faces
    /// beside its edge that cover it. The slope in the offset is the greater one of those of these faces, as far as they are
    /// seen; faces of which near plane or guard band cut something count by the parts that are left. What is nearer by more
    /// than the offset hides a pixel of the line.
    ///
    /// Cost: that of [`edges`](Self::edges) and four long divisions an edge, once a frame; a face that was cut is looked for
    /// among the parts of all such faces. Where this is not called nothing is linked for it.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::fixed::types::{I2F14, I16F16, U0F16};
    /// use zrow::{
    ///     band::Band,
    ///     scene::{Camera, Edge, FaceSet, Memory, Model, Pose, Rotation},
    ///     visible::{Comparison, DepthLine, DepthState, PolygonOffset},
    /// };
    ///
    /// // A pyramid; the first four faces are its sides.
    /// const VERTICES: [[i16; 3]; 5] = [[-512, -300, -512], [-512, -300, 512], [512, -300, 512], [512, -300, -512], [0, 400, 0]];
    /// const FACES: [[u16; 3]; 6] = [[0, 4, 3], [1, 4, 0], [2, 4, 1], [3, 4, 2], [0, 3, 2], [0, 2, 1]];
    /// static EDGES: [Edge; 9] = match FaceSet::find_edges(&VERTICES, &FACES, I2F14::lit("0.866")) {
    ///     Ok(edges) => edges,
    ///     Err(_) => panic!("a face names a vertex that is not there, or the table is too small"),
    /// };
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// let pose = Pose::new(Rotation::about_y(U0F16::from_num(0.06)), [0, 0, 1800].map(I16F16::from_num));
    /// let models = [Model::new(FaceSet::new(&VERTICES, &FACES)?, &[Rgb565::CSS_DIM_GRAY; 6])?.with_pose(pose)];
    /// let mut memory = Memory::<Rgb565, 5, 6, 64, 64>::new();
    /// let mut scene = memory.prepare(&camera, &models)?;
    ///
    /// // Once a frame.
    /// let lines: heapless::Vec<DepthLine<u16>, 9> = scene.lines_in_depth(0, &EDGES).map(|(_, line)| line).collect();
    /// let visible = DepthState { writes: false, offset: PolygonOffset::WIREFRAME, ..DepthState::NEARER };
    /// let hidden = DepthState { comparison: visible.comparison.opposite(), ..visible };
    /// let mut words = [0; 64 * 64];
    /// scene.draw_with(&mut Band::<Rgb565>::new(area, &mut words)?, |row| {
    ///     for line in &lines {
    ///         row.draw_line(line, Rgb565::CSS_GRAY, &hidden);
    ///     }
    ///     for line in &lines {
    ///         row.draw_line(line, Rgb565::WHITE, &visible);
    ///     }
    /// });
    /// assert!(words.contains(&Rgb565::WHITE.into_storage()));
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    pub fn lines_in_depth<'e>(
        &'e self,
        model: usize,
        edges: &'e [Edge],
    ) -> impl Iterator<Item = LineOf<L>> + use<'e, 'f, 'm, L> {
        let vertices = (self.faces.vertices, self.fragments.clone());
        lines_in_depth::<L>(vertices, self.faces.models, &self.faces.camera, model, edges)
    }

    /// The [`edges`](Self::edges) of all models, cut into parts that faces hide and parts that are visible, found by one of the
    /// methods of [`visible`](crate::visible). A method that is not named is not linked.
    ///
    /// `edges` has the table of edges of each model, in the order of models. A model without a table has no edges; its faces
    /// hide those of others.
    ///
    /// The parts of an edge follow each other from its first to its second end, hidden and visible ones in turns, and cover it
    /// without gaps. An edge whose ends are the same point on the screen has none. Outside of the viewport, hidden parts may be
    /// taken for visible ones.
    ///
    /// Last come the creases and boundaries at which all faces are turned away, which are none of the edges to be drawn: each is
    /// one hidden part, as where solids are closed. So a technical drawing has the back of a solid, dashed.
    ///
    /// A part has the `ends` of a line on the screen in sub-pixel units, and the `pixels()` that they are in; `is_hidden`; its
    /// [`kind`](crate::visible::PartKind); and the index of its `model` and its `edge`.
    ///
    /// ```
    /// use embedded_graphics::{
    ///     pixelcolor::Gray8,
    ///     prelude::*,
    ///     primitives::{Line, Rectangle},
    /// };
    /// use zrow::fixed::types::{I2F14, I16F16, U0F16};
    /// use zrow::{
    ///     band::Band,
    ///     draw::{DrawOn, PrimitiveStyle},
    ///     scene::{Camera, Edge, FaceSet, Memory, Model, Pose, Rotation},
    ///     visible::FaceAgainstSegment,
    /// };
    ///
    /// /// Vertex n of a cube lies at the bits of n.
    /// const VERTICES: [[i16; 3]; 8] = [
    ///     [-300, -300, -300], [300, -300, -300], [-300, 300, -300], [300, 300, -300],
    ///     [-300, -300, 300], [300, -300, 300], [-300, 300, 300], [300, 300, 300],
    /// ];
    /// const FACES: [[u16; 3]; 12] = [
    ///     [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
    ///     [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
    /// ];
    /// /// The twelve edges, without the diagonals.
    /// static EDGES: [Edge; 12] = match FaceSet::find_edges(&VERTICES, &FACES, I2F14::lit("0.866")) {
    ///     Ok(edges) => edges,
    ///     Err(_) => panic!("a face names a vertex that is not there, or the table is too small"),
    /// };
    ///
    /// let area = Rectangle::new(Point::zero(), Size::new(64, 64));
    /// let camera = Camera::new(area, I16F16::from_num(128))?;
    /// let rotation = Rotation::about_y(U0F16::lit("0.1")).then(&Rotation::about_x(U0F16::lit("0.92")));
    /// let pose = Pose::new(rotation, [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(1_200)]);
    /// let models = [Model::new(FaceSet::new(&VERTICES, &FACES)?, &[Gray8::BLACK; 12])?.with_pose(pose)];
    /// let mut memory = Memory::<Gray8, 8, 12, 64, 64>::new();
    /// let scene = memory.prepare(&camera, &models)?;
    ///
    /// let mut words = [0; 64 * 64];
    /// let mut band = Band::<Gray8>::new(area, &mut words)?;
    /// // Room for twelve faces, and for four segments that wait.
    /// let mut method = FaceAgainstSegment::<12, 4>::new();
    /// let (mut visible, mut hidden) = (0, 0);
    /// scene.visible_parts(&mut method, &[&EDGES], |part| {
    ///     *if part.is_hidden { &mut hidden } else { &mut visible } += 1;
    ///     let color = if part.is_hidden { Gray8::new(80) } else { Gray8::WHITE };
    ///     let [start, end] = part.pixels();
    ///     let Ok(()) = Line::new(start, end)
    ///         .into_styled(PrimitiveStyle::with_stroke(color, 1))
    ///         .draw_on(&mut band);
    /// })?;
    /// // Three of the edges meet in the corner that is farthest away.
    /// assert_eq!((visible, hidden), (9, 3));
    /// # Ok::<(), zrow::geometry::InputError>(())
    /// ```
    ///
    /// Technical drawings have hidden parts dashed: with a [`StrokeStyle`](crate::draw::StrokeStyle) that has
    /// [`dashes`](crate::draw::StrokeStyle::dashes), which [`DrawAntialiased`](crate::draw::DrawAntialiased) draws as well.
    ///
    /// # Errors
    /// The method has too little memory: says how much would do. Nothing was handed over.
    pub fn visible_parts(
        &self,
        method: &mut impl HiddenLines<L::Depth>,
        edges: &[&[Edge]],
        mut part: impl FnMut(LinePart<L::Precision>),
    ) -> Result<(), TooSmall> {
        let table = Lines::<L> {
            vertices: self.faces.vertices,
            models: self.faces.models,
            camera: &self.faces.camera,
            fragments: self.fragments.clone(),
            edges,
        };
        method.visible_parts(&table, &mut part)?;
        table.hand_over_turned_away(&mut part);
        Ok(())
    }
}
