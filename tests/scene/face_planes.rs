//! Faces that are left out by their planes before vertices are transformed: pictures, faces, points and hidden lines with and
//! without planes, bit for bit; and faces that are left out against their area on the screen.

use core::cell::Cell;

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I2F14, I8F24, I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::PictureItem,
    geometry::{InputError, TooSmall},
    scene::{
        Affine, Antialiased, BoundingBox, Camera, Counted, Counters, Deep, DepthWidth, DoubleSided, Edge, FacePlanes,
        FaceSet, Fine, Look, Memory, Model, Orthographic, Pose, Rotation, SceneItem, Unhurried, Whole,
    },
    shade::{Bounded, Shading, Transformed, WithPlanes},
    visible::{Appel, FaceAgainstSegment, Roberts},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::color_of;
use crate::rotations::rotation;
use crate::shaded_scene::{Even, Numbers};
use crate::snapped_faces::{at, snapped};

const WIDTH: u32 = 60;
const HEIGHT: u32 = 44;

/// Triangles of any shape, slivers among them, each from both sides; small or large, around the origin or far from it.
fn soup() -> impl Strategy<Value = Mesh> {
    let middle = prop_oneof![2 => Just([0i16; 3]), 1 => prop::array::uniform3(-3_000i16..3_000)];
    (middle, 0u32..11, 3usize..9).prop_flat_map(|(middle, bits, count)| {
        let reach = 2i16 << bits;
        let vertex = prop::array::uniform3(-reach..reach)
            .prop_map(move |vertex| core::array::from_fn(|axis| vertex[axis] + middle[axis]));
        let faces = prop::collection::vec(prop::array::uniform3(0..count as u16), 1..10);
        (prop::collection::vec(vertex, count), faces)
            .prop_map(|(vertices, faces)| Mesh::new(vertices, faces).two_sided())
    })
}

/// The standard meshes, as they are or smaller: closed, so that about half of their faces are turned away.
fn closed() -> impl Strategy<Value = Mesh> {
    (0usize..3, 0u32..7).prop_map(|(number, shift)| {
        let mesh = [meshes::torus(), meshes::icosphere(1.4), meshes::cube(1.0)][number].clone();
        let vertices = mesh.vertices.iter();
        Mesh {
            vertices: vertices.map(|vertex| vertex.map(|part| part >> shift)).collect(),
            ..mesh
        }
    })
}

fn any_mesh() -> impl Strategy<Value = Mesh> {
    prop_oneof![3 => soup(), 1 => closed()]
}

/// Some meshes with their poses, and a camera that has most of them wholly in its picture.
#[derive(Debug, Clone)]
struct Scene {
    meshes: Vec<Mesh>,
    poses: Vec<Pose>,
    camera: Camera,
}

fn scene() -> impl Strategy<Value = Scene> {
    let whole = I16F16::from_num::<i32>;
    let placed = (any_mesh(), rotation(), prop::array::uniform3(-100i32..100), 100i32..800);
    let camera = (
        8i32..200,
        1i32..2_047,
        (-60i32..90, -60i32..90),
        prop_oneof![Just(None), (4_000i32..30_000).prop_map(Some)],
        (rotation(), prop::array::uniform3(-4_000i32..4_000)),
        1i32 << 16..1 << 24,
    );
    (prop::collection::vec(placed, 1..3), camera).prop_map(
        move |(placed, (near, focal, centre, far, (turned, position), scale))| {
            let viewport = Rectangle::new(Point::zero(), Size::new(WIDTH, HEIGHT));
            let eye = Pose::new(turned, at(position[0], position[1], position[2]));
            let mut camera = Camera::new(viewport, whole(near)).unwrap().with_pose(eye);
            camera = camera.with_focal_length(whole(focal)).unwrap();
            camera = camera.with_centre([centre.0, centre.1].map(whole)).unwrap();
            camera = camera.with_scale(I8F24::from_bits(scale)).unwrap();
            if let Some(far) = far {
                camera = camera.with_far(whole(far)).unwrap();
            }
            let poses = placed.iter().map(|(mesh, rotation, [x, y, _], distance)| {
                let sizes = mesh
                    .vertices
                    .iter()
                    .flatten()
                    .map(|part| i32::from(part.unsigned_abs()));
                let size = sizes.max().unwrap_or(0);
                // From just behind the near plane up to 8 times the mesh's size.
                let z = near + size * distance / 100;
                let aside = |part: i32| part * z / 200 * 60 / focal.max(60);
                let before_eye = Pose::new(*rotation, at(aside(*x), aside(*y), z.min(30_000)));
                before_eye.then(&eye).unwrap_or(before_eye)
            });
            let poses = poses.collect();
            Scene {
                poses,
                meshes: placed.into_iter().map(|(mesh, ..)| mesh).collect(),
                camera,
            }
        },
    )
}

