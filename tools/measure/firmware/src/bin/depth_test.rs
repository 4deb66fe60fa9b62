//! Counts what is drawn into the rows of a torus and a cube at 128 x 64 by the test of their depths: the faces of another scene,
//! a wireframe, and a planar polygon; and a cube and a sphere combined by rays.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use fixed::types::{I2F14, I16F16, U0F16};
use heapless::Vec;
use zrow::{
    band::Band,
    geometry::InputError,
    scan::FillRule,
    scene::{Camera, DoubleSided, Edge, FaceSet, Memory, Model, Pose, Rotation},
    visible::{
        DepthLine, DepthPolygon, DepthState, PolygonOffset, RayCasting, SolidCombination, SolidNode, Visibility,
    },
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};
use zrow_scenes::{
    meshes::{CUBE, CUBE_COLORS, ICOSPHERE, ICOSPHERE_COLORS, TORUS_AND_CUBE, TORUS_AND_CUBE_COLORS},
    standard::{SmallTorus, stage},
};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(128, 64));
const PIXELS: usize = 128 * 64;

/// The frames that are counted.
const FRAMES: [u32; 4] = [0, 16, 32, 48];
/// The one of them in which solids are combined, because that takes a hundred times longer.
const LAST_FRAME: [u32; 1] = [48];

const TORUS_VERTICES: usize = TORUS_AND_CUBE.vertices().len();
const TORUS_FACES: usize = TORUS_AND_CUBE.faces().len();
const SPHERE_VERTICES: usize = ICOSPHERE.vertices().len();
const SPHERE_FACES: usize = ICOSPHERE.faces().len();
const CUBE_FACES: usize = CUBE.faces().len();
const SOLID_FACES: usize = CUBE_FACES + SPHERE_FACES;

/// The edges of the torus and the cube, but for those between two faces on one plane.
static EDGES: [Edge; {
    match TORUS_AND_CUBE.faces().first_chunk::<TORUS_FACES>() {
        Some(faces) => FaceSet::count_edges(TORUS_AND_CUBE.vertices(), faces),
        None => panic!("as many faces as there are"),
    }
}] = match TORUS_AND_CUBE.faces().first_chunk::<TORUS_FACES>() {
    Some(faces) => match FaceSet::find_edges(TORUS_AND_CUBE.vertices(), faces, I2F14::lit("0.998")) {
        Ok(edges) => edges,
        Err(_) => panic!("a face names a vertex that is not there"),
    },
    None => panic!("as many faces as there are"),
};

/// A star of eight points, clockwise, in front of the viewer.
const STAR: [[i16; 3]; 16] = [
    [900, 0, 1_536],
    [416, -172, 1_536],
    [636, -636, 1_536],
    [172, -416, 1_536],
    [0, -900, 1_536],
    [-172, -416, 1_536],
    [-636, -636, 1_536],
    [-416, -172, 1_536],
    [-900, 0, 1_536],
    [-416, 172, 1_536],
    [-636, 636, 1_536],
    [-172, 416, 1_536],
    [0, 900, 1_536],
    [172, 416, 1_536],
    [636, 636, 1_536],
    [416, 172, 1_536],
];
/// The star cut into triangles: its eight points, and the octagon between them.
static STAR_FACES: [[u16; 3]; 14] = [
    [15, 0, 1],
    [1, 2, 3],
    [3, 4, 5],
    [5, 6, 7],
    [7, 8, 9],
    [9, 10, 11],
    [11, 12, 13],
    [13, 14, 15],
    [1, 3, 5],
    [1, 5, 7],
    [1, 7, 9],
    [1, 9, 11],
    [1, 11, 13],
    [1, 13, 15],
];
static STAR_COLORS: [Rgb565; STAR_FACES.len()] = [STAR_COLOR; STAR_FACES.len()];
const STAR_COLOR: Rgb565 = Rgb565::YELLOW;

/// The wireframe over the faces beside it.
const WIREFRAME: DepthState<u16> = DepthState {
    writes: false,
    offset: PolygonOffset::WIREFRAME,
    ..DepthState::NEARER
};

/// The cube, the sphere, and an operation.
type Combination = [SolidNode; 3];

const fn combination(operation: SolidNode) -> Combination {
    const CUBE_END: u16 = CUBE_FACES as u16;
    [
        SolidNode::Primitive(0..CUBE_END),
        SolidNode::Primitive(CUBE_END..SOLID_FACES as u16),
        operation,
    ]
}

