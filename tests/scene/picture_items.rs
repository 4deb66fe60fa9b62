//! Scenes as items of a picture against the same shapes and scenes drawn one after the other into a whole frame: in bands of
//! any height and order, in groups, and by what has changed alone.

use embedded_graphics::{
    pixelcolor::Gray8,
    prelude::*,
    primitives::{Circle, Rectangle, Styled},
};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{DrawOn, Group, Picture, PictureSlot, PrimitiveStyle},
    geometry::{InputError, TooSmall, Window},
    scene::{Antialiased, Camera, Fine, Look, Memory, Model, Pose, SceneItem},
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::random_faces::{faces, pose};
use crate::snapped_faces::{at, camera};

const WIDTH: usize = 48;
const HEIGHT: usize = 40;
const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));

type SceneMemory<L> = Memory<L, 400, 64, WIDTH, HEIGHT>;
type Disc = Styled<Circle, PrimitiveStyle<Gray8>>;

/// A scene of one model, and the discs behind it and in front of it.
#[derive(Debug, Clone)]
struct Case {
    mesh: Mesh,
    colors: Vec<Gray8>,
    poses: [Pose; 3],
    behind: Disc,
    before: Disc,
    group: Option<(Rectangle, u8)>,
}

impl Case {
    fn model(&self, frame: usize) -> Model<'_, Gray8> {
        let model = Model::new(self.mesh.face_set(), &self.colors).unwrap();
        model.with_pose(self.poses[frame])
    }

    /// What a frame shows, drawn at once, without a picture.
    fn expected<L: Look<Color = Gray8, Shading = Gray8>>(&self, frame: usize) -> Vec<u8> {
        let mut words = vec![0; WIDTH * HEIGHT];
        let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
        self.behind.draw_on(&mut band).unwrap();
        let without = words.clone();
        let models = [self.model(frame)];
        let mut storage = SceneMemory::<L>::new();
        let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
        let mut prepared = storage.prepare(&camera(AREA), &models).unwrap();
        prepared.draw(&mut band);
        if let Some((clip, opacity)) = self.group {
            for ((point, word), without) in AREA.points().zip(&mut words).zip(without) {
                let opacity = if clip.contains(point) { u32::from(opacity) } else { 0 };
                let doubled = 2 * (u32::from(*word) * opacity + u32::from(without) * (255 - opacity));
                *word = ((doubled + 255) / 510) as u8;
            }
        }
        let mut band = Band::<Gray8>::new(AREA, &mut words).unwrap();
        self.before.draw_on(&mut band).unwrap();
        words
    }
}

fn disc() -> impl Strategy<Value = Disc> {
    (-10..50, -10..50, 0..30u32, any::<u8>()).prop_map(|(x, y, diameter, luma)| {
        Circle::new(Point::new(x, y), diameter).into_styled(PrimitiveStyle::with_fill(Gray8::new(luma)))
    })
}

fn case() -> impl Strategy<Value = Case> {
    let group = (-5..40, -5..40, 0..60u32, 0..60u32, prop_oneof![Just(255), any::<u8>()]).prop_map(
        |(x, y, width, height, opacity)| (Rectangle::new(Point::new(x, y), Size::new(width, height)), opacity),
    );
    let colors = prop::collection::vec(any::<u8>().prop_map(Gray8::new), 12);
    // Some faces reach behind the camera.
    let poses = [pose(-200..2500), pose(-200..2500), pose(1300..2500)];
    (faces(600, 6), colors, poses, disc(), disc(), prop::option::of(group)).prop_map(
        |(mesh, colors, poses, behind, before, group)| Case {
            mesh,
            colors,
            poses,
            behind,
            before,
            group,
        },
    )
}

/// Draws what a band shows onto the display.
fn show(picture: &mut Picture<'_, '_, Gray8>, area: Rectangle, display: &mut [u8]) {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    picture.draw(&mut Band::new(area, &mut words).unwrap());
    for (point, word) in area.points().zip(words) {
        display[point.y as usize * WIDTH + point.x as usize] = word;
    }
}

/// A band: its first row and its height, its first column and its width.
type Part = (i32, u32, i32, u32);

