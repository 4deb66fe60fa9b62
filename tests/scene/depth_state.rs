//! Scenes, shapes and lines drawn by a state of the depth test, against a depth buffer of the whole picture that takes one
//! face after the other: all comparisons with and without writing, with offsets and ranges, in bands of any height.
//!
//! The reference has the depths of a face from a scene that has this face alone, and everything else in `i128`.

use embedded_graphics::{
    pixelcolor::Rgb888,
    prelude::*,
    primitives::{Circle, Rectangle},
};
use fixed::types::I16F16;
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{DrawOn, PrimitiveStyle},
    geometry::{Sub4, Sub8},
    scan::Lines,
    scene::{Camera, DepthWidth, Memory, Model, Pose},
    visible::{Comparison, DepthLine, DepthState, PolygonOffset},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{Format, LookIn, area, color_of};
use crate::random_faces::{faces, pose};
use crate::reference::nearest_faces::Face;
use crate::snapped_faces::{camera, snapped, standard_pose};

const WIDTH: u32 = 48;
const HEIGHT: u32 = 40;
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

type MemoryOf<S, D, const ACTIVE: usize = 128> =
    Memory<LookIn<S, D>, 900, 600, { WIDTH as usize }, { HEIGHT as usize }, ACTIVE>;

const COMPARISONS: [Comparison; 8] = [
    Comparison::Never,
    Comparison::Less,
    Comparison::Equal,
    Comparison::LessOrEqual,
    Comparison::Greater,
    Comparison::NotEqual,
    Comparison::GreaterOrEqual,
    Comparison::Always,
];

/// The words and the depths of all pixels.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Picture {
    words: Vec<u32>,
    depths: Vec<u32>,
}

/// A picture in bands of a height, from above or from below; the closure draws a band and hands over the rows of depths.
fn in_bands(
    (height, upwards): (u32, bool),
    mut draw: impl FnMut(&mut Band<'_, Rgb888>, &mut dyn FnMut(i32, Vec<u32>)),
) -> Picture {
    let (mut words, mut depths) = (vec![0; PIXELS], vec![0; PIXELS]);
    let mut tops: Vec<u32> = (0..HEIGHT).step_by(height as usize).collect();
    if upwards {
        tops.reverse();
    }
    let width = WIDTH as usize;
    for top in tops {
        let part = Rectangle::new(Point::new(0, top as i32), Size::new(WIDTH, height.min(HEIGHT - top)));
        let first = top as usize * width;
        let words = &mut words[first..first + width * part.size.height as usize];
        draw(&mut Band::new(part, words).unwrap(), &mut |y, row| {
            depths[y as usize * width..][..width].copy_from_slice(&row);
        });
    }
    Picture { words, depths }
}

fn numbers<D: DepthWidth>(depths: &[D]) -> Vec<u32> {
    depths.iter().map(|depth| (*depth).into()).collect()
}

/// What is drawn into a scene: a mesh whose faces have numbers from 1,000 on.
struct Second {
    mesh: Mesh,
    colors: Vec<Rgb888>,
    pose: Pose,
}

impl Second {
    fn new(mesh: Mesh, pose: Pose) -> Self {
        let colors = (0..mesh.faces.len()).map(|face| color_of(face + 1_000)).collect();
        Self { mesh, colors, pose }
    }

    fn models(&self) -> [Model<'_, Rgb888>; 1] {
        [Model::new(self.mesh.face_set(), &self.colors)
            .unwrap()
            .with_pose(self.pose)]
    }
}

/// The depths of a mesh's faces, each drawn alone, and the parts of faces in the order in which they are drawn.
struct Alone {
    depths: Vec<Vec<u32>>,
    parts: Vec<Face>,
}

fn alone<S: Format<D>, D: DepthWidth>(second: &Second, camera: &Camera) -> Alone {
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let models = second.models();
    let mut parts = snapped(&memory.prepare(camera, &models).unwrap());
    parts.sort_by_key(|part| part.order);
    let depths = second.mesh.faces.iter().map(|face| {
        let one = Second::new(Mesh::new(second.mesh.vertices.clone(), vec![*face]), second.pose);
        let models = one.models();
        let mut prepared = memory.prepare(camera, &models).unwrap();
        let drawn = in_bands((HEIGHT, false), |band, keep| {
            prepared.draw_with(band, |row| keep(row.y(), numbers(row.depths())));
        });
        drawn.depths
    });
    Alone {
        depths: depths.collect(),
        parts,
    }
}

/// The greatest slope of a face, in fractions of interpolated depths.
fn slope<S: Format<D>, D: DepthWidth>(face: &Face) -> i128 {
    let [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = face.corners;
    let area = ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)).abs();
    if area == 0 {
        // Seen on edge: no pixel asks for it.
        return 0;
    }
    let per_column = (z1 - z0) * (y2 - y0) - (z2 - z0) * (y1 - y0);
    let per_row = (x1 - x0) * (z2 - z0) - (x2 - x0) * (z1 - z0);
    let steepest = per_column.abs().max(per_row.abs()) << (S::FRACTION_BITS + D::FRACTION_BITS);
    nearest(steepest, area).min(u32::MAX.into())
}

