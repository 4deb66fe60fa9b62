//! Models that are left out by boxes, spheres or cylinders around them: pictures with and without them, bit for bit.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*, primitives::Rectangle};
use fixed::types::{I8F24, I16F16};
use proptest::prelude::*;
use std::cell::Cell;
use zrow::{
    band::Band,
    draw::PictureItem,
    geometry::{InputError, Window},
    scene::{
        Affine, BoundingBox, BoundingCylinder, BoundingSphere, BoundingVolume, Camera, Counted, Counters, Deep,
        FaceSet, Fine, Look, Memory, Model, Orthographic, Pose, Rotation, SceneItem, Unhurried, Whole,
    },
    shade::{Bounded, Shading, Transformed},
};

use crate::common::meshes::{self, Mesh};
use crate::common::{cases, config};
use crate::numbered_scene::{area, color_of};
use crate::rotations::rotation;
use crate::shaded_scene::{Even, Numbers};
use crate::snapped_faces::{at, camera};

/// Models of random meshes: vertices, faces and where each is.
#[derive(Debug, Clone)]
struct Crowd {
    meshes: Vec<Mesh>,
    poses: Vec<Pose>,
    maps: Vec<Affine>,
}

const MODELS: usize = 4;
const WIDTH: u32 = 40;
const HEIGHT: u32 = 28;

/// A mesh of some vertices around the origin or far from it, with faces seen from both sides.
fn mesh() -> impl Strategy<Value = Mesh> {
    let vertices = prop_oneof![
        4 => (prop::array::uniform3(-200i16..200), 0u32..3).prop_flat_map(|(middle, shift)| {
            let vertex = prop::array::uniform3(-160i16..160);
            prop::collection::vec(vertex, 3..7).prop_map(move |vertices| {
                let moved = |vertex: [i16; 3]| core::array::from_fn(|axis| (vertex[axis] >> shift) + middle[axis]);
                vertices.into_iter().map(moved).collect::<Vec<[i16; 3]>>()
            })
        }),
        1 => prop::collection::vec(prop::array::uniform3(any::<i16>()), 3..7),
    ];
    (
        vertices,
        prop::collection::vec(prop::array::uniform3(any::<u16>()), 1..4),
    )
        .prop_map(|(vertices, faces)| {
            let count = vertices.len() as u16;
            let faces = faces.into_iter().map(|face| face.map(|index| index % count)).collect();
            Mesh::new(vertices, faces).two_sided()
        })
}

/// Around the frustum, mostly near its sides, or anywhere.
fn position() -> impl Strategy<Value = [I16F16; 3]> {
    let beside = (-40i32..40, -40i32..40, -100i32..2_400).prop_map(|(x, y, z)| {
        let reach = (z.max(150) + 300) / 16;
        at(x * reach / 16, y * reach / 20, z)
    });
    prop_oneof![
        5 => beside,
        1 => prop::array::uniform3(any::<i32>().prop_map(I16F16::from_bits)),
    ]
}

fn map() -> impl Strategy<Value = Affine> {
    let element = prop_oneof![2 => -3i32 << 24..3 << 24, 1 => -1i32 << 20..1 << 20];
    let matrix = prop::array::uniform3(prop::array::uniform3(element));
    (matrix, prop::array::uniform3(-300i32..300)).prop_map(|(matrix, [x, y, z])| Affine {
        matrix: matrix.map(|row| row.map(I8F24::from_bits)),
        translation: at(x, y, z),
    })
}

fn crowd() -> impl Strategy<Value = Crowd> {
    let many = |count| {
        (
            prop::collection::vec(mesh(), count),
            prop::collection::vec(map(), count),
        )
    };
    let poses = prop::collection::vec((rotation(), position()), MODELS);
    (many(MODELS), poses).prop_map(|((meshes, maps), poses)| Crowd {
        meshes,
        poses: poses
            .into_iter()
            .map(|(rotation, position)| Pose::new(rotation, position))
            .collect(),
        maps,
    })
}

