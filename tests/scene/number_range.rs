//! Values over the whole of their type: what is out of range is an error, and everything else is right.

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use fixed::types::{I8F24, I12F4, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::Band,
    geometry::{FixedPointWindow, InputError, Sub4, Sub8, SubPixel, SubPoint, Window},
    scene::{Affine, Camera, Deep, DepthWidth, FaceSet, Fine, Look, Memory, Model, Orthographic, Pose, Rotation},
    shade::{LinearGradient, Paint, RadialGradient, Ramp, Transformed},
};

use crate::common::numbers::any_number;
use crate::common::{cases, config};
use crate::numbered_scene::{Format, LookIn, WholeLookIn};

proptest! {
    #![proptest_config(config(cases(20_000, 20_000)))]

    /// Ends of gradients are whole pixels of the domain; a radius is one of its sizes.
    #[test]
    fn gradients_begin_and_end_in_the_domain(
        from in (any_number(), any_number()),
        to in (any_number(), any_number()),
        radius in any_number(),
        start in (any_number(), any_number()),
    ) {
        let ramp = Ramp::between(Rgb888::BLACK, Rgb888::WHITE);
        let (from, to) = (Point::from(from), Point::from(to));
        let is_inside = |number: i32| (-8191..=8191).contains(&number);
        let far = InputError::OutOfDomain { min: -8191, max: 8191 };
        let are_inside = [from.x, from.y, to.x, to.y].into_iter().all(is_inside);
        let linear = LinearGradient::<Rgb565, 2>::new(from, to, ramp);
        prop_assert_eq!(linear.as_ref().err().copied(), (!are_inside).then_some(far));
        let radial = RadialGradient::<Rgb565, 2>::new(from, radius as u32, ramp);
        prop_assert_eq!(radial.as_ref().err().copied(), (radius as u32 > 8191).then_some(far));
        // The levels are held against exact ones in the tests of paints.
        for paint in [linear.ok().map(|paint| first_colors(&paint, start)), radial.ok().map(|paint| first_colors(&paint, start))] {
            prop_assert!(paint.is_none_or(|colors| colors == 300));
        }
    }
}

fn first_colors(paint: &impl Paint, (x, y): (i32, i32)) -> usize {
    paint.colors_from(Point::new(x, y)).take(300).count()
}

proptest! {
    #![proptest_config(config(cases(20_000, 20_000)))]

    /// Windows of any sides: sizes, and sub-pixel windows over them.
    #[test]
    fn windows_of_any_sides_have_their_sizes(sides in prop::array::uniform4(any_number()), other in prop::array::uniform4(any_number())) {
        let window = |[left, top, right, bottom]: [i32; 4]| Window { left, top, right, bottom };
        let (window, other) = (window(sides), window(other));
        let length = |first: i32, end: i32| (i64::from(end) - i64::from(first)).max(0);
        let (width, height) = (length(window.left, window.right), length(window.top, window.bottom));
        let is_empty = width == 0 || height == 0;
        prop_assert_eq!(window.is_empty(), is_empty);
        let expected = if is_empty { (0, 0) } else { (width, height) };
        prop_assert_eq!((i64::from(window.width()), i64::from(window.height())), expected);
        if !is_empty {
            prop_assert_eq!(Window::from(window.to_rectangle()), window);
        }
        prop_assert_eq!(window.meets(&other), other.meets(&window));
        fn is_in_domain<S: SubPixel>(units: i64) -> bool {
            (i64::from(S::MIN_UNITS)..=i64::from(S::MAX_UNITS)).contains(&units)
        }
        fn check<S: SubPixel>(window: &Window) -> Result<(), TestCaseError> {
            let unit = 1i64 << S::FRACTION_BITS;
            let sides = |margin: i64| {
                let first = [window.left, window.top].map(|side| i64::from(side) * unit - margin);
                let last = [window.right, window.bottom].map(|side| (i64::from(side) - 1) * unit + margin);
                first.into_iter().chain(last).all(is_in_domain::<S>)
            };
            prop_assert_eq!(FixedPointWindow::<S>::between_centers(window).is_ok(), sides(0));
            prop_assert_eq!(FixedPointWindow::<S>::over_areas(window).is_ok(), sides(unit / 2));
            Ok(())
        }
        check::<Sub4>(&window)?;
        check::<Sub8>(&window)?;
        let pixel = Point::new(window.left, window.top);
        let units = [pixel.x, pixel.y].map(i64::from);
        prop_assert_eq!(SubPoint::<Sub8>::from_pixel(pixel).is_ok(), units.iter().all(|units| is_in_domain::<Sub8>(units * 256)));
        prop_assert_eq!(SubPoint::<Sub4>::from_pixel(pixel).is_ok(), units.iter().all(|units| is_in_domain::<Sub4>(units * 16)));
        let coarse = SubPoint::<Sub4> { x: I12F4::from_bits(pixel.x as i16), y: I12F4::MIN };
        prop_assert!(FixedPointWindow::new(coarse, coarse).is_err());
    }

    /// A camera is one where its numbers are in their range; its depths then never come back.
    #[test]
    fn cameras_of_any_numbers_are_errors_or_see_depths_in_order(
        corner in (any_number(), any_number()),
        size in (any_number(), any_number()),
        near in any_number(),
        focal_length in any_number(),
        distances in (any_number(), any_number()),
    ) {
        let viewport = Rectangle::new(corner.into(), Size::new(size.0 as u32, size.1 as u32));
        let window = Window::from(viewport);
        let camera = Camera::new(viewport, I16F16::from_bits(near));
        let sides = [window.left, window.top, window.right, window.bottom];
        let fits = !window.is_empty() && sides.into_iter().all(|side| (-8191..=8191).contains(&side));
        let expected = if near < 8 << 16 {
            Some(InputError::NearTooClose)
        } else if !fits {
            Some(InputError::ViewportOutOfDomain)
        } else if window.width() > 2 * 2047 {
            Some(InputError::FocalLengthOutOfDomain)
        } else {
            None
        };
        prop_assert_eq!(camera.err(), expected);
        let Ok(camera) = camera else { return Ok(()) };
        let zoomed = camera.with_focal_length(I16F16::from_bits(focal_length));
        prop_assert_eq!(zoomed.is_ok(), (1 << 16..=2047 << 16).contains(&focal_length));
        let camera = zoomed.unwrap_or(camera);
        let [nearer, farther] = [distances.0.min(distances.1), distances.0.max(distances.1)].map(I16F16::from_bits);
        prop_assert!(camera.depth_at::<Sub4, u16>(nearer) >= camera.depth_at::<Sub4, u16>(farther));
        prop_assert!(camera.depth_at::<Sub8, u32>(nearer) >= camera.depth_at::<Sub8, u32>(farther));
        prop_assert!(camera.depth_at::<Sub8, u32>(farther) > 0 && camera.depth_at::<Sub4, u16>(farther) > 0);
    }
}