/// A quotient to the nearest, halves up.
fn nearest(dividend: i128, divisor: i128) -> i128 {
    (2 * dividend + divisor).div_euclid(2 * divisor)
}

/// The depth that is compared.
fn depth_in<D: DepthWidth>(state: &DepthState<D>, slope: i128, depth: u32) -> u32 {
    let [farthest, closest] = state.range.map(|depth| i128::from(depth.into()));
    let all = i128::from(D::NEAREST.into());
    let mapped = farthest + nearest(i128::from(depth) * (closest - farthest), all);
    let slope = nearest(slope * (closest - farthest).abs(), all);
    // In 1/65,536 of the fractions of interpolated depths.
    let offset =
        i128::from(state.offset.factor.to_bits()) * slope + (i128::from(state.offset.units) << (D::FRACTION_BITS + 16));
    let step = 1 << (16 + if D::FRACTION_BITS == 16 { 16 } else { 0 });
    let moved = mapped + nearest(offset, step);
    let (least, greatest) = (farthest.min(closest).max(1), farthest.max(closest).max(1));
    moved.clamp(least, greatest) as u32
}

fn is_drawn(comparison: Comparison, depth: u32, stored: u32) -> bool {
    match comparison {
        Comparison::Never => false,
        Comparison::Less => depth < stored,
        Comparison::Equal => depth == stored,
        Comparison::LessOrEqual => depth <= stored,
        Comparison::Greater => depth > stored,
        Comparison::NotEqual => depth != stored,
        Comparison::GreaterOrEqual => depth >= stored,
        Comparison::Always => true,
    }
}

impl Picture {
    /// Draws a pixel with a depth that is compared.
    fn draw<D: DepthWidth>(&mut self, index: usize, word: u32, depth: u32, state: &DepthState<D>) {
        if is_drawn(state.comparison, depth, self.depths[index]) {
            self.words[index] = word;
            if state.writes {
                self.depths[index] = depth;
            }
        }
    }

    /// Draws the faces one after the other.
    fn draw_faces<S: Format<D>, D: DepthWidth>(&mut self, alone: &Alone, state: &DepthState<D>) {
        let unit = 1 << S::FRACTION_BITS;
        for part in &alone.parts {
            let slope = slope::<S, D>(part);
            for (index, point) in area(WIDTH, HEIGHT).points().enumerate() {
                if part.covers(i128::from(point.x) * unit, i128::from(point.y) * unit) {
                    let stored = alone.depths[part.order][index];
                    assert!(stored > 0);
                    let word = color_of(part.order + 1_000).into_storage();
                    self.draw(index, word, depth_in(state, slope, stored), state);
                }
            }
        }
    }
}

/// Draws a mesh into another one's scene by states, with little and with enough memory; returns how many pixels a state changed.
fn check<S: Format<D>, D: DepthWidth>(first: &Second, second: &Second, states: &[DepthState<D>]) -> usize {
    let camera = camera(area(WIDTH, HEIGHT));
    let alone = alone::<S, D>(second, &camera);
    let (models, more) = (first.models(), second.models());
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let mut scene = memory.prepare(&camera, &models).unwrap();
    let before = in_bands((HEIGHT, false), |band, keep| {
        scene.draw_with(band, |row| keep(row.y(), numbers(row.depths())));
    });
    let mut changed = 0;
    for (number, state) in states.iter().enumerate() {
        let mut expected = before.clone();
        expected.draw_faces::<S, D>(&alone, state);
        changed += expected.words.iter().zip(&before.words).filter(|(a, b)| a != b).count();
        macro_rules! check {
            ($active:literal, $bands:expr) => {
                let mut others = Box::new(MemoryOf::<S, D, $active>::new());
                let mut other = others.prepare(&camera, &more).unwrap();
                let drawn = in_bands($bands, |band, keep| {
                    scene.draw_with(band, |row| {
                        other.draw_in(row, state);
                        keep(row.y(), numbers(row.depths()));
                    });
                });
                assert!(
                    drawn == expected,
                    "{state:?}, {} slots, bands {:?}",
                    $active,
                    $bands
                );
            };
        }
        match number % 4 {
            0 => {
                check!(128, (HEIGHT, false));
                check!(3, (7, true));
            }
            1 => {
                check!(128, (1, true));
            }
            2 => {
                check!(5, (1, false));
            }
            _ => {
                check!(1, (11, false));
                check!(128, (5, false));
            }
        }
    }
    changed
}