/// Cameras of any place, direction, focal length, centre and far plane.
fn any_camera() -> impl Strategy<Value = Camera> {
    let corner =
        prop_oneof![3 => Just(Point::zero()), 1 => (-500i32..400, -500i32..400).prop_map(|(x, y)| Point::new(x, y))];
    (
        corner,
        rotation(),
        prop_oneof![3 => Just([0; 3]), 1 => prop::array::uniform3(-400i32..400)],
        prop_oneof![2 => 8i32..300, 1 => Just(128)],
        prop_oneof![2 => Just(20i32), 1 => 1i32..2047],
        (-60i32..90, -60i32..90),
        prop_oneof![Just(None), (301i32..3_000).prop_map(Some)],
        prop_oneof![2 => 1i32 << 18..1 << 23, 1 => 1i32..i32::MAX],
        any::<bool>(),
    )
        .prop_map(
            |(corner, rotation, [x, y, z], near, focal, centre, far, scale, is_turned)| {
                let whole = I16F16::from_num::<i32>;
                let viewport = Rectangle::new(corner, Size::new(WIDTH, HEIGHT));
                let mut camera = Camera::new(viewport, whole(near)).unwrap();
                camera = camera.with_focal_length(whole(focal)).unwrap();
                camera = camera.with_scale(I8F24::from_bits(scale)).unwrap();
                camera = camera.with_centre([centre.0, centre.1].map(whole)).unwrap();
                if let Some(far) = far {
                    camera = camera.with_far(whole(far)).unwrap();
                }
                let rotation = if is_turned { rotation } else { Rotation::IDENTITY };
                camera.with_pose(Pose::new(rotation, at(x, y, z)))
            },
        )
}

/// What there is to see of models, and what was left out.
#[derive(Debug)]
struct Seen {
    words: Vec<u32>,
    vertices_needed: usize,
    active_needed: usize,
    counters: Counters,
    faces: Vec<usize>,
}