/// Everything that a prepared frame tells.
#[derive(Debug, PartialEq)]
struct Seen {
    words: Vec<u32>,
    needed: [usize; 2],
    faces: Vec<(usize, [[i128; 3]; 3])>,
    points: Vec<[i64; 4]>,
    culled: u32,
    cut: u32,
}

fn seen<L>(models: &[Model<'_, L::Shading>], camera: &Camera) -> Result<(Seen, Counters), InputError>
where
    L: Look<Color = Rgb888, Counting = Cell<Counters>>,
{
    let mut memory = Box::new(Memory::<L, 2_400, 1_600, 64, 48>::new());
    let mut prepared = memory.prepare(camera, models)?;
    let mut words = vec![0; (WIDTH * HEIGHT) as usize];
    let area = camera.viewport().to_rectangle();
    prepared.draw(&mut Band::<Rgb888>::new(area, &mut words).unwrap());
    let points = prepared.points().map(|point| {
        let corner = point.corner;
        [
            point.vertex as i64,
            corner.point.x_units().into(),
            corner.point.y_units().into(),
            corner.depth.units().into(),
        ]
    });
    let points = points.collect();
    let counters = prepared.counters();
    let seen = Seen {
        words,
        needed: [prepared.vertices_needed(), prepared.active_needed()],
        faces: snapped(&prepared)
            .into_iter()
            .map(|face| (face.order, face.corners))
            .collect(),
        points,
        culled: counters.faces_culled,
        cut: counters.faces_cut,
    };
    Ok((seen, counters))
}

fn tables(meshes: &[Mesh]) -> Vec<Vec<[i16; 4]>> {
    let tables = meshes.iter().map(|mesh| {
        let mut table = vec![[0; 4]; mesh.faces.len()];
        FacePlanes::find_in(&mesh.face_set(), &mut table).unwrap();
        table
    });
    tables.collect()
}

fn models<'a, H: Shading>(scene: &'a Scene, skin: impl Fn(usize) -> H::Skin<'a>) -> Vec<Model<'a, H>> {
    let places = scene.meshes.iter().zip(&scene.poses).enumerate();
    places
        .map(|(number, (mesh, pose))| {
            Model::<H>::with_skin(mesh.face_set(), skin(number))
                .unwrap()
                .with_pose(*pose)
        })
        .collect()
}

fn colors(meshes: &[Mesh]) -> Vec<Vec<Rgb888>> {
    let mut numbers = 0..;
    meshes
        .iter()
        .map(|mesh| numbers.by_ref().take(mesh.faces.len()).map(color_of).collect())
        .collect()
}

/// Compares what a look sees with and without planes; returns how many faces were left out by those, and how many vertices.
fn compare<L, P>(scene: &Scene) -> Result<[u32; 2], TestCaseError>
where
    L: Look<Color = Rgb888, Shading = Rgb888, Counting = Cell<Counters>>,
    P: Look<Color = Rgb888, Shading = WithPlanes<Rgb888>, Counting = Cell<Counters>>,
{
    let (colors, tables) = (colors(&scene.meshes), tables(&scene.meshes));
    let plain = models::<Rgb888>(scene, |number| &colors[number]);
    let with_planes = models::<WithPlanes<Rgb888>>(scene, |number| {
        let mesh = scene.meshes[number].face_set();
        (&colors[number], FacePlanes::new(&mesh, &tables[number]).unwrap())
    });
    match (seen::<L>(&plain, &scene.camera), seen::<P>(&with_planes, &scene.camera)) {
        (Ok((without, _)), Ok((with, counters))) => {
            prop_assert!(with.words == without.words, "the picture is another one");
            prop_assert_eq!(with, without);
            Ok([counters.faces_culled_by_planes, counters.vertices_not_transformed])
        }
        (without, with) => {
            prop_assert_eq!(with.err(), without.err());
            Ok([0; 2])
        }
    }
}

/// Compares many frames, and whether the look had faces and vertices to leave out in enough of them.
fn frames_are_the_same(compare: fn(&Scene) -> Result<[u32; 2], TestCaseError>, least: [u32; 2]) {
    let left_out = Cell::new([0u32; 2]);
    let mut runner = proptest::test_runner::TestRunner::new(config(cases(600, 20_000)));
    runner
        .run(&scene(), |scene| {
            let (found, sums) = (compare(&scene)?, left_out.get());
            left_out.set(core::array::from_fn(|at| sums[at] + found[at]));
            Ok(())
        })
        .unwrap();
    let sums = left_out.get();
    assert!(
        sums.iter().zip(least).all(|(&sum, least)| sum >= cases(least, least)),
        "{sums:?}"
    );
}

#[test]
fn frames_are_the_same_in_perspective() {
    frames_are_the_same(compare::<Counted<Rgb888>, Counted<WithPlanes<Rgb888>>>, [1_000; 2]);
}

#[test]
fn frames_are_the_same_at_a_fine_precision() {
    frames_are_the_same(
        compare::<Counted<Fine<Deep<Rgb888>>>, Fine<Counted<Deep<WithPlanes<Rgb888>>>>>,
        [1_000; 2],
    );
}

#[test]
fn frames_are_the_same_where_rays_are_parallel() {
    frames_are_the_same(
        compare::<Counted<Orthographic<Rgb888>>, Orthographic<Counted<WithPlanes<Rgb888>>>>,
        [1_000; 2],
    );
    frames_are_the_same(
        compare::<Counted<Orthographic<Fine<Rgb888>>>, Orthographic<Counted<Fine<WithPlanes<Rgb888>>>>>,
        [1_000; 2],
    );
}

#[test]
fn frames_are_the_same_where_no_face_is_cut() {
    frames_are_the_same(
        compare::<Counted<Whole<Rgb888>>, Whole<Counted<WithPlanes<Rgb888>>>>,
        [1_000; 2],
    );
}

/// A look whose faces have planes may be anything else as well.
#[test]
fn frames_are_the_same_with_antialiased_silhouettes() {
    frames_are_the_same(
        compare::<Counted<Antialiased<Rgb888>>, Antialiased<Counted<WithPlanes<Rgb888>>>>,
        [1_000; 2],
    );
}

/// Looks that draw backs or take no shortcuts leave nothing out.
#[test]
fn looks_without_back_faces_to_leave_out_have_the_same_frames() {
    fn check<L, P>(scene: &Scene) -> Result<[u32; 2], TestCaseError>
    where
        L: Look<Color = Rgb888, Shading = Rgb888, Counting = Cell<Counters>>,
        P: Look<Color = Rgb888, Shading = WithPlanes<Rgb888>, Counting = Cell<Counters>>,
    {
        prop_assert_eq!(compare::<L, P>(scene)?, [0; 2]);
        Ok([0; 2])
    }
    frames_are_the_same(
        check::<Counted<DoubleSided<Rgb888>>, DoubleSided<Counted<WithPlanes<Rgb888>>>>,
        [0; 2],
    );
    frames_are_the_same(
        check::<Counted<Unhurried<Rgb888>>, Unhurried<Counted<WithPlanes<Rgb888>>>>,
        [0; 2],
    );
}

proptest! {
    #![proptest_config(config(cases(300, 10_000)))]

    /// What varies over faces is that of their vertices; bounds leave models out as a whole, and planes faces of the others.
    #[test]
    fn attributes_are_those_of_their_vertices(scene in scene()) {
        type Shown = Even<1>;
        type Both = Bounded<WithPlanes<Shown>>;
        let numbers: Vec<Vec<[i16; 1]>> = (0..).zip(&scene.meshes).map(|(number, mesh)| {
            (0..).zip(&mesh.vertices).map(|(vertex, _)| [number * 1_000 + vertex]).collect()
        }).collect();
        let tables = tables(&scene.meshes);
        let skin = |number: usize| Numbers { of_vertices: &numbers[number][..], shown: 0 };
        let plain = models::<Shown>(&scene, skin);
        let with_planes = models::<Both>(&scene, |number| {
            let mesh = scene.meshes[number].face_set();
            ((skin(number), FacePlanes::new(&mesh, &tables[number]).unwrap()), BoundingBox::around(mesh.vertices()))
        });
        let (without, with) = (seen::<Counted<Shown>>(&plain, &scene.camera), seen::<Counted<Both>>(&with_planes, &scene.camera));
        match (without, with) {
            (Ok((without, _)), Ok((with, _))) => prop_assert!(with.words == without.words && with.culled == without.culled),
            (without, with) => prop_assert_eq!(with.err(), without.err()),
        }
    }

    /// A map may stretch or mirror a model: its faces are told from each other on the screen alone.
    #[test]
    fn mapped_models_are_the_same(scene in scene(), factors in prop::array::uniform3(-3i32 << 24..3 << 24)) {
        type Mapped = Transformed<Rgb888>;
        type Both = Transformed<WithPlanes<Rgb888>>;
        let (colors, tables) = (colors(&scene.meshes), tables(&scene.meshes));
        let map = Affine::scaled(factors.map(I8F24::from_bits));
        let plain = models::<Mapped>(&scene, |number| (&colors[number], map));
        let with_planes = models::<Both>(&scene, |number| {
            let mesh = scene.meshes[number].face_set();
            ((&colors[number][..], FacePlanes::new(&mesh, &tables[number]).unwrap()), map)
        });
        match (seen::<Counted<Mapped>>(&plain, &scene.camera), seen::<Counted<Both>>(&with_planes, &scene.camera)) {
            (Ok((without, _)), Ok((with, counters))) => {
                prop_assert_eq!(with, without);
                prop_assert_eq!(counters.faces_culled_by_planes, 0);
            }
            (without, with) => prop_assert_eq!(with.err(), without.err()),
        }
    }
}

type Planed = Counted<WithPlanes<Rgb888>>;

fn small_camera() -> Camera {
    let viewport = Rectangle::new(Point::zero(), Size::new(WIDTH, HEIGHT));
    Camera::new(viewport, I16F16::from_num(128)).unwrap()
}

/// Nearly half of the faces of a sphere are turned away, and almost as many vertices are not transformed.
#[test]
fn most_back_faces_of_a_sphere_are_left_out() {
    let mesh = meshes::icosphere(1.4);
    let scene = Scene {
        poses: vec![Pose::new(Rotation::IDENTITY, at(0, 0, 1_500))],
        meshes: vec![mesh],
        camera: small_camera(),
    };
    // Of 320 faces and 162 vertices.
    let [faces, vertices] = compare::<Counted<Rgb888>, Planed>(&scene).unwrap();
    assert!(faces > 180 && vertices > 75, "{faces} faces, {vertices} vertices");
}

/// One triangle, whose plane the eye crosses in steps of 1/65,536 unit: what is left out is turned away on the screen, and what
/// is clearly turned away is left out. Far more of the angles than rounding can turn round are.
#[test]
fn an_eye_almost_in_the_plane_of_a_face_sees_what_it_saw() {
    for half in [40, 300, 3_000] {
        let mesh = Mesh::new(
            vec![[-half, 0, -half], [half, 0, -half], [0, 0, half]],
            vec![[0, 1, 2], [0, 2, 1]],
        );
        let mut left_out = 0;
        for step in -400i32..400 {
            let height = step.pow(3) / 8 * (i32::from(half) / 40);
            let position = [
                I16F16::ZERO,
                I16F16::from_bits(height),
                I16F16::from_num(i32::from(half) * 2 + 200),
            ];
            let scene = Scene {
                poses: vec![Pose::new(Rotation::IDENTITY, position)],
                meshes: vec![mesh.clone()],
                camera: small_camera(),
            };
            let [faces, vertices] = compare::<Counted<Rgb888>, Planed>(&scene).unwrap();
            assert_eq!(vertices, 0, "the other face has the same corners");
            assert!(faces < 2);
            left_out += faces;
        }
        assert!((300..800).contains(&left_out), "{left_out} of 800");
    }
}

/// Methods of hidden lines ask for corners that no drawn face has.
#[test]
fn hidden_lines_and_edges_are_the_same() {
    let mesh = meshes::cube(1.0);
    let faces: [[u16; 3]; 12] = mesh.faces.clone().try_into().unwrap();
    let edges: [Edge; 12] = FaceSet::find_edges(&mesh.vertices, &faces, I2F14::lit("0.866")).unwrap();
    let table = FacePlanes::find(&mesh.vertices, &faces);
    let planes = FacePlanes::new(&mesh.face_set(), &table).unwrap();
    let colors = vec![Rgb888::RED; 12];
    let camera = small_camera();
    let mut not_transformed = 0;
    for frame in 0..64u16 {
        let turn = |angle: u16| U0F16::from_bits(frame.wrapping_mul(angle));
        let rotation = Rotation::about_x(turn(1_111)).then(&Rotation::about_y(turn(2_345)));
        let pose = Pose::new(rotation, at(0, 0, 2_000));
        let plain = [Model::new(mesh.face_set(), &colors).unwrap().with_pose(pose)];
        let planed = [
            Model::<WithPlanes<Rgb888>>::with_skin(mesh.face_set(), (&colors, planes))
                .unwrap()
                .with_pose(pose),
        ];
        let mut memories = (
            Memory::<Rgb888, 8, 12, 64, 48>::new(),
            Memory::<Planed, 8, 12, 64, 48>::new(),
        );
        let without = memories.0.prepare(&camera, &plain).unwrap();
        let with = memories.1.prepare(&camera, &planed).unwrap();
        not_transformed += with.counters().vertices_not_transformed;
        assert!(with.edges(0, &edges).eq(without.edges(0, &edges)));
        let parts = |found: &mut Vec<_>, part: zrow::visible::LinePart<_>| found.push(format!("{part:?}"));
        let mut found = [const { Vec::new() }; 6];
        let [a, b, c, d, e, f] = &mut found;
        let tables = &[&edges[..]];
        with.visible_parts(&mut FaceAgainstSegment::<12, 8>::new(), tables, |part| parts(a, part))
            .unwrap();
        without
            .visible_parts(&mut FaceAgainstSegment::<12, 8>::new(), tables, |part| parts(b, part))
            .unwrap();
        with.visible_parts(&mut Roberts::<1, 12>::new(), tables, |part| parts(c, part))
            .unwrap();
        without
            .visible_parts(&mut Roberts::<1, 12>::new(), tables, |part| parts(d, part))
            .unwrap();
        with.visible_parts(&mut Appel::<16, 16, 16>::new(), tables, |part| parts(e, part))
            .unwrap();
        without
            .visible_parts(&mut Appel::<16, 16, 16>::new(), tables, |part| parts(f, part))
            .unwrap();
        assert_eq!(a, b);
        assert_eq!(c, d);
        assert_eq!(e, f);
        assert!(!a.is_empty());
    }
    // In most frames the farthest corner.
    assert!(not_transformed > 32, "{not_transformed}");
}

/// As an item of a picture, a scene is as large as what of it is drawn.
#[test]
fn an_item_is_around_what_is_drawn() {
    let mesh = meshes::icosphere(1.4);
    let colors = vec![Rgb888::RED; mesh.faces.len()];
    let table = tables(std::slice::from_ref(&mesh));
    let planes = FacePlanes::new(&mesh.face_set(), &table[0]).unwrap();
    let model = Model::<WithPlanes<Rgb888>>::with_skin(mesh.face_set(), (&colors, planes)).unwrap();
    let plain = Model::new(mesh.face_set(), &colors).unwrap();
    let pose = Pose::new(Rotation::IDENTITY, at(100, 50, 2_500));
    let mut memory = Memory::<WithPlanes<Rgb888>, 200, 400, 64, 48>::new();
    let item = SceneItem::new(memory.frame(), &small_camera(), [model.with_pose(pose)]).unwrap();
    let mut memory = Memory::<Rgb888, 200, 400, 64, 48>::new();
    let other = SceneItem::new(memory.frame(), &small_camera(), [plain.with_pose(pose)]).unwrap();
    assert_eq!(
        PictureItem::<Rgb888>::bounds(&item),
        PictureItem::<Rgb888>::bounds(&other)
    );
}

#[test]
fn a_table_that_is_too_short_is_an_error() {
    let mesh = meshes::cube(1.0);
    let mut table = [[0; 4]; 11];
    assert_eq!(
        FacePlanes::new(&mesh.face_set(), &table).err(),
        Some(TooSmall::Normals(12))
    );
    assert_eq!(
        FacePlanes::find_in(&mesh.face_set(), &mut table).err(),
        Some(TooSmall::Normals(12))
    );
    let triangle = meshes::cube(0.5);
    let small = FaceSet::new(&triangle.vertices, &triangle.faces[..1]).unwrap();
    let planes = FacePlanes::new(&small, &table).unwrap();
    let colors = [Rgb888::RED; 12];
    let model = Model::<WithPlanes<Rgb888>>::with_skin(mesh.face_set(), (&colors, planes));
    assert_eq!(model.err(), Some(TooSmall::Normals(12)));
}

const TRIANGLE: [[i16; 3]; 3] = [[-100, -100, 0], [0, 100, 0], [100, -100, 0]];
const BOTH_SIDES: [[u16; 3]; 2] = [[0, 1, 2], [0, 2, 1]];

/// A table of the greatest numbers, which no mesh has: the face may be missing.
#[test]
fn a_foreign_table_of_planes_is_no_error() {
    let mesh = FaceSet::new(&TRIANGLE, &BOTH_SIDES[..1]).unwrap();
    for table in [
        [[32_767, 32_767, -32_768, 0]],
        [[-32_768, -32_768, 32_767, 32_767]],
        [[i16::MIN; 4]],
        [[i16::MAX; 4]],
    ] {
        let planes = FacePlanes::new(&mesh, &table).unwrap();
        for position in [at(-1_000, -1_000, 1_000), at(1_000, 1_000, 1_000), at(0, 0, 30_000)] {
            let models = [Model::<WithPlanes<Rgb888>>::with_skin(mesh, (&[Rgb888::RED], planes))
                .unwrap()
                .with_pose(Pose::new(Rotation::IDENTITY, position))];
            let mut memory = Memory::<Planed, 3, 1, 64, 48>::new();
            let counters = memory.prepare(&small_camera(), &models).unwrap().counters();
            assert!(counters.faces_culled <= 1);
        }
    }
}

/// A vertex that has moved before the near plane since the planes were found: the model is prepared as without planes.
#[test]
fn a_model_that_has_left_the_box_of_its_planes_is_drawn_without_them() {
    type Plain = Counted<Fine<Rgb888>>;
    type WithTable = Counted<Fine<WithPlanes<Rgb888>>>;
    let mesh = FaceSet::new(&TRIANGLE, &BOTH_SIDES).unwrap();
    let table = FacePlanes::find(&TRIANGLE, &BOTH_SIDES);
    let planes = FacePlanes::new(&mesh, &table).unwrap();
    let mut vertices = TRIANGLE;
    vertices[2][2] = -950;
    let moved = FaceSet::new(&vertices, &BOTH_SIDES).unwrap();
    let pose = Pose::new(Rotation::IDENTITY, at(0, 0, 1_000));
    let colors = [Rgb888::RED, Rgb888::GREEN];
    let plain = [Model::new(moved, &colors).unwrap().with_pose(pose)];
    let planed = [Model::<WithPlanes<Rgb888>>::with_skin(moved, (&colors, planes))
        .unwrap()
        .with_pose(pose)];
    let (expected, _) = seen::<Plain>(&plain, &small_camera()).unwrap();
    let (found, counters) = seen::<WithTable>(&planed, &small_camera()).unwrap();
    assert!(expected.words.iter().any(|word| *word != 0));
    assert_eq!(found, expected);
    assert_eq!(
        (counters.faces_culled_by_planes, counters.vertices_not_transformed),
        (0, 0)
    );
}

/// Marks that a frame before left in the table do not count for a model that is left out as a whole.
#[test]
fn vertices_of_a_model_beside_the_picture_do_not_count() {
    type Both = Bounded<WithPlanes<Rgb888>>;
    let mesh = meshes::icosphere(1.4);
    let mut table = vec![[0; 4]; mesh.faces.len()];
    let planes = FacePlanes::find_in(&mesh.face_set(), &mut table).unwrap();
    let colors = vec![Rgb888::RED; mesh.faces.len()];
    let skin = ((&colors[..], planes), BoundingBox::around(&mesh.vertices));
    let model = Model::<Both>::with_skin(mesh.face_set(), skin).unwrap();
    let mut memory = Box::new(Memory::<Counted<Both>, 200, 400, 64, 48>::new());
    let mut not_transformed = |position| {
        let models = [model.with_pose(Pose::new(Rotation::IDENTITY, position))];
        let prepared = memory.prepare(&small_camera(), &models).unwrap();
        let counters = prepared.counters();
        [counters.vertices_not_transformed, counters.faces_culled_by_bounds]
    };
    let [seen, none] = not_transformed(at(0, 0, 1_500));
    assert!(seen > 75 && none == 0, "{seen} vertices, {none} faces");
    assert_eq!(not_transformed(at(0, 0, -5_000)), [0, 320]);
}