static UNION: Combination = combination(SolidNode::Union);
static INTERSECTION: Combination = combination(SolidNode::Intersection);
static DIFFERENCE: Combination = combination(SolidNode::Difference);

/// The torus and the cube, what is drawn into their rows, and the picture.
struct Picture {
    torus: Memory<Rgb565, TORUS_VERTICES, TORUS_FACES, 128, 64, 60>,
    sphere: Memory<Rgb565, SPHERE_VERTICES, SPHERE_FACES, 128, 64, 24>,
    /// The torus, the cube, and what else is drawn, as models of one scene.
    models: Memory<Rgb565, { TORUS_VERTICES + SPHERE_VERTICES }, { TORUS_FACES + SPHERE_FACES }, 128, 64, 84>,
    lines: Vec<DepthLine<u16>, { EDGES.len() }>,
    star: DepthPolygon<u16, { STAR.len() }>,
    words: [u16; PIXELS],
}

impl Picture {
    const EMPTY: Self = Self {
        torus: Memory::new(),
        sphere: Memory::new(),
        models: Memory::new(),
        lines: Vec::new(),
        star: DepthPolygon::new(),
        words: [0; PIXELS],
    };

    /// Counts frames that one of the methods below draws into the cleared picture.
    fn count(&mut self, runner: &mut Runner, variant: &str, draw: fn(&mut Self, u32) -> Result<(), InputError>) {
        runner.count("depth_test", variant, self, &FRAMES, |picture, &frame| {
            picture.words.fill(0);
            if draw(picture, frame).is_err() {
                report::exit(false)
            }
        });
    }

    /// The torus and the cube alone, with depths in each row.
    fn draw_nothing(&mut self, frame: u32) -> Result<(), InputError> {
        let (camera, torus) = torus(frame)?;
        let mut prepared = self.torus.prepare(&camera, &torus)?;
        prepared.draw_with(&mut Band::<Rgb565>::new(AREA, &mut self.words)?, |_| {});
        Ok(())
    }

    /// The icosphere as a scene of its own in the rows of the torus.
    fn draw_scene(&mut self, frame: u32) -> Result<(), InputError> {
        let ((camera, torus), sphere) = (torus(frame)?, [sphere()?]);
        let mut prepared = self.torus.prepare(&camera, &torus)?;
        let mut other = self.sphere.prepare(&camera, &sphere)?;
        prepared.draw_with(&mut Band::<Rgb565>::new(AREA, &mut self.words)?, |row| {
            other.draw_in(row, &DepthState::NEARER);
        });
        Ok(())
    }

    /// The icosphere as a model beside the torus.
    fn draw_sphere_as_model(&mut self, frame: u32) -> Result<(), InputError> {
        let (camera, [torus]) = torus(frame)?;
        let models = [torus, sphere()?];
        let mut prepared = self.models.prepare(&camera, &models)?;
        prepared.draw(&mut Band::<Rgb565>::new(AREA, &mut self.words)?);
        Ok(())
    }

    /// The edges of the torus and the cube over their faces.
    fn draw_lines(&mut self, frame: u32) -> Result<(), InputError> {
        let Self {
            torus: memory,
            lines,
            words,
            ..
        } = self;
        let (camera, torus) = torus(frame)?;
        let mut prepared = memory.prepare(&camera, &torus)?;
        lines.clear();
        lines.extend(prepared.lines_in_depth(0, &EDGES).map(|(_, line)| line));
        prepared.draw_with(&mut Band::<Rgb565>::new(AREA, words)?, |row| {
            for line in &*lines {
                row.draw_line(line, Rgb565::WHITE, &WIREFRAME);
            }
        });
        Ok(())
    }

    /// The star as a polygon.
    fn draw_polygon(&mut self, frame: u32) -> Result<(), InputError> {
        let Self {
            torus: memory,
            star,
            words,
            ..
        } = self;
        let (camera, torus) = torus(frame)?;
        let mut prepared = memory.prepare(&camera, &torus)?;
        prepared.prepare_polygon(star, &Pose::IDENTITY, &[&STAR], FillRule::NonZero)?;
        prepared.draw_with(&mut Band::<Rgb565>::new(AREA, words)?, |row| {
            row.draw_polygon(star, STAR_COLOR, &DepthState::NEARER);
        });
        Ok(())
    }

