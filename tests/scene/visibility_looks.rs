//! Looks that name a method of visibility: their pictures are those of the depth row, also where the method has too little memory,
//! as scenes and as items of a picture.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use zrow::{
    band::Band,
    draw::{Picture, PictureSlot},
    geometry::TooSmall,
    scene::{Antialiased, Counted, Deep, Fine, Look, Memory, Model, Prepared, SceneItem, VisibleBy},
    shade::Translucent,
    visible::{DepthBuffer, DepthSort, GridRayCasting, OneDepth, RayCasting, SpanScanLine, TileBins, Warnock},
};

use crate::common::meshes;
use crate::numbered_scene::{Scene, area};
use crate::snapped_faces::{camera, standard_pose};
use crate::visibility::{HEIGHT, WIDTH, differing, in_bands};

const PIXELS: usize = (WIDTH * HEIGHT) as usize;

type MemoryOf<L> = Memory<L, 900, 700, { WIDTH as usize }, { HEIGHT as usize }, 200>;

/// A width and a height of bands, and whether they go upwards.
const BANDS: [([u32; 2], bool); 3] = [([WIDTH, HEIGHT], false), ([WIDTH, 1], false), ([23, 11], true)];

fn models() -> Scene {
    Scene::new(vec![meshes::torus(), meshes::cube(0.5)])
}