const COLORS: [Rgb888; 4] = [Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE, Rgb888::WHITE];

/// The picture of a scene in bands of so many rows; `None` where it cannot be prepared.
fn scene<L: Look<Color = Rgb888, Shading = Rgb888>>(
    camera: &Camera,
    models: &[Model<'_, Rgb888>],
    rows: u32,
) -> Result<Vec<u32>, InputError> {
    let mut memory = Box::new(Memory::<L, 256, 8, 128, 48, 64>::new());
    let mut prepared = memory.prepare(camera, models)?;
    let viewport = camera.viewport();
    let (width, height) = (viewport.width(), viewport.height());
    let mut words = vec![0; (width * height) as usize];
    for (band, words) in words.chunks_mut((width * rows) as usize).enumerate() {
        let top = viewport.top + band as i32 * rows as i32;
        let corner = Point::new(viewport.left, top);
        let size = Size::new(width, words.len() as u32 / width);
        let mut band = Band::<Rgb888>::new(Rectangle::new(corner, size), words).unwrap();
        prepared.draw(&mut band);
    }
    assert!(prepared.faces().count() <= 8 + 8 * 6);
    Ok(words)
}

fn check_scene<S: Format<D>, D: DepthWidth>(
    camera: &Camera,
    models: &[Model<'_, Rgb888>],
) -> Result<(), TestCaseError> {
    let whole = scene::<LookIn<S, D>>(camera, models, 48);
    match &whole {
        Ok(picture) => {
            prop_assert_eq!(&scene::<LookIn<S, D>>(camera, models, 1).unwrap(), picture);
            prop_assert_eq!(&scene::<LookIn<S, D>>(camera, models, 5).unwrap(), picture);
        }
        Err(error) => prop_assert!(matches!(error, InputError::OutOfDomain { .. }), "{}", error),
    }
    // Where no face has to be cut, none is.
    if let Ok(picture) = scene::<WholeLookIn<S, D>>(camera, models, 48) {
        prop_assert_eq!(Some(picture), whole.ok());
    }
    Ok(())
}

/// In front of a camera at the origin, or anywhere.
fn position() -> impl Strategy<Value = [i32; 3]> {
    let before = (-300..300i32, -300..300i32, 0..3_000i32).prop_map(|(x, y, z)| [x << 16, y << 16, z << 16]);
    prop_oneof![3 => before, 1 => prop::array::uniform3(any_number())]
}

proptest! {
    #![proptest_config(config(cases(2_000, 2_000)))]

    /// Vertices, poses and cameras of any numbers: the scene is the same in bands of any height, or an error says why not.
    #[test]
    fn scenes_of_any_numbers_are_the_same_in_all_bands(
        corner in (any_number(), any_number()),
        size in (1..40u32, 1..48u32),
        near in prop_oneof![2 => 8 << 16..=300 << 16, 1 => 8 << 16..=i32::MAX],
        focal_length in prop_oneof![2 => 1 << 16..=60 << 16, 1 => 1 << 16..=2047 << 16],
        vertices in prop::collection::vec(prop::array::uniform3(prop_oneof![2 => -700..700i32, 1 => any_number()]), 3..8),
        faces in prop::collection::vec(prop::array::uniform3(any::<u16>()), 1..5),
        turns in prop::array::uniform3(any::<u16>()),
        positions in prop::array::uniform2(position()),
        viewer in prop_oneof![2 => Just((0, [0; 3])), 1 => (any::<u16>(), position())],
    ) {
        let corner = Point::new(corner.0 % 8_300, corner.1 % 8_300);
        let camera = Camera::new(Rectangle::new(corner, Size::new(size.0, size.1)), I16F16::from_bits(near));
        let Ok(camera) = camera.and_then(|camera| camera.with_focal_length(I16F16::from_bits(focal_length))) else {
            return Ok(());
        };
        let vertices: Vec<[i16; 3]> = vertices.iter().map(|vertex| vertex.map(|number| number as i16)).collect();
        let count = vertices.len() as u16;
        let faces: Vec<[u16; 3]> = faces.iter().map(|face| face.map(|vertex| vertex % count)).collect();
        let mesh = FaceSet::new(&vertices, &faces).unwrap();
        let [a, b, c] = turns.map(U0F16::from_bits);
        let turned = Rotation::about_x(a).then(&Rotation::about_y(b)).then(&Rotation::about_z(c));
        let at = |position: [i32; 3]| position.map(I16F16::from_bits);
        let camera = camera.with_pose(Pose::new(Rotation::about_y(U0F16::from_bits(viewer.0)), at(viewer.1)));
        let model = Model::new(mesh, &COLORS).unwrap();
        let models = [
            model.with_pose(Pose::new(turned, at(positions[0]))),
            model.with_pose(Pose::new(turned.inverse(), at(positions[1]))),
        ];
        check_scene::<Sub4, u16>(&camera, &models)?;
        check_scene::<Sub4, u32>(&camera, &models)?;
        check_scene::<Sub8, u16>(&camera, &models)?;
        check_scene::<Sub8, u32>(&camera, &models)?;
    }
}

/// Edges that nearly lie in a row and end far above the viewport, which are skipped: their columns there have no meaning.
#[test]
fn edges_that_end_far_above_the_viewport_are_skipped() {
    let bits = |vector: [i32; 3]| vector.map(I16F16::from_bits);
    let rotation = Rotation::look_at(bits([20, 1 << 26, 218_103_808]), bits([0, -1, 0])).unwrap();
    let pose = Pose::new(rotation, bits([0, 1, i32::MIN]));
    let vertices = [[1, 0, 32_767], [0, 32_767, 32_767], [1_023, 0, 32_767], [0, 0, 0]];
    let mesh = FaceSet::new(&vertices, &[[0, 1, 2], [0, 2, 1], [1, 2, 3], [3, 2, 1]]).unwrap();
    let area = Rectangle::new(Point::zero(), Size::new(24, 16));
    let camera = Camera::new(area, I16F16::from_num(8)).unwrap();
    let skin = (&[Rgb888::RED; 4][..], Affine::IDENTITY);
    let models = [Model::<Transformed<Rgb888>>::with_skin(mesh, skin)
        .unwrap()
        .with_pose(pose)];
    let mut memory = Memory::<Fine<Deep<Transformed<Rgb888>>>, 100, 4, 24, 16, 4>::new();
    let mut words = [0; 24 * 16];
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    prepared.draw(&mut Band::<Rgb888>::new(area, &mut words).unwrap());
}

/// A level edge in the last columns of the domain, in rows that begin in the first one.
#[test]
fn a_level_edge_at_the_right_end_of_the_domain_is_set_up() {
    let area = Rectangle::new(Point::new(-1024, 0), Size::new(2047, 200));
    let camera = Camera::new(area, I16F16::from_num(50))
        .and_then(|camera| camera.with_scale(I8F24::from_num(1.0 / 16.0)))
        .unwrap();
    let vertices = [[16_352, 1_591, 100], [16_367, 1_591, 100], [16_352, -9, 100]];
    let mesh = FaceSet::new(&vertices, &[[0, 1, 2]]).unwrap();
    let models = [Model::new(mesh, &[Rgb565::RED]).unwrap()];
    let mut memory = Memory::<Orthographic<Rgb565>, 3, 1, 2047, 200>::new();
    let mut prepared = memory.prepare(&camera, &models).unwrap();
    let mut words = vec![0; 2047 * 200];
    prepared.draw(&mut Band::<Rgb565>::new(area, &mut words).unwrap());
    let covered: Vec<_> = (0..words.len())
        .filter(|&index| words[index] != 0)
        .map(|index| [index % 2047, index / 2047])
        .collect();
    // The left side goes through the centres of one column, from just below the first row on.
    let expected: Vec<_> = (1..=100).map(|row| [2045, row]).collect();
    assert_eq!(covered, expected);
}