/// All comparisons, with writing and without, with an offset and a range.
fn states<D: DepthWidth>(offset: PolygonOffset, range: [D; 2]) -> Vec<DepthState<D>> {
    let all = COMPARISONS.into_iter().flat_map(|comparison| {
        [true, false].map(|writes| DepthState {
            comparison,
            writes,
            offset,
            range,
        })
    });
    all.collect()
}

/// A depth at a part of all depths, in 1/256.
fn depth_at<D: DepthWidth>(part: u16) -> D {
    let all: u32 = D::NEAREST.into();
    let depth = u64::from(all) * u64::from(part.min(256)) / 256;
    D::from_interpolated((depth as u32) << if D::FRACTION_BITS == 16 { 16 } else { 0 })
}

/// Any offset: none, small ones, and some beyond all depths.
fn offset() -> impl Strategy<Value = PolygonOffset> {
    let factor = prop_oneof![
        Just(0),
        (-4 << 16)..(4 << 16),
        Just(i32::MIN),
        Just(i32::MAX),
        any::<i32>()
    ];
    let units = prop_oneof![Just(0), -20..20, Just(i32::MIN), Just(i32::MAX), any::<i32>()];
    (factor, units).prop_map(|(factor, units)| PolygonOffset {
        factor: I16F16::from_bits(factor),
        units,
    })
}

/// Parts of the range of depths, the whole one among them, and such that are turned round.
fn range() -> impl Strategy<Value = [u16; 2]> {
    prop_oneof![Just([0, 256]), Just([256, 0]), Just([0, 0]), [0..257u16, 0..257u16]]
}

/// One mesh in another one's scene, in all formats.
fn check_formats(first: &Second, second: &Second, offset: PolygonOffset, range: [u16; 2]) -> usize {
    fn in_format<S: Format<D>, D: DepthWidth>(
        first: &Second,
        second: &Second,
        offset: PolygonOffset,
        range: [u16; 2],
    ) -> usize {
        check::<S, D>(first, second, &states(offset, range.map(depth_at)))
    }
    in_format::<Sub4, u32>(first, second, offset, range)
        + in_format::<Sub8, u16>(first, second, offset, range)
        + in_format::<Sub8, u32>(first, second, offset, range)
        + in_format::<Sub4, u16>(first, second, offset, range)
}

#[test]
fn a_cube_in_the_scene_of_another_by_all_states() {
    let first = Second::new(meshes::cube(0.8), standard_pose(3));
    let second = Second::new(meshes::cube(0.75).two_sided(), standard_pose(4));
    let offsets = [
        (0.0, 0),
        (1.5, 2),
        (-1.5, -2),
        (0.25, -700),
        (32_767.0, 0),
        (0.0, i32::MIN),
    ];
    for (number, (factor, units)) in offsets.into_iter().enumerate() {
        let offset = PolygonOffset {
            factor: I16F16::from_num(factor),
            units,
        };
        let range = [[0, 256], [0, 256], [128, 256], [20, 90], [256, 0], [0, 256]][number];
        assert!(check_formats(&first, &second, offset, range) > 2_000, "{offset:?}");
    }
}

/// The faces of one plane come in their order, whichever of them is drawn.
#[test]
fn faces_on_one_plane_come_in_order() {
    let square = |z: i16| vec![[-500, -400, z], [-500, 400, z], [500, 400, z], [500, -400, z]];
    let orders = vec![[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]];
    let first = Second::new(Mesh::new(square(0), orders.clone()), standard_pose(0));
    let second = Second::new(Mesh::new(square(0), orders).two_sided(), standard_pose(0));
    assert!(check_formats(&first, &second, PolygonOffset::NONE, [0, 256]) > 2_000);
}