/// The picture of models in a look, in bands of one size, and what the closure says of the frame that was drawn.
fn drawn<L: Look<Color = Rgb888>, T>(
    models: &[Model<'_, L::Shading>],
    (size, upwards): ([u32; 2], bool),
    report: impl FnOnce(&Prepared<'_, '_, L>) -> T,
) -> (Vec<u32>, T) {
    let mut memory = Box::new(MemoryOf::<L>::new());
    let mut prepared = memory.prepare(&camera(area(WIDTH, HEIGHT)), models).unwrap();
    let words = in_bands(size, upwards, &mut |band| prepared.draw(band));
    (words, report(&prepared))
}

/// Compares the pictures of a look that names a method with those of a look that does not. The method drew all bands, and the
/// closure says how much it did.
macro_rules! check {
    ($models:expr, $method:ty, $look:ty, $work:expr) => {
        for bands in BANDS {
            let (expected, ()) = drawn::<$look, _>($models, bands, |_| ());
            let (found, (error, work)) = drawn::<VisibleBy<$method, $look>, _>($models, bands, |prepared| {
                let work: fn(&$method) -> u32 = $work;
                (prepared.method_error(), work(prepared.method()))
            });
            let name = stringify!($method);
            assert_eq!(error, None, "{name}");
            assert!(work > 0, "{name} did nothing");
            assert_eq!(differing(&found, &expected), 0, "{name}, bands of {bands:?}");
        }
    };
}

#[test]
fn each_method_that_a_look_names_draws_the_picture_of_the_depth_row() {
    let scene = models();
    let models = &scene.models(standard_pose(5));
    check!(models, DepthSort<700, 40>, Rgb888, |sort| sort.counters().pairs);
    check!(models, GridRayCasting<700, 900, 9_000>, Rgb888, |rays| rays.faces_tested());
    check!(models, OneDepth, Rgb888, |method| method.points_tested());
    check!(models, RayCasting<700>, Rgb888, |rays| rays.faces_tested());
    check!(models, SpanScanLine<200>, Rgb888, |spans| spans.intervals());
    check!(models, Warnock<700>, Rgb888, |warnock| warnock.windows());
    // These count nothing.
    check!(models, DepthBuffer<u16, PIXELS>, Rgb888, |_| 1);
    check!(models, TileBins<u16, 12, 3_000>, Rgb888, |_| 1);
    check!(models, Warnock<700>, Fine<Deep<Rgb888>>, |warnock| warnock.windows());
    check!(models, TileBins<u32, 12, 3_000>, Deep<Rgb888>, |_| 1);
    check!(models, SpanScanLine<200>, Counted<Rgb888>, |spans| spans.intervals());
}

/// Silhouettes by area and translucent faces, which the painter's algorithm draws.
#[test]
fn looks_without_one_face_a_pixel_name_the_painters_algorithm() {
    let scene = models();
    let models = &scene.models(standard_pose(5));
    check!(models, DepthSort<700, 40>, Antialiased<Rgb888>, |sort| sort.counters().pairs);
    let mesh = meshes::torus();
    let colors: Vec<_> = (0..mesh.faces.len())
        .map(|face| Rgb888::new(face as u8, 80, 160))
        .collect();
    let model = Model::<Translucent<Rgb888>>::with_skin(mesh.face_set(), (&colors[..], 90)).unwrap();
    let models = &[model.with_pose(standard_pose(3))];
    check!(models, DepthSort<700, 40>, Translucent<Rgb888>, |sort| sort.counters().pairs);
}

/// The depth row draws the bands for which a method has too little memory; the frame says how much it would take, until the next
/// one is prepared.
#[test]
fn bands_for_which_a_method_has_too_little_memory_are_drawn_by_the_depth_row() {
    let scene = models();
    let (models, camera) = (scene.models(standard_pose(5)), camera(area(WIDTH, HEIGHT)));
    let (expected, ()) = drawn::<Rgb888, _>(&models, BANDS[0], |_| ());
    // Bands of one row have room, others have not.
    type ByRows = VisibleBy<DepthBuffer<u16, { WIDTH as usize }>, Rgb888>;
    for (bands, error) in [(BANDS[1], None), (BANDS[0], Some(TooSmall::Pixels(PIXELS)))] {
        let (found, found_error) = drawn::<ByRows, _>(&models, bands, |prepared| prepared.method_error());
        assert_eq!(found_error, error);
        assert_eq!(differing(&found, &expected), 0);
    }
    let mut memory = Box::new(MemoryOf::<ByRows>::new());
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mixed = {
        let mut heights = [1, 7, 1, 1, 5].iter().cycle();
        let (mut words, mut top) = (vec![Rgb888::WHITE.into_storage(); PIXELS], 0);
        while top < HEIGHT {
            let height = (*heights.next().unwrap()).min(HEIGHT - top);
            let rows = Rectangle::new(Point::new(0, top as i32), Size::new(WIDTH, height));
            let [first, after] = [top, top + height].map(|row| (row * WIDTH) as usize);
            prepared.draw(&mut Band::<Rgb888>::new(rows, &mut words[first..after]).unwrap());
            top += height;
        }
        words
    };
    // Of the highest band.
    assert_eq!(prepared.method_error(), Some(TooSmall::Pixels(7 * WIDTH as usize)));
    assert_eq!(differing(&mixed, &expected), 0);
    let prepared = memory.prepare(&camera, &[]).unwrap();
    assert_eq!(prepared.method_error(), None);

    let few = drawn::<VisibleBy<DepthSort<10, 0>, Antialiased<Rgb888>>, _>(&models, BANDS[0], |prepared| {
        prepared.method_error().map(|error| error.needed())
    });
    let (expected, ()) = drawn::<Antialiased<Rgb888>, _>(&models, BANDS[0], |_| ());
    assert!(few.1.is_some_and(|needed| needed > 10), "{:?}", few.1);
    assert_eq!(differing(&few.0, &expected), 0);
}

/// Draws an item of a look in a picture, in bands of several sizes, and compares it with a picture. What the item says of its method
/// afterwards, and when it was prepared once more.
macro_rules! draw_item {
    ($look:ty, $models:expr, $expected:expr) => {{
        let camera = camera(area(WIDTH, HEIGHT));
        let mut memory = Box::new(MemoryOf::<$look>::new());
        let item = SceneItem::new(memory.frame(), &camera, $models).unwrap();
        for (size, upwards) in BANDS {
            let (mut slots, mut buckets) = ([PictureSlot::EMPTY; 1], [0; HEIGHT as usize]);
            let mut picture = Picture::new(area(WIDTH, HEIGHT), &mut slots, &mut [], &mut buckets);
            picture.add_item(&item).unwrap();
            let found = in_bands(size, upwards, &mut |band| picture.draw(band));
            assert_eq!(differing(&found, $expected), 0, "bands of {size:?}");
        }
        let error = item.method_error();
        item.prepare(&camera, $models).unwrap();
        [error, item.method_error()]
    }};
}

#[test]
fn items_of_a_picture_are_drawn_by_the_method_of_their_look() {
    let scene = models();
    let models: [_; 2] = scene.models(standard_pose(5)).try_into().unwrap();
    let (expected, ()) = drawn::<Rgb888, _>(&models, BANDS[0], |_| ());
    assert_eq!(
        draw_item!(VisibleBy<SpanScanLine<200>, Rgb888>, models, &expected),
        [None; 2]
    );
    let [error, anew] = draw_item!(VisibleBy<RayCasting<0>, Rgb888>, models, &expected);
    assert!(matches!(error, Some(TooSmall::Faces(1..))), "{error:?}");
    assert_eq!(anew, None);
}

/// The memory of a method lies in that of the scene; looks that name none take nothing for it.
#[test]
fn memory_grows_by_that_of_the_method() {
    let plain = size_of::<Memory<Rgb888, 8, 8, 8, 8, 8>>();
    let by_rays = size_of::<Memory<VisibleBy<RayCasting<100>, Rgb888>, 8, 8, 8, 8, 8>>();
    let grown = by_rays - plain - size_of::<RayCasting<100>>();
    assert!(grown <= 24, "{grown} bytes");
}