/// Draws the frames of a case as pictures: the first one in bands of one row and in some others, each later one by what has changed.
fn check<L: Look<Color = Gray8, Shading = Gray8>>(case: &Case, bands: &[Part]) -> Result<(), TestCaseError> {
    let mut memory = SceneMemory::<L>::new();
    let scene = SceneItem::new(memory.frame(), &camera(AREA), [case.model(0)]).unwrap();
    let (mut slots, mut pool, mut buckets) = ([PictureSlot::EMPTY; 5], [0; 200], [0; HEIGHT]);
    let (mut areas, mut kept) = ([Window::EMPTY; 8], [0; 12 * WIDTH]);
    let mut picture = Picture::new(AREA, &mut slots, &mut pool, &mut buckets)
        .with_damage(&mut areas, (1, 1))
        .with_group_rows(&mut kept);
    picture.add(&case.behind).unwrap();
    if let Some((clip, opacity)) = case.group {
        picture.begin_group(Group::new().clip(clip).opacity(opacity)).unwrap();
    }
    let id = picture.add_item(&scene).unwrap();
    if case.group.is_some() {
        picture.end_group().unwrap();
    }
    picture.add(&case.before).unwrap();

    let expected = case.expected::<L>(0);
    let mut display = vec![1; WIDTH * HEIGHT];
    for (top, height, left, width) in (0..HEIGHT as i32)
        .map(|y| (y, 1, 0, WIDTH as u32))
        .chain(bands.iter().copied())
    {
        let area = Rectangle::new(Point::new(left, top), Size::new(width, height)).intersection(&AREA);
        show(&mut picture, area, &mut display);
        for point in area.points() {
            let index = point.y as usize * WIDTH + point.x as usize;
            prop_assert_eq!(display[index], expected[index], "{} in {:?}", point, area);
        }
    }

    // Each later frame is drawn by what has changed alone.
    picture.clear_damage();
    for number in 1..3 {
        scene.prepare(&camera(AREA), [case.model(number)]).unwrap();
        picture.replace_item(id, &scene).unwrap();
        while let Some(area) = picture.next_damage() {
            for y in area.rows() {
                let row = Rectangle::new(Point::new(area.top_left.x, y), Size::new(area.size.width, 1));
                show(&mut picture, row, &mut display);
            }
        }
        let expected = case.expected::<L>(number);
        let differs = display
            .iter()
            .zip(&expected)
            .position(|(shown, expected)| shown != expected);
        prop_assert_eq!(differs, None, "frame {}", number);
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(cases(150, 3_000)))]

    #[test]
    fn a_scene_lies_between_the_items_of_a_picture(
        case in case(),
        bands in prop::collection::vec((0..HEIGHT as i32, 1..12u32, 0..40i32, 1..48u32), 1..8),
    ) {
        check::<Gray8>(&case, &bands)?;
        // Silhouettes reach half a pixel further.
        check::<Antialiased<Gray8>>(&case, &bands)?;
        check::<Fine<Antialiased<Gray8>>>(&case, &bands)?;
    }
}

/// What cannot be prepared says what would do, draws nothing, and can be prepared again.
#[test]
fn a_scene_that_cannot_be_prepared_is_empty() {
    let mesh = Mesh::new(vec![[-900, -900, 0], [0, 900, 0], [900, -900, 0]], vec![[0, 1, 2]]);
    let colors = [Gray8::new(7)];
    let pose = Pose::new(zrow::scene::Rotation::IDENTITY, at(0, 0, 1000));
    let model = Model::new(mesh.face_set(), &colors).unwrap().with_pose(pose);
    let mut memory = Memory::<Gray8, 3, 1, WIDTH, HEIGHT, 1>::new();
    let error = |needed| Some(InputError::TooSmall(needed));

    let mut narrow = Memory::<Gray8, 3, 1, { WIDTH - 1 }, HEIGHT, 1>::new();
    let few = SceneItem::new(narrow.frame(), &camera(AREA), [model]).err();
    assert_eq!(few, error(TooSmall::Columns(WIDTH)));

    let scene = SceneItem::new(memory.frame(), &camera(AREA), [model]).unwrap();
    let mut slots = [PictureSlot::EMPTY; 1];
    let mut picture = Picture::new(AREA, &mut slots, &mut [], &mut []);
    picture.add_item(&scene).unwrap();
    let mut pixels = || {
        let mut words = [0; WIDTH * HEIGHT];
        picture.draw(&mut Band::<Gray8>::new(AREA, &mut words).unwrap());
        words.iter().filter(|&&word| word == 7).count()
    };
    let whole = pixels();
    assert!(whole > 100, "{whole}");

    let taller = Camera::new(
        Rectangle::new(Point::zero(), Size::new(8, HEIGHT as u32 + 1)),
        at(0, 0, 64)[2],
    )
    .unwrap();
    assert_eq!(scene.prepare(&taller, [model]).err(), error(TooSmall::Rows(HEIGHT + 1)));
    assert_eq!(pixels(), 0);
    scene.prepare(&camera(AREA), [model]).unwrap();
    assert_eq!(pixels(), whole);
}