    /// The star as triangles of a model beside the torus.
    fn draw_triangles(&mut self, frame: u32) -> Result<(), InputError> {
        let (camera, [torus]) = torus(frame)?;
        let star = FaceSet::new(&STAR, &STAR_FACES)?;
        let models = [torus, Model::new(star, &STAR_COLORS)?];
        let mut prepared = self.models.prepare(&camera, &models)?;
        prepared.draw(&mut Band::<Rgb565>::new(AREA, &mut self.words)?);
        Ok(())
    }
}

impl Canvas for Picture {
    fn erase(&mut self) {
        self.words.fill(0);
    }

    /// Of the pixels of the last frame.
    fn checksum(&mut self) -> u32 {
        Checksum::of(self.words.iter().copied())
    }
}

/// The cube and the sphere around its faces, and their picture.
struct Solids {
    memory: Memory<DoubleSided<Rgb565>, { 8 + SPHERE_VERTICES }, SOLID_FACES, 128, 64, 60>,
    words: [u16; PIXELS],
}

impl Solids {
    const EMPTY: Self = Self {
        memory: Memory::new(),
        words: [0; PIXELS],
    };

    /// Counts a frame by a method, or by the depth row where there is none.
    fn count(&mut self, runner: &mut Runner, variant: &str, mut method: Option<&mut impl Visibility<u16>>) {
        runner.count("combined_solids", variant, self, &LAST_FRAME, |solids, &frame| {
            solids.words.fill(0);
            if solids.draw(frame, method.as_deref_mut()).is_err() {
                report::exit(false)
            }
        });
    }

    fn draw(&mut self, frame: u32, method: Option<&mut impl Visibility<u16>>) -> Result<(), InputError> {
        let (camera, pose) = stage::<SmallTorus>(AREA, frame)?;
        let models = [
            Model::new(CUBE, &CUBE_COLORS)?.with_pose(pose),
            Model::new(ICOSPHERE, &ICOSPHERE_COLORS)?.with_pose(pose),
        ];
        let mut prepared = self.memory.prepare(&camera, &models)?;
        let mut band = Band::<Rgb565>::new(AREA, &mut self.words)?;
        match method {
            Some(method) => prepared.draw_by(method, &mut band)?,
            None => prepared.draw(&mut band),
        }
        Ok(())
    }
}

impl Canvas for Solids {
    fn erase(&mut self) {
        self.words.fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.words.iter().copied())
    }
}

/// The torus and the cube in a frame, before the camera.
fn torus(frame: u32) -> Result<(Camera, [Model<'static, Rgb565>; 1]), InputError> {
    let (camera, pose) = stage::<SmallTorus>(AREA, frame)?;
    let torus = Model::new(TORUS_AND_CUBE, &TORUS_AND_CUBE_COLORS)?;
    Ok((camera, [torus.with_pose(pose)]))
}

/// The icosphere, in front of a part of the torus and behind another one.
fn sphere() -> Result<Model<'static, Rgb565>, InputError> {
    let pose = Pose::new(Rotation::about_y(U0F16::ZERO), [600, 0, 1_700].map(I16F16::from_num));
    Ok(Model::new(ICOSPHERE, &ICOSPHERE_COLORS)?.with_pose(pose))
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let picture = cortex_m::singleton!(: Picture = Picture::EMPTY);
    let solids = cortex_m::singleton!(: Solids = Solids::EMPTY);
    let (Some(peripherals), Some(picture), Some(solids)) = (Peripherals::take(), picture, solids) else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    if runner.wants("depth_test") {
        picture.count(&mut runner, "nothing", Picture::draw_nothing);
        picture.count(&mut runner, "scene", Picture::draw_scene);
        picture.count(&mut runner, "scene_as_model", Picture::draw_sphere_as_model);
        picture.count(&mut runner, "lines", Picture::draw_lines);
        picture.count(&mut runner, "polygon", Picture::draw_polygon);
        picture.count(&mut runner, "polygon_as_triangles", Picture::draw_triangles);
    }
    if runner.wants("combined_solids") {
        let rays = cortex_m::singleton!(: RayCasting<SOLID_FACES> = RayCasting::new());
        solids.count(&mut runner, "row", None::<&mut RayCasting<SOLID_FACES>>);
        solids.count(&mut runner, "rays", rays);
        for (variant, tree) in [
            ("union", &UNION),
            ("intersection", &INTERSECTION),
            ("difference", &DIFFERENCE),
        ] {
            let mut method = SolidCombination::<SOLID_FACES, 8>::new(tree);
            solids.count(&mut runner, variant, Some(&mut method));
        }
    }
    report::exit(true)
}