/// What a state draws that changes nothing is what scenes draw by themselves.
#[test]
fn the_default_state_is_that_of_scenes() {
    fn check<S: Format<D>, D: DepthWidth>(mesh: &Mesh, frame: u16) {
        let camera = camera(area(WIDTH, HEIGHT));
        let scene = Second::new(mesh.clone(), standard_pose(frame));
        let models = scene.models();
        let (mut memory, mut empty) = (Box::new(MemoryOf::<S, D>::new()), Box::new(MemoryOf::<S, D, 0>::new()));
        let (mut prepared, mut empty) = (
            memory.prepare(&camera, &models).unwrap(),
            empty.prepare(&camera, &[]).unwrap(),
        );
        let expected = in_bands((HEIGHT, false), |band, _| prepared.draw(band));
        let with_depths = in_bands((9, true), |band, keep| {
            prepared.draw_with(band, |row| keep(row.y(), numbers(row.depths())));
        });
        for bands in [(HEIGHT, false), (1, true), (13, false)] {
            let drawn = in_bands(bands, |band, keep| {
                empty.draw_with(band, |row| {
                    prepared.draw_in(row, &DepthState::default());
                    keep(row.y(), numbers(row.depths()));
                });
            });
            assert_eq!(drawn.words, expected.words);
            assert!(drawn == with_depths);
        }
    }
    for frame in 0..3 {
        for mesh in [meshes::torus(), meshes::icosphere(1.4), meshes::cube(1.0)] {
            check::<Sub4, u16>(&mesh, frame * 7 + 1);
            check::<Sub8, u32>(&mesh, frame * 7 + 2);
        }
    }
}

/// A disc at a depth, by all states and, with the default, as without a state.
#[test]
fn shapes_at_a_depth_by_all_states() {
    fn check<S: Format<D>, D: DepthWidth>() {
        let camera = camera(area(WIDTH, HEIGHT));
        let scene = Second::new(meshes::torus(), standard_pose(5));
        let models = scene.models();
        let mut memory = Box::new(MemoryOf::<S, D>::new());
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        let before = in_bands((HEIGHT, false), |band, keep| {
            prepared.draw_with(band, |row| keep(row.y(), numbers(row.depths())));
        });
        // One of the depths that are there.
        let depth: u32 = *before.depths.iter().filter(|depth| **depth > 0).nth(300).unwrap();
        let depth_of_disc = D::from_interpolated(depth << if D::FRACTION_BITS == 16 { 16 } else { 0 });
        let disc = Circle::new(Point::new(8, 4), 31).into_styled(PrimitiveStyle::with_fill(Rgb888::RED));
        let offset = PolygonOffset {
            factor: I16F16::MAX,
            units: -3,
        };
        for offset in [PolygonOffset::NONE, offset] {
            for range in [[0, 256], [40, 230]] {
                for state in states::<D>(offset, range.map(depth_at)) {
                    let mut expected = before.clone();
                    for (index, point) in area(WIDTH, HEIGHT).points().enumerate() {
                        if disc.primitive.contains(point) {
                            let word = Rgb888::RED.into_storage();
                            expected.draw(index, word, depth_in(&state, 0, depth), &state);
                        }
                    }
                    let drawn = in_bands((6, false), |band, keep| {
                        prepared.draw_with(band, |row| {
                            let Ok(()) = disc.draw_on(&mut row.at_depth_with(depth_of_disc, &state));
                            keep(row.y(), numbers(row.depths()));
                        });
                    });
                    assert!(drawn == expected, "{state:?}");
                    if state == DepthState::NEARER {
                        let drawn = in_bands((6, false), |band, keep| {
                            prepared.draw_with(band, |row| {
                                let Ok(()) = disc.draw_on(&mut row.at_depth(depth_of_disc));
                                keep(row.y(), numbers(row.depths()));
                            });
                        });
                        assert!(drawn == expected);
                    }
                }
            }
        }
    }
    check::<Sub4, u16>();
    check::<Sub8, u32>();
}