fn seen<L>(models: &[Model<'_, L::Shading>], camera: &Camera) -> Result<Seen, InputError>
where
    L: Look<Color = Rgb888, Counting = Cell<Counters>>,
{
    let mut memory = Box::new(Memory::<L, 2_000, 80, 64, 32, 32>::new());
    let mut prepared = memory.prepare(camera, models)?;
    let area = camera.viewport().to_rectangle();
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    prepared.draw(&mut Band::<Rgb888>::new(area, &mut words).unwrap());
    Ok(Seen {
        words,
        vertices_needed: prepared.vertices_needed(),
        active_needed: prepared.active_needed(),
        counters: prepared.counters(),
        faces: prepared.faces().map(|face| face.order).collect(),
    })
}

/// The models of a crowd, each with a skin.
fn models<'a, H: Shading>(crowd: &'a Crowd, skin: impl Fn(usize) -> H::Skin<'a>) -> Vec<Model<'a, H>> {
    let places = crowd.meshes.iter().zip(&crowd.poses).enumerate();
    places
        .map(|(number, (mesh, pose))| {
            Model::<H>::with_skin(mesh.face_set(), skin(number))
                .unwrap()
                .with_pose(*pose)
        })
        .collect()
}

/// Compares what two looks see, of which the second one has bounds; returns how many faces were left out by those.
fn compare<L, B>(
    plain: &[Model<'_, L::Shading>],
    bounded: &[Model<'_, B::Shading>],
    camera: &Camera,
) -> Result<u32, TestCaseError>
where
    L: Look<Color = Rgb888, Counting = Cell<Counters>>,
    B: Look<Color = Rgb888, Counting = Cell<Counters>>,
{
    let (with, without) = (seen::<B>(bounded, camera), seen::<L>(plain, camera));
    let Ok(without) = without else {
        if L::CLIPS {
            prop_assert_eq!(with.err(), without.err());
        }
        return Ok(0);
    };
    let with = with.unwrap();
    prop_assert!(with.words == without.words, "the picture is another one");
    prop_assert_eq!(with.vertices_needed, without.vertices_needed);
    prop_assert_eq!(with.active_needed, without.active_needed);
    prop_assert_eq!(with.counters.faces_culled, without.counters.faces_culled);
    prop_assert_eq!(with.counters.faces_cut, without.counters.faces_cut);
    prop_assert!(with.faces.iter().all(|face| without.faces.contains(face)));
    prop_assert_eq!(without.counters.faces_culled_by_bounds, 0);
    Ok(with.counters.faces_culled_by_bounds)
}

fn colors(crowd: &Crowd) -> Vec<Vec<Rgb888>> {
    let mut numbers = 0..;
    let meshes = crowd.meshes.iter();
    meshes
        .map(|mesh| numbers.by_ref().take(mesh.faces.len()).map(color_of).collect())
        .collect()
}

/// A kind of bounds around points, which are the same within a volume of any kind: nothing but [`Shading::bounds`] of a
/// `Bounded` depends on the kind.
type Around = fn(&[[i16; 3]]) -> BoundingVolume;

fn around<B: Copy + Into<BoundingVolume> + 'static>(bounds: B) -> BoundingVolume {
    let volume = bounds.into();
    assert_eq!(Bounded::<Rgb888, B>::bounds(&(&[], bounds)), Some(volume));
    assert_eq!(Bounded::<Rgb888, BoundingVolume>::bounds(&(&[], volume)), Some(volume));
    volume
}

fn box_around(points: &[[i16; 3]]) -> BoundingVolume {
    around(BoundingBox::around(points))
}

fn sphere_around(points: &[[i16; 3]]) -> BoundingVolume {
    around(BoundingSphere::around(points))
}

fn cylinder_around(points: &[[i16; 3]]) -> BoundingVolume {
    around(BoundingCylinder::around(points))
}

/// Compares pictures with and without bounds of a type around the vertices.
fn compare_in<L, B, V>(crowd: &Crowd, camera: &Camera, around: fn(&[[i16; 3]]) -> V) -> Result<u32, TestCaseError>
where
    L: Look<Color = Rgb888, Shading = Rgb888, Counting = Cell<Counters>>,
    B: Look<Color = Rgb888, Shading = Bounded<Rgb888, V>, Counting = Cell<Counters>>,
    V: Copy + Into<BoundingVolume> + 'static,
{
    let colors = colors(crowd);
    let bounds = |number: usize| around(&crowd.meshes[number].vertices);
    let plain = models::<Rgb888>(crowd, |number| &colors[number]);
    let bounded = models::<Bounded<Rgb888, V>>(crowd, |number| (&colors[number], bounds(number)));
    let left_out = compare::<L, B>(&plain, &bounded, camera)?;
    // Bounds for themselves are seen where their model is not left out.
    if let Ok(seen) = seen::<B>(&bounded, camera) {
        let places = crowd.poses.iter().enumerate();
        let unseen = places.filter(|(number, pose)| !camera.may_see::<B>(bounds(*number), pose));
        let faces: u32 = unseen.map(|(number, _)| crowd.meshes[number].faces.len() as u32).sum();
        prop_assert_eq!(seen.counters.faces_culled_by_bounds, faces);
    }
    Ok(left_out)
}

type Mapped = Transformed<Rgb888>;
type BoundsInMap<V> = Transformed<Bounded<Rgb888, V>>;
type MapInBounds<V> = Bounded<Transformed<Rgb888>, V>;

/// Compares pictures with and without bounds of a kind, and returns how many faces were left out in looks whose arithmetic of
/// bounds differs: the way to the eye, and the planes of what is seen.
fn compare_with(crowd: &Crowd, camera: &Camera, around: Around) -> Result<[u32; 3], TestCaseError> {
    type V = BoundingVolume;
    type Careful = Unhurried<Counted<Fine<Deep<Bounded<Rgb888, V>>>>>;
    let colors = colors(crowd);
    let bounds = |number: usize| around(&crowd.meshes[number].vertices);
    let mapped = models::<Mapped>(crowd, |number| (&colors[number], crowd.maps[number]));
    let inside = models::<BoundsInMap<V>>(crowd, |number| ((&colors[number], bounds(number)), crowd.maps[number]));
    Ok([
        compare_in::<Counted<Fine<Deep<Rgb888>>>, Careful, V>(crowd, camera, around)?,
        compare_in::<Counted<Orthographic<Fine<Rgb888>>>, Orthographic<Counted<Fine<Bounded<Rgb888, V>>>>, V>(
            crowd, camera, around,
        )?,
        compare::<Counted<Mapped>, Counted<BoundsInMap<V>>>(&mapped, &inside, camera)?,
    ])
}

/// The same for boxes in more looks: the plainest one, one that cuts no faces, and one with an affine map within the bounds.
fn compare_with_boxes(crowd: &Crowd, camera: &Camera, _: Around) -> Result<[u32; 3], TestCaseError> {
    type V = BoundingBox;
    let colors = colors(crowd);
    let bounds = |number: usize| V::around(&crowd.meshes[number].vertices);
    let mapped = models::<Mapped>(crowd, |number| (&colors[number], crowd.maps[number]));
    let outside = models::<MapInBounds<V>>(crowd, |number| ((&colors[number], crowd.maps[number]), bounds(number)));
    Ok([
        compare_in::<Counted<Rgb888>, Counted<Bounded<Rgb888, V>>, V>(crowd, camera, V::around)?,
        compare_in::<Counted<Whole<Rgb888>>, Counted<Whole<Bounded<Rgb888, V>>>, V>(crowd, camera, V::around)?,
        compare::<Counted<Mapped>, Counted<MapInBounds<V>>>(&mapped, &outside, camera)?,
    ])
}

/// Compares many pictures, and whether each look had something to leave out.
fn pictures_are_the_same(
    compare: fn(&Crowd, &Camera, Around) -> Result<[u32; 3], TestCaseError>,
    around: Around,
    least: [u32; 3],
) {
    let left_out = Cell::new([0u32; 3]);
    let mut runner = proptest::test_runner::TestRunner::new(config(cases(1_000, 10_000)));
    runner
        .run(&(crowd(), any_camera()), |(crowd, camera)| {
            let (found, sums) = (compare(&crowd, &camera, around)?, left_out.get());
            left_out.set(core::array::from_fn(|at| sums[at] + found[at]));
            Ok(())
        })
        .unwrap();
    let sums = left_out.get();
    assert!(
        sums.iter().zip(least).all(|(&sum, least)| sum > cases(least, least)),
        "{sums:?}"
    );
}

#[test]
fn pictures_are_the_same_with_and_without_boxes() {
    pictures_are_the_same(compare_with, box_around, [66; 3]);
    // Most of what can be left out: a third of all faces at least, where all are prepared.
    pictures_are_the_same(compare_with_boxes, box_around, [2_600, 66, 66]);
}

#[test]
fn pictures_are_the_same_with_and_without_spheres() {
    pictures_are_the_same(compare_with, sphere_around, [66; 3]);
}

#[test]
fn pictures_are_the_same_with_and_without_cylinders() {
    pictures_are_the_same(compare_with, cylinder_around, [66; 3]);
}

proptest! {
    #![proptest_config(config(cases(300, 10_000)))]

    /// What varies over faces is left alone where a model is left out, and right for those after it.
    #[test]
    fn attributes_are_those_of_their_vertices(crowd in crowd(), camera in any_camera()) {
        type Shown = Even<1>;
        let numbers: Vec<Vec<[i16; 1]>> = (0..).zip(&crowd.meshes).map(|(number, mesh)| {
            (0..).zip(&mesh.vertices).map(|(vertex, _)| [number * 1_000 + vertex * 100]).collect()
        }).collect();
        let skin = |number: usize| Numbers { of_vertices: &numbers[number][..], shown: 0 };
        let plain = models::<Shown>(&crowd, skin);
        let bounded = models::<Bounded<Shown>>(&crowd, |number| (skin(number), crowd.meshes[number].face_set().bounds()));
        compare::<Counted<Shown>, Counted<Bounded<Shown>>>(&plain, &bounded, &camera)?;
    }

    /// Bounds are found outside where all of them, computed in `f64`, are beyond one plane by half a pixel, which is where the
    /// sides are. Of the corners that they are put around, two opposite ones of a box, the sphere and the cylinder are known.
    #[test]
    fn bounds_beyond_a_plane_are_found(
        corners in prop::array::uniform2(prop::array::uniform3(-300i16..300)),
        rotation in rotation(),
        position in position(),
        camera in any_camera(),
    ) {
        let pose = Pose::new(rotation, position);
        let eye = Eye::new(&camera, &pose);
        let ends = corners.map(|corner| corner.map(f64::from));
        let center: [f64; 3] = core::array::from_fn(|axis| (ends[0][axis] + ends[1][axis]) / 2.0);
        let halves: [f64; 3] = core::array::from_fn(|axis| (ends[1][axis] - ends[0][axis]).abs() / 2.0);
        let length = |of: &[f64]| of.iter().map(|part| part * part).sum::<f64>().sqrt();
        let radius = length(&halves);
        // Of the three cylinders around the two corners the smallest one, or each that may be, where rounding decides: lengths
        // are rounded up, from centres that are rounded.
        let around = |axis: usize| length(&[halves[(axis + 1) % 3], halves[(axis + 2) % 3]]);
        let volume = |axis: usize, more: f64| (around(axis) + 2.0 * more).powi(2) * (halves[axis] + 1.0 + more);
        let smallest = |axis: &usize| (0..3).all(|other| volume(other, 1.0) >= volume(*axis, 0.0));
        let cylinder = |axis: usize| {
            let reach: [f64; 3] = core::array::from_fn(|at| if at == axis { halves[at] } else { around(axis) });
            (reach, [axis == 0, axis == 1, axis == 2])
        };
        let cylinders: Vec<_> = (0..3).filter(smallest).map(cylinder).collect();
        let may_see = [
            camera.may_see::<Rgb888>(BoundingBox::around(&corners), &pose),
            camera.may_see::<Rgb888>(BoundingSphere::around(&corners), &pose),
            camera.may_see::<Rgb888>(BoundingCylinder::around(&corners), &pose),
        ];
        let expected = [vec![(halves, [true; 3])], vec![([radius; 3], [false; 3])], cylinders];
        for (may_see, volumes) in may_see.into_iter().zip(expected) {
            let beyond = |pixels: [f64; 2], space: f64| {
                // Centres and lengths are whole numbers: off by one, and for a round volume by two.
                volumes.iter().all(|(reach, straight)| eye.is_beyond(center, *reach, *straight, pixels, space))
            };
            if beyond([0.4, 0.6], 3.5) {
                prop_assert!(!may_see);
            } else if !volumes.iter().any(|(reach, straight)| {
                // The sides lie half a pixel outside of the picture, behind the camera inside. A round volume need not
                // hold another one around the same corners, whose centre is not rounded.
                let space = if *straight == [true; 3] { -0.3 } else { -2.0 };
                eye.is_beyond(center, *reach, *straight, [0.5; 2], space)
            }) {
                prop_assert!(may_see, "beyond no plane");
            }
        }
    }
}

/// A camera and a pose in `f64`.
struct Eye {
    matrix: [[f64; 3]; 3],
    translation: [f64; 3],
    focal: f64,
    depths: [f64; 2],
    /// Left, right, upper and lower side, from the centre of the picture.
    sides: [f64; 4],
}

impl Eye {
    fn new(camera: &Camera, pose: &Pose) -> Self {
        let turned = |rotation: &Rotation| rotation.matrix().map(|row| row.map(|element| element.to_num::<f64>()));
        let (model, eye) = (turned(&pose.rotation), turned(&camera.pose().rotation));
        let real = |vector: [I16F16; 3]| vector.map(|part| part.to_num::<f64>());
        let (to, from) = (real(pose.translation), real(camera.pose().translation));
        let from_world = |vector: [f64; 3]| -> [f64; 3] {
            core::array::from_fn(|column| (0..3).map(|row| eye[row][column] * vector[row]).sum())
        };
        let columns: [[f64; 3]; 3] = core::array::from_fn(|column| from_world(model.map(|row| row[column])));
        let [centre_x, centre_y] = camera.centre().map(|part| part.to_num::<f64>());
        let far = if camera.far() == I16F16::MAX {
            f64::INFINITY
        } else {
            camera.far().to_num()
        };
        Self {
            matrix: core::array::from_fn(|row| columns.map(|column| column[row])),
            translation: from_world(core::array::from_fn(|axis| to[axis] - from[axis])),
            focal: camera.focal_length().to_num(),
            depths: [camera.near().to_num(), far],
            sides: [
                -centre_x,
                f64::from(WIDTH) - centre_x,
                -centre_y,
                f64::from(HEIGHT) - centre_y,
            ],
        }
    }

    fn turned(&self, vector: [f64; 3]) -> [f64; 3] {
        self.matrix
            .map(|row| row.iter().zip(vector).map(|(part, at)| part * at).sum())
    }

    /// Whether all of a volume is beyond one plane, by each of some pixels, with a margin of space for small distances. Behind
    /// the camera fewer pixels are farther away.
    fn is_beyond(&self, center: [f64; 3], reach: [f64; 3], straight: [bool; 3], pixels: [f64; 2], space: f64) -> bool {
        let turned = self.turned(center);
        let center: [f64; 3] = core::array::from_fn(|axis| turned[axis] + self.translation[axis]);
        let axes: [[f64; 3]; 3] = core::array::from_fn(|axis| {
            let mut along = [0.0; 3];
            along[axis] = reach[axis];
            self.turned(along)
        });
        // How far the volume reaches along a vector, and its centre lies.
        let least = |normal: [f64; 3]| {
            let dot = |vector: [f64; 3]| normal.iter().zip(vector).map(|(part, at)| part * at).sum::<f64>();
            let reaches = axes.map(dot);
            let sum = |is: bool, power: i32| -> f64 {
                (0..3)
                    .filter(|&at| straight[at] == is)
                    .map(|at| reaches[at].abs().powi(power))
                    .sum()
            };
            dot(center) - sum(true, 1) - sum(false, 2).sqrt()
        };
        let side = |sign: f64, axis: usize, end: f64| {
            pixels.iter().all(|pixels| {
                let mut normal = [0.0, 0.0, -sign * (end + sign * pixels)];
                normal[axis] = if axis == 1 {
                    -sign * self.focal
                } else {
                    sign * self.focal
                };
                least(normal) > space * (self.focal + end.abs() + pixels)
            })
        };
        let ([near, far], [left, right, upper, lower]) = (self.depths, self.sides);
        least([0.0, 0.0, -1.0]) > -near + space
            || least([0.0, 0.0, 1.0]) > far + space
            || side(-1.0, 0, left)
            || side(1.0, 0, right)
            || side(-1.0, 1, upper)
            || side(1.0, 1, lower)
    }
}

/// A model whose frame before was seen leaves nothing of that frame behind.
#[test]
fn a_model_that_is_left_out_has_no_faces() {
    let mesh = meshes::cube(0.5);
    let colors: Vec<Rgb888> = (0..12).map(color_of).collect();
    let model = Model::<Bounded<Rgb888>>::with_skin(mesh.face_set(), (&colors, mesh.face_set().bounds())).unwrap();
    let at = |x, z| model.with_pose(Pose::new(Rotation::IDENTITY, at(x, 0, z)));
    let area = area(64, 48);
    let mut memory = Box::new(Memory::<Counted<Whole<Bounded<Rgb888>>>, 16, 24, 64, 48>::new());
    let camera = camera(area);
    let both = [at(-300, 1_500), at(300, 1_500)];
    assert_eq!(memory.prepare(&camera, &both).unwrap().faces().count(), 24);
    // The second one is behind the camera: no error, because nothing is cut of what is left out.
    let one = [at(-300, 1_500), at(300, -1_500)];
    let faces: Vec<_> = memory
        .prepare(&camera, &one)
        .unwrap()
        .faces()
        .map(|face| face.order)
        .collect();
    assert_eq!(faces, Vec::from_iter(0..12));
    let other = [at(-9_000, 1_500), at(300, 1_500)];
    let faces: Vec<_> = memory
        .prepare(&camera, &other)
        .unwrap()
        .faces()
        .map(|face| face.order)
        .collect();
    assert_eq!(faces, Vec::from_iter(12..24));
    // Partly behind the near plane it is seen, and has to be cut.
    let cut = [at(-300, 1_500), at(0, 200)];
    assert_eq!(
        memory.prepare(&camera, &cut).err(),
        Some(InputError::BeforeNearPlane { model: 1 })
    );

    let item = SceneItem::new(memory.frame(), &camera, both).unwrap();
    let bounds = |item: &SceneItem<'_, '_, Counted<Whole<Bounded<Rgb888>>>, 2>| {
        <SceneItem<'_, '_, _, 2> as PictureItem<Rgb888, zrow::band::LittleEndian>>::bounds(item)
    };
    let whole = bounds(&item);
    item.prepare(&camera, one).unwrap();
    let left = bounds(&item);
    assert!(
        whole.left == left.left && whole.right > left.right,
        "{whole:?} {left:?}"
    );
    item.prepare(&camera, [at(0, -900), at(0, -900)]).unwrap();
    assert_eq!(bounds(&item), Window::EMPTY);
}

/// A mesh without vertices has a box around nothing, which is nowhere, and so are a sphere and a cylinder around nothing.
#[test]
fn bounds_around_nothing_are_not_seen() {
    let nothing = FaceSet::new(&[], &[]).unwrap();
    let camera = camera(area(64, 48));
    assert!(!camera.may_see::<Rgb888>(nothing.bounds(), &Pose::IDENTITY));
    assert!(!camera.may_see::<Rgb888>(BoundingSphere::around(&[]), &Pose::IDENTITY));
    assert!(!camera.may_see::<Rgb888>(BoundingCylinder::around(&[]), &Pose::IDENTITY));
    let mesh = meshes::cube(0.5);
    let colors: Vec<Rgb888> = (0..12).map(color_of).collect();
    let solid = Model::<Bounded<Rgb888>>::with_skin(mesh.face_set(), (&colors, mesh.face_set().bounds())).unwrap();
    let empty = Model::<Bounded<Rgb888>>::with_skin(nothing, (&[], nothing.bounds())).unwrap();
    let pose = Pose::new(Rotation::IDENTITY, at(0, 0, 1_500));
    let models = [empty, solid.with_pose(pose), empty, solid, empty];
    let mut memory = Box::new(Memory::<Counted<Bounded<Rgb888>>, 64, 24, 64, 48>::new());
    let prepared = memory.prepare(&camera, &models).unwrap();
    let faces: Vec<_> = prepared.faces().map(|face| face.order).take(12).collect();
    assert_eq!(faces, Vec::from_iter(0..12));
}
