//! Counts the clippers in space: segments, apart by what becomes of them and mixed, and faces that are cut.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{prelude::*, primitives::Rectangle};
use fixed::types::{I16F16, U0F16};
use zrow::{
    clip::{ClipMatrix, ClipPlane, ClipPoint, Segments, SpaceSegment},
    scene::{Camera, Pose, Rotation},
};
use zrow_measure_firmware::{
    inputs::Uniform,
    report,
    run::{Canvas, Runner},
    stopwatch::Stopwatch,
};

/// What becomes of a segment.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fate {
    /// Visible as it is.
    Inside,
    /// Visible after a cut.
    Crossing,
    /// Rejected.
    Outside,
}

/// What becomes of one segment after the other: a quarter is inside, a quarter crosses, half is outside.
const MIXED: [Fate; 4] = [Fate::Inside, Fate::Outside, Fate::Crossing, Fate::Outside];

type Vertex = [i16; 3];

/// What a camera sees, and all that was clipped to it, folded into one number.
struct Clipped {
    matrix: ClipMatrix,
    planes: [ClipPlane; 6],
    sum: u32,
}

impl Clipped {
    /// A camera in front of a turned model.
    fn new() -> Self {
        let pose = Pose::new(
            Rotation::about_y(U0F16::from_bits(black_box(9_000))),
            [0, 0, 600].map(I16F16::from_num),
        );
        let matrix = ClipMatrix::new(&camera(), &pose, I16F16::from_num(1_500));
        let Ok(matrix) = matrix else { report::exit(false) };
        Self {
            matrix,
            planes: matrix.planes(),
            sum: 0,
        }
    }

    fn add(&mut self, part: Option<SpaceSegment>) {
        let Some(part) = part else {
            self.sum = self.sum.rotate_left(5) ^ 1;
            return;
        };
        let (from, to) = part.ends(&self.matrix);
        self.add_point(from);
        self.add_point(to);
    }

    fn add_point(&mut self, ClipPoint { x, y, z, w }: ClipPoint) {
        for number in [x, y, z, w] {
            self.sum = self.sum.rotate_left(5) ^ number as u32 ^ (number >> 32) as u32;
        }
    }
}

impl Canvas for Clipped {
    fn erase(&mut self) {
        self.sum = 0;
    }

    fn checksum(&mut self) -> u32 {
        self.sum
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    for (fates, name) in [
        (&[Fate::Inside][..], "space.segment.inside"),
        (&[Fate::Crossing], "space.segment.crossing"),
        (&[Fate::Outside], "space.segment.outside"),
        (&MIXED, "space.segment.mixed"),
    ] {
        if runner.wants(name) {
            clippers(&mut runner, name, fates);
        }
    }
    if runner.wants("space.face.crossing") {
        face_clippers(&mut runner, "space.face.crossing");
    }
    if runner.wants("space.triangle") {
        triangles(&mut runner, "space.triangle");
    }
    report::exit(true)
}

/// A camera at the origin in front of which models are.
fn camera() -> Camera {
    let viewport = Rectangle::new(Point::zero(), Size::new(240, 320));
    let Ok(camera) = Camera::new(viewport, I16F16::from_num(64)) else {
        report::exit(false)
    };
    camera
}

/// The next face of the series that is cut and visible.
fn face(uniform: &mut Uniform, matrix: &ClipMatrix) -> [Vertex; 3] {
    loop {
        let mut vertex = || [0; 3].map(|_: i16| uniform.number(-1_200, 1_200) as i16);
        let vertices = [vertex(), vertex(), vertex()];
        let face = vertices.map(|vertex| (vertex, []));
        let is_inside = vertices.iter().all(|&vertex| matrix.apply(vertex).is_inside());
        if !is_inside && !matrix.sutherland_hodgman(&face).is_empty() {
            return vertices;
        }
    }
}

/// Counts the spans of triangles that are not clipped.
fn triangles(runner: &mut Runner, name: &str) {
    let (mut clipped, camera) = (Clipped::new(), camera());
    let mut uniform = Uniform::default();
    let inputs: [[Vertex; 3]; 20] = core::array::from_fn(|_| face(&mut uniform, &clipped.matrix));
    macro_rules! count {
        ($([$name:ident] [$($fill:tt)+])+) => {$(
            runner.count(name, stringify!($name), &mut clipped, &inputs, |canvas, &vertices| {
                let corners = vertices.map(|vertex| canvas.matrix.apply(vertex));
                let Ok(()) = $($fill)+(corners, &camera, &camera.viewport(), |span| {
                    canvas.sum = canvas.sum.rotate_left(5) ^ (span.start << 10 | span.end) as u32;
                    Ok::<(), Infallible>(())
                });
            });
        )+};
    }
    zrow_methods::homogeneous_triangles!(count);
}

/// Counts all clippers of faces with the same faces of a turned model, two attributes each.
fn face_clippers(runner: &mut Runner, name: &str) {
    let mut clipped = Clipped::new();
    let mut uniform = Uniform::default();
    let inputs: [[Vertex; 3]; 100] = core::array::from_fn(|_| face(&mut uniform, &clipped.matrix));
    macro_rules! count {
        ($([$name:ident] [$($clip:tt)+])+) => {$(
            runner.count(name, stringify!($name), &mut clipped, &inputs, |canvas, &[a, b, c]| {
                let face = [(a, [0, 0]), (b, [1_000, 0]), (c, [0, 1_000])];
                for (point, [u, v]) in $($clip)+(&canvas.matrix, &face) {
                    canvas.add_point(point);
                    canvas.sum = canvas.sum.rotate_left(5) ^ (u + v) as u32;
                }
            });
        )+};
    }
    zrow_methods::space_polygons!(count);
}

/// Counts all clippers with the same segments of a turned model.
fn clippers(runner: &mut Runner, name: &str, fates: &[Fate]) {
    let mut clipped = Clipped::new();
    let matrix = clipped.matrix;
    let mut uniform = Uniform::default();
    let mut fates = fates.iter().cycle();
    let inputs: [(Vertex, Vertex); 200] =
        core::array::from_fn(|_| segment(&mut uniform, &matrix, fates.next().copied().unwrap_or(Fate::Outside)));
    macro_rules! count {
        ($([$name:ident] [$($clip:tt)+])+) => {$(
            runner.count(name, stringify!($name), &mut clipped, &inputs, |canvas, &(from, to)| {
                canvas.add($($clip)+(from, to, &canvas.matrix));
            });
        )+};
    }
    zrow_methods::space_segments!(count);
    macro_rules! count_planes {
        ($([$name:ident] [$($clip:tt)+])+) => {$(
            runner.count(name, stringify!($name), &mut clipped, &inputs, |canvas, &(from, to)| {
                canvas.add($($clip)+(from, to, &canvas.planes));
            });
        )+};
    }
    zrow_methods::volume_segments!(count_planes);
}

/// The next segment of the series that meets this fate.
fn segment(uniform: &mut Uniform, matrix: &ClipMatrix, fate: Fate) -> (Vertex, Vertex) {
    let mut vertex = || [0; 3].map(|_: i16| uniform.number(-1_200, 1_200) as i16);
    loop {
        let (from, to) = (vertex(), vertex());
        let ends_inside = matrix.apply(from).is_inside() && matrix.apply(to).is_inside();
        let found = match Segments::homogeneous_liang_barsky(from, to, matrix) {
            None => Fate::Outside,
            Some(_) if ends_inside => Fate::Inside,
            Some(_) => Fate::Crossing,
        };
        if found == fate {
            return (from, to);
        }
    }
}