/// Lines by a state, against their pixels and a rational number for each depth.
fn check_lines<S: Format<D>, D: DepthWidth>(ends: &[[(Point, u16); 2]], states: &[DepthState<D>]) {
    let camera = camera(area(WIDTH, HEIGHT));
    let scene = Second::new(meshes::torus(), standard_pose(9));
    let models = scene.models();
    let mut memory = Box::new(MemoryOf::<S, D>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let before = in_bands((HEIGHT, false), |band, keep| {
        prepared.draw_with(band, |row| keep(row.y(), numbers(row.depths())));
    });
    let lines: Vec<[(Point, D); 2]> = ends
        .iter()
        .map(|ends| ends.map(|(point, part)| (point, depth_at(part))))
        .collect();
    for state in states {
        let mut expected = before.clone();
        for ends in &lines {
            draw_line(&mut expected, *ends, state);
        }
        for bands in [(HEIGHT, false), (1, true), (9, false)] {
            let drawn = in_bands(bands, |band, keep| {
                prepared.draw_with(band, |row| {
                    for [a, b] in &lines {
                        row.draw_line(&DepthLine::new([*b, *a]), Rgb888::GREEN, state);
                    }
                    keep(row.y(), numbers(row.depths()));
                });
            });
            assert!(drawn == expected, "{state:?}");
        }
    }
}

/// Draws a line pixel by pixel.
fn draw_line<D: DepthWidth>(picture: &mut Picture, ends: [(Point, D); 2], state: &DepthState<D>) {
    let mut ends = ends.map(|(point, depth)| (point, i128::from(depth.into())));
    // The first one is the upper one, or the left one.
    ends.sort_by_key(|(point, depth)| (point.y, point.x, -depth));
    let [(from, first), (to, last)] = ends;
    let length = |a: Point, b: Point| i128::from(a.x.abs_diff(b.x).max(a.y.abs_diff(b.y)));
    let (all, gain) = (length(from, to), last - first);
    let fraction = if D::FRACTION_BITS == 16 { 16 } else { 0 };
    let slope = nearest(gain.abs() << fraction, all.max(1));
    let window = zrow::geometry::Window::from(area(WIDTH, HEIGHT));
    for pixel in Lines::bresenham(from, to, &window) {
        // Halves away from the depth of the first one.
        let gained = nearest(gain.abs() * length(from, pixel), all.max(1));
        let depth = (first + gain.signum() * gained) as u32;
        let index = (pixel.y * WIDTH as i32 + pixel.x) as usize;
        picture.draw(
            index,
            Rgb888::GREEN.into_storage(),
            depth_in(state, slope, depth),
            state,
        );
    }
}

fn ends() -> impl Strategy<Value = Vec<[(Point, u16); 2]>> {
    let end = || {
        let near = (-10..60, -10..50);
        let pixel = prop_oneof![4 => near, 1 => (any::<i32>(), any::<i32>()), 1 => (-3000..3000, -3000..3000)];
        (pixel, 0..257u16).prop_map(|((x, y), part)| (Point::new(x, y), part))
    };
    prop::collection::vec([end(), end()], 1..6)
}

/// A vertical, a level and a slanted line, one pixel, and one pixel with two depths.
#[test]
fn simple_lines_by_all_states() {
    let ends = [
        [(3, 3, 200), (3, 37, 120)],
        [(40, 20, 20), (2, 20, 250)],
        [(45, 1, 128), (1, 39, 128)],
        [(7, 7, 250), (7, 7, 250)],
        [(9, 7, 1), (9, 7, 250)],
    ]
    .map(|ends| ends.map(|(x, y, part)| (Point::new(x, y), part)));
    for offset in [PolygonOffset::NONE, PolygonOffset::WIREFRAME] {
        check_lines::<Sub4, u16>(&ends, &states(offset, [0, u16::MAX]));
        check_lines::<Sub8, u32>(&ends, &states(offset, [77, u32::MAX / 3]));
    }
}

proptest! {
    #![proptest_config(config(cases(4, 60)))]

    #[test]
    fn faces_that_go_through_each_other(
        meshes in [faces(700, 10), faces(700, 10)],
        poses in [pose(1300..2500), pose(1300..2500)],
        offset in offset(),
        range in range(),
    ) {
        let ([first, second], [pose, other]) = (meshes, poses);
        check_formats(&Second::new(first, pose), &Second::new(second, other), offset, range);
    }

    #[test]
    fn faces_around_the_camera(
        meshes in [faces(4000, 4), faces(4000, 6)],
        poses in [pose(-500..800), pose(-500..800)],
        offset in offset(),
        range in range(),
    ) {
        let ([first, second], [pose, other]) = (meshes, poses);
        check_formats(&Second::new(first, pose), &Second::new(second, other), offset, range);
    }

    #[test]
    fn small_faces_and_slivers(
        meshes in [faces(300, 4), faces(90, 20)],
        pose in pose(200..900),
        offset in offset(),
        range in range(),
    ) {
        let [first, second] = meshes;
        check_formats(&Second::new(first, pose), &Second::new(second, pose), offset, range);
    }

    #[test]
    fn any_lines(ends in ends(), offset in offset(), range in range()) {
        check_lines::<Sub4, u16>(&ends, &states(offset, range.map(depth_at)));
        check_lines::<Sub4, u32>(&ends, &states(offset, range.map(depth_at)));
    }
}
