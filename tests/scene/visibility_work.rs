//! The work that methods of visibility report: what they paint, test, look at and split, by what is known of it otherwise.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use proptest::prelude::*;
use zrow::{
    band::{Band, Span},
    geometry::{Sub4, TooSmall, Window},
    scan::Polygons,
    scene::{Pose, Prepared},
    visible::{DepthBuffer, DepthSort, OneDepth, RayCasting, SpanScanLine, TileBins, Visibility, Warnock, Work},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{LookIn, Scene, area, color_of};
use crate::random_faces::{faces, pose};
use crate::snapped_faces::{camera, snapped, standard_pose};
use crate::visibility::{HEIGHT, MemoryOf, WIDTH};

/// The part of the picture that is drawn: columns and rows of it do not begin at 0.
const PART: Window = Window {
    left: 5,
    top: 3,
    right: 63,
    bottom: 46,
};
const PIXELS: usize = (WIDTH * HEIGHT) as usize;
/// The colour behind all faces.
const BEHIND: Rgb888 = Rgb888::new(0xff, 0xff, 0xff);

type Frame<'f, 'm> = Prepared<'f, 'm, LookIn<Sub4, u16>>;

/// What a method has reported, kind by kind, in the order in which it was.
#[derive(Default)]
struct Log {
    painted: Vec<(usize, Span)>,
    tested: Vec<(usize, Span)>,
    areas: Vec<(Window, usize)>,
    splits: Vec<(usize, usize)>,
}

impl Log {
    /// Draws the part of the picture by a method.
    fn of(prepared: &mut Frame<'_, '_>, method: &mut impl Visibility<u16>) -> Self {
        let mut log = Self::default();
        let with_work = words(|band| {
            let drawn = prepared.draw_by_with(method, band, |work| match work {
                Work::Painted { face, span } => log.painted.push((face, span)),
                Work::Tested { face, span } => log.tested.push((face, span)),
                Work::Area { window, faces } => log.areas.push((window, faces)),
                Work::Split { face, by } => log.splits.push((face, by)),
                other => panic!("no such work: {other:?}"),
            });
            assert_eq!(drawn, Ok(()));
        });
        assert!(with_work == words(|band| prepared.draw(band)), "another picture");
        log.check_painted(&with_work);
        log
    }

    /// Painted one over the other, the spans are the picture.
    fn check_painted(&self, expected: &[u32]) {
        let mut picture = vec![BEHIND.into_storage(); expected.len()];
        for (face, span) in &self.painted {
            for pixel in pixels(span) {
                picture[pixel] = color_of(*face).into_storage();
            }
        }
        assert!(picture == expected, "the spans are another picture");
    }

    /// The times that a pixel is painted, at most.
    fn most_painted(&self) -> usize {
        let mut times = vec![0; expected_pixels()];
        self.painted
            .iter()
            .flat_map(|(_, span)| pixels(span))
            .for_each(|pixel| times[pixel] += 1);
        times.into_iter().max().unwrap_or(0)
    }

    /// The faces and the pixels in which they are tested, in order; each pixel of a span once.
    fn tests(&self) -> Vec<(usize, usize)> {
        let mut tests: Vec<_> = self
            .tested
            .iter()
            .flat_map(|(face, span)| pixels(span).map(|pixel| (*face, pixel)))
            .collect();
        tests.sort_unstable();
        tests
    }
}

fn expected_pixels() -> usize {
    (PART.width() * PART.height()) as usize
}

/// The pixels of a span, which lies in the part that is drawn, by their index in it.
fn pixels(span: &Span) -> std::ops::Range<usize> {
    assert!(*span == span.clipped_to(&PART), "{span:?}");
    let first = (span.y - PART.top) * PART.width() as i32 - PART.left;
    (first + span.start) as usize..(first + span.end) as usize
}

/// The part of the picture, drawn in one band.
fn words(draw: impl FnOnce(&mut Band<'_, Rgb888>)) -> Vec<u32> {
    let mut words = vec![BEHIND.into_storage(); expected_pixels()];
    draw(&mut Band::new(PART.to_rectangle(), &mut words).unwrap());
    words
}

/// The faces and the pixels that they cover, by the exact reference, in order.
fn covered(prepared: &Frame<'_, '_>) -> Vec<(usize, usize)> {
    let faces = snapped(prepared);
    let mut covered = Vec::new();
    for (pixel, point) in PART.to_rectangle().points().enumerate() {
        let (x, y) = (16 * i128::from(point.x), 16 * i128::from(point.y));
        covered.extend(
            faces
                .iter()
                .filter(|face| face.covers(x, y))
                .map(|face| (face.order, pixel)),
        );
    }
    covered.sort_unstable();
    covered
}

/// Windows that cover each pixel of the part once.
fn check_partition(windows: impl Iterator<Item = Window>) {
    let mut times = vec![0; expected_pixels()];
    for window in windows {
        for row in window.top..window.bottom {
            for pixel in pixels(&Span::new(row, window.left, window.right)) {
                times[pixel] += 1;
            }
        }
    }
    assert!(times.iter().all(|times| *times == 1));
}

/// Checks what all methods report of a scene; returns how many faces were split.
fn check_all(meshes: Vec<Mesh>, pose: Pose) -> usize {
    let (scene, camera) = (Scene::new(meshes), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(pose);
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let covered = covered(&prepared);

    let log = Log::of(&mut prepared, &mut DepthBuffer::<u16, PIXELS>::new());
    assert!(log.tests() == covered, "depth buffer");
    assert!(log.most_painted() <= 1 && log.areas.is_empty());

    let mut method = OneDepth::new(Polygons::crossing_number);
    let log = Log::of(&mut prepared, &mut method);
    assert!(includes(&log.tests(), &covered), "one depth");
    // Drawn once.
    assert_eq!(log.tested.len(), method.points_tested() as usize);
    assert!(log.most_painted() <= 1 && log.areas.is_empty());

    check_rays(&mut prepared, &covered);
    check_windows(&mut prepared);

    let log = Log::of(&mut prepared, &mut TileBins::<u16, 12, 10_000>::new());
    check_partition(log.areas.iter().map(|(window, _)| *window));
    assert!(log.most_painted() <= 1);
    assert_eq!(log.areas.len(), 4 * 3);

    for log in [
        Log::of(&mut prepared, &mut SpanScanLine::<200>::new()),
        Log::of(&mut prepared, &mut SpanScanLine::<0>::new()),
    ] {
        assert!(log.most_painted() <= 1 && log.tested.is_empty() && log.areas.is_empty());
    }
    let mut method = SpanScanLine::<200>::new();
    let log = Log::of(&mut prepared, &mut method);
    assert_eq!(log.painted.len(), method.intervals() as usize);

    let mut method = DepthSort::<1_200, 2_000>::new();
    let log = Log::of(&mut prepared, &mut method);
    assert_eq!(log.splits.len(), method.counters().splits as usize);
    // Each pixel of each face is painted, those of parts in one of them.
    let painted: usize = log.painted.iter().map(|(_, span)| pixels(span).len()).sum();
    assert!(painted <= covered.len());
    assert!(painted == covered.len() || method.counters().in_cycles > 0);
    log.splits.len()
}

/// Whether all of some sorted numbers are among others.
fn includes(all: &[(usize, usize)], some: &[(usize, usize)]) -> bool {
    some.iter().all(|one| all.binary_search(one).is_ok())
}

/// Ray casting: boxes of trees with all faces, and a test of each face that is seen.
fn check_rays(prepared: &mut Frame<'_, '_>, covered: &[(usize, usize)]) {
    let mut method = RayCasting::<2_000>::new();
    let log = Log::of(prepared, &mut method);
    assert_eq!(log.tested.len(), method.faces_tested() as usize);
    assert!(log.most_painted() <= 1);
    let tests = log.tests();
    for (face, span) in &log.painted {
        assert!(pixels(span).all(|pixel| tests.binary_search(&(*face, pixel)).is_ok()));
    }
    let Some((root, faces)) = log.areas.first() else {
        return;
    };
    assert!(log.areas.iter().all(|(_, below)| below <= faces));
    for (_, pixel) in covered {
        let (column, row) = (pixel % PART.width() as usize, pixel / PART.width() as usize);
        let [column, row] = [column as i32 + PART.left, row as i32 + PART.top];
        assert!((root.left..root.right).contains(&column) && (root.top..root.bottom).contains(&row));
    }
}

/// Warnock: the windows that are not divided are the picture, and those with one face or none are of one colour or two.
fn check_windows(prepared: &mut Frame<'_, '_>) {
    let mut method = Warnock::<1_000>::new();
    let log = Log::of(prepared, &mut method);
    assert_eq!(log.areas.len(), method.windows() as usize);
    assert!(log.most_painted() <= 1);
    let is_divided = |(window, faces): &&(Window, usize)| *faces > 1 && window.width() * window.height() > 1;
    check_partition(
        log.areas
            .iter()
            .filter(|area| !is_divided(area))
            .map(|(window, _)| *window),
    );
    let blocks = log.areas.iter().filter(|(_, faces)| *faces == 1).count();
    assert_eq!(blocks, method.blocks() as usize);

    // Without a list nothing is known of most windows.
    let log = Log::of(prepared, &mut Warnock::<0>::new());
    assert!(log.areas.iter().all(|(_, faces)| [0, 65_535].contains(faces)));
}

#[test]
fn work_in_standard_scenes() {
    let frames = cases(2, 16) as u16;
    for frame in 0..frames {
        let pose = standard_pose(frame * 5 + 1);
        check_all(vec![meshes::torus(), meshes::cube(0.5)], pose);
        check_all(vec![meshes::icosphere(1.4)], pose);
    }
    check_all(vec![], standard_pose(0));
}

#[test]
fn faces_that_penetrate_report_splits() {
    let upright = Mesh::new(
        vec![[-400, -300, -200], [400, -300, 230], [400, 310, 230], [-400, 310, -200]],
        vec![[0, 1, 2], [0, 2, 3]],
    );
    let level = Mesh::new(
        vec![[-410, -290, 210], [390, -290, -190], [390, 300, -190], [-410, 300, 210]],
        vec![[0, 1, 2], [0, 2, 3]],
    );
    assert!(check_all(vec![upright.two_sided(), level.two_sided()], standard_pose(0)) > 0);
}

#[test]
fn without_memory_nothing_is_reported() {
    let (scene, camera) = (Scene::new(vec![meshes::cube(1.0)]), camera(area(WIDTH, HEIGHT)));
    let models = scene.models(standard_pose(3));
    let mut memory = Box::new(MemoryOf::<Sub4, u16>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let error = |prepared: &mut Frame<'_, '_>, method: &mut dyn FnMut(&mut Frame<'_, '_>) -> Result<(), TooSmall>| {
        assert!(method(prepared).is_err());
    };
    macro_rules! check {
        ($($method:expr,)*) => {$(
            error(&mut prepared, &mut |prepared| {
                let mut result = Ok(());
                words(|band| {
                    result = prepared.draw_by_with(&mut $method, band, |work| panic!("{work:?}"));
                });
                result
            });
        )*};
    }
    check! {
        DepthBuffer::<u16, 99>::new(),
        DepthSort::<1, 0>::new(),
        RayCasting::<1>::new(),
        TileBins::<u16, 1, 100>::new(),
        TileBins::<u16, 12, 1>::new(),
    }
    // Nothing to draw, nothing to do.
    let beside = Rectangle::new(Point::new(100, 0), Size::new(4, 4));
    let mut words = [0; 16];
    let mut band = Band::<Rgb888>::new(beside, &mut words).unwrap();
    let drawn = prepared.draw_by_with(&mut Warnock::<9>::new(), &mut band, |work| panic!("{work:?}"));
    assert_eq!(drawn, Ok(()));
}

proptest! {
    #![proptest_config(config(cases(12, 200)))]

    #[test]
    fn work_of_interpenetrating_faces(mesh in faces(700, 14), pose in pose(1300..2500)) {
        check_all(vec![mesh], pose);
    }

    #[test]
    fn work_around_the_camera(mesh in faces(4000, 6), pose in pose(-500..800)) {
        check_all(vec![mesh], pose);
    }
}
